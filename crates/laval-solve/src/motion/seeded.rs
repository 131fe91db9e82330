//! Rows of one part at zero acceleration with their exact derivatives in the accelerations: the columns of the mass matrix.
//!
//! The blocks of a linear part hold these derivatives already; those of a nonlinear part, and of every part's share in the spin row, are seeded.

use super::direct::zeroed;
use crate::model::blocks::Blocks;
use crate::model::erased::{D8, Evaluate};
use crate::model::part::{At, Rows};
use crate::model::system::{Slot, System};
use laval_num::dense::Mat;
use laval_num::scalar::Scalar;
use std::ops::Range;

/// What the rows of all parts are added to. With a free spin the rows and columns of `mass`, and the entries of `force`, end with those of the spin.
pub(super) struct Targets<'t> {
    pub force: &'t mut [f64],
    pub rate: &'t mut [f64],
    pub mass: &'t mut Mat,
    pub rate_a: &'t mut Mat,
}

/// Scratch.
pub(super) struct Seeded {
    params: Vec<D8>,
    vars: [Vec<D8>; 4],
    local: [Vec<f64>; 3],
    seeded_force: Vec<D8>,
    seeded_rate: Vec<D8>,
    /// Of a nonlinear part, which fills none.
    unused: Blocks<D8>,
    force: Vec<f64>,
    rate: Vec<f64>,
    blocks: Blocks<f64>,
}

/// Place of the spin in rows and columns.
fn spin_row(system: &System) -> usize {
    system.n()
}

impl Seeded {
    pub fn new(system: &System) -> Self {
        Seeded {
            params: system.params().iter().map(|&x| D8::lift(x)).collect(),
            vars: Default::default(),
            local: Default::default(),
            seeded_force: Vec::new(),
            seeded_rate: Vec::new(),
            unused: Blocks::default(),
            force: Vec::new(),
            rate: Vec::new(),
            blocks: Blocks::default(),
        }
    }

    /// Adds a part's rows and their derivatives, those in the spin's acceleration too when it is `free`.
    pub fn add(&mut self, system: &System, slot: &Slot, at: &At<f64>, free: bool, out: &mut Targets) {
        // the part sees its own spin, also of derivatives in the spin's acceleration
        let at = &slot.turned(system.params(), *at);
        for (x, local) in [at.q, at.v, at.a].iter().zip(&mut self.local) {
            local.clear();
            local.extend(slot.map.iter().map(|row| row.iter().map(|&(g, c)| c * x[g]).sum::<f64>()));
        }
        for (a, &g) in self.local[2].iter_mut().zip(&slot.weight) {
            *a += g;
        }
        let z = &at.z[slot.states.clone()];
        for (x, vars) in self.local.iter().map(Vec::as_slice).chain([z]).zip(&mut self.vars) {
            vars.clear();
            vars.extend(x.iter().map(|&x| D8::lift(x)));
        }
        if slot.is_linear() {
            self.add_blocks(system, slot, at, free, out);
        }
        if free || !slot.is_linear() {
            self.add_seeded(system, slot, at, free, out);
        }
    }

    /// The rows of a linear part, but for its share in the spin row.
    fn add_blocks(&mut self, system: &System, slot: &Slot, at: &At<f64>, free: bool, out: &mut Targets) {
        let (n, states) = (slot.map.len(), slot.states.len() - slot.memory);
        let blocks = &mut self.blocks;
        blocks.reset_band(n, states, slot.reach, at.speed);
        f64::linear(&*slot.part, &system.params()[slot.params.clone()], at.speed, blocks);
        let [q, v, a] = &self.local;
        let local = At { q, v, a, z: &at.z[slot.states.clone()], ..*at };
        zeroed(&mut self.force, n);
        zeroed(&mut self.rate, slot.states.len());
        blocks.residual(&local, &mut self.force, &mut self.rate);
        for (row, f) in slot.map.iter().zip(&self.force) {
            for &(g, c) in row {
                out.force[g] += c * f;
            }
        }
        for (r, x) in out.rate[slot.states.clone()].iter_mut().zip(&self.rate) {
            *r += x;
        }
        let mut column = |col: usize, weight: f64, rows: Range<usize>, force: &dyn Fn(usize) -> f64, rate: &dyn Fn(usize) -> f64| {
            for i in rows {
                for &(g, c) in &slot.map[i] {
                    out.mass[(g, col)] += c * weight * force(i);
                }
            }
            for i in 0..states {
                out.rate_a[(slot.states.start + i, col)] += weight * rate(i);
            }
        };
        for (j, columns) in slot.map.iter().enumerate() {
            for &(col, weight) in columns {
                column(col, weight, blocks.mass.columns(j), &|i| blocks.mass[(i, j)], &|i| blocks.state_a[(i, j)]);
            }
        }
        if free {
            let turn @ (sin, cos) = at.phase.sin_cos();
            let rate = |i: usize| blocks.spin_accel_rate_cos[i] * cos + blocks.spin_accel_rate_sin[i] * sin;
            column(spin_row(system), slot.torque(system.params(), 1.0), 0..n, &|i| blocks.spin_accel_row(i, &local, turn), &rate);
        }
    }

    /// The rows of a nonlinear part, or the share of a linear one in the spin row.
    fn add_seeded(&mut self, system: &System, slot: &Slot, at: &At<f64>, free: bool, out: &mut Targets) {
        let (n, m) = (slot.map.len(), slot.states.len());
        let directions = n + usize::from(free);
        let spin_row = spin_row(system);
        let params = &self.params[slot.params.clone()];
        for start in (0..directions).step_by(8) {
            let end = directions.min(start + 8);
            let mut accel = D8::lift(at.spin_accel);
            for j in start..end {
                if j < n {
                    self.vars[2][j].eps[j - start] = 1.0;
                } else {
                    accel.eps[j - start] = slot.torque(system.params(), 1.0);
                }
            }
            let (force, rate) = (&mut self.seeded_force, &mut self.seeded_rate);
            force.clear();
            rate.clear();
            let mut spin = D8::lift(0.0);
            let [q, v, a, z] = &self.vars;
            let lift = D8::lift;
            let local = At { q, v, a, z, phase: lift(at.phase), speed: lift(at.speed), spin_accel: accel, t: lift(at.t) };
            if slot.is_linear() {
                spin = slot.part.spin_row_d8(params, &local);
            } else {
                force.resize(n, lift(0.0));
                rate.resize(m, lift(0.0));
                D8::residual(&*slot.part, params, &local, &mut Rows { force, rate, spin: &mut spin }, &mut self.unused);
            }
            spin = Scalar::scale(spin, slot.torque(system.params(), 1.0));
            if start == 0 {
                for (row, f) in slot.map.iter().zip(&self.seeded_force) {
                    for &(g, c) in row {
                        out.force[g] += c * f.re;
                    }
                }
                for (r, x) in out.rate[slot.states.clone()].iter_mut().zip(&self.seeded_rate) {
                    *r += x.re;
                }
                if free {
                    out.force[spin_row] += spin.re;
                }
            }
            for j in start..end {
                let k = j - start;
                let single = [(spin_row, 1.0)];
                let columns: &[(usize, f64)] = if j < n { &slot.map[j] } else { &single };
                for &(col, cj) in columns {
                    for (row, f) in slot.map.iter().zip(&self.seeded_force) {
                        for &(g, c) in row {
                            out.mass[(g, col)] += c * cj * f.eps[k];
                        }
                    }
                    for (i, r) in self.seeded_rate.iter().enumerate() {
                        out.rate_a[(slot.states.start + i, col)] += cj * r.eps[k];
                    }
                    if free {
                        out.mass[(spin_row, col)] += cj * spin.eps[k];
                    }
                }
                if j < n {
                    self.vars[2][j].eps[k] = 0.0;
                }
            }
        }
    }
}
