//! Bifurcations of the steady response in the plane of spin speed and one parameter: loci of folds with their cusps, loci on which stability changes.
//!
//! Equations: folds `r = 0, (dr/dx) v = 0`; changes of stability `r = 0, Re lambda = 0` with the Floquet exponent lambda; both continued by arclength in
//! (harmonics, W, q). See [`crate::solve::harmonic::loci::search`].
//!
//! Symbols: W spin speed, rad/s; q the parameter; r the harmonic balance.
//!
//! Validity: as `nonlinear_response`: periodic motion at the spin frequency, reached from an end of the range of speeds at some of the values tried.
//!
//! Theory: `docs/theory/harmonic-balance.md#bifurcations`.
//!
//! Sources: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (SIAM 2000); Y. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004).

use super::free_motion::TRUNCATION;
use super::nonlinear_response::NonlinearResponseResult;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Value, Values};
use crate::model::system::{Drive, System};
use crate::outcome::{End, Outcome};
use crate::solve::harmonic::branches::response::{MOST_HARMONICS, Response};
use crate::solve::harmonic::loci::follow::PathEnd;
use crate::solve::harmonic::loci::search::{Loci, Request, loci_from};
use crate::solve::harmonic::stability::floquet::Stability;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::range;
use crate::study::{Context, Study};
use crate::text;
use laval_num::order::ascending;
use serde::{Deserialize, Serialize};

mod findings;
mod measured;
mod report;

pub use measured::Measured;

/// See the [module](self).
///
/// It can start from a response that was computed, or stored, before:
///
/// ```
/// use laval::prelude::*;
/// use laval::solve::harmonic::{branches::response, loci::search};
/// use laval::study::TypedStudy;
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let ground = || Link::Between(Attach::on("disc"), Attach::ground());
/// let machine = Builder::new("rotor")
///     .part("disc", Disc::planar(), DiscParams { eccentricity: 180e-6, ..DiscParams::new(2.0) })
///     .part("bearing", BearingCubic::isotropic(ground()), BearingCubicParams::new([1e6; 2], [3e10; 2]))
///     .part("air", Damper::fixed(ground()), DamperParams::new([100.0; 2]))
///     .build()?;
/// let request = response::Request { stability: false, ..response::Request::over(300.0, 2000.0) };
/// let response = NonlinearResponse::new(request).result(&machine, &Context::quiet("response"))?;
/// let request = search::Request {
///     stability: false,
///     ..search::Request::over((300.0, 2000.0), "disc.eccentricity", (100e-6, 200e-6))
/// };
/// let study = BifurcationLoci::new(request).with_response(&machine, &response);
/// let loci = study.result(&machine, &Context::quiet("loci"))?.found;
/// // the only response it has is that one; both its folds lie on one locus, with a cusp
/// assert_eq!((loci.samples.len(), loci.samples[0].folds, loci.loci.len()), (1, 2, 1));
/// assert!(loci.loci[0].corners[0].turn.speed_turns);
/// # Ok(()) }
/// ```
pub struct BifurcationLoci {
    request: Request,
    /// Responses at some of the values.
    known: Vec<(f64, Response)>,
}

impl BifurcationLoci {
    /// The study that answers this request.
    pub fn new(request: Request) -> Self {
        BifurcationLoci { request, known: Vec::new() }
    }

    /// Starts at the bifurcations of a response of this machine too: at the machine's own value of the parameter, which is added to the values of the
    /// request, no response is computed. Changes of stability are there where it was assessed. Without such a value nothing changes.
    pub fn with_response(mut self, system: &System, result: &NonlinearResponseResult) -> Self {
        let own = system.param(&self.request.parameter).and_then(|i| system.params().get(*i.first()?).copied());
        if let Some(value) = own.filter(|x| (self.request.range.0..=self.request.range.1).contains(x)) {
            if !self.request.values.contains(&value) {
                self.request.values.push(value);
                ascending(&mut self.request.values);
            }
            self.known.push((value, result.response.clone()));
        }
        self
    }
}

/// Smallest spin speed, rad/s: the unbalance needs a turn to act.
const SLOWEST: f64 = 1e-3;

/// Most values at which responses are computed.
const MOST_VALUES: usize = 200;

impl Study for BifurcationLoci {
    type Result = BifurcationLociResult;
    const KIND: &'static str = "bifurcation_loci";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm" }
parameter = { parameter = "drum.eccentricity", from = "1 um", to = "100 um", points = 5 }
"#;
    const DOC: &'static str = "Where jumps and other bifurcations of the steady response lie when one parameter changes: loci of folds in the plane of spin \
        speed and parameter, with the cusps in which jumps begin, and loci on which states lose or regain their stability (Neimark-Sacker, period doubling, \
        symmetry breaking). They are followed from the bifurcations of the response at some values of the parameter.";
    const FIELDS: &'static [Field] = &[
        Field::required(
            "speed",
            FieldKind::Range { unit: "rad/s", bounds: Bounds::within(1e7) },
            "range of the spin speed; negative speeds turn clockwise",
        ),
        Field::required(
            "parameter",
            FieldKind::ParameterRange,
            "the parameter, and its range; points is the number of values at which the response is computed to find starts, 5 unless given",
        ),
        Field::optional(
            "kinds",
            FieldKind::Choice(&[
                ("all", "folds and changes of stability"),
                ("folds", "folds alone"),
                ("stability", "changes of stability away from folds alone"),
            ]),
            "all",
            "which bifurcations are followed",
        ),
        Field::optional(
            "harmonics",
            FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS as i64 },
            "auto",
            "largest order of the spin frequency kept; auto raises it until the dropped force is below truncation",
        ),
        TRUNCATION,
        Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of a locus, and of a branch"),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let speeds = values.range("speed").and_then(|r| range("speed", r, 0, values, diagnostics)).map(|s| (s.from, s.to));
        if speeds.is_some_and(|(lo, hi)| !(lo >= SLOWEST || hi <= -SLOWEST)) {
            diagnostics.push(
                Diagnostic::error("loci.standstill", text!("the range of speeds comes too near to standstill, where no unbalance acts"))
                    .at(values.span_of("speed"))
                    .help(text!(
                        "keep both ends above {slowest}, or both below {lowest} for rotation the other way round",
                        slowest = text::quantity(SLOWEST, "rad/s"),
                        lowest = text::quantity(-SLOWEST, "rad/s")
                    )),
            );
        }
        let mut parameter = None;
        if let Some((path, given)) = values.parameter_range("parameter") {
            let given = range("parameter", given, 2, values, diagnostics);
            if system.param(path).is_none() {
                diagnostics.push(system.unknown_param(path).at(values.span_of("parameter")));
            }
            if let Some(points) = given.and_then(|g| g.points).filter(|&p| p > MOST_VALUES) {
                diagnostics.push(
                    Diagnostic::error("study.range", text!("the response at {points} values is too much", points))
                        .at(values.span_of("parameter"))
                        .help(text!("points is the number of values at which loci are started: at most {most}", most = MOST_VALUES)),
                );
            }
            parameter = given.map(|g| (path.to_string(), g));
        }
        if diagnostics.0.len() > before {
            return None;
        }
        let (parameter, given) = parameter?;
        let harmonics = match values.get("harmonics") {
            Some(Value::Integer(h)) => usize::try_from(*h).ok(),
            _ => None,
        };
        let kinds = values.choice("kinds").unwrap_or("all");
        Some(BifurcationLoci::new(Request {
            speeds: speeds?,
            parameter,
            range: (given.from, given.to),
            values: given.linspace(5),
            folds: kinds != "stability",
            stability: kinds != "folds",
            harmonics,
            truncation: values.number("truncation").unwrap_or(1e-7),
            max_points: values.integer("max_points").and_then(|i| usize::try_from(i).ok()).unwrap_or(2_000),
            work: u64::MAX,
        }))
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.request.speeds.0, self.request.speeds.1)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(Size::of_branch(self.request.max_points, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "loci.free_drive",
                text!("a steady response is computed at constant speed, and the speed of this machine is free"),
            )
            .help(text!("prescribe the speed of the machine: leave out its free drive")));
        }
        let path = &self.request.parameter;
        if self.request.values.iter().all(|&x| system.with(&[(path, x)]).is_err()) {
            let x = self.request.range.0;
            let at = text::quantity(x, unit(system, path).to_string());
            let message = match system.with(&[(path, x)]) {
                Err(d) => {
                    let why = d.into_error().message;
                    text!("the machine does not exist at any value tried of {path}; at {at}: {why}", path, at, why)
                }
                Ok(_) => text!("the machine does not exist at any value tried of {path}", path),
            };
            return Err(Diagnostic::error("loci.parameter", message).help(text!("choose another range of the parameter")));
        }
        if !self.request.folds
            && let Err(why) = Stability::new(system)
        {
            return Err(Diagnostic::error(
                "loci.stability",
                text!("the stability of this machine's motions cannot be assessed: {why}", why),
            )
            .help(text!("kinds = \"folds\" needs no stability")));
        }
        Ok(())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<BifurcationLociResult, Diagnostic> {
        self.admit(system)?;
        let request = Request { work: context.work_limit, ..self.request.clone() };
        let found = loci_from(system, &request, &self.known, context.cancel, &|done| context.progress.report(done, 0))?;
        let [points, corners] = measured::measured(system, &request, &found)?;
        let ends = || found.loci.iter().flat_map(|l| &l.ends);
        let end = match () {
            () if found.stopped => context.end(false),
            () if ends().any(|e| *e == PathEnd::MaxPoints) => End::MaxPoints,
            () => End::Reached,
        };
        Ok(BifurcationLociResult { found, points, corners, end })
    }

    fn report(&self, system: &System, result: &BifurcationLociResult, name: &str) -> Result<Outcome, Diagnostic> {
        report::Shown::new(system, &self.request, result).outcome(name, result.end).map_err(Diagnostic::from)
    }
}

/// Loci, and how far the motions on them go.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BifurcationLociResult {
    /// Loci, the responses they start from, and where the machine exists.
    pub found: Loci,
    /// By locus and point.
    pub points: Vec<Vec<Measured>>,
    /// By locus and place where it turns back in the parameter.
    pub corners: Vec<Vec<Measured>>,
    /// How the study ended.
    pub end: End,
}

/// Unit of a parameter.
fn unit(system: &System, path: &str) -> &'static str {
    system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or("", |s| s.unit)
}
