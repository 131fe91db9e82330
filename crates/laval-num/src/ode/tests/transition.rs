//! Maps over steps side by side against closed forms and the integrator.

use crate::dense::Mat;
use crate::lanes::LANES;
use crate::ode::transition::{Row, STAGES, Transition, Varying, nodes};
use crate::ode::{Control, Dop853, integrate, ode};

/// `x'' + (a + b cos t) x = 0` over a time, in `groups` groups of steps.
fn mathieu(a: f64, b: f64, time: f64, groups: usize, tolerance: f64) -> (Mat, f64) {
    let h = time / (groups * LANES) as f64;
    let (mut transition, mut map, mut worst) = (Transition::default(), Mat::identity(2), 0.0f64);
    for group in 0..groups {
        let values: Vec<Row> =
            nodes().iter().map(|node| std::array::from_fn(|lane| (((group * LANES + lane) as f64 + node) * h).cos())).collect();
        assert_eq!(values.len(), STAGES);
        let a = Varying { n: 2, constant: &[(0, 1, 1.0), (1, 0, -a)], entries: &[(1, 0, 0, -b)], width: 1, values: &values };
        let error = transition.steps(&a, h, tolerance, &mut map);
        if error.is_nan() || error > worst {
            worst = error;
        }
    }
    (map, worst)
}

#[test]
fn a_constant_oscillator_turns() {
    let (time, w) = (2.0, 1.7f64);
    let (map, worst) = mathieu(w * w, 0.0, time, 1, 1e-9);
    let (s, c) = (w * time).sin_cos();
    for (found, exact) in map.data().iter().zip([c, s / w, -w * s, c]) {
        assert!((found - exact).abs() < 1e-11, "{found} instead of {exact}");
    }
    assert!(worst < 1.0, "{worst}");
}

#[test]
fn a_mathieu_equation_is_that_of_the_integrator_and_keeps_its_area() {
    let (map, worst) = mathieu(2.3, 1.1, 9.0, 4, 1e-10);
    assert!(worst < 1.0, "{worst}");
    for column in 0..2 {
        let mut y = [0.0, 0.0];
        y[column] = 1.0;
        let mut problem = ode(2, |t, y: &[f64], dy: &mut [f64]| (dy[0], dy[1]) = (y[1], -(2.3 + 1.1 * t.cos()) * y[0]));
        integrate(&mut Dop853::new(), &mut problem, 0.0, &mut y, 9.0, &Control::new(1e-12, 1e-12), &mut ());
        for i in 0..2 {
            assert!((map[(i, column)] - y[i]).abs() < 3e-10, "{} instead of {}", map[(i, column)], y[i]);
        }
    }
    let area = map[(0, 0)] * map[(1, 1)] - map[(0, 1)] * map[(1, 0)];
    assert!((area - 1.0).abs() < 1e-10, "{area}");
}

#[test]
fn the_order_is_eight_and_the_estimate_covers_the_error() {
    let (fine, _) = mathieu(2.3, 1.1, 40.0, 24, 1e-12);
    let error = |groups: usize| {
        let (map, worst) = mathieu(2.3, 1.1, 40.0, groups, 1e-8);
        let error = map.data().iter().zip(fine.data()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error < 1e-8 * worst * (groups * LANES) as f64 * fine.max_size(), "{error} beside an estimate of {worst}");
        error
    };
    let order = (error(3) / error(6)).log2();
    assert!((7.5..9.5).contains(&order), "order {order}");
}

#[test]
fn what_is_not_finite_is_no_error_within_the_tolerance() {
    let (_, worst) = mathieu(f64::NAN, 0.0, 1.0, 1, 1e-6);
    assert!(worst.is_nan());
}
