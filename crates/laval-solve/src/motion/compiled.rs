//! Constant speed and constant mass: x' = A x + B n(x) + u(phase), the linear parts as one dense matrix.

use super::direct::{Direct, memory_rows, singular};
use super::point;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::Rows;
use crate::model::system::{System, Workspace};
use crate::programme::Spin;
use laval_num::dense::{Lu, Mat};
use laval_num::ode::Failure;
use laval_num::scalar::Scalar;

/// The machine at one speed. Rows are the accelerations, then the rates of the linear parts' states without memory.
pub(crate) struct Compiled {
    pub model: LinearModel<f64>,
    /// Columns of the rows' dependence on (q, v, linear states): summing column by column lets the rows go in parallel.
    pub columns: Mat,
    /// Constant, then cosine and sine of the phase, then those of each other spin that turns loads.
    pub forcing: Vec<Vec<f64>>,
    /// Ratios of those spins.
    pub others: Vec<f64>,
    /// Coordinates that nonlinear parts and memory act on, and the rows' answer to a force on each.
    pub touched: Vec<usize>,
    pub answers: Mat,
    sum: Vec<f64>,
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
        let (b, loads) = (&model, &model.loads);
        let m = model.states().len();
        let mass = Mat::from_fn(n, n, |i, j| b.mass(i, j));
        let lu = Lu::new(&mass).map_err(|s| singular(system, s.column, mass.data()))?;
        // the force rows over (q, v, z, constant, cos, sin), solved for the accelerations
        let cols = 2 * n + m;
        let mut acting: Vec<&[f64]> = vec![&loads.force, &loads.force_cos, &loads.force_sin];
        acting.extend(loads.others.iter().flat_map(|o| &o.force).map(Vec::as_slice));
        let mut top = Mat::from_fn(n, cols + acting.len(), |i, j| match j {
            j if j < n => -b.stiffness(i, j),
            j if j < 2 * n => -b.damping(i, j - n),
            j if j < cols => -b.stiffness(i, j - n),
            j => acting[j - cols][i],
        });
        lu.solve_mat(&mut top);
        let state_a = Mat::from_fn(m, n, |i, j| b.mass(n + i, j));
        let bottom = state_a.matmul(&top);
        let own = |i: usize, j: usize| match j {
            j if j < n => b.stiffness(n + i, j),
            j if j < 2 * n => b.damping(n + i, j - n),
            j if j < cols => b.stiffness(n + i, j - n),
            j if j == cols => loads.rate[i],
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
            columns: Mat::from_fn(cols, n + m, |j, i| full(i, j)),
            sum: vec![0.0; n + m],
            forcing: (0..acting.len()).map(|k| (0..n + m).map(|i| full(i, cols + k)).collect()).collect(),
            others: loads.others.iter().map(|o| o.ratio).collect(),
            answers: Mat::from_fn(touched.len(), n + m, |j, i| if i < n { unit[(i, j)] } else { below[(i - n, j)] }),
            touched,
            nonlinear: system.slots().iter().any(|s| !s.is_linear()),
            force: vec![0.0; n],
            x: vec![0.0; cols],
            plain: Workspace::default(),
            model,
        })
    }

    /// The rows' answer to a force along a coordinate of a part, a sum over coordinates of the machine that nonlinear parts act on.
    pub fn answer(&self, coordinate: &[(usize, f64)]) -> Vec<f64> {
        let mut answer = vec![0.0; self.answers.cols()];
        for &(g, c) in coordinate {
            let Some(k) = self.touched.iter().position(|&t| t == g) else { continue };
            for (to, from) in answer.iter_mut().zip(self.answers.row(k)) {
                *to += c * from;
            }
        }
        answer
    }

    /// Fills `accel` and `rate` of `out`.
    pub(super) fn evaluate(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], out: &mut Direct) {
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
        for (x, &i) in self.x[2 * n..].iter_mut().zip(self.model.states()) {
            *x = y[2 * n + i];
        }
        // the same sine as the parts use, on every machine
        let (sin, cos) = Scalar::sin_cos(spin.phase);
        let (constant, fc, fs) = (&self.forcing[0], &self.forcing[1], &self.forcing[2]);
        for (i, sum) in self.sum.iter_mut().enumerate() {
            *sum = constant[i] + fc[i] * cos + fs[i] * sin;
        }
        for (ratio, turning) in self.others.iter().zip(self.forcing[3..].chunks(2)) {
            let (sin, cos) = Scalar::sin_cos(ratio * spin.phase);
            for (i, sum) in self.sum.iter_mut().enumerate() {
                *sum += turning[0][i] * cos + turning[1][i] * sin;
            }
        }
        for (j, &x) in self.x.iter().enumerate() {
            for (sum, a) in self.sum.iter_mut().zip(self.columns.row(j)) {
                *sum += a * x;
            }
        }
        for (j, &g) in self.touched.iter().enumerate() {
            let f = self.force[g];
            for (sum, a) in self.sum.iter_mut().zip(self.answers.row(j)) {
                *sum += a * f;
            }
        }
        out.accel[..n].copy_from_slice(&self.sum[..n]);
        for (&i, &r) in self.model.states().iter().zip(&self.sum[n..]) {
            out.rate[i] += r;
        }
    }
}
