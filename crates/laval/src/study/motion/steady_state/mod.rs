//! Motions followed until they repeat: in lanes, each for as long as it needs, then assessed by its Poincare points.
//!
//! A leg is a whole number of forcing periods `T = 2 pi / W`, so that every leg starts at phase zero. A member is integrated for as many e-folds of the
//! slowest mode as the tolerance requires, then recorded over some periods and assessed ([`period`]); while it does not repeat it goes on, up to
//! four times the time that the slowest mode requires. With shooting a few e-folds suffice: Newton's method on `P^k(y) = y` finds the orbit
//! ([`shooting`]).
//!
//! Theory: `docs/theory/motion-in-time.md#steady-state-motion`.

pub(in crate::study) mod columns;
pub(in crate::study) mod fields;
mod limits;
pub(in crate::study) mod measure;
pub(in crate::study) mod period;
mod shooting;
pub(in crate::study) mod stored;

use crate::model::probe::Probe;
use crate::model::system::System;
use crate::solve::ensemble::{self, Ended, EnsembleTask, Grid, Leg, LegEnd, Method, Next, Start};
use crate::solve::motion::SpinLaw;
use crate::solve::motion::trajectory::Choice;
use crate::solve::pencil::{Spectrum, modes_about};
use crate::solve::programme::Programme;
use crate::solve::rest::rest;
use crate::store::Rows;
use limits::Limits;
use measure::Measure;
use period::{LONGEST, Sections, Verdict};
use shooting::Shooting;
use std::f64::consts::TAU;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Samples of a forcing period.
pub(in crate::study) const SAMPLES: usize = 64;
/// Longest leg, periods: the phase keeps its digits.
const LONGEST_LEG: u64 = 1000;
/// The same where a mode at rest does not decay: a motion that flies apart is seen before its steps become tiny.
const SHORT_LEG: u64 = 20;
/// Periods between two words of progress within a leg.
const SHOW: u64 = 20;
/// Times the decay time that a motion is followed which does not repeat.
const PATIENCE: u64 = 4;
/// e-folds before shooting begins.
const FOLDS_BEFORE_SHOOTING: f64 = 5.0;
/// Displacements over their typical size (1 mm) beyond which a motion has left every machine.
pub(in crate::study) const RUNAWAY: f64 = 1e6;
/// What is said of such a motion.
pub(in crate::study) const UNBOUNDED: &str = "grows without bound";

/// How motions are settled and recorded.
#[derive(Clone, Debug)]
pub(in crate::study) struct Rules {
    /// Method of integration requested.
    pub method: Choice,
    /// Relative tolerance of a step.
    pub relative: f64,
    /// Absolute tolerance of a step over typical sizes.
    pub absolute: f64,
    /// Tolerated distance from the limit over the size of the motion.
    pub tolerance: f64,
    /// Most periods of settling.
    pub most_periods: u64,
    /// Periods recorded.
    pub periods: usize,
    /// Newton's method on the Poincare map.
    pub shooting: bool,
    /// Station whose spectrum is computed.
    pub spectrum: Option<usize>,
}

/// A motion to be settled.
#[derive(Clone)]
pub(in crate::study) struct Member {
    /// The machine: that of the ensemble, or one with other parameters.
    pub system: Arc<System>,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// State at phase zero.
    pub y: Vec<f64>,
    /// Coordinates at rest.
    pub rest: Vec<f64>,
    /// Decay rate of the slowest mode, 1/s, where every mode decays.
    pub rate: Option<f64>,
}

/// What became of it.
#[derive(Clone, Debug)]
pub(in crate::study) struct SteadyState {
    /// Assessment.
    pub verdict: Verdict,
    /// Estimated distance from the limit over the size of the motion.
    pub remaining: f64,
    /// Forcing periods integrated, those of shooting included.
    pub periods: u64,
    /// The largest number of periods ended the settling.
    pub bounded: bool,
    /// Residual of shooting over the size of the motion, and the largest modulus of its multipliers.
    pub shot: Option<(f64, f64)>,
    /// Integration steps.
    pub steps: u64,
    /// State at the end, at phase zero; empty when the motion failed.
    pub y: Vec<f64>,
    /// States at phase zero over the last period, oldest first; empty when it does not repeat.
    pub orbit: Vec<Vec<f64>>,
    /// Amplitudes; none when it failed.
    pub measure: Option<Measure>,
}

impl SteadyState {
    /// No motion.
    pub fn none(why: &'static str) -> SteadyState {
        SteadyState {
            verdict: Verdict::Failed(why),
            remaining: f64::NAN,
            periods: 0,
            bounded: false,
            shot: None,
            steps: 0,
            y: vec![],
            orbit: vec![],
            measure: None,
        }
    }
}

/// Modes of the machine linearised at rest, without their shapes; none where it does not rest.
fn modes_at_rest(system: &System, speed: f64) -> Option<Spectrum> {
    modes_about(system, &rest(system, speed).ok()?, false).ok()
}

/// Growth of the slowest or fastest growing mode at rest, 1/s, and what rounding leaves of it.
fn least_stable(system: &System, speed: f64) -> Option<(f64, f64)> {
    let spectrum = modes_at_rest(system, speed)?;
    let largest = spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
    Some((spectrum.least_stable()?.growth(), 1e-13 * largest))
}

/// Decay rate of the slowest mode of the machine linearised at rest, 1/s; `None` where there is none, or a mode does not decay.
pub(in crate::study) fn slowest_decay(system: &System, speed: f64) -> Option<f64> {
    let (growth, rounding) = least_stable(system, speed)?;
    (-growth > rounding && growth.is_finite()).then_some(-growth)
}

/// Growth rate of the fastest growing mode of the machine linearised at rest, 1/s; `None` where none grows.
pub(in crate::study) fn fastest_growth(system: &System, speed: f64) -> Option<f64> {
    least_stable(system, speed).filter(|(growth, rounding)| growth > rounding).map(|g| g.0)
}

/// A mode at rest neither decays nor grows.
pub(in crate::study) fn neutral(system: &System, speed: f64) -> bool {
    least_stable(system, speed).is_some_and(|(growth, rounding)| growth.abs() <= rounding)
}

/// Rate of the fastest mode over the spin speed above which the implicit method is cheaper: stability then requires of the explicit one some thousand
/// steps a period, where accuracy requires of the implicit one one or two hundred, each three times as dear.
const FAST: f64 = 1000.0;

/// The method for motions of a machine about a speed.
pub(in crate::study) fn method(system: &System, choice: Choice, speed: f64) -> Method {
    let fast = || modes_at_rest(system, speed).is_some_and(|s| s.modes.iter().any(|m| m.value.abs() > FAST * speed.abs()));
    match choice {
        Choice::Explicit => Method::Explicit,
        Choice::Stiff => Method::Stiff,
        Choice::Auto if system.slots().iter().any(|s| s.memory > 0) || fast() => Method::Stiff,
        Choice::Auto => Method::Explicit,
    }
}

/// Typical size of every state at a speed: displacements, rates, internal states.
pub(in crate::study) fn sizes(system: &System, speed: f64) -> Vec<f64> {
    let own = system.coordinates().iter().map(|c| c.dof.typical);
    own.clone().chain(own.map(|x| x * speed)).chain(system.states().iter().map(|s| s.dof.typical)).collect()
}

/// Steps of integration that a run may take.
pub(in crate::study) struct Budget {
    spent: AtomicU64,
    limit: u64,
}

impl Budget {
    pub fn new(limit: u64) -> Self {
        Budget { spent: AtomicU64::new(0), limit }
    }
    /// Counts the steps of a leg.
    pub fn spend(&self, ended: &Ended) {
        self.spent.fetch_add(ended.steps + ended.rejected, Ordering::Relaxed);
    }
    /// Nothing is left: what is under way is dropped.
    pub fn used_up(&self) -> bool {
        self.spent.load(Ordering::Relaxed) >= self.limit
    }
    /// A leg that stops where the budget must be used up.
    pub fn leg(&self, leg: Leg) -> Leg {
        Leg { max_steps: leg.max_steps.min(self.limit.max(1)), ..leg }
    }
}

/// Members under way.
pub(in crate::study) struct SteadyStateSearch<'a> {
    pub budget: &'a Budget,
    pub members: &'a [Member],
    pub rules: &'a Rules,
    pub counter: &'a Rows<'a>,
    /// What is recorded.
    pub probes: Vec<Probe>,
}

/// What is remembered of a member.
pub(in crate::study) struct Log {
    system: Arc<System>,
    stage: Stage,
    period: f64,
    size: Vec<f64>,
    /// Periods of one stretch of settling, and those still to go.
    stretch: u64,
    to_go: u64,
    /// Periods of settling left, and integrated so far.
    left: u64,
    done: u64,
    /// Periods of the leg under way, those in `done`, and of the longest leg.
    leg: u64,
    longest: u64,
    bounded: bool,
    steps: u64,
    sections: Sections,
    /// Both components of every probe at every sample, from their values at rest.
    samples: Vec<f64>,
    limits: Limits,
    shooting: Option<Shooting>,
    shot: Option<(f64, f64)>,
    /// Thousandths of the member that were reported.
    shown: i64,
}

enum Stage {
    Settle,
    Record,
    Shoot,
}

impl SteadyStateSearch<'_> {
    fn leg(log: &mut Log, periods: u64, first_step: Option<f64>) -> Leg {
        let t1 = log.period * periods as f64;
        log.done += periods;
        log.leg = periods;
        // as many a period as the longest leg may take: a motion that flies apart is not followed for millions
        let whole = Leg::new(0.0, t1);
        Leg { first_step, max_steps: (whole.max_steps / LONGEST_LEG).saturating_mul(periods), ..whole }
    }

    /// A leg of shooting: all begin with the same step, so that their errors are nearly the same.
    fn shot(log: &mut Log) -> Leg {
        let periods = log.shooting.as_ref().map_or(1, Shooting::periods);
        let first_step = log.period / SAMPLES as f64;
        Self::leg(log, periods, Some(first_step))
    }

    /// The next leg of settling; the record when nothing is to go.
    fn go_on(&self, log: &mut Log, first_step: Option<f64>) -> Leg {
        if log.to_go > 0 {
            let periods = log.to_go.min(log.longest);
            log.to_go -= periods;
            log.stage = Stage::Settle;
            let every = SHOW as f64 * log.period;
            let outputs = Grid { start: every, step: every, count: periods / SHOW };
            return Leg { outputs, ..Self::leg(log, periods, first_step) };
        }
        log.stage = Stage::Record;
        log.sections.clear();
        log.samples.clear();
        log.limits = Limits::default();
        let outputs = Grid { start: 0.0, step: log.period / SAMPLES as f64, count: (self.rules.periods * SAMPLES + 1) as u64 };
        let leg = Self::leg(log, self.rules.periods as u64, first_step);
        Leg { t1: outputs.time(outputs.count - 1), outputs, ..leg }
    }

    /// Begins another stretch of at most so many periods; false when the largest number is reached.
    fn stretch(log: &mut Log, periods: u64) -> bool {
        log.to_go = periods.min(log.left);
        log.left -= log.to_go;
        log.to_go > 0
    }

    fn failed(log: &Log, why: &'static str) -> SteadyState {
        SteadyState { periods: log.done, bounded: log.bounded, steps: log.steps, ..SteadyState::none(why) }
    }

    /// A record is complete: assessed, shot at, followed further, or measured.
    fn recorded(&self, index: usize, log: &mut Log, ended: &Ended, y: &mut [f64]) -> Next<SteadyState> {
        let member = &self.members[index];
        let assessment = log.sections.assess(self.rules, member.rate, log.shot.is_some(), log.period, log.bounded);
        let steady_state = matches!(assessment.verdict, Verdict::Period(_));
        if !steady_state && let Some(shooting) = log.shooting.as_mut() {
            shooting.begin(&log.sections, y);
            log.stage = Stage::Shoot;
            return Next::Leg(Self::shot(log));
        }
        if !steady_state && log.shot.is_none() && Self::stretch(log, log.stretch) {
            return Next::Leg(self.go_on(log, Some(ended.next_step)));
        }
        let outside = log.limits.worst.map(|(slot, what, ratio)| (format!("{}: {what}", member.system.slots()[slot].name), ratio));
        let orbit = if let Verdict::Period(k) = assessment.verdict { log.sections.last(k) } else { vec![] };
        let measure = Measure::of(self, log.sections.period_of(&assessment.verdict), &log.samples, outside);
        Next::Done(SteadyState {
            verdict: assessment.verdict,
            remaining: log.shot.map_or(assessment.remaining, |s| s.0),
            periods: log.done,
            bounded: log.bounded,
            shot: log.shot,
            steps: log.steps,
            y: y.to_vec(),
            orbit,
            measure: Some(measure),
        })
    }
}

impl EnsembleTask for SteadyStateSearch<'_> {
    type Log = Log;
    type Row = SteadyState;

    fn start(&self, index: usize) -> Result<Start<Log>, SteadyState> {
        let member = &self.members[index];
        let period = TAU / member.speed;
        let rules = self.rules;
        // periods in so many e-folds of the slowest mode
        let count = |folds: f64| {
            let n = member.rate.map_or(f64::INFINITY, |r| (folds / (r * period)).ceil());
            if n < rules.most_periods as f64 { n as u64 } else { rules.most_periods }
        };
        let stretch = count(-rules.tolerance.ln()).max(1);
        let bounded = stretch == rules.most_periods;
        let left = stretch.saturating_mul(PATIENCE).min(rules.most_periods);
        let size = sizes(&member.system, member.speed);
        let mut log = Log {
            system: member.system.clone(),
            stage: Stage::Record,
            period,
            stretch,
            to_go: 0,
            left,
            done: 0,
            leg: 0,
            longest: if member.rate.is_some() { LONGEST_LEG } else { SHORT_LEG },
            bounded,
            steps: 0,
            sections: Sections::new(&size, &member.rest),
            shooting: rules.shooting.then(|| Shooting::new(rules, &size)),
            size,
            samples: vec![],
            limits: Limits::default(),
            shot: None,
            shown: 0,
        };
        Self::stretch(&mut log, if rules.shooting { count(FOLDS_BEFORE_SHOOTING).max(1) } else { stretch });
        let leg = self.budget.leg(self.go_on(&mut log, None));
        // differences of neighbouring motions need more digits than the motions
        let relative = if rules.shooting { rules.relative.min(shooting::RELATIVE) } else { rules.relative };
        let absolute = if rules.shooting { rules.absolute.min(shooting::RELATIVE) } else { rules.absolute };
        Ok(Start {
            system: member.system.clone(),
            law: SpinLaw::Programme(Programme::constant(member.speed, 0.0)),
            y: member.y.clone(),
            relative,
            absolute: ensemble::tolerances(&member.system, member.speed, absolute),
            leg,
            log,
        })
    }

    fn output(&self, log: &mut Log, i: u64, t: f64, y: &[f64]) {
        if matches!(log.stage, Stage::Settle) {
            let gone = log.done - log.leg + (i + 1) * SHOW;
            self.show(log, gone);
            return;
        }
        if i >= (self.rules.periods.saturating_sub(LONGEST) * SAMPLES) as u64 {
            log.limits.watch(&log.system, TAU / log.period, t, log.period / SAMPLES as f64, y);
        }
        if i.is_multiple_of(SAMPLES as u64) {
            log.sections.push(y);
        }
        let rest = log.sections.rest();
        for p in &self.probes {
            let ([x, y], [x0, y0]) = (p.of(y), p.of(rest));
            log.samples.extend([x - x0, y - y0]);
        }
    }

    fn ended(&self, index: usize, log: &mut Log, ended: &Ended, y: &mut [f64]) -> Next<SteadyState> {
        self.budget.spend(ended);
        let gone = log.done;
        match self.next(index, log, ended, y) {
            Next::Leg(leg) => {
                self.show(log, gone);
                Next::Leg(self.budget.leg(leg))
            }
            done => {
                self.counter.advance(-log.shown);
                done
            }
        }
    }

    fn finished(&self) {
        self.counter.add(1);
    }

    fn cancelled(&self) -> bool {
        self.counter.cancelled() || self.budget.used_up()
    }
}

impl SteadyStateSearch<'_> {
    /// Reports how far the member is after so many periods, if it settles in the stretch it is in.
    fn show(&self, log: &mut Log, periods: u64) {
        let whole = log.done + log.to_go + if matches!(log.stage, Stage::Record) { 0 } else { self.rules.periods as u64 };
        let at = (1000.0 * periods as f64 / whole.max(1) as f64) as i64;
        if at > log.shown {
            self.counter.advance(at - log.shown);
            log.shown = at;
        }
    }

    fn next(&self, index: usize, log: &mut Log, ended: &Ended, y: &mut [f64]) -> Next<SteadyState> {
        log.steps += ended.steps + ended.rejected;
        if ended.end != LegEnd::Reached {
            return Next::Done(Self::failed(log, words(ended.end)));
        }
        let n = log.system.n();
        if !y[..n].iter().zip(&log.size).all(|(x, s)| x.abs() <= RUNAWAY * s) {
            return Next::Done(Self::failed(log, UNBOUNDED));
        }
        match log.stage {
            Stage::Settle => Next::Leg(self.go_on(log, Some(ended.next_step))),
            Stage::Record => self.recorded(index, log, ended, y),
            Stage::Shoot => {
                let Some(shooting) = log.shooting.as_mut() else { return Next::Done(Self::failed(log, "shooting was lost")) };
                match shooting.landed(y) {
                    shooting::Step::Again => Next::Leg(Self::shot(log)),
                    shooting::Step::Found { residual, multiplier } => {
                        log.shot = Some((residual, multiplier));
                        log.shooting = None;
                        Next::Leg(self.go_on(log, Some(ended.next_step)))
                    }
                    shooting::Step::Lost => {
                        log.shooting = None;
                        Self::stretch(log, log.stretch);
                        Next::Leg(self.go_on(log, Some(ended.next_step)))
                    }
                }
            }
        }
    }
}

/// Why a motion could not be followed.
pub(in crate::study) fn words(end: LegEnd) -> &'static str {
    match end {
        LegEnd::StepTooSmall(laval_num::ode::Cause::NotFinite) => "leaves the range of numbers",
        LegEnd::StepTooSmall(_) => "needs steps below the resolution of time",
        LegEnd::WorkLimit => "needs too many steps",
        LegEnd::NoStart => "cannot start",
        LegEnd::Event(_) => "changes side too often",
        LegEnd::Reached => "",
    }
}
