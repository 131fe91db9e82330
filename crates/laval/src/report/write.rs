//! Writing a report into a folder: every file whole or not at all.

use super::csv::write_csv;
#[cfg(feature = "parquet")]
use super::parquet::write_parquet;
use super::text::file_name;
use super::{Report, csv, html, json, svg};
use crate::hash::sha256;
use crate::outcome::{OutcomeError, Table};
use crate::output_folder::{Lasting, write_whole_by};
use crate::text;
use crate::text::Text;
use std::collections::{HashMap, HashSet};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::{fmt, fs, io};

/// A kind of file to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `results.json`.
    Json,
    /// `<study>/<table>.csv`.
    Csv,
    /// `<study>/<table>.parquet`.
    #[cfg(feature = "parquet")]
    Parquet,
    /// `figures/<study>-<figure>.svg`.
    Svg,
    /// `report.html`.
    Html,
}

impl Format {
    /// All of them.
    pub const ALL: &'static [Format] = &[
        Format::Json,
        Format::Csv,
        #[cfg(feature = "parquet")]
        Format::Parquet,
        Format::Svg,
        Format::Html,
    ];

    /// Its word on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Format::Json => "json",
            Format::Csv => "csv",
            #[cfg(feature = "parquet")]
            Format::Parquet => "parquet",
            Format::Svg => "svg",
            Format::Html => "html",
        }
    }
}

impl FromStr for Format {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let words: Vec<&str> = Format::ALL.iter().map(|f| f.word()).collect();
        Format::ALL
            .iter()
            .copied()
            .find(|f| f.word() == word)
            .ok_or_else(|| format!("unknown format `{word}`; use one of {}", words.join(", ")))
    }
}

/// Why a report could not be written completely.
#[derive(Debug)]
pub enum WriteError {
    /// A file or folder could not be written.
    Io {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
        /// The files written before; they are complete.
        written: Vec<PathBuf>,
    },
    /// An outcome contradicts itself.
    Outcome {
        /// Study.
        study: String,
        /// How.
        source: OutcomeError,
    },
}

impl WriteError {
    /// As a sentence.
    pub fn sentence(&self) -> Text {
        match self {
            WriteError::Io { path, source, written } => {
                let path = path.display();
                match written.len() {
                    0 => text!("cannot write {path}: {source}", path, source),
                    1 => text!("cannot write {path}: {source} (1 file written before it is complete)", path, source),
                    n => text!("cannot write {path}: {source} ({n} files written before it are complete)", path, source, n),
                }
            }
            WriteError::Outcome { study, source } => text!("study `{study}`: {source}", study, source),
        }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.sentence().fmt(f)
    }
}

impl std::error::Error for WriteError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            WriteError::Io { source, .. } => Some(source),
            WriteError::Outcome { source, .. } => Some(source),
        }
    }
}

/// Relative file names (without extension) of everything, unique also on systems that ignore case.
pub(super) struct Names {
    tables: Vec<Vec<String>>,
    figures: Vec<Vec<String>>,
}

impl Names {
    pub fn new(report: &Report) -> Names {
        // names of files depend on all studies of the machine file, not on those that were run
        let studies = report.studies();
        let folders: HashMap<&str, String> = studies.iter().copied().zip(folders(studies.iter().copied())).collect();
        let (mut tables, mut figures) = (Vec::new(), Vec::new());
        let mut taken: HashMap<String, [HashSet<String>; 2]> = HashMap::new();
        for o in &report.outcomes {
            let folder = folders.get(o.name.as_str()).cloned().unwrap_or_default();
            let [files, drawings] = taken.entry(folder.clone()).or_default();
            tables.push(o.tables.iter().map(|t| format!("{folder}/{}", unique(files, &file_name(t.name())))).collect());
            // no name of a folder or a figure holds two hyphens in a row: "a--b-c" is none of the figures of "a-b"
            let near = |other: &String| {
                let (a, b) = (fold(&folder) + "-", fold(other) + "-");
                *other != folder && (a.starts_with(&b) || b.starts_with(&a))
            };
            let hyphen = if folders.values().any(near) { "--" } else { "-" };
            let drawing = |name: &str| format!("figures/{folder}{hyphen}{name}");
            figures.push(o.figures.iter().map(|f| drawing(&unique(drawings, &file_name(&f.name)))).collect());
        }
        Names { tables, figures }
    }

    pub fn table(&self, study: usize, table: usize) -> &str {
        &self.tables[study][table]
    }

    pub fn figure(&self, study: usize, figure: usize) -> &str {
        &self.figures[study][figure]
    }
}

/// Names in the folder of results that are not of a study.
const RESERVED: [&str; 4] = ["figures", "manifest.json", "report.html", "results.json"];

/// The folders of studies of these names, unique also on systems that ignore case. A folder does not depend on the order of the studies: those whose
/// names would lead to the same folder all carry a mark of their name behind it.
///
/// ```
/// use laval::report::folders;
/// assert_eq!(folders(["slow run", "fast"]), ["slow-run", "fast"]);
/// let [a, b] = folders(["slow run", "slow-run"]).try_into().unwrap();
/// assert!(a.starts_with("slow-run-") && b.starts_with("slow-run-") && a != b);
/// assert_eq!(folders(["slow-run", "fast", "slow run"]), [b, "fast".into(), a]);
/// ```
pub fn folders<'a>(names: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let names: Vec<&str> = names.into_iter().collect();
    let mut taken: HashMap<String, HashSet<&str>> = RESERVED.iter().map(|r| (r.to_string(), HashSet::from([""]))).collect();
    for name in &names {
        taken.entry(fold(&file_name(name))).or_default().insert(name);
    }
    let marked = |name: &str| {
        let plain = file_name(name);
        // the mark is longer where a name of another study ends in the short one
        let marks = (8..=64).step_by(8).map(|digits| format!("{plain}-{}", &sha256(name.as_bytes())[..digits]));
        let free = |m: &String| !taken.contains_key(&fold(m));
        marks.clone().find(free).or(marks.last()).unwrap_or(plain)
    };
    let folder = |name: &&str| {
        let plain = file_name(name);
        let shared = taken.get(&fold(&plain)).is_some_and(|all| all.len() > 1);
        if shared || name.chars().any(composed) { marked(name) } else { plain }
    };
    names.iter().map(folder).collect()
}

/// Letters that some file systems take for a sequence of others: two names that differ are one to them. Plain letters of the scripts of living languages
/// that are written without combining marks are not among them.
fn composed(c: char) -> bool {
    let plain = matches!(c,
        '\0'..='\u{24f}' | '\u{370}'..='\u{373}' | '\u{376}'..='\u{377}' | '\u{37b}'..='\u{37d}' | '\u{37f}' | '\u{386}' | '\u{388}'..='\u{3ff}'
        | '\u{400}'..='\u{482}' | '\u{48a}'..='\u{52f}' | '\u{531}'..='\u{587}' | '\u{5d0}'..='\u{5ea}' | '\u{620}'..='\u{64a}'
        | '\u{660}'..='\u{669}' | '\u{671}'..='\u{6d3}' | '\u{10d0}'..='\u{10ff}' | '\u{1c90}'..='\u{1cbf}' | '\u{1e00}'..='\u{1eff}'
        | '\u{3041}'..='\u{3096}' | '\u{30a1}'..='\u{30fa}' | '\u{3400}'..='\u{4dbf}' | '\u{4e00}'..='\u{9fff}' | '\u{ac00}'..='\u{d7a3}'
    );
    c.is_alphabetic() && !plain
}

/// Names that differ by this alone are one name to some file systems.
fn fold(name: &str) -> String {
    name.chars().flat_map(char::to_uppercase).flat_map(char::to_lowercase).collect()
}

fn unique(taken: &mut HashSet<String>, name: &str) -> String {
    let mut out = name.to_string();
    let mut n = 2;
    while !taken.insert(fold(&out)) {
        out = format!("{name}-{n}");
        n += 1;
    }
    out
}

/// Writes the report into `dir`, which is made when missing, and returns the files in the order written: tables and figures
/// first, then `results.json`, then `report.html`, so that what names a file comes after it.
///
/// Each file is written under a temporary name and renamed: a reader never sees half a file, and files of an earlier run stay
/// until they are replaced.
///
/// # Errors
/// [`WriteError::Io`] with the path when a file cannot be written (the files before it are kept); [`WriteError::Outcome`], before
/// anything is written, when an outcome contradicts itself.
pub fn write(dir: &Path, report: &Report, formats: &[Format]) -> Result<Vec<PathBuf>, WriteError> {
    write_all(dir, &compose(report, formats)?)
}

/// A file of a report.
pub(super) struct Composed<'a> {
    /// Relative to the folder, with `/`.
    pub name: String,
    /// Number of its study; `None` for what belongs to all.
    pub study: Option<usize>,
    pub content: Content<'a>,
}

/// What stands in a file.
pub(super) enum Content<'a> {
    Bytes(Vec<u8>),
    /// The files of a large table are as large as the table or larger, and are made while they are written.
    Csv(&'a Table),
    #[cfg(feature = "parquet")]
    Parquet(&'a Table),
}

/// Numbers of a table whose files are not kept in memory.
const LARGE: usize = 200_000;

impl Content<'_> {
    pub fn write(&self, out: &mut (dyn Write + Send)) -> io::Result<()> {
        match self {
            Content::Bytes(bytes) => out.write_all(bytes),
            Content::Csv(table) => {
                let mut out = BufWriter::with_capacity(1 << 16, out);
                write_csv(table, &mut out)?;
                out.flush()
            }
            #[cfg(feature = "parquet")]
            Content::Parquet(table) => write_parquet(table, out).map_err(io::Error::other),
        }
    }
}

/// All files of a report, in the order in which they are written.
pub(super) fn compose<'a>(report: &'a Report, formats: &[Format]) -> Result<Vec<Composed<'a>>, WriteError> {
    for o in &report.outcomes {
        for f in &o.figures {
            f.check(&o.tables).map_err(|source| WriteError::Outcome { study: o.name.clone(), source })?;
        }
    }
    let names = Names::new(report);
    let mut out = Vec::new();
    let mut put = |name: String, study: Option<usize>, content: Content<'a>| out.push(Composed { name, study, content });
    let wants = |f: Format| formats.contains(&f);
    for (i, o) in report.outcomes.iter().enumerate() {
        for (k, t) in o.tables.iter().enumerate() {
            let large = t.rows() * t.columns().len() > LARGE;
            if wants(Format::Csv) {
                let content = if large { Content::Csv(t) } else { Content::Bytes(csv(t).into_bytes()) };
                put(format!("{}.csv", names.table(i, k)), Some(i), content);
            }
            #[cfg(feature = "parquet")]
            if wants(Format::Parquet) {
                let name = format!("{}.parquet", names.table(i, k));
                let failed = |e| WriteError::Io { path: name.clone().into(), source: io::Error::other(e), written: Vec::new() };
                let content = if large { Content::Parquet(t) } else { Content::Bytes(super::parquet(t).map_err(failed)?) };
                put(name, Some(i), content);
            }
        }
        for (k, f) in o.figures.iter().enumerate().filter(|_| wants(Format::Svg)) {
            let text = svg::draw_in(f, &o.tables, &report.style).map_err(|source| WriteError::Outcome { study: o.name.clone(), source })?;
            put(format!("{}.svg", names.figure(i, k)), Some(i), Content::Bytes(text.into_bytes()));
        }
    }
    if wants(Format::Json) {
        put("results.json".into(), None, Content::Bytes(json(report).into_bytes()));
    }
    if wants(Format::Html) {
        let text = html::page(report, wants(Format::Csv)).map_err(|(study, source)| WriteError::Outcome { study, source })?;
        put("report.html".into(), None, Content::Bytes(text.into_bytes()));
    }
    Ok(out)
}

pub(super) fn write_all(dir: &Path, files: &[Composed]) -> Result<Vec<PathBuf>, WriteError> {
    let mut written = Vec::new();
    for file in files {
        let path =
            place(dir, &file.name, &file.content).map_err(|(path, source)| WriteError::Io { path, source, written: written.clone() })?;
        written.push(path);
    }
    Ok(written)
}

/// Writes a file into a folder, whole or not at all, and returns its path; else the path that failed, and why.
pub(super) fn place(dir: &Path, name: &str, content: &Content) -> Result<PathBuf, (PathBuf, io::Error)> {
    let path = dir.join(name);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|e| (folder.to_path_buf(), e))?;
    }
    match write_whole_by(&path, Lasting::Kill, |file| content.write(file)) {
        Ok(()) => Ok(path),
        Err(e) => Err((path, e)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Axis, Figure, Finding, Line, Outcome, Panel, Table};

    struct Dir(PathBuf);

    impl Dir {
        fn new(name: &str) -> Dir {
            let dir = std::env::temp_dir().join(format!("laval-write-{}-{name}", std::process::id()));
            let _ = fs::remove_dir_all(&dir);
            Dir(dir)
        }
    }

    impl Drop for Dir {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn report(names: &[&str]) -> Report {
        let outcome = |name: &&str| {
            let table = Table::new("t", "").float("x", "m", "", vec![1.0, f64::NAN]).build().unwrap();
            let figure = Figure::new("f", "", "").panel(Panel::new(Axis::new("", "")).mark(Line::new("t", "x", "x")));
            Outcome::new("k", *name).table(table).figure(figure).finding(Finding::info("i", "Value {}.").value(f64::NAN, "m").evidence(
                "e",
                f64::INFINITY,
                "",
            ))
        };
        Report { outcomes: names.iter().map(outcome).collect(), ..Report::default() }
    }

    #[test]
    fn names_stay_inside_and_apart() {
        let dir = Dir::new("names");
        let files = write(&dir.0, &report(&["../up", "up", "Up", "figures"]), &[Format::Csv, Format::Svg]).unwrap();
        let names: Vec<_> = files.iter().map(|f| f.strip_prefix(&dir.0).unwrap().to_str().unwrap().to_string()).collect();
        let folders = ["up-8c722b8a", "up-75a288c0", "Up-55490a4b", "figures-dc2e3999"];
        let expected: Vec<String> = folders.iter().flat_map(|f| [format!("{f}/t.csv"), format!("figures/{f}-f.svg")]).collect();
        assert_eq!(names, expected);
        assert!(files.iter().all(|f| f.is_file()));
    }

    #[test]
    fn no_part_stays_and_the_same_run_gives_the_same_bytes() {
        let dir = Dir::new("same");
        let read = |files: &[PathBuf]| files.iter().map(|f| fs::read(f).unwrap()).collect::<Vec<_>>();
        let first = read(&write(&dir.0, &report(&["a"]), Format::ALL).unwrap());
        let files = write(&dir.0, &report(&["a"]), Format::ALL).unwrap();
        assert!(first == read(&files));
        let on_disk = ["", "a", "figures"]
            .iter()
            .map(|d| fs::read_dir(dir.0.join(d)).unwrap().filter(|e| e.as_ref().unwrap().path().is_file()).count());
        assert_eq!(on_disk.sum::<usize>(), files.len());
    }

    #[test]
    fn a_failure_names_the_path_and_keeps_what_was_written() {
        let dir = Dir::new("fail");
        fs::create_dir_all(dir.0.join("results.json")).unwrap();
        let error = write(&dir.0, &report(&["a"]), Format::ALL).unwrap_err();
        let WriteError::Io { path, written, .. } = &error else { panic!("{error}") };
        assert_eq!(path, &dir.0.join("results.json"));
        assert!(!written.is_empty() && written.iter().all(|f| f.is_file()));
        assert!(error.to_string().contains("results.json") && error.to_string().contains("complete"));
        let file = dir.0.join("file");
        fs::write(&file, "").unwrap();
        assert!(matches!(write(&file, &report(&["a"]), Format::ALL), Err(WriteError::Io { .. })));
    }

    /// The files of a large table are never whole in memory; they are the same.
    #[test]
    fn a_large_table_is_written_while_it_is_made() {
        let rows = LARGE / 2 + 1;
        let table = Table::new("t", "").float("x", "m", "", (0..rows).map(|i| i as f64 / 3.0).collect());
        let table = table.text("s", "", (0..rows).map(|i| format!("a,{i}")).collect()).build().unwrap();
        let text = csv(&table);
        let report = Report { outcomes: vec![Outcome::new("k", "a").table(table)], ..Report::default() };
        let composed = compose(&report, &[Format::Csv]).unwrap();
        assert!(matches!(composed[0].content, Content::Csv(_)));
        let dir = Dir::new("large");
        let files = write(&dir.0, &report, &[Format::Csv]).unwrap();
        assert!(fs::read_to_string(&files[0]).unwrap() == text);
        #[cfg(feature = "parquet")]
        {
            let composed = compose(&report, &[Format::Parquet]).unwrap();
            assert!(matches!(composed[0].content, Content::Parquet(_)));
            let files = write(&dir.0, &report, &[Format::Parquet]).unwrap();
            assert!(fs::read(&files[0]).unwrap() == super::super::parquet(&report.outcomes[0].tables[0]).unwrap());
        }
    }

    #[test]
    fn json_has_null_for_numbers_that_are_none() {
        let text = json(&report(&["a"]));
        let v: serde_json::Value = serde_json::from_str(&text).unwrap();
        let finding = &v["studies"][0]["findings"][0];
        assert!(finding["value"].is_null() && finding["evidence"][0]["value"].is_null());
        assert_eq!(finding["message"], "Value {}.");
        assert!(finding["args"]["value"]["value"].is_null() && finding["args"]["value"]["unit"] == "m");
        assert_eq!(v["studies"][0]["tables"][0]["file"], "a/t");
        let keys: Vec<&String> = v["studies"][0].as_object().unwrap().keys().collect();
        assert_eq!(keys, ["kind", "name", "end", "parameter", "findings", "special_points", "tables", "figures", "work"]);
    }

    #[test]
    fn contradictions_are_found_before_anything_is_written() {
        let dir = Dir::new("check");
        let mut r = report(&["a"]);
        r.outcomes[0].tables.clear();
        assert!(matches!(write(&dir.0, &r, Format::ALL), Err(WriteError::Outcome { .. })));
        assert!(!dir.0.exists());
    }

    #[test]
    fn formats_by_word() {
        assert_eq!("svg".parse(), Ok(Format::Svg));
        assert!("pdf".parse::<Format>().unwrap_err().contains("json, csv"));
    }
}
