//! A study from its fields in Rust: the names, units, defaults and checks of a machine file, without a file.

use super::blocks::read_fields;
use super::tree::{Entry, from_json};
use super::values::Context;
use super::{catalog, names};
use crate::diagnostic::{Diagnostic, Diagnostics, nearest};
use crate::model::field::Values;
use crate::model::system::System;
use crate::study::{ErasedStudy, Study, registry};
use crate::text;

/// A study of a machine from its fields, by the names of the [study's page](crate::study::Study::FIELDS). Numbers are in SI units; texts may carry
/// other units.
///
/// ```
/// use laval::file::construct;
/// use laval::prelude::*;
/// use serde_json::json;
///
/// # fn main() -> Result<(), Diagnostics> {
/// let ground = || Link::Between(Attach::on("rotor"), Attach::ground());
/// let machine = Builder::new("Laval rotor")
///     .part("rotor", Disc::planar(), DiscParams { eccentricity: 20e-6, ..DiscParams::new(3.0) })
///     .part("shaft", BearingCubic::per_axis(ground()), BearingCubicParams::new([3e5; 2], [1e12; 2]))
///     .part("air", Damper::fixed(ground()), DamperParams::new([20.0; 2]))
///     .build()?;
/// let sweep: Sweep = construct(&machine, &json!({ "speed": { "from": "2000 rpm", "to": 500.0, "points": 4 }, "start": "up" }))?;
/// let outcome = sweep.run(&machine, &Context::quiet("sweep")).map_err(|d| Diagnostics(vec![d]))?;
/// assert_eq!(outcome.find_table("sweep").map(|t| t.rows()), Some(4));
/// # Ok(()) }
/// ```
///
/// # Errors
/// All that is wrong with the fields, or with the study for this machine.
pub fn construct<T: Study>(system: &System, fields: &serde_json::Value) -> Result<T, Diagnostics> {
    let mut out = Diagnostics::default();
    let values = read(T::KIND, system, fields, &mut out);
    let built = values.and_then(|values| T::build(&values, system, &mut out));
    finished(built, out)
}

/// The same of a kind of study by its word in the file.
///
/// # Errors
/// All that is wrong with the kind, the fields, or the study for this machine.
pub fn construct_kind(kind: &str, system: &System, fields: &serde_json::Value) -> Result<Box<dyn ErasedStudy>, Diagnostics> {
    let mut out = Diagnostics::default();
    let registry = registry();
    let Some(found) = registry.iter().find(|k| k.info.kind == kind) else {
        let close = nearest(kind, registry.iter().map(|k| k.info.kind)).map(|k| text!("did you mean {near}?", near = text::quoted(&k)));
        let all = registry.iter().map(|k| k.info.kind).collect::<Vec<_>>().join(", ");
        let message = text!("there is no kind of study \"{kind}\"", kind);
        out.push(Diagnostic::error("kind.unknown", message).help(close.unwrap_or_else(|| text!("there is {all}", all))));
        return Err(out);
    };
    let values = read(found.info.kind, system, fields, &mut out);
    let built = values.and_then(|values| (found.build)(&values, system, &mut out));
    finished(built, out)
}

fn finished<T>(built: Option<T>, mut out: Diagnostics) -> Result<T, Diagnostics> {
    if built.is_none() && !out.has_errors() {
        out.push(Diagnostic::error("study.fields", text!("the study cannot be made from these fields")));
    }
    built.filter(|_| !out.has_errors()).ok_or(out)
}

/// The values of the fields; `None` where one is missing or wrong.
fn read(kind: &'static str, system: &System, fields: &serde_json::Value, out: &mut Diagnostics) -> Option<Values> {
    let catalog = catalog();
    let info = catalog.studies.iter().find(|k| k.kind == kind)?;
    let node = from_json(fields);
    let Some(table): Option<&[Entry]> = node.table() else {
        let message = text!("the fields of {kind} are an object, not {shape}", kind, shape = node.shape());
        out.push(Diagnostic::error("value.type", message).help(text!("write {{ \"speed\": 300.0 }}")));
        return None;
    };
    let parts: Vec<(String, &'static str)> = system.slots().iter().map(|s| (s.name.clone(), s.part.kind())).collect();
    let mut values = Values::default();
    let mut context = Context { text: "", catalog, parts: &parts, studies: &[], out, who: kind };
    read_fields(&mut context, info, &["kind"], table, None, &mut values);
    names::check(&info.fields, &values, &registry(), system, out);
    (!out.has_errors()).then_some(values)
}
