//! What is read off a recorded motion: amplitudes, orders, Poincare points, spectrum.

use super::{SAMPLES, SteadyStateSearch};
use laval_num::complex::{C64, c};
use laval_num::fourier::{hann, order_coefficient, unit_root};

/// Whole orders kept: 0 to 3.
pub const ORDERS: usize = 4;
/// Poincare points kept of a motion.
pub const POINTS: usize = 32;
/// Lines of a spectrum per order, and its highest order.
pub const LINES: usize = 16;
pub const HIGHEST: usize = 4;
/// Local maxima this much below the highest sample are refined too.
const NEARLY: f64 = 0.98;

/// The motion of one probe about its value at rest: of a displacement, or of a tilt with rad for m.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyMeasure {
    /// Largest displacement, m.
    pub peak: f64,
    /// Root of the mean squared displacement, m.
    pub rms: f64,
    /// Semi-major axes of the ellipses of orders 0 to 3, m; of order 0 the mean displacement.
    pub orders: [f64; ORDERS],
    /// That of order 1/k of a motion that repeats after k > 1 periods; NaN otherwise.
    pub sub: f64,
}

/// See the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// By probe, the reference points of the bodies first.
    pub bodies: Vec<BodyMeasure>,
    /// Both components of every probe at the last whole periods, oldest first.
    pub points: Vec<Vec<f64>>,
    /// Radii of the circular parts of one body at the orders -4, -4 + 1/16 .. 4, m; negative orders turn backward.
    pub spectrum: Vec<f64>,
    /// Statement of validity used most, and its use over the last periods; above 1 is outside. `None` when no part states one.
    pub validity: Option<(String, f64)>,
}

impl Measure {
    /// From samples of both components of every probe, over the last `periods` periods.
    pub(super) fn of(settling: &SteadyStateSearch, periods: usize, samples: &[f64], validity: Option<(String, f64)>) -> Self {
        let width = 2 * settling.probes.len();
        let motion = |b: usize| samples.chunks_exact(width).map(|s| c(s[2 * b], s[2 * b + 1])).collect::<Vec<C64>>();
        let bodies = (0..settling.probes.len()).map(|b| body(&motion(b), periods, settling.rules.periods)).collect();
        let sections: Vec<Vec<f64>> = samples.chunks_exact(width).step_by(SAMPLES).map(<[f64]>::to_vec).collect();
        let points = sections[sections.len().saturating_sub(POINTS)..].to_vec();
        let wanted = settling.rules.spectrum.and_then(|k| settling.probes.iter().position(|p| p.is_reference() && p.station == k));
        Measure { bodies, points, spectrum: wanted.map_or_else(Vec::new, |b| spectrum(&motion(b))), validity }
    }
}

fn body(z: &[C64], periods: usize, recorded: usize) -> BodyMeasure {
    // the last sample is the first of the next period
    let end = z.len().saturating_sub(1);
    let from = end.saturating_sub(periods * SAMPLES);
    let own = &z[from..end];
    let count = u32::try_from(periods).unwrap_or(1);
    let axis = |order: i32| {
        let coefficient = |o: i32| order_coefficient(own, count, o).abs();
        if order == 0 { coefficient(0) } else { coefficient(order) + coefficient(-order) }
    };
    let sub =
        if periods > 1 && periods < recorded { order_coefficient(own, 1, 1).abs() + order_coefficient(own, 1, -1).abs() } else { f64::NAN };
    let squares: f64 = own.iter().map(|z| z.norm_sqr()).sum();
    BodyMeasure {
        peak: peak(z, from),
        rms: (squares / own.len().max(1) as f64).sqrt(),
        orders: std::array::from_fn(|h| axis(h as i32)),
        sub,
    }
}

/// Largest distance from the origin at or after sample `from`, on polynomials of degree 4 through the samples.
fn peak(z: &[C64], from: usize) -> f64 {
    let z = &z[from.saturating_sub(2)..];
    let top = z.iter().map(|z| z.abs()).fold(0.0f64, |m, x| if m.is_nan() || x <= m { m } else { x });
    let near = z.windows(5).filter(|w| {
        let r = w[2].abs();
        r >= w[1].abs() && r >= w[3].abs() && r >= NEARLY * top
    });
    near.map(farthest).fold(top, |m, x| if m.is_nan() || x <= m { m } else { x })
}

/// Largest distance from the origin near the middle of the polynomial through five equidistant points.
fn farthest(f: &[C64]) -> f64 {
    // central differences
    let (d1, d3) = ((f[3] - f[1]).scale(0.5), (f[4] - f[0] - (f[3] - f[1]).scale(2.0)).scale(0.5));
    let (d2, d4) = (f[3] + f[1] - f[2].scale(2.0), f[4] + f[0] - (f[3] + f[1]).scale(4.0) + f[2].scale(6.0));
    let (a, b, c, d) = (d1 - d3.scale(1.0 / 6.0), d2.scale(0.5) - d4.scale(1.0 / 24.0), d3.scale(1.0 / 6.0), d4.scale(1.0 / 24.0));
    let value = |x: f64| f[2] + (a + (b + (c + d.scale(x)).scale(x)).scale(x)).scale(x);
    let mut x = 0.0;
    for _ in 0..8 {
        let p = value(x);
        let slope = a + (b.scale(2.0) + (c.scale(3.0) + d.scale(4.0 * x)).scale(x)).scale(x);
        let bend = b.scale(2.0) + (c.scale(6.0) + d.scale(12.0 * x)).scale(x);
        let (up, curved) = ((slope * p.conj()).re, slope.norm_sqr() + (bend * p.conj()).re);
        if !(curved < 0.0) {
            break;
        }
        x = (x - up / curved).clamp(-1.0, 1.0);
    }
    value(x).abs().max(f[2].abs())
}

/// Radii of the circular parts at the signed orders j/16 up to the highest: root mean square over stretches of 16 periods, Hann window.
fn spectrum(z: &[C64]) -> Vec<f64> {
    let n = LINES * SAMPLES;
    let window = hann(n);
    let root: Vec<C64> = (0..n).map(|k| unit_root(k as i64, n as u64).conj()).collect();
    let stretches: Vec<&[C64]> = z.chunks_exact(n).collect();
    let line = |j: i64| {
        let squares = stretches.iter().map(|s| {
            let mut sum = C64::zero();
            for (i, (z, w)) in s.iter().zip(&window).enumerate() {
                sum += z.scale(*w) * root[(i as i64 * j).rem_euclid(n as i64) as usize];
            }
            // the mean of the window is a half
            (2.0 / n as f64 * sum.abs()).powi(2)
        });
        (squares.sum::<f64>() / stretches.len().max(1) as f64).sqrt()
    };
    let reach = (LINES * HIGHEST) as i64;
    (-reach..=reach).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn ellipse(periods: usize, shift: f64) -> Vec<C64> {
        let at = |i: usize| {
            let p = TAU * i as f64 / SAMPLES as f64 + shift;
            C64::cis(p).scale(3.0) + C64::cis(-p).scale(1.0) + C64::cis(3.0 * p).scale(0.2) + C64::cis(p / 2.0).scale(0.5) + c(0.1, 0.0)
        };
        (0..=periods * SAMPLES).map(at).collect()
    }

    #[test]
    fn orders_of_a_known_motion() {
        let m = body(&ellipse(48, 0.3), 2, 48);
        for (found, known) in m.orders.iter().zip([0.1, 4.0, 0.0, 0.2]) {
            assert!((found - known).abs() < 1e-12, "{found} {known}");
        }
        assert!((m.sub - 0.5).abs() < 1e-12);
        let power: f64 = 9.0 + 1.0 + 0.04 + 0.25 + 0.01;
        assert!((m.rms - power.sqrt()).abs() < 1e-12);
    }

    /// Wherever the samples lie, the peak is that of the curve.
    #[test]
    fn peaks_lie_between_samples() {
        for k in 0..20 {
            let shift = f64::from(k) * 0.01;
            let z: Vec<C64> = (0..=SAMPLES * 2)
                .map(|i| {
                    let p = TAU * i as f64 / SAMPLES as f64 + shift;
                    c(2.0 * p.cos(), p.sin())
                })
                .collect();
            let found = peak(&z, SAMPLES);
            assert!((found - 2.0).abs() < 2e-8, "{k} {found}");
        }
    }

    #[test]
    fn lines_of_a_spectrum() {
        let s = spectrum(&ellipse(48, 0.0));
        assert_eq!(s.len(), 2 * LINES * HIGHEST + 1);
        // forward and backward parts of the ellipse stand apart
        for (order, height) in [(1.0, 3.0), (-1.0, 1.0), (3.0, 0.2), (-3.0, 0.0), (0.5, 0.5), (-0.5, 0.0), (2.0, 0.0), (0.0, 0.1)] {
            let found = s[((order + HIGHEST as f64) * LINES as f64) as usize];
            assert!((found - height).abs() < 1e-9, "{order} {found}");
        }
    }
}
