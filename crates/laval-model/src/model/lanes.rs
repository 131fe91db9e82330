//! A part in lanes: what ensembles call, one slot for every processor level.
//!
//! Generic code holding a `&dyn Erased` and a lane scalar calls [`Entry::enter`](laval_num::lanes::Entry::enter) with one of the markers below.

use super::blocks::Blocks;
use super::capability::VaryingInertia;
use super::params::Family as _;
use super::part::{At, Part, Physics, Rows};
use laval_num::lanes::{Apply, Family, Slots};
use laval_num::scalar::Scalar;

/// Arguments of a residual in lanes, all local to the part; see [`Part::residual`].
pub struct ResidualArgs<'a, S> {
    /// Parameters.
    pub p: &'a [S],
    /// Point.
    pub at: At<'a, S>,
    /// Where the share is added.
    pub out: Rows<'a, S>,
}

/// What is not in the blocks: the residual of a nonlinear part, the spin row of a linear one.
pub struct Residual;
impl Family for Residual {
    type Args<'a, S: Scalar> = ResidualArgs<'a, S>;
}
impl<P: Part> Apply<P> for Residual {
    #[inline(always)]
    fn apply<S: Scalar>(part: &P, args: &mut ResidualArgs<'_, S>) {
        let p = P::Family::from_slice(args.p);
        part.residual(&p, &args.at, &mut args.out);
        if part.physics() != Physics::Nonlinear {
            *args.out.spin += part.spin_row(&p, &args.at);
        }
    }
}

/// Arguments of [`VaryingInertia::inertial`].
pub struct InertialArgs<'a, S> {
    /// Parameters.
    pub p: &'a [S],
    /// Point.
    pub at: At<'a, S>,
    /// Where the share is added.
    pub out: Rows<'a, S>,
    /// Where the masses are added.
    pub mass: &'a mut [S],
}

/// The residual of a nonlinear part with its masses, where it gives them.
pub struct Inertial;
impl Family for Inertial {
    type Args<'a, S: Scalar> = InertialArgs<'a, S>;
}
impl<P: VaryingInertia> Apply<P> for Inertial {
    #[inline(always)]
    fn apply<S: Scalar>(part: &P, args: &mut InertialArgs<'_, S>) {
        part.inertial(&P::Family::from_slice(args.p), &args.at, &mut args.out, args.mass);
    }
}

/// Arguments of [`Part::linear`].
pub struct LinearArgs<'a, S> {
    /// Parameters.
    pub p: &'a [S],
    /// Spin speed, rad/s.
    pub speed: S,
    /// Blocks, reset to the part's size by the caller.
    pub blocks: &'a mut Blocks<S>,
}

/// The blocks of a linear part.
pub struct Linear;
impl Family for Linear {
    type Args<'a, S: Scalar> = LinearArgs<'a, S>;
}
impl<P: Part> Apply<P> for Linear {
    #[inline(always)]
    fn apply<S: Scalar>(part: &P, args: &mut LinearArgs<'_, S>) {
        part.linear(&P::Family::from_slice(args.p), args.speed, args.blocks);
    }
}

/// A part that can be called in lanes: every [`Part`] can.
pub trait InLanes: Slots<Residual> + Slots<Linear> {}
impl<P: Part> InLanes for P {}
