//! What may be written in a machine file, for the editor of the page.

use laval::file::{self, MACHINE_FIELDS};
use laval::model::field::{Field, FieldKind, KindInfo};
use laval::outcome::Arg;
use laval::report::Style;
use serde_json::{Map, Value as Json, json};

fn key(field: &Field, style: &Style) -> Json {
    let mut out = Map::new();
    out.insert("name".into(), json!(field.name));
    out.insert("doc".into(), json!(style.arg(&Arg::term(field.doc))));
    let unit = match field.kind {
        FieldKind::Quantity { unit, .. }
        | FieldKind::Lateral { unit, .. }
        | FieldKind::Range { unit, .. }
        | FieldKind::List { unit, .. }
        | FieldKind::Named { unit, .. } => Some(unit),
        _ => None,
    };
    if let Some(unit) = unit.filter(|u| !u.is_empty()) {
        out.insert("unit".into(), json!(unit));
    }
    let values: Option<Vec<String>> = match field.kind {
        FieldKind::Choice(words) => Some(words.iter().map(|w| format!("\"{}\"", w.0)).collect()),
        FieldKind::OneOf(list) => Some(list.iter().map(|o| format!("{{ {} =  }}", o.0)).collect()),
        FieldKind::Flag => Some(vec!["true".into(), "false".into()]),
        FieldKind::IntegerOrAuto { .. } => Some(vec!["\"auto\"".into()]),
        _ => None,
    };
    if let Some(values) = values {
        out.insert("values".into(), json!(values));
    }
    if !field.default.is_empty() {
        out.insert("default".into(), json!(field.default));
    }
    if field.required {
        out.insert("required".into(), json!(true));
    }
    out.into()
}

fn keys(fields: &[Field], style: &Style) -> Vec<Json> {
    fields.iter().map(|f| key(f, style)).collect()
}

fn kind(k: &KindInfo, style: &Style) -> Json {
    json!({ "kind": k.kind, "doc": style.arg(&Arg::term(k.doc)), "keys": keys(&k.fields, style) })
}

pub(crate) fn completion(style: &Style) -> Json {
    let kinds = |list: &[KindInfo]| list.iter().map(|k| kind(k, style)).collect::<Vec<Json>>();
    let blocks: Map<String, Json> =
        file::catalog().blocks.iter().map(|b| (b.word.to_string(), json!({ "several": b.several, "kinds": kinds(&b.kinds) }))).collect();
    json!({
        "machine": { "keys": keys(MACHINE_FIELDS, style) },
        "parts": kinds(&file::catalog().parts),
        "studies": kinds(&file::catalog().studies),
        "blocks": blocks,
    })
}
