//! `A x = s x`.

use super::balance::balance;
use super::mode::{Mode, order, sorted};
use super::number::{Number, apply, check_finite, frobenius, inner, norm2};
use super::{EigError, small};
use crate::complex::C64;
use crate::dense::Mat;

/// Largest real matrix the compact QR iteration is used for: up to here it takes about half the time of the general library.
const SMALL: usize = 32;

/// Eigenvalues of many real matrices, keeping its allocations. Small matrices take a path without set-up cost.
#[derive(Clone, Debug, Default)]
pub struct Spectrum {
    work: Mat,
    values: Vec<C64>,
}

impl Spectrum {
    /// Eigenvalues of a square matrix, ordered as in the module's description.
    pub fn of(&mut self, a: &Mat) -> Result<&[C64], EigError> {
        assert_eq!(a.rows(), a.cols(), "only a square matrix has eigenvalues");
        check_finite(a)?;
        self.work.copy_from(a);
        balance(&mut self.work);
        let n = a.rows();
        let done = n <= SMALL && small::eigenvalues(self.work.data_mut(), n, &mut self.values).is_ok() && all_finite(&self.values);
        if !done {
            self.work.copy_from(a);
            balance(&mut self.work);
            self.values = f64::values(&self.work)?;
        }
        if !all_finite(&self.values) {
            return Err(EigError::NoConvergence);
        }
        sort_pairs(&mut self.values);
        Ok(&self.values)
    }
}

/// Entries of extreme size can overflow on the way.
fn all_finite(values: &[C64]) -> bool {
    values.iter().all(|z| z.re.is_finite() && z.im.is_finite())
}

/// Sorts eigenvalues of a real matrix, all finite, and keeps each conjugate pair together when several share frequency and growth.
fn sort_pairs(values: &mut [C64]) {
    values.sort_unstable_by(order);
    let mut i = 0;
    while i < values.len() {
        let v = values[i];
        let run = values[i..].iter().take_while(|w| w.im.abs() == v.im.abs() && w.re == v.re).count();
        if v.im != 0.0 {
            for (k, w) in values[i..i + run].iter_mut().enumerate() {
                w.im = if k % 2 == 0 { v.im.abs() } else { -v.im.abs() };
            }
        }
        i += run;
    }
}

/// Eigenvalues of a square matrix, ordered as in the module's description.
pub fn eigenvalues<T: Number>(a: &Mat<T>) -> Result<Vec<C64>, EigError> {
    assert_eq!(a.rows(), a.cols(), "only a square matrix has eigenvalues");
    if T::REAL {
        let real = Mat::from_fn(a.rows(), a.cols(), |i, j| a[(i, j)].into().re);
        let mut s = Spectrum::default();
        s.of(&real)?;
        return Ok(s.values);
    }
    check_finite(a)?;
    let mut b = a.clone();
    balance(&mut b);
    let mut values = T::values(&b)?;
    if !all_finite(&values) {
        return Err(EigError::NoConvergence);
    }
    values.sort_by(order);
    Ok(values)
}

/// All modes of a square matrix; also those of the first-order system `x' = A x`.
pub fn modes<T: Number>(a: &Mat<T>) -> Result<Vec<Mode>, EigError> {
    assert_eq!(a.rows(), a.cols(), "only a square matrix has eigenvalues");
    check_finite(a)?;
    if a.rows() == 0 {
        return Ok(vec![]);
    }
    let mut b = a.clone();
    let d = balance(&mut b);
    let raw = T::evd(&b)?;
    if !all_finite(&raw.alpha) {
        return Err(EigError::NoConvergence);
    }
    let size = frobenius(&b);
    let mut out = Vec::with_capacity(raw.alpha.len());
    let [of_right, of_left] = raw.images;
    let vectors = raw.right.into_iter().zip(of_right).zip(raw.left.into_iter().zip(of_left));
    for (value, ((mut right, ax), (mut left, ay))) in raw.alpha.into_iter().zip(vectors) {
        let backward = |image: Vec<C64>, v: &[C64], s: C64| {
            let r: Vec<C64> = image.iter().zip(v).map(|(&i, &v)| i - s * v).collect();
            if size == 0.0 { norm2(&r) / norm2(v) } else { norm2(&r) / (size * norm2(v)) }
        };
        let (r, l) = (backward(ax, &right, value), backward(ay, &left, value.conj()));
        let sensitivity = size * (norm2(&right) * norm2(&left) / inner(&left, &right).abs());
        for ((x, y), &d) in right.iter_mut().zip(&mut left).zip(&d) {
            (*x, *y) = (x.scale(d), y.scale(1.0 / d));
        }
        let residual = if r >= l || r.is_nan() { r } else { l };
        let mut m = Mode { value, right, left, residual, sensitivity };
        m.normalise(|x| x.to_vec());
        out.push(m);
    }
    Ok(sorted(out, T::REAL))
}

/// Derivative of an eigenvalue of A in the direction dA: `y^H dA x / (y^H x)`.
pub fn derivative<T: Number>(mode: &Mode, da: &Mat<T>) -> C64 {
    inner(&mode.left, &apply(da, &mode.right)) / inner(&mode.left, &mode.right)
}
