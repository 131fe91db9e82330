//! LU factors of a band with row exchanges, column by column (the layout of LAPACK's `gbtrf`).

use super::plan::{stored, width};
use crate::dense::{Field, Singular};

/// Factors of a band; reusable.
#[derive(Clone, Debug)]
pub(super) struct Banded<T> {
    n: usize,
    half: usize,
    /// Columns of `width(half)` numbers: U on and above the diagonal, the multipliers below.
    pub data: Vec<T>,
    /// Row exchanged with each.
    rows: Vec<usize>,
    pub odd: bool,
    /// Pivots that were replaced: row and column of the matrix, and what was added there.
    pub replaced: Vec<(usize, usize, T)>,
}

impl<T> Default for Banded<T> {
    fn default() -> Self {
        Banded { n: 0, half: 0, data: Vec::new(), rows: Vec::new(), odd: false, replaced: Vec::new() }
    }
}

impl<T: Field> Banded<T> {
    /// Zeros.
    pub fn reset(&mut self, n: usize, half: usize) {
        (self.n, self.half) = (n, half);
        crate::refill::refill(&mut self.data, n * width(half), T::ZERO);
    }

    /// Factors what `data` holds. A pivot below `least` is replaced where that is positive; otherwise a column without a pivot is an error.
    pub fn factor(&mut self, least: f64, real: impl Fn(f64) -> T) -> Result<(), Singular> {
        let (n, half, w) = (self.n, self.half, width(self.half));
        let diagonal = 2 * half;
        self.rows.clear();
        self.odd = false;
        self.replaced.clear();
        let mut order: Vec<usize> = (0..n).collect();
        // the last column that row exchanges have reached
        let mut reach = 0;
        for k in 0..n {
            let below = half.min(n - 1 - k);
            let base = k * w + diagonal;
            let (mut p, mut best) = (0, -1.0);
            for (i, x) in self.data[base..=base + below].iter().enumerate() {
                if x.size() > best {
                    (p, best) = (i, x.size());
                }
            }
            if !best.is_finite() || (best <= 0.0 && !(least > 0.0)) {
                return Err(Singular { column: k });
            }
            if best < least {
                p = 0;
                self.replaced.push((order[k], k, real(least) - self.data[base]));
                self.data[base] = real(least);
            }
            self.rows.push(k + p);
            order.swap(k, k + p);
            reach = reach.max((k + p + half).min(n - 1));
            if p != 0 {
                self.odd = !self.odd;
                for j in k..=reach {
                    let at = j * w + diagonal + k - j;
                    self.data.swap(at, at + p);
                }
            }
            let inverse = T::ONE / self.data[base];
            let (left, right) = self.data.split_at_mut((k + 1) * w);
            let factors = &mut left[base + 1..=base + below];
            factors.iter_mut().for_each(|l| *l = *l * inverse);
            for j in k + 1..=reach {
                let at = (j - k - 1) * w + diagonal + k - j;
                let u = right[at];
                if u != T::ZERO {
                    for (x, &l) in right[at + 1..=at + below].iter_mut().zip(&*factors) {
                        *x -= l * u;
                    }
                }
            }
        }
        Ok(())
    }

    /// Pivots in order.
    pub fn pivots(&self) -> impl Iterator<Item = T> {
        (0..self.n).map(|k| self.data[stored(self.half, k, k)])
    }

    /// Solves in place.
    pub fn solve(&self, b: &mut [T]) {
        let (n, half, w) = (self.n, self.half, width(self.half));
        let diagonal = 2 * half;
        for k in 0..n {
            b.swap(k, self.rows[k]);
            let below = half.min(n - 1 - k);
            let base = k * w + diagonal;
            let x = b[k];
            if x != T::ZERO {
                for (r, &l) in b[k + 1..=k + below].iter_mut().zip(&self.data[base + 1..=base + below]) {
                    *r -= l * x;
                }
            }
        }
        for k in (0..n).rev() {
            let base = k * w + diagonal;
            let above = (2 * half).min(k);
            let x = b[k] / self.data[base];
            b[k] = x;
            if x != T::ZERO {
                for (r, &u) in b[k - above..k].iter_mut().zip(&self.data[base - above..base]) {
                    *r -= u * x;
                }
            }
        }
    }

    /// Solves with the transposed matrix in place.
    pub fn solve_transposed(&self, b: &mut [T]) {
        let (n, half, w) = (self.n, self.half, width(self.half));
        let diagonal = 2 * half;
        for k in 0..n {
            let base = k * w + diagonal;
            let above = (2 * half).min(k);
            let mut x = b[k];
            for (&r, &u) in b[k - above..k].iter().zip(&self.data[base - above..base]) {
                x -= u * r;
            }
            b[k] = x / self.data[base];
        }
        for k in (0..n).rev() {
            let below = half.min(n - 1 - k);
            let base = k * w + diagonal;
            let mut x = b[k];
            for (&r, &l) in b[k + 1..=k + below].iter().zip(&self.data[base + 1..=base + below]) {
                x -= l * r;
            }
            b[k] = x;
            b.swap(k, self.rows[k]);
        }
    }
}
