//! Self-excited whirls over the spin speed: limit cycles from the edges of linear instability, their stability, hard and soft onset.
//!
//! Equations: harmonic balance with unknown frequency, linear parts condensed at `s = i k w` and the spin speed W; see
//! [`crate::solve::harmonic::free::cycles`]. Of an isotropic machine the motion is circular and exact with one harmonic:
//! `Im K(w, W) = 0`, `a^2 = -(Re K + c0)/c1` for a cubic bearing on a linear rest of condensed stiffness K.
//!
//! Symbols: w whirl frequency, rad/s; W spin speed, rad/s; a amplitude of the deflection of the nonlinear parts, m.
//!
//! Validity: constant speed, no unbalance. With unbalance the whirl goes on beside the forced motion at a frequency of its own.
//!
//! Sources: `docs/theory/free-motions.md#limit-cycles`; J. E. Marsden, M. McCracken, The Hopf Bifurcation (1976).

use super::free_motion::{
    FREQUENCY, HARMONICS, MAX_POINTS, Measure, Measured, TRUNCATION, VALID, body_columns, constant_speed, end, in_order, invalid, read,
    short, trust_columns, unfinished, valid,
};
use super::nonlinear_response::{holder, unassessed};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, Values};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{
    self, Arg, Axis, Band, Figure, Finding, Line, Message, Outcome, OutcomeError, Panel, Rule, Scale, SpecialPoint, Status, Table,
};
use crate::solve::harmonic::free::cycles::{Cycle, Cycles, Family, Onset, Request, admit, limit_cycles};
use crate::solve::harmonic::stability::floquet::Exponents;
use crate::study::shared::probes;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED_RANGE, larger, range, runs};
use crate::study::{Context, Study};
use serde::{Deserialize, Serialize};

/// See the [module](self).
pub struct LimitCycles {
    request: Request,
}

impl LimitCycles {
    /// The study that answers this request.
    pub fn new(request: Request) -> Self {
        LimitCycles { request }
    }
}

impl Study for LimitCycles {
    type Result = LimitCyclesResult;
    const KIND: &'static str = "limit_cycles";
    const EXAMPLE: &'static str = r#"speed = { from = "500 rpm", to = "12000 rpm" }
"#;
    const DOC: &'static str = "Self-excited whirls of a damped machine over the spin speed, without unbalance: from every edge of linear instability the \
        cycles that begin there, with amplitude, frequency and stability; whether the onset is soft (a small whirl grows with the speed) or hard (rest is \
        stable, but a disturbance beyond an unstable cycle leads to a large whirl); folds of cycles.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds; rest is assessed at 200 unless points are given"),
        HARMONICS,
        TRUNCATION,
        MAX_POINTS,
    ];

    fn build(values: &Values, _: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = range("speed", values.range("speed")?, 3, values, diagnostics)?;
        let (harmonics, truncation, max_points) = read(values);
        let request = Request {
            speeds: (speed.from, speed.to),
            points: speed.points.unwrap_or(200),
            harmonics,
            truncation,
            max_points,
            work: u64::MAX,
        };
        Some(LimitCycles { request })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.request.speeds.0, self.request.speeds.1)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(Size::of_spectra(self.request.points, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        constant_speed(system)?;
        admit(system, self.request.speeds)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<LimitCyclesResult, Diagnostic> {
        self.admit(system)?;
        let request = Request { work: context.work_limit, ..self.request };
        let found = limit_cycles(system, &request, context.cancel, &|done| context.progress.report(done, 0))?;
        let fastest = found.onsets.iter().map(|o| o.frequency.abs()).fold(1.0, f64::max);
        let mut measure = Measure::new(system, found.discretisation, fastest)?;
        let of = |c: &Cycle, measure: &mut Measure| measure.of([c.speed, c.frequency, 0.0], &c.x);
        let measured = found.families.iter().map(|f| f.cycles.iter().map(|c| of(c, &mut measure)).collect()).collect();
        let end = if found.stopped { context.end(false) } else { end(found.families.iter().map(|f| &f.end)) };
        Ok(LimitCyclesResult { found, measured, end })
    }

    fn report(&self, system: &System, result: &LimitCyclesResult, name: &str) -> Result<Outcome, Diagnostic> {
        let LimitCyclesResult { found, measured, end } = result;
        let shown = Shown { system, request: &self.request, found, measured, probes: probes::all(system), end: *end };
        shown.outcome(name).map_err(Diagnostic::from)
    }
}

/// Families of limit cycles, and how far their motions go.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LimitCyclesResult {
    /// Stability of rest, its edges, and the families that begin there.
    pub found: Cycles,
    /// Of every family, of every cycle.
    pub measured: Vec<Vec<Measured>>,
    /// How the study ended.
    pub end: outcome::End,
}

struct Shown<'a> {
    system: &'a System,
    request: &'a Request,
    found: &'a Cycles,
    measured: &'a [Vec<Measured>],
    probes: Vec<Probe>,
    end: outcome::End,
}

/// The words of an onset.
fn word(o: &Onset) -> &'static str {
    match () {
        () if o.curvature.is_nan() => "unknown",
        () if o.hard => "hard",
        () => "soft",
    }
}

/// How far beyond the largest valid size the axis goes.
const BEYOND: f64 = 1.5;

/// What the size of a whirl is.
#[derive(Clone, Copy, PartialEq)]
enum Reach {
    Displacement,
    Tilt,
}

impl Reach {
    fn is_tilt(self) -> bool {
        self == Reach::Tilt
    }
    fn unit(self) -> &'static str {
        if self.is_tilt() { "rad" } else { "m" }
    }
    fn column(self) -> &'static str {
        if self.is_tilt() { "largest tilt" } else { "largest displacement" }
    }
}

impl Shown<'_> {
    /// Displacements, unless nothing but tilts.
    fn kind(&self) -> Reach {
        let all = || self.measured.iter().flatten().flat_map(|m| self.probes.iter().zip(m.largest.iter().copied()));
        if probes::displaced(all) { Reach::Displacement } else { Reach::Tilt }
    }

    /// The probe of this kind that goes farthest in a motion, and how far; NaN where that is not known.
    fn reach(&self, m: &Measured, kind: Reach) -> (usize, f64) {
        let own = m.largest.iter().copied().enumerate().filter(|(k, _)| self.probes[*k].is_tilt() == kind.is_tilt());
        own.reduce(|a, b| if larger(a.1, b.1) == a.1 { a } else { b }).unwrap_or((0, f64::NAN))
    }

    fn outcome(&self, name: &str) -> Result<Outcome, OutcomeError> {
        let found = self.found;
        let mut out = Outcome::new(LimitCycles::KIND, name)
            .over("speed", "rad/s")
            .end(self.end)
            .work("Newton iterations", found.iterations)
            .work("eigenproblems", found.rest.solved)
            .work("points", found.families.iter().map(|f| f.cycles.len() as u64).sum());
        let mut reported: Vec<Finding> = Vec::new();
        for f in self.findings() {
            // families that meet at a fold tell of it both
            let same = |t: &Finding| {
                t.id == f.id && f.id == "fold_of_cycles" && t.value.zip(f.value).is_some_and(|(a, b)| (a - b).abs() <= 1e-9 * b.abs())
            };
            if !reported.iter().any(same) {
                reported.push(f);
            }
        }
        for f in reported {
            out = out.finding(f);
        }
        if found.families.iter().any(|f| !f.cycles.is_empty()) {
            out = out.table(self.table()?).figure(self.figure());
        }
        if !found.onsets.is_empty() {
            out = out.table(self.onsets()?);
        }
        for o in &found.onsets {
            let status = if o.edge.located { Status::Located } else { Status::Bracketed };
            out = out.special_point(
                SpecialPoint::new("Hopf", o.edge.speed, o.edge.bracket)
                    .of(word(o))
                    .status(status)
                    .evidence("whirl frequency", o.frequency, "rad/s")
                    .evidence("uncertainty", o.edge.step, "rad/s"),
            );
        }
        for f in &found.families {
            for p in &f.folds {
                let status = if p.confirmed { Status::Located } else { Status::Bracketed };
                let point = SpecialPoint::new("fold of cycles", p.speed, p.bracket).status(status);
                out = out.special_point(point.evidence("scaled residual", p.residual, ""));
            }
            for c in &f.changes {
                let kind = if c.exponent.im.abs() > 1e-6 * c.speed { "Neimark-Sacker" } else { "change of stability" };
                let point = SpecialPoint::new(kind, c.speed, c.bracket);
                out = out.special_point(point.evidence("frequency of the disturbance", c.exponent.im.abs(), "rad/s"));
            }
        }
        out.checked()
    }

    fn findings(&self) -> Vec<Finding> {
        let found = self.found;
        let mut out = Vec::new();
        let (lo, hi) = self.request.speeds;
        if found.onsets.is_empty() {
            let unstable = found.rest.samples.first().is_some_and(|s| found.rest.unstable(s, 0.0));
            let count = found.rest.samples.len();
            let finding = if unstable {
                let most = found.rest.samples.iter().map(|s| s.value.re).fold(0.0, f64::max);
                let waves = self.system.slots().iter().find_map(|s| s.part.filling());
                Finding::warning("no_edge_unstable", "limit-cycles-no-edge-unstable")
                    .value(most, "1/s")
                    .arg("damping", waves.map_or(Arg::word("none"), |f| Arg::term(f.damping())))
            } else {
                Finding::info("no_edge", "limit-cycles-no-edge")
            };
            out.push(finding.arg("speeds", Arg::count(count)).arg("from", Arg::speed(lo)).arg("to", Arg::speed(hi)));
        }
        for (k, o) in found.onsets.iter().enumerate() {
            out.push(self.onset(k, o));
        }
        out.extend(self.beside_rest());
        for (k, f) in found.families.iter().enumerate() {
            out.extend(self.family(k, f));
        }
        if let Some(why) = &found.unassessed {
            out.push(Finding::warning("stability_unknown", "limit-cycles-stability-unknown").arg("why", unassessed(why)));
        }
        let truncations = found.families.iter().flat_map(|f| &f.cycles).map(|c| c.truncation);
        out.extend(short(self.request.harmonics, self.request.truncation, truncations, found.discretisation.harmonics));
        out.extend(invalid(self.system, &self.measured.iter().flatten().collect::<Vec<_>>(), "cycles"));
        out
    }

    fn onset(&self, k: usize, o: &Onset) -> Finding {
        let subject = format!("edge {}", k + 1);
        let side = |key: &str| Message::new(key).arg("side", Arg::word(if o.curvature > 0.0 { "higher" } else { "lower" }));
        let (mut finding, note) = match o.left {
            Some(why) if o.curvature.is_nan() => {
                (Finding::warning("onset", "limit-cycles-onset"), Message::new("limit-cycles-onset-left").arg("why", Arg::term(why)))
            }
            // not come to, or without a mode to begin at
            None if o.curvature.is_nan() => (
                Finding::warning("onset", "limit-cycles-onset"),
                Message::new(if self.end == outcome::End::Reached { "limit-cycles-onset-not-found" } else { "limit-cycles-onset-stopped" }),
            ),
            _ if o.hard => (Finding::warning("hard_onset", "limit-cycles-onset"), side("limit-cycles-hard")),
            _ => (Finding::info("soft_onset", "limit-cycles-onset"), side("limit-cycles-soft")),
        };
        finding.notes.push(note);
        finding
            .arg("edge", Arg::word(if o.edge.onset { "onset" } else { "end" }))
            .arg("frequency", Arg::frequency(o.frequency))
            .arg("whirl", Arg::word(o.whirl.word()))
            .of(subject)
            .value(o.edge.speed, "rad/s")
            .evidence("speed over amplitude squared", o.curvature, "rad/s/m^2")
            .evidence("its relative change at half the amplitude", o.curvature_change, "")
            .evidence("uncertainty of the edge", o.edge.step, "rad/s")
    }

    /// Speeds at which a stable whirl stands beside a stable rest.
    fn beside_rest(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        for (k, f) in self.found.families.iter().enumerate() {
            let both = f.cycles.iter().map(|c| c.stable() && c.rest < 0.0);
            for (a, b) in runs(both).into_iter().filter(|(a, b)| b > a) {
                let (lo, hi) =
                    f.cycles[a..=b].iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), c| (l.min(c.speed), h.max(c.speed)));
                // next to an edge both are neutral within the error
                if !(hi - lo > 1e-4 * hi) {
                    continue;
                }
                let kind = self.kind();
                let (m, largest) = self.measured[k][a..=b]
                    .iter()
                    .map(|m| (m, self.reach(m, kind).1))
                    .fold((None, 0.0), |best, (m, r)| if r > best.1 { (Some(m), r) } else { best });
                let finding = match m {
                    Some(m) if !valid(self.system, m) => Finding::invalid("whirl_beside_rest", "limit-cycles-bistable-invalid"),
                    _ => Finding::warning("whirl_beside_rest", "limit-cycles-bistable"),
                };
                out.push(
                    finding
                        .of(format!("family {}", k + 1))
                        .value(largest, kind.unit())
                        .arg("from", Arg::speed(lo))
                        .arg("to", Arg::speed(hi)),
                );
            }
        }
        out
    }

    fn family(&self, k: usize, f: &Family) -> Vec<Finding> {
        let mut out = Vec::new();
        let name = format!("family {}", k + 1);
        let number = || Arg::count(k + 1);
        let stable = f.cycles.iter().zip(&self.measured[k]).filter(|(c, _)| c.stable());
        let kind = self.kind();
        let sizes: Vec<_> = stable.map(|(c, m)| (c, self.reach(m, kind), valid(self.system, m))).collect();
        let most = |only_valid: bool| sizes.iter().filter(|s| s.2 || !only_valid).max_by(|a, b| a.1.1.total_cmp(&b.1.1));
        if let Some(&(c, (body, r), inside)) = most(false) {
            let mut finding = match inside {
                true => Finding::info("largest_whirl", "limit-cycles-largest"),
                false => Finding::invalid("largest_whirl", "limit-cycles-largest-invalid"),
            };
            if let (false, Some((c, (_, r), _))) = (inside, most(true)) {
                let note = Message::new("limit-cycles-largest-valid").arg("size", Arg::quantity(*r, kind.unit()));
                finding.notes.push(note.arg("speed", Arg::speed(c.speed)));
            }
            let trivial = f.cycles.iter().map(|c| c.trivial).fold(0.0, f64::max);
            out.push(
                finding
                    .of(&name)
                    .value(r, kind.unit())
                    .arg("family", number())
                    .arg("quality", Arg::word(if kind.is_tilt() { "tilt" } else { "displacement" }))
                    .arg("body", self.probes.get(body).map_or(Arg::name(""), holder))
                    .arg("speed", Arg::speed(c.speed))
                    .arg("frequency", Arg::frequency(c.frequency))
                    .evidence("largest exponent of a shift in time, zero in theory", trivial, "1/s")
                    .evidence("error of growth rates", c.exponents.as_ref().map_or(f64::NAN, |e: &Exponents| e.error), "1/s")
                    .evidence("scaled residual", c.residual, ""),
            );
        } else if f.cycles.iter().all(|c| c.exponents.is_some()) && !f.cycles.is_empty() {
            out.push(Finding::info("unstable_family", "limit-cycles-all-unstable").of(&name).arg("family", number()));
        }
        for p in &f.folds {
            out.push(
                Finding::info("fold_of_cycles", "limit-cycles-fold").of(&name).value(p.speed, "rad/s").arg("family", number()).evidence(
                    "scaled residual",
                    p.residual,
                    "",
                ),
            );
        }
        if let Some(speed) = f.unbounded {
            out.push(Finding::warning("unbounded_whirl", "limit-cycles-unbounded").of(&name).value(speed, "rad/s"));
        }
        if let (Some(why), Some(last)) = (unfinished(&f.end, self.end), f.cycles.last()) {
            let finding = Finding::warning("family_unfinished", "limit-cycles-family-unfinished").of(&name).value(last.speed, "rad/s");
            out.push(finding.arg("family", number()).arg("why", why));
        }
        out
    }

    fn table(&self) -> Result<Table, OutcomeError> {
        let all = in_order(self.found.families.iter().map(|f| &f.cycles[..]), self.measured);
        let column = |f: &dyn Fn(&Cycle) -> f64| all.iter().map(|a| f(a.1)).collect::<Vec<f64>>();
        let measured: Vec<&Measured> = all.iter().map(|a| a.2).collect();
        let t = Table::new("cycles", "Limit cycles, family by family in order along each; a family may turn back in speed")
            .int("family", "", "number of the family", all.iter().map(|a| a.0 as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", column(&|c| c.speed))
            .float("frequency", "rad/s", FREQUENCY, column(&|c| c.frequency))
            .float("amplitude", "m", "first-order amplitude of the deflection of the nonlinear parts", column(&|c| c.amplitude))
            .float(
                "largest displacement",
                "m",
                "largest distance of any body, at the points that count, from its rest position over a period; NaN when it could not be had",
                measured.iter().map(|m| self.reach(m, Reach::Displacement).1).collect(),
            );
        let t = match self.kind() {
            Reach::Displacement => t,
            Reach::Tilt => {
                let doc = "largest tilt of any body over a period; NaN when it could not be had";
                t.float("largest tilt", "rad", doc, measured.iter().map(|m| self.reach(m, Reach::Tilt).1).collect())
            }
        };
        let t = body_columns(t, &self.probes, &measured)
            .float(
                "growth rate",
                "1/s",
                "largest growth rate of a disturbance that is no shift in time; NaN when not assessed",
                column(&Cycle::growth),
            )
            .float(
                "growth rate error",
                "1/s",
                "its estimated error; NaN when it could not be had",
                column(&|c| c.exponents.as_ref().map_or(f64::NAN, |e| e.error)),
            )
            .flag("stable", "no growth beyond the error", all.iter().map(|a| a.1.stable()).collect())
            .float(
                "shift exponent",
                "1/s",
                "distance from zero of the exponent of a shift in time, zero in theory; NaN when it could not be had",
                column(&|c| c.trivial),
            )
            .float(
                "growth of rest",
                "1/s",
                "largest growth rate of the machine at rest at this speed; NaN when it could not be had",
                column(&|c| c.rest),
            );
        trust_columns(t, self.system, column(&|c| c.truncation), column(&|c| c.residual), &measured).build()
    }

    fn onsets(&self) -> Result<Table, OutcomeError> {
        let all = &self.found.onsets;
        let family = |k: usize| self.found.families.iter().position(|f| f.onset == k).map_or(0, |f| f as i64 + 1);
        Table::new("onsets", "Edges of linear instability of rest, where cycles begin")
            .float("speed", "rad/s", "spin speed", all.iter().map(|o| o.edge.speed).collect())
            .float("frequency", "rad/s", FREQUENCY, all.iter().map(|o| o.frequency).collect())
            .text(
                "edge",
                "onset: rest is unstable above this speed; end: stable above",
                all.iter().map(|o| if o.edge.onset { "onset" } else { "end" }.into()).collect(),
            )
            .text(
                "kind",
                "soft: small cycles where rest is unstable; hard: where it is stable",
                all.iter().map(|o| word(o).to_string()).collect(),
            )
            .float(
                "curvature",
                "rad/s/m^2",
                "k of speed - edge = k amplitude^2; NaN when no cycle was found",
                all.iter().map(|o| o.curvature).collect(),
            )
            .int("family", "", "number of the family that begins here; 0: none", (0..all.len()).map(family).collect())
            .text("why none", "why no family begins here", all.iter().map(|o| o.left.unwrap_or("").to_string()).collect())
            .build()
    }

    fn figure(&self) -> Figure {
        let found = self.found;
        let kind = self.kind();
        // sizes outside the validity of a part are no results: grey, beyond the axis
        let inside = || self.measured.iter().flatten().any(|m| valid(self.system, m));
        let seen = |m: &&Measured| !inside() || valid(self.system, m);
        let most = self.measured.iter().flatten().filter(seen).map(|m| self.reach(m, kind).1).fold(0.0, f64::max);
        // one family needs no number in the legend
        let grouped = |line: Line| if found.families.len() > 1 { line.group("family") } else { line.name("whirl") };
        let assessed = found.unassessed.is_none();
        let marked = |line: Line| {
            let line = line.valid_where(VALID);
            if assessed { line.solid_where("stable") } else { line }
        };
        // families of very different size are seen together on a logarithmic axis
        let largest = |m: &Vec<Measured>| m.iter().filter(seen).map(|m| self.reach(m, kind).1).fold(0.0, f64::max);
        let least = self.measured.iter().map(largest).filter(|l| *l > 0.0).fold(f64::INFINITY, f64::min);
        let (column, unit) = (kind.column(), if kind.is_tilt() { "mrad" } else { "m" });
        let axis = if most > 20.0 * least { Axis::log(column, unit) } else { Axis::new(column, unit) };
        let axis = if kind.is_tilt() { axis.factor(1e3) } else { axis.metres(most) };
        let cut = axis.scale == Scale::Linear && self.measured.iter().flatten().any(|m| !seen(&m));
        let top = BEYOND * most * axis.factor;
        let mut panel = Panel::new(if cut { axis.range(0.0, top) } else { axis });
        for (from, to) in found.rest.unstable_ranges(0.0) {
            panel = panel.mark(Band::x(from, to).name("equilibrium unstable").strip());
        }
        panel = panel.mark(marked(grouped(Line::new("cycles", "speed", column))));
        for o in &found.onsets {
            panel = panel.mark(Rule::x(o.edge.speed, word(o)));
        }
        let frequencies = found.families.iter().flat_map(|f| &f.cycles).map(|c| c.frequency);
        let (low, high) = frequencies.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), w| (l.min(w), h.max(w)));
        let margin = 0.05 * (high - low);
        let frequency = Panel::new(Axis::new("whirl frequency", "rad/s").range(low - margin, high + margin))
            .mark(marked(grouped(Line::new("cycles", "speed", "frequency"))));
        let alt =
            Message::new("limit-cycles-alt").arg("families", Arg::count(found.families.len())).arg("edges", Arg::count(found.onsets.len()));
        let speeds = found.families.iter().flat_map(|f| &f.cycles).map(|c| c.speed);
        let (lo, hi) = speeds.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), w| (l.min(w), h.max(w)));
        Figure::new("cycles", "Limit cycles", alt).x(Axis::new("spin speed", "rad/s").range(lo, hi)).panel(panel).panel(frequency)
    }
}
