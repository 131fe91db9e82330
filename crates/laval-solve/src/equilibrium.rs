//! A state that the machine is linearised about, and the sectors of its unknowns.

use super::sectors::Sectors;
use crate::model::system::System;
use serde::{Deserialize, Serialize};

/// Axes in which a state is at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Frame {
    /// Fixed axes: nothing moves.
    Fixed,
    /// Axes that turn with the rotor.
    Turning,
}

/// A state the machine is linearised about, with the evidence that it is one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Equilibrium {
    /// Axes it rests in.
    pub frame: Frame,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Coordinates (at spin angle 0 for [`Frame::Turning`]).
    pub q: Vec<f64>,
    /// Internal states of the whole machine; memory states and states of frequency-domain parts are left zero.
    pub z: Vec<f64>,
    /// Newton steps taken.
    pub iterations: usize,
    /// Length of the last Newton step relative to the typical sizes of the coordinates.
    pub last_step: f64,
}

impl Equilibrium {
    /// The state zero.
    pub fn zero(system: &System, frame: Frame, speed: f64) -> Self {
        Equilibrium { frame, speed, q: vec![0.0; system.n()], z: vec![0.0; system.m()], iterations: 0, last_step: 0.0 }
    }
    /// Rates of the coordinates.
    pub fn velocity(&self, sectors: &Sectors) -> Vec<f64> {
        match self.frame {
            Frame::Fixed => vec![0.0; self.q.len()],
            Frame::Turning => sectors.quarter_turn(&self.q).iter().map(|x| x * self.speed).collect(),
        }
    }
    /// Accelerations of the coordinates.
    pub fn acceleration(&self, sectors: &Sectors) -> Vec<f64> {
        let v = self.velocity(sectors);
        match self.frame {
            Frame::Fixed => v,
            Frame::Turning => sectors.quarter_turn(&v).iter().map(|x| x * self.speed).collect(),
        }
    }
}

/// Sectors of the machine's coordinates.
pub fn coordinate_sectors(system: &System) -> Sectors {
    Sectors::new(system.coordinates().iter().map(|d| d.dof.kind))
}

/// Sectors of some of the machine's internal states (global indices).
pub fn state_sectors(system: &System, states: &[usize]) -> Sectors {
    Sectors::new(states.iter().map(|&i| system.states()[i].dof.kind))
}

/// Global indices of the internal states of nonlinear parts.
pub fn nonlinear_states(system: &System) -> Vec<usize> {
    system.slots().iter().filter(|s| !s.is_linear()).flat_map(|s| s.states.clone()).collect()
}
