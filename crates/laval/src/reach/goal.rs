//! Results that can be moved.

use super::criticals::CriticalSpeed;
use super::limits::StabilityLimit;
use super::places::Placed;
use super::resonances::Resonance;
use crate::diagnostic::Diagnostic;
use crate::file::Loaded;
use crate::model::system::System;
use crate::study::sensitivity::Kind;
use crate::study::{self, Context};

/// What of a peak is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The speed.
    Speed,
    /// The displacement or tilt.
    Size,
}

impl Of {
    /// SI unit.
    pub(super) fn unit(self, tilt: bool) -> &'static str {
        match self {
            Of::Speed => "rad/s",
            Of::Size if tilt => "rad",
            Of::Size => "m",
        }
    }
}

/// A result of a machine, by what it is and where it is now.
#[derive(Clone, Debug, PartialEq)]
pub enum Goal {
    /// The critical speed of an order next to this speed, rad/s.
    CriticalSpeed {
        /// Frequency over spin speed.
        order: f64,
        /// Where it is.
        at: f64,
    },
    /// The limit of stability next to this speed, rad/s.
    StabilityLimit {
        /// Where it is.
        at: f64,
    },
    /// The peak of the steady response next to this speed, rad/s.
    Peak {
        /// Where it is.
        at: f64,
        /// The point or body it is of; the one that moves most where none is named.
        body: Option<String>,
        /// What is moved.
        of: Of,
    },
    /// The peak of the linear response next to this speed, rad/s; nonlinear parts enter by their tangent at rest.
    Resonance {
        /// Where it is.
        at: f64,
        /// The point, body or tilt it is of; the displacement that is largest where none is named.
        body: Option<String>,
        /// What is moved.
        of: Of,
    },
    /// The jump of the steady response next to this speed, rad/s.
    Jump {
        /// Where it is.
        at: f64,
    },
}

/// See [`Sought::tolerance`].
pub(super) const STATED: f64 = 2e-3;
/// See [`Sought::accuracy`].
const EXACT: f64 = 1e-9;

/// A result with its slopes, one for each of the parameters; NaN where they are not known.
pub(super) struct Valued {
    pub value: f64,
    pub slopes: Vec<f64>,
}

/// A result that is followed from machine to machine.
pub(super) trait Sought {
    /// Its SI unit.
    fn unit(&self) -> &'static str;
    /// It takes milliseconds.
    fn quick(&self) -> bool;
    /// Its value, with slopes in these parameters, each a list of indices that move together. `None` where the machine does not have it near where it was.
    fn of(&mut self, system: &System, parameters: &[Vec<usize>], context: &Context) -> Result<Option<Valued>, Diagnostic>;
    /// Distance of the result of the file from where it is stated, over its speed, up to which it is that result.
    fn tolerance(&self) -> f64 {
        STATED
    }
    /// Distance from the wanted value, over it, up to which it is reached: what the value is computed to.
    fn accuracy(&self) -> f64 {
        EXACT
    }
    /// Where it was last, its speed first.
    fn mark(&self) -> Vec<f64>;
    /// Goes on from an earlier place.
    fn back(&mut self, mark: &[f64]);
}

impl Goal {
    pub(super) fn sought(&self, loaded: &Loaded, context: &Context) -> Result<Box<dyn Sought>, Diagnostic> {
        let system = &loaded.system;
        let range = || {
            let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(system)).collect();
            study::page_range(system, &speeds)
        };
        Ok(match self {
            Goal::CriticalSpeed { order, at } => Box::new(CriticalSpeed::find(system, *order, *at, context)?),
            Goal::StabilityLimit { at } => Box::new(StabilityLimit::find(system, *at, context)?),
            Goal::Peak { at, body, of } => Box::new(Placed::new(vec![Kind::Peak], *of, *at, body.clone(), range())),
            Goal::Resonance { at, body, of } => Box::new(Resonance::new(system, *of, *at, body.clone())),
            Goal::Jump { at } => Box::new(Placed::new(vec![Kind::JumpUp, Kind::JumpDown], Of::Speed, *at, None, range())),
        })
    }
}
