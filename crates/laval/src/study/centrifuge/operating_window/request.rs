//! What is requested: the fields of the study on this machine, with all that is wrong.

use super::margins::Requirements;
use super::vary::{current, unknown, varied};
use super::{MAP_PLACES, Objective, OperatingWindow, Policy, contents};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::Values;
use crate::model::system::System;
use crate::separation::batch::RunUp;
use crate::study::centrifuge::cups;
use crate::study::centrifuge::cups::task::{self, Task};
use crate::study::shared::limits::{self, Limits};
use crate::study::shared::support::range;
use crate::text;
use crate::text::Text;
use std::sync::Arc;

/// Most uncertain parameters: their corners are all evaluated.
const MOST_UNCERTAIN: usize = 5;

fn wrong(out: &mut Diagnostics, values: &Values, field: &str, code: &'static str, message: Text, help: Text) {
    out.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
}

/// Reads the study; says all that is wrong.
pub(super) fn read(values: &Values, system: &System, out: &mut Diagnostics) -> Option<OperatingWindow> {
    let given = values.range("speed")?;
    let mut own = Diagnostics::default();
    let speed = range("speed", given, 5, values, &mut own);
    if speed.is_some_and(|s| s.from <= 0.0) {
        let help = text!("begin at a low speed, such as a tenth of the highest");
        wrong(&mut own, values, "speed", "operating_window.speed", text!("the range of speeds must begin above standstill"), help);
    }
    let objective = match values.choice("objective") {
        Some("time") => Objective::Time,
        Some("energy") => Objective::Energy,
        Some("amplitude") => Objective::Amplitude,
        _ => Objective::Margin,
    };
    let limits = limits::of(system);
    separated(values, system, given.to, &mut own);
    run_up(values, &limits, &mut own);
    aimed(objective, values, system, &limits, &mut own);
    let uncertain = uncertain(values, system, &mut own);
    let map = values.parameter_range("map").map(|(path, required)| {
        let sound = range("map", required, 2, values, &mut own);
        let trial = sound.map(|r| r.from).or_else(|| current(system, path));
        if let Err(d) = trial.map_or_else(|| Err(unknown(system, path)), |x| varied(system, path, x).map(drop)) {
            own.push(d.at(values.span_of("map")));
        }
        (path.to_string(), required)
    });
    let fine = !own.has_errors();
    out.0.append(&mut own.0);
    fine.then(|| OperatingWindow {
        speed: given,
        values: values.clone(),
        objective,
        tolerance: values.number("speed_tolerance").unwrap_or(0.0),
        uncertain,
        map,
    })
}

/// Parameters that are uncertain, with their shares.
fn uncertain(values: &Values, system: &System, out: &mut Diagnostics) -> Vec<(String, f64)> {
    let mut found = Vec::new();
    for (name, share) in values.named("uncertain") {
        let Some(path) = name else {
            let help = text!("write uncertain = {{ suspension.viscosity = \"20 %\" }}");
            wrong(out, values, "uncertain", "operating_window.uncertain", text!("which parameters are uncertain is missing"), help);
            continue;
        };
        let trial = current(system, path).ok_or_else(|| unknown(system, path)).and_then(|x| varied(system, path, x));
        if let Err(d) = trial {
            out.push(d.at(values.span_of("uncertain")));
        }
        found.push((path.to_string(), share));
    }
    if found.len() > MOST_UNCERTAIN {
        let message = text!("{found} uncertain parameters are too many: every corner is evaluated", found = found.len());
        wrong(out, values, "uncertain", "operating_window.uncertain", message, text!("keep at most five"));
    }
    found
}

/// The machine has something to separate and something that separates it.
fn separates(system: &System) -> bool {
    let has = |word: &str| system.machine.extras.iter().any(|e| e.word == word);
    has("suspension") && has("cup")
}

/// A time or throughput is given.
fn timed(values: &Values) -> Option<&'static str> {
    ["time", "throughput"].into_iter().find(|field| values.number(field).is_some())
}

/// The separation that is requested, when the machine separates; `top` is the end of the run-up, rad/s.
fn separated(values: &Values, system: &System, top: f64, out: &mut Diagnostics) -> Option<Task> {
    if !separates(system) {
        if let Some(field) = timed(values) {
            let message = text!("a time or throughput needs something to separate, and something that separates it");
            wrong(out, values, field, "operating_window.separation", message, text!("add the blocks [[cup]] and [suspension]"));
        }
        return None;
    }
    let mut task = task::task(values, system, None, out)?;
    if let Some(t) = values.number("ramp").filter(|_| values.flag("count_ramp").unwrap_or(true)) {
        if task.throughput.is_none() && !(t <= task.time) {
            let message = text!(
                "the run-up to the top of the range takes {ramp}, longer than the {time} at hand that count from its start",
                ramp = text::quantity(t, "s"),
                time = text::quantity(task.time, "s")
            );
            let help = text!(
                "give a shorter ramp, a lower top of the range or more time; with count_ramp = false the time counts from the end of the run-up"
            );
            wrong(out, values, "ramp", "operating_window.ramp", message, help);
            return None;
        }
        task.batch.run_up = RunUp::Linear(t / top);
    }
    Some(task)
}

/// What needs the time of the run-up has it.
fn run_up(values: &Values, limits: &Limits, out: &mut Diagnostics) {
    if values.number("ramp").is_some() {
        return;
    }
    let help = text!("add ramp = \"60 s\": the time to the top of the range of speeds");
    if policy(values) == Policy::Reached {
        let message = text!("the state that a run-up leads to needs the time of the run-up");
        wrong(out, values, "branch_policy", "operating_window.separation", message, help);
    } else if !limits.passage.is_empty() || limits.torque.is_some() {
        let message = text!("the limits on the passage need the time of the run-up");
        wrong(out, values, "ramp", "operating_window.separation", message, help);
    }
}

/// What the best speed is best for exists.
fn aimed(objective: Objective, values: &Values, system: &System, limits: &Limits, out: &mut Diagnostics) {
    // where a time is given, what separates is missing already
    if objective == Objective::Time && !separates(system) && timed(values).is_none() {
        let message = text!("there is no separation whose time could be shortest");
        wrong(
            out,
            values,
            "objective",
            "operating_window.objective",
            message,
            text!("add [[cup]], [suspension] and time (throughput where liquid flows through)"),
        );
    }
    if objective == Objective::Amplitude && !limits.vibration() {
        let message = text!("no limit on vibration is given that amplitudes could be measured against");
        wrong(
            out,
            values,
            "objective",
            "operating_window.objective",
            message,
            text!("add displacement, velocity, tilt, force or moment to [limits]"),
        );
    }
}

pub(super) fn policy(values: &Values) -> Policy {
    match values.choice("branch_policy") {
        Some("reached") => Policy::Reached,
        Some("highest") => Policy::Highest,
        _ => Policy::All,
    }
}

/// The separation and the limits requested of a machine like the one that the study was read for.
///
/// # Errors
/// When its cups and suspension no longer fit what is requested.
pub(super) fn requested(study: &OperatingWindow, system: &System) -> Result<(Option<Task>, Limits), Diagnostic> {
    let (v, mut own) = (&study.values, Diagnostics::default());
    let task = separated(v, system, study.speed.to, &mut own);
    let limits = limits::of(system);
    run_up(v, &limits, &mut own);
    if own.has_errors() {
        return Err(Diagnostic::error(
            "operating_window.separation",
            text!("what the study requires of the machine does not fit its cups and suspension"),
        ));
    }
    Ok((task, limits))
}

/// All that is requested of such a machine; for a map with fewer places.
///
/// # Errors
/// As [`requested`]; a machine that cannot be after the separation.
pub(super) fn fitting(study: &OperatingWindow, system: &System, map: bool) -> Result<Requirements, Diagnostic> {
    let (v, (mut task, limits)) = (&study.values, requested(study, system)?);
    let cups = cups::carried(system);
    let after = match task.as_ref().and_then(|task| {
        let own = cups.iter().position(|c| c.name == task.vessel.name);
        contents::changed(system, task, &cups, own)
    }) {
        Some(changed) => Some(Arc::new(contents::after(system, &changed)?)),
        None => None,
    };
    if let Some(task) = task.as_mut().filter(|_| map) {
        task.batch.places = task.batch.places.min(MAP_PLACES);
    }
    Ok(Requirements { task, limits, cups, after, ramp: v.number("ramp"), policy: policy(v) })
}
