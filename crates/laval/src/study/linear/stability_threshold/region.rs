//! Regions A and B of gas density and critical speed ratio: the third criterion of level 1.
//!
//! Critical speed ratio: speed over the first undamped critical speed on rigid supports. Above the boundary, in region B, a level 2 analysis is required where the threshold is below ten times the
//! anticipated stiffness.
//!
//! Sources: API 617, figure of the critical speed ratio over the average gas density, as the program ROSS (`report.py`, `stability_level_1`) writes its boundary.

use crate::model::system::System;
use crate::solve::support_map::{Spin, SupportMap};
use crate::study::shared::supporting;
use serde::{Deserialize, Serialize};

/// Average gas density up to which the largest ratio is constant, and from which on no ratio is in region A, kg/m^3.
pub const LIGHT: f64 = 16.53;
/// See [`LIGHT`].
pub const DENSE: f64 = 60.0;

/// Relative change of the critical speed, by its iteration and between two stiffnesses of the supports that differ by ten, up to which it is known.
const CONVERGED: f64 = 1e-4;

/// Largest critical speed ratio of region A at an average gas density (kg/m^3); 0 where every ratio is in region B, NaN where the density is no number from 0 on.
pub fn speed_ratio_limit(density: f64) -> f64 {
    if !(density >= 0.0) {
        f64::NAN
    } else if density <= LIGHT {
        2.5
    } else if density <= DENSE {
        2.69 - 0.0115 * density
    } else {
        0.0
    }
}

/// Where a machine lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Up to the boundary.
    A,
    /// Above it: level 2 is required.
    B,
    /// A number is missing.
    Unknown,
}

impl Region {
    /// Of a critical speed ratio at an average gas density (kg/m^3); beyond [`DENSE`] the ratio does not count.
    pub fn of(ratio: f64, density: f64) -> Region {
        let limit = speed_ratio_limit(density);
        match ratio <= limit && limit > 0.0 {
            true => Region::A,
            false if limit == 0.0 || ratio > limit => Region::B,
            false => Region::Unknown,
        }
    }
}

/// First undamped critical speed on rigid supports.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum RigidLimit {
    /// It is known.
    Found {
        /// rad/s.
        speed: f64,
        /// Relative difference with ten times the stiffness that stands for rigid supports.
        difference: f64,
        /// Slots of the supports.
        supports: Vec<usize>,
    },
    /// It is not, and why.
    Unknown(Reason),
}

/// Why there is no critical speed on rigid supports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reason {
    /// No state of rest says which supports carry.
    Rest,
    /// The machine has no supports.
    Supports,
    /// Another part than the supports is not given by matrices.
    Part,
    /// No critical speed was found.
    Missing,
    /// Two large stiffnesses differ.
    Uncertain,
}

impl Reason {
    /// The word by which sentences choose.
    pub fn word(self) -> &'static str {
        match self {
            Reason::Rest => "rest",
            Reason::Supports => "supports",
            Reason::Part => "part",
            Reason::Missing => "missing",
            Reason::Uncertain => "uncertain",
        }
    }
}

/// The lowest critical speed of either direction with the supports named, or all of the machine, rigid; pedestals and masses kept. It is that of the spin of a body, as speed of
/// the machine.
pub fn rigid_limit(system: &System, named: &[usize], body: Option<&str>, speed: f64) -> RigidLimit {
    let own = system.slots().iter().find(|s| Some(s.name.as_str()) == body).and_then(|s| s.ratio).map(|r| system.other_spin(r));
    let Some((name, ratio)) = own.and_then(|s| Some((s.name?, s.ratio))) else {
        return found(system, named, speed).unwrap_or_else(RigidLimit::Unknown);
    };
    let turned = system.at_spin(&name).map_err(|_| Reason::Rest);
    match turned.and_then(|turned| found(&turned, named, ratio * speed)) {
        Ok(RigidLimit::Found { speed, difference, supports }) => RigidLimit::Found { speed: speed / ratio.abs(), difference, supports },
        Ok(unknown) => unknown,
        Err(reason) => RigidLimit::Unknown(reason),
    }
}

fn found(system: &System, named: &[usize], speed: f64) -> Result<RigidLimit, Reason> {
    let at = supporting::state(system, speed).map_err(|_| Reason::Rest)?;
    let supports = supporting::of(system, named, &at);
    if supports.is_empty() {
        return Err(Reason::Supports);
    }
    let map = SupportMap::new(system, &supports, &at).map_err(|_| Reason::Part)?;
    let (root, difference) = map.first_rigid(Spin::Synchronous).ok_or(Reason::Missing)?;
    let certain = root.speed > 0.0 && root.speed.is_finite() && root.change <= CONVERGED && difference <= CONVERGED;
    match certain {
        true => Ok(RigidLimit::Found { speed: root.speed, difference, supports: supports.iter().map(|s| s.slot).collect() }),
        false => Err(Reason::Uncertain),
    }
}
