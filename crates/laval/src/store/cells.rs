//! Columns of a chunk: what they are, and their values.

use crate::diagnostic::Diagnostic;
use crate::text;
use serde::{Deserialize, Serialize};

/// Type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Real numbers; NaN stands for "no value".
    Float,
    /// Whole numbers, or none.
    Int,
    /// Words, or none.
    Text,
}

/// A column: name, unit, type, meaning.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Name, such as `amplitude`.
    pub name: String,
    /// SI unit; empty for a pure number or text.
    pub unit: String,
    /// Type.
    pub kind: Kind,
    /// What it holds.
    pub doc: String,
}

impl Column {
    /// A column of real numbers.
    pub fn float(name: impl Into<String>, unit: impl Into<String>, doc: impl Into<String>) -> Self {
        Column { name: name.into(), unit: unit.into(), kind: Kind::Float, doc: doc.into() }
    }
    /// A column of whole numbers.
    pub fn int(name: impl Into<String>, unit: impl Into<String>, doc: impl Into<String>) -> Self {
        Column { kind: Kind::Int, ..Self::float(name, unit, doc) }
    }
    /// A column of words.
    pub fn text(name: impl Into<String>, doc: impl Into<String>) -> Self {
        Column { kind: Kind::Text, ..Self::float(name, "", doc) }
    }
}

/// Values of one column in one chunk.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Cells {
    /// Real numbers; NaN stands for "no value" and comes back bit for bit.
    Float(Vec<f64>),
    /// Whole numbers, or none.
    Int(Vec<Option<i64>>),
    /// Words, or none.
    Text(Vec<Option<String>>),
}

impl Cells {
    /// No values of a type.
    pub fn none(kind: Kind) -> Cells {
        match kind {
            Kind::Float => Cells::Float(Vec::new()),
            Kind::Int => Cells::Int(Vec::new()),
            Kind::Text => Cells::Text(Vec::new()),
        }
    }
    /// Adds values of the same type behind; those of another are left out.
    pub fn append(&mut self, other: Cells) {
        match (self, other) {
            (Cells::Float(all), Cells::Float(more)) => all.extend(more),
            (Cells::Int(all), Cells::Int(more)) => all.extend(more),
            (Cells::Text(all), Cells::Text(more)) => all.extend(more),
            _ => {}
        }
    }
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            Cells::Float(v) => v.len(),
            Cells::Int(v) => v.len(),
            Cells::Text(v) => v.len(),
        }
    }
    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Type.
    pub fn kind(&self) -> Kind {
        match self {
            Cells::Float(_) => Kind::Float,
            Cells::Int(_) => Kind::Int,
            Cells::Text(_) => Kind::Text,
        }
    }
    /// The number in a row; NaN where there is none, also for words.
    pub fn number(&self, row: usize) -> f64 {
        match self {
            Cells::Float(v) => v.get(row).copied().unwrap_or(f64::NAN),
            Cells::Int(v) => v.get(row).copied().flatten().map_or(f64::NAN, |x| x as f64),
            Cells::Text(_) => f64::NAN,
        }
    }
    /// The word in a row.
    pub fn word(&self, row: usize) -> Option<&str> {
        match self {
            Cells::Text(v) => v.get(row)?.as_deref(),
            _ => None,
        }
    }
}

/// The cells are what the columns say, `rows` of each.
pub(super) fn check(columns: &[Column], rows: usize, cells: &[Cells]) -> Result<(), Diagnostic> {
    let fits = cells.len() == columns.len() && cells.iter().zip(columns).all(|(x, c)| x.kind() == c.kind && x.len() == rows);
    if fits {
        return Ok(());
    }
    let text = |c: &Cells| format!("{:?} of {}", c.kind(), c.len());
    let found = cells.iter().map(text).collect::<Vec<_>>().join(", ");
    Err(Diagnostic::error(
        "store.columns",
        text!("a chunk of {rows} rows and {columns} columns was computed as {found}", rows, columns = columns.len(), found),
    ))
}
