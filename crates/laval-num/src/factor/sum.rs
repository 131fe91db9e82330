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

/// Upper half of the digits of a number.
#[inline(always)]
fn upper<S: Scalar>(x: S) -> S {
    let scaled = x.scale(134_217_729.0);
    scaled - (scaled - x)
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
    /// Adds `a b` of two numbers in lanes.
    #[inline(always)]
    pub fn add_product(&mut self, a: S, b: S) {
        let (a1, b1) = (upper(a), upper(b));
        let (a2, b2) = (a - a1, b - b1);
        let product = a * b;
        let lost = a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2);
        self.take(product, lost);
    }
    #[inline(always)]
    fn take(&mut self, product: S, lost: S) {
        let sum = self.high + product;
        let from = sum - self.high;
        self.low += (self.high - (sum - from)) + (product - from) + lost;
        self.high = sum;
    }
    /// Adds `a b` exactly, but for the rounding of what is lost.
    #[inline(always)]
    pub fn add(&mut self, a: f64, b: S) {
        let (a1, b1) = (upper(a), upper(b));
        let (a2, b2) = (a - a1, b - b1);
        let product = b.scale(a);
        let lost = b2.scale(a2) - (((product - b1.scale(a1)) - b1.scale(a2)) - b2.scale(a1));
        self.take(product, lost);
    }
}
