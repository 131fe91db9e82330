//! Stability of periodic motions on Hill's determinant.

use super::viscous::one_coordinate;
use super::{at, build, changed};
use laval::model::system::System;
use laval::solve::counted;
use laval::solve::harmonic::branches::bifurcation::{Change, Event};
use laval::solve::harmonic::branches::response::{Request, Stage, Step, respond};
use laval::solve::harmonic::stability::determinant::{Effort, exponents};
use laval::solve::harmonic::stability::floquet::Method;
use laval::solve::rest::rest;
use laval::solve::roots;
use laval_num::continuation::End;
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
        let assessed = exponents(&system, branch.discretisation, &state.x, state.speed, &[], &mut Effort::endless()).unwrap();
        let roots = at(&linear, speed, &roots::Request { margin: 1e-6, growing: true, ..roots::Request::default() });
        // the forward root and its image
        assert_eq!(
            assessed.values.iter().filter(|z| z.re > 1e-4).count(),
            2 * roots.growing().unwrap(),
            "{assessed:?} {:?}",
            roots.spectrum.modes
        );
        if roots.growing() == Some(1) {
            let root = roots.spectrum.least_stable().unwrap().value;
            assert!((assessed.growth() - root.re).abs() < 1e-7 * root.abs(), "{} {root:?}", assessed.growth());
        }
    }
}

/// One coordinate on a bearing that stiffens, with an eccentricity.
fn on_a_cubic_bearing(zeta: f64, nu: f64, bearing: &str, eccentricity: f64) -> String {
    let text = one_coordinate(zeta, nu).replace("kind = \"shaft_lumped\"", &format!("kind = \"bearing_cubic\"\n{bearing}"));
    changed(&text, &[("polar_inertia = 1", &format!("polar_inertia = 1\neccentricity = {eccentricity:e}"))])
}

fn assessed(system: &System, request: Request) -> Vec<Change> {
    let never = AtomicBool::new(false);
    let found = respond(system, &request, &never, &|_| {}).unwrap();
    let open: Vec<f64> = found.branches.iter().flat_map(|b| &b.points).filter(|p| p.exponents.is_none()).map(|p| p.speed).collect();
    assert!(open.is_empty() && found.unassessed.is_none(), "{open:?} {:?}", found.unassessed);
    let determined = found.branches.iter().flat_map(|b| &b.points).filter_map(|p| p.exponents.as_ref());
    assert!(determined.clone().count() > 10 && determined.into_iter().all(|e| (e.method == Method::Determinant) == request.determinant));
    let mut changes: Vec<Change> = found.branches.into_iter().flat_map(|b| b.changes).collect();
    changes.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    changes
}

/// The planar liquid with a time form on a bearing that stiffens.
fn wave(law: &str) -> String {
    let text = on_a_cubic_bearing(0.05, 0.0, &format!("law = \"{law}\"\ncubic_stiffness = 2e11"), 2e-4);
    changed(&text, &[("density = 1000", "density = 1000\nwave_damping = 20")])
}

/// A machine that has a time form changes its stability at the same places, in the same way, by the map over the period and by Hill's determinant; `event` is among the changes.
fn located_alike(text: &str, request: Request, event: Event) {
    let system = build(text);
    let mapped = assessed(&system, request);
    let determined = assessed(&system, Request { determinant: true, ..request });
    let say = || {
        let line = |c: &Change| format!("{:?} {:.9} {:?} {:?} {}", c.event, c.speed, c.unstable, c.exponent, c.frequency);
        let lines = |all: &[Change]| all.iter().map(line).collect::<Vec<_>>().join("\n");
        format!("{text}\n{}\n\n{}", lines(&mapped), lines(&determined))
    };
    assert!(mapped.iter().any(|c| c.event == event), "{}", say());
    assert_eq!(mapped.len(), determined.len(), "{}", say());
    for (m, d) in mapped.iter().zip(&determined) {
        let same = (m.speed - d.speed).abs() < 1e-6 * m.speed
            && (m.frequency - d.frequency).abs() < 1e-5 * m.speed
            && m.unstable == d.unstable
            && (m.event, m.parts) == (d.event, d.parts)
            && d.located
            && d.growth.abs() < 1e-5
            && d.bracket.0 <= d.speed
            && d.speed <= d.bracket.1;
        assert!(same, "{}", say());
    }
}

#[test]
fn circular_motions_change_their_stability_alike_by_map_and_determinant() {
    located_alike(&wave("isotropic"), Request::over(60.0, 260.0), Event::NeimarkSacker);
}

#[test]
fn motions_with_the_symmetry_of_a_quarter_turn_change_their_stability_alike() {
    located_alike(&wave("per_axis"), Request { harmonics: Some(5), ..Request::over(80.0, 240.0) }, Event::SymmetryBreaking);
}

/// What was stopped is not blamed on the work of counting, and of states that were not assessed none is kept.
#[test]
fn a_cancelled_assessment_blames_no_work() {
    let system = build(&on_a_cubic_bearing(0.05, 1e-3, "law = \"isotropic\"\ncubic_stiffness = 2e11", 1e-6));
    let request = Request { determinant: true, ..Request::over(90.0, 220.0) };
    let cancel = AtomicBool::new(false);
    let ticks = std::cell::Cell::new(0);
    let tick = |step: Step| {
        ticks.set(ticks.get() + u64::from(matches!(step.stage, Stage::Assess(_))));
        // one for each motion assessed
        cancel.store(ticks.get() >= 5, std::sync::atomic::Ordering::Relaxed);
    };
    let found = respond(&system, &request, &cancel, &tick).unwrap();
    let points: Vec<_> = found.branches.iter().flat_map(|b| &b.points).collect();
    assert!(found.unassessed.is_none(), "{:?}", found.unassessed);
    assert!(!points.is_empty() && points.len() <= 5 && points.iter().all(|p| p.exponents.is_some()), "{}", points.len());
    assert!(found.branches.iter().all(|b| b.end == End::Cancelled));
    // a limit of work is still called so
    let short = respond(&system, &Request { work: 5, ..request }, &AtomicBool::new(false), &|_| {}).unwrap();
    assert!(short.unassessed.is_some_and(|why| why.to_string().contains("more work")));
}

/// Small circular motions of a viscous machine lose their stability where its roots about the state at rest do; with larger ones on a bearing that stiffens that place
/// moves up with the square of the deflection.
#[test]
fn a_viscous_liquid_on_a_cubic_bearing() {
    let (zeta, nu) = (0.05, 1e-3);
    let never = AtomicBool::new(false);
    let linear = build(&one_coordinate(zeta, nu));
    let state = |w: f64| rest(&linear, w);
    let speeds: Vec<f64> = (0..14).map(|i| 90.0 + 10.0 * f64::from(i)).collect();
    let row = counted::row(&linear, &state, &speeds, 0.0, (None, &never, true), |_| true).unwrap();
    let edges: Vec<f64> = row.edges.iter().map(|e| e.speed).collect();
    assert_eq!(edges.len(), 2, "{edges:?}");
    let moved = |eccentricity: f64| {
        let system = build(&on_a_cubic_bearing(zeta, nu, "law = \"isotropic\"\ncubic_stiffness = 2e11", eccentricity));
        let found = assessed(&system, Request { determinant: true, ..Request::over(90.0, 220.0) });
        assert!(found.iter().all(|c| c.event == Event::NeimarkSacker && c.located && c.growth.abs() < 1e-6 * c.speed), "{found:#?}");
        let places: Vec<f64> = found.iter().map(|c| c.speed).collect();
        assert_eq!(places.len(), 2, "{places:?}");
        [places[0] - edges[0], places[1] - edges[1]]
    };
    let [a, b] = [moved(1e-6), moved(2e-6)];
    for k in 0..2 {
        assert!(a[k] > 0.0 && a[k] < 1e-2, "{a:?}");
        assert!((b[k] / a[k] - 4.0).abs() < 0.05, "{a:?} {b:?}");
    }
}
