//! Where a machine is unstable while its speed follows a programme, and how much that lets a motion grow.
//!
//! The growth rate g of the machine linearised at rest is taken at many times; a motion grows by at most about `exp(int g dt)` while g is above 0.

use super::passages::BEAT;
use crate::model::system::System;
use crate::solve::pencil::modes_about;
use crate::solve::programme::Spin;
use crate::solve::rest::rest;
use serde::{Deserialize, Serialize};

/// Growth rates along a programme.
pub(in crate::study) struct Rates {
    at: Vec<Rate>,
    /// Speeds of the spins over that of the machine.
    ratios: Vec<f64>,
}

/// Growth at one time.
#[derive(Clone, Debug)]
pub(in crate::study) struct Rate {
    /// Time, s.
    t: f64,
    /// Speed, rad/s.
    speed: f64,
    /// Largest growth rate, 1/s.
    growth: f64,
    /// The speed of the machine or of another of its spins is within [`NEAR`] of a natural frequency.
    near: bool,
    /// Natural frequencies below the speed of each spin.
    below: Vec<usize>,
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

/// Change of the speed over it, from one time to the next, that resolves an unstable range beside a natural frequency; most times added for that.
const FINE: f64 = 2e-3;
const MOST_ADDED: usize = 64;

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
            if stop() { None } else { Rate::at(system, t, speed(t)) }
        };
        Some(Rates { at: (0..count).map(at).collect::<Option<_>>()?, ratios: ratios(system) })
    }

    /// Adds times between these two near natural frequencies, where an unstable range may be narrower than the steps of the speed.
    pub fn resolve(&mut self, from: f64, to: f64, rate: &dyn Fn(f64) -> Option<Rate>) {
        for _ in 0..MOST_ADDED {
            let step = |k: &usize| (self.at[*k].speed - self.at[k - 1].speed).abs();
            let coarse = |k: &usize| {
                let (a, b) = (&self.at[k - 1], &self.at[*k]);
                (a.near || b.near) && b.t >= from && a.t <= to && step(k) > FINE * a.speed.abs().max(b.speed.abs())
            };
            let Some(k) = (1..self.at.len()).filter(coarse).max_by(|a, b| step(a).total_cmp(&step(b))) else { return };
            let Some(between) = rate(0.5 * (self.at[k - 1].t + self.at[k].t)) else { return };
            self.at.insert(k, between);
        }
    }

    /// Time that one of them stands for: to the middles between it and its neighbours.
    fn width(&self, k: usize) -> f64 {
        let step = |k: usize| self.at[k].t - self.at[k - 1].t;
        match (k, k + 1 < self.at.len()) {
            (0, false) => 0.0,
            (0, true) => step(1),
            (_, false) => step(k),
            _ => 0.5 * (step(k) + step(k + 1)),
        }
    }

    /// The range between two times through which a motion grows most.
    pub fn most(&self, from: f64, to: f64) -> Option<Range> {
        let inside: Vec<_> = self.at.iter().enumerate().filter(|(_, x)| x.t >= from && x.t <= to).collect();
        let ranges = inside.chunk_by(|a, b| (a.1.growth > 0.0) == (b.1.growth > 0.0)).filter(|c| c[0].1.growth > 0.0);
        let range = |c: &[(usize, &Rate)]| Range {
            speeds: [c[0].1.speed, c[c.len() - 1].1.speed],
            factor: c.iter().map(|(k, x)| x.growth * self.width(*k)).sum::<f64>().exp(),
            rate: c.iter().map(|(_, x)| x.growth).fold(0.0, f64::max),
        };
        ranges.map(range).max_by(|a, b| a.factor.total_cmp(&b.factor))
    }

    /// Between two times the spin speed meets a natural frequency.
    pub fn meets(&self, from: f64, to: f64) -> bool {
        self.at.iter().any(|x| x.near && x.t >= from && x.t <= to)
    }

    /// Steps in which the speed of a spin passes a natural frequency: the number of that spin and of the later end. A frequency that vanishes, of a mode damped
    /// above the critical damping, is not passed.
    fn crossings(&self) -> impl Iterator<Item = (usize, usize)> {
        let pairs = self.at.windows(2).enumerate().filter(|(_, w)| w[0].near || w[1].near);
        pairs.flat_map(|(k, w)| {
            let changed = w[0].below.iter().zip(&w[1].below).enumerate().filter(|(_, (a, b))| a != b);
            changed.map(move |(spin, _)| (spin, k + 1))
        })
    }

    /// Number of natural frequencies that the spin speed has passed up to a time; one that is passed within the step of that time counts.
    pub fn crossed(&self, t: f64) -> usize {
        self.crossings().filter(|&(_, k)| self.at[k - 1].t <= t).count()
    }

    /// The time is within a beat after the spin speed passes a natural frequency: the faster the passage, the later its peak. Where the frequency is passed at a
    /// constant acceleration without damping, the peak is at an angle of 2.3 rad of the forced motion against the free one.
    pub fn lags(&self, t: f64, spin: &dyn Fn(f64) -> Spin) -> bool {
        self.crossings().any(|(own, k)| {
            let since = 0.5 * (self.at[k - 1].t + self.at[k].t);
            let at = spin(since);
            let angle = self.ratios[own] * (spin(t).phase - at.phase - at.speed * (t - since));
            since <= t && angle.abs() <= BEAT
        })
    }

    /// What is left of a free motion after a time, at most: that of the least stable mode.
    pub fn left(&self, from: f64, to: f64) -> f64 {
        let step = |w: &[Rate]| 0.5 * (w[0].growth + w[1].growth) * (w[1].t.min(to) - w[0].t.max(from)).max(0.0);
        self.at.windows(2).map(step).sum::<f64>().exp()
    }
}

/// The speed of the machine, then those of its other spins, over that of the machine.
fn ratios(system: &System) -> Vec<f64> {
    std::iter::once(1.0).chain(system.spins().iter().map(|s| s.ratio)).collect()
}

impl Rate {
    /// At one speed; `None` where the machine has no rest to be linearised at.
    pub fn at(system: &System, t: f64, speed: f64) -> Option<Rate> {
        let spectrum = modes_about(system, &rest(system, speed).ok()?, false).ok()?;
        let spins: Vec<f64> = ratios(system).into_iter().map(|r| (r * speed).abs()).collect();
        let below = spins.iter().map(|w| spectrum.modes.iter().filter(|m| m.frequency() > 0.0 && m.frequency() < *w).count()).collect();
        let near = spectrum.modes.iter().any(|m| m.frequency() > 0.0 && spins.iter().any(|w| (m.frequency() - w).abs() <= NEAR * w));
        Some(Rate { t, speed, growth: spectrum.least_stable()?.growth(), near, below })
    }
}

#[cfg(test)]
impl Rates {
    /// A natural frequency of 50 rad/s passed at 1 rad/s^2 from rest on, up to 100 rad/s.
    pub fn of_one_passage(growth: f64) -> (Rates, impl Fn(f64) -> Spin) {
        let rate = |t: f64| Rate { t, speed: t, growth, near: (t - 50.0).abs() <= NEAR * t, below: vec![usize::from(t > 50.0)] };
        let rates = Rates { at: (0..1000).map(|k| rate(0.1 * (f64::from(k) + 0.5))).collect(), ratios: vec![1.0] };
        (rates, |t: f64| Spin { phase: 0.5 * t * t, speed: t, accel: 1.0 })
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
                .map(|t| Rate { t, speed: t, growth: g(t), near: (5.0..5.1).contains(&t), below: Vec::new() })
                .collect(),
            ratios: vec![1.0],
        };
        assert!(rates.meets(4.0, 6.0) && !rates.meets(5.2, 9.0) && !rates.meets(0.0, 4.9));
        let seen = rates.most(0.0, 10.0).unwrap();
        assert!((seen.factor.ln() - 6.0).abs() < 1e-9 && seen.rate == 3.0, "{seen:?}");
        assert!((seen.speeds[0] - 2.0).abs() < 0.011 && (seen.speeds[1] - 4.0).abs() < 0.011, "{seen:?}");
        assert!((rates.most(5.0, 10.0).unwrap().factor.ln() - 1.0).abs() < 1e-9);
        assert_eq!(rates.most(8.0, 10.0), None);
    }

    /// g = 20 1/s from 100.1 rad/s to 100.3 rad/s, beside a natural frequency of 100 rad/s; the speed is the time.
    #[test]
    fn a_narrow_range_beside_a_natural_frequency_is_found() {
        let rate = |t: f64| {
            let growth = if (100.1..100.3).contains(&t) { 20.0 } else { -1.0 };
            Some(Rate { t, speed: t, growth, near: (t - 100.0).abs() <= NEAR * t, below: Vec::new() })
        };
        let mut rates = Rates { at: (0..40).filter_map(|k| rate(5.0 * (f64::from(k) + 0.5))).collect(), ratios: vec![1.0] };
        assert!(rates.meets(90.0, 110.0) && rates.most(90.0, 110.0).is_none());
        rates.resolve(90.0, 110.0, &rate);
        assert!(rates.at.windows(2).all(|w| w[0].t < w[1].t));
        // the steps are a fifth of a rad/s at most
        let seen = rates.most(90.0, 110.0).unwrap();
        assert!(seen.rate == 20.0 && (1.0..6.5).contains(&seen.factor.ln()), "{seen:?}");
        // nothing is added far from natural frequencies
        let count = rates.at.len();
        rates.resolve(120.0, 180.0, &rate);
        assert_eq!(rates.at.len(), count);
    }

    /// A natural frequency of 50 rad/s passed at 1 rad/s^2, and the growth rate -0.5 1/s.
    #[test]
    fn a_peak_lags_behind_the_natural_frequency_by_an_angle() {
        let (rates, spin) = Rates::of_one_passage(-0.5);
        assert_eq!([49.0, 50.2, 90.0].map(|t| rates.crossed(t)), [0, 1, 1]);
        // (t - 50)^2 / 2 is the angle
        assert_eq!([49.0, 50.5, 52.15, 53.0, 57.0].map(|t| rates.lags(t, &spin)), [false, true, true, false, false]);
        assert!((rates.left(20.0, 24.0) / (-2.0f64).exp() - 1.0).abs() < 1e-9);
    }
}
