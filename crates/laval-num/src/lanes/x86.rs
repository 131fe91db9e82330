//! Registers of x86-64: SSE2 (always there), AVX2 and AVX-512.
//!
//! Nothing here carries `#[target_feature]`: every method is inlined into the function that entered the level and becomes one
//! instruction there. Called from anywhere else it is still correct on a processor that has the instruction, but slow.

use super::level::{Level, Routine, apart, apart_avx2, apart_avx512};
use super::reg::Reg;
use core::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Two doubles, SSE2.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Xmm(__m128d);
/// Four doubles, AVX2 and FMA.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Ymm(__m256d);
/// Eight doubles, AVX-512 F.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Zmm(__m512d);

// SAFETY (all blocks of this file): the type's level is supported by the processor, which is the condition for using the type,
// see `super::Lanes`; loads and stores are unaligned and their slices are checked for length first.

macro_rules! operator {
    ($reg:ident, $trait:ident, $method:ident, $f:ident) => {
        impl $trait for $reg {
            type Output = Self;
            #[inline(always)]
            fn $method(self, o: Self) -> Self {
                unsafe { $reg($f(self.0, o.0)) }
            }
        }
    };
}

macro_rules! register {
    ($reg:ident, $level:ident, $apart:ident, $width:literal, $mask:ty, [$add:ident $sub:ident $mul:ident $div:ident $sqrt:ident],
     [$splat:ident $load:ident $store:ident], [$int:ident $float:ident $splat_int:ident],
     [$and:ident $or:ident $xor:ident $add_int:ident $shl:ident $shr:ident],
     lt: $lt:path, le: $le:path, bits: $bits:path, select($m:ident, $a:ident, $b:ident): $select:expr, odd($i:ident): $odd:expr $(, less: $less:ident)?) => {
        operator!($reg, Add, add, $add);
        operator!($reg, Sub, sub, $sub);
        operator!($reg, Mul, mul, $mul);
        operator!($reg, Div, div, $div);
        impl Neg for $reg {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.xor(Self::splat(-0.0))
            }
        }
        impl Reg for $reg {
            type Mask = $mask;
            const WIDTH: usize = $width;
            const LEVEL: Level = Level::$level;
            #[inline(always)]
            fn apart<R: Routine>(routine: R) -> R::Out {
                #[allow(unused_unsafe, reason = "at the level that every processor has")]
                unsafe {
                    $apart(routine)
                }
            }
            #[inline(always)]
            fn splat(x: f64) -> Self {
                unsafe { $reg($splat(x)) }
            }
            #[inline(always)]
            fn read(from: &[f64]) -> Self {
                let from = &from[..$width];
                unsafe { $reg($load(from.as_ptr())) }
            }
            #[inline(always)]
            fn write(self, to: &mut [f64]) {
                let to = &mut to[..$width];
                unsafe { $store(to.as_mut_ptr(), self.0) }
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                unsafe { $reg($sqrt(self.0)) }
            }
            #[inline(always)]
            fn lt(self, o: Self) -> $mask {
                unsafe { $lt(self.0, o.0) }
            }
            #[inline(always)]
            fn le(self, o: Self) -> $mask {
                unsafe { $le(self.0, o.0) }
            }
            #[inline(always)]
            fn select($m: $mask, a: Self, b: Self) -> Self {
                let ($a, $b) = (a.0, b.0);
                unsafe { $reg($select) }
            }
            #[inline(always)]
            fn mask_bits(m: $mask) -> u8 {
                unsafe { $bits(m) as u8 }
            }
            #[inline(always)]
            fn and(self, o: Self) -> Self {
                unsafe { $reg($float($and($int(self.0), $int(o.0)))) }
            }
            #[inline(always)]
            fn or(self, o: Self) -> Self {
                unsafe { $reg($float($or($int(self.0), $int(o.0)))) }
            }
            #[inline(always)]
            fn xor(self, o: Self) -> Self {
                unsafe { $reg($float($xor($int(self.0), $int(o.0)))) }
            }
            #[inline(always)]
            fn add_bits(self, o: u64) -> Self {
                unsafe { $reg($float($add_int($int(self.0), $splat_int(o as i64)))) }
            }
            #[inline(always)]
            fn shl(self, n: i32) -> Self {
                unsafe { $reg($float($shl($int(self.0), _mm_cvtsi32_si128(n)))) }
            }
            #[inline(always)]
            fn shr(self, n: i32) -> Self {
                unsafe { $reg($float($shr($int(self.0), _mm_cvtsi32_si128(n)))) }
            }
            #[inline(always)]
            fn odd(self) -> $mask {
                let $i = unsafe { $int(self.0) };
                unsafe { $odd }
            }
            $(
                #[inline(always)]
                fn product_error(self, o: Self, product: Self) -> Self {
                    unsafe { $reg($less(self.0, o.0, product.0)) }
                }
            )?
        }
    };
}

// The differing operations are passed as expressions, not closures: a closure would not be inlined into its level.
register!(
    Xmm, Base, apart, 2, __m128d,
    [_mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd],
    [_mm_set1_pd _mm_loadu_pd _mm_storeu_pd],
    [_mm_castpd_si128 _mm_castsi128_pd _mm_set1_epi64x],
    [_mm_and_si128 _mm_or_si128 _mm_xor_si128 _mm_add_epi64 _mm_sll_epi64 _mm_srl_epi64],
    lt: _mm_cmplt_pd, le: _mm_cmple_pd, bits: _mm_movemask_pd,
    select(m, a, b): _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b)),
    odd(i): _mm_castsi128_pd(_mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(i, _mm_set1_epi64x(1))))
);

register!(
    Ymm, Avx2, apart_avx2, 4, __m256d,
    [_mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd],
    [_mm256_set1_pd _mm256_loadu_pd _mm256_storeu_pd],
    [_mm256_castpd_si256 _mm256_castsi256_pd _mm256_set1_epi64x],
    [_mm256_and_si256 _mm256_or_si256 _mm256_xor_si256 _mm256_add_epi64 _mm256_sll_epi64 _mm256_srl_epi64],
    lt: _mm256_cmp_pd::<_CMP_LT_OQ>, le: _mm256_cmp_pd::<_CMP_LE_OQ>, bits: _mm256_movemask_pd,
    select(m, a, b): _mm256_blendv_pd(b, a, m),
    odd(i): _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_setzero_si256(), _mm256_and_si256(i, _mm256_set1_epi64x(1)))),
    less: _mm256_fmsub_pd
);

register!(
    Zmm, Avx512, apart_avx512, 8, __mmask8,
    [_mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd],
    [_mm512_set1_pd _mm512_loadu_pd _mm512_storeu_pd],
    [_mm512_castpd_si512 _mm512_castsi512_pd _mm512_set1_epi64],
    [_mm512_and_si512 _mm512_or_si512 _mm512_xor_si512 _mm512_add_epi64 _mm512_sll_epi64 _mm512_srl_epi64],
    lt: _mm512_cmp_pd_mask::<_CMP_LT_OQ>, le: _mm512_cmp_pd_mask::<_CMP_LE_OQ>, bits: _cvtmask8_u32,
    select(m, a, b): _mm512_mask_blend_pd(m, b, a),
    odd(i): _mm512_test_epi64_mask(i, _mm512_set1_epi64(1)),
    less: _mm512_fmsub_pd
);
