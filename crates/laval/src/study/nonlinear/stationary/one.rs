//! The states at one speed: those of branches over a narrow range about it.

use crate::outcome::{Arg, Data, Finding, Outcome};

/// Half the width of the range in which branches are followed, over the speed.
const ASIDE: f64 = 1e-3;
/// What is said of the range itself, and says nothing of one speed.
const OF_RANGES: [&str; 7] = ["balanced_stable", "stable_states", "continuum", "no_stable_state", "not_balanced", "harm", "coexistence"];

/// The range of speeds in which branches are followed.
pub(super) fn around(speed: f64) -> (f64, f64) {
    (speed * (1.0 - ASIDE), speed * (1.0 + ASIDE))
}

/// The outcome over the narrow range as that of the speed: its table of states, no curves, and a count in place of ranges.
pub(super) fn at(speed: f64, mut outcome: Outcome) -> Outcome {
    let stable = |o: &Outcome| match o.find_table("states").and_then(|t| t.column("stable")).map(|c| &c.data) {
        Some(Data::Flag(all)) => (all.iter().filter(|s| **s).count(), all.len()),
        _ => (0, 0),
    };
    let (stable, all) = stable(&outcome);
    let finding = match (stable, all) {
        (_, 0) => Finding::warning("states", "stationary-states-none"),
        (0, _) => Finding::warning("states", "stationary-states-unstable"),
        _ => Finding::info("states", "stationary-states"),
    };
    let finding = finding.arg("speed", Arg::speed(speed)).arg("states", Arg::count(all)).arg("stable", Arg::count(stable));
    let finding = if all > 0 { finding.value(all as f64, "") } else { finding };
    outcome.findings.retain(|f| !OF_RANGES.contains(&f.id.as_str()));
    outcome.findings.insert(0, finding.evidence("stable", stable as f64, ""));
    outcome.tables.retain(|t| !matches!(t.name(), "branches" | "changes"));
    // curves over the speed are none
    outcome.figures.retain(|f| !matches!(f.name.as_str(), "states" | "chart"));
    let tables = &outcome.tables;
    outcome.animations.retain(|a| a.check(tables).is_ok());
    outcome.special_points.retain(|p| p.at == speed);
    outcome
}
