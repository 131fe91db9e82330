//! Linear response to unbalance over the spin speed: orbits, phases and forces of all bodies, resonances and antiresonances.
//!
//! Equations: `T(i W, W) X = F` with the forces that turn with the rotor; frequency-domain parts and memory states enter exactly. The motion of a
//! point is `x + i y = f exp(i phase) + b exp(-i phase)`; its orbit has the semi-axes `|f| + |b|` and `||f| - |b||`.
//!
//! Symbols: W spin speed, rad/s; X complex amplitudes; f, b forward and backward amplitude, m.
//!
//! Validity: motions small enough for the tangent of nonlinear parts at rest; constant speed.
//!
//! Sources: `theory/planar-rotor.md` sections 5 and 9.

use super::support::{SPEED_RANGE, inconsistent, range, remarks};
use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, RangeValue, Values};
use crate::model::part::At;
use crate::model::system::{System, Workspace};
use crate::outcome::{Axis, End, Figure, Finding, Line, Outcome, Panel, Points, SpecialPoint, Table, quantity};
use crate::solve::characteristic::Characteristic;
use crate::solve::extrema::{Curve, Extremum, curve, seeds};
use crate::solve::linear_response::{Response, response};
use crate::solve::pencil::time_forms;
use crate::solve::rest::rest;
use laval_num::complex::{C64, c};
use std::collections::BTreeMap;

/// See the [module](self).
pub struct ForcedResponse {
    /// Speeds, rad/s.
    pub speed: RangeValue,
}

impl Study for ForcedResponse {
    const KIND: &'static str = "forced_response";
    const DOC: &'static str = "Linear unbalance response over the spin speed: amplitude and phase of every body, forces of linear parts, with \
        resonances and antiresonances located. Nonlinear parts enter by their tangent at rest; nonlinear_response keeps them whole.";
    const FIELDS: &'static [Field] =
        &[Field::required("speed", SPEED_RANGE, "spin speeds; points (400 unless given) are added where the response bends")];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = range("speed", values.range("speed")?, 3, values, diagnostics)?;
        if system.bodies().is_empty() {
            diagnostics.push(Diagnostic::error("forced_response.no_body", "no body of this machine moves across the axis"));
            return None;
        }
        Some(ForcedResponse { speed })
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let state = |w: f64| rest(system, w);
        let bodies = system.bodies();
        let at: Vec<usize> = bodies.iter().map(|b| b.x).collect();
        let (_, load) = Characteristic::new(system, &state(self.speed.to)?).loads();
        if load.iter().all(|f| f.abs() == 0.0) {
            return Err(Diagnostic::error("forced_response.no_unbalance", "nothing forces this machine at the spin speed")
                .help("give a disc an eccentricity, an unbalance or a skew"));
        }
        let mut speeds = self.speed.linspace(400);
        let mut each = |done: u64| {
            context.progress.report(done, 0);
            !context.cancelled() && done < context.work_limit
        };
        // eigenvalues tell where a narrow resonance hides; a machine without time form has none to tell
        let known = time_forms(system).is_ok();
        if known {
            speeds.extend(seeds(system, &state, self.speed.from, self.speed.to, &mut each)?);
        }
        let found: Curve = curve(system, &state, speeds, &at, &mut each)?;
        let end = if found.complete {
            End::Reached
        } else if context.cancelled() {
            End::Cancelled
        } else {
            End::MaxPoints
        };
        let points = &found.points;
        let column = |f: &dyn Fn(&Response) -> f64| points.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("response", "Linear response to unbalance").float("speed", "rad/s", "spin speed", column(&|r| r.speed));
        for b in &bodies {
            let n = &b.name;
            table = table
                .float(format!("amplitude.{n}"), "m", "semi-major axis of the orbit", column(&|r| r.major(b.x)))
                .float(
                    format!("minor.{n}"),
                    "m",
                    "semi-minor axis of the orbit, negative for backward whirl",
                    column(&|r| {
                        let (f, b) = r.circles(b.x);
                        f.abs() - b.abs()
                    }),
                )
                .float(format!("forward.{n}"), "m", "forward amplitude", column(&|r| r.circles(b.x).0.abs()))
                .float(format!("phase.{n}"), "rad", "angle of the forward amplitude from the key mark", column(&|r| r.circles(b.x).0.arg()))
                .float(format!("backward.{n}"), "m", "backward amplitude", column(&|r| r.circles(b.x).1.abs()))
                .float(format!("backward_phase.{n}"), "rad", "angle of the backward amplitude", column(&|r| r.circles(b.x).1.arg()));
        }
        for ((part, what, unit), values) in observed(system, &state, points)? {
            table = table.float(format!("{what}.{part}"), unit, "largest value over a turn", values);
        }
        let residual = points.iter().map(|r| r.residual).fold(0.0, f64::max);
        let mut outcome = Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(end).work("solutions", found.solved);
        let name = |e: &Extremum| bodies[e.body].name.clone();
        let mut peaks: Vec<&Extremum> = found.extrema.iter().filter(|e| e.maximum).collect();
        peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
        if let Some(e) = peaks.first() {
            let text = format!("The largest resonance is at {{}}: {} moves {}.", name(e), quantity(e.value, "m"));
            outcome = outcome.finding(
                Finding::info("largest_resonance", text)
                    .value(e.speed, "rad/s")
                    .evidence("amplitude", e.value, "m")
                    .evidence("residual", residual, ""),
            );
        } else {
            outcome = outcome.finding(Finding::info("no_resonance", "No body has a resonance inside the range of speeds."));
        }
        for e in &found.extrema {
            let kind = if e.maximum { "resonance" } else { "antiresonance" };
            outcome = outcome.special_point(SpecialPoint::new(kind, e.speed, e.bracket).evidence(
                format!("amplitude of {}", name(e)),
                e.value,
                "m",
            ));
        }
        if !known {
            outcome = outcome.finding(Finding::info(
                "frequency_only",
                "A part is given in the frequency domain only, so that no eigenvalues guided the search: resonances narrower than the step of speeds may be missed.",
            ));
        }
        if let Some(f) = found.singular.first() {
            outcome = outcome.finding(
                Finding::warning("undamped_resonance", "The response is infinite at {}: nothing dissipates there.").value(*f, "rad/s"),
            );
        }
        for f in remarks(system, &state(self.speed.from)?) {
            outcome = outcome.finding(f);
        }
        let extrema = Table::new("extrema", "Resonances and antiresonances of every body")
            .text("body", "body", found.extrema.iter().map(name).collect())
            .text(
                "kind",
                "maximum or minimum of the amplitude",
                found.extrema.iter().map(|e| if e.maximum { "resonance" } else { "antiresonance" }.into()).collect(),
            )
            .float("speed", "rad/s", "spin speed", found.extrema.iter().map(|e| e.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit", found.extrema.iter().map(|e| e.value).collect())
            .build()
            .map_err(inconsistent)?;
        let (mut amplitude, mut phase) = (
            Panel::new(Axis::log("amplitude", "µm").factor(1e6)),
            Panel::new(Axis::new("phase", "°").factor(180.0 / std::f64::consts::PI)),
        );
        for b in &bodies {
            amplitude = amplitude.mark(Line::new("response", "speed", format!("amplitude.{}", b.name)).name(b.name.clone()));
            phase = phase.mark(Line::new("response", "speed", format!("phase.{}", b.name)).name(b.name.clone()));
        }
        amplitude = amplitude.mark(Points::new("extrema", "speed", "amplitude").group("kind"));
        let alt = match peaks.first() {
            Some(e) => format!(
                "Amplitudes of {} bodies over spin speed; the largest resonance is at {}.",
                bodies.len(),
                quantity(e.speed, "rad/s")
            ),
            None => format!("Amplitudes of {} bodies over spin speed, without resonance.", bodies.len()),
        };
        let figure = Figure::new("response", "Unbalance response", alt).x(Axis::new("spin speed", "rad/s")).panel(amplitude).panel(phase);
        outcome.table(table.build().map_err(inconsistent)?).table(extrema).figure(figure).checked().map_err(inconsistent)
    }
}

type Observations = BTreeMap<(String, &'static str, &'static str), Vec<f64>>;

/// Quantities that linear parts show, at their largest over one turn. Nonlinear parts would show the force of a law the motion does not know.
fn observed(
    system: &System,
    state: &dyn Fn(f64) -> Result<crate::solve::characteristic::Equilibrium, Diagnostic>,
    points: &[Response],
) -> Result<Observations, Diagnostic> {
    let mut out = Observations::new();
    let mut ws = Workspace::default();
    let n = system.n();
    for (row, r) in points.iter().enumerate() {
        let rest = state(r.speed)?;
        let t = Characteristic::new(system, &rest);
        let s = c(0.0, r.speed);
        for turn in 0..24 {
            let turning = C64::cis(std::f64::consts::TAU * turn as f64 / 24.0);
            let real = |z: C64| (z * turning).re;
            let q: Vec<f64> = (0..n).map(|i| rest.q[i] + real(r.x[i])).collect();
            let v: Vec<f64> = (0..n).map(|i| real(r.x[i] * s)).collect();
            let a: Vec<f64> = (0..n).map(|i| real(r.x[i] * s * s)).collect();
            let mut z = rest.z.clone();
            for (&k, x) in t.states().iter().zip(&r.x[n..]) {
                z[k] += real(*x);
            }
            let at = At { q: &q, v: &v, a: &a, z: &z, phase: turning.arg(), speed: r.speed, spin_accel: 0.0, t: 0.0 };
            for (slot, o) in system.observe(&at, &mut ws) {
                let slot = &system.slots()[slot];
                // the amplitude of a body is in its own columns; eliminated states are not at hand
                if slot.physics != crate::model::part::Physics::Linear || slot.memory > 0 || o.name == "displacement" {
                    continue;
                }
                let column = out.entry((slot.name.clone(), o.name, o.unit)).or_insert_with(|| vec![0.0; points.len()]);
                if o.value.abs() > column[row] || o.value.is_nan() {
                    column[row] = o.value.abs();
                }
            }
        }
    }
    Ok(out)
}

/// Response at one speed, for callers that want no table.
///
/// # Errors
/// As [`rest`].
pub fn at_speed(system: &System, speed: f64) -> Result<Option<Response>, Diagnostic> {
    response(system, &|w| rest(system, w), speed)
}
