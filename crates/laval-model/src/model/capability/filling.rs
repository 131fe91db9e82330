//! Liquid that fills a cavity of a body.

use super::super::params::{Parametric, Params};

/// A part that is a liquid in a cavity.
pub trait Filling: Parametric {
    /// The parameter that is its density.
    fn density(&self) -> &'static str;
    /// What damps its waves, as an instruction: `of the liquid's wave: wave_damping`.
    fn damping(&self) -> &'static str;
    /// The parameters that are the radius of the cavity, the radius of the free surface and the height of the cavity, for a drawing.
    fn cavity(&self) -> Option<[&'static str; 3]> {
        None
    }
    /// Mass, kg, and moments of inertia, kg m^2, about the axis of the cavity and about an axis across it through the middle, of the liquid as if it were rigid. What
    /// moves with the body is less.
    fn rigid(&self, p: &Params<Self, f64>) -> Option<[f64; 3]>;
}

/// The object-safe face.
pub mod erased {
    /// See the [trait of the author](super::Filling).
    #[allow(missing_docs)]
    pub trait Filling {
        fn density(&self) -> &'static str;
        fn damping(&self) -> &'static str;
        fn cavity(&self) -> Option<[&'static str; 3]>;
        fn rigid(&self, p: &[f64]) -> Option<[f64; 3]>;
    }

    impl<T: super::Filling> Filling for T {
        fn density(&self) -> &'static str {
            super::Filling::density(self)
        }
        fn damping(&self) -> &'static str {
            super::Filling::damping(self)
        }
        fn cavity(&self) -> Option<[&'static str; 3]> {
            super::Filling::cavity(self)
        }
        fn rigid(&self, p: &[f64]) -> Option<[f64; 3]> {
            super::Filling::rigid(self, &self.given(p))
        }
    }
}
