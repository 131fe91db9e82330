//! The ideal liquid in time: a sum over waves against the exact reaction, its roots, and motions with it.

use super::machine::{FILE, build, changed, model, without};
use super::{cavity, named};
use crate::common::{number, rows};
use laval::cavity::waves::{BAND, MARGIN, MOST_WAVES};
use laval::cavity::{Cavity, Truncation};
use laval::file::load;
use laval::model::system::System;
use laval::model::timed::{Speeds, Timed};
use laval::outcome::Outcome;
use laval::solve::characteristic::Characteristic;
use laval::solve::linear_response::response;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::study::Context;
use laval_num::complex::{C64, c};

fn cavities() -> Vec<(&'static str, Cavity<f64>)> {
    let full = Cavity { radius: 0.07, free: 0.0, height: 0.06, density: 1000.0 };
    ["G1", "G2", "G3", "G4"].into_iter().map(|g| (g, cavity(g))).chain([("full", full)]).collect()
}

/// Where the fit has never been: the whole band and beyond the margin, at another speed, on both sides of the axis. What is stated is never less than what is found.
#[test]
fn stated_error() {
    let speed = 37.0;
    for (name, cavity) in cavities() {
        for truncation in [Truncation::None, Truncation::At(3)] {
            let mut before: Option<(f64, usize)> = None;
            for accuracy in [1e-2, 1e-3, 1e-4] {
                let fitted = cavity.tilt_in_time(truncation, accuracy, MOST_WAVES).unwrap();
                let mut worst = 0.0f64;
                for i in 0..211 {
                    let x = BAND * (0.993 * (2.0 * f64::from(i) / 210.0 - 1.0) + 0.0017);
                    for growth in [1.0001 * MARGIN, -1.0001 * MARGIN, 0.13, -0.4] {
                        let w = c(x + 1.0, growth).scale(speed);
                        let exact = cavity.tilt(w, speed, truncation).value;
                        let off = (fitted.form.at(w, speed) - exact).abs() / (exact.abs() + cavity.mean_tilt(w, speed).abs());
                        assert!(off <= fitted.error, "{name} {truncation:?} {accuracy} at {w:?}: {off:e}, stated {:e}", fitted.error);
                        worst = worst.max(off);
                    }
                }
                println!("{name} {truncation:?}: {} waves, stated {:.1e}, found {worst:.1e}", fitted.form.waves.len(), fitted.error);
                assert!(fitted.error <= accuracy && worst > 0.05 * fitted.error);
                // more waves where less is allowed
                assert!(before.is_none_or(|(error, waves)| fitted.error < error && fitted.form.waves.len() > waves));
                before = Some((fitted.error, fitted.form.waves.len()));
            }
        }
    }
}

/// What no table knows: real frequencies, strengths of the sign of the frequency, an inertia above 0, and the liquid at rest in its cavity at the speed of the rotor,
/// where the reaction is exact.
#[test]
fn nothing_grows_that_does_not_in_the_liquid() {
    for (name, cavity) in cavities() {
        let form = cavity.tilt_in_time(Truncation::None, 1e-3, MOST_WAVES).unwrap().form;
        assert!(form.inertia > 0.0, "{name}");
        for wave in &form.waves {
            assert!(wave.place.im == 0.0 && wave.strength.im == 0.0, "{name}");
            assert!(wave.strength.re * wave.place.re >= 0.0, "{name}: {wave:?}");
        }
        let w = c(210.0, 0.0);
        let (is, should) = (form.at(w, 210.0), cavity.mean_tilt(w, 210.0));
        // also of few waves
        let rough = cavity.tilt_in_time(Truncation::None, 0.1, MOST_WAVES).unwrap().form.at(w, 210.0);
        assert!((is - should).abs() < 1e-3 * 1e-3 * should.abs() + 1e-4 * should.abs(), "{name}: {is:?} {should:?}");
        assert!((rough - should).abs() < 1e-3 * should.abs(), "{name}: {rough:?} {should:?}");
    }
}

/// Against the tables of the reaction, off the axis and outside the dense range.
#[test]
fn reaction_of_the_tables() {
    let mut seen = 0;
    for (name, r) in named(include_str!("../reference/spatial/L_ideal.csv")) {
        let (w, should, speed) = (c(r[0], r[1]), c(r[4], r[5]), 100.0);
        let x = (w - c(speed, 0.0)).scale(1.0 / speed);
        if x.im.abs() < MARGIN || x.re.abs() > BAND {
            continue;
        }
        let cavity = cavity(name);
        let fitted = cavity.tilt_in_time(Truncation::None, 1e-4, MOST_WAVES).unwrap();
        let off = (fitted.form.at(w, speed) - should).abs() / (should.abs() + cavity.mean_tilt(w, speed).abs());
        assert!(off <= fitted.error, "{name} {w:?}: {off:e}");
        seen += 1;
    }
    assert_eq!(seen, 24);
}

fn fitted(system: &System) -> &System {
    let timed = Box::leak(Box::new(system.timed(Speeds::Several).unwrap()));
    assert!(matches!(timed, Timed::Fitted(_)));
    timed
}

fn waves(last: usize, error: &str) -> String {
    changed(
        &model(FILE, "spatial"),
        &[("model = \"spatial\"", &format!("model = \"spatial\"\naxial_harmonics = {last}\ntime_error = {error}"))],
    )
}

/// Eigenvalues of S1 and S1i with the form against those of the tables, found with Bessel functions and a linearised problem.
#[test]
fn roots_of_the_tables() {
    let table = rows(include_str!("../reference/spatial/eig_full.csv"));
    let mut sets: Vec<(&str, &str, &str)> = table.iter().map(|r| (r[0], r[1], r[2])).collect();
    sets.dedup();
    assert_eq!(sets.len(), 12);
    for (name, harmonics, speed) in sets {
        let last = harmonics.rsplit('-').next().unwrap().parse().unwrap();
        let text = waves(last, "1e-5");
        let text = if name == "S1i" { changed(&text, &[("4e6 N/m", "3e6 N/m"), ("1.2e7 N/m", "2e7 N/m")]) } else { text };
        let system = build(&text);
        let form = fitted(&system);
        let w = number(speed);
        let modes = modes_about(form, &rest(form, w).unwrap(), true).unwrap().modes;
        let mut worst = 0.0f64;
        let mut far = 0;
        let own: Vec<_> = table.iter().filter(|r| (r[0], r[1], r[2]) == (name, harmonics, speed)).collect();
        for r in &own {
            let should = c(-number(r[4]), number(r[3]));
            let near = modes.iter().flat_map(|m| [m.value, m.value.conj()]).map(|z| (z - should).abs()).fold(f64::INFINITY, f64::min);
            worst = worst.max(near / w);
            far += usize::from(!(near < 1e-5 * w));
        }
        println!("{name} {speed}: {} roots, farthest {worst:.1e} of the speed", own.len());
        // no farther than the error that was requested
        assert!(far == 0, "{name} {speed}: {worst:e}");
    }
}

pub(super) fn run(text: &str) -> Outcome {
    let machine = load(text).unwrap_or_else(|d| panic!("{text}\n{d:?}"));
    machine.studies[0].study.run(&machine.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d}"))
}

/// S1 in time: the rate at which its motion grows and the frequency are those of the exact root; the form, its error and what it does to the roots are reported.
#[test]
fn growth_in_time() {
    let text = model(FILE, "spatial");
    let system = build(&text);
    let form = fitted(&system);
    let speed = 400.0;
    let unstable =
        modes_about(form, &rest(form, speed).unwrap(), true).unwrap().modes.into_iter().max_by(|a, b| a.growth().total_cmp(&b.growth()));
    let near = unstable.unwrap();
    let exact = Characteristic::new(&system, &rest(&system, speed).unwrap()).polish(near.value, near.sector).unwrap().value;
    assert!(exact.re > 20.0 && (near.value - exact).abs() < 1e-4 * speed, "{exact:?} {:?}", near.value);
    // of harmonics 1 and 3, in the table
    assert!((exact - c(28.33957, 263.17580928)).abs() < 1e-3, "{exact:?}");
    let study = "[[study]]\nkind = \"transient\"\nduration = \"0.6 s\"\ninitial = { \"rotor.x\" = \"1e-3 mm\" }\n";
    let head = text.split("[[study]]").next().unwrap();
    let outcome = run(&format!("{head}{study}"));
    let finding = |id: &str| outcome.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("{id}: {:?}", outcome.findings));
    let grown = finding("growth_rate").value.unwrap();
    println!("growth in time {grown}, exact {exact:?}");
    assert!((grown - exact.re).abs() < 0.02 * exact.re, "{grown} {exact:?}");
    let error = finding("time_form").value.unwrap();
    assert!(error > 1e-7 && error <= 1e-4, "{error}");
    let moved = finding("time_form_roots").value.unwrap();
    assert!(moved < 1e-4 * speed && moved >= (near.value - exact).abs() * 0.999, "{moved}");
}

/// The steady motion with the form is that of the exact machine: forward synchronous whirl exactly, backward to the error of the form at `sigma = -2 W`.
#[test]
fn steady_motion() {
    let system = build(&model(FILE, "spatial"));
    let form = fitted(&system);
    for speed in [90.0, 240.0, 610.0] {
        let of = |system: &System| response(system, &|w| rest(system, w), speed).unwrap().unwrap();
        let (exact, found) = (of(&system), of(form));
        for i in 0..3 {
            let (a, b): ((C64, C64), (C64, C64)) = (exact.circles(2 * i), found.circles(2 * i));
            let size = a.0.abs() + a.1.abs();
            assert!((a.0 - b.0).abs() + (a.1 - b.1).abs() < 1e-3 * size, "{speed} {i}: {a:?} {b:?}");
        }
    }
}

/// Without damping, below the critical speed, nothing feeds a motion: it stays as large as it was given, over a hundred turns.
#[test]
fn a_stable_machine_stays_bounded() {
    let text = changed(
        &without(&model(FILE, "spatial"), &["air", "material"]),
        &[("damping = \"3000 N s/m\"", "damping = 0"), ("skew = 2e-4", "skew = 0"), ("eccentricity = \"50 um\"", "eccentricity = 0")],
    );
    let head = text.split("[[study]]").next().unwrap();
    let study = "[[study]]\nkind = \"transient\"\nspeed = \"60 rad/s\"\nduration = \"10.5 s\"\ninitial = { \"rotor.x\" = \"0.1 mm\", \"rotor.tilt_y\" = 1e-4 }\n";
    let outcome = run(&format!("{head}{study}"));
    let largest = outcome.findings.iter().find(|f| f.id == "largest_displacement" && f.subject == "rotor").unwrap().value.unwrap();
    println!("largest displacement {largest}");
    assert!((1e-4..4e-4).contains(&largest), "{largest}");
    assert!(!outcome.findings.iter().any(|f| f.id == "unbounded"));
}

/// Studies of motion take the liquid, say by what and how well; while the speed changes too.
#[test]
fn studies_of_motion() {
    let head = model(FILE, "spatial");
    let head = head.split("[[study]]").next().unwrap();
    let up = run(&format!("{head}[[study]]\nkind = \"run_up\"\nfrom = \"390 rad/s\"\nto = \"400 rad/s\"\nduration = \"0.3 s\"\n"));
    let find = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).cloned();
    let form = find(&up, "time_form").unwrap();
    assert!(form.message.key == "history-time-form" && form.sentence().contains("\"water\""), "{}", form.sentence());
    assert!(form.number("states") > Some(0.0) && form.value.unwrap() <= 1e-4, "{form:?}");
    assert!(find(&up, "time_form_roots").unwrap().value.is_some_and(|moved| moved < 1e-4 * 400.0));
    let change = up.findings.iter().any(|f| f.id == "validity" && f.sentence().contains("change of the speed within a turn"));
    assert!(change, "{:?}", up.findings);
    let sweep = run(&format!(
        "{head}[[study]]\nkind = \"sweep\"\nspeed = {{ from = \"60 rad/s\", to = \"70 rad/s\", points = 2 }}\nstart = \"rest\"\nmost_periods = 20\n"
    ));
    assert!(find(&sweep, "time_form").is_some(), "{:?}", sweep.findings);
}

/// What cannot be had is refused by name, with what to change.
#[test]
fn refusals() {
    let transient = "[[study]]\nkind = \"transient\"\nduration = \"0.1 s\"\n";
    let reported = |liquid: &str, study: &str| -> String {
        let text = changed(&model(FILE, "spatial"), &[("model = \"spatial\"", &format!("model = \"spatial\"\n{liquid}"))]);
        let head = text.split("[[study]]").next().unwrap().to_string();
        match load(&format!("{head}{study}")) {
            Ok(m) => m.studies[0].study.run(&m.system, &Context::quiet("study")).err().map(|d| d.to_string()).unwrap_or_default(),
            Err(d) => format!("{d:?}"),
        }
    };
    assert!(reported("axial_harmonics = 301", transient).contains("up to axial_harmonics = 161"));
    assert!(reported("time_error = 1e-6", transient).contains("allow a larger time_error"));
    let water = reported("viscosity = 1e-6\naxial_harmonics = 5\ntime_error = 1e-6", transient);
    assert!(water.contains("160 waves do not give its reaction on tilt with a relative error of 1e-6; try time_error = "), "{water}");
    assert!(water.contains("model = \"strip\""), "{water}");
    assert!(reported("viscosity = 1e-5\naxial_harmonics = 301", transient).contains("up to axial_harmonics = 161"));
    assert!(reported("time_error = 1e-9", transient).contains("time_error"));
    let strip = changed(FILE, &[("model = \"strip\"", "model = \"strip\"\ntime_error = 1e-3")]);
    assert!(load(&strip).err().unwrap().to_string().contains("strip without viscosity is exact in time"));
}
