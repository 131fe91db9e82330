//! Modified Bessel functions of orders 0, 1, 2 and a complex argument with real part 0 or more, exponentially scaled, over any [`Scalar`].
//!
//! ```text
//! I_n(z) exp(-z),  K_n(z) exp(z)
//! ```
//!
//! Scaled by the complex exponential they stay of the order of `1/sqrt(z)` for any size of z, are analytic, and are closed under differentiation.
//! On the imaginary axis they are the Bessel functions of real argument, `J_n(y) = (-i)^n I_n(i y)`.
//!
//! Method: power series near 0; Miller's backward recurrence, normalised by `I_0 + 2 sum I_k = exp(z)`, with Steed's continued fraction for K in the
//! middle; Hankel's expansions (with the recessive exponential in I) from |z| = 25. Error below 2e-14 of the larger of the function and the envelope
//! `1/sqrt(2 pi |z|)`: close to their zeros on the imaginary axis functions are small by cancellation.
//!
//! Sources: NIST Digital Library of Mathematical Functions, chapter 10; N. M. Temme, J. Comput. Phys. 19 (1975) 324;
//! I. J. Thompson, A. R. Barnett, J. Comput. Phys. 64 (1986) 490.

use crate::analytic::Analytic;
use crate::complex::{C64, Complex, c};
use crate::scalar::Scalar;
use crate::work::spend;
use std::f64::consts::{FRAC_PI_2, PI};

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;
/// From here on Hankel's expansions reach rounding.
const FAR: f64 = 25.0;

/// Scaled functions at one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bessel<S> {
    /// `I_n(z) exp(-z)` for n = 0, 1, 2.
    pub i: [Complex<S>; 3],
    /// `K_n(z) exp(z)` for n = 0, 1, 2.
    pub k: [Complex<S>; 3],
}

/// All six at `z`, Re z >= 0; not a number elsewhere, and where z is 0.
pub fn bessel<S: Scalar>(z: Complex<S>) -> Bessel<S> {
    spend(300 + 40 * size_of::<S>() as u64);
    let [i0, i1, i2, k0, k1] = S::analytic::<5, Scaled>(z);
    Bessel { i: [i0, i1, i2], k: [k0, k1, k0 + k1 * z.recip().scale(S::cst(2.0))] }
}

/// `2 I_1(z)/z - 1` and `8 I_2(z)/z^2 - 1`, unscaled and without cancellation, for |z| <= 3.
pub fn excess<S: Scalar>(z: Complex<S>) -> [Complex<S>; 2] {
    let q = (z * z).scale(S::cst(0.25));
    let (mut first, mut second) = (Complex::zero(), Complex::zero());
    for k in (1..=20).rev() {
        let k = f64::from(k);
        first = (first + Complex::one()) * q.scale(S::cst(1.0 / (k * (k + 1.0))));
        second = (second + Complex::one()) * q.scale(S::cst(1.0 / (k * (k + 2.0))));
    }
    [first, second]
}

/// `(z K_1(z) - 1)/z^2`, unscaled and without cancellation, for |z| <= 2, Re z >= 0; grows as `ln(z)/2` to 0.
pub fn excess_k<S: Scalar>(z: Complex<S>) -> Complex<S> {
    let half = S::cst(0.5);
    let q = (z * z).scale(S::cst(0.25));
    let log = crate::analytic::ln(z.scale(half));
    // sum of (ln(z/2) - (psi(n + 1) + psi(n + 2))/2) q^n/(n! (n + 1)!)/2, from its last term
    let (mut sum, mut harmonic) = (Complex::zero(), (1..=20).map(|n| 1.0 / f64::from(n)).sum::<f64>());
    for n in (0..=20).rev() {
        let n = f64::from(n);
        let psi = harmonic - EULER + 0.5 / (n + 1.0);
        sum = (log - Complex::real(S::cst(psi))) + sum * q.scale(S::cst(1.0 / ((n + 1.0) * (n + 2.0))));
        harmonic -= if n > 0.0 { 1.0 / n } else { 0.0 };
    }
    sum.scale(half)
}

struct Scaled;

impl Analytic<5> for Scaled {
    fn value(z: C64) -> [C64; 5] {
        let size = z.abs();
        // NaN fails both
        if !(size > 0.0 && z.re >= 0.0) {
            return [c(f64::NAN, f64::NAN); 5];
        }
        if size + z.re <= 2.5 {
            near(z)
        } else if size < FAR {
            let ([i0, i1, i2], [k0, k1]) = (miller(z, size), steed(z));
            [i0, i1, i2, k0, k1]
        } else {
            far(z)
        }
    }
    fn slope<S: Scalar>(z: Complex<S>, &[i0, i1, i2, k0, k1]: &[Complex<S>; 5]) -> [Complex<S>; 5] {
        let r = z.recip();
        [i1 - i0, i2 + i1 * r - i1, i1 - (i2 * r).scale(S::cst(2.0)) - i2, k0 - k1, k1 - k0 - k1 * r]
    }
}

/// Power series.
fn near(z: C64) -> [C64; 5] {
    let q = (z * z).scale(0.25);
    let log = z.scale(0.5).ln();
    let (mut term, mut harmonic) = (c(1.0, 0.0), 0.0);
    let (mut i, mut k) = ([C64::zero(); 3], [C64::zero(); 2]);
    for n in 0..30 {
        let m = f64::from(n);
        // term = q^n / n!^2
        let next = harmonic + 1.0 / (m + 1.0);
        i[0] += term;
        i[1] += term.scale(1.0 / (m + 1.0));
        i[2] += term.scale(1.0 / ((m + 1.0) * (m + 2.0)));
        k[0] += term.scale(harmonic);
        k[1] += term.scale((harmonic + next - 2.0 * EULER) / (m + 1.0));
        if term.norm_sqr() < 1e-36 {
            break;
        }
        harmonic = next;
        term = term * q.scale(1.0 / ((m + 1.0) * (m + 1.0)));
    }
    let half = z.scale(0.5);
    let i = [i[0], i[1] * half, i[2] * half * half];
    let k0 = k[0] - (log + c(EULER, 0.0)) * i[0];
    let k1 = z.recip() + log * i[1] - k[1] * half.scale(0.5);
    let (down, up) = ((-z).exp(), z.exp());
    [i[0] * down, i[1] * down, i[2] * down, k0 * up, k1 * up]
}

/// Scaled I of orders 0, 1, 2.
fn miller(z: C64, size: f64) -> [C64; 3] {
    let r = z.recip().scale(2.0);
    let first = 20 + (1.6 * size) as i32;
    let (mut above, mut here) = (C64::zero(), c(1e-30, 0.0));
    let mut sum = here;
    let mut low = [C64::zero(); 3];
    for n in (1..=first).rev() {
        let below = above + here * r.scale(f64::from(n));
        (above, here) = (here, below);
        if n <= 3 {
            low[n as usize - 1] = below;
        }
        if n > 1 {
            sum += below;
        }
    }
    let scale = (sum.scale(2.0) + here).recip();
    low.map(|x| x * scale)
}

/// Scaled K of orders 0 and 1.
fn steed(z: C64) -> [C64; 2] {
    let mut b = (z + c(1.0, 0.0)).scale(2.0);
    let mut d = b.recip();
    let (mut h, mut step) = (d, d);
    let (mut q1, mut q2) = (C64::zero(), c(1.0, 0.0));
    let first = 0.25;
    let (mut a, mut co) = (-first, first);
    let mut q = c(first, 0.0);
    let mut s = c(1.0, 0.0) + q * step;
    for n in 2..500 {
        let m = f64::from(n);
        a -= 2.0 * (m - 1.0);
        co *= -a / m;
        let next = (q1 - b * q2).scale(1.0 / a);
        (q1, q2) = (q2, next);
        q += next.scale(co);
        b.re += 2.0;
        d = (b + d.scale(a)).recip();
        step = (b * d - c(1.0, 0.0)) * step;
        h += step;
        let ds = q * step;
        s += ds;
        if ds.norm_sqr() < 1e-34 * s.norm_sqr() {
            break;
        }
    }
    let k0 = (z.recip().scale(FRAC_PI_2)).sqrt() * s.recip();
    [k0, k0 * (z + c(0.5, 0.0) - h.scale(first)) * z.recip()]
}

/// Hankel's expansions.
fn far(z: C64) -> [C64; 5] {
    let r = z.recip();
    // sums of even and odd terms for orders 0 and 1
    let sums = [0.0, 4.0].map(|four| {
        let (mut even, mut odd) = (c(1.0, 0.0), C64::zero());
        let mut term = c(1.0, 0.0);
        for n in 1..60 {
            let m = f64::from(n);
            let factor = (four - (2.0 * m - 1.0) * (2.0 * m - 1.0)) / (8.0 * m);
            term = term * r.scale(factor);
            if n % 2 == 0 {
                even += term;
            } else {
                odd += term;
            }
            if term.norm_sqr() < 1e-36 {
                break;
            }
        }
        (even, odd)
    });
    let i_envelope = r.scale(0.5 / PI).sqrt();
    let k_envelope = r.scale(FRAC_PI_2).sqrt();
    // i exp(-2 z) on the side of the argument
    let recessive = if z.re > 20.0 { C64::zero() } else { z.scale(-2.0).exp().mul_i().scale(1f64.copysign(z.im)) };
    let of = |(even, odd): (C64, C64), sign: f64| i_envelope * (even - odd + (recessive * (even + odd)).scale(sign));
    let (i0, i1) = (of(sums[0], 1.0), of(sums[1], -1.0));
    let k = sums.map(|(even, odd)| k_envelope * (even + odd));
    [i0, i1, i0 - (i1 * r).scale(2.0), k[0], k[1]]
}
