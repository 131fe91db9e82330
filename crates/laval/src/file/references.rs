//! What refers to something else in the file: points of bodies, parameters, coordinates and their values.

use super::tree::{Data, Entry, Node, get};
use super::values::{Context, clip, subject, suggestion};
use super::{parameter_of, parameters_of};
use crate::diagnostic::{Diagnostic, Span};
use crate::model::field::{Attach, Bounds, Field, RangeValue, Value};
use crate::model::params::List;
use crate::text;

/// The SI unit in which each entry of a table of values was given; none for a bare number.
pub(super) type Units = Vec<Option<String>>;

/// A block is named like the fixed surroundings, which is said at its name.
fn named_ground(names: &[(String, &'static str)]) -> bool {
    names.iter().any(|n| n.0 == "ground")
}

impl Context<'_> {
    pub(super) fn attach(&mut self, field: &str, node: &Node, ground: bool) -> Option<Attach> {
        let body = |cx: &mut Self, n: &Node| -> Option<Option<String>> {
            let Some(t) = n.text() else {
                cx.wrong_type(field, n, text!("the name of a body"), text!("write \"drum\", or {{ body = \"drum\", at = \"40 mm\" }}"));
                return None;
            };
            if t == "ground" && named_ground(cx.parts) {
                // a block bears this name, which none may have: what is meant is open
                return None;
            }
            if t == "ground" && !ground {
                let message = text!("{who} must be a body; the ground is not allowed here", who = subject(cx.who, field));
                cx.error("value.ground", n.span.clone(), message, text!("not a body"), None);
                return None;
            }
            if t.is_empty() {
                cx.error(
                    "value.type",
                    n.span.clone(),
                    text!("{who}: the name of a body is missing", who = subject(cx.who, field)),
                    text!("empty"),
                    None,
                );
                return None;
            }
            Some((t != "ground").then(|| t.to_string()))
        };
        let Data::Table(table) = &node.data else {
            return body(self, node).map(|body| Attach { body, position: 0.0 });
        };
        let fine = self.check_keys(field, table, &["body", "at"]);
        let Some(b) = get(table, "body") else {
            let message = text!("{who} names no body", who = subject(self.who, field));
            self.error(
                "key.missing",
                node.span.clone(),
                message,
                text!("body = .. is missing"),
                text!("write {{ body = \"drum\", at = \"40 mm\" }}"),
            );
            return None;
        };
        let body = body(self, &b.node)?;
        let position = match get(table, "at") {
            None => 0.0,
            Some(e) if body.is_none() => {
                let message = text!("{who}: the ground has no position", who = subject(self.who, field));
                self.error("value.ground", e.span.clone(), message, text!("leave this out"), None);
                return None;
            }
            Some(e) => self.quantity(&format!("{field}.at"), &e.node, "m", &Bounds::within(1e4))?,
        };
        fine.then_some(Attach { body, position })
    }

    /// Two points of bodies.
    pub(super) fn between(&mut self, name: &str, node: &Node) -> Option<Value> {
        let help = text!("write between = [\"drum\", \"base\"]; one of the two may be \"ground\"");
        let Data::List(list) = &node.data else {
            self.wrong_type(name, node, text!("a list of two points"), help);
            return None;
        };
        let [a, b] = list.as_slice() else {
            let message = text!("{who} must name two points; {given} given", who = subject(self.who, name), given = list.len());
            self.error("value.between", node.span.clone(), message, text!("two points"), help);
            return None;
        };
        let (a, b) = (self.attach(name, a, true), self.attach(name, b, true));
        let (a, b) = (a?, b?);
        if a == b {
            let what = a.body.as_deref().unwrap_or("ground");
            let message = text!("{who} connects {what} with itself", who = subject(self.who, name), what = text::quoted(&what));
            self.error("value.between", node.span.clone(), message, text!("the same point twice"), help);
            return None;
        }
        Some(Value::Between(a, b))
    }

    /// Whether a parameter path names a scalar of a part of this file; reports it when not. The inner `None`: the part has other
    /// mistakes, nothing can be said.
    #[allow(clippy::option_option)]
    pub(super) fn parameter(&mut self, field: &str, node: &Node, path: &str) -> Option<Option<(&'static str, Bounds)>> {
        let (block, rest) = path.split_once('.').unwrap_or((path, ""));
        let found = self.parts.iter().find(|p| p.0 == block).map(|p| p.1);
        let names = || self.parts.iter().map(|p| p.0.as_str());
        let Some(kind) = found else {
            let message = text!(
                "{who} is {path}, but no part is named {block}",
                who = subject(self.who, field),
                path = text::quoted(&clip(path)),
                block = text::quoted(&clip(block))
            );
            let help = suggestion(block, names(), |all| text!("parts of this file: {all}", all));
            let d = Diagnostic::error("parameter.unknown", message).at(node.span.clone()).label(text!("no such part")).about(path);
            self.out.push(Diagnostic { help: help.map(Box::new), ..d });
            return None;
        };
        let Some(info) = self.catalog.described(kind) else { return Some(None) };
        if let Some(p) = parameter_of(info, rest) {
            return Some(Some(p));
        }
        let of_parameters = Field::list_of(&info.fields, rest).and_then(|f| info.lists.iter().find(|l| l.name == f.name));
        // a row that has a number, and another mistake
        let numbered = |list: &List| {
            let number = rest.strip_prefix(list.name).and_then(|r| r.strip_prefix('[')?.split_once(']'));
            number.is_some_and(|n| n.0.parse::<usize>().is_ok_and(|n| n > 0))
        };
        if let Some(list) = of_parameters.filter(|l| !numbered(l)) {
            let message = text!(
                "{who} is {path}, but \"{name}\" is a list, whose rows are numbered from 1",
                who = subject(self.who, field),
                path = text::quoted(&clip(path)),
                name = list.name
            );
            let help = text!("parameters of a {kind}: {all}", kind, all = parameters_of(info).join(", "));
            self.error("parameter.unknown", node.span.clone(), message, text!("a list, no parameter"), help);
            return None;
        }
        if let Some(list) = Field::list_of(&info.fields, rest).filter(|_| of_parameters.is_none()) {
            let message = text!(
                "{who} is {path}, but \"{name}\" is a list: studies hold its values",
                who = subject(self.who, field),
                path = text::quoted(&clip(path)),
                name = list.name
            );
            let help = text!("studies vary single numbers; parameters of a {kind}: {all}", kind, all = parameters_of(info).join(", "));
            self.error("parameter.unknown", node.span.clone(), message, text!("a list, no parameter"), help);
            return None;
        }
        let message = if rest.is_empty() {
            text!("{who} names the part {block} and none of its parameters", who = subject(self.who, field), block = text::quoted(&block))
        } else {
            text!(
                "{who} is {path}, but a {kind} has no parameter {rest}",
                who = subject(self.who, field),
                path = text::quoted(&clip(path)),
                kind,
                rest = text::quoted(&clip(rest))
            )
        };
        let help =
            suggestion(rest, parameters_of(info).iter().map(String::as_str), |all| text!("parameters of a {kind}: {all}", kind, all));
        self.error("parameter.unknown", node.span.clone(), message, text!("no such parameter"), help);
        None
    }

    /// The range of one parameter.
    pub(super) fn parameter_range(&mut self, name: &str, node: &Node) -> Option<Value> {
        let help = text!("write {{ parameter = \"part.parameter\", from = .., to = .., points = .. }}");
        let Some(table) = node.table() else {
            self.wrong_type(name, node, text!("the range of a parameter"), help);
            return None;
        };
        let Some(e) = get(table, "parameter") else {
            let message = text!("{who} names no parameter", who = subject(self.who, name));
            self.error("key.missing", node.span.clone(), message, text!("parameter = .. is missing"), help);
            return None;
        };
        let path = self.text_value(&format!("{name}.parameter"), &e.node, text!("the path of a parameter"))?;
        let unit = self.parameter(name, &e.node, &path)?;
        self.range(name, node, &["parameter"], unit).map(|r| Value::ParameterRange(path, r))
    }

    /// Ranges of several parameters, each named once.
    pub(super) fn parameter_ranges(&mut self, name: &str, node: &Node) -> Option<Value> {
        let help = text!("write [{{ parameter = \"part.parameter\", from = .., to = .. }}]");
        let list = match &node.data {
            Data::List(list) if !list.is_empty() => list,
            _ => {
                self.wrong_type(name, node, text!("a list of ranges of parameters"), help);
                return None;
            }
        };
        let mut fine = true;
        let mut out: Vec<(String, RangeValue, Option<Span>)> = Vec::new();
        for (i, n) in list.iter().enumerate() {
            match self.parameter_range(&format!("{name}[{}]", i + 1), n) {
                Some(Value::ParameterRange(path, _)) if out.iter().any(|o| o.0 == path) => {
                    let message = text!("{who} names {path} twice", who = subject(self.who, name), path = text::quoted(&path));
                    self.error("parameter.twice", n.span.clone(), message, text!("named above"), None);
                    fine = false;
                }
                Some(Value::ParameterRange(path, r)) => out.push((path, r, n.span.clone())),
                _ => fine = false,
            }
        }
        fine.then_some(Value::ParameterRanges(out))
    }

    /// The name of a coordinate.
    pub(super) fn coordinate(&mut self, name: &str, node: &Node) -> Option<Value> {
        let t = self.text_value(name, node, text!("the name of a coordinate"))?;
        if t.trim().is_empty() {
            let message = text!("{who}: the name of a coordinate is missing", who = subject(self.who, name));
            self.error("value.type", node.span.clone(), message, text!("empty"), text!("write it as in \"drum.x\""));
            return None;
        }
        Some(Value::Text(t))
    }

    /// One quantity for all, or one for each of some names.
    pub(super) fn named(&mut self, name: &str, node: &Node, unit: &str, bounds: &Bounds, given_units: &mut Option<Units>) -> Option<Value> {
        let Some(table) = node.table() else {
            return self.quantity(name, node, unit, bounds).map(Value::Number);
        };
        let mut entries = Vec::new();
        let mut read = |key: &str, e: &Entry, cx: &mut Self| {
            let x = cx.quantity(&format!("{name}, {}", clip(key)), &e.node, unit, bounds);
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

    /// Initial values by coordinate or rate.
    pub(super) fn state_map(&mut self, name: &str, node: &Node, given_units: &mut Option<Units>) -> Option<Value> {
        let Some(table) = node.table() else {
            self.wrong_type(
                name,
                node,
                text!("a table of initial values"),
                text!("write {{ \"drum.x\" = \"1 mm\", \"drum.x'\" = \"0.1 m/s\" }}"),
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
