//! LU factors of a band with row exchanges, column by column (the layout of LAPACK's `gbtrf`).

use super::Number;
use super::plan::{stored, width};
use crate::dense::Singular;
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use std::marker::PhantomData;

/// Factors of a band; reusable.
#[derive(Clone, Debug)]
pub(super) struct Banded<T> {
    pub n: usize,
    pub half: usize,
    /// Columns of `width(half)` numbers by their parts: U on and above the diagonal, the multipliers below; [`LANES`] more at the end.
    pub data: Vec<f64>,
    /// The multipliers of one column times each unit of a number.
    multipliers: Vec<f64>,
    /// Row exchanged with each.
    pub rows: Vec<usize>,
    pub odd: bool,
    /// Diagonals above the middle one: those of the matrix, and those that row exchanges have filled.
    pub above: usize,
    /// Pivots that were replaced: row and column of the matrix, and what was added there.
    pub replaced: Vec<(usize, usize, T)>,
    number: PhantomData<T>,
}

impl<T> Default for Banded<T> {
    fn default() -> Self {
        let none = Vec::new;
        Banded {
            n: 0,
            half: 0,
            data: none(),
            multipliers: none(),
            rows: vec![],
            odd: false,
            above: 0,
            replaced: vec![],
            number: PhantomData,
        }
    }
}

/// `x -= l u` over the columns right of a pivot, l the multipliers, u the number of each column in the row of the pivot:
///
/// ```text
/// l u = sum over the parts of u (part) (l times the unit of the part)
/// ```
///
/// Multipliers are padded with zeros to whole lanes, so that numbers behind those of a column keep their values.
struct Eliminate<'a, T> {
    /// From the first number u on.
    columns: &'a mut [f64],
    /// Of one column.
    multipliers: &'a [f64],
    /// From one number u to the next.
    stride: usize,
    count: usize,
    number: PhantomData<T>,
}

impl<T: Number> Kernel for Eliminate<'_, T> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let padded = self.multipliers.len() / T::PARTS;
        for j in 0..self.count {
            let (u, below) = self.columns[j * self.stride..][..T::PARTS + padded].split_at_mut(T::PARTS);
            let mut all_zero = true;
            for c in 0..T::PARTS {
                all_zero &= u[c] == 0.0;
            }
            if all_zero {
                continue;
            }
            let below = below.as_chunks_mut::<LANES>().0;
            for (k, x) in below.iter_mut().enumerate() {
                let of_unit = |c: usize| &self.multipliers[c * padded + k * LANES..].as_chunks::<LANES>().0[0];
                let mut product = S::load(of_unit(0)) * S::cst(u[0]);
                for c in 1..T::PARTS {
                    product += S::load(of_unit(c)) * S::cst(u[c]);
                }
                (S::load(x) - product).store(x);
            }
        }
    }
}

impl<T: Number> Banded<T> {
    /// Zeros.
    pub fn reset(&mut self, n: usize, half: usize) {
        (self.n, self.half) = (n, half);
        let padded = (half * T::PARTS).next_multiple_of(LANES);
        crate::refill::refill(&mut self.data, n * width(half) * T::PARTS + padded, 0.0);
        crate::refill::refill(&mut self.multipliers, padded * T::PARTS, 0.0);
    }

    #[inline(always)]
    fn get(&self, at: usize) -> T {
        T::read(&self.data[at * T::PARTS..(at + 1) * T::PARTS])
    }

    /// Writes a number to a place of the storage.
    #[inline(always)]
    pub fn set(&mut self, at: usize, x: T) {
        x.write(&mut self.data[at * T::PARTS..(at + 1) * T::PARTS]);
    }

    /// Some numbers that follow each other in the storage.
    #[inline(always)]
    fn some(&self, from: usize, count: usize) -> impl Iterator<Item = T> {
        self.data[from * T::PARTS..(from + count) * T::PARTS].chunks_exact(T::PARTS).map(T::read)
    }

    /// Factors what the storage holds. A pivot below `least` is replaced where that is positive; otherwise a column without a pivot is an error.
    pub fn factor(&mut self, least: f64) -> Result<(), Singular> {
        let (n, half, w) = (self.n, self.half, width(self.half));
        let (diagonal, padded) = (2 * half, self.multipliers.len() / T::PARTS);
        self.rows.clear();
        (self.odd, self.above) = (false, half.min(n.saturating_sub(1)));
        self.replaced.clear();
        let level = Level::best();
        let mut order: Vec<usize> = (0..n).collect();
        // the last column that row exchanges have reached
        let mut reach = 0;
        for k in 0..n {
            let below = half.min(n - 1 - k);
            let base = k * w + diagonal;
            let (mut p, mut best) = (0, -1.0);
            for (i, x) in self.some(base, below + 1).enumerate() {
                let size = x.size();
                if size > best {
                    (p, best) = (i, size);
                }
            }
            if !best.is_finite() || (best <= 0.0 && !(least > 0.0)) {
                return Err(Singular { column: k });
            }
            if best < least {
                p = 0;
                self.replaced.push((order[k], k, T::real(least) - self.get(base)));
                self.set(base, T::real(least));
            }
            self.rows.push(k + p);
            order.swap(k, k + p);
            reach = reach.max((k + p + half).min(n - 1));
            self.above = self.above.max(reach - k);
            if p != 0 {
                self.odd = !self.odd;
                for j in k..=reach {
                    let at = j * w + diagonal + k - j;
                    let (a, b) = (self.get(at), self.get(at + p));
                    self.set(at, b);
                    self.set(at + p, a);
                }
            }
            let inverse = T::ONE / self.get(base);
            self.multipliers.fill(0.0);
            for i in 0..below {
                let l = self.get(base + 1 + i) * inverse;
                self.set(base + 1 + i, l);
                for c in 0..T::PARTS {
                    (l * T::unit(c)).write(&mut self.multipliers[c * padded + i * T::PARTS..][..T::PARTS]);
                }
            }
            if reach > k {
                let columns = &mut self.data[((k + 1) * w + diagonal - 1) * T::PARTS..];
                let (stride, count, multipliers) = ((w - 1) * T::PARTS, reach - k, &self.multipliers[..]);
                dispatch(level, Eliminate::<T> { columns, multipliers, stride, count, number: PhantomData });
            }
        }
        Ok(())
    }

    /// Pivots in order.
    pub fn pivots(&self) -> impl Iterator<Item = T> {
        (0..self.n).map(|k| self.get(stored(self.half, k, k)))
    }

    /// Solves in place.
    pub fn solve(&self, b: &mut [T]) {
        let (n, half, w) = (self.n, self.half, width(self.half));
        let diagonal = 2 * half;
        for k in 0..n {
            b.swap(k, self.rows[k]);
            let below = half.min(n - 1 - k);
            let x = b[k];
            if x != T::ZERO {
                for (r, l) in b[k + 1..=k + below].iter_mut().zip(self.some(k * w + diagonal + 1, below)) {
                    *r -= l * x;
                }
            }
        }
        for k in (0..n).rev() {
            let base = k * w + diagonal;
            let above = self.above.min(k);
            let x = b[k] / self.get(base);
            b[k] = x;
            if x != T::ZERO {
                for (r, u) in b[k - above..k].iter_mut().zip(self.some(base - above, above)) {
                    *r -= u * x;
                }
            }
        }
    }

    /// Solves with the transposed matrix in place.
    pub fn solve_transposed(&self, b: &mut [T]) {
        let (n, half, w) = (self.n, self.half, width(self.half));
        let diagonal = 2 * half;
        for k in 0..n {
            let base = k * w + diagonal;
            let above = self.above.min(k);
            let mut x = b[k];
            for (&r, u) in b[k - above..k].iter().zip(self.some(base - above, above)) {
                x -= u * r;
            }
            b[k] = x / self.get(base);
        }
        for k in (0..n).rev() {
            let below = half.min(n - 1 - k);
            let mut x = b[k];
            for (&r, l) in b[k + 1..=k + below].iter().zip(self.some(k * w + diagonal + 1, below)) {
                x -= l * r;
            }
            b[k] = x;
            b.swap(k, self.rows[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Directed;
    use super::*;
    use crate::complex::{C64, c};
    use crate::dual::Dual;

    /// At every level the bits of each level, and `x - l u` of the numbers; what follows a column stays.
    fn eliminated<T: Number>(exact: bool, mut value: impl FnMut() -> T) {
        let (half, count) = (7, 9);
        let stride = (width(half) - 1) * T::PARTS;
        let padded = (half * T::PARTS).next_multiple_of(LANES);
        let mut columns = vec![0.0; count * stride + padded + T::PARTS];
        columns.chunks_exact_mut(T::PARTS).for_each(|x| value().write(x));
        columns[3 * stride..][..T::PARTS].fill(0.0);
        let l: Vec<T> = (0..half).map(|_| value()).collect();
        let mut multipliers = vec![0.0; padded * T::PARTS];
        for (i, &l) in l.iter().enumerate() {
            (0..T::PARTS).for_each(|c| (l * T::unit(c)).write(&mut multipliers[c * padded + i * T::PARTS..][..T::PARTS]));
        }
        let mut expected = columns.clone();
        for j in 0..count {
            let of = |i: usize| j * stride + i * T::PARTS;
            let u = T::read(&columns[of(0)..of(1)]);
            for (i, &l) in l.iter().enumerate() {
                (T::read(&columns[of(i + 1)..of(i + 2)]) - l * u).write(&mut expected[of(i + 1)..of(i + 2)]);
            }
        }
        let all: Vec<Vec<f64>> = Level::supported()
            .map(|level| {
                let mut own = columns.clone();
                let kernel = Eliminate::<T> { columns: &mut own, multipliers: &multipliers, stride, count, number: PhantomData };
                dispatch(level, kernel);
                own
            })
            .collect();
        for own in &all {
            assert_eq!(own, &all[0]);
            for (x, e) in own.iter().zip(&expected) {
                assert!(if exact { x == e } else { (x - e).abs() <= 4.0 * f64::EPSILON }, "{x} {e}");
            }
        }
    }

    #[test]
    fn elimination_in_lanes_is_that_of_the_numbers() {
        let mut seed = 3u64;
        let mut random = move || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        eliminated::<f64>(true, &mut random);
        eliminated::<C64>(true, || c(random(), random()));
        eliminated::<Directed>(false, || c(Dual { re: random(), eps: [random()] }, Dual { re: random(), eps: [random()] }));
    }
}
