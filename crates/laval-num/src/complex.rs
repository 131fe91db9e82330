//! Complex numbers over any [`Scalar`]: dynamic stiffness, impedance, Fourier coefficients, eigenvalues.

use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `re + i im`.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Complex<S> {
    /// Real part.
    pub re: S,
    /// Imaginary part.
    pub im: S,
}

/// Complex number of `f64`.
pub type C64 = Complex<f64>;

/// Shorthand for [`Complex`].
#[inline(always)]
pub const fn c<S>(re: S, im: S) -> Complex<S> {
    Complex { re, im }
}

impl<S: Scalar> Complex<S> {
    /// Zero.
    #[inline(always)]
    pub fn zero() -> Self {
        c(S::zero(), S::zero())
    }
    /// One.
    #[inline(always)]
    pub fn one() -> Self {
        c(S::one(), S::zero())
    }
    /// The imaginary unit.
    #[inline(always)]
    pub fn i() -> Self {
        c(S::zero(), S::one())
    }
    /// A real number.
    #[inline(always)]
    pub fn real(re: S) -> Self {
        c(re, S::zero())
    }
    /// A constant.
    #[inline(always)]
    pub fn cst(z: C64) -> Self {
        c(S::cst(z.re), S::cst(z.im))
    }
    /// Complex conjugate.
    #[inline(always)]
    pub fn conj(self) -> Self {
        c(self.re, -self.im)
    }
    /// `i * self`.
    #[inline(always)]
    pub fn mul_i(self) -> Self {
        c(-self.im, self.re)
    }
    /// Multiplication by a real number.
    #[inline(always)]
    pub fn scale(self, k: S) -> Self {
        c(self.re * k, self.im * k)
    }
    /// `|z|^2`.
    #[inline(always)]
    pub fn norm_sqr(self) -> S {
        self.re * self.re + self.im * self.im
    }
    /// `e^(i a)`.
    #[inline(always)]
    pub fn cis(a: S) -> Self {
        let (s, co) = a.sin_cos();
        c(co, s)
    }
    /// `1/z`.
    #[inline(always)]
    pub fn recip(self) -> Self {
        let n = self.norm_sqr();
        c(self.re / n, -self.im / n)
    }
}

impl C64 {
    /// Modulus, without overflow.
    pub fn abs(self) -> f64 {
        self.re.hypot(self.im)
    }
    /// Argument in (-pi, pi].
    pub fn arg(self) -> f64 {
        self.im.atan2(self.re)
    }
    /// Principal square root.
    pub fn sqrt(self) -> Self {
        let m = self.abs();
        if m == 0.0 {
            return c(0.0, 0.0);
        }
        let re = (0.5 * (m + self.re.abs())).sqrt();
        let im = 0.5 * self.im.abs() / re;
        if self.re >= 0.0 { c(re, im.copysign(self.im)) } else { c(im, re.copysign(self.im)) }
    }
    /// Principal logarithm.
    pub fn ln(self) -> Self {
        c(self.abs().ln(), self.arg())
    }
    /// Exponential.
    pub fn exp(self) -> Self {
        let (s, co) = self.im.sin_cos();
        let e = self.re.exp();
        c(e * co, e * s)
    }
    /// Both parts finite.
    pub fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }
}

impl<S: Scalar> Add for Complex<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        c(self.re + o.re, self.im + o.im)
    }
}
impl<S: Scalar> Sub for Complex<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        c(self.re - o.re, self.im - o.im)
    }
}
impl<S: Scalar> Mul for Complex<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        c(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}
impl<S: Scalar> Div for Complex<S> {
    type Output = Self;
    #[inline(always)]
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, o: Self) -> Self {
        self * o.recip()
    }
}
impl<S: Scalar> Neg for Complex<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        c(-self.re, -self.im)
    }
}
impl<S: Scalar> AddAssign for Complex<S> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<S: Scalar> SubAssign for Complex<S> {
    #[inline(always)]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_invert_each_other() {
        for z in [c(0.3, -1.2), c(-2.0, 1e-9), c(-2.0, -1e-9), c(1e-200, 1e-200), c(0.0, -4.0)] {
            let r = z.sqrt();
            assert!((r * r - z).abs() <= 1e-15 * z.abs() && r.re >= 0.0);
            assert!((z.ln().exp() - z).abs() <= 1e-13 * z.abs());
        }
        let z = c(0.3, -1.2);
        assert!((z * z.recip() - c(1.0, 0.0)).abs() < 1e-15);
        assert!((C64::cis(0.7) - c(0.7f64.cos(), 0.7f64.sin())).abs() < 1e-15);
    }
}
