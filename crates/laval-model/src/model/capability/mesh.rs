//! Two wheels in mesh on parallel axes.

use super::super::params::{Parametric, Params};

/// Two wheels, the first at the first port of their part and the second at the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheels {
    /// Pitch radius of each, m.
    pub radii: [f64; 2],
    /// Direction from the axis of the first to that of the second, rad from x.
    pub azimuth: f64,
}

impl Wheels {
    /// From the axis of the first to that of the second, m.
    pub fn centres(&self) -> [f64; 2] {
        let (sin, cos) = self.azimuth.sin_cos();
        let distance = self.radii[0] + self.radii[1];
        [distance * cos, distance * sin]
    }
}

/// A part that joins two wheels on parallel axes.
pub trait Mesh: Parametric {
    /// Their sizes and where they lie.
    fn wheels(&self, p: &Params<Self, f64>) -> Wheels;
}

/// The object-safe face.
pub mod erased {
    use super::Wheels;

    /// See the [trait of the author](super::Mesh).
    #[allow(missing_docs)]
    pub trait Mesh {
        fn wheels(&self, p: &[f64]) -> Wheels;
    }

    impl<T: super::Mesh> Mesh for T {
        fn wheels(&self, p: &[f64]) -> Wheels {
            super::Mesh::wheels(self, &self.given(p))
        }
    }
}
