//! What single parts of a machine at rest do: forces of their springs, their weight, their mass.

use crate::model::blocks::Blocks;
use crate::model::part::{At, Physics, Rows};
use crate::model::slot::{Slot, gather};
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::dense::Field;

/// Force rows of a part over its local coordinates; the part pulls its points by the opposite.
#[derive(Clone, Debug, Default)]
pub struct Share {
    /// Of springs and constant forces.
    pub elastic: Vec<f64>,
    /// Of the mass in the field of gravity.
    pub weight: Vec<f64>,
}

pub(crate) fn blocks(system: &System, slot: &Slot, speed: f64) -> Blocks<f64> {
    system.blocks(slot, speed).unwrap_or_else(|| {
        let (mut b, speed) = (Blocks::default(), slot.speed(system.params(), speed));
        b.reset(slot.map.len(), 0, speed);
        if let Some(part) = slot.part.frequency_domain() {
            part.load_f64(&system.params()[slot.params.clone()], speed, &mut b);
        }
        b
    })
}

/// Impedance of a part given in the frequency domain in a rotor at rest, row by row; nothing where it has none, as a liquid that does not turn.
fn impedance(system: &System, slot: &Slot) -> Vec<f64> {
    let n = slot.map.len();
    let mut out = vec![C64::ZERO; n * n];
    if let Some(part) = slot.part.frequency_domain() {
        part.impedance_f64(&system.params()[slot.params.clone()], C64::ZERO, 0.0, &mut out);
    }
    if out.iter().all(|z| z.is_finite()) { out.iter().map(|z| z.re).collect() } else { vec![0.0; n * n] }
}

/// Calls `f` with what memory and impedances add to the static stiffness over the coordinates.
pub(super) fn each_beside(system: &System, slot: &Slot, speed: f64, f: impl FnMut(usize, usize, f64)) {
    let n = slot.map.len();
    let mut local = vec![0.0; n * n];
    match slot.physics {
        Physics::Frequency(_) => local = impedance(system, slot),
        _ if slot.memory > 0 => blocks(system, slot, speed).memory.iter().for_each(|m| local[m.output * n + m.input] += m.gain / m.rate),
        _ => return,
    }
    spread(slot, &local, f);
}

fn spread(slot: &Slot, local: &[f64], mut f: impl FnMut(usize, usize, f64)) {
    for (i, rows) in slot.map.iter().enumerate() {
        for (j, cols) in slot.map.iter().enumerate() {
            let k = local[i * slot.map.len() + j];
            if k != 0.0 {
                rows.iter().for_each(|&(gi, a)| cols.iter().for_each(|&(gj, b)| f(gi, gj, a * k * b)));
            }
        }
    }
}

/// Calls `f` with every entry of the static stiffness of a linear part over the coordinates, its states left out.
pub(super) fn each_stiffness(system: &System, slot: &Slot, speed: f64, f: impl FnMut(usize, usize, f64)) {
    spread(slot, &stiffness(system, slot, speed), f);
}

/// Calls `f` with every derivative of a rate of an internal state that is no memory of a linear part: state, coordinate, value.
pub(super) fn each_rate(system: &System, slot: &Slot, speed: f64, mut f: impl FnMut(usize, usize, f64)) {
    if !matches!(slot.physics, Physics::Linear) {
        return;
    }
    let own = slot.states.start..slot.states.end - slot.memory;
    let b = blocks(system, slot, speed);
    for (k, state) in own.enumerate() {
        for (j, row) in slot.map.iter().enumerate() {
            let x = b.state_q[(k, j)];
            row.iter().filter(|_| x != 0.0).for_each(|&(g, a)| f(state, g, a * x));
        }
    }
}

/// Static stiffness of a linear part over its local coordinates, row by row.
pub(super) fn stiffness(system: &System, slot: &Slot, speed: f64) -> Vec<f64> {
    let n = slot.map.len();
    if matches!(slot.physics, Physics::Frequency(_)) {
        return impedance(system, slot);
    }
    let b = blocks(system, slot, speed);
    let mut out = vec![0.0; n * n];
    for i in 0..n {
        b.stiffness.columns(i).for_each(|j| out[i * n + j] = b.stiffness[(i, j)]);
    }
    b.memory.iter().for_each(|m| out[m.output * n + m.input] += m.gain / m.rate);
    out
}

/// What the field of gravity adds to local accelerations; nothing across a vertical axis.
fn field(slot: &Slot, n: usize) -> Vec<f64> {
    if slot.weight.len() == n { slot.weight.clone() } else { vec![0.0; n] }
}

/// The force rows of a part at rest.
pub fn share(system: &System, slot: &Slot, speed: f64, q: &[f64], z: &[f64]) -> Share {
    let mut local = Vec::new();
    gather(&slot.map, q, &mut local);
    let n = local.len();
    let field = field(slot, n);
    if !slot.is_linear() {
        let still = residual(system, slot, speed, [&local, &vec![0.0; n], &vec![0.0; n]], &z[slot.states.clone()]);
        let all = residual(system, slot, speed, [&local, &vec![0.0; n], &field], &z[slot.states.clone()]);
        let weight = all.iter().zip(&still).map(|(a, b)| a - b).collect();
        return Share { elastic: still, weight };
    }
    let b = blocks(system, slot, speed);
    let linear = matches!(slot.physics, Physics::Linear);
    let k = if linear { Vec::new() } else { impedance(system, slot) };
    let mut out = Share { elastic: vec![0.0; n], weight: vec![0.0; n] };
    for i in 0..n {
        out.elastic[i] = -b.force[i];
        if linear {
            out.elastic[i] += b.stiffness.columns(i).map(|j| b.stiffness[(i, j)] * local[j]).sum::<f64>();
            let own = slot.states.start..slot.states.end - slot.memory;
            out.elastic[i] += own.enumerate().map(|(k, s)| b.state_force[(i, k)] * z[s]).sum::<f64>();
        } else {
            out.elastic[i] += (0..n).map(|j| k[i * n + j] * local[j]).sum::<f64>();
        }
        out.weight[i] = b.mass.columns(i).map(|j| b.mass[(i, j)] * field[j]).sum();
    }
    b.memory.iter().for_each(|m| out.elastic[m.output] += m.gain / m.rate * local[m.input]);
    out
}

/// Residual of a nonlinear part at local coordinates, rates and accelerations.
fn residual(system: &System, slot: &Slot, speed: f64, [q, v, a]: [&[f64]; 3], z: &[f64]) -> Vec<f64> {
    let (mut force, mut rate, mut spin) = (vec![0.0; q.len()], vec![0.0; z.len()], 0.0);
    let at = slot.turned(system.params(), At { q, v, a, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 });
    let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
    slot.part.residual_f64(&system.params()[slot.params.clone()], &at, &mut rows, &mut Blocks::default());
    force
}

/// `(M x, G x)` of a part at rest over its local coordinates.
pub(super) fn inertia(system: &System, slot: &Slot, q: &[f64], z: &[f64], x: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let n = x.len();
    if slot.is_linear() {
        let b = blocks(system, slot, 1.0);
        let rows = |grid: &crate::model::blocks::Grid<f64>| (0..n).map(|i| grid.columns(i).map(|j| grid[(i, j)] * x[j]).sum()).collect();
        return (rows(&b.mass), rows(&b.gyroscopic));
    }
    let (mut local, zero) = (Vec::new(), vec![0.0; n]);
    gather(&slot.map, q, &mut local);
    let of = |speed: f64, v: &[f64], a: &[f64]| residual(system, slot, speed, [&local, v, a], &z[slot.states.clone()]);
    let less = |a: Vec<f64>, b: Vec<f64>| -> Vec<f64> { a.iter().zip(&b).map(|(a, b)| a - b).collect() };
    let mass = less(of(0.0, &zero, x), of(0.0, &zero, &zero));
    // odd in the rates, and in the speed
    let back: Vec<f64> = x.iter().map(|x| -x).collect();
    let odd = |speed: f64| less(of(speed, x, &zero), of(speed, &back, &zero));
    let turning = less(odd(1.0), odd(-1.0)).iter().map(|f| 0.25 * f).collect();
    (mass, turning)
}
