//! How far the speed is from those at which stability begins or ends.
//!
//! Equations, w_s the nearest speed at which the largest growth rate passes -sig0:
//!
//! ```text
//! 1 - min(w, w_s)/max(w, w_s)   where stable, 1 without such a speed in the range;   its negative elsewhere
//! ```
//!
//! A distance in speed, as those of `strength` and `clear`: growth rates have no scale of their own that a limit of zero could be compared with.
//!
//! Sources: `docs/theory/operating-window.md#margins`; (-largest growth rate - sig0)/w has the same zeros.

use super::margins::{Point, STABLE};
use super::window::Interval;

/// Speeds at which stability begins or ends, rad/s.
pub(super) struct Borders(Vec<f64>);

/// The requirement on stability is kept.
pub(super) fn stable(p: &Point) -> bool {
    p.margin(STABLE).is_some_and(|m| m >= 0.0)
}

impl Borders {
    /// From the intervals in which the machine is stable.
    pub fn located(intervals: &[Interval]) -> Self {
        let ends = intervals.iter().flat_map(|i| [&i.low, &i.high]);
        Borders(ends.filter(|e| e.event != "domain limit").map(|e| e.speed).collect())
    }

    /// Straight between the points of a grid.
    pub fn between(points: &[Point]) -> Self {
        let pairs = points.windows(2).filter(|p| stable(&p[0]) != stable(&p[1]));
        Borders(
            pairs
                .map(|p| {
                    let (a, b) = (p[0].margin(STABLE).unwrap_or(f64::NAN), p[1].margin(STABLE).unwrap_or(f64::NAN));
                    let share = a / (a - b);
                    p[0].speed + (p[1].speed - p[0].speed) * if share.is_finite() { share } else { 0.5 }
                })
                .collect(),
        )
    }

    /// Margin of stability at a speed at which the machine is stable or not.
    fn margin(&self, speed: f64, stable: bool) -> f64 {
        let w = speed.abs();
        let nearest = self.0.iter().map(|s| 1.0 - w.min(s.abs()) / w.max(s.abs())).fold(1.0, f64::min);
        // what is not stable is never kept, however near
        if stable { nearest } else { -nearest.max(f64::EPSILON) }
    }

    /// Puts the distance in speed in place of the growth rate by which stability was found.
    pub fn measure(&self, p: &mut Point) {
        for m in p.margins.iter_mut().filter(|m| m.name == STABLE && m.value.is_finite()) {
            m.value = self.margin(p.speed, m.value >= 0.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::centrifuge::operating_window::detail::Detail;
    use crate::study::centrifuge::operating_window::margins::Margin;

    fn point(speed: f64, value: f64) -> Point {
        let margins = vec![Margin { name: STABLE, value, detail: Detail::Itself }];
        Point { speed, margins, needed: 0.0, tilt: 0.0, unbalance: 0.0, states: 1, energy: 0.0, growth: 0.0, leans: vec![] }
    }

    /// A band of instability from 100 to 150: one at rest stands for far away, and the sign is kept, on the border too.
    #[test]
    fn distances_in_speed() {
        let b = Borders(vec![100.0, 150.0]);
        for (w, found, want) in [(50.0, 1e-9, 0.5), (100.0, 0.0, 0.0), (120.0, -1e-9, -1.0 / 6.0), (200.0, 7.0, 0.25)] {
            let mut p = point(w, found);
            b.measure(&mut p);
            assert!((p.margins[0].value - want).abs() < 1e-15, "{w}");
        }
        let mut beside = point(100.0, -1e-300);
        b.measure(&mut beside);
        assert!(beside.margins[0].value < 0.0);
        let mut undefined = point(120.0, f64::NAN);
        b.measure(&mut undefined);
        assert!(undefined.margins[0].value.is_nan());
        let mut alone = point(120.0, 1e-3);
        Borders(vec![]).measure(&mut alone);
        assert_eq!(alone.margins[0].value, 1.0);
    }

    #[test]
    fn borders_of_a_grid_lie_where_the_growth_passes_its_limit() {
        let points: Vec<Point> = (1..=5).map(|k| point(f64::from(k), 3.25 - f64::from(k))).collect();
        assert_eq!(Borders::between(&points).0, [3.25]);
        let missing = [point(1.0, 1.0), point(2.0, f64::NAN)];
        assert_eq!(Borders::between(&missing).0, [1.5]);
    }

    /// Points are compared by the least margin, by the next where it is the same, and one that lacks a margin stands behind all.
    #[test]
    fn the_next_margin_decides_where_the_least_is_the_same() {
        let of = |values: &[f64]| {
            let margins = values.iter().enumerate().map(|(name, &value)| Margin { name, value, detail: Detail::Itself }).collect();
            Point { margins, ..point(1.0, 0.0) }.room()
        };
        assert!(of(&[0.1, 0.9, 0.3]) > of(&[0.1, 0.2, 0.9]));
        assert!(of(&[0.5, 0.1, 0.3, 0.6]) > of(&[0.5, 0.1, 0.3, 0.5]));
        assert!(of(&[0.2, 0.2]) > of(&[0.1, 0.9]));
        assert_eq!(of(&[0.9, f64::NAN]), f64::NEG_INFINITY);
        assert_eq!(of(&[f64::NAN]), f64::NEG_INFINITY);
    }
}
