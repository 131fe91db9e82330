//! A part with 200 memory states, in fixed or rotor axes: `F = k d + sum_j E_j s / (s + lambda_j) d`, rates from 1 to 1e9 1/s.

use super::tools::{orbits, response};
use laval::diagnostic::Diagnostics;
use laval::model::blocks::{Axes, Blocks, Memory};
use laval::model::builder::Builder;
use laval::model::field::{Attach, Bounds, Field, ParamValues, Values};
use laval::model::part::{Dof, DofKind, Layout, Link, Params, Part, Physics};
use laval::model::system::{Pair, System};
use laval::params;
use laval::parts::{bearing_cubic::*, disc::*};
use laval::solve::ensemble::{self, Ended, EnsembleTask, Form, Leg, LegEnd, Method, Next, Settings, Start};
use laval::solve::harmonic::stability::floquet::Unassessed;
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::pencil::modes_about;
use laval::solve::programme::Programme;
use laval::solve::rest::rest;
use laval_num::complex::{C64, c};
use laval_num::ode::{Control, End, Radau, integrate};
use laval_num::scalar::Scalar;
use std::sync::{Arc, OnceLock};

const BRANCHES: usize = 100;

params! {
    /// Parameters of a [`Relaxing`] joint.
    pub struct RelaxingParams in RelaxingFamily {
        stiffness: scalar, "N/m", Bounds::up_to(1e12), required, "stiffness k at rest";
        modulus: scalar, "N/m", Bounds::up_to(1e12), required, "stiffness E of all branches together";
    }
}

pub struct Relaxing {
    link: Link,
    rotor: bool,
}

fn rate(j: usize) -> f64 {
    10f64.powf(9.0 * j as f64 / (BRANCHES - 1) as f64)
}

/// Share of a branch; they sum to one.
fn share(j: usize) -> f64 {
    static SUM: OnceLock<f64> = OnceLock::new();
    let raw = |j: usize| 1.0 + 0.5 * (j as f64).sin();
    raw(j) / SUM.get_or_init(|| (0..BRANCHES).map(raw).sum())
}

impl Part for Relaxing {
    const KIND: &'static str = "relaxing";
    const DOC: &'static str = "A joint with a spectrum of relaxation times.";
    type Family = RelaxingFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let mut layout = Layout::point(self.link.clone());
        for j in 0..BRANCHES {
            layout.states.extend(Dof::pair(&format!("branch_{j}_"), DofKind::VectorX, "m s", 1e-3 / rate(j)));
        }
        layout
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn memory(&self) -> usize {
        2 * BRANCHES
    }
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        for i in 0..2 {
            b.stiffness[(i, i)] = p.stiffness + p.modulus;
        }
        for j in 0..BRANCHES {
            for (i, axes) in [Axes::RotorX, Axes::RotorY].into_iter().enumerate() {
                let axes = if self.rotor { axes } else { Axes::Fixed };
                let gain = p.modulus.scale(-share(j) * rate(j));
                b.memory.push(Memory { rate: S::cst(rate(j)), gain, input: i, output: i, axes });
            }
        }
    }
}

const MASS: f64 = 3.0;
const ECCENTRICITY: f64 = 1e-4;
const REST: f64 = 2e6;
const MODULUS: f64 = 1.5e6;

/// The law of the joint on x + i y at s, spin W.
fn law(rotor: bool, s: C64, w: f64) -> C64 {
    let s = if rotor { s - c(0.0, w) } else { s };
    (0..BRANCHES).fold(c(REST, 0.0), |sum, j| sum + s.scale(MODULUS * share(j)) / (s + c(rate(j), 0.0)))
}

fn machine(rotor: bool, spring: Option<[f64; 2]>) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let mut b = Builder::new("relaxing")
        .part("disc", Disc::planar(), DiscParams { eccentricity: ECCENTRICITY, ..DiscParams::new(MASS) })
        .part("joint", Relaxing { link: link(), rotor }, RelaxingParams { stiffness: REST, modulus: MODULUS });
    if let Some(stiffness) = spring {
        let p = BearingCubicParams { stiffness, cubic_stiffness: [0.0; 2], valid_to: 0.0 };
        b = b.part("spring", BearingCubic::per_axis(link()), p);
    }
    b.build().unwrap()
}

/// Forward and backward amplitude of the unbalance response, and by how much it magnifies an error of its terms.
fn closed_form(rotor: bool, spring: [f64; 2], w: f64) -> (C64, C64, f64) {
    let (mean, half) = (0.5 * (spring[0] + spring[1]), 0.5 * (spring[0] - spring[1]));
    let s = c(0.0, w);
    let plus = law(rotor, s, w) + c(mean - MASS * w * w, 0.0);
    let minus = law(rotor, s.conj(), w).conj() + c(mean - MASS * w * w, 0.0);
    let load = MASS * ECCENTRICITY * w * w;
    let det = plus * minus - c(half * half, 0.0);
    let terms = REST + MODULUS + mean + MASS * w * w;
    (minus.scale(load) / det, (c(-half * load, 0.0) / det).conj(), terms * (plus.abs() + minus.abs()) / det.abs())
}

#[test]
fn response_has_its_closed_form() {
    for rotor in [false, true] {
        for spring in [None, Some([1e6, 1e6]), Some([1e6, 3e6])] {
            let (system, range) = (machine(rotor, spring), (100.0, 3000.0));
            let found = response(&system, range);
            assert!(matches!(found.unassessed, Some(Unassessed::TooManyStates(204))), "{:?}", found.unassessed);
            let all = orbits(&system, &found, range);
            assert!(all.len() > 50);
            for orbit in all {
                let (forward, backward, condition) = closed_form(rotor, spring.unwrap_or([0.0; 2]), orbit.speed);
                let (f, b) = orbit.whirl(&Pair::coordinates(0), 1);
                let size = (forward.abs() + backward.abs()) * (1.0 + condition);
                assert!(
                    (f - forward).abs() < 1e-12 * size,
                    "{rotor} {spring:?} at {}: {f:?} {forward:?} {condition:e} {:e}",
                    orbit.speed,
                    (f - forward).abs() / size
                );
                assert!((b - backward).abs() < 1e-12 * size, "{rotor} {spring:?} at {}: {b:?} {backward:?}", orbit.speed);
            }
        }
    }
}

/// Points lie close to the peak, though no eigenvalues guide the steps.
#[test]
fn response_does_not_step_over_the_peak() {
    let (system, range) = (machine(false, None), (100.0, 3000.0));
    let all = orbits(&system, &response(&system, range), range);
    let highest = (1000..30_000).map(|k| closed_form(false, [0.0; 2], 0.1 * f64::from(k)).0.abs()).fold(0.0, f64::max);
    let met = all.iter().map(|o| o.whirl(&Pair::coordinates(0), 1).0.abs()).fold(0.0, f64::max);
    assert!(met > 0.98 * highest && met < 1.0001 * highest, "{met} of {highest}");
}

#[test]
fn eigenvalues_are_roots_of_the_characteristic_function() {
    for (rotor, w) in [(false, 700.0), (true, 300.0), (true, 1500.0)] {
        let system = machine(rotor, None);
        let spectrum = modes_about(&system, &rest(&system, w).unwrap(), false).unwrap();
        let mut oscillating = 0;
        for m in &spectrum.modes {
            // Newton's correction of the characteristic function with the nearest pole multiplied out, whose root a fast branch sits beside
            let miss = |s: C64| {
                let shifted = |s: C64| if rotor { s - c(0.0, w) } else { s };
                let distance = |j: usize| (shifted(s) + c(rate(j), 0.0)).abs();
                let j = (0..BRANCHES).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
                let others = |s: C64| {
                    let t = shifted(s);
                    let branches = (0..BRANCHES).filter(|&i| i != j);
                    branches.fold(s * s.scale(MASS) + c(REST, 0.0), |sum, i| sum + t.scale(MODULUS * share(i)) / (t + c(rate(i), 0.0)))
                };
                let g = |s: C64| (shifted(s) + c(rate(j), 0.0)) * others(s) + shifted(s).scale(MODULUS * share(j));
                let h = 1e-6 * s.abs();
                let slope = (g(s + c(h, 0.0)) - g(s - c(h, 0.0))).scale(0.5 / h);
                (g(s) / slope).abs() / s.abs()
            };
            // the mode or its conjugate whirls forward
            let off = miss(m.value).min(miss(m.value.conj()));
            assert!(off < 1e-9, "{rotor} at {w}: {:?} misses by {off:e}", m.value);
            oscillating += usize::from(m.value.im.abs() > 100.0 && m.value.re.abs() < m.value.im.abs());
        }
        assert!(oscillating >= if rotor { 2 } else { 1 }, "{oscillating}");
        assert_eq!(spectrum.modes.len(), BRANCHES + 2, "{rotor} {w}");
    }
}

/// Started on the closed-form orbit, the stiff method stays there for three turns.
#[test]
fn stiff_method_follows_the_orbit() {
    for rotor in [false, true] {
        let (system, range) = (machine(rotor, Some([1e6, 3e6])), (600.0, 800.0));
        let all = orbits(&system, &response(&system, range), range);
        let orbit = &all[0];
        let (n, m) = (system.n(), system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        orbit.at(0.0, &mut q, &mut v, &mut a, &mut z);
        let mut y = [&q[..], &v[..], &z[..]].concat();
        let mut motion = Motion::new(&system, SpinLaw::Programme(Programme::constant(orbit.speed, 0.0))).unwrap();
        assert_eq!(motion.memory_states(), 2 * BRANCHES);
        let refused = motion.refuses_explicit().unwrap();
        assert!(refused.message.contains("\"joint\""), "{refused}");
        let size: Vec<f64> = (0..n).map(|_| 1e-12).chain((0..n).map(|_| 1e-9)).chain((0..m).map(|i| 1e-12 / rate(i / 2))).collect();
        let turns = 3.3;
        let time = turns * std::f64::consts::TAU / orbit.speed;
        let run = integrate(&mut Radau::new(), &mut motion, 0.0, &mut y, time, &Control::new(1e-9, size), &mut ());
        assert_eq!(run.end, End::Reached);
        orbit.at(turns * std::f64::consts::TAU, &mut q, &mut v, &mut a, &mut z);
        for i in 0..n {
            assert!((y[i] - q[i]).abs() < 1e-6 * q[0].hypot(q[1]), "{rotor} {:?} {q:?}", &y[..n]);
        }
        for i in 0..m {
            let size: f64 = orbit.states.iter().map(|s| s[i].abs()).sum();
            assert!((y[2 * n + i] - z[i]).abs() < 1e-5 * size, "{rotor} state {i}: {} {} of {size}", y[2 * n + i], z[i]);
        }
        assert!(run.work.steps < 5000, "{:?}", run.work);
    }
}

/// Starts on one orbit at several phases.
struct OnOrbit {
    system: Arc<System>,
    speed: f64,
    starts: Vec<Vec<f64>>,
    time: f64,
}

impl EnsembleTask for OnOrbit {
    type Log = ();
    type Row = (LegEnd, u64, Vec<f64>);
    fn start(&self, index: usize) -> Result<Start<()>, Self::Row> {
        let n = self.system.n();
        let size = |i: usize| {
            if i < n {
                1e-12
            } else if i < 2 * n {
                1e-9
            } else {
                1e-12 / rate((i - 2 * n) / 2)
            }
        };
        Ok(Start {
            system: self.system.clone(),
            law: SpinLaw::Programme(Programme::constant(self.speed, 0.1 * index as f64)),
            y: self.starts[index].clone(),
            relative: 1e-8,
            absolute: (0..self.starts[index].len()).map(size).collect(),
            leg: Leg::new(0.0, self.time),
            log: (),
        })
    }
    fn ended(&self, _: usize, _: &mut (), ended: &Ended, y: &mut [f64]) -> Next<Self::Row> {
        Next::Done((ended.end, ended.steps, y.to_vec()))
    }
}

/// In lanes the stiff method stays on the closed-form orbit as well; the explicit one is refused.
#[test]
fn stiff_lanes_follow_the_orbit() {
    for rotor in [false, true] {
        let (system, range) = (machine(rotor, Some([1e6, 3e6])), (600.0, 800.0));
        let orbit = &orbits(&system, &response(&system, range), range)[0];
        let (n, m) = (system.n(), system.m());
        let state = |turns: f64| {
            let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
            orbit.at(turns * std::f64::consts::TAU, &mut q, &mut v, &mut a, &mut z);
            [q, v, z].concat()
        };
        let turned = |k: usize| 0.1 * k as f64 / std::f64::consts::TAU;
        let turns = 1.3;
        let refused = ensemble::admit(&system, Method::Explicit).unwrap_err();
        assert!(refused.message.contains("\"joint\""), "{refused}");
        ensemble::admit(&system, Method::Stiff).unwrap();
        let form = Form::of(&system, true);
        let task = OnOrbit {
            system: Arc::new(system),
            speed: orbit.speed,
            starts: (0..5).map(|k| state(turned(k))).collect(),
            time: turns * std::f64::consts::TAU / orbit.speed,
        };
        let rows = ensemble::run(&task, &task.system, form, 0..5, Settings { method: Method::Stiff, ..Settings::default() }).unwrap();
        for (k, (end, steps, y)) in rows.iter().enumerate() {
            let expected = state(turned(k) + turns);
            assert_eq!(*end, LegEnd::Reached);
            let size = expected[0].hypot(expected[1]);
            assert!((0..n).all(|i| (y[i] - expected[i]).abs() < 1e-6 * size), "{rotor} {k}: {:?} {:?}", &y[..n], &expected[..n]);
            assert!(*steps < 2000, "{steps}");
        }
    }
}

/// The joint alone holds the disc, with a spring that differs in x and y.
pub fn linear(rotor: bool) -> System {
    machine(rotor, Some([1e6, 3e6]))
}
