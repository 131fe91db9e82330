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
                        re.add(a.re, all[k].re);
                        im.add(a.re, all[k].im);
                    }
                    if a.im != 0.0 {
                        re.add(-a.im, all[k].im);
                        im.add(a.im, all[k].re);
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
