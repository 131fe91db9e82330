//! The answer in one sentence, three remarks, and what to do next.

use super::checks;
use super::margins;
use super::operating::Operating;
use super::over_frequency;
use super::{Facts, Known, MARGIN};
use crate::outcome::{Arg, Check, Message, OverSpeed, Overview, Resonance, Unstable, Verdict};
use laval_num::order::SortByNumber;

/// Remarks of one heading.
const MOST: usize = 3;

pub(super) fn headline(facts: &Facts, page: &mut Overview) {
    let buckled = facts.buckling.as_ref().map(|b| Message::new("headline-buckled").arg("time", Arg::quantity(1.0 / b.growth, "s")));
    let Some(speed) = facts.operating else {
        page.verdict = if buckled.is_some() { Verdict::Failed } else { Verdict::NotComputed };
        page.headline = buckled.into_iter().chain([Message::new("headline-no-speed")]).collect();
        page.next = hold(facts).into_iter().chain([Message::new("next-speed")]).chain(studies(facts)).collect();
        return;
    };
    let at = |key: &str| Message::new(key).arg("speed", speed.arg());
    let check = |name: &str| page.checks.iter().find(|c| c.what.key == name);
    let over = page.over_speed.as_ref();
    let crossed: Vec<&Unstable> = over.iter().flat_map(|o| &o.unstable).filter(|u| u.to < speed.low).collect();
    let endless = crossed.iter().find(|u| u.open.1);
    let unstable = check("check-stability").is_some_and(checks::grows);
    let stability = match check("check-stability").map_or(Verdict::NotComputed, |c| c.verdict) {
        Verdict::Failed if !unstable => Verdict::Passed,
        v => v,
    };
    let failed: Vec<Arg> =
        page.checks.iter().filter(|c| c.verdict == Verdict::Failed && !checks::grows(c)).map(|c| c.what.clone().into()).collect();
    let near = |name: &str| check(name).filter(|c| c.verdict == Verdict::Attention).and_then(|c| c.margin);
    let (mut verdict, mut headline) = match stability {
        Verdict::Failed => (Verdict::Failed, vec![at("headline-unstable")]),
        Verdict::Passed => {
            // none of any frequency grows at one speed: there the limit of the modes computed says nothing more
            let whole = facts.growing == Some(None) && speed.is_one();
            let limited = check("check-stability").filter(|c| !whole && c.result.key == "stability-stable-below");
            let below = limited.and_then(|c| c.result.arg_named("limit"));
            (Verdict::Passed, vec![below.map_or_else(|| at("headline-stable"), |l| at("headline-stable-below").arg("limit", l.clone()))])
        }
        Verdict::Attention if check("check-stability").is_some_and(|c| c.result.key == "stability-several") => {
            (Verdict::Attention, vec![at("headline-stable")])
        }
        Verdict::Attention => (Verdict::Attention, vec![at("headline-not-proven")]),
        _ => (Verdict::NotComputed, vec![over_frequency::unknown(facts, speed)]),
    };
    if stability != Verdict::Failed {
        let several = check("check-stability").is_some_and(|c| c.result.key == "stability-several");
        // the nearer of two troubles
        let closer = near("check-instability").is_none_or(|m| near("check-resonance").is_some_and(|r| r <= m));
        if !failed.is_empty() {
            verdict = Verdict::Failed;
            headline.push(Message::new("headline-limit").arg("checks", Arg::List(failed)));
        }
        let set = verdict == Verdict::Failed;
        let inside = over.map(|o| margins::resonance(o, speed).inside).unwrap_or_default();
        let more = if let (Some(first), false) = (inside.first(), speed.is_one()) {
            verdict = verdict.max(Verdict::Attention);
            Some(Message::new("headline-resonance-inside").arg("resonance", Arg::speed(*first)))
        } else if several && !set {
            Some(Message::new("headline-several"))
        } else if let (Some(m), Some(o), true) = (near("check-resonance"), over, closer) {
            verdict = verdict.max(Verdict::Attention);
            margins::resonance(o, speed)
                .place(speed)
                .map(|p| Message::new("headline-resonance").arg("margin", Arg::percent(m).digits(2)).arg("resonance", Arg::speed(p)))
        } else if set {
            None
        } else if let Some(m) = near("check-instability") {
            verdict = verdict.max(Verdict::Attention);
            Some(Message::new("headline-near-instability").arg("margin", Arg::percent(m).digits(2)))
        } else if let Some((from, to)) = checks::ranges(facts, "no_stable_state").into_iter().find(|r| r.0 < speed.low && facts.balls) {
            verdict = verdict.max(Verdict::Attention);
            Some(Message::new("headline-slip").arg("from", Arg::speed(from)).arg("to", Arg::speed(to)))
        } else if let Some(u) = endless {
            verdict = verdict.max(Verdict::Attention);
            Some(Message::new("headline-crosses-open").arg("from", Arg::speed(u.from)).arg("to", Arg::speed(u.to)))
        } else if let (Some(first), Some(last)) = (crossed.first(), crossed.last()) {
            verdict = verdict.max(Verdict::Attention);
            let m = Message::new("headline-crosses").arg("count", Arg::count(crossed.len()));
            Some(m.arg("from", Arg::speed(first.from)).arg("to", Arg::speed(last.to)))
        } else {
            None
        };
        headline.extend(more);
        // beside a resonance or an instability that is near
        if let (Some(m), Some(o)) = (near("check-jump"), over) {
            verdict = verdict.max(Verdict::Attention);
            headline.extend(near_jump(o, speed, m));
        }
        if check("check-validity").is_some_and(|c| c.verdict == Verdict::Attention) {
            verdict = verdict.max(Verdict::Attention);
            headline.push(Message::new("headline-validity"));
        }
    }
    // what the file requires and nothing computed is not met
    let open: Vec<Arg> = page.checks.iter().filter(|c| is_open(facts, c)).map(|c| c.what.clone().into()).collect();
    if !open.is_empty() && stability == Verdict::Passed {
        verdict = verdict.max(Verdict::Attention);
        headline.push(Message::new("headline-not-checked").arg("checks", Arg::List(open)));
    }
    // no answer is better than its checks
    let watched: Vec<Arg> = page.checks.iter().filter(|c| c.verdict == Verdict::Attention).map(|c| c.what.clone().into()).collect();
    if verdict == Verdict::Passed && !watched.is_empty() {
        verdict = Verdict::Attention;
        headline.push(Message::new("headline-attention").arg("checks", Arg::List(watched)));
    }
    if let Some(buckled) = buckled {
        verdict = verdict.max(Verdict::Attention);
        headline.insert(if verdict == Verdict::Failed { 0 } else { headline.len() }, buckled);
    }
    let remarks = [here(page, speed), below(facts, over, speed), above(over, speed)];
    let next = next(facts, &page.checks, over, speed);
    (page.verdict, page.headline, page.next) = (verdict, headline, next);
    page.remarks = remarks.into_iter().flatten().collect();
}

/// A requirement of the file that was not assessed.
fn is_open(facts: &Facts, check: &Check) -> bool {
    let (operation, limits) = (&facts.operation, &facts.limits);
    let required = match check.what.key.as_str() {
        "check-resonance" => facts.resonance_margin().is_some(),
        "check-instability" => operation.instability_margin.is_some(),
        "check-damping" => operation.decrement.is_some(),
        "check-vibration" => !limits.displacement.is_empty() || !limits.velocity.is_empty(),
        "check-velocity" => !limits.velocity.is_empty(),
        "check-forces" => !limits.force.is_empty(),
        "check-shaft-vibration" => operation.shaft_vibration.is_some(),
        "check-housing-vibration" => operation.housing_vibration.is_some(),
        "check-balance" => operation.balance_grade.is_some(),
        "check-run-up" => operation.run_up_time.is_some() || !limits.passage.is_empty(),
        // limits that the page does not assess
        "check-others" => true,
        _ => false,
    };
    required && check.verdict == Verdict::NotComputed
}

/// The nearest jump or bifurcation, and on which side it is.
fn near_jump(over: &OverSpeed, speed: Operating, margin: f64) -> Option<Message> {
    let place = margins::jump(over, speed).place(speed)?;
    let side = match () {
        _ if speed.contains(place) => "inside",
        _ if place > speed.high => "above",
        _ => "below",
    };
    let kind = if over.jumps.contains(&place) { "jump" } else { "bifurcation" };
    let m = Message::new("headline-jump").arg("kind", Arg::word(kind)).arg("side", Arg::word(side));
    Some(m.arg("speed", Arg::speed(place)).arg("margin", Arg::percent(margin).digits(2)))
}

/// What makes a machine hold its position at rest.
fn hold(facts: &Facts) -> Option<Message> {
    let parts = &facts.buckling.as_ref()?.parts;
    let m = Message::new("next-buckled").arg("count", Arg::count(parts.len()));
    Some(m.arg("parts", Arg::names(parts.iter().map(String::as_str))))
}

/// At the operating speed.
fn here(page: &Overview, speed: Operating) -> Option<(Message, Vec<Message>)> {
    let names = [("check-stability", "remark-stability"), ("check-vibration", "remark-vibration"), ("check-forces", "remark-forces")];
    let of = |name: &str| page.checks.iter().find(|c| c.what.key == name && c.verdict != Verdict::NotComputed);
    let texts: Vec<Message> =
        names.iter().filter_map(|(name, key)| Some(Message::new(*key).arg("text", of(name)?.result.clone()))).collect();
    (!texts.is_empty()).then(|| (Message::new("remark-here").arg("speed", speed.arg()), texts))
}

fn span(key: &str, u: &Unstable) -> Message {
    Message::new(key)
        .arg("from", Arg::speed(u.from))
        .arg("to", Arg::speed(u.to))
        .arg("frequency", Arg::frequency(u.frequency))
        .arg("time", Arg::quantity(1.0 / u.growth, "s"))
        .arg("open", checks::open(u))
        .arg("oscillates", Arg::word(if u.frequency > 0.0 { "yes" } else { "no" }))
}

/// On the way up.
fn below(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Option<(Message, Vec<Message>)> {
    if let Some((from, to, times)) = checks::harm(facts, speed.low).filter(|_| facts.balls) {
        let harm = Message::new("remark-harm").arg("from", Arg::speed(from)).arg("to", Arg::speed(to));
        return Some((Message::new("remark-below"), vec![harm.arg("times", Arg::number(times))]));
    }
    let over = over?;
    let mut out: Vec<Message> = over.unstable.iter().filter(|u| u.to < speed.low).map(|u| span("remark-unstable", u)).collect();
    out.truncate(MOST);
    let crossed: Vec<&Resonance> = over.resonances.iter().filter(|r| r.speed < speed.low).collect();
    out.extend(resonances(&crossed).into_iter().map(|r| r.1));
    let jumps: Vec<f64> = over.jumps.iter().copied().filter(|w| *w <= speed.high).collect();
    if !jumps.is_empty() {
        out.push(jump(&jumps));
    }
    (!out.is_empty()).then(|| (Message::new("remark-below"), out))
}

fn jump(speeds: &[f64]) -> Message {
    let list = Arg::List(speeds.iter().map(|w| Arg::speed(*w)).collect());
    Message::new("remark-jump").arg("count", Arg::count(speeds.len())).arg("speeds", list)
}

/// The first ones with their amplitudes, the others by their speeds: none is left out.
fn resonances(all: &[&Resonance]) -> Vec<(f64, Message)> {
    let (first, rest) = all.split_at(all.len().min(if all.len() > MOST { MOST - 1 } else { MOST }));
    let mut out: Vec<(f64, Message)> = first.iter().map(|r| (r.speed, resonance(r))).collect();
    if let Some(next) = rest.first() {
        let speeds = Arg::List(rest.iter().map(|r| Arg::speed(r.speed)).collect());
        out.push((next.speed, Message::new("remark-resonances").arg("speeds", speeds)));
    }
    out
}

fn resonance(r: &Resonance) -> Message {
    let m = |key: &str| Message::new(key).arg("speed", Arg::speed(r.speed));
    match &r.amplitude {
        Some((body, x)) if x.is_finite() => m("remark-resonance").arg("body", body.clone()).arg("value", Arg::quantity(*x, "m")),
        Some((body, _)) => m("remark-resonance-unbounded").arg("body", body.clone()),
        None => m("remark-critical"),
    }
}

/// Above the operating speed.
fn above(over: Option<&OverSpeed>, speed: Operating) -> Option<(Message, Vec<Message>)> {
    let over = over?;
    let mut out: Vec<(f64, Message)> =
        over.unstable.iter().filter(|u| u.from > speed.high).map(|u| (u.from, span("remark-unstable", u))).collect();
    out.truncate(MOST);
    let further: Vec<&Resonance> = over.resonances.iter().filter(|r| r.speed > speed.high).collect();
    out.extend(resonances(&further));
    let jumps: Vec<f64> = over.jumps.iter().copied().filter(|w| *w > speed.high).collect();
    out.extend(jumps.first().map(|w| (*w, jump(&jumps))));
    out.sort_by_number(|a| a.0);
    (!out.is_empty()).then(|| (Message::new("remark-above"), out.into_iter().map(|o| o.1).collect()))
}

/// The speeds nearest below and above the unstable range of the operating speed that keep the required margin to it, and lie in no other.
fn outside(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> [Option<f64>; 2] {
    let all = over.map_or(&[][..], |o| &o.unstable);
    let Some(here) = all.iter().find(|u| u.holds(speed.low, speed.high)) else { return [None; 2] };
    let margin = facts.operation.instability_margin.unwrap_or(MARGIN);
    let known = over.and_then(|o| o.examined).unwrap_or((f64::INFINITY, 0.0));
    let near = |w: f64| all.iter().any(|u| u != here && w * (1.0 + margin) > u.from && w * (1.0 - margin) < u.to);
    // a margin is a share of the operating speed
    let (below, above) = (here.from / (1.0 + margin), here.to / (1.0 - margin));
    let clear = |w: f64, open: bool| (!open && known.0 <= w && w <= known.1 && !near(w)).then_some(w);
    [clear(below, here.open.0), clear(above, here.open.1)]
}

/// What to do next: from what is missing or not met.
fn next(facts: &Facts, checks: &[Check], over: Option<&OverSpeed>, speed: Operating) -> Vec<Message> {
    let mut out = Vec::new();
    let verdict = |name: &str| checks.iter().find(|c| c.what.key == name).map(|c| c.verdict);
    let runs = |kind: &str| facts.outcomes.iter().any(|o| o.kind == kind);
    let nonlinear = facts.system.slots().iter().any(|s| !s.is_linear());
    if let Some(hold) = hold(facts) {
        out.push(hold);
    } else if checks.iter().any(|c| c.what.key == "check-stability" && checks::grows(c)) {
        let [below, above] = outside(facts, over, speed).map(|w| w.map(Arg::speed));
        let sides = match (&below, &above) {
            (Some(_), Some(_)) => "both",
            (Some(_), None) => "below",
            (None, Some(_)) => "above",
            (None, None) => "none",
        };
        let none = || Arg::word("none");
        out.push(match runs("stability_map") {
            true => Message::new("next-unstable")
                .arg("sides", Arg::word(sides))
                .arg("below", below.unwrap_or_else(none))
                .arg("above", above.unwrap_or_else(none)),
            false => Message::new("next-stability-map"),
        });
    }
    let slow = checks.iter().find(|c| c.what.key == "check-stability" && c.result.key == "stability-slow");
    if let Some(limit) = slow.and_then(|c| c.result.arg_named("limit")) {
        out.push(Message::new("next-viscosity").arg("limit", limit.clone()));
    }
    if verdict("check-validity") == Some(Verdict::Attention) {
        out.push(Message::new("next-validity"));
    }
    if matches!(verdict("check-resonance"), Some(Verdict::Attention | Verdict::Failed)) {
        out.push(Message::new("next-resonance").arg("margin", Arg::percent(facts.resonance_margin().unwrap_or(MARGIN))));
    }
    if matches!(verdict("check-jump"), Some(Verdict::Attention | Verdict::Failed)) {
        out.push(Message::new("next-jump").arg("margin", Arg::percent(facts.resonance_margin().unwrap_or(MARGIN))));
    }
    if verdict("check-balls") == Some(Verdict::NotComputed) {
        out.push(Message::new("next-balls"));
    } else if facts.balls && checks::harm(facts, speed.low).is_some() {
        out.push(Message::new("next-harm"));
    }
    let crosses = over.is_some_and(|o| o.unstable.iter().any(|u| u.to < speed.low) || o.resonances.iter().any(|r| r.speed < speed.low));
    // no machine is run up to a speed at which it is unstable
    let crosses = crosses && !checks.iter().any(|c| c.what.key == "check-stability" && checks::grows(c));
    if crosses && !runs("run_up") && facts.run_up.as_ref().and_then(Known::get).is_none() {
        out.push(Message::new("next-run-up"));
    }
    if nonlinear && !runs("nonlinear_response") && verdict("check-balls").is_none() {
        out.push(Message::new("next-nonlinear"));
    }
    // keys of limits without which a result is not assessed; a limit on the velocity assesses the vibration as well
    let open = |name: &str| verdict(name) == Some(Verdict::NoLimit);
    let keys = [
        (open("check-vibration") && facts.limits.velocity.is_empty(), "displacement"),
        (open("check-forces") && facts.limits.force.is_empty(), "force"),
        (open("check-run-up"), "passage_displacement"),
    ];
    let keys: Vec<&str> = keys.iter().filter(|k| k.0).map(|k| k.1).collect();
    if !keys.is_empty() {
        out.push(Message::new("next-limits").arg("keys", Arg::names(keys)));
    }
    // the proposal of single studies says the same of one of them
    if facts.outcomes.is_empty() {
        out.retain(|m| m.key != "next-nonlinear" && m.key != "next-balls");
        out.extend(studies(facts));
    }
    out
}

/// Studies for a file that has none.
fn studies(facts: &Facts) -> Option<Message> {
    let nonlinear = facts.system.slots().iter().any(|s| !s.is_linear());
    let kinds: &[&str] = match (facts.balls, nonlinear) {
        (true, _) => &["stationary", "transient"],
        (false, true) => &["campbell", "forced_response", "nonlinear_response"],
        (false, false) => &["campbell", "forced_response"],
    };
    facts.outcomes.is_empty().then(|| Message::new("next-studies").arg("kinds", Arg::names(kinds.iter().copied())))
}
