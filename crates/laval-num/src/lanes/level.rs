//! Processor levels and how a generic kernel enters one.

use super::{LaneScalar, LanesBase};
#[cfg(target_arch = "x86_64")]
use super::{LanesAvx2, LanesAvx512};
use crate::scalar::Scalar;

/// Instructions used for lanes, in rising order. The results are the same at every level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// What every processor of the target has (x86-64: SSE2, registers of two).
    Base,
    /// AVX2 and FMA, registers of four.
    Avx2,
    /// AVX-512 F and DQ, registers of eight.
    Avx512,
}

impl Level {
    /// The highest level of this processor.
    #[inline(always)]
    pub fn best() -> Level {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") && is_x86_feature_detected!("avx2") {
                return Level::Avx512;
            }
            if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
                return Level::Avx2;
            }
        }
        Level::Base
    }
    /// All levels of this processor, lowest first.
    pub fn supported() -> impl Iterator<Item = Level> {
        let best = Level::best();
        [Level::Base, Level::Avx2, Level::Avx512].into_iter().filter(move |&level| level <= best)
    }
    /// Name for a manifest: `base`, `avx2`, `avx512`.
    pub fn name(self) -> &'static str {
        match self {
            Level::Base => "base",
            Level::Avx2 => "avx2",
            Level::Avx512 => "avx512",
        }
    }
}

/// A computation written once for the lanes of any level, entered by [`dispatch`].
///
/// `run` and every generic function it calls inside its loop must be `#[inline(always)]`: a function that is called instead of inlined
/// does not have the level's instructions, and each operation in it becomes a call. Closures count as functions: those handed to
/// `array::map` or an iterator may stay calls, so hot code uses plain loops.
pub trait Kernel {
    /// Result.
    type Out;
    /// The computation, for the lane type of one level.
    fn run<S: LaneScalar>(self) -> Self::Out;
}

/// Runs `kernel` at `level`, or at the best level of the processor when that is lower.
///
/// ```
/// use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
/// struct Roots<'a>(&'a mut [[f64; LANES]]);
/// impl Kernel for Roots<'_> {
///     type Out = ();
///     #[inline(always)]
///     fn run<S: LaneScalar>(self) {
///         for x in self.0 {
///             S::load(x).sqrt().store(x);
///         }
///     }
/// }
/// let mut x = [[4.0; LANES]; 3];
/// dispatch(Level::best(), Roots(&mut x));
/// assert_eq!(x, [[2.0; LANES]; 3]);
/// ```
#[inline]
pub fn dispatch<K: Kernel>(level: Level, kernel: K) -> K::Out {
    match level.min(Level::best()) {
        // SAFETY: the processor has the level, `best` says so
        #[cfg(target_arch = "x86_64")]
        Level::Avx512 => unsafe { run_avx512(kernel) },
        #[cfg(target_arch = "x86_64")]
        Level::Avx2 => unsafe { run_avx2(kernel) },
        _ => run_base(kernel),
    }
}

/// A call of its own: what enters a level stays short.
#[inline(never)]
fn run_base<K: Kernel>(kernel: K) -> K::Out {
    kernel.run::<LanesBase>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,avx512f,avx512dq")]
fn run_avx512<K: Kernel>(kernel: K) -> K::Out {
    kernel.run::<LanesAvx512>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Out {
    kernel.run::<LanesAvx2>()
}

/// Runs code of another library that uses wide registers, and clears their upper halves afterwards.
///
/// What is compiled for AVX does so before it returns, but not every library in every place. As long as the upper halves hold anything, instructions of the baseline
/// wait for them on some processors: all later arithmetic of the thread then takes about three times as long.
pub fn cleared<T>(run: impl FnOnce() -> T) -> T {
    let out = run();
    clear();
    out
}

#[inline]
fn clear() {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx") {
        // SAFETY: the processor has the instruction
        unsafe { zero_upper() }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx")]
fn zero_upper() {
    core::arch::x86_64::_mm256_zeroupper();
}

/// The processor says whether the upper halves of its registers of four hold anything, and they do; `None` where it does not say.
#[cfg(test)]
pub(crate) fn upper_halves_in_use() -> Option<bool> {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{__cpuid_count, _xgetbv};
        #[target_feature(enable = "xsave")]
        fn in_use() -> bool {
            // SAFETY: of the state in use, which the processor gives
            unsafe { _xgetbv(1) & 4 != 0 }
        }
        if is_x86_feature_detected!("avx") && is_x86_feature_detected!("xsave") && __cpuid_count(0xd, 1).eax & 4 != 0 {
            // SAFETY: the processor has the instruction
            return Some(unsafe { in_use() });
        }
    }
    None
}

/// The argument list of an erased function, for every scalar: a marker type, because a trait object cannot be generic.
///
/// ```
/// use laval_num::{dual::Dual, lanes::Family, scalar::Scalar};
/// pub struct Force<'a, S> { pub q: &'a [S], pub r: &'a mut [S] }
/// pub struct Values;
/// impl Family for Values { type Args<'a, S: Scalar> = Force<'a, S>; }
/// pub struct Derivatives;
/// impl Family for Derivatives { type Args<'a, S: Scalar> = Force<'a, Dual<S, 8>>; }
/// ```
pub trait Family: 'static {
    /// The arguments over the scalar `S`: a struct of references and plain values.
    type Args<'a, S: Scalar>;
}

/// A function on `T` written once for all scalars, to be erased: with `F: Apply<T>`, every `T` is a `dyn Slots<F>`.
///
/// The trait is implemented by the marker, so that another crate can erase every type of a trait of its own:
/// `impl<P: Part> Apply<P> for Values`.
pub trait Apply<T: ?Sized>: Family {
    /// The function. Must be `#[inline(always)]`, as must what it calls (see [`Kernel`]).
    fn apply<S: Scalar>(of: &T, args: &mut Self::Args<'_, S>);
}

/// The object-safe face of [`Apply`]: one slot per scalar and level, each compiled with the instructions of its level.
///
/// Generic code holding a `&dyn Slots<F>` calls [`Entry::enter`]. A part that also gives derivatives is a
/// `trait Erased: Slots<Values> + Slots<Derivatives>`.
pub trait Slots<F: Family> {
    /// One member.
    fn scalar(&self, args: &mut F::Args<'_, f64>);
    /// Lanes at [`Level::Base`].
    fn base(&self, args: &mut F::Args<'_, LanesBase>);
    /// Lanes at [`Level::Avx2`].
    ///
    /// # Safety
    /// The processor must have the level.
    #[cfg(target_arch = "x86_64")]
    unsafe fn avx2(&self, args: &mut F::Args<'_, LanesAvx2>);
    /// Lanes at [`Level::Avx512`].
    ///
    /// # Safety
    /// The processor must have the level.
    #[cfg(target_arch = "x86_64")]
    unsafe fn avx512(&self, args: &mut F::Args<'_, LanesAvx512>);
}

impl<F: Apply<T>, T> Slots<F> for T {
    fn scalar(&self, args: &mut F::Args<'_, f64>) {
        F::apply::<f64>(self, args);
    }
    fn base(&self, args: &mut F::Args<'_, LanesBase>) {
        F::apply::<LanesBase>(self, args);
    }
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    unsafe fn avx2(&self, args: &mut F::Args<'_, LanesAvx2>) {
        F::apply::<LanesAvx2>(self, args);
    }
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,avx512f,avx512dq")]
    unsafe fn avx512(&self, args: &mut F::Args<'_, LanesAvx512>) {
        F::apply::<LanesAvx512>(self, args);
    }
}

/// Work to be compiled as a function of its own instead of wherever it is requested; called by [`Scalar::apart`].
pub trait Routine {
    /// Result.
    type Out;
    /// The work. Must be `#[inline(always)]`, as must what it calls (see [`Kernel`]).
    fn run(self) -> Self::Out;
}

#[inline(never)]
pub(crate) fn apart<R: Routine>(routine: R) -> R::Out {
    routine.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
#[inline(never)]
pub(super) fn apart_avx2<R: Routine>(routine: R) -> R::Out {
    routine.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,avx512f,avx512dq")]
#[inline(never)]
pub(super) fn apart_avx512<R: Routine>(routine: R) -> R::Out {
    routine.run()
}

/// A scalar that knows its slot: `f64`, which is one lane, and the lanes of each level.
pub trait Entry: Scalar {
    /// The same with another value in a lane (below the number of lanes).
    fn with(self, lane: usize, x: f64) -> Self;
    /// Calls the slot of this scalar.
    fn enter<F: Family, T: Slots<F> + ?Sized>(slots: &T, args: &mut F::Args<'_, Self>);
}

#[inline(always)]
fn replaced<S: LaneScalar>(of: S, lane: usize, x: f64) -> S {
    let mut a = of.to_array();
    a[lane] = x;
    S::from_array(a)
}

impl Entry for f64 {
    #[inline(always)]
    fn with(self, _: usize, x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn enter<F: Family, T: Slots<F> + ?Sized>(slots: &T, args: &mut F::Args<'_, f64>) {
        slots.scalar(args);
    }
}
impl Entry for LanesBase {
    #[inline(always)]
    fn with(self, lane: usize, x: f64) -> Self {
        replaced(self, lane, x)
    }
    #[inline(always)]
    fn enter<F: Family, T: Slots<F> + ?Sized>(slots: &T, args: &mut F::Args<'_, Self>) {
        slots.base(args);
    }
}
#[cfg(target_arch = "x86_64")]
impl Entry for LanesAvx2 {
    #[inline(always)]
    fn with(self, lane: usize, x: f64) -> Self {
        replaced(self, lane, x)
    }
    #[inline(always)]
    fn enter<F: Family, T: Slots<F> + ?Sized>(slots: &T, args: &mut F::Args<'_, Self>) {
        // SAFETY: the condition for using the type
        unsafe { slots.avx2(args) };
    }
}
#[cfg(target_arch = "x86_64")]
impl Entry for LanesAvx512 {
    #[inline(always)]
    fn with(self, lane: usize, x: f64) -> Self {
        replaced(self, lane, x)
    }
    #[inline(always)]
    fn enter<F: Family, T: Slots<F> + ?Sized>(slots: &T, args: &mut F::Args<'_, Self>) {
        // SAFETY: the condition for using the type
        unsafe { slots.avx512(args) };
    }
}
