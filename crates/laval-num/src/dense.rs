//! Small dense matrices, row-major, and their LU factors, real or complex. Large problems belong to a sparse library.

use crate::complex::{C64, c};
use crate::refill::refill;
use crate::work::spend;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// A number a linear system can be solved in.
pub trait Field:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// A cheap size for pivoting: |re| + |im|.
    fn size(self) -> f64;
}

impl Field for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    #[inline(always)]
    fn size(self) -> f64 {
        self.abs()
    }
}
impl Field for C64 {
    const ZERO: Self = c(0.0, 0.0);
    const ONE: Self = c(1.0, 0.0);
    #[inline(always)]
    fn size(self) -> f64 {
        self.re.abs() + self.im.abs()
    }
}

/// Work of so many products of numbers of a kind.
fn products<T>(count: usize) -> u64 {
    let reals = size_of::<T>() / size_of::<f64>();
    (count * reals * reals) as u64
}

/// Row-major matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Mat<T = f64> {
    rows: usize,
    cols: usize,
    data: Vec<T>,
}

impl<T> Default for Mat<T> {
    fn default() -> Self {
        Mat { rows: 0, cols: 0, data: Vec::new() }
    }
}

impl<T: Field> Mat<T> {
    /// Zero matrix.
    pub fn zeros(rows: usize, cols: usize) -> Self {
        Mat { rows, cols, data: vec![T::ZERO; rows * cols] }
    }
    /// Identity.
    pub fn identity(n: usize) -> Self {
        Self::from_fn(n, n, |i, j| if i == j { T::ONE } else { T::ZERO })
    }
    /// Entry by entry.
    pub fn from_fn(rows: usize, cols: usize, mut f: impl FnMut(usize, usize) -> T) -> Self {
        let mut data = Vec::with_capacity(rows * cols);
        for i in 0..rows {
            for j in 0..cols {
                data.push(f(i, j));
            }
        }
        Mat { rows, cols, data }
    }
    /// Number of rows.
    #[inline(always)]
    pub fn rows(&self) -> usize {
        self.rows
    }
    /// Number of columns.
    #[inline(always)]
    pub fn cols(&self) -> usize {
        self.cols
    }
    /// Row `i`.
    #[inline(always)]
    pub fn row(&self, i: usize) -> &[T] {
        &self.data[i * self.cols..(i + 1) * self.cols]
    }
    /// Row `i`, mutable.
    #[inline(always)]
    pub fn row_mut(&mut self, i: usize) -> &mut [T] {
        &mut self.data[i * self.cols..(i + 1) * self.cols]
    }
    /// All entries, row by row.
    #[inline(always)]
    pub fn data(&self) -> &[T] {
        &self.data
    }
    /// All entries, row by row, mutable.
    #[inline(always)]
    pub fn data_mut(&mut self) -> &mut [T] {
        &mut self.data
    }
    /// Sets the shape and all entries to zero, keeping the allocation where it suffices.
    pub fn reset(&mut self, rows: usize, cols: usize) {
        self.rows = rows;
        self.cols = cols;
        refill(&mut self.data, rows * cols, T::ZERO);
    }
    /// Copies shape and entries, keeping the allocation where it suffices.
    pub fn copy_from(&mut self, o: &Self) {
        self.rows = o.rows;
        self.cols = o.cols;
        self.data.clear();
        self.data.extend_from_slice(&o.data);
    }
    /// Transpose (without conjugation).
    pub fn transpose(&self) -> Self {
        Self::from_fn(self.cols, self.rows, |i, j| self[(j, i)])
    }
    /// `self * o`.
    pub fn matmul(&self, o: &Self) -> Self {
        let mut out = Self::zeros(self.rows, o.cols);
        self.matmul_into(o, &mut out);
        out
    }
    /// `out = self * o`.
    pub fn matmul_into(&self, o: &Self, out: &mut Self) {
        assert_eq!(self.cols, o.rows, "inner dimensions of a product differ");
        out.reset(self.rows, o.cols);
        self.matmul_add(o, out);
    }
    /// `out += self * o`.
    pub fn matmul_add(&self, o: &Self, out: &mut Self) {
        assert!(self.cols == o.rows && self.rows == out.rows && o.cols == out.cols, "dimensions of a product differ");
        spend(products::<T>(self.rows * self.cols * o.cols));
        if o.cols == 0 || self.cols == 0 {
            return;
        }
        let whole = self.cols / 4 * 4;
        for (factors, row) in self.data.chunks_exact(self.cols).zip(out.data.chunks_exact_mut(o.cols)) {
            // four rows at once: the sum stays in a register meanwhile, in the order of the sum
            for (a, b) in factors.chunks_exact(4).zip(o.data.chunks_exact(4 * o.cols)) {
                if a.iter().all(|&a| a == T::ZERO) {
                    continue;
                }
                let (b0, rest) = b.split_at(o.cols);
                let (b1, rest) = rest.split_at(o.cols);
                let (b2, b3) = rest.split_at(o.cols);
                for ((((r, &b0), &b1), &b2), &b3) in row.iter_mut().zip(b0).zip(b1).zip(b2).zip(b3) {
                    *r = (((*r + a[0] * b0) + a[1] * b1) + a[2] * b2) + a[3] * b3;
                }
            }
            for (&a, b) in factors[whole..].iter().zip(o.data[whole * o.cols..].chunks_exact(o.cols)) {
                if a != T::ZERO {
                    for (r, &b) in row.iter_mut().zip(b) {
                        *r += a * b;
                    }
                }
            }
        }
    }
    /// `self * x`.
    pub fn mul_vec(&self, x: &[T]) -> Vec<T> {
        let mut y = vec![T::ZERO; self.rows];
        self.mul_vec_add(x, &mut y);
        y
    }
    /// `y += self * x`.
    pub fn mul_vec_add(&self, x: &[T], y: &mut [T]) {
        assert!(self.cols == x.len() && self.rows == y.len(), "lengths of vectors differ from the matrix");
        if self.cols == 0 {
            return;
        }
        // four sums side by side, each in its order: one alone waits for its own last addition
        let mut rows = self.data.chunks_exact(4 * self.cols);
        let mut sums = y.chunks_exact_mut(4);
        for (rows, y) in rows.by_ref().zip(sums.by_ref()) {
            let (r0, rest) = rows.split_at(self.cols);
            let (r1, rest) = rest.split_at(self.cols);
            let (r2, r3) = rest.split_at(self.cols);
            let [mut s0, mut s1, mut s2, mut s3] = [y[0], y[1], y[2], y[3]];
            for ((((&x, &a0), &a1), &a2), &a3) in x.iter().zip(r0).zip(r1).zip(r2).zip(r3) {
                s0 += a0 * x;
                s1 += a1 * x;
                s2 += a2 * x;
                s3 += a3 * x;
            }
            y.copy_from_slice(&[s0, s1, s2, s3]);
        }
        for (row, y) in rows.remainder().chunks_exact(self.cols).zip(sums.into_remainder()) {
            for (&a, &b) in row.iter().zip(x) {
                *y += a * b;
            }
        }
    }
    /// Largest |entry| (|re| + |im| for complex); NaN if any entry is NaN.
    pub fn max_size(&self) -> f64 {
        self.data.iter().fold(0.0, |m: f64, x| if x.size() > m || x.size().is_nan() { x.size() } else { m })
    }
}

impl Mat<f64> {
    /// The same matrix with complex entries.
    pub fn to_complex(&self) -> Mat<C64> {
        Mat { rows: self.rows, cols: self.cols, data: self.data.iter().map(|&x| c(x, 0.0)).collect() }
    }
}

impl<T: Field> Index<(usize, usize)> for Mat<T> {
    type Output = T;
    #[inline(always)]
    fn index(&self, (i, j): (usize, usize)) -> &T {
        debug_assert!(j < self.cols);
        &self.data[i * self.cols + j]
    }
}
impl<T: Field> IndexMut<(usize, usize)> for Mat<T> {
    #[inline(always)]
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut T {
        debug_assert!(j < self.cols);
        &mut self.data[i * self.cols + j]
    }
}

/// A matrix without an inverse (to rounding), or with an entry that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Singular {
    /// Elimination step at which no pivot was left.
    pub column: usize,
}

impl std::fmt::Display for Singular {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "singular matrix (no pivot in column {})", self.column)
    }
}
impl std::error::Error for Singular {}

/// LU factors with row pivoting. Reusable: [`Lu::factor`] keeps its allocation.
#[derive(Clone, Debug)]
pub struct Lu<T = f64> {
    lu: Mat<T>,
    /// One over each entry of the diagonal.
    inverse: Vec<T>,
    pivots: Vec<usize>,
    odd: bool,
}

impl<T: Field> Default for Lu<T> {
    fn default() -> Self {
        Lu { lu: Mat::default(), inverse: Vec::new(), pivots: Vec::new(), odd: false }
    }
}

impl<T: Field> Lu<T> {
    /// Factors of a square matrix.
    pub fn new(a: &Mat<T>) -> Result<Self, Singular> {
        let mut lu = Self::default();
        lu.factor(a)?;
        Ok(lu)
    }
    /// Factors `a` into this object.
    pub fn factor(&mut self, a: &Mat<T>) -> Result<(), Singular> {
        assert_eq!(a.rows, a.cols, "only a square matrix has LU factors");
        let n = a.rows;
        spend(products::<T>(n * n * (n + 3) / 3));
        self.lu.copy_from(a);
        self.pivots.clear();
        self.inverse.clear();
        self.odd = false;
        let d = &mut self.lu.data[..];
        for k in 0..n {
            let (mut p, mut best) = (k, -1.0);
            for i in k..n {
                let s = d[i * n + k].size();
                if s > best {
                    (p, best) = (i, s);
                }
            }
            if best <= 0.0 || !best.is_finite() {
                return Err(Singular { column: k });
            }
            self.pivots.push(p);
            if p != k {
                self.odd = !self.odd;
                for j in 0..n {
                    d.swap(k * n + j, p * n + j);
                }
            }
            let inv = T::ONE / d[k * n + k];
            self.inverse.push(inv);
            let (top, bottom) = d.split_at_mut((k + 1) * n);
            let pivot_row = &top[k * n + k + 1..];
            for row in bottom.chunks_exact_mut(n) {
                let l = row[k] * inv;
                row[k] = l;
                if l != T::ZERO {
                    for (r, &u) in row[k + 1..].iter_mut().zip(pivot_row) {
                        *r -= l * u;
                    }
                }
            }
        }
        Ok(())
    }
    /// Solves `A x = b` in place.
    pub fn solve(&self, b: &mut [T]) {
        let n = self.lu.rows;
        assert_eq!(b.len(), n, "length of the right side differs from the matrix");
        spend(products::<T>(n * n));
        for (k, &p) in self.pivots.iter().enumerate() {
            b.swap(k, p);
        }
        for i in 0..n {
            let row = self.lu.row(i);
            let mut s = b[i];
            for (&l, &x) in row[..i].iter().zip(&b[..i]) {
                s -= l * x;
            }
            b[i] = s;
        }
        for i in (0..n).rev() {
            let row = self.lu.row(i);
            let mut s = b[i];
            for (&u, &x) in row[i + 1..].iter().zip(&b[i + 1..]) {
                s -= u * x;
            }
            b[i] = s / row[i];
        }
    }
    /// Solves `A^T x = b` in place.
    pub fn solve_transposed(&self, b: &mut [T]) {
        let n = self.lu.rows;
        assert_eq!(b.len(), n, "length of the right side differs from the matrix");
        spend(products::<T>(n * n));
        for i in 0..n {
            let row = self.lu.row(i);
            let x = b[i] / row[i];
            b[i] = x;
            for (r, &u) in b[i + 1..].iter_mut().zip(&row[i + 1..]) {
                *r -= u * x;
            }
        }
        for i in (0..n).rev() {
            let x = b[i];
            for (r, &l) in b[..i].iter_mut().zip(&self.lu.row(i)[..i]) {
                *r -= l * x;
            }
        }
        for (k, &p) in self.pivots.iter().enumerate().rev() {
            b.swap(k, p);
        }
    }
    /// Pivots, and whether an odd number of rows was exchanged.
    pub(crate) fn pivots(&self) -> (impl Iterator<Item = T>, bool) {
        ((0..self.lu.rows).map(|i| self.lu[(i, i)]), self.odd)
    }
    /// Solves `A X = B`, all columns, in place.
    pub fn solve_mat(&self, b: &mut Mat<T>) {
        let (n, m) = (self.lu.rows, b.cols);
        assert_eq!(b.rows, n, "rows of the right side differ from the matrix");
        if m == 0 {
            return;
        }
        spend(products::<T>(n * n * m));
        for (k, &p) in self.pivots.iter().enumerate() {
            if k != p {
                for j in 0..m {
                    b.data.swap(k * m + j, p * m + j);
                }
            }
        }
        for i in 0..n {
            let (top, bottom) = b.data.split_at_mut(i * m);
            for (&l, known) in self.lu.row(i)[..i].iter().zip(top.chunks_exact(m)) {
                if l != T::ZERO {
                    for (r, &x) in bottom[..m].iter_mut().zip(known) {
                        *r -= l * x;
                    }
                }
            }
        }
        for i in (0..n).rev() {
            let (top, bottom) = b.data.split_at_mut((i + 1) * m);
            let row = &mut top[i * m..];
            for (&u, known) in self.lu.row(i)[i + 1..].iter().zip(bottom.chunks_exact(m)) {
                if u != T::ZERO {
                    for (r, &x) in row.iter_mut().zip(known) {
                        *r -= u * x;
                    }
                }
            }
            let inv = self.inverse[i];
            for r in row {
                *r = *r * inv;
            }
        }
    }
    /// Determinant.
    pub fn det(&self) -> T {
        let d = (0..self.lu.rows).fold(T::ONE, |d, i| d * self.lu[(i, i)]);
        if self.odd { -d } else { d }
    }
    /// Smallest over largest pivot: a cheap sign of near singularity.
    pub fn pivot_ratio(&self) -> f64 {
        let s = (0..self.lu.rows).map(|i| self.lu[(i, i)].size());
        let (lo, hi) = s.fold((f64::INFINITY, 0.0f64), |(lo, hi), x| (lo.min(x), hi.max(x)));
        lo / hi
    }
}

/// Euclidean norm; NaN if any entry is NaN.
pub fn norm(x: &[f64]) -> f64 {
    let m = max_abs(x);
    if m == 0.0 || !m.is_finite() {
        return m;
    }
    m * x.iter().map(|v| (v / m) * (v / m)).sum::<f64>().sqrt()
}

/// Largest modulus; NaN if any entry is NaN.
pub fn max_abs(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m: f64, v| if v.abs() > m || v.is_nan() { v.abs() } else { m })
}

/// Inner product.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pseudo(n: usize) -> Mat {
        let mut s = 1u64;
        Mat::from_fn(n, n, |_, _| {
            s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (s >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        })
    }

    #[test]
    fn solves_real_and_complex_systems() {
        for n in [1, 2, 5, 17] {
            let a = pseudo(n);
            let x: Vec<f64> = (0..n).map(|i| i as f64 - 1.5).collect();
            let mut b = a.mul_vec(&x);
            Lu::new(&a).unwrap().solve(&mut b);
            assert!(max_abs(&b.iter().zip(&x).map(|(b, x)| b - x).collect::<Vec<_>>()) < 1e-11);
            let mut z = a.to_complex();
            for i in 0..n {
                z[(i, i)] += c(0.0, 1.0);
            }
            let mut inv = Mat::identity(n);
            Lu::new(&z).unwrap().solve_mat(&mut inv);
            let mut e = z.matmul(&inv);
            for i in 0..n {
                e[(i, i)] -= C64::ONE;
            }
            assert!(e.max_size() < 1e-12);
        }
    }

    #[test]
    fn determinant_has_its_sign() {
        let a = Mat::from_fn(3, 3, |i, j| [[0.0, 2.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 5.0]][i][j]);
        assert_eq!(Lu::new(&a).unwrap().det(), -10.0);
    }

    #[test]
    fn singular_and_nan_are_errors() {
        assert!(Lu::new(&Mat::<f64>::zeros(2, 2)).is_err());
        assert!(Lu::new(&Mat::from_fn(2, 2, |_, _| f64::NAN)).is_err());
        assert!(max_abs(&[0.0, f64::NAN, 1.0]).is_nan() && norm(&[f64::NAN]).is_nan());
    }
}
