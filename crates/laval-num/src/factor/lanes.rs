//! LU factors of as many matrices `T(s) = A0 + s A1 + s^2 A2` as there are lanes, each at an s of its own.
//!
//! Every lane exchanges rows by its own pivots; otherwise the steps are those of one band with a border.

use super::Directed;
use super::plan::{Plan, Target, effort, stored, width};
use super::quadratic::{ScaledQuadratic, Term};
use crate::complex::{C64, Complex, c};
use crate::contour::Sample;
use crate::dual::Dual;
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::refill::refill;
use crate::work::spend;
use std::fmt::Debug;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Sub};

#[cfg(test)]
mod tests;

/// A real number for each lane.
pub type Row = [f64; LANES];
/// A complex number for each lane: real parts, imaginary parts.
pub type Pair = [Row; 2];

/// An entry of the diagonal is the pivot unless another of its column is larger than it by one over this: exchanges in one lane fill the band in all.
const THRESHOLD: f64 = 0.125;
/// Pivot of the band, over the size one of the largest entries, below which what is eliminated before a border has lost too many digits.
const SMALL: f64 = 1e-8;

/// A number that is factored in lanes: [`C64`], or [`Directed`], which holds the derivative over s.
pub trait InLanes: Copy + Debug {
    /// Real numbers that it is made of.
    const PARTS: usize;
    /// The number for all lanes.
    #[doc(hidden)]
    type Of<S: LaneScalar>: Copy
        + Add<Output = Self::Of<S>>
        + Sub<Output = Self::Of<S>>
        + Mul<Output = Self::Of<S>>
        + Div<Output = Self::Of<S>>;
    #[doc(hidden)]
    fn one<S: LaneScalar>() -> Self::Of<S>;
    #[doc(hidden)]
    fn load<S: LaneScalar>(from: &[Row]) -> Self::Of<S>;
    #[doc(hidden)]
    fn store<S: LaneScalar>(x: Self::Of<S>, to: &mut [Row]);
    #[doc(hidden)]
    fn select<S: LaneScalar>(mask: S::Mask, a: Self::Of<S>, b: Self::Of<S>) -> Self::Of<S>;
    /// The number without its derivative, and the derivative over it.
    #[doc(hidden)]
    fn value<S: LaneScalar>(x: Self::Of<S>) -> (Complex<S>, Complex<S>);
    /// An entry at s.
    #[doc(hidden)]
    fn at<S: LaneScalar>(s: Complex<S>, values: &[C64; 3]) -> Self::Of<S>;
}

#[inline(always)]
fn constant<S: LaneScalar>(z: C64) -> Complex<S> {
    c(S::cst(z.re), S::cst(z.im))
}

#[inline(always)]
fn size<S: LaneScalar>(z: Complex<S>) -> S {
    z.re.abs() + z.im.abs()
}

impl InLanes for C64 {
    const PARTS: usize = 2;
    type Of<S: LaneScalar> = Complex<S>;
    #[inline(always)]
    fn one<S: LaneScalar>() -> Complex<S> {
        Complex::one()
    }
    #[inline(always)]
    fn load<S: LaneScalar>(from: &[Row]) -> Complex<S> {
        c(S::load(&from[0]), S::load(&from[1]))
    }
    #[inline(always)]
    fn store<S: LaneScalar>(x: Complex<S>, to: &mut [Row]) {
        x.re.store(&mut to[0]);
        x.im.store(&mut to[1]);
    }
    #[inline(always)]
    fn select<S: LaneScalar>(mask: S::Mask, a: Complex<S>, b: Complex<S>) -> Complex<S> {
        c(S::select(mask, a.re, b.re), S::select(mask, a.im, b.im))
    }
    #[inline(always)]
    fn value<S: LaneScalar>(x: Complex<S>) -> (Complex<S>, Complex<S>) {
        (x, Complex::zero())
    }
    #[inline(always)]
    fn at<S: LaneScalar>(s: Complex<S>, values: &[C64; 3]) -> Complex<S> {
        constant::<S>(values[0]) + s * (constant::<S>(values[1]) + s * constant::<S>(values[2]))
    }
}

impl InLanes for Directed {
    const PARTS: usize = 4;
    type Of<S: LaneScalar> = Complex<Dual<S, 1>>;
    #[inline(always)]
    fn one<S: LaneScalar>() -> Self::Of<S> {
        Complex::one()
    }
    #[inline(always)]
    fn load<S: LaneScalar>(from: &[Row]) -> Self::Of<S> {
        let of = |k: usize| Dual { re: S::load(&from[k]), eps: [S::load(&from[k + 2])] };
        c(of(0), of(1))
    }
    #[inline(always)]
    fn store<S: LaneScalar>(x: Self::Of<S>, to: &mut [Row]) {
        x.re.re.store(&mut to[0]);
        x.im.re.store(&mut to[1]);
        x.re.eps[0].store(&mut to[2]);
        x.im.eps[0].store(&mut to[3]);
    }
    #[inline(always)]
    fn select<S: LaneScalar>(mask: S::Mask, a: Self::Of<S>, b: Self::Of<S>) -> Self::Of<S> {
        let of = |a: Dual<S, 1>, b: Dual<S, 1>| Dual { re: S::select(mask, a.re, b.re), eps: [S::select(mask, a.eps[0], b.eps[0])] };
        c(of(a.re, b.re), of(a.im, b.im))
    }
    #[inline(always)]
    fn value<S: LaneScalar>(x: Self::Of<S>) -> (Complex<S>, Complex<S>) {
        let value = c(x.re.re, x.im.re);
        (value, c(x.re.eps[0], x.im.eps[0]) / value)
    }
    #[inline(always)]
    fn at<S: LaneScalar>(s: Complex<S>, values: &[C64; 3]) -> Self::Of<S> {
        let [a0, a1, a2] = [constant::<S>(values[0]), constant::<S>(values[1]), constant::<S>(values[2])];
        let high = s * a2;
        let (value, slope) = (a0 + s * (a1 + high), a1 + high + high);
        c(Dual { re: value.re, eps: [slope.re] }, Dual { re: value.im, eps: [slope.im] })
    }
}

/// A band in every lane, in the order of [`stored`], and its factors.
#[derive(Clone, Debug, Default)]
struct Band {
    n: usize,
    half: usize,
    data: Vec<Row>,
    /// How far below each row the one stood that it was exchanged with.
    exchanged: Vec<Row>,
    /// 1 or -1 by the number of exchanges.
    sign: Row,
    /// Diagonals above the middle one that exchanges have filled.
    above: usize,
}

impl Band {
    fn reset(&mut self, n: usize, half: usize, parts: usize) {
        (self.n, self.half, self.sign) = (n, half, [1.0; LANES]);
        self.data.resize(n * width(half) * parts, [0.0; LANES]);
        // what only exchanges fill is cleared at the first of them
        self.data.chunks_exact_mut(width(half) * parts).for_each(|column| column[half * parts..].fill([0.0; LANES]));
        refill(&mut self.exchanged, n, [0.0; LANES]);
    }
}

/// Where the offset is this one.
#[inline(always)]
fn is<S: LaneScalar>(offset: S, i: usize) -> S::Mask {
    (offset - S::cst(i as f64)).abs().lt(S::cst(0.5))
}

struct Factor<'a, N> {
    band: &'a mut Band,
    number: PhantomData<N>,
}

impl<N: InLanes> Kernel for Factor<'_, N> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let Band { n, half, data, exchanged, sign, above } = self.band;
        let (n, half, p) = (*n, *half, N::PARTS);
        let (w, diagonal) = (width(half), 2 * half);
        let mut parity = S::load(sign);
        let mut reach = 0;
        *above = half;
        for k in 0..n {
            let below = half.min(n - 1 - k);
            let base = k * w + diagonal;
            let own = size(N::value::<S>(N::load::<S>(&data[base * p..])).0);
            let (mut best, mut offset) = (own, S::zero());
            for i in 1..=below {
                let other = size(N::value::<S>(N::load::<S>(&data[(base + i) * p..])).0);
                let larger = best.lt(other);
                best = S::select(larger, other, best);
                offset = S::select(larger, S::cst(i as f64), offset);
            }
            offset = S::select(own.lt(best.scale(THRESHOLD)), offset, S::zero());
            offset.store(&mut exchanged[k]);
            let farthest = exchanged[k].iter().fold(0.0, |m: f64, x| if *x > m { *x } else { m }) as usize;
            reach = reach.max((k + farthest + half).min(n - 1));
            if *above == half && reach - k > half {
                for column in data.chunks_exact_mut(w * p) {
                    for x in &mut column[..half * p] {
                        *x = [0.0; LANES];
                    }
                }
            }
            *above = (*above).max(reach - k);
            for i in 1..=farthest {
                let mask = is(offset, i);
                if !S::bits(mask).any() {
                    continue;
                }
                for j in k..=reach {
                    let at = (j * w + diagonal + k - j) * p;
                    let (a, b) = (N::load::<S>(&data[at..]), N::load::<S>(&data[at + i * p..]));
                    N::store::<S>(N::select::<S>(mask, b, a), &mut data[at..]);
                    N::store::<S>(N::select::<S>(mask, a, b), &mut data[at + i * p..]);
                }
                parity = S::select(mask, -parity, parity);
            }
            let inverse = N::one::<S>() / N::load::<S>(&data[base * p..]);
            for i in 1..=below {
                let at = (base + i) * p;
                N::store::<S>(N::load::<S>(&data[at..]) * inverse, &mut data[at..]);
            }
            let (own, right) = data.split_at_mut((k + 1) * w * p);
            let multipliers = &own[(base + 1) * p..(base + 1 + below) * p];
            for j in k + 1..=reach {
                let at = ((j - k - 1) * w + diagonal + k - j) * p;
                let (u, column) = right[at..at + (1 + below) * p].split_at_mut(p);
                let u = N::load::<S>(u);
                for (l, x) in multipliers.chunks_exact(p).zip(column.chunks_exact_mut(p)) {
                    let less = N::load::<S>(x) - N::load::<S>(l) * u;
                    N::store::<S>(less, x);
                }
            }
        }
        parity.store(sign);
    }
}

/// Solves with the factors of a band in place.
struct Solve<'a, N> {
    band: &'a Band,
    b: &'a mut [Row],
    transposed: bool,
    number: PhantomData<N>,
}

impl<N: InLanes> Solve<'_, N> {
    #[inline(always)]
    fn exchange<S: LaneScalar>(&mut self, k: usize) {
        let (p, exchanged) = (N::PARTS, &self.band.exchanged[k]);
        let farthest = exchanged.iter().fold(0.0, |m: f64, x| if *x > m { *x } else { m }) as usize;
        for i in 1..=farthest {
            let mask = is(S::load(exchanged), i);
            let (at, other) = (k * p, (k + i) * p);
            let (a, b) = (N::load::<S>(&self.b[at..]), N::load::<S>(&self.b[other..]));
            N::store::<S>(N::select::<S>(mask, b, a), &mut self.b[at..]);
            N::store::<S>(N::select::<S>(mask, a, b), &mut self.b[other..]);
        }
    }
}

impl<N: InLanes> Kernel for Solve<'_, N> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(mut self) {
        let (n, half, p) = (self.band.n, self.band.half, N::PARTS);
        let (w, diagonal) = (width(half), 2 * half);
        let data = &self.band.data;
        if self.transposed {
            for k in 0..n {
                let base = k * w + diagonal;
                let above = self.band.above.min(k);
                let mut x = N::load::<S>(&self.b[k * p..]);
                for i in 0..above {
                    let u = N::load::<S>(&data[(base - above + i) * p..]);
                    x = x - u * N::load::<S>(&self.b[(k - above + i) * p..]);
                }
                N::store::<S>(x / N::load::<S>(&data[base * p..]), &mut self.b[k * p..]);
            }
            for k in (0..n).rev() {
                let below = half.min(n - 1 - k);
                let mut x = N::load::<S>(&self.b[k * p..]);
                for i in 1..=below {
                    let l = N::load::<S>(&data[(k * w + diagonal + i) * p..]);
                    x = x - l * N::load::<S>(&self.b[(k + i) * p..]);
                }
                N::store::<S>(x, &mut self.b[k * p..]);
                self.exchange::<S>(k);
            }
            return;
        }
        for k in 0..n {
            self.exchange::<S>(k);
            let below = half.min(n - 1 - k);
            let x = N::load::<S>(&self.b[k * p..]);
            for i in 1..=below {
                let l = N::load::<S>(&data[(k * w + diagonal + i) * p..]);
                let at = (k + i) * p;
                N::store::<S>(N::load::<S>(&self.b[at..]) - l * x, &mut self.b[at..]);
            }
        }
        for k in (0..n).rev() {
            let base = k * w + diagonal;
            let above = self.band.above.min(k);
            let x = N::load::<S>(&self.b[k * p..]) / N::load::<S>(&data[base * p..]);
            N::store::<S>(x, &mut self.b[k * p..]);
            for i in 0..above {
                let u = N::load::<S>(&data[(base - above + i) * p..]);
                let at = (k - above + i) * p;
                N::store::<S>(N::load::<S>(&self.b[at..]) - u * x, &mut self.b[at..]);
            }
        }
    }
}

/// `to -= sum of a[k] b[k]`, the numbers of `a` and `b` after each other.
struct Less<'a, N> {
    to: &'a mut [Row],
    a: &'a [Row],
    b: &'a [Row],
    number: PhantomData<N>,
}

impl<N: InLanes> Kernel for Less<'_, N> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let mut x = N::load::<S>(self.to);
        for (a, b) in self.a.chunks_exact(N::PARTS).zip(self.b.chunks_exact(N::PARTS)) {
            x = x - N::load::<S>(a) * N::load::<S>(b);
        }
        N::store::<S>(x, self.to);
    }
}

/// `to[k] -= a[k] x`.
struct LessTimes<'a, N> {
    to: &'a mut [Row],
    a: &'a [Row],
    x: &'a [Row],
    number: PhantomData<N>,
}

impl<N: InLanes> Kernel for LessTimes<'_, N> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let x = N::load::<S>(self.x);
        for (to, a) in self.to.chunks_exact_mut(N::PARTS).zip(self.a.chunks_exact(N::PARTS)) {
            let less = N::load::<S>(to) - N::load::<S>(a) * x;
            N::store::<S>(less, to);
        }
    }
}

/// Entries at the places of the lanes.
struct Fill<'a, N> {
    places: &'a Pair,
    terms: &'a [Term],
    inner: usize,
    border: usize,
    band: &'a mut [Row],
    right: &'a mut [Row],
    below: &'a mut [Row],
    corner: &'a mut [Row],
    number: PhantomData<N>,
}

impl<N: InLanes> Kernel for Fill<'_, N> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let s = c(S::load(&self.places[0]), S::load(&self.places[1]));
        for t in self.terms {
            let to = match t.target {
                Target::Band(at) => &mut self.band[at * N::PARTS..],
                Target::Right(r, c) => &mut self.right[(c * self.inner + r) * N::PARTS..],
                Target::Below(r, c) => &mut self.below[(r * self.inner + c) * N::PARTS..],
                Target::Corner(r, c) => &mut self.corner[stored(self.border - 1, r, c) * N::PARTS..],
            };
            N::store::<S>(N::at::<S>(s, &t.values), to);
        }
    }
}

/// Product of the pivots in every lane: its direction, the sum of derivatives over values, and the smallest pivot.
struct Product<'a, N> {
    bands: [&'a Band; 2],
    number: PhantomData<N>,
}

impl<N: InLanes> Kernel for Product<'_, N> {
    type Out = (Pair, Pair, Row);
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        let mut product = Complex::<S>::real(S::load(&self.bands[0].sign) * S::load(&self.bands[1].sign));
        let (mut rate, mut least) = (Complex::<S>::zero(), S::cst(f64::INFINITY));
        for (which, band) in self.bands.into_iter().enumerate() {
            for k in 0..band.n {
                let (value, own) = N::value::<S>(N::load::<S>(&band.data[stored(band.half, k, k) * N::PARTS..]));
                let size = size(value);
                if which == 0 {
                    least = S::select(size.lt(least), size, least);
                }
                product = product * c(value.re / size, value.im / size);
                // its size stays between 1/2 and 1 times that before
                if k % 256 == 255 {
                    let size = product.re.abs() + product.im.abs();
                    product = c(product.re / size, product.im / size);
                }
                rate += own;
            }
        }
        let mut out = ([[0.0; LANES]; 2], [[0.0; LANES]; 2], [0.0; LANES]);
        C64::store::<S>(product, &mut out.0);
        C64::store::<S>(rate, &mut out.1);
        least.store(&mut out.2);
        out
    }
}

/// Factors at up to [`LANES`] places. Reusable.
#[derive(Clone, Debug)]
pub struct LaneFactors<N> {
    places: Pair,
    order: Vec<usize>,
    inner: usize,
    band: Band,
    corner: Band,
    /// Band^-1 times the columns of the border, one after the other; rows of the border.
    right: Vec<Row>,
    below: Vec<Row>,
    scratch: Vec<Row>,
    number: PhantomData<N>,
}

impl<N> Default for LaneFactors<N> {
    fn default() -> Self {
        LaneFactors {
            places: [[0.0; LANES]; 2],
            order: Vec::new(),
            inner: 0,
            band: Band::default(),
            corner: Band::default(),
            right: Vec::new(),
            below: Vec::new(),
            scratch: Vec::new(),
            number: PhantomData,
        }
    }
}

impl<N: InLanes> LaneFactors<N> {
    /// Factors T at some places; lanes that are left repeat the last one.
    pub fn factor(&mut self, t: &ScaledQuadratic, places: &[C64]) {
        let Some(band) = &t.plan.band else { return };
        let (inner, border) = self.reset(band, t.n(), places.len());
        for l in 0..LANES {
            let s = places.get(l).or(places.last()).copied().unwrap_or_default();
            (self.places[0][l], self.places[1][l]) = (s.re, s.im);
        }
        dispatch(
            Level::best(),
            Fill {
                places: &self.places,
                terms: &t.terms,
                inner,
                border,
                band: &mut self.band.data,
                right: &mut self.right,
                below: &mut self.below,
                corner: &mut self.corner.data,
                number: PhantomData::<N>,
            },
        );
        self.eliminate();
    }

    /// Zeros, and the size of the band and of the border.
    fn reset(&mut self, band: &super::plan::Band, n: usize, used: usize) -> (usize, usize) {
        let (inner, border, p) = (band.inner, n - band.inner, N::PARTS);
        spend(effort(inner, band.half, border) as u64 * (p * p * used.min(LANES)) as u64);
        self.inner = inner;
        self.order.clone_from(&band.order);
        self.band.reset(inner, band.half, p);
        self.corner.reset(border, border.saturating_sub(1), p);
        refill(&mut self.right, border * inner * p, [0.0; LANES]);
        refill(&mut self.below, border * inner * p, [0.0; LANES]);
        (inner, border)
    }

    /// Factors what the storage holds.
    fn eliminate(&mut self) {
        let (inner, border, p) = (self.inner, self.corner.n, N::PARTS);
        let (number, level) = (PhantomData::<N>, Level::best());
        dispatch(level, Factor { band: &mut self.band, number });
        for column in self.right.chunks_exact_mut((inner * p).max(1)) {
            dispatch(level, Solve { band: &self.band, b: column, transposed: false, number });
        }
        for (i, row) in self.below.chunks_exact((inner * p).max(1)).enumerate() {
            for (j, column) in self.right.chunks_exact(inner * p).enumerate() {
                let to = &mut self.corner.data[stored(border - 1, i, j) * p..][..p];
                dispatch(level, Less { to, a: row, b: column, number });
            }
        }
        dispatch(level, Factor { band: &mut self.corner, number });
    }

    /// The determinant at the places, without the scaling of rows and columns; `None` where it is zero or not finite, or digits were lost before a border.
    pub fn turns(&self) -> [Option<Sample>; LANES] {
        let (direction, rate, least) = dispatch(Level::best(), Product { bands: [&self.band, &self.corner], number: PhantomData::<N> });
        let bordered = self.corner.n > 0;
        std::array::from_fn(|l| {
            let (d, rate) = (c(direction[0][l], direction[1][l]), c(rate[0][l], rate[1][l]));
            let sound = !bordered || least[l] >= SMALL;
            (sound && d.is_finite() && rate.is_finite()).then(|| Sample { phase: d.arg(), rate })
        })
    }
}

impl LaneFactors<C64> {
    /// Factors matrices of one plan by their entries.
    pub(super) fn factor_entries(&mut self, plan: &Plan, entries: impl Iterator<Item = (Target, Pair)>) {
        let Some(band) = &plan.band else { return };
        let (inner, border) = self.reset(band, plan.n(), LANES);
        for (target, x) in entries {
            let to = match target {
                Target::Band(at) => &mut self.band.data[at * 2..],
                Target::Right(r, c) => &mut self.right[(c * inner + r) * 2..],
                Target::Below(r, c) => &mut self.below[(r * inner + c) * 2..],
                Target::Corner(r, c) => &mut self.corner.data[stored(border - 1, r, c) * 2..],
            };
            to[..2].copy_from_slice(&x);
        }
        self.eliminate();
    }

    /// Solves `T x = b`, or with the transposed matrix, in place, in every lane.
    pub fn solve(&mut self, b: &mut [Pair], transposed: bool) {
        let (inner, level) = (self.inner, Level::best());
        let number = PhantomData::<C64>;
        let mut x = std::mem::take(&mut self.scratch);
        x.clear();
        x.extend(self.order.iter().flat_map(|&i| b[i]));
        let (top, end) = x.split_at_mut(inner * 2);
        if end.is_empty() {
            dispatch(level, Solve { band: &self.band, b: top, transposed, number });
        } else if transposed {
            for (e, column) in end.chunks_exact_mut(2).zip(self.right.chunks_exact(inner * 2)) {
                dispatch(level, Less { to: e, a: column, b: top, number });
            }
            dispatch(level, Solve { band: &self.corner, b: end, transposed, number });
            for (e, row) in end.chunks_exact(2).zip(self.below.chunks_exact(inner * 2)) {
                dispatch(level, LessTimes { to: top, a: row, x: e, number });
            }
            dispatch(level, Solve { band: &self.band, b: top, transposed, number });
        } else {
            dispatch(level, Solve { band: &self.band, b: top, transposed, number });
            for (e, row) in end.chunks_exact_mut(2).zip(self.below.chunks_exact(inner * 2)) {
                dispatch(level, Less { to: e, a: row, b: top, number });
            }
            dispatch(level, Solve { band: &self.corner, b: end, transposed, number });
            for (e, column) in end.chunks_exact(2).zip(self.right.chunks_exact(inner * 2)) {
                dispatch(level, LessTimes { to: top, a: column, x: e, number });
            }
        }
        for (&i, x) in self.order.iter().zip(x.as_chunks::<2>().0) {
            b[i] = *x;
        }
        self.scratch = x;
    }
}
