//! Branches of steady states: where they begin, which of them are stable, what a sentence may hold.

use super::{column, run, words};
use crate::common::files::{finding, findings};
use std::f64::consts::TAU;

/// The rotor of the file, from its sag, by Runge and Kutta: its farthest place from the sag over one turn,
/// once it repeats.
fn farthest_in_time(w: f64) -> f64 {
    const STEPS: u32 = 4000;
    let (m, e, hertz, gap, loss, g) = (6.0f64, 8e-6, 1.33e10, 1e-5, 400.0, 9.80665);
    let sag: f64 = gap + (m * g / hertz).powf(2.0 / 3.0);
    let rates = |t: f64, y: [f64; 4]| {
        let r = y[0].hypot(y[1]);
        let f = if r > gap { hertz * (r - gap).powf(1.5) / r } else { 0.0 };
        let (s, c) = (w * t).sin_cos();
        [y[2], y[3], (m * e * w * w * c - f * y[0] - loss * y[2]) / m, (m * e * w * w * s - m * g - f * y[1] - loss * y[3]) / m]
    };
    let h = TAU / w / f64::from(STEPS);
    let turns = (20.0 * 2.0 * m / loss * w / TAU).ceil() as u32;
    let (mut y, mut before, mut far) = ([0.0, -sag, 0.0, 0.0], [0.0; 4], 0.0);
    for _ in 0..=turns {
        (before, far) = (y, 0.0);
        for k in 0..STEPS {
            let t = h * f64::from(k);
            let at = |d: [f64; 4], s: f64| std::array::from_fn(|i| y[i] + s * d[i]);
            let k1 = rates(t, y);
            let k2 = rates(t + 0.5 * h, at(k1, 0.5 * h));
            let k3 = rates(t + 0.5 * h, at(k2, 0.5 * h));
            let k4 = rates(t + h, at(k3, h));
            y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            far = y[0].hypot(y[1] + sag).max(far);
        }
    }
    assert!((y[0] - before[0]).hypot(y[1] - before[1]) < 1e-6 * far, "{w}: no motion of one turn");
    far
}

/// A rotor that lies in bearings with clearance: from the lowest speed of the file on there is a stable
/// motion about the sag, that of the machine in time.
#[test]
fn a_rotor_that_lies_in_its_clearance_has_states_from_the_lowest_speed_on() {
    let text = include_str!("machines/horizontal_rotor_with_clearance.toml").replace("to = \"20000 rpm\" }", "to = \"5500 rpm\" }");
    let (o, _) = run(&text, "nonlinear_response");
    assert!(
        findings(&o, "start_missing").is_empty()
            && o.findings.iter().all(|f| !f.sentence().to_lowercase().contains("no periodic solution")),
        "{:?}",
        o.findings
    );
    let rows = column(&o, "response", "speed").into_iter().zip(column(&o, "response", "growth rate"));
    let rows: Vec<_> = rows.zip(column(&o, "response", "rotor largest displacement")).map(|((w, g), a)| (w, g, a)).collect();
    let lowest = rows.iter().map(|r| r.0).fold(f64::INFINITY, f64::min);
    assert!((lowest / (500.0 * TAU / 60.0) - 1.0).abs() < 1e-9, "{lowest}");
    // c/2m in both directions, less within its superharmonic resonances
    assert!(rows.iter().all(|r| r.1 < -0.6 * 400.0 / 12.0), "{rows:?}");
    for target in [lowest, 150.0, 300.0, 420.0, 570.0] {
        let (w, _, found) = *rows.iter().min_by(|a, b| (a.0 - target).abs().total_cmp(&(b.0 - target).abs())).unwrap();
        let known = farthest_in_time(w);
        assert!((found / known - 1.0).abs() < 2e-3, "{w}: {found} {known}");
    }
}

/// At its lowest speeds the same rotor moves by nanometres about a sag of 20 um: what differs from turn to turn is the
/// error of the integration, and no sentence blames the largest number of periods, which ended nothing.
#[test]
fn what_the_integration_leaves_is_not_called_settling() {
    let text = include_str!("machines/horizontal_rotor_with_clearance.toml");
    let machine = &text[..text.find("[[study]]").unwrap()];
    let sweep = |more: &str| {
        let speeds = "speed = { from = \"480 rpm\", to = \"540 rpm\", points = 3 }\nstart = \"up\"";
        run(&format!("{machine}[[study]]\nkind = \"sweep\"\n{speeds}\n{more}\n"), "sweep").0
    };
    let reported = findings(&sweep(""), "not_settled").iter().map(|f| f.sentence()).collect::<Vec<_>>();
    assert!(
        !reported.is_empty() && reported.iter().all(|t| t.contains("relative_tolerance") && !t.contains("most_periods")),
        "{reported:?}"
    );
    let o = sweep("relative_tolerance = 1e-11");
    assert!(words(&o, "sweep", "motion").iter().all(|m| m == "periodic"), "{:?}", o.findings);
}

/// Balls beside a spin: orders of disturbances are open, and no number stands for what is open.
#[test]
fn no_sentence_about_balls_holds_what_is_no_number() {
    let (o, _) = run(include_str!("machines/two_discs_with_balls.toml"), "nonlinear_response");
    for f in &o.findings {
        assert!(!f.sentence().contains("not a number") && f.value.is_none_or(f64::is_finite), "{}", f.sentence());
        assert!(f.evidence.iter().all(|e| e.value.is_finite()), "{f:?}");
    }
    let lost = finding(&o, "stability_lost");
    assert!(lost.sentence().contains("vibration at a second frequency grows above it"), "{}", lost.sentence());
}
