//! The speeds at which a machine is stable, keeps its limits, survives the run-up, and separates what it should in the time it has.
//!
//! Equations: every requirement is a margin, kept when 0 or more:
//!
//! ```text
//! separation    1 - t_q(w)/t            vibration    1 - max(amplitude/limit) over all stable steady states
//! self_centred  1 - (|z + e|/|e|)/c0    stable       (-largest growth rate - sig0)/w
//! clear         min |p - h w|/w - dlt   passage      1 - worst of peak/limit and torque/available on the way up and down
//! strength      1 - w/w_max(density)
//! ```
//!
//! `stable` is judged with the contents as they are before and after the separation. The window is where all are kept. Its ends are located by bracketing; the recommended speed has the largest least margin (or serves another
//! objective). At every speed the machine carries its cups at the tilt of that speed.
//!
//! Symbols: w spin speed; p natural whirl frequency; h excitation order; t_q time in which the share q is caught.
//!
//! Validity: that of the parts and of the separation; a margin that cannot be had counts as not kept. The robust window is asserted at the corners of the uncertain
//! parameters, which bounds it where margins depend on them monotonically.
//!
//! Sources: `theory/separation.md` section 13.

mod contents;
mod coupling;
mod margins;
mod passage;
mod report;
mod steady;
mod window;

use super::duty::task::{self, DIAMETER, MODEL, PARTICLES, RECOVERY, START, THROUGHPUT};
use super::duty::{self, CUP};
use super::limits;
use super::support::{SPEED_RANGE, range};
use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Extra, Field, FieldKind, RangeValue, Value, Values};
use crate::model::system::System;
use crate::outcome::{End, Outcome};
use crate::separation::batch::RunUp;
use crate::solve::extrema::seeds;
use crate::solve::rest::rest;
use crate::solve::scalar::maximum;
use margins::{Asked, Judge, Point, radial_guess};
use passage::Passage;
use rayon::prelude::*;
use steady::Branches;
use window::{Interval, dips, intervals, scan};

/// What the best speed is best for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objective {
    /// Largest least margin.
    Margin,
    /// Shortest time.
    Time,
    /// Least energy.
    Energy,
    /// Smallest vibration.
    Amplitude,
}

/// Which of several stable steady states of a nonlinear machine is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Policy {
    /// All of them.
    All,
    /// The one nearest to the motion of the simulated run-up as it passes the speed.
    Reached,
    /// The one with the least margin of vibration.
    Highest,
}

/// See the [module](self).
pub struct OperatingWindow {
    speed: RangeValue,
    values: Values,
    objective: Objective,
    tolerance: f64,
    uncertain: Vec<(String, f64)>,
    map: Option<(String, RangeValue)>,
}

/// Speeds of the scan unless given, and of a map.
const SPEEDS: usize = 120;
/// Most places where particles start in a map.
const MAP_PLACES: usize = 256;
/// Loads at which branches of a nonlinear machine are followed.
const LOADS: usize = 5;
/// Most uncertain parameters: their corners are all evaluated.
const MOST_UNCERTAIN: usize = 5;

impl Study for OperatingWindow {
    const KIND: &'static str = "operating_window";
    const DOC: &'static str = "At which speeds the machine may run: stable, its limits kept, the way up survived, and the suspension separated in the time at \
        hand; what binds at each end, the recommended speed, the shortest time, and what to relax when nothing fits. Uses the blocks \
        [limits], [[cup]] and [suspension]; a requirement that is not given is not checked. Stability is judged with the contents as they are before and after the \
        separation: particles spread over the cups and all at their bottoms, bowls full of suspension and of clear liquid.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds looked at; points (120 unless given) are added where something happens"),
        CUP,
        Field::optional(
            "time",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) },
            "",
            "time in which cups must have separated",
        ),
        THROUGHPUT,
        RECOVERY,
        DIAMETER,
        PARTICLES,
        MODEL,
        START,
        Field::optional(
            "ramp",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e7) },
            "",
            "time of the run-up to the top of the range, at constant acceleration; it is then simulated",
        ),
        Field::optional("count_ramp", FieldKind::Flag, "true", "the run-up takes its time from the time at hand"),
        Field::optional(
            "objective",
            FieldKind::Choice(&[
                ("margin", "largest least margin"),
                ("time", "shortest separation"),
                ("energy", "least kinetic energy and work of the drive"),
                ("amplitude", "smallest vibration against its limits"),
            ]),
            "margin",
            "what the recommended speed is best for",
        ),
        Field::optional(
            "branch_policy",
            FieldKind::Choice(&[
                ("all", "every stable steady state must keep the limits"),
                ("reached", "the one that the run-up of the file leads to, and valid for that run-up only"),
                ("highest", "the one with the largest vibration against its limits"),
            ]),
            "all",
            "which of several steady states of a nonlinear machine is judged",
        ),
        Field::optional(
            "speed_tolerance",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.0, 0.5) },
            "0",
            "relative error of the speed that the robust window leaves room for",
        ),
        Field::optional(
            "uncertain",
            FieldKind::Named { unit: "", bounds: Bounds { min: 0.0, max: 0.9, min_open: true } },
            "",
            "relative uncertainty of parameters by path, as { suspension.viscosity = \"20 %\" }; the robust window holds at every corner",
        ),
        Field::optional(
            "map",
            FieldKind::ParameterRange,
            "",
            "a parameter (of a part, a cup or the suspension) to vary against the speed; 12 points unless given",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = range("speed", values.range("speed")?, 5, values, diagnostics)?;
        let mut wrong = |field: &str, code: &'static str, message: String, help: &str| {
            diagnostics.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
        };
        if speed.from <= 0.0 {
            wrong(
                "speed",
                "operating_window.speed",
                "the range of speeds must begin above standstill".into(),
                "begin at a low speed, such as a tenth of the highest",
            );
            return None;
        }
        let mut uncertain = Vec::new();
        for (name, share) in values.named("uncertain") {
            match name {
                Some(path) => uncertain.push((path.to_string(), share)),
                None => wrong(
                    "uncertain",
                    "operating_window.uncertain",
                    "which parameters are uncertain is missing".into(),
                    "write uncertain = { suspension.viscosity = \"20 %\" }",
                ),
            }
        }
        if uncertain.len() > MOST_UNCERTAIN {
            wrong(
                "uncertain",
                "operating_window.uncertain",
                format!("{} uncertain parameters are too many: every corner is evaluated", uncertain.len()),
                "keep at most five",
            );
            return None;
        }
        let objective = match values.choice("objective") {
            Some("time") => Objective::Time,
            Some("energy") => Objective::Energy,
            Some("amplitude") => Objective::Amplitude,
            _ => Objective::Margin,
        };
        let map = match values.parameter_range("map") {
            None => None,
            Some((path, r)) => Some((path.to_string(), range("map", r, 2, values, diagnostics)?)),
        };
        let window = OperatingWindow {
            speed,
            values: values.clone(),
            objective,
            tolerance: values.number("speed_tolerance").unwrap_or(0.0),
            uncertain,
            map,
        };
        let asked = window.asked(system, diagnostics)?;
        let l = &asked.limits;
        let mut wrong = |field: &str, code: &'static str, message: String, help: &str| {
            diagnostics.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
        };
        if objective == Objective::Time && asked.duty.is_none() {
            wrong(
                "objective",
                "operating_window.objective",
                "there is no separation whose time could be shortest".into(),
                "add [[cup]], [suspension] and time",
            );
        }
        if objective == Objective::Amplitude && l.displacement.is_empty() && l.velocity.is_empty() && l.force.is_empty() {
            wrong(
                "objective",
                "operating_window.objective",
                "no limit on vibration is given that amplitudes could be measured against".into(),
                "add displacement, velocity or force to [limits]",
            );
        }
        for path in window.uncertain.iter().map(|u| &u.0).chain(window.map.iter().map(|m| &m.0)) {
            let at = window.map.as_ref().map_or(0.0, |m| m.1.from);
            let trial = if window.map.as_ref().is_some_and(|m| &m.0 == path) { Some(at) } else { current(system, path) };
            if let Err(d) = trial.map_or_else(|| Err(system.unknown_param(path)), |x| varied(system, path, x).map(|_| ())) {
                let field = if window.map.as_ref().is_some_and(|m| &m.0 == path) { "map" } else { "uncertain" };
                diagnostics.push(d.at(values.span_of(field)));
            }
        }
        (!diagnostics.has_errors()).then_some(window)
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let Some(main) = self.evaluate(system, context, Care::Full, None)? else {
            let end = if context.cancelled() { End::Cancelled } else { End::MaxPoints };
            return Ok(Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(end));
        };
        let robust = self.robust(system, context, &main)?;
        let map = self.mapped(system, context, &main)?;
        report::Found { study: self, main, robust, map }.outcome(context)
    }
}

/// How carefully a range is looked at.
enum Care<'a> {
    /// Ends, narrow places, the best speed.
    Full,
    /// The ends of the windows.
    Ends,
    /// These speeds alone.
    Only(&'a [f64]),
}

/// One machine evaluated over the range.
pub(super) struct Evaluated {
    asked: Asked,
    points: Vec<Point>,
    intervals: Vec<Interval>,
    /// Where everything but the separation is kept.
    mechanical: Vec<Interval>,
    best: Option<Point>,
    folds: Vec<f64>,
    harmonics: Option<usize>,
    passage: Option<Passage>,
}

/// A window that holds at all corners of the uncertain parameters.
pub(super) struct Robust {
    intervals: Vec<(f64, f64)>,
    corners: usize,
}

/// Least margin over speed and a parameter.
pub(super) struct Map {
    path: String,
    unit: &'static str,
    /// Speed, value, least margin, what binds.
    cells: Vec<(f64, f64, f64, &'static str)>,
}

impl OperatingWindow {
    /// What is asked of a machine; says what is wrong.
    fn asked(&self, system: &System, out: &mut Diagnostics) -> Option<Asked> {
        let v = &self.values;
        let has = |word: &str| system.machine.extras.iter().any(|e| e.word == word);
        let wrong = |out: &mut Diagnostics, field: &str, message: &str, help: &str| {
            out.push(Diagnostic::error("operating_window.duty", message).at(v.span_of(field)).help(help));
        };
        let (time, throughput) = (v.number("time"), v.number("throughput"));
        let ramp = v.number("ramp");
        let mut duty = None;
        if has("suspension") && has("cup") {
            let mut task = task::task(v, system, None, out)?;
            if let Some(t) = ramp.filter(|_| v.flag("count_ramp").unwrap_or(true)) {
                task.batch.run_up = RunUp::Linear(t / self.speed.to);
            }
            duty = Some(task);
        } else if time.is_some() || throughput.is_some() {
            let field = if time.is_some() { "time" } else { "throughput" };
            wrong(
                out,
                field,
                "a time or throughput needs something to separate, and something that separates it",
                "add the blocks [[cup]] and [suspension]",
            );
            return None;
        }
        let limits = limits::of(system);
        let vessels = system.machine.extras.iter().filter(|e| e.word == "cup");
        let loading = vessels.filter_map(|e| duty::vessel(e, system, &mut Diagnostics::default())).filter_map(|c| Some((c.name, c.load?)));
        let (names, cups): (Vec<String>, Vec<_>) = loading.unzip();
        let after = duty.as_ref().and_then(|task| {
            let own = names.iter().position(|n| *n == task.vessel.name);
            contents::changed(system, task, &cups, own)
        });
        let policy = match v.choice("branch_policy") {
            Some("reached") => Policy::Reached,
            Some("highest") => Policy::Highest,
            _ => Policy::All,
        };
        if policy == Policy::Reached && ramp.is_none() {
            wrong(
                out,
                "branch_policy",
                "the state that a run-up leads to needs the time of the run-up",
                "add ramp = \"60 s\": the time to the top of the range of speeds",
            );
            return None;
        }
        if ramp.is_none() && (!limits.passage.is_empty() || limits.torque.is_some()) {
            wrong(
                out,
                "ramp",
                "the limits on the passage need the time of the run-up",
                "add ramp = \"60 s\": the time to the top of the range of speeds",
            );
            return None;
        }
        Some(Asked { duty, limits, cups, after, ramp, policy, top: self.speed.to })
    }

    /// The same for a machine that was read before; for a map with fewer places.
    fn fitting(&self, system: &System, map: bool) -> Result<Asked, Diagnostic> {
        let mut asked = self.asked(system, &mut Diagnostics::default()).ok_or_else(|| {
            Diagnostic::error("operating_window.duty", "what is asked of the machine does not fit its cups and suspension")
        })?;
        if let Some(duty) = asked.duty.as_mut().filter(|_| map) {
            duty.batch.places = duty.batch.places.min(MAP_PLACES);
        }
        Ok(asked)
    }

    /// Scans the range, refines the ends; `known` is the passage when it was simulated before.
    fn evaluate(&self, system: &System, context: &Context, care: Care, known: Option<&Passage>) -> Result<Option<Evaluated>, Diagnostic> {
        let (careful, only) = (matches!(care, Care::Full), matches!(care, Care::Only(_)));
        let asked = self.fitting(system, only)?;
        let (from, to) = (self.speed.from, self.speed.to);
        let count = if careful { self.speed.points.unwrap_or(SPEEDS) } else { SPEEDS / 2 };
        let mut speeds = match care {
            Care::Only(grid) => grid.to_vec(),
            _ => RangeValue { points: Some(count), ..self.speed }.linspace(count),
        };
        let branches = self.branches(system, &asked, context)?;
        let folds: Vec<f64> = branches.iter().flat_map(|b| b.1.folds()).collect();
        let folds = if only { vec![] } else { folds };
        speeds.extend(folds.iter().flat_map(|w| [w * (1.0 - 1e-4), w * (1.0 + 1e-4)]));
        if careful {
            // loads at both ends bound where resonances lie
            for w in [from, 0.5 * (from + to), to] {
                let (changed, _) = coupling::loaded(system, &asked.cups, w)?;
                let s = changed.as_ref().unwrap_or(system);
                let mut each = |_| !context.cancelled();
                speeds.extend(seeds(s, &|w| rest(s, w), from, to, &mut each)?.into_iter().step_by(2));
                if asked.cups.is_empty() {
                    break;
                }
            }
        }
        if let Some(w) = asked.duty.as_ref().filter(|_| !only).and_then(radial_guess) {
            speeds.extend([0.5 * w, 0.8 * w, w]);
        }
        speeds.retain(|w| *w >= from && *w <= to);
        speeds.sort_by(f64::total_cmp);
        speeds.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * to);
        let limited =
            !asked.limits.passage.is_empty() || asked.limits.torque.is_some() || (asked.policy == Policy::Reached && !branches.is_empty());
        let passage = match asked.ramp.filter(|_| limited) {
            Some(_) if known.is_some() => known.cloned(),
            Some(duration) => Some(Passage::simulate(system, &asked.cups, to, duration, context)?),
            None => None,
        };
        let judge = Judge { system, asked: &asked, branches: &branches, passage: passage.as_ref() };
        let total = speeds.len() as u64;
        let go_on = |done: u64| {
            context.progress.report(done.min(total), total);
            !context.cancelled() && done < context.work_limit
        };
        let Some(mut points) = scan(&judge, &speeds, go_on)? else { return Ok(None) };
        if careful {
            let more = dips(&points);
            points.extend(scan(&judge, &more, |_| !context.cancelled())?.unwrap_or_default());
            points.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        }
        let found = if only { vec![] } else { intervals(&judge, &mut points, Point::feasible)? };
        let mechanical = if careful && asked.duty.is_some() { intervals(&judge, &mut points, |p| p.feasible_without(0))? } else { vec![] };
        let best = if careful { self.best(&judge, &points)? } else { None };
        let harmonics = branches.first().map(|b| b.1.harmonics());
        drop(branches);
        Ok(Some(Evaluated { asked, points, intervals: found, mechanical, best, folds, harmonics, passage }))
    }

    /// Branch structures of a nonlinear machine at several loads; none when it is linear or nothing forces it.
    fn branches(&self, system: &System, asked: &Asked, context: &Context) -> Result<Vec<(f64, Branches)>, Diagnostic> {
        if system.slots().iter().all(|s| s.is_linear()) {
            return Ok(vec![]);
        }
        let (from, to) = (self.speed.from, self.speed.to);
        let count = if asked.cups.is_empty() { 1 } else { LOADS };
        let mut out = Vec::new();
        for k in 0..count {
            let w = from + (to - from) * (k as f64 + 0.5) / count as f64;
            let (changed, _) = coupling::loaded(system, &asked.cups, w)?;
            // the branch begins where it is easy to begin: below the range
            let range = (0.2 * from, to * (1.0 + 1e-9));
            out.push((w, Branches::follow(changed.as_ref().unwrap_or(system), range, context.cancel)?));
        }
        Ok(out)
    }

    /// The recommended speed.
    fn best(&self, judge: &Judge, points: &[Point]) -> Result<Option<Point>, Diagnostic> {
        let value = |p: &Point| match self.objective {
            Objective::Margin => p.least(),
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
            |w| judge.at(w).ok().map(|p| if p.feasible() { value(&p).max(-1e300) } else { -1e300 }),
            points[a].speed,
            points[b].speed,
            1e-7 * points[i].speed,
        );
        let polished = match found {
            Some((w, _)) => Some(judge.at(w)?).filter(|p| p.feasible() && value(p) > value(&points[i])),
            None => None,
        };
        Ok(Some(polished.unwrap_or_else(|| points[i].clone())))
    }

    /// The window that holds at every corner, shrunk by the tolerance of the speed.
    fn robust(&self, system: &System, context: &Context, main: &Evaluated) -> Result<Option<Robust>, Diagnostic> {
        if self.uncertain.is_empty() && self.tolerance == 0.0 {
            return Ok(None);
        }
        let mut kept: Vec<(f64, f64)> = main.intervals.iter().map(|i| (i.low.speed, i.high.speed)).collect();
        let corners = if self.uncertain.is_empty() { 0 } else { 1usize << self.uncertain.len() };
        for corner in 0..corners {
            let mut changed: Option<System> = None;
            for (k, (path, share)) in self.uncertain.iter().enumerate() {
                let sign = if corner >> k & 1 == 1 { 1.0 } else { -1.0 };
                let now = changed.as_ref().unwrap_or(system);
                let x = current(now, path).ok_or_else(|| now.unknown_param(path))?;
                changed = Some(varied(now, path, x * (1.0 + sign * share))?);
            }
            let known = main.passage.as_ref().filter(|_| self.uncertain.iter().all(|u| only_liquid(system, &u.0)));
            let Some(found) = self.evaluate(changed.as_ref().unwrap_or(system), context, Care::Ends, known)? else {
                return Ok(None);
            };
            let other: Vec<(f64, f64)> = found.intervals.iter().map(|i| (i.low.speed, i.high.speed)).collect();
            kept = kept.iter().flat_map(|a| other.iter().map(move |b| (a.0.max(b.0), a.1.min(b.1)))).filter(|i| i.0 <= i.1).collect();
        }
        // a speed that may be off by the tolerance must stay inside
        let intervals =
            kept.into_iter().map(|(a, b)| (a / (1.0 - self.tolerance), b / (1.0 + self.tolerance))).filter(|i| i.0 <= i.1).collect();
        Ok(Some(Robust { intervals, corners }))
    }

    fn mapped(&self, system: &System, context: &Context, main: &Evaluated) -> Result<Option<Map>, Diagnostic> {
        let Some((path, r)) = &self.map else { return Ok(None) };
        let mut cells = Vec::new();
        let unit = system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or_else(|| extra_unit(path), |s| s.unit);
        let grid = RangeValue { points: Some(SPEEDS / 2), ..self.speed }.linspace(SPEEDS / 2);
        // what does not weigh changes the separation alone
        let moving = match only_friction(system, path) {
            true => self.evaluate(system, context, Care::Only(&grid), main.passage.as_ref())?,
            false => None,
        };
        for x in r.linspace(12) {
            let changed = varied(system, path, x)?;
            let points = if let Some(moving) = &moving {
                if context.cancelled() {
                    return Ok(None);
                }
                let asked = self.fitting(&changed, true)?;
                let judge = Judge { system: &changed, asked: &asked, branches: &[], passage: main.passage.as_ref() };
                let mut points = moving.points.clone();
                points.par_iter_mut().for_each(|p| judge.separated(p));
                points
            } else {
                let known = main.passage.as_ref().filter(|_| only_liquid(system, path));
                let Some(found) = self.evaluate(&changed, context, Care::Only(&grid), known)? else { return Ok(None) };
                found.points
            };
            for &w in &grid {
                if let Some(p) = points.iter().min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs())) {
                    let binding = p.binding().map_or("", |m| margins::NAMES[m.name]);
                    cells.push((w, x, p.least().max(-1.0), binding));
                }
            }
        }
        Ok(Some(Map { path: path.clone(), unit, cells }))
    }
}

/// The parameter belongs to the suspension and weighs nothing: it changes the times of the separation alone.
fn only_friction(system: &System, path: &str) -> bool {
    let field = path.split('.').nth(1).unwrap_or_default();
    let named = ["temperature", "viscosity", "drop_viscosity", "shape_factor", "hindered_exponent", "added_mass", "lift"].contains(&field);
    only_liquid(system, path) && named
}

/// The parameter belongs to the suspension: the machine moves the same whatever it is.
fn only_liquid(system: &System, path: &str) -> bool {
    let name = path.split('.').next().unwrap_or_default();
    system.slot(name).is_none() && system.machine.extras.iter().any(|e| e.word == "suspension" && e.name == name)
}

/// Unit of a parameter of a cup or the suspension.
fn extra_unit(path: &str) -> &'static str {
    let name = path.split_once('.').map_or("", |p| p.1);
    let blocks = super::blocks();
    let fields = blocks.iter().flat_map(|b| &b.info.kinds).flat_map(|k| &k.fields);
    fields
        .filter(|f| f.name == name)
        .find_map(|f| match f.kind {
            FieldKind::Quantity { unit, .. } => Some(unit),
            _ => None,
        })
        .unwrap_or("")
}

/// Value of a parameter of a part, or of a block beside the parts.
fn current(system: &System, path: &str) -> Option<f64> {
    if let Some(i) = system.param(path) {
        return system.params().get(*i.first()?).copied();
    }
    let (name, field) = path.split_once('.')?;
    system.machine.extras.iter().find(|e| e.name == name)?.values.number(field)
}

/// The machine with a parameter changed.
fn varied(system: &System, path: &str, x: f64) -> Result<System, Diagnostic> {
    let first =
        |d: Diagnostics| d.0.into_iter().next().unwrap_or_else(|| Diagnostic::error("parameter.bounds", format!("{path} cannot be {x}")));
    if system.param(path).is_some() {
        return system.with(&[(path, x)]).map_err(first);
    }
    let (name, field) = path.split_once('.').ok_or_else(|| system.unknown_param(path))?;
    let mut extras: Vec<Extra> = system.machine.extras.clone();
    let extra = extras.iter_mut().find(|e| e.name == name).ok_or_else(|| system.unknown_param(path))?;
    if extra.values.number(field).is_none() {
        return Err(Diagnostic::error("parameter.unknown", format!("\"{name}\" has no number {field} to vary"))
            .help("give it a value in its block first"));
    }
    let span = extra.values.span_of(field);
    extra.values.set(field, Value::Number(x), span);
    let word = extra.word;
    let changed = extra.clone();
    let out = system.with_extras(extras).map_err(first)?;
    let mut wrong = Diagnostics::default();
    if let Some(kind) = super::blocks().into_iter().find(|b| b.info.word == word) {
        (kind.check)(&changed, &out, &mut wrong);
    }
    if wrong.has_errors() { Err(first(wrong)) } else { Ok(out) }
}
