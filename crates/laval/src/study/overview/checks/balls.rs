//! Checks of a machine whose balls move in the rotor: no linear study answers them, and a study of stationary states does.

use super::super::margins::Nearest;
use super::super::operating::Operating;
use super::super::{Facts, MARGIN};
use super::distance::distance;
use super::{MOST_NAMED, against, speeds};
use crate::outcome::{Arg, Check, Data, Finding, Message, Outcome, Verdict};
use crate::study::Study;
use crate::study::nonlinear::stationary::Stationary;
use crate::study::shared::limits::Limit;
use crate::study::shared::support::larger;
use laval_num::order::SortByNumber;

/// Distance of the operating speed from the nearest speed of the table, over it, up to which its states are those of the operating speed.
const BESIDE: f64 = 0.01;

fn studies<'f>(facts: &'f Facts) -> impl Iterator<Item = &'f Outcome> {
    facts.outcomes.iter().filter(|o| o.kind == Stationary::KIND)
}

fn findings<'f>(facts: &'f Facts) -> impl Iterator<Item = &'f Finding> {
    studies(facts).flat_map(|o| &o.findings)
}

/// Ranges of speed that findings of this kind name, amounts.
pub(in super::super) fn ranges(facts: &Facts, id: &str) -> Vec<(f64, f64)> {
    let own = findings(facts).filter(|f| f.id == id);
    let ends = own.filter_map(|f| Some((f.number("from")?, f.number("to").or(f.value)?)));
    ends.map(|(a, b)| (facts.sign * a, facts.sign * b)).map(|(a, b)| (a.min(b), a.max(b))).collect()
}

/// The largest growth of the unbalance by the balls, of what findings name below a speed: from, to, times.
pub(in super::super) fn harm(facts: &Facts, below: f64) -> Option<(f64, f64, f64)> {
    let own = findings(facts).filter(|f| f.id == "harm" && f.unit.is_empty());
    let all = own.filter_map(|f| Some((facts.sign * f.number("from")?, facts.sign * f.number("to")?, f.value?)));
    let all = all.map(|(a, b, x)| (a.min(b), a.max(b), x));
    all.filter(|h| h.0 < below).max_by(|a, b| a.2.total_cmp(&b.2))
}

/// The widest range of this kind that holds the operating speeds.
fn range(facts: &Facts, speed: Operating, id: &str) -> Option<(f64, f64)> {
    let all = ranges(facts, id).into_iter().filter(|(from, to)| *from <= speed.low && speed.high <= *to);
    all.max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))
}

/// The lowest and the highest speed of the states known; none where they do not cover the operating speeds.
fn covered(facts: &Facts, speed: Operating) -> Option<(f64, f64)> {
    let all: Vec<f64> = studies(facts).flat_map(speeds).map(|w| facts.sign * w).collect();
    let (low, high) = super::super::ends(&all)?;
    (low <= speed.low * (1.0 + 1e-9) && speed.high * (1.0 - 1e-9) <= high).then_some((low, high))
}

/// Whether a state of the balls is stable at the speed.
pub(super) fn balanced(facts: &Facts, speed: Operating) -> Check {
    if findings(facts).next().is_none() {
        return Check::new("check-stability", Message::new("stability-needs-stationary"), Verdict::NotComputed);
    }
    if covered(facts, speed).is_none() {
        return Check::new("check-stability", Message::new("stability-outside-study"), Verdict::NotComputed);
    }
    let (result, verdict) = match (range(facts, speed, "balanced_stable"), range(facts, speed, "stable_states")) {
        (Some(_), _) => (Message::new("stability-balanced"), Verdict::Passed),
        (None, Some(_)) => (Message::new("stability-state"), Verdict::Attention),
        (None, None) => (Message::new("stability-no-state"), Verdict::Failed),
    };
    Check {
        required: Some(Message::new("required-decay").arg("margin", Arg::word("none")).into()),
        ..Check::new("check-stability", result, verdict)
    }
}

/// How far the ends of the range of stability are.
pub(super) fn nearest(facts: &Facts, speed: Operating) -> Option<Check> {
    let (low, high) = covered(facts, speed)?;
    let (from, to) = range(facts, speed, "balanced_stable").or_else(|| range(facts, speed, "stable_states"))?;
    let slack = 1e-6 * (high - low);
    let ends = [(from, from > low + slack), (to, to < high - slack)];
    let nearest = Nearest::of(ends.into_iter().filter(|e| e.1).map(|e| e.0), speed);
    let set = facts.operation.instability_margin;
    let mut check = distance("check-instability", "distance-stable-throughout", &nearest, speed, set.unwrap_or(MARGIN), (low, high));
    if check.verdict == Verdict::Attention && set.is_some() {
        check.verdict = Verdict::Failed;
    }
    Some(check)
}

/// Largest displacement of each body over the stable states at the operating speed, which turn with the rotor.
pub(super) fn vibration(facts: &Facts, speed: Operating) -> Option<Check> {
    let mut all: Vec<(String, f64)> = Vec::new();
    for o in studies(facts) {
        let table = o.find_table("states")?;
        let float = |name: &str| match &table.column(name)?.data {
            Data::Float(v) => Some(v),
            _ => None,
        };
        let Data::Flag(stable) = &table.column("stable")?.data else { return None };
        let at = float("speed")?;
        for place in [speed.low, speed.high] {
            let near = at.iter().map(|w| facts.sign * w).min_by(|a, b| (a - place).abs().total_cmp(&(b - place).abs()))?;
            if !((near - place).abs() <= BESIDE * place) {
                return None;
            }
            let rows: Vec<usize> = (0..at.len()).filter(|&k| stable[k] && facts.sign * at[k] == near).collect();
            for body in facts.system.stations() {
                let radius = float(&format!("{} radius", body.name))?;
                let Some(x) = rows.iter().map(|&k| radius[k]).reduce(larger) else { continue };
                match all.iter_mut().find(|a| a.0 == body.name) {
                    Some(a) => a.1 = larger(a.1, x),
                    None => all.push((body.name.clone(), x)),
                }
            }
        }
    }
    if all.is_empty() {
        return None;
    }
    let kept = |l: &Limit| all.iter().find(|a| a.0 == l.body && l.at.is_none()).map(|a| (l.value, a.1));
    let worst = facts.limits.displacement.iter().filter_map(kept).max_by(|a, b| (a.1 / a.0).total_cmp(&(b.1 / b.0)));
    let (required, verdict) = against(worst.map(|w| (w, "m")));
    // a limit on a point is on more than is known here
    let open = facts.limits.displacement.iter().any(|l| l.at.is_some()) && verdict != Verdict::Failed;
    let verdict = if open { Verdict::NotComputed } else { verdict };
    all.sort_by_number_down(|a| a.1);
    all.truncate(MOST_NAMED);
    let item =
        |(name, x): &(String, f64)| Arg::from(Message::new("item").arg("name", Arg::name(name)).arg("value", Arg::quantity(*x, "m")));
    let result = Message::new("vibration-sizes").arg("sizes", Arg::List(all.iter().map(item).collect()));
    let detail = Some(Message::new("vibration-states"));
    Some(Check { detail, required, ..Check::new("check-vibration", result, verdict) })
}

/// What balls leave of the unbalance, of a study of stationary states.
pub(super) fn balls(facts: &Facts) -> Option<Check> {
    let left = findings(facts).find(|f| f.id == "residual_unbalance");
    let Some((left, value)) = left.and_then(|f| Some((f, f.value?))) else {
        return Some(Check::new("check-balls", Message::new("balls-no-study"), Verdict::NotComputed));
    };
    let number = |what: &str| left.evidence.iter().find(|e| e.what == what).map(|e| e.value);
    let without = number("without the masses").unwrap_or(f64::NAN);
    let result = Message::new("balls-left").arg("left", Arg::quantity(value, "kg m")).arg("without", Arg::quantity(without, "kg m"));
    let verdict = if value < without { Verdict::Passed } else { Verdict::Attention };
    Some(Check { required: Some(Message::new("required-less-unbalance").into()), ..Check::new("check-balls", result, verdict) })
}
