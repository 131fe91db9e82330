//! Findings: one fact each, with its numbers and what supports them.

use super::message::{Arg, Message};
use serde::{Deserialize, Serialize};

/// One fact a reader takes away, as data: which sentence of the catalogues says it, with which values. The report chooses words, units and digits.
///
/// ```
/// use laval::outcome::{Arg, Finding};
/// let f = Finding::warning("close", "critical-speeds-margin")
///     .of("forward, order 1")
///     .value(0.05, "")
///     .arg("critical", Arg::speed(300.0))
///     .arg("operating", Arg::speed(314.159))
///     .evidence("bracket width", 2e-9, "rad/s");
/// assert_eq!(f.number("operating"), Some(314.159));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Stable machine name, such as `first_critical_speed`.
    pub id: String,
    /// What it speaks of among others of the same id: a body, a whirl direction, an order; empty when the id says it.
    pub subject: String,
    /// The sentence of the catalogues that says it, with its arguments.
    pub message: Message,
    /// Sentences behind it: a reservation that was added later.
    pub notes: Vec<Message>,
    /// The number that stands for it where one number is wanted, in SI units; the argument `value` of the sentence.
    pub value: Option<f64>,
    /// SI unit of the number.
    pub unit: String,
    /// What supports it.
    pub evidence: Vec<Evidence>,
    /// How the reader should take it.
    pub level: Level,
}

/// How a finding is to be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Evidence {
    /// What the number is.
    pub what: Arg,
    /// The number.
    pub value: f64,
    /// Its unit; empty for a pure number.
    pub unit: String,
}

impl Evidence {
    /// A supporting number.
    pub fn new(what: impl Into<Arg>, value: f64, unit: impl Into<String>) -> Self {
        Evidence { what: what.into(), value, unit: unit.into() }
    }

    /// `None` for NaN.
    pub(super) fn known(what: impl Into<Arg>, value: f64, unit: impl Into<String>) -> Option<Self> {
        (!value.is_nan()).then(|| Self::new(what, value, unit))
    }
}

impl Finding {
    fn new(level: Level, id: impl Into<String>, message: impl Into<String>) -> Self {
        Finding {
            id: id.into(),
            subject: String::new(),
            message: Message::new(message),
            notes: Vec::new(),
            value: None,
            unit: String::new(),
            evidence: Vec::new(),
            level,
        }
    }

    /// A result.
    pub fn info(id: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Level::Info, id, message)
    }

    /// A result that requires attention.
    pub fn warning(id: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Level::Warning, id, message)
    }

    /// A result outside the validity of its model.
    pub fn invalid(id: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Level::Invalid, id, message)
    }

    /// Says what it speaks of, so that it is found again in the outcome of another machine: `of("drum")`.
    pub fn of(mut self, subject: impl Into<String>) -> Self {
        self.subject = subject.into();
        self
    }

    /// The number and its SI unit (empty for a pure number): the argument `value` of the sentence.
    pub fn value(self, value: f64, unit: impl Into<String>) -> Self {
        let unit = unit.into();
        self.value_as(Arg::quantity(value, &unit))
    }

    /// The number as a quantity that says how it is read: `Arg::frequency(w)`, `Arg::percent(x)`.
    pub fn value_as(mut self, quantity: Arg) -> Self {
        if let Arg::Quantity(q) = &quantity {
            self.value = Some(q.value);
            self.unit = q.unit.clone();
        }
        self.message = self.message.arg("value", quantity);
        self
    }

    /// Adds an argument of the sentence.
    pub fn arg(mut self, name: &'static str, value: impl Into<Arg>) -> Self {
        self.message = self.message.arg(name, value);
        self
    }

    /// The number of that argument, in SI units.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.message.args.iter().find(|a| a.0 == name).and_then(|a| match &a.1 {
            Arg::Quantity(q) => Some(q.value),
            Arg::Count(n) => Some(*n as f64),
            _ => None,
        })
    }

    /// Adds a supporting number; NaN, a number that could not be had, is left out.
    pub fn evidence(mut self, what: impl Into<Arg>, value: f64, unit: impl Into<String>) -> Self {
        self.evidence.extend(Evidence::known(what, value, unit));
        self
    }
}
