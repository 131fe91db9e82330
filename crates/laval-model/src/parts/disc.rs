//! A rigid disc: two lateral coordinates, or four with tilt and gyroscopic coupling.
//!
//! Equations, with `z = x + i y` the displacement of the reference point, `theta = alpha + i beta` the rotation vector, spin angle `phi`,
//! `W = phi'`, centre of mass at height `h` above the reference point (`z_c = z + h (beta - i alpha)`), `p = m e exp(i (phi + phi_e))`,
//! `t = tau exp(i (phi + phi_t))`:
//!
//! ```text
//! m z_c''                                        = (W^2 - i W') p
//! A theta'' - i C W theta' - (i/2) C W' theta    = [(A - C) W^2 - i (A - C/2) W'] t     (and the moment of the force at h)
//! (C + m e^2 + (A - C) tau^2) W' + Im(conj(p) z_c'') + (C/2)(alpha'' beta - alpha beta'') + skew terms = torque
//! ```
//!
//! Symbols: m mass, kg; e eccentricity, m; A diametral and C polar moment of inertia about the centre of mass, kg m^2; tau skew, rad; phi_e, phi_t angles of
//! eccentricity and skew from the key mark, rad.
//!
//! Validity: small tilt; spin row linear in skew.
//!
//! Sources: `000_a291f7ede1484e56` sections 1.1 and 2.1 (planar rotor); tilt terms from the kinetic energy of a symmetric top to second order.

use crate::diagnostic::Diagnostics;
use crate::model::blocks::{Blocks, rotating};
use crate::model::field::{Bounds, Field, ParamValues, Values};
use crate::model::part::{At, Dof, Energy, Layout, Observed, Params, Part, Physics};
use crate::params;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;

params! {
    /// Parameters of a [`Disc`].
    pub struct DiscParams in DiscFamily {
        mass: scalar, "kg", Bounds::closed(1e-9, 1e7), required, "mass m";
        eccentricity: scalar, "m", Bounds::up_to(0.5), default 0.0, "distance e of the centre of mass from the shaft centre";
        eccentricity_phase: scalar, "rad", Bounds::within(1e3), default 0.0, "direction of the eccentricity from the key mark";
        unbalance: scalar, "kg m", Bounds::up_to(1e4), default 0.0, "additional unbalance in the direction of the eccentricity";
        polar_inertia: scalar, "kg m^2", Bounds::up_to(1e8), default 0.0, "polar moment of inertia C; left out it is 0, and neither a torque nor a run-up with drive = \"free\" counts this disc";
        diametral_inertia: scalar, "kg m^2", Bounds::up_to(1e8), default 0.0, "diametral moment of inertia A; when given, the disc tilts";
        skew: scalar, "rad", Bounds::within(0.5), default 0.0, "angle tau by which the principal axis is turned out of the shaft (dynamic unbalance)";
        skew_phase: scalar, "rad", Bounds::within(1e3), default 0.0, "angle phi_t from the key mark to the axis about which the skew turns; the upper end of the principal axis then leans a quarter turn behind it";
        centre_of_mass: scalar, "m", Bounds::within(100.0), default 0.0, "height h of the centre of mass above the reference point";
    }
}

/// See the [module](self).
pub struct Disc {
    tilts: bool,
}

impl Disc {
    /// Two coordinates: x, y.
    pub fn planar() -> Self {
        Disc { tilts: false }
    }
    /// Four coordinates: x, y and tilt; needs the inertias.
    pub fn tilting() -> Self {
        Disc { tilts: true }
    }
}

impl Disc {
    /// Centre-of-mass motion `x' + h beta', y' - h alpha'` of rates or accelerations.
    #[inline(always)]
    fn centre<S: Scalar>(&self, h: S, d: &[S]) -> Complex<S> {
        if self.tilts { c(d[0] + h * d[3], d[1] - h * d[2]) } else { c(d[0], d[1]) }
    }
}

impl Part for Disc {
    const KIND: &'static str = "disc";
    const EXAMPLE: &'static str = r#"name = "drum"
mass = "12 kg"
eccentricity = "20 um"
polar_inertia = "0.08 kg m^2"
diametral_inertia = "0.06 kg m^2"   # with it the disc tilts
skew = "0.1 mrad"                   # dynamic unbalance
"#;
    const DOC: &'static str = "A rigid disc on the shaft: mass, static unbalance, and with diametral_inertia also tilt, gyroscopic coupling \
        and dynamic unbalance. Other parts attach to it.";
    type Family = DiscFamily;
    const FIELDS: &'static [Field] = &[];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        Some(Disc { tilts: values.number("diametral_inertia").is_some_and(|x| x > 0.0) })
    }

    fn layout(&self) -> Layout {
        let mut own = Dof::lateral();
        if self.tilts {
            own.extend(Dof::tilt());
        }
        Layout::body(own)
    }

    fn physics(&self) -> Physics {
        Physics::Linear
    }

    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _speed: S, b: &mut Blocks<S>) {
        let one = S::one();
        b.mass[(0, 0)] = p.mass;
        b.mass[(1, 1)] = p.mass;
        let static_unbalance = rotating(p.mass * p.eccentricity + p.unbalance, p.eccentricity_phase);
        b.add_rotating([(0, one), (1, one)], static_unbalance, one, one);
        if self.tilts {
            let (a, cp, h) = (p.diametral_inertia, p.polar_inertia, p.centre_of_mass);
            let mh = p.mass * h;
            for (i, j, x) in [(0, 3, mh), (1, 2, -mh)] {
                b.mass[(i, j)] = x;
                b.mass[(j, i)] = x;
            }
            for i in [2, 3] {
                b.mass[(i, i)] = a + mh * h;
            }
            b.gyroscopic[(2, 3)] = cp;
            b.gyroscopic[(3, 2)] = -cp;
            b.spin_accel_stiffness[(2, 3)] = cp.scale(0.5);
            b.spin_accel_stiffness[(3, 2)] = cp.scale(-0.5);
            b.add_rotating([(3, h), (2, -h)], static_unbalance, one, one);
            b.add_rotating([(2, one), (3, one)], rotating(p.skew, p.skew_phase), a - cp, a - cp.scale(0.5));
        }
    }

    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        let u = p.mass * p.eccentricity + p.unbalance;
        let turning = Complex::cis(at.phase + p.eccentricity_phase).scale(u);
        let zc = self.centre(p.centre_of_mass, at.a);
        let mut r = self.spin_inertia(p) * at.spin_accel + (turning.conj() * zc).im;
        if self.tilts {
            let (a, cp) = (p.diametral_inertia, p.polar_inertia);
            r += (at.a[2] * at.q[3] - at.q[2] * at.a[3]) * cp.scale(0.5);
            let t = Complex::cis(at.phase + p.skew_phase).scale(p.skew);
            let (theta, rate, accel) = (c(at.q[2], at.q[3]), c(at.v[2], at.v[3]), c(at.a[2], at.a[3]));
            let (c1, c2) = (a - cp.scale(0.5), cp.scale(-0.5));
            r += c1 * (accel.conj() * t.mul_i()).re;
            r += c2 * (at.spin_accel * (theta.conj() * t).re + at.speed * (rate.conj() * t).re).scale(2.0);
            r += c2 * at.speed * at.speed * (theta.conj() * t.mul_i()).re;
        }
        r
    }

    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let u = p.mass * p.eccentricity + p.unbalance;
        let turning = Complex::cis(at.phase + p.eccentricity_phase).scale(u);
        let vc = self.centre(p.centre_of_mass, at.v);
        let w = at.speed;
        let mut t = (p.mass * vc.norm_sqr() + self.spin_inertia(p) * w * w).scale(0.5) + w * (turning.conj() * vc).im;
        if self.tilts {
            let (a, cp) = (p.diametral_inertia, p.polar_inertia);
            let (theta, rate) = (c(at.q[2], at.q[3]), c(at.v[2], at.v[3]));
            let skew = Complex::cis(at.phase + p.skew_phase).scale(p.skew);
            t += (a * rate.norm_sqr()).scale(0.5) + (cp * w * (rate.re * theta.im - theta.re * rate.im)).scale(0.5);
            t += (a - cp.scale(0.5)) * w * (rate.conj() * skew.mul_i()).re - cp.scale(0.5) * w * w * (theta.conj() * skew).re;
        }
        Some(Energy { stored: t, ..Energy::zero() })
    }

    fn shape(&self, _: &Params<Self, f64>, z: f64) -> Vec<[f64; 4]> {
        let mut columns = vec![[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]];
        if self.tilts {
            // x + z beta, y - z alpha
            columns.extend([[0.0, -z, 1.0, 0.0], [z, 0.0, 0.0, 1.0]]);
        }
        columns
    }

    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "displacement", unit: "m", value: at.q[0].hypot(at.q[1]) });
        let centre = self.centre(p.centre_of_mass, at.q)
            + Complex::cis(at.phase + p.eccentricity_phase).scale(p.eccentricity + p.unbalance / p.mass);
        out.push(Observed { name: "centre of mass", unit: "m", value: centre.re.hypot(centre.im) });
    }

    fn lacks_spin_inertia(&self, p: &Params<Self, f64>) -> Option<&'static str> {
        (p.polar_inertia == 0.0).then_some("polar_inertia")
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, String)> {
        let mut wrong = Vec::new();
        if self.tilts && p.polar_inertia > 2.0 * p.diametral_inertia {
            wrong.push((
                "polar_inertia",
                format!(
                    "no body has a polar inertia ({} kg m^2) above twice its diametral inertia ({} kg m^2); a thin disc has just twice",
                    p.polar_inertia, p.diametral_inertia
                ),
            ));
        }
        if !self.tilts && (p.skew != 0.0 || p.centre_of_mass != 0.0) {
            let field = if p.skew != 0.0 { "skew" } else { "centre_of_mass" };
            wrong.push((field, format!("{field} acts on the tilt, and this disc does not tilt: give diametral_inertia as well")));
        }
        wrong
    }
}

impl Disc {
    #[inline(always)]
    fn spin_inertia<S: Scalar>(&self, p: &DiscParams<S>) -> S {
        let u = p.mass * p.eccentricity + p.unbalance;
        let skew = if self.tilts { (p.diametral_inertia - p.polar_inertia) * p.skew * p.skew } else { S::zero() };
        p.polar_inertia + u * u / p.mass + skew
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::params::Family;

    #[test]
    fn mistakes_are_told() {
        let p = DiscParams { mass: 1.0, diametral_inertia: 0.01, polar_inertia: 0.03, ..DiscFamily::defaults() };
        let wrong = Disc::tilting().check(&p);
        assert_eq!(wrong[0].0, "polar_inertia");
        assert!(wrong[0].1.contains("above twice its diametral inertia"));
        // a thin disc is at the limit
        assert!(Disc::tilting().check(&DiscParams { polar_inertia: 0.02, ..p }).is_empty());
        let skewed = DiscParams { mass: 1.0, skew: 0.01, ..DiscFamily::defaults() };
        assert!(Disc::planar().check(&skewed)[0].1.contains("give diametral_inertia"));
        assert_eq!(Disc::planar().check(&DiscParams { skew: 0.0, centre_of_mass: 0.1, ..skewed })[0].0, "centre_of_mass");
    }

    /// Unbalance in two languages: m e and an unbalance are the same force.
    #[test]
    fn eccentricity_and_unbalance_are_one() {
        let base = DiscParams { mass: 2.0, eccentricity_phase: 0.3, ..DiscFamily::defaults() };
        let blocks = |p: &DiscParams| {
            let mut b = Blocks::default();
            b.reset(2, 0, 50.0);
            Disc::planar().linear(p, 50.0, &mut b);
            (b.force_cos, b.force_sin)
        };
        let (x, y) = blocks(&DiscParams { eccentricity: 1e-3, ..base });
        assert_eq!((x.clone(), y), blocks(&DiscParams { unbalance: 2e-3, ..base }));
        assert!((x[0] - 2e-3 * 2500.0 * 0.3f64.cos()).abs() < 1e-15 && (x[1] - 2e-3 * 2500.0 * 0.3f64.sin()).abs() < 1e-15);
    }
}

crate::conformance! {
    Disc {
        planar: Disc::planar(),
            DiscParams { mass: 2.4, eccentricity: 1e-3, eccentricity_phase: 0.7, unbalance: 3e-4, polar_inertia: 0.02, ..DiscFamily::defaults() },
            Options::default();
        tilting: Disc::tilting(),
            DiscParams {
                mass: 2.4, eccentricity: 1e-3, eccentricity_phase: 0.7, unbalance: 3e-4, polar_inertia: 0.02, diametral_inertia: 0.013,
                skew: 0.02, skew_phase: -0.4, centre_of_mass: 0.06,
            },
            Options::default();
    }
}
