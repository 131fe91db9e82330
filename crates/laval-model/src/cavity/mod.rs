//! Reaction of a liquid in a cylindrical cavity that turns with the rotor, on motions of the cavity: exact in the frequency domain.
//!
//! Equations: all motions as `exp(i w t)`, in the forward coordinates `Q = x + i y` of the cavity's centre and `theta = alpha + i beta`, the rotation
//! vector; `sigma = w - W` is the frequency in rotor axes. About the centre of the cavity the reaction is diagonal,
//!
//! ```text
//! F = L0(w) Q,   M = Lt(w) theta;   conjugate coordinates see L(-conj w)
//! ```
//!
//! Symbols: R radius of the cavity, r0 of the free surface, H height, m; rho density, kg/m^3; nu kinematic viscosity, m^2/s; W spin speed, rad/s;
//! kappa = pi k/H axial wave number of harmonic k = 1, 3, 5, ..., 1/m.
//!
//! Validity: small motions of a layer that rotation holds on the wall (W^2 r0 above gravity), rigid cavity without baffles, constant speed. An ideal
//! liquid has a dense set of inertial waves at real w with |sigma| < 2 W: there Lt means nothing at real w. The viscous form has free-slip ends.
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#conventions`.
//!
//! Sources: `001_352384e7bf252e35` equations (7)-(34), corrected.

mod damped;
mod ideal;
pub mod layer;
pub mod line;
pub mod rational;
mod sum;
mod viscous;
pub mod waves;

pub use ideal::Truncation;
pub use sum::Total;

use laval_num::complex::Complex;
use laval_num::lanes::LaneScalar;
use laval_num::scalar::Scalar;
use std::f64::consts::PI;

/// Size and filling of a cavity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cavity<S> {
    /// R, m.
    pub radius: S,
    /// r0, m; above 0, below R.
    pub free: S,
    /// H, m.
    pub height: S,
    /// rho, kg/m^3.
    pub density: S,
}

/// Lt with what it cost and how far it may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tilt<S> {
    /// Moment per tilt, N m/rad.
    pub value: Complex<S>,
    /// Axial harmonics evaluated.
    pub harmonics: usize,
    /// Estimate of the error, N m/rad; infinite where the sum has no meaning: at real w in the dense range of inertial waves.
    pub error: f64,
}

impl<S: Scalar> Cavity<S> {
    /// The same cavity in every lane.
    #[inline(always)]
    fn spread<L: LaneScalar>(&self) -> Cavity<S::Over<L>> {
        let Cavity { radius, free, height, density } = *self;
        Cavity { radius: radius.spread::<L>(), free: free.spread::<L>(), height: height.spread::<L>(), density: density.spread::<L>() }
    }
    /// Mass that would fill the cavity, kg.
    pub fn full_mass(&self) -> S {
        (self.radius.square() * self.height * self.density).scale(PI)
    }
    /// `H^2/12`: what turns L0 into the tilt reaction of slices that do not feel each other, m^2.
    #[inline(always)]
    pub fn slices(&self) -> S {
        self.height.square().scale(1.0 / 12.0)
    }
    /// `pi rho`.
    fn column(&self) -> S {
        self.density.scale(PI)
    }
    /// `R^2 H^3/12 - H (R^4 - r0^4)/4`, m^5.
    #[inline(always)]
    pub(crate) fn mean(&self) -> S {
        let (r2, s2) = (self.radius.square(), self.free.square());
        self.height * ((r2 * self.height.square()).scale(1.0 / 12.0) - (r2 * r2 - s2 * s2).scale(0.25))
    }
    /// Tilt reaction of the pressure that does not need axial flow (k = 0), N m/rad: `-pi rho w (w - 2 W) [R^2 H^3/12 - H (R^4 - r0^4)/4]`.
    pub fn mean_tilt(&self, w: Complex<S>, speed: S) -> Complex<S> {
        let two = Complex::real(speed.scale(2.0));
        -(w * (w - two)).scale(self.column() * self.mean())
    }
}
