//! Exact tangents of the residual by forward derivatives, part by part.

use super::blocks::Blocks;
use super::erased::{D8, Evaluate};
use super::part::{At, Rows};
use super::slot::{Slot, gather};
use super::system::{System, Workspace};
use laval_num::dense::Mat;
use laval_num::dual::Dual;
use laval_num::refill::refill;
use laval_num::scalar::Scalar;
use laval_num::work::spend;

/// A matrix that is added to entry by entry.
pub trait Entries: Default {
    /// Zeros of this size.
    fn reset(&mut self, rows: usize, cols: usize);
    /// Adds to an entry.
    fn add(&mut self, i: usize, j: usize, x: f64);
}

impl Entries for Mat {
    fn reset(&mut self, rows: usize, cols: usize) {
        Mat::reset(self, rows, cols);
    }
    #[inline]
    fn add(&mut self, i: usize, j: usize, x: f64) {
        self[(i, j)] += x;
    }
}

/// What is added, with its row and column.
#[derive(Clone, Debug, Default)]
pub struct Triplets(pub Vec<(usize, usize, f64)>);

impl Entries for Triplets {
    fn reset(&mut self, _: usize, _: usize) {
        self.0.clear();
    }
    fn add(&mut self, i: usize, j: usize, x: f64) {
        self.0.push((i, j, x));
    }
}

/// Residual and its tangents at one point. With `spin`, the spin angle is coordinate `n` and the spin row is row `n`.
#[derive(Clone, Debug, Default)]
pub struct TangentOf<M> {
    /// Residual of the rows.
    pub force: Vec<f64>,
    /// Rates of internal states.
    pub rate: Vec<f64>,
    /// d force / d q.
    pub q: M,
    /// d force / d v.
    pub v: M,
    /// d force / d a: the mass matrix.
    pub a: M,
    /// d force / d z.
    pub z: M,
    /// d rate / d q.
    pub rate_q: M,
    /// d rate / d v.
    pub rate_v: M,
    /// d rate / d a.
    pub rate_a: M,
    /// d rate / d z.
    pub rate_z: M,
}

/// In full matrices.
pub type Tangent = TangentOf<Mat>;
/// In lists of what is added to their entries.
pub type SparseTangent = TangentOf<Triplets>;

impl<M: Entries> TangentOf<M> {
    fn reset(&mut self, n: usize, m: usize) {
        refill(&mut self.force, n, 0.0);
        refill(&mut self.rate, m, 0.0);
        for x in [&mut self.q, &mut self.v, &mut self.a] {
            x.reset(n, n);
        }
        self.z.reset(n, m);
        for x in [&mut self.rate_q, &mut self.rate_v, &mut self.rate_a] {
            x.reset(m, n);
        }
        self.rate_z.reset(m, m);
    }
}

/// Scratch for tangents.
#[derive(Default)]
pub struct TangentScratch {
    plain: Workspace<f64>,
    local: [Vec<f64>; 3],
    seeded: [Vec<D8>; 4],
    params: Vec<D8>,
    force: Vec<D8>,
    rate: Vec<D8>,
    blocks8: Blocks<D8>,
    blocks: Blocks<f64>,
    seeds: Vec<Seed>,
}

#[derive(Clone, Copy, PartialEq)]
enum Group {
    Q,
    V,
    A,
    Z,
}

/// One direction of differentiation: a local variable, or (index `None`) the spin angle and its rates.
#[derive(Clone, Copy)]
struct Seed(Group, Option<usize>);

impl System {
    /// Residual and tangents of the parts `which` admits at a global point; with `spin` also over the spin angle, speed and acceleration.
    pub fn tangent<M: Entries>(
        &self,
        at: &At<f64>,
        spin: bool,
        out: &mut TangentOf<M>,
        scratch: &mut TangentScratch,
        which: impl Fn(&Slot) -> bool,
    ) {
        let rows = self.n() + usize::from(spin);
        out.reset(rows, self.m());
        let mut spin_row = 0.0;
        {
            let (force, rate) = (&mut out.force[..self.n()], &mut out.rate[..]);
            let mut r = Rows { force, rate, spin: &mut spin_row };
            self.residual(self.params(), at, &mut r, &mut scratch.plain, &which);
        }
        if spin {
            out.force[self.n()] = spin_row;
        }
        for slot in self.slots().iter().filter(|s| which(s)) {
            self.slot_tangent(slot, at, spin, out, scratch);
        }
    }

    fn slot_tangent<M: Entries>(&self, slot: &Slot, at: &At<f64>, spin: bool, out: &mut TangentOf<M>, w: &mut TangentScratch) {
        for (x, local) in [at.q, at.v, at.a].iter().zip(&mut w.local) {
            gather(&slot.map, x, local);
        }
        for (a, &g) in w.local[2].iter_mut().zip(&slot.weight) {
            *a += g;
        }
        let (n, m) = (slot.map.len(), slot.states.len());
        // residuals in eight directions at once
        spend((9 * (2 + (3 * n + m) / 8) * (20 + 10 * n)) as u64);
        let p = slot.params.clone();
        w.seeds.clear();
        if slot.is_linear() {
            let speed = slot.speed(self.params(), at.speed);
            w.blocks.reset_band(n, m - slot.memory, slot.reach, speed);
            slot.part.linear_f64(&self.params()[p.clone()], speed, &mut w.blocks);
            self.add_block_tangent(slot, slot.speed(self.params(), at.spin_accel), &w.blocks, out);
            if spin {
                // the spin row of a linear part may depend on everything
                for g in [Group::Q, Group::V, Group::A] {
                    w.seeds.extend((0..n).map(|i| Seed(g, Some(i))));
                }
                w.seeds.extend((0..m).map(|i| Seed(Group::Z, Some(i))));
            }
        } else {
            w.seeds.extend((0..n).map(|i| Seed(Group::Q, Some(i))));
            if slot.uses.velocity {
                w.seeds.extend((0..n).map(|i| Seed(Group::V, Some(i))));
            }
            if slot.uses.acceleration {
                w.seeds.extend((0..n).map(|i| Seed(Group::A, Some(i))));
            }
            w.seeds.extend((0..m).map(|i| Seed(Group::Z, Some(i))));
        }
        if spin {
            w.seeds.extend([Seed(Group::Q, None), Seed(Group::V, None), Seed(Group::A, None)]);
        }
        w.params.clear();
        w.params.extend(self.params()[p].iter().map(|&x| D8::lift(x)));
        let seeds = std::mem::take(&mut w.seeds);
        for chunk in seeds.chunks(8) {
            self.seeded(slot, at, chunk, out, w, spin);
        }
        w.seeds = seeds;
    }

    fn seeded<M: Entries>(&self, slot: &Slot, at: &At<f64>, chunk: &[Seed], out: &mut TangentOf<M>, w: &mut TangentScratch, spin: bool) {
        let z = &at.z[slot.states.clone()];
        for (x, s) in w.local.iter().map(Vec::as_slice).chain([z]).zip(&mut w.seeded) {
            s.clear();
            s.extend(x.iter().map(|&x| D8::lift(x)));
        }
        let mut spin_vars = [D8::lift(at.phase), D8::lift(at.speed), D8::lift(at.spin_accel)];
        for (k, &Seed(group, index)) in chunk.iter().enumerate() {
            match index {
                Some(i) => w.seeded[group as usize][i].eps[k] = 1.0,
                None => spin_vars[group as usize].eps[k] = 1.0,
            }
        }
        let (n, m) = (slot.map.len(), slot.states.len());
        refill(&mut w.force, n, Dual::lift(0.0));
        refill(&mut w.rate, m, Dual::lift(0.0));
        let mut spin_row = D8::lift(0.0);
        let [q, v, a, z] = &w.seeded;
        let [phase, speed, spin_accel] = spin_vars;
        let mut local = At { q, v, a, z, phase, speed, spin_accel, t: D8::lift(at.t) };
        let ratio = slot.ratio.map(|r| r.value(self.params()));
        if let Some(r) = ratio {
            let by = |x: D8| Scalar::scale(x, r);
            (local.phase, local.speed, local.spin_accel) = (by(phase), by(speed), by(spin_accel));
        }
        let mut rows = Rows { force: &mut w.force, rate: &mut w.rate, spin: &mut spin_row };
        D8::residual(&*slot.part, &w.params, &local, &mut rows, &mut w.blocks8);
        if let Some(r) = ratio {
            spin_row = Scalar::scale(spin_row, r);
        }
        let spin_index = self.n();
        for (k, &Seed(group, index)) in chunk.iter().enumerate() {
            let linear_known = slot.is_linear() && index.is_some();
            let (force_d, rate_d) = match group {
                Group::Q => (&mut out.q, &mut out.rate_q),
                Group::V => (&mut out.v, &mut out.rate_v),
                Group::A => (&mut out.a, &mut out.rate_a),
                Group::Z => (&mut out.z, &mut out.rate_z),
            };
            let single;
            let columns: &[(usize, f64)] = match (group, index) {
                (Group::Z, Some(i)) => {
                    single = [(slot.states.start + i, 1.0)];
                    &single
                }
                (_, Some(i)) => &slot.map[i],
                (_, None) => {
                    single = [(spin_index, 1.0)];
                    &single
                }
            };
            for &(col, cj) in columns {
                if !linear_known {
                    for (row, f) in slot.map.iter().zip(&w.force) {
                        for &(gi, ci) in row {
                            force_d.add(gi, col, ci * cj * f.eps[k]);
                        }
                    }
                    for (i, r) in w.rate.iter().enumerate() {
                        rate_d.add(slot.states.start + i, col, cj * r.eps[k]);
                    }
                }
                if spin {
                    force_d.add(spin_index, col, cj * spin_row.eps[k]);
                }
            }
        }
    }

    fn add_block_tangent<M: Entries>(&self, slot: &Slot, spin_accel: f64, b: &Blocks<f64>, out: &mut TangentOf<M>) {
        let m = b.state.rows();
        let z0 = slot.states.start;
        for (i, rows) in slot.map.iter().enumerate() {
            for j in b.mass.columns(i) {
                let cols = &slot.map[j];
                let d = b.damping[(i, j)] + b.speed * b.gyroscopic[(i, j)];
                let k = b.stiffness[(i, j)] + b.speed * b.circulatory[(i, j)] + spin_accel * b.spin_accel_stiffness[(i, j)];
                for &(gi, ci) in rows {
                    for &(gj, cj) in cols {
                        out.a.add(gi, gj, ci * cj * b.mass[(i, j)]);
                        out.v.add(gi, gj, ci * cj * d);
                        out.q.add(gi, gj, ci * cj * k);
                    }
                }
            }
            for &(g, c) in rows {
                for j in 0..m {
                    out.z.add(g, z0 + j, c * (b.state_force[(i, j)] + spin_accel * b.spin_accel_state_force[(i, j)]));
                    out.rate_q.add(z0 + j, g, c * b.state_q[(j, i)]);
                    out.rate_v.add(z0 + j, g, c * b.state_v[(j, i)]);
                    out.rate_a.add(z0 + j, g, c * b.state_a[(j, i)]);
                }
            }
        }
        for i in 0..m {
            for j in 0..m {
                out.rate_z.add(z0 + i, z0 + j, b.state[(i, j)]);
            }
        }
        for (k, mem) in b.memory.iter().enumerate() {
            let row = z0 + m + k;
            for &(g, c) in &slot.map[mem.input] {
                out.rate_q.add(row, g, c);
            }
            for &(g, c) in &slot.map[mem.output] {
                out.z.add(g, row, c * mem.gain);
            }
            out.rate_z.add(row, row, -mem.rate);
            match mem.axes {
                super::blocks::Axes::Fixed => {}
                super::blocks::Axes::RotorX => out.rate_z.add(row, row + 1, -b.speed),
                super::blocks::Axes::RotorY => out.rate_z.add(row, row - 1, b.speed),
            }
        }
    }
}
