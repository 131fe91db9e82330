//! States that are not isolated: three and more equal masses balance in a continuum of ways, and a mass that nothing holds rests anywhere.
//!
//! Newton's method has no step there. The shortest of all steps that serve, `s = A^T (A A^T)^-1 r` with the scaled Jacobian A, leads to the nearest state.
//! What holds masses by less than a hundred-thousandth counts as nothing where no isolated state is near: the weight of five balls tilts a disc by so little
//! that they lie anywhere they balance.
//!
//! Theory: `docs/theory/equilibria.md#continua`.

use super::Search;
use laval_num::continuation::Zero;
use laval_num::dense::{Lu, Mat, norm};

/// When a state is free.
struct Freedom {
    /// Pivots over the largest below which a direction is free.
    rank: f64,
    /// Share of the largest square by which all singular values are lifted.
    lift: f64,
    /// Length of a step, and residual, in typical sizes below which it is reached.
    step: f64,
    residual: f64,
}
const EXACTLY: Freedom = Freedom { rank: 1e-8, lift: 1e-11, step: 1e-11, residual: 1e-10 };
const NEARLY: Freedom = Freedom { rank: 1e-4, lift: 1e-4, step: 1e-5, residual: 1e-5 };
/// Places at which the masses are held for comparison.
const PULLS: usize = 6;
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
        self.scaled(x, speed).map(|(_, a)| a.rows() - rank(a, EXACTLY.rank))
    }

    /// To a state near `x`, isolated or not, and the number of directions in which it is free; `None` when there is none near.
    pub fn settle_freely(&mut self, x: &mut [f64], speed: f64) -> Option<usize> {
        let start = x.to_vec();
        if let Some(free) = self.settle_within(x, speed, &EXACTLY) {
            return Some(free);
        }
        x.copy_from_slice(&start);
        let free = self.settle_within(x, speed, &NEARLY).filter(|free| *free > 0)?;
        if !(self.pull(x, speed)? <= NEARLY.residual * self.usual_pull(speed)?) {
            return None;
        }
        let mut isolated = x.to_vec();
        if self.settle(&mut isolated, speed).is_ok() && self.freedom(&isolated, speed) == Some(0) {
            x.copy_from_slice(&isolated);
            return Some(0);
        }
        Some(free)
    }

    /// Largest force (of angles N m) on what moves in the rotor.
    fn pull(&mut self, x: &[f64], speed: f64) -> Option<f64> {
        let mut r = vec![0.0; x.len()];
        self.problem.eval(x, speed, &mut r, None, None).ok()?;
        Some(self.images.angles.iter().map(|&i| r[i].abs()).fold(0.0, |m, r| if r <= m { m } else { r }))
    }

    /// The same where it is held anywhere: the least of some places, as masses that happen to touch push each other hard.
    fn usual_pull(&mut self, speed: f64) -> Option<f64> {
        let mut least = f64::INFINITY;
        for k in 0..PULLS {
            // the first two of four starts are spread over the turn
            if let Some(x) = self.start(k / 2 * 4 + k % 2, speed) {
                least = least.min(self.pull(&x, speed)?);
            }
        }
        least.is_finite().then_some(least)
    }

    fn settle_within(&mut self, x: &mut [f64], speed: f64, limits: &Freedom) -> Option<usize> {
        let mut near = false;
        for _ in 0..STEPS {
            let (r, a) = self.scaled(x, speed)?;
            let t = a.transpose();
            let mut square = a.matmul(&t);
            (0..x.len()).for_each(|i| square[(i, i)] += limits.lift);
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
            // the second short step: what is held has converged, whatever creeps on
            let short = length <= limits.step * size;
            if short && (near || limits.step == EXACTLY.step) {
                let (r, a) = self.scaled(x, speed)?;
                return (norm(&r) <= limits.residual * size).then(|| a.rows() - rank(a, limits.rank));
            }
            near = short;
        }
        None
    }
}

/// Rank by elimination with full pivoting: pivots above `least` of the largest.
fn rank(mut a: Mat, least: f64) -> usize {
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
        if best <= least * largest {
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
        assert_eq!(rank(full.clone(), 1e-8), 4);
        // the last row is the sum of the first two
        let less = Mat::from_fn(4, 4, |i, j| if i == 3 { full[(0, j)] + full[(1, j)] } else { full[(i, j)] });
        assert_eq!(rank(less, 1e-8), 3);
        assert_eq!(rank(Mat::from_fn(3, 3, |i, j| (i + 1) as f64 * (j + 2) as f64), 1e-8), 1);
        assert_eq!(rank(Mat::zeros(3, 3), 1e-8), 0);
    }
}
