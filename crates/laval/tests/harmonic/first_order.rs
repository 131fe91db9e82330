//! Forces at the spin frequency: what a symmetry of the motion spares changes nothing.

use crate::common;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::measure::Measure;
use laval::solve::symmetry::Symmetry;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::{Context, TypedStudy};
use laval_num::complex::C64;
use std::f64::consts::TAU;

/// Complex amplitudes of both components at the spin frequency, by the transform of 96 samples of a period.
fn transformed(at: impl Fn(f64) -> [f64; 2]) -> [C64; 2] {
    let mut out = [C64::zero(); 2];
    for j in 0..96 {
        let tau = TAU * f64::from(j) / 96.0;
        let (wave, f) = (C64::cis(-tau).scale(2.0 / 96.0), at(tau));
        (0..2).for_each(|k| out[k] += wave.scale(f[k]));
    }
    out
}

/// The most that the force of any part differs from that of all samples, over it, on all branches; and the symmetry of the motion.
fn worst(bearing: &str, base: &str) -> (f64, Symmetry) {
    let text = format!(
        r#"
        machine = {{ speed = "300 rad/s" }}
        part = [
            {{ kind = "disc", name = "drum", mass = "2.4 kg", eccentricity = "50 um" }},
            {{ kind = "foundation", name = "base", mass = "25 kg", {base}, damping = "60 N s/m" }},
            {{ kind = "bearing_cubic", name = "bearing", between = ["drum", "base"], {bearing}, stiffness = "1.1e6 N/m", cubic_stiffness = "8.7e13 N/m^3" }},
            {{ kind = "damper", name = "losses", between = ["drum", "ground"], damping = "42 N s/m" }},
        ]"#
    );
    let loaded = common::files::load(&text);
    let system = &loaded.system;
    let study = NonlinearResponse::over(50.0, 900.0);
    let result = study.result(system, &Context::quiet("response")).unwrap_or_else(|d| panic!("{d}"));
    let (mut worst, mut symmetry, mut compared) = (0.0f64, Symmetry::None, 0);
    for branch in result.response.branches.iter().filter(|b| b.turns() == 1) {
        symmetry = branch.discretisation.whole().symmetry;
        let mut balance =
            Balance::new(system, branch.discretisation.whole(), study.request().speeds, None).unwrap_or_else(|d| panic!("{d}"));
        for p in branch.points.iter().step_by(7) {
            let orbit = Orbit::of(&mut balance, &p.x, p.speed).expect("a motion");
            for slot in Measure::forces(system) {
                let highest = orbit.orders.last().copied().unwrap_or(1);
                let of = |s| Measure::Force(slot).first_order(system, &orbit, 1, (s, &Measure::samples(highest, 1, s)));
                let all = transformed(|tau| Measure::Force(slot).components_at(system, &orbit, 1, tau));
                let size = all[0].abs() + all[1].abs();
                for spared in [of(Symmetry::None), of(symmetry)] {
                    worst = (0..2).map(|k| (all[k] - spared[k]).abs() / size).fold(worst, f64::max);
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 50, "{compared}");
    (worst, symmetry)
}

#[test]
fn symmetries_spare_samples_and_change_nothing() {
    let even = "stiffness = \"3.26e5 N/m\"";
    let uneven = "stiffness = { x = \"3.26e5 N/m\", y = \"5e5 N/m\" }";
    for (bearing, base, expected) in [
        ("law = \"isotropic\"", even, Symmetry::Circular),
        ("law = \"per_axis\"", even, Symmetry::Quarter),
        ("law = \"per_axis\"", uneven, Symmetry::Half),
    ] {
        let (worst, symmetry) = worst(bearing, base);
        assert_eq!(symmetry, expected, "{bearing} {base}");
        assert!(worst < 1e-10, "{bearing} {base}: {worst:e}");
    }
}

/// Sizes of a motion without symmetry, which half of a period does not hold.
#[test]
fn a_motion_without_symmetry_is_measured_over_the_whole_period() {
    let text = r#"
        machine = { speed = "300 rad/s", axis = "horizontal" }
        part = [
            { kind = "disc", name = "drum", mass = "2.4 kg", eccentricity = "50 um" },
            { kind = "bearing_cubic", name = "bearing", between = ["drum", "ground"], law = "isotropic", stiffness = "4e5 N/m", cubic_stiffness = "8e13 N/m^3" },
            { kind = "damper", name = "losses", between = ["drum", "ground"], damping = "42 N s/m" },
        ]"#;
    let loaded = common::files::load(text);
    let system = &loaded.system;
    let study = NonlinearResponse::over(100.0, 900.0);
    let result = study.result(system, &Context::quiet("response")).unwrap_or_else(|d| panic!("{d}"));
    let outcome = study.outcome(system, &result, "response").unwrap_or_else(|d| panic!("{d}"));
    let table = outcome.find_table("response").expect("a response");
    let column = table.columns().iter().find(|c| c.name == "drum largest displacement").expect("its size");
    let laval::outcome::Data::Float(sizes) = &column.data else { panic!("numbers") };
    let (mut row, mut asymmetric) = (0, 0);
    for branch in &result.response.branches {
        assert_eq!(branch.discretisation.whole().symmetry, Symmetry::None);
        let mut balance =
            Balance::new(system, branch.discretisation.whole(), study.request().speeds, None).unwrap_or_else(|d| panic!("{d}"));
        for p in &branch.points {
            let orbit = Orbit::of(&mut balance, &p.x, p.speed).expect("a motion");
            let (size, at) = Measure::Probe(0).largest(system, &orbit, branch.turns());
            // of the vertex of a parabola through samples
            assert!((sizes[row] / size - 1.0).abs() < 2e-3, "{}: {} instead of {size}", p.speed, sizes[row]);
            asymmetric += usize::from(at.rem_euclid(std::f64::consts::TAU) > std::f64::consts::PI);
            row += 1;
        }
    }
    assert!(asymmetric > 20, "{asymmetric} of {row}");
}
