//! Distributions by their quantile functions.

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

/// Quantile of the standard normal distribution, relative error about 1e-16 (Wichura 1988, algorithm AS 241, PPND16).
// the digits of the publication
#[allow(clippy::excessive_precision)]
pub fn normal_quantile(p: f64) -> f64 {
    const A: [f64; 8] = [
        3.3871328727963666080,
        1.3314166789178437745e2,
        1.9715909503065514427e3,
        1.3731693765509461125e4,
        4.5921953931549871457e4,
        6.7265770927008700853e4,
        3.3430575583588128105e4,
        2.5090809287301226727e3,
    ];
    const B: [f64; 8] = [
        1.0,
        4.2313330701600911252e1,
        6.8718700749205790830e2,
        5.3941960214247511077e3,
        2.1213794301586595867e4,
        3.9307895800092710610e4,
        2.8729085735721942674e4,
        5.2264952788528545610e3,
    ];
    const C: [f64; 8] = [
        1.42343711074968357734,
        4.63033784615654529590,
        5.76949722146069140550,
        3.64784832476320460504,
        1.27045825245236838258,
        2.41780725177450611770e-1,
        2.27238449892691845833e-2,
        7.74545014278341407640e-4,
    ];
    const D: [f64; 8] = [
        1.0,
        2.05319162663775882187,
        1.67638483018380384940,
        6.89767334985100004550e-1,
        1.48103976427480074590e-1,
        1.51986665636164571966e-2,
        5.47593808499534494600e-4,
        1.05075007164441684324e-9,
    ];
    const E: [f64; 8] = [
        6.65790464350110377720,
        5.46378491116411436990,
        1.78482653991729133580,
        2.96560571828504891230e-1,
        2.65321895265761230930e-2,
        1.24266094738807843860e-3,
        2.71155556874348757815e-5,
        2.01033439929228813265e-7,
    ];
    const F: [f64; 8] = [
        1.0,
        5.99832206555887937690e-1,
        1.36929880922735805310e-1,
        1.48753612908506148525e-2,
        7.86869131145613259100e-4,
        1.84631831751005468180e-5,
        1.42151175831644588870e-7,
        2.04426310338993978564e-15,
    ];
    let ratio = |top: &[f64; 8], bottom: &[f64; 8], r: f64| {
        let horner = |c: &[f64; 8]| c.iter().rev().fold(0.0, |s, &x| s * r + x);
        horner(top) / horner(bottom)
    };
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        return q * ratio(&A, &B, 0.180625 - q * q);
    }
    let r = (-if q < 0.0 { p } else { 1.0 - p }.ln()).sqrt();
    let x = if r <= 5.0 { ratio(&C, &D, r - 1.6) } else { ratio(&E, &F, r - 5.0) };
    if q < 0.0 { -x } else { x }
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

    /// Integrals of the quantile function over the probability are the moments.
    #[test]
    fn means_and_deviations_are_those_asked_for() {
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
