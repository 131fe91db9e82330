//! The machine at rest under its weight and constant forces: deflections on the stiffness that its bearings have at a speed, and on rigid supports.
//!
//! ```text
//! K q + n(q) = f0 + B l,   B' q = 0        K without circulatory terms, n nonlinear parts, B places held, l the forces that hold them
//! ```
//!
//! Nothing turns: what a speed does to the rotor (circulatory terms, memory that turns with it) is left out; bearings have the coefficients of the stated speed.
//!
//! Theory: `docs/theory/shafts.md#sag`.

pub mod beam;
pub mod forces;
pub mod masses;
pub mod supports;

use crate::characteristic::nonlinear_states;
use crate::diagnostic::Diagnostic;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, DofKind, Rows};
use crate::model::station::Row;
use crate::model::system::{System, Workspace};
use crate::model::tangent::{SparseTangent, TangentScratch};
use crate::rest::{no_equilibrium, not_held, rest};
use laval_num::complex::{C64, c};
use laval_num::dense::{Field, Lu, Mat, max_abs};
use laval_num::factor::{Factors, Pattern, Plan, Terms};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A machine at rest.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Statics {
    /// Speed whose coefficients the bearings have, rad/s.
    pub speed: f64,
    /// Coordinates.
    pub q: Vec<f64>,
    /// Internal states of the whole machine.
    pub z: Vec<f64>,
    /// Forces on the places that are held, one for each component.
    pub holding: Vec<f64>,
    /// Parts that are left out, because their places are held.
    pub left_out: Vec<bool>,
    /// Newton steps taken.
    pub iterations: usize,
    /// Length of the last one relative to the typical sizes of the coordinates.
    pub last_step: f64,
}

/// Newton steps, at most.
const MOST_STEPS: usize = 40;
/// Step over the displacement that is rounding; at which steps that no longer fall are accepted.
const EXACT: f64 = 1e-14;
const NEAR: f64 = 1e-9;

/// On the stiffness that the parts have at a speed (rad/s).
///
/// # Errors
/// A machine without equilibrium, as [`rest`].
pub fn own(system: &System, speed: f64) -> Result<Statics, Diagnostic> {
    let equations = Equations::new(system, speed, &vec![false; system.slots().len()]);
    let start = if system.slots().iter().all(|s| s.is_linear()) {
        (vec![0.0; system.n()], vec![0.0; system.m()])
    } else {
        let found = rest(system, speed)?;
        (found.q, found.z)
    };
    equations.solve(start, &[], 0.0)
}

/// With places held instead of the parts that are left out; from the state on their stiffness.
///
/// # Errors
/// A machine that these places do not hold.
pub fn held(system: &System, from: &Statics, ties: &[Row], left_out: &[bool]) -> Result<Statics, Diagnostic> {
    let equations = Equations::new(system, from.speed, left_out);
    let vector = |i: &usize| matches!(system.coordinates()[*i].dof.kind, DofKind::VectorX | DofKind::VectorY);
    let (load, moved) =
        (0..system.n()).filter(vector).fold((0.0, 0.0f64), |(f, x), i| (f + equations.load[i].abs(), x.max(from.q[i].abs())));
    // springs beside the ties only make the matrix regular: they carry nothing
    let spring = if load > 0.0 && moved > 0.0 { load / moved } else { 1e6 };
    equations.solve((from.q.clone(), from.z.clone()), ties, spring)
}

struct Equations<'a> {
    system: &'a System,
    plan: Plan,
    pattern: Arc<Pattern>,
    /// Linear parts; K.
    stiffness: Vec<f64>,
    load: Vec<f64>,
    left_out: Vec<bool>,
    /// Global indices of the states among the unknowns; the number of those of linear parts.
    states: Vec<usize>,
    linear_states: usize,
    speed: f64,
}

impl<'a> Equations<'a> {
    fn new(system: &'a System, speed: f64, left_out: &[bool]) -> Self {
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
        // without a load along the axis, or a torque, a rotor stays where it is in that direction
        for kind in [DofKind::Axial, DofKind::Twist] {
            let of = |i: usize| i < system.n() && system.coordinates()[i].dof.kind == kind;
            if (0..system.n()).any(|i| of(i) && load[i] != 0.0) {
                continue;
            }
            for i in 0..system.n() {
                pattern.row(i).filter(|x| of(i) || of(x.1)).for_each(|(e, j)| stiffness[e] = if i == j { 1.0 } else { 0.0 });
            }
        }
        let (plan, left_out) = (model.plan().clone(), left_out.to_vec());
        Equations { system, plan, pattern, stiffness, load, left_out, states, linear_states, speed }
    }

    fn nonlinear(&self) -> bool {
        self.system.slots().iter().zip(&self.left_out).any(|(s, out)| !s.is_linear() && !out)
    }

    fn holds(&self, name: &str) -> bool {
        self.system.slots().iter().zip(&self.left_out).any(|(s, out)| s.name == name && !out)
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
        let at = At { q: &x[..n], v: &zero, a: &zero, z, phase: 0.0, speed: self.speed, spin_accel: 0.0, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        let which = |s: &crate::model::system::Slot| !s.is_linear() && self.holds(&s.name);
        self.system.residual(self.system.params(), &at, &mut rows, &mut Workspace::default(), which);
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
        let zero = vec![0.0; n];
        let at = At { q: &x[..n], v: &zero, a: &zero, z, phase: 0.0, speed: self.speed, spin_accel: 0.0, t: 0.0 };
        let (mut t, mut scratch) = (SparseTangent::default(), TangentScratch::default());
        self.system.tangent(&at, false, &mut t, &mut scratch, |s| !s.is_linear() && self.holds(&s.name));
        let unknown = |state: usize| self.states.iter().position(|&s| s == state).map(|k| n + k);
        let mut add = |i: Option<usize>, j: Option<usize>, x: f64| {
            if let Some(e) = i.zip(j).and_then(|(i, j)| self.pattern.index(i, j)) {
                out[e] += x;
            }
        };
        t.q.0.iter().for_each(|&(i, j, x)| add(Some(i), Some(j), x));
        t.z.0.iter().for_each(|&(i, j, x)| add(Some(i), unknown(j), x));
        t.rate_q.0.iter().for_each(|&(i, j, x)| add(unknown(i), Some(j), -x));
        t.rate_z.0.iter().for_each(|&(i, j, x)| add(unknown(i), unknown(j), -x));
        out
    }

    fn solve(&self, (q, z): (Vec<f64>, Vec<f64>), ties: &[Row], spring: f64) -> Result<Statics, Diagnostic> {
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
            iterations: 0,
            last_step: 0.0,
        };
        let mut x: Vec<f64> = at.q.iter().copied().chain(self.states.iter().map(|&s| at.z[s])).collect();
        let mut last = f64::INFINITY;
        for iteration in 1..=MOST_STEPS {
            let r = self.residual(&x, &at.z);
            if iteration == 1 && r.iter().all(|r| *r == 0.0) && ties.iter().all(|row| along(row, &x) == 0.0) {
                return Ok(at);
            }
            let step = self.step(&x, &at.z, &r, ties, spring).ok_or_else(|| not_held(self.system, self.speed))?;
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
        Err(no_equilibrium(last))
    }

    /// Newton step and the forces at the ties; `None` where the matrix is singular.
    fn step(&self, x: &[f64], z: &[f64], r: &[f64], ties: &[Row], spring: f64) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut k: Vec<C64> = self.tangent(x, z).iter().map(|&k| c(k, 0.0)).collect();
        let mut right: Vec<C64> = r.iter().map(|&r| c(-r, 0.0)).collect();
        for row in ties {
            let away = along(row, x);
            for &(i, a) in row {
                right[i].re -= spring * away * a;
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
        let solved = |mut b: Vec<C64>| -> Option<Vec<f64>> {
            exact.solve(&factors, &mut b);
            let out: Vec<f64> = b.iter().map(|z| z.re).collect();
            out.iter().all(|x| x.is_finite()).then_some(out)
        };
        let mut step = solved(right)?;
        let mut columns = Vec::with_capacity(ties.len());
        for row in ties {
            let mut unit = vec![C64::ZERO; x.len()];
            row.iter().for_each(|&(i, a)| unit[i].re = a);
            columns.push(solved(unit)?);
        }
        let flexibility = Mat::from_fn(ties.len(), ties.len(), |i, j| along(&ties[i], &columns[j]));
        let away = ties.iter().map(|row| -(along(row, x) + along(row, &step))).collect();
        let holding = self::solved(&flexibility, away)?;
        for (v, l) in columns.iter().zip(&holding) {
            step.iter_mut().zip(v).for_each(|(s, v)| *s += l * v);
        }
        Some((step, holding))
    }
}

/// Value of a combination of coordinates.
fn along(row: &Row, x: &[f64]) -> f64 {
    row.iter().map(|&(i, a)| a * x[i]).sum()
}

/// Solves a small system; `None` where it is singular.
fn solved(a: &Mat, mut b: Vec<f64>) -> Option<Vec<f64>> {
    if b.is_empty() {
        return Some(b);
    }
    let lu = Lu::new(a).ok().filter(|lu| lu.pivot_ratio() > 1e-13)?;
    lu.solve(&mut b);
    Some(b)
}
