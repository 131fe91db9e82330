//! First derivatives of the motion of all coordinates: in the unknowns of the balance, in the speed, in parameters of the machine.

use crate::harmonic::balance::condense::lossy;
use crate::harmonic::balance::problem::{Balance, NO_RESPONSE};
use laval_num::complex::C64;
use laval_num::continuation::Failure;
use laval_num::dense::Mat;

impl Balance<'_> {
    /// Derivatives of [`Balance::motion`] in the unknowns, order by order: rows as there, a column for each unknown; with the residual's in `jac`.
    pub fn motion_tangent(&mut self, x: &[f64], speed: f64, jac: &mut Mat) -> Result<Vec<Mat<C64>>, Failure> {
        self.set_speed(speed).map_err(|_| Failure::Undefined(NO_RESPONSE))?;
        let unknowns = self.terms.unknowns;
        let mu = self.nonlinear.basis.rows.len();
        let mut forces = Mat::zeros(unknowns, unknowns);
        self.project(x, speed, Some(&mut forces), None);
        jac.copy_from(&self.linear);
        for i in 0..unknowns {
            for (j, f) in jac.row_mut(i).iter_mut().zip(forces.row(i)) {
                *j += f;
            }
        }
        let m = self.nonlinear.kinds.len();
        let (mut u, mut f) = (vec![C64::zero(); m], vec![C64::zero(); m]);
        let (mut unit, mut column) = (vec![0.0; unknowns], vec![0.0; unknowns]);
        let mut out = Vec::with_capacity(self.orders.len());
        for (order, &k) in self.orders.iter().zip(&self.terms.orders) {
            let mut slopes = Mat::zeros(order.free.len(), unknowns);
            for c in 0..unknowns {
                unit[c] = 1.0;
                (0..unknowns).for_each(|i| column[i] = forces[(i, c)]);
                self.terms.amplitudes(&unit, k, &mut u);
                self.terms.amplitudes(&column, k, &mut f);
                unit[c] = 0.0;
                for i in 0..order.free.len() {
                    for j in 0..mu {
                        slopes[(i, c)] -= order.spread[(i, j)] * (f[j] - u[j] * lossy(k, self.condenser.reference[j]));
                    }
                }
            }
            out.push(slopes);
        }
        Ok(out)
    }

    /// Derivatives of the residual (put into `rates`) and of [`Balance::motion`], order by order, in the speed or the parameter of
    /// [`Balance::differentiate_by`], the unknowns held.
    pub fn motion_rates(&mut self, x: &[f64], speed: f64, rates: &mut [f64]) -> Result<Vec<Vec<C64>>, Failure> {
        self.set_speed(speed).map_err(|_| Failure::Undefined(NO_RESPONSE))?;
        let mu = self.nonlinear.basis.rows.len();
        let mut forces = vec![0.0; self.terms.unknowns];
        self.project(x, speed, None, Some(&mut forces));
        for ((r, f), l) in rates.iter_mut().zip(&forces).zip(&self.load_speed) {
            *r = f - l;
        }
        self.linear_speed.mul_vec_add(x, rates);
        let mut f = vec![C64::zero(); self.nonlinear.kinds.len()];
        let mut out = Vec::with_capacity(self.orders.len());
        for which in 0..self.orders.len() {
            let k = self.terms.orders[which];
            self.terms.amplitudes(x, k, &mut self.amplitudes);
            self.force_amplitudes(k);
            self.terms.amplitudes(&forces, k, &mut f);
            let order = &self.orders[which];
            let slopes = (0..order.free.len()).map(|i| {
                (0..mu).fold(order.free_speed[i], |sum, j| {
                    let held = self.forces[j] - self.amplitudes[j] * lossy(k, self.condenser.reference[j]);
                    sum - order.spread_speed[(i, j)] * held - order.spread[(i, j)] * f[j]
                })
            });
            out.push(slopes.collect());
        }
        Ok(out)
    }
}
