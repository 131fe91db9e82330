//! Findings, a table and figures of parts that balance by themselves: the unbalance that remains and its grade, whether their masses suffice, when it settles.

use super::animation;
use super::history::{Columns, last_moment, sound};
use super::record::MotionRecord;
use crate::diagnostic::Diagnostic;
use crate::model::part::DofKind;
use crate::model::system::{System, Workspace};
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Outcome, Panel};
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;
use crate::solve::pencil::modes_about;
use crate::solve::rest::rest;
use crate::solve::unbalance::{Unbalance, unbalance};
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// The unbalance counts as settled while it stays within this share of that without balancing from what it is at the end.
const SETTLED: f64 = 0.05;
/// Drift over a part of the record, over the unbalance without balancing, that counts as none.
const STILL: f64 = 1e-4;
/// Fewest outputs from which a drift is reported.
const FEWEST: usize = 75;

/// The unbalance of a machine with parts that balance by themselves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Balancing {
    /// At the outputs of the motion.
    pub unbalance: Vec<Unbalance>,
    /// Masses that do not follow the rotor at the end.
    pub caught: Option<Caught>,
}

/// Masses that do not follow the rotor at the end of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Caught {
    /// Number of them.
    pub count: usize,
    /// Mean rate in the rotor of the one that slips most, rad/s.
    pub slip: f64,
    /// Mean speed of the rotor meanwhile, rad/s.
    pub speed: f64,
    /// Time over which both are averaged, s.
    pub span: f64,
    /// Natural frequency near which it goes round, rad/s.
    pub near: Option<f64>,
}

/// `None` of a machine without such parts.
pub(in crate::study) fn balancing(motion: &mut Motion, trajectory: &Trajectory) -> Option<Balancing> {
    let system = motion.system();
    let dim = trajectory.state.len().max(1);
    let mut ws = Workspace::default();
    let mut all = Vec::new();
    for (&t, y) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)) {
        let seen = motion.with_point(t, y, |s, at| (!s.corrections(at, &mut ws).is_empty()).then(|| unbalance(system, at, &mut ws)));
        all.push(seen.ok()??);
    }
    (!all.is_empty()).then(|| Balancing { unbalance: all, caught: caught(motion, trajectory) })
}

/// Appends the warnings of parts; for a machine with parts that balance by themselves the findings, a table and figures.
///
/// # Errors
/// An outcome that does not hold together.
pub(in crate::study) fn report(system: &System, record: &MotionRecord, mut outcome: Outcome) -> Result<Outcome, Diagnostic> {
    for (slot, text) in system.warnings() {
        let name = &system.slots()[slot].name;
        let finding = Finding::warning("purpose", "balance-purpose").arg("part", Arg::name(name)).arg("why", text);
        outcome = outcome.finding(finding.of(name));
    }
    let Some(balancing) = &record.balancing else { return Ok(outcome) };
    for finding in findings(balancing, record).into_iter().chain(balancing.caught.as_ref().map(masses_caught)) {
        outcome = outcome.finding(finding);
    }
    let at = &balancing.unbalance;
    let column = |f: &dyn Fn(usize) -> f64| (0..at.len()).map(f).collect::<Vec<f64>>();
    let mut c = Columns::default();
    c.add("t", "s", "time", record.times.clone());
    c.add("unbalance", "kg m", "unbalance with the balls where they are", column(&|i| at[i].moment.abs()));
    c.add("without", "kg m", "unbalance without the balls", column(&|i| at[i].without()));
    c.add("capacity", "kg m", "the most the balls can cancel", column(&|i| at[i].capacity));
    c.add(
        "grade",
        "m/s",
        "spin speed times unbalance over mass (ISO 21940-11)",
        column(&|i| at[i].grade(at[i].moment.abs(), record.spin[i].speed)),
    );
    let line = |column: &'static str| Line::new("balance", "t", column).name(column);
    let figure = Figure::new("balance", "Unbalance", "balance-alt")
        .x(Axis::new("time", "s"))
        .panel(Panel::new(Axis::new("unbalance", "g mm").factor(1e6)).mark(line("unbalance")).mark(line("without")).mark(line("capacity")))
        .panel(Panel::new(Axis::new("grade", "mm/s").factor(1e3)).mark(line("grade")));
    outcome = outcome.table(c.table("balance", "Unbalance against time")?).figure(figure);
    outcome = match angles(system) {
        Some(figure) => outcome.figure(figure),
        None => outcome,
    };
    if let Some(rotor) = &record.animation {
        outcome = animation::report(system, rotor, outcome)?;
    }
    sound(outcome.checked())
}

/// Share of an unbalance that is rounding.
const NOTHING: f64 = 1e-9;
/// Share of the trajectory at its end over which rates are averaged.
const LATE: usize = 5;
/// Mean rate in the rotor over its speed from which masses do not follow it.
const SLIPS: f64 = 0.01;
/// Distance of their rate from a natural frequency, over it, at which that is named.
const HELD: f64 = 0.1;

/// Masses that do not follow the rotor at the end, and the natural frequency near which they go round.
fn caught(motion: &Motion, trajectory: &Trajectory) -> Option<Caught> {
    let system = motion.system();
    let (dim, count) = (trajectory.state.len().max(1), trajectory.times.len());
    let from = count.checked_sub(1 + count / LATE)?;
    let state = |k: usize| &trajectory.states[k * dim..(k + 1) * dim];
    let (begin, end) = (state(from), state(count - 1));
    let span = trajectory.times[count - 1] - trajectory.times[from];
    let speed = (motion.spin(trajectory.times[count - 1], end).phase - motion.spin(trajectory.times[from], begin).phase) / span;
    let inside = system.coordinates().iter().enumerate().filter(|(_, c)| c.dof.kind == DofKind::Scalar && c.dof.unit == "rad");
    let slips: Vec<f64> = inside.map(|(i, _)| (end[i] - begin[i]) / span).filter(|s| s.abs() > SLIPS * speed.abs()).collect();
    let most = slips.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).filter(|s| s.is_finite())?;
    let rate = speed + most;
    let own = rest(system, speed).ok().and_then(|at| modes_about(system, &at, false).ok());
    let near =
        own.iter().flat_map(|s| &s.modes).map(|m| m.frequency()).min_by(|a, b| (a - rate.abs()).abs().total_cmp(&(b - rate.abs()).abs()));
    let near = near.filter(|f| *f > 0.0 && (f - rate.abs()).abs() <= HELD * f);
    Some(Caught { count: slips.len(), slip: most, speed, span, near })
}

fn masses_caught(caught: &Caught) -> Finding {
    let finding = match caught.near {
        Some(f) => Finding::warning("masses_caught", "balance-masses-caught").arg("near", Arg::frequency(f)),
        None => Finding::warning("masses_caught", "balance-masses-slip"),
    };
    let finding = finding.value(caught.speed + caught.slip, "rad/s").arg("speed", Arg::speed(caught.speed));
    let finding = finding.arg("count", Arg::count(caught.count)).evidence("mean slip", caught.slip, "rad/s");
    finding.evidence("averaged over", caught.span, "s")
}

/// Turns of the rotor on either side of a time over which masses are watched, and turns in it that they make meanwhile when they go round.
const WATCHED: f64 = 8.0;
const ROUND: f64 = 0.5;

/// Whether masses go round in the rotor about a time, which turns by `phase` (rad).
pub(in crate::study) fn slips(system: &System, trajectory: &Trajectory, t: f64, phase: &dyn Fn(f64) -> f64) -> bool {
    let dim = trajectory.state.len().max(1);
    let mut near = (0..trajectory.times.len()).filter(|&k| (phase(trajectory.times[k]) - phase(t)).abs() <= TAU * WATCHED);
    let (Some(first), Some(last)) = (near.next(), near.next_back()) else { return false };
    let state = |k: usize| &trajectory.states[k * dim..(k + 1) * dim];
    let inside = system.coordinates().iter().enumerate().filter(|(_, c)| c.dof.kind == DofKind::Scalar && c.dof.unit == "rad");
    inside.map(|(i, _)| (state(last)[i] - state(first)[i]).abs()).any(|turned| turned > TAU * ROUND)
}

/// Angles of what moves in the rotor, against time.
fn angles(system: &System) -> Option<Figure> {
    let inside: Vec<&str> =
        system.coordinates().iter().filter(|c| c.dof.kind == DofKind::Scalar && c.dof.unit == "rad").map(|c| c.name.as_str()).collect();
    let mut panel = Panel::new(Axis::new("angle in the rotor", "°").factor(360.0 / TAU).range(-180.0, 180.0));
    for name in &inside {
        panel = panel.mark(Line::new("motion", "t", *name).wrapped().name(Arg::name(*name)));
    }
    (!inside.is_empty()).then(|| Figure::new("angles", "Angles in the rotor", "balance-alt-angles").x(Axis::new("time", "s")).panel(panel))
}

/// Findings of the unbalance.
fn findings(balancing: &Balancing, record: &MotionRecord) -> Vec<Finding> {
    let (at, slips) = (&balancing.unbalance, balancing.caught.is_some());
    let (Some(last), Some(speed)) = (at.last(), record.spin.last().map(|s| s.speed)) else { return Vec::new() };
    let (left, without) = (last.moment.abs(), last.without());
    let mut out = Vec::new();
    let harm = left > (1.0 + NOTHING) * without;
    let finding = if harm {
        Finding::warning("residual_unbalance", "balance-increased")
    } else {
        Finding::info("residual_unbalance", "balance-residual")
    };
    out.push(
        finding
            .value(left, "kg m")
            .arg("without", Arg::quantity(without, "kg m"))
            .arg("when", last_moment(record))
            .evidence("without the balls", without, "kg m")
            .evidence("grade number (ISO 21940-11)", last.grade(left, speed), "m/s")
            .evidence("grade number without the balls", last.grade(without, speed), "m/s"),
    );
    if !(last.capacity >= (1.0 - NOTHING) * without) {
        let finding = Finding::warning("insufficient_capacity", "balance-insufficient-capacity").value(last.capacity, "kg m");
        out.push(finding.arg("without", Arg::quantity(without, "kg m")).evidence("needed", without, "kg m"));
    }
    let away = |u: &Unbalance| !((u.moment.abs() - left).abs() <= SETTLED * without);
    let (count, since) = (at.len(), at.iter().rposition(away));
    // for a fifth of the time at least
    let lasting = since.is_none_or(|i| i + count / LATE < count);
    if slips || !lasting || !(remaining(at) <= SETTLED * without) {
        out.push(Finding::info("balance_unsettled", "balance-unsettled").arg("when", last_moment(record)));
    } else if let (Some(i), false) = (since, harm) {
        let finding = Finding::info("time_to_balance", "balance-settling-time").value(record.times[i + 1], "s");
        out.push(finding.arg("share", Arg::percent(SETTLED)).evidence("within this share of the unbalance without balls", SETTLED, ""));
    }
    out
}

/// How far an unbalance may still go from where it is at the end of the record, kg m: what its means over the thirds of the last part of the record differ by, summed like a
/// geometric series. Infinite where it drifts on at an undiminished rate.
fn remaining(at: &[Unbalance]) -> f64 {
    let (Some(last), part) = (at.last(), at.len() / LATE / 3) else { return f64::INFINITY };
    if at.len() < FEWEST {
        return f64::INFINITY;
    }
    let mean = |k: usize| {
        let range = &at[at.len() - (k + 1) * part..at.len() - k * part];
        range.iter().fold(C64::zero(), |sum, u| sum + u.moment).scale(1.0 / part as f64)
    };
    let [first, second, third] = [2, 1, 0].map(mean);
    let (before, late) = ((second - first).abs(), (third - second).abs());
    if late <= STILL * last.without() {
        return late;
    }
    // NaN goes on
    if late < before { late * late / (before - late) + late } else { f64::INFINITY }
}
