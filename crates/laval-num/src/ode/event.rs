//! Events: zeros of scalar functions g(t, y) along the solution.

/// Which crossings count, seen along the direction of integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// All.
    #[default]
    Any,
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
}

/// A function of time and state whose zeros are located.
///
/// g is probed at four equally spaced points of every step; a crossing is a change of sign between two probes, or a probe where g is exactly
/// zero after it was not. Two crossings between neighbouring probes cancel and are not seen: limit the step if g varies faster than the solution.
#[derive(Clone, Copy)]
pub struct Event<'a> {
    pub(super) g: &'a dyn Fn(f64, &[f64]) -> f64,
    pub(super) direction: Direction,
    pub(super) terminal: bool,
}

impl<'a> Event<'a> {
    /// All zeros of `g(t, y)`; the integration goes on.
    pub fn new(g: &'a dyn Fn(f64, &[f64]) -> f64) -> Self {
        Event { g, direction: Direction::Any, terminal: false }
    }
    /// Only crossings in this direction.
    pub fn direction(self, direction: Direction) -> Self {
        Event { direction, ..self }
    }
    /// The first crossing ends the integration.
    pub fn terminal(self) -> Self {
        Event { terminal: true, ..self }
    }
    /// The direction in which g goes from `a` to `b`, if that is a crossing that counts.
    pub(super) fn crossing(&self, a: f64, b: f64) -> Option<Direction> {
        let way = match (a, b) {
            (a, b) if a < 0.0 && b >= 0.0 => Direction::Rising,
            (a, b) if a > 0.0 && b <= 0.0 => Direction::Falling,
            _ => return None,
        };
        (self.direction == Direction::Any || self.direction == way).then_some(way)
    }
}

/// A located crossing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Index in [`super::Control::events`].
    pub index: usize,
    /// When: the end of the bracket, where g has reached its new sign (or is zero), so that a run continued from here does not meet it again.
    pub t: f64,
    /// Two times a few roundings apart: g has its old sign at the first and its new sign, or zero, at the second.
    pub bracket: (f64, f64),
    /// `Rising` or `Falling`.
    pub direction: Direction,
}

/// Narrows a bracket of a zero of `g` to a few roundings of t, `ga` and `gb` having opposite signs (`gb` may be zero). `None` if g is NaN.
///
/// Interpolation, truncation, projection (Oliveira, Takahashi 2021): superlinear, and never more evaluations than bisection plus one.
pub(crate) fn bracket(mut a: f64, mut ga: f64, mut b: f64, mut gb: f64, mut g: impl FnMut(f64) -> f64) -> Option<(f64, f64)> {
    let tol = 2.0 * f64::EPSILON * a.abs().max(b.abs());
    let width = (b - a).abs();
    let mut r = tol * 2f64.powf((width / (2.0 * tol)).log2().ceil().max(0.0) + 1.0);
    let k = 0.2 / width;
    while (b - a).abs() > 2.0 * tol {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a).abs());
        let reach = r - half;
        r *= 0.5;
        let secant = (gb * a - ga * b) / (gb - ga);
        let toward = (middle - secant).signum();
        let shift = k * (b - a) * (b - a);
        let t = if shift <= (middle - secant).abs() { secant + toward * shift } else { middle };
        let x = if (t - middle).abs() <= reach { t } else { middle - toward * reach };
        // also when the values are infinite and the secant is not a number
        let x = if (x - a) * (x - b) < 0.0 { x } else { middle };
        if x == a || x == b {
            break;
        }
        let gx = g(x);
        if gx.is_nan() {
            return None;
        }
        if gx != 0.0 && (gx > 0.0) == (ga > 0.0) {
            (a, ga) = (x, gx);
        } else {
            (b, gb) = (x, gx);
        }
    }
    Some((a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_are_narrow_and_hold_the_zero() {
        let mut calls = 0;
        for (a, b, f) in [
            (0.0, 1.0, &(|x: f64| x - 0.3) as &dyn Fn(f64) -> f64),
            (2.0, -1.0, &|x: f64| x.powi(9) - 1e-9),
            (-1.0, 4.0, &|x: f64| (x - 0.1).cbrt()),
            (1.0, 2.0, &|x: f64| if x < 1.7 { -1.0 } else { f64::INFINITY }),
            (100.0, 101.0, &|x: f64| (x - 100.0).exp() - 2.0),
            (0.0, 1.0, &|x: f64| if x <= 0.5 { -1.0 } else { 0.0 }),
        ] {
            let (x, y) = bracket(a, f(a), b, f(b), |x| {
                calls += 1;
                f(x)
            })
            .unwrap();
            assert!((y - x).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs()));
            assert!(f(x) * f(a) > 0.0 && f(y) * f(a) <= 0.0, "{x} {y}");
        }
        assert!(calls <= 6 * 54);
        assert_eq!(bracket(0.0, -1.0, 1.0, 1.0, |_| f64::NAN), None);
    }
}
