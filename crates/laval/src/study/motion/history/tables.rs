//! Tables and figures of a motion.

use super::energy;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Line, Outcome, OutcomeError, Panel, Table};
use crate::solve::motion::SpinLaw;
use crate::solve::motion::envelope::Window;
use crate::study::motion::passages::{envelope, reach};
use crate::study::motion::record::{MotionRecord, Series};
use crate::study::motion::turns;

/// Calls for an outcome whose names fit; a misfit is a mistake of the study.
pub(in crate::study) fn sound(outcome: Result<Outcome, OutcomeError>) -> Result<Outcome, Diagnostic> {
    outcome.map_err(misfit)
}
fn misfit(e: OutcomeError) -> Diagnostic {
    e.into()
}

/// Columns collected row by row.
#[derive(Default)]
pub(in crate::study) struct Columns(Vec<(String, String, Arg, Vec<f64>)>);

impl Columns {
    pub fn add(&mut self, name: impl Into<String>, unit: &str, doc: impl Into<Arg>, values: Vec<f64>) {
        self.0.push((name.into(), unit.into(), doc.into(), values));
    }
    /// The same meaning for all of them.
    pub fn all(&mut self, series: &[Series], doc: &'static str) {
        series.iter().for_each(|s| self.add(&s.name, &s.unit, doc, s.values.clone()));
    }
    pub fn table(self, name: &str, doc: impl Into<Arg>) -> Result<Table, Diagnostic> {
        let mut builder = Table::new(name, doc);
        for (name, unit, doc, values) in self.0 {
            builder = builder.float(name, unit, doc, values);
        }
        builder.build().map_err(misfit)
    }
}

/// The states at the outputs.
fn motion_table(record: &MotionRecord) -> Result<Table, Diagnostic> {
    let mut c = Columns::default();
    c.add("t", "s", "time", record.times.clone());
    c.add("speed", "rad/s", "spin speed", record.spin.iter().map(|s| s.speed).collect());
    c.add("phase", "rad", "spin angle", record.spin.iter().map(|s| s.phase).collect());
    c.all(&record.coordinates, "coordinate");
    c.all(&record.rates, "rate of the coordinate");
    c.all(&record.states, "internal state");
    c.table("motion", "Motion of the machine against time")
}

/// What the parts show at the outputs; `None` when they show nothing.
fn observed_table(record: &MotionRecord) -> Result<Option<Table>, Diagnostic> {
    if record.observed.is_empty() {
        return Ok(None);
    }
    let mut c = Columns::default();
    c.add("t", "s", "time", record.times.clone());
    c.all(&record.observed, "quantity a part shows");
    c.table("observed", "Forces and other quantities the parts show, against time").map(Some)
}

/// Values of a coordinate in a list of them.
fn values<'s>(all: &'s [Series], name: &str) -> &'s [f64] {
    all.iter().find(|s| s.name == name).map_or(&[], |s| &s.values)
}

fn most(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// Largest over last displacement from which an envelope is drawn on a logarithmic axis.
const DECAYS: f64 = 10.0;

/// Appends figures of the bodies against time and as orbits. Where the outputs do not resolve the motion the envelope stands for it, and the orbits are those of
/// the last turns. An envelope also shows a decay.
fn motion_figures(
    system: &System,
    record: &MotionRecord,
    drawn_envelope: Option<&SpinLaw>,
    mut outcome: Outcome,
) -> Result<Outcome, Diagnostic> {
    let bodies = system.stations();
    if bodies.is_empty() {
        return Ok(outcome);
    }
    let coarse = turns::coarse(&record.spin);
    let seen = drawn_envelope.map(|law| sizes(system, record, law));
    let decays =
        |sizes: &[f64]| sizes.last().is_some_and(|last| *last > 0.0 && most(sizes.iter().copied()) > DECAYS * last) && sizes.len() > 2;
    if let Some(seen) = &seen
        && (coarse || seen.iter().any(|s| decays(s)))
    {
        outcome = outcome.table(envelope_table(system, record, seen)?);
        let alt = "history-alt-envelope";
        let mut figure = Figure::new("envelope", "Envelope against time", alt).x(Axis::new("time", "s"));
        for (b, sizes) in bodies.iter().zip(seen) {
            let label = Arg::of("amplitude", Arg::name(&b.name));
            let axis = if decays(sizes) { Axis::log(label, "m") } else { Axis::new(label, "m") };
            let panel = Panel::new(axis.metres(most(sizes.iter().copied())));
            figure = figure.panel(panel.mark(Line::new("envelope", "t", format!("{} amplitude", b.name))));
        }
        outcome = outcome.figure(figure);
    }
    let (path, shown) = match (&record.last_turns, coarse) {
        (Some(last), true) => ("last turns", &last.coordinates),
        _ => ("motion", &record.coordinates),
    };
    let mut lateral = Figure::new("lateral", "Lateral motion of the bodies", "history-alt-lateral").x(Axis::new("time", "s"));
    let reach = most(bodies.iter().flat_map(|s| s.columns()).flat_map(|name| values(shown, &name)).copied());
    let mut plane = Panel::new(Axis::new("y", "m").metres(reach));
    for b in bodies {
        let own = b.columns();
        let size = most(own.iter().flat_map(|name| values(&record.coordinates, name)).copied());
        let line = |column: &String| Line::new("motion", "t", column).name(Arg::name(column));
        lateral = lateral.panel(
            Panel::new(Axis::new(Arg::of("displacement", Arg::name(&b.name)), "m").metres(size)).mark(line(&own[0])).mark(line(&own[1])),
        );
        plane = plane.mark(Line::new(path, &own[0], &own[1]).name(Arg::name(&b.name)).path());
    }
    if !coarse {
        outcome = outcome.figure(lateral);
    }
    let title = if coarse { "Orbits of the bodies over the last turns (dot: start)" } else { "Orbits of the bodies (dot: start)" };
    let orbit = Figure::new("orbit", title, "history-alt-orbit").x(Axis::new("x", "m").metres(reach)).equal().panel(plane);
    Ok(match (&record.last_turns, coarse) {
        (Some(last), true) => outcome.table(turns::table(last)?).figure(orbit),
        (None, true) => outcome,
        (_, false) => outcome.figure(orbit),
    })
}

/// The largest displacements of each body in successive windows.
fn sizes(system: &System, record: &MotionRecord, law: &SpinLaw) -> Vec<Vec<f64>> {
    let of = |windows: &Vec<Window>| -> Vec<f64> {
        let seen = match law {
            SpinLaw::Programme(p) => envelope(windows, &|t| p.at(t), reach(system)),
            SpinLaw::Free => windows.iter().map(|w| w.peak).take_while(|p| p.amplitude.is_finite()).collect(),
        };
        seen.iter().map(|p| p.amplitude).collect()
    };
    let sizes: Vec<Vec<f64>> = record.windows.iter().map(of).collect();
    let count = sizes.iter().map(Vec::len).min().unwrap_or(0);
    sizes.into_iter().map(|s| s[..count].to_vec()).collect()
}

fn envelope_table(system: &System, record: &MotionRecord, sizes: &[Vec<f64>]) -> Result<Table, Diagnostic> {
    let count = sizes.first().map_or(0, Vec::len);
    let mut c = Columns::default();
    c.add("t", "s", "end of the window", record.windows.first().map_or(vec![], |w| w[..count].iter().map(|w| w.last).collect()));
    for (b, sizes) in system.stations().iter().zip(sizes) {
        c.add(format!("{} amplitude", b.name), "m", "largest distance from rest in the window", sizes.clone());
    }
    c.table("envelope", "Envelope of the motion against time")
}

/// Appends the tables and figures of a motion. By `drawn_envelope`, the law of the spin, the envelope is drawn in place of a motion that is not resolved; not where the
/// study draws its own.
///
/// # Errors
/// An outcome that does not hold together.
pub(in crate::study) fn shown(
    system: &System,
    record: &MotionRecord,
    drawn_envelope: Option<&SpinLaw>,
    outcome: Outcome,
) -> Result<Outcome, Diagnostic> {
    let mut outcome = motion_figures(system, record, drawn_envelope, outcome.table(motion_table(record)?))?;
    if let Some(table) = observed_table(record)? {
        outcome = outcome.table(table);
    }
    sound(energy::shown(record, outcome)?.checked())
}
