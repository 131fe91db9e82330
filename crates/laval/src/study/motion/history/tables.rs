//! Tables and figures of a motion.

use super::energy;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Axis, Figure, Line, Outcome, OutcomeError, Panel, Table};
use crate::solve::motion::SpinLaw;
use crate::solve::motion::envelope::Window;
use crate::study::motion::passages::envelope;
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
pub(in crate::study) struct Columns(Vec<(String, String, String, Vec<f64>)>);

impl Columns {
    pub fn add(&mut self, name: impl Into<String>, unit: &str, doc: impl Into<String>, values: Vec<f64>) {
        self.0.push((name.into(), unit.into(), doc.into(), values));
    }
    /// The same meaning for all of them.
    pub fn all(&mut self, series: &[Series], doc: &str) {
        series.iter().for_each(|s| self.add(&s.name, &s.unit, doc, s.values.clone()));
    }
    pub fn table(self, name: &str, doc: &str) -> Result<Table, Diagnostic> {
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

/// Appends figures of the bodies against time and as orbits. Where the outputs do not resolve the motion the envelope stands for it, and the orbits are those of
/// the last turns.
fn motion_figures(
    system: &System,
    record: &MotionRecord,
    drawn_envelope: Option<&SpinLaw>,
    mut outcome: Outcome,
) -> Result<Outcome, Diagnostic> {
    let bodies = system.bodies();
    if bodies.is_empty() {
        return Ok(outcome);
    }
    let mm = |label: &str| Axis::new(label, "mm").factor(1e3);
    let coarse = turns::coarse(&record.spin);
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
    if coarse && let Some(law) = drawn_envelope {
        outcome = outcome.table(envelope_table(system, record, law)?);
    }
    if !coarse || drawn_envelope.is_some() {
        outcome = outcome.figure(lateral);
    }
    Ok(match (&record.last_turns, coarse) {
        (Some(last), true) => {
            orbit.title = "Orbits of the bodies over the last turns".into();
            outcome.table(turns::table(last)?).figure(orbit)
        }
        (None, true) => outcome,
        (_, false) => outcome.figure(orbit),
    })
}

/// The largest displacements in successive windows.
fn envelope_table(system: &System, record: &MotionRecord, law: &SpinLaw) -> Result<Table, Diagnostic> {
    let sizes = |windows: &Vec<Window>| -> Vec<f64> {
        let seen = match law {
            SpinLaw::Programme(p) => envelope(windows, &|t| p.at(t)),
            SpinLaw::Free => windows.iter().map(|w| w.peak).take_while(|p| p.amplitude.is_finite()).collect(),
        };
        seen.iter().map(|p| p.amplitude).collect()
    };
    let sizes: Vec<Vec<f64>> = record.windows.iter().map(sizes).collect();
    let count = sizes.iter().map(Vec::len).min().unwrap_or(0);
    let mut c = Columns::default();
    c.add("t", "s", "end of the window", record.windows.first().map_or(vec![], |w| w[..count].iter().map(|w| w.last).collect()));
    for (b, sizes) in system.bodies().iter().zip(sizes) {
        c.add(format!("{} amplitude", b.name), "m", "largest distance from rest in the window", sizes[..count].to_vec());
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
