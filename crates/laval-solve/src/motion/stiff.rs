//! Exact Jacobian, and linear solves that eliminate memory states.
//!
//! With the states split into core u and memory w, J = [[Juu, L F], [U, D]]: memory acts on the core through the force rows F (lifted by L =
//! -[M^-1; d rate/d a M^-1]) and reads it through U, and D is diagonal (2 x 2 blocks in rotor axes). So
//!
//! ```text
//! (s I - Juu - L F (s - D)^-1 U) u = b_u + L F (s - D)^-1 b_w,     w = (s - D)^-1 (b_w + U u)
//! ```
//!
//! at a cost linear in the number of memory states. The energy account feeds nothing back: its rows of J are taken as zero, which costs at most one
//! iteration and no accuracy.

use super::{Motion, point};
use crate::model::system::System;
use crate::model::tangent::{Tangent, TangentScratch};
use laval_num::complex::{C64, c};
use laval_num::dense::{Field, Lu, Mat, Singular};
use laval_num::eig::eigenvalues;
use laval_num::ode::{DenseSolver, Failure, Ode, StiffOde};
use laval_num::refill::refill;

/// A field that holds the reals.
trait Shift: Field {
    fn real(x: f64) -> Self;
}
impl Shift for f64 {
    fn real(x: f64) -> f64 {
        x
    }
}
impl Shift for C64 {
    fn real(x: f64) -> C64 {
        c(x, 0.0)
    }
}

/// Where a state of the core or the memory stands in y.
pub(super) struct Elimination {
    core: Vec<usize>,
    memory: Vec<usize>,
    /// Memory state k is the first of a rotor pair.
    leads: Vec<bool>,
    tangent: Tangent,
    scratch: TangentScratch,
    lu: Lu,
    /// Juu, L, F, U.
    juu: Mat,
    lift: Mat,
    force: Mat,
    reads: Mat,
    /// Diagonal of D and its entries in (k, k+1) and (k+1, k).
    diagonal: Vec<f64>,
    pair: Vec<[f64; 2]>,
    real: Shifted<f64>,
    complex: Shifted<C64>,
}

#[derive(Default)]
struct Shifted<T: Field> {
    shift: Option<T>,
    matrix: Mat<T>,
    lu: Lu<T>,
    coupling: Mat<T>,
    u: Vec<T>,
    w: Vec<T>,
    rows: Vec<T>,
}

impl Elimination {
    pub fn new(system: &System, free: bool) -> Self {
        let (n, m) = (system.n(), system.m());
        let mut is_memory = vec![false; m];
        for slot in system.slots() {
            is_memory[slot.states.end - slot.memory..slot.states.end].fill(true);
        }
        let memory: Vec<usize> = (0..m).filter(|&i| is_memory[i]).map(|i| 2 * n + i).collect();
        let total = 2 * n + m + 2 * usize::from(free);
        let core = (0..total).filter(|&i| !(i >= 2 * n && i < 2 * n + m && is_memory[i - 2 * n])).collect();
        Elimination {
            leads: vec![false; memory.len()],
            diagonal: vec![0.0; memory.len()],
            pair: vec![[0.0; 2]; memory.len()],
            core,
            memory,
            tangent: Tangent::default(),
            scratch: TangentScratch::default(),
            lu: Lu::default(),
            juu: Mat::default(),
            lift: Mat::default(),
            force: Mat::default(),
            reads: Mat::default(),
            real: Shifted::default(),
            complex: Shifted::default(),
        }
    }

    pub fn memory(&self) -> usize {
        self.memory.len()
    }

    /// Splits the tangents of the residual at a point with the right accelerations.
    fn split(&mut self, system: &System, free: bool) -> Result<(), Failure> {
        let (n, m) = (system.n(), system.m());
        let rows = n + usize::from(free);
        let t = &self.tangent;
        self.lu.factor(&t.a).map_err(|s| super::direct::singular(system, s.column, t.a.data()))?;
        let mut inverse = Mat::identity(rows);
        self.lu.solve_mat(&mut inverse);
        let z_start = 2 * n;
        // row of the accelerations, or of a rate, that a core state's derivative is
        enum Row {
            Rate(usize),
            Accel(usize),
            State(usize),
        }
        let row = |i: usize| match i {
            i if i < n => Row::Rate(i),
            i if i < 2 * n => Row::Accel(i - n),
            i if i < 2 * n + m => Row::State(i - z_start),
            i if i == 2 * n + m => Row::Rate(n),
            _ => Row::Accel(n),
        };
        // column of the tangents
        let force_column = |k: usize, i: usize| match row(i) {
            Row::Rate(j) => t.q[(k, j)],
            Row::Accel(j) => t.v[(k, j)],
            Row::State(j) => t.z[(k, j)],
        };
        let rate_column = |k: usize, i: usize| match row(i) {
            Row::Rate(j) => t.rate_q[(k, j)],
            Row::Accel(j) => t.rate_v[(k, j)],
            Row::State(j) => t.rate_z[(k, j)],
        };
        let u = self.core.len();
        self.lift.reset(u, rows);
        for (r, &i) in self.core.iter().enumerate() {
            for k in 0..rows {
                self.lift[(r, k)] = match row(i) {
                    Row::Rate(_) => 0.0,
                    Row::Accel(j) => -inverse[(j, k)],
                    Row::State(j) => -(0..rows).map(|p| t.rate_a[(j, p)] * inverse[(p, k)]).sum::<f64>(),
                };
            }
        }
        let by_force = Mat::from_fn(rows, u, |k, col| force_column(k, self.core[col]));
        self.lift.matmul_into(&by_force, &mut self.juu);
        for (r, &i) in self.core.iter().enumerate() {
            for (col, &j) in self.core.iter().enumerate() {
                self.juu[(r, col)] += match (row(i), row(j)) {
                    (Row::Rate(a), Row::Accel(b)) if a == b => 1.0,
                    (Row::State(k), _) => rate_column(k, j),
                    _ => 0.0,
                };
            }
        }
        let w = self.memory.len();
        self.force.reset(rows, w);
        self.reads.reset(w, u);
        for k in 0..w {
            let i = self.memory[k] - z_start;
            for r in 0..rows {
                self.force[(r, k)] = t.z[(r, i)];
            }
            for (col, &j) in self.core.iter().enumerate() {
                self.reads[(k, col)] = rate_column(i, j);
            }
            self.diagonal[k] = t.rate_z[(i, i)];
            let next = self.memory.get(k + 1).is_some_and(|&j| j == self.memory[k] + 1);
            self.pair[k] = if next { [t.rate_z[(i, i + 1)], t.rate_z[(i + 1, i)]] } else { [0.0; 2] };
            self.leads[k] = self.pair[k] != [0.0; 2];
        }
        Ok(())
    }

    /// (s - D)^-1 applied in place.
    fn divide<T: Shift>(&self, s: T, w: &mut [T]) {
        let mut k = 0;
        while k < w.len() {
            let p = s - T::real(self.diagonal[k]);
            if self.leads[k] {
                let q = s - T::real(self.diagonal[k + 1]);
                let [up, down] = self.pair[k].map(T::real);
                let det = p * q - up * down;
                let (x, y) = (w[k], w[k + 1]);
                w[k] = (q * x + up * y) / det;
                w[k + 1] = (down * x + p * y) / det;
                k += 2;
            } else {
                w[k] = w[k] / p;
                k += 1;
            }
        }
    }

    fn factor<T: Shift + Default>(&self, s: T, out: &mut Shifted<T>) -> Result<(), Singular> {
        let (u, w, rows) = (self.core.len(), self.memory.len(), self.force.rows());
        out.shift = Some(s);
        // F (s - D)^-1 U, column by column of U
        out.coupling.reset(rows, u);
        refill(&mut out.w, w, T::ZERO);
        for col in 0..u {
            if w == 0 {
                break;
            }
            let mut any = false;
            for k in 0..w {
                let x = self.reads[(k, col)];
                any |= x != 0.0;
                out.w[k] = T::real(x);
            }
            if !any {
                continue;
            }
            self.divide(s, &mut out.w);
            for r in 0..rows {
                let mut sum = T::ZERO;
                for (&f, &x) in self.force.row(r).iter().zip(&out.w) {
                    sum += T::real(f) * x;
                }
                out.coupling[(r, col)] = sum;
            }
        }
        out.matrix.reset(u, u);
        for i in 0..u {
            for j in 0..u {
                let mut x = -T::real(self.juu[(i, j)]);
                if w > 0 {
                    for r in 0..rows {
                        x -= T::real(self.lift[(i, r)]) * out.coupling[(r, j)];
                    }
                }
                out.matrix[(i, j)] = x;
            }
            out.matrix[(i, i)] += s;
        }
        out.lu.factor(&out.matrix)
    }

    fn solve<T: Shift>(&self, b: &mut [T], out: &mut Shifted<T>) {
        let Some(s) = out.shift else { return };
        let rows = self.force.rows();
        out.w.clear();
        out.w.extend(self.memory.iter().map(|&i| b[i]));
        self.divide(s, &mut out.w);
        out.rows.clear();
        for r in 0..rows {
            let mut sum = T::ZERO;
            for (&f, &x) in self.force.row(r).iter().zip(&out.w) {
                sum += T::real(f) * x;
            }
            out.rows.push(sum);
        }
        out.u.clear();
        for (i, &k) in self.core.iter().enumerate() {
            let mut x = b[k];
            for (&l, &f) in self.lift.row(i).iter().zip(&out.rows) {
                x += T::real(l) * f;
            }
            out.u.push(x);
        }
        out.lu.solve(&mut out.u);
        for (k, &i) in self.memory.iter().enumerate() {
            let mut x = b[i];
            for (&r, &u) in self.reads.row(k).iter().zip(&out.u) {
                x += T::real(r) * u;
            }
            out.w[k] = x;
        }
        self.divide(s, &mut out.w);
        let total = self.core.len() + self.memory.len();
        for x in &mut b[total..] {
            *x = *x / s;
        }
        for (&i, &x) in self.core.iter().zip(&out.u).chain(self.memory.iter().zip(&out.w)) {
            b[i] = x;
        }
    }
}

impl Motion<'_> {
    /// Size of the largest eigenvalues of the Jacobian, 1/s. `None` where it cannot be computed.
    pub(super) fn spectral_radius(&mut self, t: f64, y: &[f64]) -> Option<f64> {
        if self.large.is_some() {
            self.linearise(t, y, &mut DenseSolver::default()).ok()?;
            return self.large.as_ref().map(|l| l.spectral_radius(self.system.n()));
        }
        let n = self.dim();
        let mut jac = Mat::zeros(n, n);
        self.jacobian(t, y, &mut jac).ok()?;
        Some(eigenvalues(&jac).ok()?.iter().fold(0.0f64, |r, s| r.max(s.abs())))
    }

    fn keep_tangent(&mut self, t: f64, y: &[f64]) -> Result<(), Failure> {
        let spin = self.accelerate(t, y)?;
        let free = self.is_free();
        let e = &mut self.elimination;
        let at = point(self.system, t, spin, y, &self.direct.accel);
        self.system.tangent(&at, free, &mut e.tangent, &mut e.scratch, |_| true);
        e.split(self.system, free)
    }
}

impl StiffOde for Motion<'_> {
    fn jacobian(&mut self, t: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        if self.massless.is_some() {
            let (spin, free) = (self.accelerate(t, y)?, self.is_free());
            if let Some(m) = &mut self.massless {
                let whole = m.completed().to_vec();
                m.jacobian(self.system, free, &point(self.system, t, spin, &whole, &self.direct.accel), jac)?;
            }
            return Ok(());
        }
        self.keep_tangent(t, y)?;
        let e = &self.elimination;
        for (r, &i) in e.core.iter().enumerate() {
            for (col, &j) in e.core.iter().enumerate() {
                jac[(i, j)] = e.juu[(r, col)];
            }
            for (k, &j) in e.memory.iter().enumerate() {
                jac[(i, j)] = (0..e.force.rows()).map(|p| e.lift[(r, p)] * e.force[(p, k)]).sum();
            }
        }
        for (k, &i) in e.memory.iter().enumerate() {
            for (col, &j) in e.core.iter().enumerate() {
                jac[(i, j)] = e.reads[(k, col)];
            }
            jac[(i, i)] = e.diagonal[k];
            if e.leads[k] {
                jac[(i, i + 1)] = e.pair[k][0];
                jac[(i + 1, i)] = e.pair[k][1];
            }
        }
        Ok(())
    }

    fn linearise(&mut self, t: f64, y: &[f64], dense: &mut DenseSolver) -> Result<(), Failure> {
        if self.massless.is_some() {
            return dense.set_jacobian(self, t, y);
        }
        if self.large.is_some() {
            let spin = self.accelerate(t, y)?;
            let at = point(self.system, t, spin, y, &self.direct.accel);
            return self.large.as_mut().map_or(Ok(()), |l| l.linearise(self.system, &at));
        }
        self.keep_tangent(t, y)
    }

    fn factor(&mut self, real: f64, complex: C64, dense: &mut DenseSolver) -> Result<(), Singular> {
        if self.massless.is_some() {
            return dense.factor(real, complex);
        }
        if let Some(large) = &mut self.large {
            return large.factor(real, complex);
        }
        let mut shifted = (std::mem::take(&mut self.elimination.real), std::mem::take(&mut self.elimination.complex));
        let result = self.elimination.factor(real, &mut shifted.0).and_then(|()| self.elimination.factor(complex, &mut shifted.1));
        (self.elimination.real, self.elimination.complex) = shifted;
        result
    }

    fn solve_real(&mut self, b: &mut [f64], dense: &DenseSolver) {
        if self.massless.is_some() {
            return dense.solve_real(b);
        }
        if let Some(large) = &mut self.large {
            return large.solve_real(self.system.n(), b);
        }
        let mut shifted = std::mem::take(&mut self.elimination.real);
        self.elimination.solve(b, &mut shifted);
        self.elimination.real = shifted;
    }

    fn solve_complex(&mut self, b: &mut [C64], dense: &DenseSolver) {
        if self.massless.is_some() {
            return dense.solve_complex(b);
        }
        if let Some(large) = &mut self.large {
            return large.solve_complex(self.system.n(), b);
        }
        let mut shifted = std::mem::take(&mut self.elimination.complex);
        self.elimination.solve(b, &mut shifted);
        self.elimination.complex = shifted;
    }

    fn forces(&mut self, t: f64, y: &[f64], f: &mut [f64]) -> Result<(), Failure> {
        let spin = self.spin(t, y);
        match &mut self.large {
            Some(large) if large.has_constant_mass() => large.forces(self.system, t, spin, y, f),
            _ => self.rhs_without_integrals(t, y, f),
        }
    }

    fn solve_real_forces(&mut self, real: f64, f: &mut [f64], w: &[f64], dense: &DenseSolver) {
        if let Some(large) = self.large.as_mut().filter(|l| l.has_constant_mass()) {
            return large.solve_real_forces(self.system.n(), f, w);
        }
        f.iter_mut().zip(w).for_each(|(f, w)| *f -= real * w);
        self.solve_real(f, dense);
    }

    fn solve_complex_forces(&mut self, complex: C64, f: &mut [C64], w: &[C64], dense: &DenseSolver) {
        if let Some(large) = self.large.as_mut().filter(|l| l.has_constant_mass()) {
            return large.solve_complex_forces(self.system.n(), f, w);
        }
        f.iter_mut().zip(w).for_each(|(f, w)| *f -= complex * *w);
        self.solve_complex(f, dense);
    }
}
