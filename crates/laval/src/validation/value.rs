//! Which number of an outcome is meant.

use crate::outcome::{Data, Evidence, Outcome};
use crate::text;
use crate::text::Text;
use crate::units::{UnitError, read_quantity};
use laval_num::order::SortByNumber;

/// What is compared: the cell `value` of an expectation.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// `TABLE / COLUMN`.
    Cell {
        /// Table.
        table: String,
        /// Column.
        column: String,
    },
    /// `finding ID` or `finding ID / EVIDENCE`.
    Finding {
        /// Machine name.
        id: String,
        /// A supporting number instead of the value.
        evidence: Option<String>,
    },
    /// `point KIND` or `point KIND / EVIDENCE`.
    Point {
        /// Machine name.
        kind: String,
        /// A supporting number instead of the place.
        evidence: Option<String>,
    },
    /// `count of findings ID`.
    Findings(String),
    /// `count of points KIND`.
    Points(String),
    /// `count of rows TABLE`.
    Rows(String),
}

/// A condition on candidates: the cell `at` of an expectation, which holds any number of them between commas.
#[derive(Clone, Debug, PartialEq)]
pub enum Choice {
    /// `COLUMN = VALUE`.
    Equal(String, String),
    /// `COLUMN near VALUE`, or `near VALUE` for points and findings.
    Near(Option<String>, String),
    /// `nr N`, counted from 1.
    Number(usize),
    /// `last`.
    Last,
    /// `largest`.
    Largest,
    /// `smallest`.
    Smallest,
}

/// A number found in an outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// In the unit of the outcome.
    pub value: f64,
    /// That unit.
    pub unit: String,
}

impl What {
    /// Reads the cell `value`.
    pub(super) fn read(text: &str) -> Option<What> {
        let (left, right) = match text.split_once(" / ") {
            Some((l, r)) => (l.trim(), Some(r.trim().to_string())),
            None => (text.trim(), None),
        };
        if let Some(rest) = left.strip_prefix("count of ") {
            let (what, name) = rest.split_once(' ')?;
            return match (what, right) {
                ("findings", None) => Some(What::Findings(name.into())),
                ("points", None) => Some(What::Points(name.into())),
                ("rows", None) => Some(What::Rows(name.into())),
                _ => None,
            };
        }
        if let Some(id) = left.strip_prefix("finding ") {
            return Some(What::Finding { id: id.into(), evidence: right });
        }
        if let Some(kind) = left.strip_prefix("point ") {
            return Some(What::Point { kind: kind.into(), evidence: right });
        }
        let column = right.filter(|c| !c.is_empty())?;
        (!left.is_empty()).then(|| What::Cell { table: left.into(), column })
    }

    /// The one number of the outcome that is meant; the error is the sentence to show.
    pub(super) fn find(&self, outcome: &Outcome, at: &[Choice]) -> Result<Measured, Text> {
        let count = |n: usize| Ok(Measured { value: n as f64, unit: String::new() });
        match self {
            What::Findings(id) => count(outcome.findings.iter().filter(|f| &f.id == id).count()),
            What::Points(kind) => count(outcome.special_points.iter().filter(|p| &p.kind == kind).count()),
            What::Rows(name) => {
                let known = || list(Listed::Tables, outcome.tables.iter().map(|t| t.name()));
                count(outcome.find_table(name).ok_or_else(|| text!("there is no table \"{name}\"; {known}", name, known = known()))?.rows())
            }
            What::Cell { table, column } => cell(outcome, table, column, at),
            What::Finding { id, evidence } => {
                let all: Vec<_> = outcome.findings.iter().filter(|f| &f.id == id).collect();
                if all.is_empty() {
                    return Err(text!(
                        "there is no finding \"{id}\"; {list}",
                        id,
                        list = list(Listed::Findings, outcome.findings.iter().map(|f| f.id.as_str()))
                    ));
                }
                let numbers = all
                    .iter()
                    .map(|f| match evidence {
                        Some(e) => supporting(&f.evidence, e),
                        None => f.value.map(|v| (v, f.unit.clone())).ok_or_else(|| text!("the finding \"{id}\" has no number", id)),
                    })
                    .collect::<Result<Vec<_>, _>>()?;
                let places: Vec<f64> = numbers.iter().map(|n| n.0).collect();
                let unit = numbers.first().map(|n| n.1.clone()).unwrap_or_default();
                one(numbers.into_iter().map(Some).collect(), &places, &unit, at)
            }
            What::Point { kind, evidence } => {
                let mut all: Vec<_> = outcome.special_points.iter().filter(|p| &p.kind == kind).collect();
                if all.is_empty() {
                    let kinds = list(Listed::Points, outcome.special_points.iter().map(|p| p.kind.as_str()));
                    return Err(text!("there is no special point \"{kind}\"; {kinds}", kind, kinds));
                }
                all.sort_by_number(|a| a.at);
                let unit = outcome.parameter.as_ref().map(|p| p.unit.clone()).unwrap_or_default();
                let numbers = all
                    .iter()
                    .map(|p| match evidence {
                        Some(e) => supporting(&p.evidence, e),
                        None => Ok((p.at, unit.clone())),
                    })
                    .collect::<Result<Vec<_>, _>>()?;
                let places: Vec<f64> = all.iter().map(|p| p.at).collect();
                one(numbers.into_iter().map(Some).collect(), &places, &unit, at)
            }
        }
    }
}

impl Choice {
    /// Reads the cell `at`.
    pub(super) fn read(text: &str) -> Option<Vec<Choice>> {
        text.split(',').map(str::trim).filter(|t| !t.is_empty()).map(Choice::one).collect()
    }

    fn one(text: &str) -> Option<Choice> {
        Some(match text {
            "first" => Choice::Number(1),
            "last" => Choice::Last,
            "largest" => Choice::Largest,
            "smallest" => Choice::Smallest,
            _ => {
                if let Some(n) = text.strip_prefix("nr ") {
                    Choice::Number(n.trim().parse().ok().filter(|&n| n > 0)?)
                } else if let Some((column, value)) = text.split_once(" = ") {
                    Choice::Equal(column.trim().into(), value.trim().into())
                } else if let Some(value) = text.strip_prefix("near ") {
                    Choice::Near(None, value.trim().into())
                } else {
                    let (column, value) = text.split_once(" near ")?;
                    Choice::Near(Some(column.trim().into()), value.trim().into())
                }
            }
        })
    }
}

/// What an outcome has by name.
enum Listed {
    Tables,
    Columns,
    Findings,
    Points,
    Evidence,
}

fn list<'a>(of: Listed, names: impl Iterator<Item = &'a str>) -> Text {
    let mut names: Vec<&str> = names.collect();
    names.dedup();
    let (none, names) = (names.is_empty(), names.join(", "));
    match of {
        Listed::Tables if none => text!("this study has no tables"),
        Listed::Tables => text!("tables: {names}", names),
        Listed::Columns if none => text!("this study has no columns"),
        Listed::Columns => text!("columns: {names}", names),
        Listed::Findings if none => text!("this study has no findings"),
        Listed::Findings => text!("findings: {names}", names),
        Listed::Points if none => text!("this study has no special points"),
        Listed::Points => text!("special points: {names}", names),
        Listed::Evidence if none => text!("this study has no evidence"),
        Listed::Evidence => text!("evidence: {names}", names),
    }
}

fn supporting(evidence: &[Evidence], what: &str) -> Result<(f64, String), Text> {
    match evidence.iter().find(|e| e.what == what) {
        Some(e) => Ok((e.value, e.unit.clone())),
        None => {
            let names: Vec<String> = evidence.iter().map(|e| e.what.to_string()).collect();
            Err(text!("there is no evidence \"{what}\"; {list}", what, list = list(Listed::Evidence, names.iter().map(String::as_str))))
        }
    }
}

fn cell(outcome: &Outcome, table: &str, column: &str, at: &[Choice]) -> Result<Measured, Text> {
    let t = outcome.find_table(table).ok_or_else(|| {
        text!("there is no table \"{table}\"; {list}", table, list = list(Listed::Tables, outcome.tables.iter().map(|t| t.name())))
    })?;
    let named = |name: &str| {
        t.column(name).ok_or_else(|| {
            text!(
                "table \"{table}\" has no column \"{name}\"; {list}",
                table,
                name,
                list = list(Listed::Columns, t.columns().iter().map(|c| c.name.as_str()))
            )
        })
    };
    let wanted = named(column)?;
    if t.rows() == 0 {
        return Err(text!("table \"{table}\" has no rows", table));
    }
    let mut numbers: Vec<Option<(f64, String)>> = (0..t.rows())
        .map(|row| {
            let number = wanted.number(row).ok_or_else(|| text!("column \"{column}\" holds no numbers", column))?;
            Ok(Some((number, wanted.unit.clone())))
        })
        .collect::<Result<_, Text>>()?;
    let mut rest = Vec::new();
    for choice in at {
        match choice {
            Choice::Equal(name, value) => {
                let by = named(name)?;
                let fits: Box<dyn Fn(usize) -> bool> = match &by.data {
                    Data::Text(v) => Box::new(|row| v[row] == *value),
                    Data::Flag(v) => match value.as_str() {
                        "yes" => Box::new(|row| v[row]),
                        "no" => Box::new(|row| !v[row]),
                        _ => return Err(text!("column \"{name}\" is yes or no, not \"{value}\"", name, value)),
                    },
                    _ => {
                        let x = read_quantity(value, &by.unit).map_err(UnitError::sentence)?;
                        Box::new(move |row| by.number(row).is_some_and(|y| (y - x).abs() <= 1e-12 * x.abs()))
                    }
                };
                (0..t.rows()).filter(|&row| !fits(row)).for_each(|row| numbers[row] = None);
            }
            Choice::Near(Some(name), value) => {
                let by = named(name)?;
                let x = read_quantity(value, &by.unit).map_err(UnitError::sentence)?;
                let far = |row: usize| by.number(row).map_or(f64::INFINITY, |y| (y - x).abs());
                let near = (0..t.rows()).filter(|&row| numbers[row].is_some()).min_by(|&a, &b| far(a).total_cmp(&far(b)));
                (0..t.rows()).filter(|&row| Some(row) != near).for_each(|row| numbers[row] = None);
            }
            other => rest.push(other.clone()),
        }
    }
    let places: Vec<f64> = (0..t.rows()).map(|row| wanted.number(row).unwrap_or(f64::NAN)).collect();
    one(numbers, &places, &wanted.unit, &rest)
}

/// The candidate left by the choices; `places` is what `near` compares, in `unit`.
fn one(numbers: Vec<Option<(f64, String)>>, places: &[f64], unit: &str, at: &[Choice]) -> Result<Measured, Text> {
    let mut left: Vec<(usize, f64, String)> =
        numbers.into_iter().enumerate().filter_map(|(i, n)| n.map(|(value, unit)| (i, value, unit))).collect();
    for choice in at {
        let keep = match choice {
            Choice::Number(n) => n - 1,
            Choice::Last => left.len().saturating_sub(1),
            // a value that is no number wins, so that it is seen
            Choice::Largest => extreme(&left, |v| v),
            Choice::Smallest => extreme(&left, |v| -v),
            Choice::Near(None, value) => {
                let x = read_quantity(value, unit).map_err(UnitError::sentence)?;
                extreme(&left.iter().map(|l| (l.0, places[l.0], String::new())).collect::<Vec<_>>(), |v| -(v - x).abs())
            }
            Choice::Equal(..) | Choice::Near(Some(_), _) => return Err(text!("points and findings have no columns")),
        };
        left = left.into_iter().skip(keep).take(1).collect();
    }
    match left.len() {
        1 => Ok(left.pop().map(|(_, value, unit)| Measured { value, unit }).unwrap_or(Measured { value: f64::NAN, unit: String::new() })),
        0 => Err(text!("no row fits")),
        n => Err(text!("{n} rows fit: say which one in the column \"at\"", n)),
    }
}

fn extreme(of: &[(usize, f64, String)], rank: impl Fn(f64) -> f64) -> usize {
    let key = |v: f64| if v.is_nan() { f64::INFINITY } else { rank(v) };
    (0..of.len()).max_by(|&a, &b| key(of[a].1).total_cmp(&key(of[b].1)).then(b.cmp(&a))).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Finding, SpecialPoint, Table};

    fn outcome() -> Outcome {
        let table = Table::new("modes", "")
            .float("speed", "rad/s", "", vec![10.0, 20.0, 20.0])
            .float("growth", "1/s", "", vec![-1.0, 3.0, 2.0])
            .text("whirl", "", vec!["forward".into(), "backward".into(), "forward".into()])
            .flag("stable", "", vec![true, false, false])
            .build()
            .unwrap();
        Outcome::new("k", "n")
            .over("speed", "rad/s")
            .table(table)
            .finding(Finding::info("end", "{}").value(1.0, "m").evidence("x", 7.0, "m"))
            .finding(Finding::info("end", "{}").value(2.0, "m").evidence("x", 8.0, "m"))
            .special_point(SpecialPoint::new("fold", 200.0, (199.0, 201.0)).evidence("residual", 1e-9, ""))
            .special_point(SpecialPoint::new("fold", 100.0, (99.0, 101.0)).evidence("residual", 2e-9, ""))
    }

    fn get(what: &str, at: &str) -> Result<f64, Text> {
        What::read(what).unwrap().find(&outcome(), &Choice::read(at).unwrap()).map(|m| m.value)
    }

    #[test]
    fn numbers_are_found() {
        assert_eq!(get("modes / growth", "speed = 10 rad/s"), Ok(-1.0));
        assert_eq!(get("modes / growth", "speed = 20 rad/s, whirl = forward"), Ok(2.0));
        assert_eq!(get("modes / growth", "stable = no, largest"), Ok(3.0));
        assert_eq!(get("modes / growth", "speed near 13 rad/s"), Ok(-1.0));
        assert_eq!(get("modes / growth", "last"), Ok(2.0));
        assert_eq!(get("modes / growth", "smallest"), Ok(-1.0));
        assert_eq!(get("modes / growth", "near 2.9 1/s"), Ok(3.0));
        assert_eq!(get("finding end", "nr 2"), Ok(2.0));
        assert_eq!(get("finding end / x", "near 7.9 m"), Ok(8.0));
        assert_eq!(get("point fold", "first"), Ok(100.0));
        assert_eq!(get("point fold / residual", "near 190 rad/s"), Ok(1e-9));
        assert_eq!(get("count of points fold", ""), Ok(2.0));
        assert_eq!(get("count of findings none", ""), Ok(0.0));
        assert_eq!(get("count of rows modes", ""), Ok(3.0));
    }

    #[test]
    fn what_is_not_one_number_is_reported() {
        for (what, at, words) in [
            ("modes / growth", "speed = 20 rad/s", "2 rows fit"),
            ("modes / growth", "speed = 20", "unit"),
            ("modes / growth", "nr 4", "no row"),
            ("modes / whirl", "first", "no numbers"),
            ("modes / grow", "first", "growth"),
            ("mode / growth", "first", "modes"),
            ("point fold", "", "2 rows fit"),
            ("point hopf", "", "fold"),
            ("finding end / y", "first", "evidence: x"),
            ("count of rows none", "", "modes"),
        ] {
            let e = get(what, at).unwrap_err();
            assert!(e.contains(words), "{what} {at}: {e}");
        }
        assert_eq!(What::read("modes"), None);
        assert_eq!(Choice::read("somewhere"), None);
        assert_eq!(Choice::read("nr 0"), None);
    }

    #[test]
    fn a_value_that_is_no_number_is_not_passed_over() {
        let table = Table::new("t", "").float("x", "", "", vec![1.0, f64::NAN, 2.0]).build().unwrap();
        let o = Outcome::new("k", "n").table(table);
        for at in ["largest", "smallest"] {
            assert!(What::read("t / x").unwrap().find(&o, &Choice::read(at).unwrap()).unwrap().value.is_nan());
        }
    }
}
