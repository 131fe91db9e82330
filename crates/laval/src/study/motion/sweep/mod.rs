//! Settled motion at many speeds, by integration in time: from the same start at every speed, or followed from one speed to the next.
//!
//! Equations: those of [`crate::solve::motion`] at constant speed W. Settling and its assessment: the rotor is followed for
//! `ln(1/tolerance)/a` seconds, a the slowest decay rate of the machine linearised at rest, and as long again up to four times while the states at whole
//! periods do not repeat; or Newton's method finds `y = P^k(y)` on the Poincare map P.
//!
//! Symbols: W spin speed; T = 2 pi/W forcing period; k periods after which a motion repeats; order: frequency over W; lambda largest Lyapunov exponent.
//!
//! Validity: constant speed at every step; machines whose spin is prescribed. Followed motions change speed in steps at phase zero, with position and velocity kept:
//! the limit of a slow sweep as the step becomes small.
//!
//! Sources: `docs/theory/motion-in-time.md#sweeps-and-jumps`; Benettin et al., Meccanica 15 (1980) 9; Das et al., Nonlinearity 30 (2017) 4111.

mod ahead;
mod figures;
mod lyapunov;
mod refine;
mod report;
mod rows;

use super::history::{METHOD, reduced_to, time_forms};
use super::record::{SettledMotion, UsedForm, exact_parts};
use super::start::{self, Entry, INITIAL, Start};
use super::steady_state::columns::cells;
use super::steady_state::fields::{self, SLOWEST};
use super::steady_state::measure::{HIGHEST, LINES, POINTS as KEPT_POINTS};
use super::steady_state::stored::settled;
use super::steady_state::{Budget, Member, Rules, SteadyState, SteadyStateSearch, method, slowest_decay};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values, Word};
use crate::model::probe::Probe;
use crate::model::system::{Drive, Station, System};
use crate::model::timed::Speeds;
use crate::outcome::{End, Outcome};
use crate::solve::ensemble::{self, Form, Method, Settings};
use crate::solve::reduced_machine::ReducedMachine;
use crate::solve::reduction::Reduced;
use crate::store::{self, Collected, Rows};
use crate::study::shared::probes;
use crate::study::shared::size::{KEPT, LISTED, Size};
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED_RANGE, range_or};
use crate::study::{Context, Study};
use crate::text;
use crate::text::Text;
use laval_num::work::Here;
use lyapunov::Pairs;
use rayon::prelude::*;
use refine::{Followed, SteadyPoint};
use rows::Row;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;

/// Followed motions in a chunk, at least: so many that their lanes fill.
const FOLLOWED: usize = 12;

const STARTS: &[Word] = &[
    ("rest", "from the same state at every speed: which motion is reached depends on it"),
    ("up", "from each speed to the next higher one"),
    ("down", "from each speed to the next lower one"),
    ("up_and_down", "both, side by side"),
    ("all", "all three"),
];
/// Points of a range that says none.
const DEFAULT_POINTS: usize = 200;

/// How motions begin at each speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Way {
    /// The same state at every speed.
    Rest,
    /// The motion at the speed below.
    Up,
    /// The motion at the speed above.
    Down,
}

impl Way {
    fn word(self) -> &'static str {
        match self {
            Way::Rest => "rest",
            Way::Up => "up",
            Way::Down => "down",
        }
    }

    fn of(word: &str) -> Way {
        [Way::Up, Way::Down].into_iter().find(|w| w.word() == word).unwrap_or(Way::Rest)
    }
}

/// See the [module](self).
pub struct Sweep {
    speed: RangeValue,
    ways: Vec<Way>,
    rules: Rules,
    initial: Vec<(Entry, f64)>,
    /// Coordinate of the bifurcation diagram: probe among those recorded, 0 for x and 1 for y.
    section: (usize, usize),
    /// Body of the waterfall.
    waterfall: Option<usize>,
    /// Periods of the Lyapunov exponent.
    lyapunov: Option<usize>,
}

impl Study for Sweep {
    type Result = SweepResult;
    const KIND: &'static str = "sweep";
    const IN_CHUNKS: bool = true;
    const EXAMPLE: &'static str = r#"speed = { from = "1000 rpm", to = "9000 rpm", points = 200 }
start = "up_and_down"
"#;
    const DOC: &'static str = "Settled motion over the spin speed by integration in time, from the same start at every speed or followed up and down: amplitudes, \
        orders, jumps and hysteresis, period doubling and motions that do not repeat, bifurcation diagram, order spectra, largest Lyapunov exponent. \
        nonlinear_response follows branches of periodic motions, unstable ones too; a sweep shows which of them a machine reaches.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds, above zero; 200 points unless given"),
        Field::optional("start", FieldKind::Choice(STARTS), "up_and_down", "how the motion begins at each speed"),
        INITIAL,
        METHOD,
        fields::SETTLING,
        fields::TOLERANCE,
        fields::MOST_PERIODS,
        fields::PERIODS,
        Field::optional(
            "section",
            FieldKind::Coordinate,
            "",
            "coordinate of the bifurcation diagram, such as \"drum.x\"; x of the first body unless given",
        ),
        Field::optional(
            "waterfall",
            FieldKind::Text,
            "",
            "body whose order spectra are wanted, orders -4 (backward) to 4 in steps of 1/16",
        ),
        Field::optional("lyapunov", FieldKind::Flag, "false", "compute the largest Lyapunov exponent"),
        Field::optional(
            "lyapunov_periods",
            FieldKind::Integer { min: 16, max: 10_000_000 },
            "2000",
            "forcing periods over which the exponent is taken; a quarter as many before them",
        ),
        fields::RELATIVE,
        fields::ABSOLUTE,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let one: fn(Text) -> Text = |help| {
            text!("{help}; at one speed nonlinear_response finds the steady motions, basins and transient where a start leads", help)
        };
        let speed = range_or("speed", (values.range("speed")?, one), 2, values, diagnostics);
        if let Some(s) = speed
            && !(s.from >= SLOWEST)
        {
            let message = text!("a sweep needs speeds above {least}: there is no period at rest", least = text::quantity(1e-6, "rad/s"));
            diagnostics.push(Diagnostic::error("sweep.speed", message).at(values.span_of("speed")));
        }
        let bodies = system.stations();
        if bodies.is_empty() {
            diagnostics.push(Diagnostic::error("sweep.no_body", text!("no body of this machine moves across the axis")));
        }
        let initial = start::state_map(values, "initial", system, diagnostics);
        let section = section(values, system, diagnostics);
        let named = values.text("waterfall").filter(|n| !n.is_empty());
        let waterfall = named.and_then(|n| bodies.iter().position(|b| b.name == n));
        if let (Some(name), None) = (named, waterfall) {
            let known = bodies.iter().map(|b| format!("\"{}\"", b.name)).collect::<Vec<_>>().join(", ");
            let message = text!("there is no body \"{name}\"", name);
            diagnostics.push(
                Diagnostic::error("sweep.waterfall", message)
                    .at(values.span_of("waterfall"))
                    .about(name)
                    .help(text!("there is {known}", known)),
            );
        }
        if diagnostics.0.len() > before {
            return None;
        }
        Some(Sweep {
            speed: speed?,
            ways: match values.choice("start") {
                Some("rest") => vec![Way::Rest],
                Some("up") => vec![Way::Up],
                Some("down") => vec![Way::Down],
                Some("all") => vec![Way::Rest, Way::Up, Way::Down],
                _ => vec![Way::Up, Way::Down],
            },
            rules: Rules::read(values, 50_000, waterfall)?,
            initial,
            section: section?,
            waterfall,
            lyapunov: if values.flag("lyapunov").unwrap_or(false) {
                Some(usize::try_from(values.integer("lyapunov_periods").unwrap_or(2000)).ok()?)
            } else {
                None
            },
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let rows = self.speed.points.unwrap_or(DEFAULT_POINTS) * self.ways.len();
        let spectrum = self.waterfall.map_or(0, |_| 2 * LINES * HIGHEST);
        let columns = 16 + 11 * system.stations().len() + system.probes().len() + KEPT_POINTS + spectrum + 2 * system.n() + system.m();
        Some(Size {
            bytes: rows as f64 * columns as f64 * (KEPT + LISTED),
            of: text!("{rows} motions with {columns} numbers each", rows, columns),
            fewer: text!("give the range fewer points, or leave out the waterfall"),
        })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "sweep.free_spin",
                text!("the spin of this machine is free: it has no speed of its own to be swept"),
            )
            .help(text!("leave drive = \"free\" out, or follow its motion with transient")));
        }
        let timed = system.timed(Speeds::Several)?;
        ensemble::admit(&timed, method(&timed, self.rules.method, self.fastest()))
    }

    fn compute(&self, system: &System, context: &Context) -> Result<SweepResult, Diagnostic> {
        self.admit(system)?;
        let own = system.timed(Speeds::Several)?.with(&[]).map_err(Diagnostics::into_error)?;
        let initial = start::renumbered(&self.initial, system, &own);
        let whole = Arc::new(own);
        let reduction = ReducedMachine::of(&whole, self.fastest());
        let reduced = reduction.as_ref().map(|r| r.reduced);
        let own = reduction.as_ref().map_or_else(|| whole.clone(), |r| r.system.clone());
        let members = Members {
            budget: Budget::new(context.work_limit),
            study: self,
            initial,
            method: method(&own, self.rules.method, self.fastest()),
            probes: probes::all(&own),
            system: own,
            whole,
            reduction,
            speeds: self.speed.linspace(DEFAULT_POINTS),
            stations: system.stations(),
        };
        let (steps, ways) = (members.speeds.len(), self.ways.len());
        let followed = self.ways.iter().any(|w| *w != Way::Rest);
        // a chunk of followed motions is as long as a kill may cost, one of single motions as the lanes like
        let chunk = if followed { steps.div_ceil(50).clamp(FOLLOWED, 64) } else { steps.div_ceil(50).clamp(64, 1024) };
        let rows = rows::columns(self, &members);
        let plan = store::Plan {
            study: Self::KIND.into(),
            columns: rows.iter().map(|r| r.column.clone()).collect(),
            rows: steps * ways,
            chunk: chunk * ways,
        };
        context.announce(plan.rows as f64, 1000.0, text!("motions to follow until they repeat"));
        let results = store::run_on(plan, context, |range, counter, before| {
            let carried = before()?.map(|cells| rows::states(&rows, &cells, (ways, &members.probes)));
            let computed = members.rows(range.start / ways..range.end / ways, carried, counter);
            Ok(computed.map(|list| cells(&rows, &list)))
        })?;
        let motions = Collected::of(&results)?;
        let end = context.end(motions.end == End::Reached);
        let undeflected = Start::new(&members.system, members.speeds[0]).undeflected;
        Ok(SweepResult { motions, undeflected, forms: exact_parts(&members.system), reduced, end })
    }

    fn report(&self, system: &System, result: &SweepResult, name: &str) -> Result<Outcome, Diagnostic> {
        let shown = Shown { study: self, system, stations: system.stations(), probes: probes::all(system) };
        Ok(reduced_to(result.reduced, time_forms(&result.forms, report::report(&shown, result, name)?)))
    }
}

/// Settled motions at many speeds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SweepResult {
    /// One row for each speed and way, step by step, and at each step way by way; a way down begins at the highest speed. Columns as in the table `sweep`, and the points of the
    /// bifurcation diagram, lines of the spectrum and the state at the end of each motion.
    pub motions: Collected,
    /// Why motions begin undeflected although the machine is loaded.
    pub undeflected: Option<String>,
    /// Rational forms that stood for exact parts.
    pub forms: Vec<UsedForm>,
    /// What the machine was reduced to.
    pub reduced: Option<Reduced>,
    /// How the study ended.
    pub end: End,
}

/// A motion of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweepMotion {
    /// How it began.
    pub start: Way,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// What it settles on.
    pub motion: SettledMotion,
    /// Speeds between which it jumped on the way from the speed before, in smaller steps, rad/s.
    pub jump: Option<(f64, f64)>,
    /// Largest Lyapunov exponent, 1/s, where it was computed.
    pub lyapunov: Option<f64>,
    /// State at the end, at phase zero; NaN where the motion failed.
    pub state: Vec<f64>,
}

impl SweepResult {
    /// The motions, row by row.
    pub fn list(&self) -> Vec<SweepMotion> {
        let all = &self.motions;
        let number = ["speed", "jump_before", "jump_after", "lyapunov"].map(|name| all.numbers(name));
        let start = all.words("start");
        let state = all.columns.iter().map(|c| &c.0.name).filter(|n| n.starts_with(rows::STATE)).map(|n| all.numbers(n));
        let state: Vec<Vec<f64>> = state.collect();
        let one = |(row, motion): (usize, SettledMotion)| {
            let [speed, before, after, lyapunov] = number.each_ref().map(|n| n.get(row).copied().unwrap_or(f64::NAN));
            SweepMotion {
                start: Way::of(start.get(row).map_or("", String::as_str)),
                speed,
                motion,
                jump: Some((before, after)).filter(|j| j.0.is_finite() && j.1.is_finite()),
                lyapunov: Some(lyapunov).filter(|x| x.is_finite()),
                state: state.iter().map(|s| s[row]).collect(),
            }
        };
        settled(all).into_iter().enumerate().map(one).collect()
    }
}

/// A sweep as it is reported.
struct Shown<'a> {
    study: &'a Sweep,
    system: &'a System,
    stations: &'a [Station],
    /// What is recorded of every motion.
    probes: Vec<Probe>,
}

impl Shown<'_> {
    /// Share of the loudest below which a motion is not resolved.
    fn unresolved(&self) -> f64 {
        self.study.unresolved()
    }

    /// The body of a probe has a tilt beside it.
    fn tilts(&self, probe: &Probe) -> bool {
        !probe.is_tilt() && self.probes.iter().any(|p| p.is_tilt() && p.station == probe.station)
    }
}

fn section(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<(usize, usize)> {
    let Some(name) = values.text("section").filter(|n| !n.is_empty()) else { return Some((0, 0)) };
    let own = |p: &Probe, i: usize| [0, 1].into_iter().find(|&k| (p.is_reference() || p.is_tilt()) && p.rows.0[k] == [(i, 1.0)]);
    let find = |i: usize| probes::all(system).iter().enumerate().find_map(|(k, p)| Some((k, own(p, i)?)));
    let found = system.coordinate(name).and_then(find);
    if found.is_none() {
        let first = system.stations().iter().filter_map(|s| s.lateral.first());
        let known: Vec<String> = first.map(|x| format!("\"{}\"", system.coordinates()[x].name)).collect();
        let message = text!("\"{name}\" is no displacement or tilt of a body", name);
        let help = text!("name one such as {known}", known = known.join(", "));
        diagnostics.push(Diagnostic::error("sweep.section", message).at(values.span_of("section")).about(name).help(help));
    }
    found
}

impl Sweep {
    /// Largest speed, where motions are the least stiff, rad/s.
    fn fastest(&self) -> f64 {
        self.speed.from.abs().max(self.speed.to.abs())
    }

    /// Share of the loudest below which a motion is not resolved: settling ends within the tolerance.
    fn unresolved(&self) -> f64 {
        probes::UNRESOLVED * self.rules.tolerance
    }
}

/// A sweep on its machine.
struct Members<'a> {
    budget: Budget,
    study: &'a Sweep,
    /// Start, by entries of the machine in time.
    initial: Vec<(Entry, f64)>,
    /// The machine as it is written, and what it was reduced to.
    whole: Arc<System>,
    reduction: Option<ReducedMachine>,
    /// The machine whose motions are followed.
    system: Arc<System>,
    method: Method,
    speeds: Vec<f64>,
    stations: &'a [Station],
    /// What is recorded of every motion.
    probes: Vec<Probe>,
}

/// State a followed motion brings along, for each way; none where it failed.
type Carried = Vec<Option<Followed>>;

impl Members<'_> {
    /// The speed of a step: downward sweeps begin at the top.
    fn speed(&self, way: Way, step: usize) -> f64 {
        if way == Way::Down { self.speeds[self.speeds.len() - 1 - step] } else { self.speeds[step] }
    }

    /// A member, from its own start or the state it brings along.
    fn member_at(&self, speed: f64, carried: Option<&Vec<f64>>) -> Member {
        let start = Start::new(&self.system, speed);
        let y = carried.cloned().unwrap_or_else(|| {
            let mut y = vec![0.0; 2 * self.system.n() + self.system.m()];
            match &self.reduction {
                // a start that the file gives is written in the coordinates of the whole machine
                Some(r) if !self.initial.is_empty() => drop(Start::new(&self.whole, speed).on(Some(r), &self.initial, &mut y)),
                _ => start.write(&self.initial, &mut y),
            }
            y
        });
        Member { speed, y, rest: start.rest, rate: slowest_decay(&self.system, speed), system: self.system.clone() }
    }

    /// Settled motions of members, with their exponents; none when stopped.
    fn settle(&self, members: &[Member], counter: &Rows) -> Option<Vec<SteadyPoint>> {
        self.settle_within(members, counter, &self.budget)
    }

    /// The same within another budget.
    fn settle_within(&self, members: &[Member], counter: &Rows, budget: &Budget) -> Option<Vec<SteadyPoint>> {
        let form = Form::of(&self.system, true);
        let probes = self.probes.clone();
        let task = SteadyStateSearch { members, rules: &self.study.rules, counter, budget, probes };
        let all = 0..members.len();
        let settings = Settings { method: self.method, ..Settings::default() };
        let steady_state = ensemble::run(&task, &self.system, form, all.clone(), settings)?;
        let exponents = match self.study.lyapunov {
            None => vec![None; members.len()],
            Some(periods) => {
                let one = |(m, s): (&Member, &SteadyState)| s.measure.as_ref().map(|_| (m.speed, s.y.clone()));
                let members = members.iter().zip(&steady_state).map(one).collect();
                let pairs = Pairs { system: self.system.clone(), members, periods, counter, budget };
                ensemble::run(&pairs, &self.system, form, all, settings)?
            }
        };
        // a motion that the budget cut short is none
        (!budget.used_up()).then(|| steady_state.into_iter().zip(exponents).collect())
    }

    /// Rows of the steps of a chunk, step by step and way by way.
    fn rows(&self, steps: Range<usize>, carried: Option<Carried>, counter: &Rows) -> Option<Vec<Row>> {
        let ways = &self.study.ways;
        let mut out: Vec<Vec<Row>> = ways.iter().map(|_| Vec::with_capacity(steps.len())).collect();
        let row = |way: Way, m: &Member, found: SteadyPoint, jump: Option<(f64, f64)>| Row {
            way,
            speed: m.speed,
            rate: m.rate,
            steady_state: found.0,
            exponent: found.1,
            jump,
        };
        if let Some(w) = ways.iter().position(|w| *w == Way::Rest) {
            let here = Here::now();
            let member = |step| {
                let _counted = here.enter();
                self.member_at(self.speed(Way::Rest, step), None)
            };
            let members: Vec<Member> = steps.clone().into_par_iter().map(member).collect();
            let found = self.settle(&members, counter)?;
            out[w] = members.iter().zip(found).map(|(m, f)| row(Way::Rest, m, f, None)).collect();
        }
        let mut carried = carried.unwrap_or_else(|| vec![None; ways.len()]);
        for w in (0..ways.len()).filter(|&w| ways[w] != Way::Rest) {
            out[w] = self.follow(ways[w], steps.clone(), &mut carried[w], counter)?;
        }
        let mut each: Vec<_> = out.into_iter().map(Vec::into_iter).collect();
        Some(steps.flat_map(|_| each.iter_mut().filter_map(Iterator::next).collect::<Vec<_>>()).collect())
    }
}
