//! Masses that move in the rotor: balls of a balancer.

use super::super::context::At;
use super::super::params::{Parametric, Params};

/// What a part that balances automatically does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// Moment of its movable masses in the rotating frame, kg m.
    pub moment: [f64; 2],
    /// The largest moment they can have, kg m.
    pub capacity: f64,
    /// Largest force (N; of angles N m) with which they push each other; zero where none touch.
    pub contact: f64,
}

/// A circle by which a part with movable masses is drawn: a track, a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Short name, for instance `ball 1`.
    pub name: String,
    /// Displacement of the carrier in the stationary frame, m: small, drawn enlarged.
    pub displacement: [f64; 2],
    /// Centre relative to it in the stationary frame, m: drawn to scale.
    pub place: [f64; 2],
    /// Radius, m.
    pub radius: f64,
    /// A movable mass, not its track.
    pub movable: bool,
}

/// A part with movable masses.
pub trait MovableMasses: Parametric {
    /// Their effect on the unbalance.
    fn correction(&self, p: &Params<Self, f64>, at: &At<f64>) -> Option<Correction>;
    /// Initial values of own coordinates where none are given: local coordinate and value; others are 0.
    fn places(&self, _p: &Params<Self, f64>) -> Vec<(usize, f64)> {
        Vec::new()
    }
    /// Dry friction on own coordinates at rest: local coordinate, and the largest force (N; of an angle N m) that it holds.
    fn grip(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<(usize, f64)>) {}
    /// Circles to draw, seen along the axis.
    fn outlines(&self, _p: &Params<Self, f64>, _at: &At<f64>) -> Vec<Outline> {
        Vec::new()
    }
}

/// The object-safe face.
pub mod erased {
    use super::super::super::context::At;
    use super::{Correction, Outline};

    /// See the [trait of the author](super::MovableMasses).
    #[allow(missing_docs)]
    pub trait MovableMasses {
        fn correction(&self, p: &[f64], at: &At<f64>) -> Option<Correction>;
        fn places(&self, p: &[f64]) -> Vec<(usize, f64)>;
        fn grip(&self, p: &[f64], at: &At<f64>, out: &mut Vec<(usize, f64)>);
        fn outlines(&self, p: &[f64], at: &At<f64>) -> Vec<Outline>;
    }

    impl<T: super::MovableMasses> MovableMasses for T {
        fn correction(&self, p: &[f64], at: &At<f64>) -> Option<Correction> {
            super::MovableMasses::correction(self, &self.given(p), at)
        }
        fn places(&self, p: &[f64]) -> Vec<(usize, f64)> {
            super::MovableMasses::places(self, &self.given(p))
        }
        fn grip(&self, p: &[f64], at: &At<f64>, out: &mut Vec<(usize, f64)>) {
            super::MovableMasses::grip(self, &self.given(p), at, out);
        }
        fn outlines(&self, p: &[f64], at: &At<f64>) -> Vec<Outline> {
            super::MovableMasses::outlines(self, &self.given(p), at)
        }
    }
}
