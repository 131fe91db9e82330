//! The catalogues of sentences, `text/LANGUAGE/*.ftl` (Project Fluent), and how each language writes numbers and units.

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use std::collections::BTreeMap;
use std::str::FromStr;
use std::sync::OnceLock;

include!(concat!(env!("OUT_DIR"), "/catalogues.rs"));

/// A language of reports.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Language {
    /// English; has every sentence.
    #[default]
    English,
    /// Russian.
    Russian,
    /// Kazakh.
    Kazakh,
    /// Uzbek, in Latin letters.
    Uzbek,
}

type Bundle = FluentBundle<FluentResource>;

impl Language {
    /// All languages.
    pub const ALL: [Language; 4] = [Language::English, Language::Russian, Language::Kazakh, Language::Uzbek];

    /// Its code: `en`, `ru`, `kk`, `uz`.
    pub fn code(self) -> &'static str {
        ["en", "ru", "kk", "uz"][self as usize]
    }

    /// The language has this sentence, or English has.
    pub(crate) fn has(self, key: &str) -> bool {
        self.bundle().has_message(key) || Language::English.bundle().has_message(key)
    }

    /// The language itself has this sentence.
    pub(crate) fn own(self, key: &str) -> bool {
        self.bundle().has_message(key)
    }

    /// A sentence, in English where the language does not have it. An argument that is missing stays visible as `{$name}`.
    pub(crate) fn format(self, key: &str, args: &FluentArgs) -> String {
        let bundle = if self.bundle().has_message(key) { self.bundle() } else { Language::English.bundle() };
        let Some(pattern) = bundle.get_message(key).and_then(|m| m.value()) else { return key.into() };
        bundle.format_pattern(pattern, Some(args), &mut Vec::new()).replace('\n', " ")
    }

    /// Sentences by the beginning of their names, and these others; arguments of these names stand as `{name}`, for a page that puts values in.
    pub fn words(self, prefix: &str, others: &[&str], arguments: &[&str]) -> BTreeMap<String, String> {
        let mut args = FluentArgs::new();
        for name in arguments {
            args.set(*name, FluentValue::from(format!("{{{name}}}")));
        }
        // English has every sentence
        let lines = CATALOGUES.iter().filter(|c| c.0 == "en").flat_map(|c| c.2.lines());
        let names = lines.filter_map(|l| l.split_once(" =")).map(|l| l.0);
        let wanted = names.filter(|n| n.starts_with(prefix) || others.contains(n));
        wanted.map(|n| (n.to_string(), self.format(n, &args))).collect()
    }

    /// A fixed phrase of a part: the language may have it under a name made of its letters.
    pub(crate) fn term(self, text: &str) -> String {
        let key = format!("term-{}", slug(text));
        match self.bundle().has_message(&key) {
            true => self.format(&key, &FluentArgs::new()),
            false => text.into(),
        }
    }

    /// A number as the language writes it.
    pub fn number(self, number: &str) -> String {
        match self {
            Language::English => number.into(),
            _ => number.replace('.', ","),
        }
    }

    /// A unit as the language writes it, word by word: `N/mm` has the words `N` and `mm`.
    pub fn unit(self, unit: &str) -> String {
        let mut out = String::with_capacity(unit.len());
        let mut word = String::new();
        for c in unit.chars().chain(['\0']) {
            if c.is_alphabetic() {
                word.push(c);
                continue;
            }
            let key = format!("unit-{}", word.replace('µ', "u"));
            match !word.is_empty() && self.bundle().has_message(&key) {
                true => out.push_str(&self.format(&key, &FluentArgs::new())),
                false => out.push_str(&word),
            }
            word.clear();
            out.extend(Some(c).filter(|c| *c != '\0'));
        }
        out
    }

    fn bundle(self) -> &'static Bundle {
        static BUNDLES: [OnceLock<Bundle>; 4] = [const { OnceLock::new() }; 4];
        BUNDLES[self as usize].get_or_init(|| bundle(self))
    }
}

impl FromStr for Language {
    type Err = String;

    /// From a code, also with a country: `ru`, `ru_RU.UTF-8`.
    fn from_str(code: &str) -> Result<Self, String> {
        let short = code.split(['_', '-', '.']).next().unwrap_or_default().to_ascii_lowercase();
        let codes = Language::ALL.map(Language::code).join(", ");
        Language::ALL.into_iter().find(|l| l.code() == short).ok_or_else(|| format!("unknown language `{code}`; use one of {codes}"))
    }
}

/// Letters and digits of a text, joined by hyphens.
pub(crate) fn slug(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty());
    words.collect::<Vec<_>>().join("-").to_ascii_lowercase()
}

/// Files of one language: names and texts.
pub(crate) fn files(language: Language) -> impl Iterator<Item = (&'static str, &'static str)> {
    CATALOGUES.iter().filter(move |c| c.0 == language.code()).map(|c| (c.1, c.2))
}

fn bundle(language: Language) -> Bundle {
    let id = language.code().parse().unwrap_or_default();
    let mut out = Bundle::new_concurrent(vec![id]);
    out.set_use_isolating(false);
    for (_, text) in files(language) {
        // what a file has right is used; the tests hold that all of it is
        let resource = FluentResource::try_new(text.into()).unwrap_or_else(|(part, _)| part);
        let _ = out.add_resource(resource);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn units_are_translated_word_by_word() {
        let units = ["rpm", "N/mm", "µN s/m", "rad/s²", "MN/m", "mN", "°", "1/s"];
        let ru = units.map(|u| Language::Russian.unit(u));
        assert_eq!(ru, ["об/мин", "Н/мм", "мкН с/м", "рад/с²", "МН/м", "мН", "°", "1/с"]);
        assert_eq!(units.map(|u| Language::English.unit(u)), units);
    }

    #[test]
    fn every_file_reads_without_error_and_no_sentence_stands_twice() {
        for language in Language::ALL {
            let mut out = Bundle::new_concurrent(vec![language.code().parse().unwrap()]);
            for (name, text) in files(language) {
                let resource = FluentResource::try_new(text.into()).unwrap_or_else(|e| panic!("{}/{name}: {:?}", language.code(), e.1));
                out.add_resource(resource).unwrap_or_else(|e| panic!("{}/{name}: {e:?}", language.code()));
            }
        }
    }

    #[test]
    fn other_languages_have_no_sentence_that_english_lacks() {
        let names = |l: Language| -> BTreeSet<&str> {
            let lines = files(l).flat_map(|f| f.1.lines());
            lines.filter(|l| l.starts_with(|c: char| c.is_ascii_alphabetic())).filter_map(|l| l.split_once(" =")).map(|l| l.0).collect()
        };
        let english = names(Language::English);
        for language in &Language::ALL[1..] {
            let own = names(*language);
            let more: Vec<_> = own.difference(&english).filter(|k| !k.starts_with("term-") && !k.starts_with("unit-")).collect();
            assert!(more.is_empty(), "{}: {more:?}", language.code());
        }
    }
}
