//! A bearing with a linear and a cubic restoring force on the deflection `d = z_a - z_b`.
//!
//! Equations:
//!
//! ```text
//! per axis:   f_x = c0 dx + c1 dx^3,   f_y = c0 dy + c1 dy^3     (stiffer along the axes than at 45 degrees)
//! isotropic:  f = c0 d + c1 |d|^2 d
//! ```
//!
//! Symbols: c0 N/m and c1 N/m^3, of the total force of all bearings at this point together.
//!
//! Validity: deflections inside the range over which c0 and c1 were fitted (`valid_to`).
//!
//! Theory: `docs/theory/rolling-bearings.md#cubic-law`.
//!
//! Sources: `000_a291f7ede1484e56` equations (4)-(8); the law (z1 - z2)^3 of its equation (11) is neither of the two.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Rows, Uses, Validity};
use crate::params;
use crate::text;
use crate::text::{Argument, Text};
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`BearingCubic`].
    pub struct BearingCubicParams in BearingCubicFamily {
        stiffness: lateral, "N/m", Bounds::up_to(1e15), required, "linear coefficient c0 of the total force";
        cubic_stiffness: lateral, "N/m^3", Bounds::within(1e24), required, "cubic coefficient c1 of the total force";
        valid_to: scalar, "m", Bounds::up_to(1.0), default 0.0, "largest deflection the coefficients were fitted for; 0 states none";
    }
}

/// Deflection that rotors on bearings reach, m: unless `valid_to` says more, a law holds at least so far.
const USUAL_DEFLECTION: f64 = 1e-3;

/// A softening law pushes away beyond `d = sqrt(-c0/c1)`. It is legitimate where motions stay inside.
fn warn_of_reversal(values: &Values, params: &ParamValues, diagnostics: &mut Diagnostics) {
    let valid_to = params.get("valid_to").unwrap_or(0.0);
    let reach = if valid_to > 0.0 { valid_to } else { USUAL_DEFLECTION };
    let reversals = ["x", "y"].map(|axis| {
        let (c0, c1) = (params.get(&format!("stiffness.{axis}"))?, params.get(&format!("cubic_stiffness.{axis}"))?);
        (c1 < 0.0).then(|| (-c0 / c1).sqrt())
    });
    if let Some(d) = reversals.into_iter().flatten().reduce(f64::min)
        && d < reach
    {
        let message = text!("the force no longer restores beyond a deflection of {d}: it pushes away", d = text::quantity(d, "m"));
        let place = match valid_to > 0.0 {
            true => text!("valid_to, the deflection the law holds for").argument(),
            false => text::quantity(reach, "m"),
        };
        diagnostics.push(
            Diagnostic::warning("bearing_cubic.reversal", message)
                .at(values.span_of("cubic_stiffness"))
                .label(text!("softens"))
                .help(text!("this is below {place}; check sign and unit (N/m^3), or state the range of the law with valid_to", place)),
        );
    }
}

/// See the [module](self).
pub struct BearingCubic {
    link: Link,
    isotropic: bool,
}

impl BearingCubic {
    /// Each axis by itself.
    pub fn per_axis(link: Link) -> Self {
        BearingCubic { link, isotropic: false }
    }
    /// The same in all directions.
    pub fn isotropic(link: Link) -> Self {
        BearingCubic { link, isotropic: true }
    }
    #[inline(always)]
    fn force<S: Scalar>(&self, p: &BearingCubicParams<S>, d: &[S]) -> [S; 2] {
        let r2 = d[0] * d[0] + d[1] * d[1];
        let (x2, y2) = if self.isotropic { (r2, r2) } else { (d[0] * d[0], d[1] * d[1]) };
        [(p.stiffness[0] + p.cubic_stiffness[0] * x2) * d[0], (p.stiffness[1] + p.cubic_stiffness[1] * y2) * d[1]]
    }
}

impl Part for BearingCubic {
    const KIND: &'static str = "bearing_cubic";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
law = "isotropic"
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"
valid_to = "2 mm"
"#;
    const DOC: &'static str = "A bearing whose force grows with the deflection and its cube. law = \"per_axis\" treats x and y apart, \
        law = \"isotropic\" is the same in all directions; the two have different jumps, so the law is always named.";
    type Family = BearingCubicFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins"),
        Field::required(
            "law",
            FieldKind::Choice(&[("per_axis", "c0 dx + c1 dx^3 and c0 dy + c1 dy^3"), ("isotropic", "c0 d + c1 |d|^2 d")]),
            "how the cubic force depends on direction",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let isotropic = values.choice("law")? == "isotropic";
        if isotropic {
            for field in ["stiffness", "cubic_stiffness"] {
                if params.get(&format!("{field}.x")) != params.get(&format!("{field}.y")) {
                    diagnostics.push(
                        Diagnostic::error("bearing_cubic.isotropic", text!("an isotropic law has the same {field} in x and y", field))
                            .at(values.span_of(field))
                            .help(text!("give one value, or use law = \"per_axis\"")),
                    );
                }
            }
        }
        warn_of_reversal(values, params, diagnostics);
        Some(BearingCubic { link: Link::Between(a, b), isotropic })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::point(self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: false, acceleration: false, spin: false }
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let f = self.force(p, at.q);
        out.force[0] += f[0];
        out.force[1] += f[1];
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let (x2, y2) = (at.q[0].square(), at.q[1].square());
        let linear = (p.stiffness[0] * x2 + p.stiffness[1] * y2).scale(0.5);
        let quartic = if self.isotropic {
            p.cubic_stiffness[0] * (x2 + y2).square()
        } else {
            p.cubic_stiffness[0] * x2.square() + p.cubic_stiffness[1] * y2.square()
        };
        Some(Energy { stored: linear + quartic.scale(0.25), ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let f = self.force(p, at.q);
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: f[0].hypot(f[1]) });
    }
    fn validity(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if p.valid_to > 0.0 {
            out.push(Validity { what: "bearing deflection over the range of its law", ratio: at.q[0].hypot(at.q[1]) / p.valid_to });
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let unequal = |x: [f64; 2]| self.isotropic && x[0] != x[1];
        let fields = [("stiffness", p.stiffness), ("cubic_stiffness", p.cubic_stiffness)];
        let wrong = fields.into_iter().filter(|f| unequal(f.1));
        wrong.map(|(field, _)| (field, text!("an isotropic law has the same {field} in x and y", field))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::Attach;

    pub(super) fn joint() -> Link {
        Link::Between(Attach::on("drum"), Attach::on("base"))
    }

    /// c1 (dx^3 + i dy^3) = c1 (3/4 |d|^2 d + 1/4 conj(d)^3): on the axes as the isotropic law, at 45 degrees half its cubic force.
    #[test]
    fn the_two_laws_agree_on_the_axes_only() {
        let p = BearingCubicParams { stiffness: [0.0; 2], cubic_stiffness: [8e10; 2], valid_to: 0.0 };
        let (axis, diagonal) = ([2e-3, 0.0], [2e-3 * 0.5f64.sqrt(); 2]);
        let force = |law: &BearingCubic, d: &[f64]| law.force(&p, d).iter().map(|f| f * f).sum::<f64>().sqrt();
        let (per_axis, isotropic) = (BearingCubic::per_axis(joint()), BearingCubic::isotropic(joint()));
        let full = 8e10 * 8e-9;
        assert!((force(&isotropic, &axis) - full).abs() < 1e-12 * full && (force(&isotropic, &diagonal) - full).abs() < 1e-12 * full);
        assert!((force(&per_axis, &axis) - full).abs() < 1e-12 * full && (force(&per_axis, &diagonal) - 0.5 * full).abs() < 1e-12 * full);
    }

    /// c0 d + c1 d^3 = 0 at d = sqrt(-c0/c1): 0.1 mm for 1e6 N/m and -1e14 N/m^3, 10 mm for -1e10 N/m^3.
    #[test]
    fn a_force_that_turns_round_within_reach_is_reported() {
        let reported = |cubic: f64, valid_to: f64| {
            let mut p = ParamValues::default();
            for (name, x) in [
                ("stiffness.x", 1e6),
                ("stiffness.y", 1e6),
                ("cubic_stiffness.x", 8e10),
                ("cubic_stiffness.y", cubic),
                ("valid_to", valid_to),
            ] {
                p.set(name, x);
            }
            let mut d = Diagnostics::default();
            warn_of_reversal(&Values::default(), &p, &mut d);
            assert!(!d.has_errors());
            d.0.len()
        };
        assert_eq!([reported(-1e14, 0.0), reported(-1e10, 0.0), reported(8e10, 0.0), reported(0.0, 0.0)], [1, 0, 0, 0]);
        // the range of the law decides where it is stated
        assert_eq!([reported(-1e14, 0.09e-3), reported(-1e14, 0.11e-3), reported(-1e10, 9e-3), reported(-1e10, 11e-3)], [0, 1, 0, 1]);
    }

    #[test]
    fn an_isotropic_law_with_unequal_axes_is_refused() {
        let p = BearingCubicParams { stiffness: [1.0, 2.0], cubic_stiffness: [3.0, 3.0], valid_to: 0.0 };
        let wrong = BearingCubic::isotropic(joint()).check(&p);
        assert!(wrong.len() == 1 && wrong[0].0 == "stiffness" && wrong[0].1 == "an isotropic law has the same stiffness in x and y");
        assert!(BearingCubic::per_axis(joint()).check(&p).is_empty());
    }
}

crate::conformance! {
    BearingCubic {
        per_axis: BearingCubic::per_axis(tests::joint()),
            BearingCubicParams { stiffness: [1.1e7, 0.9e7], cubic_stiffness: [8.7e10, 5e10], valid_to: 1e-2 },
            Options { length: 0.01, ..Options::anisotropic() };
        per_axis_equal: BearingCubic::per_axis(tests::joint()),
            BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 0.0 },
            Options { length: 0.01, ..Options::anisotropic() };
        isotropic: BearingCubic::isotropic(tests::joint()),
            BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 1e-2 },
            Options { length: 0.01, ..Options::default() };
    }
}
