//! States at one speed followed over a parameter of the machine: how far a state goes on, and where it ends.
//!
//! Equations: `r(x, a; W) = 0` as in [`problem`](super::problem), with the parameter `a` in place of the speed W.
//!
//! A state ends where its branch turns back in the parameter: at a fold, where it meets another and both vanish, or at a pitchfork, where it meets its own
//! mirror image, as two balls that come together because they have nothing left. Both are located by the continuation, not by what the state looks like.

use super::SAME;
use super::problem::Stationary;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::continuation::{Direction, End, Failure, Kind, Settings, Status, Zero, trace};
use laval_num::dense::Mat;
use laval_num::newton::{Options, newton};
use std::sync::atomic::{AtomicBool, Ordering};

/// Steps over the range of the parameter, at least.
const STEPS: f64 = 50.0;
/// Most points of one branch.
const MOST_POINTS: usize = 2000;

/// The family of one machine over a parameter.
pub struct Along<'a> {
    system: &'a System,
    path: &'a str,
    parameters: Vec<usize>,
    speed: f64,
    /// In the parameter itself, or in its logarithm.
    by_ratio: bool,
    range: (f64, f64),
    scale: Vec<f64>,
    cancel: &'a AtomicBool,
}

/// How a state ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// Not within the range.
    Range,
    /// Its branch turns back: at this value, which lies between these.
    Turns {
        /// Value of the parameter.
        value: f64,
        /// Values around it.
        bracket: (f64, f64),
        /// The place where it turns was located, not bracketed only.
        located: bool,
    },
    /// It was not followed farther than the last point.
    Lost,
}

/// A state followed one way.
#[derive(Clone, Debug)]
pub struct Course {
    /// Values of the parameter and unknowns, from the start on; the last at the end.
    pub points: Vec<(f64, Vec<f64>)>,
    /// Where other branches cross it on the way: values between two points.
    pub crossed: Vec<f64>,
    /// How it ends.
    pub end: Ending,
}

impl<'a> Along<'a> {
    /// Of a machine at a speed, over this parameter between these values; by ratios where it spans decades.
    ///
    /// # Errors
    /// A parameter that the machine does not have.
    pub fn new(
        system: &'a System,
        path: &'a str,
        range: (f64, f64),
        by_ratio: bool,
        speed: f64,
        cancel: &'a AtomicBool,
    ) -> Result<Self, Diagnostic> {
        let parameters = system.param(path).ok_or_else(|| system.unknown_param(path))?;
        let problem = Stationary::new(system, 1.0, cancel);
        let mut scale = vec![1.0; problem.dim()];
        problem.scale(&mut scale);
        let by_ratio = by_ratio && range.0 > 0.0;
        Ok(Along { system, path, parameters, speed, by_ratio, range: (range.0.min(range.1), range.0.max(range.1)), scale, cancel })
    }

    fn of(&self, value: f64) -> f64 {
        if self.by_ratio { value.ln() } else { value }
    }

    fn value(&self, p: f64) -> f64 {
        // the ends themselves, of which the logarithm knows only the rounding
        let (lo, hi) = self.range;
        match p {
            p if p == self.of(lo) => lo,
            p if p == self.of(hi) => hi,
            p if self.by_ratio => p.exp(),
            p => p,
        }
    }

    /// Follows a state from a value towards larger or smaller ones.
    pub fn follow(&mut self, x: &[f64], from: f64, up: bool) -> Course {
        let (lo, hi) = (self.of(self.range.0), self.of(self.range.1));
        let start = self.of(from).clamp(lo, hi);
        let direction = if up { Direction::Up } else { Direction::Down };
        let lost = || Course { points: vec![(from, x.to_vec())], crossed: Vec::new(), end: Ending::Lost };
        let settings = Settings { max_points: MOST_POINTS, max_parameter_step: (hi - lo) / STEPS, min_step: 1e-9, ..Settings::new(lo, hi) };
        let Ok(branch) = trace(self, x, start, direction, &settings, &mut []) else { return lost() };
        if branch.points.is_empty() {
            return lost();
        }
        let turns = branch.specials.iter().find(|s| matches!(s.kind, Kind::Fold | Kind::ParameterExtremum));
        let last = turns.map_or(branch.points.len() - 1, |s| s.after);
        let mut points: Vec<(f64, Vec<f64>)> = branch.points[..=last].iter().map(|q| (self.value(q.p), q.x.clone())).collect();
        let passed = branch.of(Kind::BranchPoint).filter(|s| s.after <= last && turns.is_none_or(|t| t.after != s.after));
        let crossed = passed.map(|s| self.value(s.point.p)).collect();
        // a branch point in the same step is where it turns, and known better
        let exact = turns.and_then(|t| branch.specials.iter().find(|s| s.after == t.after && s.crossing.is_some())).or(turns);
        let end = match exact {
            Some(s) => {
                let value = self.value(s.point.p);
                points.push((value, s.point.x.clone()));
                let (a, b) = s.range();
                Ending::Turns { value, bracket: (self.value(a), self.value(b)), located: s.status != Status::Bracketed }
            }
            None if branch.end == End::Reached => Ending::Range,
            None => Ending::Lost,
        };
        Course { points, crossed, end }
    }

    /// The state of a course at a value of the parameter; `None` where the course does not reach or the state there is another.
    pub fn at(&mut self, course: &Course, value: f64) -> Option<Vec<f64>> {
        let pair = course.points.windows(2).find(|w| (w[0].0 - value) * (w[1].0 - value) <= 0.0);
        let [(a, p), (b, q)] =
            pair.map_or_else(|| course.points.iter().find(|point| point.0 == value).map(|point| [point, point]), |w| Some([&w[0], &w[1]]))?;
        let share = if a == b { 0.0 } else { (value - a) / (b - a) };
        let mut x: Vec<f64> = p.iter().zip(q).map(|(p, q)| p + share * (q - p)).collect();
        let apart = |x: &[f64], y: &[f64]| x.iter().zip(y).zip(&self.scale).map(|((x, y), s)| ((x - y) / s).abs()).fold(0.0, f64::max);
        let (chord, from) = (apart(p, q), x.clone());
        let options = Options { max_iterations: 60, to_rounding: true, noise: 1e-12, loose_step: 1e-7, ..Options::default() };
        let p = self.of(value);
        newton(self, &mut x, p, &options).ok()?;
        let apart = |x: &[f64], y: &[f64]| x.iter().zip(y).zip(&self.scale).map(|((x, y), s)| ((x - y) / s).abs()).fold(0.0, f64::max);
        (apart(&x, &from) <= 2.0 * chord + SAME).then_some(x)
    }
}

impl Zero for Along<'_> {
    fn dim(&self) -> usize {
        self.scale.len()
    }
    fn scale(&self, out: &mut [f64]) {
        out.copy_from_slice(&self.scale);
    }
    fn parameter_scale(&self) -> f64 {
        let (lo, hi) = (self.of(self.range.0), self.of(self.range.1));
        0.1 * (hi - lo).max(1e-6 * hi.abs()).max(f64::MIN_POSITIVE)
    }
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], jac: Option<&mut Mat>, mut dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
        let value = self.value(p);
        let machine =
            self.system.with(&[(self.path, value)]).map_err(|_| Failure::Undefined("the machine does not exist at this value"))?;
        let mut problem = Stationary::new(&machine, 1.0, self.cancel).varying(&self.parameters);
        problem.eval(x, self.speed, r, jac, dr_dp.as_deref_mut())?;
        if let Some(out) = dr_dp.filter(|_| self.by_ratio) {
            out.iter_mut().for_each(|d| *d *= value);
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}
