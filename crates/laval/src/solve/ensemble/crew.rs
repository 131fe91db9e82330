//! The lanes of one thread: members in, rows out.

use super::constant::Constant;
use super::general::General;
use super::{Ended, Form, Grid, Leg, LegEnd, Next, Voyage};
use crate::model::part::At;
use crate::model::system::{System, Workspace};
use crate::solve::motion::SpinLaw;
use crate::solve::programme::Programme;
use laval_num::ensemble::{Crew, Seat};
use laval_num::lanes::{LANES, LaneScalar};
use std::sync::Arc;

/// The equations in the form the ensemble allows.
enum Equations<'a, S> {
    Constant(Constant<'a, S>),
    General(General<'a, S>),
}

/// A member in its lane.
struct Rider<T> {
    index: usize,
    system: Arc<System>,
    law: SpinLaw,
    log: T,
    leg: Leg,
    /// Outputs of the leg given before a crossing interrupted it.
    given: u64,
    /// Outputs given since.
    since: u64,
}

/// Crossings of switching surfaces after which a leg is given up: a member that chatters would never end.
const MOST_CROSSINGS: u64 = 10_000_000;

pub(super) struct LaneCrew<'a, S, V: Voyage, T, K> {
    voyage: &'a V,
    base: &'a System,
    equations: Equations<'a, S>,
    free: bool,
    riders: [Option<Rider<V::Log>>; LANES],
    /// Switching surfaces: slot, index within the part.
    surfaces: Vec<(usize, usize)>,
    crossings: [u64; LANES],
    zero: Vec<f64>,
    scratch: (Workspace<f64>, Vec<f64>),
    take: T,
    keep: K,
}

impl<'a, S: LaneScalar, V: Voyage, T: FnMut() -> Option<usize>, K: FnMut(usize, V::Row)> LaneCrew<'a, S, V, T, K> {
    pub fn new(voyage: &'a V, base: &'a System, form: Form, take: T, keep: K) -> Self {
        let mut crew = LaneCrew {
            voyage,
            base,
            equations: match form {
                Form::Constant => Equations::Constant(Constant::new(base)),
                Form::Prescribed => Equations::General(General::new(base, false)),
                Form::Free => Equations::General(General::new(base, true)),
            },
            free: form == Form::Free,
            riders: std::array::from_fn(|_| None),
            surfaces: vec![],
            crossings: [0; LANES],
            zero: vec![0.0; base.n()],
            scratch: Default::default(),
            take,
            keep,
        };
        let y = vec![0.0; crew.dim()];
        let still = SpinLaw::Programme(Programme::constant(0.0, 0.0));
        for k in 0..base.slots().len() {
            crew.evaluate_surfaces(base, if crew.free { &SpinLaw::Free } else { &still }, k, 0.0, &y);
            crew.surfaces.extend((0..crew.scratch.1.len()).map(|i| (k, i)));
        }
        crew
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
        system.with_local(slot, &at, workspace, |l| slot.part.switches(&system.params()[slot.params.clone()], l, out));
    }

    fn finish(&mut self, lane: usize, row: V::Row) {
        if let Some(rider) = self.riders[lane].take() {
            (self.keep)(rider.index, row);
        }
    }
}

impl<S: LaneScalar, V: Voyage, T: FnMut() -> Option<usize>, K: FnMut(usize, V::Row)> Crew<S> for LaneCrew<'_, S, V, T, K> {
    fn dim(&self) -> usize {
        2 * self.base.n() + self.base.m() + 2 * usize::from(self.free)
    }

    #[inline(always)]
    fn rhs(&mut self, t: S, y: &[S], dy: &mut [S]) {
        match &mut self.equations {
            Equations::Constant(c) => c.rhs(t, y, dy),
            Equations::General(g) => g.rhs(t, y, dy),
        }
    }

    fn load(&mut self, lane: usize, seat: Seat) -> Option<Leg> {
        loop {
            let index = (self.take)()?;
            let start = match self.voyage.start(index) {
                Ok(start) => start,
                Err(row) => {
                    (self.keep)(index, row);
                    continue;
                }
            };
            seat.y.copy_from_slice(&start.y);
            seat.relative.fill(start.relative);
            seat.absolute.copy_from_slice(&start.absolute);
            if self.free {
                // an angle that grows must not loosen its own tolerance
                let k = 2 * self.base.n() + self.base.m();
                seat.relative[k] = 0.0;
            }
            let mut rider =
                Rider { index, system: start.system, law: start.law, log: start.log, leg: start.leg, given: 0, since: 0 };
            let loaded = match &mut self.equations {
                Equations::Constant(c) => {
                    let constant = |p: &Programme| Some((p.constant_speed()?, p.at(0.0).phase));
                    let known = if let SpinLaw::Programme(p) = &rider.law { constant(p) } else { None };
                    let (speed, phase) = known.unwrap_or((f64::NAN, 0.0));
                    c.load(lane, &rider.system, speed, phase).is_ok()
                }
                Equations::General(g) => {
                    g.load(lane, &rider.system, rider.law.clone());
                    true
                }
            };
            self.crossings[lane] = 0;
            if loaded {
                let leg = rider.leg;
                self.riders[lane] = Some(rider);
                return Some(leg);
            }
            let ended = Ended { end: LegEnd::NoStart, t: rider.leg.t0, next_step: 0.0, steps: 0, rejected: 0 };
            if let Next::Done(row) = self.voyage.ended(index, &mut rider.log, &ended, seat.y) {
                (self.keep)(index, row);
            }
        }
    }

    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg> {
        let rider = self.riders[lane].as_mut()?;
        if matches!(ended.end, LegEnd::Event(_)) && self.crossings[lane] < MOST_CROSSINGS && ended.t < rider.leg.t1 {
            self.crossings[lane] += 1;
            rider.given += rider.since;
            rider.since = 0;
            let grid = rider.leg.outputs;
            let outputs = Grid { start: grid.time(rider.given), count: grid.count.saturating_sub(rider.given), ..grid };
            let first_step = (ended.next_step > 0.0).then_some(ended.next_step);
            return Some(Leg { t0: ended.t, t1: rider.leg.t1, first_step, outputs, ..rider.leg });
        }
        match self.voyage.ended(rider.index, &mut rider.log, ended, y) {
            Next::Leg(leg) => {
                (rider.leg, rider.given, rider.since) = (leg, 0, 0);
                Some(leg)
            }
            Next::Done(row) => {
                self.finish(lane, row);
                None
            }
        }
    }

    fn output(&mut self, lane: usize, index: u64, t: f64, y: &[f64]) {
        if let Some(rider) = &mut self.riders[lane] {
            rider.since = index + 1;
            self.voyage.output(&mut rider.log, rider.given + index, t, y);
        }
    }

    fn events(&self) -> usize {
        self.surfaces.len()
    }

    fn event(&mut self, lane: usize, index: usize, t: f64, y: &[f64]) -> f64 {
        let Some(rider) = self.riders[lane].take() else { return f64::NAN };
        let (slot, surface) = self.surfaces[index];
        self.evaluate_surfaces(&rider.system, &rider.law, slot, t, y);
        self.riders[lane] = Some(rider);
        self.scratch.1.get(surface).copied().unwrap_or(f64::NAN)
    }

    fn cancelled(&self) -> bool {
        self.voyage.cancelled()
    }
}
