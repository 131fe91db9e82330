//! What can be seen of the balancer without a machine.

use super::*;
use crate::model::field::Value;

pub(super) fn ring() -> BalancerBallParams {
    BalancerBallParams {
        eccentricity: 1e-3,
        eccentricity_phase: 0.5,
        tilt: 0.2,
        node_line: 0.8,
        housing_mass: 0.7,
        diametral_inertia: 0.01,
        polar_inertia: 0.018,
        drag: 3e-3,
        ..BalancerBallParams::new(0.02, 0.15)
    }
}

pub(super) fn sprung() -> BalancerBallParams {
    BalancerBallParams { tilt_stiffness: 40.0, tilt_damping: 0.02, ..ring() }
}

pub(super) fn rough() -> BalancerBallParams {
    BalancerBallParams { dry_torque: 0.01, rolling_resistance: 0.002, friction_rate: 80.0, rolling_inertia: 0.4, ..ring() }
}

pub(super) fn touching() -> BalancerBallParams {
    BalancerBallParams { ball_radius: 0.04, contact_stiffness: 30.0, contact_damping: 1e-3, ..ring() }
}

pub(super) fn balancer() -> BallBalancer {
    BallBalancer::new(Attach::on("disc"), 2).masses(&[1.0, 1.5])
}

pub(super) fn two_tracks() -> BallBalancer {
    balancer().track(1, 0.11 / 0.15, -0.35, 0.1).masses(&[1.0, 1.5, 0.75])
}

/// On a body that stands still, position and derivatives in three dimensions are the closed forms of the plane.
#[test]
fn three_dimensions_without_tilt_are_the_plane() {
    let (plane, space) = (two_tracks().planar().free(), two_tracks().free());
    let p = sprung();
    let own = [0.3, -0.2, 0.7, -1.9, 2.4];
    let rates = [0.6, -0.4, -2.0, 1.5, 0.8];
    let accels = [30.0, 4.0, 11.0, -7.0, 3.0];
    let flat = |x: [f64; 2], own: &[f64]| [&x[..], own].concat();
    let upright = |x: [f64; 2], own: &[f64]| [&x[..], &[0.0; 2], own].concat();
    let run = |part: &BallBalancer, q: &[f64], v: &[f64], a: &[f64]| {
        let at = At { q, v, a, z: &[], phase: 0.3, speed: 40.0, spin_accel: 17.0, t: 0.0 };
        let (mut force, mut spin) = (vec![0.0; q.len()], 0.0);
        part.residual(&p, &at, &mut Rows { force: &mut force, rate: &mut [], spin: &mut spin });
        let stored = part.energy(&p, &at).map_or(f64::NAN, |e| e.stored);
        (force, spin, stored)
    };
    let (x, v, a) = ([1e-3, -2e-3], [0.05, -0.03], [-9.6, 27.0]);
    let (f, s, e) = run(&plane, &flat(x, &own), &flat(v, &rates), &flat(a, &accels));
    let (g, t, d) = run(&space, &upright(x, &own), &upright(v, &rates), &upright(a, &accels));
    let size = f.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    for i in 0..f.len() {
        let j = if i < 2 { i } else { i + 2 };
        assert!((f[i] - g[j]).abs() < 1e-14 * size, "{i}: {} {}", f[i], g[j]);
    }
    assert!((s - t).abs() < 1e-14 * size && (e - d).abs() < 1e-14 * e, "{s} {t} {e} {d}");
}

fn build(fields: &[(&str, Value)], params: &[(&str, f64)]) -> (Option<BallBalancer>, Vec<String>) {
    let (mut values, mut given, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
    values.set("on", Value::Attach(Attach::on("disc")), None);
    for (name, value) in fields {
        values.set(name, value.clone(), None);
    }
    for (name, x) in params {
        given.set(name, *x);
    }
    let part = BallBalancer::build(&values, &mut given, &mut d);
    (part, d.0.iter().map(ToString::to_string).collect())
}

fn columns(balls: &[f64], radius: &[f64]) -> Value {
    Value::Columns([("balls", balls.to_vec()), ("radius", radius.to_vec())].into())
}

#[test]
fn fields_make_the_balancer() {
    let (part, text) = build(&[("balls", Value::Integer(3))], &[]);
    assert_eq!((part, text), (Some(BallBalancer::new(Attach::on("disc"), 3)), vec![]));
    let fields = [
        ("tracks", columns(&[2.0, 1.0], &[1.0, 0.5])),
        ("mass_ratios", Value::List(vec![1.0, 1.5, 0.75])),
        ("rings", Value::Choice("free")),
    ];
    let (part, text) = build(&fields, &[("contact_stiffness", 1.0)]);
    let expected = BallBalancer::new(Attach::on("disc"), 2).track(1, 0.5, 0.0, 0.0).masses(&[1.0, 1.5, 0.75]).free().touching();
    assert_eq!((part, text), (Some(expected), vec![]));
}

#[test]
fn mistakes_are_reported() {
    let reported = |fields: &[(&str, Value)], what: &str| {
        let (part, text) = build(fields, &[]);
        assert!(part.is_none() && text.iter().any(|t| t.contains(what)), "{what}: {text:?}");
    };
    reported(&[("tracks", columns(&[1.5], &[1.0]))], "a track has 1.5 balls");
    reported(&[("tracks", columns(&[f64::NAN], &[1.0]))], "a track has NaN balls");
    reported(&[("tracks", columns(&[60.0, 5.0], &[1.0, 1.0]))], "more than 64 balls");
    reported(&[("tracks", columns(&[2.0], &[-1.0]))], "a track has -1 times the radius");
    reported(&[("mass_ratios", Value::List(vec![1.0]))], "1 mass ratios are given for 2 balls");
    let wrong = |part: BallBalancer, p: BalancerBallParams, field: &str, what: &str| {
        let found = part.check(&p);
        assert!(found.iter().any(|w| w.0 == field && w.1.contains(what)), "{what}: {found:?}");
    };
    assert_eq!(balancer().check(&ring()), []);
    wrong(
        balancer().free(),
        BalancerBallParams { diametral_inertia: 0.0, polar_inertia: 0.0, ..ring() },
        "diametral_inertia",
        "free ring needs inertia",
    );
    wrong(balancer(), BalancerBallParams { polar_inertia: 0.021, ..ring() }, "polar_inertia", "above twice");
    wrong(balancer(), sprung(), "tilt_stiffness", "acts on free rings");
    wrong(balancer(), BalancerBallParams { eccentricity: 0.2, ..ring() }, "eccentricity", "lies outside the track");
    wrong(BallBalancer::new(Attach::on("disc"), 12), touching(), "ball_radius", "12 balls do not fit");
    wrong(balancer(), touching(), "contact_stiffness", "different machines");
    wrong(balancer().touching(), BalancerBallParams { ball_radius: 0.0, ..touching() }, "ball_radius", "need their size");
}

/// A horizontal axis has no weight along it; a flat ring does not care.
#[test]
fn weight_along_a_horizontal_axis_is_refused() {
    let p = ring();
    assert!(balancer().refuses_axis(&p, Axis::Horizontal).is_some_and(|m| m.contains("give gravity = 0")));
    assert_eq!(balancer().refuses_axis(&p, Axis::Vertical), None);
    assert_eq!(balancer().refuses_axis(&BalancerBallParams { gravity: 0.0, ..p }, Axis::Horizontal), None);
    assert_eq!(balancer().planar().refuses_axis(&BalancerBallParams { tilt: 0.0, ..p }, Axis::Horizontal), None);
}

/// r sin^2 alpha of the source's machine is 4.9 mm, 98 times its eccentricity.
#[test]
fn locking_to_the_node_line_is_reported() {
    let p = BalancerBallParams { track_radius: 0.2, tilt: std::f64::consts::PI / 20.0, eccentricity: 50e-6, ..ring() };
    assert!(
        balancer().warnings(&p)[0].contains("= 4.894 mm should stay below a tenth of the eccentricity of the ring, 5 µm"),
        "{:?}",
        balancer().warnings(&p)
    );
    assert!(balancer().warnings(&BalancerBallParams { tilt: 0.0049, ..p }).is_empty());
    assert!(balancer().warnings(&BalancerBallParams { tilt: 0.0051, ..p }).len() == 1);
    assert!(balancer().warnings(&BalancerBallParams { tilt: 0.0, eccentricity: 0.0, ..p }).is_empty());
}

/// Angle, slip and capacity as they are shown.
#[test]
fn what_is_shown() {
    let p = ring();
    let q = [1e-3, 0.0, 7.0, -4.0];
    let v = [0.0, 0.0, 2.0, -3.0];
    let at = At { q: &q, v: &v, a: &[0.0; 4], z: &[], phase: 0.3, speed: 40.0, spin_accel: 0.0, t: 0.0 };
    let mut out = Vec::new();
    let part = balancer().planar();
    part.observe(&p, &at, &mut out);
    let shown = |name: &str| out.iter().find(|o| o.name == name).map_or(f64::NAN, |o| o.value);
    assert!((shown("ball 1 angle, wrapped") - (7.0 - std::f64::consts::TAU)).abs() < 1e-14);
    assert!((shown("ball 2 angle, wrapped") - (std::f64::consts::TAU - 4.0)).abs() < 1e-14);
    assert_eq!((shown("ball 1 slip"), shown("ball 2 slip")), (2.0, -3.0));
    assert!((part.capacity(&p) - (0.02 + 0.03) * 0.15).abs() < 1e-17);
    assert!((two_tracks().capacity(&p) - (0.05 * 0.15 + 0.015 * 0.11)).abs() < 1e-17);
    let centre = Complex::cis(0.8f64).scale(1e-3) + Complex::real(1e-3);
    assert!((shown("ring centre") - centre.norm_sqr().sqrt()).abs() < 1e-17);
}
