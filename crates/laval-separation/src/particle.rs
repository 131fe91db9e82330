//! A particle in a liquid: buoyancy, drag, added mass, hindered settling.
//!
//! Equations, with `f = 1` (Stokes) or the law of Schiller and Naumann:
//!
//! ```text
//! r'' = kappa (g - a_e) - b a_c - 2n f(Re) r'
//! kappa = (rho_p - rho_f)/(rho_p + Ca rho_f)      b = 1 - CL rho_f/(rho_p + Ca rho_f)
//! 2n = 9 mu k/[2 r0^2 (rho_p + Ca rho_f)(1 - phi)^n_RZ]      s = kappa/(2n)
//! f = 1 + 0.15 Re^0.687 for Re < 1000, 0.44 Re/24 beyond;     Re = 2 r0 |r'| rho_f/mu
//! ```
//!
//! Symbols: r0 radius, m; rho_p, rho_f densities, kg/m^3; mu viscosity, Pa s; phi volume fraction of solids; Ca added-mass, CL lift
//! coefficient; k factor on the drag; s sedimentation coefficient, s.
//!
//! Validity: liquid at rest relative to the vessel; no Basset history force, Saffman lift or drag of walls.
//!
//! Sources: `docs/theory/separation.md#equation-of-motion`, `docs/theory/separation.md#drag-and-hindered-settling`; L. Schiller, A. Naumann, Z. VDI 77 (1933) 318; J. F. Richardson, W. N. Zaki, Trans. Inst.
//! Chem. Eng. 32 (1954) 35.

use laval_num::scalar::Scalar;

/// Law of the drag.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drag {
    /// Proportional to the velocity.
    #[default]
    Stokes,
    /// Schiller and Naumann.
    SchillerNaumann,
}

/// Reynolds number at which the law of Schiller and Naumann changes.
pub const TURBULENT: f64 = 1000.0;

/// Below [`TURBULENT`]: `1 + 0.15 Re^0.687`; `re` is not negative.
pub fn transitional<S: Scalar>(re: S) -> S {
    S::one() + re.pow_pos(0.687).scale(0.15)
}

/// Beyond [`TURBULENT`]: `0.44 Re/24`.
pub fn turbulent<S: Scalar>(re: S) -> S {
    re.scale(0.44 / 24.0)
}

/// The liquid and what is assumed of the motion of particles in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Density of the liquid rho_f, kg/m^3.
    pub density: f64,
    /// Dynamic viscosity mu, Pa s.
    pub viscosity: f64,
    /// Law of the drag.
    pub drag: Drag,
    /// Factor k on the drag: shape, or the mobile surface of a drop.
    pub drag_factor: f64,
    /// Added-mass coefficient Ca.
    pub added_mass: f64,
    /// Lift coefficient CL.
    pub lift: f64,
    /// Volume fraction of solids phi.
    pub volume_fraction: f64,
    /// Exponent of Richardson and Zaki.
    pub hindered_exponent: f64,
    /// Gravity, m/s^2.
    pub gravity: f64,
}

impl Medium {
    /// A dilute suspension with Stokes drag under standard gravity.
    pub fn new(density: f64, viscosity: f64) -> Self {
        Medium {
            density,
            viscosity,
            drag: Drag::Stokes,
            drag_factor: 1.0,
            added_mass: 0.0,
            lift: 0.0,
            volume_fraction: 0.0,
            hindered_exponent: 4.65,
            gravity: crate::model::system::GRAVITY,
        }
    }

    /// Velocity of a particle among others over that of one alone: `(1 - phi)^n_RZ`.
    pub fn hindrance(&self) -> f64 {
        (1.0 - self.volume_fraction).powf(self.hindered_exponent)
    }

    /// Coefficients of the motion of a particle.
    pub fn rates(&self, p: &Particle) -> Rates {
        let inertia = p.density + self.added_mass * self.density;
        let two_n = 9.0 * self.viscosity * self.drag_factor / (2.0 * p.radius * p.radius * inertia * self.hindrance());
        let kappa = (p.density - self.density) / inertia;
        Rates { kappa, coriolis: 1.0 - self.lift * self.density / inertia, two_n, sedimentation: kappa / two_n }
    }

    /// Reynolds number of a particle that moves at `speed` relative to the liquid.
    pub fn reynolds(&self, p: &Particle, speed: f64) -> f64 {
        2.0 * p.radius * speed * self.density / self.viscosity
    }

    /// Radius of the particle with a sedimentation coefficient of this size (inverse of [`Rates::sedimentation`]).
    pub fn radius_for(&self, sedimentation: f64, density: f64) -> f64 {
        let difference = (density - self.density).abs() * self.hindrance();
        (9.0 * self.viscosity * self.drag_factor * sedimentation.abs() / (2.0 * difference)).sqrt()
    }
}

/// Factor on Stokes' drag of a clean drop whose viscosity is `ratio` times that of the liquid (Hadamard, Rybczynski): 2/3 for a bubble, 1 for a
/// solid.
pub fn drop_factor(ratio: f64) -> f64 {
    (2.0 + 3.0 * ratio) / (3.0 + 3.0 * ratio)
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Radius r0, m.
    pub radius: f64,
    /// Density rho_p, kg/m^3.
    pub density: f64,
}

/// Coefficients of the motion; see the [module](self).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Buoyancy ratio kappa; negative for light particles.
    pub kappa: f64,
    /// Factor b on the Coriolis acceleration.
    pub coriolis: f64,
    /// Rate of the drag 2n, 1/s.
    pub two_n: f64,
    /// Sedimentation coefficient s, s.
    pub sedimentation: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sedimentation_does_not_depend_on_added_mass() {
        let p = Particle { radius: 5e-6, density: 2650.0 };
        let m = Medium::new(998.2, 1.002e-3);
        let s = |added_mass| Medium { added_mass, ..m }.rates(&p).sedimentation;
        assert!((s(0.5) / s(0.0) - 1.0).abs() < 1e-15);
        assert!((s(0.0) / (2.0 * 25e-12 * (2650.0 - 998.2) / (9.0 * 1.002e-3)) - 1.0).abs() < 1e-15);
        assert!((m.radius_for(s(0.0), 2650.0) / 5e-6 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn hindered_and_drops() {
        let m = Medium { volume_fraction: 0.1, ..Medium::new(1000.0, 1e-3) };
        assert!((m.hindrance() - 0.6127).abs() < 5e-5);
        assert_eq!((drop_factor(0.0), drop_factor(1e300)), (2.0 / 3.0, 1.0));
    }

    /// The two pieces differ by 0.4 % where they meet.
    #[test]
    fn drag_laws_meet() {
        let (a, b): (f64, f64) = (transitional(TURBULENT), turbulent(TURBULENT));
        assert!((b / a - 1.0).abs() < 5e-3 && b > a);
        assert_eq!(transitional(0.0), 1.0);
    }
}
