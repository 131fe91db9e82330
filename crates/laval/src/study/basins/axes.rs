//! The two initial values that are varied.

use super::super::start::{self, Entry, state_names};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{RangeValue, Values};
use crate::model::system::System;

/// Points along an axis that says none.
pub(super) const DEFAULT_POINTS: usize = 50;
/// Most points along an axis, and on the whole grid.
pub(super) const MOST_POINTS: f64 = 10_000.0;
const MOST_CELLS: usize = 250_000;

/// One initial value, from end to end.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    /// Name of the state.
    pub name: String,
    /// Its SI unit.
    pub unit: String,
    /// Its place in the state (q, v, z).
    pub index: usize,
    range: RangeValue,
}

impl Axis {
    /// Its values, rising.
    pub fn values(&self) -> Vec<f64> {
        self.range.linspace(DEFAULT_POINTS)
    }
    /// Distance of neighbouring values.
    pub fn step(&self) -> f64 {
        (self.range.to - self.range.from) / (self.range.points.unwrap_or(DEFAULT_POINTS).max(2) - 1) as f64
    }
    /// A value lies between its ends.
    pub fn holds(&self, x: f64) -> bool {
        self.range.from <= x && x <= self.range.to
    }
}

/// Reads `from`, `to` and `points`; says all that is wrong.
pub(super) fn read(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<[Axis; 2]> {
    let before = diagnostics.0.len();
    let mut ends = ["from", "to"].map(|field| {
        let mut found: Vec<(usize, f64)> =
            start::state_map(values, field, system, diagnostics).into_iter().map(|(e, x): (Entry, f64)| (e.index(system), x)).collect();
        let given = values.state_map(field).map_or(0, <[_]>::len);
        if given != 2 {
            let message = format!("{field} must name two initial values; it names {given}");
            let help = format!("write {field} = {{ \"drum.x\" = \"1 mm\", \"drum.y\" = \"1 mm\" }}");
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
        let list = |ends: &[(usize, f64)]| ends.iter().map(|e| format!("\"{}\"", names[e.0].0)).collect::<Vec<_>>().join(" and ");
        let message = format!("to names {}, but from names {}", list(&to), list(&from));
        diagnostics.push(Diagnostic::error("basins.axes", message).at(values.span_of("to")).help("both name the same two"));
        return None;
    }
    let points = points(values, &from.iter().map(|f| names[f.0].0.as_str()).collect::<Vec<_>>(), diagnostics);
    let mut axes = Vec::new();
    for (k, ((index, from), (_, to))) in from.into_iter().zip(to).enumerate() {
        let (name, unit) = names[index].clone();
        if !(from < to) {
            let message = format!("\"{name}\" must go from a lower to a higher value");
            diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("to")).help("exchange from and to"));
        }
        axes.push(Axis { name, unit, index, range: RangeValue { from, to, points: Some(points[k]) } });
    }
    let cells = points[0].saturating_mul(points[1]);
    if cells > MOST_CELLS {
        let message = format!("a grid of {} by {} points is too large", points[0], points[1]);
        let help = format!("at most {MOST_CELLS} points in all");
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
            let message = format!("points must be whole numbers from 2 to {MOST_POINTS}, not {x}");
            diagnostics.push(Diagnostic::error("basins.points", message).at(values.span_of("points")));
        }
        let count = if whole { x as usize } else { DEFAULT_POINTS };
        match name.map(|n| (n, names.iter().position(|o| *o == n))) {
            None => out = [count; 2],
            Some((_, Some(k))) => out[k] = count,
            Some((n, None)) => {
                let message = format!("points names \"{n}\", which is not varied");
                let help = format!("varied are {}", names.iter().map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(" and "));
                diagnostics.push(Diagnostic::error("basins.points", message).at(values.span_of("points")).about(n).help(help));
            }
        }
    }
    out
}
