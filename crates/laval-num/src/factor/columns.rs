//! Solutions for several right-hand sides of one matrix side by side: real parts, then imaginary parts, of half as many columns as there are lanes.

use super::Factors;
use super::banded::Banded;
use super::lanes::Row;
use super::plan::{Band, width};
use super::sum::Sum;
use super::terms::{CORRECTIONS, Terms, is_last, lessens};
use crate::complex::{C64, c};
use crate::dense::{Field, Mat};
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::refill::refill;
use crate::work::spend;

/// Columns side by side.
const COLUMNS: usize = LANES / 2;

/// Storage of solutions; reusable.
#[derive(Clone, Debug, Default)]
pub struct Columns {
    x: Vec<Row>,
    right: Vec<Row>,
    rest: Vec<Row>,
    /// Rows of a band in its order.
    ordered: Vec<Row>,
    /// Every row of the solution times the factor of each term.
    scaled: Vec<Row>,
}

impl Columns {
    /// Solves `A X = B` in place, A as its terms say, with approximate factors, as [`Terms::solve`] does each column.
    pub fn solve(&mut self, terms: &Terms<f64>, factors: &Factors<C64>, b: &mut Mat<C64>) {
        let Some(band) = factors.plan.as_ref().and_then(|p| p.band.as_ref()).filter(|band| band.inner == b.rows()) else {
            return one_by_one(terms, factors, b);
        };
        for from in (0..b.cols()).step_by(COLUMNS) {
            let count = COLUMNS.min(b.cols() - from);
            refill(&mut self.x, b.rows(), [0.0; LANES]);
            for (i, x) in self.x.iter_mut().enumerate() {
                for (l, z) in b.row(i)[from..from + count].iter().enumerate() {
                    (x[l], x[COLUMNS + l]) = (z.re, z.im);
                }
            }
            self.corrected(terms, factors, band);
            for (i, x) in self.x.iter().enumerate() {
                for (l, z) in b.row_mut(i)[from..from + count].iter_mut().enumerate() {
                    *z = c(x[l], x[COLUMNS + l]);
                }
            }
        }
    }

    /// Solves for what stands in `x`.
    fn corrected(&mut self, terms: &Terms<f64>, factors: &Factors<C64>, band: &Band) {
        let Columns { x, right, rest, ordered, scaled } = self;
        right.clone_from(x);
        solve(factors, band, x, ordered);
        let (mut last, mut active) = ([f64::INFINITY; COLUMNS], [true; COLUMNS]);
        for _ in 0..CORRECTIONS {
            residual(terms, x, right, scaled, rest);
            solve(factors, band, rest, ordered);
            let (more, size) = (largest(rest), largest(x));
            let change: [f64; COLUMNS] = std::array::from_fn(|l| more[l] / size[l]);
            let now: [bool; COLUMNS] = std::array::from_fn(|l| active[l] && lessens(change[l], last[l]));
            let share: Row = std::array::from_fn(|l| f64::from(u8::from(now[l % COLUMNS])));
            dispatch(Level::best(), Add { x, more: rest, share: &share });
            active = std::array::from_fn(|l| now[l] && !is_last(change[l], last[l]));
            last = change;
            if active == [false; COLUMNS] {
                return;
            }
        }
    }
}

fn one_by_one(terms: &Terms<f64>, factors: &Factors<C64>, b: &mut Mat<C64>) {
    let mut column = vec![C64::ZERO; b.rows()];
    for j in 0..b.cols() {
        column.iter_mut().enumerate().for_each(|(i, x)| *x = b[(i, j)]);
        terms.solve(factors, &mut column);
        column.iter().enumerate().for_each(|(i, x)| b[(i, j)] = *x);
    }
}

/// Largest real or imaginary part of each column; NaN stays.
fn largest(x: &[Row]) -> [f64; COLUMNS] {
    let parts = dispatch(Level::best(), Largest(x));
    std::array::from_fn(|l| {
        let (re, im) = (parts[l], parts[COLUMNS + l]);
        if re > im || re.is_nan() { re } else { im }
    })
}

struct Largest<'a>(&'a [Row]);

impl Kernel for Largest<'_> {
    type Out = Row;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Row {
        let (mut most, mut nothing) = (S::zero(), S::zero());
        for x in self.0 {
            let size = S::load(x).abs();
            most = S::select(most.lt(size), size, most);
            // zero, but NaN where a number is infinite or NaN
            nothing += size.scale(0.0);
        }
        (most + nothing).to_array()
    }
}

/// Adds corrections to the columns whose share is one; those of share zero stay, whatever their correction.
struct Add<'a> {
    x: &'a mut [Row],
    more: &'a [Row],
    share: &'a Row,
}

impl Kernel for Add<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let now = S::zero().lt(S::load(self.share));
        for (x, more) in self.x.iter_mut().zip(self.more) {
            let own = S::load(x);
            S::select(now, own + S::load(more), own).store(x);
        }
    }
}

/// Times i.
#[inline(always)]
fn turned(x: &Row) -> Row {
    let mut out = [0.0; LANES];
    for l in 0..COLUMNS {
        (out[l], out[COLUMNS + l]) = (-x[COLUMNS + l], x[l]);
    }
    out
}

/// Solves in place by the factors of a band without a border.
fn solve(factors: &Factors<C64>, band: &Band, x: &mut [Row], ordered: &mut Vec<Row>) {
    ordered.clear();
    ordered.extend(band.order.iter().map(|&i| x[i].map(|x| x * factors.rows[i])));
    dispatch(Level::best(), Substitute { band: &factors.band, b: ordered });
    for (&i, from) in band.order.iter().zip(ordered) {
        x[i] = from.map(|x| x * factors.columns[i]);
    }
}

/// Solutions by the factors of a band in place.
struct Substitute<'a> {
    band: &'a Banded<C64>,
    b: &'a mut [Row],
}

impl Kernel for Substitute<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let Substitute { band, b } = self;
        let (n, half, w, data) = (band.n, band.half, width(band.half), &band.data);
        let diagonal = 2 * half;
        for k in 0..n {
            b.swap(k, band.rows[k]);
            let below = half.min(n - 1 - k);
            less::<S>(b, k, k + 1, &data[2 * (k * w + diagonal + 1)..][..2 * below]);
        }
        for k in (0..n).rev() {
            let base = k * w + diagonal;
            let above = band.above.min(k);
            let inverse = C64::ONE / c(data[2 * base], data[2 * base + 1]);
            (S::load(&b[k]).scale(inverse.re) + S::load(&turned(&b[k])).scale(inverse.im)).store(&mut b[k]);
            less::<S>(b, k, k - above, &data[2 * (base - above)..2 * base]);
        }
    }
}

/// Rows from `first` on less complex factors times row `k`.
#[inline(always)]
fn less<S: LaneScalar>(b: &mut [Row], k: usize, first: usize, factors: &[f64]) {
    let (x, ix) = (S::load(&b[k]), S::load(&turned(&b[k])));
    for (row, f) in b[first..].iter_mut().zip(factors.as_chunks::<2>().0) {
        (S::load(row) - x.scale(f[0]) - ix.scale(f[1])).store(row);
    }
}

/// `b - A x` of all columns, rounded once, into `rest`.
fn residual(terms: &Terms<f64>, x: &[Row], b: &[Row], scaled: &mut Vec<Row>, rest: &mut Vec<Row>) {
    scaled.resize(x.len() * terms.terms.len(), [0.0; LANES]);
    rest.resize(b.len(), [0.0; LANES]);
    let products = dispatch(Level::best(), Residual { terms, x, scaled, b, rest });
    spend(3 * (terms.terms.len() * terms.pattern.entries()) as u64 + 20 * products);
}

struct Residual<'a> {
    terms: &'a Terms<'a, f64>,
    x: &'a [Row],
    scaled: &'a mut [Row],
    b: &'a [Row],
    rest: &'a mut [Row],
}

impl Kernel for Residual<'_> {
    /// Products.
    type Out = u64;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> u64 {
        let Residual { terms: Terms { pattern, terms }, x, scaled, b, rest } = self;
        for (x, own) in x.iter().zip(scaled.chunks_exact_mut(terms.len())) {
            let (x, ix) = (S::load(x), S::load(&turned(x)));
            for ((f, _), own) in terms.iter().zip(own) {
                (x.scale(f.re) + ix.scale(f.im)).store(own);
            }
        }
        let mut products = 0;
        for i in 0..b.len() {
            let mut sum = Sum::of(S::load(&b[i]));
            for (e, j) in pattern.row(i) {
                let own = &scaled[j * terms.len()..][..terms.len()];
                for ((_, values), x) in terms.iter().zip(own) {
                    // most entries of masses and dampings are zero
                    if values[e] != 0.0 {
                        sum.add(S::cst(-values[e]), S::load(x));
                        products += 1;
                    }
                }
            }
            sum.value().store(&mut rest[i]);
        }
        products
    }
}

#[cfg(test)]
mod tests {
    use super::super::terms::EXACT;
    use super::super::{Pattern, Plan};
    use super::*;
    use std::sync::Arc;

    /// A chain of two directions, coupled, on a soft support; with a foundation that all links couple with a border follows the band.
    #[test]
    fn columns_are_solutions_of_their_own() {
        for foundation in [false, true] {
            let (links, n) = (150, 300 + usize::from(foundation));
            let pairs = (0..2 * links).flat_map(|i| [(i, i ^ 1), (i, (i + 2).min(2 * links - 1)), (i, if foundation { n - 1 } else { i })]);
            let pattern = Arc::new(Pattern::new(n, pairs));
            let [mut k, mut d, mut m] = [(); 3].map(|()| vec![0.0; pattern.entries()]);
            for i in 0..n {
                for (e, j) in pattern.row(i) {
                    let far = foundation && (i == n - 1 || j == n - 1);
                    k[e] = match i.abs_diff(j) {
                        0 => 2e10 + if i < 2 { -1e10 + 1e3 } else { 0.0 } - if i / 2 == links - 1 { 1e10 } else { 0.0 },
                        2 if !far => -1e10,
                        _ => 0.0,
                    };
                    d[e] = if far {
                        0.1
                    } else if j + 1 == i {
                        3.0
                    } else if i + 1 == j {
                        -2.5
                    } else {
                        0.0
                    };
                    m[e] = if i == j { 1.5 } else { 0.0 };
                }
            }
            let plan = Plan::new(&pattern);
            assert_eq!(plan.has_border(), foundation);
            let s = c(0.0, 1.7);
            let terms = [(C64::ONE, &k[..]), (s, &d[..]), (s * s, &m[..])];
            let terms = Terms { pattern: &pattern, terms: &terms };
            let sum: Vec<C64> = (0..k.len()).map(|e| c(k[e], 0.0) + s.scale(d[e]) + (s * s).scale(m[e])).collect();
            let factors = Factors::new(&plan, &sum).unwrap();
            // more columns than go side by side, one of them zero
            let columns = COLUMNS + 3;
            let start = Mat::from_fn(n, columns, |i, j| if j == 2 { C64::ZERO } else { C64::cis((i * (j + 1)) as f64) });
            let mut all = start.clone();
            Columns::default().solve(&terms, &factors, &mut all);
            for j in 0..columns {
                let of = |m: &Mat<C64>| (0..n).map(|i| m[(i, j)]).collect::<Vec<_>>();
                let (b, found, mut own) = (of(&start), of(&all), of(&start));
                terms.solve(&factors, &mut own);
                let size = own.iter().map(|x| x.abs()).fold(0.0, f64::max);
                let worst = own.iter().zip(&found).map(|(a, b)| (*a - *b).abs()).fold(0.0, f64::max);
                assert!(worst <= 2.0 * EXACT * size, "{foundation} {j}: {worst:e} of {size:e}");
                // one more correction is rounding
                let mut more = terms.residual(&found, &b);
                factors.solve(&mut more);
                let left = more.iter().map(|x| x.abs()).fold(0.0, f64::max);
                assert!(left <= EXACT * size, "{foundation} {j}: {left:e} of {size:e}");
                // by the factors alone more than rounding is wrong
                let mut rough = b.clone();
                factors.solve(&mut rough);
                let wrong = rough.iter().zip(&own).map(|(a, b)| (*a - *b).abs()).fold(0.0, f64::max);
                assert!(j == 2 || wrong > 1e-12 * size, "{foundation} {j}: {wrong:e} of {size:e}");
            }
        }
    }
}
