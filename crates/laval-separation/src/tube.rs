//! A tube held at a fixed angle, with the free surface its liquid takes while it turns.
//!
//! Equations: the surface is the equipotential `P = w^2 |W|^2/2 - g V = C` that encloses the volume of the liquid, between mouth and bottom; C is
//! found by bisection on the volume, which is summed over the cross-section. Near 1000 g the surface is the cylinder R = const.
//!
//! Symbols: W radius vector, m; V height, m; as in [`super::closed`].
//!
//! Validity: tube capped: liquid that reaches the mouth stays inside.
//!
//! Theory: `docs/theory/separation.md#fixed-angle-tubes`.
//!
//! Sources: hydrostatics of a liquid at rest in a rotating vessel.

use super::closed::Steady;
use super::exit::{Gap, MOST, Surface, Vessel};
use std::f64::consts::PI;

/// A cylindrical tube at a fixed angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// Radius of the centre of the mouth from the spin axis, m.
    pub mouth: f64,
    /// Angle of the tube from the vertical, rad.
    pub angle: f64,
    /// Inner radius, m.
    pub radius: f64,
    /// Length from the mouth to the bottom, m.
    pub length: f64,
    /// Distance from the mouth to the surface of the liquid when the tube stands upright, m.
    pub surface: f64,
}

/// The liquid in a tube that turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filled {
    tube: Tube,
    steady: Steady,
    level: f64,
    /// The liquid touches the mouth.
    pub at_mouth: bool,
}

/// Rings and rays of the quadrature over the cross-section.
const RINGS: usize = 24;
const RAYS: usize = 48;

impl Tube {
    /// The liquid at a speed (rad/s).
    pub fn at(&self, speed: f64, gravity: f64) -> Filled {
        let steady = Steady { speed, tilt: self.angle, hinge: self.mouth, gravity };
        let mut filled = Filled { tube: *self, steady, level: 0.0, at_mouth: false };
        let wanted = PI * self.radius * self.radius * (self.length - self.surface);
        let corners =
            [-1.0, 1.0].map(|e| [filled.potential([e * self.radius, 0.0, 0.0]), filled.potential([e * self.radius, self.length, 0.0])]);
        let mut low = corners.as_flattened().iter().copied().fold(f64::INFINITY, f64::min);
        let mut high = corners.as_flattened().iter().copied().fold(f64::NEG_INFINITY, f64::max) + 0.5 * (speed * self.radius).powi(2);
        for _ in 0..100 {
            filled.level = 0.5 * (low + high);
            if filled.volume() > wanted { low = filled.level } else { high = filled.level }
        }
        filled.at_mouth = filled.surface_at(-self.radius, 0.0) <= 0.0 || filled.surface_at(self.radius, 0.0) <= 0.0;
        filled
    }
}

impl Filled {
    fn potential(&self, r: [f64; 3]) -> f64 {
        let (w, v) = self.steady.plane(r);
        0.5 * self.steady.speed.powi(2) * w.norm_sqr() - self.steady.gravity * v
    }

    /// Place of the surface on the line along the tube through (x, z), not limited to the tube.
    pub(super) fn surface_at(&self, x: f64, z: f64) -> f64 {
        let (s, c) = self.steady.tilt.sin_cos();
        let (w2, g) = (self.steady.speed.powi(2), self.steady.gravity);
        let inner = self.steady.hinge + c * x;
        let (a, b) = (0.5 * w2 * s * s, w2 * s * inner + g * c);
        let rest = 0.5 * w2 * (inner * inner + z * z) - g * s * x - self.level;
        let root = b * b - 4.0 * a * rest;
        if root < 0.0 {
            // above the level everywhere on the line
            return f64::NEG_INFINITY;
        }
        // the outer root, without cancellation
        if b >= 0.0 { -2.0 * rest / (b + root.sqrt()) } else { (-b + root.sqrt()) / (2.0 * a) }
    }

    fn volume(&self) -> f64 {
        let t = &self.tube;
        let mut sum = 0.0;
        for i in 0..RINGS {
            let rho = t.radius * ((i as f64 + 0.5) / RINGS as f64).sqrt();
            for k in 0..RAYS {
                let (s, c) = (2.0 * PI * (k as f64 + 0.5) / RAYS as f64).sin_cos();
                sum += t.length - self.surface_at(rho * c, rho * s).clamp(0.0, t.length);
            }
        }
        sum * PI * t.radius * t.radius / (RINGS * RAYS) as f64
    }

    /// A place is in the liquid.
    pub fn holds(&self, r: [f64; 3]) -> bool {
        r[1] >= 0.0 && r[1] <= self.tube.length && self.potential(r) >= self.level
    }

    /// Least and largest radius of the liquid in the plane of the tube, m.
    pub fn radii(&self) -> (f64, f64) {
        let t = &self.tube;
        let radius = |x: f64, y: f64| self.steady.plane([x, y, 0.0]).0.re;
        let inner = [-t.radius, 0.0, t.radius].map(|x| radius(x, self.surface_at(x, 0.0).clamp(0.0, t.length)));
        let outer = [-t.radius, t.radius].map(|x| radius(x, t.length));
        (inner.into_iter().fold(f64::INFINITY, f64::min), outer.into_iter().fold(0.0, f64::max))
    }

    /// The surface on the axis of the tube, from the mouth, m.
    pub fn axis_surface(&self) -> f64 {
        self.surface_at(0.0, 0.0).clamp(0.0, self.tube.length)
    }

    /// The tube.
    pub fn tube(&self) -> &Tube {
        &self.tube
    }

    /// The motion the liquid takes part in.
    pub fn steady(&self) -> Steady {
        self.steady
    }
}

impl Vessel for Filled {
    fn gaps(&self, r @ [x, y, z]: [f64; 3], v @ [vx, vy, vz]: [f64; 3]) -> [Gap; MOST] {
        let t = &self.tube;
        let ((w, _), (dw, dv)) = (self.steady.plane(r), self.steady.plane_rate(v));
        let rate = self.steady.speed.powi(2) * (w.re * dw.re + w.im * dw.im) - self.steady.gravity * dv;
        [
            Gap { surface: Surface::Wall, value: t.radius * t.radius - x * x - z * z, rate: -2.0 * (x * vx + z * vz) },
            Gap { surface: Surface::Bottom, value: t.length - y, rate: -vy },
            Gap { surface: Surface::Free, value: self.potential(r) - self.level, rate },
            Gap { surface: Surface::Free, value: y, rate: vy },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TUBE: Tube = Tube { mouth: 0.045, angle: 0.5, radius: 0.012, length: 0.09, surface: 0.02 };

    /// Fast: the surface is a cylinder about the spin axis; at rest: level. The volume is kept.
    #[test]
    fn the_surface_follows_the_field() {
        let fast = TUBE.at(2000.0, 9.80665);
        let (inner, _) = fast.radii();
        let on_surface = |x: f64, z: f64| fast.steady.radius([x, fast.surface_at(x, z), z]);
        for (x, z) in [(0.0, 0.0), (-0.01, 0.0), (0.004, 0.008), (0.0, -0.011)] {
            assert!((on_surface(x, z) / on_surface(0.01, 0.0) - 1.0).abs() < 1e-4, "{inner} {}", on_surface(x, z));
        }
        let rest = TUBE.at(0.0, 9.80665);
        let height = |x: f64| rest.steady.plane([x, rest.surface_at(x, 0.0), 0.0]).1;
        assert!((height(-0.01) - height(0.01)).abs() < 1e-12);
        for f in [fast, rest, TUBE.at(30.0, 9.80665)] {
            assert!((f.volume() / (PI * 0.012f64.powi(2) * 0.07) - 1.0).abs() < 1e-12);
        }
    }
}
