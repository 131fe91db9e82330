//! Diagonal scaling by powers of two: balancing of a matrix, scaling of several matrices that share rows and columns.

use super::number::Number;
use crate::dense::Mat;

/// The power of two nearest to a positive number (in ratio); 1 for 0 and what is not finite.
pub(super) fn power_of_two(x: f64) -> f64 {
    if x > 0.0 && x.is_finite() { x.log2().round().clamp(-500.0, 500.0).exp2() } else { 1.0 }
}

/// Replaces A by D^-1 A D with norms of corresponding rows and columns as close as powers of two allow, and returns the diagonal of D.
/// An eigenvector of A is D times one of the balanced matrix; a left vector, D^-1 times.
pub(super) fn balance<T: Number>(a: &mut Mat<T>) -> Vec<f64> {
    let n = a.rows();
    let mut d = vec![1.0; n];
    // Norms include the diagonal: this stops the harmful balancing of matrices already nearly triangular.
    for _ in 0..40 {
        let mut done = true;
        for i in 0..n {
            let (mut col, mut row) = (0.0, 0.0);
            for j in 0..n {
                col += a[(j, i)].abs2();
                row += a[(i, j)].abs2();
            }
            let (col, row) = (col.sqrt(), row.sqrt());
            if col == 0.0 || row == 0.0 || !col.is_finite() || !row.is_finite() {
                continue;
            }
            let f = power_of_two((row / col).sqrt());
            if col * f + row / f < 0.95 * (col + row) && (1e-150..1e150).contains(&(d[i] * f)) {
                done = false;
                d[i] *= f;
                for j in 0..n {
                    a[(j, i)] = a[(j, i)].times(f);
                }
                for x in a.row_mut(i) {
                    *x = x.times(1.0 / f);
                }
            }
        }
        if done {
            break;
        }
    }
    d
}

/// Row and column factors for matrices of equal shape that are solved together (a pencil, a quadratic polynomial, each already of
/// comparable norm): after `m[i][j] * rows[i] * columns[j]` all rows and columns of the joint squares have norms near one.
pub(super) fn equilibrate<T: Number>(matrices: &[&Mat<T>]) -> (Vec<f64>, Vec<f64>) {
    let n = matrices.first().map_or(0, |m| m.rows());
    let joint = Mat::from_fn(n, n, |i, j| matrices.iter().map(|m| m[(i, j)].abs2()).sum::<f64>());
    let (mut rows, mut cols) = (vec![1.0; n], vec![1.0; n]);
    // The row and column sums of a matrix of squares settle quickly; a pattern without total support never does, hence the fixed count.
    for _ in 0..8 {
        for i in 0..n {
            let s: f64 = (0..n).map(|j| joint[(i, j)] * f64::powi(cols[j], 2)).sum();
            rows[i] = limited(s);
        }
        for j in 0..n {
            let s: f64 = (0..n).map(|i| joint[(i, j)] * f64::powi(rows[i], 2)).sum();
            cols[j] = limited(s);
        }
    }
    (rows.into_iter().map(power_of_two).collect(), cols.into_iter().map(power_of_two).collect())
}

fn limited(s: f64) -> f64 {
    if s > 0.0 && s.is_finite() { s.sqrt().recip().clamp(1e-60, 1e60) } else { 1.0 }
}

/// `m[i][j] * k * rows[i] * columns[j]`.
pub(super) fn scaled<T: Number>(m: &Mat<T>, k: f64, rows: &[f64], cols: &[f64]) -> Mat<T> {
    Mat::from_fn(m.rows(), m.cols(), |i, j| m[(i, j)].times(k * rows[i] * cols[j]))
}
