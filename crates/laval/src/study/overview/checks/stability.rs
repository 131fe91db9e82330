//! Stability at the operating speeds.

use super::super::margins;
use super::super::operating::{Operating, span};
use super::super::studied::{self, Needed};
use super::super::worst::decrement;
use super::super::{Facts, ends};
use crate::outcome::{Arg, Check, Message, OverSpeed, Verdict};
use crate::solve::machine_mode::{MachineMode, Whirl};
use crate::solve::pencil::Spectrum;
use crate::solve::roots::has_more_modes;
use crate::study::Study;
use crate::study::linear::whirl::{aperiodic, far};
use crate::study::shared::support::{growth_rounding, larger};
use std::f64::consts::TAU;

/// The check of stability found motions that grow.
pub(in super::super) fn grows(stability: &Check) -> bool {
    matches!(
        stability.result.key.as_str(),
        "stability-unstable" | "stability-unstable-range" | "stability-no-state" | "stability-no-steady"
    )
}

/// Frequency over growth up to which a motion is a divergence: gyroscopic moments turn that of a buckled shaft a little while it spins.
const STATIC: f64 = 1e-2;

/// Real positive roots are a static instability, complex ones a whirl.
fn motion(growth: f64, frequency: f64) -> Arg {
    Arg::word(if frequency > STATIC * growth { "whirl" } else { "divergence" })
}

/// Whether the machine is stable at its speed, in the words of the study of modes.
pub(super) fn stability(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Check {
    let decay = if facts.limits.growth > 0.0 { Arg::quantity(facts.limits.growth, "1/s") } else { Arg::word("none") };
    let required = Some(Arg::from(Message::new("required-decay").arg("margin", decay)));
    let of = |result: Message, verdict| Check { required: required.clone(), ..Check::new("check-stability", result, verdict) };
    if let Some((value, name)) = studied::unstable(facts.outcomes, Needed::of(speed, facts.sign)) {
        let frequency = if aperiodic(value) { 0.0 } else { value.im.abs() };
        let result = Message::new("stability-unstable").arg("time", Arg::quantity(1.0 / value.re, "s"));
        let source = Message::new("from-study").arg("study", Arg::name(name));
        return Check { detail: Some(source), ..of(result.arg("motion", motion(value.re, frequency)), Verdict::Failed) };
    }
    if let Some(Some(value)) = facts.growing {
        let result = Message::new("stability-unstable").arg("time", Arg::quantity(1.0 / value.re, "s"));
        let detail = Message::new("stability-mode")
            .arg("frequency", Arg::frequency(value.im.abs()))
            .arg("decrement", Arg::number(-TAU * value.re / value.im.abs()));
        let detail = (value.im.abs() > 0.0).then(|| detail.arg("place", Arg::word("none")));
        return Check { detail, ..of(result.arg("motion", motion(value.re, value.im.abs())), Verdict::Failed) };
    }
    let Some((study, known)) = &facts.modes else { return of(Message::new("why-no-speed"), Verdict::NotComputed) };
    let Some(result) = known.get() else {
        let (result, detail, verdict) = along(facts, over, speed).unwrap_or_else(|| (known.why(), None, Verdict::NotComputed));
        return Check { detail, ..of(result, verdict) };
    };
    let Ok(outcome) = study.report(facts.system, result, "modes") else {
        return of(Message::new("why-too-long"), Verdict::NotComputed);
    };
    let has = |id: &str| outcome.findings.iter().any(|f| f.id == id);
    let Some(least) = result.spectrum.least_stable() else { return of(Message::new("stability-no-mode"), Verdict::NotComputed) };
    // of a range of speeds the least stable one counts
    let (value, modes, place) = match &facts.worst {
        Some(w) if !(w.value.re <= least.growth()) => (w.value, w.modes, Some(w.speed)),
        _ => (least.value, result.spectrum.held().count(), facts.worst.as_ref().map(|_| study.speed.abs())),
    };
    let (growth, frequency) = (value.re, if aperiodic(value) { 0.0 } else { value.im.abs() });
    let threshold = study.threshold.max(facts.threshold);
    let slow = growth > 0.0 && growth <= threshold;
    let detail = (frequency > 0.0 && !slow).then(|| {
        Message::new("stability-mode")
            .arg("frequency", Arg::frequency(frequency))
            .arg("decrement", Arg::number(-TAU * growth / frequency))
            .arg("place", place.map_or(Arg::word("none"), Arg::speed))
    });
    let detail = known.source().or(detail);
    let named = |key: &str| {
        Message::new(key)
            .arg("modes", Arg::count(modes))
            .arg("growth", Arg::quantity(growth, "1/s"))
            .arg("decay", Arg::quantity(-growth, "1/s"))
            .arg("time", Arg::quantity(1.0 / growth.abs(), "s"))
            .arg("motion", motion(growth, frequency))
    };
    // unstable at other operating speeds than that of the modes
    let elsewhere = || {
        let first = *margins::instability(over?, speed).inside.first()?;
        let found = over?.unstable.iter().find(|u| u.to >= first);
        Some(found.map_or(speed.arg(), |u| span(u.from.max(speed.low), u.to.min(speed.high))))
    };
    let (message, verdict) = if has("unstable_mode") {
        (named("stability-unstable"), Verdict::Failed)
    } else if let Some(range) = elsewhere().filter(|_| !speed.is_one()) {
        return of(Message::new("stability-unstable-range").arg("range", range), Verdict::Failed);
    } else if !speed.is_one() && facts.worst.is_none() {
        // modes at one speed say nothing of the others
        let (result, detail, verdict) = along(facts, over, speed).unwrap_or_else(|| (facts.stability.why(), None, Verdict::NotComputed));
        return Check { detail, ..of(result, verdict) };
    } else if facts.worst.as_ref().is_some_and(|w| w.value.re.is_nan()) {
        return of(Message::new("stability-unknown"), Verdict::Attention);
    } else if slow && (has("stability_unknown") || has("slow_growth")) {
        // modes that grow below the threshold of the study: waves of an ideal liquid are not resolved further
        (Message::new("stability-slow").arg("limit", Arg::quantity(threshold, "1/s")), Verdict::Attention)
    } else if has("stability_unknown") || has("slow_growth") {
        (named("stability-unknown"), Verdict::Attention)
    } else if facts.limits.growth > 0.0 && !(-growth >= facts.limits.growth) {
        (named("stability-stable"), Verdict::Failed)
    } else if !(growth < 0.0) || outcome.findings.iter().any(|f| f.id == "stable" && f.value == Some(0.0)) {
        match decay_across(&result.spectrum).filter(|_| speed.is_one() && !(facts.limits.growth > 0.0)) {
            Some((modes, decay)) => {
                let m = Message::new("stability-across").arg("modes", Arg::count(modes)).arg("decay", Arg::quantity(decay, "1/s"));
                return of(m, Verdict::Passed);
            }
            None => (named("stability-neutral"), Verdict::Attention),
        }
    } else {
        let limit = result.roots.as_ref().map(|r| r.frequency).filter(|_| has_more_modes(facts.system));
        let below = |limit: f64| named("stability-stable-below").arg("limit", Arg::frequency(limit));
        (limit.map_or_else(|| named("stability-stable"), below), Verdict::Passed)
    };
    // a whirl beside the state at rest
    if let (Some((value, name)), Verdict::Passed) = (studied::whirl_beside(facts.outcomes, facts.sign, speed), verdict) {
        let source = Message::new("from-study").arg("study", Arg::name(name));
        return Check { detail: Some(source), ..of(Message::new("stability-beside").arg("value", value), Verdict::Attention) };
    }
    // the response that unbalance drives may be unstable where the machine at rest is stable
    if let (Some(s), Verdict::Passed | Verdict::Attention) = (&facts.steady, verdict) {
        match s.stable {
            Some(0) => return of(Message::new("stability-no-steady"), Verdict::Failed),
            Some(n) if n > 1 => {
                return Check { detail, ..of(Message::new("stability-several").arg("count", Arg::count(n)), Verdict::Attention) };
            }
            _ => {}
        }
    }
    Check { detail, ..of(message, verdict) }
}

/// Where vibration along or about the axis alone has no damping: how many modes across it there are, and the rate at which the slowest decays, 1/s.
fn decay_across(spectrum: &Spectrum) -> Option<(usize, f64)> {
    let rounding = growth_rounding(spectrum);
    let (along, across): (Vec<_>, Vec<_>) = spectrum.held().partition(|m| !m.whirl.is_lateral() && m.whirl != Whirl::None);
    let largest = |modes: &[&MachineMode]| modes.iter().map(|m| m.growth()).fold(f64::NEG_INFINITY, larger);
    let (still, slowest) = (largest(&along), largest(&across));
    (still.abs() <= rounding && slowest < -rounding && slowest.is_finite()).then_some((across.len(), -slowest))
}

/// Stability at the operating speeds without modes there: by the growth along the speed, or by the steady responses that a study of the file found.
fn along(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Option<(Message, Option<Message>, Verdict)> {
    let by_steady = || {
        let detail = Some(Message::new("vibration-nonlinear"));
        match facts.steady.as_ref()?.stable? {
            0 => Some((Message::new("stability-no-steady"), None, Verdict::Failed)),
            1 => Some((Message::new("stability-steady"), None, Verdict::Passed)),
            n => Some((Message::new("stability-several").arg("count", Arg::count(n)), detail, Verdict::Attention)),
        }
    };
    let Some((over, row)) = over.zip(facts.stability.get()) else { return by_steady() };
    let (w, g) = (&over.growth_speed, &over.growth);
    let covered = ends(w).is_some_and(|(low, high)| low <= speed.low * (1.0 + 1e-9) && speed.high * (1.0 - 1e-9) <= high);
    if !covered {
        return by_steady();
    }
    let at = |x: f64| {
        let k = w.iter().position(|s| *s >= x * (1.0 - 1e-9)).unwrap_or(w.len() - 1);
        if k == 0 || w[k] <= x { g[k] } else { g[k - 1] + (g[k] - g[k - 1]) * (x - w[k - 1]) / (w[k] - w[k - 1]) }
    };
    let inside = w.iter().zip(g).filter(|(w, _)| speed.contains(**w)).map(|p| *p.1);
    let growth = [at(speed.low), at(speed.high)].into_iter().chain(inside).fold(f64::NEG_INFINITY, larger);
    let source = facts.stability.source();
    if let Some(first) = margins::instability(over, speed).inside.first() {
        let u = over.unstable.iter().find(|u| u.to >= *first && u.from <= speed.high)?;
        let result = match speed.is_one() {
            true => Message::new("stability-unstable")
                .arg("time", Arg::quantity(1.0 / u.growth.abs(), "s"))
                .arg("motion", motion(u.growth, u.frequency)),
            false => Message::new("stability-unstable-range").arg("range", span(u.from.max(speed.low), u.to.min(speed.high))),
        };
        return Some((result, source, Verdict::Failed));
    }
    // where roots are counted, a count that does not agree leaves some open
    let open = row.samples.iter().any(|s| s.counted && s.growing.is_none());
    let (result, verdict) = if growth.is_nan() || open {
        (Message::new("stability-unknown"), Verdict::Attention)
    } else if facts.threshold > 0.0 && growth > -facts.threshold {
        (Message::new("stability-slow").arg("limit", Arg::quantity(facts.threshold, "1/s")), Verdict::Attention)
    } else if growth >= 0.0 {
        (Message::new("stability-neutral"), Verdict::Attention)
    } else {
        let kept = !(facts.limits.growth > 0.0) || -growth >= facts.limits.growth;
        let result = Message::new("stability-decays").arg("decay", Arg::quantity(-growth, "1/s"));
        (result, if kept { Verdict::Passed } else { Verdict::Failed })
    };
    match by_steady() {
        Some(steady) if steady.2 != Verdict::Passed && verdict != Verdict::Failed => Some(steady),
        _ => Some((result, source, verdict)),
    }
}

/// The least logarithmic decrement of the modes, where one is required.
pub(super) fn damping(facts: &Facts) -> Option<Check> {
    let required = facts.operation.decrement?;
    let of = |result, verdict| {
        let needed = Message::new("required-above").arg("limit", Arg::number(required));
        Some(Check { required: Some(needed.into()), ..Check::new("check-damping", result, verdict) })
    };
    let (_, known) = facts.modes.as_ref()?;
    let Some(result) = known.get() else { return of(known.why(), Verdict::NotComputed) };
    let fastest = facts.operating.map_or(0.0, |o| o.high);
    let oscillating =
        result.spectrum.modes.iter().filter(|m| !aperiodic(m.value) && !far(m, fastest)).map(|m| (decrement(m), m.frequency()));
    // of a range of speeds the least counts
    let all = oscillating.chain(facts.worst.as_ref().and_then(|w| w.decrement));
    let Some((least, frequency)) = all.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return of(Message::new("damping-no-oscillation"), Verdict::NotComputed);
    };
    let found = Message::new("damping-least").arg("decrement", Arg::number(least)).arg("frequency", Arg::frequency(frequency));
    of(found, if least >= required { Verdict::Passed } else { Verdict::Failed })
}
