//! Every [`Part`] and every part with a [capability](super::capability) behind its object-safe face ([`erased`](super::erased)), and in lanes.

use super::blocks::Blocks;
use super::capability::scope::Tabulated;
use super::capability::time_form::{Fitted, Speeds, Untimed};
use super::capability::{
    self,
    frequency::{Domain, Frozen},
};
use super::context::{At, Energy, Layout, Observed, Physics, Rows, Uses, Validity};
use super::erased::*;
use super::field::Field;
use super::lanes::{Linear, LinearArgs, Residual, ResidualArgs};
use super::params::{Family as _, List, ParamSlot, Parametric};
use super::part::Part;
use crate::text::Text;
use laval_num::complex::Complex;
use laval_num::lanes::Apply;
use laval_num::scalar::Scalar;
use std::sync::Arc;

macro_rules! parts {
    ($( $scalar:ty: $residual:ident $linear:ident $load:ident $impedance:ident $regular:ident $energy:ident; )*) => {
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
            fn reach(&self) -> usize {
                self.extent().map_or(usize::MAX, |e| e.reach())
            }
            fn is_steady(&self) -> bool {
                self.extent().is_some_and(|e| e.is_steady())
            }
            fn memory(&self) -> usize {
                Part::memory(self)
            }
            fn slots(&self) -> Vec<ParamSlot> {
                T::Family::all_slots(self.row_counts())
            }
            fn lists(&self) -> Vec<List> {
                T::Family::lists()
            }
            fn fields(&self) -> &'static [Field] {
                T::FIELDS
            }
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>) {
                Part::observe(self, &self.given(p), at, out)
            }
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>) {
                Part::validity(self, &self.given(p), at, out)
            }
            fn check(&self, p: &[f64]) -> Vec<(&'static str, Text)> {
                Part::check(self, &self.given(p))
            }
            fn warnings(&self, p: &[f64]) -> Vec<Text> {
                Part::warnings(self, &self.given(p))
            }
            fn spin_row_f64(&self, p: &[f64], at: &At<f64>) -> f64 {
                Part::spin_row(self, &self.given(p), at)
            }
            fn prepared(&self, p: &[f64]) -> Option<Arc<dyn Erased>> {
                self.extent()?.prepared(p)
            }
            fn spin_row_d8(&self, p: &[D8], at: &At<D8>) -> D8 {
                Part::spin_row(self, &self.given(p), at)
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
            fn mesh(&self) -> Option<&dyn Mesh> {
                Part::mesh(self)
            }
            fn scope(&self) -> Option<&dyn Scope> {
                Part::scope(self)
            }
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>) {
                    residual(self, p, at, out, blocks)
                }
                fn $linear(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>) {
                    Part::linear(self, &self.given(p), speed, blocks)
                }
                fn $energy(&self, p: &[$scalar], at: &At<$scalar>) -> Option<Energy<$scalar>> {
                    Part::energy(self, &self.given(p), at)
                }
            )*
        }

        impl<T: capability::FrequencyDomain + Part> FrequencyDomain for T {
            fn domain(&self, p: &[f64], speed: f64) -> Option<Domain> {
                capability::FrequencyDomain::domain(self, &self.given(p), speed)
            }
            fn rough(&self) -> Option<Arc<dyn Erased>> {
                capability::FrequencyDomain::rough(self).map(|p| Arc::new(p) as Arc<dyn Erased>)
            }
            fn approximation(&self, p: &[f64]) -> Option<(Arc<dyn Erased>, Vec<f64>)> {
                let (part, p) = capability::FrequencyDomain::approximation(self, &self.given(p))?;
                Some((Arc::new(part), <T as Parametric>::Family::to_vec(&p)))
            }
            fn frequencies(&self) -> Option<Tabulated> {
                capability::FrequencyDomain::frequencies(self)
            }
            fn frozen(&self, at: Frozen) -> Option<Arc<dyn Erased>> {
                capability::FrequencyDomain::frozen(self, at).map(|p| Arc::new(p) as Arc<dyn Erased>)
            }
            $(
                fn $load(&self, p: &[$scalar], speed: $scalar, blocks: &mut Blocks<$scalar>) {
                    capability::FrequencyDomain::load(self, &self.given(p), speed, blocks)
                }
                fn $impedance(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar, out: &mut [Complex<$scalar>]) {
                    capability::FrequencyDomain::impedance(self, &self.given(p), s, speed, out)
                }
                fn $regular(&self, p: &[$scalar], s: Complex<$scalar>, speed: $scalar) -> Complex<$scalar> {
                    capability::FrequencyDomain::regular(self, &self.given(p), s, speed)
                }
            )*
        }
    };
}

with_scalars!(parts);

impl<T: capability::ReplacedInTime + Part> ReplacedInTime for T {
    fn timed(&self, p: &[f64], speeds: Speeds, stop: &dyn Fn() -> bool) -> Option<Result<Arc<dyn Erased>, Untimed>> {
        let part = capability::ReplacedInTime::timed(self, &self.given(p), speeds, stop)?;
        Some(part.map(|p| Arc::new(p) as Arc<dyn Erased>))
    }
    fn fitted(&self) -> Option<Fitted> {
        capability::ReplacedInTime::fitted(self)
    }
}

impl<P: Part> Apply<P> for Residual {
    #[inline(always)]
    fn apply<S: Scalar>(part: &P, args: &mut ResidualArgs<'_, S>) {
        let p = part.given(args.p);
        part.residual(&p, &args.at, &mut args.out);
        if part.physics() != Physics::Nonlinear {
            *args.out.spin += part.spin_row(&p, &args.at);
        }
    }
}

impl<P: Part> Apply<P> for Linear {
    #[inline(always)]
    fn apply<S: Scalar>(part: &P, args: &mut LinearArgs<'_, S>) {
        part.linear(&part.given(args.p), args.speed, args.blocks);
    }
}

#[inline(always)]
fn residual<T: Part, S: Scalar>(part: &T, p: &[S], at: &At<S>, out: &mut Rows<S>, blocks: &mut Blocks<S>) {
    let p = part.given(p);
    match Part::physics(part) {
        Physics::Nonlinear => part.residual(&p, at, out),
        Physics::Linear | Physics::Frequency(_) => {
            blocks.reset_band(at.q.len(), at.z.len() - part.memory(), part.extent().map_or(usize::MAX, |e| e.reach()), at.speed);
            part.linear(&p, at.speed, blocks);
            blocks.residual(at, out.force, out.rate);
            *out.spin += part.spin_row(&p, at);
        }
    }
}
