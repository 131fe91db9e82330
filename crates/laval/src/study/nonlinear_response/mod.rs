//! The steady response to unbalance of a machine with nonlinear parts, over a range of speeds.
//!
//! Equations: harmonic balance of the assembled residual, linear parts exact at every order; see [`crate::solve::harmonic`].
//!
//! Symbols: W spin speed, rad/s; Z_n complex amplitude of order n of a body's `x + i y`, m.
//!
//! Validity: periodic motion at the spin frequency (or its submultiple); a motion that has lost its stability is shown, not followed.
//!
//! With all states the search combines the planes of known states, switches branches at bifurcations, and starts from subharmonic and from arbitrary
//! motions (see [`crate::solve::harmonic::families`]).
//!
//! Sources: `000_a291f7ede1484e56` chapters 1 and 2 (averaging, harmonic balance); M. Urabe (1965) for the Galerkin form.

use super::support::range;
use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Value, Values};
use crate::model::system::{Drive, System};
use crate::outcome::Outcome;
use crate::solve::harmonic::response::{MOST_HARMONICS, Request, States, respond, symmetry};
use crate::solve::symmetry::Symmetry;
use shown::Shown;

mod families;
mod findings;
mod forces;
mod largest;
mod picture;
mod self_centring;
mod shown;
mod stability;
mod tables;
mod tuning;

/// See the [module](self).
pub struct NonlinearResponse {
    request: Request,
}

impl NonlinearResponse {
    /// The study that answers this request.
    pub fn new(request: Request) -> Self {
        NonlinearResponse { request }
    }
    /// What is asked.
    pub fn request(&self) -> &Request {
        &self.request
    }
}

const SPEED: Bounds = Bounds::within(1e7);

/// Smallest spin speed, rad/s: the unbalance needs a turn to act.
const SLOWEST: f64 = 1e-3;

impl Study for NonlinearResponse {
    const KIND: &'static str = "nonlinear_response";
    const DOC: &'static str = "Steady response to unbalance over a range of speeds, with the states the machine can settle in: branches followed \
        from both ends, folds (where a slow sweep jumps) and other bifurcations located, stability of every point; on request also mixed, less symmetric \
        and subharmonic states.";
    const FIELDS: &'static [Field] = &[
        Field::required(
            "speed",
            FieldKind::Range { unit: "rad/s", bounds: SPEED },
            "range of the spin speed; negative speeds turn clockwise",
        ),
        Field::optional(
            "harmonics",
            FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS as i64 },
            "auto",
            "largest order of the spin frequency kept; auto raises it until the dropped force is below truncation",
        ),
        Field::optional(
            "truncation",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-15, 1.0) },
            "1e-7",
            "dropped over kept force harmonics that auto accepts",
        ),
        Field::optional(
            "symmetry",
            FieldKind::Choice(&[
                ("auto", "the largest symmetry the machine has"),
                ("quarter", "z(t + T/4) = i z(t): orders 1, -3, 5, -7"),
                ("half", "z(t + T/2) = -z(t): odd orders"),
                ("none", "all orders"),
            ]),
            "auto",
            "symmetry imposed on the motion; less symmetry admits more states",
        ),
        Field::optional("subharmonic", FieldKind::Integer { min: 1, max: 9 }, "1", "period sought, in turns of the rotor"),
        Field::optional("stability", FieldKind::Flag, "true", "judge the stability of every point"),
        Field::optional(
            "check_stability",
            FieldKind::Flag,
            "false",
            "judge some states again by Hill's method and by a second map over the period",
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
        Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of a branch"),
    ];

    fn build(values: &Values, _: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let speeds = range("speed", values.range("speed")?, 0, values, diagnostics).map(|s| (s.from, s.to));
        if speeds.is_some_and(|(lo, hi)| !(lo >= SLOWEST || hi <= -SLOWEST)) {
            diagnostics.push(
                Diagnostic::error("response.standstill", "the range of speeds contains standstill, where no unbalance acts")
                    .at(values.span_of("speed"))
                    .help(format!("keep both ends above {SLOWEST} rad/s, or both below -{SLOWEST} rad/s for rotation the other way round")),
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
                    format!("order {h} of the base frequency does not reach the unbalance, which has order {divisor}"),
                )
                .at(values.span_of("harmonics"))
                .help("with subharmonic = n, orders count in steps of speed / n: keep at least n of them"),
            );
        }
        if diagnostics.0.len() > before {
            return None;
        }
        Some(NonlinearResponse {
            request: Request {
                speeds: speeds?,
                harmonics,
                symmetry,
                divisor,
                truncation: values.number("truncation").unwrap_or(1e-7),
                stability: values.flag("stability").unwrap_or(true),
                max_points: whole("max_points", 2_000),
                states: if values.choice("states") == Some("all") { States::All } else { States::Main },
                starts: whole("starts", 64),
                check_stability: values.flag("check_stability").unwrap_or(false),
            },
        })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "response.free_drive",
                "a steady response is computed at constant speed, and the speed of this machine is free",
            )
            .help(
                "prescribe the speed of the machine (leave out its free drive), or follow the free machine in time with a transient study",
            ));
        }
        symmetry(system, &self.request).map(|_| ())
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        self.admit(system)?;
        let mut request = self.request;
        request.max_points = request.max_points.min(usize::try_from(context.work_limit).unwrap_or(usize::MAX)).max(2);
        let response = respond(system, &request, context.cancel, &|done| context.progress.report(done, 0))?;
        let mut shown = Shown::new(system, &response, &request)?;
        shown.measure(&response);
        (shown.largest, shown.rising) = shown.peaks(&response, &request);
        shown.forces = shown.extreme_forces(&response, &request);
        shown.centring = shown.centring(&response);
        shown.tuned = shown.tuning(&response, &request);
        shown.outcome(&response, &request, context).map_err(Diagnostic::from)
    }
}
