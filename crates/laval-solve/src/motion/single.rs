//! One member of constant mass at constant speed and without memory: y' = A y + B (1, cos, sin, forces of the nonlinear parts), summed column by
//! column, so that the rates of all states go side by side.

use super::compiled::Compiled;
use crate::model::erased::Erased;
use crate::model::lanes::{Residual, ResidualArgs};
use crate::model::part::{At, Rows};
use crate::model::system::System;
use laval_num::dense::Mat;
use laval_num::lanes::{Entry, Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::ode::Failure;
use laval_num::scalar::Scalar;
use std::f64::consts::FRAC_2_PI;
use std::ops::Range;

/// Rates side by side: a register of the highest level.
const BLOCK: usize = 8;

/// A block in a line of the cache.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Block([f64; BLOCK]);

/// A matrix by columns: of each column the blocks that are not zero.
struct Columns {
    /// Number of columns.
    width: usize,
    /// Where the entries of each block of rows begin, and the end of the last.
    start: Vec<usize>,
    /// Columns, below `width`, and their numbers in the block.
    column: Vec<usize>,
    block: Vec<Block>,
}

impl Columns {
    fn of(full: &Mat) -> Self {
        let mut to = Columns { width: full.cols(), start: vec![0], column: vec![], block: vec![] };
        for first in (0..full.rows()).step_by(BLOCK) {
            for j in 0..full.cols() {
                let entry = |l: usize| if first + l < full.rows() { full[(first + l, j)] } else { 0.0 };
                let block: [f64; BLOCK] = std::array::from_fn(entry);
                // NaN is an entry
                if block.iter().any(|&x| x != 0.0) {
                    to.column.push(j);
                    to.block.push(Block(block));
                }
            }
            to.start.push(to.column.len());
        }
        to
    }

    /// Block `at` of the matrix times `x`, every other column in a sum of its own.
    ///
    /// # Panics
    /// On a vector shorter than the matrix is wide.
    #[inline(always)]
    fn times(&self, at: usize, x: &[f64]) -> [f64; BLOCK] {
        assert!(x.len() >= self.width);
        let span = self.start[at]..self.start[at + 1];
        let (columns, blocks) = (&self.column[span.clone()], &self.block[span]);
        let mut sums = [[0.0; BLOCK]; 2];
        let (pairs, rest) = columns.as_chunks::<2>();
        for (pair, of) in pairs.iter().zip(blocks.as_chunks::<2>().0) {
            // SAFETY: columns are below the width
            let [a, b] = unsafe { [*x.get_unchecked(pair[0]), *x.get_unchecked(pair[1])] };
            for l in 0..BLOCK {
                sums[0][l] += of[0].0[l] * a;
                sums[1][l] += of[1].0[l] * b;
            }
        }
        if let (&[i], Some(of)) = (rest, blocks.last()) {
            for l in 0..BLOCK {
                sums[1][l] += of.0[l] * x[i];
            }
        }
        for l in 0..BLOCK {
            sums[0][l] += sums[1][l];
        }
        sums[0]
    }
}

/// A nonlinear part in its place.
struct Law<'a> {
    part: &'a dyn Erased,
    params: Vec<f64>,
    /// Its coordinates among those of all parts; its rates follow.
    local: Range<usize>,
    /// Its forces among the terms.
    forces: Range<usize>,
    /// Its states in y, and their rates.
    states: Range<usize>,
    rates: Vec<f64>,
    /// Ratio of its spin.
    ratio: f64,
}

/// Sines and cosines of the phase at times to come, all computed side by side.
#[derive(Default)]
struct Ahead {
    times: [f64; LANES],
    sin: [f64; LANES],
    cos: [f64; LANES],
    count: usize,
    next: usize,
}

struct Sines<'a> {
    quarters: (f64, f64),
    to: &'a mut Ahead,
}

impl Kernel for Sines<'_> {
    type Out = ();
    #[inline(always)]
    fn run<L: LaneScalar>(self) {
        let phases = L::cst(self.quarters.0) + L::cst(self.quarters.1) * L::load(&self.to.times);
        let (sin, cos) = phases.sin_cos_quarters();
        sin.store(&mut self.to.sin);
        cos.store(&mut self.to.cos);
    }
}

/// The machine at one speed; see the [module](self).
pub(super) struct Single<'a> {
    /// Number of states.
    dim: usize,
    /// Coordinates and rates of the nonlinear parts from the states, and these.
    locals: Columns,
    local: Vec<[f64; BLOCK]>,
    states: Columns,
    terms: Columns,
    /// 1, cosine and sine of the phase of each spin, forces of the nonlinear parts.
    x: Vec<f64>,
    /// Ratios of the other spins that turn loads.
    others: Vec<f64>,
    laws: Vec<Law<'a>>,
    /// Accelerations of a part: one that reads them has a mass that varies.
    zero: Vec<f64>,
    speed: f64,
    phase: f64,
    ahead: Ahead,
    level: Level,
}

impl<'a> Single<'a> {
    /// The machine at a speed from a phase at time 0.
    pub fn new(system: &'a System, speed: f64, phase: f64) -> Result<Self, Failure> {
        let compiled = Compiled::new(system, speed)?;
        let (n, dim) = (system.n(), 2 * system.n() + system.m());
        // the row of each rate, accelerations first
        let row: Vec<usize> = (n..2 * n).chain(compiled.model.states().iter().map(|z| 2 * n + z)).collect();
        let mut states = Mat::zeros(dim, dim);
        for i in 0..n {
            states[(i, n + i)] = 1.0;
        }
        for (j, column) in (0..2 * n).chain(compiled.model.states().iter().map(|z| 2 * n + z)).enumerate() {
            for (i, &row) in row.iter().enumerate() {
                states[(row, column)] = compiled.columns[(j, i)];
            }
        }
        let nonlinear = || system.slots().iter().filter(|s| !s.is_linear());
        let mut locals = Mat::zeros(nonlinear().map(|s| 2 * s.map.len()).sum(), 2 * n);
        // constant, cosine and sine of the phase of each spin, then the forces of the nonlinear parts
        let head = compiled.forcing.len();
        let (mut laws, mut answers, mut first) = (vec![], vec![], head);
        for slot in nonlinear() {
            let (own, count) = (2 * (first - head), slot.map.len());
            for (l, coordinate) in slot.map.iter().enumerate() {
                for &(g, c) in coordinate {
                    locals[(own + l, g)] += c;
                    if slot.uses.velocity {
                        locals[(own + count + l, n + g)] += c;
                    }
                }
                answers.push(compiled.answer(coordinate));
            }
            laws.push(Law {
                part: &*slot.part,
                params: system.params()[slot.params.clone()].to_vec(),
                local: own..own + count,
                forces: first..first + count,
                states: 2 * n + slot.states.start..2 * n + slot.states.end,
                rates: vec![0.0; slot.states.len()],
                ratio: slot.torque(system.params(), 1.0),
            });
            first += count;
        }
        let mut terms = Mat::zeros(dim, first);
        for (j, column) in compiled.forcing.iter().chain(&answers).enumerate() {
            for (&row, &x) in row.iter().zip(column) {
                terms[(row, j)] = x;
            }
        }
        let mut x = vec![0.0; first];
        x[0] = 1.0;
        Ok(Single {
            dim,
            local: vec![[0.0; BLOCK]; locals.rows().div_ceil(BLOCK)],
            locals: Columns::of(&locals),
            states: Columns::of(&states),
            terms: Columns::of(&terms),
            x,
            others: compiled.others.clone(),
            zero: vec![0.0; first],
            laws,
            speed,
            phase,
            ahead: Ahead::default(),
            level: Level::best(),
        })
    }

    /// Number of states.
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// Prepares for times to come; of more than a register holds, for the first.
    pub fn ahead(&mut self, times: &[f64]) {
        let count = times.len().min(LANES);
        self.ahead.times[..count].copy_from_slice(&times[..count]);
        (self.ahead.count, self.ahead.next) = (count, 0);
        let quarters = (self.phase * FRAC_2_PI, self.speed * FRAC_2_PI);
        dispatch(self.level, Sines { quarters, to: &mut self.ahead });
    }

    /// Sine and cosine of the phase, from what was prepared if the next time is this one.
    #[inline(always)]
    fn sine(&mut self, t: f64) -> (f64, f64) {
        let i = self.ahead.next;
        if i < self.ahead.count && self.ahead.times[i] == t {
            self.ahead.next = i + 1;
            return (self.ahead.sin[i], self.ahead.cos[i]);
        }
        (self.phase * FRAC_2_PI + self.speed * FRAC_2_PI * t).sin_cos_quarters()
    }

    /// Rates of all states, `y` and `dy` of their number.
    pub fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        dispatch(self.level, Rates { of: self, t, y, dy });
    }

    #[inline(always)]
    fn rates(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        let (sin, cos) = self.sine(t);
        (self.x[1], self.x[2]) = (cos, sin);
        for (k, ratio) in self.others.iter().enumerate() {
            let phase = ratio * (self.phase + self.speed * t);
            (self.x[4 + 2 * k], self.x[3 + 2 * k]) = Scalar::sin_cos(phase);
        }
        for at in 0..self.local.len() {
            self.local[at] = self.locals.times(at, y);
        }
        let local = self.local.as_flattened();
        for law in &mut self.laws {
            let (q, v) = local[law.local.start..].split_at(law.local.len());
            let force = &mut self.x[law.forces.clone()];
            clear(force);
            clear(&mut law.rates);
            let (mut spin, phase) = (0.0, law.ratio * (self.phase + self.speed * t));
            let z = &y[law.states.clone()];
            let mut args = ResidualArgs {
                p: &law.params,
                at: At { q, v: &v[..q.len()], a: &self.zero[..q.len()], z, phase, speed: law.ratio * self.speed, spin_accel: 0.0, t },
                out: Rows { force, rate: &mut law.rates, spin: &mut spin },
            };
            f64::enter::<Residual, _>(law.part, &mut args);
        }
        let (whole, rest) = dy.as_chunks_mut::<BLOCK>();
        for at in 0..whole.len() {
            whole[at] = self.sum(at, y);
        }
        if !rest.is_empty() {
            rest.copy_from_slice(&self.sum(whole.len(), y)[..rest.len()]);
        }
        for law in &self.laws {
            for (dy, rate) in dy[law.states.clone()].iter_mut().zip(&law.rates) {
                *dy += rate;
            }
        }
    }

    /// A block of the rates of all states but those of nonlinear parts.
    #[inline(always)]
    fn sum(&self, at: usize, y: &[f64]) -> [f64; BLOCK] {
        let (mut sum, terms) = (self.states.times(at, y), self.terms.times(at, &self.x));
        for l in 0..BLOCK {
            sum[l] += terms[l];
        }
        sum
    }
}

struct Rates<'a, 's> {
    of: &'a mut Single<'s>,
    t: f64,
    y: &'a [f64],
    dy: &'a mut [f64],
}

impl Kernel for Rates<'_, '_> {
    type Out = ();
    #[inline(always)]
    fn run<L: LaneScalar>(self) {
        self.of.rates(self.t, self.y, self.dy);
    }
}

/// Clears a few numbers.
#[inline(always)]
pub(super) fn clear<S: Scalar>(x: &mut [S]) {
    // a zero known to the compiler would become a call, which costs more than they
    let zero = S::cst(std::hint::black_box(0.0));
    for x in x {
        *x = zero;
    }
}
