//! The way up through the resonances, and down again: largest displacements and torque up to every speed.
//!
//! One simulation up to the top of the range and one down, with the load of the cups at the top, where their unbalance is largest.

use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::motion::flight::{Choice, Plan, fly};
use crate::solve::motion::{Motion, SpinLaw};
use crate::solve::programme::{Programme, Shape};
use crate::study::Context;
use crate::study::limits::Limits;
use laval_num::ode::End;

/// What happens on the way to a speed.
#[derive(Clone)]
pub(super) struct Passage {
    bodies: Vec<String>,
    /// By window: speed reached, largest displacement of each body in it, largest torque.
    windows: Vec<(f64, Vec<f64>, f64)>,
    /// Displacement of each body over all windows, and the speed it happens at.
    pub peaks: Vec<(String, f64, f64)>,
    /// Largest torque, N m.
    pub torque: f64,
    /// Steps of both integrations.
    pub steps: u64,
}

const WINDOWS: usize = 300;

impl Passage {
    /// Simulates both ways; `duration` is the time to the top speed.
    pub fn simulate(system: &System, top: f64, duration: f64, context: &Context) -> Result<Self, Diagnostic> {
        let bodies: Vec<String> = system.bodies().into_iter().map(|b| b.name).collect();
        let mut out = Passage { bodies, windows: vec![], peaks: vec![], torque: 0.0, steps: 0 };
        let mut state: Option<(Vec<f64>, f64)> = None;
        for (from, to) in [(0.0, top), (top, 0.0)] {
            let phase = state.as_ref().map_or(0.0, |s| s.1);
            let programme = Programme::ramp(from, to, duration, Shape::Linear, phase)
                .map_err(|e| Diagnostic::error("operating_window.ramp", e.0).help("give the ramp another duration"))?;
            let mut motion = Motion::new(system, SpinLaw::Programme(programme.clone()))?;
            let y = state.take().map_or_else(|| vec![0.0; laval_num::ode::Ode::dim(&motion)], |s| s.0);
            let outputs: Vec<f64> = (0..=WINDOWS).map(|k| duration * k as f64 / WINDOWS as f64).collect();
            let plan = Plan {
                t_end: duration,
                choice: Choice::Auto,
                relative: 1e-7,
                absolute: 1e-9,
                outputs: &outputs,
                windows: WINDOWS,
                rest: &[],
                kick: None,
                max_steps: context.work_limit.min(20_000_000),
                cancel: &|| context.cancelled(),
                progress: &|_| (),
            };
            let flight = fly(&mut motion, &y, &plan)?;
            out.steps += flight.run.work.steps;
            if flight.run.end != End::Reached {
                return Err(Diagnostic::error(
                    "operating_window.passage",
                    format!("the passage could not be computed beyond {:.5} rad/s", programme.at(flight.run.t).speed),
                )
                .help("shorten the ramp or the range of speeds; a machine that is unstable below the window may move without bound"));
            }
            let dim = flight.state.len();
            let mut torques = Vec::new();
            for (&t, y) in flight.times.iter().zip(flight.states.chunks_exact(dim)) {
                torques.push(motion.torque(t, y).unwrap_or(f64::NAN).abs());
            }
            for k in 0..WINDOWS {
                let ends = [k, k + 1].map(|i| programme.at(duration * i as f64 / WINDOWS as f64).speed);
                let amplitudes: Vec<f64> = flight.windows.iter().map(|w| w[k].peak.amplitude).collect();
                let torque = torques.get(k).copied().unwrap_or(f64::NAN);
                out.windows.push((ends[0].min(ends[1]), amplitudes, torque));
            }
            for (name, p) in out.bodies.iter().zip(&flight.peaks) {
                out.peaks.push((name.clone(), p.amplitude, programme.at(p.t).speed));
            }
            // NaN stays
            out.torque = torques.into_iter().fold(out.torque, |m, x| if x > m || x.is_nan() { x } else { m });
            state = Some((flight.state, programme.at(duration).phase));
        }
        Ok(out)
    }

    /// Margin of the passage to a speed and back.
    pub fn margin(&self, speed: f64, limits: &Limits) -> (f64, String) {
        let mut worst = (f64::INFINITY, "passage".to_string());
        for (from, amplitudes, torque) in self.windows.iter().filter(|w| w.0 <= speed) {
            let of = |name: &str| self.bodies.iter().position(|b| b == name).and_then(|k| amplitudes.get(k).copied());
            let moved = limits.passage.iter().filter_map(|l| of(&l.name).map(|a| (1.0 - a / l.value, &l.name)));
            for (m, name) in moved {
                if !(m >= worst.0) {
                    worst = (m, format!("displacement of {name} at {from:.4} rad/s"));
                }
            }
            if let Some(limit) = limits.torque
                && !(1.0 - torque / limit >= worst.0)
            {
                worst = (1.0 - torque / limit, format!("torque at {from:.4} rad/s"));
            }
        }
        if worst.0 == f64::INFINITY { (1.0, worst.1) } else { worst }
    }
}
