//! A rotor that tilts and does not move: a dynamic unbalance on a conical critical speed, whose tilt has a closed form.
//!
//! `A theta'' - i C W theta' + c theta' + k theta = (A - C) W^2 tau exp(i W t)`: tilt `(A - C) W^2 tau/|k - (A - C) W^2 + i c W|`.

use laval::file::load;
use laval::outcome::{Finding, Outcome};
use laval::study::Context;

const A: f64 = 0.1;
const C: f64 = 0.09;
const TAU: f64 = 1e-3;
const K: f64 = 1e4;
const DAMPING: f64 = 0.01;

fn tilt(w: f64) -> f64 {
    let force = (A - C) * w * w;
    force * TAU / (K - force).hypot(DAMPING * w)
}

/// With a spring of no account at this height.
fn machine(height: f64, limit: &str) -> String {
    format!(
        "[machine]\nspeed = 1000\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\ndiametral_inertia = {A}\npolar_inertia = {C}\nskew = {TAU}\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"d\", \"ground\"]\nstiffness = 1e6\ntilt_stiffness = {K}\n\
         [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"d\", \"ground\"]\ndamping = 1\ntilt_damping = {DAMPING}\n\
         [[part]]\nkind = \"damper\"\nname = \"probe\"\nbetween = [{{ body = \"d\", at = {height} }}, \"ground\"]\ndamping = 1e-9\n\
         [limits]\n{limit}\n"
    )
}

fn run(machine: &str, kind: &str, fields: &str) -> Outcome {
    let loaded = load(&format!("{machine}[[study]]\nkind = \"{kind}\"\n{fields}\n")).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("tilt")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn finding<'o>(o: &'o Outcome, id: &str) -> &'o Finding {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no {id}: {:?}", o.findings))
}

fn near(found: f64, known: f64, relative: f64) {
    assert!((found - known).abs() <= relative * known.abs(), "{found} {known}");
}

const RANGE: &str = "speed = { from = 10, to = 4000 }";

#[test]
fn the_response_has_a_resonance_of_the_tilt() {
    let o = run(&machine(0.0, ""), "forced_response", RANGE);
    let f = finding(&o, "largest_tilt_resonance");
    let peak = f.value.expect("a speed");
    near(peak, 1000.0, 1e-6);
    near(f.evidence.iter().find(|e| e.what == "tilt").expect("a tilt").value, tilt(peak), 1e-8);
    let t = o.find_table("response").expect("a response");
    let column = |name: &str, i: usize| t.column(name).and_then(|c| c.number(i)).unwrap_or_else(|| panic!("no {name}"));
    for i in 0..t.rows() {
        let w = column("speed", i);
        near(column("tilt.d", i), tilt(w), 1e-8);
        // the spring against tilt carries what it turns by
        near(column("moment.shaft", i), K * tilt(w), 1e-3);
    }
    // the model of a small tilt ends before
    assert!(finding(&o, "validity").sentence().contains("tilt over 0.1 rad"));
    let criticals = run(&machine(0.0, ""), "critical_speeds", RANGE);
    let tilts = |f: &&Finding| f.sentence().contains("Response peak at 1000 rad/s: the tilt of \"d\"");
    let peak = criticals.findings.iter().find(tilts).and_then(|f| f.number("peak"));
    near(peak.unwrap_or_else(|| panic!("{:?}", criticals.findings)), 1000.0, 1e-4);
}

/// A point above the reference point moves by the tilt times its height.
#[test]
fn a_point_off_the_reference_point_moves() {
    let o = run(&machine(0.1, ""), "forced_response", RANGE);
    let t = o.find_table("response").expect("a response");
    let column = |name: &str, i: usize| t.column(name).and_then(|c| c.number(i)).unwrap_or_else(|| panic!("no {name}"));
    for i in 0..t.rows() {
        near(column("amplitude.d at 100 mm", i), 0.1 * tilt(column("speed", i)), 1e-6);
    }
    assert!(finding(&o, "largest_resonance").sentence().contains("\"d\" at 100 mm"));
}

/// Ends of the windows, by the kind of the special points.
fn windows(o: &Outcome) -> Vec<(f64, f64)> {
    let of = |kind: &str| o.special_points.iter().filter(|p| p.kind == kind).map(|p| p.at).collect::<Vec<f64>>();
    of("window_low").into_iter().zip(of("window_high")).collect()
}

/// No margin at the resonance: by the validity of a small tilt, by a limit on the tilt or on a moment, by the displacement of a point where something is attached.
#[test]
fn no_window_holds_a_resonance_of_the_tilt() {
    let inside = |o: &Outcome| windows(o).iter().any(|(low, high)| *low <= 1000.0 && 1000.0 <= *high);
    let reference = run(&machine(0.0, "displacement = \"0.1 mm\""), "operating_window", RANGE);
    assert!(!windows(&reference).is_empty() && !inside(&reference), "{:?}", windows(&reference));
    assert!(finding(&reference, "tilt_without_limit").value.is_some_and(|x| x > 0.05 && x <= 0.1));
    // tilt 2e-3: (A - C) W^2 tau = +- 2e-3 (K - (A - C) W^2)
    let (low, high) = ((20.0f64 / 3e-5).sqrt(), 2e6f64.sqrt());
    for (height, limit) in [(0.0, "tilt = 2e-3"), (0.0, "moment = { shaft = 20 }"), (0.1, "displacement = { d = \"0.2 mm\" }")] {
        let o = run(&machine(height, limit), "operating_window", RANGE);
        let w = windows(&o);
        assert_eq!(w.len(), 2, "{limit}: {w:?}");
        near(w[0].1, low, 1e-4);
        near(w[1].0, high, 1e-4);
        assert!(!o.findings.iter().any(|f| f.id == "tilt_without_limit"), "{limit}");
    }
}

#[test]
fn motions_and_steady_states_show_the_tilt() {
    let o = run(&machine(0.0, ""), "transient", "duration = \"0.5 s\"");
    assert_eq!(finding(&o, "largest_displacement").message.key, "history-only-tilts");
    // at resonance the tilt grows at first like W tau (A - C)/(2 A - C) t
    let grown = finding(&o, "largest_tilt").value.expect("a tilt");
    let known = 1000.0 * TAU * (A - C) / (2.0 * A - C) * 0.5;
    near(grown, known, 0.1);
    let o = run(&machine(0.0, ""), "nonlinear_response", RANGE);
    near(finding(&o, "largest_tilt").value.expect("a tilt"), tilt(1000.0), 1e-6);
    let o = run(&machine(0.0, ""), "run_up", "from = \"900 rad/s\"\nto = \"1100 rad/s\"\nduration = \"2 s\"");
    assert!(o.findings.iter().any(|f| f.id == "peak" && f.subject == "tilt of d"), "{:?}", o.findings);
}
