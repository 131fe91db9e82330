//! Pages of theory: what comments cite is there, and what the pages link to is there.

use std::path::{Component, Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Files with one of these endings below a folder of the repository, by their path from its root.
fn files(folder: &str, endings: &[&str]) -> Vec<PathBuf> {
    let (mut folders, mut found) = (vec![PathBuf::from(folder)], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(root().join(&folder)).unwrap() {
            let path = folder.join(entry.unwrap().file_name());
            if root().join(&path).is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| endings.iter().any(|x| e == *x)) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(root().join(path)).unwrap().replace('\r', "")
}

/// Names of the sections of a page, as they stand in links.
fn sections(page: &str) -> Vec<String> {
    let mut fenced = false;
    let mut found = Vec::new();
    for line in page.lines() {
        fenced ^= line.starts_with("```");
        if !fenced && line.starts_with('#') {
            let title = line.trim_start_matches('#').trim().to_lowercase();
            found.push(
                title.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c)).map(|c| if c == ' ' { '-' } else { c }).collect(),
            );
        }
    }
    found
}

/// Pages that a comment names, with their sections: every word that ends with `.md` or `.md#section`.
fn cited(comment: &str) -> Vec<(String, Option<String>)> {
    let words = comment.split(|c: char| !(c.is_alphanumeric() || "./#_-".contains(c))).map(|w| w.trim_end_matches(['.', '-']));
    words
        .filter_map(|w| {
            let (path, section) = w.split_once('#').map_or((w, None), |(p, s)| (p, Some(s.to_string())));
            path.strip_suffix(".md").filter(|stem| !stem.is_empty()).map(|_| (path.to_string(), section))
        })
        .collect()
}

/// What is wrong with a page and its section; names are from the root of the repository.
fn missing(page: &Path, section: Option<&str>) -> Option<String> {
    let inside = page.components().all(|c| matches!(c, Component::Normal(_)));
    match section {
        _ if !inside || !root().join(page).is_file() => Some(format!("{} is not in the repository", page.display())),
        Some(s) if !sections(&text(page)).iter().any(|x| x == s) => Some(format!("{} has no section {s}", page.display())),
        _ => None,
    }
}

/// A path with `..` taken out.
fn plain(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir if out.pop() => {}
            other => out.push(other),
        }
    }
    out
}

/// Two names in comments that stand for any page: cases of the gallery link to each other by `../topic/case.md`.
const ANY: [&str; 2] = ["../topic/case.md", "README.md"];

#[test]
fn every_page_that_a_comment_cites_is_there() {
    let (mut wrong, mut seen) = (Vec::new(), 0);
    for path in files("crates", &["rs", "toml"]) {
        let mark = if path.extension().is_some_and(|e| e == "rs") { "//" } else { "#" };
        for (i, line) in text(&path).lines().enumerate() {
            let Some((_, comment)) = line.split_once(mark) else { continue };
            for (page, section) in cited(comment) {
                if ANY.contains(&page.as_str()) {
                    continue;
                }
                seen += usize::from(page.starts_with("docs/theory/"));
                wrong.extend(missing(Path::new(&page), section.as_deref()).map(|m| format!("{}:{}: {m}", path.display(), i + 1)));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(seen > 60, "only {seen} comments point to pages of theory");
}

#[test]
fn links_of_the_pages_lead_somewhere() {
    let mut wrong = Vec::new();
    for path in files("docs", &["md"]).into_iter().chain(["README.md", "CONTRIBUTING.md", "validation/README.md"].map(PathBuf::from)) {
        let whole = text(&path);
        for link in whole.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(link, _)| link) {
            if link.contains("://") {
                continue;
            }
            let (page, section) = link.split_once('#').map_or((link, None), |(p, s)| (p, Some(s)));
            let page = if page.is_empty() { path.clone() } else { plain(&path.parent().unwrap().join(page)) };
            let lost = if page.extension().is_some_and(|e| e == "md") {
                missing(&page, section)
            } else {
                (!root().join(&page).exists()).then(|| format!("{} is not in the repository", page.display()))
            };
            wrong.extend(lost.map(|m| format!("{}: {m}", path.display())));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// What every page of theory says, beside its equations.
#[test]
fn pages_of_theory_are_listed_and_whole() {
    let index = text(Path::new("docs/theory/README.md"));
    let mut wrong = Vec::new();
    for path in files("docs/theory", &["md"]) {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if name == "README.md" {
            continue;
        }
        if !index.contains(&format!("]({name})")) {
            wrong.push(format!("the index does not list {name}"));
        }
        let page = text(&path);
        let named = sections(&page);
        wrong.extend(
            ["validity", "sources"].iter().filter(|s| !named.iter().any(|x| x == *s)).map(|s| format!("{name} has no section {s}")),
        );
        if !page.contains("](../../crates/") {
            wrong.push(format!("{name} names no file that implements it"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn citations_are_read_as_they_are_written() {
    assert_eq!(cited(" Sources: `docs/a.md#b-c`, `docs/d.md`; x.md.").len(), 3);
    assert_eq!(cited("`docs/a.md#b-c`.")[0], ("docs/a.md".to_string(), Some("b-c".to_string())));
    assert!(cited("`*.md` and model.rs").is_empty());
    assert!(missing(Path::new("theory/separation.md"), None).is_some() && missing(Path::new("../README.md"), None).is_some());
    assert!(missing(Path::new("docs/theory/separation.md"), Some("cups")).is_none());
    assert!(missing(Path::new("docs/theory/separation.md"), Some("saucers")).is_some());
    assert_eq!(sections("# Flow, plane\n```\n# no\n```\n## a - b\n"), ["flow-plane", "a---b"]);
}
