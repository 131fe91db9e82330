//! The method of order 8 for states of which some are positions: the rates of others.
//!
//! Where q' = v, the rates of q in the stages are v0 + h sum_m a_im k_m, so that every combination of them is one of the rates k of v:
//!
//! ```text
//! v = v0 + h sum_m r_m k_m,     q = q0 + h (sum_m r_m) v0 + h^2 sum_m (r A)_m k_m
//! ```
//!
//! Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, section II.14 (Nystrom methods induced by Runge-Kutta
//! methods).

use super::tableau::{self as t8, Row};

const STAGES: usize = 16;

/// One row: stage, its share in v, its share in q.
pub type Pair<const N: usize> = [(usize, f64, f64); N];

/// Below this an entry of `r A` is rounding of one that the order conditions make zero.
const ROUNDING: f64 = 1e-12;

const fn full<const N: usize>(row: &Row<N>) -> [f64; STAGES] {
    let mut out = [0.0; STAGES];
    let mut m = 0;
    while m < N {
        out[row[m].0] = row[m].1;
        m += 1;
    }
    out
}

/// All rows of A; row 12 holds the weights.
const A: [[f64; STAGES]; STAGES] = [
    [0.0; STAGES],
    full(&t8::A1),
    full(&t8::A2),
    full(&t8::A3),
    full(&t8::A4),
    full(&t8::A5),
    full(&t8::A6),
    full(&t8::A7),
    full(&t8::A8),
    full(&t8::A9),
    full(&t8::A10),
    full(&t8::A11),
    full(&t8::B),
    full(&t8::A13),
    full(&t8::A14),
    full(&t8::A15),
];

/// A row with its product with A, entries that are zero in both left out.
const fn pair<const N: usize>(row: [f64; STAGES]) -> Pair<N> {
    let mut out = [(0, 0.0, 0.0); N];
    let (mut count, mut j) = (0, 0);
    while j < STAGES {
        let (mut through, mut i) = (0.0, 0);
        while i < STAGES {
            through += row[i] * A[i][j];
            i += 1;
        }
        if through.abs() < ROUNDING {
            through = 0.0;
        }
        if row[j] != 0.0 || through != 0.0 {
            out[count] = (j, row[j], through);
            count += 1;
        }
        j += 1;
    }
    // checked when compiled
    assert!(count == N);
    out
}

const fn difference(a: [f64; STAGES], b: [f64; STAGES]) -> [f64; STAGES] {
    let mut out = a;
    let mut j = 0;
    while j < STAGES {
        out[j] -= b[j];
        j += 1;
    }
    out
}

/// Stage 1.
pub const P1: Pair<1> = pair(A[1]);
/// Stage 2.
pub const P2: Pair<2> = pair(A[2]);
/// Stage 3.
pub const P3: Pair<3> = pair(A[3]);
/// Stage 4.
pub const P4: Pair<4> = pair(A[4]);
/// Stage 5.
pub const P5: Pair<4> = pair(A[5]);
/// Stage 6.
pub const P6: Pair<5> = pair(A[6]);
/// Stage 7.
pub const P7: Pair<6> = pair(A[7]);
/// Stage 8.
pub const P8: Pair<7> = pair(A[8]);
/// Stage 9.
pub const P9: Pair<8> = pair(A[9]);
/// Stage 10.
pub const P10: Pair<9> = pair(A[10]);
/// Stage 11.
pub const P11: Pair<10> = pair(A[11]);
/// Stage 12: the end of the step.
pub const P12: Pair<8> = pair(A[12]);
/// Stage 13.
pub const P13: Pair<9> = pair(A[13]);
/// Stage 14.
pub const P14: Pair<10> = pair(A[14]);
/// Stage 15.
pub const P15: Pair<11> = pair(A[15]);
/// Error of the formula of order 5.
pub const E5: Pair<10> = pair(full(&t8::E5));
/// Error of the formula of order 3.
pub const E3: Pair<10> = pair(difference(full(&t8::B), full(&t8::BHH)));
/// Row F3 of the dense output.
pub const D3: Pair<12> = pair(full(&t8::D3));
/// Row F4 of the dense output.
pub const D4: Pair<12> = pair(full(&t8::D4));
/// Row F5 of the dense output.
pub const D5: Pair<12> = pair(full(&t8::D5));
/// Row F6 of the dense output.
pub const D6: Pair<12> = pair(full(&t8::D6));

#[cfg(test)]
mod tests {
    use super::*;

    /// y = t^2/2: unit rates of v give it exactly at every node.
    #[test]
    fn quadratic_motions_are_exact() {
        fn shares<const N: usize>(row: &Pair<N>) -> [f64; 2] {
            row.iter().fold([0.0, 0.0], |s, r| [s[0] + r.1, s[1] + r.2])
        }
        let all = [
            shares(&P1),
            shares(&P2),
            shares(&P3),
            shares(&P4),
            shares(&P5),
            shares(&P6),
            shares(&P7),
            shares(&P8),
            shares(&P9),
            shares(&P10),
            shares(&P11),
            shares(&P12),
            shares(&P13),
            shares(&P14),
            shares(&P15),
        ];
        for (i, [v, q]) in all.into_iter().enumerate() {
            let c = t8::C[i + 1];
            assert!((v - c).abs() < 1e-13, "{i}: {v} {c}");
            // the first stage is of order 1
            assert!(i == 0 || (q - c * c / 2.0).abs() < 1e-13, "{i}: {q}");
        }
        for [v, q] in [shares(&E5), shares(&E3), shares(&D3), shares(&D4), shares(&D5), shares(&D6)] {
            assert!(v.abs() < 1e-12 && q.abs() < 1e-11, "{v} {q}");
        }
    }
}
