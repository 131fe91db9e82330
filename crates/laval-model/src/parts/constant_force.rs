//! A force, and a moment, that stays the same in size and direction: the pull of a belt, the thrust of a pump, the load of a test bench.
//!
//! Equations, the applied force and moment on a point: `(Fx, Fy, Fz)`, `(Mx, My)`, in fixed axes. The weight of a part is no such force: it follows from the mass and the
//! axis of the machine.
//!
//! Symbols: F force, N; M moment about the x and y axes through the point, N m.
//!
//! Validity: the force does not change with the motion, the speed or the time.
//!
//! Theory: `docs/theory/shafts.md#sag`.
//!
//! Sources: M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees, Dynamics of Rotating Machines, Cambridge 2010, section 5.5 (static load of bearings).

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::capability::Extent;
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, PortKind};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`ConstantForce`].
    pub struct ConstantForceParams in ConstantForceFamily {
        force_x: scalar, "N", Bounds::within(1e12), default 0.0, "force along x";
        force_y: scalar, "N", Bounds::within(1e12), default 0.0, "force along y; up where the axis is horizontal";
        axial_force: scalar, "N", Bounds::within(1e12), default 0.0, "force along the axis; of a body that moves along the axis";
        moment_about_x: scalar, "N m", Bounds::within(1e12), default 0.0, "moment about the x axis; of a body that tilts";
        moment_about_y: scalar, "N m", Bounds::within(1e12), default 0.0, "moment about the y axis; of a body that tilts";
    }
}

/// See the [module](self).
pub struct ConstantForce {
    on: Attach,
    tilt: bool,
    axial: bool,
}

impl ConstantForce {
    /// Across the axis.
    pub fn lateral(on: Attach) -> Self {
        ConstantForce { on, tilt: false, axial: false }
    }
    /// Across the axis, along it, and moments.
    pub fn general(on: Attach) -> Self {
        ConstantForce { on, tilt: true, axial: true }
    }
    /// Over the local coordinates, and how many there are.
    #[inline(always)]
    fn loads<S: Scalar>(&self, p: &ConstantForceParams<S>) -> ([S; 5], usize) {
        let mut out = [p.force_x, p.force_y, S::zero(), S::zero(), S::zero()];
        let mut n = 2;
        if self.tilt {
            (out[2], out[3]) = (p.moment_about_x, p.moment_about_y);
            n = 4;
        }
        if self.axial {
            out[n] = p.axial_force;
            n += 1;
        }
        (out, n)
    }
}

impl Part for ConstantForce {
    const KIND: &'static str = "constant_force";
    const EXAMPLE: &'static str = r#"on = { body = "drum", at = "120 mm" }   # a belt that pulls up
force_y = "800 N"
"#;
    const DOC: &'static str = "A force, and a moment, of constant size and direction on a point of a body: the pull of a belt, the radial or axial thrust of a pump. \
        It bends the shaft and loads the bearings, in every study that starts from the state of rest.";
    type Family = ConstantForceFamily;
    const FIELDS: &'static [Field] = &[Field::required("on", FieldKind::Attach { ground: false }, "point of a body on which it acts")];

    fn build(values: &Values, params: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        let given = |name: &str| params.get(name).is_some_and(|x| x != 0.0);
        Some(ConstantForce {
            on: values.attach("on")?,
            tilt: given("moment_about_x") || given("moment_about_y"),
            axial: given("axial_force"),
        })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        let kind = PortKind { tilt: self.tilt, axial: self.axial, ..PortKind::POINT };
        Layout::on(kind, Link::On(self.on.clone()))
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let (loads, n) = self.loads(p);
        b.force[..n].copy_from_slice(&loads[..n]);
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let (loads, n) = self.loads(p);
        let mut supplied = S::zero();
        for i in 0..n {
            supplied += loads[i] * at.v[i];
        }
        Some(Energy { supplied, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, _: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "force", unit: "N", value: p.force_x.hypot(p.force_y) });
        if self.tilt {
            out.push(Observed { name: Observed::MOMENT, unit: "N m", value: p.moment_about_x.hypot(p.moment_about_y) });
        }
        if self.axial {
            out.push(Observed { name: "axial force", unit: "N", value: p.axial_force });
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let mut out = Vec::new();
        if [p.force_x, p.force_y, p.axial_force, p.moment_about_x, p.moment_about_y].iter().all(|x| *x == 0.0) {
            out.push(("on", text!("this part does nothing: give a force or a moment")));
        }
        let without = |name: &'static str| (name, text!("this force was built without {name}", name));
        out.extend((!self.axial && p.axial_force != 0.0).then(|| without("axial_force")));
        for (name, value) in [("moment_about_x", p.moment_about_x), ("moment_about_y", p.moment_about_y)] {
            out.extend((!self.tilt && value != 0.0).then(|| without(name)));
        }
        out
    }
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for ConstantForce {
    fn is_steady(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn params() -> ConstantForceParams {
        ConstantForceParams { force_x: 30.0, force_y: -700.0, axial_force: 250.0, moment_about_x: 4.0, moment_about_y: -6.0 }
    }

    pub(super) fn lateral() -> ConstantForceParams {
        ConstantForceParams { axial_force: 0.0, moment_about_x: 0.0, moment_about_y: 0.0, ..params() }
    }

    #[test]
    fn what_it_was_built_without_is_refused() {
        let force = ConstantForce::lateral(Attach::on("drum"));
        assert!(force.check(&lateral()).is_empty());
        let names: Vec<&str> = force.check(&params()).iter().map(|x| x.0).collect();
        assert_eq!(names, ["axial_force", "moment_about_x", "moment_about_y"]);
        let nothing = ConstantForceParams { force_x: 0.0, force_y: 0.0, ..lateral() };
        assert_eq!(force.check(&nothing)[0].0, "on");
    }
}

crate::conformance! {
    ConstantForce {
        lateral: ConstantForce::lateral(Attach::on("drum")), tests::lateral(), Options::anisotropic();
        general: ConstantForce::general(Attach::on("drum")), tests::params(), Options::anisotropic();
    }
}
