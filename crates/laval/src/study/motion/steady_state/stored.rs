//! Read from the stored rows of steady-state studies: the motions, and parts outside their validity.

use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Finding, Outcome};
use crate::store::Collected;
use crate::text;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a motion settles on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Settling {
    /// It repeats after so many turns.
    Periodic(usize),
    /// It does not repeat: quasi-periodic, chaotic, or of a longer period.
    NotPeriodic,
    /// It still changed slowly where it was cut short.
    NotSettled,
    /// It could not be followed, and why.
    Failed(String),
}

/// A settled motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SettledMotion {
    /// What it settles on.
    pub settling: Settling,
    /// Estimated distance from the settled motion over its size; NaN where there is none.
    pub remaining: f64,
    /// Turns integrated.
    pub turns: u64,
    /// Integration steps.
    pub steps: u64,
    /// The largest number of periods cut the settling short.
    pub cut_short: bool,
    /// Largest displacements (m) of all bodies and points, and largest tilts (rad), by name of their columns, such as `amplitude.drum`; NaN where the motion failed.
    pub amplitudes: Vec<(String, f64)>,
}

/// The motions of stored rows.
pub fn settled(results: &Collected) -> Vec<SettledMotion> {
    let (motion, failure) = (results.words("motion"), results.words("failure"));
    let number = ["period", "remaining", "periods", "steps", "bounded"].map(|name| results.numbers(name));
    let sizes = results.columns.iter().map(|c| &c.0.name).filter(|n| n.starts_with("amplitude.") || n.starts_with("tilt."));
    let sizes: Vec<(&String, Vec<f64>)> = sizes.map(|n| (n, results.numbers(n))).collect();
    let one = |(row, word): (usize, &String)| {
        let [period, remaining, turns, steps, bounded] = number.each_ref().map(|n| n.get(row).copied().unwrap_or(f64::NAN));
        let settling = match word.as_str() {
            "periodic" => Settling::Periodic(period as usize),
            "not periodic" => Settling::NotPeriodic,
            "not settled" => Settling::NotSettled,
            _ => Settling::Failed(failure.get(row).cloned().unwrap_or_default()),
        };
        let amplitudes = sizes.iter().map(|(n, all)| ((*n).clone(), all[row])).collect();
        SettledMotion { settling, remaining, turns: turns as u64, steps: steps as u64, cut_short: bounded == 1.0, amplitudes }
    };
    motion.iter().enumerate().map(one).collect()
}

/// These columns are there: the rows may be those of a stored result.
///
/// # Errors
/// A column that is not.
pub fn check(results: &Collected, mut columns: impl Iterator<Item = String>) -> Result<(), Diagnostic> {
    let missing = columns.find(|name| !results.columns.iter().any(|c| c.0.name == *name));
    missing.map_or(Ok(()), |name| Err(Diagnostic::error("store.columns", text!("there is no column \"{name}\"", name))))
}

/// Parts outside their validity, with the worst use. `at` says where a row lies.
pub fn limits(results: &Collected, at: impl Fn(usize, Finding) -> Finding, mut outcome: Outcome) -> Outcome {
    let uses = results.numbers("validity");
    let mut worst: BTreeMap<String, (f64, usize, usize)> = BTreeMap::new();
    for (row, (what, ratio)) in results.words("limit").into_iter().zip(uses).enumerate().filter(|(_, x)| x.1 > 1.0) {
        let entry = worst.entry(what).or_insert((ratio, row, 0));
        entry.2 += 1;
        if ratio > entry.0 {
            (entry.0, entry.1) = (ratio, row);
        }
    }
    for (what, (ratio, row, count)) in worst {
        let (part, statement) = what.split_once(": ").unwrap_or((&what, ""));
        let finding = if ratio.is_finite() {
            Finding::invalid("validity", "steady-state-not-valid").value(ratio, "")
        } else {
            Finding::invalid("validity", "steady-state-not-valid-unbounded")
        };
        let finding = finding.of(part).arg("part", Arg::name(part)).arg("what", Arg::term(statement)).arg("count", Arg::count(count));
        outcome = outcome.finding(at(row, finding));
    }
    outcome
}
