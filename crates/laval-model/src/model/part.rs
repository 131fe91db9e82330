//! A part: the physics of one piece of the machine, and no analysis.

use super::blocks::Blocks;
use super::erased;
use super::field::{Field, ParamValues, Values};
use super::params::{Family, MOST_LISTS, RowCounts};
use crate::diagnostic::Diagnostics;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

pub use super::capability::frequency::{Domain, Frozen, Words};
pub use super::capability::movable::{Correction, Outline};
pub use super::capability::scope::{Beyond, Tabulated};
pub use super::capability::time_form::Fitted;
pub use super::context::{
    At, COMPONENTS, Dof, DofKind, Energy, Layout, Link, Observed, Physics, Port, PortKind, Rows, TimeForm, Uses, Validity,
};
pub use super::params::{Parametric, Params};

/// A part with its type forgotten.
pub type ErasedPart = Arc<dyn erased::Erased>;

/// The physics of one kind of piece.
///
/// A part adds its share to the residual of the machine, written once over [`Scalar`]; see [`Physics`] for the three forms. It is affine in
/// `a` and `spin_accel`. It never sees other parts, positions or analyses.
///
/// The methods down to [`warnings`](Self::warnings) are the part; [`erased`](Self::erased) is for libraries of parts. Those after it declare a [capability](super::capability): a part that
/// implements the trait returns `Some(self)`.
pub trait Part: Send + Sync + Sized + 'static {
    /// The word in the file.
    const KIND: &'static str;
    /// One paragraph for the documentation.
    const DOC: &'static str;
    /// Lines of a typical block beside a body named `drum`, for the documentation; where it is empty they follow from the fields.
    const EXAMPLE: &'static str = "";
    /// Parameters, declared with [`params!`](crate::params).
    type Family: Family;
    /// What the file may say besides the parameters: where it is attached, which force law, tables.
    const FIELDS: &'static [Field];

    /// Builds the part from its fields and reports every mistake in `diagnostics`; values that parameters depend on
    /// (given in another form) are written to `params`.
    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self>;
    /// Relations between parameters that bounds cannot express: the parameter and the mistake.
    fn check(&self, _p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        Vec::new()
    }
    /// Ports, own coordinates and internal states.
    fn layout(&self) -> Layout;
    /// The form of its physics.
    fn physics(&self) -> Physics;
    /// What a nonlinear residual reads.
    fn uses(&self) -> Uses {
        Uses { velocity: true, acceleration: true, spin: true }
    }
    /// How many of its states, the last ones, are memory states ([`Blocks::memory`]).
    fn memory(&self) -> usize {
        0
    }
    /// Adds its share; only for [`Physics::Nonlinear`].
    fn residual<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>, _out: &mut Rows<S>) {}
    /// Fills the blocks at a spin speed (rad/s); for [`Physics::Linear`] and for the time form of [`Physics::Frequency`].
    fn linear<S: Scalar>(&self, _p: &Params<Self, S>, _speed: S, _blocks: &mut Blocks<S>) {}
    /// Share in the spin row of a part with linear blocks, N m: `inertia spin_accel + ... - torque`.
    fn spin_row<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>) -> S {
        S::zero()
    }
    /// Energy and power; `None` when the part keeps no account.
    fn energy<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>) -> Option<Energy<S>> {
        None
    }
    /// Quantities worth showing.
    fn observe(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<Observed>) {}
    /// Use of the model's validity.
    fn validity(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<Validity>) {}
    /// Why the part does not serve its purpose although its model is right: sentences that begin with a small letter and end without a stop.
    fn warnings(&self, _p: &Params<Self, f64>) -> Vec<Text> {
        Vec::new()
    }

    /// The part with its type forgotten. The parts of a library repeat these lines with `#[inline(never)]`, so that their arithmetic in lanes is
    /// compiled in the library and not once more in every crate that builds a machine of them.
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }

    /// Other parts attach to it: [`BodyPart`](super::capability::BodyPart).
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        None
    }
    /// It has many coordinates, or parameters in lists: [`Extent`](super::capability::Extent).
    fn extent(&self) -> Option<&dyn erased::Extent> {
        None
    }
    /// Gaps and force laws that are not smooth: [`Contacts`](super::capability::Contacts).
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        None
    }
    /// Masses that move in the rotor: [`MovableMasses`](super::capability::MovableMasses).
    fn movable_masses(&self) -> Option<&dyn erased::MovableMasses> {
        None
    }
    /// A mass matrix of its own that varies with the configuration: [`VaryingInertia`](super::capability::VaryingInertia).
    fn varying_inertia(&self) -> Option<&dyn erased::VaryingInertia> {
        None
    }
    /// Negative added inertia: [`AddedInertia`](super::capability::AddedInertia).
    fn added_inertia(&self) -> Option<&dyn erased::AddedInertia> {
        None
    }
    /// Exact dynamic stiffness and where it is analytic: [`FrequencyDomain`](super::capability::FrequencyDomain).
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        None
    }
    /// Another part takes its place in motions: [`ReplacedInTime`](super::capability::ReplacedInTime).
    fn replaced_in_time(&self) -> Option<&dyn erased::ReplacedInTime> {
        None
    }
    /// It drives the spin: [`SpinDrive`](super::capability::SpinDrive).
    fn spin_drive(&self) -> Option<&dyn erased::SpinDrive> {
        None
    }
    /// It is a liquid in a cavity: [`Filling`](super::capability::Filling).
    fn filling(&self) -> Option<&dyn erased::Filling> {
        None
    }
    /// It joins two wheels on parallel axes: [`Mesh`](super::capability::Mesh).
    fn mesh(&self) -> Option<&dyn erased::Mesh> {
        None
    }
    /// It does not serve every machine or every speed: [`Scope`](super::capability::Scope).
    fn scope(&self) -> Option<&dyn erased::Scope> {
        None
    }
}

impl<P: Part> Parametric for P {
    type Family = <P as Part>::Family;
    #[inline(always)]
    fn row_counts(&self) -> RowCounts {
        self.extent().map_or([0; MOST_LISTS], |e| e.rows())
    }
}
