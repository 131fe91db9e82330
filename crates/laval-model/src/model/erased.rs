//! Parts composed at run time: the object-safe face of [`Part`], one method slot per scalar, filled by one blanket implementation.

use super::blocks::Blocks;
use super::lanes::InLanes;
use super::params::{Family, ParamSlot};
use super::part::{At, Correction, Domain, Energy, Fitted, Layout, Observed, Outline, Part, Physics, Rows, Tabulated, Uses, Validity};
use super::system::Axis;
use super::timed::{Speeds, Untimed};
use laval_num::complex::Complex;
use laval_num::dual::Dual;
use laval_num::scalar::Scalar;
use std::sync::Arc;

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
            fn shape(&self, p: &[f64], position: f64) -> Vec<[f64; 4]>;
            fn refuses_rest(&self, p: &[f64]) -> Option<String>;
            fn clearance(&self, p: &[f64], at: &At<f64>) -> Option<f64>;
            fn switches(&self, p: &[f64], at: &At<f64>, out: &mut Vec<f64>);
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>);
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>);
            fn tabulated(&self) -> Option<Tabulated>;
            fn check(&self, p: &[f64]) -> Vec<(&'static str, String)>;
            fn refuses_axis(&self, p: &[f64], axis: Axis) -> Option<String>;
            fn lightens(&self, p: &[f64]) -> Option<String>;
            fn approximation(&self, p: &[f64]) -> Option<(Arc<dyn Erased>, Vec<f64>)>;
            fn warnings(&self, p: &[f64]) -> Vec<String>;
            fn drives(&self, p: &[f64], speed: f64) -> Option<f64>;
            fn lacks_spin_inertia(&self, p: &[f64]) -> Option<&'static str>;
            fn without_tilt(&self) -> Option<&'static str>;
            fn domain(&self, p: &[f64], speed: f64) -> Option<Domain>;
            fn rough(&self) -> Option<Arc<dyn Erased>>;
            fn places(&self, p: &[f64]) -> Vec<(usize, f64)>;
            fn timed(&self, p: &[f64], speeds: Speeds, stop: &dyn Fn() -> bool) -> Option<Result<Arc<dyn Erased>, Untimed>>;
            fn fitted(&self) -> Option<Fitted>;
            fn grip(&self, p: &[f64], at: &At<f64>, out: &mut Vec<(usize, f64)>);
            fn correction(&self, p: &[f64], at: &At<f64>) -> Option<Correction>;
            fn outlines(&self, p: &[f64], at: &At<f64>) -> Vec<Outline>;
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>);
                fn $linear(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>);
                fn $load(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>);
                fn $impedance(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar, out: &mut [Complex<$scalar>]);
                fn $regular(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar) -> Complex<$scalar>;
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
            fn shape(&self, p: &[f64], position: f64) -> Vec<[f64; 4]> {
                Part::shape(self, &T::Family::from_slice(p), position)
            }
            fn refuses_rest(&self, p: &[f64]) -> Option<String> {
                Part::refuses_rest(self, &T::Family::from_slice(p))
            }
            fn clearance(&self, p: &[f64], at: &At<f64>) -> Option<f64> {
                Part::clearance(self, &T::Family::from_slice(p), at)
            }
            fn switches(&self, p: &[f64], at: &At<f64>, out: &mut Vec<f64>) {
                Part::switches(self, &T::Family::from_slice(p), at, out)
            }
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>) {
                Part::observe(self, &T::Family::from_slice(p), at, out)
            }
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>) {
                Part::validity(self, &T::Family::from_slice(p), at, out)
            }
            fn tabulated(&self) -> Option<Tabulated> {
                Part::tabulated(self)
            }
            fn check(&self, p: &[f64]) -> Vec<(&'static str, String)> {
                Part::check(self, &T::Family::from_slice(p))
            }
            fn refuses_axis(&self, p: &[f64], axis: Axis) -> Option<String> {
                Part::refuses_axis(self, &T::Family::from_slice(p), axis)
            }
            fn approximation(&self, p: &[f64]) -> Option<(Arc<dyn Erased>, Vec<f64>)> {
                let (part, p) = Part::approximation(self, &T::Family::from_slice(p))?;
                Some((Arc::new(part), T::Family::to_vec(&p)))
            }
            fn lightens(&self, p: &[f64]) -> Option<String> {
                Part::lightens(self, &T::Family::from_slice(p))
            }
            fn warnings(&self, p: &[f64]) -> Vec<String> {
                Part::warnings(self, &T::Family::from_slice(p))
            }
            fn drives(&self, p: &[f64], speed: f64) -> Option<f64> {
                Part::drives(self, &T::Family::from_slice(p), speed)
            }
            fn lacks_spin_inertia(&self, p: &[f64]) -> Option<&'static str> {
                Part::lacks_spin_inertia(self, &T::Family::from_slice(p))
            }
            fn without_tilt(&self) -> Option<&'static str> {
                Part::without_tilt(self)
            }
            fn domain(&self, p: &[f64], speed: f64) -> Option<Domain> {
                Part::domain(self, &T::Family::from_slice(p), speed)
            }
            fn rough(&self) -> Option<Arc<dyn Erased>> {
                Part::rough(self).map(|p| Arc::new(p) as Arc<dyn Erased>)
            }
            fn places(&self, p: &[f64]) -> Vec<(usize, f64)> {
                Part::places(self, &T::Family::from_slice(p))
            }
            fn timed(&self, p: &[f64], speeds: Speeds, stop: &dyn Fn() -> bool) -> Option<Result<Arc<dyn Erased>, Untimed>> {
                Part::timed(self, &T::Family::from_slice(p), speeds, stop).map(|r| r.map(|p| Arc::new(p) as Arc<dyn Erased>))
            }
            fn fitted(&self) -> Option<Fitted> {
                Part::fitted(self)
            }
            fn grip(&self, p: &[f64], at: &At<f64>, out: &mut Vec<(usize, f64)>) {
                Part::grip(self, &T::Family::from_slice(p), at, out)
            }
            fn correction(&self, p: &[f64], at: &At<f64>) -> Option<Correction> {
                Part::correction(self, &T::Family::from_slice(p), at)
            }
            fn outlines(&self, p: &[f64], at: &At<f64>) -> Vec<Outline> {
                Part::outlines(self, &T::Family::from_slice(p), at)
            }
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>) {
                    residual(self, p, at, out, blocks)
                }
                fn $linear(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>) {
                    Part::linear(self, &T::Family::from_slice(p), speed, blocks)
                }
                fn $load(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>) {
                    Part::load(self, &T::Family::from_slice(p), speed, blocks)
                }
                fn $impedance(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar, out: &mut [Complex<$scalar>]) {
                    Part::impedance(self, &T::Family::from_slice(p), s, speed, out)
                }
                fn $regular(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar) -> Complex<$scalar> {
                    Part::regular(self, &T::Family::from_slice(p), s, speed)
                }
                fn $energy(&self, p: &[$scalar], at: &At<$scalar>) -> Option<Energy<$scalar>> {
                    Part::energy(self, &T::Family::from_slice(p), at)
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
                fn load(part: &dyn Erased, p: &[Self], speed: Self, blocks: &mut Blocks<Self>) {
                    part.$load(p, speed, blocks)
                }
                fn impedance(part: &dyn Erased, p: &[Self], s: Complex<Self>, speed: Self, out: &mut [Complex<Self>]) {
                    part.$impedance(p, s, speed, out)
                }
                fn regular(part: &dyn Erased, p: &[Self], s: Complex<Self>, speed: Self) -> Complex<Self> {
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
    /// [`Part::load`]; the caller has reset the blocks to the part's size, without states.
    fn load(part: &dyn Erased, p: &[Self], speed: Self, blocks: &mut Blocks<Self>);
    /// [`Part::impedance`].
    fn impedance(part: &dyn Erased, p: &[Self], s: Complex<Self>, speed: Self, out: &mut [Complex<Self>]);
    /// [`Part::regular`].
    fn regular(part: &dyn Erased, p: &[Self], s: Complex<Self>, speed: Self) -> Complex<Self>;
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
