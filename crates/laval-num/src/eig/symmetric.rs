//! Symmetric pencils `A x = s E x` with E positive definite.

use super::EigError;
use super::number::{check_finite, symmetric};
use crate::dense::Mat;

/// Eigenvalues, real and ascending, and vectors as columns with `X^T E X = 1`, of real symmetric A and E of which the lower triangles are read.
///
/// # Errors
/// [`EigError::SingularPencil`] where E is not positive definite to rounding.
pub fn definite(a: &Mat, e: &Mat) -> Result<(Vec<f64>, Mat), EigError> {
    check_finite(a)?;
    check_finite(e)?;
    let n = a.rows();
    // E = L L^T
    let mut l = Mat::zeros(n, n);
    for i in 0..n {
        for j in 0..=i {
            let rest = e[(i, j)] - (0..j).map(|k| l[(i, k)] * l[(j, k)]).sum::<f64>();
            if i == j {
                if !(rest > 4.0 * f64::EPSILON * e[(i, i)]) {
                    return Err(EigError::SingularPencil);
                }
                l[(i, i)] = rest.sqrt();
            } else {
                l[(i, j)] = rest / l[(j, j)];
            }
        }
    }
    // L^-1 A L^-T, from both sides by the same substitution
    let forward = |m: &Mat| {
        let mut out = m.clone();
        for i in 0..n {
            for j in 0..n {
                let known: f64 = (0..i).map(|k| l[(i, k)] * out[(k, j)]).sum();
                out[(i, j)] = (out[(i, j)] - known) / l[(i, i)];
            }
        }
        out
    };
    let whole = Mat::from_fn(n, n, |i, j| if i < j { a[(j, i)] } else { a[(i, j)] });
    let (values, mut x) = symmetric(&forward(&forward(&whole).transpose()))?;
    for i in (0..n).rev() {
        for j in 0..n {
            let known: f64 = (i + 1..n).map(|k| l[(k, i)] * x[(k, j)]).sum();
            x[(i, j)] = (x[(i, j)] - known) / l[(i, i)];
        }
    }
    Ok((values, x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Vectors diagonalise both matrices; the sum of the eigenvalues is the trace of `E^-1 A`.
    #[test]
    fn both_matrices_become_diagonal() {
        let n = 9;
        let entry = |i: usize, j: usize| ((3 * i + 7 * j + i * j) as f64).sin();
        let a = Mat::from_fn(n, n, |i, j| entry(i, j) + entry(j, i));
        let root = Mat::from_fn(n, n, |i, j| entry(i + 2, 3 * j) + if i == j { 3.0 } else { 0.0 });
        let e = root.transpose().matmul(&root);
        let (values, x) = definite(&a, &e).unwrap();
        assert!(values.windows(2).all(|w| w[0] <= w[1]));
        let (ones, diagonal) = (x.transpose().matmul(&e).matmul(&x), x.transpose().matmul(&a).matmul(&x));
        for i in 0..n {
            for j in 0..n {
                let (one, value) = if i == j { (1.0, values[i]) } else { (0.0, 0.0) };
                assert!((ones[(i, j)] - one).abs() < 1e-12 && (diagonal[(i, j)] - value).abs() < 1e-12, "{i} {j}");
            }
        }
        assert_eq!(definite(&a, &Mat::from_fn(n, n, |i, j| f64::from(i == j) - f64::from(i == 4))), Err(EigError::SingularPencil));
        assert_eq!(definite(&Mat::from_fn(2, 2, |_, _| f64::NAN), &Mat::identity(2)), Err(EigError::NotFinite));
    }
}
