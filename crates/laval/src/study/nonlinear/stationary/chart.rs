//! The balanced state over speed and one parameter: whether it exists, how fast disturbances of it grow, and how many other states are stable.

use super::classify::{Class, Scale, Seen};
use super::continua::{Continua, continua};
use super::follow::{Follower, Why};
use super::{Context, changed, listed, spread, wide};
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::solve::stationary::{Change, Found, Request, Search, State};
use crate::study::shared::support::larger;
use crate::text;
use laval_num::order::SortByNumber;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicU64, Ordering};

/// Seed speeds of a row: neighbouring rows see what one would miss.
const SEEDS: usize = 3;

/// What may be the case at a cell.
pub const WORDS: &[&str] = &["balanced only", "balanced or not", "not balanced", "none stable"];

/// A speed and a value.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Cell {
    pub speed: f64,
    pub value: f64,
    /// Largest growth rate of the state that balances best, 1/s; NaN where no state balances.
    pub growth: f64,
    /// Kind of that state.
    pub class: Option<Class>,
    /// It does not grow.
    calm: bool,
    /// The state where it is isolated.
    x: Option<Vec<f64>>,
    /// Stable states; a continuum counts once.
    pub stable: usize,
    /// One of them balances, and one does not.
    pub balances: bool,
    pub other: bool,
    /// Largest unbalance of a stable state over that without the movable masses; NaN where none is stable.
    pub share: f64,
}

impl Cell {
    /// One of [`WORDS`].
    pub fn word(&self) -> &'static str {
        WORDS[match (self.balances, self.other) {
            (true, false) => 0,
            (true, true) => 1,
            (false, true) => 2,
            (false, false) => 3,
        }]
    }
}

/// What happens at a point of the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// The state vanishes, or meets its mirror image.
    Exists,
    /// It goes on, and leaves more than half of the unbalance.
    Half,
    /// Its stability changes.
    Stability,
}

impl Kind {
    /// The words in the table.
    pub fn words(self) -> &'static str {
        match self {
            Kind::Exists => "limit of existence",
            Kind::Half => "half of the unbalance left",
            Kind::Stability => "stability changes",
        }
    }
}

/// A located point of the boundary of the balanced state.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Edge {
    pub speed: f64,
    pub value: f64,
    pub kind: Kind,
    /// Frequency of the root that crosses, rad/s in turning axes; NaN for limits of existence and continua.
    pub frequency: f64,
}

/// The chart.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Chart {
    pub path: String,
    /// Its values are spread by ratios.
    pub wide: bool,
    pub cells: Vec<Cell>,
    pub edges: Vec<Edge>,
    /// Not all rows were computed.
    pub stopped: bool,
}

/// A row: one machine over all speeds.
fn row(
    system: &System,
    value: f64,
    speeds: &[f64],
    request: &Request,
    context: &Context,
) -> Result<(Vec<Cell>, Vec<Edge>, bool), Diagnostic> {
    let mut search = Search::new(system, request, context.cancel);
    let found = search.run(|p| !context.cancelled() && p.work < request.work)?;
    let mut spent = found.work;
    let mut goes_on = |more: u64| {
        spent = spent.saturating_add(more);
        !context.cancelled() && spent < request.work
    };
    let loose = continua(system, &mut search, &found, speeds, &mut goes_on)?;
    let mut cells = Vec::new();
    for &speed in speeds {
        let rows = listed(system, &mut search, &found, speed)?;
        let mut cell = Cell {
            speed,
            value,
            growth: f64::NAN,
            class: None,
            calm: false,
            x: None,
            stable: 0,
            balances: false,
            other: false,
            share: f64::NAN,
        };
        let own = rows.iter().map(|r| (r.class, r.stability.growth(), r.stable(), r.seen.share().unwrap_or(f64::NAN), Some(&r.state.x)));
        let sheets = loose.sheets.iter().filter(|s| s.speed == speed).map(|s| (s.class, s.growth.0, s.stable > 0, s.share, None));
        for (class, growth, stable, share, x) in own.chain(sheets) {
            if class.balances() && cell.class.is_none_or(|c| (class, growth) < (c, cell.growth)) {
                (cell.class, cell.growth, cell.calm, cell.x) = (Some(class), growth, stable, x.cloned());
            }
            if stable {
                cell.stable += 1;
                cell.balances |= class.balances();
                cell.other |= !class.balances();
                cell.share = if cell.share.is_nan() { share } else { larger(cell.share, share) };
            }
        }
        cells.push(cell);
        if !goes_on(1 + rows.len() as u64) {
            break;
        }
    }
    let edges = edges(system, value, &mut search, &found, &loose);
    let stopped = found.stopped || cells.len() < speeds.len() || !goes_on(0);
    Ok((cells, edges, stopped))
}

/// Where the balanced state begins, ends or changes its stability along a row.
fn edges(system: &System, value: f64, search: &mut Search, found: &Found, loose: &Continua) -> Vec<Edge> {
    let mut out: Vec<Edge> = Vec::new();
    let mut balances = |state: &State| {
        let scale = Scale::at(system, search, state.speed);
        Seen::of(system, search, state).class(&scale).balances()
    };
    for path in &found.paths {
        for l in path.special.iter().filter(|l| l.located) {
            let steady = l.growing.0.min(l.growing.1) == 0 && l.growing.0 != l.growing.1;
            let kind = match l.change {
                Change::Hopf | Change::Real if steady => Kind::Stability,
                Change::Hopf | Change::Real => continue,
                Change::Fold | Change::BranchPoint => {
                    let near = [path.points.iter().rfind(|p| p.s < l.s), path.points.iter().find(|p| p.s > l.s)];
                    let sides = near.map(|p| p.map(|p| (p.state.speed > l.state.speed, balances(&p.state))));
                    match sides {
                        // the state goes on beyond the place where another branch crosses it
                        [Some((a, true)), Some((b, true))] if a != b && steady => Kind::Stability,
                        [Some((a, true)), Some((b, true))] if a != b => continue,
                        [Some((_, true)), _] | [_, Some((_, true))] => Kind::Exists,
                        _ => continue,
                    }
                }
            };
            if !balances(&l.state) {
                continue;
            }
            let frequency = if matches!(l.change, Change::Hopf | Change::Real) { l.frequency } else { f64::NAN };
            let near = |e: &Edge| e.kind == kind && (e.speed - l.state.speed).abs() <= 1e-9 * e.speed.abs();
            if !out.iter().any(near) {
                out.push(Edge { speed: l.state.speed, value, kind, frequency });
            }
        }
    }
    let (first, last) = search.range();
    for s in loose.spans.iter().filter(|s| s.class.balances()) {
        for speed in [s.from, s.to].into_iter().filter(|w| *w > first && *w < last) {
            out.push(Edge { speed, value, kind: if s.stable { Kind::Stability } else { Kind::Exists }, frequency: f64::NAN });
        }
    }
    out.sort_by_number(|a| a.speed);
    out
}

/// The boundary between neighbouring rows, where the balanced state exists on one side only or is stable on one side only, at each speed: the state is
/// followed from the one value to the other.
fn across(system: &System, path: &str, rows: &[(Vec<Cell>, Vec<Edge>, bool)], request: &Request, context: &Context) -> Vec<Edge> {
    let count = rows.iter().map(|r| r.0.len()).min().unwrap_or(0);
    let here = Here::now();
    let place = |j: usize| {
        let _counted = here.enter();
        let mut out = Vec::new();
        for pair in rows.windows(2) {
            let (a, b) = (&pair[0].0[j], &pair[1].0[j]);
            let status = |c: &Cell| (c.class.is_some(), c.calm);
            // from a side on which there is an isolated state
            let (from, to) = if a.x.is_some() { (a, b) } else { (b, a) };
            let Some(x) = from.x.as_ref().filter(|_| status(a) != status(b)) else { continue };
            if to.class.is_some() && to.x.is_none() {
                continue;
            }
            if context.cancelled() {
                return out;
            }
            let range = RangeValue { from: a.value.min(b.value), to: a.value.max(b.value), points: None };
            let Ok(mut follower) = Follower::between(system, path, &range, from.speed, request, context.cancel) else { continue };
            let reach = follower.reach(x, from.value, to.value > from.value);
            let mut edge = |value: f64, kind: Kind, frequency: f64| out.push(Edge { speed: from.speed, value, kind, frequency });
            match reach.limit {
                Some(l) if l.why == Why::Exists && l.located => edge(l.value, Kind::Exists, f64::NAN),
                Some(l) if l.why == Why::Half => edge(l.value, Kind::Half, f64::NAN),
                Some(_) => {}
                None => {
                    let ends = [from.value, to.value].map(|v| Some((v, follower.at(&reach, v)?.growth)));
                    if let [Some(p), Some(q)] = ends
                        && let Some((value, frequency)) = follower.change(&reach, [p, q])
                    {
                        edge(value, Kind::Stability, frequency);
                    }
                }
            }
        }
        out
    };
    (0..count).into_par_iter().map(place).collect::<Vec<_>>().concat()
}

/// Over these values and speeds, each row from its own machine, on all processors.
///
/// # Errors
/// Eigenvalues that cannot be computed; a machine that does not exist at a value.
pub fn chart(
    system: &System,
    path: &str,
    range: &RangeValue,
    speeds: &[f64],
    request: &Request,
    context: &Context,
    spent: u64,
) -> Result<Chart, Diagnostic> {
    let values = spread(range, super::POINTS);
    context.announce((values.len() * speeds.len()) as f64, 2_000.0, text!("cells of the chart"));
    // every row has its share of the work, so that none depends on the number of threads
    let work = context.work_limit.saturating_sub(spent) / values.len() as u64;
    let skip = request.seeds.len().div_ceil(SEEDS);
    let seeds = request.seeds.iter().copied().step_by(skip.max(1)).collect();
    let own = Request { seeds, work, ..request.clone() };
    let (done, total) = (AtomicU64::new(0), values.len() as u64);
    let here = Here::now();
    let rows: Vec<(Vec<Cell>, Vec<Edge>, bool)> = values
        .par_iter()
        .map(|&value| {
            let _counted = here.enter();
            if work == 0 || context.cancelled() {
                return Ok((Vec::new(), Vec::new(), true));
            }
            let found = row(&changed(system, path, value)?, value, speeds, &own, context)?;
            context.progress.report((done.fetch_add(1, Ordering::Relaxed) + 1).min(total), total);
            Ok(found)
        })
        .collect::<Result<_, Diagnostic>>()?;
    let stopped = rows.iter().any(|r| r.2);
    let between = if stopped { Vec::new() } else { across(system, path, &rows, &own, context) };
    let (mut cells, mut edges) = (Vec::new(), Vec::new());
    for (own, limits, _) in rows {
        cells.extend(own);
        edges.extend(limits);
    }
    edges.extend(between);
    Ok(Chart { path: path.to_string(), wide: wide(range), cells, edges, stopped })
}
