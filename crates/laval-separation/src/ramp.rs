//! The spin speed while a centrifuge starts or stops, with its exact rate.
//!
//! Equations: linear `w = w_f u`, smooth `w = w_f (10 u^3 - 15 u^4 + 6 u^5)` with `u = t/T`, or a table joined by the monotone cubic of
//! [`laval_num::interpolate`]; held after the last time.
//!
//! Sources: `docs/theory/separation.md#run-up`.

use laval_num::interpolate::{Interpolant, TableError};

/// A law of the spin speed from t = 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Ramp {
    /// Always this speed, rad/s.
    Constant(f64),
    /// From rest to a speed (rad/s) in a time (s) at constant acceleration.
    Linear(f64, f64),
    /// From rest to a speed (rad/s) in a time (s), with acceleration and its rate zero at both ends.
    Smooth(f64, f64),
    /// Through a table of times and speeds.
    Table(Table),
}

/// Speeds at given times.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    curve: Interpolant,
    times: Vec<f64>,
    last: f64,
    /// All speeds are multiplied by this.
    scale: f64,
}

impl Ramp {
    /// Through points (s, rad/s).
    ///
    /// # Errors
    /// Times that do not increase, columns of different lengths, numbers that are not finite.
    pub fn table(times: &[f64], speeds: &[f64]) -> Result<Self, TableError> {
        let curve = Interpolant::new(times, speeds)?;
        Ok(Ramp::Table(Table { curve, times: times.to_vec(), last: speeds.last().copied().unwrap_or(0.0), scale: 1.0 }))
    }

    /// The law with all its speeds in proportion, so that it ends at this speed (rad/s).
    pub fn ending_at(&self, speed: f64) -> Self {
        match self {
            Ramp::Constant(_) => Ramp::Constant(speed),
            Ramp::Linear(_, d) => Ramp::Linear(speed, *d),
            Ramp::Smooth(_, d) => Ramp::Smooth(speed, *d),
            Ramp::Table(t) => Ramp::Table(Table { scale: if speed == t.last { 1.0 } else { speed / t.last }, ..t.clone() }),
        }
    }

    /// Speed and its rate at a time.
    pub fn at(&self, t: f64) -> (f64, f64) {
        match self {
            Ramp::Constant(w) => (*w, 0.0),
            Ramp::Linear(w, d) if t < *d => (w * t / d, w / d),
            Ramp::Smooth(w, d) if t < *d => {
                let u = t / d;
                (w * u * u * u * (10.0 + u * (6.0 * u - 15.0)), w * 30.0 * u * u * (1.0 - u) * (1.0 - u) / d)
            }
            Ramp::Linear(w, _) | Ramp::Smooth(w, _) => (*w, 0.0),
            Ramp::Table(table) => {
                let (w, slope) = table.curve.value_and_slope(t);
                (table.scale * w, table.scale * slope)
            }
        }
    }

    /// Speed that is held in the end, rad/s.
    pub fn final_speed(&self) -> f64 {
        match self {
            Ramp::Constant(w) | Ramp::Linear(w, _) | Ramp::Smooth(w, _) => *w,
            Ramp::Table(t) => t.scale * t.last,
        }
    }

    /// Time after which the speed is held, s.
    pub fn duration(&self) -> f64 {
        match self {
            Ramp::Constant(_) => 0.0,
            Ramp::Linear(_, d) | Ramp::Smooth(_, d) => *d,
            Ramp::Table(t) => t.times.last().copied().unwrap_or(0.0),
        }
    }

    /// Times at which the law changes.
    pub fn knots(&self) -> impl Iterator<Item = f64> + '_ {
        let inner: &[f64] = match self {
            Ramp::Table(t) => &t.times,
            _ => &[],
        };
        let end = matches!(self, Ramp::Linear(..) | Ramp::Smooth(..)).then(|| self.duration());
        inner.iter().copied().chain(end)
    }

    /// Time at full speed that separates as much as the ramp does: `int w^2 dt / w_f^2`, s (exact for motion along the radius without gravity).
    pub fn equivalent(&self) -> f64 {
        match self {
            Ramp::Constant(_) => 0.0,
            Ramp::Linear(_, d) => d / 3.0,
            Ramp::Smooth(_, d) => 181.0 / 462.0 * d,
            Ramp::Table(t) => {
                // w^2 is of degree 6 between knots: Gauss with four points is exact
                let nodes = [(0.339981043584856, 0.652145154862546), (0.861136311594053, 0.347854845137454)];
                let mut sum = 0.0;
                for w in t.times.windows(2) {
                    let (middle, half) = (0.5 * (w[0] + w[1]), 0.5 * (w[1] - w[0]));
                    for (x, weight) in nodes {
                        for sign in [-1.0, 1.0] {
                            let speed = self.at(middle + sign * x * half).0;
                            sum += half * weight * speed * speed;
                        }
                    }
                }
                sum / self.final_speed().powi(2)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_derivatives_and_squares_integrate() {
        let table = Ramp::table(&[0.0, 2.0, 5.0, 9.0], &[0.0, 40.0, 90.0, 100.0]).unwrap();
        for r in [Ramp::Linear(100.0, 9.0), Ramp::Smooth(100.0, 9.0), table] {
            for t in [0.7, 3.1, 8.2] {
                let h = 1e-4;
                let d = (r.at(t + h).0 - r.at(t - h).0) / (2.0 * h);
                assert!((d - r.at(t).1).abs() < 1e-5, "{r:?}");
            }
            let n = 90_000;
            let sum: f64 = (0..n).map(|i| r.at((i as f64 + 0.5) * 9.0 / n as f64).0.powi(2)).sum::<f64>() * 9.0 / n as f64;
            assert!((r.equivalent() - sum / 1e4).abs() < 1e-7, "{r:?}");
            assert_eq!(r.at(20.0), (100.0, 0.0));
            // all speeds in proportion: the same time at full speed
            let faster = r.ending_at(250.0);
            assert!((faster.at(3.1).0 / r.at(3.1).0 - 2.5).abs() < 1e-14 && (faster.at(3.1).1 / r.at(3.1).1 - 2.5).abs() < 1e-14);
            assert!((faster.equivalent() / r.equivalent() - 1.0).abs() < 1e-14);
        }
    }
}
