//! Phrases of figures and tables: those that readers see are fixed phrases or sentences of the catalogues, never composed where they are used, and
//! every translation belongs to one.

use super::catalogues::{LANGUAGES, messages, read};
use laval::model::field::FieldKind;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Calls, and which of their arguments readers see: titles, labels, headings, meanings.
const SHOWN: &[(&str, &[usize])] = &[
    ("Figure::new(", &[1, 2]),
    ("Axis::new(", &[0]),
    ("Axis::log(", &[0]),
    ("axis(", &[0]),
    ("lengths(", &[0]),
    ("drawn(", &[0]),
    ("Rule::x(", &[1]),
    ("Rule::y(", &[1]),
    ("Text::new(", &[2]),
    (".name(", &[0]),
    (".meaning(", &[0, 1]),
    ("Table::new(", &[1]),
    (".float(", &[2]),
    (".float_if_any(", &[2]),
    (".int(", &[2]),
    (".text(", &[1]),
    (".flag(", &[1]),
    (".names(", &[1]),
    (".add(", &[2]),
    (".all(", &[1]),
    (".evidence(", &[0]),
    ("Arg::of(", &[0]),
    ("Arg::noted(", &[0, 1]),
    ("Arg::term(", &[0]),
    ("SpecialPoint::new(", &[0]),
    ("noted(", &[0]),
    ("reported(", &[0]),
    ("interval(", &[3]),
    ("line(", &[0, 1]),
    ("across(", &[1]),
    ("factor_of(", &[0]),
    ("figure(", &[1]),
    ("pair(", &[1]),
    ("row(&", &[0]),
    (".work(", &[0]),
    (".over(", &[0]),
];
/// Names of columns, which are headings; and columns of stored rows.
const HEADINGS: &[(&str, &[usize])] = &[
    (".float(", &[0]),
    (".float_if_any(", &[0]),
    (".int(", &[0]),
    (".text(", &[0, 2]),
    (".flag(", &[0]),
    (".names(", &[0]),
    (".add(", &[0]),
    ("number(", &[0, 2]),
    ("word(", &[0, 1]),
    ("count(", &[0, 1]),
    ("body(", &[0, 2]),
];
/// Ends of phrases that are put together where they are used: a state that is not stable, one of several alike.
const BEHIND: [&str; 1] = ["-unstable"];
const BEFORE: [&str; 1] = ["at-rest-"];

/// Sources without comments and unit tests, and without quotation marks that are characters.
fn sources(folder: &Path) -> Vec<(String, String)> {
    let code = |text: &str| {
        let lines = text.split("#[cfg(test)]\nmod tests {").next().unwrap().lines().filter(|l| !l.trim_start().starts_with("//"));
        lines.collect::<Vec<_>>().join("\n").replace("'\"'", "' '")
    };
    read(folder, "rs").into_iter().map(|(path, text)| (path.display().to_string(), code(&text))).collect()
}

/// Texts between quotation marks, lines that go on joined.
fn strings(code: &str) -> Vec<String> {
    let mut out = Vec::new();
    let mut chars = code.chars().peekable();
    while let Some(c) = chars.next() {
        if c != '"' {
            continue;
        }
        let mut text = String::new();
        while let Some(c) = chars.next().filter(|c| *c != '"') {
            match (c, c == '\\').1.then(|| chars.next()).flatten() {
                Some('\n') => while chars.next_if(|c| c.is_whitespace()).is_some() {},
                Some(escaped) => text.push(escaped),
                None => text.push(c),
            }
        }
        out.push(text);
    }
    out
}

/// The arguments of a call whose bracket opened before this text.
fn arguments(code: &str) -> Vec<&str> {
    let (mut out, mut start, mut depth, mut inside, mut escaped) = (Vec::new(), 0, 0, false, false);
    for (i, c) in code.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' if inside => escaped = true,
            '"' => inside = !inside,
            _ if inside => {}
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' if depth == 0 => {
                out.push(&code[start..i]);
                return out;
            }
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                out.push(&code[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    out
}

/// The chosen arguments of all calls: the call and the argument.
fn chosen<'c>(code: &'c str, calls: &[(&'static str, &[usize])]) -> Vec<(&'static str, &'c str)> {
    let mut out = Vec::new();
    for (call, which) in calls {
        for (at, _) in code.match_indices(call) {
            let before = code[..at].chars().next_back().unwrap_or(' ');
            let part = !call.starts_with('.') && (before.is_alphanumeric() || before == '_' || before == '.');
            if part || code[..at].ends_with("fn ") {
                continue;
            }
            let all = arguments(&code[at + call.len()..]);
            out.extend(which.iter().filter_map(|k| all.get(*k)).map(|a| (*call, *a)));
        }
    }
    out
}

/// Texts of constants and of functions that choose one: words of tables.
fn words(code: &str) -> Vec<String> {
    let mut out = Vec::new();
    for (at, _) in code.match_indices("const ") {
        let Some((head, rest)) = code[at..].split_once(" = ") else { continue };
        let noise = ["EXAMPLE", "DOC", "KIND"].iter().any(|n| head.starts_with(&format!("const {n}:")));
        let list = head.contains("[&str;") || head.contains("str") && !head.contains(['(', ';', '{']);
        if list && !noise {
            out.extend(strings(rest.split(";\n").next().unwrap_or_default()));
        }
    }
    for (at, found) in code.match_indices("&'static str {").chain(code.match_indices("Option<&'static str> {")) {
        if code[..at].trim_end().ends_with("->") {
            out.extend(arguments(&code[at + found.len()..]).into_iter().flat_map(strings));
        }
    }
    for name in ["doc", "label", "word", "words", "title", "what", "at_hand", "shown", "slope", "influence"] {
        for (at, _) in code.match_indices(&format!("let {name} = ")) {
            out.extend(strings(code[at..].split(";\n").next().unwrap_or_default()));
        }
    }
    out
}

/// Without messages of the catalogues and their arguments.
fn own(argument: &str) -> String {
    let mut out = argument.to_string();
    for call in ["Message::new(", ".arg("] {
        while let Some(at) = out.find(call) {
            let first = arguments(&out[at + call.len()..]).first().map_or(0, |a| a.len());
            out.replace_range(at..at + call.len() + first, "");
        }
    }
    out
}

/// A phrase as readers see it: a column that holds the name of a body without that name, blanks for underscores. None for what is no phrase.
fn phrase(text: &str) -> Option<String> {
    let text = text.split_once(['}']).filter(|t| t.0.starts_with('{') && t.1.starts_with([' ', '.'])).map_or(text, |t| &t.1[1..]);
    let text = text.rsplit_once(".{").map_or(text, |t| t.0).replace('_', " ");
    let letters = text.chars().filter(|c| c.is_ascii_alphabetic()).count();
    (letters > 0 && !text.contains(['{', '}', '<', '/', '\\', '=']) && (letters > 1 || text.len() == 1)).then(|| text.trim().to_string())
}

fn slug(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty());
    words.collect::<Vec<_>>().join("-").to_ascii_lowercase()
}

/// Phrases of figures, tables, evidence and the page, by the names under which languages may have them.
fn phrases() -> BTreeMap<String, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let known = messages("en");
    let mut out = BTreeMap::new();
    for (folder, all) in [("study", true), ("store", true), ("report", false), ("outcome", false)] {
        for (_, code) in sources(&root.join(folder)) {
            let mut found: Vec<String> = chosen(&code, SHOWN).into_iter().flat_map(|a| strings(&own(a.1))).collect();
            if all {
                found.extend(chosen(&code, HEADINGS).into_iter().flat_map(|a| strings(&own(a.1))));
                found.extend(words(&code));
            }
            let texts = found.into_iter().filter(|t| !known.contains_key(t)).filter_map(|t| phrase(&t));
            out.extend(texts.map(|t| (slug(&t), t)));
        }
    }
    // parameters of parts, which axes and rows of figures name
    for kind in &laval::file::catalog().parts {
        let quantities = kind.fields.iter().filter(|f| matches!(f.kind, FieldKind::Quantity { .. } | FieldKind::Lateral { .. }));
        for f in quantities {
            let sides: &[&str] = if matches!(f.kind, FieldKind::Lateral { .. }) { &["", " x", " y"] } else { &[""] };
            out.extend(sides.iter().filter_map(|side| phrase(&[f.name, side].concat())).map(|t| (slug(&t), t)));
        }
    }
    // what parts show, which columns and legends name
    for (_, code) in sources(&root.join("../../laval-model/src")) {
        let shown = code.match_indices("Observed { name: \"").filter_map(|(at, _)| strings(&code[at..]).into_iter().next());
        out.extend(shown.filter_map(|t| phrase(&t)).map(|t| (slug(&t), t)));
    }
    out
}

/// What readers see in figures and tables is a phrase or a sentence of the catalogues with its arguments: then a language can have it, in its units.
#[test]
fn no_text_of_a_figure_or_table_is_composed_in_the_sources() {
    let known = messages("en");
    let mut wrong = Vec::new();
    for (path, code) in sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/study")) {
        let composed = chosen(&code, SHOWN).into_iter().filter(|a| a.1.contains("format!"));
        wrong.extend(composed.map(|(call, a)| format!("{path}: {call}.. {a}")));
        // the description of a figure is a sentence
        let all = chosen(&code, &[("Figure::new(", &[2])]).into_iter();
        let sentences = all.flat_map(|a| strings(a.1)).filter(|t| !known.contains_key(t));
        wrong.extend(sentences.map(|t| format!("{path}: no sentence of the catalogue is named {t:?}")));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A translation of a phrase that no source has any more is left over. Phrases that are not translated are listed.
#[test]
fn translated_phrases_are_those_of_the_sources() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let phrases = phrases();
    assert!(phrases.len() > 500);
    let mut used: BTreeSet<String> = phrases.keys().cloned().collect();
    for name in ["laval", "laval-cli", "laval-model", "laval-num", "laval-separation", "laval-solve", "laval-studio"] {
        used.extend(sources(&crates.join(name).join("src")).iter().flat_map(|s| strings(&s.1)).map(|t| slug(&t)));
    }
    let is_used = |term: &str| {
        let numbered = term.rsplit_once('-').filter(|t| t.1.parse::<u32>().is_ok()).map_or(term, |t| t.0);
        let behind = |t: &str| BEHIND.iter().find_map(|e| t.strip_suffix(e)).unwrap_or(t).to_string();
        let before = |t: &str| BEFORE.iter().find_map(|e| t.strip_prefix(e)).unwrap_or(t).to_string();
        [term, numbered].iter().any(|t| used.contains(*t) || used.contains(&before(&behind(t))))
    };
    for (term, text) in &phrases {
        println!("term-{term}\t{text}");
    }
    for language in LANGUAGES {
        let own: BTreeSet<String> = messages(language).into_keys().filter_map(|k| k.strip_prefix("term-").map(String::from)).collect();
        let over: Vec<&String> = own.iter().filter(|t| !is_used(t)).collect();
        assert!(over.is_empty(), "{language}: no source has these phrases: {over:#?}");
        let left: Vec<&String> = phrases.keys().filter(|k| !own.contains(*k)).collect();
        println!("{language}: {} of {} phrases are not translated: {left:?}", left.len(), phrases.len());
    }
}
