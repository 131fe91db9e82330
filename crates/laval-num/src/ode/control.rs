//! Requirements of an integration and how it ended: tolerances, limits, work, and the choice of the first step.

use super::event::Event;
use super::system::{Failure, Ode};
use serde::{Deserialize, Serialize};

/// A tolerance, the same for all states or one for each.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// The same for every state.
    All(f64),
    /// One for each state.
    Each(Vec<f64>),
}

impl From<f64> for Tolerance {
    fn from(x: f64) -> Self {
        Tolerance::All(x)
    }
}
impl From<Vec<f64>> for Tolerance {
    fn from(x: Vec<f64>) -> Self {
        Tolerance::Each(x)
    }
}

impl Tolerance {
    fn load(&self, n: usize, out: &mut Vec<f64>) -> bool {
        out.clear();
        match self {
            Tolerance::All(x) => out.resize(n, *x),
            Tolerance::Each(x) => out.extend_from_slice(x),
        }
        out.len() == n && out.iter().all(|x| *x >= 0.0 && x.is_finite())
    }
}

/// Requirements of an integration.
///
/// The local error estimate e of a step from y to w is kept to rms(e_i / (a_i + r_i max(|y_i|, |w_i|))) < 1 with absolute tolerances a
/// (in the unit of the state) and relative tolerances r. A state that starts at zero is governed by a alone, which must
/// then not be zero.
#[derive(Clone)]
pub struct Control<'a> {
    /// Relative tolerance r.
    pub relative: Tolerance,
    /// Absolute tolerance a, in the unit of each state.
    pub absolute: Tolerance,
    /// Length of the first step; chosen from the problem if absent.
    pub first_step: Option<f64>,
    /// Longest step; the last of a run may be one percent longer.
    pub max_step: f64,
    /// Most steps, accepted and rejected together.
    pub max_steps: u64,
    /// Times of output, from `t0` to `t1` in the direction of integration.
    pub outputs: &'a [f64],
    /// Events to locate.
    pub events: &'a [Event<'a>],
    /// Polled before every step; `true` ends the integration. Reading an atomic flag here is the usual way to stop on Ctrl-C.
    pub cancel: Option<&'a dyn Fn() -> bool>,
}

impl Control<'_> {
    /// Tolerances, no limit on the step, ten million steps, no outputs, no events.
    pub fn new(relative: impl Into<Tolerance>, absolute: impl Into<Tolerance>) -> Self {
        Control {
            relative: relative.into(),
            absolute: absolute.into(),
            first_step: None,
            max_step: f64::INFINITY,
            max_steps: 10_000_000,
            outputs: &[],
            events: &[],
            cancel: None,
        }
    }
}

/// Work done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Work {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps, those of failed Newton iterations included.
    pub rejected: u64,
    /// Evaluations of the right side.
    pub rhs: u64,
    /// Evaluations of the Jacobian.
    pub jacobians: u64,
    /// Factorisations, each of one real and one complex matrix.
    pub factorisations: u64,
    /// Newton iterations, each of one real and one complex solution.
    pub iterations: u64,
}

/// Why a step was rejected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Cause {
    /// The error estimate exceeded the tolerance.
    Error,
    /// A value was not finite.
    NotFinite,
    /// Newton's iteration did not converge with a Jacobian of this step.
    Newton,
    /// The matrix of the implicit system was singular.
    Singular,
}

/// How an integration ended. The state reached until then is always kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum End {
    /// The final time was reached.
    Reached,
    /// A terminal event occurred.
    Event {
        /// Index in [`Control::events`].
        index: usize,
        /// When.
        t: f64,
    },
    /// No step above the resolution of `t` succeeded.
    StepTooSmall {
        /// Where.
        t: f64,
        /// Why the last step was rejected.
        cause: Cause,
    },
    /// The right side, the Jacobian or an event failed, or the request is inconsistent.
    Failed {
        /// Where.
        t: f64,
        /// Why.
        what: Failure,
    },
    /// [`Control::max_steps`] is used up.
    WorkLimit {
        /// Where.
        t: f64,
    },
    /// [`Control::cancel`] said so.
    Cancelled {
        /// Where.
        t: f64,
    },
}

/// Result of an integration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Time of the state reached.
    pub t: f64,
    /// How it ended.
    pub end: End,
    /// Length of the step the control would take next: the first step of a continued run.
    pub next_step: f64,
    /// Work done.
    pub work: Work,
}

/// Outcome of one attempted step, with the factor the control proposes for the step length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attempt {
    /// The step meets the tolerance.
    Accepted {
        /// Proposed length of the next step over that of this one.
        factor: f64,
    },
    /// The step must be repeated.
    Rejected {
        /// Proposed length of the next trial over that of this one, below 1.
        factor: f64,
        /// Why.
        cause: Cause,
    },
}

impl Attempt {
    pub(super) fn not_finite() -> Self {
        Attempt::Rejected { factor: 0.2, cause: Cause::NotFinite }
    }
}

/// Calls the right side and counts; `false` if a value is not finite.
pub(super) fn evaluate<S: Ode + ?Sized>(system: &mut S, t: f64, y: &[f64], dy: &mut [f64], work: &mut Work) -> Result<bool, Failure> {
    work.rhs += 1;
    system.rhs(t, y, dy)?;
    Ok(finite(dy))
}

/// All entries finite.
#[inline(always)]
pub(super) fn finite(x: &[f64]) -> bool {
    // no branch per entry
    !x.iter().fold(false, |bad, x| bad | !x.is_finite())
}

/// Tolerances state by state.
#[derive(Clone, Debug, Default)]
pub(super) struct Scale {
    pub abs: Vec<f64>,
    pub rel: Vec<f64>,
}

impl Scale {
    pub fn load(&mut self, control: &Control, n: usize) -> Result<(), Failure> {
        let ok = control.relative.load(n, &mut self.rel) & control.absolute.load(n, &mut self.abs);
        if !ok || self.abs.iter().zip(&self.rel).any(|(a, r)| a + r <= 0.0) {
            return Err("tolerances must be finite and not negative, one of each state positive, and as many as the states".into());
        }
        Ok(())
    }

    /// Scale of state `i` of size `y`.
    #[inline(always)]
    pub fn at(&self, i: usize, y: f64) -> f64 {
        self.abs[i] + self.rel[i] * y
    }

    /// rms of e_i / scale_i at the state `y`; a zero entry counts as zero whatever its scale.
    pub fn norm(&self, e: &[f64], y: &[f64]) -> f64 {
        self.rms(e, |i| y[i].abs())
    }

    /// rms of e_i / scale_i at the larger of the states `y` and `w`.
    pub fn norm2(&self, e: &[f64], y: &[f64], w: &[f64]) -> f64 {
        self.rms(e, |i| y[i].abs().max(w[i].abs()))
    }

    fn rms(&self, e: &[f64], size: impl Fn(usize) -> f64) -> f64 {
        let mut sum = 0.0;
        for (i, &e) in e.iter().enumerate() {
            if e != 0.0 {
                let q = e / self.at(i, size(i));
                sum += q * q;
            }
        }
        (sum / e.len().max(1) as f64).sqrt()
    }

    /// First step of a method whose error estimate is of order `order`: one explicit Euler step estimates the second derivative
    /// (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.4). `f0` is f(t, y); `w`, `f1` are scratch.
    #[allow(clippy::too_many_arguments)]
    pub fn first_step<S: Ode + ?Sized>(
        &self,
        system: &mut S,
        (t, span): (f64, f64),
        order: f64,
        y: &[f64],
        f0: &[f64],
        w: &mut [f64],
        f1: &mut [f64],
        work: &mut Work,
    ) -> Result<f64, Failure> {
        let (d0, d1) = (self.norm(y, y), self.norm(f0, y));
        let ratio = 0.01 * d0 / d1;
        let h0 = if d0 < 1e-5 || d1 < 1e-5 || !(ratio > 0.0 && ratio.is_finite()) { 1e-6 } else { ratio };
        let h0 = h0.min(span.abs());
        for ((w, y), f) in w.iter_mut().zip(y).zip(f0) {
            *w = y + h0.copysign(span) * f;
        }
        if !evaluate(system, t + h0.copysign(span), w, f1, work)? {
            return Ok(1e-3 * h0);
        }
        for (f, g) in f1.iter_mut().zip(f0) {
            *f -= g;
        }
        let d2 = self.norm(f1, y) / h0;
        let d = if d2 > d1 { d2 } else { d1 };
        let h1 = if d <= 1e-15 { (h0 * 1e-3).max(1e-6) } else { (0.01 / d).powf(1.0 / (order + 1.0)) };
        let h = (100.0 * h0).min(h1).min(span.abs());
        Ok(if h > 0.0 { h } else { 1e-3 * h0 })
    }
}
