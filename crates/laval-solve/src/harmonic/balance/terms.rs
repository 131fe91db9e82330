//! The harmonics a periodic motion is built from, and their samples over a period.
//!
//! A lateral pair is `x + i y = sum_n Z_n exp(i n tau)` with signed orders n (n > 0 forward, n < 0 backward); a scalar coordinate is
//! `s_0 + sum_k (a_k cos k tau + b_k sin k tau)`. `tau = W t / nu`, with nu the subharmonic divisor. A symmetry keeps only some orders and only part
//! of the period has to be sampled.

use crate::model::part::DofKind;
use crate::symmetry::Symmetry;
use laval_num::dense::Mat;
use std::f64::consts::TAU;

/// One complex (or real) unknown of the balance: a coordinate and a signed order.
#[allow(missing_docs)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// `Z_n` of the pair that starts at this coordinate: two real unknowns.
    Pair { coordinate: usize, order: i32 },
    /// `a_k`, `b_k` of a scalar coordinate (one unknown for order 0).
    Scalar { coordinate: usize, order: i32 },
}

impl Term {
    /// Number of real unknowns.
    pub fn size(self) -> usize {
        match self {
            Term::Scalar { order: 0, .. } => 1,
            _ => 2,
        }
    }
    /// A coefficient is the mean of the row times the synthesis, times this.
    pub fn gain(self) -> f64 {
        match self {
            Term::Scalar { order, .. } if order != 0 => 2.0,
            _ => 1.0,
        }
    }
    /// Signed order.
    pub fn order(self) -> i32 {
        match self {
            Term::Pair { order, .. } | Term::Scalar { order, .. } => order,
        }
    }
}

/// Entries of one term in the synthesis, where its angle has this sine and cosine: columns from `at`, coordinates from row `first`.
fn place(term: Term, at: usize, first: usize, (s, c): (f64, f64), synthesis: &mut [Mat; 3]) {
    let n = f64::from(term.order());
    match term {
        Term::Pair { coordinate, .. } => {
            let (x, y) = (first + coordinate, first + coordinate + 1);
            for (d, factor) in [1.0, n, -n * n].into_iter().enumerate() {
                // i n turns (c, s) into n (-s, c)
                let (c, s) = if d == 1 { (-s, c) } else { (c, s) };
                synthesis[d][(x, at)] = factor * c;
                synthesis[d][(x, at + 1)] = -factor * s;
                synthesis[d][(y, at)] = factor * s;
                synthesis[d][(y, at + 1)] = factor * c;
            }
        }
        Term::Scalar { coordinate, order } => {
            let row = first + coordinate;
            for (d, (c, s)) in [(c, s), (-n * s, n * c), (-n * n * c, -n * n * s)].into_iter().enumerate() {
                synthesis[d][(row, at)] = c;
                if order != 0 {
                    synthesis[d][(row, at + 1)] = s;
                }
            }
        }
    }
}

/// The chosen harmonics of `m` coordinates.
#[derive(Clone, Debug)]
pub struct Terms {
    /// Largest order kept, in multiples of the base frequency.
    pub harmonics: usize,
    /// Subharmonic divisor nu: the base frequency is speed / nu.
    pub divisor: usize,
    /// Symmetry that selected the orders.
    pub symmetry: Symmetry,
    /// Terms with the index of their first real unknown.
    pub list: Vec<(Term, usize)>,
    /// Number of real unknowns.
    pub unknowns: usize,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Distinct orders |n|, ascending.
    pub orders: Vec<usize>,
    /// Number of samples evaluated.
    pub samples: usize,
    /// Sample angles tau.
    pub angles: Vec<f64>,
    /// Synthesis: coordinates at the samples from unknowns, (samples * m) x unknowns; then its first and second derivative in tau.
    pub synthesis: [Mat; 3],
    /// Analysis: unknown-like coefficients of sampled rows, unknowns x (samples * m).
    pub analysis: Mat,
}

/// Signed orders of vectors and orders of scalars up to `h` that a symmetry admits.
pub fn admitted(symmetry: Symmetry, h: usize, divisor: usize) -> (Vec<i32>, Vec<i32>) {
    let (h, nu) = (h as i32, divisor as i32);
    let vector = |n: &i32| match symmetry {
        Symmetry::None => true,
        Symmetry::Half => (n - nu).rem_euclid(2) == 0,
        Symmetry::Quarter => (n - nu).rem_euclid(4) == 0,
        Symmetry::Circular => *n == nu,
    };
    let scalar = |n: &i32| match symmetry {
        Symmetry::None => true,
        Symmetry::Half => n % 2 == 0,
        Symmetry::Quarter => n % 4 == 0,
        Symmetry::Circular => *n == 0,
    };
    let mut v: Vec<i32> = (-h..=h).filter(vector).collect();
    v.sort_by_key(|n| (n.abs(), -n));
    (v, (0..=h).filter(scalar).collect())
}

impl Terms {
    /// Harmonics up to `harmonics` (multiples of speed / divisor) of coordinates of these kinds, with at least `samples` samples a whole period.
    pub fn new(kinds: &[DofKind], symmetry: Symmetry, harmonics: usize, divisor: usize, samples: usize) -> Terms {
        // an even divisor leaves no time shift that goes with a turn
        let symmetry = if divisor.is_multiple_of(2) { Symmetry::None } else { symmetry };
        let (vector, scalar) = admitted(symmetry, harmonics, divisor);
        let mut list = Vec::new();
        let mut unknowns = 0;
        let mut push = |t: Term| {
            list.push((t, unknowns));
            unknowns += t.size();
        };
        let mut i = 0;
        while i < kinds.len() {
            if kinds[i].leads_pair() && kinds.get(i + 1).is_some_and(|k| k.ends_pair()) {
                vector.iter().for_each(|&order| push(Term::Pair { coordinate: i, order }));
                i += 2;
            } else {
                scalar.iter().for_each(|&order| push(Term::Scalar { coordinate: i, order }));
                i += 1;
            }
        }
        let mut orders: Vec<usize> = list.iter().map(|(t, _)| t.order().unsigned_abs() as usize).collect();
        orders.sort_unstable();
        orders.dedup();
        // the part of the period that the symmetry repeats
        let (count, total) = match symmetry.order() {
            0 => (1, 1),
            parts => {
                let count = samples.div_ceil(parts);
                (count, count * parts)
            }
        };
        let angles: Vec<f64> = (0..count).map(|j| TAU * j as f64 / total as f64).collect();
        let m = kinds.len();
        let mut synthesis = [0; 3].map(|_| Mat::zeros(count * m, unknowns));
        let mut analysis = Mat::zeros(unknowns, count * m);
        for (j, _) in angles.iter().enumerate() {
            for &(term, at) in &list {
                // the angle is reduced in integers, so that symmetric samples are exact
                let step = (i64::from(term.order()) * j as i64).rem_euclid(total as i64);
                let (s, c) = (TAU * step as f64 / total as f64).sin_cos();
                place(term, at, j * m, (s, c), &mut synthesis);
                for row in j * m..(j + 1) * m {
                    for i in at..at + term.size() {
                        analysis[(i, row)] = term.gain() / count as f64 * synthesis[0][(row, i)];
                    }
                }
            }
        }
        Terms { harmonics, divisor, symmetry, list, unknowns, coordinates: m, orders, samples: count, angles, synthesis, analysis }
    }

    /// Synthesis at one base phase `tau`: coordinates and their first and second derivative in tau from unknowns, m x unknowns.
    pub fn rows_at(&self, tau: f64, out: &mut [Mat; 3]) {
        out.iter_mut().for_each(|e| e.reset(self.coordinates, self.unknowns));
        for &(term, at) in &self.list {
            place(term, at, 0, (f64::from(term.order()) * tau).sin_cos(), out);
        }
    }

    /// Smallest number of samples for orders up to `h`: without aliasing for a cubic law, a whole number for every symmetry, no less than 32.
    pub fn samples(h: usize, divisor: usize) -> usize {
        Self::alias_free(3, h.max(divisor)).next_multiple_of(8).max(32)
    }
    /// Smallest number of samples of a whole period without aliasing into orders up to `harmonics` for a law of polynomial degree `degree`.
    pub fn alias_free(degree: usize, harmonics: usize) -> usize {
        (degree + 1) * harmonics + 1
    }

    /// Complex amplitudes over the coordinates at order `k >= 0` (coordinate = Re(amplitude exp(i k tau))) of unknowns `x`.
    pub fn amplitudes(&self, x: &[f64], k: usize, out: &mut [laval_num::complex::C64]) {
        use laval_num::complex::{C64, c};
        out.fill(C64::zero());
        for &(term, at) in &self.list {
            if term.order().unsigned_abs() as usize != k {
                continue;
            }
            match term {
                Term::Pair { coordinate, order } => {
                    let z = c(x[at], x[at + 1]);
                    let (a, b) = match order.signum() {
                        1 => (z, -z.mul_i()),
                        -1 => (z.conj(), z.conj().mul_i()),
                        _ => (c(z.re, 0.0), c(z.im, 0.0)),
                    };
                    out[coordinate] += a;
                    out[coordinate + 1] += b;
                }
                Term::Scalar { coordinate, order } => {
                    out[coordinate] += if order == 0 { c(x[at], 0.0) } else { c(x[at], -x[at + 1]) };
                }
            }
        }
    }

    /// The inverse of [`Terms::amplitudes`] for rows: adds amplitudes of order `k` to unknown-like coefficients.
    pub fn add_amplitudes(&self, k: usize, amplitudes: &[laval_num::complex::C64], out: &mut [f64]) {
        for &(term, at) in &self.list {
            if term.order().unsigned_abs() as usize != k {
                continue;
            }
            match term {
                Term::Pair { coordinate, order } => {
                    let (x, y) = (amplitudes[coordinate], amplitudes[coordinate + 1]);
                    let z = match order.signum() {
                        1 => (x + y.mul_i()).scale(0.5),
                        -1 => (x - y.mul_i()).scale(0.5).conj(),
                        _ => laval_num::complex::c(x.re, y.re),
                    };
                    out[at] += z.re;
                    out[at + 1] += z.im;
                }
                Term::Scalar { coordinate, order } => {
                    out[at] += amplitudes[coordinate].re;
                    if order != 0 {
                        out[at + 1] -= amplitudes[coordinate].im;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [DofKind; 3] = [DofKind::VectorX, DofKind::VectorY, DofKind::Scalar];

    #[test]
    fn analysis_inverts_synthesis() {
        for (symmetry, nu) in
            [(Symmetry::None, 1), (Symmetry::Half, 1), (Symmetry::Quarter, 1), (Symmetry::Circular, 1), (Symmetry::Half, 3)]
        {
            let t = Terms::new(&KINDS, symmetry, 9, nu, 37);
            let e = t.analysis.matmul(&t.synthesis[0]);
            for i in 0..t.unknowns {
                for j in 0..t.unknowns {
                    let d = if i == j { 1.0 } else { 0.0 };
                    assert!((e[(i, j)] - d).abs() < 1e-14, "{symmetry:?} {i} {j} {}", e[(i, j)]);
                }
            }
        }
    }

    #[test]
    fn symmetric_orders_are_the_textbook_ones() {
        assert_eq!(admitted(Symmetry::Quarter, 7, 1).0, [1, -3, 5, -7]);
        assert_eq!(admitted(Symmetry::Half, 3, 1).0, [1, -1, 3, -3]);
        assert_eq!(admitted(Symmetry::Circular, 7, 1), (vec![1], vec![0]));
    }

    #[test]
    fn amplitudes_and_back() {
        let t = Terms::new(&KINDS, Symmetry::None, 3, 1, 16);
        let x: Vec<f64> = (0..t.unknowns).map(|i| (i as f64 * 0.7).sin()).collect();
        let mut back = vec![0.0; t.unknowns];
        let mut a = [laval_num::complex::C64::zero(); 3];
        for &k in &t.orders {
            t.amplitudes(&x, k, &mut a);
            t.add_amplitudes(k, &a, &mut back);
        }
        for (x, b) in x.iter().zip(&back) {
            assert!((x - b).abs() < 1e-15);
        }
    }

    #[test]
    fn derivatives_of_the_synthesis_are_exact() {
        let t = Terms::new(&KINDS, Symmetry::None, 3, 1, 16);
        // sample j of d/dtau equals the band-limited derivative: check by shifting analytically one pair term
        let (term, at) = t.list[2];
        let n = f64::from(term.order());
        for (j, tau) in t.angles.iter().enumerate() {
            let x = t.synthesis[1][(j * 3, at)];
            assert!((x + n * (n * tau).sin()).abs() < 1e-14);
            let x = t.synthesis[2][(j * 3, at)];
            assert!((x + n * n * (n * tau).cos()).abs() < 1e-14);
        }
    }
}
