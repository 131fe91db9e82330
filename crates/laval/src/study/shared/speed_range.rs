//! The speeds a study needs against the speeds at which parts in a table are known: a study beyond a table is refused, or, where the part says how the table
//! continues, every finding there is marked.

use super::vibration;
use crate::diagnostic::{Diagnostic, Span};
use crate::model::field::{RangeValue, Values};
use crate::model::part::{Beyond, Tabulated};
use crate::model::system::{Slot, System};
use crate::outcome::{Arg, Finding, Level, Message, Outcome};
use crate::study::Study;
use crate::text;
use laval_num::order::ascending;

/// Fields of studies that are spin speeds.
const FIELDS: [&str; 5] = ["speed", "from", "to", "programme", "stabilise_at"];

/// Share of a speed within which two units say the same.
const SAME: f64 = 1e-9;

/// Spin speeds that a study needs, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinSpeeds {
    /// Lowest.
    pub from: f64,
    /// Highest.
    pub to: f64,
}

impl SpinSpeeds {
    /// One speed.
    pub fn one(speed: f64) -> Self {
        SpinSpeeds { from: speed, to: speed }
    }
    /// From one speed to another.
    pub fn between(a: f64, b: f64) -> Self {
        SpinSpeeds { from: a.min(b), to: a.max(b) }
    }

    fn leaves(&self, t: &Tabulated) -> bool {
        let slack = SAME * t.to.abs().max(t.from.abs());
        self.from < t.from - slack || self.to > t.to + slack
    }
}

/// Where a file gives the speeds of a study.
pub(in crate::study) fn place(values: &Values) -> Option<Span> {
    FIELDS.iter().find_map(|field| values.span_of(field))
}

/// The code of a refusal by [`known`].
pub(in crate::study) const BEYOND: &str = "study.beyond_table";

/// # Errors
/// A machine of several spins in a study of one; a speed at which a part is not known.
pub(in crate::study) fn able<T: Study>(study: &T, system: &System) -> Result<(), Diagnostic> {
    if !T::SEVERAL_SPINS
        && let Some(name) = system.spins().into_iter().find_map(|s| s.name)
    {
        let message = text!("this study knows one spin, and the machine has another one, \"{name}\"", name);
        let help = text!(
            "modes, campbell, critical_speeds, stability_map, forced_response, harmonic_force, static, transient and run_up take several spins"
        );
        return Err(Diagnostic::error("study.spins", message).help(help));
    }
    vibration::known(study, system)?;
    known(study, system)
}

/// # Errors
/// A speed at which a part is not known.
fn known<T: Study>(study: &T, system: &System) -> Result<(), Diagnostic> {
    let refusing: Vec<_> = tabulated(system).filter(|(_, t)| t.beyond == Beyond::Refuse).collect();
    if refusing.is_empty() {
        return Ok(());
    }
    let needed = study.spin_speeds(system);
    for (name, t) in refusing {
        if let Some(n) = needed.iter().find(|n| n.leaves(&t)) {
            let speed = |w: f64| text::quantity(w, "rad/s");
            let (low, high, from, to) = (speed(t.from), speed(t.to), speed(n.from), speed(n.to));
            let message = if n.from == n.to {
                text!(
                    "the study needs the coefficients of \"{name}\" at {from}; its table goes from {low} to {high}",
                    name,
                    from,
                    low,
                    high
                )
            } else {
                text!(
                    "the study needs the coefficients of \"{name}\" from {from} to {to}; its table goes from {low} to {high}",
                    name,
                    from,
                    to,
                    low,
                    high
                )
            };
            // speeds of a shaft that turns the other way are negative
            let own = system
                .slots()
                .iter()
                .find(|s| s.name == name)
                .and_then(|s| s.part.scope()?.tabulated().map(|own| (s.speed(system.params(), 1.0), own)));
            if let Some((ratio, _)) = own.filter(|(ratio, own)| *ratio < 0.0 && own.from >= 0.0) {
                let ratio = text::number(ratio, 6);
                return Err(Diagnostic::error(BEYOND, message).help(text!("\"{name}\" turns {ratio} times as fast as the machine, and its table is over that speed: write negative speeds, and cross-coupled coefficients for that direction", name, ratio)));
            }
            return Err(Diagnostic::error(BEYOND, message).help(text!("keep to speeds of the table, add rows to it, or write beyond = \"hold\" or beyond = \"linear\" in \"{name}\": results beyond are then marked", name)));
        }
    }
    Ok(())
}

/// Speed of the fastest shaft over that of the machine, at least 1.
pub(in crate::study) fn fastest_ratio(system: &System) -> f64 {
    system.spins().iter().map(|s| s.ratio.abs()).fold(1.0, f64::max)
}

/// First and last speed of the machine at which no table refuses its coefficients; infinite without such a table.
pub(in crate::study) fn known_speeds(system: &System) -> (f64, f64) {
    let refusing = tabulated(system).filter(|(_, t)| t.beyond == Beyond::Refuse);
    refusing.fold((f64::NEG_INFINITY, f64::INFINITY), |(a, b), (_, t)| (a.max(t.from), b.min(t.to)))
}

/// Marks in an outcome what rests on a table beyond its speeds.
pub(in crate::study) fn mark_beyond<T: Study>(study: &T, system: &System, outcome: &mut Outcome) {
    for (name, t) in tabulated(system) {
        let mut needed = study.spin_speeds(system);
        needed.retain(|n| n.leaves(&t));
        if !needed.is_empty() {
            mark(outcome, name, &t, (t.from, t.to), &needed, "beyond-table");
        }
    }
    vibration::mark_beyond(study, system, outcome);
}

/// Speeds of a range at which modes are followed: those requested, and the rows of tables between them, where coefficients have their largest values.
pub(in crate::study) fn with_table_speeds(range: &RangeValue, points: usize, system: &System) -> Vec<f64> {
    let mut out = range.linspace(points);
    let near = |w: f64, all: &[f64]| all.iter().any(|s| (s - w).abs() <= 1e-9 * w.abs());
    let rows: Vec<f64> = system.table_speeds(range.from, range.to).into_iter().filter(|w| !near(*w, &out)).collect();
    out.extend(rows);
    ascending(&mut out);
    out
}

fn tabulated(system: &System) -> impl Iterator<Item = (&str, Tabulated)> {
    let table = |s: &Slot| {
        let t = s.part.scope()?.tabulated()?;
        // over the speed of the machine
        let ratio = s.speed(system.params(), 1.0);
        Some(Tabulated { from: (t.from / ratio).min(t.to / ratio), to: (t.from / ratio).max(t.to / ratio), ..t })
    };
    system.slots().iter().filter_map(move |s| Some((s.name.as_str(), table(s)?)))
}

/// How far the speeds go beyond the table, rad/s.
fn reach(n: &SpinSpeeds, t: &Tabulated) -> f64 {
    (n.to - t.to).max(t.from - n.from)
}

/// Evidence in rad/s that is no spin speed, by words of its name.
const NO_SPEED: [&str; 9] = ["frequency", "width", "change", "difference", "uncertainty", "step", "rate", "slip", "bracket"];

/// Findings whose value in rad/s is no spin speed.
const NO_PLACE: [&str; 6] = ["family", "merged_modes", "fold_deviation", "hysteresis", "widest_hysteresis", "widest_window"];

/// Findings without a speed that rest on no coefficient of a table: of the file, the form of the equations, or the accuracy of the method.
const OF_THE_METHOD: [&str; 16] = [
    "incomplete",
    "nothing_shown",
    "validity",
    "linearised",
    "open_gap",
    "fitted_part",
    "start",
    "massless",
    "threshold",
    "criterion",
    "threshold_raised",
    "frequency_only",
    "stability_fit",
    "harmonics_short",
    "energy_balance",
    "spin_inertia",
];

/// The spin speeds that a finding names.
fn speeds(f: &Finding) -> impl Iterator<Item = f64> + '_ {
    let own = f.value.filter(|_| f.unit == "rad/s" && !NO_PLACE.contains(&f.id.as_str()));
    let named = f.evidence.iter().filter(|e| e.unit == "rad/s" && !NO_SPEED.iter().any(|word| e.what.to_string().contains(word)));
    own.into_iter().chain(named.map(|e| e.value))
}

/// A finding about all speeds of a study: one that names no speed, that nothing was found at any, or that the machine is stable at all.
fn about_all(f: &Finding) -> bool {
    let none = f.id == "stable" || f.id.starts_with("no_") && f.value.is_none();
    none || speeds(f).next().is_none() && !OF_THE_METHOD.contains(&f.id.as_str()) && f.id != "beyond_table"
}

/// Says first that the study leaves the table, by a sentence of the catalogue, and marks every finding at a speed outside `inside` or about all speeds; all of them, where
/// no speed lies inside.
pub(super) fn mark(outcome: &mut Outcome, name: &str, t: &Tabulated, inside: (f64, f64), needed: &[SpinSpeeds], sentence: &'static str) {
    let slack = SAME * t.to.abs().max(t.from.abs());
    let slack_inside = SAME * if inside.1.is_finite() { inside.0.abs().max(inside.1.abs()) } else { inside.0.abs() };
    let beyond = |w: f64| w < inside.0 - slack_inside || w > inside.1 + slack_inside;
    // the statement of the part itself says the same of one speed
    outcome.findings.retain(|f| !(f.level == Level::Invalid && f.message.mentions(t.statement)));
    let Some(most) = needed.iter().max_by(|a, b| reach(a, t).total_cmp(&reach(b, t))) else { return };
    let everywhere = most.to < t.from - slack || most.from > t.to + slack;
    for f in outcome.findings.iter_mut().filter(|f| f.id != "beyond_table") {
        if everywhere || speeds(f).any(beyond) || about_all(f) {
            f.level = Level::Invalid;
            f.notes.push(Message::new("beyond-table-note").arg("part", Arg::name(name)));
        }
    }
    let how = match t.beyond {
        Beyond::Refuse => "refuse",
        Beyond::Hold => "hold",
        Beyond::Linear => "linear",
    };
    let (lowest, highest) = needed.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), n| (l.min(n.from), h.max(n.to)));
    let (below, above) = (lowest < t.from - slack, highest > t.to + slack);
    let farthest = if most.to - t.to >= t.from - most.from { most.to } else { most.from };
    let sides = match (below, above) {
        (true, true) => "both",
        (true, false) => "below",
        _ => "above",
    };
    let shown = |w: f64| if sentence == "beyond-table" { Arg::speed(w) } else { Arg::frequency(w) };
    let finding = Finding::invalid("beyond_table", sentence).of(name).value(farthest, "rad/s");
    let finding = finding.arg("part", Arg::name(name)).arg("from", shown(t.from)).arg("to", shown(t.to));
    let finding = finding.arg("lowest", shown(lowest)).arg("highest", shown(highest));
    let finding = finding.arg("sides", Arg::word(sides)).arg("rule", Arg::word(how));
    let mut finding = finding.evidence("table from", t.from, "rad/s").evidence("table to", t.to, "rad/s");
    if below && above {
        finding = finding.evidence("lowest speed", lowest, "rad/s").evidence("highest speed", highest, "rad/s");
    }
    outcome.findings.insert(0, finding);
}
