//! Linear response to unbalance over the spin speed: orbits, phases and forces of all bodies, resonances and antiresonances.
//!
//! Equations: `T(i W, W) X = F` with the forces that turn with the rotor; frequency-domain parts and memory states enter exactly. The motion of a
//! point is `x + i y = f exp(i phase) + b exp(-i phase)`; its orbit has the semi-axes `|f| + |b|` and `||f| - |b||`, the longer at the angle `(arg f + arg b)/2` from x.
//!
//! Symbols: W spin speed, rad/s; X complex amplitudes; f, b forward and backward amplitude, m.
//!
//! Validity: motions small enough for the tangent of nonlinear parts at rest; constant speed.
//!
//! Sources: `docs/theory/linear-vibration.md#unbalance-response`.

mod beside;
mod limits;
mod linearised;
pub(in crate::study::linear) mod observed;
mod orbits;
mod polar;
mod report;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values};
use crate::model::part::Frozen;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{End, Kept, Outcome};
use crate::solve::characteristic::Characteristic;
use crate::solve::extrema::{Curve, Extremum, curve, seeds};
use crate::solve::extremum::Search;
use crate::solve::linear_response::{Response, response};
use crate::solve::locate::State;
use crate::solve::pencil::time_forms;
use crate::solve::rest::{over_speed, rest};
use crate::solve::sweep::{Strongest, spectrum};
use crate::study::linear::over_frequency::growth_unassessed;
use crate::study::shared::half_power::{at_most, ends, factor, of_responses};
use crate::study::shared::journals::{JournalVibration, journals, vibrations};
use crate::study::shared::margins::{CRITICALLY_DAMPED, STANDARD, Speeds};
use crate::study::shared::operation;
use crate::study::shared::size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{EndStates, SPEED_RANGE, held, one_or_range};
use crate::study::shared::vibration::Vibration;
use crate::study::{Context, Study};
use crate::text;
use laval_num::order::SortByNumber;
use observed::observed;
pub use observed::{LINEARISED, Observations, Outside, Shows};
pub use orbits::{AtSpeed, Gap, Orbits, Reason};
use serde::{Deserialize, Serialize};

/// See the [module](self).
#[derive(Clone)]
pub struct ForcedResponse {
    /// Speeds, rad/s.
    pub speed: RangeValue,
    /// Separation margins of API 684 are assessed.
    pub margins: bool,
    /// The spin whose unbalance acts, and that speeds are those of; the machine's where there is none.
    pub spin: Option<String>,
}

/// Speeds of a range, unless given.
const POINTS: usize = 400;

impl Study for ForcedResponse {
    type Result = ForcedResponseResult;
    const KIND: &'static str = "forced_response";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm", points = 400 }
"#;
    const DOC: &'static str = "Linear unbalance response over the spin speed: amplitude and phase of every body, at its reference point and \
        wherever something is attached to it, of its tilt; forces and moments of linear parts and linearised forces of nonlinear ones, with resonances and antiresonances located; \
        orbits and deflected shapes at the operating speed and at the largest resonances. \
        Nonlinear parts enter by their tangent at rest; nonlinear_response keeps them whole.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "one spin speed, or a range: points (400 unless given) are added where the response bends"),
        STANDARD,
        Field::optional(
            "spin",
            FieldKind::Text,
            "",
            "of a machine of several spins: the part of kind \"speed_ratio\" whose unbalance acts; speeds are then those of this spin. Without it, the unbalance of what turns at the speed of the machine acts",
        ),
    ];
    const SEVERAL_SPINS: bool = true;

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = one_or_range("speed", values.range("speed")?, 3, values, diagnostics)?;
        if system.stations().is_empty() {
            diagnostics.push(Diagnostic::error("forced_response.no_body", text!("no body of this machine moves across the axis")));
            return None;
        }
        let margins = values.choice("standard") == Some("api_684");
        if margins && Speeds::of(system).is_none() {
            diagnostics.push(
                Diagnostic::error("forced_response.standard", text!("separation margins need an operating speed"))
                    .at(values.span_of("standard"))
                    .help(text!("give speed in [machine], or the range of operating speeds in [operation]")),
            );
            return None;
        }
        let spin = values.text("spin").map(str::to_string);
        let mut speed = speed;
        if let Some(name) = &spin {
            match system.at_spin(name) {
                Ok(_) if margins => {
                    diagnostics.push(
                        Diagnostic::error("forced_response.standard", text!("separation margins are those of the speed of the machine"))
                            .at(values.span_of("standard"))
                            .help(text!("leave standard out, or spin")),
                    );
                    return None;
                }
                Ok(_) => {
                    // a spin that turns the other way has negative speeds
                    if ratio(system, name).is_some_and(|r| r < 0.0) {
                        (speed.from, speed.to) = (-speed.to, -speed.from);
                    }
                }
                Err(found) => {
                    diagnostics.0.extend(found.0.into_iter().map(|d| d.at(values.span_of("spin"))));
                    return None;
                }
            }
        }
        Some(ForcedResponse { speed, margins, spin })
    }

    fn spin_speeds(&self, system: &System) -> Vec<SpinSpeeds> {
        let ratio = self.spin.as_ref().and_then(|name| ratio(system, name)).unwrap_or(1.0);
        vec![SpinSpeeds::between(self.speed.from / ratio, self.speed.to / ratio)]
    }

    fn vibration(&self, system: &System) -> Vibration {
        // of the spin whose unbalance acts
        Vibration::Orders(vec![self.spin.as_ref().and_then(|name| ratio(system, name)).unwrap_or(1.0)])
    }

    fn size(&self, system: &System) -> Option<size::Size> {
        let speeds = self.speed.points.unwrap_or(POINTS);
        let kept = 4.0 * (system.n() + system.m()) as f64;
        let listed = (7 * system.stations().len() + 3 * system.slots().len()) as f64;
        Some(size::Size {
            bytes: speeds as f64 * (size::KEPT * kept + size::LISTED * listed),
            of: text!("responses at {speeds} speeds of {n} coordinates", speeds, n = system.n()),
            fewer: text!("give the range fewer points: where the response bends it is refined without them"),
        })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        let turned = self.turned(system)?;
        let system = turned.as_ref().unwrap_or(system);
        let (_, load) = Characteristic::new(system, &rest(system, self.speed.to)?).loads();
        if load.iter().all(|f| f.abs() == 0.0) {
            return Err(Diagnostic::error("forced_response.no_unbalance", text!("nothing forces this machine at the spin speed"))
                .help(text!("give a disc an eccentricity, an unbalance or a skew")));
        }
        Ok(())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<ForcedResponseResult, Diagnostic> {
        self.admit(system)?;
        let turned = self.turned(system)?;
        // deflected under weight with coefficients at rest
        let still = turned.as_ref().unwrap_or(system);
        let state = over_speed(still);
        let own = held(still, Frozen::Order(1.0))?;
        let system = own.as_ref().unwrap_or(still);
        let mut speeds = self.speed.linspace(POINTS);
        context.announce(speeds.len() as f64, 10_000.0, text!("speeds to solve for, and more where the response bends"));
        let mut each = |done: u64| {
            context.progress.report(done, 0);
            context.goes_on(done)
        };
        // eigenvalues tell where a narrow resonance hides; a machine without time form has none to tell
        let known = time_forms(system).is_ok();
        let mut strongest = Vec::new();
        if known && self.speed.is_one() {
            strongest.extend(Strongest::of(self.speed.from, &spectrum(system, &state, self.speed.from)?.1));
        } else if known {
            let more = seeds(system, &state, self.speed.from, self.speed.to, &mut each)?;
            speeds.extend(more.speeds);
            strongest = more.strongest;
        }
        let found = curve(system, &state, speeds, system.probes(), &mut each)?;
        let observed = observed(system, &state, &found)?;
        let mut directions = [f64::NAN; 2];
        for (direction, tilt) in directions.iter_mut().zip([false, true]) {
            let Some(e) = largest(&found, system.probes(), tilt).filter(|e| !e.unbounded) else { continue };
            let there = response(system, &state, e.speed)?;
            *direction = there.map_or(f64::NAN, |r| r.direction_of(&system.probes()[e.probe]));
        }
        if own.is_some() {
            // modes have other coefficients than the response
            strongest.clear();
        }
        let (half_power, range_ends) = half_power(system, &state, &found);
        let orbits = orbits::orbits(self, system, &state, &found)?;
        let states = EndStates::find(state, self.speed.from, self.speed.to)?;
        let journals = self.journals(system, &found)?;
        let end = context.end(found.complete);
        Ok(ForcedResponseResult { curve: found, half_power, range_ends, strongest, observed, directions, orbits, states, journals, end })
    }

    fn report(&self, system: &System, result: &ForcedResponseResult, name: &str) -> Result<Outcome, Diagnostic> {
        let own = self.seen(system)?;
        let outcome = report::Shown::new(self, own.as_ref().unwrap_or(system), result).outcome(name)?;
        Ok(growth_unassessed(system).into_iter().fold(outcome, Outcome::finding))
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

impl ForcedResponse {
    /// Over these speeds, without a standard.
    pub fn over(speed: RangeValue) -> Self {
        ForcedResponse { speed, margins: false, spin: None }
    }
    /// Vibration of the shaft in its bearings, where `[operation]` names a standard and operating speeds are computed.
    fn journals(&self, system: &System, found: &Curve) -> Result<Vec<JournalVibration>, Diagnostic> {
        let standard = operation::among(&system.machine.extras).shaft_vibration;
        let Some((standard, speeds)) = standard.zip(Speeds::of(system)).filter(|_| self.spin.is_none()) else { return Ok(Vec::new()) };
        Ok(vibrations(&journals(system, speeds.high)?, found, standard, (speeds.low, speeds.high)))
    }
    /// The machine at the spin whose unbalance acts, where that is not its own.
    fn turned(&self, system: &System) -> Result<Option<System>, Diagnostic> {
        self.spin.as_ref().map(|name| system.at_spin(name).map_err(Diagnostics::into_error)).transpose()
    }
    /// The same with coefficients of the frequency of the unbalance.
    fn seen(&self, system: &System) -> Result<Option<System>, Diagnostic> {
        let turned = self.turned(system)?;
        let own = held(turned.as_ref().unwrap_or(system), Frozen::Order(1.0))?;
        Ok(own.or(turned))
    }
    /// Distance of the speeds required, rad/s; 0 of one speed.
    fn step(&self) -> f64 {
        let points = self.speed.points.unwrap_or(POINTS);
        (self.speed.to - self.speed.from) / (points.max(2) - 1) as f64
    }
}

/// The linear response to unbalance.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ForcedResponseResult {
    /// Amplitudes over the speed, their maxima and minima; probes in the order of the machine.
    pub curve: Curve,
    /// Of every extremum of the curve: speeds on both sides of a maximum at which the amplitude is 1/sqrt(2) of it; NaN where it does not fall so far.
    pub half_power: Vec<[f64; 2]>,
    /// The same of sides without such a speed: the end of the range up to which the amplitude stays above; NaN elsewhere.
    #[serde(default)]
    pub range_ends: Vec<[f64; 2]>,
    /// The mode that grows most at every speed of the search for resonances; none of a machine without time form.
    pub strongest: Vec<Strongest>,
    /// What the parts show.
    pub observed: Observations,
    /// Angle of the major axis of the orbit from x at the largest resonance of a displacement, and of a tilt, rad; NaN where there is none.
    pub directions: [f64; 2],
    /// Motions at the operating speed and at resonances.
    pub orbits: Orbits,
    /// States at the ends of the range.
    pub states: EndStates,
    /// Vibration of the shaft in its bearings over the operating speeds, where a standard is to be kept.
    #[serde(default)]
    pub journals: Vec<JournalVibration>,
    /// How the study ended.
    pub end: End,
}

impl ForcedResponseResult {
    /// Amplification factor of an extremum by its index, and what it is at most where it is not known; infinite without damping.
    fn amplification(&self, index: usize) -> (f64, f64) {
        let of = |all: &[[f64; 2]]| all.get(index).copied().unwrap_or([f64::NAN; 2]);
        let Some(e) = self.curve.extrema.get(index).filter(|e| e.maximum) else { return (f64::NAN, f64::NAN) };
        if e.unbounded {
            return (f64::INFINITY, f64::NAN);
        }
        (factor(e.speed, of(&self.half_power)), at_most(e.speed, of(&self.half_power), of(&self.range_ends)))
    }

    /// Speeds of the maxima of displacements, and whether each is critically damped.
    pub fn damped_peaks(&self, probes: &[Probe]) -> Vec<(f64, bool)> {
        let moves = |e: &Extremum| e.maximum && probes.get(e.probe).is_some_and(|p| !p.is_tilt());
        let damped = |k: usize| {
            let (factor, at_most) = self.amplification(k);
            factor < CRITICALLY_DAMPED || factor.is_nan() && at_most < CRITICALLY_DAMPED
        };
        self.curve.extrema.iter().enumerate().filter(|(_, e)| moves(e)).map(|(k, e)| (e.speed, damped(k))).collect()
    }
}

/// Ratio of a spin to that of the machine.
fn ratio(system: &System, name: &str) -> Option<f64> {
    system.spins().into_iter().find(|s| s.name.as_deref() == Some(name)).map(|s| s.ratio)
}

/// Half-power points of the maxima of a curve, and ends of the range before them.
fn half_power(system: &System, state: State, found: &Curve) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let gaps: Vec<f64> = found.poles().into_iter().chain(found.unknown.iter().copied()).collect();
    let computed = |w: f64| response(system, state, w).ok().flatten();
    let mut search = Search::new(&computed);
    let mut one = |e: &Extremum| {
        if !e.maximum || e.unbounded || !e.value.is_finite() {
            return ([f64::NAN; 2], [f64::NAN; 2]);
        }
        let (peak, probe) = ((e.speed, e.value), &system.probes()[e.probe]);
        let sides = of_responses(peak, &found.points, probe, &mut search);
        (sides, ends(peak, sides, &found.points, &gaps, probe, &mut search))
    };
    found.extrema.iter().map(&mut one).unzip()
}

/// The largest resonance of a displacement, or of a tilt.
fn largest<'c>(found: &'c Curve, probes: &[Probe], tilt: bool) -> Option<&'c Extremum> {
    let mut peaks: Vec<&Extremum> = found.extrema.iter().filter(|e| e.maximum).collect();
    peaks.sort_by_number_down(|a| a.value);
    peaks.into_iter().find(|e| probes[e.probe].is_tilt() == tilt)
}

/// Response at one speed, for callers that want no table.
///
/// # Errors
/// As [`rest`].
pub fn at_speed(system: &System, speed: f64) -> Result<Option<Response>, Diagnostic> {
    response(system, &|w| rest(system, w), speed)
}
