//! Recommended parameters: what another study finds made as small or as large as possible over parameters of the machine within bounds.
//!
//! Equations: over parameters p in a box,
//!
//! ```text
//! minimise s f(p)/|f(p0)| + k sum_j max(0, g_j(p))      g_j = +-(value/limit - 1)
//! ```
//!
//! s = 1, or -1 to maximise; p0 the machine as it is. The penalty is exact: for a large enough k (raised until the limits are kept) the minimum is that of the problem with
//! constraints. It is sought by the evolution strategy with covariance matrix adaptation ([`laval_num::optimise`]) from several starts, because the larger of two peaks
//! has kinks and a response may have several optima. What is found is then tested: one-sided slopes in both directions of every parameter and in
//! directions between them. The recommended range of a parameter is where the number is no worse than a tolerance allows, all limits kept and the other
//! parameters at their best.
//!
//! Symbols: f the number to make small or large; g_j a number with a limit.
//!
//! Validity: that of the inner study. The search does not exclude that a better machine lies elsewhere in the box.
//!
//! Sources: N. Hansen (2016), see there; exact penalties: D. Bertsekas, Nonlinear Programming (1999) section 5.5.

mod machine;
mod report;
mod request;
mod result;
mod search;

use super::uncertainty::build_inner;
use super::uncertainty::collect::with_sizes;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::System;
use crate::outcome::{End, Outcome};
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::{Context, ErasedStudy, Study};
use crate::text;
pub use machine::Vary;
pub use request::{Aim, Limit};
pub use result::{Along, Found, OptimumResult, Run, Slope, Stray, Trail};

/// See the [module](self).
pub struct Optimum {
    /// What is computed for every machine.
    pub study: Box<dyn ErasedStudy>,
    /// The parameters and their bounds.
    pub vary: Vec<Vary>,
    /// What is made small or large.
    pub aim: Aim,
    /// Limits on other numbers.
    pub limits: Vec<Limit>,
    /// Searches.
    pub starts: usize,
    /// Most runs of each search.
    pub runs: usize,
    /// Share by which the number may be worse in a recommended range.
    pub tolerance: f64,
}

/// Most parameters: a search takes hundreds of runs for each.
const MOST_PARAMETERS: usize = 12;

impl Study for Optimum {
    type Result = OptimumResult;
    const KIND: &'static str = "optimum";
    const EXAMPLE: &'static str = r#"study = { kind = "modes", speed = "3000 rpm" }
vary = [{ parameter = "drum.mass", from = "2 kg", to = "4 kg" }]
maximise = "least_damped_mode damping ratio"
"#;
    const DOC: &'static str = "Recommended parameters within bounds: makes a number that another study finds as small or as large as possible (least peak, least force, \
        widest window, highest speed of instability), keeps limits on others, and says how far each parameter may stray.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required("study", FieldKind::Study, "what is computed for every machine"),
        Field::required(
            "vary",
            FieldKind::ParameterRanges,
            "the parameters and their bounds; a range over a decade and more is searched in the logarithm",
        ),
        Field::optional(
            "minimise",
            FieldKind::Text,
            "largest_displacement",
            "name of the number to make small, as results.json and uncertainty call it: the finding and what it speaks of; the largest where there are several; of a finding whose number is a speed, what it has there, as largest_resonance.amplitude",
        ),
        Field::optional("maximise", FieldKind::Text, "", "the number to make large instead; the least where there are several"),
        Field::optional("at_most", FieldKind::StateMap, "", "upper limits on numbers: { \"largest_force bearing\" = \"5 kN\" }"),
        Field::optional("at_least", FieldKind::StateMap, "", "lower limits on numbers"),
        Field::optional(
            "starts",
            FieldKind::Integer { min: 1, max: 32 },
            "3",
            "searches: from the machine as it is, and from elsewhere in the bounds",
        ),
        Field::optional("runs", FieldKind::Integer { min: 20, max: 100_000 }, "600", "most runs of the study in each search"),
        Field::optional(
            "tolerance",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-4, 10.0) },
            "5 %",
            "by how much the number may be worse in the recommended range of a parameter",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let study = build_inner(values.study("study")?, system, diagnostics);
        let vary = machine::vary(values, system, diagnostics);
        let limits = request::limits(values, diagnostics);
        let aim = request::aim(values, diagnostics);
        let whole = |name: &str, default: usize| values.integer(name).and_then(|i| usize::try_from(i).ok()).unwrap_or(default);
        Some(Optimum {
            study: study?,
            vary: vary?,
            aim: aim?,
            limits: limits?,
            starts: whole("starts", 3),
            runs: whole("runs", 600),
            tolerance: values.number("tolerance").unwrap_or(0.05),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        Vec::new()
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.study.admit(system)
    }

    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        self.study.prepare(system, context)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<OptimumResult, Diagnostic> {
        Study::prepare(self, system, context)?;
        let inner = Context { progress: &crate::study::Silent, work_limit: u64::MAX, keep: None, ..*context };
        let nominal = self.study.run(system, &inner)?;
        if context.cancelled() || nominal.end == End::Cancelled {
            return Ok(OptimumResult { found: None, end: End::Cancelled });
        }
        let now = with_sizes(&nominal);
        self.known(&now)?;
        context.announce((self.starts * self.runs) as f64, 1000.0, text!("runs of the study {kind} at most", kind = self.study.kind()));
        let found = search::search(self, system, &now, &inner, context);
        Ok(OptimumResult { end: context.end(found.complete), found: Some(found) })
    }

    fn report(&self, _: &System, result: &OptimumResult, name: &str) -> Result<Outcome, Diagnostic> {
        match &result.found {
            Some(found) => report::report(self, found, result.end, name),
            None => Ok(Outcome::new(Self::KIND, name).end(result.end)),
        }
    }
}
