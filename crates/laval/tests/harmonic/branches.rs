//! States beside the branches from the ends of the range, changes of stability and their kinds, branches that do not close.

use crate::common;

use common::base::{Base, defect, request, run};
use common::{number, rows};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::{Pair, System};
use laval::parts::{bearing_cubic::*, damper::*, disc::*};
use laval::solve::harmonic::balance::motion::Motion;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::bifurcation::Event;
use laval::solve::harmonic::branches::branch::{Origin, Traced};
use laval::solve::harmonic::branches::response::{Request, Response, States};
use laval::solve::harmonic::branches::unclosed::{Beyond, Unclosed};
use laval::solve::harmonic::stability::floquet::Stability;
use laval::solve::symmetry::Symmetry;
use laval_num::complex::C64;
use laval_num::continuation::End;
use laval_num::newton::{Options, newton};

fn all(base: Base, range: (f64, f64)) -> (System, Response) {
    let wanted = Request { truncation: 1e-7, states: States::All, starts: 18, ..request(range.0, range.1) };
    (base.builder().build().unwrap(), run(base.builder(), wanted))
}

/// A state of a branch corrected at a speed, with its exponents.
struct At {
    x: Vec<f64>,
    orbit: Orbit,
    exponents: Vec<C64>,
    stable: bool,
}

fn states<'a>(system: &'a System, branch: &Traced, speed: f64) -> (Balance<'a>, Vec<At>) {
    let mut balance = Balance::new(system, branch.discretisation, (speed, speed), None).unwrap();
    let mut assess = Stability::new(system).unwrap();
    let mut out: Vec<At> = Vec::new();
    for w in branch.points.windows(2) {
        let (a, b) = (w[0].speed, w[1].speed);
        if (a - speed) * (b - speed) > 0.0 || a == b {
            continue;
        }
        let t = (speed - a) / (b - a);
        let mut x: Vec<f64> = w[0].x.iter().zip(&w[1].x).map(|(p, q)| p + t * (q - p)).collect();
        newton(&mut balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).unwrap();
        balance.sample(&x, speed);
        let e = assess.exponents(&mut balance, &x, speed).unwrap();
        let orbit = Orbit::of(&mut balance, &x, speed).unwrap();
        out.push(At { exponents: e.descending(), stable: e.stable(), orbit, x });
    }
    (balance, out)
}

/// Without liquid the planes of the per-axis law do not couple: with 3 states in each there are 9, of which 4 can be held. The mixed ones move in each
/// plane as the symmetric ones do; turned by a quarter they are states too, with the same exponents.
#[test]
fn nine_states_of_two_planes() {
    let speed = 2850.0;
    let (system, r) = all(Base::default(), (2500.0, 3500.0));
    assert!(!r.more_families && r.unassessed.is_none());
    let (mut number, mut held, mut plane) = (0, 0, Vec::new());
    let amplitude = |o: &Orbit, i: usize| o.coordinates[o.orders.iter().position(|&k| k == 1).unwrap()][i].abs();
    for branch in r.branches.iter().filter(|b| b.discretisation.symmetry == Symmetry::Quarter) {
        for s in states(&system, branch, speed).1 {
            plane.push(amplitude(&s.orbit, 0));
        }
    }
    assert_eq!(plane.len(), 3, "{plane:?}");
    for branch in &r.branches {
        assert!(matches!(branch.end, End::Reached | End::Closed), "{:?}", branch.end);
        let (mut balance, found) = states(&system, branch, speed);
        for s in found {
            number += branch.images;
            held += branch.images * usize::from(s.stable);
            assert!(defect(&system, &s.orbit, 1) < 1e-6);
            for i in 0..2 {
                let a = amplitude(&s.orbit, i);
                assert!(plane.iter().any(|p| (a - p).abs() < 1e-7 * p), "{a} {plane:?}");
            }
            // the image, assessed by itself
            let turned = Motion { terms: &balance.terms, x: &s.x }.image(Symmetry::Quarter);
            let mut x = turned.clone();
            newton(&mut balance, &mut x, speed, &Options::default()).unwrap();
            assert!(x.iter().zip(&turned).all(|(a, b)| (a - b).abs() < 1e-9), "the image is a state");
            balance.sample(&x, speed);
            let e = Stability::new(&system).unwrap().exponents(&mut balance, &x, speed).unwrap().descending();
            for (a, b) in e.iter().zip(&s.exponents) {
                assert!((a.re - b.re).abs() < 1e-5, "{a:?} {b:?}");
            }
        }
    }
    assert_eq!((number, held), (9, 4));
    // the flat ellipse of the stable mixed state
    let mixed = r.branches.iter().filter(|b| b.images == 2);
    let ellipse = mixed.flat_map(|b| states(&system, b, speed).1).find(|s| s.stable).unwrap();
    let radius = (0..720).map(|k| {
        let [[x, y], ..] = ellipse.orbit.probe_at(&system.probes()[0], std::f64::consts::TAU * f64::from(k) / 720.0);
        x.hypot(y) / 1e-3
    });
    let (least, most) = radius.fold((f64::INFINITY, 0.0f64), |(l, m), r| (l.min(r), m.max(r)));
    assert!((least - 2.67).abs() < 0.01 && (most - 10.35).abs() < 0.01, "{least} {most}");
}

/// Liquid couples the planes; the mixed states are there all the same, and lie on a branch that a symmetry breaking or its own folds bound.
#[test]
fn mixed_states_of_a_filled_rotor() {
    let (system, r) = all(Base { fill: Some(0.93), chi: 300.0, ..Base::default() }, (2300.0, 2900.0));
    let mixed: Vec<&Traced> = r.branches.iter().filter(|b| b.images == 2).collect();
    assert!(!mixed.is_empty());
    for b in mixed {
        assert_eq!(b.discretisation.symmetry, Symmetry::Half);
        let speed = 0.5 * (b.points[0].speed + b.points[b.points.len() - 1].speed);
        for s in states(&system, b, speed).1 {
            assert!(defect(&system, &s.orbit, 1) < 1e-6);
        }
    }
}

/// Every row of the table: amplitudes of one plane, which are those of the circular orbit of both.
#[test]
fn subharmonic_of_order_one_third() {
    let unit = (1.1e7f64 / 2.4).sqrt();
    let range = (3.1 * unit, 5.05 * unit);
    let (system, r) = all(Base::default(), range);
    let family: Vec<&Traced> = r.branches.iter().filter(|b| b.turns() == 3 && b.discretisation.symmetry == Symmetry::Quarter).collect();
    assert_eq!(family.len(), 1, "{:?}", r.branches.iter().map(|b| b.origin).collect::<Vec<_>>());
    assert_eq!(family[0].origin, Origin::Subharmonic(3));
    assert_eq!(family[0].images, 3);
    let onset: Vec<f64> = family[0].folds.iter().map(|f| f.speed / unit).collect();
    assert!(onset.len() == 1 && (onset[0] - 3.172_372_26).abs() < 1e-8, "{onset:?}");
    for row in rows(include_str!("../reference/planar/subharmonic_third.csv")) {
        let speed = number(row[0]) * unit;
        let (_, found) = states(&system, family[0], speed);
        assert_eq!(found.len(), 2);
        let near = |s: &&At| (s.orbit.whirl(&Pair::coordinates(0), 1).1.abs() / number(row[1]) - 1.0).abs() < 1e-6;
        let s = found.iter().find(near).unwrap_or_else(|| panic!("{row:?}"));
        assert!((s.orbit.whirl(&Pair::coordinates(0), 3).0.abs() / number(row[2]) - 1.0).abs() < 1e-6, "{row:?}");
        assert_eq!(s.stable, row[5] == "1", "{row:?}");
    }
}

/// One harmonic: the share of the power of the unbalance tends to (chi T^2 + chi0 (m'/(M + m'))^2) / (T m e sqrt(kap c1/mu)), 1 at the critical damping.
#[test]
fn whether_a_branch_closes() {
    for (isotropic, fill, critical) in
        [(false, None, 454.00), (true, None, 524.24), (false, Some(0.667), 405.40), (true, Some(0.667), 468.13)]
    {
        for chi in [42.0, 0.985 * critical] {
            let base = Base { isotropic, fill, chi, ..Base::default() };
            let r = run(base.builder(), Request { harmonics: Some(1), stability: false, ..request(500.0, 60_000.0) });
            let u = r.unclosed.unwrap_or_else(|| panic!("{base:?}"));
            let m = 2.4 + fill.map_or(0.0, |_| 0.923_628_24);
            let (t, kap) = (25.0 / (25.0 + m), if isotropic { 1.0 } else { 0.75 });
            let mu = m * 25.0 / (m + 25.0);
            let want = (chi * t * t + 6.59 * (m / (25.0 + m)).powi(2)) / (t * 2.4 * 1e-3 * (kap * 8.7e10f64 / mu).sqrt());
            let Beyond::Tends(limit) = u.beyond else { panic!("{base:?}: {u:?}") };
            assert!((limit - want).abs() < 1e-7 * want && limit < 1.0, "{base:?}: {u:?} {want}");
            assert!((u.rise - 1.0).abs() < 0.01 && u.amplitude > 10.0 * u.low_amplitude);
        }
        // above the critical damping, where the fold lies beyond the range
        let base = Base { isotropic, fill, chi: 1.01 * critical, ..Base::default() };
        let r = run(base.builder(), Request { harmonics: Some(1), stability: false, ..request(500.0, 12_000.0) });
        let Some(Unclosed { beyond: Beyond::Closes(at), share, .. }) = r.unclosed else { panic!("{base:?}: {:?}", r.unclosed) };
        let whole = run(base.builder(), Request { harmonics: Some(1), stability: false, ..request(500.0, 1.2 * at) });
        let last = whole.branches[0].folds.iter().find(|f| f.upper).unwrap_or_else(|| panic!("{base:?}"));
        assert!(share < 1.0 && at > 12_000.0 && (at / last.speed - 1.0).abs() < 1e-9, "{base:?} {at} {last:?}");
        let closed = Base { chi: 600.0, ..base };
        assert!(run(closed.builder(), Request { harmonics: Some(1), stability: false, ..request(500.0, 60_000.0) }).unclosed.is_none());
    }
}

/// A rotor on an isotropic spring whose range ends not far above its resonance: the share of the power tends to `c sqrt(m/k3)/(m e)` with 1/speed.
#[test]
fn a_short_range_does_not_mislead_about_closing() {
    let (m, e, k, k3) = (10.0f64, 2e-5, 1e6, 2e13f64);
    for c in [200.0, 240.0, 280.0, 290.0] {
        let link = || Link::Between(Attach::on("rotor"), Attach::ground());
        let disc = DiscParams { eccentricity: e, ..DiscParams::new(m) };
        let law = BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [k3; 2], valid_to: 0.0 };
        let built = Builder::new("jeffcott")
            .part("rotor", Disc::planar(), disc)
            .part("bearing", BearingCubic::isotropic(link()), law)
            .part("loss", Damper::fixed(link()), DamperParams { damping: [c; 2], tilt_damping: 0.0 });
        let r = run(built, request(100.0, 900.0));
        let want = c * (m / k3).sqrt() / (m * e);
        match r.unclosed.unwrap_or_else(|| panic!("{c}")).beyond {
            Beyond::Tends(limit) => assert!(want < 1.0 && (limit - want).abs() < 1e-6, "{c} {limit} {want}"),
            Beyond::Closes(at) => {
                // on the ridge of the resonance: c w a = m e w^2 with k + k3 a^2 = m w^2
                let ridge = (k / m / (1.0 - 1.0 / (want * want))).sqrt();
                assert!(want > 1.0 && (at / ridge - 1.0).abs() < 0.01, "{c} {at} {ridge}");
            }
            Beyond::Lost(at) => panic!("{c} {at}"),
        }
    }
}

/// A rotor that only tilts, between two isotropic bearings that harden: its reference point does not move, those of the bearings do. The share of the power tends
/// to `2 c / (tau sqrt(2 k3 (A - C)))`, with the damping c at each bearing.
#[test]
fn a_branch_of_tilts_does_not_close_either() {
    let (a, polar, arm, skew, k, k3) = (0.05f64, 0.02, 0.1, 2e-4, 1e6, 2e13f64);
    for c in [40.0, 70.0] {
        let link = |z: f64| Link::Between(Attach::at("rotor", z), Attach::ground());
        let disc = DiscParams { diametral_inertia: a, polar_inertia: polar, skew, ..DiscParams::new(10.0) };
        let law = || BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [k3; 2], valid_to: 0.0 };
        let loss = || DamperParams { damping: [c; 2], tilt_damping: 0.0 };
        let built = Builder::new("tilting")
            .part("rotor", Disc::tilting(), disc)
            .part("low", BearingCubic::isotropic(link(-arm)), law())
            .part("high", BearingCubic::isotropic(link(arm)), law())
            .part("low loss", Damper::fixed(link(-arm)), loss())
            .part("high loss", Damper::fixed(link(arm)), loss());
        let u = run(built, request(300.0, 4000.0)).unclosed.unwrap_or_else(|| panic!("{c}"));
        let want = 2.0 * c / (skew * (2.0 * k3 * (a - polar)).sqrt());
        let Beyond::Tends(limit) = u.beyond else { panic!("{c}: {u:?}") };
        assert!((limit - want).abs() < 1e-6 && want < 1.0, "{c}: {u:?} {want}");
        assert!((u.rise - 1.0).abs() < 0.1 && u.amplitude > 10.0 * u.low_amplitude, "{u:?}");
    }
}

/// The upper branch of the filled rotor becomes stable through a second frequency, that of the slow wave. Isotropic: where the largest growth rate of the
/// twelve-state matrix of the rotating frame, written out from the equations and bisected, changes its sign.
#[test]
fn liquid_waves_are_neimark_sacker() {
    let unit = (1.1e7f64 / 2.4).sqrt();
    for (isotropic, s, tolerance) in [(true, 0.964_900_591_55, 1e-8), (false, 0.97, 0.01)] {
        let base = Base { isotropic, fill: Some(0.667), ..Base::default() };
        let r = run(base.builder(), Request { truncation: 1e-7, ..request(1500.0, 3000.0) });
        let changes: Vec<_> = r.branches.iter().filter(|b| b.from_low()).flat_map(|b| &b.changes).collect();
        let gained: Vec<_> = changes.iter().filter(|c| c.unstable == (2, 0)).collect();
        assert_eq!(gained.len(), 1, "{changes:?}");
        let c = gained[0];
        assert!((c.speed / unit - s).abs() < tolerance, "{}", c.speed / unit);
        assert!(c.event == Event::NeimarkSacker && c.located && c.growth.abs() < 1e-5, "{c:?}");
        // the wave of a tank at rest is at 1 + (1 - sqrt(1 + gamma))/gamma of the spin
        let gamma = (1.0 + 0.667f64 * 0.667) / (1.0 - 0.667 * 0.667);
        let wave = 1.0 + (1.0 - (1.0 + gamma).sqrt()) / gamma;
        assert!((c.frequency / c.speed / wave - 1.0).abs() < 0.02, "{c:?} {wave}");
    }
}

/// Three ways to assess: the map over a quarter of the period, over the whole, and Hill's.
#[test]
fn stability_by_other_methods() {
    for base in [
        Base::default(),
        Base { isotropic: true, ..Base::default() },
        Base { fill: Some(0.667), wave_damping: 1.0, ..Base::default() },
        Base { isotropic: true, fill: Some(0.8), ..Base::default() },
    ] {
        for sign in [1.0, -1.0] {
            let (lo, hi) = if sign > 0.0 { (2000.0, 3000.0) } else { (-3000.0, -2000.0) };
            let r = run(base.builder(), Request { truncation: 1e-8, check_stability: true, ..request(lo, hi) });
            let a = r.agreement.unwrap();
            assert!(a.contradictions == 0 && a.failed.is_none(), "{base:?} {a:?}");
            assert!(a.states >= 3 && a.assessed == [a.states, a.states], "{a:?}");
            assert!(a.difference[0] < 1e-5 && a.difference[1] < 1e-5, "{base:?} {a:?}");
        }
    }
}
