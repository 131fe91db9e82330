//! Nonlinear parts by alternating frequency and time: forces and exact tangents at the samples of a period.

use crate::harmonic::balance::pace::{Pace, Parameter};
use crate::harmonic::balance::terms::Terms;
use crate::model::blocks::Blocks;
use crate::model::erased::{D1, D8, Evaluate};
use crate::model::part::{At, Rows, Uses};
use crate::model::slot::{gather, scatter};
use crate::model::system::System;
use laval_num::dense::Mat;
use laval_num::refill::refill;
use laval_num::work::spend;
use std::ops::Range;

/// A nonlinear part seen from the balance: local coordinates over nonlinear ones, states among them.
#[derive(Clone, Debug)]
pub struct Member {
    /// Its slot.
    pub slot: usize,
    /// Local coordinates over the nonlinear coordinates.
    pub map: Vec<Vec<(usize, f64)>>,
    /// Index of its first state among the nonlinear coordinates; states follow the coordinates there.
    pub states: Range<usize>,
    /// What it reads.
    pub uses: Uses,
}

/// The instants rows are evaluated at: base phases, and what turns them into time.
struct Instants<'a> {
    m: usize,
    angles: &'a [f64],
    divisor: usize,
    pace: Pace,
}

impl Instants<'_> {
    /// Spin phase and time of instant `j`.
    fn time(&self, j: usize) -> (f64, f64) {
        let w = self.pace.frequency;
        (self.divisor as f64 * self.angles[j], if w == 0.0 { 0.0 } else { self.angles[j] / w })
    }
}

/// Samples of forces and their tangents over nonlinear coordinates `u` (states included: their row is `z' - rate`).
#[derive(Default)]
pub struct Sampled {
    u: [Vec<f64>; 3],
    /// Rows at the samples, (samples * m).
    pub rows: Vec<f64>,
    /// d rows / d parameter of the pace at the samples with the unknowns fixed.
    pub rows_speed: Vec<f64>,
    tangent: [Mat; 3],
    uses: [bool; 3],
    local: [Vec<f64>; 3],
    force: Vec<f64>,
    rate: Vec<f64>,
    blocks: Blocks<f64>,
    seeded: [Vec<D8>; 4],
    force8: Vec<D8>,
    rate8: Vec<D8>,
    params8: Vec<D8>,
    blocks8: Blocks<D8>,
    seeded1: [Vec<D1>; 4],
    force1: Vec<D1>,
    rate1: Vec<D1>,
    params1: Vec<D1>,
    blocks1: Blocks<D1>,
    product: Mat,
    seeds: Vec<(usize, usize)>,
}

impl Sampled {
    /// Coordinates, rates or accelerations at all samples (derivative 0, 1, 2), after [`Sampled::eval`].
    pub fn motion(&self, derivative: usize) -> &[f64] {
        &self.u[derivative]
    }

    /// Motion of unknowns `x` at a pace, rows and (with `tangents`) their tangents, of all `members` at all samples.
    pub fn eval(&mut self, system: &System, members: &[Member], terms: &Terms, x: &[f64], pace: Pace, tangents: bool) {
        let (m, samples) = (terms.coordinates, terms.samples);
        let w = pace.frequency;
        for (d, factor) in [1.0, w, w * w].into_iter().enumerate() {
            refill(&mut self.u[d], samples * m, 0.0);
            terms.synthesis[d].mul_vec_add(x, &mut self.u[d]);
            self.u[d].iter_mut().for_each(|v| *v *= factor);
        }
        self.evaluate(system, members, &Instants { m, angles: &terms.angles, divisor: terms.divisor, pace }, tangents);
    }

    /// The same at one instant, base phase `tau`, where the coordinates and their derivatives are `u`.
    #[allow(clippy::too_many_arguments)]
    pub fn eval_at(&mut self, system: &System, members: &[Member], terms: &Terms, tau: f64, u: [&[f64]; 3], pace: Pace, tangents: bool) {
        self.place(u);
        self.evaluate(system, members, &Instants { m: terms.coordinates, angles: &[tau], divisor: terms.divisor, pace }, tangents);
    }

    /// Rows and tangents at many instants, base phases `angles`, where the coordinates and their derivatives are `u`, instant after instant.
    #[allow(clippy::too_many_arguments)]
    pub fn eval_along(&mut self, system: &System, members: &[Member], terms: &Terms, angles: &[f64], u: [&[f64]; 3], pace: Pace) {
        self.place(u);
        self.evaluate(system, members, &Instants { m: terms.coordinates, angles, divisor: terms.divisor, pace }, true);
    }

    /// Values of the surfaces where a member's law changes, at one instant as in [`Sampled::eval_at`].
    #[allow(clippy::too_many_arguments)]
    pub fn switches_at(
        &mut self,
        system: &System,
        member: &Member,
        terms: &Terms,
        tau: f64,
        u: [&[f64]; 3],
        pace: Pace,
        out: &mut Vec<f64>,
    ) {
        self.place(u);
        let slot = &system.slots()[member.slot];
        self.gather(member, &slot.weight, 0..terms.coordinates);
        let (phase, t) = Instants { m: terms.coordinates, angles: &[tau], divisor: terms.divisor, pace }.time(0);
        let [q, v, a] = &self.local;
        let at = At { q, v, a, z: &self.u[0][member.states.clone()], phase, speed: pace.speed, spin_accel: 0.0, t };
        out.clear();
        if let Some(contacts) = slot.part.contacts() {
            contacts.switches(&system.params()[slot.params.clone()], &at, out);
        }
    }

    fn place(&mut self, u: [&[f64]; 3]) {
        for (own, u) in self.u.iter_mut().zip(u) {
            own.clear();
            own.extend_from_slice(u);
        }
    }

    fn evaluate(&mut self, system: &System, members: &[Member], instants: &Instants, tangents: bool) {
        let (m, samples) = (instants.m, instants.angles.len());
        spend((samples * members.iter().map(|p| if tangents { 500 } else { 50 } * (1 + p.map.len())).sum::<usize>()) as u64);
        if tangents {
            self.tangent.iter_mut().for_each(|t| t.reset(samples * m, m));
        }
        self.uses = [true, members.iter().any(|p| p.uses.velocity || !p.states.is_empty()), members.iter().any(|p| p.uses.acceleration)];
        refill(&mut self.rows, samples * m, 0.0);
        refill(&mut self.rows_speed, samples * m, 0.0);
        for member in members {
            if tangents {
                let slot = &system.slots()[member.slot];
                self.params8.clear();
                self.params8.extend(system.params()[slot.params.clone()].iter().map(|&p| D8::lift(p)));
                self.seeds.clear();
                let n = member.map.len();
                self.seeds.extend((0..n).map(|i| (0, i)));
                if member.uses.velocity {
                    self.seeds.extend((0..n).map(|i| (1, i)));
                }
                if member.uses.acceleration {
                    self.seeds.extend((0..n).map(|i| (2, i)));
                }
                self.seeds.extend((0..member.states.len()).map(|i| (3, i)));
            }
            for j in 0..samples {
                if tangents {
                    self.member(system, member, instants, j);
                } else {
                    self.member_value(system, member, instants, j);
                }
            }
        }
    }

    /// Local coordinates and their derivatives of a member at sample `j`.
    fn gather(&mut self, member: &Member, weight: &[f64], range: Range<usize>) {
        for (u, local) in self.u.iter().zip(&mut self.local) {
            gather(&member.map, &u[range.clone()], local);
        }
        for (a, &g) in self.local[2].iter_mut().zip(weight) {
            *a += g;
        }
    }

    fn member_value(&mut self, system: &System, member: &Member, instants: &Instants, j: usize) {
        let slot = &system.slots()[member.slot];
        let range = j * instants.m..(j + 1) * instants.m;
        let (phase, t) = instants.time(j);
        self.gather(member, &slot.weight, range.clone());
        let states = range.start + member.states.start..range.start + member.states.end;
        let (mut force, mut rate) = (std::mem::take(&mut self.force), std::mem::take(&mut self.rate));
        refill(&mut force, member.map.len(), 0.0);
        refill(&mut rate, states.len(), 0.0);
        let mut spin = 0.0;
        let [q, v, a] = &self.local;
        let at = At { q, v, a, z: &self.u[0][states.clone()], phase, speed: instants.pace.speed, spin_accel: 0.0, t };
        let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        f64::residual(&*slot.part, &system.params()[slot.params.clone()], &at, &mut out, &mut self.blocks);
        scatter(&member.map, &force, &mut self.rows[range]);
        for ((row, d), r) in states.clone().zip(&self.u[1][states]).zip(&rate) {
            self.rows[row] += d - r;
        }
        (self.force, self.rate) = (force, rate);
    }

    fn member(&mut self, system: &System, member: &Member, instants: &Instants, j: usize) {
        let slot = &system.slots()[member.slot];
        let &Instants { m, pace, .. } = instants;
        let range = j * m..(j + 1) * m;
        let (phase, t) = instants.time(j);
        self.gather(member, &slot.weight, range.clone());
        let (n, states) = (member.map.len(), member.states.clone());
        let z = &self.u[0][range.start + states.start..range.start + states.end];
        let zdot = &self.u[1][range.start + states.start..range.start + states.end];
        let seeds = std::mem::take(&mut self.seeds);
        for (pass, chunk) in seeds.chunks(8).enumerate() {
            for (x, s) in self.local.iter().map(Vec::as_slice).chain([z]).zip(&mut self.seeded) {
                s.clear();
                s.extend(x.iter().map(|&x| D8::lift(x)));
            }
            for (k, &(group, i)) in chunk.iter().enumerate() {
                if let Some(s) = self.seeded[group].get_mut(i) {
                    s.eps[k] = 1.0;
                }
            }
            refill(&mut self.force8, n, D8::lift(0.0));
            refill(&mut self.rate8, z.len(), D8::lift(0.0));
            let mut spin = D8::lift(0.0);
            let [q, v, a, zs] = &self.seeded;
            let lift = D8::lift;
            let at = At { q, v, a, z: zs, phase: lift(phase), speed: lift(pace.speed), spin_accel: lift(0.0), t: lift(t) };
            let mut out = Rows { force: &mut self.force8, rate: &mut self.rate8, spin: &mut spin };
            D8::residual(&*slot.part, &self.params8, &at, &mut out, &mut self.blocks8);
            if pass == 0 {
                for (row, f) in member.map.iter().zip(&self.force8) {
                    for &(i, c) in row {
                        self.rows[range.start + i] += c * f.re;
                    }
                }
                for (i, (r, d)) in self.rate8.iter().zip(zdot).enumerate() {
                    self.rows[range.start + states.start + i] += d - r.re;
                }
            }
            for (k, &(group, index)) in chunk.iter().enumerate() {
                let own = [(states.start + index, 1.0)];
                let (columns, derivative) = if group == 3 { (&own[..], 0) } else { (&member.map[index][..], group) };
                let tangent = &mut self.tangent[derivative];
                for &(col, cj) in columns {
                    for (row, f) in member.map.iter().zip(&self.force8) {
                        for &(i, ci) in row {
                            tangent[(range.start + i, col)] += ci * cj * f.eps[k];
                        }
                    }
                    for (i, r) in self.rate8.iter().enumerate() {
                        tangent[(range.start + states.start + i, col)] -= cj * r.eps[k];
                    }
                }
            }
        }
        self.seeds = seeds;
        for i in states.clone() {
            self.tangent[1][(range.start + i, i)] += 1.0;
        }
        let own = |q: Parameter| slot.params.clone().any(|i| q.rate(i) != 0.0);
        let moves = member.uses.velocity || member.uses.acceleration || member.uses.spin || !states.is_empty();
        if pace.parameter.map_or(moves, own) {
            self.speed_derivative(system, member, range, pace, phase, t);
        }
    }

    /// d rows / d parameter with the unknowns fixed: rates grow with the base frequency, and the part may read the speed itself.
    fn speed_derivative(&mut self, system: &System, member: &Member, range: Range<usize>, pace: Pace, phase: f64, t: f64) {
        let slot = &system.slots()[member.slot];
        let start = range.start;
        let stretch = pace.stretch();
        let states = member.states.clone();
        self.params1.clear();
        let own = slot.params.clone().zip(&system.params()[slot.params.clone()]);
        self.params1.extend(own.map(|(i, &p)| D1 { re: p, eps: [pace.parameter.map_or(0.0, |q| q.rate(i))] }));
        for (d, power) in [0.0, 1.0, 2.0].into_iter().enumerate() {
            self.seeded1[d].clear();
            for (i, &x) in self.local[d].iter().enumerate() {
                // the weight's share of the accelerations does not grow with the speed
                let moving = if d == 2 { x - slot.weight.get(i).copied().unwrap_or(0.0) } else { x };
                self.seeded1[d].push(D1 { re: x, eps: [power * moving * stretch] });
            }
        }
        self.seeded1[3].clear();
        self.seeded1[3].extend(self.u[0][start + states.start..start + states.end].iter().map(|&x| D1::lift(x)));
        refill(&mut self.force1, member.map.len(), D1::lift(0.0));
        refill(&mut self.rate1, states.len(), D1::lift(0.0));
        let mut spin = D1::lift(0.0);
        let [q, v, a, z] = &self.seeded1;
        let time = D1 { re: t, eps: [-t * stretch] };
        let at = At {
            q,
            v,
            a,
            z,
            phase: D1::lift(phase),
            speed: D1 { re: pace.speed, eps: [pace.rate[0]] },
            spin_accel: D1::lift(0.0),
            t: time,
        };
        let mut out = Rows { force: &mut self.force1, rate: &mut self.rate1, spin: &mut spin };
        D1::residual(&*slot.part, &self.params1, &at, &mut out, &mut self.blocks1);
        let force: Vec<f64> = self.force1.iter().map(|f| f.eps[0]).collect();
        scatter(&member.map, &force, &mut self.rows_speed[range]);
        for (i, r) in self.rate1.iter().enumerate() {
            let row = start + states.start + i;
            self.rows_speed[row] += self.u[1][row] * stretch - r.eps[0];
        }
    }

    /// Adds the balance's tangent `analysis (T0 E0 + w T1 E1 + w^2 T2 E2)` to `jac`, w the base frequency.
    pub fn add_jacobian(&mut self, terms: &Terms, w: f64, jac: &mut Mat) {
        let m = terms.coordinates;
        self.product.reset(terms.samples * m, terms.unknowns);
        spend((terms.samples * m * terms.unknowns * (3 * m + terms.unknowns)) as u64);
        for (d, factor) in [1.0, w, w * w].into_iter().enumerate() {
            if !self.uses[d] {
                continue;
            }
            for j in 0..terms.samples {
                for i in 0..m {
                    let row = j * m + i;
                    for k in 0..m {
                        let t = self.tangent[d][(row, k)] * factor;
                        if t != 0.0 {
                            let e = terms.synthesis[d].row(j * m + k);
                            for (p, &e) in self.product.row_mut(row).iter_mut().zip(e) {
                                *p += t * e;
                            }
                        }
                    }
                }
            }
        }
        terms.analysis.matmul_add(&self.product, jac);
    }

    /// Tangent of the rows at sample `j` in the motion's derivative `d` (0, 1, 2): an m x m block, rows from `j * m`.
    pub fn tangent(&self, d: usize) -> &Mat {
        &self.tangent[d]
    }
}
