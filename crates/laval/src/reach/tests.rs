use super::*;
use crate::file::{catalog, load};

const RIGID: &str = r#"
machine = { name = "rigid rotor", speed = "3000 rpm" }
part = [
    { kind = "disc", name = "drum", mass = "3 kg", eccentricity = "20 um" },
    { kind = "shaft_lumped", name = "shaft", between = ["drum", "ground"], stiffness = "3e5 N/m" },
    { kind = "damper", name = "air", between = ["drum", "ground"], damping = "20 N s/m" },
]
"#;

fn free(path: &str, low: f64, high: f64) -> Free {
    Free { path: path.into(), low, high }
}

fn reached(text: &str, goal: &Goal, wanted: f64, free: &[Free]) -> Reached {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d}"));
    reach(text, &loaded, catalog(), goal, wanted, free, &Context::quiet("reach")).unwrap_or_else(|d| panic!("{d}"))
}

/// Without damping a critical speed is at sqrt(k / m).
#[test]
fn a_critical_speed_of_a_rigid_rotor_is_moved_to_the_closed_form() {
    let undamped = RIGID.replace("damping = \"20 N s/m\"", "damping = 0");
    let goal = Goal::CriticalSpeed { order: 1.0, at: 310.0 };
    for wanted in [250.0, 330.0, 480.0] {
        let r = reached(&undamped, &goal, wanted, &[free("shaft.stiffness", 1e5, 9e5)]);
        let k = 3.0 * wanted * wanted;
        assert!(r.reached && r.impossible.is_none(), "{r:?}");
        assert!((r.moved[0].to - k).abs() < 1e-7 * k, "{} instead of {k}", r.moved[0].to);
        let r = reached(&undamped, &goal, wanted, &[free("drum.mass", 0.5, 9.0)]);
        let m = 3e5 / (wanted * wanted);
        assert!(r.reached && (r.moved[0].to - m).abs() < 1e-7 * m, "{r:?}");
    }
}

/// Of two parameters the least change on the curve k = m W^2, by a fine search along it.
#[test]
fn of_two_parameters_the_change_is_the_least() {
    let undamped = RIGID.replace("damping = \"20 N s/m\"", "damping = 0");
    let all = [free("shaft.stiffness", 1e5, 9e5), free("drum.mass", 1.0, 9.0)];
    let wanted = 400.0;
    let r = reached(&undamped, &Goal::CriticalSpeed { order: 1.0, at: 316.0 }, wanted, &all);
    let far = |k: f64, m: f64| (((k - 3e5) / 8e5).powi(2) + ((m - 3.0) / 8.0).powi(2)).sqrt();
    let best =
        (0..200_000).map(|i| 1.0 + 3.0 * f64::from(i) / 200_000.0).map(|m| far(m * wanted * wanted, m)).fold(f64::INFINITY, f64::min);
    let own = far(r.moved[0].to, r.moved[1].to);
    assert!(r.reached && own < best * (1.0 + 1e-6), "{own} instead of {best}: {r:?}");
    // each alone is farther, and the curve rises to the whole change
    assert!(r.alone.iter().all(|a| a.reached) && r.alone.len() == 2);
    assert!(r.curve.windows(2).all(|w| w[0].1 < w[1].1) && (r.curve[CURVE].1 - own).abs() < 1e-12);
}

#[test]
fn a_bound_that_prevents_the_wanted_value_is_named() {
    let goal = Goal::CriticalSpeed { order: 1.0, at: 316.0 };
    let undamped = RIGID.replace("damping = \"20 N s/m\"", "damping = 0");
    let r = reached(&undamped, &goal, 500.0, &[free("shaft.stiffness", 1e5, 4e5), free("drum.eccentricity", 0.0, 1e-3)]);
    let (sentence, bounds) = r.impossible.clone().expect("it cannot be reached");
    assert_eq!(bounds, ["shaft.stiffness"]);
    assert!(sentence.to_string().contains("shaft.stiffness stands at its bound"), "{sentence}");
    assert!(!r.reached && (r.to - (4e5f64 / 3.0).sqrt()).abs() < 1e-6 && r.moved[0].at_bound);
    // what does not enter moves nothing
    let r = reached(&undamped, &goal, 320.0, &[free("drum.eccentricity", 0.0, 1e-3)]);
    assert!(r.impossible.is_some_and(|i| i.1.is_empty() && i.0.to_string().contains("do not move")));
}

/// Where internal damping of the shaft makes the rotor unstable: W = w (1 + c_fixed / c_rotating).
#[test]
fn a_limit_of_stability_is_moved_to_the_closed_form() {
    let text = RIGID.replace(
        "{ kind = \"damper\", name = \"air\", between = [\"drum\", \"ground\"], damping = \"20 N s/m\" },",
        "{ kind = \"damper\", name = \"air\", between = [\"drum\", \"ground\"], damping = \"20 N s/m\" },
         { kind = \"damper\", name = \"inner\", between = [\"drum\", \"ground\"], damping = \"40 N s/m\", axes = \"rotating\" },",
    );
    let w = (3e5f64 / 3.0).sqrt();
    let r = reached(&text, &Goal::StabilityLimit { at: 1.45 * w }, 2.0 * w, &[free("air.damping", 1.0, 100.0)]);
    assert!((r.from - 1.5 * w).abs() < 1e-6 * w, "{r:?}");
    assert!(r.reached && (r.moved[0].to - 40.0).abs() < 1e-5, "{r:?}");
}

/// A bearing is moved along the shaft: no parameter of a part, so by differences.
#[test]
fn a_position_is_moved() {
    let text = r#"
machine = { name = "overhung", speed = "3000 rpm" }
part = [
    { kind = "disc", name = "drum", mass = "3 kg", polar_inertia = 0.01, diametral_inertia = 0.02 },
    { kind = "shaft_lumped", name = "lower", between = [{ body = "drum", at = "-100 mm" }, "ground"], stiffness = "3e5 N/m" },
    { kind = "shaft_lumped", name = "upper", between = [{ body = "drum", at = "60 mm" }, "ground"], stiffness = "3e5 N/m" },
]
"#;
    let loaded = load(text).unwrap_or_else(|d| panic!("{d}"));
    let study = crate::study::critical_speeds::CriticalSpeeds {
        speed: crate::model::field::RangeValue { from: 50.0, to: 2000.0, points: None },
        orders: vec![1.0],
        margin: 0.15,
    };
    let first = crate::study::TypedStudy::result(&study, &loaded.system, &Context::quiet("c")).unwrap().crossings[0].speed;
    let r = reached(text, &Goal::CriticalSpeed { order: 1.0, at: first }, 1.01 * first, &[free("upper.between[1].at", 0.0, 0.2)]);
    assert!(r.reached && (r.to / first - 1.01).abs() < 1e-8, "{r:?}");
    assert!(r.moved[0].to != 0.06);
}

/// A peak and a jump of a bearing that stiffens.
#[test]
fn peaks_and_jumps_are_moved() {
    let text = r#"
machine = { name = "separator", speed = "3000 rpm" }
part = [
    { kind = "disc", name = "drum", mass = "2.4 kg", eccentricity = "50 um" },
    { kind = "foundation", name = "base", mass = "25 kg", stiffness = "3.26e5 N/m", damping = "6.59 N s/m" },
    { kind = "bearing_cubic", name = "bearing", between = ["drum", "base"], law = "per_axis", stiffness = "1.1e7 N/m", cubic_stiffness = "8.7e10 N/m^3" },
    { kind = "damper", name = "air", between = ["drum", "ground"], damping = "42 N s/m" },
]
study = [{ kind = "nonlinear_response", speed = { from = "25 rad/s", to = "5000 rad/s" } }]
"#;
    let r = reached(text, &Goal::Jump { at: 2668.0 }, 2600.0, &[free("drum.eccentricity", 1e-5, 1e-4)]);
    assert!((r.from - 2668.4586212391).abs() < 1e-5, "{r:?}");
    assert!(r.reached, "{r:?}");
    let moved = text.replace("50 um", &format!("{:e} m", r.moved[0].to));
    let again = reached(&moved, &Goal::Jump { at: 2600.0 }, 2600.0, &[free("drum.eccentricity", 1e-6, 1e-3)]);
    assert!((again.from - 2600.0).abs() < 1e-5, "{again:?}");
}

/// The linear peak of a rotor of one mass: W = w / sqrt(1 - 2 z^2), size e / (2 z sqrt(1 - z^2)), with the damping ratio z; the bearing that stiffens enters by its tangent.
#[test]
fn a_peak_of_the_linear_response_is_moved_to_the_closed_form() {
    let text = RIGID.replace(
        "stiffness = \"3e5 N/m\" },",
        "stiffness = \"2e5 N/m\" },
         { kind = \"bearing_cubic\", name = \"bearing\", between = [\"drum\", \"ground\"], law = \"per_axis\", stiffness = \"1e5 N/m\", cubic_stiffness = \"8e10 N/m^3\" },",
    );
    let text = text.replace("damping = \"20 N s/m\"", "damping = \"300 N s/m\"");
    let (k, m) = (3e5f64, 3.0f64);
    let w = (k / m).sqrt();
    let ratio = |c: f64, k: f64| c / (2.0 * (k * m).sqrt());
    let at = w / (1.0 - 2.0 * ratio(300.0, k).powi(2)).sqrt();
    let goal = |of| Goal::Resonance { at, body: Some("drum".into()), of };
    // the size, by the damping: e = 20 um
    let r = reached(&text, &goal(Of::Size), 30e-6, &[free("air.damping", 100.0, 900.0)]);
    let z = ratio(r.moved[0].to, k);
    assert!(r.reached && (20e-6 / (2.0 * z * (1.0 - z * z).sqrt()) / 30e-6 - 1.0).abs() < 1e-6, "{r:?}");
    // the speed, by the stiffness; what the speed does not depend on stays
    let r = reached(&text, &goal(Of::Speed), 1.1 * at, &[free("shaft.stiffness", 1e5, 9e5), free("drum.eccentricity", 1e-6, 1e-3)]);
    let k = r.moved[0].to + 1e5;
    let there = (k / m).sqrt() / (1.0 - 2.0 * ratio(300.0, k).powi(2)).sqrt();
    assert!(r.reached && (there / (1.1 * at) - 1.0).abs() < 1e-6, "{r:?}");
    assert_eq!(r.moved[1].to, r.moved[1].from);
    // nor is it driven to its bound where the others do not suffice
    let r = reached(&text, &goal(Of::Speed), 2.0 * at, &[free("shaft.stiffness", 1e5, 4e5), free("drum.eccentricity", 1e-6, 1e-3)]);
    assert!(!r.reached && r.moved[1].to == r.moved[1].from, "{r:?}");
    assert_eq!(r.impossible.expect("a bound").1, ["shaft.stiffness"]);
}

/// Slopes are those of differences, of a rotor whose critical speeds move with gyroscopic moments.
#[test]
fn slopes_of_a_gyroscopic_rotor_are_those_of_differences() {
    let text = r#"
machine = { name = "overhung", speed = "3000 rpm" }
part = [
    { kind = "disc", name = "drum", mass = "3 kg", polar_inertia = 0.02, diametral_inertia = 0.012, eccentricity = "20 um" },
    { kind = "shaft_lumped", name = "lower", between = [{ body = "drum", at = "-100 mm" }, "ground"], stiffness = "3e5 N/m" },
    { kind = "shaft_lumped", name = "upper", between = [{ body = "drum", at = "-30 mm" }, "ground"], stiffness = "5e5 N/m" },
    { kind = "damper", name = "air", between = ["drum", "ground"], damping = "30 N s/m" },
    { kind = "damper", name = "inner", between = ["drum", "ground"], damping = "60 N s/m", axes = "rotating" },
]
"#;
    let loaded = load(text).unwrap_or_else(|d| panic!("{d}"));
    let system = &loaded.system;
    let context = Context::quiet("slopes");
    let speed = crate::model::field::RangeValue { from: 50.0, to: 2000.0, points: None };
    let study = crate::study::critical_speeds::CriticalSpeeds { speed, orders: vec![1.0], margin: 0.15 };
    let critical = crate::study::TypedStudy::result(&study, system, &context).unwrap().crossings[0].speed;
    let map = crate::study::stability_map::StabilityMap {
        speed: crate::model::field::RangeValue { from: 50.0, to: 3000.0, points: Some(200) },
        parameter: None,
        about: crate::study::support::About::Rest,
        criterion: crate::study::criterion::Criterion::Growth,
        threshold: 0.0,
        frequency: None,
    };
    let limit = crate::study::TypedStudy::result(&map, system, &context).unwrap().rows[0].edges[0].speed;
    for goal in [Goal::CriticalSpeed { order: 1.0, at: critical }, Goal::StabilityLimit { at: limit }] {
        for path in ["drum.mass", "drum.polar_inertia", "upper.stiffness", "air.damping"] {
            let own = system.param(path).expect("a parameter").to_vec();
            let mut sought = goal.sought(&loaded, &context).unwrap_or_else(|d| panic!("{d}"));
            let mark = sought.mark();
            let exact = sought.of(system, std::slice::from_ref(&own), &context).unwrap().expect("a result").slopes[0];
            let x = system.params()[own[0]];
            let mut beside = |share: f64| {
                sought.back(&mark);
                let changed = system.with(&[(path, x * (1.0 + share))]).unwrap_or_else(|d| panic!("{d}"));
                sought.of(&changed, &[], &context).unwrap().expect("a result").value
            };
            let h = 1e-5;
            let slope = (beside(h) - beside(-h)) / (2.0 * h * x);
            assert!((exact - slope).abs() * x < 1e-6 * critical, "{goal:?} {path}: {exact} instead of {slope}");
        }
    }
}

/// Of two jumps that lie close together the one that was pulled is moved, also past where the other was.
#[test]
fn a_jump_up_does_not_become_one_down() {
    let text = include_str!("../../../../examples/01-oil-separator/machine.toml");
    let loaded = load(text).unwrap_or_else(|d| panic!("{d}"));
    let jump = |system: &crate::model::system::System, up: bool| -> f64 {
        let study = crate::study::nonlinear_response::NonlinearResponse::over(25.0, 5000.0);
        let found = crate::study::TypedStudy::result(&study, system, &Context::quiet("r")).unwrap();
        let folds = found.response.branches.iter().flat_map(|b| &b.folds);
        folds.filter(|f| f.upper == up).map(|f| f.speed).fold(f64::NAN, f64::max)
    };
    for up in [true, false] {
        let at = jump(&loaded.system, up);
        for wanted in [1.045 * at, 0.92 * at] {
            let r = reached(text, &Goal::Jump { at }, wanted, &[free("bearing.stiffness", 4e6, 3.3e7)]);
            assert!(r.reached, "{up} {wanted}: {r:?}");
            let moved = loaded.system.with(&[("bearing.stiffness", r.moved[0].to)]).unwrap_or_else(|d| panic!("{d}"));
            let after = jump(&moved, up);
            assert!((after - wanted).abs() < 1e-6 * wanted, "{up}: {after} instead of {wanted}");
        }
    }
}

/// There and back again: a critical speed that was moved is found where it was moved to, beside that of the other direction of whirl.
#[test]
fn a_critical_speed_is_moved_back_to_where_it_was() {
    let text = include_str!("../../../../examples/01-oil-separator/machine.toml");
    let rpm = std::f64::consts::PI / 30.0;
    let range = [free("bearing.stiffness", 3e6, 4e7)];
    for there in [23500.0, 25200.0] {
        let r = reached(text, &Goal::CriticalSpeed { order: 1.0, at: 18774.0 * rpm }, there * rpm, &range);
        assert!(r.reached, "{r:?}");
        let moved = text.replace("stiffness = \"1.1e7 N/m\"", &format!("stiffness = \"{:e} N/m\"", r.moved[0].to));
        let back = reached(&moved, &Goal::CriticalSpeed { order: 1.0, at: there * rpm }, r.from, &range);
        assert!(back.reached && (back.moved[0].to / 1.1e7 - 1.0).abs() < 1e-6, "{there}: {back:?}");
    }
}
