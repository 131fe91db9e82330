//! Heat maps.

use super::Axis;
use crate::outcome::message::Arg;
use serde::{Deserialize, Serialize};

/// A heat map of `value` over a grid of x and y, given row by row in any order; missing cells stay blank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Heat {
    /// Table.
    pub table: String,
    /// Column of x.
    pub x: String,
    /// Column of y.
    pub y: String,
    /// Column of the value.
    pub value: String,
    /// Label, unit, factor, scale and range of the colours.
    pub colours: Axis,
    /// Colours that part at zero (growth rates) instead of a plain ramp.
    pub diverging: bool,
    /// Green above zero, where it is allowed; hatched red below.
    pub allowed: bool,
    /// Draws the curve where the value (before the factor) equals this.
    pub contour: Option<f64>,
    /// Draws curves at these values (before the factor) instead of cells.
    pub curves: Option<Vec<f64>>,
    /// Words the value may be, each with a colour of its own and an entry in the legend; empty for numbers.
    pub classes: Vec<String>,
    /// Words, and their names in the legend, where these are not the words.
    pub called: Vec<(String, Arg)>,
}

impl Heat {
    /// A heat map; colours part at zero when the data do.
    pub fn new(table: impl Into<String>, x: impl Into<String>, y: impl Into<String>, value: impl Into<String>, colours: Axis) -> Self {
        Heat {
            table: table.into(),
            x: x.into(),
            y: y.into(),
            value: value.into(),
            colours,
            diverging: false,
            allowed: false,
            contour: None,
            curves: None,
            classes: Vec::new(),
            called: Vec::new(),
        }
    }

    /// Names of these words in the legend.
    pub fn called(mut self, names: Vec<(String, Arg)>) -> Self {
        self.called = names;
        self
    }

    /// A map of a column of words: one colour for each of `classes`; cells of other words stay blank.
    pub fn of_classes(mut self, classes: Vec<String>) -> Self {
        self.classes = classes;
        self
    }

    /// Colours that part at zero: blue below, red above.
    pub fn diverging(mut self) -> Self {
        self.diverging = true;
        self
    }

    /// Colours that part at zero: green above, where it is allowed; hatched red below.
    pub fn allowed(mut self) -> Self {
        self.allowed = true;
        self.diverging()
    }

    /// Draws the curves where the value equals each of `levels`, and no cells.
    pub fn curves(mut self, levels: Vec<f64>) -> Self {
        self.curves = Some(levels);
        self
    }

    /// Draws the curve where the value equals `level`.
    pub fn contour(mut self, level: f64) -> Self {
        self.contour = Some(level);
        self
    }
}
