//! Machines with shafts through their studies: limits in which they are machines of rigid bodies, mistakes, names.

use crate::common::files::{load, run_all};
use laval::model::system::{Pair, System};
use laval::solve::harmonic::branches::response::{Request, respond};
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use laval_num::complex::C64;
use std::sync::atomic::AtomicBool;

const INERTIA: &str = "mass = \"20 kg\"\npolar_inertia = \"0.3 kg m^2\"\ndiametral_inertia = \"0.25 kg m^2\"\neccentricity = \"30 um\"\nskew = \"0.2 mrad\"\n";

/// A rotor with a liquid between two nonlinear bearings: rigid, or carried by a shaft without weight that hardly bends.
fn separator(rigid: bool) -> System {
    let (drum, lower, upper) = if rigid {
        (String::new(), "{ body = \"drum\", at = \"-150 mm\" }", "{ body = \"drum\", at = \"250 mm\" }")
    } else {
        let shaft = "[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 2\nmodulus = 1e13\nshear_modulus = 4e12\ndensity = 1e-3\n\
                     section = { length = [\"150 mm\", \"250 mm\"], outer_diameter = [\"200 mm\", \"200 mm\"] }\n";
        (shaft.to_string(), "\"shaft\"", "{ body = \"shaft\", at = \"400 mm\" }")
    };
    let on = if rigid { "" } else { "on = { body = \"shaft\", at = \"150 mm\" }\n" };
    let bearing = |name: &str, at: &str| {
        format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"{name}\"\nbetween = [{at}, \"ground\"]\nlaw = \"isotropic\"\nstiffness = 1e6\ncubic_stiffness = 1e14\n\
             [[part]]\nkind = \"damper\"\nname = \"{name} damping\"\nbetween = [{at}, \"ground\"]\ndamping = 400.0\n"
        )
    };
    let liquid = "[[part]]\nkind = \"liquid\"\nin = { body = \"drum\", at = \"40 mm\" }\nmodel = \"planar\"\ncavity_radius = \"120 mm\"\ncavity_height = \"100 mm\"\n\
                  density = 1000.0\nfill = { volume_fraction = 0.3 }\nviscosity = \"5e-3 Pa s\"\n";
    let text = format!(
        "[machine]\nname = \"separator\"\nspeed = \"3000 rpm\"\n{drum}[[part]]\nkind = \"disc\"\nname = \"drum\"\n{on}{INERTIA}{}{}{}",
        bearing("neck", upper),
        bearing("foot", lower),
        liquid.replace("viscosity = \"5e-3 Pa s\"\n", "")
    );
    load(&text).system
}

fn modes(system: &System, speed: f64, below: f64) -> Vec<C64> {
    let all = Linearised::new(system, &rest(system, speed).unwrap()).unwrap().spectrum().unwrap().modes;
    let mut out: Vec<C64> = all.iter().map(|m| m.value).filter(|s| s.im.abs() < below && s.re.abs() < below).collect();
    out.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    out
}

/// A drum with liquid on a shaft that hardly bends has the modes of the rigid drum, and jumps where it does.
#[test]
fn a_stiff_shaft_carries_a_rigid_rotor() {
    let (rigid, carried) = (separator(true), separator(false));
    assert!(carried.stations().iter().any(|s| s.name == "drum" && s.tilt.is_some()));
    for speed in [0.0, 200.0, 700.0] {
        let (a, b) = (modes(&rigid, speed, 3000.0), modes(&carried, speed, 3000.0));
        assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
        for (x, y) in a.iter().zip(&b) {
            assert!((*x - *y).abs() < 2e-4 * x.abs().max(1.0), "{speed}: {x:?} {y:?}");
        }
    }
    let folds = |system: &System| -> Vec<f64> {
        let request = Request { stability: false, ..Request::over(100.0, 700.0) };
        let found = respond(system, &request, &AtomicBool::new(false), &|_| {}).unwrap();
        let mut all: Vec<f64> = found.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let (a, b) = (folds(&rigid), folds(&carried));
    assert!(!a.is_empty() && a.len() == b.len(), "{a:?} {b:?}");
    assert!(a.iter().zip(&b).all(|(x, y)| (x / y - 1.0).abs() < 1e-3), "{a:?} {b:?}");
}

const MACHINE: &str = r#"
[machine]
name = "pump"
speed = "3000 rpm"
axis = "horizontal"

[[part]]
kind = "shaft"
name = "shaft"
section = { length = ["100 mm", "400 mm", "100 mm"], outer_diameter = ["40 mm", "60 mm", "40 mm"] }

[[part]]
kind = "disc"
name = "impeller"
on = { body = "shaft", at = "300 mm" }
mass = "15 kg"
polar_inertia = "0.12 kg m^2"
diametral_inertia = "0.08 kg m^2"
unbalance = "100 g mm"

[[part]]
kind = "bearing_linear"
name = "left"
between = ["shaft", "ground"]
kxx = "5e7 N/m"
kyy = "7e7 N/m"
cxx = "5 kN s/m"
cyy = "5 kN s/m"

[[part]]
kind = "bearing_linear"
name = "right"
between = [{ body = "shaft", at = "600 mm" }, "ground"]
kxx = "5e7 N/m"
kyy = "7e7 N/m"
cxx = "5 kN s/m"
cyy = "5 kN s/m"
"#;

/// Every study of a shaft ends with results, and names its stations.
#[test]
fn studies_of_a_shaft() {
    let studies = r#"
[[study]]
kind = "modes"
[[study]]
kind = "campbell"
speed = { from = "0 rpm", to = "6000 rpm", points = 13 }
[[study]]
kind = "critical_speeds"
speed = { from = "100 rpm", to = "12000 rpm" }
[[study]]
kind = "forced_response"
speed = { from = "100 rpm", to = "12000 rpm", points = 60 }
[[study]]
kind = "stability_map"
speed = "3000 rpm"
parameter = { parameter = "shaft.section[2].outer_diameter", from = "50 mm", to = "70 mm", points = 5 }
"#;
    let outcomes = run_all(&format!("{MACHINE}{studies}"));
    assert_eq!(outcomes.len(), 5);
    let table = outcomes.iter().find_map(|o| o.find_table("response")).unwrap();
    for column in ["amplitude.impeller", "amplitude.shaft at 0 m", "amplitude.shaft at 600 mm"] {
        assert!(table.column(column).is_some(), "{:?}", table.columns().iter().map(|c| &c.name).collect::<Vec<_>>());
    }
    assert!(outcomes.iter().all(|o| !o.findings.is_empty()));
}

/// The exact derivative of a frequency in the diameter of a section is that of a difference.
#[test]
fn derivatives_in_sections() {
    use laval::solve::mode_slopes::mode_slopes;
    let system = load(MACHINE).system;
    let path = "shaft.section[2].outer_diameter";
    let lowest = |s: &System| modes(s, 314.0, 1e4).into_iter().filter(|s| s.im > 0.0).min_by(|a, b| a.im.total_cmp(&b.im)).unwrap();
    let h = 1e-6;
    let moved = |d: f64| lowest(&system.with(&[(path, 0.06 + d)]).unwrap());
    let difference = (moved(h) - moved(-h)).scale(0.5 / h);
    let exact = mode_slopes(&system, &|s| rest(s, 314.0), lowest(&system), None, &[system.param(path).unwrap()]).unwrap().unwrap();
    assert!((exact.slopes[0] - difference).abs() < 1e-5 * difference.abs(), "{exact:?} {difference:?}");
}

/// Names of stations are those of probes.
#[test]
fn names_of_stations() {
    let system = load(MACHINE).system;
    let names: Vec<&str> = system.stations().iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["shaft at 0 m", "shaft at 600 mm", "impeller"]);
    assert_eq!(system.stations()[0].lateral, Pair::coordinates(0));
}

/// Mistakes are reported at their place.
#[test]
fn mistakes() {
    let reported = |from: &str, to: &str| {
        assert!(MACHINE.contains(from));
        let text = MACHINE.replace(from, to);
        laval::file::load(&text).err().map_or_else(String::new, |d| d.0.iter().map(ToString::to_string).collect())
    };
    let beyond = reported("at = \"600 mm\"", "at = \"601 mm\"");
    assert_eq!(beyond.matches("to 600 mm").count(), 1, "{beyond}");
    assert!(reported("\"60 mm\", \"40 mm\"]", "\"60 mm\"]").contains("differ in length"));
    assert!(
        reported("outer_diameter = [\"40 mm\"", "inner_diameter = [\"50 mm\", \"0 mm\", \"0 mm\"], outer_diameter = [\"40 mm\"")
            .contains("section 1")
    );
    assert!(reported("on = { body = \"shaft\", at", "on = { body = \"impeller\", at").contains("itself"));
    assert!(reported("name = \"shaft\"", "name = \"shaft\"\nshear_modulus = \"210 GPa\"").contains("Poisson"));
}

/// The jumps of a rotor do not depend on the number of its elements but for their error, which falls at their order, from eleven stations to 201.
#[test]
fn jumps_converge_with_the_elements() {
    let jumps = |elements: usize| -> Vec<f64> {
        let bearing = |name: &str, at: f64| {
            format!(
                "[[part]]\nkind = \"bearing_cubic\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nlaw = \"isotropic\"\nstiffness = 2e6\ncubic_stiffness = 1e14\n\
                 [[part]]\nkind = \"damper\"\nname = \"{name} damping\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\ndamping = 250.0\n"
            )
        };
        let text = format!(
            "[machine]\nname = \"rotor\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\nmodulus = 2.1e11\ndensity = 7800.0\n\
             section = {{ length = [1.5], outer_diameter = [0.05] }}\n\
             [[part]]\nkind = \"disc\"\nname = \"middle\"\non = {{ body = \"shaft\", at = 0.75 }}\nmass = 1e-6\nunbalance = \"20 g mm\"\n{}{}",
            bearing("lower", 0.0),
            bearing("upper", 1.5)
        );
        let request = Request { stability: false, ..Request::over(100.0, 400.0) };
        let found = respond(&load(&text).system, &request, &AtomicBool::new(false), &|_| {}).unwrap();
        let mut folds: Vec<f64> = found.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect();
        folds.sort_by(f64::total_cmp);
        folds
    };
    let all = [10, 20, 50, 100, 200].map(jumps);
    assert!(all.iter().all(|f| f.len() == 2), "{all:?}");
    for k in 0..2 {
        let far: Vec<f64> = all[..4].iter().map(|f| (f[k] / all[4][k] - 1.0).abs()).collect();
        assert!(far[0] < 1e-3 && far[3] < 1e-6, "{far:?}");
        // at least the second order of the rotation of a section, less where rounding begins
        for (pair, ratio) in far.windows(2).zip([2.0f64, 2.5, 2.0]) {
            assert!(pair[0] / pair[1] > 0.8 * ratio.powi(2) || pair[1] < 1e-9, "{far:?}");
        }
    }
}

/// A shaft of two sections on two bearings; a file of its rows.
fn rows(first: &str, more: &str) -> String {
    format!(
        "[machine]\nname = \"pump\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\n\
         [[part.section]]\nlength = \"300 mm\"\n{first}\n[[part.section]]\nlength = \"300 mm\"\nouter_diameter = \"20 mm\"\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"left\"\nbetween = [\"shaft\", \"ground\"]\nstiffness = 1e7\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"right\"\nbetween = [{{ body = \"shaft\", at = \"600 mm\" }}, \"ground\"]\nstiffness = 1e7\n{more}"
    )
}

/// A misspelt column of a row is one mistake, and says what is meant; a missing one beside it stays one of its own.
#[test]
fn a_misspelt_column_of_a_row_is_one_mistake() {
    let mistakes = |first: &str| laval::file::load(&rows(first, "")).map(|_| ()).unwrap_err().0;
    let one = mistakes("outer_diametr = \"20 mm\"");
    assert_eq!(one.len(), 1, "{one:?}");
    assert!(one[0].help.as_ref().is_some_and(|h| h.to_string().contains("\"outer_diameter\"")), "{one:?}");
    assert_eq!(mistakes("colour = \"red\"").len(), 2);
    assert_eq!(mistakes("").len(), 1);
}

/// A section that the shaft does not have: the message says how many there are.
#[test]
fn a_section_beyond_the_last_is_counted() {
    let study = "[[study]]\nkind = \"stability_map\"\nspeed = { from = 10, to = 100 }\n\
                 parameter = { parameter = \"shaft.section[9].outer_diameter\", from = 0.01, to = 0.02, points = 3 }\n";
    let mistakes = laval::file::load(&rows("outer_diameter = \"20 mm\"", study)).map(|_| ()).unwrap_err().0;
    assert!(mistakes.len() == 1 && mistakes[0].message.to_string().contains("section of \"shaft\" has 2 rows"), "{mistakes:?}");
}

/// Modes have one number in the study of modes and in the Campbell diagram: that of their frequency at the speed of the machine.
#[test]
fn modes_have_one_number() {
    use laval::outcome::Data;
    let studies = "[[study]]\nkind = \"modes\"\n[[study]]\nkind = \"campbell\"\nspeed = { from = \"0 rpm\", to = \"6000 rpm\", points = 25 }\n\
                   [[study]]\nkind = \"critical_speeds\"\nspeed = { from = \"0 rpm\", to = \"6000 rpm\" }\n";
    // a heavy disc beside the middle: forward and backward modes part, and pass each other
    let disc = "[[part]]\nkind = \"disc\"\nname = \"disc\"\non = { body = \"shaft\", at = \"200 mm\" }\nmass = 10\npolar_inertia = 0.2\ndiametral_inertia = 0.1\n";
    let text =
        rows("outer_diameter = \"20 mm\"\n", &format!("{disc}{studies}")).replace("name = \"shaft\"\n", "name = \"shaft\"\nelements = 2\n");
    let outcomes = run_all(&text);
    let floats = |k: usize, table: &str, name: &str| match &outcomes[k].find_table(table).unwrap().column(name).unwrap().data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    };
    let numbers = |k: usize, table: &str| -> Vec<usize> {
        match &outcomes[k].find_table(table).unwrap().column("mode").unwrap().data {
            Data::Text(v) => v.iter().map(|t| t.split(' ').next().unwrap().parse().unwrap()).collect(),
            Data::Int(v) => v.iter().map(|n| *n as usize).collect(),
            other => panic!("{other:?}"),
        }
    };
    let speed = 3000.0 * std::f64::consts::PI / 30.0;
    let (own, followed) = (floats(0, "modes", "frequency"), floats(1, "modes", "frequency"));
    let (speeds, branch) = (floats(1, "modes", "speed"), numbers(1, "modes"));
    let at: Vec<usize> = (0..speeds.len()).filter(|&k| (speeds[k] - speed).abs() < 1e-6).collect();
    assert_eq!(at.len(), own.len());
    for k in at {
        assert!((followed[k] - own[branch[k] - 1]).abs() < 1e-6 * followed[k], "mode {} at {}", branch[k], followed[k]);
    }
    // and critical speeds name the same modes
    let (a, b) = (floats(1, "critical_speeds", "speed"), floats(2, "critical_speeds", "speed"));
    let (m, n) = (numbers(1, "critical_speeds"), numbers(2, "critical_speeds"));
    for (w, k) in a.iter().zip(&m) {
        let other = b.iter().zip(&n).find(|o| (o.0 - w).abs() < 1e-6 * w && o.1 == k);
        assert!(other.is_some(), "{w} {k} {b:?} {n:?}");
    }
}
