//! Integration of a [`Motion`] with what a study wants to know of it: outputs, peaks and envelope of the bodies, contacts, use of validity.
//!
//! The integration restarts where the spin programme changes its law, at a kick, and where a part's law switches
//! ([`Contacts::switches`](crate::model::capability::Contacts::switches)), so that no step spans a jump of any derivative.

use super::envelope::{Peak, Window};
use super::{ACCOUNT, Motion, SpinLaw, point};
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::probe::Probe;
use crate::model::system::{System, Workspace};
use crate::programme::Spin;
use laval_model::text;
use laval_model::text::{Arg, Argument};
use laval_num::ode::{Control, Crossing, Dop853, End, Event, Method, Observer, Ode, Radau, Run, Step, Tolerance, Work, integrate};
use laval_num::order::ascending;
use serde::{Deserialize, Serialize};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// Which method integrates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Choice {
    /// Stiff when a part has memory states or when stability, not accuracy, limits the explicit step; explicit otherwise.
    #[default]
    Auto,
    /// Order 8.
    Explicit,
    /// Order 5, implicit.
    Stiff,
}

/// Request of an integration, from t = 0.
#[derive(Clone)]
pub struct Plan<'p> {
    /// End, s.
    pub t_end: f64,
    /// Method.
    pub choice: Choice,
    /// Relative tolerance.
    pub relative: f64,
    /// Absolute tolerance over the typical size of each state.
    pub absolute: f64,
    /// Times of output, increasing.
    pub outputs: &'p [f64],
    /// Number of equal windows of the envelope.
    pub windows: usize,
    /// Coordinates at rest, from which displacements are measured; zero when empty.
    pub rest: &'p [f64],
    /// Displacement of a body from rest beyond which nothing is computed, m.
    pub bound: f64,
    /// A sudden change of velocities: when, and of each coordinate.
    pub kick: Option<(f64, Vec<f64>)>,
    /// Most steps.
    pub max_steps: u64,
    /// Polled before every step.
    pub cancel: &'p dyn Fn() -> bool,
    /// Receives the time reached.
    pub progress: &'p dyn Fn(f64),
}

/// Largest use of one statement of validity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Use {
    /// Slot of the part.
    pub slot: usize,
    /// The statement.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub what: laval_num::text::Text,
    /// Largest ratio.
    pub ratio: f64,
    /// When.
    pub t: f64,
    /// When it first exceeded 1.
    pub exceeded: Option<f64>,
    /// When it was first seen.
    pub begin: f64,
    /// When it was seen above 1 for the last time.
    pub until: Option<f64>,
    /// Largest ratio after that.
    pub after: f64,
}

/// Where a motion passed its bound.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Left {
    /// Index of the body.
    pub body: usize,
    /// Its displacement from rest, m.
    pub displacement: f64,
    /// When, s.
    pub t: f64,
}

/// What a trajectory found.
#[derive(Clone)]
pub struct Trajectory {
    /// Times of the outputs reached.
    pub times: Vec<f64>,
    /// States there, one after the other.
    pub states: Vec<f64>,
    /// State at the end.
    pub state: Vec<f64>,
    /// How it ended.
    pub run: Run,
    /// The motion passed its bound and was left there; the run then ends as cancelled.
    pub left: Option<Left>,
    /// The implicit method was used.
    pub stiff: bool,
    /// Of each body, the largest of all its points where something is attached.
    pub peaks: Vec<Peak>,
    /// Of each body, the same.
    pub windows: Vec<Vec<Window>>,
    /// Of each point beside the reference points.
    pub points: Vec<(Probe, Vec<Window>)>,
    /// Of each body that tilts.
    pub tilts: Vec<Tilting>,
    /// Crossings of switching surfaces: slot, surface of the part, time.
    pub contacts: Vec<(usize, usize, f64)>,
    /// Use of validity, by statement.
    pub validity: Vec<Use>,
}

/// Tilt of a body from rest, rad.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tilting {
    /// Index of the body.
    pub body: usize,
    /// The largest.
    pub peak: Peak,
    /// Its envelope.
    pub windows: Vec<Window>,
}

/// Crossings of one surface nearer together than this share of a step are one.
const INSTANT: f64 = 1e-7;

/// Integrates from `y` at t = 0.
///
/// # Errors
/// An explicit method requested of a machine with memory states; a state that cannot be evaluated at the start.
pub fn simulate(motion: &mut Motion, y: &[f64], plan: &Plan) -> Result<Trajectory, Diagnostic> {
    if let (Choice::Explicit, Some(d)) = (plan.choice, motion.refuses_explicit()) {
        return Err(d);
    }
    let cannot = |what: Arg| Diagnostic::error("motion.start", text!("the motion cannot be computed from its start: {what}", what));
    motion.accelerations(0.0, y).map_err(|e| cannot(e.argument()))?;
    let (relative, absolute) = tolerances(motion, plan);
    let stiff = match plan.choice {
        Choice::Explicit => false,
        Choice::Stiff => true,
        Choice::Auto => motion.memory_states() > 0 || explicit_is_limited_by_stability(motion, y, plan, &relative, &absolute),
    };
    let system = motion.system();
    let mut watch = Watch::new(system, motion.law().clone(), plan, motion.dim());
    let mut state = y.to_vec();
    motion.settle(0.0, &mut state).map_err(|e| cannot(super::direct::in_words(&e)))?;
    watch.start(&state);
    let run = if stiff {
        legs(&mut Radau::new(), motion, &mut state, plan, (relative, absolute), &mut watch)
    } else {
        legs(&mut Dop853::new(), motion, &mut state, plan, (relative, absolute), &mut watch)
    };
    // a state of which nothing follows stays as it is
    let _ = motion.settle(run.t, &mut state);
    for (t, y) in watch.times.iter().zip(watch.states.chunks_exact_mut(state.len().max(1))) {
        let _ = motion.settle(*t, y);
    }
    match run.end {
        End::Failed { t: 0.0, what } => Err(cannot(what.argument())),
        _ => {
            let aside = |t: &&Track| !t.probe.is_tilt() && !t.probe.is_reference();
            let points = watch.tracks.iter().filter(aside).map(|t| (t.probe.clone(), t.windows.clone())).collect();
            let (peaks, windows, tilts) = by_body(watch.tracks);
            Ok(Trajectory {
                times: watch.times,
                states: watch.states,
                state,
                run,
                left: watch.left.get(),
                stiff,
                peaks,
                windows,
                points,
                tilts,
                contacts: watch.contacts,
                validity: watch.validity,
            })
        }
    }
}

/// Of every body the largest displacement among its points, and its tilt.
fn by_body(tracks: Vec<Track>) -> (Vec<Peak>, Vec<Vec<Window>>, Vec<Tilting>) {
    let (tilts, points): (Vec<Track>, Vec<Track>) = tracks.into_iter().partition(|t| t.probe.is_tilt());
    let raise = |largest: &mut Peak, other: Peak| {
        if other.amplitude > largest.amplitude || other.amplitude.is_nan() {
            *largest = other;
        }
    };
    let (mut peaks, mut windows) = (Vec::<Peak>::new(), Vec::<Vec<Window>>::new());
    for track in points {
        let body = track.probe.station;
        if body == peaks.len() {
            peaks.push(track.peak);
            windows.push(track.windows);
            continue;
        }
        // what moves most says how it turns
        let turns = track.peak.amplitude > peaks[body].amplitude;
        raise(&mut peaks[body], track.peak);
        for (largest, w) in windows[body].iter_mut().zip(track.windows) {
            if w.last.is_finite() {
                raise(&mut largest.peak, w.peak);
                largest.angle = if turns { w.angle } else { largest.angle };
            }
        }
    }
    let tilts = tilts.into_iter().map(|t| Tilting { body: t.probe.station, peak: t.peak, windows: t.windows });
    (peaks, windows, tilts.collect())
}

/// Tolerances by kind of state: typical sizes of the coordinates, for velocities times the spin speed (at least 100 rad/s).
fn tolerances(motion: &mut Motion, plan: &Plan) -> (Tolerance, Tolerance) {
    let system = motion.system();
    let (n, m) = (system.n(), system.m());
    let speed = match motion.law() {
        SpinLaw::Programme(p) => p.largest_speed(),
        SpinLaw::Free => system.machine.speed.unwrap_or(0.0).abs(),
    };
    let rate = speed.max(100.0);
    let mut typical = vec![1.0; motion.dim()];
    for (i, c) in system.coordinates().iter().enumerate() {
        typical[i] = c.dof.typical;
        typical[n + i] = c.dof.typical * rate;
    }
    for (i, s) in system.states().iter().enumerate() {
        typical[2 * n + i] = s.dof.typical;
    }
    let mut relative = vec![plan.relative; motion.dim()];
    if let Some(k) = motion.spin_start() {
        // an angle that grows must not loosen its own tolerance
        relative[k] = 0.0;
        typical[k + 1] = rate;
    }
    if let Some(k) = motion.account_start() {
        let mut y = vec![0.0; motion.dim()];
        let rest = motion.stored_energy(0.0, &y).unwrap_or(0.0);
        y[n..2 * n].copy_from_slice(&typical[n..2 * n]);
        let energy = (motion.stored_energy(0.0, &y).unwrap_or(0.0) - rest).abs();
        let energy = if energy > 0.0 && energy.is_finite() { energy } else { 1.0 };
        typical[k..k + ACCOUNT].fill(energy);
    }
    debug_assert_eq!(typical.len(), 2 * n + m + motion.dim() - (2 * n + m));
    (Tolerance::Each(relative), Tolerance::Each(typical.into_iter().map(|x| x * plan.absolute).collect()))
}

const TRIAL: u64 = 200;
/// Step times spectral radius at which the explicit method works at the border of its stability (about 6 on the real axis).
const BORDER: f64 = 3.5;
/// The same of a machine by entries, whose implicit steps cost little more than explicit ones: its high modes decay, and what limits the first steps does not limit later ones.
const BORDER_BY_ENTRIES: f64 = 1.0;

/// A trial of some explicit steps: are they as long as stability, not accuracy, allows, and is there still far to go?
fn explicit_is_limited_by_stability(motion: &mut Motion, y: &[f64], plan: &Plan, relative: &Tolerance, absolute: &Tolerance) -> bool {
    let mut state = y.to_vec();
    let control =
        Control { max_steps: TRIAL.min(plan.max_steps), cancel: Some(plan.cancel), ..Control::new(relative.clone(), absolute.clone()) };
    let run = integrate(&mut Dop853::new(), motion, 0.0, &mut state, plan.t_end, &control, &mut ());
    if !matches!(run.end, End::WorkLimit { .. } | End::StepTooSmall { .. }) {
        return false;
    }
    let Some(radius) = motion.spectral_radius(run.t, &state) else { return false };
    let length = run.t / run.work.steps.max(1) as f64;
    // few steps are cheap whatever limits them
    let border = if motion.is_by_entries() { BORDER_BY_ENTRIES } else { BORDER };
    length * radius > border && plan.t_end > 5000.0 * length
}

fn legs<'a, M: Method<Motion<'a>>>(
    method: &mut M,
    motion: &mut Motion<'a>,
    y: &mut [f64],
    plan: &Plan,
    (relative, absolute): (Tolerance, Tolerance),
    watch: &mut Watch,
) -> Run {
    let mut cuts: Vec<f64> = match motion.law() {
        SpinLaw::Programme(p) => p.knots().collect(),
        SpinLaw::Free => Vec::new(),
    };
    let kick = plan.kick.as_ref();
    cuts.extend(kick.map(|k| k.0));
    cuts.retain(|&t| t > 0.0 && t < plan.t_end);
    cuts.push(plan.t_end);
    ascending(&mut cuts);
    let left = watch.left.clone();
    let cancel = &|| left.get().is_some() || (plan.cancel)();
    let surfaces = &Surfaces::new(motion, y);
    watch.switching = !surfaces.list.is_empty();
    let functions: Vec<_> = (0..surfaces.list.len()).map(|i| move |t: f64, y: &[f64]| surfaces_value(surfaces, i, t, y)).collect();
    let events: Vec<Event> = functions.iter().map(|g| Event::new(g).terminal()).collect();
    let mut total = Run { t: 0.0, end: End::Reached, next_step: 0.0, work: Work::default() };
    let mut cut = 0;
    let mut first_step = None;
    let mut kicked = false;
    loop {
        if let Some((t, change)) = kick
            && !kicked
            && total.t >= *t
        {
            kicked = true;
            first_step = None;
            if let Err(what) = give_kick(motion, total.t, y, change) {
                total.end = End::Failed { t: total.t, what };
                return total;
            }
        }
        while cut < cuts.len() && total.t >= cuts[cut] {
            cut += 1;
        }
        let Some(&to) = cuts.get(cut) else { return total };
        if let Err(what) = motion.settle(total.t, y) {
            total.end = End::Failed { t: total.t, what };
            return total;
        }
        let given = watch.times.len();
        let last = plan.outputs.partition_point(|&t| t <= to);
        let done = total.work.steps + total.work.rejected;
        let control = Control {
            outputs: &plan.outputs[given.min(last)..last],
            events: &events,
            cancel: Some(cancel),
            first_step,
            max_steps: plan.max_steps.saturating_sub(done),
            ..Control::new(relative.clone(), absolute.clone())
        };
        let run = integrate(method, motion, total.t, y, to, &control, watch);
        let w = &mut total.work;
        w.steps += run.work.steps;
        w.rejected += run.work.rejected;
        w.rhs += run.work.rhs;
        w.jacobians += run.work.jacobians;
        w.factorisations += run.work.factorisations;
        w.iterations += run.work.iterations;
        (total.t, total.next_step) = (run.t, run.next_step);
        match run.end {
            End::Reached => first_step = None,
            End::Event { index, t } => {
                let (slot, surface) = surfaces.list[index];
                // what is left of the distance to the surface after its own crossing may cross it once more
                let again = watch.contacts.last().is_some_and(|c| (c.0, c.1) == (slot, surface) && t - c.2 <= INSTANT * run.next_step);
                if !again {
                    watch.contacts.push((slot, surface, t));
                }
                // the step that ends here, integrated again: its interpolant is less accurate than the method
                let (from, start) = &watch.step_start;
                let control = Control {
                    first_step: (t > *from).then_some(t - from),
                    cancel: Some(cancel),
                    max_steps: plan.max_steps.saturating_sub(total.work.steps + total.work.rejected).max(1),
                    ..Control::new(relative.clone(), absolute.clone())
                };
                y.copy_from_slice(start);
                let again = integrate(method, motion, *from, y, t, &control, &mut ());
                total.work.rhs += again.work.rhs;
                // an accepted step that is repeated counts once
                total.work.rejected += again.work.rejected;
                if again.end != End::Reached {
                    (total.t, total.end) = (again.t, again.end);
                    return total;
                }
                first_step = (run.next_step > 0.0).then_some(run.next_step);
            }
            end => {
                total.end = end;
                return total;
            }
        }
    }
}

fn give_kick(motion: &mut Motion, t: f64, y: &mut [f64], change: &[f64]) -> Result<(), laval_num::ode::Failure> {
    let before = motion.account_start().map(|k| (k, motion.stored_energy(t, y).unwrap_or(f64::NAN)));
    motion.kick(t, y, change)?;
    if let Some((k, before)) = before {
        // the kick counts among the sources
        y[k + 1] += motion.stored_energy(t, y).unwrap_or(f64::NAN) - before;
    }
    Ok(())
}

/// The switching surfaces of all parts.
struct Surfaces<'a> {
    system: &'a System,
    law: SpinLaw,
    /// Slot and surface of the part.
    list: Vec<(usize, usize)>,
    zero: Vec<f64>,
    scratch: RefCell<(Workspace<f64>, Vec<f64>)>,
}

impl<'a> Surfaces<'a> {
    fn new(motion: &Motion<'a>, y: &[f64]) -> Self {
        let system = motion.system();
        let mut s = Surfaces { system, law: motion.law().clone(), list: vec![], zero: vec![0.0; system.n()], scratch: RefCell::default() };
        for k in 0..system.slots().len() {
            s.evaluate(k, 0.0, y);
            let count = s.scratch.borrow().1.len();
            s.list.extend((0..count).map(|i| (k, i)));
        }
        s
    }
    fn evaluate(&self, k: usize, t: f64, y: &[f64]) {
        let slot = &self.system.slots()[k];
        let at = point(self.system, t, spin_of(self.system, &self.law, t, y), y, &self.zero);
        let (workspace, out) = &mut *self.scratch.borrow_mut();
        out.clear();
        let Some(contacts) = slot.part.contacts() else { return };
        self.system.with_local(slot, &at, workspace, |l| contacts.switches(&self.system.params()[slot.params.clone()], l, out));
    }
}

fn surfaces_value(s: &Surfaces, index: usize, t: f64, y: &[f64]) -> f64 {
    let (slot, surface) = s.list[index];
    s.evaluate(slot, t, y);
    s.scratch.borrow().1.get(surface).copied().unwrap_or(f64::NAN)
}

fn spin_of(system: &System, law: &SpinLaw, t: f64, y: &[f64]) -> Spin {
    match law {
        SpinLaw::Programme(p) => p.at(t),
        SpinLaw::Free => {
            let k = 2 * system.n() + system.m();
            Spin { phase: y[k], speed: y[k + 1], accel: 0.0 }
        }
    }
}

/// Follows what one probe measures.
struct Track {
    probe: Probe,
    /// The same at rest.
    rest: [f64; 2],
    peak: Peak,
    windows: Vec<Window>,
    angle: f64,
    last: [f64; 2],
    /// The last two probes: time and squared displacement.
    before: [(f64, f64); 2],
}

struct Watch<'a> {
    system: &'a System,
    law: SpinLaw,
    t_end: f64,
    progress: &'a dyn Fn(f64),
    times: Vec<f64>,
    states: Vec<f64>,
    tracks: Vec<Track>,
    contacts: Vec<(usize, usize, f64)>,
    validity: Vec<Use>,
    y: Vec<f64>,
    dy: Vec<f64>,
    workspace: Workspace<f64>,
    steps: u64,
    bound: f64,
    left: Rc<Cell<Option<Left>>>,
    /// Time and state where the last step began; kept only for machines with switching laws.
    step_start: (f64, Vec<f64>),
    switching: bool,
}

/// Least number of probes of the displacements inside a step.
const PROBES: usize = 4;

impl<'a> Watch<'a> {
    fn new(system: &'a System, law: SpinLaw, plan: &'a Plan, dim: usize) -> Self {
        let empty = Window { peak: Peak { amplitude: f64::NAN, t: f64::NAN }, angle: f64::NAN, last: f64::NAN };
        let track = |probe: &Probe| Track {
            rest: if plan.rest.is_empty() { [0.0; 2] } else { probe.of(plan.rest) },
            probe: probe.clone(),
            peak: Peak::default(),
            windows: vec![empty; plan.windows],
            angle: 0.0,
            last: [0.0; 2],
            before: [(f64::NAN, f64::NAN); 2],
        };
        Watch {
            system,
            law,
            t_end: plan.t_end,
            progress: plan.progress,
            times: Vec::with_capacity(plan.outputs.len()),
            states: Vec::with_capacity(plan.outputs.len() * dim),
            tracks: system.probes().iter().map(track).collect(),
            contacts: Vec::new(),
            validity: Vec::new(),
            y: vec![0.0; dim],
            dy: vec![0.0; dim],
            workspace: Workspace::default(),
            steps: 0,
            bound: plan.bound,
            left: Rc::default(),
            step_start: (0.0, vec![0.0; dim]),
            switching: false,
        }
    }

    fn start(&mut self, y: &[f64]) {
        for track in &mut self.tracks {
            track.last = track.place(y);
            track.probe(0.0, track.last, self.t_end);
        }
    }

    /// Probes inside a step: one at least in each window of the envelope that it passes through.
    fn probes(&self, length: f64) -> usize {
        let windows = self.tracks.first().map_or(0, |track| track.windows.len());
        PROBES.max(1 + (length / self.t_end * windows as f64).ceil() as usize)
    }

    fn assess(&mut self, t: f64, y: &[f64]) {
        let n = self.system.n();
        let mut spin = spin_of(self.system, &self.law, t, y);
        if self.law == SpinLaw::Free {
            spin.accel = self.dy[2 * n + self.system.m() + 1];
        }
        let at = At { a: &self.dy[n..2 * n], ..point(self.system, t, spin, y, &self.dy) };
        for (slot, v) in self.system.validity(&at, &mut self.workspace) {
            let entry = match self.validity.iter_mut().find(|u| u.slot == slot && u.what == v.what) {
                Some(u) => u,
                None => {
                    self.validity.push(Use {
                        slot,
                        what: v.what,
                        ratio: f64::NEG_INFINITY,
                        t,
                        exceeded: None,
                        begin: t,
                        until: None,
                        after: 0.0,
                    });
                    let last = self.validity.len() - 1;
                    &mut self.validity[last]
                }
            };
            // a ratio that is not a number counts as exceeded
            if v.ratio > entry.ratio || v.ratio.is_nan() {
                (entry.ratio, entry.t) = (v.ratio, t);
            }
            if v.ratio <= 1.0 {
                entry.after = entry.after.max(v.ratio);
            } else {
                entry.exceeded.get_or_insert(t);
                (entry.until, entry.after) = (Some(t), 0.0);
            }
        }
    }
}

impl Track {
    /// Displacement from rest.
    fn place(&self, y: &[f64]) -> [f64; 2] {
        let [px, py] = self.probe.of(y);
        [px - self.rest[0], py - self.rest[1]]
    }
    fn probe(&mut self, t: f64, [x, y]: [f64; 2], t_end: f64) {
        let [px, py] = self.last;
        let turned = (px * y - py * x).atan2(px * x + py * y);
        self.angle += turned;
        self.last = [x, y];
        let square = x * x + y * y;
        let count = self.windows.len();
        let k = ((t / t_end * count as f64) as usize).min(count.saturating_sub(1));
        let raise = |w: &mut Peak, amplitude: f64, t: f64| {
            if amplitude > w.amplitude || w.amplitude.is_nan() {
                *w = Peak { amplitude, t };
            }
        };
        raise(&mut self.peak, square.sqrt(), t);
        if let Some(w) = self.windows.get_mut(k) {
            raise(&mut w.peak, square.sqrt(), t);
            (w.angle, w.last) = (self.angle, t);
        }
        // a maximum between probes, by the parabola through three of them
        let [(t0, f0), (t1, f1)] = self.before;
        if f1 >= f0 && f1 >= square && t > t1 && t1 > t0 {
            let (d01, d12) = ((f1 - f0) / (t1 - t0), (square - f1) / (t - t1));
            let curvature = (d12 - d01) / (t - t0);
            let at = 0.5 * (t0 + t1) - 0.5 * d01 / curvature;
            if curvature < 0.0 && at > t0 && at < t {
                let amplitude = (f0 + (at - t0) * (d01 + curvature * (at - t1))).max(0.0).sqrt();
                raise(&mut self.peak, amplitude, at);
                if let Some(w) = self.windows.get_mut(k) {
                    raise(&mut w.peak, amplitude, at);
                }
            }
        }
        self.before = [(t1, f1), (t, square)];
    }
}

impl Observer for Watch<'_> {
    fn step(&mut self, step: &Step<'_>) {
        let mut y = std::mem::take(&mut self.y);
        let probes = self.probes(step.t1 - step.t0);
        for p in 1..=probes {
            let t = if p == probes { step.t1 } else { step.t0 + (step.t1 - step.t0) * (p as f64 / probes as f64) };
            step.eval(t, &mut y);
            for track in &mut self.tracks {
                track.probe(t, track.place(&y), self.t_end);
            }
        }
        step.eval_derivative(step.t1, &mut self.dy);
        self.assess(step.t1, &y);
        if self.left.get().is_none() {
            let away = |t: &Track| t.last[0].hypot(t.last[1]);
            // a displacement that is no number is past every bound, but has no place: the step size control ends there
            let far = self.tracks.iter().find(|t| !t.probe.is_tilt() && away(t) > self.bound);
            self.left.set(far.map(|track| Left { body: track.probe.station, displacement: away(track), t: step.t1 }));
        }
        self.y = y;
        if self.switching {
            self.step_start.0 = step.t0;
            self.step_start.1.copy_from_slice(step.y0);
        }
        self.steps += 1;
        if self.steps.is_multiple_of(256) {
            (self.progress)(step.t1);
        }
    }
    fn output(&mut self, _: usize, t: f64, y: &[f64]) {
        self.times.push(t);
        self.states.extend_from_slice(y);
    }
    fn event(&mut self, _: &Crossing, _: &[f64]) {}
}
