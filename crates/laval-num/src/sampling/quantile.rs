//! Quantiles of a sample with confidence intervals that assume no distribution, and shares.

use super::distribution::normal_quantile;
use serde::{Deserialize, Serialize};

/// A number with its confidence interval; NaN where the sample is too small to bound it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// The estimate.
    pub value: f64,
    /// Lower bound.
    pub low: f64,
    /// Upper bound.
    pub high: f64,
}

/// The quantile `p` of `sorted` (rising) by linear interpolation between order statistics (definition 7 of Hyndman and Fan 1996), with the
/// interval between two order statistics that holds the true one with probability `confidence` at least: the number of values below it is
/// binomial, whatever the distribution.
///
/// ```
/// use laval_num::sampling::quantile::quantile;
/// let x: Vec<f64> = (1..=10).map(f64::from).collect();
/// let median = quantile(&x, 0.5, 0.95);
/// // a table of every textbook: the 2nd and the 9th of 10 hold the median with 97.9 %
/// assert_eq!((median.value, median.low, median.high), (5.5, 2.0, 9.0));
/// ```
pub fn quantile(sorted: &[f64], p: f64, confidence: f64) -> Interval {
    let n = sorted.len();
    if n == 0 {
        return Interval { value: f64::NAN, low: f64::NAN, high: f64::NAN };
    }
    let at = p * (n - 1) as f64;
    let i = (at.floor() as usize).min(n - 1);
    let value = if i + 1 < n { sorted[i] + (at - i as f64) * (sorted[i + 1] - sorted[i]) } else { sorted[i] };
    let below = binomial(n, p);
    let tail = 0.5 * (1.0 - confidence);
    // x(l) lies above the quantile when fewer than l values lie below it
    let (mut low, mut sum) = (None, 0.0);
    for (k, w) in below.iter().enumerate().take(n) {
        sum += w;
        if sum > tail {
            break;
        }
        low = Some(k);
    }
    // x(u) lies below it when u or more do
    let (mut high, mut sum) = (None, 0.0);
    for (k, w) in below.iter().enumerate().skip(1).rev() {
        sum += w;
        if sum > tail {
            break;
        }
        high = Some(k - 1);
    }
    let at = |i: Option<usize>| i.map_or(f64::NAN, |i| sorted[i]);
    Interval { value, low: at(low), high: at(high) }
}

/// Probabilities of 0 to n successes, each with probability p; from the largest outwards, so that nothing underflows.
fn binomial(n: usize, p: f64) -> Vec<f64> {
    let mut w = vec![0.0; n + 1];
    let top = (((n + 1) as f64 * p).floor() as usize).min(n);
    w[top] = 1.0;
    let odds = p / (1.0 - p);
    for k in top..n {
        w[k + 1] = w[k] * odds * (n - k) as f64 / (k + 1) as f64;
    }
    for k in (0..top).rev() {
        w[k] = w[k + 1] * (k + 1) as f64 / (odds * (n - k) as f64);
    }
    let sum: f64 = w.iter().sum();
    w.iter_mut().for_each(|x| *x /= sum);
    w
}

/// The share `count` of `n` with its confidence interval (Wilson 1927).
pub fn share(count: usize, n: usize, confidence: f64) -> Interval {
    let z = normal_quantile(0.5 + 0.5 * confidence);
    let (all, p) = (n as f64, count as f64 / n as f64);
    let centre = (p + 0.5 * z * z / all) / (1.0 + z * z / all);
    let half = z / (1.0 + z * z / all) * (p * (1.0 - p) / all + 0.25 * z * z / (all * all)).sqrt();
    // none and all are bounds of their own, to the last digit
    let low = if count == 0 { 0.0 } else { centre - half };
    let high = if count == n { 1.0 } else { centre + half };
    Interval { value: p, low, high }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::Points;

    #[test]
    fn small_samples_bound_nothing() {
        let q = quantile(&[1.0, 2.0, 3.0], 0.5, 0.95);
        assert!(q.value == 2.0 && q.low.is_nan() && q.high.is_nan());
        // 59 values: the largest exceeds the quantile 0.95 with 1 - 0.95^59 = 95.15 % (Wilks 1941)
        let x: Vec<f64> = (0..59).map(f64::from).collect();
        assert_eq!(quantile(&x, 0.95, 0.90).high, 58.0);
        assert!(quantile(&x[..58], 0.95, 0.90).high.is_nan());
    }

    #[test]
    fn a_large_sample_does_not_underflow() {
        let x: Vec<f64> = (0..100_000).map(|i| f64::from(i) / 1e5).collect();
        let q = quantile(&x, 0.5, 0.95);
        // half width of the normal approximation: 1.96 sqrt(0.25 / n)
        assert!((q.high - q.low - 2.0 * 1.96 * 0.5 / 1e5f64.sqrt()).abs() < 3e-5, "{q:?}");
        let q = quantile(&x, 1e-3, 0.95);
        assert!(q.low > 0.0 && q.low < 1e-3 && q.high > 1e-3);
    }

    /// The interval holds the true quantile as often as it says, whatever the distribution.
    #[test]
    fn intervals_cover_as_often_as_they_say() {
        for p in [0.1, 0.5, 0.9] {
            let mut held = 0;
            for trial in 0..2000 {
                let mut x: Vec<f64> = (0..100).map(|i| -Points::Random.at(5, i, trial).ln()).collect();
                x.sort_by(f64::total_cmp);
                let (q, truth) = (quantile(&x, p, 0.95), -(1.0 - p).ln());
                held += usize::from(q.low <= truth && truth <= q.high);
            }
            // 95 % at least, up to the steps of the binomial; three standard errors of 2000 trials are 1.5 %
            assert!((1870..=1970).contains(&held), "{p}: {held}");
        }
    }

    #[test]
    fn shares() {
        let s = share(0, 100, 0.95);
        assert!(s.value == 0.0 && s.low == 0.0 && (s.high - 0.036995).abs() < 1e-5, "{s:?}");
        let s = share(50, 100, 0.95);
        assert!((s.low - 0.40383).abs() < 1e-5 && (s.high - 0.59617).abs() < 1e-5, "{s:?}");
    }
}
