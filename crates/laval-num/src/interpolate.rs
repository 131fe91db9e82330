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

use crate::scalar::Scalar;
use std::fmt;

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
        let (Some(&x0), Some(&y0)) = (x.first(), y.first()) else { return Err(TableError::Empty) };
        if let Some(row) = x.iter().zip(y).position(|(x, y)| !(x.is_finite() && y.is_finite())) {
            return Err(TableError::NotFinite(row));
        }
        if let Some(row) = x.windows(2).position(|w| w[0] >= w[1]) {
            return Err(TableError::NotIncreasing(row + 1));
        }
        let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
        let d: Vec<f64> = y.windows(2).zip(&h).map(|(w, h)| (w[1] - w[0]) / h).collect();
        let slope = slopes(&h, &d);
        let piece = |i: usize| {
            let (s0, s1) = (slope[i], slope[i + 1]);
            let c = [s0, (3.0 * d[i] - 2.0 * s0 - s1) / h[i], (s0 + s1 - 2.0 * d[i]) / (h[i] * h[i])];
            Piece { start: x[i], width: h[i], c }
        };
        Ok(Interpolant { first: (x0, y0), pieces: (0..h.len()).map(piece).collect(), outside: None })
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
            let u = x - S::cst(p.start);
            let over = u - S::cst(p.width);
            let t = over.select_pos(S::cst(p.width), u.pos());
            let (c1, c2, c3) = (S::cst(p.c[0]), S::cst(p.c[1]), S::cst(p.c[2]));
            y += t * (c1 + t * (c2 + t * c3));
            let inside = c1 + t * (c2.scale(2.0) + t * c3.scale(3.0));
            slope += over.select_pos(S::zero(), u.select_pos(inside, S::zero()));
        }
        if let Some([before, after]) = self.outside {
            let (first, last) = self.range();
            let (under, over) = (S::cst(first) - x, x - S::cst(last));
            y += over.pos().scale(after) - under.pos().scale(before);
            slope += over.select_pos(S::cst(after), S::zero()) + under.select_pos(S::cst(before), S::zero());
        }
        (y, slope)
    }
}

fn slopes(h: &[f64], d: &[f64]) -> Vec<f64> {
    let n = h.len();
    match n {
        0 => return vec![0.0],
        1 => return vec![d[0]; 2],
        _ => {}
    }
    let inner = |i: usize| {
        let (left, right) = (d[i - 1], d[i]);
        let (p, r) = (2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]);
        if left * right <= 0.0 { 0.0 } else { (p + r) / (p / left + r / right) }
    };
    let mut s = vec![end(h[0], h[1], d[0], d[1])];
    s.extend((1..n).map(inner));
    s.push(end(h[n - 1], h[n - 2], d[n - 1], d[n - 2]));
    s
}

fn end(h0: f64, h1: f64, d0: f64, d1: f64) -> f64 {
    let s = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if s * d0 <= 0.0 {
        0.0
    } else if d0 * d1 < 0.0 && s.abs() > 3.0 * d0.abs() {
        3.0 * d0
    } else {
        s
    }
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
}
