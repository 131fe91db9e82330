//! Parts of many coordinates, or with parameters in the rows of lists.

use super::super::erased::Erased;
use super::super::params::{MOST_LISTS, Parametric, Params, RowCounts};
use std::sync::Arc;

/// A part of many coordinates of which only neighbours are coupled, or with parameters in lists.
pub trait Extent: Parametric {
    /// Local coordinates farther apart than this in their order are not coupled.
    fn reach(&self) -> usize {
        usize::MAX
    }
    /// How many rows the lists with its parameters have ([`WithRows`](super::super::params::WithRows)), in their order.
    fn rows(&self) -> RowCounts {
        [0; MOST_LISTS]
    }
    /// What [`linear`](super::super::part::Part::linear) adds is the same at every speed, but for loads that turn, which grow with its square; the part has no states.
    fn is_steady(&self) -> bool {
        false
    }
    /// The same part with what it computes from its parameters alone kept for these values; other values it computes as before.
    fn prepared(&self, _p: &Params<Self, f64>) -> Option<Arc<dyn Erased>>
    where
        Self: Sized,
    {
        None
    }
}

/// The object-safe face.
pub mod erased {
    use super::super::super::erased::Erased;
    use super::super::super::params::RowCounts;
    use std::sync::Arc;

    /// See the [trait of the author](super::Extent).
    #[allow(missing_docs)]
    pub trait Extent {
        fn reach(&self) -> usize;
        fn rows(&self) -> RowCounts;
        fn is_steady(&self) -> bool;
        fn prepared(&self, p: &[f64]) -> Option<Arc<dyn Erased>>;
    }

    impl<T: super::Extent> Extent for T {
        #[inline(always)]
        fn reach(&self) -> usize {
            super::Extent::reach(self)
        }
        #[inline(always)]
        fn rows(&self) -> RowCounts {
            super::Extent::rows(self)
        }
        fn is_steady(&self) -> bool {
            super::Extent::is_steady(self)
        }
        fn prepared(&self, p: &[f64]) -> Option<Arc<dyn Erased>> {
            super::Extent::prepared(self, &self.given(p))
        }
    }
}
