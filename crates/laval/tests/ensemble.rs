//! Ensembles against single motions: every form of the equations, other parameters in every lane, neighbours that fail, threads and levels.

mod common;
#[path = "hard_parts/pendulum.rs"]
mod pendulum;

use common::Planar;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{balancer_ball::*, bearing_linear::*, disc::*, liquid::*, motor::*, shaft_lumped::*, stop::*};
use laval::solve::ensemble::{self, Ended, EnsembleTask, Form, Grid, Leg, LegEnd, Method, Next, Settings, Start};
use laval::solve::motion::trajectory::{Choice, Plan, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use laval_num::lanes::Level;
use pendulum::*;
use std::sync::Arc;

/// A member: machine, spin, start, duration.
#[derive(Clone)]
struct Member {
    system: Arc<System>,
    law: SpinLaw,
    y: Vec<f64>,
    time: f64,
}

struct Members {
    members: Vec<Member>,
    outputs: u64,
    relative: f64,
    most_steps: u64,
}

type Row = (LegEnd, Vec<f64>, Vec<(f64, f64)>);

impl EnsembleTask for Members {
    type Log = Vec<(f64, f64)>;
    type Row = Row;
    fn start(&self, index: usize) -> Result<Start<Self::Log>, Row> {
        let m = &self.members[index];
        let mut absolute = ensemble::tolerances(&m.system, 300.0, 100.0 * self.relative);
        absolute.resize(m.y.len(), 100.0 * self.relative);
        let step = m.time / self.outputs.max(1) as f64;
        let leg = Leg { outputs: Grid { start: 0.0, step, count: self.outputs }, max_steps: self.most_steps, ..Leg::new(0.0, m.time) };
        Ok(Start { system: m.system.clone(), law: m.law.clone(), y: m.y.clone(), relative: self.relative, absolute, leg, log: vec![] })
    }
    fn output(&self, log: &mut Self::Log, _: u64, t: f64, y: &[f64]) {
        log.push((t, y[0]));
    }
    fn ended(&self, _: usize, log: &mut Self::Log, ended: &Ended, y: &mut [f64]) -> Next<Row> {
        Next::Done((ended.end, y.to_vec(), std::mem::take(log)))
    }
}

fn sail(members: &[Member], form: Form, outputs: u64, settings: Settings) -> Vec<Row> {
    // the tolerance that each method reaches with steps of its own
    let relative = if settings.method == Method::Stiff { 1e-11 } else { 1e-13 };
    let all = Members { members: members.to_vec(), outputs, relative, most_steps: u64::MAX };
    ensemble::run(&all, &members[0].system, form, 0..members.len(), settings).unwrap()
}

/// The same motion by the integrator of single motions, with the states at `outputs`.
fn alone(m: &Member, outputs: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut motion = Motion::new(&m.system, m.law.clone()).unwrap();
    let plan = Plan {
        t_end: m.time,
        choice: Choice::Explicit,
        relative: 1e-13,
        absolute: 1e-11,
        outputs,
        windows: 1,
        kick: None,
        rest: &[],
        bound: f64::INFINITY,
        max_steps: u64::MAX,
        cancel: &|| false,
        progress: &|_| {},
    };
    let trajectory = simulate(&mut motion, &m.y, &plan).unwrap();
    let first = trajectory.states.chunks(m.y.len()).map(|y| y[0]).collect();
    (trajectory.state, first)
}

/// Deviation of two states over the sizes of the first's positions, velocities and so on.
fn apart(system: &System, a: &[f64], b: &[f64]) -> f64 {
    let n = system.n();
    let mut worst = 0.0f64;
    for range in [0..n, n..2 * n, 2 * n..a.len()] {
        let size = a[range.clone()].iter().fold(1e-12f64, |s, x| s.max(x.abs()));
        for i in range {
            let d = (a[i] - b[i]).abs() / size;
            // NaN stays
            worst = if d <= worst { worst } else { d };
        }
    }
    worst
}

fn constant(system: System, speed: f64, time: f64) -> Member {
    let y = vec![0.0; 2 * system.n() + system.m()];
    Member { system: Arc::new(system), law: SpinLaw::Programme(Programme::constant(speed, 0.3)), y, time }
}

/// Filled machines that differ in every parameter the lanes can hold, at other speeds and for other times.
fn filled(count: usize) -> Vec<Member> {
    let base = Planar { fill: 0.667, delta: 3.0, ..Planar::default() }.build();
    let member = |k: usize| {
        let x = k as f64;
        let overrides = [
            ("drum.mass", 2.4 + 0.1 * x),
            ("bearing.cubic_stiffness", 8.7e10 * (1.0 + 0.2 * x)),
            ("air.damping", 42.0 + 30.0 * x),
            ("liquid.wave_damping", 3.0 + x),
            ("base.stiffness.x", 3.26e5 * (1.0 + 0.05 * x)),
        ];
        let mut m = constant(base.with(&overrides).unwrap(), 150.0 + 90.0 * x, 0.02 + 0.005 * ((3 * k) % 7) as f64);
        m.y[0] = 1e-4 * x;
        m
    };
    (0..count).map(member).collect()
}

#[test]
fn compiled_members_follow_single_motions() {
    let members = filled(19);
    assert_eq!(Form::of(&members[0].system, true), Form::Constant);
    let rows = sail(&members, Form::Constant, 5, Settings::default());
    for (m, (end, y, outputs)) in members.iter().zip(&rows) {
        let times: Vec<f64> = outputs.iter().map(|o| o.0).collect();
        let (expected, first) = alone(m, &times);
        assert_eq!((*end, outputs.len()), (LegEnd::Reached, 5));
        assert!(apart(&m.system, &expected, y) < 1e-8, "{:e}", apart(&m.system, &expected, y));
        for (a, b) in first.iter().zip(outputs) {
            assert!((a - b.1).abs() < 1e-9 * 1e-2, "{a} {b:?}");
        }
    }
}

/// The stiff method finds the same motions, compiled and part by part.
#[test]
fn stiff_members_follow_single_motions() {
    let members = filled(19);
    for form in [Form::Constant, Form::Prescribed] {
        let rows = sail(&members, form, 5, Settings { method: Method::Stiff, ..Settings::default() });
        for (m, (end, y, outputs)) in members.iter().zip(&rows) {
            let times: Vec<f64> = outputs.iter().map(|o| o.0).collect();
            let (expected, first) = alone(m, &times);
            assert_eq!((*end, outputs.len()), (LegEnd::Reached, 5));
            assert!(apart(&m.system, &expected, y) < 1e-6, "{:e}", apart(&m.system, &expected, y));
            for (a, b) in first.iter().zip(outputs) {
                assert!((a - b.1).abs() < 1e-9, "{a} {b:?}");
            }
        }
    }
}

/// The general form of the same machines: another program for the same equations.
#[test]
fn both_forms_agree() {
    let members = filled(9);
    let (a, b) = (sail(&members, Form::Constant, 0, Settings::default()), sail(&members, Form::Prescribed, 0, Settings::default()));
    for ((m, a), b) in members.iter().zip(&a).zip(&b) {
        assert!(apart(&m.system, &a.1, &b.1) < 1e-8, "{:e}", apart(&m.system, &a.1, &b.1));
    }
}

fn tilting(horizontal: bool) -> Builder {
    let disc = DiscParams {
        diametral_inertia: 0.02,
        polar_inertia: 0.035,
        eccentricity: 2e-4,
        skew: 1e-3,
        centre_of_mass: 0.01,
        ..DiscParams::new(3.0)
    };
    let link = || Link::Between(Attach { body: Some("wheel".into()), position: 0.05 }, Attach::ground());
    let shaft = ShaftLumpedParams { stiffness: [3e5; 2], tilt_stiffness: 900.0, material_damping: 1e-5, ..ShaftLumpedParams::new() };
    let seal = BearingLinearParams { kxx: 1e4, kxy: 4e3, kyx: -4e3, kyy: 2e4, cxx: 90.0, cyy: 60.0, ..BearingLinearParams::new() };
    let liquid = LiquidParams { wave_damping: 1.0, ..LiquidParams::new(0.1, 0.05, 900.0, 0.07) };
    let builder = Builder::new("overhung wheel")
        .part("wheel", Disc::tilting(), disc)
        .part("shaft", ShaftLumped::with_tilt(Link::Between(Attach::on("wheel"), Attach::ground())).damped(), shaft)
        .part("seal", BearingLinear::constant(link()), seal)
        .part("liquid", Liquid::new(Attach::on("wheel"), Fill::Partial), liquid);
    if horizontal { builder.horizontal() } else { builder }
}

/// Run-ups: speed, gyroscopic, circulatory and liquid terms change within a step; with weight and without.
#[test]
fn run_ups_follow_single_motions() {
    for horizontal in [false, true] {
        let base = tilting(horizontal).build().unwrap();
        let member = |k: usize| {
            let shape = [Shape::Linear, Shape::Smooth, Shape::Exponential][k % 3];
            let law = SpinLaw::Programme(Programme::ramp(60.0 + 7.0 * k as f64, 500.0, 0.3, shape, 0.1).unwrap());
            let system = base.with(&[("wheel.polar_inertia", 0.03 + 5e-4 * k as f64)]).unwrap();
            Member { law, time: 0.25, ..constant(system, 0.0, 0.0) }
        };
        let members: Vec<Member> = (0..10).map(member).collect();
        assert_eq!(Form::of(&base, false), Form::Prescribed);
        let rows = sail(&members, Form::Prescribed, 0, Settings::default());
        for (m, (end, y, _)) in members.iter().zip(&rows) {
            assert_eq!(*end, LegEnd::Reached);
            let d = apart(&m.system, &alone(m, &[]).0, y);
            assert!(d < 1e-7, "{d:e}");
        }
    }
}

/// A pendulum on a rotor whose spin is free: the mass matrix depends on the configuration, and the spin has its row and column.
#[test]
fn free_spin_and_varying_mass_follow_single_motions() {
    for free in [true, false] {
        let pendulum = PendulumParams { mass: 0.2, arm: 0.05, hinge: 0.03, hinge_phase: 0.4, drag: 2e-3 };
        let builder = tilting(false).part("pendulum", Pendulum(Attach::on("wheel")), pendulum);
        let base = if free { builder.free_spin() } else { builder }.build().unwrap();
        let member = |k: usize| {
            let system = base.with(&[("pendulum.mass", 0.1 + 0.05 * k as f64)]).unwrap();
            let mut m = constant(system, 200.0, 0.1);
            let n = m.system.n();
            m.y[n - 1] = 0.5 + 0.3 * k as f64;
            if free {
                m.y.extend([0.2, 180.0 + 10.0 * k as f64]);
                m.law = SpinLaw::Free;
            }
            m
        };
        let members: Vec<Member> = (0..10).map(member).collect();
        let form = Form::of(&base, true);
        assert_eq!(form, if free { Form::Free } else { Form::Prescribed });
        let rows = sail(&members, form, 0, Settings::default());
        for (m, (end, y, _)) in members.iter().zip(&rows) {
            assert_eq!(*end, LegEnd::Reached);
            let d = apart(&m.system, &alone(m, &[]).0, y);
            assert!(d < 1e-7, "{d:e}");
        }
    }
}

/// Balls that touch and rings that tilt, on a body that tilts or does not, with a programme and with a motor.
#[test]
fn balancers_follow_single_motions() {
    let ring = BalancerBallParams {
        eccentricity: 1e-3,
        eccentricity_phase: 0.4,
        node_line: 1.0,
        housing_mass: 0.3,
        diametral_inertia: 2e-3,
        polar_inertia: 3e-3,
        tilt_stiffness: 20.0,
        drag: 1e-3,
        dry_torque: 1e-3,
        friction_rate: 1.0,
        ball_radius: 0.01,
        contact_stiffness: 5.0,
        ..BalancerBallParams::new(0.02, 0.1)
    };
    let balancer = || BallBalancer::new(Attach::on("wheel"), 2).track(1, 0.8, 0.02, 0.3).masses(&[1.0, 1.2, 0.7]).free().touching();
    for (balancer, free) in [(balancer(), false), (balancer().planar(), false), (balancer(), true)] {
        let motor = MotorParams { drag: 1e-3, ..MotorParams::new(0.5) };
        let builder = tilting(false).part("balancer", balancer, ring).part("motor", Motor::new(Curve::Constant), motor);
        let base = if free { builder.free_spin() } else { builder }.build().unwrap();
        let member = |k: usize| {
            let mut m = constant(base.with(&[("balancer.drag", 1e-3 * (1 + k) as f64)]).unwrap(), 200.0, 0.05);
            let n = m.system.n();
            for (y, x) in m.y[n - 3..n].iter_mut().zip([0.5, 0.8 + 0.1 * k as f64, 2.0]) {
                *y = x;
            }
            if free {
                m.y.extend([0.2, 180.0 + 10.0 * k as f64]);
                m.law = SpinLaw::Free;
            }
            m
        };
        let members: Vec<Member> = (0..10).map(member).collect();
        let rows = sail(&members, Form::of(&base, true), 0, Settings::default());
        for (m, (end, y, _)) in members.iter().zip(&rows) {
            assert_eq!(*end, LegEnd::Reached);
            let d = apart(&m.system, &alone(m, &[]).0, y);
            assert!(d < 1e-7, "{d:e}");
        }
    }
}

/// The same at constant speed on machines without internal states, where parts give their masses with their residual: tilting and planar bodies, balancers at the
/// reference point and beside it, horizontal machines, members that differ.
#[test]
fn masses_with_the_residual_are_those_of_single_motions() {
    let ring = BalancerBallParams {
        eccentricity: 1e-3,
        eccentricity_phase: 0.4,
        node_line: 1.0,
        tilt: 0.05,
        housing_mass: 0.3,
        diametral_inertia: 2e-3,
        polar_inertia: 3e-3,
        drag: 1e-3,
        dry_torque: 1e-3,
        friction_rate: 20.0,
        rolling_inertia: 0.4,
        ..BalancerBallParams::new(0.02, 0.1)
    };
    let level =
        BalancerBallParams { gravity: 0.0, tilt: 0.0, node_line: 0.0, eccentricity: 0.0, housing_mass: 0.0, dry_torque: 0.0, ..ring };
    let sprung = BalancerBallParams { tilt_stiffness: 20.0, tilt_damping: 1e-3, ..ring };
    let on = |z: f64| BallBalancer::new(Attach::at("wheel", z), 2).track(1, 0.8, 0.02, 0.3).masses(&[1.0, 1.2, 0.7]);
    let disc = DiscParams { diametral_inertia: 0.02, polar_inertia: 0.035, eccentricity: 2e-4, ..DiscParams::new(3.0) };
    let shaft = ShaftLumpedParams { stiffness: [3e5; 2], tilt_stiffness: 900.0, material_damping: 1e-5, ..ShaftLumpedParams::new() };
    let link = || Link::Between(Attach::on("wheel"), Attach::ground());
    let cases = [
        (on(0.0), ring, true, false),
        (on(0.03).free(), sprung, true, false),
        (on(-0.02), BalancerBallParams { gravity: 0.0, ..ring }, true, true),
        (on(0.0).planar(), level, false, true),
        (on(0.0).planar().free(), sprung, false, false),
    ];
    for (balancer, ring, tilts, horizontal) in cases {
        let builder = Builder::new("wheel");
        let builder = if tilts {
            builder.part("wheel", Disc::tilting(), disc).part("shaft", ShaftLumped::with_tilt(link()).damped(), shaft)
        } else {
            builder.part("wheel", Disc::planar(), DiscParams { diametral_inertia: 0.0, ..disc }).part(
                "shaft",
                ShaftLumped::lateral(link()).damped(),
                ShaftLumpedParams { tilt_stiffness: 0.0, ..shaft },
            )
        };
        let builder = builder.part("balancer", balancer, ring);
        let base = if horizontal { builder.horizontal() } else { builder }.build().unwrap();
        assert_eq!(Form::of(&base, true), Form::Varying);
        let member = |k: usize| {
            let changes = [
                ("balancer.drag", 1e-3 * (1 + k) as f64),
                ("wheel.mass", 3.0 + 0.1 * k as f64),
                ("balancer.ball_mass", 0.02 + 1e-3 * k as f64),
            ];
            let mut m = constant(base.with(&changes).unwrap(), 200.0 + 10.0 * k as f64, 0.05);
            let n = m.system.n();
            for (y, x) in m.y[n - 3..n].iter_mut().zip([0.5, 0.8 + 0.1 * k as f64, 2.0]) {
                *y = x;
            }
            m
        };
        let members: Vec<Member> = (0..10).map(member).collect();
        let rows = sail(&members, Form::Varying, 0, Settings::default());
        let general = sail(&members, Form::Prescribed, 0, Settings::default());
        for ((m, (end, y, _)), other) in members.iter().zip(&rows).zip(&general) {
            assert_eq!(*end, LegEnd::Reached);
            let (d, o) = (apart(&m.system, &alone(m, &[]).0, y), apart(&m.system, &other.1, y));
            assert!(d < 1e-7 && o < 1e-7, "{d:e} {o:e}");
        }
        // the processor level changes no bit
        let plain = sail(&members, Form::Varying, 0, Settings { level: Level::Base, ..Settings::default() });
        assert!(rows.iter().zip(&plain).all(|(a, b)| a.1 == b.1));
    }
}

/// Steps between crossings count: a contact that opens and closes does not give a member more of them.
#[test]
fn crossings_do_not_lengthen_the_work() {
    let members = touching(6);
    let all = sail(&members, Form::Constant, 0, Settings::default());
    assert!(all.iter().all(|r| r.0 == LegEnd::Reached));
    let all = Members { members, outputs: 0, relative: 1e-13, most_steps: 200 };
    let rows = ensemble::run(&all, &all.members[0].system, Form::Constant, 0..6, Settings::default()).unwrap();
    assert!(rows.iter().all(|r| r.0 == LegEnd::WorkLimit), "{:?}", rows.iter().map(|r| r.0).collect::<Vec<_>>());
}

fn touching(count: usize) -> Vec<Member> {
    let planar = Planar { chi: 200.0, ..Planar::default() };
    let gap = Link::Between(Attach::on("drum"), Attach::on("base"));
    let stop = StopParams { stiffness: 4e7, gap: 5e-4, damping: 20.0 };
    let base = planar.builder().part("guard", Stop::new(gap), stop).build().unwrap();
    (0..count).map(|k| constant(base.with(&[("guard.gap", 3e-4 + 5e-5 * k as f64)]).unwrap(), 1800.0 + 40.0 * k as f64, 0.05)).collect()
}

/// Contacts are located in every lane: outputs go on behind them, and the motion is that of the single integrator.
#[test]
fn contacts_follow_single_motions() {
    let members = touching(9);
    let rows = sail(&members, Form::Constant, 40, Settings::default());
    for (m, (end, y, outputs)) in members.iter().zip(&rows) {
        let times: Vec<f64> = outputs.iter().map(|o| o.0).collect();
        assert!(outputs.len() == 40 && times.iter().enumerate().all(|(i, t)| (t - 0.05 * i as f64 / 40.0).abs() < 1e-15));
        let (expected, first) = alone(m, &times);
        assert_eq!(*end, LegEnd::Reached);
        let d = apart(&m.system, &expected, y);
        assert!(d < 1e-5, "{d:e}");
        for (a, b) in first.iter().zip(outputs) {
            assert!((a - b.1).abs() < 1e-5 * 1e-3, "{a} {b:?}");
        }
    }
}

/// Same bits for any number of threads, any level, and with neighbours that cannot be computed.
#[test]
fn a_member_does_not_depend_on_how_it_travels() {
    let mut members = filled(21);
    let expected = sail(&members, Form::Constant, 3, Settings { level: Level::Base, threads: 1, ..Settings::default() });
    for level in Level::supported() {
        for threads in [1, 2, 3] {
            assert_eq!(
                sail(&members, Form::Constant, 3, Settings { level, threads, ..Settings::default() }),
                expected,
                "{level:?} {threads}"
            );
        }
    }
    for k in [2, 7, 8, 15] {
        members[k].y[0] = f64::NAN;
    }
    for k in [4, 11] {
        members[k].y[1] = 1e200;
    }
    let rows = sail(&members, Form::Constant, 3, Settings::default());
    for (k, (row, expected)) in rows.iter().zip(&expected).enumerate() {
        match k {
            2 | 7 | 8 | 15 => assert_eq!(row.0, LegEnd::NoStart),
            4 | 11 => assert!(row.0 != LegEnd::Reached, "{:?}", row.0),
            _ => assert_eq!(row, expected),
        }
    }
    let order: Vec<Member> = (0..21).rev().map(|k| members[k].clone()).collect();
    let backwards = sail(&order, Form::Constant, 3, Settings::default());
    for k in [0, 1, 3, 5, 20] {
        assert_eq!(backwards[20 - k], expected[k]);
    }
}
