//! Forces and tangents seen at instants of a period, gathered as Fourier coefficients and projected onto the terms from these.
//!
//! With `u_k = (q c e^(i n' tau) + conj) ` the motion of one term of complex amplitude c (q = 1/2 for x and a scalar, -i/2 for y) and
//! `mean(r . f e^(-i n tau))` the coefficient of another (r = 1 for x and a scalar, i for y), a tangent T(tau) of Fourier coefficients T(l)
//! couples the two by
//!
//! ```text
//! sum over coordinates of r_j [T_jk(n - n') q_k g c + T_jk(n + n') conj(q_k g c)],   g = (i n' w)^d
//! ```
//!
//! for the d-th derivative in time, w the base frequency. That costs the square of the number of terms once, not once an instant.

use crate::harmonic::balance::terms::{Term, Terms};
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::refill::refill;

/// Where coefficients and their derivatives go.
pub struct Into<'o> {
    /// Coefficients, added to.
    pub coefficients: &'o mut [f64],
    /// d coefficients / d unknowns, added to.
    pub jac: Option<&'o mut Mat>,
    /// d coefficients / d speed, added to.
    pub speed: Option<&'o mut [f64]>,
}

/// `exp(i l tau)` for l from 0 to `most`.
pub fn turns(tau: f64, most: usize, out: &mut Vec<C64>) {
    let step = C64::cis(tau);
    let mut turn = C64::one();
    out.clear();
    for _ in 0..=most {
        out.push(turn);
        turn = turn * step;
    }
}

/// Coordinates and their derivatives in time at the base phase of `turns`, which reach the largest order.
pub fn motion_at(terms: &Terms, x: &[f64], frequency: f64, turns: &[C64], out: &mut [Vec<f64>; 3]) {
    for o in out.iter_mut() {
        refill(o, terms.coordinates, 0.0);
    }
    for &(term, at) in &terms.list {
        let order = term.order();
        let turn = turns[order.unsigned_abs() as usize];
        match term {
            Term::Pair { coordinate, .. } => {
                let turn = if order < 0 { turn.conj() } else { turn };
                let mut z = c(x[at], x[at + 1]) * turn;
                for o in out.iter_mut() {
                    o[coordinate] += z.re;
                    o[coordinate + 1] += z.im;
                    z = z.mul_i().scale(f64::from(order) * frequency);
                }
            }
            Term::Scalar { coordinate, .. } => {
                let mut z = c(x[at], if order == 0 { 0.0 } else { -x[at + 1] }) * turn;
                for o in out.iter_mut() {
                    o[coordinate] += z.re;
                    z = z.mul_i().scale(f64::from(order) * frequency);
                }
            }
        }
    }
}

/// Fourier coefficients of rows (orders to h) and of their tangents (to 2 h).
#[derive(Clone, Debug, Default)]
pub struct Coefficients {
    coordinates: usize,
    harmonics: usize,
    rows: Vec<C64>,
    rows_speed: Vec<C64>,
    tangents: [Vec<C64>; 3],
    seen: [bool; 3],
}

/// Adds a real value seen at one instant to its coefficients.
fn accumulate(into: &mut [C64], turns: &[C64], value: f64) {
    if value != 0.0 {
        for (o, turn) in into.iter_mut().zip(turns) {
            o.re += value * turn.re;
            o.im -= value * turn.im;
        }
    }
}

/// First coordinate of a term, and the factors of its coordinates with which their coefficients are summed.
fn factors(term: Term) -> (usize, [C64; 2], usize) {
    match term {
        Term::Pair { coordinate, .. } => (coordinate, [C64::one(), C64::i()], 2),
        Term::Scalar { coordinate, .. } => (coordinate, [C64::one(), C64::zero()], 1),
    }
}

/// Adds a complex coefficient to the real ones of a term.
fn add(term: Term, value: C64, out: [&mut f64; 2]) {
    let [first, second] = out;
    match term {
        Term::Pair { .. } => {
            *first += value.re;
            *second += value.im;
        }
        Term::Scalar { order: 0, .. } => *first += value.re,
        Term::Scalar { .. } => {
            *first += term.gain() * value.re;
            *second -= term.gain() * value.im;
        }
    }
}

impl Coefficients {
    /// Starts anew.
    pub fn clear(&mut self, terms: &Terms) {
        (self.coordinates, self.harmonics) = (terms.coordinates, terms.harmonics);
        let m = terms.coordinates;
        for rows in [&mut self.rows, &mut self.rows_speed] {
            refill(rows, m * (terms.harmonics + 1), C64::zero());
        }
        self.seen = [false; 3];
    }

    /// Adds rows seen at one instant, with its share of the period.
    pub fn add_rows(&mut self, rows: &[f64], turns: &[C64], share: f64) {
        for (own, row) in self.rows.chunks_exact_mut(self.harmonics + 1).zip(rows) {
            accumulate(own, turns, share * row);
        }
    }

    /// Adds derivatives of rows in the speed and tangents of them (m x m, by the derivative of the motion) likewise.
    pub fn add_tangents(&mut self, rows_speed: &[f64], tangents: [&Mat; 3], turns: &[C64], share: f64) {
        for (own, row) in self.rows_speed.chunks_exact_mut(self.harmonics + 1).zip(rows_speed) {
            accumulate(own, turns, share * row);
        }
        let (m, orders) = (self.coordinates, 2 * self.harmonics + 1);
        for ((own, seen), tangent) in self.tangents.iter_mut().zip(&mut self.seen).zip(tangents) {
            for (at, &value) in tangent.data().iter().enumerate().filter(|(_, v)| **v != 0.0) {
                if !*seen {
                    *seen = true;
                    refill(own, m * m * orders, C64::zero());
                }
                accumulate(&mut own[at * orders..][..orders], turns, share * value);
            }
        }
    }

    /// Adds the projections of all that was seen; `frequency` is the base frequency.
    pub fn project(&self, terms: &Terms, frequency: f64, out: &mut Into) {
        let orders = self.harmonics + 1;
        let of = |rows: &[C64], term: Term| {
            let (first, factor, count) = factors(term);
            let l = term.order();
            let value = |i: usize| conjugate_if(l < 0, rows[(first + i) * orders + l.unsigned_abs() as usize]);
            (0..count).fold(C64::zero(), |sum, i| sum + factor[i] * value(i))
        };
        for &(term, at) in &terms.list {
            let both = |rows: &[C64], out: &mut [f64]| {
                let (a, b) = out[at..].split_at_mut(1);
                let mut none = 0.0;
                add(term, of(rows, term), [&mut a[0], b.first_mut().unwrap_or(&mut none)]);
            };
            both(&self.rows, out.coefficients);
            if let Some(speed) = &mut out.speed {
                both(&self.rows_speed, speed);
            }
        }
        if let Some(jac) = &mut out.jac {
            for d in (0..3).filter(|&d| self.seen[d]) {
                for &(row, at) in &terms.list {
                    for &(column, from) in &terms.list {
                        self.couple(d, frequency, (row, at), (column, from), jac);
                    }
                }
            }
        }
    }

    /// Adds one tangent's coupling of the term at column `from` into that at row `at`.
    fn couple(&self, d: usize, frequency: f64, (row, at): (Term, usize), (column, from): (Term, usize), jac: &mut Mat) {
        let (m, orders) = (self.coordinates, 2 * self.harmonics + 1);
        let ((i, r, rows), (k, q, columns)) = (factors(row), factors(column));
        let (difference, sum) = (row.order() - column.order(), row.order() + column.order());
        let (mut direct, mut mirrored) = (C64::zero(), C64::zero());
        for (i, r) in (i..i + rows).zip(r) {
            for (k, q) in (k..k + columns).zip(q) {
                // 1/2 and -i/2 are half the conjugates of 1 and i
                let q = q.conj().scale(0.5);
                let hat = &self.tangents[d][(i * m + k) * orders..][..orders];
                let at = |l: i32| conjugate_if(l < 0, hat[l.unsigned_abs() as usize]);
                direct += r * q * at(difference);
                mirrored += r * q.conj() * at(sum);
            }
        }
        let mut g = C64::one();
        for _ in 0..d {
            g = g.mul_i().scale(f64::from(column.order()) * frequency);
        }
        (direct, mirrored) = (direct * g, mirrored * g.conj());
        let sign = if matches!(column, Term::Scalar { .. }) { -1.0 } else { 1.0 };
        let parts = [direct + mirrored, (direct - mirrored).mul_i().scale(sign)];
        for (part, value) in parts.into_iter().take(column.size()).enumerate() {
            let mut sums = [0.0; 2];
            let [a, b] = &mut sums;
            add(row, value, [a, b]);
            for (j, sum) in sums.into_iter().take(row.size()).enumerate() {
                jac[(at + j, from + part)] += sum;
            }
        }
    }
}

fn conjugate_if(yes: bool, z: C64) -> C64 {
    if yes { z.conj() } else { z }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::part::DofKind;
    use crate::symmetry::Symmetry;

    /// Against synthesis and its transpose at every instant, for pairs and scalars.
    #[test]
    fn projection_equals_the_mean_of_products() {
        let kinds = [DofKind::VectorX, DofKind::VectorY, DofKind::Scalar, DofKind::Scalar];
        for (symmetry, nu) in [(Symmetry::None, 1), (Symmetry::Half, 3), (Symmetry::Quarter, 1)] {
            let terms = Terms::new(&kinds, symmetry, 5, nu, 16);
            let (m, n, w) = (kinds.len(), terms.unknowns, 1.7);
            let x: Vec<f64> = (0..n).map(|i| (0.7 * i as f64).sin()).collect();
            let (mut own, mut powers, mut u) = (Coefficients::default(), Vec::new(), [0; 3].map(|_| Vec::new()));
            let (mut rows, mut speed, mut jac) = (vec![0.0; n], vec![0.0; n], Mat::zeros(n, n));
            let (mut rows_wanted, mut jac_wanted) = (vec![0.0; n], Mat::zeros(n, n));
            let mut synthesis = [0; 3].map(|_| Mat::default());
            own.clear(&terms);
            for j in 0..9 {
                let (tau, share) = (0.3 + 0.6 * f64::from(j), 0.1 + 0.01 * f64::from(j));
                turns(tau, 2 * terms.harmonics, &mut powers);
                terms.rows_at(tau, &mut synthesis);
                motion_at(&terms, &x, w, &powers, &mut u);
                for (d, u) in u.iter().enumerate() {
                    for (u, e) in u.iter().zip(synthesis[d].mul_vec(&x)) {
                        assert!((u - e * w.powi(d as i32)).abs() < 1e-12, "{u} {e}");
                    }
                }
                let row: Vec<f64> = (0..m).map(|i| (tau + i as f64).cos()).collect();
                let tangents = [0, 1, 2].map(|d| Mat::from_fn(m, m, |i, k| (tau * (d as f64 + 1.0) + (i * m + k) as f64).sin()));
                own.add_rows(&row, &powers, share);
                own.add_tangents(&row, [&tangents[0], &tangents[1], &tangents[2]], &powers, share);
                for &(term, at) in &terms.list {
                    for i in at..at + term.size() {
                        for c in 0..m {
                            let left = share * term.gain() * synthesis[0][(c, i)];
                            rows_wanted[i] += left * row[c];
                            for (d, t) in tangents.iter().enumerate() {
                                for k in 0..m {
                                    for o in 0..n {
                                        jac_wanted[(i, o)] += left * t[(c, k)] * synthesis[d][(k, o)] * w.powi(d as i32);
                                    }
                                }
                            }
                        }
                    }
                }
            }
            own.project(&terms, w, &mut Into { coefficients: &mut rows, jac: Some(&mut jac), speed: Some(&mut speed) });
            for i in 0..n {
                assert!((rows[i] - rows_wanted[i]).abs() < 1e-13 && (speed[i] - rows_wanted[i]).abs() < 1e-13);
                for o in 0..n {
                    let (a, b): (f64, f64) = (jac[(i, o)], jac_wanted[(i, o)]);
                    assert!((a - b).abs() < 1e-11, "{symmetry:?} {i} {o}: {a} {b}");
                }
            }
        }
    }
}
