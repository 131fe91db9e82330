//! A massless shaft of constant section on two elastic supports, seen from a point between them: deflection and tilt of that point.
//!
//! Equations, in each plane by itself, on the motion `u = (x, beta)`, `(y, -alpha)` of the first point relative to the second:
//!
//! ```text
//! f = C^-1 u,   C = 1/(3 E I l) [ a^2 b^2      a b (b - a)       ] + T [ 1/k1  .    ] T^T,   T = [ b/l    a/l ]
//!                               [ a b (b - a)  a^2 - a b + b^2   ]     [ .     1/k2 ]            [ -1/l   1/l ]
//! ```
//!
//! Symbols: a length of the shaft from the lower support to the point, b from there to the upper one, l = a + b, m; E I = E pi (d^4 - di^4)/64 bending stiffness,
//! N m^2; k1, k2 stiffness of the lower and upper support, N/m. Slopes are beta = dx/dz, alpha = -dy/dz.
//!
//! Validity: slender shaft (no shear deflection), mass of the shaft small against what it carries; the supports carry no moment. Unequal stiffness in x
//! and y belongs to the supports, which do not turn.
//!
//! Theory: `docs/theory/machine.md#massless-shafts`.
//!
//! Sources: any text on beams; the same as a model of two beam elements on springs.

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::f64::consts::PI;
use std::sync::Arc;

params! {
    /// Parameters of a [`ShaftSpan`].
    pub struct ShaftSpanParams in ShaftSpanFamily {
        below: scalar, "m", Bounds::closed(1e-4, 100.0), required, "length a of the shaft from the lower support to the point";
        above: scalar, "m", Bounds::closed(1e-4, 100.0), required, "length b of the shaft from the point to the upper support";
        diameter: scalar, "m", Bounds::closed(1e-5, 10.0), required, "diameter d of the shaft";
        inner_diameter: scalar, "m", Bounds::up_to(10.0), default 0.0, "inner diameter di of a hollow shaft";
        modulus: scalar, "Pa", Bounds::closed(1e5, 1e13), default 2.06e11, "Young's modulus E of the shaft";
        lower_support: lateral, "N/m", Bounds::closed(1.0, 1e15), required, "stiffness k1 of the lower support";
        upper_support: lateral, "N/m", Bounds::closed(1.0, 1e15), required, "stiffness k2 of the upper support";
    }
}

/// See the [module](self).
pub struct ShaftSpan {
    link: Link,
}

/// K11, K12, K22 of one plane.
type Plane<S> = [S; 3];

impl ShaftSpan {
    /// Between a point of the rotor and what its supports stand on.
    pub fn new(link: Link) -> Self {
        ShaftSpan { link }
    }
    /// Stiffness in the planes of x and of y.
    #[inline(always)]
    fn planes<S: Scalar>(p: &ShaftSpanParams<S>) -> [Plane<S>; 2] {
        let (a, b) = (p.below, p.above);
        let l = a + b;
        let fourth = |d: S| d.square().square();
        let bending = p.modulus * (fourth(p.diameter) - fourth(p.inner_diameter)).scale(PI / 64.0);
        let unit = S::one() / (bending * l).scale(3.0);
        let mut planes = [[S::zero(); 3]; 2];
        for (i, plane) in planes.iter_mut().enumerate() {
            let (lower, upper) = (S::one() / (p.lower_support[i] * l * l), S::one() / (p.upper_support[i] * l * l));
            let c11 = unit * a * a * b * b + b * b * lower + a * a * upper;
            let c12 = unit * a * b * (b - a) - b * lower + a * upper;
            let c22 = unit * (a * a - a * b + b * b) + lower + upper;
            let det = S::one() / (c11 * c22 - c12 * c12);
            *plane = [c22 * det, -(c12 * det), c11 * det];
        }
        planes
    }
    /// `K q` over x, y, alpha, beta.
    #[inline(always)]
    fn force<S: Scalar>(p: &ShaftSpanParams<S>, q: &[S]) -> [S; 4] {
        let [x, y] = Self::planes(p);
        [x[0] * q[0] + x[1] * q[3], y[0] * q[1] - y[1] * q[2], y[2] * q[2] - y[1] * q[1], x[1] * q[0] + x[2] * q[3]]
    }
}

impl Part for ShaftSpan {
    const KIND: &'static str = "shaft_span";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
below = "250 mm"
above = "350 mm"
diameter = "35 mm"
lower_support = "2e7 N/m"
upper_support = { x = "2e7 N/m", y = "1.2e7 N/m" }
modulus = "206 GPa"
"#;
    const DOC: &'static str = "A massless shaft of constant section on two elastic supports, from its geometry: stiffness of deflection and tilt at the \
        point of the rotor it carries, in the planes of x and y. For its internal friction put a damper with rotating axes beside it.";
    type Family = ShaftSpanFamily;
    const FIELDS: &'static [Field] = &[Field::required(
        "between",
        FieldKind::Between,
        "the point of the rotor at which the lengths meet, and what the supports stand on",
    )];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        Some(ShaftSpan { link: Link::Between(a, b) })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::point_and_tilt(self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let [x, y] = Self::planes(p);
        for (i, j, k) in [(0, 0, x[0]), (0, 3, x[1]), (3, 0, x[1]), (3, 3, x[2])] {
            b.stiffness[(i, j)] = k;
        }
        for (i, j, k) in [(1, 1, y[0]), (1, 2, -y[1]), (2, 1, -y[1]), (2, 2, y[2])] {
            b.stiffness[(i, j)] = k;
        }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let f = Self::force(p, at.q);
        let stored = (f[0] * at.q[0] + f[1] * at.q[1] + f[2] * at.q[2] + f[3] * at.q[3]).scale(0.5);
        Some(Energy { stored, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let f = Self::force(p, at.q);
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: f[0].hypot(f[1]) });
        out.push(Observed { name: Observed::MOMENT, unit: "N m", value: f[2].hypot(f[3]) });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let hollow = p.inner_diameter < p.diameter;
        if hollow { Vec::new() } else { vec![("inner_diameter", text!("inner_diameter is less than diameter"))] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::Attach;

    pub(super) fn link() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }
    pub(super) fn params(stiff: [f64; 2]) -> ShaftSpanParams {
        ShaftSpanParams {
            below: 0.25,
            above: 0.35,
            diameter: 0.035,
            inner_diameter: 0.02,
            modulus: 2.06e11,
            lower_support: stiff,
            upper_support: [1.5e7; 2],
        }
    }

    /// Forces of the two supports hold a force and a moment at the point; the shaft between bends as two cantilevers clamped there.
    #[test]
    fn statics_of_a_beam_on_springs() {
        let p = params([2e7, 1.2e7]);
        let (a, b, l) = (p.below, p.above, p.below + p.above);
        let ei = p.modulus * PI * (p.diameter.powi(4) - p.inner_diameter.powi(4)) / 64.0;
        for (i, (force, moment)) in [(0, (1.0, 0.0)), (0, (0.0, 1.0)), (1, (-2.0, 0.3))] {
            // upward reactions, positive against the load; slope and deflection of the rigid chord, then the two cantilevers
            let (low, high) = ((force * b - moment) / l, (force * a + moment) / l);
            let ends = [low / p.lower_support[i] + low * a.powi(3) / (3.0 * ei), high / p.upper_support[i] + high * b.powi(3) / (3.0 * ei)];
            // the tangent at the point goes through both deflected ends
            let slope = (ends[1] - ends[0]) / l;
            let deflection = (ends[0] * b + ends[1] * a) / l;
            let q = if i == 0 { [deflection, 0.0, 0.0, slope] } else { [0.0, deflection, -slope, 0.0] };
            let f = ShaftSpan::force(&p, &q);
            let (is, turned) = if i == 0 { (f[0], f[3]) } else { (f[1], -f[2]) };
            assert!((is - force).abs() < 1e-12 && (turned - moment).abs() < 1e-12, "{f:?}");
        }
    }

    #[test]
    fn in_the_middle_of_rigid_supports() {
        let p = ShaftSpanParams { above: 0.25, lower_support: [1e15; 2], upper_support: [1e15; 2], ..params([0.0; 2]) };
        let ei = p.modulus * PI * (p.diameter.powi(4) - p.inner_diameter.powi(4)) / 64.0;
        let [x, y] = ShaftSpan::planes(&p);
        assert!((x[0] / (48.0 * ei / 0.5f64.powi(3)) - 1.0).abs() < 1e-6 && (x[1] / x[0]).abs() < 1e-9);
        assert!((x[2] / (12.0 * ei / 0.5) - 1.0).abs() < 1e-6 && x == y);
    }
}

crate::conformance! {
    ShaftSpan {
        round: ShaftSpan::new(tests::link()), tests::params([1.5e7; 2]), Options::default();
        unequal_supports: ShaftSpan::new(tests::link()), tests::params([2e7, 1.2e7]), Options::anisotropic();
    }
}
