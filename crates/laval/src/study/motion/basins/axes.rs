//! The two initial values that are varied.

use super::super::start::{self, Entry, state_names};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{RangeValue, Values};
use crate::model::part::DofKind;
use crate::model::system::System;
use crate::outcome::Arg;
use crate::study::shared::support::{apart, range};
use crate::text;
use crate::text::Joint;

/// Points along an axis that says none.
pub(super) const DEFAULT_POINTS: usize = 50;
/// Most points along an axis.
pub(super) const MOST_POINTS: f64 = 10_000.0;

/// One initial value, or the duration of the run-up, from end to end.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct InitialValueAxis {
    /// Name of the state.
    pub name: String,
    /// Its SI unit.
    pub unit: String,
    /// Its place in the state (q, v, z); none of the run-up.
    pub index: Option<usize>,
    range: RangeValue,
}

impl InitialValueAxis {
    /// Its values, rising.
    pub fn values(&self) -> Vec<f64> {
        self.range.linspace(DEFAULT_POINTS)
    }
    /// Distance of neighbouring values.
    pub fn step(&self) -> f64 {
        (self.range.to - self.range.from) / (self.range.points.unwrap_or(DEFAULT_POINTS).max(2) - 1) as f64
    }
    /// What its values are.
    pub fn meaning(&self) -> Arg {
        if self.index.is_some() { Arg::of("initial value", Arg::name(&self.name)) } else { "duration of the run-up".into() }
    }
    /// Its name in a figure.
    pub fn label(&self) -> Arg {
        if self.index.is_some() { Arg::name(&self.name) } else { "duration of the run-up".into() }
    }
    /// A value lies between its ends.
    pub fn holds(&self, x: f64) -> bool {
        self.range.from <= x && x <= self.range.to
    }
}

/// Reads `from`, `to` and `points`, of which there may be so many cells; says all that is wrong.
pub(super) fn read(values: &Values, system: &System, most: usize, diagnostics: &mut Diagnostics) -> Option<[InitialValueAxis; 2]> {
    let before = diagnostics.0.len();
    let run_up = values.range("run_up").and_then(|r| range("run_up", r, 2, values, diagnostics));
    let wanted = if values.get("run_up").is_some() { 1 } else { 2 };
    let mut ends = ["from", "to"].map(|field| {
        let mut found: Vec<(usize, f64)> =
            start::state_map(values, field, system, diagnostics).into_iter().map(|(e, x): (Entry, f64)| (e.index(system), x)).collect();
        let given = values.state_map(field).map_or(0, <[_]>::len);
        if given != wanted {
            let message = match wanted {
                1 => text!("{field} must name one initial value beside the run-up; it names {given}", field, given),
                _ => text!("{field} must name two initial values; it names {given}", field, given),
            };
            // names of this machine
            let masses = system.coordinates().iter().filter(|c| c.dof.kind == DofKind::Scalar && c.dof.unit == "rad");
            let body = system.stations().iter().next().map_or_else(|| "rotor".to_string(), |s| s.name.clone());
            let help = match masses.map(|c| &c.name).next() {
                Some(mass) if wanted == 1 => text!("write {field} = {{ \"{mass}\" = \"1 rad\" }}", field, mass),
                _ if wanted == 1 => text!("write {field} = {{ \"{body}.x\" = \"1 mm\" }}", field, body),
                _ => text!("write {field} = {{ \"{body}.x\" = \"1 mm\", \"{body}.y\" = \"1 mm\" }}", field, body),
            };
            diagnostics.push(Diagnostic::error("basins.axes", message).at(values.span_of(field)).help(help));
        }
        found.sort_by_key(|f| f.0);
        found
    });
    if diagnostics.0.len() > before {
        return None;
    }
    let (to, from) = (std::mem::take(&mut ends[1]), std::mem::take(&mut ends[0]));
    let names = state_names(system);
    if !from.iter().map(|f| f.0).eq(to.iter().map(|t| t.0)) {
        let list = |ends: &[(usize, f64)]| text::list(ends.iter().map(|e| format!("\"{}\"", names[e.0].0)), Joint::Ands);
        let message = text!("to names {to}, but from names {from}", to = list(&to), from = list(&from));
        diagnostics.push(Diagnostic::error("basins.axes", message).at(values.span_of("to")).help(text!("both name the same")));
        return None;
    }
    let points = points(values, &from.iter().map(|f| names[f.0].0.as_str()).collect::<Vec<_>>(), diagnostics);
    let mut axes = Vec::new();
    for (k, ((index, from), (_, to))) in from.into_iter().zip(to).enumerate() {
        let (name, unit) = names[index].clone();
        if !(from < to) {
            let message = text!("\"{name}\" must go from a lower to a higher value", name);
            diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("to")).help(apart(from, to)));
        }
        axes.push(InitialValueAxis { name, unit, index: Some(index), range: RangeValue { from, to, points: Some(points[k]) } });
    }
    if let Some(run_up) = run_up {
        let count = run_up.points.unwrap_or(points[1]);
        axes.push(InitialValueAxis {
            name: "run-up".into(),
            unit: "s".into(),
            index: None,
            range: RangeValue { points: Some(count), ..run_up },
        });
    }
    let points: Vec<usize> = axes.iter().filter_map(|a| a.range.points).collect();
    let cells = points.iter().fold(1usize, |n, p| n.saturating_mul(*p));
    if cells > most {
        let message = text!("a grid of {first} by {second} points is too large", first = points[0], second = points[1]);
        let help = text!("at most {most} points in all", most);
        diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("points")).help(help));
    }
    if diagnostics.0.len() > before { None } else { axes.try_into().ok() }
}

/// Points along each of two axes.
fn points(values: &Values, names: &[&str], diagnostics: &mut Diagnostics) -> [usize; 2] {
    let mut out = [DEFAULT_POINTS; 2];
    for (name, x) in values.named("points") {
        let whole = x.fract() == 0.0 && (2.0..=MOST_POINTS).contains(&x);
        if !whole {
            let message = text!("points must be whole numbers from 2 to {most}, not {x}", most = MOST_POINTS, x);
            diagnostics.push(Diagnostic::error("basins.points", message).at(values.span_of("points")));
        }
        let count = if whole { x as usize } else { DEFAULT_POINTS };
        match name.map(|n| (n, names.iter().position(|o| *o == n))) {
            None => out = [count; 2],
            Some((_, Some(k))) => out[k] = count,
            Some((n, None)) => {
                let message = text!("points names \"{n}\", which is not varied", n);
                let help = text!("varied are {names}", names = text::list(names.iter().map(|n| format!("\"{n}\"")), Joint::Ands));
                diagnostics.push(Diagnostic::error("basins.points", message).at(values.span_of("points")).about(n).help(help));
            }
        }
    }
    out
}
