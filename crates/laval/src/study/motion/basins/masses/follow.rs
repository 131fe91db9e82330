//! Motions followed until the masses have come to rest in turning axes or go on moving alike, or until it is known where they end.
//!
//! A leg is a whole number of turns, so that each ends at phase zero. At its end the motion is compared with the attractors that are known. It has ended in a
//! stable state at rest when it comes nearer and is within [`DEEP`] of it; elsewhere at rest when it does not stir for some windows; in motion when the mean slip rates of the last windows
//! agree.

use super::known::{KnownAttractors, MassKind};
use crate::model::system::System;
use crate::solve::ensemble::{self, Ended, EnsembleTask, Leg, LegEnd, Next, Start};
use crate::solve::motion::SpinLaw;
use crate::solve::programme::{Programme, Shape};
use crate::solve::stationary::metric::Metric;
use crate::study::motion::steady_state::{Budget, words};
use crate::study::shared::support::larger;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Turns between two looks.
const LEG: u64 = 8;
/// Looks of a window over which slip rates are averaged.
const WINDOW: usize = 16;
/// Windows that must agree.
const WINDOWS: usize = 4;
/// Distance from a stable state within which a motion that comes nearer has ended there.
const DEEP: f64 = 1e-3;
/// Stir of a motion that has come to rest.
const STILL: f64 = 1e-4;
/// Distance within which a motion that has come to rest is at a known state.
const AT: f64 = 1e-2;
/// Mean slip rate over the speed of masses that go round.
const ROUND: f64 = 1e-2;
/// Change of mean slip rates over the speed, and share of the mean displacement, within which windows agree.
const ALIKE: (f64, f64) = (2e-3, 0.1);
/// Most steps of a turn.
const MOST_STEPS: u64 = 100_000;
/// Displacements over their typical size beyond which a motion has left every machine.
const RUNAWAY: f64 = 1e6;

/// Where a motion ended.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Goal {
    /// On an attractor of the known ones.
    Known(usize),
    /// At rest in turning axes, at none of the states of the known ones.
    Resting,
    /// Moving on, like none of the known ones.
    Moving,
    /// Not settled in the time given.
    Unsettled,
    /// Not followed.
    Failed(&'static str),
}

/// What became of a motion.
#[derive(Clone, Debug)]
pub(super) struct Course {
    pub goal: Goal,
    /// The first attractor it came so near that it would be recognised by it.
    pub recognised: Option<usize>,
    /// Nearest it came to each attractor.
    pub nearest: Vec<f64>,
    /// Mean slip rates over the speed in the last window, in rising order within each group; none before the first.
    pub slip: Vec<f64>,
    /// Mean size and largest stir in the last window.
    pub extent: (f64, f64),
    pub turns: u64,
    pub steps: u64,
    /// State (q, v, z) at its end.
    pub y: Vec<f64>,
    /// What was seen of it over the last window.
    pub tail: Vec<Vec<f64>>,
}

#[derive(Default)]
pub(super) struct Log {
    /// Time of the last look, s.
    t: f64,
    running_up: bool,
    turns: u64,
    steps: u64,
    recognised: Option<usize>,
    nearest: Vec<f64>,
    last: Vec<f64>,
    /// Angles where the window began.
    begin: Vec<f64>,
    seen: Vec<Vec<f64>>,
    /// Of windows: slip rates over the speed, mean size, largest stir.
    windows: Vec<(Vec<f64>, f64, f64)>,
}

/// Where a motion begins.
pub(super) struct Begin {
    /// State (q, v, z).
    pub y: Vec<f64>,
    /// Duration of a run-up from standstill at constant acceleration, s; at speed from the start where there is none.
    pub run_up: Option<f64>,
}

pub(super) struct Follow<'a> {
    pub system: &'a Arc<System>,
    pub metric: &'a Metric,
    pub speed: f64,
    pub starts: &'a [Begin],
    pub relative: f64,
    pub absolute: f64,
    pub most_turns: u64,
    pub known: &'a KnownAttractors,
    /// A motion whose end is recognised stops there.
    pub early: bool,
    pub budget: &'a Budget,
    pub done: &'a (dyn Fn() + Sync),
    pub cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl Follow<'_> {
    fn leg(&self, log: &Log, first_step: Option<f64>) -> Leg {
        let turns = LEG.min(self.most_turns.saturating_sub(log.turns)).max(1);
        let t1 = log.t + turns as f64 * TAU / self.speed;
        self.budget.leg(Leg { first_step, max_steps: MOST_STEPS * turns, ..Leg::new(log.t, t1) })
    }

    fn angles(&self, y: &[f64]) -> Vec<f64> {
        self.metric.images.angles.iter().map(|&i| y[i]).collect()
    }

    fn failed(log: &mut Log, why: &'static str, y: &[f64]) -> Course {
        Self::kept(log, Goal::Failed(why), y)
    }

    fn course(log: &mut Log, goal: Goal, y: &[f64]) -> Next<Course> {
        Next::Done(Self::kept(log, goal, y))
    }

    fn kept(log: &mut Log, goal: Goal, y: &[f64]) -> Course {
        Course {
            goal,
            recognised: log.recognised,
            nearest: std::mem::take(&mut log.nearest),
            slip: log.windows.last().map(|w| w.0.clone()).unwrap_or_default(),
            extent: log.windows.last().map_or((f64::NAN, f64::NAN), |w| (w.1, w.2)),
            turns: log.turns,
            steps: log.steps,
            y: y.to_vec(),
            tail: std::mem::take(&mut log.seen),
        }
    }

    /// What a motion that is at this state now has come to, as far as that shows.
    fn look(&self, log: &mut Log, seen: &[f64]) -> Option<Goal> {
        let distances = self.known.distances(self.metric, seen, self.early);
        for (near, &d) in log.nearest.iter_mut().zip(&distances) {
            *near = near.min(d);
        }
        let within = self.known.attractors.iter().zip(&distances).position(|(a, &d)| d <= a.radius);
        log.recognised = log.recognised.or(within);
        let before = std::mem::replace(&mut log.last, distances);
        if self.early && log.recognised.is_some() {
            return log.recognised.map(Goal::Known);
        }
        let deep = |k: usize| {
            let stable = matches!(self.known.attractors[k].kind, MassKind::Rest { stable: true, .. });
            stable && log.last[k] <= DEEP && before.get(k).is_some_and(|b| log.last[k] < *b)
        };
        (0..log.last.len()).find(|&k| deep(k)).map(Goal::Known)
    }

    /// The same at the end of a window.
    fn assess(&self, log: &Log) -> Option<Goal> {
        let last = log.windows.last()?;
        let recent = &log.windows[log.windows.len().saturating_sub(WINDOWS)..];
        if recent.len() < WINDOWS || log.windows.len() == WINDOWS {
            return None;
        }
        if recent.iter().all(|w| w.2 <= STILL) {
            return Some(log.last.iter().position(|d| *d <= AT).map_or(Goal::Resting, Goal::Known));
        }
        if self.early
            && let Some(k) = self.known.swinging(recent, ROUND)
        {
            return Some(Goal::Known(k));
        }
        let alike = |w: &(Vec<f64>, f64, f64)| {
            w.0.iter().zip(&last.0).all(|(a, b)| (a - b).abs() <= ALIKE.0) && (w.1 - last.1).abs() <= ALIKE.1 * last.1
        };
        let round = last.0.iter().any(|s| s.abs() > ROUND);
        (round && recent.iter().all(alike)).then(|| self.known.moving(&last.0).map_or(Goal::Moving, Goal::Known))
    }

    /// The time is up: masses that swing alike have ended, others have not.
    fn last_word(&self, log: &Log) -> Goal {
        let windows = &log.windows;
        let half = &windows[windows.len() / 2..];
        let mean = |w: &[(Vec<f64>, f64, f64)]| w.iter().map(|w| w.2).sum::<f64>() / w.len() as f64;
        let (first, second) = half.split_at(half.len() / 2);
        let swings = first.len() >= WINDOWS && (mean(first) / mean(second) - 1.0).abs() <= ALIKE.1;
        let slip = windows.last().filter(|w| swings && w.0.iter().all(|s| s.abs() <= ROUND)).map(|w| &w.0);
        slip.map_or(Goal::Unsettled, |s| self.known.moving(s).map_or(Goal::Moving, Goal::Known))
    }
}

impl EnsembleTask for Follow<'_> {
    type Log = Log;
    type Row = Course;

    fn start(&self, index: usize) -> Result<Start<Log>, Course> {
        let Begin { y, run_up } = &self.starts[index];
        let nearest = vec![f64::INFINITY; self.known.attractors.len()];
        let mut log = Log { begin: self.angles(y), nearest, ..Log::default() };
        let mut leg = self.leg(&log, None);
        let mut programme = Programme::constant(self.speed, 0.0);
        if let Some(d) = *run_up {
            // the run-up ends at phase zero
            let half = 0.5 * self.speed * d;
            let Ok(ramp) = Programme::ramp(0.0, self.speed, d, Shape::Linear, -half) else {
                return Err(Self::failed(&mut log, "has no run-up", y));
            };
            programme = ramp;
            log.running_up = true;
            let turns = (half / TAU).ceil().max(1.0) as u64;
            leg = self.budget.leg(Leg { max_steps: MOST_STEPS.saturating_mul(turns), ..Leg::new(0.0, d) });
        }
        Ok(Start {
            system: self.system.clone(),
            law: SpinLaw::Programme(programme),
            leg,
            y: y.clone(),
            relative: self.relative,
            absolute: ensemble::tolerances(self.system, self.speed, self.absolute),
            log,
        })
    }

    fn ended(&self, _: usize, log: &mut Log, ended: &Ended, y: &mut [f64]) -> Next<Course> {
        self.budget.spend(ended);
        log.steps += ended.steps + ended.rejected;
        if ended.end != LegEnd::Reached {
            return Next::Done(Self::failed(log, words(ended.end), y));
        }
        let coordinates = self.system.coordinates();
        let bodies = (0..self.system.n()).filter(|i| !self.metric.images.angles.contains(i));
        if !bodies.into_iter().all(|i| y[i].abs() <= RUNAWAY * coordinates[i].dof.typical) {
            return Next::Done(Self::failed(log, "grows without bound", y));
        }
        if std::mem::take(&mut log.running_up) {
            log.t = ended.t;
            log.begin = self.angles(y);
            return Next::Leg(self.leg(log, Some(ended.next_step)));
        }
        log.turns += ((ended.t - log.t) * self.speed / TAU).round() as u64;
        log.t = ended.t;
        let seen = self.metric.seen(y);
        if log.seen.len() == WINDOW {
            log.seen.clear();
        }
        let goal = self.look(log, &seen);
        log.seen.push(seen);
        if let Some(goal) = goal {
            return Self::course(log, goal, y);
        }
        if log.seen.len() == WINDOW {
            let now = self.angles(y);
            let turned = WINDOW as f64 * LEG as f64 * TAU;
            let slip: Vec<f64> = now.iter().zip(&log.begin).map(|(a, b)| (a - b) / turned).collect();
            let size = log.seen.iter().map(|s| self.metric.size(s)).sum::<f64>() / WINDOW as f64;
            let stir = log.seen.iter().map(|s| self.metric.stir(s)).fold(0.0, larger);
            log.windows.push((self.metric.sorted(&slip), size, stir));
            log.begin = now;
            if let Some(goal) = self.assess(log) {
                return Self::course(log, goal, y);
            }
        }
        if log.turns >= self.most_turns {
            let goal = self.last_word(log);
            return Self::course(log, goal, y);
        }
        Next::Leg(self.leg(log, Some(ended.next_step)))
    }

    fn finished(&self) {
        (self.done)();
    }

    fn cancelled(&self) -> bool {
        self.budget.used_up() || (self.cancelled)()
    }
}
