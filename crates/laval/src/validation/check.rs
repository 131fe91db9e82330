//! Running a case and comparing.

use super::case::{Case, Verdict, verdict};
use super::table::{Expectation, Expected, Row, factor};
use crate::diagnostic::{Diagnostic, Diagnostics, nearest};
use crate::file;
use crate::outcome::Outcome;
use crate::study::Context;
use crate::text;
use crate::text::Text;

/// One number compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// What was found, in the unit of the row; NaN when nothing was.
    pub measured: f64,
    /// Distance from the expected value or bound, in the unit of the row.
    pub error: f64,
    /// Error over tolerance; for a bound 0 or infinite.
    pub ratio: f64,
    /// How it compares.
    pub row: Row,
}

/// A case that was run.
#[derive(Debug)]
pub struct Checked {
    /// The case.
    pub case: Case,
    /// What its studies found, in the order of the document.
    pub outcomes: Vec<Outcome>,
    /// One entry for each expected value, as long as the case could run.
    pub compared: Vec<Compared>,
    /// Why it could not run; places are those of the document.
    pub problems: Diagnostics,
}

impl Checked {
    /// What follows from the comparisons; `None` when the case could not run.
    pub fn verdict(&self) -> Option<Verdict> {
        if self.problems.has_errors() || self.compared.len() != self.case.expected.len() {
            return None;
        }
        self.compared.iter().map(|c| c.row).max().map(|worst| verdict(worst, self.case.explained))
    }

    /// The verdicts of the document, of every row and of the page, are those found.
    pub fn holds(&self) -> bool {
        self.verdict() == Some(self.case.verdict) && self.case.expected.iter().zip(&self.compared).all(|(e, c)| e.stated == c.row)
    }

    /// Largest error over tolerance; NaN when a number is missing.
    pub fn worst(&self) -> f64 {
        let worse = |a: f64, c: &Compared| if a.is_nan() || c.ratio.is_nan() { f64::NAN } else { a.max(c.ratio) };
        if self.verdict().is_none() { f64::NAN } else { self.compared.iter().fold(0.0, worse) }
    }
}

/// Runs the machines of a case the ordinary way and compares.
pub fn check(case: Case) -> Checked {
    let mut problems = Diagnostics::default();
    let outcomes = run(&case, &mut problems);
    let mut compared = Vec::new();
    if !problems.has_errors() {
        for e in &case.expected {
            match compare(e, &outcomes) {
                Ok(c) => compared.push(c),
                Err(message) => {
                    let message = text!("study \"{study}\", {value}: {message}", study = e.study, value = e.value, message);
                    problems.push(Diagnostic::error("validation.value", message).at(e.place.clone()));
                }
            }
        }
    }
    Checked { case, outcomes, compared, problems }
}

fn run(case: &Case, problems: &mut Diagnostics) -> Vec<Outcome> {
    let mut outcomes: Vec<Outcome> = Vec::new();
    for machine in &case.machines {
        let moved = |mut d: Diagnostic| {
            d.span = Some(d.span.map_or(machine.span.clone(), |s| s.start + machine.span.start..s.end + machine.span.start));
            d
        };
        let loaded = match file::load(&machine.text) {
            Ok(loaded) => loaded,
            Err(found) => {
                problems.0.extend(found.0.into_iter().map(moved));
                continue;
            }
        };
        for named in &loaded.studies {
            let context = Context { name: &named.name, ..Context::quiet("") };
            if outcomes.iter().any(|o| o.name == named.name) {
                let d = Diagnostic::error("validation.study", text!("two studies of this page are named \"{name}\"", name = named.name));
                problems.push(moved(d.help(text!("give each study of the page a name of its own"))));
                continue;
            }
            match named.study.run(&loaded.system, &context) {
                Ok(outcome) => {
                    if !outcome.end.is_complete() {
                        let d = Diagnostic::error(
                            "validation.study",
                            text!("study \"{name}\": {message}", name = named.name, message = outcome.end_in_words()),
                        );
                        problems.push(moved(d));
                    }
                    outcomes.push(outcome);
                }
                Err(mut d) => {
                    d.message = text!("study \"{name}\": {message}", name = named.name, message = d.message);
                    problems.push(moved(d));
                }
            }
        }
    }
    outcomes
}

fn compare(e: &Expectation, outcomes: &[Outcome]) -> Result<Compared, Text> {
    let outcome = outcomes.iter().find(|o| o.name == e.study).ok_or_else(|| {
        let names = || outcomes.iter().map(|o| o.name.as_str());
        match nearest(&e.study, names()) {
            Some(n) => text!("there is no such study; did you mean {near}?", near = text::quoted(&n)),
            None => text!("there is no such study; studies: {names}", names = names().collect::<Vec<_>>().join(", ")),
        }
    })?;
    let found = e.what.find(outcome, &e.choices)?;
    let measured = found.value / factor(&e.unit, &found.unit)?;
    Ok(assess(e, measured))
}

fn assess(e: &Expectation, measured: f64) -> Compared {
    let (error, ratio) = match e.expected {
        Expected::Value(x) => {
            let error = (measured - x).abs();
            (error, error / e.tolerance.map_or(f64::NAN, |t| t.size(x)))
        }
        Expected::Below(x) => bound(measured - x),
        Expected::Above(x) => bound(x - measured),
    };
    let inside = match (e.expected, e.scatter) {
        (Expected::Value(x), Some(s)) => error <= s.size(x),
        _ => false,
    };
    let row = if ratio <= 1.0 {
        Row::Agrees
    } else if inside {
        Row::WithinScatter
    } else {
        Row::Differs
    };
    Compared { measured, error, ratio, row }
}

/// Excess over a bound that must not be reached.
fn bound(excess: f64) -> (f64, f64) {
    if excess.is_nan() {
        (f64::NAN, f64::NAN)
    } else if excess < 0.0 {
        (0.0, 0.0)
    } else {
        (excess, f64::INFINITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mass on a spring, with the rows and the end of the page to choose.
    fn page(verdict: &str, rows: &str, end: &str) -> String {
        format!(
            "# Mass on a spring\n\n| | |\n|---|---|\n| Requirement | r |\n| Source | s |\n| Evidence | closed form |\n| Verdict | {verdict} |\n\n\
             ## Symbols\nk\n\n## Machine\n```toml machine\n[machine]\nname = \"m\"\n[[part]]\nkind = \"disc\"\nname = \"body\"\nmass = \"4 kg\"\n\
             [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"body\", \"ground\"]\nstiffness = \"400 N/m\"\n\
             [[study]]\nkind = \"modes\"\nspeed = \"0 rad/s\"\n```\n\n## Expected\n\
             | study | value | at | expected | unit | tolerance | scatter | verdict |\n|---|---|---|---|---|---|---|---|\n{rows}\n\
             ## Tolerance\nt\n{end}"
        )
    }

    fn checked(verdict: &str, rows: &str, end: &str) -> Checked {
        check(Case::parse("t/c", &page(verdict, rows, end)).unwrap_or_else(|d| panic!("{d:?}")))
    }

    const RIGHT: &str = "| modes | modes / frequency | first | 10 | rad/s | 1e-12 relative | | |\n";
    const WRONG: &str = "| modes | modes / frequency | first | 10.1 | rad/s | 1e-3 relative | | |\n";
    const STATED: &str = "| modes | modes / frequency | first | 10.1 | rad/s | 1e-3 relative | | differs |\n";
    const WHY: &str = "\n## Why it differs\nBecause.\n";

    #[test]
    fn a_right_value_agrees() {
        let c = checked("agrees", RIGHT, "");
        assert_eq!((c.verdict(), c.holds()), (Some(Verdict::Agrees), true));
        assert!(c.worst() < 1.0 && c.problems.0.is_empty());
        assert!(checked("agrees", "| modes | modes / frequency | first | 1 | 10 rad/s | 1e-12 relative | | |\n", "").holds());
        assert!(checked("agrees", "| modes | modes / frequency | first | 95.49296585513721 | rpm | 1e-12 relative | | |\n", "").holds());
        assert!(checked("agrees", "| modes | modes / frequency | first | below 10.1 | rad/s | | | |\n", "").holds());
    }

    #[test]
    fn a_wrong_value_changes_the_verdict() {
        let c = checked("agrees", WRONG, "");
        assert_eq!((c.verdict(), c.holds()), (Some(Verdict::Open), false));
        assert!((c.worst() - 0.1 / 0.0101).abs() < 1e-9);
        // an explanation of something else does not cover it
        let c = checked("differs (explained)", &format!("{STATED}{WRONG}"), WHY);
        assert_eq!((c.verdict(), c.holds()), (Some(Verdict::Explained), false));
        assert!(!checked("agrees", "| modes | modes / frequency | first | above 10 | rad/s | | | |\n", "").holds());
    }

    #[test]
    fn a_stated_difference_must_remain() {
        assert!(checked("differs (explained)", STATED, WHY).holds());
        assert!(checked("open", STATED, "").holds());
        let gone = "| modes | modes / frequency | first | 10 | rad/s | 1e-3 relative | | differs |\n";
        assert!(!checked("differs (explained)", gone, WHY).holds());
    }

    #[test]
    fn scatter_of_the_source_is_between() {
        let row = "| modes | modes / frequency | first | 10.1 | rad/s | 1e-3 relative | 0.2 absolute | within source scatter |\n";
        let c = checked("within source scatter", row, "");
        assert_eq!((c.verdict(), c.holds()), (Some(Verdict::WithinScatter), true));
    }

    #[test]
    fn no_number_differs() {
        let case = Case::parse("t/c", &page("agrees", RIGHT, "")).unwrap();
        for expected in [Expected::Value(1.0), Expected::Below(1.0), Expected::Above(1.0)] {
            let e = Expectation { expected, scatter: case.expected[0].tolerance, ..case.expected[0].clone() };
            let c = assess(&e, f64::NAN);
            assert_eq!(c.row, Row::Differs);
            assert!(c.ratio.is_nan());
        }
    }

    #[test]
    fn what_cannot_run_has_no_verdict() {
        for row in [
            "| mode | modes / frequency | first | 10 | rad/s | 1e-12 relative | | |\n",
            "| modes | modes / frequenzy | first | 10 | rad/s | 1e-12 relative | | |\n",
            "| modes | modes / frequency | first | 10 | kg | 1e-12 relative | | |\n",
        ] {
            let c = checked("agrees", row, "");
            assert_eq!((c.verdict(), c.holds()), (None, false), "{row}");
            let place = c.problems.0[0].span.clone().unwrap();
            assert!(row.contains(&c.case.text[place]));
        }
        let text = page("agrees", RIGHT, "").replace("stiffness", "stifness");
        let c = check(Case::parse("t/c", &text).unwrap());
        assert!(!c.holds());
        assert!(c.problems.0.iter().any(|d| d.span.clone().is_some_and(|place| text[place].contains("stifness"))));
    }

    #[test]
    fn documents_are_reported_all_that_is_missing() {
        let codes = |text: &str| Case::parse("t/c", text).err().map_or(0, |d| d.0.len());
        assert_eq!(codes(&page("agrees", RIGHT, "")), 0);
        assert!(codes("") >= 9);
        assert_eq!(codes(&page("agrees", STATED, WHY)), 1, "stated verdict and rows contradict each other");
        assert_eq!(codes(&page("differs (explained)", STATED, "")), 1, "no explanation");
        assert_eq!(codes(&page("fine", RIGHT, "")), 1);
        assert_eq!(codes(&page("agrees", "", "")), 1, "nothing expected");
        for row in [
            "| modes | modes | | 10 | rad/s | 1e-12 relative | | |\n",
            "| modes | modes / frequency | somewhere | 10 | rad/s | 1e-12 relative | | |\n",
            "| modes | modes / frequency | first | NaN | rad/s | 1e-12 relative | | |\n",
            "| modes | modes / frequency | first | 10 | radd/s | 1e-12 relative | | |\n",
            "| modes | modes / frequency | first | 10 | rad/s | 1e-12 | | |\n",
            "| modes | modes / frequency | first | 10 | rad/s | -1 relative | | |\n",
            "| modes | modes / frequency | first | 0 | rad/s | 1e-12 relative | | |\n",
            "| modes | modes / frequency | first | below 0 | rad/s | 1 absolute | | |\n",
            "| modes | modes / frequency | first | 10 | rad/s | 1e-12 relative | | perhaps |\n",
            "| modes | modes / frequency |\n",
        ] {
            assert_eq!(codes(&page("agrees", row, "")), 1, "{row}");
        }
    }
}
