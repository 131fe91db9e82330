//! What a finding says, as data: the name of a sentence in the catalogues and the values it names, in SI units.

use super::stored::{self, Fixed};
use crate::text::Text;
use serde::{Deserialize, Serialize};

/// A sentence of the catalogues (`crates/laval/text`) and its arguments.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Message {
    /// Name in the catalogue: `modes-stable`.
    pub key: String,
    /// Arguments, by the names that the sentence uses.
    #[serde(with = "stored::args")]
    pub args: Vec<(&'static str, Arg)>,
}

impl Message {
    /// A sentence or phrase without arguments yet.
    pub fn new(key: impl Into<String>) -> Self {
        Message { key: key.into(), args: Vec::new() }
    }

    /// Adds an argument.
    #[must_use]
    pub fn arg(mut self, name: &'static str, value: impl Into<Arg>) -> Self {
        self.args.push((name, value.into()));
        self
    }

    /// The argument of this name.
    pub fn arg_named(&self, name: &str) -> Option<&Arg> {
        self.args.iter().find(|a| a.0 == name).map(|a| &a.1)
    }

    /// One of the arguments is this fixed phrase.
    pub(crate) fn mentions(&self, term: &str) -> bool {
        self.key.contains(term) || self.args.iter().any(|a| matches!(&a.1, Arg::Term(t) if t == term))
    }

    /// Calls `each` with every number of the arguments and of the phrases among them.
    pub(super) fn quantities<E>(&self, each: &mut dyn FnMut(&Quantity) -> Result<(), E>) -> Result<(), E> {
        self.args.iter().try_for_each(|a| a.1.quantities(each))
    }
}

/// A value that a sentence names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Arg {
    /// A number with its SI unit. The report chooses unit and digits.
    Quantity(Quantity),
    /// A count: chooses plural forms.
    Count(u64),
    /// A name from the machine file; never translated.
    Name(String),
    /// A word that a sentence chooses by: `forward`, `up`.
    #[serde(with = "stored::word")]
    Word(Fixed),
    /// A fixed phrase of a part, in English, such as a statement of its validity; the catalogues may have it in other languages.
    Term(String),
    /// A sentence of a diagnostic.
    #[serde(with = "stored::said")]
    Said(Text),
    /// A phrase of the catalogues.
    Phrase(Message),
    /// Several, joined by commas.
    List(Vec<Arg>),
}

/// A number with its SI unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// In SI units.
    pub value: f64,
    /// SI unit; empty for a pure number.
    pub unit: String,
    /// What it measures, where the unit leaves that open.
    pub role: Role,
    /// Significant digits; `None` where the report decides.
    pub digits: Option<u8>,
}

/// What a quantity measures, where its unit leaves that open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Role {
    /// The unit says it; rad/s is a spin speed.
    #[default]
    Plain,
    /// A frequency of whirl or vibration, rad/s.
    Frequency,
    /// A share or ratio, read as a percentage.
    Percent,
}

impl Arg {
    /// A number with its SI unit.
    pub fn quantity(value: f64, unit: &str) -> Arg {
        Arg::Quantity(Quantity { value, unit: unit.into(), role: Role::Plain, digits: None })
    }

    /// A spin speed, rad/s.
    pub fn speed(value: f64) -> Arg {
        Arg::quantity(value, "rad/s")
    }

    /// A frequency of whirl or vibration, rad/s.
    pub fn frequency(value: f64) -> Arg {
        Arg::role(value, "rad/s", Role::Frequency)
    }

    /// A pure number.
    pub fn number(value: f64) -> Arg {
        Arg::quantity(value, "")
    }

    /// A share, read as a percentage: `0.25` is 25 %.
    pub fn percent(value: f64) -> Arg {
        Arg::role(value, "", Role::Percent)
    }

    fn role(value: f64, unit: &str, role: Role) -> Arg {
        Arg::Quantity(Quantity { value, unit: unit.into(), role, digits: None })
    }

    /// The same to this many significant digits.
    #[must_use]
    pub fn digits(self, digits: u8) -> Arg {
        match self {
            Arg::Quantity(q) => Arg::Quantity(Quantity { digits: Some(digits), ..q }),
            other => other,
        }
    }

    /// A count: chooses plural forms.
    pub fn count(n: usize) -> Arg {
        Arg::Count(n as u64)
    }

    /// A name from the machine file.
    pub fn name(name: impl Into<String>) -> Arg {
        Arg::Name(name.into())
    }

    /// A fixed phrase of a part.
    pub fn term(text: impl Into<String>) -> Arg {
        Arg::Term(text.into())
    }

    /// What belongs to a body or part: `largest tilt of drum`.
    pub fn of(what: impl Into<Arg>, owner: impl Into<Arg>) -> Arg {
        Message::new("label-of").arg("what", what).arg("owner", owner).into()
    }

    /// What something is, and a reservation about it.
    pub fn noted(what: impl Into<Arg>, note: impl Into<Arg>) -> Arg {
        Message::new("label-noted").arg("what", what).arg("note", note).into()
    }

    /// A word that a sentence chooses by.
    pub fn word(word: &'static str) -> Arg {
        Arg::Word(word)
    }

    fn quantities<E>(&self, each: &mut dyn FnMut(&Quantity) -> Result<(), E>) -> Result<(), E> {
        match self {
            Arg::Quantity(q) => each(q),
            Arg::Phrase(m) => m.quantities(each),
            Arg::List(all) => all.iter().try_for_each(|a| a.quantities(each)),
            Arg::Count(_) | Arg::Name(_) | Arg::Word(_) | Arg::Term(_) | Arg::Said(_) => Ok(()),
        }
    }

    /// Names, joined by commas.
    pub fn names<S: Into<String>>(names: impl IntoIterator<Item = S>) -> Arg {
        Arg::List(names.into_iter().map(Arg::name).collect())
    }
}

impl Default for Arg {
    /// No words.
    fn default() -> Arg {
        Arg::Term(String::new())
    }
}

/// A fixed phrase.
impl From<&'static str> for Arg {
    fn from(text: &'static str) -> Arg {
        Arg::term(text)
    }
}

impl From<Text> for Arg {
    fn from(text: Text) -> Arg {
        Arg::Said(text)
    }
}

/// A sentence without arguments.
impl From<&'static str> for Message {
    fn from(key: &'static str) -> Message {
        Message::new(key)
    }
}

impl From<Message> for Arg {
    fn from(message: Message) -> Arg {
        Arg::Phrase(message)
    }
}

impl From<usize> for Arg {
    fn from(n: usize) -> Arg {
        Arg::count(n)
    }
}
