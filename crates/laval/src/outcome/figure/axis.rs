//! Axes of figures.

use crate::outcome::message::Arg;
use serde::{Deserialize, Serialize};

/// Scale of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios; values that are not positive are left out.
    Log,
}

/// An axis. Every value along it (columns and constants alike) is multiplied by `factor` before it is drawn, so that tables
/// and marks stay in SI units while the axis shows `rpm` or `µm`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Label, such as `speed`.
    pub label: Arg,
    /// Unit after the factor.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Factor from the values of the table to the unit of the axis.
    pub factor: f64,
    /// Range to show, in the unit of the axis; from the data when absent.
    pub range: Option<(f64, f64)>,
    /// Without numbers: places along it only have names.
    pub bare: bool,
    /// Names that stand at places of the axis, in its unit, instead of numbers.
    pub names: Vec<(f64, Arg)>,
    /// Linear nearer to zero than this, logarithmic on both sides beyond: for values of both signs and of many sizes.
    pub knee: Option<f64>,
}

impl Axis {
    /// A linear axis.
    pub fn new(label: impl Into<Arg>, unit: impl Into<String>) -> Self {
        Axis {
            label: label.into(),
            unit: unit.into(),
            scale: Scale::Linear,
            factor: 1.0,
            range: None,
            bare: false,
            names: Vec::new(),
            knee: None,
        }
    }

    /// A logarithmic axis.
    pub fn log(label: impl Into<Arg>, unit: impl Into<String>) -> Self {
        Axis { scale: Scale::Log, ..Axis::new(label, unit) }
    }

    /// Factor from the values of the table to the unit of the axis: `1e6` from m to µm.
    pub fn factor(mut self, factor: f64) -> Self {
        self.factor = factor;
        self
    }

    /// For values in m that reach to `most`: in mm, or in µm where that is small.
    pub fn metres(self, most: f64) -> Self {
        let (unit, factor) = if most >= 1e-3 { ("mm", 1e3) } else { ("µm", 1e6) };
        Axis { unit: unit.into(), factor, ..self }
    }

    /// Of the parameter at a path: `radius of oil` for `oil.radius`; metres in mm.
    pub fn parameter(path: &str, unit: &str) -> Self {
        let axis = Axis::new(parameter_name(path), unit);
        if unit == "m" { Axis { unit: "mm".into(), factor: 1e3, ..axis } } else { axis }
    }

    /// Names at places, in the unit of the axis, instead of numbers.
    pub fn names(mut self, names: Vec<(f64, Arg)>) -> Self {
        self.names = names;
        self
    }

    /// Linear nearer to zero than `knee`, in the unit of the axis, and logarithmic on both sides beyond.
    pub fn knee(mut self, knee: f64) -> Self {
        self.knee = Some(knee).filter(|k| k.is_finite() && *k > 0.0);
        self
    }

    /// Without numbers.
    pub fn bare(mut self) -> Self {
        self.bare = true;
        self
    }

    /// Shows this range (in the unit of the axis) whatever the data.
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }
}

/// A parameter as it is read: `radius of oil` for `oil.radius`.
pub fn parameter_name(path: &str) -> Arg {
    match path.split_once('.') {
        Some((part, field)) => Arg::of(Arg::term(field.replace(['_', '.'], " ")), Arg::name(part)),
        None => Arg::term(path.replace('_', " ")),
    }
}
