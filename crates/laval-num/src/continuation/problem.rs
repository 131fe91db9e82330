//! The face every family of solutions shows to Newton's method and to continuation.

use crate::dense::Mat;
use std::fmt;

/// Why a problem could not be evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The equations mean nothing here (outside a law's domain, a closed gap, an inner solve without result).
    Undefined(&'static str),
    /// The user stopped it.
    Cancelled,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Undefined(why) => write!(f, "the equations are not defined here: {why}"),
            Failure::Cancelled => f.write_str("cancelled"),
        }
    }
}
impl std::error::Error for Failure {}

/// Equations `r(x, p) = 0`: as many equations as unknowns `x`, and one real parameter `p`.
///
/// Stationary states, harmonic balance, shooting and collocation implement this; Newton, continuation, events and folds see nothing
/// else. Everything is in the problem's own units; `scale` and `parameter_scale` give the sizes that make them comparable.
pub trait Zero {
    /// Number of unknowns and of equations.
    fn dim(&self) -> usize;

    /// Typical size of each unknown, positive, constant along a branch. Steps and errors are measured in these.
    fn scale(&self, out: &mut [f64]);

    /// Typical size of the parameter, positive: a change by it weighs as much as a change of one unknown by its scale.
    fn parameter_scale(&self) -> f64;

    /// Residual `r` and, where requested, exact `jac[(i, j)]` = dr_i/dx_j and `dr_dp[i]` = dr_i/dp. All arrive filled with zeros.
    /// Equations need no scaling: they are weighed by the rows of the scaled Jacobian.
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) -> Result<(), Failure>;

    /// Number of monitored quantities: things other than `x` that a branch must resolve (displacements of bodies at each order,
    /// where `x` holds only the condensed coordinates). A whole number of [`Zero::monitor_width`].
    fn monitors(&self) -> usize {
        0
    }

    /// How many consecutive monitored quantities form one vector whose change is taken relative to its own length
    /// (2: real and imaginary part).
    fn monitor_width(&self) -> usize {
        1
    }

    /// For each vector of monitored quantities the length below which its changes are absolute, not relative; positive.
    fn monitor_scale(&self, out: &mut [f64]) {
        out.fill(1.0);
    }

    /// Monitored quantities at a point (cheap: it is called twice for every point of a branch).
    fn measure(&mut self, _x: &[f64], _p: f64, _out: &mut [f64]) -> Result<(), Failure> {
        Ok(())
    }

    /// Largest step of the parameter allowed at this point. [`resonance_cap`] gives one for a linear mode.
    fn max_parameter_step(&mut self, _x: &[f64], _p: f64) -> f64 {
        f64::INFINITY
    }

    /// Whether to stop; requested once per Newton iteration.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Largest parameter step at `p` that cannot pass over a resonance at `centre` with half width `half_width`: a quarter of the distance
/// to it, and no less than a quarter of its half width. The least of it over all modes is a good [`Zero::max_parameter_step`].
pub fn resonance_cap(p: f64, centre: f64, half_width: f64) -> f64 {
    0.25 * (p - centre).hypot(half_width)
}
