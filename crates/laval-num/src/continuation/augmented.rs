//! Minimally augmented systems: points where a Jacobian loses its rank, as zeros of
//!
//! `r(x, p) + s b = 0, g = 0` with `g` from `[J b; C 0] [V; g] = [0; 1]`.
//!
//! For a [fold](super::fold) J is dr/dx, `C` one row, and `s` is left out; for a [branch point](super::branch_point) J is [dr/dx dr/dp] and `C` has two rows.
//! The derivative of `g` is `-u' dJ V_k`, `u` from the transposed system, with the second derivative of `r` along `V_k` by central differences of the exact
//! Jacobian. That difference affects the speed of Newton's method only: the point where `g` vanishes is as exact as the Jacobian.

use super::problem::{Failure, Zero};
use super::step::{Scratch, extended, resized};
use crate::dense::{Lu, Mat, Singular, dot, norm};
use crate::newton::{Converged, NotConverged, Options, Solver, System};

pub(super) struct Augmented<'a> {
    problem: &'a mut dyn Zero,
    scale: &'a [f64],
    /// Lengths of the rows of the Jacobian at the start.
    weight: Vec<f64>,
    /// Columns of J.
    width: usize,
    b: Vec<f64>,
    c: Vec<Vec<f64>>,
    /// Null vectors, each followed by its g.
    pub v: Vec<Vec<f64>>,
    /// Left null vector of J with rows of unit length.
    pub u: Vec<f64>,
    bordered: Mat,
    lu: Lu,
    full: Mat,
    plus: Mat,
    scratch: Scratch,
}

impl<'a> Augmented<'a> {
    /// For rows of `C` near the null vectors, `b` from the Jacobian with rows of unit length at the scaled point `y`; `None` where a row is zero.
    pub fn new(
        problem: &'a mut dyn Zero,
        scale: &'a [f64],
        y: &[f64],
        c: Vec<Vec<f64>>,
        b: impl FnOnce(&Mat) -> Vec<f64>,
    ) -> Result<Option<Self>, Failure> {
        let n = scale.len() - 1;
        let (mut scratch, mut full) = (Scratch::default(), Mat::zeros(n + 1, n + 1));
        extended(problem, scale, y, &mut scratch, &mut vec![0.0; n], Some(&mut full))?;
        let weight: Vec<f64> = (0..n).map(|i| norm(full.row(i))).collect();
        if weight.iter().any(|w| !(*w > 0.0 && w.is_finite())) {
            return Ok(None);
        }
        let unit = Mat::from_fn(n, n + 1, |i, j| full[(i, j)] / weight[i]);
        let (v, width) = (vec![Vec::new(); c.len()], n + c.len() - 1);
        let (b, u, bordered, lu, plus) = (b(&unit), Vec::new(), Mat::default(), Lu::default(), Mat::default());
        Ok(Some(Augmented { problem, scale, weight, width, b, c, v, u, bordered, lu, full, plus, scratch }))
    }

    /// Newton's method to rounding.
    pub fn solve(&mut self, y: &mut [f64]) -> Result<Converged, NotConverged> {
        Solver::default().solve(self, y, &Options { to_rounding: true, noise: 1e-13, ..Options::default() })
    }

    /// Both null vectors at a point, not at the last difference.
    pub fn null_vectors(&mut self, y: &[f64]) -> Result<(), Failure> {
        let n = self.scale.len() - 1;
        self.full.reset(n + 1, n + 1);
        extended(self.problem, self.scale, y, &mut self.scratch, &mut vec![0.0; n], Some(&mut self.full))?;
        self.borders(true).map_err(|_| SINGULAR)
    }

    /// Change of the scaled parameter that stands for one rounding of the equations, `u' dr / u' dr/dp` at the point of [`Self::null_vectors`]: without bound at a branch
    /// point.
    pub fn resolution(&self, y: &[f64]) -> f64 {
        let n = self.scale.len() - 1;
        let size = f64::EPSILON * norm(y).max(1.0);
        let along: f64 = (0..n).map(|i| self.u[i] * self.full[(i, n)] / self.weight[i]).sum();
        size * self.u[..n].iter().map(|u| u.abs()).sum::<f64>() / along.abs()
    }

    /// Directions of both branches through a branch point: `a V_1 + b V_2` with `u' d2r` of it twice zero, a quadratic equation for a : b.
    pub fn tangents(&mut self, y: &[f64]) -> Option<[Vec<f64>; 2]> {
        let (n, size) = (self.scale.len() - 1, self.width + 1);
        let mut jac = Mat::zeros(size, size);
        self.eval(y, &mut vec![0.0; size], Some(&mut jac)).ok()?;
        let [v, w] = &self.v[..] else { return None };
        let form = |k: usize, v: &[f64]| dot(&jac.row(n + k)[..=n], &v[..=n]);
        let (aa, ab, bb) = (form(0, v), 0.5 * (form(0, w) + form(1, v)), form(1, w));
        let root = (ab * ab - aa * bb).sqrt();
        let q = -(ab + root.copysign(ab));
        let one = |a: f64, b: f64| {
            let t: Vec<f64> = v[..=n].iter().zip(&w[..=n]).map(|(v, w)| a * v + b * w).collect();
            let length = norm(&t);
            (length > 0.0 && length.is_finite()).then(|| t.iter().map(|t| t / length).collect())
        };
        Some([one(q, aa)?, one(bb, q)?])
    }

    /// Fills `bordered` from `full`, and `v`; with `left`, `u` too.
    fn borders(&mut self, left: bool) -> Result<(), Singular> {
        let (n, width) = (self.scale.len() - 1, self.width);
        self.bordered.reset(width + 1, width + 1);
        for i in 0..n {
            for j in 0..width {
                self.bordered[(i, j)] = self.full[(i, j)] / self.weight[i];
            }
            self.bordered[(i, width)] = self.b[i];
        }
        for (k, c) in self.c.iter().enumerate() {
            self.bordered.row_mut(n + k)[..width].copy_from_slice(c);
        }
        self.lu.factor(&self.bordered)?;
        for (k, v) in self.v.iter_mut().enumerate() {
            resized(v, width + 1)[n + k] = 1.0;
            self.lu.solve(v);
        }
        if left {
            self.lu.factor(&self.bordered.transpose())?;
            resized(&mut self.u, width + 1)[width] = 1.0;
            self.lu.solve(&mut self.u);
        }
        Ok(())
    }
}

const SINGULAR: Failure = Failure::Undefined("the bordered Jacobian is singular: neither a simple fold nor a simple branch point");

impl System for Augmented<'_> {
    fn size(&self) -> usize {
        self.width + 1
    }
    fn eval(&mut self, y: &[f64], r: &mut [f64], jac: Option<&mut Mat>) -> Result<(), Failure> {
        let (n, width) = (self.scale.len() - 1, self.width);
        let own = &y[..=n];
        self.full.reset(n + 1, n + 1);
        extended(self.problem, self.scale, own, &mut self.scratch, r, Some(&mut self.full))?;
        self.borders(jac.is_some()).map_err(|_| SINGULAR)?;
        if let Some(apart) = y.get(n + 1) {
            for i in 0..n {
                r[i] += apart * self.b[i] * self.weight[i];
            }
        }
        for (r, v) in r[n..].iter_mut().zip(&self.v) {
            *r = v[width];
        }
        let Some(jac) = jac else { return Ok(()) };
        for i in 0..n {
            jac.row_mut(i)[..=n].copy_from_slice(&self.full.row(i)[..=n]);
            if width > n {
                jac[(i, n + 1)] = self.b[i] * self.weight[i];
            }
        }
        let mut waste = vec![0.0; n];
        for (k, v) in self.v.iter().enumerate() {
            // cube root of the rounding unit: the best of a central difference
            let h = 6e-6 * norm(own).max(1.0) / norm(&v[..width]);
            let shift = |h: f64| own.iter().enumerate().map(|(i, y)| if i < width { y + h * v[i] } else { *y }).collect::<Vec<_>>();
            for (place, out) in [(shift(h), &mut self.plus), (shift(-h), &mut self.full)] {
                out.reset(n + 1, n + 1);
                waste.fill(0.0);
                extended(self.problem, self.scale, &place, &mut self.scratch, &mut waste, Some(out))?;
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
