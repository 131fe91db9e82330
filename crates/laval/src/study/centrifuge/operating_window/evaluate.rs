//! One machine over the range of speeds: scan, ends of the windows, best speed.

use super::borders::{Borders, stable};
use super::margins::{Evaluator, Point, Requirements, radial_guess};
use super::passage::Passage;
use super::request::fitting;
use super::steady::Branches;
use super::window::{Interval, dips, intervals, scan, stepped_over};
use super::{Objective, OperatingWindow, Policy, SPEEDS};
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::separation::separator::Separator;
use crate::solve::extrema::seeds;
use crate::solve::rest::rest;
use crate::study::Context;
use crate::study::shared::limits::Limit;
use laval_num::order::{SortByNumber, ascending};
use laval_num::univariate::maximum;
use serde::{Deserialize, Serialize};

/// How carefully a range is looked at.
pub(super) enum Care<'a> {
    /// Ends, narrow places, the best speed.
    Full,
    /// The ends of the windows.
    Ends,
    /// These speeds alone.
    Only(&'a [f64]),
}

/// One machine evaluated over the range.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Evaluated {
    /// By speed.
    pub points: Vec<Point>,
    /// Where everything is kept.
    pub intervals: Vec<Interval>,
    /// Where everything but the separation is kept.
    pub mechanical: Vec<Interval>,
    /// The recommended speed.
    pub best: Option<Point>,
    /// Bodies whose tilt no limit sees.
    pub unseen: Vec<Unseen>,
    /// Folds of the response of a nonlinear machine, rad/s.
    pub folds: Vec<f64>,
    /// Orders kept of it.
    pub harmonics: Option<usize>,
    /// The way up and down, where it was simulated.
    pub passage: Option<Passage>,
    /// The run-up to the recommended speed of tubes held at an angle.
    pub counted: Option<Counted>,
    /// The search for narrow interruptions between the speeds of the scan was not stopped.
    pub refined: bool,
}

/// A run-up counted by an estimate.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Counted {
    /// Time at full speed as which it counts, by the field at mean radius, s.
    pub counted: f64,
    /// How long it takes, s.
    pub duration: f64,
    /// As which it counts by the square of the speed alone, s.
    pub equivalent: f64,
}

/// A body that tilts, forced to do so or not, without a limit that its tilt could break.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Unseen {
    /// Index among the bodies.
    pub index: usize,
    /// Its name.
    pub name: String,
}

/// The run-up of tubes held at an angle to a speed.
fn counted(required: &Requirements, best: &Point) -> Option<Counted> {
    let task = required.task.as_ref().filter(|t| matches!(t.vessel.separator, Separator::Tube(..)))?;
    let ramp = task.batch.run_up.to(best.speed)?;
    let counted = task.batch.at(best.speed).clock.counted(ramp.duration());
    Some(Counted { counted, duration: ramp.duration(), equivalent: ramp.equivalent() })
}

/// Bodies that tilt without a limit on that, and whose displacement is the same at all points that count.
fn unseen(system: &System, required: &Requirements) -> Vec<Unseen> {
    let apart = |k: usize| system.probes().iter().any(|p| p.station == k && !p.is_tilt() && !p.is_reference());
    let limited = |list: &[Limit], name: &str| list.iter().any(|l| l.body == name);
    let l = &required.limits;
    let seen = |k: usize, name: &str| limited(&l.tilt, name) || (apart(k) && limited(&l.displacement, name)) || !l.moment.is_empty();
    let bodies = system.stations().iter().enumerate();
    bodies.filter(|(k, b)| b.tilt.is_some() && !seen(*k, &b.name)).map(|(index, b)| Unseen { index, name: b.name.clone() }).collect()
}

impl OperatingWindow {
    /// Scans the range, refines the ends; `known` is the passage when it was simulated before, `before` the number of speeds evaluated until now, which count for
    /// the limit on the work. `None` when it was stopped.
    pub(super) fn evaluate(
        &self,
        system: &System,
        context: &Context,
        care: Care,
        known: Option<&Passage>,
        before: u64,
    ) -> Result<Option<Evaluated>, Diagnostic> {
        let (careful, only) = (matches!(care, Care::Full), matches!(care, Care::Only(_)));
        let required = fitting(self, system, only)?;
        let (from, to) = (self.speed.from, self.speed.to);
        let count = if careful { self.speed.points.unwrap_or(SPEEDS) } else { SPEEDS / 2 };
        let mut speeds = match care {
            Care::Only(grid) => grid.to_vec(),
            _ => RangeValue { points: Some(count), ..self.speed }.linspace(count),
        };
        let branches = self.branches(system, context)?;
        let folds: Vec<f64> = branches.iter().flat_map(Branches::folds).collect();
        let folds = if only { vec![] } else { folds };
        speeds.extend(folds.iter().flat_map(|w| [w * (1.0 - 1e-4), w * (1.0 + 1e-4)]));
        if careful {
            let mut each = |_| !context.cancelled();
            speeds.extend(seeds(system, &|w| rest(system, w), from, to, &mut each)?.speeds.into_iter().step_by(2));
        }
        if let Some(w) = required.task.as_ref().filter(|_| !only).and_then(radial_guess) {
            speeds.extend([0.5 * w, 0.8 * w, w]);
        }
        speeds.retain(|w| *w >= from && *w <= to);
        ascending(&mut speeds);
        speeds.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * to);
        let limited = !required.limits.passage.is_empty()
            || required.limits.torque.is_some()
            || (required.policy == Policy::Reached && branches.is_some());
        let passage = match required.ramp.filter(|_| limited) {
            Some(_) if known.is_some() => known.cloned(),
            Some(duration) => match Passage::simulate(system, to, duration, context)? {
                None => return Ok(None),
                whole => whole,
            },
            None => None,
        };
        let evaluator = Evaluator { system, required: &required, branches: branches.as_ref(), passage: passage.as_ref() };
        let total = speeds.len() as u64;
        let go_on = |done: u64| {
            context.progress.report(done.min(total), total);
            context.goes_on(before.saturating_add(done))
        };
        let Some(mut points) = scan(&evaluator, &speeds, go_on)? else { return Ok(None) };
        let mut refined = true;
        if careful {
            let scanned = before.saturating_add(total);
            let more = scan(&evaluator, &dips(&points), |done| context.goes_on(scanned.saturating_add(done)))?;
            refined = more.is_some();
            points.extend(more.unwrap_or_default());
            points.sort_by_number(|a| a.speed);
        }
        if !only {
            stepped_over(|w| evaluator.at(w), &mut points)?;
        }
        let mut found = if only { vec![] } else { intervals(&evaluator, &mut points, Point::feasible)? };
        let mechanical =
            if careful && required.task.is_some() { intervals(&evaluator, &mut points, |p| p.feasible_without(0))? } else { vec![] };
        let borders = if careful { Borders::located(&intervals(&evaluator, &mut points, stable)?) } else { Borders::between(&points) };
        // an end of another interval may lie in a window that no speed of the grid has met
        let inside = |p: &Point, all: &[Interval]| all.iter().any(|i| i.low.speed <= p.speed && p.speed <= i.high.speed);
        if !only && points.iter().any(|p| p.feasible() && !inside(p, &found)) {
            found = intervals(&evaluator, &mut points, Point::feasible)?;
        }
        points.iter_mut().for_each(|p| borders.measure(p));
        let best = if careful { self.best(&evaluator, &borders, &points)? } else { None };
        let harmonics = branches.as_ref().map(Branches::harmonics);
        drop(branches);
        let unseen = unseen(system, &required);
        let counted = best.as_ref().and_then(|best| counted(&required, best));
        Ok(Some(Evaluated { points, intervals: found, mechanical, best, unseen, folds, harmonics, passage, counted, refined }))
    }

    /// Branches of a nonlinear machine; none when it is linear.
    fn branches(&self, system: &System, context: &Context) -> Result<Option<Branches>, Diagnostic> {
        if system.slots().iter().all(|s| s.is_linear()) {
            return Ok(None);
        }
        // the branch begins where it is easy to begin: below the range
        let range = (0.2 * self.speed.from, self.speed.to * (1.0 + 1e-9));
        Branches::follow(system, range, context.cancel).map(Some)
    }

    /// The recommended speed.
    fn best(&self, evaluator: &Evaluator, borders: &Borders, points: &[Point]) -> Result<Option<Point>, Diagnostic> {
        let at = |w: f64| {
            evaluator.at(w).map(|mut p| {
                borders.measure(&mut p);
                p
            })
        };
        let value = |p: &Point| match self.objective {
            Objective::Margin => p.room(),
            Objective::Time => -p.needed,
            Objective::Energy => -p.energy,
            Objective::Amplitude => p.margin(1).unwrap_or(f64::NEG_INFINITY),
        };
        let feasible: Vec<usize> = (0..points.len()).filter(|&i| points[i].feasible()).collect();
        // ties go to the lowest speed
        let mut top: Option<usize> = None;
        for &i in &feasible {
            if top.is_none_or(|t| value(&points[i]) > value(&points[t])) {
                top = Some(i);
            }
        }
        let Some(i) = top else { return Ok(None) };
        let (a, b) = (i.saturating_sub(1), (i + 1).min(points.len() - 1));
        let found = maximum(
            |w| at(w).ok().map(|p| if p.feasible() { value(&p).max(-1e300) } else { -1e300 }),
            points[a].speed,
            points[b].speed,
            1e-7 * points[i].speed,
        );
        let polished = match found {
            Some((w, _)) => Some(at(w)?).filter(|p| p.feasible() && value(p) > value(&points[i])),
            None => None,
        };
        Ok(Some(polished.unwrap_or_else(|| points[i].clone())))
    }
}
