//! Inertia that a part adds to its body or takes from it.

use super::super::params::{Parametric, Params};
use crate::text::Text;

/// Inertia that a part takes from its body.
#[derive(Clone, Debug, PartialEq)]
pub struct Removed {
    /// How much of what, as a sentence without its stop.
    pub what: Text,
    /// What to change where too little is left.
    pub help: Text,
}

/// A part whose added inertia may be negative.
pub trait AddedInertia: Parametric {
    /// What it takes away; the machine is refused where too little inertia is left.
    fn removed(&self, p: &Params<Self, f64>) -> Option<Removed>;
}

/// The object-safe face.
pub mod erased {
    use super::Removed;

    /// See the [trait of the author](super::AddedInertia).
    #[allow(missing_docs)]
    pub trait AddedInertia {
        fn removed(&self, p: &[f64]) -> Option<Removed>;
    }

    impl<T: super::AddedInertia> AddedInertia for T {
        fn removed(&self, p: &[f64]) -> Option<Removed> {
            super::AddedInertia::removed(self, &self.given(p))
        }
    }
}
