//! How far periodic motions use up the validity of the parts' models.

use super::support::larger;
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::system::{System, Workspace};
use crate::outcome::{Finding, significant};
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
        self.say("outside_validity", system, |part, u| {
            let (from, to) = (significant(u.speeds.0, 5), significant(u.speeds.1, 5));
            let place = if from == to { format!("at {from} rad/s") } else { format!("between {from} and {to} rad/s") };
            (format!("Some states {place} lie outside the validity of a part ({part}: {})", u.what), ": up to {} times the limit.")
        })
    }

    /// That some of what these motions are called is outside: one finding for each statement.
    pub fn of_motions(&self, system: &System, motions: &str) -> Vec<Finding> {
        self.say("validity", system, |part, u| {
            (format!("Some {motions} are outside the model of \"{part}\": {}", u.what), " reaches {}, above 1.")
        })
    }

    fn say(&self, id: &str, system: &System, text: impl Fn(&str, &Use) -> (String, &'static str)) -> Vec<Finding> {
        let one = |u: &Use| {
            let part = &system.slots()[u.slot].name;
            let (text, amount) = text(part, u);
            let finding = if u.ratio.is_finite() {
                Finding::invalid(id, text + amount).value(u.ratio, "")
            } else {
                Finding::invalid(id, text + " without bound.")
            };
            finding.of(part)
        };
        self.0.iter().filter(|u| u.outside()).map(one).collect()
    }
}
