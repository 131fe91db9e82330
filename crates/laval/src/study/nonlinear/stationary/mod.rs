//! States at rest in axes that turn with the rotor, over a range of speeds: where a machine with movable masses balances itself, and where it does not.
//!
//! Equations: `r(q, W) = 0` with vectors turning and everything else constant; see [`crate::solve::stationary`]. Eigenvalues about a state are those of the
//! machine in turning axes, exact in memory and frequency-domain parts.
//!
//! Symbols: W spin speed; s = growth + i frequency in turning axes, 1/s and rad/s.
//!
//! Validity: constant speed; a machine that is the same in all directions, without weight across its axis. No number of starts proves that the list of
//! states is complete. States that are not isolated (three and more equal balls that balance in a continuum of ways) are assessed by samples of the continuum.
//!
//! Sources: `docs/theory/equilibria.md#states-in-rotating-axes`, `docs/theory/ball-balancers.md#stationary-states`; K. Green, A. R. Champneys, N. J. Lieven, J. Sound Vib. 291 (2006) 861.

mod chart;
pub(in crate::study) mod classify;
mod continua;
mod errors;
mod figures;
mod findings;
mod follow;
mod least;
mod one;
mod ranges;
mod report;
mod slack;
mod zones;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values};
use crate::model::system::{Drive, System};
use crate::outcome::{End, Outcome};
use crate::solve::co_rotating::isotropic;
use crate::solve::stationary::images::Images;
use crate::solve::stationary::{Found, Progress, Request, Search, Stability, State};
use crate::solve::symmetry::probed_speeds;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED, SPEED_RANGE, one_or_range, range};
use crate::study::{Context, Study};
use crate::text;
use chart::Chart;
use classify::{Class, Scale, Seen};
use continua::Continua;
use errors::Errors;
use laval_num::order::{SortByNumber, ascending};
use laval_num::work::Here;
use least::Least;
use rayon::prelude::*;
use report::Reported;
use serde::{Deserialize, Serialize};
use slack::Left;
use zones::Zone;

/// See the [module](self).
pub struct Stationary {
    speed: RangeValue,
    starts: usize,
    seeds: usize,
    max_points: usize,
    stabilise: Option<Varied>,
    chart: Option<(String, RangeValue)>,
    errors: Vec<Varied>,
}

/// A parameter over a range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Varied {
    /// Path.
    pub path: String,
    /// Values, in the unit of the parameter.
    pub range: RangeValue,
    /// Speed, rad/s.
    pub speed: f64,
}

/// Stationary states of a machine over the speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StationaryResult {
    /// Branches of states with their special points.
    pub found: Found,
    /// States at the speeds of the table.
    pub rows: Vec<Row>,
    /// Continua of states.
    pub continua: Continua,
    /// Ranges in which dry friction holds the masses about states of the table.
    pub zones: Vec<Zone>,
    /// What dry friction leaves on continua.
    pub slack: Vec<Left>,
    /// Values of a parameter that make the balanced state stable, where they are requested.
    pub least: Option<Least>,
    /// What errors of parameters cost.
    pub errors: Vec<Errors>,
    /// Stability over the speed and a parameter.
    pub chart: Option<Chart>,
    /// What the points of the branches show, and where which states are stable.
    pub shown: Reported,
    /// Special points at one place: branch and number among its special points.
    pub places: Vec<Vec<(usize, usize)>>,
    /// Nothing was left out for want of time.
    pub complete: bool,
    /// How the study ended.
    pub end: End,
}

/// Speeds of the table of states when none are given.
const POINTS: usize = 21;
/// Share of the highest speed below which the machine stands still and nothing holds the masses.
const STANDSTILL: f64 = 1e-4;
/// Share of the highest speed below which no start is made: what holds the masses there is little beside what holds the rotor.
const NEAR_REST: f64 = 0.01;
/// Intervals without a stable state in which one is sought once more, and the share of the range below which they count as none.
const GAPS: usize = 4;
const NARROW: f64 = 0.01;
/// Most points of a branch where the study says nothing else.
const MOST_POINTS: usize = 2000;
/// Most cells of a chart.
const MOST_CELLS: usize = 100_000;

impl Study for Stationary {
    type Result = StationaryResult;
    const KIND: &'static str = "stationary";
    const EXAMPLE: &'static str = r#"speed = { from = "3000 rpm", to = "12000 rpm", points = 31 }
chart = { parameter = "drum.eccentricity", from = "5 um", to = "100 um", points = 9 }
"#;
    const DOC: &'static str = "Where a machine with movable masses, such as the balls of a balancer, balances itself: its states at rest in axes that turn with \
        the rotor, all that are found from many starts, followed over the speed and classified (balanced, partly balanced, unbalance reduced, masses touching, together, opposed, \
        locked by a tilt), with eigenvalues, limits of existence and the speeds where stability changes. It says where states balance, where they make the unbalance \
        larger, where none is stable, and in which ranges dry friction holds the masses; on request the least value of a parameter, such as external damping, that makes the balanced state stable, a chart of \
        its stability over speed and one parameter, and what errors of tilt or eccentricity cost.";
    const FIELDS: &'static [Field] = &[
        Field::required(
            "speed",
            SPEED_RANGE,
            "speeds over which states are followed, from a ten-thousandth of the highest on (at standstill nothing holds the masses); points: number of speeds in the \
                table of states, 21 unless given",
        ),
        Field::optional(
            "starts",
            FieldKind::Integer { min: 1, max: 10_000 },
            "100",
            "starts at each of the speeds at which states are sought",
        ),
        Field::optional(
            "seeds",
            FieldKind::Integer { min: 1, max: 100 },
            "7",
            "number of these speeds: both ends of the range and others between them; 1 is the middle. Where no state is stable there are more",
        ),
        Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of one branch"),
        Field::optional(
            "stabilise",
            FieldKind::ParameterRange,
            "",
            "parameter and range in which the values are sought that make the balanced state stable, for instance an external damping",
        ),
        Field::optional(
            "stabilise_at",
            SPEED,
            "",
            "speed at which it is to be stable and at which errors are assessed; the machine's when left out",
        ),
        Field::optional(
            "chart",
            FieldKind::ParameterRange,
            "",
            "a parameter, such as the mass of the balls, for a chart of the balanced state and the number of stable states over it and the speed; 21 values unless given",
        ),
        Field::optional(
            "errors",
            FieldKind::ParameterRanges,
            "",
            "parameters and how far they may be off, such as the tilt of a track from 0 to 0.5 deg: what that costs",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = values.range("speed").and_then(|r| one_or_range("speed", r, 2, values, diagnostics));
        let whole = |name: &str, default: usize| values.integer(name).and_then(|n| usize::try_from(n).ok()).unwrap_or(default);
        let at = values.number("stabilise_at").or(system.machine.speed);
        let before = diagnostics.0.len();
        let varied = |field: &str, path: &str, given: RangeValue, diagnostics: &mut Diagnostics| {
            let found = range(field, given, 2, values, diagnostics);
            if system.param(path).is_none() {
                diagnostics.push(system.unknown_param(path).at(values.span_of(field)));
            }
            found.map(|range| (path.to_string(), range))
        };
        let stabilise = values.parameter_range("stabilise").and_then(|(path, given)| varied("stabilise", path, given, diagnostics));
        let chart = values.parameter_range("chart").and_then(|(path, given)| varied("chart", path, given, diagnostics));
        let lists: Vec<(String, RangeValue)> = values
            .parameter_ranges("errors")
            .unwrap_or_default()
            .iter()
            .filter_map(|(path, given, _)| varied("errors", path, *given, diagnostics))
            .collect();
        if let (Some(s), Some((_, c))) = (&speed, &chart)
            && s.points.unwrap_or(POINTS).saturating_mul(c.points.unwrap_or(POINTS)) > MOST_CELLS
        {
            diagnostics.push(
                Diagnostic::error("study.range", text!("the chart has too many cells"))
                    .at(values.span_of("chart"))
                    .help(text!("at most {most} speeds times values", most = MOST_CELLS)),
            );
        }
        for field in ["stabilise", "errors"] {
            let requested = if field == "errors" { !lists.is_empty() } else { stabilise.is_some() };
            if requested && at.is_none() {
                diagnostics.push(
                    Diagnostic::error("stationary.speed", text!("{field} needs the speed of the state that is meant", field))
                        .at(values.span_of(field))
                        .help(text!("give stabilise_at = \"3000 rpm\", or a speed in [machine]")),
                );
            }
        }
        let speed = speed.filter(|_| diagnostics.0.len() == before)?;
        let named = |(path, range): (String, RangeValue)| at.map(|speed| Varied { path, range, speed });
        Some(Stationary {
            speed,
            starts: whole("starts", 100),
            seeds: whole("seeds", 7),
            max_points: whole("max_points", 2000),
            stabilise: stabilise.and_then(named),
            chart,
            errors: lists.into_iter().filter_map(named).collect(),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        let assessed = self.stabilise.iter().chain(&self.errors).map(|v| SpinSpeeds::one(v.speed));
        std::iter::once(SpinSpeeds::between(self.speed.from, self.speed.to)).chain(assessed).collect()
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(Size::of_branch(self.max_points, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "stationary.drive",
                text!("stationary states are sought at given speeds, and the speed of this machine is free"),
            )
            .help(text!("prescribe the speed of the machine, or follow the free machine in time with a transient study")));
        }
        let probed = probed_speeds((self.speed.from, self.speed.to));
        for w in probed.iter().copied().chain(self.stabilise.iter().chain(&self.errors).map(|s| s.speed)) {
            isotropic(system, w)?;
        }
        crate::solve::pencil::time_forms(system)?;
        let varied = self.stabilise.iter().chain(&self.errors).map(|v| (&v.path, v.range, v.speed));
        let middle = 0.5 * (self.speed.from + self.speed.to);
        for (path, range, speed) in varied.chain(self.chart.iter().map(|(path, range)| (path, *range, middle))) {
            for x in [range.from, range.to] {
                isotropic(&changed(system, path, x)?, speed).map_err(|d| {
                    let message = text!("at {path} = {x}: {message}", path, x, message = d.message);
                    Diagnostic { message, ..d }
                })?;
            }
        }
        Ok(())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<StationaryResult, Diagnostic> {
        Study::admit(self, system)?;
        let request = self.request(context.work_limit);
        context.announce((request.seeds.len() * request.starts) as f64, 5_000.0, text!("starts to follow"));
        let mut search = Search::new(system, &request, context.cancel);
        let mut each = |p: Progress| {
            context.progress.report(p.done, p.total);
            context.goes_on(p.work)
        };
        let mut found = search.run(&mut each)?;
        let speeds = self.speeds(system);
        let (mut spent, mut complete) = (found.work, !found.stopped);
        let mut goes_on = |more: u64| {
            spent = spent.saturating_add(more);
            let on = context.goes_on(spent);
            complete &= on;
            on
        };
        let mut continua = continua::continua(system, &mut search, &found, &speeds, &mut goes_on)?;
        let width = request.range.1 - request.range.0;
        let again = within(ranges::without_stable(&found, &continua.spans, request.range, NARROW * width));
        if !again.is_empty() && goes_on(0) {
            let (work, loose) = (found.work, found.loose.len());
            context.announce((again.len() * request.starts) as f64, 5_000.0, text!("starts to follow where no state is stable"));
            search.seek(&mut found, &again, &mut each)?;
            goes_on(found.work - work);
            if found.loose.len() > loose {
                continua = continua::continua(system, &mut search, &found, &speeds, &mut goes_on)?;
            }
        }
        let mut rows = Vec::new();
        'all: for some in speeds.chunks(TOGETHER) {
            for here in listed_all(system, &request, &found, some, context) {
                if !goes_on(0) {
                    break 'all;
                }
                let here = here?;
                goes_on(1 + here.len() as u64);
                rows.extend(here);
            }
        }
        let zones = zones::zones(system, &mut search, &rows, &mut goes_on)?;
        let slack = slack::slack(system, &mut search, &continua.sheets, &mut goes_on);
        let least = match &self.stabilise {
            Some(s) if goes_on(0) => Some(least::least(system, s, &request, context, &mut goes_on)?),
            _ => None,
        };
        let mut errors = Vec::new();
        for requested in &self.errors {
            if goes_on(0) {
                errors.push(errors::errors(system, requested, &request, context, &mut goes_on)?);
            }
        }
        let chart = match &self.chart {
            Some((path, values)) if goes_on(0) => {
                let speeds = self.speed.linspace(POINTS);
                let chart = chart::chart(system, path, values, &speeds, &request, context, spent)?;
                complete &= !chart.stopped;
                Some(chart)
            }
            _ => None,
        };
        let shown = Reported::of(system, &mut search, &found, request.range.1.abs());
        let places = report::places(&found, &search);
        let complete = complete && !found.stopped;
        Ok(StationaryResult {
            found,
            rows,
            continua,
            zones,
            slack,
            least,
            errors,
            chart,
            shown,
            places,
            complete,
            end: context.end(complete),
        })
    }

    fn report(&self, system: &System, result: &StationaryResult, name: &str) -> Result<Outcome, Diagnostic> {
        let report = report::Report {
            system,
            range: self.request(u64::MAX).range,
            operating: system.machine.speed.filter(|w| (self.speed.from..=self.speed.to).contains(w)).unwrap_or(self.speed.to),
            stabilise: self.stabilise.as_ref(),
            found: &result.found,
            rows: &result.rows,
            continua: &result.continua,
            zones: &result.zones,
            slack: &result.slack,
            least: result.least.as_ref(),
            errors: &result.errors,
            chart: result.chart.as_ref(),
            complete: result.complete,
        };
        let outcome = report.outcome(result, name)?;
        Ok(if self.speed.is_one() { one::at(self.speed.from, outcome) } else { outcome })
    }
}

impl Stationary {
    /// Speeds of the table of states, with that of the machine.
    fn speeds(&self, system: &System) -> Vec<f64> {
        let mut out = self.speed.linspace(POINTS);
        if let Some(own) = system.machine.speed
            && (self.speed.from..=self.speed.to).contains(&own)
            && out.iter().all(|w| (w - own).abs() > 1e-9 * own.abs())
        {
            out.push(own);
            ascending(&mut out);
        }
        out
    }

    fn request(&self, work: u64) -> Request {
        let ends = if self.speed.is_one() { one::around(self.speed.from) } else { (self.speed.from, self.speed.to) };
        let (a, b) = (ends.0.max(STANDSTILL * ends.1), ends.1);
        // states near the ends may not reach far into the range, which irregular places between see where a regular grid would step over them
        let low = a.max(NEAR_REST * b);
        let between = |k: usize| low + (b - low) * (0.5 + 0.618_033_988_749_895 * k as f64).fract();
        let mut seeds: Vec<f64> = match self.seeds {
            1 => vec![between(0)],
            n => [low, b].into_iter().chain((0..n.saturating_sub(2)).map(between)).collect(),
        };
        ascending(&mut seeds);
        Request { range: (a, b), starts: self.starts, seeds, max_points: self.max_points, work }
    }
}

/// Speeds in the widest of these intervals: near both ends and in the middle.
fn within(mut gaps: Vec<(f64, f64)>) -> Vec<f64> {
    gaps.sort_by_number_down(|a| a.1 - a.0);
    let widest = gaps.into_iter().take(GAPS);
    widest.flat_map(|(a, b)| [0.02, 0.5, 0.98].map(|t| a + t * (b - a))).collect()
}

/// The machine with another value of a parameter.
fn changed(system: &System, path: &str, x: f64) -> Result<System, Diagnostic> {
    system.with(&[(path, x)]).map_err(|d| {
        let why = d.into_error().message;
        Diagnostic::error("stationary.parameter", text!("the machine does not exist at {path} = {x}: {why}", path, x, why))
            .help(text!("narrow the range of the parameter"))
    })
}

/// Ends of a range over the ratio of which values are spread by ratios.
const WIDE: f64 = 30.0;

/// Spans decades.
fn wide(range: &RangeValue) -> bool {
    range.from > 0.0 && range.to / range.from > WIDE
}

/// Values over a range, by ratios where it is [`wide`].
fn spread(range: &RangeValue, default: usize) -> Vec<f64> {
    let n = range.points.unwrap_or(default).max(2);
    let (lo, hi) = (range.from, range.to);
    let at = |k: usize| {
        let t = k as f64 / (n - 1) as f64;
        if wide(range) { lo * (hi / lo).powf(t) } else { lo + t * (hi - lo) }
    };
    (0..n).map(|k| if k + 1 == n { hi } else { at(k) }).collect()
}

/// The unit of a parameter.
fn unit_of(system: &System, path: &str) -> &'static str {
    let i = system.param(path).and_then(|p| p.first().copied());
    i.map_or("", |i| system.param_slots()[i].unit)
}

/// A state of the table.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// Speed and unknowns.
    pub state: State,
    /// Kind.
    pub class: Class,
    /// What bodies and parts show of it.
    pub seen: Seen,
    /// Eigenvalues.
    pub stability: Stability,
}

impl Row {
    pub(in crate::study) fn stable(&self) -> bool {
        self.stability.growing == 0
    }
}

/// Speeds whose states are classified together, whatever the number of processors.
const TOGETHER: usize = 8;

/// The states at some speeds, on all processors.
fn listed_all(system: &System, request: &Request, found: &Found, speeds: &[f64], context: &Context) -> Vec<Result<Vec<Row>, Diagnostic>> {
    let here = Here::now();
    let one = |speed: &f64| {
        let _counted = here.enter();
        listed(system, &mut Search::new(system, request, context.cancel), found, *speed)
    };
    speeds.par_iter().map(one).collect()
}

/// The states at a speed, classified.
fn listed(system: &System, search: &mut Search, found: &Found, speed: f64) -> Result<Vec<Row>, Diagnostic> {
    let scale = Scale::at(system, search, speed);
    found
        .states(search, speed)
        .into_iter()
        .map(|state| {
            let stability = search.stability(&state.x, state.speed)?;
            let seen = Seen::of(system, search, &state);
            Ok(Row { class: seen.class(&scale), state, seen, stability })
        })
        .collect()
}

/// A request for the states at one speed alone.
fn alone(request: &Request, speed: f64) -> Request {
    let width = 1e-3 * speed.abs().max(1e-3);
    Request { range: (speed - width, speed + width), seeds: vec![speed], ..request.clone() }
}

/// The states at one speed that so many starts lead to, and what counts as the same state.
pub(in crate::study) fn states_at(system: &System, speed: f64, starts: usize, context: &Context) -> Result<(Vec<Row>, Images), Diagnostic> {
    let whole = Request { range: (speed, speed), starts, seeds: vec![speed], max_points: MOST_POINTS, work: context.work_limit };
    let request = alone(&whole, speed);
    let mut search = Search::new(system, &request, context.cancel);
    let found = search.run(|p: Progress| context.goes_on(p.work))?;
    let rows = listed(system, &mut search, &found, speed)?;
    Ok((rows, found.images))
}
