//! Outcomes as bytes and back: texts that live as long as the program come back as such.

use super::message::Arg;
use crate::text::{self, Joint, Text};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// A text of the program. (Under a name, for of a plain `&str` the bytes would have to live as long.)
pub type Fixed = &'static str;

/// One text of the program for each content.
fn fixed(content: String) -> Fixed {
    static KNOWN: Mutex<BTreeSet<Fixed>> = Mutex::new(BTreeSet::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = known.get(content.as_str()) {
        return found;
    }
    let new: Fixed = content.leak();
    known.insert(new);
    new
}

/// A text of the program.
pub mod word {
    use super::*;

    pub fn serialize<S: Serializer>(word: &Fixed, to: S) -> Result<S::Ok, S::Error> {
        word.serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Fixed, D::Error> {
        String::deserialize(from).map(fixed)
    }
}

/// A list of them.
pub mod words {
    use super::*;

    pub fn serialize<S: Serializer>(words: &&'static [Fixed], to: S) -> Result<S::Ok, S::Error> {
        words.serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<&'static [Fixed], D::Error> {
        static KNOWN: Mutex<BTreeSet<&'static [Fixed]>> = Mutex::new(BTreeSet::new());
        let list: Vec<Fixed> = Vec::<String>::deserialize(from)?.into_iter().map(fixed).collect();
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.get(list.as_slice()) {
            return Ok(found);
        }
        let new: &'static [Fixed] = list.leak();
        known.insert(new);
        Ok(new)
    }
}

/// Arguments with their names.
pub mod args {
    use super::*;

    pub fn serialize<S: Serializer>(args: &[(Fixed, Arg)], to: S) -> Result<S::Ok, S::Error> {
        args.serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<(Fixed, Arg)>, D::Error> {
        let list = Vec::<(String, Arg)>::deserialize(from)?;
        Ok(list.into_iter().map(|(name, arg)| (fixed(name), arg)).collect())
    }
}

/// A sentence of a diagnostic.
pub mod said {
    use super::*;

    pub fn serialize<S: Serializer>(text: &Text, to: S) -> Result<S::Ok, S::Error> {
        Said::from(text).serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Text, D::Error> {
        Said::deserialize(from).map(Text::from)
    }
}

#[derive(Serialize, Deserialize)]
struct Said {
    template: String,
    args: Vec<(String, Word)>,
}

#[derive(Serialize, Deserialize)]
enum Word {
    Plain(String),
    Number(String),
    /// The bits of the value, so that NaN comes back too, unit and digits.
    Quantity(u64, String, Option<u8>),
    Count(u64),
    Term(String),
    Text(Said),
    Capital(Said),
    List(Vec<Word>, Between),
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(remote = "Joint")]
enum JointDef {
    Comma,
    Semicolon,
    And,
    Ands,
    Or,
    Ors,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
struct Between(#[serde(with = "JointDef")] Joint);

impl From<&Text> for Said {
    fn from(text: &Text) -> Said {
        Said { template: text.template().into(), args: text.args().iter().map(|(name, arg)| (name.to_string(), arg.into())).collect() }
    }
}

impl From<Said> for Text {
    fn from(said: Said) -> Text {
        let args = said.args.into_iter().map(|(name, word)| (fixed(name), word.into()));
        Text::of_template(fixed(said.template), args.collect())
    }
}

impl From<&text::Arg> for Word {
    fn from(arg: &text::Arg) -> Word {
        match arg {
            text::Arg::Plain(s) => Word::Plain(s.clone()),
            text::Arg::Number(s) => Word::Number(s.clone()),
            text::Arg::Quantity(q) => Word::Quantity(q.value.to_bits(), q.unit.to_string(), q.digits),
            text::Arg::Count(n) => Word::Count(*n),
            text::Arg::Term(s) => Word::Term(s.to_string()),
            text::Arg::Text(t) => Word::Text(t.into()),
            text::Arg::Capital(t) => Word::Capital(t.into()),
            text::Arg::List(all, joint) => Word::List(all.iter().map(Word::from).collect(), Between(*joint)),
        }
    }
}

impl From<Word> for text::Arg {
    fn from(word: Word) -> text::Arg {
        match word {
            Word::Plain(s) => text::Arg::Plain(s),
            Word::Number(s) => text::Arg::Number(s),
            Word::Quantity(bits, unit, digits) => {
                text::Arg::Quantity(text::Value { value: f64::from_bits(bits), unit: unit.into(), digits })
            }
            Word::Count(n) => text::Arg::Count(n),
            Word::Term(s) => text::Arg::Term(fixed(s)),
            Word::Text(t) => text::Arg::Text(t.into()),
            Word::Capital(t) => text::Arg::Capital(t.into()),
            Word::List(all, joint) => text::Arg::List(all.into_iter().map(text::Arg::from).collect(), joint.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Axis, Figure, Finding, Line, Outcome, Panel, Table};
    use crate::text;

    #[test]
    fn an_outcome_comes_back_whole() {
        let said = text!("{path} is damaged", path = text::list(&[text!("no part {n}", n = 3usize), text!("none")], Joint::Or));
        let reason = Finding::warning("refused", "run-refused").arg("reason", Arg::Said(said)).value(f64::NEG_INFINITY, "m");
        let table = Table::new("t", "doc").float("x", "m", "", vec![0.1, -0.0, 1e300]).flag("f", "", vec![true, false, true]);
        let table =
            table.text("s", "", vec!["a".into(), String::new(), "ü".into()]).int("n", "", "", vec![1, -2, i64::MAX]).build().unwrap();
        let line = Line::new("t", "x", "x").classes("s", &["one", "two"]).muted(&["two"]);
        let figure = Figure::new("f", "title", "alt").panel(Panel::new(Axis::new("x", "m")).mark(line));
        let outcome = Outcome::new("k", "n").over("speed", "rad/s").finding(reason).table(table).figure(figure).work("steps", 7);
        let bytes = postcard::to_stdvec(&outcome).unwrap();
        let back: Outcome = postcard::from_bytes(&bytes).unwrap();
        assert_eq!(back, outcome);
        assert_eq!(postcard::to_stdvec(&back).unwrap(), bytes);
        assert_eq!(back.findings[0].sentence(), outcome.findings[0].sentence());
        // texts of the program are held once
        let again: Outcome = postcard::from_bytes(&bytes).unwrap();
        let name = |o: &Outcome| o.findings[0].message.args[0].0.as_ptr();
        assert_eq!(name(&again), name(&back));
        assert!(postcard::from_bytes::<Outcome>(&bytes[..bytes.len() - 1]).is_err());
    }
}
