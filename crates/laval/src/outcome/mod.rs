//! What a study hands back: tables, figures, findings, and how it ended.
//!
//! An [`Outcome`] knows nothing of machines, parts or output formats. A study fills it; `report` draws and writes it.
//! Partial success is a value: see [`End`].
//!
//! ```
//! use laval::outcome::{Axis, End, Figure, Finding, Line, Outcome, Panel, Rule, Table};
//!
//! # fn main() -> Result<(), laval::outcome::OutcomeError> {
//! let table = Table::new("response", "Steady unbalance response of the drum")
//!     .float("speed", "rad/s", "spin speed", vec![100.0, 200.0, 300.0])
//!     .float("amplitude", "m", "largest displacement of the drum", vec![1e-5, 9e-5, 2e-5])
//!     .flag("stable", "all Floquet multipliers inside the unit circle", vec![true, false, true])
//!     .build()?;
//! let figure = Figure::new("amplitude", "Unbalance response", "Amplitude peaks at 200 rad/s, where the branch is unstable.")
//!     .x(Axis::new("speed", "rad/s"))
//!     .panel(
//!         Panel::new(Axis::log("amplitude", "µm").factor(1e6))
//!             .mark(Line::new("response", "speed", "amplitude").solid_where("stable"))
//!             .mark(Rule::x(250.0, "operating speed")),
//!     );
//! let outcome = Outcome::new("nonlinear_response", "response")
//!     .over("speed", "rad/s")
//!     .end(End::Reached)
//!     .finding(Finding::info("peak_amplitude", "The drum moves most, {}, at 200 rad/s.").value(9e-5, "m").evidence("residual", 3e-13, "N"))
//!     .table(table)
//!     .figure(figure)
//!     .checked()?;
//! assert_eq!(outcome.findings[0].sentence(), "The drum moves most, 90 µm, at 200 rad/s.");
//! # Ok(()) }
//! ```

mod animation;
mod figure;
mod finding;
mod kept;
mod message;
mod number;
mod overview;
mod stored;
mod table;
mod tiles;

use crate::text;
use crate::text::Argument;
pub use animation::{Animation, Circle};
pub use figure::{Axis, Band, BandPlace, Figure, Heat, Line, Mark, Panel, Points, Rule, Scale, Text, parameter_name};
pub use finding::{Evidence, Finding, Level};
pub use kept::Kept;
pub use message::{Arg, Message, Quantity, Role};
pub(crate) use number::quantity_to;
pub use number::{quantity, significant, unit_text};
pub use overview::{Block, Check, Joint, Mode, OverSpeed, Overview, Resonance, Unstable, Verdict};
use serde::{Deserialize, Serialize};
pub use stored::Fixed;
pub use table::{Column, Data, Table, TableBuilder};
pub use tiles::{Limit, Picture, Tiles, View};

use crate::diagnostic::Diagnostic;
use std::collections::BTreeMap;
use std::fmt;

/// Everything one study found out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// The study's kind, the word in the file: `nonlinear_response`.
    pub kind: String,
    /// The study's own name; also the name of its folder of tables.
    pub name: String,
    /// How the study ended.
    pub end: End,
    /// Name and unit of the quantity the study moves along; places in `end` and `special_points` are values of it.
    pub parameter: Option<Parameter>,
    /// What was found out, most important first.
    pub findings: Vec<Finding>,
    /// The numbers.
    pub tables: Vec<Table>,
    /// The pictures, drawn from `tables`.
    pub figures: Vec<Figure>,
    /// Motions to be played.
    pub animations: Vec<Animation>,
    /// Folds, bifurcations, crossings.
    pub special_points: Vec<SpecialPoint>,
    /// Work counters (steps, factorisations, residual calls): name to count, in order of name.
    pub work: BTreeMap<String, u64>,
    /// The study and its result, where the first page may need them.
    #[serde(skip)]
    pub kept: Kept,
}

/// Name and unit of the quantity a study moves along.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Parameter {
    /// Name, such as `speed`.
    pub name: String,
    /// Unit, such as `rad/s`.
    pub unit: String,
}

impl Outcome {
    /// An outcome without content that reached its end.
    pub fn new(kind: impl Into<String>, name: impl Into<String>) -> Self {
        Outcome {
            kind: kind.into(),
            name: name.into(),
            end: End::Reached,
            parameter: None,
            findings: Vec::new(),
            tables: Vec::new(),
            figures: Vec::new(),
            animations: Vec::new(),
            special_points: Vec::new(),
            work: BTreeMap::new(),
            kept: Kept::default(),
        }
    }

    /// Names the quantity the study moves along.
    pub fn over(mut self, name: impl Into<String>, unit: impl Into<String>) -> Self {
        self.parameter = Some(Parameter { name: name.into(), unit: unit.into() });
        self
    }

    /// Sets how the study ended.
    pub fn end(mut self, end: End) -> Self {
        self.end = end;
        self
    }

    /// Adds a finding.
    pub fn finding(mut self, finding: Finding) -> Self {
        self.findings.push(finding);
        self
    }

    /// Adds a table.
    pub fn table(mut self, table: Table) -> Self {
        self.tables.push(table);
        self
    }

    /// Adds a figure.
    pub fn figure(mut self, figure: Figure) -> Self {
        self.figures.push(figure);
        self
    }
    /// Adds a motion to be played.
    #[must_use]
    pub fn animation(mut self, animation: Animation) -> Self {
        self.animations.push(animation);
        self
    }

    /// Adds a special point.
    pub fn special_point(mut self, point: SpecialPoint) -> Self {
        self.special_points.push(point);
        self
    }

    /// Adds `count` to the work counter `name`.
    pub fn work(mut self, name: impl Into<String>, count: u64) -> Self {
        *self.work.entry(name.into()).or_insert(0) += count;
        self
    }

    /// The table of that name.
    pub fn find_table(&self, name: &str) -> Option<&Table> {
        self.tables.iter().find(|t| t.name() == name)
    }

    /// The outcome itself when its names are unique, every mark of every figure names columns that exist and have a fitting type, and no
    /// NaN or infinity is passed off as a number: values, evidence and places are finite, and in tables NaN alone stands for "no value". Figures
    /// without anything to see are left out.
    ///
    /// # Errors
    /// The first name that is double, missing or of the wrong type, or number that is none.
    pub fn checked(mut self) -> Result<Self, OutcomeError> {
        self.finite()?;
        unique("table", self.tables.iter().map(Table::name))?;
        unique("figure", self.figures.iter().map(|f| f.name.as_str()))?;
        for figure in &self.figures {
            figure.check(&self.tables)?;
        }
        self.animations.iter().try_for_each(|a| a.check(&self.tables))?;
        self.figures.retain(|figure| figure.shows(&self.tables));
        Ok(self)
    }

    fn finite(&self) -> Result<(), OutcomeError> {
        let check = |what: &dyn Argument, numbers: &[f64]| match numbers.iter().all(|x| x.is_finite()) {
            true => Ok(()),
            false => Err(OutcomeError::NotFinite { what: what.argument() }),
        };
        if let End::StepTooSmall { at } | End::NewtonFailed { at, .. } | End::Unbounded { at } = self.end {
            check(&text!("the end"), &[at])?;
        }
        for f in &self.findings {
            f.message.quantities(&mut |q| check(&f.id, &[q.value]))?;
            f.evidence.iter().try_for_each(|e| check(&e.what.to_string(), &[e.value]))?;
        }
        for p in &self.special_points {
            check(&p.kind, &[p.at, p.bracket.0, p.bracket.1])?;
            p.evidence.iter().try_for_each(|e| check(&e.what.to_string(), &[e.value]))?;
        }
        for (t, c) in self.tables.iter().flat_map(|t| t.columns().iter().map(move |c| (t, c))) {
            if let Data::Float(values) = &c.data
                && values.iter().any(|x| x.is_infinite())
            {
                return Err(OutcomeError::NotFinite {
                    what: text!("{name} in the table {table}", name = c.name, table = t.name()).argument(),
                });
            }
        }
        Ok(())
    }

    /// The end of the study, with the place where it stopped.
    pub fn end_message(&self) -> Message {
        let place = |at: f64| match &self.parameter {
            Some(p) => {
                let name = Arg::term(p.name.replace('_', " "));
                Message::new("end-place").arg("parameter", name).arg("at", Arg::quantity(at, &p.unit).digits(4)).into()
            }
            None => Arg::number(at).digits(5),
        };
        let stopped = |key: &str, at: f64| Message::new(key).arg("place", place(at));
        match self.end {
            End::Reached => "end-reached".into(),
            End::StepTooSmall { at } => stopped("end-step-too-small", at),
            End::NewtonFailed { at, residual } if residual.is_finite() => {
                stopped("end-no-solution", at).arg("residual", Arg::number(residual).digits(2))
            }
            End::NewtonFailed { at, .. } => stopped("end-no-values", at),
            End::Unbounded { at } => stopped("end-unbounded", at),
            End::Cancelled => "end-cancelled".into(),
            End::Refused => "end-refused".into(),
            End::MaxPoints => "end-max-points".into(),
            End::WorkLimit => "end-work-limit".into(),
        }
    }
}

fn unique<'a>(what: &'static str, names: impl Iterator<Item = &'a str>) -> Result<(), OutcomeError> {
    let mut seen = std::collections::BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(OutcomeError::Twice { what, name: name.into() });
        }
    }
    Ok(())
}

/// How a study ended. Everything but [`End::Reached`] leaves results that are right as far as they go.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum End {
    /// The end requested.
    Reached,
    /// Continuation could not go on: its step fell below the smallest allowed.
    StepTooSmall {
        /// Value of the parameter there.
        at: f64,
    },
    /// Newton's method did not converge.
    NewtonFailed {
        /// Value of the parameter there.
        at: f64,
        /// Norm of the residual that remained.
        residual: f64,
    },
    /// The motion went beyond every displacement that makes sense for the machine.
    Unbounded {
        /// Value of the parameter there.
        at: f64,
    },
    /// Stopped by the user.
    Cancelled,
    /// The machine cannot answer what was requested; a finding says why.
    Refused,
    /// The largest number of points was computed before the end was reached.
    MaxPoints,
    /// The steps allowed for the run (`--work-limit`) were used up before the end was reached.
    WorkLimit,
}

impl End {
    /// The machine-readable word: `reached`, `step_too_small`, `newton_failed`, `unbounded`, `cancelled`, `refused`,
    /// `max_points`, `work_limit`.
    pub fn word(&self) -> &'static str {
        match self {
            End::Reached => "reached",
            End::StepTooSmall { .. } => "step_too_small",
            End::NewtonFailed { .. } => "newton_failed",
            End::Unbounded { .. } => "unbounded",
            End::Cancelled => "cancelled",
            End::Refused => "refused",
            End::MaxPoints => "max_points",
            End::WorkLimit => "work_limit",
        }
    }

    /// Whether the study did all that was requested.
    pub fn is_complete(&self) -> bool {
        matches!(self, End::Reached)
    }
}

/// A fold, bifurcation, crossing or resonance on the study's path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpecialPoint {
    /// Stable machine name: `fold`, `neimark_sacker`, `critical_speed`.
    pub kind: String,
    /// What it belongs to among others of its kind: a body; empty when the kind says it.
    pub subject: String,
    /// Value of the study's parameter.
    pub at: f64,
    /// Interval of the parameter that holds the point.
    pub bracket: (f64, f64),
    /// How sure it is.
    pub status: Status,
    /// Numbers that support it: residual, multiplier, frequency.
    pub evidence: Vec<Evidence>,
}

impl SpecialPoint {
    /// A located point.
    pub fn new(kind: impl Into<String>, at: f64, bracket: (f64, f64)) -> Self {
        let bracket = if bracket.0 > bracket.1 { (bracket.1, bracket.0) } else { bracket };
        SpecialPoint { kind: kind.into(), subject: String::new(), at, bracket, status: Status::Located, evidence: Vec::new() }
    }

    /// Says what it belongs to, so that it is found again in the outcome of another machine: `of("drum")`.
    pub fn of(mut self, subject: impl Into<String>) -> Self {
        self.subject = subject.into();
        self
    }

    /// Sets the status.
    pub fn status(mut self, status: Status) -> Self {
        self.status = status;
        self
    }

    /// Adds a supporting number; NaN, a number that could not be had, is left out.
    pub fn evidence(mut self, what: impl Into<Arg>, value: f64, unit: impl Into<String>) -> Self {
        self.evidence.extend(Evidence::known(what, value, unit));
        self
    }
}

/// How sure a special point is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// Its own equations were solved.
    Located,
    /// The test function changes sign in the bracket; the point itself was not solved for.
    Bracketed,
    /// Something speaks against it; the reason says what.
    Doubtful(String),
}

impl Status {
    /// The machine-readable word: `located`, `bracketed`, `doubtful`.
    pub fn word(&self) -> &'static str {
        match self {
            Status::Located => "located",
            Status::Bracketed => "bracketed",
            Status::Doubtful(_) => "doubtful",
        }
    }
}

/// An outcome that contradicts itself: a mistake of the study's author, reported instead of drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OutcomeError {
    /// A column is longer or shorter than the columns before it.
    Length {
        /// Table.
        table: String,
        /// Column.
        column: String,
        /// Its length.
        found: usize,
        /// Length of the first column.
        expected: usize,
    },
    /// A name is used twice.
    Twice {
        /// What kind of thing: table, column, figure.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A number left the range of floating point.
    NotFinite {
        /// What it would have been.
        what: text::Arg,
    },
    /// A figure names a table or column that does not exist, or one of a type that it cannot use.
    Reference {
        /// Figure.
        figure: String,
        /// Table.
        table: String,
        /// Column; empty when the table itself is missing.
        column: String,
        /// What was expected.
        expected: &'static str,
    },
}

impl Argument for OutcomeError {
    fn argument(&self) -> text::Arg {
        let said = match self {
            OutcomeError::Length { table, column, found, expected } => text!(
                "column `{column}` of table `{table}` has {found} rows, the columns before it have {expected}",
                column,
                table,
                found,
                expected
            ),
            OutcomeError::NotFinite { what } => text!("{what} is no finite number", what),
            OutcomeError::Twice { what, name } => text!("two {what}s are named `{name}`", what = text::term(what), name),
            OutcomeError::Reference { figure, table, column, expected } if column.is_empty() => {
                text!("figure `{figure}` needs {expected} `{table}`, which is missing", figure, expected = text::term(expected), table)
            }
            OutcomeError::Reference { figure, table, column, expected } => {
                text!(
                    "figure `{figure}` needs {expected} `{column}` in table `{table}`",
                    figure,
                    expected = text::term(expected),
                    column,
                    table
                )
            }
        };
        said.argument()
    }
}

impl fmt::Display for OutcomeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.argument().fmt(f)
    }
}

impl std::error::Error for OutcomeError {}

impl From<OutcomeError> for Diagnostic {
    fn from(e: OutcomeError) -> Self {
        match e {
            OutcomeError::NotFinite { .. } => Diagnostic::error("study.not_finite", text!("the result cannot be computed: {e}", e))
                .help(text!("a value of the machine or of the study is too large or too small")),
            _ => Diagnostic::error("study.outcome", text!("the study's result is inconsistent: {e}", e)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn end_names_its_place() {
        let o = Outcome::new("k", "n").over("speed", "rad/s").end(End::StepTooSmall { at: 123.456 });
        assert_eq!(o.end_in_words(), "The study stopped early: the step became too small at speed = 123.5 rad/s.");
        let o = o.end(End::NewtonFailed { at: 123.456, residual: f64::NAN });
        assert!(!o.end_in_words().contains("not a number"), "{}", o.end_in_words());
    }

    #[test]
    fn figure_must_name_existing_columns_of_the_right_type() {
        let table = || Table::new("t", "").float("x", "m", "", vec![1.0]).text("s", "", vec!["a".into()]).build().unwrap();
        let with = |mark: Mark| {
            Outcome::new("k", "n")
                .table(table())
                .figure(Figure::new("f", "", "").panel(Panel::new(Axis::new("y", "")).mark(mark)))
                .checked()
        };
        assert!(with(Line::new("t", "x", "x").into()).is_ok());
        for bad in [Line::new("u", "x", "x"), Line::new("t", "x", "z"), Line::new("t", "x", "s"), Line::new("t", "x", "x").solid_where("x")]
        {
            assert!(matches!(with(bad.into()), Err(OutcomeError::Reference { .. })));
        }
    }

    #[test]
    fn double_names_are_reported() {
        let t = || Table::new("t", "").build().unwrap();
        assert!(matches!(Outcome::new("k", "n").table(t()).table(t()).checked(), Err(OutcomeError::Twice { .. })));
    }
}
