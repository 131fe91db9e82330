//! Heat maps: long tables to grids, colours, cells and contours.

use super::colour::{self, Colour};
use super::ticks::AxisView;
use laval_num::order::ascending;

/// A grid of values in display units with its colour scale.
#[derive(Clone, Debug)]
pub(super) struct HeatView {
    /// Values of x and y at the cell centres, rising.
    pub xs: Vec<f64>,
    pub ys: Vec<f64>,
    /// Values row by row (y outer); NaN where there is none.
    pub values: Vec<f64>,
    /// Scale of the values.
    pub axis: AxisView,
    pub diverging: bool,
    /// Below zero it is forbidden: hatched.
    pub allowed: bool,
    pub contour: Option<f64>,
    /// Curves at these values in place of cells.
    pub curves: Option<Vec<f64>>,
    /// Names and colours of the values 0, 1, 2 ..; empty for numbers on a scale.
    pub classes: Vec<(String, Colour)>,
}

/// Finest grid that is drawn; larger ones are merged, keeping the value of largest size (an island of instability stays).
const MOST_CELLS: usize = 240;
const LEVELS: usize = 40;

impl HeatView {
    /// Grid from rows (x, y, value), in any order. Where cells are merged, a class is that of the first.
    pub fn grid(rows: &[(f64, f64, f64)], classes: bool) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let sorted = |pick: fn(&(f64, f64, f64)) -> f64| {
            let mut v: Vec<f64> = rows.iter().map(pick).filter(|v| v.is_finite()).collect();
            ascending(&mut v);
            v.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * a.abs().max(b.abs()));
            v
        };
        let (xs, ys) = (merge(sorted(|r| r.0)), merge(sorted(|r| r.1)));
        let mut values = vec![f64::NAN; xs.len() * ys.len()];
        for (x, y, v) in rows {
            if !(x.is_finite() && y.is_finite() && v.is_finite()) {
                continue;
            }
            let cell = &mut values[nearest(&ys, *y) * xs.len() + nearest(&xs, *x)];
            if cell.is_nan() || (!classes && v.abs() > cell.abs()) {
                *cell = *v;
            }
        }
        (xs, ys, values)
    }

    /// Place of a value on the colour map. Around zero each side has its own half, so that a small unstable region
    /// beside a large stable one keeps its colour.
    pub fn tone(&self, v: f64) -> f64 {
        if !self.diverging {
            return self.axis.place(v).clamp(0.0, 1.0);
        }
        let (lo, hi) = (self.axis.lo.min(0.0), self.axis.hi.max(0.0));
        let t = if v < 0.0 { 0.5 - 0.5 * (v / lo).min(1.0) } else { 0.5 + 0.5 * (v / hi).min(1.0) };
        if t.is_nan() { 0.5 } else { t }
    }

    /// Colour at a place of the colour map, quantised.
    pub fn colour(&self, tone: f64) -> String {
        if self.allowed { colour::allowed(tone) } else { colour::heat(tone, self.diverging) }
    }

    /// Path data in pixels of the cells with values below zero: runs along x.
    pub fn forbidden(&self, x: &AxisView, y: &AxisView, w: f64, h: f64) -> String {
        let (xe, ye) = (edges(&self.xs, x), edges(&self.ys, y));
        let n = self.xs.len();
        let mut out = String::new();
        for j in 0..self.ys.len() {
            let mut first = 0;
            for run in self.values[j * n..(j + 1) * n].chunk_by(|a, b| (*a < 0.0) == (*b < 0.0)) {
                let (from, to) = (xe[first] * w, xe[first + run.len()] * w);
                first += run.len();
                if run[0] < 0.0 {
                    let [a, b, c, d] = [from, (1.0 - ye[j + 1]) * h, to, (1.0 - ye[j]) * h].map(super::text::px);
                    out.push_str(&format!("M{a} {b}H{c}V{d}H{a}z"));
                }
            }
        }
        out
    }

    /// Colour, class of the style sheet and path data in pixels: runs of equal colour along x, joined per colour.
    pub fn cells(&self, x: &AxisView, y: &AxisView, w: f64, h: f64) -> Vec<(String, String, String)> {
        let (xe, ye) = (edges(&self.xs, x), edges(&self.ys, y));
        let last = if self.classes.is_empty() { LEVELS } else { self.classes.len() - 1 };
        let mut paths: Vec<String> = vec![String::new(); last + 1];
        let n = self.xs.len();
        for j in 0..self.ys.len() {
            let (y0, y1) = ((1.0 - ye[j + 1]) * h, (1.0 - ye[j]) * h);
            let level = |i: usize| {
                let v = self.values[j * n + i];
                v.is_finite().then(|| if self.classes.is_empty() { (self.tone(v) * LEVELS as f64).round() as usize } else { v as usize })
            };
            let mut i = 0;
            while i < n {
                let first = i;
                let here = level(i);
                while i < n && level(i) == here {
                    i += 1;
                }
                if let Some(l) = here {
                    let (x0, x1) = (xe[first] * w, xe[i] * w);
                    paths[l.min(last)].push_str(&format!(
                        "M{} {}H{}V{}H{}z",
                        super::text::px(x0),
                        super::text::px(y0),
                        super::text::px(x1),
                        super::text::px(y1),
                        super::text::px(x0)
                    ));
                }
            }
        }
        let coloured = paths.into_iter().enumerate().filter(|(_, p)| !p.is_empty());
        let style = |l: usize| match self.classes.get(l) {
            Some((_, c)) => (c.hex(), format!("mf {}", c.class())),
            None => (self.colour(l as f64 / LEVELS as f64), String::new()),
        };
        coloured
            .map(|(l, p)| {
                let (colour, class) = style(l);
                (colour, class, p)
            })
            .collect()
    }

    /// Pieces of the curve where the value equals `level`, as pairs of places (0..1) broken by NaN: marching squares on the cell centres.
    pub fn contour_path(&self, level: f64, x: &AxisView, y: &AxisView) -> Vec<(f64, f64)> {
        let (px, py): (Vec<f64>, Vec<f64>) = (self.xs.iter().map(|v| x.place(*v)).collect(), self.ys.iter().map(|v| y.place(*v)).collect());
        let n = px.len();
        let mut segments = Vec::new();
        for j in 0..py.len().saturating_sub(1) {
            for i in 0..n.saturating_sub(1) {
                let corner = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let v = corner.map(|(a, b)| self.values[b * n + a] - level);
                if v.iter().any(|v| !v.is_finite()) {
                    continue;
                }
                let mut cuts = Vec::with_capacity(4);
                for k in 0..4 {
                    let (a, b) = (v[k], v[(k + 1) % 4]);
                    if (a > 0.0) != (b > 0.0) {
                        let f = a / (a - b);
                        let (p, q) = (corner[k], corner[(k + 1) % 4]);
                        cuts.push((px[p.0] + f * (px[q.0] - px[p.0]), py[p.1] + f * (py[q.1] - py[p.1])));
                    }
                }
                segments.extend(cuts.chunks_exact(2).map(|c| (c[0], c[1])));
            }
        }
        join(segments)
    }
}

/// Chains segments that touch into polylines separated by NaN.
fn join(segments: Vec<((f64, f64), (f64, f64))>) -> Vec<(f64, f64)> {
    use std::collections::BTreeMap;
    let key = |p: (f64, f64)| ((p.0 * 1e7).round() as i64, (p.1 * 1e7).round() as i64);
    let mut ends: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
    for (i, s) in segments.iter().enumerate() {
        ends.entry(key(s.0)).or_default().push(i);
        ends.entry(key(s.1)).or_default().push(i);
    }
    let mut used = vec![false; segments.len()];
    let mut out = Vec::new();
    for start in 0..segments.len() {
        if used[start] {
            continue;
        }
        used[start] = true;
        let mut chain = std::collections::VecDeque::from([segments[start].0, segments[start].1]);
        for forward in [true, false] {
            loop {
                let tip = if forward { chain[chain.len() - 1] } else { chain[0] };
                let Some(next) = ends.get(&key(tip)).and_then(|c| c.iter().copied().find(|i| !used[*i])) else { break };
                used[next] = true;
                let s = segments[next];
                let far = if key(s.0) == key(tip) { s.1 } else { s.0 };
                if forward { chain.push_back(far) } else { chain.push_front(far) }
            }
        }
        out.extend(chain);
        out.push((f64::NAN, f64::NAN));
    }
    out
}

fn merge(v: Vec<f64>) -> Vec<f64> {
    let stride = v.len().div_ceil(MOST_CELLS).max(1);
    v.chunks(stride).map(|c| c[c.len() / 2]).collect()
}

fn nearest(sorted: &[f64], v: f64) -> usize {
    let i = sorted.partition_point(|s| *s < v);
    if i == 0 || (i < sorted.len() && sorted[i] - v <= v - sorted[i - 1]) { i } else { i - 1 }
}

/// Cell borders half way between the centres, the outer ones at the ends of the range, as places on the axis.
pub(super) fn edges(centres: &[f64], axis: &AxisView) -> Vec<f64> {
    let t: Vec<f64> = centres.iter().map(|v| axis.place(*v)).collect();
    match t.as_slice() {
        [] => Vec::new(),
        [only] => vec![only - 0.05, only + 0.05],
        _ => {
            let n = t.len();
            let mut e = Vec::with_capacity(n + 1);
            e.push(t[0]);
            e.extend(t.windows(2).map(|w| 0.5 * (w[0] + w[1])));
            e.push(t[n - 1]);
            e
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(lo: f64, hi: f64) -> AxisView {
        AxisView::new("", "", false, lo, hi)
    }

    fn view(rows: &[(f64, f64, f64)], lo: f64, hi: f64) -> HeatView {
        let (xs, ys, values) = HeatView::grid(rows, false);
        HeatView { xs, ys, values, axis: unit(lo, hi), diverging: true, allowed: false, contour: None, curves: None, classes: vec![] }
    }

    #[test]
    fn grid_in_any_order_with_a_hole() {
        let (xs, ys, v) = HeatView::grid(&[(2.0, 0.0, 4.0), (1.0, 1.0, f64::NAN), (1.0, 0.0, 3.0), (2.0, 1.0, 6.0)], false);
        assert_eq!((xs, ys), (vec![1.0, 2.0], vec![0.0, 1.0]));
        assert_eq!(&v[..2], [3.0, 4.0]);
        assert!(v[2].is_nan() && v[3] == 6.0);
    }

    #[test]
    fn large_grids_keep_islands() {
        let rows: Vec<_> =
            (0..1000).flat_map(|i| (0..2).map(move |j| (i as f64, j as f64, if i == 501 && j == 1 { 9.0 } else { -1.0 }))).collect();
        let (xs, _, v) = HeatView::grid(&rows, false);
        assert!(xs.len() <= MOST_CELLS);
        assert!(v.contains(&9.0));
    }

    #[test]
    fn classes_have_their_own_colours() {
        let (xs, ys, values) = HeatView::grid(&[(0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (0.0, 1.0, 1.0), (1.0, 1.0, f64::NAN)], true);
        let classes = vec![("a".to_string(), Colour::Slot(0)), ("b".to_string(), Colour::Slot(1))];
        let h = HeatView { xs, ys, values, axis: unit(0.0, 1.0), diverging: false, allowed: false, contour: None, curves: None, classes };
        let drawn = h.cells(&unit(0.0, 1.0), &unit(0.0, 1.0), 10.0, 10.0);
        assert_eq!(drawn.iter().map(|c| c.0.as_str()).collect::<Vec<_>>(), [colour::SLOTS[0], colour::SLOTS[1]]);
        assert_eq!(drawn.iter().map(|c| c.2.matches('z').count()).collect::<Vec<_>>(), [1, 2]);
    }

    /// Nothing is said beyond the range that was computed.
    #[test]
    fn cells_end_with_the_range() {
        let axis = unit(0.0, 1.0);
        assert_eq!(edges(&[0.0, 0.25, 1.0], &axis), [0.0, 0.125, 0.625, 1.0]);
    }

    #[test]
    fn each_side_of_zero_has_half_the_colours() {
        let h = view(&[(0.0, 0.0, -100.0), (1.0, 0.0, 2.0)], -100.0, 2.0);
        assert_eq!([h.tone(-100.0), h.tone(0.0), h.tone(1.0), h.tone(2.0)], [0.0, 0.5, 0.75, 1.0]);
    }

    /// The contour of the distance from a centre is a circle.
    #[test]
    fn contour_is_where_the_value_is() {
        let rows: Vec<_> = (0..41)
            .flat_map(|i| (0..41).map(move |j| (i as f64 / 40.0, j as f64 / 40.0)))
            .map(|(x, y)| (x, y, ((x - 0.5).powi(2) + (y - 0.5).powi(2)).sqrt()))
            .collect();
        let path = view(&rows, 0.0, 1.0).contour_path(0.3, &unit(0.0, 1.0), &unit(0.0, 1.0));
        let points: Vec<_> = path.iter().filter(|p| p.0.is_finite()).collect();
        assert!(points.len() > 50);
        assert_eq!(path.len() - points.len(), 1, "one closed curve");
        for p in points {
            // linear interpolation of a distance over a cell of 1/40
            assert!((((p.0 - 0.5).powi(2) + (p.1 - 0.5).powi(2)).sqrt() - 0.3).abs() < 1e-3);
        }
    }
}
