//! Explicit Runge-Kutta method of order 8 of Dormand and Prince, 8(5,3), with a dense output of order 7.

use super::control::{Attempt, Cause, Control, Scale, Work, evaluate};
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
    y0: Blocks,
    y1: Blocks,
    w: Blocks,
    /// Tolerances; behind the states 1 and 0.
    absolute: Blocks,
    relative: Blocks,
    /// Stage after stage; stage 12 is f at the end of the step.
    k: Blocks,
    /// Of the interpolant, see [`Step`].
    rows: Vec<f64>,
    used_rows: usize,
    /// Logarithm of the previous error, not below [`LEAST_ERROR`].
    last_error: f64,
    after_rejection: bool,
    t0: f64,
    t1: f64,
}

/// States side by side: a register of the highest level.
const BLOCK: usize = 8;
type Block = [f64; BLOCK];

/// Blocks, each in a line of the cache of its own.
#[derive(Clone, Debug, Default)]
struct Blocks {
    numbers: Vec<f64>,
    first: usize,
}

impl Blocks {
    /// That many, of zeros.
    fn reset(&mut self, count: usize) {
        self.numbers.clear();
        self.numbers.resize((count + 1) * BLOCK, 0.0);
        self.first = self.numbers.as_ptr().align_offset(size_of::<Block>()).min(BLOCK);
    }
    #[inline(always)]
    fn get(&self) -> &[Block] {
        self.numbers[self.first..].as_chunks().0
    }
    #[inline(always)]
    fn get_mut(&mut self) -> &mut [Block] {
        self.numbers[self.first..].as_chunks_mut().0
    }
    fn numbers(&self) -> &[f64] {
        self.get().as_flattened()
    }
    fn numbers_mut(&mut self) -> &mut [f64] {
        self.get_mut().as_flattened_mut()
    }
}

/// Stages whose weights in the solution, in its error and in the interpolant are zero.
const LEFT_OUT: std::ops::RangeInclusive<usize> = 1..=4;

/// A step tried, from the first stage to the interpolant, with the instructions of the level. It gives the error norm, or nothing if a value was not
/// finite; beyond a norm of 1 nothing is done after it.
struct Trial<'a, S: ?Sized> {
    system: &'a mut S,
    work: &'a mut Work,
    dense: bool,
    /// Numbers of states, and of blocks of states in each of the following.
    n: usize,
    count: usize,
    t0: f64,
    t1: f64,
    h: f64,
    y0: &'a [Block],
    y1: &'a mut [Block],
    w: &'a mut [Block],
    absolute: &'a [Block],
    relative: &'a [Block],
    k: &'a mut [Block],
    rows: &'a mut [f64],
}

impl<S: Ode + ?Sized> Kernel for Trial<'_, S> {
    type Out = Result<Option<f64>, Failure>;
    #[inline(always)]
    fn run<L: LaneScalar>(mut self) -> Self::Out {
        match self.count {
            1 => self.step::<1>(),
            2 => self.step::<2>(),
            _ => self.step::<0>(),
        }
    }
}

/// `B` is the number of blocks, or 0 where it is known at run time only.
impl<S: Ode + ?Sized> Trial<'_, S> {
    #[inline(always)]
    fn count<const B: usize>(&self) -> usize {
        if B > 0 { B } else { self.count }
    }

    #[inline(always)]
    fn step<const B: usize>(&mut self) -> Result<Option<f64>, Failure> {
        let fine = self.stage::<B, _>(1, &t8::A1)?
            && self.stage::<B, _>(2, &t8::A2)?
            && self.stage::<B, _>(3, &t8::A3)?
            && self.stage::<B, _>(4, &t8::A4)?
            && self.stage::<B, _>(5, &t8::A5)?
            && self.stage::<B, _>(6, &t8::A6)?
            && self.stage::<B, _>(7, &t8::A7)?
            && self.stage::<B, _>(8, &t8::A8)?
            && self.stage::<B, _>(9, &t8::A9)?
            && self.stage::<B, _>(10, &t8::A10)?
            && self.stage::<B, _>(11, &t8::A11)?;
        if !fine {
            return Ok(None);
        }
        for at in 0..self.count::<B>() {
            self.y1[at] = plus(&self.y0[at], self.h, &self.sum::<B, _>(&t8::B, at));
        }
        if !finite(&self.y1[..self.count::<B>()]) {
            return Ok(None);
        }
        let error = self.error::<B>();
        // a NaN must reject
        if error.is_nan() || error >= 1.0 {
            return Ok(Some(error));
        }
        let fine = self.evaluate::<B>(12, self.t1)? && self.extend::<B>()?;
        Ok(fine.then_some(error))
    }

    /// `sum_m a_m k_m` of block `at`.
    #[inline(always)]
    fn sum<const B: usize, const N: usize>(&self, row: &Row<N>, at: usize) -> Block {
        let mut s = [0.0; BLOCK];
        for m in 0..N {
            let stage = &self.k[row[m].0 * self.count::<B>() + at];
            for l in 0..BLOCK {
                s[l] += row[m].1 * stage[l];
            }
        }
        s
    }

    /// Evaluates the right side at the state of the stage; `false` if a value is not finite.
    #[inline(always)]
    fn stage<const B: usize, const N: usize>(&mut self, i: usize, row: &Row<N>) -> Result<bool, Failure> {
        for at in 0..self.count::<B>() {
            self.w[at] = plus(&self.y0[at], self.h, &self.sum::<B, _>(row, at));
        }
        self.evaluate::<B>(i, self.t0 + t8::C[i] * self.h)
    }

    #[inline(always)]
    fn evaluate<const B: usize>(&mut self, i: usize, t: f64) -> Result<bool, Failure> {
        let (n, count) = (self.n, self.count::<B>());
        let state = if i == 12 { &*self.y1 } else { &*self.w };
        let stage = &mut self.k[i * count..][..count];
        self.work.rhs += 1;
        let (y, dy) = (&state.as_flattened()[..n], &mut stage.as_flattened_mut()[..n]);
        // no sum that ends in a result holds these stages, and no right side reads an integral
        let integrals = if LEFT_OUT.contains(&i) { self.system.integrals() } else { 0 };
        if integrals > 0 {
            self.system.rhs_without_integrals(t, y, dy)?;
            dy[n - integrals..].fill(0.0);
        } else {
            self.system.rhs(t, y, dy)?;
        }
        Ok(finite(stage))
    }

    /// The error norm of the formula 8(5,3), |h| e5^2 / sqrt(e5^2 + e3^2/100), from the squares of both estimates over their scales.
    #[inline(always)]
    fn error<const B: usize>(&self) -> f64 {
        let (mut e5, mut e3) = ([0.0; BLOCK], [0.0; BLOCK]);
        let per_h = 1.0 / self.h;
        for at in 0..self.count::<B>() {
            let (x5, bhh) = (self.sum::<B, _>(&t8::E5, at), self.sum::<B, _>(&t8::BHH, at));
            let (y0, y1, absolute, relative) = (&self.y0[at], &self.y1[at], &self.absolute[at], &self.relative[at]);
            for l in 0..BLOCK {
                let (a, b) = (y0[l].abs(), y1[l].abs());
                let x3 = (y1[l] - y0[l]) * per_h - bhh[l];
                let scale = 1.0 / (absolute[l] + relative[l] * if a < b { b } else { a });
                // a zero entry counts as zero whatever its scale
                e5[l] += if x5[l] == 0.0 { 0.0 } else { (x5[l] * scale) * (x5[l] * scale) };
                e3[l] += if x3 == 0.0 { 0.0 } else { (x3 * scale) * (x3 * scale) };
            }
        }
        let (e5, e3) = (total(&e5), total(&e3));
        if e5 == 0.0 { 0.0 } else { self.h.abs() * e5 / ((e5 + 0.01 * e3) * self.n as f64).sqrt() }
    }

    /// The cubic rows from both ends, and where requested the rows of degree 4 to 7.
    #[inline(always)]
    fn extend<const B: usize>(&mut self) -> Result<bool, Failure> {
        let (n, count, h) = (self.n, self.count::<B>(), self.h);
        let (y0, y1, k) = (self.y0.as_flattened(), self.y1.as_flattened(), self.k.as_flattened());
        let f_end = &k[12 * count * BLOCK..];
        for j in 0..n {
            let (f0, f1, d) = (h * k[j], h * f_end[j], y1[j] - y0[j]);
            self.rows[j] = d;
            self.rows[n + j] = f0 - d;
            self.rows[2 * n + j] = d - f1 - (f0 - d);
        }
        if !self.dense {
            return Ok(true);
        }
        let fine = self.stage::<B, _>(13, &t8::A13)? && self.stage::<B, _>(14, &t8::A14)? && self.stage::<B, _>(15, &t8::A15)?;
        for (i, row) in [&t8::D3, &t8::D4, &t8::D5, &t8::D6].into_iter().enumerate() {
            for at in 0..count {
                self.w[at] = plus(&[0.0; BLOCK], h, &self.sum::<B, _>(row, at));
            }
            self.rows[(3 + i) * n..][..n].copy_from_slice(&self.w.as_flattened()[..n]);
        }
        Ok(fine)
    }
}

/// `y + h s`.
#[inline(always)]
fn plus(y: &Block, h: f64, s: &Block) -> Block {
    let mut out = *y;
    for l in 0..BLOCK {
        out[l] += h * s[l];
    }
    out
}

#[inline(always)]
fn total(x: &Block) -> f64 {
    ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]))
}

#[inline(always)]
fn finite(x: &[Block]) -> bool {
    let mut bad = false;
    for block in x {
        for l in 0..BLOCK {
            bad |= !block[l].is_finite();
        }
    }
    !bad
}

impl Dop853 {
    /// Empty storage.
    pub fn new() -> Self {
        Dop853 {
            n: 0,
            level: Level::Base,
            scale: Scale::default(),
            y0: Blocks::default(),
            y1: Blocks::default(),
            w: Blocks::default(),
            absolute: Blocks::default(),
            relative: Blocks::default(),
            k: Blocks::default(),
            rows: vec![],
            used_rows: 0,
            last_error: LEAST_ERROR,
            after_rejection: false,
            t0: 0.0,
            t1: 0.0,
        }
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
        let count = n.div_ceil(BLOCK);
        (self.n, self.level) = (n, Level::best());
        for blocks in [&mut self.y0, &mut self.y1, &mut self.w, &mut self.absolute, &mut self.relative] {
            blocks.reset(count);
        }
        self.k.reset(STAGES * count);
        self.rows.clear();
        self.rows.resize(ROWS * n, 0.0);
        self.y0.numbers_mut()[..n].copy_from_slice(y);
        self.absolute.numbers_mut().fill(1.0);
        self.absolute.numbers_mut()[..n].copy_from_slice(&self.scale.abs);
        self.relative.numbers_mut()[..n].copy_from_slice(&self.scale.rel);
        (self.last_error, self.after_rejection) = (LEAST_ERROR, false);
        let (f0, f1) = self.k.numbers_mut().split_at_mut(count * BLOCK);
        if !evaluate(system, t0, y, &mut f0[..n], work)? {
            return Ok(None);
        }
        if let Some(h) = control.first_step {
            return Ok(Some(h));
        }
        let w = &mut self.w.numbers_mut()[..n];
        self.scale.first_step(system, (t0, t1 - t0), 7.0, y, &f0[..n], w, &mut f1[..n], work).map(Some)
    }

    fn attempt(&mut self, system: &mut S, (t0, t1): (f64, f64), dense: bool, work: &mut Work) -> Result<Attempt, Failure> {
        (self.t0, self.t1) = (t0, t1);
        let h = t1 - t0;
        let mut times = [t1; 12];
        for (time, c) in times.iter_mut().zip(&t8::C[1..12]) {
            *time = t0 + c * h;
        }
        system.ahead(&times);
        let trial = Trial {
            system,
            work,
            dense,
            n: self.n,
            count: self.n.div_ceil(BLOCK),
            t0,
            t1,
            h,
            y0: self.y0.get(),
            y1: self.y1.get_mut(),
            w: self.w.get_mut(),
            absolute: self.absolute.get(),
            relative: self.relative.get(),
            k: self.k.get_mut(),
            rows: &mut self.rows,
        };
        let Some(error) = dispatch(self.level, trial)? else {
            self.after_rejection = true;
            return Ok(Attempt::not_finite());
        };
        let log = error.ln();
        let needed = (1.0 / 8.0 - 0.2 * BETA) * log;
        if error.is_nan() || error >= 1.0 {
            self.after_rejection = true;
            let factor = if needed.is_finite() { (SAFETY * (-needed).exp()).max(MIN_FACTOR) } else { MIN_FACTOR };
            return Ok(Attempt::Rejected { factor, cause: Cause::Error });
        }
        self.used_rows = if dense { ROWS } else { 3 };
        let most = if self.after_rejection { 1.0 } else { MAX_FACTOR };
        let factor = (SAFETY * (BETA * self.last_error - needed).exp()).clamp(MIN_FACTOR, most);
        self.last_error = log.max(LEAST_ERROR);
        self.after_rejection = false;
        Ok(Attempt::Accepted { factor })
    }

    fn step(&self) -> Step<'_> {
        let n = self.n;
        let (y0, y1) = (&self.y0.numbers()[..n], &self.y1.numbers()[..n]);
        Step { t0: self.t0, t1: self.t1, y0, y1, h: self.t1 - self.t0, rows: &self.rows[..self.used_rows * n] }
    }

    fn advance(&mut self) {
        let count = self.n.div_ceil(BLOCK);
        std::mem::swap(&mut self.y0, &mut self.y1);
        self.k.get_mut().copy_within(12 * count..13 * count, 0);
    }
}
