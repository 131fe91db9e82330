//! The speeds a study needs against the speeds at which parts in a table are known: a study beyond a table is refused, or, where the part says how the table
//! continues, every finding there is marked.

use crate::diagnostic::{Diagnostic, Span};
use crate::model::field::{Field, FieldKind, Value, Values};
use crate::model::part::{Beyond, Tabulated};
use crate::model::system::System;
use crate::outcome::{Finding, Level, Outcome, quantity};
use crate::study::{Context, ErasedStudy, Study};
use crate::units::format_si;

/// Fields of studies that are spin speeds, and those of them that stand for the machine's speed when left out.
pub const SPIN: [(&str, bool); 5] = [("speed", true), ("from", false), ("to", true), ("programme", false), ("stabilise_at", false)];

/// Share of a speed within which two units say the same.
const SAME: f64 = 1e-9;

/// Spin speeds a study needs, and the place of the field that says so.
#[derive(Clone, Debug, PartialEq)]
struct Needed {
    from: f64,
    to: f64,
    span: Option<Span>,
}

impl Needed {
    /// Of a study with these fields; empty where none of them is a spin speed.
    fn of(fields: &[Field], values: &Values, system: &System) -> Vec<Self> {
        let spin = |f: &&Field| SPIN.iter().any(|s| s.0 == f.name);
        let needed = |f: &Field| {
            let machine = || system.machine.speed.filter(|_| SPIN.contains(&(f.name, true))).map(|w| (w, w));
            let (from, to) = match (f.kind, values.get(f.name)) {
                (FieldKind::Quantity { unit: "rad/s", .. }, Some(Value::Number(w))) => (*w, *w),
                (FieldKind::Range { unit: "rad/s", .. }, Some(Value::Range(r))) => (r.from, r.to),
                (FieldKind::Columns(_), Some(Value::Columns(columns))) => {
                    let speeds = columns.get("speed")?;
                    (speeds.iter().copied().fold(f64::INFINITY, f64::min), speeds.iter().copied().fold(f64::NEG_INFINITY, f64::max))
                }
                (FieldKind::Quantity { unit: "rad/s", .. }, None) if !values.written("programme") => machine()?,
                (FieldKind::Range { unit: "rad/s", .. }, None) => machine()?,
                _ => return None,
            };
            Some(Needed { from, to, span: values.span_of(f.name) })
        };
        fields.iter().filter(spin).filter_map(needed).collect()
    }

    fn leaves(&self, t: &Tabulated) -> bool {
        let slack = SAME * t.to.abs().max(t.from.abs());
        self.from < t.from - slack || self.to > t.to + slack
    }
}

/// A study with the spin speeds it needs.
pub(in crate::study) struct Ranged {
    study: Box<dyn ErasedStudy>,
    needed: Vec<Needed>,
}

impl Ranged {
    pub(in crate::study) fn new<T: Study>(study: T, values: &Values, system: &System) -> Self {
        let needed = match T::speeds(values, system) {
            _ if !T::TURNS => Vec::new(),
            Some((from, to)) => vec![Needed { from, to, span: SPIN.iter().find_map(|s| values.span_of(s.0)) }],
            None => Needed::of(T::FIELDS, values, system),
        };
        Ranged { study: Box::new(study), needed }
    }

    /// # Errors
    /// A speed at which a part is not known.
    fn known(&self, system: &System) -> Result<(), Diagnostic> {
        for (name, t) in tabulated(system).filter(|(_, t)| t.beyond == Beyond::Refuse) {
            if let Some(n) = self.needed.iter().find(|n| n.leaves(&t)) {
                let speed = |w: f64| format_si(w, "rad/s");
                let (wanted, table) = if n.from == n.to {
                    (format!("at {}", speed(n.from)), format!("from {} to {}", speed(t.from), speed(t.to)))
                } else {
                    (format!("from {} to {}", speed(n.from), speed(n.to)), format!("from {} to {}", speed(t.from), speed(t.to)))
                };
                return Err(Diagnostic::error(
                    "study.beyond_table",
                    format!("the study needs the coefficients of \"{name}\" {wanted}; its table goes {table}"),
                )
                .at(n.span.clone())
                .help(format!(
                    "keep to speeds of the table, add rows to it, or write beyond = \"hold\" or beyond = \"linear\" in \"{name}\": results beyond are then marked"
                )));
            }
        }
        Ok(())
    }
}

fn tabulated(system: &System) -> impl Iterator<Item = (&str, Tabulated)> {
    system.slots().iter().filter_map(|s| Some((s.name.as_str(), s.part.scope()?.tabulated()?)))
}

impl ErasedStudy for Ranged {
    fn kind(&self) -> &'static str {
        self.study.kind()
    }
    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.known(system)?;
        self.study.admit(system)
    }
    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        self.known(system)?;
        self.study.prepare(system, context)
    }
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        self.known(system)?;
        let mut outcome = self.study.run(system, context)?;
        for (name, t) in tabulated(system) {
            if let Some(needed) = self.needed.iter().filter(|n| n.leaves(&t)).max_by(|a, b| reach(a, &t).total_cmp(&reach(b, &t))) {
                mark(&mut outcome, name, &t, needed);
            }
        }
        Ok(outcome)
    }
}

/// How far the speeds go beyond the table, rad/s.
fn reach(n: &Needed, t: &Tabulated) -> f64 {
    (n.to - t.to).max(t.from - n.from)
}

/// Says first that the study leaves the table, and marks every finding at a speed beyond it; all of them, where no speed lies inside.
fn mark(outcome: &mut Outcome, name: &str, t: &Tabulated, needed: &Needed) {
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
