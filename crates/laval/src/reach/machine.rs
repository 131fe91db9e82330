//! The machine with other values of the released parameters.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::file::{self, Catalog, Change, Loaded};
use crate::model::system::System;
use crate::text;

/// A parameter that may be moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Free {
    /// Its path: that of a parameter, or of a position of an attachment.
    pub path: String,
    /// Bounds, SI.
    pub low: f64,
    /// See [`Free::low`].
    pub high: f64,
}

pub(super) struct Varied<'a> {
    text: &'a str,
    loaded: &'a Loaded,
    catalog: &'a Catalog,
    pub free: &'a [Free],
    /// Of each its indices among the parameters of the machine; empty for a position.
    pub indices: Vec<Vec<usize>>,
    start: Vec<f64>,
}

/// Digits of values that are written into the file to vary a position.
const DIGITS: u8 = 15;

impl<'a> Varied<'a> {
    pub fn new(text: &'a str, loaded: &'a Loaded, catalog: &'a Catalog, free: &'a [Free]) -> Result<Varied<'a>, Diagnostics> {
        let (mut indices, mut start, mut wrong) = (Vec::new(), Vec::new(), Diagnostics::default());
        let numbers = file::numbers_of(text, &loaded.spec, catalog);
        for f in free {
            let own = loaded.system.param(&f.path).unwrap_or_default();
            let number = numbers.iter().find(|n| n.path == f.path);
            let value = own.first().and_then(|&i| loaded.system.params().get(i).copied()).or(number.map(|n| n.value));
            let Some(value) = value.filter(|v| v.is_finite()) else {
                wrong.push(Diagnostic::error("reach.path", text!("the file has no number \"{path}\"", path = f.path)));
                continue;
            };
            if indices.iter().flatten().any(|i| own.contains(i)) || free.iter().filter(|o| o.path == f.path).count() > 1 {
                wrong.push(Diagnostic::error("reach.twice", text!("{path} is released twice", path = f.path)));
            }
            if !(f.low < f.high && f.low.is_finite() && f.high.is_finite() && f.low <= value && value <= f.high) {
                let message = text!("{path}: the released range must hold the value of the file", path = f.path);
                wrong.push(Diagnostic::error("reach.range", message));
            }
            indices.push(own);
            start.push(value);
        }
        if wrong.has_errors() { Err(wrong) } else { Ok(Varied { text, loaded, catalog, free, indices, start }) }
    }

    /// Values of the file.
    pub fn start(&self) -> Vec<f64> {
        self.start.clone()
    }

    /// The change, as the root of the sum of squared shares of the ranges.
    pub fn distance(&self, p: &[f64]) -> f64 {
        let share = |((f, a), b): ((&Free, &f64), &f64)| ((b - a) / (f.high - f.low)).powi(2);
        self.free.iter().zip(&self.start).zip(p).map(share).sum::<f64>().sqrt()
    }

    /// The machine at these values.
    pub fn at(&self, p: &[f64]) -> Result<System, Diagnostic> {
        let changed = || self.free.iter().zip(&self.start).zip(p).zip(&self.indices).filter(|(((_, a), b), _)| a != b);
        let written = changed().any(|(_, own)| own.is_empty());
        let by_text: Vec<(String, Change)> =
            changed().filter(|(_, own)| own.is_empty()).map(|(((f, _), x), _)| (f.path.clone(), Change::Value(*x, DIGITS))).collect();
        let by_path: Vec<(&str, f64)> =
            changed().filter(|(_, own)| !own.is_empty()).map(|(((f, _), x), _)| (f.path.as_str(), *x)).collect();
        if !written {
            return self.loaded.system.with(&by_path).map_err(Diagnostics::into_error);
        }
        let edits = file::edits(self.text, &self.loaded.spec, self.catalog, &by_text).map_err(Diagnostics::into_error)?;
        let moved = file::load(&file::edited(self.text, &edits)).map_err(Diagnostics::into_error)?;
        moved.system.with(&by_path).map_err(Diagnostics::into_error)
    }
}
