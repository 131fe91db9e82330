//! One member, or those in lanes, of constant mass at constant speeds and without memory: the linear parts as one sparse matrix, and a call for
//! each nonlinear part.

use super::compiled::Compiled;
use crate::model::erased::Erased;
use crate::model::lanes::{Residual, ResidualArgs};
use crate::model::part::{At, Rows};
use crate::model::system::System;
use laval_num::dense::Mat;
use laval_num::lanes::{Entry, Kernel, LANES, LaneScalar, Level, Sparse, dispatch};
use laval_num::ode::Failure;
use std::f64::consts::FRAC_2_PI;
use std::ops::Range;

/// A nonlinear part in its place.
struct Law<'a, S> {
    slot: usize,
    part: &'a dyn Erased,
    params: Vec<S>,
    /// Local coordinates and (if it reads them) rates, from the state.
    map: Sparse<S>,
    local: Vec<S>,
    /// What the weight adds to local accelerations.
    weight: Vec<S>,
    /// Where its forces stand among the terms of the rows.
    first: usize,
    /// Its states in y.
    states: Range<usize>,
}

/// The members, ready to be evaluated.
///
/// Every row of the machine is one sum over the terms (y, 1, cos(phase), sin(phase), forces of the nonlinear parts): what is known last comes
/// last.
pub(in crate::solve) struct Constant<'a, S> {
    n: usize,
    /// Index of each row among the rates (accelerations, then states): accelerations, then the states of linear parts.
    target: Vec<usize>,
    rows: Sparse<S>,
    laws: Vec<Law<'a, S>>,
    speed: S,
    /// Phase at time 0, and at the moment announced with its sine and cosine.
    phase: S,
    now: S,
    sine: (S, S),
    /// Phase at time 0 and speed in quarter turns.
    quarters: (S, S),
    level: Level,
}

/// Copies a few numbers, in steps of two: a plain copy would become a call.
#[inline(always)]
fn copy<S: Copy>(from: &[S], to: &mut [S]) {
    let n = from.len().min(to.len());
    let mut j = 0;
    while j + 1 < n {
        (to[j], to[j + 1]) = (from[j], from[j + 1]);
        j += 2;
    }
    if j < n {
        to[j] = from[j];
    }
}

/// Clears a few numbers, likewise.
#[inline(always)]
fn clear<S: Entry>(x: &mut [S]) {
    let mut j = 0;
    while j + 1 < x.len() {
        (x[j], x[j + 1]) = (S::zero(), S::zero());
        j += 2;
    }
    if j < x.len() {
        x[j] = S::zero();
    }
}

/// Sines and cosines of the phase at times to come, all computed side by side, with the bits of one by one.
#[derive(Default)]
pub(in crate::solve) struct Ahead {
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

impl Constant<'_, f64> {
    /// Prepares for times to come; of more than a register holds, for the first.
    pub fn ahead(&self, times: &[f64], to: &mut Ahead) {
        let count = times.len().min(LANES);
        to.times[..count].copy_from_slice(&times[..count]);
        (to.count, to.next) = (count, 0);
        dispatch(self.level, Sines { quarters: self.quarters, to });
    }

    /// As [`Constant::time`], from what was prepared if the next time is this one.
    #[inline(always)]
    pub fn time_from(&mut self, ahead: &mut Ahead, t: f64) {
        let i = ahead.next;
        if i < ahead.count && ahead.times[i] == t {
            ahead.next = i + 1;
            self.now = self.phase + self.speed * t;
            self.sine = (ahead.sin[i], ahead.cos[i]);
        } else {
            self.time(t);
        }
    }
}

impl<'a, S: Entry> Constant<'a, S> {
    pub fn new(base: &'a System) -> Self {
        let (n, m) = (base.n(), base.m());
        let states = base.linear_states(crate::model::linear::Form::Time);
        let target: Vec<usize> = (0..n).chain(states.iter().map(|z| n + z)).collect();
        let zeros = |len: usize| vec![S::zero(); len];
        let mut laws = Vec::new();
        let mut first = 2 * n + m + 3;
        for (k, slot) in base.slots().iter().enumerate().filter(|(_, s)| !s.is_linear()) {
            let local = slot.map.len();
            let read = if slot.uses.velocity { 2 * local } else { local };
            laws.push(Law {
                slot: k,
                part: &*slot.part,
                params: zeros(slot.params.len()),
                map: Sparse::new(read, 2 * n),
                local: zeros(2 * local),
                weight: zeros(local),
                first,
                states: 2 * n + slot.states.start..2 * n + slot.states.end,
            });
            first += local;
        }
        let zero = S::zero();
        Constant {
            n,
            rows: Sparse::new(target.len(), first),
            target,
            laws,
            speed: zero,
            phase: zero,
            now: zero,
            sine: (zero, zero),
            quarters: (zero, zero),
            level: Level::best(),
        }
    }

    /// Number of terms behind the states.
    pub fn room(&self, dim: usize) -> usize {
        self.rows.cols() - dim
    }

    /// Puts a member into a lane.
    pub fn load(&mut self, lane: usize, system: &System, speed: f64, phase: f64) -> Result<(), Failure> {
        let compiled = Compiled::new(system, speed)?;
        let (n, dim) = (self.n, 2 * self.n + system.m());
        let rows = self.target.len();
        let mut full = Mat::zeros(rows, self.rows.cols());
        let constant = dim;
        for i in 0..rows {
            for j in 0..2 * n {
                full[(i, j)] = compiled.columns[(j, i)];
            }
            for (k, &z) in compiled.model.states.iter().enumerate() {
                full[(i, 2 * n + z)] = compiled.columns[(2 * n + k, i)];
            }
            for (k, forcing) in compiled.forcing.iter().enumerate() {
                full[(i, constant + k)] = forcing[i];
            }
        }
        for law in &mut self.laws {
            let slot = &system.slots()[law.slot];
            for (p, &x) in law.params.iter_mut().zip(&system.params()[slot.params.clone()]) {
                *p = p.with(lane, x);
            }
            for (w, &x) in law.weight.iter_mut().zip(&slot.weight) {
                *w = w.with(lane, x);
            }
            let local = slot.map.len();
            let mut map = Mat::zeros(if slot.uses.velocity { 2 * local } else { local }, 2 * n);
            for (l, row) in slot.map.iter().enumerate() {
                for &(g, c) in row {
                    map[(l, g)] += c;
                    if slot.uses.velocity {
                        map[(local + l, n + g)] += c;
                    }
                    let Some(k) = compiled.touched.iter().position(|&t| t == g) else { continue };
                    for i in 0..rows {
                        full[(i, law.first + l)] += c * compiled.answers[(k, i)];
                    }
                }
            }
            law.map.set(lane, &map);
        }
        self.rows.set(lane, &full);
        self.speed = self.speed.with(lane, speed);
        self.phase = self.phase.with(lane, phase);
        self.quarters.0 = self.quarters.0.with(lane, phase * FRAC_2_PI);
        self.quarters.1 = self.quarters.1.with(lane, speed * FRAC_2_PI);
        Ok(())
    }

    #[inline(always)]
    pub fn time(&mut self, t: S) {
        self.now = self.phase + self.speed * t;
        self.sine = (self.quarters.0 + self.quarters.1 * t).sin_cos_quarters();
    }

    /// The same from the states alone, at the moment announced; the states go to `y` first, and rates of the coordinates are included.
    #[inline(always)]
    pub fn all_rates(&mut self, t: S, states: &[S], y: &mut [S], dy: &mut [S]) {
        let (positions, rates) = dy.split_at_mut(self.n);
        copy(&states[self.n..], positions);
        copy(states, y);
        self.rhs(t, y, rates);
    }

    /// Accelerations and rates of the states.
    #[inline(always)]
    pub fn rhs(&mut self, t: S, y: &mut [S], rates: &mut [S]) {
        let (n, dim, phase) = (self.n, self.n + rates.len(), self.now);
        (y[dim], y[dim + 1], y[dim + 2]) = (S::one(), self.sine.1, self.sine.0);
        for law in &mut self.laws {
            let read = law.map.rows();
            law.map.times_in_order(&y[..2 * n], &mut law.local[..read]);
            let local = law.weight.len();
            let (y, terms) = y.split_at_mut(law.first);
            let force = &mut terms[..local];
            clear(force);
            let rate = &mut rates[law.states.start - n..law.states.end - n];
            clear(rate);
            let mut spin = S::zero();
            let (q, v) = law.local.split_at(local);
            let mut args = ResidualArgs {
                p: &law.params,
                at: At { q, v, a: &law.weight, z: &y[law.states.clone()], phase, speed: self.speed, spin_accel: S::zero(), t },
                out: Rows { force, rate, spin: &mut spin },
            };
            S::enter::<Residual, _>(law.part, &mut args);
        }
        self.rows.times(y, &self.target, rates);
    }
}
