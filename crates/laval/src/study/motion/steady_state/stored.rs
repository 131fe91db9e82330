//! Read from the stored rows of steady-state studies: words, and parts outside their validity.

use crate::diagnostic::Diagnostic;
use crate::outcome::{Finding, Outcome};
use crate::store::Results;
use std::collections::BTreeMap;

/// Words of a column; empty where there is none.
pub fn words(results: &Results, column: &str) -> Result<Vec<String>, Diagnostic> {
    let Some(c) = results.position(column) else { return Ok(vec![]) };
    let mut out = Vec::new();
    for chunk in results.chunks() {
        let chunk = chunk?;
        out.extend((0..chunk.rows.len()).map(|i| chunk.cells[c].word(i).unwrap_or_default().to_string()));
    }
    Ok(out)
}

/// Parts that leave their model, with the worst use. `at` says where a row lies.
pub fn limits(results: &Results, at: impl Fn(usize, Finding) -> Finding, mut outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let uses = results.numbers("validity")?;
    let mut worst: BTreeMap<String, (f64, usize, usize)> = BTreeMap::new();
    for (row, (what, ratio)) in words(results, "limit")?.into_iter().zip(uses).enumerate().filter(|(_, x)| x.1 > 1.0) {
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
    Ok(outcome)
}
