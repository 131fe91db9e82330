//! What the studies in time share: their common fields, and the request of an integration.

pub mod energy;
mod findings;
mod tables;

pub(in crate::study) use findings::{
    ProbeMotion, common_findings, end, last_moment, probe_motions, reduced_to, stop, time_forms, unbounded,
};
pub(in crate::study) use tables::{Columns, shown, sound};

use super::start::Start;
use crate::diagnostic::Diagnostic;
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::{Station, System};
use crate::outcome::quantity;
use crate::solve::large::is_large;
use crate::solve::motion::trajectory::{Choice, Plan, Trajectory, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::solve::programme::Programme;
use crate::solve::reduced_machine::ReducedMachine;
use crate::study::Context;
use crate::study::shared::size::{KEPT, LISTED, Size};
use crate::study::shared::watch;
use crate::text;
use std::f64::consts::TAU;

/// `method`.
pub(in crate::study) const METHOD: Field = Field::optional(
    "method",
    FieldKind::Choice(&[
        ("auto", "explicit unless memory states or stability make it slow"),
        ("explicit", "order 8, for motions that are not stiff"),
        ("stiff", "implicit, order 5"),
    ]),
    "auto",
    "method of integration",
);
/// `relative_tolerance`.
pub(in crate::study) const RELATIVE: Field = Field::optional(
    "relative_tolerance",
    FieldKind::Quantity { unit: "", bounds: Bounds { min: 1e-14, max: 1e-2, min_open: false } },
    "1e-8",
    "tolerated error of a step over the size of each state",
);
/// `absolute_tolerance`.
pub(in crate::study) const ABSOLUTE: Field = Field::optional(
    "absolute_tolerance",
    FieldKind::Quantity { unit: "", bounds: Bounds { min: 1e-18, max: 1e-2, min_open: false } },
    "",
    "tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given, \
        but at most 1e-9",
);
/// `points`.
pub(in crate::study) const POINTS: Field =
    Field::optional("points", FieldKind::Integer { min: 2, max: 1_000_000 }, "2000", "number of output times, equally spaced");
/// `phase`.
pub(in crate::study) const PHASE: Field =
    Field::optional("phase", FieldKind::Quantity { unit: "rad", bounds: Bounds::within(1e6) }, "0 rad", "spin angle at the start");

/// Settings of the integration from their fields.
#[derive(Clone, Debug)]
pub(in crate::study) struct Settings {
    pub method: Choice,
    pub relative: f64,
    pub absolute: f64,
    pub points: usize,
    pub phase: f64,
}

impl Settings {
    pub fn read(values: &Values) -> Self {
        let relative = values.number("relative_tolerance").unwrap_or(1e-8);
        Settings {
            method: method(values),
            relative,
            // small motions would keep to the absolute one alone, however exact the relative one
            absolute: values.number("absolute_tolerance").unwrap_or((0.1 * relative).min(1e-9)),
            points: values.integer("points").map_or(2000, |x| x.max(2) as usize),
            phase: values.number("phase").unwrap_or(0.0),
        }
    }
}

/// The field [`METHOD`].
pub(in crate::study) fn method(values: &Values) -> Choice {
    match values.choice("method") {
        Some("explicit") => Choice::Explicit,
        Some("stiff") => Choice::Stiff,
        _ => Choice::Auto,
    }
}

/// A machine of many coordinates as one of few, where its motion is not computed by entries: with movable masses, memory states or coordinates without inertia.
pub(in crate::study) fn reduced(timed: &System, programme: Programme) -> Option<ReducedMachine> {
    let fastest = programme.largest_speed();
    let by_entries = is_large(timed) && Motion::new(timed, SpinLaw::Programme(programme)).is_ok_and(|m| m.is_by_entries());
    if by_entries { None } else { ReducedMachine::of(timed, fastest) }
}

/// What the record of a motion takes.
pub(in crate::study) fn size(system: &System, outputs: usize, velocities: bool, observables: bool) -> Size {
    let (n, m, parts) = (system.n(), system.m(), system.slots().len());
    let listed = n * if velocities { 2 } else { 1 } + if observables { 3 * parts } else { 0 } + 8;
    Size {
        bytes: outputs as f64 * (KEPT * (2 * n + m + 6) as f64 + LISTED * listed as f64),
        of: text!("{outputs} output times of {n} coordinates", outputs, n),
        fewer: text!("give fewer points (a longer output_step), or leave out velocities and observables"),
    }
}

/// That a study was stopped while the time form of its machine was made.
pub(in crate::study) fn stopped() -> Diagnostic {
    Diagnostic::error(watch::STOPPED, text!("the study was stopped before its machine in time was there"))
}

/// The motion of this machine can be integrated in the way requested.
pub(in crate::study) fn admit(motion: &Motion, method: Choice) -> Result<(), Diagnostic> {
    match motion.refuses_explicit() {
        Some(d) if method == Choice::Explicit => Err(d),
        _ => Ok(()),
    }
}

/// Displacement that the integration cannot distinguish from none, m: a hundred times the tolerance of one step, for a typical displacement of 1 mm beside the sag.
/// At rest no error shortens the steps, and they grow to the border of stability, where noise of some tolerances stays alive.
pub(in crate::study) fn negligible(settings: &Settings, rest: &[f64]) -> f64 {
    let sag = rest.iter().fold(0.0, |m: f64, q| m.max(q.abs()));
    100.0 * (1e-3 * settings.absolute + settings.relative * sag)
}

/// Displacement from rest beyond which a motion is left, m: a hundred thousand times the largest of a typical displacement, the start and the lengths among the
/// parameters. No law of a part holds so far out.
pub(in crate::study) fn bound(system: &System, start: &Start, y: &[f64]) -> f64 {
    let lengths = system.param_slots().iter().zip(system.params()).filter(|(slot, _)| slot.unit == "m").map(|(_, x)| x.abs());
    let place = |s: &Station| {
        let (at, rest) = (s.lateral.of(y), s.lateral.of(&start.rest));
        [0, 1].map(|k| (at[k] - rest[k]).abs().max(rest[k].abs()).max(1e-3))
    };
    let places = system.stations().iter().flat_map(place);
    1e5 * lengths.chain(places).filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// The trajectory as far as its bound again, with all its windows and this many outputs in that time.
pub(in crate::study) fn magnified(
    motion: &mut Motion,
    y: &[f64],
    plan: &Plan,
    trajectory: Trajectory,
    points: usize,
) -> Result<Trajectory, Diagnostic> {
    let Some(left) = trajectory.left else { return Ok(trajectory) };
    let outputs = spaced(left.t, points);
    let choice = if trajectory.stiff { Choice::Stiff } else { Choice::Explicit };
    let again = simulate(motion, y, &Plan { t_end: left.t, outputs: &outputs, choice, bound: f64::INFINITY, ..plan.clone() })?;
    Ok(Trajectory { left: Some(left), ..again })
}

/// Equally spaced times from 0 to `t_end`, both included.
pub(in crate::study) fn spaced(t_end: f64, points: usize) -> Vec<f64> {
    (0..points).map(|i| if i + 1 == points { t_end } else { t_end * i as f64 / (points - 1) as f64 }).collect()
}

/// Rate of a unit.
pub(in crate::study) fn per_second(unit: &str) -> String {
    match unit {
        "" => "1/s".into(),
        "m/s" => "m/s^2".into(),
        u if u.contains('/') => format!("{u}/s"),
        u => format!("{u}/s"),
    }
}

/// Says how much there is to integrate: turns of the rotor at the mean speed, rad/s.
pub(in crate::study) fn announce(context: &Context, duration: f64, speed: f64) {
    let turns = duration * speed.abs() / TAU;
    context.announce(turns, 1e5, text!("turns of the rotor to integrate, {duration}", duration = quantity(duration, "s")));
}

/// Parts of the time that are distinguished: a motion over years moves on by few thousandths an hour.
const PARTS: u64 = 1_000_000_000;

/// Reports the share of the time that is reached.
pub(in crate::study) fn progress<'c>(context: &'c Context, t_end: f64) -> impl Fn(f64) + 'c {
    move |t| context.progress.report((PARTS as f64 * (t / t_end).clamp(0.0, 1.0)) as u64, PARTS)
}
