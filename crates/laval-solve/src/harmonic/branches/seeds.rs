//! Starts for states that no branch from the ends of the range reaches.

use crate::harmonic::balance::motion::{Motion, put};
use crate::harmonic::balance::terms::{Term, Terms};
use laval_num::complex::C64;
use std::f64::consts::TAU;

/// Every vector's x from one motion, its y from another, scalars between: exact where the planes do not couple.
pub fn planes(to: &Terms, x: Motion, y: Motion) -> Vec<f64> {
    let (a, b) = (x.carried(to), y.carried(to));
    let (a, b) = (Motion { terms: to, x: &a }, Motion { terms: to, x: &b });
    let mut out = vec![0.0; to.unknowns];
    for &(term, at) in &to.list {
        let z = match term {
            Term::Pair { coordinate, order } => {
                let mirror = Term::Pair { coordinate, order: -order };
                (a.coefficient(term) + a.coefficient(mirror).conj() + b.coefficient(term) - b.coefficient(mirror).conj()).scale(0.5)
            }
            Term::Scalar { .. } => (a.coefficient(term) + b.coefficient(term)).scale(0.5),
        };
        put(term, at, z, &mut out);
    }
    out
}

/// A known motion with a component of the lowest order added to every vector: of this amplitude and phase, circular where the symmetry admits one
/// sense of turning only, else in one plane.
pub fn with_subharmonic(to: &Terms, motion: Motion, amplitude: f64, phase: f64, upright: bool) -> Vec<f64> {
    let mut out = motion.carried(to);
    let both = [1, -1].iter().all(|&order| to.list.iter().any(|(t, _)| matches!(t, Term::Pair { order: o, .. } if *o == order)));
    for &(term, at) in &to.list {
        let Term::Pair { order, .. } = term else { continue };
        if order.unsigned_abs() != 1 {
            continue;
        }
        let mut z = C64::cis(phase * f64::from(order)).scale(if both { 0.5 * amplitude } else { amplitude });
        if both && upright {
            // i a cos(tau + phase)
            z = z.mul_i();
        }
        out[at] += z.re;
        out[at + 1] += z.im;
    }
    out
}

/// A deterministic sequence of numbers between 0 and 1 (splitmix64).
pub struct Random(pub u64);

impl Random {
    /// The next number.
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((z ^ (z >> 31)) >> 11) as f64) / (1u64 << 53) as f64
    }
}

/// A start taken anywhere: first orders of moduli between `least` and `most` (evenly in their logarithm), higher ones smaller, any phases.
pub fn anywhere(to: &Terms, (least, most): (f64, f64), random: &mut Random) -> Vec<f64> {
    let mut out = vec![0.0; to.unknowns];
    for &(term, at) in &to.list {
        let over = (f64::from(term.order()).abs() / to.divisor as f64).max(1.0);
        let size = least * (most / least).powf(random.next()) * 0.1f64.powf(over - 1.0);
        put(term, at, C64::cis(TAU * random.next()).scale(size), &mut out);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::part::DofKind;
    use crate::symmetry::Symmetry;

    const KINDS: [DofKind; 2] = [DofKind::VectorX, DofKind::VectorY];

    /// x(t) of one and y(t) of the other, instant by instant.
    #[test]
    fn planes_are_those_of_their_sources() {
        let (from, to) = (Terms::new(&KINDS, Symmetry::Quarter, 7, 1, 32), Terms::new(&KINDS, Symmetry::Half, 7, 1, 32));
        let a: Vec<f64> = (0..from.unknowns).map(|i| (1.3 * i as f64 + 0.4).sin()).collect();
        let b: Vec<f64> = a.iter().map(|x| x * x - 0.3).collect();
        let mixed = planes(&to, Motion { terms: &from, x: &a }, Motion { terms: &from, x: &b });
        let mut rows = [0; 3].map(|_| laval_num::dense::Mat::default());
        for k in 0..9 {
            let tau = 0.7 * f64::from(k);
            from.rows_at(tau, &mut rows);
            let (u, v) = (rows[0].mul_vec(&a), rows[0].mul_vec(&b));
            to.rows_at(tau, &mut rows);
            let w = rows[0].mul_vec(&mixed);
            assert!((w[0] - u[0]).abs() < 1e-13 && (w[1] - v[1]).abs() < 1e-13, "{w:?} {u:?} {v:?}");
        }
    }
}
