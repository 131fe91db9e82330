//! Basins as data.

use super::masses::{Checked, MassAttractor, Rehearsal};
pub use super::{attractors::Attractor, attractors::AttractorSet};
use crate::outcome::End;
use crate::store::Collected;
use crate::study::motion::record::UsedForm;
use serde::{Deserialize, Serialize};

/// Where the motions from a grid of initial values lead.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BasinsResult {
    /// What was found; `None` where a study of a machine with movable masses was stopped before the first cell.
    pub found: Option<Found>,
    /// Why motions begin undeflected although the machine is loaded.
    pub undeflected: Option<String>,
    /// How the study ended.
    pub end: End,
}

/// What was found.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Found {
    /// Motions in fixed axes, by their Poincare sets.
    Motions(Box<MotionBasins>),
    /// States at rest in turning axes, and motions with masses that go round.
    Masses(Box<MassBasins>),
}

/// Basins by Poincare sets.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MotionBasins {
    /// The motion from the undisturbed start, then that of every cell, along the first axis and then along the second.
    pub motions: Collected,
    /// Which of them are the same.
    pub attractors: AttractorSet,
    /// States of the machine in time: names and units.
    pub states: Vec<(String, String)>,
    /// Their typical sizes.
    pub sizes: Vec<f64>,
    /// What is known of the modes at rest.
    pub modes: ModesAtRest,
    /// Rational forms that stood for exact parts.
    pub forms: Vec<UsedForm>,
}

/// What is known of the modes of a machine at rest: how long settling takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModesAtRest {
    /// Decay rate of the slowest mode, 1/s; none where a mode does not decay.
    pub decay: Option<f64>,
    /// Growth rate of the fastest growing mode, 1/s.
    pub growth: Option<f64>,
    /// A mode neither decays nor grows.
    pub neutral: bool,
}

/// Basins of a machine with movable masses.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MassBasins {
    /// What motions end in.
    pub attractors: Vec<MassAttractor>,
    /// Coordinates of the masses, by groups of those that may be exchanged.
    pub masses: Vec<usize>,
    /// Every cell, along the first axis and then along the second.
    pub cells: Collected,
    /// What was followed beforehand, where ends of motions were recognised early.
    pub recognition: Option<Rehearsal>,
    /// Cells that were followed to their ends after all.
    pub checked: Option<Checked>,
}
