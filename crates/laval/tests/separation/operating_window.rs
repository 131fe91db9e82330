//! The operating window against a machine whose window has a closed form, on a nonlinear machine, with cups that load their rotor, and when nothing fits.

use crate::common;

use common::{number, rows};
use laval::file::load;
use laval::outcome::{Outcome, Table};
use laval::study::Context;
use std::f64::consts::PI;

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("window")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn column(t: &Table, name: &str) -> Vec<f64> {
    (0..t.rows()).map(|i| t.column(name).unwrap().number(i).unwrap()).collect()
}

fn words(t: &Table, name: &str) -> Vec<String> {
    match &t.column(name).unwrap().data {
        laval::outcome::Data::Text(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

fn evidence(o: &Outcome, id: &str) -> f64 {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no {id}")).value.unwrap()
}

/// The Jeffcott machine of the reference table; its damping is scaled down so that the response is undamped, which leaves the boundary of stability
/// where it was. The bowl's throughput gives the residence time wanted, the particles the sedimentation coefficient.
fn jeffcott(time: f64) -> String {
    let volume = PI * (0.19f64.powi(2) - 0.09f64.powi(2)) * 0.5;
    let diameter = 2.0 * (9.0 * 1e-3 * 2.5e-8 / (2.0 * 1000.0f64)).sqrt();
    format!(
        r#"
[machine]
name = "Jeffcott"
[[part]]
kind = "disc"
name = "rotor"
mass = 1
eccentricity = "0.2 mm"
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["rotor", "ground"]
stiffness = 3600
[[part]]
kind = "damper"
name = "internal"
between = ["rotor", "ground"]
damping = 1e-5
axes = "rotating"
[[part]]
kind = "damper"
name = "external"
between = ["rotor", "ground"]
damping = 1.5e-5
[[cup]]
kind = "tubular_bowl"
length = "0.5 m"
bowl_radius = "190 mm"
surface_radius = "90 mm"
[suspension]
liquid_density = 1000
viscosity = "1 mPa s"
particle_density = 2000
diameter = {diameter:e}
[limits]
displacement = "0.35 mm"
self_centring = 0.5
[[study]]
kind = "operating_window"
speed = {{ from = "20 rad/s", to = "400 rad/s" }}
throughput = {:e}
recovery = 1
start = "slowest"
"#,
        volume / time
    )
}

#[test]
fn the_closed_form_window() {
    for row in rows(include_str!("../reference/separation/operating_window_example.csv")) {
        let n = |i: usize| number(row[i]);
        let o = run(&jeffcott(n(0)));
        // the shortest time the machine allows, whatever is requested
        assert!((evidence(&o, "shortest_time") / n(9) - 1.0).abs() < 1e-6, "{}", evidence(&o, "shortest_time"));
        let t = o.find_table("window").unwrap();
        if row[8] == "infeasible" {
            assert_eq!(t.rows(), 0);
            assert!(o.findings.iter().any(|f| f.id == "excluding" && f.sentence().contains("residence time and stability")));
            // the time must be relaxed by the ratio of the shortest to the one requested
            assert!((evidence(&o, "relaxation") / (n(9) / n(0)) - 1.0).abs() < 1e-6);
            continue;
        }
        assert_eq!(t.rows(), 1);
        // eigenvalues known to rounding cross zero at a slope of 1e-7: the boundary of stability to 1e-6
        assert!((column(t, "low")[0] / n(6) - 1.0).abs() < 1e-8, "{} {}", column(t, "low")[0], n(6));
        assert!((column(t, "high")[0] / n(7) - 1.0).abs() < 1e-6, "{} {}", column(t, "high")[0], n(7));
        let binding = if row[8] == "self_centring" { "self_centred" } else { "separation" };
        assert_eq!((words(t, "low binding")[0].as_str(), words(t, "high binding")[0].as_str()), (binding, "stable"));
        assert_eq!((words(t, "low event")[0].as_str(), words(t, "high event")[0].as_str()), ("crossing", "eigenvalue crossing"));
    }
}

/// A polar inertia changes nothing in a plane but the energy that the rotor holds, by C w^2/2.
#[test]
fn the_spin_holds_its_energy() {
    let energy = |polar: f64| {
        let o = run(&jeffcott(60.0).replace("mass = 1\n", &format!("mass = 1\npolar_inertia = {polar}\n")));
        let t = o.find_table("speeds").unwrap();
        (column(t, "speed"), column(t, "energy"))
    };
    let ((w, none), (same, some)) = (energy(0.0), energy(3.0));
    assert!(w == same && w.len() > 10);
    for ((w, none), some) in w.iter().zip(none).zip(some) {
        assert!(((some - none) / (1.5 * w * w) - 1.0).abs() < 1e-9, "{w} {none} {some}");
    }
}

/// The speed with the largest least margin lies where a margin that rises meets one that falls, in closed form: separation `1 - (ws/w)^2` or vibration
/// `1 - (e/A) r^2/(r^2 - 1)` with `r = w/n0`, and stability `1 - w/150`, whose border is 150 rad/s.
#[test]
fn the_best_speed_is_where_margins_meet() {
    let separation = (150.0 * 128.859475728858f64.powi(2)).cbrt();
    // (1 - w/150) = 1 - (e/A) r^2/(r^2 - 1):  r^2 - 1 = (150/n0)(e/A) r
    let b = 150.0 / 60.0 * 0.2 / 0.35;
    let vibration = 60.0 * 0.5 * (b + (b * b + 4.0f64).sqrt());
    for (time, want, binding) in [(1800.0, separation, "separation"), (3000.0, vibration, "vibration")] {
        let o = run(&jeffcott(time));
        let best = o.findings.iter().find(|f| f.id == "best_speed").unwrap();
        assert!((best.value.unwrap() / want - 1.0).abs() < 1e-6, "{time}: {} {want}", best.value.unwrap());
        let of = |name: &str| best.evidence.iter().find(|e| e.what == format!("margin of {name}")).unwrap().value;
        assert!((of("stable") - (1.0 - want / 150.0)).abs() < 1e-5 && (of(binding) - of("stable")).abs() < 1e-5, "{time}");
    }
}

/// What the dynamics leave out is said: cups that hang on nothing, and the liquid of a bowl.
#[test]
fn what_is_not_carried_is_said() {
    let said = |text: &str, id: &str| run(text).findings.iter().filter(|f| f.id == id).map(|f| f.sentence()).collect::<Vec<_>>();
    assert!(said(CUPS, "cups_not_carried").is_empty());
    let loose = said(&CUPS.replace("on = \"rotor\"\n", ""), "cups_not_carried");
    assert!(loose.len() == 1 && loose[0].contains("\"cups\"") && loose[0].contains("on = \"rotor\""), "{loose:?}");
    let bowl = jeffcott(3000.0);
    assert_eq!(said(&bowl, "bowl_without_liquid").len(), 1);
    let liquid = "[[part]]\nkind = \"liquid\"\nin = \"rotor\"\nfill = { free_surface_radius = \"90 mm\" }\ncavity_radius = \"190 mm\"\n\
                  cavity_height = \"500 mm\"\nwave_damping = \"2 1/s\"\ndensity = 1000\n[[cup]]";
    assert!(said(&bowl.replace("[[cup]]", liquid).replace("mass = 1\n", "mass = 100\n"), "bowl_without_liquid").is_empty());
}

/// In a machine that liquid flows through advice speaks of the throughput; a window that begins below ten times gravity is in doubt.
#[test]
fn flow_machines_are_reported_in_throughputs() {
    let one = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).cloned();
    let o = run(&jeffcott(1200.0));
    let relaxation = one(&o, "relaxation").unwrap();
    // the share to which the throughput falls is that by which the time rises
    let share = relaxation.number("share").unwrap() * relaxation.value.unwrap();
    assert!((share - 1.0).abs() < 1e-12 && relaxation.sentence().contains("throughput"), "{relaxation:?}");
    let shortest = one(&o, "shortest_time").unwrap();
    let volume = PI * (0.19f64.powi(2) - 0.09f64.powi(2)) * 0.5;
    let throughput = shortest.number("throughput").unwrap();
    assert!((throughput * shortest.value.unwrap() / volume - 1.0).abs() < 1e-9, "{shortest:?}");
    assert!(shortest.sentence().contains("m³/s"), "{}", shortest.sentence());
    assert!(one(&o, "gravity").is_none());
    // particles so coarse that 20 rad/s, 3.7 g at the surface, suffice
    let coarse = jeffcott(3000.0).replace("self_centring = 0.5\n", "");
    let coarse = coarse
        .replace("particle_density = 2000", "particle_density = 29000")
        .replace("viscosity = \"1 mPa s\"", "viscosity = \"0.5 mPa s\"");
    let o = run(&coarse);
    let w = column(o.find_table("window").unwrap(), "low")[0];
    let felt = o.findings.iter().find(|f| f.id == "gravity").unwrap_or_else(|| panic!("{:?}", o.findings));
    assert!((felt.value.unwrap() / (w * w * 0.09 / 9.80665) - 1.0).abs() < 1e-9 && felt.value.unwrap() < 10.0);
}

/// Without the self-centring requirement the speeds below the resonance are a window of their own: its closed-form ends, both sides.
#[test]
fn two_windows_around_a_resonance() {
    let text = jeffcott(3000.0).replace("self_centring = 0.5\n", "");
    let text = text[..text.find("[[cup]]").unwrap()].to_string()
        + "[limits]\ndisplacement = \"0.35 mm\"\n[[study]]\nkind = \"operating_window\"\nspeed = { from = \"20 rad/s\", to = \"400 rad/s\" }\n";
    let o = run(&text);
    let t = o.find_table("window").unwrap();
    let row = &rows(include_str!("../reference/separation/operating_window_example.csv"))[0];
    assert_eq!(t.rows(), 2);
    for (got, k) in [(column(t, "high")[0], 1), (column(t, "low")[1], 2)] {
        assert!((got / number(row[k]) - 1.0).abs() < 1e-8, "{got} {}", row[k]);
    }
    assert_eq!(words(t, "low event")[0], "domain limit");
    assert!(o.find_table("trade").is_none());
}

const CUPS: &str = r#"
[machine]
name = "cups"
[[part]]
kind = "disc"
name = "rotor"
mass = 10
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["rotor", "ground"]
stiffness = 4e5
[[part]]
kind = "damper"
name = "air"
between = ["rotor", "ground"]
damping = 200
[[cup]]
kind = "swinging"
name = "cups"
on = "rotor"
count = 4
mass = "500 g"
centre_of_mass = "100 mm"
hinge_radius = "150 mm"
cup_radius = "20 mm"
bottom = "150 mm"
mass_differences = ["3 g", 0, 0, 0]
[limits]
displacement = "0.1 mm"
[[study]]
kind = "operating_window"
speed = { from = "1 rad/s", to = "600 rad/s" }
"#;

/// Unbalance and mass of the cups at the tilt of every speed, against the closed form of the machine they make.
#[test]
fn cups_load_their_rotor() {
    let o = run(CUPS);
    let s = o.find_table("speeds").unwrap();
    let (w, u, m) = (column(s, "speed"), column(s, "unbalance"), o.find_table("margins").unwrap());
    let vibration: Vec<(f64, f64)> = column(m, "speed")
        .into_iter()
        .zip(column(m, "margin"))
        .zip(words(m, "requirement"))
        .filter(|x| x.1 == "vibration")
        .map(|x| x.0)
        .collect();
    assert_eq!(vibration.len(), w.len());
    for ((w, u), (_, margin)) in w.iter().zip(&u).zip(&vibration) {
        // tilt by its own equation, solved by halving
        let (mut a, mut b) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..200 {
            let x = 0.5 * (a + b);
            if 9.80665 * f64::sin(x) < w * w * (0.15 + 0.1 * f64::sin(x)) * f64::cos(x) { a = x } else { b = x }
        }
        let unbalance = 0.003 * (0.15 + 0.1 * a.sin());
        assert!((u / unbalance - 1.0).abs() < 1e-12, "{w} {u} {unbalance}");
        let mass = 10.0 + 4.0 * 0.5 + 0.003;
        let amplitude = unbalance * w * w / (4e5 - mass * w * w).hypot(200.0 * w);
        assert!((1.0 - amplitude / 1e-4 - margin).abs() < 1e-9, "{w} {margin}");
    }
}

/// A rotor on a stiffening bearing.
const STIFFENING: &str = r#"
[machine]
name = "stiffening"
[[part]]
kind = "disc"
name = "rotor"
mass = 2.4
eccentricity = "50 um"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["rotor", "ground"]
stiffness = 1.1e7
cubic_stiffness = 8.7e12
law = "isotropic"
[[part]]
kind = "damper"
name = "air"
between = ["rotor", "ground"]
damping = 400
[limits]
displacement = "0.45 mm"
"#;

/// A machine with a stiffening bearing: between its folds two stable states exist, and the larger one closes the window.
#[test]
fn coexisting_states_close_the_window() {
    let study = "[[study]]\nkind = \"operating_window\"\nspeed = { from = \"1000 rad/s\", to = \"5000 rad/s\", points = 60 }\n";
    let o = run(&format!("{STIFFENING}{study}"));
    let s = o.find_table("speeds").unwrap();
    // circular motion z = a exp(i W t): [(k + k3 a^2 - m W^2)^2 + (c W)^2] a^2 = (m e W^2)^2, a cubic in a^2
    let states = |w: f64| -> Vec<f64> {
        let f = |q: f64| ((1.1e7 + 8.7e12 * q - 2.4 * w * w).powi(2) + (400.0 * w).powi(2)) * q - (2.4 * 5e-5 * w * w).powi(2);
        let n = 200_000;
        let grid = |i: usize| (1e-3 * i as f64 / n as f64).powi(2);
        let brackets = (0..n).filter(|&i| f(grid(i)) * f(grid(i + 1)) <= 0.0 && f(grid(i)) != 0.0);
        brackets.map(|i| (0.5 * (grid(i) + grid(i + 1))).sqrt()).collect()
    };
    let coexist: Vec<f64> = (0..400).map(|i| 2300.0 + i as f64).filter(|&w| states(w).len() == 3).collect();
    let (first, last) = (coexist[0], coexist[coexist.len() - 1]);
    assert!(last - first > 40.0 && last < 2690.0, "the machine of the test has a hysteresis");
    let inside: Vec<bool> = match &s.column("inside").unwrap().data {
        laval::outcome::Data::Flag(v) => v.clone(),
        _ => unreachable!(),
    };
    let counted = column(s, "states");
    for ((w, inside), met) in column(s, "speed").into_iter().zip(inside).zip(counted) {
        let all = states(w);
        if (w - first).abs() < 2.0 || (w - last).abs() < 2.0 {
            continue;
        }
        // of three states the middle one is unstable
        assert_eq!(met as usize, if all.len() == 3 { 2 } else { 1 }, "{w}");
        let largest = all.iter().copied().fold(0.0, f64::max);
        if (largest / 4.5e-4 - 1.0).abs() > 1e-2 {
            assert_eq!(inside, largest < 4.5e-4, "{w} {largest}");
        }
    }
    // above, the window begins again where the larger state ceases to exist
    let t = o.find_table("window").unwrap();
    assert_eq!((t.rows(), words(t, "low event")[1].as_str()), (2, "jump"));
    let fold = column(t, "low")[1];
    assert!((fold - last).abs() < 1.5 && states(fold + 1.5).len() == 1 && states(fold - 1.5).len() == 3, "{fold} {last}");
}

/// The branch that a slow run-up reaches: the larger state up to the fold where it ends, also where the smaller one keeps the limit.
#[test]
fn policies_choose_among_the_states() {
    let text = |policy: &str, from: f64, to: f64| {
        format!(
            r#"{STIFFENING}
[[study]]
kind = "operating_window"
speed = {{ from = "{from} rad/s", to = "{to} rad/s", points = 12 }}
ramp = "2 s"
branch_policy = "{policy}"
"#
        )
    };
    // between the folds
    let outcomes: Vec<Outcome> = ["all", "reached", "highest"].iter().map(|p| run(&text(p, 2400.0, 2900.0))).collect();
    let margin = |o: &Outcome| -> Vec<(f64, f64)> {
        let t = o.find_table("margins").unwrap();
        let rows = column(t, "speed").into_iter().zip(column(t, "margin")).zip(words(t, "requirement"));
        rows.filter(|r| r.1 == "vibration").map(|r| r.0).collect()
    };
    let (all, reached, highest) = (margin(&outcomes[0]), margin(&outcomes[1]), margin(&outcomes[2]));
    let states = column(outcomes[0].find_table("speeds").unwrap(), "states");
    assert!(states.contains(&2.0), "no speed has two states");
    for ((w, a), n) in all.iter().zip(&states) {
        let other = |v: &[(f64, f64)]| v.iter().find(|x| x.0 == *w).map(|x| x.1);
        if let (Some(r), Some(h)) = (other(&reached), other(&highest)) {
            assert!((h - a).abs() < 1e-9, "{w}");
            // going up slowly the larger state is kept until it ends
            assert!((r - a).abs() < 1e-9, "{w} {n}: {r} {a}");
        }
    }
}

#[test]
fn mistakes_are_reported() {
    let one = |text: &str, code: &str| {
        let found = load(text).err().unwrap_or_else(|| panic!("{code}: no mistake found"));
        assert!(found.0.iter().any(|d| d.code == code), "{code}: {found:?}");
        assert!(found.0.iter().all(|d| d.span.is_some()), "{found:?}");
    };
    let base = jeffcott(3000.0);
    one(&base.replace("particle_density = 2000", "particle_density = 1000"), "separation.neutral");
    one(&base.replace("surface_radius = \"90 mm\"", "surface_radius = \"200 mm\""), "cup.radii");
    one(&base.replace("displacement = \"0.35 mm\"", "displacement = { rotr = \"0.35 mm\" }"), "limits.name");
    one(&base.replace("start = \"slowest\"", "time = \"1 h\""), "separation.throughput");
    one(&base.replace("[[cup]]", "[cup]"), "file.brackets");
    one(&base.replace("[suspension]", "[suspensoin]"), "file.unknown_table");
    one(&base.replace("viscosity = \"1 mPa s\"", ""), "suspension.viscosity");
    one(&base.replace("kind = \"tubular_bowl\"", "kind = \"tubular\""), "kind.unknown");
    one(&base.replace("from = \"20 rad/s\"", "from = \"0 rad/s\""), "operating_window.speed");
    one(&base.replace("start = \"slowest\"", "uncertain = { suspension.viscosty = 0.1 }"), "parameter.unknown");
    let unknown = load(&base.replace("start = \"slowest\"", "uncertain = { suspension.viscosty = 0.1 }")).err().unwrap();
    assert!(unknown.0.iter().any(|d| d.help.as_deref().is_some_and(|h| h.contains("suspension.viscosity"))), "{unknown:?}");
    one(&CUPS.replace("on = \"rotor\"", "on = \"rotr\""), "body.missing");
    one(&CUPS.replace("[\"3 g\", 0, 0, 0]", "[\"3 g\", 0]"), "cup.count");
    one(&CUPS.replace("[\"3 g\", 0, 0, 0]", "[\"-3 kg\", 0, 0, 0]"), "cup.negative");
    // four cups of 20 mm fit from a radius of sqrt(2) 20 mm on
    one(&CUPS.replace("hinge_radius = \"150 mm\"", "hinge_radius = \"28.2 mm\""), "cup.overlap");
    one(&CUPS.replace("hinge_radius = \"150 mm\"", "hinge_radius = 0"), "cup.overlap");
    assert!(load(&CUPS.replace("hinge_radius = \"150 mm\"", "hinge_radius = \"28.3 mm\"")).is_ok());
    one(&CUPS.replace("centre_of_mass = \"100 mm\"", "centre_of_mass = \"9.9 m\""), "cup.centre");
    one(&CUPS.replace("centre_of_mass = \"100 mm\"", "centre_of_mass = \"99 m\""), "value.bounds");
    one(&CUPS.replace("speed = { from", "branch_policy = \"reached\"\nspeed = { from"), "operating_window.separation");
    one(&CUPS.replace("displacement = \"0.1 mm\"", "drive_torque = \"3 N m\""), "operating_window.separation");
    // a run-up that is longer than the time it counts in
    let sand = "[suspension]\nliquid_density = 1000\nviscosity = \"1 mPa s\"\nparticle_density = 2000\ndiameter = \"9 um\"\n[limits]";
    let hurried = CUPS.replace("[limits]", sand).replace("speed = { from", "time = \"1 min\"\nramp = \"2 min\"\nspeed = { from");
    one(&hurried, "operating_window.ramp");
    assert!(load(&hurried.replace("ramp = ", "count_ramp = false\nramp = ")).is_ok());
    assert!(load(&hurried.replace("1 min", "3 min")).is_ok());
}

#[test]
fn all_wrong_fields_are_reported_at_once() {
    let fields = r#"speed = { from = "600 rad/s", to = "1 rad/s" }
objective = "time"
branch_policy = "reached"
uncertain = { rotor.mass = 0.1, shaft.stiffnes = 0.1 }
map = { parameter = "air.damping", from = 300, to = 100 }
"#;
    let text = CUPS.replace("speed = { from = \"1 rad/s\", to = \"600 rad/s\" }\n", fields);
    let found = load(&text).err().expect("five mistakes");
    let mut lines: Vec<(usize, &str)> =
        found.0.iter().map(|d| (text[..d.span.clone().expect("a place").start].matches('\n').count(), d.code)).collect();
    let first = lines[0].0;
    lines.iter_mut().for_each(|l| l.0 -= first);
    let all = ["study.range", "operating_window.objective", "operating_window.separation", "parameter.unknown", "study.range"];
    assert_eq!(lines, all.into_iter().enumerate().collect::<Vec<_>>(), "{found:?}");
    // what is requested of the separation as well
    let text = jeffcott(3000.0)
        .replace("particle_density = 2000", "particle_density = 1000")
        .replace("start = \"slowest\"", "time = \"1 h\"\nbranch_policy = \"reached\"");
    let mut codes: Vec<&str> = load(&text).err().expect("three mistakes").0.iter().map(|d| d.code).collect();
    codes.sort_unstable();
    assert_eq!(codes, ["operating_window.separation", "separation.neutral", "separation.throughput"]);
}

/// In the passage the cups load the rotor as they hang at every moment: at the resonance, low in the range, less than at the top. The largest displacement comes after the
/// resonance; it lies between those of loads that stay what they are at either speed.
#[test]
fn passages_carry_the_load_of_their_speed() {
    let soft = CUPS.replace("stiffness = 4e5", "stiffness = 300").replace("damping = 200", "damping = 4");
    let text = soft.replace("displacement = \"0.1 mm\"", "passage_displacement = \"1 m\"").replace(
        "speed = { from = \"1 rad/s\", to = \"600 rad/s\" }",
        "speed = { from = \"1 rad/s\", to = \"60 rad/s\", points = 8 }\nramp = \"120 s\"",
    );
    let o = run(&text);
    let up = o.findings.iter().find(|f| f.id == "passage_peak").unwrap();
    let e = |what: &str| up.evidence.iter().find(|e| e.what == what).unwrap().value;
    // the same machine without cups, with their mass and the unbalance at a speed written into the disc
    let tilt = |w: f64| {
        let (mut a, mut b) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..200 {
            let x = 0.5 * (a + b);
            if 9.80665 * f64::sin(x) < w * w * (0.15 + 0.1 * f64::sin(x)) * f64::cos(x) { a = x } else { b = x }
        }
        a
    };
    let unbalance = |a: f64| 0.003 * (0.15 + 0.1 * a.sin());
    let frozen = |unbalance: f64| {
        let start = text.find("[[cup]]").unwrap();
        let end = text.find("[limits]").unwrap();
        let disc = format!("mass = 12.003\neccentricity = {:e}", unbalance / 12.003);
        let o = run(&(text[..start].replace("mass = 10", &disc) + &text[end..]));
        evidence(&o, "passage_peak")
    };
    let resonance = (300.0f64 / 12.003).sqrt();
    let (before, own, top) = (frozen(unbalance(tilt(resonance))), frozen(unbalance(tilt(e("speed")))), frozen(unbalance(1.57)));
    let found = up.value.unwrap();
    assert!(before < found && found < own && 1.05 * own < top, "{before} {found} {own} {top}");
}

/// The uncertain window lies inside the plain one, and the map agrees with it at the value of the file.
#[test]
fn robust_windows_and_maps() {
    let text = jeffcott(1800.0).replace("start = \"slowest\"", "start = \"slowest\"\nspeed_tolerance = \"1 %\"\nuncertain = { suspension.viscosity = \"10 %\" }\nmap = { parameter = \"suspension.viscosity\", from = \"0.5 mPa s\", to = \"1.5 mPa s\", points = 3 }");
    let o = run(&text);
    let robust = o.findings.iter().find(|f| f.id == "robust_window").unwrap();
    // a tenth more viscosity takes sqrt(1.1) more speed; one percent of room on both sides
    let low = robust.evidence.iter().find(|e| e.what == "from").unwrap().value;
    assert!((low / (128.859475728858 * 1.1f64.sqrt() / 0.99) - 1.0).abs() < 1e-6, "{low}");
    assert!((robust.value.unwrap() / (150.0 / 1.01) - 1.0).abs() < 1e-6);
    let map = o.find_table("map").unwrap();
    assert_eq!(map.rows(), 180);
    let kept: Vec<(f64, f64)> = column(map, "speed")
        .into_iter()
        .zip(column(map, "suspension.viscosity"))
        .zip(column(map, "margin"))
        .filter(|x| x.1 >= 0.0)
        .map(|x| x.0)
        .collect();
    assert!(kept.iter().any(|x| x.1 == 0.5e-3) && kept.iter().all(|x| x.1 < 1.2e-3 && x.0 > 91.0));
}

/// A bowl is assessed full of suspension and full of clear liquid: the larger growth rate of both machines.
#[test]
fn stability_before_and_after_the_separation() {
    let text = |particle: f64, density: f64, fraction: f64| {
        format!(
            r#"
[machine]
name = "bowl"
[[part]]
kind = "disc"
name = "rotor"
mass = 1
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["rotor", "ground"]
stiffness = 3600
[[part]]
kind = "damper"
name = "external"
between = ["rotor", "ground"]
damping = 20
[[part]]
kind = "liquid"
name = "contents"
in = "rotor"
fill = {{ free_surface_radius = "20 mm" }}
cavity_radius = "50 mm"
cavity_height = "50 mm"
wave_damping = "2 1/s"
density = {density:e}
[[cup]]
kind = "tubular_bowl"
length = "50 mm"
bowl_radius = "50 mm"
surface_radius = "20 mm"
[suspension]
liquid_density = 800
viscosity = "1 mPa s"
particle_density = {particle}
volume_fraction = {fraction}
diameter = "10 um"
[[study]]
kind = "operating_window"
speed = {{ from = "10 rad/s", to = "200 rad/s", points = 12 }}
throughput = "100 l/h"
particles = 16
"#
        )
    };
    let growth = |particle: f64, density: f64, fraction: f64| {
        let o = run(&text(particle, density, fraction));
        let s = o.find_table("speeds").unwrap();
        column(s, "speed").into_iter().zip(column(s, "growth")).collect::<Vec<_>>()
    };
    // a fifth of heavy particles: 1200 kg/m^3 as fed, 800 when clear; of light ones 700 as fed
    let mut decided = [0, 0];
    for (particle, mixed) in [(2800.0, 1200.0), (300.0, 700.0)] {
        let (both, fed, clear) = (growth(particle, mixed, 0.2), growth(particle, mixed, 0.0), growth(particle, 800.0, 0.0));
        let at = |all: &[(f64, f64)], w: f64| all.iter().find(|x| (x.0 / w - 1.0).abs() < 1e-12).map(|x| x.1);
        for (w, g) in &both {
            let (Some(a), Some(b)) = (at(&fed, *w), at(&clear, *w)) else { continue };
            assert!((g - a.max(b)).abs() < 1e-9 * (1.0 + g.abs()), "{w}: {g} {a} {b}");
            assert!((a - b).abs() > 1e-6, "{w}: the density makes a difference");
            decided[usize::from(b > a)] += 1;
        }
    }
    assert!(decided[0] > 0 && decided[1] > 0 && decided[0] + decided[1] >= 24, "{decided:?}");
}

/// A horizontal rotor starts its passage where it hangs: the sag is no displacement of the run-up, and a limit below it is kept. The torque of a rotor without polar inertia is
/// reported to be without it.
#[test]
fn passages_of_horizontal_machines_start_sagged() {
    let machine = |inertia: &str| {
        format!(
            "[machine]\naxis = \"horizontal\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 10\neccentricity = \"1 um\"\n{inertia}\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"rotor\", \"ground\"]\nkxx = 1e5\nkyy = 1e5\ncxx = 500\ncyy = 500\n\
             [limits]\npassage_displacement = \"0.1 mm\"\n\
             [[study]]\nkind = \"operating_window\"\nspeed = {{ from = 10, to = 80, points = 10 }}\nramp = 4\n"
        )
    };
    let sag = 10.0 * 9.80665 / 1e5;
    let o = run(&machine(""));
    let peaks: Vec<f64> = o.findings.iter().filter(|f| f.id == "passage_peak").filter_map(|f| f.value).collect();
    assert!(!peaks.is_empty() && peaks.iter().all(|p| *p < 0.02 * sag), "{peaks:?} {sag}");
    assert!(o.findings.iter().any(|f| f.id == "spin_inertia"), "{:?}", o.findings);
    let o = run(&machine("polar_inertia = 0.1\n"));
    assert!(o.findings.iter().all(|f| f.id != "spin_inertia"));
}
