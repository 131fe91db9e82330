//! The window of other machines: at the corners of uncertain parameters, and over a parameter.

use super::evaluate::{Care, Evaluated};
use super::margins::{self, Evaluator};
use super::request::fitting;
use super::{MAP_POINTS, OperatingWindow, SPEEDS};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Extra, FieldKind, RangeValue, Value};
use crate::model::system::System;
use crate::study::{Context, blocks, with_blocks};
use crate::text;
use laval_num::text::Text;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// A window that holds at all corners of the uncertain parameters.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Robust {
    /// Lowest and highest speeds, rad/s.
    pub intervals: Vec<(f64, f64)>,
    /// Corners of the uncertain parameters.
    pub corners: usize,
}

/// Least margin over speed and a parameter.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Map {
    /// Path of the parameter.
    pub path: String,
    /// Its unit.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub unit: Text,
    /// By parameter, then speed.
    pub cells: Vec<Cell>,
}

/// Least margin of a map.
const LEAST: f64 = -1.0;

/// A point of a map.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Cell {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Value of the parameter.
    pub value: f64,
    /// Least margin, not below -1.
    pub margin: f64,
    /// Requirement that has it.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub binding: Text,
}

impl OperatingWindow {
    /// The file requires a robust window.
    pub(super) fn wants_robust(&self) -> bool {
        !self.uncertain.is_empty() || self.tolerance != 0.0
    }

    /// The window that holds at every corner, shrunk by the tolerance of the speed, where it is required; `None` when it was stopped. Counts the speeds evaluated.
    pub(super) fn robust(
        &self,
        system: &System,
        context: &Context,
        main: &Evaluated,
        speeds: &mut u64,
    ) -> Result<Option<Robust>, Diagnostic> {
        if !self.wants_robust() {
            return Ok(None);
        }
        let mut kept: Vec<(f64, f64)> = main.intervals.iter().map(|i| (i.low.speed, i.high.speed)).collect();
        let corners = if self.uncertain.is_empty() { 0 } else { 1usize << self.uncertain.len() };
        for corner in 0..corners {
            let mut changed: Option<System> = None;
            for (k, (path, share)) in self.uncertain.iter().enumerate() {
                let sign = if corner >> k & 1 == 1 { 1.0 } else { -1.0 };
                let now = changed.as_ref().unwrap_or(system);
                let x = current(now, path).ok_or_else(|| unknown(now, path))?;
                changed = Some(varied(now, path, x * (1.0 + sign * share))?);
            }
            let known = main.passage.as_ref().filter(|_| self.uncertain.iter().all(|u| only_liquid(system, &u.0)));
            let Some(found) = self.evaluate(changed.as_ref().unwrap_or(system), context, Care::Ends, known, *speeds)? else {
                return Ok(None);
            };
            *speeds += found.points.len() as u64;
            let other: Vec<(f64, f64)> = found.intervals.iter().map(|i| (i.low.speed, i.high.speed)).collect();
            kept = kept.iter().flat_map(|a| other.iter().map(move |b| (a.0.max(b.0), a.1.min(b.1)))).filter(|i| i.0 <= i.1).collect();
        }
        // a speed that may be off by the tolerance must stay inside
        let intervals =
            kept.into_iter().map(|(a, b)| (a / (1.0 - self.tolerance), b / (1.0 + self.tolerance))).filter(|i| i.0 <= i.1).collect();
        Ok(Some(Robust { intervals, corners }))
    }

    /// The least margin over speed and the parameter of the map, where it is required; `None` when it was stopped. Counts the speeds evaluated.
    pub(super) fn mapped(&self, system: &System, context: &Context, main: &Evaluated, speeds: &mut u64) -> Result<Option<Map>, Diagnostic> {
        let Some((path, r)) = &self.map else { return Ok(None) };
        let mut cells = Vec::new();
        let unit = unit_of(system, path);
        let grid = RangeValue { points: Some(SPEEDS / 2), ..self.speed }.linspace(SPEEDS / 2);
        // what does not weigh changes the separation alone
        let moving = match only_friction(system, path) {
            true => {
                let Some(found) = self.evaluate(system, context, Care::Only(&grid), main.passage.as_ref(), *speeds)? else {
                    return Ok(None);
                };
                *speeds += found.points.len() as u64;
                Some(found)
            }
            false => None,
        };
        for x in r.linspace(MAP_POINTS) {
            let changed = varied(system, path, x)?;
            let points = if let Some(moving) = &moving {
                if !context.goes_on(*speeds) {
                    return Ok(None);
                }
                *speeds += moving.points.len() as u64;
                let required = fitting(self, &changed, true)?;
                let evaluator = Evaluator { system: &changed, required: &required, branches: None, passage: main.passage.as_ref() };
                let mut points = moving.points.clone();
                let here = Here::now();
                points.par_iter_mut().for_each(|p| {
                    let _counted = here.enter();
                    evaluator.separated_down_to(LEAST, p);
                });
                points
            } else {
                let known = main.passage.as_ref().filter(|_| only_liquid(system, path));
                let Some(found) = self.evaluate(&changed, context, Care::Only(&grid), known, *speeds)? else { return Ok(None) };
                *speeds += found.points.len() as u64;
                found.points
            };
            for &w in &grid {
                if let Some(p) = points.iter().min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs())) {
                    let binding = p.binding().map_or("", |m| margins::NAMES[m.name]);
                    cells.push(Cell { speed: w, value: x, margin: p.least().max(LEAST), binding });
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

/// Unit of a parameter of a part, or of a block beside the parts.
fn unit_of(system: &System, path: &str) -> &'static str {
    system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or_else(|| extra_unit(path), |s| s.unit)
}

/// Unit of a parameter of a cup or the suspension.
fn extra_unit(path: &str) -> &'static str {
    let name = path.split_once('.').map_or("", |p| p.1);
    let known = blocks();
    let fields = known.iter().flat_map(|b| &b.info.kinds).flat_map(|k| &k.fields);
    fields
        .filter(|f| f.name == name)
        .find_map(|f| match f.kind {
            FieldKind::Quantity { unit, .. } => Some(unit),
            _ => None,
        })
        .unwrap_or("")
}

/// Value of a parameter of a part, or of a block beside the parts.
pub(super) fn current(system: &System, path: &str) -> Option<f64> {
    if let Some(i) = system.param(path) {
        return system.params().get(*i.first()?).copied();
    }
    let (name, field) = path.split_once('.')?;
    system.machine.extras.iter().find(|e| e.name == name)?.values.number(field)
}

/// That there is no such parameter, with those that its part, or its block beside the parts, has.
pub(super) fn unknown(system: &System, path: &str) -> Diagnostic {
    let plain = system.unknown_param(path);
    let name = path.split('.').next().unwrap_or_default();
    let Some(extra) = system.machine.extras.iter().find(|e| e.name == name) else { return plain };
    let known = blocks();
    let fields = known.iter().filter(|b| b.info.word == extra.word).flat_map(|b| &b.info.kinds).flat_map(|k| &k.fields);
    let mut own: Vec<String> = Vec::new();
    for f in fields.filter(|f| matches!(f.kind, FieldKind::Quantity { .. }) && extra.values.number(f.name).is_some()) {
        let path = format!("{name}.{}", f.name);
        if !own.contains(&path) {
            own.push(path);
        }
    }
    if own.is_empty() { plain } else { plain.help(text!("numbers of \"{name}\": {own}", name, own = own.join(", "))) }
}

/// The machine with a parameter changed.
pub(super) fn varied(system: &System, path: &str, x: f64) -> Result<System, Diagnostic> {
    let bounds = || {
        Diagnostic::error(
            "parameter.bounds",
            text!("{path} cannot be {value}", path, value = text::quantity(x, unit_of(system, path).to_string())),
        )
    };
    let first = |d: Diagnostics| d.0.into_iter().next().unwrap_or_else(bounds);
    if system.param(path).is_some() {
        return system.with(&[(path, x)]).map_err(first);
    }
    let (name, field) = path.split_once('.').ok_or_else(|| unknown(system, path))?;
    let mut extras: Vec<Extra> = system.machine.extras.clone();
    let extra = extras.iter_mut().find(|e| e.name == name).ok_or_else(|| unknown(system, path))?;
    if extra.values.number(field).is_none() {
        return Err(Diagnostic::error("parameter.unknown", text!("\"{name}\" has no number {field} to vary", name, field))
            .help(text!("give it a value in its block first")));
    }
    let span = extra.values.span_of(field);
    extra.values.set(field, Value::Number(x), span);
    let word = extra.word;
    let changed = extra.clone();
    let out = system.with_extras(extras).map_err(first)?;
    let mut wrong = Diagnostics::default();
    if let Some(kind) = blocks().into_iter().find(|b| b.info.word == word) {
        (kind.check)(&changed, &out, &mut wrong);
    }
    if wrong.has_errors() { Err(first(wrong)) } else { with_blocks(out).map_err(first) }
}
