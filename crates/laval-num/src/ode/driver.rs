//! The loop over steps: lengths, limits, outputs and events.

use super::control::{Attempt, Cause, Control, End, Run, Work, finite};
use super::event::Crossing;
use super::step::Step;
use super::system::{Failure, Ode};
use crate::univariate::bracket;
use crate::work::spend;

/// Probes of every event in a step.
const PROBES: usize = 4;

/// A one-step method: a formula with its error estimate, step control and dense output. Drive it by [`integrate`].
pub trait Method<S: Ode + ?Sized> {
    /// Takes the initial state and proposes the length of the first step; `None` if f(t0, y0) is not finite.
    fn begin(&mut self, system: &mut S, span: (f64, f64), y: &[f64], control: &Control, work: &mut Work) -> Result<Option<f64>, Failure>;
    /// Tries the step `span`; its interpolant must be of full order only if `dense`.
    fn attempt(&mut self, system: &mut S, span: (f64, f64), dense: bool, work: &mut Work) -> Result<Attempt, Failure>;
    /// The step just accepted.
    fn step(&self) -> Step<'_>;
    /// Makes the end of the step just accepted the start of the next.
    fn advance(&mut self);
}

/// Receives what happens during an integration, in order of time within a step: outputs and events, then the step itself.
///
/// Every closure `FnMut(&Step)` is an observer of steps, and `()` one that looks at nothing.
pub trait Observer {
    /// Whether [`Observer::step`] evaluates the step's interior. If not, the step may carry a cubic interpolant only, which saves work.
    fn dense(&self) -> bool {
        true
    }
    /// An accepted step.
    fn step(&mut self, _step: &Step<'_>) {}
    /// The state at `t`, entry `index` of [`Control::outputs`].
    fn output(&mut self, _index: usize, _t: f64, _y: &[f64]) {}
    /// A located event and the state at its time.
    fn event(&mut self, _crossing: &Crossing, _y: &[f64]) {}
}

impl<F: FnMut(&Step<'_>)> Observer for F {
    fn step(&mut self, step: &Step<'_>) {
        self(step);
    }
}

impl Observer for () {
    fn dense(&self) -> bool {
        false
    }
}

/// Keeps outputs and events.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// Times of the outputs.
    pub times: Vec<f64>,
    /// States at those times, one after the other.
    pub states: Vec<f64>,
    /// Events in order of time.
    pub events: Vec<Crossing>,
    /// States at the events, one after the other.
    pub event_states: Vec<f64>,
}

impl Record {
    /// An empty record with room for `outputs` states of `dim` entries.
    pub fn with_capacity(outputs: usize, dim: usize) -> Self {
        Record { times: Vec::with_capacity(outputs), states: Vec::with_capacity(outputs * dim), ..Self::default() }
    }
}

impl Observer for Record {
    fn dense(&self) -> bool {
        false
    }
    fn output(&mut self, _index: usize, t: f64, y: &[f64]) {
        self.times.push(t);
        self.states.extend_from_slice(y);
    }
    fn event(&mut self, crossing: &Crossing, y: &[f64]) {
        self.events.push(*crossing);
        self.event_states.extend_from_slice(y);
    }
}

/// Integrates from `(t0, y)` to `t1`, forwards or backwards, leaving in `y` the state at [`Run::t`].
///
/// Every end is a value: after a failure `y` holds the last accepted state, and what was observed before stands. An event at `t0` (within 1e-10
/// of the first step) is not reported.
pub fn integrate<S: Ode + ?Sized, M: Method<S>>(
    method: &mut M,
    system: &mut S,
    t0: f64,
    y: &mut [f64],
    t1: f64,
    control: &Control,
    observer: &mut dyn Observer,
) -> Run {
    let mut run = Run { t: t0, end: End::Reached, next_step: 0.0, work: Work::default() };
    let result = advance(method, system, y, t1, control, observer, &mut run);
    run.end = match result {
        Ok(end) => end,
        Err(what) => End::Failed { t: run.t, what },
    };
    run
}

fn advance<S: Ode + ?Sized, M: Method<S>>(
    method: &mut M,
    system: &mut S,
    y: &mut [f64],
    t_end: f64,
    control: &Control,
    observer: &mut dyn Observer,
    run: &mut Run,
) -> Result<End, Failure> {
    check(system.dim(), run.t, y, t_end, control)?;
    let sign = if t_end >= run.t { 1.0 } else { -1.0 };
    let mut watch = Watch::start(control, run.t, y, sign)?;
    watch.outputs_until(run.t, &Step { t0: run.t, t1: run.t, y0: y, y1: y, h: 1.0, rows: &[] }, observer);
    let Some(first) = method.begin(system, (run.t, t_end), y, control, &mut run.work)? else {
        return Ok(if t_end == run.t { End::Reached } else { End::StepTooSmall { t: run.t, cause: Cause::NotFinite } });
    };
    run.next_step = first.min(control.max_step);
    while run.t != t_end {
        let t = run.t;
        spend(200 + 150 * y.len() as u64);
        if control.cancel.is_some_and(|cancel| cancel()) {
            return Ok(End::Cancelled { t });
        }
        if run.work.steps + run.work.rejected >= control.max_steps {
            return Ok(End::WorkLimit { t });
        }
        let shortest = (10.0 * f64::EPSILON * t.abs()).max(1e-290);
        let h = system.longest_step(t, y, run.next_step).max(shortest);
        // a last step a little longer than proposed spares a very short one
        let t1 = if (t_end - t).abs() <= 1.01 * h { t_end } else { t + sign * h };
        let dense = !control.events.is_empty() || observer.dense() || watch.next_output().is_some_and(|o| (t1 - o) * sign > 0.0);
        let factor = match method.attempt(system, (t, t1), dense, &mut run.work)? {
            Attempt::Accepted { factor } => factor,
            Attempt::Rejected { factor, cause } => {
                run.work.rejected += 1;
                if h <= shortest || (t1 - t).abs() <= shortest {
                    return Ok(End::StepTooSmall { t, cause });
                }
                run.next_step = (t1 - t).abs() * factor;
                continue;
            }
        };
        run.work.steps += 1;
        // a step cut short by the end says nothing against the length proposed before
        let proposed = (t1 - t).abs() * factor;
        run.next_step = if t1 == t_end { proposed.max(h) } else { proposed }.min(control.max_step);
        let step = method.step();
        let (terminal, failed) = watch.inside(&step, run.work.steps == 1, observer);
        let t_reached = terminal.map_or(step.t1, |c| c.t);
        step.eval(t_reached, y);
        run.t = t_reached;
        observer.step(&Step { t1: t_reached, y1: y, ..step });
        if let Some(what) = failed {
            return Err(what);
        }
        if let Some(c) = terminal {
            return Ok(End::Event { index: c.index, t: c.t });
        }
        method.advance();
    }
    Ok(End::Reached)
}

/// The request makes sense.
fn check(dim: usize, t0: f64, y: &[f64], t1: f64, control: &Control) -> Result<(), Failure> {
    if y.len() != dim {
        return Err(format!("the state has {} entries, the system {dim}", y.len()).into());
    }
    if !(t0.is_finite() && t1.is_finite() && finite(y)) {
        return Err("the initial state and the times must be finite".into());
    }
    // NaN fails
    if !(control.max_step > 0.0 && control.first_step.is_none_or(|h| h > 0.0 && h.is_finite())) {
        return Err("the first and the longest step must be positive".into());
    }
    let (lo, hi) = (t0.min(t1), t0.max(t1));
    let ordered = control.outputs.windows(2).all(|w| (w[1] - w[0]) * (t1 - t0) >= 0.0);
    if !ordered || !control.outputs.iter().all(|&t| t >= lo && t <= hi) {
        return Err("the output times must lie between the ends, in the order of integration".into());
    }
    Ok(())
}

/// Outputs and events still to come.
struct Watch<'a> {
    control: &'a Control<'a>,
    sign: f64,
    output: usize,
    /// Values of the events at the last probe.
    values: Vec<f64>,
    probe: Vec<f64>,
    scratch: Vec<f64>,
    found: Vec<Crossing>,
}

impl<'a> Watch<'a> {
    fn start(control: &'a Control<'a>, t: f64, y: &[f64], sign: f64) -> Result<Self, Failure> {
        let values: Vec<f64> = control.events.iter().map(|e| (e.g)(t, y)).collect();
        if let Some(i) = values.iter().position(|g| g.is_nan()) {
            return Err(not_a_number(i));
        }
        Ok(Watch {
            control,
            sign,
            output: 0,
            values,
            probe: y.to_vec(),
            scratch: y.to_vec(),
            found: Vec::with_capacity(control.events.len()),
        })
    }

    fn next_output(&self) -> Option<f64> {
        self.control.outputs.get(self.output).copied()
    }

    fn outputs_until(&mut self, t: f64, step: &Step, observer: &mut dyn Observer) {
        while let Some(o) = self.next_output().filter(|o| (t - o) * self.sign >= 0.0) {
            step.eval(o, &mut self.probe);
            observer.output(self.output, o, &self.probe);
            self.output += 1;
        }
    }

    /// Reports outputs and events inside the step in order; returns the terminal event, or why an event could not be evaluated.
    fn inside(&mut self, step: &Step, first: bool, observer: &mut dyn Observer) -> (Option<Crossing>, Option<Failure>) {
        let mut a = step.t0;
        for p in 1..=PROBES {
            if self.values.is_empty() {
                break;
            }
            let b = if p == PROBES { step.t1 } else { step.t0 + step.h * (p as f64 / PROBES as f64) };
            if let Some(i) = self.locate(step, a, b, first) {
                return (None, Some(not_a_number(i)));
            }
            for i in 0..self.found.len() {
                let crossing = self.found[i];
                self.outputs_until(crossing.t, step, observer);
                step.eval(crossing.t, &mut self.probe);
                observer.event(&crossing, &self.probe);
                if self.control.events[crossing.index].terminal {
                    return (Some(crossing), None);
                }
            }
            a = b;
        }
        self.outputs_until(step.t1, step, observer);
        (None, None)
    }

    /// Collects the crossings between the probes `a` and `b` in order of time; returns the index of an event that is not a number.
    fn locate(&mut self, step: &Step, a: f64, b: f64, first: bool) -> Option<usize> {
        self.found.clear();
        step.eval(b, &mut self.probe);
        for (index, event) in self.control.events.iter().enumerate() {
            let (ga, gb) = (self.values[index], (event.g)(b, &self.probe));
            if gb.is_nan() {
                return Some(index);
            }
            self.values[index] = gb;
            let Some(direction) = event.crossing(ga, gb) else { continue };
            let scratch = &mut self.scratch;
            let zero = bracket(a, ga, b, gb, |t| {
                step.eval(t, scratch);
                (event.g)(t, scratch)
            });
            let Some(bracket) = zero else { return Some(index) };
            if first && (bracket.1 - step.t0).abs() <= 1e-10 * step.h.abs() {
                continue;
            }
            self.found.push(Crossing { index, t: bracket.1, bracket, direction });
        }
        let sign = self.sign;
        self.found.sort_unstable_by(|p, q| (sign * p.t).total_cmp(&(sign * q.t)).then(p.index.cmp(&q.index)));
        None
    }
}

fn not_a_number(index: usize) -> Failure {
    format!("event {index} is not a number").into()
}
