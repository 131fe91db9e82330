//! What is made small or large, and what has limits.

use super::{MOST_PARAMETERS, Optimum};
use crate::diagnostic::{Diagnostic, Diagnostics, Span, meant, nearest};
use crate::model::field::{Value, Values};
use crate::study::parameters::uncertainty::collect::Quantity;
use crate::text;
use crate::units::check_dimension;

/// The number that is made small or large.
#[derive(Clone, Debug, PartialEq)]
pub struct Aim {
    /// Its name.
    pub name: String,
    /// Made large.
    pub large: bool,
    /// Where the file names it.
    pub span: Option<Span>,
}

/// A limit on a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Its name.
    pub name: String,
    /// The limit, SI.
    pub value: f64,
    /// SI unit of what was written; `None` for a bare number.
    pub unit: Option<String>,
    /// An upper limit, else a lower one.
    pub upper: bool,
    /// Where the file names it.
    pub span: Option<Span>,
}

/// The number of a name: of several the largest or the least.
pub(super) fn number(list: &[Quantity], name: &str, largest: bool) -> Option<f64> {
    let own = list.iter().filter(|q| q.label == name || q.label.strip_prefix(name).is_some_and(|rest| rest.starts_with(" #")));
    own.map(|q| q.value).reduce(|a, b| if (b > a) == largest || b.is_nan() { b } else { a })
}

pub(super) fn aim(values: &Values, out: &mut Diagnostics) -> Option<Aim> {
    let word = |field: &str| values.text(field).map(str::trim).filter(|t| !t.is_empty());
    // a name that only stands by default gives way
    match (word("minimise").filter(|_| values.written("minimise") || word("maximise").is_none()), word("maximise")) {
        (Some(_), Some(_)) => {
            let d = Diagnostic::error("optimum.aim", text!("one number can be made small or large, not two at once"));
            out.push(
                d.at(values.span_of("maximise"))
                    .help(text!("leave out minimise or maximise, and give the other number a limit by at_most or at_least")),
            );
            None
        }
        (_, Some(name)) => Some(Aim { name: name.into(), large: true, span: values.span_of("maximise") }),
        (Some(name), None) => Some(Aim { name: name.into(), large: false, span: values.span_of("minimise") }),
        (None, None) => {
            let d = Diagnostic::error("optimum.aim", text!("nothing is named that should become small or large"));
            out.push(
                d.at(values.span_of("minimise")).help(text!("write minimise = \"largest_displacement\", or maximise = \"widest_window\"")),
            );
            None
        }
    }
}

pub(super) fn limits(values: &Values, out: &mut Diagnostics) -> Option<Vec<Limit>> {
    let mut found = Vec::new();
    let mut fine = true;
    for (field, upper) in [("at_most", true), ("at_least", false)] {
        let Some(Value::StateMap(entries)) = values.get(field) else { continue };
        let units = values.units_of(field);
        for (k, (name, value, span)) in entries.iter().enumerate() {
            if *value == 0.0 || !value.is_finite() {
                let message = text!("the limit on \"{name}\" is {value}: how far it is kept is measured by its size", name, value);
                out.push(Diagnostic::error("optimum.limit", message).at(span.clone()).help(text!("give a number other than zero")));
                fine = false;
                continue;
            }
            found.push(Limit { name: name.clone(), value: *value, unit: units.get(k).cloned().flatten(), upper, span: Some(span.clone()) });
        }
    }
    fine.then_some(found)
}

impl Optimum {
    /// The inner study finds all numbers that are requested, in units that fit.
    pub(super) fn known(&self, now: &[Quantity]) -> Result<(), Diagnostic> {
        let names = || now.iter().map(|q| q.label.as_str());
        let limits = self.limits.iter().map(|l| (&l.name, l.unit.as_ref(), &l.span));
        for (name, unit, span) in std::iter::once((&self.aim.name, None, &self.aim.span)).chain(limits) {
            let Some(q) = now.iter().find(|q| q.label == *name) else {
                let own = now.iter().filter(|q| !q.label.contains(" #"));
                let mut all: Vec<String> =
                    own.map(|q| if q.unit.is_empty() { q.label.clone() } else { format!("{} ({})", q.label, q.unit) }).collect();
                all.dedup();
                let all = all.join(", ");
                let help = match nearest(name, names()) {
                    Some(near) => meant(text::quoted(&near), text!("it finds: {all}", all)),
                    None => text!("it finds: {all}", all),
                };
                let message = text!("the study {kind} finds no number \"{name}\" of this machine", kind = self.study.kind(), name);
                return Err(Diagnostic::error("optimum.number", message).at(span.clone()).help(help));
            };
            if let Some(given) = unit
                && let Err(e) = check_dimension(given, &q.unit)
            {
                let d = Diagnostic::error("optimum.unit", text!("the limit on \"{name}\": {message}", name, message = e.message))
                    .at(span.clone());
                return Err(Diagnostic { help: e.help.map(Box::new), ..d });
            }
        }
        Ok(())
    }
}

/// Says so when there are too many parameters.
pub(super) fn few_enough(count: usize, values: &Values, out: &mut Diagnostics) -> bool {
    if count > MOST_PARAMETERS {
        let message = text!("{count} parameters are too many to search", count);
        out.push(
            Diagnostic::error("optimum.parameters", message)
                .at(values.span_of("vary"))
                .help(text!("at most {most}", most = MOST_PARAMETERS)),
        );
    }
    count <= MOST_PARAMETERS
}
