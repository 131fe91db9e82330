//! Curves.

use super::super::stored;
use crate::outcome::message::Arg;
use serde::{Deserialize, Serialize};

/// A curve through the rows of a table in their order; it may fold back. NaN breaks it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Table.
    pub table: String,
    /// Column of x.
    pub x: String,
    /// Column of y.
    pub y: String,
    /// Column whose values split the rows into one line each (mode number, branch).
    pub group: Option<String>,
    /// Flag column: a piece is solid where it is true at both ends, dashed elsewhere.
    pub solid_where: Option<String>,
    /// Flag column: where it is true the curve begins anew, with a gap before it.
    pub begins_where: Option<String>,
    /// Column whose values give pieces of the curves their colour and their name in the legend, in place of the groups.
    pub class: Option<String>,
    /// Values of `class` that always have the same colour, whichever of them occur.
    #[serde(with = "stored::words")]
    pub classes: &'static [&'static str],
    /// Curves of groups coincide: the earlier are drawn wider, so that all are seen.
    pub nested: bool,
    /// Pieces that would be dashed are left out.
    pub solid_only: bool,
    /// What solid and dashed mean in the legend.
    pub solid_dashed: (Arg, Arg),
    /// Name in the legend.
    pub name: Arg,
    /// Drawn thin and grey with its name at its end instead of in the legend: for orders such as 1× and 2×.
    pub reference: bool,
    /// Flag column: rows outside validity are drawn thin and grey, and do not widen the axes.
    pub valid_where: Option<String>,
    /// An angle in rad, shown from half a turn below zero to half a turn above.
    pub wrapped: bool,
    /// A smooth path: drawn through its points without corners, its start and direction marked.
    pub path: bool,
    /// Values of `class` that are drawn thin and grey.
    #[serde(with = "stored::words")]
    pub muted: &'static [&'static str],
    /// In the colour of text, not of the palette: for intervals on bars.
    pub ink: bool,
    /// Groups, and the words at the ends of their curves.
    pub ends: Vec<(String, Arg)>,
    /// Groups, and their names in the legend, where these are not the values of the column.
    pub called: Vec<(String, Arg)>,
    /// Values that differ by this are the same (angles): the curve is drawn without jumps by it.
    pub period: Option<f64>,
}

impl Line {
    /// A curve of column `y` over column `x`.
    pub fn new(table: impl Into<String>, x: impl Into<String>, y: impl Into<String>) -> Self {
        Line {
            table: table.into(),
            x: x.into(),
            y: y.into(),
            group: None,
            solid_where: None,
            begins_where: None,
            class: None,
            classes: &[],
            nested: false,
            solid_only: false,
            solid_dashed: ("stable".into(), "unstable".into()),
            name: Arg::default(),
            reference: false,
            valid_where: None,
            wrapped: false,
            path: false,
            muted: &[],
            ink: false,
            ends: Vec::new(),
            called: Vec::new(),
            period: None,
        }
    }

    /// Draws pieces of these classes thin and grey.
    pub fn muted(mut self, classes: &'static [&'static str]) -> Self {
        self.muted = classes;
        self
    }

    /// Draws it in the colour of text.
    pub fn ink(mut self) -> Self {
        self.ink = true;
        self
    }

    /// Words at the ends of the curves of these groups.
    pub fn ends(mut self, ends: Vec<(String, Arg)>) -> Self {
        self.ends = ends;
        self
    }

    /// Names of these groups in the legend.
    pub fn called(mut self, names: Vec<(String, Arg)>) -> Self {
        self.called = names;
        self
    }

    /// Values that differ by `period` are the same: the curve goes on without jumps by it.
    pub fn cyclic(mut self, period: f64) -> Self {
        self.period = Some(period);
        self
    }

    /// One line per value of this column.
    pub fn group(mut self, column: impl Into<String>) -> Self {
        self.group = Some(column.into());
        self
    }

    /// Colours and names the pieces by this column, the same for each of these values in every figure: where there are more curves than colours.
    pub fn classes(mut self, column: impl Into<String>, classes: &'static [&'static str]) -> Self {
        self.class = Some(column.into());
        self.classes = classes;
        self
    }

    /// Leaves out what would be dashed.
    pub fn solid_only(mut self, only: bool) -> Self {
        self.solid_only = only;
        self
    }

    /// Solid where this flag column is true (stable), dashed elsewhere (unstable).
    pub fn solid_where(mut self, column: impl Into<String>) -> Self {
        self.solid_where = Some(column.into());
        self
    }

    /// Begins anew, with a gap before, where this flag column is true.
    pub fn begins_where(mut self, column: impl Into<String>) -> Self {
        self.begins_where = Some(column.into());
        self
    }

    /// Draws earlier groups wider, so that curves that coincide are all seen.
    pub fn nested(mut self) -> Self {
        self.nested = true;
        self
    }

    /// What solid and dashed mean, when not stable and unstable.
    pub fn meaning(mut self, solid: impl Into<Arg>, dashed: impl Into<Arg>) -> Self {
        self.solid_dashed = (solid.into(), dashed.into());
        self
    }

    /// Name in the legend.
    pub fn name(mut self, name: impl Into<Arg>) -> Self {
        self.name = name.into();
        self
    }

    /// Grey where this flag column is not true: outside the validity of a part.
    pub fn valid_where(mut self, column: impl Into<String>) -> Self {
        self.valid_where = Some(column.into());
        self
    }

    /// Shows an angle in rad from half a turn below zero to half a turn above.
    pub fn wrapped(mut self) -> Self {
        self.wrapped = true;
        self
    }

    /// Smooth through its points, with its start and direction: for orbits.
    pub fn path(mut self) -> Self {
        self.path = true;
        self
    }

    /// Draws a thin grey line with its name at its end.
    pub fn reference(mut self) -> Self {
        self.reference = true;
        self
    }
}
