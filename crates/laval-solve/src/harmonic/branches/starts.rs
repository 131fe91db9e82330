//! Where the branches of a response begin.
//!
//! A machine brought to an end of the range is on the states that it reached from beyond that end: run up from low speed, or run down from high speed. Several
//! states may exist there, so the start is followed from a speed well beyond the end, where Newton's method leads from the equilibrium under constant loads
//! to the motion about it. Where no branch leads from there to the end of the range, the start is what Newton's method finds at the end itself.

use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::balance::raise::raised;
use crate::harmonic::balance::terms::{Term, Terms};
use crate::harmonic::branches::response::{Request, carry};
use crate::model::system::System;
use crate::rest::rest;
use laval_num::continuation::{Direction, End, Settings, Zero, trace};
use laval_num::newton::{Options, newton};
use laval_num::work::Here;
use std::sync::atomic::AtomicBool;

/// Where the approach to the slow end begins, as a share of that speed: well below the hystereses of the machine's lowest resonance.
const SLOWER: f64 = 1.0 / 30.0;
/// The same for the fast end: above a hysteresis that holds the end of the range.
const FASTER: f64 = 2.0;
/// Points that may be spent on an approach.
const MOST_POINTS: usize = 600;

/// A state at an end of the range.
#[derive(Clone)]
pub(super) struct Start {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Followed from beyond the range: a machine that comes from there is on it.
    pub followed: bool,
}

/// Starts at the lower and at the upper end, kept from one discretisation to the next.
#[derive(Default)]
pub(super) struct Starts([Kept; 2]);

impl Starts {
    /// The states of a machine brought to the lower and to the upper end of the range from beyond them.
    pub fn both<'a>(
        &mut self,
        system: &'a System,
        balance: &mut Balance<'a>,
        request: &Request,
        cancel: &'a AtomicBool,
    ) -> (Option<Start>, Option<Start>) {
        let ((lo, hi), [first, second]) = (request.speeds, &mut self.0);
        let (mut other, here) = (balance.twin(balance.cancel), Here::now());
        let at = |kept, balance: &mut Balance<'a>, speed| {
            let _counted = here.enter();
            at(kept, (system, balance), request, speed, cancel)
        };
        rayon::join(|| at(first, balance, lo), || at(second, &mut other, hi))
    }
}

type Kept = Option<(Terms, Start)>;

/// The state of a machine brought to the end `speed` of the range from beyond it.
fn at<'a>(
    kept: &mut Kept,
    (system, balance): (&'a System, &mut Balance<'a>),
    request: &Request,
    speed: f64,
    cancel: &'a AtomicBool,
) -> Option<Start> {
    let slow = (speed == request.speeds.0) == (speed > 0.0);
    let known = kept.as_ref().and_then(|(terms, start)| {
        let x = solved(balance, carry(terms, &balance.terms, &start.x), speed)?;
        Some(Start { x, ..*start })
    });
    let found = match known {
        Some(start) => Some(start),
        // one state, whichever way the machine came
        None if balance.nonlinear.members.is_empty() => direct(balance, speed).map(|x| Start { x, followed: true }),
        None => {
            let from = speed * if slow { SLOWER } else { FASTER };
            let x = approach(system, balance.discretisation(), request, (from, speed), cancel).and_then(|x| solved(balance, x, speed));
            match x {
                Some(x) => Some(Start { x, followed: true }),
                None => direct(balance, speed).map(|x| Start { x, followed: false }),
            }
        }
    };
    *kept = found.clone().map(|start| (balance.terms.clone(), start));
    found
}

/// Newton's method at one speed.
fn solved(balance: &mut Balance, mut x: Vec<f64>, speed: f64) -> Option<Vec<f64>> {
    newton(balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).ok()?;
    Some(x)
}

/// Unknowns at the end `to` of the branch that begins at the speed `from`.
fn approach<'a>(
    system: &'a System,
    d: Discretisation,
    request: &Request,
    (from, to): (f64, f64),
    cancel: &'a AtomicBool,
) -> Option<Vec<f64>> {
    let range = (from.min(to), from.max(to));
    let mut balance = Balance::new(system, d, range, Some(cancel)).ok()?;
    let start = direct(&mut balance, from)?;
    let way = if to > from { Direction::Up } else { Direction::Down };
    let max_points = MOST_POINTS.min(request.max_points);
    // only the last state is kept, so that longer steps will do than along a branch that is drawn
    let max_parameter_step = (range.1 - range.0) / 10.0;
    let settings = Settings { max_points, max_parameter_step, monitor_change: 0.3, ..Settings::new(range.0, range.1) };
    let branch = trace(&mut balance, &start, from, way, &settings, &mut []).ok()?;
    let last = branch.points.last().filter(|p| branch.end == End::Reached && p.p == to)?;
    Some(last.x.clone())
}

/// A motion at one speed: about the equilibrium, else by raising the rotating load, else from linear estimates.
fn direct(balance: &mut Balance, speed: f64) -> Option<Vec<f64>> {
    let sagged = equilibrium(balance, speed);
    if let Some(x) = solved(balance, sagged.clone().unwrap_or_else(|| vec![0.0; balance.dim()]), speed) {
        return Some(x);
    }
    if let Some(x) = sagged.as_ref().and_then(|start| raised(balance, speed, Some(start))) {
        return Some(x);
    }
    // a linear estimate with the reference stiffness, then with a tenth of it and with ten times as much
    for part in [1.0, 0.1, 10.0] {
        if let Some(x) = balance.linear_estimate(speed, part).and_then(|x| solved(balance, x, speed)) {
            return Some(x);
        }
    }
    raised(balance, speed, None)
}

/// Unknowns of the machine in equilibrium under its constant loads; `None` where it has none or is not displaced.
fn equilibrium(balance: &Balance, speed: f64) -> Option<Vec<f64>> {
    let at = rest(balance.system, speed).ok()?;
    if at.q.iter().chain(&at.z).all(|&x| x == 0.0) {
        return None;
    }
    let rows = balance.nonlinear.basis.rows.iter().map(|row| row.iter().map(|&(g, b)| b * at.q[g]).sum::<f64>());
    let states = balance.nonlinear.states.iter().map(|&g| at.z[g]);
    let u: Vec<f64> = rows.chain(states).collect();
    let mut x = vec![0.0; balance.dim()];
    for &(term, to) in balance.terms.list.iter().filter(|(t, _)| t.order() == 0) {
        match term {
            Term::Pair { coordinate, .. } => x[to..to + 2].copy_from_slice(&u[coordinate..coordinate + 2]),
            Term::Scalar { coordinate, .. } => x[to] = u[coordinate],
        }
    }
    Some(x)
}
