//! Gauss's rule for integrals of smooth functions.

use std::f64::consts::PI;

/// Nodes in (0, 1) and weights of Gauss's rule with `n` points: exact for polynomials up to degree `2 n - 1`.
///
/// Zeros of the Legendre polynomial by Newton's method from their asymptotic places.
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    let node = |i: usize| {
        let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut p, mut before) = (1.0, 0.0);
            for k in 0..n {
                let k = k as f64;
                (p, before) = (((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0), p);
            }
            slope = n as f64 * (x * p - before) / (x * x - 1.0);
            let step = p / slope;
            x -= step;
            if step.abs() <= 1e-15 {
                break;
            }
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

#[cfg(test)]
mod tests {
    use super::gauss;

    #[test]
    fn exact_for_polynomials_and_no_further() {
        for n in 1..=16usize {
            let rule = gauss(n);
            let of = |d: usize| rule.iter().map(|(x, w)| w * x.powi(d as i32)).sum::<f64>();
            for d in 0..2 * n {
                assert!((of(d) - 1.0 / (d as f64 + 1.0)).abs() < 1e-14, "{n} points, degree {d}");
            }
            // the error of degree 2n: (n!)^4 / ((2n + 1) ((2n)!)^2)
            let ratio = (1..=n).map(|k| k as f64 / (n + k) as f64).product::<f64>();
            let error = ratio * ratio / (2 * n + 1) as f64;
            if error > 1e-11 {
                assert!((1.0 / (2.0 * n as f64 + 1.0) - of(2 * n) - error).abs() < 1e-3 * error, "{n} points");
            }
        }
    }
}
