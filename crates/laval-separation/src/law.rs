//! How sizes or densities are distributed in a suspension.
//!
//! Equations, u the share below:
//!
//! ```text
//! single          x
//! log-normal      x = median exp(ln(GSD) Phi^-1(u))
//! Rosin-Rammler   u = 1 - exp(-(x/x')^n)
//! table           cumulative shares, straight in ln x between the points; or classes, each with its share
//! ```
//!
//! Symbols: GSD geometric standard deviation; x' size with 63.2 % below; n spread. Shares are by mass when the powder's shares are.
//!
//! Sources: `docs/theory/separation.md#ensembles-and-recovery`; P. Rosin, E. Rammler, J. Inst. Fuel 7 (1933) 29.

use laval_model::text;
use laval_model::text::Text;
use laval_num::sampling::distribution::{normal_probability, normal_quantile};

/// A law of sizes or densities.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// One value.
    Single(f64),
    /// Median and geometric standard deviation.
    LogNormal {
        /// Median.
        median: f64,
        /// Geometric standard deviation, above 1.
        gsd: f64,
    },
    /// Rosin, Rammler, Sperling, Bennett (Weibull).
    RosinRammler {
        /// Value with 63.2 % below.
        characteristic: f64,
        /// Spread n.
        spread: f64,
    },
    /// Points (value, share below), both increasing, from share 0 to 1.
    Cumulative(Vec<(f64, f64)>),
    /// Classes (value, share), values increasing, shares adding up to 1.
    Classes(Vec<(f64, f64)>),
}

/// A law that cannot be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Impossible(pub Text);

impl Law {
    /// A table of values with shares below (from 0 or more, to 1).
    ///
    /// # Errors
    /// Columns of different lengths, values not positive and increasing, shares that fall or do not end at 1.
    pub fn cumulative(values: &[f64], below: &[f64]) -> Result<Law, Impossible> {
        let points = columns(values, below)?;
        if below.windows(2).any(|w| !(w[1] >= w[0])) || below.first().is_some_and(|b| !(*b >= 0.0)) {
            return Err(Impossible(text!("the shares below must rise from 0 to 1")));
        }
        if below.last().is_some_and(|b| (b - 1.0).abs() > 1e-9) {
            return Err(Impossible(text!("the last share below is {last}; it must be 1", last = below[below.len() - 1])));
        }
        Ok(Law::Cumulative(points))
    }

    /// A table of classes; the shares are scaled to add up to 1.
    ///
    /// # Errors
    /// Columns of different lengths, values not positive and increasing, negative shares or none.
    pub fn classes(values: &[f64], shares: &[f64]) -> Result<Law, Impossible> {
        let mut points = columns(values, shares)?;
        let sum: f64 = shares.iter().sum();
        if !shares.iter().all(|s| *s >= 0.0) || !(sum > 0.0) {
            return Err(Impossible(text!("the shares of the classes must not be negative, and not all zero")));
        }
        points.iter_mut().for_each(|p| p.1 /= sum);
        Ok(Law::Classes(points))
    }

    /// The value with a share `u` below.
    pub fn quantile(&self, u: f64) -> f64 {
        match self {
            Law::Single(x) => *x,
            Law::LogNormal { median, gsd } => median * (gsd.ln() * normal_quantile(u)).exp(),
            Law::RosinRammler { characteristic, spread } => characteristic * (-(-u).ln_1p()).powf(1.0 / spread),
            Law::Cumulative(points) => {
                let k = points.partition_point(|p| p.1 < u);
                let (Some(b), Some(a)) = (points.get(k), k.checked_sub(1).and_then(|i| points.get(i))) else {
                    return points[k.min(points.len() - 1)].0;
                };
                a.0 * (b.0 / a.0).powf((u - a.1) / (b.1 - a.1))
            }
            Law::Classes(points) => {
                let mut sum = 0.0;
                let found = points.iter().find(|p| {
                    sum += p.1;
                    u < sum
                });
                found.or(points.last()).map_or(f64::NAN, |p| p.0)
            }
        }
    }

    /// Share above `x`.
    pub fn above(&self, x: f64) -> f64 {
        match self {
            Law::Single(v) => f64::from(u8::from(*v > x)),
            Law::LogNormal { median, gsd } => normal_probability(-(x / median).ln() / gsd.ln()),
            Law::RosinRammler { characteristic, spread } => (-(x / characteristic).powf(*spread)).exp(),
            Law::Cumulative(points) => {
                let k = points.partition_point(|p| p.0 <= x);
                match (k.checked_sub(1).map(|i| points[i]), points.get(k)) {
                    (None, _) => 1.0,
                    (_, None) => 0.0,
                    (Some(a), Some(b)) => 1.0 - (a.1 + (b.1 - a.1) * (x / a.0).ln() / (b.0 / a.0).ln()),
                }
            }
            Law::Classes(points) => points.iter().filter(|p| p.0 > x).map(|p| p.1).sum(),
        }
    }

    /// Share above the value whose logarithm this is.
    pub fn above_ln(&self, ln_x: f64) -> f64 {
        match self {
            Law::LogNormal { median, gsd } => normal_probability((median.ln() - ln_x) / gsd.ln()),
            Law::RosinRammler { characteristic, spread } => (-(spread * (ln_x - characteristic.ln())).exp()).exp(),
            _ => self.above(ln_x.exp()),
        }
    }

    /// All particles have one value.
    pub fn is_single(&self) -> bool {
        matches!(self, Law::Single(_))
    }
}

fn columns(values: &[f64], shares: &[f64]) -> Result<Vec<(f64, f64)>, Impossible> {
    if values.len() != shares.len() || values.is_empty() {
        return Err(Impossible(text!("{values} values have {shares} shares", values = values.len(), shares = shares.len())));
    }
    if !values.iter().chain(shares).all(|x| x.is_finite()) || !(values[0] > 0.0) || values.windows(2).any(|w| !(w[1] > w[0])) {
        return Err(Impossible(text!("the values must be positive and increase from row to row")));
    }
    Ok(values.iter().copied().zip(shares.iter().copied()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws() -> Vec<Law> {
        vec![
            Law::LogNormal { median: 5e-6, gsd: 2.0 },
            Law::RosinRammler { characteristic: 12e-6, spread: 1.4 },
            Law::cumulative(&[1e-6, 3e-6, 10e-6, 40e-6], &[0.0, 0.2, 0.7, 1.0]).unwrap(),
        ]
    }

    #[test]
    fn quantile_and_share_above_are_inverse() {
        for law in laws() {
            for i in 1..100 {
                let u = i as f64 / 100.0;
                assert!((1.0 - law.above(law.quantile(u)) - u).abs() < 1e-13, "{law:?} {u}");
                assert!((1.0 - law.above_ln(law.quantile(u).ln()) - u).abs() < 1e-13, "{law:?} {u}");
            }
        }
    }

    #[test]
    fn classes_have_their_shares() {
        let law = Law::classes(&[1.0, 2.0, 5.0], &[1.0, 2.0, 1.0]).unwrap();
        assert_eq!((law.quantile(0.2), law.quantile(0.25), law.quantile(0.74), law.quantile(0.99)), (1.0, 2.0, 2.0, 5.0));
        assert_eq!((law.above(0.5), law.above(1.0), law.above(2.0), law.above(5.0)), (1.0, 0.75, 0.25, 0.0));
    }

    #[test]
    fn impossible_tables_are_refused() {
        assert!(Law::cumulative(&[1.0, 2.0], &[0.0, 0.9]).is_err());
        assert!(Law::cumulative(&[2.0, 1.0], &[0.0, 1.0]).is_err());
        assert!(Law::cumulative(&[1.0, 2.0, 3.0], &[0.0, 0.8, 0.7]).is_err());
        assert!(Law::classes(&[1.0, 2.0], &[0.0, 0.0]).is_err());
        assert!(Law::classes(&[1.0, f64::NAN], &[0.5, 0.5]).is_err());
        assert!(Law::classes(&[1.0], &[0.5, 0.5]).is_err());
    }
}
