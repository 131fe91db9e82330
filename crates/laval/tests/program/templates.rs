//! Sentences of diagnostics: `text/en/diagnostics.ftl` lists the template of every `text!` in the sources, and translations have the same places.
//! `LAVAL_WRITE_DOCS=1 cargo test -p laval --test program templates` writes the list anew.

use super::catalogues::{LANGUAGES, messages, read};
use laval::language::has_words;
use laval::text::{id, places};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

const CRATES: [&str; 6] = ["laval-model", "laval-solve", "laval-separation", "laval", "laval-studio", "laval-cli"];

/// A source file of the workspace: its path from `crates` on, and its code without comments and unit tests.
pub struct Source {
    pub path: String,
    pub code: String,
}

pub fn sources() -> Vec<Source> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut out = Vec::new();
    for name in CRATES {
        for (path, text) in read(&crates.join(name).join("src"), "rs") {
            let path = path.strip_prefix(&crates).unwrap().to_string_lossy().replace('\\', "/");
            // the macro itself, and tests
            if path == "laval-model/src/text.rs" || path.ends_with("/tests.rs") || path.contains("/tests/") {
                continue;
            }
            let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let code = code.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
            out.push(Source { path, code });
        }
    }
    assert!(out.len() > 100);
    out
}

/// A string literal at the beginning of a text: what it says, and what follows it.
pub fn literal(text: &str) -> Option<(String, &str)> {
    let mut out = String::new();
    let mut rest = text.trim_start().strip_prefix('"')?;
    loop {
        let c = rest.chars().next()?;
        rest = &rest[c.len_utf8()..];
        match c {
            '"' => return Some((out, rest)),
            '\\' => {
                let e = rest.chars().next()?;
                rest = &rest[e.len_utf8()..];
                match e {
                    'n' => out.push('\n'),
                    't' => out.push('\t'),
                    '\n' => rest = rest.trim_start(),
                    'u' => {
                        let (code, after) = rest.strip_prefix('{')?.split_once('}')?;
                        out.push(char::from_u32(u32::from_str_radix(code, 16).ok()?)?);
                        rest = after;
                    }
                    other => out.push(other),
                }
            }
            c => out.push(c),
        }
    }
}

/// The text up to the bracket that closes what was opened before it.
pub fn inside(text: &str) -> &str {
    let (mut depth, mut at) = (0usize, 0);
    while let Some(c) = text[at..].chars().next() {
        match c {
            '"' => {
                let Some((_, rest)) = literal(&text[at..]) else { return text };
                at = text.len() - rest.len();
                continue;
            }
            // a character, not a lifetime
            '\'' if text[at + 1..].chars().nth(1) == Some('\'') => {
                at += 2 + text[at + 1..].chars().next().map_or(0, char::len_utf8);
                continue;
            }
            '\'' if text[at + 1..].starts_with('\\') && text.get(at + 3..at + 4) == Some("'") => {
                at += 4;
                continue;
            }
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' if depth == 0 => return &text[..at],
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        at += c.len_utf8();
    }
    text
}

/// Templates of a piece of code, in order, with what follows each inside its call.
pub fn templates(code: &str) -> Vec<(String, &str)> {
    code.match_indices("text!(").filter_map(|(at, m)| literal(inside(&code[at + m.len()..]))).collect()
}

/// Templates with words, by the file that has each first.
fn listed() -> Vec<(String, Vec<String>)> {
    let mut seen = BTreeSet::new();
    let mut out = Vec::new();
    for source in sources() {
        let own: Vec<String> =
            templates(&source.code).into_iter().map(|t| t.0).filter(|t| has_words(t) && seen.insert(t.clone())).collect();
        if !own.is_empty() {
            out.push((source.path, own));
        }
    }
    out
}

/// A template as a pattern of Fluent.
fn pattern(template: &str) -> String {
    let mut out = template.replace("{{", "\u{1}").replace("}}", "\u{2}");
    for place in places(template) {
        out = out.replace(&format!("{{{place}}}"), &format!("\u{3} ${place} \u{4}"));
    }
    let out = out.replace('\u{3}', "{").replace('\u{4}', "}").replace('\u{1}', "{\"{\"}").replace('\u{2}', "{\"}\"}");
    match (out.starts_with(' '), out.ends_with(' ')) {
        (false, false) => out,
        (a, b) => format!("{}{}{}", if a { "{\" \"}" } else { "" }, out.trim(), if b { "{\" \"}" } else { "" }),
    }
}

fn catalogue() -> String {
    let mut out = String::from(
        "### Sentences of diagnostics and of the command line, one for each template in the sources.\n### Written by LAVAL_WRITE_DOCS=1 cargo test -p laval --test program templates.\n",
    );
    for (path, own) in listed() {
        out += &format!("\n## {path}\n\n");
        for t in own {
            out += &format!("{} = {}\n", id(&t), pattern(&t));
        }
    }
    out
}

#[test]
fn the_list_of_templates_is_that_of_the_sources() {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("text/en/diagnostics.ftl");
    let text = catalogue();
    if std::env::var_os("LAVAL_WRITE_DOCS").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default().replace('\r', "");
    assert!(found == text, "text/en/diagnostics.ftl: run LAVAL_WRITE_DOCS=1 cargo test -p laval --test program templates");
}

#[test]
fn every_template_has_a_name_of_its_own_and_is_one_line() {
    let mut names: BTreeMap<String, String> = BTreeMap::new();
    for t in listed().into_iter().flat_map(|l| l.1) {
        assert!(!t.contains('\n'), "{t:?}");
        if let Some(other) = names.insert(id(&t), t.clone()) {
            panic!("{} is the name of {other:?} and of {t:?}", id(&t));
        }
    }
    assert!(names.len() > 400, "{}", names.len());
}

/// A translation has the places of the English sentence, each and no other; what is not translated is listed.
#[test]
fn translations_have_the_places_of_their_templates() {
    let own = |language: &str| messages(language).into_iter().filter(|m| m.0.starts_with("diag-")).collect::<BTreeMap<_, _>>();
    let english: BTreeMap<String, BTreeSet<String>> =
        listed().into_iter().flat_map(|l| l.1).map(|t| (id(&t), places(&t).into_iter().map(String::from).collect())).collect();
    assert_eq!(own("en"), english, "the list is not current");
    for language in LANGUAGES {
        let translated = own(language);
        let wrong: Vec<_> = translated.iter().filter(|(name, used)| english.get(*name) != Some(*used)).collect();
        assert!(wrong.is_empty(), "{language}: other places than the template, or no template: {wrong:#?}");
        let left: Vec<&String> = english.keys().filter(|k| !translated.contains_key(*k)).collect();
        println!("{language}: {} of {} sentences of diagnostics are not translated: {left:#?}", left.len(), english.len());
    }
}

/// `Diagnostic` takes a `Text`, and only `text!` makes one.
#[test]
fn sentences_are_templates_and_no_strings() {
    // a stored outcome brings back what text! made
    for source in sources().into_iter().filter(|s| s.path != "laval/src/outcome/stored.rs") {
        assert!(!source.code.contains("of_template("), "{}: a Text that no text! made", source.path);
    }
    let own = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../laval-model/src/text.rs")).unwrap();
    assert!(!own.contains("for Text {\n    fn from"), "nothing turns into a Text by itself");
}

/// What stands in a place is data: no English words, which other languages could not say.
#[test]
fn no_english_stands_in_the_places() {
    let mut wrong = Vec::new();
    for source in sources() {
        for (template, arguments) in templates(&source.code) {
            let mut rest = arguments.to_string();
            // phrases in places are templates themselves
            while let Some(at) = rest.find("text!(") {
                let whole = inside(&rest[at + 6..]).len();
                rest.replace_range(at..at + 6 + whole, "");
            }
            let mut left = rest.as_str();
            while let Some(at) = left.find('"') {
                let Some((said, after)) = literal(&left[at..]) else { break };
                if said.split([' ', ',']).filter(|w| w.len() > 2 && w.bytes().all(|b| b.is_ascii_lowercase())).count() > 1 {
                    wrong.push(format!("{}: {template:?} has {said:?}", source.path));
                }
                left = after;
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
