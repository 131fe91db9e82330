//! A rubber ring around a bearing: `F = k (1 + r^2/a^2) d + c d'` with the deflection d and r = |d|.

use laval::diagnostic::Diagnostics;
use laval::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use laval::model::part::{At, Energy, Layout, Link, Observed, Params, Part, Physics, Rows, Uses};
use laval_num::scalar::Scalar;

laval::params! {
    /// Parameters of a [`RubberRing`].
    pub struct RubberRingParams in RubberRingFamily {
        stiffness: scalar, "N/m", Bounds::positive(1e12), required, "stiffness k at small deflection";
        doubling: scalar, "m", Bounds::positive(1.0), required, "deflection a at which the stiffness is 2 k";
        damping: scalar, "N s/m", Bounds::up_to(1e9), default 0.0, "damping c";
    }
}

pub struct RubberRing(pub Link);

impl Part for RubberRing {
    const KIND: &'static str = "rubber_ring";
    const DOC: &'static str = "A rubber ring around a bearing, stiffer the more it is deflected.";
    type Family = RubberRingFamily;
    const FIELDS: &'static [Field] = &[Field::required("between", FieldKind::Between, "the two points it joins")];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        values.between("between").map(|(a, b)| RubberRing(Link::Between(a, b)))
    }
    fn layout(&self) -> Layout {
        Layout::point(self.0.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: true, acceleration: false, spin: false }
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let k = p.stiffness * (S::one() + (at.q[0].square() + at.q[1].square()) / p.doubling.square());
        for i in 0..2 {
            out.force[i] += k * at.q[i] + p.damping * at.v[i];
        }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let (d2, v2) = (at.q[0].square() + at.q[1].square(), at.v[0].square() + at.v[1].square());
        let stored = (p.stiffness * d2).scale(0.5) * (S::one() + (d2 / p.doubling.square()).scale(0.5));
        Some(Energy { stored, dissipated: p.damping * v2, ..Energy::zero() })
    }
    fn observe(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
    }
}

laval::conformance! { RubberRing {
    ring: RubberRing(Link::Between(Attach::on("drum"), Attach::ground())),
        RubberRingParams { stiffness: 1e6, doubling: 1e-3, damping: 50.0 }, Options::default();
} }
