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
use super::history::{self, ABSOLUTE, METHOD, PHASE, POINTS, RELATIVE, Settings};
use super::moved_roots::moved_roots;
use super::record::{Beside, Capture, MotionRecord, MotionState};
use super::spectra::{self, Spectra};
use super::start::{self, Entry, INITIAL, Start};
use super::turns::Turns;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::{Drive, System};
use crate::model::timed::Speeds;
use crate::outcome::{Arg, End, Finding, Outcome};
use crate::solve::motion::envelope::{Course, Growth, Window, growth};
use crate::solve::motion::trajectory::{Plan, simulate};
use crate::solve::motion::{Motion, SpinLaw};
use crate::solve::reduced_machine::ReducedMachine;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::{Context, Study};
use crate::text;
use serde::{Deserialize, Serialize};

/// Speeds of a motion that starts at this one.
fn speeds(system: &System, speed: f64) -> Speeds {
    if system.machine.drive == Drive::Free { Speeds::Changing } else { Speeds::One(speed) }
}

/// Windows of the envelope.
const WINDOWS: usize = 200;
/// Turns from which a record is long, and windows below which its envelope has too few values.
const SEVERAL: f64 = 8.0;

/// See the [module](self).
#[derive(Clone, Debug)]
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
    /// A state the motion starts from, in place of `initial`.
    from: Option<MotionState>,
}

/// A motion in time.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct TransientResult {
    /// The motion, with its state at the end.
    pub motion: MotionRecord,
    /// Where a free spin was caught by a vibration.
    pub capture: Option<Capture>,
    /// How the study ended.
    pub end: End,
}

impl Study for Transient {
    type Result = TransientResult;
    const KIND: &'static str = "transient";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
duration = "2 s"
kick = { "drum.x'" = "20 mm/s" }
"#;
    const DOC: &'static str = "Motion in time from a given start at constant speed, or with the spin free to move by itself when the machine's drive \
        is free. Reports the motion, the energy balance, the largest displacements and whether the motion grows. A spatial \
        liquid is a sum over waves in time: its error is stated, and how far it moves the roots; so is a viscous liquid at constant speed.";
    const SEVERAL_SPINS: bool = true;
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
                Diagnostic::error("study.speed", text!("neither the study nor the machine says the spin speed"))
                    .at(values.span.clone())
                    .help(text!("add speed = \"3000 rpm\" to [machine] or to the study")),
            );
        }
        let initial = start::state_map(values, "initial", system, diagnostics);
        let mut change = vec![0.0; system.n()];
        let kicks = start::state_map(values, "kick", system, diagnostics);
        for &(e, x) in &kicks {
            match e {
                Entry::Rate(i) => change[i] = x,
                _ => diagnostics.push(
                    Diagnostic::error("transient.kick", text!("a kick changes rates only"))
                        .at(values.span_of("kick"))
                        .help(text!("name rates with ', such as \"drum.x'\"")),
                ),
            }
        }
        let at = values.number("kick_time").unwrap_or(0.0);
        if values.state_map("kick").is_some_and(|k| !k.is_empty()) && (at.is_nan() || at >= duration) {
            diagnostics.push(
                Diagnostic::error(
                    "transient.kick_time",
                    text!(
                        "the kick at {at} comes after the end at {duration}",
                        at = text::quantity(at, "s"),
                        duration = text::quantity(duration, "s")
                    ),
                )
                .at(values.span_of("kick_time")),
            );
        }
        let step = values.number("output_step");
        if let Some(step) = step
            && !(0.0..=1e6).contains(&(duration / step))
        {
            diagnostics.push(
                Diagnostic::error(
                    "transient.output_step",
                    text!("{step} outputs are too many", step = format_args!("{:.0}", duration / step)),
                )
                .at(values.span_of("output_step"))
                .help(text!("at most 1000000 outputs")),
            );
        }
        if step.is_some() && values.written("points") {
            diagnostics.push(
                Diagnostic::error("transient.output_step", text!("both output_step and points are given"))
                    .at(values.span_of("output_step"))
                    .help(text!("say one or the other")),
            );
        }
        if !(duration > 0.0 && duration.is_finite()) {
            diagnostics
                .push(Diagnostic::error("transient.duration", text!("the duration must be positive")).at(values.span_of("duration")));
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
            from: None,
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
        let reduced = self.reduced(&timed);
        let system: &System = reduced.as_ref().map_or(&timed, |r| &r.system);
        let motion = Motion::new(system, self.law(system))?;
        history::admit(&motion, self.settings.method)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<TransientResult, Diagnostic> {
        let s = &self.settings;
        let exact = system;
        let timed = context.timed(system, speeds(system, self.speed))?.ok_or_else(history::stopped)?;
        let reduced = self.reduced(&timed);
        let system: &System = reduced.as_ref().map_or(&timed, |r| &r.system);
        let mut motion = Motion::new(system, self.law(system))?;
        let no_account = motion.keep_account().err();
        let mut y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
        let entries = start::renumbered(&self.initial, exact, &timed);
        let start = Start::new(&timed, self.speed).on(reduced.as_ref(), &entries, &mut y);
        match &self.from {
            Some(state) => state.write(&motion, reduced.as_ref(), &mut y)?,
            None => {
                if let Some(k) = motion.spin_start() {
                    (y[k], y[k + 1]) = (s.phase, self.speed);
                }
            }
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
            kick: self.kick.clone().map(|(t, rates)| (t, reduced.as_ref().map_or(rates.clone(), |r| r.coordinates(&rates)))),
            max_steps: context.work_limit,
            cancel: &|| context.cancelled(),
            progress: &history::progress(context, self.duration),
        };
        let mut trajectory = simulate(&mut motion, &y, &plan)?;
        let spectra = self.spectra.as_ref().map_or_else(Vec::new, |s| s.taken(&motion, &start, &mut trajectory, &drawn));
        let last_turns = turns.and_then(|t| t.taken(&motion, &mut trajectory, &requested));
        let trajectory = history::magnified(&mut motion, &y, &plan, trajectory, s.points)?;
        let moved_roots = moved_roots(exact, &timed, self.speed, context);
        let beside = Beside {
            start: &start,
            velocities: self.velocities,
            observables: self.observables,
            no_account,
            last_turns,
            moved_roots,
            natural: spectra::natural(exact, &spectra),
            reduced: reduced.as_ref().map(|r| r.reduced),
            spectra,
        };
        let record = MotionRecord::of(&mut motion, &trajectory, beside);
        let end = history::end(&record);
        Ok(TransientResult { motion: record, capture: drive::capture(&motion, &trajectory), end })
    }

    fn report(&self, system: &System, result: &TransientResult, name: &str) -> Result<Outcome, Diagnostic> {
        let record = &result.motion;
        let mut outcome = Outcome::new(Self::KIND, name).over("t", "s").end(result.end);
        for finding in history::stop(record).into_iter().chain(start::undeflected(&record.undeflected)) {
            outcome = outcome.finding(finding);
        }
        let moved = record.moved_roots.as_ref().map(|m| m.finding());
        outcome = self.findings(system, record).into_iter().chain(moved).fold(outcome, Outcome::finding);
        outcome = history::common_findings(system, record, outcome);
        if let Some(spectra) = &self.spectra {
            outcome = spectra.report(record, outcome)?;
        }
        if let Some((finding, point)) = result.capture.map(|c| c.report()) {
            outcome = outcome.finding(finding).special_point(point);
        }
        let outcome = history::shown(system, record, Some(&self.law(system)), outcome)?;
        balance::report(system, record, outcome)
    }
}

impl Transient {
    /// A machine of many coordinates as one of few.
    fn reduced(&self, timed: &System) -> Option<ReducedMachine> {
        match self.law(timed) {
            SpinLaw::Programme(p) => history::reduced(timed, p),
            SpinLaw::Free => None,
        }
    }

    /// The same study from the state at the end of another motion of the machine, in place of `initial`, at its speed; time begins anew at 0.
    ///
    /// ```
    /// use laval::prelude::*;
    /// use serde_json::json;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let ground = || Link::Between(Attach::on("disc"), Attach::ground());
    /// let machine = Builder::new("Laval rotor")
    ///     .part("disc", Disc::planar(), DiscParams { eccentricity: 20e-6, ..DiscParams::new(3.0) })
    ///     .part("shaft", ShaftLumped::lateral(ground()), ShaftLumpedParams { stiffness: [3e5; 2], ..ShaftLumpedParams::new() })
    ///     .part("air", Damper::fixed(ground()), DamperParams::new([20.0; 2]))
    ///     .build()?;
    /// let study = |duration: f64| construct::<Transient>(&machine, &json!({ "speed": 250.0, "duration": duration }));
    /// let context = Context::quiet("motion");
    /// let whole = study(0.5)?.result(&machine, &context)?;
    /// let first = study(0.2)?.result(&machine, &context)?;
    /// let second = study(0.3)?.continued_from(&first.motion.end_state).result(&machine, &context)?;
    /// let [a, b] = [&whole, &second].map(|r| &r.motion.end_state);
    /// assert!((a.coordinates[0] - b.coordinates[0]).abs() < 1e-10);
    /// assert!((a.spin.phase - b.spin.phase).abs() < 1e-9);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn continued_from(&self, state: &MotionState) -> Transient {
        let settings = Settings { phase: state.spin.phase, ..self.settings.clone() };
        Transient { speed: state.spin.speed, settings, from: Some(state.clone()), ..self.clone() }
    }

    /// How the spin moves.
    fn law(&self, system: &System) -> SpinLaw {
        Motion::law_of(system, self.speed, self.settings.phase)
    }

    fn findings(&self, system: &System, record: &MotionRecord) -> Vec<Finding> {
        let last_state = &record.end_state;
        // a drive of its own starts slowly
        let fastest = last_state.spin.speed.abs().max(self.speed.abs());
        let turn = std::f64::consts::TAU / fastest;
        if let Some(left) = record.left {
            return vec![history::unbounded(system, left, &record.windows[left.body], turn, last_state.spin.speed)];
        }
        let still = history::negligible(&self.settings, &record.rest);
        let when = history::last_moment(record);
        let mut out = Vec::new();
        // the body that moves most at the end stands for the machine
        let last = |w: &[Window]| w.iter().rev().map(|w| w.peak.amplitude).find(|a| a.is_finite()).unwrap_or(0.0);
        let motions = history::probe_motions(system, record, still);
        let of = |tilt: bool| motions.iter().filter(move |s| s.tilt == tilt && last(s.windows) > s.still);
        let most = |tilt: bool| of(tilt).max_by(|a, b| last(a.windows).total_cmp(&last(b.windows)));
        // a machine whose bodies stay in their places may tilt
        let loudest = most(false).or_else(|| most(true));
        let rate = loudest.and_then(|s| growth(s.windows, turn));
        let clear = |g: &Growth| g.rate.abs() > 3.0 * g.uncertainty;
        let grows = rate.as_ref().is_some_and(|g| clear(g) && g.rate > 0.0);
        for s in &motions {
            let finding = if grows && s.moves() && s.peak.t >= 0.9 * record.run.t {
                let finding = Finding::info(s.id(), "transient-still-growing").of(&s.body).value(s.peak.amplitude, s.unit);
                Some(finding.arg("quality", s.quality()).arg("body", Arg::name(&s.body)).arg("when", when.clone()))
            } else {
                s.largest()
            };
            out.extend(finding.map(|f| f.evidence("reached at", s.peak.t, "s")));
        }
        for b in system.stations() {
            let ([x, y], rest) = (b.lateral.of(&last_state.coordinates), b.lateral.of(&record.rest));
            let away = (x - rest[0]).hypot(y - rest[1]);
            if away <= still {
                continue;
            }
            let finding = Finding::info("end_state", "transient-end-state").of(&b.name).value(away, "m");
            let finding = finding.arg("body", Arg::name(&b.name)).arg("when", when.clone()).evidence("x", x, "m").evidence("y", y, "m");
            out.push(finding.evidence("t", record.run.t, "s"));
        }
        if system.machine.drive == Drive::Free {
            out.extend(drive::spin_inertia(system));
            let speed = last_state.spin.speed;
            let finding = Finding::info("end_speed", "transient-end-speed").value(speed, "rad/s").arg("when", when);
            out.push(finding.evidence("change", speed - self.speed, "rad/s"));
        }
        let Some(loudest) = loudest else { return out };
        let Some(g) = rate else {
            let window = self.duration / WINDOWS as f64;
            let finding = if record.run.t > SEVERAL * turn && window > 0.5 * turn && record.run.t < SEVERAL * window {
                // the integration ended early in the duration: its envelope has hardly a value
                Finding::info("no_growth_rate", "transient-windows-too-long").value(window, "s")
            } else {
                Finding::info("no_growth_rate", "transient-too-short")
            };
            out.push(finding);
            return out;
        };
        let make = if grows { Finding::warning } else { Finding::info };
        let finding = match g.course {
            Course::Straight { slope, uncertainty } if clear(&g) => {
                let unit = history::per_second(loudest.unit);
                let key = if slope > 0.0 { "transient-grows-linearly" } else { "transient-decreases-linearly" };
                make("no_growth_rate", key).value(slope, &unit).evidence("uncertainty", uncertainty, &unit)
            }
            Course::Falling { first, second } if clear(&g) => {
                let finding = make("no_growth_rate", "transient-grows-ever-more-slowly").value(second, "1/s");
                finding.arg("first", Arg::quantity(first, "1/s")).evidence("relative rate before", first, "1/s")
            }
            _ => {
                let key = match (clear(&g), g.rate > 0.0) {
                    (true, true) => "transient-grows",
                    (true, false) => "transient-decays",
                    _ => "transient-steady",
                };
                let finding = make("growth_rate", key).value(g.rate, "1/s").arg("uncertainty", Arg::quantity(g.uncertainty, "1/s"));
                finding.evidence("uncertainty", g.uncertainty, "1/s")
            }
        };
        let finding = finding.arg("body", loudest.arg());
        out.push(finding.evidence("mean turning rate of the displacement", g.frequency, "rad/s").evidence("record starts at", g.from, "s"));
        out
    }
}
