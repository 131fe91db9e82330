//! A stop (snubber, retainer ring): free inside a gap, a stiff spring outside, with optional damping while in contact.
//!
//! Equations, on the deflection `d = z_a - z_b`, `r = |d|`, penetration `u = r - g`:
//!
//! ```text
//! f = N d/r,   N = max(k u + c u', 0) while u > 0, else 0
//! ```
//!
//! The contact never pulls. With damping the force jumps at first touch by c u'.
//!
//! Symbols: k contact stiffness, N/m; g radial gap, m; c contact damping, N s/m.
//!
//! Validity: no friction at the contact (no rub-driven backward whirl); a jump of the force needs steps that locate the touch.
//!
//! Theory: `docs/theory/rolling-bearings.md#stops`.
//!
//! Sources: Kelvin-Voigt contact without tension, as in S. W. Shaw, P. J. Holmes, J. Sound Vib. 90 (1983) 129, taken radially.

use crate::diagnostic::Diagnostics;
use crate::model::capability::Contacts;
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Rows, Uses};
use crate::params;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Stop`].
    pub struct StopParams in StopFamily {
        stiffness: scalar, "N/m", Bounds::positive(1e15), required, "contact stiffness k";
        gap: scalar, "m", Bounds::positive(1.0), required, "radial gap g";
        damping: scalar, "N s/m", Bounds::up_to(1e12), default 0.0, "contact damping c";
    }
}

/// See the [module](self).
pub struct Stop {
    link: Link,
}

/// Contact at a state: direction, penetration, its rate, normal force.
struct Contact<S> {
    direction: [S; 2],
    penetration: S,
    rate: S,
    force: S,
}

impl Stop {
    /// Between two points, or a point and the ground.
    pub fn new(link: Link) -> Self {
        Stop { link }
    }
    #[inline(always)]
    fn contact<S: Scalar>(p: &StopParams<S>, at: &At<S>) -> Contact<S> {
        let r = at.q[0].norm2(at.q[1]);
        let inverse = S::one() / r.select_pos(r, S::one());
        let direction = [at.q[0] * inverse, at.q[1] * inverse];
        let u = r - p.gap;
        let rate = direction[0] * at.v[0] + direction[1] * at.v[1];
        // 0 times the rate where there is no contact: a rate that is not a number is not hidden
        let rate = u.select_pos(rate, rate.scale(0.0));
        let penetration = u.pos();
        Contact { direction, penetration, rate, force: (p.stiffness * penetration + p.damping * rate).pos() }
    }
}

impl Part for Stop {
    const KIND: &'static str = "stop";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
stiffness = "5e7 N/m"
gap = "0.5 mm"
damping = "200 N s/m"
"#;
    const DOC: &'static str = "A stop that is free inside a radial gap and pushes back outside, with stiffness and optional damping while in \
        contact. It never pulls and has no friction.";
    type Family = StopFamily;
    const FIELDS: &'static [Field] = &[Field::required("between", FieldKind::Between, "the two points it keeps together")];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        Some(Stop::new(Link::Between(a, b)))
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
        Uses { velocity: true, acceleration: false, spin: false }
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let c = Self::contact(p, at);
        out.force[0] += c.force * c.direction[0];
        out.force[1] += c.force * c.direction[1];
    }
    /// What the damper takes, and what the spring loses unused when the contact parts before it has relaxed.
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let c = Self::contact(p, at);
        let spring = p.stiffness * c.penetration;
        Some(Energy { stored: (spring * c.penetration).scale(0.5), dissipated: (c.force - spring) * c.rate, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let c = Self::contact(p, at);
        out.push(Observed { name: "penetration", unit: "m", value: c.penetration });
        out.push(Observed { name: "force", unit: "N", value: c.force });
    }
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        Some(self)
    }
}

impl Contacts for Stop {
    fn clearance(&self, p: &Params<Self, f64>, at: &At<f64>) -> Option<f64> {
        Some(p.gap - at.q[0].hypot(at.q[1]))
    }
    fn switches(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<f64>) {
        let c = Self::contact(p, at);
        out.push(at.q[0].norm2(at.q[1]) - p.gap);
        out.push(p.stiffness * c.penetration + p.damping * c.rate);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::Attach;

    pub(super) fn joint() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }

    fn force(p: &StopParams, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let mut f = [0.0; 2];
        let at = At { q: &q, v: &v, a: &[0.0; 2], z: &[], phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 };
        Stop::new(joint()).residual(p, &at, &mut Rows { force: &mut f, rate: &mut [], spin: &mut 0.0 });
        f
    }

    #[test]
    fn free_inside_pushes_outside_never_pulls() {
        let p = StopParams { stiffness: 1e6, gap: 1e-3, damping: 100.0 };
        assert_eq!(force(&p, [5e-4, 5e-4], [1.0, 1.0]), [0.0; 2]);
        let f = force(&p, [0.0, -3e-3], [5.0, -0.1]); // 2 mm in, going further in at 0.1 m/s
        assert!(f[0].abs() < 1e-12 && (f[1] + 2010.0).abs() < 1e-9);
        assert_eq!(force(&p, [1.1e-3, 0.0], [-10.0, 0.0]), [0.0; 2]); // parts faster than the spring relaxes
        assert_eq!(force(&p, [0.0; 2], [0.0; 2]), [0.0; 2]);
    }

    /// A mass that hits the stop at speed v without damping leaves with -v after half a period sqrt(m/k) pi.
    #[test]
    fn an_elastic_bounce_takes_half_a_period() {
        let (p, m, v) = (StopParams { stiffness: 1e6, gap: 1e-3, damping: 0.0 }, 2.0, 0.3);
        let (mut x, mut u) = (1e-3, v);
        let steps = 20_000;
        let h = std::f64::consts::PI * (m / 1e6f64).sqrt() / f64::from(steps);
        for _ in 0..steps {
            let half = u - 0.5 * h * force(&p, [x, 0.0], [u, 0.0])[0] / m;
            x += h * half;
            u = half - 0.5 * h * force(&p, [x, 0.0], [half, 0.0])[0] / m;
        }
        assert!((u + v).abs() < 1e-7 * v && (x - 1e-3).abs() < 1e-9, "{u} {x}");
    }
}

crate::conformance! {
    Stop {
        elastic: Stop::new(tests::joint()), StopParams { stiffness: 1e6, gap: 6e-4, damping: 0.0 }, Options::default();
        damped: Stop::new(tests::joint()), StopParams { stiffness: 1e6, gap: 6e-4, damping: 900.0 }, Options { states: 40, ..Options::default() };
    }
}
