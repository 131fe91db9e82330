//! Steps of the speed that throw a followed motion off its branch, in smaller steps: the motion goes on, or the place where it jumps is known closely.

use super::lyapunov::Exponent;
use super::{Fleet, Way};
use crate::store::Rows;
use crate::study::settled::Settled;
use crate::study::settled::period::Verdict;

/// Share of the larger amplitude that a jump changes, at least.
pub(super) const JUMP: f64 = 0.25;
/// Parts of a step, at most: so closely a jump is placed.
const PARTS: f64 = 64.0;
/// Motions that one step may cost.
const MOST: usize = 24;

/// What a followed motion brings along to the next speed.
#[derive(Clone)]
pub(super) struct Followed {
    /// State at phase zero.
    pub y: Vec<f64>,
    /// Largest value of every probe over its typical size.
    pub amplitude: Vec<f64>,
    /// It is known not to repeat. One that still changes slowly, as beside a fold, has an amplitude all the same.
    pub wanders: bool,
}

impl Followed {
    /// The motions are too different for neighbours of a branch, in what is more than this share of the loudest. What does not repeat has no amplitude to compare.
    fn jumps_to(&self, other: &Followed, share: f64) -> bool {
        let loudest = self.amplitude.iter().chain(&other.amplitude).copied().fold(0.0, f64::max);
        let apart = |(a, b): (&f64, &f64)| (a - b).abs() > JUMP * a.max(*b) && a.max(*b) > share * loudest;
        !self.wanders && !other.wanders && self.amplitude.iter().zip(&other.amplitude).any(apart)
    }
}

/// A settled motion with its exponent.
pub(super) type Found = (Settled, Option<Exponent>);

/// What a step comes to: the motion at its end, and the speeds between which it jumped.
pub(super) type Step = (Found, Option<(f64, f64)>);

impl Fleet<'_> {
    /// What a motion hands on; `None` of one that failed.
    pub(super) fn followed(&self, settled: &Settled) -> Option<Followed> {
        let m = settled.measure.as_ref()?;
        let wanders = settled.verdict == Verdict::NotPeriodic;
        let amplitude = m.bodies.iter().zip(&self.probes).map(|(b, p)| b.peak / p.typical()).collect();
        Some(Followed { y: settled.y.clone(), amplitude, wanders })
    }

    /// A step of a followed motion from the speed `from` to `to`, where taken at once it leads to `found`; `None` when stopped.
    pub(super) fn step(&self, way: Way, (from, before): (f64, Option<&Followed>), to: f64, found: Found, counter: &Rows) -> Option<Step> {
        let share = self.unresolved();
        let jumps = |a: &Followed, b: &Found| self.followed(&b.0).is_some_and(|b| a.jumps_to(&b, share));
        let Some(before) = before.filter(|b| way != Way::Rest && jumps(b, &found)) else { return Some((found, None)) };
        let quiet = counter.aside();
        let at = |from: &Followed, speed: f64| self.settle(&[self.member_at(speed, Some(&from.y))], &quiet)?.pop();
        // a motion on the branch, and one that the step from there leads to beyond a jump
        let (mut on, mut beyond) = ((from, before.clone()), (to, found.clone()));
        let narrow = (to - from).abs() / PARTS;
        let mut count = 0;
        while (beyond.0 - on.0).abs() > narrow * (1.0 + 1e-9) && count < MOST {
            let middle = 0.5 * (on.0 + beyond.0);
            let half = at(&on.1, middle)?;
            count += 1;
            let Some(next) = self.followed(&half.0) else { return Some((found, None)) };
            if on.1.jumps_to(&next, share) {
                beyond = (middle, half);
                continue;
            }
            on = (middle, next);
            // from here the rest of the step again, and what is beyond it
            for end in [beyond.0, to] {
                let whole = at(&on.1, end)?;
                count += 1;
                let Some(next) = self.followed(&whole.0) else { return Some((found, None)) };
                if on.1.jumps_to(&next, share) {
                    beyond = (end, whole);
                    break;
                }
                if end == to {
                    return Some((whole, None));
                }
                on = (end, next);
            }
        }
        let place = (on.0, beyond.0);
        if beyond.0 == to {
            return Some((beyond.1, Some(place)));
        }
        let landed = self.followed(&beyond.1.0)?;
        Some((at(&landed, to)?, Some(place)))
    }
}
