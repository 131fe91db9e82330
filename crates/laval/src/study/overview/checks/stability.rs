//! Stability at the operating speeds.

use super::super::margins;
use super::super::operating::{Operating, span};
use super::super::{Facts, Known};
use super::speeds;
use crate::outcome::{Arg, Check, Message, OverSpeed, Verdict};
use crate::solve::pencil::MachineMode;
use crate::study::Study;
use crate::study::nonlinear::stationary::Stationary;
use std::f64::consts::TAU;

/// The check of stability found motions that grow.
pub(in super::super) fn grows(stability: &Check) -> bool {
    matches!(
        stability.result.key.as_str(),
        "stability-unstable" | "stability-unstable-range" | "stability-no-state" | "stability-no-steady"
    )
}

/// Whether the machine is stable at its speed, in the words of the study of modes.
pub(super) fn stability(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Check {
    let decay = if facts.limits.growth > 0.0 { Arg::quantity(facts.limits.growth, "1/s") } else { Arg::word("none") };
    let required = Some(Arg::from(Message::new("required-decay").arg("margin", decay)));
    let of = |result: Message, verdict| Check { required: required.clone(), ..Check::new("check-stability", result, verdict) };
    let Some((study, known)) = &facts.modes else { return of(Message::new("why-no-speed"), Verdict::NotComputed) };
    let Known::Yes(result) = known else { return of(known.why(), Verdict::NotComputed) };
    let Ok(outcome) = study.report(facts.system, result, "modes") else {
        return of(Message::new("why-too-long"), Verdict::NotComputed);
    };
    let has = |id: &str| outcome.findings.iter().any(|f| f.id == id);
    let modes = &result.spectrum.modes;
    let Some(least) = result.spectrum.least_stable() else { return of(Message::new("stability-no-mode"), Verdict::NotComputed) };
    let threshold = study.threshold.max(facts.threshold);
    let slow = least.growth() > 0.0 && least.growth() <= threshold;
    let detail = (least.frequency() > 0.0 && !slow).then(|| {
        Message::new("stability-mode")
            .arg("frequency", Arg::frequency(least.frequency()))
            .arg("decrement", Arg::number(-TAU * least.growth() / least.frequency()))
    });
    let named = |key: &str| {
        Message::new(key)
            .arg("modes", Arg::count(modes.len()))
            .arg("growth", Arg::quantity(least.growth(), "1/s"))
            .arg("decay", Arg::quantity(-least.growth(), "1/s"))
            .arg("time", Arg::quantity(1.0 / least.growth().abs(), "s"))
    };
    let (message, verdict) = if has("unstable_mode") {
        (named("stability-unstable"), Verdict::Failed)
    } else if slow && (has("stability_unknown") || has("slow_growth")) {
        // modes that grow below the threshold of the study: waves of an ideal liquid are not resolved further
        (Message::new("stability-slow").arg("limit", Arg::quantity(threshold, "1/s")), Verdict::Attention)
    } else if has("stability_unknown") || has("slow_growth") {
        (named("stability-unknown"), Verdict::Attention)
    } else if facts.limits.growth > 0.0 && !(-least.growth() >= facts.limits.growth) {
        (named("stability-stable"), Verdict::Failed)
    } else if outcome.findings.iter().any(|f| f.id == "stable" && f.value == Some(0.0)) {
        (named("stability-neutral"), Verdict::Attention)
    } else {
        (named("stability-stable"), Verdict::Passed)
    };
    // the modes are those of one speed
    if let (Some(over), Verdict::Passed | Verdict::Attention, false) = (over, verdict, speed.is_one())
        && let Some(first) = margins::instability(over, speed).inside.first()
    {
        let within =
            over.unstable.iter().find(|u| u.to >= *first).map_or(speed.arg(), |u| span(u.from.max(speed.low), u.to.min(speed.high)));
        return of(Message::new("stability-unstable-range").arg("range", within), Verdict::Failed);
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

/// Whether a state of the balls is stable at the speed, of a study of stationary states.
pub(super) fn balanced(facts: &Facts, speed: Operating) -> Check {
    let found: Vec<_> = facts.outcomes.iter().filter(|o| o.kind == Stationary::KIND).flat_map(|o| &o.findings).collect();
    if found.is_empty() {
        return Check::new("check-stability", Message::new("stability-needs-stationary"), Verdict::NotComputed);
    }
    let range = |id: &str| {
        let all = found.iter().filter(|f| f.id == id).filter_map(|f| Some((f.number("from")?, f.value?)));
        let all = all.map(|(a, b)| (facts.sign * a, facts.sign * b)).map(|(a, b)| (a.min(b), a.max(b)));
        all.filter(|(from, to)| *from <= speed.low && speed.high <= *to).max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))
    };
    let of = |key: &str, (from, to): (f64, f64)| Message::new(key).arg("from", Arg::speed(from)).arg("to", Arg::speed(to));
    let covered: Vec<f64> = facts.outcomes.iter().filter(|o| o.kind == Stationary::KIND).flat_map(speeds).map(|w| facts.sign * w).collect();
    if !covered.iter().any(|w| *w >= speed.high * (1.0 - 1e-9)) || !covered.iter().any(|w| *w <= speed.low * (1.0 + 1e-9)) {
        return Check::new("check-stability", Message::new("stability-outside-study"), Verdict::NotComputed);
    }
    let (result, verdict) = match (range("balanced_stable"), range("stable_states")) {
        (Some(r), _) => (of("stability-balanced", r), Verdict::Passed),
        (None, Some(r)) => (of("stability-state", r), Verdict::Attention),
        (None, None) => (Message::new("stability-no-state"), Verdict::Failed),
    };
    Check {
        required: Some(Message::new("required-decay").arg("margin", Arg::word("none")).into()),
        ..Check::new("check-stability", result, verdict)
    }
}

/// What balls leave of the unbalance, of a study of stationary states.
pub(super) fn balls(facts: &Facts) -> Option<Check> {
    let found = facts.outcomes.iter().filter(|o| o.kind == Stationary::KIND).flat_map(|o| &o.findings);
    let left = found.clone().find(|f| f.id == "residual_unbalance");
    let Some((left, value)) = left.and_then(|f| Some((f, f.value?))) else {
        return Some(Check::new("check-balls", Message::new("balls-no-study"), Verdict::NotComputed));
    };
    let number = |what: &str| left.evidence.iter().find(|e| e.what == what).map(|e| e.value);
    let without = number("without the masses").unwrap_or(f64::NAN);
    let result = Message::new("balls-left").arg("left", Arg::quantity(value, "kg m")).arg("without", Arg::quantity(without, "kg m"));
    let verdict = if value < without { Verdict::Passed } else { Verdict::Attention };
    Some(Check { required: Some(Message::new("required-less-unbalance").into()), ..Check::new("check-balls", result, verdict) })
}

/// The least logarithmic decrement of the modes, where one is required.
pub(super) fn damping(facts: &Facts) -> Option<Check> {
    let required = facts.operation.decrement?;
    let of = |result, verdict| {
        let needed = Message::new("required-above").arg("limit", Arg::number(required));
        Some(Check { required: Some(needed.into()), ..Check::new("check-damping", result, verdict) })
    };
    let (_, known) = facts.modes.as_ref()?;
    let Known::Yes(result) = known else { return of(known.why(), Verdict::NotComputed) };
    let decrement = |m: &MachineMode| -TAU * m.growth() / m.frequency();
    let least = result.spectrum.modes.iter().filter(|m| m.frequency() > 0.0).min_by(|a, b| decrement(a).total_cmp(&decrement(b)));
    let Some(m) = least else { return of(Message::new("stability-no-mode"), Verdict::NotComputed) };
    let found = Message::new("damping-least").arg("decrement", Arg::number(decrement(m))).arg("frequency", Arg::frequency(m.frequency()));
    of(found, if decrement(m) >= required { Verdict::Passed } else { Verdict::Failed })
}
