//! Maps of settled motion: the same start at every point of a grid of two parameters, or of the spin speed and one parameter, integrated in time.
//!
//! Equations: those of [`crate::solve::motion`] at constant speed W. Settling and its assessment: as in [`sweep`](super::sweep).
//!
//! Symbols: W spin speed; T = 2 pi/W forcing period; k periods after which a motion repeats.
//!
//! Validity: constant speed; machines whose spin is prescribed. Each point shows the motion reached from its start, of which there may be others.
//!
//! Sources: `docs/theory/motion-in-time.md#steady-state-motion`.

mod report;

use super::history::{METHOD, reduced_to, time_forms};
use super::record::{SettledMotion, UsedForm, exact_parts};
use super::start::{self, Entry, INITIAL, Start};
use super::steady_state::columns::{self, RowColumn, body, cells, number, word};
use super::steady_state::fields::{self, SLOWEST};
use super::steady_state::stored::settled;
use super::steady_state::{Budget, Member, Rules, SteadyState, SteadyStateSearch, method, slowest_decay};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values};
use crate::model::system::{Drive, System};
use crate::model::timed::Speeds;
use crate::outcome::{End, Outcome};
use crate::solve::ensemble::{self, Form, Method, Settings};
use crate::solve::reduced_machine::ReducedMachine;
use crate::solve::reduction::Reduced;
use crate::store::{self, Collected, Rows};
use crate::study::shared::probes;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED_RANGE, range, range_or};
use crate::study::{Context, Study};
use crate::text;
use crate::text::Text;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;

/// Points along an axis that says none.
const DEFAULT_POINTS: usize = 50;
/// Most points of a map.
const MOST_CELLS: usize = 250_000;
/// Most forcing periods of settling where the file says nothing: a map has many motions.
const MOST_PERIODS: i64 = 10_000;
/// Speeds unless given, over that of the machine.
const ABOUT: (f64, f64) = (0.5, 1.5);

/// What varies along one side.
#[derive(Clone, Debug, PartialEq)]
struct GridAxis {
    /// Path of the parameter; `None` is the spin speed.
    path: Option<String>,
    unit: &'static str,
    range: RangeValue,
}

impl GridAxis {
    fn name(&self) -> &str {
        self.path.as_deref().unwrap_or("speed")
    }
    fn values(&self) -> Vec<f64> {
        self.range.linspace(DEFAULT_POINTS)
    }
}

/// See the [module](self).
pub struct MotionMap {
    axes: [GridAxis; 2],
    /// Spin speed where no axis is, rad/s.
    speed: f64,
    rules: Rules,
    initial: Vec<(Entry, f64)>,
}

impl Study for MotionMap {
    type Result = MotionMapResult;
    const KIND: &'static str = "motion_map";
    const IN_CHUNKS: bool = true;
    const EXAMPLE: &'static str = r#"speed = { from = "1000 rpm", to = "9000 rpm", points = 60 }
y = { parameter = "drum.eccentricity", from = "10 um", to = "100 um", points = 20 }
"#;
    const DOC: &'static str = "Settled motion over the spin speed and a parameter, or over two parameters, by integration in time from the same start at every point: \
        largest displacements, and where the motion repeats every turn, after several turns, or not at all. response_map follows all states of every machine; \
        a motion map shows what a start leads to.";
    const FIELDS: &'static [Field] = &[
        Field::required("y", FieldKind::ParameterRange, "the parameter along y; 50 points unless given"),
        Field::optional(
            "speed",
            SPEED_RANGE,
            "",
            "spin speeds along x, above zero, 50 points unless given; half to one and a half times that of the machine when left out. One speed beside x: that of all motions",
        ),
        Field::optional(
            "x",
            FieldKind::ParameterRange,
            "",
            "a second parameter along x in place of the speed, which is then one: speed, or that of the machine",
        ),
        INITIAL,
        METHOD,
        fields::SETTLING,
        fields::TOLERANCE,
        Field { default: "10000", ..fields::MOST_PERIODS },
        fields::PERIODS,
        fields::RELATIVE,
        fields::ABSOLUTE,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let y = parameter("y", values, system, diagnostics);
        let x = match values.get("x") {
            Some(_) if values.range("speed").is_some_and(|r| !r.is_one()) => {
                let message = text!("both a range of speeds and a parameter along x are given");
                diagnostics.push(Diagnostic::error("motion_map.axes", message).at(values.span_of("x")).help(text!("say one or the other")));
                None
            }
            Some(_) => parameter("x", values, system, diagnostics),
            None => speeds(values, system, diagnostics),
        };
        let one = values.range("speed").filter(RangeValue::is_one).map(|r| r.from);
        let speed = one.or(system.machine.speed).unwrap_or(f64::NAN);
        if x.as_ref().is_some_and(|x| x.path.is_some()) && !(speed >= SLOWEST) {
            let message = text!("a map of two parameters needs a speed above zero");
            let help = text!("add speed = \"3000 rpm\" here or to [machine]");
            let place = if one.is_some() { values.span_of("speed") } else { values.span.clone() };
            diagnostics.push(Diagnostic::error("motion_map.speed", message).at(place).help(help));
        }
        if system.stations().is_empty() {
            diagnostics.push(Diagnostic::error("motion_map.no_body", text!("no body of this machine moves across the axis")));
        }
        if let (Some(x), Some(y)) = (&x, &y) {
            let indices = |a: &GridAxis| a.path.as_deref().and_then(|p| system.param(p)).unwrap_or_default();
            if indices(x).iter().any(|i| indices(y).contains(i)) {
                let message = text!("\"{first}\" and \"{second}\" are the same parameter", first = x.name(), second = y.name());
                diagnostics.push(Diagnostic::error("motion_map.axes", message).at(values.span_of("y")).help(text!("vary two parameters")));
            }
            let [a, b] = [x, y].map(|a| a.range.points.unwrap_or(DEFAULT_POINTS));
            if a.saturating_mul(b) > MOST_CELLS {
                let message = text!("a map of {a} by {b} motions is too large", a, b);
                let help = text!("at most {most} motions in all", most = MOST_CELLS);
                diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("y")).help(help));
            }
        }
        let initial = start::state_map(values, "initial", system, diagnostics);
        if diagnostics.0.len() > before {
            return None;
        }
        Some(MotionMap { axes: [x?, y?], speed, rules: Rules::read(values, MOST_PERIODS, None)?, initial })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        let along = self.axes.iter().find(|a| a.path.is_none());
        vec![along.map_or(SpinSpeeds::one(self.speed), |a| SpinSpeeds::between(a.range.from, a.range.to))]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let motions = self.axes.iter().map(|a| a.values().len()).product();
        Some(Size::of_rows(motions, 24 + 6 * system.probes().len()))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "motion_map.free_spin",
                text!("the spin of this machine is free: it has no speed at which motions settle"),
            )
            .help(text!("leave drive = \"free\" out, or follow its motion with transient")));
        }
        let timed = system.timed(Speeds::Several)?;
        ensemble::admit(&timed, self.method(&timed))
    }

    fn compute(&self, system: &System, context: &Context) -> Result<MotionMapResult, Diagnostic> {
        self.admit(system)?;
        let own = system.timed(Speeds::Several)?.with(&[]).map_err(Diagnostics::into_error)?;
        let initial = start::renumbered(&self.initial, system, &own);
        let whole = Arc::new(own);
        let reduction = self.reduced(&whole);
        let reduced = reduction.as_ref().map(|r| r.reduced);
        let system = reduction.as_ref().map_or_else(|| whole.clone(), |r| r.system.clone());
        let members = Members {
            budget: Budget::new(context.work_limit),
            study: self,
            initial,
            method: self.method(&system),
            values: self.axes.each_ref().map(GridAxis::values),
            whole,
            reduction,
            system,
        };
        let columns = members.columns();
        let count = members.values[0].len() * members.values[1].len();
        let plan = store::Plan {
            study: Self::KIND.into(),
            columns: columns.iter().map(|c| c.column.clone()).collect(),
            rows: count,
            chunk: count.div_ceil(50).clamp(64, 1024),
        };
        context.announce(plan.rows as f64, 1000.0, text!("motions to follow until they repeat"));
        let results = store::run(plan, context, |range, counter| Ok(members.rows(range, counter).map(|list| cells(&columns, &list))))?;
        let motions = Collected::of(&results)?;
        let end = context.end(motions.end == End::Reached);
        Ok(MotionMapResult { motions, forms: exact_parts(&members.system), reduced, end })
    }

    fn report(&self, system: &System, result: &MotionMapResult, name: &str) -> Result<Outcome, Diagnostic> {
        Ok(reduced_to(result.reduced, time_forms(&result.forms, report::report(self, system, result, name)?)))
    }
}

/// Settled motions over two parameters, or the spin speed and one.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MotionMapResult {
    /// One row for each point, along x and then along y; columns as in the table `map`.
    pub motions: Collected,
    /// Rational forms that stood for exact parts.
    pub forms: Vec<UsedForm>,
    /// What the machine was reduced to.
    pub reduced: Option<Reduced>,
    /// How the study ended.
    pub end: End,
}

/// A point of a map.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MapPoint {
    /// Values along both axes.
    pub at: [f64; 2],
    /// What the motion from its start settles on, or why there is no machine with these values.
    pub motion: Result<SettledMotion, String>,
}

impl MotionMapResult {
    /// The points, row by row.
    pub fn list(&self) -> Vec<MapPoint> {
        let axis = |k: usize| self.motions.columns.get(k).map_or_else(Vec::new, |c| self.motions.numbers(&c.0.name));
        let (x, y, refused) = (axis(0), axis(1), self.motions.words(REFUSED));
        let one = |(row, motion): (usize, SettledMotion)| {
            let why = refused.get(row).filter(|w| !w.is_empty());
            MapPoint { at: [x[row], y[row]], motion: why.map_or(Ok(motion), |why| Err(why.clone())) }
        };
        settled(&self.motions).into_iter().enumerate().map(one).collect()
    }
}

/// The speeds along x.
fn speeds(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<GridAxis> {
    let about = |speed: f64| RangeValue { from: ABOUT.0 * speed, to: ABOUT.1 * speed, points: None };
    let Some(given) = values.range("speed").or(system.machine.speed.map(f64::abs).map(about)) else {
        diagnostics.push(
            Diagnostic::error("motion_map.speed", text!("this study needs a range of speeds"))
                .at(values.span.clone())
                .help(text!("add speed = {{ from = \"1000 rpm\", to = \"5000 rpm\" }}, or a speed to [machine]")),
        );
        return None;
    };
    let one: fn(Text) -> Text = |help| text!("{help}, or give x a second parameter: the speed is then the same everywhere", help);
    let range = range_or("speed", (given, one), 2, values, diagnostics)?;
    if !(range.from >= SLOWEST) {
        let message = text!("a map needs speeds above {least}: there is no period at rest", least = text::quantity(1e-6, "rad/s"));
        diagnostics.push(Diagnostic::error("motion_map.speed", message).at(values.span_of("speed")));
        return None;
    }
    Some(GridAxis { path: None, unit: "rad/s", range })
}

/// A parameter and its values.
fn parameter(field: &str, values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<GridAxis> {
    let (path, given) = values.parameter_range(field)?;
    let range = range(field, given, 2, values, diagnostics);
    let slot = system.param(path).and_then(|i| system.param_slots().get(*i.first()?));
    if slot.is_none() {
        diagnostics.push(system.unknown_param(path).at(values.span_of(field)));
    }
    Some(GridAxis { path: Some(path.to_string()), unit: slot?.unit, range: range? })
}

impl MotionMap {
    /// The implicit method where a corner of the map requires it.
    fn method(&self, system: &System) -> Method {
        let ends = |k: usize| [self.axes[k].range.from, self.axes[k].range.to];
        let corners = ends(0).into_iter().flat_map(|x| ends(1).map(|y| [x, y]));
        let stiff = |at: [f64; 2]| {
            let machine = self.machine(system, at);
            method(machine.as_ref().unwrap_or(system), self.rules.method, self.speed_at(at)) == Method::Stiff
        };
        if corners.into_iter().any(stiff) { Method::Stiff } else { Method::Explicit }
    }

    /// Speed of a point, rad/s.
    fn speed_at(&self, at: [f64; 2]) -> f64 {
        if self.axes[0].path.is_none() { at[0] } else { self.speed }
    }

    /// The machine reduced, but for the parts whose parameters vary; `None` where it is small, or where a value moves what is attached to it.
    fn reduced(&self, whole: &System) -> Option<ReducedMachine> {
        let fastest = if self.axes[0].path.is_none() { self.axes[0].range.from.max(self.axes[0].range.to) } else { self.speed };
        let varied = self.axes.iter().filter_map(|a| whole.param(a.path.as_deref()?)).flatten();
        let slots: Vec<usize> = varied.filter_map(|i| whole.slots().iter().position(|s| s.params.contains(&i))).collect();
        let reduced = ReducedMachine::varying(whole, fastest, &slots)?;
        let ends = [[0, 0], [1, 1]].map(|at| [0, 1].map(|k| if at[k] == 0 { self.axes[k].range.from } else { self.axes[k].range.to }));
        let moves = |at| self.machine(whole, at).is_ok_and(|m| reduced.member(whole, &m).is_none());
        (!ends.into_iter().any(moves)).then_some(reduced)
    }

    /// The machine of a point, or why there is none.
    fn machine(&self, system: &System, at: [f64; 2]) -> Result<System, String> {
        let changes: Vec<(&str, f64)> = self.axes.iter().zip(at).filter_map(|(a, x)| Some((a.path.as_deref()?, x))).collect();
        let machine = system.with(&changes).map_err(|d| d.into_error().message.to_string())?;
        if (machine.n(), machine.m()) == (system.n(), system.m()) { Ok(machine) } else { Err("it has other states".into()) }
    }
}

/// The study on its machine.
struct Members<'a> {
    budget: Budget,
    study: &'a MotionMap,
    /// Start, by entries of the machine in time.
    initial: Vec<(Entry, f64)>,
    /// The machine as it is written, and what it was reduced to.
    whole: Arc<System>,
    reduction: Option<ReducedMachine>,
    /// The machine whose motions are followed.
    system: Arc<System>,
    method: Method,
    /// Values along both axes.
    values: [Vec<f64>; 2],
}

/// One point.
struct Row {
    at: [f64; 2],
    /// Why there is no machine.
    refused: Option<String>,
    steady_state: SteadyState,
}

impl columns::Row for Row {
    fn steady_state(&self) -> &SteadyState {
        &self.steady_state
    }
}

/// Name of the column that tells why there is no machine.
const REFUSED: &str = "refused";

/// The place of a row on a grid: along x first.
fn place(values: &[Vec<f64>; 2], row: usize) -> [f64; 2] {
    let width = values[0].len();
    [values[0][row % width], values[1][row / width]]
}

impl Members<'_> {
    fn at(&self, row: usize) -> [f64; 2] {
        place(&self.values, row)
    }

    fn columns(&self) -> Vec<RowColumn<Row>> {
        let mut out: Vec<RowColumn<Row>> = Vec::new();
        for (k, a) in self.study.axes.iter().enumerate() {
            out.push(number(a.name(), a.unit, "value along this side of the map", move |r: &Row| r.at[k]));
        }
        out.extend(columns::verdict_columns(&self.study.rules));
        for (b, own) in self.system.stations().iter().enumerate() {
            out.push(body(format!("amplitude.{}", own.name), b, "largest displacement", |m| m.peak));
            out.push(body(format!("rms.{}", own.name), b, "root of the mean squared displacement", |m| m.rms));
        }
        out.extend(columns::others(&self.system));
        out.push(word(REFUSED, "why there is no machine with these values", |r: &Row| r.refused.clone()));
        out
    }

    /// The member of a point, or why there is none.
    fn member(&self, at: [f64; 2]) -> Result<Member, String> {
        let speed = self.study.speed_at(at);
        let whole = Arc::new(self.study.machine(&self.whole, at)?);
        let elsewhere = || "other parts are attached to it elsewhere".to_string();
        let system = match &self.reduction {
            Some(r) => Arc::new(r.member(&self.whole, &whole).ok_or_else(elsewhere)?),
            None => whole.clone(),
        };
        let mut y = vec![0.0; 2 * system.n() + system.m()];
        let start = Start::new(&whole, speed).on(self.reduction.as_ref(), &self.initial, &mut y);
        Ok(Member { speed, y, rest: start.rest, rate: slowest_decay(&system, speed), system })
    }

    fn rows(&self, range: Range<usize>, counter: &Rows) -> Option<Vec<Row>> {
        let here = Here::now();
        let member = |row| {
            let _counted = here.enter();
            self.member(self.at(row))
        };
        let found: Vec<Result<Member, String>> = range.clone().into_par_iter().map(member).collect();
        let refused: Vec<Option<String>> = found.iter().map(|m| m.as_ref().err().cloned()).collect();
        let members: Vec<Member> = found.into_iter().flatten().collect();
        let task = SteadyStateSearch {
            members: &members,
            rules: &self.study.rules,
            counter,
            budget: &self.budget,
            probes: probes::all(&self.system),
        };
        let settings = Settings { method: self.method, ..Settings::default() };
        let steady_state = ensemble::run(&task, &self.system, Form::of(&self.system, true), 0..members.len(), settings)?;
        let mut steady_state = steady_state.into_iter();
        let mut row = |(row, refused): (usize, Option<String>)| {
            let none = || SteadyState::none("is that of no machine");
            let steady_state = if refused.is_some() { none() } else { steady_state.next().unwrap_or_else(none) };
            Row { at: self.at(row), refused, steady_state }
        };
        let list = range.zip(refused).map(&mut row).collect();
        // a motion that the budget cut short is none
        (!self.budget.used_up()).then_some(list)
    }
}
