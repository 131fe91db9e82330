//! Some eigenvalues of a large sparse quadratic problem: those nearest to a shift.
//!
//! ```text
//! (A0 + s A1 + s^2 A2) u = 0,    T(s) = A0 + s A1 + s^2 A2
//! ```
//!
//! Arnoldi's method for the inverse of the problem about the shift p, written for (u, w) with w = s u / d, d a number of the size of the eigenvalues:
//!
//! ```text
//! u' = -T(p)^-1 (d A2 w + (A1 + p A2) u),    w' = (u + p u') / d,    eigenvalues 1/(s - p).
//! ```
//!
//! One factorisation of T(p) serves all steps. Infinite eigenvalues (singular A2) are its zeros and do not disturb.
//!
//! Source: Z. Bai, J. Demmel, J. Dongarra, A. Ruhe, H. van der Vorst (eds.), Templates for the Solution of Algebraic Eigenvalue Problems, SIAM 2000, sections 7.5 and 9.2.

use super::EigError;
use super::number::{norm2, right_vectors};
use crate::complex::{C64, c};
use crate::dense::{Field, Mat};
use crate::factor::{Factors, Plan};
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::work::spend;

/// A quadratic problem by the entries of its matrices on the pattern of a plan.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<'a> {
    /// How T(s) is factored.
    pub plan: &'a Plan,
    /// A0, A1, A2.
    pub terms: [&'a [C64]; 3],
}

/// Eigenvalues nearest to a shift.
#[derive(Clone, Debug, Default)]
pub struct Nearest {
    /// By distance from the shift.
    pub values: Vec<C64>,
    /// Distance from the shift of the nearest that is not resolved yet: nearer ones are among the values, but for copies of a multiple one. Infinite where all are resolved.
    pub radius: f64,
}

/// Distance of an approximate eigenvalue from a true one, relative to its distance from the shift, at which it is resolved.
const RESOLVED: f64 = 1e-7;
/// Distance of the nearest eigenvalue over that of one from which on it is rounding of infinite ones, which may come in chains.
const INFINITE: f64 = 1e-7;
/// Steps after which the approximations are looked at, again and again.
const ROUND: usize = 20;
/// Shifts that are tried, and their distance over the size of the eigenvalues.
const SHIFTS: i32 = 4;
const BESIDE: f64 = 1e-6;
/// Size of a new direction, over that before it was made orthogonal, that is rounding.
const ROUNDING: f64 = 1e-13;

impl Quadratic<'_> {
    fn at(&self, s: C64) -> Vec<C64> {
        let [a0, a1, a2] = self.terms;
        a0.iter().zip(a1).zip(a2).map(|((&a0, &a1), &a2)| a0 + s * (a1 + s * a2)).collect()
    }

    /// Entries of A1 and A2 that are not both zero: row, column, values.
    fn rates(&self) -> Vec<(usize, usize, C64, C64)> {
        let [_, a1, a2] = self.terms;
        let row = |i: usize| self.plan.pattern().row(i).map(move |(e, j)| (i, j, a1[e], a2[e]));
        (0..self.plan.n()).flat_map(row).filter(|x| x.2 != C64::ZERO || x.3 != C64::ZERO).collect()
    }

    /// Square roots of the diagonal of |A0| + |p| |A1| + |p|^2 |A2|: unknowns of different units count alike.
    fn weights(&self, p: f64) -> Vec<f64> {
        let [a0, a1, a2] = self.terms;
        let weight = |i: usize| {
            let size = self.plan.pattern().index(i, i).map_or(0.0, |e| a0[e].size() + p * (a1[e].size() + p * a2[e].size()));
            if size > 0.0 && size.is_finite() { size.sqrt() } else { 1.0 }
        };
        (0..self.plan.n()).map(weight).collect()
    }
}

/// A complex vector, padded with zeros to whole lanes: real parts, then imaginary parts.
#[derive(Clone, Debug)]
struct Planes {
    re: Vec<f64>,
    im: Vec<f64>,
}

impl Planes {
    fn from(values: impl ExactSizeIterator<Item = C64>) -> Self {
        let length = values.len().next_multiple_of(LANES);
        let mut out = Planes { re: vec![0.0; length], im: vec![0.0; length] };
        values.enumerate().for_each(|(i, x)| (out.re[i], out.im[i]) = (x.re, x.im));
        out
    }
    #[inline(always)]
    fn at(&self, i: usize) -> C64 {
        c(self.re[i], self.im[i])
    }
    fn norm(&self) -> f64 {
        let m = self.re.iter().chain(&self.im).fold(0.0, |m: f64, x| if x.abs() > m || x.is_nan() { x.abs() } else { m });
        let squares = |all: &[f64]| all.iter().map(|x| (x / m) * (x / m)).sum::<f64>();
        if m == 0.0 || !m.is_finite() { m } else { m * (squares(&self.re) + squares(&self.im)).sqrt() }
    }
    /// Divides by the norm, which is returned.
    fn normalise(&mut self) -> f64 {
        let size = self.norm();
        if size > 0.0 {
            self.re.iter_mut().chain(&mut self.im).for_each(|x| *x *= 1.0 / size);
        }
        size
    }
}

/// Makes a vector orthogonal to others of norm one; what of them was in it is added to `column`.
struct Orthogonalise<'a> {
    basis: &'a [Planes],
    next: &'a mut Planes,
    column: &'a mut [C64],
}

impl Kernel for Orthogonalise<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let mut parts = vec![C64::ZERO; self.basis.len()];
        // twice: what the first pass leaves is rounding of what it takes
        for _ in 0..2 {
            let (re, im) = (self.next.re.as_chunks::<LANES>().0, self.next.im.as_chunks::<LANES>().0);
            for (b, part) in self.basis.iter().zip(&mut parts) {
                let (b_re, b_im) = (b.re.as_chunks::<LANES>().0, b.im.as_chunks::<LANES>().0);
                let (mut sum_re, mut sum_im) = (S::zero(), S::zero());
                for k in 0..re.len() {
                    let (x, y, u, v) = (S::load(&re[k]), S::load(&im[k]), S::load(&b_re[k]), S::load(&b_im[k]));
                    sum_re += u * x + v * y;
                    sum_im += u * y - v * x;
                }
                let (mut a, mut b) = (0.0, 0.0);
                for (x, y) in sum_re.to_array().iter().zip(&sum_im.to_array()) {
                    (a, b) = (a + x, b + y);
                }
                *part = c(a, b);
            }
            let (re, im) = (self.next.re.as_chunks_mut::<LANES>().0, self.next.im.as_chunks_mut::<LANES>().0);
            for k in 0..re.len() {
                let (mut x, mut y) = (S::load(&re[k]), S::load(&im[k]));
                for (b, part) in self.basis.iter().zip(&parts) {
                    let (u, v) = (S::load(&b.re.as_chunks::<LANES>().0[k]), S::load(&b.im.as_chunks::<LANES>().0[k]));
                    let (p, q) = (S::cst(part.re), S::cst(part.im));
                    x -= p * u - q * v;
                    y -= p * v + q * u;
                }
                x.store(&mut re[k]);
                y.store(&mut im[k]);
            }
            for (h, &part) in self.column.iter_mut().zip(&parts) {
                *h += part;
            }
        }
    }
}

/// The eigenvalues nearest to `shift`, at least `wanted` where so many are resolved within `most` steps. `size` is that of the eigenvalues.
///
/// # Errors
/// Entries that are not finite; a problem that every number solves.
pub fn nearest(problem: &Quadratic, shift: C64, size: f64, wanted: usize, most: usize) -> Result<Nearest, EigError> {
    let n = problem.plan.n();
    // beside an eigenvalue where the shift is one
    let beside = (0..SHIFTS).map(|k| shift + C64::cis(f64::from(k)).scale(BESIDE * f64::from(k) * size));
    let factored = |p: C64| Some((p, Factors::new(problem.plan, &problem.at(p)).ok()?));
    let Some((shift, factors)) = beside.into_iter().find_map(factored) else { return Err(EigError::SingularPencil) };
    let (weights, rates, level) = (problem.weights(size), problem.rates(), Level::best());
    let most = most.min(2 * n);
    // an arbitrary start, the same every time
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mut start = Planes::from((0..2 * n).map(|_| c(random(), random())));
    start.normalise();
    let (mut basis, mut columns): (Vec<Planes>, Vec<Vec<C64>>) = (vec![start], Vec::new());
    let (mut x, mut y, mut image) = (vec![C64::ZERO; n], vec![C64::ZERO; n], vec![C64::ZERO; n]);
    loop {
        let k = columns.len();
        spend((4 * (n * 30 + 8 * n * k)) as u64);
        let b = &basis[k];
        for i in 0..n {
            x[i] = b.at(i).scale(1.0 / weights[i]);
            y[i] = (b.at(n + i).scale(size) + shift * b.at(i)).scale(1.0 / weights[i]);
        }
        image.fill(C64::ZERO);
        rates.iter().for_each(|&(i, j, a1, a2)| image[i] += a1 * x[j] + a2 * y[j]);
        factors.solve(&mut image);
        image.iter_mut().zip(&weights).for_each(|(v, &d)| *v = -v.scale(d));
        let second = |i: usize| (b.at(i) + shift * image[i]).scale(1.0 / size);
        let mut next = Planes::from((0..2 * n).map(|i| if i < n { image[i] } else { second(i - n) }));
        let before = next.norm();
        if !before.is_finite() {
            return Err(EigError::NotFinite);
        }
        let mut column = vec![C64::ZERO; k + 2];
        dispatch(level, Orthogonalise { basis: &basis, next: &mut next, column: &mut column });
        let rest = next.normalise();
        let ended = rest <= ROUNDING * before;
        column[k + 1] = c(if ended { 0.0 } else { rest }, 0.0);
        columns.push(column);
        let steps = k + 1;
        if ended || steps >= most || (steps % ROUND == 0 && steps > wanted) {
            let found = resolved(&columns, shift)?;
            if ended || steps >= most || found.values.len() >= wanted {
                return Ok(if ended { Nearest { radius: f64::INFINITY, ..found } } else { found });
            }
        }
        basis.push(next);
    }
}

/// What a Hessenberg matrix, column by column with the entry below its last row, says of the eigenvalues.
fn resolved(columns: &[Vec<C64>], shift: C64) -> Result<Nearest, EigError> {
    let m = columns.len();
    let h = Mat::from_fn(m, m, |i, j| columns[j].get(i).copied().unwrap_or(C64::ZERO));
    let beyond = columns[m - 1][m].abs();
    let mut out = Nearest { values: Vec::new(), radius: f64::INFINITY };
    let all = right_vectors(&h)?;
    let largest = all.iter().map(|m| m.0.abs()).fold(0.0, f64::max);
    for (value, right) in all.iter().filter(|m| m.0.abs() > INFINITE * largest) {
        let size = value.abs();
        let error = beyond * right[m - 1].abs() / norm2(right);
        if error <= RESOLVED * size {
            out.values.push(shift + value.recip());
        } else {
            out.radius = out.radius.min(1.0 / size);
        }
    }
    let distance = |s: &C64| (*s - shift).abs();
    out.values.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::super::Pencil;
    use super::*;
    use crate::factor::Pattern;
    use std::sync::Arc;

    /// A chain of equal masses between springs, fixed at both ends, damping proportional to stiffness: roots in closed form.
    fn chain(n: usize, stiffness: f64, delay: f64) -> (Plan, [Vec<C64>; 3], Vec<C64>) {
        let pattern = Arc::new(Pattern::new(n, (1..n).map(|i| (i - 1, i))));
        let [mut k, mut m] = [vec![C64::ZERO; pattern.entries()], vec![C64::ZERO; pattern.entries()]];
        for i in 0..n {
            for (e, j) in pattern.row(i) {
                k[e] = c(if i == j { 2.0 } else { -1.0 } * stiffness, 0.0);
                m[e] = c(if i == j { 1.0 } else { 0.0 }, 0.0);
            }
        }
        let d = k.iter().map(|x| x.scale(delay)).collect();
        let mut roots = Vec::new();
        for j in 1..=n {
            let w2 = 4.0 * stiffness * (0.5 * std::f64::consts::PI * j as f64 / (n + 1) as f64).sin().powi(2);
            let (decay, rest) = (0.5 * delay * w2, 0.25 * delay * delay * w2 * w2 - w2);
            let root = if rest < 0.0 { c(0.0, (-rest).sqrt()) } else { c(rest.sqrt(), 0.0) };
            roots.extend([c(-decay, 0.0) + root, c(-decay, 0.0) - root]);
        }
        (Plan::new(&pattern), [k, d, m], roots)
    }

    fn agrees(found: &Nearest, exact: &[C64], shift: C64) {
        for v in &found.values {
            let away = exact.iter().map(|e| (*e - *v).abs()).fold(f64::INFINITY, f64::min);
            assert!(away <= 1e-6 * (*v - shift).abs() + 1e-9 * v.abs(), "{v:?} is off by {away:e}");
        }
        // none nearer than the radius is overlooked
        for e in exact.iter().filter(|e| (**e - shift).abs() < 0.999 * found.radius) {
            let away = found.values.iter().map(|v| (*e - *v).abs()).fold(f64::INFINITY, f64::min);
            assert!(away <= 1e-6 * e.abs(), "{e:?} is missing: {away:e}");
        }
    }

    #[test]
    fn orthogonal_at_every_level_with_the_same_bits() {
        let vector =
            |k: usize| Planes::from((0..37).map(|i| C64::cis((i * i + 3 * k * i) as f64 + k as f64).scale(1.0 + 0.1 * (i + k) as f64)));
        let mut basis = vec![vector(0)];
        basis[0].normalise();
        for k in 1..4 {
            let mut next = vector(k);
            dispatch(Level::best(), Orthogonalise { basis: &basis, next: &mut next, column: &mut [C64::ZERO; 4] });
            next.normalise();
            basis.push(next);
        }
        let inner = |a: &Planes, b: &Planes| (0..37).fold(C64::ZERO, |sum, i| sum + a.at(i).conj() * b.at(i));
        let all: Vec<(Planes, [C64; 4])> = Level::supported()
            .map(|level| {
                let (mut next, mut column) = (vector(7), [C64::ZERO; 4]);
                dispatch(level, Orthogonalise { basis: &basis, next: &mut next, column: &mut column });
                (next, column)
            })
            .collect();
        for (next, column) in &all {
            assert!(next.re == all[0].0.re && next.im == all[0].0.im && *column == all[0].1);
            for (b, h) in basis.iter().zip(column) {
                assert!(inner(b, next).abs() <= 1e-14 * next.norm() && (inner(b, &vector(7)) - *h).abs() <= 1e-13 * next.norm());
            }
        }
    }

    #[test]
    fn those_nearest_to_a_shift() {
        let (plan, terms, exact) = chain(600, 4e8, 1e-6);
        let problem = Quadratic { plan: &plan, terms: terms.each_ref().map(Vec::as_slice) };
        // the last one where eigenvalues crowd
        let shifts = [(c(0.0, 900.0), 1e3, 10), (c(-20.0, 9000.0), 1e4, 10), (c(0.0, -3000.0), 3e3, 10), (c(-700.0, 39_000.0), 4e4, 4)];
        for (shift, size, wanted) in shifts {
            let found = nearest(&problem, shift, size, wanted, 120).unwrap();
            assert!(found.values.len() >= wanted, "{} at {shift:?}", found.values.len());
            let nearer = found.values.iter().filter(|v| (**v - shift).abs() < found.radius).count();
            assert!(found.radius > 0.0 && nearer >= wanted / 2, "{found:?}");
            agrees(&found, &exact, shift);
        }
    }

    #[test]
    fn a_shift_on_an_eigenvalue() {
        let (plan, terms, exact) = chain(40, 1e4, 0.0);
        let problem = Quadratic { plan: &plan, terms: terms.each_ref().map(Vec::as_slice) };
        for shift in [exact[0], exact[20], exact[39]] {
            let found = nearest(&problem, shift, shift.abs(), 6, 60).unwrap();
            assert!(found.values.iter().any(|v| (*v - shift).abs() <= 1e-9 * shift.abs()), "{found:?}");
        }
        let zero = vec![C64::ZERO; terms[0].len()];
        let nothing = Quadratic { plan: &plan, terms: [&zero, &zero, &zero] };
        assert_eq!(nearest(&nothing, c(0.0, 1.0), 1.0, 3, 20).unwrap_err(), EigError::SingularPencil);
        let mut wrong = terms[0].clone();
        wrong[7] = c(f64::NAN, 0.0);
        let wrong = Quadratic { plan: &plan, terms: [&wrong, &terms[1], &terms[2]] };
        assert!(nearest(&wrong, c(0.0, 1.0), 1.0, 3, 20).is_err());
    }

    /// A full problem of small size, with a singular A2, against the pencil of its first order.
    #[test]
    fn all_of_a_small_problem() {
        let n = 7;
        let mut seed = 5u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let pattern = Arc::new(Pattern::new(n, (0..n).flat_map(|i| (0..n).map(move |j| (i, j)))));
        let mut terms = [(); 3].map(|()| (0..n * n).map(|_| c(random(), 0.3 * random())).collect::<Vec<C64>>());
        // two unknowns without mass
        for i in 0..n {
            for j in [2, 5] {
                (terms[2][i * n + j], terms[2][j * n + i]) = (C64::ZERO, C64::ZERO);
            }
        }
        let [k, d, m] = &terms;
        let a = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, false) if j - n == i => C64::ONE,
            (false, true) => -k[(i - n) * n + j],
            (false, false) => -d[(i - n) * n + j - n],
            _ => C64::ZERO,
        });
        let e = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) if i == j => C64::ONE,
            (false, false) => m[(i - n) * n + j - n],
            _ => C64::ZERO,
        });
        let exact = Pencil::new(a, e).modes().unwrap();
        assert_eq!(exact.infinite, 2);
        let exact: Vec<C64> = exact.finite.iter().map(|m| m.value).collect();
        let plan = Plan::new(&pattern);
        let problem = Quadratic { plan: &plan, terms: terms.each_ref().map(Vec::as_slice) };
        let shift = c(0.1, 0.2);
        let found = nearest(&problem, shift, 1.0, 2 * n, 100).unwrap();
        assert_eq!(found.values.len(), exact.len(), "{found:?} {exact:?}");
        agrees(&Nearest { radius: f64::INFINITY, ..found }, &exact, shift);
    }
}
