//! Rational approximation: poles by the AAA algorithm, strengths by least squares.
//!
//! Nakatsukasa, Sete, Trefethen, SIAM J. Sci. Comput. 40 (2018) A1494, with weighted errors.

use crate::complex::C64;
use crate::dense::Mat;
use crate::eig::{Number, Pencil};

/// Poles of a rational function with `weight_i |r(x_i) - f_i| <= tolerance`; of one with `most` poles where that is not reached.
pub fn poles(x: &[C64], f: &[C64], weights: &[f64], tolerance: f64, most: usize) -> Option<Vec<C64>> {
    let n = x.len();
    let mean = f.iter().fold(C64::zero(), |s, f| s + *f).scale(1.0 / n as f64);
    let mut now = vec![mean; n];
    let mut taken: Vec<usize> = Vec::new();
    let mut shares: Vec<C64> = Vec::new();
    let error = |i: usize, now: &[C64]| (now[i] - f[i]).abs() * weights[i];
    while taken.len() <= most && taken.len() + 1 < n {
        let worst = (0..n).filter(|i| !taken.contains(i)).max_by(|&i, &j| error(i, &now).total_cmp(&error(j, &now)))?;
        if !error(worst, &now).is_finite() {
            return None;
        }
        if error(worst, &now) <= tolerance {
            break;
        }
        taken.push(worst);
        let rest: Vec<usize> = (0..n).filter(|i| !taken.contains(i)).collect();
        let loewner = Mat::from_fn(rest.len(), taken.len(), |i, j| {
            let (i, j) = (rest[i], taken[j]);
            ((f[i] - f[j]) / (x[i] - x[j])).scale(weights[i])
        });
        // the triangle of an orthogonal factorisation has the singular vectors of the whole
        let svd = C64::svd(&triangle(&loewner)).ok()?;
        shares = (0..taken.len()).map(|j| svd.v[(j, taken.len() - 1)]).collect();
        for &i in &rest {
            let (mut top, mut bottom) = (C64::zero(), C64::zero());
            for (&j, &w) in taken.iter().zip(&shares) {
                let term = w / (x[i] - x[j]);
                top += term * f[j];
                bottom += term;
            }
            now[i] = top / bottom;
        }
        for &j in &taken {
            now[j] = f[j];
        }
    }
    // zeros of the denominator: an arrow pencil with two infinite eigenvalues
    let m = taken.len();
    if m == 0 {
        // a constant will do
        return Some(Vec::new());
    }
    let arrow = Mat::from_fn(m + 1, m + 1, |i, j| match (i, j) {
        (0, 0) => C64::zero(),
        (0, j) => shares[j - 1],
        (_, 0) => C64::one(),
        (i, j) if i == j => x[taken[i - 1]],
        _ => C64::zero(),
    });
    let mass = Mat::from_fn(m + 1, m + 1, |i, j| if i == j && i > 0 { C64::one() } else { C64::zero() });
    let modes = Pencil::new(arrow, mass).modes().ok()?;
    Some(modes.finite.iter().map(|m| m.value).collect())
}

/// R of `A = Q R`, by Gram and Schmidt done twice.
fn triangle(a: &Mat<C64>) -> Mat<C64> {
    let (n, m) = (a.rows(), a.cols());
    let mut q: Vec<Vec<C64>> = Vec::with_capacity(m);
    let mut r = Mat::zeros(m, m);
    for j in 0..m {
        let mut v: Vec<C64> = (0..n).map(|i| a[(i, j)]).collect();
        for _ in 0..2 {
            for (k, q) in q.iter().enumerate() {
                let along = q.iter().zip(&v).fold(C64::zero(), |s, (q, v)| s + q.conj() * *v);
                r[(k, j)] += along;
                v.iter_mut().zip(q).for_each(|(v, q)| *v -= *q * along);
            }
        }
        let size = v.iter().map(|v| v.norm_sqr()).sum::<f64>().sqrt();
        r[(j, j)] = C64::real(size);
        q.push(v.into_iter().map(|v| if size > 0.0 { v.scale(1.0 / size) } else { v }).collect());
    }
    r
}

/// Real least squares by orthogonal columns.
pub fn least_squares(a: &Mat, b: &[f64]) -> Vec<f64> {
    let (n, m) = (a.rows(), a.cols());
    let mut q: Vec<Vec<f64>> = Vec::with_capacity(m);
    let mut r = Mat::zeros(m, m);
    let mut rest = b.to_vec();
    let mut right = vec![0.0; m];
    for j in 0..m {
        let mut v: Vec<f64> = (0..n).map(|i| a[(i, j)]).collect();
        for _ in 0..2 {
            for (k, q) in q.iter().enumerate() {
                let along: f64 = q.iter().zip(&v).map(|(q, v)| q * v).sum();
                r[(k, j)] += along;
                v.iter_mut().zip(q).for_each(|(v, q)| *v -= q * along);
            }
        }
        let size = v.iter().map(|v| v * v).sum::<f64>().sqrt();
        r[(j, j)] = size;
        v.iter_mut().for_each(|v| *v /= size);
        right[j] = v.iter().zip(&rest).map(|(q, b)| q * b).sum();
        rest.iter_mut().zip(&v).for_each(|(b, q)| *b -= q * right[j]);
        q.push(v);
    }
    for j in (0..m).rev() {
        let known: f64 = (j + 1..m).map(|k| r[(j, k)] * right[k]).sum();
        right[j] = (right[j] - known) / r[(j, j)];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::complex::c;

    /// A rational function has its own poles; a root of x near its branch point a ladder of them on one side.
    #[test]
    fn poles_are_found() {
        let x: Vec<C64> = (0..200).map(|i| c(-2.0 + 0.02 * f64::from(i) + 0.003, 0.0)).collect();
        let own = [c(0.3, 0.1), c(-1.1, 0.4), c(0.31, 2.0)];
        let f: Vec<C64> = x.iter().map(|x| own.iter().fold(c(1.0, 0.2), |s, p| s + c(0.7, -0.3) / (*x - *p))).collect();
        let found = poles(&x, &f, &vec![1.0; x.len()], 1e-11, 20).unwrap();
        assert_eq!(found.len(), 3);
        for p in own {
            assert!(found.iter().any(|q| (*q - p).abs() < 1e-8), "{found:?}");
        }
        let x: Vec<C64> = (0..160).flat_map(|i| [1.0, -1.0].map(|s| c(s * 10f64.powf(-6.0 + 6.0 * f64::from(i) / 159.0), 0.0))).collect();
        let f: Vec<C64> = x.iter().map(|x| crate::analytic::sqrt(x.mul_i()) + C64::one()).collect();
        let found = poles(&x, &f, &vec![1.0; x.len()], 1e-6, 40).unwrap();
        assert!(found.len() > 4 && found.iter().all(|p| p.im > 0.0), "{found:?}");
        // where little is requested no poles are spent: 11 of them if the weights chose places but no denominator
        let weights: Vec<f64> = x.iter().map(|x| if x.abs() > 0.1 { 1.0 } else { 1e-9 }).collect();
        assert!(poles(&x, &f, &weights, 1e-7, 40).unwrap().len() <= 9);
        assert!(poles(&x, &f, &vec![1.0; x.len()], 1e-7, 40).unwrap().len() > 20);
    }

    /// What is constant to the tolerance has none.
    #[test]
    fn constants_have_no_poles() {
        let x: Vec<C64> = (0..9).map(|i| c(f64::from(i), 0.0)).collect();
        let f: Vec<C64> = x.iter().map(|x| c(2.0, 1.0) + x.scale(1e-5)).collect();
        assert!(poles(&x, &f, &[1.0; 9], 1e-3, 8).unwrap().is_empty());
    }

    /// The rest stands at right angles to every column.
    #[test]
    fn normal_equations_hold() {
        let a = Mat::from_fn(30, 5, |i, j| ((i * (j + 2)) as f64 * 0.37 + j as f64).sin());
        let b: Vec<f64> = (0..30).map(|i| f64::from(i).cos()).collect();
        let x = least_squares(&a, &b);
        for j in 0..5 {
            let along: f64 = (0..30).map(|i| a[(i, j)] * (b[i] - (0..5).map(|k| a[(i, k)] * x[k]).sum::<f64>())).sum();
            assert!(along.abs() < 1e-12, "{along:e}");
        }
    }
}
