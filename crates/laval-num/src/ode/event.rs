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
