//! Distributions by their quantile functions.

use libm::erfc;
use statrs::function::erf::erfc_inv;
use std::f64::consts::{PI, SQRT_2};

/// Distribution of one uncertain number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Mean and standard deviation.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Equally probable between two ends.
    Uniform {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// The logarithm is normal; given by the mean and the standard deviation of the number itself.
    LogNormal {
        /// Mean, positive.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Density that rises linearly to its peak and falls linearly to its end.
    Triangular {
        /// Lower end.
        from: f64,
        /// Place of the peak.
        mode: f64,
        /// Upper end.
        to: f64,
    },
}

impl Distribution {
    /// The value below which a share `p` (between 0 and 1) lies.
    ///
    /// ```
    /// use laval_num::sampling::distribution::Distribution;
    /// let x = Distribution::Normal { mean: 10.0, deviation: 2.0 }.quantile(0.975);
    /// assert!((x - 13.919927969080108).abs() < 1e-13);
    /// ```
    pub fn quantile(&self, p: f64) -> f64 {
        match *self {
            Distribution::Normal { mean, deviation } => mean + deviation * normal_quantile(p),
            Distribution::Uniform { from, to } => from + (to - from) * p,
            Distribution::LogNormal { mean, deviation } => {
                // mean = exp(m + s^2/2), variance = (exp(s^2) - 1) mean^2
                let variance = (deviation / mean).powi(2).ln_1p();
                mean * (variance.sqrt() * normal_quantile(p) - 0.5 * variance).exp()
            }
            Distribution::Triangular { from, mode, to } => {
                let below = (mode - from) / (to - from);
                if p <= below {
                    from + (p * (to - from) * (mode - from)).sqrt()
                } else {
                    to - ((1.0 - p) * (to - from) * (to - mode)).sqrt()
                }
            }
        }
    }
}

/// Probability below `x` of the standard normal distribution.
pub fn normal_probability(x: f64) -> f64 {
    0.5 * erfc(-x / SQRT_2)
}

/// The `x` below which a share `p` of the standard normal distribution lies; infinite at 0 and 1, NaN outside.
pub fn normal_quantile(p: f64) -> f64 {
    if !(0.0..=1.0).contains(&p) {
        return f64::NAN;
    }
    // the smaller tail keeps its digits
    let tail = p.min(1.0 - p);
    let x = SQRT_2 * erfc_inv(2.0 * tail);
    // one Newton step: the library has some 11 digits
    let density = (-0.5 * x * x).exp() / (2.0 * PI).sqrt();
    let x = if density > 0.0 { x + (normal_probability(-x) - tail) / density } else { x };
    if p < 0.5 { -x } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_normal_quantiles() {
        for (p, x) in [
            (0.975, 1.959963984540054),
            (0.5, 0.0),
            (0.3, -0.5244005127080407),
            (1e-10, -6.361340902404056),
            (1e-20, -9.262340089798405),
            (1e-5, -4.264890793922825),
        ] {
            let e: f64 = normal_quantile(p) - x;
            assert!(e.abs() <= 4e-15 * x.abs(), "{p}: {e}");
        }
    }

    #[test]
    fn tabulated_normal_probabilities() {
        for (x, p) in [
            (0.0, 0.5),
            (1.0, 0.841344746068543),
            (-1.959963984540054, 0.025),
            (-3.0, 0.0013498980316301),
            (-5.0, 2.866515718791939e-7),
            (-8.0, 6.22096057427178e-16),
        ] {
            let e: f64 = normal_probability(x) / p - 1.0;
            assert!(e.abs() < 2e-13, "{x} {e}");
        }
    }

    #[test]
    fn the_normal_quantile_inverts_the_probability() {
        for i in 1..2000 {
            let p = i as f64 / 2000.0;
            let e = normal_probability(normal_quantile(p)) - p;
            assert!(e.abs() < 4e-16, "{p} {e}");
        }
        for p in [1e-300, 1e-20, 1e-8] {
            let e = normal_probability(normal_quantile(p)) / p - 1.0;
            assert!(e.abs() < 1e-11, "{p} {e}");
        }
        assert_eq!((normal_quantile(0.0), normal_quantile(1.0)), (f64::NEG_INFINITY, f64::INFINITY));
        assert!(normal_quantile(1.2).is_nan() && normal_quantile(f64::NAN).is_nan());
    }

    /// Integrals of the quantile function over the probability are the moments.
    #[test]
    fn means_and_deviations_are_those_requested_for() {
        let moments = |d: Distribution| {
            // tanh-sinh over (0, 1), so that the infinite ends do not matter
            let (mut m1, mut m2, mut w0) = (0.0, 0.0, 0.0);
            for k in -400..=400 {
                let t = f64::from(k) * 0.01;
                let u = std::f64::consts::FRAC_PI_2 * t.sinh();
                let p = 1.0 / (1.0 + (-2.0 * u).exp());
                let w = 0.01 * 0.5 * std::f64::consts::FRAC_PI_2 * t.cosh() / u.cosh().powi(2);
                if p > 0.0 && p < 1.0 && w > 0.0 {
                    let x = d.quantile(p);
                    m1 += w * x;
                    m2 += w * x * x;
                    w0 += w;
                }
            }
            assert!((w0 - 1.0).abs() < 1e-12);
            (m1, (m2 - m1 * m1).sqrt())
        };
        let s = 24f64.sqrt();
        for (d, mean, deviation) in [
            (Distribution::Normal { mean: 3.0, deviation: 0.5 }, 3.0, 0.5),
            (Distribution::LogNormal { mean: 3.0, deviation: 0.9 }, 3.0, 0.9),
            (Distribution::Uniform { from: 1.0, to: 4.0 }, 2.5, 3.0 / 12f64.sqrt()),
            (Distribution::Triangular { from: -2.0, mode: 0.0, to: 2.0 }, 0.0, 4.0 / s),
            (Distribution::Triangular { from: 0.0, mode: 0.0, to: 3.0 }, 1.0, 3.0 / 18f64.sqrt()),
        ] {
            let (m, s) = moments(d);
            assert!((m - mean).abs() < 1e-9 && (s - deviation).abs() < 1e-6, "{d:?}: {m} {s}");
        }
    }
}
