//! Members side by side: lanes for every processor level, chosen at run time.
//!
//! A computation written over [`LaneScalar`] (or plain [`Scalar`]) is a [`Kernel`]; [`dispatch`] enters it once with the lane type of
//! the level, and everything inside is inlined there. A function of an object that must be erased is an
//! [`Apply`], called through the slots of [`Slots`].
//!
//! The width is the same at every level and no operation is fused unless its result is exact, so lanes, levels and `f64` agree bit for bit (any NaN counts as NaN). It is two
//! registers at the highest level: while one waits for a result the other computes, and what is not arithmetic is shared.

// several arrays of registers are walked in step
#![allow(clippy::needless_range_loop)]

mod level;
pub mod math;
mod pow;
mod reg;
mod sparse;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use level::apart;
#[cfg(test)]
pub(crate) use level::upper_halves_in_use;
pub use level::{Apply, Entry, Family, Kernel, Level, Routine, Slots, cleared, dispatch};
pub use pow::pow_pos;
pub use reg::Reg;
pub use sparse::Sparse;

use crate::analytic::Analytic;
use crate::complex::{Complex, c};
use crate::scalar::Scalar;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Number of lanes at every level.
pub const LANES: usize = 16;
/// One bit for each lane.
pub type Bits = u16;
const _: () = assert!(Bits::BITS as usize == LANES);

/// A double for each lane, in `K` registers.
///
/// # Condition
/// A type of a level above the baseline may be used only on a processor that has the level; [`dispatch`] and [`Slots`] see to that,
/// and nothing else should name the types. Debug builds assert it wherever a constant is made.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Lanes<R, const K: usize>([R; K]);

/// Lanes of plain doubles, for processors without a level of their own and as reference.
pub type LanesPlain = Lanes<f64, LANES>;
/// Lanes at [`Level::Base`].
#[cfg(target_arch = "x86_64")]
pub type LanesBase = Lanes<x86::Xmm, { LANES / 2 }>;
/// Lanes at [`Level::Base`].
#[cfg(not(target_arch = "x86_64"))]
pub type LanesBase = LanesPlain;
/// Lanes at [`Level::Avx2`].
#[cfg(target_arch = "x86_64")]
pub type LanesAvx2 = Lanes<x86::Ymm, { LANES / 4 }>;
/// Lanes at [`Level::Avx512`].
#[cfg(target_arch = "x86_64")]
pub type LanesAvx512 = Lanes<x86::Zmm, { LANES / 8 }>;

/// One truth value per lane, bit `i` for lane `i`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneBits(pub Bits);

impl LaneBits {
    /// True when a lane holds.
    #[inline(always)]
    pub fn any(self) -> bool {
        self.0 != 0
    }
    /// True when all lanes hold.
    #[inline(always)]
    pub fn all(self) -> bool {
        self.0 == Bits::MAX
    }
    /// Lane `i`.
    #[inline(always)]
    pub fn get(self, i: usize) -> bool {
        i < LANES && self.0 >> i & 1 != 0
    }
}

/// A [`Scalar`] of all lanes.
pub trait LaneScalar: Scalar<Base = Self> + Entry {
    /// The level whose instructions the type uses.
    const LEVEL: Level;
    /// One register's truth values each.
    type Mask: Copy;
    /// Reads the values of all lanes.
    fn load(from: &[f64; LANES]) -> Self;
    /// Writes the values of all lanes.
    fn store(self, to: &mut [f64; LANES]);
    /// `self < o`, false on NaN.
    fn lt(self, o: Self) -> Self::Mask;
    /// `self <= o`, false on NaN.
    fn le(self, o: Self) -> Self::Mask;
    /// `a` where the mask holds, `b` elsewhere.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// The mask as bits.
    fn bits(mask: Self::Mask) -> LaneBits;
    /// From an array.
    #[inline(always)]
    fn from_array(x: [f64; LANES]) -> Self {
        Self::load(&x)
    }
    /// To an array.
    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        let mut x = [0.0; LANES];
        self.store(&mut x);
        x
    }
    /// Lane `i < LANES`.
    #[inline(always)]
    fn get(self, i: usize) -> f64 {
        self.to_array()[i]
    }
    /// Lanes that are NaN or infinite are false.
    #[inline(always)]
    fn finite(self) -> LaneBits {
        Self::bits(self.abs().lt(Self::cst(f64::INFINITY)))
    }
}

impl<R: Reg, const K: usize> LaneScalar for Lanes<R, K>
where
    Self: Entry + Scalar<Base = Self>,
{
    const LEVEL: Level = R::LEVEL;
    type Mask = [R::Mask; K];
    #[inline(always)]
    fn load(from: &[f64; LANES]) -> Self {
        let mut a = [R::splat(0.0); K];
        for i in 0..K {
            a[i] = R::read(&from[i * R::WIDTH..]);
        }
        Lanes(a)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64; LANES]) {
        for i in 0..K {
            self.0[i].write(&mut to[i * R::WIDTH..]);
        }
    }
    #[inline(always)]
    fn lt(self, o: Self) -> Self::Mask {
        let mut m = [self.0[0].lt(o.0[0]); K];
        for i in 1..K {
            m[i] = self.0[i].lt(o.0[i]);
        }
        m
    }
    #[inline(always)]
    fn le(self, o: Self) -> Self::Mask {
        let mut m = [self.0[0].le(o.0[0]); K];
        for i in 1..K {
            m[i] = self.0[i].le(o.0[i]);
        }
        m
    }
    #[inline(always)]
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self {
        let mut out = b;
        for i in 0..K {
            out.0[i] = R::select(mask[i], a.0[i], b.0[i]);
        }
        out
    }
    #[inline(always)]
    fn bits(mask: Self::Mask) -> LaneBits {
        let mut bits = 0;
        for i in 0..K {
            bits |= Bits::from(R::mask_bits(mask[i])) << (i * R::WIDTH);
        }
        LaneBits(bits)
    }
}

impl<R: Reg, const K: usize> std::fmt::Debug for Lanes<R, K> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.plain().fmt(f)
    }
}

impl<R: Reg, const K: usize> Lanes<R, K> {
    #[inline(always)]
    fn plain(self) -> [f64; LANES] {
        let mut a = [0.0; LANES];
        for i in 0..K {
            self.0[i].write(&mut a[i * R::WIDTH..]);
        }
        a
    }
    #[inline(always)]
    fn from_plain(from: &[f64; LANES]) -> Self {
        Lanes(std::array::from_fn(|i| R::read(&from[i * R::WIDTH..])))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $assign_trait:ident, $assign:ident, $op:tt) => {
        impl<R: Reg, const K: usize> $trait for Lanes<R, K> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, o: Self) -> Self {
                for i in 0..K {
                    self.0[i] = self.0[i] $op o.0[i];
                }
                self
            }
        }
        impl<R: Reg, const K: usize> $assign_trait for Lanes<R, K> {
            #[inline(always)]
            fn $assign(&mut self, o: Self) {
                *self = *self $op o;
            }
        }
    };
}
operator!(Add, add, AddAssign, add_assign, +);
operator!(Sub, sub, SubAssign, sub_assign, -);
operator!(Mul, mul, MulAssign, mul_assign, *);
operator!(Div, div, DivAssign, div_assign, /);

/// Applies a register function to each register in place.
macro_rules! each {
    ($self:ident, $x:ident, $i:ident, $f:expr) => {{
        let mut out = $self;
        for $i in 0..K {
            let $x = $self.0[$i];
            out.0[$i] = $f;
        }
        out
    }};
}

impl<R: Reg, const K: usize> Neg for Lanes<R, K> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        each!(self, x, i, -x)
    }
}

impl<R: Reg, const K: usize> Scalar for Lanes<R, K> {
    type Base = Self;
    type Over<L: LaneScalar> = L;
    const SPREADS: bool = false;
    #[inline(always)]
    fn apart<W: Routine>(routine: W) -> W::Out {
        R::apart(routine)
    }
    #[inline(always)]
    fn base(self) -> Self {
        self
    }
    #[inline(always)]
    fn constant(x: Self) -> Self {
        x
    }
    #[inline(always)]
    fn spread<L: LaneScalar>(self) -> L {
        L::cst(f64::NAN)
    }
    #[inline(always)]
    fn lane<L: LaneScalar>(_: L, _: usize) -> Self {
        Self::cst(f64::NAN)
    }
    #[inline(always)]
    fn cst(x: f64) -> Self {
        debug_assert!(R::LEVEL <= Level::best(), "lanes of a level that this processor lacks");
        Lanes([R::splat(x); K])
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut s, mut c) = (self, self);
        for i in 0..K {
            (s.0[i], c.0[i]) = math::sin_cos(self.0[i]);
        }
        (s, c)
    }
    #[inline(always)]
    fn sin_cos_quarters(self) -> (Self, Self) {
        let (mut s, mut c) = (self, self);
        for i in 0..K {
            (s.0[i], c.0[i]) = math::sin_cos_quarters(self.0[i]);
        }
        (s, c)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        each!(self, x, i, x.sqrt())
    }
    #[inline(always)]
    fn exp(self) -> Self {
        each!(self, x, i, math::exp(x))
    }
    #[inline(always)]
    fn ln(self) -> Self {
        each!(self, x, i, math::ln(x))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        each!(self, y, i, math::atan2(y, x.0[i]))
    }
    #[inline(always)]
    fn pos(self) -> Self {
        each!(self, x, i, math::pos(x))
    }
    #[inline(always)]
    fn pow_pos(self, p: f64) -> Self {
        each!(self, x, i, pow_pos(x, p))
    }
    #[inline(always)]
    fn select_pos(self, then: Self, other: Self) -> Self {
        each!(self, x, i, R::select(R::splat(0.0).lt(x), then.0[i], other.0[i]))
    }
    #[inline(always)]
    fn value(self) -> f64 {
        let a = self.plain();
        if a.iter().all(|x| *x == a[0]) { a[0] } else { f64::NAN }
    }
    #[inline(always)]
    fn is_nothing(self) -> bool {
        let zero = R::splat(0.0);
        let mut all = true;
        for i in 0..K {
            let both = R::mask_bits(self.0[i].le(zero)) & R::mask_bits(zero.le(self.0[i]));
            all &= u32::from(both) + 1 == 1 << R::WIDTH;
        }
        all
    }
    #[inline(always)]
    fn analytic<const N: usize, F: Analytic<N>>(z: Complex<Self>) -> [Complex<Self>; N] {
        let (re, im) = (z.re.plain(), z.im.plain());
        if let Some(way) = F::way(&re, &im) {
            return F::by(way, z);
        }
        let (re, im) = by_lane::<N, F>(&re, &im);
        let mut out = [Complex::zero(); N];
        for i in 0..N {
            out[i] = c(Self::from_plain(&re[i]), Self::from_plain(&im[i]));
        }
        out
    }
    #[inline(always)]
    fn scale(self, k: f64) -> Self {
        each!(self, x, i, x * R::splat(k))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        each!(self, x, i, x.abs())
    }
    #[inline(always)]
    fn product_error(self, o: Self, product: Self) -> Self {
        each!(self, x, i, x.product_error(o.0[i], product.0[i]))
    }
}

/// Real and imaginary parts of functions, lane by lane.
type Parts<const N: usize> = ([[f64; LANES]; N], [[f64; LANES]; N]);

#[inline(never)]
fn by_lane<const N: usize, F: Analytic<N>>(re: &[f64; LANES], im: &[f64; LANES]) -> Parts<N> {
    let mut out = ([[0.0; LANES]; N], [[0.0; LANES]; N]);
    for l in 0..LANES {
        for (i, value) in F::value(c(re[l], im[l])).into_iter().enumerate() {
            (out.0[i][l], out.1[i][l]) = (value.re, value.im);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On x86-64 nothing enters the lanes of plain doubles, so they are compared here.
    #[test]
    fn plain_lanes_equal_scalar() {
        let x = [0.3, -2.5, 1e5, 2e6, 0.0, 17.0, f64::NAN, -0.0].repeat(2).try_into().unwrap();
        let y = [1.3, 2.5, -1e-5, 2e6, 0.0, -17.0, 3.0, f64::INFINITY].repeat(2).try_into().unwrap();
        let (a, b) = (Lanes(x), Lanes(y));
        let all = |f: &dyn Fn(f64, f64) -> f64, lanes: LanesPlain| {
            for i in 0..LANES {
                let (g, e) = (lanes.0[i], f(x[i], y[i]));
                assert!(g.to_bits() == e.to_bits() || (g.is_nan() && e.is_nan()), "{g} {e}");
            }
        };
        all(&|x, y| x / y + x * y - x, a / b + a * b - a);
        all(&|x, _| Scalar::sin(x), a.sin());
        all(&|x, _| Scalar::exp(x), a.exp());
        all(&|x, _| Scalar::ln(x), a.ln());
        all(&|x, y| Scalar::atan2(x, y), a.atan2(b));
        all(&|x, _| x.pow_pos(1.3), a.pow_pos(1.3));
        all(&|x, y| x.select_pos(y, -y), a.select_pos(b, -b));
        all(&|x, y| Scalar::norm2(x, y) + x.pos(), a.norm2(b) + a.pos());
    }

    #[test]
    fn functions_of_complex_argument_lane_by_lane() {
        let re: [f64; LANES] = std::array::from_fn(|i| i as f64 - 2.3);
        let im: [f64; LANES] = std::array::from_fn(|i| 0.7 * (i as f64 - 4.1));
        let r = crate::analytic::sqrt(c(Lanes(re), Lanes(im)));
        for i in 0..LANES {
            assert_eq!(c(r.re.0[i], r.im.0[i]), c(re[i], im[i]).sqrt());
        }
        // of lanes that differ there is no single value
        assert!(Lanes(re).value().is_nan() && Lanes([3.0; LANES]).value() == 3.0);
    }
}
