//! Curves that go on beyond the range of their axis.

use super::{Kind, Series};
use crate::report::ticks::AxisView;

/// A curve goes on beyond the range.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::report) struct Cut {
    /// Where on x it goes farthest, in display units.
    pub x: f64,
    /// How far, in display units.
    pub to: f64,
    /// Beyond the upper end.
    pub up: bool,
}

/// Share of the width within which two of them are marked as one.
const NEAR: f64 = 0.09;
/// How far beyond a curve has to go, over the range: less is hardly seen.
const LEAST: f64 = 1e-3;

/// Every stretch of a curve beyond the range once; of those side by side the farthest.
pub(in crate::report) fn cut(series: &[Series], x: &AxisView, y: &AxisView) -> Vec<Cut> {
    let mut all: Vec<Cut> = Vec::new();
    for s in series.iter().filter(|s| !s.reference && matches!(s.kind, Kind::Solid | Kind::Dashed)) {
        let mut run: Option<Cut> = None;
        for (px, py) in &s.points {
            let (a, b) = (x.place(*px), y.place(*py));
            let beyond = (-1e-9..=1.0 + 1e-9).contains(&a) && b.is_finite() && !(-LEAST..=1.0 + LEAST).contains(&b);
            let here = beyond.then_some(Cut { x: *px, to: *py, up: b > 1.0 });
            match (&mut run, here) {
                (Some(r), Some(h)) if r.up == h.up => {
                    if (h.to > r.to) == h.up {
                        *r = h;
                    }
                }
                (_, h) => all.extend(std::mem::replace(&mut run, h)),
            }
        }
        all.extend(run);
    }
    // the farthest first, so that it stays
    all.sort_by(|a, b| b.to.abs().total_cmp(&a.to.abs()));
    let mut out: Vec<Cut> = Vec::new();
    for c in all {
        if !out.iter().any(|o| o.up == c.up && (x.place(o.x) - x.place(c.x)).abs() < NEAR) {
            out.push(c);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::colour::Colour;

    #[test]
    fn every_stretch_beyond_the_range_is_marked_once() {
        let points: Vec<(f64, f64)> =
            (0..=95).map(|k| (f64::from(k), 50.0 * (f64::from(k) * 0.2).sin())).chain([(f64::NAN, f64::NAN)]).collect();
        let series = |reference, kind| Series {
            name: String::new(),
            state: String::new(),
            kind,
            colour: Colour::Slot(0),
            points: points.clone(),
            entry: None,
            reference,
            below: 0,
        };
        let (x, y) = (AxisView::new("", "", false, 0.0, 100.0), AxisView::new("", "", false, -100.0, 40.0));
        let found = cut(&[series(false, Kind::Solid)], &x, &y);
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found.iter().all(|c| c.up && (c.to - 50.0).abs() < 0.3));
        // a second curve over the same stretches adds none, reference lines and markers are no curves
        assert_eq!(cut(&[series(false, Kind::Solid), series(false, Kind::Dashed)], &x, &y).len(), 3);
        assert!(cut(&[series(true, Kind::Solid), series(false, Kind::Marker { shape: 0, open: false })], &x, &y).is_empty());
        let y = AxisView::new("", "", false, -60.0, 60.0);
        assert!(cut(&[series(false, Kind::Solid)], &x, &y).is_empty());
    }
}
