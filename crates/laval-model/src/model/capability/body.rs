//! Bodies: parts that other parts attach to.

use super::super::erased::Erased;
use super::super::params::{Parametric, Params};
use std::sync::Arc;

/// Names of parameters of a body, where it has them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BodyParameters {
    /// Its mass.
    pub mass: Option<&'static str>,
    /// Its static unbalance.
    pub unbalance: Option<&'static str>,
    /// Stiffness of its own support to the ground.
    pub stiffness: Option<&'static str>,
}

/// A part that other parts attach to; its layout says so too ([`Layout::body`](super::super::part::Layout::body)).
pub trait BodyPart: Parametric {
    /// Rows of the map from the local coordinates to the [`COMPONENTS`](super::super::context::COMPONENTS) of the motion of the point at `position` (m): six
    /// entries for each local coordinate, those of the ports first.
    fn shape(&self, p: &Params<Self, f64>, position: f64) -> Vec<[f64; 6]>;
    /// Positions of the nodes of a body that bends, m, rising; `None` of a rigid body.
    fn nodes(&self) -> Option<Vec<f64>> {
        None
    }
    /// Outline of a body that bends: first and last position of each piece and the outer diameters there, m.
    fn profile(&self, _p: &Params<Self, f64>) -> Vec<[f64; 4]> {
        Vec::new()
    }
    /// A body that bends with nodes at these positions as well; `None` where nothing changes.
    fn divided(&self, _positions: &[f64]) -> Option<Arc<dyn Erased>> {
        None
    }
    /// It turns with the rotor.
    fn turns(&self) -> bool {
        self.parameters().unbalance.is_some()
    }
    /// Of a body that spins with the rotor and has mass: the parameter for its inertia about the axis, while that is 0.
    fn lacks_spin_inertia(&self, _p: &Params<Self, f64>) -> Option<&'static str> {
        None
    }
    /// Of a body that does not tilt and could: the parameter that lets it.
    fn without_tilt(&self) -> Option<&'static str> {
        None
    }
    /// Parameters by meaning.
    fn parameters(&self) -> BodyParameters {
        BodyParameters::default()
    }
}

/// The object-safe face.
pub mod erased {
    use super::super::super::erased::Erased;
    use super::BodyParameters;
    use std::sync::Arc;

    /// See the [trait of the author](super::BodyPart).
    #[allow(missing_docs)]
    pub trait BodyPart {
        fn shape(&self, p: &[f64], position: f64) -> Vec<[f64; 6]>;
        fn nodes(&self) -> Option<Vec<f64>>;
        fn profile(&self, p: &[f64]) -> Vec<[f64; 4]>;
        fn turns(&self) -> bool;
        fn divided(&self, positions: &[f64]) -> Option<Arc<dyn Erased>>;
        fn lacks_spin_inertia(&self, p: &[f64]) -> Option<&'static str>;
        fn without_tilt(&self) -> Option<&'static str>;
        fn parameters(&self) -> BodyParameters;
    }

    impl<T: super::BodyPart> BodyPart for T {
        fn shape(&self, p: &[f64], position: f64) -> Vec<[f64; 6]> {
            super::BodyPart::shape(self, &self.given(p), position)
        }
        fn nodes(&self) -> Option<Vec<f64>> {
            super::BodyPart::nodes(self)
        }
        fn profile(&self, p: &[f64]) -> Vec<[f64; 4]> {
            super::BodyPart::profile(self, &self.given(p))
        }
        fn turns(&self) -> bool {
            super::BodyPart::turns(self)
        }
        fn divided(&self, positions: &[f64]) -> Option<Arc<dyn Erased>> {
            super::BodyPart::divided(self, positions)
        }
        fn lacks_spin_inertia(&self, p: &[f64]) -> Option<&'static str> {
            super::BodyPart::lacks_spin_inertia(self, &self.given(p))
        }
        fn without_tilt(&self) -> Option<&'static str> {
            super::BodyPart::without_tilt(self)
        }
        fn parameters(&self) -> BodyParameters {
            super::BodyPart::parameters(self)
        }
    }
}
