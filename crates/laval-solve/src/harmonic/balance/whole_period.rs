//! A motion with a symmetry as one of the whole period without it.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::motion::Motion;
use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::balance::terms::Terms;
use crate::model::system::System;
use crate::symmetry::Symmetry;

/// A balance that holds the whole period without symmetry, and a motion in its terms.
pub(in crate::harmonic) fn whole_period<'a>(
    system: &'a System,
    d: Discretisation,
    x: &[f64],
    speed: f64,
) -> Result<(Balance<'a>, Vec<f64>), Diagnostic> {
    let balance = Balance::new(system, whole(d), (speed, speed), None)?;
    let carried = carried(d, x, &balance);
    Ok((balance, carried))
}

/// The same to sample the nonlinear parts with, which no part without a response at some order hinders.
pub(in crate::harmonic) fn sampled_period<'a>(system: &'a System, d: Discretisation, x: &[f64], speed: f64) -> (Balance<'a>, Vec<f64>) {
    let balance = Balance::sampler(system, whole(d), speed);
    let carried = carried(d, x, &balance);
    (balance, carried)
}

fn whole(d: Discretisation) -> Discretisation {
    // of a circular motion the law is constant: a few orders hold it
    let harmonics = if d.symmetry == Symmetry::Circular { 3 * d.divisor } else { d.harmonics };
    Discretisation { symmetry: Symmetry::None, harmonics, samples: d.samples.max(Terms::samples(harmonics, d.divisor)), ..d }
}

fn carried(d: Discretisation, x: &[f64], balance: &Balance) -> Vec<f64> {
    let terms = Terms::new(&balance.nonlinear.kinds, d.symmetry, d.harmonics, d.divisor, d.samples);
    Motion { terms: &terms, x }.carried(&balance.terms)
}
