//! Shaded areas: intervals of one axis, what lies between two columns.

use crate::outcome::message::Arg;
use serde::{Deserialize, Serialize};

/// A shaded interval.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// Where.
    pub place: BandPlace,
    /// Name in the legend; bands of one name look alike.
    pub name: Arg,
    /// Also a strip at the upper border, never too narrow to be seen.
    pub strip: bool,
    /// In full colour: a bar rather than a background.
    pub bar: bool,
    /// The tint: 0 green, 1 red, 2 blue, 3 pink, 4 grey; otherwise the next of the first four that is free.
    pub tint: Option<usize>,
    /// Column of numbers that splits the rows between curves into areas of their own.
    pub group: Option<String>,
}

/// Where a [`Band`] lies; values before the axis factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum BandPlace {
    /// Between two values of x, the whole height.
    X(f64, f64),
    /// Between two values of y, the whole width.
    Y(f64, f64),
    /// Between two curves: table, x, lower and upper column; NaN breaks it.
    Between(String, String, String, String),
    /// The same along y: table, y, left and right column.
    Across(String, String, String, String),
}

impl Band {
    /// Between two values of x.
    pub fn x(from: f64, to: f64) -> Self {
        Band::new(BandPlace::X(from, to))
    }

    /// Between two values of y.
    pub fn y(from: f64, to: f64) -> Self {
        Band::new(BandPlace::Y(from, to))
    }

    /// Between the columns `low` and `high` over column `x`.
    pub fn between(table: impl Into<String>, x: impl Into<String>, low: impl Into<String>, high: impl Into<String>) -> Self {
        Band::new(BandPlace::Between(table.into(), x.into(), low.into(), high.into()))
    }

    /// Between the columns `left` and `right` of x over column `y`.
    pub fn across(table: impl Into<String>, y: impl Into<String>, left: impl Into<String>, right: impl Into<String>) -> Self {
        Band::new(BandPlace::Across(table.into(), y.into(), left.into(), right.into()))
    }

    fn new(place: BandPlace) -> Self {
        Band { place, name: Arg::default(), strip: false, bar: false, tint: None, group: None }
    }

    /// One area per value of this column.
    pub fn group(mut self, column: impl Into<String>) -> Self {
        self.group = Some(column.into());
        self
    }

    /// In full colour.
    pub fn bar(mut self) -> Self {
        self.bar = true;
        self
    }

    /// Green, of what is allowed.
    pub fn good(mut self) -> Self {
        self.tint = Some(0);
        self
    }

    /// Red, for states to avoid.
    pub fn bad(mut self) -> Self {
        self.tint = Some(1);
        self
    }

    /// Pink: missing values of another kind than those drawn in red.
    pub fn pink(mut self) -> Self {
        self.tint = Some(3);
        self
    }

    /// Blue, of neither.
    pub fn neutral(mut self) -> Self {
        self.tint = Some(2);
        self
    }

    /// Grey: nothing is known there.
    pub fn unknown(mut self) -> Self {
        self.tint = Some(4);
        self
    }

    /// Adds a strip at the upper border of the panel, wide enough to be seen however narrow the interval. For intervals of x.
    pub fn strip(mut self) -> Self {
        self.strip = true;
        self
    }

    /// Name in the legend.
    pub fn name(mut self, name: impl Into<Arg>) -> Self {
        self.name = name.into();
        self
    }
}
