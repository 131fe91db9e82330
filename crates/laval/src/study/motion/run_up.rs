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

use super::balance;
use super::drive;
use super::history::{self, ABSOLUTE, Columns, Listed, METHOD, PHASE, POINTS, RELATIVE, Settings};
use super::moved_roots::moved_roots;
use super::passages::{PROMINENT, envelope, passages};
use super::spectra::{self, Spectra};
use super::start::{self, Entry, INITIAL, Start};
use super::turns::Turns;
use super::unstable::{Range, Rates};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Grid;
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::At;
use crate::model::system::{Drive, System};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::model::timed::Speeds;
use crate::outcome::{Axis, End, Figure, Finding, Line, Outcome, Panel, SpecialPoint, Status, quantity, significant};
use crate::solve::characteristic::{Equilibrium, Frame};
use crate::solve::motion::envelope::Peak;
use crate::solve::motion::trajectory::{Plan, Trajectory, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::solve::programme::{Programme, Shape, Unusable};
use crate::solve::rest::unlinearised;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::{Context, Study};
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};

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
}

const TABLE: &[(&str, &str, bool, &str)] =
    &[("time", "s", true, "times, increasing, from 0"), ("speed", "rad/s", true, "spin speed at these times")];

impl Study for RunUp {
    type Result = Outcome;
    const KIND: &'static str = "run_up";
    const EXAMPLE: &'static str = r#"from = "0 rpm"
to = "12000 rpm"
duration = "20 s"
hold = "2 s"
"#;
    const DOC: &'static str = "Motion while the spin speed follows a programme: from one speed to another, coasting down, or through a table of \
        speeds. Reports the envelope against speed beside the quasi-static linear response, the peaks, and the torque and power of the drive. A spatial \
        liquid has at every moment the waves of its speed, with an error that is stated; viscous liquids are refused.";
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
        let made = programme(values, system, settings.phase, diagnostics);
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
            return Err(Diagnostic::error("run_up.drive", "the spin of this machine is free and cannot follow a programme")
                .help("use a transient study, or take the free drive away"));
        }
        let timed = system.timed(Speeds::Changing)?;
        let motion = Motion::new(&timed, SpinLaw::Programme(self.programme.clone()))?;
        history::admit(&motion, self.settings.method)
    }

    fn report(&self, _: &System, result: &Outcome, _: &str) -> Result<Outcome, Diagnostic> {
        Ok(result.clone())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        self.admit(system)?;
        let s = &self.settings;
        let (exact, timed) = (system, system.timed(Speeds::Changing)?);
        let system: &System = &timed;
        let mut motion = Motion::new(system, SpinLaw::Programme(self.programme.clone()))?;
        let no_account = history::keep_account(&mut motion);
        let mut y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
        let start = Start::new(system, self.programme.at(0.0).speed);
        start.write(&start::renumbered(&self.initial, exact, system), &mut y);
        let still = history::negligible(s, &start);
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
        let record = self.spectra.as_ref().map(|s| (s, s.taken(&motion, &start, &mut trajectory, &drawn)));
        let path = turns.map(|t| t.taken(&motion, &mut trajectory, &requested)).transpose()?.flatten();
        let (end, stopped) = history::ended(&trajectory);
        let end = match end {
            End::StepTooSmall { at } => End::StepTooSmall { at: self.programme.at(at).speed },
            End::Unbounded { at } => End::Unbounded { at: self.programme.at(at).speed },
            other => other,
        };
        let mut outcome = Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(end);
        for f in stopped.into_iter().chain(start.finding) {
            outcome = outcome.finding(f);
        }
        match trajectory.left {
            Some(left) => {
                let speed = self.programme.at(left.t).speed;
                let again = history::magnified(&mut motion, &y, &plan, trajectory.clone(), 2)?;
                if let Some(f) = history::unbounded(system, &again, std::f64::consts::TAU / speed.abs()) {
                    outcome = outcome.finding(f.evidence("speed there", speed, "rad/s"));
                }
            }
            None => outcome = self.peaks(system, &trajectory, still, plan.cancel, outcome),
        }
        outcome = moved_roots(exact, &timed, last.speed, context).into_iter().fold(outcome, Outcome::finding);
        outcome = self.drive(&mut motion, &trajectory, outcome)?;
        let (mut outcome, balance) = history::accounted(&mut motion, &trajectory, no_account, outcome)?;
        outcome = self.envelope(system, &trajectory, outcome)?;
        if let Some((spectra, record)) = record {
            outcome = spectra.report(&record, outcome)?;
        }
        let listed = Listed { velocities: self.velocities, observables: self.observables, path, envelope: false };
        let outcome = history::shown(&mut motion, &trajectory, listed, balance, outcome)?;
        balance::report(&mut motion, &trajectory, outcome)
    }
}

/// The programme and its last time.
fn programme(values: &Values, system: &System, phase: f64, diagnostics: &mut Diagnostics) -> Option<(Programme, f64)> {
    let unusable = |field: &str, Unusable(what): Unusable| Diagnostic::error("run_up.programme", what).at(values.span_of(field));
    if let Some(columns) = values.columns("programme") {
        let (times, speeds) = (columns.get("time")?, columns.get("speed")?);
        if times.first() != Some(&0.0) {
            diagnostics.push(Diagnostic::error("run_up.programme", "the times must begin at 0").at(values.span_of("programme")));
        }
        for given in ["to", "duration", "polynomial"] {
            if values.get(given).is_some() {
                diagnostics.push(
                    Diagnostic::error("run_up.programme", format!("both a programme and {given} are given"))
                        .at(values.span_of(given))
                        .help("say one or the other"),
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
            Diagnostic::error("run_up.duration", "how long the change of speed takes is missing")
                .at(values.span.clone())
                .help("add duration = \"10 s\", or a programme of times and speeds"),
        );
        return None;
    };
    if let Some(coefficients) = values.list("polynomial") {
        if values.number("to").is_some() {
            diagnostics.push(
                Diagnostic::error("run_up.programme", "both a polynomial and to are given")
                    .at(values.span_of("to"))
                    .help("say one or the other"),
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
            Diagnostic::error("study.speed", "neither the study nor the machine says which speed to reach")
                .at(values.span.clone())
                .help("add to = \"3000 rpm\""),
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

impl RunUp {
    /// Largest displacements and the passages through resonances.
    fn peaks(&self, system: &System, trajectory: &Trajectory, still: f64, stop: &dyn Fn() -> bool, mut outcome: Outcome) -> Outcome {
        let mut rates: Option<Option<Rates>> = None;
        for seen in history::probe_motions(system, trajectory, still) {
            let (peak, windows, unit) = (seen.peak, seen.windows, seen.unit);
            let speed = self.programme.at(peak.t).speed;
            let Some(largest) = seen.largest() else { continue };
            outcome = outcome.finding(largest.evidence("at speed", speed, "rad/s").evidence("at time", peak.t, "s"));
            if peak.amplitude <= seen.still {
                continue;
            }
            let (name, b) = (seen.words(), seen.label());
            let spin = |t: f64| self.programme.at(t);
            let seen = envelope(windows, &spin);
            let slips = |t: f64| balance::slips(system, trajectory, t, &|t| spin(t).phase);
            let mut round: Vec<(f64, f64)> = Vec::new();
            let passed = passages(&seen, &spin);
            if !passed.is_empty() && rates.is_none() {
                rates = Some(Rates::along(system, trajectory.run.t, &|t| spin(t).speed, stop));
            }
            for &i in &passed {
                let p = seen[i];
                let speed = |k: usize| self.programme.at(seen[k].t).speed;
                let beside = |mut k: Box<dyn Iterator<Item = usize>>| k.find(|&k| seen[k].t != p.t).map_or(speed(i), speed);
                let (before, after) = (beside(Box::new((0..i).rev())), beside(Box::new(i + 1..seen.len())));
                let at = self.programme.at(p.t).speed;
                if before == at && after == at {
                    // nothing is passed while the speed is held
                    continue;
                }
                if slips(p.t) {
                    round.push((p.amplitude, at));
                    continue;
                }
                let since = lowest_before(&seen, &passed, i);
                let finding = self.passage((&name, &b), rates.as_ref().and_then(Option::as_ref), [since, p.t]);
                let finding = finding.value(at, "rad/s").evidence("amplitude", p.amplitude, unit);
                let point = SpecialPoint::new("peak", at, (before.min(after), before.max(after))).status(Status::Bracketed);
                outcome =
                    outcome.finding(finding.evidence("at time", p.t, "s")).special_point(point.evidence("amplitude", p.amplitude, unit));
            }
            if let Some(&(amplitude, at)) = round.iter().max_by(|a, b| a.0.total_cmp(&b.0)) {
                let text = format!(
                    "{name} swings while masses go round in the rotor, which is no resonance of its own: its envelope peaks most at {{}}."
                );
                let finding = Finding::info("swings", text).of(&b).value(at, "rad/s").evidence("amplitude", amplitude, unit);
                outcome = outcome.finding(finding.evidence("peaks", round.len() as f64, ""));
            }
        }
        outcome
    }

    /// What a peak of the envelope is, from the time since which it rises: a resonance where the machine is stable and the spin speed meets a natural frequency on the way,
    /// growth through a range in which it is not stable, else no more than a peak.
    fn passage(&self, (name, subject): (&str, &str), rates: Option<&Rates>, [since, until]: [f64; 2]) -> Finding {
        let grown = rates.and_then(|r| r.most(since, until)).filter(|range| range.factor > 1.0 / PROMINENT);
        match grown {
            None if rates.is_some_and(|r| r.meets(since, until)) => {
                Finding::info("peak", format!("{name} passes a resonance: its envelope peaks at {{}}."))
            }
            None => Finding::info("peak", format!("The envelope of {} peaks at {{}}.", name.replacen("The ", "the ", 1))),
            Some(Range { speeds: [a, b], factor, rate }) => {
                let (a, b, times) = (quantity(a, "rad/s"), quantity(b, "rad/s"), significant(factor, 2));
                let text = format!(
                    "{name} grows by itself between {a} and {b}, where the machine is unstable, by a factor of up to {times}: its envelope peaks at {{}}. Pass this range \
                     quickly, or add damping."
                );
                Finding::warning("unstable_range", text).evidence("largest growth rate there", rate, "1/s")
            }
        }
        .of(subject)
    }

    /// Torque and power of the drive at the outputs.
    fn drive(&self, motion: &mut Motion, trajectory: &Trajectory, outcome: Outcome) -> Result<Outcome, Diagnostic> {
        let dim = trajectory.state.len();
        let mut torque = Vec::with_capacity(trajectory.times.len());
        let spins: Vec<_> = trajectory.times.iter().map(|&t| self.programme.at(t)).collect();
        for (&t, y) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)) {
            torque.push(motion.torque(t, y).unwrap_or(f64::NAN));
        }
        let power: Vec<f64> = torque.iter().zip(&spins).map(|(m, s)| m * s.speed).collect();
        let system = motion.system();
        let accelerates = spins.iter().any(|s| s.accel != 0.0);
        let speeds: Vec<f64> = spins.iter().map(|s| s.speed).collect();
        let driven = speeds.first().is_some_and(|&w| system.drive_torque(w).is_some());
        let beyond = if driven { "Beyond its motors the drive" } else { "The drive" };
        let short = drive::short(system, &speeds, &torque, accelerates);
        let lacking = if accelerates { drive::without_inertia(system, "Torque and power of the drive are") } else { None };
        let largest =
            |x: &[f64]| x.iter().enumerate().map(|(i, x)| (x.abs(), i)).max_by(|a, b| a.0.total_cmp(&b.0)).map_or((f64::NAN, 0), |m| m);
        let ((most, at), (strongest, when)) = (largest(&torque), largest(&power));
        let speed = |i: usize| spins.get(i).map_or(f64::NAN, |s| s.speed);
        let mut columns = Columns::default();
        columns.add("t", "s", "time", trajectory.times.clone());
        columns.add("speed", "rad/s", "spin speed", spins.iter().map(|s| s.speed).collect());
        columns.add("acceleration", "rad/s^2", "spin acceleration", spins.iter().map(|s| s.accel).collect());
        columns.add("torque", "N m", "torque the drive must bring", torque);
        columns.add("power", "W", "power the drive must bring", power);
        let line = |column: &str| Line::new("drive", "t", column).name(column);
        let figure = Figure::new("drive", "Drive", "Spin speed, torque and power of the drive against time.")
            .x(Axis::new("time", "s"))
            .panel(Panel::new(Axis::new("speed", "rad/s")).mark(line("speed")))
            .panel(Panel::new(Axis::new("torque", "N m")).mark(line("torque")))
            .panel(Panel::new(Axis::new("power", "W")).mark(line("power")));
        let outcome = outcome.table(columns.table("drive", "Torque and power of the drive against time")?).figure(figure);
        if trajectory.left.is_some() {
            return Ok(outcome);
        }
        let outcome = short.into_iter().chain(lacking).fold(outcome, Outcome::finding);
        Ok(outcome
            .finding(Finding::info("largest_torque", format!("{beyond} must bring a torque of up to {{}}.")).value(most, "N m").evidence(
                "at speed",
                speed(at),
                "rad/s",
            ))
            .finding(Finding::info("largest_power", format!("{beyond} must bring a power of up to {{}}.")).value(strongest, "W").evidence(
                "at speed",
                speed(when),
                "rad/s",
            )))
    }

    /// Envelope against speed, beside the linear response.
    fn envelope(&self, system: &System, trajectory: &Trajectory, outcome: Outcome) -> Result<Outcome, Diagnostic> {
        let bodies = system.bodies();
        if bodies.is_empty() {
            return Ok(outcome);
        }
        let seen: Vec<_> = trajectory.windows.iter().map(|w| envelope(w, &|t| self.programme.at(t))).collect();
        let count = seen.first().map_or(0, Vec::len);
        let middle: Vec<f64> = (0..count).map(|k| self.t_end * (k as f64 + 0.5) / self.windows as f64).collect();
        let speeds: Vec<f64> = middle.iter().map(|&t| self.programme.at(t).speed).collect();
        let mut linear = LinearResponse::new(system);
        let quasi: Option<Vec<Vec<f64>>> = linear.as_mut().map(|l| speeds.iter().map(|&w| l.amplitudes(w)).collect());
        let mut columns = Columns::default();
        columns.add("t", "s", "middle of the window", middle);
        columns.add("speed", "rad/s", "spin speed there", speeds);
        let mut figure = Figure::new(
            "envelope",
            "Envelope against speed",
            "Largest displacement of each body from rest within a turn, against the spin speed.",
        )
        .x(Axis::new("speed", "rad/s"));
        for (k, b) in bodies.iter().enumerate() {
            let amplitude = |i: usize| seen[k][i].amplitude;
            let doc = "largest distance from rest in the window and within half a turn of it";
            columns.add(format!("{} amplitude", b.name), "m", doc, (0..count).map(amplitude).collect());
            let mut panel = Panel::new(Axis::new(&b.name, "mm").factor(1e3))
                .mark(Line::new("envelope", "speed", format!("{} amplitude", b.name)).name("envelope"));
            if let Some(q) = &quasi {
                let name = format!("{} linear", b.name);
                columns.add(
                    &name,
                    "m",
                    "largest |x + i y| of the steady linear response, at any point of the body, at this speed; NaN where nothing holds or damps the machine",
                    q.iter().map(|row| row[k]).collect(),
                );
                panel = panel.mark(Line::new("envelope", "speed", name).name("steady linear response"));
            }
            figure = figure.panel(panel);
        }
        Ok(outcome.table(columns.table("envelope", "Envelope of the motion against speed")?).figure(figure))
    }
}

/// The time of the lowest place of an envelope between a passage and the one before it.
fn lowest_before(seen: &[Peak], passed: &[usize], at: usize) -> f64 {
    let from = passed.iter().copied().take_while(|&k| k < at).last().unwrap_or(0);
    seen[from..=at].iter().min_by(|a, b| a.amplitude.total_cmp(&b.amplitude)).map_or(0.0, |p| p.t)
}

/// Steady unbalance response of the machine linearised at rest.
struct LinearResponse<'a> {
    system: &'a System,
    model: LinearModel<f64>,
    scratch: LinearScratch<f64>,
    tangent: Tangent,
    tangent_scratch: TangentScratch,
    stiffness: Grid<C64>,
}

impl<'a> LinearResponse<'a> {
    /// `None` when a nonlinear part has no linear form at rest, states of its own, or forces of its own that turn.
    fn new(system: &'a System) -> Option<Self> {
        let still = Equilibrium::zero(system, Frame::Fixed, 0.0);
        let fits =
            system.slots().iter().all(|s| s.is_linear() || (s.states.is_empty() && !s.uses.spin)) && unlinearised(system, &still).is_none();
        fits.then(|| LinearResponse {
            system,
            model: LinearModel::default(),
            scratch: LinearScratch::default(),
            tangent: Tangent::default(),
            tangent_scratch: TangentScratch::default(),
            stiffness: Grid::empty(),
        })
    }

    /// Largest |x + i y| of each body, at any of its points; NaN where the stiffness is singular.
    fn amplitudes(&mut self, speed: f64) -> Vec<f64> {
        let system = self.system;
        let (n, zero) = (system.n(), vec![0.0; system.n().max(system.m())]);
        let (q, z) = (&zero[..n], &zero[..system.m()]);
        system.linear(system.params(), speed, Form::Frequency, &mut self.model, &mut self.scratch);
        let s = c(0.0, speed);
        system.dynamic_stiffness(system.params(), &self.model, Form::Frequency, s, &mut self.stiffness, &mut self.scratch);
        let at = At { q, v: q, a: q, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        system.tangent(&at, false, &mut self.tangent, &mut self.tangent_scratch, |slot| !slot.is_linear());
        let t = &self.tangent;
        let matrix = Mat::from_fn(self.stiffness.rows(), self.stiffness.cols(), |i, j| {
            let own = self.stiffness[(i, j)];
            if i < n && j < n { own + c(t.q[(i, j)], 0.0) + s.scale(t.v[(i, j)]) + (s * s).scale(t.a[(i, j)]) } else { own }
        });
        let b = &self.model.blocks;
        let mut x: Vec<C64> = (0..matrix.rows()).map(|i| if i < n { c(b.force_cos[i], -b.force_sin[i]) } else { c(0.0, 0.0) }).collect();
        let count = system.bodies().len();
        let Ok(lu) = Lu::new(&matrix) else { return vec![f64::NAN; count] };
        lu.solve(&mut x);
        // forward and backward parts turn against each other: their radii add up once a turn
        let size = |[x, y]: [C64; 2]| 0.5 * ((x + y.mul_i()).abs() + (x - y.mul_i()).abs());
        let points = |k: usize| system.probes().iter().filter(move |p| p.body == k && !p.is_tilt());
        (0..count).map(|k| crate::study::shared::support::largest(points(k).map(|p| size(p.amplitudes(&x))))).collect()
    }
}
