//! Elementary functions written once over a register, so that `f64` and the lanes of every level return the same bits.
//!
//! Only exactly rounded operations are used and none is fused: a fused multiply-add exists at the AVX2 and AVX-512 levels but is a
//! slow library call at the baseline, so the one rule that gives the same bits everywhere at full speed is to fuse nowhere.
//! Signs and payloads of NaN are not specified.
//!
//! Largest error against 260-bit arithmetic over 1e5 random points, in units in the last place: `sin_cos` 0.75 (up to 1e6, with the
//! doubles nearest to multiples of pi/2), `sin_cos_quarters` 1.75, `exp` 0.88, `ln` 0.75, `pow_pos` 0.87, `atan2` 1.24. Subnormal results excepted.
//!
//! The functions evaluate all cases and select, so a register costs the same whatever it holds. Only angles beyond
//! [`SIN_COS_DIRECT`] and powers of registers without a positive lane leave the straight line.
//!
//! Polynomials of `sin_cos`, `ln` and `atan2` are those of fdlibm (Sun Microsystems, 1993; permission to use, copy, modify and
//! distribute is freely granted, provided that this notice is preserved).

// constants are written as published
#![allow(clippy::excessive_precision)]

use super::reg::{Reg, SIGN};

/// Adding `1.5 * 2^52` rounds to the nearest integer and leaves that integer in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Up to this magnitude `sin_cos` reduces the angle itself; beyond it uses the standard library, lane by lane.
pub const SIN_COS_DIRECT: f64 = 1e6;

// pi/2 in three parts of 33 bits and a rest: integer multiples below 2^20 of the parts are exact
const PIO2_1: f64 = f64::from_bits(0x3FF9_21FB_5440_0000);
const PIO2_2: f64 = f64::from_bits(0x3DD0_B461_1A60_0000);
const PIO2_3: f64 = f64::from_bits(0x3BA3_198A_2E00_0000);
const PIO2_4: f64 = f64::from_bits(0x397B_839A_2520_49C1);

const S1: f64 = -1.666_666_666_666_663_243_48e-01;
const S2: f64 = 8.333_333_333_322_489_461_24e-03;
const S3: f64 = -1.984_126_982_985_794_931_34e-04;
const S4: f64 = 2.755_731_370_707_006_767_89e-06;
const S5: f64 = -2.505_076_025_340_686_341_95e-08;
const S6: f64 = 1.589_690_995_211_550_102_21e-10;
const C1: f64 = 4.166_666_666_666_660_190_37e-02;
const C2: f64 = -1.388_888_888_887_410_957_49e-03;
const C3: f64 = 2.480_158_728_947_672_941_78e-05;
const C4: f64 = -2.755_731_435_139_066_330_35e-07;
const C5: f64 = 2.087_572_321_298_174_827_90e-09;
const C6: f64 = -1.135_964_755_778_819_482_65e-11;

/// Sum and its rounding error, exact when `|a| >= |b|` or `a` is a multiple of the last place of `b`.
#[inline(always)]
pub(super) fn fast_two_sum<R: Reg>(a: R, b: R) -> (R, R) {
    let s = a + b;
    (s, b - (s - a))
}

/// Sine and cosine of `x` in radians. Infinities give NaN.
#[inline(always)]
pub fn sin_cos<R: Reg>(x: R) -> (R, R) {
    let c = R::splat;
    let n = x * c(std::f64::consts::FRAC_2_PI) + c(ROUND);
    let k = n - c(ROUND);
    // x - k pi/2 as y + t; the first difference is exact and each sum catches its rounding
    let r = x - k * c(PIO2_1);
    let (r, e1) = fast_two_sum(r, -(k * c(PIO2_2)));
    let (r, e2) = fast_two_sum(r, -(k * c(PIO2_3)));
    let rest = k * c(PIO2_4) - (e1 + e2);
    let y = r - rest;
    let t = (r - y) - rest;

    let z = y * y;
    let w = z * z;
    let p = c(S2) + z * (c(S3) + z * c(S4)) + z * w * (c(S5) + z * c(S6));
    let v = z * y;
    let s = y - ((z * (c(0.5) * t - v * p) - t) - v * c(S1));
    let p = z * (c(C1) + z * (c(C2) + z * c(C3))) + w * w * (c(C4) + z * (c(C5) + z * c(C6)));
    let h = c(0.5) * z;
    let q = c(1.0) - h;
    let co = q + (((c(1.0) - q) - h) + (z * p - y * t));

    let (sin, cos) = in_quadrant(n, s, co);
    if R::all(x.abs().le(c(SIN_COS_DIRECT))) {
        (sin, cos)
    } else {
        let mut sc = [sin, cos];
        sin_cos_far(&x, &mut sc);
        (sc[0], sc[1])
    }
}

/// Sine and cosine of the angle in the quadrant that the low bits of `n` count: bit 0 exchanges the two, bit 1 of n and of n + 1 are their signs.
#[inline(always)]
fn in_quadrant<R: Reg>(n: R, s: R, co: R) -> (R, R) {
    let swap = n.odd();
    let sin = R::select(swap, co, s).xor(n.shl(62).and(R::bits(SIGN)));
    let cos = R::select(swap, s, co).xor((n + R::splat(1.0)).shl(62).and(R::bits(SIGN)));
    (sin, cos)
}

/// Sine and cosine of `x` quarter turns; more than 2^51 of them, infinities and NaN give NaN.
///
/// Whole quarters are taken off without error, so that the reduction costs next to nothing.
#[inline(always)]
pub fn sin_cos_quarters<R: Reg>(x: R) -> (R, R) {
    let c = R::splat;
    // beyond this what is left is no fraction
    let x = R::select(x.abs().lt(c(2_251_799_813_685_248.0)), x, c(f64::NAN));
    let n = x + c(ROUND);
    let y = (x - (n - c(ROUND))) * c(std::f64::consts::FRAC_PI_2);
    let z = y * y;
    let w = z * z;
    let p = c(S1) + z * (c(S2) + z * c(S3)) + z * w * (c(S4) + z * (c(S5) + z * c(S6)));
    let s = y + z * y * p;
    let p = c(C1) + z * (c(C2) + z * c(C3)) + z * w * (c(C4) + z * (c(C5) + z * c(C6)));
    let co = c(1.0) - (c(0.5) * z - w * p);
    in_quadrant(n, s, co)
}

/// Replaces the lanes that `sin_cos` cannot reduce: large angles, infinities, NaN.
#[cold]
#[inline(never)]
fn sin_cos_far<R: Reg>(x: &R, sc: &mut [R; 2]) {
    let (mut xs, mut s, mut c) = ([0.0; 8], [0.0; 8], [0.0; 8]);
    x.write(&mut xs);
    sc[0].write(&mut s);
    sc[1].write(&mut c);
    for i in 0..R::WIDTH {
        if xs[i].abs() > SIN_COS_DIRECT || xs[i].is_nan() {
            (s[i], c[i]) = xs[i].sin_cos();
        }
    }
    *sc = [R::read(&s), R::read(&c)];
}

/// `ln 2` in 33 bits, so that its multiples by exponents are exact, and the rest.
pub(super) const LN2_HI: f64 = 6.931_471_803_691_238_164_90e-01;
pub(super) const LN2_LO: f64 = 1.908_214_929_270_587_700_02e-10;

/// `e^x`: 0 far below, infinite far above, subnormal results rounded once.
#[inline(always)]
pub fn exp<R: Reg>(x: R) -> R {
    exp_sum(x, R::splat(0.0))
}

/// `e^(x + tail)` for a tail below the last places of `x`.
#[inline(always)]
pub(super) fn exp_sum<R: Reg>(x: R, tail: R) -> R {
    let c = R::splat;
    // beyond these bounds the result is infinite or zero already; NaN passes both comparisons
    let (top, bottom) = (c(710.0), c(-746.0));
    let tail = R::select(top.lt(x), c(0.0), R::select(x.lt(bottom), c(0.0), tail));
    let x = R::select(top.lt(x), top, R::select(x.lt(bottom), bottom, x));

    let k = (x * c(std::f64::consts::LOG2_E) + c(ROUND)) - c(ROUND);
    let hi = x - k * c(LN2_HI);
    let lo = k * c(LN2_LO) - tail;
    let r = hi - lo;
    // Taylor: |r| <= ln(2)/2, the term of order 14 is below 5e-18; even and odd parts side by side
    let z = r * r;
    const I: [f64; 14] = inverse_factorials();
    let even = c(I[2]) + z * (c(I[4]) + z * (c(I[6]) + z * (c(I[8]) + z * (c(I[10]) + z * c(I[12])))));
    let odd = c(I[3]) + z * (c(I[5]) + z * (c(I[7]) + z * (c(I[9]) + z * (c(I[11]) + z * c(I[13])))));
    let q = z * (even + r * odd);
    let y = c(1.0) + (hi + (q - lo));
    // two factors, because 2^k itself need not be a normal number; the first product is exact
    let half = (k * c(0.5) + c(ROUND)) - c(ROUND);
    y * power_of_two(half) * power_of_two(k - half)
}

const fn inverse_factorials() -> [f64; 14] {
    let mut out = [1.0; 14];
    let (mut i, mut f) = (1, 1.0);
    while i < 14 {
        f *= i as f64;
        out[i] = 1.0 / f;
        i += 1;
    }
    out
}

/// `2^m` for an integer `-1022 <= m <= 1023`.
#[inline(always)]
fn power_of_two<R: Reg>(m: R) -> R {
    (m + R::splat(ROUND + 1023.0)).shl(52)
}

/// `x = 2^k (1 + f)` with `1 + f` in `[sqrt(1/2), sqrt(2))`, for positive finite `x`.
#[inline(always)]
pub(super) fn split_exponent<R: Reg>(x: R) -> (R, R) {
    let c = R::splat;
    const SQRT_HALF: u64 = 0x3FE6_A09E << 32;
    const ONE: u64 = 0x3FF0_0000 << 32;
    const TWO_52: f64 = 4_503_599_627_370_496.0;
    let subnormal = x.lt(c(f64::MIN_POSITIVE));
    let x = R::select(subnormal, x * c(18_014_398_509_481_984.0), x); // 2^54
    let b = x.add_bits(ONE - SQRT_HALF);
    let bias = R::select(subnormal, c(TWO_52 + 1023.0 + 54.0), c(TWO_52 + 1023.0));
    let k = b.shr(52).or(c(TWO_52)) - bias;
    let m = b.and(R::bits(0x000F_FFFF_FFFF_FFFF)).add_bits(SQRT_HALF);
    (k, m - c(1.0))
}

/// Natural logarithm: minus infinity at zero, NaN below.
#[inline(always)]
pub fn ln<R: Reg>(x: R) -> R {
    let c = R::splat;
    let (k, f) = split_exponent(x);
    let h = c(0.5) * f * f;
    let s = f / (c(2.0) + f);
    let z = s * s;
    let w = z * z;
    let even = w * (c(L2) + w * (c(L4) + w * c(L6)));
    let odd = z * (c(L1) + w * (c(L3) + w * (c(L5) + w * c(L7))));
    let y = k * c(LN2_HI) - ((h - (s * (h + (even + odd)) + k * c(LN2_LO))) - f);
    // infinity and NaN return themselves
    let y = R::select(x.lt(c(f64::INFINITY)), y, x);
    R::select(x.le(c(0.0)), R::select(x.lt(c(0.0)), c(f64::NAN), c(f64::NEG_INFINITY)), y)
}

const L1: f64 = 6.666_666_666_666_735_130e-01;
const L2: f64 = 3.999_999_999_940_941_908e-01;
const L3: f64 = 2.857_142_874_366_239_149e-01;
const L4: f64 = 2.222_219_843_214_978_396e-01;
const L5: f64 = 1.818_357_216_161_805_012e-01;
const L6: f64 = 1.531_383_769_920_937_332e-01;
const L7: f64 = 1.479_819_860_511_658_591e-01;

/// `max(x, 0)`; NaN passes.
#[inline(always)]
pub fn pos<R: Reg>(x: R) -> R {
    R::select(x.le(R::splat(0.0)), R::splat(0.0), x)
}

/// Angle of the point `(x, y)`, signed zeros and infinities as in IEEE 754.
#[inline(always)]
pub fn atan2<R: Reg>(y: R, x: R) -> R {
    let c = R::splat;
    let (zero, one, inf) = (c(0.0), c(1.0), c(f64::INFINITY));
    let (u, v) = (x.abs(), y.abs());
    let steep = u.lt(v);
    // b >= a, except that NaN may be either
    let (a, b) = (R::select(steep, u, v), R::select(steep, v, u));
    // keep clear of overflow and of subnormal numbers
    let factor = R::select(c(2f64.powi(900)).lt(b), c(2f64.powi(-600)), R::select(b.lt(c(2f64.powi(-900))), c(2f64.powi(600)), one));
    let infinite = inf.le(b);
    let a = R::select(infinite, R::select(inf.le(a), one, a * zero), a * factor);
    let b = R::select(infinite, one, b * factor);
    // two zeros: the angle of (1, 0); a zero times NaN stays NaN
    let b = R::select(b.le(zero), one, b);

    // atan(a/b) = atan(m) + atan((a - m b)/(b + m a)), m = 0, 1/2, 1; the numerator is exact
    let low = a.lt(b * c(0.4375));
    let middle = a.lt(b * c(0.6875));
    let m = R::select(low, zero, R::select(middle, c(0.5), one));
    let base = R::select(low, zero, R::select(middle, c(ATAN_HALF.0), c(std::f64::consts::FRAC_PI_4)));
    let base_lo = R::select(low, zero, R::select(middle, c(ATAN_HALF.1), c(PIO2_LO * 0.5)));
    let t = (a - m * b) / (b + m * a);
    let z = t * t;
    let w = z * z;
    const A: [f64; 11] = ATAN;
    let even = z * (c(A[0]) + w * (c(A[2]) + w * (c(A[4]) + w * (c(A[6]) + w * (c(A[8]) + w * c(A[10]))))));
    let odd = w * (c(A[1]) + w * (c(A[3]) + w * (c(A[5]) + w * (c(A[7]) + w * c(A[9])))));
    // the angle as hi + lo through the reflections at the diagonal and at the vertical
    let (hi, lo) = fast_two_sum(base, t);
    let lo = lo + (base_lo - t * (even + odd));
    let (h, l) = fast_two_sum(c(std::f64::consts::FRAC_PI_2), -hi);
    let (hi, lo) = (R::select(steep, h, hi), R::select(steep, (l - lo) + c(PIO2_LO), lo));
    let (h, l) = fast_two_sum(c(std::f64::consts::PI), -hi);
    let left = sign(x).or(one).lt(zero);
    let (hi, lo) = (R::select(left, h, hi), R::select(left, (l - lo) + c(PIO2_LO * 2.0), lo));
    (hi + lo).or(sign(y))
}

/// The sign bit alone.
#[inline(always)]
fn sign<R: Reg>(x: R) -> R {
    x.and(R::bits(SIGN))
}

/// `pi/2` minus its double.
const PIO2_LO: f64 = 6.123_233_995_736_766_035_87e-17;
/// `atan(1/2)` as a sum of two doubles.
const ATAN_HALF: (f64, f64) = (4.636_476_090_008_060_935_15e-01, 2.269_877_745_296_168_709_24e-17);
const ATAN: [f64; 11] = [
    3.333_333_333_333_293_180_27e-01,
    -1.999_999_999_987_648_324_76e-01,
    1.428_571_427_250_346_637_11e-01,
    -1.111_111_040_546_235_578_80e-01,
    9.090_887_133_436_506_561_96e-02,
    -7.691_876_205_044_829_994_95e-02,
    6.661_073_137_387_531_206_69e-02,
    -5.833_570_133_790_573_486_45e-02,
    4.976_877_994_615_932_360_17e-02,
    -3.653_157_274_421_691_552_70e-02,
    1.628_582_011_536_578_236_23e-02,
];
