//! Stationary states in turning axes: a flat ring with balls of its own making, against the reference tables, closed forms and refusals.

use crate::common;

use common::{number, rows};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::model::builder::Builder;
use laval::model::field::{Attach, Bounds, Field, ParamValues, RangeValue, Value, Values};
use laval::model::part::{At, Dof, Layout, Link, Observed, Params, Part, Physics, Rows};
use laval::model::system::System;
use laval::outcome::{Data, Outcome};
use laval::params;
use laval::parts::{balancer_ball::*, damper::*, disc::*, shaft_lumped::*};
use laval::study::stationary::Stationary;
use laval::study::{Context, ErasedStudy, Study};
use laval_num::complex::{C64, Complex, c};
use laval_num::scalar::Scalar;
use std::f64::consts::PI;

params! {
    /// Parameters of a [`Ring`].
    pub struct RingParams in RingFamily {
        ball_mass: scalar, "kg", Bounds::positive(1e6), required, "mass m of a ball";
        radius: scalar, "m", Bounds::positive(10.0), required, "radius r of the track";
        eccentricity: scalar, "m", Bounds::up_to(10.0), default 0.0, "distance of the ring centre from the shaft centre";
        phase: scalar, "rad", Bounds::within(10.0), default 0.0, "its direction";
        drag: scalar, "N m s", Bounds::up_to(1e6), default 0.0, "drag torque of a ball per rate";
    }
}

/// A flat circular track with balls; angles from the key mark.
struct Ring(usize);

impl Part for Ring {
    const KIND: &'static str = "ring";
    const DOC: &'static str = "A flat circular track with balls.";
    type Family = RingFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let own = (0..self.0).map(|k| Dof::scalar(format!("ball_{k}"), "rad", 1.0)).collect();
        Layout { own, ..Layout::point(Link::On(Attach::on("disc"))) }
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let along = |arm: Complex<S>, rate: S, accel: S| arm.mul_i().scale(accel) - arm.scale(rate * rate);
        let centre = Complex::cis(at.phase + p.phase).scale(p.eccentricity);
        for k in 2..2 + self.0 {
            let arm = Complex::cis(at.phase + at.q[k]).scale(p.radius);
            let (rate, accel) = (at.speed + at.v[k], at.spin_accel + at.a[k]);
            let force = (c(at.a[0], at.a[1]) + along(centre, at.speed, at.spin_accel) + along(arm, rate, accel)).scale(p.ball_mass);
            out.force[0] += force.re;
            out.force[1] += force.im;
            out.force[k] += (arm.conj() * force).im + p.drag * at.v[k];
            *out.spin += ((centre + arm).conj() * force).im;
        }
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let centre = C64::cis(at.phase + p.phase).scale(p.eccentricity) + c(at.q[0], at.q[1]);
        out.push(Observed { name: "ring centre", unit: "m", value: centre.abs() });
    }
}

/// A disc with housing and ring on a shaft.
#[derive(Clone, Copy)]
struct Case {
    /// Disc and housing, kg.
    masses: (f64, f64),
    /// Their eccentricities, m, and the direction of the second, rad.
    eccentricities: (f64, f64, f64),
    stiffness: f64,
    damping: f64,
    ball: f64,
    radius: f64,
    drag: f64,
    balls: usize,
}

/// Dimensionless, as Green et al. have it.
const PLANAR: Case = Case {
    masses: (1.0, 0.0),
    eccentricities: (0.01, 0.0, 0.0),
    stiffness: 1.0,
    damping: 0.02,
    ball: 0.05,
    radius: 1.0,
    drag: 0.0005,
    balls: 2,
};
/// The dissertation's machine with an untilted ring.
const SOURCE: Case = Case {
    masses: (8.91, 1.5),
    eccentricities: (50e-6, 50e-6, PI / 40.0),
    stiffness: 2922676.0,
    damping: 1e-3,
    ball: 0.0036,
    radius: 0.2,
    drag: 1e-3,
    balls: 2,
};

impl Case {
    fn builder(self, stiffness: [f64; 2]) -> Builder {
        let (mr, mb) = self.masses;
        let (s1, s2, gamma) = self.eccentricities;
        let unbalance = c(mr * s1, 0.0) + C64::cis(gamma).scale(mb * s2);
        let ground = || Link::Between(Attach::on("disc"), Attach::ground());
        let disc = DiscParams { unbalance: unbalance.abs(), eccentricity_phase: unbalance.arg(), ..DiscParams::new(mr + mb) };
        let ring = RingParams { ball_mass: self.ball, radius: self.radius, eccentricity: s2, phase: gamma, drag: self.drag };
        Builder::new("balancer")
            .part("disc", Disc::planar(), disc)
            .part("shaft", ShaftLumped::lateral(ground()), ShaftLumpedParams { stiffness, ..ShaftLumpedParams::new() })
            .part("air", Damper::fixed(ground()), DamperParams { damping: [self.damping; 2], tilt_damping: 0.0 })
            .part("ring", Ring(self.balls), ring)
    }
    fn system(self) -> System {
        self.builder([self.stiffness; 2]).build().unwrap()
    }
}

fn built(system: &System, list: &[(&str, Value)]) -> (Option<Stationary>, Diagnostics) {
    let mut values = Values::default();
    for (name, v) in list {
        values.set(name, v.clone(), None);
    }
    let mut d = Diagnostics::default();
    (Stationary::build(&values, system, &mut d), d)
}

fn range(from: f64, to: f64, points: usize) -> (&'static str, Value) {
    ("speed", Value::Range(RangeValue { from, to, points: Some(points) }))
}

fn run(system: &System, list: &[(&str, Value)]) -> Outcome {
    let (study, d) = built(system, list);
    assert!(d.0.is_empty(), "{d:?}");
    study.unwrap().run(system, &Context::quiet("stationary")).unwrap()
}

fn column<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [f64] {
    match &o.find_table(table).unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
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

/// A listed state: x, y, angles, growing roots, growth rate, kind.
#[derive(Clone, Debug)]
struct Listed {
    place: [f64; 2],
    angles: Vec<f64>,
    growing: i64,
    growth: f64,
    kind: String,
}

fn listed(o: &Outcome, speed: f64, angles: &[&str]) -> Vec<Listed> {
    let column = |name: &str| column(o, "states", name);
    (0..column("speed").len())
        .filter(|&k| (column("speed")[k] - speed).abs() < 1e-12 * speed)
        .map(|k| Listed {
            place: [column("disc x")[k], column("disc y")[k]],
            angles: angles.iter().map(|a| column(a)[k]).collect(),
            growing: whole(o, "states", "growing")[k],
            growth: column("growth")[k],
            kind: words(o, "states", "kind")[k].clone(),
        })
        .collect()
}

fn wrapped(x: f64) -> f64 {
    x - 2.0 * PI * (x / (2.0 * PI)).round()
}

/// The states hold one with this place and these two angles, whichever ball is called first.
fn find(all: &[Listed], place: [f64; 2], angles: [f64; 2], size: f64, tolerance: f64) -> Option<&Listed> {
    all.iter().find(|s| {
        let near = (s.place[0] - place[0]).hypot(s.place[1] - place[1]) <= tolerance * size;
        let same =
            |i: usize, j: usize| wrapped(s.angles[i] - angles[0]).abs() < tolerance && wrapped(s.angles[j] - angles[1]).abs() < tolerance;
        near && (same(0, 1) || same(1, 0))
    })
}

const BALLS: [&str; 2] = ["ring.ball_0", "ring.ball_1"];

#[test]
fn planar_branches() {
    let table = rows(include_str!("../reference/balancer/planar_branches.csv"));
    assert_eq!(table.len(), 44);
    let system = PLANAR.system();
    let mut speeds: Vec<f64> = table.iter().map(|r| number(r[0])).collect();
    speeds.dedup();
    for &w in &speeds {
        let o = run(&system, &[range(w, w + 0.01, 2), ("seeds", Value::Integer(1)), ("starts", Value::Integer(60))]);
        let all = listed(&o, w, &BALLS);
        let wanted: Vec<_> = table.iter().filter(|r| number(r[0]) == w).collect();
        assert_eq!(all.len(), wanted.len(), "{w}: {all:?}");
        for r in wanted {
            let n: Vec<f64> = r.iter().map(|x| number(x)).collect();
            let s = find(&all, [n[1], n[2]], [n[3], n[4]], 1.0, 1e-9).unwrap_or_else(|| panic!("{r:?}: {all:?}"));
            assert_eq!(s.growing as f64, n[6], "{r:?}");
            assert!((s.growth - n[7]).abs() < 1e-9, "{r:?}: {}", s.growth);
            let kind = match r[8] {
                "together" => "together",
                "opposed" => "opposed",
                _ => "balanced",
            };
            assert_eq!(s.kind, kind, "{r:?}");
        }
    }
}

#[test]
fn balanced_state_gains_and_loses_its_stability() {
    let table = rows(include_str!("../reference/balancer/planar_balanced_stability.csv"));
    assert_eq!(table.len(), 10);
    let mut done: Vec<&[&str]> = Vec::new();
    let mut worst = 0.0f64;
    for r in &table {
        if done.iter().any(|d| *d == &r[..7]) {
            continue;
        }
        done.push(&r[..7]);
        let n: Vec<f64> = r.iter().map(|x| number(x)).collect();
        let system = Case { ball: n[0], eccentricities: (n[1], 0.0, 0.0), damping: n[4], drag: n[5], ..PLANAR }.system();
        let o = run(&system, &[range(0.2, 12.0, 60)]);
        // the branch of the balanced state
        let kinds = words(&o, "states", "kind");
        let branch = (0..kinds.len()).find(|&k| kinds[k] == "balanced").map(|k| whole(&o, "states", "branch")[k]).unwrap();
        let change: Vec<usize> = (0..column(&o, "changes", "speed").len())
            .filter(|&k| whole(&o, "changes", "branch")[k] == branch && words(&o, "changes", "change")[k] == "hopf")
            .filter(|&k| whole(&o, "changes", "growing_before")[k].min(whole(&o, "changes", "growing_behind")[k]) == 0)
            .collect();
        let wanted: Vec<_> = table.iter().filter(|q| q[..7] == r[..7]).collect();
        // at twice the eccentricity the table steps over a window of 0.0016, in which the growth falls to -1e-5
        let narrow = change.iter().filter(|&&k| (1.1105..1.1130).contains(&column(&o, "changes", "speed")[k])).count();
        assert_eq!(narrow, if n[1] == 0.02 && n[2] == 0.01 { 2 } else { 0 }, "{r:?}");
        assert_eq!(change.len(), wanted.len() + narrow, "{r:?}: {:?}", column(&o, "changes", "speed"));
        for q in wanted {
            let (speed, frequency) = (number(q[7]), number(q[9]));
            let k = *change
                .iter()
                .min_by(|&&a, &&b| {
                    (column(&o, "changes", "speed")[a] - speed).abs().total_cmp(&(column(&o, "changes", "speed")[b] - speed).abs())
                })
                .unwrap();
            let off = (column(&o, "changes", "speed")[k] - speed).abs();
            worst = worst.max(off);
            assert!(off < 1e-7, "{q:?}: {}", column(&o, "changes", "speed")[k]);
            assert!((column(&o, "changes", "frequency")[k] - frequency).abs() < 1e-7, "{q:?}");
            let gains = whole(&o, "changes", "growing_behind")[k] == 0;
            assert_eq!(gains, q[8] == "gains", "{q:?}");
        }
    }
    println!("Hopf speeds: largest deviation {worst:.1e}");
}

#[test]
fn states_of_the_source_with_an_untilted_ring() {
    let table = rows(include_str!("../reference/balancer/stationary_fixed_tilt.csv"));
    let flat: Vec<_> = table.iter().filter(|r| number(r[0]) == 0.0).collect();
    assert!(flat.len() > 50);
    let mut done: Vec<(&str, &str)> = Vec::new();
    for r in &flat {
        if done.contains(&(r[1], r[2])) {
            continue;
        }
        done.push((r[1], r[2]));
        let w = number(r[2]);
        let case = Case { damping: number(r[1]), ..SOURCE };
        let o = run(&case.system(), &[range(w, 1.001 * w, 2), ("seeds", Value::Integer(1)), ("starts", Value::Integer(60))]);
        let all = listed(&o, w, &BALLS);
        let wanted: Vec<_> = flat.iter().filter(|q| q[1] == r[1] && q[2] == r[2]).collect();
        assert_eq!(all.len(), wanted.len(), "{r:?}: {all:?}");
        for q in wanted {
            let n: Vec<f64> = q.iter().map(|x| number(x)).collect();
            // the table counts from the node line, at pi/6
            let line = PI / 6.0;
            let s = find(&all, [n[3], n[4]], [n[5] + line, n[6] + line], 1e-6, 2e-6).unwrap_or_else(|| panic!("{q:?}: {all:?}"));
            assert_eq!(s.growing as f64, n[9], "{q:?}: {s:?}");
            assert!((s.growth - n[10]).abs() < 1e-6 * (1e-3 + n[10].abs()), "{q:?}: {}", s.growth);
            let kind = match q[11] {
                k if k.ends_with("ring centre on axis") => "partly_balanced",
                k => k,
            };
            assert_eq!(s.kind, kind, "{q:?}");
            let radius = s.place[0].hypot(s.place[1]);
            assert!((radius - n[7]).abs() < 1e-9 * n[7] + 1e-15, "{q:?}");
        }
    }
}

#[test]
fn eigenvalues_of_the_partly_balanced_state() {
    let table = rows(include_str!("../reference/balancer/eigenvalues.csv"));
    let flat: Vec<_> = table.iter().filter(|r| number(r[0]) == 0.0).collect();
    assert_eq!(flat.len(), 8);
    let case = Case { stiffness: 2e6, damping: 100.0, ..SOURCE };
    let o = run(&case.system(), &[range(750.0, 751.0, 2), ("seeds", Value::Integer(1)), ("starts", Value::Integer(60))]);
    let state = (0..words(&o, "states", "kind").len()).find(|&k| words(&o, "states", "kind")[k] == "partly_balanced").unwrap();
    assert_eq!(column(&o, "states", "speed")[state], 750.0);
    let own: Vec<C64> = (0..column(&o, "eigenvalues", "growth").len())
        .filter(|&k| whole(&o, "eigenvalues", "state")[k] == state as i64 + 1)
        .flat_map(|k| {
            let s = c(column(&o, "eigenvalues", "growth")[k], column(&o, "eigenvalues", "frequency")[k]);
            if s.im == 0.0 { vec![s] } else { vec![s, s.conj()] }
        })
        .collect();
    assert_eq!(own.len(), 8);
    for r in flat {
        let want = c(number(r[6]), number(r[7]));
        let off = own.iter().map(|s| (*s - want).abs()).fold(f64::INFINITY, f64::min);
        assert!(off < 1e-9 * 1200.0, "{r:?}: {own:?}");
    }
}

#[test]
fn least_external_damping() {
    let table = rows(include_str!("../reference/balancer/min_external_damping.csv"));
    for r in &table {
        let (w, drag) = (number(r[1]), number(r[2]));
        let stiffness = if r[0] == "fig8" { 2922676.0 } else { 2e6 };
        let system = Case { stiffness, drag, ..SOURCE }.system();
        let stabilise = Value::ParameterRange("air.damping".into(), RangeValue { from: 1e-3, to: 4e3, points: None });
        let o = run(
            &system,
            &[
                range(w, 1.001 * w, 2),
                ("seeds", Value::Integer(1)),
                ("starts", Value::Integer(60)),
                ("stabilise", stabilise),
                ("stabilise_at", Value::Number(w)),
            ],
        );
        let (value, growth) = (column(&o, "stabilised", "value"), column(&o, "stabilised", "growth"));
        let edge = match &o.find_table("stabilised").unwrap().column("edge").unwrap().data {
            Data::Flag(v) => v.clone(),
            other => panic!("{other:?}"),
        };
        assert!((growth[0] - number(r[4])).abs() < 1e-7 * number(r[4]).abs(), "{r:?}: {}", growth[0]);
        let found: Vec<f64> = (0..value.len()).filter(|&k| edge[k]).map(|k| value[k]).collect();
        let wanted: Vec<(f64, bool)> = r[3]
            .split([';', ' '])
            .filter(|t| t.contains("->"))
            .map(|t| t.split_once("->").map(|(v, what)| (number(v), what == "stable")).unwrap())
            .collect();
        assert_eq!(found.len(), wanted.len(), "{r:?}: {found:?}");
        for (f, (want, gains)) in found.iter().zip(&wanted) {
            assert!((f - want).abs() < 2e-9 * want, "{r:?}: {f}");
            let after = value.iter().zip(growth).find(|(v, g)| **v > *f && **g != 0.0).unwrap().1;
            assert_eq!(*after < 0.0, *gains, "{r:?}");
        }
        let reported = o.findings.iter().find(|f| f.id == "least").unwrap();
        if let Some((want, _)) = wanted.iter().find(|w| w.1) {
            assert!((reported.value.unwrap() - want).abs() < 2e-9 * want, "{reported:?}");
        } else {
            assert!(reported.value.is_none() && reported.sentence().contains("is unstable at all 61 values"), "{reported:?}");
        }
    }
}

/// Two equal balls apart exist exactly where |V| <= 2: the limits of the closed form are branch points on the states with both together or opposed.
#[test]
fn limits_of_existence_are_those_of_the_closed_form() {
    // too little ball mass: V = -unbalance/(m r) at every speed, so vary the mass against the closed form instead
    for (ball, exists) in [(0.0051, true), (0.0049, false)] {
        let system = Case { ball, ..PLANAR }.system();
        let o = run(&system, &[range(1.5, 3.0, 5)]);
        let balanced = words(&o, "states", "kind").iter().any(|k| k == "balanced");
        assert_eq!(balanced, exists, "{ball}");
    }
    // an eccentric ring: |V| depends on the speed
    let case = Case { eccentricities: (0.01, 0.02, 0.6), masses: (0.9, 0.1), ball: 0.02, damping: 0.05, drag: 1e-3, ..PLANAR };
    let measure = |w: f64| {
        let (mr, mb) = case.masses;
        let mass = mr + mb + 2.0 * case.ball;
        let ring = C64::cis(0.6).scale(0.02);
        let carried = ring.scale(mb + 2.0 * case.ball);
        let v = (c(1.0 / (w * w) - mass, 0.05 / w) * -ring - c(mr * 0.01, 0.0) - carried).scale(1.0 / case.ball);
        v.abs() - 2.0
    };
    let o = run(&case.system(), &[range(0.6, 3.0, 25)]);
    let mut limits = Vec::new();
    for k in 0..2400 {
        let (mut a, mut b) = (0.6 + 0.001 * f64::from(k), 0.601 + 0.001 * f64::from(k));
        if measure(a) * measure(b) < 0.0 {
            for _ in 0..60 {
                let m = 0.5 * (a + b);
                if measure(a) * measure(m) <= 0.0 { b = m } else { a = m }
            }
            limits.push(a);
        }
    }
    assert!(!limits.is_empty());
    for limit in limits {
        let off = o
            .special_points
            .iter()
            .filter(|p| p.kind == "fold" || p.kind == "branch_point")
            .map(|p| (p.at - limit).abs())
            .fold(f64::INFINITY, f64::min);
        assert!(off < 1e-6, "{limit}: {:?}", o.special_points);
    }
}

/// Without movable masses there is the one state that the unbalance response gives.
#[test]
fn a_machine_without_movable_masses_has_one_state() {
    let ground = || Link::Between(Attach::on("disc"), Attach::ground());
    let system = Builder::new("plain")
        .part("disc", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(4.0) })
        .part("shaft", ShaftLumped::lateral(ground()), ShaftLumpedParams { stiffness: [1e6; 2], ..ShaftLumpedParams::new() })
        .part("air", Damper::fixed(ground()), DamperParams { damping: [50.0; 2], tilt_damping: 0.0 })
        .build()
        .unwrap();
    let o = run(&system, &[range(100.0, 900.0, 9)]);
    let speeds = column(&o, "states", "speed");
    assert_eq!(speeds.len(), 9);
    for (k, &w) in speeds.iter().enumerate() {
        let z = c(4.0 * 1e-4 * w * w, 0.0) / c(1e6 - 4.0 * w * w, 50.0 * w);
        let off = (column(&o, "states", "disc x")[k] - z.re).hypot(column(&o, "states", "disc y")[k] - z.im);
        assert!(off < 1e-11 * z.abs(), "{w}");
        assert_eq!((words(&o, "states", "kind")[k].as_str(), whole(&o, "states", "growing")[k]), ("single", 0));
    }
}

fn refusal(system: &System) -> Diagnostic {
    let (study, _) = built(system, &[range(100.0, 900.0, 5)]);
    ErasedStudy::admit(&study.unwrap(), system).unwrap_err()
}

#[test]
fn what_knows_a_direction_is_refused_by_name() {
    let d = refusal(&SOURCE.builder([3e6, 2.9e6]).build().unwrap());
    assert!(d.message.contains("stiffness differs in x") && d.message.contains("3000000") && d.message.contains("2900000"), "{d}");
    let d = refusal(&SOURCE.builder([3e6; 2]).horizontal().build().unwrap());
    assert!(d.message.contains("the weight of \"disc\" pulls to one side"), "{d}");
    let d = refusal(&SOURCE.builder([3e6; 2]).free_spin().build().unwrap());
    assert!(d.message.contains("speed of this machine is free"), "{d}");
}

#[test]
fn wrong_requests_are_reported() {
    let system = SOURCE.system();
    let reported = |list: &[(&str, Value)]| built(&system, list).1.0.iter().map(|d| d.to_string()).collect::<Vec<_>>();
    assert!(reported(&[range(900.0, 100.0, 5)])[0].contains("from a lower to a higher value"));
    let vary = |path: &str| ("stabilise", Value::ParameterRange(path.into(), RangeValue { from: 1.0, to: 2.0, points: None }));
    assert!(reported(&[range(100.0, 900.0, 5), vary("air.dmping"), ("stabilise_at", Value::Number(500.0))])[0].contains("air.dmping"));
    assert!(reported(&[range(100.0, 900.0, 5), vary("air.damping")])[0].contains("needs the speed"));
}

/// The source's machine with its balancer: node line, tilt and what differs from [`SOURCE`].
#[derive(Clone, Copy)]
struct Tilted {
    stiffness: f64,
    damping: f64,
    tilt: f64,
    node_line: f64,
    radius: f64,
}

const TILTED: Tilted = Tilted { stiffness: 2922676.0, damping: 1e-3, tilt: 0.0, node_line: PI / 6.0, radius: 0.2 };

impl Tilted {
    fn system(self) -> System {
        let ground = || Link::Between(Attach::on("disc"), Attach::ground());
        let ring = BalancerBallParams {
            eccentricity: 50e-6,
            eccentricity_phase: PI / 40.0,
            tilt: self.tilt,
            node_line: self.node_line,
            housing_mass: 1.5,
            drag: 1e-3,
            gravity: 9.81,
            ..BalancerBallParams::new(0.0036, self.radius)
        };
        let balancer = BallBalancer::new(Attach::on("disc"), 2).planar();
        Builder::new("balancer")
            .part("disc", Disc::planar(), DiscParams { eccentricity: 50e-6, ..DiscParams::new(8.91) })
            .part("shaft", ShaftLumped::lateral(ground()), ShaftLumpedParams { stiffness: [self.stiffness; 2], ..ShaftLumpedParams::new() })
            .part("air", Damper::fixed(ground()), DamperParams { damping: [self.damping; 2], tilt_damping: 0.0 })
            .part("ring", balancer, ring)
            .build()
            .unwrap()
    }
}

/// All states at one speed, from this many starts.
fn at_speed(system: &System, w: f64, starts: i64) -> Outcome {
    run(system, &[range(w, 1.001 * w, 2), ("seeds", Value::Integer(1)), ("starts", Value::Integer(starts))])
}

#[test]
fn a_tilt_locks_the_balls_to_the_node_line() {
    let table = rows(include_str!("../reference/balancer/tilt_locking.csv"));
    assert_eq!(table.len(), 17);
    let mut tilts: Vec<&str> = table.iter().map(|r| r[0]).collect();
    tilts.dedup();
    for tilt in tilts {
        let w = 750.0;
        let case = Tilted { stiffness: 2e6, damping: 100.0, tilt: number(tilt), node_line: PI / 3.0, ..TILTED };
        let o = at_speed(&case.system(), w, 120);
        let stable: Vec<usize> = (0..column(&o, "states", "speed").len())
            .filter(|&k| (column(&o, "states", "speed")[k] - w).abs() < 1e-12 * w && whole(&o, "states", "growing")[k] == 0)
            .collect();
        let wanted: Vec<_> = table.iter().filter(|r| r[0] == tilt).collect();
        assert_eq!(stable.len(), wanted.len(), "{tilt}");
        for r in wanted {
            let n: Vec<f64> = r.iter().map(|x| number(x)).collect();
            let radius = |k: usize| column(&o, "states", "disc radius")[k];
            let k = *stable.iter().min_by(|&&a, &&b| (radius(a) - n[1]).abs().total_cmp(&(radius(b) - n[1]).abs())).unwrap();
            assert!((radius(k) - n[1]).abs() < 1e-7 * n[1], "{r:?}: {}", radius(k));
            let (x, y) = (column(&o, "states", "disc x")[k], column(&o, "states", "disc y")[k]);
            assert!(((x + 50e-6).hypot(y) - n[2]).abs() < 1e-7 * n[2], "{r:?}");
            assert!((column(&o, "states", "growth")[k] - n[5]).abs() < 6e-5 * n[5].abs(), "{r:?}: {}", column(&o, "states", "growth")[k]);
            let flags = match &o.find_table("states").unwrap().column("locked").unwrap().data {
                Data::Flag(v) => v.clone(),
                other => panic!("{other:?}"),
            };
            // r sin^2(tilt) is three times the eccentricity of the ring at 0.03 rad
            if n[0] >= 0.03 {
                assert!(flags[k], "{r:?}");
            } else if n[0] == 0.0 {
                assert!(!flags[k], "{r:?}");
            }
        }
        assert_eq!(o.findings.iter().any(|f| f.id == "hindered"), number(tilt) > 0.005, "{tilt}");
    }
}

#[test]
fn eigenvalues_with_a_tilt() {
    let table = rows(include_str!("../reference/balancer/eigenvalues.csv"));
    let mut tilts: Vec<&str> = table.iter().map(|r| r[0]).collect();
    tilts.dedup();
    assert_eq!(tilts.len(), 2);
    for tilt in tilts {
        let case = Tilted { stiffness: 2e6, damping: 100.0, tilt: number(tilt), node_line: PI / 3.0, ..TILTED };
        let exact = if number(tilt) > 0.1 { PI / 20.0 } else { number(tilt) };
        let o = at_speed(&Tilted { tilt: exact, ..case }.system(), 750.0, 120);
        let wanted: Vec<Vec<f64>> = table.iter().filter(|r| r[0] == tilt).map(|r| r.iter().map(|x| number(x)).collect()).collect();
        let (x, y) = (column(&o, "states", "disc x"), column(&o, "states", "disc y"));
        let state = (0..x.len())
            .min_by(|&a, &b| (x[a] - wanted[0][1]).hypot(y[a] - wanted[0][2]).total_cmp(&(x[b] - wanted[0][1]).hypot(y[b] - wanted[0][2])))
            .unwrap();
        let own: Vec<C64> = (0..column(&o, "eigenvalues", "growth").len())
            .filter(|&k| whole(&o, "eigenvalues", "state")[k] == state as i64 + 1)
            .map(|k| c(column(&o, "eigenvalues", "growth")[k], column(&o, "eigenvalues", "frequency")[k]))
            .flat_map(|s| if s.im == 0.0 { vec![s] } else { vec![s, s.conj()] })
            .collect();
        assert_eq!(own.len(), wanted.len());
        for n in wanted {
            let off = own.iter().map(|s| (*s - c(n[6], n[7])).abs()).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-9 * 1200.0, "{tilt}: {n:?}: {own:?}");
        }
    }
}
