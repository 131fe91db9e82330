//! Which settled motions are the same: their Poincare sets agree.
//!
//! Two motions of period k are one attractor when the states of one at k successive phases zero are those of the other, begun at some of its points,
//! within `AGREE` times the settling tolerance over the size of the larger motion. Each motion is compared with the first of its kind: of two
//! motions on one attractor each is at most one tolerance from it.

use crate::study::shared::support::largest;
use serde::{Deserialize, Serialize};

/// Distance that counts as agreement, over the settling tolerance.
pub(super) const AGREE: f64 = 10.0;
/// Size of a motion over typical sizes below which its changes are assessed as if it were that large.
const SMALLEST: f64 = 1e-3;

/// A settled motion.
#[derive(Clone, Debug, Default)]
pub(super) struct Motion {
    /// States at phase zero over one period, oldest first; empty when it does not repeat.
    pub orbit: Vec<Vec<f64>>,
    /// It goes on for ever without repeating.
    pub irregular: bool,
    /// Estimated distance from the limit over its size.
    pub remaining: f64,
    /// Largest displacement of the first body, by which attractors are ordered.
    pub amplitude: f64,
}

/// Motions that are the same.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attractor {
    /// Forcing periods after which it repeats; none for all motions that do not repeat.
    pub period: Option<usize>,
    /// Motions, in order.
    pub members: Vec<usize>,
    /// The motion that is nearest to its limit.
    pub best: usize,
    /// Largest distance of a motion from the first over its size.
    pub spread: f64,
}

/// What the motions are, in order of amplitude, with those that do not repeat last; and to which each belongs, none where it has no limit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AttractorSet {
    /// By amplitude.
    pub attractors: Vec<Attractor>,
    /// Of every motion, the attractor it belongs to.
    pub of: Vec<Option<usize>>,
    /// Smallest distance of two attractors of one period over the size of the larger.
    pub gap: Option<f64>,
}

/// How far apart motions are.
pub(super) struct Ruler<'a> {
    /// Typical sizes of the states.
    pub sizes: &'a [f64],
    /// Coordinates at rest.
    pub rest: &'a [f64],
    /// Settling tolerance.
    pub tolerance: f64,
}

impl Ruler<'_> {
    fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        largest(a.iter().zip(b).zip(self.sizes).map(|((a, b), s)| (a - b).abs() / s))
    }

    fn size(&self, orbit: &[Vec<f64>]) -> f64 {
        let from_rest =
            |y: &Vec<f64>| largest(y.iter().enumerate().map(|(i, y)| (y - self.rest.get(i).unwrap_or(&0.0)).abs() / self.sizes[i]));
        largest(orbit.iter().map(from_rest).chain([SMALLEST]))
    }

    /// Distance of two orbits of one period over the size of the larger, at the phase at which they are nearest; infinite when they differ in period.
    fn distance(&self, a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
        if a.len() != b.len() || a.is_empty() {
            return f64::INFINITY;
        }
        let size = self.size(a).max(self.size(b));
        let begun_at = |shift: usize| largest((0..a.len()).map(|p| self.apart(&a[p], &b[(p + shift) % b.len()])));
        (0..b.len()).map(begun_at).filter(|d| !d.is_nan()).fold(f64::INFINITY, f64::min) / size
    }

    /// Sorts the motions.
    pub fn sort(&self, motions: &[Motion]) -> AttractorSet {
        let mut found: Vec<Attractor> = Vec::new();
        for (i, m) in motions.iter().enumerate() {
            if m.orbit.is_empty() && !m.irregular {
                continue;
            }
            let period = (!m.irregular).then_some(m.orbit.len());
            let near = |a: &Attractor| {
                let d = if m.irregular { 0.0 } else { self.distance(&motions[a.members[0]].orbit, &m.orbit) };
                (a.period == period && d <= AGREE * self.tolerance).then_some(d)
            };
            match found.iter_mut().find_map(|a| near(a).map(|d| (a, d))) {
                Some((a, d)) => {
                    a.members.push(i);
                    a.spread = a.spread.max(d);
                    if m.remaining < motions[a.best].remaining || motions[a.best].remaining.is_nan() {
                        a.best = i;
                    }
                }
                None => found.push(Attractor { period, members: vec![i], best: i, spread: 0.0 }),
            }
        }
        let height = |a: &Attractor| motions[a.best].amplitude;
        found.sort_by(|a, b| {
            let last = a.period.is_none().cmp(&b.period.is_none());
            last.then(height(a).total_cmp(&height(b))).then(a.period.cmp(&b.period)).then(a.members[0].cmp(&b.members[0]))
        });
        let mut of = vec![None; motions.len()];
        for (k, a) in found.iter().enumerate() {
            a.members.iter().for_each(|&i| of[i] = Some(k));
        }
        let pairs = found.iter().enumerate().flat_map(|(k, a)| found[..k].iter().map(move |b| (a, b)));
        let distances = pairs.map(|(a, b)| self.distance(&motions[a.best].orbit, &motions[b.best].orbit));
        let gap = distances.filter(|d| d.is_finite()).min_by(f64::total_cmp);
        AttractorSet { attractors: found, of, gap }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(points: &[f64], remaining: f64) -> Motion {
        let amplitude = points.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        Motion { orbit: points.iter().map(|x| vec![*x]).collect(), irregular: false, remaining, amplitude }
    }

    fn sorted(motions: &[Motion]) -> (Vec<Option<usize>>, Vec<usize>) {
        let found = Ruler { sizes: &[1.0], rest: &[0.0], tolerance: 1e-6 }.sort(motions);
        (found.of, found.attractors.iter().map(|a| a.best).collect())
    }

    #[test]
    fn orbits_are_the_same_from_whichever_point_they_begin() {
        let (of, best) = sorted(&[
            motion(&[2.0, -1.0, 0.5], 1e-7),
            motion(&[1.0], 1e-7),
            motion(&[-1.0, 0.5, 2.0 + 1e-6], 1e-9),
            // the same points in another order are another motion
            motion(&[0.5, -1.0, 2.0], 1e-7),
            motion(&[1.0 + 1e-4], 1e-7),
        ]);
        assert_eq!((of[0], of[0] == of[3]), (of[2], false));
        assert_eq!((of[1], of[4]), (Some(0), Some(1)));
        assert!(best.contains(&2) && !best.contains(&0));
    }

    #[test]
    fn what_has_no_limit_belongs_to_none_and_no_number_agrees() {
        let (of, _) = sorted(&[Motion::default(), motion(&[f64::NAN], 1e-7), motion(&[1.0], 1e-7), motion(&[f64::NAN], 1e-7)]);
        assert_eq!(of[0], None);
        assert!(of[1] != of[2] && of[1] != of[3]);
    }
}
