//! Findings in words: sentences of the catalogues with numbers in the units of the reader.

use super::units::Units;
use crate::language::Language;
use crate::outcome::{Arg, Finding, Message, Outcome, Quantity, Role, quantity_to, significant};
use crate::units::read_quantity;
use fluent_bundle::{FluentArgs, FluentValue};
use std::fmt;

/// Language and units of a reader.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Style {
    /// Language of all words.
    pub language: Language,
    /// Units of all numbers.
    pub units: Units,
}

impl Style {
    /// A finding as one or a few sentences.
    pub fn sentence(&self, f: &Finding) -> String {
        let all: Vec<String> = std::iter::once(&f.message).chain(&f.notes).map(|m| self.message(m)).collect();
        all.join(" ")
    }

    /// A sentence or phrase of the catalogues. What no catalogue has is shown by its name.
    pub fn message(&self, m: &Message) -> String {
        if !self.language.has(&m.key) {
            return self.plain(m);
        }
        let mut args = FluentArgs::new();
        for (name, value) in &m.args {
            args.set(*name, self.value(value));
        }
        self.language.format(&m.key, &args)
    }

    /// A text that is no name of a sentence: `{}` stands for the value.
    fn plain(&self, m: &Message) -> String {
        let value = m.args.iter().find_map(|(name, a)| match a {
            Arg::Quantity(q) if *name == "value" => Some(q),
            _ => None,
        });
        match value {
            Some(q) if q.role == Role::Percent => m.key.replacen("{}", &self.quantity(q), 1),
            Some(q) => m.key.replacen("{}", &quantity_to(q.value, &q.unit, 4), 1),
            None => m.key.clone(),
        }
    }

    fn value(&self, arg: &Arg) -> FluentValue<'static> {
        match arg {
            Arg::Count(n) => FluentValue::from(*n),
            other => FluentValue::from(self.arg(other)),
        }
    }

    /// A value in words.
    pub fn arg(&self, arg: &Arg) -> String {
        match arg {
            Arg::Quantity(q) => self.quantity(q),
            Arg::Count(n) => n.to_string(),
            Arg::Name(name) => name.clone(),
            Arg::Word(word) => word.to_string(),
            Arg::Term(text) => self.language.term(text),
            Arg::Phrase(m) => self.message(m),
            Arg::Said(text) => self.language.said_with(text, &|value, unit, digits| {
                self.units.split(&Quantity { value, unit: unit.into(), role: Role::Plain, digits })
            }),
            Arg::List(all) => self.list(all),
        }
    }

    /// A body, point or tilt of a body as tables and results name it, `drum at 100 mm`, in the units and words of the reader.
    pub fn owner(&self, name: &str) -> String {
        if let Some(body) = name.strip_prefix("tilt of ") {
            return self.arg(&Arg::of("tilt", Arg::name(body)));
        }
        let point = name.rsplit_once(" at ").and_then(|(body, height)| {
            let digits = height.chars().filter(char::is_ascii_digit).count().clamp(1, 9) as u8;
            Some((body, read_quantity(height, "m").ok()?, digits))
        });
        match point {
            Some((body, height, digits)) => {
                let height = Arg::quantity(height, "m").digits(digits);
                self.message(&Message::new("label-point").arg("body", Arg::name(body)).arg("height", height))
            }
            None => name.into(),
        }
    }

    /// What a finding or a special point belongs to: the name of a body or part, or a phrase.
    pub fn subject(&self, text: &str) -> String {
        let owner = self.owner(text);
        if owner != text {
            return owner;
        }
        // a name keeps its underscores
        let word = self.word(text);
        if word == text.replace('_', " ") { owner } else { word }
    }

    /// A word of a table: a fixed phrase with blanks for underscores, or several joined by commas, with or without a number before each.
    pub fn word(&self, text: &str) -> String {
        let text = text.replace('_', " ");
        let whole = self.language.term(&text);
        if whole != text || !text.contains(' ') {
            return whole;
        }
        let piece = |p: &str| match p.split_once(' ') {
            Some((n, rest)) if n.bytes().all(|b| b.is_ascii_digit()) => format!("{n} {}", self.language.term(rest)),
            _ => self.language.term(p),
        };
        text.split(", ").map(piece).collect::<Vec<_>>().join(", ")
    }

    fn list(&self, all: &[Arg]) -> String {
        let words: Vec<String> = all.iter().map(|a| self.arg(a)).collect();
        match words.split_last() {
            Some((last, rest)) if !rest.is_empty() => {
                let mut args = FluentArgs::new();
                args.set("rest", FluentValue::from(rest.join(", ")));
                args.set("last", FluentValue::from(last.clone()));
                self.language.format("list-and", &args)
            }
            Some((last, _)) => last.clone(),
            None => String::new(),
        }
    }

    /// A number of an evidence, with its SI unit, in those of the reader.
    pub fn number(&self, value: f64, unit: &str) -> String {
        self.arg(&Arg::quantity(value, unit).digits(4))
    }

    /// A number as it is read, without unit.
    pub(super) fn shown(&self, value: f64, digits: usize) -> String {
        let number = self.language.number(&significant(value, digits));
        if self.units.is_everyday() { grouped(&number) } else { number }
    }

    /// A number with its unit.
    pub fn quantity(&self, q: &Quantity) -> String {
        let (number, unit) = self.units.split(q);
        let number = self.language.number(&number);
        let number = if self.units.is_everyday() { grouped(&number) } else { number };
        match unit.as_str() {
            "" => number,
            "°" => format!("{number}°"),
            unit => format!("{number} {}", self.language.unit(unit)),
        }
    }
}

/// Groups of three digits, apart by a narrow space that does not break, from five digits before the point on.
fn grouped(number: &str) -> String {
    let start = number.find(|c: char| c.is_ascii_digit()).unwrap_or(number.len());
    let digits = number[start..].chars().take_while(char::is_ascii_digit).count();
    if digits < 5 {
        return number.into();
    }
    let mut out = number[..start].to_string();
    for (k, c) in number[start..start + digits].chars().enumerate() {
        if k > 0 && (digits - k).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(c);
    }
    out + &number[start + digits..]
}

impl Finding {
    /// The finding in English, numbers in SI units with prefixes.
    pub fn sentence(&self) -> String {
        Style::default().sentence(self)
    }
}

impl Outcome {
    /// The end of the study as one English sentence, with the place where it stopped.
    pub fn end_in_words(&self) -> String {
        self.end_message().to_string()
    }
}

/// In English, numbers in SI units with prefixes.
impl fmt::Display for Arg {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Style::default().arg(self))
    }
}

/// The English text.
impl PartialEq<str> for Arg {
    fn eq(&self, text: &str) -> bool {
        Style::default().arg(self) == text
    }
}

/// The English text.
impl PartialEq<String> for Arg {
    fn eq(&self, text: &String) -> bool {
        *self == **text
    }
}

/// The English text.
impl PartialEq<&str> for Arg {
    fn eq(&self, text: &&str) -> bool {
        *self == **text
    }
}

/// In English, numbers in SI units with prefixes.
impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Style::default().message(self))
    }
}
