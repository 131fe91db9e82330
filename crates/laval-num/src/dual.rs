//! Forward-mode exact derivatives: a value and its gradient in `N` directions.

use crate::analytic::Analytic;
use crate::complex::{Complex, c};
use crate::lanes::{LaneScalar, Routine};
use crate::scalar::Scalar;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// `re + sum_i eps[i] e_i` with `e_i e_j = 0`: a value and `N` directional derivatives. Nests: `Dual<Dual<f64, 1>, 1>`, `Dual<Lanes, N>`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T, const N: usize> {
    /// Value.
    pub re: T,
    /// Directional derivatives.
    pub eps: [T; N],
}

impl<T: Scalar, const N: usize> Dual<T, N> {
    /// A constant.
    #[inline(always)]
    pub fn lift(re: T) -> Self {
        Dual { re, eps: [T::zero(); N] }
    }
    /// The variable of direction `i`.
    #[inline(always)]
    pub fn seed(re: T, i: usize) -> Self {
        let mut d = Self::lift(re);
        d.eps[i] = T::one();
        d
    }
    /// Applies a function with value `f` and derivative `df` at `self.re`.
    #[inline(always)]
    pub fn chain(self, f: T, df: T) -> Self {
        let mut eps = self.eps;
        for e in &mut eps {
            *e *= df;
        }
        Dual { re: f, eps }
    }
}

impl<T: Scalar, const N: usize> Add for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn add(mut self, o: Self) -> Self {
        self.re += o.re;
        for i in 0..N {
            self.eps[i] += o.eps[i];
        }
        self
    }
}
impl<T: Scalar, const N: usize> Sub for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(mut self, o: Self) -> Self {
        self.re -= o.re;
        for i in 0..N {
            self.eps[i] -= o.eps[i];
        }
        self
    }
}
impl<T: Scalar, const N: usize> Mul for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        let mut eps = self.eps;
        for i in 0..N {
            eps[i] = self.eps[i] * o.re + self.re * o.eps[i];
        }
        Dual { re: self.re * o.re, eps }
    }
}
impl<T: Scalar, const N: usize> Div for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        let re = self.re / o.re;
        let mut eps = self.eps;
        for i in 0..N {
            eps[i] = (self.eps[i] - re * o.eps[i]) / o.re;
        }
        Dual { re, eps }
    }
}
impl<T: Scalar, const N: usize> Neg for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        self.re = -self.re;
        for e in &mut self.eps {
            *e = -*e;
        }
        self
    }
}
impl<T: Scalar, const N: usize> AddAssign for Dual<T, N> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<T: Scalar, const N: usize> SubAssign for Dual<T, N> {
    #[inline(always)]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}
impl<T: Scalar, const N: usize> MulAssign for Dual<T, N> {
    #[inline(always)]
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}
impl<T: Scalar, const N: usize> DivAssign for Dual<T, N> {
    #[inline(always)]
    fn div_assign(&mut self, o: Self) {
        *self = *self / o;
    }
}

impl<T: Scalar, const N: usize> Scalar for Dual<T, N> {
    type Base = T::Base;
    type Over<L: LaneScalar> = Dual<T::Over<L>, N>;
    const SPREADS: bool = T::SPREADS && N <= 2;
    #[inline(always)]
    fn apart<R: Routine>(routine: R) -> R::Out {
        T::apart(routine)
    }
    #[inline(always)]
    fn base(self) -> T::Base {
        self.re.base()
    }
    #[inline(always)]
    fn constant(x: T::Base) -> Self {
        Self::lift(T::constant(x))
    }
    #[inline(always)]
    fn spread<L: LaneScalar>(self) -> Dual<T::Over<L>, N> {
        let mut out = Dual::lift(self.re.spread::<L>());
        for i in 0..N {
            out.eps[i] = self.eps[i].spread::<L>();
        }
        out
    }
    #[inline(always)]
    fn lane<L: LaneScalar>(of: Dual<T::Over<L>, N>, lane: usize) -> Self {
        let mut out = Self::lift(T::lane::<L>(of.re, lane));
        for i in 0..N {
            out.eps[i] = T::lane::<L>(of.eps[i], lane);
        }
        out
    }
    #[inline(always)]
    fn cst(x: f64) -> Self {
        Self::lift(T::cst(x))
    }
    #[inline(always)]
    fn is_nothing(self) -> bool {
        self.re.is_nothing() && self.eps.iter().all(|x| x.is_nothing())
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.re.sin_cos();
        (self.chain(s, c), self.chain(c, -s))
    }
    #[inline(always)]
    fn product_error(self, o: Self, product: Self) -> Self {
        Self::lift(self.re.product_error(o.re, product.re))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let r = self.re.sqrt();
        // at 0 the derivative is set to 0: see the trait
        let safe = r.select_pos(r, T::one());
        let d = r.select_pos(T::cst(0.5) / safe, T::zero());
        self.chain(r, d)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        let e = self.re.exp();
        self.chain(e, e)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.chain(self.re.ln(), T::one() / self.re)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let a = self.re.atan2(x.re);
        let n = x.re * x.re + self.re * self.re;
        let mut eps = self.eps;
        for i in 0..N {
            eps[i] = (self.eps[i] * x.re - self.re * x.eps[i]) / n;
        }
        Dual { re: a, eps }
    }
    #[inline(always)]
    fn pos(self) -> Self {
        self.chain(self.re.pos(), self.re.select_pos(T::one(), T::zero()))
    }
    #[inline(always)]
    fn pow_pos(self, p: f64) -> Self {
        let f = self.re.pow_pos(p);
        let df = if p == 1.5 { self.re.pos().sqrt().scale(1.5) } else { self.re.pow_pos(p - 1.0).scale(p) };
        self.chain(f, df)
    }
    #[inline(always)]
    fn select_pos(self, then: Self, other: Self) -> Self {
        let mut eps = then.eps;
        for i in 0..N {
            eps[i] = self.re.select_pos(then.eps[i], other.eps[i]);
        }
        Dual { re: self.re.select_pos(then.re, other.re), eps }
    }
    #[inline(always)]
    fn value(self) -> f64 {
        self.re.value()
    }
    #[inline(always)]
    fn analytic<const M: usize, F: Analytic<M>>(z: Complex<Self>) -> [Complex<Self>; M] {
        let at = c(z.re.re, z.im.re);
        let value = T::analytic::<M, F>(at);
        let slope = F::slope(at, &value);
        let mut out = [Complex::zero(); M];
        for m in 0..M {
            let mut f: Complex<Self> = c(Self::lift(value[m].re), Self::lift(value[m].im));
            for i in 0..N {
                let d = slope[m] * c(z.re.eps[i], z.im.eps[i]);
                (f.re.eps[i], f.im.eps[i]) = (d.re, d.im);
            }
            out[m] = f;
        }
        out
    }
    #[inline(always)]
    fn scale(mut self, k: f64) -> Self {
        self.re = self.re.scale(k);
        for e in &mut self.eps {
            *e = e.scale(k);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type D = Dual<f64, 2>;

    fn check(f: impl Fn(D, D) -> D, x: f64, y: f64) {
        let d = f(D::seed(x, 0), D::seed(y, 1));
        let h = 1e-6;
        let g = |x: f64, y: f64| f(D::cst(x), D::cst(y)).re;
        let gx = (g(x + h, y) - g(x - h, y)) / (2.0 * h);
        let gy = (g(x, y + h) - g(x, y - h)) / (2.0 * h);
        assert!((d.eps[0] - gx).abs() < 1e-8 * (1.0 + gx.abs()), "{} {gx}", d.eps[0]);
        assert!((d.eps[1] - gy).abs() < 1e-8 * (1.0 + gy.abs()), "{} {gy}", d.eps[1]);
    }

    #[test]
    fn derivatives_agree_with_central_differences() {
        check(|x, y| x * y / (x + y.square()) - y, 0.7, -1.3);
        check(|x, y| (x * y).sin() * (x - y).cos(), 0.7, -1.3);
        check(|x, y| x.exp() * (y.square() + D::one()).ln(), 0.7, -1.3);
        check(|x, y| y.atan2(x) + x.norm2(y).sqrt(), 0.7, -1.3);
        check(|x, y| x.pow_pos(1.5) + (-y).pow_pos(2.7), 0.7, -1.3);
        check(|x, y| x.abs() * y.abs() + y.select_pos(x, y.scale(3.0)), 0.7, -1.3);
    }

    #[test]
    fn kinks_have_finite_derivatives() {
        let z = D::seed(0.0, 0);
        for d in [z.sqrt(), z.pos(), z.pow_pos(1.5), z.abs(), z.norm2(D::zero())] {
            assert_eq!(d.re, 0.0);
            assert_eq!(d.eps, [0.0, 0.0]);
        }
    }

    #[test]
    fn nested_duals_give_second_derivatives() {
        type DD = Dual<Dual<f64, 1>, 1>;
        let x = DD { re: Dual::seed(0.4, 0), eps: [Dual::cst(1.0)] };
        let f = x.sin() * x;
        let exact = 2.0 * 0.4f64.cos() - 0.4 * 0.4f64.sin();
        assert!((f.eps[0].eps[0] - exact).abs() < 1e-15);
    }

    #[test]
    fn nan_is_never_hidden() {
        assert!(f64::NAN.pos().is_nan() && f64::NAN.pow_pos(1.5).is_nan() && Scalar::abs(f64::NAN).is_nan());
    }
}
