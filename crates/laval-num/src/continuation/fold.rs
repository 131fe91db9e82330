//! Folds by the minimally augmented system
//!
//! `r(x, p) = 0, g(x, p) = 0` with `g` from `[A b; c' 0] [v; g] = [0; 1]`, A = dr/dx,
//!
//! which is regular at a simple fold for `c` near the null vector and `b` = dr/dp. Its derivative is `-u' dA v`, `u` from the transposed
//! system, with the second derivative of `r` along `v` by central differences of the exact Jacobian. That difference affects the speed
//! of Newton's method only: the point where `g` vanishes is as exact as the Jacobian.

use super::problem::{Failure, Zero};
use super::step::{Scratch, distance, extended, resized};
use crate::dense::{Lu, Mat, Singular, dot, norm};
use crate::newton::{Cause, NotConverged, Options, Solver, System};

/// A fold from the extended system.
#[derive(Clone, Debug, PartialEq)]
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
    /// Scaled distance of the unknowns from the start.
    pub x_difference: f64,
}

struct Augmented<'a, P: ?Sized> {
    problem: &'a mut P,
    scale: &'a [f64],
    weight: Vec<f64>,
    b: Vec<f64>,
    c: Vec<f64>,
    v: Vec<f64>,
    u: Vec<f64>,
    bordered: Mat,
    lu: Lu,
    full: Mat,
    plus: Mat,
    scratch: Scratch,
}

impl<P: Zero + ?Sized> Augmented<'_, P> {
    /// Fills `bordered` from `full`, and `v` with (null vector, g); with `left`, `u` too.
    fn borders(&mut self, left: bool) -> Result<(), Singular> {
        let n = self.scale.len() - 1;
        self.bordered.reset(n + 1, n + 1);
        for i in 0..n {
            for j in 0..n {
                self.bordered[(i, j)] = self.full[(i, j)] / self.weight[i];
            }
            self.bordered[(i, n)] = self.b[i];
            self.bordered[(n, i)] = self.c[i];
        }
        self.lu.factor(&self.bordered)?;
        resized(&mut self.v, n + 1)[n] = 1.0;
        self.lu.solve(&mut self.v);
        if left {
            self.lu.factor(&self.bordered.transpose())?;
            resized(&mut self.u, n + 1)[n] = 1.0;
            self.lu.solve(&mut self.u);
        }
        Ok(())
    }
}

const SINGULAR: Failure = Failure::Undefined("the bordered Jacobian is singular: not a simple fold");

impl<P: Zero + ?Sized> System for Augmented<'_, P> {
    fn size(&self) -> usize {
        self.scale.len()
    }
    fn eval(&mut self, y: &[f64], r: &mut [f64], jac: Option<&mut Mat>) -> Result<(), Failure> {
        let n = self.scale.len() - 1;
        self.full.reset(n + 1, n + 1);
        extended(self.problem, self.scale, y, &mut self.scratch, r, Some(&mut self.full))?;
        self.borders(jac.is_some()).map_err(|_| SINGULAR)?;
        r[n] = self.v[n];
        let Some(jac) = jac else { return Ok(()) };
        jac.copy_from(&self.full);
        // cube root of the rounding unit: the best of a central difference
        let h = 6e-6 * norm(y).max(1.0) / norm(&self.v[..n]);
        let mut waste = vec![0.0; n];
        let shift = |h: f64, v: &[f64]| y.iter().enumerate().map(|(i, y)| if i < n { y + h * v[i] } else { *y }).collect::<Vec<_>>();
        self.plus.reset(n + 1, n + 1);
        extended(self.problem, self.scale, &shift(h, &self.v), &mut self.scratch, &mut waste, Some(&mut self.plus))?;
        self.full.reset(n + 1, n + 1);
        waste.fill(0.0);
        extended(self.problem, self.scale, &shift(-h, &self.v), &mut self.scratch, &mut waste, Some(&mut self.full))?;
        for j in 0..=n {
            jac[(n, j)] = -(0..n).map(|i| self.u[i] / self.weight[i] * (self.plus[(i, j)] - self.full[(i, j)])).sum::<f64>() / (2.0 * h);
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.problem.cancelled()
    }
}

/// Solves for the simple fold near `(x, p)`; `null_vector` is a guess of the Jacobian's null vector (dx/ds of a nearby point serves).
///
/// Fails where the null space has more than one dimension (two planes of an isotropic machine folding together) and where dr/dp lies
/// in the range of the Jacobian (branch points).
pub fn fold<P: Zero + ?Sized>(problem: &mut P, x: &[f64], p: f64, null_vector: &[f64]) -> Result<FoldPoint, NotConverged> {
    let n = problem.dim();
    assert!(x.len() == n && null_vector.len() == n, "length of the start differs from the number of unknowns");
    let mut scale = vec![1.0; n + 1];
    problem.scale(&mut scale[..n]);
    scale[n] = problem.parameter_scale();
    let mut y: Vec<f64> = x.iter().chain([&p]).zip(&scale).map(|(x, s)| x / s).collect();
    let lost = |cause| NotConverged { cause, iterations: 0, residual: f64::NAN, step: f64::NAN };

    let (mut scratch, mut full, mut r) = (Scratch::default(), Mat::zeros(n + 1, n + 1), vec![0.0; n]);
    extended(problem, &scale, &y, &mut scratch, &mut r, Some(&mut full)).map_err(|f| lost(f.into()))?;
    let weight: Vec<f64> = (0..n).map(|i| norm(full.row(i))).collect();
    let mut b: Vec<f64> = (0..n).map(|i| full[(i, n)] / weight[i]).collect();
    let mut c: Vec<f64> = null_vector.iter().zip(&scale).map(|(v, s)| v / s).collect();
    for v in [&mut b, &mut c] {
        let length = norm(v);
        if length.is_nan() || length == 0.0 || !length.is_finite() {
            return Err(lost(Cause::Singular));
        }
        v.iter_mut().for_each(|v| *v /= length);
    }

    let start = y.clone();
    let mut system = Augmented {
        problem,
        scale: &scale,
        weight,
        b,
        c,
        v: Vec::new(),
        u: Vec::new(),
        bordered: Mat::default(),
        lu: Lu::default(),
        full,
        plus: Mat::default(),
        scratch,
    };
    let options = Options { to_rounding: true, noise: 1e-13, ..Options::default() };
    let done = Solver::default().solve(&mut system, &mut y, &options)?;
    // the null vector at the solution, not at the last difference
    system.full.reset(n + 1, n + 1);
    r.fill(0.0);
    extended(system.problem, &scale, &y, &mut system.scratch, &mut r, Some(&mut system.full)).map_err(|f| lost(f.into()))?;
    system.borders(false).map_err(|_| lost(Cause::Singular))?;
    let length = norm(&system.v[..n]) * dot(&system.v[..n], &system.c).signum();
    Ok(FoldPoint {
        p: y[n] * scale[n],
        x: y[..n].iter().zip(&scale).map(|(y, s)| y * s).collect(),
        null_vector: system.v[..n].iter().zip(&scale).map(|(v, s)| v / length * s).collect(),
        residual: done.residual,
        error: done.step,
        p_difference: (y[n] - start[n]) * scale[n],
        x_difference: distance(&y[..n], &start[..n]),
    })
}
