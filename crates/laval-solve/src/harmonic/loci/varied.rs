//! A balance whose machine has one parameter that is varied with the unknowns and the speed: the ground loci of bifurcations stand on.
//!
//! The machine is assembled anew at every value, so that a parameter may enter anything: forces, masses, the place of a joint. Derivatives in the parameter are
//! central differences of exact residuals and Jacobians. They turn steps and tangents; where the equations vanish does not depend on them.

use crate::diagnostic::Diagnostics;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::balance::terms::Terms;
use crate::model::system::System;
use laval_num::continuation::{Failure, Zero};
use laval_num::dense::Mat;
use std::sync::atomic::Ordering;

/// Relative step of central differences: the cube root of the rounding unit.
pub(super) const STEP: f64 = 6e-6;

/// Part of the range of speeds by which a locus may leave it before it is cut off.
const MARGIN: f64 = 0.02;

/// See the [module](self).
pub struct Varied<'a> {
    system: &'a System,
    path: &'a str,
    /// Range of the parameter.
    pub range: (f64, f64),
    /// Range of the speed, rad/s.
    pub speeds: (f64, f64),
    balance: Balance<'a>,
    /// Balances evaluated so far.
    pub evaluations: u64,
}

impl<'a> Varied<'a> {
    /// The machine of a balance with the parameter of this path varied.
    pub fn new(system: &'a System, balance: Balance<'a>, path: &'a str, range: (f64, f64), speeds: (f64, f64)) -> Self {
        Varied { system, path, range, speeds, balance, evaluations: 0 }
    }

    /// The harmonics.
    pub fn terms(&self) -> &Terms {
        &self.balance.terms
    }
    /// Size of the unknowns.
    pub fn scales(&self) -> &[f64] {
        self.balance.scales()
    }
    /// Size of the speed, rad/s.
    pub fn speed_scale(&self) -> f64 {
        self.balance.parameter_scale()
    }
    /// Size of the parameter: its range.
    pub fn value_scale(&self) -> f64 {
        self.range.1 - self.range.0
    }
    /// Stopped by the user.
    pub fn cancelled(&self) -> bool {
        self.balance.cancelled()
    }

    /// The machine at a value of the parameter.
    ///
    /// # Errors
    /// Values its parts refuse.
    pub fn machine(&self, value: f64) -> Result<System, Diagnostics> {
        self.system.with(&[(self.path, value)])
    }

    /// Something of the balance at a value of the parameter.
    pub fn at<R>(&mut self, value: f64, f: impl FnOnce(&mut Balance) -> Result<R, Failure>) -> Result<R, Failure> {
        if self.cancelled() {
            return Err(Failure::Cancelled);
        }
        let system = self.machine(value).map_err(|_| Failure::Undefined("the machine does not exist at this value of the parameter"))?;
        let other = self.balance.of_other(&system);
        let mut balance = other.ok_or(Failure::Undefined("the nonlinear coordinates change with the parameter"))?;
        self.evaluations += 1;
        f(&mut balance)
    }

    /// Derivative in the parameter of what `f` gives; one-sided where the machine ends.
    pub fn slope(&mut self, value: f64, f: &dyn Fn(&mut Balance) -> Result<Vec<f64>, Failure>) -> Result<Vec<f64>, Failure> {
        let h = STEP * value.abs().max(0.01 * self.value_scale());
        let combine = |parts: &[(f64, &Vec<f64>)]| {
            let sum = |i: usize| parts.iter().map(|(c, v)| c * v[i]).sum::<f64>();
            (0..parts[0].1.len()).map(sum).collect::<Vec<f64>>()
        };
        match (self.at(value + h, f), self.at(value - h, f)) {
            (Err(Failure::Cancelled), _) | (_, Err(Failure::Cancelled)) => Err(Failure::Cancelled),
            (Ok(a), Ok(b)) => {
                let width = (value + h) - (value - h);
                Ok(combine(&[(1.0 / width, &a), (-1.0 / width, &b)]))
            }
            (a, b) => {
                let (side, one) = if let Ok(a) = a { (h, a) } else { (-h, b?) };
                let (own, two) = (self.at(value, f)?, self.at(value + 2.0 * side, f)?);
                Ok(combine(&[(-1.5 / side, &own), (2.0 / side, &one), (-0.5 / side, &two)]))
            }
        }
    }

    /// Whether a speed lies so far outside the range that a locus is cut off before.
    pub fn beyond(&self, speed: f64) -> bool {
        let (lo, hi) = self.speeds;
        let margin = (MARGIN * (hi - lo)).min(0.5 * lo.abs().min(hi.abs()));
        !(lo - margin..=hi + margin).contains(&speed)
    }
}

/// What a residual and its derivatives are at one point: r, dr/dx, dr/dspeed.
pub(super) fn linearised(balance: &mut Balance, x: &[f64], speed: f64) -> Result<(Vec<f64>, Mat, Vec<f64>), Failure> {
    let n = balance.dim();
    let (mut r, mut jac, mut by_speed) = (vec![0.0; n], Mat::zeros(n, n), vec![0.0; n]);
    balance.eval(x, speed, &mut r, Some(&mut jac), Some(&mut by_speed))?;
    Ok((r, jac, by_speed))
}

/// A stop requested through a flag.
pub(super) fn stopped(flag: &std::sync::atomic::AtomicBool) -> bool {
    flag.load(Ordering::Relaxed)
}
