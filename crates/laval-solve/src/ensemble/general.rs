//! Members with any spin and any mass matrix, evaluated part by part.
//!
//! ```text
//! M(q) a = -r(q, v, a = 0, z; spin, t),   z' = rate(q, v, a, z)
//! ```
//!
//! with the spin row and column when the spin is free. Residuals are affine in the accelerations: a column of M is the difference of two
//! residuals, and what rounding leaves of it is removed by a second solution with the residual of the first. M is eliminated without pivoting,
//! which is safe for the positive definite mass matrices of machines.

use crate::model::blocks::Blocks;
use crate::model::erased::Erased;
use crate::model::lanes::{Linear, LinearArgs, Residual, ResidualArgs};
use crate::model::part::{At, Rows};
use crate::model::system::{Slot, System};
use crate::motion::SpinLaw;
use laval_num::dense::Mat;
use laval_num::lanes::{LANES, LaneScalar, Routine, Sparse};
use std::ops::Range;

/// A part in its place.
struct Place<'a, S> {
    part: &'a dyn Erased,
    slot: usize,
    /// Given by blocks.
    linear: bool,
    /// Its rows outside the blocks depend on accelerations, that of the spin counted when it is free.
    inertial: bool,
    params: Vec<S>,
    map: Sparse<S>,
    weight: Vec<S>,
    q: Vec<S>,
    v: Vec<S>,
    a: Vec<S>,
    /// Its states in y, memory last.
    states: Range<usize>,
    /// How many of them are no memory.
    own: usize,
    blocks: Blocks<S>,
    /// Local rows, then that of the spin, then rates; at zero acceleration, and at another.
    base: Vec<S>,
    other: Vec<S>,
}

/// Spin and time of an evaluation.
#[derive(Clone, Copy)]
struct Moment<S> {
    phase: S,
    speed: S,
    /// Prescribed acceleration.
    accel: S,
    t: S,
}

impl<S: LaneScalar> Place<'_, S> {
    /// Rows outside the blocks at local accelerations `a` (the weight included) and the spin's.
    #[inline(always)]
    fn rows(&mut self, at: Moment<S>, y: &[S], spin_accel: S, other: bool) {
        let local = self.q.len();
        let out = if other { &mut self.other } else { &mut self.base };
        for x in out.iter_mut() {
            *x = S::zero();
        }
        let (force, rest) = out.split_at_mut(local);
        let (spin, rate) = rest.split_at_mut(1);
        let z = &y[self.states.clone()];
        let point = At { q: &self.q, v: &self.v, a: &self.a, z, phase: at.phase, speed: at.speed, spin_accel, t: at.t };
        let mut args = ResidualArgs { p: &self.params, at: point, out: Rows { force, rate, spin: &mut spin[0] } };
        S::enter::<Residual, _>(self.part, &mut args);
    }

    /// Adds the rows of the blocks at the present accelerations.
    #[inline(always)]
    fn add_blocks(&mut self, at: Moment<S>, y: &[S], spin_accel: S, other: bool) {
        let local = self.q.len();
        let out = if other { &mut self.other } else { &mut self.base };
        let (force, rest) = out.split_at_mut(local);
        let z = &y[self.states.clone()];
        let point = At { q: &self.q, v: &self.v, a: &self.a, z, phase: at.phase, speed: at.speed, spin_accel, t: at.t };
        self.blocks.residual(&point, force, &mut rest[1..]);
    }
}

/// The members in the lanes, ready to be evaluated.
pub(super) struct General<'a, S> {
    n: usize,
    m: usize,
    free: bool,
    laws: [SpinLaw; LANES],
    places: Vec<Place<'a, S>>,
    mass: Vec<S>,
    factors: Vec<S>,
    force: Vec<S>,
    accel: Vec<S>,
    rate: Vec<S>,
    rate_a: Vec<S>,
    /// Phase, speed and acceleration prescribed for the moment announced.
    now: [S; 3],
}

impl<'a, S: LaneScalar> General<'a, S> {
    pub fn new(base: &'a System, free: bool) -> Self {
        let (n, m) = (base.n(), base.m());
        let rows = n + usize::from(free);
        let zeros = |len: usize| vec![S::zero(); len];
        let place = |(k, slot): (usize, &'a Slot)| {
            let (local, states) = (slot.map.len(), slot.states.len());
            Place {
                part: &*slot.part,
                slot: k,
                linear: slot.is_linear(),
                inertial: free || (!slot.is_linear() && slot.uses.acceleration),
                params: zeros(slot.params.len()),
                map: Sparse::new(local, n),
                weight: zeros(local),
                q: zeros(local),
                v: zeros(local),
                a: zeros(local),
                states: 2 * n + slot.states.start..2 * n + slot.states.end,
                own: states - slot.memory,
                blocks: Blocks::default(),
                base: zeros(local + 1 + states),
                other: zeros(local + 1 + states),
            }
        };
        let still = || SpinLaw::Programme(crate::programme::Programme::constant(0.0, 0.0));
        General {
            n,
            m,
            free,
            laws: std::array::from_fn(|_| still()),
            places: base.slots().iter().enumerate().map(place).collect(),
            mass: zeros(rows * rows),
            factors: zeros(rows * rows),
            force: zeros(rows),
            accel: zeros(rows),
            rate: zeros(m),
            rate_a: zeros(m * rows),
            now: [S::zero(); 3],
        }
    }

    /// Puts a member into a lane.
    pub fn load(&mut self, lane: usize, system: &System, law: SpinLaw) {
        self.laws[lane] = law;
        for place in &mut self.places {
            let slot = &system.slots()[place.slot];
            for (p, &x) in place.params.iter_mut().zip(&system.params()[slot.params.clone()]) {
                *p = p.with(lane, x);
            }
            for (w, &x) in place.weight.iter_mut().zip(&slot.weight) {
                *w = w.with(lane, x);
            }
            let mut map = Mat::zeros(slot.map.len(), self.n);
            for (l, row) in slot.map.iter().enumerate() {
                for &(g, c) in row {
                    map[(l, g)] += c;
                }
            }
            place.map.set(lane, &map);
        }
    }

    #[inline(always)]
    fn moment(&self, t: S, y: &[S]) -> Moment<S> {
        if self.free {
            let k = 2 * self.n + self.m;
            return Moment { phase: y[k], speed: y[k + 1], accel: S::zero(), t };
        }
        let [phase, speed, accel] = self.now;
        Moment { phase, speed, accel, t }
    }

    #[inline(always)]
    pub fn time(&mut self, t: S) {
        if self.free {
            return;
        }
        let times = t.to_array();
        let mut out = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            if let SpinLaw::Programme(p) = &self.laws[lane] {
                let s = p.at(times[lane]);
                (out[0][lane], out[1][lane], out[2][lane]) = (s.phase, s.speed, s.accel);
            }
        }
        self.now = [S::load(&out[0]), S::load(&out[1]), S::load(&out[2])];
    }

    /// Mass matrix, and derivatives of the rates in the accelerations, with the rows at zero acceleration.
    #[inline(always)]
    fn assemble(&mut self, at: Moment<S>, y: &[S]) {
        let (n, rows) = (self.n, self.accel.len());
        for x in self.mass.iter_mut().chain(&mut self.rate_a) {
            *x = S::zero();
        }
        for place in &mut self.places {
            let local = place.q.len();
            place.map.times_in_order(&y[..n], &mut place.q);
            place.map.times_in_order(&y[n..2 * n], &mut place.v);
            for l in 0..local {
                place.a[l] = place.weight[l];
            }
            let states = place.states.len();
            let first = place.states.start - 2 * n;
            if place.linear {
                place.blocks.reset_band(local, place.own, place.part.reach(), at.speed);
                S::enter::<Linear, _>(place.part, &mut LinearArgs { p: &place.params, speed: at.speed, blocks: &mut place.blocks });
                for j in 0..local {
                    for k in place.map.span(j) {
                        let (gj, cj) = place.map.at(k);
                        for i in place.blocks.mass.columns(j) {
                            let x = place.blocks.mass[(i, j)] * cj;
                            for k in place.map.span(i) {
                                let (gi, ci) = place.map.at(k);
                                self.mass[gi * rows + gj] += ci * x;
                            }
                        }
                        for i in 0..place.own {
                            self.rate_a[(first + i) * rows + gj] += place.blocks.state_a[(i, j)] * cj;
                        }
                    }
                }
            }
            place.rows(at, y, at.accel, false);
            if place.inertial {
                for j in 0..local + usize::from(self.free) {
                    let mut spin_accel = at.accel;
                    if j < local {
                        place.a[j] += S::one();
                    } else {
                        spin_accel += S::one();
                    }
                    place.rows(at, y, spin_accel, true);
                    if j < local {
                        place.a[j] = place.weight[j];
                    }
                    let span = if j < local { place.map.span(j) } else { 0..1 };
                    for k in span {
                        let (gj, cj) = if j < local { place.map.at(k) } else { (n, S::one()) };
                        for i in 0..local {
                            let x = (place.other[i] - place.base[i]) * cj;
                            for k in place.map.span(i) {
                                let (gi, ci) = place.map.at(k);
                                self.mass[gi * rows + gj] += ci * x;
                            }
                        }
                        if self.free {
                            self.mass[n * rows + gj] += (place.other[local] - place.base[local]) * cj;
                        }
                        for i in 0..states {
                            self.rate_a[(first + i) * rows + gj] += (place.other[local + 1 + i] - place.base[local + 1 + i]) * cj;
                        }
                    }
                }
            }
            if place.linear {
                if self.free {
                    let (sin, cos) = at.phase.sin_cos();
                    let z = &y[place.states.clone()];
                    let point =
                        At { q: &place.q, v: &place.v, a: &place.a, z, phase: at.phase, speed: at.speed, spin_accel: at.accel, t: at.t };
                    for i in 0..local {
                        let x = place.blocks.spin_accel_row(i, &point, (sin, cos));
                        for k in place.map.span(i) {
                            let (gi, ci) = place.map.at(k);
                            self.mass[gi * rows + n] += ci * x;
                        }
                    }
                }
                place.add_blocks(at, y, at.accel, false);
            }
        }
    }

    /// Sums the rows of all parts, at zero acceleration or at the present ones.
    #[inline(always)]
    fn gather(&mut self, at: Moment<S>, y: &[S], present: bool) {
        let n = self.n;
        for x in self.force.iter_mut().chain(&mut self.rate) {
            *x = S::zero();
        }
        for place in &mut self.places {
            let local = place.q.len();
            if present {
                let spin_accel = if self.free { self.accel[n] } else { at.accel };
                place.map.times_in_order(&self.accel[..n], &mut place.a);
                for l in 0..local {
                    place.a[l] += place.weight[l];
                }
                if place.linear || place.inertial {
                    place.rows(at, y, spin_accel, true);
                }
                if place.linear {
                    place.add_blocks(at, y, spin_accel, true);
                }
            }
            let rows = if present && (place.linear || place.inertial) { &place.other } else { &place.base };
            for i in 0..local {
                for k in place.map.span(i) {
                    let (g, c) = place.map.at(k);
                    self.force[g] += c * rows[i];
                }
            }
            if self.free {
                self.force[n] += rows[local];
            }
            for i in 0..place.states.len() {
                self.rate[place.states.start - 2 * n + i] += rows[local + 1 + i];
            }
        }
    }

    /// The rates of all but the coordinates; a long function, compiled once.
    #[inline(always)]
    pub fn rhs(&mut self, t: S, y: &[S], dy: &mut [S]) {
        S::apart(RightSide { general: self, t, y, dy });
    }

    #[inline(always)]
    fn evaluate(&mut self, t: S, y: &[S], dy: &mut [S]) {
        let (n, m) = (self.n, self.m);
        let rows = self.accel.len();
        let at = self.moment(t, y);
        self.assemble(at, y);
        for i in 0..rows {
            self.accel[i] = S::zero();
        }
        // the second round removes what rounding left in the columns of M
        let mut round = 0;
        while round < 2 {
            self.gather(at, y, round == 1);
            for i in 0..rows * rows {
                self.factors[i] = self.mass[i];
            }
            eliminate(&mut self.factors, &mut self.force);
            for i in 0..rows {
                self.accel[i] -= self.force[i];
            }
            round += 1;
        }
        dy[..n].copy_from_slice(&self.accel[..n]);
        for i in 0..m {
            let mut rate = self.rate[i];
            for j in 0..rows {
                rate -= self.rate_a[i * rows + j] * self.force[j];
            }
            dy[n + i] = rate;
        }
        if self.free {
            dy[n + m] = at.speed;
            dy[n + m + 1] = self.accel[n];
        }
    }
}

struct RightSide<'a, 'b, S> {
    general: &'a mut General<'b, S>,
    t: S,
    y: &'a [S],
    dy: &'a mut [S],
}

impl<S: LaneScalar> Routine for RightSide<'_, '_, S> {
    type Out = ();
    #[inline(always)]
    fn run(self) {
        self.general.evaluate(self.t, self.y, self.dy);
    }
}

/// Solves `m x = b` in place by elimination without pivoting; `m` is row-major and is destroyed.
#[inline(always)]
fn eliminate<S: LaneScalar>(m: &mut [S], b: &mut [S]) {
    let n = b.len();
    for k in 0..n {
        let inverse = S::one() / m[k * n + k];
        for i in k + 1..n {
            let f = m[i * n + k] * inverse;
            for j in k + 1..n {
                let x = m[k * n + j];
                m[i * n + j] -= f * x;
            }
            let x = b[k];
            b[i] -= f * x;
        }
    }
    for k in (0..n).rev() {
        let mut x = b[k];
        for j in k + 1..n {
            x -= m[k * n + j] * b[j];
        }
        b[k] = x / m[k * n + k];
    }
}
