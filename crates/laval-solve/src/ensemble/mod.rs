//! Many motions of one machine at once, with other parameters, speeds or starts: in lanes on every core.
//!
//! A [`EnsembleTask`] says where each member starts, what is watched on the way and what is kept of it; [`run`] integrates all members and returns what
//! was kept, in order. The result of a member does not depend on the others, on the number of threads or on the processor level, bit for bit.
//!
//! Members share the parts, coordinates and states of one machine and differ in parameters, spin and state. A machine with constant mass at
//! constant speeds is compiled member by member to
//!
//! ```text
//! x' = A x + B n(C x) + u0 + uc cos(phase) + us sin(phase)
//! ```
//!
//! with n the nonlinear parts only, one call for each and all lanes. Where the mass depends on the configuration, such as that of balls in a ring, the linear
//! parts are compiled and the others called with their masses (`varying`). Any other motion is evaluated part by part, and one lane after another where coordinates have no inertia.

mod general;
mod lane_run;
mod varying;

use crate::diagnostic::Diagnostic;
use crate::model::part::{Physics, TimeForm};
use crate::model::system::{Drive, System};
use crate::motion::SpinLaw;
use crate::motion::one_by_one::is_massless;
use lane_run::{LaneRun, MemberSource, RunningMembers};
use laval_model::text;
pub use laval_num::ensemble::{Ended, Grid, Leg, LegEnd};
use laval_num::lanes::{Kernel, LaneScalar, Level, dispatch};
use laval_num::work::Here;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// A member at its start.
pub struct Start<T> {
    /// The machine: that of the ensemble with other parameters.
    pub system: Arc<System>,
    /// How its spin moves.
    pub law: SpinLaw,
    /// State (q, v, z [, phase, speed]) as in [`crate::motion`].
    pub y: Vec<f64>,
    /// Relative tolerance.
    pub relative: f64,
    /// Absolute tolerance of each state, in its unit.
    pub absolute: Vec<f64>,
    /// First leg.
    pub leg: Leg,
    /// What the task remembers of the member while it is under way.
    pub log: T,
}

/// What becomes of a member at the end of a leg.
pub enum Next<R> {
    /// It goes on from its state, which may have been changed.
    Leg(Leg),
    /// It is finished.
    Done(R),
}

/// Members, what is watched of them and what is kept.
pub trait EnsembleTask: Sync {
    /// What is remembered of a member under way.
    type Log: Send;
    /// What is kept of it.
    type Row: Send;
    /// Member `index`; an error is what is kept of one that cannot start.
    fn start(&self, index: usize) -> Result<Start<Self::Log>, Self::Row>;
    /// The state at output `i` of the present leg.
    fn output(&self, _log: &mut Self::Log, _i: u64, _t: f64, _y: &[f64]) {}
    /// A leg has ended. Crossings of switching surfaces do not come here: the leg goes on behind them.
    fn ended(&self, index: usize, log: &mut Self::Log, ended: &Ended, y: &mut [f64]) -> Next<Self::Row>;
    /// A member is finished; for progress.
    fn finished(&self) {}
    /// Polled now and then; `true` leaves all members where they are.
    fn cancelled(&self) -> bool {
        false
    }
}

/// The method of integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Order 8, for motions that are not stiff.
    #[default]
    Explicit,
    /// Implicit, order 5.
    Stiff,
}

/// Why motions of this machine cannot go in lanes.
///
/// # Errors
/// A part without a time form; memory states with the explicit method.
pub fn admit(system: &System, method: Method) -> Result<(), Diagnostic> {
    for slot in system.slots() {
        if let Physics::Frequency(TimeForm::None(why)) = slot.physics {
            return Err(Diagnostic::error(
                "motion.no_time_form",
                text!("\"{name}\" has no form in the time domain: {why}", name = slot.name, why = text::term(why)),
            )
            .at(slot.span.clone())
            .help(text!("use a study in the frequency domain, such as forced_response")));
        }
        if slot.memory > 0 && method == Method::Explicit {
            return Err(Diagnostic::error(
                "ensemble.memory",
                text!("\"{name}\" has memory states, which an explicit method cannot follow", name = slot.name),
            )
            .at(slot.span.clone())
            .help(text!("use method = \"stiff\"")));
        }
    }
    Ok(())
}

/// How members are integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Method of integration.
    pub method: Method,
    /// Processor level; the numbers are the same at each.
    pub level: Level,
    /// Number of threads; 0 takes those of the present thread pool.
    pub threads: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { method: Method::default(), level: Level::best(), threads: 0 }
    }
}

/// The form in which the equations of all members are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Constant speeds, a mass matrix that depends on parameters only, no memory: compiled.
    Constant,
    /// Constant speeds, a mass matrix that depends on the configuration, no internal states.
    Varying,
    /// Any prescribed programme, any mass matrix.
    Prescribed,
    /// The spin is free.
    Free,
    /// Some coordinates have no inertia.
    Massless,
}

impl Form {
    /// The fastest form for a machine.
    pub fn of(system: &System, constant_speeds: bool) -> Form {
        let varying = system.slots().iter().any(|s| s.memory > 0 || (!s.is_linear() && s.uses.acceleration));
        match system.machine.drive {
            _ if is_massless(system) => Form::Massless,
            Drive::Free => Form::Free,
            Drive::Prescribed if constant_speeds && !varying => Form::Constant,
            Drive::Prescribed if constant_speeds && varying::serves(system) => Form::Varying,
            Drive::Prescribed => Form::Prescribed,
        }
    }
}

/// Integrates the members `range`; their rows in order, or `None` when cancelled. `base` is the machine whose parts the members share.
pub fn run<V: EnsembleTask>(task: &V, base: &System, form: Form, range: Range<usize>, settings: Settings) -> Option<Vec<V::Row>> {
    let count = range.len();
    let threads = if settings.threads == 0 { rayon::current_num_threads() } else { settings.threads };
    // fewer members than lanes on all threads: fill the lanes of one before using the next
    let threads = threads.clamp(1, count.div_ceil(laval_num::lanes::LANES).max(1));
    let next = AtomicUsize::new(range.start);
    let rows = Mutex::new(Vec::with_capacity(count));
    let take = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&i| i < range.end);
    let keep = |index: usize, row: V::Row| {
        rows.lock().unwrap_or_else(PoisonError::into_inner).push((index, row));
        task.finished();
    };
    let (take, keep) = (&take as &(dyn Fn() -> Option<usize> + Sync), &keep as &(dyn Fn(usize, V::Row) + Sync));
    let on_thread = || {
        let mut running = RunningMembers { task, logs: std::array::from_fn(|_| None), take, keep };
        run_members(settings, &mut running, base, form)
    };
    let here = Here::now();
    let counted = |_| {
        let _counted = here.enter();
        on_thread()
    };
    let whole = if threads == 1 { on_thread() } else { (0..threads).into_par_iter().map(counted).reduce(|| true, |a, b| a && b) };
    let mut rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    rows.sort_by_key(|r: &(usize, V::Row)| r.0);
    (whole && rows.len() == count).then(|| rows.into_iter().map(|r| r.1).collect())
}

/// The members of one thread. Not generic, so that the kernels are compiled in this crate once and not for each kind of task.
#[inline(never)]
fn run_members(settings: Settings, hands: &mut dyn MemberSource, base: &System, form: Form) -> bool {
    dispatch(settings.level, RunMembers { hands, base, form, method: settings.method })
}

/// The lanes of one thread.
struct RunMembers<'a> {
    hands: &'a mut dyn MemberSource,
    base: &'a System,
    form: Form,
    method: Method,
}

impl Kernel for RunMembers<'_> {
    type Out = bool;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> bool {
        let mut lane_run = LaneRun::<S>::new(self.hands, self.base, self.form);
        match self.method {
            Method::Explicit => laval_num::ensemble::run(&mut lane_run),
            Method::Stiff => laval_num::ensemble::run_stiff(&mut lane_run),
        }
    }
}

/// Absolute tolerances: `absolute` times the typical size of each state; velocities times the spin speed, at least 100 rad/s.
pub fn tolerances(system: &System, speed: f64, absolute: f64) -> Vec<f64> {
    let rate = speed.abs().max(100.0);
    let sizes = system.coordinates().iter().map(|c| c.dof.typical);
    let states = system.states().iter().map(|s| s.dof.typical);
    sizes.clone().chain(sizes.map(|x| x * rate)).chain(states).map(|x| x * absolute).collect()
}
