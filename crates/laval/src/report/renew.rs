//! Writing a report over an earlier one: what laval itself wrote for studies that are gone is taken away, nothing else.

use super::Report;
use super::write::{Composed, Content, Format, WriteError, compose, folders, write_all};
use crate::diagnostic::Diagnostic;
use crate::outcome::End;
use crate::output_folder::{Held, Lasting, tidy, write_whole};
use crate::text;
use crate::text::Text;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

/// The list of the files laval wrote into a folder.
const MANIFEST: &str = "manifest.json";

/// A file of an earlier run.
#[derive(Clone)]
struct Entry {
    /// Name of its study; `None` for what belongs to all.
    study: Option<String>,
    /// What it holds; while files are being written, one of these.
    hashes: Vec<String>,
    /// Hash of the input it follows from.
    input: Option<String>,
}

/// Takes the folder of results beside other processes that compute parts of long studies; none of them writes what [`renew`] writes.
///
/// # Errors
/// When it cannot be made or written, or a run holds it.
pub fn share(dir: &Path) -> Result<Held, Diagnostic> {
    Held::share(dir)
}

/// Takes the folder that a report will be written into, for the studies of these names: before anything is computed it is certain that nobody else writes
/// it, that all of it can be written, and that nothing of another program stands in the way. What a killed run left unfinished is removed.
///
/// # Errors
/// When one of these does not hold.
pub fn prepare(dir: &Path, studies: &[&str]) -> Result<Held, Diagnostic> {
    let held = Held::take(dir)?;
    let blocked = |path: &Path, what: Text| {
        let d = Diagnostic::error("folder.taken", text!("{path} is {what}, where results are to be written", path = path.display(), what));
        Err(d.help(text!("move it elsewhere, or name another folder with --out")))
    };
    let earlier = match read(dir) {
        Earlier::Ours(files) => files,
        Earlier::None => BTreeMap::new(),
        Earlier::Foreign => return blocked(&dir.join(MANIFEST), text!("a file of another program")),
    };
    for name in [MANIFEST, "results.json", "report.html"] {
        let path = dir.join(name);
        if path.is_dir() {
            return blocked(&path, text!("a folder"));
        }
        if name != MANIFEST && earlier.is_empty() && foreign(&path) {
            return blocked(&path, text!("a file of another program"));
        }
    }
    let listed = earlier.keys().filter(|name| plain(name)).filter_map(|name| Some(name.split_once('/')?.0.to_string()));
    let all: BTreeSet<String> = folders(studies.iter().copied()).into_iter().chain(listed).chain(["figures".to_string()]).collect();
    for folder in all.into_iter().map(|name| dir.join(name)) {
        if folder.is_dir() {
            tidy(&folder)?;
        } else if folder.symlink_metadata().is_ok() {
            return blocked(&folder, text!("no folder"));
        }
    }
    Ok(held)
}

/// As [`write`](super::write()), into a folder that may hold the results of earlier runs; hold it meanwhile ([`prepare`]). Afterwards no file stands there
/// that laval wrote earlier for a study which is not among `report.studies`, or for a table or figure that a study run now no longer has; a refused study
/// keeps what it had. A file laval did not write, or that was changed since, stays. `manifest.json` keeps the list, and says whether it is complete: a
/// process killed on the way leaves files of two runs side by side.
///
/// # Errors
/// As [`write`](super::write()).
pub fn renew(dir: &Path, report: &Report, formats: &[Format]) -> Result<Vec<PathBuf>, WriteError> {
    let earlier = match read(dir) {
        Earlier::Ours(files) => files,
        Earlier::None | Earlier::Foreign => BTreeMap::new(),
    };
    let composed = compose(report, formats)?;
    let now: BTreeMap<String, Entry> = composed.iter().map(|c| (c.name.clone(), entry(c, report))).collect();
    let mut underway = now.clone();
    for (name, old) in &earlier {
        let all = underway.entry(name.clone()).or_insert_with(|| Entry { hashes: Vec::new(), ..old.clone() });
        all.hashes.extend(old.hashes.clone());
    }
    let changes = underway.values().any(|e| e.hashes.iter().any(|h| *h != e.hashes[0]));
    if changes || underway.len() > earlier.len() {
        list(dir, &underway, false)?;
    }
    let written = write_all(dir, &composed)?;
    let mut files = now;
    for (name, entry) in earlier {
        // some file systems do not tell capitals
        if files.keys().any(|k| k.to_lowercase() == name.to_lowercase()) {
            continue;
        }
        let gone = |s: &String| !report.studies().contains(&s.as_str());
        let replaced = |s: &String| {
            let format = formats.iter().any(|f| name.ends_with(&format!(".{}", f.word())));
            // a study that was refused has not replaced what it had
            format && report.outcomes.iter().any(|o| &o.name == s && o.end != End::Refused)
        };
        if entry.study.as_ref().is_some_and(|s| gone(s) || replaced(s)) {
            remove(dir, &name, &entry.hashes);
        } else {
            files.insert(name, entry);
        }
    }
    list(dir, &files, true)?;
    Ok(written)
}

/// The studies whose files in the folder follow from another input than those of this report, because they were not run with it.
pub fn outdated(dir: &Path, report: &Report) -> Vec<String> {
    let Earlier::Ours(files) = read(dir) else { return Vec::new() };
    let other = |e: &Entry| e.input.as_ref().is_some_and(|i| *i != report.provenance.input_hash);
    let studies: BTreeSet<String> = files.into_values().filter(other).filter_map(|e| e.study).collect();
    studies.into_iter().collect()
}

fn entry(file: &Composed, report: &Report) -> Entry {
    let input = &report.provenance.input_hash;
    Entry {
        study: file.study.map(|k| report.outcomes[k].name.clone()),
        hashes: vec![hash_of(&file.content)],
        input: (!input.is_empty()).then(|| input.clone()),
    }
}

/// Writes the list.
fn list(dir: &Path, files: &BTreeMap<String, Entry>, complete: bool) -> Result<(), WriteError> {
    let one = |(name, e): (&String, &Entry)| {
        let hash = if let [one] = e.hashes.as_slice() { json!(one) } else { json!(e.hashes) };
        json!({ "file": name, "study": e.study, "hash": hash, "input": e.input })
    };
    let list: Vec<Value> = files.iter().map(one).collect();
    let about = "the files laval wrote here; a later run removes those of studies that are no longer in the machine file";
    let text = format!("{:#}\n", json!({ "program": "laval", "about": about, "complete": complete, "files": list }));
    let io = |(path, source)| WriteError::Io { path, source, written: Vec::new() };
    fs::create_dir_all(dir).map_err(|e| io((dir.to_path_buf(), e)))?;
    let path = dir.join(MANIFEST);
    write_whole(&path, crate::plain::lines(&text).as_bytes(), Lasting::PowerLoss).map_err(|e| io((path, e)))
}

/// What the list of an earlier run says.
enum Earlier {
    /// There is none, or none that can be read.
    None,
    /// Another program wrote a file of that name.
    Foreign,
    Ours(BTreeMap<String, Entry>),
}

/// A file beside no list of ours that does not look like one of ours.
fn foreign(path: &Path) -> bool {
    let Ok(bytes) = fs::read(path) else { return false };
    let text = String::from_utf8_lossy(&bytes);
    let ours = match path.extension().and_then(|e| e.to_str()) {
        Some("html") => text.contains("laval report</title>"),
        _ => serde_json::from_str::<Value>(&text).is_ok_and(|v| v["provenance"]["program"] == "laval" || v["program"] == "laval"),
    };
    !ours
}

fn read(dir: &Path) -> Earlier {
    let text = fs::read_to_string(dir.join(MANIFEST)).unwrap_or_default();
    let Ok(all) = serde_json::from_str::<Value>(&text) else { return Earlier::None };
    if all["program"] != "laval" {
        return Earlier::Foreign;
    }
    let entry = |v: &Value| {
        let words = |v: &Value| v.as_str().map(String::from);
        let hashes =
            v["hash"].as_array().map_or_else(|| words(&v["hash"]).into_iter().collect(), |all| all.iter().filter_map(words).collect());
        Some((words(&v["file"])?, Entry { study: words(&v["study"]), hashes, input: words(&v["input"]) }))
    };
    Earlier::Ours(all["files"].as_array().into_iter().flatten().filter_map(entry).collect())
}

/// A name that leads nowhere else.
fn plain(name: &str) -> bool {
    Path::new(name).components().all(|c| matches!(c, Component::Normal(_)))
}

/// Removes a file inside `dir` that still holds what was written; and its folder, when that is empty then.
fn remove(dir: &Path, name: &str, written: &[String]) {
    let path = dir.join(name);
    let inside = || Some(path.canonicalize().ok()?.starts_with(dir.canonicalize().ok()?));
    let own = plain(name)
        && fs::symlink_metadata(&path).is_ok_and(|m| m.is_file())
        && inside() == Some(true)
        && fs::read(&path).is_ok_and(|content| written.contains(&hash(&content)));
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
    let mut sum = Sum::new();
    sum.add(content);
    sum.text()
}

/// The same of content that is made while it is summed.
fn hash_of(content: &Content) -> String {
    let mut sum = Sum::new();
    // a sum does not fail
    let _ = content.write(&mut sum);
    sum.text()
}

struct Sum(u64);

impl Sum {
    fn new() -> Sum {
        Sum(0xcbf2_9ce4_8422_2325)
    }
    fn add(&mut self, bytes: &[u8]) {
        self.0 = bytes.iter().fold(self.0, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0000_0100_0000_01b3));
    }
    fn text(&self) -> String {
        format!("{:016x}", self.0)
    }
}

impl io::Write for Sum {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.add(bytes);
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Axis, Figure, Line, Outcome, Panel, Table};

    fn report(names: &[&str], all: &[&str]) -> Report {
        let table = |name: &str| Table::new("t", "").float("x", "", "", vec![0.0]).text("of", "", vec![name.into()]).build().unwrap();
        let outcomes = names.iter().map(|n| Outcome::new("k", *n).table(table(n))).collect();
        Report { studies: all.iter().map(|s| s.to_string()).collect(), outcomes, ..Report::default() }
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
    fn files_of_other_programs_are_left_alone() {
        for (name, own) in
            [("results.json", "{\"provenance\": {\"program\": \"laval\"}}"), ("report.html", "<title>m \u{b7} laval report</title>")]
        {
            let d = Dir::new(&format!("foreign-{name}"));
            fs::create_dir_all(&d.0).unwrap();
            fs::write(d.0.join(name), "results of somebody else").unwrap();
            let refused = prepare(&d.0, &["a"]).unwrap_err();
            assert_eq!(refused.code, "folder.taken", "{refused}");
            assert_eq!(fs::read_to_string(d.0.join(name)).unwrap(), "results of somebody else");
            fs::write(d.0.join(name), own).unwrap();
            prepare(&d.0, &["a"]).unwrap();
        }
    }

    #[test]
    fn results_of_studies_that_are_gone_are_removed() {
        let d = Dir::new("gone");
        renew(&d.0, &report(&["a", "b", "c"], &["a", "b", "c"]), FORMATS).unwrap();
        renew(&d.0, &report(&["b"], &["b", "c"]), FORMATS).unwrap();
        assert!(!d.has("a") && d.has("b/t.csv") && d.has("results.json"));
        // in the file but not requested this time
        assert!(d.has("c/t.csv"));
        renew(&d.0, &report(&["b"], &["b"]), FORMATS).unwrap();
        assert!(!d.has("c"), "remembered over a run that did not touch it");
    }

    #[test]
    fn a_refused_study_keeps_what_it_had() {
        let d = Dir::new("refused");
        renew(&d.0, &report(&["a"], &["a"]), FORMATS).unwrap();
        let refused = Report { outcomes: vec![Outcome::new("k", "a").end(End::Refused)], ..Report::default() };
        renew(&d.0, &refused, FORMATS).unwrap();
        assert!(d.has("a/t.csv"));
    }

    #[test]
    fn foreign_and_changed_files_stay() {
        let d = Dir::new("foreign");
        renew(&d.0, &report(&["a", "b"], &["a", "b"]), FORMATS).unwrap();
        fs::write(d.0.join("a/notes.txt"), "mine").unwrap();
        fs::write(d.0.join("b/t.csv"), "mine now").unwrap();
        renew(&d.0, &report(&[], &[]), FORMATS).unwrap();
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
        renew(&d.0, &report(&["b"], &["b"]), FORMATS).unwrap();
        assert!(precious.exists() && d.has("b/t.csv"));
        fs::write(d.0.join(MANIFEST), "{ not json").unwrap();
        renew(&d.0, &report(&["c"], &["c"]), FORMATS).unwrap();
        assert!(d.has("b/t.csv") && d.has("c/t.csv"));
    }

    #[test]
    fn a_table_that_a_study_no_longer_has_goes() {
        let d = Dir::new("table");
        renew(&d.0, &report(&["a"], &["a"]), FORMATS).unwrap();
        let without = Report { outcomes: vec![Outcome::new("k", "a")], ..Report::default() };
        renew(&d.0, &without, &[Format::Json]).unwrap();
        assert!(d.has("a/t.csv"), "that format was not requested");
        renew(&d.0, &without, FORMATS).unwrap();
        assert!(!d.has("a"));
    }

    #[test]
    fn a_study_run_alone_keeps_its_own_files() {
        let all = ["a b", "a-b", "A B", "c", "c d", "figures", "results.json"];
        let d = Dir::new("alone");
        let names = |studies: &[&str]| -> Vec<PathBuf> {
            let mut report = report(studies, &all);
            for o in &mut report.outcomes {
                for name in ["d-e", "e", "d"] {
                    o.figures.push(Figure::new(name, "", "").panel(Panel::new(Axis::new("", "")).mark(Line::new("t", "x", "x"))));
                }
            }
            let files = compose(&report, &[Format::Csv, Format::Svg]);
            files.unwrap().into_iter().map(|c| d.0.join(c.name.to_lowercase())).collect()
        };
        let together = names(&all);
        let alone: Vec<PathBuf> = all.iter().flat_map(|s| names(&[s])).collect();
        assert_eq!(together, alone);
        assert_eq!(BTreeSet::from_iter(&together).len(), together.len());
        // and no study of the file is taken for one that is gone
        renew(&d.0, &report(&all, &all), FORMATS).unwrap();
        for study in all {
            renew(&d.0, &report(&[study], &all), FORMATS).unwrap();
        }
        for (study, folder) in all.iter().zip(folders(all)) {
            assert!(fs::read_to_string(d.0.join(folder).join("t.csv")).unwrap().ends_with(&format!("{study}\n")));
        }
    }

    #[test]
    fn files_of_a_run_that_was_killed_are_still_known() {
        let d = Dir::new("killed");
        renew(&d.0, &report(&["a"], &["a"]), FORMATS).unwrap();
        // a folder in place of a file: everything before it is written, nothing after
        fs::create_dir_all(d.0.join("c/t.csv")).unwrap();
        assert!(renew(&d.0, &report(&["b", "c"], &["b", "c"]), FORMATS).is_err());
        let list: Value = serde_json::from_str(&fs::read_to_string(d.0.join(MANIFEST)).unwrap()).unwrap();
        assert_eq!(list["complete"], false);
        assert!(d.has("a/t.csv") && d.has("b/t.csv"));
        fs::remove_dir(d.0.join("c/t.csv")).unwrap();
        renew(&d.0, &report(&["c"], &["c"]), FORMATS).unwrap();
        let list: Value = serde_json::from_str(&fs::read_to_string(d.0.join(MANIFEST)).unwrap()).unwrap();
        assert_eq!(list["complete"], true);
        assert!(!d.has("a") && !d.has("b") && d.has("c/t.csv"));
    }

    #[test]
    fn the_folder_is_prepared_before_anything_is_computed() {
        let d = Dir::new("prepare");
        let why = |d: &Dir| prepare(&d.0, &["a"]).err().map(|d| d.code);
        assert_eq!(why(&d), None);
        fs::create_dir_all(d.0.join("a")).unwrap();
        // left by a killed run, and something that is not
        fs::write(d.0.join("a/.laval-1-0.part"), "half").unwrap();
        fs::write(d.0.join("a/t.csv.part1"), "mine").unwrap();
        assert_eq!(why(&d), None);
        assert!(!d.has("a/.laval-1-0.part") && d.has("a/t.csv.part1"));
        for (file, content) in [("figures", "x"), ("manifest.json", "{ \"name\": \"a web page\" }")] {
            fs::write(d.0.join(file), content).unwrap();
            assert_eq!(why(&d), Some("folder.taken"));
            assert_eq!(fs::read_to_string(d.0.join(file)).unwrap(), content);
            fs::remove_file(d.0.join(file)).unwrap();
        }
        fs::create_dir(d.0.join("report.html")).unwrap();
        assert_eq!(why(&d), Some("folder.taken"));
    }
}
