//! The rows of a run as plain data.

use super::{Cells, Column, Results, incomplete};
use crate::diagnostic::Diagnostic;
use crate::outcome::{End, Finding};
use serde::{Deserialize, Serialize};

/// All rows of a run that are there, column by column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Collected {
    /// Columns and their values.
    pub columns: Vec<(Column, Cells)>,
    /// Rows that are there.
    pub done: u64,
    /// Rows requested.
    pub requested: u64,
    /// They are kept in a folder, where the same study goes on.
    pub kept: bool,
    /// How the run ended.
    pub end: End,
}

impl Collected {
    /// The rows of a run.
    ///
    /// # Errors
    /// When a chunk cannot be read.
    pub fn of(results: &Results) -> Result<Collected, Diagnostic> {
        let mut columns: Vec<(Column, Cells)> = results.columns().iter().map(|c| (c.clone(), Cells::none(c.kind))).collect();
        for chunk in results.chunks() {
            for (all, cells) in columns.iter_mut().zip(chunk?.cells) {
                all.1.append(cells);
            }
        }
        let (done, requested) = (results.done(), results.requested());
        Ok(Collected { columns, done, requested, kept: results.kept(), end: results.end() })
    }

    fn cells(&self, column: &str) -> Option<&Cells> {
        self.columns.iter().find(|c| c.0.name == column).map(|c| &c.1)
    }

    /// One column of numbers, NaN where there is none; empty where there is no such column.
    pub fn numbers(&self, column: &str) -> Vec<f64> {
        self.cells(column).map_or(Vec::new(), |cells| (0..cells.len()).map(|i| cells.number(i)).collect())
    }

    /// One column of words, empty where there is none; empty where there is no such column.
    pub fn words(&self, column: &str) -> Vec<String> {
        self.cells(column).map_or(Vec::new(), |cells| (0..cells.len()).map(|i| cells.word(i).unwrap_or_default().to_string()).collect())
    }

    /// What a run that ended early owes its reader: how far it came, and how it goes on.
    pub fn remark(&self) -> Option<Finding> {
        self.remark_of("rows")
    }

    /// The same where the rows have a name.
    pub fn remark_of(&self, rows: &str) -> Option<Finding> {
        incomplete(self.done, self.requested, self.kept, rows)
    }
}
