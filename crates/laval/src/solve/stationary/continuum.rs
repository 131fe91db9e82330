//! States that are not isolated: three and more equal masses balance in a continuum of ways, and a mass that nothing holds rests anywhere.
//!
//! Newton's method has no step there. The shortest of all steps that serve, `s = A^T (A A^T)^-1 r` with the scaled Jacobian A, leads to the nearest state.

use super::Search;
use laval_num::continuation::Zero;
use laval_num::dense::{Lu, Mat, norm};

/// Pivots over the largest below which a direction is free.
const RANK: f64 = 1e-8;
/// Share of the largest square by which all singular values are lifted.
const LIFT: f64 = 1e-11;
/// Most steps, and the longest of them in typical sizes.
const STEPS: usize = 60;
const LONGEST: f64 = 0.5;

impl Search<'_> {
    /// Residual and Jacobian in typical sizes, every row of unit length.
    fn scaled(&mut self, x: &[f64], speed: f64) -> Option<(Vec<f64>, Mat)> {
        let n = x.len();
        let (mut r, mut a) = (vec![0.0; n], Mat::zeros(n, n));
        self.problem.eval(x, speed, &mut r, Some(&mut a), None).ok()?;
        for (i, r) in r.iter_mut().enumerate() {
            let row = a.row_mut(i);
            row.iter_mut().zip(&self.scale).for_each(|(a, s)| *a *= s);
            let length = norm(row);
            if length > 0.0 {
                row.iter_mut().for_each(|a| *a /= length);
                *r /= length;
            }
        }
        (r.iter().all(|r| r.is_finite()) && a.data().iter().all(|a| a.is_finite())).then_some((r, a))
    }

    /// In how many directions a state can be moved and stays a state: 0 when it is isolated. `None` where the equations have no value.
    pub fn freedom(&mut self, x: &[f64], speed: f64) -> Option<usize> {
        self.scaled(x, speed).map(|(_, a)| a.rows() - rank(a))
    }

    /// To a state near `x`, isolated or not, and the number of directions in which it is free; `None` when there is none near.
    pub fn settle_freely(&mut self, x: &mut [f64], speed: f64) -> Option<usize> {
        for _ in 0..STEPS {
            let (r, a) = self.scaled(x, speed)?;
            let t = a.transpose();
            let mut square = a.matmul(&t);
            (0..x.len()).for_each(|i| square[(i, i)] += LIFT);
            let mut weights = r.clone();
            Lu::new(&square).ok()?.solve(&mut weights);
            let mut step = t.mul_vec(&weights);
            let length = norm(&step);
            if !length.is_finite() {
                return None;
            }
            if length > LONGEST {
                step.iter_mut().for_each(|s| *s *= LONGEST / length);
            }
            x.iter_mut().zip(&step).zip(&self.scale).for_each(|((x, s), scale)| *x -= s * scale);
            let size = x.iter().zip(&self.scale).map(|(x, s)| (x / s).abs()).fold(1.0, f64::max);
            if length <= 1e-11 * size {
                let (r, _) = self.scaled(x, speed)?;
                return if norm(&r) <= 1e-10 * size { self.freedom(x, speed) } else { None };
            }
        }
        None
    }
}

/// Rank by elimination with full pivoting.
fn rank(mut a: Mat) -> usize {
    let n = a.rows();
    let mut largest = 0.0f64;
    let (mut rows, mut cols): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
    for k in 0..n {
        let (mut best, mut at) = (0.0f64, (k, k));
        for i in k..n {
            for j in k..n {
                let size = a[(rows[i], cols[j])].abs();
                if size > best {
                    (best, at) = (size, (i, j));
                }
            }
        }
        largest = largest.max(best);
        if best <= RANK * largest {
            return k;
        }
        rows.swap(k, at.0);
        cols.swap(k, at.1);
        let pivot = a[(rows[k], cols[k])];
        for i in k + 1..n {
            let factor = a[(rows[i], cols[k])] / pivot;
            for j in k..n {
                let own = a[(rows[k], cols[j])];
                a[(rows[i], cols[j])] -= factor * own;
            }
        }
    }
    n
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rank_is_the_number_of_independent_rows() {
        let full = Mat::from_fn(4, 4, |i, j| if i == j { 2.0 } else { 0.3 * (i as f64 - j as f64) });
        assert_eq!(rank(full.clone()), 4);
        // the last row is the sum of the first two
        let less = Mat::from_fn(4, 4, |i, j| if i == 3 { full[(0, j)] + full[(1, j)] } else { full[(i, j)] });
        assert_eq!(rank(less), 3);
        assert_eq!(rank(Mat::from_fn(3, 3, |i, j| (i + 1) as f64 * (j + 2) as f64)), 1);
        assert_eq!(rank(Mat::zeros(3, 3)), 0);
    }
}
