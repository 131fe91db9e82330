//! Modes, critical speeds, responses.

use super::{column, near, run, words};
use crate::common::files::{finding, findings, load};
use laval::outcome::{Level, Outcome};
use laval_num::complex::{C64, c};

/// Masses that swing out turn with the rotor: its critical speeds and its response are those of two masses on
/// two springs, the cups in the upper one.
#[test]
fn cups_belong_to_the_rotor() {
    let text = include_str!("machines/centrifuge_with_swinging_cups.toml");
    let (rotor, housing, cups) = (3.0, 22.0, 4.0 * 0.4 + 0.003);
    let (spindle, support, bearing, loss) = (2e5, 3e4, 15.0, 60.0);
    // of m2 m1 W^4 - (m2 (k1 + k0) + m1 k1) W^2 + k1 k0
    let upper: f64 = rotor + cups;
    let (a, b) = (upper * housing, upper * (spindle + support) + housing * spindle);
    let root = (b * b - 4.0 * a * spindle * support).sqrt();
    let known = [((b - root) / (2.0 * a)).sqrt(), ((b + root) / (2.0 * a)).sqrt()];
    let (criticals, _) = run(text, "critical_speeds");
    let speeds = column(&criticals, "critical_speeds", "speed");
    assert_eq!(speeds.len(), 4, "{speeds:?}");
    for (found, known) in speeds.iter().zip([known[0], known[0], known[1], known[1]]) {
        // damping ratios of 0.03 and 0.01
        near(*found, known, 1e-3);
    }
    // a heavier cup is an unbalance at the radius of its centre, hinge and arm
    let unbalance = rotor * 300e-6 + 0.003 * (0.09 + 0.06);
    let (response, _) = run(text, "forced_response");
    let swung = column(&response, "response", "speed").into_iter().zip(column(&response, "response", "amplitude.rotor"));
    let mut compared = 0;
    // far above the speed at which gravity holds the cups down
    for (w, found) in swung.filter(|x| x.0 > 150.0) {
        let (k, k0) = (c(spindle, bearing * w), c(spindle + support, (bearing + loss) * w));
        let lower = k0 - C64::real(housing * w * w);
        let amplitude = lower.scale(unbalance * w * w) / ((k - C64::real(upper * w * w)) * lower - k * k);
        near(found, amplitude.abs(), 2e-3);
        compared += 1;
    }
    assert!(compared > 50, "{compared}");
}

/// Speeds found with a second method to twelve digits, beside a memory that turns with the rotor.
#[test]
fn critical_speeds_beside_a_memory_are_located() {
    let machine = include_str!("../linear/machines/two_discs_with_memory.toml");
    let (o, _) = run(
        &format!("{machine}\n[[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = \"10 rad/s\", to = \"2000 rad/s\" }}\n"),
        "critical_speeds",
    );
    let speeds = column(&o, "critical_speeds", "speed");
    for known in [131.412423802, 289.741313585] {
        let nearest = speeds.iter().copied().min_by(|a, b| (a - known).abs().total_cmp(&(b - known).abs())).unwrap();
        near(nearest, known, 1e-11);
    }
    assert!(column(&o, "critical_speeds", "uncertainty").iter().all(|u| *u < 1e-6));
    assert!(findings(&o, "critical_speed_not_located").is_empty());
}

/// `x'' + x' - x = 0` diverges at every speed: said first by every study, and no sentence offers a sweep or a
/// margin without it.
#[test]
fn a_machine_that_diverges_is_called_so_by_every_study() {
    let text = include_str!("machines/diverging_disc.toml");
    let growth = 0.5 * (5f64.sqrt() - 1.0);
    for (name, id) in
        [("modes", "unstable_mode"), ("stability_map", "largest_growth"), ("forced_response", "unstable"), ("critical_speeds", "unstable")]
    {
        let (o, _) = run(text, name);
        let first = &o.findings[0];
        assert!(first.id == id && first.level == Level::Warning, "{name}: {first:?}");
        let rates = first.value.into_iter().chain(first.evidence.iter().map(|e| e.value));
        assert!(rates.into_iter().any(|x| (x / growth - 1.0).abs() < 1e-6), "{name}: {first:?}");
    }
    let (o, _) = run(text, "nonlinear_response");
    assert!(o.findings[0].sentence().contains("unstable"), "{:?}", o.findings[0]);
    let reported = finding(&o, "unstable_states");
    assert_eq!(reported.level, Level::Warning);
    near(column(&o, "response", "growth rate").into_iter().fold(f64::NEG_INFINITY, f64::max), growth, 1e-6);
    assert!(findings(&o, "jump_up").is_empty() && findings(&o, "jump_down").is_empty(), "{:?}", o.findings);
}

/// Damped far beyond the critical, and its tilt far from the range (`W^2 = k/(A - C)` and `k/(A + C)`): no
/// critical speed, and no figure of none.
#[test]
fn without_critical_speeds_there_is_no_figure_of_them() {
    let (diametral, polar, tilt) = (0.087102f64, 0.07528, 7.845e4);
    assert!((tilt / (diametral + polar)).sqrt() > 245.7 && (tilt / (diametral - polar)).sqrt() > 245.7);
    let (o, _) = run(include_str!("machines/disc_in_thick_oil.toml"), "critical_speeds");
    assert!(o.figures.is_empty() && column(&o, "critical_speeds", "speed").is_empty());
    assert_eq!(o.findings[0].id, "no_critical_speed");
}

/// Myklestad and Prohl: displacement, slope, moment and shear force carried over 24 elements that act at
/// their middles. A rotor that whirls at its speed sees the moments of inertia `A - C` (forward) and `A + C`
/// (backward).
fn shaft_determinant(discs: &[[f64; 3]], elements: &[[f64; 2]], speed: f64, forward: bool) -> f64 {
    let (length, support, w2) = (1.5 / elements.len() as f64, 1e6, speed * speed);
    let ends = [[1.0, 0.0], [0.0, 1.0]].map(|[y0, slope0]| {
        let (mut y, mut slope, mut moment, mut shear) = (y0, slope0, 0.0, 0.0);
        for (k, [mass, a, c]) in discs.iter().enumerate() {
            let spring = if k == 0 || k + 1 == discs.len() { support } else { 0.0 };
            shear += (mass * w2 - spring) * y;
            moment -= if forward { a - c } else { a + c } * w2 * slope;
            if let Some([across, tilt]) = elements.get(k) {
                let turned = slope + (moment + 0.5 * length * shear) / tilt;
                y += 0.5 * length * (slope + turned) - shear / across;
                moment += length * shear;
                slope = turned;
            }
        }
        [moment, shear]
    });
    ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]
}

/// Numbers of all parts of a kind in a machine file.
fn numbers<const N: usize>(text: &str, kind: &str, names: [&str; N]) -> Vec<[f64; N]> {
    let machine: toml::Table = text.parse().unwrap();
    let parts = machine["part"].as_array().unwrap().iter().filter(|p| p["kind"].as_str() == Some(kind));
    parts.map(|p| names.map(|n| p[n].as_float().unwrap())).collect()
}

#[test]
fn a_shaft_of_elements_has_the_critical_speeds_of_its_transfer_matrices() {
    let text = include_str!("machines/shaft_of_24_elements.toml");
    let (o, work) = run(&text.replace("\"6000 rpm\" }", "\"6000 rpm\", points = 40 }"), "critical_speeds");
    let (speed, whirl) = (column(&o, "critical_speeds", "speed"), words(&o, "critical_speeds", "whirl"));
    let discs = numbers(text, "disc", ["mass", "diametral_inertia", "polar_inertia"]);
    let elements = numbers(text, "shaft_lumped", ["stiffness", "tilt_stiffness"]);
    for direction in ["forward", "backward"] {
        let above = |w: f64| shaft_determinant(&discs, &elements, w, direction == "forward") > 0.0;
        let sign = |k: u32| above(f64::from(k));
        let known: Vec<f64> = (12..628)
            .filter(|&k| sign(k) != sign(k + 1))
            .map(|k| {
                let (mut low, mut high) = (f64::from(k), f64::from(k + 1));
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    if above(middle) == sign(k) { low = middle } else { high = middle }
                }
                low
            })
            .collect();
        let found: Vec<f64> = speed.iter().zip(whirl).filter(|x| x.1 == direction).map(|x| *x.0).collect();
        assert_eq!(found.len(), known.len(), "{direction}: {found:?} for {known:?}");
        // damping ratios up to 0.014
        found.iter().zip(&known).for_each(|(f, k)| near(*f, *k, 1e-4));
    }
    // between antiresonances a body beside a node has maxima of its own, hundreds of times smaller than what
    // the disc does there
    assert!(findings(&o, "response_peak").is_empty(), "{:?}", findings(&o, "response_peak"));
    let operating = 4000.0 * std::f64::consts::PI / 30.0;
    let margin = finding(&o, "margin");
    near(margin.value.unwrap(), 1.0 - 288.52 / operating, 1e-3);
    assert_eq!(margin.level, Level::Info);
    assert!(work < 20_000_000_000, "{work} units");
}

fn legend(o: &Outcome) -> usize {
    laval::report::draw(&o.figures[0], &o.tables).unwrap().matches("<g class=\"lg\"").count()
}

#[test]
fn the_diagram_of_a_long_shaft_can_be_read() {
    let (o, work) = run(&include_str!("machines/shaft_of_24_elements.toml").replace("points = 91", "points = 12"), "campbell");
    assert!((2..=8).contains(&legend(&o)), "{}", legend(&o));
    assert!(work < 6_000_000_000, "{work} units");
}

#[test]
fn a_bowl_with_liquid_is_computed_in_time() {
    let text = include_str!("machines/separator_bowl.toml");
    let (o, work) = run(text, "modes");
    assert!(findings(&o, "unstable_mode").is_empty() && work < 10_000_000_000, "{work} units");
    let (o, work) = run(text, "forced_response");
    assert!(o.end.is_complete() && work < 1_000_000_000, "{work} units");
}

/// What takes long is left to the run.
#[test]
fn a_check_of_many_studies_is_quick() {
    let l = load(include_str!("machines/three_discs_with_oil.toml"));
    let stop = laval::study::Cancel::default();
    let refused = laval_num::work::watched(Some(&stop), u64::MAX, || l.refusals()).unwrap();
    assert!(stop.spent() < 200_000_000, "{} units, {refused:?}", stop.spent());
}
