//! The speeds a study needs against the speeds at which parts in a table are known: a study beyond a table is refused, or, where the part says how the table
//! continues, every finding there is marked.

use crate::diagnostic::{Diagnostic, Span};
use crate::model::field::Values;
use crate::model::part::{Beyond, Tabulated};
use crate::model::system::System;
use crate::outcome::{Finding, Level, Outcome, quantity};
use crate::study::Study;
use crate::units::format_si;

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
/// A speed at which a part is not known.
pub(in crate::study) fn known<T: Study>(study: &T, system: &System) -> Result<(), Diagnostic> {
    let refusing: Vec<_> = tabulated(system).filter(|(_, t)| t.beyond == Beyond::Refuse).collect();
    if refusing.is_empty() {
        return Ok(());
    }
    let needed = study.spin_speeds(system);
    for (name, t) in refusing {
        if let Some(n) = needed.iter().find(|n| n.leaves(&t)) {
            let speed = |w: f64| format_si(w, "rad/s");
            let table = format!("from {} to {}", speed(t.from), speed(t.to));
            let wanted =
                if n.from == n.to { format!("at {}", speed(n.from)) } else { format!("from {} to {}", speed(n.from), speed(n.to)) };
            let message = format!("the study needs the coefficients of \"{name}\" {wanted}; its table goes {table}");
            return Err(Diagnostic::error(BEYOND, message).help(format!(
                "keep to speeds of the table, add rows to it, or write beyond = \"hold\" or beyond = \"linear\" in \"{name}\": results beyond are then marked"
            )));
        }
    }
    Ok(())
}

/// Marks in an outcome what rests on a table beyond its speeds.
pub(in crate::study) fn mark_beyond<T: Study>(study: &T, system: &System, outcome: &mut Outcome) {
    for (name, t) in tabulated(system) {
        let needed = study.spin_speeds(system);
        if let Some(needed) = needed.iter().filter(|n| n.leaves(&t)).max_by(|a, b| reach(a, &t).total_cmp(&reach(b, &t))) {
            mark(outcome, name, &t, needed);
        }
    }
}

fn tabulated(system: &System) -> impl Iterator<Item = (&str, Tabulated)> {
    system.slots().iter().filter_map(|s| Some((s.name.as_str(), s.part.scope()?.tabulated()?)))
}

/// How far the speeds go beyond the table, rad/s.
fn reach(n: &SpinSpeeds, t: &Tabulated) -> f64 {
    (n.to - t.to).max(t.from - n.from)
}

/// Says first that the study leaves the table, and marks every finding at a speed beyond it; all of them, where no speed lies inside.
fn mark(outcome: &mut Outcome, name: &str, t: &Tabulated, needed: &SpinSpeeds) {
    let slack = SAME * t.to.abs().max(t.from.abs());
    let beyond = |w: f64| w < t.from - slack || w > t.to + slack;
    // the statement of the part itself says the same of one speed
    outcome.findings.retain(|f| !(f.level == Level::Invalid && f.text.contains(t.statement)));
    let everywhere = needed.to < t.from - slack || needed.from > t.to + slack;
    let places: Vec<f64> = outcome.special_points.iter().map(|p| p.at).filter(|at| beyond(*at)).collect();
    let along_speed = outcome.parameter.as_ref().is_some_and(|p| p.unit == "rad/s");
    for f in &mut outcome.findings {
        let at = |w: f64, unit: &str| along_speed && unit == "rad/s" && places.contains(&w);
        let here = f.value.is_some_and(|w| at(w, &f.unit))
            || f.evidence.iter().any(|e| e.unit == "rad/s" && beyond(e.value) && (e.what == "at" || e.what.contains("speed")));
        if everywhere || here {
            f.level = Level::Invalid;
            let end = if f.text.ends_with('.') { "" } else { "." };
            f.text += &format!("{end} Outside the table of \"{name}\".");
        }
    }
    let how = match t.beyond {
        Beyond::Refuse => "unknown",
        Beyond::Hold => "held at its ends",
        Beyond::Linear => "continued along its slope at the ends",
    };
    let (from, to) = (quantity(t.from, "rad/s"), quantity(t.to, "rad/s"));
    let text = format!("The table of \"{name}\" goes from {from} to {to}. Beyond, up to {{}}, its coefficients are {how}.");
    let farthest = if needed.to - t.to >= t.from - needed.from { needed.to } else { needed.from };
    let text = if farthest == needed.from { text.replace("up to", "down to") } else { text };
    let finding = Finding::invalid("beyond_table", text).of(name).value(farthest, "rad/s");
    let finding = finding.evidence("table from", t.from, "rad/s").evidence("table to", t.to, "rad/s");
    outcome.findings.insert(0, finding);
}
