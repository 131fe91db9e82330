//! The number a formula is written in: `f64`, an exact derivative ([`crate::dual::Dual`]), several members at once
//! ([`crate::lanes`]), or derivatives of several members.
//!
//! A formula written once over [`Scalar`] serves all of them. Branches on the state are written with [`Scalar::pos`]
//! and [`Scalar::select_pos`], so that lanes work and switching surfaces stay visible.

use crate::analytic::Analytic;
use crate::complex::Complex;
use crate::lanes::{LaneScalar, Routine, apart};
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A real number, possibly with derivatives, possibly in lanes.
///
/// All methods are pure. Functions with a root or a kink at zero have finite derivatives there (the limit from the unloaded side, zero),
/// because an unloaded contact evaluates `0 * sqrt(0)`.
pub trait Scalar:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// What carries no derivatives: `f64`, or lanes of it.
    type Base: Scalar<Base = Self::Base>;
    /// The same number with lanes in the place of `f64`; of a number that is in lanes already, those lanes alone.
    type Over<L: LaneScalar>: Scalar<Base = L>;
    /// It pays to evaluate a formula for several arguments in lanes: few derivatives, and no lanes yet.
    const SPREADS: bool;
    /// The number without its derivatives.
    fn base(self) -> Self::Base;
    /// The constant `x` (all derivatives zero), each lane its own.
    fn constant(x: Self::Base) -> Self;
    /// The same number in every lane; not a number where it is in lanes already.
    fn spread<L: LaneScalar>(self) -> Self::Over<L>;
    /// The number in a lane.
    fn lane<L: LaneScalar>(of: Self::Over<L>, lane: usize) -> Self;
    /// The constant `x` (all derivatives zero, the same in every lane).
    fn cst(x: f64) -> Self;
    /// `sin` and `cos` in radians.
    fn sin_cos(self) -> (Self, Self);
    /// `sin` and `cos` of so many quarter turns: cheaper where the angle is known so.
    #[inline(always)]
    fn sin_cos_quarters(self) -> (Self, Self) {
        self.scale(std::f64::consts::FRAC_PI_2).sin_cos()
    }
    /// Square root; the derivative at 0 is 0.
    fn sqrt(self) -> Self;
    /// Natural exponential.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Angle of the point `(x, self)`, in (-pi, pi].
    fn atan2(self, x: Self) -> Self;
    /// `max(self, 0)`; the derivative at 0 is 0.
    fn pos(self) -> Self;
    /// `max(self, 0)^p`; value and derivative are 0 for `self <= 0` when `p > 1`.
    fn pow_pos(self, p: f64) -> Self;
    /// `then` where `self > 0`, `other` elsewhere.
    fn select_pos(self, then: Self, other: Self) -> Self;
    /// The number without its derivatives, to choose between ways of computing the same function (how many terms, which pivot), never for a
    /// branch of a law. NaN of lanes that differ.
    fn value(self) -> f64;
    /// Zero in every lane and constant: terms that it multiplies may be left out.
    #[inline(always)]
    fn is_nothing(self) -> bool {
        false
    }
    /// Calls a routine with the instructions of this number, as a function of its own.
    fn apart<R: Routine>(routine: R) -> R::Out;
    /// Analytic functions of a complex argument.
    fn analytic<const N: usize, F: Analytic<N>>(z: Complex<Self>) -> [Complex<Self>; N];
    /// Multiplication by a constant, cheaper than lifting it.
    #[inline(always)]
    fn scale(self, k: f64) -> Self {
        self * Self::cst(k)
    }
    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::cst(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::cst(1.0)
    }
    /// `self o - product` of the rounded product: exact, where nothing overflows or is subnormal. Of the number without its derivatives.
    fn product_error(self, o: Self, product: Self) -> Self;
    /// `self * self`.
    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }
    /// Absolute value; the derivative at 0 is 0.
    #[inline(always)]
    fn abs(self) -> Self {
        self.pos() + (-self).pos()
    }
    /// Length of the plane vector `(self, y)`; the derivative at the origin is 0.
    #[inline(always)]
    fn norm2(self, y: Self) -> Self {
        (self * self + y * y).sqrt()
    }
    /// Sine.
    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// Cosine.
    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
}

impl Scalar for f64 {
    type Base = f64;
    type Over<L: LaneScalar> = L;
    const SPREADS: bool = true;
    #[inline(always)]
    fn apart<R: Routine>(routine: R) -> R::Out {
        apart(routine)
    }
    #[inline(always)]
    fn base(self) -> f64 {
        self
    }
    #[inline(always)]
    fn constant(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn spread<L: LaneScalar>(self) -> L {
        L::cst(self)
    }
    #[inline(always)]
    fn lane<L: LaneScalar>(of: L, lane: usize) -> f64 {
        of.get(lane)
    }
    #[inline(always)]
    fn is_nothing(self) -> bool {
        self == 0.0
    }
    #[inline(always)]
    fn cst(x: f64) -> Self {
        x
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        crate::lanes::math::sin_cos(self)
    }
    #[inline]
    fn sin_cos_quarters(self) -> (Self, Self) {
        crate::lanes::math::sin_cos_quarters(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline]
    fn exp(self) -> Self {
        crate::lanes::math::exp(self)
    }
    #[inline]
    fn ln(self) -> Self {
        crate::lanes::math::ln(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        crate::lanes::math::atan2(self, x)
    }
    #[inline(always)]
    fn pos(self) -> Self {
        // not f64::max: that would turn NaN into 0
        crate::lanes::math::pos(self)
    }
    #[inline]
    fn pow_pos(self, p: f64) -> Self {
        crate::lanes::pow_pos(self, p)
    }
    #[inline(always)]
    fn select_pos(self, then: Self, other: Self) -> Self {
        if self > 0.0 { then } else { other }
    }
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }
    #[inline(always)]
    fn analytic<const N: usize, F: Analytic<N>>(z: Complex<Self>) -> [Complex<Self>; N] {
        F::value(z)
    }
    #[inline(always)]
    fn scale(self, k: f64) -> Self {
        self * k
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn product_error(self, o: Self, product: Self) -> Self {
        crate::lanes::Reg::product_error(self, o, product)
    }
}
