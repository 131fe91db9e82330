//! Requirements at the operating speed, and how they are met.

use super::margins::{self, Nearest};
use super::{Facts, Known, MARGIN};
use crate::model::part::Link;
use crate::model::probe::Probe;
use crate::outcome::{Arg, Check, Data, End, Level, Message, Outcome, OverSpeed, Verdict};
use crate::solve::linear_response::Response;
use crate::study::Study;
use crate::study::centrifuge::operating_window::OperatingWindow;
use crate::study::motion::run_up::RunUp;
use crate::study::nonlinear::stationary::Stationary;
use crate::study::shared::limits::Limit;
use crate::study::shared::support::larger;
use std::f64::consts::TAU;

/// Bodies and parts named in one result.
const MOST_NAMED: usize = 3;

/// All checks that apply to this machine.
pub(super) fn checks(facts: &Facts, over: Option<&OverSpeed>) -> Vec<Check> {
    let Some(speed) = facts.operating.map(f64::abs) else { return Vec::new() };
    if facts.balls {
        let mut out = vec![balanced(facts, speed), validity(facts)];
        out.extend(balls(facts));
        out.extend(run_up(facts, over, speed));
        out.extend(window(facts, speed));
        out.extend(highest(facts, speed));
        out.extend(left_out(facts, true));
        return out;
    }
    let mut out = vec![stability(facts)];
    let unstable = grows(&out[0]);
    out.extend(instability(facts, over, speed, unstable));
    out.extend(resonance(facts, over, speed));
    if unstable {
        // the response exists, and no machine stays on it
        out.push(Check::new("check-vibration", Message::new("vibration-unstable"), Verdict::NotComputed));
    } else {
        out.extend(vibration(facts));
        out.extend(forces(facts));
    }
    out.push(validity(facts));
    out.extend(run_up(facts, over, speed));
    out.extend(window(facts, speed));
    out.extend(highest(facts, speed));
    out.extend(left_out(facts, false));
    // a reason that holds for several stands once
    let mut reasons: Vec<Message> = Vec::new();
    for c in out.iter_mut().filter(|c| c.result.key == "why-refused") {
        if reasons.contains(&c.result) {
            c.result = Message::new("why-same");
        } else {
            reasons.push(c.result.clone());
        }
    }
    out
}

/// The check of stability found motions that grow.
pub(super) fn grows(stability: &Check) -> bool {
    matches!(stability.result.key.as_str(), "stability-unstable" | "stability-no-state" | "stability-no-steady")
}

/// The operating speed against the windows that a study of the file found.
fn window(facts: &Facts, speed: f64) -> Option<Check> {
    let study = facts.outcomes.iter().find(|o| o.kind == OperatingWindow::KIND && o.end.is_complete())?;
    let windows: Vec<(f64, f64)> =
        study.findings.iter().filter(|f| f.id == "window").filter_map(|f| Some((f.number("from")?, f.value?))).collect();
    let range = |(from, to): &(f64, f64)| Arg::from(Message::new("speed-span").arg("from", Arg::speed(*from)).arg("to", Arg::speed(*to)));
    let (result, verdict) = match windows.iter().any(|(from, to)| (from..=to).contains(&&speed)) {
        _ if windows.is_empty() => (Message::new("window-none"), Verdict::Failed),
        inside => {
            let result = Message::new("window-ranges").arg("ranges", Arg::List(windows.iter().map(range).collect()));
            (result, if inside { Verdict::Passed } else { Verdict::Failed })
        }
    };
    Some(Check { required: Some(Message::new("required-validity").into()), ..Check::new("check-window", result, verdict) })
}

/// The highest speed allowed.
fn highest(facts: &Facts, speed: f64) -> Option<Check> {
    let limit = facts.limits.speed?;
    let (required, verdict) = against(Some(((limit, speed), "rad/s")));
    Some(Check { required, ..Check::new("check-speed", Message::new("speed-is").arg("speed", Arg::speed(speed)), verdict) })
}

/// Limits that this page does not assess.
fn left_out(facts: &Facts, balls: bool) -> Option<Check> {
    let l = &facts.limits;
    let mut names = Vec::new();
    let mut add = |given: bool, name: &'static str| names.extend(given.then_some(name));
    add(!l.tilt.is_empty(), "tilt");
    add(!l.moment.is_empty(), "moment");
    add(l.torque.is_some(), "drive_torque");
    add(l.self_centring.is_some(), "self_centring");
    add(balls && !l.displacement.is_empty(), "displacement");
    add(balls && !l.velocity.is_empty(), "velocity");
    add(balls && !l.force.is_empty(), "force");
    add(balls && l.clearance.is_some(), "clearance");
    add(balls && l.growth > 0.0, "growth_margin");
    let result = Message::new("limits-left-out").arg("names", Arg::names(names.iter().copied()));
    (!names.is_empty()).then(|| Check::new("check-others", result, Verdict::NotComputed))
}

/// Whether the machine is stable at its speed, in the words of the study of modes.
fn stability(facts: &Facts) -> Check {
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
    let detail = (least.frequency() > 0.0).then(|| {
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
    } else if has("stability_unknown") || has("slow_growth") {
        (named("stability-unknown"), Verdict::Attention)
    } else if facts.limits.growth > 0.0 && !(-least.growth() >= facts.limits.growth) {
        (named("stability-stable"), Verdict::Failed)
    } else if outcome.findings.iter().any(|f| f.id == "stable" && f.value == Some(0.0)) {
        (named("stability-neutral"), Verdict::Attention)
    } else {
        (named("stability-stable"), Verdict::Passed)
    };
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
fn balanced(facts: &Facts, speed: f64) -> Check {
    let found: Vec<_> = facts.outcomes.iter().filter(|o| o.kind == Stationary::KIND).flat_map(|o| &o.findings).collect();
    if found.is_empty() {
        return Check::new("check-stability", Message::new("stability-needs-stationary"), Verdict::NotComputed);
    }
    let range = |id: &str| {
        let all = found.iter().filter(|f| f.id == id).filter_map(|f| Some((f.number("from")?, f.value?)));
        let all = all.map(|(a, b)| (facts.sign * a, facts.sign * b)).map(|(a, b)| (a.min(b), a.max(b)));
        all.filter(|(from, to)| (from..=to).contains(&&speed)).max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))
    };
    let of = |key: &str, (from, to): (f64, f64)| Message::new(key).arg("from", Arg::speed(from)).arg("to", Arg::speed(to));
    let covered: Vec<f64> = facts.outcomes.iter().filter(|o| o.kind == Stationary::KIND).flat_map(speeds).map(|w| facts.sign * w).collect();
    if !covered.iter().any(|w| *w >= speed * (1.0 - 1e-9)) || !covered.iter().any(|w| *w <= speed * (1.0 + 1e-9)) {
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

/// Speeds that a study covers: those of all its tables.
fn speeds(o: &Outcome) -> Vec<f64> {
    let columns = o.tables.iter().filter_map(|t| t.column("speed"));
    let floats = columns.filter_map(|c| match &c.data {
        Data::Float(v) => Some(v),
        _ => None,
    });
    floats.flatten().copied().filter(|w| w.is_finite()).collect()
}

/// A distance in speed with its requirement.
fn distance(what: &str, none: &str, nearest: &Nearest, speed: f64, required: f64, within: (f64, f64)) -> Check {
    let places = |key: &str| {
        let mut m = Message::new(key).arg("from", Arg::speed(within.0)).arg("to", Arg::speed(within.1));
        for (name, place) in [("below", nearest.below), ("above", nearest.above)] {
            m = m.arg(name, place.map_or(Arg::word("none"), Arg::speed));
        }
        m
    };
    let margin = nearest.margin(speed);
    let result = match (nearest.below, nearest.above) {
        (None, None) => places(none),
        (Some(_), None) => places("distance-below"),
        (None, Some(_)) => places("distance-above"),
        (Some(_), Some(_)) => places("distance-both"),
    };
    let verdict = match margin {
        Some(m) if !(m >= required) => Verdict::Attention,
        _ => Verdict::Passed,
    };
    Check { required: Some(Arg::percent(required)), margin, ..Check::new(what, result, verdict) }
}

fn instability(facts: &Facts, over: Option<&OverSpeed>, speed: f64, unstable: bool) -> Option<Check> {
    let Some(over) = over.filter(|o| !o.growth.is_empty()) else {
        return Some(Check::new("check-instability", facts.stability.why(), Verdict::NotComputed));
    };
    let nearest = margins::instability(over, speed);
    let mut check = distance("check-instability", "distance-stable-throughout", &nearest, speed, MARGIN, over.range);
    // a band may be narrower than the steps over the range
    if unstable || nearest.margin(speed) == Some(0.0) {
        check.verdict = Verdict::Failed;
        check.margin = None;
        check.result = Message::new("distance-inside-unstable");
    }
    Some(check)
}

fn resonance(facts: &Facts, over: Option<&OverSpeed>, speed: f64) -> Option<Check> {
    let required = facts.limits.clearance.unwrap_or(MARGIN);
    let Some(over) = over.filter(|o| !o.response_speed.is_empty() || facts.criticals.get().is_some()) else {
        return Some(Check::new("check-resonance", facts.criticals.why(), Verdict::NotComputed));
    };
    let nearest = margins::resonance(over, speed);
    let mut check = distance("check-resonance", "distance-no-resonance", &nearest, speed, required, over.range);
    if check.verdict == Verdict::Attention && facts.limits.clearance.is_some() {
        check.verdict = Verdict::Failed;
    }
    Some(check)
}

/// The response at the operating speed.
fn response<'a>(facts: &'a Facts) -> Result<&'a Response, Message> {
    let Some(known) = &facts.response else { return Err(Message::new("why-no-speed")) };
    let Some(result) = known.get() else { return Err(known.why()) };
    result.curve.points.first().filter(|r| r.x.iter().all(|x| x.is_finite())).ok_or_else(|| Message::new("vibration-unbounded"))
}

/// Displacements of bodies against their limits.
fn vibration(facts: &Facts) -> Vec<Check> {
    let r = match response(facts) {
        Ok(r) => r,
        Err(why) => {
            let verdict = if why.key == "vibration-unbounded" { Verdict::Failed } else { Verdict::NotComputed };
            return vec![Check::new("check-vibration", why, verdict)];
        }
    };
    // what a nonlinear study found counts before the linear response
    let nonlinear = facts.steady.as_ref().filter(|s| !s.sizes.is_empty());
    let size = |p: &Probe| {
        let known = nonlinear.and_then(|s| s.sizes.iter().find(|x| p.is_reference() && x.0 == p.name));
        known.map_or_else(|| r.size(p), |x| x.1)
    };
    let sizes: Vec<(&Probe, f64)> = facts.system.probes().iter().filter(|p| p.is_reference()).map(|p| (p, size(p))).collect();
    let mut largest = sizes.clone();
    largest.sort_by(|a, b| b.1.total_cmp(&a.1));
    largest.truncate(MOST_NAMED);
    let item =
        |(p, x): &(&Probe, f64)| Arg::from(Message::new("item").arg("name", Arg::name(&p.name)).arg("value", Arg::quantity(*x, "m")));
    let result = Message::new("vibration-sizes").arg("sizes", Arg::List(largest.iter().map(item).collect()));
    let speed = r.speed.abs();
    let detail = largest
        .first()
        .map(|(p, x)| Message::new("vibration-velocity").arg("name", Arg::name(&p.name)).arg("peak", Arg::quantity(x * speed, "m/s")));
    let kept = |limits: &[Limit], factor: f64| {
        let of = |l: &&Limit| {
            facts.system.probes().iter().find(|p| if l.at.is_some() { l.is_at(p) } else { p.is_reference() && p.name == l.body })
        };
        limits
            .iter()
            .filter_map(|l| Some((l, factor * size(of(&l)?))))
            .max_by(|a, b| (a.1 / a.0.value).total_cmp(&(b.1 / b.0.value)))
            .map(|(l, x)| (l.value, x))
    };
    let worst = [(kept(&facts.limits.displacement, 1.0), "m"), (kept(&facts.limits.velocity, speed), "m/s")];
    let worst = worst.into_iter().filter_map(|(w, unit)| Some((w?, unit))).max_by(|a, b| (a.0.1 / a.0.0).total_cmp(&(b.0.1 / b.0.0)));
    let (required, verdict) = against(worst);
    let closes: Vec<&str> =
        facts.response.as_ref().and_then(Known::get).map_or(Vec::new(), |r| r.observed.closed.iter().map(|c| c.part.as_str()).collect());
    let (detail, verdict) = if nonlinear.is_some() {
        (Some(Message::new("vibration-nonlinear")), verdict)
    } else if !closes.is_empty() {
        // the linear response passes through a part that would hold it
        (Some(Message::new("vibration-contact").arg("parts", Arg::names(closes))), Verdict::Attention)
    } else {
        (detail, verdict)
    };
    vec![Check { detail, required, ..Check::new("check-vibration", result, verdict) }]
}

/// A limit with its unit, and whether a value keeps it.
fn against(worst: Option<((f64, f64), &'static str)>) -> (Option<Arg>, Verdict) {
    match worst {
        Some(((limit, x), unit)) => {
            let verdict = if x <= limit { Verdict::Passed } else { Verdict::Failed };
            (Some(Message::new("required-below").arg("limit", Arg::quantity(limit, unit)).into()), verdict)
        }
        None => (None, Verdict::NoLimit),
    }
}

/// Forces of the parts against their limits.
fn forces(facts: &Facts) -> Option<Check> {
    let result = facts.response.as_ref()?.get()?;
    let mut all: Vec<(&str, f64)> = Vec::new();
    for q in result.observed.quantities.iter().filter(|q| q.unit == "N") {
        let Some(x) = q.values.first().copied() else { continue };
        match all.iter_mut().find(|a| a.0 == q.part) {
            Some(a) => a.1 = larger(a.1, x),
            None => all.push((&q.part, x)),
        }
    }
    // a linear response has no force of a nonlinear part
    if let Some(s) = &facts.steady {
        for (part, x) in &s.forces {
            match all.iter_mut().find(|a| a.0 == part) {
                Some(a) => a.1 = *x,
                None => all.push((part, *x)),
            }
        }
    }
    let largest = all.iter().map(|a| a.1).fold(0.0, f64::max);
    // what is no number stays, and keeps no limit
    all.retain(|a| !(a.1 <= 1e-9 * largest));
    let nonlinear =
        facts.system.slots().iter().filter(|s| !s.is_linear() && s.layout.ports.iter().any(|p| matches!(p.link, Link::Between(..))));
    let missing: Vec<&str> = nonlinear.map(|s| s.name.as_str()).filter(|n| !all.iter().any(|a| a.0 == *n)).collect();
    if all.is_empty() && missing.is_empty() {
        return None;
    }
    let limit = |part: &str| facts.limits.force.iter().find(|l| l.body == part).map(|l| l.value);
    let worst = all.iter().filter_map(|(p, x)| Some((limit(p)?, *x))).max_by(|a, b| (a.1 / a.0).total_cmp(&(b.1 / b.0)));
    let (required, verdict) = against(worst.map(|w| (w, "N")));
    all.sort_by(|a, b| b.1.total_cmp(&a.1));
    all.truncate(MOST_NAMED);
    let item = |(name, x): &(&str, f64)| Arg::from(Message::new("item").arg("name", Arg::name(*name)).arg("value", Arg::quantity(*x, "N")));
    let result = Message::new("forces-sizes").arg("sizes", Arg::List(all.iter().map(item).collect()));
    let limited = missing.iter().any(|n| facts.limits.force.iter().any(|l| l.body == *n));
    let verdict = if limited && verdict != Verdict::Failed { Verdict::Attention } else { verdict };
    let detail = (!missing.is_empty()).then(|| Message::new("forces-without").arg("parts", Arg::names(missing)));
    Some(Check { detail, required, ..Check::new("check-forces", result, verdict) })
}

/// Validity of the parts at the operating speed, and what the studies of the file found outside.
fn validity(facts: &Facts) -> Check {
    let outside: Vec<&str> = facts
        .outcomes
        .iter()
        .flat_map(|o| &o.findings)
        .filter(|f| f.level == Level::Invalid)
        .map(|f| if f.subject.is_empty() { f.id.as_str() } else { f.subject.as_str() })
        .collect();
    let here = facts.response.as_ref().and_then(Known::get).and_then(|r| r.observed.validity.first().copied());
    let required = Some(Arg::from(Message::new("required-validity")));
    let (result, verdict) = match here {
        Some(x) if !(x <= 1.0) => (Message::new("validity-outside-here").arg("ratio", Arg::number(x)), Verdict::Failed),
        Some(0.0) if outside.is_empty() => (Message::new("validity-none"), Verdict::NoLimit),
        Some(x) if x.is_nan() => (Message::new("validity-nothing"), Verdict::NotComputed),
        Some(x) if outside.is_empty() => (Message::new("validity-inside").arg("share", Arg::percent(x)), Verdict::Passed),
        Some(x) => (Message::new("validity-elsewhere").arg("share", Arg::percent(x)), Verdict::Passed),
        None if outside.is_empty() => (Message::new("validity-nothing"), Verdict::NotComputed),
        None => (Message::new("validity-studies").arg("count", Arg::count(outside.len())), Verdict::Attention),
    };
    Check { required, ..Check::new("check-validity", result, verdict) }
}

/// What balls leave of the unbalance, of a study of stationary states.
fn balls(facts: &Facts) -> Option<Check> {
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

/// The largest displacement of the run-ups of the file that begin below what is crossed and reach the operating speed, with its body; infinite where one of
/// them diverges.
fn simulated(facts: &Facts, over: Option<&OverSpeed>, speed: f64) -> Option<(String, f64)> {
    let events = over.into_iter().flat_map(|o| o.resonances.iter().map(|r| r.speed).chain(o.unstable.iter().map(|u| u.from)));
    let lowest = events.fold(0.2 * speed, f64::min);
    let one = |o: &Outcome| {
        if matches!(o.end, End::Unbounded { .. }) {
            return Some((String::new(), f64::INFINITY));
        }
        let covered: Vec<f64> = speeds(o).into_iter().map(|w| facts.sign * w).collect();
        let whole = o.end.is_complete() && covered.iter().any(|w| *w >= 0.999 * speed) && covered.first().is_some_and(|w| *w <= lowest);
        let largest = o.findings.iter().filter(|f| f.id == "largest_displacement").filter_map(|f| Some((f.subject.clone(), f.value?)));
        largest.filter(|_| whole).max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let all = facts.outcomes.iter().filter(|o| o.kind == RunUp::KIND).filter_map(one);
    all.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// What a run-up to the operating speed crosses.
fn run_up(facts: &Facts, over: Option<&OverSpeed>, speed: f64) -> Option<Check> {
    let largest = simulated(facts, over, speed);
    let known = over.is_some_and(|o| !o.growth.is_empty() && (!o.response_speed.is_empty() || facts.criticals.get().is_some()));
    if !known && largest.is_none() {
        let result = Message::new("run-up-unknown").arg("speed", Arg::speed(speed));
        return Some(Check::new("check-run-up", result, Verdict::NotComputed));
    }
    let below = |o: &OverSpeed| {
        let resonances: Vec<Arg> = o.resonances.iter().filter(|r| r.speed < speed).map(|r| Arg::speed(r.speed)).collect();
        let span = |from: f64, to: f64| Arg::from(Message::new("speed-span").arg("from", Arg::speed(from)).arg("to", Arg::speed(to)));
        let unstable = o.unstable.iter().filter(|u| u.from < speed);
        (resonances, unstable.map(|u| span(u.from, u.to.min(speed))).collect::<Vec<Arg>>())
    };
    let (resonances, ranges) = over.map(below).unwrap_or_default();
    let limit = facts.limits.passage.iter().map(|l| l.value).reduce(f64::min);
    let (result, required, verdict) = match (largest, resonances.is_empty() && ranges.is_empty()) {
        (Some((_, x)), _) if !x.is_finite() => (Message::new("run-up-diverges"), None, Verdict::Failed),
        (Some((body, x)), _) => {
            let result = Message::new("run-up-computed").arg("body", Arg::name(body)).arg("value", Arg::quantity(x, "m"));
            let (required, verdict) = against(limit.map(|l| ((l, x), "m")));
            (result, required, verdict)
        }
        (None, true) => {
            let verdict = if facts.limits.passage.is_empty() { Verdict::Passed } else { Verdict::NotComputed };
            (Message::new("run-up-free"), None, verdict)
        }
        (None, false) => {
            let key = match (resonances.is_empty(), ranges.is_empty()) {
                (false, true) => "run-up-resonances",
                (true, _) => "run-up-unstable",
                (false, false) => "run-up-both",
            };
            let m = Message::new(key).arg("count", Arg::count(resonances.len())).arg("resonances", Arg::List(resonances));
            (m.arg("ranges", Arg::List(ranges)), None, Verdict::NotComputed)
        }
    };
    Some(Check { required, ..Check::new("check-run-up", result, verdict) })
}
