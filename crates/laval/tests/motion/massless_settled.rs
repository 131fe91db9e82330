//! Settled motions, their basins and exponents where a node has no inertia: against the machine of one spring, small masses, and each other.

use crate::common::base::{Found, request, states_at};
use crate::common::files::{load, run_all};
use laval::model::system::System;
use laval::outcome::{Data, Outcome, Table};
use laval::solve::harmonic::branches::response::respond;
use laval::solve::harmonic::stability::floquet::Stability;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use std::sync::atomic::AtomicBool;

const K1: f64 = 2.2e7;
const K2: f64 = 6e6;

/// A rotor in a cubic bearing; between the bearing and `support` a node of this mass.
fn chain(law: &str, mass: &str, support: &str, studies: &str) -> String {
    format!(
        "[machine]\nspeed = 1500\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 2.4\neccentricity = 1e-3\n\
         [[part]]\nkind = \"disc\"\nname = \"node\"\nmass = {mass}\n\
         [[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"rotor\", \"node\"]\nlaw = \"{law}\"\nstiffness = 1.1e7\ncubic_stiffness = 8.7e10\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"support\"\nbetween = [\"node\", \"ground\"]\n{support}\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"rotor\", \"ground\"]\ndamping = 300\n{studies}"
    )
}

/// The cubic bearing on the ground, the rotor beside it on two springs in series, or on the one that they amount to.
fn beside(law: &str, series: bool) -> String {
    let springs = if series {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"node\"\nmass = 0\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"rotor\", \"node\"]\nname = \"upper\"\nstiffness = {K1}\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"node\", \"ground\"]\nname = \"lower\"\nstiffness = {K2}\n"
        )
    } else {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nbetween = [\"rotor\", \"ground\"]\nname = \"both\"\nstiffness = {}\n",
            K1 * K2 / (K1 + K2)
        )
    };
    format!(
        "[machine]\nspeed = 1500\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 2.4\neccentricity = 1e-3\n\
         [[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\nlaw = \"{law}\"\nstiffness = 1.1e7\ncubic_stiffness = 8.7e10\n{springs}\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"rotor\", \"ground\"]\ndamping = 300\n"
    )
}

fn system(text: &str) -> System {
    load(text).system
}

/// States at a speed by size, with their growth rates.
fn states(system: &System, range: (f64, f64), speed: f64) -> Vec<Found> {
    static NEVER: AtomicBool = AtomicBool::new(false);
    let response = respond(system, &request(range.0, range.1), &NEVER, &|_| {}).unwrap_or_else(|d| panic!("{d:?}"));
    let mut found = states_at(system, &response, range, speed, true);
    found.sort_by(|a, b| a.z[0].total_cmp(&b.z[0]));
    found
}

/// Three motions, the middle one unstable, each with the growth of the machine of one spring; circular ones and others.
#[test]
fn growth_is_that_of_the_machine_of_one_spring() {
    for law in ["isotropic", "per_axis"] {
        let [two, one] = [true, false].map(|series| states(&system(&beside(law, series)), (2600.0, 4600.0), 4000.0));
        assert!(two.len() >= 3 && two.len() == one.len(), "{law}: {} {}", two.len(), one.len());
        assert!(two.iter().any(|s| s.growth > 10.0) && two.iter().any(|s| s.growth < -10.0));
        for (a, b) in two.iter().zip(&one) {
            assert!((a.growth - b.growth).abs() < 1e-5 * b.growth.abs().max(50.0), "{law}: {} {}", a.growth, b.growth);
            assert!((a.z[0] / b.z[0] - 1.0).abs() < 1e-8);
        }
    }
}

/// The node carries a nonlinear bearing and a damper: growth rates differ from those with a small mass in proportion to it.
#[test]
fn growth_converges_with_the_mass_of_a_damped_node() {
    let support = "stiffness = 9e6\ndamping = 2000";
    for law in ["isotropic", "per_axis"] {
        let of = |mass: &str| states(&system(&chain(law, mass, support, "")), (1400.0, 1800.0), 1600.0);
        let none = of("0");
        assert!(!none.is_empty());
        for (k, s) in none.iter().enumerate() {
            let away = |mass: &str| (of(mass)[k].growth - s.growth).abs();
            let (coarse, fine) = (away("4e-3"), away("4e-4"));
            assert!(coarse < 0.05 * s.growth.abs() && fine < 0.2 * coarse && coarse > 0.0, "{law}: {} {coarse} {fine}", s.growth);
        }
    }
}

/// A part whose internal states read the place of a node, damped or not, where the cubic force is small: decay rates of circular motions are those of the modes.
#[test]
fn internal_states_that_read_a_node_are_differentiated_through_it() {
    static NEVER: AtomicBool = AtomicBool::new(false);
    for damping in [0.0, 2000.0] {
        let support = format!("stiffness = 4e6\ndamping = {damping}");
        let more = "[[part]]\nkind = \"shaft_viscoelastic\"\nname = \"shaft\"\nbetween = [\"node\", \"ground\"]\nstiffness = 5e6\n\
                    exponentials = { share = [0.3], rate = [900] }\n";
        let system = system(&chain("isotropic", "0", &support, more).replace("8.7e10", "1e3"));
        let response = respond(&system, &request(1500.0, 1700.0), &NEVER, &|_| {}).unwrap();
        let point = &response.branches[0].points[3];
        let mut found: Vec<f64> = point.exponents.as_ref().unwrap().values.iter().filter(|s| s.im > 0.0).map(|s| s.re).collect();
        let modes = Linearised::new(&system, &rest(&system, point.speed).unwrap()).unwrap().spectrum().unwrap().modes;
        let mut modes: Vec<f64> = modes.iter().map(|m| m.value.re).collect();
        found.sort_by(f64::total_cmp);
        modes.sort_by(f64::total_cmp);
        assert!(found.len() >= 3 && found.len() == modes.len(), "{found:?} {modes:?}");
        for (a, b) in found.iter().zip(&modes) {
            assert!((a / b - 1.0).abs() < 1e-6, "{damping}: {found:?} {modes:?}");
        }
    }
}

/// Two halves of a pair of which one alone is damped cannot be turned together.
#[test]
fn a_pair_of_unlike_halves_is_not_assessed() {
    let half = system(&chain("per_axis", "0", "kxx = 9e6\nkyy = 8e6\ncxx = 2000", ""));
    assert!(Stability::new(&half).is_err());
    assert!(Stability::new(&system(&chain("per_axis", "0", "kxx = 9e6\nkyy = 8e6", ""))).is_ok());
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    let t = o.find_table(table).unwrap_or_else(|| panic!("no table {table} in {:?}", o.tables.iter().map(Table::name).collect::<Vec<_>>()));
    match &t
        .column(name)
        .unwrap_or_else(|| panic!("no {name} in {:?}", t.columns().iter().map(|c| c.name.clone()).collect::<Vec<_>>()))
        .data
    {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// Sweeps settle on the motions of the harmonic response, by both methods; a basin map finds the same.
#[test]
fn sweeps_and_basins_find_the_states_of_the_response() {
    let studies = "[[study]]\nkind = \"nonlinear_response\"\nspeed = { from = 1300, to = 1500 }\n\
                   [[study]]\nkind = \"sweep\"\nspeed = { from = 1300, to = 1500, points = 3 }\n\
                   [[study]]\nkind = \"sweep\"\nspeed = { from = 1300, to = 1500, points = 2 }\nmethod = \"stiff\"\nrelative_tolerance = 1e-5\n\
                   [[study]]\nkind = \"basins\"\nspeed = 1400\npoints = 3\nfrom = { \"rotor.x\" = \"-1 mm\", \"rotor.y\" = \"-1 mm\" }\nto = { \"rotor.x\" = \"1 mm\", \"rotor.y\" = \"1 mm\" }\n";
    let support = "stiffness = 9e6\ndamping = 2000";
    let outcomes = run_all(&chain("isotropic", "0", support, studies));
    let (speeds, largest) = (column(&outcomes[0], "response", "speed"), column(&outcomes[0], "response", "rotor largest displacement"));
    let at = |speed: f64| {
        let k = speeds.windows(2).position(|w| (w[0] - speed) * (w[1] - speed) <= 0.0).unwrap();
        let t = (speed - speeds[k]) / (speeds[k + 1] - speeds[k]);
        largest[k] + t * (largest[k + 1] - largest[k])
    };
    for o in &outcomes[1..3] {
        let (w, r) = (column(o, "sweep", "speed"), column(o, "sweep", "amplitude.rotor"));
        assert!(w.len() >= 4);
        for (w, r) in w.iter().zip(&r) {
            assert!((r / at(*w) - 1.0).abs() < 2e-3, "{w}: {r} {}", at(*w));
        }
    }
    let motions = column(&outcomes[3], "attractors", "amplitude.rotor");
    assert!(motions.len() == 1 && (motions[0] / at(1400.0) - 1.0).abs() < 2e-3, "{motions:?} {}", at(1400.0));
}
