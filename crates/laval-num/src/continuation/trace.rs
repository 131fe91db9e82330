//! Following a branch from a start to its ends.

use super::branch::{Branch, Counters, End, Refusal};
use super::event::{Found, Test, Tested, Traced};
use super::problem::Zero;
use super::settings::{Invalid, Settings};
use super::step::{Node, Tracer, distance, hermite};
use crate::dense::dot;
use crate::newton::{Cause, Options};

/// The way to set out from the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Towards larger parameters.
    Up,
    /// Towards smaller parameters.
    Down,
}

/// Follows the branch through the solution near `x0` at the parameter `p0`.
pub fn trace<P: Zero>(
    problem: &mut P,
    x0: &[f64],
    p0: f64,
    direction: Direction,
    settings: &Settings,
    tests: &mut [Test<'_, P>],
) -> Result<Branch, Invalid> {
    one_way(&mut Tested { problem, tests }, x0, p0, direction, settings)
}

/// As [`trace`], compiled once for all problems.
fn one_way(problem: &mut dyn Traced, x0: &[f64], p0: f64, direction: Direction, settings: &Settings) -> Result<Branch, Invalid> {
    settings.check()?;
    if x0.len() != problem.dim() {
        return Err(Invalid("the start must have as many entries as the problem has unknowns"));
    }
    let (lo, hi) = settings.range;
    if !(lo..=hi).contains(&p0) {
        return Err(Invalid("the start must lie in the range of the parameter"));
    }
    let mut tracer = Tracer::new(problem, settings);
    if tracer.scale.iter().any(|s| !(*s > 0.0 && s.is_finite())) {
        return Err(Invalid("scales must be positive"));
    }
    let mut branch = Branch { points: Vec::new(), specials: Vec::new(), first_end: None, end: End::Reached, counters: Counters::default() };
    branch.end = follow(&mut tracer, x0, p0, direction, &mut branch);
    branch.counters = Counters { points: branch.points.len(), work: tracer.solver.work, ..tracer.counters };
    Ok(branch)
}

/// Follows the branch both ways from the start; points run from the end reached downwards to the end reached upwards.
pub fn trace_both<P: Zero>(
    problem: &mut P,
    x0: &[f64],
    p0: f64,
    settings: &Settings,
    tests: &mut [Test<'_, P>],
) -> Result<Branch, Invalid> {
    both_ways(&mut Tested { problem, tests }, x0, p0, settings)
}

fn both_ways(problem: &mut dyn Traced, x0: &[f64], p0: f64, settings: &Settings) -> Result<Branch, Invalid> {
    let mut branch = one_way(problem, x0, p0, Direction::Down, settings)?;
    if branch.end == End::Closed || branch.points.is_empty() {
        return Ok(branch);
    }
    let up = one_way(problem, x0, p0, Direction::Up, settings)?;
    branch.reverse();
    let joint = branch.points.len() - 1;
    branch.first_end = Some(branch.end);
    branch.end = up.end;
    branch.points.extend(up.points.into_iter().skip(1));
    branch.specials.extend(up.specials.into_iter().map(|mut special| {
        special.after += joint;
        special
    }));
    let (a, b) = (&mut branch.counters, &up.counters);
    a.points = branch.points.len();
    a.refused += b.refused;
    a.located += b.located;
    a.undefined_tests += b.undefined_tests;
    a.work.evaluations += b.work.evaluations;
    a.work.jacobians += b.work.jacobians;
    a.work.factorisations += b.work.factorisations;
    a.work.iterations += b.work.iterations;
    Ok(branch)
}

fn follow(tracer: &mut Tracer, x0: &[f64], p0: f64, direction: Direction, branch: &mut Branch) -> End {
    let set = tracer.settings;
    let (lo, hi) = set.range;
    let mut a = Node { y: x0.iter().chain([&p0]).zip(&tracer.scale).map(|(x, s)| x / s).collect(), ..Node::default() };
    if let Err(e) = tracer.correct_at(&mut a, p0, &Options { to_rounding: true, ..Options::default() }) {
        return match e.cause {
            Cause::Cancelled => End::Cancelled,
            cause => End::NewtonFailed { at: p0, residual: e.residual, cause },
        };
    }
    if direction == Direction::Down {
        a.turn();
    }
    if let Err(f) = tracer.monitor(&mut a) {
        return End::NewtonFailed { at: p0, residual: a.evidence.residual, cause: f.into() };
    }
    let start = a.clone();
    let mut values = [Vec::new(), Vec::new()];
    keep(tracer, &a, branch, &mut values);
    if p0 == hi && direction == Direction::Up || p0 == lo && direction == Direction::Down {
        return End::Reached;
    }

    let (mut before, mut b) = (Node::default(), Node::default());
    let (mut predicted, mut ds, mut refusal, mut still) = (Vec::new(), set.first_step, None, 0);
    let mut refusals = 0;
    loop {
        if branch.points.len() >= set.max_points {
            return End::MaxPoints;
        }
        if still > STILL || a.y.iter().any(|y| y.abs() > HOPELESS) {
            // towards an infinite state, as at an undamped resonance: the parameter has stopped moving
            return End::StepTooSmall { at: a.p, why: Refusal::Parameter };
        }
        let cap = tracer.cap(&a);
        if cap < ds || cap.is_nan() {
            ds = cap;
        }
        if ds.is_nan() || ds < set.min_step {
            return End::StepTooSmall { at: a.p, why: refusal.unwrap_or(Refusal::Parameter) };
        }
        predict(&a, &before, ds, refusal.is_none(), &mut b.y);
        predicted.clone_from(&b.y);
        match attempt(tracer, &a, &mut b, &predicted, ds, &start, branch, &mut values) {
            Ok(Advance { grow, end }) => {
                if let Some(end) = end {
                    return end;
                }
                ds *= if refusal.is_some() { grow.min(1.0) } else { grow };
                (refusal, refusals) = (None, 0);
                std::mem::swap(&mut before, &mut a);
                std::mem::swap(&mut a, &mut b);
                still = if (a.p - before.p).abs() <= 1e-12 * a.p.abs() { still + 1 } else { 0 };
            }
            Err(Refusal::Corrector(Cause::Cancelled)) => return End::Cancelled,
            Err(why) => {
                tracer.counters.refused += 1;
                refusals += 1;
                refusal = Some(why);
                if refusals % PATIENCE == 0
                    && let Some(corner) = tracer.corner(&a, 2.0 * ds)
                {
                    let last = branch.points.len() - 1;
                    branch.specials.extend(tracer.corner_specials(&corner, last));
                    [_, a] = corner;
                    before = Node::default();
                    values[1].clear();
                    keep(tracer, &a, branch, &mut values);
                    ds = ds.min(set.first_step);
                } else {
                    ds *= 0.5;
                }
            }
        }
    }
}

/// Unknowns of this many scales lead nowhere.
const HOPELESS: f64 = 1e12;
/// Neither do this many steps in a row that leave the parameter where it was.
const STILL: usize = 50;

/// After this many refusals in a row, and again after as many, a corner is looked for.
const PATIENCE: usize = 2;

/// Point at the distance `ds` along the tangent, bent as it bent since the node before (not after a refusal, nor at the start).
fn predict(a: &Node, before: &Node, ds: f64, bend: bool, y: &mut Vec<f64>) {
    y.clear();
    y.extend(a.y.iter().zip(&a.t).map(|(y, t)| y + ds * t));
    if bend && before.t.len() == a.t.len() {
        let c = 0.5 * ds * ds / (a.s - before.s);
        for ((y, t), t0) in y.iter_mut().zip(&a.t).zip(&before.t) {
            *y += c * (t - t0);
        }
    }
}

struct Advance {
    grow: f64,
    end: Option<End>,
}

/// One step: correct, assess, cut at the edge of the range, look for special points, keep.
#[allow(clippy::too_many_arguments)]
fn attempt(
    tracer: &mut Tracer,
    a: &Node,
    b: &mut Node,
    predicted: &[f64],
    ds: f64,
    start: &Node,
    branch: &mut Branch,
    values: &mut [Vec<f64>; 2],
) -> Result<Advance, Refusal> {
    let set = tracer.settings;
    let o = Options { damped: false, to_rounding: false, ..set.corrector.clone() };
    tracer.correct(b, &a.t, &o).map_err(Refusal::Corrector)?;
    b.s = a.s + distance(&a.y, &b.y);
    tracer.monitor(b).map_err(|f| Refusal::Corrector(f.into()))?;
    let grow = tracer.assess(a, b, predicted, ds)?;
    let after = branch.points.len() - 1;
    let outside = |p: f64| p < set.range.0 || p > set.range.1;
    let nearest = |p: f64| if p > set.range.1 { set.range.1 } else { set.range.0 };

    let mut end = None;
    if outside(b.p) {
        *b = tracer.edge(a, b, nearest(b.p)).ok_or(Refusal::Parameter)?;
        end = Some(End::Reached);
    } else if after > 0 && tracer.closes(a, b, start) {
        let s = a.s + distance(&a.y, &start.y);
        b.copy_from(start);
        b.s = s;
        end = Some(End::Closed);
    }
    let point = tracer.point(b);
    evaluate(tracer, &point, &mut values[1]);
    let mut found = tracer.scan(a, b, after, values)?;
    if let Some(k) = found.iter().position(|f| outside(f.node.p)) {
        // the branch leaves the range and comes back within the step
        let edge = tracer.edge(a, &found[k].node, nearest(found[k].node.p)).ok_or(Refusal::Parameter)?;
        found.retain(|f: &Found| f.node.s < edge.s);
        *b = edge;
        end = Some(End::Reached);
    }
    branch.specials.extend(found.into_iter().map(|f| f.special));
    keep(tracer, b, branch, values);
    Ok(Advance { grow, end })
}

fn evaluate(tracer: &mut Tracer, point: &super::Point, out: &mut Vec<f64>) {
    out.clear();
    for k in 0..tracer.problem.tests() {
        out.push(tracer.problem.test(k, point));
    }
}

/// Stores the node; its test values become those of the left side of the next step.
fn keep(tracer: &mut Tracer, node: &Node, branch: &mut Branch, values: &mut [Vec<f64>; 2]) {
    let point = tracer.point(node);
    let known = branch.points.last().is_some() && values[1].len() == tracer.problem.tests();
    if !known {
        evaluate(tracer, &point, &mut values[1]);
    }
    values.swap(0, 1);
    tracer.counters.undefined_tests += values[0].iter().filter(|v| !v.is_finite()).count();
    branch.points.push(point);
}

impl Tracer<'_> {
    /// The point between `a` and `b` exactly at the parameter `p`.
    fn edge(&mut self, a: &Node, b: &Node, p: f64) -> Option<Node> {
        let (n, h) = (self.n(), distance(&a.y, &b.y));
        let (mut guess, mut u) = (Vec::new(), [0.0, 1.0]);
        let rising = b.p > a.p;
        for _ in 0..50 {
            let middle = 0.5 * (u[0] + u[1]);
            hermite(a, b, h, middle, &mut guess);
            u[usize::from((guess[n] * self.scale[n] > p) == rising)] = middle;
        }
        let o = Options { max_iterations: 15, damped: false, to_rounding: true, ..self.settings.corrector.clone() };
        self.counters.located += 1;
        let mut node = Node { y: guess.clone(), ..Node::default() };
        self.correct_at(&mut node, p, &o).ok()?;
        if distance(&guess, &node.y).is_nan() || distance(&guess, &node.y) > 0.25 * h {
            return None;
        }
        if node.t.iter().zip(&a.y).zip(&b.y).map(|((t, a), b)| t * (b - a)).sum::<f64>() < 0.0 {
            node.turn();
        }
        node.s = a.s + distance(&a.y, &node.y);
        Some(node)
    }

    /// Whether the step from `a` to `b` passes through the start in the direction in which it was left.
    fn closes(&mut self, a: &Node, b: &Node, start: &Node) -> bool {
        let h = distance(&a.y, &b.y);
        let u = a.y.iter().zip(&b.y).zip(&start.y).map(|((a, b), s)| (b - a) * (s - a)).sum::<f64>() / (h * h);
        if !(u > 0.0 && u <= 1.0) || dot(&start.t, &b.t) < 0.8 {
            return false;
        }
        let chord: Vec<f64> = a.y.iter().zip(&b.y).map(|(a, b)| (b - a) / h).collect();
        let mut node = Node::default();
        hermite(a, b, h, u, &mut node.y);
        // into the plane through the start normal to the chord
        let short = chord.iter().zip(&start.y).zip(&node.y).map(|((c, s), y)| c * (s - y)).sum::<f64>();
        node.y.iter_mut().zip(&chord).for_each(|(y, c)| *y += short * c);
        let o = Options { max_iterations: 15, damped: false, to_rounding: true, noise: 1e-13, ..self.settings.corrector.clone() };
        if distance(&node.y, &start.y) > 0.1 * h || self.correct(&mut node, &chord, &o).is_err() {
            return false;
        }
        let size = start.y.iter().fold(1.0, |m: f64, y| m.max(y.abs()));
        distance(&node.y, &start.y) <= 1e-6 * size
    }
}
