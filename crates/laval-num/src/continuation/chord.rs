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

#[cfg(test)]
mod tests {
    use super::super::Failure;
    use super::*;
    use crate::dense::Mat;

    /// `x^2 + (p/3)^2 = 1`.
    struct Ellipse;

    impl Zero for Ellipse {
        fn dim(&self) -> usize {
            1
        }
        fn scale(&self, out: &mut [f64]) {
            out.fill(1.0);
        }
        fn parameter_scale(&self) -> f64 {
            3.0
        }
        fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
            r[0] = x[0] * x[0] + p * p / 9.0 - 1.0;
            if let Some(jac) = jac {
                jac[(0, 0)] = 2.0 * x[0];
            }
            if let Some(dr_dp) = dr_dp {
                dr_dp[0] = 2.0 * p / 9.0;
            }
            Ok(())
        }
    }

    #[test]
    fn every_place_has_its_point_also_at_a_fold() {
        // a circle in scaled unknowns: the chord between the angles -40 and 40 degrees about the fold at p = 3
        let at = |angle: f64| ([angle.to_radians().sin()], 3.0 * angle.to_radians().cos());
        let (a, b) = (at(-40.0), at(40.0));
        let chord = Chord::new(&Ellipse, (&a.0, a.1), (&b.0, b.1)).unwrap();
        assert!((chord.length() - 2.0 * 40f64.to_radians().sin()).abs() < 1e-15);
        for angle in [-50.0, -40.0, -13.0, 0.0, 25.0, 40.0] {
            let (x, p) = at(angle);
            let place = chord.place(&x, p);
            assert!((place - 0.5 - 0.5 * angle.to_radians().sin() / 40f64.to_radians().sin()).abs() < 1e-15);
            let found = chord.point(&mut Ellipse, place, (&[x[0] + 0.05], p - 0.2)).unwrap();
            assert!((found.x[0] - x[0]).abs() < 1e-14 && (found.p - p).abs() < 1e-14, "{angle}: {found:?}");
        }
        assert!(Chord::new(&Ellipse, (&a.0, a.1), (&a.0, a.1)).is_none());
        // beyond the circle no point has this place
        assert!(chord.point(&mut Ellipse, 1.4, (&[1.0], 0.0)).is_none());
    }
}
