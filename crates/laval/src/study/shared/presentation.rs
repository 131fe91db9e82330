//! The block `[report]` of a machine file: language and units of what people read.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Extra, Field, FieldKind};
use crate::model::system::System;
use crate::text;
use crate::units::parse_unit;

/// Lines of a typical block.
pub const EXAMPLE: &str = r#"language = "ru"
units = "rpm, mm, N/mm, kN"
"#;
/// What the block is.
pub const DOC: &str = "Language and units of the report, its figures and the summary in the terminal. Tables, results.json and figures of other programs \
    that read them keep SI units and English names.";

/// Fields of `[report]`.
pub const FIELDS: &[Field] = &[
    Field::optional(
        "language",
        FieldKind::Choice(&[("en", "English"), ("ru", "Russian"), ("kk", "Kazakh"), ("uz", "Uzbek, Latin letters")]),
        "",
        "language of the report; --lang comes before it, the language of the environment after it",
    ),
    Field::optional(
        "units",
        FieldKind::Text,
        "file",
        "file: the units that this file writes; si: SI units with prefixes; or the units to use, such as \"rpm, mm, kN\", before those of the file",
    ),
];

/// What the block says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Presentation {
    /// Code of the language.
    pub language: Option<String>,
    /// `file`, `si`, or units.
    pub units: Option<String>,
}

/// Of the blocks of a machine; nothing where there is no such block.
pub fn among(extras: &[Extra]) -> Presentation {
    let of = |e: &Extra| Presentation {
        language: e.values.choice("language").map(String::from),
        units: e.values.text("units").map(String::from),
    };
    extras.iter().find(|e| e.word == "report").map(of).unwrap_or_default()
}

/// The units of a list.
pub fn listed(units: &str) -> impl Iterator<Item = &str> {
    units.split([',', ';']).map(str::trim).filter(|u| !u.is_empty())
}

/// Says what is wrong with the block.
pub fn check(extra: &Extra, _: &System, out: &mut Diagnostics) {
    let Some(units) = extra.values.text("units").filter(|u| !matches!(*u, "file" | "si")) else { return };
    for unit in listed(units) {
        if let Err(e) = parse_unit(unit) {
            let help = text!("write file, si, or units such as \"rpm, mm, kN\"");
            out.push(Diagnostic::error("report.units", e.sentence()).at(extra.values.span_of("units")).help(help));
        }
    }
}
