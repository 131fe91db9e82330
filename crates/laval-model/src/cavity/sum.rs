//! Sums over the odd axial harmonics: exact terms first, then the rest as an integral with differences in place of derivatives.
//!
//! With `delta f(a) = f(a + 1) - f(a - 1)` and f smooth in k,
//!
//! ```text
//! sum f(k), k = a + 1, a + 3, ...  =  1/2 int_a^inf f dk + delta f/24 - 17 delta^3 f/5760 + 367 delta^5 f/967680 - ...
//! ```
//!
//! (Gauss's summation formula), and the integral over `t = 1/k` by Gauss's rule on panels that halve from `1/a` to the last length scale of the
//! terms. It needs a few dozen terms where the plain sum, falling as `k^-4` or, close to `sigma = -2 Omega`, as `k^-2`, needs thousands.

use laval_num::analytic::value;
use laval_num::complex::Complex;
use laval_num::dense::Field;
use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::quadrature::gauss;
use laval_num::scalar::Scalar;
use std::marker::PhantomData;
use std::sync::OnceLock;

/// Coefficients of odd central differences of step 2, from `1/(2 asinh(delta/2)) - 1/delta`.
const DIFFERENCES: [f64; 5] = [1.0 / 24.0, -17.0 / 5760.0, 367.0 / 967_680.0, -27_859.0 / 464_486_400.0, 1_295_803.0 / 122_624_409_600.0];
/// Terms on either side of the joint that the differences need.
const REACH: usize = DIFFERENCES.len();
/// The joint is moved no further than this.
const FARTHEST: f64 = 3000.0;

/// Share of the integral that is taken in one piece whatever its scales.
const NOTHING: f64 = 1e-10;

/// A sum with what it cost and how far it may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Total<S> {
    /// The sum.
    pub value: Complex<S>,
    /// Harmonics evaluated, those at the places of the integral included.
    pub harmonics: usize,
    /// Estimate of the absolute error: what the last change of the joint moved, and rounding.
    pub error: f64,
}

/// A term with its own rounding error.
pub(super) type Term<S> = (Complex<S>, f64);

/// Terms of a sum over harmonics k, which may be any numbers.
pub(super) trait Series<S: Scalar> {
    /// Appends the terms of several.
    fn terms(&self, all: &[f64], out: &mut Vec<Term<S>>);
}

/// Terms that can be computed side by side.
pub(super) trait SideBySide<S: Scalar> {
    /// The term of k must be computed by itself.
    fn apart(&self, k: f64) -> bool;
    /// The term of k.
    fn alone(&self, k: f64) -> Term<S>;
    /// The terms of several, in lanes. Must be `#[inline(always)]` (see [`Kernel`]).
    fn together<L: LaneScalar>(&self, ks: L) -> (Complex<S::Over<L>>, L);
}

struct Together<'a, S, F> {
    series: &'a F,
    ks: &'a [f64; LANES],
    number: PhantomData<S>,
}

impl<S: Scalar, F: SideBySide<S>> Kernel for Together<'_, S, F> {
    type Out = [Term<S>; LANES];
    #[inline(always)]
    fn run<L: LaneScalar>(self) -> Self::Out {
        let (term, doubt) = self.series.together::<L>(L::load(self.ks));
        let (mut out, doubt) = ([(Complex::zero(), 0.0); LANES], doubt.to_array());
        for l in 0..LANES {
            out[l] = (Complex { re: S::lane::<L>(term.re, l), im: S::lane::<L>(term.im, l) }, doubt[l]);
        }
        out
    }
}

/// Fewer terms than these are computed one by one.
const FEW: usize = 3;

/// Appends terms, side by side where they need not be computed by themselves.
pub(super) fn side_by_side<S: Scalar, F: SideBySide<S>>(series: &F, all: &[f64], out: &mut Vec<Term<S>>) {
    // nothing below is compiled for such numbers
    if !S::SPREADS {
        out.extend(all.iter().map(|&k| series.alone(k)));
        return;
    }
    let first = out.len();
    out.resize(first + all.len(), (Complex::zero(), 0.0));
    let (mut places, mut ks, mut count) = ([0; LANES], [0.0; LANES], 0);
    for (i, &k) in all.iter().enumerate() {
        if !series.apart(k) {
            (places[count], ks[count]) = (first + i, k);
            count += 1;
        } else {
            out[first + i] = series.alone(k);
        }
        if count == LANES || i + 1 == all.len() && count >= FEW {
            // lanes without a term of their own repeat the first
            let first = ks[0];
            ks[count..].fill(first);
            let terms = dispatch(Level::best(), Together { series, ks: &ks, number: PhantomData::<S> });
            places[..count].iter().zip(terms).for_each(|(&i, term)| out[i] = term);
            count = 0;
        }
    }
    for (&i, &k) in places.iter().zip(&ks).take(count) {
        out[i] = series.alone(k);
    }
}

/// Sum over k = 1, 3, 5, ...: terms are smooth in k beyond `first`, and without further length scale beyond `corner`. The sum is taken as found when it moves by less
/// than `share` of its size.
pub(super) fn over_odd<S: Scalar>(first: f64, corner: f64, share: f64, series: &impl Series<S>) -> Total<S> {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    let rule = RULE.get_or_init(|| gauss(10));
    let (mut terms, mut places): (Vec<Complex<S>>, Vec<f64>) = (Vec::with_capacity(64), Vec::new());
    let (mut found, mut weights): (Vec<Term<S>>, Vec<f64>) = (Vec::new(), Vec::new());
    let (mut harmonics, mut last, mut rounding) = (0, None, 0.0);
    let (mut exact, mut size, mut added) = (Complex::zero(), 0.0, 0);
    // even, so that the joint lies between two harmonics
    let mut joint = if first > 16.0 { 2.0 * (0.5 * first.min(FARTHEST)).ceil() } else { 16.0 };
    loop {
        let count = (0.5 * joint) as usize;
        places.clear();
        places.extend((terms.len()..count + REACH).map(|i| 2.0 * i as f64 + 1.0));
        found.clear();
        series.terms(&places, &mut found);
        for &(t, doubt) in &found {
            terms.push(t);
            rounding += doubt;
        }
        for &t in &terms[added..count] {
            exact += t;
            size += value(t).size();
        }
        added = count;
        let mut sum = exact;
        let mut d: Vec<Complex<S>> = terms[count - REACH..count + REACH].to_vec();
        for factor in DIFFERENCES {
            for i in 0..d.len() - 1 {
                d[i] = d[i + 1] - d[i];
            }
            d.pop();
            sum += d[d.len() / 2].scale(S::cst(factor));
            for i in 0..d.len() - 1 {
                d[i] = d[i + 1] - d[i];
            }
            d.pop();
        }
        let mut end = joint.recip();
        places.clear();
        weights.clear();
        while end > 0.0 {
            let start = if end * corner < 0.2 || end * joint < NOTHING { 0.0 } else { 0.5 * end };
            for &(x, weight) in rule {
                let t = start + (end - start) * x;
                places.push(t.recip());
                weights.push(0.5 * weight * (end - start) / (t * t));
            }
            end = start;
        }
        found.clear();
        series.terms(&places, &mut found);
        harmonics += places.len();
        for ((t, _), weight) in found.iter().zip(&weights) {
            sum += t.scale(S::cst(*weight));
        }
        let moved = last.map_or(f64::INFINITY, |before| value(sum - before).size());
        let next = 2.0 * (0.75 * joint).ceil();
        if moved <= share * size + rounding || next > 1.5 * FARTHEST || !size.is_finite() {
            return Total { value: sum, harmonics: harmonics + terms.len(), error: moved + rounding };
        }
        (joint, last) = (next, Some(sum));
    }
}

/// `|re| + |im|` without derivatives.
#[inline(always)]
pub(super) fn size<S: Scalar>(z: Complex<S>) -> S::Base {
    z.re.base().abs() + z.im.base().abs()
}

/// The same number in every lane.
#[inline(always)]
pub(super) fn spread<S: Scalar, L: LaneScalar>(z: Complex<S>) -> Complex<S::Over<L>> {
    Complex { re: z.re.spread::<L>(), im: z.im.spread::<L>() }
}
