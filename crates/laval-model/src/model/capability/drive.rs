//! Drives of the spin.

use super::super::params::{Parametric, Params};

/// A part that drives the spin. A part that only supplies power is no drive.
pub trait SpinDrive: Parametric {
    /// Torque at a spin speed (rad/s), N m.
    fn torque(&self, p: &Params<Self, f64>, speed: f64) -> f64;
}

/// The object-safe face.
pub mod erased {

    /// See the [trait of the author](super::SpinDrive).
    #[allow(missing_docs)]
    pub trait SpinDrive {
        fn torque(&self, p: &[f64], speed: f64) -> f64;
    }

    impl<T: super::SpinDrive> SpinDrive for T {
        fn torque(&self, p: &[f64], speed: f64) -> f64 {
            super::SpinDrive::torque(self, &self.given(p), speed)
        }
    }
}
