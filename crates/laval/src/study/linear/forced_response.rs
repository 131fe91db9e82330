//! Linear response to unbalance over the spin speed: orbits, phases and forces of all bodies, resonances and antiresonances.
//!
//! Equations: `T(i W, W) X = F` with the forces that turn with the rotor; frequency-domain parts and memory states enter exactly. The motion of a
//! point is `x + i y = f exp(i phase) + b exp(-i phase)`; its orbit has the semi-axes `|f| + |b|` and `||f| - |b||`, the longer at the angle `(arg f + arg b)/2` from x.
//!
//! Symbols: W spin speed, rad/s; X complex amplitudes; f, b forward and backward amplitude, m.
//!
//! Validity: motions small enough for the tangent of nonlinear parts at rest; constant speed.
//!
//! Sources: `docs/theory/linear-vibration.md#unbalance-response`.

use super::growing::{Follows, unstable};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::field::{Field, RangeValue, Values};
use crate::model::part::{At, Physics};
use crate::model::probe::Probe;
use crate::model::system::{Slot, System, Workspace};
use crate::outcome::{Axis, Figure, Finding, Line, Outcome, Panel, Points, SpecialPoint, Table, quantity};
use crate::solve::characteristic::Characteristic;
use crate::solve::extrema::{Curve, Extremum, curve, seeds};
use crate::solve::linear_response::{Response, response};
use crate::solve::pencil::time_forms;
use crate::solve::rest::rest;
use crate::solve::sectors::circular;
use crate::solve::sweep::{Strongest, spectrum};
use crate::study::shared::probes;
use crate::study::shared::size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED_RANGE, inconsistent, moves, one_or_range, probe_name, remarks_between};
use crate::study::{Context, Study};
use laval_num::complex::{C64, c};
use std::collections::BTreeMap;

/// See the [module](self).
pub struct ForcedResponse {
    /// Speeds, rad/s.
    pub speed: RangeValue,
}

impl Study for ForcedResponse {
    type Result = Outcome;
    const KIND: &'static str = "forced_response";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm", points = 400 }
"#;
    const DOC: &'static str = "Linear unbalance response over the spin speed: amplitude and phase of every body, at its reference point and \
        wherever something is attached to it, of its tilt, and forces and moments of linear parts, with resonances and antiresonances located. \
        Nonlinear parts enter by their tangent at rest; nonlinear_response keeps them whole.";
    const FIELDS: &'static [Field] = &[Field::required(
        "speed",
        SPEED_RANGE,
        "one spin speed, or a range: points (400 unless given) are added where the response bends",
    )];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = one_or_range("speed", values.range("speed")?, 3, values, diagnostics)?;
        if system.bodies().is_empty() {
            diagnostics.push(Diagnostic::error("forced_response.no_body", "no body of this machine moves across the axis"));
            return None;
        }
        Some(ForcedResponse { speed })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<size::Size> {
        let speeds = self.speed.points.unwrap_or(400);
        let kept = 4.0 * (system.n() + system.m()) as f64;
        let listed = (7 * system.bodies().len() + 3 * system.slots().len()) as f64;
        Some(size::Size {
            bytes: speeds as f64 * (size::KEPT * kept + size::LISTED * listed),
            of: format!("responses at {speeds} speeds of {} coordinates", system.n()),
            fewer: "give the range fewer points: where the response bends it is refined without them",
        })
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        let (_, load) = Characteristic::new(system, &rest(system, self.speed.to)?).loads();
        if load.iter().all(|f| f.abs() == 0.0) {
            return Err(Diagnostic::error("forced_response.no_unbalance", "nothing forces this machine at the spin speed")
                .help("give a disc an eccentricity, an unbalance or a skew"));
        }
        Ok(())
    }

    fn report(&self, _: &System, result: &Outcome, _: &str) -> Result<Outcome, Diagnostic> {
        Ok(result.clone())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        self.admit(system)?;
        let state = |w: f64| rest(system, w);
        let bodies = system.bodies();
        let probes = system.probes();
        let mut speeds = self.speed.linspace(400);
        context.announce(speeds.len() as f64, 10_000.0, "speeds to solve for, and more where the response bends");
        let mut each = |done: u64| {
            context.progress.report(done, 0);
            context.goes_on(done)
        };
        // eigenvalues tell where a narrow resonance hides; a machine without time form has none to tell
        let known = time_forms(system).is_ok();
        let one = self.speed.is_one();
        let mut strongest = Vec::new();
        if known && one {
            strongest.extend(Strongest::of(self.speed.from, &spectrum(system, &state, self.speed.from)?.1));
        } else if known {
            let more = seeds(system, &state, self.speed.from, self.speed.to, &mut each)?;
            speeds.extend(more.speeds);
            strongest = more.strongest;
        }
        let found: Curve = curve(system, &state, speeds, probes, &mut each)?;
        let points = &found.points;
        let reported = |what: &str| format!("{what}; NaN beside a resonance without bound");
        let column = |f: &dyn Fn(&Response) -> f64| points.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("response", "Linear response to unbalance").float("speed", "rad/s", "spin speed", column(&|r| r.speed));
        for p in probes {
            // the tilt of a body has its own columns, a point those of a body of that name
            let (n, of, unit) = match p.is_tilt() {
                true => (p.name.clone(), "tilt_", "rad"),
                false => (probe_name(p), "", "m"),
            };
            let amplitude = if p.is_tilt() { "tilt" } else { "amplitude" };
            table = table
                .float(format!("{amplitude}.{n}"), unit, reported("semi-major axis of the orbit"), column(&|r| r.size(p)))
                .float(
                    format!("{of}minor.{n}"),
                    unit,
                    reported("semi-minor axis of the orbit, negative for backward whirl"),
                    column(&|r| {
                        let (f, b) = r.circles_of(p);
                        f.abs() - b.abs()
                    }),
                )
                .float_if_any(
                    format!("{of}direction.{n}"),
                    "rad",
                    "angle of the major axis from x, above -pi/2 and at most pi/2; NaN of a circle, and beside a resonance without bound",
                    column(&|r| r.direction_of(p)),
                )
                .float(format!("{of}forward.{n}"), unit, reported("forward amplitude"), column(&|r| r.circles_of(p).0.abs()))
                .float(
                    format!("{of}phase.{n}"),
                    "rad",
                    reported("angle of the forward amplitude from the key mark"),
                    column(&|r| r.circles_of(p).0.arg()),
                )
                .float(format!("{of}backward.{n}"), unit, reported("backward amplitude"), column(&|r| r.circles_of(p).1.abs()))
                .float(
                    format!("{of}backward_phase.{n}"),
                    "rad",
                    reported("angle of the backward amplitude"),
                    column(&|r| r.circles_of(p).1.arg()),
                );
        }
        let seen = observed(system, &state, points)?;
        for ((part, what, unit), values) in seen.quantities {
            table = table.float(format!("{what}.{part}"), unit, reported("largest value over a turn"), values);
        }
        table = table.float("validity", "", reported("largest use of a part's validity over a turn; above 1 is outside"), seen.validity);
        let residual = points.iter().map(|r| r.residual).fold(0.0, f64::max);
        let mut outcome =
            Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(context.end(found.complete)).work("solutions", found.solved);
        if let Some(f) = unstable(system, &strongest, &Follows::Response) {
            outcome = outcome.finding(f);
        }
        let name = |e: &Extremum| probe_name(&probes[e.probe]);
        let mut peaks: Vec<&Extremum> = found.extrema.iter().filter(|e| e.maximum).collect();
        peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
        let largest = |tilt: bool| peaks.iter().find(|e| probes[e.probe].is_tilt() == tilt).copied();
        let (moved, tilted) = (largest(false), largest(true));
        if one {
            for p in points.iter().flat_map(|_| probes) {
                let (id, does) = if p.is_tilt() { ("tilt", "tilts by") } else { ("amplitude", "moves") };
                let who = if p.is_tilt() { p.name.clone() } else { probe_name(p) };
                let finding = Finding::info(id, format!("At {} {who} {does} {{}}.", quantity(self.speed.from, "rad/s")));
                outcome = outcome.finding(finding.of(who).value(points[0].size(p), p.unit()).evidence("residual", residual, ""));
            }
        }
        for e in [moved, tilted].into_iter().flatten() {
            let so_far = if found.complete { "" } else { " found before the study stopped" };
            let probe = &probes[e.probe];
            let (id, of) = if probe.is_tilt() { ("largest_tilt_resonance", " of a tilt") } else { ("largest_resonance", "") };
            let finding = if e.unbounded {
                let does = if probe.is_tilt() { "tilts" } else { "moves" };
                let body = if probe.is_tilt() { probe.name.clone() } else { probe_name(probe) };
                let text = format!("Nothing dissipates at the resonance{of}{so_far} at {{}}: there {body} {does} without bound.");
                Finding::warning("undamped_resonance", text)
            } else {
                let text = format!("The largest resonance{of}{so_far} is at {{}}: {}.", moves(probe, e.value));
                Finding::info(id, text)
            };
            let amplitude = if probe.is_tilt() { "tilt" } else { "amplitude" };
            let finding = finding.value(e.speed, "rad/s").evidence(amplitude, e.value, probe.unit()).evidence("residual", residual, "");
            let there = if e.unbounded { None } else { response(system, &state, e.speed)? };
            let direction = there.map_or(f64::NAN, |r| r.direction_of(probe));
            outcome = outcome.finding(if direction.is_nan() {
                finding
            } else {
                finding.evidence("angle of the major axis of the orbit from x", direction, "rad")
            });
        }
        if peaks.is_empty() && !one {
            let text = if !found.unknown.is_empty() {
                "No resonance was found where the response is known."
            } else if found.complete {
                "No body has a resonance inside the range of speeds."
            } else {
                "No resonance was found before the study stopped."
            };
            outcome = outcome.finding(Finding::info("no_resonance", text));
        }
        for e in &found.extrema {
            let kind = if e.maximum { "resonance" } else { "antiresonance" };
            let unit = probes[e.probe].unit();
            outcome = outcome.special_point(SpecialPoint::new(kind, e.speed, e.bracket).of(name(e)).evidence(
                format!("amplitude of {}", name(e)),
                e.value,
                unit,
            ));
        }
        if !known && !one {
            outcome = outcome.finding(Finding::info(
                "frequency_only",
                "A part is given in the frequency domain only, so that no eigenvalues guided the search: resonances narrower than the step of speeds may be missed, and stability was not assessed.",
            ));
        }
        // other poles than the one already named
        let mut poles: Vec<f64> =
            found.extrema.iter().filter(|e| e.unbounded).map(|e| e.speed).chain(found.singular.iter().copied()).collect();
        poles.sort_by(f64::total_cmp);
        poles.dedup_by(|b, a| (*b - *a).abs() <= 1e-6 * a.abs());
        let named: Vec<f64> = [moved, tilted].into_iter().flatten().filter(|e| e.unbounded).map(|e| e.speed).collect();
        for w in poles.into_iter().filter(|w| named.iter().all(|n| (n - w).abs() > 1e-6 * n.abs())) {
            let text = "The response grows without bound at {}: nothing dissipates there.";
            outcome = outcome.finding(Finding::warning("undamped_resonance", text).value(w, "rad/s"));
        }
        if let Some(first) = found.unknown.first() {
            let text = format!(
                "At {} of {} speeds, first at {{}}, a part has no accurate reaction, and the response is not known there.",
                found.unknown.len(),
                found.unknown.len() + found.singular.len() + points.len()
            );
            outcome = outcome.finding(Finding::warning("response_unknown", text).value(*first, "rad/s"));
        }
        for u in &seen.outside {
            let text = format!("\"{}\" leaves its model at the amplitudes of this response: {} reaches {{}}, above 1.", u.part, u.what);
            let text = if u.ratio.is_finite() { text } else { text.replace("{}, above 1", "no finite value") };
            let finding = Finding::invalid("validity", text);
            let finding = if u.ratio.is_finite() { finding.value(u.ratio, "") } else { finding };
            outcome = outcome
                .finding(finding.evidence("at", u.speed, "rad/s").evidence("outside from", u.from, "rad/s").evidence("to", u.to, "rad/s"));
        }
        for f in remarks_between(system, &state(self.speed.from)?, state(self.speed.to)) {
            outcome = outcome.finding(f);
        }
        let size = |tilt: bool| found.extrema.iter().map(|e| if probes[e.probe].is_tilt() == tilt { e.value } else { f64::NAN }).collect();
        let extrema = Table::new("extrema", "Resonances and antiresonances of every body")
            .text("body", "body, point of a body, or tilt of a body", found.extrema.iter().map(name).collect())
            .text(
                "kind",
                "maximum or minimum of the amplitude",
                found.extrema.iter().map(|e| if e.maximum { "resonance" } else { "antiresonance" }.into()).collect(),
            )
            .float("speed", "rad/s", "spin speed", found.extrema.iter().map(|e| e.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound, and of a tilt", size(false))
            .float("tilt", "rad", "semi-major axis of the tilt; NaN where it has no bound, and of a displacement", size(true))
            .build()
            .map_err(inconsistent)?;
        let (mut amplitude, mut phase) = (
            Panel::new(Axis::log("amplitude", "µm").factor(1e6)),
            Panel::new(Axis::new("phase", "°").factor(180.0 / std::f64::consts::PI)),
        );
        let mut tilt = Panel::new(Axis::log("tilt", "mrad").factor(1e3));
        for p in probes {
            if p.is_tilt() {
                tilt = tilt.mark(Line::new("response", "speed", format!("tilt.{}", p.name)).name(p.name.clone()));
            } else {
                let name = probe_name(p);
                amplitude = amplitude.mark(Line::new("response", "speed", format!("amplitude.{name}")).name(name.clone()));
                phase = phase.mark(Line::new("response", "speed", format!("phase.{name}")).name(name));
            }
        }
        amplitude = amplitude.mark(Points::new("extrema", "speed", "amplitude").group("kind"));
        tilt = tilt.mark(Points::new("extrema", "speed", "tilt").group("kind"));
        let alt = match moved.or(tilted) {
            Some(e) if e.unbounded => {
                format!("Amplitudes of {} bodies over spin speed, without bound at {}.", bodies.len(), quantity(e.speed, "rad/s"))
            }
            Some(e) => format!(
                "Amplitudes of {} bodies over spin speed; the largest resonance is at {}.",
                bodies.len(),
                quantity(e.speed, "rad/s")
            ),
            None => format!("Amplitudes of {} bodies over spin speed, without resonance.", bodies.len()),
        };
        // of a machine that only tilts there is nothing to draw of displacements, of one that does not tilt nothing of tilts
        let largest = |p: &Probe| points.iter().map(|r| r.size(p)).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let loud = probes::loudest(probes.iter().map(|p| (p, largest(p))));
        let some = |tilt: bool| probes.iter().any(|p| p.is_tilt() == tilt && !probes::still(p, largest(p), loud, probes::ROUNDING));
        let figure = Figure::new("response", "Unbalance response", alt).x(Axis::new("spin speed", "rad/s"));
        let figure = if some(false) { figure.panel(amplitude).panel(phase) } else { figure };
        let figure = if some(true) { figure.panel(tilt) } else { figure };
        outcome = outcome.table(table.build().map_err(inconsistent)?);
        // one speed makes neither curves nor extrema
        if !one {
            outcome = outcome.table(extrema);
            outcome = if figure.panels.is_empty() { outcome } else { outcome.figure(figure) };
        }
        outcome.checked().map_err(inconsistent)
    }
}

/// What the parts show along the response.
struct Seen {
    /// Part, quantity and unit, with the largest value over a turn at every speed.
    quantities: BTreeMap<(String, &'static str, &'static str), Vec<f64>>,
    /// Largest use of validity at every speed.
    validity: Vec<f64>,
    /// Statements of validity that do not hold throughout.
    outside: Vec<Outside>,
}

/// A statement of validity that is left.
struct Outside {
    slot: usize,
    part: String,
    what: &'static str,
    /// Largest use, and the speed where it occurs, rad/s.
    ratio: f64,
    speed: f64,
    /// First and last speed outside, rad/s.
    from: f64,
    to: f64,
}

/// Quantities that linear parts show, at their largest over one turn, and the use of every part's validity. The observed force of a nonlinear part would
/// be that of a law the motion does not know; its validity is a matter of the motion itself.
fn observed(
    system: &System,
    state: &dyn Fn(f64) -> Result<crate::solve::characteristic::Equilibrium, Diagnostic>,
    points: &[Response],
) -> Result<Seen, Diagnostic> {
    let mut out = BTreeMap::new();
    let (mut validity, mut outside) = (vec![0.0f64; points.len()], Vec::<Outside>::new());
    let mut ws = Workspace::default();
    let n = system.n();
    for (row, r) in points.iter().enumerate() {
        for (name, force) in exact_forces(system, r) {
            out.entry((name, "force", "N")).or_insert_with(|| vec![0.0; points.len()])[row] = force;
        }
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
            for (k, u) in system.validity(&at, &mut ws) {
                // the amplitude beside a pole is not a number
                if !r.x.iter().all(|x| x.is_finite()) {
                    validity[row] = f64::NAN;
                    continue;
                }
                if !(validity[row].is_nan() || u.ratio <= validity[row]) {
                    validity[row] = if u.ratio.is_finite() { u.ratio } else { f64::NAN };
                }
                if u.ratio <= 1.0 {
                    continue;
                }
                match outside.iter_mut().find(|o| o.slot == k && o.what == u.what) {
                    Some(o) => {
                        o.to = r.speed;
                        if !(u.ratio <= o.ratio) {
                            (o.ratio, o.speed) = (u.ratio, r.speed);
                        }
                    }
                    None => outside.push(Outside {
                        slot: k,
                        part: system.slots()[k].name.clone(),
                        what: u.what,
                        ratio: u.ratio,
                        speed: r.speed,
                        from: r.speed,
                        to: r.speed,
                    }),
                }
            }
            for (slot, o) in system.observe(&at, &mut ws) {
                let slot = &system.slots()[slot];
                // the amplitude of a body is in its own columns; eliminated states are not at hand
                if slot.physics != Physics::Linear || slot.memory > 0 || o.is_motion_of_body() {
                    continue;
                }
                let column: &mut Vec<f64> = out.entry((slot.name.clone(), o.name, o.unit)).or_insert_with(|| vec![0.0; points.len()]);
                if o.value.abs() > column[row] || o.value.is_nan() {
                    column[row] = o.value.abs();
                }
            }
        }
    }
    Ok(Seen { quantities: out, validity, outside })
}

/// Forces of the parts that are given in the frequency domain, by their exact reaction: what they put on their first pair of coordinates, such as a liquid on
/// the wall of its cavity. Semi-major axes, N.
fn exact_forces(system: &System, r: &Response) -> Vec<(String, f64)> {
    let slots = system.slots().iter().filter(|s| matches!(s.physics, Physics::Frequency(_)) && s.map.len() >= 2);
    let one = |slot: &Slot| {
        let (n, params) = (slot.map.len(), &system.params()[slot.params.clone()]);
        let moved: Vec<C64> = slot.map.iter().map(|row| row.iter().fold(C64::zero(), |sum, &(g, x)| sum + r.x[g].scale(x))).collect();
        let (mut reaction, mut load) = (vec![C64::zero(); n * n], Blocks::default());
        load.reset(n, 0, r.speed);
        if let Some(part) = slot.part.frequency_domain() {
            part.impedance_f64(params, c(0.0, r.speed), r.speed, &mut reaction);
            part.load_f64(params, r.speed, &mut load);
        }
        let force = |i: usize| (0..n).fold(c(-load.force_cos[i], load.force_sin[i]), |sum, j| sum + reaction[i * n + j] * moved[j]);
        let (forward, backward) = circular(force(0), force(1));
        (slot.name.clone(), forward.abs() + backward.abs())
    };
    slots.map(one).collect()
}

/// Response at one speed, for callers that want no table.
///
/// # Errors
/// As [`rest`].
pub fn at_speed(system: &System, speed: f64) -> Result<Option<Response>, Diagnostic> {
    response(system, &|w| rest(system, w), speed)
}
