//! The equations of a state that turns with the rotor, as a family over the spin speed.
//!
//! ```text
//! r(x, W) = T_linear(0; W) x + f(q, W J q, W^2 J^2 q, z; W) - p(W) = 0
//! ```
//!
//! x are the coordinates q at spin angle 0 and those states that are not eliminated, J the quarter turn of vectors and tilts (0 for coordinates that do not
//! turn), T_linear the characteristic matrix of linear and frequency-domain parts in turning axes, f the nonlinear parts. Derivatives are exact.

use crate::characteristic::{Equilibrium, Frame, coordinate_sectors, nonlinear_states, state_sectors};
use crate::model::blocks::Grid;
use crate::model::erased::D1;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, Rows};
use crate::model::system::{System, Workspace};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::sectors::{Sector, Sectors};
use laval_num::complex::{Complex, c};
use laval_num::continuation::{Failure, Zero};
use laval_num::dense::Mat;
use laval_num::dual::Dual;
use std::sync::atomic::{AtomicBool, Ordering};

/// The family of one machine; keeps its scratch.
pub struct Stationary<'a> {
    /// The machine.
    pub system: &'a System,
    /// Typical size of a change of the speed, rad/s.
    pub speed_scale: f64,
    /// Forces from outside: coordinate, force (N; of angles N m).
    pub load: Vec<(usize, f64)>,
    cancel: &'a AtomicBool,
    params: Vec<D1>,
    /// 1 where the parameter of the family is the speed, 0 where it is another.
    by_speed: f64,
    /// Global indices of the states among the unknowns: those of linear parts, then those of nonlinear ones.
    states: Vec<usize>,
    linear_states: usize,
    coordinates: Sectors,
    all_states: Sectors,
    sectors: Sectors,
    model: LinearModel<D1>,
    scratch: LinearScratch<D1>,
    grid: Grid<Complex<D1>>,
    tangent: Tangent,
    tangent_scratch: TangentScratch,
    workspace: Workspace<D1>,
}

impl<'a> Stationary<'a> {
    /// For a machine without preferred direction.
    pub fn new(system: &'a System, speed_scale: f64, cancel: &'a AtomicBool) -> Self {
        let linear = system.assembly(Form::Frequency).states.clone();
        let linear_states = linear.len();
        let states: Vec<usize> = linear.into_iter().chain(nonlinear_states(system)).collect();
        let coordinates = coordinate_sectors(system);
        Stationary {
            sectors: Sectors::chain(&[&coordinates, &state_sectors(system, &states)]),
            all_states: Sectors::new(system.states().iter().map(|s| s.dof.kind)),
            params: system.params().iter().map(|&x| Dual::lift(x)).collect(),
            system,
            load: Vec::new(),
            by_speed: 1.0,
            speed_scale,
            cancel,
            states,
            linear_states,
            coordinates,
            model: LinearModel::default(),
            scratch: LinearScratch::default(),
            grid: Grid::empty(),
            tangent: Tangent::default(),
            tangent_scratch: TangentScratch::default(),
            workspace: Workspace::default(),
        }
    }

    /// With the derivative of these parameters, changed together, in place of that of the speed.
    pub fn varying(mut self, parameters: &[usize]) -> Self {
        self.by_speed = 0.0;
        for (i, p) in self.params.iter_mut().enumerate() {
            p.eps = [if parameters.contains(&i) { 1.0 } else { 0.0 }];
        }
        self
    }

    /// The state as an equilibrium in turning axes.
    pub fn equilibrium(&self, x: &[f64], speed: f64) -> Equilibrium {
        let n = self.system.n();
        let mut out = Equilibrium::zero(self.system, Frame::Turning, speed);
        out.q.copy_from_slice(&x[..n]);
        for (&s, &x) in self.states.iter().zip(&x[n..]) {
            out.z[s] = x;
        }
        out
    }

    /// Residual of the linear parts, its derivatives in x and W (or what [varies](Self::varying)).
    fn linear(&mut self, x: &[f64], speed: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) {
        let (n, size) = (self.system.n(), x.len());
        self.system.linear(&self.params, Dual { re: speed, eps: [self.by_speed] }, Form::Frequency, &mut self.model, &mut self.scratch);
        let held = n + self.linear_states;
        let (mut value, mut slope) = (Mat::zeros(size, size), Mat::zeros(size, size));
        for kind in [Sector::Axial, Sector::Forward, Sector::Backward] {
            let k = kind.winding();
            let s = c(Dual { re: 0.0, eps: [0.0] }, Dual { re: k * speed, eps: [k * self.by_speed] });
            self.system.dynamic_stiffness(&self.params, &self.model, Form::Frequency, s, &mut self.grid, &mut self.scratch);
            let (mut v, mut d) = (Mat::zeros(size, size), Mat::zeros(size, size));
            for i in 0..held {
                for j in 0..held {
                    let e = self.grid[(i, j)];
                    (v[(i, j)], d[(i, j)]) = (c(e.re.re, e.im.re), c(e.re.eps[0], e.im.eps[0]));
                }
            }
            self.sectors.polarise_matrix(&self.sectors, &mut v);
            self.sectors.polarise_matrix(&self.sectors, &mut d);
            for j in (0..size).filter(|&j| self.sectors.of(j) == kind) {
                for i in 0..size {
                    (value[(i, j)], slope[(i, j)]) = (v[(i, j)], d[(i, j)]);
                }
            }
        }
        self.sectors.restore_matrix(&self.sectors, &mut value);
        self.sectors.restore_matrix(&self.sectors, &mut slope);
        let b = &self.model.loads;
        let load = |i: usize| {
            let l = if i < n { b.force[i] + b.force_cos[i] } else { b.rate[i - n] };
            (l.re, l.eps[0])
        };
        for i in 0..held {
            r[i] += (0..size).map(|j| value[(i, j)].re * x[j]).sum::<f64>() - load(i).0;
        }
        if let Some(out) = dr_dp {
            for i in 0..held {
                out[i] += (0..size).map(|j| slope[(i, j)].re * x[j]).sum::<f64>() - load(i).1;
            }
        }
        if let Some(jac) = jac {
            for i in 0..held {
                for j in 0..size {
                    jac[(i, j)] += value[(i, j)].re;
                }
            }
        }
    }

    /// The same of the nonlinear parts.
    fn nonlinear(&mut self, x: &[f64], speed: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) {
        let (n, m) = (self.system.n(), self.system.m());
        let held = n + self.linear_states;
        let at = self.equilibrium(x, speed);
        let jq = self.coordinates.quarter_turn(&at.q);
        let jjq = self.coordinates.quarter_turn(&jq);
        let by_speed = self.by_speed;
        let dual = |re: f64, eps: f64| Dual { re, eps: [eps * by_speed] };
        let q: Vec<D1> = at.q.iter().map(|&x| dual(x, 0.0)).collect();
        let v: Vec<D1> = jq.iter().map(|&x| dual(speed * x, x)).collect();
        let a: Vec<D1> = jjq.iter().map(|&x| dual(speed * speed * x, 2.0 * speed * x)).collect();
        let z: Vec<D1> = at.z.iter().map(|&x| dual(x, 0.0)).collect();
        let (mut force, mut rate, mut spin) = (vec![dual(0.0, 0.0); n], vec![dual(0.0, 0.0); m], dual(0.0, 0.0));
        let o = dual(0.0, 0.0);
        let point = At { q: &q, v: &v, a: &a, z: &z, phase: o, speed: dual(speed, 1.0), spin_accel: o, t: o };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        self.system.residual(&self.params, &point, &mut rows, &mut self.workspace, |s| !s.is_linear());
        let turned = self.all_states.quarter_turn(&at.z);
        let own = &self.states[self.linear_states..];
        for i in 0..n {
            r[i] += force[i].re;
        }
        for (k, &s) in own.iter().enumerate() {
            r[held + k] += speed * turned[s] - rate[s].re;
        }
        if let Some(out) = dr_dp {
            for i in 0..n {
                out[i] += force[i].eps[0];
            }
            for (k, &s) in own.iter().enumerate() {
                out[held + k] += self.by_speed * turned[s] - rate[s].eps[0];
            }
        }
        let Some(jac) = jac else { return };
        let (v, a): (Vec<f64>, Vec<f64>) = (v.iter().map(|x| x.re).collect(), a.iter().map(|x| x.re).collect());
        let point = At { q: &at.q, v: &v, a: &a, z: &at.z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let t = &mut self.tangent;
        self.system.tangent(&point, false, t, &mut self.tangent_scratch, |s| !s.is_linear());
        let total = |k: &Mat, d: &Mat, m: &Mat| {
            let dj = self.coordinates.times_quarter_turn(d);
            let mjj = self.coordinates.times_quarter_turn(&self.coordinates.times_quarter_turn(m));
            Mat::from_fn(k.rows(), k.cols(), |i, j| k[(i, j)] + speed * dj[(i, j)] + speed * speed * mjj[(i, j)])
        };
        let (top, bottom) = (total(&t.q, &t.v, &t.a), total(&t.rate_q, &t.rate_v, &t.rate_a));
        let turn = self.all_states.times_quarter_turn(&Mat::identity(m));
        for i in 0..n {
            for j in 0..n {
                jac[(i, j)] += top[(i, j)];
            }
            for (k, &s) in own.iter().enumerate() {
                jac[(i, held + k)] += t.z[(i, s)];
            }
        }
        for (k, &s) in own.iter().enumerate() {
            for j in 0..n {
                jac[(held + k, j)] -= bottom[(s, j)];
            }
            for (l, &u) in own.iter().enumerate() {
                jac[(held + k, held + l)] += speed * turn[(s, u)] - t.rate_z[(s, u)];
            }
        }
    }
}

impl Zero for Stationary<'_> {
    fn dim(&self) -> usize {
        self.system.n() + self.states.len()
    }
    fn scale(&self, out: &mut [f64]) {
        let coordinates = self.system.coordinates().iter().map(|c| c.dof.typical);
        let states = self.states.iter().map(|&s| self.system.states()[s].dof.typical);
        out.iter_mut().zip(coordinates.chain(states)).for_each(|(o, t)| *o = t);
    }
    fn parameter_scale(&self) -> f64 {
        self.speed_scale
    }
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], mut jac: Option<&mut Mat>, mut dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
        self.linear(x, p, r, jac.as_deref_mut(), dr_dp.as_deref_mut());
        self.nonlinear(x, p, r, jac, dr_dp);
        for &(i, force) in &self.load {
            r[i] -= force;
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}
