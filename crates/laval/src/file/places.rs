//! The numbers of a machine file by path, with the place where each is written.
//!
//! Paths are those of the parameters of the machine (`drum.mass`, `bearing.stiffness.x`, `shaft.section[3].outer_diameter`), and beside them numbers that are no parameters
//! of an assembled machine: `machine.speed`, positions of attachments (`bearing.between[1].at`, `disc.on.at`) and ends of ranges (`operation.speed.from`).

use super::tree::{Data, Entry, Node, from_table, get, too_deep};
use super::{Block, Catalog, MACHINE_FIELDS, Spec};
use crate::diagnostic::Span;
use crate::model::field::{Attach, Bounds, Field, FieldKind, KindInfo, Value};
use toml::de::DeTable;

/// A number of a machine file.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Its path.
    pub path: String,
    /// SI unit.
    pub unit: &'static str,
    /// Admissible interval.
    pub bounds: Bounds,
    /// Its meaning.
    pub doc: &'static str,
    /// Value, SI; NaN of a quantity that the file gives by another one, as a fill by its volume.
    pub value: f64,
    /// Where the value is written, with its quotation marks; none where it stands by default.
    pub span: Option<Span>,
    /// Of the position of an attachment: the body that it is on.
    pub on: Option<String>,
    pub(super) home: Home,
}

/// Where a number that is not written as such would be written.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Home {
    /// It is written.
    Written,
    /// A key of the block whose keys are these: where a line follows, or an entry of an inline table.
    Key(Room, String),
    /// One half of a pair that is written as one number.
    Half(Span, &'static str),
    /// Both halves of a pair.
    Both([Span; 2]),
    /// A table that gives another quantity in place of this one.
    Other(Span, &'static str),
    /// A body that is named without a position.
    Body(Span),
    /// An attachment `{ body = .. }` without a position.
    Position(Span),
}

/// Room for another key.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Room {
    /// Behind the line that holds this place.
    Line(usize),
    /// Before the end of an inline table at this place.
    Inline(usize),
}

/// Rows of a list that have paths; longer ones are tables of data.
const MOST_ROWS: usize = 64;
/// Largest distance of an attachment from the reference point of its body, m.
const POSITION: Bounds = Bounds::within(1e3);

/// All numbers of a file that has been read.
pub fn numbers(text: &str, spec: &Spec, catalog: &Catalog) -> Vec<Number> {
    if too_deep(text).is_some() {
        return Vec::new();
    }
    let root = from_table(DeTable::parse_recoverable(text).0.into_inner());
    let mut out = Vec::new();
    if let Some(entry) = get(&root, "machine") {
        machine(text, entry, spec, &mut out);
    }
    let mut block = |word: &str, blocks: &[&Block]| {
        let Some(entry) = get(&root, word) else { return };
        let tables: Vec<&Node> = match &entry.node.data {
            Data::List(list) => list.iter().collect(),
            _ => vec![&entry.node],
        };
        for (b, node) in blocks.iter().zip(tables) {
            let kind = catalog.described(b.kind).or_else(|| catalog.blocks.iter().flat_map(|x| &x.kinds).find(|k| k.kind == b.kind));
            if let (Some(kind), Some(table)) = (kind, node.table()) {
                let name = if b.name.is_empty() { word } else { &b.name };
                Reader { text, table, node, block: b, name }.all(kind, &mut out);
            }
        }
    };
    block("part", &spec.parts.iter().collect::<Vec<_>>());
    for info in &catalog.blocks {
        let own: Vec<&Block> = spec.extras.iter().filter(|e| e.0 == info.word).map(|e| &e.1).collect();
        block(info.word, &own);
    }
    out
}

fn machine(text: &str, entry: &Entry, spec: &Spec, out: &mut Vec<Number>) {
    let (Some(table), Some(field)) = (entry.node.table(), MACHINE_FIELDS.iter().find(|f| f.name == "speed")) else { return };
    let (FieldKind::Quantity { unit, bounds }, Some(value)) = (field.kind, spec.machine.speed) else { return };
    let written = get(table, "speed").and_then(|e| e.node.span.clone());
    let home = if written.is_some() { Home::Written } else { Home::Key(room(text, table, &entry.node), "speed".into()) };
    out.push(Number { path: "machine.speed".into(), unit, bounds, doc: field.doc, value, span: written, on: None, home });
}

/// Where another key of a block goes.
fn room(text: &str, table: &[Entry], node: &Node) -> Room {
    let span = node.span.clone().unwrap_or_default();
    if text.get(span.clone()).is_some_and(|t| t.starts_with('{') && t.ends_with('}')) {
        return Room::Inline(span.end - 1);
    }
    let headed = |e: &&Entry| {
        let at = e.span.as_ref().map_or(0, |s| s.start);
        let line = text.get(..at).and_then(|t| t.rfind('\n')).map_or(0, |i| i + 1);
        !text.get(line..).is_some_and(|l| l.trim_start().starts_with('['))
    };
    let end = |n: &Node| deepest(n);
    Room::Line(table.iter().filter(headed).filter_map(|e| end(&e.node)).max().unwrap_or(span.start))
}

/// The last place of a value: a table of dotted keys ends where the last of them does.
fn deepest(node: &Node) -> Option<usize> {
    let own = node.span.as_ref().map(|s| s.end);
    match &node.data {
        Data::Table(t) => t.iter().filter_map(|e| deepest(&e.node)).chain(own).max(),
        _ => own,
    }
}

/// Where the numbers of a column are written, with their rows, from 0: columns of a table, or rows of a list that leave some out.
fn cells<'a, 'n>(written: &'a Node<'n>, column: &str) -> Vec<(usize, &'a Node<'n>)> {
    match &written.data {
        Data::List(rows) => {
            let cell = |row: &'a Node<'n>| Some(&get(row.table()?, column)?.node);
            rows.iter().enumerate().filter_map(|(k, row)| Some((k, cell(row)?))).collect()
        }
        _ => match written.table().and_then(|t| get(t, column)).map(|e| &e.node.data) {
            Some(Data::List(nodes)) => nodes.iter().enumerate().collect(),
            _ => Vec::new(),
        },
    }
}

struct Reader<'a> {
    text: &'a str,
    table: &'a [Entry<'a>],
    node: &'a Node<'a>,
    block: &'a Block,
    name: &'a str,
}

impl Reader<'_> {
    fn all(&self, kind: &KindInfo, out: &mut Vec<Number>) {
        for field in &kind.fields {
            self.field(field, kind, out);
        }
    }

    fn missing(&self, key: &str) -> Home {
        Home::Key(room(self.text, self.table, self.node), key.to_string())
    }

    fn number(&self, path: &str, field: &Field, value: f64, span: Option<Span>, home: Home) -> Number {
        let (unit, bounds) = match field.kind {
            FieldKind::Quantity { unit, bounds } | FieldKind::Lateral { unit, bounds } | FieldKind::List { unit, bounds } => (unit, bounds),
            _ => ("", Bounds::within(f64::MAX)),
        };
        Number { path: format!("{}.{path}", self.name), unit, bounds, doc: field.doc, value, span, on: None, home }
    }

    fn field(&self, field: &Field, kind: &KindInfo, out: &mut Vec<Number>) {
        let written = get(self.table, field.name).map(|e| &e.node);
        match (field.kind, self.block.values.get(field.name)) {
            (FieldKind::Quantity { .. }, Some(Value::Number(x))) => {
                let span = written.and_then(|n| n.span.clone());
                let home = if span.is_some() { Home::Written } else { self.missing(field.name) };
                out.push(self.number(field.name, field, *x, span, home));
            }
            (FieldKind::Lateral { .. }, Some(Value::Lateral(pair))) => self.lateral(field, *pair, written, out),
            (FieldKind::OneOf(list), Some(Value::OneOf(which, x))) => {
                let Some(node) = written else { return };
                for (name, unit, bounds, doc) in list {
                    let own = node.table().and_then(|t| get(t, name)).and_then(|e| e.node.span.clone());
                    let value = if name == which { *x } else { f64::NAN };
                    let home = match (&own, &node.span) {
                        (None, Some(span)) => Home::Other(span.clone(), name),
                        _ => Home::Written,
                    };
                    let path = format!("{}.{name}", self.name);
                    out.push(Number { path, unit, bounds: *bounds, doc, value, span: own, on: None, home });
                }
            }
            (FieldKind::Columns(columns), Some(Value::Columns(values))) => {
                let Some(written) = written else { return };
                let own = kind.lists.iter().find(|l| l.name == field.name);
                for (column, unit, _, doc) in columns {
                    let (nodes, Some(numbers)) = (cells(written, column), values.get(column)) else { continue };
                    let slot = own.and_then(|l| l.slots.iter().find(|s| s.name == *column));
                    let bounds = slot.map_or(Bounds::within(f64::MAX), |s| s.bounds);
                    if numbers.len() > MOST_ROWS {
                        continue;
                    }
                    for (k, node) in nodes {
                        let Some(value) = numbers.get(k).copied() else { continue };
                        let path = format!("{}.{}[{}].{column}", self.name, field.name, k + 1);
                        let span = node.span.clone();
                        out.push(Number { path, unit, bounds, doc, value, span, on: None, home: Home::Written });
                    }
                }
            }
            (FieldKind::Range { unit, bounds }, Some(Value::Range(range))) => {
                let Some(table) = written.and_then(Node::table) else { return };
                for (end, value) in [("from", range.from), ("to", range.to)] {
                    let Some(span) = get(table, end).and_then(|e| e.node.span.clone()) else { continue };
                    let path = format!("{}.{}.{end}", self.name, field.name);
                    out.push(Number { path, unit, bounds, doc: field.doc, value, span: Some(span), on: None, home: Home::Written });
                }
            }
            (FieldKind::List { .. }, Some(Value::List(values))) => {
                let Some(Data::List(nodes)) = written.map(|n| &n.data) else { return };
                if nodes.len() <= MOST_ROWS {
                    for (k, (node, value)) in nodes.iter().zip(values).enumerate() {
                        out.push(self.number(&format!("{}[{}]", field.name, k + 1), field, *value, node.span.clone(), Home::Written));
                    }
                }
            }
            (FieldKind::Attach { .. }, Some(Value::Attach(attach))) => {
                self.attach(&format!("{}.at", field.name), attach, written, out);
            }
            (FieldKind::Between, Some(Value::Between(a, b))) => {
                let Some(Data::List(nodes)) = written.map(|n| &n.data) else { return };
                for (k, attach) in [a, b].into_iter().enumerate() {
                    self.attach(&format!("{}[{}].at", field.name, k + 1), attach, nodes.get(k), out);
                }
            }
            _ => {}
        }
    }

    fn lateral(&self, field: &Field, pair: [f64; 2], written: Option<&Node>, out: &mut Vec<Number>) {
        let Some(node) = written else {
            return out.push(self.number(field.name, field, pair[0], None, self.missing(field.name)));
        };
        let Some(table) = node.table() else {
            out.push(self.number(field.name, field, pair[0], node.span.clone(), Home::Written));
            for (half, value) in ["x", "y"].into_iter().zip(pair) {
                let home = Home::Half(node.span.clone().unwrap_or_default(), half);
                out.push(self.number(&format!("{}.{half}", field.name), field, value, None, home));
            }
            return;
        };
        let spans = ["x", "y"].map(|half| get(table, half).and_then(|e| e.node.span.clone()));
        if let [Some(x), Some(y)] = &spans
            && pair[0] == pair[1]
        {
            out.push(self.number(field.name, field, pair[0], None, Home::Both([x.clone(), y.clone()])));
        }
        for ((half, value), span) in ["x", "y"].into_iter().zip(pair).zip(spans) {
            out.push(self.number(&format!("{}.{half}", field.name), field, value, span, Home::Written));
        }
    }

    fn attach(&self, path: &str, attach: &Attach, node: Option<&Node>, out: &mut Vec<Number>) {
        let (Some(node), true) = (node, attach.body.is_some()) else { return };
        let Some(place) = node.span.clone() else { return };
        let at = node.table().and_then(|t| get(t, "at")).and_then(|e| e.node.span.clone());
        let home = match (&at, node.table()) {
            (Some(_), _) => Home::Written,
            (None, Some(_)) => Home::Position(place),
            (None, None) => Home::Body(place),
        };
        let doc = "position along the axis from the reference point of the body";
        out.push(Number {
            path: format!("{}.{path}", self.name),
            unit: "m",
            bounds: POSITION,
            doc,
            value: attach.position,
            span: at,
            on: attach.body.clone(),
            home,
        });
    }
}
