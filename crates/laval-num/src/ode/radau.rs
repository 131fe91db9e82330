//! Radau IIA collocation with three stages: implicit, order 5, L-stable.

use super::control::{Attempt, Cause, Control, Scale, Work, evaluate, finite};
use super::driver::Method;
use super::step::Step;
use super::system::{DenseSolver, Failure, StiffOde};
use crate::complex::{C64, c};
use crate::refill::refill;

const SQRT6: f64 = 2.449489742783178;
/// Nodes.
pub(super) const C: [f64; 3] = [(4.0 - SQRT6) / 10.0, (4.0 + SQRT6) / 10.0, 1.0];
/// Real eigenvalue of the inverse A^-1 of the coefficient matrix.
pub(super) const REAL: f64 = 3.637834252744496;
/// Complex eigenvalue of A^-1, the one of negative imaginary part.
pub(super) const COMPLEX: C64 = c(2.681082873627752, -3.050430199247411);
/// A^-1 T = T diag(REAL, [[re, -im], [im, re]] of conj(COMPLEX)).
pub(super) const T: [[f64; 3]; 3] = [
    [0.09443876248897524, -0.141_255_295_020_954_2, 0.03002919410514742],
    [0.250_213_122_965_333_3, 0.20412935229379994, -0.382_942_112_757_261_9],
    [1.0, 1.0, 0.0],
];
/// T^-1.
pub(super) const TI: [[f64; 3]; 3] = [
    [4.178_718_591_551_905, 0.327_682_820_761_062_4, 0.523_376_445_499_449_5],
    [-4.178_718_591_551_905, -0.327_682_820_761_062_4, 0.476_623_554_500_550_44],
    [0.502_872_634_945_786_8, -2.571_926_949_855_605, 0.596_039_204_828_225],
];
/// Coefficient matrix A.
pub(super) const A: [[f64; 3]; 3] = [
    [(88.0 - 7.0 * SQRT6) / 360.0, (296.0 - 169.0 * SQRT6) / 1800.0, (-2.0 + 3.0 * SQRT6) / 225.0],
    [(296.0 + 169.0 * SQRT6) / 1800.0, (88.0 + 7.0 * SQRT6) / 360.0, (-2.0 - 3.0 * SQRT6) / 225.0],
    [(16.0 - SQRT6) / 36.0, (16.0 + SQRT6) / 36.0, 1.0 / 9.0],
];
/// Weights of the stage increments in the error estimate.
const E: [f64; 3] = [(-13.0 - 7.0 * SQRT6) / 3.0, (-13.0 + 7.0 * SQRT6) / 3.0, -1.0 / 3.0];

const MAX_ITERATIONS: usize = 7;
const MIN_FACTOR: f64 = 0.125;
const MAX_FACTOR: f64 = 5.0;
/// A Newton iteration that contracts faster keeps its Jacobian for the next step.
const KEEP_JACOBIAN: f64 = 0.1;
/// A step that could grow by no more keeps its length, and with it the factors: with a factorisation at half of the steps, a motion of a shaft of 50 elements took a third longer.
const KEEP_LENGTH: f64 = 1.5;
/// Lengths this close share their factors; what is lost is far below the contraction of the iteration.
const SAME_LENGTH: f64 = 1e-6;

/// Implicit method of order 5 for stiff problems (Hairer, Wanner, Solving Ordinary Differential Equations II, section IV.8), with a dense
/// output of order 3. The object is its storage; reuse it to avoid allocation.
///
/// The error estimate is of order 3; following the source it is held to the tolerances r' = r^(2/3)/10, a' = a r'/r, at which the error of the
/// formula itself is about r. A state with r = 0 keeps its absolute tolerance. Inside a step, at outputs and events, the error is about r', not r:
/// where that matters, require a smaller tolerance.
#[derive(Clone, Debug, Default)]
pub struct Radau {
    /// Newton's iteration stops when its estimated error is this fraction of the (transformed) tolerance; chosen from the tolerance if absent.
    pub newton_tolerance: Option<f64>,
    scale: Scale,
    dense: DenseSolver,
    y0: Vec<f64>,
    y1: Vec<f64>,
    f0: Vec<f64>,
    f1: Vec<f64>,
    w: Vec<f64>,
    error: Vec<f64>,
    /// Stage increments Z, their transforms W, right sides F: three rows each.
    z: Vec<f64>,
    tz: Vec<f64>,
    f: Vec<f64>,
    complex: Vec<C64>,
    transformed: Vec<C64>,
    /// Rows of the interpolant of the last accepted step, and of the step just accepted.
    rows: Vec<f64>,
    t0: f64,
    t1: f64,
    last_length: Option<f64>,
    linearised: bool,
    fresh: bool,
    factored: Option<f64>,
    kappa: f64,
    /// Last contraction factor over (1 - itself): lets an iteration stop after one pass.
    eta: f64,
    contraction: f64,
    /// States that are no integrals.
    core: usize,
    accepted: Option<(f64, f64)>,
    first: bool,
    after_rejection: bool,
}

/// Evaluates the forces on the first `core` states; the rates of the integrals behind them stay in `f`. `false` if one is not finite.
fn forces<S: StiffOde + ?Sized>(
    system: &mut S,
    t: f64,
    y: &[f64],
    (f, scratch): (&mut [f64], &mut [f64]),
    core: usize,
    work: &mut Work,
) -> Result<bool, Failure> {
    work.rhs += 1;
    if core == f.len() {
        system.forces(t, y, f)?;
    } else {
        system.forces(t, y, scratch)?;
        f[..core].copy_from_slice(&scratch[..core]);
    }
    Ok(finite(f))
}

enum Newton {
    Converged { iterations: usize },
    Diverged,
    NotFinite,
}

impl Radau {
    /// Empty storage.
    pub fn new() -> Self {
        Self::default()
    }

    /// Stage increments of the last collocation polynomial, continued to the new step, or zero.
    fn predict(&mut self, h: f64) {
        let n = self.y0.len();
        let Some(last) = self.last_length else {
            self.z.fill(0.0);
            self.tz.fill(0.0);
            return;
        };
        let (a, b, d) = (&self.rows[..n], &self.rows[n..2 * n], &self.rows[2 * n..3 * n]);
        for (i, ci) in C.iter().enumerate() {
            let x = 1.0 + ci * h / last;
            for j in 0..n {
                self.z[i * n + j] = x * (a[j] + (1.0 - x) * (b[j] + x * d[j])) - a[j];
            }
        }
        for (i, row) in TI.iter().enumerate() {
            for j in 0..n {
                self.tz[i * n + j] = row[0] * self.z[j] + row[1] * self.z[n + j] + row[2] * self.z[2 * n + j];
            }
        }
    }

    /// Simplified Newton iteration for Z = h (A x I) F(Z), in the transformed variables.
    fn newton<S: StiffOde + ?Sized>(&mut self, system: &mut S, h: f64, work: &mut Work) -> Result<Newton, Failure> {
        let (n, core) = (self.y0.len(), self.core);
        self.predict(h);
        // below this the iteration only sees rounding
        let floor = (0..n).fold(0.0, |m: f64, i| m.max(self.y0[i].abs() / self.scale.at(i, self.y0[i].abs())));
        let kappa = self.kappa.max(10.0 * f64::EPSILON * floor);
        let mut eta = self.eta.max(f64::EPSILON).powf(0.8);
        let mut last = 0.0;
        self.contraction = 0.0;
        for k in 0..MAX_ITERATIONS {
            work.iterations += 1;
            for (i, ci) in C.iter().enumerate() {
                for j in 0..n {
                    self.w[j] = self.y0[j] + self.z[i * n + j];
                }
                let t = if i == 2 { self.t1 } else { self.t0 + ci * h };
                work.rhs += 1;
                let f = &mut self.f[i * n..(i + 1) * n];
                system.forces(t, &self.w, f)?;
                if !finite(&f[..core]) {
                    return Ok(Newton::NotFinite);
                }
            }
            let (real, complex) = (REAL / h, c(COMPLEX.re / h, COMPLEX.im / h));
            self.w[core..].fill(0.0);
            self.complex[core..].fill(c(0.0, 0.0));
            for j in 0..core {
                let f = [self.f[j], self.f[n + j], self.f[2 * n + j]];
                let g = |row: &[f64; 3]| row[0] * f[0] + row[1] * f[1] + row[2] * f[2];
                self.w[j] = g(&TI[0]);
                self.complex[j] = c(g(&TI[1]), g(&TI[2]));
                self.transformed[j] = c(self.tz[n + j], self.tz[2 * n + j]);
            }
            system.solve_real_forces(real, &mut self.w, &self.tz[..n], &self.dense);
            system.solve_complex_forces(complex, &mut self.complex, &self.transformed, &self.dense);
            let mut sum = 0.0;
            for j in 0..core {
                let s = self.scale.at(j, self.y0[j].abs());
                for d in [self.w[j], self.complex[j].re, self.complex[j].im] {
                    if d != 0.0 {
                        sum += (d / s) * (d / s);
                    }
                }
            }
            let size = (sum / (3 * n).max(1) as f64).sqrt();
            if !size.is_finite() {
                return Ok(Newton::NotFinite);
            }
            if k > 0 {
                let rate = size / last;
                self.contraction = rate;
                if rate < 0.99 {
                    eta = rate / (1.0 - rate);
                    if eta * size * rate.powi((MAX_ITERATIONS - 1 - k) as i32) > kappa {
                        return Ok(Newton::Diverged);
                    }
                } else if size > kappa {
                    return Ok(Newton::Diverged);
                }
            }
            last = size;
            for j in 0..core {
                self.tz[j] += self.w[j];
                self.tz[n + j] += self.complex[j].re;
                self.tz[2 * n + j] += self.complex[j].im;
                let w = [self.tz[j], self.tz[n + j], self.tz[2 * n + j]];
                for (i, row) in T.iter().enumerate() {
                    self.z[i * n + j] = row[0] * w[0] + row[1] * w[1] + row[2] * w[2];
                }
            }
            if eta * size <= kappa || size == 0.0 {
                self.eta = eta;
                return Ok(Newton::Converged { iterations: k + 1 });
            }
        }
        Ok(Newton::Diverged)
    }

    /// Increments of the integrals, from their rates at the stages; the last of these stay in `f1`. `false` where one is not finite.
    fn integrate<S: StiffOde + ?Sized>(&mut self, system: &mut S, h: f64, work: &mut Work) -> Result<bool, Failure> {
        let (n, core) = (self.y0.len(), self.core);
        for i in 0..3 {
            let (t, f) = if i == 2 { (self.t1, &mut self.f1[..]) } else { (self.t0 + C[i] * h, &mut self.f[i * n..(i + 1) * n]) };
            for j in 0..n {
                self.w[j] = self.y0[j] + self.z[i * n + j];
            }
            if !evaluate(system, t, &self.w, f, work)? {
                return Ok(false);
            }
        }
        for j in core..n {
            let f = [self.f[j], self.f[n + j], self.f1[j]];
            for (i, a) in A.iter().enumerate() {
                self.z[i * n + j] = h * (a[0] * f[0] + a[1] * f[1] + a[2] * f[2]);
            }
            self.y1[j] = self.y0[j] + self.z[2 * n + j];
        }
        Ok(finite(&self.y1))
    }

    /// Norm of (REAL/h I - J)^-1 (M^-1 f(t0, y0) + sum E_i Z_i / h), filtered once more where it rejects after a rejection or at the start.
    fn error<S: StiffOde + ?Sized>(&mut self, system: &mut S, h: f64, work: &mut Work) -> Result<f64, Failure> {
        let (n, real) = (self.y0.len(), REAL / h);
        for j in 0..n {
            self.w[j] = (E[0] * self.z[j] + E[1] * self.z[n + j] + E[2] * self.z[2 * n + j]) / -REAL;
        }
        self.error.copy_from_slice(&self.f0);
        system.solve_real_forces(real, &mut self.error, &self.w, &self.dense);
        let error = self.scale.norm2(&self.error, &self.y0, &self.y1);
        if error < 1.0 || !(self.first || self.after_rejection) {
            return Ok(error);
        }
        for (e, y) in self.error.iter_mut().zip(&self.y0) {
            *e += y;
        }
        let (f, scratch) = self.f.split_at_mut(n);
        let integrals = self.core == n || evaluate(system, self.t0, &self.error, f, work)?;
        if !(integrals && forces(system, self.t0, &self.error, (f, &mut scratch[..n]), self.core, work)?) {
            return Ok(error);
        }
        self.error.copy_from_slice(f);
        system.solve_real_forces(real, &mut self.error, &self.w, &self.dense);
        Ok(self.scale.norm2(&self.error, &self.y0, &self.y1))
    }

    fn rejected(&mut self, factor: f64, cause: Cause) -> Result<Attempt, Failure> {
        self.after_rejection = true;
        Ok(Attempt::Rejected { factor, cause })
    }

    /// The collocation polynomial in the form of [`Step`].
    fn extend(&mut self) {
        let n = self.y0.len();
        for j in 0..n {
            let (z1, z2, z3) = (self.z[j], self.z[n + j], self.z[2 * n + j]);
            let g1 = (z1 / C[0] - z3) / (1.0 - C[0]);
            let g2 = (z2 / C[1] - z3) / (1.0 - C[1]);
            let d = (g2 - g1) / (C[1] - C[0]);
            self.rows[j] = z3;
            self.rows[n + j] = g1 - C[0] * d;
            self.rows[2 * n + j] = d;
        }
    }
}

impl<S: StiffOde + ?Sized> Method<S> for Radau {
    fn begin(
        &mut self,
        system: &mut S,
        (t0, t1): (f64, f64),
        y: &[f64],
        control: &Control,
        work: &mut Work,
    ) -> Result<Option<f64>, Failure> {
        let n = y.len();
        self.core = n - system.integrals();
        self.scale.load(control, n)?;
        let mut finest = f64::INFINITY;
        for (r, a) in self.scale.rel.iter_mut().zip(&mut self.scale.abs) {
            if *r > 0.0 {
                let transformed = 0.1 * r.powf(2.0 / 3.0);
                *a *= transformed / *r;
                *r = transformed;
                finest = finest.min(transformed);
            }
        }
        self.kappa = self.newton_tolerance.unwrap_or_else(|| if finest.is_finite() { finest.sqrt().min(0.03) } else { 1e-3 });
        for (v, rows) in [
            (&mut self.y0, 1),
            (&mut self.y1, 1),
            (&mut self.f0, 1),
            (&mut self.f1, 1),
            (&mut self.w, 1),
            (&mut self.error, 1),
            (&mut self.z, 3),
            (&mut self.tz, 3),
            (&mut self.f, 3),
            (&mut self.rows, 3),
        ] {
            refill(v, rows * n, 0.0);
        }
        refill(&mut self.complex, n, c(0.0, 0.0));
        refill(&mut self.transformed, n, c(0.0, 0.0));
        self.y0.copy_from_slice(y);
        (self.last_length, self.factored, self.accepted) = (None, None, None);
        (self.linearised, self.fresh) = (false, false);
        (self.first, self.after_rejection) = (true, false);
        (self.eta, self.contraction) = (1.0, 0.0);
        if !evaluate(system, t0, y, &mut self.f0, work)? {
            return Ok(None);
        }
        let first = match control.first_step {
            Some(h) => h,
            None => self.scale.first_step(system, (t0, t1 - t0), 3.0, y, &self.f0, &mut self.w, &mut self.f1, work)?,
        };
        Ok(forces(system, t0, y, (&mut self.f0, &mut self.w), self.core, work)?.then_some(first))
    }

    fn attempt(&mut self, system: &mut S, (t, t1): (f64, f64), _dense: bool, work: &mut Work) -> Result<Attempt, Failure> {
        let (n, h) = (self.y0.len(), t1 - t);
        (self.t0, self.t1) = (t, t1);
        let iterations = loop {
            if !self.linearised {
                work.jacobians += 1;
                system.linearise(t, &self.y0, &mut self.dense)?;
                (self.linearised, self.fresh, self.factored) = (true, true, None);
            }
            if self.factored.is_none_or(|f| (h - f).abs() > SAME_LENGTH * f.abs()) {
                work.factorisations += 1;
                self.factored = None;
                if system.factor(REAL / h, c(COMPLEX.re / h, COMPLEX.im / h), &mut self.dense).is_err() {
                    return self.rejected(0.5, Cause::Singular);
                }
                self.factored = Some(h);
            }
            let cause = match self.newton(system, h, work)? {
                Newton::Converged { iterations } => break iterations,
                Newton::Diverged => Cause::Newton,
                Newton::NotFinite => Cause::NotFinite,
            };
            self.eta = 1.0;
            if self.fresh {
                return self.rejected(if cause == Cause::Newton { 0.5 } else { 0.2 }, cause);
            }
            self.linearised = false;
        };
        for j in 0..n {
            self.y1[j] = self.y0[j] + self.z[2 * n + j];
        }
        if !finite(&self.y1) || self.core < n && !self.integrate(system, h, work)? {
            return self.rejected(0.2, Cause::NotFinite);
        }
        let error = self.error(system, h, work)?;
        let safety = 0.9 * (1 + 2 * MAX_ITERATIONS) as f64 / (iterations + 2 * MAX_ITERATIONS) as f64;
        let mut factor = if error == 0.0 { MAX_FACTOR } else { safety * error.powf(-0.25) };
        // a NaN must reject
        if error.is_nan() || error >= 1.0 {
            let factor = if self.first { 0.1 } else { factor.clamp(MIN_FACTOR, 0.9) };
            return self.rejected(if factor.is_nan() { MIN_FACTOR } else { factor }, Cause::Error);
        }
        if !forces(system, t1, &self.y1, (&mut self.f1, &mut self.w), self.core, work)? {
            return self.rejected(0.2, Cause::NotFinite);
        }
        // the predictive controller of Gustafsson
        if let Some((length, before)) = self.accepted.filter(|_| error > 0.0) {
            factor = factor.min(safety * (h / length).abs() * (before / (error * error)).powf(0.25));
        }
        self.accepted = Some((h, error.max(1e-2)));
        factor = factor.clamp(MIN_FACTOR, if self.after_rejection { 1.0 } else { MAX_FACTOR });
        if self.contraction > KEEP_JACOBIAN {
            self.linearised = false;
        } else if (1.0..=KEEP_LENGTH).contains(&factor) {
            factor = 1.0;
        }
        self.extend();
        self.last_length = Some(h);
        (self.first, self.after_rejection) = (false, false);
        Ok(Attempt::Accepted { factor })
    }

    fn step(&self) -> Step<'_> {
        Step { t0: self.t0, t1: self.t1, y0: &self.y0, y1: &self.y1, h: self.t1 - self.t0, rows: &self.rows }
    }

    fn advance(&mut self) {
        std::mem::swap(&mut self.y0, &mut self.y1);
        std::mem::swap(&mut self.f0, &mut self.f1);
        self.fresh = false;
    }
}
