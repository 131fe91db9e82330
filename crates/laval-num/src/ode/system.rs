//! The problem: y' = f(t, y), with its Jacobian and linear solves for implicit methods.

use crate::complex::{C64, c};
use crate::dense::{Lu, Mat, Singular};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Why a right side, a Jacobian or a request could not be evaluated. It ends the integration;
/// a right side that merely left its domain returns a value that is not finite instead, and the step is retried smaller.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure(pub Cow<'static, str>);

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}
impl std::error::Error for Failure {}
impl From<&'static str> for Failure {
    fn from(what: &'static str) -> Self {
        Failure(Cow::Borrowed(what))
    }
}
impl From<String> for Failure {
    fn from(what: String) -> Self {
        Failure(Cow::Owned(what))
    }
}

/// y' = f(t, y).
pub trait Ode {
    /// Number of states.
    fn dim(&self) -> usize;
    /// `dy = f(t, y)`; both slices have length [`Ode::dim`], and every entry of `dy` must be written.
    ///
    /// A value that is not finite rejects the step, which is then tried smaller; an error ends the integration.
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure>;
    /// Times at which the right side is requested next, in this order, if the step runs to its end: what depends on time alone may be computed for all of
    /// them side by side. Other times may come between.
    fn ahead(&mut self, _times: &[f64]) {}
    /// The length of the step from `(t, y)`, shortened where a step of the length `proposed` could pass over a change of the right side with time, such as a
    /// load that turns: the error estimate does not see it while the states stay below their absolute tolerances.
    fn longest_step(&self, _t: f64, _y: &[f64], proposed: f64) -> f64 {
        proposed
    }
    /// Number of the last states that no rate depends on: integrals along the motion. An implicit method computes them after the others.
    fn integrals(&self) -> usize {
        0
    }
    /// Rates of all states but the [integrals](Ode::integrals), whose entries of `dy` are arbitrary.
    fn rhs_without_integrals(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        self.rhs(t, y, dy)
    }
}

/// A problem an implicit method can solve, `M y' = f(t, y)` with a matrix M that only the system knows: by default the identity.
///
/// The method needs solutions of (s I - J) x = b, J = df/dy, for one real and one complex shift s at a time. By default J is a dense
/// matrix and the systems are solved by LU factors kept in [`DenseSolver`]. A system with structure overrides
/// [`StiffOde::linearise`], [`StiffOde::factor`], [`StiffOde::solve_real`] and [`StiffOde::solve_complex`] together, keeps what it needs in
/// itself and leaves the [`DenseSolver`] untouched (it then stays empty). Linear memory z_k' = -l_k z_k + c_k u(q), for
/// instance, is eliminated by z_k = (b_k + c_k du) / (s + l_k) at a cost linear in the number of memory states.
pub trait StiffOde: Ode {
    /// `jac[(i, j)] = d f_i / d y_j` at `(t, y)`; `jac` comes square of size [`Ode::dim`] and zero.
    fn jacobian(&mut self, t: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure>;

    /// Evaluates and keeps J at `(t, y)` for the next calls of [`StiffOde::factor`].
    fn linearise(&mut self, t: f64, y: &[f64], dense: &mut DenseSolver) -> Result<(), Failure> {
        dense.set_jacobian(self, t, y)
    }

    /// Prepares the solutions of `(real I - J) x = b` and `(complex I - J) x = b`.
    fn factor(&mut self, real: f64, complex: C64, dense: &mut DenseSolver) -> Result<(), Singular> {
        dense.factor(real, complex)
    }

    /// Solves `(real I - J) x = b` in place.
    fn solve_real(&mut self, b: &mut [f64], dense: &DenseSolver) {
        dense.solve_real(b);
    }

    /// Solves `(complex I - J) x = b` in place.
    fn solve_complex(&mut self, b: &mut [C64], dense: &DenseSolver) {
        dense.solve_complex(b);
    }

    /// f(t, y) of `M y' = f`, that of the [integrals](Ode::integrals) arbitrary. A system whose solves multiply by M anyway overrides this and the next two
    /// together, and is spared the division by M.
    fn forces(&mut self, t: f64, y: &[f64], f: &mut [f64]) -> Result<(), Failure> {
        self.rhs_without_integrals(t, y, f)
    }

    /// Solves `(real I - J) x = M^-1 f - real w` in place of f.
    fn solve_real_forces(&mut self, real: f64, f: &mut [f64], w: &[f64], dense: &DenseSolver) {
        f.iter_mut().zip(w).for_each(|(f, w)| *f -= real * w);
        self.solve_real(f, dense);
    }

    /// Solves `(complex I - J) x = M^-1 f - complex w` in place of f.
    fn solve_complex_forces(&mut self, complex: C64, f: &mut [C64], w: &[C64], dense: &DenseSolver) {
        f.iter_mut().zip(w).for_each(|(f, w)| *f -= complex * *w);
        self.solve_complex(f, dense);
    }
}

/// Dense J and the LU factors of its two shifts: what the default methods of [`StiffOde`] work on.
#[derive(Clone, Debug, Default)]
pub struct DenseSolver {
    jac: Mat,
    shifted: Mat,
    shifted_complex: Mat<C64>,
    real: Lu,
    complex: Lu<C64>,
}

impl DenseSolver {
    /// The Jacobian last evaluated.
    pub fn jacobian(&self) -> &Mat {
        &self.jac
    }

    /// Evaluates and keeps the Jacobian of `system`.
    pub fn set_jacobian<S: StiffOde + ?Sized>(&mut self, system: &mut S, t: f64, y: &[f64]) -> Result<(), Failure> {
        let n = system.dim();
        self.jac.reset(n, n);
        system.jacobian(t, y, &mut self.jac)
    }

    /// Factors `real I - J` and `complex I - J`.
    pub fn factor(&mut self, real: f64, complex: C64) -> Result<(), Singular> {
        let n = self.jac.rows();
        self.shifted.reset(n, n);
        self.shifted_complex.reset(n, n);
        for ((r, z), &j) in self.shifted.data_mut().iter_mut().zip(self.shifted_complex.data_mut()).zip(self.jac.data()) {
            *r = -j;
            *z = c(-j, 0.0);
        }
        for i in 0..n {
            self.shifted[(i, i)] += real;
            self.shifted_complex[(i, i)] += complex;
        }
        self.real.factor(&self.shifted)?;
        self.complex.factor(&self.shifted_complex)
    }

    /// Solves `(real I - J) x = b` in place.
    pub fn solve_real(&self, b: &mut [f64]) {
        self.real.solve(b);
    }

    /// Solves `(complex I - J) x = b` in place.
    pub fn solve_complex(&self, b: &mut [C64]) {
        self.complex.solve(b);
    }
}

/// A right side given as a closure; see [`ode`].
#[derive(Clone, Debug)]
pub struct FnOde<F> {
    dim: usize,
    f: F,
}

/// The problem of `dim` states whose right side is the closure `f(t, y, dy)`.
pub fn ode<F: FnMut(f64, &[f64], &mut [f64])>(dim: usize, f: F) -> FnOde<F> {
    FnOde { dim, f }
}

impl<F: FnMut(f64, &[f64], &mut [f64])> Ode for FnOde<F> {
    fn dim(&self) -> usize {
        self.dim
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        (self.f)(t, y, dy);
        Ok(())
    }
}
