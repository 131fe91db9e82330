//! Loci of folds in the plane of spin speed and one parameter.
//!
//! ```text
//! r(x, W, q) = 0,    A(x, W, q) v = 0,    v.v = 1         A = dr/dx
//! ```
//!
//! with the null vector v as an unknown, so that no border has to follow it. The Jacobian of this system has full rank along a curve of folds, also where the
//! curve ends in a cusp (`u.r_xx v v = 0`, u the left null vector): there its tangent is (v, ..., 0, 0) and both speed and parameter turn back. Where only the
//! parameter turns back (`u.r_W = 0`) two folds of the response meet: a detached branch begins or ends, or branches exchange their parts.
//!
//! Second derivatives along v are central differences of the exact Jacobian, which serve steps and tangents alone.
//!
//! Theory: `docs/theory/harmonic-balance.md#folds-and-branch-points`.
//!
//! Source: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (SIAM 2000), chapters 3 and 8.

use crate::harmonic::balance::problem::Balance;
use crate::harmonic::loci::varied::{STEP, Varied, linearised};
use laval_num::continuation::{Failure, Zero};
use laval_num::dense::{Lu, Mat, dot, max_abs, norm};

/// Folds of a balance. Unknowns: n harmonics, the n components of the null vector in scaled unknowns, the speed; the parameter is that of the machine.
pub struct FoldLocus<'a> {
    /// The machine.
    pub varied: Varied<'a>,
}

impl<'a> FoldLocus<'a> {
    /// Number of unknowns of the motion alone.
    pub fn size(&self) -> usize {
        self.varied.terms().unknowns
    }

    /// Unknowns at a fold of the response, with the null vector by inverse iteration.
    ///
    /// # Errors
    /// Equations that cannot be evaluated there.
    pub fn unknowns(&mut self, x: &[f64], speed: f64, value: f64) -> Result<Vec<f64>, Failure> {
        let scale = self.varied.scales().to_vec();
        let v = self.varied.at(value, |balance| null_vector(balance, x, speed, &scale))?;
        Ok(x.iter().chain(&v).chain([&speed]).copied().collect())
    }
}

/// Null vector of the Jacobian beside a fold, of unit length in scaled unknowns.
fn null_vector(balance: &mut Balance, x: &[f64], speed: f64, scale: &[f64]) -> Result<Vec<f64>, Failure> {
    const SINGULAR: Failure = Failure::Undefined("the Jacobian has no single null vector");
    let (_, mut a, _) = linearised(balance, x, speed)?;
    scaled(&mut a, scale);
    for i in 0..scale.len() {
        let size = norm(a.row(i));
        a.row_mut(i).iter_mut().for_each(|a| *a /= size);
    }
    let (lu, transposed) = (Lu::new(&a).map_err(|_| SINGULAR)?, Lu::new(&a.transpose()).map_err(|_| SINGULAR)?);
    let mut v: Vec<f64> = (0..scale.len()).map(|i| 1.0 + 0.3 * (1.7 * i as f64).sin()).collect();
    for _ in 0..6 {
        transposed.solve(&mut v);
        let size = max_abs(&v);
        v.iter_mut().for_each(|v| *v /= size);
        lu.solve(&mut v);
        let size = norm(&v);
        if !(size.is_finite() && size > 0.0) {
            return Err(SINGULAR);
        }
        v.iter_mut().for_each(|v| *v /= size);
    }
    Ok(v)
}

/// Columns times the scales of their unknowns.
pub(super) fn scaled(a: &mut Mat, scale: &[f64]) {
    for i in 0..a.rows() {
        a.row_mut(i).iter_mut().zip(scale).for_each(|(a, s)| *a *= s);
    }
}

impl Zero for FoldLocus<'_> {
    fn dim(&self) -> usize {
        2 * self.size() + 1
    }
    fn scale(&self, out: &mut [f64]) {
        let n = self.size();
        out[..n].copy_from_slice(self.varied.scales());
        out[n..2 * n].fill(1.0);
        out[2 * n] = self.varied.speed_scale();
    }
    fn parameter_scale(&self) -> f64 {
        self.varied.value_scale()
    }
    fn eval(&mut self, y: &[f64], q: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dq: Option<&mut [f64]>) -> Result<(), Failure> {
        let n = self.size();
        let (x, v, speed) = (&y[..n], &y[n..2 * n], y[2 * n]);
        if self.varied.beyond(speed) {
            return Err(Failure::Undefined("the locus leaves the range of speeds"));
        }
        let scale = self.varied.scales().to_vec();
        let own: Vec<f64> = v.iter().zip(&scale).map(|(v, s)| v * s).collect();
        let h = STEP * norm(&x.iter().zip(&scale).map(|(x, s)| x / s).collect::<Vec<_>>()).max(1.0);
        let beside = |side: f64| -> Vec<f64> { x.iter().zip(&own).map(|(x, v)| x + side * h * v).collect() };
        let wanted = jac.is_some();
        let (residual, a, by_speed, sides) = self.varied.at(q, |balance| {
            let (residual, a, by_speed) = linearised(balance, x, speed)?;
            let sides =
                if wanted { Some([linearised(balance, &beside(1.0), speed)?, linearised(balance, &beside(-1.0), speed)?]) } else { None };
            Ok((residual, a, by_speed, sides))
        })?;
        r[..n].copy_from_slice(&residual);
        a.mul_vec_add(&own, &mut r[n..2 * n]);
        r[2 * n] = 0.5 * (dot(v, v) - 1.0);
        if let (Some(jac), Some([plus, minus])) = (jac, sides) {
            for i in 0..n {
                for j in 0..n {
                    jac[(i, j)] = a[(i, j)];
                    jac[(n + i, n + j)] = a[(i, j)] * scale[j];
                    jac[(n + i, j)] = (plus.1[(i, j)] - minus.1[(i, j)]) / (2.0 * h);
                }
                jac[(i, 2 * n)] = by_speed[i];
                jac[(n + i, 2 * n)] = (plus.2[i] - minus.2[i]) / (2.0 * h);
            }
            jac.row_mut(2 * n)[n..2 * n].copy_from_slice(v);
        }
        if let Some(out) = dr_dq {
            let both = |balance: &mut Balance| {
                let (mut residual, a, _) = linearised(balance, x, speed)?;
                residual.extend(a.mul_vec(&own));
                Ok(residual)
            };
            out[..2 * n].copy_from_slice(&self.varied.slope(q, &both)?);
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.varied.cancelled()
    }
}
