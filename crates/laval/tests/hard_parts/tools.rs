//! Second methods: motions and their maps by integration of the assembled residual.

use laval::model::system::System;
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::Programme;
use laval_num::complex::C64;
use laval_num::dense::Mat;
use laval_num::ode::{Control, Dop853, End, integrate};

/// The state of a machine at constant speed after a time, to rounding as far as the method goes.
pub fn advance(system: &System, speed: f64, y: &[f64], t: (f64, f64)) -> Vec<f64> {
    let mut motion = Motion::new(system, SpinLaw::Programme(Programme::constant(speed, 0.0))).unwrap();
    let mut y = y.to_vec();
    let n = system.n();
    let size = |x: &[f64]| x.iter().fold(0.0f64, |m, x| m.max(x.abs())).max(1e-6);
    let (q, v, z) = (size(&y[..n]), size(&y[n..2 * n]), size(&y[2 * n..]));
    let scale: Vec<f64> = (0..y.len())
        .map(|i| {
            1e-13
                * if i < n {
                    q
                } else if i < 2 * n {
                    v
                } else {
                    z
                }
        })
        .collect();
    let control = Control::new(1e-13, scale);
    let run = integrate(&mut Dop853::new(), &mut motion, t.0, &mut y, t.1, &control, &mut ());
    assert_eq!(run.end, End::Reached);
    y
}

/// Map of small disturbances over a time by central differences, turned back by `angle`.
pub fn map(system: &System, speed: f64, y: &[f64], time: f64, angle: f64) -> Mat {
    let n = y.len();
    let mut out = Mat::zeros(n, n);
    let q = system.n();
    for j in 0..n {
        let step = 1e-5 * if j < q { 1e-2 } else { 1e-2 * speed };
        let [p, m] = [step, -step].map(|d| {
            let mut y = y.to_vec();
            y[j] += d;
            let mut y = advance(system, speed, &y, (0.0, time));
            let (a, b) = y.split_at_mut(q);
            let (b, z) = b.split_at_mut(q);
            system.turn(a, -angle);
            system.turn(b, -angle);
            system.turn_states(z, -angle);
            y
        });
        for i in 0..n {
            out[(i, j)] = (p[i] - m[i]) / (2.0 * step);
        }
    }
    out
}

/// Every one of `some` has a partner among `all` closer than `tolerance`.
#[track_caller]
pub fn contained(some: &[C64], all: &[C64], tolerance: f64) {
    for z in some {
        let nearest = all.iter().map(|w| (*w - *z).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= tolerance, "{z:?} is {nearest:e} from the nearest of {all:?}");
    }
}

/// `|a - b|` over the size of `b`, largest entry.
pub fn relative(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs() / size).fold(0.0, |m, x| if x > m || x.is_nan() { x } else { m })
}

/// Jacobian and derivative in the parameter of a balance against central differences.
#[track_caller]
pub fn check_tangents(problem: &mut laval::solve::harmonic::balance::problem::Balance, x: &[f64], p: f64) {
    use laval_num::continuation::Zero;
    let n = problem.dim();
    let (mut r, mut jac, mut dp) = (vec![0.0; n], Mat::zeros(n, n), vec![0.0; n]);
    problem.eval(x, p, &mut r, Some(&mut jac), Some(&mut dp)).unwrap();
    let mut scale = vec![0.0; n];
    problem.scale(&mut scale);
    let mut at = |x: &[f64], p: f64| {
        let mut r = vec![0.0; n];
        problem.eval(x, p, &mut r, None, None).unwrap();
        r
    };
    // Richardson's rule on central differences: error of order 4
    let difference = |f: &mut dyn FnMut(f64) -> Vec<f64>, h: f64| -> Vec<f64> {
        let [a, b, c, d] = [h, -h, 0.5 * h, -0.5 * h].map(&mut *f);
        (0..n).map(|i| (8.0 * (c[i] - d[i]) - (a[i] - b[i])) / (6.0 * h)).collect()
    };
    let size = |v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let wanted = difference(&mut |h| at(x, p + h), 1e-3 * p);
    assert!(relative(&dp, &wanted) < 1e-7, "d/dp {dp:?} {wanted:?}");
    for j in 0..n {
        let step = 1e-2 * size(x).min(scale[j]).max(1e-3 * scale[j]);
        let wanted = difference(
            &mut |h| {
                let mut moved = x.to_vec();
                moved[j] += h;
                at(&moved, p)
            },
            step,
        );
        let column: Vec<f64> = (0..n).map(|i| jac[(i, j)]).collect();
        assert!(relative(&column, &wanted) < 1e-6, "column {j}: {}", relative(&column, &wanted));
    }
}

/// Response over a range with the usual request.
pub fn response(system: &System, speeds: (f64, f64)) -> laval::solve::harmonic::branches::response::Response {
    use laval::solve::harmonic::branches::response::respond;
    use std::sync::atomic::AtomicBool;
    static NEVER: AtomicBool = AtomicBool::new(false);
    respond(system, &crate::common::base::request(speeds.0, speeds.1), &NEVER, &|_| {}).unwrap()
}

/// The motions at all points of a response.
pub fn orbits(
    system: &System,
    response: &laval::solve::harmonic::branches::response::Response,
    speeds: (f64, f64),
) -> Vec<laval::solve::harmonic::balance::orbit::Orbit> {
    use laval::solve::harmonic::balance::{orbit::Orbit, problem::Balance};
    let mut balance = Balance::new(system, response.discretisation, speeds, None).unwrap();
    response.branches.iter().flat_map(|b| &b.points).map(|p| Orbit::of(&mut balance, &p.x, p.speed).unwrap()).collect()
}
