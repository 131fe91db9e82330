//! Numbers with units: one, two, a range, a list, columns.

use super::tree::{Data, Node, get};
use super::values::{Context, clip, subject};
use crate::diagnostic::nearest;
use crate::model::field::{Bounds, MOST_POINTS, RangeValue, Value};
use crate::text;
use crate::units;
use std::collections::BTreeMap;

type Alternative = (&'static str, &'static str, Bounds, &'static str);
type Column = (&'static str, &'static str, bool, &'static str);

impl Context<'_> {
    /// A number with a unit, in SI and inside its bounds.
    pub(super) fn quantity(&mut self, field: &str, node: &Node, unit: &str, bounds: &Bounds) -> Option<f64> {
        let (x, bare) = match &node.data {
            Data::Text(t) => match units::read_quantity(t, unit) {
                Ok(x) => (x, t.trim().parse::<f64>().is_ok()),
                Err(e) => {
                    self.unit_error(field, node, e, Some(unit));
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
                    units::describe(unit),
                    text!("write a number with a unit in quotes ({example}), or a bare number in SI units", example),
                );
                return None;
            }
        };
        if !x.is_finite() {
            let message = text!("{who}: a finite number is needed", who = subject(self.who, field));
            self.error("number.invalid", node.span.clone(), message, text!("not finite"), None);
            return None;
        }
        if !bounds.contains(x) {
            let value = text::quantity(x, unit.to_string());
            let message = text!("{who} is {value}; it must be {bounds}", who = subject(self.who, field), value, bounds = bounds.text(unit));
            let share = bare && unit.is_empty() && bounds.max == 1.0 && (2.0..=100.0).contains(&x);
            let help = share.then(|| text!("write \"{x} %\" if you mean percent", x = units::write_number(x)));
            let help = help.or_else(|| (!bare).then(|| text!("give a value {bounds}", bounds = bounds.text(unit))));
            let help = help.or_else(|| {
                (bare && !unit.is_empty()).then(|| {
                    text!(
                        "a bare number is in {unit}; put number and unit in quotes to use others ({examples})",
                        unit,
                        examples = units::examples(unit)
                    )
                })
            });
            self.error("value.bounds", node.span.clone(), message, text!("out of bounds"), help);
            return None;
        }
        Some(x)
    }

    pub(super) fn integer(&mut self, field: &str, node: &Node, min: i64, max: i64, auto: bool) -> Option<Value> {
        let wanted = if auto { text!("a whole number, or \"auto\"") } else { text!("a whole number") };
        match &node.data {
            Data::Integer(i) if (min..=max).contains(i) => Some(Value::Integer(*i)),
            Data::Integer(i) => {
                let who = subject(self.who, field);
                let message = match auto {
                    true => text!("{who} is {i}; it must be a whole number from {min} to {max}, or \"auto\"", who, i, min, max),
                    false => text!("{who} is {i}; it must be a whole number from {min} to {max}", who, i, min, max),
                };
                self.error("value.bounds", node.span.clone(), message, text!("out of bounds"), None);
                None
            }
            Data::Text(t) if auto && t == "auto" => Some(Value::Auto),
            Data::Text(t) if t.trim().parse::<i64>().is_ok() => {
                self.wrong_type(field, node, &wanted, text!("write {t} without quotes", t = t.trim()));
                None
            }
            Data::Text(t) if auto => {
                let message =
                    text!("{who}: {wanted} is needed, not {t}", who = subject(self.who, field), wanted, t = text::quoted(&clip(t)));
                self.error("value.type", node.span.clone(), message, text!("not a whole number"), None);
                None
            }
            Data::Float(x) if x.fract() == 0.0 && x.abs() < 1e15 => {
                self.wrong_type(field, node, &wanted, text!("write {number}", number = *x as i64));
                None
            }
            Data::Float(_) => {
                let message =
                    text!("{who}: {wanted} is needed; this number has a fraction or is too large", who = subject(self.who, field), wanted);
                self.error("value.type", node.span.clone(), message, text!("not a whole number"), None);
                None
            }
            _ => {
                self.wrong_type(field, node, &wanted, None);
                None
            }
        }
    }

    /// One number for both directions, or one for each.
    pub(super) fn lateral(&mut self, name: &str, node: &Node, unit: &str, bounds: &Bounds) -> Option<Value> {
        let Some(table) = node.table() else {
            return self.quantity(name, node, unit, bounds).map(|x| Value::Lateral([x, x]));
        };
        let fine = self.check_keys(name, table, &["x", "y"]);
        let mut half = |key: &str| match get(table, key) {
            Some(e) => self.quantity(&format!("{name}.{key}"), &e.node, unit, bounds),
            None => {
                let message = text!("{who} has no {key}", who = subject(self.who, name), key = text::quoted(&key));
                self.error(
                    "key.missing",
                    node.span.clone(),
                    message,
                    text!("{key} = .. is missing", key),
                    text!("write one value for both directions, or {{ x = .., y = .. }}"),
                );
                None
            }
        };
        let (x, y) = (half("x"), half("y"));
        if fine { Some(Value::Lateral([x?, y?])) } else { None }
    }

    /// Exactly one of several quantities.
    pub(super) fn one_of(&mut self, name: &str, node: &Node, list: &[Alternative]) -> Option<Value> {
        let names: Vec<&str> = list.iter().map(|o| o.0).collect();
        let how = text!("write exactly one of them: {{ {names} = .. }}", names = names.join(" = .. } or { "));
        let Some(table) = node.table() else {
            self.wrong_type(name, node, text!("one of several quantities"), how);
            return None;
        };
        if !self.check_keys(name, table, &names) {
            return None;
        }
        let [e] = table else {
            let (who, names) = (subject(self.who, name), names.join(", "));
            let message = match table {
                [] => text!("{who} wants exactly one of {names}; none given", who, names),
                _ => {
                    let found = table.iter().map(|e| e.key.as_ref()).collect::<Vec<_>>().join(", ");
                    text!("{who} wants exactly one of {names}; {found} given", who, names, found)
                }
            };
            self.error("value.one_of", node.span.clone(), message, text!("exactly one"), None);
            return None;
        };
        let o = list.iter().find(|o| o.0 == e.key)?;
        self.quantity(&format!("{name}.{}", o.0), &e.node, o.1, &o.2).map(|x| Value::OneOf(o.0, x))
    }

    pub(super) fn range(&mut self, field: &str, node: &Node, extra: &[&str], unit: Option<(&str, Bounds)>) -> Option<RangeValue> {
        let single = unit.filter(|_| extra.is_empty());
        if let (Some((u, b)), Data::Text(_) | Data::Integer(_) | Data::Float(_)) = (single, &node.data) {
            return self.quantity(field, node, u, &b).map(|x| RangeValue { from: x, to: x, points: None });
        }
        let Some(table) = node.table() else {
            let example = match unit {
                Some((u, _)) => {
                    let examples = units::examples(u);
                    text!("write one value, or {{ from = .., to = .., points = .. }}, with values in {examples}", examples)
                }
                None => text!("write one value, or {{ from = .., to = .., points = .. }}, with numbers"),
            };
            self.wrong_type(field, node, text!("a range"), example);
            return None;
        };
        let mut allowed = vec!["from", "to", "points"];
        allowed.extend(extra);
        let mut fine = self.check_keys(field, table, &allowed);
        let mut end = |cx: &mut Self, key: &str| {
            let Some(e) = get(table, key) else {
                let message = text!("{who} has no {key}", who = subject(cx.who, field), key = text::quoted(&key));
                cx.error(
                    "key.missing",
                    node.span.clone(),
                    message,
                    text!("{key} = .. is missing", key),
                    text!("a range is {{ from = .., to = .., points = .. }}; points may be left out"),
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
            match self.integer(&format!("{field}.points"), &e.node, 2, MOST_POINTS as i64, false) {
                Some(Value::Integer(n)) => points = Some(n as usize),
                _ => fine = false,
            }
        }
        let (from, to) = (from?, to?);
        if from == to && single.is_some() {
            return fine.then_some(RangeValue { from, to, points: None });
        }
        if from == to {
            let message = text!(
                "{who} begins and ends at {from}",
                who = subject(self.who, field),
                from = text::quantity(from, unit.map_or("", |u| u.0).to_string())
            );
            self.error("range.empty", node.span.clone(), message, text!("empty range"), text!("from and to must differ"));
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
                    self.unit_error(field, node, e, None);
                    None
                }
            },
            Data::Integer(i) => Some((*i as f64, None)),
            Data::Float(x) if x.is_finite() => Some((*x, None)),
            _ => {
                self.wrong_type(field, node, text!("a finite number with a unit"), None);
                None
            }
        }
    }

    pub(super) fn columns(&mut self, field: &str, node: &Node, declared: &[Column]) -> Option<Value> {
        if let Data::List(rows) = &node.data
            && !rows.is_empty()
            && rows.iter().all(|r| r.table().is_some())
        {
            return self.rows(field, node, rows, declared);
        }
        let Some(table) = node.table() else {
            let names: Vec<String> = declared.iter().map(|c| format!("{} = [..]", c.0)).collect();
            self.wrong_type(field, node, text!("a table of columns"), text!("write {{ {names} }}", names = names.join(", ")));
            return None;
        };
        let allowed: Vec<&str> = declared.iter().map(|c| c.0).collect();
        let mut fine = self.check_keys(field, table, &allowed);
        let mut out = BTreeMap::new();
        let mut length: Option<(&str, usize)> = None;
        for &(name, unit, required, doc) in declared {
            let Some(e) = get(table, name) else {
                if required {
                    let message = text!(
                        "{who} has no column {name} ({doc})",
                        who = subject(self.who, field),
                        name = text::quoted(&name),
                        doc = text::term(doc)
                    );
                    self.error("key.missing", node.span.clone(), message, text!("{name} = [..] is missing", name), None);
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
                    let message = text!(
                        "{who}: the columns differ in length: {first} has {n} values, {name} has {column}",
                        who = subject(self.who, field),
                        first,
                        n,
                        name,
                        column = column.len()
                    );
                    self.error("columns.length", e.node.span.clone(), message, text!("other length"), None);
                    fine = false;
                }
                _ => length = length.or(Some((name, column.len()))),
            }
            out.insert(name, column);
        }
        if fine && out.is_empty() {
            let message = text!("{who} has no columns", who = subject(self.who, field));
            self.error("key.missing", node.span.clone(), message, text!("empty"), None);
            return None;
        }
        fine.then_some(Value::Columns(out))
    }

    /// The same columns written row by row, as `[{ length = "1 m", diameter = "50 mm" }, ..]`: what a row leaves out is 0.
    fn rows(&mut self, field: &str, node: &Node, rows: &[Node], declared: &[Column]) -> Option<Value> {
        let allowed: Vec<&str> = declared.iter().map(|c| c.0).collect();
        let mut fine = true;
        for table in rows.iter().filter_map(Node::table) {
            fine &= self.check_keys(field, table, &allowed);
        }
        let mut out = BTreeMap::new();
        for &(name, unit, required, doc) in declared {
            let cells: Vec<Option<&Node>> = rows.iter().map(|r| Some(&get(r.table()?, name)?.node)).collect();
            if !required && cells.iter().all(Option::is_none) {
                continue;
            }
            let mut column = Vec::new();
            for (k, cell) in cells.iter().enumerate() {
                let Some(cell) = cell else {
                    if !required {
                        column.push(0.0);
                        continue;
                    }
                    fine = false;
                    // a misspelt column is reported already, and this one proposed
                    let table = rows[k].table().unwrap_or_default();
                    if table.iter().any(|e| !allowed.contains(&&*e.key) && nearest(&e.key, allowed.iter().copied()) == Some(name)) {
                        continue;
                    }
                    let message = text!(
                        "{who}, row {row}, has no {name} ({doc})",
                        who = subject(self.who, field),
                        row = k + 1,
                        name = text::quoted(&name),
                        doc = text::term(doc)
                    );
                    self.error("key.missing", rows[k].span.clone(), message, text!("{name} is missing", name), None);
                    continue;
                };
                match self.quantity(&format!("{field}.{name}"), cell, unit, &Bounds::within(f64::MAX)) {
                    Some(x) => column.push(x),
                    None => fine = false,
                }
            }
            out.insert(name, column);
        }
        if fine && out.is_empty() {
            let message = text!("{who} has no columns", who = subject(self.who, field));
            self.error("key.missing", node.span.clone(), message, text!("empty"), None);
            return None;
        }
        fine.then_some(Value::Columns(out))
    }

    pub(super) fn list(&mut self, field: &str, node: &Node, unit: &str, bounds: &Bounds) -> Option<Vec<f64>> {
        let Data::List(list) = &node.data else {
            let help = match node.data {
                Data::Table(_) => None,
                _ => Some(text!("put it in brackets, also when it is one value: [..]")),
            };
            self.wrong_type(field, node, text!("a list of numbers"), help);
            return None;
        };
        if list.is_empty() {
            self.error(
                "value.type",
                node.span.clone(),
                text!("{who}: the list is empty", who = subject(self.who, field)),
                text!("empty"),
                None,
            );
            return None;
        }
        let read: Vec<Option<f64>> =
            list.iter().enumerate().map(|(i, n)| self.quantity(&format!("{field}[{}]", i + 1), n, unit, bounds)).collect();
        read.into_iter().collect()
    }
}
