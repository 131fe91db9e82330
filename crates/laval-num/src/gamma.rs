//! The gamma function of a real argument, over any [`Scalar`] and so with exact derivatives.

use crate::scalar::Scalar;
use std::f64::consts::PI;

/// Coefficients of C. Lanczos, SIAM J. Numer. Anal. B 1 (1964) 86, for g = 7 (as computed by P. Godfrey).
const LANCZOS: [f64; 9] = [
    0.999_999_999_999_809_9,
    676.520_368_121_885_1,
    -1_259.139_216_722_402_8,
    771.323_428_777_653_1,
    -176.615_029_162_140_6,
    12.507_343_278_686_905,
    -0.138_571_095_265_720_12,
    9.984_369_578_019_572e-6,
    1.505_632_735_149_311_6e-7,
];

/// Gamma(x) for 0 < x < 10, relative error below 2e-14; infinite at 0.
///
/// Lanczos's formula for `Gamma(x + 1)`, divided by x.
#[inline(always)]
pub fn gamma<S: Scalar>(x: S) -> S {
    let mut sum = S::cst(LANCZOS[0]);
    for (k, &c) in LANCZOS.iter().enumerate().skip(1) {
        sum += S::cst(c) / (x + S::cst(k as f64));
    }
    let t = x + S::cst(7.5);
    ((x + S::cst(0.5)) * t.ln() - t).exp() * sum.scale((2.0 * PI).sqrt()) / x
}

#[cfg(test)]
mod tests {
    use super::gamma;
    use crate::dual::Dual;
    use std::f64::consts::PI;

    #[test]
    fn closed_forms() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 2e-14 * b.abs(), "{a} {b}");
        near(gamma(0.5), PI.sqrt());
        for (n, f) in [(1.0, 1.0), (2.0, 1.0), (3.0, 2.0), (5.0, 24.0), (8.0, 5040.0)] {
            near(gamma(n), f);
        }
        for k in 1..100 {
            let x = 0.01 * f64::from(k);
            near(gamma(x) * gamma(1.0 - x), PI / (PI * x).sin());
            near(gamma(x + 1.0), x * gamma(x));
        }
        assert!(gamma(0.0).is_infinite() && gamma(f64::NAN).is_nan());
    }

    /// The derivative at 1 is minus Euler's constant, at 1/2 it is -sqrt(pi) (C + 2 ln 2).
    #[test]
    fn derivative() {
        let euler = 0.577_215_664_901_532_9;
        let slope = |x: f64| gamma(Dual { re: x, eps: [1.0] }).eps[0];
        assert!((slope(1.0) + euler).abs() < 1e-13);
        assert!((slope(0.5) + PI.sqrt() * (euler + 2.0 * 2f64.ln())).abs() < 1e-12);
    }
}
