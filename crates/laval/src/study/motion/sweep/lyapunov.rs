//! Largest Lyapunov exponent: two motions of the same member a small distance apart, brought back to that distance after every forcing period.
//!
//! ```text
//! lambda = sum_j w_j ln(d_j / d_0) / (T sum_j w_j),   w_j = exp(-1/(s (1 - s))),  s = (j + 1/2)/N
//! ```
//!
//! The smooth weights make the mean of a quasi-periodic growth converge faster than any power of the time (Das et al., Nonlinearity 30 (2017)
//! 4111; exponents: Benettin et al., Meccanica 15 (1980) 9). Distances are the root of the sum of squares over the sizes of the states. Before the N periods counted, N/4
//! turn the difference into the direction that grows fastest.

use super::super::steady_state::{Budget, sizes};
use crate::model::system::System;
use crate::solve::ensemble::{self, Ended, EnsembleTask, Leg, LegEnd, Next, Start};
use crate::solve::motion::SpinLaw;
use crate::solve::programme::Programme;
use crate::store::Rows;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Distance over the size of the motion, which counts as 1 mm at least.
const APART: f64 = 1e-7;
/// Tolerance of the integration: the difference of two motions loses the digits of the distance.
const TOLERANCE: f64 = 1e-13;

/// Exponent, 1/s, and the difference between the two halves of its time.
pub(super) type Exponent = (f64, f64);

/// Members: speed and settled state; none where there is no motion.
pub(super) struct Pairs<'a> {
    pub system: Arc<System>,
    pub members: Vec<Option<(f64, Vec<f64>)>>,
    pub periods: usize,
    pub counter: &'a Rows<'a>,
    pub budget: &'a Budget,
}

pub(super) struct Log {
    period: f64,
    size: Vec<f64>,
    /// Start of the period; its end, when that is known.
    from: Vec<f64>,
    own: Option<Vec<f64>>,
    difference: Vec<f64>,
    lead: usize,
    growth: Vec<f64>,
}

impl Log {
    fn leg(&self) -> Leg {
        // the same first step, so that the errors of both motions are nearly the same
        Leg { first_step: Some(self.period / 64.0), ..Leg::new(0.0, self.period) }
    }

    fn beside(&self, y: &mut [f64]) {
        for (((y, from), d), s) in y.iter_mut().zip(&self.from).zip(&self.difference).zip(&self.size) {
            *y = from + d * s;
        }
    }
}

/// Makes the difference as long as it shall be; its length before.
fn shorten(difference: &mut [f64]) -> f64 {
    let length = difference.iter().map(|d| d * d).sum::<f64>().sqrt();
    difference.iter_mut().for_each(|d| *d *= APART / length);
    length
}

impl EnsembleTask for Pairs<'_> {
    type Log = Log;
    type Row = Option<Exponent>;

    fn start(&self, index: usize) -> Result<Start<Log>, Self::Row> {
        let (speed, y) = self.members[index].clone().ok_or(None)?;
        let mut size = sizes(&self.system, speed);
        let large = y.iter().zip(&size).map(|(y, s)| y.abs() / s).fold(1.0, f64::max);
        size.iter_mut().for_each(|s| *s *= large);
        let mut difference: Vec<f64> = (0..size.len()).map(|i| 1.0 / (1.0 + i as f64)).collect();
        shorten(&mut difference);
        let log = Log { period: TAU / speed, size, from: y.clone(), own: None, difference, lead: self.periods / 4, growth: vec![] };
        Ok(Start {
            system: self.system.clone(),
            law: SpinLaw::Programme(Programme::constant(speed, 0.0)),
            y,
            relative: TOLERANCE,
            absolute: ensemble::tolerances(&self.system, speed, TOLERANCE),
            leg: self.budget.leg(log.leg()),
            log,
        })
    }

    fn ended(&self, _: usize, log: &mut Log, ended: &Ended, y: &mut [f64]) -> Next<Self::Row> {
        self.budget.spend(ended);
        if ended.end != LegEnd::Reached {
            return Next::Done(None);
        }
        let Some(own) = log.own.take() else {
            log.own = Some(y.to_vec());
            log.beside(y);
            return Next::Leg(self.budget.leg(log.leg()));
        };
        for (((d, y), own), s) in log.difference.iter_mut().zip(y.iter()).zip(&own).zip(&log.size) {
            *d = (y - own) / s;
        }
        let grown = (shorten(&mut log.difference) / APART).ln();
        if !grown.is_finite() {
            return Next::Done(None);
        }
        if log.lead > 0 {
            log.lead -= 1;
        } else {
            log.growth.push(grown);
        }
        if log.growth.len() == self.periods {
            return Next::Done(Some(exponent(&log.growth, log.period)));
        }
        y.copy_from_slice(&own);
        log.from = own;
        Next::Leg(self.budget.leg(log.leg()))
    }

    fn cancelled(&self) -> bool {
        self.counter.cancelled() || self.budget.used_up()
    }
}

fn exponent(growth: &[f64], period: f64) -> Exponent {
    let (first, second) = growth.split_at(growth.len() / 2);
    (weighted(growth) / period, (weighted(first) - weighted(second)).abs() / period)
}

/// Mean with smooth weights.
fn weighted(x: &[f64]) -> f64 {
    let weight = |j: usize| {
        let s = (j as f64 + 0.5) / x.len() as f64;
        (-1.0 / (s * (1.0 - s))).exp()
    };
    let (sum, all) = x.iter().enumerate().fold((0.0, 0.0), |(sum, all), (j, x)| (sum + weight(j) * x, all + weight(j)));
    sum / all
}
