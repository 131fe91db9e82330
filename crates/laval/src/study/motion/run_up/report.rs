//! Findings, tables and figures of a run-up.

use super::{BodyPassages, Nature, Passage, RunUp, RunUpResult};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Band, Figure, Finding, Line, Outcome, Panel, Rule, SpecialPoint, Status};
use crate::study::Study;
use crate::study::motion::history::{self, Columns, ProbeMotion};
use crate::study::motion::passages::{envelope, reach};
use crate::study::motion::unstable::Range;
use crate::study::motion::{balance, drive, start};
use crate::study::shared::support::place;
use laval_num::order::ascending;

pub(super) fn report(study: &RunUp, system: &System, result: &RunUpResult, name: &str) -> Result<Outcome, Diagnostic> {
    let record = &result.motion;
    let mut outcome = Outcome::new(RunUp::KIND, name).over("speed", "rad/s").end(result.end);
    for f in history::stop(record).into_iter().chain(start::undeflected(&record.undeflected)) {
        outcome = outcome.finding(f);
    }
    match record.left {
        Some(left) => {
            let speed = study.programme.at(left.t).speed;
            let f = history::unbounded(system, left, &result.unbounded, std::f64::consts::TAU / speed.abs(), speed);
            outcome = outcome.finding(f.evidence("speed there", speed, "rad/s"));
        }
        None => outcome = peaks(study, system, result, outcome),
    }
    outcome = record.moved_roots.as_ref().map(|m| m.finding()).into_iter().fold(outcome, Outcome::finding);
    outcome = drive_shown(system, result, outcome)?;
    outcome = history::common_findings(system, record, outcome);
    outcome = envelope_shown(study, system, result, outcome)?;
    if let Some(spectra) = &study.spectra {
        outcome = spectra.report(record, outcome)?;
    }
    let outcome = history::shown(system, record, None, outcome)?;
    balance::report(system, record, outcome)
}

/// Largest displacements and the passages through resonances.
fn peaks(study: &RunUp, system: &System, result: &RunUpResult, mut outcome: Outcome) -> Outcome {
    let record = &result.motion;
    for seen in history::probe_motions(system, record, history::negligible(&study.settings, &record.rest)) {
        let peak = seen.peak;
        let Some(largest) = seen.largest() else { continue };
        let speed = study.programme.at(peak.t).speed;
        outcome = outcome.finding(largest.evidence("at speed", speed, "rad/s").evidence("at time", peak.t, "s"));
        if let Some(own) = result.passages.iter().find(|p| p.body == seen.body && p.tilt == seen.tilt) {
            outcome = passed(&seen, own, outcome);
        }
    }
    outcome
}

fn passed(seen: &ProbeMotion, own: &BodyPassages, mut outcome: Outcome) -> Outcome {
    let (b, unit) = (seen.label(), seen.unit);
    for p in &own.passages {
        let (before, after) = p.beside;
        let finding = passage(p).of(&b).value(p.speed, "rad/s").arg("body", seen.arg()).evidence("amplitude", p.amplitude, unit);
        let point = SpecialPoint::new("peak", p.speed, (before.min(after), before.max(after))).status(Status::Bracketed);
        let finding = finding.evidence("at time", p.t, "s");
        let finding = if p.beats > 0 { finding.evidence("beats of the same passage", p.beats as f64, "") } else { finding };
        outcome = outcome.finding(finding).special_point(point.evidence("amplitude", p.amplitude, unit));
    }
    if let Some(swings) = &own.swings {
        let finding = Finding::info("swings", "run-up-swings").of(&b).value(swings.speed, "rad/s").arg("body", seen.arg());
        outcome = outcome.finding(finding.evidence("amplitude", swings.amplitude, unit).evidence("peaks", swings.peaks as f64, ""));
    }
    outcome
}

/// What a peak of the envelope is.
fn passage(p: &Passage) -> Finding {
    match p.nature {
        Nature::Resonance => Finding::info("peak", "run-up-resonance"),
        Nature::Peak => Finding::info("peak", "run-up-peak"),
        Nature::Unstable(Range { speeds: [a, b], factor, rate }) => {
            let finding = Finding::warning("unstable_range", "run-up-unstable-range").arg("range", place(a, b));
            finding.arg("factor", Arg::number(factor).digits(2)).evidence("largest growth rate there", rate, "1/s")
        }
    }
}

/// Torque and power of the drive at the outputs.
fn drive_shown(system: &System, result: &RunUpResult, outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let (record, torque) = (&result.motion, &result.torque);
    let spins = &record.spin;
    let power: Vec<f64> = torque.iter().zip(spins).map(|(m, s)| m * s.speed).collect();
    let accelerates = spins.iter().any(|s| s.accel != 0.0);
    let speeds: Vec<f64> = spins.iter().map(|s| s.speed).collect();
    let driven = speeds.first().is_some_and(|&w| system.drive_torque(w).is_some());
    let short = drive::short(system, &speeds, torque, accelerates);
    let lacking = if accelerates { drive::spin_inertia(system) } else { None };
    let largest =
        |x: &[f64]| x.iter().enumerate().map(|(i, x)| (x.abs(), i)).max_by(|a, b| a.0.total_cmp(&b.0)).map_or((f64::NAN, 0), |m| m);
    let ((most, at), (strongest, when)) = (largest(torque), largest(&power));
    let speed = |i: usize| spins.get(i).map_or(f64::NAN, |s| s.speed);
    let mut columns = Columns::default();
    columns.add("t", "s", "time", record.times.clone());
    columns.add("speed", "rad/s", "spin speed", spins.iter().map(|s| s.speed).collect());
    columns.add("acceleration", "rad/s^2", "spin acceleration", spins.iter().map(|s| s.accel).collect());
    columns.add("torque", "N m", "torque the drive must bring", torque.clone());
    columns.add("power", "W", "power the drive must bring", power.clone());
    let line = |column: &str| Line::new("drive", "t", column);
    let figure = Figure::new("drive", "Drive", "run-up-alt-drive")
        .x(Axis::new("time", "s"))
        .panel(Panel::new(Axis::new("speed", "rad/s")).mark(line("speed")))
        .panel(Panel::new(both_signs("torque", "N m", torque)).mark(line("torque")))
        .panel(Panel::new(both_signs("power", "W", &power)).mark(line("power")));
    let outcome = outcome.table(columns.table("drive", "Torque and power of the drive against time")?).figure(figure);
    if record.left.is_some() {
        return Ok(outcome);
    }
    let outcome = short.into_iter().chain(lacking).fold(outcome, Outcome::finding);
    let torque = Finding::info("largest_torque", if driven { "run-up-torque-beyond-motors" } else { "run-up-torque" });
    let power = Finding::info("largest_power", if driven { "run-up-power-beyond-motors" } else { "run-up-power" });
    let at_speed = |f: Finding, w: f64| f.arg("speed", Arg::speed(w)).evidence("at speed", w, "rad/s");
    Ok(outcome.finding(at_speed(torque.value(most, "N m"), speed(at))).finding(at_speed(power.value(strongest, "W"), speed(when))))
}

/// The largest of some values over the middle one from which on their axis is logarithmic: the end of a motion that diverges hides all before it otherwise.
const DIVERGES: f64 = 1e3;

/// The middle and the largest of sizes that are finite and not zero; 0 where there are none.
fn middle_and_most(sizes: impl Iterator<Item = f64>) -> (f64, f64) {
    let mut all: Vec<f64> = sizes.filter(|x| x.is_finite() && *x > 0.0).collect();
    ascending(&mut all);
    (all.get(all.len() / 2).copied().unwrap_or(0.0), all.last().copied().unwrap_or(0.0))
}

/// An axis for values of both signs.
fn both_signs(label: &'static str, unit: &str, values: &[f64]) -> Axis {
    let (middle, most) = middle_and_most(values.iter().map(|x| x.abs()));
    let axis = Axis::new(label, unit);
    if most > DIVERGES * middle { axis.knee(10.0 * middle) } else { axis }
}

/// Envelope against speed, beside the linear response.
fn envelope_shown(study: &RunUp, system: &System, result: &RunUpResult, outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let (record, bodies) = (&result.motion, system.stations());
    if bodies.is_empty() {
        return Ok(outcome);
    }
    let seen: Vec<_> = record.windows.iter().map(|w| envelope(w, &|t| study.programme.at(t), reach(system))).collect();
    let middle = study.middles(record);
    let count = middle.len();
    let speeds: Vec<f64> = middle.iter().map(|&t| study.programme.at(t).speed).collect();
    let mut columns = Columns::default();
    columns.add("t", "s", "middle of the window", middle);
    for spin in system.spins().iter().filter(|s| s.name.is_some()) {
        let own = speeds.iter().map(|w| spin.ratio * w).collect();
        columns.add(format!("{} speed", spin.name.as_deref().unwrap_or_default()), "rad/s", "speed of this spin there", own);
    }
    columns.add("speed", "rad/s", "spin speed there", speeds);
    let mut figure = Figure::new("envelope", "Envelope against speed", "run-up-alt-envelope").x(Axis::new("speed", "rad/s"));
    let natures = result.passages.iter().flat_map(|p| &p.passages).map(|p| p.nature);
    let mut unstable: Vec<(f64, f64)> = Vec::new();
    for nature in natures {
        if let Nature::Unstable(Range { speeds: [a, b], .. }) = nature
            && !unstable.contains(&(a.min(b), a.max(b)))
        {
            unstable.push((a.min(b), a.max(b)));
        }
    }
    for (k, b) in bodies.iter().enumerate() {
        let amplitude = |i: usize| seen[k][i].amplitude;
        let doc = "largest distance from rest in the window and within half a turn of it";
        columns.add(format!("{} amplitude", b.name), "m", doc, (0..count).map(amplitude).collect());
        let (middle, most) = middle_and_most(seen[k].iter().map(|p| p.amplitude));
        let label = Arg::of("amplitude", Arg::name(&b.name));
        let axis = if most > DIVERGES * middle { Axis::log(label, "m").metres(middle) } else { Axis::new(label, "m").metres(most) };
        let mut panel = Panel::new(axis).mark(Line::new("envelope", "speed", format!("{} amplitude", b.name)).name("envelope"));
        let own = result.passages.iter().filter(|p| p.body == b.name && !p.tilt).flat_map(|p| &p.passages);
        for p in own.filter(|p| p.nature == Nature::Resonance) {
            panel = panel.mark(Rule::x(p.speed, "resonance"));
        }
        for &(from, to) in &unstable {
            panel = panel.mark(Band::x(from, to).name("unstable").strip());
        }
        if let Some(linear) = &result.linear {
            let name = format!("{} linear", b.name);
            columns.add(
                &name,
                "m",
                "largest |x + i y| of the steady linear response, at any point of the body, at this speed; NaN where nothing holds or damps the machine",
                linear[k].clone(),
            );
            panel = panel.mark(Line::new("envelope", "speed", name).name("linear steady-state response"));
        }
        figure = figure.panel(panel);
    }
    Ok(outcome.table(columns.table("envelope", "Envelope of the motion against speed")?).figure(figure))
}
