//! Every kind of field, read from a tree into SI units and checked.

use super::tree::{Data, Entry, Node, get};
use super::{Catalog, parameter_of, parameters_of};
use crate::diagnostic::{Diagnostic, Diagnostics, Span, nearest};
use crate::model::field::{Attach, Bounds, Field, FieldKind, KindInfo, RangeValue, Value, Values};
use crate::units::{self, UnitError};
use std::collections::BTreeMap;

/// Most points of a range.
const MAX_POINTS: i64 = 1_000_000;

/// What reading a field needs to know about its surroundings.
pub(super) struct Context<'a> {
    pub text: &'a str,
    pub catalog: &'a Catalog,
    /// Name and kind of every part in the file (kind empty when it is unknown).
    pub parts: &'a [(String, &'static str)],
    /// The studies in the file, for those that refer to one.
    pub studies: &'a [StudyTable<'a>],
    pub out: &'a mut Diagnostics,
    /// The block in messages: `disc "drum"`.
    pub who: &'a str,
}

/// A study before its values are read.
pub(super) struct StudyTable<'a> {
    pub name: &'a str,
    pub info: Option<&'a KindInfo>,
    pub table: &'a [Entry<'a>],
    pub span: Option<Span>,
}

pub(super) fn subject(who: &str, field: &str) -> String {
    if field.is_empty() { who.to_string() } else { format!("{who}: {field}") }
}

/// An interval in words, with a capital unit where both ends share one.
pub(super) fn bounds_text(b: &Bounds, unit: &str) -> String {
    let n = |x: f64| match unit {
        "rad/s" | "rad" | "K" => units::format_si(x, unit),
        _ => units::write_si(x, unit),
    };
    let low = match (b.min, b.min_open) {
        (m, _) if m == f64::NEG_INFINITY => None,
        (0.0, true) => Some("above 0".to_string()),
        (m, true) => Some(format!("above {}", n(m))),
        (0.0, false) => Some("0 or more".to_string()),
        (m, false) => Some(format!("at least {}", n(m))),
    };
    let high = (b.max != f64::INFINITY).then(|| n(b.max));
    match (low, high) {
        (None, None) => "finite".into(),
        (Some(l), None) => l,
        (None, Some(h)) => format!("at most {h}"),
        (Some(_), Some(h)) if !b.min_open && b.min != 0.0 => format!("between {} and {h}", n(b.min)),
        (Some(_), Some(h)) if !b.min_open => format!("between 0 and {h}"),
        (Some(l), Some(h)) => format!("{l} and at most {h}"),
    }
}

impl Context<'_> {
    pub fn error(&mut self, code: &'static str, span: Option<Span>, message: String, label: &str, help: impl Into<Option<String>>) {
        let mut d = Diagnostic::error(code, message).at(span);
        if !label.is_empty() {
            d = d.label(label);
        }
        d.help = help.into();
        self.out.push(d);
    }

    /// Place of a part of a quoted text: exact when the quotes hold it unescaped.
    fn inner(&self, node: &Node, e: &UnitError) -> Option<Span> {
        let span = node.span.clone()?;
        let inside = self.text.get(span.start + 1..span.end.saturating_sub(1));
        if e.range.is_empty() || inside.is_none() || inside != node.text() {
            return Some(span);
        }
        Some(span.start + 1 + e.range.start..span.start + 1 + e.range.end)
    }

    fn unit_error(&mut self, field: &str, node: &Node, e: UnitError) {
        let label = match e.code {
            "unit.unknown" => "unknown unit",
            "unit.missing" => "no unit",
            "unit.dimension" => "wrong dimension",
            "unit.angle" => "turns or radians?",
            "number.missing" => "no number",
            _ => "here",
        };
        let span = self.inner(node, &e);
        let message = format!("{}: {}", subject(self.who, field), e.message);
        self.error(e.code, span, message, label, e.help);
    }

    pub(super) fn wrong_type(&mut self, field: &str, node: &Node, wanted: &str, help: impl Into<Option<String>>) {
        let message = format!("{}: {wanted} is needed, not {}", subject(self.who, field), node.shape());
        self.error("value.type", node.span.clone(), message, node.shape(), help);
    }

    /// A number with a unit, in SI and inside its bounds.
    pub fn quantity(&mut self, field: &str, node: &Node, unit: &str, bounds: &Bounds) -> Option<f64> {
        let (x, bare) = match &node.data {
            Data::Text(t) => match units::read_quantity(t, unit) {
                Ok(x) => (x, false),
                Err(e) => {
                    self.unit_error(field, node, e);
                    return None;
                }
            },
            Data::Integer(i) => (*i as f64, true),
            Data::Float(x) => (*x, true),
            _ => {
                let example = units::examples(unit);
                self.wrong_type(
                    field,
                    node,
                    &units::describe(unit),
                    format!("write a number with a unit in quotes ({example}), or a bare number in SI units"),
                );
                return None;
            }
        };
        if !x.is_finite() {
            let message = format!("{}: a finite number is needed", subject(self.who, field));
            self.error("number.invalid", node.span.clone(), message, "not finite", None);
            return None;
        }
        if !bounds.contains(x) {
            let value = units::format_si(x, unit);
            let message = format!("{} is {value}; it must be {}", subject(self.who, field), bounds_text(bounds, unit));
            let share = unit.is_empty() && bounds.max == 1.0 && (2.0..=100.0).contains(&x);
            let help = share.then(|| format!("write \"{} %\" if you mean percent", units::write_number(x)));
            let help = help.or_else(|| {
                (bare && !unit.is_empty())
                    .then(|| format!("a bare number is in {unit}; put number and unit in quotes to use others ({})", units::examples(unit)))
            });
            self.error("value.bounds", node.span.clone(), message, "out of bounds", help);
            return None;
        }
        Some(x)
    }

    fn integer(&mut self, field: &str, node: &Node, min: i64, max: i64, auto: bool) -> Option<Value> {
        let or_auto = if auto { ", or \"auto\"" } else { "" };
        let wanted = format!("a whole number{or_auto}");
        match &node.data {
            Data::Integer(i) if (min..=max).contains(i) => Some(Value::Integer(*i)),
            Data::Integer(i) => {
                let message = format!("{} is {i}; it must be a whole number from {min} to {max}{or_auto}", subject(self.who, field));
                self.error("value.bounds", node.span.clone(), message, "out of bounds", None);
                None
            }
            Data::Text(t) if auto && t == "auto" => Some(Value::Auto),
            Data::Text(t) if t.trim().parse::<i64>().is_ok() => {
                self.wrong_type(field, node, &wanted, format!("write {} without quotes", t.trim()));
                None
            }
            Data::Text(t) if auto => {
                let message = format!("{}: {wanted} is needed, not {:?}", subject(self.who, field), clip(t));
                self.error("value.type", node.span.clone(), message, "not a whole number", None);
                None
            }
            Data::Float(x) if x.fract() == 0.0 && x.abs() < 1e15 => {
                self.wrong_type(field, node, &wanted, format!("write {} without a decimal point", *x as i64));
                None
            }
            Data::Float(_) => {
                let message = format!("{}: {wanted} is needed; this number has a fraction or is too large", subject(self.who, field));
                self.error("value.type", node.span.clone(), message, "not a whole number", None);
                None
            }
            _ => {
                self.wrong_type(field, node, &wanted, None);
                None
            }
        }
    }

    /// Reports keys of a small table that are not among `allowed`.
    pub(super) fn check_keys(&mut self, field: &str, table: &[Entry], allowed: &[&str]) -> bool {
        let mut fine = true;
        for e in table.iter().filter(|e| !allowed.contains(&e.key.as_ref())) {
            fine = false;
            let message = format!("{} has no {:?}", subject(self.who, field), clip(&e.key));
            let help = suggestion(&e.key, allowed.iter().copied(), "allowed here");
            self.error("key.unknown", e.span.clone(), message, "unknown key", help);
        }
        fine
    }

    fn attach(&mut self, field: &str, node: &Node, ground: bool) -> Option<Attach> {
        let body = |cx: &mut Self, n: &Node| -> Option<Option<String>> {
            let Some(t) = n.text() else {
                cx.wrong_type(field, n, "the name of a body", "write \"drum\", or { body = \"drum\", at = \"40 mm\" }".to_string());
                return None;
            };
            if t == "ground" && !ground {
                let message = format!("{} must be a body; the ground is not allowed here", subject(cx.who, field));
                cx.error("value.ground", n.span.clone(), message, "not a body", None);
                return None;
            }
            if t.is_empty() {
                cx.error("value.type", n.span.clone(), format!("{}: the name of a body is missing", subject(cx.who, field)), "empty", None);
                return None;
            }
            Some((t != "ground").then(|| t.to_string()))
        };
        let Data::Table(table) = &node.data else {
            return body(self, node).map(|body| Attach { body, position: 0.0 });
        };
        let fine = self.check_keys(field, table, &["body", "at"]);
        let Some(b) = get(table, "body") else {
            let message = format!("{} names no body", subject(self.who, field));
            self.error(
                "key.missing",
                node.span.clone(),
                message,
                "body = .. is missing",
                "write { body = \"drum\", at = \"40 mm\" }".to_string(),
            );
            return None;
        };
        let body = body(self, &b.node)?;
        let position = match get(table, "at") {
            None => 0.0,
            Some(e) if body.is_none() => {
                let message = format!("{}: the ground has no position", subject(self.who, field));
                self.error("value.ground", e.span.clone(), message, "leave this out", None);
                return None;
            }
            Some(e) => self.quantity(&format!("{field}.at"), &e.node, "m", &Bounds::within(1e4))?,
        };
        fine.then_some(Attach { body, position })
    }

    fn range(&mut self, field: &str, node: &Node, extra: &[&str], unit: Option<(&str, Bounds)>) -> Option<RangeValue> {
        let Some(table) = node.table() else {
            let example = format!(
                "write {{ from = .., to = .., points = .. }} with {}",
                unit.map_or("numbers".into(), |u| format!("values in {}", units::examples(u.0)))
            );
            self.wrong_type(field, node, "a range", example);
            return None;
        };
        let mut allowed = vec!["from", "to", "points"];
        allowed.extend(extra);
        let mut fine = self.check_keys(field, table, &allowed);
        let mut end = |cx: &mut Self, key: &str| {
            let Some(e) = get(table, key) else {
                let message = format!("{} has no {key:?}", subject(cx.who, field));
                cx.error(
                    "key.missing",
                    node.span.clone(),
                    message,
                    &format!("{key} = .. is missing"),
                    "a range is { from = .., to = .., points = .. }; points may be left out".to_string(),
                );
                fine = false;
                return None;
            };
            let name = format!("{field}.{key}");
            match unit {
                Some((u, b)) => cx.quantity(&name, &e.node, u, &b),
                None => cx.any_quantity(&name, &e.node).map(|q| q.0),
            }
        };
        let (from, to) = (end(self, "from"), end(self, "to"));
        let mut points = None;
        if let Some(e) = get(table, "points") {
            match self.integer(&format!("{field}.points"), &e.node, 2, MAX_POINTS, false) {
                Some(Value::Integer(n)) => points = Some(n as usize),
                _ => fine = false,
            }
        }
        let (from, to) = (from?, to?);
        if from == to {
            let message = format!("{} begins and ends at {}", subject(self.who, field), units::format_si(from, unit.map_or("", |u| u.0)));
            self.error("range.empty", node.span.clone(), message, "empty range", "from and to must differ".to_string());
            return None;
        }
        fine.then_some(RangeValue { from, to, points })
    }

    /// A quantity of unknown dimension: SI value and, unless it is a bare number, its SI unit.
    pub(super) fn any_quantity(&mut self, field: &str, node: &Node) -> Option<(f64, Option<String>)> {
        match &node.data {
            Data::Text(t) => match units::read_any(t) {
                Ok((x, u)) => Some((x, Some(u.dimension.si_text()))),
                Err(e) => {
                    self.unit_error(field, node, e);
                    None
                }
            },
            Data::Integer(i) => Some((*i as f64, None)),
            Data::Float(x) if x.is_finite() => Some((*x, None)),
            _ => {
                self.wrong_type(field, node, "a finite number with a unit", None);
                None
            }
        }
    }

    /// Whether a parameter path names a scalar of a part of this file; reports it when not. The inner `None`: the part has other
    /// mistakes, nothing can be said.
    #[allow(clippy::option_option)]
    pub(super) fn parameter(&mut self, field: &str, node: &Node, path: &str) -> Option<Option<(&'static str, Bounds)>> {
        let (block, rest) = path.split_once('.').unwrap_or((path, ""));
        let found = self.parts.iter().find(|p| p.0 == block).map(|p| p.1);
        let Some(kind) = found else {
            let message = format!("{} is {:?}, but no part is named {:?}", subject(self.who, field), clip(path), clip(block));
            let help = suggestion(block, self.parts.iter().map(|p| p.0.as_str()), "parts of this file");
            self.error("parameter.unknown", node.span.clone(), message, "no such part", help);
            return None;
        };
        let Some(info) = self.catalog.described(kind) else { return Some(None) };
        if let Some(p) = parameter_of(info, rest) {
            return Some(Some(p));
        }
        let message = if rest.is_empty() {
            format!("{} names the part {block:?} and none of its parameters", subject(self.who, field))
        } else {
            format!("{} is {:?}, but a {kind} has no parameter {:?}", subject(self.who, field), clip(path), clip(rest))
        };
        let help = suggestion(rest, parameters_of(info), &format!("parameters of a {kind}"));
        self.error("parameter.unknown", node.span.clone(), message, "no such parameter", help);
        None
    }

    pub(super) fn text_value(&mut self, field: &str, node: &Node, what: &str) -> Option<String> {
        match node.text() {
            Some(t) => Some(t.to_string()),
            None => {
                self.wrong_type(field, node, what, "put it in quotes".to_string());
                None
            }
        }
    }

    fn columns(&mut self, field: &str, node: &Node, declared: &[(&'static str, &'static str, bool, &'static str)]) -> Option<Value> {
        let Some(table) = node.table() else {
            let names: Vec<String> = declared.iter().map(|c| format!("{} = [..]", c.0)).collect();
            self.wrong_type(field, node, "a table of columns", format!("write {{ {} }}", names.join(", ")));
            return None;
        };
        let allowed: Vec<&str> = declared.iter().map(|c| c.0).collect();
        let mut fine = self.check_keys(field, table, &allowed);
        let mut out = BTreeMap::new();
        let mut length: Option<(&str, usize)> = None;
        for &(name, unit, required, doc) in declared {
            let Some(e) = get(table, name) else {
                if required {
                    let message = format!("{} has no column {name:?} ({doc})", subject(self.who, field));
                    self.error("key.missing", node.span.clone(), message, &format!("{name} = [..] is missing"), None);
                    fine = false;
                }
                continue;
            };
            let Some(column) = self.list(&format!("{field}.{name}"), &e.node, unit, &Bounds::within(f64::MAX)) else {
                fine = false;
                continue;
            };
            match length {
                Some((first, n)) if n != column.len() => {
                    let message = format!(
                        "{}: the columns differ in length: {first} has {n} values, {name} has {}",
                        subject(self.who, field),
                        column.len()
                    );
                    self.error("columns.length", e.node.span.clone(), message, "other length", None);
                    fine = false;
                }
                _ => length = length.or(Some((name, column.len()))),
            }
            out.insert(name, column);
        }
        if fine && out.is_empty() {
            let message = format!("{} has no columns", subject(self.who, field));
            self.error("key.missing", node.span.clone(), message, "empty", None);
            return None;
        }
        fine.then_some(Value::Columns(out))
    }

    fn list(&mut self, field: &str, node: &Node, unit: &str, bounds: &Bounds) -> Option<Vec<f64>> {
        let Data::List(list) = &node.data else {
            let help = match node.data {
                Data::Table(_) => None,
                _ => Some("put it in brackets, also when it is one value: [..]".to_string()),
            };
            self.wrong_type(field, node, "a list of numbers", help);
            return None;
        };
        if list.is_empty() {
            self.error("value.type", node.span.clone(), format!("{}: the list is empty", subject(self.who, field)), "empty", None);
            return None;
        }
        let read: Vec<Option<f64>> =
            list.iter().enumerate().map(|(i, n)| self.quantity(&format!("{field}[{}]", i + 1), n, unit, bounds)).collect();
        read.into_iter().collect()
    }

    /// Reads a field of any kind into `values`; false when it could not be.
    pub fn field(&mut self, f: &Field, node: &Node, values: &mut Values) -> bool {
        let mut given_units = None;
        let value = self.value(f, node, &mut given_units);
        if let (Some(_), Some(u)) = (&value, given_units) {
            values.set_units(f.name, u);
        }
        let fine = value.is_some();
        if let Some(v) = value {
            values.set(f.name, v, node.span.clone());
        }
        fine
    }

    fn value(&mut self, f: &Field, node: &Node, given_units: &mut Option<Vec<Option<String>>>) -> Option<Value> {
        let name = f.name;
        match f.kind {
            FieldKind::Quantity { unit, bounds } => self.quantity(name, node, unit, &bounds).map(Value::Number),
            FieldKind::Lateral { unit, bounds } => {
                let Some(table) = node.table() else {
                    return self.quantity(name, node, unit, &bounds).map(|x| Value::Lateral([x, x]));
                };
                let fine = self.check_keys(name, table, &["x", "y"]);
                let mut half = |key: &str| match get(table, key) {
                    Some(e) => self.quantity(&format!("{name}.{key}"), &e.node, unit, &bounds),
                    None => {
                        let message = format!("{} has no {key:?}", subject(self.who, name));
                        self.error(
                            "key.missing",
                            node.span.clone(),
                            message,
                            &format!("{key} = .. is missing"),
                            "write one value for both directions, or { x = .., y = .. }".to_string(),
                        );
                        None
                    }
                };
                let (x, y) = (half("x"), half("y"));
                if fine { Some(Value::Lateral([x?, y?])) } else { None }
            }
            FieldKind::OneOf(list) => {
                let names: Vec<&str> = list.iter().map(|o| o.0).collect();
                let how = format!("write exactly one of them: {{ {} = .. }}", names.join(" = .. } or { "));
                let Some(table) = node.table() else {
                    self.wrong_type(name, node, "one of several quantities", how);
                    return None;
                };
                if !self.check_keys(name, table, &names) {
                    return None;
                }
                let [e] = table else {
                    let found = if table.is_empty() {
                        "none".to_string()
                    } else {
                        table.iter().map(|e| e.key.as_ref()).collect::<Vec<_>>().join(", ")
                    };
                    let message = format!("{} wants exactly one of {}; {found} given", subject(self.who, name), names.join(", "));
                    self.error("value.one_of", node.span.clone(), message, "exactly one", None);
                    return None;
                };
                let o = list.iter().find(|o| o.0 == e.key)?;
                self.quantity(&format!("{name}.{}", o.0), &e.node, o.1, &o.2).map(|x| Value::OneOf(o.0, x))
            }
            FieldKind::Choice(words) => {
                let all = words.iter().map(|w| format!("{:?}", w.0)).collect::<Vec<_>>().join(", ");
                let Some(t) = node.text() else {
                    self.wrong_type(name, node, "a word", format!("write one of {all}"));
                    return None;
                };
                if let Some(w) = words.iter().find(|w| w.0 == t) {
                    return Some(Value::Choice(w.0));
                }
                let message = format!("{} cannot be {:?}", subject(self.who, name), clip(t));
                let mut help = nearest(t, words.iter().map(|w| w.0)).map(|w| format!("did you mean {w:?}? ")).unwrap_or_default();
                help += if help.is_empty() { "choose " } else { "Choose " };
                help += &words.iter().map(|w| format!("{:?} ({})", w.0, w.1)).collect::<Vec<_>>().join(", ");
                self.error("value.choice", node.span.clone(), message, "not one of its words", help);
                None
            }
            FieldKind::Integer { min, max } => self.integer(name, node, min, max, false),
            FieldKind::IntegerOrAuto { min, max } => self.integer(name, node, min, max, true),
            FieldKind::Flag => match &node.data {
                Data::Flag(b) => Some(Value::Flag(*b)),
                other => {
                    let help = match other {
                        Data::Text(t) if t == "true" || t == "false" => format!("write {t} without quotes"),
                        _ => "write true or false, without quotes".to_string(),
                    };
                    self.wrong_type(name, node, "true or false", help);
                    None
                }
            },
            FieldKind::Text => self.text_value(name, node, "a text").map(Value::Text),
            FieldKind::Coordinate => {
                let t = self.text_value(name, node, "the name of a coordinate")?;
                if t.trim().is_empty() {
                    let message = format!("{}: the name of a coordinate is missing", subject(self.who, name));
                    self.error("value.type", node.span.clone(), message, "empty", "write it as in \"drum.x\"".to_string());
                    return None;
                }
                Some(Value::Text(t))
            }
            FieldKind::Attach { ground } => self.attach(name, node, ground).map(Value::Attach),
            FieldKind::Between => {
                let help = "write between = [\"drum\", \"base\"]; one of the two may be \"ground\"".to_string();
                let Data::List(list) = &node.data else {
                    self.wrong_type(name, node, "a list of two points", help);
                    return None;
                };
                let [a, b] = list.as_slice() else {
                    let message = format!("{} must name two points; {} given", subject(self.who, name), list.len());
                    self.error("value.between", node.span.clone(), message, "two points", help);
                    return None;
                };
                let (a, b) = (self.attach(name, a, true), self.attach(name, b, true));
                let (a, b) = (a?, b?);
                if a == b {
                    let what = a.body.as_deref().unwrap_or("ground");
                    let message = format!("{} connects {what:?} with itself", subject(self.who, name));
                    self.error("value.between", node.span.clone(), message, "the same point twice", help);
                    return None;
                }
                Some(Value::Between(a, b))
            }
            FieldKind::Range { unit, bounds } => self.range(name, node, &[], Some((unit, bounds))).map(Value::Range),
            FieldKind::List { unit, bounds } => self.list(name, node, unit, &bounds).map(Value::List),
            FieldKind::ParameterPath => {
                let path = self.text_value(name, node, "the path of a parameter")?;
                self.parameter(name, node, &path).map(|_| Value::Text(path))
            }
            FieldKind::ParameterRange => {
                let help = "write { parameter = \"part.parameter\", from = .., to = .., points = .. }".to_string();
                let Some(table) = node.table() else {
                    self.wrong_type(name, node, "the range of a parameter", help);
                    return None;
                };
                let Some(e) = get(table, "parameter") else {
                    let message = format!("{} names no parameter", subject(self.who, name));
                    self.error("key.missing", node.span.clone(), message, "parameter = .. is missing", help);
                    return None;
                };
                let path = self.text_value(&format!("{name}.parameter"), &e.node, "the path of a parameter")?;
                let unit = self.parameter(name, &e.node, &path)?;
                self.range(name, node, &["parameter"], unit).map(|r| Value::ParameterRange(path, r))
            }
            FieldKind::Columns(declared) => self.columns(name, node, declared),
            FieldKind::Named { unit, bounds } => {
                let Some(table) = node.table() else {
                    return self.quantity(name, node, unit, &bounds).map(Value::Number);
                };
                let mut entries = Vec::new();
                let mut read = |key: &str, e: &Entry, cx: &mut Self| {
                    let x = cx.quantity(&format!("{name}, {}", clip(key)), &e.node, unit, &bounds);
                    entries.push(x.map(|x| (key.to_string(), x, e.span.clone().unwrap_or(0..0))));
                };
                for e in table {
                    // drum.mass = .. without quotes nests in TOML and means the same
                    match e.node.table() {
                        Some(inner) => inner.iter().for_each(|i| read(&format!("{}.{}", e.key, i.key), i, self)),
                        None => read(&e.key, e, self),
                    }
                }
                let entries: Vec<_> = entries.into_iter().collect::<Option<_>>()?;
                *given_units = Some(vec![Some(unit.to_string()); entries.len()]);
                Some(Value::StateMap(entries))
            }
            FieldKind::StateMap => {
                let Some(table) = node.table() else {
                    self.wrong_type(
                        name,
                        node,
                        "a table of initial values",
                        "write { \"drum.x\" = \"1 mm\", \"drum.x'\" = \"0.1 m/s\" }".to_string(),
                    );
                    return None;
                };
                let (mut out, mut unit_texts) = (Vec::new(), Vec::new());
                let mut fine = true;
                self.state_entries(name, "", table, &mut |key, span, q| match q {
                    Some((x, u)) => {
                        out.push((key, x, span.unwrap_or(0..0)));
                        unit_texts.push(u);
                    }
                    None => fine = false,
                });
                *given_units = Some(unit_texts);
                fine.then_some(Value::StateMap(out))
            }
            FieldKind::Study => self.inner_study(name, node).map(|s| Value::Study(Box::new(s))),
            FieldKind::Tolerances => self.tolerances(name, node).map(Value::Tolerances),
        }
    }

    /// Entries of a state map; `drum.x = ..` without quotes nests in TOML and means the same.
    #[allow(clippy::type_complexity)]
    fn state_entries(
        &mut self,
        name: &str,
        prefix: &str,
        table: &[Entry],
        put: &mut dyn FnMut(String, Option<Span>, Option<(f64, Option<String>)>),
    ) {
        for e in table {
            let key = if prefix.is_empty() { e.key.to_string() } else { format!("{prefix}.{}", e.key) };
            match e.node.table() {
                Some(inner) => self.state_entries(name, &key, inner, put),
                None => {
                    let q = self.any_quantity(&format!("{name}, {}", clip(&key)), &e.node);
                    put(key, e.span.clone(), q);
                }
            }
        }
    }
}

/// "did you mean ..?" and the list of what is allowed.
pub(super) fn suggestion<'a>(word: &str, allowed: impl IntoIterator<Item = &'a str>, what: &str) -> Option<String> {
    let allowed: Vec<&str> = allowed.into_iter().collect();
    let list = if allowed.is_empty() { None } else { Some(format!("{what}: {}", allowed.join(", "))) };
    match (nearest(word, allowed.iter().copied()), list) {
        (Some(n), Some(l)) => Some(format!("did you mean {n:?}? {}", capital(l))),
        (_, l) => l,
    }
}

fn capital(s: String) -> String {
    let mut c = s.chars();
    c.next().map(|f| f.to_uppercase().chain(c).collect()).unwrap_or_default()
}

/// The first characters of a word from the file, for messages.
pub(super) fn clip(s: &str) -> String {
    if s.chars().count() <= 40 { s.to_string() } else { s.chars().take(37).chain("...".chars()).collect() }
}
