//! Distances from instability and resonance.

use super::super::margins::{self, Nearest};
use super::super::operating::Operating;
use super::super::{Facts, MARGIN, ends, followed};
use crate::outcome::{Arg, Check, Message, OverSpeed, Unstable, Verdict};
use crate::solve::criticals::Critical;
use crate::study::linear::campbell;
use crate::study::shared::margins::resonant;
use laval_num::order::ascending;

/// On which sides an unstable range has no known end.
pub(in super::super) fn open(u: &Unstable) -> Arg {
    Arg::word(match u.open {
        (true, true) => "both",
        (true, false) => "below",
        (false, true) => "yes",
        (false, false) => "no",
    })
}

/// The unstable range that holds the lowest of the operating speeds that lie in one.
fn inside(over: &OverSpeed, speed: Operating) -> Message {
    let m = Message::new("distance-inside-unstable");
    let Some(u) = over.unstable.iter().find(|u| u.holds(speed.low, speed.high)) else {
        return m.arg("open", Arg::word("unknown"));
    };
    m.arg("open", open(u)).arg("from", Arg::speed(u.from)).arg("to", Arg::speed(u.to))
}

/// Share of the operating speed below which a range searched begins at rest.
const LOW: f64 = 0.25;

/// A distance in speed with its requirement.
pub(super) fn distance(what: &str, none: &str, nearest: &Nearest, speed: Operating, required: f64, within: (f64, f64)) -> Check {
    let places = |key: &str| {
        // a search that begins well below the operating speeds needs no lower end
        let from = if within.0 <= LOW * speed.low { Arg::word("none") } else { Arg::speed(within.0) };
        let mut m = Message::new(key).arg("from", from).arg("to", Arg::speed(within.1));
        for (name, place) in [("below", nearest.below), ("above", nearest.above)] {
            m = m.arg(name, place.map_or(Arg::word("none"), Arg::speed));
        }
        m
    };
    let margin = nearest.margin(speed);
    let inside = || Message::new("distance-inside").arg("places", Arg::List(nearest.inside.iter().map(|w| Arg::speed(*w)).collect()));
    let result = match (nearest.below, nearest.above) {
        _ if !nearest.inside.is_empty() => inside(),
        (None, None) => places(none),
        (Some(_), None) => places("distance-below"),
        (None, Some(_)) => places("distance-above"),
        (Some(_), Some(_)) => places("distance-both"),
    };
    let verdict = match margin {
        Some(m) if !(m >= required) || !nearest.inside.is_empty() => Verdict::Attention,
        _ => Verdict::Passed,
    };
    Check { required: Some(Arg::percent(required)), margin, ..Check::new(what, result, verdict) }
}

/// Where nothing was found as far as it was examined, which is not as far as the distance required: that is no margin.
fn as_far_as_examined(check: &mut Check, nearest: &Nearest, reach: (f64, f64), examined: (f64, f64)) {
    const SLACK: f64 = 1e-9;
    let below = nearest.below.is_some() || examined.0 <= reach.0 * (1.0 + SLACK);
    let above = nearest.above.is_some() || examined.1 >= reach.1 * (1.0 - SLACK);
    if check.verdict == Verdict::Passed && !(below && above) {
        check.verdict = Verdict::Attention;
        check.margin = None;
        check.detail = Some(Message::new("distance-not-examined").arg("from", Arg::speed(reach.0)).arg("to", Arg::speed(reach.1)));
    }
}

/// Largest step between speeds at which growth was computed among the operating speeds, over the speed, with which a range of them counts as examined.
const COARSE: f64 = 0.1;

/// Too few speeds were computed between these two.
fn coarse(over: &OverSpeed, (low, high): (f64, f64)) -> bool {
    let inside = over.growth_speed.windows(2).filter(|w| w[1] > low && w[0] < high);
    inside.into_iter().any(|w| w[1] - w[0] > COARSE * w[1])
}

pub(super) fn instability(facts: &Facts, over: Option<&OverSpeed>, speed: Operating, unstable: bool) -> Option<Check> {
    // what ended early below the operating speeds tells nothing of them
    let covered = |o: &&OverSpeed| {
        ends(&o.growth_speed).is_some_and(|(low, high)| low <= speed.low * (1.0 + 1e-9) && high >= speed.high * (1.0 - 1e-9))
    };
    let Some(over) = over.filter(|o| unstable || covered(o)) else {
        return Some(Check::new("check-instability", facts.stability.why(), Verdict::NotComputed));
    };
    let required = facts.operation.instability_margin.unwrap_or(MARGIN);
    let nearest = margins::instability(over, speed);
    let examined = ends(&over.growth_speed).unwrap_or(over.range);
    let mut check = distance("check-instability", "distance-stable-throughout", &nearest, speed, required, examined);
    check.detail = facts.stability.source();
    let reach = facts.reach(speed, facts.operation.instability_margin);
    as_far_as_examined(&mut check, &nearest, reach, examined);
    if check.verdict == Verdict::Passed && facts.near.is_none() && coarse(over, reach) {
        check.verdict = Verdict::Attention;
        check.margin = None;
        check.detail = Some(Message::new("distance-coarse"));
    }
    // a band may be narrower than the steps over the range
    if unstable || nearest.margin(speed) == Some(0.0) {
        check.verdict = Verdict::Failed;
        check.margin = None;
        check.result = inside(over, speed);
    } else if check.verdict == Verdict::Attention && check.margin.is_some() && facts.operation.instability_margin.is_some() {
        check.verdict = Verdict::Failed;
    }
    Some(check)
}

/// The study that found the nearest resonance: a peak is that of the response, a critical speed without an amplitude that of the modes.
fn source(facts: &Facts, over: &OverSpeed, nearest: &Nearest, speed: Operating) -> Option<Message> {
    let peak = match nearest.place(speed) {
        Some(place) => over.resonances.iter().any(|r| r.speed == place && r.amplitude.is_some()),
        None => !over.response_speed.is_empty(),
    };
    let from = |name: &String| Message::new("from-study").arg("study", Arg::name(name));
    if peak { facts.response_study.as_ref().map(from) } else { facts.criticals.source() }
}

/// Jumps and changes of stability of the nonlinear response; none where no study of the file found one.
pub(super) fn jump(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Option<Check> {
    let over = over.filter(|o| !o.jumps.is_empty() || !o.bifurcations.is_empty())?;
    let set = facts.resonance_margin();
    let nearest = margins::jump(over, speed);
    let mut check = distance("check-jump", "distance-no-resonance", &nearest, speed, set.unwrap_or(MARGIN), over.range);
    if check.verdict == Verdict::Attention && set.is_some() {
        check.verdict = Verdict::Failed;
    }
    Some(check)
}

/// Critically damped peaks, which are left out.
fn exempt(over: &OverSpeed) -> Option<Message> {
    let speeds: Vec<Arg> = over.critically_damped.iter().map(|w| Arg::speed(*w)).collect();
    (!speeds.is_empty()).then(|| Message::new("distance-critically-damped").arg("speeds", Arg::List(speeds)))
}

/// Critical speeds within the distance required that whirl forward and show no peak: with the unbalance of the file they are not excited, with another one they are.
fn silent(facts: &Facts, over: &OverSpeed, reach: (f64, f64)) -> Vec<f64> {
    let spins = facts.system.spins();
    let found = facts.criticals.get().into_iter().chain(&facts.narrow).flat_map(|c| &c.crossings);
    let driven = |c: &Critical| c.driven_by_unbalance() || spins.iter().any(|s| c.driven_by(s.ratio));
    let forward = found.filter(|c| driven(c) && c.forward_share > 0.5 && c.located() && resonant(campbell::damping(c)));
    let mut out: Vec<f64> = forward.map(|c| facts.sign * c.speed).filter(|w| reach.0 <= *w && *w <= reach.1).collect();
    out.retain(|w| !over.resonances.iter().any(|r| (r.speed - w).abs() < PEAK * w));
    ascending(&mut out);
    out.dedup_by(|a, b| (*a - *b).abs() < PEAK * *b);
    out
}

/// Distance of a peak from the critical speed it belongs to, over the speed, at most.
const PEAK: f64 = 0.05;

pub(super) fn resonance(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Option<Check> {
    let set = facts.resonance_margin();
    let reach = facts.reach(speed, set);
    let over = over.filter(|o| !o.response_speed.is_empty() || facts.criticals.get().is_some() || facts.narrow.is_some());
    let own = over.and_then(|o| facts.searched(o)).filter(|s| s.1 >= speed.high * (1.0 - 1e-9));
    // the search about the operating speeds reaches as far as required
    let searched = match (own, &facts.narrow) {
        (Some(own), Some(narrow)) => {
            let narrow = followed(narrow, facts.sign).unwrap_or(reach);
            Some((own.0.min(narrow.0), own.1.max(narrow.1)))
        }
        (None, Some(narrow)) => Some(followed(narrow, facts.sign).unwrap_or(reach)),
        (own, None) => own,
    };
    let Some((over, searched)) = over.zip(searched) else {
        return Some(Check::new("check-resonance", facts.criticals.why(), Verdict::NotComputed));
    };
    let nearest = margins::resonance(over, speed);
    let none = if over.critically_damped.is_empty() { "distance-no-resonance" } else { "distance-no-other-resonance" };
    let mut check = distance("check-resonance", none, &nearest, speed, set.unwrap_or(MARGIN), searched);
    check.detail = exempt(over).or_else(|| source(facts, over, &nearest, speed));
    as_far_as_examined(&mut check, &nearest, reach, searched);
    let (open, silent) = (facts.orders_open(), silent(facts, over, reach));
    if check.verdict == Verdict::Attention && check.margin.is_some() && set.is_some() {
        check.verdict = Verdict::Failed;
    } else if check.verdict == Verdict::Passed && !open.is_empty() {
        check.verdict = Verdict::Attention;
        check.margin = None;
        let orders = Arg::List(open.iter().map(|k| Arg::number(*k)).collect());
        check.detail = Some(Message::new("distance-orders-open").arg("orders", orders));
    } else if check.verdict == Verdict::Passed && !silent.is_empty() {
        check.verdict = Verdict::Attention;
        check.margin = None;
        let speeds = Arg::List(silent.iter().map(|w| Arg::speed(*w)).collect());
        check.detail = Some(Message::new("distance-silent").arg("speeds", speeds));
    }
    Some(check)
}
