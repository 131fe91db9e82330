//! Followed motions at several speeds together: in the lanes and on all processors, with the states that follow them one by one would give.
//!
//! A followed motion begins in the state in which that of the speed before ended, so one seems to wait for the other. But it is enough to know which motion that is. At the next
//! speeds motions begin together in the last known state, which leads most of them to the branch; then each begins anew where that of the speed before arrived. These are the
//! motions of the sweep as long as that one was reached from its own neighbour, too: from the first that was not on, the search begins again, with fewer speeds.

use super::refine::{Followed, SteadyPoint};
use super::rows::Row;
use super::{Members, Way};
use crate::store::Rows;
use crate::study::motion::steady_state::{Budget, Member};
use std::ops::Range;

/// Speeds looked at together: as many whatever the number of processors, so that the result does not depend on it.
const TOGETHER: usize = 16;
/// Distance of two states over their size, and over the tolerance of settling, at which they belong to one motion.
const SAME: f64 = 100.0;

impl Members<'_> {
    /// Rows of the steps of one way; `carried` is the state that the motion brings along, and that it hands on. None when stopped.
    pub(super) fn follow(&self, way: Way, steps: Range<usize>, carried: &mut Option<Followed>, counter: &Rows) -> Option<Vec<Row>> {
        let quiet = counter.aside();
        let mut out: Vec<Row> = Vec::with_capacity(steps.len());
        let mut next = steps.start;
        // an exponent takes longer than the motion
        let most = if self.study.lyapunov.is_some() { 1 } else { TOGETHER };
        let mut count = most;
        while next < steps.end {
            count = count.min(steps.end - next);
            let speeds: Vec<f64> = (next..next + count).map(|step| self.speed(way, step)).collect();
            let leaps: Vec<Member> = speeds.iter().map(|&w| self.member_at(w, carried.as_ref().map(|c| &c.y))).collect();
            // a leap that is no motion of the sweep is not among its steps
            let own = Budget::new(u64::MAX);
            let first = self.settle_within(&leaps, &quiet, if count == 1 { &self.budget } else { &own })?;
            let hops: Vec<Member> = speeds[1..]
                .iter()
                .zip(&first)
                .map(|(&w, before)| self.member_at(w, self.followed(&before.0).as_ref().map(|f| &f.y)))
                .collect();
            let second = if hops.is_empty() { Vec::new() } else { self.settle(&hops, &quiet)? };
            let ends: Vec<Vec<f64>> = first.iter().map(|f| f.0.y.clone()).collect();
            let found: Vec<SteadyPoint> = first.into_iter().take(1).chain(second).collect();
            let mut known = 0;
            for ((member, leap), found) in leaps.iter().zip(&ends).zip(found) {
                let from = self.speed(way, (next + known).saturating_sub(1));
                let (found, jump) = self.step(way, (from, carried.as_ref()), member.speed, found, counter)?;
                let same = jump.is_none() && self.same(leap, &found.0.y);
                *carried = self.followed(&found.0);
                let (steady_state, exponent) = found;
                out.push(Row { way, speed: member.speed, rate: member.rate, steady_state, exponent, jump });
                counter.add(1);
                known += 1;
                if !same {
                    break;
                }
            }
            next += known;
            count = if known == count { (2 * count).min(most) } else { known };
        }
        Some(out)
    }

    /// Two states at phase zero belong to one motion.
    fn same(&self, a: &[f64], b: &[f64]) -> bool {
        let n = self.system.n();
        let near = |range: Range<usize>| {
            let (Some(a), Some(b)) = (a.get(range.clone()), b.get(range)) else { return false };
            let size = b.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let apart = a.iter().zip(b).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            // what is no number is not near
            apart <= SAME * self.study.rules.tolerance * size
        };
        a.iter().chain(b).all(|x| x.is_finite()) && near(0..n) && near(n..2 * n)
    }
}
