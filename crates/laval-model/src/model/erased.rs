//! Parts composed at run time: the object-safe faces of [`Part`] and of the [capabilities](super::capability), one method slot per scalar,
//! filled by one blanket implementation each.

use super::blocks::Blocks;
use super::capability;
use super::lanes::InLanes;
use super::params::{Family, ParamSlot};
use super::part::{At, Domain, Energy, Layout, Observed, Part, Physics, Rows, Uses, Validity};
use laval_num::complex::Complex;
use laval_num::dual::Dual;
use laval_num::scalar::Scalar;
use std::sync::Arc;

pub use super::capability::added_inertia::erased::AddedInertia;
pub use super::capability::body::erased::BodyPart;
pub use super::capability::contact::erased::Contacts;
pub use super::capability::drive::erased::SpinDrive;
pub use super::capability::filling::erased::Filling;
pub use super::capability::movable::erased::MovableMasses;
pub use super::capability::scope::erased::Scope;
pub use super::capability::time_form::erased::ReplacedInTime;
pub use super::capability::varying::erased::VaryingInertia;

/// One derivative: with respect to the spin speed or one parameter.
pub type D1 = Dual<f64, 1>;
/// Eight derivatives at once: the width tangents are seeded in.
pub type D8 = Dual<f64, 8>;

macro_rules! erased {
    ($( $scalar:ty: $residual:ident $linear:ident $load:ident $impedance:ident $regular:ident $energy:ident; )*) => {
        /// A part with its type forgotten. Parameters arrive as consecutive scalars.
        #[allow(missing_docs)]
        pub trait Erased: InLanes + Send + Sync {
            fn kind(&self) -> &'static str;
            fn layout(&self) -> Layout;
            fn physics(&self) -> Physics;
            fn uses(&self) -> Uses;
            fn memory(&self) -> usize;
            fn slots(&self) -> Vec<ParamSlot>;
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>);
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>);
            fn check(&self, p: &[f64]) -> Vec<(&'static str, String)>;
            fn warnings(&self, p: &[f64]) -> Vec<String>;
            fn body(&self) -> Option<&dyn BodyPart>;
            fn contacts(&self) -> Option<&dyn Contacts>;
            fn movable_masses(&self) -> Option<&dyn MovableMasses>;
            fn varying_inertia(&self) -> Option<&dyn VaryingInertia>;
            fn added_inertia(&self) -> Option<&dyn AddedInertia>;
            fn frequency_domain(&self) -> Option<&dyn FrequencyDomain>;
            fn replaced_in_time(&self) -> Option<&dyn ReplacedInTime>;
            fn spin_drive(&self) -> Option<&dyn SpinDrive>;
            fn filling(&self) -> Option<&dyn Filling>;
            fn scope(&self) -> Option<&dyn Scope>;
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>);
                fn $linear(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>);
                fn $energy(&self, p: &[$scalar], at: &At<$scalar>) -> Option<Energy<$scalar>>;
            )*
        }

        impl<T: Part> Erased for T {
            fn kind(&self) -> &'static str {
                T::KIND
            }
            fn layout(&self) -> Layout {
                Part::layout(self)
            }
            fn physics(&self) -> Physics {
                Part::physics(self)
            }
            fn uses(&self) -> Uses {
                Part::uses(self)
            }
            fn memory(&self) -> usize {
                Part::memory(self)
            }
            fn slots(&self) -> Vec<ParamSlot> {
                T::Family::slots()
            }
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>) {
                Part::observe(self, &T::Family::from_slice(p), at, out)
            }
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>) {
                Part::validity(self, &T::Family::from_slice(p), at, out)
            }
            fn check(&self, p: &[f64]) -> Vec<(&'static str, String)> {
                Part::check(self, &T::Family::from_slice(p))
            }
            fn warnings(&self, p: &[f64]) -> Vec<String> {
                Part::warnings(self, &T::Family::from_slice(p))
            }
            fn body(&self) -> Option<&dyn BodyPart> {
                Part::body(self)
            }
            fn contacts(&self) -> Option<&dyn Contacts> {
                Part::contacts(self)
            }
            fn movable_masses(&self) -> Option<&dyn MovableMasses> {
                Part::movable_masses(self)
            }
            fn varying_inertia(&self) -> Option<&dyn VaryingInertia> {
                Part::varying_inertia(self)
            }
            fn added_inertia(&self) -> Option<&dyn AddedInertia> {
                Part::added_inertia(self)
            }
            fn frequency_domain(&self) -> Option<&dyn FrequencyDomain> {
                Part::frequency_domain(self)
            }
            fn replaced_in_time(&self) -> Option<&dyn ReplacedInTime> {
                Part::replaced_in_time(self)
            }
            fn spin_drive(&self) -> Option<&dyn SpinDrive> {
                Part::spin_drive(self)
            }
            fn filling(&self) -> Option<&dyn Filling> {
                Part::filling(self)
            }
            fn scope(&self) -> Option<&dyn Scope> {
                Part::scope(self)
            }
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>) {
                    residual(self, p, at, out, blocks)
                }
                fn $linear(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>) {
                    Part::linear(self, &T::Family::from_slice(p), speed, blocks)
                }
                fn $energy(&self, p: &[$scalar], at: &At<$scalar>) -> Option<Energy<$scalar>> {
                    Part::energy(self, &T::Family::from_slice(p), at)
                }
            )*
        }

        /// See the [trait of the author](capability::FrequencyDomain).
        #[allow(missing_docs)]
        pub trait FrequencyDomain {
            fn domain(&self, p: &[f64], speed: f64) -> Option<Domain>;
            fn rough(&self) -> Option<Arc<dyn Erased>>;
            fn approximation(&self, p: &[f64]) -> Option<(Arc<dyn Erased>, Vec<f64>)>;
            $(
                fn $load(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>);
                fn $impedance(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar, out: &mut [Complex<$scalar>]);
                fn $regular(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar) -> Complex<$scalar>;
            )*
        }

        impl<T: capability::FrequencyDomain> FrequencyDomain for T {
            fn domain(&self, p: &[f64], speed: f64) -> Option<Domain> {
                capability::FrequencyDomain::domain(self, &T::Family::from_slice(p), speed)
            }
            fn rough(&self) -> Option<Arc<dyn Erased>> {
                capability::FrequencyDomain::rough(self).map(|p| Arc::new(p) as Arc<dyn Erased>)
            }
            fn approximation(&self, p: &[f64]) -> Option<(Arc<dyn Erased>, Vec<f64>)> {
                let (part, p) = capability::FrequencyDomain::approximation(self, &T::Family::from_slice(p))?;
                Some((Arc::new(part), T::Family::to_vec(&p)))
            }
            $(
                fn $load(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>) {
                    capability::FrequencyDomain::load(self, &T::Family::from_slice(p), speed, blocks)
                }
                fn $impedance(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar, out: &mut [Complex<$scalar>]) {
                    capability::FrequencyDomain::impedance(self, &T::Family::from_slice(p), s, speed, out)
                }
                fn $regular(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar) -> Complex<$scalar> {
                    capability::FrequencyDomain::regular(self, &T::Family::from_slice(p), s, speed)
                }
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
    /// [`Part::residual`], or the same from the part's blocks.
    fn residual(part: &dyn Erased, p: &[Self], at: &At<Self>, out: &mut Rows<Self>, blocks: &mut Blocks<Self>);
    /// [`Part::linear`]; the caller has reset the blocks to the part's size.
    fn linear(part: &dyn Erased, p: &[Self], speed: Self, blocks: &mut Blocks<Self>);
    /// [`capability::FrequencyDomain::load`]; the caller has reset the blocks to the part's size, without states.
    fn load(part: &dyn FrequencyDomain, p: &[Self], speed: Self, blocks: &mut Blocks<Self>);
    /// [`capability::FrequencyDomain::impedance`].
    fn impedance(part: &dyn FrequencyDomain, p: &[Self], s: Complex<Self>, speed: Self, out: &mut [Complex<Self>]);
    /// [`capability::FrequencyDomain::regular`].
    fn regular(part: &dyn FrequencyDomain, p: &[Self], s: Complex<Self>, speed: Self) -> Complex<Self>;
    /// [`Part::energy`].
    fn energy(part: &dyn Erased, p: &[Self], at: &At<Self>) -> Option<Energy<Self>>;
}

erased! {
    f64: residual_f64 linear_f64 load_f64 impedance_f64 regular_f64 energy_f64;
    D1: residual_d1 linear_d1 load_d1 impedance_d1 regular_d1 energy_d1;
    D8: residual_d8 linear_d8 load_d8 impedance_d8 regular_d8 energy_d8;
}

#[inline(always)]
fn residual<T: Part, S: Scalar>(part: &T, p: &[S], at: &At<S>, out: &mut Rows<S>, blocks: &mut Blocks<S>) {
    let p = T::Family::from_slice(p);
    match Part::physics(part) {
        Physics::Nonlinear => part.residual(&p, at, out),
        Physics::Linear | Physics::Frequency(_) => {
            blocks.reset(at.q.len(), at.z.len() - part.memory(), at.speed);
            part.linear(&p, at.speed, blocks);
            blocks.residual(at, out.force, out.rate);
            *out.spin += part.spin_row(&p, at);
        }
    }
}
