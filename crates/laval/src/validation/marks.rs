//! Expected values drawn into the figures of their studies.

use super::table::{Expectation, Expected, Row, factor};
use super::value::{Choice, What};
use crate::outcome::{Figure, Line, Mark, Outcome, OutcomeError, Points, Table};
use crate::units::read_quantity;

/// The name an expected value has in the legend.
fn name(row: Row) -> &'static str {
    match row {
        Row::Agrees => "expected: agrees",
        Row::WithinScatter => "expected: within source scatter",
        Row::Differs => "expected: differs",
    }
}

/// A figure with the expected values that belong to its lines, and the tables to draw it from; `None` when no value does.
///
/// A value belongs to a line when it stands in the column the line draws and is chosen by the column it is drawn against.
///
/// # Errors
/// When a table cannot be formed.
pub(super) fn marked(figure: &Figure, outcome: &Outcome, expected: &[Expectation]) -> Result<Option<(Figure, Vec<Table>)>, OutcomeError> {
    let mut figure = figure.clone();
    let mut tables = Vec::new();
    for panel in &mut figure.panels {
        let lines: Vec<Line> = panel.marks.iter().filter_map(|m| if let Mark::Line(l) = m { Some(l.clone()) } else { None }).collect();
        for row in [Row::Agrees, Row::WithinScatter, Row::Differs] {
            let of_row = expected.iter().filter(|e| e.stated == row && e.study == outcome.name);
            let places: Vec<(f64, f64)> = of_row.flat_map(|e| lines.iter().filter_map(|l| place(e, l, outcome))).collect();
            if places.is_empty() {
                continue;
            }
            let table = format!("expected {}", tables.len());
            tables.push(
                Table::new(&table, "Expected values")
                    .float("x", "", "place", places.iter().map(|p| p.0).collect())
                    .float("y", "", "value", places.iter().map(|p| p.1).collect())
                    .build()?,
            );
            panel.marks.push(Mark::Points(Points::new(table, "x", "y").name(name(row))));
        }
    }
    if tables.is_empty() {
        return Ok(None);
    }
    tables.extend(outcome.tables.iter().cloned());
    Ok(Some((figure, tables)))
}

/// Where an expected value stands beside a line, in the units of the columns.
fn place(e: &Expectation, line: &Line, outcome: &Outcome) -> Option<(f64, f64)> {
    let What::Cell { table, column } = &e.what else { return None };
    let Expected::Value(value) = e.expected else { return None };
    if *table != line.table || *column != line.y {
        return None;
    }
    let table = outcome.find_table(table)?;
    let text = e.choices.iter().find_map(|c| match c {
        Choice::Equal(by, text) | Choice::Near(Some(by), text) if *by == line.x => Some(text),
        _ => None,
    })?;
    let x = read_quantity(text, &table.column(&line.x)?.unit).ok()?;
    let y = value * factor(&e.unit, &table.column(column)?.unit).ok()?;
    (x.is_finite() && y.is_finite()).then_some((x, y))
}
