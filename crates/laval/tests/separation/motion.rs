//! Motion, exits and tilt of a swinging cup against the reference tables, to their stated digits.

use crate::common;

use common::{number, rows};
use laval::separation::closed::{Closed, Drifting, Path, Steady, exponents};
use laval::separation::cup::{Hanging, SwingingCup};
use laval::separation::exit::{Cylinder, Surface, first_exit};
use laval::separation::frame::{Pose, coriolis, transport};
use laval::separation::motion::{Journey, Tilt};
use laval::separation::particle::{Drag, Medium, Particle};
use laval::separation::ramp::Ramp;

macro_rules! table {
    ($name:literal) => {
        rows(include_str!(concat!("../reference/separation/", $name, ".csv")))
    };
}

struct Case {
    steady: Steady,
    vessel: Cylinder,
    medium: Medium,
    particle: Particle,
    start: [f64; 3],
}

fn case(name: &str) -> (Case, Vec<&'static str>) {
    let row = table!("cases").into_iter().find(|r| r[0] == name).unwrap();
    let n = |i: usize| number(row[i]);
    let medium = Medium { gravity: n(9), added_mass: n(10), volume_fraction: n(11), hindered_exponent: n(12), ..Medium::new(n(7), n(8)) };
    let case = Case {
        steady: Steady { speed: n(13), tilt: n(14), hinge: n(1), gravity: n(9) },
        vessel: Cylinder { radius: n(2), bottom: n(3), top: n(4) },
        medium,
        particle: Particle { radius: n(5), density: n(6) },
        start: [n(15), n(16), n(17)],
    };
    (case, row)
}

fn close(got: f64, want: f64, tolerance: f64, what: &str) {
    assert!((got - want).abs() <= tolerance * want.abs(), "{what}: {got} wanted {want}, relative {:e}", (got / want - 1.0).abs());
}

fn horizon(c: &Case) -> f64 {
    let s = c.medium.rates(&c.particle).sedimentation.abs();
    let field = (c.steady.speed.powi(2) * c.steady.radius(c.start)).hypot(c.steady.gravity);
    (c.vessel.bottom - c.vessel.top) / (s * field)
}

#[test]
fn exponents_keep_their_digits() {
    for row in table!("cases") {
        let (c, _) = case(row[0]);
        let r = c.medium.rates(&c.particle);
        let (a, b) = exponents(&r, c.steady.speed);
        for (i, got) in [(18, r.two_n), (19, r.kappa), (20, r.sedimentation), (21, a.re), (22, a.im), (23, b.re), (24, b.im)] {
            close(got, number(row[i]), 1e-13, &format!("{} column {i}", row[0]));
        }
    }
}

#[test]
fn settling_times_places_and_impacts() {
    for row in table!("settling_times") {
        let (c, _) = case(row[0]);
        let rates = c.medium.rates(&c.particle);
        let path = Closed::new(&rates, &c.steady, c.start, [0.0; 3]);
        let exit = first_exit(&path, &c.vessel, horizon(&c)).unwrap();
        close(exit.time, number(row[1]), 1e-12, row[0]);
        assert_eq!(exit.surface.word(), row[2], "{}", row[0]);
        let size = c.vessel.bottom - c.vessel.top;
        for k in 0..3 {
            assert!((exit.position[k] - number(row[3 + k])).abs() < 2e-13 * size, "{} {k}: {:?}", row[0], exit.position);
        }
        let speed = exit.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
        close(speed, number(row[6]), 1e-12, row[0]);
        close(c.medium.reynolds(&c.particle, speed), number(row[7]), 1e-12, row[0]);
        let drift = Drifting::new(rates.sedimentation, &c.steady, c.start);
        let exit = first_exit(&drift, &c.vessel, horizon(&c)).unwrap();
        close(exit.time, number(row[10]), 1e-12, row[0]);
        assert_eq!(exit.surface.word(), row[11], "{}", row[0]);
    }
}

#[test]
fn trajectories() {
    for row in table!("trajectories") {
        let (c, _) = case(row[0]);
        let (x, v) = Closed::new(&c.medium.rates(&c.particle), &c.steady, c.start, [0.0; 3]).at(number(row[2]));
        for (got, at) in [(x, 3), (v, 6)] {
            let want: Vec<f64> = (0..3).map(|k| number(row[at + k])).collect();
            let size = want.iter().fold(0.0f64, |m, w| m.max(w.abs()));
            // positions come out of a difference of the hinge's size; what starts at rest is zero to rounding in the table too
            let size = if at == 3 { size.max(c.steady.hinge) } else { size };
            for k in 0..3 {
                assert!((got[k] - want[k]).abs() <= 1e-13 * size.max(1e-2), "{} {} {k}: {} {}", row[0], row[1], got[k], want[k]);
            }
        }
    }
}

#[test]
fn accelerations_of_the_frame() {
    for row in table!("inertia_terms") {
        let n = |i: usize| number(row[i]);
        let pose = Pose { speed: n(7), accel: n(8), tilt: n(9), rate: n(10), rate_accel: n(11) };
        let got = [transport(&pose, n(0), [n(1), n(2), n(3)]), coriolis(&pose, [n(4), n(5), n(6)])];
        let size = (12..18).map(|i| n(i).abs()).fold(0.0, f64::max);
        for (i, g) in got.as_flattened().iter().enumerate() {
            assert!((g - n(12 + i)).abs() <= 1e-13 * size, "{row:?} {i}: {g}");
        }
    }
}

#[test]
fn tilt_and_small_swing() {
    let cup = |hinge, l| SwingingCup { hinge, body: Hanging::point(1.0, l), damping: 0.0, gravity: 9.80665 };
    for row in table!("equilibrium_tilt") {
        let n = |i: usize| number(row[i]);
        let tilt = cup(n(1), n(2)).equilibrium(n(4) * std::f64::consts::PI / 30.0);
        assert!((tilt - n(5)).abs() < 1e-12, "{row:?}: {tilt}");
    }
    for row in table!("cup_swing_frequency") {
        let n = |i: usize| number(row[i]);
        let c = cup(n(0), n(1));
        assert!((c.equilibrium(n(2)) - n(3)).abs() < 1e-12);
        close(c.swing_frequency(n(2), n(3)), n(4), 1e-12, "swing");
    }
}

/// Integration against the closed form: the same motion by a second method, stiff and not.
#[test]
fn integration_meets_the_closed_form() {
    for row in table!("settling_times") {
        let (c, _) = case(row[0]);
        let journey = Journey {
            medium: c.medium,
            particle: c.particle,
            ramp: Ramp::Constant(c.steady.speed),
            tilt: Tilt::Fixed { tilt: c.steady.tilt, hinge: c.steady.hinge },
            vessel: c.vessel.into(),
        };
        let arrival = journey.follow(journey.start(c.start), 3.0 * number(row[1]), 1e-12, &[]).unwrap();
        let exit = arrival.exit.unwrap();
        close(exit.time, number(row[1]), 1e-9, row[0]);
        assert_eq!(exit.surface.word(), row[2]);
    }
}

#[test]
fn drag_of_schiller_and_naumann() {
    for row in table!("nonlinear_drag") {
        let (mut c, _) = case(row[1]);
        c.medium.drag = Drag::SchillerNaumann;
        c.medium.added_mass = number(row[2]);
        let journey = Journey {
            medium: c.medium,
            particle: c.particle,
            ramp: Ramp::Constant(c.steady.speed),
            tilt: Tilt::Fixed { tilt: c.steady.tilt, hinge: c.steady.hinge },
            vessel: c.vessel.into(),
        };
        let (end, t) = (number(row[3]), number(row[6]));
        let outputs = if t < end { vec![t] } else { vec![] };
        let arrival = journey.follow(journey.start(c.start), 3.0 * end, 1e-12, &outputs).unwrap();
        let exit = arrival.exit.unwrap();
        close(exit.time, end, 1e-9, row[0]);
        assert_eq!(exit.surface.word(), row[4]);
        let state: Vec<f64> = match arrival.moments.first() {
            Some(m) => m.state[..6].to_vec(),
            None => exit.position.into_iter().chain(exit.velocity).collect(),
        };
        for (k, got) in state.iter().enumerate() {
            let want = number(row[7 + k]);
            let size = (0..3).map(|j| number(row[7 + k / 3 * 3 + j]).abs()).fold(0.0, f64::max);
            assert!((got - want).abs() <= 1e-9 * size, "{} {k}: {got} {want}", row[0]);
        }
        let re = c.medium.reynolds(&c.particle, state[3..].iter().map(|v| v * v).sum::<f64>().sqrt());
        close(re, number(row[13]), 1e-9, row[0]);
    }
}

#[test]
fn run_up_with_a_swinging_cup() {
    for row in table!("runup_cases") {
        let n = |i: usize| number(row[i]);
        let medium = Medium {
            added_mass: n(8),
            drag: if row[9] == "stokes" { Drag::Stokes } else { Drag::SchillerNaumann },
            volume_fraction: n(10),
            hindered_exponent: n(11),
            ..Medium::new(n(7), n(5))
        };
        let speed = n(12) * std::f64::consts::PI / 30.0;
        let cup = SwingingCup { hinge: n(1), body: Hanging::point(1.0, n(14)), damping: n(15), gravity: 9.80665 };
        let journey = Journey {
            medium,
            particle: Particle { radius: n(4), density: n(6) },
            ramp: Ramp::Smooth(speed, n(13)),
            tilt: Tilt::Swinging(cup),
            vessel: Cylinder { radius: n(2), bottom: n(3), top: 0.0 }.into(),
        };
        let path: Vec<Vec<&str>> = table!("runup_trajectories").into_iter().filter(|r| r[0] == row[0]).collect();
        let times: Vec<f64> = path.iter().map(|r| number(r[1])).filter(|&t| t < n(19) * (1.0 - 1e-9)).collect();
        let arrival = journey.follow(journey.start([n(16), n(17), n(18)]), 5.0 * n(19), 1e-12, &times).unwrap();
        let exit = arrival.exit.unwrap();
        close(exit.time, n(19), 1e-9, row[0]);
        assert_eq!(exit.surface.word(), row[20], "{}", row[0]);
        assert_eq!(arrival.moments.len(), times.len());
        for (m, want) in arrival.moments.iter().zip(&path) {
            close(journey.ramp.at(m.t).0 * 30.0 / std::f64::consts::PI, number(want[2]), 1e-10, "speed");
            // the times of the table have twelve digits
            for (got, k, size) in [(m.state[6], 3, 1.0), (m.state[7], 4, 10.0)] {
                assert!((got - number(want[k])).abs() < 1e-9 * size, "{want:?}: {got}");
            }
            let sizes = [n(3), n(3) * 10.0];
            for k in 0..6 {
                let w = number(want[5 + k]);
                assert!((m.state[k] - w).abs() < 1e-9 * sizes[k / 3], "{} t {} {k}: {} {w}", row[0], m.t, m.state[k]);
            }
            assert!((cup.equilibrium(journey.ramp.at(m.t).0) - number(want[11])).abs() < 1e-10);
        }
    }
}

/// Mirror images: turning the other way round mirrors the motion across the plane of the cup.
#[test]
fn mirrored_motion() {
    let (c, _) = case("P4_inertial_r0_0.5mm_45deg");
    let r = c.medium.rates(&c.particle);
    let other = Steady { speed: -c.steady.speed, ..c.steady };
    let mirrored = [c.start[0], c.start[1], -c.start[2]];
    for t in [0.0, 1e-3, 0.02, 0.1] {
        let (a, b) = (Closed::new(&r, &c.steady, c.start, [0.0; 3]).at(t), Closed::new(&r, &other, mirrored, [0.0; 3]).at(t));
        for (p, q) in [(a.0, b.0), (a.1, b.1)] {
            assert!((p[0] - q[0]).abs() + (p[1] - q[1]).abs() + (p[2] + q[2]).abs() < 1e-13);
        }
    }
}

/// d/dt (|W'|^2 - kappa w^2 |W|^2)/2 = -2n |W'|^2: the Coriolis force does no work.
#[test]
fn power_balance_of_the_plane() {
    let (c, _) = case("P3_88deg_1Pas");
    let r = c.medium.rates(&c.particle);
    let path = Closed::new(&r, &c.steady, c.start, [0.0; 3]);
    let energy = |t: f64| {
        let (x, v) = path.at(t);
        let (w, dw) = (c.steady.plane(x).0, c.steady.plane_rate(v).0);
        (0.5 * (dw.norm_sqr() - r.kappa * c.steady.speed.powi(2) * w.norm_sqr()), dw.norm_sqr())
    };
    for t in [1e-3, 4e-3, 8e-3] {
        let h = 1e-5;
        let slope = |h: f64| (energy(t + h).0 - energy(t - h).0) / (2.0 * h);
        let rate = (4.0 * slope(h) - slope(2.0 * h)) / 3.0;
        close(rate, -r.two_n * energy(t).1, 1e-7, "power");
    }
}

/// Nothing moves without buoyancy; without spin a particle falls by Stokes' law; the wall can be grazed.
#[test]
fn limits() {
    let vessel = Cylinder { radius: 0.02, bottom: 0.1, top: 0.0 };
    let steady = Steady { speed: 100.0, tilt: 1.2, hinge: 0.1, gravity: 9.80665 };
    let medium = Medium::new(1000.0, 1e-3);
    let neutral = medium.rates(&Particle { radius: 1e-5, density: 1000.0 });
    assert_eq!(neutral.sedimentation, 0.0);
    let start = [0.001, 0.05, 0.002];
    let path = Closed::new(&neutral, &steady, start, [0.0; 3]);
    assert!((0..3).all(|k| (path.at(1e4).0[k] - start[k]).abs() < 1e-12));
    assert!(first_exit(&path, &vessel, f64::INFINITY).is_none());
    // upright and still: the bottom after (L - y)/v_g
    let heavy = medium.rates(&Particle { radius: 1e-5, density: 2650.0 });
    let still = Steady { speed: 0.0, tilt: 0.0, ..steady };
    let exit = first_exit(&Closed::new(&heavy, &still, start, [0.0; 3]), &vessel, 1.0).unwrap();
    let stokes = 0.05 / (heavy.sedimentation * 9.80665);
    assert_eq!(exit.surface, Surface::Bottom);
    close(exit.time, stokes + 1.0 / heavy.two_n, 1e-12, "fall");
}
