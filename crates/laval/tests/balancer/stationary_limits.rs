//! Where states that balance begin and end: the study `stationary` against the closed form for two balls on a level ring. They bring the ring centre to the
//! axis, and exist where their moments close a triangle with what that takes,
//!
//! ```text
//! N = |-(k/w^2 - m_r - m_b + i c/w) s_2 - m_r s_1 - m_b s_2|,   |m_1 - m_2| r <= N <= (m_1 + m_2) r
//! ```
//!
//! whatever they weigh. The limits are pitchforks: beyond them the balls stand together (or opposite each other) and the ring centre leaves the axis slowly.

use laval::file::load;
use laval::outcome::{Data, End, Finding, Level, Outcome};
use laval::study::Context;
use laval_num::complex::c;

const EXAMPLE: &str = include_str!("../../../../examples/04-ball-balancer/machine.toml");

/// The example's machine with some words exchanged and a study.
fn run(changes: &[(&str, &str)], study: &str) -> Outcome {
    let mut text = EXAMPLE.split("# Above the critical").next().unwrap().to_string();
    for (old, new) in changes {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    let text = format!("{text}\n[[study]]\nkind = \"stationary\"\n{study}\n");
    let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}\n{text}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("t")).unwrap_or_else(|d| panic!("{d}\n{text}"));
    assert_eq!(o.end, End::Reached);
    o
}

fn column<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [f64] {
    match &o.find_table(table).unwrap_or_else(|| panic!("no table {table}")).column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v,
        _ => panic!("{name} is no number"),
    }
}

fn words<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [String] {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Text(v) => v,
        _ => panic!("{name} is no text"),
    }
}

fn whole<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [i64] {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Int(v) => v,
        _ => panic!("{name} is no whole number"),
    }
}

fn all<'a>(o: &'a Outcome, id: &str) -> Vec<&'a Finding> {
    o.findings.iter().filter(|f| f.id == id).collect()
}

/// What the balls of the example must supply, kg m.
fn needed(w: f64) -> f64 {
    let ring = 2e-6;
    (c(2.92e6 / (w * w) - 8.91 - 1.5, 400.0 / w).scale(-ring) - c(8.91 * 50e-6 + 1.5 * ring, 0.0)).abs()
}

/// Speed at which a moment is just enough.
fn enough(moment: f64) -> f64 {
    let (mut a, mut b) = (500.0, 900.0);
    assert!(needed(a) > moment && needed(b) < moment);
    for _ in 0..100 {
        let middle = 0.5 * (a + b);
        if needed(middle) > moment { a = middle } else { b = middle }
    }
    0.5 * (a + b)
}

/// Equal balls and unequal ones: the least and the largest mass at every speed, to rounding.
#[test]
fn limits_over_the_ball_mass_are_those_of_the_closed_form() {
    let cases = [
        ("", 2.0, f64::INFINITY, "from = \"1.2 g\", to = \"4 g\", points = 6"),
        ("mass_ratios = [1, 1.5]\n", 2.5, 0.5, "from = \"1 g\", to = \"13 g\", points = 7"),
    ];
    for (ratios, sum, difference, range) in cases {
        let balls = format!("balls = 2\n{ratios}");
        let study = format!(
            "speed = {{ from = 620, to = 1000, points = 3 }}\nstarts = 60\nchart = {{ parameter = \"balancer.ball_mass\", {range} }}"
        );
        let o = run(&[("balls = 2\n", &balls)], &study);
        let (speed, mass, edge) =
            (column(&o, "boundary", "speed"), column(&o, "boundary", "balancer.ball_mass"), words(&o, "boundary", "edge"));
        for w in [620.0, 810.0, 1000.0] {
            let mut wanted = vec![needed(w) / (sum * 0.1)];
            wanted.extend(Some(needed(w) / (difference * 0.1)).filter(|m| *m > 0.0 && *m < 0.013));
            let found: Vec<f64> = (0..speed.len()).filter(|&k| speed[k] == w && edge[k] == "limit of existence").map(|k| mass[k]).collect();
            assert_eq!(found.len(), wanted.len(), "{w}: {found:?} {wanted:?}");
            for want in wanted {
                assert!(found.iter().any(|m| (m - want).abs() < 1e-11 * want), "{w}: {found:?} {want}");
            }
        }
    }
}

/// The heaviest balls are not needed where the lightest that exist are stable: the limit of existence is that of stability.
#[test]
fn a_state_that_is_stable_wherever_it_exists_is_made_stable_by_existing() {
    let study = "speed = { from = 890, to = 900, points = 2 }\nseeds = 1\nstabilise = { parameter = \"balancer.ball_mass\", from = \"0.1 g\", to = \"10 g\" }";
    let o = run(&[], study);
    let reported = all(&o, "least")[0];
    let want = needed(900.0) / 0.2;
    assert!(reported.value.is_some_and(|m| (m - want).abs() < 1e-11 * want), "{reported:?} {want}");
    assert!(
        reported.level == Level::Info && reported.sentence().contains("exists and is stable when balancer.ball_mass exceeds"),
        "{reported:?}"
    );
    // and values of the table above it are stable, those below are none
    let (value, growth) = (column(&o, "stabilised", "value"), column(&o, "stabilised", "growth"));
    assert!(value.iter().zip(growth).all(|(m, g)| if *m < want { g.is_nan() } else { *g <= 0.0 }));
    // with damping as parameter: an edge of stability as before, and none where no value helps
    let study = |from: f64, to: f64| {
        format!(
            "speed = {{ from = 890, to = 900, points = 2 }}\nseeds = 1\nstabilise = {{ parameter = \"losses.damping\", from = {from}, to = {to} }}"
        )
    };
    assert!(all(&run(&[], &study(0.01, 400.0)), "least")[0].sentence().contains("becomes stable when losses.damping exceeds"));
    let never = run(&[], &study(0.01, 0.1));
    assert!(
        all(&never, "least")[0].level == Level::Warning && all(&never, "least")[0].sentence().contains("is unstable at all"),
        "{:?}",
        never.findings
    );
    let always = run(&[], &study(10.0, 400.0));
    assert!(all(&always, "least")[0].sentence().contains("is stable at all 61 values"), "{:?}", always.findings);
}

/// Along the speed: one pitchfork, listed once, at the closed form's place and with it in its bracket; ranges begin there.
#[test]
fn a_pitchfork_over_the_speed_is_listed_once_where_it_is() {
    for (ball, change) in [(2.2e-3, "ball_mass = \"2.2 g\""), (2.21e-3, "ball_mass = \"2.21 g\""), (2.19e-3, "ball_mass = \"2.19 g\"")] {
        let o = run(&[("ball_mass = \"3.6 g\"", change)], "speed = { from = 300, to = 1200, points = 10 }");
        let want = enough(2.0 * ball * 0.1);
        let near = |w: f64| (w - want).abs() < 1e-3 * want;
        let listed: Vec<_> = o.special_points.iter().filter(|p| near(p.at)).collect();
        assert_eq!(listed.len(), 1, "{want}: {listed:?}");
        let p = listed[0];
        assert!((p.at - want).abs() < 1e-11 * want && p.bracket.0 <= want && want <= p.bracket.1, "{want}: {p:?}");
        assert!(p.kind == "branch_point" && p.subject.starts_with("branches "), "{p:?}");
        let (branch, speed) = (whole(&o, "changes", "branch"), column(&o, "changes", "speed"));
        let mut own: Vec<i64> = (0..speed.len()).filter(|&k| near(speed[k])).map(|k| branch[k]).collect();
        assert_eq!(own.len(), 2);
        own.dedup();
        assert_eq!(own.len(), 2, "one row for each branch");
        let begins = all(&o, "balanced_stable")[0];
        assert!(begins.evidence.iter().any(|e| e.what == "from" && (e.value - want).abs() < 1e-11 * want), "{begins:?}");
        let none = all(&o, "not_balanced")[0];
        assert!(none.value.is_some_and(|w| (w - want).abs() < 1e-11 * want), "{none:?} {want}");
    }
}

/// A ring tilted by a degree on a rotor without unbalance: what the balls do is given by itself, not as a multiple of rounding.
#[test]
fn nothing_is_a_multiple_of_no_unbalance() {
    let none = [("eccentricity = \"50 um\" ", "eccentricity = 0 "), ("eccentricity = \"2 um\"", "eccentricity = 0\ntilt = \"1 deg\"")];
    let o = run(
        &none,
        "speed = { from = 300, to = 1200, points = 10 }\nerrors = [{ parameter = \"balancer.tilt\", from = \"0.5 deg\", to = \"1 deg\" }]",
    );
    assert!(column(&o, "branches", "without").iter().all(|u| *u == 0.0));
    assert!(o.findings.iter().all(|f| !f.sentence().contains("times")), "{:?}", o.findings);
    let (harm, stable) = (all(&o, "harm"), all(&o, "stable_states"));
    assert!(!harm.is_empty() && harm.len() <= stable.len(), "{} findings of {} ranges", harm.len(), stable.len());
    // two balls of 3.6 g at 100 mm
    assert!(harm.iter().all(|f| f.unit == "kg m" && f.value.is_some_and(|u| u > 1e-9 && u <= 7.2e-4 * (1.0 + 1e-12))), "{harm:?}");
    assert!(all(&o, "residual_unbalance")[0].sentence().contains("nothing is out of balance without"), "{:?}", o.findings);
}

/// The best state at the operating speed may be one of a continuum; here all others leave more.
#[test]
fn the_best_state_may_be_one_of_a_continuum() {
    let o = run(&[("balls = 2", "balls = 3")], "speed = { from = 700, to = 900, points = 3 }");
    let best = all(&o, "residual_unbalance")[0];
    // the ring centre on the axis: U = (k/w^2 - M + i c/w) zeta with zeta = -s_2
    let (w, mass) = (900.0f64, 8.91 + 1.5 + 3.0 * 3.6e-3);
    let want = c(2.92e6 / (w * w) - mass, 400.0 / w).abs() * 2e-6;
    assert!(best.sentence().contains("partly balanced") && best.value.is_some_and(|u| (u - want).abs() < 1e-6 * want), "{best:?} {want}");
}

/// Three equal balls keep the ring centre on the axis in a continuum of ways, which shrinks to one state where their moments just suffice: all balls stand together there.
#[test]
fn a_continuum_ends_where_the_closed_form_has_it() {
    for (balls, mass) in [(3, 1.47e-3), (3, 1.472e-3), (4, 1.1e-3), (5, 0.881e-3)] {
        let changes = [("balls = 2", &*format!("balls = {balls}")), ("ball_mass = \"3.6 g\"", &*format!("ball_mass = {mass}"))];
        let o = run(&changes, "speed = { from = 300, to = 1200, points = 10 }");
        let want = enough(f64::from(balls) * mass * 0.1);
        let begins = all(&o, "continuum");
        assert_eq!(begins.len(), 1, "{begins:?}");
        let from = begins[0].evidence.iter().find(|e| e.what == "from").unwrap().value;
        // several roots vanish there together, each known to its rounding only
        assert!((from - want).abs() < 1e-6 * want, "{balls} balls of {mass} kg: {from} {want}");
    }
}

/// Balls whose moments are less than the unbalance are too light, beyond rounding; a machine without balls
/// has none that could be too light or do harm; only there `no_masses` is reported.
#[test]
fn the_capacity_is_that_of_balls() {
    let level = ("eccentricity = \"2 um\"", "eccentricity = 0");
    for (share, short) in [(1.0 - 1e-7, true), (1.0 - 1e-10, false), (1.5, false)] {
        let mass = format!("ball_mass = {:e}", share * 8.91 * 50e-6 / (2.0 * 0.1));
        let o = run(&[level, ("ball_mass = \"3.6 g\"", &mass)], "speed = { from = 890, to = 900, points = 2 }\nseeds = 1\nstarts = 20");
        assert_eq!(
            (all(&o, "insufficient_capacity").is_empty(), all(&o, "no_masses").is_empty()),
            (!short, true),
            "{share}: {:?}",
            o.findings
        );
    }
    let text = "[machine]\nspeed = 900\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 8.91\neccentricity = 50e-6\n\
                [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 2.92e6\n\
                [[part]]\nkind = \"damper\"\nbetween = [\"disc\", \"ground\"]\ndamping = 400\n\
                [[study]]\nkind = \"stationary\"\nspeed = { from = 300, to = 900, points = 3 }\n";
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("t")).unwrap();
    assert_eq!(all(&o, "no_masses").len(), 1);
    for id in ["insufficient_capacity", "not_balanced", "harm", "coexistence", "no_stable_state"] {
        assert!(all(&o, id).is_empty(), "{id}: {:?}", o.findings);
    }
}

/// Below the critical speed balls together add their moments to the unbalance: harm is reported from a
/// thousandth of it on.
#[test]
fn harm_is_reported_from_a_thousandth_on() {
    for (added, harm) in [(5e-3, true), (5e-4, false)] {
        let mass = format!("ball_mass = {:e}", added * 8.91 * 50e-6 / (2.0 * 0.1));
        let changes = [("eccentricity = \"2 um\"", "eccentricity = 0"), ("ball_mass = \"3.6 g\"", mass.as_str())];
        let o = run(&changes, "speed = { from = 290, to = 300, points = 2 }\nseeds = 1\nstarts = 20");
        let (left, without) = (column(&o, "states", "unbalance"), column(&o, "states", "without"));
        let stable = (0..left.len()).filter(|&k| whole(&o, "states", "growing")[k] == 0).map(|k| left[k] / without[k]);
        let most = stable.fold(0.0, f64::max);
        assert!((most - 1.0) / added > 0.9 && (most - 1.0) / added <= 1.0 + 1e-9, "{added}: {most}");
        let reported: Vec<f64> = all(&o, "harm").iter().filter_map(|f| f.value).collect();
        assert_eq!(reported.len(), usize::from(harm), "{:?}", o.findings);
        assert!(reported.iter().all(|v| (v - most).abs() < 1e-9), "{reported:?} {most}");
    }
}
