//! What the declarations of fields themselves say: defaults, and whether a declaration is sound.

use super::Catalog;
use super::tree::{Data, Node, from_toml};
use super::values::Context;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, Values};
use crate::text;
use crate::units;
use std::borrow::Cow;

impl Context<'_> {
    /// Fills the default of a field that was left out.
    pub fn default(&mut self, f: &Field, values: &mut Values) {
        if f.default.is_empty() {
            return;
        }
        let node = default_node(f.default);
        let before = self.out.0.len();
        let fine = self.field(f, &node, values);
        if !fine {
            let text = self.out.0.drain(before..).map(|d| d.to_string()).collect::<Vec<_>>().join("; ");
            self.out.push(Diagnostic::error(
                "declaration.default",
                text!("the declared default {default} cannot be used: {text}", default = text::quoted(&f.default), text),
            ));
        }
        values.mark_default(f.name);
    }
}

/// A default text as a person would write it: a TOML value without places, or a text without its quotes.
fn default_node(text: &'static str) -> Node<'static> {
    let first = text.as_bytes()[0];
    let toml_like = matches!(first, b'{' | b'[' | b'"' | b'\'') || matches!(text, "true" | "false") || text.parse::<f64>().is_ok();
    if toml_like && let Ok(v) = toml::de::DeValue::parse(text) {
        let mut node = from_toml(v);
        forget(&mut node);
        return node;
    }
    Node { data: Data::Text(Cow::Borrowed(text)), span: None }
}

fn forget(node: &mut Node) {
    node.span = None;
    match &mut node.data {
        Data::List(l) => l.iter_mut().for_each(forget),
        Data::Table(t) => t.iter_mut().for_each(|e| {
            e.span = None;
            forget(&mut e.node);
        }),
        _ => {}
    }
}

/// Mistakes of one declaration: units, default.
pub(super) fn check_declaration(kind: &str, f: &Field, out: &mut Diagnostics) {
    let units: Vec<&str> = match f.kind {
        FieldKind::Quantity { unit, .. }
        | FieldKind::Lateral { unit, .. }
        | FieldKind::Range { unit, .. }
        | FieldKind::Named { unit, .. }
        | FieldKind::List { unit, .. } => vec![unit],
        FieldKind::OneOf(list) => list.iter().map(|o| o.1).collect(),
        FieldKind::Columns(list) => list.iter().map(|o| o.1).collect(),
        _ => vec![],
    };
    for unit in units {
        match units::parse_unit(unit) {
            Ok(u) if (u.factor() - 1.0).abs() < 1e-12 => {}
            Ok(_) => out.push(Diagnostic::error(
                "declaration.unit",
                text!("{kind}.{name}: {unit} is not an SI unit", kind, name = f.name, unit = text::quoted(&unit)),
            )),
            Err(e) => {
                out.push(Diagnostic::error("declaration.unit", text!("{kind}.{name}: {why}", kind, name = f.name, why = e.sentence())))
            }
        }
    }
    let catalog = Catalog::default();
    let who = format!("{kind}.{}", f.name);
    Context { text: "", catalog: &catalog, parts: &[], studies: &[], out, who: &who }.default(f, &mut Values::default());
}
