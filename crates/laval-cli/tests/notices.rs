//! `THIRD-PARTY-NOTICES.md` names every library that is linked into the program or the Python package, on any system, with its licence.
//! `LAVAL_WRITE_NOTICES=1 cargo test -p laval-cli notices` writes it anew.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What Cargo knows of the workspace.
fn metadata(root: &Path) -> Value {
    let run = |more: &[&str]| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["metadata", "--format-version", "1", "--locked"]).args(more).current_dir(root).output().unwrap()
    };
    // without a network when all is there
    let offline = run(&["--offline"]);
    let said = if offline.status.success() { offline } else { run(&[]) };
    assert!(said.status.success(), "{}", String::from_utf8_lossy(&said.stderr));
    serde_json::from_slice(&said.stdout).unwrap()
}

fn text<'a>(v: &'a Value, key: &str) -> &'a str {
    v[key].as_str().unwrap_or_default()
}

/// The packages that `laval-cli` and `laval-py` need when they run, by name and version, without those of this workspace.
fn linked(all: &Value) -> BTreeMap<(String, String), &Value> {
    let list = |v: &'static str| all[v].as_array().unwrap();
    let packages: BTreeMap<&str, &Value> = list("packages").iter().map(|p| (text(p, "id"), p)).collect();
    let nodes: BTreeMap<&str, &Value> = all["resolve"]["nodes"].as_array().unwrap().iter().map(|n| (text(n, "id"), n)).collect();
    let macros = |id: &str| {
        let kinds = packages[id]["targets"].as_array().unwrap().iter().flat_map(|t| t["kind"].as_array().unwrap());
        kinds.into_iter().any(|k| k == "proc-macro")
    };
    let mut open: Vec<&str> =
        packages.values().filter(|p| p["name"] == "laval-cli" || p["name"] == "laval-py").map(|p| text(p, "id")).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = open.pop() {
        // macros run while building and are no part of the program
        if macros(id) || !seen.insert(id) {
            continue;
        }
        let needed = |d: &&Value| d["dep_kinds"].as_array().unwrap().iter().any(|k| k["kind"].is_null());
        open.extend(nodes[id]["deps"].as_array().unwrap().iter().filter(needed).map(|d| text(d, "pkg")));
    }
    let foreign = seen.into_iter().map(|id| packages[id]).filter(|p| !p["source"].is_null());
    foreign.map(|p| ((text(p, "name").to_string(), text(p, "version").to_string()), p)).collect()
}

/// Files with the terms of a package; of several licences to choose from, those of MIT where they stand alone.
fn terms(package: &Value) -> Vec<String> {
    let folder = Path::new(text(package, "manifest_path")).parent().unwrap();
    let mut names: Vec<String> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    let starts = |n: &str, words: &[&str]| words.iter().any(|w| n.to_lowercase().starts_with(w));
    names.retain(|n| starts(n, &["license", "licence", "copying", "notice", "unlicense", "copyright"]) && folder.join(n).is_file());
    let mit = |n: &String| n.to_lowercase().contains("mit");
    let license = text(package, "license");
    let choice = (license.contains(" OR ") || license.contains('/')) && !license.contains(" AND ");
    if choice && names.iter().any(mit) {
        names.retain(|n| mit(n) || starts(n, &["notice", "copyright"]));
    }
    let read = |n: &String| String::from_utf8_lossy(&fs::read(folder.join(n)).unwrap()).into_owned();
    let tidy = |t: String| t.lines().map(str::trim_end).collect::<Vec<_>>().join("\n").trim_matches('\n').to_string();
    names.iter().map(read).map(tidy).filter(|t| !t.is_empty()).collect()
}

fn notices(all: &Value) -> String {
    let mut out = String::from(
        "# Notices of third parties\n\nThe program `laval` and its Python package contain the libraries below. Each is under the licence named with it; numbers in brackets lead to the \
         texts behind the list. Where a library may be had under one of several licences, laval takes MIT when that is one of them. A package without a \
         number brings no file with its terms.\n\n",
    );
    let mut texts: Vec<String> = Vec::new();
    for ((name, version), package) in linked(all) {
        let mut numbers = Vec::new();
        for text in terms(package) {
            let at = texts.iter().position(|t| *t == text).unwrap_or_else(|| {
                texts.push(text);
                texts.len() - 1
            });
            numbers.push(format!("[{}]", at + 1));
        }
        let by: Vec<&str> = package["authors"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        // a package without a file says who wrote it in its manifest at most
        let by = if numbers.is_empty() && !by.is_empty() { format!(", by {}", by.join(", ")) } else { String::new() };
        let place = text(package, "repository");
        let license = text(package, "license");
        let _ = writeln!(out, "- {name} {version}: {license}{by} {} {place}", numbers.join(" "));
    }
    for (i, text) in texts.iter().enumerate() {
        let _ = write!(out, "\n## [{}]\n\n````text\n{text}\n````\n", i + 1);
    }
    out
}

#[test]
fn the_notices_name_every_library_of_the_program() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = notices(&metadata(&root));
    let path = root.join("THIRD-PARTY-NOTICES.md");
    if std::env::var_os("LAVAL_WRITE_NOTICES").is_some() {
        fs::write(&path, &text).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(found == text, "run LAVAL_WRITE_NOTICES=1 cargo test -p laval-cli notices");
    assert!(text.lines().filter(|l| l.starts_with("- ")).count() > 50);
}
