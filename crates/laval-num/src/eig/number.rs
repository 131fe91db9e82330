//! The border to faer: decompositions of real and complex matrices, in and out of this crate's types.

use super::{EigError, small};
use crate::complex::{C64, c};
use crate::dense::{Field, Mat};
use crate::lanes::cleared;
use crate::work::spend;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::evd::{self, ComputeEigenvectors};
use faer::linalg::matmul::matmul;
use faer::linalg::{gevd, svd};
use faer::traits::{ComplexField, Conjugate};
use faer::{Accum, MatRef, Par, Spec, c64};

type Vectors = Vec<Vec<C64>>;

/// Eigenvalues `alpha/beta` with right and left vectors, as the iteration leaves them. [`Number::evd`] of a real matrix gives only the members with Im >= 0.
pub struct Raw {
    pub(super) alpha: Vec<C64>,
    pub(super) beta: Vec<C64>,
    pub(super) right: Vectors,
    pub(super) left: Vectors,
    /// `A x` of the right and `A^H y` of the left vectors; empty for a pencil.
    pub(super) images: [Vectors; 2],
}

/// `A = U diag(s) V^H` of an r x c matrix: U is r x r, V is c x c.
pub struct Svd<T> {
    /// U.
    pub u: Mat<T>,
    /// Singular values, descending.
    pub s: Vec<f64>,
    /// V.
    pub v: Mat<T>,
}

/// An entry of an eigenvalue problem: `f64` or [`C64`].
pub trait Number: Field + Into<C64> {
    /// Eigenvalues come in conjugate pairs.
    const REAL: bool;
    /// Complex conjugate.
    fn conj(self) -> Self;
    /// Multiplication by a real number.
    fn times(self, k: f64) -> Self;
    /// `|x|^2`.
    fn abs2(self) -> f64;
    /// Product with a complex number.
    fn act(self, z: C64) -> C64;
    #[doc(hidden)]
    fn values(a: &Mat<Self>) -> Result<Vec<C64>, EigError>;
    /// Eigenvalues of a Hessenberg matrix.
    #[doc(hidden)]
    fn of_hessenberg(a: &Mat<Self>) -> Result<Vec<C64>, EigError> {
        Self::values(a)
    }
    #[doc(hidden)]
    fn evd(a: &Mat<Self>) -> Result<Raw, EigError>;
    #[doc(hidden)]
    fn svd(a: &Mat<Self>) -> Result<Svd<Self>, EigError>;
}

impl From<f64> for C64 {
    fn from(x: f64) -> C64 {
        c(x, 0.0)
    }
}

fn is_finite<T: Number>(a: &Mat<T>) -> bool {
    a.max_size().is_finite()
}

fn out(z: c64) -> C64 {
    c(z.re, z.im)
}

/// Counts a decomposition that takes about `factor n^3` products.
fn decompose<T>(factor: usize, n: usize) {
    let reals = size_of::<T>() / size_of::<f64>();
    spend((factor * n * n * n * reals * reals) as u64);
}

/// Largest Hessenberg matrix that the compact QR iteration is used for.
const COMPACT: usize = 64;

const YES: ComputeEigenvectors = ComputeEigenvectors::Yes;
const NO: ComputeEigenvectors = ComputeEigenvectors::No;

/// Work space of the QZ algorithm. The library's own figure leaves out the back substitution, which takes some vectors more.
fn qz_scratch<F: ComplexField>(n: usize) -> StackReq {
    gevd::gevd_scratch::<F>(n, YES, YES, Par::Seq, Spec::default()).and(StackReq::new_aligned::<F>(16 * n + 512, 64))
}

/// Columns of a real pair matrix at the eigenvalue of column j: re + i im, or re alone.
fn real_column(u: &faer::Mat<f64>, j: usize, pair: bool) -> Vec<C64> {
    (0..u.nrows()).map(|i| c(u[(i, j)], if pair { u[(i, j + 1)] } else { 0.0 })).collect()
}

fn real_raw(re: &[f64], im: &[f64], [right, left]: [&faer::Mat<f64>; 2], images: [&faer::Mat<f64>; 2]) -> Raw {
    let mut raw = Raw { alpha: vec![], beta: vec![], right: vec![], left: vec![], images: [vec![], vec![]] };
    let mut j = 0;
    while j < re.len() {
        let pair = im[j] != 0.0 && j + 1 < re.len();
        let column = |m: &faer::Mat<f64>| {
            let mut v = real_column(m, j, pair);
            if im[j] < 0.0 {
                v.iter_mut().for_each(|z| *z = C64::conj(*z));
            }
            v
        };
        raw.alpha.push(c(re[j], im[j].abs()));
        raw.beta.push(C64::ONE);
        raw.right.push(column(right));
        raw.left.push(column(left));
        raw.images.iter_mut().zip(images).for_each(|(all, image)| all.push(column(image)));
        j += if pair { 2 } else { 1 };
    }
    raw
}

/// `a v`.
fn product<F: ComplexField, A: Conjugate<Canonical = F>>(a: MatRef<A>, v: &faer::Mat<F>) -> faer::Mat<F> {
    let mut out = faer::Mat::zeros(a.nrows(), v.ncols());
    cleared(|| matmul(out.as_mut(), Accum::Replace, a, v.as_ref(), F::one_impl(), Par::Seq));
    out
}

fn column(u: &faer::Mat<c64>, j: usize) -> Vec<C64> {
    (0..u.nrows()).map(|i| out(u[(i, j)])).collect()
}

fn svd_with<T: Number, F: ComplexField>(
    a: &Mat<T>,
    into: impl Fn(T) -> F,
    back: impl Fn(&F) -> T,
    real: impl Fn(&F) -> f64,
) -> Result<Svd<T>, EigError> {
    if !is_finite(a) {
        return Err(EigError::NotFinite);
    }
    let (r, k) = (a.rows(), a.cols());
    decompose::<T>(30, r.max(k));
    let f = faer::Mat::from_fn(r, k, |i, j| into(a[(i, j)]));
    let (mut u, mut v) = (faer::Mat::zeros(r, r), faer::Mat::zeros(k, k));
    let mut s = faer::diag::Diag::zeros(r.min(k));
    let all = svd::ComputeSvdVectors::Full;
    let mut buffer = MemBuffer::new(svd::svd_scratch::<F>(r, k, all, all, Par::Seq, Spec::default()));
    cleared(|| svd::svd(f.as_ref(), s.as_mut(), Some(u.as_mut()), Some(v.as_mut()), Par::Seq, MemStack::new(&mut buffer), Spec::default()))
        .map_err(|_| EigError::NoConvergence)?;
    Ok(Svd {
        u: Mat::from_fn(r, r, |i, j| back(&u[(i, j)])),
        s: (0..r.min(k)).map(|i| real(&s[i])).collect(),
        v: Mat::from_fn(k, k, |i, j| back(&v[(i, j)])),
    })
}

/// Eigenvalues of a real symmetric matrix, ascending, and orthonormal vectors as columns.
pub(super) fn symmetric(a: &Mat) -> Result<(Vec<f64>, Mat), EigError> {
    if !is_finite(a) {
        return Err(EigError::NotFinite);
    }
    let n = a.rows();
    decompose::<f64>(15, n);
    let f = faer::Mat::from_fn(n, n, |i, j| a[(i, j)]);
    let (mut s, mut u) = (faer::diag::Diag::zeros(n), faer::Mat::zeros(n, n));
    let mut buffer = MemBuffer::new(evd::self_adjoint_evd_scratch::<f64>(n, YES, Par::Seq, Spec::default()));
    cleared(|| evd::self_adjoint_evd(f.as_ref(), s.as_mut(), Some(u.as_mut()), Par::Seq, MemStack::new(&mut buffer), Spec::default()))
        .map_err(|_| EigError::NoConvergence)?;
    Ok(((0..n).map(|i| s[i]).collect(), Mat::from_fn(n, n, |i, j| u[(i, j)])))
}

impl Number for f64 {
    const REAL: bool = true;
    fn conj(self) -> f64 {
        self
    }
    fn times(self, k: f64) -> f64 {
        self * k
    }
    fn abs2(self) -> f64 {
        self * self
    }
    #[inline(always)]
    fn act(self, z: C64) -> C64 {
        z.scale(self)
    }
    fn values(a: &Mat) -> Result<Vec<C64>, EigError> {
        if !is_finite(a) {
            return Err(EigError::NotFinite);
        }
        let n = a.rows();
        decompose::<Self>(30, n);
        let f = faer::Mat::from_fn(n, n, |i, j| a[(i, j)]);
        let (mut re, mut im) = (faer::diag::Diag::zeros(n), faer::diag::Diag::zeros(n));
        let mut buffer = MemBuffer::new(evd::evd_scratch::<f64>(n, NO, NO, Par::Seq, Spec::default()));
        cleared(|| evd::evd_real(f.as_ref(), re.as_mut(), im.as_mut(), None, None, Par::Seq, MemStack::new(&mut buffer), Spec::default()))
            .map_err(|_| EigError::NoConvergence)?;
        Ok((0..n).map(|i| c(re[i], im[i])).collect())
    }
    fn of_hessenberg(a: &Mat) -> Result<Vec<C64>, EigError> {
        let (n, mut values) = (a.rows(), Vec::new());
        let done = n <= COMPACT && is_finite(a) && small::eigenvalues(a.clone().data_mut(), n, &mut values).is_ok();
        if done && values.iter().all(|z| z.is_finite()) { Ok(values) } else { Self::values(a) }
    }
    fn evd(a: &Mat) -> Result<Raw, EigError> {
        if !is_finite(a) {
            return Err(EigError::NotFinite);
        }
        let n = a.rows();
        decompose::<Self>(30, n);
        let f = faer::Mat::from_fn(n, n, |i, j| a[(i, j)]);
        let (mut re, mut im) = (faer::diag::Diag::zeros(n), faer::diag::Diag::zeros(n));
        let (mut l, mut r) = (faer::Mat::zeros(n, n), faer::Mat::zeros(n, n));
        let mut buffer = MemBuffer::new(evd::evd_scratch::<f64>(n, YES, YES, Par::Seq, Spec::default()));
        cleared(|| {
            evd::evd_real(
                f.as_ref(),
                re.as_mut(),
                im.as_mut(),
                Some(l.as_mut()),
                Some(r.as_mut()),
                Par::Seq,
                MemStack::new(&mut buffer),
                Spec::default(),
            )
        })
        .map_err(|_| EigError::NoConvergence)?;
        let (re, im): (Vec<f64>, Vec<f64>) = (0..n).map(|i| (re[i], im[i])).unzip();
        let (ar, al) = (product(f.as_ref(), &r), product(f.transpose(), &l));
        Ok(real_raw(&re, &im, [&r, &l], [&ar, &al]))
    }
    fn svd(a: &Mat) -> Result<Svd<f64>, EigError> {
        svd_with(a, |x| x, |x: &f64| *x, |x| *x)
    }
}

impl Number for C64 {
    const REAL: bool = false;
    fn conj(self) -> C64 {
        C64::conj(self)
    }
    fn times(self, k: f64) -> C64 {
        self.scale(k)
    }
    fn abs2(self) -> f64 {
        self.norm_sqr()
    }
    #[inline(always)]
    fn act(self, z: C64) -> C64 {
        self * z
    }
    fn values(a: &Mat<C64>) -> Result<Vec<C64>, EigError> {
        if !is_finite(a) {
            return Err(EigError::NotFinite);
        }
        let n = a.rows();
        decompose::<Self>(30, n);
        let f = faer::Mat::from_fn(n, n, |i, j| c64::new(a[(i, j)].re, a[(i, j)].im));
        let mut s = faer::diag::Diag::zeros(n);
        let mut buffer = MemBuffer::new(evd::evd_scratch::<c64>(n, NO, NO, Par::Seq, Spec::default()));
        cleared(|| evd::evd_cplx(f.as_ref(), s.as_mut(), None, None, Par::Seq, MemStack::new(&mut buffer), Spec::default()))
            .map_err(|_| EigError::NoConvergence)?;
        Ok((0..n).map(|i| out(s[i])).collect())
    }
    fn evd(a: &Mat<C64>) -> Result<Raw, EigError> {
        if !is_finite(a) {
            return Err(EigError::NotFinite);
        }
        let n = a.rows();
        decompose::<Self>(30, n);
        let f = faer::Mat::from_fn(n, n, |i, j| c64::new(a[(i, j)].re, a[(i, j)].im));
        let mut s = faer::diag::Diag::zeros(n);
        let (mut l, mut r) = (faer::Mat::zeros(n, n), faer::Mat::zeros(n, n));
        let mut buffer = MemBuffer::new(evd::evd_scratch::<c64>(n, YES, YES, Par::Seq, Spec::default()));
        cleared(|| {
            evd::evd_cplx(f.as_ref(), s.as_mut(), Some(l.as_mut()), Some(r.as_mut()), Par::Seq, MemStack::new(&mut buffer), Spec::default())
        })
        .map_err(|_| EigError::NoConvergence)?;
        let (ar, al) = (product(f.as_ref(), &r), product(f.adjoint(), &l));
        let columns = |m: &faer::Mat<c64>| (0..n).map(|j| column(m, j)).collect::<Vectors>();
        Ok(Raw {
            alpha: (0..n).map(|i| out(s[i])).collect(),
            beta: vec![C64::ONE; n],
            right: columns(&r),
            left: columns(&l),
            images: [columns(&ar), columns(&al)],
        })
    }
    fn svd(a: &Mat<C64>) -> Result<Svd<C64>, EigError> {
        svd_with(a, |z| c64::new(z.re, z.im), |z: &c64| out(*z), |z| z.re)
    }
}

/// QZ algorithm. Complex also for real pencils: the library's real back substitution gives wrong left vectors for complex pairs.
pub(super) fn qz(a: &Mat<C64>, e: &Mat<C64>) -> Result<Raw, EigError> {
    if !is_finite(a) || !is_finite(e) {
        return Err(EigError::NotFinite);
    }
    let n = a.rows();
    decompose::<C64>(80, n);
    let into = |m: &Mat<C64>| faer::Mat::from_fn(n, n, |i, j| c64::new(m[(i, j)].re, m[(i, j)].im));
    let (mut fa, mut fe) = (into(a), into(e));
    let (mut alpha, mut beta) = (faer::diag::Diag::<c64>::zeros(n), faer::diag::Diag::<c64>::zeros(n));
    let (mut l, mut r) = (faer::Mat::zeros(n, n), faer::Mat::zeros(n, n));
    let mut buffer = MemBuffer::new(qz_scratch::<c64>(n));
    cleared(|| {
        gevd::gevd_cplx(
            fa.as_mut(),
            fe.as_mut(),
            alpha.as_mut(),
            beta.as_mut(),
            Some(l.as_mut()),
            Some(r.as_mut()),
            Par::Seq,
            MemStack::new(&mut buffer),
            Spec::default(),
        )
    })
    .map_err(|_| EigError::NoConvergence)?;
    Ok(Raw {
        alpha: (0..n).map(|i| out(alpha[i])).collect(),
        beta: (0..n).map(|i| out(beta[i])).collect(),
        right: (0..n).map(|j| column(&r, j)).collect(),
        left: (0..n).map(|j| column(&l, j)).collect(),
        images: [vec![], vec![]],
    })
}

/// `m x`; most of a large machine's matrix is empty.
pub(super) fn apply<T: Number>(m: &Mat<T>, x: &[C64]) -> Vec<C64> {
    (0..m.rows()).map(|i| m.row(i).iter().zip(x).filter(|(a, _)| **a != T::ZERO).fold(C64::ZERO, |s, (&a, &x)| s + a.act(x))).collect()
}

/// `m^H y`.
pub(super) fn apply_adjoint<T: Number>(m: &Mat<T>, y: &[C64]) -> Vec<C64> {
    let mut out = vec![C64::ZERO; m.cols()];
    for (i, &y) in y.iter().enumerate() {
        for (o, &a) in out.iter_mut().zip(m.row(i)).filter(|(_, a)| **a != T::ZERO) {
            *o += a.conj().act(y);
        }
    }
    out
}

/// `y^H x` of every y with every x.
pub(super) fn overlaps(left: &[Vec<C64>], right: &[Vec<C64>]) -> Mat<C64> {
    let length = left.iter().chain(right).map(Vec::len).max().unwrap_or(0);
    let columns = |all: &[Vec<C64>]| {
        let entry = |i: usize, j: usize| all[j].get(i).map_or(c64::new(0.0, 0.0), |z| c64::new(z.re, z.im));
        faer::Mat::from_fn(length, all.len(), entry)
    };
    let found = product(columns(left).adjoint(), &columns(right));
    Mat::from_fn(left.len(), right.len(), |i, j| out(found[(i, j)]))
}

/// `y^H x`.
pub(super) fn inner(y: &[C64], x: &[C64]) -> C64 {
    y.iter().zip(x).fold(C64::ZERO, |s, (y, &x)| s + C64::conj(*y) * x)
}

/// Euclidean norm.
pub(super) fn norm2(x: &[C64]) -> f64 {
    let sum: f64 = x.iter().map(|z| z.norm_sqr()).sum();
    // no square was lost or is infinite; NaN goes on
    if (1e-250..1e300).contains(&sum) {
        return sum.sqrt();
    }
    let m = x.iter().fold(0.0, |m: f64, z| if z.size() > m || z.size().is_nan() { z.size() } else { m });
    if m == 0.0 || !m.is_finite() { m } else { m * x.iter().map(|z| z.scale(1.0 / m).norm_sqr()).sum::<f64>().sqrt() }
}

/// Frobenius norm.
pub(super) fn frobenius<T: Number>(a: &Mat<T>) -> f64 {
    let m = a.max_size();
    if m == 0.0 || !m.is_finite() { m } else { m * a.data().iter().map(|z| z.times(1.0 / m).abs2()).sum::<f64>().sqrt() }
}

/// Rejects what no decomposition can work on.
pub(super) fn check_finite<T: Number>(a: &Mat<T>) -> Result<(), EigError> {
    if is_finite(a) { Ok(()) } else { Err(EigError::NotFinite) }
}
