//! Members in lanes, of constant mass at constant speeds and without memory: the linear parts as one sparse matrix, and a call for each nonlinear
//! part.

use super::compiled::Compiled;
use super::single::clear;
use crate::model::erased::Erased;
use crate::model::lanes::{Residual, ResidualArgs};
use crate::model::part::{At, Rows};
use crate::model::system::System;
use laval_num::dense::Mat;
use laval_num::lanes::{Entry, Sparse};
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
pub(crate) struct Constant<'a, S> {
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
}

impl<'a, S: Entry> Constant<'a, S> {
    pub fn new(base: &'a System) -> Self {
        let (n, m) = (base.n(), base.m());
        let states = &base.assembly(crate::model::linear::Form::Time).states;
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
            for (k, &z) in compiled.model.states().iter().enumerate() {
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
                }
                for (i, answer) in compiled.answer(row).into_iter().enumerate() {
                    full[(i, law.first + l)] = answer;
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
