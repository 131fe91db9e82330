//! What every run of a machine file has in common, whoever starts it: how its report begins, and where long studies keep their rows.

use crate::build;
use crate::file::{self, Loaded};
use crate::hash::sha256;
use crate::report::{self, Language, Provenance, Report, Style, Units};
use crate::store::{Keep, Work};
use crate::study::presentation;
use std::path::{Component, Path};

/// A language, and the units of the file's `[report]`, else those that the file writes.
pub fn style(text: &str, loaded: &Loaded, language: Language) -> Style {
    let own = presentation::among(&loaded.system.machine.extras);
    let written = || file::written_units(text);
    let units = match own.units.as_deref() {
        None | Some("file") => Units::new(written()),
        Some("si") => Units::default(),
        Some(list) => Units::chosen(file::si_units(presentation::listed(list).map(String::from)), written()),
    };
    Style { language, units }
}

/// The report of a run before its studies: `name` is that of the file, `text` and `bytes` what it holds.
pub fn begun(name: &str, (text, bytes): (&str, &[u8]), loaded: &Loaded, settings: Vec<(String, String)>, language: Language) -> Report {
    Report {
        machine: loaded.system.machine.name.clone(),
        provenance: Provenance {
            version: env!("CARGO_PKG_VERSION").into(),
            build: build::ID.into(),
            processor: build::processor().into(),
            input_name: name.into(),
            input_hash: format!("sha256:{}", sha256(bytes)),
            settings,
            seed: None,
        },
        input: Some(text.into()),
        studies: loaded.spec.studies.iter().map(|b| b.name.clone()).collect(),
        outcomes: Vec::new(),
        overview: None,
        style: style(text, loaded, language),
    }
}

/// Where a long study keeps its rows.
pub fn keep(loaded: &Loaded, dir: &Path, study: &str, work: Work) -> Option<Keep> {
    let names = || loaded.spec.studies.iter().map(|b| b.name.as_str());
    let folders = report::folders(names());
    let at = names().position(|n| n == study)?;
    Some(Keep { folder: dir.join(folders.get(at)?), input: file::canonical(&loaded.spec, study), fresh: false, work })
}

/// The name by which results refer to a file: its folder and name, which do not depend on where the folder lies.
pub fn name(path: &Path) -> String {
    let named = |c: Component| match c {
        Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
        _ => None,
    };
    let mut parts: Vec<String> = path.components().rev().take(2).filter_map(named).collect();
    parts.reverse();
    parts.join("/")
}

/// The name of the machine's folder of results: that of the file, or of its folder when the file is called `machine.toml`.
pub fn stem(path: &Path) -> String {
    let stem = path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
    let folder = || {
        let full = path.canonicalize().ok()?;
        Some(full.parent()?.file_name()?.to_string_lossy().into_owned())
    };
    let name = if stem == "machine" { folder().unwrap_or(stem) } else { stem };
    let usual = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_' | '.' | '+' | ',' | '(' | ')' | '\u{300}'..='\u{36f}');
    // names such as "..", that are no folder on every system, are changed
    let sound = name.chars().all(usual) && name.trim_end_matches([' ', '.']) == name && !report::file_name(&name).ends_with('_');
    if sound && !name.starts_with('.') { name } else { report::file_name(&name) }
}
