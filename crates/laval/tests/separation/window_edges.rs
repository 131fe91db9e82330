//! Why the window of a nonlinear machine without a duty ends where it ends: limits that are reached, jumps at folds, growth rates.

use crate::common;

use common::base::{Base, run};
use laval::file::load;
use laval::outcome::{Data, Finding, Outcome, Table};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::measure::Measure;
use laval::solve::harmonic::branches::response::Request;
use laval::study::Context;
use laval_num::complex::C64;
use laval_num::newton::{Options, newton};

const MACHINE: &str = r#"
[machine]
name = "planar set"
[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "0.05 mm"
[[part]]
kind = "foundation"
name = "base"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "6.59 N s/m"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "base"]
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"
law = "per_axis"
[[part]]
kind = "damper"
name = "air"
between = ["drum", "ground"]
damping = "42 N s/m"
"#;

fn window(limits: &str, extra: &str) -> Outcome {
    let text = format!(
        "{MACHINE}{extra}\n[limits]\n{limits}\n[[study]]\nkind = \"operating_window\"\nspeed = {{ from = \"50 rad/s\", to = \"5000 rad/s\" }}\n"
    );
    let loaded = load(&text).unwrap_or_else(|d| panic!("{:?}", d.0));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("window")).unwrap()
}

fn edges<'a>(o: &'a Outcome, side: &str) -> Vec<&'a Finding> {
    o.findings.iter().filter(|f| f.id == "edge" && f.subject == side).collect()
}

fn evidence(f: &Finding, what: &str) -> f64 {
    f.evidence.iter().find(|e| e.what == what).unwrap_or_else(|| panic!("no {what} in {f:?}")).value
}

fn words(t: &Table, name: &str) -> Vec<String> {
    match &t.column(name).unwrap().data {
        Data::Text(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// At the edge the state of small motions has just the displacement, or force, that is allowed; where the branch of large motions begins, the window of high speeds
/// begins, at the fold of the reference.
#[test]
fn limits_are_reached_and_jumps_lie_at_folds() {
    let base = Base { e: 5e-5, ..Base::default() };
    let system = base.builder().build().unwrap();
    let response = run(base.builder(), Request { stability: false, truncation: 1e-9, ..Request::over(25.0, 5000.0) });
    let folds: Vec<f64> = response.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect();
    let upper = folds.iter().copied().fold(0.0, f64::max);
    assert!((upper - 2668.4586212391).abs() < 1e-6, "{folds:?}");
    for (limits, measure, limit, says) in [
        ("displacement = { drum = \"0.3 mm\" }", Measure::Probe(0), 3e-4, "displacement of \"drum\" reaches its limit, 300 µm"),
        ("force = { bearing = \"2 kN\" }", Measure::Force(2), 2000.0, "force of \"bearing\" reaches its limit, 2 kN"),
    ] {
        let o = window(limits, "");
        let (ends, begins) = (edges(&o, "ends"), edges(&o, "begins"));
        assert_eq!((ends.len(), begins.len()), (1, 1), "{:?}", o.findings);
        let at = ends[0].value.unwrap();
        assert!(ends[0].sentence().contains(says), "{}", ends[0].sentence());
        assert!(evidence(ends[0], "width of the bracket") < 1e-8);
        let mut balance = Balance::new(&system, response.discretisation.whole(), (25.0, 5000.0), None).unwrap();
        let below = response.branches[0].points.iter().take_while(|p| p.speed < at).last().unwrap();
        let mut x = below.x.clone();
        newton(&mut balance, &mut x, at, &Options { to_rounding: true, ..Options::default() }).unwrap();
        let found = measure.largest(&system, &Orbit::of(&mut balance, &x, at).unwrap(), 1).0;
        assert!((found - limit).abs() < 1e-9 * limit, "{found} {limit}");
        let jump = begins[0].value.unwrap();
        assert!((jump - upper).abs() < 1e-7, "{jump} {upper}");
        assert!(evidence(begins[0], "difference from the fold by its extended system") < 1e-7);
        let why = begins[0].sentence();
        assert!(why.contains("2 stable states, any of which a slow run-up or run-down can reach") && why.contains("at a fold"), "{why}");
        let widest = o.findings.iter().find(|f| f.id == "widest_window").unwrap();
        assert!((widest.value.unwrap() - (5000.0 - jump).max(at - 50.0)).abs() < 1e-9);
        let t = o.find_table("window").unwrap();
        assert!(words(t, "high reason")[0].contains("reaches its limit") && words(t, "low reason")[0] == "the range of speeds ends");
    }
}

/// With liquid, stability ends the window where a disturbance begins to grow faster than allowed.
#[test]
fn growth_ends_a_window() {
    let liquid = r#"
[[part]]
kind = "liquid"
name = "liquid"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "1000 kg/m^3"
fill = { free_surface_radius = "46.7 mm" }
wave_damping = "40 1/s"
"#;
    let o = window("growth_margin = \"0.1 1/s\"\ndisplacement = { drum = \"20 mm\" }", liquid);
    let all: Vec<_> = edges(&o, "ends").into_iter().chain(edges(&o, "begins")).collect();
    assert!(all.iter().any(|f| f.sentence().contains("growth rate reaches its limit, −0.1 1/s")), "{:?}", o.findings);
}

/// `few_requirements` is reported where stability alone bounds the window, not where the vibration or the
/// speed has a limit. A requirement with a limit is not among those not checked.
#[test]
fn a_window_needs_more_than_stability() {
    let machine = |limits: &str| {
        let text = format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 10\neccentricity = \"10 um\"\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"rotor\", \"ground\"]\nkxx = 1e6\nkyy = 1e6\ncxx = 500\ncyy = 500\n\
             {limits}[[study]]\nkind = \"operating_window\"\nspeed = {{ from = 50, to = 900, points = 8 }}\n"
        );
        let loaded = load(&text).unwrap_or_else(|d| panic!("{:?}", d.0));
        loaded.studies[0].study.run(&loaded.system, &Context::quiet("window")).unwrap()
    };
    for (limits, few, checked) in [
        ("", true, None),
        ("[limits]\ngrowth_margin = \"1 1/s\"\n", true, None),
        ("[limits]\nclearance = 0.1\n", true, Some("clear")),
        ("[limits]\ndisplacement = \"0.1 mm\"\n", false, Some("vibration")),
        ("[limits]\nspeed = 800\n", false, Some("strength")),
    ] {
        let o = machine(limits);
        assert_eq!(o.findings.iter().any(|f| f.id == "few_requirements"), few, "{limits}: {:?}", o.findings);
        let open = o.findings.iter().find(|f| f.id == "not_checked").unwrap().sentence();
        for (name, words) in [
            ("vibration", "vibration"),
            ("clear", "clearance of natural frequencies"),
            ("strength", "highest speed"),
            ("separation", "separation time"),
        ] {
            assert_eq!(open.contains(words), checked != Some(name), "{limits}: {open}");
        }
        assert!(!open.contains("stability"), "{open}");
    }
}

/// The velocity on an ellipse is the speed times the semi-major axis, reached between the instants of a
/// period at which forces are sampled: the window ends where that passes the limit.
#[test]
fn a_limit_on_the_velocity_is_reached_between_instants() {
    let (m, e, kx, ky, c, limit): (f64, f64, f64, f64, f64, f64) = (1.0, 1e-5, 1e5, 2e5, 5.0, 2e-3);
    for phase in [0.0, 0.7] {
        let text = format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {m}\neccentricity = {e}\neccentricity_phase = {phase}\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nkxx = {kx}\nkyy = {ky}\ncxx = {c}\ncyy = {c}\n\
             [limits]\nvelocity = {limit}\n[[study]]\nkind = \"operating_window\"\nspeed = {{ from = 50, to = 300, points = 8 }}\n"
        );
        let loaded = load(&text).unwrap_or_else(|d| panic!("{:?}", d.0));
        let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("window")).unwrap();
        // x + i y of both circles: the semi-major axis is half the sum of |X + i Y| and |X - i Y|
        let velocity = |w: f64| {
            let axis = |k: f64| C64::real(m * e * w * w) / C64 { re: k - m * w * w, im: c * w };
            let (x, y) = (axis(kx), axis(ky) * C64 { re: 0.0, im: -1.0 });
            0.5 * w * ((x + y.mul_i()).abs() + (x - y.mul_i()).abs())
        };
        let (mut low, mut high) = (50.0, 300.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if velocity(middle) < limit { low = middle } else { high = middle }
        }
        let ends = edges(&o, "ends");
        assert!(ends.len() == 1 && (ends[0].value.unwrap() / low - 1.0).abs() < 1e-8, "{:?} {low}", o.findings);
    }
}

/// What nothing damps neither grows nor decays: it keeps a margin of 0, the whole range through, and no other. What grows keeps none.
#[test]
fn a_neutral_mode_is_not_unstable() {
    let linear = "kind = \"shaft_lumped\"\nstiffness = 2e6\ntilt_stiffness = 2e3\ncoupling = 1e4\n";
    let cubic = "kind = \"bearing_cubic\"\nlaw = \"isotropic\"\nstiffness = 2e6\ncubic_stiffness = 1e12\n";
    let driven = "kind = \"bearing_linear\"\nkxx = 2e6\nkyy = 2e6\nkxy = 1e3\nkyx = -1e3\n";
    let inertia = "diametral_inertia = 0.01\npolar_inertia = 0.015\n";
    let machine = |disc: &str, held: &str, limits: &str| {
        let text = format!(
            "[machine]\nspeed = 200\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 2\neccentricity = 1e-6\n{disc}\
             [[part]]\n{held}between = [\"drum\", \"ground\"]\n[limits]\ndisplacement = 1e-3\n{limits}\
             [[study]]\nkind = \"operating_window\"\nspeed = {{ from = 100, to = 400, points = 20 }}\n"
        );
        let loaded = load(&text).unwrap_or_else(|d| panic!("{:?}", d.0));
        loaded.studies[0].study.run(&loaded.system, &Context::quiet("window")).unwrap()
    };
    let ids = |o: &Outcome| o.findings.iter().map(|f| f.id.clone()).collect::<Vec<_>>();
    for (disc, held) in [(inertia, linear), ("", linear), ("", cubic)] {
        for limits in ["", "growth_margin = 0\n"] {
            let o = machine(disc, held, limits);
            let widest = o.findings.iter().find(|f| f.id == "widest_window").unwrap_or_else(|| panic!("{held}: {:?}", ids(&o)));
            assert!((widest.value.unwrap() - 300.0).abs() < 1e-9, "{held}: {:?}", o.findings);
        }
        let o = machine(disc, held, "growth_margin = 0.1\n");
        assert!(ids(&o).contains(&"no_window".to_string()) && ids(&o).contains(&"growth_margin".to_string()), "{:?}", ids(&o));
    }
    let o = machine("", driven, "growth_margin = 0\n");
    assert!(ids(&o).contains(&"no_window".to_string()) && ids(&o).contains(&"unstable".to_string()), "{:?}", ids(&o));
}

/// A disc of 2 kg on 2e5 N/m without damping: at its critical speed the vibration has no bound, and no margin is a number made by rounding.
#[test]
fn at_an_undamped_resonance_the_vibration_has_no_margin() {
    let text = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\neccentricity = \"10 um\"\n\
                [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nstiffness = 2e5\n\
                [limits]\ndisplacement = \"0.2 mm\"\n\
                [[study]]\nkind = \"operating_window\"\nspeed = { from = 50, to = 900, points = 20 }\n";
    let l = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = l.studies[0].study.run(&l.system, &Context::quiet("window")).unwrap();
    let t = o.find_table("margins").unwrap();
    let (Data::Text(names), Data::Text(by)) = (&t.column("requirement").unwrap().data, &t.column("by").unwrap().data) else { panic!() };
    let number = |column: &str, row: usize| t.column(column).unwrap().number(row).unwrap();
    let pole = 1e5f64.sqrt();
    let at: Vec<usize> = (0..t.rows()).filter(|&r| names[r] == "vibration" && (number("speed", r) / pole - 1.0).abs() < 2e-9).collect();
    assert!(!at.is_empty());
    for r in at {
        assert!(number("margin", r).is_nan() && by[r].contains("without bound"), "{} {}", number("margin", r), by[r]);
    }
}
