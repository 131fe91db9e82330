//! From requirements at single speeds to intervals: scan, refinement of the ends, best speed, trade with time, conflicts.

use super::margins::{Evaluator, NAMES, Point};
use crate::diagnostic::Diagnostic;
use laval_num::text::Text;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// One end of an interval.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct End {
    /// Last feasible speed, rad/s.
    pub speed: f64,
    /// The requirement that ends it, or `range`.
    pub binding: String,
    /// What binds in it.
    pub detail: String,
    /// crossing, jump, eigenvalue crossing, domain limit.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub event: Text,
    /// Width of the bracket, rad/s.
    pub bracket: f64,
    /// Beyond it: the margin that ends it.
    pub beyond: f64,
    /// Stable states inside, and beyond it.
    pub states: [usize; 2],
}

/// Speeds at which all requirements are kept.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Interval {
    /// Where it begins.
    pub low: End,
    /// Where it ends.
    pub high: End,
}

/// Relative width at which an end is located.
const LOCATED: f64 = 1e-11;

/// Evaluates speeds on all cores; results in their order. `None` when cancelled.
pub(super) fn scan(evaluator: &Evaluator, speeds: &[f64], go_on: impl Fn(u64) -> bool + Sync) -> Result<Option<Vec<Point>>, Diagnostic> {
    let done = std::sync::atomic::AtomicU64::new(0);
    let here = Here::now();
    let found: Result<Vec<Option<Point>>, Diagnostic> = speeds
        .par_iter()
        .map(|&w| {
            let _counted = here.enter();
            if !go_on(done.fetch_add(1, std::sync::atomic::Ordering::Relaxed)) {
                return Ok(None);
            }
            evaluator.at(w).map(Some)
        })
        .collect();
    Ok(found?.into_iter().collect())
}

/// Adds points where the least margin of feasible neighbours dips: a narrow interruption may hide there.
pub(super) fn dips(points: &[Point]) -> Vec<f64> {
    let mut out = Vec::new();
    for w in points.windows(3) {
        let (a, b, c) = (w[0].least(), w[1].least(), w[2].least());
        if b >= 0.0 && b <= a && b <= c && b < 0.3 {
            let (from, to) = (w[0].speed, w[2].speed);
            out.extend((1..8).map(|k| from + (to - from) * k as f64 / 8.0));
        }
    }
    out
}

/// Narrows the border between a feasible and an infeasible speed.
fn border(
    evaluator: &Evaluator,
    mut inside: Point,
    mut outside: Point,
    keeps: impl Fn(&Point) -> bool,
) -> Result<(Point, Point), Diagnostic> {
    for _ in 0..60 {
        if (inside.speed - outside.speed).abs() <= LOCATED * inside.speed.abs() {
            break;
        }
        // the secant of the margin that ends it, kept inside the bracket, then the middle
        let middle = 0.5 * (inside.speed + outside.speed);
        let name = outside.binding().map(|m| m.name);
        let guess = name.and_then(|n| Some((inside.margin(n)?, outside.margin(n)?))).filter(|(a, b)| *a > 0.0 && *b < 0.0).map(|(a, b)| {
            let x = inside.speed + (outside.speed - inside.speed) * a / (a - b);
            // a little to either side, so that both ends close in
            x + 1e-3 * (outside.speed - inside.speed) * if a < -b { 1.0 } else { -1.0 }
        });
        for x in guess.into_iter().chain([middle]) {
            if (x - inside.speed) * (x - outside.speed) < 0.0 {
                let p = evaluator.at(x)?;
                if keeps(&p) { inside = p } else { outside = p }
            }
        }
    }
    Ok((inside, outside))
}

fn end(inside: &Point, outside: &Point) -> End {
    let binding = outside.binding();
    let name = binding.map_or("", |m| NAMES[m.name]);
    let jump = binding.is_none_or(|m| m.value.is_nan() || inside.margin(m.name).is_none_or(|a| !((a - m.value).abs() < 1e-4)));
    let event = if jump {
        "jump"
    } else if name == "stable" {
        "eigenvalue crossing"
    } else {
        "crossing"
    };
    End {
        speed: inside.speed,
        binding: name.to_string(),
        detail: binding.map_or_else(String::new, |m| m.detail.clone()),
        event,
        bracket: (inside.speed - outside.speed).abs(),
        beyond: binding.map_or(f64::NAN, |m| m.value),
        states: [inside.states, outside.states],
    }
}

/// Intervals in which `keeps` holds; points are in order of speed. The points made on the way are added.
pub(super) fn intervals(
    evaluator: &Evaluator,
    points: &mut Vec<Point>,
    keeps: impl Fn(&Point) -> bool + Copy,
) -> Result<Vec<Interval>, Diagnostic> {
    let mut out: Vec<Interval> = Vec::new();
    let mut made = Vec::new();
    let limit = |p: &Point| End {
        speed: p.speed,
        binding: "range".into(),
        detail: String::new(),
        event: "domain limit",
        bracket: 0.0,
        beyond: f64::NAN,
        states: [p.states; 2],
    };
    let mut low: Option<End> = None;
    for i in 0..points.len() {
        let p = &points[i];
        if keeps(p) && low.is_none() {
            low = Some(match i.checked_sub(1).and_then(|k| points.get(k)) {
                None => limit(p),
                Some(before) => {
                    let (a, b) = border(evaluator, p.clone(), before.clone(), keeps)?;
                    let e = end(&a, &b);
                    made.extend([a, b]);
                    e
                }
            });
        }
        let next = points.get(i + 1);
        if keeps(p) && next.is_none_or(|n| !keeps(n)) {
            let high = match next {
                None => limit(p),
                Some(after) => {
                    let (a, b) = border(evaluator, p.clone(), after.clone(), keeps)?;
                    let e = end(&a, &b);
                    made.extend([a, b]);
                    e
                }
            };
            out.extend(low.take().map(|low| Interval { low, high }));
        }
    }
    points.extend(made);
    points.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    points.dedup_by(|a, b| a.speed == b.speed);
    Ok(out)
}

/// Two requirements that no speed keeps together.
pub(super) fn excluding(points: &[Point]) -> Vec<(usize, usize)> {
    let mut out = Vec::new();
    for a in 0..NAMES.len() {
        for b in a + 1..NAMES.len() {
            let kept = |p: &Point, n: usize| p.margin(n).is_some_and(|m| m >= 0.0);
            let alone = |n: usize| points.iter().any(|p| kept(p, n));
            if alone(a) && alone(b) && !points.iter().any(|p| kept(p, a) && kept(p, b)) {
                out.push((a, b));
            }
        }
    }
    out
}

/// The smallest relaxation of a single requirement that opens a window: its best margin where all others are kept, and the speed.
pub(super) fn relaxations(points: &[Point]) -> Vec<(usize, f64, f64)> {
    let mut out = Vec::new();
    for name in 0..NAMES.len() {
        let best = points
            .iter()
            .filter(|p| p.feasible_without(name))
            .filter_map(|p| p.margin(name).filter(|m| m.is_finite()).map(|m| (m, p.speed)))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        out.extend(best.map(|(m, w)| (name, m, w)));
    }
    out
}
