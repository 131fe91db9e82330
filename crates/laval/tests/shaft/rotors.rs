//! Rotors of the reference files: eigenvalues, critical speeds, unbalance responses, sag.

use super::definition::{file, list, number, numbers, rotor};
use laval::model::system::System;
use laval::solve::criticals::criticals;
use laval::solve::large::is_large;
use laval::solve::linear_response::response;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use laval::solve::roots::{Request, roots};
use laval::solve::sweep::sweep;
use laval_num::complex::{C64, c};
use serde_json::Value;

pub const ROTORS: [&str; 14] = [
    "lalanne_ferraris_3disc",
    "nelson_mcvaugh_iso",
    "overhung_disc_6el",
    "single_disc_fixed_frame_beta",
    "soft_bearings_overhung_6el",
    "two_disc_anisotropic_48el",
    "two_disc_axial_100kN_6el",
    "two_disc_cross_coupled_48el",
    "two_disc_damped_6el",
    "two_disc_general_6el",
    "two_disc_isotropic_48el",
    "two_disc_isotropic_6el",
    "two_disc_pedestals",
    "two_disc_proportional_33el",
];

fn complex(v: &Value) -> C64 {
    let [re, im] = numbers(v)[..] else { panic!("{v} is no complex number") };
    c(re, im)
}

/// All oscillating modes with frequencies up to a limit.
pub fn modes(system: &System, speed: f64, limit: f64) -> Vec<C64> {
    let about = rest(system, speed).unwrap();
    let all = if is_large(system) {
        let found = roots(system, &about, &Request { frequency: Some(limit), ..Request::default() }).unwrap();
        assert!(found.areas.iter().all(|a| a.complete()), "{:?}", found.areas);
        found.spectrum.modes
    } else {
        Linearised::new(system, &about).unwrap().spectrum().unwrap().modes
    };
    all.iter().map(|m| m.value).filter(|s| s.im > 1e-3 && s.im <= limit).collect()
}

/// Every value of the reference is a mode, each once.
pub fn held(expected: &[C64], found: &[C64], tolerance: f64, what: &str) {
    let mut left = found.to_vec();
    for s in expected {
        let best = (0..left.len()).min_by(|&i, &j| (left[i] - *s).abs().total_cmp(&(left[j] - *s).abs()));
        let k = best.unwrap_or_else(|| panic!("{what}: no mode left for {s:?}"));
        let away = (left.swap_remove(k) - *s).abs() / s.abs();
        assert!(away <= tolerance, "{what}: {s:?} is {away:e} away");
    }
}

/// Eigenvalues at every speed of every file, to nine digits.
#[test]
fn eigenvalues() {
    for name in ROTORS {
        let file = file(name);
        let system = rotor(&file["definition"], "", "");
        for at in list(&file["modal"]) {
            let speed = number(&at["speed_rad_s"]);
            let expected: Vec<C64> = list(&at["lateral_eigenvalues"]).iter().map(complex).collect();
            let top = expected.iter().map(|s| s.im).fold(0.0, f64::max);
            let found = modes(&system, speed, 1.001 * top);
            let what = format!("{name} at {speed} rad/s");
            // repeated pairs, as of an isotropic rotor at rest, are known to eight digits
            held(&expected, &found, if speed == 0.0 { 1e-8 } else { 2e-9 }, &what);
            // none of those below the highest is left over
            let below = |all: &[C64]| all.iter().filter(|s| s.im < 0.999 * top && s.re.abs() < 0.999 * s.abs()).count();
            assert_eq!(below(&found), below(&expected), "{what}: {found:?} {expected:?}");
        }
    }
}

/// Where the frequency of a mode is the speed.
#[test]
fn critical_speeds() {
    for name in ROTORS {
        let file = file(name);
        let Some(expected) = file.get("critical_speeds_lateral") else { continue };
        let system = rotor(&file["definition"], "", "");
        let (values, range) = (numbers(&expected["values_rad_s"]), numbers(&expected["range_rad_s"]));
        let state = |w: f64| rest(&system, w);
        let speeds: Vec<f64> = (0..=40).map(|k| range[0] + (range[1] - range[0]) * f64::from(k) / 40.0).collect();
        let branches = sweep(&system, &state, &speeds, 2.0 * range[1], |_, _| true).unwrap();
        let mut found: Vec<f64> = criticals(&system, &state, &branches, &[1.0]).iter().filter(|c| c.located()).map(|c| c.speed).collect();
        found.sort_by(f64::total_cmp);
        found.retain(|w| *w > 1e-3);
        assert_eq!(found.len(), values.len(), "{name}: {found:?} {values:?}");
        for (a, b) in found.iter().zip(&values) {
            assert!((a / b - 1.0).abs() < 1e-7, "{name}: {a} {b}");
        }
    }
}

/// Amplitudes of every probe under an unbalance.
#[test]
fn unbalance_responses() {
    for name in ROTORS.iter().chain(&["two_disc_unbalance_6el"]) {
        let file = file(name);
        let Some(unbalance) = file.get("unbalance") else { continue };
        let nodes = numbers(&file["definition"]["nodes_pos_m"]);
        let place = nodes[unbalance["node"].as_u64().unwrap() as usize];
        let (size, phase) = (number(&unbalance["unbalance_kg_m"]), number(&unbalance["phase_rad"]));
        // a disc without mass worth speaking of carries it
        let more = format!(
            "[[part]]\nkind = \"disc\"\nname = \"unbalance\"\non = {{ body = \"shaft\", at = {place:?} }}\nmass = 1e-9\nunbalance = {size:?}\neccentricity_phase = {phase:?}\n"
        );
        let system = rotor(&file["definition"], "", &more);
        for at in list(&unbalance["points"]) {
            let speed = number(&at["speed_rad_s"]);
            let found = response(&system, &|w| rest(&system, w), speed).unwrap().unwrap();
            for (node, expected) in at["probes"].as_object().unwrap() {
                let Some(z) = nodes.get(node.parse::<usize>().unwrap()) else { continue };
                let slot = system.slots().iter().position(|s| s.name == "shaft").unwrap();
                let [x, y] = system.point(slot, *z).unwrap().amplitudes(&found.x);
                let size = number(&expected["major_m"]);
                for (own, key) in [(x, "x"), (y, "y")] {
                    let away = (own - complex(&expected[key])).abs() / size;
                    assert!(away < 1e-6, "{name} at {speed} rad/s, node {node} {key}: {away:e}");
                }
            }
        }
    }
}

/// Sag of a lying rotor on the stiffness of its bearings.
#[test]
fn sag() {
    for name in ROTORS {
        let file = file(name);
        let Some(expected) = file.get("static_bearing_stiffness") else { continue };
        let system = rotor(&file["definition"], "axis = \"horizontal\"", "");
        let q = rest(&system, 0.0).unwrap().q;
        let nodes = numbers(&file["definition"]["nodes_pos_m"]);
        let slot = system.slots().iter().position(|s| s.name == "shaft").unwrap();
        let (xs, ys) = (numbers(&expected["x_m"]), numbers(&expected["y_m"]));
        // the reference leaves out the weight of pedestals
        let pedestal = list(&file["definition"]["point_masses"]).first().map_or(0.0, |p| number(&p["my"]) * 9.80665 / 1e8);
        let ys: Vec<f64> = ys.into_iter().map(|y| y - pedestal).collect();
        let size = ys.iter().fold(0.0f64, |m, y| m.max(y.abs()));
        for ((z, x), y) in nodes.iter().zip(xs).zip(ys) {
            let [own_x, own_y] = system.point(slot, *z).unwrap().of(&q);
            assert!((own_x - x).hypot(own_y - y) < 1e-8 * size, "{name}, {z} m: {own_x} {x}, {own_y} {y}");
        }
    }
}

/// Damping of the material, in axes that turn, makes the first forward mode grow from the published speed on, and the same damping in fixed axes never.
#[test]
fn onset_of_rotating_damping() {
    let file = file("rotating_damping_onset");
    let model = file.get("definition").or(file.get("model")).unwrap();
    let system = rotor(model, "", "");
    for at in list(&file["points"]) {
        let speed = number(&at["speed_rad_s"]);
        let expected: Vec<C64> = list(&at["lateral_eigenvalues"]).iter().map(complex).collect();
        let top = expected.iter().map(|s| s.im).fold(0.0, f64::max);
        held(&expected, &modes(&system, speed, 1.1 * top), 2e-9, &format!("at {speed} rad/s"));
    }
    let onset = number(&file["onset_speed_rad_s"]);
    let growth = |w: f64| modes(&system, w, 1e4).iter().map(|s| s.re).fold(f64::NEG_INFINITY, f64::max);
    assert!(growth(onset * (1.0 - 1e-7)) < 0.0 && growth(onset * (1.0 + 1e-7)) > 0.0);
    let fixed = system.with(&[("shaft.rotating_damping", 0.0), ("shaft.stiffness_damping", 2e-4)]).unwrap();
    let growth = |w: f64| modes(&fixed, w, 1e4).iter().map(|s| s.re).fold(f64::NEG_INFINITY, f64::max);
    assert!([0.5, 1.0, 2.0, 6.0].into_iter().all(|k| growth(k * onset) < 0.0));
}
