//! From [`Spec`] back to a file: in the order of the declarations, with readable units, and exact: reading it gives the same spec. What was left out stays
//! so: some keys are refused beside others even with the value that they stand for.

use super::{Block, Catalog, Drive, RotorAxis, Spec, parameter_in};
use crate::diagnostic::Span;
use crate::model::field::{Amount, Attach, Field, FieldKind, KindInfo, RangeValue, Tolerance, Value, Values};
use crate::units::{write_number, write_si};
use serde_json::{Map, Value as Json, json};
use std::fmt::Write as _;

/// A TOML basic string.
pub(crate) fn quoted(s: &str) -> String {
    let mut out = String::with_capacity(s.len() + 2);
    out.push('"');
    for c in s.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A quantity as a TOML value.
fn quantity(x: f64, unit: &str) -> String {
    if unit.is_empty() { write_number(x) } else { quoted(&write_si(x, unit)) }
}

fn point(a: &Attach) -> String {
    match &a.body {
        None => quoted("ground"),
        Some(b) if a.position == 0.0 => quoted(b),
        Some(b) => format!("{{ body = {}, at = {} }}", quoted(b), quantity(a.position, "m")),
    }
}

fn range(r: &RangeValue, unit: &str, head: &str) -> String {
    if r.is_one() && head.is_empty() {
        return quantity(r.from, unit);
    }
    let points = r.points.map_or(String::new(), |n| format!(", points = {n}"));
    format!("{{ {head}from = {}, to = {}{points} }}", quantity(r.from, unit), quantity(r.to, unit))
}

fn list(v: &[f64], unit: &str) -> String {
    format!("[{}]", v.iter().map(|&x| quantity(x, unit)).collect::<Vec<_>>().join(", "))
}

struct Writer<'a> {
    catalog: &'a Catalog,
    spec: &'a Spec,
}

impl Writer<'_> {
    fn parameter_unit(&self, path: &str) -> &'static str {
        parameter_in(self.catalog, self.spec.named(), path).map_or("", |p| p.0)
    }

    fn value(&self, f: Option<&Field>, name: &str, value: &Value, values: &Values) -> String {
        let unit = match f.map(|f| f.kind) {
            Some(
                FieldKind::Quantity { unit, .. }
                | FieldKind::Lateral { unit, .. }
                | FieldKind::Range { unit, .. }
                | FieldKind::Named { unit, .. }
                | FieldKind::List { unit, .. },
            ) => unit,
            _ => "",
        };
        match value {
            Value::Number(x) => quantity(*x, unit),
            Value::Lateral([x, y]) if x == y => quantity(*x, unit),
            Value::Lateral([x, y]) => format!("{{ x = {}, y = {} }}", quantity(*x, unit), quantity(*y, unit)),
            Value::OneOf(which, x) => {
                let unit = match f.map(|f| f.kind) {
                    Some(FieldKind::OneOf(l)) => l.iter().find(|o| o.0 == *which).map_or("", |o| o.1),
                    _ => "",
                };
                format!("{{ {which} = {} }}", quantity(*x, unit))
            }
            Value::Choice(w) => quoted(w),
            Value::Integer(i) => i.to_string(),
            Value::Auto => quoted("auto"),
            Value::Flag(b) => b.to_string(),
            Value::Text(t) => quoted(t),
            Value::Attach(a) => point(a),
            Value::Between(a, b) => format!("[{}, {}]", point(a), point(b)),
            Value::Range(r) => range(r, unit, ""),
            Value::List(v) => list(v, unit),
            Value::ParameterRange(path, r) => range(r, self.parameter_unit(path), &format!("parameter = {}, ", quoted(path))),
            Value::ParameterRanges(l) => {
                let one = |(path, r, _): &(String, RangeValue, Option<Span>)| {
                    range(r, self.parameter_unit(path), &format!("parameter = {}, ", quoted(path)))
                };
                format!("[{}]", l.iter().map(one).collect::<Vec<_>>().join(", "))
            }
            Value::Columns(columns) => {
                let unit = |c: &str| match f.map(|f| f.kind) {
                    Some(FieldKind::Columns(l)) => l.iter().find(|o| o.0 == c).map_or("", |o| o.1),
                    _ => "",
                };
                let columns: Vec<String> = columns.iter().map(|(c, v)| format!("{c} = {}", list(v, unit(c)))).collect();
                format!("{{ {} }}", columns.join(", "))
            }
            Value::StateMap(entries) => {
                let units = values.units_of(name);
                let each = entries.iter().enumerate().map(|(i, (key, x, _))| {
                    let text = match units.get(i) {
                        Some(Some(u)) => quoted(write_si(*x, u).trim_end()),
                        _ => write_number(*x),
                    };
                    format!("{} = {text}", quoted(key))
                });
                format!("{{ {} }}", each.collect::<Vec<_>>().join(", "))
            }
            Value::Study(inner) => match &inner.name {
                Some(name) => quoted(name),
                None => {
                    let fields = self.catalog.study(inner.kind).map_or(&[][..], |k| &k.fields);
                    let each = fields.iter().filter_map(|f| {
                        let v = inner.values.get(f.name)?;
                        Some(format!(", {} = {}", f.name, self.value(Some(f), f.name, v, &inner.values)))
                    });
                    format!("{{ kind = {}{} }}", quoted(inner.kind), each.collect::<String>())
                }
            },
            Value::Tolerances(list) => {
                let one = |t: &Tolerance| {
                    let amount = |(name, a): &(&str, Amount)| match a {
                        Amount::Absolute(x) => format!(", {name} = {}", quantity(*x, self.parameter_unit(&t.parameter))),
                        Amount::Percent(x) => format!(", {name} = \"{} %\"", write_number(*x)),
                    };
                    let amounts: String = t.amounts.iter().map(amount).collect();
                    format!("{{ parameter = {}, distribution = {}{amounts} }}", quoted(&t.parameter), quoted(t.distribution))
                };
                format!("[{}]", list.iter().map(one).collect::<Vec<_>>().join(", "))
            }
        }
    }

    fn block(&self, out: &mut String, what: &str, b: &Block, info: Option<&KindInfo>) {
        let _ = write!(out, "\n[[{what}]]\nkind = {}\nname = {}\n", quoted(b.kind), quoted(&b.name));
        self.fields(out, b, info);
    }

    fn fields(&self, out: &mut String, b: &Block, info: Option<&KindInfo>) {
        let fields: &[Field] = info.map_or(&[], |k| &k.fields);
        for f in fields.iter().filter(|f| b.values.written(f.name)) {
            if let Some(v) = b.values.get(f.name) {
                let _ = writeln!(out, "{} = {}", f.name, self.value(Some(f), f.name, v, &b.values));
            }
        }
    }
}

/// The canonical file of a spec. Values that no field of the catalogue declares are left out.
pub fn write(spec: &Spec, catalog: &Catalog) -> String {
    let w = Writer { catalog, spec };
    let m = &spec.machine;
    let mut out = format!("[machine]\nname = {}\n", quoted(&m.name));
    if let Some(s) = m.speed {
        let _ = writeln!(out, "speed = {}", quantity(s, "rad/s"));
    }
    let _ = writeln!(out, "axis = {}", quoted(axis_word(m.axis)));
    if m.drive == Drive::Free {
        let _ = writeln!(out, "drive = \"free\"");
    }
    for b in &spec.parts {
        w.block(&mut out, "part", b, catalog.part(b.kind));
    }
    for (word, b) in &spec.extras {
        let info = catalog.blocks.iter().find(|i| i.word == *word);
        let kind = info.and_then(|i| i.kinds.iter().find(|k| k.kind == b.kind));
        if info.is_some_and(|i| i.several) {
            w.block(&mut out, word, b, kind);
        } else {
            let _ = writeln!(out, "\n[{word}]");
            w.fields(&mut out, b, kind);
        }
    }
    for b in &spec.studies {
        w.block(&mut out, "study", b, catalog.study(b.kind));
    }
    out
}

fn axis_word(a: RotorAxis) -> &'static str {
    match a {
        RotorAxis::Vertical => "vertical",
        RotorAxis::Horizontal => "horizontal",
    }
}

/// The JSON form: the keys of the file, numbers in SI units (initial values as texts with their unit).
pub fn write_json(spec: &Spec) -> Json {
    to_json(spec, false)
}

/// With `whole`, a study that another one names is written in full.
fn to_json(spec: &Spec, whole: bool) -> Json {
    let m = &spec.machine;
    let mut machine = Map::new();
    machine.insert("name".into(), json!(m.name));
    if let Some(s) = m.speed {
        machine.insert("speed".into(), json!(s));
    }
    machine.insert("axis".into(), json!(axis_word(m.axis)));
    if m.drive == Drive::Free {
        machine.insert("drive".into(), json!("free"));
    }
    let blocks = |list: &[Block]| -> Vec<Json> {
        let one = |b: &Block| {
            let mut o = Map::new();
            o.insert("kind".into(), json!(b.kind));
            o.insert("name".into(), json!(b.name));
            for name in b.values.names() {
                if let Some(v) = b.values.get(name) {
                    o.insert(name.into(), json_value(name, v, &b.values, whole));
                }
            }
            Json::Object(o)
        };
        list.iter().map(one).collect()
    };
    let mut out = json!({ "machine": machine, "part": blocks(&spec.parts), "study": blocks(&spec.studies) });
    for (word, b) in &spec.extras {
        let Some(Json::Object(mut o)) = blocks(std::slice::from_ref(b)).pop() else { continue };
        if b.kind == *word {
            o.remove("kind");
            o.remove("name");
            out[word] = Json::Object(o);
        } else {
            match out.get_mut(word).and_then(Json::as_array_mut) {
                Some(list) => list.push(Json::Object(o)),
                None => out[word] = json!([o]),
            }
        }
    }
    out
}

/// All in a file that settles the numbers of one study: the machine without its title, the parts, and the study without its name.
pub fn canonical(spec: &Spec, study: &str) -> Json {
    let mut all = to_json(
        &Spec {
            machine: spec.machine.clone(),
            parts: spec.parts.clone(),
            studies: spec.study(study).cloned().into_iter().collect(),
            extras: spec.extras.clone(),
        },
        true,
    );
    if let Some(machine) = all["machine"].as_object_mut() {
        machine.shift_remove("name");
    }
    let mut study = all["study"][0].take();
    if let Some(study) = study.as_object_mut() {
        study.shift_remove("name");
    }
    all["study"] = study;
    all
}

fn json_value(name: &str, value: &Value, values: &Values, whole: bool) -> Json {
    let point = |a: &Attach| match &a.body {
        None => json!("ground"),
        Some(b) if a.position == 0.0 => json!(b),
        Some(b) => json!({ "body": b, "at": a.position }),
    };
    let range = |r: &RangeValue| {
        let mut o = Map::new();
        o.insert("from".into(), json!(r.from));
        o.insert("to".into(), json!(r.to));
        if let Some(n) = r.points {
            o.insert("points".into(), json!(n));
        }
        o
    };
    match value {
        Value::Number(x) => json!(x),
        Value::Lateral([x, y]) => json!({ "x": x, "y": y }),
        Value::OneOf(which, x) => json!({ *which: x }),
        Value::Choice(w) => json!(w),
        Value::Integer(i) => json!(i),
        Value::Auto => json!("auto"),
        Value::Flag(b) => json!(b),
        Value::Text(t) => json!(t),
        Value::Attach(a) => point(a),
        Value::Between(a, b) => json!([point(a), point(b)]),
        Value::Range(r) => Json::Object(range(r)),
        Value::List(v) => json!(v),
        Value::ParameterRange(path, r) => {
            let mut o = range(r);
            o.insert("parameter".into(), json!(path));
            Json::Object(o)
        }
        Value::ParameterRanges(l) => {
            let one = |(path, r, _): &(String, RangeValue, Option<Span>)| {
                let mut o = range(r);
                o.insert("parameter".into(), json!(path));
                Json::Object(o)
            };
            Json::Array(l.iter().map(one).collect())
        }
        Value::Columns(c) => json!(c),
        Value::Study(inner) => {
            let mut o = Map::new();
            o.insert("kind".into(), json!(inner.kind));
            for name in inner.values.names() {
                if let Some(v) = inner.values.get(name) {
                    o.insert(name.into(), json_value(name, v, &inner.values, whole));
                }
            }
            // the name of a study that is in the file suffices, but not where it stands alone
            match &inner.name {
                Some(name) if !whole => json!(name),
                _ => Json::Object(o),
            }
        }
        Value::Tolerances(list) => {
            let one = |t: &Tolerance| {
                let mut o = Map::new();
                o.insert("parameter".into(), json!(t.parameter));
                o.insert("distribution".into(), json!(t.distribution));
                for (name, a) in &t.amounts {
                    let v = match a {
                        Amount::Absolute(x) => json!(x),
                        Amount::Percent(x) => json!(format!("{} %", write_number(*x))),
                    };
                    o.insert((*name).into(), v);
                }
                Json::Object(o)
            };
            Json::Array(list.iter().map(one).collect())
        }
        Value::StateMap(entries) => {
            let units = values.units_of(name);
            let mut o = Map::new();
            for (i, (key, x, _)) in entries.iter().enumerate() {
                let v = match units.get(i) {
                    Some(Some(u)) => json!(write_si(*x, u)),
                    _ => json!(x),
                };
                o.insert(key.clone(), v);
            }
            Json::Object(o)
        }
    }
}
