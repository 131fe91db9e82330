//! What the registries declare, for the modules `laval.parts`, `laval.studies` and `laval.blocks`.

use laval::file::{self, docs};
use laval::model::field::{Field, FieldKind, KindInfo};
use laval::units;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde_json::{Value, json};

/// All kinds of parts, studies and blocks beside them, with their keys, as JSON.
#[pyfunction]
pub fn catalog() -> String {
    let all = file::catalog();
    let kinds = |word: &str, list: &[KindInfo]| list.iter().map(|k| kind(word, k)).collect::<Vec<_>>();
    let blocks: Vec<Value> =
        all.blocks.iter().map(|b| json!({ "word": b.word, "several": b.several, "kinds": kinds(b.word, &b.kinds) })).collect();
    json!({
        "machine": kind("machine", &docs::machine()),
        "parts": kinds("part", &all.parts),
        "studies": kinds("study", &all.studies),
        "blocks": blocks,
    })
    .to_string()
}

/// The SI value of a quantity, and its SI unit: `("3000 rpm")` is `(314.159..., "rad/s")`.
#[pyfunction]
pub fn si(quantity: &str) -> PyResult<(f64, String)> {
    let (x, unit) = units::read_any(quantity).map_err(|e| PyValueError::new_err(e.to_string()))?;
    Ok((x, unit.dimension.si_text()))
}

fn kind(word: &str, k: &KindInfo) -> Value {
    let fields: Vec<Value> = k.fields.iter().map(field).collect();
    json!({ "kind": k.kind, "doc": k.doc, "example": docs::example(word, k), "fields": fields })
}

fn field(f: &Field) -> Value {
    let mut out = json!({ "name": f.name, "required": f.required, "default": f.default, "doc": f.doc, "takes": docs::takes(f) });
    out["type"] = json!(match f.kind {
        FieldKind::Quantity { .. } => "quantity",
        FieldKind::Lateral { .. } => "lateral",
        FieldKind::OneOf(_) => "one_of",
        FieldKind::Choice(_) => "choice",
        FieldKind::Integer { .. } => "integer",
        FieldKind::IntegerOrAuto { .. } => "integer_or_auto",
        FieldKind::Flag => "flag",
        FieldKind::Text => "text",
        FieldKind::Attach { .. } => "point",
        FieldKind::Between => "between",
        FieldKind::Range { .. } => "range",
        FieldKind::List { .. } => "list",
        FieldKind::ParameterPath => "parameter",
        FieldKind::ParameterRange => "parameter_range",
        FieldKind::ParameterRanges => "parameter_ranges",
        FieldKind::Coordinate => "coordinate",
        FieldKind::Columns(_) => "columns",
        FieldKind::Named { .. } => "named",
        FieldKind::StateMap => "state",
        FieldKind::Study => "study",
        FieldKind::Tolerances => "tolerances",
    });
    match f.kind {
        FieldKind::Choice(words) => out["words"] = words.iter().map(|w| w.0).collect(),
        FieldKind::OneOf(list) => out["words"] = list.iter().map(|o| o.0).collect(),
        FieldKind::Columns(list) => out["words"] = list.iter().map(|o| o.0).collect(),
        _ => {}
    }
    out
}
