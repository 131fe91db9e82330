//! The machine file: read with every mistake at its place, written back, described to editors and people.
//!
//! A file is TOML: one `[machine]`, any number of `[[part]]` and `[[study]]` blocks. Which kinds of parts and studies exist, and
//! what may be said of each, is a [`Catalog`]; nothing here knows a concrete part.

pub mod assemble;
pub mod docs;
pub mod reader;
pub mod render;
pub mod schema;
pub mod writer;

mod absent;
mod blocks;
mod constructed;
mod declared;
mod draft;
mod edits;
mod examine;
mod held;
mod joints;
mod names;
mod naming;
mod nested;
mod numbers;
mod places;
mod references;
mod stages;
mod stand_in;
mod syntax;
pub(crate) mod tree;
mod unusual;
mod values;
mod written_units;

#[cfg(test)]
mod tests;

pub use assemble::{Loaded, NamedStudy, Refusal, assemble, catalog, load, load_bytes};
pub use constructed::{construct, construct_kind};
pub use edits::{Change, Edit, edited, edits};
pub use places::{Number, numbers as numbers_of};
pub use reader::{read, read_bytes, read_json};
pub use render::{Form, render, render_in, to_json as diagnostics_json, to_json_in as diagnostics_json_in};
pub use writer::{canonical, write, write_json};
pub use written_units::{si_units, written_language, written_units};

use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::model::field::{BlockInfo, Bounds, Field, FieldKind, KindInfo, Values};
use crate::model::system::Drive;
use crate::text;

/// All kinds a file may name.
#[derive(Clone, Debug, Default)]
pub struct Catalog {
    /// Kinds of `[[part]]`.
    pub parts: Vec<KindInfo>,
    /// Kinds of `[[study]]`.
    pub studies: Vec<KindInfo>,
    /// Blocks beside them.
    pub blocks: Vec<BlockInfo>,
}

impl Catalog {
    /// A part by its word in the file.
    pub fn part(&self, kind: &str) -> Option<&KindInfo> {
        self.parts.iter().find(|k| k.kind == kind)
    }
    /// A study by its word in the file.
    pub fn study(&self, kind: &str) -> Option<&KindInfo> {
        self.studies.iter().find(|k| k.kind == kind)
    }
    /// What has parameters: a part, or a kind of a block beside the parts.
    pub fn described(&self, kind: &str) -> Option<&KindInfo> {
        self.part(kind).or_else(|| self.blocks.iter().flat_map(|b| &b.kinds).find(|k| k.kind == kind))
    }
    /// Mistakes in the declarations themselves: units that do not parse, defaults that do not read or lie outside their bounds,
    /// a key or kind declared twice. A registry asserts in a test that this is empty.
    pub fn check(&self) -> Diagnostics {
        let mut out = Diagnostics::default();
        let blocks = self.blocks.iter().map(|b| (&b.kinds, b.word));
        for (list, what) in [(&self.parts, "part"), (&self.studies, "study")].into_iter().chain(blocks) {
            for (i, k) in list.iter().enumerate() {
                if list[..i].iter().any(|o| o.kind == k.kind) {
                    out.push(Diagnostic::error(
                        "declaration.twice",
                        text!("the kind of {what} {kind} is declared twice", what, kind = text::quoted(&k.kind)),
                    ));
                }
                for (j, f) in k.fields.iter().enumerate() {
                    if k.fields[..j].iter().any(|o| o.name == f.name) || matches!(f.name, "kind" | "name") {
                        out.push(Diagnostic::error(
                            "declaration.twice",
                            text!("{kind} declares the key {name} twice", kind = k.kind, name = text::quoted(&f.name)),
                        ));
                    }
                    declared::check_declaration(k.kind, f, &mut out);
                }
            }
        }
        out
    }
}

/// Direction of the rotor axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RotorAxis {
    /// Gravity acts along the axis.
    #[default]
    Vertical,
    /// Gravity points to -y.
    Horizontal,
}

/// The `[machine]` block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MachineBlock {
    /// Name for titles; any text.
    pub name: String,
    /// Speed for studies that name none, rad/s.
    pub speed: Option<f64>,
    /// Direction of the rotor axis.
    pub axis: RotorAxis,
    /// How the spin angle moves.
    pub drive: Drive,
    /// The block's header in the file.
    pub span: Option<Span>,
    /// Place of the speed.
    pub speed_span: Option<Span>,
}

/// One `[[part]]` or `[[study]]` block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The word of its kind.
    pub kind: &'static str,
    /// Given, or the kind (then kind-2, kind-3 ...).
    pub name: String,
    /// All values, defaults filled in.
    pub values: Values,
    /// The block's header in the file.
    pub span: Option<Span>,
    /// Place of the kind.
    pub kind_span: Option<Span>,
    /// Place of the name, when it was given.
    pub name_span: Option<Span>,
}

/// A machine file after reading: everything typed, in SI units, defaults filled in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spec {
    /// `[machine]`.
    pub machine: MachineBlock,
    /// `[[part]]` in order.
    pub parts: Vec<Block>,
    /// `[[study]]` in order.
    pub studies: Vec<Block>,
    /// Blocks beside them with their words, in the order of the catalogue.
    pub extras: Vec<(&'static str, Block)>,
}

impl Spec {
    /// A part by name.
    pub fn part(&self, name: &str) -> Option<&Block> {
        self.parts.iter().find(|b| b.name == name)
    }
    /// A study by name.
    pub fn study(&self, name: &str) -> Option<&Block> {
        self.studies.iter().find(|b| b.name == name)
    }
    /// Name and kind of everything that has parameters.
    pub(crate) fn named(&self) -> impl Iterator<Item = (&str, &str)> {
        self.parts.iter().chain(self.extras.iter().map(|e| &e.1)).map(|b| (b.name.as_str(), b.kind))
    }
    /// The same without places in a file, for comparisons.
    pub fn without_spans(mut self) -> Self {
        self.machine.span = None;
        self.machine.speed_span = None;
        for b in self.parts.iter_mut().chain(&mut self.studies).chain(self.extras.iter_mut().map(|e| &mut e.1)) {
            (b.span, b.kind_span, b.name_span) = (None, None, None);
            b.values.forget_spans();
        }
        self
    }
}

/// The keys of `[machine]`.
pub const MACHINE_FIELDS: &[Field] = &[
    Field::optional("name", FieldKind::Text, "machine", "name of the machine, for titles"),
    Field::optional(
        "speed",
        FieldKind::Quantity { unit: "rad/s", bounds: Bounds::up_to(1e6) },
        "",
        "spin speed for studies that name none",
    ),
    Field::optional(
        "axis",
        FieldKind::Choice(&[("vertical", "gravity acts along the axis"), ("horizontal", "gravity points to -y")]),
        "vertical",
        "direction of the rotor axis",
    ),
    Field::optional(
        "drive",
        FieldKind::Choice(&[
            ("prescribed", "studies say how the spin speed goes; its torque is a result"),
            ("free", "the spin follows from the torques of the parts, such as a motor"),
        ]),
        "prescribed",
        "what moves the rotor",
    ),
];

/// The scalar that a parameter path of a block (`free_surface_radius`, `stiffness.x`) names: its unit and bounds.
pub(crate) fn parameter_of(kind: &KindInfo, path: &str) -> Option<(&'static str, Bounds)> {
    // of a row of a list: section[3].outer_diameter
    let row = || kind.lists.iter().find_map(|list| list.find(path)).map(|slot| (slot.unit, slot.bounds));
    let field = |f: &Field| match f.kind {
        FieldKind::Quantity { unit, bounds } if f.name == path => Some((unit, bounds)),
        FieldKind::Lateral { unit, bounds } => {
            let rest = path.strip_prefix(f.name)?;
            matches!(rest, "" | ".x" | ".y").then_some((unit, bounds))
        }
        FieldKind::OneOf(list) => {
            let name = path.strip_prefix(f.name).and_then(|r| r.strip_prefix('.')).unwrap_or(path);
            list.iter().find(|o| o.0 == name).map(|o| (o.1, o.2))
        }
        _ => None,
    };
    kind.fields.iter().find_map(field).or_else(row)
}

/// All parameter paths of a kind; of lists those of their first rows.
pub(crate) fn parameters_of(kind: &KindInfo) -> Vec<String> {
    let mut out = Vec::new();
    for f in &kind.fields {
        match f.kind {
            FieldKind::Quantity { .. } | FieldKind::Lateral { .. } => out.push(f.name.to_string()),
            FieldKind::OneOf(list) => out.extend(list.iter().map(|o| o.0.to_string())),
            _ => {}
        }
    }
    let rows = kind.lists.iter().flat_map(|list| list.slots.iter().map(move |s| list.path(0, &s.name)));
    out.into_iter().chain(rows).collect()
}

/// The unit and value of the parameter that a range in `values` runs over, when the file settles it.
pub(crate) fn parameter_in<'a>(
    catalog: &'a Catalog,
    parts: impl Iterator<Item = (&'a str, &'a str)>,
    path: &str,
) -> Option<(&'static str, Bounds)> {
    let (block, rest) = path.split_once('.')?;
    let kind = parts.into_iter().find(|(name, _)| *name == block)?.1;
    parameter_of(catalog.described(kind)?, rest)
}
