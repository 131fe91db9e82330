//! Every registered study on every hard part: an answer, or a refusal that names the part; and two linear programs that must agree.

use super::tools::{orbits, response};
use super::{chain, fractional, memory, pendulum_tests, tabulated};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::model::field::{RangeValue, Value, Values};
use laval::model::system::System;
use laval::outcome::Outcome;
use laval::solve::rest::rest;
use laval::study::{Context, registry};

fn run(system: &System, kind: &str, extra: &[(&str, Value)]) -> Result<Outcome, Diagnostic> {
    let study = registry().into_iter().find(|k| k.info.kind == kind).unwrap();
    let mut values = Values::default();
    let (from, to) = (300.0, 500.0);
    match kind {
        "transient" => {
            values.set("duration", Value::Number(0.02), None);
            values.set("speed", Value::Number(from), None);
        }
        _ => values.set("speed", Value::Range(RangeValue { from, to, points: Some(5) }), None),
    }
    for (name, value) in extra {
        values.set(name, value.clone(), None);
    }
    let mut diagnostics = Diagnostics::default();
    match (study.build)(&values, system, &mut diagnostics) {
        Some(study) if !diagnostics.has_errors() => study.run(system, &Context::quiet("hard")),
        _ => Err(diagnostics.0.into_iter().next().unwrap()),
    }
}

/// The linear response by the characteristic matrix and by one harmonic, to rounding.
#[test]
fn forced_response_equals_nonlinear_response_of_a_linear_machine() {
    let machines = [
        ("memory", memory::linear(false)),
        ("rotor memory", memory::linear(true)),
        ("fractional", fractional::linear()),
        ("table", tabulated::linear()),
        ("chain", chain::linear()),
    ];
    for (name, system) in machines {
        let range = (200.0, 600.0);
        for o in orbits(&system, &response(&system, range), range) {
            let x = laval::solve::linear_response::response(&system, &|w| rest(&system, w), o.speed).unwrap().unwrap();
            let first = o.orders.iter().position(|&k| k == 1).unwrap();
            let n = system.n();
            let size = x.x[..n].iter().map(|z| z.abs()).fold(0.0, f64::max);
            for (i, (a, b)) in o.coordinates[first].iter().zip(&x.x).enumerate() {
                // at a resonance of the chain its softest mode stands 1e7 below its stiffest
                let tolerance = if name == "chain" { 1e-8 } else { 1e-10 };
                assert!((*a - *b).abs() <= tolerance * size, "{name} coordinate {i} at {}: {a:?} {b:?}", o.speed);
            }
        }
    }
}

/// What each study says of each part.
#[test]
fn every_study_answers_or_names_the_part() {
    let machines = [
        ("memory", "joint", memory::linear(true)),
        ("fractional", "polymer", fractional::linear()),
        ("table", "bearing", tabulated::linear()),
        ("chain", "chain", chain::linear()),
        ("pendulum", "arm", pendulum_tests::swinging()),
    ];
    for (name, part, system) in &machines {
        for kind in ["campbell", "critical_speeds", "stability_map", "forced_response", "nonlinear_response", "transient"] {
            if matches!(*name, "memory" | "chain") && matches!(kind, "critical_speeds" | "stability_map" | "forced_response") {
                continue; // searches over hundreds of eigenvalues at many speeds
            }
            let answer = run(system, kind, &[]);
            let refused = matches!((*name, kind), ("fractional", "campbell" | "critical_speeds" | "stability_map" | "transient"));
            // an arm that hangs in the spin's field alone has no rest
            let no_rest = *name == "pendulum" && matches!(kind, "campbell" | "critical_speeds" | "stability_map" | "forced_response");
            match answer {
                Ok(outcome) => {
                    assert!(!refused && !no_rest, "{kind} answered for {name}");
                    assert!(!outcome.tables.is_empty(), "{kind} of {name} is empty");
                }
                Err(d) if refused || no_rest => assert!(d.message.contains(&format!("\"{part}\"")), "{kind} of {name}: {d}"),
                Err(d) => panic!("{kind} of {name}: {d}"),
            }
        }
    }
    let explicit = run(&machines[0].2, "transient", &[("method", Value::Choice("explicit"))]).unwrap_err();
    assert!(explicit.message.contains("\"joint\""), "{explicit}");
}
