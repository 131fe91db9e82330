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
        self.condense(speed, true).map_err(|_| Failure::Undefined(NO_RESPONSE))?;
        let mut forces = vec![0.0; self.terms.unknowns];
        self.project(x, speed, None, Some(&mut forces));
        for ((r, f), l) in rates.iter_mut().zip(&forces).zip(&self.load_speed) {
            *r = f - l;
        }
        self.linear_speed.mul_vec_add(x, rates);
        let still = vec![0.0; x.len()];
        Ok((0..self.orders.len()).map(|which| self.moved(x, which, (&still, &forces, 1.0))).collect())
    }

    /// Derivative of [`Balance::motion`], order by order, along a direction of the unknowns and the speed.
    pub fn motion_along(&mut self, (x, speed): (&[f64], f64), (dx, rate): (&[f64], f64)) -> Result<Vec<Vec<C64>>, Failure> {
        self.condense(speed, true).map_err(|_| Failure::Undefined(NO_RESPONSE))?;
        let unknowns = self.terms.unknowns;
        let (mut tangent, mut forces) = (Mat::zeros(unknowns, unknowns), vec![0.0; unknowns]);
        self.project(x, speed, Some(&mut tangent), Some(&mut forces));
        forces.iter_mut().for_each(|f| *f *= rate);
        tangent.mul_vec_add(dx, &mut forces);
        Ok((0..self.orders.len()).map(|which| self.moved(x, which, (dx, &forces, rate))).collect())
    }

    /// Change of the motion at one order with changes of the unknowns, of the nonlinear forces on the terms, and of the speed, of the motion projected last.
    fn moved(&mut self, x: &[f64], which: usize, (dx, df, rate): (&[f64], &[f64], f64)) -> Vec<C64> {
        let (m, mu, k) = (self.nonlinear.kinds.len(), self.nonlinear.basis.rows.len(), self.terms.orders[which]);
        let (mut du, mut f) = (vec![C64::zero(); m], vec![C64::zero(); m]);
        self.terms.amplitudes(x, k, &mut self.amplitudes);
        self.force_amplitudes(k);
        self.terms.amplitudes(df, k, &mut f);
        self.terms.amplitudes(dx, k, &mut du);
        let (order, reference) = (&self.orders[which], &self.condenser.reference);
        let held: Vec<C64> = (0..mu).map(|j| (self.forces[j] - self.amplitudes[j] * lossy(k, reference[j])).scale(rate)).collect();
        let change: Vec<C64> = (0..mu).map(|j| f[j] - du[j] * lossy(k, reference[j])).collect();
        let row = |i: usize| {
            let start = order.free_speed[i].scale(rate);
            (0..mu).fold(start, |sum, j| sum - order.spread_speed[(i, j)] * held[j] - order.spread[(i, j)] * change[j])
        };
        (0..order.free.len()).map(row).collect()
    }
}
