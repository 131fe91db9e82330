//! What a slow sweep of the speed meets: the branches it follows, and where it jumps from one state to another.

use super::findings::{reason, residual};
use super::shown::branch;
use super::stretches::{listed, ranges_of, unstable_runs};
use crate::model::probe::Probe;
use crate::outcome::{self, Arg, Finding, Message};
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Fold, Response, Traced};
use crate::study::shared::probes;
use laval_num::continuation::End;
use std::ops::Range;

/// Relative distance beyond a fold at which the states left are looked for.
const BEYOND: f64 = 1e-6;

/// A jump of a slow sweep.
pub(super) struct Jump<'r> {
    /// Where the states it followed end.
    pub fold: &'r Fold,
    /// The other branch whose states it goes on with; `None` when it stays on the same.
    pub onto: Option<&'r Traced>,
    /// Stable states of the branches from both ends just beyond it; `None` where stability is not known.
    pub stable: Option<usize>,
    /// Growth rate, 1/s, of the states next to it where they are unstable: no sweep comes to it.
    pub unstable: Option<f64>,
    /// Speeds at which the states that lead to it are unstable, rad/s.
    pub on_the_way: Vec<(f64, f64)>,
}

/// States before a fold that are looked at.
const NEAR: usize = 4;

/// What moves most at a fold, and how far, m or rad.
type Size<'a> = &'a dyn Fn(&Fold) -> Option<(&'a Probe, f64)>;

/// The branches from both ends of the range.
fn main_branches(response: &Response) -> impl Iterator<Item = &Traced> {
    response.branches.iter().filter(|b| matches!(b.origin, Origin::Low | Origin::High))
}

/// The branch that a slow sweep starts on: the state a machine brought to an end of the range is on is that of the branch which starts there, else of the
/// end of the other.
pub(super) fn swept(response: &Response, up: bool, speeds: (f64, f64)) -> Option<&Traced> {
    if response.unstarted.contains(&begins(up, speeds)) {
        return None;
    }
    let from = |origin: Origin| response.branches.iter().find(|b| b.origin == origin);
    let (near, far) = if up { (Origin::Low, Origin::High) } else { (Origin::High, Origin::Low) };
    from(near).or(from(far))
}

/// Where a slow sweep that starts on a branch jumps: at the first fold that turns against it, from there to the next states of the branch at that speed, else to
/// those of the other branch, and on to the next such fold beyond.
pub(super) fn jumps<'r>(response: &'r Response, start: &'r Traced, up: bool) -> Vec<Jump<'r>> {
    let further = |speed: f64, than: f64| (speed.abs() > than.abs()) == up && speed != than;
    let mut out: Vec<Jump> = Vec::new();
    let mut branch = start;
    loop {
        // of a branch that was cut off nothing is known about its folds beyond
        let mut met: Vec<&Fold> = branch.folds.iter().filter(|f| f.upper == up && f.after < branch.points.len()).collect();
        if up != branch.from_low() {
            met.reverse();
        }
        for fold in met {
            if out.last().is_none_or(|last| further(fold.speed, last.fold.speed)) {
                let since = out.last().map(|last| last.fold.speed);
                let on_the_way = on_the_way(branch, Some(fold), since, up);
                let (stable, unstable) = (landings(response, fold.speed, up), before(branch, fold, up));
                out.push(Jump { fold, onto: None, stable, unstable, on_the_way });
            }
        }
        let Some(last) = out.last_mut() else { break };
        let at = last.fold.speed;
        if branch.points.iter().any(|p| further(p.speed, at)) {
            break;
        }
        let Some(other) = main_branches(response).find(|b| segments(b, beyond(at, up)).any(|stable| stable != Some(false))) else { break };
        last.onto = Some(other);
        branch = other;
    }
    out
}

/// Speeds at which a slow sweep jumps from states that a machine stays on.
pub(super) fn reached(response: &Response, up: bool, speeds: (f64, f64)) -> Vec<f64> {
    let jumps = swept(response, up, speeds).map(|branch| jumps(response, branch, up)).unwrap_or_default();
    jumps.iter().take_while(|j| j.unstable.is_none()).map(|j| j.fold.speed).collect()
}

/// Growth rate of the states a sweep meets before a fold, where all of them that are near are unstable; beside the fold one is so by rounding.
fn before(branch: &Traced, fold: &Fold, up: bool) -> Option<f64> {
    let onwards = up == branch.from_low();
    let near: Vec<_> = if onwards {
        branch.points[..(fold.after + 1).min(branch.points.len())].iter().rev().take(NEAR).collect()
    } else {
        branch.points.iter().skip(fold.after + 1).take(NEAR).collect()
    };
    let all = !near.is_empty() && near.iter().all(|p| p.unstable());
    all.then(|| near.iter().map(|p| p.growth()).fold(f64::NEG_INFINITY, f64::max))
}

/// Where the states that a sweep meets on a branch before a fold, or on to its end, are unstable: from the end where it begins, or beyond the speed of the
/// jump before.
fn on_the_way(branch: &Traced, fold: Option<&Fold>, since: Option<f64>, up: bool) -> Vec<(f64, f64)> {
    let count = branch.points.len();
    let met = match fold {
        None => 0..count,
        Some(f) if up == branch.from_low() => 0..(f.after + 1).min(count),
        Some(f) => f.after + 1..count,
    };
    let reached = |i: usize| since.is_none_or(|s| (branch.points[i].speed.abs() > s.abs()) == up);
    let cut = |r: Range<usize>| {
        let inside = || r.clone().filter(|i| met.contains(i) && reached(*i));
        inside().min().unwrap_or(0)..inside().max().map_or(0, |i| i + 1)
    };
    ranges_of(branch, unstable_runs(branch).into_iter().map(cut).filter(|r| !r.is_empty()).collect())
}

fn beyond(speed: f64, up: bool) -> f64 {
    speed * if up { 1.0 + BEYOND } else { 1.0 - BEYOND }
}

/// Pieces of a branch from point to point that pass a speed: whether they are stable.
fn segments(branch: &Traced, speed: f64) -> impl Iterator<Item = Option<bool>> + '_ {
    let pairs = branch.points.windows(2).filter(move |w| (w[0].speed - speed) * (w[1].speed - speed) < 0.0);
    pairs.map(|w| w.iter().all(|p| p.exponents.is_some()).then(|| !w[0].unstable() && !w[1].unstable()))
}

/// Stable states just beyond a speed.
fn landings(response: &Response, speed: f64, up: bool) -> Option<usize> {
    let known: Option<Vec<bool>> = main_branches(response).flat_map(|b| segments(b, beyond(speed, up))).collect();
    known.map(|k| k.into_iter().filter(|stable| *stable).count())
}

/// Where a slow sweep jumps, that it does not, or that its states are not known.
pub(super) fn findings(response: &Response, up: bool, ((lo, hi), study): ((f64, f64), outcome::End), size: Size) -> Vec<Finding> {
    let Some(followed) = swept(response, up, (lo, hi)) else { return vec![unstarted(up, (lo, hi))] };
    let way = if up { "up" } else { "down" };
    let begin = begins(up, (lo, hi));
    let end = if begin == lo { hi } else { lo };
    let jumps = jumps(response, followed, up);
    if !jumps.is_empty() {
        // what lies behind states that no machine stays on is reached from elsewhere
        let reached = jumps.iter().take_while(|j| j.unstable.is_none()).count();
        let reported = jumps[..reached].iter().enumerate().map(|(k, jump)| jump.reported(way, k == 0, size));
        let lost = jumps.get(reached).and_then(|j| Some(unstable(way, j, j.unstable?)));
        return reported.chain(lost).collect();
    }
    let lost = on_the_way(followed, None, None, up);
    let range = |f: Finding| f.arg("way", Arg::word(way)).arg("from", Arg::speed(begin)).arg("to", Arg::speed(end));
    let none = if followed.end == End::Reached && !lost.is_empty() {
        range(Finding::info(format!("no_jump_{way}"), "nonlinear-response-no-fold")).arg("ranges", listed(&lost))
    } else if followed.end == End::Reached {
        let rising = up && response.unclosed.is_some();
        range(Finding::info(format!("no_jump_{way}"), "nonlinear-response-no-jump"))
            .arg("amplitude", Arg::word(if rising { "rising" } else { "other" }))
    } else {
        let id = format!("sweep_{way}_unfinished");
        // where it begins is the end that was cut off
        let begun = followed.end != End::Cancelled || up == followed.from_low();
        let finding = match followed.points.last().filter(|_| begun) {
            Some(p) => Finding::warning(id, "nonlinear-response-sweep-unfinished").value(p.speed, "rad/s"),
            None => Finding::warning(id, "nonlinear-response-sweep-not-followed"),
        };
        finding.arg("way", Arg::word(way)).arg("why", reason(&followed.end, study)).evidence(
            "scaled residual of the start",
            residual(&followed.end),
            "",
        )
    };
    vec![none]
}

impl Jump<'_> {
    fn reported(&self, way: &'static str, first: bool, size: Size) -> Finding {
        let f = self.fold;
        let mut finding = Finding::info(format!("jump_{way}"), "nonlinear-response-jump")
            .value(f.speed, "rad/s")
            .arg("way", Arg::word(way))
            .arg("again", Arg::word(if first { "no" } else { "yes" }))
            .arg("onto", self.onto.map_or(Arg::word("none"), |b| branch(b.origin).into()));
        if !self.on_the_way.is_empty() {
            let note = Message::new("nonlinear-response-jump-unstable-before");
            finding.notes.push(note.arg("ranges", listed(&self.on_the_way)));
        }
        if let Some(n) = self.stable.filter(|n| *n != 1) {
            finding.notes.push(Message::new("nonlinear-response-jump-landing").arg("stable", Arg::count(n)));
        }
        let finding = match size(f) {
            Some((p, size)) => {
                let what = if p.is_tilt() { "largest tilt at the fold" } else { "largest displacement at the fold" };
                finding.evidence(Arg::of(what, probes::label(p)), size, p.unit())
            }
            None => finding,
        };
        finding
            .evidence("change with four more orders", f.harmonics_change.abs(), "rad/s")
            .evidence("difference of two methods", f.methods_differ.abs(), "rad/s")
            .evidence("width of the bracket", (f.bracket.0 - f.bracket.1).abs(), "rad/s")
            .evidence("scaled residual", f.residual, "")
    }
}

/// Where a slow sweep begins: up is faster, whichever way round the rotor turns.
fn begins(up: bool, (lo, hi): (f64, f64)) -> f64 {
    if up == (lo >= 0.0) { lo } else { hi }
}

/// That the states before a fold are unstable.
fn unstable(way: &'static str, jump: &Jump, growth: f64) -> Finding {
    Finding::warning(format!("sweep_{way}_unstable"), "nonlinear-response-sweep-unstable")
        .value(jump.fold.speed, "rad/s")
        .arg("way", Arg::word(way))
        .arg("ranges", listed(&jump.on_the_way))
        .evidence("growth rate before it", growth, "1/s")
}

/// That states at an end of the range were found there alone.
pub(super) fn unfollowed(response: &Response) -> Vec<Finding> {
    let begun = |w: f64| response.branches.iter().any(|b| b.points.first().is_some_and(|p| p.speed == w));
    let reported = |&w: &f64| Finding::info("start_not_followed", "nonlinear-response-start-not-followed").value(w, "rad/s");
    response.unfollowed.iter().filter(|w| begun(**w)).map(reported).collect()
}

/// That the states of a sweep are not known.
fn unstarted(up: bool, speeds: (f64, f64)) -> Finding {
    let way = if up { "up" } else { "down" };
    Finding::warning(format!("sweep_{way}_unknown"), "nonlinear-response-sweep-unknown")
        .value(begins(up, speeds), "rad/s")
        .arg("way", Arg::word(way))
}
