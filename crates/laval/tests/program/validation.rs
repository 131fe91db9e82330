//! The validation gallery: every case of the repository, with the verdict it states.

use laval::file::Form;
use laval::validation::{Page, Verdict, documents, gallery, run};
use std::collections::HashSet;
use std::path::Path;

fn pages() -> Vec<Page> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let found = documents(&folder).unwrap_or_else(|(path, e)| panic!("{}: {e}", path.display()));
    run(&found, |_| {})
}

/// What has changed, for the message of the test.
fn reported(page: &Page) -> String {
    let mut s = format!("{}: {}\n{}", page.id(), page.verdict(), page.complaint(Form::Lines));
    if let Page::Checked(c) = page {
        for (e, found) in c.case.expected.iter().zip(&c.compared).filter(|(e, found)| e.stated != found.row) {
            s += &format!("  {} {} {}: {} expected {} {}\n", e.study, e.value, e.at, found.measured, e.expected_text, e.unit);
        }
    }
    s
}

#[test]
fn every_case_has_the_verdict_it_states() {
    let pages = pages();
    let changed: Vec<String> = pages.iter().filter(|p| !p.holds()).map(reported).collect();
    assert!(changed.is_empty(), "{} of {} cases:\n{}", changed.len(), pages.len(), changed.join("\n"));
    // cases that disagree stay
    assert!(pages.len() >= 60);
    assert!(pages.iter().filter(|p| p.verdict() == Verdict::Explained.words()).count() >= 2);
    let files = gallery(&pages).unwrap();
    assert_eq!(files.len(), pages.len() + 1);
    assert_eq!(files.iter().map(|f| f.0.as_str()).collect::<HashSet<_>>().len(), files.len());
    for (name, content) in &files[1..] {
        assert!(files[0].1.contains(&format!("href=\"{name}\"")), "{name} is not in the index");
        // a few modes or critical speeds stand in a table alone
        assert!(content.contains("<svg") || content.contains("<table"), "{name} shows nothing");
    }
    let known: HashSet<&str> = files.iter().map(|f| f.0.as_str()).collect();
    for (name, content) in &files {
        for link in content.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()).filter(|l| l.ends_with(".html")) {
            assert!(known.contains(link), "{name} links to {link}");
        }
        assert!(content.contains("default-src 'none'") && !content.contains("<script"), "{name}");
        for outside in ["src=", "<link", "@import", "url(h"] {
            assert!(!content.contains(outside), "{name} contains {outside}");
        }
    }
}

/// The numbers in `2, 3` and `14 to 23`.
fn numbers(cell: &str) -> Vec<usize> {
    let ranges = cell.split(',').filter_map(|part| {
        let mut ends = part.trim().split(" to ").map(|n| n.parse::<usize>().ok());
        let first = ends.next()??;
        Some(first..=ends.next().unwrap_or(Some(first))?)
    });
    ranges.flatten().collect()
}

#[test]
fn the_index_names_every_figure_and_equation_of_the_sources() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let text = std::fs::read_to_string(folder.join("README.md")).unwrap();
    for target in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(folder.join(target).is_file(), "{target} does not exist");
    }
    let table = |head: &str| -> HashSet<usize> {
        let rows = text.split_once(head).unwrap().1.lines().skip(2).take_while(|l| l.starts_with('|'));
        rows.flat_map(|l| numbers(l.split('|').nth(1).unwrap())).collect()
    };
    let (figures, equations) = (table("| figure | page |"), table("| equation | page |"));
    assert!((1..=36).all(|n| figures.contains(&n)), "{figures:?}");
    assert!((1..=55).all(|n| equations.contains(&n)), "{equations:?}");
    let (figures, equations) = (table("| figure of the balancer source | page |"), table("| equation of the balancer source | page |"));
    assert!((1..=19).all(|n| figures.contains(&n)), "{figures:?}");
    assert!((1..=34).all(|n| equations.contains(&n)), "{equations:?}");
}
