//! Motion while the spin speed follows a programme: run-up, coast-down, passage through resonances.
//!
//! Equations: those of [`crate::solve::motion`]; the spin row gives the torque of the drive. The quasi-static linear response at the same speed is
//! `Z(i W, W) X = f(W)` with nonlinear parts linearised at rest.
//!
//! Symbols: W spin speed, rad/s; Z dynamic stiffness, N/m; X complex amplitude, m.
//!
//! Validity: that of the parts, followed along the motion; a liquid layer must be spun up with its cavity.
//!
//! Theory: `docs/theory/motors-and-run-up.md#passage-through-resonance`.
//!
//! Sources: `000_a291f7ede1484e56` chapter 2; envelope against speed as in every text on passage through resonance.

mod linear;
mod passing;
mod report;

pub use super::unstable::Range;
pub use passing::{BodyPassages, Nature, Passage, Swings};

use super::history::{self, ABSOLUTE, METHOD, PHASE, POINTS, RELATIVE, Settings};
use super::moved_roots::moved_roots;
use super::record::{Beside, MotionRecord};
use super::spectra::{self, Spectra};
use super::start::{self, Entry, INITIAL, Start};
use super::turns::Turns;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::{Drive, System};
use crate::model::timed::Speeds;
use crate::outcome::{End, Outcome};
use crate::solve::motion::envelope::Window;
use crate::solve::motion::trajectory::{Plan, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::solve::programme::{Programme, Shape, Unusable};
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::NARROWEST;
use crate::study::{Context, Study};
use crate::text;
use linear::LinearResponse;
use serde::{Deserialize, Serialize};

/// See the [module](self).
pub struct RunUp {
    programme: Programme,
    t_end: f64,
    settings: Settings,
    windows: usize,
    initial: Vec<(Entry, f64)>,
    velocities: bool,
    observables: bool,
    spectra: Option<Spectra>,
    /// Integrate the energy account beside the motion.
    account: bool,
}

/// A motion along a programme of the spin speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RunUpResult {
    /// The motion, with its state at the end.
    pub motion: MotionRecord,
    /// Torque that the drive must bring at the outputs, N m.
    pub torque: Vec<f64>,
    /// Largest |x + i y| of the steady linear response by body, at the middles of the windows of the envelope; none where the machine has no such response.
    pub linear: Option<Vec<Vec<f64>>>,
    /// Peaks of the envelope of every body that moves, then of every tilt.
    pub passages: Vec<BodyPassages>,
    /// Of a motion that passed its bound, the envelope of the body that did, up to there.
    pub unbounded: Vec<Window>,
    /// How the study ended.
    pub end: End,
}

const TABLE: &[(&str, &str, bool, &str)] =
    &[("time", "s", true, "times, increasing, from 0"), ("speed", "rad/s", true, "spin speed at these times")];

impl Study for RunUp {
    type Result = RunUpResult;
    const KIND: &'static str = "run_up";
    const EXAMPLE: &'static str = r#"from = "0 rpm"
to = "12000 rpm"
duration = "20 s"
hold = "2 s"
"#;
    const DOC: &'static str = "Motion while the spin speed follows a programme: from one speed to another, coasting down, or through a table of \
        speeds. Reports the envelope against speed beside the quasi-static linear response, the peaks, and the torque and power of the drive. A spatial \
        liquid has at every moment the waves of its speed, with an error that is stated; viscous liquids are refused.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::optional("from", FieldKind::Quantity { unit: "rad/s", bounds: Bounds::within(1e7) }, "0 rad/s", "speed at the start"),
        Field::optional(
            "to",
            FieldKind::Quantity { unit: "rad/s", bounds: Bounds::within(1e7) },
            "",
            "speed at the end; that of the machine when absent",
        ),
        Field::optional(
            "duration",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) },
            "",
            "time from one speed to the other",
        ),
        Field::optional(
            "shape",
            FieldKind::Choice(&[
                ("linear", "constant acceleration"),
                ("smooth", "acceleration that begins and ends at zero"),
                ("exponential", "constant rate relative to the speed: coasting down against viscous drag"),
            ]),
            "linear",
            "how the speed changes",
        ),
        Field::optional(
            "programme",
            FieldKind::Columns(TABLE),
            "",
            "speeds at given times, joined smoothly, instead of from, to and duration",
        ),
        Field::optional(
            "polynomial",
            FieldKind::List { unit: "", bounds: Bounds::within(1e12) },
            "",
            "speed as a polynomial of the time during duration, instead of from and to: coefficients of 1, t, t^2 ... in rad/s, rad/s^2, rad/s^3 ...",
        ),
        Field::optional("hold", FieldKind::Quantity { unit: "s", bounds: Bounds::up_to(1e9) }, "0 s", "time at the last speed"),
        Field::optional("windows", FieldKind::Integer { min: 10, max: 100_000 }, "400", "pieces of equal time the envelope is taken over"),
        PHASE,
        INITIAL,
        METHOD,
        RELATIVE,
        ABSOLUTE,
        POINTS,
        Field::optional("velocities", FieldKind::Flag, "false", "list the rates too"),
        Field::optional("observables", FieldKind::Flag, "false", "list the quantities the parts show, such as bearing forces"),
        spectra::WATERFALL,
        spectra::SPECTRA,
        spectra::HIGHEST_ORDER,
        spectra::THRESHOLD,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let initial = start::state_map(values, "initial", system, diagnostics);
        let settings = Settings::read(values);
        let made = programme(values, system, settings.phase, diagnostics).filter(|(p, _)| changes(p, values, diagnostics));
        let t_end = made.as_ref().map(|m| m.1 + values.number("hold").unwrap_or(0.0));
        let span = made.as_ref().zip(t_end).map(|((p, _), t)| (t, p.largest_speed()));
        let spectra = Spectra::read(values, system, span.unwrap_or((1.0, 1.0)), diagnostics);
        if diagnostics.0.len() > before {
            return None;
        }
        Some(RunUp {
            programme: made?.0,
            t_end: t_end?,
            spectra,
            settings,
            windows: values.integer("windows").map_or(400, |x| x.max(10) as usize),
            initial,
            velocities: values.flag("velocities").unwrap_or(false),
            observables: values.flag("observables").unwrap_or(false),
            account: true,
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        let (from, to) = self.programme.speed_range();
        vec![SpinSpeeds::between(from, to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(history::size(system, self.settings.points, self.velocities, self.observables))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error("run_up.drive", text!("the spin of this machine is free and cannot follow a programme"))
                .help(text!("use a transient study, or take the free drive away")));
        }
        let timed = system.timed(Speeds::Changing)?;
        let reduced = history::reduced(&timed, self.programme.clone());
        let system: &System = reduced.as_ref().map_or(&timed, |r| &r.system);
        let motion = Motion::new(system, SpinLaw::Programme(self.programme.clone()))?;
        history::admit(&motion, self.settings.method)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<RunUpResult, Diagnostic> {
        self.admit(system)?;
        let s = &self.settings;
        let (exact, timed) = (system, system.timed(Speeds::Changing)?);
        let reduced = history::reduced(&timed, self.programme.clone());
        let system: &System = reduced.as_ref().map_or(&timed, |r| &r.system);
        let mut motion = Motion::new(system, SpinLaw::Programme(self.programme.clone()))?;
        let no_account = if self.account { motion.keep_account().err() } else { None };
        let mut y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
        let entries = start::renumbered(&self.initial, exact, &timed);
        let start = Start::new(&timed, self.programme.at(0.0).speed).on(reduced.as_ref(), &entries, &mut y);
        let last = self.programme.at(self.t_end);
        history::announce(context, self.t_end, (last.phase - self.programme.at(0.0).phase) / self.t_end);
        let requested = history::spaced(self.t_end, s.points);
        let turns = Turns::beside(&requested, last, self.programme.largest_speed());
        let drawn = turns.as_ref().map_or_else(|| requested.clone(), |t| t.with_outputs(&requested));
        let outputs = self.spectra.as_ref().map_or_else(|| drawn.clone(), |s| s.with_outputs(&drawn));
        let plan = Plan {
            t_end: self.t_end,
            choice: s.method,
            relative: s.relative,
            absolute: s.absolute,
            outputs: &outputs,
            windows: self.windows,
            rest: &start.rest,
            bound: history::bound(system, &start, &y),
            kick: None,
            max_steps: context.work_limit,
            cancel: &|| context.cancelled(),
            progress: &history::progress(context, self.t_end),
        };
        let mut trajectory = simulate(&mut motion, &y, &plan)?;
        let spectra = self.spectra.as_ref().map_or_else(Vec::new, |s| s.taken(&motion, &start, &mut trajectory, &drawn));
        let last_turns = turns.and_then(|t| t.taken(&motion, &mut trajectory, &requested));
        let unbounded = match trajectory.left {
            Some(left) => history::magnified(&mut motion, &y, &plan, trajectory.clone(), 2)?.windows.swap_remove(left.body),
            None => Vec::new(),
        };
        let dim = trajectory.state.len().max(1);
        let states = trajectory.times.iter().zip(trajectory.states.chunks_exact(dim));
        let torque = states.map(|(&t, y)| motion.torque(t, y).unwrap_or(f64::NAN)).collect();
        let beside = Beside {
            start: &start,
            velocities: self.velocities,
            observables: self.observables,
            no_account,
            last_turns,
            moved_roots: moved_roots(exact, &timed, last.speed, context),
            natural: spectra::natural(exact, &spectra),
            reduced: reduced.as_ref().map(|r| r.reduced),
            spectra,
        };
        let record = MotionRecord::of(&mut motion, &trajectory, beside);
        let passages = match record.left {
            None => self.passages(system, &record, &trajectory, plan.cancel),
            Some(_) => Vec::new(),
        };
        let end = match history::end(&record) {
            End::StepTooSmall { at } => End::StepTooSmall { at: self.programme.at(at).speed },
            End::Unbounded { at } => End::Unbounded { at: self.programme.at(at).speed },
            other => other,
        };
        let linear = LinearResponse::new(system).map(|mut response| {
            let rows: Vec<Vec<f64>> = self.middles(&record).iter().map(|&t| response.amplitudes(self.programme.at(t).speed)).collect();
            (0..system.stations().len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect()
        });
        Ok(RunUpResult { motion: record, torque, linear, passages, unbounded, end })
    }

    fn report(&self, system: &System, result: &RunUpResult, name: &str) -> Result<Outcome, Diagnostic> {
        report::report(self, system, result, name)
    }
}

/// The programme and its last time.
fn programme(values: &Values, system: &System, phase: f64, diagnostics: &mut Diagnostics) -> Option<(Programme, f64)> {
    let unusable = |field: &str, Unusable(what): Unusable| Diagnostic::error("run_up.programme", what).at(values.span_of(field));
    if let Some(columns) = values.columns("programme") {
        let (times, speeds) = (columns.get("time")?, columns.get("speed")?);
        if times.first() != Some(&0.0) {
            diagnostics.push(Diagnostic::error("run_up.programme", text!("the times must begin at 0")).at(values.span_of("programme")));
        }
        for given in ["to", "duration", "polynomial"] {
            if values.get(given).is_some() {
                diagnostics.push(
                    Diagnostic::error("run_up.programme", text!("both a programme and {given} are given", given))
                        .at(values.span_of(given))
                        .help(text!("say one or the other")),
                );
            }
        }
        return match Programme::table(times, speeds, phase) {
            Ok(p) => Some((p, *times.last()?)),
            Err(e) => {
                diagnostics.push(unusable("programme", e));
                None
            }
        };
    }
    let Some(duration) = values.number("duration") else {
        diagnostics.push(
            Diagnostic::error("run_up.duration", text!("how long the change of speed takes is missing"))
                .at(values.span.clone())
                .help(text!("add duration = \"10 s\", or a programme of times and speeds")),
        );
        return None;
    };
    if let Some(coefficients) = values.list("polynomial") {
        if values.number("to").is_some() {
            diagnostics.push(
                Diagnostic::error("run_up.programme", text!("both a polynomial and to are given"))
                    .at(values.span_of("to"))
                    .help(text!("say one or the other")),
            );
        }
        return match Programme::polynomial(coefficients, duration, phase) {
            Ok(p) => Some((p, duration)),
            Err(e) => {
                diagnostics.push(unusable("polynomial", e));
                None
            }
        };
    }
    let Some(to) = values.number("to").or(system.machine.speed) else {
        diagnostics.push(
            Diagnostic::error("study.speed", text!("neither the study nor the machine says which speed to reach"))
                .at(values.span.clone())
                .help(text!("add to = \"3000 rpm\"")),
        );
        return None;
    };
    let shape = match values.choice("shape") {
        Some("smooth") => Shape::Smooth,
        Some("exponential") => Shape::Exponential,
        _ => Shape::Linear,
    };
    match Programme::ramp(values.number("from").unwrap_or(0.0), to, duration, shape, phase) {
        Ok(p) => Some((p, duration)),
        Err(e) => {
            diagnostics.push(unusable("duration", e));
            None
        }
    }
}

/// Whether the speed changes at all, with a mistake where it does not.
fn changes(programme: &Programme, values: &Values, diagnostics: &mut Diagnostics) -> bool {
    let (low, high) = programme.speed_range();
    if high - low > NARROWEST * high.abs().max(low.abs()) {
        return true;
    }
    let speed = text::quantity(low, "rad/s");
    let given = |field: &&str| values.get(field).is_some();
    let (said, field) = match ["programme", "polynomial", "to"].into_iter().find(given) {
        Some("to") => (text!("from and to are both {speed}", speed), "to"),
        Some(field) => (text!("this {field} stays at {speed}", field, speed), field),
        None => (text!("from and the speed of the machine are both {speed}", speed), "from"),
    };
    let message = text!("a run-up needs two different speeds; {said}", said);
    let help = text!("give another speed, or take a transient study for a constant speed");
    diagnostics.push(Diagnostic::error("run_up.speed", message).at(values.span_of(field)).help(help));
    false
}

impl RunUp {
    /// The motion alone, without the account of its energy.
    pub(in crate::study) fn without_account(self) -> Self {
        RunUp { account: false, ..self }
    }

    /// Middles of the windows of the envelope that were computed, s.
    fn middles(&self, record: &MotionRecord) -> Vec<f64> {
        let seen = |w: &Vec<Window>| w.iter().take_while(|w| w.peak.amplitude.is_finite()).count();
        let count = record.windows.first().map_or(0, seen);
        (0..count).map(|k| self.t_end * (k as f64 + 0.5) / self.windows as f64).collect()
    }
}
