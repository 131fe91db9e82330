//! Analytic functions of a complex argument over any [`Scalar`]: written for plain numbers, with exact derivatives all the same.
//!
//! An algorithm for a special function branches, iterates and compares: it is written for [`C64`]. What carries it to dual numbers and lanes is that
//! a set of functions is closed under differentiation (the Bessel functions of two neighbouring orders, for instance): values at the plain number, then
//! derivatives by the chain rule, for nested duals level by level.

use crate::complex::{C64, Complex, c};
use crate::lanes::LANES;
use crate::scalar::Scalar;

/// `N` analytic functions whose derivatives are rational in them and the argument.
pub trait Analytic<const N: usize> {
    /// Values.
    fn value(z: C64) -> [C64; N];
    /// One of several ways of computing the values.
    type Way: Copy;
    /// A way that serves all of some arguments; `None` where each needs its own.
    fn way(re: &[f64; LANES], im: &[f64; LANES]) -> Option<Self::Way>;
    /// Values of lanes by a way that serves all of them. Must be `#[inline(always)]` (see [`Kernel`](crate::lanes::Kernel)).
    fn by<S: Scalar>(way: Self::Way, z: Complex<S>) -> [Complex<S>; N];
    /// Derivatives, from argument and values.
    fn slope<S: Scalar>(z: Complex<S>, f: &[Complex<S>; N]) -> [Complex<S>; N];
}

struct Root;

impl Analytic<1> for Root {
    type Way = ();
    fn value(z: C64) -> [C64; 1] {
        [z.sqrt()]
    }
    #[inline(always)]
    fn way(re: &[f64; LANES], im: &[f64; LANES]) -> Option<()> {
        let whole = |(re, im): (&f64, &f64)| (1e-300..1e300).contains(&(re * re + im * im));
        re.iter().zip(im).all(whole).then_some(())
    }
    #[inline(always)]
    fn by<S: Scalar>((): (), z: Complex<S>) -> [Complex<S>; 1] {
        let large = ((z.norm_sqr().sqrt() + z.re.abs()).scale(0.5)).sqrt();
        let small = z.im.abs().scale(0.5) / large;
        let sign = (-z.im).select_pos(S::cst(-1.0), S::one());
        let left = -z.re;
        [c(left.select_pos(small, large), left.select_pos(large, small) * sign)]
    }
    #[inline(always)]
    fn slope<S: Scalar>(_: Complex<S>, f: &[Complex<S>; 1]) -> [Complex<S>; 1] {
        [f[0].recip().scale(S::cst(0.5))]
    }
}

struct Logarithm;

impl Analytic<1> for Logarithm {
    type Way = ();
    fn value(z: C64) -> [C64; 1] {
        [z.ln()]
    }
    #[inline(always)]
    fn way(_: &[f64; LANES], _: &[f64; LANES]) -> Option<()> {
        None
    }
    #[inline(always)]
    fn by<S: Scalar>((): (), z: Complex<S>) -> [Complex<S>; 1] {
        [c(z.norm_sqr().ln().scale(0.5), z.im.atan2(z.re))]
    }
    fn slope<S: Scalar>(z: Complex<S>, _: &[Complex<S>; 1]) -> [Complex<S>; 1] {
        [z.recip()]
    }
}

/// Principal logarithm.
#[inline(always)]
pub fn ln<S: Scalar>(z: Complex<S>) -> Complex<S> {
    S::analytic::<1, Logarithm>(z)[0]
}

/// Principal square root, real part 0 or more; no derivative at 0.
#[inline(always)]
pub fn sqrt<S: Scalar>(z: Complex<S>) -> Complex<S> {
    S::analytic::<1, Root>(z)[0]
}

/// Exponential.
#[inline(always)]
pub fn exp<S: Scalar>(z: Complex<S>) -> Complex<S> {
    Complex::cis(z.im).scale(z.re.exp())
}

/// The value of a complex number without its derivatives.
#[inline(always)]
pub fn value<S: Scalar>(z: Complex<S>) -> C64 {
    c(z.re.value(), z.im.value())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::Dual;

    type D = Dual<f64, 2>;

    #[test]
    fn derivatives_of_the_root() {
        for z in [c(0.3, -1.2), c(-2.0, 1e-3), c(-2.0, -1e-3), c(5.0, 0.0)] {
            let r = sqrt(c(D::seed(z.re, 0), D::seed(z.im, 1)));
            let slope = z.sqrt().recip().scale(0.5);
            let (along, across) = (c(r.re.eps[0], r.im.eps[0]), c(r.re.eps[1], r.im.eps[1]));
            assert!((along - slope).abs() < 1e-15 * slope.abs() && (across - slope.mul_i()).abs() < 1e-15 * slope.abs());
        }
        // second derivative: -z^(-3/2)/4
        type DD = Dual<Dual<f64, 1>, 1>;
        let z = c(DD { re: Dual::seed(0.7, 0), eps: [Dual::cst(1.0)] }, DD::cst(0.4));
        let (r, w) = (sqrt(z), c(0.7, 0.4).sqrt());
        let second = (w * w * w).recip().scale(-0.25);
        assert!((c(r.re.eps[0].eps[0], r.im.eps[0].eps[0]) - second).abs() < 1e-15);
    }
}
