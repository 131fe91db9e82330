//! Load of cups on the rotor that carries them: mass, inertia, height of the centre of mass, unbalance, at
//! the tilt of the current speed.
//!
//! Equations, for n cups at equal pitch with centres of mass at the radius `R = L + xc cos a + yc sin a` and the height `V` above the hinges:
//!
//! ```text
//! mass n m,   polar inertia sum m_k R_k^2 + J_polar,   unbalance U = sum m_k R_k exp(2 pi i k/n)
//! ```
//!
//! A cup that weighs dm more adds `dm R`; one whose centre of mass lies dl farther out `m dl sin a`, also when it weighs the same; n equal cups
//! cancel. U grows with the tilt: the response is no multiple of w^2 at low speed.
//!
//! Validity: contents frozen; cups do not swing about their tilt, and are as thick along the hinge as across it.
//!
//! Sources: `docs/theory/operating-window.md#load-of-the-cups`.

use super::cup::SwingingCup;
use laval_num::complex::{C64, Complex, c};
use laval_num::scalar::Scalar;
use std::f64::consts::{PI, TAU};

/// Cups at equal pitch around a rotor.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// One of them, with its contents.
    pub cup: SwingingCup,
    /// A tilt they are held at, rad.
    pub held: Option<f64>,
    /// How many.
    pub count: usize,
    /// What each weighs more, kg; empty: nothing.
    pub mass_differences: Vec<f64>,
    /// How much farther from the hinge each one's centre of mass lies, m; empty: nothing.
    pub centre_differences: Vec<f64>,
}

/// Least radius of the hinges at which the insides of equal cups do not reach into each other, m: cylinders of this radius from the distance `top` from the hinge outwards, at
/// one tilt. Half way between neighbours lies a plane through the spin axis.
pub fn least_hinge_radius(count: usize, radius: f64, top: f64, tilt: f64) -> f64 {
    if count < 2 {
        return f64::NEG_INFINITY;
    }
    let (sin, cos) = (PI / count as f64).sin_cos();
    let (s, c) = tilt.sin_cos();
    radius * (c * sin).hypot(cos) / sin - s * top
}

/// Their share in the rotor, about the point on the axis at the height of the hinges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<S = f64> {
    /// Tilt, rad.
    pub tilt: S,
    /// Mass of all, kg.
    pub mass: f64,
    /// Height of their common centre of mass above the hinges, m.
    pub height: S,
    /// Moment of inertia about the spin axis, kg m^2.
    pub polar: S,
    /// Moment about an axis across, through the point at the height of the hinges (mean over all directions), kg m^2.
    pub diametral: S,
    /// Unbalance over the key mark's direction, kg m.
    pub unbalance: Complex<S>,
    /// Moment of the unbalance about the height of the hinges, kg m^2.
    pub couple: Complex<S>,
}

/// Sums over the cups of a ring that do not depend on the tilt, of the powers 0, 1, 2 of the difference of their centres of mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sums {
    /// `sum m_k dl_k^p`.
    mass: [f64; 3],
    /// `sum m_k dl_k^p exp(2 pi i k/n)`.
    round: [C64; 3],
}

impl Ring {
    /// The load at a speed (rad/s).
    pub fn at(&self, speed: f64) -> Load {
        self.loading(&self.sums(), speed)
    }

    /// What of the cups does not depend on the speed.
    pub fn sums(&self) -> Sums {
        let difference = |list: &[f64], k: usize| list.get(k).copied().unwrap_or(0.0);
        let (mut mass, mut size, mut round) = ([0.0; 3], [0.0; 3], [C64::zero(); 3]);
        for k in 0..self.count {
            let direction = C64::cis(TAU * k as f64 / self.count as f64);
            let mut m = self.cup.body.mass + difference(&self.mass_differences, k);
            for p in 0..3 {
                mass[p] += m;
                size[p] += m.abs();
                round[p] += direction.scale(m);
                m *= difference(&self.centre_differences, k);
            }
        }
        // equal cups cancel to rounding
        for (round, size) in round.iter_mut().zip(size) {
            if round.abs() < 1e-14 * size {
                *round = C64::zero();
            }
        }
        Sums { mass, round }
    }

    /// The load at a speed (rad/s), with the sums at hand. Derivatives of the speed pass through.
    #[inline(always)]
    pub fn loading<S: Scalar>(&self, sums: &Sums, speed: S) -> Load<S> {
        let tilt = match self.held {
            Some(tilt) => S::cst(tilt),
            None => self.cup.equilibrium(speed),
        };
        let (s, co) = tilt.sin_cos();
        let b = &self.cup.body;
        let (radius, height) = self.cup.centre(tilt);
        // second moments of one cup about its own centre of mass, along and across it, turned into the directions of radius and axis
        let (own_y, own_x) = (b.moment_along - b.mass * b.along * b.along, b.moment_across - b.mass * b.across * b.across);
        let own_xy = b.product - b.mass * b.across * b.along;
        let (ss, sc, cc) = (s * s, s * co, co * co);
        let radial = cc.scale(own_x) + ss.scale(own_y) + sc.scale(2.0 * own_xy);
        let axial = ss.scale(own_x) + cc.scale(own_y) - sc.scale(2.0 * own_xy);
        // product of inertia of one cup between radius and axis
        let mixed = sc.scale(own_x - own_y) + (ss - cc).scale(own_xy);
        let ([m0, m1, m2], [u0, u1, u2]) = (sums.mass, sums.round);
        let share = m0 / b.mass;
        // radii are R + dl s, heights V - dl c
        let polar = (radius * radius).scale(m0) + (radius * s).scale(2.0 * m1) + ss.scale(m2) + (radial + S::cst(own_x)).scale(share);
        let axially = (height * height).scale(m0) - (height * co).scale(2.0 * m1) + cc.scale(m2) + axial.scale(share);
        Load {
            tilt,
            mass: m0,
            height: if m0 > 0.0 { height - co.scale(m1 / m0) } else { S::zero() },
            polar,
            diametral: polar.scale(0.5) + axially,
            unbalance: times(u0, radius) + times(u1, s),
            couple: times(u0, radius * height + mixed.scale(1.0 / b.mass)) + times(u1, s * height - radius * co) - times(u2, sc),
        }
    }
}

/// A number along a direction.
#[inline(always)]
fn times<S: Scalar>(u: C64, x: S) -> Complex<S> {
    c(x.scale(u.re), x.scale(u.im))
}

#[cfg(test)]
mod tests {
    use super::super::cup::Hanging;
    use super::*;

    fn ring(count: usize) -> Ring {
        let cup = SwingingCup { hinge: 0.15, body: Hanging::point(0.8, 0.1), damping: 0.0, gravity: 9.80665 };
        Ring { cup, held: None, count, mass_differences: vec![], centre_differences: vec![] }
    }

    #[test]
    fn equal_cups_are_balanced_and_a_missing_one_is_not() {
        for n in [2, 3, 4, 7] {
            assert_eq!(ring(n).at(80.0).unbalance, c(0.0, 0.0), "{n}");
            let mut missing = ring(n);
            missing.mass_differences = vec![0.0; n];
            missing.mass_differences[n - 1] = -0.8;
            let l = missing.at(80.0);
            let radius = 0.15 + 0.1 * l.tilt.sin();
            assert!((l.unbalance.abs() - 0.8 * radius).abs() < 1e-14);
            assert!((l.mass - 0.8 * (n - 1) as f64).abs() < 1e-14);
        }
    }

    /// A pellet that shifts one centre of mass by dl: U = m dl sin a, growing with the tilt.
    #[test]
    fn shifted_pellets() {
        let mut r = ring(2);
        r.centre_differences = vec![0.002, 0.0];
        for w in [2.0, 8.0, 300.0] {
            let l = r.at(w);
            assert!((l.unbalance.abs() - 0.8 * 0.002 * l.tilt.sin()).abs() < 1e-14, "{w}");
        }
    }

    /// A lopsided cup of many point masses: inertia and couple summed over them.
    #[test]
    fn lopsided_cups_are_sums_of_points() {
        let masses = [(0.2, 0.01, 0.05), (0.5, -0.02, 0.11), (0.1, 0.03, 0.14)];
        let sum = |f: &dyn Fn(f64, f64, f64) -> f64| masses.iter().map(|m| f(m.0, m.1, m.2)).sum::<f64>();
        let mass = sum(&|m, _, _| m);
        let across = sum(&|m, x, _| m * x) / mass;
        let body = Hanging {
            mass,
            across,
            along: sum(&|m, _, y| m * y) / mass,
            moment_across: sum(&|m, x, _| m * x * x),
            moment_along: sum(&|m, _, y| m * y * y),
            product: sum(&|m, x, y| m * x * y),
        };
        let cup = SwingingCup { hinge: 0.15, body, damping: 0.0, gravity: 9.80665 };
        // as thick along the hinge as across it
        let thickness = body.moment_across - mass * across * across;
        for a in [0.0, 0.4, 1.3] {
            let (s, co) = f64::sin_cos(a);
            let (radius, height) = (|x: f64, y: f64| 0.15 + co * x + s * y, |x: f64, y: f64| s * x - co * y);
            let of_radius = sum(&|m, x, y| m * radius(x, y).powi(2)) + thickness;
            let l = Ring { cup, held: Some(a), count: 1, mass_differences: vec![], centre_differences: vec![] }.at(20.0);
            assert!((l.polar - of_radius).abs() < 1e-15, "{a}");
            let of_height = sum(&|m, x, y| m * height(x, y).powi(2));
            assert!((l.diametral - of_height - 0.5 * of_radius).abs() < 1e-15, "{a}");
            assert!((l.unbalance - c(sum(&|m, x, y| m * radius(x, y)), 0.0)).abs() < 1e-15, "{a}");
            assert!((l.couple - c(sum(&|m, x, y| m * radius(x, y) * height(x, y)), 0.0)).abs() < 1e-15, "{a}");
        }
    }

    /// Inertia of two point masses, and that of a sphere-like cup (equal second moments about its centre), which keeps them when it tilts.
    #[test]
    fn inertia_of_known_bodies() {
        let l = ring(2).at(1e4);
        assert!((l.polar - 2.0 * 0.8 * 0.25f64.powi(2)).abs() < 1e-6 && l.height.abs() < 1e-6);
        let mut round = ring(3);
        round.cup.body.moment_across = 0.003;
        round.cup.body.moment_along = 0.8 * 0.01 + 0.003;
        let sum = |l: Load| l.polar + 2.0 * l.diametral;
        let (a, b) = (round.at(3.0), ring(3).at(3.0));
        // trace of the moments of inertia: twice the second moment about the point
        let (r, v) = (0.15 + 0.1 * a.tilt.sin(), -0.1 * a.tilt.cos());
        assert!((sum(a) - 3.0 * (0.8 * 2.0 * (r * r + v * v) + 6.0 * 0.003)).abs() < 1e-12);
        let r = 0.15 + 0.1 * b.tilt.sin();
        assert!((b.polar - 3.0 * 0.8 * r * r).abs() < 1e-13);
    }

    /// All points of a cup lie on its side of the plane half way to the next one, and the nearest of them on it.
    #[test]
    fn cups_touch_at_the_least_radius() {
        for (count, top, tilt) in [(2, 0.02, 0.0), (4, 0.02, 0.0), (3, -0.05, 1.2), (6, 0.01, 0.7), (8, 0.03, 1.5), (12, -0.04, 1.57)] {
            let radius = 0.04;
            let hinge = least_hinge_radius(count, radius, top, tilt);
            let (sin, cos) = (PI / count as f64).sin_cos();
            let (s, c) = f64::sin_cos(tilt);
            let n = 3600;
            let distance = (0..=50)
                .flat_map(|j| (0..n).map(move |k| (top + 0.006 * f64::from(j), (TAU * f64::from(k) / f64::from(n)).sin_cos())))
                .map(|(y, (z, x))| (hinge + c * radius * x + s * y) * sin - radius * z * cos)
                .fold(f64::INFINITY, f64::min);
            assert!(distance.abs() < 1e-6 * radius, "{count} {top} {tilt}: {distance:e}");
        }
        assert_eq!(least_hinge_radius(1, 0.04, 0.0, 0.0), f64::NEG_INFINITY);
    }
}
