//! Machines of many coordinates as machines of few: statics, modes, motions and exponents against the whole machine.

use crate::common::files::{findings, load, run_all};
use laval::model::system::System;
use laval::solve::harmonic::branches::response::{Request, Response, respond};
use laval::solve::pencil::Linearised;
use laval::solve::reduced_machine::ReducedMachine;
use laval::solve::rest::rest;
use laval::study::{Cancel, Context};
use laval_num::complex::C64;
use laval_num::work::watched;
use std::sync::atomic::AtomicBool;

/// A lying rotor with two discs; cubic bearings of different stiffness in x and y, dampers beside them, a linear seal with cross-coupling.
fn machine(elements: usize) -> String {
    let bearing = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\nlaw = \"per_axis\"\n\
             stiffness = {{ x = 4e6, y = 6e6 }}\ncubic_stiffness = 4e14\n\
             [[part]]\nkind = \"damper\"\nname = \"{name} damping\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\ndamping = 900.0\n"
        )
    };
    let disc = |name: &str, at: f64, unbalance: f64| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\non = {{ body = \"shaft\", at = {at} }}\nmass = 14.0\npolar_inertia = 0.12\ndiametral_inertia = 0.07\nunbalance = {unbalance:?}\n"
        )
    };
    format!(
        "[machine]\nname = \"rotor\"\nspeed = 300.0\naxis = \"horizontal\"\n\
         [[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\nstiffness_damping = 2e-6\n\
         section = {{ length = [0.2, 0.3, 0.2], outer_diameter = [0.04, 0.05, 0.04] }}\n{}{}{}{}\
         [[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [{{ body = \"shaft\", at = 0.35 }}, \"ground\"]\nkxx = 2e5\nkyy = 2e5\nkxy = 6e4\nkyx = -6e4\n",
        disc("left", 0.2, 4e-4),
        disc("right", 0.5, 2e-4),
        bearing("lower", 0.0),
        bearing("upper", 0.7),
    )
}

fn modes(system: &System, speed: f64, limit: f64) -> Vec<C64> {
    let all = Linearised::new(system, &rest(system, speed).unwrap()).unwrap().spectrum().unwrap().modes;
    let mut out: Vec<C64> = all.iter().map(|m| m.value).filter(|s| s.im > 0.0 && s.im < limit).collect();
    out.sort_by(|a, b| a.im.total_cmp(&b.im));
    out
}

/// Sag under weight, modes up to the frequency, and coordinates there and back.
#[test]
fn statics_and_modes() {
    let whole = load(&machine(8)).system;
    let own = ReducedMachine::of(&whole, 300.0).unwrap();
    assert!(own.system.n() <= whole.n() / 2 && own.reduced.error < 1e-4 && own.reduced.frequency == 2400.0, "{:?}", own.reduced);
    let (sag, lifted) = (rest(&whole, 300.0).unwrap().q, own.system.projection().unwrap().all(&rest(&own.system, 300.0).unwrap().q));
    let size = sag.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let far = |list: &[f64]| list.iter().zip(&sag).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // exact at the ports, the bearings; between them what the modes hold
    for (a, b) in whole.stations().iter().zip(own.system.stations()).filter(|(a, _)| a.flexible && a.position != 0.35) {
        let ([x, y], [u, v]) = (a.lateral.of(&sag), b.lateral.of(&rest(&own.system, 300.0).unwrap().q));
        assert!((x - u).hypot(y - v) < 1e-7 * size, "{}", a.name);
    }
    assert!(far(&lifted) < 1e-4 * size, "{:e}", far(&lifted) / size);
    for speed in [0.0, 150.0, 300.0] {
        let (a, b) = (modes(&whole, speed, 2300.0), modes(&own.system, speed, 2300.0));
        assert!(a.len() >= 4 && a.len() == b.len(), "{a:?} {b:?}");
        for (x, y) in a.iter().zip(&b) {
            assert!((*x - *y).abs() < 1e-4 * x.abs(), "{speed}: {x:?} {y:?}");
        }
    }
    // what moves as the reduced machine can comes back as it was
    let x: Vec<f64> = (0..own.system.n()).map(|i| (1.3 * i as f64).cos() * 1e-4).collect();
    let back = own.coordinates(&own.system.projection().unwrap().all(&x));
    assert!(x.iter().zip(&back).all(|(a, b)| (a - b).abs() < 1e-11), "{x:?} {back:?}");
}

const STUDY: &str = r#"
[[study]]
kind = "transient"
speed = "300 rad/s"
duration = "0.2 s"
initial = { "shaft.node_1.x" = "20 um", "shaft.node_1.y'" = "0.01 m/s" }
"#;

/// A motion by entries is that of a machine of few elements with full matrices; its energy is kept, and it names no reduction.
#[test]
fn motions() {
    let of = |elements: usize| {
        let text = STUDY.replace("initial", "points = 200\ninitial");
        run_all(&(machine(elements) + &text)).swap_remove(0)
    };
    let (few, many) = (of(6), of(8));
    assert!(findings(&few, "reduced").is_empty() && findings(&many, "reduced").is_empty());
    let column = |o: &laval::outcome::Outcome, name: &str| -> Vec<f64> {
        let table = o.find_table("motion").unwrap();
        let c = table.column(name).unwrap_or_else(|| panic!("{name}: {:?}", table.columns().iter().map(|c| &c.name).collect::<Vec<_>>()));
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    for name in ["left.x", "shaft at 700 mm.y"] {
        let (a, b) = (column(&few, name), column(&many, name));
        let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let far = a.iter().zip(&b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!(size > 1e-6 && far < 5e-3 * size, "{name}: {:e}", far / size);
    }
    assert!(many.find_table("motion").unwrap().column("shaft.node_5.tilt_x").is_some());
    let kept =
        |o: &laval::outcome::Outcome| findings(o, "energy_balance").iter().filter_map(|f| f.value).fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(kept(&many) < 1e-6, "{:e}", kept(&many));
}

/// Basins of many elements, on the reduced machine, are those of few elements: as many motions, of the same amplitudes, from the same initial values.
#[test]
fn basins_of_many_elements() {
    let study = "[[study]]\nkind = \"basins\"\nspeed = \"320 rad/s\"\nfrom = { \"left.x\" = \"-0.3 mm\", \"left.y'\" = \"-0.1 m/s\" }\n\
                 to = { \"left.x\" = \"0.3 mm\", \"left.y'\" = \"0.1 m/s\" }\npoints = 3\n";
    let of = |elements: usize| run_all(&(machine(elements).replace("horizontal", "vertical") + study)).swap_remove(0);
    let (few, many) = (of(2), of(8));
    assert!(findings(&few, "reduced").is_empty());
    assert_eq!(findings(&many, "reduced").len(), 1);
    let column = |o: &laval::outcome::Outcome, name: &str| -> Vec<f64> {
        let table = o.find_table("cells").unwrap();
        let c = table.column(name).unwrap_or_else(|| panic!("{name}: {:?}", table.columns().iter().map(|c| &c.name).collect::<Vec<_>>()));
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    let (a, b) = (column(&few, "amplitude.left"), column(&many, "amplitude.left"));
    assert!(a.len() == b.len() && a.len() >= 9);
    for (x, y) in a.iter().zip(&b) {
        assert!(*x > 1e-6 && (x / y - 1.0).abs() < 0.02, "{a:?} {b:?}");
    }
}

/// A map over a parameter of a disc and one of a bearing: the parts that vary stay as they are, the rest is reduced once; as of few elements.
#[test]
fn maps_over_parameters_of_many_elements() {
    let study = "[[study]]\nkind = \"motion_map\"\nspeed = 320\nx = { parameter = \"left.mass\", from = 12, to = 16, points = 2 }\n\
                 y = { parameter = \"lower.cubic_stiffness\", from = 1e14, to = 8e14, points = 2 }\n";
    let of = |elements: usize| run_all(&(machine(elements).replace("horizontal", "vertical") + study)).swap_remove(0);
    let (few, many) = (of(2), of(8));
    assert!(findings(&few, "reduced").is_empty() && findings(&many, "reduced").len() == 1);
    let column = |o: &laval::outcome::Outcome| -> Vec<f64> {
        let c = o.find_table("map").unwrap().column("amplitude.left").unwrap();
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    let (a, b) = (column(&few), column(&many));
    assert!(a.len() == 4 && b.len() == 4);
    for (x, y) in a.iter().zip(&b) {
        assert!(*x > 1e-6 && (x / y - 1.0).abs() < 0.02, "{a:?} {b:?}");
    }
    // both parameters have an effect
    assert!((b[0] / b[1] - 1.0).abs() > 1e-2 && (b[0] / b[2] - 1.0).abs() > 1e-3, "{b:?}");
}

/// A diameter of the shaft moves what is reduced: the whole machine is followed.
#[test]
fn a_parameter_of_the_shaft_itself_varies_on_the_whole_machine() {
    let whole = load(&machine(8).replace("horizontal", "vertical")).system;
    let shaft = whole.slots().iter().position(|s| s.name == "shaft").unwrap();
    assert!(ReducedMachine::varying(&whole, 300.0, &[shaft]).is_none());
    // a part that varies has the parameters of the member; a machine with a part attached elsewhere is none
    let disc = whole.slots().iter().position(|s| s.name == "left").unwrap();
    let own = ReducedMachine::varying(&whole, 300.0, &[disc]).unwrap();
    let heavier = whole.with(&[("left.mass", 20.0)]).unwrap();
    let a = modes(&own.member(&whole, &heavier).unwrap(), 250.0, 1500.0);
    let b = modes(&ReducedMachine::of(&heavier, 300.0).unwrap().system, 250.0, 1500.0);
    assert!(a.len() == b.len() && a.len() > 3);
    for (a, b) in a.iter().zip(&b) {
        assert!((*a - *b).abs() < 1e-4 * b.abs(), "{a:?} {b:?}");
    }
    let other = load(&machine(8).replace("horizontal", "vertical").replace("at = 0.35", "at = 0.3")).system;
    assert!(own.member(&whole, &other).is_none());
}

/// A load of another spin keeps its own angle where the matrices are kept as entries.
#[test]
fn loads_of_another_spin() {
    let text = |elements: usize| {
        let other = "[[part]]\nkind = \"speed_ratio\"\nname = \"other\"\nratio = -1.3\n\
                     [[part]]\nkind = \"disc\"\nname = \"ring\"\nspin = \"other\"\nmass = 5.0\nunbalance = 6e-4\n\
                     [[part]]\nkind = \"bearing_linear\"\nname = \"of ring\"\nbetween = [\"ring\", { body = \"shaft\", at = 0.5 }]\nkxx = 8e6\nkyy = 8e6\ncxx = 500.0\ncyy = 500.0\n";
        machine(elements) + other + &STUDY.replace("initial", "points = 200\ninitial")
    };
    let column = |o: &laval::outcome::Outcome| -> Vec<f64> {
        let c = o.find_table("motion").unwrap().column("right.x").unwrap();
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    let [few, many, same] = [text(6), text(8), text(8).replace("spin = \"other\"\n", "")].map(|t| run_all(&t).swap_remove(0));
    assert!(findings(&few, "reduced").is_empty() && findings(&many, "reduced").is_empty());
    let [a, b, c] = [&few, &many, &same].map(column);
    let far = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(size > 1e-6 && far(&a, &b) < 5e-3 * size, "{:e}", far(&a, &b) / size);
    assert!(far(&b, &c) > 0.05 * size, "another spin makes another motion");
}

/// Twice the elements are twice the work of a motion, not eight times.
#[test]
fn work_of_a_motion_grows_with_the_elements() {
    let cost = |elements: usize| {
        let loaded = load(&(machine(elements) + STUDY));
        let stop = Cancel::default();
        watched(Some(&stop), u64::MAX, || loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).map(|_| ()))
            .unwrap()
            .unwrap();
        stop.spent() as f64
    };
    let all = [8, 16, 32].map(cost);
    assert!(all.windows(2).all(|w| w[1] / w[0] < 2f64.powf(1.3)), "{all:?}");
}

/// Stability of motions that are not circular: exponents of the reduced machine are those of few elements but for the error of these, and every state has them.
#[test]
fn exponents_of_motions_that_are_not_circular() {
    let of = |elements: usize| -> Response {
        let system = load(&machine(elements).replace("horizontal", "vertical")).system;
        respond(&system, &Request::over(280.0, 340.0), &AtomicBool::new(false), &|_| {}).unwrap()
    };
    let (few, many) = (of(1), of(4));
    let reduced = many.reduced.unwrap();
    assert!(few.reduced.is_none() && reduced.error < 1e-3 && reduced.coordinates <= 32, "{reduced:?}");
    let states = |r: &Response| r.branches.iter().flat_map(|b| b.points.clone()).collect::<Vec<_>>();
    assert!(many.unassessed.is_none() && states(&many).iter().all(|p| p.exponents.is_some()));
    let unstable = |r: &Response| states(r).iter().filter(|p| p.exponents.as_ref().is_some_and(|e| !e.stable())).count();
    assert_eq!(unstable(&few) == 0, unstable(&many) == 0);
    // growth of the least stable exponent over the speed, on the branches from below
    let growth = |r: &Response, w: f64| {
        let all = states(r);
        let near = all.iter().min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs())).unwrap();
        (near.speed, near.exponents.as_ref().unwrap().growth())
    };
    for w in [285.0, 310.0, 335.0] {
        let ((va, a), (vb, b)) = (growth(&few, w), growth(&many, w));
        assert!((va - vb).abs() < 3.0 && (a - b).abs() < 0.05 * a.abs() + 0.3, "{w}: {va} {a}, {vb} {b}");
    }
}
