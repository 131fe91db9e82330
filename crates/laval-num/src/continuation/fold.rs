//! Folds by the minimally augmented system
//!
//! `r(x, p) = 0, g(x, p) = 0` with `g` from `[A b; c' 0] [v; g] = [0; 1]`, A = dr/dx,
//!
//! which is regular at a simple fold for `c` near the null vector and `b` = dr/dp ([`super::augmented`]).

use super::augmented::Augmented;
use super::problem::Zero;
use super::step::distance;
use crate::dense::{Mat, dot, norm};
use crate::newton::{Cause, NotConverged};
use serde::{Deserialize, Serialize};

/// A fold from the extended system.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FoldPoint {
    /// Parameter.
    pub p: f64,
    /// Unknowns.
    pub x: Vec<f64>,
    /// Null vector of the Jacobian, of unit length in scaled unknowns, in the problem's own units.
    pub null_vector: Vec<f64>,
    /// Largest scaled residual of the extended system.
    pub residual: f64,
    /// Newton step that would follow, relative to the scales.
    pub error: f64,
    /// This parameter minus that of the start.
    pub p_difference: f64,
    /// Change of the parameter that stands for one rounding of the equations: large beside a branch point.
    pub p_error: f64,
    /// Scaled distance of the unknowns from the start.
    pub x_difference: f64,
}

/// Solves for the simple fold near `(x, p)`; `null_vector` is a guess of the Jacobian's null vector (dx/ds of a nearby point serves).
///
/// Fails where the null space has more than one dimension (two planes of an isotropic machine folding together) and where dr/dp lies
/// in the range of the Jacobian (branch points).
pub fn fold(problem: &mut dyn Zero, x: &[f64], p: f64, null_vector: &[f64]) -> Result<FoldPoint, NotConverged> {
    let n = problem.dim();
    assert!(x.len() == n && null_vector.len() == n, "length of the start differs from the number of unknowns");
    let mut scale = vec![1.0; n + 1];
    problem.scale(&mut scale[..n]);
    scale[n] = problem.parameter_scale();
    let mut y: Vec<f64> = x.iter().chain([&p]).zip(&scale).map(|(x, s)| x / s).collect();
    let lost = |cause| NotConverged { cause, iterations: 0, residual: f64::NAN, step: f64::NAN };

    let mut c: Vec<f64> = null_vector.iter().zip(&scale).map(|(v, s)| v / s).collect();
    if !unit(&mut c) {
        return Err(lost(Cause::Singular));
    }
    let start = y.clone();
    let b = |jacobian: &Mat| {
        let mut b: Vec<f64> = (0..n).map(|i| jacobian[(i, n)]).collect();
        unit(&mut b);
        b
    };
    let system = Augmented::new(problem, &scale, &y, vec![c.clone()], b).map_err(|f| lost(f.into()))?;
    let mut system = system.ok_or_else(|| lost(Cause::Singular))?;
    let done = system.solve(&mut y)?;
    system.null_vectors(&y).map_err(|f| lost(f.into()))?;
    let p_error = system.resolution(&y) * scale[n];
    let v = &system.v[0][..n];
    let length = norm(v) * dot(v, &c).signum();
    Ok(FoldPoint {
        p: y[n] * scale[n],
        x: y[..n].iter().zip(&scale).map(|(y, s)| y * s).collect(),
        null_vector: v.iter().zip(&scale).map(|(v, s)| v / length * s).collect(),
        residual: done.residual,
        error: done.step,
        p_difference: (y[n] - start[n]) * scale[n],
        p_error,
        x_difference: distance(&y[..n], &start[..n]),
    })
}

/// Brings a vector to unit length; false where it has none.
fn unit(v: &mut [f64]) -> bool {
    let length = norm(v);
    v.iter_mut().for_each(|v| *v /= length);
    length > 0.0 && length.is_finite()
}
