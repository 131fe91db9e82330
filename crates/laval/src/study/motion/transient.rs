//! Motion in time from a given start.
//!
//! Equations: those of [`crate::solve::motion`].
//!
//! Symbols: t time, s; displacements m, rates per second; energies J.
//!
//! Validity: that of the parts, followed along the motion; frequency-domain parts only by a stated fit.
//!
//! Theory: `docs/theory/motion-in-time.md#first-order-system`.
//!
//! Sources: `000_a291f7ede1484e56` chapter 2 (transients by direct integration).

use super::balance;
use super::drive;
use super::history::{self, ABSOLUTE, Listed, METHOD, PHASE, POINTS, RELATIVE, Settings};
use super::moved_roots::moved_roots;
use super::spectra::{self, Spectra};
use super::start::{self, Entry, INITIAL, Start};
use super::turns::Turns;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::{Drive, System};
use crate::model::timed::Speeds;
use crate::outcome::{End, Finding, Outcome};
use crate::solve::motion::envelope::{Growth, Window, growth};
use crate::solve::motion::trajectory::{Plan, Trajectory, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::{Context, Study};

/// Speeds of a motion that starts at this one.
fn speeds(system: &System, speed: f64) -> Speeds {
    if system.machine.drive == Drive::Free { Speeds::Changing } else { Speeds::One(speed) }
}

/// Windows of the envelope.
const WINDOWS: usize = 200;
/// Turns from which a record is long, and windows below which its envelope has too few values.
const SEVERAL: f64 = 8.0;

/// See the [module](self).
pub struct Transient {
    duration: f64,
    speed: f64,
    settings: Settings,
    step: Option<f64>,
    initial: Vec<(Entry, f64)>,
    kick: Option<(f64, Vec<f64>)>,
    velocities: bool,
    observables: bool,
    spectra: Option<Spectra>,
}

impl Study for Transient {
    type Result = Outcome;
    const KIND: &'static str = "transient";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
duration = "2 s"
kick = { "drum.x'" = "20 mm/s" }
"#;
    const DOC: &'static str = "Motion in time from a given start at constant speed, or with the spin free to move by itself when the machine's drive \
        is free. Reports the motion, the energy balance, the largest displacements and whether the motion grows. A spatial \
        liquid is a sum over waves in time: its error is stated, and how far it moves the roots; so is a viscous liquid at constant speed.";
    const FIELDS: &'static [Field] = &[
        Field::required("duration", FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) }, "time to compute"),
        Field::optional(
            "speed",
            FieldKind::Quantity { unit: "rad/s", bounds: Bounds::within(1e7) },
            "",
            "spin speed; that of the machine when absent",
        ),
        PHASE,
        INITIAL,
        Field::optional("kick", FieldKind::StateMap, "", "sudden changes of rates, as { \"drum.x'\" = \"0.1 m/s\" }"),
        Field::optional("kick_time", FieldKind::Quantity { unit: "s", bounds: Bounds::up_to(1e9) }, "0 s", "when the kick comes"),
        METHOD,
        RELATIVE,
        ABSOLUTE,
        POINTS,
        Field::optional(
            "output_step",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) },
            "",
            "time between outputs, instead of their number",
        ),
        Field::optional("velocities", FieldKind::Flag, "false", "list the rates too"),
        Field::optional("observables", FieldKind::Flag, "true", "list the quantities the parts show, such as bearing forces"),
        spectra::WATERFALL,
        spectra::SPECTRA,
        spectra::HIGHEST_ORDER,
        spectra::THRESHOLD,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let duration = values.number("duration")?;
        let speed = values.number("speed").or(system.machine.speed);
        if speed.is_none() {
            diagnostics.push(
                Diagnostic::error("study.speed", "neither the study nor the machine says the spin speed")
                    .at(values.span.clone())
                    .help("add speed = \"3000 rpm\" to [machine] or to the study"),
            );
        }
        let initial = start::state_map(values, "initial", system, diagnostics);
        let mut change = vec![0.0; system.n()];
        let kicks = start::state_map(values, "kick", system, diagnostics);
        for &(e, x) in &kicks {
            match e {
                Entry::Rate(i) => change[i] = x,
                _ => diagnostics.push(
                    Diagnostic::error("transient.kick", "a kick changes rates only")
                        .at(values.span_of("kick"))
                        .help("name rates with ', such as \"drum.x'\""),
                ),
            }
        }
        let at = values.number("kick_time").unwrap_or(0.0);
        if values.state_map("kick").is_some_and(|k| !k.is_empty()) && (at.is_nan() || at >= duration) {
            diagnostics.push(
                Diagnostic::error("transient.kick_time", format!("the kick at {at} s comes after the end at {duration} s"))
                    .at(values.span_of("kick_time")),
            );
        }
        let step = values.number("output_step");
        if let Some(step) = step
            && !(0.0..=1e6).contains(&(duration / step))
        {
            diagnostics.push(
                Diagnostic::error("transient.output_step", format!("{:.0} outputs are too many", duration / step))
                    .at(values.span_of("output_step"))
                    .help("at most 1000000 outputs"),
            );
        }
        if step.is_some() && values.written("points") {
            diagnostics.push(
                Diagnostic::error("transient.output_step", "both output_step and points are given")
                    .at(values.span_of("output_step"))
                    .help("say one or the other"),
            );
        }
        if !(duration > 0.0 && duration.is_finite()) {
            diagnostics.push(Diagnostic::error("transient.duration", "the duration must be positive").at(values.span_of("duration")));
        }
        let spectra = Spectra::read(values, system, (duration, speed.unwrap_or(1.0).abs()), diagnostics);
        if diagnostics.0.len() > before {
            return None;
        }
        Some(Transient {
            duration,
            speed: speed?,
            settings: Settings::read(values),
            step,
            initial,
            kick: (!kicks.is_empty()).then_some((at, change)),
            velocities: values.flag("velocities").unwrap_or(false),
            observables: values.flag("observables").unwrap_or(true),
            spectra,
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::one(self.speed)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let outputs = self.step.map_or(self.settings.points, |step| (self.duration / step) as usize);
        Some(history::size(system, outputs, self.velocities, self.observables))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.prepare(system, &Context::quiet(Self::KIND))
    }

    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        let Some(timed) = context.timed(system, speeds(system, self.speed))? else { return Ok(()) };
        let motion = Motion::new(&timed, Motion::law_of(&timed, self.speed, self.settings.phase))?;
        history::admit(&motion, self.settings.method)
    }

    fn report(&self, _: &System, result: &Outcome, _: &str) -> Result<Outcome, Diagnostic> {
        Ok(result.clone())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let s = &self.settings;
        let exact = system;
        let Some(timed) = context.timed(system, speeds(system, self.speed))? else {
            return Ok(Outcome::new(Self::KIND, context.name).end(End::Cancelled));
        };
        let system: &System = &timed;
        let mut motion = Motion::new(system, Motion::law_of(system, self.speed, s.phase))?;
        let no_account = history::keep_account(&mut motion);
        let mut y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
        let start = Start::new(system, self.speed);
        start.write(&start::renumbered(&self.initial, exact, system), &mut y);
        if let Some(k) = motion.spin_start() {
            (y[k], y[k + 1]) = (s.phase, self.speed);
        }
        history::announce(context, self.duration, self.speed);
        let requested: Vec<f64> = match self.step {
            Some(step) => {
                let count = (self.duration / step * (1.0 + 1e-12)) as usize;
                (0..=count).map(|i| (i as f64 * step).min(self.duration)).collect()
            }
            None => history::spaced(self.duration, s.points),
        };
        let turns = match motion.law() {
            SpinLaw::Programme(p) => Turns::beside(&requested, p.at(self.duration), p.largest_speed()),
            SpinLaw::Free => None,
        };
        let drawn = turns.as_ref().map_or_else(|| requested.clone(), |t| t.with_outputs(&requested));
        let outputs = self.spectra.as_ref().map_or_else(|| drawn.clone(), |s| s.with_outputs(&drawn));
        let plan = Plan {
            t_end: self.duration,
            choice: s.method,
            relative: s.relative,
            absolute: s.absolute,
            outputs: &outputs,
            windows: WINDOWS,
            rest: &start.rest,
            bound: history::bound(system, &start, &y),
            kick: self.kick.clone(),
            max_steps: context.work_limit,
            cancel: &|| context.cancelled(),
            progress: &history::progress(context, self.duration),
        };
        let mut trajectory = simulate(&mut motion, &y, &plan)?;
        let record = self.spectra.as_ref().map(|s| (s, s.taken(&motion, &start, &mut trajectory, &drawn)));
        let path = turns.map(|t| t.taken(&motion, &mut trajectory, &requested)).transpose()?.flatten();
        let trajectory = history::magnified(&mut motion, &y, &plan, trajectory, s.points)?;
        let (end, stopped) = history::ended(&trajectory);
        let mut outcome = Outcome::new(Self::KIND, context.name).over("t", "s").end(end);
        for finding in stopped.into_iter().chain(start.finding.clone()).chain(self.findings(&motion, &trajectory, &start)) {
            outcome = outcome.finding(finding);
        }
        outcome = moved_roots(exact, &timed, self.speed, context).into_iter().fold(outcome, Outcome::finding);
        let (mut outcome, balance) = history::accounted(&mut motion, &trajectory, no_account, outcome)?;
        if let Some((spectra, record)) = record {
            outcome = spectra.report(&record, outcome)?;
        }
        let (captured, point) = drive::findings(&motion, &trajectory);
        outcome = captured.into_iter().fold(outcome, Outcome::finding);
        outcome = point.into_iter().fold(outcome, Outcome::special_point);
        let listed = Listed { velocities: self.velocities, observables: self.observables, path, envelope: true };
        let outcome = history::shown(&mut motion, &trajectory, listed, balance, outcome)?;
        balance::report(&mut motion, &trajectory, outcome)
    }
}

impl Transient {
    fn findings(&self, motion: &Motion, trajectory: &Trajectory, start: &Start) -> Vec<Finding> {
        let system = motion.system();
        // a drive of its own starts slowly
        let fastest = motion.spin(trajectory.run.t, &trajectory.state).speed.abs().max(self.speed.abs());
        let turn = std::f64::consts::TAU / fastest;
        if let Some(finding) = history::unbounded(system, trajectory, turn) {
            return vec![finding];
        }
        let still = history::negligible(&self.settings, start);
        let [by, at] = history::end_in_words(trajectory);
        let mut out = Vec::new();
        // the body that moves most at the end speaks for the machine
        let last = |w: &[Window]| w.iter().rev().map(|w| w.peak.amplitude).find(|a| a.is_finite()).unwrap_or(0.0);
        let motions = history::probe_motions(system, trajectory, still);
        let of = |tilt: bool| motions.iter().filter(move |s| s.tilt == tilt && last(s.windows) > s.still);
        let most = |tilt: bool| of(tilt).max_by(|a, b| last(a.windows).total_cmp(&last(b.windows)));
        // a machine whose bodies stay in their places may tilt
        let loudest = most(false).or_else(|| most(true));
        let rate = loudest.and_then(|s| growth(s.windows, turn));
        let clear = |g: &Growth| g.rate.abs() > 3.0 * g.uncertainty;
        let grows = rate.as_ref().is_some_and(|g| clear(g) && g.rate > 0.0);
        for s in &motions {
            let finding = if grows && s.moves() && s.peak.t >= 0.9 * trajectory.run.t {
                let (id, what) = if s.tilt { ("largest_tilt", "tilt") } else { ("largest_displacement", "displacement") };
                let text = format!("The {what} of \"{}\" from rest reaches {{}} {by}, while the motion still grows.", s.body);
                Some(Finding::info(id, text).of(&s.body).value(s.peak.amplitude, s.unit))
            } else {
                s.largest()
            };
            out.extend(finding.map(|f| f.evidence("reached at", s.peak.t, "s")));
        }
        for b in system.bodies() {
            let (x, y) = (trajectory.state[b.x], trajectory.state[b.x + 1]);
            let away = (x - start.rest[b.x]).hypot(y - start.rest[b.x + 1]);
            if away <= still {
                continue;
            }
            let text = format!("{at} \"{}\" is {{}} from its place of rest.", b.name);
            let finding = Finding::info("end_state", text).of(&b.name).value(away, "m").evidence("x", x, "m").evidence("y", y, "m");
            out.push(finding.evidence("t", trajectory.run.t, "s"));
        }
        if system.machine.drive == Drive::Free {
            out.extend(drive::without_inertia(system, "The spin speed changes"));
            let speed = motion.spin(trajectory.run.t, &trajectory.state).speed;
            let text = format!("{at} the spin speed is {{}}.");
            out.push(Finding::info("end_speed", text).value(speed, "rad/s").evidence("change", speed - self.speed, "rad/s"));
        }
        let Some(loudest) = loudest else { return out };
        let Some(g) = rate else {
            let window = self.duration / WINDOWS as f64;
            let finding = if trajectory.run.t > SEVERAL * turn && window > 0.5 * turn && trajectory.run.t < SEVERAL * window {
                // the integration ended early in the duration: its envelope has hardly a value
                let text = "Whether the motion grows is not assessed: the largest displacements are kept per {} of the duration, several turns in one. Give a shorter duration.";
                Finding::info("no_growth_rate", text).value(window, "s")
            } else {
                let text = "The record is too short to say whether the motion grows: that takes several turns of the displacement.";
                Finding::info("no_growth_rate", text)
            };
            out.push(finding);
            return out;
        };
        let how = match (clear(&g), g.rate > 0.0) {
            (true, true) => "grows at",
            (true, false) => "decays at",
            _ => "neither grows nor decays clearly; the slope of its logarithm is",
        };
        let what = if loudest.tilt { "the tilt of " } else { "" };
        let text = format!("In the second half the envelope of {what}\"{}\" {how} {{}}.", loudest.body);
        let make = if grows { Finding::warning } else { Finding::info };
        out.push(
            make("growth_rate", text)
                .value(g.rate, "1/s")
                .evidence("uncertainty", g.uncertainty, "1/s")
                .evidence("mean turning rate of the displacement", g.frequency, "rad/s")
                .evidence("record starts at", g.from, "s"),
        );
        out
    }
}
