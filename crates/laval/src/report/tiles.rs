//! Small pictures side by side: orbits, and shapes in space and along the axis.

use super::colour::Colour;
use super::scene::Scene;
use super::scene::whirl::{Camera, Point, TileView, TilesView, Whirl};
use super::svg::{FONT, INK};
use super::text::{escape, px, width, wrap};
use crate::outcome::{Message, View};
use std::f64::consts::FRAC_PI_3;
use std::fmt::Write;

const TITLE: f64 = 12.0;
const TEXT: f64 = 10.5;
const ROW: f64 = 13.0;
/// Between pictures, and within their borders.
const GAP: f64 = 8.0;
const INSIDE: f64 = 7.0;
/// Steps of an orbit, and between two points of a line.
const STEPS: usize = 48;
const BETWEEN: usize = 8;
/// Share of the limiting circle below which an orbit is drawn to its own scale, without the circle.
const SEEN: f64 = 0.05;

/// Sizes of a kind of picture.
struct Size {
    /// Width of a tile and of the drawing in it, and height of the drawing.
    tile: f64,
    w: f64,
    h: f64,
}

fn size(view: View) -> Size {
    match view {
        View::Orbits => Size { tile: 118.0, w: 100.0, h: 100.0 },
        View::Shapes { horizontal: false, .. } => Size { tile: 244.0, w: 230.0, h: 158.0 },
        View::Shapes { horizontal: true, .. } => Size { tile: 244.0, w: 230.0, h: 196.0 },
    }
}

/// The drawing; `alone` with a title of its own and a white ground.
pub(super) fn render(scene: &Scene, view: &TilesView, w: f64, alone: bool) -> String {
    let size = size(view.view);
    let across = (((w + GAP) / (size.tile + GAP)) as usize).max(1);
    let tile = ((w + GAP) / across as f64 - GAP).min(1.25 * size.tile);
    let mut y = if alone { 30.0 } else { 2.0 };
    let mut body = String::new();
    for row in view.tiles.chunks(across) {
        let room = tile - 2.0 * INSIDE;
        let texts: Vec<(Vec<String>, Vec<String>)> =
            row.iter().map(|t| (wrap(&t.title, 1.08 * TITLE, room), t.lines.iter().flat_map(|l| wrap(l, TEXT, room)).collect())).collect();
        let lines = |f: fn(&(Vec<String>, Vec<String>)) -> usize| texts.iter().map(f).max().unwrap_or(0) as f64;
        let (titles, lines) = (lines(|t| t.0.len()), lines(|t| t.1.len()));
        let height = 2.0 * INSIDE + ROW * (titles + lines) + size.h + 6.0;
        for (k, (t, (title, text))) in row.iter().zip(&texts).enumerate() {
            let x = k as f64 * (tile + GAP);
            let _ = write!(
                body,
                r##"<rect class="tile{}" stroke="#d9dde2" x="{}" y="{}" width="{}" height="{}" rx="6"/>"##,
                if t.unstable { " bad" } else { "" },
                px(x + 0.5),
                px(y),
                px(tile - 1.0),
                px(height)
            );
            let middle = x + 0.5 * tile;
            let mut base = y + INSIDE + 10.0;
            for line in title {
                text_at(&mut body, (middle, base), line, Words { bold: true, ..Words::middle(TITLE) });
                base += ROW;
            }
            for line in text {
                text_at(&mut body, (middle, base), line, Words { soft: true, ..Words::middle(TEXT) });
                base += ROW;
            }
            let top = y + INSIDE + ROW * (titles + lines) + 4.0;
            let corner = (middle - 0.5 * size.w, top);
            match view.view {
                View::Orbits => orbits(&mut body, t, corner, &size),
                View::Shapes { horizontal, to_scale } => shape(&mut body, t, corner, horizontal, to_scale),
            }
        }
        y += height + GAP;
    }
    y = key(&mut body, scene, view, w, y + 8.0);
    let (sw, sh) = (px(w), px(y + 4.0));
    let (title, alt) = (escape(&scene.title), escape(&scene.alt));
    let mut s = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {sw} {sh}" role="img" font-family="{FONT}" font-size="{TEXT}" fill="none""#
    );
    if alone {
        let _ = write!(
            s,
            r##" width="{sw}" height="{sh}"><title>{title}</title><desc>{alt}</desc><rect width="{sw}" height="{sh}" fill="#ffffff"/><text x="6" y="20" font-size="14" font-weight="bold" fill="{INK}">{title}</text>"##
        );
    } else {
        let class = if w < 500.0 { "narrow" } else { "wide" };
        let _ = write!(s, r#" class="{class}" aria-label="{title}. {alt}">"#);
    }
    s + &body + "</svg>"
}

/// How words are set.
#[derive(Clone, Copy)]
struct Words {
    size: f64,
    anchor: &'static str,
    bold: bool,
    soft: bool,
}

impl Words {
    fn middle(size: f64) -> Words {
        Words { size, anchor: "middle", bold: false, soft: false }
    }
    fn start(size: f64) -> Words {
        Words { anchor: "start", ..Words::middle(size) }
    }
}

fn text_at(s: &mut String, (x, y): (f64, f64), text: &str, set: Words) {
    let class = if set.soft { "t so" } else { "t" };
    let fill = if set.soft { "#5c646e" } else { INK };
    let bold = if set.bold { r#" font-weight="bold""# } else { "" };
    let _ = write!(
        s,
        r#"<text class="{class}" x="{}" y="{}" text-anchor="{}" font-size="{}"{bold} fill="{fill}">{}</text>"#,
        px(x),
        px(y),
        set.anchor,
        set.size,
        escape(text)
    );
}

/// A path through places of the drawing.
fn path(points: &[(f64, f64)]) -> String {
    let mut d = String::new();
    for (k, (x, y)) in points.iter().enumerate() {
        let _ = write!(d, "{}{} {}", if k == 0 { 'M' } else { 'L' }, px(*x), px(*y));
    }
    d
}

fn line(s: &mut String, points: &[(f64, f64)], colour: Colour, stroke: f64, more: &str) {
    let _ = write!(
        s,
        r#"<path class="{}" stroke="{}" stroke-width="{stroke}" stroke-linejoin="round"{more} d="{}"/>"#,
        colour.class(),
        colour.hex(),
        path(points)
    );
}

fn dot(s: &mut String, (x, y): (f64, f64), colour: Colour, r: f64) {
    let _ = write!(
        s,
        r##"<circle class="mf {}" fill="{}" stroke="#ffffff" stroke-width="0.8" cx="{}" cy="{}" r="{r}"/>"##,
        colour.class(),
        colour.hex(),
        px(x),
        px(y)
    );
}

/// An arrowhead at a place, in the direction of a motion there.
fn arrow(s: &mut String, (x, y): (f64, f64), (dx, dy): (f64, f64), colour: Colour) {
    let size = dx.hypot(dy);
    if !(size > 0.0) {
        return;
    }
    let (a, b) = (dx / size, dy / size);
    let at = |along: f64, across: f64| (x + along * a - across * b, y + along * b + across * a);
    let d = path(&[at(4.5, 0.0), at(-3.5, 3.2), at(-3.5, -3.2)]);
    let _ = write!(s, r##"<path class="mf {}" fill="{}" stroke="#ffffff" stroke-width="0.6" d="{d}z"/>"##, colour.class(), colour.hex());
}

fn grey(s: &mut String, points: &[(f64, f64)], more: &str) {
    let _ = write!(s, r##"<path class="gr" stroke="#d4d8dd"{more} d="{}"/>"##, path(points));
}

/// An orbit with its point and its direction, where these can be seen.
fn orbit(s: &mut String, motion: &Whirl, at: &dyn Fn([f64; 2]) -> (f64, f64), radius: f64, colour: Colour) {
    let points: Vec<(f64, f64)> = motion.orbit(STEPS).into_iter().map(at).collect();
    line(s, &points, colour, 1.5, "");
    let (major, minor) = motion.axes();
    if minor.abs() > 0.08 * major && radius > 7.0 {
        let (a, b) = (at(motion.at(FRAC_PI_3)), at(motion.at(FRAC_PI_3 + 0.05)));
        arrow(s, a, (b.0 - a.0, b.1 - a.1), colour);
    }
    dot(s, at(motion.at(0.0)), colour, 3.0);
}

fn orbits(s: &mut String, t: &TileView, (x, y): (f64, f64), size: &Size) {
    let most = t.points.iter().map(|p| p.motion.axes().0).fold(0.0, f64::max);
    let circle = t.circle.filter(|c| most >= SEEN * c.radius);
    let scale = circle.map_or(most, |c| most.max(c.radius + c.centre[0].hypot(c.centre[1])));
    let (cx, cy, r) = (x + 0.5 * size.w, y + 0.5 * size.h + 3.0, 0.42 * size.w);
    grey(s, &[(cx - r, cy), (cx + r, cy)], "");
    grey(s, &[(cx, cy - r), (cx, cy + r)], "");
    text_at(s, (cx + r + 6.0, cy + 3.0), "x", Words { soft: true, ..Words::middle(9.0) });
    text_at(s, (cx, cy - r - 4.0), "y", Words { soft: true, ..Words::middle(9.0) });
    if !(scale > 0.0 && scale.is_finite()) {
        return;
    }
    if let Some(c) = circle {
        let _ = write!(
            s,
            r##"<circle class="lim" stroke="#a8121f" stroke-width="1.2" stroke-dasharray="4 3" cx="{}" cy="{}" r="{}"/>"##,
            px(cx + r * c.centre[0] / scale),
            px(cy - r * c.centre[1] / scale),
            px(r * c.radius / scale)
        );
    }
    let at = |p: [f64; 2]| (cx + r * p[0] / scale, cy - r * p[1] / scale);
    for p in &t.points {
        orbit(s, &p.motion, &at, r * p.motion.axes().0 / scale, Colour::Slot(p.body));
    }
}

/// Points of every line from the lowest place to the highest.
fn lines(t: &TileView) -> Vec<Vec<&Point>> {
    let mut numbers: Vec<i64> = t.points.iter().map(|p| p.line).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let one = |n: i64| {
        let mut own: Vec<&Point> = t.points.iter().filter(|p| p.line == n).collect();
        own.sort_by(|a, b| a.place.total_cmp(&b.place));
        own
    };
    numbers.into_iter().map(one).collect()
}

/// The shape in space, and along the axis beside it or below.
fn shape(s: &mut String, t: &TileView, (x, y): (f64, f64), horizontal: bool, to_scale: bool) {
    let most = t.points.iter().map(|p| p.motion.axes().0).fold(0.0, f64::max);
    let (low, high) = t.points.iter().map(|p| p.place).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
    if !(most > 0.0 && most.is_finite() && high > low) {
        return;
    }
    // places from -0.5 to 0.5
    let unit = |p: &Point| (p.place - low) / (high - low) - 0.5;
    let (camera, radius, length, centre) = if horizontal {
        (Camera::lying(0.55, 0.32), 30.0, 172.0, (x + 115.0, y + 58.0))
    } else {
        (Camera::upright(-0.42, 0.36), 34.0, 118.0, (x + 62.0, y + 80.0))
    };
    let axes = axes(t);
    let shift = shift(&axes, length / (high - low));
    let space = |axis: [f64; 2], place: f64, p: [f64; 2]| {
        let [sx, sy] = shift(axis);
        let (u, v) = camera.project([radius * p[0] / most + sx, radius * p[1] / most + sy, length * place]);
        (centre.0 + u, centre.1 - v)
    };
    // axes through the lowest place, and the axis of the machine
    for (k, name) in ["x", "y"].into_iter().enumerate() {
        let end = |r: f64| space(axes[0], -0.5, if k == 0 { [r, 0.0] } else { [0.0, r] });
        grey(s, &[end(-1.15 * most), end(1.15 * most)], "");
        let at = end(1.38 * most);
        text_at(s, (at.0, at.1 + 3.0), name, Words { soft: true, ..Words::middle(9.0) });
    }
    for &axis in &axes {
        grey(s, &[space(axis, -0.56, [0.0; 2]), space(axis, 0.56, [0.0; 2])], r#" stroke-dasharray="8 3 2 3""#);
    }
    // shafts beside each other differ by the colour of their body
    let of = |own: &[&Point]| Colour::Slot(if axes.len() > 1 { own[0].body } else { 6 });
    let all = lines(t);
    for p in t.points.iter().filter(|p| p.named) {
        let at = |q: [f64; 2]| space(p.axis, unit(p), q);
        orbit(s, &p.motion, &at, radius * p.motion.axes().0 / most, Colour::Slot(p.body));
    }
    for own in all.iter().filter(|o| o.len() > 1) {
        let points: Vec<_> = own.iter().map(|p| space(p.axis, unit(p), p.motion.at(0.0))).collect();
        line(s, &points, of(own), 1.8, "");
        for p in own.iter().filter(|p| p.named) {
            dot(s, space(p.axis, unit(p), p.motion.at(0.0)), Colour::Slot(p.body), 3.0);
        }
    }
    // along the axis: how far out in the planes of x and y, between the semi-major axes
    let axis = |place: f64, out: f64| {
        if horizontal {
            (centre.0 + camera.right[2] * length * place, y + 158.0 - 33.0 * out / most)
        } else {
            (x + 182.0 + 38.0 * out / most, centre.1 - camera.up[2] * length * place)
        }
    };
    grey(s, &[axis(-0.56, 0.0), axis(0.56, 0.0)], r#" stroke-dasharray="8 3 2 3""#);
    for own in &all {
        let fine = fine(own);
        let colour = Colour::Slot(own[0].body);
        let around = |side: f64| fine.iter().map(move |(z, m)| ((z - low) / (high - low) - 0.5, side * m.axes().0));
        if own.len() > 1 {
            let edge: Vec<_> = around(1.0).chain(around(-1.0).collect::<Vec<_>>().into_iter().rev()).map(|(z, r)| axis(z, r)).collect();
            let _ = write!(s, r##"<path class="env" fill="#0072b2" fill-opacity="0.13" d="{}z"/>"##, path(&edge));
            for (k, more) in [(1, r#" stroke-dasharray="4 3""#), (0, "")] {
                let points: Vec<_> = fine.iter().map(|(z, m)| axis((z - low) / (high - low) - 0.5, m.at(0.0)[k])).collect();
                line(s, &points, of(own), 1.6, more);
            }
        } else {
            let p = own[0];
            line(s, &[axis(unit(p), -p.motion.axes().0), axis(unit(p), p.motion.axes().0)], colour, 3.0, r#" stroke-opacity="0.35""#);
        }
    }
    let mut before = f64::NEG_INFINITY;
    let mut marked: Vec<&Point> = t.points.iter().filter(|p| p.named).collect();
    // of points at one place the height is that on the shaft
    let alone = |p: &Point| all.iter().any(|o| o.len() == 1 && std::ptr::eq(o[0], p));
    let along_first = |p: &Point| if horizontal { p.place } else { -p.place };
    marked.sort_by(|a, b| along_first(a).total_cmp(&along_first(b)).then(alone(a).cmp(&alone(b))));
    for p in marked {
        let at = axis(unit(p), p.motion.at(0.0)[0]);
        dot(s, at, Colour::Slot(p.body), 2.6);
        let foot = axis(unit(p), -1.12 * most);
        let (along, need) = if horizontal { (foot.0, width(&p.height, 9.0) + 4.0) } else { (foot.1, 10.0) };
        if to_scale && along - before >= need {
            let place = if horizontal { (foot.0, foot.1 + 6.0) } else { (foot.0 - 1.0, foot.1 + 3.0) };
            let anchor = if horizontal { "middle" } else { "end" };
            text_at(s, place, &p.height, Words { soft: true, anchor, ..Words::middle(9.0) });
            before = along;
        }
    }
}

/// The axes on which bodies lie, m, from that of the first body; one at least.
fn axes(t: &TileView) -> Vec<[f64; 2]> {
    let mut out: Vec<[f64; 2]> = Vec::new();
    for p in &t.points {
        if !out.contains(&p.axis) {
            out.push(p.axis);
        }
    }
    if out.is_empty() { vec![[0.0; 2]] } else { out }
}

/// Where an axis is drawn, pixels from their middle: to the scale of the lengths, but no farther than is free.
fn shift(axes: &[[f64; 2]], scale: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    const FREE: f64 = 22.0;
    let range = |k: usize| axes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x[k]), b.max(x[k])));
    let ranges = [range(0), range(1)];
    let widest = ranges.iter().map(|(a, b)| 0.5 * (b - a)).fold(0.0, f64::max);
    let scale = if widest > 0.0 { scale.min(FREE / widest) } else { scale };
    move |axis| [0, 1].map(|k| scale * (axis[k] - 0.5 * (ranges[k].0 + ranges[k].1)))
}

/// The motions of a line at its points and between them: the points of a rigid body between two others lie on the straight line through these.
fn fine(own: &[&Point]) -> Vec<(f64, Whirl)> {
    let mut out = Vec::new();
    for w in own.windows(2) {
        for k in 0..BETWEEN {
            let t = k as f64 / BETWEEN as f64;
            out.push((w[0].place + t * (w[1].place - w[0].place), w[0].motion.between(&w[1].motion, t)));
        }
    }
    out.extend(own.last().map(|p| (p.place, p.motion)));
    out
}

/// Colours of the bodies, meanings of the lines, remarks. Returns where it ends.
fn key(s: &mut String, scene: &Scene, view: &TilesView, w: f64, from: f64) -> f64 {
    let (mut x, mut y) = (4.0, from + 4.0);
    let say = |key: &'static str| scene.style.message(&Message::new(key));
    let mut entry = |s: &mut String, text: &str, draw: &dyn Fn(&mut String, f64, f64)| {
        let lines = wrap(text, TEXT, w - 36.0);
        let need = 28.0 + lines.iter().map(|l| width(l, TEXT)).fold(0.0, f64::max) + 12.0;
        if x > 4.0 && x + need > w {
            (x, y) = (4.0, y + 15.0);
        }
        draw(s, x, y - 3.5);
        for (k, l) in lines.iter().enumerate() {
            text_at(s, (x + 28.0, y + ROW * k as f64), l, Words::start(TEXT));
        }
        y += ROW * (lines.len() - 1) as f64;
        x += need;
    };
    let drawn = |k: usize| view.tiles.iter().flat_map(|t| &t.points).any(|p| p.body == k);
    if view.bodies.len() > 1 {
        for (k, name) in view.bodies.iter().enumerate().filter(|(k, _)| drawn(*k)) {
            entry(s, name, &|s, x, y| line(s, &[(x, y), (x + 22.0, y)], Colour::Slot(k), 2.0, ""));
        }
    }
    let ink = Colour::Slot(6);
    entry(s, &view.mark, &|s, x, y| dot(s, (x + 11.0, y), ink, 3.0));
    let joined = view.tiles.iter().any(|t| lines(t).iter().any(|own| own.len() > 1));
    if matches!(view.view, View::Shapes { .. }) && joined {
        entry(s, &say("tiles-plane-x"), &|s, x, y| line(s, &[(x, y), (x + 22.0, y)], ink, 1.6, ""));
        entry(s, &say("tiles-plane-y"), &|s, x, y| line(s, &[(x, y), (x + 22.0, y)], ink, 1.6, r#" stroke-dasharray="4 3""#));
        entry(s, &say("tiles-envelope"), &|s, x, y| {
            let _ = write!(s, r##"<path class="env" fill="#0072b2" fill-opacity="0.13" d="M{} {}h22v9h-22z"/>"##, px(x), px(y - 4.5));
        });
    }
    let circles = view.tiles.iter().any(|t| t.circle.is_some_and(|c| t.points.iter().any(|p| p.motion.axes().0 >= SEEN * c.radius)));
    if circles {
        entry(s, &say("tiles-clearance"), &|s, x, y| {
            let _ = write!(
                s,
                r##"<circle class="lim" stroke="#a8121f" stroke-width="1.2" stroke-dasharray="4 3" cx="{}" cy="{}" r="5"/>"##,
                px(x + 11.0),
                px(y)
            );
        });
    }
    let mut notes = Vec::new();
    match view.view {
        View::Shapes { to_scale: true, .. } => {
            notes.push(scene.style.message(&Message::new("tiles-heights").arg("unit", crate::outcome::Arg::name(&view.unit))));
        }
        View::Shapes { to_scale: false, .. } => notes.push(say("tiles-not-to-scale")),
        View::Orbits => {}
    }
    notes.extend(view.notes.iter().cloned());
    y += 4.0;
    for l in notes.iter().flat_map(|n| wrap(n, TEXT, w - 8.0)) {
        y += ROW + 1.0;
        text_at(s, (4.0, y), &l, Words { soft: true, ..Words::start(TEXT) });
    }
    y
}
