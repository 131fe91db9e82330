//! The lanes of one thread: members in, rows out.

use super::general::General;
use super::varying::Varying;
use super::{Ended, EnsembleTask, Form, Grid, Leg, LegEnd, Next};
use crate::model::part::At;
use crate::model::system::{Drive, System, Workspace};
use crate::motion::SpinLaw;
use crate::motion::constant::Constant;
use crate::motion::one_by_one::MasslessMember;
use crate::programme::Programme;
use laval_num::ensemble::{EnsembleProblem, Seat};
use laval_num::lanes::{LANES, LaneScalar};
use std::sync::Arc;

/// A task with its types forgotten, so that the engine is compiled once: the members in the lanes of one thread.
pub(super) trait MemberSource {
    /// The next member for a lane: its state and tolerances go to the seat.
    fn board(&mut self, lane: usize, seat: &mut Seat) -> Option<(Arc<System>, SpinLaw, Leg)>;
    fn output(&mut self, lane: usize, i: u64, t: f64, y: &[f64]);
    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg>;
    fn cancelled(&self) -> bool;
}

/// The members of a task on one thread. `take` gives the next index, `keep` receives rows.
pub(super) struct RunningMembers<'a, V: EnsembleTask> {
    pub task: &'a V,
    pub logs: [Option<(usize, V::Log)>; LANES],
    pub take: &'a dyn Fn() -> Option<usize>,
    pub keep: &'a dyn Fn(usize, V::Row),
}

impl<V: EnsembleTask> MemberSource for RunningMembers<'_, V> {
    fn board(&mut self, lane: usize, seat: &mut Seat) -> Option<(Arc<System>, SpinLaw, Leg)> {
        loop {
            let index = (self.take)()?;
            match self.task.start(index) {
                Ok(start) => {
                    seat.y.copy_from_slice(&start.y);
                    seat.relative.fill(start.relative);
                    seat.absolute.copy_from_slice(&start.absolute);
                    self.logs[lane] = Some((index, start.log));
                    return Some((start.system, start.law, start.leg));
                }
                Err(row) => (self.keep)(index, row),
            }
        }
    }
    fn output(&mut self, lane: usize, i: u64, t: f64, y: &[f64]) {
        if let Some((_, log)) = &mut self.logs[lane] {
            self.task.output(log, i, t, y);
        }
    }
    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg> {
        let (index, log) = self.logs[lane].as_mut()?;
        match self.task.ended(*index, log, ended, y) {
            Next::Leg(leg) => Some(leg),
            Next::Done(row) => {
                (self.keep)(*index, row);
                self.logs[lane] = None;
                None
            }
        }
    }
    fn cancelled(&self) -> bool {
        self.task.cancelled()
    }
}

/// The equations in the form the ensemble allows.
enum Equations<'a, S> {
    Constant(Constant<'a, S>),
    Varying(Box<Varying<'a, S>>),
    General(Box<General<'a, S>>),
    OneByOne(Box<OneByOne>),
}

/// The members of a machine with coordinates without inertia, and states and rates of one of them.
struct OneByOne {
    members: [Option<MasslessMember>; LANES],
    y: Vec<f64>,
    dy: Vec<f64>,
}

impl OneByOne {
    /// Rates of all states, those of the places counted.
    #[inline(always)]
    fn rhs<S: LaneScalar>(&mut self, t: S, y: &[S], dy: &mut [S]) {
        let t = t.to_array();
        for (lane, member) in self.members.iter_mut().enumerate() {
            let Some(member) = member else { continue };
            for (to, from) in self.y.iter_mut().zip(y) {
                *to = from.to_array()[lane];
            }
            member.rates(t[lane], &self.y, &mut self.dy);
            for (to, from) in dy.iter_mut().zip(&self.dy) {
                *to = to.with(lane, *from);
            }
        }
    }
}

/// A member in its lane.
struct Aboard {
    system: Arc<System>,
    law: SpinLaw,
    leg: Leg,
    /// Outputs of the leg given before a crossing interrupted it, and since.
    given: u64,
    since: u64,
    crossings: u64,
    /// Steps of the leg accepted and rejected before the last crossing.
    steps: u64,
    rejected: u64,
}

/// Crossings of switching surfaces after which a leg is given up: a member that chatters would never end.
const MOST_CROSSINGS: u64 = 10_000_000;

pub(super) struct LaneRun<'a, S> {
    hands: &'a mut dyn MemberSource,
    equations: Equations<'a, S>,
    dim: usize,
    /// Index of the spin angle, when it is free.
    spin: Option<usize>,
    aboard: [Option<Aboard>; LANES],
    /// Switching surfaces: slot, index within the part.
    surfaces: Vec<(usize, usize)>,
    zero: Vec<f64>,
    scratch: (Workspace<f64>, Vec<f64>),
}

impl<'a, S: LaneScalar> LaneRun<'a, S> {
    pub fn new(hands: &'a mut dyn MemberSource, base: &'a System, form: Form) -> Self {
        let core = 2 * base.n() + base.m();
        let free = form == Form::Free || (form == Form::Massless && base.machine.drive == Drive::Free);
        let spin = free.then_some(core);
        let dim = core + if free { 2 } else { 0 };
        let mut lane_run = LaneRun {
            hands,
            equations: match form {
                Form::Constant => Equations::Constant(Constant::new(base)),
                Form::Varying => Equations::Varying(Box::new(Varying::new(base))),
                Form::Prescribed | Form::Free => Equations::General(Box::new(General::new(base, free))),
                Form::Massless => Equations::OneByOne(Box::new(OneByOne {
                    members: std::array::from_fn(|_| None),
                    y: vec![0.0; dim],
                    dy: vec![0.0; dim],
                })),
            },
            dim,
            spin,
            aboard: std::array::from_fn(|_| None),
            surfaces: vec![],
            zero: vec![0.0; base.n()],
            scratch: Default::default(),
        };
        let y = vec![0.0; lane_run.dim];
        for k in 0..base.slots().len() {
            let law = if spin.is_some() { SpinLaw::Free } else { SpinLaw::Programme(Programme::constant(0.0, 0.0)) };
            lane_run.evaluate_surfaces(base, &law, k, 0.0, &y);
            lane_run.surfaces.extend((0..lane_run.scratch.1.len()).map(|i| (k, i)));
        }
        lane_run
    }

    fn evaluate_surfaces(&mut self, system: &System, law: &SpinLaw, k: usize, t: f64, y: &[f64]) {
        let slot = &system.slots()[k];
        let (n, m) = (system.n(), system.m());
        let (phase, speed) = match law {
            SpinLaw::Programme(p) => (p.at(t).phase, p.at(t).speed),
            SpinLaw::Free => (y[2 * n + m], y[2 * n + m + 1]),
        };
        let at = At { q: &y[..n], v: &y[n..2 * n], a: &self.zero, z: &y[2 * n..2 * n + m], phase, speed, spin_accel: 0.0, t };
        let (workspace, out) = &mut self.scratch;
        out.clear();
        let Some(contacts) = slot.part.contacts() else { return };
        system.with_local(slot, &at, workspace, |l| contacts.switches(&system.params()[slot.params.clone()], l, out));
    }
}

impl<S: LaneScalar> EnsembleProblem<S> for LaneRun<'_, S> {
    fn dim(&self) -> usize {
        self.dim
    }

    fn positions(&self) -> usize {
        // places of coordinates without inertia have rates of their own
        if matches!(self.equations, Equations::OneByOne(_)) { 0 } else { self.zero.len() }
    }

    fn room(&self) -> usize {
        match &self.equations {
            Equations::Constant(c) => c.room(self.dim),
            Equations::Varying(v) => v.room(),
            Equations::General(_) | Equations::OneByOne(_) => 0,
        }
    }

    #[inline(always)]
    fn time(&mut self, t: S) {
        match &mut self.equations {
            Equations::Constant(c) => c.time(t),
            Equations::Varying(v) => v.time(t),
            Equations::General(g) => g.time(t),
            Equations::OneByOne(_) => {}
        }
    }

    #[inline(always)]
    fn rhs(&mut self, t: S, y: &mut [S], dy: &mut [S]) {
        match &mut self.equations {
            Equations::Constant(c) => c.rhs(t, y, dy),
            Equations::Varying(v) => v.rhs(t, y, dy),
            Equations::General(g) => g.rhs(t, y, dy),
            Equations::OneByOne(o) => o.rhs(t, y, dy),
        }
    }

    fn load(&mut self, lane: usize, mut seat: Seat) -> Option<Leg> {
        loop {
            let (system, law, leg) = self.hands.board(lane, &mut seat)?;
            if let Some(k) = self.spin {
                // an angle that grows must not loosen its own tolerance
                seat.relative[k] = 0.0;
            }
            let known = if let SpinLaw::Programme(p) = &law { p.constant_speed().map(|s| (s, p.at(0.0).phase)) } else { None };
            let loaded = match &mut self.equations {
                Equations::Constant(c) => known.is_some_and(|(speed, phase)| c.load(lane, &system, speed, phase).is_ok()),
                Equations::Varying(v) => known.map(|(speed, phase)| v.load(lane, &system, speed, phase)).is_some(),
                Equations::General(g) => {
                    g.load(lane, &system, law.clone());
                    true
                }
                Equations::OneByOne(o) => {
                    o.members[lane] = MasslessMember::new(system.clone(), law.clone(), seat.y);
                    if let Some(member) = &mut o.members[lane] {
                        member.settle(leg.t0, seat.y);
                    }
                    o.members[lane].is_some()
                }
            };
            if loaded {
                self.aboard[lane] = Some(Aboard { system, law, leg, given: 0, since: 0, crossings: 0, steps: 0, rejected: 0 });
                return Some(leg);
            }
            // a singular mass matrix, or a spin that the form does not allow
            let ended = Ended { end: LegEnd::NoStart, t: leg.t0, next_step: 0.0, steps: 0, rejected: 0 };
            let mut next = self.hands.ended(lane, &ended, seat.y);
            while let Some(leg) = next {
                next = self.hands.ended(lane, &Ended { t: leg.t0, ..ended }, seat.y);
            }
        }
    }

    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg> {
        let aboard = self.aboard[lane].as_mut()?;
        let mut ended = Ended { steps: aboard.steps + ended.steps, rejected: aboard.rejected + ended.rejected, ..*ended };
        let crosses = matches!(ended.end, LegEnd::Event(_)) && ended.t < aboard.leg.t1;
        let left = aboard.leg.max_steps.saturating_sub(ended.steps + ended.rejected);
        if crosses && left == 0 {
            ended.end = LegEnd::WorkLimit;
        } else if crosses && aboard.crossings < MOST_CROSSINGS {
            aboard.crossings += 1;
            (aboard.steps, aboard.rejected) = (ended.steps, ended.rejected);
            aboard.given += aboard.since;
            aboard.since = 0;
            let grid = aboard.leg.outputs;
            let outputs = Grid { start: grid.time(aboard.given), count: grid.count.saturating_sub(aboard.given), ..grid };
            let first_step = (ended.next_step > 0.0).then_some(ended.next_step);
            return Some(Leg { t0: ended.t, t1: aboard.leg.t1, first_step, outputs, max_steps: left });
        }
        let next = self.hands.ended(lane, &ended, y);
        match next {
            Some(leg) => {
                (aboard.leg, aboard.given, aboard.since) = (leg, 0, 0);
                (aboard.steps, aboard.rejected) = (0, 0);
            }
            None => {
                self.aboard[lane] = None;
                if let Equations::OneByOne(o) = &mut self.equations {
                    o.members[lane] = None;
                }
            }
        }
        next
    }

    fn output(&mut self, lane: usize, index: u64, t: f64, y: &[f64]) {
        if let Some(aboard) = &mut self.aboard[lane] {
            aboard.since = index + 1;
            self.hands.output(lane, aboard.given + index, t, y);
        }
    }

    fn events(&self) -> usize {
        self.surfaces.len()
    }

    fn event(&mut self, lane: usize, index: usize, t: f64, y: &[f64]) -> f64 {
        let Some(aboard) = self.aboard[lane].take() else { return f64::NAN };
        let (slot, surface) = self.surfaces[index];
        self.evaluate_surfaces(&aboard.system, &aboard.law, slot, t, y);
        self.aboard[lane] = Some(aboard);
        self.scratch.1.get(surface).copied().unwrap_or(f64::NAN)
    }

    fn cancelled(&self) -> bool {
        self.hands.cancelled()
    }
}
