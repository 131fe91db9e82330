//! Whether a motion repeats, assessed by its Poincare points: the states at every whole forcing period.
//!
//! With lags of about a third of the record, `d1` and `d2` are the largest differences between points of the first and second, and of the second
//! and third part. What is still to come is `d2 f`, where f is the larger of `1/(1 - exp(-a L T))`, for the slowest decay rate a that is known, and
//! `1/(1 - d2/d1)`, as measured: near a fold a motion settles more slowly than the machine does at rest.

use super::Rules;
use crate::study::shared::support::largest;

/// Longest period looked for, in forcing periods.
pub const LONGEST: usize = 16;
/// Fewest periods of a record: three lags of the longest period.
pub const FEWEST: usize = 3 * LONGEST;
/// Change over a third of the record, over the size of the motion, above which a motion that does not repeat is called so even where the
/// settling was cut short.
const CLEAR: f64 = 1e-2;
/// Tolerances by which points must differ from turn to turn before their motion is called subharmonic, and by which they must change before it is
/// called one that does not repeat: smaller differences are settling that is not over.
const SUBHARMONIC: f64 = 10.0;
const CHANGING: f64 = 100.0;
/// Size of a motion over typical sizes below which its changes are assessed as if it were that large.
const SMALLEST: f64 = 1e-3;

/// What a motion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Repeats after so many forcing periods.
    Period(usize),
    /// Does not repeat: quasi-periodic, chaotic, or of a longer period.
    NotPeriodic,
    /// Still changes slowly where the settling was cut short.
    NotConverged,
    /// Could not be followed, and why.
    Failed(&'static str),
}

impl Verdict {
    /// The word of tables and findings.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Period(_) => "periodic",
            Verdict::NotPeriodic => "not periodic",
            Verdict::NotConverged => "not settled",
            Verdict::Failed(_) => "failed",
        }
    }
}

/// An assessment and the estimated distance from the limit over the size of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assessment {
    pub verdict: Verdict,
    pub remaining: f64,
}

/// Poincare points of a record.
#[derive(Clone, Debug)]
pub struct Sections {
    size: Vec<f64>,
    rest: Vec<f64>,
    points: Vec<Vec<f64>>,
}

impl Sections {
    pub fn new(size: &[f64], rest: &[f64]) -> Self {
        Sections { size: size.to_vec(), rest: rest.to_vec(), points: vec![] }
    }
    pub fn clear(&mut self) {
        self.points.clear();
    }
    pub fn push(&mut self, y: &[f64]) {
        self.points.push(y.to_vec());
    }
    /// The last points, oldest first.
    pub fn last(&self, count: usize) -> Vec<Vec<f64>> {
        self.points[self.points.len().saturating_sub(count)..].to_vec()
    }
    /// Coordinates at rest.
    pub fn rest(&self) -> &[f64] {
        &self.rest
    }
    /// Largest difference of two states over typical sizes; NaN stays.
    pub fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        largest(a.iter().zip(b).zip(&self.size).map(|((a, b), s)| (a - b).abs() / s))
    }
    /// Size of the motion over typical sizes.
    pub fn amplitude(&self) -> f64 {
        let centre: Vec<f64> = (0..self.size.len()).map(|i| self.rest.get(i).copied().unwrap_or(0.0)).collect();
        let own = largest(self.points.iter().map(|p| self.apart(p, &centre)));
        if own <= SMALLEST { SMALLEST } else { own }
    }
    fn drift(&self, from: usize, lag: usize) -> f64 {
        let pairs = (from..from + lag).filter(|&j| j + lag < self.points.len());
        largest(pairs.map(|j| self.apart(&self.points[j], &self.points[j + lag])))
    }
    /// Change from one point to the k-th after it, at the end of the record.
    pub fn change(&self, k: usize) -> f64 {
        self.drift(self.points.len().saturating_sub(2 * k), k)
    }
    /// Number of periods the record is taken over.
    pub fn period_of(&self, verdict: &Verdict) -> usize {
        if let Verdict::Period(k) = verdict { *k } else { self.points.len().saturating_sub(1) }
    }

    /// Assesses the record. `known` says that the orbit was found by shooting: then the points need only repeat. `rate` is the slowest decay rate,
    /// `bounded` that the settling was cut short.
    pub fn assess(&self, rules: &Rules, rate: Option<f64>, known: bool, period: f64, bounded: bool) -> Assessment {
        let size = self.amplitude();
        let noise = 100.0 * rules.relative * size;
        let third = (self.points.len().saturating_sub(1)) / 3;
        let turn = largest((third..self.points.len().saturating_sub(1)).map(|j| self.apart(&self.points[j], &self.points[j + 1])));
        let mut first = None;
        for k in 1..=LONGEST {
            let lag = k * (third / k).max(1);
            let (d1, d2) = (self.drift(0, lag), self.drift(lag, lag));
            // a lag may be a multiple of the period without k being one
            let once = largest((third..self.points.len().saturating_sub(k)).map(|j| self.apart(&self.points[j], &self.points[j + k])));
            let still = if known {
                d2
            } else {
                let decay = rate.map_or(1.0, |a| -1.0 / (-a * lag as f64 * period).exp_m1());
                let measured = match () {
                    () if d2 <= noise => 1.0,
                    () if d2 < d1 => 1.0 / (1.0 - d2 / d1),
                    () => f64::INFINITY,
                };
                d2 * decay.max(measured)
            };
            let assessment = (still / size, d2 / size);
            let clear = k == 1 || turn > SUBHARMONIC * rules.tolerance * size;
            if assessment.0 <= rules.tolerance && once <= rules.tolerance * size && clear {
                return Assessment { verdict: Verdict::Period(k), remaining: assessment.0 };
            }
            first = first.or(Some(assessment));
        }
        let (remaining, change) = first.unwrap_or((f64::NAN, f64::NAN));
        let small = if bounded { CLEAR } else { CHANGING * rules.tolerance };
        let verdict = if change < small { Verdict::NotConverged } else { Verdict::NotPeriodic };
        Assessment { verdict, remaining: if remaining.is_finite() { remaining } else { f64::NAN } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::motion::trajectory::Choice;

    fn rules() -> Rules {
        Rules {
            method: Choice::Auto,
            relative: 1e-12,
            absolute: 1e-12,
            tolerance: 1e-6,
            most_periods: 100,
            periods: 64,
            shooting: false,
            spectrum: None,
        }
    }

    fn assessment(f: impl Fn(f64) -> f64, rate: Option<f64>, bounded: bool) -> Assessment {
        let mut s = Sections::new(&[1.0], &[0.0]);
        (0..=64).for_each(|j| s.push(&[f(f64::from(j))]));
        s.assess(&rules(), rate, false, 1.0, bounded)
    }

    #[test]
    fn periods_are_the_shortest_that_repeat() {
        for k in [1usize, 2, 3, 5, 6, 8, 11, 16] {
            let j = assessment(|j| 2.0 + (std::f64::consts::TAU * j / k as f64).cos(), None, false);
            assert_eq!(j.verdict, Verdict::Period(k));
        }
    }

    #[test]
    fn what_is_still_to_come_is_estimated() {
        // geometric: the distance left after the record is exp(-0.05 * 63) times the first
        let (rate, left) = (0.05, 1e-3 * (-0.05f64 * 64.0).exp());
        let decaying = |size: f64| assessment(move |j| 1.0 + size * (-rate * j).exp(), None, true);
        let j = decaying(1e-3);
        assert_eq!(j.verdict, Verdict::NotConverged);
        // the estimate holds for the point a third of a record before the last
        assert!(j.remaining > left && j.remaining < 10.0 * left, "{} {left}", j.remaining);
        assert_eq!(decaying(1e-6).verdict, Verdict::Period(1));
        // a slow mode that the record alone would not show
        let slow = |known| assessment(|j| 1.0 + 1e-4 * (-1e-5 * j).exp(), known, true).verdict;
        assert_eq!(slow(Some(1e-5)), Verdict::NotConverged);
    }

    /// A slowly decaying beat repeats after nine turns as well as it repeats at all: no subharmonic.
    #[test]
    fn settling_is_no_subharmonic() {
        let beat = |size: f64| assessment(move |j| 1.0 + size * (std::f64::consts::TAU * j / 9.0).cos(), None, false).verdict;
        assert_eq!((beat(3e-6), beat(1e-4), beat(1e-11)), (Verdict::NotConverged, Verdict::Period(9), Verdict::Period(1)));
    }

    #[test]
    fn what_never_repeats_is_not_periodic_and_no_number_passes() {
        assert_eq!(assessment(|j| (2.0 * j).cos(), None, false).verdict, Verdict::NotPeriodic);
        assert_eq!(assessment(|j| (2.0 * j).cos(), None, true).verdict, Verdict::NotPeriodic);
        assert!(!matches!(assessment(|j| if j == 40.0 { f64::NAN } else { 1.0 }, None, false).verdict, Verdict::Period(_)));
    }
}
