//! Modified Bessel functions of orders 0, 1, 2 and a complex argument with real part 0 or more, exponentially scaled, over any [`Scalar`].
//!
//! ```text
//! I_n(z) exp(-z),  K_n(z) exp(z)
//! ```
//!
//! Scaled by the complex exponential they stay of the order of `1/sqrt(z)` for any size of z, are analytic, and are closed under differentiation.
//! On the imaginary axis they are the Bessel functions of real argument, `J_n(y) = (-i)^n I_n(i y)`.
//!
//! Method: power series near 0; integrals by the trapezoidal rule in the middle (module `quadrature`; in lanes Miller's recurrence for I); Hankel's expansions
//! (with the recessive exponential in I) from |z| = 25. Error below 2e-14 of the larger of the function and the envelope `1/sqrt(2 pi |z|)`: close to their
//! zeros on the imaginary axis functions are small by cancellation.
//!
//! Sources: NIST Digital Library of Mathematical Functions, chapter 10; L. N. Trefethen, J. A. C. Weideman, SIAM Review 56 (2014) 385.

mod quadrature;

use crate::analytic::Analytic;
use crate::complex::{C64, Complex, c};
use crate::lanes::LANES;
use crate::scalar::Scalar;
use crate::work::spend;
use quadrature::{CLOSE, CLOSEST, at_nodes, middle};
use std::f64::consts::PI;

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;
/// From here on Hankel's expansions reach rounding.
const FAR: f64 = 25.0;
/// To here Miller's recurrence and the integral of K serve lanes.
const MILLER: f64 = 60.0;
/// Beyond this real part `exp(-2 z)` is below rounding.
const SMALL: f64 = 20.0;

/// Scaled functions at one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bessel<S> {
    /// `I_n(z) exp(-z)` for n = 0, 1, 2.
    pub i: [Complex<S>; 3],
    /// `K_n(z) exp(z)` for n = 0, 1, 2.
    pub k: [Complex<S>; 3],
}

/// All six at `z`, Re z >= 0; not a number elsewhere, and where z is 0.
#[inline(always)]
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

/// How lanes are computed.
#[derive(Clone, Copy)]
enum Way {
    /// Miller's recurrence from an order and the integral of K.
    Middle {
        first: u32,
        /// The integral of K with all nodes.
        close: bool,
    },
    Far(Terms),
}

/// Terms of Hankel's expansions.
#[derive(Clone, Copy)]
struct Terms {
    pairs: usize,
    /// The recessive exponential of I counts too.
    whole: bool,
}

impl Analytic<5> for Scaled {
    type Way = Way;
    fn value(z: C64) -> [C64; 5] {
        // NaN, and what overflows or is lost, fails
        let size = z.norm_sqr().sqrt();
        let size = if size > 1e-150 && size < 1e150 { size } else { z.abs() };
        // NaN fails both
        if !(size > 0.0 && z.re >= 0.0) {
            return [c(f64::NAN, f64::NAN); 5];
        }
        if size + z.re < CLOSEST {
            near(z)
        } else if size < FAR {
            middle(z, size)
        } else {
            far(z, Terms { pairs: pairs(size), whole: z.re <= SMALL })
        }
    }
    fn way(re: &[f64; LANES], im: &[f64; LANES]) -> Option<Way> {
        let (mut least, mut most, mut distance, mut whole) = (f64::INFINITY, 0.0f64, f64::INFINITY, false);
        for (re, im) in re.iter().zip(im) {
            let size = (re * re + im * im).sqrt();
            // NaN fails
            if !(*re >= 0.0 && size < 1e150) {
                return None;
            }
            (least, most, distance) = (least.min(size), most.max(size), distance.min(size + re));
            whole |= *re <= SMALL;
        }
        match () {
            () if least >= FAR => Some(Way::Far(Terms { pairs: pairs(least), whole })),
            () if most <= MILLER && distance >= CLOSEST => Some(Way::Middle { first: 20 + (1.6 * most) as u32, close: distance < CLOSE }),
            () => None,
        }
    }
    #[inline(always)]
    fn by<S: Scalar>(way: Way, z: Complex<S>) -> [Complex<S>; 5] {
        match way {
            Way::Far(terms) => far(z, terms),
            Way::Middle { first, close } => {
                let ([i0, i1, i2], [k0, k1]) = (miller(z, first), at_nodes(z, close));
                [i0, i1, i2, k0, k1]
            }
        }
    }
    #[inline(always)]
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

/// Scaled I of orders 0, 1, 2 by Miller's backward recurrence from an order, normalised by `I_0 + 2 sum I_k = exp(z)`; for lanes.
#[inline(always)]
fn miller<S: Scalar>(z: Complex<S>, first: u32) -> [Complex<S>; 3] {
    let r = z.recip().scale(S::cst(2.0));
    let (mut above, mut here) = (Complex::zero(), Complex::real(S::cst(1e-30)));
    let mut sum = here;
    for n in (3..=first).rev() {
        (above, here) = (here, above + here * r.scale(S::cst(f64::from(n))));
        sum += here;
    }
    let first = above + here * r.scale(S::cst(2.0));
    let zeroth = here + first * r;
    let scale = ((sum + first).scale(S::cst(2.0)) + zeroth).recip();
    [zeroth * scale, first * scale, here * scale]
}

/// Terms of [`far`], even and odd ones by turns.
const TERMS: usize = 26;
/// Coefficients of the powers of `1/z` in Hankel's expansions of K for orders 0 and 1: `a_n = prod (4 v^2 - (2 m - 1)^2)/(8 m)`.
const HANKEL: [[f64; TERMS]; 2] = [hankel(0.0), hankel(4.0)];

const fn hankel(four: f64) -> [f64; TERMS] {
    let mut a = [1.0; TERMS];
    let mut n = 1;
    while n < TERMS {
        let odd = 2.0 * n as f64 - 1.0;
        a[n] = a[n - 1] * (four - odd * odd) / (8.0 * n as f64);
        n += 1;
    }
    a
}

/// Pairs of terms that count from this |z| on: n!/(2 |z|)^n of the next is below rounding.
fn pairs(size: f64) -> usize {
    match size {
        s if s < 32.0 => TERMS / 2,
        s if s < 60.0 => 9,
        s if s < 200.0 => 6,
        _ => 4,
    }
}

/// Hankel's expansions by pairs of terms, with the recessive exponential of I where the whole counts; for numbers and for lanes.
#[inline(always)]
fn far<S: Scalar>(z: Complex<S>, Terms { pairs, whole }: Terms) -> [Complex<S>; 5] {
    let r = z.recip();
    // sums of even and odd terms for orders 0 and 1
    let q = r * r;
    let mut sums = [Complex::zero(); 4];
    for n in (0..pairs).rev() {
        for k in 0..4 {
            sums[k] = sums[k] * q;
            sums[k].re += S::cst(HANKEL[k / 2][2 * n + k % 2]);
        }
    }
    let [even0, odd0, even1, odd1] = [sums[0], sums[1] * r, sums[2], sums[3] * r];
    // sqrt(1/(2 pi z)) on the side Re z >= 0
    let root = r.scale(S::cst(0.5 / PI));
    let re = ((root.norm_sqr().sqrt() + root.re).scale(0.5)).sqrt();
    let i_envelope = c(re, root.im.scale(0.5) / re);
    let k_envelope = i_envelope.scale(S::cst(PI));
    let (mut i0, mut i1) = (even0 - odd0, even1 - odd1);
    if whole {
        // i exp(-2 z) on the side of the argument
        let side = z.im.select_pos(S::one(), S::cst(-1.0));
        let recessive = Complex::cis(z.im.scale(-2.0)).scale(z.re.scale(-2.0).exp()).mul_i().scale(side);
        i0 += recessive * (even0 + odd0);
        i1 -= recessive * (even1 + odd1);
    }
    let (i0, i1) = (i_envelope * i0, i_envelope * i1);
    [i0, i1, i0 - (i1 * r).scale(S::cst(2.0)), k_envelope * (even0 + odd0), k_envelope * (even1 + odd1)]
}
