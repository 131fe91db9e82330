//! Stability of the lateral modes over a cross-coupled stiffness at a place of the machine, and the stiffness at which it becomes unstable: the level 1 stability analysis of API 684 and API 617.
//!
//! Equations: `Fx = -q y`, `Fy = q x` on a point of the machine; `det T(s; q) = 0` for q from 0 on, each root followed by its exact derivative; `Re s(q0) = 0` at the threshold q0. Logarithmic
//! decrement `-2 pi growth/frequency`.
//!
//! Symbols: q cross-coupled stiffness kxy = -kyx, N/m; q0 its threshold; qa the one that is anticipated; s = growth + i frequency; critical speed ratio: speed over the first undamped critical
//! speed on rigid supports.
//!
//! Validity: small motions about the equilibrium without q, at one speed; the coefficients of the bearings do not change with q.
//!
//! Theory: `docs/theory/linear-vibration.md#cross-coupled-stiffness`.
//!
//! Sources: API 684 (2nd edition), SP6.8.5 (level 1: log decrement over Q at midspan, Q0, Qa; criteria in SP6.8.5.10). Regions of gas density: as [`region`] cites.

pub mod region;
mod report;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Attach, Bounds, Field, FieldKind, Values, Word};
use crate::model::system::System;
use crate::outcome::{End, Kept, Outcome};
use crate::solve::characteristic::Equilibrium;
use crate::solve::cross_coupling::{Coupled, Lines, Point, Start};
use crate::solve::rest::rest;
use crate::study::shared::place;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{About, SPEED, admit_roots, speed};
use crate::study::shared::supporting;
use crate::study::{Context, Study};
use crate::text;
use region::RigidLimit;
use serde::{Deserialize, Serialize};

/// See the [module](self).
#[derive(Clone)]
pub struct StabilityThreshold {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Where the stiffness acts.
    pub place: Attach,
    /// Largest stiffness, N/m; from the derivatives at 0 where it is not given.
    pub up_to: Option<f64>,
    /// Values of the stiffness.
    pub points: usize,
    /// In equal ratios over [`DECADES`], and 0; otherwise in equal steps.
    pub logarithmic: bool,
    /// The stiffness that is expected, N/m.
    pub anticipated: Option<f64>,
    /// Average of the gas densities at suction and discharge, kg/m^3.
    pub gas_density: Option<f64>,
    /// Slots of the supports that are rigid in the critical speed ratio; all of the machine where it is empty.
    pub supports: Vec<usize>,
    /// Modes followed.
    pub modes: usize,
}

/// Powers of ten below the largest value in equal ratios.
pub const DECADES: f64 = 3.0;
/// The largest value, where it is not given, over the first threshold by the derivatives, and over the stiffness that is expected.
const BEYOND: f64 = 1.5;

/// A largest value proposed over 1.5 times the threshold found from which on a nearer one is taken.
const FAR: f64 = 3.0;

const POINTS: i64 = 40;
const MODES: i64 = 4;
const STIFFNESS: FieldKind = FieldKind::Quantity { unit: "N/m", bounds: Bounds::positive(1e14) };
const GAS_DENSITY: FieldKind = FieldKind::Quantity { unit: "kg/m^3", bounds: Bounds::positive(1e4) };
const SPACINGS: &[Word] = &[("linear", "equal steps"), ("logarithmic", "0, and equal ratios over three powers of ten")];

impl Study for StabilityThreshold {
    type Result = ThresholdResult;
    const KIND: &'static str = "stability_threshold";
    const EXAMPLE: &'static str = r#"place = "drum"
up_to = "1e7 N/m"
anticipated = "1e6 N/m"
"#;
    const DOC: &'static str = "How much cross-coupled stiffness (kxy = -kyx, of seals or impellers) at a place of the machine it bears before a lateral mode becomes unstable: the \
        level 1 stability analysis of API 684 and API 617. The logarithmic decrement of the modes over the stiffness, each mode followed by its derivative, with the threshold solved for; on \
        request the criteria of level 1 at the stiffness that is anticipated. Pedestals and masses stay.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required(
            "place",
            FieldKind::Attach { ground: false },
            "point of a body on which the stiffness acts; level 1 takes the middle between the bearings",
        ),
        Field::optional("speed", SPEED, "", "spin speed; the machine's when left out"),
        Field::optional(
            "up_to",
            STIFFNESS,
            "",
            "largest cross-coupled stiffness; when left out, 1.5 times the larger of the anticipated one and the threshold",
        ),
        Field::optional("points", FieldKind::Integer { min: 2, max: 10_000 }, "40", "values of the stiffness, 0 among them"),
        Field::optional("spacing", FieldKind::Choice(SPACINGS), "linear", "how the values of the stiffness are spaced"),
        Field::optional("anticipated", STIFFNESS, "", "cross-coupled stiffness that is anticipated, for the criteria of level 1"),
        Field::optional(
            "gas_density",
            GAS_DENSITY,
            "",
            "average of the gas densities at suction and discharge, for the criterion of level 1 on gas density and critical speed ratio; with anticipated",
        ),
        supporting::SUPPORTS,
        Field::optional(
            "modes",
            FieldKind::Integer { min: 1, max: 100 },
            "4",
            "modes followed: those that the stiffness makes unstable first, by their derivatives at 0; the first forward mode is followed as well",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let place = place::read("place", values, system, diagnostics);
        let speed = speed(values, system, diagnostics);
        let supports = supporting::read(values, system, diagnostics);
        let (up_to, anticipated) = (values.number("up_to"), values.number("anticipated"));
        if let (Some(up_to), Some(anticipated)) = (up_to, anticipated)
            && up_to < anticipated
        {
            let message = text!("up_to is below the anticipated stiffness {anticipated}", anticipated = text::quantity(anticipated, "N/m"));
            let help = text!("give a larger up_to, or leave it out");
            diagnostics.push(Diagnostic::error("stability_threshold.up_to", message).at(values.span_of("up_to")).help(help));
            return None;
        }
        let gas_density = values.number("gas_density");
        if gas_density.is_some() && anticipated.is_none() {
            let message = text!("{way} needs {field} beside it", way = "gas_density", field = "anticipated");
            let help = text!("add {field}", field = "anticipated");
            diagnostics.push(Diagnostic::error("stability_threshold.gas_density", message).at(values.span_of("gas_density")).help(help));
            return None;
        }
        Some(StabilityThreshold {
            speed: speed?,
            place: place?,
            up_to,
            points: values.integer("points").unwrap_or(POINTS).clamp(2, 10_000) as usize,
            logarithmic: values.choice("spacing") == Some("logarithmic"),
            anticipated,
            gas_density,
            supports: supports?,
            modes: values.integer("modes").unwrap_or(MODES).clamp(1, 100) as usize,
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::one(self.speed)]
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_roots(system, About::Rest, self.speed)?;
        self.coupled(system).map(drop)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<ThresholdResult, Diagnostic> {
        self.admit(system)?;
        let coupled = self.coupled(system)?;
        let mut starts = coupled.modes()?;
        if starts.is_empty() {
            return Err(Diagnostic::error("stability_threshold.no_mode", text!("no lateral mode of this machine oscillates"))
                .help(text!("cross-coupled stiffness makes lateral modes unstable: modes lists those of the machine")));
        }
        let modes = starts.len();
        let first = starts.iter().map(Start::estimate).filter(|q| *q > 0.0 && q.is_finite()).fold(f64::INFINITY, f64::min);
        let mut values = self.values(Some(first).filter(|q| q.is_finite()))?;
        // those that grow without it are of interest, too
        let growing = starts.iter().filter(|s| s.at.value.re >= 0.0).count();
        let kept = self.modes.max(growing);
        let mut forward = first_forward(&starts);
        if let Some(k) = forward.filter(|k| *k >= kept) {
            starts.swap(k, kept);
            forward = Some(kept);
            starts.truncate(kept + 1);
        } else {
            starts.truncate(kept);
        }
        let total = values.len() as u64;
        context.announce((total * starts.len() as u64) as f64, 100_000.0, text!("roots to follow"));
        let each = |done: u64| {
            context.progress.report(done, total);
            context.goes_on(done)
        };
        let (mut lines, mut complete) = coupled.follow(&starts, &values, each)?;
        // on unequal springs the derivative at 0 says little of the threshold
        let found = lines.first_onset().filter(|q| self.up_to.is_none() && complete && *q > 0.0);
        if let Some(q) = found.filter(|q| FAR * q.max(self.anticipated.unwrap_or(0.0)) < values[values.len() - 1]) {
            values = self.values(Some(q))?;
            (lines, complete) = coupled.follow(&starts, &values, each)?;
        }
        lines.modes = modes;
        let about = rest(system, self.speed)?;
        let body = self.place.body.as_deref();
        let rigid = self.anticipated.and(self.gas_density).map(|_| region::rigid_limit(system, &self.supports, body, self.speed));
        Ok(ThresholdResult { lines, forward, values, about, rigid, end: context.end(complete) })
    }

    fn report(&self, system: &System, result: &ThresholdResult, name: &str) -> Result<Outcome, Diagnostic> {
        report::Shown { study: self, system, result }.outcome(name)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// The first forward mode, whose decrement the criteria of level 1 assess: the lowest of those that move at the place, that whirl forward for the larger part or that the stiffness drives,
/// and that are less than half critically damped.
fn first_forward(all: &[Start]) -> Option<usize> {
    let driven = all.iter().enumerate().filter(|(_, s)| {
        let Point { value, slope, .. } = s.at;
        s.moves() && (slope.re > 0.0 || s.mode.forward_share > 0.5) && -value.re < 0.5 * value.abs()
    });
    driven.min_by(|a, b| a.1.at.value.im.total_cmp(&b.1.at.value.im)).map(|x| x.0)
}

impl StabilityThreshold {
    fn coupled(&self, system: &System) -> Result<Coupled, Diagnostic> {
        Coupled::new(system, &self.place, self.speed).map_err(Diagnostics::into_error)
    }

    /// Values of the stiffness, 0 first, with the anticipated one among them; up to beyond a threshold where the largest is not given.
    fn values(&self, threshold: Option<f64>) -> Result<Vec<f64>, Diagnostic> {
        let own = [threshold, self.anticipated].into_iter().flatten().fold(0.0, f64::max);
        let up_to = self.up_to.unwrap_or(BEYOND * own);
        if !(up_to > 0.0 && up_to.is_finite()) {
            return Err(Diagnostic::error(
                "stability_threshold.up_to",
                text!("no mode becomes less stable with the stiffness, so that there is no largest one to propose"),
            )
            .help(text!("give up_to")));
        }
        let last = self.points - 1;
        let one = |k: usize| match (k, self.logarithmic) {
            (0, _) => 0.0,
            (k, _) if k == last => up_to,
            (k, false) => up_to * k as f64 / last as f64,
            (k, true) => up_to * 10f64.powf(-DECADES * (last - k) as f64 / (last - 1).max(1) as f64),
        };
        let mut out: Vec<f64> = (0..=last).map(one).collect();
        if let Some(q) = self.anticipated.filter(|q| !out.contains(q)) {
            out.insert(out.partition_point(|x| *x < q), q);
        }
        Ok(out)
    }
}

/// Modes over the cross-coupled stiffness.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ThresholdResult {
    /// The modes, their thresholds, and the counts.
    pub lines: Lines,
    /// The first forward mode among them.
    pub forward: Option<usize>,
    /// Values of the stiffness, N/m.
    pub values: Vec<f64>,
    /// State linearised about.
    pub about: Equilibrium,
    /// First critical speed on rigid supports, where the gas density is given.
    pub rigid: Option<RigidLimit>,
    /// How the study ended.
    pub end: End,
}

/// Logarithmic decrement of a mode; NaN of one that does not oscillate.
pub fn decrement(p: &Point) -> f64 {
    if p.value.im > 0.0 { -std::f64::consts::TAU * p.value.re / p.value.im } else { f64::NAN }
}
