//! Schema, documentation and the forms of diagnostics.

use super::*;
use serde_json::{Value as Json, json};

/// As much of JSON Schema as the schema uses.
fn valid(root: &Json, s: &Json, v: &Json) -> bool {
    let Some(s) = s.as_object() else { return s.as_bool().unwrap_or(false) };
    s.iter().all(|(key, rule)| match key.as_str() {
        "$ref" => valid(root, root.pointer(rule.as_str().unwrap().trim_start_matches('#')).unwrap(), v),
        "type" => match rule.as_str().unwrap() {
            "object" => v.is_object(),
            "array" => v.is_array(),
            "string" => v.is_string(),
            "number" => v.is_number(),
            "integer" => v.is_i64(),
            "boolean" => v.is_boolean(),
            other => panic!("{other}"),
        },
        "const" => v == rule,
        "not" => !valid(root, rule, v),
        "oneOf" => rule.as_array().unwrap().iter().filter(|r| valid(root, r, v)).count() == 1,
        "anyOf" => rule.as_array().unwrap().iter().any(|r| valid(root, r, v)),
        "minimum" => v.as_f64().is_none_or(|x| x >= rule.as_f64().unwrap()),
        "exclusiveMinimum" => v.as_f64().is_none_or(|x| x > rule.as_f64().unwrap()),
        "maximum" => v.as_f64().is_none_or(|x| x <= rule.as_f64().unwrap()),
        "minItems" => v.as_array().is_none_or(|x| x.len() as u64 >= rule.as_u64().unwrap()),
        "maxItems" => v.as_array().is_none_or(|x| x.len() as u64 <= rule.as_u64().unwrap()),
        "minLength" => v.as_str().is_none_or(|x| x.len() as u64 >= rule.as_u64().unwrap()),
        "minProperties" => v.as_object().is_none_or(|x| x.len() as u64 >= rule.as_u64().unwrap()),
        "maxProperties" => v.as_object().is_none_or(|x| x.len() as u64 <= rule.as_u64().unwrap()),
        "items" => v.as_array().is_none_or(|x| x.iter().all(|x| valid(root, rule, x))),
        "required" => v.as_object().is_none_or(|x| rule.as_array().unwrap().iter().all(|k| x.contains_key(k.as_str().unwrap()))),
        "properties" => v.as_object().is_none_or(|x| x.iter().all(|(k, x)| rule.get(k).is_none_or(|r| valid(root, r, x)))),
        "additionalProperties" => {
            assert_eq!(rule, &json!(false));
            v.as_object().is_none_or(|x| x.keys().all(|k| s["properties"].get(k).is_some()))
        }
        "pattern" | "description" | "title" | "$schema" | "$defs" => true,
        other => panic!("{other}"),
    })
}

fn as_json(text: &str) -> Json {
    serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap()
}

#[test]
fn the_schema_admits_what_reads_and_refuses_wrong_shapes() {
    let s = schema::schema(&catalog());
    for text in [EXAMPLE, EVERYTHING] {
        assert!(valid(&s, &s, &as_json(text)));
        assert!(valid(&s, &s, &write_json(&good(text))));
    }
    for (from, to) in [
        ("\"2.4 kg\"", "-2.4"),
        ("\"2.4 kg\"", "true"),
        ("eccentricity =", "excentricity ="),
        ("density = \"1000 kg/m^3\"\n", ""),
        ("\"per_axis\"", "\"peraxis\""),
        ("\"bearing_cubic\"", "\"gearbox\""),
        ("[\"drum\", \"base\"]", "[\"drum\"]"),
        (", to = \"8000 rad/s\"", ""),
        ("in = \"drum\"", "in = \"ground\""),
        ("{ free_surface_radius = \"46.7 mm\" }", "{ volume = \"0.3 l\", mass = \"1 kg\" }"),
        ("name = \"base\"", "name = \"ground\""),
        ("\"auto\"", "\"always\""),
        ("[machine]", "[pump]"),
    ] {
        let text = EXAMPLE.replacen(from, to, 1);
        assert!(!valid(&s, &s, &as_json(&text)), "{from} -> {to}");
        assert!(read(&text, &catalog()).0.is_none(), "{from} -> {to}");
    }
}

#[test]
fn the_schema_names_its_draft_and_resolves() {
    let s = schema::schema(&catalog());
    assert_eq!(s["$schema"], "https://json-schema.org/draft/2020-12/schema");
    insta::assert_snapshot!(serde_json::to_string_pretty(&s["$defs"]["part.bearing_cubic"]).unwrap());
}

#[test]
fn every_example_reads() {
    let c = catalog();
    let drum = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = \"2 kg\"\n";
    for (list, what) in [(&c.parts, "part"), (&c.studies, "study")] {
        for k in list {
            let block = docs::every_key(what, k);
            good(&format!("{drum}{block}"));
            // With the optional keys too.
            good(&format!("{drum}{}", block.replace("# ", "")));
        }
    }
}

#[test]
fn documentation() {
    let c = catalog();
    insta::assert_snapshot!(docs::text("part", c.part("liquid").unwrap(), 90));
    insta::assert_snapshot!(docs::markdown("study", c.study("nonlinear_response").unwrap()));
}

#[test]
fn diagnostics_for_tools() {
    let text = EXAMPLE.replace("\"2.4 kg\"", "\"2.4 µs\"");
    let d = read(&text, &catalog()).1;
    assert_eq!(
        diagnostics_json(&d, &text),
        json!([{
            "code": "unit.dimension", "severity": "error",
            "message": "disc \"drum\": mass: a mass is needed (kg, g, t); \"2.4 µs\" is a time",
            "place": { "start": text.find("µs").unwrap(), "end": text.find("µs").unwrap() + 3, "line": 9, "column": 13, "end_line": 9, "end_column": 15 },
            "also": [], "label": "wrong dimension", "help": null,
        }])
    );
}

#[test]
fn places_outside_of_the_text_are_shown_somehow() {
    let mut d = Diagnostics::default();
    for span in [0..0, 3..1_000_000, 5_000..6_000, 4..5, 0..1] {
        d.push(Diagnostic::error("x", text!("message")).at(span).label(text!("l")).help(text!("h")));
    }
    for text in ["", "ααα", "\n\n", "a\r\nb"] {
        for form in [Form::Lines, Form::Excerpts { width: 0, colour: true }, Form::Excerpts { width: 80, colour: false }] {
            let shown = render(&d, text, "f", form);
            assert_eq!(shown.matches("message").count(), 5, "{shown}");
        }
        diagnostics_json(&d, text);
    }
}

#[test]
fn nothing_of_a_file_steers_the_terminal() {
    let evil = "\u{1b}]0;title\u{7}\u{9b}2J\u{202e}";
    let text = format!("a = 1\r\nb = \"{evil}µ{evil}\" # {evil}\r\n");
    let at = text.find('µ').unwrap();
    let mut d = Diagnostics::default();
    d.push(Diagnostic::error("x", text!("message {evil}", evil)).at(at..at + 2).label(text!("{evil}", evil)).help(text!("{evil}", evil)));
    for form in [Form::Lines, Form::Excerpts { width: 110, colour: true }, Form::Excerpts { width: 110, colour: false }] {
        let shown = render(&d, &text, &format!("f{evil}"), form);
        assert_eq!(crate::plain::painted(&shown), shown);
        assert!(form == Form::Lines || shown.contains(r"\u001b]0;title\u0007\u009b2J\u202eµ\u001b"), "{shown}");
    }
    let shown = render(&d, &text, "f", Form::Excerpts { width: 110, colour: false });
    let (line, mark) = (shown.lines().find(|l| l.contains('µ')).unwrap(), shown.lines().find(|l| l.contains('┬')).unwrap());
    let column = |l: &str, c| l.chars().position(|x| x == c);
    assert_eq!(column(line, 'µ'), column(mark, '┬'), "{shown}");
}

#[test]
fn colours_and_endless_lists() {
    let text = EXAMPLE.replace("2.4 kg", "2.4 m");
    let d = read(&text, &catalog()).1;
    assert!(render(&d, &text, "f", Form::Excerpts { width: 80, colour: true }).contains('\u{1b}'));
    assert!(!render(&d, &text, "f", Form::Excerpts { width: 80, colour: false }).contains('\u{1b}'));
    let many = format!("[machine]\n{}", "[[part]]\nkind = \"disc\"\n".repeat(200));
    let d = read(&many, &catalog()).1;
    assert_eq!(d.0.len(), 200);
    assert!(render(&d, &many, "f", Form::Lines).ends_with("... and 150 more\n"));
}
