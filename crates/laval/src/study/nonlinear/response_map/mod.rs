//! The nonlinear response of many machines that differ in two parameters: where they jump, how far, how high their peak is, where they are unstable.
//!
//! Equations: those of [`nonlinear_response`](super::nonlinear_response), one complete response for every cell of the grid.
//!
//! Symbols: x, y the two parameters; W spin speed, rad/s.
//!
//! Validity: as there, with the states of the branches from both ends of the range of speeds. A machine that does not exist or whose response cannot be
//! computed is a cell without numbers, with the reason; it does not end the study.
//!
//! Sources: `docs/theory/harmonic-balance.md#continuation`, `docs/theory/harmonic-balance.md#stability`.

mod border;
mod cells;
mod figures;
mod report;

use super::nonlinear_response::summary::Summary;
use super::nonlinear_response::{self as single, HARMONICS, MAX_POINTS, SPEED, STABILITY, SYMMETRY, TRUNCATION};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values, Word};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{End, Outcome};
use crate::solve::harmonic::branches::response::Request;
use crate::store::{self, Collected};
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::range;
use crate::study::{Context, Study};
use crate::text;
use cells::Cell;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicU64, Ordering};

const SPACINGS: &[Word] = &[("linear", "equal steps"), ("logarithmic", "equal ratios")];
/// Points along an axis that says none.
const DEFAULT_POINTS: usize = 20;
/// Most cells of a map.
const MOST_CELLS: usize = 100_000;

/// One parameter, from end to end.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterAxis {
    /// Path; a lateral pair without `.x` or `.y` changes both halves together.
    pub path: String,
    /// Its SI unit.
    pub unit: &'static str,
    /// Ends and number of points.
    pub range: RangeValue,
    /// Equal ratios instead of equal steps.
    pub logarithmic: bool,
}

impl ParameterAxis {
    /// Its values, rising; the ends are exactly those requested.
    pub fn values(&self) -> Vec<f64> {
        let even = self.range.linspace(DEFAULT_POINTS);
        if !self.logarithmic {
            return even;
        }
        let (from, to, last) = (self.range.from, self.range.to, even.len() - 1);
        let one = |i: usize| match i {
            0 => from,
            i if i == last => to,
            i => from * (to / from).powf(i as f64 / last as f64),
        };
        (0..=last).map(one).collect()
    }
}

/// See the [module](self).
pub struct ResponseMap {
    /// What varies along x and along y.
    pub axes: [ParameterAxis; 2],
    /// What is computed for every machine.
    pub request: Request,
}

const fn parameter(name: &'static str, doc: &'static str) -> Field {
    Field::required(name, FieldKind::ParameterRange, doc)
}
const fn spacing(name: &'static str, doc: &'static str) -> Field {
    Field::optional(name, FieldKind::Choice(SPACINGS), "linear", doc)
}

impl Study for ResponseMap {
    type Result = ResponseMapResult;
    const KIND: &'static str = "response_map";
    const IN_CHUNKS: bool = true;
    const EXAMPLE: &'static str = r#"x = { parameter = "drum.mass", from = "2 kg", to = "4 kg", points = 9 }
y = { parameter = "drum.eccentricity", from = "10 um", to = "100 um", points = 9 }
speed = { from = "100 rpm", to = "12000 rpm" }
"#;
    const DOC: &'static str = "The nonlinear response over a grid of two parameters of the machine, a complete one in every cell: largest peak and its \
        speed, folds, jump speeds of slow sweeps up and down, width of the hysteresis, unstable ranges; and the border between machines that jump and \
        machines that do not. A cell has the numbers that nonlinear_response finds for its machine.";
    const FIELDS: &'static [Field] = &[
        parameter("x", "the parameter along x; 20 points unless given"),
        parameter("y", "the parameter along y; 20 points unless given"),
        spacing("x_spacing", "how the points along x are spaced"),
        spacing("y_spacing", "how the points along y are spaced"),
        SPEED,
        HARMONICS,
        TRUNCATION,
        SYMMETRY,
        STABILITY,
        MAX_POINTS,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let request = single::request(values, diagnostics);
        let axes = [("x", "x_spacing"), ("y", "y_spacing")].map(|(field, spacing)| axis(field, spacing, values, system, diagnostics));
        let [Some(x), Some(y)] = axes else { return None };
        let (mine, other) = (system.param(&x.path).unwrap_or_default(), system.param(&y.path).unwrap_or_default());
        if mine.iter().any(|i| other.contains(i)) {
            let message = text!("\"{first}\" and \"{second}\" are the same parameter", first = x.path, second = y.path);
            let help = text!("vary two parameters; for one, see nonlinear_response with uncertainty, or give y another");
            diagnostics.push(Diagnostic::error("response_map.parameter", message).at(values.span_of("y")).help(help));
        }
        let count = |a: &ParameterAxis| a.range.points.unwrap_or(DEFAULT_POINTS);
        if count(&x).saturating_mul(count(&y)) > MOST_CELLS {
            let message = text!("a map of {x} by {y} machines is too large", x = count(&x), y = count(&y));
            let help = text!("at most {most} machines in all", most = MOST_CELLS);
            diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("y")).help(help));
        }
        if diagnostics.0.len() > before { None } else { Some(ResponseMap { axes: [x, y], request: request? }) }
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.request.speeds.0, self.request.speeds.1)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let cells = self.axes.iter().map(|a| a.values().len()).product();
        Some(Size::of_rows(cells, 24 + 8 * system.stations().len()))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        single::admit(system, &self.request)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<ResponseMapResult, Diagnostic> {
        self.admit(system)?;
        let values = self.axes.each_ref().map(ParameterAxis::values);
        let rows = values[0].len() * values[1].len();
        let columns = cells::columns(&self.axes, system.probes().iter().any(Probe::is_tilt));
        let plan = store::Plan {
            study: Self::KIND.into(),
            columns: columns.iter().map(|c| c.column.clone()).collect(),
            rows,
            // settled by the request alone, so that a resumed study finds its chunks; small, because a row may take seconds
            chunk: rows.div_ceil(50).clamp(4, 16),
        };
        context.announce(rows as f64, 400.0, text!("responses to compute"));
        let spent = AtomicU64::new(0);
        let results = store::run(plan, context, |range, counter| {
            // The limit counts points of responses. It never shortens a response, which would then be kept as if it were complete: a chunk
            // whose points are within the limit is kept, whatever the number of threads, and any other is dropped.
            let here = Here::now();
            let one = |row: usize| {
                let _counted = here.enter();
                if counter.cancelled() || spent.load(Ordering::Relaxed) > context.work_limit {
                    return Cell { at: [f64::NAN; 2], found: Err(String::new()), stopped: true };
                }
                let at = [values[0][row % values[0].len()], values[1][row / values[0].len()]];
                let cell = self.cell(system, at, context);
                spent.fetch_add(cell.found.as_ref().map_or(0, |s| s.work), Ordering::Relaxed);
                counter.add(1);
                cell
            };
            let all: Vec<Cell> = range.into_par_iter().map(one).collect();
            let over = spent.load(Ordering::Relaxed) > context.work_limit;
            Ok((!over && !all.iter().any(|c| c.stopped)).then(|| cells::write(&columns, &all)))
        })?;
        let cells = Collected::of(&results)?;
        let end = context.end(cells.end == End::Reached);
        Ok(ResponseMapResult { cells, end })
    }

    fn report(&self, system: &System, result: &ResponseMapResult, name: &str) -> Result<Outcome, Diagnostic> {
        report::report(self, system, result, name)
    }
}

/// The machines of the map and what their responses come to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ResponseMapResult {
    /// One row for each machine, along x and then along y; columns as in the table `map`.
    pub cells: Collected,
    /// How the study ended.
    pub end: End,
}

/// One parameter and its values; says all that is wrong.
fn axis(field: &str, spacing: &str, values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<ParameterAxis> {
    let (path, given) = values.parameter_range(field)?;
    let range = range(field, given, 2, values, diagnostics);
    let slot = system.param(path).and_then(|i| system.param_slots().get(*i.first()?));
    if slot.is_none() {
        diagnostics.push(system.unknown_param(path).at(values.span_of(field)));
    }
    let logarithmic = values.choice(spacing) == Some("logarithmic");
    if logarithmic && !(given.from > 0.0) {
        let message = text!("{field} is spaced in equal ratios, but does not begin above 0", field);
        let help = text!("begin above 0, or leave {spacing} out", spacing);
        diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of(field)).help(help));
        return None;
    }
    Some(ParameterAxis { path: path.to_string(), unit: slot?.unit, range: range?, logarithmic })
}

impl ResponseMap {
    /// The response of one machine.
    fn cell(&self, system: &System, at: [f64; 2], context: &Context) -> Cell {
        let changes = [0, 1].map(|k| (self.axes[k].path.as_str(), at[k]));
        let found = system
            .with(&changes)
            .map_err(Diagnostics::into_error)
            .and_then(|machine| Summary::of(&machine, &self.request, context.cancel))
            .map_err(|d| format!("{}: {}", d.code, d.message));
        let stopped = context.cancelled() || found.as_ref().is_ok_and(|s| s.end == End::Cancelled);
        Cell { at, found: found.map(Box::new), stopped }
    }
}
