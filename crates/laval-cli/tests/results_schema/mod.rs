//! results.json keeps the layout that `laval schema --results` states: the keywords of JSON Schema that it uses, checked here.

use serde_json::Value;

/// What of `value` is against `schema`, with its path.
pub fn mistakes(schema: &Value, value: &Value) -> Vec<String> {
    let mut out = Vec::new();
    walk(schema, schema, value, "", &mut out);
    out
}

fn walk(root: &Value, schema: &Value, value: &Value, path: &str, out: &mut Vec<String>) {
    for (keyword, rule) in schema.as_object().expect("a schema is an object") {
        match keyword.as_str() {
            "$schema" | "title" | "description" | "$defs" | "properties" => {}
            "$ref" => {
                let place = rule.as_str().and_then(|r| r.strip_prefix('#')).expect("a reference inside the schema");
                walk(root, root.pointer(place).unwrap_or_else(|| panic!("{place} is not there")), value, path, out);
            }
            "const" => out.extend((value != rule).then(|| format!("{path}: {value} is not {rule}"))),
            "enum" => out.extend((!rule.as_array().unwrap().contains(value)).then(|| format!("{path}: {value} is none of {rule}"))),
            "type" => {
                let names: Vec<&str> =
                    rule.as_array().map_or_else(|| vec![rule.as_str().unwrap()], |a| a.iter().filter_map(Value::as_str).collect());
                out.extend((!names.iter().any(|n| is(value, n))).then(|| format!("{path}: {value} is no {rule}")));
            }
            "required" => {
                let Some(object) = value.as_object() else { continue };
                let missing = rule.as_array().unwrap().iter().filter_map(Value::as_str).filter(|k| !object.contains_key(*k));
                out.extend(missing.map(|k| format!("{path}: {k} is missing")));
            }
            "additionalProperties" => {
                let known = schema["properties"].as_object();
                for (key, inner) in value.as_object().into_iter().flatten() {
                    let path = format!("{path}/{key}");
                    match (known.and_then(|k| k.get(key)), rule) {
                        (Some(own), _) => walk(root, own, inner, &path, out),
                        (None, Value::Bool(false)) => out.push(format!("{path}: not in the schema")),
                        (None, other) => walk(root, other, inner, &path, out),
                    }
                }
            }
            "items" => {
                for (k, inner) in value.as_array().into_iter().flatten().enumerate() {
                    walk(root, rule, inner, &format!("{path}/{k}"), out);
                }
            }
            "anyOf" => {
                let fits = |one: &Value| {
                    let mut wrong = Vec::new();
                    walk(root, one, value, path, &mut wrong);
                    wrong.is_empty()
                };
                out.extend((!rule.as_array().unwrap().iter().any(fits)).then(|| format!("{path}: {value} fits none of the alternatives")));
            }
            other => panic!("the keyword {other} is not checked here"),
        }
    }
}

fn is(value: &Value, name: &str) -> bool {
    match name {
        "null" => value.is_null(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("{other}"),
    }
}

#[test]
fn what_the_layout_does_not_allow_is_found() {
    let schema: Value = serde_json::from_str(laval::report::RESULTS_SCHEMA).unwrap();
    let empty = laval::report::Report { machine: "m".into(), ..Default::default() };
    let good: Value = serde_json::from_str(&laval::report::json(&empty)).unwrap();
    assert_eq!(mistakes(&schema, &good), [""; 0]);
    for (place, wrong) in [("/schema", 1.into()), ("/machine", 3.into()), ("/studies", Value::Null), ("/provenance/seed", "x".into())] {
        let mut bad = good.clone();
        *bad.pointer_mut(place).unwrap() = wrong;
        assert_eq!(mistakes(&schema, &bad).len(), 1, "{place}");
    }
    let mut more = good.clone();
    more["text"] = "x".into();
    assert_eq!(mistakes(&schema, &more), ["/text: not in the schema"]);
    more.as_object_mut().unwrap().remove("machine");
    assert_eq!(mistakes(&schema, &more).len(), 2);
}
