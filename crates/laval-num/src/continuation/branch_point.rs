//! Branch points by the minimally augmented system
//!
//! `r(x, p) + s b = 0, g_1 = 0, g_2 = 0` with `g` from `[B b; C 0] [V; g] = [0; 1]`, B = [dr/dx dr/dp],
//!
//! which is regular where two branches cross transversally and at a pitchfork, for rows of `C` near the two null vectors of B and `b` near its left null
//! vector. Its derivative is `-u' dB V_k`, with the second derivative of `r` along `V_k` by central differences of the exact Jacobian, as for
//! [folds](super::fold). At a branch point `s` vanishes; where two branches pass each other without crossing it does not.
//!
//! Sources: A. Griewank, G. W. Reddien, SIAM J. Numer. Anal. 21 (1984) 176; G. Moore, Numer. Funct. Anal. Optim. 2 (1980) 441.

use super::problem::{Failure, Zero};
use super::step::{Node, Scratch, Tracer, distance, extended, resized};
use crate::dense::{Lu, Mat, Singular, norm};
use crate::newton::{Options, Solver, System};

/// A branch point from its extended system.
#[derive(Clone, Debug, PartialEq)]
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

struct Augmented<'a, P: ?Sized> {
    problem: &'a mut P,
    scale: &'a [f64],
    weight: Vec<f64>,
    b: Vec<f64>,
    c: [Vec<f64>; 2],
    v: [Vec<f64>; 2],
    u: Vec<f64>,
    bordered: Mat,
    lu: Lu,
    full: Mat,
    plus: Mat,
    scratch: Scratch,
}

impl<P: Zero + ?Sized> Augmented<'_, P> {
    /// Fills `bordered` from `full`, and `v` with (null vectors, g); with `left`, `u` too.
    fn borders(&mut self, left: bool) -> Result<(), Singular> {
        let n = self.scale.len() - 1;
        self.bordered.reset(n + 2, n + 2);
        for i in 0..n {
            for j in 0..=n {
                self.bordered[(i, j)] = self.full[(i, j)] / self.weight[i];
            }
            self.bordered[(i, n + 1)] = self.b[i];
        }
        for (k, c) in self.c.iter().enumerate() {
            self.bordered.row_mut(n + k)[..=n].copy_from_slice(c);
        }
        self.lu.factor(&self.bordered)?;
        for (k, v) in self.v.iter_mut().enumerate() {
            resized(v, n + 2)[n + k] = 1.0;
            self.lu.solve(v);
        }
        if left {
            self.lu.factor(&self.bordered.transpose())?;
            resized(&mut self.u, n + 2)[n + 1] = 1.0;
            self.lu.solve(&mut self.u);
        }
        Ok(())
    }
}

const SINGULAR: Failure = Failure::Undefined("the bordered Jacobian is singular: not a simple branch point");

impl<P: Zero + ?Sized> System for Augmented<'_, P> {
    fn size(&self) -> usize {
        self.scale.len() + 1
    }
    fn eval(&mut self, y: &[f64], r: &mut [f64], jac: Option<&mut Mat>) -> Result<(), Failure> {
        let n = self.scale.len() - 1;
        let own = &y[..=n];
        self.full.reset(n + 1, n + 1);
        extended(self.problem, self.scale, own, &mut self.scratch, r, Some(&mut self.full))?;
        self.borders(jac.is_some()).map_err(|_| SINGULAR)?;
        for i in 0..n {
            r[i] += y[n + 1] * self.b[i] * self.weight[i];
        }
        (r[n], r[n + 1]) = (self.v[0][n + 1], self.v[1][n + 1]);
        let Some(jac) = jac else { return Ok(()) };
        for i in 0..n {
            jac.row_mut(i)[..=n].copy_from_slice(&self.full.row(i)[..=n]);
            jac[(i, n + 1)] = self.b[i] * self.weight[i];
        }
        let mut waste = vec![0.0; n];
        for k in 0..2 {
            // cube root of the rounding unit: the best of a central difference
            let h = 6e-6 * norm(own).max(1.0) / norm(&self.v[k][..=n]);
            let shift = |h: f64, v: &[f64]| own.iter().zip(v).map(|(y, v)| y + h * v).collect::<Vec<_>>();
            let (ahead, behind) = (shift(h, &self.v[k]), shift(-h, &self.v[k]));
            for (place, out) in [(&ahead, &mut self.plus), (&behind, &mut self.full)] {
                out.reset(n + 1, n + 1);
                waste.fill(0.0);
                extended(self.problem, self.scale, place, &mut self.scratch, &mut waste, Some(out))?;
            }
            for j in 0..=n {
                let change = (0..n).map(|i| self.u[i] / self.weight[i] * (self.plus[(i, j)] - self.full[(i, j)])).sum::<f64>();
                jac[(n + k, j)] = -change / (2.0 * h);
            }
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.problem.cancelled()
    }
}

impl<P: Zero + ?Sized> Tracer<'_, P> {
    /// The branch point near a node where the determinant vanishes between two others, and the node there; `None` where there is none.
    pub(super) fn branch_point(&mut self, a: &Node, b: &Node, near: &Node) -> Option<(BranchPoint, Node)> {
        let n = self.n();
        let (second, left) = self.second_null_vectors(near)?;
        let length = norm(&near.t);
        let first: Vec<f64> = near.t.iter().map(|t| t / length).collect();
        let (mut scratch, mut full, mut r) = (Scratch::default(), Mat::zeros(n + 1, n + 1), vec![0.0; n]);
        extended(self.problem, &self.scale, &near.y, &mut scratch, &mut r, Some(&mut full)).ok()?;
        let weight: Vec<f64> = (0..n).map(|i| norm(full.row(i))).collect();
        if weight.iter().any(|w| !(*w > 0.0 && w.is_finite())) {
            return None;
        }
        let mut system = Augmented {
            problem: &mut *self.problem,
            scale: &self.scale,
            weight,
            b: left,
            c: [first, second],
            v: [Vec::new(), Vec::new()],
            u: Vec::new(),
            bordered: Mat::default(),
            lu: Lu::default(),
            full,
            plus: Mat::default(),
            scratch,
        };
        let mut y = near.y.clone();
        y.push(0.0);
        let options = Options { to_rounding: true, noise: 1e-13, ..Options::default() };
        let done = Solver::default().solve(&mut system, &mut y, &options).ok()?;
        let apart = y.pop()?;
        let h = distance(&a.y, &b.y);
        let strayed = distance(&y, &near.y);
        if !(apart.abs() <= MEETING) || !(strayed <= NEAR * h) {
            return None;
        }
        let along = a.y.iter().zip(&b.y).zip(&y).map(|((a, b), y)| (b - a) * (y - a)).sum::<f64>() / h;
        let p = y[n] * self.scale[n];
        let node = Node { s: a.s + along.clamp(0.0, h), p, y: y.clone(), ..near.clone() };
        let x = y[..n].iter().zip(&self.scale).map(|(y, s)| y * s).collect();
        let size = y.iter().fold(1.0, |m: f64, y| m.max(y.abs()));
        let p_error = STEPS * done.step * size * self.scale[n] + 16.0 * f64::EPSILON * p.abs();
        Some((BranchPoint { p, x, residual: done.residual, error: done.step, p_error }, node))
    }
}
