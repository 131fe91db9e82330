//! Interpolation in tables: a piecewise cubic that keeps the monotony of its data, written over [`Scalar`].
//!
//! ```text
//! slopes at inner knots: 0 if D_{i-1} D_i <= 0, else (p + r)/(p/D_{i-1} + r/D_i),  p = 2 h_i + h_{i-1},  r = h_i + 2 h_{i-1}
//! end slope:             ((2 h_0 + h_1) D_0 - h_0 D_1)/(h_0 + h_1), 0 against the sign of D_0, at most 3 D_0 where D_0 D_1 < 0
//! h_i = x_{i+1} - x_i,   D_i = (y_{i+1} - y_i)/h_i,   cubic Hermite between
//! ```
//!
//! Outside the table the end values continue as constants, or, after [`Interpolant::straight_outside`], along the tangents at the ends. Sources: F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238;
//! F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300.

use crate::lanes::Routine;
use crate::scalar::Scalar;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

/// A table that cannot be interpolated. Rows are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableError {
    /// No rows.
    Empty,
    /// The columns have these different lengths.
    Lengths(usize, usize),
    /// A number in this row is not finite.
    NotFinite(usize),
    /// The argument in this row is not above the one before.
    NotIncreasing(usize),
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TableError::Empty => write!(f, "the table has no rows"),
            TableError::Lengths(x, y) => write!(f, "the columns have {x} and {y} rows"),
            TableError::NotFinite(row) => write!(f, "row {} holds a number that is not finite", row + 1),
            TableError::NotIncreasing(row) => write!(f, "the argument in row {} is not above the one before", row + 1),
        }
    }
}
impl std::error::Error for TableError {}

/// One interval: `y - y_i = t (c1 + t (c2 + t c3))` for `t = x - start` from 0 to `width`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    start: f64,
    width: f64,
    c: [f64; 3],
}

/// Monotone piecewise cubic through a table; constant outside, unless it was made to go [straight](Interpolant::straight_outside).
#[derive(Clone, Debug, PartialEq)]
pub struct Interpolant {
    first: (f64, f64),
    pieces: Vec<Piece>,
    /// Slopes before the first and after the last argument.
    outside: Option<[f64; 2]>,
}

impl Interpolant {
    /// Through the points `(x[i], y[i])`, `x` strictly increasing. One point is a constant, two are a straight line.
    pub fn new(x: &[f64], y: &[f64]) -> Result<Self, TableError> {
        if x.len() != y.len() {
            return Err(TableError::Lengths(x.len(), y.len()));
        }
        let knots = Knots::new(x)?;
        if let Some(row) = y.iter().position(|y| !y.is_finite()) {
            return Err(TableError::NotFinite(row));
        }
        let slope: Vec<f64> = (0..x.len()).map(|k| knots.slope(&y, k)).collect();
        let piece = |i: usize| {
            let h = x[i + 1] - x[i];
            Piece { start: x[i], width: h, c: cubic(h, (y[i + 1] - y[i]) / h, slope[i], slope[i + 1]) }
        };
        Ok(Interpolant { first: (x[0], y[0]), pieces: (0..x.len() - 1).map(piece).collect(), outside: None })
    }

    /// The same with the tangents at its ends outside.
    #[must_use]
    pub fn straight_outside(mut self) -> Self {
        let end = |p: &Piece| p.c[0] + p.width * (2.0 * p.c[1] + 3.0 * p.width * p.c[2]);
        self.outside = Some([self.pieces.first().map_or(0.0, |p| p.c[0]), self.pieces.last().map_or(0.0, end)]);
        self
    }

    /// First and last argument of the table.
    pub fn range(&self) -> (f64, f64) {
        (self.first.0, self.pieces.last().map_or(self.first.0, |p| p.start + p.width))
    }

    /// Value at `x`; derivatives of `x` pass through. Without a search: each interval adds its rise up to `x`, so that lanes work.
    pub fn value<S: Scalar>(&self, x: S) -> S {
        self.value_and_slope(x).0
    }

    /// Value and d value / d x at `x`; the slope at a knot is that of the interval before it.
    #[inline(always)]
    pub fn value_and_slope<S: Scalar>(&self, x: S) -> (S, S) {
        // 0 * x lets NaN through where there is no interval
        let (mut y, mut slope) = (S::cst(self.first.1) + x.scale(0.0), x.scale(0.0));
        for p in &self.pieces {
            let (rise, inside) = rise([S::cst(p.c[0]), S::cst(p.c[1]), S::cst(p.c[2])], p.start, p.width, x);
            y += rise;
            slope += inside;
        }
        if let Some([before, after]) = self.outside {
            let (rise, inside) = beyond(self.range(), [S::cst(before), S::cst(after)], x);
            y += rise;
            slope += inside;
        }
        (y, slope)
    }
}

/// `c` of [`Piece`] for an interval of width h, mean slope d and slopes s at its ends.
#[inline(always)]
fn cubic<S: Scalar>(h: f64, d: S, s0: S, s1: S) -> [S; 3] {
    [s0, (d.scale(3.0) - s0.scale(2.0) - s1).scale(1.0 / h), (s0 + s1 - d.scale(2.0)).scale(1.0 / (h * h))]
}

/// What an interval adds to value and slope at `x`: nothing before it, its whole rise after it.
#[inline(always)]
fn rise<S: Scalar>(c: [S; 3], start: f64, width: f64, x: S) -> (S, S) {
    let u = x - S::cst(start);
    let over = u - S::cst(width);
    let t = over.select_pos(S::cst(width), u.pos());
    let inside = c[0] + t * (c[1].scale(2.0) + t * c[2].scale(3.0));
    (t * (c[0] + t * (c[1] + t * c[2])), over.select_pos(S::zero(), u.select_pos(inside, S::zero())))
}

/// What tangents at the ends add to value and slope outside.
#[inline(always)]
fn beyond<S: Scalar>((first, last): (f64, f64), [before, after]: [S; 2], x: S) -> (S, S) {
    let (under, over) = (S::cst(first) - x, x - S::cst(last));
    let slope = over.select_pos(after, S::zero()) + under.select_pos(before, S::zero());
    (over.pos() * after - under.pos() * before, slope)
}

/// The values of a table at its arguments.
pub trait Ordinates<S> {
    /// That of a row, counted from 0.
    fn at(&self, row: usize) -> S;
}

impl Ordinates<f64> for &[f64] {
    #[inline(always)]
    fn at(&self, row: usize) -> f64 {
        self[row]
    }
}

/// Arguments of a table whose values are numbers with derivatives of their own: the same cubic as [`Interpolant`], exact in the values as well.
///
/// The slope at a knot has a corner in the values where the table turns or is flat; there its derivative is that with the slope held at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Knots {
    x: Vec<f64>,
    straight: bool,
}

impl Knots {
    /// Strictly increasing, at least one.
    pub fn new(x: &[f64]) -> Result<Self, TableError> {
        if x.is_empty() {
            return Err(TableError::Empty);
        }
        if let Some(row) = x.iter().position(|x| !x.is_finite()) {
            return Err(TableError::NotFinite(row));
        }
        if let Some(row) = x.windows(2).position(|w| w[0] >= w[1]) {
            return Err(TableError::NotIncreasing(row + 1));
        }
        Ok(Knots { x: x.to_vec(), straight: false })
    }
    /// See [`Interpolant::straight_outside`].
    #[must_use]
    pub fn straight_outside(self) -> Self {
        Knots { straight: true, ..self }
    }
    /// All of them.
    pub fn all(&self) -> &[f64] {
        &self.x
    }
    /// First and last argument.
    pub fn range(&self) -> (f64, f64) {
        (self.x[0], self.x[self.x.len() - 1])
    }
    /// How many there are.
    pub fn count(&self) -> usize {
        self.x.len()
    }
    #[inline(always)]
    fn width(&self, i: usize) -> f64 {
        self.x[i + 1] - self.x[i]
    }
    /// Mean slope of an interval.
    #[inline(always)]
    fn mean<S: Scalar>(&self, y: &impl Ordinates<S>, i: usize) -> S {
        (y.at(i + 1) - y.at(i)).scale(1.0 / self.width(i))
    }
    /// Slope at a knot.
    #[inline(always)]
    fn slope<S: Scalar>(&self, y: &impl Ordinates<S>, k: usize) -> S {
        let last = self.x.len() - 1;
        match (k, last) {
            (_, 0) => S::zero(),
            (_, 1) => self.mean(y, 0),
            (0, _) => end([self.width(0), self.width(1)], [self.mean(y, 0), self.mean(y, 1)]),
            _ if k == last => end([self.width(last - 1), self.width(last - 2)], [self.mean(y, last - 1), self.mean(y, last - 2)]),
            _ => {
                let (left, right, h) = (self.mean(y, k - 1), self.mean(y, k), [self.width(k - 1), self.width(k)]);
                let (p, r) = (2.0 * h[1] + h[0], h[1] + 2.0 * h[0]);
                let both = left * right;
                // 0 times NaN is NaN
                let sum = both.select_pos(right.scale(p) + left.scale(r), S::one());
                both.select_pos(both.scale(p + r) / sum, both.scale(0.0))
            }
        }
    }
    /// Value and d value / d x at `x`, with derivatives of `x` and of the values; the slope at a knot is that of the interval before it.
    #[inline(always)]
    pub fn value_and_slope<S: Scalar>(&self, y: &impl Ordinates<S>, x: S) -> (S, S) {
        // four copies of the slope are most of what the compiler would have to optimise
        let at_knot = |k: usize| S::apart(AtKnot { knots: self, y, k, number: PhantomData });
        let pieces = self.pieces(x.value());
        let (mut value, mut slope) = (y.at(pieces.start) + x.scale(0.0), x.scale(0.0));
        for i in pieces {
            let c = cubic(self.width(i), self.mean(y, i), at_knot(i), at_knot(i + 1));
            let (rise, inside) = rise(c, self.x[i], self.width(i), x);
            value += rise;
            slope += inside;
        }
        if self.straight {
            let (rise, inside) = beyond(self.range(), [at_knot(0), at_knot(self.x.len() - 1)], x);
            value += rise;
            slope += inside;
        }
        (value, slope)
    }
    /// The knots whose values the value at an argument rests on: those of its interval and one more on either side; all of them for lanes in several intervals.
    #[inline(always)]
    pub fn rests_on<S: Scalar>(&self, x: S) -> Range<usize> {
        let pieces = self.pieces(x.value());
        pieces.start.saturating_sub(1)..self.x.len().min(pieces.end + 2)
    }
    /// The interval of an argument; all of them for lanes on several.
    #[inline(always)]
    fn pieces(&self, x: f64) -> Range<usize> {
        let count = self.x.len() - 1;
        if count == 0 || x.is_nan() {
            return 0..count;
        }
        let mut i = 0;
        while i + 1 < count && self.x[i + 1] < x {
            i += 1;
        }
        i..i + 1
    }
}

/// The slope of a table at a knot.
struct AtKnot<'a, S, Y> {
    knots: &'a Knots,
    y: &'a Y,
    k: usize,
    number: PhantomData<S>,
}

impl<S: Scalar, Y: Ordinates<S>> Routine for AtKnot<'_, S, Y> {
    type Out = S;
    #[inline(always)]
    fn run(self) -> S {
        self.knots.slope(self.y, self.k)
    }
}

/// Slope at an end, from the nearer interval to the farther.
#[inline(always)]
fn end<S: Scalar>(h: [f64; 2], d: [S; 2]) -> S {
    let s = (d[0].scale(2.0 * h[0] + h[1]) - d[1].scale(h[0])).scale(1.0 / (h[0] + h[1]));
    let steep = (s.square() - d[0].square().scale(9.0)).select_pos(d[0].scale(3.0), s);
    let limited = (-(d[0] * d[1])).select_pos(steep, s);
    (s * d[0]).select_pos(limited, s.scale(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::Dual;

    #[test]
    fn passes_through_its_points_and_is_constant_outside() {
        let (x, y) = ([0.0, 1.0, 1.5, 4.0, 4.25], [2.0, -1.0, -1.5, 7.0, 7.5]);
        let f = Interpolant::new(&x, &y).unwrap();
        for (&x, &y) in x.iter().zip(&y) {
            assert!((f.value(x) - y).abs() < 1e-14);
        }
        assert_eq!(f.value(-1e9), 2.0);
        assert!((f.value(1e9) - 7.5).abs() < 1e-14);
        assert_eq!(f.value_and_slope(5.0).1, 0.0);
        assert_eq!(f.range(), (0.0, 4.25));
        assert!(f.value(f64::NAN).is_nan() && f.value_and_slope(f64::NAN).0.is_nan());
    }

    #[test]
    fn straight_lines_and_constants_are_exact() {
        let line = Interpolant::new(&[0.0, 0.5, 2.0, 3.0], &[1.0, 2.0, 5.0, 7.0]).unwrap();
        for x in [0.0, 0.2, 0.5, 1.7, 3.0] {
            let (y, s) = line.value_and_slope(x + 1e-9);
            assert!((y - (1.0 + 2.0 * (x + 1e-9).min(3.0))).abs() < 1e-14 && (x == 3.0 || (s - 2.0).abs() < 1e-13));
        }
        assert_eq!(Interpolant::new(&[3.0], &[5.0]).unwrap().value(100.0), 5.0);
        assert!(Interpolant::new(&[3.0], &[5.0]).unwrap().value(f64::NAN).is_nan());
    }

    /// Inside nothing changes; outside value, slope and derivative are those of the tangents at the ends, and both meet at the ends.
    #[test]
    fn straight_outside_follows_the_tangents() {
        let held = Interpolant::new(&[1.0, 2.0, 4.0], &[3.0, 4.0, 9.0]).unwrap();
        let straight = held.clone().straight_outside();
        for x in [1.0, 1.3, 2.0, 3.9, 4.0] {
            assert!((straight.value(x) - held.value(x)).abs() < 1e-14);
        }
        for (end, away) in [(1.0, -5.0), (4.0, 7.0)] {
            let inside = held.value_and_slope(end + if away < 0.0 { 1e-9 } else { -1e-9 }).1;
            let (y, slope) = straight.value_and_slope(end + away);
            assert!((slope - inside).abs() < 1e-8 && (y - held.value(end) - inside * away).abs() < 1e-7, "{end}: {y} {slope} {inside}");
            assert!((straight.value(Dual::<f64, 1>::seed(end + away, 0)).eps[0] - slope).abs() < 1e-14);
        }
        assert!(straight.value(f64::NAN).is_nan());
    }

    /// Between monotone data it is monotone, and nowhere leaves the range of two neighbours.
    #[test]
    fn keeps_monotony() {
        let (x, y) = ([0.0, 1.0, 2.0, 2.1, 5.0, 6.0, 7.0], [0.0, 0.0, 1e-3, 10.0, 10.1, 3.0, 3.0]);
        let f = Interpolant::new(&x, &y).unwrap();
        for i in 0..6 {
            let (lo, hi) = (y[i].min(y[i + 1]), y[i].max(y[i + 1]));
            let up = y[i + 1] >= y[i];
            let mut last = y[i];
            for k in 0..=50 {
                let v = f.value(x[i] + (x[i + 1] - x[i]) * f64::from(k) / 50.0);
                assert!(v >= lo - 1e-12 && v <= hi + 1e-12);
                assert!(if up { v >= last - 1e-12 } else { v <= last + 1e-12 });
                last = v;
            }
        }
    }

    /// The printed slope formula by hand, and the order of convergence where data are smooth and monotone (third at least).
    #[test]
    fn slopes_and_order() {
        let f = Interpolant::new(&[0.0, 1.0, 3.0], &[0.0, 1.0, 5.0]).unwrap();
        // D = 1, 2; h = 1, 2: p = 2*2 + 1 = 5, r = 2 + 2 = 4, slope = 9/(5/1 + 4/2) = 9/7; end: ((2+2)*1 - 1*2)/3 = 2/3
        assert!((f.value_and_slope(1.0).1 - 9.0 / 7.0).abs() < 1e-15);
        assert!((f.value_and_slope(1e-12).1 - 2.0 / 3.0).abs() < 1e-10);
        let error = |n: usize| {
            let x: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
            let y: Vec<f64> = x.iter().map(|x| x.exp()).collect();
            let f = Interpolant::new(&x, &y).unwrap();
            (0..1000).map(|k| (k as f64 + 0.5) / 1000.0).fold(0.0, |m: f64, x| m.max((f.value(x) - x.exp()).abs()))
        };
        let order = (error(20) / error(40)).log2();
        assert!(order > 2.8, "{order}");
    }

    #[test]
    fn derivative_is_exact_and_agrees_with_the_slope() {
        let f = Interpolant::new(&[0.0, 1.0, 3.0, 3.5], &[0.0, 1.0, 5.0, -2.0]).unwrap();
        for x in [-0.5, 0.3, 1.0, 2.9, 3.2, 3.49, 8.0] {
            let d = f.value(Dual::<f64, 1>::seed(x, 0));
            let h = 1e-5;
            let slope = f.value_and_slope(x).1;
            assert_eq!(d.re, f.value(x));
            assert!((d.eps[0] - slope).abs() < 1e-13);
            let difference = (f.value(x + h) - f.value(x - h)) / (2.0 * h);
            assert!((slope - difference).abs() < 1e-4, "{x}: {slope} {difference}");
            let curvature = f.value_and_slope(Dual::<f64, 1>::seed(x, 0)).1.eps[0];
            let difference = (f.value_and_slope(x + h).1 - f.value_and_slope(x - h).1) / (2.0 * h);
            assert!(x == 1.0 || (curvature - difference).abs() < 1e-6 * (1.0 + difference.abs()));
        }
    }

    #[test]
    fn bad_tables_are_reported() {
        assert_eq!(Interpolant::new(&[], &[]), Err(TableError::Empty));
        assert_eq!(Interpolant::new(&[1.0], &[]), Err(TableError::Lengths(1, 0)));
        assert_eq!(Interpolant::new(&[1.0, 2.0, 2.0], &[0.0; 3]), Err(TableError::NotIncreasing(2)));
        assert_eq!(Interpolant::new(&[1.0, f64::NAN], &[0.0; 2]), Err(TableError::NotFinite(1)));
        assert!(TableError::NotIncreasing(2).to_string().contains("row 3"));
    }

    /// A column of numbers with derivatives.
    struct Column<S>(Vec<S>);
    impl<S: Scalar> Ordinates<S> for Column<S> {
        fn at(&self, row: usize) -> S {
            self.0[row]
        }
    }

    /// Inside, at the knots and outside: value and slope are those of the table of constants.
    #[test]
    fn knots_are_the_same_cubic() {
        let (x, y) = ([0.0, 1.0, 3.0, 3.5, 6.0], [0.0, 1.0, 5.0, -2.0, -2.5]);
        for straight in [false, true] {
            let (mut table, mut knots) = (Interpolant::new(&x, &y).unwrap(), Knots::new(&x).unwrap());
            if straight {
                (table, knots) = (table.straight_outside(), knots.straight_outside());
            }
            for at in [-1.0, 0.0, 0.4, 1.0, 2.0, 3.0, 3.2, 3.5, 4.0, 6.0, 9.0] {
                let (a, b) = (table.value_and_slope(at), knots.value_and_slope(&&y[..], at));
                assert!((a.0 - b.0).abs() < 1e-13 && (a.1 - b.1).abs() < 1e-13, "{at}: {a:?} {b:?}");
            }
            assert!(knots.value_and_slope(&&y[..], f64::NAN).0.is_nan());
        }
        assert_eq!(Knots::new(&[3.0]).unwrap().value_and_slope(&&[5.0][..], 100.0), (5.0, 0.0));
        assert_eq!(Knots::new(&[1.0, 1.0]), Err(TableError::NotIncreasing(1)));
        assert_eq!(Knots::new(&[]), Err(TableError::Empty));
    }

    /// Of value and slope, in every ordinate: central differences of whole tables, at arguments in every interval and outside. A row farther than two from
    /// the argument has no effect.
    #[test]
    fn derivatives_in_the_values_are_exact() {
        let (x, y) = ([0.0, 1.0, 3.0, 3.5, 6.0, 6.5], [0.0, 1.0, 5.0, 9.0, 4.0, 8.0]);
        for straight in [false, true] {
            let knots = Knots::new(&x).unwrap();
            let knots = if straight { knots.straight_outside() } else { knots };
            for at in [-0.5, 0.3, 1.0, 2.9, 3.2, 5.0, 6.2, 8.0] {
                for k in 0..x.len() {
                    let seeded = Column(
                        y.iter().enumerate().map(|(i, y)| if i == k { Dual::<f64, 1>::seed(*y, 0) } else { Dual::cst(*y) }).collect(),
                    );
                    let (value, slope) = knots.value_and_slope(&seeded, Dual::cst(at));
                    let moved = |h: f64| {
                        let mut y = y;
                        y[k] += h;
                        knots.value_and_slope(&&y[..], at)
                    };
                    let (up, down) = (moved(1e-5), moved(-1e-5));
                    let difference = [(up.0 - down.0) / 2e-5, (up.1 - down.1) / 2e-5];
                    assert!((value.eps[0] - difference[0]).abs() < 1e-8, "{at} {k}: {value:?} {difference:?}");
                    assert!((slope.eps[0] - difference[1]).abs() < 1e-7, "{at} {k}: {slope:?} {difference:?}");
                }
            }
        }
        // at a row its own value alone
        let seeded = |k: usize| Column((0..6).map(|i| if i == k { Dual::<f64, 1>::seed(y[i], 0) } else { Dual::cst(y[i]) }).collect());
        let knots = Knots::new(&x).unwrap();
        for k in 0..6 {
            assert!((knots.value_and_slope(&seeded(k), Dual::cst(3.0)).0.eps[0] - f64::from(u8::from(k == 2))).abs() < 1e-14, "{k}");
        }
    }
}
