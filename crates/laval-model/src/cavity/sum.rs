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
use laval_num::quadrature::gauss;
use laval_num::scalar::Scalar;
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

/// Sum of `term(k)`, given with its own rounding error, over k = 1, 3, 5, ...: `term` is smooth in k beyond `first`, and without further length scale beyond `corner`. The
/// sum is taken as found when it moves by less than `share` of its size.
pub fn over_odd<S: Scalar>(first: f64, corner: f64, share: f64, mut term: impl FnMut(f64) -> (Complex<S>, f64)) -> Total<S> {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    let rule = RULE.get_or_init(|| gauss(10));
    let mut terms: Vec<Complex<S>> = Vec::with_capacity(64);
    let (mut harmonics, mut last, mut rounding) = (0, None, 0.0);
    let (mut exact, mut size, mut added) = (Complex::zero(), 0.0, 0);
    // even, so that the joint lies between two harmonics
    let mut joint = if first > 16.0 { 2.0 * (0.5 * first.min(FARTHEST)).ceil() } else { 16.0 };
    loop {
        let count = (0.5 * joint) as usize;
        while terms.len() < count + REACH {
            let (t, doubt) = term(2.0 * terms.len() as f64 + 1.0);
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
        loop {
            let start = if end * corner < 0.2 || end * joint < NOTHING { 0.0 } else { 0.5 * end };
            for &(x, weight) in rule {
                let t = start + (end - start) * x;
                sum += term(t.recip()).0.scale(S::cst(0.5 * weight * (end - start) / (t * t)));
                harmonics += 1;
            }
            if start == 0.0 {
                break;
            }
            end = start;
        }
        let moved = last.map_or(f64::INFINITY, |before| value(sum - before).size());
        let next = 2.0 * (0.75 * joint).ceil();
        if moved <= share * size + rounding || next > 1.5 * FARTHEST || !size.is_finite() {
            return Total { value: sum, harmonics: harmonics + terms.len(), error: moved + rounding };
        }
        (joint, last) = (next, Some(sum));
    }
}
