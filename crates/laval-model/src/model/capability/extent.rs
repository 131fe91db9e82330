//! Parts of many coordinates.

use super::super::params::Parametric;

/// A part of many coordinates of which only neighbours are coupled.
pub trait Extent: Parametric {
    /// Local coordinates farther apart than this in their order are not coupled.
    fn reach(&self) -> usize;
}

/// The object-safe face.
pub mod erased {
    /// See the [trait of the author](super::Extent).
    #[allow(missing_docs)]
    pub trait Extent {
        fn reach(&self) -> usize;
    }

    impl<T: super::Extent> Extent for T {
        fn reach(&self) -> usize {
            super::Extent::reach(self)
        }
    }
}
