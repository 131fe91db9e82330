//! Tilt of the body: the rotation by the vector (x, y, 0), with its derivatives by exact differentiation.

use laval_num::dual::Dual;
use laval_num::scalar::Scalar;

/// The rotation without the unit matrix, `sin(t)/t K + (1 - cos t)/t^2 K^2`, or a derivative of it; K the cross product with the vector, t its length.
/// Entries: x, y of K, then x x, x y, y y of K^2, each with its weight.
#[derive(Clone, Copy)]
pub(super) struct Turn<S>([S; 5]);

impl<T: Scalar> Turn<T> {
    /// The two weights by their series: to rounding for tilts below 0.1 rad.
    #[inline(always)]
    fn new(x: T, y: T) -> Self {
        let s = x * x + y * y;
        let sine = T::one() - s * (T::cst(1.0 / 6.0) - s * (T::cst(1.0 / 120.0) - s.scale(1.0 / 5040.0)));
        let cosine = T::cst(0.5) - s * (T::cst(1.0 / 24.0) - s * (T::cst(1.0 / 720.0) - s.scale(1.0 / 40320.0)));
        Turn([sine * x, sine * y, cosine * x * x, cosine * x * y, cosine * y * y])
    }
    #[inline(always)]
    pub fn apply(&self, b: [T; 3]) -> [T; 3] {
        let [x, y, xx, xy, yy] = self.0;
        [xy * b[1] - yy * b[0] + y * b[2], xy * b[0] - xx * b[1] - x * b[2], x * b[1] - y * b[0] - (xx + yy) * b[2]]
    }
    #[inline(always)]
    pub fn transposed(&self, b: [T; 3]) -> [T; 3] {
        let [x, y, xx, xy, yy] = self.0;
        [xy * b[1] - yy * b[0] - y * b[2], xy * b[0] - xx * b[1] + x * b[2], y * b[0] - x * b[1] - (xx + yy) * b[2]]
    }
}

/// The rotation of a body that moves: R - 1, its derivatives in the two tilts, and its first and second derivatives in time.
pub(super) struct Tilt<S> {
    pub turn: Turn<S>,
    pub over: [Turn<S>; 2],
    pub rate: Turn<S>,
    pub accel: Turn<S>,
}

/// A number along the path q + v t + a t^2/2.
#[inline(always)]
fn path<S: Scalar>(q: S, v: S, a: S) -> Dual<Dual<S, 1>, 1> {
    Dual { re: Dual { re: q, eps: [v] }, eps: [Dual { re: v, eps: [a] }] }
}

impl<S: Scalar> Tilt<S> {
    /// From the tilts, their rates and accelerations.
    #[inline(always)]
    pub fn new(q: &[S], v: &[S], a: &[S]) -> Self {
        let first = Turn::new(Dual::<S, 2>::seed(q[0], 0), Dual::<S, 2>::seed(q[1], 1));
        let second = Turn::new(path(q[0], v[0], a[0]), path(q[1], v[1], a[1]));
        let none = Turn([S::zero(); 5]);
        let mut out = Tilt { turn: none, over: [none, none], rate: none, accel: none };
        for k in 0..5 {
            out.turn.0[k] = first.0[k].re;
            out.over[0].0[k] = first.0[k].eps[0];
            out.over[1].0[k] = first.0[k].eps[1];
            out.rate.0[k] = second.0[k].re.eps[0];
            out.accel.0[k] = second.0[k].eps[0].eps[0];
        }
        out
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
