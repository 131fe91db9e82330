//! `max(x, 0)^p` with the logarithm carried in two doubles.

use super::math::{LN2_HI, LN2_LO, exp_sum, fast_two_sum, split_exponent};
use super::reg::Reg;

/// `max(x, 0)^p`: 0 for `x <= 0` whatever the exponent, NaN for NaN. Exponents 1/2, 1, 3/2 and 2 go through roots and products.
#[inline(always)]
pub fn pow_pos<R: Reg>(x: R, p: f64) -> R {
    let zero = R::splat(0.0);
    let y = if p == 1.5 {
        x * x.sqrt()
    } else if p == 0.5 {
        x.sqrt()
    } else if p == 1.0 {
        x
    } else if p == 2.0 {
        x * x
    } else if R::mask_bits(zero.lt(x)) == 0 {
        // an unloaded contact pays nothing
        x
    } else {
        general(x, p)
    };
    // a NaN fails both comparisons and passes
    R::select(zero.lt(x), y, R::select(x.le(zero), zero, x))
}

/// `x^p = exp(p ln x)` for `x > 0`.
#[inline(always)]
fn general<R: Reg>(x: R, p: f64) -> R {
    // |ln x| >= 1e-16 unless x = 1, so larger exponents overflow or vanish all the same; NaN stays
    let p = p.clamp(-1e20, 1e20);
    let (log, log_lo) = ln_pair(x);
    let p_r = R::splat(p);
    let (y, y_lo) = two_product(halves(p_r), halves(log));
    let y = exp_sum(y, y_lo + p_r * log_lo);
    let at_infinity = R::splat(if p > 0.0 {
        f64::INFINITY
    } else if p < 0.0 {
        0.0
    } else {
        1.0 + p
    });
    R::select(x.lt(R::splat(f64::INFINITY)), y, at_infinity)
}

/// `ln x` for positive finite `x` as a sum of two doubles, relative error near 1e-19.
///
/// `x = 2^k (1 + f)`, `s = f / (2 + f)`, `ln(1 + f) = 2 s (1 + z/3 + z^2/5 + ...)`, `z = s^2 <= 0.0295`.
#[inline(always)]
fn ln_pair<R: Reg>(x: R) -> (R, R) {
    let c = R::splat;
    let (k, f) = split_exponent(x);
    let d = c(2.0) + f;
    let d_lo = f - (d - c(2.0));
    let inverse = c(1.0) / d;
    let s = f * inverse;
    let sh = halves(s);
    let (q, q_lo) = two_product(sh, halves(d));
    let s_lo = (((f - q) - q_lo) - s * d_lo) * inverse;
    let (z, z_lo) = two_product(sh, sh);
    let z_lo = z_lo + c(2.0) * s * s_lo;
    // 1/5 + z/7 + ... + z^10/25
    let w = z * z;
    let even = c(1.0 / 5.0) + w * (c(1.0 / 9.0) + w * (c(1.0 / 13.0) + w * (c(1.0 / 17.0) + w * (c(1.0 / 21.0) + w * c(1.0 / 25.0)))));
    let odd = c(1.0 / 7.0) + w * (c(1.0 / 11.0) + w * (c(1.0 / 15.0) + w * (c(1.0 / 19.0) + w * c(1.0 / 23.0))));
    let (t, t_lo) = fast_two_sum(c(1.0 / 3.0), z * (even + z * odd));
    let t_lo = t_lo + c(THIRD_LO);
    let (u, u_lo) = two_product(halves(z), halves(t));
    let u_lo = u_lo + (z * t_lo + z_lo * t);
    let (v, v_lo) = two_product(sh, halves(u));
    let v_lo = v_lo + (s * u_lo + s_lo * u);
    // k ln 2 + 2 s + 2 v, in falling order
    let (a, e1) = fast_two_sum(k * c(LN2_HI), c(2.0) * s);
    let (a, e2) = fast_two_sum(a, c(2.0) * v);
    fast_two_sum(a, (e1 + e2) + (c(2.0) * (v_lo + s_lo) + k * c(LN2_LO)))
}

/// 1/3 minus its double.
const THIRD_LO: f64 = 1.850_371_707_708_594e-17;

/// A number as itself and its upper and lower 26 bits.
#[derive(Clone, Copy)]
struct Halves<R> {
    all: R,
    hi: R,
    lo: R,
}

#[inline(always)]
fn halves<R: Reg>(a: R) -> Halves<R> {
    let t = R::splat(134_217_729.0) * a; // 2^27 + 1
    let hi = t - (t - a);
    Halves { all: a, hi, lo: a - hi }
}

/// Product and its rounding error (Dekker).
#[inline(always)]
fn two_product<R: Reg>(a: Halves<R>, b: Halves<R>) -> (R, R) {
    let p = a.all * b.all;
    (p, a.lo * b.lo - (((p - a.hi * b.hi) - a.lo * b.hi) - a.hi * b.lo))
}
