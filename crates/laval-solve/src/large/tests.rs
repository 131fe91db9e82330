//! A chain of gyroscopic masses between springs against its full matrices.

use super::{ALL_MODES, LEAST_MODES, starts, usual_frequency};
use crate::characteristic::{Characteristic, Equilibrium, Frame};
use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::response::{Request as Response, respond};
use crate::harmonic::stability::floquet::Stability;
use crate::linear_response::response;
use crate::locate::value_and_slope;
use crate::matrices::{Matrices, matrices};
use crate::pencil::{Linearised, modes_about};
use crate::rest::rest;
use crate::roots::{Request, in_region, roots};
use crate::sectors::Sector;
use crate::sweep::sweep;
use laval_model::diagnostic::Diagnostics;
use laval_model::model::blocks::Blocks;
use laval_model::model::builder::Builder;
use laval_model::model::capability::BodyPart;
use laval_model::model::erased;
use laval_model::model::field::{Attach, Bounds, Field, ParamValues, Values};
use laval_model::model::part::{Dof, DofKind, Layout, Link, Params, Part, Physics};
use laval_model::model::system::System;
use laval_model::params;
use laval_model::parts::bearing_cubic::{BearingCubic, BearingCubicParams};
use laval_model::parts::damper::{Damper, DamperParams};
use laval_model::parts::disc::{Disc, DiscParams};
use laval_model::parts::shaft_lumped::{ShaftLumped, ShaftLumpedParams};
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use laval_num::scalar::Scalar;
use std::sync::atomic::AtomicBool;

params! {
    /// Parameters of a [`Chain`].
    pub struct ChainParams in ChainFamily {
        mass: scalar, "kg", Bounds::positive(1e6), required, "mass of each link";
        stiffness: scalar, "N/m", Bounds::positive(1e12), required, "stiffness between links";
        damping: scalar, "N s/m", Bounds::up_to(1e6), required, "damping of each link";
        gyroscopic: scalar, "kg", Bounds::up_to(1e6), required, "force on x for each rate of y and speed";
        other: scalar, "N/m", Bounds::up_to(1e12), required, "stiffness to the ground of every second link along y";
        unbalance: scalar, "kg m", Bounds::up_to(1e3), required, "unbalance of the link in the middle";
    }
}

/// So many links, fixed at the lower end.
struct Chain(usize);

impl Part for Chain {
    const KIND: &'static str = "gyroscopic_chain";
    const DOC: &'static str = "A chain of masses.";
    type Family = ChainFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::body((0..self.0).flat_map(|k| Dof::pair(&format!("{k}_"), DofKind::VectorX, "m", 1e-3)).collect())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, w: S, b: &mut Blocks<S>) {
        for k in 0..self.0 {
            let (x, y) = (2 * k, 2 * k + 1);
            b.gyroscopic[(x, y)] = p.gyroscopic;
            b.gyroscopic[(y, x)] = -p.gyroscopic;
            for i in [x, y] {
                b.mass[(i, i)] = p.mass;
                b.damping[(i, i)] = p.damping;
                b.stiffness[(i, i)] = p.stiffness.scale(if k + 1 < self.0 { 2.0 } else { 1.0 });
                if k + 1 < self.0 {
                    (b.stiffness[(i, i + 2)], b.stiffness[(i + 2, i)]) = (-p.stiffness, -p.stiffness);
                }
            }
            if k % 2 == 1 {
                b.stiffness[(y, y)] += p.other;
            }
        }
        let middle = self.0 / 2 * 2;
        b.force_cos[middle] = p.unbalance * w * w;
        b.force_sin[middle + 1] = p.unbalance * w * w;
    }
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        Some(self)
    }
}

impl BodyPart for Chain {
    fn shape(&self, _: &Params<Self, f64>, z: f64) -> Vec<[f64; 6]> {
        let link = (z.round().max(0.0) as usize).min(self.0 - 1);
        let mut rows = vec![[0.0; 6]; 2 * self.0];
        (rows[2 * link][0], rows[2 * link + 1][1]) = (1.0, 1.0);
        rows
    }
}

const LINKS: usize = 60;

fn builder(other: f64) -> Builder {
    let p = ChainParams { mass: 0.2, stiffness: 4e6, damping: 3.0, gyroscopic: 0.15, other, unbalance: 2e-4 };
    Builder::new("chain").part("chain", Chain(LINKS), p)
}

fn bearing(place: f64, cubic: f64) -> (BearingCubic, BearingCubicParams) {
    let link = Link::Between(Attach::at("chain", place), Attach::ground());
    (BearingCubic::isotropic(link), BearingCubicParams { stiffness: [3e5; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 })
}

/// Bodies joined by springs, of which soft ones with dampers hold both ends.
fn rod(stiff: f64, soft: f64) -> System {
    let mut b = Builder::new("rod");
    for k in 0..LINKS {
        b = b.part(format!("d{k}"), Disc::planar(), DiscParams::new(0.2));
    }
    let spring = |k: f64| ShaftLumpedParams { stiffness: [k; 2], ..ShaftLumpedParams::new() };
    for k in 1..LINKS {
        let link = Link::Between(Attach::on(format!("d{k}")), Attach::on(format!("d{}", k - 1)));
        b = b.part(format!("s{k}"), ShaftLumped::lateral(link), spring(stiff));
    }
    for k in [0, LINKS - 1] {
        let link = || Link::Between(Attach::on(format!("d{k}")), Attach::ground());
        b = b.part(format!("k{k}"), ShaftLumped::lateral(link()), spring(soft));
        b = b.part(format!("c{k}"), Damper::fixed(link()), DamperParams { damping: [4.0; 2], tilt_damping: 0.0 });
    }
    b.build().unwrap()
}

/// Without preferred direction; with one; with a nonlinear part; of many parts.
fn machines() -> [System; 4] {
    let (part, p) = bearing(40.0, 1e12);
    let [a, b, c] = [builder(0.0), builder(3e4), builder(0.0).part("bearing", part, p)].map(|b| b.build().unwrap());
    [a, b, c, rod(1e8, 2e4)]
}

fn all(system: &System, about: &Equilibrium, limit: f64) -> Vec<C64> {
    let all = Linearised::new(system, about).unwrap().spectrum().unwrap().modes;
    all.iter().map(|m| m.value).filter(|s| s.im <= limit && s.re.abs() <= limit).collect()
}

fn dynamic_stiffness(m: &Matrices, s: C64) -> Mat<C64> {
    Mat::from_fn(m.mass.len(), m.mass.len(), |i, j| {
        let damping = m.damping[i][j] + m.speed * m.gyroscopic[i][j];
        c(m.stiffness[i][j], 0.0) + s.scale(damping) + (s * s).scale(m.mass[i][j])
    })
}

fn same(found: &[C64], all: &[C64]) {
    assert_eq!(found.len(), all.len(), "{found:?} {all:?}");
    for s in all {
        let away = found.iter().map(|f| (*f - *s).abs()).fold(f64::INFINITY, f64::min);
        assert!(away <= 1e-9 * s.abs(), "{s:?} is {away:e} away");
    }
}

#[test]
fn modes_up_to_a_frequency_are_those_of_the_full_matrices() {
    for system in machines() {
        assert!(2 * system.n() > ALL_MODES && in_region(&system));
        for speed in [0.0, 300.0, -500.0] {
            let about = rest(&system, speed).unwrap();
            let found = roots(&system, &about, &Request::default()).unwrap();
            assert!(!found.areas.is_empty() && found.areas.iter().all(|a| a.complete()), "{:?}", found.areas);
            assert!(found.frequency >= 3.0 * speed.abs() && found.spectrum.modes.len() >= LEAST_MODES);
            let modes = modes_about(&system, &about, false).unwrap().modes;
            let own = all(&system, &about, found.frequency);
            same(&modes.iter().map(|m| m.value).collect::<Vec<_>>(), &own);
            // a wider region holds the same and more
            let wide = roots(&system, &about, &Request { frequency: Some(3.0 * found.frequency), ..Request::default() }).unwrap();
            same(&wide.spectrum.modes.iter().map(|m| m.value).collect::<Vec<_>>(), &all(&system, &about, 3.0 * found.frequency));
            // vectors, in x and y, are null vectors: (s^2 M + s C + K) q = 0
            let matrices = matrices(&system, &about).unwrap();
            for m in &modes {
                let t = dynamic_stiffness(&matrices, m.value);
                let rest = t.mul_vec(&m.q).iter().map(|x| x.abs()).fold(0.0, f64::max);
                let size = t.max_size() * m.q.iter().map(|x| x.abs()).fold(0.0, f64::max);
                assert!(rest <= 1e-12 * size, "{:?} {:e}", m.value, rest / size);
            }
        }
    }
}

/// The axis is covered: every mode near it has a start, before any count.
#[test]
fn starts_of_all_modes_near_the_axis() {
    for (k, system) in machines().iter().enumerate() {
        let (about, limit) = (rest(system, 300.0).unwrap(), 7000.0);
        let t = Characteristic::new(system, &about);
        // the second machine has a preferred direction
        let sectors = [Some(None), (k != 1).then_some(Some(Sector::Forward))];
        for sector in sectors.into_iter().flatten() {
            let found = starts(&t, &[sector], Some(limit)).values;
            for s in all(system, &about, 0.95 * limit).iter().filter(|s| s.re.abs() < 0.1 * limit) {
                let near = |v: &(Option<Sector>, C64)| (v.1 - *s).abs().min((v.1 - s.conj()).abs()) <= 1e-5 * s.abs();
                assert!(found.iter().any(near), "machine {k}, {sector:?}: {s:?}");
            }
        }
    }
}

/// The tangent of a mode over the speed is that of its values.
#[test]
fn tangents_of_modes() {
    for system in &machines()[..3] {
        let (state, speed) = (|w: f64| rest(system, w), 300.0);
        for m in modes_about(system, &state(speed).unwrap(), false).unwrap().modes.iter().step_by(3) {
            let (value, slope) = value_and_slope(system, &state, speed, m.value, m.sector).unwrap();
            let at = |w: f64| Characteristic::new(system, &state(w).unwrap()).polish(value, m.sector).unwrap().value;
            let central = |h: f64| (at(speed + h) - at(speed - h)).scale(0.5 / h);
            // modes veer: the error of second order is taken off
            let difference = (central(0.01).scale(4.0) - central(0.02)).scale(1.0 / 3.0);
            assert!((slope - difference).abs() <= 1e-6 * (difference.abs() + 1e-3), "{:?} {value:?} {slope:?} {difference:?}", m.sector);
        }
    }
}

/// A stiff rod of many bodies on soft springs moves as one body, whose frequency rounding of its stiffness does not spoil.
#[test]
fn a_stiff_rod_on_soft_springs() {
    let (stiff, soft) = (1e12, 2e4);
    let system = rod(stiff, soft);
    let root = Characteristic::new(&system, &rest(&system, 100.0).unwrap()).polish(c(-1.0, 60.0), None).unwrap();
    let (mass, damping) = (0.2 * LINKS as f64, 8.0);
    let rigid = c(-0.5 * damping / mass, (2.0 * soft / mass - (0.5 * damping / mass).powi(2)).sqrt());
    // one rounding of the stiffness between two bodies is 1e-16 of 1e12 beside 2e4
    assert!((root.value - rigid).abs() <= 1e-7 * rigid.abs(), "{:?} {rigid:?}", root.value);
    assert!(root.step <= 1e-12 * rigid.abs(), "{:e}", root.step);
}

/// The border of a root at another speed leads to the same root as one of its own.
#[test]
fn borders_serve_at_speeds_beside() {
    for system in machines() {
        let [mut here, mut there] = [300.0, 310.0].map(|w| Characteristic::new(&system, &rest(&system, w).unwrap()));
        for m in modes_about(&system, &rest(&system, 300.0).unwrap(), false).unwrap().modes.iter().step_by(3) {
            let first = here.polish(m.value, m.sector).unwrap();
            let (own, led) = (there.polish(first.value, m.sector).unwrap(), there.polish_with(first.value, first.border).unwrap());
            assert!((own.value - led.value).abs() <= 1e-12 * own.value.abs(), "{:?} {:?}", own.value, led.value);
            assert!(own.step <= 1e-12 * own.value.abs() && led.step <= 1e-12 * led.value.abs() && led.defect <= 1e-12);
            // both vectors, up to a factor
            let size = |x: &[C64]| x.iter().map(|x| x.norm_sqr()).sum::<f64>().sqrt();
            for (a, b) in [(&own.right, &led.right), (&own.left, &led.left)] {
                let inner = a.iter().zip(b).fold(C64::zero(), |sum, (a, b)| sum + a.conj() * *b);
                assert!(inner.abs() >= (1.0 - 1e-10) * size(a) * size(b), "{inner:?}");
            }
        }
    }
}

#[test]
fn modes_are_followed_over_the_speed() {
    for system in machines() {
        let state = |w: f64| rest(&system, w);
        let speeds: Vec<f64> = (0..25).map(|k| 40.0 + 25.0 * f64::from(k)).collect();
        let limit = usual_frequency(&system, &state(640.0).unwrap());
        let found = sweep(&system, &state, &speeds, limit, |_, _| true).unwrap();
        assert!(found.ambiguous.is_empty() && found.points.len() == speeds.len());
        assert!(found.counts.len() == 3 && found.counts.iter().all(|n| n.complete), "{:?}", found.counts);
        for &speed in &speeds {
            let here = found.branches.iter().filter_map(|b| b.points.iter().find(|p| p.0 == speed));
            same(&here.map(|p| p.1.value).collect::<Vec<_>>(), &all(&system, &state(speed).unwrap(), limit));
        }
        // smooth: the second difference of a frequency is small beside the first, and no branch has a gap
        for b in &found.branches {
            let at: Vec<usize> = b.points.iter().map(|p| speeds.iter().position(|w| *w == p.0).unwrap()).collect();
            assert!(at.windows(2).all(|w| w[1] == w[0] + 1), "{at:?}");
            for w in b.points.windows(3) {
                let f = [0, 1, 2].map(|k| w[k].1.value.im);
                assert!((f[0] - 2.0 * f[1] + f[2]).abs() <= 0.02 * f[1], "{f:?}");
            }
        }
    }
}

#[test]
fn responses_and_rest_are_those_of_the_full_matrices() {
    let system = builder(3e4).horizontal().build().unwrap();
    for speed in [70.0, 260.0, -410.0] {
        let state = |w: f64| rest(&system, w);
        let about = state(speed).unwrap();
        let matrices = matrices(&system, &about).unwrap();
        let n = system.n();
        let k = Mat::from_fn(n, n, |i, j| matrices.stiffness[i][j]);
        let mut hanging: Vec<f64> = (0..n).map(|i| if i % 2 == 1 { -0.2 * laval_model::model::system::GRAVITY } else { 0.0 }).collect();
        Lu::new(&k).unwrap().solve(&mut hanging);
        for (a, b) in about.q.iter().zip(&hanging) {
            assert!((a - b).abs() <= 1e-10 * hanging[n - 1].abs(), "{a} {b}");
        }
        let z = dynamic_stiffness(&matrices, c(0.0, speed));
        let mut x = vec![C64::zero(); n];
        (x[LINKS], x[LINKS + 1]) = (c(2e-4 * speed * speed, 0.0), c(0.0, -2e-4 * speed * speed));
        Lu::new(&z).unwrap().solve(&mut x);
        let found = response(&system, &state, speed).unwrap().unwrap();
        let size = x.iter().map(|x| x.abs()).fold(0.0, f64::max);
        for (a, b) in found.x.iter().zip(&x) {
            assert!((*a - *b).abs() <= 1e-10 * size, "{a:?} {b:?}");
        }
        assert!(found.residual < 1e-11);
    }
}

/// About a motion that turns with the rotor the exponents are the roots of the full matrices there, where they grow and where they do not.
#[test]
fn exponents_of_circular_motions() {
    let (part, p) = bearing(40.0, 1e14);
    let system = builder(0.0).part("bearing", part, p).build().unwrap().with(&[("chain.damping", 0.3)]).unwrap();
    let range = (60.0, 700.0);
    let request = Response { stability: false, ..Response::over(range.0, range.1) };
    let found = respond(&system, &request, &AtomicBool::new(false), &|_| {}).unwrap();
    let mut balance = Balance::new(&system, found.discretisation, range, None).unwrap();
    let mut assessor = Stability::new(&system).unwrap();
    let (mut stable, mut unstable) = (0, 0);
    for branch in &found.branches {
        for point in branch.points.iter().step_by(branch.points.len().div_ceil(30)) {
            balance.sample(&point.x, point.speed);
            let exponents = assessor.exponents(&mut balance, &point.x, point.speed).unwrap();
            let mut about = Equilibrium::zero(&system, Frame::Turning, point.speed);
            let (mut v, mut a) = (vec![0.0; system.n()], vec![0.0; system.n()]);
            Orbit::of(&mut balance, &point.x, point.speed).unwrap().at(0.0, &mut about.q, &mut v, &mut a, &mut about.z);
            let growth = all(&system, &about, f64::INFINITY).iter().map(|s| s.re).fold(f64::NEG_INFINITY, f64::max);
            assert!((exponents.growth() - growth).abs() <= 1e-6 * growth.abs() + 1e-9, "{} {growth}", exponents.growth());
            assert_eq!(exponents.unstable() > 0, growth > exponents.error);
            if growth > exponents.error { unstable += 1 } else { stable += 1 }
        }
    }
    let folds: Vec<f64> = found.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect();
    assert!(stable >= 6 && unstable >= 1, "{stable} {unstable} {folds:?}");
}

/// Derivatives of T over the speed and along s are those of its values.
#[test]
fn slopes_of_the_characteristic_matrix() {
    for (system, frame) in machines().iter().flat_map(|m| [(m, Frame::Fixed), (m, Frame::Turning)]) {
        let (speed, s, h) = (300.0, c(-4.0, 517.0), 1e-3);
        let at = |w: f64| Characteristic::new(system, &Equilibrium::zero(system, frame, w));
        let value = |w: f64, s: C64| at(w).entries(s)[0].clone();
        let (up, down) = (value(speed + h, s), value(speed - h, s));
        let by_speed = at(speed).linear_by_speed(s);
        let [_, by_s] = at(speed).entries(s);
        let (right, left) = (value(speed, s + c(h, 0.0)), value(speed, s - c(h, 0.0)));
        for e in 0..up.len() {
            let (over, along) = ((up[e] - down[e]).scale(0.5 / h), (right[e] - left[e]).scale(0.5 / h));
            assert!((over - by_speed[e]).abs() <= 1e-5 * (1.0 + over.abs()), "{frame:?} {over:?} {:?}", by_speed[e]);
            assert!((along - by_s[e]).abs() <= 1e-5 * (1.0 + along.abs()), "{frame:?} {along:?} {:?}", by_s[e]);
        }
    }
}
