//! Equilibria: static rest in fixed axes, and the Newton iteration shared with states that turn with the rotor.
//!
//! Theory: `docs/theory/equilibria.md#static-rest`.

use super::characteristic::{Characteristic, Equilibrium, Frame, coordinate_sectors, nonlinear_states};
use super::co_rotating::preferring;
use super::sectors::Sectors;
use super::turned_freely::kept;
use crate::diagnostic::Diagnostic;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, DofKind, Rows};
use crate::model::system::{Drive, Slot, System, Workspace};
use laval_model::text;
use laval_model::text::Text;
use laval_num::complex::{C64, c};
use laval_num::dense::max_abs;
use laval_num::factor::{Factors, Pattern};

/// Static equilibrium at a spin speed (rad/s): all rates zero, constant loads only. Zero when there is no load.
///
/// # Errors
/// A part that cannot be linearised at rest or whose force turns with the rotor; no equilibrium.
pub fn rest(system: &System, speed: f64) -> Result<Equilibrium, Diagnostic> {
    let start = Equilibrium::zero(system, Frame::Fixed, speed);
    if let Some(refused) = unlinearised(system, &start).filter(|_| !loaded(system, &start)) {
        return Err(refused);
    }
    let found = settle(system, start.clone())
        .or_else(|d| sink(system, &start, &[]).and_then(|sunk| settle(system, sunk).ok()).ok_or(d))
        .map_err(|d| unlinearised(system, &start).unwrap_or(d))?;
    if let Some(refused) = unlinearised(system, &found) {
        return Err(refused);
    }
    for slot in system.slots().iter().filter(|s| !s.is_linear() && s.uses.spin) {
        let force = |phase: f64| part_force(system, slot, &found, phase);
        let reference = force(0.0);
        let size = 1e-12 + max_abs(&reference);
        for phase in [1.1, 2.9] {
            let change = force(phase).iter().zip(&reference).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            if change > 1e-9 * size {
                return Err(Diagnostic::error(
                    "rest.turning",
                    text!("the machine has no rest: the force of \"{name}\" turns with the rotor", name = slot.name),
                )
                .at(slot.span.clone())
                .help(instead(system, speed)));
            }
        }
    }
    Ok(found)
}

/// Static rest over the speed, as [`rest`] at each: found once where all parts are linear and neither stiffness nor constant loads depend on the speed.
pub fn over_speed(system: &System) -> impl Fn(f64) -> Result<Equilibrium, Diagnostic> + Sync {
    let once = same_at_every_speed(system).then(|| rest(system, 0.0).ok()).flatten();
    move |speed| match &once {
        Some(found) => Ok(Equilibrium { speed, ..found.clone() }),
        None => rest(system, speed),
    }
}

/// Stiffness and constant loads are those of any speed. What is linear in the speed and equal at two speeds is equal at all.
fn same_at_every_speed(system: &System) -> bool {
    let at = |speed: f64| {
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
        let [stiffness, ..] = model.polynomial();
        (stiffness, model.loads.force, model.loads.rate)
    };
    system.slots().iter().all(Slot::is_steady) && at(0.0) == at(1.0)
}

/// Where the bodies of a machine hang whose forces turn with the rotor: equilibrium of the means over a turn of the loads, with what moves inside the rotor (balls) held
/// where `places` says, at 0 otherwise.
///
/// # Errors
/// No equilibrium.
pub fn hanging(system: &System, speed: f64, places: &[(usize, f64)]) -> Result<Equilibrium, Diagnostic> {
    let mut start = Equilibrium::zero(system, Frame::Fixed, speed);
    places.iter().for_each(|&(i, x)| start.q[i] = x);
    let kinds = system.coordinates().iter().map(|c| c.dof.kind);
    let held: Vec<usize> = kinds.enumerate().filter(|(_, k)| *k == DofKind::Scalar).map(|(i, _)| i).collect();
    settle_with(system, start.clone(), &held)
        .or_else(|d| sink(system, &start, &held).and_then(|sunk| settle_with(system, sunk, &held).ok()).ok_or(d))
}

/// Studies that answer for a machine without rest: states that turn exist only where nothing has a preferred direction, and a free spin has neither a given
/// speed nor a programme.
pub(super) fn instead(system: &System, speed: f64) -> Text {
    if system.machine.drive == Drive::Free {
        return text!("transient gives the motion in time");
    }
    match preferring(system, speed) {
        None => text!("stationary gives the states that turn with the rotor and their stability, transient and run_up the motion in time"),
        Some(_) => text!("transient and run_up give the motion in time"),
    }
}

/// What is said of the first part that cannot be linearised about a state: it carries no load there, and either it is about to or nothing else holds
/// the points it joins. Parts in contact and parts whose clearance is open in a machine that others hold can be.
pub fn unlinearised(system: &System, about: &Equilibrium) -> Option<Diagnostic> {
    system.slots().iter().find_map(|slot| {
        let reason = slot.part.contacts()?.refuses_rest(&system.params()[slot.params.clone()])?;
        let fine = clearance(system, slot, about).is_some_and(|gap| {
            let resolved = 1e-9 * max_abs(&local(system, slot, &about.q)).max(gap.abs());
            gap < -resolved || gap > resolved && held(system, slot, about)
        });
        (!fine).then(|| {
            Diagnostic::error("rest.refused", text!("\"{name}\" cannot be linearised at rest: {reason}", name = slot.name, reason))
                .at(slot.span.clone())
                .help(text!("use a nonlinear study or one in time, or give the part a preload"))
        })
    })
}

/// Distance of a part's gap from contact at a state, m.
pub fn clearance(system: &System, slot: &Slot, about: &Equilibrium) -> Option<f64> {
    let zero = vec![0.0; system.n()];
    let at = At { q: &about.q, v: &zero, a: &zero, z: &about.z, phase: 0.0, speed: about.speed, spin_accel: 0.0, t: 0.0 };
    let (contacts, p) = (slot.part.contacts()?, &system.params()[slot.params.clone()]);
    system.with_local(slot, &at, &mut Workspace::default(), |l| contacts.clearance(p, l))
}

/// Coordinates of a part's port at coordinates of the machine.
fn local(system: &System, slot: &Slot, q: &[f64]) -> Vec<f64> {
    let (v, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let at = At { q, v: &v, a: &v, z: &z, phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 };
    system.with_local(slot, &at, &mut Workspace::default(), |l| l.q.to_vec())
}

/// The tangent stiffness at a state bounds what a force between the points of a part moves: with a support too weak to matter added to every
/// coordinate, the points give way by no more than it is weaker.
fn held(system: &System, slot: &Slot, about: &Equilibrium) -> bool {
    const WEAK: f64 = 1e-13;
    const HELD: f64 = 1e-11;
    let n = system.n();
    let mut t = Characteristic::new(system, about);
    let k = t.stiffness_entries();
    let typical: Vec<f64> = system.coordinates().iter().map(|c| c.dof.typical).collect();
    let typical: Vec<f64> = typical.into_iter().chain(t.states().iter().map(|&s| system.states()[s].dof.typical)).collect();
    let size = typical.len();
    let (mut scaled, mut largest) = (k, 0.0f64);
    for i in 0..size {
        for (e, j) in t.pattern().row(i) {
            scaled[e] *= typical[i] * typical[j];
            if i < n && j < n {
                largest = largest.max(scaled[e].abs());
            }
        }
    }
    for i in 0..n {
        t.pattern().row(i).filter(|x| x.1 == i).for_each(|(e, _)| scaled[e] += WEAK * largest);
    }
    let Ok(lu) = Factors::new(t.plan(), &scaled) else { return false };
    let moves = |i: usize| local(system, slot, &(0..n).map(|j| if i == j { typical[i] } else { 0.0 }).collect::<Vec<_>>());
    let moves: Vec<Vec<f64>> = (0..n).map(moves).collect();
    (0..moves.first().map_or(0, Vec::len)).all(|side| {
        let force: Vec<f64> = (0..size).map(|i| if i < n { moves[i][side] } else { 0.0 }).collect();
        let mut moved = force.clone();
        lu.solve(&mut moved);
        let (gives, square) = force.iter().zip(&moved).fold((0.0, 0.0), |(g, s), (f, x)| (g + f * x, s + f * f));
        // nothing that is not a number holds
        gives.abs() * HELD * largest < square
    })
}

/// A constant load acts on the machine.
fn loaded(system: &System, at: &Equilibrium) -> bool {
    let mut t = Characteristic::new(system, at);
    let x = vec![0.0; system.n() + t.states().len()];
    residual(system, at, &mut t, &mut None, &coordinate_sectors(system), &x, &[]).iter().any(|r| *r != 0.0)
}

fn part_force(system: &System, slot: &Slot, at: &Equilibrium, phase: f64) -> Vec<f64> {
    let name = &slot.name;
    let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
    let zero = vec![0.0; system.n()];
    let point = At { q: &at.q, v: &zero, a: &zero, z: &at.z, phase, speed: at.speed, spin_accel: 0.0, t: 0.0 };
    let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
    system.residual(system.params(), &point, &mut rows, &mut Workspace::default(), |s| &s.name == name);
    force.extend(rate);
    force
}

/// Spin angles over which the mean of forces that turn is taken: exact up to the order below their number.
const PHASES: usize = 8;

/// Residual over the unknowns of the characteristic matrix; with coordinates that are held its mean over a turn, and none of theirs. `linear`: the stiffness of the linear parts,
/// once it is known.
fn residual(
    system: &System,
    at: &Equilibrium,
    t: &mut Characteristic,
    linear: &mut Option<Vec<C64>>,
    coordinates: &Sectors,
    x: &[f64],
    held: &[usize],
) -> Vec<f64> {
    let mut r = if x.iter().all(|&x| x == 0.0) {
        vec![0.0; x.len()]
    } else {
        let k = &*linear.get_or_insert_with(|| t.linear_entries(C64::zero()));
        let mut u: Vec<C64> = x.iter().map(|&x| c(x, 0.0)).collect();
        t.sectors().polarise(&mut u);
        let mut force = t.times(k, &u);
        t.sectors().restore(&mut force);
        force.iter().map(|f| f.re).collect()
    };
    let (constant, turning) = t.loads();
    for (i, r) in r.iter_mut().enumerate() {
        *r -= constant[i] + if at.frame == Frame::Turning { turning[i].re } else { 0.0 };
    }
    let n = system.n();
    let (v, a) = (at.velocity(coordinates), at.acceleration(coordinates));
    let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; system.m()], 0.0);
    let phases = if held.is_empty() { 1 } else { PHASES };
    for k in 0..phases {
        let phase = std::f64::consts::TAU * k as f64 / phases as f64;
        let point = At { q: &at.q, v: &v, a: &a, z: &at.z, phase, speed: at.speed, spin_accel: 0.0, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &point, &mut rows, &mut Workspace::default(), |s| !s.is_linear());
    }
    let share = 1.0 / phases as f64;
    rate.iter_mut().for_each(|r| *r *= share);
    for (r, f) in r.iter_mut().zip(&force) {
        *r += share * f;
    }
    let own = nonlinear_states(system);
    let turn = Sectors::new(system.states().iter().map(|s| s.dof.kind)).quarter_turn(&at.z);
    for (k, &state) in t.states().iter().enumerate().filter(|(_, s)| own.contains(s)) {
        r[n + k] -= rate[state];
        if at.frame == Frame::Turning {
            r[n + k] += at.speed * turn[state];
        }
    }
    held.iter().for_each(|&i| r[i] = 0.0);
    r
}

/// Coordinates that are held take no part in a Newton step.
fn hold(pattern: &Pattern, k: &mut [f64], held: &[usize]) {
    for i in 0..pattern.n() {
        for (e, j) in pattern.row(i) {
            if held.contains(&i) || held.contains(&j) {
                k[e] = if i == j { 1.0 } else { 0.0 };
            }
        }
    }
}

/// The machine rests where it is: nothing is deflected and no constant force acts, which needs no tangent to be seen.
fn undeflected(system: &System, at: &Equilibrium) -> bool {
    if !at.q.iter().chain(&at.z).all(|&x| x == 0.0) {
        return false;
    }
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(system.params(), at.speed, Form::Frequency, &mut model, &mut scratch);
    if !model.loads.force.iter().chain(&model.loads.rate).all(|&f| f == 0.0) {
        return false;
    }
    let zero = vec![0.0; system.n()];
    let (mut force, mut rate, mut spin) = (zero.clone(), vec![0.0; system.m()], 0.0);
    let point = At { q: &at.q, v: &zero, a: &zero, z: &at.z, phase: 0.0, speed: at.speed, spin_accel: 0.0, t: 0.0 };
    let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
    system.residual(system.params(), &point, &mut rows, &mut Workspace::default(), |s| !s.is_linear());
    force.iter().chain(&rate).all(|&f| f == 0.0)
}

/// Newton step over the displacement up to which it may be rounding, and roundings of the forces that a step may stand for.
const RESOLVED: f64 = 1e-6;
const ROUNDINGS: f64 = 4.0;

/// A Newton step is no longer than some of those that one rounding of every force stands for, in typical sizes: `|K^-1| |K| |x|` times the rounding unit. Heavy bodies that are
/// stiffly joined on a soft support hang further down than their forces cancel.
fn resolves(count: f64, length: f64, (pattern, k, lu): (&Pattern, &[f64], &Factors<f64>), x: &[f64], typical: &[f64]) -> bool {
    let size = x.len();
    let force: Vec<f64> = (0..size).map(|j| f64::EPSILON * pattern.row(j).map(|(e, i)| (k[e] * x[i]).abs()).sum::<f64>()).collect();
    let reaches = |moved: &[f64]| length <= count * max_abs(&moved.iter().zip(typical).map(|(m, t)| m / t).collect::<Vec<_>>());
    // roundings of any signs move it by no more than all together: where these suffice, no others are needed
    let together = |sign: &dyn Fn(usize) -> f64| {
        let mut moved: Vec<f64> = (0..size).map(|j| sign(j) * force[j]).collect();
        lu.solve(&mut moved);
        reaches(&moved)
    };
    let alternate = |period: usize| move |j: usize| if (j / period).is_multiple_of(2) { 1.0 } else { -1.0 };
    if together(&|j| if x[j] < 0.0 { -1.0 } else { 1.0 }) || [1, 2, 4, size.max(1)].iter().any(|&period| together(&alternate(period))) {
        return true;
    }
    let mut moved = vec![0.0; size];
    for j in 0..size {
        let mut column = vec![0.0; size];
        column[j] = force[j];
        lu.solve(&mut column);
        moved.iter_mut().zip(&column).for_each(|(m, c)| *m += c.abs());
    }
    reaches(&moved)
}

/// Newton's method on the equilibrium, from a start, with steps shortened until the residual falls.
pub(super) fn settle(system: &System, start: Equilibrium) -> Result<Equilibrium, Diagnostic> {
    settle_with(system, start, &[])
}

fn settle_with(system: &System, start: Equilibrium, held: &[usize]) -> Result<Equilibrium, Diagnostic> {
    let n = system.n();
    let coordinates = coordinate_sectors(system);
    let place = |states: &[usize], x: &[f64], at: &mut Equilibrium| {
        at.q.copy_from_slice(&x[..n]);
        for (&s, &x) in states.iter().zip(&x[n..]) {
            at.z[s] = x;
        }
    };
    let mut at = start;
    if at.frame == Frame::Fixed && undeflected(system, &at) {
        return Ok(at);
    }
    let mut t = Characteristic::new(system, &at);
    let states = t.states().to_vec();
    let typical: Vec<f64> =
        system.coordinates().iter().map(|c| c.dof.typical).chain(states.iter().map(|&s| system.states()[s].dof.typical)).collect();
    let mut x: Vec<f64> = at.q.iter().copied().chain(states.iter().map(|&s| at.z[s])).collect();
    let mut linear = None;
    let mut r = residual(system, &at, &mut t, &mut linear, &coordinates, &x, held);
    if r.iter().all(|&r| r == 0.0) {
        return Ok(at);
    }
    let mut held = held.to_vec();
    let k = t.stiffness_entries();
    held.extend(kept(system, t.pattern(), &k, |i| r[i] != 0.0 || x[i] != 0.0));
    let held = &held[..];
    let mut last = f64::INFINITY;
    for iteration in 1..=60 {
        let mut k = t.stiffness_entries();
        hold(t.pattern(), &mut k, held);
        let Ok(lu) = Factors::new(t.plan(), &k) else { return Err(not_held(system, at.speed)) };
        if lu.pivot_ratio().is_nan() {
            return Err(not_held(system, at.speed));
        }
        let mut step = r.clone();
        lu.solve(&mut step);
        let length = max_abs(&step.iter().zip(&typical).map(|(s, t)| s / t).collect::<Vec<_>>());
        if !length.is_finite() {
            return Err(not_held(system, at.speed));
        }
        let size = max_abs(&x.iter().zip(&typical).map(|(s, t)| s / t).collect::<Vec<_>>());
        // The natural measure of progress is the length of the simplified Newton step with this Jacobian.
        let mut share = 1.0;
        let (next, moved) = loop {
            let trial: Vec<f64> = x.iter().zip(&step).map(|(x, s)| x - share * s).collect();
            let mut moved = at.clone();
            place(&states, &trial, &mut moved);
            let mut again = residual(system, &moved, &mut t, &mut linear, &coordinates, &trial, held);
            lu.solve(&mut again);
            let rest = max_abs(&again.iter().zip(&typical).map(|(s, t)| s / t).collect::<Vec<_>>());
            if rest <= (1.0 - 0.25 * share) * length || length <= 1e-12 * (size + 1e-12) {
                break (trial, moved);
            }
            let resolved = || resolves(ROUNDINGS, length, (t.pattern(), &k, &lu), &x, &typical);
            if share == 1.0 && length <= RESOLVED * size && resolved() {
                (at.iterations, at.last_step) = (iteration, length);
                return Ok(at);
            }
            share *= 0.5;
            if share < 1e-6 {
                return Err(unfound(system, at.speed, length));
            }
        };
        (x, at) = (next, moved);
        (at.iterations, at.last_step) = (iteration, length);
        t.move_to(&at);
        r = residual(system, &at, &mut t, &mut linear, &coordinates, &x, held);
        if length <= 1e-13 * size || (length >= 0.5 * last && length <= 1e-9 * (size + 1e-9)) || length <= 1e-18 {
            return Ok(at);
        }
        last = length;
    }
    Err(unfound(system, at.speed, last))
}

/// Of a machine of linear parts Newton's first step leads to its equilibrium, unless nothing holds some motion of it.
pub(super) fn unfound(system: &System, speed: f64, step: f64) -> Diagnostic {
    if system.slots().iter().all(|s| s.is_linear()) { not_held(system, speed) } else { no_equilibrium(step) }
}

/// Near the equilibrium of a machine that has no stiffness where it starts: bodies sink under their loads, slowed by a support that moves along, until
/// what they meet carries them. `None` when they sink on and on.
fn sink(system: &System, start: &Equilibrium, held: &[usize]) -> Option<Equilibrium> {
    const MOST: usize = 300;
    const CARRIED: f64 = 1e-6;
    let coordinates = coordinate_sectors(system);
    let n = system.n();
    let typical: Vec<f64> = system.coordinates().iter().map(|c| c.dof.typical).collect();
    let mut at = start.clone();
    let mut t = Characteristic::new(system, &at);
    let (states, mut linear) = (t.states().to_vec(), None);
    // largest work of a load over a typical displacement, at the start
    let mut first = None;
    for _ in 0..MOST {
        t.move_to(&at);
        let mut x: Vec<f64> = at.q.iter().copied().chain(states.iter().map(|&s| at.z[s])).collect();
        let mut r = residual(system, &at, &mut t, &mut linear, &coordinates, &x, held);
        let work = max_abs(&r[..n].iter().zip(&typical).map(|(r, t)| r * t).collect::<Vec<_>>());
        let load = *first.get_or_insert(work);
        if work <= CARRIED * load {
            return Some(at);
        }
        let mut k = t.stiffness_entries();
        hold(t.pattern(), &mut k, held);
        for i in 0..n {
            t.pattern().row(i).filter(|x| x.1 == i).for_each(|(e, _)| k[e] += load / (typical[i] * typical[i]));
        }
        Factors::new(t.plan(), &k).ok()?.solve(&mut r);
        // nothing that is not a number goes on
        if !r.iter().all(|s| s.is_finite()) {
            return None;
        }
        x.iter_mut().zip(&r).for_each(|(x, s)| *x -= s);
        at.q.copy_from_slice(&x[..n]);
        for (&s, &x) in states.iter().zip(&x[n..]) {
            at.z[s] = x;
        }
    }
    None
}

pub(super) fn not_held(system: &System, speed: f64) -> Diagnostic {
    let free = instead(system, speed);
    Diagnostic::error("rest.not_held", text!("the machine has no equilibrium under its loads: some coordinate is not held by any stiffness"))
        .help(text!("attach a bearing, shaft or foundation to every body that carries a load; masses that move freely, such as the balls of a balancer, have no equilibrium at rest: {free}", free))
}

fn no_equilibrium(step: f64) -> Diagnostic {
    Diagnostic::error(
        "rest.not_found",
        text!("no equilibrium was found (Newton's method stopped with a step of {step} typical sizes)", step = text::number(step, 2)),
    )
    .help(text!("check the load and the characteristics of nonlinear parts, or start from another state"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::Builder;
    use crate::model::field::Attach;
    use crate::model::params::Listed;
    use crate::model::part::Link;
    use laval_model::parts::bearing_linear::{BearingLinear, BearingLinearParams};
    use laval_model::parts::shaft::{SectionParams, Shaft, ShaftParams};

    fn lying_shaft(rotating_damping: f64) -> System {
        let bearing = || BearingLinearParams { kxx: 1e6, kyy: 2e6, cyy: 20.0, ..BearingLinearParams::new() };
        let own = ShaftParams { rotating_damping, ..ShaftParams::new() };
        let held = |z: f64| BearingLinear::constant(Link::Between(Attach::at("shaft", z), Attach::ground()));
        Builder::new("shaft")
            .horizontal()
            .part("a", held(0.0), bearing())
            .part(
                "shaft",
                Shaft::new(&[0.3, 0.5], &[0.04, 0.05]),
                Listed { own, rows: vec![SectionParams::new(0.04), SectionParams::new(0.05)] },
            )
            .part("b", held(0.8), bearing())
            .build()
            .unwrap()
    }

    /// The sag of a shaft is that of any speed, to the bit; damping that turns with it moves it sideways by the speed.
    #[test]
    fn rest_over_the_speed_is_that_at_each() {
        for rotating_damping in [0.0, 1e-5] {
            let system = lying_shaft(rotating_damping);
            assert_eq!(same_at_every_speed(&system), rotating_damping == 0.0);
            let state = over_speed(&system);
            let still = rest(&system, 0.0).unwrap();
            assert!(max_abs(&still.q) > 1e-6);
            for speed in [0.0, 1.0, 300.0, -500.0] {
                let (found, own) = (state(speed).unwrap(), rest(&system, speed).unwrap());
                assert!(found.speed == speed && found.frame == own.frame);
                assert_eq!((&found.q, &found.z), (&own.q, &own.z));
                assert_eq!(found.q == still.q, rotating_damping == 0.0 || speed == 0.0);
            }
        }
    }
}
