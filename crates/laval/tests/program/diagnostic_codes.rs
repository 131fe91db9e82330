//! `docs/diagnostics.md`: every code of a diagnostic with its sentences, as the sources have them.
//! `LAVAL_WRITE_DOCS=1 cargo test -p laval --test program diagnostic_codes` writes it anew.

use super::docs::current;
use super::templates::{Source, inside, literal, sources, templates};
use std::collections::{BTreeMap, BTreeSet};

/// Calls that take a code, all of whose messages are among their arguments or named there.
const CALLS: [&str; 6] = ["error(", "warning(", "UnitError::new(", "wrong(", "incomplete(", "invalid("];
/// Codes whose sentences functions of this name return, and where these are.
const BY_FUNCTION: [(&str, &str, &str); 9] = [
    ("bearing_linear.table", "pub fn new(speed: &[f64]", "laval-model/src/parts/bearing_linear/"),
    ("part.axis", "fn refuses_axis(", "laval-"),
    ("part.spins", "fn refuses_ratio(", "laval-"),
    ("part.check", "fn check(&self, p:", "laval-model/src/parts/"),
    ("part.check", "fn wrong(&self, p:", "laval-model/src/parts/"),
    ("part.incomplete", "fn incomplete(", "laval/src/file/"),
    ("part.purpose", "fn warnings(&self, p: &Params", "laval-model/src/parts/"),
    ("shaft_viscoelastic.creep", "fn creeps(", "laval-model/src/parts/"),
    ("study.incomplete", "fn incomplete(", "laval/src/file/"),
];
/// Lines above a call in which a message that it names is looked for.
const ABOVE: usize = 90;

/// `unit.missing`: words of small letters, with dots between.
fn is_code(text: &str) -> bool {
    let word = |w: &str| !w.is_empty() && w.bytes().all(|b| b.is_ascii_lowercase() || b == b'_');
    text.contains('.') && text.split('.').all(word)
}

/// Arguments of a call.
fn arguments(call: &str) -> Vec<&str> {
    let mut out = Vec::new();
    let (mut begin, mut at, mut depth) = (0, 0, 0i32);
    while let Some(c) = call[at..].chars().next() {
        match c {
            '"' => {
                at = literal(&call[at..]).map_or(call.len(), |(_, rest)| call.len() - rest.len());
                continue;
            }
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                out.push(call[begin..at].trim());
                begin = at + 1;
            }
            _ => {}
        }
        at += c.len_utf8();
    }
    out.push(call[begin..].trim());
    out
}

/// Templates of a piece of code that stand in no other one.
fn outermost(code: &str) -> Vec<String> {
    let mut out = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find("text!(") {
        let call = inside(&rest[at + 6..]);
        out.extend(literal(call).map(|l| l.0));
        rest = &rest[at + 6 + call.len()..];
    }
    out
}

/// What the variable of a name was set to above a place.
fn set_above<'c>(code: &'c str, at: usize, name: &str) -> Option<&'c str> {
    let above = &code[..at];
    let begin = above.rmatch_indices('\n').nth(ABOVE).map_or(0, |m| m.0);
    let plain = [format!("let {name} ="), format!("let ({name}, help) ="), format!("let mut {name} =")];
    let (start, found) = plain.iter().filter_map(|p| above[begin..].rfind(p.as_str()).map(|i| (begin + i + p.len(), p))).max()?;
    let _ = found;
    let rest = &code[start..];
    // up to the semicolon outside of brackets and texts
    let (mut i, mut depth) = (0, 0i32);
    while let Some(c) = rest[i..].chars().next() {
        match c {
            '"' => {
                i = literal(&rest[i..]).map_or(rest.len(), |(_, after)| rest.len() - after.len());
                continue;
            }
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ';' if depth == 0 => return Some(&rest[..i]),
            _ => {}
        }
        i += c.len_utf8();
    }
    None
}

/// The closure around a place that takes its message as an argument, by its name: `let wrong = |message: Text| ...`.
fn closure_around(code: &str, at: usize) -> Option<String> {
    let above = &code[..at];
    let begin = above.rmatch_indices('\n').nth(6).map_or(0, |m| m.0);
    let start = above[begin..].rfind("let ").map(|i| begin + i + 4)?;
    let (name, after) = code[start..].trim_start_matches("mut ").split_once(" =")?;
    (after.trim_start().starts_with(['|', 'm']) && after[..after.len().min(300)].contains('|')).then(|| name.trim().to_string())
}

/// The first of the arguments of a call at a place that is a sentence, or a variable that was set to one; labels and help come after it.
fn sentence(code: &str, at: usize, arguments: &[&str]) -> Vec<String> {
    let of = |a: &&str| {
        let said = outermost(a);
        let word = a.trim_start_matches('&').trim_end_matches(".clone()");
        match said.is_empty() && word.chars().all(|c| c.is_alphanumeric() || c == '_') {
            true => set_above(code, at, word).map(outermost).unwrap_or_default(),
            false => said,
        }
    };
    arguments.iter().map(of).find(|said| !said.is_empty()).unwrap_or_default()
}

/// Codes of a file with their sentences.
fn codes(source: &Source, consts: &BTreeMap<String, String>, out: &mut BTreeMap<String, Vec<String>>) {
    let code = source.code.as_str();
    for call in CALLS {
        for (at, _) in code.match_indices(call) {
            // the whole name of what is called
            if call != "UnitError::new(" && code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_') {
                continue;
            }
            let all = arguments(inside(&code[at + call.len()..]));
            let named = |a: &&str| consts.get(a.rsplit("::").next().unwrap_or_default()).cloned();
            let value = |a: &&str| literal(a).map(|l| l.0).filter(|t| a.starts_with('"') && is_code(t)).or_else(|| named(a));
            let Some((place, own)) = all.iter().enumerate().find_map(|(k, a)| Some((k, value(a)?))) else { continue };
            let mut said = sentence(code, at, &all[place + 1..]);
            if said.is_empty()
                && let Some(name) = closure_around(code, at)
            {
                for (k, m) in code.match_indices(&format!("{name}(")) {
                    if !code[..k].ends_with(|c: char| c.is_alphanumeric() || c == '_') {
                        said.extend(sentence(code, k, &arguments(inside(&code[k + m.len()..]))));
                    }
                }
            }
            let list = out.entry(own).or_default();
            said.retain(|t| laval::language::has_words(t) && !list.contains(t));
            list.extend(said);
        }
    }
}

/// Sentences in the bodies of functions that return them for these codes.
fn by_functions(all: &[Source], out: &mut BTreeMap<String, Vec<String>>) {
    for (own, head, folder) in BY_FUNCTION {
        for source in all.iter().filter(|s| s.path.starts_with(folder)) {
            for (at, _) in source.code.match_indices(head) {
                let rest = &source.code[at..];
                let Some(body) = rest.find("{\n").map(|i| inside(&rest[i + 1..])) else { continue };
                let list = out.entry(own.into()).or_default();
                for t in outermost(body) {
                    if !list.contains(&t) {
                        list.push(t);
                    }
                }
            }
        }
    }
}

/// `const BEYOND: &str = "study.beyond_table"`, in all files.
fn constants(all: &[Source]) -> BTreeMap<String, String> {
    let mut out = BTreeMap::new();
    for line in all.iter().flat_map(|s| s.code.lines()).filter(|l| l.contains("const ") && l.contains(": &str = \"")) {
        let (head, value) = line.split_once(": &str = ").unwrap();
        let name = head.rsplit(' ').next().unwrap_or_default();
        if let Some((value, _)) = literal(value).filter(|v| is_code(&v.0)) {
            out.insert(name.to_string(), value);
        }
    }
    out
}

fn page() -> String {
    let all = sources();
    let consts = constants(&all);
    let mut found = BTreeMap::new();
    for source in &all {
        codes(source, &consts, &mut found);
    }
    assert!(found.len() > 100, "{}", found.len());
    by_functions(&all, &mut found);
    let groups: BTreeSet<&str> = found.keys().filter_map(|c| c.split('.').next()).collect();
    let mut out = String::from(
        "# Diagnostics\n\nEvery mistake of a machine file, every refusal of a study and every complaint of the command line has a code, which never changes with the\n\
         language. `laval check FILE --lang ru` prints the sentences in Russian (`kk` Kazakh, `uz` Uzbek); `laval check FILE --json` gives code, severity, sentence and\n\
         place to editors. Words in braces stand for names, values and phrases. A code whose sentence is that of another part of the program, as of a value that it\n\
         could not read, has none here.\n",
    );
    for group in groups {
        out += &format!("\n## {group}\n\n| code | sentences |\n| --- | --- |\n");
        for (code, said) in found.iter().filter(|(c, _)| c.split('.').next() == Some(group)) {
            let cell = |t: &String| t.replace("{{", "{").replace("}}", "}").replace('|', "\\|").replace('<', "&lt;").replace('*', "\\*");
            out += &format!("| `{code}` | {} |\n", said.iter().map(cell).collect::<Vec<_>>().join("<br>"));
        }
    }
    out
}

#[test]
fn page_of_diagnostics_is_current() {
    let text = page();
    current("diagnostics.md", &text);
    let silent: Vec<&str> = text.lines().filter(|l| l.ends_with("` |  |")).collect();
    println!("codes whose sentences come from elsewhere: {silent:#?}");
    // the sentences of a design stand where its kinds are checked; that of a unit has a code of its own
    assert_eq!(silent, ["| `cases.design` |  |", "| `report.units` |  |"]);
}

#[test]
fn every_sentence_of_the_page_is_a_template() {
    let known: BTreeSet<String> = sources().iter().flat_map(|s| templates(&s.code).into_iter().map(|t| t.0).collect::<Vec<_>>()).collect();
    let mut found = BTreeMap::new();
    let all = sources();
    let consts = constants(&all);
    all.iter().for_each(|s| codes(s, &consts, &mut found));
    assert!(found.values().flatten().all(|t| known.contains(t)));
}
