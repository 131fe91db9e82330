//! Findings: one sentence each, with the number and what supports it.

use super::number::quantity;

/// One sentence a reader takes away, with its number in machine-readable form.
///
/// `{}` in the text stands for the value with its unit, so that the sentence and the number cannot disagree.
///
/// ```
/// use laval::outcome::Finding;
/// let f = Finding::warning("critical_speed_close", "A critical speed, {}, lies close to the operating speed.")
///     .value(314.159, "rad/s")
///     .shown_as(3000.0, "rpm")
///     .evidence("bracket width", 2e-9, "rad/s");
/// assert_eq!(f.sentence(), "A critical speed, 3000 rpm, lies close to the operating speed.");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Stable machine name, such as `first_critical_speed`.
    pub id: String,
    /// What it speaks of among others of the same id: a body, a whirl direction, an order; empty when the id says it.
    pub subject: String,
    /// The sentence; `{}` stands for the value.
    pub text: String,
    /// The number, in SI units.
    pub value: Option<f64>,
    /// Unit of the number.
    pub unit: String,
    /// Number and unit to show in the sentence instead of `value`.
    pub shown: Option<(f64, String)>,
    /// What supports it.
    pub evidence: Vec<Evidence>,
    /// How the reader should take it.
    pub level: Level,
}

/// How a finding is to be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// A result.
    Info,
    /// A result that requires attention.
    Warning,
    /// A result outside the validity of its model.
    Invalid,
}

impl Level {
    /// The machine-readable word: `info`, `warning`, `invalid`.
    pub fn word(&self) -> &'static str {
        match self {
            Level::Info => "info",
            Level::Warning => "warning",
            Level::Invalid => "invalid",
        }
    }
}

/// A number that supports a finding: residual, bracket width, difference from a second method.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// What the number is.
    pub what: String,
    /// The number.
    pub value: f64,
    /// Its unit; empty for a pure number.
    pub unit: String,
}

impl Evidence {
    /// A supporting number.
    pub fn new(what: impl Into<String>, value: f64, unit: impl Into<String>) -> Self {
        Evidence { what: what.into(), value, unit: unit.into() }
    }

    /// `None` for NaN.
    pub(super) fn known(what: impl Into<String>, value: f64, unit: impl Into<String>) -> Option<Self> {
        (!value.is_nan()).then(|| Self::new(what, value, unit))
    }
}

impl Finding {
    fn new(level: Level, id: impl Into<String>, text: impl Into<String>) -> Self {
        Finding {
            id: id.into(),
            subject: String::new(),
            text: text.into(),
            value: None,
            unit: String::new(),
            shown: None,
            evidence: Vec::new(),
            level,
        }
    }

    /// A result.
    pub fn info(id: impl Into<String>, text: impl Into<String>) -> Self {
        Self::new(Level::Info, id, text)
    }

    /// A result that requires attention.
    pub fn warning(id: impl Into<String>, text: impl Into<String>) -> Self {
        Self::new(Level::Warning, id, text)
    }

    /// A result outside the validity of its model.
    pub fn invalid(id: impl Into<String>, text: impl Into<String>) -> Self {
        Self::new(Level::Invalid, id, text)
    }

    /// Says what it speaks of, so that it is found again in the outcome of another machine: `of("drum")`.
    pub fn of(mut self, subject: impl Into<String>) -> Self {
        self.subject = subject.into();
        self
    }

    /// The number and its unit (SI; empty unit for a pure number).
    pub fn value(mut self, value: f64, unit: impl Into<String>) -> Self {
        self.value = Some(value);
        self.unit = unit.into();
        self
    }

    /// Shows the number in another unit in the sentence: `value(314.16, "rad/s").shown_as(3000.0, "rpm")`.
    pub fn shown_as(mut self, value: f64, unit: impl Into<String>) -> Self {
        self.shown = Some((value, unit.into()));
        self
    }

    /// Adds a supporting number; NaN, a number that could not be had, is left out.
    pub fn evidence(mut self, what: impl Into<String>, value: f64, unit: impl Into<String>) -> Self {
        self.evidence.extend(Evidence::known(what, value, unit));
        self
    }

    /// The sentence with its number filled in.
    pub fn sentence(&self) -> String {
        let number = match (&self.shown, self.value) {
            (Some((v, unit)), _) => quantity(*v, unit),
            (None, Some(v)) => quantity(v, &self.unit),
            (None, None) => return self.text.clone(),
        };
        self.text.replacen("{}", &number, 1)
    }
}
