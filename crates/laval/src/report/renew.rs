//! Writing a report over an earlier one: what laval itself wrote for studies that are gone is taken away, nothing else.

use super::Report;
use super::write::{Format, WriteError, Written, place, write_all};
use crate::outcome::End;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// The list of the files laval wrote into a folder.
const MANIFEST: &str = "manifest.json";

/// A file of an earlier run.
struct Entry {
    /// Name of its study; `None` for what belongs to all.
    study: Option<String>,
    hash: String,
}

/// As [`write`](super::write()), into a folder that may hold the results of earlier runs. `studies` names every study of the machine file, run or not.
/// Afterwards no file stands there that laval wrote earlier for a study which is no longer in the file, or for a table or figure that a study run
/// now no longer has; a refused study keeps what it had. A file laval did not write, or that was changed since, stays. `manifest.json` keeps the list.
///
/// # Errors
/// As [`write`](super::write()).
pub fn renew(dir: &Path, report: &Report, formats: &[Format], studies: &[&str]) -> Result<Vec<PathBuf>, WriteError> {
    let earlier = read(dir);
    let written = write_all(dir, report, formats)?;
    let mut files: BTreeMap<String, Entry> = BTreeMap::new();
    for w in &written {
        let study = w.study.map(|k| report.outcomes[k].name.clone());
        files.insert(w.name.clone(), Entry { study, hash: hash(&w.content) });
    }
    for (name, entry) in earlier {
        // some file systems do not tell capitals
        if files.keys().any(|k| k.to_lowercase() == name.to_lowercase()) {
            continue;
        }
        let gone = |s: &String| !studies.contains(&s.as_str());
        let replaced = |s: &String| {
            let format = formats.iter().any(|f| name.ends_with(&format!(".{}", f.word())));
            // a study that was refused has not replaced what it had
            format && report.outcomes.iter().any(|o| &o.name == s && o.end != End::Refused)
        };
        if entry.study.as_ref().is_some_and(|s| gone(s) || replaced(s)) {
            remove(dir, &name, &entry.hash);
        } else {
            files.insert(name, entry);
        }
    }
    let list: Vec<Value> = files.iter().map(|(name, e)| json!({ "file": name, "study": e.study, "hash": e.hash })).collect();
    let about = "the files laval wrote here; a later run removes those of studies that are no longer in the machine file";
    let text = format!("{:#}\n", json!({ "program": "laval", "about": about, "files": list }));
    place(dir, MANIFEST, text.as_bytes()).map_err(|(path, source)| WriteError::Io { path, source, written: paths(dir, &written) })?;
    Ok(paths(dir, &written))
}

fn paths(dir: &Path, written: &[Written]) -> Vec<PathBuf> {
    written.iter().map(|w| dir.join(&w.name)).collect()
}

/// The list of an earlier run; nothing when there is none that can be read.
fn read(dir: &Path) -> BTreeMap<String, Entry> {
    let text = fs::read_to_string(dir.join(MANIFEST)).unwrap_or_default();
    let all: Value = serde_json::from_str(&text).unwrap_or_default();
    if all["program"] != "laval" {
        return BTreeMap::new();
    }
    let entry = |v: &Value| {
        let hash = v["hash"].as_str()?.to_string();
        Some((v["file"].as_str()?.to_string(), Entry { study: v["study"].as_str().map(String::from), hash }))
    };
    all["files"].as_array().into_iter().flatten().filter_map(entry).collect()
}

/// Removes a file inside `dir` that still holds what was written; and its folder, when that is empty then.
fn remove(dir: &Path, name: &str, written: &str) {
    let path = dir.join(name);
    let plain = Path::new(name).components().all(|c| matches!(c, Component::Normal(_)));
    let inside = || Some(path.canonicalize().ok()?.starts_with(dir.canonicalize().ok()?));
    let own = plain
        && fs::symlink_metadata(&path).is_ok_and(|m| m.is_file())
        && inside() == Some(true)
        && fs::read(&path).is_ok_and(|content| hash(&content) == written);
    // what cannot be removed stays: it is in nobody's way
    if own
        && fs::remove_file(&path).is_ok()
        && let Some(folder) = path.parent().filter(|f| *f != dir)
    {
        let _ = fs::remove_dir(folder);
    }
}

/// FNV-1a of 64 bits: tells a changed file.
fn hash(content: &[u8]) -> String {
    let h = content.iter().fold(0xcbf2_9ce4_8422_2325u64, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0000_0100_0000_01b3));
    format!("{h:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Outcome, Table};

    fn report(names: &[&str]) -> Report {
        let table = |name: &str| Table::new("t", "").text("of", "", vec![name.into()]).build().unwrap();
        Report { outcomes: names.iter().map(|n| Outcome::new("k", *n).table(table(n))).collect(), ..Report::default() }
    }

    struct Dir(PathBuf);
    impl Dir {
        fn new(name: &str) -> Dir {
            let dir = std::env::temp_dir().join(format!("laval-renew-{}-{name}", std::process::id()));
            let _ = fs::remove_dir_all(&dir);
            Dir(dir)
        }
        fn has(&self, file: &str) -> bool {
            self.0.join(file).exists()
        }
    }
    impl Drop for Dir {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }
    const FORMATS: &[Format] = &[Format::Csv, Format::Json];

    #[test]
    fn results_of_studies_that_are_gone_are_removed() {
        let d = Dir::new("gone");
        renew(&d.0, &report(&["a", "b", "c"]), FORMATS, &["a", "b", "c"]).unwrap();
        renew(&d.0, &report(&["b"]), FORMATS, &["b", "c"]).unwrap();
        assert!(!d.has("a") && d.has("b/t.csv") && d.has("results.json"));
        // in the file but not asked for this time
        assert!(d.has("c/t.csv"));
        renew(&d.0, &report(&["b"]), FORMATS, &["b"]).unwrap();
        assert!(!d.has("c"), "remembered over a run that did not touch it");
    }

    #[test]
    fn a_refused_study_keeps_what_it_had() {
        let d = Dir::new("refused");
        renew(&d.0, &report(&["a"]), FORMATS, &["a"]).unwrap();
        let refused = Report { outcomes: vec![Outcome::new("k", "a").end(End::Refused)], ..Report::default() };
        renew(&d.0, &refused, FORMATS, &["a"]).unwrap();
        assert!(d.has("a/t.csv"));
    }

    #[test]
    fn foreign_and_changed_files_stay() {
        let d = Dir::new("foreign");
        renew(&d.0, &report(&["a", "b"]), FORMATS, &["a", "b"]).unwrap();
        fs::write(d.0.join("a/notes.txt"), "mine").unwrap();
        fs::write(d.0.join("b/t.csv"), "mine now").unwrap();
        renew(&d.0, &report(&[]), FORMATS, &[]).unwrap();
        assert!(d.has("a/notes.txt") && !d.has("a/t.csv") && d.has("b/t.csv"));
    }

    #[test]
    fn a_list_that_points_elsewhere_is_not_followed() {
        let d = Dir::new("list");
        let outside = Dir::new("list-outside");
        fs::create_dir_all(&outside.0).unwrap();
        fs::create_dir_all(&d.0).unwrap();
        let precious = outside.0.join("precious");
        fs::write(&precious, "x").unwrap();
        let up = format!("../{}/precious", outside.0.file_name().unwrap().to_str().unwrap());
        let list = [up.as_str(), precious.to_str().unwrap()].map(|f| json!({ "file": f, "study": "a", "hash": hash(b"x") }));
        fs::write(d.0.join(MANIFEST), json!({ "program": "laval", "files": list }).to_string()).unwrap();
        renew(&d.0, &report(&["b"]), FORMATS, &["b"]).unwrap();
        assert!(precious.exists() && d.has("b/t.csv"));
        fs::write(d.0.join(MANIFEST), "{ not json").unwrap();
        renew(&d.0, &report(&["c"]), FORMATS, &["c"]).unwrap();
        assert!(d.has("b/t.csv") && d.has("c/t.csv"));
    }

    #[test]
    fn a_table_that_a_study_no_longer_has_goes() {
        let d = Dir::new("table");
        renew(&d.0, &report(&["a"]), FORMATS, &["a"]).unwrap();
        let without = Report { outcomes: vec![Outcome::new("k", "a")], ..Report::default() };
        renew(&d.0, &without, &[Format::Json], &["a"]).unwrap();
        assert!(d.has("a/t.csv"), "that format was not asked for");
        renew(&d.0, &without, FORMATS, &["a"]).unwrap();
        assert!(!d.has("a"));
    }
}
