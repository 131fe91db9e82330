//! Cells of a map, chosen by chance, that are followed to their ends after all: do they end where the map says?
//!
//! The steps are the same, so that a motion differs only by what was concluded from it. Beside a border nothing else than a disagreement can be expected now and
//! then; one with no neighbour that ends elsewhere would be a mistake.

use super::follow::Goal;
use super::{Basins, Members, place};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Finding, Outcome, Table};
use crate::study::motion::basins::rows::PLACE;
use crate::study::shared::support::inconsistent;
use laval_num::sampling::Points;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicU64, Ordering};

/// Seed of the choice of cells.
const SEED: u32 = 37;

/// A cell that ends elsewhere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Differs {
    /// Its number.
    pub cell: usize,
    /// What the map says of it.
    pub expected: String,
    /// What it ends in.
    pub end: String,
    /// A cell beside it ends elsewhere than expected.
    pub border: bool,
}

/// Cells that were followed to their ends after all.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checked {
    /// Number of cells.
    pub cells: usize,
    /// Those that end elsewhere.
    pub differ: Vec<Differs>,
}

/// One of the eight cells about a cell says something else.
fn at_a_border(words: &[String], width: usize, cell: usize) -> bool {
    let (i, j) = (cell % width, cell / width);
    let around = |x: usize, n: usize| x.saturating_sub(1)..=(x + 1).min(n.saturating_sub(1));
    around(j, words.len() / width).any(|b| around(i, width).any(|a| words[b * width + a] != words[cell]))
}

/// Follows cells; `None` when stopped.
pub(super) fn check(members: &Members, names: &[String], words: &[String]) -> Option<Checked> {
    let at = |k: usize| ((Points::Random.at(SEED, k as u32, 0) * words.len() as f64) as usize).min(words.len() - 1);
    let mut chosen: Vec<usize> = (0..members.study.check).map(at).collect();
    chosen.sort_unstable();
    // a cell drawn twice is followed once
    chosen.dedup();
    let starts: Vec<_> = chosen.iter().map(|&c| members.start_at(members.place(c))).collect();
    let (progress, done) = (members.context.progress, AtomicU64::new(0));
    let courses = members.follow(&starts, false, &|| progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, chosen.len() as u64))?;
    let mut differ = Vec::new();
    for (&cell, course) in chosen.iter().zip(&courses) {
        let end = match &course.goal {
            Goal::Known(k) => names.get(*k).cloned().unwrap_or_default(),
            goal => members.word(goal, &course.y),
        };
        if end != words[cell] {
            let border = at_a_border(words, members.values[0].len(), cell);
            differ.push(Differs { cell, expected: words[cell].clone(), end, border });
        }
    }
    Some(Checked { cells: chosen.len(), differ })
}

impl Checked {
    /// A finding, and a table of the cells that differ.
    pub(super) fn report(&self, study: &Basins, values: &[Vec<f64>; 2], outcome: Outcome) -> Result<Outcome, Diagnostic> {
        let (differ, inside) = (self.differ.len(), self.differ.iter().filter(|d| !d.border).count());
        let key = match (differ, inside) {
            (0, _) => "basins-agreement",
            (_, 0) => "basins-agreement-at-boundaries",
            _ => "basins-agreement-inside",
        };
        let doubtful = inside > 0 || 500 * differ > self.cells;
        let make = if doubtful { Finding::warning } else { Finding::info };
        let finding = make("agreement", key)
            .value((self.cells - differ) as f64, "")
            .arg("agree", Arg::count(self.cells - differ))
            .arg("cells", Arg::count(self.cells))
            .arg("inside", Arg::count(inside))
            .arg("doubtful", Arg::word(if doubtful { "yes" } else { "no" }))
            .evidence("cells followed", self.cells as f64, "")
            .evidence("end elsewhere", differ as f64, "")
            .evidence("of them with no neighbour that does", inside as f64, "");
        let mut table = Table::new("disagreements", "Cells followed to their ends that end elsewhere than expected");
        for (k, axis) in study.axes.iter().enumerate() {
            let places = self.differ.iter().map(|d| place(values, d.cell)[k]).collect();
            table = table.float(PLACE[k], &axis.unit, axis.meaning(), places);
        }
        let column = |f: &dyn Fn(&Differs) -> String| self.differ.iter().map(f).collect::<Vec<String>>();
        let table = table
            .text("expected", "what the map says of the cell", column(&|d| d.expected.clone()))
            .text("end", "what it ends in", column(&|d| d.end.clone()))
            .flag("border", "a cell beside it ends elsewhere", self.differ.iter().map(|d| d.border).collect());
        Ok(outcome.finding(finding).table(table.build().map_err(inconsistent)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_beside_a_border() {
        let map = |rows: [&str; 3]| rows.concat().chars().map(String::from).collect::<Vec<String>>();
        let words = map(["aaaa", "aaab", "aaaa"]);
        let beside: Vec<usize> = (0..12).filter(|&c| at_a_border(&words, 4, c)).collect();
        // nothing wraps round the ends of a row
        assert_eq!(beside, [2, 3, 6, 7, 10, 11]);
        assert!(!at_a_border(&map(["bbbb"; 3]), 4, 5));
    }
}
