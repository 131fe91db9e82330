//! Sparse matrices of one member or of lanes: an entry is where any member has one; members without it have a zero there.

use super::Entry;
use crate::dense::Mat;
use std::ops::Range;

/// Sparse matrix, row by row, columns in increasing order.
#[derive(Debug)]
pub struct Sparse<S> {
    rows: usize,
    cols: usize,
    /// Where each row begins in the lists below, and the end of the last.
    start: Vec<u32>,
    /// Below `cols`.
    col: Vec<u32>,
    /// Distance of the column's element from the first, bytes.
    at: Vec<u32>,
    value: Vec<S>,
}

impl<S: Entry> Sparse<S> {
    /// No entries.
    pub fn new(rows: usize, cols: usize) -> Self {
        Sparse { rows, cols, start: vec![0; rows + 1], col: vec![], at: vec![], value: vec![] }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// Puts a member's matrix, of this size, into a lane.
    pub fn set(&mut self, lane: usize, entry: &Mat) {
        assert_eq!((entry.rows(), entry.cols()), (self.rows, self.cols));
        for i in 0..self.rows {
            for k in self.span(i) {
                self.value[k] = self.value[k].with(lane, entry[(i, self.col[k] as usize)]);
            }
            for j in 0..self.cols {
                let x = entry[(i, j)];
                // NaN is an entry
                if x == 0.0 {
                    continue;
                }
                let span = self.span(i);
                let at = span.start + self.col[span.clone()].partition_point(|&c| (c as usize) < j);
                if at == span.end || self.col[at] as usize != j {
                    self.col.insert(at, j as u32);
                    self.at.insert(at, (j * size_of::<S>()) as u32);
                    self.value.insert(at, S::zero().with(lane, x));
                    for s in &mut self.start[i + 1..] {
                        *s += 1;
                    }
                }
            }
        }
    }

    /// Row after row times `x` (of as many entries as columns), each result put where `place` says.
    ///
    /// # Panics
    /// On a vector of another length, or a place outside `out`.
    #[inline(always)]
    pub fn times(&self, x: &[S], place: &[usize], out: &mut [S]) {
        assert!(x.len() == self.cols && place.len() == self.rows);
        let mut k = 0;
        for (&end, &at) in self.start[1..].iter().zip(place) {
            // SAFETY: `end` is at most the last entry of `start`, and `x` has `cols` entries
            out[at] = unsafe { self.row(k, end as usize, x) };
            k = end as usize;
        }
    }

    /// Row after row times `x`, in order.
    ///
    /// # Panics
    /// As [`Sparse::times`].
    #[inline(always)]
    pub fn times_in_order(&self, x: &[S], out: &mut [S]) {
        assert!(x.len() == self.cols && out.len() == self.rows);
        let mut k = 0;
        for (&end, out) in self.start[1..].iter().zip(out) {
            // SAFETY: as in `times`
            *out = unsafe { self.row(k, end as usize, x) };
            k = end as usize;
        }
    }

    /// The sum over the entries from `k` to `end`, from left to right.
    ///
    /// # Safety
    /// `end` must not exceed the number of entries, nor `cols` the length of `x`.
    #[inline(always)]
    unsafe fn row(&self, mut k: usize, end: usize, x: &[S]) -> S {
        // SAFETY: `product` is called below `end` only. Short rows are the rule: without a loop
        unsafe {
            match end - k {
                0 => S::zero(),
                1 => self.product(k, x),
                2 => self.product(k, x) + self.product(k + 1, x),
                3 => self.product(k, x) + self.product(k + 1, x) + self.product(k + 2, x),
                4 => self.product(k, x) + self.product(k + 1, x) + self.product(k + 2, x) + self.product(k + 3, x),
                _ => {
                    let mut sum = self.product(k, x);
                    loop {
                        k += 1;
                        if k == end {
                            return sum;
                        }
                        sum += self.product(k, x);
                    }
                }
            }
        }
    }

    /// Entry `k` times its element of `x`.
    ///
    /// # Safety
    /// `k` must be below the number of entries, and `cols` not exceed the length of `x`.
    #[inline(always)]
    unsafe fn product(&self, k: usize, x: &[S]) -> S {
        // SAFETY: both lists have as many entries, and columns are below `cols`
        unsafe { *self.value.get_unchecked(k) * *x.as_ptr().byte_add(*self.at.get_unchecked(k) as usize) }
    }

    /// Where the entries of a row are.
    #[inline(always)]
    pub fn span(&self, i: usize) -> Range<usize> {
        self.start[i] as usize..self.start[i + 1] as usize
    }
    /// Column and value of an entry.
    #[inline(always)]
    pub fn at(&self, k: usize) -> (usize, S) {
        (self.col[k] as usize, self.value[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Kernel, LaneScalar, Level, dispatch};

    struct Products;
    impl Kernel for Products {
        type Out = ();
        #[inline(always)]
        fn run<S: LaneScalar>(self) {
            // members with different patterns
            let matrix = |lane: usize| {
                Mat::from_fn(3, 4, |i, j| if (i + j + lane).is_multiple_of(3) { (1 + i + 10 * j + 100 * lane) as f64 } else { 0.0 })
            };
            let mut sparse = Sparse::<S>::new(3, 4);
            for lane in [5, 0, 3] {
                sparse.set(lane, &matrix(lane));
            }
            let x = [1.0, -2.0, 0.5, 3.0];
            let lanes = x.map(S::cst);
            let (mut out, mut ordered) = ([S::one(); 5], [S::one(); 3]);
            sparse.times(&lanes, &[4, 0, 2], &mut out);
            sparse.times_in_order(&lanes, &mut ordered);
            for lane in [0, 3, 5] {
                let m = matrix(lane);
                for (i, at) in [4, 0, 2].into_iter().enumerate() {
                    let expected: f64 = (0..4).map(|j| m[(i, j)] * x[j]).sum();
                    assert_eq!((out[at].get(lane), ordered[i].get(lane)), (expected, expected));
                }
            }
            assert!(out[1].get(0) == 1.0 && out[3].get(0) == 1.0 && ordered[0].get(7) == 0.0);
        }
    }

    #[test]
    fn rows_times_a_vector() {
        for level in Level::supported() {
            dispatch(level, Products);
        }
    }
}
