//! Meanings of keys and of their words, which messages quote, are in the catalogues of all languages.

use super::catalogues::{LANGUAGES, messages};
use laval::file::{MACHINE_FIELDS, catalog};
use laval::model::field::{DISTRIBUTIONS, Field, FieldKind};
use std::collections::BTreeSet;

/// The name of a phrase in the catalogues.
fn key(phrase: &str) -> String {
    let words = phrase.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty());
    format!("term-{}", words.collect::<Vec<_>>().join("-").to_ascii_lowercase())
}

/// What a message may quote of a field: its meaning where it must be given, and those of its words and columns.
fn quoted(f: &Field) -> Vec<&'static str> {
    let mut out: Vec<&str> = f.required.then_some(f.doc).into_iter().collect();
    match f.kind {
        FieldKind::Choice(words) => out.extend(words.iter().map(|w| w.1)),
        FieldKind::Columns(columns) => out.extend(columns.iter().filter(|c| c.2).map(|c| c.3)),
        FieldKind::Tolerances => out.extend(DISTRIBUTIONS.iter().map(|d| d.1)),
        _ => {}
    }
    out
}

#[test]
fn every_meaning_that_a_message_quotes_is_translated() {
    let catalog = catalog();
    let kinds = catalog.parts.iter().chain(&catalog.studies).chain(catalog.blocks.iter().flat_map(|b| &b.kinds));
    let fields = kinds.flat_map(|k| &k.fields).chain(MACHINE_FIELDS);
    let mut all: BTreeSet<&str> = fields.flat_map(quoted).collect();
    all.extend(laval::units::quantities().iter().map(|q| q.1));
    assert!(all.len() > 200, "{}", all.len());
    let mut missing = Vec::new();
    for language in LANGUAGES {
        let own = messages(language);
        missing.extend(all.iter().filter(|p| !own.contains_key(&key(p))).map(|p| format!("{language}: {} ({p})", key(p))));
    }
    assert!(missing.is_empty(), "text/LANGUAGE/terms.ftl lacks {missing:#?}");
}
