//! A motion in its terms, carried to others and turned by the symmetry of the machine, and what makes two motions the same.
//!
//! A motion turned by the symmetry of the machine is another motion of it: with the spin phase turned along, turning by a quarter is the same as
//! waiting for a quarter of a turn of the rotor, `Z_n -> i exp(-i n pi/(2 nu)) Z_n` (half: `-exp(-i n pi/nu)`, none: `exp(-2 pi i n/nu)`, which is waiting
//! for one turn). All these images have the same moduli `|Z_n|`, by which states are compared.

use crate::harmonic::balance::terms::{Term, Terms};
use crate::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use std::f64::consts::TAU;

/// A motion in the terms it was found in.
#[derive(Clone, Copy)]
pub struct Motion<'a> {
    /// The terms.
    pub terms: &'a Terms,
    /// The unknowns.
    pub x: &'a [f64],
}

impl Motion<'_> {
    /// Complex coefficient of a term: `Z_n`, or `a_k - i b_k`.
    pub(in crate::harmonic) fn coefficient(&self, term: Term) -> C64 {
        let Some(&(_, at)) = self.terms.list.iter().find(|(t, _)| *t == term) else { return C64::zero() };
        match term {
            Term::Pair { .. } => c(self.x[at], self.x[at + 1]),
            Term::Scalar { order: 0, .. } => c(self.x[at], 0.0),
            Term::Scalar { .. } => c(self.x[at], -self.x[at + 1]),
        }
    }

    /// Largest modulus.
    pub fn size(&self) -> f64 {
        self.terms.list.iter().map(|(t, _)| self.coefficient(*t).abs()).fold(0.0, f64::max)
    }

    /// The same motion in other terms, whose divisor is a multiple of this one's or divides it; orders they lack are left out.
    pub fn carried(&self, to: &Terms) -> Vec<f64> {
        let mut out = vec![0.0; to.unknowns];
        for &(term, at) in &to.list {
            let order = term.order() * self.terms.divisor as i32;
            if order % to.divisor as i32 == 0 {
                put(term, at, self.coefficient(with_order(term, order / to.divisor as i32)), &mut out);
            }
        }
        out
    }

    /// Part of the motion that other terms leave out, relative to its size.
    pub fn left_out(&self, to: &Terms) -> f64 {
        let nu = (self.terms.divisor as i32, to.divisor as i32);
        let kept = |t: Term| {
            let order = t.order() * nu.1;
            order % nu.0 == 0 && to.list.iter().any(|(o, _)| *o == with_order(t, order / nu.0))
        };
        let beyond = |t: Term| t.order().unsigned_abs() as usize * to.divisor > to.harmonics * self.terms.divisor;
        let lost = self.terms.list.iter().filter(|(t, _)| !kept(*t) && !beyond(*t));
        lost.map(|(t, _)| self.coefficient(*t).abs()).fold(0.0, f64::max) / self.size().max(f64::MIN_POSITIVE)
    }

    /// The motion turned by the least turn of the symmetry, or one turn of the rotor later where there is none.
    pub fn image(&self, symmetry: Symmetry) -> Vec<f64> {
        let mut out = vec![0.0; self.terms.unknowns];
        let (turned, shift) = match symmetry {
            Symmetry::Quarter => (C64::i(), 0.25),
            Symmetry::Half => (c(-1.0, 0.0), 0.5),
            Symmetry::None | Symmetry::Circular => (C64::one(), 1.0),
        };
        for &(term, at) in &self.terms.list {
            let later = C64::cis(-TAU * shift * f64::from(term.order()) / self.terms.divisor as f64);
            let turned = if matches!(term, Term::Pair { .. }) { turned } else { C64::one() };
            put(term, at, self.coefficient(term) * turned * later, &mut out);
        }
        out
    }

    /// Number of different motions among the images.
    pub fn images(&self, symmetry: Symmetry) -> usize {
        let most = symmetry.order().max(1) * self.terms.divisor;
        let size = self.size();
        let mut turned = self.x.to_vec();
        for k in 1..most {
            turned = Motion { terms: self.terms, x: &turned }.image(symmetry);
            if self.x.iter().zip(&turned).all(|(a, b)| (a - b).abs() <= 1e-5 * size) {
                return k;
            }
        }
        most
    }

    /// Whether the other motion is this one, or an image of it.
    pub fn same(&self, other: &Motion) -> bool {
        let tolerance = 1e-5 * self.size().max(other.size());
        let covered = |a: &Motion, b: &Motion| {
            a.terms.list.iter().all(|&(term, _)| {
                let order = term.order() * b.terms.divisor as i32;
                let nu = a.terms.divisor as i32;
                let theirs = if order % nu == 0 { b.coefficient(with_order(term, order / nu)).abs() } else { 0.0 };
                (a.coefficient(term).abs() - theirs).abs() <= tolerance
            })
        };
        covered(self, other) && covered(other, self)
    }
}

fn with_order(term: Term, order: i32) -> Term {
    match term {
        Term::Pair { coordinate, .. } => Term::Pair { coordinate, order },
        Term::Scalar { coordinate, .. } => Term::Scalar { coordinate, order },
    }
}

/// Stores a coefficient as unknowns.
pub(in crate::harmonic) fn put(term: Term, at: usize, z: C64, out: &mut [f64]) {
    out[at] = z.re;
    match term {
        Term::Pair { .. } => out[at + 1] = z.im,
        Term::Scalar { order: 0, .. } => {}
        Term::Scalar { .. } => out[at + 1] = -z.im,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::part::DofKind;

    const KINDS: [DofKind; 3] = [DofKind::VectorX, DofKind::VectorY, DofKind::Scalar];

    fn motion(terms: &Terms) -> Vec<f64> {
        (0..terms.unknowns).map(|i| (1.3 * i as f64 + 0.4).sin()).collect()
    }

    /// An image is the motion turned back at a later instant; images close after as many turns as the group has.
    #[test]
    fn images_are_turned_motions() {
        for nu in [1, 2, 3] {
            let terms = Terms::new(&KINDS, Symmetry::None, 4 * nu, nu, 32);
            let x = motion(&terms);
            let m = Motion { terms: &terms, x: &x };
            let turned = m.image(Symmetry::Quarter);
            let mut rows = [0; 3].map(|_| laval_num::dense::Mat::default());
            let tau = 0.9;
            terms.rows_at(tau, &mut rows);
            let w = rows[0].mul_vec(&turned);
            terms.rows_at(tau - TAU / (4.0 * nu as f64), &mut rows);
            let u = rows[0].mul_vec(&x);
            assert!((w[0] + u[1]).abs() < 1e-12 && (w[1] - u[0]).abs() < 1e-12 && (w[2] - u[2]).abs() < 1e-12, "{w:?} {u:?}");
            assert_eq!(m.images(Symmetry::Quarter), 4 * nu);
            assert!(m.same(&Motion { terms: &terms, x: &turned }));
            let symmetric = Terms::new(&KINDS, Symmetry::Quarter, 7, 1, 32);
            let y = motion(&symmetric);
            assert_eq!(Motion { terms: &symmetric, x: &y }.images(Symmetry::Quarter), 1);
        }
    }
}
