//! The test function of a singular matrix: the matrix, scaled, with one more row and column that make it regular.
//!
//! ```text
//! [ T    b ] [ x ]   [ 0 ]
//! [ c^H  0 ] [ g ] = [ 1 ]        g = 0 exactly where T is singular; x is its null vector there, y, the solution with the adjoint, the left one
//! ```

use laval_num::complex::{C64, c};
use laval_num::dense::Field;
use laval_num::factor::{Factors, Selection};
use std::sync::Arc;

/// Scaling and bordering vectors, kept while `s` and the speed move a little.
#[derive(Clone, Debug)]
pub struct Border {
    pub(super) of: Arc<Selection>,
    pub(super) rows: Vec<f64>,
    pub(super) cols: Vec<f64>,
    pub(super) b: Vec<C64>,
    pub(super) c: Vec<C64>,
}

/// Value of the test function.
#[derive(Clone, Debug)]
pub struct Test {
    /// g: relative distance from singularity.
    pub g: C64,
    /// dg/ds.
    pub slope: C64,
    /// Right vector (scaled, over the members).
    pub right: Vec<C64>,
    /// Left vector.
    pub left: Vec<C64>,
}

impl Border {
    /// By the null vectors of a root over the members.
    pub(super) fn of(of: &Arc<Selection>, (rows, cols): (&[f64], &[f64]), (left, right): (&[C64], &[C64])) -> Option<Border> {
        let scaled = |x: &[C64], k: &[f64]| x.iter().zip(k).map(|(x, k)| x.scale(1.0 / k)).collect();
        let (mut b, mut c): (Vec<C64>, Vec<C64>) = (scaled(left, rows), scaled(right, cols));
        normalise(&mut b)?;
        normalise(&mut c)?;
        Some(Border { of: of.clone(), rows: rows.to_vec(), cols: cols.to_vec(), b, c })
    }

    /// `y^H M x` for the vectors of a test and the entries of a matrix over all unknowns.
    pub fn product(&self, test: &Test, m: &[C64]) -> C64 {
        let (pattern, from) = (self.of.inner.pattern(), &self.of.inner_from);
        self.products(test, |i| pattern.row(i).filter_map(|(e, j)| Some((j, m[from[e]?]))))
    }

    /// The same of a matrix by the entries of its rows.
    fn products<I: Iterator<Item = (usize, C64)>>(&self, test: &Test, row: impl Fn(usize) -> I) -> C64 {
        let mut sum = C64::ZERO;
        for (i, y) in test.left.iter().enumerate() {
            let row = row(i).fold(C64::ZERO, |s, (j, m)| s + m * test.right[j].scale(self.cols[j]));
            sum += y.conj() * row.scale(self.rows[i]);
        }
        sum
    }

    /// With the vectors of a test nearby.
    pub(super) fn towards(mut self, test: Test) -> Option<Border> {
        (self.b, self.c) = (test.left, test.right);
        normalise(&mut self.b)?;
        normalise(&mut self.c)?;
        Some(self)
    }

    pub(super) fn test(&self, t: &[C64], d: &[C64]) -> Option<Test> {
        let of = &self.of;
        let k = of.members.len();
        let (pattern, from) = (of.bordered.pattern(), &of.bordered_from);
        let mut m = vec![C64::ZERO; from.len()];
        for i in 0..=k {
            for (e, j) in pattern.row(i) {
                m[e] = match (from[e], i < k, j < k) {
                    (Some(whole), ..) => t[whole].scale(self.rows[i] * self.cols[j]),
                    (_, true, false) => self.b[i],
                    (_, false, true) => self.c[j].conj(),
                    _ => C64::ZERO,
                };
            }
        }
        let factors = Factors::new(&of.bordered, &m).ok()?;
        let mut right = vec![C64::ZERO; k + 1];
        right[k] = C64::ONE;
        let mut left = right.clone();
        factors.solve(&mut right);
        // of the adjoint: the right side is real
        factors.solve_transposed(&mut left);
        left.iter_mut().for_each(|x| *x = x.conj());
        // T x + b g = 0, so that g is minus the usual sign; it vanishes with the determinant.
        let g = right[k];
        right.truncate(k);
        left.truncate(k);
        let mut test = Test { g, slope: C64::ZERO, right, left };
        let row = |i: usize| pattern.row(i).filter_map(|(e, j)| Some((j, d[from[e]?])));
        test.slope = -self.products(&test, row);
        (test.g.is_finite() && test.slope.is_finite()).then_some(test)
    }

    pub(super) fn spread(&self, x: &[C64], scale: &[f64], size: usize) -> Vec<C64> {
        let mut out = vec![C64::ZERO; size];
        for ((&m, &x), &k) in self.of.members.iter().zip(x).zip(scale) {
            out[m] = x.scale(k);
        }
        out
    }
}

/// Row and column factors that bring the largest entries of rows and columns near one. Sizes come from T and s dT/ds together: T alone may be
/// small only because its terms cancel, which is what the test function is to see.
pub(super) fn equilibrate(of: &Selection, t: &[C64], slope: &[C64], s: f64) -> (Vec<f64>, Vec<f64>) {
    let (pattern, k) = (of.inner.pattern(), of.members.len());
    let (mut rows, mut cols) = (vec![1.0; k], vec![1.0; k]);
    let sizes: Vec<f64> = t.iter().zip(slope).map(|(t, d)| t.size() + s * d.size()).collect();
    let factor = |x: f64| if x > 0.0 && x.is_finite() { x.sqrt().recip() } else { 1.0 };
    let mut largest = vec![0.0f64; k];
    for _ in 0..6 {
        for (i, r) in rows.iter_mut().enumerate() {
            *r *= factor(pattern.row(i).map(|(e, j)| sizes[e] * *r * cols[j]).fold(0.0, f64::max));
        }
        largest.fill(0.0);
        for (i, r) in rows.iter().enumerate() {
            pattern.row(i).for_each(|(e, j)| largest[j] = largest[j].max(sizes[e] * r * cols[j]));
        }
        cols.iter_mut().zip(&largest).for_each(|(c, &x)| *c *= factor(x));
    }
    let power = |x: &f64| x.log2().round().exp2();
    (rows.iter().map(power).collect(), cols.iter().map(power).collect())
}

/// Inverse of a singular value, over the size one of the entries, from which on no further iteration is needed.
const NEAR_SINGULAR: f64 = 1e5;

/// Factors of a matrix that may be singular, for inverse iteration.
fn nearly_singular(of: &Selection, t: &[C64]) -> Option<Factors<C64>> {
    let pattern = of.inner.pattern();
    // A change by a few roundings keeps an exactly singular matrix factorable and moves the directions no further.
    // One equation alone is zero where it is singular, and has no size.
    let size = t.iter().fold(0.0, |m: f64, x| if x.size() > m || x.size().is_nan() { x.size() } else { m });
    let eps = 8.0 * f64::EPSILON * if size > 0.0 { size } else { 1.0 };
    let mut shifted = t.to_vec();
    for i in 0..of.members.len() {
        pattern.row(i).filter(|x| x.1 == i).for_each(|(e, _)| shifted[e] += c(eps, 0.5 * eps));
    }
    Factors::new(&of.inner, &shifted).ok()
}

/// Orthonormal left and right singular directions of some of the smallest singular values, by inverse iteration.
pub(super) fn null_spaces(of: &Selection, t: &[C64], count: usize) -> Option<[Vec<Vec<C64>>; 2]> {
    let factors = nearly_singular(of, t)?;
    let start = |k: usize| {
        let entry = |i: usize| C64::cis(1.0 + (2.4 + 0.7 * k as f64) * i as f64).scale(1.0 + 0.3 * ((1 + k) as f64 * i as f64).sin());
        (0..of.members.len()).map(entry).collect()
    };
    let mut right: Vec<Vec<C64>> = (0..count).map(start).collect();
    let mut left = right.clone();
    for _ in 0..4 {
        for (y, x) in left.iter_mut().zip(&right) {
            *y = x.iter().map(|x| x.conj()).collect();
            factors.solve_transposed_roughly(y);
            y.iter_mut().for_each(|y| *y = y.conj());
        }
        orthonormal(&mut left)?;
        right.clone_from(&left);
        right.iter_mut().for_each(|x| factors.solve_roughly(x));
        orthonormal(&mut right)?;
    }
    Some([left, right])
}

fn orthonormal(all: &mut [Vec<C64>]) -> Option<()> {
    for k in 0..all.len() {
        let (before, rest) = all.split_at_mut(k);
        let x = &mut rest[0];
        normalise(x)?;
        // the first pass leaves rounding of what it takes away
        for _ in 0..2 {
            for b in before.iter() {
                let share = b.iter().zip(x.iter()).fold(C64::ZERO, |sum, (b, x)| sum + b.conj() * *x);
                x.iter_mut().zip(b).for_each(|(x, b)| *x -= share * *b);
            }
            normalise(x)?;
        }
    }
    Some(())
}

/// Left and right singular directions of the smallest singular value, roughly, by inverse iteration.
pub(super) fn singular_directions(of: &Selection, t: &[C64]) -> Option<(Vec<C64>, Vec<C64>)> {
    let k = of.members.len();
    let factors = nearly_singular(of, t)?;
    let mut x: Vec<C64> = (0..k).map(|i| C64::cis(1.0 + 2.4 * i as f64).scale(1.0 + 0.3 * (i as f64).sin())).collect();
    let mut y = x.clone();
    for _ in 0..3 {
        // with the adjoint
        y = x.iter().map(|x| x.conj()).collect();
        factors.solve_transposed_roughly(&mut y);
        y.iter_mut().for_each(|y| *y = y.conj());
        normalise(&mut y)?;
        x = y.clone();
        factors.solve_roughly(&mut x);
        let grown = normalise(&mut x)?;
        // near a root the first directions are those of the smallest singular value but for its share of the next one
        if grown >= NEAR_SINGULAR && !of.inner.is_dense() {
            break;
        }
    }
    Some((y, x))
}

/// Divides by the norm, which is returned.
fn normalise(x: &mut [C64]) -> Option<f64> {
    let m = x.iter().fold(0.0, |m: f64, z| if z.size() > m || z.size().is_nan() { z.size() } else { m });
    if !(m > 0.0 && m.is_finite()) {
        return None;
    }
    x.iter_mut().for_each(|z| *z = z.scale(1.0 / m));
    let n = x.iter().map(|z| z.norm_sqr()).sum::<f64>().sqrt();
    x.iter_mut().for_each(|z| *z = z.scale(1.0 / n));
    Some(m * n)
}
