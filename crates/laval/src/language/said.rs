//! Sentences of diagnostics in the languages of the catalogues, looked up by their English templates.

use super::Language;
use crate::plain;
use crate::text::{Arg, Joint, Text, capital, fill, id};
use fluent_bundle::{FluentArgs, FluentValue};

impl Language {
    /// A sentence of a diagnostic; in English where the language does not have it.
    pub fn said(self, text: &Text) -> String {
        let template = text.template();
        if self == Language::English {
            return text.to_string();
        }
        if !has_words(template) {
            let value = |name: &str| text.args().iter().find(|a| a.0 == name).map_or_else(String::new, |a| self.argument(&a.1));
            return fill(template, value);
        }
        let key = id(template);
        if !self.own(&key) {
            return text.to_string();
        }
        let mut args = FluentArgs::new();
        for (name, value) in text.args() {
            args.set(
                *name,
                match value {
                    Arg::Count(n) => FluentValue::from(*n),
                    other => FluentValue::from(plain::line(&self.argument(other)).into_owned()),
                },
            );
        }
        self.format(&key, &args)
    }

    fn argument(self, arg: &Arg) -> String {
        match arg {
            Arg::Plain(text) => text.clone(),
            Arg::Count(n) => n.to_string(),
            Arg::Term(text) => self.term(text),
            Arg::Text(text) => self.said(text),
            Arg::Capital(text) => capital(&self.said(text)),
            Arg::List(all, joint) => self.joined(all.iter().map(|a| self.argument(a)).collect(), *joint),
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
    fn what_a_language_lacks_is_said_in_english() {
        let inner = text!("no catalogue has this of {x}", x = 3usize);
        assert_eq!(Language::Kazakh.said(&text!("{who}: {inner}", who = "x", inner)), "x: no catalogue has this of 3");
    }
}
