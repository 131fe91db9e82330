//! What the rotor turns besides the parts of the machine: inertia about the axis, and torques that resist the spin.
//!
//! Equations, the share of the spin row, spin speed W:
//!
//! ```text
//! J W' + c W + k |W| W
//! ```
//!
//! Symbols: J inertia, kg m^2; c drag, N m s/rad; k windage, N m s^2/rad^2.
//!
//! The spin is a coordinate when the machine says `drive = "free"`. While it is prescribed, these torques are part of the torque of the drive that a study
//! reports.
//!
//! Validity: what it stands for is rigidly coupled to the rotor; slow changes of speed, so that the steady drag holds.
//!
//! Theory: `docs/theory/motors-and-run-up.md#torque-curves`.
//!
//! Sources: linear drag of lubricated bearings; windage with the square of the speed, as for turbulent flow around discs (H. Schlichting, Boundary-Layer Theory,
//! McGraw-Hill 1979, chapter XXI).

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Observed, Params, Part, Physics};
use crate::params;
use crate::parts::speed_ratio::SPIN;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`SpinLoad`].
    pub struct SpinLoadParams in SpinLoadFamily {
        inertia: scalar, "kg m^2", Bounds::up_to(1e9), default 0.0, "moment of inertia J about the axis";
        drag: scalar, "N m s/rad", Bounds::up_to(1e9), default 0.0, "drag c of bearings and seals: torque over speed";
        windage: scalar, "N m s^2/rad^2", Bounds::up_to(1e9), default 0.0, "windage k: torque over the square of the speed";
    }
}

/// See the [module](self).
#[derive(Default)]
pub struct SpinLoad {
    /// The part that gives the ratio of the spin it loads.
    spin: Option<String>,
}

impl SpinLoad {
    #[inline(always)]
    fn resists<S: Scalar>(&self, p: &SpinLoadParams<S>, speed: S) -> S {
        p.drag * speed + p.windage * speed.abs() * speed
    }
}

impl Part for SpinLoad {
    const KIND: &'static str = "spin_load";
    const EXAMPLE: &'static str = r#"inertia = "0.05 kg m^2"
drag = "2e-3 N m s"
"#;
    const DOC: &'static str = "Inertia about the axis and torques that resist the spin: a coupling or gear on the shaft, drag of bearings, windage. It counts in the \
        torque and power of the drive, and with drive = \"free\" in how the speed changes, as in a run-down.";
    type Family = SpinLoadFamily;
    const FIELDS: &'static [Field] = &[Field::optional("spin", FieldKind::Text, "", SPIN)];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        Some(SpinLoad { spin: values.text("spin").map(str::to_string) })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout { spin: self.spin.clone(), ..Layout::default() }
    }
    /// Nothing but a share of the spin row.
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, _: &Params<Self, S>, _: S, _: &mut Blocks<S>) {}
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        p.inertia * at.spin_accel + self.resists(p, at.speed)
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let w = at.speed;
        Some(Energy { stored: (p.inertia * w * w).scale(0.5), dissipated: self.resists(p, w) * w, supplied: S::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "torque", unit: "N m", value: self.resists(p, at.speed) });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let nothing = p.inertia == 0.0 && p.drag == 0.0 && p.windage == 0.0;
        if nothing { vec![("inertia", text!("this part does nothing: give inertia, drag or windage"))] } else { Vec::new() }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(super) fn params() -> SpinLoadParams {
        SpinLoadParams { inertia: 0.3, drag: 2e-3, windage: 4e-6 }
    }

    #[test]
    fn resists_either_way() {
        let torque = |w: f64| SpinLoad::default().resists(&params(), w);
        assert!((torque(500.0) - 2.0).abs() < 1e-14 && torque(-500.0) == -torque(500.0));
        assert!(SpinLoad::default().spin_drive().is_none());
        assert_eq!(SpinLoad::default().check(&SpinLoadParams { inertia: 0.0, drag: 0.0, windage: 0.0 })[0].0, "inertia");
    }
}

crate::conformance! {
    SpinLoad {
        all: SpinLoad::default(), tests::params(), Options::default();
        inertia: SpinLoad::default(), SpinLoadParams { drag: 0.0, windage: 0.0, ..tests::params() }, Options::default();
    }
}
