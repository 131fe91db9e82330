//! Sentences of diagnostics in the languages of the catalogues, looked up by their English templates.

use super::Language;
use crate::plain;
use crate::text::{Arg, Joint, Text, capital, fill, id};
use crate::units::{DIGITS, read_in};
use fluent_bundle::{FluentArgs, FluentValue};

/// Number and unit of a value in its SI unit, as a reader has them, with so many digits or as many as the reader is used to.
pub type Shown<'a> = &'a dyn Fn(f64, &str, Option<u8>) -> (String, String);

impl Language {
    /// A sentence of a diagnostic, with values in everyday units; in English where the language does not have it.
    pub fn said(self, text: &Text) -> String {
        self.said_in(text, &[] as &[&str])
    }

    /// The same with values in the first of these units that measures them, such as those of the file.
    pub fn said_in(self, text: &Text, units: &[impl AsRef<str>]) -> String {
        self.said_with(text, &|x, unit, digits| read_in(units, x, unit, digits.unwrap_or(DIGITS)))
    }

    /// The same with values as `shown` has them.
    pub fn said_with(self, text: &Text, shown: Shown) -> String {
        let template = text.template();
        let key = id(template);
        if self == Language::English || !has_words(template) {
            let value = |name: &str| text.args().iter().find(|a| a.0 == name).map_or_else(String::new, |a| self.argument(&a.1, shown));
            return fill(template, value);
        }
        if !self.own(&key) {
            return Language::English.said_with(text, shown);
        }
        let mut args = FluentArgs::new();
        for (name, value) in text.args() {
            args.set(
                *name,
                match value {
                    Arg::Count(n) => FluentValue::from(*n),
                    other => FluentValue::from(plain::line(&self.argument(other, shown)).into_owned()),
                },
            );
        }
        self.format(&key, &args)
    }

    fn argument(self, arg: &Arg, shown: Shown) -> String {
        match arg {
            Arg::Plain(text) => text.clone(),
            Arg::Number(number) => self.number(number),
            Arg::Quantity(q) => {
                let (number, unit) = shown(q.value, &q.unit, q.digits);
                let number = if q.value.is_finite() { self.number(&number) } else { number };
                if unit.is_empty() { number } else { format!("{number} {}", self.unit(&unit)) }
            }
            Arg::Count(n) => n.to_string(),
            Arg::Term(text) => self.term(text),
            Arg::Text(text) => self.said_with(text, shown),
            Arg::Capital(text) => capital(&self.said_with(text, shown)),
            Arg::List(all, joint) => self.joined(all.iter().map(|a| self.argument(a, shown)).collect(), *joint),
        }
    }

    fn joined(self, entries: Vec<String>, joint: Joint) -> String {
        let pair = |key: &str, rest: String, last: String| {
            let mut args = FluentArgs::new();
            args.set("rest", FluentValue::from(rest));
            args.set("last", FluentValue::from(last));
            self.format(key, &args)
        };
        let key = match joint {
            Joint::Comma => return entries.join(", "),
            Joint::Semicolon => return entries.join("; "),
            Joint::And | Joint::Ands => "list-and",
            Joint::Or | Joint::Ors => "list-or",
        };
        if matches!(joint, Joint::Ands | Joint::Ors) {
            return entries.into_iter().reduce(|rest, last| pair(key, rest, last)).unwrap_or_default();
        }
        match entries.split_last() {
            Some((last, rest)) if !rest.is_empty() => pair(key, rest.join(", "), last.clone()),
            Some((last, _)) => last.clone(),
            None => String::new(),
        }
    }
}

/// There is something to translate: letters outside the places.
pub fn has_words(template: &str) -> bool {
    fill(template, |_| String::new()).chars().any(char::is_alphabetic)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text;

    #[test]
    fn what_has_no_words_of_its_own_holds_translated_phrases() {
        let inner = text::list(["a", "b", "c"], Joint::And);
        let t = text!("{who}: {list}", who = "disc \"drum\"", list = inner);
        assert_eq!(Language::Russian.said(&t), "disc \"drum\": a, b и c");
        assert_eq!(Language::Uzbek.said(&text!("{list}", list = text::list(["a", "b", "c"], Joint::Ands))), "a va b va c");
        assert_eq!(Language::English.said(&t), "disc \"drum\": a, b and c");
        assert!(!has_words("{{ {x} }}: ({y})") && has_words("no {x}"));
    }

    #[test]
    fn values_are_those_of_the_reader() {
        let t = text!("{x}: {share}", x = text::quantity(0.0508, "m"), share = 2.5);
        assert_eq!(Language::English.said_in(&t, &["rpm", "in"]), "2 in: 2.5");
        assert_eq!(Language::Russian.said(&t), "50,8 мм: 2,5");
        assert_eq!(Language::Kazakh.said_with(&t, &|_, _, _| ("0.0508".into(), "m".into())), "0,0508 м: 2,5");
        // what stands in quotation marks is written into the file, with a decimal point
        assert_eq!(Language::Uzbek.said(&text!("{x}", x = text::quoted("1.5 mm"))), "\"1.5 mm\"");
        assert_eq!(Language::English.said(&text!("{w}", w = text::quantity(314.159_265, "rad/s"))), "3000 rpm");
    }

    #[test]
    fn what_a_language_lacks_is_said_in_english() {
        let inner = text!("no catalogue has this of {x}", x = 3usize);
        assert_eq!(Language::Kazakh.said(&text!("{who}: {inner}", who = "x", inner)), "x: no catalogue has this of 3");
    }
}
