//! What the studies in time share: their common fields, tables and figures of the motion, energy, and the sentences about them.

use super::passages::envelope;
use super::start::Start;
use super::turns;
use crate::diagnostic::Diagnostic;
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::part::{Physics, TimeForm};
use crate::model::system::{System, Workspace};
use crate::outcome::{Axis, End, Figure, Finding, Line, Outcome, OutcomeError, Panel, Table, quantity};
use crate::solve::motion::envelope::{Peak, Window, growth_of};
use crate::solve::motion::trajectory::{Choice, Plan, Trajectory, Use, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::study::Context;
use crate::study::shared::size::{KEPT, LISTED, Size};
use laval_num::ode;
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

/// What the record of a motion takes.
pub(in crate::study) fn size(system: &System, outputs: usize, velocities: bool, observables: bool) -> Size {
    let (n, m, parts) = (system.n(), system.m(), system.slots().len());
    let listed = n * if velocities { 2 } else { 1 } + if observables { 3 * parts } else { 0 } + 8;
    Size {
        bytes: outputs as f64 * (KEPT * (2 * n + m + 6) as f64 + LISTED * listed as f64),
        of: format!("{outputs} output times of {n} coordinates"),
        fewer: "give fewer points (a longer output_step), or leave out velocities and observables",
    }
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
pub(in crate::study) fn negligible(settings: &Settings, start: &Start) -> f64 {
    let sag = start.rest.iter().fold(0.0, |m: f64, q| m.max(q.abs()));
    100.0 * (1e-3 * settings.absolute + settings.relative * sag)
}

/// Displacement from rest beyond which a motion is left, m: a hundred thousand times the largest of a typical displacement, the start and the lengths among the
/// parameters. No law of a part holds so far out.
pub(in crate::study) fn bound(system: &System, start: &Start, y: &[f64]) -> f64 {
    let lengths = system.param_slots().iter().zip(system.params()).filter(|(slot, _)| slot.unit == "m").map(|(_, x)| x.abs());
    let places = system.bodies().into_iter().flat_map(|b| [b.x, b.x + 1]);
    let places = places.map(|i| (y[i] - start.rest[i]).abs().max(start.rest[i].abs()).max(system.coordinates()[i].dof.typical));
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

/// That a motion passed its bound, from its [`magnified`] trajectory; a turn of the rotor takes `turn` (s).
pub(in crate::study) fn unbounded(system: &System, trajectory: &Trajectory, turn: f64) -> Option<Finding> {
    let left = trajectory.left?;
    let body = &system.bodies()[left.body].name;
    let (at, place) = (quantity(left.t, "s"), quantity(left.displacement, "m"));
    let where_ = format!("it was left at {at}, {place} from its place of rest");
    // many e-folds in few turns tell the rate as well as many turns
    let finding = match growth_of(&trajectory.windows[left.body], turn, 4) {
        Some(g) if g.rate > g.uncertainty => {
            let text = format!("The motion of \"{body}\" grows without bound, at {{}} over the second half of the record; {where_}.");
            Finding::warning("unbounded", text).value(g.rate, "1/s").evidence("uncertainty", g.uncertainty, "1/s")
        }
        _ => Finding::warning("unbounded", format!("The motion of \"{body}\" goes beyond all bounds; {where_}.")),
    };
    Some(finding.of(body).evidence("left at", left.t, "s").evidence("displacement there", left.displacement, "m"))
}

/// What is seen of the motion of a body: its displacement, at any of its points where something is attached, or its tilt.
pub(in crate::study) struct ProbeMotion<'f> {
    pub body: String,
    pub tilt: bool,
    pub peak: Peak,
    pub windows: &'f [Window],
    pub unit: &'static str,
    /// Up to here it is none.
    pub still: f64,
    /// The other of displacement and tilt is more than none.
    other: bool,
}

/// Displacements of the bodies, then tilts; `still` (m) is no displacement.
pub(in crate::study) fn probe_motions<'f>(system: &System, trajectory: &'f Trajectory, still: f64) -> Vec<ProbeMotion<'f>> {
    // typical sizes are 1 mm and 10 mrad
    let still_tilt = 10.0 * still;
    let bodies = system.bodies();
    let name = |k: usize| bodies.get(k).map_or_else(String::new, |b| b.name.clone());
    let tilted = |k: usize| trajectory.tilts.iter().any(|t| t.body == k && !(t.peak.amplitude <= still_tilt));
    let moved = trajectory.peaks.iter().zip(&trajectory.windows).enumerate().map(|(k, (peak, windows))| ProbeMotion {
        body: name(k),
        tilt: false,
        peak: *peak,
        windows,
        unit: "m",
        still,
        other: tilted(k),
    });
    let tilts = trajectory.tilts.iter().map(|t| ProbeMotion {
        body: name(t.body),
        tilt: true,
        peak: t.peak,
        windows: &t.windows,
        unit: "rad",
        still: still_tilt,
        other: !(trajectory.peaks[t.body].amplitude <= still),
    });
    moved.chain(tilts).collect()
}

impl ProbeMotion<'_> {
    /// As the subject of a finding.
    pub fn label(&self) -> String {
        if self.tilt { format!("tilt of {}", self.body) } else { self.body.clone() }
    }
    /// As the subject of a sentence.
    pub fn words(&self) -> String {
        if self.tilt { format!("The tilt of \"{}\"", self.body) } else { format!("\"{}\"", self.body) }
    }
    /// It is more than none.
    pub fn moves(&self) -> bool {
        !(self.peak.amplitude <= self.still)
    }
    /// The largest in a sentence; nothing of a tilt that is none.
    pub fn largest(&self) -> Option<Finding> {
        let (id, what) = if self.tilt { ("largest_tilt", "tilt") } else { ("largest_displacement", "displacement") };
        if self.moves() {
            let text = format!("The largest {what} of \"{}\" from rest is {{}}.", self.body);
            return Some(Finding::info(id, text).of(&self.body).value(self.peak.amplitude, self.unit));
        }
        let but = if self.other { "; it tilts" } else { "" };
        let text = format!("\"{}\" does not move from its place of rest, to the tolerance of the integration{but}.", self.body);
        (!self.tilt).then(|| Finding::info(id, text).of(&self.body).value(0.0, "m"))
    }
}

/// Equally spaced times from 0 to `t_end`, both included.
pub(in crate::study) fn spaced(t_end: f64, points: usize) -> Vec<f64> {
    (0..points).map(|i| if i + 1 == points { t_end } else { t_end * i as f64 / (points - 1) as f64 }).collect()
}

/// How the integration ended, in the words of an outcome, with what must be said about it.
pub(in crate::study) fn ended(trajectory: &Trajectory) -> (End, Option<Finding>) {
    if let Some(left) = trajectory.left {
        return (End::Unbounded { at: left.t }, None);
    }
    match &trajectory.run.end {
        ode::End::Reached | ode::End::Event { .. } => (End::Reached, None),
        ode::End::Cancelled { .. } => (End::Cancelled, None),
        ode::End::WorkLimit { t } => {
            let text = "The limit on the number of steps (--work-limit) was reached at {}.";
            (End::WorkLimit, Some(Finding::warning("work_limit", text).value(*t, "s")))
        }
        ode::End::StepTooSmall { t, .. } => {
            let text = "The integration could not go on at {}: no step, however short, met the tolerance. The motion may run away there.";
            (End::StepTooSmall { at: *t }, Some(Finding::warning("integration_stopped", text).value(*t, "s")))
        }
        ode::End::Failed { t, what } => {
            let text = format!("The integration could not go on at {{}}: {what}.");
            (End::StepTooSmall { at: *t }, Some(Finding::warning("integration_stopped", text).value(*t, "s")))
        }
    }
}

/// When the record of a motion ends, as words at the end of a clause and at the beginning of a sentence.
pub(in crate::study) fn end_in_words(trajectory: &Trajectory) -> [String; 2] {
    match trajectory.run.end {
        ode::End::Reached | ode::End::Event { .. } => ["by the end".into(), "At the end".into()],
        _ => {
            let at = quantity(trajectory.run.t, "s");
            [format!("by {at}, where it was stopped"), format!("At {at}, where it was stopped,")]
        }
    }
}

/// Calls for an outcome whose names fit; a misfit is a mistake of the study.
pub(in crate::study) fn sound(outcome: Result<Outcome, OutcomeError>) -> Result<Outcome, Diagnostic> {
    outcome.map_err(misfit)
}
pub(in crate::study) fn misfit(e: OutcomeError) -> Diagnostic {
    e.into()
}

/// Columns collected row by row.
#[derive(Default)]
pub(in crate::study) struct Columns(Vec<(String, String, String, Vec<f64>)>);

impl Columns {
    pub fn add(&mut self, name: impl Into<String>, unit: &str, doc: impl Into<String>, values: Vec<f64>) {
        self.0.push((name.into(), unit.into(), doc.into(), values));
    }
    pub fn table(self, name: &str, doc: &str) -> Result<Table, Diagnostic> {
        let mut builder = Table::new(name, doc);
        for (name, unit, doc, values) in self.0 {
            builder = builder.float(name, unit, doc, values);
        }
        builder.build().map_err(misfit)
    }
}

/// Rate of a unit.
fn per_second(unit: &str) -> String {
    match unit {
        "" => "1/s".into(),
        "m/s" => "m/s^2".into(),
        u if u.contains('/') => format!("{u}/s"),
        u => format!("{u}/s"),
    }
}

/// The states at the outputs.
pub(in crate::study) fn motion_table(motion: &Motion, trajectory: &Trajectory, velocities: bool) -> Result<Table, Diagnostic> {
    let system = motion.system();
    let (n, dim) = (system.n(), trajectory.state.len());
    let rows = || trajectory.states.chunks_exact(dim.max(1));
    let column = |i: usize| rows().map(|y| y[i]).collect::<Vec<f64>>();
    let mut c = Columns::default();
    c.add("t", "s", "time", trajectory.times.clone());
    let spins: Vec<_> = trajectory.times.iter().zip(rows()).map(|(&t, y)| motion.spin(t, y)).collect();
    c.add("speed", "rad/s", "spin speed", spins.iter().map(|s| s.speed).collect());
    c.add("phase", "rad", "spin angle", spins.iter().map(|s| s.phase).collect());
    for (i, d) in system.coordinates().iter().enumerate() {
        c.add(&d.name, d.dof.unit, "coordinate", column(i));
    }
    if velocities {
        for (i, d) in system.coordinates().iter().enumerate() {
            c.add(format!("{}'", d.name), &per_second(d.dof.unit), "rate of the coordinate", column(n + i));
        }
    }
    // memory states are many and mean nothing one by one
    for (k, slot) in system.slots().iter().enumerate() {
        for i in slot.states.start..slot.states.end - slot.memory {
            let d = &system.states()[i];
            debug_assert_eq!(d.slot, k);
            c.add(&d.name, d.dof.unit, "internal state", column(2 * n + i));
        }
    }
    c.table("motion", "Motion of the machine against time")
}

/// What the parts show at the outputs; `None` when they show nothing.
pub(in crate::study) fn observed_table(motion: &mut Motion, trajectory: &Trajectory) -> Result<Option<Table>, Diagnostic> {
    let system = motion.system();
    let dim = trajectory.state.len();
    let mut workspace = Workspace::default();
    let mut series: Vec<(String, &'static str, Vec<f64>)> = Vec::new();
    for (row, (&t, y)) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim.max(1))).enumerate() {
        let seen = motion.with_point(t, y, |s, at| s.observe(at, &mut workspace)).unwrap_or_default();
        for (slot, o) in seen {
            let name = format!("{}.{}", system.slots()[slot].name, o.name);
            let k = series.iter().position(|s| s.0 == name).unwrap_or_else(|| {
                series.push((name, o.unit, Vec::new()));
                series.len() - 1
            });
            series[k].2.resize(row, f64::NAN);
            series[k].2.push(o.value);
        }
    }
    if series.is_empty() {
        return Ok(None);
    }
    let mut c = Columns::default();
    c.add("t", "s", "time", trajectory.times.clone());
    for (name, unit, mut values) in series {
        values.resize(trajectory.times.len(), f64::NAN);
        c.add(name, unit, "quantity a part shows", values);
    }
    c.table("observed", "Forces and other quantities the parts show, against time").map(Some)
}

/// The energy balance at the outputs.
pub(in crate::study) struct Balance {
    pub table: Table,
    /// Largest missing energy, J.
    pub missing: f64,
    /// Largest flows and changes, and the largest stored energy beside that of the spin alone, J.
    pub exchanged: f64,
    /// Largest stored energy, J.
    pub stored: f64,
}

/// `None` without an account.
pub(in crate::study) fn balance(motion: &mut Motion, trajectory: &Trajectory) -> Result<Option<Balance>, Diagnostic> {
    let Some(k) = motion.account_start() else { return Ok(None) };
    let dim = trajectory.state.len();
    let rows: Vec<&[f64]> = trajectory.states.chunks_exact(dim).collect();
    let stored: Vec<f64> = trajectory.times.iter().zip(&rows).map(|(&t, y)| motion.stored_energy(t, y).unwrap_or(f64::NAN)).collect();
    // the first output holds the energy of a kick at its time: the account begins before it
    let first = stored.first().zip(rows.first()).map_or(f64::NAN, |(e, y)| e - y[k + 1]);
    let (mut missing, mut swing, mut vibration, mut most) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
    let grow = |m: &mut f64, x: f64| {
        if x > *m || x.is_nan() {
            *m = x;
        }
    };
    let mut motionless = vec![0.0; dim];
    let mut lack = Vec::with_capacity(rows.len());
    let mut flows = [0.0f64; 4];
    for ((y, e), &t) in rows.iter().zip(&stored).zip(&trajectory.times) {
        if let Some(s) = motion.spin_start() {
            motionless[s..s + 2].copy_from_slice(&y[s..s + 2]);
        }
        let spin = motion.stored_energy(t, &motionless).unwrap_or(f64::NAN);
        grow(&mut vibration, (e - spin).abs());
        grow(&mut most, e.abs());
        let change = e - first;
        let x = change - (-y[k] + y[k + 1] + y[k + 2] + y[k + 3]);
        lack.push(x);
        grow(&mut missing, x.abs());
        grow(&mut swing, change.abs());
        for (f, x) in flows.iter_mut().zip(&y[k..]) {
            grow(f, x.abs());
        }
    }
    let column = |i: usize| rows.iter().map(|y| y[k + i]).collect::<Vec<f64>>();
    let mut c = Columns::default();
    c.add("t", "s", "time", trajectory.times.clone());
    c.add("change", "J", "change of the stored energy since the start", stored.iter().map(|e| e - first).collect());
    c.add("stored", "J", "kinetic and potential energy, that of the spin with it", stored);
    c.add("dissipated", "J", "turned into heat since the start", column(0));
    c.add("supplied", "J", "work of the parts' own sources and of a kick since the start", column(1));
    c.add("drive", "J", "work of the drive since the start", column(2));
    c.add("weight", "J", "work of the weight since the start", column(3));
    c.add("missing", "J", "change of the stored energy not explained by the others: the error of the integration", lack);
    Ok(Some(Balance {
        table: c.table("energy", "Energy balance against time")?,
        missing,
        exchanged: flows.iter().sum::<f64>() + swing + vibration,
        stored: most,
    }))
}

/// Rounding of an energy over its size: some tens of operations.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The balance in a sentence; of a motion that goes beyond all bounds it says nothing.
pub(in crate::study) fn balance_finding(balance: &Balance, trajectory: &Trajectory) -> Option<Finding> {
    if trajectory.left.is_some() {
        return None;
    }
    if !(balance.missing.is_finite() && balance.exchanged.is_finite()) {
        let text = "The energy balance could not be formed: energies leave the range of numbers.";
        return Some(Finding::warning("no_energy_balance", text));
    }
    // differences of stored energies hold no more digits than these
    let whole = balance.stored + balance.exchanged;
    if balance.missing <= ROUNDING * whole {
        let share = if whole > 0.0 { balance.missing / whole } else { 0.0 };
        let finding = Finding::info("energy_balance", "The energy balance closes to rounding: {} of the energy stored or exchanged.");
        return Some(finding.value(share, "").evidence("largest missing energy", balance.missing, "J").evidence("energy", whole, "J"));
    }
    let ratio = if balance.exchanged > 0.0 { balance.missing / balance.exchanged } else { balance.missing };
    let make = if ratio < 1e-4 { Finding::info } else { Finding::warning };
    let finding = make("energy_balance", "The energy balance closes to {} of the energy exchanged.").value(ratio, "");
    Some(finding.evidence("largest missing energy", balance.missing, "J").evidence("energy exchanged", balance.exchanged, "J"))
}

/// What the rational forms that stand for exact parts are worth.
pub(in crate::study) fn time_forms(system: &System, mut outcome: Outcome) -> Outcome {
    for slot in system.slots() {
        let Some(f) = slot.part.replaced_in_time().and_then(|r| r.fitted()) else { continue };
        let text = format!(
            "\"{}\" is integrated by a rational form of {} states, with a relative error of at most {{}} {}.",
            slot.name, f.states, f.scope
        );
        outcome = outcome.finding(Finding::info("time_form", text).of(&slot.name).value(f.error, ""));
    }
    outcome
}

/// What a motion uses of the validity of a part. One that starts outside, as the layer of a liquid that is not yet held on its wall, and is inside from some time on is
/// recognised by that time.
fn validity(motion: &Motion, trajectory: &Trajectory, u: &Use) -> Finding {
    let part = &motion.system().slots()[u.slot].name;
    let (Some(first), Some(until)) = (u.exceeded, u.until) else {
        let text = format!("\"{part}\" stays inside its model: {} is at most {{}}.", u.what);
        return Finding::info("validity", text).value(u.ratio, "").evidence("reached at", u.t, "s");
    };
    if first == u.begin && until < trajectory.run.t {
        let speed = speed_at(motion, trajectory, until);
        let after = crate::outcome::significant(u.after, 3);
        if until == 0.0 && speed == 0.0 {
            let text = format!(
                "\"{part}\" has no validity at standstill, where the motion starts. From the first step on {} is at most {{}}.",
                u.what
            );
            return Finding::info("validity", text).value(u.after, "");
        }
        let text = format!("\"{part}\" is not valid before {{}}: there {} exceeds 1. From then on it is at most {after}.", u.what);
        let finding = Finding::warning("validity", text).value(until, "s").evidence("speed then", speed, "rad/s");
        return finding.evidence("largest value from then on", u.after, "");
    }
    if u.ratio.is_infinite() {
        let text = format!("\"{part}\" leaves its model: {} grows without bound.", u.what);
        return Finding::invalid("validity", text).evidence("first exceeded at", first, "s");
    }
    let finding = Finding::invalid("validity", format!("\"{part}\" leaves its model: {} reaches {{}}, above 1.", u.what));
    finding.evidence("first exceeded at", first, "s").value(u.ratio, "").evidence("reached at", u.t, "s")
}

/// Spin speed at a time, rad/s; of a free spin at the output before it.
fn speed_at(motion: &Motion, trajectory: &Trajectory, t: f64) -> f64 {
    let last = trajectory.times.partition_point(|&x| x <= t).saturating_sub(1);
    let state = trajectory.states.chunks_exact(trajectory.state.len().max(1)).nth(last).unwrap_or(&trajectory.state);
    motion.spin(t, state).speed
}

/// Findings on validity, time forms and contacts.
pub(in crate::study) fn common_findings(motion: &Motion, trajectory: &Trajectory, mut outcome: Outcome) -> Outcome {
    let system = motion.system();
    for u in &trajectory.validity {
        outcome = outcome.finding(validity(motion, trajectory, u));
    }
    outcome = time_forms(system, outcome);
    for slot in system.slots() {
        if let Physics::Frequency(TimeForm::Fit(error)) = slot.physics {
            let text = format!("\"{}\" is integrated by a rational fit of its frequency form with relative error {{}}.", slot.name);
            outcome = outcome.finding(Finding::info("time_form", text).value(error, ""));
        }
    }
    if !trajectory.contacts.is_empty() {
        let count = trajectory.contacts.len() as f64;
        let finding =
            Finding::info("contacts", "Laws with a switch changed side {} times; the integration restarted at each.").value(count, "");
        outcome = outcome.finding(finding.evidence("first at", trajectory.contacts[0].2, "s"));
    }
    let w = &trajectory.run.work;
    outcome
        .work("steps", w.steps)
        .work("rejected_steps", w.rejected)
        .work("right_sides", w.rhs)
        .work("jacobians", w.jacobians)
        .work("factorisations", w.factorisations)
        .work(if trajectory.stiff { "stiff" } else { "explicit" }, 1)
}

/// What a study lists and draws of a motion.
pub(in crate::study) struct Listed {
    /// The rates too.
    pub velocities: bool,
    /// What the parts show.
    pub observables: bool,
    /// The last turns, where the outputs do not resolve the motion.
    pub path: Option<Table>,
    /// The envelope is drawn in place of a motion that is not resolved; not where the study draws its own.
    pub envelope: bool,
}

/// Appends figures of the bodies against time and as orbits. Where the outputs do not resolve the motion the envelope stands for it, and the orbits are those of
/// the last turns.
fn motion_figures(motion: &Motion, trajectory: &Trajectory, listed: &Listed, mut outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let system = motion.system();
    let bodies = system.bodies();
    if bodies.is_empty() {
        return Ok(outcome);
    }
    let mm = |label: &str| Axis::new(label, "mm").factor(1e3);
    let coarse = turns::coarse(motion, trajectory);
    let (title, alt) = match coarse {
        true => ("Envelope against time", "Largest displacement of each body from rest within a turn, against time."),
        false => ("Lateral motion of the bodies", "x and y of each body against time."),
    };
    let mut lateral = Figure::new("lateral", title, alt).x(Axis::new("time", "s"));
    let mut orbit = Figure::new("orbit", "Orbits of the bodies", "Path of each body in the plane, to scale.").x(mm("x")).equal();
    let path = if coarse { "last turns" } else { "motion" };
    let mut plane = Panel::new(mm("y"));
    for b in &bodies {
        let (x, y) = (&system.coordinates()[b.x].name, &system.coordinates()[b.x + 1].name);
        let line = |column: &String| Line::new("motion", "t", column).name(column);
        lateral = lateral.panel(match coarse {
            true => Panel::new(mm(&b.name)).mark(Line::new("envelope", "t", format!("{} amplitude", b.name)).name("envelope")),
            false => Panel::new(mm(&b.name)).mark(line(x)).mark(line(y)),
        });
        plane = plane.mark(Line::new(path, x, y).name(&b.name));
    }
    orbit = orbit.panel(plane);
    if coarse && listed.envelope {
        outcome = outcome.table(envelope_table(motion, trajectory)?);
    }
    if !coarse || listed.envelope {
        outcome = outcome.figure(lateral);
    }
    Ok(match (&listed.path, coarse) {
        (Some(table), true) => {
            orbit.title = "Orbits of the bodies over the last turns".into();
            outcome.table(table.clone()).figure(orbit)
        }
        (None, true) => outcome,
        (_, false) => outcome.figure(orbit),
    })
}

/// The largest displacements in successive windows.
fn envelope_table(motion: &Motion, trajectory: &Trajectory) -> Result<Table, Diagnostic> {
    let sizes = |windows: &Vec<Window>| -> Vec<f64> {
        let seen = match motion.law() {
            SpinLaw::Programme(p) => envelope(windows, &|t| p.at(t)),
            SpinLaw::Free => windows.iter().map(|w| w.peak).take_while(|p| p.amplitude.is_finite()).collect(),
        };
        seen.iter().map(|p| p.amplitude).collect()
    };
    let sizes: Vec<Vec<f64>> = trajectory.windows.iter().map(sizes).collect();
    let count = sizes.iter().map(Vec::len).min().unwrap_or(0);
    let mut c = Columns::default();
    c.add("t", "s", "end of the window", trajectory.windows.first().map_or(vec![], |w| w[..count].iter().map(|w| w.last).collect()));
    for (b, sizes) in motion.system().bodies().iter().zip(sizes) {
        c.add(format!("{} amplitude", b.name), "m", "largest distance from rest in the window", sizes[..count].to_vec());
    }
    c.table("envelope", "Envelope of the motion against time")
}

/// Figure of the energy balance.
pub(in crate::study) fn energy_figure() -> Figure {
    let line = |column: &str| Line::new("energy", "t", column).name(column);
    let mut panel = Panel::new(Axis::new("energy", "J"));
    // the energy of the spin would dwarf all others
    panel = panel.mark(line("change").name("change of the stored energy"));
    for column in ["dissipated", "supplied", "drive", "weight"] {
        panel = panel.mark(line(column));
    }
    let text =
        "Change of the stored energy since the start, heat and the work done on the machine against time; below, what the balance misses.";
    Figure::new("energy", "Energy since the start", text)
        .x(Axis::new("time", "s"))
        .panel(panel)
        .panel(Panel::new(Axis::new("missing", "J")).mark(line("missing")))
}

/// Appends what both studies of motions find: whether the energy balance closes (or why there is none), and the common findings.
///
/// # Errors
/// As [`balance`].
pub(in crate::study) fn accounted(
    motion: &mut Motion,
    trajectory: &Trajectory,
    no_account: Option<Finding>,
    mut outcome: Outcome,
) -> Result<(Outcome, Option<Balance>), Diagnostic> {
    let balance = balance(motion, trajectory)?;
    let closes = balance.as_ref().and_then(|b| balance_finding(b, trajectory));
    for f in closes.into_iter().chain(no_account) {
        outcome = outcome.finding(f);
    }
    Ok((common_findings(motion, trajectory, outcome), balance))
}

/// Appends the tables and figures of a motion.
///
/// # Errors
/// As [`motion_table`] and [`observed_table`]; an outcome that does not hold together.
pub(in crate::study) fn shown(
    motion: &mut Motion,
    trajectory: &Trajectory,
    listed: Listed,
    balance: Option<Balance>,
    outcome: Outcome,
) -> Result<Outcome, Diagnostic> {
    let outcome = outcome.table(motion_table(motion, trajectory, listed.velocities)?);
    let mut outcome = motion_figures(motion, trajectory, &listed, outcome)?;
    if listed.observables
        && let Some(table) = observed_table(motion, trajectory)?
    {
        outcome = outcome.table(table);
    }
    if let Some(b) = balance {
        outcome = outcome.table(b.table).figure(energy_figure());
    }
    sound(outcome.checked())
}

/// Adds the energy account, or says which part keeps none.
pub(in crate::study) fn keep_account(motion: &mut Motion) -> Option<Finding> {
    let part = motion.keep_account().err()?;
    let text = format!("The energy balance was not checked: \"{part}\" keeps no account of its energy.");
    Some(Finding::info("no_energy_account", text))
}

/// Says how much there is to integrate: turns of the rotor at the mean speed, rad/s.
pub(in crate::study) fn announce(context: &Context, duration: f64, speed: f64) {
    let turns = duration * speed.abs() / TAU;
    context.announce(turns, 1e5, &format!("turns of the rotor to integrate, {}", quantity(duration, "s")));
}

/// Parts of the time that are distinguished: a motion over years moves on by few thousandths an hour.
const PARTS: u64 = 1_000_000_000;

/// Reports the share of the time that is reached.
pub(in crate::study) fn progress<'c>(context: &'c Context, t_end: f64) -> impl Fn(f64) + 'c {
    move |t| context.progress.report((PARTS as f64 * (t / t_end).clamp(0.0, 1.0)) as u64, PARTS)
}
