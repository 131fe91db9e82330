//! What a balance is scaled and its steps are measured by: resonances of the machine at rest, stiffnesses of the size of those of the nonlinear parts.

use crate::characteristic::{Characteristic, Equilibrium, Frame, is_polynomial};
use crate::harmonic::balance::coordinates::Nonlinear;
use crate::harmonic::balance::first_order::{MOST_STATES, first_order};
use crate::large;
use crate::model::part::{At, DofKind};
use crate::model::system::{Slot, System};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::orders::Orders;
use crate::rest::rest;
use laval_num::complex::C64;

/// Where the spin speed meets a frequency of the machine linearised at rest: continuation must not step over these.
pub(super) fn resonances(system: &System, (lo, hi): (f64, f64)) -> Vec<(f64, f64)> {
    let (n, m) = (system.n(), system.m());
    let (q, z) = (vec![0.0; n], vec![0.0; m]);
    let (mut tangent, mut scratch) = (Tangent::default(), TangentScratch::default());
    let mut found: Vec<(f64, f64)> = Vec::new();
    let points = 12;
    let spacing = (hi - lo) / points as f64;
    for i in 0..points {
        let speed = lo + spacing * (i as f64 + 0.5);
        let mut keep = |z: C64| {
            // trusted only near the speed it was computed at; the synchronous wave of a liquid is no resonance of the unbalance
            let (centre, half_width) = (z.im.abs(), z.re.abs().max(1e-4 * z.im.abs()));
            if (centre - speed.abs()).abs() <= spacing && !found.iter().any(|f| (f.0 - centre).abs() <= 0.5 * half_width) {
                found.push((centre, half_width));
            }
        };
        if 2 * n + m > MOST_STATES {
            let mut t = Characteristic::new(system, &Equilibrium::zero(system, Frame::Fixed, speed));
            let near = large::near(&t, speed.abs());
            near.into_iter()
                .filter_map(|s| if is_polynomial(system) { Some(s) } else { Some(t.polish(s, None)?.value) })
                .for_each(&mut keep);
            continue;
        }
        let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        system.tangent(&at, false, &mut tangent, &mut scratch, |_| true);
        let of_states = first_order(&tangent).or_else(|| Orders::of(system, false, &[speed], speed.abs()).ok()??.over_states(&tangent));
        let Some(values) = of_states.and_then(|a| laval_num::eig::eigenvalues(&a).ok()) else {
            continue;
        };
        values.into_iter().for_each(keep);
    }
    found
}

/// Stiffnesses of the size of the nonlinear parts' on each nonlinear coordinate, for [`Condenser`](super::condense::Condenser); the same for all of one kind.
/// At the rest of a machine under load: a small displacement from anywhere else may be one through the clearance of a film. Without load, or of parts that are
/// free at rest, at a small displacement from the middle.
pub(super) fn reference_stiffness(system: &System, nonlinear: &Nonlinear, speed: f64) -> Vec<f64> {
    let small = system.coordinates().iter().enumerate().map(|(i, c)| c.dof.typical * if i % 2 == 0 { 0.1 } else { 0.07 });
    let displaced = (small.collect(), vec![0.0; system.m()]);
    let own = |s: &Slot| !s.is_linear();
    let at_rest =
        system.is_loaded().then(|| rest(system, speed).ok()).flatten().map(|e| largest(system, nonlinear, (&(e.q, e.z), speed), &own, 0.0));
    let by_displacement = largest(system, nonlinear, (&displaced, speed), &own, 0.0);
    // of the whole machine without its mass where that is anything: K loses the digits by which the reference exceeds it, all of them at a resonance far below
    let [without_mass, with_mass] = [0.0, 1.0].map(|inertia| largest(system, nonlinear, (&displaced, speed), &|_| true, inertia));
    let sizes = || at_rest.iter().chain([&by_displacement, &without_mass, &with_mass]);
    let first = |class: usize| sizes().map(|size| size[class]).find(|k| *k > 0.0);
    let lateral = first(0);
    nonlinear.kinds.iter().take(nonlinear.basis.rows.len()).map(|&kind| first(kind.class()).or(lateral).unwrap_or(1.0)).collect()
}

/// By kind of coordinate the largest tangent stiffness (with so much of the mass times the square of the speed) of some parts at coordinates and states; of what a
/// row combines, the softest: `K_gg / B_g^2`.
fn largest(
    system: &System,
    nonlinear: &Nonlinear,
    ((q, z), speed): (&(Vec<f64>, Vec<f64>), f64),
    which: &dyn Fn(&Slot) -> bool,
    inertia: f64,
) -> [f64; DofKind::CLASSES] {
    let (mut tangent, mut scratch) = (Tangent::default(), TangentScratch::default());
    let v = vec![0.0; system.n()];
    let at = At { q, v: &v, a: &v, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    system.tangent(&at, false, &mut tangent, &mut scratch, which);
    let mut size = [0.0f64; DofKind::CLASSES];
    for (row, &kind) in nonlinear.basis.rows.iter().zip(&nonlinear.kinds) {
        let of = |&(g, b): &(usize, f64)| (tangent.q[(g, g)].abs() + inertia * speed * speed * tangent.a[(g, g)].abs()) / (b * b);
        let softest = row.iter().map(of).filter(|k| k.is_finite() && *k > 0.0).fold(f64::INFINITY, f64::min);
        if softest.is_finite() {
            size[kind.class()] = size[kind.class()].max(softest);
        }
    }
    size
}
