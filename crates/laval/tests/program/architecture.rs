//! Who may use whom, and that only the registry knows the kinds of parts.

use std::fs;
use std::path::{Path, PathBuf};

/// Module, and the modules it may use besides itself. `units`, `diagnostic`, `text`, `hash`, `plain`, `build` and `folder` are open to all. What one crate may use of another
/// Cargo enforces; this holds between the modules of a crate, and keeps concrete parts out of `laval-solve`.
const MAY_USE: &[(&str, &[&str])] = &[
    ("units", &[]),
    ("diagnostic", &[]),
    ("text", &[]),
    ("numerics", &[]),
    ("language", &[]),
    ("model", &[]),
    ("cavity", &[]),
    ("parts", &["model", "cavity"]),
    ("solve", &["model"]),
    ("separation", &["model"]),
    ("outcome", &[]),
    ("hash", &[]),
    ("plain", &[]),
    ("build", &[]),
    ("output_folder", &[]),
    ("columns", &[]),
    ("store", &["outcome", "columns"]),
    ("study", &["model", "solve", "separation", "outcome", "store"]),
    ("report", &["outcome", "columns", "language"]),
    ("file", &["model", "parts", "study", "language"]),
    ("import", &["file", "model", "parts"]),
    ("cases", &["file", "study", "model", "outcome", "store"]),
    ("reach", &["file", "study", "solve", "model"]),
    ("run", &["file", "study", "outcome", "report", "store"]),
    ("validation", &["file", "study", "outcome", "report"]),
    ("prelude", &["model", "parts", "study", "outcome", "file"]),
];
const OPEN: &[&str] = &["units", "diagnostic", "text", "hash", "plain", "build", "output_folder"];

/// A source file of the crate: its module, its path, and its code without comments and unit tests.
struct Source {
    module: String,
    path: PathBuf,
    lines: Vec<(usize, String)>,
}

fn sources() -> Vec<Source> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    let mut folders = Vec::new();
    for (name, module) in [("laval-model", None), ("laval-solve", Some("solve")), ("laval-separation", Some("separation")), ("laval", None)]
    {
        let root = crates.join(name).join("src");
        folders.push((root.clone(), root, module));
    }
    while let Some((root, folder, whole)) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                // unit tests in files of their own are left out like those at the foot of a file
                if path.file_name().is_some_and(|n| n != "tests") {
                    folders.push((root.clone(), path, whole));
                }
            } else if path.extension().is_some_and(|e| e == "rs") && path.file_stem().is_some_and(|s| s != "tests") {
                let first = path.strip_prefix(&root).unwrap().components().next().unwrap();
                let own = || Path::new(first.as_os_str()).file_stem().unwrap().to_string_lossy().into_owned();
                let module = whole.map_or_else(own, str::to_string);
                let text = fs::read_to_string(&path).unwrap();
                found.push(Source { module, path, lines: code(&text) });
            }
        }
    }
    assert!(found.len() > 20, "the sources were not found");
    found
}

/// Code lines, numbered from 1: whole-line comments are dropped, trailing ones cut, lists after `crate::{` joined to one line, and
/// everything from the unit tests on left out.
fn code(text: &str) -> Vec<(usize, String)> {
    let lines: Vec<&str> = text.lines().collect();
    let test_module = |i: usize| {
        let next = lines.get(i + 1).map_or("", |l| l.trim());
        lines[i].trim() == "#[cfg(test)]" && next.starts_with("mod ") && next.ends_with('{')
    };
    let end = (0..lines.len()).find(|&i| test_module(i)).unwrap_or(lines.len());
    let mut out: Vec<(usize, String)> = Vec::new();
    for (i, line) in lines[..end].iter().enumerate().filter(|(_, l)| !l.trim_start().starts_with("//")) {
        let line = line.split(" // ").next().unwrap_or_default();
        match out.last_mut() {
            Some((_, last)) if last.contains("crate::{") && last.matches('{').count() > last.matches('}').count() => {
                last.push_str(line.trim())
            }
            _ => out.push((i + 1, line.to_string())),
        }
    }
    out
}

/// Modules named after `crate::` or `laval_model::` in a line, also inside braces.
fn used(line: &str) -> Vec<String> {
    ["crate::", "laval_model::"].iter().flat_map(|root| used_of(root, line)).collect()
}

fn used_of(root: &str, line: &str) -> Vec<String> {
    let mut out = Vec::new();
    for (at, _) in line.match_indices(root) {
        let before = line[..at].chars().next_back();
        if before.is_some_and(|c| c == '$' || c.is_alphanumeric() || c == '_') {
            continue;
        }
        let rest = &line[at + root.len()..];
        // names at the outermost level of a list
        let mut depth = 0;
        let outermost = |c: char| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            c == ',' && depth == 0
        };
        let names: Vec<&str> = rest.strip_prefix('{').map_or(vec![rest], |list| list.split(outermost).collect());
        for name in names {
            let word: String = name.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            if !word.is_empty() {
                out.push(word);
            }
        }
    }
    out
}

fn forbidden(module: &str, line: &str) -> Option<String> {
    let allowed = MAY_USE.iter().find(|m| m.0 == module).map(|m| m.1)?;
    let known = |u: &String| MAY_USE.iter().any(|m| m.0 == u);
    used(line).into_iter().find(|u| known(u) && u != module && !OPEN.contains(&u.as_str()) && !allowed.contains(&u.as_str()))
}

#[test]
fn modules_use_only_what_they_may() {
    let mut wrong = Vec::new();
    for source in sources() {
        if source.module == "lib" {
            continue;
        }
        if !MAY_USE.iter().any(|m| m.0 == source.module) {
            wrong.push(format!("module \"{}\" has no rule: {}", source.module, source.path.display()));
        }
        for (number, line) in &source.lines {
            if let Some(other) = forbidden(&source.module, line) {
                wrong.push(format!("{}:{number}: {} may not use {other}", source.path.display(), source.module));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Words that only this program used, for which the field has terms of its own.
#[test]
fn private_words_are_gone() {
    const PRIVATE: [&str; 14] = [
        "told", "asked", "judge", "judged", "judges", "judging", "unjudged", "voyage", "flight", "fleet", "riders", "atlas", "crew", "sail",
    ];
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let (mut found, mut folders, mut files) = (Vec::new(), vec![root.join("docs"), root.join("crates")], vec![root.join("README.md")]);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
            let tests = entry.ends_with("tests") || entry.ends_with("benches");
            match entry.extension().and_then(|e| e.to_str()) {
                Some("rs" | "md") => files.push(entry),
                None if entry.is_dir() && !tests => folders.push(entry),
                _ => {}
            }
        }
    }
    for file in &files {
        for (k, line) in std::fs::read_to_string(file).unwrap().lines().enumerate() {
            let mut words = line.split(|c: char| !c.is_ascii_alphabetic()).map(str::to_lowercase);
            if let Some(word) = words.find(|w| PRIVATE.contains(&w.as_str())) {
                found.push(format!("{}:{}: {word}", file.display(), k + 1));
            }
        }
    }
    assert!(files.len() > 300 && found.is_empty(), "{} files\n{}", files.len(), found.join("\n"));
}

/// The trait of a part knows what it is given and its capabilities; none of these know the trait.
#[test]
fn what_a_part_is_given_does_not_know_the_part() {
    let of_model = |s: &&Source| s.module == "model";
    let apart = ["context.rs", "blocks.rs", "params.rs", "lanes.rs", "erased.rs"];
    let (mut wrong, mut seen) = (Vec::new(), 0);
    for source in sources().iter().filter(of_model) {
        let capability = source.path.components().any(|c| c.as_os_str() == "capability");
        if !capability && !apart.iter().any(|name| source.path.ends_with(format!("model/{name}"))) {
            continue;
        }
        seen += 1;
        for (number, line) in source.lines.iter().filter(|(_, l)| l.contains("part::") || l.contains("erasure::")) {
            wrong.push(format!("{}:{number}: {line}", source.path.display()));
        }
    }
    assert!(wrong.is_empty() && seen >= 15, "{seen}\n{}", wrong.join("\n"));
}

/// An analysis knows no concrete part: the word of a kind is no literal in its code.
#[test]
fn kinds_of_parts_are_named_in_the_registry_only() {
    let kinds: Vec<&str> = laval::parts::registry().iter().map(|k| k.info.kind).collect();
    assert!(kinds.contains(&"disc") && kinds.len() >= 9);
    let mut wrong = Vec::new();
    for source in sources().iter().filter(|s| !matches!(s.module.as_str(), "parts" | "lib")) {
        for (number, line) in &source.lines {
            if let Some(kind) = named(line, &kinds) {
                wrong.push(format!("{}:{number}: \"{kind}\"", source.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn named<'a>(line: &str, kinds: &[&'a str]) -> Option<&'a str> {
    kinds.iter().copied().find(|k| line.contains(&format!("\"{k}\"")))
}

/// An analysis finds what it needs of a part through a capability, not by the name of a parameter. Names that blocks and studies have too are left out, unless they stand in a path.
#[test]
fn parameters_of_parts_are_named_by_no_analysis() {
    let catalog = laval::file::catalog();
    let of_parts = || laval::parts::registry().into_iter().flat_map(|k| k.info.fields.into_iter().map(|f| f.name));
    let others =
        || catalog.studies.iter().chain(catalog.blocks.iter().flat_map(|b| &b.kinds)).flat_map(|k| k.fields.iter().map(|f| f.name));
    let own: Vec<&str> = of_parts().filter(|n| n.contains('_') && !others().any(|o| o == *n)).collect();
    let paths: Vec<String> = of_parts().map(|n| format!("}}.{n}\"")).collect();
    assert!(own.contains(&"cavity_radius") && paths.iter().any(|p| p == "}.density\""));
    let mut wrong = Vec::new();
    for source in sources().iter().filter(|s| matches!(s.module.as_str(), "study" | "solve")) {
        for (number, line) in &source.lines {
            if let Some(name) = named(line, &own).or_else(|| paths.iter().find(|p| line.contains(*p)).map(String::as_str)) {
                wrong.push(format!("{}:{number}: {name}", source.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every part's file runs the conformance suite.
#[test]
fn every_part_runs_the_conformance_suite() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../laval-model/src/parts");
    for kind in laval::parts::registry() {
        let files = [folder.join(format!("{}.rs", kind.info.kind)), folder.join(kind.info.kind).join("mod.rs")];
        let text = files.iter().find_map(|f| fs::read_to_string(f).ok()).unwrap_or_else(|| panic!("no file for \"{}\"", kind.info.kind));
        assert!(text.contains("conformance! {"), "\"{}\" does not run the conformance suite", kind.info.kind);
        for item in ["Equations", "Symbols", "Validity", "Sources"] {
            assert!(text.contains(&format!("//! {item}")), "the header of \"{}\" lacks {item}", kind.info.kind);
        }
    }
}

#[test]
fn the_rules_can_be_broken() {
    assert_eq!(forbidden("model", "use crate::parts::disc::Disc;").as_deref(), Some("parts"));
    assert_eq!(forbidden("report", "let x = crate::study::registry();").as_deref(), Some("study"));
    assert_eq!(forbidden("solve", "use crate::{model::part::At, outcome::Outcome};").as_deref(), Some("outcome"));
    assert_eq!(forbidden("solve", "use laval_model::parts::disc::Disc;").as_deref(), Some("parts"));
    assert_eq!(forbidden("parts", "use crate::solve::X;").as_deref(), Some("solve"));
    assert_eq!(forbidden("study", "use crate::{diagnostic::Diagnostic, outcome::Outcome};"), None);
    let list = code("use crate::{\n    model::part::{At, Rows},\n    outcome::Outcome,\n};\nfn f() {}");
    assert_eq!(list.len(), 2);
    assert_eq!(forbidden("solve", &list[0].1).as_deref(), Some("outcome"));
    assert_eq!(named("    \"disc\" => 1,", &["disc"]), Some("disc"));
    assert_eq!(named("    .help(\"kind = \\\"disc\\\"\")", &["disc"]), None);
    assert_eq!(code("let a = 1;\n// crate::x\n#[cfg(test)]\nmod tests {\nuse crate::parts;\n}").len(), 1);
}

#[test]
fn crates_without_unsafe_code_forbid_it() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut with = Vec::new();
    for entry in fs::read_dir(&crates).unwrap() {
        let root = entry.unwrap().path().join("src");
        let mut open = vec![root.clone()];
        let mut found = false;
        while let Some(folder) = open.pop() {
            for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
                if path.is_dir() {
                    open.push(path);
                } else if path.extension().is_some_and(|e| e == "rs") {
                    let text = fs::read_to_string(&path).unwrap();
                    let word = |l: &str| l.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == "unsafe");
                    found |= text.lines().map(|l| l.split("//").next().unwrap_or_default()).any(word);
                }
            }
        }
        let name = root.parent().unwrap().file_name().unwrap().to_string_lossy().into_owned();
        let forbids = fs::read_to_string(root.join("lib.rs")).unwrap().contains("#![forbid(unsafe_code)]");
        assert!(found != forbids, "{name}: unsafe code {found}, forbidden {forbids}");
        if found {
            with.push(name);
        }
    }
    with.sort();
    assert_eq!(with, ["laval-num", "laval-py", "laval-solve"]);
}
