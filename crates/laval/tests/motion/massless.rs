//! Coordinates without inertia in time: springs and dampers in series against what they amount to, small masses, the account of energy.

use crate::common::files::{findings, load, run_all};
use laval::model::system::System;
use laval::solve::motion::trajectory::{Choice, Plan, Trajectory, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::pencil::Linearised;
use laval::solve::programme::{Programme, Shape};
use laval::solve::rest::rest;
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::ode::{Ode, StiffOde};

const M: f64 = 3.0;
const E: f64 = 2e-4;
const K1: f64 = 8e5;
const K2: f64 = 3e5;
const W: f64 = 350.0;

/// A rotor on what `bearing` says of the rotor and the node, the node of this mass on what `support` says, and external damping on the rotor.
fn chain(mass: f64, bearing: &str, support: &str, machine: &str) -> System {
    let text = format!(
        "[machine]\nspeed = {W}\n{machine}\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {M}\neccentricity = {E}\npolar_inertia = 0.02\n\
         [[part]]\nkind = \"disc\"\nname = \"node\"\nmass = {mass}\n\
         [[part]]\nbetween = [\"rotor\", \"node\"]\nname = \"bearing\"\n{bearing}\n\
         [[part]]\nbetween = [\"node\", \"ground\"]\nname = \"support\"\n{support}\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"rotor\", \"ground\"]\ndamping = 40\n"
    );
    load(&text).system
}

fn spring(k: f64) -> String {
    format!("kind = \"bearing_linear\"\nstiffness = {k}")
}
fn damped(k: f64, damping: f64) -> String {
    format!("{}\ndamping = {damping}", spring(k))
}

/// The rotor on one spring.
fn single(k: f64, machine: &str) -> System {
    let text = format!(
        "[machine]\nspeed = {W}\n{machine}\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {M}\neccentricity = {E}\npolar_inertia = 0.02\n\
         [[part]]\nbetween = [\"rotor\", \"ground\"]\n{}\n[[part]]\nkind = \"damper\"\nbetween = [\"rotor\", \"ground\"]\ndamping = 40\n",
        spring(k)
    );
    load(&text).system
}

fn at(speed: f64) -> SpinLaw {
    SpinLaw::Programme(Programme::constant(speed, 0.0))
}
fn ramp() -> SpinLaw {
    SpinLaw::Programme(Programme::ramp(100.0, 600.0, 0.2, Shape::Smooth, 0.2).unwrap())
}

/// To `end`, with the states at `outputs`.
fn run(motion: &mut Motion, y: &[f64], end: f64, choice: Choice, outputs: &[f64]) -> Trajectory {
    let plan = Plan {
        t_end: end,
        choice,
        relative: 1e-10,
        absolute: 1e-10,
        outputs,
        windows: 10,
        rest: &[],
        bound: 1.0,
        kick: None,
        max_steps: 1_000_000,
        cancel: &|| false,
        progress: &|_| (),
    };
    simulate(motion, y, &plan).unwrap_or_else(|d| panic!("{d:?}"))
}

/// States of rotor and node: x, y each, then their rates.
fn ends(system: &System, law: SpinLaw, start: &[f64], end: f64, choice: Choice) -> Vec<f64> {
    let mut motion = Motion::new(system, law).unwrap_or_else(|d| panic!("{d:?}"));
    let mut y = vec![0.0; motion.dim()];
    y[..start.len()].copy_from_slice(start);
    run(&mut motion, &y, end, choice, &[]).state
}

fn near(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let size = b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance * size)
}

/// At constant and changing speed, upright and lying, by both methods; the node is where the springs put it.
#[test]
fn springs_in_series_are_one_spring() {
    let share = K1 / (K1 + K2);
    for machine in ["", "axis = \"horizontal\""] {
        let (two, one) = (chain(0.0, &spring(K1), &spring(K2), machine), single(K2 * share, machine));
        for law in [at(W), ramp()] {
            for choice in [Choice::Explicit, Choice::Stiff] {
                let a = ends(&two, law.clone(), &[4e-4, 0.0], 0.3, choice);
                let b = ends(&one, law.clone(), &[4e-4, 0.0], 0.3, choice);
                assert!(near(&a[..2], &b[..2], 1e-6) && near(&a[4..6], &b[2..4], 1e-6), "{a:?} {b:?}");
                let node: Vec<f64> = [a[0], a[1]].map(|x| share * x).to_vec();
                assert!(near(&a[2..4], &node, 1e-12), "{a:?}");
                let rates: Vec<f64> = [a[4], a[5]].map(|x| share * x).to_vec();
                assert!(near(&a[6..8], &rates, 1e-12), "{a:?}");
            }
        }
    }
}

/// A damper beside the support: steady amplitude from the complex stiffness, and the three roots of each plane.
#[test]
fn a_damped_node_is_a_state_of_first_order() {
    let damping = 900.0;
    let system = chain(0.0, &spring(K1), &damped(K2, damping), "");
    let stiffness = |s: C64| C64::real(1.0) / (C64::real(1.0 / K1) + C64::real(1.0) / (C64::real(K2) + s.scale(damping)));
    for choice in [Choice::Explicit, Choice::Stiff] {
        let mut motion = Motion::new(&system, at(W)).unwrap();
        let y = vec![0.0; motion.dim()];
        let end = run(&mut motion, &y, 1.5, choice, &[]).state;
        let s = c(0.0, W);
        let rotor = c(M * E * W * W, 0.0) / (stiffness(s) + s * s.scale(M) + s.scale(40.0));
        let node = rotor.scale(K1) / (C64::real(K1 + K2) + s.scale(damping));
        for (found, expected) in [(c(end[0], end[1]).abs(), rotor.abs()), (c(end[2], end[3]).abs(), node.abs())] {
            assert!((found / expected - 1.0).abs() < 1e-7, "{found} {expected}");
        }
        // the velocity of the node turns with it
        assert!((c(end[6], end[7]) - c(0.0, W) * c(end[2], end[3])).abs() < 1e-6 * W * node.abs());
    }
    let modes = Linearised::new(&system, &rest(&system, W).unwrap()).unwrap().spectrum().unwrap().modes;
    // of x + i y
    assert_eq!(modes.len(), 3, "{:?}", modes.iter().map(|m| m.value).collect::<Vec<_>>());
    for m in modes {
        let s = m.value;
        let balance = stiffness(s) + s * s.scale(M) + s.scale(40.0);
        assert!(balance.abs() < 1e-8 * K2, "{s:?} {balance:?}");
    }
}

/// A cubic bearing on a spring: a small mass of the node, started on the slow motion, differs in proportion to it.
#[test]
fn a_small_mass_converges_to_none() {
    let cubic = "kind = \"bearing_cubic\"\nlaw = \"isotropic\"\nstiffness = 4e5\ncubic_stiffness = 5e12";
    let none = chain(0.0, cubic, &spring(K2), "");
    let mut motion = Motion::new(&none, at(W)).unwrap();
    let mut start = vec![0.0; motion.dim()];
    start[0] = 6e-4;
    motion.settle(0.0, &mut start).unwrap();
    // forces of bearing and support on the node are equal
    let d = start[0] - start[2];
    assert!((4e5 * d + 5e12 * d.powi(3) - K2 * start[2]).abs() < 1e-9 * K2 * start[2] && start[2] > 2e-4, "{start:?}");
    let limit = ends(&none, at(W), &start, 0.05, Choice::Stiff);
    let stiff = ends(&none, at(W), &start, 0.05, Choice::Explicit);
    assert!(near(&stiff[..4], &limit[..4], 1e-7), "{stiff:?} {limit:?}");
    let away = |mass: f64| {
        let with = ends(&chain(mass, cubic, &spring(K2), ""), at(W), &start, 0.05, Choice::Explicit);
        (0..2).map(|i| (with[i] - limit[i]).powi(2)).sum::<f64>().sqrt()
    };
    let found = [3e-2, 3e-3, 3e-4].map(away);
    assert!(found[0] < 0.2 * 6e-4, "{found:?}");
    for pair in found.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((6.0..15.0).contains(&ratio), "{found:?}");
    }
}

/// Internal states that read a node whose place follows: a node on a viscoelastic shaft, and with small masses.
#[test]
fn states_that_read_a_node() {
    let shaft = "kind = \"shaft_viscoelastic\"\nstiffness = 4e5\nexponentials = { share = [0.4], rate = [300] }";
    let none = chain(0.0, &spring(K1), shaft, "");
    let mut motion = Motion::new(&none, at(W)).unwrap();
    let mut start = vec![0.0; motion.dim()];
    start[0] = 6e-4;
    motion.settle(0.0, &mut start).unwrap();
    let limit = ends(&none, at(W), &start, 0.05, Choice::Stiff);
    let away = |mass: f64| {
        let with = ends(&chain(mass, &spring(K1), shaft, ""), at(W), &start, 0.05, Choice::Stiff);
        (0..2).map(|i| (with[i] - limit[i]).powi(2)).sum::<f64>().sqrt()
    };
    let found = [3e-2, 3e-3, 3e-4].map(away);
    assert!(found[0] < 0.2 * 6e-4, "{found:?}");
    for pair in found.windows(2) {
        assert!((6.0..15.0).contains(&(pair[0] / pair[1])), "{found:?}");
    }
}

/// What is stored changes by what goes in and out, with a damped node and with one that has springs alone.
#[test]
fn energy_is_accounted_for() {
    let cubic = "kind = \"bearing_cubic\"\nlaw = \"isotropic\"\nstiffness = 4e5\ncubic_stiffness = 5e12";
    for (support, law, machine) in [
        (spring(K2), at(W), ""),
        (damped(K2, 700.0), ramp(), ""),
        (damped(K2, 700.0), at(W), "axis = \"horizontal\""),
        (spring(K2), ramp(), "axis = \"horizontal\""),
    ] {
        let system = chain(0.0, cubic, &support, machine);
        let mut motion = Motion::new(&system, law).unwrap();
        motion.keep_account().unwrap();
        let mut y = vec![0.0; motion.dim()];
        y[0] = 5e-4;
        motion.settle(0.0, &mut y).unwrap();
        let before = motion.stored_energy(0.0, &y).unwrap();
        let end = run(&mut motion, &y, 0.3, Choice::Auto, &[]).state;
        let k = motion.account_start().unwrap();
        let change = motion.stored_energy(0.3, &end).unwrap() - before;
        let (heat, rest) = (end[k], end[k + 1] + end[k + 2] + end[k + 3]);
        assert!(heat > 1e-3, "{heat}");
        assert!((change - (rest - heat)).abs() < 1e-7 * (heat + rest.abs()), "{change} {heat} {rest}");
    }
}

/// Free spin: a motor on the rotor, with and without the node.
#[test]
fn a_free_spin_takes_nodes_too() {
    let machine = "drive = \"free\"";
    let motor = "[[part]]\nkind = \"motor\"\nname = \"motor\"\ntorque = 0.8\n";
    let with = |system: System| {
        let mut text = laval::file::load(&format!(
            "[machine]\n{machine}\n[[part]]\nkind = \"disc\"\nname = \"x\"\nmass = 1\npolar_inertia = 1\n{motor}"
        ))
        .unwrap()
        .system
        .inputs();
        let mut inputs = system.inputs();
        inputs.push(text.remove(1));
        System::assemble(system.machine.clone(), inputs).unwrap()
    };
    let (two, one) = (with(chain(0.0, &spring(K1), &spring(K2), machine)), with(single(K1 * K2 / (K1 + K2), machine)));
    for choice in [Choice::Explicit, Choice::Stiff] {
        let (a, b) = (ends(&two, SpinLaw::Free, &[], 0.4, choice), ends(&one, SpinLaw::Free, &[], 0.4, choice));
        assert!(near(&a[..2], &b[..2], 1e-6) && (a[9] - b[5]).abs() < 1e-7 * b[5] && b[5] > 1.0, "{a:?} {b:?}");
    }
}

/// Columns of states that something reads, in the rows of accelerations and of damped nodes; nothing reads places that follow.
#[test]
fn the_jacobian_is_that_of_the_right_side() {
    let cubic = "kind = \"bearing_cubic\"\nlaw = \"isotropic\"\nstiffness = 4e5\ncubic_stiffness = 5e12";
    for (support, is_state) in [(spring(K2), false), (damped(K2, 700.0), true)] {
        let system = chain(0.0, cubic, &support, "");
        let mut motion = Motion::new(&system, ramp()).unwrap();
        let y = [3e-4, -1e-4, 2e-4, 1e-4, 0.03, 0.05, -0.02, 0.04];
        let mut jac = Mat::zeros(8, 8);
        motion.jacobian(0.11, &y, &mut jac).unwrap();
        let mut f = |j: usize, d: f64| {
            let (mut y, mut dy) = (y, [0.0; 8]);
            y[j] += d;
            motion.rhs(0.11, &y, &mut dy).unwrap();
            dy
        };
        for j in 0..8 {
            let h = if j < 4 { 1e-7 } else { 1e-4 };
            let (up, down) = (f(j, h), f(j, -h));
            for i in 0..8 {
                // rows of what follows leave second derivatives out
                let follows = if is_state { i >= 6 } else { [2, 3, 6, 7].contains(&i) };
                if follows {
                    continue;
                }
                let difference = (up[i] - down[i]) / (2.0 * h);
                let size = jac.row(i).iter().fold(1.0f64, |m, x| m.max(x.abs()));
                assert!((difference - jac[(i, j)]).abs() < 1e-6 * size, "{i} {j}: {difference} {}", jac[(i, j)]);
                let read = if is_state { j < 6 } else { [0, 1, 4, 5].contains(&j) };
                assert!(read || difference.abs() < 1e-9 * size && jac[(i, j)] == 0.0, "{i} {j}: {difference}");
            }
        }
    }
}

/// What nothing holds, and what dampers alone hold without determining it, is refused by name.
#[test]
fn what_nothing_determines_is_refused() {
    let rotor = "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 3\n[[part]]\nkind = \"disc\"\nname = \"node\"\nmass = 0\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = 1e6\n";
    let refused = |more: &str| {
        let system = load(&format!("{rotor}{more}")).system;
        let d = Motion::new(&system, at(300.0)).err().unwrap();
        assert_eq!(d.code, "motion.mass");
        format!("{} {}", d.message, d.help.map_or(String::new(), |h| h.to_string()))
    };
    let alone = refused("");
    assert!(alone.contains("no damping or stiffness determines \"node.x\"") && alone.contains("hold it"), "{alone}");
    let second = "[[part]]\nkind = \"disc\"\nname = \"second\"\nmass = 0\n[[part]]\nkind = \"damper\"\nbetween = [\"node\", \"second\"]\ndamping = 50\n\
                  [[part]]\nkind = \"bearing_linear\"\nname = \"a\"\nbetween = [\"node\", \"rotor\"]\nstiffness = 1e5\n\
                  [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"second\", \"ground\"]\nstiffness = 1e5\n";
    let apart = refused(second);
    assert!(apart.contains("determines \"second."), "{apart}");
    // a damper of its own settles it
    let held = format!("{rotor}{second}[[part]]\nkind = \"damper\"\nbetween = [\"node\", \"ground\"]\ndamping = 5\n");
    assert!(Motion::new(&load(&held).system, at(300.0)).is_ok());
}

/// A file with a node: modes, response, motion in time and run-up, which agree.
#[test]
fn studies_of_a_file_take_nodes() {
    let machine = format!(
        "[machine]\nspeed = {W}\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {M}\neccentricity = {E}\n[[part]]\nkind = \"disc\"\nname = \"node\"\nmass = \"0 kg\"\n\
         [[part]]\nbetween = [\"rotor\", \"node\"]\n{}\n[[part]]\nbetween = [\"node\", \"ground\"]\n{}\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"rotor\", \"ground\"]\ndamping = 40\n",
        spring(K1),
        spring(K2)
    );
    let studies = format!(
        "[[study]]\nkind = \"modes\"\n[[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 50, to = 800 }}\n\
         [[study]]\nkind = \"forced_response\"\nspeed = {{ from = {W}, to = {}, points = 3 }}\n[[study]]\nkind = \"transient\"\nduration = 1.5\n\
         [[study]]\nkind = \"run_up\"\nfrom = 100\nto = 500\nduration = 2\n",
        W + 1.0
    );
    let outcomes = run_all(&format!("{machine}{studies}"));
    assert_eq!(outcomes.len(), 5);
    let k = K1 * K2 / (K1 + K2);
    let critical = findings(&outcomes[1], "critical_speed");
    // of both directions of whirl, at the damped frequency on the springs in series
    let at = format!("{:.1} rad/s", (k / M - (40.0 / (2.0 * M)).powi(2)).sqrt());
    assert_eq!(critical.len(), 2);
    assert!(critical.iter().all(|f| f.sentence().contains(&at)), "{at}: {:?}", critical.iter().map(|f| f.sentence()).collect::<Vec<_>>());
    let modes = outcomes[0].tables.first().map(|t| t.rows()).unwrap();
    assert_eq!(modes, 2, "{:?}", outcomes[0].tables);
    let response = outcomes[2].find_table("response").unwrap().column("amplitude.rotor").unwrap();
    let laval::outcome::Data::Float(found) = &response.data else { panic!() };
    let expected = M * E * W * W / (C64::real(k - M * W * W) + c(0.0, 40.0 * W)).abs();
    assert!((found[0] / expected - 1.0).abs() < 1e-9, "{found:?} {expected}");
}
