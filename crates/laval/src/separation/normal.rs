//! The normal distribution function and its inverse, to rounding.
//!
//! Equations: `erf x = 2/sqrt(pi) exp(-x^2) sum 2^k x^(2k+1)/(2k+1)!!` (all terms positive) near the origin, the continued fraction of `erfc`
//! beyond; the inverse by Halley steps.
//!
//! Sources: DLMF 7.6.2, 7.9.1.

use std::f64::consts::{FRAC_2_SQRT_PI, LN_2, PI, SQRT_2};

/// Where the fraction takes over from the series.
const JOINT: f64 = 2.5;

/// Complementary error function of `x >= 0`.
fn erfc(x: f64) -> f64 {
    if x < JOINT {
        let (mut term, mut sum) = (x, x);
        for k in 1..200 {
            term *= 2.0 * x * x / (2 * k + 1) as f64;
            sum += term;
            if term < 1e-17 * sum {
                break;
            }
        }
        return 1.0 - FRAC_2_SQRT_PI * (-x * x).exp() * sum;
    }
    // x + (1/2)/(x + 1/(x + (3/2)/(x + ...))), from its end
    let terms = (120.0 / x) as u32 + 20;
    let mut f = x;
    for k in (1..=terms).rev() {
        f = x + 0.5 * k as f64 / f;
    }
    (-x * x).exp() / (PI.sqrt() * f)
}

/// Probability below `x` of the standard normal law.
pub fn probability(x: f64) -> f64 {
    let tail = 0.5 * erfc(x.abs() / SQRT_2);
    if x < 0.0 { tail } else { 1.0 - tail }
}

/// The `x` below which a share `p` of the standard normal law lies; infinite at 0 and 1, NaN outside.
pub fn quantile(p: f64) -> f64 {
    if !(p > 0.0 && p < 1.0) {
        return if p == 0.0 {
            f64::NEG_INFINITY
        } else if p == 1.0 {
            f64::INFINITY
        } else {
            f64::NAN
        };
    }
    // the smaller tail keeps its digits
    let tail = p.min(1.0 - p);
    // tail of exp(-x^2/2): a start within a few percent
    let mut x = if tail > 0.2 { (0.5 - tail) * (2.0 * PI).sqrt() } else { (-2.0 * (tail.ln() + 0.5 * LN_2)).max(0.1).sqrt() };
    for _ in 0..30 {
        let density = (-0.5 * x * x).exp() / (2.0 * PI).sqrt();
        // probability above x against the tail
        let error = 0.5 * erfc(x.max(0.0) / SQRT_2) - tail;
        let newton = error / density;
        let step = newton / (1.0 - 0.5 * x * newton).max(0.5);
        x = (x + step).max(0.0);
        if step.abs() <= 1e-16 * x.abs() {
            break;
        }
    }
    if p < 0.5 { -x } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tabulated_values() {
        for (x, p) in [
            (0.0, 0.5),
            (1.0, 0.841344746068543),
            (-1.959963984540054, 0.025),
            (-3.0, 0.0013498980316301),
            (-5.0, 2.866515718791939e-7),
            (-8.0, 6.22096057427178e-16),
        ] {
            assert!((probability(x) / p - 1.0).abs() < 2e-13, "{x} {}", probability(x));
        }
    }

    #[test]
    fn the_inverse_inverts() {
        for i in 1..2000 {
            let p = i as f64 / 2000.0;
            assert!((probability(quantile(p)) - p).abs() < 4e-16, "{p}");
        }
        for p in [1e-300, 1e-20, 1e-8] {
            assert!((probability(quantile(p)) / p - 1.0).abs() < 1e-11, "{p}");
        }
        assert_eq!((quantile(0.0), quantile(1.0)), (f64::NEG_INFINITY, f64::INFINITY));
        assert!(quantile(1.2).is_nan() && quantile(f64::NAN).is_nan());
    }
}
