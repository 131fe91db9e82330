//! Forward, backward and axial sectors of a machine.
//!
//! A pair of coordinates that turns like a vector is replaced by `u+ = (x + i y)/sqrt(2)` and `u- = (x - i y)/sqrt(2)`: under a turn by an angle `a`
//! they are multiplied by `exp(+i a)` and `exp(-i a)`, everything else by one. A machine without preferred direction couples no two sectors.
//! A motion `exp(s t)` with Im s > 0 is a forward whirl in the `+` sector and a backward whirl in the `-` sector.

use crate::model::part::DofKind;
use laval_num::complex::{C64, c};
use laval_num::dense::{Field, Mat};
use laval_num::factor::Pattern;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_1_SQRT_2;

/// A sector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Sector {
    /// `u+` of every pair: turns with the rotor.
    Forward,
    /// `u-` of every pair.
    Backward,
    /// Coordinates that do not turn.
    Axial,
}

impl Sector {
    /// How often the coordinate turns when the machine turns once: 1, -1, 0.
    pub fn winding(self) -> f64 {
        match self {
            Sector::Forward => 1.0,
            Sector::Backward => -1.0,
            Sector::Axial => 0.0,
        }
    }
}

/// Which sector each coordinate belongs to after [`Sectors::polarise`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sectors {
    of: Vec<Sector>,
}

impl Sectors {
    /// From the kinds of coordinates in their order.
    pub fn new(kinds: impl IntoIterator<Item = DofKind>) -> Self {
        let kinds: Vec<DofKind> = kinds.into_iter().collect();
        let mut of = vec![Sector::Axial; kinds.len()];
        for i in 0..kinds.len().saturating_sub(1) {
            if kinds[i].leads_pair() {
                (of[i], of[i + 1]) = (Sector::Forward, Sector::Backward);
            }
        }
        Sectors { of }
    }

    /// Number of coordinates.
    pub fn len(&self) -> usize {
        self.of.len()
    }
    /// No coordinates.
    pub fn is_empty(&self) -> bool {
        self.of.is_empty()
    }
    /// Sector of a coordinate.
    pub fn of(&self, i: usize) -> Sector {
        self.of[i]
    }
    /// Coordinates of a sector.
    pub fn members(&self, sector: Sector) -> Vec<usize> {
        (0..self.len()).filter(|&i| self.of[i] == sector).collect()
    }
    /// Indices of the first coordinate of each pair.
    pub fn pairs(&self) -> Vec<usize> {
        self.members(Sector::Forward)
    }
    /// The sectors of several lists one after the other.
    pub fn chain(parts: &[&Sectors]) -> Sectors {
        Sectors { of: parts.iter().flat_map(|s| s.of.iter().copied()).collect() }
    }
    /// `dx/da` of a turn by the angle `a`: `(x, y) -> (-y, x)` for pairs, zero elsewhere.
    pub fn quarter_turn(&self, x: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; x.len()];
        for i in self.pairs() {
            (out[i], out[i + 1]) = (-x[i + 1], x[i]);
        }
        out
    }
    /// `m J` with J of [`Sectors::quarter_turn`].
    pub fn times_quarter_turn(&self, m: &Mat) -> Mat {
        let mut out = Mat::zeros(m.rows(), m.cols());
        for i in self.pairs() {
            for r in 0..m.rows() {
                (out[(r, i)], out[(r, i + 1)]) = (m[(r, i + 1)], -m[(r, i)]);
            }
        }
        out
    }

    /// Vector in sector coordinates, in place.
    pub fn polarise(&self, x: &mut [C64]) {
        for i in self.pairs() {
            let (a, b) = (x[i], x[i + 1].mul_i());
            (x[i], x[i + 1]) = ((a + b).scale(FRAC_1_SQRT_2), (a - b).scale(FRAC_1_SQRT_2));
        }
    }
    /// Vector in x and y again, in place.
    pub fn restore(&self, u: &mut [C64]) {
        for i in self.pairs() {
            let (p, m) = (u[i], u[i + 1]);
            (u[i], u[i + 1]) = ((p + m).scale(FRAC_1_SQRT_2), (m - p).mul_i().scale(FRAC_1_SQRT_2));
        }
    }
    /// Matrix in sector coordinates: rows of `rows`, columns of `self`.
    pub fn polarise_matrix(&self, rows: &Sectors, m: &mut Mat<C64>) {
        for i in rows.pairs() {
            for j in 0..m.cols() {
                let (a, b) = (m[(i, j)], m[(i + 1, j)].mul_i());
                (m[(i, j)], m[(i + 1, j)]) = ((a + b).scale(FRAC_1_SQRT_2), (a - b).scale(FRAC_1_SQRT_2));
            }
        }
        for j in self.pairs() {
            for i in 0..m.rows() {
                let (x, y) = (m[(i, j)], m[(i, j + 1)].mul_i());
                (m[(i, j)], m[(i, j + 1)]) = ((x - y).scale(FRAC_1_SQRT_2), (x + y).scale(FRAC_1_SQRT_2));
            }
        }
    }
    /// Matrix in x and y again.
    pub fn restore_matrix(&self, rows: &Sectors, m: &mut Mat<C64>) {
        for i in rows.pairs() {
            for j in 0..m.cols() {
                let (p, q) = (m[(i, j)], m[(i + 1, j)]);
                (m[(i, j)], m[(i + 1, j)]) = ((p + q).scale(FRAC_1_SQRT_2), (q - p).mul_i().scale(FRAC_1_SQRT_2));
            }
        }
        for j in self.pairs() {
            for i in 0..m.rows() {
                let (p, q) = (m[(i, j)], m[(i, j + 1)]);
                (m[(i, j)], m[(i, j + 1)]) = ((p + q).scale(FRAC_1_SQRT_2), (p - q).mul_i().scale(FRAC_1_SQRT_2));
            }
        }
    }
    /// Entries of a square matrix in sector coordinates; the pattern couples both components of a pair with whatever it couples one of them with.
    pub fn polarise_entries(&self, pattern: &Pattern, values: &mut [C64]) {
        for i in self.pairs() {
            let rows = pattern.row(i).zip(pattern.row(i + 1));
            for ((p, _), (q, _)) in rows {
                let (a, b) = (values[p], values[q].mul_i());
                (values[p], values[q]) = ((a + b).scale(FRAC_1_SQRT_2), (a - b).scale(FRAC_1_SQRT_2));
            }
        }
        for i in 0..pattern.n() {
            for (e, j) in pattern.row(i) {
                if self.of[j] == Sector::Forward {
                    let (x, y) = (values[e], values[e + 1].mul_i());
                    (values[e], values[e + 1]) = ((x - y).scale(FRAC_1_SQRT_2), (x + y).scale(FRAC_1_SQRT_2));
                }
            }
        }
    }
    /// Entries in x and y again.
    pub fn restore_entries(&self, pattern: &Pattern, values: &mut [C64]) {
        for i in self.pairs() {
            for ((p, _), (q, _)) in pattern.row(i).zip(pattern.row(i + 1)) {
                let (a, b) = (values[p], values[q]);
                (values[p], values[q]) = ((a + b).scale(FRAC_1_SQRT_2), (b - a).mul_i().scale(FRAC_1_SQRT_2));
            }
        }
        for i in 0..pattern.n() {
            for (e, j) in pattern.row(i) {
                if self.of[j] == Sector::Forward {
                    let (a, b) = (values[e], values[e + 1]);
                    (values[e], values[e + 1]) = ((a + b).scale(FRAC_1_SQRT_2), (a - b).mul_i().scale(FRAC_1_SQRT_2));
                }
            }
        }
    }
    /// Complex copy of a real matrix in sector coordinates.
    pub fn polarised(&self, rows: &Sectors, m: &Mat) -> Mat<C64> {
        let mut z = m.to_complex();
        self.polarise_matrix(rows, &mut z);
        z
    }

    /// Largest entry of a polarised matrix that couples two sectors, over the largest entry; NaN stays NaN.
    pub fn coupling(&self, rows: &Sectors, polarised: &Mat<C64>) -> f64 {
        let all = polarised.max_size();
        if all == 0.0 {
            return 0.0;
        }
        let mut worst = 0.0;
        for i in 0..polarised.rows() {
            for j in 0..polarised.cols() {
                let x = polarised[(i, j)].size();
                if rows.of[i] != self.of[j] && (x > worst || x.is_nan()) {
                    worst = x;
                }
            }
        }
        worst / all
    }
    /// The same of the entries of a square matrix.
    pub fn coupling_of_entries(&self, pattern: &Pattern, polarised: &[C64]) -> f64 {
        let larger = |a: f64, x: f64| if x > a || x.is_nan() { x } else { a };
        let all = polarised.iter().map(|x| x.size()).fold(0.0, larger);
        let across = |i: usize| pattern.row(i).filter(move |&(_, j)| self.of[i] != self.of[j]);
        let worst = (0..pattern.n()).flat_map(across).map(|(e, _)| polarised[e].size()).fold(0.0, larger);
        if all == 0.0 { 0.0 } else { worst / all }
    }
}

/// Amplitudes of the forward and the backward circular motion of the pair `(x, y) exp(s t)`, Im s > 0: the real motion is
/// `x + i y = F exp(i w t) + B exp(-i w t)` (times its growth).
pub fn circular(x: C64, y: C64) -> (C64, C64) {
    let iy = y.mul_i();
    ((x + iy).scale(0.5), (x - iy).scale(0.5).conj())
}

/// Rows and columns of a matrix.
pub fn block<T: Field>(m: &Mat<T>, rows: &[usize], cols: &[usize]) -> Mat<T> {
    Mat::from_fn(rows.len(), cols.len(), |i, j| m[(rows[i], cols[j])])
}

/// The imaginary unit times a number.
pub fn imaginary(w: f64) -> C64 {
    c(0.0, w)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_is_a_phase_in_each_sector() {
        let s = Sectors::new([DofKind::Scalar, DofKind::VectorX, DofKind::VectorY]);
        let (x, y, a) = (0.3, -0.8, 0.4f64);
        let mut u = [c(2.0, 0.0), c(x, 0.0), c(y, 0.0)];
        let mut v = [c(2.0, 0.0), c(a.cos() * x - a.sin() * y, 0.0), c(a.sin() * x + a.cos() * y, 0.0)];
        s.polarise(&mut u);
        s.polarise(&mut v);
        assert!((v[1] - u[1] * C64::cis(a)).abs() < 1e-15 && (v[2] - u[2] * C64::cis(-a)).abs() < 1e-15 && v[0] == u[0]);
        s.restore(&mut u);
        assert!((u[1] - c(x, 0.0)).abs() < 1e-15 && (u[2] - c(y, 0.0)).abs() < 1e-15);
    }

    #[test]
    fn matrices_turn_like_vectors() {
        let s = Sectors::new([DofKind::VectorX, DofKind::VectorY, DofKind::Scalar]);
        let m = Mat::from_fn(3, 3, |i, j| (1 + 3 * i + j * j) as f64);
        let x = [c(0.2, 0.1), c(-0.4, 0.3), c(1.0, 0.0)];
        let (mut px, mut mx) = (x, m.to_complex().mul_vec(&x));
        s.polarise(&mut px);
        s.polarise(&mut mx);
        let p = s.polarised(&s, &m);
        assert!(p.mul_vec(&px).iter().zip(&mx).all(|(a, b)| (*a - *b).abs() < 1e-14));
        let mut back = p;
        s.restore_matrix(&s, &mut back);
        assert!((0..9).all(|k| (back.data()[k] - c(m.data()[k], 0.0)).abs() < 1e-14));
        let full = Pattern::new(3, (0..3).flat_map(|i| (0..3).map(move |j| (i, j))));
        let mut entries: Vec<C64> = m.data().iter().map(|x| c(*x, 0.0)).collect();
        s.polarise_entries(&full, &mut entries);
        assert!(entries.iter().zip(s.polarised(&s, &m).data()).all(|(a, b)| (*a - *b).abs() < 1e-14));
        s.restore_entries(&full, &mut entries);
        assert!(entries.iter().zip(m.data()).all(|(a, b)| (*a - c(*b, 0.0)).abs() < 1e-14));
        let iso = Mat::from_fn(3, 3, |i, j| [[2.0, -3.0, 0.0], [3.0, 2.0, 0.0], [0.0, 0.0, 1.0]][i][j]);
        assert!(s.coupling(&s, &s.polarised(&s, &iso)) < 1e-15);
        assert!(s.coupling(&s, &s.polarised(&s, &m)) > 0.1);
    }
}
