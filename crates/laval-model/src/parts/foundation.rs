//! A rigid foundation block on springs and dampers to the ground, moving in x and y.
//!
//! Equations: `M z'' + chi0 z' + c2 z = forces of attached parts`, per axis.
//!
//! Symbols: M mass, kg; c2 stiffness of all supports together, N/m; chi0 their damping, N s/m.
//!
//! Validity: no tilt of the block; linear supports.
//!
//! Theory: `docs/theory/machine.md#foundation`.
//!
//! Sources: `000_a291f7ede1484e56` section 2.1, equation (8).

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::capability::Extent;
use crate::model::capability::body::{BodyParameters, BodyPart};
use crate::model::erased;
use crate::model::field::{Bounds, Field, ParamValues, Values};
use crate::model::part::{At, Dof, Energy, ErasedPart, Layout, Observed, Params, Part, Physics};
use crate::params;
use crate::parts::disc::too_light;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Foundation`].
    pub struct FoundationParams in FoundationFamily {
        mass: scalar, "kg", Bounds::up_to(1e9), required, "mass M";
        stiffness: lateral, "N/m", Bounds::up_to(1e15), required, "stiffness c2 of all supports together";
        damping: lateral, "N s/m", Bounds::up_to(1e12), default 0.0, "damping chi0 of all supports together";
    }
}

/// See the [module](self).
pub struct Foundation;

impl Part for Foundation {
    const KIND: &'static str = "foundation";
    const EXAMPLE: &'static str = r#"name = "base"
mass = "60 kg"
stiffness = { x = "2.4e6 N/m", y = "1.8e6 N/m" }
damping = "900 N s/m"
"#;
    const DOC: &'static str = "A foundation block on elastic supports to the ground, movable in x and y. Other parts attach to it. With mass = 0 it is a point without inertia on its \
        supports.";
    type Family = FoundationFamily;
    const FIELDS: &'static [Field] = &[];

    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        Some(Foundation)
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::body(Dof::lateral())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        for i in 0..2 {
            b.mass[(i, i)] = p.mass;
            b.stiffness[(i, i)] = p.stiffness[i];
            b.damping[(i, i)] = p.damping[i];
        }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let mut e = Energy::zero();
        for i in 0..2 {
            e.stored += (p.mass * at.v[i].square() + p.stiffness[i] * at.q[i].square()).scale(0.5);
            e.dissipated += p.damping[i] * at.v[i].square();
        }
        Some(e)
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let force = |i: usize| p.stiffness[i] * at.q[i] + p.damping[i] * at.v[i];
        out.push(Observed { name: Observed::DISPLACEMENT, unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "ground force", unit: "N", value: force(0).hypot(force(1)) });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        too_light(p.mass).map(|message| ("mass", message)).into_iter().collect()
    }
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        Some(self)
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for Foundation {
    fn is_steady(&self) -> bool {
        true
    }
}

impl BodyPart for Foundation {
    fn shape(&self, _: &Params<Self, f64>, _: f64) -> Vec<[f64; 6]> {
        vec![[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]]
    }
    fn parameters(&self) -> BodyParameters {
        BodyParameters { mass: Some("mass"), unbalance: None, stiffness: Some("stiffness") }
    }
}

crate::conformance! {
    Foundation {
        isotropic: Foundation, FoundationParams { mass: 25.0, stiffness: [3.26e5; 2], damping: [6.59; 2] }, Options::default();
        anisotropic: Foundation, FoundationParams { mass: 25.0, stiffness: [3.26e5, 8e5], damping: [6.59, 50.0] }, Options::anisotropic();
    }
}
