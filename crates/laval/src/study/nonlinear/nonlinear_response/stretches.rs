//! Stretches of a branch from fold to fold: each holds one state at a speed, and is stable or not by itself.

use super::shown::branch;
use crate::outcome::{Arg, Message};
use crate::solve::harmonic::branches::response::{Fold, State, Traced};
use crate::study::shared::support::{place, runs};
use std::ops::Range;

/// A frequency this small, relative to the spin, is none.
const REAL: f64 = 1e-6;

/// Points of a branch between two folds, or between a fold and an end.
pub(super) struct Stretch<'b> {
    branch: &'b Traced,
    /// Its points.
    pub(super) points: Range<usize>,
    folds: [Option<&'b Fold>; 2],
}

/// The stretches of a branch, in order along it.
pub(super) fn stretches(branch: &Traced) -> Vec<Stretch<'_>> {
    let count = branch.points.len();
    let mut folds: Vec<&Fold> = branch.folds.iter().filter(|f| f.after + 1 < count).collect();
    folds.sort_by_key(|f| f.after);
    let edges: Vec<usize> = [0].into_iter().chain(folds.iter().map(|f| f.after + 1)).chain([count]).collect();
    let piece =
        |k: usize| Stretch { branch, points: edges[k]..edges[k + 1], folds: [k.checked_sub(1).map(|k| folds[k]), folds.get(k).copied()] };
    (0..edges.len() - 1).map(piece).filter(|s| !s.points.is_empty()).collect()
}

/// The stretch that holds a point.
pub(super) fn stretch_of(branch: &Traced, point: usize) -> Option<Stretch<'_>> {
    stretches(branch).into_iter().find(|s| s.points.contains(&point))
}

impl Stretch<'_> {
    /// Which part of which branch, as a phrase behind "the branch".
    pub(super) fn phrase(&self) -> Message {
        let of = |word| Message::new("nonlinear-response-stretch").arg("place", Arg::word(word)).arg("branch", branch(self.branch.origin));
        let at = |f: &Fold| Arg::speed(f.speed);
        match self.folds {
            [None, None] => of("whole"),
            [None, Some(f)] => of("before").arg("to", at(f)),
            [Some(f), None] => of("beyond").arg("from", at(f)),
            [Some(a), Some(b)] => of("between").arg("from", at(a)).arg("to", at(b)),
        }
    }

    /// Between two stretches that can be stable: an odd number of disturbances grows without oscillation, as beyond any fold. No machine is there, which the
    /// jumps say.
    fn saddle(&self) -> bool {
        let odd = |p: &State| {
            let real = |e: &crate::solve::harmonic::stability::floquet::Exponents| {
                e.values.iter().filter(|z| z.re > e.error && z.im.abs() <= REAL * p.speed.abs()).count()
            };
            p.exponents.as_ref().is_some_and(|e| real(e) % 2 == 1)
        };
        let points = &self.branch.points[self.points.clone()];
        self.folds.iter().any(Option::is_some) && 2 * points.iter().filter(|p| odd(p)).count() > points.len()
    }

    /// Consecutive unstable points, with those between them that were not assessed. Beside a fold one point is so by rounding.
    fn unstable(&self) -> Vec<Range<usize>> {
        if self.saddle() {
            return Vec::new();
        }
        let (from, count) = (self.points.start, self.points.len());
        let points = &self.branch.points[self.points.clone()];
        let found = runs(points.iter().map(State::unstable));
        let at_fold =
            |a: usize, b: usize| a == b && (a == 0 && self.folds[0].is_some() || a + 1 == count && self.folds[1].is_some()) && count > 1;
        let mut out: Vec<Range<usize>> = Vec::new();
        for (a, b) in found.into_iter().filter(|&(a, b)| !at_fold(a, b)) {
            match out.last_mut().filter(|last| points[last.end..a].iter().all(|p| p.exponents.is_none())) {
                Some(last) => last.end = b + 1,
                None => out.push(a..b + 1),
            }
        }
        out.into_iter().map(|r| from + r.start..from + r.end).collect()
    }

    /// Ranges of speed over which its states are unstable.
    pub(super) fn unstable_ranges(&self) -> Vec<(f64, f64)> {
        ranges_of(self.branch, self.unstable())
    }

    /// The unstable state that grows fastest.
    pub(super) fn fastest(&self) -> Option<&State> {
        let points = self.unstable().into_iter().flatten().map(|i| &self.branch.points[i]).filter(|p| p.growth() > 0.0);
        points.max_by(|a, b| a.growth().total_cmp(&b.growth()))
    }
}

/// Consecutive unstable points of a branch, stretch by stretch, but not those between two stretches that can be stable.
pub(super) fn unstable_runs(branch: &Traced) -> Vec<Range<usize>> {
    stretches(branch).iter().flat_map(Stretch::unstable).collect()
}

/// Ranges of speed over which consecutive points of a branch are unstable, ascending ends.
pub(super) fn unstable_ranges(branch: &Traced) -> Vec<(f64, f64)> {
    ranges_of(branch, unstable_runs(branch))
}

/// Ranges of speed over which states of these branches are unstable and none is stable, ascending ends.
pub(super) fn unstable_throughout(branches: &[&Traced]) -> Vec<(f64, f64)> {
    let stable = |s: Stretch<'_>| {
        let runs = runs(s.branch.points[s.points.clone()].iter().map(State::stable));
        ranges_of(s.branch, runs.into_iter().map(|(a, b)| s.points.start + a..s.points.start + b + 1).collect())
    };
    let held: Vec<(f64, f64)> = branches.iter().flat_map(|b| stretches(b)).flat_map(stable).collect();
    let mut left: Vec<(f64, f64)> = branches.iter().flat_map(|b| unstable_ranges(b)).collect();
    for (from, to) in held {
        let outside = |(a, b): (f64, f64)| [(a, b.min(from)), (a.max(to), b)].into_iter().filter(|(a, b)| a < b);
        left = left.into_iter().flat_map(outside).collect();
    }
    left
}

/// Speeds of runs of points.
pub(super) fn ranges_of(branch: &Traced, runs: Vec<Range<usize>>) -> Vec<(f64, f64)> {
    let range = |run: Range<usize>| {
        // to where the stability is lost and regained, not to the nearest points computed
        let located = branch.changes.iter().filter(|c| c.after + 1 == run.start || c.after + 1 == run.end).map(|c| c.speed);
        let speeds = branch.points[run.clone()].iter().map(|p| p.speed).chain(located);
        speeds.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), s| (a.min(s), b.max(s)))
    };
    runs.into_iter().map(range).collect()
}

/// Ranges of speed as a list of phrases, the first ones one by one.
pub(super) fn listed(ranges: &[(f64, f64)]) -> Arg {
    const MOST: usize = 4;
    let shown = ranges.iter().take(MOST).map(|&(from, to)| place(from, to));
    let more = Some(ranges.len().saturating_sub(MOST)).filter(|n| *n > 0);
    let more = more.map(|n| Message::new("nonlinear-response-more-ranges").arg("n", Arg::count(n)));
    Arg::List(shown.chain(more).map(Arg::from).collect())
}
