//! Matrices known as sums, and solutions that the rounding of their sums does not spoil.
//!
//! A stiff chain on soft supports has entries many orders larger than what holds it. Rounding the sum `K + s D + s^2 M` once is as if a spring of
//! `1e-16` of the stiffest element were attached, another one at every s. Products and sums in twice the working precision leave the matrices as they
//! are: what is solved or evaluated then is exact for them.
//!
//! Source: T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26 (2005) 1955-1988.

use super::sum::Sum;
use super::{Factors, Pattern};
use crate::complex::{C64, c};
use crate::dense::Field;
use crate::work::spend;

/// Most corrections of a solution.
pub(super) const CORRECTIONS: usize = 6;
/// Correction over the solution at which it is exact to rounding.
pub(super) const EXACT: f64 = 4.0 * f64::EPSILON;

/// `f_1 V_1 + f_2 V_2 + ..` by the entries of one pattern.
#[derive(Clone, Copy, Debug)]
pub struct Terms<'a, V> {
    /// Where the entries stand.
    pub pattern: &'a Pattern,
    /// Factors and entries.
    pub terms: &'a [(C64, &'a [V])],
}

/// An entry: `f64` or [`C64`].
pub trait Entry: Copy {
    /// It adds nothing.
    #[doc(hidden)]
    fn is_zero(self) -> bool;
    /// Adds `self x` to a sum of complex numbers.
    #[doc(hidden)]
    fn add_to(self, x: C64, re: &mut impl FnMut(f64, f64), im: &mut impl FnMut(f64, f64));
}

impl Entry for f64 {
    #[inline]
    fn is_zero(self) -> bool {
        self == 0.0
    }
    #[inline]
    fn add_to(self, x: C64, re: &mut impl FnMut(f64, f64), im: &mut impl FnMut(f64, f64)) {
        re(self, x.re);
        im(self, x.im);
    }
}

impl Entry for C64 {
    #[inline]
    fn is_zero(self) -> bool {
        self == C64::ZERO
    }
    #[inline]
    fn add_to(self, x: C64, re: &mut impl FnMut(f64, f64), im: &mut impl FnMut(f64, f64)) {
        re(self.re, x.re);
        re(-self.im, x.im);
        im(self.re, x.im);
        im(self.im, x.re);
    }
}

impl<V: Entry> Terms<'_, V> {
    /// `b - A x`, rounded once.
    pub fn residual(&self, x: &[C64], b: &[C64]) -> Vec<C64> {
        let scaled: Vec<Vec<C64>> = self.terms.iter().map(|(f, _)| x.iter().map(|&x| *f * x).collect()).collect();
        let mut products = 0;
        let out = (0..self.pattern.n())
            .map(|i| {
                let (mut re, mut im) = (Sum::of(b[i].re), Sum::of(b[i].im));
                let (mut to_re, mut to_im) = (|a: f64, b: f64| re.add(-a, b), |a: f64, b: f64| im.add(-a, b));
                for (e, j) in self.pattern.row(i) {
                    for ((_, values), x) in self.terms.iter().zip(&scaled) {
                        // most entries of masses and dampings
                        if !values[e].is_zero() {
                            values[e].add_to(x[j], &mut to_re, &mut to_im);
                            products += 1;
                        }
                    }
                }
                c(re.value(), im.value())
            })
            .collect();
        spend(3 * (self.terms.len() * self.pattern.entries()) as u64 + 40 * products);
        out
    }

    /// `y^H A x`.
    pub fn form(&self, y: &[C64], x: &[C64]) -> C64 {
        let zero = vec![C64::ZERO; self.pattern.n()];
        self.residual(x, &zero).iter().zip(y).fold(C64::ZERO, |sum, (r, y)| sum - y.conj() * *r)
    }

    /// Solves `A x = b` in place with approximate factors, corrected until `x` is exact to rounding.
    pub fn solve(&self, factors: &Factors<C64>, x: &mut [C64]) {
        let b = x.to_vec();
        factors.solve(x);
        let mut last = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let mut more = self.residual(x, &b);
            factors.solve(&mut more);
            let largest = |v: &[C64]| v.iter().map(|x| x.size()).fold(0.0, f64::max);
            let change = largest(&more) / largest(x);
            if !lessens(change, last) {
                return;
            }
            x.iter_mut().zip(&more).for_each(|(x, m)| *x += *m);
            if is_last(change, last) {
                return;
            }
            last = change;
        }
    }
}

/// Whether a correction, over the solution, is less than half of the one before: else it is rounding. NaN is not.
pub(super) fn lessens(change: f64, last: f64) -> bool {
    change < 0.5 * last
}

/// After this correction over the solution, and that before it, the next is below rounding: each multiplies the error by about the same factor, and the first
/// correction is the error of solutions by the factors alone.
pub(super) fn is_last(change: f64, last: f64) -> bool {
    let factor = if last.is_finite() { change / last } else { change };
    change <= EXACT || change * factor <= 0.1 * EXACT
}

#[cfg(test)]
mod tests {
    use super::super::Plan;
    use super::*;
    use std::sync::Arc;

    /// A chain of springs of 1e12 N/m on one of 1 N/m at its end, loaded at the other: the load moves it as one body.
    #[test]
    fn a_soft_support_below_a_stiff_chain() {
        let (n, stiff) = (200, 1e12);
        let pattern = Arc::new(Pattern::new(n, (1..n).map(|i| (i - 1, i))));
        let [mut k, mut m] = [vec![0.0; pattern.entries()], vec![0.0; pattern.entries()]];
        for i in 0..n {
            for (e, j) in pattern.row(i) {
                let inner = if i == 0 || i + 1 == n { 1.0 } else { 2.0 };
                k[e] = if i == j { inner * stiff } else { -stiff };
                m[e] = if i == j { 3.0 } else { 0.0 };
            }
        }
        // the support is a term of its own: in a sum with 1e12 its last digits would be lost
        let mut soft = vec![0.0; pattern.entries()];
        soft[pattern.index(0, 0).unwrap()] = 1.0 + 1e-9;
        let plan = Plan::new(&pattern);
        for w in [0.0, 0.3, 0.07] {
            let s = c(0.0, w);
            let all = [(C64::ONE, &k[..]), (C64::ONE, &soft[..]), (s * s, &m[..])];
            let terms = Terms { pattern: &pattern, terms: &all };
            let sum: Vec<C64> = (0..k.len()).map(|e| c(k[e] + soft[e] - w * w * m[e], 0.0)).collect();
            let factors = Factors::new(&plan, &sum).unwrap();
            let mut x = vec![C64::ZERO; n];
            x[n - 1] = C64::ONE;
            let b = x.clone();
            terms.solve(&factors, &mut x);
            let worst = terms.residual(&x, &b).iter().map(|r| r.abs()).fold(0.0, f64::max);
            // one rounding of x costs 1e12 * 1e-16 * x
            assert!(worst <= 2e-3 * x[0].abs().max(1e-2), "{w}: {worst:e}");
            let rigid = 1.0 / (1.0 + 1e-9 - w * w * 3.0 * n as f64);
            assert!((x[0].re / rigid - 1.0).abs() < 1e-8, "{w}: {} {rigid}", x[0].re);
            // y^H A x of nearly rigid motions is that of the support and the masses
            let one = vec![C64::ONE; n];
            assert!((terms.form(&one, &one).re * rigid - 1.0).abs() < 1e-12, "{w}");
        }
    }

    #[test]
    fn complex_entries_are_products_of_complex_numbers() {
        let pattern = Pattern::new(2, [(0, 1)]);
        let values = [c(1.0, 2.0), c(-0.5, 0.25), c(3.0, -1.0), c(0.125, 4.0)];
        let (x, b) = ([c(0.3, -0.7), c(1.5, 0.2)], [c(1.0, 0.0), c(0.0, 2.0)]);
        let all = [(c(0.5, 1.0), &values[..])];
        let r = Terms { pattern: &pattern, terms: &all }.residual(&x, &b);
        for i in 0..2 {
            let expected = b[i] - c(0.5, 1.0) * (values[2 * i] * x[0] + values[2 * i + 1] * x[1]);
            assert!((r[i] - expected).abs() < 1e-15);
        }
    }
}
