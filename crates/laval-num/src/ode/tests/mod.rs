//! Tests of the integrators against closed forms, orders and published values.

mod driver;
mod events;
mod explicit;
mod stiff;
mod tableaux;
mod transition;

use super::*;
use crate::dense::Mat;

/// Uniform steps: tolerances so wide that the control always requires more than the longest step allowed.
pub(super) fn fixed(h: f64) -> Control<'static> {
    Control { first_step: Some(h), max_step: h, ..Control::new(0.0, 1e12) }
}

/// States (q, q', y) of q'' + 4 q = sin 3t, y' = y cos t: forced, nonlinear in nothing but its exact solution's dependence on time.
pub(super) struct Forced;

impl Forced {
    pub fn exact(t: f64) -> [f64; 3] {
        // q = (3/10) sin 2t - (1/5) sin 3t starts at rest
        [0.3 * (2.0 * t).sin() - 0.2 * (3.0 * t).sin(), 0.6 * (2.0 * t).cos() - 0.6 * (3.0 * t).cos(), t.sin().exp()]
    }
}

impl Ode for Forced {
    fn dim(&self) -> usize {
        3
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        dy.copy_from_slice(&[y[1], (3.0 * t).sin() - 4.0 * y[0], y[2] * t.cos()]);
        Ok(())
    }
}

impl StiffOde for Forced {
    fn jacobian(&mut self, t: f64, _: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        (jac[(0, 1)], jac[(1, 0)], jac[(2, 2)]) = (1.0, -4.0, t.cos());
        Ok(())
    }
}

/// y' = -2 t y^2, y = 1/(1 + t^2): nonlinear and non-autonomous.
pub(super) struct Bell;

impl Bell {
    pub fn exact(t: f64) -> f64 {
        1.0 / (1.0 + t * t)
    }
}

impl Ode for Bell {
    fn dim(&self) -> usize {
        1
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        dy[0] = -2.0 * t * y[0] * y[0];
        Ok(())
    }
}

impl StiffOde for Bell {
    fn jacobian(&mut self, t: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        jac[(0, 0)] = -4.0 * t * y[0];
        Ok(())
    }
}

/// Largest |a_i - b_i|, NaN if any is.
pub(super) fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    crate::dense::max_abs(&a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>())
}

/// Slope of log error over log step from errors at h, h/2, h/4, ...
pub(super) fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|e| (e[0] / e[1]).log2()).collect()
}

/// Error at `t1` and largest error between, each step sampled at 7 points, of `n` uniform steps on [`Forced`].
pub(super) fn forced_errors<M: Method<Forced>>(method: &mut M, t1: f64, n: usize) -> (f64, f64, f64) {
    let (mut y, mut inside, mut slope) = (Forced::exact(0.0), 0.0f64, 0.0f64);
    let mut watch = |s: &Step<'_>| {
        let (mut w, mut dw, mut f) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        for k in 1..8 {
            let t = s.t0 + (s.t1 - s.t0) * k as f64 / 8.0;
            s.eval(t, &mut w);
            s.eval_derivative(t, &mut dw);
            Forced.rhs(t, &Forced::exact(t), &mut f).unwrap();
            inside = inside.max(distance(&w, &Forced::exact(t)));
            slope = slope.max(distance(&dw, &f));
        }
    };
    let run = integrate(method, &mut Forced, 0.0, &mut y, t1, &fixed(t1 / n as f64), &mut watch);
    assert_eq!((run.end, run.work.steps, run.work.rejected), (End::Reached, n as u64, 0));
    (distance(&y, &Forced::exact(t1)), inside, slope)
}
