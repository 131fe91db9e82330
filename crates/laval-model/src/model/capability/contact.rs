//! Gaps, and surfaces in the state where a force law changes.

use super::super::context::At;
use super::super::params::{Parametric, Params};
use crate::text::Text;

/// A part with a gap, or with a force law that is not smooth.
pub trait Contacts: Parametric {
    /// Width of the gap at a state, m; negative in contact. `None` for a part without a gap.
    fn clearance(&self, _p: &Params<Self, f64>, _at: &At<f64>) -> Option<f64> {
        None
    }
    /// Why the part cannot be linearised where it carries no load, as a sentence that names what is missing. A part with an open
    /// [`clearance`](Self::clearance) is linearised nevertheless where other parts hold what it joins.
    fn refuses_rest(&self, _p: &Params<Self, f64>) -> Option<Text> {
        None
    }
    /// Surfaces in the state where the force law changes: zero on the surface. Integration in time stops on them.
    fn switches(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<f64>) {}
}

/// The object-safe face.
pub mod erased {
    use super::super::super::context::At;
    use crate::text::Text;

    /// See the [trait of the author](super::Contacts).
    #[allow(missing_docs)]
    pub trait Contacts {
        fn clearance(&self, p: &[f64], at: &At<f64>) -> Option<f64>;
        fn refuses_rest(&self, p: &[f64]) -> Option<Text>;
        fn switches(&self, p: &[f64], at: &At<f64>, out: &mut Vec<f64>);
    }

    impl<T: super::Contacts> Contacts for T {
        fn clearance(&self, p: &[f64], at: &At<f64>) -> Option<f64> {
            super::Contacts::clearance(self, &self.given(p), at)
        }
        fn refuses_rest(&self, p: &[f64]) -> Option<Text> {
            super::Contacts::refuses_rest(self, &self.given(p))
        }
        fn switches(&self, p: &[f64], at: &At<f64>, out: &mut Vec<f64>) {
            super::Contacts::switches(self, &self.given(p), at, out);
        }
    }
}
