//! What the linear studies share: where to linearise, how to say it, columns and sentences.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, MOST_POINTS, RangeValue, Values, Word};
use crate::model::part::{At, Frozen};
use crate::model::probe::Probe;
use crate::model::station::at_height;
use crate::model::system::{Slot, System, Workspace};
use crate::outcome::{Arg, Finding, Level, Message, OutcomeError};
use crate::solve::characteristic::{Equilibrium, coordinate_sectors};
use crate::solve::pencil::{MachineMode, Spectrum, time_forms};
use crate::solve::roots::transcendental;
use crate::solve::{co_rotating, rest};
use crate::text;
use crate::text::Text;
use serde::{Deserialize, Serialize};

/// Bounds of a spin speed, rad/s. Coefficients of bearings are given for one sense of turning, that of the axes: a machine that turns the other way is
/// described by its mirror image.
pub const SPEED: FieldKind = FieldKind::Quantity { unit: "rad/s", bounds: Bounds::up_to(1e6) };
/// A range of spin speeds; bounds as [`SPEED`].
pub const SPEED_RANGE: FieldKind = FieldKind::Range { unit: "rad/s", bounds: Bounds::up_to(1e6) };

/// Share of the largest eigenvalue, or of the largest amplitude, that a number must exceed to be more than rounding.
pub const ROUNDING: f64 = 1e-13;

/// What a probe measures, in words: the body, a point of it, or its tilt.
pub fn probe_name(probe: &Probe) -> String {
    match probe.height() {
        Some(z) => at_height(&probe.name, z, probe.digits),
        None if probe.is_tilt() => format!("tilt of {}", probe.name),
        None => probe.name.clone(),
    }
}

/// Relative difference of speeds that read alike in four digits.
const ALIKE: f64 = 1e-3;

/// A range of speeds in rad/s, or the one speed that it is in four digits, as a phrase: "from .. to ..", "at ..".
pub fn place(from: f64, to: f64) -> Message {
    match (to - from).abs() <= ALIKE * from.abs().max(to.abs()) {
        true => Message::new("at").arg("at", Arg::speed(from)),
        false => Message::new("range").arg("from", Arg::speed(from)).arg("to", Arg::speed(to)),
    }
}

/// Of two numbers the larger; NaN, which `f64::max` drops, stays.
pub fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// The largest of numbers above zero; NaN stays.
pub fn largest(x: impl IntoIterator<Item = f64>) -> f64 {
    x.into_iter().fold(0.0, larger)
}

/// First and last index of every run of `true`.
pub fn runs(flags: impl IntoIterator<Item = bool>) -> Vec<(usize, usize)> {
    let mut out: Vec<(usize, usize)> = Vec::new();
    for (i, _) in flags.into_iter().enumerate().filter(|f| f.1) {
        match out.last_mut() {
            Some(last) if last.1 + 1 == i => last.1 = i,
            _ => out.push((i, i)),
        }
    }
    out
}

/// Growth that is rounding beside the largest eigenvalue, 1/s.
pub fn growth_rounding(spectrum: &Spectrum) -> f64 {
    ROUNDING * spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max)
}

/// What the growth rate of a mode may be off by, 1/s: its own error, or that `rounding`. A mode grows by more, or it is neutral.
pub fn growth_error(m: &MachineMode, rounding: f64) -> f64 {
    rounding.max(if m.error.is_nan() { 0.0 } else { m.error })
}

/// `x`, or zero where it does not stand out from rounding beside a number of that `size`.
pub fn beyond_rounding(x: f64, size: f64) -> f64 {
    if x.abs() <= ROUNDING * size { 0.0 } else { x }
}

const ABOUT_WORDS: &[Word] = &[
    ("rest", "the static equilibrium, seen in fixed axes"),
    ("turning", "the state that turns with the rotor, seen in axes that turn with it (frequencies are counted from the spin)"),
];
/// Field: the state the machine is linearised about.
pub const ABOUT: Field = Field::optional("about", FieldKind::Choice(ABOUT_WORDS), "rest", "state the machine is linearised about");

/// The state the machine is linearised about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// Static equilibrium.
    Rest,
    /// State that turns with the rotor.
    Turning,
}

impl About {
    /// From the field [`ABOUT`].
    pub fn read(values: &Values) -> Self {
        if values.choice("about") == Some("turning") { About::Turning } else { About::Rest }
    }
    /// The word in the file.
    pub fn word(self) -> &'static str {
        match self {
            About::Rest => "rest",
            About::Turning => "turning",
        }
    }
    /// Finds it at a speed; a turning state from the one before, when there is one.
    ///
    /// # Errors
    /// As [`rest::rest`] and [`co_rotating::turning`].
    pub fn find(self, system: &System, speed: f64, before: Option<&Equilibrium>) -> Result<Equilibrium, Diagnostic> {
        match self {
            About::Rest => rest::rest(system, speed),
            About::Turning => co_rotating::turning(system, speed, before.cloned()),
        }
    }
    /// Finds it at one speed after another, each by itself.
    pub fn over_speed(self, system: &System) -> Box<dyn Fn(f64) -> Result<Equilibrium, Diagnostic> + Sync + '_> {
        match self {
            About::Rest => Box::new(rest::over_speed(system)),
            About::Turning => Box::new(|w| co_rotating::turning(system, w, None)),
        }
    }
}

/// No part has a preferred direction, so that states may exist that turn with the rotor.
pub fn turns_alike(system: &System) -> bool {
    co_rotating::isotropic(system, system.machine.speed.unwrap_or_default()).is_ok()
}

/// Eigenvalues can be had: there is a state to linearise about, and every part has a form with finitely many of them.
///
/// # Errors
/// As [`About::find`] and [`time_forms`].
pub fn admit_eigenvalues(system: &System, about: About, speed: f64) -> Result<(), Diagnostic> {
    if about == About::Rest || system.over_frequency().next().is_none() {
        about.find(system, speed, None)?;
    }
    // coefficients over the frequency of vibration are held at some frequency
    match held(system, Frozen::At(0.0))? {
        Some(_) if about == About::Turning => {
            Err(Diagnostic::error("modes.frequency_only", text!("a part without time form is linearised about rest only"))
                .help(text!("leave about out")))
        }
        Some(held) => time_forms(&held).map(drop),
        None => time_forms(system).map(drop),
    }
}

/// The machine with the coefficients of one frequency of vibration; none of a machine whose parts have no tables over it.
///
/// # Errors
/// As [`System::assemble`].
pub fn held(system: &System, at: Frozen) -> Result<Option<System>, Diagnostic> {
    system.frozen(at).transpose().map_err(Diagnostics::into_error)
}

/// Roots can be had: as [`admit_eigenvalues`], or, for a machine with parts that have no time form, in a region about rest.
///
/// # Errors
/// As [`About::find`]; a part without time form in a state that turns.
pub fn admit_roots(system: &System, about: About, speed: f64) -> Result<(), Diagnostic> {
    if about == About::Rest && transcendental(system) && system.undeclared().is_none() {
        return about.find(system, speed, None).map(drop);
    }
    admit_eigenvalues(system, about, speed)
}

/// What it is beside which roots are counted only where they grow.
pub fn decay_uncounted(system: &System, speed: f64) -> Option<&'static str> {
    let domains = if transcendental(system) { system.domains(speed) } else { Vec::new() };
    domains.iter().find(|d| !d.left).map(|d| d.words.name)
}

/// A threshold of growth from which on roots are counted.
///
/// # Errors
/// One below 0 where roots that decay are not counted.
pub fn admit_threshold(system: &System, speed: f64, threshold: f64) -> Result<(), Diagnostic> {
    match decay_uncounted(system, speed) {
        Some(name) if threshold < 0.0 => Err(Diagnostic::error(
            "study.growth_threshold",
            text!("with {name} roots are counted where they grow: whether one decays more slowly than at a growth_threshold below 0 is not known", name = text::term(name)),
        )
        .help(text!("give a growth_threshold of 0 or more; a transient shows how fast a motion dies out"))),
        _ => Ok(()),
    }
}

/// The spin speed: the field `speed`, or the machine's own.
pub fn speed(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<f64> {
    let found = values.number("speed").or(system.machine.speed);
    if found.is_none() {
        diagnostics.push(
            Diagnostic::error("study.speed", text!("this study needs a spin speed"))
                .at(values.span_of("speed"))
                .help(text!("give speed = \"3000 rpm\" here, or once for all studies in [machine]")),
        );
    }
    found
}

/// Speeds at which roots are counted that are worth a word beforehand: one may take seconds.
pub const COUNTS: f64 = 20.0;

/// How to mend a range whose ends do not rise.
pub fn apart(from: f64, to: f64) -> Text {
    if from == to { text!("give two values that differ") } else { text!("exchange from and to") }
}

/// A single value, or a [`range`].
pub fn one_or_range(field: &str, given: RangeValue, least: usize, values: &Values, diagnostics: &mut Diagnostics) -> Option<RangeValue> {
    if given.is_one() { Some(given) } else { range(field, given, least, values, diagnostics) }
}

/// A range whose ends differ and whose number of points is at least `least`, and not beyond what memory can keep.
pub fn range(field: &str, given: RangeValue, least: usize, values: &Values, diagnostics: &mut Diagnostics) -> Option<RangeValue> {
    let speeds: fn(Text) -> Text = |help| text!("{help}; modes, forced_response, stability_map and transient take one speed", help);
    range_or(field, (given, if field == "speed" { speeds } else { |help| help }), least, values, diagnostics)
}

/// Least width of a range, relative to its larger end: steps inside a narrower one are lost in the rounding of its values.
pub(in crate::study) const NARROWEST: f64 = 1e-9;

/// The same; what is added to the help where it is one value: which study answers then.
pub fn range_or(
    field: &str,
    (range, one): (RangeValue, fn(Text) -> Text),
    least: usize,
    values: &Values,
    diagnostics: &mut Diagnostics,
) -> Option<RangeValue> {
    let wrong = if range.is_one() {
        let message = text!("{field} is one value, and this study needs a range", field);
        Some((message, one(text!("write {field} = {{ from = .., to = .. }}", field))))
    } else if range.to <= range.from || range.to.is_nan() || range.from.is_nan() {
        Some((text!("{field} must go from a lower to a higher value", field), apart(range.from, range.to)))
    } else if range.to - range.from <= NARROWEST * range.to.abs().max(range.from.abs()) {
        let help = one(text!("{field} needs ends farther apart", field));
        Some((text!("{field} is too narrow: its ends differ by less than a billionth", field), help))
    } else if range.points.is_some_and(|p| p < least) {
        Some((text!("{field} needs at least {least} points", field, least), text!("leave points out for a fitting number")))
    } else {
        let many = range.points.filter(|&p| p > MOST_POINTS);
        many.map(|p| {
            (
                text!("{field} requires {points} points, which are too many", field, points = p),
                text!("at most {most} points", most = MOST_POINTS),
            )
        })
    };
    match wrong {
        Some((message, help)) => {
            diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of(field)).help(help));
            None
        }
        None => Some(range),
    }
}

/// The states a study over a range of speeds is linearised about at both ends of the range.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct EndStates {
    /// At the first speed.
    pub first: Equilibrium,
    /// At the last speed; none where the machine has no such state there.
    pub last: Option<Equilibrium>,
}

impl EndStates {
    /// Finds them.
    ///
    /// # Errors
    /// No state at the first speed.
    pub fn find(state: impl Fn(f64) -> Result<Equilibrium, Diagnostic>, from: f64, to: f64) -> Result<Self, Diagnostic> {
        Ok(EndStates { first: state(from)?, last: state(to).ok() })
    }

    /// The remarks of a study over the range. Models are left at either end.
    pub fn remarks(&self, system: &System) -> Vec<Finding> {
        let mut out = remarks(system, &self.first);
        let known: Vec<String> = out.iter().filter(|f| f.level == Level::Invalid).map(|f| f.subject.clone()).collect();
        // a state that is not to be had there is said by the study itself
        out.extend(self.last.iter().flat_map(|last| outside(system, last)).filter(|f| !known.contains(&f.subject)));
        out
    }
}

/// The remarks every linear study owes: nonlinear parts enter by their tangent, fits by their error, weight by the equilibrium.
pub fn remarks(system: &System, about: &Equilibrium) -> Vec<Finding> {
    let mut out = Vec::new();
    let names: Vec<&str> = system.slots().iter().filter(|s| !s.is_linear()).map(|s| s.name.as_str()).collect();
    if !names.is_empty() {
        let largest = system.coordinates().iter().zip(&about.q).map(|(c, q)| (q / c.dof.typical).abs()).fold(0.0, f64::max);
        out.push(
            Finding::info("linearised", "support-linearised")
                .arg("n", Arg::count(names.len()))
                .arg("parts", Arg::names(names))
                .arg("state", Arg::word(if largest == 0.0 { "undeflected" } else { "deflected" }))
                .evidence("Newton steps to the state", about.iterations as f64, "")
                .evidence("last Newton step over typical size", about.last_step, ""),
        );
    }
    out.extend(open(system, about));
    out.extend(outside(system, about));
    for (name, error) in time_forms(system).unwrap_or_default() {
        let finding = Finding::info("fitted_part", "support-fitted-part").arg("part", Arg::name(name));
        out.push(finding.evidence("relative error of the fit", error, ""));
    }
    out
}

/// What a study of the state itself owes: gaps that are open, parts outside their model.
pub fn state_remarks(system: &System, about: &Equilibrium) -> Vec<Finding> {
    open(system, about).into_iter().chain(outside(system, about)).collect()
}

/// Parts with a gap that is open at the state: they add nothing until it closes.
fn open(system: &System, about: &Equilibrium) -> Vec<Finding> {
    let gap = |slot: &Slot| rest::clearance(system, slot, about).filter(|gap| *gap > 0.0);
    let one = |(slot, gap): (&Slot, f64)| {
        Finding::info("open_gap", "support-open-gap").of(&slot.name).arg("part", Arg::name(&slot.name)).value(gap, "m")
    };
    system.slots().iter().filter_map(|slot| Some((slot, gap(slot)?))).map(one).collect()
}

/// Parts that are outside the validity of their model at the state itself, before anything vibrates.
fn outside(system: &System, about: &Equilibrium) -> Vec<Finding> {
    let sectors = coordinate_sectors(system);
    let (v, a) = (about.velocity(&sectors), about.acceleration(&sectors));
    let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed: about.speed, spin_accel: 0.0, t: 0.0 };
    let uses = system.validity(&at, &mut Workspace::default());
    let mut out = Vec::new();
    for (slot, u) in uses.iter().filter(|(_, u)| !(u.ratio <= 1.0)) {
        let part = &system.slots()[*slot].name;
        let finding = if u.ratio.is_finite() {
            Finding::invalid("validity", "support-outside").value(u.ratio, "")
        } else {
            Finding::invalid("validity", "support-outside-unbounded")
        };
        let finding = finding.of(part).arg("part", Arg::name(part)).arg("speed", Arg::speed(about.speed));
        out.push(finding.arg("what", Arg::term(u.what)));
    }
    out
}

/// An outcome that contradicts itself, as a diagnostic.
pub fn inconsistent(e: OutcomeError) -> Diagnostic {
    e.into()
}

/// Frequency in rad/s and Hz for a sentence.
pub fn hertz(w: f64) -> f64 {
    w / std::f64::consts::TAU
}

/// From rad/s to rpm.
pub const RPM: f64 = 30.0 / std::f64::consts::PI;
