//! Machines in time: reference end states, exact Jacobians, energy, conserved quantities, memory states.

mod bristle;
use crate::common;
mod reference;

use common::Base;
use laval::model::blocks::{Axes, Blocks, Memory};
use laval::model::builder::Builder;
use laval::model::field::{Attach, Field, ParamValues, Values};
use laval::model::params::NoParams;
use laval::model::part::*;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};
use laval::solve::motion::{ACCOUNT, Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use laval_num::complex::c;
use laval_num::dense::Mat;
use laval_num::ode::{Control, Dop853, End, Ode, Radau, StiffOde, Tolerance, integrate};
use laval_num::scalar::Scalar;

fn constant(speed: f64) -> SpinLaw {
    SpinLaw::Programme(Programme::constant(speed, 0.0))
}

fn motion(system: &System, law: SpinLaw) -> Motion<'_> {
    Motion::new(system, law).unwrap()
}

fn explicit(m: &mut Motion, y: &mut [f64], t0: f64, t1: f64, rel: f64, abs: f64) {
    let run = integrate(&mut Dop853::new(), m, t0, y, t1, &Control::new(rel, abs), &mut ());
    assert_eq!(run.end, End::Reached);
}

fn stiff(m: &mut Motion, y: &mut [f64], t0: f64, t1: f64, rel: f64, abs: f64) {
    let run = integrate(&mut Radau::new(), m, t0, y, t1, &Control::new(rel, abs), &mut ());
    assert_eq!(run.end, End::Reached);
}

/// A two-ball pendulum on a disc: mass that depends on the configuration, spin included.
struct Ball {
    attach: Attach,
}
const BALL: f64 = 0.05;
const TRACK: f64 = 0.1;
impl Part for Ball {
    const KIND: &'static str = "test_ball";
    const DOC: &'static str = "A ball that rolls without friction on a circle around a point of the rotor.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut laval::diagnostic::Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout { own: vec![Dof::scalar("angle", "rad", 1.0)], ..Layout::point(Link::On(self.attach.clone())) }
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    // position z + r exp(i (phase + angle))
    fn residual<S: Scalar>(&self, _: &(), at: &At<S>, out: &mut Rows<S>) {
        let arm = laval_num::complex::Complex::cis(at.phase + at.q[2]).scale(S::cst(TRACK));
        let (w, dw) = (at.speed + at.v[2], at.spin_accel + at.a[2]);
        let accel = c(at.a[0], at.a[1]) + arm.mul_i().scale(dw) - arm.scale(w * w);
        let force = accel.scale(S::cst(BALL));
        let moment = (arm.conj() * force).im;
        out.force[0] += force.re;
        out.force[1] += force.im;
        out.force[2] += moment;
        *out.spin += moment;
    }
    fn energy<S: Scalar>(&self, _: &(), at: &At<S>) -> Option<Energy<S>> {
        let arm = laval_num::complex::Complex::cis(at.phase + at.q[2]).scale(S::cst(TRACK));
        let v = c(at.v[0], at.v[1]) + arm.mul_i().scale(at.speed + at.v[2]);
        Some(Energy { stored: v.norm_sqr().scale(0.5 * BALL), ..Energy::zero() })
    }
}

fn ball_machine(free: bool, damped: bool) -> System {
    let joint = Link::Between(Attach::on("drum"), Attach::ground());
    let mut b = Builder::new("balls")
        .speed(120.0)
        .part("drum", Disc::planar(), DiscParams { eccentricity: 2e-3, polar_inertia: 0.01, ..DiscParams::new(2.0) })
        .part(
            "spring",
            BearingCubic::isotropic(joint.clone()),
            BearingCubicParams { stiffness: [4e4; 2], cubic_stiffness: [1e9; 2], valid_to: 0.0 },
        )
        .part("ball", Ball { attach: Attach::on("drum") }, ());
    if damped {
        b = b.part("oil", Damper::fixed(joint.clone()), DamperParams { damping: [30.0; 2], tilt_damping: 0.0 });
        b = b.part("inner", Damper::rotating(joint), DamperParams { damping: [5.0; 2], tilt_damping: 0.0 });
    }
    if free { b.free_spin() } else { b }.build().unwrap()
}

fn tilting(horizontal: bool) -> System {
    let disc = DiscParams {
        eccentricity: 1e-3,
        eccentricity_phase: 0.4,
        polar_inertia: 0.02,
        diametral_inertia: 0.013,
        skew: 0.01,
        skew_phase: 1.0,
        centre_of_mass: 0.03,
        ..DiscParams::new(2.0)
    };
    let link = |z| Link::Between(Attach::at("drum", z), Attach::ground());
    let bearing = |k: f64| BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [2e9; 2], valid_to: 0.0 };
    let b = Builder::new("tilting")
        .speed(200.0)
        .part("drum", Disc::tilting(), disc)
        .part("lower", BearingCubic::isotropic(link(-0.1)), bearing(3e4))
        .part("upper", BearingCubic::isotropic(link(0.15)), bearing(5e4))
        .part("oil", Damper::fixed(link(0.1)), DamperParams { damping: [20.0; 2], tilt_damping: 0.0 })
        .part("inner", Damper::rotating(link(0.05)), DamperParams { damping: [10.0; 2], tilt_damping: 0.0 });
    if horizontal { b.horizontal() } else { b }.build().unwrap()
}

fn scattered(n: usize, seed: u64) -> Vec<f64> {
    let mut s = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    (0..n)
        .map(|_| {
            s ^= s << 13;
            s ^= s >> 7;
            s ^= s << 17;
            (s >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        })
        .collect()
}

/// A state of plausible size.
fn random_state(m: &Motion, seed: u64) -> Vec<f64> {
    let n = m.system().n();
    let mut y = scattered(m.dim(), seed);
    for (i, y) in y.iter_mut().enumerate() {
        *y *= if i < n { 1e-3 } else { 1.0 };
    }
    if let Some(k) = m.spin_start() {
        y[k + 1] += 150.0;
    }
    y
}

fn all_machines() -> Vec<(System, SpinLaw)> {
    let ramp = || SpinLaw::Programme(Programme::ramp(100.0, 900.0, 0.3, Shape::Smooth, 0.2).unwrap());
    let liquid = || Base { fill: Some(0.7), wave_damping: 3.0, ..Base::default() };
    vec![
        (liquid().builder().build().unwrap(), constant(900.0)),
        (liquid().builder().build().unwrap(), ramp()),
        (
            liquid()
                .builder()
                .part("flywheel", Disc::planar(), DiscParams { polar_inertia: 0.3, ..DiscParams::new(1.0) })
                .free_spin()
                .build()
                .unwrap(),
            SpinLaw::Free,
        ),
        (ball_machine(false, true), constant(120.0)),
        (ball_machine(false, true), ramp()),
        (ball_machine(true, true), SpinLaw::Free),
        (tilting(false), constant(200.0)),
        (tilting(false), ramp()),
        (tilting(true), ramp()),
        (liquid().builder().horizontal().build().unwrap(), constant(900.0)),
        (with_memory(3, 1e3), constant(300.0)),
        (with_memory(3, 1e3), ramp()),
        (bristle::machine(false), constant(300.0)),
        (bristle::machine(true), constant(300.0)),
        (bristle::machine(false), ramp()),
    ]
}

#[test]
fn jacobian_is_the_derivative_of_the_right_side() {
    for (k, (system, law)) in all_machines().into_iter().enumerate() {
        let mut m = motion(&system, law);
        let (t, y) = (0.11, random_state(&m, k as u64 + 1));
        let n = m.dim();
        let mut jac = Mat::zeros(n, n);
        m.jacobian(t, &y, &mut jac).unwrap();
        let mut f = |y: &[f64]| {
            let mut d = vec![0.0; n];
            m.rhs(t, y, &mut d).unwrap();
            d
        };
        let scale = jac.max_size();
        for j in 0..n {
            let h = if j < system.n() { 1e-6 } else { 1e-3 };
            // fourth order
            let side = |s: f64| {
                let mut w = y.clone();
                w[j] += s * h;
                w
            };
            let (a, b, c, d) = (f(&side(-2.0)), f(&side(-1.0)), f(&side(1.0)), f(&side(2.0)));
            for i in 0..n {
                let numeric = (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h);
                let size = jac.row(i).iter().fold(1e-9 * scale, |s, x| s.max(x.abs()));
                assert!((numeric - jac[(i, j)]).abs() < 2e-6 * size, "machine {k} ({i}, {j}): {numeric:e} {:e}", jac[(i, j)]);
            }
        }
    }
}

#[test]
fn compiled_form_equals_the_general_one() {
    for (k, (system, law)) in all_machines().into_iter().enumerate() {
        let SpinLaw::Programme(p) = law else { continue };
        let speed = p.at(0.05).speed;
        let mut a = motion(&system, constant(speed));
        let mut b = motion(&system, SpinLaw::Programme(Programme::table(&[0.0, 1.0], &[speed; 2], 0.0).unwrap()));
        let y = random_state(&a, k as u64 + 77);
        let (mut da, mut db) = (vec![0.0; a.dim()], vec![0.0; b.dim()]);
        a.rhs(0.3, &y, &mut da).unwrap();
        b.rhs(0.3, &y, &mut db).unwrap();
        let size = da.iter().fold(0.0f64, |s, x| s + x.abs());
        for (x, y) in da.iter().zip(&db) {
            assert!((x - y).abs() < 1e-13 * size, "machine {k}: {x:e} {y:e}");
        }
    }
}

/// Memory of a spring with relaxing branches, in rotor and fixed axes.
struct Relaxing {
    link: Link,
    states: usize,
    fastest: f64,
}
impl Part for Relaxing {
    const KIND: &'static str = "test_relaxing";
    const DOC: &'static str = "A spring with branches that relax.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut laval::diagnostic::Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let mut layout = Layout::point(self.link.clone());
        for k in 0..self.states {
            layout.states.extend(Dof::pair(&format!("m{k}_"), DofKind::VectorX, "m s", 1e-6));
        }
        layout
    }
    fn memory(&self) -> usize {
        2 * self.states
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn linear<S: Scalar>(&self, _: &(), _: S, b: &mut Blocks<S>) {
        // instantaneous stiffness, less what relaxes
        for i in 0..2 {
            b.stiffness[(i, i)] = S::cst(8e4);
        }
        for k in 0..self.states {
            let rate = 10.0 * (self.fastest / 10.0).powf(k as f64 / (self.states - 1).max(1) as f64);
            let gain = S::cst(-4e4 / self.states as f64 * rate);
            let rotor = k % 2 == 0;
            for (i, axes) in [Axes::RotorX, Axes::RotorY].into_iter().enumerate() {
                let axes = if rotor { axes } else { Axes::Fixed };
                b.memory.push(Memory { rate: S::cst(rate), gain, input: i, output: i, axes });
            }
        }
    }
}

/// Times announced ahead change no bit, whichever of them are then requested.
#[test]
fn announced_times_change_nothing() {
    for (system, law) in all_machines() {
        let (mut a, mut b) = (motion(&system, law.clone()), motion(&system, law));
        let y = random_state(&a, 5);
        let times: Vec<f64> = (0..20).map(|k| 1e-4 * f64::from(k * k)).collect();
        a.ahead(&times);
        for t in [times[0], times[1], 0.7e-4, times[2], times[5], times[3], times[19], -1e-3] {
            let (mut da, mut db) = (vec![0.0; y.len()], vec![0.0; y.len()]);
            a.rhs(t, &y, &mut da).unwrap();
            b.rhs(t, &y, &mut db).unwrap();
            assert!(da.iter().zip(&db).all(|(a, b)| a.to_bits() == b.to_bits()), "{t} {da:?} {db:?}");
        }
    }
}

fn with_memory(states: usize, fastest: f64) -> System {
    let link = Link::Between(Attach::on("drum"), Attach::on("base"));
    Builder::new("memory")
        .part("drum", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(2.4) })
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [3e5; 2], damping: [100.0; 2] })
        .part("shaft", Relaxing { link: link.clone(), states, fastest }, ())
        .part("stop", BearingCubic::isotropic(link), BearingCubicParams { stiffness: [0.0; 2], cubic_stiffness: [1e10; 2], valid_to: 0.0 })
        .build()
        .unwrap()
}

/// 200 memory states with rates to 1e9 1/s; a branch that fast only adds `gain/rate u` to the force, which is the check.
#[test]
fn two_hundred_memory_states() {
    let system = with_memory(100, 1e9);
    let mut m = motion(&system, constant(300.0));
    assert_eq!(m.memory_states(), 200);
    let refusal = m.refuses_explicit().unwrap();
    assert!(refusal.message.contains("\"shaft\"") && refusal.help.as_deref().is_some_and(|h| *h == "use method = \"stiff\""), "{refusal}");
    let tolerance = |m: &Motion, f: f64| {
        let mut each = vec![f * 1e-3; m.dim()];
        each[4..8].fill(f * 0.3);
        each[8..].fill(f * 1e-9);
        Tolerance::Each(each)
    };
    let mut run = |f: f64| {
        let mut y = vec![0.0; m.dim()];
        y[0] = 1e-3;
        let control = Control::new(1e-4 * f, tolerance(&m, 1e-4 * f));
        let run = integrate(&mut Radau::new(), &mut m, 0.0, &mut y, 0.2, &control, &mut ());
        assert_eq!(run.end, End::Reached, "{run:?}");
        (y, run.work)
    };
    let (coarse, work) = run(1e-2);
    let (fine, _) = run(1e-6);
    assert!(work.steps < 2000, "{work:?}");
    for i in 0..4 {
        assert!((coarse[i] - fine[i]).abs() < 1e-5 * fine[0].hypot(fine[1]), "{i} {:e} {:e}", coarse[i], fine[i]);
    }
    // the fastest branch follows its input: z = u / rate
    let k = 8 + 2 * 99;
    let u = fine[0] - fine[2];
    assert!((fine[k] * 1e9 - u).abs() < 1e-4 * u.abs());
}

/// The eliminated solve is the dense one.
#[test]
fn elimination_solves_the_dense_system() {
    use laval_num::dense::Lu;
    use laval_num::ode::DenseSolver;
    let ramp = SpinLaw::Programme(Programme::ramp(100.0, 900.0, 0.3, Shape::Smooth, 0.2).unwrap());
    let system = with_memory(6, 1e4);
    let mut m = motion(&system, ramp);
    let (n, y) = (m.dim(), random_state(&m, 5));
    let mut jac = Mat::zeros(n, n);
    m.jacobian(0.1, &y, &mut jac).unwrap();
    let (real, complex) = (350.0, c(270.0, -310.0));
    let mut unused = DenseSolver::default();
    m.linearise(0.1, &y, &mut unused).unwrap();
    m.factor(real, complex, &mut unused).unwrap();
    let b = scattered(n, 9);
    let mut x = b.clone();
    m.solve_real(&mut x, &unused);
    let mut want = b.clone();
    Lu::new(&Mat::from_fn(n, n, |i, j| if i == j { real } else { 0.0 } - jac[(i, j)])).unwrap().solve(&mut want);
    let size = want.iter().fold(0.0f64, |s, x| s.max(x.abs()));
    assert!(x.iter().zip(&want).all(|(a, b)| (a - b).abs() < 1e-10 * size));
    let mut x: Vec<_> = b.iter().map(|&x| c(x, 0.5 * x)).collect();
    let mut want = x.clone();
    m.solve_complex(&mut x, &unused);
    Lu::new(&Mat::from_fn(n, n, |i, j| if i == j { complex } else { c(0.0, 0.0) } - c(jac[(i, j)], 0.0))).unwrap().solve(&mut want);
    let size = want.iter().fold(0.0f64, |s, x| s.max(x.abs()));
    assert!(x.iter().zip(&want).all(|(a, b)| (*a - *b).abs() < 1e-10 * size));
}

/// Stored energy changes by what the account says, whatever the spin does.
#[test]
fn energy_account_closes() {
    for (k, (system, law)) in all_machines().into_iter().enumerate() {
        let mut m = motion(&system, law);
        if let Err(part) = m.keep_account() {
            assert_eq!(part, "shaft", "machine {k}");
            continue;
        }
        let mut y = random_state(&m, k as u64 + 3);
        let s = m.account_start().unwrap();
        y[s..].fill(0.0);
        let before = m.stored_energy(0.0, &y).unwrap();
        let mut dy = vec![0.0; m.dim()];
        m.rhs(0.05, &y, &mut dy).unwrap();
        let start = y.clone();
        // the smooth ramp has a knot at its end: stay inside
        explicit(&mut m, &mut y, 0.0, 0.1, 1e-13, 1e-13);
        let after = m.stored_energy(0.1, &y).unwrap();
        let [heat, sources, drive, weight] = [y[s], y[s + 1], y[s + 2], y[s + 3]];
        let exchanged = heat.abs() + sources.abs() + drive.abs() + weight.abs() + (after - before).abs();
        let missing = after - before - (-heat + sources + drive + weight);
        assert!(exchanged > 1e-6, "machine {k}: {start:?}");
        assert!(missing.abs() < 1e-9 * exchanged, "machine {k}: {missing:e} of {exchanged:e}: {before} {after} {:?}", &y[s..]);
        assert_eq!(m.dim(), s + ACCOUNT);
    }
}

/// Without friction or supports that hold a moment, a freely spinning machine keeps its angular momentum, balls and eccentricity included.
#[test]
fn angular_momentum_of_a_free_rotor_is_conserved() {
    let system = ball_machine(true, false);
    let mut m = motion(&system, SpinLaw::Free);
    let mut y = vec![0.0; m.dim()];
    let k = m.spin_start().unwrap();
    (y[0], y[1], y[2], y[5], y[k + 1]) = (3e-3, -1e-3, 0.7, -40.0, 120.0);
    let momentum = |y: &[f64]| {
        let (z, v) = (c(y[0], y[1]), c(y[3], y[4]));
        let (angle, rate, phase, speed) = (y[2], y[5], y[k], y[k + 1]);
        let at = |r: f64, phi: f64, w: f64, mass: f64| {
            let arm = laval_num::complex::Complex::<f64>::cis(phi).scale(r);
            ((z + arm).conj() * (v + arm.mul_i().scale(w))).im * mass
        };
        // the disc's own inertia is about its centre of mass
        0.01 * speed + at(2e-3, phase, speed, 2.0) + at(TRACK, phase + angle, speed + rate, BALL)
    };
    let before = momentum(&y);
    explicit(&mut m, &mut y, 0.0, 1.0, 1e-14, 1e-16);
    let after = momentum(&y);
    assert!((after - before).abs() < 1e-12 * before.abs(), "{before} {after} {:e}", after / before - 1.0);
    assert!((y[k + 1] - 120.0).abs() > 1e-2, "the balls exchange angular momentum with the rotor");
    assert!(m.torque(1.0, &y).unwrap().abs() < 1e-9);
}

/// The liquid's force is the rate of its momentum at any speed: a rotor and its liquid without supports keep theirs.
#[test]
fn liquid_keeps_its_momentum_while_the_speed_changes() {
    let disc = DiscParams { eccentricity: 0.0, ..DiscParams::new(2.4) };
    let (radius, free) = (0.07f64, 0.05f64);
    let liquid = LiquidParams { wave_damping: 0.0, ..LiquidParams::new(radius, 0.06, 1000.0, free) };
    let system = Builder::new("free")
        .part("drum", Disc::planar(), disc)
        .part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), liquid)
        .build()
        .unwrap();
    let programme = Programme::ramp(200.0, 800.0, 0.2, Shape::Smooth, 0.0).unwrap();
    let mut m = motion(&system, SpinLaw::Programme(programme.clone()));
    let mut y = vec![1e-3, -2e-3, 0.3, 0.1, 0.05, 0.02, 5e-4, -3e-4];
    let full = std::f64::consts::PI * radius * radius * 0.06 * 1000.0;
    let outer = full * (free / radius).powi(2);
    // m v + m_l v - m_o eta'
    let momentum = |t: f64, y: &[f64]| {
        let w = programme.at(t).speed;
        let rate = c(y[6], y[7]).mul_i().scale(w) - c(y[4], y[5]);
        c(y[2], y[3]).scale(2.4 + full - outer) - rate.scale(outer)
    };
    let before = momentum(0.0, &y);
    explicit(&mut m, &mut y, 0.0, 0.2, 1e-14, 1e-17);
    let after = momentum(0.2, &y);
    assert!((after - before).abs() < 1e-12 * before.abs(), "{before:?} {after:?}");
}

/// Undamped motion runs backwards into itself.
#[test]
fn undamped_motion_is_reversible() {
    let system = Base { chi: 0.0, chi0: 0.0, fill: Some(0.8), ..Base::default() }.builder().build().unwrap();
    let mut m = motion(&system, constant(1500.0));
    let mut y = random_state(&m, 4);
    for z in &mut y[8..] {
        *z *= 1e-3;
    }
    let start = y.clone();
    explicit(&mut m, &mut y, 0.0, 0.02, 1e-13, 1e-16);
    assert!((y[0] - start[0]).abs() > 1e-5);
    explicit(&mut m, &mut y, 0.02, 0.0, 1e-13, 1e-16);
    for (i, (a, b)) in y.iter().zip(&start).enumerate() {
        let size = if i < 4 { 1e-3 } else { 1.0 };
        assert!((a - b).abs() < 1e-9 * size, "{i} {a:e} {b:e}");
    }
}

/// Turning the start and the phase turns the motion (isotropic laws).
#[test]
fn motion_turns_with_its_start() {
    let system = Base { fill: Some(0.8), isotropic: true, ..Base::default() }.builder().build().unwrap();
    let (angle, speed) = (0.83, 1700.0);
    let mut a = motion(&system, constant(speed));
    let mut b = motion(&system, SpinLaw::Programme(Programme::constant(speed, angle)));
    let turn = |y: &mut [f64]| {
        system.turn(&mut y[..4], angle);
        system.turn(&mut y[4..8], angle);
        system.turn_states(&mut y[8..12], angle);
    };
    let mut y = vec![1e-4, 2e-4, 0.0, -1e-4, 0.1, 0.0, 0.0, 0.05, 1e-2, 0.0, 1e-5, -1e-5];
    let mut w = y.clone();
    turn(&mut w);
    explicit(&mut a, &mut y, 0.0, 0.03, 1e-12, 1e-15);
    explicit(&mut b, &mut w, 0.0, 0.03, 1e-12, 1e-15);
    turn(&mut y);
    for (x, w) in y.iter().zip(&w) {
        assert!((x - w).abs() < 1e-10 * x.abs().max(1e-3), "{x:e} {w:e}");
    }
}

#[test]
fn explicit_and_stiff_methods_agree() {
    for (k, (system, law)) in all_machines().into_iter().enumerate() {
        if system.slot("shaft").is_some() {
            continue;
        }
        let mut m = motion(&system, law);
        let start = random_state(&m, k as u64 + 40);
        let (mut a, mut b) = (start.clone(), start);
        explicit(&mut m, &mut a, 0.0, 0.05, 1e-11, 1e-13);
        stiff(&mut m, &mut b, 0.0, 0.05, 1e-9, 1e-11);
        let n = system.n();
        let size = a[..n].iter().fold(0.0f64, |s, x| s.max(x.abs()));
        for i in 0..n {
            assert!((a[i] - b[i]).abs() < 1e-6 * size, "machine {k} coordinate {i}: {:e} {:e}", a[i], b[i]);
        }
    }
}

/// A body without mass is named.
#[test]
fn singular_mass_names_its_coordinate() {
    let ball = ball_machine(false, false);
    assert!(Motion::new(&ball, SpinLaw::Free).is_ok());
    // a point mass on an arm has only two coordinates' worth of inertia, whatever the rounding says
    for e in [1e-3, 1.1e-3, 0.37e-3] {
        let system = Base { e, phase: 0.3, ..Base::default() }.builder().build().unwrap();
        let d = Motion::new(&system, SpinLaw::Free).err().unwrap();
        assert!(d.message.contains("singular"), "{d}");
    }
    let system = Base { e: 0.0, ..Base::default() }.builder().build().unwrap();
    let d = Motion::new(&system, SpinLaw::Free).err().unwrap();
    assert!(d.message.contains("the spin angle"), "{d}");
}

/// A frequency-domain part without a time form is refused by name and reason.
struct NoTime(Link);
impl Part for NoTime {
    const KIND: &'static str = "test_table";
    const DOC: &'static str = "Coefficients over frequency.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut laval::diagnostic::Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(self.0.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Frequency(TimeForm::None("its coefficients are a table over frequency"))
    }
}

#[test]
fn frequency_only_parts_are_refused() {
    let link = Link::Between(Attach::on("drum"), Attach::ground());
    let system = Base::default().builder().part("film", NoTime(link), ()).build().unwrap();
    let d = Motion::new(&system, constant(100.0)).err().unwrap();
    assert!(d.message.contains("\"film\"") && d.message.contains("a table over frequency"), "{d}");
}

/// Asked for an explicit method, a machine with memory says which part forbids it; left to itself it takes the implicit one.
#[test]
fn memory_needs_the_implicit_method() {
    use laval::solve::motion::trajectory::{Choice, Plan, simulate};
    let system = with_memory(20, 1e7);
    let mut m = motion(&system, constant(300.0));
    let y = vec![0.0; m.dim()];
    let mut plan = Plan {
        t_end: 0.02,
        choice: Choice::Explicit,
        relative: 1e-6,
        absolute: 1e-6,
        outputs: &[0.0, 0.01, 0.02],
        windows: 10,
        rest: &[],
        bound: f64::INFINITY,
        kick: None,
        max_steps: 10_000,
        cancel: &|| false,
        progress: &|_| {},
    };
    let d = simulate(&mut m, &y, &plan).err().unwrap();
    assert!(d.message.contains("\"shaft\"") && d.help.as_deref().is_some_and(|h| *h == "use method = \"stiff\""), "{d}");
    plan.choice = Choice::Auto;
    let f = simulate(&mut m, &y, &plan).unwrap();
    assert!(f.stiff && f.run.end == End::Reached && f.times == [0.0, 0.01, 0.02]);
    assert_eq!(f.states.len(), 3 * m.dim());
}
