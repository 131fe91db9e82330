//! Growth rate over the spin speed, alone or together with one parameter of the machine, and the boundary of stability.
//!
//! Equations: largest Re s over all roots of `det T(s, W) = 0`; boundary where it crosses the threshold. An undamped machine is unstable between
//! double roots: there `det T = 0` and `d det T / ds = 0` are solved together for (s, W).
//!
//! Symbols: W spin speed, rad/s; s = growth + i frequency.
//!
//! Validity: small motions about the equilibrium at each speed; constant speed.
//!
//! Sources: `docs/theory/linear-vibration.md#stability-boundaries`, `docs/theory/liquid-plane-flow.md#instability`.

mod findings;
mod regions;
mod report;

use super::criterion::{CRITERION, Criterion};
use super::modes::THRESHOLD;
use super::operating::operating;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values};
use crate::model::part::Domain;
use crate::model::system::System;
use crate::outcome::{End, Kept, Outcome, quantity};
use crate::solve::counted;
use crate::solve::large::usual_frequency;
use crate::solve::roots::{LEAST, has_more_modes, in_region};
use crate::solve::stability::{Row, Sample, row};
use crate::study::shared::region;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::{SpinSpeeds, with_table_speeds};
use crate::study::shared::support::{ABOUT, About, COUNTS, EndStates, SPEED_RANGE, admit_roots, admit_threshold, one_or_range, range};
use crate::study::{Context, Study};
use crate::text;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Most points of a map.
const MOST_CELLS: usize = 1_000_000;

/// See the [module](self).
#[derive(Clone)]
pub struct StabilityMap {
    /// Speeds, rad/s.
    pub speed: RangeValue,
    /// Parameter path and its range.
    pub parameter: Option<(String, RangeValue)>,
    /// State linearised about.
    pub about: About,
    /// What counts as unstable.
    pub criterion: Criterion,
    /// Growth that counts as unstable, 1/s.
    pub threshold: f64,
    /// Largest frequency at which roots of a machine with parts without time form are looked for, rad/s.
    pub frequency: Option<f64>,
}

impl Study for StabilityMap {
    type Result = StabilityMapResult;
    const KIND: &'static str = "stability_map";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm", points = 120 }
parameter = { parameter = "drum.mass", from = "1.5 kg", to = "4 kg", points = 11 }
"#;
    const DOC: &'static str = "Where the machine is unstable: growth rate over the spin speed, alone or together with one parameter, with the \
        boundary and the peaks of the growth located. Nonlinear parts enter by their tangent in the state it is linearised about; nonlinear_response \
        assesses the motion that unbalance drives, whose ranges differ where that motion is not small.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "one spin speed, or a range of 200 points unless given"),
        Field::optional(
            "parameter",
            FieldKind::ParameterRange,
            "",
            "a parameter to vary as well; 40 points unless given, at most 1000000 in all with those of the speed",
        ),
        ABOUT,
        CRITERION,
        THRESHOLD,
        region::FREQUENCY_LIMIT,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = one_or_range("speed", values.range("speed")?, 3, values, diagnostics);
        let mut parameter = None;
        if let Some((path, given)) = values.parameter_range("parameter") {
            let given = range("parameter", given, 2, values, diagnostics);
            if system.param(path).is_none() {
                diagnostics.push(system.unknown_param(path).at(values.span_of("parameter")));
                return None;
            }
            parameter = Some((path.to_string(), given?));
        }
        let count = |r: &RangeValue, default| r.points.unwrap_or(default);
        if let (Some(s), Some((_, p))) = (&speed, &parameter)
            && count(s, 200).saturating_mul(count(p, 40)) > MOST_CELLS
        {
            let message = text!("a map of {speeds} by {values} points is too large", speeds = count(s, 200), values = count(p, 40));
            let help = text!("at most {most} points in all", most = MOST_CELLS);
            diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("parameter")).help(help));
            return None;
        }
        Some(StabilityMap {
            speed: speed?,
            parameter,
            about: About::read(values),
            criterion: Criterion::read(values),
            threshold: values.number("growth_threshold").unwrap_or(0.0),
            frequency: values.number("frequency_limit"),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        // lines of the map are computed side by side
        let lines = self.parameter.as_ref().map_or(1, |p| p.1.points.unwrap_or(40).min(8));
        Some(Size::of_spectra(self.speed.points.unwrap_or(200) * lines, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_roots(system, self.about, self.speed.from)?;
        admit_threshold(system, self.speed.from, self.threshold)?;
        self.criterion.admit(system, self.about, self.speed.from)?;
        let Some((path, range)) = &self.parameter else { return Ok(()) };
        for x in [range.from, range.to] {
            let changed = system.with(&[(path, x)]).map_err(|d| refused(system, path, x, d))?;
            admit_roots(&changed, self.about, self.speed.from)?;
        }
        Ok(())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<StabilityMapResult, Diagnostic> {
        self.admit(system)?;
        // a map over a parameter is a grid
        let speeds = if self.parameter.is_some() { self.speed.linspace(200) } else { with_table_speeds(&self.speed, 200, system) };
        let values = self.values();
        let total = (values.len() * speeds.len()) as u64;
        if in_region(system) {
            context.announce(total as f64, COUNTS, text!("speeds at which roots are counted, one after another"));
        } else {
            context.announce(total as f64, 10_000.0, text!("eigenvalue problems to solve"));
        }
        let done = AtomicU64::new(0);
        // rows that the limit cannot reach are not begun
        let within = usize::try_from(context.work_limit.div_ceil(speeds.len() as u64)).unwrap_or(usize::MAX).clamp(1, values.len());
        let here = Here::now();
        let rows: Vec<Row> = values[..within]
            .par_iter()
            .enumerate()
            .map(|(k, value)| {
                let _counted = here.enter();
                // the limit counts rows before this one as done, so that the result does not depend on the number of threads
                let first = (k * speeds.len()) as u64;
                let each = |solved: u64| {
                    context.progress.report(done.fetch_add(1, Ordering::Relaxed).min(total), total);
                    context.goes_on(first + solved)
                };
                if context.cancelled() {
                    return Ok(Row { stopped: true, ..Row::default() });
                }
                match (value, &self.parameter) {
                    (Some(x), Some((path, _))) => {
                        let changed = system.with(&[(path, *x)]).map_err(|d| refused(system, path, *x, d))?;
                        self.row(&changed, &speeds, &speeds, context, &each)
                    }
                    _ => self.row(system, &speeds, &speeds, context, &each),
                }
            })
            .collect::<Result<_, Diagnostic>>()?;
        context.progress.report(total, total);
        let stopped = rows.len() < values.len() || rows.iter().any(|r| r.stopped);
        let states = EndStates::find(|w| self.about.find(system, w, None), speeds[0], speeds[speeds.len() - 1])?;
        let shown = operating(system, self.speed.from, self.speed.to).filter(|_| self.parameter.is_none() && !self.speed.is_one());
        let shown = shown.map(|o| self.row(system, &[o.speed()], &speeds, context, &|_| true)).transpose()?;
        let operating = shown.and_then(|r| r.samples.first().copied());
        Ok(StabilityMapResult { rows, operating, states, end: context.end(!stopped) })
    }

    fn report(&self, system: &System, result: &StabilityMapResult, name: &str) -> Result<Outcome, Diagnostic> {
        report::Shown::new(self, system, result).outcome(name)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// Stability along the spin speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StabilityMapResult {
    /// For every value of the parameter, as far as computed; one row without a parameter.
    pub rows: Vec<Row>,
    /// At the operating speed, where the range holds it; none of a map over a parameter.
    pub operating: Option<Sample>,
    /// States at the ends of the range of speeds.
    pub states: EndStates,
    /// How the study ended.
    pub end: End,
}

/// Growth over the speed from which on roots of a machine with more modes than are computed are counted.
pub(in crate::study) const RESOLVED: f64 = 1e-6;

impl StabilityMap {
    /// Values of the parameter; one that is none without a parameter.
    fn values(&self) -> Vec<Option<f64>> {
        match &self.parameter {
            Some((_, r)) => r.linspace(40).into_iter().map(Some).collect(),
            None => vec![None],
        }
    }

    /// Stability along the speeds `at`, some of the speeds of the map.
    fn row(
        &self,
        system: &System,
        at: &[f64],
        speeds: &[f64],
        context: &Context,
        each: &(dyn Fn(u64) -> bool + Sync),
    ) -> Result<Row, Diagnostic> {
        let state = self.about.over_speed(system);
        if !in_region(system) {
            return row(system, &state, at, self.threshold, each);
        }
        let limits: (_, &AtomicBool, _) = (self.limit(system, speeds)?, context.cancel, context.work_limit == u64::MAX);
        counted::row(system, &state, at, self.least(system, speeds), limits, each)
    }

    /// Frequency up to which roots are counted: of a machine with more modes than are computed one for all speeds.
    fn limit(&self, system: &System, speeds: &[f64]) -> Result<Option<f64>, Diagnostic> {
        let fastest = speeds.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()));
        match fastest.filter(|_| self.frequency.is_none() && has_more_modes(system)) {
            Some(fastest) => Ok(Some(usual_frequency(system, &self.about.find(system, fastest, None)?))),
            None => Ok(self.frequency),
        }
    }

    /// The threshold, or, of a machine with waves that nothing inside it damps, the least growth that is distinguished from theirs at all these speeds.
    fn least(&self, system: &System, speeds: &[f64]) -> f64 {
        let fastest = speeds.iter().fold(0.0f64, |m, w| m.max(w.abs()));
        match system.domains(fastest).iter().any(Domain::undamped) {
            true => self.threshold.max(LEAST * fastest),
            // without damping roots lie on the axis to rounding, and no count can be taken along it
            false if has_more_modes(system) => self.threshold.max(RESOLVED * fastest),
            false => self.threshold,
        }
    }
}

fn refused(system: &System, path: &str, x: f64, d: Diagnostics) -> Diagnostic {
    let unit = system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or("", |s| s.unit);
    let x = quantity(x, unit);
    let why = d.into_error().message;
    Diagnostic::error("stability_map.parameter", text!("the machine does not exist at {path} = {x}: {why}", path, x, why))
        .help(text!("narrow the range of the parameter"))
}
