//! A nonlinear part that reads rates and has states of its own, without mass.

use laval::model::builder::Builder;
use laval::model::field::{Attach, Field, ParamValues, Values};
use laval::model::params::NoParams;
use laval::model::part::*;
use laval::model::system::System;
use laval::parts::{disc::*, foundation::*};
use laval_num::scalar::Scalar;

/// Bristles of deflection z: `f = k z + d |v|^2 v`, `z' = v - s |v|^2 z`.
struct Bristle {
    link: Link,
}

const K: f64 = 3e4;
const D: f64 = 4.0;
const S: f64 = 2.0;

impl Part for Bristle {
    const KIND: &'static str = "test_bristle";
    const DOC: &'static str = "Bristles that bend and slip.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut laval::diagnostic::Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let mut layout = Layout::point(self.link.clone());
        layout.states.extend(Dof::pair("z", DofKind::VectorX, "m", 1e-6));
        layout
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: true, acceleration: false, spin: false }
    }
    fn residual<T: Scalar>(&self, _: &(), at: &At<T>, out: &mut Rows<T>) {
        let v2 = at.v[0] * at.v[0] + at.v[1] * at.v[1];
        for i in 0..2 {
            out.force[i] += at.z[i].scale(K) + (v2 * at.v[i]).scale(D);
            out.rate[i] += at.v[i] - (v2 * at.z[i]).scale(S);
        }
    }
    fn energy<T: Scalar>(&self, _: &(), at: &At<T>) -> Option<Energy<T>> {
        let v2 = at.v[0] * at.v[0] + at.v[1] * at.v[1];
        let z2 = at.z[0] * at.z[0] + at.z[1] * at.z[1];
        Some(Energy { stored: z2.scale(0.5 * K), dissipated: (v2 * z2).scale(K * S) + (v2 * v2).scale(D), ..Energy::zero() })
    }
}

pub fn machine(horizontal: bool) -> System {
    let link = Link::Between(Attach::on("drum"), Attach::on("base"));
    let b = Builder::new("bristles")
        .part("drum", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(2.4) })
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [3e5; 2], damping: [100.0; 2] })
        .part("brush", Bristle { link }, ());
    if horizontal { b.horizontal() } else { b }.build().unwrap()
}
