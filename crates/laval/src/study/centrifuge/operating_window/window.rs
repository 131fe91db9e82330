//! From requirements at single speeds to intervals: scan, refinement of the ends, best speed, trade with time, conflicts.

use super::detail::Detail;
use super::margins::{Evaluator, NAMES, Point};
use crate::diagnostic::Diagnostic;
use laval_num::order::SortByNumber;
use laval_num::text::Text;
use laval_num::univariate::maximum;
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
    pub detail: Detail,
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
/// Width at which the largest least margin is located, as a share of two steps of the grid.
const HUMP: f64 = 1e-4;

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

/// A speed that keeps all requirements between neighbours that do not, where the grid steps over a window: between two speeds that break different requirements, and
/// around one whose least margin is larger than those of both neighbours. All points looked at are added.
pub(super) fn stepped_over(at: impl Fn(f64) -> Result<Point, Diagnostic>, points: &mut Vec<Point>) -> Result<(), Diagnostic> {
    let mut made = Vec::new();
    for pair in points.windows(2) {
        made.extend(between(&pair[0], &pair[1], &at)?);
    }
    for three in points.windows(3).filter(|t| t.iter().all(|p| !p.feasible())) {
        let (a, b, c) = (three[0].least(), three[1].least(), three[2].least());
        if b.is_finite()
            && b > a
            && b > c
            && !made.iter().any(|p: &Point| p.feasible() && three[0].speed < p.speed && p.speed < three[2].speed)
        {
            around(three, &mut made, &at)?;
        }
    }
    points.extend(made);
    points.sort_by_number(|a| a.speed);
    points.dedup_by(|a, b| a.speed == b.speed);
    Ok(())
}

/// Halves the range between two speeds that break different requirements, until one keeps all or breaks some of both.
fn between(a: &Point, b: &Point, at: impl Fn(f64) -> Result<Point, Diagnostic>) -> Result<Vec<Point>, Diagnostic> {
    let mut made = Vec::new();
    let (left, right) = (a.broken(), b.broken());
    if left.is_empty() || right.is_empty() || left.iter().any(|n| right.contains(n)) {
        return Ok(made);
    }
    let (mut low, mut high) = (a.speed, b.speed);
    while (high - low).abs() > LOCATED * low.abs() {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high {
            break;
        }
        let p = at(middle)?;
        let broken = p.broken();
        made.push(p);
        if broken.is_empty() {
            break;
        } else if broken.iter().all(|n| left.contains(n)) {
            low = middle;
        } else if broken.iter().all(|n| right.contains(n)) {
            high = middle;
        } else {
            break;
        }
    }
    Ok(made)
}

/// Where the least margin is largest around the middle of three speeds; the first that keeps all is added.
fn around(three: &[Point], made: &mut Vec<Point>, at: impl Fn(f64) -> Result<Point, Diagnostic>) -> Result<(), Diagnostic> {
    let mut found: Result<Option<Point>, Diagnostic> = Ok(None);
    let (from, to) = (three[0].speed, three[2].speed);
    let least = |w: f64| {
        let p = at(w).map_err(|d| found = Err(d)).ok()?;
        let value = p.least();
        if p.feasible() {
            found = Ok(Some(p));
            return None;
        }
        Some(value.max(-1e300))
    };
    maximum(least, from, to, HUMP * (to - from).abs());
    made.extend(found?);
    Ok(())
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
        detail: binding.map(|m| m.detail.clone()).unwrap_or_default(),
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
        detail: Detail::Itself,
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
    points.sort_by_number(|a| a.speed);
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

/// The smallest relaxation of a single requirement that opens a window: its best margin where all others are kept, and the speed. A requirement that is kept needs none.
pub(super) fn relaxations(points: &[Point]) -> Vec<(usize, f64, f64)> {
    let mut out = Vec::new();
    for name in 0..NAMES.len() {
        let best = points
            .iter()
            .filter(|p| p.feasible_without(name))
            .filter_map(|p| p.margin(name).filter(|m| m.is_finite() && *m < 0.0).map(|m| (m, p.speed)))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        out.extend(best.map(|(m, w)| (name, m, w)));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::centrifuge::operating_window::margins::Margin;

    fn point(speed: f64, values: &[f64]) -> Point {
        let margins = values.iter().enumerate().map(|(name, &value)| Margin { name, value, detail: Detail::Itself }).collect();
        Point { speed, margins, needed: 0.0, tilt: 0.0, unbalance: 0.0, states: 1, energy: 0.0, growth: 0.0, leans: vec![] }
    }

    /// One requirement is kept from 5.001 on, another up to 5.002: no speed of a grid of whole numbers keeps both.
    #[test]
    fn a_window_between_two_speeds_of_the_grid() {
        let at = |w: f64| Ok(point(w, &[w - 5.001, 5.002 - w]));
        let (a, b) = (at(5.0).unwrap(), at(6.0).unwrap());
        let made = between(&a, &b, at).unwrap();
        assert!(made.last().is_some_and(Point::feasible), "{made:?}");
        // the other way round nothing keeps both
        let never = |w: f64| Ok(point(w, &[w - 5.4, 5.3 - w]));
        let made = between(&never(5.0).unwrap(), &never(6.0).unwrap(), never).unwrap();
        assert!(!made.is_empty() && made.len() < 10 && !made.iter().any(Point::feasible));
        // the same requirement is broken at both
        assert!(between(&point(5.0, &[-1.0, 1.0]), &point(6.0, &[-1.0, -1.0]), at).unwrap().is_empty());
    }

    /// A requirement that is kept near 5.3 alone.
    #[test]
    fn a_window_around_a_largest_margin() {
        let at = |w: f64| Ok(point(w, &[0.01 - (w - 5.3).powi(2)]));
        let three = [4.0, 5.0, 6.0].map(|w| at(w).unwrap());
        let mut made = Vec::new();
        around(&three, &mut made, at).unwrap();
        assert!(made.len() == 1 && made[0].feasible(), "{made:?}");
        let never = |w: f64| Ok(point(w, &[-0.01 - (w - 5.3).powi(2)]));
        let three = [4.0, 5.0, 6.0].map(|w| never(w).unwrap());
        made.clear();
        around(&three, &mut made, never).unwrap();
        assert!(made.is_empty());
    }

    /// The same on a grid: beside the speed with the largest of the least margins, and nowhere else.
    #[test]
    fn a_window_that_the_grid_steps_over() {
        let looked = std::cell::RefCell::new(Vec::new());
        let at = |w: f64| {
            looked.borrow_mut().push(w);
            Ok(point(w, &[0.01 - (w - 5.3).powi(2)]))
        };
        let mut points: Vec<Point> = (1..10).map(|k| at(f64::from(k)).unwrap()).collect();
        looked.borrow_mut().clear();
        stepped_over(at, &mut points).unwrap();
        assert!(points.iter().any(Point::feasible) && points.is_sorted_by(|a, b| a.speed < b.speed), "{points:?}");
        assert!(looked.borrow().iter().all(|w| (4.0..=6.0).contains(w)), "{looked:?}");
        // margins that only rise have no largest one inside
        let rising = |w: f64| Ok(point(w, &[w - 20.0]));
        let mut points: Vec<Point> = (1..10).map(|k| rising(f64::from(k)).unwrap()).collect();
        stepped_over(rising, &mut points).unwrap();
        assert_eq!(points.len(), 9);
    }

    /// What is kept needs no relaxation.
    #[test]
    fn relaxations_relax() {
        assert!(relaxations(&[point(1.0, &[0.04, 0.2])]).is_empty());
        let found = relaxations(&[point(1.0, &[-0.5, 0.2]), point(2.0, &[-0.1, 0.2]), point(3.0, &[0.3, 0.2])]);
        assert_eq!(found, [(0, -0.1, 2.0)]);
    }
}
