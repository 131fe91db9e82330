//! `(s^2 M + s C + K) x = 0`.

use super::EigError;
use super::balance::{equilibrate, power_of_two, scaled};
use super::mode::{Mode, sorted};
use super::number::{Number, apply, apply_adjoint, check_finite, frobenius, inner, norm2};
use super::pencil::{Modes, Pair, solve};
use crate::complex::{C64, c};
use crate::dense::{Field, Lu, Mat};

/// The quadratic matrix polynomial `P(s) = s^2 M + s C + K`; M may be singular.
///
/// Solved by scaling (s = g mu with g^2 = |K|/|M| after H.-Y. Fan, W.-W. Lin, P. Van Dooren, SIAM J. Matrix Anal. Appl. 26 (2004) 252,
/// and rows and columns by powers of two), companion linearisation, removal of the infinite eigenvalues and the QZ algorithm.
#[derive(Clone, Debug)]
pub struct Quadratic<T> {
    m: Mat<T>,
    c: Mat<T>,
    scaled: Scaled<T>,
}

/// The polynomial in mu = s/g with rows and columns scaled.
#[derive(Clone, Debug)]
struct Scaled<T> {
    m: Mat<T>,
    c: Mat<T>,
    k: Mat<T>,
    g: f64,
    rows: Vec<f64>,
    cols: Vec<f64>,
    norms: [f64; 3],
}

impl<T: Number> Scaled<T> {
    fn new(m: &Mat<T>, d: &Mat<T>, k: &Mat<T>) -> Self {
        let once = |rows: &[f64], cols: &[f64]| {
            let f = |x: &Mat<T>| frobenius(&scaled(x, 1.0, rows, cols));
            let (nm, nc, nk) = (f(m), f(d), f(k));
            let g = match (nm > 0.0, nc > 0.0, nk > 0.0) {
                (true, _, true) => (nk / nm).sqrt(),
                (true, true, false) => nc / nm,
                (false, true, true) => nk / nc,
                _ => 1.0,
            };
            let g = power_of_two(g);
            let size = nk + g * nc;
            let size = power_of_two(if size > 0.0 { size } else { g * g * nm });
            (g, size)
        };
        let n = m.rows();
        let (mut rows, mut cols) = (vec![1.0; n], vec![1.0; n]);
        let (mut g, mut size) = once(&rows, &cols);
        // The frequency scale shifts when rows and columns of different units are brought together; twice settles it.
        for _ in 0..2 {
            let [a, b, e] = [(m, g * g), (d, g), (k, 1.0)].map(|(x, f)| scaled(x, f / size, &rows, &cols));
            let (r, co) = equilibrate(&[&a, &b, &e]);
            rows.iter_mut().zip(r).for_each(|(x, r)| *x *= r);
            cols.iter_mut().zip(co).for_each(|(x, r)| *x *= r);
            (g, size) = once(&rows, &cols);
        }
        let [m, c, k] = [(m, g * g), (d, g), (k, 1.0)].map(|(x, f)| scaled(x, f / size, &rows, &cols));
        let norms = [frobenius(&m), frobenius(&c), frobenius(&k)];
        Scaled { m, c, k, g, rows, cols, norms }
    }

    /// |mu|^2 |M| + |mu| |C| + |K|.
    fn size(&self, mu: C64) -> f64 {
        let a = mu.abs();
        a * a * self.norms[0] + a * self.norms[1] + self.norms[2]
    }

    /// [P(mu), P'(mu) x; x^H, 0]: regular at a simple eigenvalue.
    fn bordered(&self, mu: C64, x: &[C64]) -> Mat<C64> {
        let (n, mu2) = (x.len(), mu * mu);
        let dx = slope(mu, &self.m, &self.c, x);
        Mat::from_fn(n + 1, n + 1, |i, j| match (i < n, j < n) {
            (true, true) => mu2 * self.m[(i, j)].into() + mu * self.c[(i, j)].into() + self.k[(i, j)].into(),
            (true, false) => dx[i],
            (false, true) => x[j].conj(),
            _ => C64::ZERO,
        })
    }

    fn residual(&self, p: &Pair) -> f64 {
        let (mu, n) = (p.value, self.size(p.value));
        let r = norm2(&value(mu, &self.m, &self.c, &self.k, &p.right)) / (n * norm2(&p.right));
        let sum = |mu: C64, m: Vec<C64>, d: Vec<C64>, k: Vec<C64>| -> Vec<C64> {
            m.iter().zip(&d).zip(&k).map(|((&m, &d), &k)| mu * (mu * m + d) + k).collect()
        };
        let y = &p.left;
        let l = sum(mu.conj(), apply_adjoint(&self.m, y), apply_adjoint(&self.c, y), apply_adjoint(&self.k, y));
        let l = norm2(&l) / (n * norm2(y));
        if r >= l || r.is_nan() { r } else { l }
    }

    fn slope(&self, p: &Pair) -> C64 {
        inner(&p.left, &slope(p.value, &self.m, &self.c, &p.right))
    }
}

/// `P(s) x`.
fn value<T: Number>(s: C64, m: &Mat<T>, d: &Mat<T>, k: &Mat<T>, x: &[C64]) -> Vec<C64> {
    let (m, d, k) = (apply(m, x), apply(d, x), apply(k, x));
    m.iter().zip(&d).zip(&k).map(|((&m, &d), &k)| s * (s * m + d) + k).collect()
}

/// `P'(s) x = (2 s M + C) x`.
fn slope<T: Number>(s: C64, m: &Mat<T>, d: &Mat<T>, x: &[C64]) -> Vec<C64> {
    apply(m, x).iter().zip(&apply(d, x)).map(|(&m, &d)| (s * m).scale(2.0) + d).collect()
}

impl<T: Number> Quadratic<T> {
    /// The polynomial of three square matrices of equal size (n x n).
    pub fn new(m: Mat<T>, c: Mat<T>, k: Mat<T>) -> Result<Self, EigError> {
        let n = m.rows();
        assert!([&m, &c, &k].iter().all(|x| x.rows() == n && x.cols() == n), "M, C and K must be square and of equal size");
        for x in [&m, &c, &k] {
            check_finite(x)?;
        }
        let scaled = Scaled::new(&m, &c, &k);
        Ok(Quadratic { m, c, scaled })
    }

    /// All 2n modes, finite and infinite.
    pub fn modes(&self) -> Result<Modes, EigError> {
        let q = &self.scaled;
        let n = q.m.rows();
        let a = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) => -q.c[(i, j)],
            (true, false) => -q.k[(i, j - n)],
            (false, true) if i - n == j => T::ONE,
            _ => T::ZERO,
        });
        let e = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) => q.m[(i, j)],
            (false, false) if i == j => T::ONE,
            _ => T::ZERO,
        });
        let (pairs, infinite) = solve(a, e)?;
        let modes = pairs
            .into_iter()
            .map(|mut p| {
                // The companion vector is (mu x, x), its left vector (y, ..): the larger copy of x is the accurate one.
                let x = p.right.split_off(n);
                if norm2(&x) >= norm2(&p.right) {
                    p.right = x;
                }
                p.left.truncate(n);
                self.mode(p)
            })
            .collect();
        Ok(Modes { finite: sorted(modes, T::REAL), infinite })
    }

    /// A mode in the given coordinates from a pair in the scaled ones.
    fn mode(&self, mut p: Pair) -> Mode {
        let q = &self.scaled;
        let residual = q.residual(&p);
        let sensitivity = q.g * q.size(p.value) * (norm2(&p.right) * norm2(&p.left) / q.slope(&p).abs());
        p.right.iter_mut().zip(&q.cols).for_each(|(x, &k)| *x = x.scale(k));
        p.left.iter_mut().zip(&q.rows).for_each(|(y, &k)| *y = y.scale(k));
        let value = p.value.scale(q.g);
        let mut m = Mode { value, right: p.right, left: p.left, residual, sensitivity };
        m.normalise(|x| slope(value, &self.m, &self.c, x));
        m
    }

    /// Newton's method on the pair (and on the left vector); the start is kept if it is not improved. Two or three steps bring a
    /// simple eigenvalue to the accuracy its sensitivity allows.
    pub fn refine(&self, mode: &Mode) -> Mode {
        let q = &self.scaled;
        let undo = |v: &[C64], k: &[f64]| -> Vec<C64> {
            let w: Vec<C64> = v.iter().zip(k).map(|(z, &k)| z.scale(1.0 / k)).collect();
            let n = norm2(&w);
            w.iter().map(|z| z.scale(1.0 / n)).collect()
        };
        let start = Pair { value: mode.value.scale(1.0 / q.g), right: undo(&mode.right, &q.cols), left: undo(&mode.left, &q.rows) };
        let (mut best, mut p) = (None, start);
        let mut least = q.residual(&p);
        for _ in 0..6 {
            let Some(next) = self.newton(&p) else { break };
            let r = q.residual(&next);
            // At rounding level the residual no longer tells which pair is better; the value still gains.
            if r.is_nan() || (r > least && r > 8.0 * f64::EPSILON) {
                break;
            }
            let moved = (next.value - p.value).abs();
            let done = moved <= f64::EPSILON * next.value.abs();
            least = r;
            best = Some(Pair { value: next.value, right: next.right.clone(), left: next.left.clone() });
            p = next;
            if done {
                break;
            }
        }
        best.map_or_else(|| mode.clone(), |p| self.mode(p))
    }

    /// One Newton step on `P(mu) x = 0, x0^H x = 1`, and the left vector at the new value.
    fn newton(&self, p: &Pair) -> Option<Pair> {
        let q = &self.scaled;
        let n = q.m.rows();
        let mu = p.value;
        let mut step: Vec<C64> = value(mu, &q.m, &q.c, &q.k, &p.right).iter().map(|&r| -r).collect();
        step.push(C64::ZERO);
        Lu::new(&q.bordered(mu, &p.right)).ok()?.solve(&mut step);
        let mut right: Vec<C64> = p.right.iter().zip(&step).map(|(&x, &d)| x + d).collect();
        let unit = |v: &mut [C64]| {
            let s = 1.0 / norm2(v);
            v.iter_mut().for_each(|z| *z = z.scale(s));
        };
        unit(&mut right);
        let mut value = mu + step[n];
        if T::REAL && mu.im == 0.0 {
            value = c(value.re, 0.0);
        }
        let b = q.bordered(value, &right);
        let adjoint = Mat::from_fn(n + 1, n + 1, |i, j| b[(j, i)].conj());
        let mut left = vec![C64::ZERO; n + 1];
        left[n] = C64::ONE;
        Lu::new(&adjoint).ok()?.solve(&mut left);
        left.truncate(n);
        unit(&mut left);
        (value.is_finite() && right.iter().chain(&left).all(|z| z.is_finite())).then_some(Pair { value, right, left })
    }

    /// Derivative of an eigenvalue: `-y^H (s^2 dM + s dC + dK) x / (y^H (2 s M + C) x)`.
    pub fn derivative(&self, mode: &Mode, dm: &Mat<T>, dc: &Mat<T>, dk: &Mat<T>) -> C64 {
        let (s, x, y) = (mode.value, &mode.right, &mode.left);
        -inner(y, &value(s, dm, dc, dk, x)) / inner(y, &slope(s, &self.m, &self.c, x))
    }

    /// The mode in state space: right vector (x, s x), left vector ((s M + C)^H y, M^H y). Vectors of different modes are then
    /// orthogonal, as [`Track`](super::Track) wants them.
    pub fn biorthogonal(&self, mode: &Mode) -> Mode {
        let (s, y) = (mode.value, &mode.left);
        let my = apply_adjoint(&self.m, y);
        let cy = apply_adjoint(&self.c, y);
        let left = my.iter().zip(&cy).map(|(&m, &d)| s.conj() * m + d).chain(my.iter().copied()).collect();
        let right = mode.right.iter().copied().chain(mode.right.iter().map(|&x| s * x)).collect();
        Mode { right, left, ..mode.clone() }
    }
}
