//! Members of constant mass at constant speeds: the linear parts as one sparse matrix of lanes, and a call for each nonlinear part.

use super::pattern::Pattern;
use crate::model::lanes::{Residual, ResidualArgs};
use crate::model::part::{At, Rows};
use crate::model::system::{Slot, System};
use crate::solve::motion::compiled::Compiled;
use laval_num::lanes::LaneScalar;
use laval_num::ode::Failure;

/// A nonlinear part in its place.
struct Law<S> {
    slot: usize,
    params: Vec<S>,
    /// Local coordinates from global ones.
    map: Pattern<S>,
    /// What the weight adds to local accelerations.
    weight: Vec<S>,
    velocity: bool,
    /// Answer of the rows to the local forces.
    answer: Pattern<S>,
    q: Vec<S>,
    v: Vec<S>,
    force: Vec<S>,
}

/// Eight members, ready to be evaluated.
pub(super) struct Constant<'a, S> {
    base: &'a System,
    /// Index in dy of each row: accelerations, then the states of linear parts.
    target: Vec<u32>,
    /// Over the state y.
    linear: Pattern<S>,
    /// Constant, cosine and sine of the phase; and whether any member has them.
    forcing: Vec<[S; 3]>,
    forced: Vec<[bool; 2]>,
    laws: Vec<Law<S>>,
    speed: S,
    phase: S,
}

impl<'a, S: LaneScalar> Constant<'a, S> {
    pub fn new(base: &'a System) -> Self {
        let (n, m) = (base.n(), base.m());
        let states = base.linear_states(crate::model::linear::Form::Time);
        let target: Vec<u32> = (n..2 * n).chain(states.iter().map(|z| 2 * n + z)).map(|i| i as u32).collect();
        let rows = target.len();
        let zeros = |len: usize| vec![S::zero(); len];
        let law = |(k, slot): (usize, &Slot)| {
            let local = slot.map.len();
            Law {
                slot: k,
                params: zeros(slot.params.len()),
                map: Pattern::new(local, n),
                weight: zeros(local),
                velocity: slot.uses.velocity,
                answer: Pattern::new(rows, local),
                q: zeros(local),
                v: zeros(local),
                force: zeros(local),
            }
        };
        Constant {
            base,
            linear: Pattern::new(rows, 2 * n + m),
            forcing: vec![[S::zero(); 3]; rows],
            forced: vec![[false; 2]; rows],
            laws: base.slots().iter().enumerate().filter(|(_, s)| !s.is_linear()).map(law).collect(),
            speed: S::zero(),
            phase: S::zero(),
            target,
        }
    }

    /// Puts a member into a lane.
    pub fn load(&mut self, lane: usize, system: &System, speed: f64, phase: f64) -> Result<(), Failure> {
        let compiled = Compiled::new(system, speed)?;
        let n = system.n();
        // where each column of the compiled form stands in y
        let mut column = vec![usize::MAX; 2 * n + system.m()];
        for j in 0..2 * n {
            column[j] = j;
        }
        for (k, &z) in compiled.model.states.iter().enumerate() {
            column[2 * n + z] = 2 * n + k;
        }
        self.linear.set(lane, |i, j| if column[j] == usize::MAX { 0.0 } else { compiled.columns[(column[j], i)] });
        for (i, f) in self.forcing.iter_mut().enumerate() {
            for k in 0..3 {
                f[k] = f[k].with(lane, compiled.forcing[k][i]);
            }
            self.forced[i][0] |= compiled.forcing[0][i] != 0.0;
            self.forced[i][1] |= compiled.forcing[1][i] != 0.0 || compiled.forcing[2][i] != 0.0;
        }
        for law in &mut self.laws {
            let slot = &system.slots()[law.slot];
            for (p, &x) in law.params.iter_mut().zip(&system.params()[slot.params.clone()]) {
                *p = p.with(lane, x);
            }
            for (w, &x) in law.weight.iter_mut().zip(&slot.weight) {
                *w = w.with(lane, x);
            }
            let coefficient = |l: usize, g: usize| slot.map[l].iter().filter(|e| e.0 == g).map(|e| e.1).sum::<f64>();
            law.map.set(lane, coefficient);
            law.answer.set(lane, |i, l| {
                let answers = compiled.touched.iter().enumerate();
                answers.map(|(k, &g)| coefficient(l, g) * compiled.answers[(k, i)]).sum()
            });
        }
        self.speed = self.speed.with(lane, speed);
        self.phase = self.phase.with(lane, phase);
        Ok(())
    }

    #[inline(always)]
    pub fn rhs(&mut self, t: S, y: &[S], dy: &mut [S]) {
        let n = self.base.n();
        let phase = self.phase + self.speed * t;
        for i in 0..n {
            dy[i] = y[n + i];
        }
        for law in &mut self.laws {
            let slot = &self.base.slots()[law.slot];
            let local = law.q.len();
            for l in 0..local {
                law.q[l] = law.map.add_row(l, &y[..n], S::zero());
                law.force[l] = S::zero();
            }
            if law.velocity {
                for l in 0..local {
                    law.v[l] = law.map.add_row(l, &y[n..2 * n], S::zero());
                }
            }
            let states = 2 * n + slot.states.start..2 * n + slot.states.end;
            let rate = &mut dy[states.clone()];
            for r in rate.iter_mut() {
                *r = S::zero();
            }
            let mut spin = S::zero();
            let mut args = ResidualArgs {
                p: &law.params,
                at: At { q: &law.q, v: &law.v, a: &law.weight, z: &y[states], phase, speed: self.speed, spin_accel: S::zero(), t },
                out: Rows { force: &mut law.force, rate, spin: &mut spin },
            };
            S::enter::<Residual, _>(&*slot.part, &mut args);
        }
        let (sin, cos) = phase.sin_cos();
        for i in 0..self.target.len() {
            let mut sum = S::zero();
            let [constant, turning] = self.forced[i];
            if constant {
                sum += self.forcing[i][0];
            }
            if turning {
                sum += self.forcing[i][1] * cos + self.forcing[i][2] * sin;
            }
            sum = self.linear.add_row(i, y, sum);
            for law in &self.laws {
                sum = law.answer.add_row(i, &law.force, sum);
            }
            dy[self.target[i] as usize] = sum;
        }
    }
}
