//! Bessel functions of complex argument against numbers of 40 digits, Wronskians, recurrences, integrals and closed derivatives.

use laval_num::bessel::{Bessel, bessel, excess};
use laval_num::complex::{C64, c};
use laval_num::dual::Dual;
use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::scalar::Scalar;
use std::f64::consts::{PI, TAU};

/// Points over the half plane: sizes from 1e-3 to 1e4, arguments to the imaginary axis, on both sides of each change of method.
fn points() -> Vec<C64> {
    let sizes = [
        1e-3, 0.03, 0.4, 0.74, 0.76, 1.2, 1.24, 1.49, 1.51, 2.0, 4.0, 4.14, 4.16, 7.0, 8.29, 8.31, 7.0, 13.0, 24.9, 25.1, 31.9, 59.9, 60.0,
        199.0, 1e3, 1e4,
    ];
    let angles = [-1.0, -0.98, -0.6, -0.2, 0.0, 0.05, 0.4, 0.8, 0.999, 1.0];
    let at = |size: f64, a: f64| if f64::abs(a) == 1.0 { c(0.0, a * size) } else { C64::cis(0.5 * PI * a).scale(size) };
    sizes.iter().flat_map(|&s| angles.iter().map(move |&a| at(s, a))).collect()
}

/// Error relative to the larger of the value and the envelope.
fn error(is: C64, should: C64, z: C64) -> f64 {
    let envelope = if z.abs() > 1.0 { 1.0 / (TAU * z.abs()).sqrt() } else { 0.0 };
    (is - should).abs() / should.abs().max(envelope)
}

#[test]
fn digits_of_a_slower_arithmetic() {
    let rows: Vec<Vec<f64>> = include_str!("data/bessel.csv")
        .lines()
        .filter(|l| !l.starts_with(['#', 'z']))
        .map(|line| line.split(',').map(|x| x.parse().unwrap()).collect())
        .collect();
    assert!(rows.len() > 150);
    for group in rows.chunks(LANES) {
        let at = |l: usize| &group[l % group.len()];
        let lanes = dispatch(Level::best(), InLanes(std::array::from_fn(|l| at(l)[0]), std::array::from_fn(|l| at(l)[1])));
        for (l, x) in group.iter().enumerate() {
            let z = c(x[0], x[1]);
            let b = bessel(z);
            for (n, f) in b.i.into_iter().chain(b.k).enumerate() {
                let should = c(x[2 + 2 * n], x[3 + 2 * n]);
                for found in [f, c(lanes[n][0][l], lanes[n][1][l])] {
                    let e = error(found, should, z);
                    assert!(e < 2e-14, "function {n} at {z:?}: {e:e}");
                }
            }
        }
    }
}

/// `I_n K_(n+1) + I_(n+1) K_n = 1/z`, and the recurrences to order 2.
#[test]
fn wronskians_and_recurrences() {
    for z in points() {
        let Bessel { i, k } = bessel(z);
        for n in 0..2 {
            let sum = (i[n] * k[n + 1] + i[n + 1] * k[n]) * z;
            let size = (i[n] * k[n + 1] * z).abs() + 1.0;
            assert!((sum - c(1.0, 0.0)).abs() < 2e-14 * size, "{z:?} {n}: {sum:?}");
        }
        let r = z.recip().scale(2.0);
        assert!((i[0] - i[2] - r * i[1]).abs() < 2e-14 * i[0].abs().max((r * i[1]).abs()), "{z:?}");
        assert!((k[2] - k[0] - r * k[1]).abs() < 2e-14 * k[2].abs(), "{z:?}");
        // the conjugate argument has the conjugate values
        let mirrored = bessel(z.conj());
        assert!((0..3).all(|n| (mirrored.i[n].conj() - i[n]).abs() <= 1e-14 * i[n].abs().max(mirrored.i[n].abs())), "{z:?}");
    }
}

/// `pi I_n = int_0^pi exp(z cos t) cos(n t) dt` and `K_n = int_0^inf exp(-z cosh t) cosh(n t) dt` by the trapezoidal rule, which converges geometrically.
#[test]
fn integrals() {
    for z in points().into_iter().filter(|z| z.abs() > 0.3 && z.abs() < 100.0) {
        let b = bessel(z);
        for n in 0..3 {
            let order = n as f64;
            let steps = 400;
            let term = |j: i32| {
                let t = PI * f64::from(j) / f64::from(steps);
                let end = if j == 0 || j == steps { 0.5 } else { 1.0 };
                z.scale(t.cos() - 1.0).exp().scale(end * (order * t).cos() / f64::from(steps))
            };
            let sum = (0..=steps).fold(C64::zero(), |s, j| s + term(j));
            assert!(error(b.i[n], sum, z) < 3e-14, "I{n} at {z:?}");
            if z.arg().abs() < 1.3 {
                let (h, mut sum) = (0.01, c(0.5, 0.0));
                for j in 1..1500 {
                    let t = h * f64::from(j);
                    sum += z.scale(1.0 - t.cosh()).exp().scale((order * t).cosh());
                }
                assert!(error(b.k[n], sum.scale(h), z) < 3e-14, "K{n} at {z:?}");
            }
        }
    }
}

/// Exact derivatives: `I_0' = I_1`, `K_0' = -K_1`, `(z I_1)' = z I_0`, `(z K_1)' = -z K_0` (scaled), and the differential equation to second order.
#[test]
fn derivatives() {
    type D = Dual<Dual<f64, 1>, 1>;
    for z in points().into_iter().filter(|z| z.abs() > 0.3 && z.abs() < 2e3) {
        let unit = |re: f64, along: f64| D { re: Dual { re, eps: [along] }, eps: [Dual::lift(along)] };
        let b = bessel(c(unit(z.re, 1.0), unit(z.im, 0.0)));
        for n in 0..3 {
            let order = n as f64;
            for (f, sign) in [(b.i[n], 1.0), (b.k[n], -1.0)] {
                let value = c(f.re.re.re, f.im.re.re);
                let first = c(f.re.re.eps[0], f.im.re.eps[0]);
                let second = c(f.re.eps[0].eps[0], f.im.eps[0].eps[0]);
                // of F(z) = f(z) exp(sign z): z^2 F'' + z F' - (z^2 + n^2) F = 0
                let z2 = z * z;
                let rest = z2 * (second + first.scale(2.0 * sign)) + z * (first + value.scale(sign)) - value.scale(order * order);
                let size = z2.abs() * (second.abs() + 2.0 * first.abs()) + z.abs() * value.abs();
                assert!(rest.abs() < 1e-13 * (size + z2.abs() * 1e-2 * value.abs()), "{n} {sign} at {z:?}: {rest:?} {size}");
            }
        }
    }
}

#[test]
fn excess_over_the_limit_at_zero() {
    for z in [c(0.01, 0.0), c(0.5, 0.4), c(0.0, 2.9), c(2.9, 0.0)] {
        let (b, e) = (bessel(z), excess(z));
        let up = z.exp();
        let direct = [(b.i[1] * up * z.recip()).scale(2.0) - c(1.0, 0.0), (b.i[2] * up * (z * z).recip()).scale(8.0) - c(1.0, 0.0)];
        for (e, d) in e.into_iter().zip(direct) {
            assert!((e - d).abs() < 1e-14 * (1.0 + e.abs()), "{z:?}");
        }
    }
    // the first terms of the series, which subtraction would lose
    let z = c(1e-5, 2e-5);
    let q = z * z;
    let [first, second] = excess(z);
    assert!((first - q.scale(1.0 / 8.0)).abs() < 1e-9 * first.abs() && (second - q.scale(1.0 / 12.0)).abs() < 1e-9 * second.abs());
}

#[test]
fn nothing_where_nothing_is_promised() {
    for z in [c(0.0, 0.0), c(-1e-9, 1.0), c(f64::NAN, 1.0), c(1.0, f64::NAN)] {
        assert!(bessel(z).i[0].re.is_nan() && bessel(z).k[1].im.is_nan(), "{z:?}");
    }
}

struct InLanes([f64; LANES], [f64; LANES]);

impl Kernel for InLanes {
    type Out = Vec<[[f64; LANES]; 4]>;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        let z = c(Dual::<S, 1>::seed(S::load(&self.0), 0), Dual::<S, 1>::lift(S::load(&self.1)));
        let b = bessel(z);
        let arrays = |f: laval_num::complex::Complex<Dual<S, 1>>| [f.re.re, f.im.re, f.re.eps[0], f.im.eps[0]].map(S::to_array);
        b.i.into_iter().chain(b.k).map(arrays).collect()
    }
}

/// Lanes hold the functions of their arguments and the derivatives, at every level and by whatever ways: all far, all in the middle, mixed; the same bits at all levels.
#[test]
fn lanes_are_their_arguments_one_by_one() {
    type D = Dual<f64, 1>;
    let all = points();
    let middle = points().into_iter().filter(|z| z.abs() > 1.5 && z.abs() < 60.0).collect::<Vec<C64>>();
    let far = points().into_iter().filter(|z| z.abs() > 25.0).collect::<Vec<C64>>();
    for group in all.chunks(LANES).chain(middle.chunks(LANES)).chain(far.chunks(LANES)) {
        let at = |l: usize| group[l % group.len()];
        let (re, im): ([f64; LANES], [f64; LANES]) = (std::array::from_fn(|l| at(l).re), std::array::from_fn(|l| at(l).im));
        let best = dispatch(Level::best(), InLanes(re, im));
        for level in Level::supported() {
            let found = dispatch(level, InLanes(re, im));
            let bits = |f: &[[[f64; LANES]; 4]]| f.iter().flatten().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&found), bits(&best));
            for l in 0..LANES {
                let Bessel { i, k } = bessel(c(D::seed(re[l], 0), D::cst(im[l])));
                for (f, lanes) in i.into_iter().chain(k).zip(&found) {
                    let [value, slope] = [c(f.re.re, f.im.re), c(f.re.eps[0], f.im.eps[0])];
                    let z = at(l);
                    assert!(error(c(lanes[0][l], lanes[1][l]), value, z) < 2e-14, "{z:?} {level:?}");
                    assert!((c(lanes[2][l], lanes[3][l]) - slope).abs() < 1e-13 * (slope.abs() + value.abs()), "{z:?} {level:?}");
                }
            }
        }
    }
}
