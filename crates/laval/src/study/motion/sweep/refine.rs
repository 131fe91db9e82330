//! Steps of the speed that throw a followed motion off its branch, in smaller steps: the motion goes on, or the place where it jumps is known closely.

use super::lyapunov::Exponent;
use super::{Fleet, Way};
use crate::store::Rows;
use crate::study::motion::settled::Settled;
use crate::study::motion::settled::period::Verdict;

/// Share of the larger amplitude that a jump changes, at least.
pub(super) const JUMP: f64 = 0.25;
/// Parts of a step, at most: so closely a jump is placed.
const PARTS: f64 = 64.0;
/// Motions that one step may cost: beside a fold the steps that stay on a branch become short as the fold comes near.
const MOST: usize = 96;

/// What a followed motion brings along to the next speed.
#[derive(Clone)]
pub(super) struct Followed {
    /// State at phase zero.
    pub y: Vec<f64>,
    /// Largest value of every probe over its typical size.
    pub amplitude: Vec<f64>,
    /// It is known not to repeat. One that still changes slowly, as beside a fold, has an amplitude all the same.
    pub wanders: bool,
    /// It repeats. What falls off a branch does not, and may change little from one short step to the next.
    pub repeats: bool,
}

impl Followed {
    /// The motions are too different for neighbours of a branch, in what is more than this share of the loudest. What does not repeat has no amplitude to compare.
    fn jumps_to(&self, other: &Followed, share: f64) -> bool {
        let loudest = self.amplitude.iter().chain(&other.amplitude).copied().fold(0.0, f64::max);
        let apart = |(a, b): (&f64, &f64)| (a - b).abs() > JUMP * a.max(*b) && a.max(*b) > share * loudest;
        !self.wanders && !other.wanders && self.amplitude.iter().zip(&other.amplitude).any(apart)
    }

    /// The other is no neighbour of it on a branch.
    fn leads_off(&self, other: &Followed, share: f64) -> bool {
        self.jumps_to(other, share) || self.repeats && !other.repeats
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
        let repeats = matches!(settled.verdict, Verdict::Period(_));
        Some(Followed { y: settled.y.clone(), amplitude, wanders, repeats })
    }

    /// A step of a followed motion from the speed `from` to `to`, where taken at once it leads to `found`; `None` when stopped.
    pub(super) fn step(&self, way: Way, (from, before): (f64, Option<&Followed>), to: f64, found: Found, counter: &Rows) -> Option<Step> {
        let share = self.unresolved();
        let jumps = |a: &Followed, b: &Found| self.followed(&b.0).is_some_and(|b| a.jumps_to(&b, share));
        let Some(before) = before.filter(|b| way != Way::Rest && jumps(b, &found)) else { return Some((found, None)) };
        let quiet = counter.aside();
        let at = |from: &Followed, speed: f64| self.settle(&[self.member_at(speed, Some(&from.y))], &quiet)?.pop();
        let narrow = (to - from).abs() / PARTS * (1.0 + 1e-9);
        // a motion on the branch, the step from there that leads off it, and where that leads
        let (mut on, mut part, mut beyond) = ((from, before.clone()), to - from, (to, found.clone()));
        let mut count = 0;
        while part.abs() > narrow {
            if count >= MOST {
                // steps as short as this still lead off, where shorter ones go on: the rest of the step is the place
                let last = at(&on.1, to)?;
                return Some((last, Some((on.0, to))));
            }
            part *= 0.5;
            loop {
                let end = if (to - on.0).abs() <= part.abs() { to } else { on.0 + part };
                let next = at(&on.1, end)?;
                count += 1;
                let Some(there) = self.followed(&next.0) else { return Some((found, None)) };
                if on.1.leads_off(&there, share) {
                    (part, beyond) = (end - on.0, (end, next));
                    break;
                }
                if end == to {
                    return Some((next, None));
                }
                (on, part) = ((end, there), 2.0 * part);
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
