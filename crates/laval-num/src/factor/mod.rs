//! Direct factorisations of sparse square matrices behind one face.
//!
//! A [`Pattern`] says which entries may differ from zero, a [`Plan`] decides once how matrices of that pattern are factored, [`Factors`] hold one factorisation
//! and solve with it. The cost of a chain grows with its length, not with the cube of it.
//!
//! ```
//! use laval_num::factor::{Factors, Pattern, Plan};
//! use std::sync::Arc;
//! let pattern = Arc::new(Pattern::new(100, (1..100).map(|i| (i - 1, i))));
//! let plan = Plan::new(&pattern);
//! let mut values = vec![-1.0; pattern.entries()];
//! (0..100).for_each(|i| values[pattern.index(i, i).unwrap()] = 2.0);
//! let factors = Factors::new(&plan, &values)?;
//! let mut x = vec![1.0; 100];
//! factors.solve(&mut x);
//! assert!((x[49] - 0.5 * 50.0 * 51.0).abs() < 1e-9);
//! // det of this matrix is 101
//! assert!((factors.log_det().log_size - 101f64.ln()).abs() < 1e-12);
//! # Ok::<(), laval_num::dense::Singular>(())
//! ```

mod banded;
mod columns;
pub mod dense_lanes;
mod each;
mod forms;
mod lanes;
mod order;
mod pattern;
mod plan;
mod quadratic;
mod selection;
mod sum;
mod terms;
#[cfg(test)]
mod tests;

use crate::complex::{C64, Complex, c};
use crate::dense::{Field, Lu, Mat, Singular};
use crate::dual::Dual;
use crate::work::spend;
use banded::Banded;
pub use columns::Columns;
pub use each::{Each, Forced, Solved};
pub use forms::Forms;
pub use lanes::{InLanes, LaneFactors, Pair, Row};
pub use pattern::Pattern;
pub use plan::Plan;
use plan::Target;
pub use quadratic::ScaledQuadratic;
pub use selection::Selection;
pub use terms::{Entry, Terms};

/// A pivot of the band below this share of the largest entry is replaced where a border follows: the matrix may be regular although its band is not.
/// Corrections with the original matrix restore what that costs.
const REPLACED: f64 = 1e-10;
/// Passes of scaling.
const SCALINGS: usize = 3;
/// Most corrections of a solution.
const CORRECTIONS: usize = 5;

/// A number that [`Factors`] can be made of.
pub trait Number: Field {
    /// Real numbers that it is made of, its parts: it is the sum of its parts times their [units](Number::unit).
    const PARTS: usize;
    /// From its parts.
    fn read(parts: &[f64]) -> Self;
    /// To its parts.
    fn write(self, parts: &mut [f64]);
    /// What a part is multiplied by.
    fn unit(part: usize) -> Self;
    /// A real number.
    fn real(x: f64) -> Self;
    /// Multiplied by a real number.
    fn times(self, k: f64) -> Self;
    /// Logarithm of the modulus, and phase.
    fn polar(self) -> (f64, f64);
    /// Derivative over the value, for dual numbers; 0 for others.
    fn log_rate(self) -> C64 {
        C64::ZERO
    }
}

impl Number for f64 {
    const PARTS: usize = 1;
    #[inline(always)]
    fn read(parts: &[f64]) -> Self {
        parts[0]
    }
    #[inline(always)]
    fn write(self, parts: &mut [f64]) {
        parts[0] = self;
    }
    #[inline(always)]
    fn unit(_: usize) -> Self {
        1.0
    }
    fn real(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn times(self, k: f64) -> Self {
        self * k
    }
    fn polar(self) -> (f64, f64) {
        (self.abs().ln(), if self < 0.0 { std::f64::consts::PI } else { 0.0 })
    }
}

impl Number for C64 {
    const PARTS: usize = 2;
    #[inline(always)]
    fn read(parts: &[f64]) -> Self {
        c(parts[0], parts[1])
    }
    #[inline(always)]
    fn write(self, parts: &mut [f64]) {
        (parts[0], parts[1]) = (self.re, self.im);
    }
    #[inline(always)]
    fn unit(part: usize) -> Self {
        if part == 0 { C64::ONE } else { c(0.0, 1.0) }
    }
    fn real(x: f64) -> Self {
        c(x, 0.0)
    }
    #[inline(always)]
    fn times(self, k: f64) -> Self {
        self.scale(k)
    }
    fn polar(self) -> (f64, f64) {
        (self.abs().ln(), self.arg())
    }
}

/// A complex number with its derivative in one direction.
pub type Directed = Complex<Dual<f64, 1>>;

const fn directed(re: f64) -> Directed {
    c(Dual { re, eps: [0.0] }, Dual { re: 0.0, eps: [0.0] })
}

impl Field for Directed {
    const ZERO: Self = directed(0.0);
    const ONE: Self = directed(1.0);
    fn size(self) -> f64 {
        // a derivative that is not finite must not pass
        let size = self.re.re.abs() + self.im.re.abs();
        if (self.re.eps[0] + self.im.eps[0]).is_finite() { size } else { f64::NAN }
    }
}

impl Number for Directed {
    const PARTS: usize = 4;
    #[inline(always)]
    fn read(parts: &[f64]) -> Self {
        c(Dual { re: parts[0], eps: [parts[2]] }, Dual { re: parts[1], eps: [parts[3]] })
    }
    #[inline(always)]
    fn write(self, parts: &mut [f64]) {
        (parts[0], parts[1], parts[2], parts[3]) = (self.re.re, self.im.re, self.re.eps[0], self.im.eps[0]);
    }
    /// One, i, and both times the derivative.
    #[inline(always)]
    fn unit(part: usize) -> Self {
        let of = |k: usize| if part == k { 1.0 } else { 0.0 };
        Self::read(&[of(0), of(1), of(2), of(3)])
    }
    fn real(x: f64) -> Self {
        directed(x)
    }
    #[inline(always)]
    fn times(self, k: f64) -> Self {
        self.scale(Dual { re: k, eps: [0.0] })
    }
    fn polar(self) -> (f64, f64) {
        c(self.re.re, self.im.re).polar()
    }
    fn log_rate(self) -> C64 {
        c(self.re.eps[0], self.im.eps[0]) / c(self.re.re, self.im.re)
    }
}

/// A determinant that may be far outside the range of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LogDet {
    /// Logarithm of its modulus.
    pub log_size: f64,
    /// Phase, rad, not wrapped.
    pub phase: f64,
    /// Derivative over the value, of dual numbers.
    pub rate: C64,
}

impl LogDet {
    fn times<T: Number>(self, factor: T, power: f64) -> Self {
        let (size, phase) = factor.polar();
        LogDet {
            log_size: self.log_size + power * size,
            phase: self.phase + power * phase,
            rate: self.rate + factor.log_rate().scale(power),
        }
    }
}

/// The power of two nearest to `x^-1/2`, or its neighbour; 1 where x is no size.
#[inline]
fn inverse_root(x: f64) -> f64 {
    if !(x > 0.0 && x.is_finite()) {
        return 1.0;
    }
    let exponent = (x.to_bits() >> 52) as i64 - 1023;
    f64::from_bits(((1023 - (exponent + 1).div_euclid(2)) as u64) << 52)
}

/// Powers of two for rows and columns that bring the largest entries of both near one, from the row, the column and the size of entries, row by row.
fn scales(n: usize, entries: &[(usize, usize, f64)]) -> (Vec<f64>, Vec<f64>) {
    let (mut rows, mut columns) = (vec![1.0; n], vec![1.0; n]);
    let (mut by_row, mut by_column) = (vec![0.0f64; n], vec![0.0f64; n]);
    for _ in 0..SCALINGS {
        by_row.fill(0.0);
        by_column.fill(0.0);
        for row in entries.chunk_by(|a, b| a.0 == b.0) {
            let (i, mut largest) = (row[0].0, 0.0f64);
            let scale = rows[i];
            for &(_, j, size) in row {
                let x = size * scale * columns[j];
                largest = largest.max(x);
                by_column[j] = by_column[j].max(x);
            }
            by_row[i] = by_row[i].max(largest);
        }
        let mut settled = true;
        for (scale, &size) in rows.iter_mut().zip(&by_row).chain(columns.iter_mut().zip(&by_column)) {
            let more = inverse_root(size);
            settled &= more == 1.0;
            *scale *= more;
        }
        if settled {
            break;
        }
    }
    (rows, columns)
}

/// One factorisation. Reusable: [`Factors::factor`] keeps its allocations.
#[derive(Clone, Debug)]
pub struct Factors<T> {
    plan: Option<Plan>,
    dense: Lu<T>,
    matrix: Mat<T>,
    band: Banded<T>,
    /// Band^-1 times the columns of the border, one after the other.
    right: Vec<T>,
    /// Rows of the border, one after the other.
    below: Vec<T>,
    corner: Lu<T>,
    /// Powers of two that rows and columns were multiplied by.
    rows: Vec<f64>,
    columns: Vec<f64>,
    /// Entries that are not zero, in rows: row, column, place in the pattern, value.
    entries: Vec<(usize, usize, usize, T)>,
}

impl<T: Number> Default for Factors<T> {
    fn default() -> Self {
        Factors {
            plan: None,
            dense: Lu::default(),
            matrix: Mat::default(),
            band: Banded::default(),
            right: Vec::new(),
            below: Vec::new(),
            corner: Lu::default(),
            rows: Vec::new(),
            columns: Vec::new(),
            entries: Vec::new(),
        }
    }
}

impl<T: Number> Factors<T> {
    /// Factors a matrix whose entries stand in the order of the pattern.
    ///
    /// # Errors
    /// A singular matrix, or an entry that is not finite.
    pub fn new(plan: &Plan, values: &[T]) -> Result<Self, Singular> {
        let mut out = Self::default();
        out.factor(plan, values)?;
        Ok(out)
    }

    /// The same into this object.
    ///
    /// # Errors
    /// As [`Factors::new`].
    pub fn factor(&mut self, plan: &Plan, values: &[T]) -> Result<(), Singular> {
        assert_eq!(values.len(), plan.pattern.entries(), "entries differ from the pattern");
        if self.plan.as_ref().is_none_or(|p| !std::sync::Arc::ptr_eq(&p.pattern, &plan.pattern)) {
            self.plan = Some(plan.clone());
        }
        self.band.replaced.clear();
        self.rows.clear();
        self.columns.clear();
        let n = plan.n();
        let Some(band) = &plan.band else {
            self.matrix.reset(n, n);
            for i in 0..n {
                for (e, j) in plan.pattern.row(i) {
                    self.matrix[(i, j)] = values[e];
                }
            }
            return self.dense.factor(&self.matrix);
        };
        let (inner, border) = (band.inner, n - band.inner);
        spend(plan.multiplications() * (size_of::<T>() / size_of::<f64>()).pow(2) as u64);
        self.band.reset(inner, band.half);
        crate::refill::refill(&mut self.right, border * inner, T::ZERO);
        crate::refill::refill(&mut self.below, border * inner, T::ZERO);
        let mut corner = Mat::zeros(border, border);
        self.entries.clear();
        for i in 0..n {
            let row = plan.pattern.row(i).filter(|x| values[x.0] != T::ZERO);
            self.entries.extend(row.map(|(e, j)| (i, j, e, values[e])));
        }
        self.scale(n);
        for &(i, j, e, x) in &self.entries {
            let x = x.times(self.rows[i] * self.columns[j]);
            match band.targets[e] {
                Target::Band(at) => self.band.set(at, x),
                Target::Right(r, c) => self.right[c * inner + r] = x,
                Target::Below(r, c) => self.below[r * inner + c] = x,
                Target::Corner(r, c) => corner[(r, c)] = x,
            }
        }
        let least = if border > 0 { REPLACED } else { 0.0 };
        let unknown = |s: Singular| Singular { column: band.order[s.column] };
        self.band.factor(least).map_err(unknown)?;
        if border == 0 {
            return Ok(());
        }
        for column in self.right.chunks_exact_mut(inner) {
            self.band.solve(column);
        }
        for (i, row) in self.below.chunks_exact(inner).enumerate() {
            for (j, column) in self.right.chunks_exact(inner).enumerate() {
                for (&a, &b) in row.iter().zip(column) {
                    corner[(i, j)] -= a * b;
                }
            }
        }
        self.corner.factor(&corner).map_err(|s| Singular { column: band.order[inner + s.column] })
    }

    fn scale(&mut self, n: usize) {
        let sizes: Vec<(usize, usize, f64)> = self.entries.iter().map(|x| (x.0, x.1, x.3.size())).collect();
        (self.rows, self.columns) = scales(n, &sizes);
    }

    /// Solves `A x = b` in place.
    pub fn solve(&self, b: &mut [T]) {
        self.with_correction(b, false, |x| self.solve_once(x));
    }

    /// Solves `A^T x = b` in place.
    pub fn solve_transposed(&self, b: &mut [T]) {
        self.with_correction(b, true, |x| self.solve_transposed_once(x));
    }

    /// The same without corrections: of a matrix with a border digits may be lost.
    pub fn solve_roughly(&self, b: &mut [T]) {
        self.solve_once(b);
    }

    /// Solves `A^T x = b` in place, without corrections.
    pub fn solve_transposed_roughly(&self, b: &mut [T]) {
        self.solve_transposed_once(b);
    }

    /// Solves and, of a matrix with a border, corrects with the original entries: elimination of the band before the border may lose digits.
    fn with_correction(&self, b: &mut [T], transposed: bool, solve: impl Fn(&mut [T])) {
        if !self.plan.as_ref().is_some_and(Plan::has_border) {
            return solve(b);
        }
        let right = b.to_vec();
        solve(b);
        let (mut last, mut rest, mut size) = (f64::INFINITY, right.clone(), vec![0.0; right.len()]);
        for _ in 0..CORRECTIONS {
            rest.copy_from_slice(&right);
            size.iter_mut().zip(&right).for_each(|(s, x)| *s = x.size());
            for &(i, j, _, x) in &self.entries {
                let (row, column) = if transposed { (j, i) } else { (i, j) };
                rest[row] -= x * b[column];
                size[row] += x.size() * b[column].size();
            }
            // rounding of each equation
            let worst = rest.iter().zip(&size).map(|(r, s)| if *s > 0.0 { r.size() / s } else { 0.0 }).fold(0.0, f64::max);
            if worst <= 2.0 * f64::EPSILON || !(worst < 0.5 * last) {
                return;
            }
            last = worst;
            solve(&mut rest);
            b.iter_mut().zip(&rest).for_each(|(x, r)| *x += *r);
        }
    }

    fn solve_once(&self, b: &mut [T]) {
        let Some(band) = self.plan.as_ref().and_then(|p| p.band.as_ref()) else { return self.dense_solve(b, false) };
        let inner = band.inner;
        let mut x: Vec<T> = band.order.iter().map(|&i| b[i].times(self.rows[i])).collect();
        let (top, end) = x.split_at_mut(inner);
        self.band.solve(top);
        if !end.is_empty() {
            for (e, row) in end.iter_mut().zip(self.below.chunks_exact(inner)) {
                row.iter().zip(&*top).for_each(|(&a, &t)| *e -= a * t);
            }
            self.corner.solve(end);
            for (&e, column) in end.iter().zip(self.right.chunks_exact(inner)) {
                top.iter_mut().zip(column).for_each(|(t, &w)| *t -= w * e);
            }
        }
        band.order.iter().zip(x).for_each(|(&i, x)| b[i] = x.times(self.columns[i]));
    }

    fn solve_transposed_once(&self, b: &mut [T]) {
        let Some(band) = self.plan.as_ref().and_then(|p| p.band.as_ref()) else { return self.dense_solve(b, true) };
        let inner = band.inner;
        let mut x: Vec<T> = band.order.iter().map(|&i| b[i].times(self.columns[i])).collect();
        let (top, end) = x.split_at_mut(inner);
        if !end.is_empty() {
            // S^T e = end - W^T top, then B^T t = top - F^T e
            for (e, column) in end.iter_mut().zip(self.right.chunks_exact(inner)) {
                column.iter().zip(&*top).for_each(|(&w, &t)| *e -= w * t);
            }
            self.corner.solve_transposed(end);
            for (&e, row) in end.iter().zip(self.below.chunks_exact(inner)) {
                top.iter_mut().zip(row).for_each(|(t, &a)| *t -= a * e);
            }
        }
        self.band.solve_transposed(top);
        band.order.iter().zip(x).for_each(|(&i, x)| b[i] = x.times(self.rows[i]));
    }

    fn dense_solve(&self, b: &mut [T], transposed: bool) {
        if transposed { self.dense.solve_transposed(b) } else { self.dense.solve(b) }
    }

    /// Solves `A X = B` in place, row by row of `B`.
    pub fn solve_mat(&self, b: &mut Mat<T>) {
        let banded = self.plan.as_ref().is_some_and(|p| p.band.is_some());
        if !banded {
            return self.dense.solve_mat(b);
        }
        let mut column = vec![T::ZERO; b.rows()];
        for j in 0..b.cols() {
            column.iter_mut().enumerate().for_each(|(i, x)| *x = b[(i, j)]);
            self.solve(&mut column);
            column.iter().enumerate().for_each(|(i, x)| b[(i, j)] = *x);
        }
    }

    /// Pivots, and whether an odd number of rows was exchanged.
    fn pivots(&self) -> (Vec<T>, bool) {
        let band = self.plan.as_ref().and_then(|p| p.band.as_ref());
        let (dense, odd) = if band.is_some() { self.corner.pivots() } else { self.dense.pivots() };
        if band.is_some() { (self.band.pivots().chain(dense).collect(), odd != self.band.odd) } else { (dense.collect(), odd) }
    }

    /// Determinant.
    pub fn log_det(&self) -> LogDet {
        let (pivots, odd) = self.pivots();
        let start = LogDet { phase: if odd { std::f64::consts::PI } else { 0.0 }, ..LogDet::default() };
        let mut whole = pivots.iter().fold(start, |d, p| d.times(*p, 1.0));
        whole.log_size -= self.rows.iter().chain(&self.columns).map(|x| x.ln()).sum::<f64>();
        self.replacement().map_or(whole, |r| whole.times(r, -1.0))
    }

    /// Determinant of the matrix with replaced pivots over that of the matrix: `det(1 + D A^-1)` over the places of what was added, A as it was scaled.
    fn replacement(&self) -> Option<T> {
        let added = &self.band.replaced;
        let band = self.plan.as_ref()?.band.as_ref().filter(|_| !added.is_empty())?;
        let mut small = Mat::identity(added.len());
        for (j, &(row, ..)) in added.iter().enumerate() {
            let mut x = vec![T::ZERO; band.order.len()];
            x[band.order[row]] = T::real(1.0 / self.rows[band.order[row]]);
            self.solve(&mut x);
            for (i, &(_, column, d)) in added.iter().enumerate() {
                small[(i, j)] += d * x[band.order[column]] * T::real(1.0 / self.columns[band.order[column]]);
            }
        }
        Some(Lu::new(&small).map_or(T::ZERO, |lu| lu.det()))
    }

    /// Smallest over largest pivot: a cheap sign of near singularity.
    pub fn pivot_ratio(&self) -> f64 {
        let sizes = self.pivots().0.into_iter().map(|p| p.size());
        let (lo, hi) = sizes.fold((f64::INFINITY, 0.0f64), |(lo, hi), x| (lo.min(x), hi.max(x)));
        lo / hi
    }
}
