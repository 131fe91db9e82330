//! A ball or roller bearing from its geometry and load: stiffness of the rolling contacts, linear about the deflection under the load.
//!
//! Equations, stiffness along the load and across it, force on the deflection d of one point against another:
//!
//! ```text
//! balls:    k = 13e6 n^(2/3) D^(1/3) F^(1/3) cos(a)^(5/3)       k_across/k = 0.46, 0.64, 0.73 for n = 8, 12, 16
//! rollers:  k = 1.0e9 n^0.9 l^0.8 F^0.1 cos(a)^1.9              k_across/k = 0.49, 0.66, 0.74
//! f = -k d - t k d'
//! ```
//!
//! Between those numbers of rolling elements the ratio is interpolated by straight lines; beyond them it must be given.
//!
//! Symbols: n number of rolling elements; D diameter of a ball, l length of a roller, m; F static load, N; a contact angle; t damping over stiffness, s. The factors have the units N^(2/3) m^(-4/3) and
//! N^0.9 m^(-1.8).
//!
//! Validity: steel; motion small against the deflection under the load, which is 1.5 F/k of balls and F/(0.9 k) of rollers; no clearance, no preload beside the load; speed so low that the centrifugal load
//! of the rolling elements is small.
//!
//! Theory: `docs/theory/rolling-bearings.md#stiffness-from-the-geometry`.
//!
//! Sources: E. Krämer, Dynamics of Rotors and Foundations, Springer 1993; M. I. Friswell et al., Dynamics of Rotating Machines, Cambridge 2010, section 5.4.1; the damping of 0.25e-5 s to 2.5e-5 s there.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Validity};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`BearingRolling`].
    pub struct BearingRollingParams in BearingRollingFamily {
        size: scalar, "m", Bounds::closed(1e-4, 1.0), required, "diameter D of a ball, or length l of a roller";
        load: scalar, "N", Bounds::positive(1e9), required, "static load F on the bearing";
        contact_angle: scalar, "rad", Bounds::closed(0.0, 1.4), default 0.0, "contact angle a";
        ratio: scalar, "", Bounds::up_to(10.0), default 0.0, "stiffness across the load over that along it; 0 takes the value for the number of rolling elements, from 8 to 16";
        damping_time: scalar, "s", Bounds::up_to(1.0), default 1.25e-5, "damping over stiffness t; measured values are 0.25e-5 s to 2.5e-5 s";
    }
}

/// What rolls: factor, exponents of number, size, load and cosine, and of the force law `F ~ d^e`; ratios at 8, 12, 16 elements.
struct Law {
    factor: f64,
    exponents: [f64; 4],
    force: f64,
    ratios: [f64; 3],
}

const BALLS: Law = Law { factor: 13e6, exponents: [2.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 5.0 / 3.0], force: 1.5, ratios: [0.46, 0.64, 0.73] };
const ROLLERS: Law = Law { factor: 1e9, exponents: [0.9, 0.8, 0.1, 1.9], force: 1.0 / 0.9, ratios: [0.49, 0.66, 0.74] };

/// Coefficient of the Hertz law `F = Cb d^(3/2)` of a ball bearing, N/m^1.5, whose tangent under any load is the stiffness of balls above: `(2/3 13e6)^(3/2) n D^(1/2) cos(a)^(5/2)`.
pub fn hertz_coefficient(count: f64, diameter: f64, contact_angle: f64) -> f64 {
    (BALLS.factor / BALLS.force).powf(1.5) * count * diameter.sqrt() * contact_angle.cos().powf(2.5)
}

/// Numbers of rolling elements with a known ratio.
const COUNTS: [f64; 3] = [8.0, 12.0, 16.0];
/// Fewest and most rolling elements.
const FEWEST: i64 = 3;
const MOST: i64 = 200;

/// See the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct BearingRolling {
    link: Link,
    rollers: bool,
    count: usize,
    /// The load is along x; otherwise along y.
    along_x: bool,
}

impl BearingRolling {
    /// So many balls, loaded along y.
    pub fn balls(link: Link, count: usize) -> Self {
        BearingRolling { link, rollers: false, count, along_x: false }
    }
    /// So many rollers, loaded along y.
    pub fn rollers(link: Link, count: usize) -> Self {
        BearingRolling { link, rollers: true, count, along_x: false }
    }
    /// Loaded along x.
    #[must_use]
    pub fn loaded_along_x(self) -> Self {
        BearingRolling { along_x: true, ..self }
    }
    fn law(&self) -> &'static Law {
        if self.rollers { &ROLLERS } else { &BALLS }
    }
    /// Stiffness across the load over that along it, by the number of rolling elements; `None` beyond the known ones.
    fn known_ratio(&self) -> Option<f64> {
        let n = self.count as f64;
        let k = COUNTS.windows(2).position(|w| (w[0]..=w[1]).contains(&n))?;
        let share = (n - COUNTS[k]) / (COUNTS[k + 1] - COUNTS[k]);
        let ratios = self.law().ratios;
        Some(ratios[k] + share * (ratios[k + 1] - ratios[k]))
    }
    /// Stiffness along the load, N/m.
    #[inline(always)]
    fn along<S: Scalar>(&self, p: &BearingRollingParams<S>) -> S {
        let Law { factor, exponents: [n, size, load, cosine], .. } = self.law();
        let fixed = factor * (self.count as f64).powf(*n);
        (p.size.pow_pos(*size) * p.load.pow_pos(*load) * p.contact_angle.cos().pow_pos(*cosine)).scale(fixed)
    }
    /// Stiffness in x and y, N/m.
    #[inline(always)]
    fn stiffness<S: Scalar>(&self, p: &BearingRollingParams<S>) -> [S; 2] {
        let along = self.along(p);
        let known = S::cst(self.known_ratio().unwrap_or(f64::NAN));
        let ratio = if p.ratio.value() == 0.0 { known } else { p.ratio };
        let across = along * ratio;
        if self.along_x { [along, across] } else { [across, along] }
    }
}

impl Part for BearingRolling {
    const KIND: &'static str = "bearing_rolling";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
elements = "balls"
count = 12
size = "10 mm"
load = "250 N"
"#;
    const DOC: &'static str = "A ball or roller bearing from its geometry and load: stiffness along the load and across it, linear about the deflection under the load. \
        bearing_hertz keeps the force law of balls for large motion.";
    type Family = BearingRollingFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins"),
        Field::required("elements", FieldKind::Choice(&[("balls", "steel balls"), ("rollers", "steel rollers")]), "rolling elements"),
        Field::required("count", FieldKind::Integer { min: FEWEST, max: MOST }, "number of rolling elements"),
        Field::optional("load_direction", FieldKind::Choice(&[("x", "along x"), ("y", "along y")]), "y", "direction of the static load"),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let count = values.integer("count")?.clamp(FEWEST, MOST) as usize;
        let rollers = values.choice("elements")? == "rollers";
        let link = Link::Between(a, b);
        let bearing = BearingRolling { link, rollers, count, along_x: values.choice("load_direction") == Some("x") };
        if bearing.known_ratio().is_none() && params.get("ratio").is_none_or(|r| r == 0.0) {
            diagnostics.push(
                Diagnostic::error(
                    "bearing_rolling.ratio",
                    text!("the ratio of the stiffnesses is known from 8 to 16 rolling elements, not of {count}", count),
                )
                .at(values.span_of("count"))
                .help(text!(
                    "give ratio: the stiffness across the load over that along it; it comes near 1 for many rolling elements under preload"
                )),
            );
            return None;
        }
        Some(bearing)
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::point(self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let k = self.stiffness(p);
        for i in 0..2 {
            b.stiffness[(i, i)] = k[i];
            b.damping[(i, i)] = p.damping_time * k[i];
        }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let (mut stored, mut dissipated) = (S::zero(), S::zero());
        for (i, k) in self.stiffness(p).into_iter().enumerate() {
            stored += (k * at.q[i].square()).scale(0.5);
            dissipated += p.damping_time * k * at.v[i].square();
        }
        Some(Energy { stored, dissipated, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let k = self.stiffness(p);
        let force = |i: usize| k[i] * (at.q[i] + p.damping_time * at.v[i]);
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: force(0).hypot(force(1)) });
    }
    fn validity(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        let held = self.law().force * p.load / self.along(p);
        out.push(Validity { what: "deflection over that under the load of the rolling bearing", ratio: at.q[0].hypot(at.q[1]) / held });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        if p.ratio == 0.0 && self.known_ratio().is_none() {
            return vec![("ratio", text!("the ratio of the stiffnesses is known from 8 to 16 rolling elements"))];
        }
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::{Attach, Value};

    pub(super) fn link() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a / b - 1.0).abs() <= tolerance, "{a:e} {b:e}");
    }

    /// Another program, ROSS: eight balls of 30 mm under 500 N at 30 degrees, eight rollers of 30 mm under 500 N at 30 degrees.
    #[test]
    fn stiffness_is_that_of_another_program() {
        let p = BearingRollingParams { contact_angle: std::f64::consts::FRAC_PI_6, ..BearingRollingParams::new(0.03, 500.0) };
        let k = BearingRolling::balls(link(), 8).stiffness(&p);
        near(k[0], 4.641_688_38e7, 1e-8);
        near(k[1], 1.009_062_69e8, 1e-8);
        let k = BearingRolling::rollers(link(), 8).stiffness(&p);
        near(k[0], 2.728_219_27e8, 1e-8);
        near(k[1], 5.567_794_44e8, 1e-8);
        let k = BearingRolling::rollers(link(), 8).loaded_along_x().stiffness(&p);
        near(k[0], 5.567_794_44e8, 1e-8);
    }

    /// Palmgren's deflection of a ball between both races, `d = 4.4e-8 Q^(2/3) D^(-1/3)` in m and N, with the sum over the loaded half of the balls, `F = 0.2288 n Q` (T. A. Harris, Rolling Bearing
    /// Analysis): the same stiffness within the digits of both.
    #[test]
    fn the_factor_of_balls_agrees_with_another_law() {
        let (n, d, load) = (12.0f64, 0.012f64, 800.0);
        let coefficient = 0.2288 * n * (d.powf(1.0 / 3.0) / 4.4e-8).powf(1.5);
        let tangent = 1.5 * coefficient.powf(2.0 / 3.0) * f64::powf(load, 1.0 / 3.0);
        let k = BearingRolling::balls(link(), 12).along(&BearingRollingParams::new(d, load));
        near(k, tangent, 0.03);
        // and the coefficient of bearing_hertz has that tangent exactly
        for (angle, load) in [(0.0, 50.0), (0.4, 3e3)] {
            let p = BearingRollingParams { contact_angle: angle, ..BearingRollingParams::new(d, load) };
            let cb = hertz_coefficient(n, d, angle);
            near(BearingRolling::balls(link(), 12).along(&p), 1.5 * cb.powf(2.0 / 3.0) * load.powf(1.0 / 3.0), 1e-13);
        }
    }

    #[test]
    fn the_ratio_is_interpolated_and_never_extrapolated() {
        let ratio = |n: usize| BearingRolling::balls(link(), n).known_ratio();
        assert_eq!([ratio(8), ratio(12), ratio(16)], [Some(0.46), Some(0.64), Some(0.73)]);
        assert!((ratio(10).unwrap() - 0.55).abs() < 1e-14);
        assert_eq!([ratio(7), ratio(17)], [None, None]);
        let build = |count: i64, given: f64| {
            let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
            values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
            values.set("elements", Value::Choice("balls"), None);
            values.set("count", Value::Integer(count), Some(3..5));
            params.set("ratio", given);
            (BearingRolling::build(&values, &mut params, &mut d), d)
        };
        let (part, d) = build(20, 0.0);
        assert!(part.is_none() && d.0[0].span == Some(3..5) && d.0[0].code == "bearing_rolling.ratio");
        assert!(build(20, 0.9).0.is_some() && build(9, 0.0).0.is_some());
        assert_eq!(BearingRolling::balls(link(), 20).check(&BearingRollingParams::new(0.01, 100.0)).len(), 1);
    }

    #[test]
    fn motion_is_held_against_the_deflection_under_the_load() {
        let bearing = BearingRolling::balls(link(), 12);
        let p = BearingRollingParams::new(0.01, 300.0);
        let cb = hertz_coefficient(12.0, 0.01, 0.0);
        let held = (300.0 / cb).powf(2.0 / 3.0);
        for (q, inside) in [(0.99 * held, true), (1.01 * held, false)] {
            let at = At { q: &[0.0, q], v: &[0.0; 2], a: &[0.0; 2], z: &[], phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 };
            let mut v = Vec::new();
            bearing.validity(&p, &at, &mut v);
            assert_eq!(v[0].ratio <= 1.0, inside);
        }
    }
}

crate::conformance! {
    BearingRolling {
        balls: BearingRolling::balls(tests::link(), 10), BearingRollingParams { contact_angle: 0.3, ..BearingRollingParams::new(0.01, 300.0) }, Options::anisotropic();
        rollers: BearingRolling::rollers(tests::link(), 20).loaded_along_x(),
            BearingRollingParams { ratio: 0.8, contact_angle: 0.2, ..BearingRollingParams::new(0.012, 900.0) }, Options::anisotropic();
    }
}
