//! The study `stationary` on machines that are not the example: continua of balanced states, unequal balls, several balancers, tilting bodies, a shaft with
//! memory, what is refused, and the findings for balancing.

use laval::diagnostic::Diagnostics;
use laval::file::load;
use laval::model::builder::Builder;
use laval::model::field::{Attach, Bounds, Field, ParamValues, Values};
use laval::model::part::{At, Dof, DofKind, Layout, Link, Params, Part, Physics, Rows};
use laval::model::system::{System, Workspace};
use laval::outcome::{Data, End, Finding, Level, Outcome};
use laval::params;
use laval::parts::{damper::*, disc::*, shaft_lumped::*};
use laval::solve::stationary::{Request, Search};
use laval::study::Context;
use laval_num::complex::{C64, c};
use laval_num::scalar::Scalar;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::AtomicBool;

const EXAMPLE: &str = include_str!("../../../../examples/04-ball-balancer/machine.toml");

/// The example's machine with some words exchanged, more lines, and a study over these speeds.
fn machine(changes: &[(&str, &str)], more: &str, study: &str) -> String {
    let mut text = EXAMPLE.split("# Above the critical").next().unwrap().to_string();
    for (old, new) in changes {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    format!("{text}{more}\n[[study]]\nkind = \"stationary\"\n{study}\n")
}

fn outcome(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}\n{text}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("t")).unwrap_or_else(|d| panic!("{d}\n{text}"))
}

fn run(text: &str) -> Outcome {
    let o = outcome(text);
    assert_eq!(o.end, End::Reached);
    o
}

const SPEEDS: &str = "speed = { from = 300, to = 1200, points = 10 }";
const EQUAL: (&str, &str) = ("balls = 2", "balls = 3");
const ROUND: (&str, &str) = ("eccentricity = \"2 um\"", "eccentricity = 0");

fn column<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [f64] {
    let table = o.find_table(table).unwrap_or_else(|| panic!("no table {table}"));
    match &table.column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v,
        _ => panic!("{name} is no number"),
    }
}

fn whole<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [i64] {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Int(v) => v,
        _ => panic!("{name} is no whole number"),
    }
}

fn words<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [String] {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Text(v) => v,
        _ => panic!("{name} is no text"),
    }
}

fn all<'a>(o: &'a Outcome, id: &str) -> Vec<&'a Finding> {
    o.findings.iter().filter(|f| f.id == id).collect()
}

fn one<'a>(o: &'a Outcome, id: &str) -> &'a Finding {
    all(o, id).first().copied().unwrap_or_else(|| panic!("no {id}: {:#?}", o.findings.iter().map(|f| f.sentence()).collect::<Vec<_>>()))
}

fn evidence(f: &Finding, what: &str) -> f64 {
    f.evidence.iter().find(|e| e.what == what).unwrap_or_else(|| panic!("no {what}: {f:?}")).value
}

/// Distance of the disc from the axis with a moment of the balls (kg m, turning axes), on the example's shaft.
fn distance(moment: C64, balls: f64, ring: f64, w: f64) -> f64 {
    let mass = 8.91 + 1.5 + balls * 0.0036;
    let unbalance = c(8.91 * 50e-6 + (1.5 + balls * 0.0036) * ring, 0.0) + moment;
    (unbalance.scale(w * w) / c(2.92e6 - mass * w * w, 400.0 * w)).abs()
}

/// n equal balls that cancel one vector have n - 2 directions left; the balls of the samples keep the disc on the axis.
#[test]
fn three_and_more_balls_balance_in_a_continuum() {
    for (balls, free) in [(3, 1), (5, 3)] {
        let count = format!("balls = {balls}");
        let o = run(&machine(&[("balls = 2", &count), ROUND], "", SPEEDS));
        assert!(words(&o, "continua", "kind").iter().any(|k| k == "balanced"));
        let rows: Vec<usize> =
            (0..column(&o, "continua", "speed").len()).filter(|&k| words(&o, "continua", "kind")[k] == "balanced").collect();
        // at every speed: the condition does not know the speed
        assert_eq!(rows.len(), 10);
        for &k in &rows {
            assert_eq!(whole(&o, "continua", "free")[k], free);
            assert!(whole(&o, "continua", "samples")[k] >= 10);
            let stable = whole(&o, "continua", "stable")[k];
            // below the critical speed (529 rad/s) none, well above it some
            let w = column(&o, "continua", "speed")[k];
            assert!(if w < 550.0 { stable == 0 } else { stable > 0 }, "{w}: {stable}");
        }
        // isolated states do not balance
        assert!(words(&o, "states", "kind").iter().all(|k| k != "balanced"), "{:?}", words(&o, "states", "kind"));
        assert!(all(&o, "no_stable_state").iter().all(|f| f.value.unwrap() < 620.0));
        let stable = all(&o, "balanced_stable");
        assert!(stable.iter().any(|f| f.value == Some(1200.0)), "{stable:?}");
        assert!(all(&o, "unfinished").is_empty(), "{:?}", one(&o, "unfinished"));
        // together they leave the shaft where the closed form has it
        let (speeds, radius) = (column(&o, "states", "speed"), column(&o, "states", "disc radius"));
        let mut together = 0;
        for k in (0..speeds.len()).filter(|&k| words(&o, "states", "kind")[k] == "together") {
            let moment = C64::cis(column(&o, "states", "balancer.ball_1")[k]).scale(f64::from(balls) * 0.0036 * 0.1);
            let want = distance(moment, f64::from(balls), 0.0, speeds[k]);
            assert!((radius[k] - want).abs() < 1e-9 * want, "{}: {} {want}", speeds[k], radius[k]);
            together += 1;
        }
        // on the heavy and on the light side, but near the critical speed
        assert!((16..=20).contains(&together), "{together}");
    }
}

/// With an eccentric ring its centre stays on the axis.
#[test]
fn a_continuum_of_an_eccentric_ring_balances_partly() {
    let o = run(&machine(&[EQUAL], "", SPEEDS));
    assert!(words(&o, "continua", "kind").iter().all(|k| k == "partly_balanced"));
    assert!(whole(&o, "continua", "free").iter().all(|n| *n == 1));
    let last = whole(&o, "continua", "stable").last().copied().unwrap();
    assert!(last > 0 && last <= *whole(&o, "continua", "samples").last().unwrap());
    // one of the continuum needs as much damping as it needs, which is reported
    let study = format!("{SPEEDS}\nstabilise = {{ parameter = \"losses.damping\", from = 1e-3, to = 1000 }}");
    let o = run(&machine(&[EQUAL], "", &study));
    let least = one(&o, "least");
    assert!(least.sentence().contains("one state of the continuum") && least.value.is_some_and(|v| v > 0.01 && v < 400.0), "{least:?}");
}

/// Two unequal balls balance where unbalance and moments form a triangle.
#[test]
fn unequal_balls_balance_within_the_triangle() {
    let unbalance = 8.91 * 50e-6;
    for (first, second) in [(1.0f64, 1.3f64), (0.3, 1.3), (0.9, 2.4), (0.2, 0.9)] {
        let moments = [first, second].map(|m: f64| m * 0.0036 * 0.1);
        let exists = moments[0] + moments[1] > unbalance && (moments[0] - moments[1]).abs() < unbalance;
        let masses = format!("balls = 2\nmass_ratios = [{first}, {second}]");
        let o = run(&machine(&[("balls = 2", &masses), ROUND], "", SPEEDS));
        let kinds = words(&o, "states", "kind");
        assert_eq!(kinds.iter().filter(|k| *k == "balanced").count(), if exists { 20 } else { 0 }, "{first} {second}");
        assert_eq!(all(&o, "insufficient_capacity").is_empty(), moments[0] + moments[1] > unbalance);
        assert_eq!(all(&o, "not_balanced").is_empty(), exists, "{:?}", o.findings);
        // the two balanced states are mirror images: angles with the sign exchanged
        for w in [300.0, 1200.0] {
            let mine = |k: &usize| kinds[*k] == "balanced" && column(&o, "states", "speed")[*k] == w;
            let angles: Vec<[f64; 2]> =
                (0..kinds.len()).filter(mine).map(|k| ["balancer.ball_1", "balancer.ball_2"].map(|b| column(&o, "states", b)[k])).collect();
            for a in &angles {
                let left = (0..2).fold(c(unbalance, 0.0), |sum, i| sum + C64::cis(a[i]).scale(moments[i]));
                assert!(left.abs() < 1e-9 * unbalance, "{a:?}");
                assert!(angles.iter().any(|b| (0..2).all(|i| (a[i] + b[i]).abs() < 1e-8)));
            }
        }
        assert!(kinds.iter().any(|k| k == "together") && kinds.iter().any(|k| k == "opposed"));
    }
}

#[test]
fn one_ball_has_two_states() {
    let o = run(&machine(&[("balls = 2", "balls = 1"), ROUND], "", SPEEDS));
    let share = |k: usize| column(&o, "states", "unbalance")[k] / column(&o, "states", "without")[k];
    for (k, kind) in words(&o, "states", "kind").iter().enumerate() {
        assert_eq!(kind, if share(k) < 0.5 { "reduced" } else { "single" });
    }
    assert_eq!(column(&o, "states", "speed").len(), 20);
    assert!(!all(&o, "not_balanced").is_empty() && !all(&o, "insufficient_capacity").is_empty());
}

/// Two rings in one plane cancel with their moments together; each ball of one may not be exchanged with one of the other.
#[test]
fn two_balancers_on_one_disc() {
    let lower = "\n[[part]]\nkind = \"balancer_ball\"\nname = \"lower\"\non = \"disc\"\nballs = 2\nball_mass = \"2 g\"\ntrack_radius = \"80 mm\"\n\
                 drag = \"2e-3 N m s\"\nbody_tilt = false\n";
    let o = run(&machine(&[ROUND], lower, SPEEDS));
    let free: Vec<i64> = whole(&o, "continua", "free").to_vec();
    assert!(!free.is_empty() && free.iter().all(|f| *f == 2), "{free:?}");
    // with the balls of the first too light to do it alone
    assert!(all(&o, "insufficient_capacity").is_empty());
}

/// A disc that may tilt but is held stiffly is the planar one; its balls then work in three dimensions.
#[test]
fn a_body_that_may_tilt_stiffly_held_is_planar() {
    let flat = run(&machine(&[], "", SPEEDS));
    let spatial = run(&machine(
        &[
            ("body_tilt = false", ""),
            ("polar_inertia = \"0.05 kg m^2\"", "polar_inertia = \"0.05 kg m^2\"\ndiametral_inertia = \"0.03 kg m^2\""),
            ("stiffness = \"2.92e6 N/m\"", "tilt_stiffness = \"1e9 N m/rad\"\nstiffness = \"2.92e6 N/m\""),
        ],
        "",
        SPEEDS,
    ));
    let (a, b) = (column(&flat, "states", "disc radius"), column(&spatial, "states", "disc radius"));
    assert_eq!(words(&flat, "states", "kind"), words(&spatial, "states", "kind"));
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-8 * (a + 1e-9)), "{a:?} {b:?}");
    let changes = |o: &Outcome| o.special_points.iter().map(|p| p.at).collect::<Vec<f64>>();
    let (a, b) = (changes(&flat), changes(&spatial));
    assert!(a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-6 * a), "{a:?} {b:?}");
}

/// Forces on all coordinates in fixed axes at a spin angle, of the parts that `which` takes.
fn forces(system: &System, x: &[f64], w: f64, phase: f64, which: &dyn Fn(&str) -> bool) -> Vec<f64> {
    let n = system.n();
    let mut q = x[..n].to_vec();
    system.turn(&mut q, phase);
    let (mut v, mut a) = (vec![0.0; n], vec![0.0; n]);
    for i in (0..n).filter(|&i| system.coordinates()[i].dof.kind.leads_pair()) {
        (v[i], v[i + 1]) = (-w * q[i + 1], w * q[i]);
        (a[i], a[i + 1]) = (-w * w * q[i], -w * w * q[i + 1]);
    }
    let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; system.m()], 0.0);
    let at = At { q: &q, v: &v, a: &a, z: &[], phase, speed: w, spin_accel: 0.0, t: 0.0 };
    let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
    system.residual(system.params(), &at, &mut out, &mut Workspace::default(), |s| which(&s.name));
    force
}

/// States of a balancer beside the plane of a disc that tilts, inserted in the full equations of motion in fixed axes at several spin angles.
#[test]
fn states_satisfy_the_equations_of_motion() {
    let inertia = "polar_inertia = \"0.05 kg m^2\"\ndiametral_inertia = \"0.03 kg m^2\"\nskew = \"2 mrad\"";
    let text = machine(
        &[
            ("body_tilt = false", "tilt = \"1 deg\"\nnode_line = \"40 deg\""),
            ("polar_inertia = \"0.05 kg m^2\"", inertia),
            ("stiffness = \"2.92e6 N/m\"", "tilt_stiffness = \"4e4 N m/rad\"\nstiffness = \"2.92e6 N/m\""),
            ("on = \"disc\"", "on = { body = \"disc\", at = \"60 mm\" }"),
        ],
        "",
        SPEEDS,
    );
    let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    let system = &loaded.system;
    let (w, cancel) = (900.0, AtomicBool::new(false));
    let request = Request { range: (890.0, 910.0), starts: 60, seeds: vec![w], max_points: 2000, work: u64::MAX };
    let mut search = Search::new(system, &request, &cancel);
    let found = search.run(|_| true).unwrap();
    let states = found.states(&mut search, w);
    assert!(states.len() >= 4, "{}", states.len());
    let tilt = system.coordinates().iter().position(|c| c.name.ends_with("tilt_x")).unwrap();
    for s in &states {
        assert!(s.x[tilt].hypot(s.x[tilt + 1]) > 1e-4);
        for phase in [0.0, 0.9, 4.0] {
            let total = forces(system, &s.x, w, phase, &|_| true);
            let parts: Vec<Vec<f64>> = system.slots().iter().map(|p| forces(system, &s.x, w, phase, &|name| name == p.name)).collect();
            for (i, total) in total.iter().enumerate() {
                let size = parts.iter().map(|f| f[i].abs()).fold(1e-4, f64::max);
                assert!(total.abs() < 1e-8 * size, "{}: {total} beside {size}", system.coordinates()[i].name);
            }
        }
    }
}

/// A bow that turns with the shaft has relaxed: states of a shaft with memory are those of its long-term stiffness.
#[test]
fn a_shaft_with_memory_has_relaxed() {
    let speeds = "speed = { from = 300, to = 1200, points = 3 }\nseeds = 2\nstarts = 4";
    let (amplitude, decay) = (0.04f64, 0.04f64);
    // integral of A t^(-1/2) exp(-b t)
    let lasting = 1.0 - amplitude * (PI / decay).sqrt();
    let memory = format!("supports = \"given\"\namplitude = {amplitude}\nexponent = 0.5\ndecay = {decay}\nstiffness = \"2.92e6 N/m\"");
    let soft = format!("stiffness = {}", 2.92e6 * lasting);
    let with =
        run(&machine(&[("kind = \"shaft_lumped\"", "kind = \"shaft_viscoelastic\""), ("stiffness = \"2.92e6 N/m\"", &memory)], "", speeds));
    let without = run(&machine(&[("stiffness = \"2.92e6 N/m\"", &soft)], "", speeds));
    assert_eq!(words(&with, "states", "kind"), words(&without, "states", "kind"));
    let (a, b) = (column(&with, "states", "disc radius"), column(&without, "states", "disc radius"));
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-7 * b), "{a:?} {b:?}");
    // but it drives the whirl above the critical speed: less is stable than without memory
    let stable = |o: &Outcome| whole(o, "states", "growing").iter().filter(|g| **g == 0).count();
    assert!(stable(&with) <= stable(&without));
}

/// Machines of all kinds come to an end, with something said and nothing left open.
#[test]
fn odd_machines_come_to_an_end() {
    let free = "rings = \"free\"\ndiametral_inertia = 0.01\npolar_inertia = 0.02\ntilt_damping = 1e-3\nbody_tilt = false";
    let cases: [(&str, Vec<(&str, &str)>); 8] = [
        ("undamped", vec![("\"400 N s/m\"", "0"), ("\"2e-3 N m s\"", "0")]),
        ("no drag", vec![("\"2e-3 N m s\"", "0")]),
        ("dry", vec![("body_tilt = false", "body_tilt = false\ndry_torque = 1e-4\nrolling_resistance = 1e-4")]),
        ("contact", vec![EQUAL, ("body_tilt = false", "body_tilt = false\nball_radius = \"5 mm\"\ncontact_stiffness = 1e5")]),
        ("tilted", vec![("body_tilt = false", "body_tilt = false\ntilt = \"2 deg\"")]),
        ("free", vec![("body_tilt = false", free)]),
        ("tracks", vec![("balls = 2", "tracks = { balls = [2, 1], radius = [1.0, 1.2], tilt = [\"0 deg\", \"0.1 deg\"] }")]),
        ("round", vec![ROUND, ("eccentricity = \"50 um\"", "eccentricity = 0")]),
    ];
    for (name, changes) in cases {
        for study in [
            "speed = { from = 300, to = 1200, points = 5 }\nseeds = 2\nstarts = 12",
            "speed = { from = 0, to = 1200, points = 3 }\nseeds = 2",
        ] {
            let o = run(&machine(&changes, "", study));
            assert!(o.findings.iter().any(|f| f.id == "completeness"), "{name}");
            assert!(o.special_points.len() < 400, "{name}: {}", o.special_points.len());
            assert!(o.findings.len() < 40, "{name}: {:#?}", o.findings.iter().map(|f| f.sentence()).collect::<Vec<_>>());
        }
    }
}

/// What stops a study is reported, and what it had until then is kept.
#[test]
fn a_limit_of_work_stops_the_study() {
    let text = machine(&[], "", &format!("{SPEEDS}\nchart = {{ parameter = \"balancer.ball_mass\", from = 1e-3, to = 1e-2, points = 5 }}"));
    let loaded = load(&text).unwrap();
    for work_limit in [1, 10, 200, 1000] {
        let o = loaded.studies[0].study.run(&loaded.system, &Context { work_limit, ..Context::quiet("t") }).unwrap();
        assert_eq!(o.end, End::WorkLimit, "{work_limit}");
        assert!(all(&o, "no_stable_state").is_empty() && all(&o, "not_balanced").is_empty());
    }
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let refused = |text: &str| {
        let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
        loaded.studies[0].study.run(&loaded.system, &Context::quiet("t")).err().unwrap_or_else(|| panic!("{text}")).to_string()
    };
    let stiffness = ("stiffness = \"2.92e6 N/m\"", "stiffness = { x = 2.92e6, y = 2.9e6 }");
    assert!(refused(&machine(&[stiffness], "", SPEEDS)).contains("stiffness differs in x"));
    let lying = ("speed = \"900 rad/s\"", "speed = \"900 rad/s\"\naxis = \"horizontal\"");
    assert!(refused(&machine(&[lying], "", SPEEDS)).contains("weight of \"disc\" pulls to one side"));
    // a parameter that would make it so
    let one_way = format!("{SPEEDS}\nstabilise = {{ parameter = \"shaft.stiffness.x\", from = 2e6, to = 2.92e6 }}");
    let reported = refused(&machine(&[], "", &one_way));
    assert!(reported.contains("at shaft.stiffness.x = 2000000") && reported.contains("differs in x"), "{reported}");
    let absent = format!("{SPEEDS}\nerrors = [{{ parameter = \"balancer.tlt\", from = 0, to = 0.01 }}]");
    assert!(load(&machine(&[], "", &absent)).err().unwrap().0.iter().any(|d| d.message.contains("balancer.tlt")));
    let without_speed = format!("{SPEEDS}\nerrors = [{{ parameter = \"balancer.tilt\", from = 0, to = 0.01 }}]");
    let d = load(&machine(&[("speed = \"900 rad/s\"", "")], "", &without_speed)).err().unwrap();
    assert!(d.0.iter().any(|d| d.message.contains("errors needs the speed")), "{d:?}");
}

/// Where balls do harm, and how much: below the critical speed both add their moments to the unbalance.
#[test]
fn the_engineer_is_reported_where_balls_do_harm() {
    let o = run(&machine(&[ROUND], "", "speed = { from = 300, to = 1200, points = 10 }"));
    let unbalance = 8.91 * 50e-6;
    let harm = one(&o, "harm");
    assert_eq!(harm.level, Level::Warning);
    // both balls follow the shaft, which lags behind the unbalance the less the slower it turns
    let k = (0..10).find(|&k| words(&o, "states", "kind")[k] == "together" && whole(&o, "states", "growing")[k] == 0).unwrap();
    assert_eq!(column(&o, "states", "speed")[k], 300.0);
    let balls = C64::cis(column(&o, "states", "balancer.ball_1")[k]).scale(2.0 * 0.0036 * 0.1);
    let most = (balls + c(unbalance, 0.0)).abs() / unbalance;
    assert!(most > 2.6 && (harm.value.unwrap() - most).abs() < 1e-9, "{harm:?} {most}");
    assert!((column(&o, "states", "disc radius")[k] - distance(balls, 2.0, 0.0, 300.0)).abs() < 1e-13);
    assert_eq!(evidence(harm, "from"), 300.0);
    // up to the speed where the state with both together loses its stability
    let stable = all(&o, "stable_states");
    assert!(stable.iter().any(|f| f.value == Some(evidence(harm, "to"))), "{stable:?} {harm:?}");
    // between harm and balance there is a gap, which is reported with the same ends
    let gap = one(&o, "no_stable_state");
    let balanced = one(&o, "balanced_stable");
    assert_eq!(gap.value.unwrap(), evidence(balanced, "from"));
    assert_eq!(evidence(gap, "from"), evidence(harm, "to"));
    // at the operating speed all is cancelled
    let left = one(&o, "residual_unbalance");
    assert!(left.value.unwrap() < 1e-12 && (evidence(left, "without the masses") - unbalance).abs() < 1e-15, "{left:?}");
    // light balls have too little
    let o = run(&machine(&[ROUND, ("ball_mass = \"3.6 g\"", "ball_mass = \"1 g\"")], "", SPEEDS));
    assert!((one(&o, "insufficient_capacity").value.unwrap() - 2e-4).abs() < 1e-15);
    let none = one(&o, "not_balanced");
    assert_eq!((evidence(none, "from"), none.value), (300.0, Some(1200.0)));
}

/// What errors cost is what the closed forms say: an eccentric ring leaves its own moment, whatever the balls do.
#[test]
fn errors_of_the_ring_cost_what_the_closed_form_says() {
    let study = format!(
        "{SPEEDS}\nerrors = [{{ parameter = \"balancer.eccentricity\", from = 0, to = 50e-6 }}, {{ parameter = \"balancer.tilt\", from = 0, to = 0.05 }}]"
    );
    let o = run(&machine(&[ROUND], "", &study));
    let (value, left, radius) =
        (column(&o, "errors_1", "value"), column(&o, "errors_1", "unbalance_least"), column(&o, "errors_1", "radius_least"));
    assert_eq!(value.len(), 9);
    for k in 0..9 {
        // the centre of the ring on the axis: the shaft at its eccentricity, held there by |U| W^2 = |k - M W^2 + i c W| s
        let (w, mass) = (900.0, 8.91 + 1.5 + 2.0 * 0.0036);
        assert!((radius[k] - value[k]).abs() < 1e-9 * value[k] + 1e-15, "{k}: {}", radius[k]);
        let want = c(2.92e6 - mass * w * w, 400.0 * w).abs() * value[k] / (w * w);
        assert!((left[k] - want).abs() < 1e-8 * want + 1e-15, "{k}: {} {want}", left[k]);
    }
    let costs = all(&o, "cost");
    assert_eq!(costs.len(), 2);
    assert_eq!(costs[0].value.unwrap(), left[8]);
    // r sin^2 of the tilt reaches 250 um: the balls are locked, and the study says from where on
    assert!(
        costs[1].level == Level::Warning && evidence(costs[1], "first value at which no stable state balances") > 0.0,
        "{:?}",
        costs[1]
    );
}

params! {
    /// Parameters of a [`Slow`].
    pub struct SlowParams in SlowFamily {
        stiffness: scalar, "N/m", Bounds::positive(1e12), required, "stiffness k of the spring behind the dashpot";
        time: scalar, "s", Bounds::positive(1e6), required, "relaxation time T";
    }
}

/// A spring behind a dashpot in fixed axes, written as a nonlinear part: `F = k (x - z)`, `z' = (x - z)/T`.
struct Slow;

impl Part for Slow {
    const KIND: &'static str = "slow";
    const DOC: &'static str = "A spring behind a dashpot.";
    type Family = SlowFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let states = Dof::pair("slow_", DofKind::VectorX, "m", 1e-3);
        Layout { states, ..Layout::point(Link::Between(Attach::on("disc"), Attach::ground())) }
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        for i in 0..2 {
            let away = at.q[i] - at.z[i];
            out.force[i] += p.stiffness * away;
            out.rate[i] += away / p.time;
        }
    }
}

/// The internal states of a nonlinear part turn along: `i W z = (x - z)/T`, so that the part acts as `k i W T/(1 + i W T)`.
#[test]
fn internal_states_turn_with_the_rotor() {
    let (m, e, k, own, time, damping) = (2.0, 1e-4, 8e4, 5e4, 4e-3, 30.0);
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let system = Builder::new("slow")
        .part("disc", Disc::planar(), DiscParams { eccentricity: e, ..DiscParams::new(m) })
        .part("shaft", ShaftLumped::lateral(link()), ShaftLumpedParams { stiffness: [k; 2], ..ShaftLumpedParams::new() })
        .part("air", Damper::fixed(link()), DamperParams { damping: [damping; 2], tilt_damping: 0.0 })
        .part("slow", Slow, SlowParams { stiffness: own, time })
        .build()
        .unwrap();
    let never = AtomicBool::new(false);
    for w in [60.0, 200.0, 700.0] {
        let request = Request { range: (w, 1.001 * w), starts: 3, seeds: vec![w], max_points: 100, work: u64::MAX };
        let mut search = Search::new(&system, &request, &never);
        let found = search.run(|_| true).unwrap();
        let states = found.states(&mut search, w);
        assert_eq!(states.len(), 1);
        let turning = c(0.0, w * time);
        let at = c(m * e * w * w, 0.0) / (c(k - m * w * w, damping * w) + turning.scale(own) / (c(1.0, 0.0) + turning));
        let z = at / (c(1.0, 0.0) + turning);
        let x = &states[0].x;
        for (own, closed) in [(c(x[0], x[1]), at), (c(x[2], x[3]), z)] {
            assert!((own - closed).abs() < 1e-12 * at.abs(), "{w}: {own:?} {closed:?}");
        }
    }
}

/// Five balls on a disc that tilts under their weight: what holds them in place is too small to hold them, and the study says that they balance.
#[test]
fn five_heavy_balls_on_a_tilting_disc_balance() {
    let (m, r, moment): (f64, f64, f64) = (0.03, 0.22, 12.0 * 0.0008);
    let text = |study: &str| {
        format!(
            "[machine]\nname = \"drum\"\nspeed = \"1200 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 12\npolar_inertia = 0.45\n\
             diametral_inertia = 0.35\neccentricity = 0.0008\n[[part]]\nkind = \"shaft_lumped\"\nname = \"springs\"\n\
             between = [\"drum\", \"ground\"]\nstiffness = 9000\ntilt_stiffness = 900\n[[part]]\nkind = \"damper\"\nname = \"struts\"\n\
             between = [\"drum\", \"ground\"]\ndamping = 80\ntilt_damping = 6\n[[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\n\
             on = \"drum\"\nballs = 5\nball_mass = {m}\ntrack_radius = {r}\ndrag = 2e-3\n[[study]]\n{study}\n"
        )
    };
    let o = run(&text("kind = \"stationary\"\nspeed = { from = \"600 rpm\", to = \"1400 rpm\", points = 3 }"));
    let (speed, free, stable) = (column(&o, "continua", "speed"), whole(&o, "continua", "free"), whole(&o, "continua", "stable"));
    let kinds = words(&o, "continua", "kind");
    for w in [600.0, 1000.0, 1400.0].map(|n: f64| n * PI / 30.0) {
        let k = (0..kinds.len()).find(|&k| (speed[k] - w).abs() < 1e-9 && kinds[k] == "reduced" && free[k] == 3);
        assert!(k.is_some_and(|k| stable[k] > 0), "{w}: {kinds:?} {speed:?} {free:?} {stable:?}");
    }
    assert!(!o.findings.iter().any(|f| f.id == "no_stable_state" || f.id == "no_balance"), "{:?}", o.findings);
    // in time: balls put where they cancel the unbalance stay there, all but
    // two balls at right angles cancel each other, one lies opposite the unbalance, and a pair carries what it lacks
    let front = ((moment / (m * r) - 1.0) / 2.0).acos();
    let angles = [PI - front, PI + front, FRAC_PI_2, -FRAC_PI_2, PI].map(|a| format!("{a:.15}"));
    let initial: Vec<String> = angles.iter().enumerate().map(|(i, a)| format!("\"ring.ball_{}\" = {a}", i + 1)).collect();
    let o = run(&text(&format!("kind = \"transient\"\nduration = 10\ninitial = {{ {} }}", initial.join(", "))));
    let left = o.findings.iter().find(|f| f.id == "residual_unbalance").unwrap().value.unwrap();
    assert!(left < 1e-3 * moment, "{left}");
}

/// Balls that touch beside the states that balance are no states of their own: what a stiff contact hides is no rest.
#[test]
fn stiff_contact_hides_no_pull() {
    let ring = [("balls = 2", "balls = 3\nball_radius = 0.0045\ncontact_stiffness = 3e4")];
    let o = run(&machine(&ring, "", SPEEDS));
    let kinds: Vec<&String> = words(&o, "continua", "kind").iter().collect();
    assert!(!kinds.is_empty() && kinds.iter().all(|k| *k == "balanced" || *k == "partly_balanced"), "{kinds:?}");
    assert!(!o.findings.iter().any(|f| f.id == "coexistence"), "{:?}", o.findings);
}
