//! Basins of machines with movable masses, such as the balls of a balancer: which stationary state, or which motion with masses that go round, is reached from
//! which start.
//!
//! The states at rest in turning axes are those that `stationary` finds. A motion is followed until it has reached one of them, or goes on moving alike
//! ([`follow`]). Large maps do not follow every cell so far: of starts spread over the grid some are followed to their ends and show what else there is
//! ([`known`]); then others, which show how near a motion comes to an attractor and still goes elsewhere. Within half that distance motions are assigned to the
//! attractor without being followed on. A third part of the starts is followed to the end as well, and says how often that would have been wrong; cells of the
//! map may be, too ([`check`]).
//!
//! Distances are those of [`Metric`].

mod check;
mod follow;
mod known;
mod report;

use super::rows::PLACE;
use super::{Basins, BasinsResult, Context, Found, MassBasins};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::system::{Drive, System};
use crate::outcome::{End, Finding, Outcome};
use crate::solve::co_rotating::isotropic;
use crate::solve::ensemble::{self, Form, Settings};
use crate::solve::stationary::images::Images;
use crate::solve::stationary::metric::Metric;
use crate::solve::stationary::{Request, Search, State};
use crate::store::{self, Collected};
use crate::study::Study;
use crate::study::motion::start::Start;
use crate::study::motion::steady_state::columns::{RowColumn, cells, count, number, word};
use crate::study::motion::steady_state::{Budget, method};
pub use crate::study::nonlinear::stationary::classify::Class;
use crate::study::nonlinear::stationary::classify::{Scale, Seen};
use crate::study::nonlinear::stationary::states_at;
use crate::text;
pub use check::{Checked, Differs};
use follow::{Begin, Course, Follow, Goal};
use known::{Attractor, KnownAttractors};
pub use known::{MassAttractor, MassKind};
use laval_num::sampling::Points;
pub(super) use report::report;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Most cells of a map.
pub(super) const MOST_CELLS: usize = 1_000_000;
/// Cells from which on motions are assigned before their end.
const MANY: usize = 1200;
/// Typical sizes between the end of a motion and the state it has come to.
const AT: f64 = 1e-2;
/// So many starts followed beforehand are announced.
const ANNOUNCED: f64 = 400.0;
/// Starts of the search for states at rest.
const STARTS: usize = 200;
/// Tolerated error of a step where the file gives none: where a motion ends does not depend on its last digits.
const RELATIVE: f64 = 1e-6;
/// Seed of the starts that are followed beforehand.
const SEED: u32 = 31;

/// The machine has masses that move round, and no preferred direction: it has states at rest in turning axes.
pub(super) fn has(system: &System, speed: f64) -> bool {
    let turns = system.machine.drive == Drive::Prescribed && isotropic(system, speed).is_ok();
    turns && !Images::of(system, speed).angles.is_empty()
}

/// What the starts followed beforehand show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rehearsal {
    /// Starts that showed what there is.
    pub learned: usize,
    /// Starts that showed how near motions come.
    pub witnessed: usize,
    /// Starts followed to the end afterwards.
    pub tried: usize,
    /// Those of them that would have been assigned to an attractor earlier.
    pub assigned: usize,
    /// Those that would have been assigned wrongly.
    pub wrong: usize,
}

/// A motion that was followed, and the class of the state where it rests at none of the known attractors.
struct Row {
    place: [f64; 2],
    course: Course,
    class: Option<&'static str>,
}

/// Initial values of a cell.
fn place(values: &[Vec<f64>; 2], cell: usize) -> [f64; 2] {
    let width = values[0].len();
    [values[0][cell % width], values[1][cell / width]]
}

struct Members<'a> {
    study: &'a Basins,
    system: Arc<System>,
    metric: Metric,
    start: Start,
    budget: Budget,
    values: [Vec<f64>; 2],
    known: KnownAttractors,
    early: bool,
    context: &'a Context<'a>,
}

impl Members<'_> {
    fn undisturbed(&self) -> Vec<f64> {
        let mut y = vec![0.0; 2 * self.system.n() + self.system.m()];
        self.start.write(&self.study.initial, &mut y);
        y
    }

    fn start_at(&self, place: [f64; 2]) -> Begin {
        let mut begin = Begin { y: self.undisturbed(), run_up: None };
        for (axis, x) in self.study.axes.iter().zip(place) {
            match axis.index {
                Some(i) => begin.y[i] = x,
                None => begin.run_up = Some(x),
            }
        }
        begin
    }

    fn place(&self, cell: usize) -> [f64; 2] {
        place(&self.values, cell)
    }

    fn follow(&self, starts: &[Begin], early: bool, done: &(dyn Fn() + Sync)) -> Option<Vec<Course>> {
        let rules = &self.study.rules;
        let relative = if self.study.exact { rules.relative } else { RELATIVE };
        let task = Follow {
            system: &self.system,
            metric: &self.metric,
            speed: self.study.speed,
            starts,
            relative,
            absolute: if self.study.exact { rules.absolute } else { relative },
            most_turns: rules.most_periods,
            known: &self.known,
            early,
            budget: &self.budget,
            done,
            cancelled: &|| self.context.cancelled(),
        };
        let settings = Settings { method: method(&self.system, rules.method, self.study.speed), ..Settings::default() };
        let courses = ensemble::run(
            &task,
            &self.system,
            Form::of(&self.system, self.study.axes.iter().all(|a| a.index.is_some())),
            0..starts.len(),
            settings,
        )?;
        (!self.budget.used_up()).then_some(courses)
    }

    /// Starts spread over the grid between its ends, by chance: `from` counts on.
    fn spread(&self, from: usize, count: usize) -> Vec<Begin> {
        let at = |k: usize, d: usize| {
            let share = Points::Random.at(SEED, u32::try_from(from + k).unwrap_or(u32::MAX), d as u32);
            let (lo, hi) = (self.values[d][0], self.values[d][self.values[d].len() - 1]);
            lo + share * (hi - lo)
        };
        (0..count).map(|k| self.start_at([at(k, 0), at(k, 1)])).collect()
    }

    /// Follows starts beforehand; `None` when stopped.
    fn rehearse(&mut self, cells: usize) -> Option<Rehearsal> {
        let (learned, witnessed) = ((cells / 8).clamp(16, 256), (cells / 10).clamp(400, 1024));
        let total = learned + if self.early { witnessed + witnessed / 2 } else { 0 };
        let (context, begun) = (self.context, AtomicU64::new(0));
        context.announce(total as f64, ANNOUNCED, text!("starts followed beforehand, then those of the map"));
        // one is never done: the map is still to come
        let done = || context.progress.report(begun.fetch_add(1, Ordering::Relaxed), total as u64);
        let mut seen = Rehearsal { learned, ..Rehearsal::default() };
        for course in self.follow(&self.spread(0, learned), false, &done)? {
            if course.goal == Goal::Moving {
                self.known.learn(&self.metric, &course.slip, course.extent, &course.tail);
            }
        }
        if !self.early {
            return Some(seen);
        }
        let known = |goal: &Goal| if let Goal::Known(k) = goal { Some(*k) } else { None };
        for course in self.follow(&self.spread(learned, witnessed), false, &done)? {
            self.known.witness(known(&course.goal), &course.nearest);
        }
        self.known.trust();
        (seen.witnessed, seen.tried) = (witnessed, witnessed / 2);
        for course in self.follow(&self.spread(learned + witnessed, seen.tried), false, &done)? {
            seen.assigned += usize::from(course.recognised.is_some());
            seen.wrong += usize::from(course.recognised.is_some() && course.recognised != known(&course.goal));
        }
        Some(seen)
    }

    /// Class of the state a motion rests in.
    fn class(&self, y: &[f64]) -> &'static str {
        let speed = self.study.speed;
        let width = 1e-3 * speed;
        let request = Request { range: (speed - width, speed + width), starts: 1, seeds: vec![speed], max_points: 2, work: u64::MAX };
        let mut search = Search::new(&self.system, &request, self.context.cancel);
        let scale = Scale::at(&self.system, &mut search, speed);
        let mut x = y[..self.system.n()].to_vec();
        // a motion comes near its state only: which one that is tells the state itself
        let came = x.clone();
        if search.settle_freely(&mut x, speed).is_none() || search.images().distance(&came, &x, search.scale()) > AT {
            x = came;
        }
        Seen::of(&self.system, &search, &State { branch: 0, speed, x, error: 0.0 }).class(&scale).words()
    }

    /// What a motion comes to that ends in no attractor of the known ones, at the state `y`.
    fn word(&self, goal: &Goal, y: &[f64]) -> String {
        let class = (*goal == Goal::Resting && self.system.m() == 0).then(|| self.class(y));
        name(goal, class).unwrap_or_default()
    }

    fn rows(&self, range: std::ops::Range<usize>, counter: &store::Rows) -> Option<Vec<Row>> {
        let places: Vec<[f64; 2]> = range.map(|c| self.place(c)).collect();
        let starts: Vec<Begin> = places.iter().map(|&p| self.start_at(p)).collect();
        let courses = self.follow(&starts, self.early, &|| counter.add(1))?;
        let row = |(place, course): ([f64; 2], Course)| {
            let class = (course.goal == Goal::Resting && self.system.m() == 0).then(|| self.class(&course.y));
            Row { place, course, class }
        };
        Some(places.into_iter().zip(courses).map(row).collect())
    }
}

/// Names of the columns of a row.
pub(super) const STATE: &str = "state";
pub(super) const GOAL: &str = "goal";
pub(super) const EARLY: &str = "early";
pub(super) const TURNS: &str = "turns";
const STEPS: &str = "steps";
pub(super) const FAILURE: &str = "failure";

/// A goal in words, with the class of the state where the motion rests; none of one that is known.
fn name(goal: &Goal, class: Option<&'static str>) -> Option<String> {
    match goal {
        Goal::Known(_) => None,
        Goal::Resting => Some(class.map_or("at rest".into(), |c| format!("at rest, {c}"))),
        Goal::Moving => Some("moves on".into()),
        Goal::Unsettled => Some("not settled".into()),
        Goal::Failed(_) => Some("failed".into()),
    }
}

fn columns(members: &Members) -> Vec<RowColumn<Row>> {
    let whole = |x: u64| i64::try_from(x).ok();
    let mut out: Vec<RowColumn<Row>> = Vec::new();
    for (k, axis) in members.study.axes.iter().enumerate() {
        out.push(number(PLACE[k], &axis.unit, &axis.meaning().to_string(), move |r: &Row| r.place[k]));
    }
    out.push(count(STATE, "number in the table of attractors; none where the motion ends in none of them", |r: &Row| {
        match r.course.goal {
            Goal::Known(k) => i64::try_from(k + 1).ok(),
            _ => None,
        }
    }));
    out.push(word(GOAL, "what the motion comes to where it ends in no attractor of the table", |r: &Row| name(&r.course.goal, r.class)));
    out.push(count(EARLY, "1 where the end of the motion was recognised before it was reached", move |r: &Row| {
        Some(i64::from(r.course.recognised.is_some()))
    }));
    out.push(count(TURNS, "turns integrated", move |r: &Row| whole(r.course.turns)));
    out.push(count(STEPS, "integration steps", move |r: &Row| whole(r.course.steps)));
    out.push(word(FAILURE, "why there is no motion", |r: &Row| match r.course.goal {
        Goal::Failed(why) => Some(why.into()),
        _ => None,
    }));
    out
}

pub(super) fn run(study: &Basins, system: &System, context: &Context) -> Result<BasinsResult, Diagnostic> {
    let own = system.with(&[]).map_err(Diagnostics::into_error)?;
    let (states, images) = states_at(&own, study.speed, STARTS, context)?;
    let held = states.first().map_or_else(|| vec![0.0; own.n()], |s| s.state.x[..own.n()].to_vec());
    let metric = Metric::new(&own, study.speed, images, &held);
    let values = study.axes.each_ref().map(super::InitialValueAxis::values);
    let count = values[0].len() * values[1].len();
    let rest = |r: &crate::study::nonlinear::stationary::Row| {
        Attractor::rest(&metric, &r.state.x[..own.n()], r.class, r.stability.growth(), r.stable())
    };
    let attractors = states.iter().map(rest).collect();
    let early = study.recognise && count >= MANY && metric.countable();
    let mut members = Members {
        study,
        known: KnownAttractors { attractors },
        metric,
        start: Start::new(&own, study.speed),
        budget: Budget::new(context.work_limit),
        values,
        early,
        context,
        system: Arc::new(own),
    };
    context.announce(count as f64, 1000.0, text!("motions to follow until their masses rest or go on moving alike"));
    let Some(seen) = members.rehearse(count) else {
        return Ok(BasinsResult { found: None, undeflected: members.start.undeflected, end: context.end(false) });
    };
    let columns = columns(&members);
    let plan = store::Plan {
        study: Basins::KIND.into(),
        columns: columns.iter().map(|c| c.column.clone()).collect(),
        rows: count,
        chunk: count.div_ceil(50).clamp(64, 4096),
    };
    let results = store::run(plan, context, |range, counter| Ok(members.rows(range, counter).map(|list| cells(&columns, &list))))?;
    let cells = Collected::of(&results)?;
    let complete = cells.end == End::Reached;
    let attractors: Vec<MassAttractor> = members.known.attractors.iter().map(Attractor::kept).collect();
    let wanted = members.early && complete && study.check > 0;
    let names = report::names(&attractors);
    let checked = if wanted { check::check(&members, &names, &report::ends(&cells, &names)) } else { None };
    let end = context.end(complete && !(wanted && checked.is_none()));
    let masses = members.metric.images.groups.iter().flatten().copied().collect();
    let recognition = members.early.then_some(seen);
    let found = MassBasins { attractors, masses, cells, recognition, checked };
    Ok(BasinsResult { found: Some(Found::Masses(Box::new(found))), undeflected: members.start.undeflected, end })
}

/// Of a study that was stopped before the first cell.
pub(super) fn nothing(result: &BasinsResult, name: &str) -> Outcome {
    Outcome::new(Basins::KIND, name).end(result.end).finding(Finding::warning("incomplete", "basins-no-cell"))
}
