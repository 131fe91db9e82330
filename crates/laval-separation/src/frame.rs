//! Frame of a swinging cup: positions, and the accelerations of the frame.
//!
//! Equations, with `c = cos a`, `s = sin a`, `R = L + c x + s y`, angular velocity of the frame `Om = (w s, -w c, -A1)`:
//!
//! ```text
//! a_e = (-w^2 c R - A1^2 x + A2 y - w1 c z,  -w^2 s R - A1^2 y - A2 x - w1 s z,  -w^2 z + w1 R - 2 w A1 (s x - c y))
//! a_c = (-2 (w c vz - A1 vy),  -2 (w s vz + A1 vx),  2 w (c vx + s vy))            g = (-g s, g c, 0)
//! ```
//!
//! Symbols: x across the cup, away from the axis of spin when it hangs; y along the cup from the hinge to the bottom, z along the hinge, m; L radius of the
//! hinge, m; w spin speed, w1 its rate; a tilt from the downward vertical, A1, A2 its rates.
//!
//! Validity: exact. L multiplies w^2 and w1 only, because the tilt happens about the hinge.
//!
//! Sources: `docs/theory/separation.md#frame-of-a-cup`; 000_a291f7ede1484e56 equations (57), (58), of which (57) carries L with the rates of the tilt.

use laval_num::scalar::Scalar;

/// Spin and tilt at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<S = f64> {
    /// Spin speed w, rad/s.
    pub speed: S,
    /// Its rate w1, rad/s^2.
    pub accel: S,
    /// Tilt a from the downward vertical, rad.
    pub tilt: S,
    /// Its rate A1, rad/s.
    pub rate: S,
    /// Its second rate A2, rad/s^2.
    pub rate_accel: S,
}

impl Pose {
    /// Constant speed and tilt.
    pub fn steady(speed: f64, tilt: f64) -> Self {
        Pose { speed, accel: 0.0, tilt, rate: 0.0, rate_accel: 0.0 }
    }
}

/// Acceleration of the frame's point at `r`, m/s^2; `hinge` is the radius of the hinge.
pub fn transport<S: Scalar>(p: &Pose<S>, hinge: f64, [x, y, z]: [S; 3]) -> [S; 3] {
    let (s, c) = p.tilt.sin_cos();
    let radius = S::cst(hinge) + c * x + s * y;
    let (w2, a12) = (p.speed * p.speed, p.rate * p.rate);
    [
        -(w2 * c * radius) - a12 * x + p.rate_accel * y - p.accel * c * z,
        -(w2 * s * radius) - a12 * y - p.rate_accel * x - p.accel * s * z,
        -(w2 * z) + p.accel * radius - (p.speed * p.rate * (s * x - c * y)).scale(2.0),
    ]
}

/// Coriolis acceleration at the relative velocity `v`, m/s^2.
pub fn coriolis<S: Scalar>(p: &Pose<S>, [vx, vy, vz]: [S; 3]) -> [S; 3] {
    let om = turning(p);
    [(om[1] * vz - om[2] * vy).scale(2.0), (om[2] * vx - om[0] * vz).scale(2.0), (om[0] * vy - om[1] * vx).scale(2.0)]
}

/// Angular velocity of the frame in its own axes, rad/s.
pub fn turning<S: Scalar>(p: &Pose<S>) -> [S; 3] {
    let (s, c) = p.tilt.sin_cos();
    [p.speed * s, -(p.speed * c), -p.rate]
}

/// Gravity in the axes of the cup, m/s^2.
pub fn gravity<S: Scalar>(p: &Pose<S>, g: f64) -> [S; 3] {
    let (s, c) = p.tilt.sin_cos();
    [s.scale(-g), c.scale(g), S::zero()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Second derivative of the inertial position by differences of high order.
    #[test]
    fn accelerations_are_those_of_the_inertial_position() {
        let (hinge, w0, w1, a0, a1, a2) = (0.2, 3.0, -1.2, 0.7, 0.9, -0.6);
        let (r0, v, acc) = ([0.02, 0.3, -0.05], [0.4, -0.2, 0.3], [0.1, 0.2, -0.3]);
        let place = |t: f64| {
            let a: f64 = a0 + a1 * t + 0.5 * a2 * t * t;
            let phi: f64 = w0 * t + 0.5 * w1 * t * t;
            let r: Vec<f64> = (0..3).map(|i| r0[i] + v[i] * t + 0.5 * acc[i] * t * t).collect();
            let (s, c) = a.sin_cos();
            let (radial, tangential, up) = (hinge + c * r[0] + s * r[1], r[2], s * r[0] - c * r[1]);
            [radial * phi.cos() - tangential * phi.sin(), radial * phi.sin() + tangential * phi.cos(), up]
        };
        // central differences of order 6 at t = 0
        let h = 2e-3;
        let weights = [(0.0, -49.0 / 18.0), (1.0, 1.5), (2.0, -0.15), (3.0, 1.0 / 90.0)];
        let mut inertial = [0.0; 3];
        for (k, w) in weights {
            for sign in if k == 0.0 { vec![1.0] } else { vec![1.0, -1.0] } {
                let p = place(sign * k * h);
                (0..3).for_each(|i| inertial[i] += w * p[i] / (h * h));
            }
        }
        let pose = Pose { speed: w0, accel: w1, tilt: a0, rate: a1, rate_accel: a2 };
        let (e, co) = (transport(&pose, hinge, r0), coriolis(&pose, v));
        let sum: Vec<f64> = (0..3).map(|i| acc[i] + e[i] + co[i]).collect();
        let (s, c) = a0.sin_cos();
        // axes of the cup at t = 0 in inertial axes
        let axes = [[c, 0.0, s], [s, 0.0, -c], [0.0, 1.0, 0.0]];
        for i in 0..3 {
            let want: f64 = (0..3).map(|j| axes[i][j] * inertial[j]).sum();
            assert!((sum[i] - want).abs() < 1e-8, "{i}: {} {want}", sum[i]);
        }
    }
}
