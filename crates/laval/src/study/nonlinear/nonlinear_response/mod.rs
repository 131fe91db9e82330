//! The steady response to unbalance of a machine with nonlinear parts, over a range of speeds.
//!
//! Equations: harmonic balance of the assembled residual, linear parts exact at every order; see [`crate::solve::harmonic`].
//!
//! Symbols: W spin speed, rad/s; Z_n complex amplitude of order n of a body's `x + i y`, m.
//!
//! Validity: periodic motion at the spin frequency (or its submultiple); a motion that has lost its stability is shown, not followed.
//!
//! What proves each statement:
//!
//! | statement | proof |
//! | --- | --- |
//! | a slow sweep jumps | a fold, with bracket and second method, that turns against the sweep on the branch followed from beyond the range; states next to it stable |
//! | it jumps onto a stable state, or none | exponents of the states of both main branches just beyond the fold |
//! | no jump | the branch meets the other end of the range without such a fold; where its states are unstable is said with it |
//! | states are unstable, fastest growth | exponents at the points of one stretch from fold to fold, with their error; a saddle between two folds is left out |
//! | stability is lost, gained | a zero of a growth rate between a stable and an unstable point of one stretch |
//! | largest displacement, force | maximum over the states not unstable, refined between points; nothing is said where a branch was left rising |
//! | a start is not followed | no branch led from beyond the range to its end: the state was found there alone |
//! | further states, none found | each is solved for and followed; what is not found is not excluded |
//!
//! With all states the search combines the planes of known states, switches branches at bifurcations, and starts from subharmonic and from arbitrary
//! motions (see [`crate::solve::harmonic::branches::families`]).
//!
//! Theory: `docs/theory/harmonic-balance.md#balance`.
//!
//! Sources: `000_a291f7ede1484e56` chapters 1 and 2 (averaging, harmonic balance); M. Urabe (1965) for the Galerkin form.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Value, Values};
use crate::model::system::{Drive, System};
use crate::outcome::{End, Outcome};
use crate::solve::ensemble;
use crate::solve::harmonic::branches::response::{MOST_HARMONICS, Request, States, respond, symmetry};
use crate::solve::harmonic::branches::time_starts;
use crate::solve::symmetry::Symmetry;
use crate::study::nonlinear::progress::progress;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::range;
use crate::study::{Context, Study};
use crate::text;
use measuring::Measuring;
pub(in crate::study) use one::around;
pub use result::{Measured, NonlinearResponseResult};
use shown::Shown;
pub(in crate::study) use shown::{holder, limited};
pub(in crate::study) use stability::unassessed;
pub use {
    forces::Extremes,
    largest::{Largest, Rising},
    one::Motion,
    orders::{Edge, Orders, Stretch, Whirl, Whirls},
    self_centring::{Approach, Centring},
    tuning::Tuned,
};

mod families;
mod findings;
mod forces;
mod largest;
mod measuring;
mod one;
mod orders;
mod picture;
mod result;
mod self_centring;
mod shown;
mod stability;
mod stretches;
pub(in crate::study) mod summary;
mod sweeps;
mod tables;
mod tilts;
mod tuning;

/// See the [module](self).
pub struct NonlinearResponse {
    request: Request,
    /// Amplitude from which orders beside the synchronous one are reported, m.
    order_threshold: Option<f64>,
    /// The one speed that is meant, rad/s; the range of the request lies about it.
    one: Option<f64>,
}

impl NonlinearResponse {
    /// The study that answers this request.
    pub fn new(request: Request) -> Self {
        NonlinearResponse { request, order_threshold: None, one: None }
    }
    /// The same response for a figure that follows a changing machine, at fewer speeds. Over a range of speeds (rad/s) it has the first figure with its table, and the folds:
    /// displacements (m) and tilts (rad) at computed points. Forces, other quantities of parts, validity, values between points and findings are left out.
    #[must_use]
    pub fn sketch(self) -> Self {
        NonlinearResponse { request: Request { sketch: true, ..self.request }, ..self }
    }
    /// Over this range of speeds, rad/s, with the defaults.
    pub fn over(from: f64, to: f64) -> Self {
        NonlinearResponse::new(Request::over(from, to))
    }
    /// The request.
    pub fn request(&self) -> &Request {
        &self.request
    }
}

/// Smallest spin speed, rad/s: the unbalance needs a turn to act.
const SLOWEST: f64 = 1e-3;

pub(in crate::study) const SPEED: Field = Field::required(
    "speed",
    FieldKind::Range { unit: "rad/s", bounds: Bounds::within(1e7) },
    "range of the spin speed; negative speeds turn clockwise",
);
pub(in crate::study) const HARMONICS: Field = Field::optional(
    "harmonics",
    FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS as i64 },
    "auto",
    "largest order of the spin frequency kept; auto raises it until the dropped force is below truncation",
);
pub(in crate::study) const TRUNCATION: Field = Field::optional(
    "truncation",
    FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-15, 1.0) },
    "1e-7",
    "dropped over kept force harmonics that auto accepts",
);
pub(in crate::study) const SYMMETRY: Field = Field::optional(
    "symmetry",
    FieldKind::Choice(&[
        ("auto", "the largest symmetry the machine has"),
        ("quarter", "z(t + T/4) = i z(t): orders 1, -3, 5, -7"),
        ("half", "z(t + T/2) = -z(t): odd orders"),
        ("none", "all orders"),
    ]),
    "auto",
    "symmetry imposed on the motion; less symmetry admits more states",
);
pub(in crate::study) const STABILITY: Field = Field::optional("stability", FieldKind::Flag, "true", "assess the stability of every point");
pub(in crate::study) const MAX_POINTS: Field =
    Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of a branch");

impl Study for NonlinearResponse {
    type Result = NonlinearResponseResult;
    const KIND: &'static str = "nonlinear_response";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm" }
harmonics = "auto"
"#;
    const DOC: &'static str = "Steady response to unbalance over a range of speeds, with the states the machine can settle in: branches followed \
        from both ends, folds (where a slow sweep jumps) and other bifurcations located, stability of every point; on request also mixed, less symmetric \
        and subharmonic states.";
    const FIELDS: &'static [Field] = &[
        SPEED,
        HARMONICS,
        TRUNCATION,
        SYMMETRY,
        Field::optional(
            "subharmonic",
            FieldKind::Integer { min: 1, max: 9 },
            "1",
            "period sought, in turns n of the rotor; of the orders in steps of speed / n symmetry by a quarter turn keeps every fourth (for 3: -1/3, 1, -5/3), by \
             half a turn every second; even n has no symmetry",
        ),
        STABILITY,
        Field::optional(
            "check_stability",
            FieldKind::Flag,
            "false",
            "assess some states again by Hill's method and by a second map over the period",
        ),
        Field::optional(
            "states",
            FieldKind::Choice(&[
                ("main", "those of the branches from both ends of the range"),
                ("all", "also mixed, less symmetric and subharmonic states, and those apart from the others"),
            ]),
            "main",
            "which states are looked for",
        ),
        Field::optional(
            "starts",
            FieldKind::Integer { min: 0, max: 100_000 },
            "64",
            "with states = \"all\": starts of any size and phase, the same in every run",
        ),
        Field::optional(
            "time_starts",
            FieldKind::Integer { min: 0, max: 1000 },
            "0",
            "with states = \"all\": starts integrated in time at each speed searched; what they settle on, of periods up to 9 turns, is solved for and followed",
        ),
        Field::optional(
            "order_threshold",
            FieldKind::Quantity { unit: "m", bounds: Bounds::positive(1.0) },
            "",
            "amplitude from which sub- and superharmonic orders are reported, with the speeds at which they pass it; none unless given",
        ),
        MAX_POINTS,
    ];

    fn build(values: &Values, _: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let one = values.range("speed").filter(RangeValue::is_one).map(|r| r.from);
        let mut about = values.clone();
        if let Some((from, to)) = one.map(one::around) {
            about.set("speed", Value::Range(RangeValue { from, to, points: None }), values.span_of("speed"));
        }
        let request = request(&about, diagnostics)?;
        Some(NonlinearResponse { request, order_threshold: values.number("order_threshold"), one })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        let (from, to) = self.request.speeds;
        vec![self.one.map_or(SpinSpeeds::between(from, to), SpinSpeeds::one)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(Size::of_branch(self.request.max_points, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit(system, &self.request)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<NonlinearResponseResult, Diagnostic> {
        self.admit(system)?;
        let mut request = Request { work: context.work_limit, ..self.request };
        request.max_points = request.max_points.min(usize::try_from(context.work_limit).unwrap_or(usize::MAX)).max(2);
        let response = respond(system, &request, context.cancel, &|step| progress(context, &step))?;
        if let Some(speed) = self.one {
            let motions = Some(one::motions(system, &request, &response, speed, context)?);
            let end = if context.cancelled() { End::Cancelled } else { limited(&response, &request, context) };
            return Ok(NonlinearResponseResult { response, measured: None, orders: None, motions, end });
        }
        let mut measuring = if self.request.sketch {
            Measuring::sketch(system, &response, &request)?
        } else {
            Measuring::new(system, &response, &request)?
        };
        let measured = if self.request.sketch { measuring.sizes(&response, &request) } else { measuring.all(&response, &request) };
        let orders = self.order_threshold.filter(|_| !self.request.sketch).map(|threshold| measuring.orders(&response, threshold));
        let end = limited(&response, &request, context);
        Ok(NonlinearResponseResult { response, measured: Some(measured), orders, motions: None, end })
    }

    fn report(&self, system: &System, result: &NonlinearResponseResult, name: &str) -> Result<Outcome, Diagnostic> {
        let NonlinearResponseResult { response, measured, orders, motions, end } = result;
        if let (Some(speed), Some(motions)) = (self.one, motions) {
            return one::outcome(Self::KIND, system, response, (speed, motions), name, *end);
        }
        let Some(measured) = measured else {
            return Err(Diagnostic::error("response.result", text!("the stored response is of one speed, and this study is over a range")));
        };
        let shown = Shown::new(system, response, measured);
        if self.request.sketch {
            return shown.sketch(&self.request, name, *end)?.checked().map_err(Diagnostic::from);
        }
        let mut outcome = shown.outcome(&self.request, name, *end)?;
        if let (Some(threshold), Some(orders)) = (self.order_threshold, orders) {
            outcome = shown.with_orders(orders, threshold, outcome)?;
        }
        outcome.checked().map_err(Diagnostic::from)
    }
}

/// The request of the fields; those that a study does not have stand at their defaults.
pub(in crate::study) fn request(values: &Values, diagnostics: &mut Diagnostics) -> Option<Request> {
    let before = diagnostics.0.len();
    let speeds = range("speed", values.range("speed")?, 0, values, diagnostics).map(|s| (s.from, s.to));
    if speeds.is_some_and(|(lo, hi)| !(lo >= SLOWEST || hi <= -SLOWEST)) {
        diagnostics.push(
            Diagnostic::error("response.standstill", text!("the range of speeds comes too near to standstill, where no unbalance acts"))
                .at(values.span_of("speed"))
                .help(text!(
                    "keep both ends above {slowest}, or both below {lowest} for rotation the other way round",
                    slowest = text::quantity(SLOWEST, "rad/s"),
                    lowest = text::quantity(-SLOWEST, "rad/s")
                )),
        );
    }
    let harmonics = match values.get("harmonics") {
        Some(Value::Integer(h)) => usize::try_from(*h).ok(),
        _ => None,
    };
    let symmetry = match values.choice("symmetry") {
        Some("quarter") => Some(Symmetry::Quarter),
        Some("half") => Some(Symmetry::Half),
        Some("none") => Some(Symmetry::None),
        _ => None,
    };
    let whole = |name: &str, default: usize| values.integer(name).and_then(|i| usize::try_from(i).ok()).unwrap_or(default);
    let divisor = whole("subharmonic", 1);
    if let Some(h) = harmonics.filter(|&h| h < divisor) {
        diagnostics.push(
            Diagnostic::error(
                "response.harmonics",
                text!("order {h} of the base frequency does not reach the unbalance, which has order {divisor}", h, divisor),
            )
            .at(values.span_of("harmonics"))
            .help(text!("with subharmonic = n, orders count in steps of speed / n: keep at least n of them")),
        );
    }
    if let Some(by) = symmetry.filter(|s| *s != Symmetry::None && divisor.is_multiple_of(2)) {
        let message = text!(
            "motions of {divisor} turns of the rotor have no symmetry by a {symmetry}: only those of an odd number of turns do",
            divisor,
            symmetry = text::term(by.name())
        );
        diagnostics.push(
            Diagnostic::error("response.symmetry", message)
                .at(values.span_of("symmetry"))
                .help(text!("write symmetry = \"none\", or an odd number for subharmonic")),
        );
    }
    if diagnostics.0.len() > before {
        return None;
    }
    Some(Request {
        speeds: speeds?,
        harmonics,
        symmetry,
        divisor,
        truncation: values.number("truncation").unwrap_or(1e-7),
        stability: values.flag("stability").unwrap_or(true),
        determinant: false,
        sketch: false,
        max_points: whole("max_points", 2_000),
        states: if values.choice("states") == Some("all") { States::All } else { States::Main },
        work: u64::MAX,
        starts: whole("starts", 64),
        time_starts: whole("time_starts", 0),
        check_stability: values.flag("check_stability").unwrap_or(false),
    })
}

/// Whether a machine can answer a request at all.
pub(in crate::study) fn admit(system: &System, request: &Request) -> Result<(), Diagnostic> {
    if system.machine.drive == Drive::Free {
        return Err(Diagnostic::error(
            "response.free_drive",
            text!("a steady response is computed at constant speed, and the speed of this machine is free"),
        )
        .help(text!(
            "prescribe the speed of the machine (leave out its free drive), or follow the free machine in time with a transient study"
        )));
    }
    if request.states == States::All && request.time_starts > 0 {
        ensemble::admit(system, time_starts::method(system))?;
    }
    symmetry(system, request).map(|_| ())
}
