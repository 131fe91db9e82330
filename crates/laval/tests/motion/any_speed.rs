//! Rows of linear parts at any speed against those assembled at each speed.

use laval::file::load;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::part::At;
use laval::model::rows::{LinearRows, Padded};
use laval::model::system::System;

fn system(text: &str) -> System {
    load(text).unwrap_or_else(|d| panic!("{d:?}")).system
}

/// Gyroscopic moments and internal damping by the speed, liquid and unbalance by its square, and a spin that accelerates.
#[test]
fn rows_at_any_speed_are_those_of_each_speed() {
    let text = include_str!("../../../../examples/09-cream-separator/machine.toml");
    let with_damping = text.replace("material = \"steel\"", "material = \"steel\"\nrotating_damping = 1e-5");
    let mut seen = 0;
    for text in [text, &with_damping] {
        let system = system(text);
        let top = 800.0;
        let rows = LinearRows::of_any_speed(&system, top).expect("polynomials in the speed");
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        let n = system.n();
        let wave = |count: usize, k: f64| (0..count).map(|i| 1e-4 * (k * i as f64 + 0.3).sin()).collect::<Vec<f64>>();
        for speed in [0.0, 3.7, -410.0, 555.5, 800.0, 900.0] {
            system.linear(system.params(), speed, Form::Time, &mut model, &mut scratch);
            let m = model.states().len();
            let (q, v, a, z) = (wave(n, 1.1), wave(n, 2.3), vec![0.0; n], wave(m, 0.7));
            let at = At { t: 0.1, phase: 0.9, speed, spin_accel: 5.0, q: &q, v: &v, a: &a, z: &z };
            let (mut force, mut rate) = (vec![0.0; n], vec![0.0; m]);
            model.residual(&at, &mut force, &mut rate);
            let mut out = vec![0.0; model.held()];
            rows.residual(&at, &mut Padded::default(), &mut out);
            let size = force.iter().fold(0.0f64, |s, x| s.max(x.abs()));
            for (i, (found, should)) in out.iter().zip(force.iter().chain(&rate)).enumerate() {
                assert!((found - should).abs() <= 1e-11 * size.max(should.abs()), "row {i} at {speed} rad/s: {found} {should}");
            }
            assert!(size > 1e-3, "{size}");
            seen += 1;
        }
    }
    assert!(seen == 12 && with_damping != text);
}

/// A table over the speed, and cups whose load is no polynomial, have none.
#[test]
fn other_machines_have_none() {
    let with_table = |k: &str| {
        let text = format!(
            "[machine]\nname = \"m\"\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\n[[part]]\nkind = \"bearing_linear\"\nname = \"b\"\n\
         between = [\"d\", \"ground\"]\ntable = {{ speed = [0, 100, 105, 400], kxx = [1e5, {k}, {k}, {k}], kyy = [1e5, 1e5, 1e5, 1e5], cxx = [10, 10, 10, 10], cyy = [10, 10, 10, 10] }}\nbeyond = \"hold\"\n"
        );
        LinearRows::of_any_speed(&system(&text), 400.0)
    };
    assert!(with_table("1.5e5").is_none() && with_table("1e5").is_some());
    let cups = system(include_str!("../../../../examples/05-oil-desludging/machine.toml"));
    assert!(LinearRows::of_any_speed(&cups, 200.0).is_none());
}
