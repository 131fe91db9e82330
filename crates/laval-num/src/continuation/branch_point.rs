//! Branch points by the minimally augmented system
//!
//! `r(x, p) + s b = 0, g_1 = 0, g_2 = 0` with `g` from `[B b; C 0] [V; g] = [0; 1]`, B = [dr/dx dr/dp],
//!
//! which is regular where two branches cross transversally and at a pitchfork, for rows of `C` near the two null vectors of B and `b` near its left null
//! vector ([`super::augmented`]). At a branch point `s` vanishes; where two branches pass each other without crossing it does not.
//!
//! Sources: A. Griewank, G. W. Reddien, SIAM J. Numer. Anal. 21 (1984) 176; G. Moore, Numer. Funct. Anal. Optim. 2 (1980) 441.

use super::augmented::Augmented;
use super::step::{Node, Tracer, distance, heading};
use crate::dense::{dot, norm};
use serde::{Deserialize, Serialize};

/// A branch point from its extended system.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BranchPoint {
    /// Parameter.
    pub p: f64,
    /// Unknowns.
    pub x: Vec<f64>,
    /// Largest scaled residual of the extended system.
    pub residual: f64,
    /// Newton step that would follow, relative to the scales.
    pub error: f64,
    /// Largest error of the parameter that steps of this size stand for.
    pub p_error: f64,
}

/// Largest scaled residual that is left where the branches meet.
const MEETING: f64 = 1e-9;
/// Steps of Newton's method at rounding level that the error of the parameter may be.
const STEPS: f64 = 10.0;
/// Share of the step within which the branch point must lie from where the determinant vanishes.
const NEAR: f64 = 0.1;

impl Tracer<'_> {
    /// The branch point near a node where the determinant vanishes between two others, and the node there; `None` where there is none.
    pub(super) fn branch_point(&mut self, a: &Node, b: &Node, near: &Node) -> Option<(BranchPoint, Node)> {
        let n = self.n();
        let (second, left) = self.second_null_vectors(near)?;
        let length = norm(&near.t);
        let first: Vec<f64> = near.t.iter().map(|t| t / length).collect();
        let mut y = near.y.clone();
        y.push(0.0);
        let mut system = Augmented::new(&mut *self.problem, &self.scale, &near.y, vec![first, second], |_| left).ok()??;
        let done = system.solve(&mut y).ok()?;
        let tangents = system.tangents(&y);
        let apart = y.pop()?;
        let h = distance(&a.y, &b.y);
        let strayed = distance(&y, &near.y);
        if !(apart.abs() <= MEETING) || !(strayed <= NEAR * h) {
            return None;
        }
        let along = a.y.iter().zip(&b.y).zip(&y).map(|((a, b), y)| (b - a) * (y - a)).sum::<f64>() / h;
        let p = y[n] * self.scale[n];
        let mut node = Node { s: a.s + along.clamp(0.0, h), p, y: y.clone(), ..near.clone() };
        // the tangent found there by the way is lost in rounding: of the two directions that of this branch
        let way = heading(a, b, h, (along / h).clamp(0.0, 1.0));
        let own = tangents.into_iter().flatten().max_by(|s, t| dot(s, &way).abs().total_cmp(&dot(t, &way).abs()));
        if let Some(mut t) = own {
            let sign = dot(&t, &way).signum();
            t.iter_mut().for_each(|t| *t *= sign);
            node.t = t;
        }
        let x = y[..n].iter().zip(&self.scale).map(|(y, s)| y * s).collect();
        let size = y.iter().fold(1.0, |m: f64, y| m.max(y.abs()));
        let p_error = STEPS * done.step * size * self.scale[n] + 16.0 * f64::EPSILON * p.abs();
        Some((BranchPoint { p, x, residual: done.residual, error: done.step, p_error }, node))
    }
}
