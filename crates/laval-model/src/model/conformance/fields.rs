//! Promises of the declarations of a part.

use super::{Failure, Promise};
use crate::diagnostic::Diagnostics;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::params::Family;
use crate::model::part::Part;

/// Checks the declarations of a kind of part.
pub fn check_fields<P: Part>() -> Vec<Failure> {
    let mut failures = Vec::new();
    let mut fail = |detail: String| failures.push(Failure { promise: Promise::Fields, detail });
    let word = |s: &str| !s.is_empty() && s.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
    let all: Vec<&Field> = P::FIELDS.iter().chain(P::Family::FIELDS).collect();
    if !word(P::KIND) || P::DOC.trim().len() < 20 {
        fail(format!("kind \"{}\" needs a word and a paragraph", P::KIND));
    }
    for (i, f) in all.iter().enumerate() {
        if !word(f.name) || matches!(f.name, "kind" | "name") || all[..i].iter().any(|g| g.name == f.name) {
            fail(format!("field \"{}\" is not a word of its own", f.name));
        }
        if f.doc.trim().is_empty() || (f.required && !f.default.is_empty()) {
            fail(format!("field \"{}\" needs a meaning, and no default when it is required", f.name));
        }
        for unit in units_of(&f.kind) {
            if !unit_reads(unit) {
                fail(format!("field \"{}\" has an unreadable unit \"{unit}\"", f.name));
            }
        }
        if let FieldKind::Choice(words) = f.kind
            && !f.required
            && !words.iter().any(|w| w.0 == f.default)
        {
            fail(format!("default \"{}\" of \"{}\" is none of its words", f.default, f.name));
        }
    }
    let slot_required = |name: &str| P::Family::FIELDS.iter().any(|f| f.required && name.split('.').next() == Some(f.name));
    for slot in P::Family::slots() {
        let Bounds { min, max, .. } = slot.bounds;
        let (ordered, required) = (min <= max, slot_required(&slot.name));
        if !ordered || required != slot.default.is_none() || slot.default.is_some_and(|value| !slot.bounds.contains(value)) {
            let value = slot.default.map_or("none".into(), |value| value.to_string());
            fail(format!("default {value} of \"{}\" does not fit its bounds", slot.name));
        }
    }
    // a block that says nothing is refused or built, without a panic
    let _ = P::build(&Values::default(), &mut ParamValues::default(), &mut Diagnostics::default());
    failures
}

fn units_of(kind: &FieldKind) -> Vec<&'static str> {
    match kind {
        FieldKind::Quantity { unit, .. }
        | FieldKind::Lateral { unit, .. }
        | FieldKind::Range { unit, .. }
        | FieldKind::List { unit, .. } => {
            vec![unit]
        }
        FieldKind::OneOf(options) => options.iter().map(|o| o.1).collect(),
        FieldKind::Columns(columns) => columns.iter().map(|c| c.1).collect(),
        _ => Vec::new(),
    }
}

/// An SI unit as declarations write it: `N s/m`, `kg m^2`, `N/m^1.5`, empty for a pure number.
fn unit_reads(unit: &str) -> bool {
    const SYMBOLS: [&str; 14] = ["m", "kg", "s", "rad", "N", "J", "W", "Pa", "K", "A", "V", "1", "Hz", "mol"];
    let factor = |f: &str| {
        let (symbol, power) = f.split_once('^').unwrap_or((f, "1"));
        SYMBOLS.contains(&symbol) && power.parse::<f64>().is_ok()
    };
    unit.is_empty() || unit.split(['/', ' ']).all(factor)
}
