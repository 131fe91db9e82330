//! One processor register of doubles: the few operations from which lanes and elementary functions are built.
//!
//! Every operation is exactly rounded or acts on bits, so that each implementation returns the same bits.

use super::level::{Level, Routine, apart};
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A register of [`Reg::WIDTH`] doubles; `f64` is the register of width one.
///
/// Comparisons are false on NaN. Bit operations treat each double as its 64-bit pattern.
pub trait Reg:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One truth value per lane.
    type Mask: Copy + Debug + Send + Sync + 'static;
    /// Number of lanes.
    const WIDTH: usize;
    /// The level whose instructions are used.
    const LEVEL: Level;
    /// Calls a routine with the instructions of this register.
    fn apart<R: Routine>(routine: R) -> R::Out;
    /// The same value in every lane.
    fn splat(x: f64) -> Self;
    /// Reads the first `WIDTH` values of `from` (which has at least that many).
    fn read(from: &[f64]) -> Self;
    /// Writes to the first `WIDTH` values of `to` (which has at least that many).
    fn write(self, to: &mut [f64]);
    /// Square root.
    fn sqrt(self) -> Self;
    /// `self < o`.
    fn lt(self, o: Self) -> Self::Mask;
    /// `self <= o`.
    fn le(self, o: Self) -> Self::Mask;
    /// `a` where `m` holds, `b` elsewhere.
    fn select(m: Self::Mask, a: Self, b: Self) -> Self;
    /// Bit `i` is the truth value of lane `i`.
    fn mask_bits(m: Self::Mask) -> u8;
    /// Bitwise and.
    fn and(self, o: Self) -> Self;
    /// Bitwise or.
    fn or(self, o: Self) -> Self;
    /// Bitwise exclusive or.
    fn xor(self, o: Self) -> Self;
    /// Wrapping integer addition to the bit pattern.
    fn add_bits(self, o: u64) -> Self;
    /// Bit pattern shifted towards the sign by `n` (a literal at every call).
    fn shl(self, n: i32) -> Self;
    /// Bit pattern shifted away from the sign by `n` (a literal at every call), zeros shifted in.
    fn shr(self, n: i32) -> Self;
    /// True where the lowest bit is set.
    fn odd(self) -> Self::Mask;

    /// The same bit pattern in every lane.
    #[inline(always)]
    fn bits(b: u64) -> Self {
        Self::splat(f64::from_bits(b))
    }
    /// Magnitude.
    #[inline(always)]
    fn abs(self) -> Self {
        self.and(Self::bits(!SIGN))
    }
    /// `self o - product` of the rounded product: exact, where nothing overflows or is subnormal.
    #[inline(always)]
    fn product_error(self, o: Self, product: Self) -> Self {
        // halves of the digits: T. J. Dekker, Numer. Math. 18 (1971) 224-242
        let upper = |x: Self| {
            let scaled = x * Self::splat(134_217_729.0);
            scaled - (scaled - x)
        };
        let (a1, b1) = (upper(self), upper(o));
        let (a2, b2) = (self - a1, o - b1);
        a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2)
    }
    /// True when all lanes hold.
    #[inline(always)]
    fn all(m: Self::Mask) -> bool {
        Self::mask_bits(m) == ((1u32 << Self::WIDTH) - 1) as u8
    }
}

/// The sign bit of a double.
pub const SIGN: u64 = 1 << 63;

impl Reg for f64 {
    type Mask = bool;
    const WIDTH: usize = 1;
    const LEVEL: Level = Level::Base;
    #[inline(always)]
    fn apart<R: Routine>(routine: R) -> R::Out {
        apart(routine)
    }
    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn read(from: &[f64]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn write(self, to: &mut [f64]) {
        to[0] = self;
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn lt(self, o: Self) -> bool {
        self < o
    }
    #[inline(always)]
    fn le(self, o: Self) -> bool {
        self <= o
    }
    #[inline(always)]
    fn select(m: bool, a: Self, b: Self) -> Self {
        // a branch here would be mispredicted: the cases of an elementary function change from call to call
        std::hint::select_unpredictable(m, a, b)
    }
    #[inline(always)]
    fn mask_bits(m: bool) -> u8 {
        m as u8
    }
    #[inline(always)]
    fn and(self, o: Self) -> Self {
        f64::from_bits(self.to_bits() & o.to_bits())
    }
    #[inline(always)]
    fn or(self, o: Self) -> Self {
        f64::from_bits(self.to_bits() | o.to_bits())
    }
    #[inline(always)]
    fn xor(self, o: Self) -> Self {
        f64::from_bits(self.to_bits() ^ o.to_bits())
    }
    #[inline(always)]
    fn add_bits(self, o: u64) -> Self {
        f64::from_bits(self.to_bits().wrapping_add(o))
    }
    #[inline(always)]
    fn shl(self, n: i32) -> Self {
        f64::from_bits(self.to_bits() << n)
    }
    #[inline(always)]
    fn shr(self, n: i32) -> Self {
        f64::from_bits(self.to_bits() >> n)
    }
    #[inline(always)]
    fn odd(self) -> bool {
        self.to_bits() & 1 != 0
    }
}
