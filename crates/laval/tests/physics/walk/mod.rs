//! The documented promise of every key is held by every study, or refused: parts and studies of the registries, pairwise.

mod answers;
mod machines;
mod studies;

use answers::{Answer, ask, difference};
use laval::file::catalog;
use laval::study::registry;
use machines::{CASES, Case, changes};
use studies::{APART, LONG, MAIN, NOTHING, STUDIES, WITHOUT_MOTION};

/// Relative difference that is an influence and not rounding.
const INFLUENCE: f64 = 1e-6;

fn of(case: &str, kind: &str, list: &[(&str, &[&str])]) -> bool {
    list.iter().any(|(name, kinds)| *name == case && kinds.contains(&kind))
}

/// Nothing is to be expected of a changed property in a study.
fn without_influence(case: &str, what: &str, kind: &str) -> bool {
    let key = |k: &&str| *k == format!("{case}.{what}") || *k == format!("{case}.*");
    NOTHING.iter().any(|(keys, kinds, _)| keys.iter().any(key) && (kinds.is_empty() || kinds.contains(&kind)))
}

/// What is wrong with a study of a case: every changed property is seen, or the part is named in a refusal.
fn wrong(case: &Case, (kind, fields, quick): (&str, &str, bool)) -> Vec<String> {
    let plain = match ask(&case.machine(false).text(), kind, fields) {
        Answer::Outcome(o) => o,
        // a motion that is not found or not the same in every direction is refused for what it is
        refused => {
            let named =
                refused.refused(&[case.name, "free", "equilibrium", "periodic motion", "linearised about rest", "one spin"]) == Some(true);
            return if named { Vec::new() } else { vec![format!("{} {kind}: {}", case.name, refused.text())] };
        }
    };
    let requested = |what: &str| quick || MAIN.contains(&what) || (what == "height" && kind != "nonlinear_response");
    let mut out = Vec::new();
    for change in changes(case).into_iter().filter(|c| requested(&c.what)) {
        let Answer::Outcome(changed) = ask(&change.machine.text(), kind, fields) else { continue };
        let d = difference(&plain, &changed);
        if !(d > INFLUENCE) && !without_influence(case.name, &change.what, kind) {
            out.push(format!("{}.{} in {kind}: {d:e}", case.name, change.what));
        }
    }
    out
}

#[test]
fn every_part_and_every_study_is_walked() {
    assert_eq!(machines::left_out(), Vec::<String>::new(), "numbers of parts that no case changes");
    for k in &catalog().parts {
        assert!(CASES.iter().any(|c| c.kind == k.kind), "no case for {}", k.kind);
    }
    for k in registry() {
        let kind = k.info.kind;
        assert!(
            STUDIES.iter().any(|s| s.0 == kind) || WITHOUT_MOTION.contains(&kind) || APART.contains(&kind),
            "{kind}: say what is requested of it"
        );
    }
}

/// Every second case.
fn every_second(first: usize) {
    let cases = CASES.iter().skip(first).step_by(2);
    let pairs = cases.flat_map(|c| STUDIES.iter().map(move |s| (c, *s))).filter(|(c, s)| !of(c.name, s.0, LONG));
    let wrong: Vec<String> = pairs.flat_map(|(c, s)| wrong(c, s)).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_study_sees_every_property_of_every_part_in_even_places() {
    every_second(0);
}

#[test]
fn every_study_sees_every_property_of_every_part_in_odd_places() {
    every_second(1);
}

/// Studies of small motions about a rest that is inside.
const AT_REST: &[&str] = &["modes", "campbell", "critical_speeds", "stability_map", "stability_threshold", "optimum"];

/// A law that is fitted for a millionth of what moves; upright only motion leaves it, and every study with an amplitude says so, with the name of the part.
#[test]
fn every_study_says_that_a_law_is_left() {
    let case = CASES.iter().find(|c| c.name == "cubic").expect("a case");
    let mut wrong = Vec::new();
    for (kind, fields, _) in STUDIES.iter().filter(|s| s.0 != "modes" || s.1.is_empty()) {
        for (range, outside) in [("\"1 nm\"", true), ("\"0.9 m\"", false)] {
            let mut machine = case.machine(false);
            machine.part("cubic").retain(|l| l.0 != "valid_to");
            machine.part("cubic").push(("valid_to".into(), range.into()));
            let answer = ask(&machine.text(), kind, fields);
            // a study of studies counts the results outside
            let said = answer.outside("cubic") + answer.outside("validity");
            // there validity is one of the requirements, which no speed keeps
            let said = said + usize::from(*kind == "operating_window" && answer.text().contains("no_window"));
            if (said > 0) != (outside && !AT_REST.contains(kind)) {
                wrong.push(format!("{kind} with {range}: {said} findings\n{}", answer.text()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
