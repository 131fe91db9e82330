//! An elastic coupling between two shafts, or from a shaft to a drive.
//!
//! Equations, forces on the first point by its motion relative to the second, in axes that turn with the rotor:
//!
//! ```text
//! F = -k d - c (d' - W R d),   d = (x, y) and, with tilt_stiffness and tilt_damping, (alpha, beta),   R: (x, y) -> (-y, x)
//! Fz = -ka u - ca u',   Mz = -kt theta - ct theta'
//! ```
//!
//! Symbols: k, c lateral stiffness, N/m, and damping, N s/m; ka, ca along the axis; kt, ct about it, N m/rad and N m s; W spin speed, rad/s; u displacement along
//! the axis, m; theta rotation about it relative to the spin, rad.
//!
//! The ground of the rotation is a drive that turns at the spin speed. The damping of a coupling turns with it: on lateral motion it destabilises above the
//! critical speed.
//!
//! Validity: both shafts turn at one speed; linear; no error of alignment.
//!
//! Theory: `docs/theory/shafts.md#along-and-about-the-axis`.
//!
//! Sources: any text on drive lines, as E. J. Nestorides, A Handbook on Torsional Vibration, Cambridge 1958.

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::capability::Scope;
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, PortKind};
use crate::model::spins::same_ratio;
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Coupling`].
    pub struct CouplingParams in CouplingFamily {
        stiffness: scalar, "N/m", Bounds::up_to(1e15), default 0.0, "lateral stiffness k";
        damping: scalar, "N s/m", Bounds::up_to(1e12), default 0.0, "lateral damping c, in axes that turn with the rotor";
        tilt_stiffness: scalar, "N m/rad", Bounds::up_to(1e15), default 0.0, "stiffness against tilt";
        tilt_damping: scalar, "N m s", Bounds::up_to(1e12), default 0.0, "damping of tilt, in axes that turn with the rotor";
        axial_stiffness: scalar, "N/m", Bounds::up_to(1e15), default 0.0, "stiffness ka along the axis";
        axial_damping: scalar, "N s/m", Bounds::up_to(1e12), default 0.0, "damping ca along the axis";
        torsional_stiffness: scalar, "N m/rad", Bounds::up_to(1e15), default 0.0, "stiffness kt about the axis";
        torsional_damping: scalar, "N m s", Bounds::up_to(1e12), default 0.0, "damping ct about the axis";
    }
}

/// See the [module](self).
pub struct Coupling {
    link: Link,
}

/// First local coordinates of displacement and tilt, and those along and about the axis.
const PAIRS: [usize; 2] = [0, 2];
const AXIAL: usize = 4;
const TWIST: usize = 5;

impl Coupling {
    /// Between two points.
    pub fn new(link: Link) -> Self {
        Coupling { link }
    }
    /// Stiffness and damping of displacement and of tilt.
    #[inline(always)]
    fn pairs<S: Scalar>(p: &CouplingParams<S>) -> [(usize, S, S); 2] {
        let of = [(p.stiffness, p.damping), (p.tilt_stiffness, p.tilt_damping)];
        [0, 1].map(|k| (PAIRS[k], of[k].0, of[k].1))
    }
    /// A pair, and its rate in axes that turn with the rotor.
    #[inline(always)]
    fn seen<S: Scalar>(at: &At<S>, i: usize) -> [Complex<S>; 2] {
        let q = c(at.q[i], at.q[i + 1]);
        [q, c(at.v[i], at.v[i + 1]) - q.mul_i().scale(at.speed)]
    }
    /// Size of the force on a pair.
    fn force(p: &CouplingParams<f64>, at: &At<f64>, k: usize) -> f64 {
        let (i, stiffness, damping) = Self::pairs(p)[k];
        let [q, rate] = Self::seen(at, i);
        (q.scale(stiffness) + rate.scale(damping)).abs()
    }
}

impl Part for Coupling {
    const KIND: &'static str = "coupling";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
torsional_stiffness = "2e5 N m/rad"
torsional_damping = "20 N m s"
"#;
    const DOC: &'static str = "An elastic coupling between two shafts, or from a shaft to a drive that turns at the spin speed (\"ground\"): stiffness and damping \
        of displacement, tilt, motion along the axis and rotation about it. Its damping turns with the rotor.";
    type Family = CouplingFamily;
    const FIELDS: &'static [Field] = &[Field::required("between", FieldKind::Between, "the two points it joins")];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        Some(Coupling { link: Link::Between(a, b) })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::on(PortKind::ALL, self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        for (i, stiffness, damping) in Self::pairs(p) {
            for k in [i, i + 1] {
                b.stiffness[(k, k)] = stiffness;
                b.damping[(k, k)] = damping;
            }
            b.circulatory[(i, i + 1)] = damping;
            b.circulatory[(i + 1, i)] = -damping;
        }
        for (i, stiffness, damping) in [(AXIAL, p.axial_stiffness, p.axial_damping), (TWIST, p.torsional_stiffness, p.torsional_damping)] {
            b.stiffness[(i, i)] = stiffness;
            b.damping[(i, i)] = damping;
        }
    }
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        let mut r = S::zero();
        for (i, _, damping) in Self::pairs(p) {
            let [q, rate] = Self::seen(at, i);
            r -= damping * (q.conj() * rate).im;
        }
        r
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let mut e = Energy::zero();
        for (i, stiffness, damping) in Self::pairs(p) {
            let [q, rate] = Self::seen(at, i);
            e.stored += (stiffness * q.norm_sqr()).scale(0.5);
            e.dissipated += damping * rate.norm_sqr();
        }
        for (i, stiffness, damping) in [(AXIAL, p.axial_stiffness, p.axial_damping), (TWIST, p.torsional_stiffness, p.torsional_damping)] {
            e.stored += (stiffness * at.q[i].square()).scale(0.5);
            e.dissipated += damping * at.v[i].square();
        }
        Some(e)
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let mut show = |name, unit, value: f64, exists: bool| {
            if exists {
                out.push(Observed { name, unit, value });
            }
        };
        let [lateral, tilt] = [0, 1].map(|k| Self::force(p, at, k));
        show("force", "N", lateral, p.stiffness != 0.0 || p.damping != 0.0);
        show(Observed::MOMENT, "N m", tilt, p.tilt_stiffness != 0.0 || p.tilt_damping != 0.0);
        let along = |i: usize, stiffness: f64, damping: f64| stiffness * at.q[i] + damping * at.v[i];
        let thrust = along(AXIAL, p.axial_stiffness, p.axial_damping);
        show("axial force", "N", thrust, p.axial_stiffness != 0.0 || p.axial_damping != 0.0);
        let torque = along(TWIST, p.torsional_stiffness, p.torsional_damping);
        show("torque", "N m", torque, p.torsional_stiffness != 0.0 || p.torsional_damping != 0.0);
    }
    fn scope(&self) -> Option<&dyn erased::Scope> {
        Some(self)
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        use crate::model::params::Family as _;
        let nothing = CouplingFamily::to_vec(p).iter().all(|x| *x == 0.0);
        if nothing { vec![("between", text!("the coupling does nothing: give it a stiffness"))] } else { Vec::new() }
    }
}

impl Scope for Coupling {
    fn refuses_ratio(&self, _: &Params<Self, f64>, ratio: f64) -> Option<Text> {
        (!same_ratio(ratio, 1.0))
            .then(|| text!("a coupling joins shafts of one speed; between shafts of different speeds use a gear or a bearing"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::Attach;

    pub(super) fn link() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }

    #[test]
    fn a_coupling_without_stiffness_is_refused() {
        let none = CouplingParams::new();
        assert!(Coupling::new(link()).check(&none)[0].1.contains("does nothing"));
        assert!(Coupling::new(link()).check(&CouplingParams { torsional_stiffness: 1.0, ..none }).is_empty());
    }
}

crate::conformance! {
    Coupling {
        all: Coupling::new(tests::link()),
            CouplingParams {
                stiffness: 2e6, damping: 40.0, tilt_stiffness: 3e3, tilt_damping: 0.6, axial_stiffness: 5e5, axial_damping: 20.0,
                torsional_stiffness: 2e4, torsional_damping: 3.0,
            },
            Options::default();
        torsional: Coupling::new(tests::link()), CouplingParams { torsional_stiffness: 2e4, ..CouplingParams::new() }, Options::default();
    }
}
