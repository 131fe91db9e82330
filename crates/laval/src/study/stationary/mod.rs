//! States at rest in axes that turn with the rotor, over a range of speeds: where a machine with movable masses balances itself, and where it does not.
//!
//! Equations: `r(q, W) = 0` with vectors turning and everything else constant; see [`crate::solve::stationary`]. Eigenvalues about a state are those of the
//! machine in turning axes, exact in memory and frequency-domain parts.
//!
//! Symbols: W spin speed; s = growth + i frequency in turning axes, 1/s and rad/s.
//!
//! Validity: constant speed; a machine that is the same in all directions, without weight across its axis. No number of starts proves that the list of
//! states is complete; states that are not isolated (three and more equal balls that balance in a continuum of ways) are not listed.
//!
//! Sources: `theory/ball-balancer.md` sections 5 to 8; K. Green, A. R. Champneys, N. J. Lieven, J. Sound Vib. 291 (2006) 861.

mod classify;
mod least;
mod report;

use super::support::{SPEED, SPEED_RANGE, range};
use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values};
use crate::model::system::{Drive, System};
use crate::outcome::Outcome;
use crate::solve::stationary::{Found, Request, Search, Stability, State};
use crate::solve::symmetry::probed_speeds;
use crate::solve::turning::isotropic;
use classify::{Class, Seen};

/// See the [module](self).
pub struct Stationary {
    speed: RangeValue,
    starts: usize,
    seeds: usize,
    max_points: usize,
    stabilise: Option<Stabilise>,
}

/// A parameter that is to make the balanced state stable.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stabilise {
    /// Path.
    pub path: String,
    /// Values, in the unit of the parameter.
    pub range: RangeValue,
    /// Speed, rad/s.
    pub speed: f64,
}

/// Speeds of the table of states when none are given.
const POINTS: usize = 21;

impl Study for Stationary {
    const KIND: &'static str = "stationary";
    const DOC: &'static str = "States at rest in axes that turn with the rotor: all that are found from many starts, followed over the speed and \
        classified (balanced, partly balanced, masses together, opposed, locked by a tilt), with eigenvalues, limits of existence and the speeds where stability \
        changes; on request the least value of a parameter, such as external damping, that makes the balanced state stable.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "speeds over which states are followed; points: number of speeds in the table of states"),
        Field::optional(
            "starts",
            FieldKind::Integer { min: 1, max: 10_000 },
            "100",
            "starts at each of the speeds at which states are sought",
        ),
        Field::optional("seeds", FieldKind::Integer { min: 1, max: 100 }, "5", "number of these speeds"),
        Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of one branch"),
        Field::optional(
            "stabilise",
            FieldKind::ParameterRange,
            "",
            "parameter and range in which the values are sought that make the balanced state stable, for instance an external damping",
        ),
        Field::optional("stabilise_at", SPEED, "", "speed at which it is to be stable; the machine's when left out"),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = values.range("speed").and_then(|r| range("speed", r, 2, values, diagnostics));
        let whole = |name: &str, default: usize| values.integer(name).and_then(|n| usize::try_from(n).ok()).unwrap_or(default);
        let at = values.number("stabilise_at").or(system.machine.speed);
        let mut sound = true;
        let stabilise = values.parameter_range("stabilise").and_then(|(path, given)| {
            let found = range("stabilise", given, 2, values, diagnostics);
            if system.param(path).is_none() {
                diagnostics.push(system.unknown_param(path).at(values.span_of("stabilise")));
            } else if let (Some(range), Some(speed)) = (found, at) {
                return Some(Stabilise { path: path.into(), range, speed });
            } else if at.is_none() {
                diagnostics.push(
                    Diagnostic::error("stationary.speed", "stabilise needs the speed at which the state is to be stable")
                        .at(values.span_of("stabilise"))
                        .help("give stabilise_at = \"3000 rpm\", or a speed in [machine]"),
                );
            }
            sound = false;
            None
        });
        let speed = speed.filter(|_| sound)?;
        Some(Stationary { speed, starts: whole("starts", 100), seeds: whole("seeds", 5), max_points: whole("max_points", 2000), stabilise })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "stationary.drive",
                "stationary states are sought at given speeds, and the speed of this machine is free",
            )
            .help("prescribe the speed of the machine, or follow the free machine in time with a transient study"));
        }
        let all = probed_speeds((self.speed.from, self.speed.to)).into_iter().chain(self.stabilise.as_ref().map(|s| s.speed));
        all.map(|w| isotropic(system, w)).collect::<Result<Vec<()>, _>>()?;
        crate::solve::pencil::time_forms(system).map(drop)
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        Study::admit(self, system)?;
        let request = self.request(context);
        let mut search = Search::new(system, &request, context.cancel);
        let total = (request.seeds.len() * request.starts) as u64;
        let found = search.run(|done| {
            context.progress.report(done.min(total), total);
            context.goes_on(done)
        })?;
        let mut rows = Vec::new();
        for speed in self.speed.linspace(POINTS) {
            if !context.goes_on(found.work) {
                break;
            }
            rows.extend(listed(system, &mut search, &found, speed)?);
        }
        let least = match &self.stabilise {
            Some(s) if context.goes_on(found.work) => Some(least::least(system, s, &request, context)?),
            _ => None,
        };
        report::Report {
            system,
            search: &search,
            range: (self.speed.from, self.speed.to),
            found: &found,
            rows,
            stabilise: self.stabilise.as_ref(),
            least,
        }
        .outcome(context)
    }
}

impl Stationary {
    fn request(&self, context: &Context) -> Request {
        let (a, b) = (self.speed.from, self.speed.to);
        // ends and middle matter most; irregular places see what a regular grid would step over
        let mut seeds: Vec<f64> = (0..self.seeds).map(|k| a + (b - a) * (0.5 + 0.618_033_988_749_895 * k as f64).fract()).collect();
        seeds.sort_by(f64::total_cmp);
        Request { range: (a, b), starts: self.starts, seeds, max_points: self.max_points, work: context.work_limit }
    }
}

/// A state of the table.
pub(super) struct Row {
    pub state: State,
    pub class: Class,
    pub seen: Seen,
    pub stability: Stability,
}

/// The states at a speed, classified among each other.
fn listed(system: &System, search: &mut Search, found: &Found, speed: f64) -> Result<Vec<Row>, Diagnostic> {
    let states = found.states(search, speed);
    let seen: Vec<Seen> = states.iter().map(|s| Seen::of(system, search, s)).collect();
    let scale = Seen::largest(&seen);
    states
        .into_iter()
        .zip(seen)
        .map(|(state, seen)| {
            let stability = search.stability(&state.x, state.speed)?;
            Ok(Row { class: seen.class(&scale), state, seen, stability })
        })
        .collect()
}
