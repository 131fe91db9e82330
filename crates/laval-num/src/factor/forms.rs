//! Forms `y^H T(s) x` of a [`ScaledQuadratic`] matrix in lanes: to ordinary precision for all s, and at one s with products and sums in twice the working precision.

use super::lanes::{InLanes, Pair};
use super::quadratic::ScaledQuadratic;
use super::sum::Sum;
use crate::complex::{C64, Complex, c};
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::work::spend;

/// `y^H A_k x` of the three matrices, and the squares of the norms of x and y, in every lane.
#[derive(Clone, Copy, Debug)]
pub struct Forms {
    /// Of A0, A1 and A2.
    pub terms: [Pair; 3],
    /// Of x and y.
    pub norms: [[f64; LANES]; 2],
}

impl Forms {
    /// `y^H T(s) x` in a lane, and its derivative over s.
    pub fn at(&self, lane: usize, s: C64) -> (C64, C64) {
        let [a, b, d] = self.terms.map(|t| c(t[0][lane], t[1][lane]));
        (a + s * (b + s * d), b + (s * d).scale(2.0))
    }
}

impl ScaledQuadratic {
    /// Forms of the vectors in each lane.
    pub fn forms(&self, y: &[Pair], x: &[Pair]) -> Forms {
        dispatch(Level::best(), Plain { t: self, y, x })
    }

    /// `y^H T(s) x` in each lane, exact for the entries but for one rounding of each row.
    pub fn exact_form(&self, s: &Pair, y: &[Pair], x: &[Pair]) -> Pair {
        spend(100 * self.terms.len() as u64);
        dispatch(Level::best(), Exact { t: self, s, y, x })
    }
}

struct Plain<'a> {
    t: &'a ScaledQuadratic,
    y: &'a [Pair],
    x: &'a [Pair],
}

impl Kernel for Plain<'_> {
    type Out = Forms;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Forms {
        let mut sums = [Complex::<S>::zero(); 3];
        let mut at = 0;
        let terms = &self.t.terms;
        while at < terms.len() {
            let row = terms[at].row;
            let mut own = [Complex::<S>::zero(); 3];
            while at < terms.len() && terms[at].row == row {
                let t = &terms[at];
                let x = C64::load::<S>(&self.x[t.column]);
                for k in 0..3 {
                    let a = t.values[k];
                    if a.re != 0.0 {
                        own[k] += c(x.re.scale(a.re), x.im.scale(a.re));
                    }
                    if a.im != 0.0 {
                        own[k] += c(-x.im.scale(a.im), x.re.scale(a.im));
                    }
                }
                at += 1;
            }
            let y = C64::load::<S>(&self.y[row]).conj();
            for k in 0..3 {
                sums[k] += y * own[k];
            }
        }
        let (mut nx, mut ny) = (S::zero(), S::zero());
        for (x, y) in self.x.iter().zip(self.y) {
            nx += C64::load::<S>(x).norm_sqr();
            ny += C64::load::<S>(y).norm_sqr();
        }
        let mut out = Forms { terms: [[[0.0; LANES]; 2]; 3], norms: [[0.0; LANES]; 2] };
        for k in 0..3 {
            C64::store::<S>(sums[k], &mut out.terms[k]);
        }
        nx.store(&mut out.norms[0]);
        ny.store(&mut out.norms[1]);
        out
    }
}

struct Exact<'a> {
    t: &'a ScaledQuadratic,
    s: &'a Pair,
    y: &'a [Pair],
    x: &'a [Pair],
}

impl Kernel for Exact<'_> {
    type Out = Pair;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Pair {
        let s = C64::load::<S>(self.s);
        let square = s * s;
        let mut sum = Complex::<S>::zero();
        let mut at = 0;
        let terms = &self.t.terms;
        while at < terms.len() {
            let row = terms[at].row;
            let (mut re, mut im) = (Sum::of(S::zero()), Sum::of(S::zero()));
            while at < terms.len() && terms[at].row == row {
                let t = &terms[at];
                let x = C64::load::<S>(&self.x[t.column]);
                let all = [x, s * x, square * x];
                for k in 0..3 {
                    let a = t.values[k];
                    if a.re != 0.0 {
                        re.add(S::cst(a.re), all[k].re);
                        im.add(S::cst(a.re), all[k].im);
                    }
                    if a.im != 0.0 {
                        re.add(S::cst(-a.im), all[k].im);
                        im.add(S::cst(a.im), all[k].re);
                    }
                }
                at += 1;
            }
            sum += C64::load::<S>(&self.y[row]).conj() * c(re.value(), im.value());
        }
        let mut out = [[0.0; LANES]; 2];
        C64::store::<S>(sum, &mut out);
        out
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Pattern, Plan};
    use super::*;
    use std::sync::Arc;

    /// Both forms are the products of complex numbers, lane by lane, also of entries that are not real.
    #[test]
    fn forms_are_products_of_the_matrices() {
        let n = 60;
        let pattern = Arc::new(Pattern::new(n, (0..n).flat_map(|i| [(i, (i + 1).min(n - 1)), (i, (i + 3).min(n - 1))])));
        let own = |k: usize| (0..pattern.entries()).map(|e| C64::cis((3 * e + 7 * k) as f64).scale(1.0 + k as f64)).collect::<Vec<_>>();
        let terms = [own(0), own(1), own(2)];
        let t = ScaledQuadratic::new(&Plan::new(&pattern), terms.each_ref().map(Vec::as_slice), 1.0).unwrap();
        let vector = |seed: usize| -> Vec<Pair> {
            let of = |i: usize, l: usize| C64::cis((seed * i + 5 * l) as f64 + 0.3 * (i * l) as f64);
            (0..n).map(|i| [std::array::from_fn(|l| of(i, l).re), std::array::from_fn(|l| of(i, l).im)]).collect()
        };
        let (x, y) = (vector(3), vector(11));
        let s: Pair = [std::array::from_fn(|l| 0.1 * l as f64 - 0.5), std::array::from_fn(|l| 1.0 + 0.2 * l as f64)];
        let (forms, exact) = (t.forms(&y, &x), t.exact_form(&s, &y, &x));
        for l in 0..LANES {
            let (at, get) = (c(s[0][l], s[1][l]), |v: &[Pair], i: usize| c(v[i][0][l], v[i][1][l]));
            let (mut value, mut slope) = (C64::zero(), C64::zero());
            for i in 0..n {
                for (e, j) in pattern.row(i) {
                    let [a0, a1, a2] = terms.each_ref().map(|all| all[e].scale(t.rows()[i] * t.columns()[j]));
                    let outer = get(&y, i).conj() * get(&x, j);
                    value += outer * (a0 + at * (a1 + at * a2));
                    slope += outer * (a1 + (at * a2).scale(2.0));
                }
            }
            let (plain, by_s) = forms.at(l, at);
            for (found, expected) in [(plain, value), (c(exact[0][l], exact[1][l]), value), (by_s, slope)] {
                assert!((found - expected).abs() <= 1e-12 * (1.0 + expected.abs()) * n as f64, "{l}: {found:?} {expected:?}");
            }
        }
    }
}
