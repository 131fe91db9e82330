//! JSON Schema of machine files, for editors that complete and check while one writes.

use super::docs::takes;
use super::{Catalog, MACHINE_FIELDS};
use crate::model::field::{AMOUNTS, Bounds, DISTRIBUTIONS, Field, FieldKind, KindInfo, MOST_POINTS};
use crate::units::{describe, examples};
use serde_json::{Map, Value as Json, json};

/// The schema (draft 2020-12). It knows shapes, words, and bounds of bare SI numbers; dimensions of quantities with units are
/// checked by the reader alone.
pub fn schema(catalog: &Catalog) -> Json {
    let mut defs = Map::new();
    let mut kinds = |list: &[KindInfo], what: &str| -> Json {
        let refs: Vec<Json> = list
            .iter()
            .map(|k| {
                let name = format!("{what}.{}", k.kind);
                defs.insert(name.clone(), block(k));
                json!({ "$ref": format!("#/$defs/{name}") })
            })
            .collect();
        if refs.is_empty() { json!({ "type": "object" }) } else { json!({ "oneOf": refs }) }
    };
    let part = kinds(&catalog.parts, "part");
    let study = kinds(&catalog.studies, "study");
    let extras: Vec<(&str, Json)> = catalog
        .blocks
        .iter()
        .map(|b| {
            let one = kinds(&b.kinds, b.word);
            (b.word, if b.several { json!({ "type": "array", "items": one, "description": "what separates" }) } else { one })
        })
        .collect();
    let mut out = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "laval machine file",
        "type": "object",
        "properties": {
            "machine": object(MACHINE_FIELDS, &[], "the machine as a whole"),
            "part": { "type": "array", "items": part, "minItems": 1, "description": "the parts of the machine" },
            "study": { "type": "array", "items": study, "description": "what is computed" },
        },
        "required": ["machine", "part"],
        "additionalProperties": false,
        "$defs": defs,
    });
    for (word, s) in extras {
        out["properties"][word] = s;
    }
    for b in catalog.blocks.iter().filter(|b| !b.several) {
        // a block that exists once says neither kind nor name
        let s = &mut out["$defs"][format!("{}.{}", b.word, b.word)];
        if let Some(p) = s["properties"].as_object_mut() {
            p.remove("kind");
            p.remove("name");
        }
        if let Some(r) = s["required"].as_array_mut() {
            r.retain(|x| x != "kind");
        }
    }
    out
}

fn block(k: &KindInfo) -> Json {
    let name = json!({ "type": "string", "pattern": "^[\\p{L}\\p{N}]([\\p{L}\\p{M}\\p{N} _-]{0,62}[\\p{L}\\p{M}\\p{N}_-])?$", "not": { "const": "ground" },
        "description": "name by which others refer to it; the kind when left out" });
    object(&k.fields, &[("kind", json!({ "const": k.kind, "description": k.doc })), ("name", name)], k.doc)
}

fn object(fields: &[Field], first: &[(&str, Json)], doc: &str) -> Json {
    let mut properties = Map::new();
    let mut required: Vec<&str> = Vec::new();
    for (name, s) in first {
        properties.insert((*name).into(), s.clone());
        if *name == "kind" {
            required.push(name);
        }
    }
    for f in fields {
        let mut s = field(f);
        if let Json::Object(o) = &mut s {
            let default = if f.default.is_empty() { String::new() } else { format!("; default {}", f.default.trim()) };
            o.insert("description".into(), json!(format!("{}: {}{default}", f.doc, takes(f))));
        }
        properties.insert(f.name.into(), s);
        if f.required {
            required.push(f.name);
        }
    }
    json!({ "type": "object", "description": doc, "properties": properties, "required": required, "additionalProperties": false })
}

fn quantity(unit: &str, b: &Bounds) -> Json {
    let mut number = Map::new();
    number.insert("type".into(), json!("number"));
    let lower = if b.min_open { "exclusiveMinimum" } else { "minimum" };
    if b.min.is_finite() {
        number.insert(lower.into(), json!(b.min));
    }
    if b.max.is_finite() {
        number.insert("maximum".into(), json!(b.max));
    }
    let text =
        json!({ "type": "string", "pattern": "^\\s*[-+−]?[0-9._]", "description": format!("{} ({})", describe(unit), examples(unit)) });
    json!({ "anyOf": [number, text] })
}

fn table(properties: Map<String, Json>, required: &[&str]) -> Json {
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

fn point(ground: bool) -> Json {
    let body = if ground {
        json!({ "type": "string", "minLength": 1 })
    } else {
        json!({ "type": "string", "minLength": 1, "not": { "const": "ground" } })
    };
    let mut o = Map::new();
    o.insert("body".into(), body.clone());
    o.insert("at".into(), quantity("m", &Bounds::within(1e4)));
    json!({ "anyOf": [body, table(o, &["body"])] })
}

fn range(extra: &[(&str, Json)], end: Json) -> Json {
    let mut o = Map::new();
    for (name, s) in extra {
        o.insert((*name).into(), s.clone());
    }
    o.insert("from".into(), end.clone());
    o.insert("to".into(), end);
    o.insert("points".into(), json!({ "type": "integer", "minimum": 2, "maximum": MOST_POINTS }));
    let mut required: Vec<&str> = extra.iter().map(|e| e.0).collect();
    required.extend(["from", "to"]);
    table(o, &required)
}

fn field(f: &Field) -> Json {
    let any = Bounds::within(f64::MAX);
    match f.kind {
        FieldKind::Quantity { unit, bounds } => quantity(unit, &bounds),
        FieldKind::Lateral { unit, bounds } => {
            let one = quantity(unit, &bounds);
            let mut o = Map::new();
            o.insert("x".into(), one.clone());
            o.insert("y".into(), one.clone());
            let pair = table(o, &["x", "y"]);
            match one {
                Json::Object(mut m) => {
                    if let Some(Json::Array(list)) = m.get_mut("anyOf") {
                        list.push(pair);
                    }
                    Json::Object(m)
                }
                other => other,
            }
        }
        FieldKind::OneOf(list) => {
            let o: Map<String, Json> = list
                .iter()
                .map(|o| {
                    let mut s = quantity(o.1, &o.2);
                    s["description"] = json!(o.3);
                    (o.0.to_string(), s)
                })
                .collect();
            let mut s = table(o, &[]);
            s["minProperties"] = json!(1);
            s["maxProperties"] = json!(1);
            s
        }
        FieldKind::Choice(words) => {
            json!({ "oneOf": words.iter().map(|w| json!({ "const": w.0, "description": w.1 })).collect::<Vec<_>>() })
        }
        FieldKind::Integer { min, max } => json!({ "type": "integer", "minimum": min, "maximum": max }),
        FieldKind::IntegerOrAuto { min, max } => {
            json!({ "anyOf": [{ "type": "integer", "minimum": min, "maximum": max }, { "const": "auto" }] })
        }
        FieldKind::Flag => json!({ "type": "boolean" }),
        FieldKind::Text => json!({ "type": "string" }),
        FieldKind::Coordinate | FieldKind::ParameterPath => json!({ "type": "string", "minLength": 1 }),
        FieldKind::Attach { ground } => point(ground),
        FieldKind::Between => json!({ "type": "array", "items": point(true), "minItems": 2, "maxItems": 2 }),
        FieldKind::Range { unit, bounds } => json!({ "anyOf": [quantity(unit, &bounds), range(&[], quantity(unit, &bounds))] }),
        FieldKind::List { unit, bounds } => json!({ "type": "array", "items": quantity(unit, &bounds), "minItems": 1 }),
        FieldKind::ParameterRange => range(&[("parameter", json!({ "type": "string", "minLength": 1 }))], quantity("", &any)),
        FieldKind::ParameterRanges => {
            let one = range(&[("parameter", json!({ "type": "string", "minLength": 1 }))], quantity("", &any));
            json!({ "type": "array", "items": one, "minItems": 1 })
        }
        FieldKind::Columns(list) => {
            let column = |c: &(&str, &str, bool, &str)| {
                (c.0.to_string(), json!({ "type": "array", "items": quantity(c.1, &any), "minItems": 1, "description": c.3 }))
            };
            let required: Vec<&str> = list.iter().filter(|c| c.2).map(|c| c.0).collect();
            let cell = |c: &(&str, &str, bool, &str)| {
                let mut one = quantity(c.1, &any);
                if let Some(o) = one.as_object_mut() {
                    o.insert("description".into(), json!(c.3));
                }
                (c.0.to_string(), one)
            };
            let row = table(list.iter().map(cell).collect(), &required);
            json!({ "anyOf": [table(list.iter().map(column).collect(), &required), { "type": "array", "items": row, "minItems": 1 }] })
        }
        FieldKind::Named { unit, bounds } => {
            let one = quantity(unit, &bounds);
            json!({ "anyOf": [one, { "type": "object" }] })
        }
        FieldKind::StateMap => json!({ "type": "object" }),
        FieldKind::Study => {
            let kind = json!({ "type": "object", "properties": { "kind": { "type": "string" } }, "required": ["kind"] });
            json!({ "anyOf": [{ "type": "string", "minLength": 1 }, kind] })
        }
        FieldKind::Tolerances => {
            let mut o = Map::new();
            o.insert("parameter".into(), json!({ "type": "string", "minLength": 1 }));
            let words: Vec<Json> = DISTRIBUTIONS.iter().map(|w| json!({ "const": w.0, "description": w.1 })).collect();
            o.insert("distribution".into(), json!({ "oneOf": words }));
            for a in AMOUNTS {
                o.insert((*a).into(), quantity("", &any));
            }
            json!({ "type": "array", "items": table(o, &["parameter", "distribution"]), "minItems": 1 })
        }
    }
}
