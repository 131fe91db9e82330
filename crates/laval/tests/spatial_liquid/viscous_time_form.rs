//! The viscous liquid in time at one speed: a rational form against the exact reaction, roots, and motions with it.

use super::cavity;
use super::machine::{FILE, build, changed};
use super::time_form::run;
use crate::common::{number, rows};
use laval::cavity::layer::Refused;
use laval::cavity::waves::BAND;
use laval::cavity::{Cavity, Truncation};
use laval::file::load;
use laval::model::system::System;
use laval::model::timed::Speeds;
use laval::outcome::{End, Outcome};
use laval::solve::characteristic::Characteristic;
use laval::solve::linear_response::response;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::study::{Cancel, Context};
use laval_num::complex::c;
use std::cell::Cell;

fn cavities() -> Vec<(&'static str, Cavity<f64>)> {
    let thin = Cavity { radius: 0.1, free: 0.097, height: 0.1, density: 1000.0 };
    ["G1", "G2", "G3", "G4"].into_iter().map(|g| (g, cavity(g))).chain([("thin", thin)]).collect()
}

/// Frequencies over the speed, in rotor axes, where the fit has not been: even ones, and close ones where the reaction changes fast or almost vanishes.
fn elsewhere(cavity: &Cavity<f64>) -> Vec<f64> {
    let even = (0..601).map(|i| BAND * (0.999 * (2.0 * f64::from(i) / 600.0 - 1.0) + 0.00071));
    let waves: Vec<f64> =
        cavity.plane_waves(1.0).into_iter().map(|w| w - 1.0).chain([0.0, -1.0, 1.0 - 2f64.sqrt(), 1.0 + 2f64.sqrt()]).collect();
    let close =
        waves.into_iter().flat_map(|x| (0..80).flat_map(move |i| [-1.0, 1.0].map(|s| x + s * 10f64.powf(-7.0 + 0.0873 * f64::from(i)))));
    even.chain(close.filter(|x| x.abs() < BAND)).collect()
}

/// What is stated is never less than what is found, where motions do not decay; poles die out, energy is taken, and what turns with the rotor is exact.
#[test]
fn stated_error_of_a_layer() {
    let mut most = 0;
    for (name, cavity) in cavities() {
        let ring = cavity.full_mass() * (1.0 - (cavity.free / cavity.radius).powi(2));
        for nu in [1e-6, 3e-5, 1e-3, 2e-2] {
            for speed in [23.0, -140.0, 900.0] {
                for accuracy in [1e-2, 1e-4, 1e-6] {
                    let made = cavity
                        .planar_in_time(speed, nu, accuracy, &|| false)
                        .unwrap_or_else(|e| panic!("{name} {nu} {speed} {accuracy}: {e:?}"));
                    let form = &made.form;
                    assert!(made.error <= accuracy && form.inertia.is_finite());
                    assert!(form.waves.iter().all(|w| w.place.im * speed > 0.0), "{name} {nu} {speed}: {:?}", form.waves);
                    most = most.max(form.waves.len());
                    for x in elsewhere(&cavity) {
                        for growth in [0.0, 1e-4, 4e-3, 0.11, 0.9] {
                            // growth is Im w < 0
                            let w = c(speed * (1.0 + x), -growth * speed.abs());
                            let exact = cavity.planar_viscous(w, speed, nu);
                            let is = form.at(w, speed);
                            let size = exact.abs() + ring * w.norm_sqr();
                            let off = (is - exact).abs() / size;
                            let rounding = if (x + 1.0).abs() < 1e-3 { 1e-7 } else { 1e-9 };
                            assert!(
                                off <= made.error + rounding,
                                "{name} {nu} {speed} {accuracy} at {x} {growth}: {off:e}, stated {:e}",
                                made.error
                            );
                            if growth == 0.0 {
                                let power = is.im * x * speed.signum() / size;
                                assert!(power <= 1e-12, "{name} {nu} {speed} {accuracy} gives energy at {x}: {power:e}");
                            }
                        }
                    }
                    let turning = form.at(c(speed, 0.0), speed).scale(1.0 / (cavity.full_mass() * speed * speed));
                    assert!((turning - c(1.0, 0.0)).abs() < 1e-10, "{name} {nu} {speed}: {turning:?}");
                }
            }
        }
    }
    println!("{most} poles at the most");
    // few are not enough for all of that
    assert!(most > 12);
    let still = Cavity { radius: 0.1, free: 0.05, height: 0.1, density: 1000.0 };
    assert_eq!(still.planar_in_time(0.0, 1e-5, 1e-3, &|| false), Err(Refused::Speed));
}

/// The same of tilt with axial flow, water among it; and what no table knows: energy is taken at every frequency, far outside the band too.
#[test]
fn stated_error_of_tilt() {
    let none = Truncation::None;
    let cases = [
        ("G1", 1e-6, 420.0, none, 2e-2),
        ("G1", 1e-4, 60.0, none, 1e-2),
        ("G1", 3e-3, -200.0, none, 1e-3),
        ("G1", 5.0, 200.0, none, 1e-4),
        ("G2", 1e-6, 210.0, none, 1e-3),
        ("G2", 1e-4, -110.0, none, 1e-4),
        ("G2", 1e-3, 110.0, Truncation::At(1), 1e-5),
        ("G3", 1e-5, 200.0, none, 1e-2),
        ("G3", 1e-3, -33.0, none, 1e-3),
        ("G4", 1e-2, -110.0, Truncation::At(3), 1e-3),
        ("G4", 1e-3, 900.0, none, 1e-2),
        ("thin", 1e-6, 300.0, none, 1e-2),
    ];
    for (name, nu, speed, truncation, accuracy) in cases {
        let cavity = cavities().into_iter().find(|c| c.0 == name).unwrap().1;
        let made = cavity
            .tilt_viscous_in_time(speed, nu, truncation, accuracy, &|| false)
            .unwrap_or_else(|e| panic!("{name} {nu} {speed}: {e:?}"));
        let form = &made.form;
        assert!(made.error <= accuracy && form.waves.iter().all(|w| w.place.im * speed > 0.0));
        let narrow: Vec<f64> = form.waves.iter().map(|w| w.place.re).filter(|x| x.abs() < BAND).collect();
        let mut worst = 0.0f64;
        let even = (0..81).map(|i| BAND * (0.999 * (2.0 * f64::from(i) / 80.0 - 1.0) + 0.00071));
        for x in even.chain(narrow) {
            for growth in [0.0, 0.0021, 0.03, 0.3, 1.1] {
                let w = c(speed * (1.0 + x), -growth * speed.abs());
                let exact = cavity.tilt_viscous(w, speed, nu, truncation).value;
                let (is, size) = (form.at(w, speed), exact.abs() + cavity.mean_tilt(w, speed).abs());
                let off = (is - exact).abs() / size;
                assert!(off <= made.error, "{name} {nu} at {x} {growth}: {off:e}, stated {:e}", made.error);
                worst = worst.max(off);
            }
        }
        println!("{name} {nu} {speed}: {} waves, stated {:.1e}, found {worst:.1e}", form.waves.len(), made.error);
        assert!(worst > 0.05 * made.error);
        for i in (-400i32..=400).step_by(2) {
            let x = f64::from(i).signum() * 10f64.powf(0.025 * f64::from(i.abs()) - 5.99);
            let w = c(speed * (1.0 + x), 0.0);
            let power = form.at(w, speed).im * x * speed.signum() / (form.inertia.abs() * w.norm_sqr());
            assert!(power <= 1e-12, "{name} {nu} gives energy at {x}: {power:e}");
        }
        let turning = (form.at(c(speed, 0.0), speed) - cavity.mean_tilt(c(speed, 0.0), speed)).abs();
        assert!(turning < 1e-9 * cavity.mean_tilt(c(speed, 0.0), speed).abs(), "{turning:e}");
    }
}

/// What cannot be had says what can: that is then had, and two thirds of it are not.
#[test]
fn a_refused_error_says_what_can_be_had() {
    let cases = [("G1", 1e-6, 300.0, Truncation::At(5), 1e-6), ("G3", 1e-6, -200.0, Truncation::At(5), 1e-6)];
    for (name, nu, speed, truncation, wish) in cases {
        let cavity = cavities().into_iter().find(|c| c.0 == name).unwrap().1;
        let of = |accuracy: f64| cavity.tilt_viscous_in_time(speed, nu, truncation, accuracy, &|| false);
        let reached = match of(wish) {
            Err(Refused::Accuracy { reached }) => reached,
            other => panic!("{name}: {other:?}"),
        };
        println!("{name} {nu} {speed}: {wish} refused, {reached} advised");
        assert!(reached > wish && reached <= 0.1, "{name}: {reached}");
        assert_eq!(format!("{reached:.1e}").parse(), Ok(reached), "two digits");
        assert!(of(reached).is_ok_and(|l| l.error <= reached), "{name}: {reached} does not do");
        assert!(matches!(of(reached / 1.5), Err(Refused::Accuracy { .. })), "{name}: much less than {reached} does, too");
    }
    let far = cavity("G1").tilt_viscous_in_time(300.0, 1e-3, Truncation::At(301), 1e-2, &|| false);
    assert_eq!(far, Err(Refused::Harmonics));
    assert_eq!(cavity("G1").tilt_viscous_in_time(0.0, 1e-3, Truncation::None, 1e-2, &|| false), Err(Refused::Speed));
}

/// One coordinate, w0 = 100 rad/s, R = 0.1 m, full cavity half the rotor, r0/R = 0.7.
fn one(zeta: f64, nu: f64, speed: f64, study: &str) -> String {
    let height = 0.5 * 20.0 / (std::f64::consts::PI * 0.01 * 1000.0);
    format!(
        "[machine]\nname = \"one\"\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 20\npolar_inertia = 1\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = 2e5\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"rotor\", \"ground\"]\ndamping = {}\n\
         [[part]]\nkind = \"liquid\"\nname = \"water\"\nin = \"rotor\"\ncavity_radius = 0.1\ncavity_height = {height:e}\ndensity = 1000\n\
         viscosity = {:e}\ntime_error = 1e-5\nfill = {{ free_surface_radius = 0.07 }}\n{study}",
        2.0 * zeta * 20.0 * 100.0,
        nu,
    )
}

fn largest(system: &System, speed: f64) -> f64 {
    modes_about(system, &rest(system, speed).unwrap(), true).unwrap().modes.iter().map(|m| m.growth()).fold(f64::NEG_INFINITY, f64::max)
}

/// Rates of growth of another program, by the machine with the form; where the table has no root that grows the machine has none.
#[test]
fn growth_of_the_table() {
    let table = rows(include_str!("../reference/spatial/viscous_1dof_stability.csv"));
    let (mut grow, mut worst) = (0, 0.0f64);
    for r in table.iter().filter(|r| number(r[1]) > 0.0).step_by(2) {
        let (zeta, nu, speed) = (number(r[0]), number(r[1]), 100.0 * number(r[2]));
        let system = build(&one(zeta, nu, speed, ""));
        let form = system.timed(Speeds::One(speed)).unwrap();
        let (is, should) = (largest(&form, speed), 100.0 * number(r[4]));
        if number(r[3]) > 0.0 {
            grow += 1;
            worst = worst.max((is - should).abs() / speed);
            assert!((is - should).abs() < 1e-4 * speed, "{r:?}: {is} {should}");
        } else {
            // to the error of the form
            assert!(is < 1e-5 * speed, "{r:?}: {is}");
        }
    }
    println!("{grow} roots that grow, at most {worst:.1e} of the speed away");
    assert!(grow > 100);
}

fn finding<'a>(outcome: &'a Outcome, id: &str) -> &'a laval::outcome::Finding {
    outcome.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("{id}: {:?}", outcome.findings))
}

/// In time an unstable machine grows as its exact root does, a stable one comes to rest.
#[test]
fn growth_in_time() {
    let study =
        |duration: &str| format!("[[study]]\nkind = \"transient\"\nduration = \"{duration}\"\ninitial = {{ \"rotor.x\" = \"1e-3 mm\" }}\n");
    let speed = 137.5;
    let text = one(0.05, 1e-3, speed, &study("1.2 s"));
    let system = build(&text);
    let near = system.timed(Speeds::One(speed)).unwrap();
    let mode =
        modes_about(&near, &rest(&near, speed).unwrap(), true).unwrap().modes.into_iter().max_by(|a, b| a.growth().total_cmp(&b.growth()));
    let mode = mode.unwrap();
    let exact = Characteristic::new(&system, &rest(&system, speed).unwrap()).polish(mode.value, mode.sector).unwrap().value;
    assert!((exact.re - 7.9510556).abs() < 1e-5, "{exact:?}");
    let outcome = run(&text);
    let grown = finding(&outcome, "growth_rate").value.unwrap();
    println!("growth in time {grown}, exact {exact:?}");
    assert!((grown - exact.re).abs() < 0.02 * exact.re, "{grown} {exact:?}");
    let error = finding(&outcome, "time_form").value.unwrap();
    assert!(error > 0.0 && error <= 1e-5, "{error}");
    let moved = finding(&outcome, "time_form_roots").value.unwrap();
    assert!(moved < 1e-4 * speed && moved >= (mode.value - exact).abs() * 0.999, "{moved}");
    // below the band
    let calm = run(&one(0.05, 1e-3, 75.0, &study("3 s")));
    assert_eq!(finding(&calm, "time_form_roots").message.key, "moved-roots-none");
    let largest = calm.findings.iter().find(|f| f.id == "largest_displacement" && f.subject == "rotor").unwrap().value.unwrap();
    assert!(largest < 1.2e-6, "{largest}");
}

/// S1i where its rotor meets an inertial wave, harmonics up to 9: what no planar flow has.
fn inertial(ratio: f64, nu: f64, speed: f64, study: &str) -> String {
    let liquid = format!("model = \"spatial\"\naxial_harmonics = 9\ntime_error = 2e-3\nviscosity = {nu:e}");
    let free = format!("free_surface_radius = {:e}", 0.15 * ratio);
    let pieces = [
        ("model = \"strip\"", liquid.as_str()),
        ("free_surface_radius = \"105 mm\"", &free),
        ("4e6 N/m", "3e6 N/m"),
        ("1.2e7 N/m", "2e7 N/m"),
        ("400 rad/s", &format!("{speed} rad/s")),
    ];
    let text = changed(FILE, &pieces);
    format!("{}{study}", text.split("[[study]]").next().unwrap())
}

/// The strongest root with the form of plane flow and tilt against that of another program, and a motion that grows so.
#[test]
fn the_inertial_wave_of_the_table_grows_in_time() {
    let mut seen = 0;
    for r in rows(include_str!("../reference/spatial/inertial_band.csv")).iter().filter(|r| number(r[2]) > 0.0) {
        let (ratio, speed, nu, should) = (number(r[0]), number(r[1]), number(r[2]), c(-number(r[4]), number(r[3])));
        let system = build(&inertial(ratio, nu, speed, ""));
        let form = system.timed(Speeds::One(speed)).unwrap();
        let modes = modes_about(&form, &rest(&form, speed).unwrap(), true).unwrap().modes;
        let best =
            modes.iter().flat_map(|m| [m.value, m.value.conj()]).max_by(|a, b| (a.re, a.im).partial_cmp(&(b.re, b.im)).unwrap()).unwrap();
        println!("{r:?}: {} modes, {:.1e} of the speed", modes.len(), (best - should).abs() / speed);
        // the table is good to 1e-2 rad/s
        assert!((best - should).abs() < 2e-2 + 2e-4 * speed, "{r:?}: {best:?}");
        seen += 1;
    }
    assert_eq!(seen, 6);
    let study = "[[study]]\nkind = \"transient\"\nduration = \"0.8 s\"\ninitial = { \"rotor.x\" = \"1e-3 mm\" }\n";
    let outcome = run(&inertial(0.8, 1e-3, 870.0, study));
    let (grown, moved) = (finding(&outcome, "growth_rate").value.unwrap(), finding(&outcome, "time_form_roots").value.unwrap());
    println!("growth in time {grown}, root moved by {moved}");
    assert!((grown - 8.61525264).abs() < 0.03 * 8.61525264, "{grown}");
    assert!(moved < 2e-4 * 870.0, "{moved}");
}

/// The steady motion with the form is that of the exact machine, strip and spatial, in a cavity off its shaft and skew to it.
#[test]
fn steady_motion() {
    for (word, nu, error) in [("strip", "1e-5", "1e-5"), ("spatial", "1e-2", "1e-2")] {
        let fields = format!("model = \"{word}\"\nviscosity = {nu}\ntime_error = {error}\neccentricity = \"0.1 mm\"\nskew = 1e-4");
        let system = build(&changed(FILE, &[("model = \"strip\"", &fields)]));
        let speed = 240.0;
        let form = system.timed(Speeds::One(speed)).unwrap();
        let of = |system: &System| response(system, &|w| rest(system, w), speed).unwrap().unwrap();
        let (exact, found) = (of(&system), of(&form));
        for i in 0..3 {
            let (a, b) = (exact.circles(2 * i), found.circles(2 * i));
            let size = a.0.abs() + a.1.abs();
            let off = ((a.0 - b.0).abs() + (a.1 - b.1).abs()) / size;
            println!("{word} {i}: {off:.1e}");
            assert!(off < 10.0 * number(error), "{word} {i}: {a:?} {b:?}");
        }
    }
}

/// Asked to stop, the search stops, wherever it is.
#[test]
fn a_search_that_is_stopped_ends() {
    let cavity = cavity("G1");
    let mut seen = 0;
    for after in [0u32, 3, 40, 400] {
        let requested = Cell::new(0);
        let stop = || {
            requested.set(requested.get() + 1);
            requested.get() > after
        };
        let found = cavity.tilt_viscous_in_time(420.0, 1e-6, Truncation::None, 2e-2, &stop);
        // requested no more once it has said so
        assert!(
            found == Err(Refused::Stopped) && requested.get() == after + 1 || found.is_ok() && requested.get() <= after,
            "{after}: {}",
            requested.get()
        );
        seen += u32::from(found.is_err());
    }
    assert!(seen >= 3, "{seen}");
    assert_eq!(cavity.planar_in_time(420.0, 1e-6, 1e-3, &|| true), Err(Refused::Stopped));
}

/// A study cancelled while the form is made ends so, and leaves nothing behind: the next run is that of a fresh machine.
#[test]
fn a_cancelled_form_is_not_remembered() {
    let study = "[[study]]\nkind = \"transient\"\nduration = \"0.05 s\"\n[[study]]\nkind = \"basins\"\nfrom = { \"rotor.x\" = 0, \"rotor.x'\" = 0 }\n\
                 to = { \"rotor.x\" = 1e-3, \"rotor.x'\" = 0.1 }\npoints = 2\nmost_periods = 2\nperiods = 48\n";
    let text = one(0.05, 1e-3, 75.0, study);
    let (fresh, stopped) = (load(&text).unwrap(), load(&text).unwrap());
    let cancel = Cancel::new(true);
    for k in 0..2 {
        let context = Context { cancel: &cancel, ..Context::quiet("study") };
        assert_eq!(stopped.refusals_in(&context).len(), 0);
        let outcome = stopped.studies[k].study.run(&stopped.system, &context).unwrap();
        assert!(outcome.end == End::Cancelled && outcome.tables.is_empty(), "{outcome:?}");
    }
    for k in 0..2 {
        let run = |l: &laval::file::Loaded| l.studies[k].study.run(&l.system, &Context::quiet("study")).unwrap();
        let (a, b) = (run(&stopped), run(&fresh));
        assert!(a.end == b.end && a.end != End::Cancelled && !a.tables.is_empty());
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
    }
}

/// At a standstill nothing helps but to turn.
#[test]
fn a_standstill_is_refused_with_what_can_be_done() {
    let loaded = load(&one(0.05, 1e-3, 75.0, "[[study]]\nkind = \"transient\"\nduration = \"0.1 s\"\nspeed = 0\n")).unwrap();
    let refused = loaded.refusals();
    assert_eq!(refused.len(), 1);
    let help = refused[0].diagnostic.help.as_deref().unwrap();
    assert!(help.contains("above 0") && help.contains("frozen") && !help.contains("forced_response"), "{help}");
    // what is advised is accepted
    let frozen = one(0.05, 1e-3, 75.0, "[[study]]\nkind = \"transient\"\nduration = \"0.1 s\"\nspeed = 0\n");
    let frozen = changed(&frozen, &[("viscosity = 1e-3", "model = \"frozen\""), ("time_error = 1e-5", "")]);
    assert!(load(&frozen).unwrap().refusals().is_empty());
}

/// Where the speed changes, or there are several, it is refused by name.
#[test]
fn refusals() {
    let reported = |study: &str| match load(&one(0.05, 1e-3, 100.0, study)) {
        Ok(m) => m.studies[0].study.run(&m.system, &Context::quiet("study")).err().map(|d| d.to_string()).unwrap_or_default(),
        Err(d) => format!("{d:?}"),
    };
    let up = reported("[[study]]\nkind = \"run_up\"\nfrom = \"90 rad/s\"\nto = \"100 rad/s\"\nduration = \"0.3 s\"\n");
    assert!(up.contains("\"water\" has no form in the time domain: the layer of a viscous liquid depends on the speed"), "{up}");
    assert!(up.contains("constant speed only"), "{up}");
    let sweep = reported("[[study]]\nkind = \"sweep\"\nspeed = { from = \"60 rad/s\", to = \"70 rad/s\", points = 2 }\n");
    assert!(sweep.contains("\"water\"") && sweep.contains("made for one"), "{sweep}");
}
