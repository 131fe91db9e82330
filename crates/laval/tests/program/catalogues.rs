//! Sentences of reports: every one that a study names is in the English catalogue with the arguments that it is given, and the catalogue has no other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Beginnings of names that are put together where they are used; those of diagnostics have tests of their own (`templates`).
const COMPOSED: [&str; 7] = ["verdict-", "short-", "study-", "unit-", "term-", "diag-", "studio-"];
pub const LANGUAGES: [&str; 3] = ["ru", "kk", "uz"];

fn files(folder: &Path, extension: &str, out: &mut Vec<PathBuf>) {
    for path in fs::read_dir(folder).into_iter().flatten().map(|e| e.unwrap().path()) {
        if path.is_dir() {
            files(&path, extension, out);
        } else if path.extension().is_some_and(|e| e == extension) {
            out.push(path);
        }
    }
}

pub fn read(folder: &Path, extension: &str) -> Vec<(PathBuf, String)> {
    let mut out = Vec::new();
    files(folder, extension, &mut out);
    out.sort();
    out.into_iter().map(|p| (p.clone(), fs::read_to_string(p).unwrap().replace('\r', ""))).collect()
}

/// Messages of a language with the variables that each uses.
pub fn messages(language: &str) -> BTreeMap<String, BTreeSet<String>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("text").join(language);
    let mut out: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut current = String::new();
    for (_, text) in read(&root, "ftl") {
        for line in text.lines().filter(|l| !l.starts_with('#')) {
            if line.starts_with(|c: char| c.is_ascii_alphabetic()) {
                current = line.split(" =").next().unwrap().to_string();
                out.entry(current.clone()).or_default();
            }
            for (at, _) in line.match_indices('$') {
                let name: String = line[at + 1..].chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_' || *c == '-').collect();
                out.entry(current.clone()).or_default().insert(name);
            }
        }
    }
    out
}

/// Text between quotation marks in a source file.
fn literals(text: &str) -> BTreeSet<&str> {
    let mut out = BTreeSet::new();
    for line in text.lines().filter(|l| !l.trim_start().starts_with("//")) {
        out.extend(line.split('"').skip(1).step_by(2));
    }
    out
}

#[test]
fn sentences_and_their_arguments_are_those_of_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources = read(&root.join("src"), "rs");
    for user in ["../laval-cli/src", "../laval-studio/src"] {
        sources.extend(read(&root.join(user), "rs"));
    }
    let known = messages("en");
    assert!(known.len() > 400);
    let mut missing = Vec::new();
    let mut used: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (_, text) in &sources {
        for word in literals(text) {
            if known.contains_key(word) {
                used.entry(word).or_default().push(text);
            }
        }
    }
    for (name, variables) in &known {
        if COMPOSED.iter().any(|c| name.starts_with(c)) {
            continue;
        }
        let Some(texts) = used.get(name.as_str()) else {
            missing.push(format!("no source names the sentence {name}"));
            continue;
        };
        for v in variables.iter().filter(|v| !texts.iter().any(|t| t.contains(&format!("\"{v}\"")))) {
            // arguments that several findings share are added by a helper of another file
            if !sources.iter().any(|(_, t)| t.contains(&format!("arg(\"{v}\""))) && v != "value" {
                missing.push(format!("{name} uses ${v}, which no source gives"));
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// The second argument of a finding is the name of a sentence, never a sentence.
#[test]
fn no_finding_is_a_sentence_in_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut wrong = Vec::new();
    for (path, text) in read(&root.join("src/study"), "rs").into_iter().chain(read(&root.join("src/store"), "rs")) {
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap();
        for call in ["Finding::info(", "Finding::warning(", "Finding::invalid("] {
            for (at, _) in code.match_indices(call) {
                let rest = &code[at + call.len()..];
                let mut depth = 1;
                let end = rest
                    .char_indices()
                    .find(|(_, c)| {
                        depth += match c {
                            '(' => 1,
                            ')' => -1,
                            _ => 0,
                        };
                        depth == 0
                    })
                    .map_or(rest.len(), |e| e.0);
                let arguments = &rest[..end];
                let sentence = literals(arguments).into_iter().any(|l| l.contains(' '));
                let composed = arguments.split_once(',').is_some_and(|(_, second)| second.contains("format!"));
                if sentence || composed {
                    wrong.push(format!("{}: {call}{arguments})", path.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A translation uses no argument that the English sentence does not have; what is not translated is listed.
#[test]
fn translations_use_the_arguments_of_the_english_sentences() {
    let english = messages("en");
    for language in LANGUAGES {
        let own = messages(language);
        let mut wrong = Vec::new();
        for (name, variables) in &own {
            if let Some(e) = english.get(name) {
                wrong.extend(variables.difference(e).map(|v| format!("{name}: ${v}")));
            }
        }
        assert!(wrong.is_empty(), "{language}: {wrong:#?}");
        let left: Vec<&String> = english.keys().filter(|k| !own.contains_key(*k)).collect();
        println!("{language}: {} of {} sentences are not translated: {left:?}", left.len(), english.len());
    }
}
