//! What a recovery takes: time and speed, and how both depend on speed, size, density and viscosity.

use super::Separation;
use super::compute::Ensemble;
use super::result::{Demand, SpeedNeeded};
use crate::separation::batch::{Batch, FELT, Spinning};
use crate::separation::law::Law;
use crate::separation::suspension::Model;
use crate::study::centrifuge::cups::task::needed;
use laval_num::univariate::maximum;

/// Highest speed shown over that of the study.
pub(super) const HIGHEST_SHOWN: f64 = 4.0;

/// Another speed can be requested: no particle after the other must be integrated with its inertia.
pub(super) fn searched(study: &Separation, spinning: &Spinning) -> bool {
    study.speed != 0.0 && affordable(study, spinning, HIGHEST_SHOWN * study.speed)
}

fn affordable(study: &Separation, spinning: &Spinning, speed: f64) -> bool {
    if !spinning.integrated() {
        return true;
    }
    match study.task.batch.model {
        Model::Drifting => true,
        Model::Inertial => false,
        Model::Adaptive => 0.5 * study.task.suspension.medium.rates(&study.median()).two_n >= FELT * speed.abs(),
    }
}

/// A law with all values times a factor.
fn scaled(law: &Law, by: f64) -> Law {
    let all = |points: &[(f64, f64)]| points.iter().map(|p| (by * p.0, p.1)).collect();
    match law {
        Law::Single(x) => Law::Single(by * x),
        Law::LogNormal { median, gsd } => Law::LogNormal { median: by * median, gsd: *gsd },
        Law::RosinRammler { characteristic, spread } => Law::RosinRammler { characteristic: by * characteristic, spread: *spread },
        Law::Cumulative(points) => Law::Cumulative(all(points)),
        Law::Classes(points) => Law::Classes(all(points)),
    }
}

/// A law of densities whose distance from the liquid's is multiplied.
fn moved(law: &Law, liquid: f64, by: f64) -> Law {
    let to = |x: f64| liquid + by * (x - liquid);
    match law {
        Law::Single(x) => Law::Single(to(*x)),
        Law::Cumulative(points) => Law::Cumulative(points.iter().map(|p| (to(p.0), p.1)).collect()),
        Law::Classes(points) => Law::Classes(points.iter().map(|p| (to(p.0), p.1)).collect()),
        Law::LogNormal { .. } | Law::RosinRammler { .. } => {
            const POINTS: usize = 1000;
            let share = |k: usize| (k as f64 / POINTS as f64).clamp(1e-9, 1.0 - 1e-9);
            Law::Cumulative((0..=POINTS).map(|k| (to(law.quantile(share(k))), k as f64 / POINTS as f64)).collect())
        }
    }
}

impl Ensemble<'_> {
    /// Times at a row of speeds, and how the time depends on each parameter; none where no other speed can be requested.
    pub fn demand(&self) -> Option<Demand> {
        searched(self.study, self.spinning).then(|| {
            let speed = self.speed_needed();
            let highest = HIGHEST_SHOWN;
            let speeds: Vec<f64> = (0..=32).map(|k| self.study.speed.abs() * highest.powf(-1.0 + 2.0 * k as f64 / 32.0)).collect();
            let times = speeds.iter().map(|&w| self.time_at(w)).collect();
            Demand { speed, speeds, times, exponents: self.exponents() }
        })
    }

    /// Time a batch takes at a speed, s; NaN where a path cannot be computed.
    fn time_of(&self, batch: &Batch, speed: f64) -> f64 {
        // a search goes on over numbers that are not there, but each must cost nothing
        if !(self.goes_on)() {
            return f64::NAN;
        }
        needed(batch, speed, self.study.task.recovery, self.watch).unwrap_or(f64::NAN)
    }

    /// Time the recovery takes at another speed, s; NaN where a path cannot be computed.
    fn time_at(&self, speed: f64) -> f64 {
        self.time_of(&self.study.task.batch, speed)
    }

    /// The lowest speed that catches the recovery in the time at hand, and the width of its bracket: scanned from below, then narrowed. Otherwise the highest
    /// speed looked at.
    fn speed_needed(&self) -> SpeedNeeded {
        let s = self.study;
        let spare = |w: f64| {
            let t = self.time_at(w);
            if t > 0.0 { (s.task.time / t).ln() } else { f64::NEG_INFINITY }
        };
        if spare(0.0) >= 0.0 {
            return SpeedNeeded::Found { speed: 0.0, bracket: 0.0 };
        }
        let (mut earlier, mut before) = ((0.0, f64::NEG_INFINITY), (0.0, f64::NEG_INFINITY));
        for k in 0..40 {
            // from a hundredth to a hundred times the speed
            let w = s.speed.abs() * 10f64.powf(-2.0 + 4.0 * k as f64 / 39.0);
            if !affordable(s, self.spinning, w) {
                break;
            }
            let m = spare(w);
            // between the speeds scanned it may suffice for a while
            let hill = before.1 > earlier.1 && before.1 > m && earlier.1.is_finite();
            let top = if hill { maximum(|x| Some(spare(x)), earlier.0, w, 1e-9 * w).filter(|t| t.1 >= 0.0) } else { None };
            if m >= 0.0 || top.is_some() {
                let (mut low, mut high) = match top {
                    Some(top) => (if top.0 > before.0 { before } else { earlier }, top),
                    None => (before, (w, m)),
                };
                for k in 0..60 {
                    if high.0 - low.0 < 1e-9 * high.0 {
                        break;
                    }
                    // the time falls like the square of the speed: secant in its logarithm, and the middle every third time
                    let middle = k % 3 == 2 || !low.1.is_finite();
                    let share = if middle { 0.5 } else { (low.1 / (low.1 - high.1)).clamp(1e-6, 1.0 - 1e-6) };
                    let x = if low.0 == 0.0 { 0.5 * high.0 } else { low.0 * (high.0 / low.0).powf(share) };
                    let m = spare(x);
                    if m >= 0.0 { high = (x, m) } else { low = (x, m) }
                }
                return SpeedNeeded::Found { speed: high.0, bracket: high.0 - low.0 };
            }
            (earlier, before) = (before, (w, m));
        }
        SpeedNeeded::None { highest: before.0 }
    }

    /// d ln t_q/d ln p by central differences.
    fn exponents(&self) -> [f64; 4] {
        let (w, s) = (self.study.speed, &self.study.task);
        let h: f64 = 0.01;
        let slope = |time: &dyn Fn(f64) -> f64| {
            let d = (time(1.0 + h) / time(1.0 - h)).ln() / ((1.0 + h) / (1.0 - h)).ln();
            if d.is_finite() { d } else { f64::NAN }
        };
        let with = |change: &dyn Fn(&mut Batch)| {
            let mut batch = s.batch.clone();
            change(&mut batch);
            self.time_of(&batch, w)
        };
        [
            slope(&|by| self.time_at(w * by)),
            slope(&|by| with(&|b| b.powder.size = scaled(&b.powder.size, by))),
            slope(&|by| with(&|b| b.powder.density = moved(&b.powder.density, b.medium.density, by))),
            slope(&|by| with(&|b| b.medium.viscosity *= by)),
        ]
    }
}
