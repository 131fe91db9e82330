//! Read from the stored rows of steady-state studies: parts outside their validity.

use crate::diagnostic::Diagnostic;
use crate::outcome::{Finding, Outcome};
use crate::store::Collected;
use std::collections::BTreeMap;

/// These columns are there: the rows may be those of a stored result.
///
/// # Errors
/// A column that is not.
pub fn check(results: &Collected, mut columns: impl Iterator<Item = String>) -> Result<(), Diagnostic> {
    let missing = columns.find(|name| !results.columns.iter().any(|c| c.0.name == *name));
    missing.map_or(Ok(()), |name| Err(Diagnostic::error("store.columns", format!("there is no column \"{name}\""))))
}

/// Parts that leave their model, with the worst use. `at` says where a row lies.
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
        let text = format!("\"{part}\" leaves its model in {count} motions: {statement} reaches");
        let finding = if ratio.is_finite() {
            Finding::invalid("validity", text + " {}, above 1.").value(ratio, "")
        } else {
            Finding::invalid("validity", text + " no finite value.")
        };
        outcome = outcome.finding(at(row, finding.of(part)));
    }
    outcome
}
