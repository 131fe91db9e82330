//! Leaving a branch: points of the branch that crosses it at a branch point, and zeros of a function between two of its points.
//!
//! At a simple branch point the `n` by `n + 1` Jacobian [dr/dx dr/dp] has two null vectors: the tangent t, and a second v normal to it. A point of the
//! crossing branch lies near `y0 + d v`; Newton's method in the hyperplane normal to v through it cannot fall back on the branch left.

use super::Kind;
use super::branch::{Point, Special};
use super::event::{Test, Tested, Traced};
use super::problem::Zero;
use super::settings::{Invalid, Settings};
use super::step::{Node, Tracer, distance, extended};
use super::trace::Direction;
use crate::dense::{Lu, Mat, dot, norm};
use crate::newton::Options;

/// A point beside a branch point on the crossing branch, and the way to set out from it, away from the branch point.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Parameter.
    pub p: f64,
    /// Away from the branch point.
    pub direction: Direction,
    /// The second null vector, of unit length in scaled unknowns, in the problem's own units: the way the unknowns leave the branch.
    pub null_vector: Vec<f64>,
}

/// Distances from the branch point that are tried, in scaled unknowns, relative to their length where that exceeds one.
const DISTANCES: [f64; 4] = [2e-2, 5e-3, 1e-3, 1e-4];

/// The crossing branch on both sides of the branch point at `point`, which carries the tangent of the branch it lies on.
pub fn cross<P: Zero>(problem: &mut P, point: &Point, settings: &Settings) -> Result<Vec<Crossing>, Invalid> {
    beside(&mut Tested { problem, tests: &mut [] }, point, settings)
}

fn beside(problem: &mut dyn Traced, point: &Point, settings: &Settings) -> Result<Vec<Crossing>, Invalid> {
    settings.check()?;
    let mut tracer = Tracer::new(problem, settings);
    let origin = tracer.node(point);
    let n = tracer.n();
    let Some((v, _)) = tracer.second_null_vectors(&origin) else { return Ok(Vec::new()) };
    let size = norm(&origin.y[..n]).max(1.0);
    let options = Options { max_iterations: 15, damped: false, to_rounding: true, noise: 1e-13, ..settings.corrector.clone() };
    let mut out = Vec::new();
    for sign in [1.0, -1.0] {
        for reach in DISTANCES {
            let d = sign * reach * size;
            let guess: Vec<f64> = origin.y.iter().zip(&v).map(|(y, v)| y + d * v).collect();
            let mut node = Node { y: guess.clone(), ..Node::default() };
            let near = tracer.correct(&mut node, &v, &options).is_ok() && distance(&node.y, &guess) <= 0.5 * d.abs();
            if !near || !(settings.range.0..=settings.range.1).contains(&node.p) {
                continue;
            }
            let away = if dot(&node.t, &v) * sign < 0.0 { -1.0 } else { 1.0 };
            let direction = if away * node.slope() < 0.0 { Direction::Down } else { Direction::Up };
            let own = |y: &[f64]| y[..n].iter().zip(&tracer.scale).map(|(y, s)| y * s).collect::<Vec<f64>>();
            out.push(Crossing { x: own(&node.y), p: node.p, direction, null_vector: own(&v) });
            break;
        }
    }
    Ok(out)
}

/// The zero of `g` between two neighbouring points of a branch, where it has the values `ends`, on corrected points in between; its kind is
/// `Kind::User(0)`.
pub fn zero_between<P: Zero>(
    problem: &mut P,
    points: [&Point; 2],
    ends: [f64; 2],
    settings: &Settings,
    mut g: impl FnMut(&mut P, &Point) -> f64,
) -> Result<Special, Invalid> {
    let mut test: [Test<'_, P>; 1] = [Box::new(&mut g)];
    between(&mut Tested { problem, tests: &mut test }, points, ends, settings)
}

fn between(problem: &mut dyn Traced, points: [&Point; 2], ends: [f64; 2], settings: &Settings) -> Result<Special, Invalid> {
    settings.check()?;
    let mut tracer = Tracer::new(problem, settings);
    let [a, b] = points.map(|p| tracer.node(p));
    let zero = tracer.locate(&a, &b, ends, &mut |tracer, node| {
        let point = tracer.point(node);
        tracer.problem.test(0, &point)
    });
    Ok(tracer.found(zero, Kind::User(0), ends, 0).special)
}

impl Tracer<'_> {
    /// The node of a point.
    fn node(&self, point: &Point) -> Node {
        let n = self.n();
        let scaled = |x: &[f64], p: f64| x.iter().chain([&p]).zip(&self.scale).map(|(x, s)| x / s).collect::<Vec<f64>>();
        Node {
            y: scaled(&point.x, point.p),
            t: scaled(&point.dx_ds, point.dp_ds),
            s: point.s,
            p: point.p,
            determinant: point.determinant,
            weight: vec![1.0; n + 1],
            ..Node::default()
        }
    }

    /// The right and the left singular vector of the least singular value of the Jacobian with the tangent as last row, by inverse iteration; of the left
    /// one the part that belongs to the equations, weighed by the lengths of their rows.
    pub(super) fn second_null_vectors(&mut self, at: &Node) -> Option<(Vec<f64>, Vec<f64>)> {
        let n = self.n();
        let length = norm(&at.t);
        let mut shift = 0.0;
        for _ in 0..4 {
            // exactly on the branch point the matrix has no inverse: beside it will do
            let y: Vec<f64> = at.y.iter().zip(&at.t).map(|(y, t)| y + shift * t).collect();
            shift = (10.0 * shift).max(1e-10 * norm(&at.y).max(1.0));
            let (mut b, mut r) = (Mat::zeros(n + 1, n + 1), vec![0.0; n + 1]);
            extended(self.problem, &self.scale, &y, &mut self.scratch, &mut r, Some(&mut b)).ok()?;
            for i in 0..n {
                let weight = norm(b.row(i));
                b.row_mut(i).iter_mut().for_each(|x| *x /= weight);
            }
            b.row_mut(n).iter_mut().zip(&at.t).for_each(|(b, t)| *b = t / length);
            let (Ok(lu), Ok(transposed)) = (Lu::new(&b), Lu::new(&b.transpose())) else { continue };
            let mut v: Vec<f64> = (0..=n).map(|i| 1.0 + 0.3 * (1.7 * i as f64).sin()).collect();
            let mut left = Vec::new();
            for _ in 0..8 {
                let before = norm(&v);
                v.iter_mut().for_each(|x| *x /= before);
                transposed.solve(&mut v);
                left.clone_from(&v);
                lu.solve(&mut v);
            }
            let size = norm(&v);
            if !(size.is_finite() && size > 0.0) {
                continue;
            }
            v.iter_mut().for_each(|x| *x /= size);
            // normal to the tangent, by which the iteration is blind on the shifted point only to rounding
            let along = dot(&v, &at.t) / (length * length);
            v.iter_mut().zip(&at.t).for_each(|(v, t)| *v -= along * t);
            let size = norm(&v);
            v.iter_mut().for_each(|x| *x /= size);
            left.truncate(n);
            let size = norm(&left);
            left.iter_mut().for_each(|x| *x /= size);
            return (size.is_finite() && size > 0.0).then_some((v, left));
        }
        None
    }
}
