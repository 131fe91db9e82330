//! What a separation has found: exits, recovery, demand, paths.

use crate::outcome::End;
use crate::separation::exit::Exit;
use crate::separation::places::Place;
use crate::separation::recovery::Needed;
use crate::separation::release::Moment;
use crate::separation::slowest::Last;
use serde::{Deserialize, Serialize};

/// The separation at one speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SeparationResult {
    /// None where the study was stopped before all paths were computed.
    pub found: Option<Separated>,
    /// How the study ended.
    pub end: End,
}

/// What was found of a separation.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Separated {
    /// Exits of the particles of the fixed set, in their order; none of a particle that stays.
    pub exits: Vec<Option<Exit>>,
    /// Share caught in the time at hand.
    pub caught: f64,
    /// Time of the recovery requested.
    pub needed: Needed,
    /// When the last particle is caught, where the whole fixed set is.
    pub last: Option<Last>,
    /// The recovery over time.
    pub recovered: Recovered,
    /// Products of sedimentation coefficient and time to the exit without inertia, s^2, rising; infinite for particles that stay.
    pub products: Vec<f64>,
    /// Largest Reynolds number of the particles of the set, at their exits.
    pub reynolds: f64,
    /// Tilt of the cup, rad; none where nothing is tilted.
    pub tilt: Option<f64>,
    /// Least and largest radius, m.
    pub radii: (f64, f64),
    /// The time at hand, counted at full speed, s.
    pub full_time: f64,
    /// The run-up that particles settle on.
    pub run_up: Option<RunUpTime>,
    /// What the recovery takes at other speeds; none where another speed is not searched for.
    pub demand: Option<Demand>,
    /// Paths of the first particles of the set.
    pub paths: Vec<Path>,
    /// The one particle released.
    pub released: Option<Released>,
}

/// Share of the particles caught over time.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Recovered {
    /// Times, s.
    pub time: Vec<f64>,
    /// Share caught by then.
    pub share: Vec<f64>,
    /// At the wall.
    pub wall: Vec<f64>,
    /// At the bottom.
    pub bottom: Vec<f64>,
    /// Share that reached the surface of the liquid.
    pub surface: Vec<f64>,
}

/// A run-up.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct RunUpTime {
    /// How long it takes, s.
    pub duration: f64,
    /// Time at full speed that separates as much, by an estimate along the radius, s.
    pub equivalent: f64,
}

/// What a recovery takes at other speeds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Demand {
    /// The speed that catches it in the time at hand.
    pub speed: SpeedNeeded,
    /// Speeds looked at, rad/s.
    pub speeds: Vec<f64>,
    /// Time that it takes there, s.
    pub times: Vec<f64>,
    /// Exponents of the time over each of [`PARAMETERS`]; NaN where the share is never caught.
    pub exponents: [f64; 4],
}

/// The parameters of the sensitivities.
pub const PARAMETERS: [&str; 4] = ["speed", "size", "density difference", "viscosity"];

/// The lowest speed that catches the recovery in the time at hand.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub enum SpeedNeeded {
    /// It was bracketed.
    Found {
        /// The speed, rad/s.
        speed: f64,
        /// Width of its bracket, rad/s.
        bracket: f64,
    },
    /// No speed looked at does.
    None {
        /// The highest of them, rad/s.
        highest: f64,
    },
}

/// A path, until the particle leaves or the time at hand ends.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Path {
    /// Diameter of the particle, m.
    pub diameter: f64,
    /// Its places.
    pub places: Vec<Place>,
}

/// The particle released.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Released {
    /// Where it leaves the liquid; none when it never does.
    pub exit: Option<Exit>,
    /// Largest Reynolds number.
    pub reynolds: f64,
    /// Its way.
    pub path: Vec<Moment>,
    /// Of a cup that swings: tilt of equilibrium, rad, at the speed, rad/s, of each moment.
    pub swing: Option<Vec<(f64, f64)>>,
}

impl Released {
    /// It begins in the liquid and leaves it.
    pub(super) fn leaves(&self) -> bool {
        self.exit.is_some_and(|e| e.time != 0.0)
    }
}
