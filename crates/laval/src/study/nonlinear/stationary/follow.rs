//! A state that balances, followed over a parameter: from where to where it is one, and why it ends there.

use super::classify::{Scale, Seen};
use super::least::{Assessed, assess};
use super::{Varied, alone, changed, wide};
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::solve::stationary::along::{Along, Course, Ending};
use crate::solve::stationary::{Request, Search, State};
use laval_num::univariate::root;
use serde::{Deserialize, Serialize};
use std::sync::atomic::AtomicBool;

/// Halvings of the interval in which a state ceases to be one that balances.
const HALVINGS: usize = 40;

/// Why a state that balances is followed no farther.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Why {
    /// It ends: its branch turns back, or another crosses it beyond which it does not balance.
    Exists,
    /// It goes on, and leaves more than half of the unbalance.
    Half,
    /// It was not followed beyond.
    Lost,
}

/// Where it is followed no farther.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Limit {
    pub value: f64,
    pub why: Why,
    /// Values around it.
    pub bracket: (f64, f64),
    /// To rounding.
    pub located: bool,
}

/// A state followed one way.
pub struct Reach {
    course: Course,
    /// `None` where it goes on to the end of the range.
    pub limit: Option<Limit>,
}

/// Follows states of one machine at one speed.
pub struct Follower<'a> {
    system: &'a System,
    path: &'a str,
    speed: f64,
    along: Along<'a>,
    own: Request,
    cancel: &'a AtomicBool,
}

impl<'a> Follower<'a> {
    /// Over a range of a parameter at a speed.
    ///
    /// # Errors
    /// A parameter that the machine does not have.
    pub fn new(system: &'a System, requested: &'a Varied, request: &Request, cancel: &'a AtomicBool) -> Result<Self, Diagnostic> {
        Self::between(system, &requested.path, &requested.range, requested.speed, request, cancel)
    }

    /// The same.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn between(
        system: &'a System,
        path: &'a str,
        range: &RangeValue,
        speed: f64,
        request: &Request,
        cancel: &'a AtomicBool,
    ) -> Result<Self, Diagnostic> {
        let along = Along::new(system, path, (range.from, range.to), wide(range), speed, cancel)?;
        Ok(Follower { system, path, speed, along, own: alone(request, speed), cancel })
    }

    /// The state near `x` at a value of the parameter.
    fn assessed(&self, x: &[f64], value: f64) -> Option<Assessed> {
        let machine = changed(self.system, self.path, value).ok()?;
        let mut search = Search::new(&machine, &self.own, self.cancel);
        assess(&machine, &mut search, x, self.speed)
    }

    fn balances(&self, x: &[f64], value: f64) -> Option<bool> {
        let machine = changed(self.system, self.path, value).ok()?;
        let mut search = Search::new(&machine, &self.own, self.cancel);
        let scale = Scale::at(&machine, &mut search, self.speed);
        let state = State { branch: 0, speed: self.speed, x: x.to_vec(), error: 0.0 };
        Some(Seen::of(&machine, &search, &state).class(&scale).balances())
    }

    /// From a state that balances at a value towards larger values or smaller ones.
    pub fn reach(&mut self, x: &[f64], from: f64, up: bool) -> Reach {
        let mut course = self.along.follow(x, from, up);
        // the last point of a branch that turns back is where it does
        let own = course.points.len() - usize::from(matches!(course.end, Ending::Turns { .. }));
        let ends = (1..own).find(|&k| self.balances(&course.points[k].1, course.points[k].0) != Some(true));
        let last = |course: &Course| course.points.last().map_or(from, |p| p.0);
        let Some(k) = ends else {
            let limit = match course.end {
                Ending::Range => None,
                Ending::Turns { value, bracket, located } => Some(Limit { value, why: Why::Exists, bracket, located }),
                Ending::Lost => {
                    Some(Limit { value: last(&course), why: Why::Lost, bracket: (last(&course), last(&course)), located: false })
                }
            };
            return Reach { course, limit };
        };
        let (a, b) = (course.points[k - 1].0, course.points[k].0);
        let limit = match course.crossed.iter().find(|c| (a.min(b)..=a.max(b)).contains(*c)) {
            Some(&c) => Limit { value: c, why: Why::Exists, bracket: (c, c), located: true },
            None => {
                let (mut yes, mut no) = (a, b);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (yes + no);
                    if middle == yes || middle == no {
                        break;
                    }
                    let there = self.along.at(&course, middle).and_then(|x| self.balances(&x, middle));
                    if there == Some(true) { yes = middle } else { no = middle }
                }
                Limit { value: yes, why: Why::Half, bracket: (yes.min(no), yes.max(no)), located: true }
            }
        };
        course.points.truncate(k + 1);
        Reach { course, limit: Some(limit) }
    }

    /// The state at a value on the way; `None` where it does not reach.
    pub fn at(&mut self, reach: &Reach, value: f64) -> Option<Assessed> {
        let x = self.along.at(&reach.course, value)?;
        self.assessed(&x, value)
    }

    /// Where its stability changes between two values at which it differs, and the frequency of the root that crosses.
    pub fn change(&mut self, reach: &Reach, ends: [(f64, f64); 2]) -> Option<(f64, f64)> {
        let tolerance = 1e-13 * ends[0].0.abs().max(ends[1].0.abs());
        let value = root(|v| self.at(reach, v).map(|j| j.growth), ends[0], ends[1], tolerance)?;
        Some((value, self.at(reach, value).map_or(f64::NAN, |j| j.frequency)))
    }
}
