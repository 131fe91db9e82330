//! Machines with many coordinates: matrices as entries, whose factors cost in proportion to the number of coordinates.
//!
//! ```text
//! T(s) = A0 + s A1 + s^2 A2    over coordinates and internal states, the Laplace transform of the linearised equations
//! M a = -r(q, v, a = 0, z)
//! (s I - J) x = b:    T(s) (dq, dz) = A2 (b_v + s b_q) + A1 b_q + (0, b_z),    dv = s dq - b_q
//! ```
//!
//! For machines of constant mass without memory states and of more than a few coordinates. M is factored once, T(s) for each length of a step. With
//! b = M^-1 f - s w (M with the identity for places and states) the forces -r stand in place of A2 b_v, and nothing is divided by M.

use super::direct::{Direct, linear_rows, singular};
use super::point;
use crate::characteristic::each_tangent_entry;
use crate::equilibrium::nonlinear_states;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, Rows};
use crate::model::rows::{LinearRows, Padded};
use crate::model::system::{System, Workspace};
use crate::model::tangent::{SparseTangent, TangentScratch};
use crate::programme::Spin;
use laval_num::complex::C64;
use laval_num::dense::Singular;
use laval_num::factor::{Factors, Number, Selection};
use laval_num::ode::Failure;
use std::sync::Arc;

/// States up to which full matrices are kept.
const FEW: usize = 24;
/// Speeds at which the linear parts are kept: of the stages of a step, and of its start.
const KEPT: usize = 4;
/// Pivot over the largest below which the mass matrix is singular to rounding.
const SINGULAR: f64 = 1e-13;
/// Applications of J that its spectral radius is estimated by, after as many before them.
const GROWTH: i32 = 16;

/// The machine by entries.
pub(super) struct Large {
    /// Linear parts at the latest speeds, the last one first.
    models: Vec<Linear>,
    /// Their rows at any speed, where there are such.
    any_speed: Option<LinearRows>,
    /// The spin has one speed throughout.
    one_speed: bool,
    scratch: LinearScratch<f64>,
    coordinates: Arc<Selection>,
    mass: Factors<f64>,
    factored: Vec<f64>,
    /// Global indices of the internal states in the order of the unknowns.
    states: Vec<usize>,
    z: Vec<f64>,
    zero: Vec<f64>,
    padded: Padded,
    sum: Vec<f64>,
    plain: Workspace<f64>,
    tangent: SparseTangent,
    tangents: TangentScratch,
    terms: [Vec<f64>; 3],
    /// A1 and A2 in the columns of coordinates.
    rates: Rates,
    shifted: Shifted,
}

/// Linear parts at a speed, and their rows where these serve.
struct Linear {
    model: LinearModel<f64>,
    rows: Option<LinearRows>,
}

/// Highest speed of rows at any speed where the machine stands, rad/s.
const ANY: f64 = 100.0;

/// Factors of T at a real and a complex place, and room for right sides.
#[derive(Default)]
struct Shifted {
    at: (f64, C64),
    real: Factors<f64>,
    complex: Factors<C64>,
    rows: [Vec<f64>; 2],
    complex_rows: [Vec<C64>; 2],
}

/// Rows of A1 and A2: column and both values, and where each row ends.
#[derive(Default)]
struct Rates {
    ends: Vec<usize>,
    entries: Vec<(usize, f64, f64)>,
}

impl Rates {
    fn fill(&mut self, model: &LinearModel<f64>, [_, a1, a2]: &[Vec<f64>; 3], n: usize) {
        self.ends.clear();
        self.entries.clear();
        for i in 0..model.pattern().n() {
            let row = model.pattern().row(i).take_while(|x| x.1 < n).map(|(e, j)| (j, a1[e], a2[e]));
            self.entries.extend(row.filter(|x| x.1 != 0.0 || x.2 != 0.0));
            self.ends.push(self.entries.len());
        }
    }
    /// `A1 x + A2 y`.
    fn apply<T: Number>(&self, x: &[T], y: &[T], out: &mut Vec<T>) {
        out.clear();
        let mut from = 0;
        out.extend(self.ends.iter().map(|&end| {
            let row = &self.entries[from..end];
            from = end;
            row.iter().fold(T::ZERO, |sum, &(j, a1, a2)| sum + x[j].times(a1) + y[j].times(a2))
        }));
    }
}

impl Large {
    /// `None` of a machine that is not large, or not of this kind; `constant` says that its mass matrix is. It begins at `speed` and turns no faster than `fastest`; at `speed` alone without.
    ///
    /// # Errors
    /// A singular mass matrix.
    pub fn new(system: &System, constant: bool, speed: f64, fastest: Option<f64>) -> Result<Option<Self>, Failure> {
        if !(constant && 2 * system.n() + system.m() > FEW && system.slots().iter().all(|s| s.memory == 0)) {
            return Ok(None);
        }
        let any_speed = fastest.and_then(|top| LinearRows::of_any_speed(system, if top == 0.0 { ANY } else { top }));
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        system.linear(system.params(), speed, Form::Time, &mut model, &mut scratch);
        let rows = if any_speed.is_none() { LinearRows::new(&model) } else { None };
        let linear = Linear { rows, model };
        let model = &linear.model;
        let mut out = Large {
            coordinates: model.selection(&(0..system.n()).collect::<Vec<_>>()),
            states: model.states().iter().copied().chain(nonlinear_states(system)).collect(),
            models: vec![linear],
            any_speed,
            one_speed: fastest.is_none(),
            scratch,
            mass: Factors::default(),
            factored: Vec::new(),
            z: Vec::new(),
            zero: vec![0.0; system.n()],
            padded: Padded::default(),
            sum: Vec::new(),
            plain: Workspace::default(),
            tangent: SparseTangent::default(),
            tangents: TangentScratch::default(),
            terms: Default::default(),
            rates: Rates::default(),
            shifted: Shifted::default(),
        };
        out.factor_mass(system)?;
        // NaN fails
        if !(out.mass.pivot_ratio() > SINGULAR) {
            return Err(singular(system, system.n() - 1, &out.factored));
        }
        Ok(Some(out))
    }

    /// The mass matrix is that of any speed: the same at all stages of a step.
    pub fn has_constant_mass(&self) -> bool {
        self.any_speed.is_some() || self.one_speed
    }

    /// Assembles the linear parts at a speed, or finds them.
    fn assemble(&mut self, system: &System, speed: f64) -> Result<(), Failure> {
        // also where both are NaN
        if let Some(k) = self.models.iter().position(|m| m.model.speed.to_bits() == speed.to_bits()) {
            self.models[..=k].rotate_right(1);
            return Ok(());
        }
        let reused = if self.models.len() < KEPT { None } else { self.models.pop() };
        let mut model = reused.map(|l| l.model).unwrap_or_default();
        system.linear(system.params(), speed, Form::Time, &mut model, &mut self.scratch);
        self.models.insert(0, Linear { rows: None, model });
        if self.any_speed.is_some() {
            return Ok(());
        }
        let linear = &mut self.models[0];
        linear.rows = LinearRows::new(&linear.model);
        if self.models[0].model.mass_values() == self.factored { Ok(()) } else { self.factor_mass(system) }
    }

    fn factor_mass(&mut self, system: &System) -> Result<(), Failure> {
        let values = self.models[0].model.mass_values();
        self.factored.clear();
        self.factored.extend_from_slice(values);
        self.mass.factor(&self.coordinates.inner, &self.coordinates.taken(values)).map_err(|s| singular(system, s.column, values))
    }

    /// Fills `accel` and `rate` of `out`.
    ///
    /// # Errors
    /// A mass matrix that is singular at this speed.
    pub fn evaluate(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], out: &mut Direct) -> Result<(), Failure> {
        let n = system.n();
        let (force, rate) = (&mut out.accel[..n], &mut out.rate[..]);
        self.residual(system, t, spin, y, force, rate)?;
        self.mass.solve(force);
        let model = &self.models[0].model;
        for (k, &i) in model.states().iter().enumerate() {
            let row = model.pattern().row(n + k).take_while(|x| x.1 < n);
            rate[i] += row.map(|(e, j)| model.mass_values()[e] * force[j]).sum::<f64>();
        }
        Ok(())
    }

    /// Velocities, forces and rates at zero accelerations: M times the rates of all states.
    ///
    /// # Errors
    /// As [`Large::evaluate`].
    pub fn forces(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], f: &mut [f64]) -> Result<(), Failure> {
        let (n, m) = (system.n(), system.m());
        let (velocities, rest) = f.split_at_mut(n);
        velocities.copy_from_slice(&y[n..2 * n]);
        let (force, rate) = rest.split_at_mut(n);
        self.residual(system, t, spin, y, force, &mut rate[..m])
    }

    /// Forces and rates at zero accelerations.
    fn residual(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], force: &mut [f64], rate: &mut [f64]) -> Result<(), Failure> {
        if self.any_speed.is_none() {
            self.assemble(system, spin.speed)?;
        }
        let n = system.n();
        let Linear { model, rows } = &self.models[0];
        let at = point(system, t, spin, y, &self.zero);
        rate.fill(0.0);
        match self.any_speed.as_ref().or(rows.as_ref()) {
            Some(rows) => {
                self.z.clear();
                self.z.extend(model.states().iter().map(|&i| at.z[i]));
                self.sum.resize(model.held(), 0.0);
                rows.residual(&At { z: &self.z, ..at }, &mut self.padded, &mut self.sum);
                force.copy_from_slice(&self.sum[..n]);
                model.states().iter().zip(&self.sum[n..]).for_each(|(&i, r)| rate[i] = *r);
            }
            None => {
                force.fill(0.0);
                linear_rows(system, model, &at, force, rate, &mut self.z, &mut self.sum);
            }
        }
        let mut ignored = 0.0;
        let mut rows = Rows { force: &mut *force, rate: &mut *rate, spin: &mut ignored };
        system.residual(system.params(), &at, &mut rows, &mut self.plain, |s| !s.is_linear());
        force.iter_mut().for_each(|f| *f = -*f);
        Ok(())
    }

    /// A0, A1, A2 at a point with the right accelerations.
    pub fn linearise(&mut self, system: &System, at: &At<f64>) -> Result<(), Failure> {
        self.assemble(system, at.speed)?;
        let Large { models, states, tangent: t, tangents, terms, .. } = self;
        let (model, n) = (&models[0].model, system.n());
        *terms = model.polynomial();
        model.add_spin_accel(at.spin_accel, &mut terms[0]);
        system.tangent(at, false, t, tangents, |s| !s.is_linear());
        each_tangent_entry(t, model.pattern(), (n, model.held()), states, |power, e, x| terms[power][e] += x);
        self.rates.fill(&self.models[0].model, &self.terms, n);
        Ok(())
    }

    /// Factors T at both shifts.
    pub fn factor(&mut self, real: f64, complex: C64) -> Result<(), Singular> {
        let plan = self.models[0].model.plan();
        self.shifted.at = (real, complex);
        self.shifted.real.factor(plan, &at(&self.terms, real))?;
        self.shifted.complex.factor(plan, &at(&self.terms, complex))
    }

    /// Solves `(s I - J) x = b` in place at the real shift.
    pub fn solve_real(&mut self, n: usize, b: &mut [f64]) {
        let Shifted { at, real, rows, .. } = &mut self.shifted;
        solve((n, &self.states, &self.rates), at.0, real, b, rows);
    }

    /// The same at the complex one.
    pub fn solve_complex(&mut self, n: usize, b: &mut [C64]) {
        let Shifted { at, complex, complex_rows, .. } = &mut self.shifted;
        solve((n, &self.states, &self.rates), at.1, complex, b, complex_rows);
    }

    /// Solves `(s I - J) x = M^-1 f - s w` in place of f at the real shift.
    pub fn solve_real_forces(&mut self, n: usize, f: &mut [f64], w: &[f64]) {
        let Shifted { at, real, rows, .. } = &mut self.shifted;
        solve_forces((n, &self.states, &self.rates), at.0, real, (f, w), rows);
    }

    /// The same at the complex one.
    pub fn solve_complex_forces(&mut self, n: usize, f: &mut [C64], w: &[C64]) {
        let Shifted { at, complex, complex_rows, .. } = &mut self.shifted;
        solve_forces((n, &self.states, &self.rates), at.1, complex, (f, w), complex_rows);
    }

    /// Size of the largest eigenvalues of J, 1/s, by its powers at the last linearisation, in coordinates whose masses are one; internal states are left out.
    pub fn spectral_radius(&self, n: usize) -> f64 {
        let (model, plan) = (&self.models[0].model, &self.coordinates.inner);
        let pattern = model.pattern();
        let scale: Vec<f64> = (0..n).map(|i| model.mass(i, i).abs().sqrt()).collect();
        let [a0, a1, _] = &self.terms;
        let applied = |q: &[f64], v: &[f64]| -> Vec<f64> {
            let row = |i: usize| pattern.row(i).take_while(|x| x.1 < n).map(|(e, j)| a0[e] * q[j] + a1[e] * v[j]).sum::<f64>();
            let mut force: Vec<f64> = (0..plan.n()).map(|i| -row(i)).collect();
            self.mass.solve(&mut force);
            force
        };
        // displacements in units of the radius found so far, so that both halves count
        let (mut unit, mut x) = (1.0f64, [vec![0.0; n], vec![0.0; n]]);
        x[1].iter_mut().enumerate().for_each(|(i, v)| *v = (1.0 + 0.3 * (1.7 * i as f64).sin()) * if i % 2 == 0 { 1.0 } else { -1.0 });
        let norm = |x: &[Vec<f64>; 2], unit: f64| -> f64 {
            let square = |x: &[f64]| x.iter().zip(&scale).map(|(x, s)| (x * s) * (x * s)).sum::<f64>();
            (unit * unit * square(&x[0]) + square(&x[1])).sqrt()
        };
        let mut rate = 0.0;
        for _ in 0..2 {
            let (mut growth, mut last) = (0.0, norm(&x, unit));
            for _ in 0..GROWTH {
                let force = applied(&x[0], &x[1]);
                let [q, v] = x;
                (x, _) = ([v, force], q);
                let size = norm(&x, unit);
                growth += (size / last).ln();
                x.iter_mut().flatten().for_each(|x| *x /= size);
                last = 1.0;
            }
            rate = (growth / f64::from(GROWTH)).exp();
            unit = rate;
        }
        rate
    }
}

/// `A0 + s A1 + s^2 A2`.
fn at<T: Number>([a0, a1, a2]: &[Vec<f64>; 3], s: T) -> Vec<T> {
    let square = s * s;
    a0.iter().zip(a1).zip(a2).map(|((&a0, &a1), &a2)| T::real(a0) + s.times(a1) + square.times(a2)).collect()
}

/// Solves `(s I - J) x = M^-1 f - s w` in place of f.
fn solve_forces<T: Number>(
    (n, states, rates): (usize, &[usize], &Rates),
    s: T,
    factors: &Factors<T>,
    (f, w): (&mut [T], &[T]),
    [moved, right]: &mut [Vec<T>; 2],
) {
    for (f, w) in f.iter_mut().zip(w).take(n) {
        *f -= s * *w;
    }
    moved.clear();
    moved.extend((0..n).map(|i| s * (f[i] - w[n + i])));
    rates.apply(&f[..n], moved, right);
    for (right, f) in right.iter_mut().zip(&f[n..2 * n]) {
        *right += *f;
    }
    for (k, &z) in states.iter().enumerate() {
        right[n + k] += f[2 * n + z] - s * w[2 * n + z];
    }
    factors.solve(right);
    for i in 0..n {
        let dq = right[i];
        f[n + i] = s * dq - f[i];
        f[i] = dq;
    }
    for (k, &z) in states.iter().enumerate() {
        f[2 * n + z] = right[n + k];
    }
    for (f, w) in f.iter_mut().zip(w).skip(2 * n + states.len()) {
        *f = *f / s - *w;
    }
}

/// Solves `(s I - J) x = b` in place with the factors of T(s); the numbers behind the states are integrals.
fn solve<T: Number>((n, states, rates): (usize, &[usize], &Rates), s: T, factors: &Factors<T>, b: &mut [T], rows: &mut [Vec<T>; 2]) {
    let [moved, right] = rows;
    moved.clear();
    moved.extend((0..n).map(|i| b[n + i] + s * b[i]));
    rates.apply(&b[..n], moved, right);
    for (k, &z) in states.iter().enumerate() {
        right[n + k] += b[2 * n + z];
    }
    factors.solve(right);
    for i in 0..n {
        let dq = right[i];
        b[n + i] = s * dq - b[i];
        b[i] = dq;
    }
    for (k, &z) in states.iter().enumerate() {
        b[2 * n + z] = right[n + k];
    }
    for x in &mut b[2 * n + states.len()..] {
        *x = *x / s;
    }
}
