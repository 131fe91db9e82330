//! Another spin of the machine, of a fixed ratio to the first: that of a coaxial or a geared shaft.
//!
//! Equations: `phase_k = r phase`, `W_k = r W`, `W_k' = r W'`. A torque M on this spin is r M on that of the machine.
//!
//! Symbols: phase spin angle, rad; W spin speed, rad/s; r ratio, negative for a shaft that turns the other way.
//!
//! Validity: the ratio is that of a rigid gear or of two controlled drives; what the teeth yield is motion relative to the spins (`gear`).
//!
//! Theory: `docs/theory/shafts.md#several-spins`.
//!
//! Sources: K. Gupta, K. D. Gupta, K. Athre, ASME J. Vib. Acoust. 115 (1993) 427 (dual-rotor systems); the carried-over torque is that of equal work.

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::capability::Scope;
use crate::model::erased;
use crate::model::field::{Bounds, Field, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Params, Part, Physics};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`SpeedRatio`].
    pub struct SpeedRatioParams in SpeedRatioFamily {
        ratio: scalar, "", Bounds::within(1e4), required, "speed over that of the machine; negative where it turns the other way";
    }
}

/// What the documentation of a part says of its key `spin`.
pub const SPIN: &str = "the part of kind \"speed_ratio\" with which it turns; without it, it turns with the body that carries it or else at the speed of the machine";

/// See the [module](self).
pub struct SpeedRatio;

impl Part for SpeedRatio {
    const KIND: &'static str = "speed_ratio";
    const EXAMPLE: &'static str = "name = \"inner\"\nratio = -1.4\n";
    const DOC: &'static str = "Another spin of the machine, at a fixed ratio to its speed: the inner shaft of two coaxial ones, or the driven shaft of a gear. A shaft \
        or disc that names it turns with it, and so does all that is attached to that body.";
    type Family = SpeedRatioFamily;
    const FIELDS: &'static [Field] = &[];

    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        Some(SpeedRatio)
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::default()
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, _: &Params<Self, S>, _: S, _: &mut Blocks<S>) {}
    fn energy<S: Scalar>(&self, _: &Params<Self, S>, _: &At<S>) -> Option<Energy<S>> {
        Some(Energy::zero())
    }
    fn scope(&self) -> Option<&dyn erased::Scope> {
        Some(self)
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let still = p.ratio == 0.0;
        if still { vec![("ratio", text!("a spin of ratio 0 stands still: parts that do not turn need none"))] } else { Vec::new() }
    }
}

impl Scope for SpeedRatio {
    fn spin_ratio(&self) -> Option<usize> {
        Some(0)
    }
}

crate::conformance! {
    SpeedRatio {
        opposite: SpeedRatio, SpeedRatioParams { ratio: -1.4 }, Options::default();
    }
}
