//! What lies on the way to the operating speeds.

use super::super::forecast::forecast;
use super::super::operating::{Operating, span};
use super::super::spins::Spins;
use super::super::{Facts, Known, SECOND, ends, within_work};
use super::response::closed_on_the_way;
use super::{against, speeds};
use crate::diagnostic::Diagnostics;
use crate::model::field::{Value, Values};
use crate::model::system::System;
use crate::outcome::{Arg, Check, End, Message, Outcome, OverSpeed, Unstable, Verdict};
use crate::study::motion::run_up::RunUp;
use crate::study::shared::limits::Limit;
use crate::study::shared::support::larger;
use crate::study::{Context, Study};

/// A run-up is known where it is known from this share of the lowest operating speed on.
const BEGINS: f64 = 0.25;

/// Rows of the motion kept, and the tolerated error of a step: the page needs the largest displacement alone, to three digits.
const ROWS: i64 = 100;
const TOLERANCE: f64 = 1e-5;

/// Most units of work of the run-up; one that will take more is given up long before.
const WORK: u64 = SECOND + SECOND / 4;

/// The run-up from standstill to this speed in this time, s.
pub(in super::super) fn simulate(system: &System, speed: f64, time: f64, context: &Context) -> Known<Outcome> {
    let mut values = Values::default();
    values.set("to", Value::Number(speed), None);
    values.set("duration", Value::Number(time), None);
    values.set("points", Value::Integer(ROWS), None);
    values.set("relative_tolerance", Value::Number(TOLERANCE), None);
    let mut wrong = Diagnostics::default();
    let Some(study) = RunUp::build(&values, system, &mut wrong) else { return Known::Refused(wrong.into_error()) };
    let study = study.without_account();
    forecast(context, WORK, |context| within_work(&study, system, context, WORK))
        .and_then(|result| study.report(system, &result, RunUp::KIND).ok())
}

/// The largest displacement of each body on the run-ups of the file that begin below what is crossed and reach the operating speed; infinite where one of them
/// diverges, none where there is no such run-up.
fn simulated(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Vec<(String, f64)> {
    let events = over.into_iter().flat_map(|o| o.resonances.iter().map(|r| r.speed).chain(o.unstable.iter().map(|u| u.from)));
    let lowest = events.fold(0.2 * speed.low, f64::min);
    let one = |o: &Outcome| -> Vec<(String, f64)> {
        if matches!(o.end, End::Unbounded { .. }) {
            return vec![(String::new(), f64::INFINITY)];
        }
        let covered: Vec<f64> = speeds(o).into_iter().map(|w| facts.sign * w).collect();
        let whole =
            o.end.is_complete() && covered.iter().any(|w| *w >= 0.999 * speed.high) && covered.first().is_some_and(|w| *w <= lowest);
        let largest = o.findings.iter().filter(|f| f.id == "largest_displacement").filter_map(|f| Some((f.subject.clone(), f.value?)));
        largest.filter(|_| whole).collect()
    };
    let all = facts.outcomes.iter().filter(|o| o.kind == RunUp::KIND).chain(facts.run_up.as_ref().and_then(Known::get)).flat_map(one);
    let mut out: Vec<(String, f64)> = Vec::new();
    for (body, x) in all {
        match out.iter_mut().find(|known| known.0 == body) {
            Some(known) => known.1 = larger(known.1, x),
            None => out.push((body, x)),
        }
    }
    out
}

/// The limit that is used up most, with the displacement it is on, m. A limit on a point that the run-up does not list is held against the largest displacement
/// of all.
fn nearest(facts: &Facts, sizes: &[(String, f64)]) -> Option<(f64, f64)> {
    let most = sizes.iter().map(|s| s.1).fold(0.0, larger);
    let one = |l: &Limit| {
        // the limit of a body holds at all of its points
        let of_body = |name: &str| name.strip_prefix(&l.body).is_some_and(|rest| rest.is_empty() || rest.starts_with(" at "));
        let own = sizes.iter().filter(|s| s.0 == l.name || l.at.is_none() && of_body(&s.0));
        (l.value, own.map(|s| s.1).reduce(larger).unwrap_or(most))
    };
    facts.limits.passage.iter().map(one).max_by(|a, b| (a.1 / a.0).total_cmp(&(b.1 / b.0)))
}

/// The lowest speed from which on it is known up to the operating speeds what a run-up crosses.
fn known_from(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Option<f64> {
    let over = over.filter(|o| !o.growth.is_empty() && (!o.response_speed.is_empty() || facts.criticals.get().is_some()))?;
    let (growth, searched) = (ends(&over.growth_speed)?, facts.searched(over)?);
    (growth.1.min(searched.1) >= speed.high * (1.0 - 1e-9)).then_some(growth.0.max(searched.0))
}

/// What a run-up to the operating speed crosses, and how far the bodies move: on the way, or at its end, where the steady response may still be larger. `steady`
/// holds the displacements of that response; none where it is not stable.
pub(super) fn run_up(facts: &Facts, over: Option<&OverSpeed>, speed: Operating, steady: Vec<(String, f64)>) -> Option<Check> {
    // without any load nothing is simulated
    let passing = Some(simulated(facts, over, speed)).filter(|all| all.iter().any(|x| x.1 != 0.0)).unwrap_or_default();
    let lowest = known_from(facts, over, speed);
    if lowest.is_none() && passing.is_empty() {
        let result = Message::new("run-up-unknown").arg("speed", Arg::speed(speed.low));
        return Some(Check::new("check-run-up", result, Verdict::NotComputed));
    }
    let largest = |sizes: &[(String, f64)]| sizes.iter().max_by(|a, b| a.1.total_cmp(&b.1)).cloned();
    let (most, after) = (largest(&passing), if passing.is_empty() { None } else { largest(&steady) });
    let ends_higher = most.as_ref().zip(after.as_ref()).is_some_and(|(a, b)| !(b.1 <= a.1));
    let mut sizes = passing;
    for (body, x) in steady.into_iter().filter(|_| most.is_some()) {
        match sizes.iter_mut().find(|known| known.0 == body) {
            Some(known) => known.1 = larger(known.1, x),
            None => sizes.push((body, x)),
        }
    }
    let most = if ends_higher { after } else { most };
    let below = |o: &OverSpeed| {
        let resonances: Vec<Arg> = o.resonances.iter().filter(|r| r.speed < speed.high).map(|r| Arg::speed(r.speed)).collect();
        let unstable = o.unstable.iter().filter(|u| u.from < speed.high);
        let to = |u: &Unstable| if u.ends_below(speed.high) { u.to } else { speed.high };
        (resonances, unstable.map(|u| span(u.from, to(u))).collect::<Vec<Arg>>())
    };
    let (resonances, ranges) = over.map(below).unwrap_or_default();
    let (result, required, verdict) = match (most, resonances.is_empty() && ranges.is_empty()) {
        (Some((_, x)), _) if !x.is_finite() => (Message::new("run-up-diverges"), None, Verdict::Failed),
        (Some((body, x)), _) => {
            let key = if ends_higher { "run-up-steady" } else { "run-up-computed" };
            let result = Message::new(key).arg("body", Arg::name(body)).arg("value", Arg::quantity(x, "m"));
            let (required, verdict) = against(nearest(facts, &sizes).map(|l| (l, "m")));
            (result, required, verdict)
        }
        // slower speeds than a study of the file covers may hold more
        (None, true) if lowest.is_some_and(|w| w > BEGINS * speed.low) => {
            let result = Message::new("run-up-unknown").arg("speed", lowest.map_or(Arg::word("none"), Arg::speed));
            (result, None, Verdict::NotComputed)
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
            let several = Arg::count(ranges.len());
            (m.arg("several", several).arg("ranges", Arg::List(ranges)), None, Verdict::NotComputed)
        }
    };
    // no run-up has the unbalance of more than one spin
    let spins = &facts.spins;
    let spins = Spins { left_out: spins.known.iter().map(|k| &k.0).chain(&spins.left_out).cloned().collect(), ..Spins::default() };
    // a quick run-up may pass before the vibration has grown, and a part with a gap may hold it
    let contact = closed_on_the_way(facts);
    let verdict = if contact.is_empty() || verdict == Verdict::Failed { verdict } else { Verdict::Attention };
    let contact = (!contact.is_empty()).then(|| Message::new("run-up-contact").arg("parts", Arg::names(contact)));
    let detail = contact.or_else(|| spins.remark()).or_else(|| factor(facts, over, speed));
    Some(Check { required, detail, ..Check::new("check-run-up", result, spins.kept(verdict)) })
}

/// By what factor a disturbance grows at most on the way through unstable ranges in the time of the run-up: exp of the growth rate over that time, as in
/// every slow passage.
fn factor(facts: &Facts, over: Option<&OverSpeed>, speed: Operating) -> Option<Message> {
    let (time, over) = (facts.operation.run_up_time?, over?);
    let samples: Vec<(f64, f64)> = over.growth_speed.iter().copied().zip(over.growth.iter().map(|g| g.max(0.0))).collect();
    let piece = |w: &[(f64, f64)]| {
        let (from, to) = (w[0].0, w[1].0.min(speed.low));
        let end = w[0].1 + (w[1].1 - w[0].1) * (to - from) / (w[1].0 - from);
        if to > from { 0.5 * (w[0].1 + end) * (to - from) } else { 0.0 }
    };
    let area: f64 = samples.windows(2).map(piece).sum();
    let exponent = area * time / speed.high;
    (exponent > 0.0).then(|| Message::new("run-up-grows").arg("factor", Arg::number(exponent.exp())))
}
