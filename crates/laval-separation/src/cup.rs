//! Swinging cup: equilibrium tilt, small swing about it, motion while the speed changes.
//!
//! Equations, with the second moments about the hinge `Jx = int x^2 dm`, `Jy = int y^2 dm`, `Jxy = int x y dm`:
//!
//! ```text
//! (Jx + Jy) (a'' + cd a') = w^2 [m L (yc cos a - xc sin a) + (Jy - Jx) sin a cos a + Jxy cos 2a] - m g (xc cos a + yc sin a)
//! ```
//!
//! and for a point mass at the distance l (`m = 1, yc = l, Jy = l^2`) `l (a'' + cd a') = w^2 cos a (L + l sin a) - g sin a`. The tilt of equilibrium is the
//! stable root of the right side; the small swing about it has `w_s^2 = -d(right side)/da /(Jx + Jy)`.
//!
//! Symbols: a tilt from the downward vertical, rad; L radius of the hinge, m; w spin speed, rad/s; cd rate of the damping in the hinge, 1/s.
//!
//! Validity: contents frozen; cup symmetric about the plane of its swing.
//!
//! Sources: `docs/theory/separation.md#cups`; 000_a291f7ede1484e56 equation (60).

use laval_num::scalar::Scalar;
use std::f64::consts::{FRAC_PI_2, PI};

/// Halvings of the interval of the equilibrium: near enough for Newton's method.
const HALVINGS: usize = 40;

/// Mass distribution of a cup with its contents about the hinge, in the axes of the cup.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hanging {
    /// Mass m, kg.
    pub mass: f64,
    /// Centre of mass across the cup xc, m.
    pub across: f64,
    /// Centre of mass along the cup yc, m.
    pub along: f64,
    /// Jx, kg m^2.
    pub moment_across: f64,
    /// Jy, kg m^2.
    pub moment_along: f64,
    /// Jxy, kg m^2.
    pub product: f64,
}

impl Hanging {
    /// A point mass at the distance `l` below the hinge.
    pub fn point(mass: f64, l: f64) -> Self {
        Hanging { mass, across: 0.0, along: l, moment_across: 0.0, moment_along: mass * l * l, product: 0.0 }
    }
}

/// A swinging cup.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwingingCup {
    /// Radius of the hinge L, m.
    pub hinge: f64,
    /// Its mass distribution.
    pub body: Hanging,
    /// Rate of the damping in the hinge cd, 1/s.
    pub damping: f64,
    /// Gravity, m/s^2.
    pub gravity: f64,
}

impl SwingingCup {
    /// Right side over the moment of inertia: acceleration of an undamped cup at rest, rad/s^2.
    #[inline(always)]
    pub fn drive<S: Scalar>(&self, speed: S, tilt: S) -> S {
        let b = &self.body;
        let (s, c) = tilt.sin_cos();
        let spin = (c.scale(b.along) - s.scale(b.across)).scale(b.mass * self.hinge)
            + (s * c).scale(b.moment_along - b.moment_across)
            + (c * c - s * s).scale(b.product);
        let weight = (c.scale(b.across) + s.scale(b.along)).scale(b.mass * self.gravity);
        (speed * speed * spin - weight).scale(1.0 / (b.moment_across + b.moment_along))
    }

    /// Acceleration of the tilt, rad/s^2.
    pub fn acceleration<S: Scalar>(&self, speed: S, tilt: S, rate: S) -> S {
        self.drive(speed, tilt) - rate.scale(self.damping)
    }

    /// Derivative of the [`drive`](Self::drive) in the tilt, 1/s^2.
    #[inline(always)]
    fn slope<S: Scalar>(&self, speed: S, tilt: S) -> S {
        let b = &self.body;
        let (s, c) = tilt.sin_cos();
        let spin = (s.scale(b.along) + c.scale(b.across)).scale(-b.mass * self.hinge)
            + (c * c - s * s).scale(b.moment_along - b.moment_across)
            - (s * c).scale(4.0 * b.product);
        let weight = (c.scale(b.along) - s.scale(b.across)).scale(b.mass * self.gravity);
        (speed * speed * spin - weight).scale(1.0 / (b.moment_across + b.moment_along))
    }

    /// Tilt of stable equilibrium, rad: the one a cup swings out to. With the hinge on the axis a symmetric cup hangs straight until
    /// `w^2 l = g`. Derivatives of the speed pass through.
    #[inline(always)]
    pub fn equilibrium<S: Scalar>(&self, speed: S) -> S {
        let w = speed.abs();
        let (mut low, mut high) = self.between(w);
        // the ends are constants, so that only their values take part
        for _ in 0..HALVINGS {
            let middle = (low + high).scale(0.5);
            let drive = self.drive(w, middle);
            low = drive.select_pos(middle, low);
            high = drive.select_pos(high, middle);
        }
        let mut tilt = (low + high).scale(0.5);
        for _ in 0..3 {
            let slope = self.slope(w, tilt);
            // none where a symmetric cup is about to leave the axis
            tilt = tilt - slope.square().select_pos(self.drive(w, tilt) / slope, S::zero());
        }
        tilt
    }

    /// Tilts between which the drive falls through zero, farthest out.
    #[inline(always)]
    fn between<S: Scalar>(&self, w: S) -> (S, S) {
        if self.body.across == 0.0 && self.body.product == 0.0 {
            // one fall at most between hanging and level; just beyond the hanging state the drive is positive wherever the cup can leave it
            let leaves = self.drive(w, S::cst(1e-9));
            return (leaves.select_pos(S::cst(1e-9), S::zero()), leaves.select_pos(S::cst(FRAC_PI_2), S::zero()));
        }
        const STEPS: usize = 64;
        let (mut low, mut high) = (S::zero(), S::zero());
        let mut left = S::cst(-FRAC_PI_2);
        let mut before = self.drive(w, left);
        for k in 1..=STEPS {
            let right = S::cst(-FRAC_PI_2 + (PI + FRAC_PI_2) * k as f64 / STEPS as f64);
            let drive = self.drive(w, right);
            let falls = before.select_pos(drive.select_pos(S::zero(), S::one()), S::zero());
            low = falls.select_pos(left, low);
            high = falls.select_pos(right, high);
            (left, before) = (right, drive);
        }
        (low, high)
    }

    /// Frequency of the small swing about a tilt of equilibrium, rad/s; 0 where the tilt is not stable.
    pub fn swing_frequency(&self, speed: f64, tilt: f64) -> f64 {
        (-self.slope(speed, tilt)).max(0.0).sqrt()
    }

    /// Radius and height (above the hinge) of the centre of mass, m.
    #[inline(always)]
    pub fn centre<S: Scalar>(&self, tilt: S) -> (S, S) {
        let ((s, c), b) = (tilt.sin_cos(), &self.body);
        (S::cst(self.hinge) + c.scale(b.across) + s.scale(b.along), s.scale(b.across) - c.scale(b.along))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const G: f64 = 9.80665;

    fn point(hinge: f64, l: f64) -> SwingingCup {
        SwingingCup { hinge, body: Hanging::point(0.7, l), damping: 0.0, gravity: G }
    }

    /// A cup of many point masses: the torque summed over them.
    #[test]
    fn a_rigid_cup_is_a_sum_of_points() {
        let masses = [(0.2, 0.01, 0.05), (0.5, -0.02, 0.11), (0.1, 0.03, 0.14)];
        let sum = |f: &dyn Fn(f64, f64, f64) -> f64| masses.iter().map(|m| f(m.0, m.1, m.2)).sum::<f64>();
        let mass = sum(&|m, _, _| m);
        let body = Hanging {
            mass,
            across: sum(&|m, x, _| m * x) / mass,
            along: sum(&|m, _, y| m * y) / mass,
            moment_across: sum(&|m, x, _| m * x * x),
            moment_along: sum(&|m, _, y| m * y * y),
            product: sum(&|m, x, y| m * x * y),
        };
        let cup = SwingingCup { hinge: 0.13, body, damping: 0.0, gravity: G };
        for (w, a) in [(0.0, 0.4), (7.0, 1.2), (30.0, -0.3)] {
            let (s, c) = f64::sin_cos(a);
            let torque = sum(&|m, x, y| {
                let radius = 0.13 + c * x + s * y;
                // lever of the centrifugal force and of the weight about the hinge
                m * (w * w * radius * (c * y - s * x) - G * (c * x + s * y))
            });
            let inertia = body.moment_across + body.moment_along;
            assert!((cup.drive(w, a) - torque / inertia).abs() < 1e-12 * (1.0 + w * w), "{w} {a}");
        }
        // an equilibrium that holds, and that the cup returns to
        let a = cup.equilibrium(20.0);
        assert!(cup.drive(20.0, a).abs() < 1e-10 && cup.swing_frequency(20.0, a) > 0.0);
    }

    #[test]
    fn a_hinge_on_the_axis_is_a_conical_pendulum() {
        let cup = point(0.0, 0.1);
        assert_eq!(cup.equilibrium(0.999 * (G / 0.1f64).sqrt()), 0.0);
        let w = 1.2 * (G / 0.1f64).sqrt();
        assert!((cup.equilibrium(w).cos() - G / (w * w * 0.1)).abs() < 1e-14);
    }

    /// The field at the centre of mass lies along the cup: w^2 R/g = tan a.
    #[test]
    fn the_field_lies_along_the_cup() {
        let cup = point(0.08, 0.06);
        for w in [0.3, 3.0, 30.0, 300.0] {
            let a = cup.equilibrium(w);
            let rcf = w * w * cup.centre(a).0 / G;
            assert!((rcf * a.cos() - a.sin()).abs() < 1e-12 * (1.0 + rcf * a.cos()), "{w}");
        }
    }

    /// A slender uniform cup hung at its top swings out like a point at two thirds of its length.
    #[test]
    fn slender_cups() {
        let (m, len) = (0.4, 0.3);
        let body = Hanging { along: 0.5 * len, moment_along: m * len * len / 3.0, ..Hanging::point(m, 0.0) };
        let slender = SwingingCup { body, ..point(0.1, 0.0) };
        for w in [2.0, 5.0, 20.0] {
            assert!((slender.equilibrium(w) - point(0.1, 2.0 * len / 3.0).equilibrium(w)).abs() < 1e-13);
        }
    }
}
