//! Parts composed at run time: the object-safe faces of [`Part`](super::part::Part) and of the [capabilities](super::capability), one method
//! slot per scalar. Every part has them (module `erasure`).

use super::blocks::Blocks;
use super::capability::frequency::{Domain, Frozen};
use super::capability::scope::Tabulated;
use super::capability::time_form::{Fitted, Speeds, Untimed};
use super::context::{At, Energy, Layout, Observed, Physics, Rows, Uses, Validity};
use super::field::Field;
use super::lanes::InLanes;
use super::params::{List, ParamSlot};
use crate::text::Text;
use laval_num::complex::Complex;
use laval_num::dual::Dual;
use laval_num::scalar::Scalar;
use std::sync::Arc;

pub use super::capability::added_inertia::erased::AddedInertia;
pub use super::capability::body::erased::BodyPart;
pub use super::capability::contact::erased::Contacts;
pub use super::capability::drive::erased::SpinDrive;
pub use super::capability::extent::erased::Extent;
pub use super::capability::filling::erased::Filling;
pub use super::capability::mesh::erased::Mesh;
pub use super::capability::movable::erased::MovableMasses;
pub use super::capability::scope::erased::Scope;
pub use super::capability::varying::erased::VaryingInertia;

/// One derivative: with respect to the spin speed or one parameter.
pub type D1 = Dual<f64, 1>;
/// Eight derivatives at once: the width tangents are seeded in.
pub type D8 = Dual<f64, 8>;

/// Calls a macro with the scalars that have slots, and the names of their methods.
macro_rules! with_scalars {
    ($then:ident) => {
        $then! {
            f64: residual_f64 linear_f64 load_f64 impedance_f64 regular_f64 energy_f64;
            D1: residual_d1 linear_d1 load_d1 impedance_d1 regular_d1 energy_d1;
            D8: residual_d8 linear_d8 load_d8 impedance_d8 regular_d8 energy_d8;
        }
    };
}
pub(super) use with_scalars;

macro_rules! faces {
    ($( $scalar:ty: $residual:ident $linear:ident $load:ident $impedance:ident $regular:ident $energy:ident; )*) => {
        /// A part with its type forgotten. Parameters arrive as consecutive scalars.
        #[allow(missing_docs)]
        pub trait Erased: InLanes + Send + Sync {
            fn kind(&self) -> &'static str;
            fn layout(&self) -> Layout;
            fn physics(&self) -> Physics;
            fn uses(&self) -> Uses;
            fn reach(&self) -> usize;
            fn is_steady(&self) -> bool;
            fn memory(&self) -> usize;
            fn slots(&self) -> Vec<ParamSlot>;
            fn lists(&self) -> Vec<List>;
            fn fields(&self) -> &'static [Field];
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>);
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>);
            fn check(&self, p: &[f64]) -> Vec<(&'static str, Text)>;
            fn warnings(&self, p: &[f64]) -> Vec<Text>;
            fn spin_row_f64(&self, p: &[f64], at: &At<f64>) -> f64;
            fn spin_row_d8(&self, p: &[D8], at: &At<D8>) -> D8;
            fn prepared(&self, p: &[f64]) -> Option<Arc<dyn Erased>>;
            fn body(&self) -> Option<&dyn BodyPart>;
            fn contacts(&self) -> Option<&dyn Contacts>;
            fn movable_masses(&self) -> Option<&dyn MovableMasses>;
            fn varying_inertia(&self) -> Option<&dyn VaryingInertia>;
            fn added_inertia(&self) -> Option<&dyn AddedInertia>;
            fn frequency_domain(&self) -> Option<&dyn FrequencyDomain>;
            fn replaced_in_time(&self) -> Option<&dyn ReplacedInTime>;
            fn spin_drive(&self) -> Option<&dyn SpinDrive>;
            fn filling(&self) -> Option<&dyn Filling>;
            fn mesh(&self) -> Option<&dyn Mesh>;
            fn scope(&self) -> Option<&dyn Scope>;
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>);
                fn $linear(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>);
                fn $energy(&self, p: &[$scalar], at: &At<$scalar>) -> Option<Energy<$scalar>>;
            )*
        }

        /// See the [trait of the author](super::capability::FrequencyDomain).
        #[allow(missing_docs)]
        pub trait FrequencyDomain {
            fn domain(&self, p: &[f64], speed: f64) -> Option<Domain>;
            fn rough(&self) -> Option<Arc<dyn Erased>>;
            fn approximation(&self, p: &[f64]) -> Option<(Arc<dyn Erased>, Vec<f64>)>;
            fn frequencies(&self) -> Option<Tabulated>;
            fn frozen(&self, at: Frozen) -> Option<Arc<dyn Erased>>;
            $(
                fn $load(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>);
                fn $impedance(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar, out: &mut [Complex<$scalar>]);
                fn $regular(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar) -> Complex<$scalar>;
            )*
        }

        $(
            impl Evaluate for $scalar {
                fn residual(part: &dyn Erased, p: &[Self], at: &At<Self>, out: &mut Rows<Self>, blocks: &mut Blocks<Self>) {
                    part.$residual(p, at, out, blocks)
                }
                fn linear(part: &dyn Erased, p: &[Self], speed: Self, blocks: &mut Blocks<Self>) {
                    part.$linear(p, speed, blocks)
                }
                fn load(part: &dyn FrequencyDomain, p: &[Self], speed: Self, blocks: &mut Blocks<Self>) {
                    part.$load(p, speed, blocks)
                }
                fn impedance(part: &dyn FrequencyDomain, p: &[Self], s: Complex<Self>, speed: Self, out: &mut [Complex<Self>]) {
                    part.$impedance(p, s, speed, out)
                }
                fn regular(part: &dyn FrequencyDomain, p: &[Self], s: Complex<Self>, speed: Self) -> Complex<Self> {
                    part.$regular(p, s, speed)
                }
                fn energy(part: &dyn Erased, p: &[Self], at: &At<Self>) -> Option<Energy<Self>> {
                    part.$energy(p, at)
                }
            }
        )*
    };
}

/// A scalar that machines can be evaluated in.
pub trait Evaluate: Scalar {
    /// [`Part::residual`](super::part::Part::residual), or the same from the part's blocks.
    fn residual(part: &dyn Erased, p: &[Self], at: &At<Self>, out: &mut Rows<Self>, blocks: &mut Blocks<Self>);
    /// [`Part::linear`](super::part::Part::linear); the caller has reset the blocks to the part's size.
    fn linear(part: &dyn Erased, p: &[Self], speed: Self, blocks: &mut Blocks<Self>);
    /// [`load`](super::capability::FrequencyDomain::load); the caller has reset the blocks to the part's size, without states.
    fn load(part: &dyn FrequencyDomain, p: &[Self], speed: Self, blocks: &mut Blocks<Self>);
    /// [`impedance`](super::capability::FrequencyDomain::impedance).
    fn impedance(part: &dyn FrequencyDomain, p: &[Self], s: Complex<Self>, speed: Self, out: &mut [Complex<Self>]);
    /// [`regular`](super::capability::FrequencyDomain::regular).
    fn regular(part: &dyn FrequencyDomain, p: &[Self], s: Complex<Self>, speed: Self) -> Complex<Self>;
    /// [`Part::energy`](super::part::Part::energy).
    fn energy(part: &dyn Erased, p: &[Self], at: &At<Self>) -> Option<Energy<Self>>;
}

with_scalars!(faces);

/// See the [trait of the author](super::capability::ReplacedInTime).
#[allow(missing_docs)]
pub trait ReplacedInTime {
    fn timed(&self, p: &[f64], speeds: Speeds, stop: &dyn Fn() -> bool) -> Option<Result<Arc<dyn Erased>, Untimed>>;
    fn fitted(&self) -> Option<Fitted>;
}
