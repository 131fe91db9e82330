//! Points of a branch by their place along the chord between two of them.

use super::branch::Point;
use super::event::Tested;
use super::problem::Zero;
use super::settings::Settings;
use super::step::{Node, Tracer, distance};
use crate::dense::dot;
use crate::newton::Options;

/// The chord between two points of a branch: the place of a point is where the plane through it normal to the chord meets the chord, in scaled unknowns
/// and parameter; 0 at the first point, 1 at the second. A branch that turns by less than a right angle between both has one point at each place, folds
/// among them.
#[derive(Clone, Debug)]
pub struct Chord {
    scale: Vec<f64>,
    from: Vec<f64>,
    direction: Vec<f64>,
    length: f64,
}

impl Chord {
    /// From `a` to `b`, unknowns and parameter each. `None` where they are one point.
    pub fn new(problem: &dyn Zero, a: (&[f64], f64), b: (&[f64], f64)) -> Option<Self> {
        let n = problem.dim();
        let mut scale = vec![1.0; n + 1];
        problem.scale(&mut scale[..n]);
        scale[n] = problem.parameter_scale();
        let scaled = |(x, p): (&[f64], f64)| x.iter().chain([&p]).zip(&scale).map(|(x, s)| x / s).collect::<Vec<f64>>();
        let (from, to) = (scaled(a), scaled(b));
        let length = distance(&from, &to);
        let direction = from.iter().zip(&to).map(|(a, b)| (b - a) / length).collect();
        (length > 0.0 && length.is_finite()).then_some(Chord { scale, from, direction, length })
    }

    /// Length in scaled unknowns and parameter.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Place of a point.
    pub fn place(&self, x: &[f64], p: f64) -> f64 {
        let along = x.iter().chain([&p]).zip(&self.scale).zip(&self.from).zip(&self.direction);
        along.map(|(((x, s), from), d)| (x / s - from) * d).sum::<f64>() / self.length
    }

    /// The point of the branch at a place, to rounding, from a guess of its unknowns and parameter. `None` where the corrector fails or strays.
    pub fn point<P: Zero>(&self, problem: &mut P, place: f64, (x, p): (&[f64], f64)) -> Option<Point> {
        let settings = Settings::new(0.0, 1.0);
        let mut tested = Tested { problem, tests: &mut [] };
        let mut tracer = Tracer::new(&mut tested, &settings);
        let mut y: Vec<f64> = x.iter().chain([&p]).zip(&self.scale).map(|(x, s)| x / s).collect();
        // into the plane
        let short = place * self.length - (dot(&y, &self.direction) - dot(&self.from, &self.direction));
        y.iter_mut().zip(&self.direction).for_each(|(y, d)| *y += short * d);
        let guess = y.clone();
        let options = Options { max_iterations: 15, damped: false, to_rounding: true, noise: 1e-13, ..settings.corrector.clone() };
        let mut node = Node { y, ..Node::default() };
        tracer.correct(&mut node, &self.direction, &options).ok()?;
        node.s = place * self.length;
        (distance(&guess, &node.y) <= 0.25 * self.length).then(|| tracer.point(&node))
    }
}
