//! Parts of many coordinates, or with parameters in the rows of a list.

use super::super::params::Parametric;

/// A part of many coordinates of which only neighbours are coupled, or with parameters in a list.
pub trait Extent: Parametric {
    /// Local coordinates farther apart than this in their order are not coupled.
    fn reach(&self) -> usize {
        usize::MAX
    }
    /// Rows of the list that holds parameters ([`Family::LIST`](super::super::params::Family::LIST)).
    fn rows(&self) -> usize {
        0
    }
}

/// The object-safe face.
pub mod erased {
    /// See the [trait of the author](super::Extent).
    #[allow(missing_docs)]
    pub trait Extent {
        fn reach(&self) -> usize;
        fn rows(&self) -> usize;
    }

    impl<T: super::Extent> Extent for T {
        fn reach(&self) -> usize {
            super::Extent::reach(self)
        }
        fn rows(&self) -> usize {
            super::Extent::rows(self)
        }
    }
}
