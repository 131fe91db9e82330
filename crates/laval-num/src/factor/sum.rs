//! Sums of products in twice the working precision.
//!
//! Source: T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26 (2005) 1955-1988.

use crate::scalar::Scalar;

/// A sum, in lanes or not, that keeps what its rounding loses.
#[derive(Clone, Copy)]
pub(super) struct Sum<S> {
    high: S,
    low: S,
}

impl<S: Scalar> Sum<S> {
    /// It begins with x.
    #[inline(always)]
    pub fn of(x: S) -> Self {
        Sum { high: x, low: S::zero() }
    }
    /// Rounded.
    #[inline(always)]
    pub fn value(self) -> S {
        self.high + self.low
    }
    /// Adds `a b` exactly, but for the rounding of what is lost.
    #[inline(always)]
    pub fn add(&mut self, a: S, b: S) {
        let product = a * b;
        let sum = self.high + product;
        let from = sum - self.high;
        self.low += (self.high - (sum - from)) + (product - from) + a.product_error(b, product);
        self.high = sum;
    }
}
