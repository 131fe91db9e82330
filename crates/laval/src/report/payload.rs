//! The numbers behind the drawings of a page, thinned and packed for its script.

use super::embed::floats;
use super::heat::HeatView;
use super::scene::{Kind, Scene, Series};
use super::svg::{DOTS, WIDE};
use super::thin;
use super::ticks::AxisView;
use crate::outcome::unit_text;
use crate::plain;
use serde_json::{Value, json};

/// Most points in all drawings of a page that can be zoomed, about 11 bytes each. With the part that each drawing has at least there may be twice as many.
const MOST_POINTS: usize = 30_000;
/// Most points in a drawing of a file of its own, and in one of the two that a page shows before its script runs.
const ALONE: usize = 45_000;
const ON_PAGE: usize = 8_000;
/// Widths of the pixel columns tried, finest first: the finer, the deeper one can zoom. The last ones are for hundreds of curves.
const COLUMNS: [f64; 13] = [0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 256.0, 1024.0];

/// The finest thinning of a drawing by itself: pixels, or more where many curves would make it large. The highest and the lowest point of a column stay whatever its width.
pub(super) fn drawn(scene: &Scene) -> f64 {
    column_within(&[scene], ALONE).max(1.0)
}

/// The same on a page.
pub(super) fn drawn_on_page(scene: &Scene) -> f64 {
    column_within(&[scene], ON_PAGE).max(1.0)
}

/// How the scenes of a page are thinned.
#[derive(Clone, Copy)]
pub(super) struct Thinning {
    /// The finest that keeps all scenes together below the limit of a page.
    column: f64,
    /// The part of the limit that each scene has for itself.
    share: usize,
}

impl Thinning {
    /// For these scenes.
    pub fn of(scenes: &[&Scene]) -> Self {
        Thinning { column: column_within(scenes, MOST_POINTS), share: MOST_POINTS / scenes.len().max(1) }
    }

    /// Of a scene: a long orbit beside it makes it no coarser than its own points do.
    pub fn column(&self, scene: &Scene) -> f64 {
        self.column.min(column_within(&[scene], self.share))
    }
}

fn column_within(scenes: &[&Scene], most: usize) -> f64 {
    let count = |column: f64| -> usize {
        scenes.iter().flat_map(|s| s.panels.iter().flat_map(move |p| p.series.iter().map(move |q| kept(q, &s.x, &p.y, column).len()))).sum()
    };
    COLUMNS.into_iter().find(|c| count(*c) <= most).unwrap_or(COLUMNS[COLUMNS.len() - 1])
}

fn kept(s: &Series, x: &AxisView, y: &AxisView, column: f64) -> Vec<usize> {
    let points: Vec<_> = s.points.iter().map(|q| (x.place(q.0) * WIDE, y.place(q.1) * WIDE)).collect();
    match s.kind {
        Kind::Marker { .. } => thin::cloud(&points, column),
        Kind::Solid | Kind::Dashed => thin::path(&points, column),
    }
}

/// JSON of a figure for the page's script, safe inside a `script` element.
pub(super) fn payload(scene: &Scene, column: f64) -> String {
    let panels: Vec<Value> = scene
        .panels
        .iter()
        .map(|p| {
            let series: Vec<Value> = p
                .series
                .iter()
                .map(|s| {
                    let rows = kept(s, &scene.x, &p.y, column);
                    let dots = rows.len() > DOTS;
                    let (kind, shape) = match s.kind {
                        Kind::Marker { shape, .. } => (if dots { "d" } else { "m" }, shape),
                        Kind::Solid | Kind::Dashed => ("l", 0),
                    };
                    let data = floats(rows.iter().flat_map(|i| [s.points[*i].0, s.points[*i].1]));
                    json!({ "n": plain::line(&s.name), "st": s.state, "k": kind, "sh": shape, "e": s.entry, "d": data })
                })
                .collect();
            json!({ "y": axis(&p.y), "s": series, "h": p.heat.as_ref().map(heat) })
        })
        .collect();
    json!({ "x": axis(&scene.x), "p": panels }).to_string().replace('<', "\\u003c")
}

fn axis(a: &AxisView) -> Value {
    let names: Vec<Value> = a
        .names
        .iter()
        .map(|n| json!([n.0, plain::line(&super::text::fit(&n.1, super::layout::TICK, super::layout::NAMES * WIDE))]))
        .collect();
    json!({ "k": a.knee, "names": names, "lo": a.lo, "hi": a.hi, "log": a.log, "e": a.exponent, "n": plain::line(&a.label), "u": unit_text(&a.unit), "ul": unit(a), "bare": a.bare })
}

/// The unit as the language writes it.
fn unit(a: &AxisView) -> String {
    a.language.unit(&unit_text(&a.unit))
}

fn heat(h: &HeatView) -> Value {
    let pack = |v: &[f64]| floats(v.iter().copied());
    let mut out = json!({ "x": pack(&h.xs), "y": pack(&h.ys), "v": pack(&h.values), "n": plain::line(&h.axis.label), "u": unit(&h.axis) });
    if !h.classes.is_empty() {
        out["c"] = h.classes.iter().map(|c| plain::line(&c.0).into_owned()).collect();
    }
    out
}
