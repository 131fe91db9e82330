//! A locus of bifurcations in the plane of spin speed and one parameter.

use crate::harmonic::branches::bifurcation::Event;
use crate::harmonic::loci::follow::{PathEnd, Turn};
use serde::{Deserialize, Serialize};

/// What happens on a locus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum LocusKind {
    /// Two states meet and vanish.
    Fold,
    /// Stability changes otherwise.
    Change(Event),
}

impl LocusKind {
    /// The field's term.
    pub fn name(self) -> &'static str {
        match self {
            LocusKind::Fold => "fold",
            LocusKind::Change(event) => event.name(),
        }
    }
}

/// One point of a locus.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LocusPoint {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// The parameter.
    pub value: f64,
    /// Harmonics of the motion.
    pub x: Vec<f64>,
    /// Scaled residual.
    pub residual: f64,
    /// Dropped force harmonics over kept ones.
    pub truncation: f64,
    /// Of a change of stability: growth rate left there, 1/s; frequency of the disturbance, rad/s; exponents that grow beside the one that crosses.
    pub crossing: Option<(f64, f64, usize)>,
}

/// A place where a locus turns back in the parameter.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Corner {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Harmonics of the motion.
    pub x: Vec<f64>,
    /// The same seen along the locus.
    pub turn: Turn,
    /// Change of speed and parameter with four more orders; NaN when that did not converge.
    pub harmonics_change: [f64; 2],
}

/// A locus.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Locus {
    /// What happens on it.
    pub kind: LocusKind,
    /// Points in order along it.
    pub points: Vec<LocusPoint>,
    /// Places where it turns back in the parameter: for folds cusps, or places where two folds meet.
    pub corners: Vec<Corner>,
    /// How it ends.
    pub ends: [PathEnd; 2],
    /// Largest difference of the growth rate at points assessed again by Hill's method, 1/s, and their number.
    pub assessed_again: (f64, usize),
    /// Speed, rad/s, and value of the bifurcation it was started from.
    pub start: (f64, f64),
}
