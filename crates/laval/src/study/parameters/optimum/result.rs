//! What a search for better parameters has found.

use crate::outcome::End;
use laval_num::optimise::Ended;
use serde::{Deserialize, Serialize};

/// The searches, the best machine, and what was tested around it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OptimumResult {
    /// None where the study was stopped before the machine as it is was known.
    pub found: Option<Found>,
    /// How the study ended.
    pub end: End,
}

/// A machine that was run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Run {
    /// By parameter: the place between its bounds, 0 to 1.
    pub place: Vec<f64>,
    /// The number; NaN where the study did not find it.
    pub value: f64,
    /// By limit: the number, NaN where it was not found.
    pub limited: Vec<f64>,
    /// A result lies outside the validity of a model.
    pub invalid: bool,
}

/// One search.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Trail {
    /// Runs so far and the best number with all limits kept (NaN before the first), generation by generation.
    pub history: Vec<(u64, f64)>,
    /// The best machine with all limits kept.
    pub best: Option<Run>,
    /// How it ended.
    pub ended: Ended,
    /// Width of the last generation in the unit cube.
    pub width: f64,
}

/// A direction: index of the parameter and the sign, or `None` for one between parameters.
pub type Along = Option<(usize, f64)>;

/// One-sided slopes of the merit at the optimum, per length in the unit cube, over a direction.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Slope {
    /// The direction.
    pub along: Along,
    /// The slope.
    pub slope: f64,
}

/// A recommended range.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Stray {
    /// Lowest and highest value, SI, and whether a bound of the search ends it.
    pub ends: [(f64, bool); 2],
}

/// What the searches have found.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Found {
    /// The number of the machine as it is.
    pub now: f64,
    /// Its unit.
    pub unit: String,
    /// By limit: the unit of its number.
    pub units: Vec<String>,
    /// The searches.
    pub trails: Vec<Trail>,
    /// The best machine of all.
    pub best: Option<Run>,
    /// Slopes around it.
    pub slopes: Vec<Slope>,
    /// By parameter: the recommended range.
    pub stray: Vec<Stray>,
    /// By parameter: places and runs along it.
    pub profiles: Vec<Vec<Run>>,
    /// Runs begun.
    pub runs: u64,
    /// Runs without the number.
    pub failed: u64,
    /// All searches and tests were made.
    pub complete: bool,
    /// Weight of the penalty at the end.
    pub weight: f64,
}

/// What the number is divided by where it is minimised: that of the machine as it is, or 1 where that is zero or has none.
pub(super) fn size(now: f64) -> f64 {
    if now.is_finite() && now != 0.0 { now.abs() } else { 1.0 }
}

impl Found {
    /// Slopes are of the number over that of the machine as it is.
    pub(super) fn relative(&self) -> bool {
        self.now.is_finite() && self.now != 0.0
    }

    /// What the number is divided by in slopes.
    pub(super) fn size(&self) -> f64 {
        size(self.now)
    }
}
