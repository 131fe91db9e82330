//! Every kind of field, read from a tree into SI units and checked.

use super::Catalog;
use super::references::Units;
use super::tree::{Data, Entry, Node};
use crate::diagnostic::{Diagnostic, Diagnostics, Span, meant, nearest};
use crate::model::field::{Field, FieldKind, KindInfo, Value, Values, Word};
use crate::text;
use crate::text::{Argument, Joint, Text};
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

/// A field of a block: `disc "drum": mass`.
pub(super) fn subject(who: &str, field: &str) -> String {
    if field.is_empty() { who.to_string() } else { format!("{who}: {field}") }
}

impl Context<'_> {
    pub fn error(&mut self, code: &'static str, span: Option<Span>, message: Text, label: Text, help: impl Into<Option<Text>>) {
        let mut d = Diagnostic::error(code, message).at(span).label(label);
        d.help = help.into().map(Box::new);
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
            "unit.unknown" => text!("unknown unit"),
            "unit.missing" => text!("no unit"),
            "unit.dimension" => text!("wrong dimension"),
            "unit.angle" => text!("turns or radians?"),
            "number.missing" => text!("no number"),
            _ => text!("here"),
        };
        let span = self.inner(node, &e);
        let message = text!("{who}: {message}", who = subject(self.who, field), message = e.message);
        let known = || {
            let unit = wanted.filter(|_| e.code == "unit.unknown")?;
            Some(if unit.is_empty() {
                text!("a pure number has none")
            } else {
                text!("{quantity} is given in {examples}", quantity = describe(unit), examples = examples(unit))
            })
        };
        let help = e.help.clone().or_else(known);
        self.error(e.code, span, message, label, help);
    }

    pub(super) fn wrong_type(&mut self, field: &str, node: &Node, wanted: impl Argument, help: impl Into<Option<Text>>) {
        let message = text!("{who}: {wanted} is needed, not {shape}", who = subject(self.who, field), wanted, shape = node.shape());
        self.error("value.type", node.span.clone(), message, node.shape(), help);
    }

    /// Reports keys of a small table that are not among `allowed`.
    pub(super) fn check_keys(&mut self, field: &str, table: &[Entry], allowed: &[&str]) -> bool {
        let mut fine = true;
        for e in table.iter().filter(|e| !allowed.contains(&e.key.as_ref())) {
            fine = false;
            let message = text!("{who} has no {key}", who = subject(self.who, field), key = text::quoted(&clip(&e.key)));
            let help = suggestion(&e.key, allowed.iter().copied(), |all| text!("allowed here: {all}", all));
            self.error("key.unknown", e.span.clone(), message, text!("unknown key"), help);
        }
        fine
    }

    pub(super) fn text_value(&mut self, field: &str, node: &Node, what: Text) -> Option<String> {
        match node.text() {
            Some(t) => Some(t.to_string()),
            None => {
                self.wrong_type(field, node, what, text!("put it in quotes"));
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
            FieldKind::Text => self.text_value(name, node, text!("a text")).map(Value::Text),
            FieldKind::Coordinate => self.coordinate(name, node),
            FieldKind::Attach { ground } => self.attach(name, node, ground).map(Value::Attach),
            FieldKind::Between => self.between(name, node),
            FieldKind::Range { unit, bounds } => self.range(name, node, &[], Some((unit, bounds))).map(Value::Range),
            FieldKind::List { unit, bounds } => self.list(name, node, unit, &bounds).map(Value::List),
            FieldKind::ParameterPath => {
                let path = self.text_value(name, node, text!("the path of a parameter"))?;
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
            self.wrong_type(name, node, text!("a word"), text!("write one of {all}", all));
            return None;
        };
        if let Some(w) = words.iter().find(|w| w.0 == t) {
            return Some(Value::Choice(w.0));
        }
        let message = text!("{who} cannot be {t}", who = subject(self.who, name), t = text::quoted(&clip(t)));
        let word = |w: &Word| text!("{word} ({meaning})", word = text::quoted(&w.0), meaning = text::term(w.1));
        let all = text::list(words.iter().map(word), Joint::Comma);
        let help = match nearest(t, words.iter().map(|w| w.0)) {
            Some(near) => text!("did you mean {near}? Choose {all}", near = text::quoted(&near), all),
            None => text!("choose {all}", all),
        };
        self.error("value.choice", node.span.clone(), message, text!("not one of its words"), help);
        None
    }

    fn flag(&mut self, name: &str, node: &Node) -> Option<Value> {
        match &node.data {
            Data::Flag(b) => Some(Value::Flag(*b)),
            other => {
                let help = match other {
                    Data::Text(t) if t == "true" || t == "false" => text!("write {t} without quotes", t),
                    _ => text!("write true or false, without quotes"),
                };
                self.wrong_type(name, node, text!("true or false"), help);
                None
            }
        }
    }
}

/// "did you mean ..?" and the list of what is allowed, as `listed` says it.
pub(super) fn suggestion<'a>(word: &str, allowed: impl IntoIterator<Item = &'a str>, listed: impl Fn(String) -> Text) -> Option<Text> {
    let allowed: Vec<&str> = allowed.into_iter().collect();
    if allowed.is_empty() {
        return None;
    }
    let list = listed(allowed.join(", "));
    Some(match nearest(word, allowed.iter().copied()) {
        Some(near) => meant(text::quoted(&near), list),
        None => list,
    })
}

/// The first characters of a word from the file, for messages.
pub(super) fn clip(s: &str) -> String {
    if s.chars().count() <= 40 { s.to_string() } else { s.chars().take(37).chain("...".chars()).collect() }
}
