//! Members in lanes at constant speeds whose mass matrix depends on the configuration, without internal states: the linear parts as one sparse matrix, the
//! nonlinear ones with their masses in the same call.
//!
//! ```text
//! M(q) a = -r(q, v, a = 0; phase)
//! ```
//!
//! M is symmetric and, for machines, positive definite: it is eliminated without pivoting.

use crate::model::erased::{Erased, VaryingInertia};
use crate::model::lanes::{Inertial, InertialArgs, Residual, ResidualArgs};
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, Rows};
use crate::model::system::{Drive, Slot, System};
use laval_num::dense::Mat;
use laval_num::lanes::{Entry, Routine, Sparse};
use std::f64::consts::FRAC_2_PI;

/// A nonlinear part in its place.
struct Law<'a, S> {
    slot: usize,
    part: &'a dyn Erased,
    /// Gives its masses with its residual.
    inertial: Option<&'a dyn VaryingInertia>,
    params: Vec<S>,
    map: Sparse<S>,
    /// Coordinates of the machine, where each of the part is one of them for every member.
    picked: Option<Vec<usize>>,
    q: Vec<S>,
    v: Vec<S>,
    /// What the weight adds to local accelerations.
    weight: Vec<S>,
    force: Vec<S>,
    mass: Vec<S>,
}

/// The members, ready to be evaluated.
pub(super) struct Varying<'a, S> {
    n: usize,
    /// Rows of the linear parts over (q, v, 1, cos(phase), sin(phase)), and their masses.
    rows: Sparse<S>,
    fixed: Vec<S>,
    laws: Vec<Law<'a, S>>,
    mass: Vec<S>,
    force: Vec<S>,
    speed: S,
    /// Phase at time 0, and at the moment announced with its sine and cosine.
    phase: S,
    now: S,
    sine: (S, S),
}

/// The coordinates of the machine that a part's are, where each is one of them, none twice.
fn picks(slot: &Slot) -> Option<Vec<usize>> {
    let one = |row: &Vec<(usize, f64)>| if let [(g, 1.0)] = row[..] { Some(g) } else { None };
    let list: Vec<usize> = slot.map.iter().map(one).collect::<Option<_>>()?;
    (0..list.len()).all(|i| !list[..i].contains(&list[i])).then_some(list)
}

/// The machine can be evaluated in this form at constant speeds.
pub(super) fn serves(system: &System) -> bool {
    let plain = system.m() == 0 && system.machine.drive == Drive::Prescribed;
    plain && system.slots().iter().all(|s| s.is_linear() || !s.uses.acceleration || s.part.varying_inertia().is_some())
}

impl<'a, S: Entry> Varying<'a, S> {
    pub fn new(base: &'a System) -> Self {
        let n = base.n();
        let zeros = |len: usize| vec![S::zero(); len];
        let law = |(k, slot): (usize, &'a Slot)| {
            let local = slot.map.len();
            let inertial = slot.part.varying_inertia().filter(|_| slot.uses.acceleration);
            Law {
                slot: k,
                part: &*slot.part,
                inertial,
                params: zeros(slot.params.len()),
                map: Sparse::new(local, n),
                picked: picks(slot),
                q: zeros(local),
                v: zeros(local),
                weight: zeros(local),
                force: zeros(local),
                mass: zeros(if inertial.is_some() { local * local } else { 0 }),
            }
        };
        let zero = S::zero();
        Varying {
            n,
            rows: Sparse::new(n, 2 * n + 3),
            fixed: zeros(n * n),
            laws: base.slots().iter().enumerate().filter(|(_, s)| !s.is_linear()).map(law).collect(),
            mass: zeros(n * n),
            force: zeros(n),
            speed: zero,
            phase: zero,
            now: zero,
            sine: (zero, zero),
        }
    }

    /// Number of terms behind the states.
    pub fn room(&self) -> usize {
        3
    }

    /// Puts a member into a lane.
    pub fn load(&mut self, lane: usize, system: &System, speed: f64, phase: f64) {
        let n = self.n;
        let mut model = LinearModel::default();
        system.linear(system.params(), speed, Form::Time, &mut model, &mut LinearScratch::default());
        let rows = Mat::from_fn(n, 2 * n + 3, |i, j| match j {
            j if j < n => -model.stiffness(i, j),
            j if j < 2 * n => -model.damping(i, j - n),
            j => [model.loads.force[i], model.loads.force_cos[i], model.loads.force_sin[i]][j - 2 * n],
        });
        self.rows.set(lane, &rows);
        for (k, m) in self.fixed.iter_mut().enumerate() {
            *m = m.with(lane, model.mass(k / n, k % n));
        }
        for law in &mut self.laws {
            let slot = &system.slots()[law.slot];
            for (p, &x) in law.params.iter_mut().zip(&system.params()[slot.params.clone()]) {
                *p = p.with(lane, x);
            }
            for (w, &x) in law.weight.iter_mut().zip(&slot.weight) {
                *w = w.with(lane, x);
            }
            let mut map = Mat::zeros(slot.map.len(), n);
            for (l, row) in slot.map.iter().enumerate() {
                for &(g, c) in row {
                    map[(l, g)] += c;
                }
            }
            law.map.set(lane, &map);
            if law.picked != picks(slot) {
                law.picked = None;
            }
        }
        self.speed = self.speed.with(lane, speed);
        self.phase = self.phase.with(lane, phase);
    }

    #[inline(always)]
    pub fn time(&mut self, t: S) {
        self.now = self.phase + self.speed * t;
        self.sine = self.now.scale(FRAC_2_PI).sin_cos_quarters();
    }

    /// Accelerations.
    #[inline(always)]
    pub fn rhs(&mut self, t: S, y: &mut [S], rates: &mut [S]) {
        S::apart(RightSide { varying: self, t, y, rates });
    }

    #[inline(always)]
    fn evaluate(&mut self, t: S, y: &mut [S], rates: &mut [S]) {
        let n = self.n;
        (y[2 * n], y[2 * n + 1], y[2 * n + 2]) = (S::one(), self.sine.1, self.sine.0);
        self.rows.times_in_order(y, &mut self.force);
        self.mass.copy_from_slice(&self.fixed);
        for law in &mut self.laws {
            let local = law.q.len();
            if let Some(picked) = &law.picked {
                for (i, &g) in picked.iter().enumerate() {
                    (law.q[i], law.v[i]) = (y[g], y[n + g]);
                }
            } else {
                law.map.times_in_order(&y[..n], &mut law.q);
                law.map.times_in_order(&y[n..2 * n], &mut law.v);
            }
            clear(&mut law.force);
            clear(&mut law.mass);
            let mut spin = S::zero();
            let at = At { q: &law.q, v: &law.v, a: &law.weight, z: &[], phase: self.now, speed: self.speed, spin_accel: S::zero(), t };
            let out = Rows { force: &mut law.force, rate: &mut [], spin: &mut spin };
            if let Some(part) = law.inertial {
                let mut args = InertialArgs { p: &law.params, at, out, mass: &mut law.mass };
                S::enter::<Inertial, _>(part, &mut args);
            } else {
                S::enter::<Residual, _>(law.part, &mut ResidualArgs { p: &law.params, at, out });
            }
            if let Some(picked) = &law.picked {
                for (i, &gi) in picked.iter().enumerate() {
                    self.force[gi] -= law.force[i];
                    if law.inertial.is_some() {
                        // of equals above and below the diagonal one is read
                        for (j, &gj) in picked.iter().enumerate().filter(|(_, gj)| **gj >= gi) {
                            self.mass[gi * n + gj] += law.mass[i * local + j];
                        }
                    }
                }
                continue;
            }
            for i in 0..local {
                for k in law.map.span(i) {
                    let (gi, ci) = law.map.at(k);
                    self.force[gi] -= ci * law.force[i];
                    if law.inertial.is_none() {
                        continue;
                    }
                    for j in 0..local {
                        let x = ci * law.mass[i * local + j];
                        for k in law.map.span(j) {
                            let (gj, cj) = law.map.at(k);
                            self.mass[gi * n + gj] += x * cj;
                        }
                    }
                }
            }
        }
        solve(&mut self.mass, &mut self.force);
        rates.copy_from_slice(&self.force);
    }
}

#[inline(always)]
fn clear<S: Entry>(x: &mut [S]) {
    for x in x {
        *x = S::zero();
    }
}

struct RightSide<'a, 'b, S> {
    varying: &'a mut Varying<'b, S>,
    t: S,
    y: &'a mut [S],
    rates: &'a mut [S],
}

impl<S: Entry> Routine for RightSide<'_, '_, S> {
    type Out = ();
    #[inline(always)]
    fn run(self) {
        self.varying.evaluate(self.t, self.y, self.rates);
    }
}

/// Solves `m x = b` in place by symmetric elimination; `m` is row-major, its upper half is read and destroyed.
#[inline(always)]
fn solve<S: Entry>(m: &mut [S], b: &mut [S]) {
    let n = b.len();
    assert!(m.len() == n * n);
    for k in 0..n {
        let inverse = S::one() / m[k * n + k];
        m[k * n + k] = inverse;
        let pivot = b[k];
        for i in k + 1..n {
            let f = m[k * n + i] * inverse;
            for j in i..n {
                let x = m[k * n + j];
                m[i * n + j] -= f * x;
            }
            b[i] -= f * pivot;
        }
    }
    for k in (0..n).rev() {
        let mut x = b[k];
        for j in k + 1..n {
            x -= m[k * n + j] * b[j];
        }
        b[k] = x * m[k * n + k];
    }
}
