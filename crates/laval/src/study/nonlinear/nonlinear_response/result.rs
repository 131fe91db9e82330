//! The result: states, and what is measured of them.

use super::forces::Extremes;
use super::largest::{Largest, Rising};
use super::one::Motion;
use super::orders::Orders;
use super::self_centring::Centring;
use super::tuning::Tuned;
use crate::model::probe::Probe;
use crate::outcome::End;
use crate::solve::harmonic::branches::response::Response;
use crate::study::shared::probes;
use crate::study::shared::validity::Uses;
use serde::{Deserialize, Serialize};

/// The steady response, and what is measured of its states.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct NonlinearResponseResult {
    /// Branches of states with folds, other bifurcations and stability.
    pub response: Response,
    /// Over a range of speeds: what is measured of the states.
    pub measured: Option<Measured>,
    /// With a threshold: orders beside the synchronous one.
    pub orders: Option<Orders>,
    /// At one speed: the motions there, by the displacement of the first body.
    pub motions: Option<Vec<Motion>>,
    /// How the study ended.
    pub end: End,
}

/// What is measured of the states of a response. Probes are the reference points of the bodies first, then their other points and tilts.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Measured {
    /// By branch and point: per probe the largest value over a period, m or rad.
    pub sizes: Vec<Vec<Vec<f64>>>,
    /// By branch and point: per body |Z_1|, largest distance from the axis, largest x, largest component slower than the spin, root of the mean square,
    /// largest y, amplitudes of x and y at the spin frequency.
    pub amplitudes: Vec<Vec<Vec<[f64; 8]>>>,
    /// By branch and fold: per probe the largest value over a period.
    pub at_folds: Vec<Vec<Vec<f64>>>,
    /// By branch and point: per part whose force is measured the force at the spin frequency: semi-major axis, amplitudes of x and y.
    pub first_forces: Vec<Vec<Vec<[f64; 3]>>>,
    /// Names and units of observed quantities.
    pub observed: Vec<(String, String)>,
    /// By branch and point their largest values.
    pub observations: Vec<Vec<Vec<f64>>>,
    /// By branch and point: use of the parts' validity.
    pub validity: Vec<Vec<Uses>>,
    /// Largest displacement of each point of the bodies.
    pub largest: Vec<Largest>,
    /// A displacement that still rises where a branch was left, above all others.
    pub rising: Option<Rising>,
    /// Largest forces of parts, and where one nearly vanishes.
    pub forces: Vec<Extremes>,
    /// Largest tilt of each body.
    pub tilts: Vec<Largest>,
    /// A tilt that still rises where a branch was left, above all others.
    pub tilt_rising: Option<Rising>,
    /// The displacement that bodies tend to at ever higher speed.
    pub centring: Option<Centring>,
    /// Foundations tuned to the speed of the machine.
    pub tuned: Vec<Tuned>,
}

impl Measured {
    /// Some point is displaced, and not only by what rounding leaves beside the tilts.
    pub(super) fn displaced(&self, probes: &[Probe]) -> bool {
        probes::displaced(|| self.sizes.iter().flatten().flat_map(|s| probes.iter().zip(s.iter().copied())))
    }
}
