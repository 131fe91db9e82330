//! The ball balancer in assembled machines: equations of motion, motions at constant speed and in run-ups, conservation.

use crate::common;

use common::{number, rows};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::{At, Link};
use laval::model::system::{System, Workspace};
use laval::model::tangent::{Tangent, TangentScratch};
use laval::parts::{balancer_ball::*, damper::*, disc::*, motor::*, shaft_lumped::*};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use laval_num::complex::{C64, c};
use laval_num::dense::Lu;
use laval_num::ode::{Control, Dop853, End, Ode, integrate};
use std::collections::BTreeMap;
use std::f64::consts::PI;

const EARTH: f64 = 9.81;

/// A disc on an elastic shaft in air, and a balancer.
#[derive(Clone)]
struct Case {
    disc: DiscParams,
    stiffness: f64,
    damping: f64,
    balancer: BallBalancer,
    ring: BalancerBallParams,
    motor: Option<MotorParams>,
}

impl Case {
    fn build(&self) -> System {
        let link = || Link::Between(Attach::on("disc"), Attach::ground());
        let shaft = ShaftLumpedParams { stiffness: [self.stiffness; 2], ..ShaftLumpedParams::new() };
        let mut b = Builder::new("balancer")
            .speed(100.0)
            .part("disc", Disc::planar(), self.disc)
            .part("shaft", ShaftLumped::lateral(link()), shaft)
            .part("air", Damper::fixed(link()), DamperParams { damping: [self.damping; 2], tilt_damping: 0.0 })
            .part("balancer", self.balancer.clone(), self.ring);
        if let Some(motor) = self.motor {
            b = b.part("motor", Motor::new(Curve::Constant), motor).free_spin();
        }
        b.build().unwrap()
    }
}

/// The machine of the source: two balls of 3.6 g on a housing of 1.5 kg.
fn source() -> Case {
    Case {
        disc: DiscParams { eccentricity: 50e-6, polar_inertia: 0.05, ..DiscParams::new(8.91) },
        stiffness: 2922676.0,
        damping: 1e-3,
        balancer: BallBalancer::new(Attach::on("disc"), 2).planar(),
        ring: BalancerBallParams {
            eccentricity: 50e-6,
            tilt: PI / 20.0,
            node_line: PI / 6.0,
            housing_mass: 1.5,
            gravity: EARTH,
            ..BalancerBallParams::new(0.0036, 0.2)
        },
        motor: None,
    }
}

/// Follows a programme from output to output; the states (q, v) there. Checks the energy balance.
fn follow(system: &System, programme: Programme, start: &[f64], times: &[f64], closes: f64) -> Vec<Vec<f64>> {
    let mut motion = Motion::new(system, SpinLaw::Programme(programme)).unwrap();
    motion.keep_account().unwrap();
    let mut y = vec![0.0; motion.dim()];
    y[..start.len()].copy_from_slice(start);
    let before = motion.stored_energy(times[0], &y).unwrap();
    let n = system.n();
    // lengths, angles, their rates, energies
    let size = |i: usize| if i >= 2 * n { 1e-12 } else { [1e-14, 1e-12][usize::from(i % n > 1)] * if i < n { 1.0 } else { 100.0 } };
    let control = Control::new(1e-12, (0..y.len()).map(size).collect::<Vec<f64>>());
    let k = motion.account_start().unwrap();
    let (mut out, mut exchanged) = (vec![y.clone()], 0.0f64);
    for w in times.windows(2) {
        let run = integrate(&mut Dop853::new(), &mut motion, w[0], &mut y, w[1], &control, &mut ());
        assert_eq!(run.end, End::Reached);
        out.push(y.clone());
        exchanged = exchanged.max(y[k].abs() + y[k + 2].abs());
    }
    let after = motion.stored_energy(times[times.len() - 1], &y).unwrap();
    let missing = after - before + y[k] - y[k + 1] - y[k + 2] - y[k + 3];
    assert!(missing.abs() < closes * (exchanged + (after - before).abs()), "{missing:e} of {exchanged}");
    out
}

#[test]
fn equations_of_motion_through_the_parts() {
    let text = include_str!("../reference/balancer/eom_test_vectors.csv");
    let mut table: BTreeMap<(&str, &str), Vec<f64>> = BTreeMap::new();
    for r in rows(text) {
        table.entry((r[0], r[1])).or_default().push(number(r[3]));
    }
    for case in ["one_track", "two_tracks"] {
        let get = |what: &str| table[&(case, what)].clone();
        let one = BallBalancer::new(Attach::on("disc"), 2);
        let balancer =
            if case == "one_track" { one.masses(&[1.0, 1.5]) } else { one.track(1, 0.11 / 0.15, 0.0, 0.0).masses(&[1.0, 1.5, 0.75]) };
        for balancer in [balancer.clone().free().planar(), balancer.free()] {
            let machine = Case {
                disc: DiscParams { eccentricity: 2e-3, polar_inertia: 0.04, ..DiscParams::new(3.0) },
                stiffness: 5e4,
                damping: 12.0,
                balancer,
                ring: BalancerBallParams {
                    eccentricity: 1e-3,
                    eccentricity_phase: 0.5,
                    node_line: 0.8,
                    housing_mass: 0.7,
                    diametral_inertia: 0.01,
                    polar_inertia: 0.018,
                    tilt_damping: 0.02,
                    drag: 0.003,
                    gravity: EARTH,
                    ..BalancerBallParams::new(0.02, 0.15)
                },
                motor: Some(MotorParams { drag: 0.01, ..MotorParams::new(get("motor_torque")[0]) }),
            };
            let system = machine.build();
            // the table has the spin angle third, the machine last
            let n = system.n();
            let theirs: Vec<usize> = (0..=n)
                .map(|i| {
                    if i < 2 {
                        i
                    } else if i == n {
                        2
                    } else {
                        i + 1
                    }
                })
                .collect();
            let split = |x: &[f64]| (theirs[..n].iter().map(|&i| x[i]).collect::<Vec<f64>>(), x[2]);
            let ((q, phase), (v, speed)) = (split(&get("q")), split(&get("qdot")));
            let zero = vec![0.0; n];
            let at = At { q: &q, v: &v, a: &zero, z: &[], phase, speed, spin_accel: 0.0, t: 0.0 };
            let mut tangent = Tangent::default();
            system.tangent(&at, true, &mut tangent, &mut TangentScratch::default(), |_| true);
            let (m, f, accel) = (get("M"), get("f"), get("qddot"));
            let size = |x: &[f64], i: usize| x[theirs[i]].abs();
            for i in 0..=n {
                for j in 0..=n {
                    let expected = m[theirs[i] * (n + 1) + theirs[j]];
                    let scale = (m[theirs[i] * (n + 2)] * m[theirs[j] * (n + 2)]).sqrt();
                    assert!((tangent.a[(i, j)] - expected).abs() < 1e-14 * scale, "{case} M {i} {j}: {} {expected}", tangent.a[(i, j)]);
                }
                // rows with cancelling terms of 30 N and 0.5 N m
                let scale = size(&f, i).max(if i < 2 { 100.0 } else { 1.0 });
                assert!((tangent.force[i] + f[theirs[i]]).abs() < 1e-13 * scale, "{case} f {i}: {} {}", -tangent.force[i], f[theirs[i]]);
            }
            let mut found: Vec<f64> = tangent.force.iter().map(|r| -r).collect();
            Lu::new(&tangent.a).unwrap().solve(&mut found);
            for i in 0..=n {
                assert!(
                    (found[i] - accel[theirs[i]]).abs() < 1e-12 * size(&accel, i).max(30.0),
                    "{case} q'' {i}: {} {}",
                    found[i],
                    accel[theirs[i]]
                );
            }
            let stored = system.energy(system.params(), &at, &mut Workspace::default()).unwrap().stored;
            let expected = get("T")[0] + get("Pi")[0];
            assert!((stored - expected).abs() < 1e-13 * expected, "{case} T + Pi {stored} {expected}");
        }
    }
}

/// The flat ring agrees with the equations of Rodrigues, Champneys, Friswell and Wilson (2010).
#[test]
fn flat_ring_follows_the_published_equations() {
    let table = rows(include_str!("../reference/balancer/planar_transient.csv"));
    let machine = Case {
        disc: DiscParams { eccentricity: 0.01, polar_inertia: 1.0, ..DiscParams::new(1.0) },
        stiffness: 1.0,
        damping: 0.02,
        balancer: BallBalancer::new(Attach::on("disc"), 2).planar(),
        ring: BalancerBallParams { drag: 0.0025, ..BalancerBallParams::new(0.05, 1.0) },
        motor: None,
    };
    let times: Vec<f64> = table.iter().map(|r| number(r[0])).collect();
    let start = [0.0, 0.0, 0.3, 2.0, 0.0, 0.0, 0.0, 0.0];
    let states = follow(&machine.build(), Programme::constant(3.0, 0.0), &start, &times, 1e-9);
    for (row, y) in table.iter().zip(&states) {
        for k in 0..4 {
            for column in [1 + k, 5 + k] {
                assert!((y[k] - number(row[column])).abs() < 1e-10, "t = {}: {} {}", row[0], y[k], row[column]);
            }
        }
    }
}

#[test]
fn starts_at_full_speed() {
    let table = rows(include_str!("../reference/balancer/constant_speed_transients.csv"));
    let mut runs: BTreeMap<Vec<&str>, Vec<&Vec<&str>>> = BTreeMap::new();
    for r in &table {
        runs.entry(r[..6].to_vec()).or_default().push(r);
    }
    assert_eq!(runs.len(), 4);
    for (key, rows) in runs {
        let mut machine = source();
        let [nu, k, beta, gamma, drag] = [1, 2, 3, 4, 5].map(|i| number(key[i]));
        machine.stiffness = k;
        (machine.ring.node_line, machine.ring.eccentricity_phase, machine.ring.drag) = (beta, gamma, drag);
        let times: Vec<f64> = rows.iter().map(|r| number(r[6])).collect();
        let start = [0.0, 0.0, 0.0, -0.5 * PI, 0.0, 0.0, 0.0, 0.0];
        let states = follow(&machine.build(), Programme::constant(nu, 0.0), &start, &times, 1e-9);
        for (r, y) in rows.iter().zip(&states) {
            // angles and gamma are printed to ten decimals
            let tolerance = 1e-8 + 10.0 * number(r[13]);
            for (i, column) in [(2, 9), (3, 10)] {
                assert!((y[i] - number(r[column])).abs() < tolerance, "{key:?} at {} s: {} {}", r[6], y[i], r[column]);
            }
            for (i, column) in [(0, 7), (1, 8)] {
                assert!((y[i] - number(r[column])).abs() < 1e-3 * tolerance, "{key:?} at {} s: {} {}", r[6], y[i], r[column]);
            }
        }
    }
}

/// Rows of a run-up, the states of the machine at their times, and the number of columns before x.
fn run_up(text: &str, change: impl Fn(&mut Case)) {
    let table = rows(text);
    let mut machine = source();
    machine.ring.eccentricity_phase = PI / 40.0;
    change(&mut machine);
    let system = machine.build();
    let n = system.n();
    let mut start = vec![0.0; 2 * n];
    for (i, x) in start[..n].iter_mut().enumerate() {
        *x = number(table[0][2 + i]);
    }
    let times: Vec<f64> = table.iter().map(|r| number(r[0])).collect();
    let programme = Programme::ramp(0.0, 1600.0, 1.0, Shape::Linear, 0.0).unwrap();
    let states = follow(&system, programme, &start, &times, 1e-9);
    let mut compared = 0;
    for (r, y) in table.iter().zip(&states) {
        let check = number(r[r.len() - 1]);
        if check < 1e-6 {
            compared += 1;
            let tolerance = 1e-9 + 10.0 * check;
            for i in 0..n {
                let tolerance = if i < 2 { 1e-3 * tolerance } else { tolerance };
                assert!((y[i] - number(r[2 + i])).abs() < tolerance, "at {} s: {} {}", r[0], y[i], r[2 + i]);
            }
        }
    }
    assert!(compared > 150, "{compared}");
}

#[test]
fn run_ups_with_fixed_tilt() {
    run_up(include_str!("../reference/balancer/runup_fixed_cphi0.001.csv"), |m| m.ring.drag = 1e-3);
    run_up(include_str!("../reference/balancer/runup_fixed_cphi0.01.csv"), |m| m.ring.drag = 1e-2);
}

#[test]
fn run_ups_with_free_tilt() {
    let free = |m: &mut Case, jz: f64| {
        m.balancer = m.balancer.clone().free();
        m.ring = BalancerBallParams { tilt: 0.0, drag: 0.01, tilt_damping: 1e-3, diametral_inertia: 0.03, polar_inertia: jz, ..m.ring };
    };
    run_up(include_str!("../reference/balancer/runup_free_Jx0.03_Jz0.03.csv"), |m| free(m, 0.03));
    run_up(include_str!("../reference/balancer/runup_free_Jx0.03_Jz0.06.csv"), |m| free(m, 0.06));
}

/// A tilting disc on a shaft that holds its tilt, with or without weight and losses.
fn tilting(balancer: BallBalancer, ring: BalancerBallParams, tilt_stiffness: f64, damping: f64, free: bool) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let disc = DiscParams { eccentricity: 5e-4, polar_inertia: 0.05, diametral_inertia: 0.03, ..DiscParams::new(8.91) };
    let shaft = ShaftLumpedParams { stiffness: [2e6; 2], tilt_stiffness, ..ShaftLumpedParams::new() };
    let b = Builder::new("tilting")
        .part("disc", Disc::tilting(), disc)
        .part("shaft", ShaftLumped::with_tilt(link()), shaft)
        .part("air", Damper::fixed(link()), DamperParams { damping: [damping; 2], tilt_damping: 0.0 })
        .part("balancer", balancer, ring);
    if free { b.free_spin() } else { b }.build().unwrap()
}

/// A shaft that hardly tilts: the motion is that of the plane, but for what the shaft gives way.
#[test]
fn a_stiff_tilt_is_the_plane() {
    let ring = BalancerBallParams { drag: 1e-3, eccentricity_phase: 0.3, ..source().ring };
    let planar = Case { disc: DiscParams { eccentricity: 5e-4, ..source().disc }, stiffness: 2e6, damping: 40.0, ring, ..source() }.build();
    let times: Vec<f64> = (0..=20).map(|i| 1e-3 * f64::from(i)).collect();
    let still = Programme::constant(250.0, 0.0);
    let flat = follow(&planar, still.clone(), &[0.0, 0.0, 0.4, -1.1, 0.0, 0.0, 0.0, 0.0], &times, 1e-9);
    let apart = |tilt_stiffness: f64| {
        let spatial = tilting(BallBalancer::new(Attach::on("disc"), 2), ring, tilt_stiffness, 40.0, false);
        let start = [0.0, 0.0, 0.0, 0.0, 0.4, -1.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let space = follow(&spatial, still.clone(), &start, &times, 1e-9);
        let pairs = flat.iter().zip(&space);
        // lengths over a millimetre
        let one =
            |(a, b): (&Vec<f64>, &Vec<f64>)| [(0, 0, 1e3), (1, 1, 1e3), (2, 4, 1.0), (3, 5, 1.0)].map(|(i, j, s)| s * (a[i] - b[j]).abs());
        pairs.flat_map(one).fold(0.0, |m: f64, x| if x <= m { m } else { x })
    };
    let (stiff, softer) = (apart(1e9), apart(1e8));
    assert!(stiff < 1e-8 && (8.0..12.0).contains(&(softer / stiff)), "{stiff:e} {softer:e}");
}

/// Angular momentum about the axis: the derivative of the energy when everything turns along.
fn momentum(system: &System, y: &[f64]) -> f64 {
    let n = system.n();
    let energy = |rate: f64| {
        let mut v = y[n..2 * n].to_vec();
        let mut turned = y[..n].to_vec();
        system.turn(&mut turned, 0.5 * PI);
        for (i, kind) in system.coordinates().iter().map(|c| c.dof.kind).enumerate() {
            if kind.leads_pair() || kind.ends_pair() {
                v[i] += rate * turned[i];
            }
        }
        let zero = vec![0.0; n];
        let at = At { q: &y[..n], v: &v, a: &zero, z: &[], phase: y[2 * n], speed: y[2 * n + 1] + rate, spin_accel: 0.0, t: 0.0 };
        system.energy(system.params(), &at, &mut Workspace::default()).unwrap().stored
    };
    // the energy is a square in the rates: the difference is exact
    (energy(100.0) - energy(-100.0)) / 200.0
}

/// Without weight and losses a free spin keeps energy and angular momentum, in the plane and on a disc that tilts, with fixed and with free rings.
#[test]
fn free_spin_keeps_angular_momentum_and_energy() {
    let ring = BalancerBallParams { gravity: 0.0, eccentricity: 1e-3, ball_mass: 0.05, ..source().ring };
    let held = BalancerBallParams { diametral_inertia: 0.01, polar_inertia: 0.018, tilt_stiffness: 300.0, ..ring };
    let two = || BallBalancer::new(Attach::on("disc"), 2).track(1, 0.8, -0.1, 0.7).masses(&[1.0, 0.6, 1.4]);
    for (balancer, ring) in [(two(), ring), (two().free(), held), (two().planar(), ring), (two().planar().free(), held)] {
        let system = tilting(balancer, ring, 2e4, 0.0, true);
        let n = system.n();
        let mut motion = Motion::new(&system, SpinLaw::Free).unwrap();
        let mut y = vec![0.0; 2 * n + 2];
        let own = [1e-3, -5e-4, 2e-3, 1e-3, 0.2, -0.1, 0.9, -0.4, 2.2];
        for i in 0..n {
            // fixed rings have no tilts
            y[i] = if n == 7 && i >= 4 { own[i + 2] } else { own[i] };
            y[n + i] = 30.0 * own[(i + 3) % 9] * [1e-2, 1.0][usize::from(i >= 4)];
        }
        (y[2 * n], y[2 * n + 1]) = (0.3, 150.0);
        let (e, l) = (motion.stored_energy(0.0, &y).unwrap(), momentum(&system, &y));
        let run = integrate(&mut Dop853::new(), &mut motion, 0.0, &mut y, 0.2, &Control::new(1e-13, 1e-15), &mut ());
        assert_eq!(run.end, End::Reached);
        let (de, dl) = (motion.stored_energy(0.2, &y).unwrap() - e, momentum(&system, &y) - l);
        assert!((y[2 * n + 1] - 150.0).abs() > 0.05, "the spin moves: {}", y[2 * n + 1]);
        assert!(dl.abs() < 1e-12 * l && de.abs() < 1e-11 * e, "{n}: {dl:e} of {l}, {de:e} of {e}");
    }
}

/// Two balls of unequal mass on two flat tracks hold the unbalance in a triangle; the ring centre stays on the axis.
#[test]
fn unequal_balls_balance_in_a_triangle() {
    let ring = BalancerBallParams { drag: 0.01, ..BalancerBallParams::new(0.02, 0.2) };
    let machine = Case {
        disc: DiscParams { eccentricity: 4e-4, polar_inertia: 0.05, ..DiscParams::new(8.0) },
        stiffness: 2e6,
        damping: 400.0,
        balancer: BallBalancer::new(Attach::on("disc"), 1).track(1, 0.75, 0.0, 0.0).masses(&[1.0, 0.8]).planar(),
        ring,
        motor: None,
    };
    let states = follow(&machine.build(), Programme::constant(1500.0, 0.0), &[0.0, 0.0, 2.0, -2.0, 0.0, 0.0, 0.0, 0.0], &[0.0, 10.0], 1e-9);
    let y = &states[1];
    let moments = C64::cis(y[2]).scale(0.004) + C64::cis(y[3]).scale(0.0024) + c(0.0032, 0.0);
    assert!(moments.abs() < 1e-9 && y[0].hypot(y[1]) < 1e-9, "{moments:?} {y:?}");
    // sides 3.2, 4.0, 2.4: the heavier ball is the long side
    assert!((y[2].cos() + 0.8).abs() < 1e-6 && y[3].cos().abs() < 1e-6, "{y:?}");
}

/// Two balancers in two planes of a long rotor cancel a static unbalance and a couple: the axis comes to rest.
#[test]
fn two_planes_balance_a_couple() {
    let point = |z: f64| Link::Between(Attach::at("rotor", z), Attach::ground());
    let rotor = DiscParams {
        eccentricity: 2e-5,
        eccentricity_phase: 0.4,
        polar_inertia: 0.05,
        diametral_inertia: 0.3,
        skew: 6e-4,
        skew_phase: -1.1,
        ..DiscParams::new(10.0)
    };
    let ring = BalancerBallParams { drag: 1e-3, ..BalancerBallParams::new(0.005, 0.1) };
    let mut b = Builder::new("long rotor").part("rotor", Disc::tilting(), rotor);
    for (name, z) in [("lower", -0.16), ("upper", 0.16)] {
        let spring = ShaftLumpedParams { stiffness: [5e5; 2], ..ShaftLumpedParams::new() };
        b = b.part(format!("{name} spring"), ShaftLumped::lateral(point(z)), spring);
        b = b.part(format!("{name} damper"), Damper::fixed(point(z)), DamperParams { damping: [300.0; 2], tilt_damping: 0.0 });
    }
    for (name, z) in [("first", -0.1), ("second", 0.12)] {
        b = b.part(name, BallBalancer::new(Attach::at("rotor", z), 2), ring);
    }
    let system = b.build().unwrap();
    let n = system.n();
    let mut start = vec![0.0; 2 * n];
    start[4..8].copy_from_slice(&[0.3, 2.0, -1.0, 1.2]);
    let states = follow(&system, Programme::constant(1000.0, 0.0), &start, &[0.0, 0.5, 4.0], 1e-9);
    let size = |y: &[f64]| (y[0].hypot(y[1]), y[2].hypot(y[3]));
    let ((moved, tilted), (left, leans)) = (size(&states[1]), size(&states[2]));
    assert!(moved > 1e-7 && tilted > 1e-7 && left < 1e-12 && leans < 1e-11, "{moved:e} {tilted:e} then {left:e} {leans:e}");
}
