//! End states that other integrators agree on, and orbits known in closed form.

use super::{constant, explicit, motion, stiff};
use crate::common::Base;
use laval::solve::motion::SpinLaw;
use laval::solve::programme::Programme;
use laval_num::complex::c;
use laval_num::ode::Ode;

/// Free-surface radius over cavity radius (1: empty), isotropic law, speed, wave damping, end time; x1, y1, their rates, x2, y2, surface x, y.
/// Start with the rotor at x1 = 0.1 mm, all else zero. Two integrators of different order agree to 1e-12 m.
type Row = (f64, bool, f64, f64, f64, &'static [f64]);
const TRANSIENTS: [Row; 5] = [
    (1.0, false, 900.0, 0.0, 0.05, &[7.761583373e-05, -0.0004077428172, -0.1642139086, 0.03597835033, 9.844210423e-06, -0.0006128994052]),
    (1.0, true, 2900.0, 0.0, 0.05, &[-0.002842807891, -0.005332105167, 9.275644647, -8.98593985, 0.0002584650001, -0.001343361569]),
    (
        0.667,
        false,
        1500.0,
        0.0,
        0.05,
        &[0.001232173737, -0.001739966965, 1.430456395, 1.887592983, -0.0001841698401, -0.0007395669589, -0.001047670422, 0.0006453964977],
    ),
    (
        0.667,
        true,
        3000.0,
        0.0,
        0.04,
        &[0.005155413455, -0.01024679802, 22.04693909, 13.47289124, -0.001031809423, -0.001014218155, -0.01914721816, 0.01416385181],
    ),
    (
        0.8,
        false,
        2000.0,
        20.0,
        0.05,
        &[0.006651349909, -0.002022407778, 1.60602607, 13.31563285, -0.0009018062842, -0.0009974692977, -0.00658957267, 0.0009131497997],
    ),
];

#[test]
fn reference_transients() {
    for (r, isotropic, speed, wave_damping, end, want) in TRANSIENTS {
        let system = Base { fill: (r < 1.0).then_some(r), isotropic, wave_damping, ..Base::default() }.builder().build().unwrap();
        // the compiled form, the general one at the same speed, and the implicit method
        let held = Programme::table(&[0.0, 1.0], &[speed; 2], 0.0).unwrap();
        for (law, implicit) in [(constant(speed), false), (SpinLaw::Programme(held), false), (constant(speed), true)] {
            let compiled = matches!(&law, SpinLaw::Programme(p) if p.constant_speed().is_some());
            let mut m = motion(&system, law);
            assert_eq!(m.is_compiled(), compiled);
            let mut y = vec![0.0; m.dim()];
            y[0] = 1e-4;
            if implicit {
                stiff(&mut m, &mut y, 0.0, end, 1e-11, 1e-14)
            } else {
                explicit(&mut m, &mut y, 0.0, end, 1e-12, 1e-15)
            }
            for (&i, &want) in [0, 1, 4, 5, 2, 3, 10, 11].iter().zip(want) {
                assert!((y[i] - want).abs() < 1e-8 * want.abs(), "{speed} state {i}: {:e} {want:e} implicit {implicit}", y[i]);
            }
        }
    }
}

/// Isotropic law: the circular orbit is exact. Fill, speed, start of the search, |z1|. The liquid turns with the rotor: the surface stays centred.
#[test]
fn circular_orbits_persist() {
    for (fill, speed, guess, want) in
        [(None, 2900.0, c(0.0103, -0.002), 0.009294383466), (Some(0.667), 1800.0, c(0.003, 0.0), 0.002564077569)]
    {
        let liquid = if fill.is_some() { std::f64::consts::PI * 0.07 * 0.07 * 0.06 * 1000.0 } else { 0.0 };
        let k1 = c(-(2.4 + liquid) * speed * speed, 42.0 * speed);
        let k2 = c(3.26e5 - 25.0 * speed * speed, 6.59 * speed);
        let force = 2.4 * 1e-3 * speed * speed;
        // K d + (c0 + c1 |d|^2) d = T m e W^2, by Newton over the two real unknowns
        let (k, t) = (k1 * k2 / (k1 + k2), k2 / (k1 + k2));
        let residual = |d: laval_num::complex::C64| k * d + d.scale(1.1e7 + 8.7e10 * d.norm_sqr()) - t.scale(force);
        let mut d = guess;
        for _ in 0..60 {
            let r = residual(d);
            let h = 1e-7;
            let (a, b) = (
                (residual(d + c(h, 0.0)) - residual(d - c(h, 0.0))).scale(0.5 / h),
                (residual(d + c(0.0, h)) - residual(d - c(0.0, h))).scale(0.5 / h),
            );
            let det = a.re * b.im - a.im * b.re;
            d -= c((b.im * r.re - b.re * r.im) / det, (a.re * r.im - a.im * r.re) / det);
        }
        let z2 = d.scale(1.1e7 + 8.7e10 * d.norm_sqr()) / k2;
        let z1 = z2 + d;
        assert!((z1.abs() - want).abs() < 1e-9 * want, "{} {want}", z1.abs());
        let system = Base { fill, isotropic: true, ..Base::default() }.builder().build().unwrap();
        let mut m = motion(&system, constant(speed));
        let mut y = vec![0.0; m.dim()];
        for (i, z) in [z1, z2].into_iter().enumerate() {
            let v = z.mul_i().scale(speed);
            (y[2 * i], y[2 * i + 1], y[4 + 2 * i], y[5 + 2 * i]) = (z.re, z.im, v.re, v.im);
        }
        if fill.is_some() {
            (y[10], y[11]) = (-z1.re, -z1.im);
        }
        let periods = 40.0 * std::f64::consts::TAU / speed;
        explicit(&mut m, &mut y, 0.0, periods, 1e-12, 1e-15);
        assert!((y[0].hypot(y[1]) - want).abs() < 1e-8 * want && (c(y[0], y[1]) - z1).abs() < 1e-8 * want, "{y:?} {z1:?}");
    }
}

/// End states after 250 periods from rest: damping, eccentricity, speed, x1, y1; converged to 5e-10.
#[test]
fn long_transients_from_rest() {
    let rows = [
        (42.0, 1e-3, 275.0, -9.0107751689e-5, 6.675835849e-7),
        (42.0, 1e-3, 1775.0, 1.36026417963e-3, 4.8356411572e-4),
        (42.0, 1e-3, 2775.0, 9.70244253793e-3, -1.90103807740e-3),
        (42.0, 1e-3, 4775.0, -1.34170302347e-3, -2.80175434056e-3),
        (420.0, 1e-5, 2275.0, -4.59068183905e-5, -1.11014124666e-4),
        (420.0, 1e-5, 4775.0, -1.25694543483e-5, -3.3576859092e-6),
    ];
    for (chi, e, speed, x, z) in rows {
        let system = Base { chi, e, ..Base::default() }.builder().build().unwrap();
        let mut m = motion(&system, constant(speed));
        let mut y = vec![0.0; m.dim()];
        explicit(&mut m, &mut y, 0.0, 250.0 * std::f64::consts::TAU / speed, 1e-12, 1e-16);
        let size = f64::hypot(x, z);
        assert!((y[0] - x).abs() < 2e-9 * size && (y[1] - z).abs() < 2e-9 * size, "{chi} {speed}: {:e} {:e}", y[0] - x, y[1] - z);
    }
}
