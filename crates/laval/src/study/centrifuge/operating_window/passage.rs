//! The way up through the resonances, and down again: largest displacements and torque up to every speed. Simulated to the top of the range and back.

use super::detail::Detail;
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::model::timed::Speeds;
use crate::solve::motion::envelope::Window;
use crate::solve::motion::trajectory::{Choice, Plan, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::solve::programme::{Programme, Shape};
use crate::study::Context;
use crate::study::motion::start::Start;
use crate::study::shared::limits::Limits;
use crate::study::shared::support::largest;
use crate::text;
use laval_num::ode::End;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// What happens on the way to a speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Passage {
    /// Names of the bodies.
    pub bodies: Vec<String>,
    /// Points beside the reference points.
    pub points: Vec<Probe>,
    /// Up and down, each from the lowest speed on.
    pub ways: [Vec<Stretch>; 2],
    /// Steps of the integration.
    pub steps: u64,
}

/// A stretch of the way.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Stretch {
    /// Its lowest and its highest speed, rad/s.
    pub speeds: (f64, f64),
    /// Largest displacement of each body, m, and the speed it happens at.
    pub moved: Vec<(f64, f64)>,
    /// The same of each point beside the reference points.
    pub aside: Vec<(f64, f64)>,
    /// Torque of the drive, N m.
    pub torque: f64,
}

/// The largest displacement of a body on one way.
pub(super) struct Peak {
    pub body: String,
    pub up: bool,
    pub displacement: f64,
    pub speed: f64,
}

const WINDOWS: usize = 300;
/// Parts of the way that progress distinguishes.
const PARTS: f64 = 1e6;

impl Passage {
    /// Simulates both ways; `duration` is the time to the top speed. `None` when it was stopped, or the work limit ended it.
    pub(super) fn simulate(system: &System, top: f64, duration: f64, context: &Context) -> Result<Option<Self>, Diagnostic> {
        context.announce(duration * top / TAU, 1e5, text!("turns of the rotor to integrate in the simulation of the passage"));
        let reported = |share: f64| context.progress.report((share * PARTS) as u64, PARTS as u64);
        let Some((ways, steps)) = both_ways(system, (top, duration), context, &reported)? else { return Ok(None) };
        let points = system.probes().iter().filter(|p| !p.is_tilt() && !p.is_reference()).cloned().collect();
        Ok(Some(Passage { bodies: system.stations().iter().map(|s| s.name.clone()).collect(), points, ways, steps }))
    }

    /// Stretches of a way up to a speed.
    fn stretches(&self, way: usize, speed: f64) -> impl Iterator<Item = &Stretch> {
        self.ways[way].iter().filter(move |s| s.speeds.0 <= speed)
    }

    /// Largest displacement of each body on the way up to a speed and down again.
    pub(super) fn peaks(&self, speed: f64) -> Vec<Peak> {
        let of = |k: usize| self.largest(speed, move |s| s.moved.get(k).copied());
        let one = |(k, body): (usize, &String)| -> Vec<Peak> {
            let peak = |(up, at): (bool, (f64, f64))| Peak { body: body.clone(), up, displacement: at.0, speed: at.1 };
            of(k).map(peak).collect()
        };
        let mut out: Vec<Peak> = self.bodies.iter().enumerate().flat_map(one).collect();
        out.sort_by_key(|p| !p.up);
        out
    }

    /// On the way up to a speed, and down again, the largest of a displacement with its speed; NaN before all.
    fn largest<'s>(
        &'s self,
        speed: f64,
        of: impl Fn(&Stretch) -> Option<(f64, f64)> + Copy + 's,
    ) -> impl Iterator<Item = (bool, (f64, f64))> + 's {
        [(0, true), (1, false)].into_iter().filter_map(move |(way, up)| {
            let moved = self.stretches(way, speed).filter_map(of);
            Some((up, moved.reduce(|a, b| if b.0 > a.0 || b.0.is_nan() { b } else { a })?))
        })
    }

    /// Largest torque of the way to a speed and back, N m; NaN stays.
    pub fn torque(&self, speed: f64) -> f64 {
        let both = self.stretches(0, speed).chain(self.stretches(1, speed));
        largest(both.map(|s| s.torque))
    }

    /// Displacement of each body when the run-up passes a speed, m.
    pub fn reached(&self, speed: f64) -> Option<Vec<f64>> {
        let stretch = self.stretches(0, speed).last()?;
        Some(stretch.moved.iter().map(|m| m.0).collect())
    }

    /// Margin of the passage to a speed and back.
    pub(super) fn margin(&self, speed: f64, limits: &Limits) -> (f64, Detail) {
        let mut worst = (f64::INFINITY, Detail::Passage);
        for limit in &limits.passage {
            let body = self.bodies.iter().position(|b| *b == limit.body);
            let point = self.points.iter().position(|p| limit.is_at(p));
            let of = move |s: &Stretch| match (point, body) {
                (Some(k), _) => s.aside.get(k).copied(),
                (None, Some(k)) => s.moved.get(k).copied(),
                _ => None,
            };
            for (_, (displacement, speed)) in self.largest(speed, of) {
                let m = 1.0 - displacement / limit.value;
                if !(m >= worst.0) {
                    worst = (m, Detail::Moved { of: limit.name.clone(), speed });
                }
            }
        }
        if let Some(limit) = limits.torque {
            let m = 1.0 - self.torque(speed) / limit;
            if !(m >= worst.0) {
                worst = (m, Detail::Torque);
            }
        }
        if worst.0 == f64::INFINITY { (1.0, worst.1) } else { worst }
    }
}

/// Steps of each way at most.
const STEPS: u64 = 20_000_000;

/// The stretches of the ways up and down, and the steps of both.
type BothWays = ([Vec<Stretch>; 2], u64);

/// Up from rest to the top speed and down again, and the steps it took; `None` when it was stopped, or the work limit ended it.
fn both_ways(
    system: &System,
    (top, duration): (f64, f64),
    context: &Context,
    reported: &dyn Fn(f64),
) -> Result<Option<BothWays>, Diagnostic> {
    let timed = system.timed(Speeds::Changing)?;
    let system: &System = &timed;
    let mut ways = [vec![], vec![]];
    let mut steps = 0;
    let mut state: Option<(Vec<f64>, f64)> = None;
    for (way, (from, to)) in ways.iter_mut().zip([(0.0, top), (top, 0.0)]) {
        let behind = if to < from { 0.5 } else { 0.0 };
        let phase = state.as_ref().map_or(0.0, |s| s.1);
        let programme = Programme::ramp(from, to, duration, Shape::Linear, phase)
            .map_err(|e| Diagnostic::error("operating_window.ramp", e.0).help(text!("give the ramp another duration")))?;
        let mut motion = Motion::new(system, SpinLaw::Programme(programme.clone()))?;
        let start = Start::new(system, from);
        let y = state.take().map_or_else(
            || {
                let mut y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
                start.write(&[], &mut y);
                y
            },
            |s| s.0,
        );
        let outputs: Vec<f64> = (0..=WINDOWS).map(|k| duration * k as f64 / WINDOWS as f64).collect();
        let plan = Plan {
            t_end: duration,
            choice: Choice::Auto,
            // the peaks hold to about five digits
            relative: 1e-6,
            absolute: 1e-8,
            outputs: &outputs,
            windows: WINDOWS,
            rest: &start.rest,
            bound: f64::INFINITY,
            kick: None,
            max_steps: context.work_limit.min(STEPS),
            cancel: &|| context.cancelled(),
            progress: &|t| reported(behind + 0.5 * t / duration),
        };
        let trajectory = simulate(&mut motion, &y, &plan)?;
        steps += trajectory.run.work.steps;
        let limited = matches!(trajectory.run.end, End::WorkLimit { .. }) && context.work_limit < STEPS;
        if limited || context.cancelled() {
            return Ok(None);
        }
        if trajectory.run.end != End::Reached {
            return Err(Diagnostic::error(
                "operating_window.passage",
                text!(
                    "the passage could not be computed beyond {speed}",
                    speed = text::quantity(programme.at(trajectory.run.t).speed, "rad/s")
                ),
            )
            .help(text!("shorten the ramp or the range of speeds; a machine that is unstable below the window may move without bound")));
        }
        let dim = trajectory.state.len();
        let mut torques = Vec::new();
        for (&t, y) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)) {
            torques.push(motion.torque(t, y).unwrap_or(f64::NAN).abs());
        }
        for k in 0..WINDOWS {
            let [a, b] = [k, k + 1].map(|i| programme.at(duration * i as f64 / WINDOWS as f64).speed);
            let peak = |w: &Vec<Window>| (w[k].peak.amplitude, programme.at(w[k].peak.t).speed);
            let moved = trajectory.windows.iter().map(peak).collect();
            let aside = trajectory.points.iter().map(|p| peak(&p.1)).collect();
            let torque = torques.get(k).copied().unwrap_or(f64::NAN);
            way.push(Stretch { speeds: (a.min(b), a.max(b)), moved, aside, torque });
        }
        // from the lowest speed on, both ways
        if to < from {
            way.reverse();
        }
        state = Some((trajectory.state, programme.at(duration).phase));
    }
    Ok(Some((ways, steps)))
}
