//! Matrices of one shaft element in one plane, over deflection and slope at both ends: `u = (w1, s1, w2, s2)`.
//!
//! Uniform element, with `d = 1 + phi`, `phi = 12 E I/(kappa G A L^2)`; in matrices symmetric entries once:
//!
//! ```text
//! K  = E I/(d L^3) [ 12, 6 L, -12, 6 L | (4 + phi) L^2, -6 L, (2 - phi) L^2 | 12, -6 L | (4 + phi) L^2 ]
//! Ka = P/(30 L d^2) [ a, 3 L, -a, 3 L | b, -3 L, -c | a, -3 L | b ]
//!      a = 36 + 60 phi + 30 phi^2,  b = (4 + 5 phi + 2.5 phi^2) L^2,  c = (1 + 5 phi + 2.5 phi^2) L^2
//! ```
//!
//! Conical element by flexibility: clamped at its first end and loaded at the other by a force V and a moment m,
//!
//! ```text
//! M(z) = m + V (L - z),   s(z) = int_0^z M/(E I) dt,   w(z) = int_0^z (z - t) M/(E I) dt + int_0^z V/(kappa G A) dt
//! [w; s](z) = F(z) [V; m],   f = F(L),   T = [-1 -L 1 0; 0 -1 0 1]
//! K = T' f^-1 T,   [w; s](z) = ([1 z 0 0; 0 1 0 0] + F(z) f^-1 T) u = [N; R] u
//! ```
//!
//! Both: `M = int rho (A N'N + I R'R) dz`, `G = int 2 rho I R'R dz`, `Ka = P int (dN/dz)'(dN/dz) dz`.
//!
//! Sources: J. S. Przemieniecki, Theory of Matrix Structural Analysis, McGraw-Hill 1968, sections 5.6 and 11; H. D. Nelson, J. Mech. Des. 102 (1980) 793.

use laval_num::scalar::Scalar;
use std::f64::consts::PI;

/// A symmetric or square matrix over the four coordinates of an element in one plane.
pub type M4<S> = [[S; 4]; 4];

/// Material and laws of an element.
#[derive(Clone, Copy, Debug)]
pub struct Material<S> {
    /// E, Pa.
    pub modulus: S,
    /// G, Pa.
    pub shear_modulus: S,
    /// rho, kg/m^3.
    pub density: S,
}

/// How shear deflection counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shear {
    /// By Cowper's coefficient.
    Cowper,
    /// By Hutchinson's coefficient.
    Hutchinson,
    /// Not at all: a beam of Euler and Bernoulli.
    None,
}

/// Matrices of conical elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cone {
    /// From the flexibility of the cone.
    Flexibility,
    /// With the shape functions of a uniform element of the section at mid-length.
    MidSection,
}

/// One element: length, outer and inner diameters at both ends.
#[derive(Clone, Copy, Debug)]
pub struct Element<S> {
    /// L, m.
    pub length: f64,
    /// Outer diameters, m.
    pub outer: [S; 2],
    /// Inner diameters, m.
    pub inner: [S; 2],
    /// Material.
    pub material: Material<S>,
    /// Shear deflection.
    pub shear: Shear,
    /// Conical form.
    pub cone: Cone,
    /// Of cylindrical layers on it or in it.
    pub layers: Layers<S>,
}

/// What cylindrical layers add to a section: stiffnesses and inertia add up, as layers and core bend by the same slope and shear by the same angle.
#[derive(Clone, Copy, Debug)]
pub struct Layers<S> {
    /// Sum of E I, N m^2.
    pub bending: S,
    /// Sum of kappa G A, N.
    pub shear: S,
    /// Sum of E A, N.
    pub axial: S,
    /// Sum of 2 G I, N m^2.
    pub torsion: S,
    /// Sum of rho A, kg/m.
    pub mass: S,
    /// Sum of rho I, kg m.
    pub rotary: S,
}

impl<S: Scalar> Layers<S> {
    /// Without layers.
    pub fn none() -> Self {
        Layers { bending: S::zero(), shear: S::zero(), axial: S::zero(), torsion: S::zero(), mass: S::zero(), rotary: S::zero() }
    }
    /// With one more, of these diameters (m), of which this share of the stiffness counts.
    #[must_use]
    pub fn with(self, [inner, outer]: [S; 2], material: Material<S>, shear: Shear, share: S) -> Self {
        let (i, o) = (inner * inner, outer * outer);
        let (area, second) = ((o - i).scale(PI / 4.0), (o * o - i * i).scale(PI / 64.0));
        let g = shear_factor(shear, material, (inner / outer).square()).map_or(S::zero(), |k| k * material.shear_modulus);
        Layers {
            bending: self.bending + material.modulus * share * second,
            shear: self.shear + g * share * area,
            axial: self.axial + material.modulus * share * area,
            torsion: self.torsion + material.shear_modulus.scale(2.0) * share * second,
            mass: self.mass + material.density * area,
            rotary: self.rotary + material.density * second,
        }
    }
}

/// Cowper's or Hutchinson's coefficient; m2 square of inner over outer diameter. `None` without shear deflection.
fn shear_factor<S: Scalar>(shear: Shear, material: Material<S>, m2: S) -> Option<S> {
    let nu = material.modulus / material.shear_modulus.scale(2.0) - S::one();
    let q = (S::one() + m2).square();
    let number = S::cst;
    Some(match shear {
        Shear::None => return None,
        Shear::Cowper => q.scale(6.0) * (S::one() + nu) / (q * (number(7.0) + nu.scale(6.0)) + m2 * (number(20.0) + nu.scale(12.0))),
        Shear::Hutchinson => {
            let a = number(7.0) + nu.scale(12.0) + nu.square().scale(4.0);
            let b = number(5.0) + nu.scale(6.0) + nu.square().scale(2.0);
            q.scale(6.0) * (S::one() + nu) / (q * a + (m2 * b).scale(4.0))
        }
    })
}

/// Matrices of one plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<S> {
    /// Translational and rotary inertia.
    pub mass: M4<S>,
    /// Gyroscopic coupling with the other plane, per spin speed.
    pub gyroscopic: M4<S>,
    /// Elastic stiffness.
    pub stiffness: M4<S>,
    /// Stiffness of an axial force of 1 N.
    pub axial: M4<S>,
}

/// Points and weights of Gauss' rule of five points on [0, 1].
pub(super) const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Field of an element at one place: deflection, slope of the section, and derivative of the deflection, over `u`.
struct Field<S> {
    deflection: [S; 4],
    slope: [S; 4],
    gradient: [S; 4],
}

impl<S: Scalar> Element<S> {
    fn at(ends: [S; 2], share: f64) -> S {
        ends[0].scale(1.0 - share) + ends[1].scale(share)
    }
    /// Area (m^2) and second moment (m^4) at a share of the length.
    pub fn section(&self, share: f64) -> (S, S) {
        let (o, i) = (Self::at(self.outer, share).square(), Self::at(self.inner, share).square());
        ((o - i).scale(PI / 4.0), (o * o - i * i).scale(PI / 64.0))
    }
    pub(super) fn is_uniform(&self) -> bool {
        (self.outer[0] - self.outer[1]).is_nothing() && (self.inner[0] - self.inner[1]).is_nothing()
    }
    /// E I at a share of the length, N m^2.
    pub fn bending(&self, share: f64) -> S {
        self.material.modulus * self.section(share).1 + self.layers.bending
    }
    /// Mass and rotary inertia per length at a share of it, kg/m and kg m.
    fn inertia_at(&self, share: f64) -> (S, S) {
        let (area, second) = self.section(share);
        (self.material.density * area + self.layers.mass, self.material.density * second + self.layers.rotary)
    }
    /// kappa G of the core at mid-length, Pa; `None` without shear deflection.
    fn shear_stiffness(&self) -> Option<S> {
        let m2 = ((self.inner[0] + self.inner[1]) / (self.outer[0] + self.outer[1])).square();
        shear_factor(self.shear, self.material, m2).map(|kappa| kappa * self.material.shear_modulus)
    }
    /// kappa G A at a share of the length, N, with kappa G of the core at mid-length.
    fn shearing(&self, core: S, share: f64) -> S {
        core * self.section(share).0 + self.layers.shear
    }
    fn phi(&self) -> S {
        self.shear_stiffness().map_or(S::zero(), |g| self.bending(0.5).scale(12.0 / self.length.powi(2)) / self.shearing(g, 0.5))
    }

    /// Mass, kg, and moment of inertia about the axis, kg m^2.
    pub fn inertia(&self) -> (S, S) {
        let mut sum = (S::zero(), S::zero());
        for (share, weight) in GAUSS {
            let (line, tilting) = self.inertia_at(share);
            sum.0 += line.scale(weight * self.length);
            sum.1 += tilting.scale(2.0 * weight * self.length);
        }
        sum
    }

    /// All matrices.
    pub fn plane(&self) -> Plane<S> {
        match (self.is_uniform(), self.cone) {
            (true, _) => self.uniform(),
            (false, Cone::MidSection) => {
                let (phi, length) = (self.phi(), self.length);
                let shearing = self.shear_stiffness();
                let mut out = self.integrated(|x| uniform_field(length, phi, x));
                for (share, weight) in GAUSS {
                    let (bend, shear) = strains(length, phi, share);
                    add_square(&mut out.stiffness, &bend, self.bending(share).scale(weight * length));
                    if let Some(g) = shearing {
                        add_square(&mut out.stiffness, &shear, self.shearing(g, share).scale(weight * length));
                    }
                }
                out
            }
            (false, Cone::Flexibility) => {
                let flexible = Flexibility::new(self);
                let mut out = self.integrated(|x| flexible.field(self, x));
                out.stiffness = flexible.stiffness;
                out
            }
        }
    }

    /// Deflection and slope at a share of the length, over `u`.
    pub fn shape(&self, share: f64) -> [[S; 4]; 2] {
        let field = match (self.is_uniform(), self.cone) {
            (true, _) | (false, Cone::MidSection) => uniform_field(self.length, self.phi(), share),
            (false, Cone::Flexibility) => Flexibility::new(self).field(self, share),
        };
        [field.deflection, field.slope]
    }

    /// `int R' dR/dz' dz` of the slopes of a beam without shear, to be multiplied by a torque: entry (i, j) is `int R_i' R_j dz`.
    pub fn torque(&self) -> M4<f64> {
        let l = self.length;
        let mut out = [[0.0; 4]; 4];
        for (x, weight) in GAUSS {
            let slope = [6.0 * (x * x - x) / l, 1.0 - 4.0 * x + 3.0 * x * x, -6.0 * (x * x - x) / l, -2.0 * x + 3.0 * x * x];
            let bend = [(12.0 * x - 6.0) / (l * l), (6.0 * x - 4.0) / l, -(12.0 * x - 6.0) / (l * l), (6.0 * x - 2.0) / l];
            for (row, b) in out.iter_mut().zip(bend) {
                row.iter_mut().zip(slope).for_each(|(x, s)| *x += weight * l * b * s);
            }
        }
        out
    }

    /// Inertia and the stiffness of an axial force by integration over the length.
    fn integrated(&self, field: impl Fn(f64) -> Field<S>) -> Plane<S> {
        let zero = [[S::zero(); 4]; 4];
        let mut out = Plane { mass: zero, gyroscopic: zero, stiffness: zero, axial: zero };
        for (share, weight) in GAUSS {
            let (f, (line, tilting)) = (field(share), self.inertia_at(share));
            add_square(&mut out.mass, &f.deflection, line.scale(weight * self.length));
            add_square(&mut out.mass, &f.slope, tilting.scale(weight * self.length));
            add_square(&mut out.gyroscopic, &f.slope, tilting.scale(2.0 * weight * self.length));
            add_square(&mut out.axial, &f.gradient, S::cst(weight * self.length));
        }
        out
    }

    fn uniform(&self) -> Plane<S> {
        let (l, phi) = (self.length, self.phi());
        let one = S::one();
        let (d, phi2) = (one + phi, phi.square());
        let poly = |a: f64, b: f64, c: f64| S::cst(a) + phi.scale(b) + phi2.scale(c);
        let (line, tilting) = self.inertia_at(0.5);
        let d2 = recip(d * d);
        let (translational, rotary) = (line.scale(l) * d2, tilting.scale(1.0 / l) * d2);
        let couple = poly(13.0 / 420.0, 3.0 / 40.0, 1.0 / 24.0).scale(l);
        let tm = symmetric(
            poly(13.0 / 35.0, 0.7, 1.0 / 3.0),
            poly(11.0 / 210.0, 11.0 / 120.0, 1.0 / 24.0).scale(l),
            poly(9.0 / 70.0, 0.3, 1.0 / 6.0),
            -couple,
            poly(1.0 / 105.0, 1.0 / 60.0, 1.0 / 120.0).scale(l * l),
            -poly(1.0 / 140.0, 1.0 / 60.0, 1.0 / 120.0).scale(l * l),
        );
        let lean = poly(0.1, -0.5, 0.0).scale(l);
        let rm = symmetric(
            S::cst(1.2),
            lean,
            S::cst(-1.2),
            lean,
            poly(2.0 / 15.0, 1.0 / 6.0, 1.0 / 3.0).scale(l * l),
            poly(-1.0 / 30.0, -1.0 / 6.0, 1.0 / 6.0).scale(l * l),
        );
        let k = self.bending(0.5) * recip(d.scale(l.powi(3)));
        let km = symmetric(
            S::cst(12.0),
            S::cst(6.0 * l),
            S::cst(-12.0),
            S::cst(6.0 * l),
            poly(4.0, 1.0, 0.0).scale(l * l),
            poly(2.0, -1.0, 0.0).scale(l * l),
        );
        let a = poly(36.0, 60.0, 30.0);
        let am = symmetric(a, S::cst(3.0 * l), -a, S::cst(3.0 * l), poly(4.0, 5.0, 2.5).scale(l * l), -poly(1.0, 5.0, 2.5).scale(l * l));
        Plane {
            mass: sum(tm, translational, rm, rotary),
            gyroscopic: sum(rm, rotary.scale(2.0), rm, S::zero()),
            stiffness: sum(km, k, km, S::zero()),
            axial: sum(am, d2.scale(1.0 / (30.0 * l)), am, S::zero()),
        }
    }
}

/// A symmetric matrix that is the same seen from both ends: entries 11, 12, 13, 14, 22, 24.
fn symmetric<S: Scalar>(e11: S, e12: S, e13: S, e14: S, e22: S, e24: S) -> M4<S> {
    [[e11, e12, e13, e14], [e12, e22, -e14, e24], [e13, -e14, e11, -e12], [e14, e24, -e12, e22]]
}

fn recip<S: Scalar>(x: S) -> S {
    S::one() / x
}

fn sum<S: Scalar>(a: M4<S>, x: S, b: M4<S>, y: S) -> M4<S> {
    let mut out = a;
    for (row, other) in out.iter_mut().zip(b) {
        row.iter_mut().zip(other).for_each(|(a, b)| *a = *a * x + b * y);
    }
    out
}

/// Adds `weight f f'`.
fn add_square<S: Scalar>(out: &mut M4<S>, f: &[S; 4], weight: S) {
    for (row, &a) in out.iter_mut().zip(f) {
        row.iter_mut().zip(f).for_each(|(x, &b)| *x += weight * a * b);
    }
}

/// The field of a uniform element.
fn uniform_field<S: Scalar>(l: f64, phi: S, x: f64) -> Field<S> {
    let r = recip(S::one() + phi);
    let n = |a: f64, b: f64| (S::cst(a) + phi.scale(b)) * r;
    let (x2, x3) = (x * x, x * x * x);
    let lean = n(6.0 * (x2 - x) / l, 0.0);
    let fall = n((6.0 * (x2 - x)) / l, -1.0 / l);
    Field {
        deflection: [
            n(1.0 - 3.0 * x2 + 2.0 * x3, 1.0 - x),
            n(l * (x - 2.0 * x2 + x3), 0.5 * l * (x - x2)),
            n(3.0 * x2 - 2.0 * x3, x),
            n(l * (x3 - x2), -0.5 * l * (x - x2)),
        ],
        slope: [lean, n(1.0 - 4.0 * x + 3.0 * x2, 1.0 - x), -lean, n(3.0 * x2 - 2.0 * x, x)],
        gradient: [fall, n(1.0 - 4.0 * x + 3.0 * x2, 0.5 * (1.0 - 2.0 * x)), -fall, n(3.0 * x2 - 2.0 * x, -0.5 * (1.0 - 2.0 * x))],
    }
}

/// Curvature and shear angle of a uniform element.
fn strains<S: Scalar>(l: f64, phi: S, x: f64) -> ([S; 4], [S; 4]) {
    let r = recip(S::one() + phi);
    let n = |a: f64, b: f64| (S::cst(a) + phi.scale(b)) * r;
    let f = uniform_field(l, phi, x);
    let bend = n((12.0 * x - 6.0) / (l * l), 0.0);
    let curvature = [bend, n((6.0 * x - 4.0) / l, -1.0 / l), -bend, n((6.0 * x - 2.0) / l, 1.0 / l)];
    let mut shear = f.gradient;
    shear.iter_mut().zip(f.slope).for_each(|(g, s)| *g -= s);
    (curvature, shear)
}

/// The flexibility of a conical element.
struct Flexibility<S> {
    /// f^-1 T: force and moment at the second end over `u`.
    loads: [[S; 4]; 2],
    stiffness: M4<S>,
}

/// Integrals from the first end: of 1/(E I), t/(E I), t^2/(E I), 1/(kappa G A).
type Integrals<S> = [S; 4];

impl<S: Scalar> Flexibility<S> {
    fn new(e: &Element<S>) -> Self {
        let l = e.length;
        let [[f11, f12], [f21, f22]] = tip(&integrals(e, 1.0), l, l);
        let det = recip(f11 * f22 - f12 * f21);
        let inverse = [[f22 * det, -(f12 * det)], [-(f21 * det), f11 * det]];
        let (zero, one) = (S::zero(), S::one());
        let t = [[-one, S::cst(-l), one, zero], [zero, -one, zero, one]];
        let mut loads = [[zero; 4]; 2];
        for (row, own) in loads.iter_mut().zip(inverse) {
            for (j, x) in row.iter_mut().enumerate() {
                *x = own[0] * t[0][j] + own[1] * t[1][j];
            }
        }
        let mut stiffness = [[zero; 4]; 4];
        for (i, row) in stiffness.iter_mut().enumerate() {
            for (j, x) in row.iter_mut().enumerate() {
                *x = t[0][i] * loads[0][j] + t[1][i] * loads[1][j];
            }
        }
        Flexibility { loads, stiffness }
    }
    fn field(&self, e: &Element<S>, share: f64) -> Field<S> {
        let (z, l) = (share * e.length, e.length);
        let own = integrals(e, share);
        let [w, s] = tip(&own, z, l);
        let shear = e.shear_stiffness().map_or(S::zero(), |g| recip(e.shearing(g, share)));
        let (zero, one) = (S::zero(), S::one());
        let rigid = [[one, S::cst(z), zero, zero], [zero, one, zero, zero], [zero, one, zero, zero]];
        let along = [w, s, [s[0] + shear, s[1]]];
        let mut out = rigid;
        for k in 0..3 {
            for j in 0..4 {
                out[k][j] += along[k][0] * self.loads[0][j] + along[k][1] * self.loads[1][j];
            }
        }
        let [deflection, slope, gradient] = out;
        Field { deflection, slope, gradient }
    }
}

/// F(z): deflection and slope at z for a unit force and a unit moment at the second end.
fn tip<S: Scalar>(&[j0, j1, j2, h]: &Integrals<S>, z: f64, l: f64) -> [[S; 2]; 2] {
    [[j0.scale(z * l) - j1.scale(z + l) + j2 + h, j0.scale(z) - j1], [j0.scale(l) - j1, j0]]
}

/// The integrals up to a share of the length, in pieces of the rule.
fn integrals<S: Scalar>(e: &Element<S>, share: f64) -> Integrals<S> {
    const PIECES: usize = 4;
    let mut out = [S::zero(); 4];
    let step = share / PIECES as f64;
    let shear = e.shear_stiffness();
    for k in 0..PIECES {
        for (x, weight) in GAUSS {
            let at = step * (k as f64 + x);
            let (t, weight) = (at * e.length, weight * step * e.length);
            let soft = recip(e.bending(at)).scale(weight);
            out[0] += soft;
            out[1] += soft.scale(t);
            out[2] += soft.scale(t * t);
            if let Some(g) = shear {
                out[3] += recip(e.shearing(g, at)).scale(weight);
            }
        }
    }
    out
}
