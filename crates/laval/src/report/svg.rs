//! Figures as SVG: alone for papers, or inside the report, where a style sheet and a script take over colours and zoom.

use super::colour::{Colour, MUTED};
use super::layout::{LABEL, LEADING, Layout, PanelBox, TICK, TITLE, is_line};
use super::payload::drawn;
use super::scene::{ARROW, CLASS, Entry, Glyph, Kind, PanelView, SMALL, Scene, Series};
use super::text::{escape, px, width};
use super::thin;
use super::tiles;
use super::words::Style;
use crate::outcome::{Figure, OutcomeError, Table};
use std::fmt::Write;

pub(super) const WIDE: f64 = 760.0;
pub(super) const NARROW: f64 = 350.0;
pub(super) const INK: &str = "#222222";
pub(super) const FONT: &str = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";
const TINTS: [&str; 5] = ["#009e73", "#d55e00", "#0072b2", "#cc79a7", MUTED];

/// Draws a figure as a complete SVG document, in English and in the units of its axes.
///
/// ```
/// use laval::outcome::{Axis, Figure, Line, Panel, Table};
/// # fn main() -> Result<(), laval::outcome::OutcomeError> {
/// let table = Table::new("t", "").float("x", "s", "", vec![0.0, 1.0]).float("y", "m", "", vec![0.0, 2.0]).build()?;
/// let figure = Figure::new("rise", "Rise", "A straight line.")
///     .x(Axis::new("time", "s"))
///     .panel(Panel::new(Axis::new("height", "m")).mark(Line::new("t", "x", "y")));
/// let svg = laval::report::draw(&figure, &[table])?;
/// assert!(svg.contains("<desc>A straight line.</desc>"));
/// # Ok(()) }
/// ```
///
/// # Errors
/// When the figure names a table or column that does not exist.
pub fn draw(figure: &Figure, tables: &[Table]) -> Result<String, OutcomeError> {
    draw_in(figure, tables, &Style::default())
}

/// The same in the words and units of a reader.
///
/// # Errors
/// As [`draw`].
pub fn draw_in(figure: &Figure, tables: &[Table], style: &Style) -> Result<String, OutcomeError> {
    let scene = Scene::new(figure, tables, style)?;
    Ok(render(&scene, WIDE, drawn(&scene), None))
}

/// The drawing, thinned to pixel columns of this width; `inside` is the unique id prefix when it is part of a page.
pub(super) fn render(scene: &Scene, w: f64, column: f64, inside: Option<&str>) -> String {
    if let Some(tiles) = &scene.tiles {
        return tiles::render(scene, tiles, w, inside.is_none());
    }
    let alone = inside.is_none();
    let lay = Layout::new(scene, w, alone);
    let id = inside.unwrap_or("f");
    let mut s = String::new();
    let (sw, sh) = (px(lay.w), px(lay.h));
    let class = if w < 500.0 { "narrow" } else { "wide" };
    let (title, alt) = (escape(&scene.title), escape(&scene.alt));
    let _ = write!(
        s,
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {sw} {sh}" role="img" font-family="{FONT}" font-size="{TICK}" fill="none""#
    );
    if alone {
        let _ = write!(
            s,
            r##" width="{sw}" height="{sh}"><title>{title}</title><desc>{alt}</desc><rect width="{sw}" height="{sh}" fill="#ffffff"/><text x="6" y="20" font-size="{TITLE}" font-weight="bold" fill="{INK}">{title}</text>"##
        );
    } else {
        // a title element would pop up over the whole drawing
        let _ = write!(s, r#" class="{class}" data-x="{}" data-w="{}" aria-label="{title}. {alt}">"#, px(lay.x0), px(lay.pw));
    }
    for (i, (p, b)) in scene.panels.iter().zip(&lay.panels).enumerate() {
        panel(&mut s, scene, p, b, &lay, &format!("{id}-{i}"), (i, column), i + 1 == scene.panels.len());
    }
    let _ = write!(
        s,
        r#"<text class="t xt" x="{}" y="{}" text-anchor="middle" font-size="{LABEL}" fill="{INK}">{}</text>"#,
        px(lay.x0 + lay.pw / 2.0),
        px(lay.x_title_y),
        escape(&scene.x.title())
    );
    for (k, (entry, (x, y, text))) in scene.legend.iter().zip(&lay.legend).enumerate() {
        legend(&mut s, k, entry, *x, *y, text);
    }
    if let Some((x, y, text)) = &lay.note {
        let _ = write!(s, r#"<text class="t" x="{}" y="{}" fill="{INK}">{}</text>"#, px(*x), px(*y), escape(text));
    }
    if scene.is_empty() {
        let (x, y) = (lay.x0 + lay.pw / 2.0, lay.panels.first().map_or(40.0, |p| p.y0 + p.h / 2.0));
        let _ = write!(
            s,
            r#"<text class="t" x="{}" y="{}" text-anchor="middle" font-size="{LABEL}" fill="{INK}">{}</text>"#,
            px(x),
            px(y),
            escape(&scene.style.message(&"page-no-data".into()))
        );
    }
    s.push_str("</svg>");
    s
}

#[allow(clippy::too_many_arguments)]
fn panel(s: &mut String, scene: &Scene, p: &PanelView, b: &PanelBox, lay: &Layout, id: &str, (index, column): (usize, f64), last: bool) {
    let (x0, y0, w, h) = (lay.x0, b.y0, lay.pw, b.h);
    let (sx, sy, sw, sh) = (px(x0), px(y0), px(w), px(h));
    let at = |q: &(f64, f64)| (x0 + scene.x.place(q.0) * w, y0 + (1.0 - p.y.place(q.1)) * h);
    let _ = write!(
        s,
        r##"<g class="p" data-p="{index}" data-y="{sy}" data-h="{sh}"><rect class="bg" x="{sx}" y="{sy}" width="{sw}" height="{sh}" fill="#ffffff"/>"##
    );
    let _ = write!(s, r#"<text class="t yt" x="2" y="{}" font-size="{LABEL}" fill="{INK}">{}</text>"#, px(b.title_y), escape(&p.y.title()));

    s.push_str(r##"<g class="gr" stroke="#e3e3e3" stroke-width="1">"##);
    let mut grid = |major: bool| {
        let class = if major { "" } else { r##" class="mi" stroke="#f1f1f1""## };
        let mut d = String::new();
        let pick = |t: &super::ticks::Ticks| -> Vec<f64> { if major { t.major.iter().map(|m| m.0).collect() } else { t.minor.clone() } };
        for v in pick(&lay.x_ticks) {
            let _ = write!(d, "M{} {sy}v{sh}", px(x0 + scene.x.place(v) * w));
        }
        for v in pick(&b.y_ticks) {
            let _ = write!(d, "M{sx} {}h{sw}", px(y0 + (1.0 - p.y.place(v)) * h));
        }
        let _ = write!(s, r#"<path{class} d="{d}"/>"#);
    };
    grid(false);
    grid(true);
    s.push_str("</g>");

    let _ = write!(
        s,
        r#"<clipPath id="{id}"><rect x="{sx}" y="{sy}" width="{sw}" height="{sh}"/></clipPath><g clip-path="url(#{id})"><g class="tf">"#
    );
    if let Some(heat) = &p.heat {
        let _ = write!(s, r#"<g class="heat" transform="translate({sx} {sy})" shape-rendering="crispEdges">"#);
        let cells = if heat.curves.is_some() { Vec::new() } else { heat.cells(&scene.x, &p.y, w, h) };
        for (colour, class, d) in cells {
            let class = if class.is_empty() { class } else { format!(r#" class="{class}""#) };
            let _ = write!(s, r#"<path{class} fill="{colour}" d="{d}"/>"#);
        }
        let forbidden = if heat.allowed { heat.forbidden(&scene.x, &p.y, w, h) } else { String::new() };
        if !forbidden.is_empty() {
            let _ = write!(
                s,
                r##"<pattern id="{id}-h" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path stroke="#8a3a0c" stroke-width="1.3" stroke-opacity="0.55" d="M0 0v7"/></pattern><path class="hatch" fill="url(#{id}-h)" shape-rendering="auto" d="{forbidden}"/>"##
            );
        }
        s.push_str("</g>");
        for level in heat.curves.iter().flatten() {
            let points: Vec<_> =
                heat.contour_path(*level, &scene.x, &p.y).into_iter().map(|(a, c)| (x0 + a * w, y0 + (1.0 - c) * h)).collect();
            let _ = write!(
                s,
                r##"<path class="ru" stroke="#555555" stroke-width="1" vector-effect="non-scaling-stroke" d="{}"/>"##,
                path(&points, 0.5)
            );
        }
        if let Some(level) = heat.contour {
            let points: Vec<_> =
                heat.contour_path(level, &scene.x, &p.y).into_iter().map(|(a, c)| (x0 + a * w, y0 + (1.0 - c) * h)).collect();
            let _ = write!(
                s,
                r##"<path class="con" stroke="#000000" stroke-width="1.5" vector-effect="non-scaling-stroke" d="{}"/>"##,
                path(&points, 0.5)
            );
        }
    }
    for band in &p.bands {
        let side = |v: f64, place: f64, from: f64, size: f64| {
            if v.is_infinite() { from + if v > 0.0 { size } else { 0.0 } } else { from + place * size }
        };
        let corner = |q: &(f64, f64)| (side(q.0, scene.x.place(q.0), x0, w), y0 + h - side(q.1, p.y.place(q.1), 0.0, h));
        let points: Vec<_> = band.outline.iter().map(corner).filter(|q| q.0.is_finite() && q.1.is_finite()).collect();
        let _ = write!(
            s,
            r#"<path class="b{0}{3}" fill="{1}" fill-opacity="{4}" d="{2}z"/>"#,
            band.tint % TINTS.len(),
            TINTS[band.tint % TINTS.len()],
            path(&points, 0.5),
            if band.bar { " full" } else { "" },
            if band.bar { 0.85 } else { 0.16 }
        );
        if band.strip {
            let (from, to) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), q| (a.min(q.0), b.max(q.0)));
            let (from, to) = (from.max(x0), to.min(x0 + w));
            if from <= to {
                let width = (to - from).max(STRIP);
                let left = (0.5 * (from + to - width)).clamp(x0, x0 + w - width);
                let colour = TINTS[band.tint % TINTS.len()];
                let _ = write!(
                    s,
                    r#"<path class="b{} strip" fill="{colour}" d="M{} {sy}h{}v{STRIP_HEIGHT}h-{}z"/>"#,
                    band.tint % TINTS.len(),
                    px(left),
                    px(width),
                    px(width)
                );
            }
        }
    }
    s.push_str(r#"</g><g class="se">"#);
    let on_heat = p.heat.as_ref().is_some_and(|h| h.curves.is_none());
    for (i, series) in p.series.iter().enumerate() {
        let points: Vec<_> = series.points.iter().map(at).collect();
        draw_series(s, i, series, &points, column, on_heat);
    }
    s.push_str(r#"</g><g class="tf">"#);
    // dark rules cannot be seen on the low end of a ramp
    let on_map = p.heat.as_ref().is_some_and(|h| h.classes.is_empty() && !h.diverging && h.curves.is_none());
    for r in &p.rules {
        let (a, c) = if r.vertical { (scene.x.place(r.at), 0.0) } else { (0.0, p.y.place(r.at)) };
        if a.is_finite() && c.is_finite() {
            let d = if r.vertical { format!("M{} {sy}v{sh}", px(x0 + a * w)) } else { format!("M{sx} {}h{sw}", px(y0 + (1.0 - c) * h)) };
            let _ = write!(
                s,
                r##"<path {} stroke-width="1.1" stroke-dasharray="1.5 3" stroke-linecap="round" vector-effect="non-scaling-stroke" d="{d}"><title>{}</title></path>"##,
                if on_map { r##"stroke="#ffffff" stroke-opacity="0.6""## } else { r##"class="ru" stroke="#333333""## },
                escape(&r.label)
            );
        }
    }
    s.push_str(r#"</g><g class="tx">"#);
    // a word that would lie upon another is left out: a table has what it says
    let mut taken: Vec<[f64; 4]> = Vec::new();
    for (x, y, text) in &p.texts {
        let (a, c) = at(&(*x, *y));
        let half = 0.5 * width(text, TICK);
        let own = [a - half, a + half, c - TICK, c + 2.0];
        let free = !taken.iter().any(|t| own[0] < t[1] && t[0] < own[1] && own[2] < t[3] && t[2] < own[3]);
        if a.is_finite() && c.is_finite() && free {
            taken.push(own);
            let _ = write!(
                s,
                r##"<text class="t ha" x="{}" y="{}" text-anchor="middle" fill="{INK}" stroke="#ffffff" stroke-width="3" paint-order="stroke" stroke-linejoin="round">{}</text>"##,
                px(a),
                px(c),
                escape(text)
            );
        }
    }
    for c in &p.cut {
        let (place, sign) = (x0 + scene.x.place(c.x) * w, if c.up { '▲' } else { '▼' });
        let (near, anchor) = if place < x0 + EDGE {
            (place.max(x0 + 3.0), "start")
        } else if place > x0 + w - EDGE {
            (place.min(x0 + w - 3.0), "end")
        } else {
            (place, "middle")
        };
        let value = scene.style.shown(c.to, 3);
        let _ = write!(
            s,
            r##"<text class="t ha cut" x="{}" y="{}" text-anchor="{anchor}" fill="{INK}" stroke="#ffffff" stroke-width="3" paint-order="stroke" stroke-linejoin="round">{sign} {}</text>"##,
            px(near),
            px(if c.up { y0 + 20.0 } else { y0 + h - 6.0 }),
            escape(&value)
        );
    }
    s.push_str("</g></g>");

    let _ = write!(s, r##"<path class="ax" stroke="#555555" stroke-width="1" d="M{sx} {sy}v{sh}h{sw}"/><g class="tk t" fill="{INK}">"##);
    for (v, label) in &b.y_ticks.major {
        let y = y0 + (1.0 - p.y.place(*v)) * h;
        let _ = write!(s, r#"<text x="{}" y="{}" text-anchor="end">{}</text>"#, px(x0 - 5.0), px(y + 4.0), escape(label));
    }
    if last {
        for (v, label) in &lay.x_ticks.major {
            let _ =
                write!(s, r#"<text x="{}" y="{}" text-anchor="middle">{label}</text>"#, px(x0 + scene.x.place(*v) * w), px(y0 + h + 15.0));
        }
    }
    s.push_str("</g>");
    for l in &b.labels {
        let (axis, at) = if l.vertical { ("x", l.leader.map_or(l.x, |d| d[0])) } else { ("y", l.leader.map_or(l.y - 4.0, |d| d[1])) };
        let class = if l.reference { "rl re" } else { "rl" };
        let _ = write!(s, r#"<g class="{class}" data-{axis}="{}">"#, px(at));
        if let Some([a, c, d, e]) = l.leader {
            let _ = write!(s, r##"<path class="ru" stroke="#777777" stroke-width="0.8" d="M{} {}L{} {}"/>"##, px(a), px(c), px(d), px(e));
        }
        for (k, line) in l.lines.iter().enumerate() {
            let y = px(l.y + LEADING * k as f64);
            let _ = write!(s, r#"<text class="t" x="{}" y="{y}" fill="{INK}">{}</text>"#, px(l.x), escape(line));
        }
        s.push_str("</g>");
    }
    if let (Some(bar), Some(heat)) = (&b.bar, &p.heat) {
        let steps = 48;
        let (from, to) = (heat.tone(heat.axis.lo), heat.tone(heat.axis.hi));
        s.push_str(r#"<g class="bar" shape-rendering="crispEdges">"#);
        for k in 0..steps {
            let f = (k as f64 + 0.5) / steps as f64;
            let (top, bottom) = (y0 + h * (1.0 - (k + 1) as f64 / steps as f64), y0 + h * (1.0 - k as f64 / steps as f64));
            let _ = write!(
                s,
                r#"<path fill="{}" d="M{} {}h14V{}h-14z"/>"#,
                heat.colour(from + f * (to - from)),
                px(bar.x),
                px(top),
                px(bottom)
            );
        }
        s.push_str("</g>");
        for (y, label) in &bar.ticks {
            let _ = write!(s, r#"<text class="t" x="{}" y="{}" fill="{INK}">{label}</text>"#, px(bar.x + 18.0), px(y0 + y + 4.0));
        }
        let _ = write!(
            s,
            r#"<text class="t" x="{}" y="{}" text-anchor="end" font-size="{LABEL}" fill="{INK}">{}</text>"#,
            px(lay.w - 2.0),
            px(bar.title_y),
            escape(&heat.axis.title())
        );
    }
    s.push_str("</g>");
}

fn draw_series(s: &mut String, index: usize, series: &Series, points: &[(f64, f64)], column: f64, on_heat: bool) {
    let key = series.entry.map_or(String::new(), |k| format!(r#" data-k="{k}""#));
    let (hex, class) = (series.colour.hex(), series.colour.class());
    let stroke = if series.reference {
        1.0
    } else if series.colour == Colour::Muted {
        0.9
    } else {
        1.8 + NEST * series.below as f64
    };
    match series.kind {
        Kind::Solid | Kind::Dashed => {
            let dash = match series.kind {
                Kind::Dashed if series.colour.is_again() => r#" stroke-dasharray="6 4 1 4""#,
                Kind::Dashed => r#" stroke-dasharray="6 4""#,
                _ if series.colour.is_again() => DOTTED,
                // excitation lines differ from curves that lie close to them
                _ if series.reference && series.colour == Colour::Slot(6) => r#" stroke-dasharray="9 3 2 3""#,
                _ => "",
            };
            let hex = if on_heat && series.colour == Colour::Slot(0) { "#000000" } else { &hex };
            // grey cannot be seen on the low end of a ramp, and a class would set the colour of the page
            let (hex, class) = if on_heat && series.reference { ("#ffffff", "") } else { (hex, class.as_str()) };
            let _ = write!(
                s,
                r#"<path class="s {class}" data-s="{index}"{key} stroke="{hex}" stroke-width="{stroke}" stroke-linejoin="round"{dash} d="{}"/>"#,
                path(points, column)
            );
        }
        Kind::Marker { shape, open } => {
            let kept: Vec<_> = thin::cloud(points, column).into_iter().map(|i| points[i]).collect();
            if kept.len() > DOTS {
                let d: String = kept.iter().map(|q| format!("M{} {}h0", px(q.0), px(q.1))).collect();
                // dots of classes that share a place lie on each other like their markers
                let size = if shape >= SMALL {
                    2.4
                } else if shape >= CLASS {
                    5.2 - 1.4 * (shape - CLASS).min(2) as f64
                } else {
                    2.4
                };
                let _ = write!(
                    s,
                    r#"<path class="s {class}" data-s="{index}"{key} stroke="{hex}" stroke-width="{size:.1}" stroke-linecap="round" d="{d}"/>"#
                );
            } else {
                let d: String = kept.iter().map(|q| marker(shape, q.0, q.1)).collect();
                let style = marker_style(&hex, open);
                let _ = write!(s, r#"<path class="s {class} {}" data-s="{index}"{key} {style} d="{d}"/>"#, if open { "mo" } else { "mf" });
            }
        }
    }
}

/// Half width of the mark of a curve that goes on beyond the range, px.
const EDGE: f64 = 26.0;

/// What a curve is wider than the next one drawn upon it, px.
const NEST: f64 = 2.4;
/// Least width and height of the strip of a band, px.
const STRIP: f64 = 4.0;
const STRIP_HEIGHT: f64 = 7.0;

/// From so many points on, markers are plain dots.
pub(super) const DOTS: usize = 400;

fn marker_style(hex: &str, open: bool) -> String {
    if open {
        format!(r##"fill="#ffffff" stroke="{hex}" stroke-width="1.6""##)
    } else {
        format!(r##"fill="{hex}" stroke="#ffffff" stroke-width="0.8""##)
    }
}

/// Outline of a marker: circle, square, triangle, diamond, triangle on its tip; arrowhead. Classes that share a place lie on each other, the smaller above.
fn marker(shape: usize, x: f64, y: f64) -> String {
    let p = |v: f64| px(v);
    if shape >= ARROW {
        let (s, c) = ((shape - ARROW) as f64).to_radians().sin_cos();
        let corner = |(a, b): (f64, f64)| format!("{} {}", p(x + a * c + b * s), p(y - a * s + b * c));
        return format!("M{}L{}L{}z", corner((7.0, 0.0)), corner((-5.0, 5.0)), corner((-5.0, -5.0)));
    }
    let r = if shape >= SMALL {
        2.4
    } else if shape >= CLASS {
        5.6 - (shape - CLASS) as f64
    } else {
        4.2
    };
    match shape % 5 {
        0 => format!("M{} {}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0z", p(x - r), p(y), d = 2.0 * r),
        1 => format!("M{} {}h{d}v{d}h-{d}z", p(x - 0.88 * r), p(y - 0.88 * r), d = px(1.76 * r)),
        2 => format!("M{} {}L{} {}H{}z", p(x), p(y - 1.15 * r), p(x + 1.1 * r), p(y + 0.8 * r), p(x - 1.1 * r)),
        3 => {
            format!("M{} {}L{} {}L{} {}L{} {}z", p(x), p(y - 1.25 * r), p(x + 1.25 * r), p(y), p(x), p(y + 1.25 * r), p(x - 1.25 * r), p(y))
        }
        _ => format!("M{} {}H{}L{} {}z", p(x - 1.1 * r), p(y - 0.8 * r), p(x + 1.1 * r), p(x), p(y + 1.15 * r)),
    }
}

/// Lines whose colour another one has already.
const DOTTED: &str = r#" stroke-dasharray="2 3""#;

/// Path data of a thinned line; a point between two gaps is a short dash.
fn path(points: &[(f64, f64)], column: f64) -> String {
    let mut d = String::new();
    // far outside the panel coordinates only cost space and may overflow a renderer
    let near = |v: f64| px(v.clamp(-2e4, 2e4));
    let kept: Vec<(f64, f64)> = thin::path(points, column).into_iter().map(|i| points[i]).collect();
    for piece in kept.split(|p| p.0.is_nan() || p.1.is_nan()) {
        if let &[(x, y)] = piece {
            let _ = write!(d, "M{} {}h2", near(x - 1.0), near(y));
            continue;
        }
        for (k, (x, y)) in piece.iter().enumerate() {
            let _ = write!(d, "{}{} {}", if k == 0 { 'M' } else { 'L' }, near(*x), near(*y));
        }
    }
    d
}

fn legend(s: &mut String, k: usize, e: &Entry, x: f64, y: f64, text: &str) {
    let (hex, class) = (e.colour.hex(), e.colour.class());
    let _ = write!(s, r#"<g class="lg" data-k="{k}">"#);
    let (a, m) = (px(x), y - 4.0);
    match e.glyph {
        g if is_line(g) => {
            let dash = match g {
                Glyph::Dashed => r#" stroke-dasharray="6 4""#,
                _ if e.colour.is_again() => DOTTED,
                _ => "",
            };
            let (hex, class) = if g == Glyph::Contour { ("#000000".into(), "con".into()) } else { (hex, class) };
            let _ = write!(s, r#"<path class="{class}" stroke="{hex}" stroke-width="2"{dash} d="M{a} {}h24"/>"#, px(m));
        }
        Glyph::Block(t) => {
            let (t, y) = (t % TINTS.len(), px(m - 5.0));
            let _ = write!(s, r#"<path class="b{t} full" fill="{}" fill-opacity="0.85" d="M{a} {y}h24v10h-24z"/>"#, TINTS[t]);
        }
        Glyph::Tint(t) => {
            let _ = write!(
                s,
                r#"<path class="b{0}" fill="{1}" fill-opacity="0.16" stroke="{1}" stroke-opacity="0.5" d="M{a} {2}h24v10h-24z"/>"#,
                t % TINTS.len(),
                TINTS[t % TINTS.len()],
                px(m - 5.0)
            );
        }
        Glyph::Marker { shape, open } => {
            let _ = write!(
                s,
                r#"<path class="{class} {}" {} d="{}"/>"#,
                if open { "mo" } else { "mf" },
                marker_style(&hex, open),
                marker(shape, x + 12.0, m)
            );
        }
        _ => {}
    }
    let _ = write!(s, r#"<text class="t" x="{}" y="{}" fill="{INK}">{}</text></g>"#, px(x + 30.0), px(y), escape(text));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Arg, Axis, Heat, Line, Panel, Points, Rule};

    fn table(ys: Vec<f64>) -> Table {
        let n = ys.len();
        let xs = (0..n).map(|i| i as f64).collect();
        Table::new("t", "").float("x", "s", "", xs).float("y", "m", "", ys).text("g", "", vec!["<g>".into(); n]).build().unwrap()
    }

    fn with(mark: impl Into<crate::outcome::Mark>, y: Axis) -> Figure {
        Figure::new("f", "T <1>", "A & B").x(Axis::new("x<", "s")).panel(Panel::new(y).mark(mark))
    }

    #[test]
    fn words_are_escaped_and_the_bytes_repeat() {
        let figure = Figure::new("f", "<t>", "<d>").x(Axis::new("<x>", "<u>")).panel(
            Panel::new(Axis::new("<y>", ""))
                .mark(Points::new("t", "x", "y").group("g").name("<n>"))
                .mark(Rule::x(1.0, "<r>"))
                .mark(crate::outcome::Text::new(1.0, 1.0, "<w>")),
        );
        let svg = draw(&figure, &[table(vec![1.0, 2.0, 3.0])]).unwrap();
        for word in ["t", "d", "x", "u", "y", "n", "r", "w"] {
            assert!(!svg.contains(&format!("<{word}>")), "{word}");
            assert!(svg.contains(&format!("&lt;{word}&gt;")), "{word}");
        }
        assert_eq!(svg, draw(&figure, &[table(vec![1.0, 2.0, 3.0])]).unwrap());
    }

    #[test]
    fn no_coordinate_is_nan_and_gaps_break_lines() {
        for ys in [vec![1.0, f64::NAN, 2.0, 0.0, -1.0, f64::INFINITY, 5.0, 6.0], vec![], vec![f64::NAN; 4], vec![3.0]] {
            for y in [Axis::new("y", "m"), Axis::log("y", "m")] {
                for figure in
                    [with(Line::new("t", "x", "y"), y.clone()), with(Heat::new("t", "x", "x", "y", y.clone()).contour(1.0), y.clone())]
                {
                    let svg = draw(&figure, &[table(ys.clone())]).unwrap();
                    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
                }
            }
        }
        let gap = (f64::NAN, 0.0);
        let line = path(&[(0.0, 0.0), (5.0, 5.0), gap, (9.0, 9.0), (12.0, 1.0), gap, (20.0, 3.0), gap, gap], 1.0);
        assert_eq!(line, "M0 0L5 5M9 9L12 1M19 3h2");
    }

    /// Of words that would lie upon each other the first stands.
    #[test]
    fn words_in_a_panel_do_not_overlap() {
        let place = |x: f64, text: &str| crate::outcome::Text::new(x, 1.0, Arg::name(text));
        let panel = Panel::new(Axis::new("y", "m")).mark(Line::new("t", "x", "y")).mark(place(1.0, "3000 rpm"));
        let figure =
            Figure::new("f", "t", "a").x(Axis::new("x", "s")).panel(panel.mark(place(1.05, "3010 rpm")).mark(place(1.6, "3500 rpm")));
        let svg = draw(&figure, &[table(vec![0.0, 1.0, 2.0])]).unwrap();
        assert!(svg.contains("3000 rpm") && svg.contains("3500 rpm") && !svg.contains("3010 rpm"));
    }

    /// A curve that leaves the range of its axis has a mark with the value that it reaches there; one that stays inside has none.
    #[test]
    fn what_goes_on_beyond_the_range_is_marked() {
        let ys = vec![0.0, 1.0, 250.0, 1.0, 0.0, -3.0, 0.0];
        let svg = draw(&with(Line::new("t", "x", "y"), Axis::new("y", "m").range(-1.0, 40.0)), &[table(ys.clone())]).unwrap();
        assert!(svg.contains(">▲ 250</text>") && svg.contains(">▼ −3</text>"), "{svg}");
        let svg = draw(&with(Line::new("t", "x", "y"), Axis::new("y", "m").range(-10.0, 400.0)), &[table(ys)]).unwrap();
        assert!(!svg.contains('▲') && !svg.contains('▼'));
    }

    #[test]
    fn an_empty_figure_says_so() {
        let svg = draw(&with(Line::new("t", "x", "y"), Axis::new("y", "")), &[table(vec![f64::NAN; 3])]).unwrap();
        assert!(svg.contains("no data in this range"));
    }

    #[test]
    fn long_histories_are_thinned() {
        let ys: Vec<f64> = (0..200_000).map(|i| (i as f64 * 0.1).sin()).collect();
        let svg = draw(&with(Line::new("t", "x", "y"), Axis::new("y", "")), &[table(ys)]).unwrap();
        assert!(svg.len() < 60_000, "{}", svg.len());
    }

    #[test]
    fn hundreds_of_curves_stay_small() {
        let (curves, rows) = (300, 2000);
        let mut t = Table::new("t", "").float("x", "", "", (0..rows).map(f64::from).collect());
        let mut panel = Panel::new(Axis::new("y", ""));
        for k in 0..curves {
            t = t.float(format!("y{k}"), "", "", (0..rows).map(|i| (f64::from(i * (k + 1)) * 0.37).sin()).collect());
            panel = panel.mark(Line::new("t", "x", format!("y{k}")).name(Arg::name(format!("y{k}"))));
        }
        let svg = draw(&Figure::new("f", "t", "a").x(Axis::new("x", "")).panel(panel), &[t.build().unwrap()]).unwrap();
        assert!(svg.len() < 1_200_000, "{}", svg.len());
    }
}
