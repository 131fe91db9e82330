//! A viscous damper between two points, or between a point and the ground, in fixed or rotating axes.
//!
//! Equations: force on the relative motion `d = z_a - z_b`: `c d'` (fixed axes), `c (d' - i W d)` (rotating axes: the damping of a material
//! that turns with the rotor, which feeds whirl slower than the spin). With tilt damping the same law, with ct, acts on the tilt.
//!
//! Symbols: c damping, N s/m; ct tilt damping, N m s; W spin speed, rad/s.
//!
//! Validity: linear.
//!
//! Theory: `docs/theory/machine.md#dampers`.
//!
//! Sources: `000_a291f7ede1484e56` equation (8) (fixed axes); A. L. Kimball, Gen. Electr. Rev. 27 (1924) (rotating axes).

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::Extent;
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Damper`].
    pub struct DamperParams in DamperFamily {
        damping: lateral, "N s/m", Bounds::up_to(1e12), required, "damping c";
        tilt_damping: scalar, "N m s", Bounds::up_to(1e12), default 0.0, "tilt damping ct; when given, the damper acts on tilt";
    }
}

/// See the [module](self).
pub struct Damper {
    link: Link,
    rotating: bool,
    tilts: bool,
}

impl Damper {
    /// In fixed axes.
    pub fn fixed(link: Link) -> Self {
        Damper { link, rotating: false, tilts: false }
    }
    /// In axes that turn with the rotor.
    pub fn rotating(link: Link) -> Self {
        Damper { link, rotating: true, tilts: false }
    }
    /// The same on tilt as well.
    pub fn with_tilt(self) -> Self {
        Damper { tilts: true, ..self }
    }
    /// Relative rate of the pair of coordinates at `i`, seen in the damper's axes.
    #[inline(always)]
    fn slip<S: Scalar>(&self, at: &At<S>, i: usize) -> Complex<S> {
        let v = c(at.v[i], at.v[i + 1]);
        if self.rotating { v - c(at.q[i], at.q[i + 1]).mul_i().scale(at.speed) } else { v }
    }
    /// Share of the pair of coordinates at `i` in the spin row, over its damping.
    #[inline(always)]
    fn torque<S: Scalar>(&self, at: &At<S>, i: usize) -> S {
        (c(at.q[i], at.q[i + 1]).conj() * self.slip(at, i)).im
    }
}

impl Part for Damper {
    const KIND: &'static str = "damper";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
damping = "250 N s/m"
axes = "fixed"                      # "rotating" is damping inside the rotor
"#;
    const DOC: &'static str = "A viscous damper between two points or to the ground. axes = \"rotating\" is damping inside the rotor, which \
        destabilises above the critical speed. tilt_damping adds the same on tilt.";
    type Family = DamperFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins"),
        Field::optional(
            "axes",
            FieldKind::Choice(&[("fixed", "axes at rest"), ("rotating", "axes that turn with the rotor")]),
            "fixed",
            "axes the damping acts in",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let rotating = values.choice("axes") == Some("rotating");
        if rotating && params.get("damping.x") != params.get("damping.y") {
            diagnostics.push(
                Diagnostic::error("damper.rotating", text!("rotating damping must be the same in x and y"))
                    .at(values.span_of("damping"))
                    .help(text!("different values in rotating axes would make the machine's equations periodic in time")),
            );
        }
        let tilts = params.get("tilt_damping").is_some_and(|x| x != 0.0);
        Some(Damper { link: Link::Between(a, b), rotating, tilts })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        if self.tilts { Layout::point_and_tilt(self.link.clone()) } else { Layout::point(self.link.clone()) }
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        for i in 0..2 {
            b.damping[(i, i)] = p.damping[i];
        }
        if self.rotating {
            b.circulatory[(0, 1)] = p.damping[0];
            b.circulatory[(1, 0)] = -p.damping[0];
        }
        if self.tilts {
            for i in 2..4 {
                b.damping[(i, i)] = p.tilt_damping;
            }
            if self.rotating {
                b.circulatory[(2, 3)] = p.tilt_damping;
                b.circulatory[(3, 2)] = -p.tilt_damping;
            }
        }
    }
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        if !self.rotating {
            return S::zero();
        }
        let lateral = -(p.damping[0] * self.torque(at, 0));
        if self.tilts { lateral - p.tilt_damping * self.torque(at, 2) } else { lateral }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let slip = self.slip(at, 0);
        let mut dissipated = p.damping[0] * slip.re.square() + p.damping[1] * slip.im.square();
        if self.tilts {
            dissipated += p.tilt_damping * self.slip(at, 2).norm_sqr();
        }
        Some(Energy { dissipated, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let slip = self.slip(at, 0);
        out.push(Observed { name: "force", unit: "N", value: (p.damping[0] * slip.re).hypot(p.damping[1] * slip.im) });
        if self.tilts {
            let slip = self.slip(at, 2);
            out.push(Observed { name: Observed::MOMENT, unit: "N m", value: p.tilt_damping * slip.re.hypot(slip.im) });
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        if self.rotating && p.damping[0] != p.damping[1] {
            return vec![("damping", text!("rotating damping must be the same in x and y"))];
        }
        if !self.tilts && p.tilt_damping != 0.0 {
            return vec![("tilt_damping", text!("this damper was built without tilt"))];
        }
        Vec::new()
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for Damper {
    fn is_steady(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::{Attach, Value};

    pub(super) fn to_ground() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }

    #[test]
    fn rotating_damping_is_the_same_in_all_directions() {
        let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
        values.set("axes", Value::Choice("rotating"), None);
        params.set("damping.x", 10.0);
        params.set("damping.y", 20.0);
        Damper::build(&values, &mut params, &mut d);
        assert!(d.0[0].to_string().contains("same in x and y"));
        // and through an override of one parameter
        assert_eq!(Damper::rotating(to_ground()).check(&DamperParams::new([10.0, 20.0])).len(), 1);
        assert!(Damper::fixed(to_ground()).check(&DamperParams::new([10.0, 20.0])).is_empty());
    }
}

crate::conformance! {
    Damper {
        fixed: Damper::fixed(tests::to_ground()), DamperParams::new([42.0; 2]), Options::default();
        fixed_anisotropic: Damper::fixed(tests::to_ground()), DamperParams::new([42.0, 10.0]), Options::anisotropic();
        tilting: Damper::fixed(tests::to_ground()).with_tilt(), DamperParams { damping: [42.0, 10.0], tilt_damping: 0.3 }, Options::anisotropic();
        rotating_tilting: Damper::rotating(tests::to_ground()).with_tilt(), DamperParams { damping: [42.0; 2], tilt_damping: 0.3 }, Options::default();
        rotating: Damper::rotating(tests::to_ground()), DamperParams::new([42.0; 2]), Options::default();
    }
}
