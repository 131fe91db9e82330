//! A rotor that moves in one plane on a cubic spring without linear part, `x'' + d x' + c x^3 = e W^2 cos W t`: symmetry breaking, period doubling and isolated
//! subharmonics; the first two against integration of that equation written out here.

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*};
use laval::solve::harmonic::balance::motion::Motion;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::{Balance, Discretisation};
use laval::solve::harmonic::balance::terms::Terms;
use laval::solve::harmonic::branches::bifurcation::{Change, Event};
use laval::solve::harmonic::branches::branch::{Origin, Traced};
use laval::solve::harmonic::branches::response::{Request, Response, States, respond};
use laval::solve::harmonic::stability::floquet::Stability;
use laval::solve::symmetry::Symmetry;
use laval_num::newton::{Options, newton};
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

/// Mass 1 kg; the plane y is held by a stiff linear spring.
#[derive(Clone, Copy)]
struct Duffing {
    /// Damping, N s/m.
    d: f64,
    /// Cubic stiffness, N/m^3.
    c: f64,
    /// Eccentricity, m.
    e: f64,
}

const CASCADE: Duffing = Duffing { d: 20.0, c: 1e10, e: 4e-3 };
const WEAK: Duffing = Duffing { d: 10.0, c: 1e10, e: 3e-3 };

impl Duffing {
    fn system(self) -> System {
        let link = || Link::Between(Attach::on("drum"), Attach::ground());
        let disc = DiscParams { eccentricity: self.e, ..DiscParams::new(1.0) };
        let law = BearingCubicParams { stiffness: [0.0, 1e7], cubic_stiffness: [self.c, 0.0], valid_to: 0.0 };
        Builder::new("duffing")
            .part("drum", Disc::planar(), disc)
            .part("spring", BearingCubic::per_axis(link()), law)
            .part("air", Damper::fixed(link()), DamperParams { damping: [self.d, 1000.0], tilt_damping: 0.0 })
            .build()
            .unwrap()
    }

    fn response(self, system: &System, (lo, hi): (f64, f64), harmonics: usize, time_starts: usize) -> Response {
        static NEVER: AtomicBool = AtomicBool::new(false);
        let all = Request { harmonics: Some(harmonics), states: States::All, starts: 0, time_starts, ..Request::over(lo, hi) };
        respond(system, &all, &NEVER, &|_| {}).unwrap()
    }

    /// The motion and its two derivatives in the start after so many forcing periods (classical Runge-Kutta, 2000 steps a period).
    fn flow(&self, w: f64, periods: f64, y: [f64; 2]) -> [f64; 6] {
        let rate = |t: f64, s: [f64; 6]| {
            let k = 3.0 * self.c * s[0] * s[0];
            let force = self.e * w * w * (w * t).cos();
            [s[1], force - self.d * s[1] - self.c * s[0].powi(3), s[3], -self.d * s[3] - k * s[2], s[5], -self.d * s[5] - k * s[4]]
        };
        let steps = (2000.0 * periods).round() as usize;
        let h = TAU / w * periods / steps as f64;
        let mut s = [y[0], y[1], 1.0, 0.0, 0.0, 1.0];
        let plus = |s: [f64; 6], k: [f64; 6], f: f64| std::array::from_fn(|i| s[i] + f * k[i]);
        for i in 0..steps {
            let t = h * i as f64;
            let a = rate(t, s);
            let b = rate(t + 0.5 * h, plus(s, a, 0.5 * h));
            let c = rate(t + 0.5 * h, plus(s, b, 0.5 * h));
            let d = rate(t + h, plus(s, c, h));
            s = std::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        s
    }

    /// Displacement and velocity at the ends of the last `keep` of so many periods.
    fn sections(&self, w: f64, periods: usize, keep: usize, mut y: [f64; 2]) -> Vec<[f64; 2]> {
        let mut out = Vec::new();
        for p in 0..periods {
            let s = self.flow(w, 1.0, y);
            y = [s[0], s[1]];
            if p + keep >= periods {
                out.push(y);
            }
        }
        out
    }
}

/// x and its rate on an orbit at a base phase.
fn at(system: &System, orbit: &Orbit, tau: f64) -> [f64; 2] {
    let n = system.n();
    let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![]);
    orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
    [q[0], v[0]]
}

/// The motion of a branch near `x` at a speed with four times as many orders: orbit and whether it is stable.
fn finer(system: &System, coarse: Discretisation, x: &[f64], speed: f64) -> (Orbit, bool) {
    let harmonics = 4 * coarse.harmonics;
    let fine = Discretisation { harmonics, samples: Terms::alias_free(3, harmonics), ..coarse };
    let terms = Balance::new(system, coarse, (speed, speed), None).unwrap().terms;
    let mut balance = Balance::new(system, fine, (speed, speed), None).unwrap();
    let mut x = Motion { terms: &terms, x }.carried(&balance.terms);
    newton(&mut balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).unwrap();
    balance.sample(&x, speed);
    let stable = Stability::new(system).unwrap().exponents(&mut balance, &x, speed).unwrap().stable();
    (Orbit::of(&mut balance, &x, speed).unwrap(), stable)
}

/// States of a branch at a speed: orbits and whether they are stable.
fn states(system: &System, branch: &Traced, speed: f64) -> Vec<(Orbit, bool)> {
    let mut out = Vec::new();
    for w in branch.points.windows(2).filter(|w| (w[0].speed - speed) * (w[1].speed - speed) <= 0.0 && w[0].speed != w[1].speed) {
        let t = (speed - w[0].speed) / (w[1].speed - w[0].speed);
        let x: Vec<f64> = w[0].x.iter().zip(&w[1].x).map(|(p, q)| p + t * (q - p)).collect();
        out.push(finer(system, branch.discretisation, &x, speed));
    }
    out
}

/// Where the motion of a branch is assessed most stable: speed, orbit with four times as many orders.
fn most_stable(system: &System, branch: &Traced) -> Option<Orbit> {
    let point = branch.points.iter().filter(|p| p.stable()).min_by(|a, b| a.growth().total_cmp(&b.growth()))?;
    let (orbit, stable) = finer(system, branch.discretisation, &point.x, point.speed);
    assert!(stable, "{}", point.speed);
    Some(orbit)
}

fn apart(a: [f64; 2], b: [f64; 2], w: f64) -> f64 {
    (a[0] - b[0]).hypot((a[1] - b[1]) / w)
}

/// Whether motions in time that begin beside an orbit, by this share, come back to it: largest distance of the last sections from the orbit's own points.
fn returns(machine: Duffing, system: &System, orbit: &Orbit, turns: usize, share: f64) -> f64 {
    let w = orbit.speed;
    let points: Vec<[f64; 2]> = (0..turns).map(|k| at(system, orbit, TAU * k as f64 / turns as f64)).collect();
    let start = [points[0][0] * (1.0 + share) + 1e-6, points[0][1] * (1.0 - share)];
    let last = machine.sections(w, 240 * turns, turns, start);
    let nearest = |p: &[f64; 2]| points.iter().map(|q| apart(*p, *q, w)).fold(f64::INFINITY, f64::min);
    last.iter().map(nearest).fold(0.0, f64::max)
}

/// det(M - s I) of the map over a part of the period (`sign` turns it back), by the equation written out above.
fn determinant(machine: Duffing, w: f64, y: [f64; 2], periods: f64, s: f64) -> f64 {
    let f = machine.flow(w, periods, y);
    (f[2] - s) * (f[5] - s) - f[3] * f[4]
}

fn changes(branch: &Traced, event: Event) -> Vec<&Change> {
    branch.changes.iter().filter(|c| c.event == event).collect()
}

fn orbit_of(system: &System, branch: &Traced, c: &Change) -> Orbit {
    let mut balance = Balance::new(system, branch.discretisation, (c.speed, c.speed), None).unwrap();
    Orbit::of(&mut balance, &c.point.x, c.speed).unwrap()
}

/// With falling speed the symmetric motion loses its symmetry, the pair that branches off doubles its period: both are found where the multiplier of the
/// equation itself says so, and motions in time settle on the less symmetric branch where it is assessed stable, and leave it where it is not.
#[test]
fn symmetry_breaking_and_period_doubling() {
    let machine = CASCADE;
    let system = machine.system();
    let r = machine.response(&system, (48.0, 1500.0), 15, 0);
    let main =
        r.branches.iter().position(|b| b.discretisation.symmetry == Symmetry::Half && !changes(b, Event::SymmetryBreaking).is_empty());
    let main = main.unwrap_or_else(|| panic!("{:?}", r.branches.iter().map(|b| (b.origin, &b.changes)).collect::<Vec<_>>()));
    for c in changes(&r.branches[main], Event::SymmetryBreaking) {
        let y = at(&system, &orbit_of(&system, &r.branches[main], c), 0.0);
        // -1 over half the period turned back is +1 of the map over half the period
        let there = determinant(machine, c.speed, y, 0.5, 1.0);
        assert!(there.abs() < 1e-5, "{} {there}", c.speed);
    }
    let broken: Vec<usize> =
        (0..r.branches.len()).filter(|&i| matches!(r.branches[i].origin, Origin::Broken(from, _) if from == main)).collect();
    assert!(!broken.is_empty(), "{:?}", r.branches.iter().map(|b| b.origin).collect::<Vec<_>>());
    let mut settled = 0;
    let mut doubled = 0;
    for &b in &broken {
        let branch = &r.branches[b];
        let Origin::Broken(_, from) = branch.origin else { continue };
        let first = branch.points.iter().map(|p| (p.speed - from).abs()).fold(f64::INFINITY, f64::min);
        assert!(first < 0.02 * from, "the branch begins where the symmetry is lost: {first}");
        assert_eq!(branch.images, 2, "a motion and the one turned by half a turn");
        for speed in [62.0, 100.0, 140.0, 165.0] {
            for (orbit, stable) in states(&system, branch, speed) {
                // an even order: the mean
                let mean = orbit.orders.iter().position(|&k| k == 0).map_or(0.0, |i| orbit.coordinates[i][0].abs());
                assert!(mean > 1e-5, "{speed} {mean}");
                let back = returns(machine, &system, &orbit, 1, 0.002);
                assert_eq!(stable, back < 1e-7 * machine.e, "{speed} {back}");
                settled += usize::from(stable);
            }
        }
        for c in changes(branch, Event::PeriodDoubling) {
            // the multiplier of the equation passes -1 where laval says it does, within what the orders of the branch leave out
            let [below, above] = [-0.02, 0.02].map(|by| {
                let speed = c.speed + by;
                let (orbit, stable) = finer(&system, branch.discretisation, &c.point.x, speed);
                let there = determinant(machine, speed, at(&system, &orbit, 0.0), 1.0, -1.0);
                assert_eq!(stable, there > 0.0, "{speed} {there}");
                there
            });
            assert!(below * above < 0.0, "{} {below} {above}", c.speed);
            doubled += 1;
        }
    }
    assert!(settled >= 3 && doubled >= 1, "{settled} {doubled}");
    let twice: Vec<&Traced> =
        r.branches.iter().filter(|b| matches!(b.origin, Origin::Doubled(from, _) if broken.contains(&from))).collect();
    let mut seen = 0;
    for branch in twice {
        assert_eq!(branch.turns(), 2);
        let Some(orbit) = most_stable(&system, branch) else { continue };
        let back = returns(machine, &system, &orbit, 2, 0.002);
        assert!(back < 1e-7 * machine.e, "{} {back}", orbit.speed);
        let (a, b) = (at(&system, &orbit, 0.0), at(&system, &orbit, 0.5 * TAU));
        assert!(apart(a, b, orbit.speed) > 1e-5, "{a:?} {b:?}");
        seen += 1;
    }
    assert!(seen >= 1);
}

/// Motions of two turns that no other start finds: isolated families, on which a few of the starts in time settle.
#[test]
fn isolated_subharmonics_are_found_in_time() {
    let system = WEAK.system();
    let found = |starts| {
        let r = WEAK.response(&system, (300.0, 2000.0), 7, starts);
        r.branches.into_iter().filter(|b| b.turns() == 2).collect::<Vec<Traced>>()
    };
    assert!(found(0).is_empty());
    let families = found(96);
    let mut seen = 0;
    for branch in &families {
        assert_eq!(branch.origin, Origin::Subharmonic(2));
        assert!(branch.points.iter().all(|p| p.residual < 1e-8));
        let Some(orbit) = most_stable(&system, branch) else { continue };
        let back = returns(WEAK, &system, &orbit, 2, 0.002);
        assert!(back < 1e-7 * WEAK.e, "{} {back}", orbit.speed);
        seen += 1;
    }
    assert!(seen >= 1, "no stable motion of two turns");
}
