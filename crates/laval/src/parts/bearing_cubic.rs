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
//! Sources: `000_a291f7ede1484e56` equations (4)-(8); the law (z1 - z2)^3 of its equation (11) is neither of the two.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, Layout, Link, Observed, Params, Part, Physics, Rows, Uses, Validity};
use crate::params;
use laval_num::scalar::Scalar;

params! {
    /// Parameters of a [`BearingCubic`].
    pub struct BearingCubicParams in BearingCubicFamily {
        stiffness: lateral, "N/m", Bounds::up_to(1e15), required, "linear coefficient c0 of the total force";
        cubic_stiffness: lateral, "N/m^3", Bounds::within(1e24), required, "cubic coefficient c1 of the total force";
        valid_to: scalar, "m", Bounds::up_to(1.0), default 0.0, "largest deflection the coefficients were fitted for; 0 states none";
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
    fn force<S: Scalar>(&self, p: &BearingCubicParams<S>, d: &[S]) -> [S; 2] {
        let r2 = d[0] * d[0] + d[1] * d[1];
        let f = |i: usize| {
            let square = if self.isotropic { r2 } else { d[i] * d[i] };
            (p.stiffness[i] + p.cubic_stiffness[i] * square) * d[i]
        };
        [f(0), f(1)]
    }
}

impl Part for BearingCubic {
    const KIND: &'static str = "bearing_cubic";
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
                        Diagnostic::error("bearing_cubic.isotropic", format!("an isotropic law has the same {field} in x and y"))
                            .at(values.span_of(field))
                            .help("give one value, or use law = \"per_axis\""),
                    );
                }
            }
        }
        Some(BearingCubic { link: Link::Between(a, b), isotropic })
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
}

#[cfg(test)]
fn joint() -> Link {
    use crate::model::field::Attach;
    Link::Between(Attach::on("drum"), Attach::on("base"))
}

crate::conformance! {
    BearingCubic {
        per_axis: BearingCubic::per_axis(joint()),
            BearingCubicParams { stiffness: [1.1e7, 0.9e7], cubic_stiffness: [8.7e10, 5e10], valid_to: 1e-2 },
            Options { length: 0.01, ..Options::anisotropic() };
        per_axis_equal: BearingCubic::per_axis(joint()),
            BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 0.0 },
            Options { length: 0.01, ..Options::anisotropic() };
        isotropic: BearingCubic::isotropic(joint()),
            BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 1e-2 },
            Options { length: 0.01, ..Options::default() };
    }
}
