//! Where everything goes: margins, panels, labels that do not overlap, legend below the data.

use super::scene::{Glyph, Scene};
use super::text::{fit, width, wrap};
use super::ticks::Ticks;
use crate::outcome::{Arg, Message};

pub(super) const TICK: f64 = 11.0;
pub(super) const LABEL: f64 = 12.0;
pub(super) const TITLE: f64 = 14.0;
const ROW: f64 = 14.0;
/// Distance of lines of a label beside a panel.
pub(super) const LEADING: f64 = 12.5;
/// Side of a square panel.
const LARGEST_SQUARE: f64 = 440.0;
/// Share of the width for names along y, at most.
pub(super) const NAMES: f64 = 0.32;
/// Most rows of labels above a panel; what does not fit is listed in the legend.
const MOST_ROWS: usize = 5;

pub(super) struct Layout {
    pub w: f64,
    pub h: f64,
    pub x0: f64,
    pub pw: f64,
    pub x_ticks: Ticks,
    pub panels: Vec<PanelBox>,
    pub x_title_y: f64,
    /// Left end and baseline of each entry of the legend with its fitted text.
    pub legend: Vec<(f64, f64, String)>,
    /// Labels of rules for which there is no room.
    pub note: Option<(f64, f64, String)>,
}

pub(super) struct PanelBox {
    pub y0: f64,
    pub h: f64,
    pub title_y: f64,
    pub y_ticks: Ticks,
    pub labels: Vec<Label>,
    pub bar: Option<Bar>,
}

/// Colour bar of a heat map.
pub(super) struct Bar {
    pub x: f64,
    pub title_y: f64,
    /// Distance from the top and label.
    pub ticks: Vec<(f64, String)>,
}

/// A label of a rule or of a reference line, outside the panel.
pub(super) struct Label {
    pub lines: Vec<String>,
    pub x: f64,
    pub y: f64,
    /// From the panel to the text.
    pub leader: Option<[f64; 4]>,
    /// Moves with the data along x (true), along y (false).
    pub vertical: bool,
    /// Belongs to a reference line: hidden while zoomed.
    pub reference: bool,
}

struct Wanted {
    /// Place 0..1 along x or y.
    at: f64,
    text: String,
    reference: bool,
}

fn wanted(scene: &Scene, panel: usize) -> (Vec<Wanted>, Vec<Wanted>) {
    let p = &scene.panels[panel];
    let (mut top, mut right) = (Vec::new(), Vec::new());
    for r in p.rules.iter().filter(|r| !r.label.is_empty()) {
        let at = if r.vertical { scene.x.place(r.at) } else { p.y.place(r.at) };
        let above = |q: &super::scene::PanelView| q.rules.iter().any(|o| o.vertical && o.at == r.at && o.label == r.label);
        if !(-1e-9..=1.0 + 1e-9).contains(&at) || (r.vertical && scene.panels[..panel].iter().any(above)) {
            continue;
        }
        let w = Wanted { at, text: r.label.clone(), reference: false };
        if r.vertical { top.push(w) } else { right.push(w) }
    }
    let named = p.series.iter().filter(|s| s.reference && !s.name.is_empty()).map(|s| (&s.points, &s.name));
    for (points, name) in named.chain(p.ends.iter().map(|e| (&e.0, &e.1))) {
        let places: Vec<_> = points.iter().map(|(x, y)| (scene.x.place(*x), p.y.place(*y))).collect();
        let inside = |q: &(f64, f64)| (-1e-9..=1.0 + 1e-9).contains(&q.0) && (-1e-9..=1.0 + 1e-9).contains(&q.1);
        let Some(last) = places.iter().rposition(inside) else { continue };
        let mut end = places[last];
        if let Some(next) = places.get(last + 1).filter(|n| n.0.is_finite() && n.1.is_finite()) {
            let room = |a: f64, d: f64| {
                if d > 0.0 {
                    (1.0 - a) / d
                } else if d < 0.0 {
                    -a / d
                } else {
                    f64::INFINITY
                }
            };
            let (dx, dy) = (next.0 - end.0, next.1 - end.1);
            let f = room(end.0, dx).min(room(end.1, dy)).clamp(0.0, 1.0);
            end = (end.0 + f * dx, end.1 + f * dy);
        }
        let w = |at| Wanted { at, text: name.clone(), reference: true };
        if end.1 > 0.97 && end.0 < 0.99 { top.push(w(end.0)) } else { right.push(w(end.1)) }
    }
    top.sort_by(|a, b| a.at.total_cmp(&b.at));
    right.sort_by(|a, b| b.at.total_cmp(&a.at));
    (top, right)
}

/// Rows for labels that stand at their leaders like flags: a label that reaches over the next leader goes above that label,
/// so that no leader crosses a text. Row 0 is nearest the panel.
fn rows(spans: &[(f64, f64)]) -> Vec<usize> {
    let mut rows = vec![0; spans.len()];
    for i in (0..spans.len()).rev() {
        let over = (i + 1..spans.len()).filter(|j| spans[*j].0 < spans[i].1 + 5.0);
        rows[i] = over.map(|j| rows[j] + 1).max().unwrap_or(0);
    }
    rows
}

impl Layout {
    pub fn new(scene: &Scene, w: f64, title: bool) -> Layout {
        let narrow = w < 500.0;
        let ph = match (scene.panels.len(), narrow) {
            (0 | 1, false) => 340.0,
            (0 | 1, true) => 250.0,
            (2, false) => 210.0,
            (_, false) => 170.0,
            (_, true) => 150.0,
        };
        let wants: Vec<_> = (0..scene.panels.len()).map(|i| wanted(scene, i)).collect();
        let mut y_ticks: Vec<Ticks> = scene.panels.iter().map(|p| p.y.ticks((p.height * ph / 42.0) as usize)).collect();
        for (ticks, _) in y_ticks.iter_mut().zip(&scene.panels).filter(|t| !t.1.y.names.is_empty()) {
            ticks.major.iter_mut().for_each(|t| t.1 = fit(&t.1, TICK, NAMES * w));
        }
        let widest = |t: &Ticks| t.major.iter().map(|m| width(&m.1, TICK)).fold(0.0, f64::max);
        let x0 = (y_ticks.iter().map(widest).fold(0.0, f64::max) + 12.0).max(30.0).ceil();
        let label_room = if narrow { 0.2 * w } else { 0.22 * w };
        let broken = |text: &str| wrap(text, TICK, label_room);
        let widest_line = |r: &Wanted| broken(&r.text).iter().map(|l| width(l, TICK)).fold(0.0, f64::max);
        let rights = wants.iter().flat_map(|w| &w.1).map(widest_line).fold(0.0, f64::max);
        let bars: Vec<Option<Ticks>> = scene.panels.iter().map(|p| scale(p).map(|h| bar_ticks(h, p.height * ph))).collect();
        let bar_room = bars.iter().flatten().map(|t| 16.0 + 14.0 + 6.0 + widest(t)).fold(0.0, f64::max);
        let label_space = if rights > 0.0 { rights + 8.0 } else { 0.0 };
        let mut right = (label_space + bar_room).max(18.0).ceil();
        // the label of the last tick may reach farther than what stands beside the panel
        let over = |right: f64| {
            let pw = (w - x0 - right).max(60.0);
            let ends = x_ticks(scene, pw).major.into_iter().map(|(v, l)| x0 + scene.x.place(v) * pw + 0.5 * width(&l, TICK) + 2.0);
            (ends.fold(0.0, f64::max) - w).max(0.0)
        };
        right += over(right).ceil();
        let pw = (w - x0 - right).max(60.0);
        let (pw, ph) = if scene.equal { (pw.min(LARGEST_SQUARE), pw.min(LARGEST_SQUARE)) } else { (pw, ph) };
        let x_ticks = x_ticks(scene, pw);

        let mut y = if title { 30.0 } else { 4.0 };
        let mut panels = Vec::new();
        let mut omitted = Vec::new();
        for (i, (p, (tops, rights))) in scene.panels.iter().zip(wants).enumerate() {
            let ph = if scene.equal { ph } else { p.height * ph };
            y += LABEL + 2.0;
            let title_y = y;
            // the title of the colours stands beside that of y when both fit
            let bar_title = scale(p).map(|h| h.axis.title());
            let together = bar_title.as_ref().is_none_or(|t| width(t, LABEL) + width(&p.y.title(), LABEL) + 20.0 < w);
            if !together {
                y += ROW + 2.0;
            }
            let bar_title_y = y;
            y += 6.0;
            let spans: Vec<_> = tops
                .iter()
                .map(|t| {
                    let tw = width(&t.text, TICK).min(0.6 * w);
                    let x = (x0 + t.at * pw).min(w - tw - 2.0);
                    (x, x + tw)
                })
                .collect();
            let placed = rows(&spans);
            let deepest = placed.iter().filter(|r| **r < MOST_ROWS).max().map_or(0, |r| r + 1);
            y += deepest as f64 * ROW;
            let y0 = y + if deepest > 0 { 3.0 } else { 0.0 };
            let mut labels = Vec::new();
            for ((t, span), row) in tops.into_iter().zip(&spans).zip(placed) {
                if row >= MOST_ROWS {
                    omitted.push(t.text);
                    continue;
                }
                let x = x0 + t.at * pw;
                let base = y0 - 5.0 - row as f64 * ROW;
                let leader = Some([x, y0, x, base - if span.0 < x - 0.5 { -3.0 } else { 8.0 }]);
                let shift = if span.0 < x - 0.5 { 0.0 } else { 3.0 };
                let lines = vec![fit(&t.text, TICK, 0.6 * w)];
                labels.push(Label { lines, x: span.0 + shift, y: base, leader, vertical: true, reference: t.reference });
            }
            let texts: Vec<Vec<String>> = rights.iter().map(|r| broken(&r.text)).collect();
            let extra = |lines: &Vec<String>| LEADING * (lines.len() as f64 - 1.0);
            let mut ys: Vec<f64> = rights.iter().zip(&texts).map(|(r, t)| y0 + (1.0 - r.at) * ph + 4.0 - 0.5 * extra(t)).collect();
            let heights: Vec<f64> = texts.iter().map(|t| LEADING + extra(t)).collect();
            spread(&mut ys, &heights, y0 + 6.0, y0 + ph + 4.0);
            for ((r, y), lines) in rights.into_iter().zip(ys).zip(texts) {
                let from = y0 + (1.0 - r.at) * ph;
                let middle = y - 4.0 + 0.5 * extra(&lines);
                let leader = ((middle - from).abs() > 2.0).then_some([x0 + pw, from, x0 + pw + 5.0, middle]);
                labels.push(Label { lines, x: x0 + pw + 6.0, y, leader, vertical: false, reference: r.reference });
            }
            let bar = bars[i].as_ref().zip(scale(p)).map(|(t, h)| {
                let ticks = t.major.iter().map(|(v, l)| (ph * (1.0 - bar_place(h, *v)), l.clone())).collect();
                Bar { x: x0 + pw + label_space + 16.0, title_y: bar_title_y, ticks }
            });
            y = y0 + ph;
            panels.push(PanelBox { y0, h: ph, title_y, y_ticks: y_ticks[i].clone(), labels, bar });
            y += if i + 1 < scene.panels.len() { 8.0 } else { 0.0 };
        }
        let x_title_y = y + 34.0;
        y = x_title_y + 6.0;
        let left = if narrow { 6.0 } else { x0 };
        let (mut legend, mut x) = (Vec::new(), left);
        for (k, e) in scene.legend.iter().enumerate() {
            let text = fit(&e.label, TICK, w - left - 34.0);
            let need = 30.0 + width(&text, TICK) + 14.0;
            if k == 0 {
                y += 18.0;
            } else if x + need > w {
                (x, y) = (left, y + 18.0);
            }
            legend.push((x, y, text));
            x += need;
        }
        let note = (!omitted.is_empty()).then(|| {
            y += 18.0;
            (left, y, fit(&also_marked(scene, &omitted), TICK, w - left))
        });
        Layout { w, h: y + 8.0, x0, pw, x_ticks, panels, x_title_y, legend, note }
    }
}

/// Labels of rules for which there is no room.
fn also_marked(scene: &Scene, labels: &[String]) -> String {
    scene.style.message(&Message::new("page-also-marked").arg("labels", Arg::term(labels.join(", "))))
}

/// As many x ticks as fit without touching each other.
fn x_ticks(scene: &Scene, pw: f64) -> Ticks {
    let mut most = (pw / 55.0) as usize;
    loop {
        let t = scene.x.ticks(most);
        let ends: Vec<_> = t.major.iter().map(|(v, l)| (scene.x.place(*v) * pw, width(l, TICK) / 2.0)).collect();
        if most <= 2 || ends.windows(2).all(|e| e[0].0 + e[0].1 + 10.0 < e[1].0 - e[1].1) {
            return t;
        }
        most -= 1;
    }
}

/// Place of a value on the colour bar, which shows only the range of the data.
pub(super) fn bar_place(h: &super::heat::HeatView, v: f64) -> f64 {
    let (a, b) = (h.tone(h.axis.lo), h.tone(h.axis.hi));
    if b > a { (h.tone(v) - a) / (b - a) } else { 0.5 }
}

/// The heat map of a panel whose colours are a scale.
fn scale(p: &super::scene::PanelView) -> Option<&super::heat::HeatView> {
    p.heat.as_ref().filter(|h| h.classes.is_empty() && h.curves.is_none())
}

fn bar_ticks(h: &super::heat::HeatView, height: f64) -> Ticks {
    let (lo, hi) = (h.axis.lo, h.axis.hi);
    if !h.diverging || lo >= 0.0 || hi <= 0.0 {
        return h.axis.ticks((height / 42.0) as usize);
    }
    // each side of zero has its own scale
    let side = |lo: f64, hi: f64| super::ticks::AxisView { lo, hi, ..h.axis.clone() }.ticks(4).major;
    let mut major = side(lo, 0.0);
    major.extend(side(0.0, hi).into_iter().filter(|t| t.0 > 0.0));
    // two scales write zero with different decimals
    major.iter_mut().filter(|t| t.0 == 0.0).for_each(|t| t.1 = "0".into());
    Ticks { major, minor: Vec::new() }
}

/// Moves the first lines of labels of these heights apart, from top to bottom within the limits as long as there is room.
fn spread(ys: &mut [f64], heights: &[f64], top: f64, bottom: f64) {
    for i in 0..ys.len() {
        let least = if i == 0 { top } else { ys[i - 1] + heights[i - 1] };
        ys[i] = ys[i].max(least);
    }
    for i in (0..ys.len()).rev() {
        let most = if i + 1 == ys.len() { bottom - heights[i] + LEADING } else { ys[i + 1] - heights[i] };
        ys[i] = ys[i].min(most);
    }
}

/// Width of the sample in front of a legend text.
pub(super) fn is_line(glyph: Glyph) -> bool {
    matches!(glyph, Glyph::Line | Glyph::Dashed | Glyph::Contour)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_do_not_overlap_and_leaders_cross_no_text() {
        let spans = [(0.0_f64, 100.0), (20.0, 90.0), (30.0, 60.0), (200.0, 220.0), (64.0, 80.0)];
        let mut sorted = spans.to_vec();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let r = rows(&sorted);
        for i in 0..sorted.len() {
            for j in i + 1..sorted.len() {
                if sorted[j].0 < sorted[i].1 {
                    assert!(r[i] > r[j], "label {i} reaches over leader {j}");
                }
            }
        }
        assert_eq!(r[4], 0);
    }

    #[test]
    fn labels_spread_inside_the_panel() {
        let mut ys = [10.0, 11.0, 12.0, 99.0, 99.5];
        let heights = [LEADING, 2.0 * LEADING, LEADING, LEADING, 2.0 * LEADING];
        spread(&mut ys, &heights, 0.0, 100.0);
        assert!((0..4).all(|k| ys[k + 1] - ys[k] >= heights[k] - 1e-12), "{ys:?}");
        assert!(ys[0] >= 0.0 && ys[4] + LEADING <= 100.0);
    }
}
