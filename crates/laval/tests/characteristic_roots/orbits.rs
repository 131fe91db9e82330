//! Stability of periodic motions on Hill's determinant.

use super::viscous::one_coordinate;
use super::{at, build, changed};
use crate::common::Planar;
use laval::solve::harmonic::determinant::exponents;
use laval::solve::harmonic::floquet::Method;
use laval::solve::harmonic::response::{Request, respond};
use laval::solve::roots;
use std::sync::atomic::AtomicBool;

/// A liquid that has a form in time, judged both ways: orbits that are no circles, stable and unstable.
#[test]
fn the_map_over_the_period_agrees() {
    let never = AtomicBool::new(false);
    let mut worst = 0.0f64;
    let (mut compared, mut unstable) = (0, 0);
    for (fill, range) in [(0.667, (2200.0, 2500.0))] {
        let system = Planar { fill, delta: 3.0, ..Planar::default() }.build();
        let found = respond(&system, &Request { harmonics: Some(9), ..Request::over(range.0, range.1) }, &never, &|_| {}).unwrap();
        for branch in &found.branches {
            for state in branch.points.iter().step_by(branch.points.len() / 4 + 1) {
                let first = state.exponents.as_ref().unwrap();
                let second = exponents(&system, branch.discretisation, &state.x, state.speed, &[]).unwrap();
                let room = 1e-8 * state.speed;
                assert_eq!(second.method, Method::Determinant);
                let growing = |e: &laval::solve::harmonic::floquet::Exponents| e.values.iter().filter(|z| z.re > 1e-3).count();
                assert_eq!(growing(first), growing(&second), "{} rad/s: {first:?} {second:?}", state.speed);
                // of those that decay some are known
                assert!(growing(first) == 0 || (first.growth() - second.growth()).abs() < room, "{first:?} {second:?}");
                for z in &second.values {
                    let off = first.values.iter().map(|f| (f.re - z.re).abs()).fold(f64::INFINITY, f64::min);
                    worst = worst.max(off / state.speed);
                    assert!(off < room, "{} rad/s: {z:?} is not among {:?}", state.speed, first.values);
                }
                compared += second.values.len();
                unstable += growing(&second);
            }
        }
    }
    println!("{compared} exponents, {unstable} of them growing; largest difference over the speed {worst:.1e}");
    assert!(compared > 15 && unstable > 0);
}

/// With a bearing that is not nonlinear after all the exponents are the roots of the characteristic function, up to multiples of the speed.
#[test]
fn a_viscous_liquid_on_a_linear_bearing() {
    let never = AtomicBool::new(false);
    for (zeta, nu, speed) in [(0.05, 1e-3, 150.0), (0.05, 1e-2, 200.0), (0.0, 1e-4, 125.0)] {
        let text = one_coordinate(zeta, nu);
        let linear = build(&text);
        let bearing = text.replace("kind = \"shaft_lumped\"", "kind = \"bearing_cubic\"\nlaw = \"isotropic\"\ncubic_stiffness = 0");
        let system = build(&changed(&bearing, &[("polar_inertia = 1", "polar_inertia = 1\neccentricity = 1e-4")]));
        let found = respond(&system, &Request { stability: false, ..Request::over(speed - 0.1, speed) }, &never, &|_| {}).unwrap();
        let (branch, state) =
            found.branches.iter().flat_map(|b| b.points.iter().map(move |p| (b, p))).find(|(_, p)| (p.speed - speed).abs() < 1e-9).unwrap();
        let judged = exponents(&system, branch.discretisation, &state.x, state.speed, &[]).unwrap();
        let roots = at(&linear, speed, &roots::Request { margin: 1e-6, growing: true, ..roots::Request::default() });
        // the forward root and its image
        assert_eq!(
            judged.values.iter().filter(|z| z.re > 1e-4).count(),
            2 * roots.growing().unwrap(),
            "{judged:?} {:?}",
            roots.spectrum.modes
        );
        if roots.growing() == Some(1) {
            let root = roots.spectrum.least_stable().unwrap().value;
            assert!((judged.growth() - root.re).abs() < 1e-7 * root.abs(), "{} {root:?}", judged.growth());
        }
    }
}
