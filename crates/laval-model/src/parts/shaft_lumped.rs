//! A massless elastic shaft, or support, between two points: one stiffness matrix, with optional damping of its material.
//!
//! Equations, on the motion `u = (x, y, alpha, beta)` of the first point relative to the second (tilt only where the shaft couples to it):
//!
//! ```text
//! K = [ kx   kxy   .    kc ]      f = K u                                 elastic
//!     [ kxy  ky   -kc   .  ]      f = K u + b K (u' - W R u)              with material damping, in axes that turn with the rotor
//!     [ .   -kc    kt   .  ]
//!     [ kc   .     .    kt ]      R: (x, y, alpha, beta) -> (-y, x, -beta, alpha)
//! ```
//!
//! Symbols: kx, ky, kxy stiffness, N/m; kc coupling of deflection and tilt, N/rad (moment per deflection, and force per tilt); kt tilt stiffness,
//! N m/rad; b = c/k damping of the material as a time, s; W spin speed, rad/s. Slopes are beta = dx/dz, alpha = -dy/dz.
//! A shaft clamped at the second point, length L, bending stiffness EI, with the first point at its end: k = 12 EI/L^3, kc = -6 EI/L^2,
//! kt = 4 EI/L (z from the clamp to the end; kc = +6 EI/L^2 where the end hangs below the clamp). Where the second body tilts too, give both points at the same height.
//!
//! Validity: mass of the shaft small against what it carries; unequal stiffness in x and y belongs to fixed axes (a support, not a shaft with flats).
//!
//! Sources: any text on beams for the matrix; A. L. Kimball, Gen. Electr. Rev. 27 (1924) for damping in rotor axes.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, Layout, Link, Observed, Params, Part, Physics};
use crate::params;
use crate::units::format_si;
use laval_num::scalar::Scalar;

params! {
    /// Parameters of a [`ShaftLumped`].
    pub struct ShaftLumpedParams in ShaftLumpedFamily {
        stiffness: lateral, "N/m", Bounds::up_to(1e15), required, "stiffness k (kx, ky)";
        cross_stiffness: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness kxy = kyx of a support whose main axes are not x and y";
        coupling: scalar, "N/rad", Bounds::within(1e15), default 0.0, "coupling kc of deflection and tilt: the moment about y per deflection along x. Negative where the first point lies above what holds the shaft (towards larger z), positive where it hangs below; a shaft of length L and bending stiffness EI clamped at its other end has -6 EI/L^2 or +6 EI/L^2, with stiffness 12 EI/L^3 and tilt_stiffness 4 EI/L";
        tilt_stiffness: scalar, "N m/rad", Bounds::up_to(1e15), default 0.0, "tilt stiffness kt; when given, the shaft acts on tilt";
        material_damping: scalar, "s", Bounds::up_to(1e3), default 0.0, "damping of the material b = c/k, in axes that turn with the rotor";
    }
}

/// A limit with four digits that does not exceed it, so that the value that is printed is admissible.
fn below(limit: f64) -> f64 {
    if !(limit > 0.0 && limit.is_finite()) {
        return limit;
    }
    let unit = 10f64.powi(limit.log10().floor() as i32 - 3);
    (limit / unit * (1.0 + 4.0 * f64::EPSILON)).floor() * unit
}

/// See the [module](self).
pub struct ShaftLumped {
    link: Link,
    tilts: bool,
    damped: bool,
}

impl ShaftLumped {
    /// Acts on displacements only.
    pub fn lateral(link: Link) -> Self {
        ShaftLumped { link, tilts: false, damped: false }
    }
    /// Acts on displacements and tilts.
    pub fn with_tilt(link: Link) -> Self {
        ShaftLumped { link, tilts: true, damped: false }
    }
    /// The same with damping of its material; it must be equal in x and y.
    pub fn damped(self) -> Self {
        ShaftLumped { damped: true, ..self }
    }
    fn size(&self) -> usize {
        if self.tilts { 4 } else { 2 }
    }
    #[inline(always)]
    fn matrix<S: Scalar>(p: &ShaftLumpedParams<S>) -> [[S; 4]; 4] {
        let (o, kc, kt, kxy) = (S::zero(), p.coupling, p.tilt_stiffness, p.cross_stiffness);
        [[p.stiffness[0], kxy, o, kc], [kxy, p.stiffness[1], -kc, o], [o, -kc, kt, o], [kc, o, o, kt]]
    }
    /// `K x` over the coordinates it acts on.
    #[inline(always)]
    fn apply<S: Scalar>(&self, k: &[[S; 4]; 4], x: &[S]) -> [S; 4] {
        let mut f = [S::zero(); 4];
        for (f, row) in f.iter_mut().zip(k).take(self.size()) {
            for (&k, &x) in row.iter().zip(&x[..self.size()]) {
                *f += k * x;
            }
        }
        f
    }
    /// `R x`: a quarter turn of each pair.
    #[inline(always)]
    fn quarter<S: Scalar>(&self, x: &[S]) -> [S; 4] {
        let mut r = [S::zero(); 4];
        for i in (0..self.size()).step_by(2) {
            (r[i], r[i + 1]) = (-x[i + 1], x[i]);
        }
        r
    }
    /// Rate seen in rotor axes and the damping force on it.
    #[inline(always)]
    fn slip<S: Scalar>(&self, p: &ShaftLumpedParams<S>, at: &At<S>) -> ([S; 4], [S; 4]) {
        let mut slip = self.quarter(at.q);
        for (s, &v) in slip.iter_mut().zip(at.v) {
            *s = v - at.speed * *s;
        }
        let mut force = self.apply(&Self::matrix(p), &slip);
        for f in &mut force {
            *f *= p.material_damping;
        }
        (slip, force)
    }
}

#[inline(always)]
fn dot<S: Scalar>(a: &[S], b: &[S]) -> S {
    let mut s = S::zero();
    for (&a, &b) in a.iter().zip(b) {
        s += a * b;
    }
    s
}

impl Part for ShaftLumped {
    const KIND: &'static str = "shaft_lumped";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
stiffness = "2.9e6 N/m"
material_damping = "2e-5 s"         # loss of the material, turning with the shaft
"#;
    const DOC: &'static str = "A massless elastic shaft or support between two points: stiffness in x and y, optionally coupled to the tilt of a \
        disc, and optionally with damping of the shaft's material, which turns with the rotor and destabilises above the critical speed.";
    type Family = ShaftLumpedFamily;
    const FIELDS: &'static [Field] = &[Field::required("between", FieldKind::Between, "the two points it joins, the carried one first")];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let nonzero = |name: &str| params.get(name).is_some_and(|x| x != 0.0);
        let (tilts, damped) = (nonzero("coupling") || nonzero("tilt_stiffness"), nonzero("material_damping"));
        let unequal = params.get("stiffness.x") != params.get("stiffness.y") || nonzero("cross_stiffness");
        if damped && unequal {
            diagnostics.push(
                Diagnostic::error("shaft_lumped.damping", "a shaft with material damping must be equally stiff in x and y")
                    .at(values.span_of("material_damping"))
                    .help("unequal stiffness in fixed axes is a support, which does not turn: use a damper part beside it"),
            );
        }
        Some(ShaftLumped { link: Link::Between(a, b), tilts, damped })
    }
    fn layout(&self) -> Layout {
        if self.tilts { Layout::point_and_tilt(self.link.clone()) } else { Layout::point(self.link.clone()) }
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let k = Self::matrix(p);
        for (i, row) in k.iter().enumerate().take(self.size()) {
            for j in 0..self.size() {
                b.stiffness[(i, j)] = row[j];
                if self.damped {
                    b.damping[(i, j)] = p.material_damping * row[j];
                    // -b K R: column j of K R is the partner column of K
                    let turned = if j % 2 == 0 { row[j + 1] } else { -row[j - 1] };
                    b.circulatory[(i, j)] = -(p.material_damping * turned);
                }
            }
        }
    }
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        if self.damped { -dot(&self.quarter(at.q), &self.slip(p, at).1) } else { S::zero() }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let stored = dot(at.q, &self.apply(&Self::matrix(p), at.q)).scale(0.5);
        let (slip, force) = self.slip(p, at);
        Some(Energy { stored, dissipated: dot(&slip, &force), ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let (f, damping) = (self.apply(&Self::matrix(p), at.q), self.slip(p, at).1);
        let total: Vec<f64> = f.iter().zip(damping).map(|(f, d)| f + d).collect();
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: total[0].hypot(total[1]) });
        if self.tilts {
            out.push(Observed { name: "moment", unit: "N m", value: total[2].hypot(total[3]) });
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, String)> {
        let [kx, ky] = p.stiffness;
        let mut wrong = Vec::new();
        if p.cross_stiffness * p.cross_stiffness > kx * ky {
            let limit = format_si(below((kx * ky).sqrt()), "N/m");
            wrong.push(("cross_stiffness", format!("cross_stiffness is at most sqrt(kx ky) = {limit}: more would push outwards")));
        } else if p.coupling != 0.0 && p.coupling * p.coupling > p.tilt_stiffness * least(p) {
            let limit = format_si(below((p.tilt_stiffness * least(p)).sqrt()), "N/rad");
            wrong.push((
                "coupling",
                format!("coupling is at most sqrt(stiffness tilt_stiffness) = {limit}: more would give energy when bent (a clamped shaft has 0.87 of that)"),
            ));
        }
        if !self.tilts && (p.coupling != 0.0 || p.tilt_stiffness != 0.0) {
            wrong.push(("tilt_stiffness", "this shaft was built without tilt".into()));
        }
        if !self.damped && p.material_damping != 0.0 {
            wrong.push(("material_damping", "this shaft was built without material damping".into()));
        }
        if self.damped && (kx != ky || p.cross_stiffness != 0.0) {
            wrong.push(("material_damping", "a shaft with material damping must be equally stiff in x and y".into()));
        }
        wrong
    }
}

/// Smaller main stiffness, N/m.
fn least(p: &ShaftLumpedParams) -> f64 {
    let [kx, ky] = p.stiffness;
    0.5 * (kx + ky) - (0.5 * (kx - ky)).hypot(p.cross_stiffness)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::{Attach, Value};
    use crate::model::params::Family;

    pub(super) fn joint() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }
    fn build(set: &[(&str, f64)]) -> (ShaftLumped, Vec<String>) {
        let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
        for (name, x) in [("stiffness.x", 1e6), ("stiffness.y", 1e6)].iter().chain(set) {
            params.set(name, *x);
        }
        let part = ShaftLumped::build(&values, &mut params, &mut d).unwrap();
        (part, d.0.iter().map(|d| d.to_string()).collect())
    }

    /// A cantilever: a force alone at its end bends it by F L^3/(3 EI) and tilts it by F L^2/(2 EI).
    #[test]
    fn clamped_shaft_has_the_flexibility_of_a_cantilever() {
        let (ei, l) = (5e3, 0.4);
        let p = ShaftLumpedParams {
            stiffness: [12.0 * ei / (l * l * l); 2],
            coupling: -6.0 * ei / (l * l),
            tilt_stiffness: 4.0 * ei / l,
            ..ShaftLumpedFamily::defaults()
        };
        let shaft = ShaftLumped::with_tilt(joint());
        assert!(shaft.check(&p).is_empty());
        let (deflection, slope) = (l * l * l / (3.0 * ei), l * l / (2.0 * ei));
        // force along x bends with beta = dx/dz; force along y with alpha = -dy/dz
        let f = shaft.apply(&ShaftLumped::matrix(&p), &[deflection, 0.0, 0.0, slope]);
        assert!((f[0] - 1.0).abs() < 1e-12 && f[1] == 0.0 && f[2] == 0.0 && f[3].abs() < 1e-12);
        let f = shaft.apply(&ShaftLumped::matrix(&p), &[0.0, deflection, -slope, 0.0]);
        assert!((f[1] - 1.0).abs() < 1e-12 && f[0] == 0.0 && f[2].abs() < 1e-12 && f[3] == 0.0);
    }

    /// The same hanging from its clamp: z is counted upwards, so that the slope dx/dz at its end has the other sign, and with it the coupling.
    #[test]
    fn a_hanging_shaft_has_the_other_sign_of_coupling() {
        let (ei, l) = (5e3, 0.4);
        let (deflection, slope) = (l * l * l / (3.0 * ei), -l * l / (2.0 * ei));
        let force = |coupling: f64| {
            let stiffness = [12.0 * ei / (l * l * l); 2];
            let p = ShaftLumpedParams { stiffness, coupling, tilt_stiffness: 4.0 * ei / l, ..ShaftLumpedFamily::defaults() };
            let shaft = ShaftLumped::with_tilt(joint());
            assert!(shaft.check(&p).is_empty());
            shaft.apply(&ShaftLumped::matrix(&p), &[deflection, 0.0, 0.0, slope])
        };
        let right = force(6.0 * ei / (l * l));
        assert!((right[0] - 1.0).abs() < 1e-12 && right[3].abs() < 1e-12, "{right:?}");
        // with the sign of a standing shaft the same bend would need seven times the force
        assert!((force(-6.0 * ei / (l * l))[0] - 7.0).abs() < 1e-12);
    }

    #[test]
    fn fields_choose_the_variant_and_mistakes_are_told() {
        assert_eq!(build(&[]).0.size(), 2);
        assert_eq!(build(&[("tilt_stiffness", 10.0)]).0.size(), 4);
        assert!(build(&[("material_damping", 1e-5)]).1.is_empty());
        assert!(build(&[("material_damping", 1e-5), ("stiffness.y", 2e6)]).1[0].contains("equally stiff"));
        let p = ShaftLumpedParams { stiffness: [1e6; 2], coupling: 2e4, tilt_stiffness: 100.0, ..ShaftLumpedFamily::defaults() };
        assert!(ShaftLumped::with_tilt(joint()).check(&p)[0].1.contains("at most sqrt"));
        let p = ShaftLumpedParams { stiffness: [1e6; 2], cross_stiffness: 2e6, ..ShaftLumpedFamily::defaults() };
        assert_eq!(ShaftLumped::lateral(joint()).check(&p)[0].0, "cross_stiffness");
    }
}

#[cfg(test)]
fn tried(stiffness: [f64; 2], cross_stiffness: f64, coupling: f64, tilt_stiffness: f64, material_damping: f64) -> ShaftLumpedParams {
    ShaftLumpedParams { stiffness, cross_stiffness, coupling, tilt_stiffness, material_damping }
}

crate::conformance! {
    ShaftLumped {
        lateral: ShaftLumped::lateral(tests::joint()), tried([1e6; 2], 0.0, 0.0, 0.0, 0.0), Options::default();
        support: ShaftLumped::lateral(tests::joint()), tried([1e6, 2e6], 3e5, 0.0, 0.0, 0.0), Options::anisotropic();
        tilting: ShaftLumped::with_tilt(tests::joint()), tried([1e6; 2], 0.0, -7e4, 1e4, 0.0), Options::default();
        tilting_support: ShaftLumped::with_tilt(tests::joint()), tried([1e6, 2e6], 3e5, -7e4, 1e4, 0.0), Options::anisotropic();
        damped: ShaftLumped::lateral(tests::joint()).damped(), tried([1e6; 2], 0.0, 0.0, 0.0, 2e-4), Options::default();
        damped_tilting: ShaftLumped::with_tilt(tests::joint()).damped(), tried([1e6; 2], 0.0, -7e4, 1e4, 2e-4), Options::default();
    }
}
