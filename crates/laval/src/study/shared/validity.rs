//! How far periodic motions use up the validity of the parts' models.

use super::support::{larger, place};
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::system::{System, Workspace};
use crate::outcome::{Arg, Finding};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::branches::response::Response;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Instants of a period at which validity is evaluated.
const SAMPLES: usize = 16;

/// The largest use of one statement of validity of one part; above 1 is outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Use {
    slot: usize,
    #[serde(deserialize_with = "laval_num::text::one")]
    what: laval_num::text::Text,
    ratio: f64,
    /// Lowest and highest speed of the motions outside; of none outside, of the first motion.
    speeds: (f64, f64),
}

impl Use {
    /// A ratio that is no number is outside.
    fn outside(&self) -> bool {
        !(self.ratio <= 1.0)
    }
}

/// The largest use of every statement of validity over some motions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Uses(Vec<Use>);

impl Uses {
    /// One instant of a motion.
    pub fn see(&mut self, system: &System, at: &At<f64>, ws: &mut Workspace<f64>) {
        for (slot, v) in system.validity(at, ws) {
            self.add(&Use { slot, what: v.what, ratio: v.ratio, speeds: (at.speed, at.speed) });
        }
    }

    /// Other motions of the same machine.
    pub fn join(&mut self, other: &Uses) {
        other.0.iter().for_each(|u| self.add(u));
    }

    fn add(&mut self, u: &Use) {
        let Some(known) = self.0.iter_mut().find(|k| (k.slot, k.what) == (u.slot, u.what)) else {
            return self.0.push(u.clone());
        };
        known.speeds = match (known.outside(), u.outside()) {
            (true, true) => (known.speeds.0.min(u.speeds.0), known.speeds.1.max(u.speeds.1)),
            (false, true) => u.speeds,
            _ => known.speeds,
        };
        known.ratio = larger(known.ratio, u.ratio);
    }

    /// A motion over its period; the spin takes `turns` turns in it.
    pub fn over(system: &System, orbit: &Orbit, turns: usize) -> Uses {
        let mut out = Uses::default();
        if orbit.orders.is_empty() {
            return out;
        }
        let (n, m) = (system.n(), system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let mut ws = Workspace::default();
        for j in 0..SAMPLES * turns {
            let tau = TAU * j as f64 / (SAMPLES * turns) as f64;
            orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
            let phase = turns as f64 * tau;
            let at = At { q: &q, v: &v, a: &a, z: &z, phase, speed: orbit.speed, spin_accel: 0.0, t: tau / orbit.frequency };
            out.see(system, &at, &mut ws);
        }
        out
    }

    /// All states of a response.
    ///
    /// # Errors
    /// As [`Balance::new`].
    pub fn of_response(system: &System, response: &Response, speeds: (f64, f64)) -> Result<Uses, Diagnostic> {
        let mut out = Uses::default();
        for branch in &response.branches {
            let mut balance = Balance::new(system, branch.discretisation.whole(), speeds, None)?;
            for state in &branch.points {
                if let Ok(orbit) = Orbit::of(&mut balance, &state.x, state.speed) {
                    out.join(&Uses::over(system, &orbit, branch.turns()));
                }
            }
        }
        Ok(out)
    }

    /// The statement that is used most, as `part: statement`; zero where no part states any.
    pub fn worst(&self, system: &System) -> (f64, String) {
        let Some(worst) = self.0.iter().reduce(|a, b| if a.ratio.is_nan() || b.ratio <= a.ratio { a } else { b }) else {
            return (0.0, String::new());
        };
        (worst.ratio, format!("{}: {}", system.slots()[worst.slot].name, worst.what))
    }

    /// That states of a response over the speed are outside: one finding for each statement.
    pub fn of_states(&self, system: &System) -> Vec<Finding> {
        self.findings(system, |u| {
            let finding = if u.ratio.is_finite() {
                Finding::invalid("outside_validity", "validity-states").value(u.ratio, "")
            } else {
                Finding::invalid("outside_validity", "validity-states-unbounded")
            };
            finding.arg("place", place(u.speeds.0, u.speeds.1))
        })
    }

    /// That some of what these motions are called is outside: one finding for each statement.
    pub fn of_motions(&self, system: &System, motions: &str) -> Vec<Finding> {
        self.findings(system, |u| {
            let finding = if u.ratio.is_finite() {
                Finding::invalid("validity", "validity-motions").value(u.ratio, "")
            } else {
                Finding::invalid("validity", "validity-motions-unbounded")
            };
            finding.arg("motions", Arg::term(motions))
        })
    }

    fn findings(&self, system: &System, of: impl Fn(&Use) -> Finding) -> Vec<Finding> {
        let one = |u: &Use| {
            let part = &system.slots()[u.slot].name;
            of(u).of(part).arg("part", Arg::name(part)).arg("what", Arg::term(u.what))
        };
        self.0.iter().filter(|u| u.outside()).map(one).collect()
    }
}
