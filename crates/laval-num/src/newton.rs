//! Newton's method with exact tangents.
//!
//! Unknowns are divided by their scales; every equation is divided by the Euclidean length of its row of the scaled Jacobian, so the
//! result depends on the units of neither. A scaled residual is then never larger than the Newton step that belongs to it, and the
//! step is the estimate of the error. Steps may be damped by a line search on the scaled residual.

use crate::continuation::{Failure, Zero};
use crate::dense::{Lu, Mat, max_abs, norm};
use crate::refill::refill;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Tolerances and limits. Sizes are relative to the scales, or to the unknowns where these are larger than their scales.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Most Newton steps.
    pub max_iterations: usize,
    /// Largest step, in Euclidean length, at which a point counts as converged.
    pub step: f64,
    /// Largest scaled residual at which a point counts as converged.
    pub residual: f64,
    /// Scaled residual that is nothing but rounding: there a step that no longer shrinks also counts, if below `loose_step`.
    pub noise: f64,
    /// Largest step accepted at rounding level of the residual.
    pub loose_step: f64,
    /// Shorten steps until the residual falls.
    pub damped: bool,
    /// Without damping: give up when a step is longer than this times the one before.
    pub max_rate: f64,
    /// Go on after convergence until steps no longer shrink.
    pub to_rounding: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            max_iterations: 30,
            step: 1e-9,
            residual: 1e-9,
            noise: 1e-14,
            loose_step: 1e-6,
            damped: true,
            max_rate: 0.7,
            to_rounding: false,
        }
    }
}

/// Evidence of convergence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Converged {
    /// Newton steps taken.
    pub iterations: usize,
    /// Scaled residual at the point returned (largest entry).
    pub residual: f64,
    /// Newton step that would follow at the point returned: the estimate of its error, relative to the scales.
    pub step: f64,
    /// Second step over the first (0 where there was none): how nonlinear the way was.
    pub rate: f64,
}

/// Why Newton's method gave up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Cause {
    /// The residual no longer falls, or the iterations ran out.
    Stalled,
    /// Steps grow.
    Diverged,
    /// The Jacobian has no inverse.
    Singular,
    /// Residual, Jacobian or step is NaN or infinite.
    NotFinite,
    /// The problem could not be evaluated.
    Undefined(#[serde(deserialize_with = "crate::text::one")] crate::text::Text),
    /// The user stopped it.
    Cancelled,
}

impl From<Failure> for Cause {
    fn from(f: Failure) -> Self {
        match f {
            Failure::Undefined(why) => Cause::Undefined(why),
            Failure::Cancelled => Cause::Cancelled,
        }
    }
}

/// No convergence; the numbers are those of the last iterate that could be evaluated (NaN when there was none).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotConverged {
    /// Why.
    pub cause: Cause,
    /// Newton steps taken.
    pub iterations: usize,
    /// Scaled residual.
    pub residual: f64,
    /// Scaled Newton step.
    pub step: f64,
}

impl fmt::Display for NotConverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let why = match self.cause {
            Cause::Stalled => "stalled",
            Cause::Diverged => "diverged",
            Cause::Singular => "met a singular Jacobian",
            Cause::NotFinite => "met a number that is not finite",
            Cause::Undefined(why) => why,
            Cause::Cancelled => "was cancelled",
        };
        write!(f, "Newton's method: {why} (iterations {}, residual {:.2e}, step {:.2e})", self.iterations, self.residual, self.step)
    }
}
impl std::error::Error for NotConverged {}

/// Solves `r(x, p) = 0` for `x` at fixed `p`, starting at `x`. On failure `x` is left as it was.
pub fn newton(problem: &mut dyn Zero, x: &mut [f64], p: f64, options: &Options) -> Result<Converged, NotConverged> {
    let n = problem.dim();
    assert_eq!(x.len(), n, "length of the start differs from the number of unknowns");
    let mut scale = vec![1.0; n];
    problem.scale(&mut scale);
    let mut y: Vec<f64> = x.iter().zip(&scale).map(|(x, s)| x / s).collect();
    let mut at = vec![0.0; n];
    let done = Solver::default().solve(&mut FixedParameter { problem, scale: &scale, p, x: &mut at }, &mut y, options)?;
    for ((x, y), s) in x.iter_mut().zip(&y).zip(&scale) {
        *x = y * s;
    }
    Ok(done)
}

/// Square equations in scaled unknowns: what [`Solver`] solves.
pub(crate) trait System {
    fn size(&self) -> usize;
    /// `r` and `jac` (with respect to the scaled unknowns) arrive filled with zeros.
    fn eval(&mut self, y: &[f64], r: &mut [f64], jac: Option<&mut Mat>) -> Result<(), Failure>;
    fn cancelled(&self) -> bool;
}

/// The problem itself at a given parameter.
pub(crate) struct FixedParameter<'a> {
    pub problem: &'a mut dyn Zero,
    pub scale: &'a [f64],
    pub p: f64,
    /// Scratch.
    pub x: &'a mut [f64],
}

impl System for FixedParameter<'_> {
    fn size(&self) -> usize {
        self.scale.len()
    }
    fn eval(&mut self, y: &[f64], r: &mut [f64], mut jac: Option<&mut Mat>) -> Result<(), Failure> {
        for ((x, y), s) in self.x.iter_mut().zip(y).zip(self.scale) {
            *x = y * s;
        }
        self.problem.eval(self.x, self.p, r, jac.as_deref_mut(), None)?;
        if let Some(jac) = jac {
            for i in 0..self.scale.len() {
                for (a, s) in jac.row_mut(i).iter_mut().zip(self.scale) {
                    *a *= s;
                }
            }
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.problem.cancelled()
    }
}

/// Work done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Work {
    /// Evaluations of the residual.
    pub evaluations: usize,
    /// Of these, evaluations with Jacobian.
    pub jacobians: usize,
    /// Factorisations.
    pub factorisations: usize,
    /// Newton steps.
    pub iterations: usize,
}

/// Storage of Newton's method. After success `lu` holds the factors, rows scaled, at the point returned, or so close to it that Newton's step was below the tolerance.
#[derive(Default)]
pub(crate) struct Solver {
    pub lu: Lu,
    pub work: Work,
    jac: Mat,
    pub weight: Vec<f64>,
    y: Vec<f64>,
    r: Vec<f64>,
    delta: Vec<f64>,
    trial: Vec<f64>,
    r_trial: Vec<f64>,
}

#[derive(Clone, Copy)]
enum At {
    Iterate,
    Trial,
}

impl Solver {
    fn evaluate(&mut self, system: &mut dyn System, at: At, with_jac: bool) -> Result<(), Cause> {
        let n = system.size();
        let (y, r) = match at {
            At::Iterate => (&self.y, &mut self.r),
            At::Trial => (&self.trial, &mut self.r_trial),
        };
        refill(r, n, 0.0);
        self.work.evaluations += 1;
        if with_jac {
            self.work.jacobians += 1;
            self.jac.reset(n, n);
        }
        system.eval(y, r, with_jac.then_some(&mut self.jac))?;
        if max_abs(r).is_finite() { Ok(()) } else { Err(Cause::NotFinite) }
    }

    /// Divides the rows of the Jacobian and of the residual by the rows' lengths.
    fn weigh(&mut self) -> Result<(), Cause> {
        let n = self.r.len();
        self.weight.clear();
        for i in 0..n {
            let row = self.jac.row_mut(i);
            let mut w = row.iter().map(|a| a * a).sum::<f64>().sqrt();
            if !(1e-140..1e140).contains(&w) {
                w = norm(row);
            }
            if !w.is_finite() {
                return Err(Cause::NotFinite);
            }
            if w == 0.0 {
                return Err(Cause::Singular);
            }
            self.weight.push(w);
            self.r[i] /= w;
            let inverse = 1.0 / w;
            row.iter_mut().for_each(|a| *a *= inverse);
        }
        Ok(())
    }

    /// Solves from `y`; on failure `y` is left as it was.
    pub fn solve(&mut self, system: &mut dyn System, y: &mut [f64], o: &Options) -> Result<Converged, NotConverged> {
        let mut seen = NotConverged { cause: Cause::Stalled, iterations: 0, residual: f64::NAN, step: f64::NAN };
        self.y.clear();
        self.y.extend_from_slice(y);
        match self.iterate(system, o, &mut seen) {
            Ok(rate) => {
                y.copy_from_slice(&self.y);
                Ok(Converged { iterations: seen.iterations, residual: seen.residual, step: seen.step, rate })
            }
            Err(cause) => Err(NotConverged { cause, ..seen }),
        }
    }

    fn iterate(&mut self, system: &mut dyn System, o: &Options, seen: &mut NotConverged) -> Result<f64, Cause> {
        self.evaluate(system, At::Iterate, true)?;
        let (mut previous, mut rate) = (f64::INFINITY, 0.0);
        // the factors are those of the iterate before: so close to the root they serve as well
        let mut kept = false;
        loop {
            if system.cancelled() {
                return Err(Cause::Cancelled);
            }
            if kept {
                self.r.iter_mut().zip(&self.weight).for_each(|(r, w)| *r /= w);
            } else {
                self.weigh()?;
                self.work.factorisations += 1;
                self.lu.factor(&self.jac).map_err(|_| Cause::Singular)?;
            }
            let size = max_abs(&self.y).max(1.0);
            let residual = max_abs(&self.r);
            seen.residual = residual;
            self.delta.clear();
            self.delta.extend(self.r.iter().map(|r| -r));
            self.lu.solve(&mut self.delta);
            let step = self.delta.iter().zip(&self.y).map(|(d, y)| (d / y.abs().max(1.0)).powi(2)).sum::<f64>().sqrt();
            if !step.is_finite() {
                return Err(Cause::Singular);
            }
            seen.step = step;
            let (small, noise) = (step <= o.step && residual <= o.residual * size, residual <= o.noise * size);
            let stagnates = step > 0.25 * previous || step <= 2.0 * f64::EPSILON;
            if small && (!o.to_rounding || stagnates) || noise && stagnates && step <= o.loose_step {
                return Ok(rate);
            }
            if seen.iterations == o.max_iterations {
                return Err(if small { Cause::Stalled } else { slow(step, previous) });
            }
            if !o.damped && !noise && !small && step > o.max_rate * previous {
                return Err(Cause::Diverged);
            }
            if step > HOPELESS {
                return Err(Cause::Diverged);
            }
            kept = o.to_rounding && small;
            self.advance(system, o.damped && !noise && !small, residual, !kept)?;
            if seen.iterations == 1 {
                rate = step / previous;
            }
            previous = step;
            seen.iterations += 1;
            self.work.iterations += 1;
        }
    }

    /// Goes along `delta`, with damping only as far as the residual, weighed as before, falls; to a new Jacobian if `with_jac`.
    fn advance(&mut self, system: &mut dyn System, damped: bool, residual: f64, with_jac: bool) -> Result<(), Cause> {
        let mut length = 1.0;
        let mut last = Cause::Stalled;
        while length >= SHORTEST {
            self.trial.clear();
            self.trial.extend(self.y.iter().zip(&self.delta).map(|(y, d)| y + length * d));
            let full = length == 1.0;
            match self.evaluate(system, At::Trial, full && with_jac) {
                Ok(()) => {
                    let now = self.r_trial.iter().zip(&self.weight).map(|(r, w)| (r / w).abs()).fold(0.0, f64::max);
                    if !damped || now <= (1.0 - 1e-4 * length) * residual {
                        std::mem::swap(&mut self.y, &mut self.trial);
                        std::mem::swap(&mut self.r, &mut self.r_trial);
                        return if full { Ok(()) } else { self.evaluate(system, At::Iterate, true) };
                    }
                    last = Cause::Stalled;
                    // minimum of the parabola through the residual, its slope and the trial
                    length *= (0.5 * length * residual / (now - (1.0 - length) * residual)).clamp(0.1, 0.5);
                }
                Err(Cause::Cancelled) => return Err(Cause::Cancelled),
                Err(cause) if !damped => return Err(cause),
                Err(cause) => {
                    last = cause;
                    length *= 0.5;
                }
            }
        }
        Err(last)
    }
}

/// Steps beyond this many scales lead nowhere.
const HOPELESS: f64 = 1e12;
/// Shortest damped step.
const SHORTEST: f64 = 1e-4;

fn slow(step: f64, previous: f64) -> Cause {
    if step > previous { Cause::Diverged } else { Cause::Stalled }
}

#[cfg(test)]
mod tests;
