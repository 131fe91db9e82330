//! A part in lanes: what ensembles call, one slot for every processor level.
//!
//! Generic code holding a `&dyn Erased` and a lane scalar calls [`Entry::enter`](laval_num::lanes::Entry::enter) with one of the markers below.

use super::blocks::Blocks;
use super::context::{At, Rows};
use laval_num::lanes::{Family, Slots};
use laval_num::scalar::Scalar;

/// Arguments of a residual in lanes, all local to the part; see [`Part::residual`](super::part::Part::residual).
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

/// Arguments of [`VaryingInertia::inertial`](super::capability::VaryingInertia::inertial).
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

/// Arguments of [`Part::linear`](super::part::Part::linear).
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

/// A part that can be called in lanes: every [`Part`](super::part::Part) can.
pub trait InLanes: Slots<Residual> + Slots<Linear> {}
impl<T: Slots<Residual> + Slots<Linear>> InLanes for T {}
