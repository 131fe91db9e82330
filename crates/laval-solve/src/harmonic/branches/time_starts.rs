//! Starts from motions in time: an ensemble of starts of any size is integrated until the motions nearly repeat, and their nonlinear coordinates over one
//! period are expanded into harmonics. Newton's method needs no more than that; a motion that does not repeat within some turns gives no start.
//!
//! What motions settle on is stable, and of any period up to `LONGEST` turns: isolated branches that no guess at a form of the motion finds.

use crate::ensemble::{self, Ended, EnsembleTask, Form, Grid, Leg, LegEnd, Method, Next, Settings, Start};
use crate::harmonic::balance::motion::put;
use crate::harmonic::balance::problem::Nonlinear;
use crate::harmonic::balance::terms::{Term, Terms};
use crate::harmonic::branches::seeds::Random;
use crate::model::system::System;
use crate::motion::SpinLaw;
use crate::pencil::modes_about;
use crate::programme::Programme;
use crate::rest::rest;
use laval_num::complex::{C64, c};
use std::f64::consts::TAU;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Longest period sought, in turns.
pub(super) const LONGEST: usize = 9;
/// Samples of a turn.
const SAMPLES: usize = 64;
/// e-folds of the slowest mode that a motion is followed.
const FOLDS: f64 = 6.0;
/// Turns it is followed at least and at most.
const TURNS: (f64, f64) = (40.0, 4000.0);
/// Turns it is followed where a mode at rest does not decay: nothing says how long settling takes.
const UNKNOWN: f64 = 400.0;
/// Turns of one leg: the phase keeps its digits.
const LEG: u64 = 1000;
/// Difference of two successive periods over the size of the motion, up to which it nearly repeats.
const NEARLY: f64 = 0.02;
/// Difference of moduli over the size of a motion, up to which two are taken for one.
const ALIKE: f64 = 0.02;

/// Which method integrates a machine in lanes.
pub fn method(system: &System) -> Method {
    if system.slots().iter().any(|s| s.memory > 0) { Method::Stiff } else { Method::Explicit }
}

/// A motion that nearly repeats: its nonlinear coordinates, sample by sample over its period.
pub(super) struct Loop {
    /// Its period in turns.
    pub turns: usize,
    samples: Vec<Vec<f64>>,
}

impl Loop {
    /// Complex coefficient of a term whose base frequency is that of the loop: `Z_n`, or `a_k - i b_k`.
    fn coefficient(&self, term: Term) -> C64 {
        let n = self.samples.len() as i64;
        let turned = self.samples.iter().enumerate().map(|(j, u)| {
            let back = C64::cis(-TAU * ((i64::from(term.order()) * j as i64).rem_euclid(n)) as f64 / n as f64);
            match term {
                Term::Pair { coordinate, .. } => c(u[coordinate], u[coordinate + 1]) * back,
                Term::Scalar { coordinate, .. } => back.scale(u[coordinate]),
            }
        });
        turned.fold(C64::zero(), |s, z| s + z).scale(term.gain() / n as f64)
    }

    /// Its harmonics.
    pub fn start(&self, terms: &Terms) -> Vec<f64> {
        let mut out = vec![0.0; terms.unknowns];
        for &(term, at) in &terms.list {
            put(term, at, self.coefficient(term), &mut out);
        }
        out
    }

    /// The same motion, perhaps turned or begun at another instant: moduli of low orders agree.
    fn same(&self, other: &Loop, kinds: &Terms) -> bool {
        let moduli = |l: &Loop| kinds.list.iter().map(|(t, _)| l.coefficient(*t).abs()).collect::<Vec<f64>>();
        let (a, b) = (moduli(self), moduli(other));
        let size = a.iter().chain(&b).fold(0.0, |m: f64, x| m.max(*x));
        self.turns == other.turns && a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= ALIKE * size)
    }
}

/// The starts under way.
struct Members<'a> {
    system: Arc<System>,
    nonlinear: &'a Nonlinear,
    speed: f64,
    starts: Vec<Vec<f64>>,
    /// Turns followed before the record.
    turns: u64,
    cancel: &'a AtomicBool,
    /// Most steps of one start.
    most_steps: u64,
}

/// What is remembered of a start.
struct Log {
    to_go: u64,
    steps_left: u64,
    recording: bool,
    samples: Vec<Vec<f64>>,
}

impl Members<'_> {
    fn period(&self) -> f64 {
        TAU / self.speed.abs()
    }

    fn next(&self, log: &mut Log, first_step: Option<f64>) -> Leg {
        let turns = log.to_go.min(LEG);
        log.recording = turns == 0;
        let max_steps = log.steps_left.max(1);
        if log.recording {
            let count = (2 * LONGEST * SAMPLES) as u64;
            let outputs = Grid { start: 0.0, step: self.period() / SAMPLES as f64, count: count + 1 };
            return Leg { first_step, outputs, max_steps, ..Leg::new(0.0, outputs.time(count)) };
        }
        log.to_go -= turns;
        Leg { first_step, max_steps, ..Leg::new(0.0, self.period() * turns as f64) }
    }
}

impl EnsembleTask for Members<'_> {
    type Log = Log;
    type Row = Option<Loop>;

    fn start(&self, index: usize) -> Result<Start<Log>, Option<Loop>> {
        let mut log = Log { to_go: self.turns, steps_left: self.most_steps, recording: false, samples: Vec::new() };
        let leg = self.next(&mut log, None);
        Ok(Start {
            system: self.system.clone(),
            law: SpinLaw::Programme(Programme::constant(self.speed, 0.0)),
            y: self.starts[index].clone(),
            relative: 1e-6,
            absolute: ensemble::tolerances(&self.system, self.speed, 1e-8),
            leg,
            log,
        })
    }

    fn output(&self, log: &mut Log, _: u64, _: f64, y: &[f64]) {
        let n = self.system.n();
        let own = self.nonlinear.basis.rows.iter().map(|row| row.iter().map(|&(g, c)| c * y[g]).sum());
        let states = self.nonlinear.states.iter().map(|&g| y[2 * n + g]);
        log.samples.push(own.chain(states).collect());
    }

    fn ended(&self, _: usize, log: &mut Log, ended: &Ended, y: &mut [f64]) -> Next<Option<Loop>> {
        log.steps_left = log.steps_left.saturating_sub(ended.steps + ended.rejected);
        if ended.end != LegEnd::Reached || !y.iter().all(|x| x.is_finite()) {
            return Next::Done(None);
        }
        if log.recording {
            return Next::Done(repeating(std::mem::take(&mut log.samples)));
        }
        Next::Leg(self.next(log, Some(ended.next_step)))
    }

    fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

/// The last period of a record over twice the longest, where it nearly repeats.
fn repeating(samples: Vec<Vec<f64>>) -> Option<Loop> {
    let n = samples.len().checked_sub(1)?;
    // the last sample is the first of the next period
    let own = &samples[..n];
    let width = own.first()?.len();
    let sizes: Vec<f64> = (0..width).map(|i| own.iter().fold(0.0, |m: f64, u| m.max(u[i].abs()))).collect();
    let repeats = |turns: &usize| {
        let k = turns * SAMPLES;
        let apart = |j: usize| (0..width).any(|i| !((own[j][i] - own[j - k][i]).abs() <= NEARLY * sizes[i]));
        2 * k <= n && !(n - k..n).any(apart)
    };
    let turns = (1..=LONGEST).find(repeats)?;
    Some(Loop { turns, samples: own[n - turns * SAMPLES..].to_vec() })
}

/// What so many starts at a speed (rad/s) settle on, each motion once, and how many starts came to nearly repeat. `sizes` (m) are the smallest and largest
/// known motions; a start that takes more than `most_steps` is given up.
pub(super) fn loops(
    system: &System,
    speed: f64,
    sizes: (f64, f64),
    count: usize,
    most_steps: u64,
    cancel: &AtomicBool,
) -> (Vec<Loop>, usize) {
    let nonlinear = Nonlinear::of(system);
    let Ok(own) = system.with(&[]) else { return (Vec::new(), 0) };
    let still = rest(system, speed).ok();
    let decay = still.as_ref().and_then(|e| modes_about(system, e, false).ok()?.least_stable().map(|m| -m.growth()));
    let turns = decay.filter(|r| *r > 0.0).map_or(UNKNOWN, |r| FOLDS / r * speed.abs() / TAU).clamp(TURNS.0, TURNS.1).ceil() as u64;
    let (n, dim) = (own.n(), 2 * own.n() + own.m());
    let mut random = Random(speed.to_bits() ^ 0x5eed);
    let mut start = |_| {
        let size = 0.3 * sizes.0 * (10.0 * sizes.1 / sizes.0).powf(random.next());
        let mut y = vec![0.0; dim];
        for i in 0..n {
            y[i] = still.as_ref().map_or(0.0, |e| e.q[i]) + size * (2.0 * random.next() - 1.0);
            y[n + i] = size * speed * (2.0 * random.next() - 1.0);
        }
        y
    };
    let starts = (0..count).map(&mut start).collect();
    let form = Form::of(system, true);
    let members = Members { system: Arc::new(own), nonlinear: &nonlinear, speed, starts, turns, cancel, most_steps };
    let settings = Settings { method: method(system), ..Settings::default() };
    let found = ensemble::run(&members, &members.system, form, 0..count, settings).unwrap_or_default();
    let mut out: Vec<Loop> = Vec::new();
    let mut repeating = 0;
    for l in found.into_iter().flatten() {
        repeating += 1;
        let low = Terms::new(&nonlinear.kinds, crate::symmetry::Symmetry::None, 3 * l.turns, l.turns, 16);
        if !out.iter().any(|o| l.turns == o.turns && l.same(o, &low)) {
            out.push(l);
        }
    }
    (out, repeating)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::part::DofKind;
    use crate::symmetry::Symmetry;

    /// Samples of a motion of three turns: its period is found, and so are its harmonics; one that does not repeat gives none.
    #[test]
    fn harmonics_of_a_record() {
        let sample = |j: usize, orders: &[(f64, f64)]| {
            let tau = TAU * j as f64 / SAMPLES as f64;
            let z = orders.iter().fold(C64::zero(), |z, (o, a)| z + C64::cis(o * tau + 0.3).scale(*a));
            vec![z.re, z.im, (tau / 3.0).cos() + 0.5]
        };
        let record = |orders: &[(f64, f64)]| (0..=2 * LONGEST * SAMPLES).map(|j| sample(j, orders)).collect::<Vec<_>>();
        let l = repeating(record(&[(1.0, 2.0), (-1.0 / 3.0, 0.5)])).unwrap();
        assert_eq!(l.turns, 3);
        let terms = Terms::new(&[DofKind::VectorX, DofKind::VectorY, DofKind::Scalar], Symmetry::None, 4, 3, 32);
        let x = l.start(&terms);
        let mut rows = [0; 3].map(|_| laval_num::dense::Mat::default());
        for j in [0, 7, 100] {
            terms.rows_at(TAU * j as f64 / (3 * SAMPLES) as f64, &mut rows);
            let found = rows[0].mul_vec(&x);
            assert!(found.iter().zip(&l.samples[j]).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {:?}", l.samples[j]);
        }
        assert!(repeating(record(&[(1.0, 2.0), (0.618, 0.5)])).is_none());
    }
}
