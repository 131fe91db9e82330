//! Linear response to a harmonic force at a point: of an order of the spin speed, or over a range of frequencies at one speed.
//!
//! Equations: `T(i w, W) X = b F`; motion `Re(X exp(i w t))`. Amplification factor of a peak at Nc: `Nc/(N2 - N1)`, its half-power points N1 and N2.
//!
//! Symbols: W spin speed, w frequency of the force, rad/s; F amplitude, N; b displacement of the point; X complex amplitudes.
//!
//! Validity: motions small enough for the tangent of nonlinear parts at rest; constant speed; the steady response of a stable machine.
//!
//! Theory: `docs/theory/linear-vibration.md#unbalance-response`.
//!
//! Sources: as for the unbalance response; amplification factor of API 684, SP6.8.2.1.

mod report;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Attach, Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::part::Frozen;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{End, Kept, Outcome};
use crate::solve::criticals::criticals;
use crate::solve::extrema::above;
use crate::solve::extremum::{BESIDE, Search};
use crate::solve::harmonic_force::{Direction, Forced};
use crate::solve::linear_response::Response;
use crate::solve::own_frequency;
use crate::solve::pencil::time_forms;
use crate::solve::rest::{over_speed, rest};
use crate::solve::sweep::{Strongest, spectrum, sweep};
use crate::study::linear::forced_response::observed::{Assessed, Closed, Outside};
use crate::study::linear::over_frequency::{growth_unassessed, over_frequency};
use crate::study::shared::half_power::{ends, of_responses};
use crate::study::shared::margins::{STANDARD, Speeds};
use crate::study::shared::place;
use crate::study::shared::size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{EndStates, SPEED_RANGE, held, one_or_range, range};
use crate::study::shared::vibration::Vibration;
use crate::study::{Context, Study};
use crate::text;
use laval_num::order::ascending;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// What varies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Over {
    /// The spin speed; the frequency is so many times that.
    Speed(RangeValue, f64),
    /// The frequency, at one spin speed.
    Frequency(RangeValue, f64),
}

/// See the [module](self).
#[derive(Clone)]
pub struct HarmonicForce {
    /// Where the force acts.
    pub place: Attach,
    /// Amplitude, N.
    pub force: f64,
    /// How it moves.
    pub direction: Direction,
    /// Over what.
    pub over: Over,
    /// Separation margins of API 684 are assessed.
    pub margins: bool,
}

/// Values of a range, unless given.
const POINTS: usize = 400;
/// Amplification beyond which nothing damps.
pub(super) const UNBOUNDED: f64 = 1e8;
/// Distances from a mode, over its growth rate, at which the response is computed.
const WIDTHS: [f64; 12] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 16.0];
/// Responses that are computed at once.
const AT_ONCE: usize = 32;

impl Study for HarmonicForce {
    type Result = HarmonicForceResult;
    const KIND: &'static str = "harmonic_force";
    const EXAMPLE: &'static str = r#"place = "drum"
force = "10 N"
direction = "x"
speed = "3000 rpm"
frequency = { from = "5 Hz", to = "200 Hz" }
"#;
    const DOC: &'static str = "Linear response to a harmonic force at a point of the machine, along x or y or turning with or against the rotor: of an order of the spin speed over a range of \
        speeds, or over a range of frequencies at one speed. Peaks are located, with their factors of amplification by the half-power points; unbalance is left out.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required("place", FieldKind::Attach { ground: false }, "point of a body on which the force acts"),
        Field::optional("force", FieldKind::Quantity { unit: "N", bounds: Bounds::positive(1e12) }, "1 N", "amplitude of the force"),
        Field::optional(
            "direction",
            FieldKind::Choice(&[
                ("x", "along x"),
                ("y", "along y"),
                ("forward", "turning with the rotor"),
                ("backward", "turning against the rotor"),
            ]),
            "x",
            "how the force moves",
        ),
        Field::required("speed", SPEED_RANGE, "spin speeds, 400 points unless given; with frequency one speed"),
        Field::optional(
            "order",
            FieldKind::Quantity { unit: "", bounds: Bounds::positive(1e3) },
            "1",
            "frequency of the force over the spin speed",
        ),
        Field::optional(
            "frequency",
            FieldKind::Range { unit: "rad/s", bounds: Bounds::up_to(1e7) },
            "",
            "frequencies of the force at one spin speed, in place of order; 400 points unless given",
        ),
        STANDARD,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let place = place::read("place", values, system, diagnostics);
        let given = one_or_range("speed", values.range("speed")?, 3, values, diagnostics);
        let margins = values.choice("standard") == Some("api_684");
        let frequencies = values.range("frequency").map(|given| range("frequency", given, 3, values, diagnostics));
        let mut wrong = |field: &str, message: text::Text, help: text::Text| {
            diagnostics.push(Diagnostic::error("harmonic_force.speed", message).at(values.span_of(field)).help(help));
        };
        let over = match (given?, frequencies) {
            (speed, Some(_)) if !speed.is_one() => {
                wrong("frequency", text!("frequency belongs to one spin speed"), text!("give one speed, or order in place of frequency"));
                return None;
            }
            (_, Some(_)) if values.written("order") => {
                wrong("order", text!("order and frequency both say how fast the force is"), text!("leave one of them out"));
                return None;
            }
            (_, Some(_)) if margins => {
                wrong(
                    "standard",
                    text!("separation margins are those of a range of speeds"),
                    text!("leave frequency out and give a range of speeds"),
                );
                return None;
            }
            (speed, Some(frequency)) => Over::Frequency(frequency?, speed.from),
            (speed, None) => Over::Speed(speed, values.number("order").unwrap_or(1.0)),
        };
        if margins && Speeds::of(system).is_none() {
            wrong(
                "standard",
                text!("separation margins need an operating speed"),
                text!("give speed in [machine], or the range of operating speeds in [operation]"),
            );
            return None;
        }
        let direction = match values.choice("direction") {
            Some("y") => Direction::Y,
            Some("forward") => Direction::Forward,
            Some("backward") => Direction::Backward,
            _ => Direction::X,
        };
        Some(HarmonicForce { place: place?, force: values.number("force").unwrap_or(1.0), direction, over, margins })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        match self.over {
            Over::Speed(range, _) => vec![SpinSpeeds::between(range.from, range.to)],
            Over::Frequency(_, speed) => vec![SpinSpeeds::one(speed)],
        }
    }

    fn vibration(&self, _: &System) -> Vibration {
        match self.over {
            Over::Speed(_, order) => Vibration::Orders(vec![order]),
            Over::Frequency(range, _) => Vibration::Range(range.from, range.to),
        }
    }

    fn size(&self, system: &System) -> Option<size::Size> {
        let values = self.range().points.unwrap_or(POINTS);
        Some(size::Size {
            bytes: values as f64 * (size::KEPT * (system.n() + system.m()) as f64 + size::LISTED * 3.0 * system.stations().len() as f64),
            of: text!("responses at {values} values of {n} coordinates", values, n = system.n()),
            fewer: text!("give the range fewer points"),
        })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        rest(system, self.at(self.range().to).1)?;
        if !self.forced(system)?.moves() {
            return Err(Diagnostic::error(
                "harmonic_force.place",
                text!("the point on which the force acts does not move across the axis"),
            )
            .help(text!("name a point of a disc, a shaft or a foundation")));
        }
        Ok(())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<HarmonicForceResult, Diagnostic> {
        self.admit(system)?;
        let still = self.forced(system)?;
        let state = over_speed(&still.system);
        let own = self.held(system)?.map(|held| self.forced(&held)).transpose()?;
        let forced = own.as_ref().unwrap_or(&still);
        let of = &forced.system;
        let range = self.range();
        let mut strongest = Vec::new();
        let mut values = range.linspace(POINTS);
        context.announce(values.len() as f64, 10_000.0, text!("responses to compute"));
        let mut known = time_forms(of).is_ok();
        let places: Vec<(f64, f64)> = match self.over {
            Over::Frequency(range, speed) if over_frequency(of) => {
                let about = state(speed)?;
                let within = own_frequency::range(of, &about, Some(range.to))?;
                let own = own_frequency::own_modes(of, &about, within, &[], &mut |done| context.goes_on(done))?;
                known = own.counted();
                own.modes.iter().map(|m| (m.mode.value.im, m.mode.value.re.abs())).collect()
            }
            _ if !known => Vec::new(),
            Over::Frequency(_, speed) => {
                let modes = spectrum(of, &state, speed)?.1;
                strongest.extend(Strongest::of(speed, &modes));
                modes.modes.iter().map(|m| (m.value.im, m.value.re.abs())).collect()
            }
            Over::Speed(range, _) if range.is_one() => {
                strongest.extend(Strongest::of(range.from, &spectrum(of, &state, range.from)?.1));
                Vec::new()
            }
            Over::Speed(range, order) => {
                let along = RangeValue { points: None, ..range }.linspace(if of.n() > 40 { 20 } else { 60 });
                let found = sweep(of, &state, &along, above(order * range.to), |_, solved| context.goes_on(solved))?;
                let all = criticals(of, &state, &found, &[order]);
                strongest = found.strongest;
                all.iter().map(|c| (c.speed, c.growth.abs() / order)).collect()
            }
        };
        for (place, width) in places {
            let width = width.max(1e-9 * place.abs());
            values.extend(WIDTHS.iter().flat_map(|k| [place - k * width, place + k * width]));
        }
        if over_frequency(system) {
            // modes have other coefficients than the response
            strongest.clear();
        }
        values.retain(|x| (range.from..=range.to).contains(x));
        ascending(&mut values);
        values.dedup_by(|b, a| *b - *a <= 1e-10 * b.abs());
        let mut points: Vec<Response> = Vec::new();
        let (mut singular, mut complete) = (Vec::new(), true);
        let (mut outside, mut closed) = (Vec::new(), Vec::new());
        let at = |x: f64| forced.response(&state, self.at(x), self.force, self.direction);
        let here = Here::now();
        let assessed = |&x: &f64| {
            let _counted = here.enter();
            let Some(r) = at(x)? else { return Ok(None) };
            let seen = Assessed::of(of, &state, &r, self.at(x).1)?;
            Ok(Some((r, seen)))
        };
        let mut done = 0;
        while done < values.len() {
            context.progress.report(done as u64, values.len() as u64);
            if !context.goes_on(done as u64) {
                complete = false;
                break;
            }
            let left = usize::try_from(context.work_limit - done as u64).unwrap_or(usize::MAX);
            let some = &values[done..values.len().min(done + AT_ONCE.min(left))];
            done += some.len();
            let found: Vec<Result<_, Diagnostic>> = some.par_iter().map(assessed).collect();
            for (&x, found) in some.iter().zip(found) {
                match found? {
                    Some((r, seen)) => {
                        seen.enter(of, x, (&mut outside, &mut closed));
                        points.push(Response { speed: x, ..r });
                    }
                    None => singular.push(x),
                }
            }
        }
        let probes = of.probes().to_vec();
        let mut peaks = Vec::new();
        let computed = |x: f64| at(x).ok().flatten().map(|r| Response { speed: x, ..r });
        let mut search = Search::new(&computed);
        for (index, probe) in probes.iter().enumerate() {
            let samples: Vec<(f64, f64)> = points.iter().map(|r| (r.speed, r.size(probe))).collect();
            let loudest = samples.iter().map(|s| s.1).fold(0.0, f64::max);
            for (k, w) in samples.windows(3).enumerate().filter(|(_, w)| w[1].1 > w[0].1 && w[1].1 >= w[2].1 && w[1].1 > STILL * loudest) {
                let first = k.saturating_sub(BESIDE);
                let around = &points[first..(k + 3 + BESIDE).min(points.len())];
                let top = search.extremum(around, k + 1 - first, probe, true).filter(|t| t.1 >= w[1].1).unwrap_or(w[1]);
                let half_power = of_responses(top, &points, probe, &mut search);
                let range_ends = ends(top, half_power, &points, &singular, probe, &mut search);
                peaks.push(Peak { probe: index, at: top.0, value: top.1, half_power, range_ends, bracket: (w[0].0, w[2].0) });
            }
        }
        let ends = [self.at(range.from).1, self.at(range.to).1];
        let states = EndStates::find(|w| rest(system, w), ends[0], ends[1])?;
        Ok(HarmonicForceResult { points, peaks, probes, singular, outside, closed, strongest, known, states, end: context.end(complete) })
    }

    fn report(&self, system: &System, result: &HarmonicForceResult, name: &str) -> Result<Outcome, Diagnostic> {
        let outcome = report::Shown { study: self, system, result }.outcome(name)?;
        Ok(growth_unassessed(system).into_iter().fold(outcome, Outcome::finding))
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// Amplitude over the largest below which a maximum is rounding.
const STILL: f64 = 1e-9;

impl HarmonicForce {
    fn forced(&self, system: &System) -> Result<Forced, Diagnostic> {
        Forced::new(system, &self.place).map_err(Diagnostics::into_error)
    }

    /// The machine with the coefficients of an order of the speed.
    fn held(&self, system: &System) -> Result<Option<System>, Diagnostic> {
        match self.over {
            Over::Speed(_, order) => held(system, Frozen::Order(order)),
            Over::Frequency(..) => Ok(None),
        }
    }

    /// What varies.
    fn range(&self) -> RangeValue {
        match self.over {
            Over::Speed(range, _) | Over::Frequency(range, _) => range,
        }
    }

    /// Frequency and spin speed at a value.
    fn at(&self, x: f64) -> (f64, f64) {
        match self.over {
            Over::Speed(_, order) => (order * x, x),
            Over::Frequency(_, speed) => (x, speed),
        }
    }
}

/// No end known.
fn unknown() -> [f64; 2] {
    [f64::NAN; 2]
}

/// A maximum of an amplitude.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Peak {
    /// Index of the probe.
    pub probe: usize,
    /// Speed, or frequency, rad/s.
    pub at: f64,
    /// Semi-major axis, m or rad.
    pub value: f64,
    /// Half-power points; NaN on a side where the amplitude does not fall so far.
    pub half_power: [f64; 2],
    /// Of sides without such a point: the end of the range up to which the amplitude stays above; NaN elsewhere.
    #[serde(default = "unknown")]
    pub range_ends: [f64; 2],
    /// Values computed beside it.
    pub bracket: (f64, f64),
}

/// The response to a harmonic force.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct HarmonicForceResult {
    /// By rising speed or frequency, which is their `speed`.
    pub points: Vec<Response>,
    /// By probe, then value.
    pub peaks: Vec<Peak>,
    /// What is measured.
    pub probes: Vec<Probe>,
    /// Values at which the response has no bound.
    pub singular: Vec<f64>,
    /// Statements of validity that do not hold; their `speed` is what varies.
    pub outside: Vec<Outside>,
    /// Gaps that the response would close.
    pub closed: Vec<Closed>,
    /// The mode that grows most at every speed of the search for peaks.
    pub strongest: Vec<Strongest>,
    /// Modes are known, so that no narrow peak is missed.
    pub known: bool,
    /// States at the ends of the range of speeds.
    pub states: EndStates,
    /// How the study ended.
    pub end: End,
}
