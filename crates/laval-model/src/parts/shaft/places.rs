//! Where the coordinates of an element stand among those of its shaft: x, y, tilt_x, tilt_y of each node, then axial and twist as far as it has them.

use super::element::M4;
use crate::model::blocks::Grid;
use laval_num::scalar::Scalar;

/// Signs of the plane of y.
pub(super) const SIGN: [f64; 4] = [1.0, -1.0, 1.0, -1.0];

/// First coordinates of the nodes of an element among those of the shaft.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ends {
    pub lower: usize,
    pub upper: usize,
}

impl Ends {
    /// Coordinates of the plane of x: deflection and slope at both ends.
    #[inline(always)]
    pub fn x(self) -> [usize; 4] {
        [self.lower, self.lower + 3, self.upper, self.upper + 3]
    }
    /// Those of the plane of y.
    #[inline(always)]
    pub fn y(self) -> [usize; 4] {
        [self.lower + 1, self.lower + 2, self.upper + 1, self.upper + 2]
    }
    /// A coordinate of both ends by its place in the node.
    #[inline(always)]
    pub fn along(self, place: usize) -> [usize; 2] {
        [self.lower + place, self.upper + place]
    }
}

/// Adds `factor m` to both planes.
#[inline(always)]
pub(super) fn add_planes<S: Scalar>(grid: &mut Grid<S>, ends: Ends, m: &M4<S>, factor: S) {
    let (px, py) = (ends.x(), ends.y());
    for i in 0..4 {
        for j in 0..4 {
            let x = factor * m[i][j];
            grid[(px[i], px[j])] += x;
            grid[(py[i], py[j])] += x.scale(SIGN[i] * SIGN[j]);
        }
    }
}

/// Adds `[0, factor m S; -factor S m, 0]` over both planes.
#[inline(always)]
pub(super) fn add_cross<S: Scalar>(grid: &mut Grid<S>, ends: Ends, m: &M4<S>, factor: S) {
    let (px, py) = (ends.x(), ends.y());
    for i in 0..4 {
        for j in 0..4 {
            let x = factor * m[i][j];
            grid[(px[i], py[j])] += x.scale(SIGN[j]);
            grid[(py[i], px[j])] += x.scale(-SIGN[i]);
        }
    }
}

/// Deflections and slopes of both planes of an element.
#[inline(always)]
pub(super) fn planes<S: Scalar>(ends: Ends, q: &[S]) -> [[S; 4]; 2] {
    let mut out = [[S::zero(); 4]; 2];
    let (px, py) = (ends.x(), ends.y());
    for i in 0..4 {
        out[0][i] = q[px[i]];
        out[1][i] = q[py[i]].scale(SIGN[i]);
    }
    out
}

/// `a' m b`.
#[inline(always)]
pub(super) fn form<S: Scalar>(a: &[S; 4], m: &M4<S>, b: &[S; 4]) -> S {
    let mut out = S::zero();
    for i in 0..4 {
        for j in 0..4 {
            out += a[i] * m[i][j] * b[j];
        }
    }
    out
}

/// Adds `factor m` to one coordinate of both ends.
#[inline(always)]
pub(super) fn add_line<S: Scalar>(grid: &mut Grid<S>, at: [usize; 2], m: &[[S; 2]; 2], factor: S) {
    for i in 0..2 {
        for j in 0..2 {
            grid[(at[i], at[j])] += factor * m[i][j];
        }
    }
}

/// `x' m x` of one coordinate of both ends.
#[inline(always)]
pub(super) fn line_form<S: Scalar>(at: [usize; 2], m: &[[S; 2]; 2], x: &[S]) -> S {
    let mut out = S::zero();
    for i in 0..2 {
        for j in 0..2 {
            out += x[at[i]] * m[i][j] * x[at[j]];
        }
    }
    out
}

/// Rates seen from axes that turn with the rotor: `v - W R q`, over deflections and slopes of both planes.
#[inline(always)]
pub(super) fn slip<S: Scalar>(speed: S, [qx, qy]: [[S; 4]; 2], [vx, vy]: [[S; 4]; 2]) -> [[S; 4]; 2] {
    let mut out = [vx, vy];
    for i in 0..4 {
        out[0][i] += speed * qy[i];
        out[1][i] -= speed * qx[i];
    }
    out
}
