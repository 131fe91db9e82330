//! Requirements at the operating speed, and how they are met.

mod balls;
mod distance;
mod response;
mod run_up;
mod stability;
mod standards;

pub(super) use balls::{harm, ranges};
pub(super) use distance::open;
pub(super) use run_up::simulate;
pub(super) use stability::grows;

use super::Facts;
use super::operating::{Operating, span};
use crate::outcome::{Arg, Check, Data, Level, Message, Outcome, OverSpeed, Verdict};
use crate::study::Study;
use crate::study::centrifuge::operating_window::OperatingWindow;
use crate::study::shared::speed_range::fastest_ratio;
use distance::{instability, resonance};
use response::{forces, steady, validity, vibration};
use run_up::run_up;
use stability::{damping, stability};

/// Bodies and parts named in one result.
const MOST_NAMED: usize = 3;

/// All checks that apply to this machine.
pub(super) fn checks(facts: &Facts, over: Option<&OverSpeed>) -> Vec<Check> {
    let Some(speed) = facts.operating else { return Vec::new() };
    if facts.balls {
        let mut out = vec![balls::balanced(facts, speed)];
        out.extend(balls::nearest(facts, speed));
        let vibration = balls::vibration(facts, speed);
        let assessed = vibration.as_ref().is_some_and(|c| c.verdict != Verdict::NotComputed);
        out.extend(vibration);
        out.extend(standards::vibration_without(facts, "shaft-vibration-unknown"));
        out.push(validity(facts));
        out.extend(balls::balls(facts));
        out.extend(standards::balance(facts, speed));
        out.extend(run_up(facts, over, speed, Vec::new()));
        out.extend(window(facts, speed));
        out.extend(highest(facts, speed));
        out.extend(left_out(facts, true, assessed));
        out.extend(requirements(facts));
        return out;
    }
    let mut out = vec![stability(facts, over, speed)];
    out.extend(damping(facts));
    let unstable = grows(&out[0]);
    out.extend(instability(facts, over, speed, unstable));
    // without a position at rest there is no response to unbalance, and no run-up
    let buckled = facts.buckling.is_some();
    if buckled && unstable {
        out.push(Check::new("check-resonance", Message::new("vibration-unstable"), Verdict::NotComputed));
    } else {
        out.extend(resonance(facts, over, speed));
        out.extend(distance::jump(facts, over, speed));
    }
    if unstable {
        // the response exists, and no machine stays on it
        out.push(Check::new("check-vibration", Message::new("vibration-unstable"), Verdict::NotComputed));
        out.extend(standards::vibration_without(facts, "vibration-unstable"));
    } else {
        out.extend(vibration(facts));
        out.extend(standards::vibration(facts, speed));
        out.extend(forces(facts));
    }
    out.extend(standards::balance(facts, speed));
    out.push(validity(facts));
    let after = if unstable { Vec::new() } else { steady(facts) };
    if buckled {
        let verdict = if unstable { Verdict::Failed } else { Verdict::Attention };
        out.push(Check::new("check-run-up", Message::new("run-up-buckled"), verdict));
    } else {
        out.extend(run_up(facts, over, speed, after));
    }
    out.extend(window(facts, speed));
    out.extend(highest(facts, speed));
    out.extend(left_out(facts, false, true));
    out.extend(requirements(facts));
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

/// The operating speed against the windows that a study of the file found.
fn window(facts: &Facts, speed: Operating) -> Option<Check> {
    let study = facts.outcomes.iter().find(|o| o.kind == OperatingWindow::KIND && o.end.is_complete())?;
    let windows: Vec<(f64, f64)> =
        study.findings.iter().filter(|f| f.id == "window").filter_map(|f| Some((f.number("from")?, f.value?))).collect();
    let range = |(from, to): &(f64, f64)| span(*from, *to);
    let (result, verdict) = match windows.iter().any(|(from, to)| *from <= speed.low && speed.high <= *to) {
        _ if windows.is_empty() => (Message::new("window-none"), Verdict::Failed),
        inside => {
            let result = Message::new("window-ranges").arg("ranges", Arg::List(windows.iter().map(range).collect()));
            (result, if inside { Verdict::Passed } else { Verdict::Failed })
        }
    };
    Some(Check { required: Some(Message::new("required-validity").into()), ..Check::new("check-window", result, verdict) })
}

/// The highest speed allowed.
fn highest(facts: &Facts, speed: Operating) -> Option<Check> {
    let limit = facts.limits.speed?;
    // the limit is one of strength: it holds for the fastest shaft
    let fastest = fastest_ratio(facts.system) * speed.high;
    let (required, verdict) = against(Some(((limit, fastest), "rad/s")));
    Some(Check { required, ..Check::new("check-speed", Message::new("speed-is").arg("speed", Arg::speed(fastest)), verdict) })
}

/// Warnings of studies that a requirement of theirs is not kept, or not known to be.
const REQUIREMENTS: [&str; 4] = ["separation_margin", "margin", "level_1", "shaft_vibration"];

/// Requirements that studies of the file assess, such as those of API 684: none where all of them are kept.
fn requirements(facts: &Facts) -> Option<Check> {
    let broken = |o: &&Outcome| o.findings.iter().any(|f| f.level == Level::Warning && REQUIREMENTS.contains(&f.id.as_str()));
    let names: Vec<&str> = facts.outcomes.iter().filter(broken).map(|o| o.name.as_str()).collect();
    let result = Message::new("studies-requirements").arg("studies", Arg::names(names.iter().copied()));
    (!names.is_empty()).then(|| Check::new("check-studies", result, Verdict::Attention))
}

/// Limits that this page does not assess.
fn left_out(facts: &Facts, balls: bool, vibration: bool) -> Option<Check> {
    // an operating window assesses them all
    if window(facts, facts.operating?).is_some() {
        return None;
    }
    let (l, o) = (&facts.limits, &facts.operation);
    let mut names = Vec::new();
    let mut add = |given: bool, name: &'static str| names.extend(given.then_some(name));
    add(!l.tilt.is_empty(), "tilt");
    add(!l.moment.is_empty(), "moment");
    add(l.torque.is_some(), "drive_torque");
    add(l.self_centring.is_some(), "self_centring");
    add(!vibration && !l.displacement.is_empty(), "displacement");
    add(balls && !l.velocity.is_empty(), "velocity");
    add(balls && !l.force.is_empty(), "force");
    add(balls && l.clearance.is_some(), "clearance");
    add(balls && l.growth > 0.0, "growth_margin");
    add(balls && o.resonance_margin.is_some(), "resonance_margin");
    add(balls && o.instability_margin.is_some(), "instability_margin");
    add(balls && o.decrement.is_some(), "decrement");
    let result = Message::new("limits-left-out").arg("names", Arg::names(names.iter().copied()));
    (!names.is_empty()).then(|| Check::new("check-others", result, Verdict::NotComputed))
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

/// Speeds that a study covers: those of all its tables.
fn speeds(o: &Outcome) -> Vec<f64> {
    let columns = o.tables.iter().filter_map(|t| t.column("speed"));
    let floats = columns.filter_map(|c| match &c.data {
        Data::Float(v) => Some(v),
        _ => None,
    });
    floats.flatten().copied().filter(|w| w.is_finite()).collect()
}
