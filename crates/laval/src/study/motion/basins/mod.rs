//! Basins of attraction: at one speed, the settled motion for every pair of two initial values on a grid, and which of these motions are the same.
//!
//! Equations: those of [`crate::solve::motion`] at constant speed W. Settling and its assessment: as in [`sweep`](super::sweep). Two motions are one
//! attractor when their Poincare sets `{y(0), y(T), .. y((k - 1) T)}` agree: see `attractors`.
//!
//! Symbols: W spin speed; T = 2 pi/W forcing period; k periods after which a motion repeats; y state (q, v, z) at phase zero; p share of the cells.
//!
//! Machines with movable masses that have states at rest in turning axes: see `masses`.
//!
//! Validity: constant speed; machines whose spin is prescribed. The grid is a plane through the space of states: a basin that does not meet it is not seen.
//!
//! Sources: `docs/theory/motion-in-time.md#basins-of-attraction`.

mod attractors;
mod axes;
mod masses;
mod report;
mod result;
mod rows;

pub use masses::{Checked, Class, Differs, MassAttractor, MassKind, Rehearsal};
pub use result::{Attractor, AttractorSet, BasinMotion, BasinsResult, Found, MassBasins, MassCell, ModesAtRest, MotionBasins};

use super::history::{METHOD, reduced_to, stopped, time_forms};
use super::record::exact_parts;
use super::start::{self, Entry, INITIAL, Start, state_names};
use super::steady_state::columns::cells;
use super::steady_state::fields::{self, SLOWEST};
use super::steady_state::period::LONGEST;
use super::steady_state::{Budget, Member, Rules, SteadyState, SteadyStateSearch, fastest_growth, method, neutral, sizes, slowest_decay};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values, Word};
use crate::model::probe::Probe;
use crate::model::system::{Drive, Station, System};
use crate::model::timed::{Speeds, Timed};
use crate::outcome::{End, Outcome};
use crate::solve::ensemble::{self, Form, Method, Settings};
use crate::solve::reduced_machine::ReducedMachine;
use crate::store::{self, Collected, Rows};
use crate::study::shared::probes;
use crate::study::shared::size::{KEPT, Size};
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED, speed};
use crate::study::{Context, Study};
use crate::text;
use attractors::Ruler;
use axes::{InitialValueAxis, MOST_POINTS};
use std::ops::Range;
use std::sync::Arc;

/// Most forcing periods of settling where the file says nothing: a grid has many motions.
const MOST_PERIODS: i64 = 10_000;

/// Most cells of a map.
const MOST_CELLS: usize = 250_000;

const RECOGNISE: &[Word] = &[
    (
        "early",
        "on large maps a motion ends as soon as it is known where it goes: it came half as near to an attractor as any motion followed beforehand that went elsewhere",
    ),
    ("never", "every motion is followed to its end"),
];

/// See the [module](self).
pub struct Basins {
    /// Spin speed, rad/s.
    speed: f64,
    /// Initial values varied.
    axes: [InitialValueAxis; 2],
    rules: Rules,
    initial: Vec<(Entry, f64)>,
    /// The end of a motion of movable masses may be recognised early.
    recognise: bool,
    /// The file says how exact steps are.
    exact: bool,
    /// Cells that are followed to their ends although their end was recognised before.
    check: usize,
}

impl Study for Basins {
    type Result = BasinsResult;
    const KIND: &'static str = "basins";
    const IN_CHUNKS: bool = true;
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
from = { "drum.x" = "-1 mm", "drum.y" = "-1 mm" }
to = { "drum.x" = "1 mm", "drum.y" = "1 mm" }
points = 50
"#;
    const DOC: &'static str = "Basins of attraction at one speed: which motion the machine settles on from every pair of two initial values on a grid, \
        how many motions there are, which share of the grid leads to each, and the smallest disturbance that leads to another. \
        nonlinear_response follows branches of periodic motions; basins show which of them a disturbance reaches. For a machine with movable masses they show from which \
        places the balls of a balancer reach the balanced state, and from which they stay elsewhere or go round for ever.";
    const FIELDS: &'static [Field] = &[
        Field::optional("speed", SPEED, "", "spin speed, above zero; the machine's when left out"),
        Field::required(
            "from",
            FieldKind::StateMap,
            "lower ends of two initial values: displacements (\"drum.x\"), rates (\"drum.x'\") or internal states. The map shows coordinates before \
             rates before internal states: the first along x",
        ),
        Field::required("to", FieldKind::StateMap, "upper ends of the same two"),
        Field::optional(
            "points",
            FieldKind::Named { unit: "", bounds: Bounds::closed(2.0, MOST_POINTS) },
            "50",
            "whole numbers of points from end to end, as 100 or { \"drum.x\" = 100, \"drum.x'\" = 80 }",
        ),
        Field::optional(
            "run_up",
            FieldKind::Range { unit: "s", bounds: Bounds::positive(1e6) },
            "",
            "machines with movable masses: durations of a run-up from standstill at constant acceleration, along y; from and to then name one initial value",
        ),
        INITIAL,
        METHOD,
        fields::SETTLING,
        fields::TOLERANCE,
        Field { default: "10000", ..fields::MOST_PERIODS },
        fields::PERIODS,
        fields::RELATIVE,
        fields::ABSOLUTE,
        Field::optional(
            "recognise",
            FieldKind::Choice(RECOGNISE),
            "early",
            "machines with movable masses, such as the balls of a balancer: whether the end of a motion may be recognised before it is reached",
        ),
        Field::optional(
            "check",
            FieldKind::Integer { min: 0, max: 100_000 },
            "0",
            "where ends are recognised early: so many cells, chosen by chance, are followed to their ends as well, to see whether they end there",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let speed = speed(values, system, diagnostics);
        if let Some(w) = speed
            && !(w >= SLOWEST)
        {
            let message = text!("basins need a speed above {least}: there is no period at rest", least = text::quantity(1e-6, "rad/s"));
            diagnostics.push(Diagnostic::error("basins.speed", message).at(values.span_of("speed")));
        }
        if system.stations().is_empty() {
            diagnostics.push(Diagnostic::error("basins.no_body", text!("no body of this machine moves across the axis")));
        }
        let movable = speed.is_some_and(|w| w >= SLOWEST && masses::has(system, w));
        let axes = axes::read(values, system, if movable { masses::MOST_CELLS } else { MOST_CELLS }, diagnostics);
        let initial = start::state_map(values, "initial", system, diagnostics);
        if let Some(w) = speed
            && !movable
            && values.get("run_up").is_some()
        {
            let message = text!(
                "a run-up makes no difference at {speed}: this machine has no masses that move round in axes that turn with it",
                speed = text::quantity(w, "rad/s")
            );
            diagnostics.push(Diagnostic::error("basins.run_up", message).at(values.span_of("run_up")).help(text!("leave run_up out")));
        }
        if diagnostics.0.len() > before {
            return None;
        }
        let exact = values.number("relative_tolerance").is_some();
        Some(Basins {
            speed: speed?,
            axes: axes?,
            rules: Rules::read(values, MOST_PERIODS, None)?,
            initial,
            recognise: values.choice("recognise") != Some("never"),
            exact,
            check: values.integer("check").and_then(|n| usize::try_from(n).ok()).unwrap_or(0),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        // a run-up begins at rest
        let from = if self.axes.iter().any(|a| a.index.is_none()) { 0.0 } else { self.speed };
        vec![SpinSpeeds::between(from, self.speed)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let rows: usize = self.axes.iter().map(|a| a.values().len()).product();
        let states = 2 * system.n() + system.m();
        // motions of balls are kept without their states
        let kept = if masses::has(system, self.speed) { 1 } else { LONGEST };
        let columns = 16 + 2 * system.stations().len() + kept * states;
        Some(Size {
            bytes: rows as f64 * columns as f64 * (KEPT + KEPT),
            of: text!("{rows} motions with {columns} numbers each", rows, columns),
            fewer: text!("give the range fewer points"),
        })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.prepare(system, &Context::quiet(Self::KIND))
    }

    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "basins.free_spin",
                text!("the spin of this machine is free: it has no speed at which motions settle"),
            )
            .help(text!("leave drive = \"free\" out, or follow its motion with transient")));
        }
        let Some(timed) = context.timed(system, Speeds::One(self.speed))? else { return Ok(()) };
        if matches!(timed, Timed::Fitted(_)) && masses::has(system, self.speed) {
            // states at rest in turning axes are those of the exact machine
            return ensemble::admit(system, Method::Stiff);
        }
        ensemble::admit(&timed, method(&timed, self.rules.method, self.speed))
    }

    fn compute(&self, system: &System, context: &Context) -> Result<BasinsResult, Diagnostic> {
        self.prepare(system, context)?;
        if masses::has(system, self.speed) {
            return masses::run(self, system, context);
        }
        let timed = context.timed(system, Speeds::One(self.speed))?.ok_or_else(stopped)?;
        let own = timed.with(&[]).map_err(Diagnostics::into_error)?;
        // internal states have other numbers in time
        let moved = |i: usize| match i.checked_sub(2 * system.n()) {
            Some(z) => start::renumbered(&[(Entry::State(z), 0.0)], system, &own).first().map(|e| e.0.index(&own)),
            None => Some(i),
        };
        let varied = self.axes.each_ref().map(|a| a.index.and_then(moved));
        let initial = start::renumbered(&self.initial, system, &own);
        let written = Start::new(&own, self.speed);
        let reduced = ReducedMachine::of(&own, self.speed);
        let own = reduced.as_ref().map_or_else(|| Arc::new(own), |r| r.system.clone());
        let rest = reduced.as_ref().map_or_else(|| written.rest.clone(), |r| r.coordinates(&written.rest));
        let members = Members {
            budget: Budget::new(context.work_limit),
            study: self,
            written,
            rest,
            modes: ModesAtRest {
                decay: slowest_decay(&own, self.speed),
                growth: fastest_growth(&own, self.speed),
                neutral: neutral(&own, self.speed),
            },
            stations: system.stations(),
            probes: probes::all(&own),
            reduced,
            values: self.axes.each_ref().map(InitialValueAxis::values),
            method: method(&own, self.rules.method, self.speed),
            varied,
            initial,
            coordinates: system.n(),
            system: own,
        };
        let columns = rows::columns(self, &members);
        // the first row is the undisturbed start
        let count = 1 + members.values[0].len() * members.values[1].len();
        let plan = store::Plan {
            study: Self::KIND.into(),
            columns: columns.iter().map(|c| c.column.clone()).collect(),
            rows: count,
            chunk: count.div_ceil(50).clamp(64, 256),
        };
        match members.modes.undecaying() {
            Some(what) => {
                let whole = text!(
                    "{count} motions to follow ({cells} cells and the undisturbed start), each for up to {turns} turns: {what}, so that nothing says how long settling takes",
                    count,
                    cells = count - 1,
                    turns = self.rules.most_periods,
                    what
                );
                context.progress.job(&whole);
            }
            None => context.announce(plan.rows as f64, 1000.0, text!("motions to follow until they repeat")),
        }
        let results = store::run(plan, context, |range, counter| Ok(members.rows(range, counter).map(|list| cells(&columns, &list))))?;
        let motions = Collected::of(&results)?;
        let end = context.end(motions.end == End::Reached);
        let (states, sizes) = (state_names(&members.system), sizes(&members.system, self.speed));
        let ruler = Ruler { sizes: &sizes, rest: &members.rest, tolerance: self.rules.tolerance };
        let attractors = ruler.sort(&rows::motions(self, &motions, &states, &members.probes, &members.modes)?);
        let forms = exact_parts(&members.system);
        let reduced = members.reduced.as_ref().map(|r| r.reduced);
        let found = MotionBasins { motions, attractors, states, sizes, modes: members.modes, forms, reduced };
        Ok(BasinsResult { found: Some(Found::Motions(Box::new(found))), undeflected: members.written.undeflected, end })
    }

    fn report(&self, system: &System, result: &BasinsResult, name: &str) -> Result<Outcome, Diagnostic> {
        match &result.found {
            Some(Found::Motions(found)) => {
                Ok(reduced_to(found.reduced, time_forms(&found.forms, report::report(self, system, (result, found), name)?)))
            }
            Some(Found::Masses(found)) => masses::report(self, system, (result, found), name),
            None => Ok(masses::nothing(result, name)),
        }
    }
}

/// The study on its machine.
struct Members<'a> {
    budget: Budget,
    study: &'a Basins,
    /// Start, by entries of the machine in time, and the places of the two initial values in its state, before it was reduced.
    initial: Vec<(Entry, f64)>,
    varied: [Option<usize>; 2],
    written: Start,
    /// Number of its coordinates.
    coordinates: usize,
    /// The machine whose motions are followed, what it was reduced to, and its coordinates at rest.
    system: Arc<System>,
    reduced: Option<ReducedMachine>,
    rest: Vec<f64>,
    method: Method,
    modes: ModesAtRest,
    stations: &'a [Station],
    /// What is recorded of every motion.
    probes: Vec<Probe>,
    /// Initial values along both axes.
    values: [Vec<f64>; 2],
}

impl ModesAtRest {
    /// Which mode at rest does not decay.
    fn undecaying(&self) -> Option<text::Text> {
        match (self.decay, self.growth) {
            (Some(_), _) => None,
            (None, Some(growth)) => Some(text!("at rest a mode of this machine grows by {growth}", growth = text::quantity(growth, "1/s"))),
            (None, None) if self.neutral => Some(text!("at rest a mode of this machine neither decays nor grows")),
            (None, None) => Some(text!("the modes of this machine at rest are not known")),
        }
    }
}

impl Members<'_> {
    /// Start from rest and what the file says of it.
    fn undisturbed(&self) -> Vec<f64> {
        let mut y = vec![0.0; 2 * self.coordinates + self.system.m()];
        self.written.write(&self.initial, &mut y);
        y
    }

    /// The undisturbed start, then the cells along the first axis, row by row.
    fn start_of(&self, row: usize) -> Vec<f64> {
        let mut y = self.undisturbed();
        if let Some(cell) = row.checked_sub(1) {
            let width = self.values[0].len();
            let [x, v] = self.varied;
            for (index, value) in [(x, self.values[0][cell % width]), (v, self.values[1][cell / width])] {
                if let Some(i) = index {
                    y[i] = value;
                }
            }
        }
        y
    }

    fn rows(&self, range: Range<usize>, counter: &Rows) -> Option<Vec<rows::Row>> {
        let member = |row: usize| Member {
            system: self.system.clone(),
            speed: self.study.speed,
            y: self.reduced.as_ref().map_or_else(|| self.start_of(row), |r| r.state(&self.start_of(row))),
            rest: self.rest.clone(),
            rate: self.modes.decay,
        };
        let members: Vec<Member> = range.clone().map(member).collect();
        let probes = self.probes.clone();
        let task = SteadyStateSearch { members: &members, rules: &self.study.rules, counter, budget: &self.budget, probes };
        let settings = Settings { method: self.method, ..Settings::default() };
        let steady_state: Vec<SteadyState> = ensemble::run(&task, &self.system, Form::of(&self.system, true), 0..members.len(), settings)?;
        let place = |y: &[f64]| self.varied.map(|i| i.map_or(f64::NAN, |i| y[i]));
        let list = range.zip(steady_state).map(|(k, steady_state)| rows::Row { place: place(&self.start_of(k)), steady_state }).collect();
        // a motion that the budget cut short is none
        (!self.budget.used_up()).then_some(list)
    }
}
