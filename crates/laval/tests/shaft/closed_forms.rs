//! Shafts with closed forms: vibration of a rotating pinned shaft, buckling under a force and under a torque, convergence in elements.

use super::definition::{file, list, number, numbers};
use crate::common::files::load;
use laval::model::system::System;
use laval::solve::pencil::{Linearised, modes_about};
use laval::solve::rest::rest;
use laval_num::complex::C64;
use serde_json::Value;
use std::f64::consts::PI;

/// A shaft with both ends held in place, free to lean.
fn pinned(section: &str, count: usize, more: &str, stiffness: f64) -> System {
    let end = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nkxx = {stiffness:?}\nkyy = {stiffness:?}\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"pinned\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {count}\nsection = {{ {section} }}\n{more}\n{}{}",
        end("lower", 0.0),
        end("upper", 1.0)
    );
    load(&text).system
}

fn values(system: &System, speed: f64) -> Vec<C64> {
    let all = Linearised::new(system, &rest(system, speed).unwrap()).unwrap().spectrum().unwrap().modes;
    all.iter().map(|m| m.value).filter(|s| s.im > 0.0).collect()
}

fn material(v: &Value) -> String {
    let of = |k: &str| v.get(k).and_then(Value::as_f64);
    let mut out = format!("modulus = {:?}\n", of("E").unwrap());
    for (key, word) in [("G", "shear_modulus"), ("rho", "density")] {
        if let Some(x) = of(key) {
            out += &format!("{word} = {x:?}\n");
        }
    }
    out
}

/// Forward and backward frequencies of a rotating shaft of Timoshenko converge at second order at least in the length of the elements.
#[test]
fn rotating_pinned_shaft() {
    let case = &file("closed_forms")["rotating_pinned_timoshenko"];
    let shaft = &case["shaft"];
    let section = format!("length = [1.0], outer_diameter = [{:?}]", number(&shaft["D"]));
    let far = |count: usize, row: &Value, modes: usize| -> f64 {
        let system = pinned(&section, count, &material(shaft), 1e14);
        let found = values(&system, number(&row["speed_rad_s"]));
        let expected = list(&row["modes"]).iter().take(modes).flat_map(|m| [number(&m["backward_rad_s"]), number(&m["forward_rad_s"])]);
        let away = |w: f64| found.iter().map(|s| (s.im / w.abs() - 1.0).abs()).fold(f64::INFINITY, f64::min);
        expected.map(away).fold(0.0, f64::max)
    };
    for row in list(&case["rows"]) {
        let errors = [8, 16, 32].map(|n| far(n, row, 2));
        assert!(errors[2] < 5e-4, "{errors:?}");
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!(order > 1.9, "{errors:?}");
        }
    }
}

/// The first frequency vanishes under the axial force, and the torque, of the closed forms.
#[test]
fn buckling() {
    let forms = file("closed_forms");
    for (case, key, word) in [("pinned_euler_buckling", "axial_force_N", "axial_force"), ("pinned_torque_buckling", "torque_Nm", "torque")]
    {
        let (case, shaft) = (&forms[case], &forms[case]["shaft"]);
        let load = number(&case[key]);
        let section = format!("length = [{:?}], outer_diameter = [{:?}]", number(&shaft["L"]), number(&shaft["D"]));
        // the square of the lowest frequency is positive below the load of buckling and negative above; a torque makes it a growing motion
        let stable = |share: f64| {
            let more = format!("{}shear = \"none\"\n{word} = {:?}\n", material(shaft), share * load);
            let system = pinned(&section, 20, &more, 1e11);
            let all = Linearised::new(&system, &rest(&system, 0.0).unwrap()).unwrap().spectrum().unwrap().modes;
            let low = all.iter().map(|m| m.value).filter(|s| s.im < 1e3);
            let largest = low.map(|s| s.re).fold(f64::NEG_INFINITY, f64::max);
            largest < 1e-2
        };
        assert!(stable(0.998) && !stable(1.002), "{word}");
    }
}

/// Cones by their flexibility converge to the limit of the mesh far faster than with the section in the middle.
#[test]
fn cones_converge() {
    let case = &file("closed_forms")["mesh_limit_solid_cone"];
    let limit = numbers(&case["first_three_rad_s"])[0];
    let more = "modulus = 2.11e11\nshear_modulus = 8.12e10\ndensity = 7810.0\n";
    let far = |count: usize, cone: &str| {
        let section = "length = [1.0], outer_diameter = [0.03], end_outer_diameter = [0.09]";
        let system = pinned(section, count, &format!("{more}cone = \"{cone}\"\n"), 1e12);
        let lowest = values(&system, 0.0).iter().map(|s| s.im).fold(f64::INFINITY, f64::min);
        (lowest / limit - 1.0).abs()
    };
    // theory page: 3.3e-4, 4.4e-5, 8.4e-6 against 7.9e-3, 4.1e-3, 2.2e-3
    for (count, flexible, middle) in [(4, 3.3e-4, 7.9e-3), (8, 4.4e-5, 4.1e-3), (16, 8.4e-6, 2.2e-3)] {
        let (a, b) = (far(count, "flexibility"), far(count, "mid_section"));
        assert!((a / flexible - 1.0).abs() < 0.1 && (b / middle - 1.0).abs() < 0.1, "{count}: {a:e} {b:e}");
    }
}

/// Pinned slender shafts of few elements, with motion along and about the axis and without: one element takes the sine for a cubic (9.87 becomes 10.95).
#[test]
fn shafts_of_few_elements() {
    let (e, density, l, d) = (2.1e11f64, 7850.0, 1.0, 0.02);
    let bending = (PI / l).powi(2) * (e / density).sqrt() * 0.25 * d;
    for elements in 1..=6 {
        for more in ["", "axial = true\n", "axial = true\ntorsional = true\n"] {
            let held = |name: &str, at: f64| {
                format!(
                    "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"s\", at = {at:?} }}, \"ground\"]\nkxx = 1e11\nkyy = 1e11\nkzz = 1e6\n"
                )
            };
            let text = format!(
                "[machine]\nname = \"t\"\n[[part]]\nkind = \"shaft\"\nname = \"s\"\nmaterial = \"steel\"\nelements = {elements}\n{more}section = [{{ length = 1.0, outer_diameter = {d:?} }}]\n{}{}",
                held("a", 0.0),
                held("b", l)
            );
            let text = if more.is_empty() { text.replace("kzz = 1e6\n", "") } else { text };
            let system = load(&text).system;
            let all = modes_about(&system, &rest(&system, 0.0).unwrap(), false).unwrap().modes;
            let first =
                all.iter().filter(|m| m.whirl.is_lateral() && m.frequency() > 1.0).map(|m| m.frequency()).fold(f64::INFINITY, f64::min);
            let high = if elements == 1 { 0.12 } else { 0.005 };
            assert!(first > 0.995 * bending && first < (1.0 + high) * bending, "{elements} {more:?}: {first} {bending}");
        }
    }
}
