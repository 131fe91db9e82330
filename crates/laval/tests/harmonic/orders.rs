//! Sub- and superharmonic orders of a response: onset speeds, sense, largest amplitudes, against the reference tables.

use crate::common;

use common::planar_file::planar_file;
use laval::file::load;
use laval::outcome::{Arg, Data, Evidence, Finding, Outcome};
use laval::report::draw;
use laval::solve::harmonic::balance::terms::admitted;
use laval::solve::symmetry::Symmetry;
use laval::study::Context;

fn machine(law: &str, eccentricity: &str, study: &str) -> Outcome {
    let rotor = planar_file(law, eccentricity, ["42", "6.59"]);
    let text = format!("{rotor}\n[[study]]\nkind = \"nonlinear_response\"\n{study}\n");
    let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("orders")).unwrap();
    for f in &o.figures {
        assert!(!f.alt.key.is_empty() && draw(f, &o.tables).unwrap().contains("<path"));
    }
    o
}

fn finding<'a>(o: &'a Outcome, id: &str, subject: &str) -> &'a Finding {
    let all: Vec<_> = o.findings.iter().map(|f| (&f.id, &f.subject)).collect();
    o.findings.iter().find(|f| f.id == id && f.subject == subject).unwrap_or_else(|| panic!("no {id} {subject} in {all:?}"))
}

fn evidence(f: &Finding, what: &str) -> f64 {
    let named = |e: &&Evidence| e.what == what;
    f.evidence.iter().find(named).unwrap_or_else(|| panic!("no {what} in {f:?}")).value
}

/// Speed and backward third order of the drum in the table, eccentricity 10 mm.
fn reference() -> Vec<(f64, f64)> {
    let lines = include_str!("../reference/planar/superharmonic_third.csv").lines();
    let rows = lines.filter(|l| l.starts_with("10,")).map(|l| l.split(',').map(|c| c.parse().unwrap()).collect::<Vec<f64>>());
    rows.map(|r| (r[1], r[4])).collect()
}

const RANGE: &str = "speed = { from = 400, to = 1200 }\nharmonics = 11";

/// The onset lies between the rows of the table between which the amplitude passes the threshold, the peak is that of the table, and the range that
/// begins at the onset begins at the threshold.
#[test]
fn the_backward_third_superharmonic_has_its_onset() {
    let rows = reference();
    for threshold in [1e-5, 1e-4, 3e-4] {
        let o = machine("per_axis", "10 mm", &format!("{RANGE}\norder_threshold = {threshold}"));
        let f = finding(&o, "superharmonic_range", "drum order 3");
        let (onset, end) = (f.value.unwrap(), evidence(f, "end"));
        for (at, rising) in [(onset, true), (end, false)] {
            let crossed = |w: &&[(f64, f64)]| {
                let up = w[0].1 <= threshold && threshold < w[1].1;
                let down = w[0].1 > threshold && threshold >= w[1].1;
                if rising { up } else { down }
            };
            if let Some(w) = rows.windows(2).find(crossed) {
                assert!(w[0].0 <= at && at <= w[1].0, "{threshold}: {at} not in {w:?}");
            }
        }
        let top = rows.iter().map(|r| r.1).fold(0.0, f64::max);
        let largest = evidence(f, "largest amplitude");
        assert!(largest >= top * (1.0 - 1e-6) && largest < 1.002 * top, "{largest} {top}");
        assert!((evidence(f, "its speed") - 754.7).abs() < 0.5);
        let backward = f.message.args.contains(&("sense", Arg::word("backward")));
        assert!(backward && evidence(f, "forward amplitude there") < 1e-9 * largest, "{}", f.sentence());
        assert!(evidence(f, "scaled residual") < 1e-9);

        let again = machine(
            "per_axis",
            "10 mm",
            &format!("speed = {{ from = {onset}, to = 1200 }}\nharmonics = 11\norder_threshold = {threshold}"),
        );
        let t = again.find_table("orders").unwrap();
        let third = |r: &usize| matches!(&t.column("order").unwrap().data, Data::Text(v) if v[*r] == "3");
        let first = (0..t.rows()).find(third).unwrap();
        let amplitude = t.column("drum amplitude").unwrap().number(first).unwrap();
        assert!((amplitude / threshold - 1.0).abs() < 1e-8, "{amplitude} {threshold}");
    }
}

#[test]
fn the_isotropic_law_has_no_orders() {
    let o = machine("isotropic", "10 mm", "speed = { from = 400, to = 1200 }\norder_threshold = 1e-9");
    assert!(o.findings.iter().any(|f| f.id == "no_orders") && o.find_table("orders").is_none());
}

/// The subharmonic of order 1/3 exists only above a fold, which is its onset.
#[test]
fn a_subharmonic_begins_at_its_fold() {
    let unit = (1.1e7f64 / 2.4).sqrt();
    let study = format!(
        "speed = {{ from = {}, to = {} }}\nharmonics = 5\nstates = \"all\"\nstarts = 0\norder_threshold = 1e-4",
        3.1 * unit,
        3.5 * unit
    );
    let o = machine("per_axis", "1 mm", &study);
    let f = finding(&o, "subharmonic_range", "drum order 1/3");
    assert!((f.value.unwrap() / unit - 3.172_372_26).abs() < 1e-5, "{}", f.value.unwrap() / unit);
    assert!(evidence(f, "largest amplitude") > 1e-3);
    let onset = o.special_points.iter().find(|p| p.kind == "subharmonic onset").unwrap();
    assert!((onset.at - f.value.unwrap()).abs() < 1e-9);
}

/// A branch that turns without a fold, where both planes fold at once, spans its points all the same.
#[test]
fn a_range_spans_its_branch() {
    let study = "speed = { from = 2300, to = 2900 }\nharmonics = 5\nstates = \"all\"\nstarts = 0\norder_threshold = 1e-6";
    let o = machine("per_axis", "1 mm", study);
    let fold = o.special_points.iter().find(|p| p.kind == "fold").unwrap().at;
    let mixed = o.findings.iter().filter(|f| f.id == "superharmonic_range" && f.sentence().contains("x and y on different states"));
    let mut count = 0;
    for f in mixed {
        let (from, to) = (f.value.unwrap(), evidence(f, "end"));
        assert!((from - fold).abs() < 1.0 && to == 2900.0, "{} {fold}", f.sentence());
        count += 1;
    }
    assert!(count > 1, "{:?}", o.findings);
}

/// A symmetry and a number of turns that exclude each other are refused at the field; an odd number of turns keeps orders below 1 with every symmetry.
#[test]
fn turns_and_symmetry_that_exclude_each_other_are_refused() {
    let text = |law: &str, more: &str| {
        let rotor = planar_file(law, "1 mm", ["42", "6.59"]);
        format!("{rotor}\n[[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = 700, to = 710 }}\nharmonics = 4\n{more}\n")
    };
    for (symmetry, turns) in [("quarter", 2), ("half", 2), ("quarter", 4), ("half", 4)] {
        let text = text("per_axis", &format!("symmetry = \"{symmetry}\"\nsubharmonic = {turns}"));
        let found = load(&text).err().unwrap_or_else(|| panic!("{symmetry} {turns}")).0;
        let [d] = found.as_slice() else { panic!("{found:?}") };
        assert!(d.code == "response.symmetry" && d.message.contains(&format!("{turns} turns")), "{d:?}");
        assert!(text[d.span.clone().unwrap()].contains(symmetry), "{d:?}");
        assert!(d.help.as_deref().is_some_and(|h| h.contains("none")), "{d:?}");
    }
    for (symmetry, turns) in [("none", 2), ("auto", 2), ("half", 3), ("quarter", 3), ("quarter", 1)] {
        assert!(load(&text("per_axis", &format!("symmetry = \"{symmetry}\"\nsubharmonic = {turns}"))).is_ok(), "{symmetry} {turns}");
    }
    // no symmetry is imposed on two turns, and none is reported
    let o = machine(
        "per_axis",
        "1 mm",
        "speed = { from = 700, to = 710 }\nharmonics = 4\nsubharmonic = 2\nstability = false\nstates = \"all\"\nstarts = 0",
    );
    let Data::Text(symmetry) = &o.find_table("branches").unwrap().column("symmetry").unwrap().data else { panic!("no text") };
    assert!(!symmetry.is_empty() && symmetry.iter().all(|s| s == "none"), "{symmetry:?}");
    // circular motion has one order: none of three turns
    for (more, refused) in [("subharmonic = 3", true), ("subharmonic = 3\nsymmetry = \"half\"", false), ("subharmonic = 1", false)] {
        let loaded = load(&text("isotropic", more)).unwrap();
        let codes: Vec<_> = loaded.refusals().iter().map(|r| r.diagnostic.code).collect();
        assert_eq!(codes, if refused { vec!["response.subharmonic"] } else { vec![] }, "{more}");
    }
    for (symmetry, turns, slow) in [
        (Symmetry::Quarter, 3, vec![-1]),
        (Symmetry::Quarter, 5, vec![1, -3]),
        (Symmetry::Half, 3, vec![1, -1]),
        (Symmetry::Half, 2, vec![]),
    ] {
        let below: Vec<i32> = admitted(symmetry, 7, turns).0.into_iter().filter(|n| n.unsigned_abs() < turns as u32 && *n != 0).collect();
        assert_eq!(below, slow, "{symmetry:?} {turns}");
    }
}
