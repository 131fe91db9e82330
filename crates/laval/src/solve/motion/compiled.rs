//! Constant speed and constant mass: x' = A x + B n(x) + u(phase), the linear parts as one dense matrix.

use super::direct::{Direct, memory_rows, singular};
use super::point;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::Rows;
use crate::model::system::{System, Workspace};
use crate::solve::programme::Spin;
use laval_num::dense::{Lu, Mat};
use laval_num::ode::Failure;

/// The machine at one speed. Rows are the accelerations, then the rates of the linear parts' states without memory.
pub(super) struct Compiled {
    model: LinearModel<f64>,
    /// Rows over (q, v, linear states).
    matrix: Mat,
    /// Constant, cosine and sine of the phase, row by row.
    forcing: Vec<[f64; 3]>,
    /// Coordinates that nonlinear parts and memory act on, and the rows' answer to a force on each.
    touched: Vec<usize>,
    answer: Mat,
    nonlinear: bool,
    force: Vec<f64>,
    x: Vec<f64>,
    plain: Workspace<f64>,
}

impl Compiled {
    pub fn new(system: &System, speed: f64) -> Result<Self, Failure> {
        let n = system.n();
        let mut model = LinearModel::default();
        system.linear(system.params(), speed, Form::Time, &mut model, &mut LinearScratch::default());
        let b = &model.blocks;
        let m = model.states.len();
        let mass = Mat::from_fn(n, n, |i, j| b.mass[(i, j)]);
        let lu = Lu::new(&mass).map_err(|s| singular(system, s.column, mass.data()))?;
        // the force rows over (q, v, z, constant, cos, sin), solved for the accelerations
        let cols = 2 * n + m;
        let mut top = Mat::from_fn(n, cols + 3, |i, j| match j {
            j if j < n => -(b.stiffness[(i, j)] + speed * b.circulatory[(i, j)]),
            j if j < 2 * n => -(b.damping[(i, j - n)] + speed * b.gyroscopic[(i, j - n)]),
            j if j < cols => -b.state_force[(i, j - 2 * n)],
            j => [b.force[i], b.force_cos[i], b.force_sin[i]][j - cols],
        });
        lu.solve_mat(&mut top);
        let state_a = Mat::from_fn(m, n, |i, j| b.state_a[(i, j)]);
        let bottom = state_a.matmul(&top);
        let own = |i: usize, j: usize| match j {
            j if j < n => b.state_q[(i, j)],
            j if j < 2 * n => b.state_v[(i, j - n)],
            j if j < cols => b.state[(i, j - 2 * n)],
            j if j == cols => b.rate[i],
            _ => 0.0,
        };
        let full = |i: usize, j: usize| if i < n { top[(i, j)] } else { bottom[(i - n, j)] + own(i - n, j) };
        let mut acts = vec![false; n];
        for slot in system.slots().iter().filter(|s| !s.is_linear() || s.memory > 0) {
            for &(g, _) in slot.map.iter().flatten() {
                acts[g] = true;
            }
        }
        let touched: Vec<usize> = (0..n).filter(|&g| acts[g]).collect();
        let mut unit = Mat::from_fn(n, touched.len(), |i, j| if i == touched[j] { -1.0 } else { 0.0 });
        lu.solve_mat(&mut unit);
        let below = state_a.matmul(&unit);
        Ok(Compiled {
            matrix: Mat::from_fn(n + m, cols, full),
            forcing: (0..n + m).map(|i| [full(i, cols), full(i, cols + 1), full(i, cols + 2)]).collect(),
            answer: Mat::from_fn(n + m, touched.len(), |i, j| if i < n { unit[(i, j)] } else { below[(i - n, j)] }),
            touched,
            nonlinear: system.slots().iter().any(|s| !s.is_linear()),
            force: vec![0.0; n],
            x: vec![0.0; cols],
            plain: Workspace::default(),
            model,
        })
    }

    /// Fills `accel` and `rate` of `out`.
    pub fn evaluate(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], out: &mut Direct) {
        let n = system.n();
        let at = point(system, t, spin, y, &out.zero);
        out.rate.fill(0.0);
        self.force.fill(0.0);
        if self.nonlinear {
            let mut ignored = 0.0;
            let mut rows = Rows { force: &mut self.force, rate: &mut out.rate, spin: &mut ignored };
            system.residual(system.params(), &at, &mut rows, &mut self.plain, |s| !s.is_linear());
        }
        memory_rows(system, &self.model, &at, &mut self.force, &mut out.rate);
        self.x[..2 * n].copy_from_slice(&y[..2 * n]);
        for (x, &i) in self.x[2 * n..].iter_mut().zip(&self.model.states) {
            *x = y[2 * n + i];
        }
        let (sin, cos) = spin.phase.sin_cos();
        for (i, [f0, fc, fs]) in self.forcing.iter().enumerate() {
            let mut sum = f0 + fc * cos + fs * sin;
            for (a, x) in self.matrix.row(i).iter().zip(&self.x) {
                sum += a * x;
            }
            for (a, &g) in self.answer.row(i).iter().zip(&self.touched) {
                sum += a * self.force[g];
            }
            if i < n {
                out.accel[i] = sum;
            } else {
                out.rate[self.model.states[i - n]] += sum;
            }
        }
    }
}
