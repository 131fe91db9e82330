//! Matrices of a shaft element along its axis (displacement) and about it (rotation), over the values at both ends.
//!
//! ```text
//! k = 1/int 1/a dz,   n(z) = k int_0^z 1/a dt,   N = (1 - n, n),   M = int m N'N dz,   K = k [1 -1; -1 1]
//! ```
//!
//! Along the axis a = E A and m = rho A, about it a = 2 G I and m = 2 rho I. The mid-section form of a cone takes A and I of a cylinder with the means of the
//! two end sections.

use super::element::{Cone, Element, GAUSS};
use laval_num::scalar::Scalar;

/// Matrices over the values at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<S> {
    /// Consistent inertia.
    pub mass: [[S; 2]; 2],
    /// Stiffness.
    pub stiffness: [[S; 2]; 2],
}

impl<S: Scalar> Element<S> {
    /// Along the axis: kg, N/m.
    pub fn axial(&self) -> Line<S> {
        let (e, rho) = (self.material.modulus, self.material.density);
        self.line(|x| e * self.section(x).0 + self.layers.axial, |x| rho * self.section(x).0 + self.layers.mass)
    }
    /// About the axis: kg m^2, N m/rad.
    pub fn torsional(&self) -> Line<S> {
        let (g, rho) = (self.material.shear_modulus, self.material.density);
        let polar = |x: f64| self.section(x).1.scale(2.0);
        self.line(|x| g * polar(x) + self.layers.torsion, |x| rho * polar(x) + self.layers.rotary.scale(2.0))
    }
    /// Share of the motion of the second end at a share of the length, along the axis and about it.
    pub fn line_shape(&self, share: f64) -> [S; 2] {
        if self.cone == Cone::MidSection || self.is_uniform() {
            return [S::cst(share); 2];
        }
        let (e, g) = (self.material.modulus, self.material.shear_modulus);
        let axial = |x| e * self.section(x).0 + self.layers.axial;
        let torsion = |x| g * self.section(x).1.scale(2.0) + self.layers.torsion;
        [softness(&axial, share) / softness(&axial, 1.0), softness(&torsion, share) / softness(&torsion, 1.0)]
    }

    /// Of a stiffness and an inertia per length.
    fn line(&self, stiffness: impl Fn(f64) -> S, inertia: impl Fn(f64) -> S) -> Line<S> {
        let l = self.length;
        let (k, mass) = if self.cone == Cone::MidSection || self.is_uniform() {
            let m = (inertia(0.0) + inertia(1.0)).scale(0.5).scale(l / 6.0);
            ((stiffness(0.0) + stiffness(1.0)).scale(0.5).scale(1.0 / l), [[m.scale(2.0), m], [m, m.scale(2.0)]])
        } else {
            let whole = softness(&stiffness, 1.0);
            let mut mass = [[S::zero(); 2]; 2];
            for (x, weight) in GAUSS {
                let n = softness(&stiffness, x) / whole;
                let (m, shape) = (inertia(x).scale(weight * l), [S::one() - n, n]);
                for i in 0..2 {
                    for j in 0..2 {
                        mass[i][j] += m * shape[i] * shape[j];
                    }
                }
            }
            (S::one() / whole.scale(l), mass)
        };
        Line { mass, stiffness: [[k, -k], [-k, k]] }
    }
}

/// `int_0^x 1/a dt`.
fn softness<S: Scalar>(a: &impl Fn(f64) -> S, x: f64) -> S {
    let mut out = S::zero();
    for (share, weight) in GAUSS {
        out += (S::one() / a(share * x)).scale(weight * x);
    }
    out
}
