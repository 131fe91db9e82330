//! A body with 120 coordinates: a chain of 60 masses between springs, fixed at its lower end, each mass moving in x and y. Points between two
//! masses move on the straight line that joins them, and tilt with it.

use super::tools::orbits;
use crate::common::base::defect;
use laval::diagnostic::Diagnostics;
use laval::model::blocks::Blocks;
use laval::model::builder::Builder;
use laval::model::capability::BodyPart;
use laval::model::erased;
use laval::model::field::{Attach, Bounds, Field, ParamValues, Values};
use laval::model::part::{At, Dof, DofKind, Layout, Link, Params, Part, Physics, Rows, Uses};
use laval::model::system::{Pair, System};
use laval::params;
use laval::parts::{bearing_cubic::*, damper::*};
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::{Request, Response, respond};
use laval::solve::large::usual_frequency;
use laval::solve::pencil::{Linearised, modes_about};
use laval::solve::rest::rest;
use laval::solve::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::scalar::Scalar;
use std::sync::atomic::AtomicBool;

const N: usize = 60;
const LENGTH: f64 = 1.2;

params! {
    /// Parameters of a [`Chain`].
    pub struct ChainParams in ChainFamily {
        mass: scalar, "kg", Bounds::positive(1e6), required, "mass of each link";
        stiffness: scalar, "N/m", Bounds::positive(1e12), required, "stiffness between links";
        delay: scalar, "s", Bounds::up_to(1.0), default 0.0, "damping over stiffness";
        unbalance: scalar, "kg m", Bounds::up_to(1e3), default 0.0, "unbalance of the link in the middle";
    }
}

pub struct Chain;

impl Part for Chain {
    const KIND: &'static str = "chain";
    const DOC: &'static str = "A chain of masses.";
    type Family = ChainFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::body((0..N).flat_map(|k| Dof::pair(&format!("{k}_"), DofKind::VectorX, "m", 1e-3)).collect())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, w: S, b: &mut Blocks<S>) {
        for k in 0..N {
            for axis in 0..2 {
                let i = 2 * k + axis;
                b.mass[(i, i)] = p.mass;
                let springs = if k + 1 < N { 2.0 } else { 1.0 };
                b.stiffness[(i, i)] = p.stiffness.scale(springs);
                b.damping[(i, i)] = (p.delay * p.stiffness).scale(springs);
                if k + 1 < N {
                    for (r, s) in [(i, i + 2), (i + 2, i)] {
                        b.stiffness[(r, s)] = -p.stiffness;
                        b.damping[(r, s)] = -(p.delay * p.stiffness);
                    }
                }
            }
        }
        b.force_cos[N] = p.unbalance * w * w;
        b.force_sin[N + 1] = p.unbalance * w * w;
    }
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        Some(self)
    }
}

impl BodyPart for Chain {
    fn shape(&self, _: &Params<Self, f64>, z: f64) -> Vec<[f64; 6]> {
        let step = LENGTH / N as f64;
        // link k stands at (k + 1) step
        let place = (z / step - 1.0).clamp(0.0, (N - 1) as f64);
        let below = (place.floor() as usize).min(N - 2);
        let t = place - below as f64;
        let mut rows = vec![[0.0; 6]; 2 * N];
        for (k, weight, slope) in [(below, 1.0 - t, -1.0 / step), (below + 1, t, 1.0 / step)] {
            // tilt about x is minus the slope of y
            rows[2 * k][..4].copy_from_slice(&[weight, 0.0, 0.0, slope]);
            rows[2 * k + 1][..4].copy_from_slice(&[0.0, weight, -slope, 0.0]);
        }
        rows
    }
}

params! {
    /// Parameters of a [`Hinge`].
    pub struct HingeParams in HingeFamily {
        cubic: scalar, "N m/rad^3", Bounds::up_to(1e12), required, "moment over the cube of the tilt";
    }
}

/// Holds the tilt of a point by a moment that grows with its cube.
pub struct Hinge(Attach);

impl Part for Hinge {
    const KIND: &'static str = "hinge";
    const DOC: &'static str = "A nonlinear hinge.";
    type Family = HingeFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point_and_tilt(Link::On(self.0.clone()))
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: false, acceleration: false, spin: false }
    }
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let square = at.q[2].square() + at.q[3].square();
        for i in [2, 3] {
            out.force[i] += p.cubic * square * at.q[i];
        }
    }
}

/// Without stability, which other tests assess on machines of many small parts.
fn response(system: &System, range: (f64, f64)) -> Response {
    let request = Request { stability: false, ..Request::over(range.0, range.1) };
    respond(system, &request, &AtomicBool::new(false), &|_| {}).unwrap()
}

const MASS: f64 = 0.1;
const STIFFNESS: f64 = 4e7;
const DELAY: f64 = 2e-6;
const UNBALANCE: f64 = 2e-4;

fn builder(unbalance: f64) -> Builder {
    Builder::new("chain").part("chain", Chain, ChainParams { mass: MASS, stiffness: STIFFNESS, delay: DELAY, unbalance })
}

fn angle(j: usize) -> f64 {
    (2 * j + 1) as f64 * std::f64::consts::PI / (2 * N + 1) as f64
}

fn frequency(j: usize) -> f64 {
    2.0 * (STIFFNESS / MASS).sqrt() * (0.5 * angle(j)).sin()
}

/// Displacement of link `a` per force on link `b` at s, as a sum over modes.
fn receptance(a: usize, b: usize, s: C64) -> C64 {
    (0..N).fold(C64::zero(), |sum, j| {
        let (w2, norm) = (frequency(j).powi(2), MASS * (2 * N + 1) as f64 / 4.0);
        let shape = ((a + 1) as f64 * angle(j)).sin() * ((b + 1) as f64 * angle(j)).sin() / norm;
        sum + c(shape, 0.0) / (s * s + s.scale(DELAY * w2) + c(w2, 0.0))
    })
}

#[test]
fn modes_have_their_closed_form() {
    let system = builder(0.0).build().unwrap();
    assert_eq!(system.n(), 2 * N);
    let about = rest(&system, 300.0).unwrap();
    // a machine of this size: those up to a frequency; all from its matrices
    let band = modes_about(&system, &about, false).unwrap();
    let below = |limit: f64| 2 * (0..N).filter(|&j| frequency(j) < limit).count();
    let limit = usual_frequency(&system, &about);
    assert!((12..2 * N).contains(&band.modes.len()));
    assert_eq!(band.modes.len(), below(limit), "below {limit}");
    let spectrum = Linearised::new(&system, &about).unwrap().spectrum().unwrap();
    for m in &band.modes {
        assert!(spectrum.modes.iter().any(|all| (all.value - m.value).abs() < 1e-9 * m.value.abs()), "{:?}", m.value);
    }
    // forward and backward of each
    assert_eq!(spectrum.modes.len(), 2 * N);
    for j in 0..N {
        let w = frequency(j);
        let growth = -0.5 * DELAY * w * w;
        let near = spectrum.modes.iter().filter(|m| (m.value - c(growth, (w * w - growth * growth).sqrt())).abs() < 1e-8 * w).count();
        assert_eq!(near, 2, "mode {j} at {w}");
    }
}

#[test]
fn linear_response_is_the_modal_sum() {
    let (system, range) = (builder(UNBALANCE).build().unwrap(), (50.0, 2500.0));
    let found = response(&system, range);
    let all = orbits(&system, &found, range);
    for o in &all {
        let force = UNBALANCE * o.speed * o.speed;
        for link in [0, 30, 59] {
            let exact = receptance(link, N / 2, c(0.0, o.speed)).scale(force);
            let got = o.whirl(&Pair::coordinates(2 * link), 1).0;
            assert!((got - exact).abs() < 1e-9 * exact.abs().max(1e-9), "link {link} at {}: {got:?} {exact:?}", o.speed);
        }
    }
    // two resonances in the range, and points on both peaks
    for j in 0..2 {
        let w = frequency(j);
        let peak = all.iter().map(|o| (o.speed - w).abs()).fold(f64::INFINITY, f64::min);
        assert!(peak < 0.5 * DELAY * w * w, "{peak} rad/s beside {w}");
    }
}

fn bearing(position: f64, linear: f64, cubic: f64) -> (BearingCubic, BearingCubicParams) {
    let link = Link::Between(Attach::at("chain", position), Attach::ground());
    (BearingCubic::isotropic(link), BearingCubicParams { stiffness: [linear; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 })
}

/// Only what the bearing sees stays in the balance, and its equation is the one condensed by hand.
#[test]
fn a_bearing_at_the_end_condenses_to_two_unknowns() {
    let (linear, cubic) = (2e5, 1e11);
    let (part, p) = bearing(LENGTH, linear, cubic);
    let (system, range) = (builder(UNBALANCE).part("bearing", part, p).build().unwrap(), (50.0, 1200.0));
    let found = response(&system, range);
    assert_eq!(found.discretisation.symmetry, Symmetry::Circular);
    let balance = Balance::new(&system, found.discretisation, range, None).unwrap();
    assert_eq!((balance.terms.unknowns, balance.nonlinear.basis.rows.len()), (2, 2));
    for o in orbits(&system, &found, range) {
        let s = c(0.0, o.speed);
        let d = o.whirl(&Pair::coordinates(2 * (N - 1)), 1).0;
        let free = receptance(N - 1, N / 2, s).scale(UNBALANCE * o.speed * o.speed);
        let held = receptance(N - 1, N - 1, s) * d.scale(linear + cubic * d.norm_sqr());
        let size = d.abs() + free.abs() + held.abs();
        assert!((d + held - free).abs() < 1e-9 * size, "{}: {:?}", o.speed, d + held - free);
    }
}

/// Parts between two links, one of which sees the tilt: the motion balances the assembled machine.
#[test]
fn ports_along_the_chain() {
    let ground = |z: f64| Link::Between(Attach::at("chain", z), Attach::ground());
    let (middle, law) = bearing(0.507, 3e5, 1e11);
    let system = builder(UNBALANCE)
        .part("middle", middle, law)
        .part("hinge", Hinge(Attach::at("chain", 0.993)), HingeParams { cubic: 1e9 })
        .part("air", Damper::fixed(ground(0.711)), DamperParams { damping: [20.0; 2], tilt_damping: 0.0 })
        .build()
        .unwrap();
    let range = (200.0, 1200.0);
    let found = response(&system, range);
    assert_eq!(found.discretisation.symmetry, Symmetry::Circular, "{:?}", found.broken);
    let all = orbits(&system, &found, range);
    let largest = all.iter().map(|o| o.whirl(&Pair::coordinates(0), 1).0.abs()).fold(0.0, f64::max);
    assert!(largest > 1e-6);
    for o in all {
        let d = defect(&system, &o, 1);
        assert!(d < 1e-9, "{}: {d:e}", o.speed);
    }
}

/// The chain and nothing else.
pub fn linear() -> System {
    builder(UNBALANCE).build().unwrap()
}
