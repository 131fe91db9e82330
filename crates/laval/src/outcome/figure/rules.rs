//! Straight lines across a panel, and words at a place.

use crate::outcome::message::Arg;
use serde::{Deserialize, Serialize};

/// A straight line across the panel with a label; `at` before the axis factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rule {
    /// True: vertical, at a value of x. False: horizontal, at a value of y.
    pub vertical: bool,
    /// Where.
    pub at: f64,
    /// Label.
    pub label: Arg,
    /// Two values along the same axis that the label ends with, in the unit of the axis: `unstable 100 to 120`.
    pub between: Option<(f64, f64)>,
}

impl Rule {
    /// Vertical, at a value of x.
    pub fn x(at: f64, label: impl Into<Arg>) -> Self {
        Rule { vertical: true, at, label: label.into(), between: None }
    }

    /// Horizontal, at a value of y.
    pub fn y(at: f64, label: impl Into<Arg>) -> Self {
        Rule { vertical: false, at, label: label.into(), between: None }
    }

    /// Adds two values of the same axis to the label, before its factor.
    pub fn between(mut self, from: f64, to: f64) -> Self {
        self.between = Some((from, to));
        self
    }
}

/// Words at a place in data coordinates (before the axis factors).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Text {
    /// x.
    pub x: f64,
    /// y.
    pub y: f64,
    /// The words.
    pub text: Arg,
}

impl Text {
    /// Words centred at a place.
    pub fn new(x: f64, y: f64, text: impl Into<Arg>) -> Self {
        Text { x, y, text: text.into() }
    }
}
