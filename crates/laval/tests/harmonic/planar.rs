//! Harmonic balance of the planar machine by checks that know no table: symmetries, similarity, evidence, limits.

use crate::common;

use common::base::{Base, request, run, states_at};
use common::shaft::cubic_text;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::{Balance, Discretisation};
use laval::solve::harmonic::balance::terms::Terms;
use laval::solve::harmonic::branches::response::{Request, Response};
use laval::solve::symmetry::Symmetry;
use laval_num::continuation::End;

const RANGE: (f64, f64) = (25.0, 8000.0);

fn response(base: Base) -> Response {
    run(base.builder(), Request { truncation: 1e-7, ..request(RANGE.0, RANGE.1) })
}

fn fold_speeds(r: &Response) -> Vec<f64> {
    r.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect()
}

/// Branches reach the end of the range; folds are located by two methods and hold with more orders; stability changes only at folds.
#[test]
fn folds_carry_their_evidence() {
    for (base, branches, folds) in [
        (Base { e: 5e-5, ..Base::default() }, 1, 2),
        (Base::default(), 2, 1),
        (Base { isotropic: true, ..Base::default() }, 2, 1),
        (Base { chi: 600.0, ..Base::default() }, 1, 2),
    ] {
        let r = response(base);
        assert_eq!((r.branches.len(), fold_speeds(&r).len()), (branches, folds), "{base:?}");
        assert!(r.unassessed.is_none() && r.sampling < 1e-12, "{}", r.sampling);
        for b in &r.branches {
            assert_eq!(b.end, End::Reached);
            assert!(b.changes.is_empty() && b.branch_points.is_empty(), "{:?} {:?}", b.changes, b.branch_points);
            assert!(b.points.iter().all(|p| p.residual < 1e-11 && p.truncation < 1e-6 && p.exponents.is_some()));
            for f in &b.folds {
                assert!(f.confirmed && f.residual < 1e-12, "{f:?}");
                assert!(f.methods_differ.abs() < 1e-8 && f.harmonics_change.abs() < 1e-8, "{f:?}");
                // one side of a fold is unstable
                assert_ne!(b.points[f.after].stable(), b.points[f.after + 1].stable());
            }
        }
    }
}

#[test]
fn exchange_of_the_axes_changes_nothing() {
    let machine = |swap: bool| {
        let two = |a: f64, b: f64| if swap { [b, a] } else { [a, b] };
        let link = || Link::Between(Attach::on("drum"), Attach::on("base"));
        Builder::new("two axes")
            .part("drum", Disc::planar(), DiscParams { eccentricity: 5e-5, ..DiscParams::new(2.4) })
            .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: two(3e5, 5e5), damping: two(7.0, 9.0) })
            .part(
                "bearing",
                BearingCubic::per_axis(link()),
                BearingCubicParams { stiffness: two(1.1e7, 1.5e7), cubic_stiffness: two(8.7e10, 5e10), valid_to: 0.0 },
            )
            .part(
                "air",
                Damper::fixed(Link::Between(Attach::on("drum"), Attach::ground())),
                DamperParams { damping: two(60.0, 80.0), tilt_damping: 0.0 },
            )
    };
    let range = (1000.0, 4000.0);
    let (a, b) = (run(machine(false), request(range.0, range.1)), run(machine(true), request(range.0, range.1)));
    assert_eq!(a.discretisation.symmetry, Symmetry::Half);
    let (fa, fb) = (fold_speeds(&a), fold_speeds(&b));
    assert!(fa.len() >= 2 && fa.len() == fb.len(), "{fa:?} {fb:?}");
    for (x, y) in fa.iter().zip(&fb) {
        assert!((x - y).abs() < 1e-9 * x, "{fa:?} {fb:?}");
    }
}

#[test]
fn direction_of_the_unbalance_does_not_move_isotropic_folds() {
    let at = |degrees: f64| response(Base { isotropic: true, chi: 600.0, phase: degrees.to_radians(), ..Base::default() });
    let (a, b) = (fold_speeds(&at(0.0)), fold_speeds(&at(37.0)));
    assert_eq!((a.len(), b.len()), (2, 2));
    for (x, y) in a.iter().zip(&b) {
        assert!((x - y).abs() < 1e-11 * x, "{a:?} {b:?}");
    }
}

/// With another unit of length the same numbers follow, scaled.
#[test]
fn unit_of_length_is_free() {
    for metre in [0.1, 2.0] {
        for isotropic in [false, true] {
            let (a, b) = (
                Base { isotropic, chi: 600.0, fill: Some(0.667), ..Base::default() },
                Base { isotropic, chi: 600.0, fill: Some(0.667), metre, ..Base::default() },
            );
            let (ra, rb) = (response(a), response(b));
            let (fa, fb) = (fold_speeds(&ra), fold_speeds(&rb));
            assert_eq!((fa.len(), fb.len()), (2, 2), "metre {metre} isotropic {isotropic}");
            for (x, y) in fa.iter().zip(&fb) {
                assert!((x - y).abs() < 1e-9 * x, "{fa:?} {fb:?}");
            }
            for speed in [500.0, 2300.0] {
                let [sa, sb] = [(a, &ra), (b, &rb)].map(|(base, r)| states_at(&base.builder().build().unwrap(), r, RANGE, speed, false));
                assert_eq!(sa.len(), sb.len());
                for (x, y) in sa.iter().zip(&sb) {
                    assert!((x.z[0] - y.z[0] * metre).abs() < 1e-9 * x.z[0], "{} {}", x.z[0], y.z[0] * metre);
                }
            }
        }
    }
}

fn orbits(system: &System, r: &Response, range: (f64, f64)) -> Vec<Orbit> {
    let mut balance = Balance::new(system, r.discretisation, range, None).unwrap();
    r.branches.iter().flat_map(|b| &b.points).map(|p| Orbit::of(&mut balance, &p.x, p.speed).unwrap()).collect()
}

/// Motions along a direction in the unknowns and the speed, by their derivatives and by differences: of a small machine, and of one whose matrices are banded.
#[test]
fn motions_beside_one_are_those_of_their_unknowns() {
    let small = Base { isotropic: true, chi: 600.0, c0: 2e6, c1: 2e12, ..Base::default() }.builder().horizontal().build().unwrap();
    let long = laval::file::load(&cubic_text(21)).unwrap_or_else(|d| panic!("{d:?}")).system;
    let discretised =
        |harmonics: usize, symmetry| Discretisation { harmonics, divisor: 1, samples: Terms::samples(harmonics, 1), symmetry };
    let machines = [(&small, discretised(5, Symmetry::None), (500.0, 3000.0)), (&long, discretised(1, Symmetry::Circular), (100.0, 400.0))];
    for (system, d, range) in machines {
        let mut balance = Balance::new(system, d, range, None).unwrap();
        let along = |f: &dyn Fn(f64) -> f64| balance.scales().iter().enumerate().map(|(i, s)| 0.05 * s * f(i as f64 + 1.0)).collect();
        let (x, dx): (Vec<f64>, Vec<f64>) = (along(&f64::cos), along(&f64::sin));
        let (speed, rate, h) = (0.6 * range.1, 0.1 * range.1, 1e-4);
        let mut at = |h: f64| {
            let x: Vec<f64> = x.iter().zip(&dx).map(|(x, d)| x + h * d).collect();
            Orbit::of(&mut balance, &x, speed + h * rate).unwrap()
        };
        let [before, after, orbit] = [-h, h, 0.0].map(&mut at);
        let [less, more] = orbit.beside(&mut balance, (&x, speed), (&dx, rate), h).unwrap();
        assert_eq!((less.speed, more.frequency), (speed - h * rate, after.frequency));
        let change = |a: &Orbit, b: &Orbit| -> Vec<f64> {
            let of = |o: &Orbit| o.coordinates.iter().chain(&o.states).flatten().copied().collect::<Vec<_>>();
            of(a).iter().zip(of(b)).map(|(a, b)| (b - *a).abs()).collect()
        };
        let by_differences = change(&before, &after);
        let size = by_differences.iter().copied().fold(0.0, f64::max);
        assert!(size > 0.0);
        // the difference of both: what central differences leave out
        for orbits in [(&before, &less), (&after, &more)] {
            let apart = change(orbits.0, orbits.1).into_iter().fold(0.0, f64::max);
            assert!(apart < 1e-3 * size, "{apart:e} of {size:e}");
        }
        let slopes = less.coordinates.iter().flatten().zip(more.coordinates.iter().flatten());
        let differences = before.coordinates.iter().flatten().zip(after.coordinates.iter().flatten());
        for ((a, b), (c, d)) in slopes.zip(differences) {
            assert!(((*b - *a) - (*d - *c)).abs() < 1e-6 * size, "{a:?} {b:?} {c:?} {d:?}");
        }
    }
}

/// Weight takes all symmetry: even orders and a static deflection appear, and go with the weight.
#[test]
fn weight_brings_even_orders() {
    let range = (500.0, 3000.0);
    let machine = |horizontal: bool| {
        let b = Base { isotropic: true, chi: 600.0, c0: 2e6, c1: 2e12, ..Base::default() }.builder();
        if horizontal { b.horizontal() } else { b }
    };
    let r = run(machine(true), Request { truncation: 1e-7, ..request(range.0, range.1) });
    assert_eq!(r.discretisation.symmetry, Symmetry::None);
    // the weight acts through every part that has mass
    assert!(r.broken.iter().any(|b| b.part == "drum"), "{:?}", r.broken);
    let system = machine(true).build().unwrap();
    for o in orbits(&system, &r, range) {
        let order = |k: usize| o.orders.iter().position(|&x| x == k).map(|i| o.coordinates[i][1].abs()).unwrap();
        assert!(order(2) > 1e-9 * order(1), "{}: {}", o.speed, order(2));
        // the foundation carries the weight of both
        let sag = o.coordinates[0][3].re;
        assert!((sag + 27.4 * 9.80665 / 3.26e5).abs() < 1e-9 * sag.abs(), "{sag}");
    }
    let upright = run(machine(false), request(range.0, range.1));
    assert_eq!(upright.discretisation.symmetry, Symmetry::Circular);
}

/// A tilting disc on two nonlinear bearings in different planes: balance of the assembled machine along every motion.
#[test]
fn tilting_disc_on_two_bearings() {
    for (isotropic, symmetry) in [(true, Symmetry::Circular), (false, Symmetry::Quarter)] {
        let disc = DiscParams {
            eccentricity: 1e-4,
            polar_inertia: 0.06,
            diametral_inertia: 0.04,
            skew: 2e-3,
            skew_phase: 1.0,
            centre_of_mass: 0.02,
            ..DiscParams::new(5.0)
        };
        let bearing = |z: f64| {
            let link = Link::Between(Attach::at("disc", z), Attach::ground());
            if isotropic { BearingCubic::isotropic(link) } else { BearingCubic::per_axis(link) }
        };
        let law = |k: f64| BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [1e6 * k; 2], valid_to: 0.0 };
        let air = Link::Between(Attach::at("disc", 0.1), Attach::ground());
        let b = Builder::new("two bearings")
            .part("disc", Disc::tilting(), disc)
            .part("lower", bearing(-0.1), law(1e6))
            .part("upper", bearing(0.15), law(2e6))
            .part("air", Damper::fixed(air), DamperParams { damping: [80.0; 2], tilt_damping: 0.0 });
        let range = (100.0, 900.0);
        let r = run(b.clone(), request(range.0, range.1));
        assert_eq!(r.discretisation.symmetry, symmetry);
        let system = b.build().unwrap();
        for o in orbits(&system, &r, range) {
            let d = common::base::defect(&system, &o, 1);
            assert!(d < 1e-8, "{isotropic} at {}: {d:e}", o.speed);
        }
    }
}

/// Without any damping the peak is infinite: the branch ends, and its points are the closed form.
#[test]
fn undamped_resonance_ends() {
    let link = Link::Between(Attach::on("disc"), Attach::ground());
    let p = BearingCubicParams { stiffness: [2e6; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
    let b = Builder::new("undamped").part("disc", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(3.0) }).part(
        "spring",
        BearingCubic::isotropic(link),
        p,
    );
    let r = run(b, Request { stability: false, ..request(100.0, 3000.0) });
    let peak = (2e6f64 / 3.0).sqrt();
    assert_eq!(r.branches.len(), 2);
    for branch in &r.branches {
        assert!(branch.points.len() < 3000, "{} points, {:?}", branch.points.len(), branch.end);
        for p in branch.points.iter().filter(|p| (p.speed - peak).abs() > 1e-3 * peak) {
            let exact = 1e-4 * p.speed * p.speed / (peak * peak - p.speed * p.speed);
            assert!((p.x[0] - exact).abs() < 1e-11 * exact.abs(), "{}: {} {exact}", p.speed, p.x[0]);
        }
    }
}
