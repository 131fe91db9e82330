//! `docs/findings.md` has a line for every finding that a study can make, in the section of the study, and no other.

use laval::study;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Names that are put together where a finding is made: file, number of such places, names.
const COMPOSED: &[(&str, usize, &[&str])] = &[
    ("motion/history/findings.rs", 2, &["largest_displacement", "largest_tilt"]),
    ("motion/motion_map/report.rs", 1, &["largest_displacement", "largest_tilt"]),
    ("nonlinear/nonlinear_response/findings.rs", 1, &["largest_displacement_not_reached", "unbounded_displacement"]),
    ("nonlinear/nonlinear_response/one.rs", 1, &["steady_motion", "steady_tilt"]),
    ("nonlinear/nonlinear_response/orders.rs", 1, &["superharmonic_range", "subharmonic_range"]),
    ("nonlinear/nonlinear_response/stability.rs", 1, &["stability_lost", "stability_gained"]),
    (
        "nonlinear/nonlinear_response/sweeps.rs",
        7,
        &[
            "no_jump_up",
            "no_jump_down",
            "jump_up",
            "jump_down",
            "sweep_up_unfinished",
            "sweep_down_unfinished",
            "sweep_up_unstable",
            "sweep_down_unstable",
            "sweep_up_unknown",
            "sweep_down_unknown",
        ],
    ),
    ("parameters/optimum/report.rs", 1, &["limit_reached", "limit_kept"]),
    (
        "nonlinear/response_map/report.rs",
        2,
        &["largest_peak", "smallest_peak", "neimark_sacker_machines", "symmetry_breaking_machines", "period_doubling_machines"],
    ),
    ("parameters/sensitivity/report.rs", 1, &["peak", "jump_up", "jump_down"]),
    ("centrifuge/separation/report.rs", 2, &["validity_..."]),
    ("motion/spectra/report.rs", 1, &["superharmonic", "subharmonic", "component", "asynchronous"]),
    ("nonlinear/stationary/findings.rs", 2, &["balanced_stable", "stable_states", "continuum"]),
    (
        "motion/sweep/report.rs",
        4,
        &[
            "largest_displacement",
            "largest_tilt",
            "start_jump",
            "jump_up",
            "jump_down",
            "joins_up",
            "joins_down",
            "no_jump_up",
            "no_jump_down",
            "not_periodic",
            "not_settled",
        ],
    ),
    ("motion/transient.rs", 1, &["largest_displacement", "largest_tilt"]),
];

fn sources(folder: &Path, out: &mut Vec<PathBuf>) {
    for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// Names of the findings made in a text, and the number of those that are not written there.
fn made(text: &str) -> (BTreeSet<String>, usize) {
    let (mut names, mut composed) = (BTreeSet::new(), 0);
    for call in ["Finding::info(", "Finding::warning(", "Finding::invalid(", " make("] {
        for (at, _) in text.match_indices(call) {
            match text[at + call.len()..].trim_start().strip_prefix('"') {
                Some(rest) => drop(names.insert(rest.split('"').next().unwrap_or_default().to_string())),
                None => composed += 1,
            }
        }
    }
    (names, composed)
}

/// Names by the section of the page that must have them: that of the study, or any section where several studies share the code.
fn all(src: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let kinds: BTreeSet<&str> = study::registry().iter().map(|k| k.info.kind).collect();
    let mut files = Vec::new();
    sources(&src.join("study"), &mut files);
    files.push(src.join("store/mod.rs"));
    let mut out: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut seen = BTreeSet::new();
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        let (mut names, composed) = made(text.split("#[cfg(test)]\nmod tests").next().unwrap());
        let place = file.strip_prefix(src).unwrap().to_str().unwrap().replace('\\', "/").replacen("study/", "", 1);
        let known = COMPOSED.iter().find(|c| c.0 == place);
        assert_eq!(composed, known.map_or(0, |c| c.1), "{place}: findings whose name is put together");
        if let Some((_, _, own)) = known {
            seen.insert(place.clone());
            names.extend(own.iter().map(|n| n.to_string()));
        }
        let section = place.split(['/', '.']).find(|name| kinds.contains(name)).unwrap_or_default();
        out.entry(section.into()).or_default().extend(names);
    }
    assert_eq!(seen.len(), COMPOSED.len(), "a file that makes no such finding: {seen:?}");
    out
}

/// Names of the first column by section, and the cells of all lines.
fn page(text: &str) -> (BTreeMap<String, BTreeSet<String>>, Vec<Vec<String>>) {
    let (mut names, mut lines, mut section): (BTreeMap<String, BTreeSet<String>>, _, _) = (BTreeMap::new(), Vec::new(), String::new());
    for line in text.lines() {
        if let Some(title) = line.strip_prefix("## ") {
            section = title.trim_matches('`').to_string();
        } else if line.starts_with("| `") {
            let cells: Vec<String> = line.trim_matches('|').split(" | ").map(|c| c.trim().to_string()).collect();
            for name in cells[0].split(", ") {
                let fresh = names.entry(section.clone()).or_default().insert(name.trim_matches('`').to_string());
                assert!(fresh, "{section}: {name} stands twice");
            }
            lines.push(cells);
        }
    }
    (names, lines)
}

#[test]
fn every_finding_has_its_evidence_on_the_page() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join("../../docs/findings.md")).unwrap().replace('\r', "");
    let (listed, lines) = page(&text);
    for cells in &lines {
        assert!(cells.len() == 3 && cells.iter().all(|c| !c.is_empty()), "{cells:?}");
    }
    let made = all(&root.join("src"));
    for kind in study::registry() {
        assert!(listed.contains_key(kind.info.kind), "no section {}", kind.info.kind);
    }
    let anywhere: BTreeSet<&String> = listed.values().flatten().collect();
    for (section, names) in &made {
        for name in names {
            let there = if section.is_empty() {
                anywhere.contains(name)
            } else {
                [section.as_str(), "All studies", "Counted roots"].iter().any(|s| listed[*s].contains(name))
            };
            assert!(there, "docs/findings.md, section {section:?}: no line for the finding `{name}`");
        }
    }
    let all: BTreeSet<&String> = made.values().flatten().collect();
    for (section, names) in &listed {
        for name in names {
            assert!(all.contains(name), "docs/findings.md, section {section}: no study makes a finding `{name}`");
        }
    }
}

#[test]
fn findings_are_seen_in_sources() {
    let (names, composed) = made("a.push(Finding::info(\n    \"one\", text)); make(\"two\", t); Finding::warning(id, t)");
    assert_eq!((names.into_iter().collect::<Vec<_>>(), composed), (vec!["one".to_string(), "two".to_string()], 1));
}
