//! The pendulum: conservation, stationary state and its modes, harmonic balance and Floquet exponents against time.

use super::pendulum::*;
use super::tools::{advance, contained, map, relative};
use crate::common::base::request;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*};
use laval::solve::co_rotating::turning;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::{Response, respond};
use laval::solve::harmonic::stability::floquet::{Method, Stability};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::pencil::modes_about;
use laval::solve::programme::{Programme, Shape};
use laval::solve::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::continuation::Zero;
use laval_num::dense::Mat;
use laval_num::ode::{Control, Dop853, End, integrate};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::atomic::AtomicBool;

#[derive(Clone, Copy)]
struct Case {
    isotropic: bool,
    damping: f64,
    drag: f64,
    hinge_phase: f64,
    stiffness: [f64; 2],
    free: bool,
}

const CASE: Case = Case { isotropic: true, damping: 30.0, drag: 2e-3, hinge_phase: 0.5, stiffness: [4e5; 2], free: false };

fn machine(case: Case) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let bearing = if case.isotropic { BearingCubic::isotropic(link()) } else { BearingCubic::per_axis(link()) };
    let disc = DiscParams { eccentricity: 2e-4, polar_inertia: 0.02, ..DiscParams::new(4.0) };
    let arm = PendulumParams { mass: 0.05, arm: 0.03, hinge: 0.05, hinge_phase: case.hinge_phase, drag: case.drag };
    let b = Builder::new("pendulum")
        .speed(150.0)
        .part("disc", Disc::planar(), disc)
        .part("bearing", bearing, BearingCubicParams { stiffness: case.stiffness, cubic_stiffness: [3e11; 2], valid_to: 0.0 })
        .part("air", Damper::fixed(link()), DamperParams { damping: [case.damping; 2], tilt_damping: 0.0 })
        .part("arm", Pendulum(Attach::on("disc")), arm);
    if case.free { b.free_spin() } else { b }.build().unwrap()
}

/// Angular momentum about the axis, from the definition.
fn momentum(y: &[f64]) -> f64 {
    let (z, v) = (c(y[0], y[1]), c(y[3], y[4]));
    let (theta, rate, phase, speed) = (y[2], y[5], y[6], y[7]);
    let (e, b, l) = (C64::cis(phase).scale(2e-4), C64::cis(phase + CASE.hinge_phase).scale(0.05), C64::cis(phase + theta).scale(0.03));
    let disc = ((z + e).conj() * (v + e.mul_i().scale(speed))).im * 4.0 + 0.02 * speed;
    let arm = (z + b + l).conj() * (v + b.mul_i().scale(speed) + l.mul_i().scale(speed + rate));
    disc + 0.05 * arm.im
}

#[test]
fn free_spin_keeps_energy_and_angular_momentum() {
    let system = machine(Case { damping: 0.0, free: true, ..CASE });
    let mut motion = Motion::new(&system, SpinLaw::Free).unwrap();
    motion.keep_account().unwrap();
    let mut y = vec![1e-3, -5e-4, 0.9, 0.05, 0.1, 20.0, 0.3, 150.0, 0.0, 0.0, 0.0, 0.0];
    let (before, turning) = (motion.stored_energy(0.0, &y).unwrap(), momentum(&y));
    let control = Control::new(1e-13, 1e-14);
    let run = integrate(&mut Dop853::new(), &mut motion, 0.0, &mut y, 0.5, &control, &mut ());
    assert_eq!(run.end, End::Reached);
    let k = motion.account_start().unwrap();
    let heat = y[k];
    assert!(heat > 1e-3 * before, "the hinge warms: {heat} of {before}");
    let balance = motion.stored_energy(run.t, &y).unwrap() - before + heat - y[k + 1] - y[k + 2] - y[k + 3];
    assert!(balance.abs() < 1e-9 * before, "{balance:e} of {before}");
    let lost = momentum(&y) - turning;
    assert!(lost.abs() < 1e-12 * turning, "{lost:e} of {turning}");
    assert!((y[7] - 150.0).abs() > 0.02, "the spin moves: {}", y[7]);
}

#[test]
fn prescribed_spin_balances_drive_and_heat() {
    let system = machine(Case { isotropic: false, ..CASE });
    let law = SpinLaw::Programme(Programme::ramp(150.0, 220.0, 0.3, Shape::Smooth, 0.4).unwrap());
    let mut motion = Motion::new(&system, law).unwrap();
    motion.keep_account().unwrap();
    let mut y = vec![1e-3, -5e-4, 0.9, 0.05, 0.1, 20.0, 0.0, 0.0, 0.0, 0.0];
    let before = motion.stored_energy(0.0, &y).unwrap();
    let control = Control::new(1e-12, 1e-13);
    let run = integrate(&mut Dop853::new(), &mut motion, 0.0, &mut y, 0.5, &control, &mut ());
    assert_eq!(run.end, End::Reached);
    let k = motion.account_start().unwrap();
    let after = motion.stored_energy(run.t, &y).unwrap();
    let balance = after - before + y[k] - y[k + 1] - y[k + 2] - y[k + 3];
    assert!(y[k] > 0.01 && y[k + 2].abs() > 1.0, "heat {} drive {}", y[k], y[k + 2]);
    assert!(balance.abs() < 1e-9 * after, "{balance:e} of {after}");
}

/// The arm lies in line with the hinge and points outwards; forces balance by hand.
#[test]
fn stationary_state_is_the_one_on_paper() {
    let (system, w) = (machine(CASE), 150.0);
    let at = turning(&system, w, None).unwrap();
    let (z, theta) = (c(at.q[0], at.q[1]), at.q[2]);
    let hinge = z + C64::cis(CASE.hinge_phase).scale(0.05);
    let arm = C64::cis(theta);
    assert!((arm.conj() * hinge).im.abs() < 1e-14 && (arm.conj() * hinge).re > 0.0, "{theta}");
    let spring = 4e5 + 3e11 * z.norm_sqr();
    let air = c(0.0, 30.0 * w);
    let rows = z * (air + c(spring - 4.0 * w * w, 0.0)) - c(4.0 * 2e-4 * w * w, 0.0) - (hinge + arm.scale(0.03)).scale(0.05 * w * w);
    assert!(rows.abs() < 1e-10 * spring * z.abs(), "{rows:?}");
}

/// Eigenvalues about the turning state, exponents of the harmonic balance and the map of disturbances in time agree.
#[test]
fn modes_about_the_turning_state() {
    let (system, w) = (machine(CASE), 150.0);
    let at = turning(&system, w, None).unwrap();
    let spectrum = modes_about(&system, &at, false).unwrap();
    let modes: Vec<C64> = spectrum.modes.iter().map(|m| m.value).flat_map(|s| [s, s.conj()]).collect();
    assert_eq!(spectrum.modes.len(), 3);
    // a tenth of a turn, so that no frequency is aliased; the machine turns along
    let time = 0.1 * TAU / w;
    let v = [-w * at.q[1], w * at.q[0], 0.0];
    let y: Vec<f64> = at.q.iter().copied().chain(v).collect();
    let end = advance(&system, w, &y, (0.0, time));
    let mut turned = at.q.clone();
    system.turn(&mut turned, w * time);
    assert!(relative(&end[..3], &turned) < 1e-10);
    let multipliers = laval_num::eig::eigenvalues(&map(&system, w, &y, time, w * time)).unwrap();
    let from_time: Vec<C64> = multipliers.iter().map(|z| z.ln().scale(1.0 / time)).collect();
    contained(&modes, &from_time, 1e-5 * w);

    let response = respond_to(&system, (140.0, 160.0));
    assert_eq!(response.discretisation.symmetry, Symmetry::Circular);
    let (x, exponents, method, _) = state(&system, &response, w);
    assert_eq!(method, Method::Rotating);
    contained(&modes, &exponents, 1e-8 * w);
    let orbit = orbit(&system, &response, &x, w);
    let mut q = [[0.0; 3]; 4];
    let [q0, v0, a0, _] = &mut q;
    orbit.at(0.0, q0, v0, a0, &mut []);
    assert!(relative(q0, &at.q) < 1e-11, "{q0:?} {:?}", at.q);
}

fn respond_to(system: &System, speeds: (f64, f64)) -> Response {
    static NEVER: AtomicBool = AtomicBool::new(false);
    respond(system, &request(speeds.0, speeds.1), &NEVER, &|_| {}).unwrap()
}

/// The state of the first branch corrected at a speed: unknowns, exponents, how they were found and their error.
fn state(system: &System, response: &Response, w: f64) -> (Vec<f64>, Vec<C64>, Method, f64) {
    let mut balance = Balance::new(system, response.discretisation, (w, 1.1 * w), None).unwrap();
    let points = &response.branches[0].points;
    let near = points.iter().min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs())).unwrap();
    let mut x = near.x.clone();
    let options = laval_num::newton::Options { to_rounding: true, ..Default::default() };
    laval_num::newton::newton(&mut balance, &mut x, w, &options).unwrap();
    let n = balance.dim();
    let (mut r, mut jac) = (vec![0.0; n], Mat::zeros(n, n));
    balance.eval(&x, w, &mut r, Some(&mut jac), None).unwrap();
    let e = Stability::new(system).unwrap().exponents(&mut balance, &x, w).unwrap();
    (x, e.values, e.method, e.error)
}

fn orbit(system: &System, response: &Response, x: &[f64], w: f64) -> Orbit {
    Orbit::of(&mut Balance::new(system, response.discretisation, (w, 1.1 * w), None).unwrap(), x, w).unwrap()
}

/// On an anisotropic bearing the pendulum swings: harmonic balance with its mass that depends on the angle, against time, in all symmetries.
#[test]
fn swinging_pendulum_against_time() {
    let quarter = Case { isotropic: false, ..CASE };
    let half = Case { stiffness: [4e5, 6e5], ..quarter };
    for (case, symmetry, parts, angle) in [(quarter, Symmetry::Quarter, 4.0, FRAC_PI_2), (half, Symmetry::Half, 2.0, 2.0 * FRAC_PI_2)] {
        let (system, w) = (machine(case), 260.0);
        let response = respond_to(&system, (200.0, 300.0));
        assert_eq!(response.discretisation.symmetry, symmetry);
        let (x, exponents, method, error) = state(&system, &response, w);
        assert_eq!(method, Method::Map);
        let orbit = orbit(&system, &response, &x, w);
        let (mut q, mut v, mut a) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        orbit.at(0.0, &mut q, &mut v, &mut a, &mut []);
        let y: Vec<f64> = q.iter().chain(&v).copied().collect();
        for part in [0.37, 1.0] {
            let end = advance(&system, w, &y, (0.0, part * TAU / w));
            orbit.at(part * TAU, &mut q, &mut v, &mut a, &mut []);
            assert!(relative(&end[..2], &q[..2]) < 1e-7 && (end[2] - q[2]).abs() < 1e-7, "{symmetry:?} {end:?} {q:?} {v:?}");
            assert!(relative(&end[3..5], &v[..2]) < 1e-7, "{symmetry:?} {end:?} {v:?}");
        }
        let swing: f64 = (0..40)
            .map(|k| {
                orbit.at(TAU * f64::from(k) / 40.0, &mut q, &mut v, &mut a, &mut []);
                (q[2] - CASE.hinge_phase).abs()
            })
            .fold(0.0, f64::max);
        assert!(swing > 1e-4, "it swings: {swing}");
        let time = TAU / w / parts;
        let multipliers = laval_num::eig::eigenvalues(&map(&system, w, &y, time, angle)).unwrap();
        let from_time: Vec<C64> = multipliers.iter().map(|z| z.ln().scale(1.0 / time)).collect();
        contained(&exponents, &from_time, 1e-5 * w + error);
    }
}

/// The tangent of the balance and its derivative in the speed against central differences.
#[test]
fn balance_tangents_are_exact() {
    let system = machine(Case { stiffness: [4e5, 6e5], isotropic: false, ..CASE });
    let response = respond_to(&system, (200.0, 220.0));
    let mut balance = Balance::new(&system, response.discretisation, (200.0, 220.0), None).unwrap();
    super::tools::check_tangents(&mut balance, &response.branches[0].points[3].x, 211.0);
}

/// On a bearing that differs in x and y.
pub fn swinging() -> System {
    machine(Case { isotropic: false, stiffness: [4e5, 6e5], ..CASE })
}
