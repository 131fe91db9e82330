//! Basins as data.

use super::masses::{self, Checked, MassAttractor, Rehearsal};
use super::rows::PLACE;
pub use super::{attractors::Attractor, attractors::AttractorSet};
use crate::outcome::End;
use crate::solve::reduction::Reduced;
use crate::store::Collected;
use crate::study::motion::record::{SettledMotion, UsedForm};
use crate::study::motion::steady_state::stored::settled;
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
    /// What the machine was reduced to.
    pub reduced: Option<Reduced>,
}

/// A motion from the undisturbed start or from a cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BasinMotion {
    /// Initial values along both axes.
    pub place: [f64; 2],
    /// What it settles on.
    pub motion: SettledMotion,
    /// Number of its attractor, from 0; none where it has no limit.
    pub attractor: Option<usize>,
}

impl MotionBasins {
    /// The motions, row by row.
    pub fn list(&self) -> Vec<BasinMotion> {
        let [x, y] = PLACE.map(|name| self.motions.numbers(name));
        let of = |row: usize| self.attractors.of.get(row).copied().flatten();
        let one = |(row, motion): (usize, SettledMotion)| BasinMotion { place: [x[row], y[row]], motion, attractor: of(row) };
        settled(&self.motions).into_iter().enumerate().map(one).collect()
    }
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

/// A cell of a map of a machine with movable masses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MassCell {
    /// Initial values along both axes.
    pub place: [f64; 2],
    /// Number of the attractor it ends in, from 0, or in words what it comes to that is none of them.
    pub end: Result<usize, String>,
    /// Its end was recognised before it was reached.
    pub early: bool,
    /// Turns integrated.
    pub turns: u64,
    /// Why there is no motion.
    pub failure: Option<String>,
}

impl MassBasins {
    /// The cells, row by row.
    pub fn list(&self) -> Vec<MassCell> {
        let all = &self.cells;
        let [x, y] = PLACE.map(|name| all.numbers(name));
        let [state, early, turns] = [masses::STATE, masses::EARLY, masses::TURNS].map(|name| all.numbers(name));
        let (goals, failures) = (all.words(masses::GOAL), all.words(masses::FAILURE));
        let one = |(row, goal): (usize, String)| MassCell {
            place: [x[row], y[row]],
            // numbers count from 1
            end: (state[row] as usize).checked_sub(1).ok_or(goal),
            early: early[row] == 1.0,
            turns: turns[row] as u64,
            failure: failures.get(row).filter(|w| !w.is_empty()).cloned(),
        };
        goals.into_iter().enumerate().map(one).collect()
    }
}
