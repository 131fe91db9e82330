//! The response in fewer points and without what is measured beside displacements, against the whole one.

use crate::common;

use common::planar_file::{oil, planar_file};
use laval::file::load;
use laval::model::system::System;
use laval::outcome::{Data, Outcome};
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::{Context, TypedStudy};

/// A disc on two springs that stiffen: it tilts as well.
const TILTING: &str = r#"
[machine]
name = "overhung"
[[part]]
kind = "disc"
name = "rotor"
mass = 8
diametral_inertia = 0.12
polar_inertia = 0.05
eccentricity = "15 um"
[[part]]
kind = "bearing_cubic"
name = "lower"
between = [{ body = "rotor", at = "-120 mm" }, "ground"]
law = "per_axis"
stiffness = 2e6
cubic_stiffness = 4e14
[[part]]
kind = "bearing_cubic"
name = "upper"
between = [{ body = "rotor", at = "180 mm" }, "ground"]
law = "per_axis"
stiffness = 1e6
cubic_stiffness = 2e14
[[part]]
kind = "damper"
name = "air"
between = ["rotor", "ground"]
damping = 60
tilt_damping = 0.5
"#;

fn system(text: &str) -> System {
    load(text).unwrap_or_else(|d| panic!("{d:?}")).system
}

fn outcome(system: &System, study: &NonlinearResponse) -> Outcome {
    let result = study.result(system, &Context::quiet("response")).unwrap_or_else(|d| panic!("{d:?}"));
    study.outcome(system, &result, "response").unwrap_or_else(|d| panic!("{d:?}"))
}

fn floats<'a>(o: &'a Outcome, name: &str) -> &'a [f64] {
    match &o.find_table("response").unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v,
        other => panic!("{other:?}"),
    }
}

fn folds(o: &Outcome) -> Vec<f64> {
    o.special_points.iter().filter(|p| p.kind == "fold").map(|p| p.at).collect()
}

fn most(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[test]
fn a_sketch_has_the_folds_and_the_sizes_of_the_response_in_fewer_points() {
    let planar = planar_file("per_axis", "20 um", ["42", "6.59"]);
    let with_oil = format!("{}{}", planar_file("per_axis", "40 um", ["150", "6.59"]), oil("40 mm", "5"));
    for (text, range, columns) in [
        (planar.as_str(), (25.0, 5000.0), vec!["drum largest displacement", "base largest displacement"]),
        (with_oil.as_str(), (25.0, 4000.0), vec!["drum largest displacement", "base largest displacement"]),
        (TILTING, (50.0, 3000.0), vec!["rotor largest displacement", "rotor tilt"]),
    ] {
        let system = system(text);
        let of = || NonlinearResponse::new(Request { harmonics: Some(7), ..Request::over(range.0, range.1) });
        let (whole, sketch) = (outcome(&system, &of()), outcome(&system, &of().sketch()));
        let (all, few) = (folds(&whole), folds(&sketch));
        assert_eq!(all.len(), few.len(), "{all:?} {few:?}");
        assert!(all.iter().zip(&few).all(|(a, b)| (a - b).abs() <= 1e-9 * a), "{all:?} {few:?}");
        let (n, m) = (floats(&whole, "speed").len(), floats(&sketch, "speed").len());
        assert!(m < 9 * n / 10 && m > n / 3, "{m} of {n} points");
        for name in columns {
            let (a, b) = (most(floats(&whole, name)), most(floats(&sketch, name)));
            assert!(a > 0.0 && (a - b).abs() <= 0.02 * a, "{name}: {a} {b}");
        }
        let growth = |o: &Outcome| most(floats(o, "growth rate"));
        assert!((growth(&whole) - growth(&sketch)).abs() <= 0.05 * growth(&whole).max(1.0), "{} {}", growth(&whole), growth(&sketch));
        // nothing that was not measured
        assert!(sketch.findings.is_empty() && sketch.tables.len() == 1 && sketch.figures.len() == 1);
        let names = sketch.tables[0].columns().iter().map(|c| c.name.clone()).collect::<Vec<_>>();
        assert!(!names.iter().any(|n| n.contains("force") || n == "validity"), "{names:?}");
        assert!(whole.tables.iter().any(|t| t.columns().iter().any(|c| c.name == "validity")));
        let panels = |o: &Outcome| o.figures[0].panels.len();
        assert_eq!(panels(&whole), panels(&sketch));
    }
}

/// The range ends among several states: the branch from its slow end does not lead to the state of the fast one, which is followed as well.
#[test]
fn a_sketch_follows_the_second_branch_where_the_first_does_not_lead_there() {
    let system = system(&planar_file("per_axis", "60 um", ["20", "6.59"]));
    let of = |to: f64| NonlinearResponse::new(Request { harmonics: Some(7), ..Request::over(25.0, to) });
    for study in [of(5000.0), of(5000.0).sketch()] {
        let result = study.result(&system, &Context::quiet("response")).unwrap();
        assert_eq!(result.response.branches.len(), 2);
        let all = folds(&study.outcome(&system, &result, "response").unwrap());
        assert!(all.len() == 1 && (all[0] - 2_301.412_251).abs() < 1e-6, "{all:?}");
    }
}
