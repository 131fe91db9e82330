//! Vibration of shafts along and about their axis: published rotors, bars, drive lines, the weight of a vertical shaft, a rotor that is driven through a coupling.

use super::definition::{file, list, number, numbers, text};
use crate::common::files::{finding, load, run_all};
use laval::model::system::System;
use laval::solve::pencil::{Linearised, MachineMode, Whirl};
use laval::solve::rest::rest;
use std::f64::consts::PI;

fn modes(system: &System, speed: f64) -> Vec<MachineMode> {
    Linearised::new(system, &rest(system, speed).unwrap()).unwrap().spectrum().unwrap().modes
}

/// Frequencies of one kind of motion, rising.
fn frequencies(system: &System, speed: f64, whirl: Whirl) -> Vec<f64> {
    modes(system, speed).iter().filter(|m| m.whirl == whirl).map(MachineMode::frequency).collect()
}

const BOTH: &str = "axial = true\ntorsional = true\n";

/// Frequencies along and about the axis of the reference rotors, whose cones have mean end sections, at rest and at speed; the lateral ones are those of a shaft
/// that bends only.
#[test]
fn published_rotors() {
    for name in
        ["two_disc_isotropic_6el", "overhung_disc_6el", "lalanne_ferraris_3disc", "two_disc_pedestals", "soft_bearings_overhung_6el"]
    {
        let file = file(name);
        let system = load(&text(&file["definition"], "axis = \"horizontal\"", BOTH)).system;
        let plain = load(&text(&file["definition"], "axis = \"horizontal\"", "")).system;
        for at in list(&file["modal"]) {
            let speed = number(&at["speed_rad_s"]);
            let expected = numbers(&at["axial_torsional_rad_s"]);
            let all = modes(&system, speed);
            let top = expected.iter().copied().fold(0.0, f64::max);
            let mut found: Vec<f64> = all
                .iter()
                .filter(|m| !m.whirl.is_lateral())
                .map(MachineMode::frequency)
                .filter(|w| *w > 1.0 && *w < 1.0001 * top)
                .collect();
            found.sort_by(f64::total_cmp);
            assert_eq!(found.len(), expected.len(), "{name} at {speed}: {found:?} {expected:?}");
            for (a, b) in found.iter().zip(&expected) {
                assert!((a / b - 1.0).abs() < 1e-8, "{name} at {speed}: {a} {b}");
            }
            if speed > 0.0 {
                let lateral = |system: &System| -> Vec<f64> {
                    modes(system, speed).iter().filter(|m| m.whirl.is_lateral()).map(MachineMode::frequency).collect()
                };
                let (own, alone) = (lateral(&system), lateral(&plain));
                assert_eq!(own.len(), alone.len(), "{name} at {speed}");
                // those of the highest frequencies are known to the rounding of the matrices
                let close = |(a, b): (&f64, &f64)| (a / b - 1.0).abs() < 1e-8;
                assert!(own.iter().zip(&alone).all(close), "{name} at {speed}");
            }
        }
    }
}

fn bar(elements: usize, shaft: &str, more: &str) -> String {
    format!(
        "[machine]\nname = \"bar\"\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\n{shaft}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"lower\"\nbetween = [\"shaft\", \"ground\"]\nstiffness = \"1e8 N/m\"\n{more}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"upper\"\nbetween = [{{ body = \"shaft\", at = \"1 m\" }}, \"ground\"]\nstiffness = \"1e8 N/m\"\n"
    )
}

const CYLINDER: &str = "section = { length = [\"1 m\"], outer_diameter = [\"50 mm\"] }\naxial = true\ntorsional = true";

/// A bar clamped at one end along the axis and free about it: (n - 1/2) pi c/L and n pi c/L, with errors of second order in the elements.
#[test]
fn a_bar() {
    let (sound, shear) = ((2.1e11f64 / 7850.0).sqrt(), (8.08e10f64 / 7850.0).sqrt());
    let errors = [8, 16, 32].map(|n| {
        let system = load(&bar(n, CYLINDER, "kzz = \"1e15 N/m\"")).system;
        let (axial, torsional) = (frequencies(&system, 100.0, Whirl::Axial), frequencies(&system, 100.0, Whirl::Torsional));
        // the free rotation of the whole is a double root at 0
        assert!(torsional[1] < 1e-3 * torsional[2], "{torsional:?}");
        let first = |k: usize| {
            (axial[k] / ((k as f64 + 0.5) * PI * sound) - 1.0).abs().max((torsional[k + 2] / ((k as f64 + 1.0) * PI * shear) - 1.0).abs())
        };
        first(0).max(first(1))
    });
    assert!(errors[2] < 3e-3, "{errors:?}");
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1]).log2() > 1.9, "{errors:?}");
    }
}

/// The static stiffness of a cone is exact with one element: E pi d1 d2/(4 L) along the axis, 3 pi G/(32 L) (d2 - d1)/(1/d1^3 - 1/d2^3) about it. A disc so
/// heavy that the shaft does not count swings on it.
#[test]
fn a_cone_is_exact() {
    let cone = "section = { length = [\"1 m\"], outer_diameter = [\"50 mm\"], end_outer_diameter = [\"80 mm\"] }\naxial = true\ntorsional = true\ndensity = 0.01";
    let disc = "[[part]]\nkind = \"disc\"\nname = \"disc\"\non = { body = \"shaft\", at = \"1 m\" }\nmass = 100\npolar_inertia = 2\n\
                [[part]]\nkind = \"coupling\"\nname = \"drive\"\nbetween = [\"shaft\", \"ground\"]\naxial_stiffness = 1e14\ntorsional_stiffness = 1e14\n";
    let system = load(&(bar(1, cone, "") + disc)).system;
    let (d1, d2): (f64, f64) = (0.05, 0.08);
    let axial = 2.1e11 * PI * d1 * d2 / 4.0;
    let torsional = 3.0 * PI * 8.08e10 / 32.0 * (d2 - d1) / (d1.powi(-3) - d2.powi(-3));
    for (whirl, k, inertia) in [(Whirl::Axial, axial, 100.0), (Whirl::Torsional, torsional, 2.0)] {
        let found = frequencies(&system, 100.0, whirl)[0];
        assert!((found / f64::sqrt(k / inertia) - 1.0).abs() < 1e-5, "{whirl:?} {found}");
    }
}

/// Two discs joined by a coupling turn against each other at sqrt(k (J1 + J2)/(J1 J2)) and together at 0, which is no critical speed.
#[test]
fn a_drive_line() {
    let disc = |name: &str, inertia: f64| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = 5\npolar_inertia = {inertia:?}\ntorsional = true\n\
                 [[part]]\nkind = \"shaft_lumped\"\nname = \"{name} shaft\"\nbetween = [\"{name}\", \"ground\"]\nstiffness = \"2e6 N/m\"\n"
        )
    };
    let joined =
        "[[part]]\nkind = \"coupling\"\nname = \"joint\"\nbetween = [\"motor\", \"load\"]\ntorsional_stiffness = \"75e3 N m/rad\"\n";
    let studies = "[[study]]\nkind = \"campbell\"\nspeed = { from = \"100 rad/s\", to = \"2000 rad/s\" }\n[[study]]\nkind = \"modes\"\n";
    let text = format!("[machine]\nname = \"drive\"\nspeed = \"300 rad/s\"\n{}{}{joined}", disc("motor", 0.1), disc("load", 0.3));
    let loaded = load(&text);
    let found = frequencies(&loaded.system, 300.0, Whirl::Torsional);
    let expected = (75e3f64 * 0.4 / 0.03).sqrt();
    assert!(found.len() == 3 && found[1] < 1e-6 && (found[2] / expected - 1.0).abs() < 1e-12, "{found:?} {expected}");
    assert!(loaded.warnings.0.iter().any(|d| d.message.to_string().contains("nothing holds the rotation")), "{:?}", loaded.warnings);
    // free rotation is no instability
    let spectrum = Linearised::new(&loaded.system, &rest(&loaded.system, 300.0).unwrap()).unwrap().spectrum().unwrap();
    assert_eq!(spectrum.modes.iter().filter(|m| m.is_free()).count(), 2);
    assert!(spectrum.least_stable().is_some_and(|m| !m.is_free()));
    let out = run_all(&format!("{text}{studies}"));
    // lateral: sqrt(k/m) = 632.5 rad/s; torsional at 1000 rad/s would cross the line of the speed too
    let criticals: Vec<f64> = out[0].findings.iter().filter(|f| f.id == "critical_speed").filter_map(|f| f.value).collect();
    assert!(!criticals.is_empty() && criticals.iter().all(|w| (w / (2e6f64 / 5.0).sqrt() - 1.0).abs() < 1e-6), "{criticals:?}");
    assert!(finding(&out[1], "least_damped_mode").value.is_some());
}

/// A shaft that stands on its lower end is shortened by its weight: rho g L^2/(2 E) at the upper one.
#[test]
fn a_standing_shaft_carries_its_weight() {
    let system = load(&bar(4, CYLINDER, "kzz = \"1e15 N/m\"")).system;
    let found = rest(&system, 100.0).unwrap();
    let top = system.coordinates().iter().rposition(|c| c.dof.name.ends_with("axial")).unwrap();
    let expected = -7850.0 * 9.80665 / (2.0 * 2.1e11);
    assert!((found.q[top] / expected - 1.0).abs() < 1e-3, "{} {expected}", found.q[top]);
}

/// A rotor that is speeded up through a coupling lags behind the drive by J W'/k once the start has died away.
#[test]
fn a_coupling_carries_the_torque_of_a_run_up() {
    let text = "[machine]\nname = \"run-up\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 5\npolar_inertia = 0.2\ntorsional = true\n\
                [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = \"2e6 N/m\"\n\
                [[part]]\nkind = \"coupling\"\nname = \"drive\"\nbetween = [\"rotor\", \"ground\"]\ntorsional_stiffness = 1e4\ntorsional_damping = 40\n\
                [[study]]\nkind = \"run_up\"\nfrom = \"0 rad/s\"\nto = \"100 rad/s\"\nduration = 2\n";
    let out = run_all(text);
    let column = out[0].tables.iter().find_map(|t| t.column("rotor.twist"));
    let names = || out[0].tables.iter().map(|t| t.columns().iter().map(|c| c.name.clone()).collect::<Vec<_>>()).collect::<Vec<_>>();
    let column = column.unwrap_or_else(|| panic!("{:?}", names()));
    let twist: Vec<f64> = (0..column.data.len()).filter_map(|k| column.number(k)).collect();
    let late = twist[twist.len() / 2];
    assert!((late / (-0.2 * 50.0 / 1e4) - 1.0).abs() < 1e-3, "{late}");
}

/// Coordinates along and about the axis change neither the sag nor the critical speeds over the stiffness of the supports.
#[test]
fn they_change_nothing_across_the_axis() {
    let studies = "[[study]]\nkind = \"static\"\n[[study]]\nkind = \"support_stiffness_map\"\n";
    let of = |more: &str| {
        run_all(&(bar(6, &format!("{CYLINDER}{more}"), "").replacen("[machine]", "[machine]\naxis = \"horizontal\"", 1) + studies))
    };
    let plain = CYLINDER.lines().next().unwrap_or_default();
    let alone = run_all(&(bar(6, plain, "").replacen("[machine]", "[machine]\naxis = \"horizontal\"", 1) + studies));
    for (a, b) in of("").iter().zip(&alone) {
        assert_eq!(a.findings.len(), b.findings.len(), "{:?} {:?}", a.findings, b.findings);
        let values = |o: &laval::outcome::Outcome| o.findings.iter().filter_map(|f| f.value).collect::<Vec<f64>>();
        for (x, y) in values(a).iter().zip(values(b)) {
            // defects of a balance are rounding
            assert!((x - y).abs() <= 1e-9 * y.abs() || y.abs() < 1e-9, "{}: {x} {y}", a.kind);
        }
    }
}

/// With a free spin the twist of all that turns is the spin itself: no equation is left for it, however fine the shaft. Without torsion, or with inertia that does not twist, there is one.
#[test]
fn a_free_spin_and_a_free_twist_are_one_motion() {
    let text = |torsional: bool, more: &str| {
        format!(
            "[machine]\nname = \"pump\"\nspeed = \"3000 rpm\"\ndrive = \"free\"\n\
             [[part]]\nkind = \"shaft\"\nname = \"shaft\"\ntorsional = {torsional}\nelements = 10\nsection = [{{ length = 0.6, outer_diameter = 0.05 }}]\n\
             [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.3 }}\nmass = 15.0\npolar_inertia = 0.12\ndiametral_inertia = 0.08\nunbalance = \"100 g mm\"\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"left\"\nbetween = [\"shaft\", \"ground\"]\nkxx = 5e7\nkyy = 7e7\ncxx = 5e3\ncyy = 5e3\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"right\"\nbetween = [{{ body = \"shaft\", at = 0.6 }}, \"ground\"]\nkxx = 5e7\nkyy = 7e7\ncxx = 5e3\ncyy = 5e3\n\
             [[part]]\nkind = \"motor\"\nname = \"motor\"\ncurve = \"linear\"\ntorque = \"50 N m\"\nsynchronous_speed = \"3100 rpm\"\n{more}"
        )
    };
    let of = |text: &str| {
        let system = load(text).system;
        laval::solve::motion::Motion::new(&system, laval::solve::motion::SpinLaw::Free).map(|_| ()).map_err(|d| d.message.to_string())
    };
    for elements in [10, 24, 45] {
        let refused = of(&text(true, "").replace("elements = 10", &format!("elements = {elements}"))).unwrap_err();
        assert!(refused.contains("the mass matrix is singular") && refused.contains("the spin angle"), "{elements}: {refused}");
    }
    assert_eq!(of(&text(false, "")), Ok(()));
    let fan = "[[part]]\nkind = \"disc\"\nname = \"fan\"\nmass = 1.0\npolar_inertia = 0.01\n[[part]]\nkind = \"bearing_linear\"\nname = \"third\"\nbetween = [\"fan\", \"ground\"]\nstiffness = 1e6\n";
    assert_eq!(of(&text(true, fan)), Ok(()));
}
