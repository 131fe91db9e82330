//! How the peaks and folds of the steady response move with every parameter of the machine.
//!
//! Equations: implicit function theorem on the harmonic balance, exact first derivatives; see [`crate::solve::harmonic::branches::sensitivity`].
//!
//! Symbols: W spin speed, rad/s; a largest displacement of a point of a body (m) or tilt (rad) over a period; p a parameter; relative influence `(p/a) da/dp`, `(p/W) dW/dp`: per cent
//! for one per cent more of the parameter.
//!
//! Validity: small changes; a peak or fold may cease to exist under large ones. That of the response; parts whose force jumps have no derivatives.
//!
//! Sources: as there.

mod places;
mod report;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::System;
use crate::outcome::{End, Outcome};
use crate::solve::harmonic::branches::response::{MOST_HARMONICS, Request, respond};
use crate::study::nonlinear::nonlinear_response::NonlinearResponse;
use crate::study::nonlinear::progress::progress;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::validity::Uses;
use crate::study::{Context, Study};
pub use places::{Derivatives, Kind, Place, Without};
use serde::{Deserialize, Serialize};

/// See the [module](self).
pub struct Sensitivity {
    response: NonlinearResponse,
    bars: usize,
}

impl Sensitivity {
    /// The study of the places found by this request.
    pub fn new(request: Request) -> Self {
        Sensitivity { response: NonlinearResponse::new(request), bars: BARS }
    }
}

/// Parameters drawn unless said.
const BARS: usize = 10;

impl Study for Sensitivity {
    type Result = SensitivityResult;
    const KIND: &'static str = "sensitivity";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm" }
"#;
    const DOC: &'static str = "How every peak and every fold (jump) of the steady response moves with every parameter of the machine: exact derivatives of its speed and \
        of its displacement or tilt, in order of their relative influence. Peaks are those of every point that a part, a limit or a probe names, and of tilts. \
        Values in lists and tables of a part are no parameters.";
    const FIELDS: &'static [Field] = &[
        Field::required(
            "speed",
            FieldKind::Range { unit: "rad/s", bounds: Bounds::within(1e7) },
            "range of the spin speed; negative speeds turn clockwise",
        ),
        Field::optional(
            "harmonics",
            FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS as i64 },
            "auto",
            "largest order of the spin frequency kept; auto raises it until the dropped force is negligible",
        ),
        Field::optional("bars", FieldKind::Integer { min: 1, max: 100 }, "10", "parameters drawn for each place, those of most influence"),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let response = NonlinearResponse::build(values, system, diagnostics)?;
        let bars = values.integer("bars").and_then(|b| usize::try_from(b).ok()).unwrap_or(BARS);
        Some(Sensitivity { response, bars })
    }

    fn spin_speeds(&self, system: &System) -> Vec<SpinSpeeds> {
        self.response.spin_speeds(system)
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.response.admit(system)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<SensitivityResult, Diagnostic> {
        self.admit(system)?;
        let mut request = *self.response.request();
        request.max_points = request.max_points.min(usize::try_from(context.work_limit).unwrap_or(usize::MAX)).max(2);
        let response = respond(system, &request, context.cancel, &|step| progress(context, &step))?;
        let (found, end) = places::find(system, &response, &request, context)?;
        let uses = Uses::of_response(system, &response, request.speeds)?;
        Ok(SensitivityResult { found, uses, end })
    }

    fn report(&self, system: &System, result: &SensitivityResult, name: &str) -> Result<Outcome, Diagnostic> {
        let outcome = report::report(&result.found, result.end, self.bars, name)?;
        Ok(result.uses.of_states(system).into_iter().fold(outcome, Outcome::finding))
    }
}

/// How the peaks and folds of a response move with the parameters.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SensitivityResult {
    /// The peaks and folds.
    pub found: Derivatives,
    /// How far the states of the response use up the validity of the parts.
    pub uses: Uses,
    /// How the study ended.
    pub end: End,
}
