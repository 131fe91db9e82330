//! Coordinates and parameters that studies name.

use crate::diagnostic::{Diagnostic, Diagnostics, Span, meant, nearest};
use crate::model::field::{Field, FieldKind, Value, Values};
use crate::model::system::System;
use crate::study::StudyKind;
use crate::text;

/// They exist.
pub(super) fn check(fields: &[Field], values: &Values, registry: &[StudyKind], system: &System, out: &mut Diagnostics) {
    for field in fields {
        let span = || values.span_of(field.name);
        match (field.kind, values.get(field.name)) {
            (FieldKind::Coordinate, Some(Value::Text(name))) => coordinate(system, name, span(), out),
            (FieldKind::ParameterPath, Some(Value::Text(path))) if system.param(path).is_none() => {
                out.push(system.unknown_param(path).at(span()).label(text!("unknown parameter")));
            }
            (FieldKind::Tolerances, Some(Value::Tolerances(list))) => {
                for t in list.iter().filter(|t| system.param(&t.parameter).is_none()) {
                    out.push(system.unknown_param(&t.parameter).at(t.span.clone()).label(text!("unknown parameter")));
                }
            }
            (FieldKind::ParameterRanges, Some(Value::ParameterRanges(list))) => {
                for (path, _, place) in list.iter().filter(|r| system.param(&r.0).is_none()) {
                    out.push(system.unknown_param(path).at(place.clone()).label(text!("unknown parameter")));
                }
            }
            // one that is named is checked where it stands
            (FieldKind::Study, Some(Value::Study(inner))) if inner.name.is_none() => {
                if let Some(kind) = registry.iter().find(|k| k.info.kind == inner.kind) {
                    check(&kind.info.fields, &inner.values, registry, system, out);
                }
            }
            _ => {}
        }
    }
}

fn coordinate(system: &System, name: &str, span: Option<Span>, out: &mut Diagnostics) {
    let all = || system.coordinates().iter().chain(system.states()).map(|c| c.name.as_str());
    if all().any(|n| n == name) {
        return;
    }
    let known = text!("coordinates of this machine: {all}", all = all().collect::<Vec<_>>().join(", "));
    let help = nearest(name, all()).map_or_else(|| known.clone(), |n| meant(text::quoted(&n), known.clone()));
    out.push(
        Diagnostic::error("coordinate.unknown", text!("there is no coordinate \"{name}\"", name))
            .at(span)
            .label(text!("unknown coordinate"))
            .about(name)
            .help(help),
    );
}
