//! Time integration of many members at once, in lanes, each with its own time, step and end; a lane whose member is finished takes the
//! next one from the queue, so that no member waits for another.
//!
//! An [`EnsembleProblem`] supplies the equations and the members; [`run`] integrates until the problem has no more members. Within a lane every operation depends on
//! that lane alone, so the bits of a member do not depend on its neighbours, on the lane it rides in, or on the processor level.

mod dop853;
mod inside;
mod method;
mod rodas;
#[cfg(test)]
mod tests;

use crate::lanes::{Bits, LANES, LaneScalar, Routine};
use crate::ode::Cause;
use crate::work::spend;
use dop853::Dop853;
use inside::Inside;
use method::Method;
use rodas::Rodas;
use std::marker::PhantomData;

/// A stretch of time that a lane integrates without interruption.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Start.
    pub t0: f64,
    /// End, later than the start.
    pub t1: f64,
    /// Length of the first step; chosen from the problem if absent.
    pub first_step: Option<f64>,
    /// Outputs wanted.
    pub outputs: Grid,
    /// Most steps, accepted and rejected together.
    pub max_steps: u64,
}

/// Equidistant times `start + i step` for `i < count`; those after the end of the leg are not reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Grid {
    /// First time.
    pub start: f64,
    /// Distance.
    pub step: f64,
    /// Number.
    pub count: u64,
}

impl Grid {
    /// Time of output `i`.
    pub fn time(&self, i: u64) -> f64 {
        self.start + i as f64 * self.step
    }
}

impl Leg {
    /// From `t0` to `t1`, without outputs, ten million steps.
    pub fn new(t0: f64, t1: f64) -> Self {
        Leg { t0, t1, first_step: None, outputs: Grid::default(), max_steps: 10_000_000 }
    }
}

/// What a lane needs to begin with a member.
#[derive(Debug)]
pub struct Seat<'a> {
    /// State.
    pub y: &'a mut [f64],
    /// Relative tolerance of each state.
    pub relative: &'a mut [f64],
    /// Absolute tolerance of each state, in its unit.
    pub absolute: &'a mut [f64],
}

/// How a leg ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LegEnd {
    /// At its end.
    Reached,
    /// A crossing for which [`EnsembleProblem::crossed`] said so: index of the event.
    Event(usize),
    /// No step above the resolution of time succeeded.
    StepTooSmall(Cause),
    /// [`Leg::max_steps`] is used up.
    WorkLimit,
    /// The equations or the tolerances are not finite at the start, or the leg has no length.
    NoStart,
}

/// A leg that ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ended {
    /// How.
    pub end: LegEnd,
    /// When.
    pub t: f64,
    /// Length of the step that the control would take next.
    pub next_step: f64,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
}

/// Equations y' = f(t, y) for the members in the lanes, and where members come from and go.
pub trait EnsembleProblem<S: LaneScalar> {
    /// Number of states.
    fn dim(&self) -> usize;
    /// Number p of positions: the first p states, whose rates are the p states behind them.
    fn positions(&self) -> usize {
        0
    }
    /// Number of scratch entries wanted behind the states.
    fn room(&self) -> usize {
        0
    }
    /// What of the right side depends on time alone, as sines of phases: called before [`EnsembleProblem::rhs`] with its time, ahead of the arithmetic that
    /// gives its states, so that a processor does both side by side. Inlined like `rhs`.
    fn time(&mut self, t: S);
    /// The right side in all lanes, each at its own time, but for the positions: `dy` holds the rates of the states behind them. `y` are the
    /// states and [`EnsembleProblem::room`] entries for any use. Must be `#[inline(always)]`, as must what it calls. A lane without a member, or one whose member is failing, may hold any values.
    fn rhs(&mut self, t: S, y: &mut [S], dy: &mut [S]);
    /// Puts the next member into `lane`, its parameters into the equations. `None` when there is no more.
    fn load(&mut self, lane: usize, seat: Seat) -> Option<Leg>;
    /// A leg of the member in `lane` has ended in the state `y`, which may be changed. `Some` continues the member, `None` ends it.
    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg>;
    /// The state at output `index` of the leg.
    fn output(&mut self, _lane: usize, _index: u64, _t: f64, _y: &[f64]) {}
    /// Number of events: functions g(t, y) whose changes of sign are located in every step (probed at four points).
    fn events(&self) -> usize {
        0
    }
    /// Value of an event.
    fn event(&mut self, _lane: usize, _index: usize, _t: f64, _y: &[f64]) -> f64 {
        f64::NAN
    }
    /// An event has changed its sign at `t`; `true` ends the leg there.
    fn crossed(&mut self, _lane: usize, _index: usize, _t: f64, _y: &[f64]) -> bool {
        true
    }
    /// Polled between steps; `true` leaves all members where they are.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Bookkeeping of the lanes.
struct Roster<S> {
    t: S,
    /// Proposed length of the next step.
    next: S,
    t_end: S,
    shortest: S,
    /// Time of the next output, infinite when there is none.
    next_output: [f64; LANES],
    output: [u64; LANES],
    legs: [Leg; LANES],
    steps: [u64; LANES],
    rejected: [u64; LANES],
    /// Lanes with a member.
    active: Bits,
    /// Lanes whose derivative at the start is still to be computed.
    fresh: Bits,
    /// Lanes whose last attempt was rejected.
    repeated: Bits,
}

/// Steps between questions whether to cancel.
const PATIENCE: u32 = 64;

/// Integrates all members of the problem with the explicit method of order 8, 8(5,3) of Dormand and Prince; dense output of order 7.
///
/// The local error is kept as in [`crate::ode::Control`]; the step control is proportional, with no memory but that of a rejection.
/// Returns `false` when cancelled.
#[inline(always)]
pub fn run<S: LaneScalar, C: EnsembleProblem<S>>(problem: &mut C) -> bool {
    S::apart(Travel { problem, method: PhantomData::<(S, Dop853<S>)> })
}

/// The same with an implicit method of order 5, stiffly accurate and L-stable: Rodas5P of G. Steinebach, BIT Numer. Math. 63 (2023) 27; dense
/// output of order 4. Jacobians are differences of right sides. For equations some of whose motions die out far faster than what is sought.
#[inline(always)]
pub fn run_stiff<S: LaneScalar, C: EnsembleProblem<S>>(problem: &mut C) -> bool {
    S::apart(Travel { problem, method: PhantomData::<(S, Rodas<S>)> })
}

/// All members by one method. This, the beginning of members and dense output are functions of their own, since each holds the right side.
struct Travel<'a, S, C, M> {
    problem: &'a mut C,
    method: PhantomData<(S, M)>,
}

impl<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>> Routine for Travel<'_, S, C, M> {
    type Out = bool;
    #[inline(always)]
    fn run(self) -> bool {
        travel::<S, C, M>(self.problem)
    }
}

/// The interpolant over the last step.
struct DenseOutput<'a, S, C, M> {
    problem: &'a mut C,
    method: &'a mut M,
    number: PhantomData<S>,
}

impl<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>> Routine for DenseOutput<'_, S, C, M> {
    type Out = ();
    #[inline(always)]
    fn run(self) {
        self.method.dense(self.problem);
    }
}

/// Starts the fresh lanes.
struct Begin<'a, S, C, M> {
    roster: &'a mut Roster<S>,
    problem: &'a mut C,
    method: &'a mut M,
    inside: &'a mut Inside,
}

impl<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>> Routine for Begin<'_, S, C, M> {
    type Out = ();
    #[inline(always)]
    fn run(self) {
        self.roster.begin(self.problem, self.method, self.inside);
    }
}

#[inline(always)]
fn travel<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>>(problem: &mut C) -> bool {
    let n = problem.dim();
    let mut method = M::new(n, problem.positions(), problem.room());
    let mut inside = Inside::new(n, problem.events());
    let zero = S::zero();
    let mut r = Roster {
        t: zero,
        next: zero,
        t_end: zero,
        shortest: zero,
        next_output: [f64::INFINITY; LANES],
        output: [0; LANES],
        legs: [Leg::new(0.0, 0.0); LANES],
        steps: [0; LANES],
        rejected: [0; LANES],
        active: 0,
        fresh: 0,
        repeated: 0,
    };
    for lane in 0..LANES {
        r.load(lane, problem, &mut method, &mut inside);
    }
    let mut patience = 0;
    while r.active != 0 {
        patience += 1;
        spend(2000 + 200 * n as u64);
        if patience >= PATIENCE {
            patience = 0;
            if problem.cancelled() {
                return false;
            }
        }
        if r.fresh != 0 {
            S::apart(Begin { roster: &mut r, problem, method: &mut method, inside: &mut inside });
            continue;
        }
        let h = S::select(r.shortest.lt(r.next), r.next, r.shortest);
        // a last step a little longer than proposed spares a very short one
        let last = (r.t_end - r.t).le(h.scale(1.01));
        let t1 = S::select(last, r.t_end, r.t + h);
        let h_used = t1 - r.t;
        let attempt = method.attempt(problem, r.t, t1, h_used);
        let accepted = attempt.accepted.0 & r.active;
        let factor = bound_after_rejection(attempt.factor, r.repeated);
        let proposed = h_used * factor;
        // a step cut short by the end says nothing against the length proposed before
        let kept = S::select(last, S::select(h.lt(proposed), proposed, h), proposed);
        let rejected = r.active & !accepted;
        r.next = if accepted == Bits::MAX { kept } else { lanes_of(accepted, kept, proposed) };
        r.repeated = rejected;
        let mut stopped = 0;
        if accepted != 0 {
            let wanted = accepted & r.wants_inside(t1, problem.events());
            if wanted != 0 {
                S::apart(DenseOutput { problem, method: &mut method, number: PhantomData::<S> });
                inside.keep(&method);
                stopped = r.inside(wanted, t1, problem, &mut method, &mut inside);
            }
            let advanced = accepted & !stopped;
            r.t = if advanced == Bits::MAX { t1 } else { lanes_of(advanced, t1, r.t) };
            method.advance(advanced);
        }
        let full = r.count(accepted, rejected);
        let ends = S::bits(last).0 & accepted & !stopped;
        let too_small = if rejected == 0 { 0 } else { rejected & S::bits(h_used.le(r.shortest)).0 };
        if stopped | ends | too_small | full == 0 {
            continue;
        }
        for lane in each(stopped | ends | too_small | full) {
            let bit = 1 << lane;
            let end = match () {
                () if stopped & bit != 0 => LegEnd::Event(inside.crossing(lane)),
                () if ends & bit != 0 => LegEnd::Reached,
                () if too_small & bit == 0 => LegEnd::WorkLimit,
                () if attempt.finite.get(lane) => LegEnd::StepTooSmall(Cause::Error),
                () => LegEnd::StepTooSmall(Cause::NotFinite),
            };
            r.end(lane, end, problem, &mut method, &mut inside);
        }
    }
    true
}

impl<S: LaneScalar> Roster<S> {
    fn set(&mut self, lane: usize, leg: Leg) {
        self.legs[lane] = leg;
        self.t = self.t.with(lane, leg.t0);
        self.t_end = self.t_end.with(lane, leg.t1);
        self.shortest = self.shortest.with(lane, (10.0 * f64::EPSILON * leg.t0.abs().max(leg.t1.abs())).max(1e-290));
        self.output[lane] = 0;
        self.next_output[lane] = if leg.outputs.count > 0 { leg.outputs.start } else { f64::INFINITY };
        (self.steps[lane], self.rejected[lane]) = (0, 0);
        self.active |= 1 << lane;
        self.fresh |= 1 << lane;
        self.repeated &= !(1 << lane);
    }

    /// Takes members from the problem until one can be put into the lane.
    fn load<C: EnsembleProblem<S>, M: Method<S>>(&mut self, lane: usize, problem: &mut C, method: &mut M, inside: &mut Inside) {
        let seat = inside.seat();
        match problem.load(lane, seat) {
            Some(leg) => {
                method.ends_mut().seat(lane, inside.state(), inside.relative(), inside.absolute());
                self.set(lane, leg);
            }
            None => self.idle(lane, method),
        }
    }

    /// An empty lane computes on, harmlessly.
    fn idle<M: Method<S>>(&mut self, lane: usize, method: &mut M) {
        self.active &= !(1 << lane);
        self.fresh &= !(1 << lane);
        self.next_output[lane] = f64::INFINITY;
        self.t = self.t.with(lane, 0.0);
        self.t_end = self.t_end.with(lane, f64::INFINITY);
        self.next = self.next.with(lane, 1e-9);
        method.clear(lane);
    }

    /// Outcome of a leg: the problem continues the member, or the next one takes its place.
    fn end<C: EnsembleProblem<S>, M: Method<S>>(&mut self, lane: usize, end: LegEnd, problem: &mut C, method: &mut M, inside: &mut Inside) {
        let ended =
            Ended { end, t: self.t.get(lane), next_step: self.next.get(lane), steps: self.steps[lane], rejected: self.rejected[lane] };
        let y = inside.state_mut();
        method.ends().state(lane, y);
        match problem.ended(lane, &ended, y) {
            Some(leg) => {
                method.ends_mut().set_state(lane, y);
                self.set(lane, leg);
            }
            None => self.load(lane, problem, method, inside),
        }
    }

    /// Starts the fresh lanes: derivative, length of the first step, outputs and events at the start.
    #[inline(always)]
    fn begin<C: EnsembleProblem<S>, M: Method<S>>(&mut self, problem: &mut C, method: &mut M, inside: &mut Inside) {
        let fresh = self.fresh;
        let length = method.begin(problem, self.t, self.t_end, fresh);
        self.fresh = 0;
        let (length, t0, t1) = (length.to_array(), self.t.to_array(), self.t_end.to_array());
        for lane in each(fresh) {
            let first = self.legs[lane].first_step.unwrap_or(length[lane]);
            self.next = self.next.with(lane, first);
            // NaN fails
            let fine = first > 0.0 && t1[lane] > t0[lane] && inside.begin(lane, problem, self, method, t0[lane]);
            if !fine {
                self.end(lane, LegEnd::NoStart, problem, method, inside);
            }
        }
    }

    /// Counts steps; the lanes whose limit is reached.
    #[inline(always)]
    fn count(&mut self, accepted: Bits, rejected: Bits) -> Bits {
        let mut full = 0;
        for lane in 0..LANES {
            self.steps[lane] += u64::from(accepted >> lane & 1);
            self.rejected[lane] += u64::from(rejected >> lane & 1);
            full |= Bits::from(self.steps[lane] + self.rejected[lane] >= self.legs[lane].max_steps) << lane;
        }
        full & (accepted | rejected)
    }

    /// Outputs and events of the step in the lanes `wanted`; the lanes in which a crossing ends the leg, put to their time and state.
    fn inside<C: EnsembleProblem<S>, M: Method<S>>(
        &mut self,
        wanted: Bits,
        t1: S,
        problem: &mut C,
        method: &mut M,
        inside: &mut Inside,
    ) -> Bits {
        let (t0, t1) = (self.t.to_array(), t1.to_array());
        let mut stopped = 0;
        for lane in each(wanted) {
            if let Some(t) = inside.look::<S, C, M>(lane, problem, self, t0[lane], t1[lane]) {
                stopped |= 1 << lane;
                self.t = self.t.with(lane, t);
                method.ends_mut().set_state(lane, inside.state());
            }
        }
        stopped
    }

    /// Lanes in which an output or an event may lie before `t1`.
    #[inline(always)]
    fn wants_inside(&self, t1: S, events: usize) -> Bits {
        if events > 0 { Bits::MAX } else { S::bits(S::load(&self.next_output).le(t1)).0 }
    }
}

/// Lanes of `a` where the bits are set, of `b` elsewhere.
#[inline(always)]
fn lanes_of<S: LaneScalar>(bits: Bits, a: S, b: S) -> S {
    let mut flags = [0.0; LANES];
    for (eight, byte) in flags.chunks_exact_mut(8).zip(bits.to_le_bytes()) {
        eight.copy_from_slice(&FLAGS[usize::from(byte)]);
    }
    S::select(S::zero().lt(S::load(&flags)), a, b)
}

/// One where a bit of a byte is set.
static FLAGS: [[f64; 8]; 256] = flags();

const fn flags() -> [[f64; 8]; 256] {
    let mut table = [[0.0; 8]; 256];
    let mut bits = 0;
    while bits < 256 {
        let mut lane = 0;
        while lane < 8 {
            if bits >> lane & 1 == 1 {
                table[bits][lane] = 1.0;
            }
            lane += 1;
        }
        bits += 1;
    }
    table
}

/// No growth of the step right after a rejection.
#[inline(always)]
fn bound_after_rejection<S: LaneScalar>(factor: S, repeated: Bits) -> S {
    if repeated == 0 {
        return factor;
    }
    let one = S::one();
    lanes_of(repeated, S::select(factor.lt(one), factor, one), factor)
}

/// The set bits.
fn each(bits: Bits) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |i| bits >> i & 1 == 1)
}
