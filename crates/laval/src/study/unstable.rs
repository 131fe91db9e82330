//! Where a machine is unstable while its speed follows a programme, and how much that lets a motion grow.
//!
//! The growth rate g of the machine linearised at rest is taken at many times; a motion grows by at most about `exp(int g dt)` while g is above 0.

use crate::model::system::System;
use crate::solve::pencil::modes_about;
use crate::solve::rest::rest;

/// Growth rates along a programme.
pub(super) struct Rates {
    /// Time, s; speed, rad/s; largest growth rate, 1/s.
    at: Vec<(f64, f64, f64)>,
}

/// A range of speeds in which the machine is unstable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
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
            Some((t, w, spectrum.least_stable()?.growth()))
        };
        Some(Rates { at: (0..count).map(at).collect::<Option<_>>()? })
    }

    /// The range between two times through which a motion grows most.
    pub fn most(&self, from: f64, to: f64) -> Option<Range> {
        let inside: Vec<_> = self.at.iter().filter(|x| x.0 >= from && x.0 <= to).collect();
        let width = self.at.get(1).zip(self.at.first()).map_or(0.0, |(b, a)| b.0 - a.0);
        let ranges = inside.chunk_by(|a, b| (a.2 > 0.0) == (b.2 > 0.0)).filter(|c| c[0].2 > 0.0);
        let range = |c: &[&(f64, f64, f64)]| Range {
            speeds: [c[0].1, c[c.len() - 1].1],
            factor: (c.iter().map(|x| x.2).sum::<f64>() * width).exp(),
            rate: c.iter().map(|x| x.2).fold(0.0, f64::max),
        };
        ranges.map(range).max_by(|a, b| a.factor.total_cmp(&b.factor))
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
        let rates = Rates { at: (0..1000).map(|k| 0.01 * (k as f64 + 0.5)).map(|t| (t, t, g(t))).collect() };
        let seen = rates.most(0.0, 10.0).unwrap();
        assert!((seen.factor.ln() - 6.0).abs() < 1e-9 && seen.rate == 3.0, "{seen:?}");
        assert!((seen.speeds[0] - 2.0).abs() < 0.011 && (seen.speeds[1] - 4.0).abs() < 0.011, "{seen:?}");
        assert!((rates.most(5.0, 10.0).unwrap().factor.ln() - 1.0).abs() < 1e-9);
        assert_eq!(rates.most(8.0, 10.0), None);
    }
}
