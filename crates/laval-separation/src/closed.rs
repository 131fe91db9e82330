//! The exact motion of a particle at constant speed and tilt with Stokes drag, and its drag-dominated limit.
//!
//! Equations: the plane `W = R + i z` and the height V move by themselves,
//!
//! ```text
//! W'' + 2 (n + i b w) W' - kappa w^2 W = 0            V'' + 2n V' = -kappa g
//! q = sqrt((n + i b w)^2 + kappa w^2), Re q > 0       lam2 = -(n + i b w) - q      lam1 = kappa w^2/(n + i b w + q)
//! W = c1 exp(lam1 t) + c2 exp(lam2 t)                 V = V0 + vs t + (V0' - vs)(1 - exp(-2n t))/(2n),  vs = -kappa g/(2n)
//! ```
//!
//! and for n >> w  `W = W0 exp(s w^2 t)`, `V = V0 - s g t`. The quotient for lam1 is exact where the difference `q - n` would lose all digits.
//!
//! Symbols: as in [`super::particle`] and [`super::frame`].
//!
//! Validity: speed and tilt constant; Re small.
//!
//! Sources: `docs/theory/separation.md#exact-solution`, `docs/theory/separation.md#drag-dominated-limit`.

use super::particle::Rates;
use laval_num::complex::{C64, c};

/// A cup that turns steadily: where particles move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steady {
    /// Spin speed w, rad/s.
    pub speed: f64,
    /// Tilt from the downward vertical, rad.
    pub tilt: f64,
    /// Radius of the hinge L, m.
    pub hinge: f64,
    /// Gravity, m/s^2.
    pub gravity: f64,
}

impl Steady {
    /// Radius vector `R + i z` and height above the hinge of a point of the cup.
    pub fn plane(&self, [x, y, z]: [f64; 3]) -> (C64, f64) {
        let (s, co) = self.tilt.sin_cos();
        (c(self.hinge + co * x + s * y, z), s * x - co * y)
    }

    /// The same for a velocity.
    pub fn plane_rate(&self, [vx, vy, vz]: [f64; 3]) -> (C64, f64) {
        let (s, co) = self.tilt.sin_cos();
        (c(co * vx + s * vy, vz), s * vx - co * vy)
    }

    /// Distance from the spin axis, m.
    pub fn radius(&self, r: [f64; 3]) -> f64 {
        self.plane(r).0.abs()
    }
}

/// A motion in closed form.
pub trait Path {
    /// Position and velocity in the cup's axes at `t`.
    fn at(&self, t: f64) -> ([f64; 3], [f64; 3]);
    /// Longest interval over which the motion is smooth, and the rate of its first transient (infinite: none), for the search of exits.
    fn pace(&self) -> Pace;
}

/// How fast a path changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Rate of the first transient, 1/s; infinite when there is none.
    pub transient: f64,
    /// Fastest rate that does not die out with the transient, 1/s.
    pub lasting: f64,
}

/// Back from radius and height to the cup's axes.
#[derive(Clone, Copy, Debug)]
struct Axes {
    sin: f64,
    cos: f64,
    hinge: f64,
}

impl Axes {
    fn of(steady: &Steady) -> Self {
        let (sin, cos) = steady.tilt.sin_cos();
        Axes { sin, cos, hinge: steady.hinge }
    }
    fn point(&self, w: C64, v: f64) -> [f64; 3] {
        let r = w.re - self.hinge;
        [self.cos * r + self.sin * v, self.sin * r - self.cos * v, w.im]
    }
    fn rate(&self, w: C64, v: f64) -> [f64; 3] {
        [self.cos * w.re + self.sin * v, self.sin * w.re - self.cos * v, w.im]
    }
}

/// The exact motion with inertia; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Closed {
    axes: Axes,
    lam1: C64,
    lam2: C64,
    c1: C64,
    c2: C64,
    two_n: f64,
    height: f64,
    settling: f64,
    excess: f64,
}

impl Closed {
    /// From a position and velocity in the cup's axes.
    pub fn new(rates: &Rates, steady: &Steady, position: [f64; 3], velocity: [f64; 3]) -> Self {
        let (lam1, lam2) = exponents(rates, steady.speed);
        let ((w0, v0), (w1, v1)) = (steady.plane(position), steady.plane_rate(velocity));
        let difference = lam1 - lam2;
        let settling = -rates.sedimentation * steady.gravity;
        Closed {
            axes: Axes::of(steady),
            lam1,
            lam2,
            c1: (w1 - lam2 * w0) / difference,
            c2: (lam1 * w0 - w1) / difference,
            two_n: rates.two_n,
            height: v0,
            settling,
            excess: v1 - settling,
        }
    }
}

/// Exponents lam1, lam2 of the motion across the axis, 1/s.
pub fn exponents(rates: &Rates, speed: f64) -> (C64, C64) {
    let damped = c(0.5 * rates.two_n, rates.coriolis * speed);
    let k = rates.kappa * speed * speed;
    let q = (damped * damped + c(k, 0.0)).sqrt();
    let q = if q.re < 0.0 { -q } else { q };
    (c(k, 0.0) / (damped + q), -(damped + q))
}

impl Path for Closed {
    fn at(&self, t: f64) -> ([f64; 3], [f64; 3]) {
        let e1 = self.c1 * self.lam1.scale(t).exp();
        let (mut w, mut dw) = (e1, e1 * self.lam1);
        let faded = self.lam2.re * t;
        if faded > -745.0 {
            let e2 = self.c2 * self.lam2.scale(t).exp();
            w += e2;
            dw += e2 * self.lam2;
        }
        let gone = -(-self.two_n * t).exp_m1();
        let v = self.height + self.settling * t + self.excess * gone / self.two_n;
        let dv = self.settling + self.excess * (1.0 - gone);
        (self.axes.point(w, v), self.axes.rate(dw, dv))
    }

    fn pace(&self) -> Pace {
        // a motion without inertia turns by little while it settles; its exponent has hardly an imaginary part
        Pace { transient: self.lam2.abs(), lasting: self.lam1.re.max(0.0).max(4.0 * self.lam1.im.abs()).max(slow(self.lam2)) }
    }
}

/// Turning of a transient that dies out slowly.
fn slow(lam2: C64) -> f64 {
    if -lam2.re < lam2.im.abs() { 4.0 * lam2.im.abs() } else { 0.0 }
}

/// The motion of a particle without inertia.
#[derive(Clone, Copy, Debug)]
pub struct Drifting {
    axes: Axes,
    start: C64,
    rate: f64,
    height: f64,
    settling: f64,
}

impl Drifting {
    /// From a position; `sedimentation` in s.
    pub fn new(sedimentation: f64, steady: &Steady, position: [f64; 3]) -> Self {
        let (start, height) = steady.plane(position);
        Drifting {
            axes: Axes::of(steady),
            start,
            rate: sedimentation * steady.speed * steady.speed,
            height,
            settling: -sedimentation * steady.gravity,
        }
    }
}

impl Path for Drifting {
    fn at(&self, t: f64) -> ([f64; 3], [f64; 3]) {
        let w = self.start.scale((self.rate * t).exp());
        (self.axes.point(w, self.height + self.settling * t), self.axes.rate(w.scale(self.rate), self.settling))
    }

    fn pace(&self) -> Pace {
        Pace { transient: f64::INFINITY, lasting: self.rate.max(0.0) }
    }
}
