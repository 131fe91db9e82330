//! Cross-coupled stiffness at a place of the machine, as a part of it.

use crate::model::blocks::Blocks;
use crate::model::capability::Extent;
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, ParamValues, Values};
use crate::model::part::{Layout, Link, Params, Part, Physics};
use laval_model::diagnostic::Diagnostics;
use laval_model::params;
use laval_num::scalar::Scalar;

params! {
    /// Parameters of a [`CrossCoupling`].
    pub struct CrossCouplingParams in CrossCouplingFamily {
        cross_coupled: scalar, "N/m", Bounds::within(1e15), required, "cross-coupled stiffness q";
    }
}

/// Force `Fx = -q y`, `Fy = q x` on a point: kxy = q, kyx = -q; of the opposite sign where the point turns from y towards x.
pub(super) struct CrossCoupling {
    /// The point.
    pub at: Attach,
    /// 1, or -1 where it turns from y towards x.
    pub sense: f64,
}

impl Part for CrossCoupling {
    const KIND: &'static str = "cross_coupling";
    const DOC: &'static str = "Cross-coupled stiffness kxy = -kyx at a point.";
    type Family = CrossCouplingFamily;
    const FIELDS: &'static [Field] = &[];

    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(Link::Between(self.at.clone(), Attach::ground()))
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let q = p.cross_coupled.scale(self.sense);
        b.stiffness[(0, 1)] = q;
        b.stiffness[(1, 0)] = -q;
    }
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for CrossCoupling {
    fn is_steady(&self) -> bool {
        true
    }
}
