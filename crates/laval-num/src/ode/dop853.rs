//! Explicit Runge-Kutta method of order 8 of Dormand and Prince, 8(5,3), with a dense output of order 7.

use super::control::{Attempt, Cause, Control, Scale, Work, evaluate, finite};
use super::driver::Method;
use super::step::Step;
use super::system::{Failure, Ode};
use super::tableau::{self as t8, Row};
use crate::lanes::{Kernel, LaneScalar, Level, dispatch};

const STAGES: usize = 16;
const ROWS: usize = 7;
/// Exponent of the previous error in the step control (PI control); the present error has 1/8 - BETA/5.
const BETA: f64 = 0.04;
/// Logarithm of the least previous error that counts, 1e-4.
const LEAST_ERROR: f64 = -9.210_340_371_976_182;
const SAFETY: f64 = 0.9;
const MIN_FACTOR: f64 = 1.0 / 3.0;
const MAX_FACTOR: f64 = 6.0;

/// Explicit method of order 8 for problems that are not stiff: 12 evaluations of the right side a step, 15 where the solution inside the step
/// is wanted. The object is its storage; reuse it to avoid allocation.
#[derive(Clone, Debug)]
pub struct Dop853 {
    /// Number of states; they are stored in whole blocks, whose rest stays zero.
    n: usize,
    level: Level,
    scale: Scale,
    y0: Vec<f64>,
    y1: Vec<f64>,
    w: Vec<f64>,
    zero: Vec<f64>,
    /// Stage after stage; stage 12 is f at the end of the step.
    k: Vec<f64>,
    rows: Vec<f64>,
    used_rows: usize,
    /// Logarithm of the previous error, not below [`LEAST_ERROR`].
    last_error: f64,
    after_rejection: bool,
    t0: f64,
    t1: f64,
}

/// States side by side in a combination: a register of the highest level.
const BLOCK: usize = 8;

/// `out = y + h sum_m a_m k_m`, in whole blocks; `k` holds stages of the length of `out`.
struct Combine<'a, const N: usize> {
    out: &'a mut [f64],
    y: &'a [f64],
    h: f64,
    k: &'a [f64],
    row: &'a Row<N>,
}

impl<const N: usize> Kernel for Combine<'_, N> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let len = self.out.len();
        for at in (0..len).step_by(BLOCK) {
            let s = block_sum(self.k, len, self.row, at);
            let (out, y) = (&mut self.out[at..at + BLOCK], &self.y[at..at + BLOCK]);
            for l in 0..BLOCK {
                out[l] = y[l] + self.h * s[l];
            }
        }
    }
}

/// `sum_m a_m k_m` of the block of states that begins at `at`: every other term in a sum of its own, which a processor adds up side by side, the last
/// stage last.
#[inline(always)]
fn block_sum<const N: usize>(k: &[f64], len: usize, row: &Row<N>, at: usize) -> [f64; BLOCK] {
    let mut sums = [[0.0; BLOCK]; 2];
    for m in 0..N {
        let stage = &k[row[m].0 * len + at..][..BLOCK];
        for l in 0..BLOCK {
            sums[(N - m) % 2][l] += row[m].1 * stage[l];
        }
    }
    let [mut s, last] = sums;
    for l in 0..BLOCK {
        s[l] += last[l];
    }
    s
}

/// Sums over the states of the squares of both error estimates over their scales.
struct Estimates<'a>(&'a Dop853, f64);

impl Kernel for Estimates<'_> {
    type Out = [f64; 2];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> [f64; 2] {
        let Estimates(d, h) = self;
        let len = d.y0.len();
        let mut totals = [0.0, 0.0];
        for at in (0..len).step_by(BLOCK) {
            let (e5, bhh) = (block_sum(&d.k, len, &t8::E5, at), block_sum(&d.k, len, &t8::BHH, at));
            for l in 0..BLOCK.min(d.n - at) {
                let (y0, y1) = (d.y0[at + l], d.y1[at + l]);
                let scale = d.scale.at(at + l, y0.abs().max(y1.abs()));
                for (total, e) in totals.iter_mut().zip([e5[l], (y1 - y0) / h - bhh[l]]) {
                    // a zero entry counts as zero whatever its scale
                    if e != 0.0 {
                        *total += (e / scale) * (e / scale);
                    }
                }
            }
        }
        totals
    }
}

impl Dop853 {
    /// Empty storage.
    pub fn new() -> Self {
        let none = Vec::new;
        Dop853 {
            n: 0,
            level: Level::Base,
            scale: Scale::default(),
            y0: none(),
            y1: none(),
            w: none(),
            zero: none(),
            k: none(),
            rows: none(),
            used_rows: 0,
            last_error: LEAST_ERROR,
            after_rejection: false,
            t0: 0.0,
            t1: 0.0,
        }
    }

    fn stage<S: Ode + ?Sized, const N: usize>(
        &mut self,
        system: &mut S,
        i: usize,
        row: &Row<N>,
        h: f64,
        work: &mut Work,
    ) -> Result<bool, Failure> {
        let (n, len) = (self.n, self.y0.len());
        dispatch(self.level, Combine { out: &mut self.w, y: &self.y0, h, k: &self.k, row });
        evaluate(system, self.t0 + t8::C[i] * h, &self.w[..n], &mut self.k[i * len..][..n], work)
    }

    /// The error norm of the formula 8(5,3): |h| e5^2 / sqrt(e5^2 + e3^2/100).
    fn error(&self, h: f64) -> f64 {
        let [e5, e3] = dispatch(self.level, Estimates(self, h));
        if e5 == 0.0 { 0.0 } else { h.abs() * e5 / ((e5 + 0.01 * e3) * self.n as f64).sqrt() }
    }

    /// The cubic rows from both ends, and with `dense` the rows of degree 4 to 7.
    fn extend<S: Ode + ?Sized>(&mut self, system: &mut S, h: f64, dense: bool, work: &mut Work) -> Result<bool, Failure> {
        let (n, len) = (self.n, self.y0.len());
        for j in 0..n {
            let (f0, f1, d) = (h * self.k[j], h * self.k[12 * len + j], self.y1[j] - self.y0[j]);
            self.rows[j] = d;
            self.rows[n + j] = f0 - d;
            self.rows[2 * n + j] = d - f1 - (f0 - d);
        }
        self.used_rows = 3;
        if !dense {
            return Ok(true);
        }
        let fine = self.stage(system, 13, &t8::A13, h, work)?
            && self.stage(system, 14, &t8::A14, h, work)?
            && self.stage(system, 15, &t8::A15, h, work)?;
        if !fine {
            return Ok(false);
        }
        self.zero.resize(len, 0.0);
        for (i, row) in [&t8::D3, &t8::D4, &t8::D5, &t8::D6].into_iter().enumerate() {
            dispatch(self.level, Combine { out: &mut self.w, y: &self.zero, h, k: &self.k, row });
            self.rows[(3 + i) * n..(4 + i) * n].copy_from_slice(&self.w[..n]);
        }
        self.used_rows = ROWS;
        Ok(true)
    }
}

impl Default for Dop853 {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Ode + ?Sized> Method<S> for Dop853 {
    fn begin(
        &mut self,
        system: &mut S,
        (t0, t1): (f64, f64),
        y: &[f64],
        control: &Control,
        work: &mut Work,
    ) -> Result<Option<f64>, Failure> {
        let n = y.len();
        self.scale.load(control, n)?;
        let len = n.next_multiple_of(BLOCK);
        (self.n, self.level) = (n, Level::best());
        for (v, len) in
            [(&mut self.y0, len), (&mut self.y1, len), (&mut self.w, len), (&mut self.k, STAGES * len), (&mut self.rows, ROWS * n)]
        {
            v.clear();
            v.resize(len, 0.0);
        }
        self.y0[..n].copy_from_slice(y);
        (self.last_error, self.after_rejection) = (LEAST_ERROR, false);
        if !evaluate(system, t0, y, &mut self.k[..n], work)? {
            return Ok(None);
        }
        if let Some(h) = control.first_step {
            return Ok(Some(h));
        }
        let (f0, f1) = self.k.split_at_mut(len);
        self.scale.first_step(system, (t0, t1 - t0), 7.0, y, &f0[..n], &mut self.w[..n], &mut f1[..n], work).map(Some)
    }

    fn attempt(&mut self, system: &mut S, (t, t1): (f64, f64), dense: bool, work: &mut Work) -> Result<Attempt, Failure> {
        let (n, len, h) = (self.n, self.y0.len(), t1 - t);
        (self.t0, self.t1) = (t, t1);
        let mut times = [t1; 12];
        for (time, c) in times.iter_mut().zip(&t8::C[1..12]) {
            *time = t + c * h;
        }
        system.ahead(&times);
        let fine = self.stage(system, 1, &t8::A1, h, work)?
            && self.stage(system, 2, &t8::A2, h, work)?
            && self.stage(system, 3, &t8::A3, h, work)?
            && self.stage(system, 4, &t8::A4, h, work)?
            && self.stage(system, 5, &t8::A5, h, work)?
            && self.stage(system, 6, &t8::A6, h, work)?
            && self.stage(system, 7, &t8::A7, h, work)?
            && self.stage(system, 8, &t8::A8, h, work)?
            && self.stage(system, 9, &t8::A9, h, work)?
            && self.stage(system, 10, &t8::A10, h, work)?
            && self.stage(system, 11, &t8::A11, h, work)?;
        if fine {
            dispatch(self.level, Combine { out: &mut self.y1, y: &self.y0, h, k: &self.k, row: &t8::B });
        }
        if !fine || !finite(&self.y1) {
            self.after_rejection = true;
            return Ok(Attempt::not_finite());
        }
        let error = self.error(h);
        let log = error.ln();
        let needed = (1.0 / 8.0 - 0.2 * BETA) * log;
        // a NaN must reject
        if error.is_nan() || error >= 1.0 {
            self.after_rejection = true;
            let factor = if needed.is_finite() { (SAFETY * (-needed).exp()).max(MIN_FACTOR) } else { MIN_FACTOR };
            return Ok(Attempt::Rejected { factor, cause: Cause::Error });
        }
        let fine = evaluate(system, t1, &self.y1[..n], &mut self.k[12 * len..][..n], work)? && self.extend(system, h, dense, work)?;
        if !fine {
            self.after_rejection = true;
            return Ok(Attempt::not_finite());
        }
        let most = if self.after_rejection { 1.0 } else { MAX_FACTOR };
        let factor = (SAFETY * (BETA * self.last_error - needed).exp()).clamp(MIN_FACTOR, most);
        self.last_error = log.max(LEAST_ERROR);
        self.after_rejection = false;
        Ok(Attempt::Accepted { factor })
    }

    fn step(&self) -> Step<'_> {
        let n = self.n;
        let (y0, y1) = (&self.y0[..n], &self.y1[..n]);
        Step { t0: self.t0, t1: self.t1, y0, y1, h: self.t1 - self.t0, rows: &self.rows[..self.used_rows * n] }
    }

    fn advance(&mut self) {
        let len = self.y0.len();
        std::mem::swap(&mut self.y0, &mut self.y1);
        self.k.copy_within(12 * len..13 * len, 0);
    }
}
