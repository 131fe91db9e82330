//! Parts that support the rotor, as a field of a study.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, Values};
use crate::model::system::System;
use crate::solve::statics::supports::{Support, named, supports};
use crate::solve::statics::{Statics, own};
use crate::text;

/// Field: the supports.
pub const SUPPORTS: Field = Field::optional(
    "supports",
    FieldKind::Text,
    "",
    "names of the parts that support the rotor, separated by commas; every part with stiffness between what turns and what does not, unless given",
);

/// Slots of the parts named; none where the field is absent.
pub fn read(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Vec<usize>> {
    let mut out = Vec::new();
    let mut complete = true;
    for name in values.text("supports").unwrap_or_default().split(',').map(str::trim).filter(|n| !n.is_empty()) {
        match slot(name, "supports", values, system, diagnostics) {
            Some(k) if out.contains(&k) => {
                let message = text!("\"{name}\" is named twice", name);
                diagnostics.push(Diagnostic::error("study.supports", message).at(values.span_of("supports")).about(name));
                complete = false;
            }
            Some(k) => out.push(k),
            None => complete = false,
        }
    }
    complete.then_some(out)
}

/// The slot of a part that joins a turning body to something, which a field names.
pub fn slot(name: &str, field: &str, values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<usize> {
    let known = system.slots().iter().position(|s| s.name == name);
    let found = known.filter(|&k| named(system, k).is_some());
    if found.is_none() {
        let candidates: Vec<&str> =
            (0..system.slots().len()).filter(|&k| named(system, k).is_some()).map(|k| system.slots()[k].name.as_str()).collect();
        let message = match known {
            None => text!("there is no part \"{name}\"", name),
            Some(_) => text!("\"{name}\" does not join a turning body to anything", name),
        };
        diagnostics.push(
            Diagnostic::error("study.supports", message)
                .at(values.span_of(field))
                .about(name)
                .help(text!("parts that join a turning body to something: {names}", names = candidates.join(", "))),
        );
    }
    found
}

/// The supports named, or all that hold the machine at rest.
pub fn of(system: &System, slots: &[usize], at: &Statics) -> Vec<Support> {
    if slots.is_empty() { supports(system, at) } else { slots.iter().filter_map(|&k| named(system, k)).collect() }
}

/// A state of rest that says which gaps are open; of a machine without gaps the undeflected one.
///
/// # Errors
/// As [`own`].
pub fn state(system: &System, speed: f64) -> Result<Statics, Diagnostic> {
    if system.slots().iter().any(|s| !s.is_linear()) {
        return own(system, speed);
    }
    Ok(Statics {
        speed,
        q: vec![0.0; system.n()],
        z: vec![0.0; system.m()],
        holding: Vec::new(),
        left_out: vec![false; system.slots().len()],
        raised: Vec::new(),
        iterations: 0,
        last_step: 0.0,
    })
}
