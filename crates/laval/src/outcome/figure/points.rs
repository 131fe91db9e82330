//! Markers.

use super::super::stored;
use crate::outcome::message::Arg;
use serde::{Deserialize, Serialize};

/// A marker per row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Points {
    /// Table.
    pub table: String,
    /// Column of x.
    pub x: String,
    /// Column of y.
    pub y: String,
    /// Column whose values choose colour and shape.
    pub group: Option<String>,
    /// Values of `group` that always have the same colour and shape, whichever of them occur: the first, the second, ... Their sizes differ, so that
    /// markers of two classes at one place are both seen.
    #[serde(with = "stored::words")]
    pub classes: &'static [&'static str],
    /// Flag column: filled markers where true, open ones elsewhere.
    pub filled_where: Option<String>,
    /// Values of `group` that are grey.
    #[serde(with = "stored::words")]
    pub muted: &'static [&'static str],
    /// Small, for many.
    pub small: bool,
    /// Name in the legend.
    pub name: Arg,
    /// Groups, and their names in the legend, where these are not the values of the column.
    pub called: Vec<(String, Arg)>,
}

impl Points {
    /// Markers at columns `x`, `y`.
    pub fn new(table: impl Into<String>, x: impl Into<String>, y: impl Into<String>) -> Self {
        Points {
            table: table.into(),
            x: x.into(),
            y: y.into(),
            group: None,
            classes: &[],
            filled_where: None,
            muted: &[],
            small: false,
            name: Arg::default(),
            called: Vec::new(),
        }
    }

    /// Draws markers of these classes grey.
    pub fn muted(mut self, classes: &'static [&'static str]) -> Self {
        self.muted = classes;
        self
    }

    /// Names of these groups in the legend.
    pub fn called(mut self, names: Vec<(String, Arg)>) -> Self {
        self.called = names;
        self
    }

    /// Small markers, for many.
    pub fn small(mut self) -> Self {
        self.small = true;
        self
    }

    /// Colour and shape by this column.
    pub fn group(mut self, column: impl Into<String>) -> Self {
        self.group = Some(column.into());
        self
    }

    /// Colour and shape by this column, the same for each of these values in every figure.
    pub fn classes(mut self, column: impl Into<String>, classes: &'static [&'static str]) -> Self {
        self.classes = classes;
        self.group(column)
    }

    /// Filled where this flag column is true, open elsewhere.
    pub fn filled_where(mut self, column: impl Into<String>) -> Self {
        self.filled_where = Some(column.into());
        self
    }

    /// Name in the legend.
    pub fn name(mut self, name: impl Into<Arg>) -> Self {
        self.name = name.into();
        self
    }
}
