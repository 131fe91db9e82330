//! A branch of large motions that does not close in the range of speeds.
//!
//! The force of an unbalance grows with the square of the speed. On the upper branch of a hardening machine the phase of the motion against the unbalance
//! says how much of the power that the unbalance could give is used up by damping:
//!
//! ```text
//! share = power given / largest power at this amplitude = |Im S| / |S|,      S = sum over coordinates of conj(F) Q
//! ```
//!
//! with F the unbalance force and Q the motion at the spin frequency. The branch turns back (closes) where the share reaches 1. With a cubic law amplitudes
//! grow like the speed and the share tends to a limit, `share = limit + A/W + B/W^2 + ..`: below 1 the branch never closes. For the rotor on a movable foundation
//! the limit with one harmonic is `(chi T^2 + chi0 (m'/(M + m'))^2) / (T m e sqrt(kap c1/mu))`, 1 at the critical damping chi*.
//!
//! The terms in 1/W are no small matter at the end of a range of interest, so the branch is followed on to many times that speed, where they are.
//!
//! Theory: `docs/theory/harmonic-balance.md#branches-that-do-not-close`.

use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::branch::{State, Traced};
use crate::harmonic::branches::response::{Request, Response};
use crate::model::part::{At, Rows};
use crate::model::probe::Probe;
use crate::model::system::{System, Workspace};
use crate::sectors::circular;
use laval_num::complex::{C64, c};
use laval_num::continuation::{Direction, End, Kind, Settings, trace};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::AtomicBool;

/// A branch that goes on rising at the end of the range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unclosed {
    /// Index of the branch.
    pub branch: usize,
    /// Speed at its end, rad/s.
    pub speed: f64,
    /// Largest amplitude of a point of a body there at the spin frequency, m.
    pub amplitude: f64,
    /// The same on the branch from the other end, m.
    pub low_amplitude: f64,
    /// d ln amplitude / d ln speed there.
    pub rise: f64,
    /// Share of the power the unbalance could give that damping uses up there.
    pub share: f64,
    /// What becomes of the branch beyond the range.
    pub beyond: Beyond,
}

/// What becomes of a branch beyond the range; speeds rad/s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Beyond {
    /// It turns back at this speed.
    Closes(f64),
    /// It still rises at [`REACH`] times the last speed, and its share of the power tends to this limit.
    Tends(f64),
    /// It could be followed to this speed only.
    Lost(f64),
}

/// How far beyond the range a branch is followed, in multiples of the last speed.
pub const REACH: f64 = 64.0;

/// Points that may be spent on it.
const MOST_POINTS: usize = 2000;

/// The branch from the slow end of the range that reaches the other end with larger, still rising motions than the branch that starts there.
pub fn unclosed(system: &System, response: &Response, request: &Request, cancel: &AtomicBool) -> Option<Unclosed> {
    let index = response.branches.iter().position(|b| b.from_low() && b.end == End::Reached)?;
    let high = response.branches.iter().find(|b| b.origin == crate::harmonic::branches::branch::Origin::High)?;
    let branch = &response.branches[index];
    let last = branch.points.last()?;
    let end = high.points.first()?.speed;
    if last.speed != end {
        return None;
    }
    let mut balance = Balance::new(system, response.discretisation, request.speeds, None).ok()?;
    let force = unbalance(system);
    let orbit = Orbit::of(&mut balance, &last.x, last.speed).ok()?;
    let low = Orbit::of(&mut balance, &high.points.first()?.x, end).ok()?;
    let (amplitude, low_amplitude) = (largest(system, &orbit, request.divisor), largest(system, &low, request.divisor));
    let share_here = share(system, &force, &orbit, request.divisor)?;
    let other = &branch.points[earlier(branch, 0.75)?];
    let other = Orbit::of(&mut balance, &other.x, other.speed).ok()?;
    let rise = (amplitude / largest(system, &other, request.divisor)).ln() / (end / other.speed).abs().ln();
    if !(amplitude > low_amplitude && rise > 0.0) {
        return None;
    }
    let beyond = beyond(system, response, last, request, cancel).unwrap_or(Beyond::Lost(end));
    Some(Unclosed { branch: index, speed: end, amplitude, low_amplitude, rise, share: share_here, beyond })
}

/// Follows the branch on from its last state.
fn beyond(system: &System, response: &Response, last: &State, request: &Request, cancel: &AtomicBool) -> Option<Beyond> {
    let (end, far) = (last.speed, REACH * last.speed);
    let range = (end.min(far), end.max(far));
    let way = if far > end { Direction::Up } else { Direction::Down };
    let mut balance = Balance::new(system, response.discretisation, range, Some(cancel)).ok()?;
    let settings = Settings { max_points: MOST_POINTS, ..Settings::new(range.0, range.1) };
    let branch = trace(&mut balance, &last.x, end, way, &settings, &mut []).ok()?;
    if let Some(f) = branch.specials.iter().find(|s| s.kind == Kind::Fold) {
        return Some(Beyond::Closes(f.point.p));
    }
    let reached = branch.points.last()?.p;
    if branch.end != End::Reached {
        return Some(Beyond::Lost(reached));
    }
    let force = unbalance(system);
    let mut shares = Vec::new();
    for part in [1.0, 0.5, 0.25] {
        let wanted = part * far;
        let point = branch.points.iter().min_by(|a, b| (a.p - wanted).abs().total_cmp(&(b.p - wanted).abs()))?;
        let orbit = Orbit::of(&mut balance, &point.x, point.p).ok()?;
        shares.push((far / point.p, share(system, &force, &orbit, request.divisor)?));
    }
    Some(Beyond::Tends(extrapolated(&shares)))
}

/// The point of the last run of a branch nearest to this part of its last speed.
fn earlier(branch: &Traced, part: f64) -> Option<usize> {
    let last = branch.points.len().checked_sub(1)?;
    let wanted = part * branch.points[last].speed;
    let from = branch.folds.last().map_or(0, |f| f.after + 1);
    (from..last).min_by(|&a, &b| (branch.points[a].speed - wanted).abs().total_cmp(&(branch.points[b].speed - wanted).abs()))
}

/// Value at u = 0 of the polynomial through points (u, value); NaN where two have the same u.
fn extrapolated(points: &[(f64, f64)]) -> f64 {
    let weight = |i: usize| {
        let others = points.iter().enumerate().filter(|(j, _)| *j != i);
        others.fold(1.0, |w, (_, p)| if p.0 == points[i].0 { f64::NAN } else { w * p.0 / (p.0 - points[i].0) })
    };
    (0..points.len()).map(|i| weight(i) * points[i].1).sum()
}

/// Largest forward amplitude of a point of a body at the spin frequency, m.
fn largest(system: &System, orbit: &Orbit, order: usize) -> f64 {
    let Some(at) = orbit.orders.iter().position(|&o| o == order) else { return 0.0 };
    let forward = |p: &Probe| {
        let [x, y] = p.amplitudes(&orbit.coordinates[at]);
        circular(x, y).0.abs()
    };
    system.probes().iter().filter(|p| !p.is_tilt()).map(forward).fold(0.0, f64::max)
}

/// `|Im S| / |S|`.
fn share(system: &System, force: &dyn Fn(f64) -> Vec<C64>, orbit: &Orbit, order: usize) -> Option<f64> {
    let at = orbit.orders.iter().position(|&o| o == order)?;
    let force = force(orbit.speed);
    let s = (0..system.n()).fold(C64::zero(), |s, g| s + force[g].conj() * orbit.coordinates[at][g]);
    (s.abs() > 0.0).then(|| s.im.abs() / s.abs())
}

/// Forces on the machine at rest in its middle position, turning at a speed: amplitudes at the spin frequency.
fn unbalance(system: &System) -> impl Fn(f64) -> Vec<C64> {
    move |speed| {
        let (n, m) = (system.n(), system.m());
        let (q, z) = (vec![0.0; n], vec![0.0; m]);
        let rows = |phase: f64| {
            let at = At { q: &q, v: &q, a: &q, z: &z, phase, speed, spin_accel: 0.0, t: 0.0 };
            let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
            let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            system.residual(system.params(), &at, &mut out, &mut Workspace::default(), |_| true);
            force
        };
        let (a, b, opposite) = (rows(0.0), rows(FRAC_PI_2), rows(PI));
        // F = (row(0) - row(pi))/2 - i (row(pi/2) - mean)
        (0..n).map(|g| c(0.5 * (a[g] - opposite[g]), -(b[g] - 0.5 * (a[g] + opposite[g])))).collect()
    }
}
