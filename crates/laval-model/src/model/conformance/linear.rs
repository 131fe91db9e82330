//! Promises of parts that have blocks or an impedance.

use super::{Bench, Promise, Pseudo, within};
use crate::model::blocks::{Axes, Blocks};
use crate::model::erased::{D1, Evaluate};
use crate::model::params::Parametric as _;
use crate::model::part::{Part, Physics, Rows, TimeForm};
use laval_num::complex::{C64, Complex, c};
use laval_num::dense::{Lu, Mat, Singular, max_abs};

impl<P: Part> Bench<'_, P> {
    pub(super) fn blocks(&mut self) {
        if Part::physics(self.part) == Physics::Nonlinear {
            return;
        }
        let states = self.states();
        for (k, x) in states.iter().enumerate() {
            let at = self.at(x);
            let b = self.blocks_at(at.speed);
            let (value, jacobian) = (self.eval(x), self.jacobian(x));
            let size = self.sizes(&value, &jacobian);
            // the part's own residual, if it writes one besides its blocks, must be the same
            let mut own = vec![0.0; self.n + self.m + 1];
            {
                let (force, rest) = own.split_at_mut(self.n);
                let (rate, spin) = rest.split_at_mut(self.m);
                let p = self.part.given(&self.params);
                Part::residual(self.part, &p, &at, &mut Rows { force, rate, spin: &mut spin[0] });
            }
            if own.iter().any(|o| *o != 0.0) {
                self.compare(Promise::Blocks, "residual beside blocks", &own, &value, &size, 1e-12);
            }
            // tangents are the blocks
            for (j, exact) in jacobian.iter().enumerate().take(self.spin_at()) {
                let column = b.column(j, self.n, at.spin_accel);
                let exact = &exact[..column.len()];
                self.compare(Promise::Blocks, &format!("block of {}", self.input_name(j)), &column, exact, &size, 1e-10);
            }
            // so is the derivative in the spin acceleration
            let turn = at.phase.sin_cos();
            let rows: Vec<f64> = (0..self.n).map(|i| b.0.spin_accel_row(i, &at, turn)).collect();
            let exact = &jacobian[self.spin_at() + 2][..self.n];
            self.compare(Promise::Blocks, "derivative in the spin acceleration", &rows, exact, &size, 1e-12);
            // superposition over states at the same spin, on what is linear: force rows and rates
            let other = &states[(k + 1) % states.len()];
            let (mut y, mut sum, mut zero) = (x.clone(), x.clone(), x.clone());
            for j in 0..self.spin_at() {
                (y[j], sum[j], zero[j]) = (other[j], x[j] + other[j], 0.0);
            }
            let (g, both, none) = (self.eval(&y), self.eval(&sum), self.eval(&zero));
            let split: Vec<f64> = (0..self.n + self.m).map(|i| value[i] + g[i] - none[i]).collect();
            let size: Vec<f64> = size.iter().zip(&g).map(|(s, g)| 2.0 * (s + g.abs())).collect();
            self.compare(Promise::Blocks, "sum of two states", &both[..self.n + self.m], &split, &size, 1e-12);
            for (grid, sign, name) in [(&b.0.mass, 1.0, "M"), (&b.0.gyroscopic, -1.0, "G"), (&b.0.circulatory, -1.0, "N")] {
                for (i, j) in (0..self.n).flat_map(|i| (grid.columns(i).start..=i).map(move |j| (i, j))) {
                    if !within(grid[(i, j)] - sign * grid[(j, i)], 1e-14, grid[(i, j)].abs()) {
                        self.fail(Promise::Blocks, format!("{name}[{i},{j}] breaks its symmetry"));
                    }
                }
            }
        }
    }
    /// What says that it is the same at every speed is, but for loads that turn, which grow with the square of the speed.
    pub(super) fn steady(&mut self) {
        if !self.part.extent().is_some_and(|e| e.is_steady()) {
            return;
        }
        let [slow, mut fast] = [0.2, 1.0].map(|share| Blocks { speed: 0.0, ..self.blocks_at(share * self.options.speed).0 });
        let mut squares = true;
        for (x, y) in [(&slow.force_cos, &mut fast.force_cos), (&slow.force_sin, &mut fast.force_sin)] {
            squares &= x.iter().zip(&*y).all(|(&x, &y)| within(x - 0.04 * y, 1e-14, y.abs()));
            y.clone_from(x);
        }
        if !squares || slow != fast || self.m > 0 {
            self.fail(Promise::Blocks, "blocks of a steady part change with the speed, or it has states".into());
        }
    }
    fn blocks_at(&self, speed: f64) -> Local {
        let mut b = Blocks::default();
        b.reset_band(self.n, self.m - Part::memory(self.part), self.part.extent().map_or(usize::MAX, |e| e.reach()), speed);
        Part::linear(self.part, &self.part.given(&self.params), speed, &mut b);
        Local(b)
    }

    pub(super) fn impedance(&mut self) {
        let Physics::Frequency(form) = Part::physics(self.part) else { return };
        let Some(part) = Part::frequency_domain(self.part) else {
            return self.fail(Promise::Impedance, "a part in the frequency domain that declares no impedance".into());
        };
        let n = self.n;
        let z = |s: C64, speed: f64| {
            let mut out = vec![C64::zero(); n * n];
            f64::impedance(part, &self.params, s, speed, &mut out);
            out
        };
        let largest = |z: &[C64]| max_abs(&z.iter().map(|z| z.abs()).collect::<Vec<_>>());
        let distance = |a: &[C64], b: &[C64]| largest(&a.iter().zip(b).map(|(&a, &b)| a - b).collect::<Vec<_>>());
        let mut random = Pseudo(23);
        let mut broken = Vec::new();
        for _ in 0..self.options.states {
            // motions with a frequency, that grow or decay with up to a tenth of it: a fit of a branch cut is none close to the cut
            let frequency = random.next();
            let s = c(0.1 * frequency * random.next(), frequency).scale(2.0 * self.options.speed);
            let speed = self.options.speed * (0.6 + 0.4 * random.next());
            let here = z(s, speed);
            let size = largest(&here);
            let mirrored: Vec<C64> = z(s.conj(), speed).iter().map(|z| z.conj()).collect();
            if !within(distance(&here, &mirrored), 1e-12, size) {
                broken.push("Z(conj s) differs from conj Z(s)".to_string());
            }
            let mut dual = vec![Complex::<D1>::zero(); n * n];
            let p: Vec<D1> = self.params.iter().map(|&x| D1::lift(x)).collect();
            D1::impedance(part, &p, Complex::cst(s), D1::seed(speed, 0), &mut dual);
            let exact: Vec<C64> = dual.iter().map(|z| c(z.re.eps[0], z.im.eps[0]).scale(speed)).collect();
            // a narrow resonance wants a small step, a flat curve a large one
            let agrees = [1e-3, 1e-4, 1e-5, 1e-6].into_iter().any(|step| {
                let f = [-2.0, -1.0, 1.0, 2.0].map(|k| z(s, speed * (1.0 + step * k)));
                let at = |i: usize| ((f[2][i] - f[1][i]).scale(8.0) - (f[3][i] - f[0][i])).scale(1.0 / (12.0 * step));
                let difference: Vec<C64> = (0..n * n).map(at).collect();
                within(distance(&exact, &difference), 1e-7, size + largest(&difference))
            });
            if !agrees {
                broken.push("derivative of Z over speed differs from central differences".into());
            }
            if let TimeForm::Fit(stated) = form {
                let fitted = local_stiffness(&self.blocks_at(speed).0, s);
                if !fitted.is_ok_and(|f| within(distance(f.data(), &here), stated, size)) {
                    broken.push(format!("the time form misses Z by more than the stated {stated:e} at s = {} + {} i", s.re, s.im));
                }
            }
        }
        for text in broken {
            self.fail(Promise::Impedance, text);
        }
    }
}

/// Blocks of one part as columns of its tangent.
struct Local(Blocks<f64>);

impl Local {
    /// Derivatives of force rows and rates over input `j` of (q, v, a, z), as the conventions of [`Blocks`] say.
    fn column(&self, j: usize, n: usize, spin_accel: f64) -> Vec<f64> {
        let b = &self.0;
        let (m, memory) = (b.state.rows(), b.memory.len());
        let mut out = vec![0.0; n + m + memory];
        let (group, k) = if j < 3 * n { (j / n, j % n) } else { (3, j - 3 * n) };
        for (i, o) in out.iter_mut().take(n).enumerate() {
            *o = match group {
                0 => b.stiffness.get(i, k) + b.speed * b.circulatory.get(i, k) + spin_accel * b.spin_accel_stiffness.get(i, k),
                1 => b.damping.get(i, k) + b.speed * b.gyroscopic.get(i, k),
                2 => b.mass.get(i, k),
                _ if k < m => b.state_force[(i, k)] + spin_accel * b.spin_accel_state_force[(i, k)],
                _ if b.memory[k - m].output == i => b.memory[k - m].gain,
                _ => 0.0,
            };
        }
        for i in 0..m {
            out[n + i] = match group {
                0 => b.state_q[(i, k)],
                1 => b.state_v[(i, k)],
                2 => b.state_a[(i, k)],
                _ if k < m => b.state[(i, k)],
                _ => 0.0,
            };
        }
        for (i, mem) in b.memory.iter().enumerate() {
            out[n + m + i] = match (group, mem.axes) {
                (0, _) if mem.input == k => 1.0,
                (3, _) if k == m + i => -mem.rate,
                (3, Axes::RotorX) if k == m + i + 1 => -b.speed,
                (3, Axes::RotorY) if k + 1 == m + i => b.speed,
                _ => 0.0,
            };
        }
        out
    }
}

/// Dynamic stiffness of one part's blocks at `s` (1/s), all states eliminated; an error at a pole.
pub fn local_stiffness(b: &Blocks<f64>, s: C64) -> Result<Mat<C64>, Singular> {
    let (n, states) = (b.mass.rows(), b.state.rows() + b.memory.len());
    let local = Local(b.clone());
    let tangent: Vec<Vec<f64>> = (0..3 * n + states).map(|j| local.column(j, n, 0.0)).collect();
    let s2 = s * s;
    let poly = |i: usize, j: usize| c(tangent[j][i], 0.0) + s.scale(tangent[n + j][i]) + s2.scale(tangent[2 * n + j][i]);
    let mut stiffness = Mat::from_fn(n, n, poly);
    if states > 0 {
        let pencil = Mat::from_fn(states, states, |i, j| if i == j { s } else { C64::zero() } - c(tangent[3 * n + j][n + i], 0.0));
        let mut driven = Mat::from_fn(states, n, |i, j| poly(n + i, j));
        Lu::new(&pencil)?.solve_mat(&mut driven);
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            for k in 0..states {
                stiffness[(i, j)] += driven[(k, j)].scale(tangent[3 * n + k][i]);
            }
        }
    }
    Ok(stiffness)
}
