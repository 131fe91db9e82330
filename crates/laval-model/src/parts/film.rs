//! Force of a short oil film between two circles: Reynolds' equation without pressure gradient around the circumference.
//!
//! ```text
//! p = (6 mu/h^3) (z^2 - L^2/4) (W/2 dh/dtheta + dh/dt),   h = c - x cos(theta) - y sin(theta)
//! F = -int p (cos, sin) R dtheta dz = mu R L^3/(4 c^2) f,   A = W X - 2 Y',  B = W Y + 2 X',  X = x/c, Y = y/c
//! ```
//!
//! Ruptured film (pressure only where it is positive), with `m = 1 - X^2 - Y^2`, `u = |A, B|`, `P = (X A + Y B)/u`, `Q = (Y A - X B)/u`:
//!
//! ```text
//! G = 2/sqrt(m) (pi/2 - atan(Q/sqrt(m))),   V = (2 - Q G)/m,   H = -P/(1 - P^2)
//! f = -(3 X V u + B G + 2 A H,  3 Y V u - A G + 2 B H)/m
//! ```
//!
//! Full film (the pressure may be negative): `f = -2 pi m^(-3/2) (B - 3 X Q u/m, -A - 3 Y Q u/m)`.
//!
//! Sources: F. W. Ocvirk, NACA TN 2808 (1952); G. Capone, Energia Elettrica 68 (1991) 105 (closed form of the ruptured film).

use laval_num::scalar::Scalar;
use std::f64::consts::PI;

/// Where the film carries pressure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Film {
    /// Where its pressure is positive: it ruptures over half of the circumference.
    Ruptured,
    /// All around.
    Full,
}

/// Eccentricity over the clearance from which on the walls push back: the law of the film is left before.
const TOUCH: f64 = 0.99;
/// Square of a rate so small, over the clearance, that it stands for none, 1/s^2.
const STILL: f64 = 1e-30;

/// Measures of a film.
#[derive(Clone, Copy, Debug)]
pub struct Measures<S> {
    /// mu, Pa s.
    pub viscosity: S,
    /// 2 R, m.
    pub diameter: S,
    /// L, m.
    pub length: S,
    /// c, m, of the radius.
    pub clearance: S,
}

impl<S: Scalar> Measures<S> {
    /// mu R L^3/(4 c^2), N s.
    #[inline(always)]
    fn scale(&self) -> S {
        let c2 = self.clearance * self.clearance;
        (self.viscosity * self.diameter * self.length * self.length * self.length).scale(0.125) / c2
    }

    /// Force on the inner circle, N, at a displacement (m) and velocity (m/s) relative to the outer one, with the inner circle turning at `speed`.
    #[inline(always)]
    pub fn force(&self, film: Film, [x, y]: [S; 2], [vx, vy]: [S; 2], speed: S) -> [S; 2] {
        let k = S::one() / self.clearance;
        let (x, y, vx, vy) = (x * k, y * k, vx * k, vy * k);
        let e = x.norm2(y);
        let over = e - S::cst(TOUCH);
        let inside = over.select_pos(S::cst(TOUCH) / over.select_pos(e, S::one()), S::one());
        let (px, py) = (x * inside, y * inside);
        let (a, b) = (speed * px - vy.scale(2.0), speed * py + vx.scale(2.0));
        let f = match film {
            Film::Ruptured => ruptured([px, py], [a, b]),
            Film::Full => full([px, py], [a, b]),
        };
        // walls that hold at any load, in the direction of the displacement
        let wall = over.pos() * (S::one() + speed.abs()).scale(1e6) / over.select_pos(e, S::one());
        let scale = self.scale();
        [scale * (f[0] - wall * x), scale * (f[1] - wall * y)]
    }

    /// Torque of a full film that turns with the inner circle about its centre, N m.
    #[inline(always)]
    pub fn drag(&self, [x, y]: [S; 2], speed: S) -> S {
        let k = S::one() / self.clearance;
        let e2 = (x * k).square() + (y * k).square();
        let over = e2 - S::cst(TOUCH * TOUCH);
        let m = S::one() - over.select_pos(S::cst(TOUCH * TOUCH) + over.scale(0.0), e2);
        let d3 = self.diameter * self.diameter * self.diameter;
        (self.viscosity * d3 * self.length * speed).scale(0.25 * PI) / (self.clearance * m.sqrt())
    }
}

#[inline(always)]
fn ruptured<S: Scalar>([x, y]: [S; 2], [a, b]: [S; 2]) -> [S; 2] {
    let u = (a * a + b * b + S::cst(STILL)).sqrt();
    let (p, q) = ((x * a + y * b) / u, (y * a - x * b) / u);
    let m = S::one() - x * x - y * y;
    let root = m.sqrt();
    // pi/2 - atan(q/root)
    let g = root.atan2(q).scale(2.0) / root;
    let v = (S::cst(2.0) - q * g) / m;
    let h = -(p / (S::one() - p * p));
    let along = (v * u).scale(3.0);
    [-(x * along + b * g + (a * h).scale(2.0)) / m, -(y * along - a * g + (b * h).scale(2.0)) / m]
}

#[inline(always)]
fn full<S: Scalar>([x, y]: [S; 2], [a, b]: [S; 2]) -> [S; 2] {
    let m = S::one() - x * x - y * y;
    let w = ((y * a - x * b) / m).scale(3.0);
    let k = S::cst(2.0 * PI) / (m * m.sqrt());
    [-(k * (b - x * w)), k * (a + y * w)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const OIL: Measures<f64> = Measures { viscosity: 0.1, diameter: 0.1, length: 0.03, clearance: 1e-4 };

    /// The integral of the pressure over the circumference by a fine sum.
    fn summed(film: Film, q: [f64; 2], v: [f64; 2], speed: f64) -> [f64; 2] {
        let n = 200_000;
        let mut out = [0.0; 2];
        for k in 0..n {
            let theta = 2.0 * PI * (f64::from(k) + 0.5) / f64::from(n);
            let (s, c) = theta.sin_cos();
            let h = OIL.clearance - q[0] * c - q[1] * s;
            let (slope, rate) = (q[0] * s - q[1] * c, -(v[0] * c + v[1] * s));
            // integrated over the length
            let p = -OIL.viscosity * OIL.length.powi(3) / h.powi(3) * (0.5 * speed * slope + rate);
            let p = if film == Film::Ruptured { p.max(0.0) } else { p };
            let share = OIL.diameter / 2.0 * 2.0 * PI / f64::from(n);
            out[0] -= p * c * share;
            out[1] -= p * s * share;
        }
        out
    }

    #[test]
    fn forces_are_integrals_of_the_pressure() {
        for film in [Film::Ruptured, Film::Full] {
            for (q, v, speed) in [
                ([3e-5, -2e-5], [0.0, 0.0], 157.0),
                ([-4e-5, 6e-5], [2e-3, -5e-3], 157.0),
                ([-4e-5, 6e-5], [-9e-3, 4e-3], -80.0),
                ([1e-5, 7e-5], [3e-3, 2e-3], 0.0),
                ([0.0, 0.0], [3e-3, 2e-3], 0.0),
            ] {
                let (found, expected) = (OIL.force(film, q, v, speed), summed(film, q, v, speed));
                let size = expected[0].hypot(expected[1]);
                for (a, b) in found.iter().zip(expected) {
                    assert!((a - b).abs() < 1e-5 * size, "{film:?} {q:?} {v:?}: {found:?} {expected:?}");
                }
            }
        }
    }

    /// Steady film at the eccentricity e: radial 4 e^2/m^2, tangential pi e/m^1.5 (half of a full film's), and the load line of Ocvirk.
    #[test]
    fn steady_forces() {
        let (e, w) = (0.4, 157.0);
        let m: f64 = 1.0 - e * e;
        let unit = OIL.viscosity * OIL.diameter / 2.0 * OIL.length.powi(3) / (4.0 * OIL.clearance.powi(2)) * w;
        let f = OIL.force(Film::Ruptured, [e * OIL.clearance, 0.0], [0.0; 2], w);
        assert!((f[0] / (-4.0 * e * e / (m * m) * unit) - 1.0).abs() < 1e-12);
        assert!((f[1] / (PI * e / m.powf(1.5) * unit) - 1.0).abs() < 1e-12);
        let full = OIL.force(Film::Full, [e * OIL.clearance, 0.0], [0.0; 2], w);
        assert!(full[0].abs() < 1e-12 * full[1] && (full[1] / (2.0 * f[1]) - 1.0).abs() < 1e-12);
    }

    /// What is not a number is not hidden, and beyond the clearance the walls hold.
    #[test]
    fn walls() {
        let beyond = OIL.force(Film::Ruptured, [1.2e-4, 0.0], [0.0; 2], 157.0);
        let near = OIL.force(Film::Ruptured, [0.98e-4, 0.0], [0.0; 2], 157.0);
        assert!(beyond[0] < near[0] && near[0] < 0.0);
        assert!(OIL.force(Film::Ruptured, [f64::NAN, 0.0], [0.0; 2], 157.0)[0].is_nan());
        assert!(OIL.drag([f64::NAN, 0.0], 157.0).is_nan() && OIL.drag([1.2e-4, 0.0], 157.0).is_finite());
    }
}
