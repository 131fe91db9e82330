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
//! Unbalances u_k at heights z_k in directions phi_k (`unbalances`), with `U = p m + sum u_k exp(i (phi + phi_k))`:
//!
//! ```text
//! add (W^2 - i W') u_k exp(i (phi + phi_k)) at z_k,  Im(conj(u_k exp(i (phi + phi_k))) z_k'') to the torque
//! C + |U|^2/m + |sum u_k (z_k - h)|^2/A + (A - C) tau^2      in place of the factor of W': moments of inertia are those with the masses that make the unbalances
//! ```
//!
//! Along the axis `m u''`, about it `C (theta'' + W')` with theta the rotation relative to the spin, which adds `C theta''` to the torque.
//!
//! Validity: the unbalance does not couple with the rotation relative to the spin; tilt up to 0.1 rad, where its sine is 0.2 % less than the angle; spin row linear in skew.
//!
//! Theory: `docs/theory/machine.md#rigid-disc`.
//!
//! Sources: `000_a291f7ede1484e56` sections 1.1 and 2.1 (planar rotor); tilt terms from the kinetic energy of a symmetric top to second order.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::{Blocks, rotating};
use crate::model::capability::Extent;
use crate::model::capability::body::{BodyParameters, BodyPart};
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::params::{RowCounts, RowFamily, WithRows};
use crate::model::part::{At, Dof, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, PortKind, Validity};
use crate::params;
use crate::parts::speed_ratio::SPIN;
use crate::text;
use crate::text::Text;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Disc`].
    pub struct DiscParams in DiscFamily {
        mass: scalar, "kg", Bounds::up_to(1e7), required, "mass m";
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

/// Largest tilt, rad, whose square is left out.
const SMALL: f64 = 0.1;

params! {
    /// An unbalance of a [`Disc`] in a plane of its own.
    pub struct UnbalanceParams in UnbalanceFamily {
        unbalance: scalar, "kg m", Bounds::up_to(1e4), required, "size";
        phase: scalar, "rad", Bounds::within(1e3), default 0.0, "direction from the key mark";
        at: scalar, "m", Bounds::within(100.0), default 0.0, "height of its plane above the reference point, for a disc that tilts";
    }
}

impl RowFamily for UnbalanceFamily {
    const LIST: &'static str = "unbalances";
}

/// See the [module](self).
pub struct Disc {
    tilts: bool,
    /// Of a disc with coordinates of its own: it moves along the axis, it twists. What another body carries moves as that body does.
    along: [bool; 2],
    /// The point of another body that carries it; a disc without one has coordinates of its own.
    on: Option<Attach>,
    /// The part that gives the ratio of its spin.
    spin: Option<String>,
    /// How many unbalances it has in planes of their own.
    unbalances: usize,
}

impl Disc {
    /// Two coordinates: x, y.
    pub fn planar() -> Self {
        Disc { tilts: false, along: [false; 2], on: None, spin: None, unbalances: 0 }
    }
    /// Four coordinates: x, y and tilt; needs the inertias.
    pub fn tilting() -> Self {
        Disc { tilts: true, ..Self::planar() }
    }
    /// With displacement along the axis and rotation about it as well.
    pub fn coordinates(self, axial: bool, torsional: bool) -> Self {
        Disc { along: [axial, torsional], ..self }
    }
    /// Local coordinates of the displacement along the axis and of the rotation about it.
    #[inline(always)]
    fn axis(&self) -> [Option<usize>; 2] {
        let first = if self.tilts { 4 } else { 2 };
        let [axial, twist] = if self.on.is_some() { [true; 2] } else { self.along };
        [axial.then_some(first), twist.then_some(first + usize::from(axial))]
    }
    /// Fixed to a point of another body, as a shaft: it moves with it and has no coordinates of its own.
    pub fn on(self, attach: Attach) -> Self {
        Disc { on: Some(attach), ..self }
    }
    /// Turning with another spin than that of the machine: the name of the part that gives its ratio.
    pub fn spin(self, name: impl Into<String>) -> Self {
        Disc { spin: Some(name.into()), ..self }
    }
    /// With so many unbalances in planes of their own; they are rows of its parameters.
    pub fn unbalanced(self, unbalances: usize) -> Self {
        Disc { unbalances, ..self }
    }
    /// `U` at a spin angle.
    #[inline(always)]
    fn turning<S: Scalar>(&self, p: &Params<Self, S>, phase: S) -> Complex<S> {
        let mut sum = Complex::cis(phase + p.eccentricity_phase).scale(p.mass * p.eccentricity + p.unbalance);
        for u in &p.rows {
            sum += Complex::cis(phase + u.phase).scale(u.unbalance);
        }
        sum
    }
    /// `Im(conj(u) z')` of all unbalances, each with the motion (rate or acceleration) of its own height.
    #[inline(always)]
    fn carried<S: Scalar>(&self, p: &Params<Self, S>, phase: S, motion: &[S]) -> S {
        let own = Complex::cis(phase + p.eccentricity_phase).scale(p.mass * p.eccentricity + p.unbalance);
        let mut sum = (own.conj() * self.centre(p.centre_of_mass, motion)).im;
        for u in &p.rows {
            let turning = Complex::cis(phase + u.phase).scale(u.unbalance);
            sum += (turning.conj() * self.centre(u.at, motion)).im;
        }
        sum
    }
}

impl Disc {
    /// Centre-of-mass motion `x' + h beta', y' - h alpha'` of rates or accelerations.
    #[inline(always)]
    fn centre<S: Scalar>(&self, h: S, d: &[S]) -> Complex<S> {
        if self.tilts { c(d[0] + h * d[3], d[1] - h * d[2]) } else { c(d[0], d[1]) }
    }
}

/// Least mass of what has one, kg.
const LIGHTEST: f64 = 1e-9;

/// What is wrong with a mass that is not 0 and less than any body has.
pub(super) fn too_light(mass: f64) -> Option<Text> {
    let (mass, least) = (text::quantity(mass, "kg"), (mass > 0.0 && mass < LIGHTEST).then(|| text::quantity(LIGHTEST, "kg"))?);
    Some(text!("mass is {mass}; it must be 0, for a point without inertia, or at least {least}", mass, least))
}

/// `|U|^2/m`: the moment of inertia of masses that make an unbalance. The mass of an unbalance without any of its own belongs to what carries it.
#[inline(always)]
fn own<S: Scalar>(square: S, mass: S) -> S {
    mass.select_pos(square / mass.select_pos(mass, S::one()), mass.scale(0.0))
}

const UNBALANCES: &[(&str, &str, bool, &str)] = &[
    ("unbalance", "kg m", true, "size"),
    ("phase", "rad", false, "direction from the key mark"),
    ("at", "m", false, "height of its plane above the reference point, for a disc that tilts"),
];

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
        and dynamic unbalance. Other parts attach to it. With mass = 0 it is a point without inertia, as between two springs in series.";
    type Family = WithRows<DiscFamily, UnbalanceFamily>;
    const FIELDS: &'static [Field] = &[
        Field::optional(
            "on",
            FieldKind::Attach { ground: false },
            "",
            "the point of a shaft or of another body that it is fixed to and moves with; without it the disc has coordinates of its own",
        ),
        Field::optional("spin", FieldKind::Text, "", SPIN),
        Field::optional("axial", FieldKind::Flag, "false", "a disc with coordinates of its own also moves along its axis"),
        Field::optional(
            "torsional",
            FieldKind::Flag,
            "false",
            "a disc with coordinates of its own also twists: twist is its rotation relative to the spin",
        ),
        Field::optional(
            "unbalances",
            FieldKind::Columns(UNBALANCES),
            "",
            "several unbalances, in addition to eccentricity and unbalance: sizes, directions and heights",
        ),
    ];

    fn build(values: &Values, _: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let tilts = values.number("diametral_inertia").is_some_and(|x| x > 0.0);
        let along = ["axial", "torsional"].map(|name| values.flag(name) == Some(true));
        let on = values.attach("on").filter(|a| a.body.is_some());
        let disc = Disc { tilts, along, on, spin: values.text("spin").map(str::to_string), unbalances: 0 };
        if let (Some(_), Some(name)) = (&disc.on, ["axial", "torsional"].into_iter().find(|n| values.written(n))) {
            diagnostics.push(
                Diagnostic::error("disc.on", text!("{name} has no effect on a disc that another body carries", name))
                    .at(values.span_of(name))
                    .help(text!("it moves as that body does: say {name} of the body", name)),
            );
        }
        let Some(columns) = values.columns("unbalances") else { return Some(disc) };
        let sizes = columns.get("unbalance")?;
        let entry = |name: &str, k: usize| columns.get(name).and_then(|c| c.get(k)).copied().unwrap_or(0.0);
        let mut refuse = |message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("disc.unbalances", message).at(values.span_of("unbalances")).help(help));
        };
        if let Some(u) = sizes.iter().find(|u| !(0.0..=1e4).contains(*u)) {
            refuse(
                text!("an unbalance of {u}", u = text::quantity(*u, "kg m")),
                text!("sizes are positive; phase = \"180 deg\" turns one round"),
            );
            return None;
        }
        if (0..sizes.len()).any(|k| !(entry("phase", k).abs() <= 1e3 && entry("at", k).abs() <= 100.0)) {
            refuse(text!("an unbalance has no place"), text!("phase is an angle up to 1000 rad, at a height up to 100 m"));
            return None;
        }
        if !disc.tilts && (0..sizes.len()).any(|k| entry("at", k) != 0.0) {
            refuse(
                text!("the height of an unbalance acts on the tilt, and this disc does not tilt"),
                text!("give diametral_inertia as well, or leave at out"),
            );
            return None;
        }
        Some(disc.unbalanced(sizes.len()))
    }

    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        if let Some(attach) = &self.on {
            let link = Link::On(attach.clone());
            let port = PortKind { tilt: self.tilts, ..PortKind::ALL };
            return Layout { body: true, spin: self.spin.clone(), ..Layout::on(port, link) };
        }
        let mut own = Dof::lateral();
        if self.tilts {
            own.extend(Dof::tilt());
        }
        own.extend(self.along[0].then(Dof::axial));
        own.extend(self.along[1].then(Dof::twist));
        Layout { spin: self.spin.clone(), ..Layout::body(own) }
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
        for u in &p.rows {
            let (own, z) = (rotating(u.unbalance, u.phase), u.at);
            b.add_rotating([(0, one), (1, one)], own, one, one);
            if self.tilts {
                b.add_rotating([(3, z), (2, -z)], own, one, one);
            }
        }
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
        let [axial, twist] = self.axis();
        if let Some(i) = axial {
            b.mass[(i, i)] = p.mass;
        }
        if let Some(i) = twist {
            b.mass[(i, i)] = p.polar_inertia;
            b.spin_accel_force[i] = -p.polar_inertia;
        }
    }

    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        let mut r = self.spin_inertia(p) * at.spin_accel + self.carried(p, at.phase, at.a);
        if let Some(i) = self.axis()[1] {
            r += p.polar_inertia * at.a[i];
        }
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
        let vc = self.centre(p.centre_of_mass, at.v);
        let w = at.speed;
        let mut t = (p.mass * vc.norm_sqr() + self.spin_inertia(p) * w * w).scale(0.5) + w * self.carried(p, at.phase, at.v);
        if self.tilts {
            let (a, cp) = (p.diametral_inertia, p.polar_inertia);
            let (theta, rate) = (c(at.q[2], at.q[3]), c(at.v[2], at.v[3]));
            let skew = Complex::cis(at.phase + p.skew_phase).scale(p.skew);
            t += (a * rate.norm_sqr()).scale(0.5) + (cp * w * (rate.re * theta.im - theta.re * rate.im)).scale(0.5);
            t += (a - cp.scale(0.5)) * w * (rate.conj() * skew.mul_i()).re - cp.scale(0.5) * w * w * (theta.conj() * skew).re;
        }
        let [axial, twist] = self.axis();
        if let Some(i) = axial {
            t += (p.mass * at.v[i].square()).scale(0.5);
        }
        if let Some(i) = twist {
            t += p.polar_inertia * at.v[i] * (w + at.v[i].scale(0.5));
        }
        Some(Energy { stored: t, ..Energy::zero() })
    }

    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: Observed::DISPLACEMENT, unit: "m", value: at.q[0].hypot(at.q[1]) });
        if self.tilts {
            out.push(Observed { name: Observed::TILT, unit: "rad", value: at.q[2].hypot(at.q[3]) });
        }
        if p.mass > 0.0 {
            let centre = self.centre(p.centre_of_mass, at.q) + self.turning(p, at.phase).scale(1.0 / p.mass);
            out.push(Observed { name: "centre of mass", unit: "m", value: centre.re.hypot(centre.im) });
        }
    }

    fn validity(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if self.tilts {
            out.push(Validity { what: "tilt over 0.1 rad", ratio: at.q[2].hypot(at.q[3]) / SMALL });
        }
    }

    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let mut wrong = Vec::new();
        if self.tilts && p.polar_inertia > 2.0 * p.diametral_inertia {
            wrong.push((
                "polar_inertia",
                text!("no body has a polar inertia ({polar_inertia}) above twice its diametral inertia ({diametral_inertia}); a thin disc has just twice", polar_inertia = text::quantity(p.polar_inertia, "kg m^2"), diametral_inertia = text::quantity(p.diametral_inertia, "kg m^2")),
            ));
        }
        if !self.tilts && (p.skew != 0.0 || p.centre_of_mass != 0.0) {
            let field = if p.skew != 0.0 { "skew" } else { "centre_of_mass" };
            wrong.push((field, text!("{field} acts on the tilt, and this disc does not tilt: give diametral_inertia as well", field)));
        }
        if let Some(message) = too_light(p.mass) {
            wrong.push(("mass", message));
        }
        if !self.tilts && p.rows.iter().any(|u| u.at != 0.0) {
            wrong.push(("unbalances", text!("the height of an unbalance acts on the tilt, and this disc does not tilt")));
        }
        wrong
    }
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        Some(self)
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for Disc {
    #[inline(always)]
    fn rows(&self) -> RowCounts {
        [self.unbalances, 0]
    }
    fn is_steady(&self) -> bool {
        true
    }
}

impl BodyPart for Disc {
    fn shape(&self, _: &Params<Self, f64>, z: f64) -> Vec<[f64; 6]> {
        let mut columns = vec![[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]];
        if self.tilts {
            // x + z beta, y - z alpha
            columns.extend([[0.0, -z, 1.0, 0.0, 0.0, 0.0], [z, 0.0, 0.0, 1.0, 0.0, 0.0]]);
        }
        let [axial, twist] = self.axis();
        columns.extend(axial.map(|_| [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]));
        columns.extend(twist.map(|_| [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]));
        columns
    }
    fn lacks_spin_inertia(&self, p: &Params<Self, f64>) -> Option<&'static str> {
        (p.polar_inertia == 0.0).then_some("polar_inertia")
    }
    fn without_tilt(&self) -> Option<&'static str> {
        (!self.tilts).then_some("diametral_inertia")
    }
    fn parameters(&self) -> BodyParameters {
        BodyParameters { mass: Some("mass"), unbalance: Some("unbalance"), stiffness: None }
    }
}

impl Disc {
    #[inline(always)]
    fn spin_inertia<S: Scalar>(&self, p: &Params<Self, S>) -> S {
        let skew = if self.tilts { (p.diametral_inertia - p.polar_inertia) * p.skew * p.skew } else { S::zero() };
        if p.rows.is_empty() {
            let u = p.mass * p.eccentricity + p.unbalance;
            return p.polar_inertia + own(u * u, p.mass) + skew;
        }
        let mut moment = Complex::zero();
        for u in &p.rows {
            moment += Complex::cis(u.phase).scale((u.at - p.centre_of_mass) * u.unbalance);
        }
        let pair = if self.tilts { moment.norm_sqr() / p.diametral_inertia } else { S::zero() };
        p.polar_inertia + own(self.turning(p, S::zero()).norm_sqr(), p.mass) + pair + skew
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::params::Listed;

    /// Size, direction and height of each.
    pub(super) fn with(own: DiscParams, unbalances: &[[f64; 3]]) -> Params<Disc, f64> {
        Listed { own, rows: unbalances.iter().map(|&[unbalance, phase, at]| UnbalanceParams { unbalance, phase, at }).collect() }
    }

    #[test]
    fn mistakes_are_reported() {
        let p = DiscParams { diametral_inertia: 0.01, polar_inertia: 0.03, ..DiscParams::new(1.0) };
        let wrong = Disc::tilting().check(&p.into());
        assert_eq!(wrong[0].0, "polar_inertia");
        assert!(wrong[0].1.contains("above twice its diametral inertia"));
        // a thin disc is at the limit
        assert!(Disc::tilting().check(&DiscParams { polar_inertia: 0.02, ..p }.into()).is_empty());
        let skewed = DiscParams { skew: 0.01, ..DiscParams::new(1.0) };
        assert!(Disc::planar().check(&skewed.into())[0].1.contains("give diametral_inertia"));
        assert_eq!(Disc::planar().check(&DiscParams { skew: 0.0, centre_of_mass: 0.1, ..skewed }.into())[0].0, "centre_of_mass");
    }

    /// One part whose unbalances stand for eccentricity, unbalance at a height, and a pair in two planes: the same forces.
    #[test]
    fn several_unbalances_are_the_sum_of_each() {
        let p = DiscParams { polar_inertia: 0.02, diametral_inertia: 0.03, centre_of_mass: 0.05, ..DiscParams::new(2.0) };
        let forces = |own: DiscParams, unbalances: &[[f64; 3]]| {
            let p = with(own, unbalances);
            let mut b = Blocks::default();
            b.reset(4, 0, 50.0);
            Disc::tilting().unbalanced(p.rows.len()).linear(&p, 50.0, &mut b);
            [b.force_cos, b.force_sin, b.spin_accel_cos, b.spin_accel_sin].concat()
        };
        let near = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= 1e-13 * (1.0 + b.abs()));
        // at the height of the centre of mass an unbalance is that of the disc itself
        let own = forces(DiscParams { unbalance: 3e-4, eccentricity_phase: 0.4, ..p }, &[]);
        assert!(near(own, forces(p, &[[1e-4, 0.4, 0.05], [2e-4, 0.4, 0.05]])));
        // equal and opposite in two planes: no force, a moment u W^2 l about the axis a quarter turn from them
        let (u, l) = (2e-4, 0.3);
        let pair = forces(p, &[[u, 0.0, 0.2], [u, std::f64::consts::PI, 0.2 - l]]);
        let mut want = [0.0; 16];
        // along x at the height z bends about y; sin: along y about -x
        (want[3], want[4 + 2]) = (u * 2500.0 * l, -u * 2500.0 * l);
        assert!(near(pair[..8].to_vec(), want[..8].to_vec()), "{pair:?}");
    }

    #[test]
    fn unbalances_have_a_size_and_a_place() {
        use crate::model::field::{ParamValues, Value, Values};
        let build = |columns: &[(&'static str, Vec<f64>)], inertia: Option<f64>| {
            let (mut values, mut d) = (Values::default(), Diagnostics::default());
            values.set("unbalances", Value::Columns(columns.iter().cloned().collect()), None);
            if let Some(x) = inertia {
                values.set("diametral_inertia", Value::Number(x), None);
            }
            let disc = Disc::build(&values, &mut ParamValues::default(), &mut d);
            (disc.map(|d| d.unbalances), d.0.iter().map(|d| d.to_string()).collect::<String>())
        };
        let two = [("unbalance", vec![1e-5, 2e-5]), ("phase", vec![0.1, 0.2])];
        assert_eq!(build(&two, None), (Some(2), String::new()));
        let high = [two[0].clone(), ("at", vec![0.0, 0.1])];
        assert_eq!(build(&high, Some(0.1)).0, Some(2));
        assert!(build(&high, None).1.contains("does not tilt"));
        assert!(build(&[("unbalance", vec![-1e-5])], None).1.contains("-10 g mm"));
        assert!(build(&[("unbalance", vec![f64::NAN])], None).0.is_none());
    }

    /// Unbalance in two languages: m e and an unbalance are the same force.
    #[test]
    fn eccentricity_and_unbalance_are_one() {
        let base = DiscParams { eccentricity_phase: 0.3, ..DiscParams::new(2.0) };
        let blocks = |p: &DiscParams| {
            let mut b = Blocks::default();
            b.reset(2, 0, 50.0);
            Disc::planar().linear(&(*p).into(), 50.0, &mut b);
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
            DiscParams { eccentricity: 1e-3, eccentricity_phase: 0.7, unbalance: 3e-4, polar_inertia: 0.02, ..DiscParams::new(2.4) },
            Options::default();
        tilting: Disc::tilting(),
            DiscParams {
                mass: 2.4, eccentricity: 1e-3, eccentricity_phase: 0.7, unbalance: 3e-4, polar_inertia: 0.02, diametral_inertia: 0.013,
                skew: 0.02, skew_phase: -0.4, centre_of_mass: 0.06,
            },
            Options::default();
        axial_and_torsional: Disc::tilting().coordinates(true, true),
            DiscParams { polar_inertia: 0.02, diametral_inertia: 0.013, unbalance: 3e-4, ..DiscParams::new(2.4) },
            Options::default();
        massless: Disc::planar(), DiscParams { unbalance: 3e-4, polar_inertia: 0.02, ..DiscParams::new(0.0) }, Options::default();
        carried: Disc::planar().on(Attach::on("shaft")), DiscParams { polar_inertia: 0.02, ..DiscParams::new(2.4) }, Options::default();
        planar_unbalances: Disc::planar().unbalanced(2),
            tests::with(
                DiscParams { eccentricity: 1e-3, eccentricity_phase: 0.7, unbalance: 3e-4, polar_inertia: 0.02, ..DiscParams::new(2.4) },
                &[[2e-4, 0.3, 0.0], [1e-4, 2.0, 0.0]],
            ),
            Options::default();
        tilting_unbalances: Disc::tilting().unbalanced(2),
            tests::with(
                DiscParams {
                    mass: 2.4, eccentricity: 1e-3, eccentricity_phase: 0.7, unbalance: 3e-4, polar_inertia: 0.02, diametral_inertia: 0.013,
                    skew: 0.0, skew_phase: 0.0, centre_of_mass: 0.06,
                },
                &[[2e-4, 0.3, 0.1], [1e-4, 2.0, -0.07]],
            ),
            Options::default();
    }
}
