//! Balancer and motor from machine files through the studies in time: findings, captured drives, friction and contact, what is refused.

use crate::common;

use common::{number, rows};
use laval::file::load;
use laval::laval_num::univariate::root;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::{At, Link, Rows};
use laval::model::system::{System, Workspace};
use laval::outcome::{Data, End, Level, Outcome};
use laval::parts::{balancer_ball::*, damper::*, disc::*, shaft_lumped::*};
use laval::solve::co_rotating::turning;
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::Programme;
use laval::study::Context;
use laval_num::complex::C64;
use laval_num::ode::{Control, Dop853, Ode, integrate};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const EXAMPLE: &str = include_str!("../../../../examples/04-ball-balancer/machine.toml");

fn run(text: &str, study: usize) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    let outcome = loaded.studies[study].study.run(&loaded.system, &Context::quiet("t")).unwrap_or_else(|d| panic!("{d}"));
    assert_eq!(outcome.end, End::Reached);
    outcome
}

fn wrong(text: &str) -> String {
    load(text).err().map(|d| d.0.iter().map(|d| format!("{d}\n")).collect()).unwrap_or_default()
}

fn has(o: &Outcome, id: &str) -> bool {
    o.findings.iter().any(|f| f.id == id)
}

fn value(o: &Outcome, id: &str) -> f64 {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no finding {id} in {:?}", o.findings)).value.unwrap()
}

fn evidence(o: &Outcome, id: &str, what: &str) -> f64 {
    let found = o.findings.iter().find(|f| f.id == id).unwrap();
    found.evidence.iter().find(|e| e.what == what).unwrap_or_else(|| panic!("no {what} in {found:?}")).value
}

fn column<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [f64] {
    match &o.find_table(table).unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v,
        _ => panic!("{name} is no number"),
    }
}

/// Balls that make the unbalance larger, or are still on their way, or go round: no time to balance.
#[test]
fn a_time_to_balance_needs_balls_that_balance() {
    let machine = |duration: &str, drag: f64, initial: &str| {
        format!(
            "[machine]\nspeed = \"900 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = \"8.91 kg\"\neccentricity = \"5e-05 m\"\n\
             [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = \"2920000.0 N/m\"\n\
             [[part]]\nkind = \"damper\"\nbetween = [\"disc\", \"ground\"]\ndamping = \"400.0 N s/m\"\n\
             [[part]]\nkind = \"balancer_ball\"\nname = \"b\"\non = \"disc\"\nballs = 2\nball_mass = \"3.6 g\"\ntrack_radius = \"100 mm\"\n\
             drag = \"{drag} N m s\"\nbody_tilt = false\n\
             [[study]]\nkind = \"transient\"\nduration = \"{duration}\"\nobservables = false\n[study.initial]\n{initial}"
        )
    };
    let together = "\"b.ball_1\" = \"20 deg\"\n\"b.ball_2\" = \"60 deg\"\n";
    let slow = run(&machine("3 s", 0.5, together), 0);
    assert!(has(&slow, "balance_unsettled") && !has(&slow, "time_to_balance"), "{:?}", slow.findings);
    let slipping = run(&machine("250 ms", 1e-5, "\"b.ball_1'\" = -400\n\"b.ball_2'\" = -500\n"), 0);
    assert!(
        has(&slipping, "masses_caught") && has(&slipping, "balance_unsettled") && !has(&slipping, "time_to_balance"),
        "{:?}",
        slipping.findings
    );
    // with less drag the same balls from the same start are there in time
    let there = run(&machine("3 s", 0.005, together), 0);
    assert!(has(&there, "time_to_balance") && !has(&there, "balance_unsettled"), "{:?}", there.findings);
    assert!(value(&there, "residual_unbalance") < 0.1 * evidence(&there, "residual_unbalance", "without the balls"));
    let since = value(&there, "time_to_balance");
    let (t, unbalance) = (column(&there, "balance", "t"), column(&there, "balance", "unbalance"));
    let (last, without) = (unbalance[unbalance.len() - 1], column(&there, "balance", "without")[0]);
    let late = t.iter().zip(unbalance).filter(|(t, _)| **t >= since);
    assert!(late.clone().count() > 100 && late.map(|(_, u)| (u - last).abs()).all(|d| d <= 0.05 * without));
}

/// The balls bring the centre of the ring to the axis: what remains is closed form.
#[test]
fn the_example_balances_to_the_eccentricity_of_its_ring() {
    let (nu, k, s1, s2) = (900.0, 2.92e6, 50e-6, 2e-6);
    let mass = 8.91 + 1.5 + 2.0 * 0.0036;
    let (without, expected) = (8.91 * s1 + (mass - 8.91) * s2, C64 { re: k / nu / nu - mass, im: 400.0 / nu }.abs() * s2);
    for (study, closes) in [(0, 1e-9), (1, 1e-9)] {
        let o = run(EXAMPLE, study);
        assert!((value(&o, "residual_unbalance") - expected).abs() < 1e-6 * without, "{} {expected}", value(&o, "residual_unbalance"));
        assert!((evidence(&o, "residual_unbalance", "without the balls") - without).abs() < 1e-12 * without);
        let grade = evidence(&o, "residual_unbalance", "grade number (ISO 21940-11)");
        assert!((grade - nu * expected / mass).abs() < 1e-5 * grade.max(1e-3), "{grade}");
        assert!(value(&o, "energy_balance") < closes, "{}", value(&o, "energy_balance"));
        assert!(!has(&o, "insufficient_capacity") && !has(&o, "purpose") && has(&o, "time_to_balance"), "{:?}", o.findings);
        // the shaft centre stays at the eccentricity of the ring, the ring centre on the axis
        let last = |name: &str| *column(&o, "motion", name).last().unwrap();
        assert!((last("disc.x").hypot(last("disc.y")) - s2).abs() < 1e-9);
        if study == 0 {
            assert!(*column(&o, "observed", "balancer.ring centre").last().unwrap() < 1e-9);
            assert!((column(&o, "observed", "disc.centre of mass").last().unwrap() - (s1 - s2)).abs() < 1e-8);
            let wrapped = *column(&o, "observed", "balancer.ball 1 angle, wrapped").last().unwrap();
            assert!(wrapped.abs() <= PI && ((last("balancer.ball_1") - wrapped) / TAU).fract().abs() < 1e-9);
        }
    }
}

#[test]
fn what_keeps_it_from_balancing_is_reported() {
    let light = EXAMPLE.replace("\"3.6 g\"", "\"1 g\"");
    let o = run(&light, 0);
    assert!(value(&o, "insufficient_capacity") == 2e-4 && evidence(&o, "insufficient_capacity", "needed") > 4e-4);
    assert!(value(&o, "residual_unbalance") > 2e-4);
    let tilted = EXAMPLE.replace("body_tilt = false", "body_tilt = false\ntilt = \"9 deg\"");
    let warned: Vec<String> = load(&tilted).unwrap().warnings.0.into_iter().map(|d| d.message.to_string()).collect();
    assert!(warned.len() == 1 && warned[0].contains("locks the balls to the node line"), "{warned:?}");
    assert_eq!(load(EXAMPLE).unwrap().warnings.0, []);
    let free = EXAMPLE.replace("body_tilt = false", "rings = \"free\"\ndiametral_inertia = 0.01\npolar_inertia = 0.02\ntilt_stiffness = 5");
    assert_eq!(load(&free).unwrap().warnings.0, []);
    let o = run(&tilted, 0);
    let text = o.findings.iter().find(|f| f.id == "purpose").unwrap().sentence();
    assert!(text.contains("\"balancer\": the tilt of the tracks locks the balls to the node line"), "{text}");
    assert!(value(&o, "residual_unbalance") > 4e-4);
}

/// A disc with two balls on its heavy side, whose moments are this share of its unbalance, after a
/// microsecond.
fn on_the_heavy_side(moments: f64) -> (f64, Outcome) {
    let unbalance: f64 = 8.91 * 50e-6;
    let text = format!(
        "[machine]\nspeed = \"900 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 8.91\neccentricity = 50e-6\n\
         [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 2.92e6\n\
         [[part]]\nkind = \"balancer_ball\"\nname = \"b\"\non = \"disc\"\nballs = 2\nball_mass = {:e}\ntrack_radius = 0.1\nbody_tilt = false\n\
         drag = 1e-3\n[[study]]\nkind = \"transient\"\nduration = \"1 us\"\npoints = 3\n",
        moments * unbalance / (2.0 * 0.1)
    );
    (unbalance, run(&text, 0))
}

/// Balls that add their moments to the unbalance do harm, beyond rounding.
#[test]
fn harm_is_reported_beyond_rounding() {
    for (moments, harm) in [(1e-7, true), (1e-10, false)] {
        let (unbalance, o) = on_the_heavy_side(moments);
        let left = o.findings.iter().find(|f| f.id == "residual_unbalance").unwrap();
        assert!((left.value.unwrap() / unbalance - 1.0 - moments).abs() < 1e-2 * moments, "{left:?}");
        assert_eq!((left.level == Level::Warning, left.message.key == "balance-increased"), (harm, harm), "{left:?}");
    }
}

/// Balls whose moments are less than the unbalance are too light, beyond rounding.
#[test]
fn too_little_capacity_is_reported_beyond_rounding() {
    for (moments, short) in [(1.0 - 1e-7, true), (1.0 - 1e-10, false), (1.5, false)] {
        assert_eq!(has(&on_the_heavy_side(moments).1, "insufficient_capacity"), short, "{moments}");
    }
}

#[test]
fn bad_machines_are_reported() {
    for (from, to, what) in [
        ("balls = 2", "balls = 0", "balls"),
        ("balls = 2", "mass_ratios = [1, 2, 3]", "3 mass ratios are given for 2 balls"),
        ("balls = 2", "tracks = { balls = [2, 1.5] }", "a track has 1.5 balls"),
        // balls on several tracks are counted on the tracks; a number beside them is their sum
        ("balls = 2", "balls = 2\ntracks = { balls = [3, 2] }", "balls = 2, and the tracks have 3 + 2 = 5"),
        ("balls = 2", "balls = 5\ntracks = { balls = [3, 2] }", ""),
        ("balls = 2", "mass_ratios = [1, 2]\ntracks = { balls = [3, 2] }", "2 mass ratios are given for 5 balls on 2 tracks"),
        ("balls = 2", "rings = \"free\"", "free ring needs inertia"),
        ("balls = 2", "contact_stiffness = 1e3", "give ball_radius"),
        ("balls = 2", "polar_inertia = 1", "no ring has a polar inertia"),
        ("eccentricity = \"2 um\"", "eccentricity = \"120 mm\"", "lies outside the track"),
        ("body_tilt = false", "tilt = 0.1", ""),
    ] {
        let reported = wrong(&EXAMPLE.replace(from, to));
        assert!(reported.contains(what) && reported.is_empty() == what.is_empty(), "{to}: {reported}");
    }
    // weight across a horizontal axis acts on the balls through the port; along it there is none
    let level = EXAMPLE.replace("[machine]", "[machine]\naxis = \"horizontal\"");
    assert_eq!(wrong(&level), "");
    let inclined = level.replace("body_tilt = false", "tilt = 0.01");
    assert!(wrong(&inclined).contains("give gravity = 0"), "{}", wrong(&inclined));
    assert_eq!(wrong(&inclined.replace("tilt = 0.01", "tilt = 0.01\ngravity = 0")), "");
    let driven = |keys: &str| EXAMPLE.replace("[[study]]", &format!("[[part]]\nkind = \"motor\"\n{keys}\n[[study]]"));
    for (keys, what) in [
        ("torque = 3\ncurve = \"linear\"", "needs synchronous_speed"),
        ("torque = 3\ncurve = \"table\"", "needs a table"),
        ("torque = 3\npower = 5\ntable = { speed = [0, 1], share = [1, 0] }", "a table is given beside"),
        ("torque = 3\ncurve = \"table\"\ntable = { speed = [1, 0], share = [1, 0] }", "row"),
    ] {
        let reported = wrong(&driven(keys));
        assert!(reported.contains(what), "{keys}: {reported}");
    }
    let free = load(&driven("torque = 3").replace("[machine]", "[machine]\ndrive = \"free\"")).unwrap();
    let refused = free.refusals();
    assert!(refused.iter().any(|r| r.diagnostic.to_string().contains("free and cannot follow a programme")), "{}", refused.len());
}

/// Housing and disc of the source as one unbalanced disc, with a motor.
fn driven(torque: f64, duration: f64) -> String {
    let unbalance = (C64 { re: 8.91, im: 0.0 } + C64::cis(PI / 40.0).scale(1.5)).abs() * 50e-6;
    format!(
        "[machine]\nspeed = 0\ndrive = \"free\"\n[[part]]\nkind = \"disc\"\nmass = 10.41\nunbalance = {unbalance:e}\npolar_inertia = 0.05\n\
         [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 2922676.0\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"disc\", \"ground\"]\ndamping = 50\n\
         [[part]]\nkind = \"motor\"\ncurve = \"linear\"\ntorque = {torque:e}\nsynchronous_speed = 800\ndrag = 1e-3\n\
         [[study]]\nkind = \"transient\"\nduration = {duration}\npoints = 400\nobservables = false\nrelative_tolerance = 1e-9\n"
    )
}

/// Torque left over at a steady speed, from the state that turns with the rotor.
fn surplus(system: &System, speed: f64) -> f64 {
    let steady = turning(system, speed, None).unwrap();
    let n = system.n();
    let mut v = steady.q.clone();
    system.turn(&mut v, FRAC_PI_2);
    v.iter_mut().for_each(|v| *v *= speed);
    let a: Vec<f64> = steady.q.iter().map(|q| -q * speed * speed).collect();
    let (mut force, mut spin) = (vec![0.0; n], 0.0);
    let at = At { q: &steady.q, v: &v, a: &a, z: &[], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let mut rows = Rows { force: &mut force, rate: &mut [], spin: &mut spin };
    system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |_| true);
    -spin
}

/// Every balance of torques of the table, and the three where the speed stays behind are found as captures.
#[test]
fn limited_power_is_caught_at_the_resonance() {
    for row in rows(include_str!("../reference/balancer/motor_limited_power.csv")) {
        if row[0] != "no balls" {
            continue;
        }
        let torque = number(row[1]);
        let loaded = load(&driven(torque, 40.0)).unwrap();
        let steady: Vec<(f64, bool)> =
            row[3].split(';').map(|s| s.trim().split_once(' ').map(|(w, kind)| (number(w), kind == "stable")).unwrap()).collect();
        for &(w, stable) in &steady {
            let at = |w: f64| surplus(&loaded.system, w);
            let (a, b) = (w - 0.3, w + 0.3);
            let found = root(|w| Some(at(w)), (a, at(a)), (b, at(b)), 1e-12 * w).unwrap();
            assert!((found - w).abs() < 1e-9 * w, "{torque}: {found} {w}");
            assert_eq!(at(a) > 0.0 && at(b) < 0.0, stable, "{torque} at {w}");
        }
        if torque == 3.0 || torque == 4.0 {
            let o = run(&driven(torque, if torque == 3.0 { 40.0 } else { 80.0 }), 0);
            let caught = torque == 3.0;
            let speed = value(&o, "end_speed");
            assert!((speed - steady[0].0).abs() < if caught { 1e-3 } else { 0.1 }, "{torque}: {speed}");
            assert_eq!((has(&o, "capture"), o.special_points.len()), (caught, usize::from(caught)), "{:?}", o.findings);
            if caught {
                assert!((value(&o, "capture") - steady[0].0).abs() < 1e-2);
                // without vibration L = c w at 3/(3/800 + 1e-3)
                assert!((evidence(&o, "capture", "speed without vibration") - 3.0 / (3.0 / 800.0 + 1e-3)).abs() < 1e-6);
                assert!(o.special_points[0].kind == "capture" && o.special_points[0].at < 30.0);
            }
            assert!(value(&o, "energy_balance") < 1e-9);
        }
    }
}

/// A programme that asks the motor for more than it has at the resonance, and one slow enough for it.
#[test]
fn a_motor_that_cannot_follow_is_reported() {
    let programme = |torque: f64, polynomial: &str| {
        let file = driven(torque, 1.0).replace("drive = \"free\"\n", "");
        let (machine, _) = file.split_once("[[study]]").unwrap();
        run(&format!("{machine}[[study]]\nkind = \"run_up\"\nduration = 10\n{polynomial}\n"), 0)
    };
    // J W' = 0.05 * 60 = 3 N m and drag beside it
    let o = programme(3.2, "polynomial = [0, 60]");
    let (lack, first) = (value(&o, "drive_short"), evidence(&o, "drive_short", "first at speed"));
    // 3 + 1e-3 w = 3.2 (1 - w/800) at 40 rad/s
    assert!((first - 40.0).abs() < 8.0 && lack > 2.0, "{lack} {first}");
    let o = programme(40.0, "polynomial = [0, 20, 4]");
    assert!(value(&o, "drive_suffices") > 0.0 && !has(&o, "drive_short"));
    let last = |name: &str| *column(&o, "drive", name).last().unwrap();
    assert!((last("speed") - 600.0).abs() < 1e-9);
}

/// A heavy disc that stands still and a ring on it.
fn bench(balancer: BallBalancer, ring: BalancerBallParams) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    Builder::new("bench")
        .part("disc", Disc::planar(), DiscParams { polar_inertia: 1e7, ..DiscParams::new(1e7) })
        .part("shaft", ShaftLumped::lateral(link()), ShaftLumpedParams { stiffness: [1e9; 2], ..ShaftLumpedParams::new() })
        .part("air", Damper::fixed(link()), DamperParams { damping: [1e3; 2], tilt_damping: 0.0 })
        .part("balancer", balancer, ring)
        .build()
        .unwrap()
}

fn ring() -> BalancerBallParams {
    BalancerBallParams { gravity: 9.81, ..BalancerBallParams::new(0.01, 0.1) }
}

/// The motion on the bench at standstill after some time.
fn after(system: &System, start: &[f64], time: f64) -> Vec<f64> {
    let mut motion = Motion::new(system, SpinLaw::Programme(Programme::constant(0.0, 0.0))).unwrap();
    let mut y = vec![0.0; motion.dim()];
    let n = system.n();
    for (i, x) in start.iter().enumerate() {
        y[if i < n - 2 { i + 2 } else { i + 4 }] = *x;
    }
    integrate(&mut Dop853::new(), &mut motion, 0.0, &mut y, time, &Control::new(1e-11, 1e-13), &mut ());
    y
}

/// A ball rolls about the lowest point of a tilted track like a pendulum with its rolling inertia.
#[test]
fn a_rolling_ball_swings() {
    let p = BalancerBallParams { tilt: 0.3, rolling_inertia: 0.4, ..ring() };
    let system = bench(BallBalancer::new(Attach::on("disc"), 1).planar(), p);
    let w = (9.81 * 0.3f64.sin() / (0.1 * 1.4)).sqrt();
    let y = after(&system, &[1e-4 - FRAC_PI_2, 0.0], 2.25 * TAU / w);
    // after a quarter turn more than two swings it passes the lowest point backwards
    assert!((y[2] + FRAC_PI_2).abs() < 1e-9 && (y[5] + 1e-4 * w).abs() < 1e-9, "{y:?}");
}

/// Dry friction holds a ball where the track pulls less than its torque, and only there.
#[test]
fn dry_friction_has_a_dead_zone() {
    let pull = 0.01 * 9.81 * 0.1 * 0.3f64.sin();
    for (share, stays) in [(1.2, true), (0.8, false)] {
        let p = BalancerBallParams { tilt: 0.3, dry_torque: share * pull, friction_rate: 1e-3, ..ring() };
        let y = after(&bench(BallBalancer::new(Attach::on("disc"), 1).planar(), p), &[0.0, 0.0], 2.0);
        if stays {
            // creep: share of the friction s/sqrt(1 + s^2) = 1/1.2
            let rate = 1e-3 / (1.2f64 * 1.2 - 1.0).sqrt();
            assert!((y[5] + rate).abs() < 1e-3 * rate && (y[2] + 2.0 * rate).abs() < 1e-2 * rate, "{y:?}");
        } else {
            assert!(y[2] < -0.2, "{y:?}");
        }
    }
    // rolling resistance bears on a ball in proportion to its centrifugal load
    let p = BalancerBallParams { rolling_resistance: 0.01, ..ring() };
    let y = after(&bench(BallBalancer::new(Attach::on("disc"), 1).planar(), p), &[0.0, 5.0], 3.0);
    // phi'' = -f phi'^2
    assert!((y[5] - 5.0 / (1.0 + 0.01 * 5.0 * 3.0)).abs() < 1e-6, "{y:?}");
    // on a rotor that turns the load is that of both together: phi'' = -f (W + phi')^2 while the ball runs ahead
    let system = bench(BallBalancer::new(Attach::on("disc"), 1).planar(), BalancerBallParams { gravity: 0.0, friction_rate: 1e-6, ..p });
    let mut motion = Motion::new(&system, SpinLaw::Programme(Programme::constant(10.0, 0.0))).unwrap();
    let mut y = vec![0.0; motion.dim()];
    y[5] = 5.0;
    integrate(&mut Dop853::new(), &mut motion, 0.0, &mut y, 2.0, &Control::new(1e-11, 1e-13), &mut ());
    assert!((y[5] - (15.0 / (1.0 + 0.01 * 15.0 * 2.0) - 10.0)).abs() < 1e-6, "{y:?}");
}

/// Equal balls exchange their rates; damping leaves the share 1 - 2/3 chi v to first order.
#[test]
fn balls_push_each_other() {
    let hit = |chi: f64, masses: &[f64]| {
        let p = BalancerBallParams { ball_radius: 0.01, contact_stiffness: 50.0, contact_damping: chi, gravity: 0.0, ..ring() };
        let system = bench(BallBalancer::new(Attach::on("disc"), 2).masses(masses).planar().touching(), p);
        let y = after(&system, &[0.0, 1.0, 2.0, 0.0], 0.8);
        (y[6], y[7])
    };
    let (a, b) = hit(0.0, &[1.0, 1.0]);
    assert!(a.abs() < 1e-7 && (b - 2.0).abs() < 1e-7, "{a} {b}");
    let (a, b) = hit(0.0, &[1.0, 3.0]);
    assert!((a + 1.0).abs() < 1e-7 && (b - 1.0).abs() < 1e-7, "{a} {b}");
    let loss = |chi: f64| 1.0 - (hit(chi, &[1.0, 1.0]).1 - hit(chi, &[1.0, 1.0]).0) / 2.0;
    let (small, large) = (loss(0.01), loss(0.02));
    assert!((small - 2.0 / 3.0 * 0.02).abs() < 2e-4 && (large / small - 2.0).abs() < 0.06, "{small} {large}");
}

/// With friction and contact the energy balance closes to a millionth.
#[test]
fn friction_and_contact_keep_account() {
    let rough = EXAMPLE
        .replace("body_tilt = false", "body_tilt = false\ndry_torque = \"2e-4 N m\"\nrolling_resistance = 1e-4\nball_radius = \"8 mm\"\ncontact_stiffness = 20\ncontact_damping = 0.01")
        .replace("duration = \"3 s\"", "duration = \"0.4 s\"")
        .replace("\"60 deg\" }", "\"60 deg\", \"balancer.ball_2'\" = \"-60 rad/s\" }");
    let o = run(&rough, 0);
    assert!(value(&o, "contacts") >= 2.0, "{:?}", o.findings);
    assert!(value(&o, "energy_balance") < 1e-6, "{}", value(&o, "energy_balance"));
}

/// Touching balls of which nothing is said begin side by side, and what is said of one goes before.
#[test]
fn balls_that_touch_begin_side_by_side() {
    let touching =
        EXAMPLE.replace("balls = 2", "tracks = { balls = [3, 2], radius = [1, 0.8] }\ncontact_stiffness = 20\nball_radius = \"8 mm\"");
    let touching = touching.replace("duration = \"3 s\"", "duration = \"0.02 s\"");
    let from = touching.find("initial = {").expect("the example says where its balls begin");
    let to = from + touching[from..].find('\n').unwrap();
    let said = format!("{}initial = {{ \"balancer.ball_2\" = 1.5 }}{}", &touching[..from], &touching[to..]);
    let silent = format!("{}{}", &touching[..from], &touching[to..]);
    let radius = 0.1f64;
    let apart = |r: f64| 2.0 * (8e-3 / r).asin();
    let want = [0.0, apart(radius), 2.0 * apart(radius), 0.0, apart(0.8 * radius)];
    for (text, second) in [(&silent, want[1]), (&said, 1.5)] {
        let o = run(text, 0);
        for (k, want) in [want[0], second, want[2], want[3], want[4]].into_iter().enumerate() {
            let angle = column(&o, "motion", &format!("balancer.ball_{}", k + 1))[0];
            assert!((angle - want).abs() < 1e-12, "{k}: {angle} {want}");
        }
        assert!(value(&o, "energy_balance") < 1e-6);
    }
    let o = run(&silent, 0);
    assert!(value(&o, "validity") < 1e-6);
    // all on one side they do harm, and that is said
    let left = o.findings.iter().find(|f| f.id == "residual_unbalance").unwrap();
    assert!(left.value.unwrap() > evidence(&o, "residual_unbalance", "without the balls"));
    assert!(left.message.key == "balance-increased" && left.sentence().contains("increase the unbalance"), "{}", left.sentence());
    let o = run(EXAMPLE, 0);
    let left = o.findings.iter().find(|f| f.id == "residual_unbalance").unwrap();
    assert!(left.message.key == "balance-residual", "{}", left.sentence());
}

/// Balls that go round in the rotor make its envelope swing; that, and what happens while the speed is held, is no passage through a resonance.
#[test]
fn what_balls_do_is_no_resonance() {
    let machine = |ball: f64| {
        format!(
            "[machine]\nname = \"planar\"\nspeed = 3\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 1\neccentricity = 0.01\n\
             [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1\n\
             [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 0.1\n\
             [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"disc\"\nballs = 2\nbody_tilt = false\ngravity = 0\nball_mass = {ball}\n\
             track_radius = 1\ndrag = 1e-4\n[[study]]\nkind = \"run_up\"\nduration = 300\nhold = 300\nfrom = 0.1\nto = 3\n\
             initial = {{ \"ring.ball_2\" = 1 }}\n"
        )
    };
    let slipping = run(&machine(0.05), 0);
    assert!(has(&slipping, "masses_caught") && has(&slipping, "swings"), "{:?}", slipping.findings);
    // they stay behind, where the disc swings widely
    let rate = value(&slipping, "masses_caught");
    assert!(rate > 0.3 && rate < 1.2 && (evidence(&slipping, "masses_caught", "mean slip") - (rate - 3.0)).abs() < 0.02, "{rate}");
    let peaks: Vec<f64> = slipping.findings.iter().filter(|f| f.id == "peak").map(|f| f.value.unwrap()).collect();
    assert!(peaks.len() <= 1 && peaks.iter().all(|w| *w < 1.5), "{peaks:?}");
    // with balls that weigh nothing to speak of the critical speed is passed and reported
    let plain = run(&machine(1e-9), 0);
    let peaks: Vec<f64> = plain.findings.iter().filter(|f| f.id == "peak").map(|f| f.value.unwrap()).collect();
    assert!(peaks.len() == 1 && (0.95..1.2).contains(&peaks[0]) && !has(&plain, "swings"), "{:?}", plain.findings);
}

/// The absolute tolerance that is not given follows the relative one: the energy is accounted for as sharply as it was requested.
#[test]
fn a_sharper_tolerance_keeps_a_sharper_account() {
    let sharp = EXAMPLE.replace("duration = \"3 s\"", "duration = \"0.5 s\"").replacen(
        "relative_tolerance = 1e-10",
        "relative_tolerance = 1e-12",
        1,
    );
    let open = sharp.replacen("absolute_tolerance = 1e-11\n", "", 1);
    let blunt = sharp.replacen("absolute_tolerance = 1e-11", "absolute_tolerance = 1e-9", 1);
    assert!(open != sharp && blunt != sharp);
    let (open, blunt) = (value(&run(&open, 0), "energy_balance"), value(&run(&blunt, 0), "energy_balance"));
    assert!(open < 0.2 * blunt && open < 1e-10, "{open} {blunt}");
}
