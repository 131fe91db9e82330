//! The supports of a machine at rest over the speed: load, place of the journal, oil film, and the eight coefficients about that state.
//!
//! Equations: `K = d(-F)/d(x, y)`, `C = d(-F)/d(x', y')` where the supports carry the weight; a rigid mass M on a support whirls at g where `K + i g C - M g^2` is singular.
//!
//! Symbols: F force on the turning body; x, y its displacement in the support; K, C stiffness and damping, row by row kxx kxy kyx kyy.
//!
//! Validity: small motions about the state at rest; constant speed; that of the law of each support, whose use is a finding.
//!
//! Theory: `docs/theory/oil-films.md`.
//!
//! Sources: J. W. Lund, K. K. Thomsen, ASME 1978 (threshold); each support names that of its law.

use super::operating::operating;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, RangeValue, Values};
use crate::model::part::Observed;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, End, Figure, Finding, Kept, Line, Message, Outcome, Panel, Table};
use crate::solve::characteristic::{Equilibrium, Frame};
use crate::solve::statics::bearing::{BearingState, bearing_state};
use crate::solve::statics::own;
use crate::solve::statics::supports::Support;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED_RANGE, beyond_rounding, inconsistent, largest, one_or_range, state_remarks};
use crate::study::shared::supporting;
use crate::study::{Context, Study};
use crate::text;
use laval_num::order::ascending;
use serde::{Deserialize, Serialize};

/// See the [module](self).
#[derive(Clone)]
pub struct BearingCoefficients {
    /// Speeds, rad/s.
    pub speed: RangeValue,
    /// Slots of the supports; all of the machine where it is empty.
    pub supports: Vec<usize>,
}

/// Speeds unless given.
const POINTS: usize = 60;
/// Difference of two speeds that is rounding, over one of them.
const SAME: f64 = 1e-9;
const NAMES: [&str; 8] = ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"];

impl Study for BearingCoefficients {
    type Result = CoefficientsResult;
    const KIND: &'static str = "bearing_coefficients";
    const EXAMPLE: &'static str = r#"speed = { from = "600 rpm", to = "6000 rpm" }
"#;
    const DOC: &'static str = "The supports of the machine at rest over the speed: the load that each carries, where its journal lies, eccentricity, attitude, least film and power of \
        oil films, the eight stiffness and damping coefficients about that state, and the rigid mass that begins to whirl on them.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] =
        &[Field::required("speed", SPEED_RANGE, "spin speeds, 60 unless their number is given, or one"), supporting::SUPPORTS];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let supports = supporting::read(values, system, diagnostics);
        let speed = one_or_range("speed", values.range("speed")?, 2, values, diagnostics)?;
        Some(BearingCoefficients { speed, supports: supports? })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        let parts = system.slots().iter().filter(|s| s.part.body().is_none()).count();
        Some(Size::of_rows(self.speed.points.unwrap_or(POINTS), 24 * parts))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.supported(system).map(drop)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<CoefficientsResult, Diagnostic> {
        let supports = self.supported(system)?;
        let mut speeds = self.speed.linspace(POINTS);
        let near = |a: f64, b: f64| (a - b).abs() <= SAME * b.abs();
        let operates = operating(system, self.speed.from, self.speed.to).map(|o| o.speed());
        speeds.extend(operates.filter(|w| !speeds.iter().any(|x| near(*x, *w))));
        ascending(&mut speeds);
        let mut out = CoefficientsResult { rows: Vec::new(), states: Vec::new(), refused: Vec::new(), end: End::Reached };
        let mut complete = true;
        for &speed in &speeds {
            if !context.goes_on(out.rows.len() as u64) {
                complete = false;
                break;
            }
            let Ok(at) = own(system, speed) else {
                out.refused.push(speed);
                continue;
            };
            for s in &supports {
                let Some(b) = bearing_state(system, s.slot, &at) else { continue };
                let spin = system.slots()[s.slot].speed(system.params(), speed);
                out.rows.push(Row::of(s.slot, (speed, spin), &b));
            }
            out.states.push((speed, at.q, at.z));
        }
        out.end = context.end(complete);
        // the state at one of the speeds was found before
        if out.rows.is_empty() && complete {
            own(system, self.speed.to)?;
        }
        Ok(out)
    }

    fn report(&self, system: &System, result: &CoefficientsResult, name: &str) -> Result<Outcome, Diagnostic> {
        Shown { system, result }.outcome(name)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

impl BearingCoefficients {
    /// The supports that have coefficients.
    fn supported(&self, system: &System) -> Result<Vec<Support>, Diagnostic> {
        let speed = operating(system, self.speed.from, self.speed.to).map_or(self.speed.to, |o| o.speed());
        let at = own(system, speed)?;
        let mut supports = supporting::of(system, &self.supports, &at);
        supports.retain(|s| bearing_state(system, s.slot, &at).is_some());
        if supports.is_empty() {
            return Err(Diagnostic::error("bearing_coefficients.none", text!("the machine has no support with coefficients"))
                .help(text!("a support is a part with stiffness between what turns and what does not; supports names others")));
        }
        Ok(supports)
    }
}

/// A support at a speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// Slot of the support.
    pub slot: usize,
    /// Speed of the machine, rad/s.
    pub speed: f64,
    /// Speed of the spin that turns in the support, rad/s.
    pub spin: f64,
    /// Force on the turning body, x and y, N.
    pub force: [f64; 2],
    /// Displacement of the turning body in the support, x and y, m.
    pub place: [f64; 2],
    /// kxx, kxy, kyx, kyy, N/m, then cxx, cxy, cyx, cyy, N s/m.
    pub coefficients: [f64; 8],
    /// Eccentricity over the clearance of a film; NaN of other supports.
    pub eccentricity: f64,
    /// Least thickness of a film, m; NaN of other supports.
    pub film: f64,
    /// Power that it takes from the spin, W; NaN of other supports.
    pub power: f64,
    /// Rigid mass from which on it whirls, kg, and the frequency of the whirl, rad/s; NaN where none does.
    pub threshold: [f64; 2],
}

impl Row {
    fn of(slot: usize, (speed, spin): (f64, f64), b: &BearingState) -> Row {
        let shown = |name: &str| b.observed.iter().find(|o| o.name == name).map_or(f64::NAN, |o| o.value);
        let [k, c] = [b.stiffness, b.damping];
        // a film without a load holds no mass, but for rounding
        let held = |mass: f64, frequency: f64| beyond_rounding(mass * frequency * frequency, largest(k.map(f64::abs)));
        let threshold = b.threshold().filter(|_| speed != 0.0);
        Row {
            slot,
            speed,
            spin,
            force: b.force,
            place: b.place,
            coefficients: [k[0], k[1], k[2], k[3], c[0], c[1], c[2], c[3]],
            eccentricity: shown(Observed::ECCENTRICITY),
            film: shown(Observed::FILM),
            power: shown(Observed::TORQUE) * spin,
            threshold: threshold.map_or([f64::NAN; 2], |t| [if held(t.mass, t.frequency) > 0.0 { t.mass } else { 0.0 }, t.frequency]),
        }
    }

    /// What it carries, N.
    fn load(&self) -> f64 {
        self.force[0].hypot(self.force[1])
    }

    /// Angle in the sense in which the journal turns from the load to the displacement, rad, above -pi and at most pi; NaN without a load.
    fn attitude(&self) -> f64 {
        let ([fx, fy], [x, y]) = (self.force, self.place);
        // the load is the opposite of the force on the journal
        let (along, across) = (-(fx * x + fy * y), -(fx * y - fy * x));
        let across = if self.spin < 0.0 { -across } else { across };
        if along == 0.0 && across == 0.0 { f64::NAN } else { across.atan2(along) }
    }
}

/// See the [module](self).
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CoefficientsResult {
    /// By speed, then support.
    pub rows: Vec<Row>,
    /// Speed, coordinates and internal states at rest.
    pub states: Vec<(f64, Vec<f64>, Vec<f64>)>,
    /// Speeds without a state at rest, rad/s.
    pub refused: Vec<f64>,
    /// How the study ended.
    pub end: End,
}

struct Shown<'a> {
    system: &'a System,
    result: &'a CoefficientsResult,
}

impl Shown<'_> {
    fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let mut outcome = Outcome::new(BearingCoefficients::KIND, name)
            .over("speed", "rad/s")
            .end(self.result.end)
            .work("states at rest", self.result.states.len() as u64);
        outcome = self.findings().into_iter().fold(outcome, Outcome::finding);
        outcome = outcome.table(self.table()?);
        if self.result.states.len() > 1 {
            outcome = outcome.figure(self.coefficients());
            if self.films() {
                outcome = outcome.figure(self.film());
            }
        }
        outcome.checked().map_err(inconsistent)
    }

    fn name(&self, slot: usize) -> &str {
        &self.system.slots()[slot].name
    }

    fn films(&self) -> bool {
        self.result.rows.iter().any(|r| r.eccentricity.is_finite())
    }

    /// The speed that findings speak of, among those computed: the operating speed, or the highest.
    fn speed(&self) -> Option<f64> {
        let (first, last) = (self.result.states.first()?.0, self.result.states.last()?.0);
        let wanted = self.system.machine.speed.filter(|w| (first * (1.0 - SAME)..=last * (1.0 + SAME)).contains(w)).unwrap_or(last);
        self.result.states.iter().map(|s| s.0).min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs()))
    }

    fn table(&self) -> Result<Table, Diagnostic> {
        let rows = &self.result.rows;
        let column = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("bearings", "Supports at rest over the speed")
            .leading()
            .names("bearing", "support", rows.iter().map(|r| self.name(r.slot).to_string()).collect())
            .float("speed", "rad/s", "spin speed", column(&|r| r.speed))
            .float("load", "N", "force that it carries", column(&Row::load))
            .float("x", "m", "displacement of the turning body in it", column(&|r| r.place[0]))
            .float("y", "m", "displacement of the turning body in it", column(&|r| r.place[1]))
            .float_if_any(
                "eccentricity",
                "",
                "eccentricity over the clearance; NaN of a support without a film",
                column(&|r| r.eccentricity),
            )
            .float(
                "attitude",
                "rad",
                "angle from the load to the displacement, in the sense of the rotation; NaN without a load",
                column(&Row::attitude),
            )
            .float_if_any("film", "m", "least thickness of the film; NaN of a support without one", column(&|r| r.film))
            .float_if_any("power", "W", "power that it takes from the spin; NaN of a support that shows none", column(&|r| r.power));
        for (k, name) in NAMES.into_iter().enumerate() {
            let (unit, doc) = if k < 4 { ("N/m", "stiffness") } else { ("N s/m", "damping") };
            table = table.float(name, unit, doc, column(&|r| r.coefficients[k]));
        }
        table
            .float("threshold_mass", "kg", "rigid mass on it from which on it whirls; NaN where none does", column(&|r| r.threshold[0]))
            .float(
                "whirl_ratio",
                "",
                "frequency of that whirl over the speed; NaN where none does",
                column(&|r| r.threshold[1] / r.spin.abs()),
            )
            .build()
            .map_err(inconsistent)
    }

    fn figure(&self, name: &'static str, title: &'static str, panels: impl IntoIterator<Item = Panel>) -> Figure {
        let alt = Message::new("bearing-coefficients-alt").arg("speeds", Arg::count(self.result.states.len()));
        let mut figure = Figure::new(name, title, alt).x(Axis::new("spin speed", "rad/s"));
        let (first, last) = (self.result.states[0].0, self.result.states[self.result.states.len() - 1].0);
        for panel in panels {
            figure = figure.panel(match operating(self.system, first, last) {
                Some(o) => panel.mark(o.rule()),
                None => panel,
            });
        }
        figure
    }

    fn coefficients(&self) -> Figure {
        let panels = ["kxx", "kyy", "kxy", "kyx", "cxx", "cyy"].map(|name| {
            let unit = if name.starts_with('k') { "N/m" } else { "N s/m" };
            Panel::new(Axis::new(name, unit)).height(0.7).mark(line(name))
        });
        self.figure("coefficients", "Coefficients of the supports over the speed", panels)
    }

    /// What the films of the machine show: a squeeze film has no thickness of its own, and without a load there is no angle.
    fn film(&self) -> Figure {
        let known = |of: fn(&Row) -> f64| self.result.rows.iter().any(|r| of(r).is_finite());
        let panels = [
            ("eccentricity over the clearance", "", "eccentricity", known(|r| r.eccentricity)),
            ("angle from the load", "rad", "attitude", known(Row::attitude)),
            ("least film thickness", "m", "film", known(|r| r.film)),
        ];
        let panels = panels.into_iter().filter(|p| p.3).map(|p| Panel::new(Axis::new(p.0, p.1)).mark(line(p.2)));
        self.figure("film", "Oil films over the speed", panels)
    }

    fn findings(&self) -> Vec<Finding> {
        let Some(speed) = self.speed() else { return Vec::new() };
        let mut out = Vec::new();
        for r in self.result.rows.iter().filter(|r| r.speed == speed) {
            let film = r.eccentricity.is_finite();
            let key = if film { "bearing-coefficients-film" } else { "bearing-coefficients-state" };
            let name = self.name(r.slot);
            let mut finding =
                Finding::info("bearing", key).of(name).value(r.load(), "N").arg("part", Arg::name(name)).arg("speed", Arg::speed(speed));
            if film {
                let attitude = Some(r.attitude()).filter(|a| a.is_finite());
                finding = finding
                    .arg("eccentricity", Arg::percent(r.eccentricity))
                    .arg("loaded", Arg::word(if attitude.is_some() { "yes" } else { "no" }))
                    .arg("attitude", Arg::quantity(attitude.unwrap_or(0.0), "rad"))
                    .arg("shows", Arg::word(if r.film.is_finite() && r.power.is_finite() { "film" } else { "nothing" }))
                    .arg("film", Arg::quantity(if r.film.is_finite() { r.film } else { 0.0 }, "m"))
                    .arg("power", Arg::quantity(if r.power.is_finite() { r.power } else { 0.0 }, "W"));
            } else {
                finding = finding.arg("x", Arg::quantity(r.coefficients[0], "N/m")).arg("y", Arg::quantity(r.coefficients[3], "N/m"));
            }
            out.push(finding.evidence("displacement of the turning body in it", r.place[0].hypot(r.place[1]), "m"));
            let [mass, frequency] = r.threshold;
            if mass.is_finite() {
                let finding = Finding::info("threshold", "bearing-coefficients-threshold")
                    .of(name)
                    .value(mass, "kg")
                    .arg("part", Arg::name(name))
                    .arg("share", Arg::percent(frequency / r.spin.abs()))
                    .arg("any", Arg::word(if mass > 0.0 { "some" } else { "all" }));
                out.push(finding.evidence("frequency of the whirl", frequency, "rad/s"));
            }
        }
        if let Some(last) = self.result.refused.last() {
            let count = self.result.refused.len();
            out.push(Finding::warning("no_rest", "bearing-coefficients-no-rest").arg("count", Arg::count(count)).value(*last, "rad/s"));
        }
        if let Some((speed, q, z)) = self.result.states.iter().find(|s| s.0 == speed) {
            let about = Equilibrium { q: q.clone(), z: z.clone(), ..Equilibrium::zero(self.system, Frame::Fixed, *speed) };
            out.extend(state_remarks(self.system, &about));
        }
        out
    }
}

/// One line for each support.
fn line(column: &'static str) -> Line {
    Line::new("bearings", "speed", column).group("bearing")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pushed down, a journal that turns from x to y lies at an angle between 0 and a quarter turn in that sense; on a spring it lies below the load.
    #[test]
    fn attitude_is_counted_from_the_load() {
        let row = |force: [f64; 2], place: [f64; 2]| Row {
            slot: 0,
            speed: 1.0,
            spin: 1.0,
            force,
            place,
            coefficients: [0.0; 8],
            eccentricity: 0.0,
            film: 0.0,
            power: 0.0,
            threshold: [0.0; 2],
        };
        assert!(row([0.0, 10.0], [0.0, -1.0]).attitude().abs() < 1e-15);
        assert!((row([0.0, 10.0], [1.0, -1.0]).attitude() - 0.25 * std::f64::consts::PI).abs() < 1e-15);
        assert!((row([0.0, 10.0], [-1.0, 0.0]).attitude() + 0.5 * std::f64::consts::PI).abs() < 1e-15);
        assert!(row([0.0; 2], [0.0; 2]).attitude().is_nan());
        // of a journal that turns from y to x the other way
        let turned = Row { spin: -1.0, ..row([0.0, 10.0], [-1.0, -1.0]) };
        assert!((turned.attitude() - 0.25 * std::f64::consts::PI).abs() < 1e-15);
    }
}
