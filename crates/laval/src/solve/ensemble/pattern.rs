//! Sparse rows of lanes: entries are where any member has one; members without it have a zero there.

use laval_num::lanes::LaneScalar;

/// Sparse matrix of lanes, row by row, columns in increasing order.
pub(super) struct Pattern<S> {
    rows: usize,
    cols: usize,
    /// Where each row begins in the lists below.
    start: Vec<u32>,
    col: Vec<u32>,
    value: Vec<S>,
}

impl<S: LaneScalar> Pattern<S> {
    pub fn new(rows: usize, cols: usize) -> Self {
        Pattern { rows, cols, start: vec![0; rows + 1], col: vec![], value: vec![] }
    }

    /// Puts a member's matrix into a lane: `entry(i, j)`.
    pub fn set(&mut self, lane: usize, entry: impl Fn(usize, usize) -> f64) {
        for i in 0..self.rows {
            for k in self.start[i] as usize..self.start[i + 1] as usize {
                self.value[k] = self.value[k].with(lane, entry(i, self.col[k] as usize));
            }
            for j in 0..self.cols {
                let x = entry(i, j);
                // NaN is an entry
                if x == 0.0 {
                    continue;
                }
                let (first, last) = (self.start[i] as usize, self.start[i + 1] as usize);
                let at = first + self.col[first..last].partition_point(|&c| (c as usize) < j);
                if at == last || self.col[at] as usize != j {
                    self.col.insert(at, j as u32);
                    self.value.insert(at, S::zero().with(lane, x));
                    for s in &mut self.start[i + 1..] {
                        *s += 1;
                    }
                }
            }
        }
    }

    /// `sum + row i times x`.
    #[inline(always)]
    pub fn add_row(&self, i: usize, x: &[S], mut sum: S) -> S {
        let span = self.start[i] as usize..self.start[i + 1] as usize;
        let (col, value) = (&self.col[span.clone()], &self.value[span]);
        for k in 0..col.len() {
            sum += value[k] * x[col[k] as usize];
        }
        sum
    }

    /// Columns and values of a row.
    #[inline(always)]
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, S)> + '_ {
        (self.start[i] as usize..self.start[i + 1] as usize).map(|k| (self.col[k] as usize, self.value[k]))
    }
}
