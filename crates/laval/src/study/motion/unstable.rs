//! Where a machine is unstable while its speed follows a programme, and how much that lets a motion grow.
//!
//! The growth rate g of the machine linearised at rest is taken at many times; a motion grows by at most about `exp(int g dt)` while g is above 0.

use crate::model::system::System;
use crate::solve::pencil::modes_about;
use crate::solve::rest::rest;
use serde::{Deserialize, Serialize};

/// Growth rates along a programme.
pub(in crate::study) struct Rates {
    at: Vec<Rate>,
}

struct Rate {
    /// Time, s.
    t: f64,
    /// Speed, rad/s.
    speed: f64,
    /// Largest growth rate, 1/s.
    growth: f64,
    /// The speed is within [`NEAR`] of a natural frequency.
    near: bool,
}

/// Distance of the speed from a natural frequency, over it, within which it is in resonance.
const NEAR: f64 = 0.05;

/// A range of speeds in which the machine is unstable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// Speeds at its ends in the order of time, rad/s.
    pub speeds: [f64; 2],
    /// Growth of a motion through it.
    pub factor: f64,
    /// Largest growth rate in it, 1/s.
    pub rate: f64,
}

/// Most times at which the growth rate is taken, the fewest that resolve a range, and the work it may take: times by the cube of the number of states.
const MOST: usize = 400;
const FEWEST: usize = 40;
const WORK: f64 = 1e8;

impl Rates {
    /// From the start to `t_end`; `None` where the machine has no rest to be linearised at, is too large for that at many speeds, or when stopped.
    pub fn along(system: &System, t_end: f64, speed: &dyn Fn(f64) -> f64, stop: &dyn Fn() -> bool) -> Option<Rates> {
        let states = (2 * system.n() + system.m()).max(1) as f64;
        let count = ((WORK / states.powi(3)) as usize).min(MOST);
        if count < FEWEST {
            return None;
        }
        let at = |k: usize| {
            let t = t_end * (k as f64 + 0.5) / count as f64;
            let w = speed(t);
            if stop() {
                return None;
            }
            let spectrum = modes_about(system, &rest(system, w).ok()?, false).ok()?;
            let near = spectrum.modes.iter().any(|m| m.frequency() > 0.0 && (m.frequency() - w.abs()).abs() <= NEAR * w.abs());
            Some(Rate { t, speed: w, growth: spectrum.least_stable()?.growth(), near })
        };
        Some(Rates { at: (0..count).map(at).collect::<Option<_>>()? })
    }

    /// The range between two times through which a motion grows most.
    pub fn most(&self, from: f64, to: f64) -> Option<Range> {
        let inside: Vec<_> = self.at.iter().filter(|x| x.t >= from && x.t <= to).collect();
        let width = self.at.get(1).zip(self.at.first()).map_or(0.0, |(b, a)| b.t - a.t);
        let ranges = inside.chunk_by(|a, b| (a.growth > 0.0) == (b.growth > 0.0)).filter(|c| c[0].growth > 0.0);
        let range = |c: &[&Rate]| Range {
            speeds: [c[0].speed, c[c.len() - 1].speed],
            factor: (c.iter().map(|x| x.growth).sum::<f64>() * width).exp(),
            rate: c.iter().map(|x| x.growth).fold(0.0, f64::max),
        };
        ranges.map(range).max_by(|a, b| a.factor.total_cmp(&b.factor))
    }

    /// Between two times the spin speed meets a natural frequency.
    pub fn meets(&self, from: f64, to: f64) -> bool {
        self.at.iter().any(|x| x.near && x.t >= from && x.t <= to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_that_of_the_range_that_counts() {
        // g = 3 from 2 s to 4 s, 1 from 6 s to 7 s; the speed is the time
        let g = |t: f64| {
            if (2.0..4.0).contains(&t) {
                3.0
            } else if (6.0..7.0).contains(&t) {
                1.0
            } else {
                -1.0
            }
        };
        let rates = Rates {
            at: (0..1000)
                .map(|k| 0.01 * (k as f64 + 0.5))
                .map(|t| Rate { t, speed: t, growth: g(t), near: (5.0..5.1).contains(&t) })
                .collect(),
        };
        assert!(rates.meets(4.0, 6.0) && !rates.meets(5.2, 9.0) && !rates.meets(0.0, 4.9));
        let seen = rates.most(0.0, 10.0).unwrap();
        assert!((seen.factor.ln() - 6.0).abs() < 1e-9 && seen.rate == 3.0, "{seen:?}");
        assert!((seen.speeds[0] - 2.0).abs() < 0.011 && (seen.speeds[1] - 4.0).abs() < 0.011, "{seen:?}");
        assert!((rates.most(5.0, 10.0).unwrap().factor.ln() - 1.0).abs() < 1e-9);
        assert_eq!(rates.most(8.0, 10.0), None);
    }
}
