//! Limits and tolerances of a continuation.

use crate::newton;
use std::fmt;

/// How far and how finely a branch is followed. Lengths are in scaled unknowns and parameter (see [`super::Zero::scale`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Range of the parameter; a branch that leaves it ends exactly on its edge.
    pub range: (f64, f64),
    /// First step of the arclength.
    pub first_step: f64,
    /// The step that is too small to go on with.
    pub min_step: f64,
    /// Largest step, relative to the length of the scaled unknowns where that exceeds one.
    pub max_step: f64,
    /// Largest step of the parameter, in its own unit.
    pub max_parameter_step: f64,
    /// Most points.
    pub max_points: usize,
    /// Smallest cosine of the angle between successive tangents, and between tangent and chord.
    pub min_cosine: f64,
    /// Largest change of a monitored vector per step, relative to its length or scale. A complex resonance then gets about ten points
    /// within its half-power width.
    pub monitor_change: f64,
    /// Contraction of Newton's method that step control aims at.
    pub target_rate: f64,
    /// Corrector. Its `damped` and `to_rounding` are ignored.
    pub corrector: newton::Options,
}

impl Settings {
    /// Usual values for a range of the parameter: at least 50 steps over the range.
    pub fn new(lo: f64, hi: f64) -> Self {
        Settings {
            range: (lo, hi),
            first_step: 1e-2,
            min_step: 1e-10,
            max_step: 0.5,
            max_parameter_step: (hi - lo) / 50.0,
            max_points: 20_000,
            min_cosine: 0.985,
            monitor_change: 0.15,
            target_rate: 0.1,
            corrector: newton::Options { max_iterations: 8, damped: false, ..newton::Options::default() },
        }
    }

    pub(super) fn check(&self) -> Result<(), Invalid> {
        let positive = |v: f64| v > 0.0 && !v.is_nan();
        let (lo, hi) = self.range;
        let rules = [
            (lo.is_finite() && hi.is_finite() && lo < hi, "the range of the parameter must be finite and not empty"),
            (positive(self.first_step) && self.first_step.is_finite(), "the first step must be positive"),
            (positive(self.min_step) && self.min_step <= self.first_step, "the smallest step must be positive and not above the first"),
            (self.max_step >= self.first_step, "the largest step must not be below the first"),
            (positive(self.max_parameter_step), "the largest parameter step must be positive"),
            (self.min_cosine > 0.0 && self.min_cosine < 1.0, "the smallest cosine must lie between 0 and 1"),
            (positive(self.monitor_change), "the largest change of monitored quantities must be positive"),
            (self.target_rate > 0.0 && self.target_rate < 1.0, "the target rate must lie between 0 and 1"),
        ];
        rules.iter().find(|(ok, _)| !ok).map_or(Ok(()), |(_, why)| Err(Invalid(why)))
    }
}

/// A request that makes no sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Invalid(pub &'static str);

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}
impl std::error::Error for Invalid {}
