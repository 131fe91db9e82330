//! Every kind of field, read from a tree into SI units and checked.

use super::Catalog;
use super::references::Units;
use super::tree::{Data, Entry, Node};
use crate::diagnostic::{Diagnostic, Diagnostics, Span, nearest};
use crate::model::field::{Field, FieldKind, KindInfo, Value, Values, Word};
use crate::units::{UnitError, describe, examples};

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

impl Context<'_> {
    pub fn error(&mut self, code: &'static str, span: Option<Span>, message: String, label: &str, help: impl Into<Option<String>>) {
        let mut d = Diagnostic::error(code, message).at(span);
        if !label.is_empty() {
            d = d.label(label);
        }
        d.help = help.into().map(Into::into);
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

    /// Says what is wrong with a quantity, wanted in a unit or in any.
    pub(super) fn unit_error(&mut self, field: &str, node: &Node, e: UnitError, wanted: Option<&str>) {
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
        let known = || {
            let unit = wanted.filter(|_| e.code == "unit.unknown")?;
            Some(if unit.is_empty() {
                "a pure number has none".to_string()
            } else {
                format!("{} is given in {}", describe(unit), examples(unit))
            })
        };
        let help = e.help.clone().or_else(known);
        self.error(e.code, span, message, label, help);
    }

    pub(super) fn wrong_type(&mut self, field: &str, node: &Node, wanted: &str, help: impl Into<Option<String>>) {
        let message = format!("{}: {wanted} is needed, not {}", subject(self.who, field), node.shape());
        self.error("value.type", node.span.clone(), message, node.shape(), help);
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

    pub(super) fn text_value(&mut self, field: &str, node: &Node, what: &str) -> Option<String> {
        match node.text() {
            Some(t) => Some(t.to_string()),
            None => {
                self.wrong_type(field, node, what, "put it in quotes".to_string());
                None
            }
        }
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

    fn value(&mut self, f: &Field, node: &Node, given_units: &mut Option<Units>) -> Option<Value> {
        let name = f.name;
        match f.kind {
            FieldKind::Quantity { unit, bounds } => self.quantity(name, node, unit, &bounds).map(Value::Number),
            FieldKind::Lateral { unit, bounds } => self.lateral(name, node, unit, &bounds),
            FieldKind::OneOf(list) => self.one_of(name, node, list),
            FieldKind::Choice(words) => self.choice(name, node, words),
            FieldKind::Integer { min, max } => self.integer(name, node, min, max, false),
            FieldKind::IntegerOrAuto { min, max } => self.integer(name, node, min, max, true),
            FieldKind::Flag => self.flag(name, node),
            FieldKind::Text => self.text_value(name, node, "a text").map(Value::Text),
            FieldKind::Coordinate => self.coordinate(name, node),
            FieldKind::Attach { ground } => self.attach(name, node, ground).map(Value::Attach),
            FieldKind::Between => self.between(name, node),
            FieldKind::Range { unit, bounds } => self.range(name, node, &[], Some((unit, bounds))).map(Value::Range),
            FieldKind::List { unit, bounds } => self.list(name, node, unit, &bounds).map(Value::List),
            FieldKind::ParameterPath => {
                let path = self.text_value(name, node, "the path of a parameter")?;
                self.parameter(name, node, &path).map(|_| Value::Text(path))
            }
            FieldKind::ParameterRange => self.parameter_range(name, node),
            FieldKind::ParameterRanges => self.parameter_ranges(name, node),
            FieldKind::Columns(declared) => self.columns(name, node, declared),
            FieldKind::Named { unit, bounds } => self.named(name, node, unit, &bounds, given_units),
            FieldKind::StateMap => self.state_map(name, node, given_units),
            FieldKind::Study => self.inner_study(name, node).map(|s| Value::Study(Box::new(s))),
            FieldKind::Tolerances => self.tolerances(name, node).map(Value::Tolerances),
        }
    }

    fn choice(&mut self, name: &str, node: &Node, words: &[Word]) -> Option<Value> {
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

    fn flag(&mut self, name: &str, node: &Node) -> Option<Value> {
        match &node.data {
            Data::Flag(b) => Some(Value::Flag(*b)),
            other => {
                let help = match other {
                    Data::Text(t) if t == "true" || t == "false" => format!("write {t} without quotes"),
                    _ => "write true or false, without quotes".to_string(),
                };
                self.wrong_type(name, node, "true or false", help);
                None
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
