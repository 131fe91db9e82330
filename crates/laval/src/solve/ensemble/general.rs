//! Members with any spin and any mass matrix, evaluated part by part.
//!
//! ```text
//! M(q) a = -r(q, v, a = 0, z; spin, t),   z' = rate(a = 0) + (d rate / d a) a
//! ```
//!
//! with the spin row and column when the spin is free. The derivatives in the accelerations are exact; M is eliminated without pivoting, which
//! is safe for the positive definite mass matrices of machines.

use super::pattern::Pattern;
use crate::model::blocks::Blocks;
use crate::model::lanes::{Dual8, Linear, LinearArgs, Residual, ResidualArgs, Tangent};
use crate::model::part::{At, Rows};
use crate::model::system::{Slot, System};
use crate::solve::motion::SpinLaw;
use laval_num::dual::Dual;
use laval_num::lanes::{LANES, LaneScalar};
use laval_num::scalar::Scalar;

/// How a part is evaluated.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// By its blocks; its spin row, if there is one, with derivatives.
    Blocks,
    /// By its residual: it reads no accelerations.
    Plain,
    /// By its residual with derivatives in the accelerations.
    Seeded,
}

/// A part in its place.
struct Place<S> {
    slot: usize,
    way: Way,
    params: Vec<S>,
    map: Pattern<S>,
    weight: Vec<S>,
    q: Vec<S>,
    v: Vec<S>,
    force: Vec<S>,
    rate: Vec<S>,
    /// d force / d a, and d rate / d a, over local accelerations; the spin's last.
    mass: Vec<S>,
    rate_a: Vec<S>,
    seeded: Seeded<S>,
}

/// Scratch of a seeded evaluation.
struct Seeded<S> {
    params: Vec<Dual8<S>>,
    vars: [Vec<Dual8<S>>; 4],
    force: Vec<Dual8<S>>,
    rate: Vec<Dual8<S>>,
}

/// Eight members, ready to be evaluated.
pub(super) struct General<'a, S> {
    base: &'a System,
    free: bool,
    laws: [SpinLaw; LANES],
    places: Vec<Place<S>>,
    mass: Vec<S>,
    force: Vec<S>,
    rate: Vec<S>,
    rate_a: Vec<S>,
    accel: Vec<S>,
    blocks: Blocks<S>,
}

impl<'a, S: LaneScalar> General<'a, S> {
    pub fn new(base: &'a System, free: bool) -> Self {
        let (n, m) = (base.n(), base.m());
        let rows = n + usize::from(free);
        let zeros = |len: usize| vec![S::zero(); len];
        let place = |(k, slot): (usize, &Slot)| {
            let (local, states) = (slot.map.len(), slot.states.len());
            let way = match () {
                () if slot.is_linear() => Way::Blocks,
                () if free || slot.uses.acceleration => Way::Seeded,
                () => Way::Plain,
            };
            let columns = local + usize::from(free);
            Place {
                slot: k,
                way,
                params: zeros(slot.params.len()),
                map: Pattern::new(local, n),
                weight: zeros(local),
                q: zeros(local),
                v: zeros(local),
                force: zeros(local + usize::from(free)),
                rate: zeros(states),
                mass: zeros((local + usize::from(free)) * columns),
                rate_a: zeros(states * columns),
                seeded: Seeded {
                    params: vec![Dual::zero(); slot.params.len()],
                    vars: [vec![Dual::zero(); local], vec![Dual::zero(); local], vec![Dual::zero(); local], vec![Dual::zero(); states]],
                    force: vec![Dual::zero(); local],
                    rate: vec![Dual::zero(); states],
                },
            }
        };
        let still = || SpinLaw::Programme(crate::solve::programme::Programme::constant(0.0, 0.0));
        General {
            base,
            free,
            laws: std::array::from_fn(|_| still()),
            places: base.slots().iter().enumerate().map(place).collect(),
            mass: zeros(rows * rows),
            force: zeros(rows),
            rate: zeros(m),
            rate_a: zeros(m * rows),
            accel: zeros(rows),
            blocks: Blocks::default(),
        }
    }

    /// Puts a member into a lane.
    pub fn load(&mut self, lane: usize, system: &System, law: SpinLaw) {
        self.laws[lane] = law;
        for place in &mut self.places {
            let slot = &system.slots()[place.slot];
            let values = &system.params()[slot.params.clone()];
            for ((p, d), &x) in place.params.iter_mut().zip(&mut place.seeded.params).zip(values) {
                *p = p.with(lane, x);
                d.re = *p;
            }
            for (w, &x) in place.weight.iter_mut().zip(&slot.weight) {
                *w = w.with(lane, x);
            }
            place.map.set(lane, |l, g| slot.map[l].iter().filter(|e| e.0 == g).map(|e| e.1).sum());
        }
    }

    /// Phase, speed and (prescribed) acceleration of the spin.
    #[inline(always)]
    fn spin(&self, t: S, y: &[S]) -> [S; 3] {
        if self.free {
            let k = 2 * self.base.n() + self.base.m();
            return [y[k], y[k + 1], S::zero()];
        }
        let t = t.to_array();
        let mut out = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            if let SpinLaw::Programme(p) = &self.laws[lane] {
                let s = p.at(t[lane]);
                (out[0][lane], out[1][lane], out[2][lane]) = (s.phase, s.speed, s.accel);
            }
        }
        [S::load(&out[0]), S::load(&out[1]), S::load(&out[2])]
    }

    #[inline(always)]
    pub fn rhs(&mut self, t: S, y: &[S], dy: &mut [S]) {
        let (n, m) = (self.base.n(), self.base.m());
        let rows = self.accel.len();
        let [phase, speed, spin_accel] = self.spin(t, y);
        for x in [&mut self.mass, &mut self.force, &mut self.rate, &mut self.rate_a] {
            for x in x.iter_mut() {
                *x = S::zero();
            }
        }
        for k in 0..self.places.len() {
            let place = &mut self.places[k];
            let slot = &self.base.slots()[place.slot];
            let local = place.q.len();
            for l in 0..local {
                place.q[l] = place.map.add_row(l, &y[..n], S::zero());
                place.v[l] = place.map.add_row(l, &y[n..2 * n], S::zero());
            }
            for x in place.force.iter_mut().chain(&mut place.rate) {
                *x = S::zero();
            }
            let z = &y[2 * n + slot.states.start..2 * n + slot.states.end];
            let at = At { q: &place.q, v: &place.v, a: &place.weight, z, phase, speed, spin_accel, t };
            let mut spin = S::zero();
            match place.way {
                Way::Blocks => {
                    self.blocks.reset(local, z.len(), speed);
                    let mut args = LinearArgs { p: &place.params, speed, blocks: &mut self.blocks };
                    S::enter::<Linear, _>(&*slot.part, &mut args);
                    if self.free {
                        seeded(place, slot, [phase, speed, spin_accel, t], z, true);
                    }
                    // the spin row is in place; the rows of the blocks follow
                    let at = At { q: &place.q, v: &place.v, a: &place.weight, z, phase, speed, spin_accel, t };
                    self.blocks.residual(&at, &mut place.force[..local], &mut place.rate);
                    let columns = local + usize::from(self.free);
                    for i in 0..local {
                        for j in 0..local {
                            place.mass[i * columns + j] = self.blocks.mass[(i, j)];
                        }
                    }
                    for i in 0..z.len() {
                        for j in 0..local {
                            place.rate_a[i * columns + j] = self.blocks.state_a[(i, j)];
                        }
                    }
                    if self.free {
                        let turn = phase.sin_cos();
                        for i in 0..local {
                            place.mass[i * columns + local] = self.blocks.spin_accel_row(i, &at, turn);
                        }
                    }
                }
                Way::Plain => {
                    let out = Rows { force: &mut place.force[..local], rate: &mut place.rate, spin: &mut spin };
                    let mut args = ResidualArgs { p: &place.params, at, out };
                    S::enter::<Residual, _>(&*slot.part, &mut args);
                }
                Way::Seeded => seeded(place, slot, [phase, speed, spin_accel, t], z, self.free),
            }
            // into the rows of the machine
            let place = &self.places[k];
            let columns = local + usize::from(self.free);
            for i in 0..local {
                for (gi, ci) in place.map.row(i) {
                    self.force[gi] += ci * place.force[i];
                    if place.way == Way::Plain {
                        continue;
                    }
                    for j in 0..local {
                        let x = ci * place.mass[i * columns + j];
                        for (gj, cj) in place.map.row(j) {
                            self.mass[gi * rows + gj] += x * cj;
                        }
                    }
                    if self.free {
                        self.mass[gi * rows + n] += ci * place.mass[i * columns + local];
                    }
                }
            }
            if self.free {
                self.force[n] += place.force[local];
                for j in 0..local {
                    for (gj, cj) in place.map.row(j) {
                        self.mass[n * rows + gj] += cj * place.mass[local * columns + j];
                    }
                }
                self.mass[n * rows + n] += place.mass[local * columns + local];
            }
            for i in 0..slot.states.len() {
                let row = slot.states.start + i;
                self.rate[row] += place.rate[i];
                if place.way == Way::Plain {
                    continue;
                }
                for j in 0..local {
                    for (gj, cj) in place.map.row(j) {
                        self.rate_a[row * rows + gj] += cj * place.rate_a[i * columns + j];
                    }
                }
                if self.free {
                    self.rate_a[row * rows + n] += place.rate_a[i * columns + local];
                }
            }
        }
        for i in 0..rows {
            self.accel[i] = -self.force[i];
        }
        eliminate(&mut self.mass, &mut self.accel);
        for i in 0..n {
            dy[i] = y[n + i];
            dy[n + i] = self.accel[i];
        }
        for i in 0..m {
            let mut rate = self.rate[i];
            for j in 0..rows {
                rate += self.rate_a[i * rows + j] * self.accel[j];
            }
            dy[2 * n + i] = rate;
        }
        if self.free {
            dy[2 * n + m] = speed;
            dy[2 * n + m + 1] = self.accel[n];
        }
    }
}

/// A part's rows at zero acceleration with their exact derivatives in the accelerations (and the spin's when `free`).
#[inline(always)]
fn seeded<S: LaneScalar>(
    place: &mut Place<S>,
    slot: &Slot,
    [phase, speed, spin_accel, t]: [S; 4],
    z: &[S],
    free: bool,
) {
    let local = place.q.len();
    let directions = local + usize::from(free);
    let s = &mut place.seeded;
    let lift = |x: S| Dual { re: x, eps: [S::zero(); 8] };
    for l in 0..local {
        s.vars[0][l] = lift(place.q[l]);
        s.vars[1][l] = lift(place.v[l]);
        s.vars[2][l] = lift(place.weight[l]);
    }
    for l in 0..z.len() {
        s.vars[3][l] = lift(z[l]);
    }
    let mut start = 0;
    while start < directions {
        let end = directions.min(start + 8);
        let mut accel = lift(spin_accel);
        for j in start..end {
            if j < local {
                s.vars[2][j].eps[j - start] = S::one();
            } else {
                accel.eps[j - start] = S::one();
            }
        }
        for f in s.force.iter_mut().chain(&mut s.rate) {
            *f = lift(S::zero());
        }
        let mut spin = lift(S::zero());
        let [q, v, a, z8] = &s.vars;
        let mut args = ResidualArgs {
            p: &s.params,
            at: At { q, v, a, z: z8, phase: lift(phase), speed: lift(speed), spin_accel: accel, t: lift(t) },
            out: Rows { force: &mut s.force, rate: &mut s.rate, spin: &mut spin },
        };
        S::enter::<Tangent, _>(&*slot.part, &mut args);
        for j in start..end {
            let k = j - start;
            for i in 0..local {
                place.mass[i * directions + j] = s.force[i].eps[k];
            }
            for i in 0..z.len() {
                place.rate_a[i * directions + j] = s.rate[i].eps[k];
            }
            if free {
                place.mass[local * directions + j] = spin.eps[k];
            }
            if j < local {
                s.vars[2][j].eps[k] = S::zero();
            }
        }
        if start == 0 {
            for i in 0..local {
                place.force[i] = s.force[i].re;
            }
            for i in 0..z.len() {
                place.rate[i] = s.rate[i].re;
            }
            if free {
                place.force[local] = spin.re;
            }
        }
        start = end;
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
