//! Steps of the speed that throw a followed motion off its branch, in smaller steps: the motion goes on, or the place where it jumps is known closely.

use super::lyapunov::Exponent;
use super::{Members, Way};
use crate::model::probe::Probe;
use crate::store::Rows;
use crate::study::motion::steady_state::SteadyState;
use crate::study::motion::steady_state::measure::BodyMeasure;
use crate::study::motion::steady_state::period::Verdict;

/// Share of the larger amplitude about its mean that a jump changes, at least: a sag makes no motion large.
pub(super) const JUMP: f64 = 0.25;
/// Parts of a step, at most: so closely a jump is placed.
const PARTS: f64 = 64.0;
/// Batches of motions that one step may cost: beside a fold the steps that stay on a branch become short as the fold comes near.
const MOST: usize = 48;

/// Amplitude about the mean of a motion that goes as far as `peak` from the origin.
pub(super) fn about_mean(peak: f64, mean: f64) -> f64 {
    if mean.is_finite() { (peak - mean).max(0.0) } else { peak }
}

/// What a followed motion brings along to the next speed.
#[derive(Clone)]
pub(super) struct Followed {
    /// State at phase zero.
    pub y: Vec<f64>,
    /// Largest value of every probe over its typical size.
    pub amplitude: Vec<f64>,
    /// The same without the mean displacement, where that is known.
    pub about_mean: Vec<f64>,
    /// It is known not to repeat. One that still changes slowly, as beside a fold, has an amplitude all the same.
    pub wanders: bool,
    /// It repeats. What falls off a branch does not, and may change little from one short step to the next.
    pub repeats: bool,
}

impl Followed {
    /// The motions are too different for neighbours of a branch, in what is more than this share of the loudest. What does not repeat has no amplitude to compare.
    fn jumps_to(&self, other: &Followed, share: f64) -> bool {
        let loudest = self.amplitude.iter().chain(&other.amplitude).copied().fold(0.0, f64::max);
        let apart = |k: usize| {
            let (a, b) = (self.amplitude[k], other.amplitude[k]);
            let size = self.about_mean[k].max(other.about_mean[k]);
            (a - b).abs() > JUMP * size && a.max(b) > share * loudest
        };
        !self.wanders && !other.wanders && (0..self.amplitude.len().min(other.amplitude.len())).any(apart)
    }

    /// The other is no neighbour of it on a branch.
    fn leads_off(&self, other: &Followed, share: f64) -> bool {
        self.jumps_to(other, share) || self.repeats && !other.repeats
    }
}

/// A settled motion with its exponent.
pub(super) type SteadyPoint = (SteadyState, Option<Exponent>);

/// What a step comes to: the motion at its end, and the speeds between which it jumped.
pub(super) type Step = (SteadyPoint, Option<(f64, f64)>);

impl Members<'_> {
    /// What a motion hands on; `None` of one that failed.
    pub(super) fn followed(&self, steady_state: &SteadyState) -> Option<Followed> {
        let m = steady_state.measure.as_ref()?;
        let wanders = steady_state.verdict == Verdict::NotPeriodic;
        let all = || m.bodies.iter().zip(&self.probes);
        let amplitude = all().map(|(b, p)| b.peak / p.typical()).collect();
        let mean = |b: &BodyMeasure, p: &Probe| if p.is_reference() { b.orders[0] } else { 0.0 };
        let about_mean = all().map(|(b, p)| about_mean(b.peak, mean(b, p)) / p.typical()).collect();
        let repeats = matches!(steady_state.verdict, Verdict::Period(_));
        Some(Followed { y: steady_state.y.clone(), amplitude, about_mean, wanders, repeats })
    }

    /// A step of a followed motion from the speed `from` to `to`, where taken at once it leads to `found`; `None` when stopped.
    pub(super) fn step(
        &self,
        way: Way,
        (from, before): (f64, Option<&Followed>),
        to: f64,
        found: SteadyPoint,
        counter: &Rows,
    ) -> Option<Step> {
        let share = self.study.unresolved();
        let jumps = |a: &Followed, b: &SteadyPoint| self.followed(&b.0).is_some_and(|b| a.jumps_to(&b, share));
        // a linear machine has one motion at every speed: nothing to jump to
        let single = way == Way::Rest || self.system.slots().iter().all(|s| s.is_linear());
        let Some(before) = before.filter(|b| !single && jumps(b, &found)) else { return Some((found, None)) };
        let quiet = counter.aside();
        let narrow = (to - from).abs() / PARTS * (1.0 + 1e-9);
        let mut on = (from, before.clone());
        for _ in 0..MOST {
            // in one batch: the rest of the step, its half, and so on to a part that places a jump
            let parts = std::iter::successors(Some(to - on.0), |p| (p.abs() > narrow).then_some(0.5 * p));
            let ends: Vec<f64> = parts.map(|p| if p == to - on.0 { to } else { on.0 + p }).collect();
            let members: Vec<_> = ends.iter().map(|&speed| self.member_at(speed, Some(&on.1.y))).collect();
            let all = self.settle(&members, &quiet)?;
            let there: Option<Vec<Followed>> = all.iter().map(|f| self.followed(&f.0)).collect();
            let Some(there) = there else { return Some((found, None)) };
            match there.iter().position(|f| !on.1.leads_off(f, share)) {
                Some(0) => return Some((all.into_iter().next()?, None)),
                Some(k) => on = (ends[k], there[k].clone()),
                None => {
                    let (Some(&end), Some(landed), Some(beyond)) = (ends.last(), there.last(), all.into_iter().next_back()) else {
                        return None;
                    };
                    let last = if end == to { beyond } else { self.settle(&[self.member_at(to, Some(&landed.y))], &quiet)?.pop()? };
                    return Some((last, Some((on.0, end))));
                }
            }
        }
        // steps as short as a place still lead off where shorter ones go on: the rest of the step is the place
        let last = self.settle(&[self.member_at(to, Some(&on.1.y))], &quiet)?.pop()?;
        Some((last, Some((on.0, to))))
    }
}
