//! Whether the machine holds its position at rest: real positive roots at standstill are a static instability (divergence), for instance a buckled shaft.

use super::{Known, SECOND, limited, within};
use crate::model::part::{At, Physics};
use crate::model::system::System;
use crate::model::tangent::{SparseTangent, TangentScratch};
use crate::solve::characteristic::Equilibrium;
use crate::solve::large::{divergence, is_large};
use crate::solve::pencil::MachineMode;
use crate::solve::rest::rest;
use crate::study::Context;
use crate::study::linear::modes::{Modes, ModesResult};
use crate::study::linear::over_frequency::over_frequency;
use crate::study::linear::whirl::aperiodic;
use crate::study::shared::support::{About, growth_error, growth_rounding};
use laval_num::complex::C64;

/// Share of the stiffness of all parts in the shape below which that of one part is rounding.
const SMALL: f64 = 1e-6;

/// How the machine diverges at rest.
pub(super) struct Buckling {
    /// Largest growth rate without oscillation, 1/s.
    pub growth: f64,
    /// Parts whose stiffness is negative in the shape that grows.
    pub parts: Vec<String>,
}

/// The mode that grows most without oscillation, by more than its error and this threshold.
pub(super) fn diverging(result: &ModesResult, threshold: f64) -> Option<&MachineMode> {
    let rounding = growth_rounding(&result.spectrum);
    let grows = |m: &&MachineMode| aperiodic(m.value) && m.growth() > threshold + growth_error(m, rounding);
    result.spectrum.modes.iter().filter(grows).max_by(|a, b| a.growth().total_cmp(&b.growth()))
}

/// At rest; none where the machine holds its position, and where that is not known within a second.
pub(super) fn buckling(system: &System, context: &Context) -> Option<Buckling> {
    // of a large machine all modes would take too long
    if is_large(system) {
        // coefficients at rest may not be known
        if over_frequency(system) {
            return None;
        }
        let growth = || Ok(divergence(system, &rest(system, 0.0)?));
        let Known::Yes(Some(growth)) = limited(context, SECOND, growth) else { return None };
        return Some(Buckling { growth, parts: Vec::new() });
    }
    let study = Modes { speed: 0.0, about: About::Rest, threshold: 0.0, frequency: None };
    let Known::Yes(result) = within(&study, system, context) else { return None };
    let mode = diverging(&result, 0.0)?;
    Some(Buckling { growth: mode.growth(), parts: negative(system, &result.about, &mode.q) })
}

/// Parts whose stiffness is negative in a shape: twice their energy in it.
fn negative(system: &System, about: &Equilibrium, shape: &[C64]) -> Vec<String> {
    let largest = shape.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).filter(|z| z.abs() > 0.0);
    let Some(largest) = largest else { return Vec::new() };
    // the shape of a real root is real up to one factor
    let x: Vec<f64> = shape.iter().map(|z| (*z * largest.conj()).re / largest.norm_sqr()).collect();
    let rates = vec![0.0; system.n()];
    let at = At { q: &about.q, v: &rates, a: &rates, z: &about.z, phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut scratch) = (SparseTangent::default(), TangentScratch::default());
    let known = system.slots().iter().filter(|s| !matches!(s.physics, Physics::Frequency(_)));
    let stiffness: Vec<(&str, f64)> = known
        .map(|slot| {
            system.tangent(&at, false, &mut t, &mut scratch, |s| s.name == slot.name);
            (slot.name.as_str(), t.q.0.iter().map(|&(i, j, k)| x[i] * k * x[j]).sum())
        })
        .collect();
    let whole: f64 = stiffness.iter().map(|s| s.1.abs()).sum();
    stiffness.into_iter().filter(|s| s.1 < -SMALL * whole).map(|s| s.0.to_string()).collect()
}
