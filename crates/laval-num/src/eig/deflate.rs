//! Removal of the infinite eigenvalues of `A x = s E x`.

use super::EigError;
use super::number::{Number, apply_adjoint, frobenius};
use crate::complex::C64;
use crate::dense::Mat;

/// What is needed to bring a left vector back through one step.
struct Step<T> {
    u: Mat<T>,
    a_row: Mat<T>,
    e_row: Mat<T>,
    p: Mat<T>,
    s: Vec<f64>,
}

/// The part of a pencil with finite eigenvalues.
///
/// Each step takes E = U [E1; 0] and, with the same rows, A = U [A1; A2]. The rows A2 x = 0 are constraints: x stays in their null
/// space, and the pencil (A1, E1) on that space has as many rows and columns fewer as E had rank defect. Steps repeat until E is
/// regular, so that infinite eigenvalues of any index go, with orthogonal transformations only.
pub(super) struct Finite<T> {
    pub(super) a: Mat<T>,
    pub(super) e: Mat<T>,
    /// Columns: the space the right vectors live in; `None` when nothing was removed.
    basis: Option<Mat<T>>,
    steps: Vec<Step<T>>,
    pub(super) infinite: usize,
}

pub(super) fn finite_part<T: Number>(a: Mat<T>, e: Mat<T>) -> Result<Finite<T>, EigError> {
    let n = a.rows();
    let tolerance = 8.0 * n as f64 * f64::EPSILON;
    let (small_a, small_e) = (tolerance * frobenius(&a), tolerance * frobenius(&e));
    let mut f = Finite { a, e, basis: None, steps: vec![], infinite: 0 };
    while f.a.rows() > 0 {
        let m = f.a.rows();
        let left = T::svd(&f.e)?;
        let rank = left.s.iter().filter(|&&s| s > small_e).count();
        let d = m - rank;
        if d == 0 {
            break;
        }
        let uh = adjoint(&left.u);
        let (ua, ue) = (uh.matmul(&f.a), uh.matmul(&f.e));
        let right = T::svd(&block(&ua, rank..m, 0..m))?;
        if right.s.iter().any(|&s| s.is_nan() || s <= small_a) {
            return Err(EigError::SingularPencil);
        }
        let (row, null) = (block(&right.v, 0..m, 0..d), block(&right.v, 0..m, d..m));
        let (a1, e1) = (block(&ua, 0..rank, 0..m), block(&ue, 0..rank, 0..m));
        f.steps.push(Step { a_row: a1.matmul(&row), e_row: e1.matmul(&row), u: left.u, p: right.u, s: right.s });
        f.a = a1.matmul(&null);
        f.e = e1.matmul(&null);
        f.basis = Some(match f.basis {
            Some(b) => b.matmul(&null),
            None => null,
        });
        f.infinite += d;
    }
    Ok(f)
}

impl<T: Number> Finite<T> {
    /// A right vector of the whole pencil.
    pub(super) fn right(&self, z: Vec<C64>) -> Vec<C64> {
        match &self.basis {
            Some(b) => super::number::apply(b, &z),
            None => z,
        }
    }
    /// A left vector of the whole pencil at the eigenvalue s.
    pub(super) fn left(&self, mut y: Vec<C64>, s: C64) -> Vec<C64> {
        for st in self.steps.iter().rev() {
            // y2^H P S = -y1^H (A1 - s E1) V_row.
            let (ya, ye) = (apply_adjoint(&st.a_row, &y), apply_adjoint(&st.e_row, &y));
            let w: Vec<C64> = ya.iter().zip(&ye).zip(&st.s).map(|((&a, &e), &k)| (s.conj() * e - a).scale(1.0 / k)).collect();
            let y2 = super::number::apply(&st.p, &w);
            y.extend(y2);
            y = super::number::apply(&st.u, &y);
        }
        y
    }
}

fn adjoint<T: Number>(m: &Mat<T>) -> Mat<T> {
    Mat::from_fn(m.cols(), m.rows(), |i, j| m[(j, i)].conj())
}

fn block<T: Number>(m: &Mat<T>, rows: std::ops::Range<usize>, cols: std::ops::Range<usize>) -> Mat<T> {
    Mat::from_fn(rows.len(), cols.len(), |i, j| m[(rows.start + i, cols.start + j)])
}
