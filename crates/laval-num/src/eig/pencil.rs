//! `A x = s E x`.

use super::EigError;
use super::balance::{equilibrate, power_of_two, scaled};
use super::deflate::finite_part;
use super::mode::{Mode, sorted};
use super::number::{Number, apply, apply_adjoint, check_finite, frobenius, inner, norm2, qz};
use crate::complex::{C64, c};
use crate::dense::{Lu, Mat};

/// The modes of a problem that may have infinite eigenvalues.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// Modes with finite eigenvalues, ordered as in the module's description.
    pub finite: Vec<Mode>,
    /// Number of infinite eigenvalues: those that a change of the (scaled) leading matrix by rounding errors could move to infinity.
    pub infinite: usize,
}

/// The pencil `A - s E`; E may be singular.
#[derive(Clone, Debug)]
pub struct Pencil<T> {
    a: Mat<T>,
    e: Mat<T>,
}

/// A finite eigenvalue `alpha / beta` of a scaled pencil with vectors not yet normalised.
pub(super) struct Pair {
    pub(super) value: C64,
    pub(super) right: Vec<C64>,
    pub(super) left: Vec<C64>,
}

/// Finite pairs (Im >= 0 only when T is real) and the number of infinite eigenvalues of an already scaled pencil.
pub(super) fn solve<T: Number>(a: Mat<T>, e: Mat<T>) -> Result<(Vec<Pair>, usize), EigError> {
    let part = finite_part(a, e)?;
    let mut infinite = part.infinite;
    if part.a.rows() == 0 {
        return Ok((vec![], infinite));
    }
    let complex = |m: &Mat<T>| Mat::from_fn(m.rows(), m.cols(), |i, j| m[(i, j)].into());
    let raw = qz(&complex(&part.a), &complex(&part.e))?;
    let mut pairs = Vec::with_capacity(raw.alpha.len());
    for (((alpha, beta), right), left) in raw.alpha.into_iter().zip(raw.beta).zip(raw.right).zip(raw.left) {
        let value = alpha / beta;
        if value.is_finite() {
            pairs.push(Pair { value, right, left });
        } else {
            infinite += 1;
        }
    }
    if T::REAL {
        pairs = conjugate_symmetric(pairs);
    }
    separate_clusters(&mut pairs, &complex(&part.a), &complex(&part.e))?;
    for p in &mut pairs {
        p.left = part.left(std::mem::take(&mut p.left), p.value);
        p.right = part.right(std::mem::take(&mut p.right));
    }
    Ok((pairs, infinite))
}

/// Vectors of nearly equal eigenvalues again, by inverse iteration from different starts: the back substitution after QZ divides by the
/// difference of the values, and may return nothing finite, or parallel vectors where independent ones exist.
fn separate_clusters(pairs: &mut [Pair], a: &Mat<C64>, e: &Mat<C64>) -> Result<(), EigError> {
    let values: Vec<C64> = pairs.iter().map(|p| p.value).collect();
    let finite = |v: &[C64]| v.iter().all(|z| z.is_finite()) && norm2(v) > 0.0;
    for (i, p) in pairs.iter_mut().enumerate() {
        let size = values[i].abs().max(1.0);
        let clustered = values.iter().enumerate().any(|(j, v)| j != i && (*v - values[i]).abs() <= 1e-9 * size);
        if !clustered && finite(&p.right) && finite(&p.left) {
            continue;
        }
        // A shift off by some roundings keeps the factors regular and costs no accuracy.
        let s = values[i] + c(3.0, 2.0).scale(f64::EPSILON * size);
        let shifted = Mat::from_fn(a.rows(), a.rows(), |i, j| a[(i, j)] - s * e[(i, j)]);
        let adjoint = Mat::from_fn(a.rows(), a.rows(), |i, j| shifted[(j, i)].conj());
        p.right = inverse_iteration(&shifted, e, i).ok_or(EigError::NoConvergence)?;
        let eh = Mat::from_fn(a.rows(), a.rows(), |i, j| e[(j, i)].conj());
        p.left = inverse_iteration(&adjoint, &eh, i).ok_or(EigError::NoConvergence)?;
    }
    Ok(())
}

fn inverse_iteration(shifted: &Mat<C64>, e: &Mat<C64>, seed: usize) -> Option<Vec<C64>> {
    let lu = Lu::new(shifted).ok()?;
    // Angles of the golden section: starts for different seeds are far from parallel.
    let start = |k: usize| C64::cis(2.399963229728653 * ((k + 1) * (seed + 1) + k * k) as f64);
    let mut x: Vec<C64> = (0..shifted.rows()).map(start).collect();
    for pass in 0..2 {
        if pass > 0 {
            x = apply(e, &x);
        }
        lu.solve(&mut x);
        let n = norm2(&x);
        if !(n > 0.0 && n.is_finite()) {
            return None;
        }
        x.iter_mut().for_each(|z| *z = z.scale(1.0 / n));
    }
    Some(x)
}

/// The members with Im >= 0 of the pairs of a real problem, whose values are conjugate only to rounding: a value is taken as real if its
/// conjugate is nearer to itself than to any other, and as one of a pair with that other if not.
fn conjugate_symmetric(mut pairs: Vec<Pair>) -> Vec<Pair> {
    let mut out = Vec::with_capacity(pairs.len());
    pairs.sort_by(|a, b| a.value.im.abs().total_cmp(&b.value.im.abs()));
    while let Some(mut p) = pairs.pop() {
        let target = p.value.conj();
        let distance = |q: &Pair| (q.value - target).abs();
        let nearest = (0..pairs.len()).min_by(|&i, &j| distance(&pairs[i]).total_cmp(&distance(&pairs[j])));
        match nearest.filter(|&k| distance(&pairs[k]) < 2.0 * p.value.im.abs()) {
            Some(k) => {
                let q = pairs.remove(k);
                let mean = (p.value + q.value.conj()).scale(0.5);
                let (mut upper, value) = if p.value.im > 0.0 { (p, mean) } else { (q, mean.conj()) };
                upper.value = c(value.re, value.im.abs());
                out.push(upper);
            }
            None => {
                p.value = c(p.value.re, 0.0);
                real_if_nearly(&mut p.right);
                real_if_nearly(&mut p.left);
                out.push(p);
            }
        }
    }
    out
}

/// Turns the phase of a vector so that its largest component is real and drops imaginary parts of the size of rounding errors.
/// (At a multiple eigenvalue a vector may be a complex combination, and is left as it is.)
fn real_if_nearly(v: &mut [C64]) {
    let Some(lead) = v.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())) else { return };
    let size = lead.abs();
    if size > 0.0 && size.is_finite() {
        let phase = lead.conj().scale(1.0 / size);
        v.iter_mut().for_each(|z| *z = *z * phase);
        if v.iter().all(|z| z.im.abs() <= 1e-8 * size) {
            v.iter_mut().for_each(|z| z.im = 0.0);
        }
    }
}

impl<T: Number> Pencil<T> {
    /// The pencil `A - s E` of two square matrices of equal size.
    pub fn new(a: Mat<T>, e: Mat<T>) -> Self {
        assert!(a.rows() == a.cols() && e.rows() == a.rows() && e.cols() == a.rows(), "a pencil needs two square matrices of equal size");
        Pencil { a, e }
    }

    /// All modes. Vectors satisfy `A x = s E x` and `y^H A = s y^H E`.
    pub fn modes(&self) -> Result<Modes, EigError> {
        check_finite(&self.a)?;
        check_finite(&self.e)?;
        let (ka, ke) = (power_of_two(frobenius(&self.a)), power_of_two(frobenius(&self.e)));
        let one = vec![1.0; self.a.rows()];
        let (mut a, mut e) = (scaled(&self.a, 1.0 / ka, &one, &one), scaled(&self.e, 1.0 / ke, &one, &one));
        let (rows, cols) = equilibrate(&[&a, &e]);
        (a, e) = (scaled(&a, 1.0, &rows, &cols), scaled(&e, 1.0, &rows, &cols));
        let (na, ne) = (frobenius(&a), frobenius(&e));
        let (pairs, infinite) = solve(a.clone(), e.clone())?;
        let mut modes = Vec::with_capacity(pairs.len());
        for Pair { value: s, mut right, mut left } in pairs {
            let size = na + s.abs() * ne;
            let defect = |pa: Vec<C64>, pe: Vec<C64>, s: C64, v: &[C64]| {
                let r: Vec<C64> = pa.iter().zip(&pe).map(|(&a, &e)| a - s * e).collect();
                norm2(&r) / (size * norm2(v))
            };
            let r = defect(apply(&a, &right), apply(&e, &right), s, &right);
            let l = defect(apply_adjoint(&a, &left), apply_adjoint(&e, &left), s.conj(), &left);
            let scale = ka / ke;
            let product = inner(&left, &apply(&e, &right)).abs();
            let sensitivity = scale * size * (norm2(&right) * norm2(&left) / product);
            right.iter_mut().zip(&cols).for_each(|(x, &k)| *x = x.scale(k));
            left.iter_mut().zip(&rows).for_each(|(y, &k)| *y = y.scale(k));
            let residual = if r >= l || r.is_nan() { r } else { l };
            let mut m = Mode { value: s.scale(scale), right, left, residual, sensitivity };
            m.normalise(|x| apply(&self.e, x));
            modes.push(m);
        }
        Ok(Modes { finite: sorted(modes, T::REAL), infinite })
    }

    /// Derivative of an eigenvalue: `y^H (dA - s dE) x / (y^H E x)`.
    pub fn derivative(&self, mode: &Mode, da: &Mat<T>, de: &Mat<T>) -> C64 {
        let x = &mode.right;
        let (a, e) = (inner(&mode.left, &apply(da, x)), inner(&mode.left, &apply(de, x)));
        (a - mode.value * e) / inner(&mode.left, &apply(&self.e, x))
    }

    /// The mode with `E^H y` for its left vector: right and left vectors of different modes are then orthogonal, as
    /// [`Track`](super::Track) wants them.
    pub fn biorthogonal(&self, mode: &Mode) -> Mode {
        Mode { left: apply_adjoint(&self.e, &mode.left), ..mode.clone() }
    }
}
