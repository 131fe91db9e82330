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
use crate::complex::C64;
use crate::dense::{Field, Mat};
use crate::factor::{Factors, Number, Plan, ScaledQuadratic};
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::work::spend;

/// A quadratic problem by the entries of its matrices on the pattern of a plan.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<'a, T = C64> {
    /// How T(s) is factored.
    pub plan: &'a Plan,
    /// A0, A1, A2.
    pub terms: [&'a [T]; 3],
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
const RESOLVED: f64 = 1e-6;
/// Distance of the nearest eigenvalue over that of one from which on it is rounding of infinite ones, which may come in chains.
const INFINITE: f64 = 1e-7;
/// Steps over wanted eigenvalues from which on the approximations are looked at, and steps after which they are looked at again: a look costs as much as many steps.
const FIRST: f64 = 1.625;
const ROUND: usize = 4;
/// Shifts that are tried, and their distance over the size of the eigenvalues.
const SHIFTS: i32 = 4;
const BESIDE: f64 = 1e-6;
/// Square of the norm of a vector, over that of its last component, from which on the component counts as zero.
const FAR: f64 = 1e60;
/// Squares of a norm that are exact to rounding.
const SQUARES: std::ops::Range<f64> = 1e-200..1e280;
/// Size of a new direction, over that before it was made orthogonal, that is rounding.
const ROUNDING: f64 = 1e-13;

impl Quadratic<'_> {
    /// Scaled for s of some size; `None` of a plan that does not suit lanes.
    pub fn scaled(&self, size: f64) -> Option<ScaledQuadratic> {
        ScaledQuadratic::new(self.plan, self.terms, size)
    }
}

impl<T: Number + super::Number> Quadratic<'_, T> {
    fn at(&self, s: T) -> Vec<T> {
        let [a0, a1, a2] = self.terms;
        a0.iter().zip(a1).zip(a2).map(|((&a0, &a1), &a2)| a0 + s * (a1 + s * a2)).collect()
    }

    /// Entries of A1 and A2 that are not both zero, for the unknowns of the iteration.
    fn rates(&self, shift: T, size: f64, weights: &[f64]) -> Rates<T> {
        let [_, a1, a2] = self.terms;
        let mut out = Rates { ends: Vec::with_capacity(self.plan.n()), entries: Vec::with_capacity(self.plan.pattern().entries()) };
        for i in 0..self.plan.n() {
            let row = self.plan.pattern().row(i).filter(|&(e, _)| a1[e] != T::ZERO || a2[e] != T::ZERO);
            let times = |x: T, k: f64| Number::times(x, k);
            out.entries.extend(row.map(|(e, j)| (j, times(a1[e] + shift * a2[e], 1.0 / weights[j]), times(a2[e], size / weights[j]))));
            out.ends.push(out.entries.len());
        }
        out
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

/// Rows of `(A1 + p A2) D` and `d A2 D` with D the inverse weights: column and both values, and where each row ends.
struct Rates<T> {
    ends: Vec<usize>,
    entries: Vec<(usize, T, T)>,
}

impl<T: Number> Rates<T> {
    /// Applied to u and w, the halves of a vector.
    fn apply(&self, halves: (&[T], &[T]), out: &mut [T]) {
        let mut from = 0;
        for (out, &end) in out.iter_mut().zip(&self.ends) {
            let (mut of_u, mut of_w) = (T::ZERO, T::ZERO);
            for &(j, a, b) in &self.entries[from..end] {
                of_u += a * halves.0[j];
                of_w += b * halves.1[j];
            }
            (*out, from) = (of_u + of_w, end);
        }
    }
}

/// A vector by the `P` parts of its numbers, each padded with zeros to whole lanes.
#[derive(Clone, Debug)]
struct Planes<const P: usize>([Vec<f64>; P]);

impl<const P: usize> Planes<P> {
    fn from<T: Number>(values: impl ExactSizeIterator<Item = T>) -> Self {
        let length = values.len().next_multiple_of(LANES);
        let mut out = std::array::from_fn(|_| vec![0.0; length]);
        let mut parts = [0.0; P];
        for (i, x) in values.enumerate() {
            x.write(&mut parts);
            out.iter_mut().zip(parts).for_each(|(plane, part)| plane[i] = part);
        }
        Planes(out)
    }
    #[cfg(test)]
    fn at<T: Number>(&self, i: usize) -> T {
        T::read(&std::array::from_fn::<f64, P, _>(|p| self.0[p][i]))
    }
    fn read<T: Number>(&self, out: &mut [T]) {
        for (i, out) in out.iter_mut().enumerate() {
            *out = T::read(&std::array::from_fn::<f64, P, _>(|p| self.0[p][i]));
        }
    }
    fn all(&mut self) -> impl Iterator<Item = &mut f64> {
        self.0.iter_mut().flatten()
    }
    fn norm(&self) -> f64 {
        let mut sums = [0.0; LANES];
        for chunk in self.0.iter().flat_map(|all| all.as_chunks::<LANES>().0) {
            sums.iter_mut().zip(chunk).for_each(|(sum, x)| *sum += x * x);
        }
        let square: f64 = sums.iter().sum();
        if SQUARES.contains(&square) {
            return square.sqrt();
        }
        // squares that overflow or vanish, and numbers that are not finite
        let m = self.0.iter().flatten().fold(0.0, |m: f64, x| if x.abs() > m || x.is_nan() { x.abs() } else { m });
        if m == 0.0 || !m.is_finite() {
            return m;
        }
        let scale = 1.0 / m;
        m * self.0.iter().map(|all| all.iter().map(|x| (x * scale) * (x * scale)).sum::<f64>()).sum::<f64>().sqrt()
    }
    /// Divides by the norm, which is returned.
    fn normalise(&mut self) -> f64 {
        let size = self.norm();
        if size > 0.0 {
            let scale = 1.0 / size;
            self.all().for_each(|x| *x *= scale);
        }
        size
    }
}

/// Makes a vector orthogonal to others of norm one; the parts of them that were in it are added to `column`.
struct Orthogonalise<'a, const P: usize> {
    basis: &'a [Planes<P>],
    next: &'a mut Planes<P>,
    column: &'a mut [[f64; P]],
}

impl<const P: usize> Kernel for Orthogonalise<'_, P> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let mut parts = vec![[0.0; P]; self.basis.len()];
        let rows = self.next.0[0].len() / LANES;
        // twice: what the first pass leaves is rounding of what it takes
        for _ in 0..2 {
            for (b, part) in self.basis.iter().zip(&mut parts) {
                let mut sums = [S::zero(); P];
                for k in 0..rows {
                    let (x, u) = (lane::<S>(&self.next.0[0], k), lane::<S>(&b.0[0], k));
                    sums[0] += u * x;
                    if P == 2 {
                        let (y, v) = (lane::<S>(&self.next.0[P - 1], k), lane::<S>(&b.0[P - 1], k));
                        sums[0] += v * y;
                        sums[P - 1] += u * y - v * x;
                    }
                }
                for p in 0..P {
                    part[p] = sums[p].to_array().iter().fold(0.0, |a, x| a + x);
                }
            }
            for k in 0..rows {
                let mut x = [S::zero(); P];
                for p in 0..P {
                    x[p] = lane::<S>(&self.next.0[p], k);
                }
                for (b, part) in self.basis.iter().zip(&parts) {
                    let (u, p) = (lane::<S>(&b.0[0], k), S::cst(part[0]));
                    x[0] -= p * u;
                    if P == 2 {
                        let (v, q) = (lane::<S>(&b.0[P - 1], k), S::cst(part[P - 1]));
                        x[0] += q * v;
                        x[P - 1] -= p * v + q * u;
                    }
                }
                for p in 0..P {
                    x[p].store(&mut self.next.0[p].as_chunks_mut::<LANES>().0[k]);
                }
            }
            for (h, part) in self.column.iter_mut().zip(&parts) {
                for p in 0..P {
                    h[p] += part[p];
                }
            }
        }
    }
}

#[inline(always)]
fn lane<S: LaneScalar>(plane: &[f64], k: usize) -> S {
    S::load(&plane.as_chunks::<LANES>().0[k])
}

/// The eigenvalues nearest to `shift`, at least `wanted` where so many are resolved within `most` steps. `size` is that of the eigenvalues.
///
/// # Errors
/// Entries that are not finite; a problem that every number solves.
pub fn nearest(problem: &Quadratic, shift: C64, size: f64, wanted: usize, most: usize) -> Result<Nearest, EigError> {
    // beside an eigenvalue where the shift is one
    let shifts = (0..SHIFTS).map(|k| shift + C64::cis(f64::from(k)).scale(BESIDE * f64::from(k) * size));
    arnoldi::<C64, 2>(problem, shifts, size, (wanted, most))
}

/// The same of a real problem with a real shift, in real arithmetic.
///
/// # Errors
/// As [`nearest`].
pub fn nearest_real(problem: &Quadratic<f64>, shift: f64, size: f64, wanted: usize, most: usize) -> Result<Nearest, EigError> {
    let shifts = (0..SHIFTS).map(|k| shift + BESIDE * f64::from(k) * size);
    arnoldi::<f64, 1>(problem, shifts, size, (wanted, most))
}

fn arnoldi<T: Number + super::Number, const P: usize>(
    problem: &Quadratic<T>,
    mut shifts: impl Iterator<Item = T>,
    size: f64,
    (wanted, most): (usize, usize),
) -> Result<Nearest, EigError> {
    let n = problem.plan.n();
    let factored = |p: T| Some((p, Factors::new(problem.plan, &problem.at(p)).ok()?));
    let Some((shift, factors)) = shifts.find_map(factored) else { return Err(EigError::SingularPencil) };
    let (weights, level) = (problem.weights(size), Level::best());
    let rates = problem.rates(shift, size, &weights);
    let most = most.min(2 * n);
    // an arbitrary start, the same every time
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let start = (0..2 * n).map(|_| T::read(&std::array::from_fn::<f64, P, _>(|_| random())));
    let mut start = Planes::<P>::from(start);
    start.normalise();
    let (mut basis, mut columns): (Vec<Planes<P>>, Vec<Vec<T>>) = (vec![start], Vec::new());
    let (mut last, mut next) = (vec![T::ZERO; 2 * n], vec![T::ZERO; 2 * n]);
    loop {
        let k = columns.len();
        spend((P * P * (n * 30 + 8 * n * k)) as u64);
        basis[k].read(&mut last);
        let (u, w) = last.split_at(n);
        let (image, rate) = next.split_at_mut(n);
        rates.apply((u, w), image);
        factors.solve(image);
        for (((image, rate), &u), &weight) in image.iter_mut().zip(rate).zip(u).zip(&weights) {
            *image = Number::times(*image, -weight);
            *rate = Number::times(u + shift * *image, 1.0 / size);
        }
        let mut next = Planes::<P>::from(next.iter().copied());
        let before = next.norm();
        if !before.is_finite() {
            return Err(EigError::NotFinite);
        }
        let mut parts = vec![[0.0; P]; k + 2];
        dispatch(level, Orthogonalise { basis: &basis, next: &mut next, column: &mut parts });
        let rest = next.normalise();
        let ended = rest <= ROUNDING * before;
        let mut column: Vec<T> = parts.iter().map(|x| T::read(x)).collect();
        column[k + 1] = T::real(if ended { 0.0 } else { rest });
        columns.push(column);
        let steps = k + 1;
        if ended || steps >= most || (steps % ROUND == 0 && steps as f64 >= FIRST * wanted as f64) {
            let found = resolved::<T, P>(&columns, shift.act(C64::ONE), level)?;
            if ended || steps >= most || found.values.len() >= wanted {
                return Ok(if ended { Nearest { radius: f64::INFINITY, ..found } } else { found });
            }
        }
        basis.push(next);
    }
}

/// What a Hessenberg matrix, column by column with the entry below its last row, shows of the eigenvalues.
fn resolved<T: Number + super::Number, const P: usize>(columns: &[Vec<T>], shift: C64, level: Level) -> Result<Nearest, EigError> {
    let m = columns.len();
    let h = Mat::from_fn(m, m, |i, j| columns[j].get(i).copied().unwrap_or(T::ZERO));
    let beyond = columns[m - 1][m].size();
    let mut out = Nearest { values: Vec::new(), radius: f64::INFINITY };
    let all = T::of_hessenberg(&h)?;
    let largest = all.iter().map(|m| m.abs()).fold(0.0, f64::max);
    let finite: Vec<C64> = all.into_iter().filter(|m| m.abs() > INFINITE * largest).collect();
    // of a real matrix conjugate values have conjugate vectors
    let second = |k: usize| T::REAL && k > 0 && finite[k].im < 0.0 && finite[k] == finite[k - 1].conj();
    let alone: Vec<C64> = (0..finite.len()).filter(|&k| !second(k)).map(|k| finite[k]).collect();
    let mut components = alone.chunks(LANES).flat_map(|some| dispatch(level, LastComponents::<T, P> { h: &h, values: some }));
    let mut last = 0.0;
    for (k, &value) in finite.iter().enumerate() {
        let size = value.abs();
        if !second(k) {
            last = components.next().unwrap_or(f64::INFINITY);
        }
        if beyond * last <= RESOLVED * size {
            out.values.push(shift + value.recip());
        } else {
            out.radius = out.radius.min(1.0 / size);
        }
    }
    let distance = |s: &C64| (*s - shift).abs();
    out.values.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    Ok(out)
}

/// Last components of eigenvectors y of a Hessenberg matrix H over their norms, of as many eigenvalues as there are lanes: from the last row up to the second
///
/// ```text
/// y[k-1] = (value y[k] - sum over j >= k of H[k,j] y[j]) / H[k,k-1],    y[m-1] = 1
/// ```
struct LastComponents<'a, T, const P: usize> {
    h: &'a Mat<T>,
    values: &'a [C64],
}

impl<T: Number, const P: usize> Kernel for LastComponents<'_, T, P> {
    type Out = [f64; LANES];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> [f64; LANES] {
        let m = self.h.rows();
        let mut value = [[0.0; LANES]; 2];
        for (l, v) in self.values.iter().enumerate() {
            (value[0][l], value[1][l]) = (v.re, v.im);
        }
        let value = [S::load(&value[0]), S::load(&value[1])];
        let mut y = vec![[S::zero(); 2]; m];
        y[m - 1][0] = S::cst(1.0);
        let mut squares = S::cst(1.0);
        for k in (1..m).rev() {
            let last = y[k];
            let mut sum = [value[0] * last[0] - value[1] * last[1], value[0] * last[1] + value[1] * last[0]];
            for j in k..m {
                let (mut h, y) = ([0.0; P], y[j]);
                self.h[(k, j)].write(&mut h);
                let re = S::cst(h[0]);
                sum = [sum[0] - re * y[0], sum[1] - re * y[1]];
                if P == 2 {
                    let im = S::cst(h[P - 1]);
                    sum = [sum[0] + im * y[1], sum[1] - im * y[0]];
                }
            }
            let mut below = [0.0; P];
            self.h[(k, k - 1)].write(&mut below);
            let (re, im) = (below[0], if P == 2 { below[P - 1] } else { 0.0 });
            let over = 1.0 / (re * re + im * im);
            let (re, im) = (S::cst(re * over), S::cst(im * over));
            y[k - 1] = [sum[0] * re + sum[1] * im, sum[1] * re - sum[0] * im];
            squares += y[k - 1][0] * y[k - 1][0] + y[k - 1][1] * y[k - 1][1];
            if !S::bits(squares.lt(S::cst(FAR))).any() {
                break;
            }
        }
        // zero where the norm is beyond the limit or has overflowed
        let mut out = squares.to_array();
        for x in &mut out {
            *x = if *x < FAR { 1.0 / x.sqrt() } else { 0.0 };
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::super::Pencil;
    use super::*;
    use crate::complex::c;
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
            assert!(away <= RESOLVED * (*v - shift).abs() + 1e-9 * v.abs(), "{v:?} is off by {away:e}");
        }
        // none nearer than the radius is overlooked
        for e in exact.iter().filter(|e| (**e - shift).abs() < 0.999 * found.radius) {
            let away = found.values.iter().map(|v| (*e - *v).abs()).fold(f64::INFINITY, f64::min);
            assert!(away <= RESOLVED * e.abs(), "{e:?} is missing: {away:e}");
        }
    }

    #[test]
    fn orthogonal_at_every_level_with_the_same_bits() {
        let vector = |k: usize| {
            Planes::<2>::from((0..37).map(|i| C64::cis((i * i + 3 * k * i) as f64 + k as f64).scale(1.0 + 0.1 * (i + k) as f64)))
        };
        let mut basis = vec![vector(0)];
        basis[0].normalise();
        for k in 1..4 {
            let mut next = vector(k);
            dispatch(Level::best(), Orthogonalise { basis: &basis, next: &mut next, column: &mut [[0.0; 2]; 4] });
            next.normalise();
            basis.push(next);
        }
        let inner = |a: &Planes<2>, b: &Planes<2>| (0..37).fold(C64::ZERO, |sum, i| sum + a.at::<C64>(i).conj() * b.at(i));
        let all: Vec<(Planes<2>, [[f64; 2]; 4])> = Level::supported()
            .map(|level| {
                let (mut next, mut column) = (vector(7), [[0.0; 2]; 4]);
                dispatch(level, Orthogonalise { basis: &basis, next: &mut next, column: &mut column });
                (next, column)
            })
            .collect();
        for (next, column) in &all {
            assert!(next.0 == all[0].0.0 && *column == all[0].1);
            for (b, h) in basis.iter().zip(column) {
                assert!(inner(b, next).abs() <= 1e-14 * next.norm() && (inner(b, &vector(7)) - c(h[0], h[1])).abs() <= 1e-13 * next.norm());
            }
        }
    }

    fn last_components<T: Number + super::super::Number, const P: usize>(entry: impl Fn(usize, usize) -> T) {
        let n = 11;
        let h = Mat::from_fn(n, n, |i, j| if i > j + 1 { T::ZERO } else { entry(i, j) });
        let values = T::of_hessenberg(&h).unwrap();
        for some in values.chunks(LANES) {
            for level in Level::supported() {
                let found = dispatch(level, LastComponents::<T, P> { h: &h, values: some });
                for (&value, found) in some.iter().zip(found) {
                    let singular = Mat::from_fn(n, n, |i, j| h[(i, j)].act(C64::ONE) - if i == j { value } else { C64::ZERO });
                    let last = <C64 as super::super::Number>::svd(&singular).unwrap().v[(n - 1, n - 1)].abs();
                    assert!((found - last).abs() <= 1e-9 * last, "{value:?} {found} {last}");
                }
            }
        }
    }

    #[test]
    fn last_components_are_those_of_eigenvectors() {
        let wave = |i: usize, j: usize| (1.0 + 2.3 * i as f64 + 0.7 * (j * j) as f64).sin() + if i == j + 1 { 1.5 } else { 0.0 };
        last_components::<f64, 1>(wave);
        last_components::<C64, 2>(|i, j| c(wave(i, j), wave(j + 3, i)));
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

    /// In real arithmetic the same, in conjugate pairs.
    #[test]
    fn a_real_shift() {
        let (plan, terms, exact) = chain(600, 4e8, 1e-6);
        let real = terms.each_ref().map(|all| all.iter().map(|x| x.re).collect::<Vec<f64>>());
        let problem = Quadratic { plan: &plan, terms: real.each_ref().map(Vec::as_slice) };
        for (shift, size) in [(300.0, 1e3), (0.0, 500.0), (-900.0, 2e3)] {
            let found = nearest_real(&problem, shift, size, 12, 120).unwrap();
            assert!(found.values.len() >= 12 && found.radius > 0.0, "{found:?}");
            agrees(&found, &exact, c(shift, 0.0));
            for v in &found.values {
                assert!(found.values.iter().any(|w| (w.conj() - *v).abs() <= 1e-9 * v.abs()), "{v:?} is alone");
            }
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
