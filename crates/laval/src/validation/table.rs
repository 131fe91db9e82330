//! The table of expected values.

use super::markdown::{Cell, Grid};
use super::value::{Choice, What};
use crate::diagnostic::{Diagnostic, Diagnostics, nearest};
use crate::text;
use crate::text::Text;
use crate::units::{UnitError, parse_unit, read_quantity};

/// How one number compares with what is expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Row {
    /// Within the tolerance.
    Agrees,
    /// Outside the tolerance, inside the scatter of the source.
    WithinScatter,
    /// Outside both, or no number.
    Differs,
}

impl Row {
    /// The word in the table.
    pub fn word(self) -> &'static str {
        match self {
            Row::Agrees => "agrees",
            Row::WithinScatter => "within source scatter",
            Row::Differs => "differs",
        }
    }
    fn read(text: &str) -> Option<Row> {
        [Row::Agrees, Row::WithinScatter, Row::Differs].into_iter().find(|r| r.word() == text)
    }
}

/// What a number should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// This value, in the unit of the row.
    Value(f64),
    /// Below this value.
    Below(f64),
    /// Above this value.
    Above(f64),
}

/// How far a number may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// Share of the expected value.
    Relative(f64),
    /// In the unit of the row.
    Absolute(f64),
}

impl Tolerance {
    fn read(text: &str) -> Option<Tolerance> {
        let (number, word) = text.split_once(' ')?;
        let x = number.parse::<f64>().ok().filter(|x| *x > 0.0 && x.is_finite())?;
        match word.trim() {
            "relative" => Some(Tolerance::Relative(x)),
            "absolute" => Some(Tolerance::Absolute(x)),
            _ => None,
        }
    }
    /// In the unit of the row.
    pub fn size(self, expected: f64) -> f64 {
        match self {
            Tolerance::Relative(x) => x * expected.abs(),
            Tolerance::Absolute(x) => x,
        }
    }
    /// As in the document.
    pub fn words(self) -> String {
        match self {
            Tolerance::Relative(x) => format!("{x:e} relative"),
            Tolerance::Absolute(x) => format!("{x:e} absolute"),
        }
    }
}

/// One row: a number of a study and what it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    /// Name of the study.
    pub study: String,
    /// The number as the document names it.
    pub value: String,
    /// Which of several, as the document says it.
    pub at: String,
    /// The same, read.
    pub(super) what: What,
    pub(super) choices: Vec<Choice>,
    /// What it should be, in `unit`.
    pub expected: Expected,
    /// As written, with all digits.
    pub expected_text: String,
    /// Unit of the row; a factor before it turns dimensionless numbers of a source into quantities.
    pub unit: String,
    /// How far the number may be off; `None` for a bound.
    pub tolerance: Option<Tolerance>,
    /// How far the source itself is uncertain.
    pub scatter: Option<Tolerance>,
    /// The verdict the document states.
    pub stated: Row,
    /// A remark.
    pub note: String,
    pub(super) place: crate::diagnostic::Span,
}

const COLUMNS: [&str; 9] = ["study", "value", "at", "expected", "unit", "tolerance", "scatter", "verdict", "note"];

impl Expectation {
    /// The rows of a table; says all that is wrong.
    pub(super) fn read(grid: &Grid, out: &mut Diagnostics) -> Vec<Expectation> {
        let before = out.0.len();
        let wrong = |cell: &Cell, message: Text| Diagnostic::error("validation.expected", message).at(cell.span.clone());
        for h in &grid.head {
            if !COLUMNS.contains(&h.text.as_str()) {
                let help = nearest(&h.text, COLUMNS).map_or_else(
                    || text!("columns: {names}", names = COLUMNS.join(", ")),
                    |n| text!("did you mean {near}?", near = text::quoted(&n)),
                );
                out.push(wrong(h, text!("\"{text}\" is no column of expected values", text = h.text)).help(help));
            }
        }
        for name in ["study", "value", "expected", "tolerance"] {
            if !grid.head.iter().any(|h| h.text == name) {
                let place = grid.head.first().cloned().unwrap_or_default();
                out.push(wrong(&place, text!("the table of expected values has no column \"{name}\"", name)));
            }
        }
        if out.0.len() > before {
            return Vec::new();
        }
        grid.rows.iter().filter_map(|row| Self::row(&grid.head, row, out)).collect()
    }

    fn row(head: &[Cell], row: &[Cell], out: &mut Diagnostics) -> Option<Expectation> {
        let before = out.0.len();
        let mut wrong = |cell: &Cell, message: Text, help: Option<Text>| {
            let d = Diagnostic::error("validation.expected", message).at(cell.span.clone());
            out.push(match help {
                Some(help) => d.help(help),
                None => d,
            });
        };
        let place = row.first().map_or(0..0, |c| c.span.start..row.last().map_or(c.span.end, |l| l.span.end));
        if row.len() != head.len() {
            let all = Cell { text: String::new(), span: place };
            wrong(
                &all,
                text!("this row has {cells} cells, the head of the table has {head}", cells = row.len(), head = head.len()),
                Some(text!("write a bar inside a cell as \\|")),
            );
            return None;
        }
        let missing = Cell::default();
        // marks that only serve the eye
        let get = |name: &str| {
            let cell = head.iter().position(|h| h.text == name).map_or(&missing, |i| &row[i]);
            (cell, cell.text.trim_matches('`').trim())
        };
        let (cell, value) = get("value");
        let what = What::read(value);
        if what.is_none() {
            wrong(
                cell,
                text!("\"{value}\" names no number", value),
                Some(text!("write TABLE / COLUMN, finding ID, point KIND, or count of points KIND")),
            );
        }
        let (cell, at) = get("at");
        let choices = Choice::read(at);
        if choices.is_none() {
            wrong(
                cell,
                text!("\"{at}\" chooses no row", at),
                Some(text!(
                    "write COLUMN = VALUE, COLUMN near VALUE, near VALUE, nr N, first, last, largest or smallest, with commas between"
                )),
            );
        }
        let (cell, expected_text) = get("expected");
        let number = |t: &str| t.trim().parse::<f64>().ok().filter(|x| x.is_finite());
        let expected = if let Some(t) = expected_text.strip_prefix("below ") {
            number(t).map(Expected::Below)
        } else if let Some(t) = expected_text.strip_prefix("above ") {
            number(t).map(Expected::Above)
        } else {
            number(expected_text).map(Expected::Value)
        };
        if expected.is_none() {
            wrong(
                cell,
                text!("\"{expected_text}\" is no number", expected_text),
                Some(text!("write a number, below NUMBER or above NUMBER; the unit has a column of its own")),
            );
        }
        let (cell, unit) = get("unit");
        if let Err(e) = factor(unit, split_factor(unit).1) {
            wrong(cell, text!("\"{unit}\" is no unit: {why}", unit, why = e), None);
        }
        let (cell, text) = get("tolerance");
        let tolerance = Tolerance::read(text);
        match (expected, tolerance) {
            (Some(Expected::Value(0.0)), Some(Tolerance::Relative(_))) => {
                wrong(cell, text!("nothing is near zero relatively"), Some(text!("give an absolute tolerance")));
            }
            (Some(Expected::Value(_)), None) => {
                wrong(
                    cell,
                    text!("\"{text}\" is no tolerance", text),
                    Some(text!("write NUMBER relative or NUMBER absolute (in the unit of the row), above zero")),
                );
            }
            (Some(Expected::Below(_) | Expected::Above(_)), _) if !matches!(text, "" | "-" | "–") => {
                wrong(cell, text!("a bound has no tolerance"), Some(text!("leave the cell empty")));
            }
            _ => {}
        }
        let (cell, text) = get("scatter");
        let scatter = Tolerance::read(text);
        if scatter.is_none() && !matches!(text, "" | "-" | "–") {
            wrong(cell, text!("\"{text}\" is no scatter", text), Some(text!("write NUMBER relative or NUMBER absolute")));
        }
        let (cell, text) = get("verdict");
        let stated = if text.is_empty() { Some(Row::Agrees) } else { Row::read(text) };
        if stated.is_none() {
            wrong(cell, text!("\"{text}\" is no verdict of a row", text), Some(text!("write agrees, within source scatter or differs")));
        }
        if out.0.len() > before {
            return None;
        }
        let note = head.iter().position(|h| h.text == "note").map_or(String::new(), |i| row[i].text.clone());
        Some(Expectation {
            study: get("study").1.into(),
            value: value.into(),
            at: at.into(),
            what: what?,
            choices: choices?,
            expected: expected?,
            expected_text: expected_text.into(),
            unit: unit.into(),
            tolerance,
            scatter,
            stated: stated?,
            note,
            place,
        })
    }
}

/// Cuts a leading number off a unit.
fn split_factor(unit: &str) -> (&str, &str) {
    match unit.split_once(' ') {
        Some((n, rest)) if n.parse::<f64>().is_ok() => (n, rest.trim()),
        _ => ("1", unit),
    }
}

/// What one of the row's unit is in the unit of the outcome.
pub(super) fn factor(unit: &str, of_outcome: &str) -> Result<f64, Text> {
    let (number, plain) = split_factor(unit);
    parse_unit(plain).map_err(UnitError::sentence)?;
    read_quantity(format!("{number} {plain}").trim(), of_outcome).map_err(UnitError::sentence)
}
