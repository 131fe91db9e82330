//! Equations of a machine at rest and their solution by Newton's method.

use super::offsets::Raised;
use super::{Statics, along, forces};
use crate::characteristic::nonlinear_states;
use crate::diagnostic::Diagnostic;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, Rows};
use crate::model::station::Row;
use crate::model::system::{System, Workspace};
use crate::model::tangent::{SparseTangent, TangentScratch};
use crate::rest::{not_held, unfound};
use crate::turned_freely::kept;
use laval_num::complex::{C64, c};
use laval_num::dense::{Field, Mat, max_abs};
use laval_num::factor::{Factors, Pattern, Plan, Terms};
use std::sync::Arc;

/// Newton steps, at most.
const MOST_STEPS: usize = 40;
/// Step over the displacement that is rounding; at which steps that no longer fall are accepted.
const EXACT: f64 = 1e-14;
const NEAR: f64 = 1e-9;

pub(super) struct Equations<'a> {
    system: &'a System,
    plan: Plan,
    pattern: Arc<Pattern>,
    /// Linear parts; K.
    stiffness: Vec<f64>,
    /// Weight, constant forces, and those of linear supports that are raised.
    pub(super) load: Vec<f64>,
    left_out: Vec<bool>,
    raised: Vec<Raised>,
    /// Global indices of the states among the unknowns; the number of those of linear parts.
    states: Vec<usize>,
    linear_states: usize,
    speed: f64,
}

impl<'a> Equations<'a> {
    pub(super) fn new(system: &'a System, speed: f64, left_out: &[bool], raised: &[Raised]) -> Self {
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
        // the rotor rests: coefficients are those of the speed, and what it multiplies is none
        model.speed = 0.0;
        let [mut stiffness, ..] = model.polynomial();
        let pattern = model.pattern().clone();
        for slot in system.slots() {
            forces::each_beside(system, slot, speed, |i, j, k| {
                if let Some(e) = pattern.index(i, j) {
                    stiffness[e] += k;
                }
            });
        }
        let mut load: Vec<f64> = model.loads.force.iter().chain(&model.loads.rate).copied().collect();
        load.resize(pattern.n(), 0.0);
        for (slot, _) in system.slots().iter().zip(left_out).filter(|x| *x.1 && x.0.is_linear()) {
            forces::each_stiffness(system, slot, speed, |i, j, k| {
                if let Some(e) = pattern.index(i, j) {
                    stiffness[e] -= k;
                }
            });
        }
        let own = nonlinear_states(system);
        let states: Vec<usize> = model.states().iter().chain(&own).copied().collect();
        let linear_states = model.states().len();
        for (slot, _) in system.slots().iter().zip(left_out).filter(|x| *x.1) {
            for k in (0..states.len()).filter(|&k| slot.states.contains(&states[k])) {
                let i = system.n() + k;
                pattern.row(i).for_each(|(e, j)| stiffness[e] = if i == j { 1.0 } else { 0.0 });
                load[i] = 0.0;
            }
        }
        let mut stays = vec![false; pattern.n()];
        kept(system, &pattern, &stiffness, |i| load[i] != 0.0).into_iter().for_each(|i| stays[i] = true);
        for i in 0..pattern.n() {
            pattern.row(i).filter(|x| stays[i] || stays[x.1]).for_each(|(e, j)| stiffness[e] = if i == j { 1.0 } else { 0.0 });
        }
        let (plan, left_out) = (model.plan().clone(), left_out.to_vec());
        let raised: Vec<Raised> = raised.iter().filter(|r| !left_out[r.slot]).cloned().collect();
        let mut out = Equations { system, plan, pattern, stiffness, load, left_out, raised, states, linear_states, speed };
        for r in out.raised.clone().iter().filter(|r| system.slots()[r.slot].is_linear()) {
            let shift = r.shift();
            // K (x + shift) = K x - load
            out.each_entry(r.slot, &[], &[], |i, j, k| {
                let by: f64 = shift.iter().filter(|x| x.0 == j).map(|x| x.1).sum();
                (i, k * by)
            })
            .into_iter()
            .for_each(|(i, f)| out.load[i] -= f);
        }
        out
    }

    /// Number of unknowns: coordinates, then internal states.
    pub(super) fn unknowns(&self) -> usize {
        self.pattern.n()
    }

    /// Coordinates and those of the internal states that are unknown.
    pub(super) fn point(&self, at: &Statics) -> Vec<f64> {
        at.q.iter().copied().chain(self.states.iter().map(|&s| at.z[s])).collect()
    }

    /// What one part adds to the derivative of the residual: `f(row, column, value)` of every entry.
    pub(super) fn each_entry<T>(&self, slot: usize, x: &[f64], z: &[f64], mut f: impl FnMut(usize, usize, f64) -> T) -> Vec<T> {
        let part = &self.system.slots()[slot];
        let mut out = Vec::new();
        if part.is_linear() {
            forces::each_stiffness(self.system, part, self.speed, |i, j, k| out.push(f(i, j, k)));
            let unknown = |state: usize| self.unknown(state);
            forces::each_rate(self.system, part, self.speed, |state, j, k| {
                if let Some(i) = unknown(state) {
                    out.push(f(i, j, -k));
                }
            });
            return out;
        }
        let q = self.seen(slot, x);
        let t = self.derivatives(&q, z, |k| k == slot);
        self.each_derivative(&t, |i, j, k| out.push(f(i, j, k)));
        out
    }

    /// The unknown that is an internal state.
    fn unknown(&self, state: usize) -> Option<usize> {
        self.states.iter().position(|&s| s == state).map(|k| self.system.n() + k)
    }

    /// Coordinates as a part sees them.
    fn seen(&self, slot: usize, x: &[f64]) -> Vec<f64> {
        let q = &x[..self.system.n()];
        self.raised.iter().find(|r| r.slot == slot).map_or_else(|| q.to_vec(), |r| r.seen(q))
    }

    fn is_raised(&self, slot: usize) -> bool {
        self.raised.iter().any(|r| r.slot == slot)
    }

    /// Nonlinear parts that are raised.
    fn apart(&self) -> impl Iterator<Item = usize> {
        self.raised.iter().map(|r| r.slot).filter(|&k| !self.system.slots()[k].is_linear())
    }

    fn slot_of(&self, name: &str) -> usize {
        self.system.slots().iter().position(|s| s.name == name).unwrap_or(usize::MAX)
    }

    fn derivatives(&self, q: &[f64], z: &[f64], which: impl Fn(usize) -> bool) -> SparseTangent {
        let zero = vec![0.0; q.len()];
        let at = At { q, v: &zero, a: &zero, z, phase: 0.0, speed: self.speed, spin_accel: 0.0, t: 0.0 };
        let (mut t, mut scratch) = (SparseTangent::default(), TangentScratch::default());
        self.system.tangent(&at, false, &mut t, &mut scratch, |s| !s.is_linear() && which(self.slot_of(&s.name)));
        t
    }

    fn each_derivative(&self, t: &SparseTangent, mut f: impl FnMut(usize, usize, f64)) {
        let mut add = |i: Option<usize>, j: Option<usize>, x: f64| {
            if let Some((i, j)) = i.zip(j) {
                f(i, j, x);
            }
        };
        t.q.0.iter().for_each(|&(i, j, x)| add(Some(i), Some(j), x));
        t.z.0.iter().for_each(|&(i, j, x)| add(Some(i), self.unknown(j), x));
        t.rate_q.0.iter().for_each(|&(i, j, x)| add(self.unknown(i), Some(j), -x));
        t.rate_z.0.iter().for_each(|&(i, j, x)| add(self.unknown(i), self.unknown(j), -x));
    }

    fn nonlinear(&self) -> bool {
        self.system.slots().iter().zip(&self.left_out).any(|(s, out)| !s.is_linear() && !out)
    }

    /// `K x + n(x) - f0`.
    fn residual(&self, x: &[f64], z: &[f64]) -> Vec<f64> {
        let n = self.system.n();
        let complex = |v: &[f64]| v.iter().map(|&x| c(x, 0.0)).collect::<Vec<_>>();
        let terms = [(C64::ONE, &self.stiffness[..])];
        let short = Terms { pattern: &self.pattern, terms: &terms }.residual(&complex(x), &complex(&self.load));
        let mut r: Vec<f64> = short.iter().map(|r| -r.re).collect();
        if !self.nonlinear() {
            return r;
        }
        let zero = vec![0.0; n];
        let (mut force, mut rate, mut spin) = (zero.clone(), vec![0.0; self.system.m()], 0.0);
        let mut add = |q: &[f64], which: &dyn Fn(usize) -> bool| {
            let at = At { q, v: &zero, a: &zero, z, phase: 0.0, speed: self.speed, spin_accel: 0.0, t: 0.0 };
            let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            let which = |s: &crate::model::system::Slot| !s.is_linear() && which(self.slot_of(&s.name));
            self.system.residual(self.system.params(), &at, &mut rows, &mut Workspace::default(), which);
        };
        add(&x[..n], &|k| !self.left_out[k] && !self.is_raised(k));
        self.apart().for_each(|k| add(&self.seen(k, x), &|other| other == k));
        r.iter_mut().zip(&force).for_each(|(r, f)| *r += f);
        for (k, &state) in self.states.iter().enumerate().skip(self.linear_states) {
            r[n + k] -= rate[state];
        }
        r
    }

    /// Entries of the derivative of the residual.
    fn tangent(&self, x: &[f64], z: &[f64]) -> Vec<f64> {
        let mut out = self.stiffness.clone();
        if !self.nonlinear() {
            return out;
        }
        let n = self.system.n();
        let mut add = |i: usize, j: usize, x: f64| {
            if let Some(e) = self.pattern.index(i, j) {
                out[e] += x;
            }
        };
        self.each_derivative(&self.derivatives(&x[..n], z, |k| !self.left_out[k] && !self.is_raised(k)), &mut add);
        self.apart().for_each(|k| self.each_derivative(&self.derivatives(&self.seen(k, x), z, |other| other == k), &mut add));
        out
    }

    /// With ties held at these offsets, m, beside which springs act, N/m.
    pub(super) fn solve(&self, (q, z): (Vec<f64>, Vec<f64>), ties: &[Row], offsets: &[f64], spring: f64) -> Result<Statics, Diagnostic> {
        let n = self.system.n();
        let mut typical: Vec<f64> = self.system.coordinates().iter().map(|c| c.dof.typical).collect();
        typical.extend(self.states.iter().map(|&s| self.system.states()[s].dof.typical));
        let size = |x: &[f64]| max_abs(&x.iter().zip(&typical).map(|(x, t)| x / t).collect::<Vec<_>>());
        let mut at = Statics {
            speed: self.speed,
            q,
            z,
            holding: vec![0.0; ties.len()],
            left_out: self.left_out.clone(),
            raised: self.raised.clone(),
            iterations: 0,
            last_step: 0.0,
        };
        let mut x = self.point(&at);
        let target = |k: usize| offsets.get(k).copied().unwrap_or(0.0);
        let away = |x: &[f64]| -> Vec<f64> { ties.iter().enumerate().map(|(k, row)| along(row, x) - target(k)).collect() };
        let mut last = f64::INFINITY;
        for iteration in 1..=MOST_STEPS {
            let r = self.residual(&x, &at.z);
            if iteration == 1 && r.iter().all(|r| *r == 0.0) && away(&x).iter().all(|d| *d == 0.0) {
                return Ok(at);
            }
            let step = self.step(&x, &at.z, &r, (ties, &away(&x)), spring).ok_or_else(|| not_held(self.system, self.speed))?;
            x.iter_mut().zip(&step.0).for_each(|(x, s)| *x += s);
            at.holding = step.1;
            at.q.copy_from_slice(&x[..n]);
            self.states.iter().zip(&x[n..]).for_each(|(&s, &x)| at.z[s] = x);
            let (length, whole) = (size(&step.0), size(&x));
            (at.iterations, at.last_step) = (iteration, length);
            if length <= EXACT * whole || (length >= 0.5 * last && length <= NEAR * (whole + NEAR)) {
                return Ok(at);
            }
            last = length;
        }
        Err(unfound(self.system, self.speed, last))
    }

    /// Newton step and the forces at the ties, which are this far from their places; `None` where the matrix is singular.
    fn step(&self, x: &[f64], z: &[f64], r: &[f64], (ties, away): (&[Row], &[f64]), spring: f64) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut right: Vec<f64> = r.iter().map(|&r| -r).collect();
        for (row, away) in ties.iter().zip(away) {
            row.iter().for_each(|&(i, a)| right[i] -= spring * away * a);
        }
        let mut columns: Vec<Vec<f64>> = ties
            .iter()
            .map(|row| {
                let mut unit = vec![0.0; x.len()];
                row.iter().for_each(|&(i, a)| unit[i] = a);
                unit
            })
            .collect();
        columns.push(right);
        let mut columns = self.solved(x, z, columns, ties, spring)?;
        let mut step = columns.pop()?;
        let flexibility = Mat::from_fn(ties.len(), ties.len(), |i, j| along(&ties[i], &columns[j]));
        let left = ties.iter().zip(away).map(|(row, away)| -(away + along(row, &step))).collect();
        let holding = super::solved(&flexibility, left)?;
        for (v, l) in columns.iter().zip(&holding) {
            step.iter_mut().zip(v).for_each(|(s, v)| *s += l * v);
        }
        Some((step, holding))
    }

    /// The derivative of the residual, with springs at the ties, applied backwards to these columns; `None` where it is singular.
    pub(super) fn solved(&self, x: &[f64], z: &[f64], columns: Vec<Vec<f64>>, ties: &[Row], spring: f64) -> Option<Vec<Vec<f64>>> {
        let mut k: Vec<C64> = self.tangent(x, z).iter().map(|&k| c(k, 0.0)).collect();
        for row in ties {
            for &(i, a) in row {
                for &(j, b) in row {
                    k[self.pattern.index(i, j)?].re += spring * a * b;
                }
            }
        }
        let factors = Factors::new(&self.plan, &k).ok()?;
        if factors.pivot_ratio().is_nan() {
            return None;
        }
        let terms = [(C64::ONE, &k[..])];
        let exact = Terms { pattern: &self.pattern, terms: &terms };
        let one = |column: Vec<f64>| -> Option<Vec<f64>> {
            let mut b: Vec<C64> = column.into_iter().map(|x| c(x, 0.0)).collect();
            exact.solve(&factors, &mut b);
            let out: Vec<f64> = b.iter().map(|z| z.re).collect();
            out.iter().all(|x| x.is_finite()).then_some(out)
        };
        columns.into_iter().map(one).collect()
    }
}
