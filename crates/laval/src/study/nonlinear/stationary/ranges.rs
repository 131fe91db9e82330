//! Over which speeds something holds: along one branch, of all branches together, of none.

use super::classify::{Class, HALF, Scale, Seen};
use super::continua::Span;
use crate::model::system::System;
use crate::solve::stationary::{Found, Located, Sample, Search, State};
use laval_num::order::SortByNumber;
use laval_num::univariate::root;
use serde::{Deserialize, Serialize};

/// Share of the unbalance without the masses above which they do harm; equal masses opposite each other leave it as it is.
const HARM: f64 = 1.001;

/// Share of their capacity below which what the masses leave is rounding.
const NOTHING: f64 = 1e-9;

/// A point of a branch with what it shows.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shown {
    pub path: usize,
    /// Which of its points.
    pub sample: usize,
    /// Arclength along the branch.
    pub s: f64,
    pub speed: f64,
    pub seen: Seen,
    pub class: Class,
    pub growing: usize,
    pub growth: f64,
    /// A curve through the points begins anew: another branch, another kind, an angle that passes half a turn.
    pub begins: bool,
}

/// A range of speeds in which states of one class are stable along one branch.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Range {
    pub class: Class,
    pub path: usize,
    pub from: f64,
    pub to: f64,
    /// First and last point.
    pub points: (usize, usize),
}

/// The points of all branches.
pub fn points(system: &System, search: &mut Search, found: &Found) -> Vec<Shown> {
    let mut out: Vec<Shown> = Vec::new();
    for (path, p) in found.paths.iter().enumerate() {
        for (k, sample) in p.points.iter().enumerate() {
            let state: &State = &sample.state;
            let scale = Scale::at(system, search, state.speed);
            let seen = Seen::of(system, search, state);
            let class = seen.class(&scale);
            let turned = |before: &Shown| {
                let (a, b) = (before.seen.groups.iter().flatten(), seen.groups.iter().flatten());
                a.zip(b).any(|(a, b)| (a - b).abs() > std::f64::consts::PI)
            };
            let begins = out.last().is_none_or(|b| b.path != path || b.class != class || turned(b));
            let (growing, growth) = (sample.stability.growing, sample.stability.growth());
            out.push(Shown { path, sample: k, s: sample.s, speed: state.speed, seen, class, growing, growth, begins });
        }
    }
    out
}

/// Speed between two neighbouring points of a branch at which the unbalance left has this share of that without the masses; `None` where it does not pass it.
fn passes(system: &System, search: &mut Search, found: &Found, ends: [&Shown; 2], share: f64) -> Option<f64> {
    let own = &found.paths.get(ends[0].path)?.points;
    let [a, b] = [own.get(ends[0].sample)?, own.get(ends[1].sample)?];
    let off = |seen: &Seen| seen.share().map_or(f64::NAN, |s| s - share);
    let sides = ends.map(|e| (e.speed, off(&e.seen)));
    let mut at = |w: f64| search.between(a, b, w).map(|s| off(&Seen::of(system, search, &s.state)));
    root(&mut at, sides[0], sides[1], 1e-12 * sides[1].0.abs())
}

/// Where states of a class are stable: from located change to located change. Branches that are images of each other tell the same once.
pub fn stable(system: &System, search: &mut Search, found: &Found, points: &[Shown], width: f64) -> Vec<Range> {
    let mut out: Vec<Range> = Vec::new();
    let mut i = 0;
    while i < points.len() {
        if points[i].growing > 0 {
            i += 1;
            continue;
        }
        let begin = i;
        let same = |k: usize| points[k].path == points[begin].path && points[k].class == points[begin].class && points[k].growing == 0;
        while i + 1 < points.len() && same(i + 1) {
            i += 1;
        }
        // the change between two points of the branch that has no growing root on one side
        let path = points[begin].path;
        let special = || found.paths.get(path).into_iter().flat_map(|p| &p.special);
        let mut edge = |a: usize, b: usize| {
            let inside = |l: &&Located| (points[a].s..=points[b].s).contains(&l.s) && l.growing.0.min(l.growing.1) == 0;
            // or where the unbalance left is half of that without masses
            let half = || passes(system, search, found, [&points[a], &points[b]], HALF);
            let change = special().find(inside).map(|l| l.state.speed);
            change.or_else(half).unwrap_or(0.5 * (points[a].speed + points[b].speed))
        };
        let own = |k: usize| points.get(k).is_some_and(|p| p.path == path);
        let from = if begin > 0 && own(begin - 1) { edge(begin - 1, begin) } else { points[begin].speed };
        let to = if own(i + 1) { edge(i, i + 1) } else { points[i].speed };
        // a branch that turns back within the range reaches beyond both its ends
        let turns = special().filter(|l| l.located && (points[begin].s..=points[i].s).contains(&l.s)).map(|l| l.state.speed);
        let inner = points[begin..=i].iter().map(|p| p.speed).chain(turns);
        let (low, high) = inner.chain([from, to]).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), w| (l.min(w), h.max(w)));
        out.push(Range { class: points[begin].class, path, from: low, to: high, points: (begin, i) });
        i += 1;
    }
    let mut kept: Vec<Range> = Vec::new();
    for r in out {
        let near = |o: &Range| o.class == r.class && (o.from - r.from).abs() < 1e-7 * width && (o.to - r.to).abs() < 1e-7 * width;
        if !kept.iter().any(near) {
            kept.push(r);
        }
    }
    kept.sort_by(|a, b| (a.class, a.path).cmp(&(b.class, b.path)).then(a.from.total_cmp(&b.from)));
    kept
}

/// Intervals that cover the same speeds, joined where they touch within `gap`.
pub fn union(mut all: Vec<(f64, f64)>, gap: f64) -> Vec<(f64, f64)> {
    all.sort_by_number(|a| a.0);
    let mut out: Vec<(f64, f64)> = Vec::new();
    for (from, to) in all {
        match out.last_mut() {
            Some(last) if from <= last.1 + gap => {
                if to > last.1 {
                    last.1 = to;
                }
            }
            _ => out.push((from, to)),
        }
    }
    out
}

/// What of a range some intervals, as [`union`] gives them, leave; pieces narrower than `least` are left out.
pub fn rest(range: (f64, f64), covered: &[(f64, f64)], least: f64) -> Vec<(f64, f64)> {
    let mut out = Vec::new();
    let mut at = range.0;
    for &(from, to) in covered {
        if from - at > least {
            out.push((at, from));
        }
        if to > at {
            at = to;
        }
    }
    if range.1 - at > least {
        out.push((at, range.1));
    }
    out
}

/// Of the range of a search the pieces in which no isolated state and none of these continua is stable, as far as the points of the branches tell.
pub fn without_stable(found: &Found, spans: &[Span], range: (f64, f64), least: f64) -> Vec<(f64, f64)> {
    let calm = |w: &[Sample]| w.iter().all(|p| p.stability.growing == 0);
    let pairs = found.paths.iter().flat_map(|p| p.points.windows(2)).filter(|w| calm(w));
    let isolated = pairs.map(|w| (w[0].state.speed.min(w[1].state.speed), w[0].state.speed.max(w[1].state.speed)));
    let continua = spans.iter().filter(|s| s.stable).map(|s| (s.from, s.to));
    rest(range, &union(isolated.chain(continua).collect(), 0.0), least)
}

/// Speeds over which branches hold states that balance, stable or not, with the places where such a branch turns back.
pub fn existing(found: &Found, points: &[Shown]) -> Vec<(f64, f64)> {
    let mut out = Vec::new();
    for w in points.windows(2) {
        if w[0].path != w[1].path || !(w[0].class.balances() && w[1].class.balances()) {
            continue;
        }
        let special = found.paths.get(w[0].path).into_iter().flat_map(|p| &p.special);
        let turns = special.filter(|l| l.located && (w[0].s..=w[1].s).contains(&l.s)).map(|l| l.state.speed);
        let all = turns.chain([w[0].speed, w[1].speed]);
        out.push(all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), w| (l.min(w), h.max(w))));
    }
    out
}

/// A run of points of a stable range at which the masses make the unbalance larger.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Harm {
    pub from: f64,
    pub to: f64,
    /// Largest unbalance at its points, over that without the masses; where nothing is out of balance without them, kg m.
    pub most: f64,
    /// Something is out of balance without them.
    pub relative: bool,
}

/// Where in a stable range the masses make the unbalance larger.
pub fn harmful(system: &System, search: &mut Search, found: &Found, points: &[Shown], range: &Range) -> Vec<Harm> {
    let mut out: Vec<Harm> = Vec::new();
    let own = &points[range.points.0..=range.points.1];
    // over what is there without them, or by itself where that is nothing
    let size = |p: &Shown| -> (f64, bool, bool) {
        let Some(u) = p.seen.unbalance else { return (0.0, false, true) };
        match p.seen.share() {
            Some(share) => (share, share > HARM, true),
            None => (u.moment.abs(), u.without() == 0.0 && u.moment.abs() > NOTHING * u.capacity, false),
        }
    };
    let above = |k: usize| size(&own[k]).1;
    let mut k = 0;
    while k < own.len() {
        if !above(k) {
            k += 1;
            continue;
        }
        let begin = k;
        while k + 1 < own.len() && above(k + 1) {
            k += 1;
        }
        let mut between = |inside: usize, outside: usize| {
            passes(system, search, found, [&own[inside.min(outside)], &own[inside.max(outside)]], 1.0).unwrap_or(own[inside].speed)
        };
        let (first, last) = (own[0].speed, own[own.len() - 1].speed);
        // the ends of the range are located better than its first and last points
        let (low, high) = if first <= last { (range.from, range.to) } else { (range.to, range.from) };
        let from = if begin == 0 { low } else { between(begin, begin - 1) };
        let to = if k + 1 == own.len() { high } else { between(k, k + 1) };
        let most = own[begin..=k].iter().map(|p| size(p).0).fold(0.0, crate::study::shared::support::larger);
        out.push(Harm { from: from.min(to), to: from.max(to), most, relative: size(&own[begin]).2 });
        k += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_of_a_range() {
        let covered = union(vec![(5.0, 6.0), (1.0, 2.0), (1.5, 3.0), (3.0 + 1e-9, 4.0)], 1e-6);
        assert_eq!(covered, vec![(1.0, 4.0), (5.0, 6.0)]);
        assert_eq!(rest((0.0, 7.0), &covered, 1e-6), vec![(0.0, 1.0), (4.0, 5.0), (6.0, 7.0)]);
        assert_eq!(rest((1.0, 6.0), &covered, 2.0), vec![]);
        assert_eq!(rest((0.0, 1.0), &[], 1e-6), vec![(0.0, 1.0)]);
    }
}
