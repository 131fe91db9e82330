//! What cups do to the rotor that carries them: mass, inertia, height of the centre of mass, unbalance, all at the tilt of the moment.
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
//! Sources: `theory/separation.md` section 13, couplings.

use super::cup::SwingingCup;
use laval_num::complex::{C64, c};
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
pub struct Load {
    /// Tilt, rad.
    pub tilt: f64,
    /// Mass of all, kg.
    pub mass: f64,
    /// Height of their common centre of mass above the hinges, m.
    pub height: f64,
    /// Moment of inertia about the spin axis, kg m^2.
    pub polar: f64,
    /// Moment about an axis across, through the point at the height of the hinges (mean over all directions), kg m^2.
    pub diametral: f64,
    /// Unbalance over the key mark's direction, kg m.
    pub unbalance: C64,
    /// Moment of the unbalance about the height of the hinges, kg m^2.
    pub couple: C64,
}

impl Ring {
    /// The load at a speed (rad/s).
    pub fn at(&self, speed: f64) -> Load {
        let tilt = self.held.unwrap_or_else(|| self.cup.equilibrium(speed));
        let (s, co) = tilt.sin_cos();
        let b = &self.cup.body;
        let (radius, height) = self.cup.centre(tilt);
        // second moments of one cup about its own centre of mass, along and across it, turned into the directions of radius and axis
        let (own_y, own_x) = (b.moment_along - b.mass * b.along * b.along, b.moment_across - b.mass * b.across * b.across);
        let own_xy = b.product - b.mass * b.across * b.along;
        let radial = own_x * co * co + own_y * s * s + 2.0 * own_xy * s * co;
        let axial = own_x * s * s + own_y * co * co - 2.0 * own_xy * s * co;
        let difference = |list: &[f64], k: usize| list.get(k).copied().unwrap_or(0.0);
        let mut load = Load { tilt, mass: 0.0, height: 0.0, polar: 0.0, diametral: 0.0, unbalance: c(0.0, 0.0), couple: c(0.0, 0.0) };
        for k in 0..self.count {
            let mass = b.mass + difference(&self.mass_differences, k);
            let dl = difference(&self.centre_differences, k);
            let (r, v) = (radius + dl * s, height - dl * co);
            let share = mass / b.mass;
            let direction = C64::cis(TAU * k as f64 / self.count as f64);
            load.mass += mass;
            load.height += mass * v;
            let polar = mass * r * r + share * (radial + own_x);
            load.polar += polar;
            load.diametral += 0.5 * polar + mass * v * v + share * axial;
            load.unbalance += direction.scale(mass * r);
            load.couple += direction.scale(mass * r * v + share * self.coupled(own_x, own_y, own_xy, s, co));
        }
        if load.mass > 0.0 {
            load.height /= load.mass;
        }
        // equal cups cancel to rounding
        let size = load.mass * radius.abs();
        if load.unbalance.abs() < 1e-14 * size {
            load.unbalance = c(0.0, 0.0);
        }
        if load.couple.abs() < 1e-14 * size * (1.0 + height.abs()) {
            load.couple = c(0.0, 0.0);
        }
        load
    }

    /// Product of inertia of one cup between radius and axis.
    fn coupled(&self, own_x: f64, own_y: f64, own_xy: f64, s: f64, co: f64) -> f64 {
        (own_x - own_y) * s * co + own_xy * (s * s - co * co)
    }
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
