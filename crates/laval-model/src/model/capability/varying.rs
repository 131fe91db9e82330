//! Inertia that varies with the configuration.

use super::super::context::{At, Rows};
use super::super::lanes::{Inertial, InertialArgs};
use super::super::params::{Parametric, Params};
use laval_num::lanes::Apply;
use laval_num::scalar::Scalar;

/// A nonlinear part that gives its masses with its residual, which saves an ensemble the differences.
pub trait VaryingInertia: Parametric {
    /// Adds the residual, and to `mass` the change of the force rows per acceleration of each local coordinate (row-major, symmetric).
    fn inertial<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>, mass: &mut [S]);
}

impl<P: VaryingInertia> Apply<P> for Inertial {
    #[inline(always)]
    fn apply<S: Scalar>(part: &P, args: &mut InertialArgs<'_, S>) {
        part.inertial(&part.given(args.p), &args.at, &mut args.out, args.mass);
    }
}

/// The object-safe face.
pub mod erased {
    use super::super::super::lanes::Inertial;
    use laval_num::lanes::Slots;

    /// See the [trait of the author](super::VaryingInertia); called through
    /// [`Entry::enter`](laval_num::lanes::Entry::enter) with [`Inertial`].
    pub trait VaryingInertia: Slots<Inertial> + Send + Sync {}

    impl<T: super::VaryingInertia> VaryingInertia for T {}
}
