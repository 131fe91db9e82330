//! Complete elliptic integrals and Jacobi's elliptic functions of a real argument, to rounding.
//!
//! ```text
//! K(m) = int_0^(pi/2) (1 - m sin^2)^(-1/2),   E(m) = int_0^(pi/2) (1 - m sin^2)^(1/2),   0 <= m < 1
//! u = int_0^phi (1 - m sin^2)^(-1/2),   sn = sin phi,  cn = cos phi,  dn = sqrt(1 - m sn^2)
//! ```
//!
//! Everything is in the parameter `m = k^2`, k the modulus. The integrals come from the arithmetic-geometric mean of 1 and `sqrt(1 - m)`; the functions from
//! the same means, followed back by Gauss's transformation. `cn` swings like the free oscillation of a mass on a spring that hardens with the cube:
//! `cn'' = (2m - 1) cn - 2m cn^3`.
//!
//! Sources: R. Bulirsch, Numer. Math. 7 (1965) 78; M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 16.23, 17.3, 17.6.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Complete elliptic integral of the first kind. NaN where `m > 1`; infinite at `m = 1`.
pub fn complete_first(m: f64) -> f64 {
    FRAC_PI_2 / mean((1.0 - m).sqrt()).0
}

/// Complete elliptic integral of the second kind. NaN where `m > 1`; 1 at `m = 1`.
pub fn complete_second(m: f64) -> f64 {
    if m == 1.0 {
        return 1.0;
    }
    let (a, sum) = mean((1.0 - m).sqrt());
    FRAC_PI_2 / a * (1.0 - 0.5 * (m + sum))
}

/// Arithmetic-geometric mean of 1 and `b`, and `sum over n >= 1 of 2^n c_n^2` with `c_n` half the difference of the n-th pair's forerunners.
fn mean(mut b: f64) -> (f64, f64) {
    let (mut a, mut sum, mut weight) = (1.0, 0.0, 1.0);
    if b.is_nan() || b == 0.0 {
        return (b, b);
    }
    // seven means close on rounding for every b that is not 0
    for _ in 0..64 {
        let c: f64 = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        weight *= 2.0;
        sum += weight * c * c;
        // the next difference is the square of this one
        if c.abs() <= 1e-9 * a {
            break;
        }
    }
    (a, sum)
}

/// Jacobi's `(sn, cn, dn)` of `u` at the parameter `m`, `0 <= m <= 1`; NaN outside.
pub fn jacobi(u: f64, m: f64) -> (f64, f64, f64) {
    if !(0.0..=1.0).contains(&m) || !u.is_finite() {
        return (f64::NAN, f64::NAN, f64::NAN);
    }
    if m == 1.0 {
        let sech = 1.0 / u.cosh();
        return (u.tanh(), sech, sech);
    }
    // descending means
    let mut pairs = [(0.0, 0.0); 16];
    let (mut a, mut b, mut last) = (1.0, (1.0 - m).sqrt(), 0);
    for (k, pair) in pairs.iter_mut().enumerate() {
        *pair = (a, b);
        last = k;
        let close = (a - b).abs() <= 1e-9 * a;
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        if close {
            break;
        }
    }
    // the angle of the limit, where all functions are circular; whole periods are taken off
    let angle = (u * a) % TAU;
    let (mut sn, mut cn) = angle.sin_cos();
    let mut dn = 1.0;
    if sn != 0.0 {
        // back through the means: c stands for the cotangent times the mean
        let mut ratio = cn / sn;
        let mut c = a * ratio;
        for &(a, b) in pairs[..=last].iter().rev() {
            ratio *= c;
            c *= dn;
            dn = (b + ratio) / (a + ratio);
            ratio = c / a;
        }
        let size = 1.0 / c.hypot(1.0);
        sn = if sn < 0.0 { -size } else { size };
        cn = c * sn;
    }
    (sn, cn, dn)
}

/// First cosine coefficients of `cn` and of `cn^3` over a period `4 K(m)`: of `cos v` with `v = pi u / (2 K)`.
pub fn first_coefficients(m: f64) -> (f64, f64) {
    (coefficient(1, m), cubed_coefficient(1, m))
}

/// Coefficient of `cos n v` of `cn(2 K v / pi)` for odd n: `(pi / k K) sech(n pi K' / 2 K)`; 0 for even n.
pub fn coefficient(n: u32, m: f64) -> f64 {
    if n.is_multiple_of(2) {
        return 0.0;
    }
    if m == 0.0 {
        return if n == 1 { 1.0 } else { 0.0 };
    }
    let (k, whole) = (m.sqrt(), complete_first(m));
    // K' by its own mean: 1 - m would lose a small m
    let other = FRAC_PI_2 / mean(k).0;
    PI / (k * whole) / (f64::from(n) * FRAC_PI_2 * other / whole).cosh()
}

/// Coefficient of `cos n v` of `cn^3`.
pub fn cubed_coefficient(n: u32, m: f64) -> f64 {
    if n.is_multiple_of(2) {
        return 0.0;
    }
    // the mean over equally spaced points: exact once the aliased orders are rounding
    let order = f64::from(n);
    let whole = complete_first(m);
    let other = FRAC_PI_2 / mean(m.sqrt()).0;
    let decay = PI * other / (2.0 * whole);
    if !(decay > 0.05) {
        // close to m = 1 the equation of motion gives it without cancellation
        let f = order * FRAC_PI_2 / whole;
        return coefficient(n, m) * (2.0 * m - 1.0 + f * f) / (2.0 * m);
    }
    let points = 2 * ((40.0 / decay).min(800.0) as usize + n as usize + 8);
    let sum: f64 = (0..points)
        .map(|j| {
            let v = TAU * j as f64 / points as f64;
            jacobi(2.0 * whole * v / PI, m).1.powi(3) * (order * v).cos()
        })
        .sum();
    2.0 * sum / points as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARAMETERS: [f64; 9] = [0.0, 1e-12, 1e-3, 0.1, 0.3, 0.5, 0.8, 0.99, 1.0 - 1e-9];

    fn close(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance * b.abs().max(1.0), "{a} {b}: {:e}", (a - b).abs());
    }

    /// Gauss's lemniscate: K(1/2) = Gamma(1/4)^2 / (4 sqrt pi); 2 E - K = pi / (2 K) there.
    #[test]
    fn lemniscate() {
        let quarter = 3.625_609_908_221_908_f64;
        let k = quarter * quarter / (4.0 * PI.sqrt());
        close(complete_first(0.5), k, 1e-15);
        close(2.0 * complete_second(0.5) - k, FRAC_PI_2 / k, 1e-15);
    }

    #[test]
    fn ends() {
        assert_eq!((complete_first(0.0), complete_second(0.0)), (FRAC_PI_2, FRAC_PI_2));
        assert_eq!((complete_first(1.0), complete_second(1.0)), (f64::INFINITY, 1.0));
        assert!(complete_first(1.5).is_nan() && complete_second(1.5).is_nan() && complete_first(f64::NAN).is_nan());
        // ln 4/k' and 1 + (ln 4/k' - 1/2) k'^2/2 near m = 1
        let m = 1.0 - 2f64.powi(-40);
        let l = (4.0 * 2f64.powi(20)).ln();
        close(complete_first(m), l + (l - 1.0) * (1.0 - m) / 4.0, 1e-14);
        close(complete_second(m), 1.0 + (l - 0.5) * (1.0 - m) / 2.0, 1e-14);
        for m in [-0.1, 1.1, f64::NAN] {
            assert!(jacobi(0.3, m).1.is_nan());
        }
    }

    /// E K' + E' K - K K' = pi / 2.
    #[test]
    fn legendre() {
        for m in [0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999] {
            let (k, e, k1, e1) = (complete_first(m), complete_second(m), complete_first(1.0 - m), complete_second(1.0 - m));
            close(e * k1 + e1 * k - k * k1, FRAC_PI_2, 2e-15 * k.max(k1));
        }
    }

    #[test]
    fn squares_sum_to_one() {
        for m in PARAMETERS {
            for j in -40..=40 {
                let (sn, cn, dn) = jacobi(0.37 * f64::from(j), m);
                close(sn * sn + cn * cn, 1.0, 1e-15);
                close(dn * dn + m * sn * sn, 1.0, 1e-14);
            }
        }
    }

    /// Half and whole quarter periods, and the shift by a quarter: cn(u + K) = -k' sn(u) / dn(u).
    #[test]
    fn quarter_periods() {
        for m in &PARAMETERS[..8] {
            let (k, k1) = (complete_first(*m), (1.0 - m).sqrt());
            let (sn, cn, dn) = jacobi(0.5 * k, *m);
            close(sn, (1.0 / (1.0 + k1)).sqrt(), 1e-14);
            close(cn, (k1 / (1.0 + k1)).sqrt(), 1e-14);
            close(dn, k1.sqrt(), 1e-14);
            for u in [0.1, 0.7, 1.3] {
                let (s, c, d) = jacobi(u, *m);
                let (sk, ck, dk) = jacobi(u + k, *m);
                close(ck, -k1 * s / d, 1e-14);
                close(sk, c / d, 1e-14);
                close(dk, k1 / d, 1e-14);
                close(jacobi(u + 4.0 * k, *m).1, c, 1e-14);
            }
        }
    }

    /// sn(u + v) (1 - m sn^2 u sn^2 v) = sn u cn v dn v + sn v cn u dn u, and alike for cn and dn.
    #[test]
    fn addition_theorem() {
        for m in PARAMETERS {
            for (u, v) in [(0.3, 0.4), (1.1, -0.6), (0.05, 2.0)] {
                let ((s, c, d), (t, e, f), (sn, cn, dn)) = (jacobi(u, m), jacobi(v, m), jacobi(u + v, m));
                let base = 1.0 - m * s * s * t * t;
                close(sn * base, s * e * f + t * c * d, 2e-15 * 4.0);
                close(cn * base, c * e - s * d * t * f, 1e-14);
                close(dn * base, d * f - m * s * c * t * e, 1e-14);
            }
        }
    }

    #[test]
    fn circular_and_hyperbolic_limits() {
        for u in [-2.0, -0.3, 0.0, 0.5, 3.0f64] {
            let (sn, cn, dn) = jacobi(u, 0.0);
            close(sn, u.sin(), 1e-15);
            close(cn, u.cos(), 1e-15);
            assert_eq!(dn, 1.0);
            let (sn, cn, _) = jacobi(u, 1.0 - 1e-16);
            close(sn, u.tanh(), 1e-14);
            close(cn, 1.0 / u.cosh(), 1e-14);
        }
    }

    /// The series gives back the function; that of the cube its cube; both together the equation of motion.
    #[test]
    fn fourier_series() {
        for m in [0.0, 1e-8, 1e-3, 0.2, 0.5, 0.9] {
            let k = complete_first(m);
            for v in [0.0, 0.4, 1.2, 2.5, 4.0f64] {
                let series = |c: &dyn Fn(u32) -> f64| (0..60).map(|i| 2 * i + 1).map(|n| c(n) * (f64::from(n) * v).cos()).sum::<f64>();
                let cn = jacobi(2.0 * k * v / PI, m).1;
                close(series(&|n| coefficient(n, m)), cn, 1e-14);
                close(series(&|n| cubed_coefficient(n, m)), cn.powi(3), 2e-14);
            }
            for n in [1, 3, 5] {
                let f = f64::from(n) * FRAC_PI_2 / k;
                close(2.0 * m * cubed_coefficient(n, m), (2.0 * m - 1.0 + f * f) * coefficient(n, m), 1e-14);
            }
        }
        assert_eq!(coefficient(2, 0.5), 0.0);
        let (first, cubed) = first_coefficients(0.0);
        close(first, 1.0, 0.0);
        close(cubed, 0.75, 1e-15);
    }
}
