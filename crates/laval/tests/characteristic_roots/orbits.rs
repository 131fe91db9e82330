//! Stability of periodic motions on Hill's determinant.

use super::viscous::one_coordinate;
use super::{at, build, changed};
use laval::solve::harmonic::determinant::{Effort, exponents};
use laval::solve::harmonic::response::{Request, respond};
use laval::solve::roots;
use std::sync::atomic::AtomicBool;

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
        let judged = exponents(&system, branch.discretisation, &state.x, state.speed, &[], &mut Effort::endless()).unwrap();
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
