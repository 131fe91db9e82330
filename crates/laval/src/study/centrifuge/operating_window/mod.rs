//! The speeds at which a machine is stable, keeps its limits, survives the run-up, and separates what it should in the time it has.
//!
//! Equations: every requirement is a margin, kept when 0 or more:
//!
//! ```text
//! separation    1 - t_q(w)/t            vibration    1 - max(amplitude/limit) over all stable steady states
//! self_centred  1 - (|z + e|/|e|)/c0    passage      1 - worst of peak/limit and torque/available on the way up and down
//! strength      1 - w/w_max(density)    stable       1 - min(w, w_s)/max(w, w_s), negative where unstable
//! clear         min |p - h w|/w - dlt
//! ```
//!
//! All are shares of a limit that are left: of a time, an amplitude or a torque, or (`strength`, `stable`, `clear`) of the speed, as its distance from the speed that is not
//! allowed. `stable` is assessed with the contents as they are before and after the separation. The window is where all are kept. Its ends are located by bracketing; the recommended speed has the largest least margin, the next larger ones deciding with a thousandth of the weight each (or serves another
//! objective). At every speed the machine carries its cups at the tilt of that speed.
//!
//! Symbols: w spin speed; w_s nearest speed at which the largest growth rate passes -sig0 (`borders`); p natural whirl frequency; h excitation order; t_q time in which the share q is caught.
//!
//! Validity: that of the parts and of the separation; a margin that cannot be had counts as not kept. The robust window is asserted at the corners of the uncertain
//! parameters, which bounds it where margins depend on them monotonically.
//!
//! Sources: `docs/theory/operating-window.md#margins`.

mod borders;
mod contents;
mod detail;
mod evaluate;
mod figures;
mod findings;
mod margins;
mod passage;
mod recommended;
mod report;
mod request;
mod steady;
mod tables;
mod vary;
mod window;

use super::cups::CUP;
use super::cups::task::{DIAMETER, MODEL, PARTICLES, RECOVERY, START, THROUGHPUT};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::system::System;
use crate::outcome::{End, Outcome};
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::SPEED_RANGE;
use crate::study::{Context, Study};
use crate::text;
pub use detail::Detail;
use evaluate::Care;
pub use evaluate::{Counted, Evaluated, Unseen};
use laval_num::work;
pub use margins::{Margin, Point};
pub use passage::{Passage, Stretch};
use serde::{Deserialize, Serialize};
pub use vary::{Cell, Map, Robust};
pub use window::{End as Edge, Interval};

/// What the best speed is best for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objective {
    /// Largest least margin.
    Margin,
    /// Shortest time.
    Time,
    /// Least energy.
    Energy,
    /// Smallest vibration.
    Amplitude,
}

/// Which of several stable steady states of a nonlinear machine is assessed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum Policy {
    /// All of them.
    All,
    /// The one nearest to the motion of the simulated run-up as it passes the speed.
    Reached,
    /// The one with the least margin of vibration.
    Highest,
}

/// See the [module](self).
pub struct OperatingWindow {
    speed: RangeValue,
    values: Values,
    objective: Objective,
    tolerance: f64,
    uncertain: Vec<(String, f64)>,
    map: Option<(String, RangeValue)>,
}

/// Speeds of the scan unless given, and of a map.
const SPEEDS: usize = 120;
/// Values of the parameter of a map unless given.
const MAP_POINTS: usize = 12;
/// Most places where particles start in a map.
const MAP_PLACES: usize = 256;

impl Study for OperatingWindow {
    type Result = WindowResult;
    const KIND: &'static str = "operating_window";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "3000 rpm" }
time = "10 min"
recovery = "95 %"
ramp = "60 s"
"#;
    const DOC: &'static str = "At which speeds the machine may run: stable, its limits kept, the way up survived, and the suspension separated in the time at \
        hand; what binds at each end, the recommended speed, the shortest time, and what to relax when nothing fits. Uses the blocks \
        [limits], [[cup]] and [suspension]; a requirement that is not given is not checked. Stability is assessed with the contents as they are before and after the \
        separation: particles spread over the cups and all at their bottoms, bowls full of suspension and of clear liquid.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds looked at; points (120 unless given) are added where something happens"),
        CUP,
        Field::optional(
            "time",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) },
            "",
            "time in which cups and tubes must have separated; where liquid flows through, throughput says it",
        ),
        THROUGHPUT,
        RECOVERY,
        DIAMETER,
        PARTICLES,
        MODEL,
        START,
        Field::optional(
            "ramp",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e7) },
            "",
            "time of the run-up to the top of the range, at constant acceleration; it is then simulated",
        ),
        Field::optional(
            "count_ramp",
            FieldKind::Flag,
            "true",
            "the run-up takes its time from the time at hand, and is no longer than it; cups separate on the way, the liquid of fixed-angle tubes by an estimate (field at mean \
             radius), and machines that liquid flows through are fed at speed",
        ),
        Field::optional(
            "objective",
            FieldKind::Choice(&[
                ("margin", "largest least margin; where it is nearly the same, the largest next one"),
                ("time", "shortest separation, or largest throughput"),
                ("energy", "least kinetic energy and work of the drive"),
                ("amplitude", "smallest vibration against its limits"),
            ]),
            "margin",
            "what the recommended speed is best for",
        ),
        Field::optional(
            "branch_policy",
            FieldKind::Choice(&[
                ("all", "every stable steady state must keep the limits"),
                ("reached", "the one that the run-up of the file leads to, and valid for that run-up only"),
                ("highest", "the one with the largest vibration against its limits"),
            ]),
            "all",
            "which of several steady states of a nonlinear machine is assessed",
        ),
        Field::optional(
            "speed_tolerance",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.0, 0.5) },
            "0",
            "relative error of the speed that the robust window leaves room for",
        ),
        Field::optional(
            "uncertain",
            FieldKind::Named { unit: "", bounds: Bounds { min: 0.0, max: 0.9, min_open: true } },
            "",
            "relative uncertainty of parameters by path, as { suspension.viscosity = \"20 %\" }; the robust window holds at every corner",
        ),
        Field::optional(
            "map",
            FieldKind::ParameterRange,
            "",
            "a parameter (of a part, a cup or the suspension) to vary against the speed; 12 points unless given",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        request::read(values, system, diagnostics)
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        // a run-up begins at rest
        let from = if self.values.number("ramp").is_some() { 0.0 } else { self.speed.from };
        vec![SpinSpeeds::between(from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let map = self.map.as_ref().map_or(0, |m| m.1.points.unwrap_or(MAP_POINTS) * SPEEDS / 2);
        let speeds = 2 * self.speed.points.unwrap_or(SPEEDS) + map;
        Some(Size::of_rows(speeds, 48 + 4 * system.probes().len()))
    }

    fn compute(&self, system: &System, context: &Context) -> Result<WindowResult, Diagnostic> {
        let corners = if self.uncertain.is_empty() { 0 } else { 1usize << self.uncertain.len() };
        let others = corners + self.map.as_ref().map_or(0, |m| m.1.points.unwrap_or(MAP_POINTS));
        let speeds = self.speed.points.unwrap_or(SPEEDS) + others * SPEEDS / 2;
        context.announce(speeds as f64, 1000.0, text!("speeds to evaluate, and more where something happens"));
        let Some(main) = self.evaluate(system, context, Care::Full, None, 0)? else {
            return Ok(WindowResult { found: None, end: context.end(false) });
        };
        let mut speeds = main.points.len() as u64;
        let robust = later(context, || self.robust(system, context, &main, &mut speeds))?;
        let stopped = self.wants_robust() && robust.is_none();
        let map = if stopped { None } else { later(context, || self.mapped(system, context, &main, &mut speeds))? };
        let found = Found { main, robust, map };
        let end = context.end(self.missing(&found).is_empty());
        Ok(WindowResult { found: Some(found), end })
    }

    fn report(&self, system: &System, result: &WindowResult, name: &str) -> Result<Outcome, Diagnostic> {
        match &result.found {
            Some(found) => Ok(report::Shown::new(self, system, found)?.outcome(name)?.end(result.end)),
            None => Ok(Outcome::new(Self::KIND, name).over("speed", "rad/s").end(result.end)),
        }
    }
}

impl OperatingWindow {
    /// What the file requires and a stop left out, as words of the sentence.
    fn missing(&self, found: &Found) -> Vec<&'static str> {
        let parts = [
            (!found.main.refined, "refinement"),
            (self.wants_robust() && found.robust.is_none(), "robust"),
            (self.map.is_some() && found.map.is_none(), "map"),
        ];
        parts.into_iter().filter_map(|(left_out, part)| left_out.then_some(part)).collect()
    }
}

/// A part of the study after the window of the machine itself, which is shown without it; `None` where it is not required or was stopped.
fn later<R>(context: &Context, part: impl FnOnce() -> Result<Option<R>, Diagnostic>) -> Result<Option<R>, Diagnostic> {
    match work::piece(part) {
        // a computation that was stopped may end with an error of its own
        Some(Err(_)) if context.cancelled() => Ok(None),
        Some(found) => found,
        None => Ok(None),
    }
}

/// The speeds at which the machine may run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct WindowResult {
    /// None where the study was stopped before the range was scanned.
    pub found: Option<Found>,
    /// How the study ended.
    pub end: End,
}

/// The window of the machine, and of others like it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Found {
    /// The machine as it is.
    pub main: Evaluated,
    /// At the corners of uncertain parameters, with room for the tolerance of the speed.
    pub robust: Option<Robust>,
    /// Over speed and a parameter.
    pub map: Option<Map>,
}
