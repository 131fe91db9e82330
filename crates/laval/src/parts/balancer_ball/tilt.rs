//! Tilt of the body: the rotation by the vector (x, y, 0), with its derivatives by exact differentiation.

use laval_num::dual::Dual;
use laval_num::scalar::Scalar;

/// The rotation without the unit matrix, `sin(t)/t K + (1 - cos t)/t^2 K^2`, or a derivative of it; K the cross product with the vector, t its length.
#[derive(Clone, Copy)]
pub(super) struct Turn<S> {
    /// Entries of K, weighted.
    x: S,
    y: S,
    /// Entries of K^2, weighted: x x, x y, y y.
    xx: S,
    xy: S,
    yy: S,
}

impl<T: Scalar> Turn<T> {
    /// The two weights by their series: to rounding for tilts below 0.1 rad.
    #[inline(always)]
    fn new(x: T, y: T) -> Self {
        let s = x * x + y * y;
        let sine = T::one() - s * (T::cst(1.0 / 6.0) - s * (T::cst(1.0 / 120.0) - s.scale(1.0 / 5040.0)));
        let cosine = T::cst(0.5) - s * (T::cst(1.0 / 24.0) - s * (T::cst(1.0 / 720.0) - s.scale(1.0 / 40320.0)));
        Turn { x: sine * x, y: sine * y, xx: cosine * x * x, xy: cosine * x * y, yy: cosine * y * y }
    }
    #[inline(always)]
    pub fn apply(&self, b: [T; 3]) -> [T; 3] {
        [
            self.xy * b[1] - self.yy * b[0] + self.y * b[2],
            self.xy * b[0] - self.xx * b[1] - self.x * b[2],
            self.x * b[1] - self.y * b[0] - (self.xx + self.yy) * b[2],
        ]
    }
    #[inline(always)]
    pub fn transposed(&self, b: [T; 3]) -> [T; 3] {
        [
            self.xy * b[1] - self.yy * b[0] - self.y * b[2],
            self.xy * b[0] - self.xx * b[1] + self.x * b[2],
            self.y * b[0] - self.x * b[1] - (self.xx + self.yy) * b[2],
        ]
    }
}

/// The rotation of a body that moves: R - 1, its derivatives in the two tilts, and its first and second derivatives in time.
pub(super) struct Tilt<S> {
    pub turn: Turn<S>,
    pub over: [Turn<S>; 2],
    pub rate: Turn<S>,
    pub accel: Turn<S>,
}

impl<S: Scalar> Tilt<S> {
    #[inline(always)]
    pub fn new(q: [S; 2], v: [S; 2], a: [S; 2]) -> Self {
        let first = Turn::new(Dual::<S, 2>::seed(q[0], 0), Dual::seed(q[1], 1));
        // along the path q + v t + a t^2/2
        let path = |i: usize| Dual { re: Dual { re: q[i], eps: [v[i]] }, eps: [Dual { re: v[i], eps: [a[i]] }] };
        let second: Turn<Dual<Dual<S, 1>, 1>> = Turn::new(path(0), path(1));
        let value = |x: Dual<S, 2>| x.re;
        let over = |i: usize| first.each(|x| x.eps[i]);
        Tilt {
            turn: first.each(value),
            over: [over(0), over(1)],
            rate: second.each(|x| x.re.eps[0]),
            accel: second.each(|x| x.eps[0].eps[0]),
        }
    }
}

impl<T: Copy> Turn<T> {
    #[inline(always)]
    fn each<S>(&self, f: impl Fn(T) -> S) -> Turn<S> {
        Turn { x: f(self.x), y: f(self.y), xx: f(self.xx), xy: f(self.xy), yy: f(self.yy) }
    }
}

/// `a + b`.
#[inline(always)]
pub(super) fn sum<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a . b`.
#[inline(always)]
pub(super) fn dot<S: Scalar>(a: [S; 3], b: [S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
