//! Findings, tables and the figure of a linear response.

use super::polar::Polar;
use super::{ForcedResponse, ForcedResponseResult, largest};
use crate::diagnostic::Diagnostic;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Message, Outcome, Panel, Points, Rule, SpecialPoint, Table};
use crate::solve::extrema::Extremum;
use crate::solve::linear_response::Response;
use crate::solve::pencil::time_forms;
use crate::study::Study;
use crate::study::linear::growing::{Follows, unstable};
use crate::study::linear::operating::operating;
use crate::study::shared::margins::{Open, Speeds, required_within, undecided};
use crate::study::shared::probes;
use crate::study::shared::support::{inconsistent, probe_name};
use laval_num::order::SortByNumber;

/// Peaks that the figure labels, at most; bodies peak at one speed within this share of it; a factor of amplification beyond this says that nothing damps.
const LABELLED: usize = 4;
const ONE_PEAK: f64 = 0.02;
const SHARPEST: f64 = 1e4;
/// Size of a resonance, over that of the largest, that is rounding.
const STILL: f64 = 1e-9;

/// Columns of a displacement and of a tilt.
const COLUMNS: [[&str; 7]; 2] = [
    ["amplitude", "minor", "direction", "forward", "phase", "backward", "backward_phase"],
    ["tilt", "tilt_minor", "tilt_direction", "tilt_forward", "tilt_phase", "tilt_backward", "tilt_backward_phase"],
];

pub(super) struct Shown<'a> {
    pub(super) study: &'a ForcedResponse,
    pub(super) system: &'a System,
    pub(super) result: &'a ForcedResponseResult,
    /// Largest residual of the linear systems.
    residual: f64,
    /// The largest resonance of a displacement, and of a tilt.
    largest: [Option<&'a Extremum>; 2],
}

impl<'a> Shown<'a> {
    pub fn new(study: &'a ForcedResponse, system: &'a System, result: &'a ForcedResponseResult) -> Self {
        let residual = result.curve.points.iter().map(|r| r.residual).fold(0.0, f64::max);
        let largest = [false, true].map(|tilt| largest(&result.curve, system.probes(), tilt));
        Shown { study, system, result, residual, largest }
    }

    pub fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let found = &self.result.curve;
        let one = self.study.speed.is_one();
        let mut out = Outcome::new(ForcedResponse::KIND, name).over("speed", "rad/s").end(self.result.end).work("solutions", found.solved);
        let unstable = unstable(self.system, &self.result.strongest, &Follows::Response);
        let findings = unstable
            .into_iter()
            .chain(if one { self.amplitudes() } else { Vec::new() })
            .chain(self.resonances())
            .chain(self.margins())
            .chain(self.shaft_vibration());
        out = self.spins().into_iter().fold(out, Outcome::finding);
        out = findings.chain(self.doubts()).chain(self.result.states.remarks(self.system)).fold(out, Outcome::finding);
        out = self.special_points().into_iter().fold(out, Outcome::special_point);
        let (extrema, figure) = (self.extrema_table()?, self.figure());
        out = out.table(self.response_table()?);
        // one speed makes neither curves nor extrema
        if !one {
            out = out.table(extrema);
            out = if figure.panels.is_empty() { out } else { out.figure(figure) };
            if let Some(polar) = Polar::of(self.system, self.result) {
                out = out.table(polar.table().build().map_err(inconsistent)?).figure(polar.figure());
            }
        }
        if let Some(table) = self.journals_table()? {
            out = out.table(table);
        }
        let orbits = &self.result.orbits;
        if !orbits.at.is_empty() {
            out = out.table(orbits.table().build().map_err(inconsistent)?).figure(orbits.orbit_figure(self.system));
            out = orbits.shape_figure(self.system).into_iter().fold(out, Outcome::figure);
        }
        out.checked().map_err(inconsistent)
    }

    /// Whose unbalance acts in a machine of several spins.
    fn spins(&self) -> Option<Finding> {
        if let Some(name) = &self.study.spin {
            return Some(Finding::info("spin", "forced-response-spin").arg("spin", Arg::name(name)));
        }
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        self.system.linear(self.system.params(), self.study.speed.to, Form::Frequency, &mut model, &mut scratch);
        let spins = model.loads.others.iter().filter_map(|o| self.system.other_spin(o.spin).name);
        let names: Vec<String> = spins.map(|name| format!("\"{name}\"")).collect();
        (!names.is_empty()).then(|| Finding::warning("spin", "forced-response-other-spins").arg("spins", Arg::term(names.join(", "))))
    }

    fn probes(&self) -> &'a [Probe] {
        self.system.probes()
    }

    fn points(&self) -> &'a [Response] {
        &self.result.curve.points
    }

    fn name(&self, e: &Extremum) -> String {
        probe_name(&self.probes()[e.probe])
    }

    /// At one speed: how far everything moves.
    fn amplitudes(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        for (r, p) in self.points().iter().flat_map(|r| self.probes().iter().map(move |p| (r, p))) {
            // an amplitude without bound has no number; the finding about the pole reports its speed
            if !r.size(p).is_finite() {
                continue;
            }
            let finding = if p.is_tilt() {
                Finding::info("tilt", "forced-response-tilt").of(&p.name).arg("body", Arg::name(&p.name))
            } else {
                Finding::info("amplitude", "forced-response-amplitude").of(probe_name(p)).arg("body", probes::arg(p))
            };
            let finding = finding.value(r.size(p), p.unit()).arg("speed", Arg::speed(self.study.speed.from));
            out.push(finding.evidence("residual", self.residual, ""));
        }
        out
    }

    /// The largest resonances, or that there is none.
    fn resonances(&self) -> Vec<Finding> {
        let found = &self.result.curve;
        let mut out = Vec::new();
        let size = |e: &Extremum| if e.unbounded { f64::INFINITY } else { e.value / self.probes()[e.probe].typical() };
        let most = self.largest.iter().flatten().map(|e| size(e)).fold(0.0, f64::max);
        for (e, direction) in self.largest.into_iter().zip(self.result.directions).filter_map(|(e, d)| Some((e?, d))) {
            // what does not move but for rounding has no resonance
            if !(size(e) > STILL * most) && most.is_finite() {
                continue;
            }
            let probe = &self.probes()[e.probe];
            let finding = if e.unbounded {
                Finding::warning("undamped_resonance", "forced-response-undamped-resonance")
            } else {
                let finding = match probe.is_tilt() {
                    true => Finding::info("largest_tilt_resonance", "forced-response-largest-tilt-resonance"),
                    false => Finding::info("largest_resonance", "forced-response-largest-resonance"),
                };
                finding
                    .arg("amplitude", Arg::quantity(e.value, probe.unit()))
                    .arg("others", Arg::word(if found.poles().is_empty() { "none" } else { "unbounded" }))
                    .arg("search", Arg::word(if found.complete { "complete" } else { "stopped" }))
            };
            let finding = finding.arg("body", probes::arg(probe));
            let amplitude = if probe.is_tilt() { "tilt" } else { "amplitude" };
            let finding =
                finding.value(e.speed, "rad/s").evidence(amplitude, e.value, probe.unit()).evidence("residual", self.residual, "");
            out.push(if direction.is_nan() {
                finding
            } else {
                finding.evidence("angle of the major axis of the orbit from x", direction, "rad")
            });
        }
        if self.largest.iter().all(Option::is_none) && !self.study.speed.is_one() {
            let key = if !found.unknown.is_empty() {
                "forced-response-no-resonance-known"
            } else if found.complete {
                "forced-response-no-resonance"
            } else {
                "forced-response-no-resonance-yet"
            };
            out.push(Finding::info("no_resonance", key));
        }
        out
    }

    /// Where the response is not known, without bound, or outside the models.
    fn doubts(&self) -> Vec<Finding> {
        let found = &self.result.curve;
        let mut out = Vec::new();
        if time_forms(self.system).is_err() && !self.study.speed.is_one() {
            out.push(Finding::info("frequency_only", "forced-response-frequency-only").arg("step", Arg::speed(self.study.step())));
        }
        // other poles than the one already named
        let poles = found.poles();
        let named: Vec<f64> = self.largest.into_iter().flatten().filter(|e| e.unbounded).map(|e| e.speed).collect();
        for w in poles.into_iter().filter(|w| named.iter().all(|n| (n - w).abs() > 1e-6 * n.abs())) {
            out.push(Finding::warning("undamped_resonance", "forced-response-other-undamped-resonance").value(w, "rad/s"));
        }
        if let Some(first) = found.unknown.first() {
            let without = |w: &&f64| found.points.iter().all(|r| r.speed != **w);
            let speeds = found.unknown.len() + found.singular.iter().filter(without).count() + found.points.len();
            let finding = Finding::warning("response_unknown", "forced-response-unknown").value(*first, "rad/s");
            out.push(finding.arg("unknown", Arg::count(found.unknown.len())).arg("speeds", Arg::count(speeds)));
        }
        for c in &self.result.observed.closed {
            let deepest = if c.depth.is_finite() { c.depth } else { f64::NAN };
            out.push(
                Finding::warning("gap_closes", "forced-response-gap-closes")
                    .of(&c.part)
                    .value(c.from, "rad/s")
                    .arg("speeds", Arg::word(if self.study.speed.is_one() { "one" } else { "several" }))
                    .arg("last", Arg::speed(c.to))
                    .arg("part", Arg::name(&c.part))
                    .arg("gap", Arg::quantity(c.gap, "m"))
                    .evidence("last at speed", c.to, "rad/s")
                    .evidence("deepest penetration", deepest, "m")
                    .evidence("at speed", c.speed, "rad/s"),
            );
        }
        for u in &self.result.observed.outside {
            let finding = if u.ratio.is_finite() {
                Finding::invalid("validity", "forced-response-validity").value(u.ratio, "")
            } else {
                Finding::invalid("validity", "forced-response-validity-unbounded")
            };
            let finding = finding.arg("part", Arg::name(&u.part)).arg("what", Arg::term(u.what)).arg("speed", Arg::speed(u.speed));
            out.push(finding.evidence("at", u.speed, "rad/s").evidence("outside from", u.from, "rad/s").evidence("to", u.to, "rad/s"));
        }
        out
    }

    fn special_points(&self) -> Vec<SpecialPoint> {
        let one = |e: &Extremum| {
            let kind = if e.maximum { "resonance" } else { "antiresonance" };
            let (name, unit) = (self.name(e), self.probes()[e.probe].unit());
            SpecialPoint::new(kind, e.speed, e.bracket).of(name).evidence(probes::size_of(&self.probes()[e.probe]), e.value, unit)
        };
        self.result.curve.extrema.iter().map(one).collect()
    }

    fn response_table(&self) -> Result<Table, Diagnostic> {
        let points = self.points();
        let reported = |what: &'static str| Arg::noted(what, "NaN beside a resonance without bound");
        let column = |f: &dyn Fn(&Response) -> f64| points.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("response", "Linear response to unbalance").float("speed", "rad/s", "spin speed", column(&|r| r.speed));
        for p in self.probes() {
            // the tilt of a body has its own columns, a point those of a body of that name
            let (n, unit) = (probes::owner(p), p.unit());
            let [amplitude, minor, direction, forward, phase, backward, backward_phase] = COLUMNS[usize::from(p.is_tilt())];
            table = table
                .float(format!("{amplitude}.{n}"), unit, reported("semi-major axis of the orbit"), column(&|r| r.size(p)))
                .float(
                    format!("{minor}.{n}"),
                    unit,
                    reported("semi-minor axis of the orbit, negative for backward whirl"),
                    column(&|r| {
                        let (f, b) = r.circles_of(p);
                        f.abs() - b.abs()
                    }),
                )
                .float_if_any(
                    format!("{direction}.{n}"),
                    "rad",
                    "angle of the major axis from x, above -pi/2 and at most pi/2; NaN of a circle, and beside a resonance without bound",
                    column(&|r| r.direction_of(p)),
                )
                .float(format!("{forward}.{n}"), unit, reported("forward amplitude"), column(&|r| r.circles_of(p).0.abs()))
                .float(
                    format!("{phase}.{n}"),
                    "rad",
                    reported("angle of the forward amplitude from the key mark"),
                    column(&|r| r.circles_of(p).0.arg()),
                )
                .float(format!("{backward}.{n}"), unit, reported("backward amplitude"), column(&|r| r.circles_of(p).1.abs()))
                .float(
                    format!("{backward_phase}.{n}"),
                    "rad",
                    reported("angle of the backward amplitude"),
                    column(&|r| r.circles_of(p).1.arg()),
                );
        }
        for shows in &self.result.observed.quantities {
            let name = format!("{}.{}", shows.what, shows.part);
            table = table.float(name, shows.unit, reported("largest value over a turn"), shows.values.clone());
        }
        for (name, meaning, values) in self.boundaries() {
            table = table.float_if_any(name, "m", meaning, values);
        }
        let validity = self.result.observed.validity.clone();
        let table = table.float("validity", "", reported("largest use of a part's validity over a turn; above 1 is outside"), validity);
        table.build().map_err(inconsistent)
    }

    fn extrema_table(&self) -> Result<Table, Diagnostic> {
        let (extrema, probes) = (&self.result.curve.extrema, self.probes());
        let size = |tilt: bool| extrema.iter().map(|e| if probes[e.probe].is_tilt() == tilt { e.value } else { f64::NAN }).collect();
        Table::new("extrema", "Resonances and antiresonances of every body")
            .names("body", "body, point of a body, or tilt of a body", extrema.iter().map(|e| self.name(e)).collect())
            .text(
                "kind",
                "maximum or minimum of the amplitude",
                extrema.iter().map(|e| if e.maximum { "resonance" } else { "antiresonance" }.into()).collect(),
            )
            .float("speed", "rad/s", "spin speed", extrema.iter().map(|e| e.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound, and of a tilt", size(false))
            .float("tilt", "rad", "semi-major axis of the tilt; NaN where it has no bound, and of a displacement", size(true))
            .float_if_any(
                "amplification",
                "",
                "speed of a resonance over the width of its peak at 0.707 of its height (API 684); NaN where the response does not fall so far on both sides",
                extrema.iter().map(|e| self.amplification(e)).collect(),
            )
            .float_if_any(
                "amplification_at_most",
                "",
                "bound of the amplification that is not known: the response stays above 0.707 of the peak up to an end of the range; NaN elsewhere, and without a standard",
                extrema.iter().map(|e| if self.study.margins { self.at_most(e) } else { f64::NAN }).collect(),
            )
            .float_if_any(
                "separation",
                "",
                "distance of a resonance from the nearest operating speed, over that; 0 among them; NaN of an antiresonance",
                extrema.iter().map(|e| self.separation(e)).collect(),
            )
            .float_if_any(
                "required_separation",
                "",
                "separation that the standard requires of a resonance (API 684, SP6.8.2.10); where its amplification is not known, the most that any requires, if that is kept; NaN of an antiresonance, and where it is not decided",
                extrema.iter().map(|e| self.required(e)).collect(),
            )
            .build()
            .map_err(inconsistent)
    }

    /// Speed of a peak over its width at half power.
    fn amplification(&self, e: &Extremum) -> f64 {
        if e.unbounded { f64::NAN } else { self.factors(e).0 }
    }

    /// What that is at most where it is not known.
    fn at_most(&self, e: &Extremum) -> f64 {
        self.factors(e).1
    }

    fn factors(&self, e: &Extremum) -> (f64, f64) {
        let index = self.result.curve.extrema.iter().position(|o| std::ptr::eq(o, e));
        index.map_or((f64::NAN, f64::NAN), |k| self.result.amplification(k))
    }

    /// Distance of a peak from the operating speeds, over the nearest.
    fn separation(&self, e: &Extremum) -> f64 {
        let operating = Speeds::of(self.system).filter(|_| e.maximum);
        operating.map_or(f64::NAN, |o| o.separation(e.speed))
    }

    /// Separation margin required of a peak; NaN without a standard, and where the factor of amplification is not known.
    fn required(&self, e: &Extremum) -> f64 {
        let operating = Speeds::of(self.system).filter(|_| e.maximum && self.study.margins);
        operating.map_or(f64::NAN, |o| required_within(self.factors(e), o.is_above(e.speed), o.separation(e.speed)))
    }

    /// The response stays above half power from a peak up to an end of the range.
    fn ends_beside(&self, e: &Extremum) -> bool {
        let index = self.result.curve.extrema.iter().position(|o| std::ptr::eq(o, e));
        index.and_then(|k| self.result.range_ends.get(k)).is_some_and(|ends| ends.iter().any(|x| x.is_finite()))
    }

    /// Whether the resonances keep the margins that the standard requires: the one that keeps least, or breaks most.
    fn margins(&self) -> Option<Finding> {
        let operating = Speeds::of(self.system).filter(|_| self.study.margins && !self.study.speed.is_one())?;
        let moves = |e: &&Extremum| e.maximum && !self.probes()[e.probe].is_tilt();
        let peaks: Vec<&Extremum> = self.result.curve.extrema.iter().filter(moves).collect();
        let unknown = peaks.iter().filter(|e| self.required(e).is_nan()).count();
        let worst = peaks.iter().filter(|e| self.required(e) > 0.0).min_by(|a, b| {
            let slack = |e: &Extremum| self.separation(e) - self.required(e);
            slack(a).total_cmp(&slack(b))
        });
        let worst = worst.filter(|e| unknown == 0 || !(self.separation(e) >= self.required(e)));
        let Some(e) = worst else {
            if unknown > 0 || !self.result.curve.complete {
                return Some(undecided(peaks.iter().filter(|e| self.required(e).is_nan()).map(|e| Open {
                    speed: e.speed,
                    separation: self.separation(e),
                    below: operating.is_above(e.speed),
                    by_range: self.ends_beside(e),
                })));
            }
            let finding = Finding::info("separation_margin", "forced-response-margin-none");
            let most = peaks.iter().map(|e| self.at_most(e)).filter(|x| x.is_finite()).reduce(f64::max);
            let finding = finding.arg("bounded", Arg::word(if most.is_some() { "yes" } else { "no" }));
            return Some(finding.arg("most", Arg::number(most.unwrap_or(0.0))));
        };
        let (kept, needed) = (self.separation(e), self.required(e));
        let side = match (kept == 0.0, operating.is_above(e.speed)) {
            (true, _) => "among",
            (_, true) => "below",
            _ => "above",
        };
        let finding = match kept >= needed {
            true => Finding::info("separation_margin", "forced-response-margin-kept"),
            false => Finding::warning("separation_margin", "forced-response-margin-broken"),
        };
        let nearest = if operating.is_above(e.speed) { operating.low } else { operating.high };
        let [low, high] =
            self.result.curve.extrema.iter().position(|o| std::ptr::eq(o, *e)).map_or([f64::NAN; 2], |k| self.result.half_power[k]);
        let factor = self.amplification(e);
        let finding = finding
            .of("of the resonance that keeps least")
            .value_as(Arg::percent(kept))
            .arg("required", Arg::percent(needed))
            .arg("resonance", Arg::speed(e.speed))
            .arg("operating", Arg::speed(nearest))
            .arg("side", Arg::word(side))
            .arg("body", probes::arg(&self.probes()[e.probe]))
            .arg(
                "damped",
                Arg::word(if factor.is_nan() {
                    "unknown"
                } else if factor.is_finite() {
                    "yes"
                } else {
                    "no"
                }),
            )
            .arg("factor", Arg::number(if factor.is_nan() { 0.0 } else { factor }))
            .evidence("its speed", e.speed, "rad/s");
        Some(finding.evidence("speed below at half power", low, "rad/s").evidence("speed above at half power", high, "rad/s"))
    }

    /// The highest peaks at different speeds, with their factors of amplification.
    fn peaks(&self) -> Vec<(f64, Message)> {
        let mut found: Vec<&Extremum> =
            self.result.curve.extrema.iter().filter(|e| e.maximum && !e.unbounded && !self.probes()[e.probe].is_tilt()).collect();
        found.sort_by_number_down(|a| a.value);
        let mut out: Vec<(f64, Message)> = Vec::new();
        for e in found {
            let factor = self.amplification(e);
            if factor.is_finite() && factor < SHARPEST && out.len() < LABELLED && out.iter().all(|o| (o.0 / e.speed - 1.0).abs() > ONE_PEAK)
            {
                out.push((e.speed, Message::new("forced-response-amplification").arg("factor", Arg::number(factor).digits(2))));
            }
        }
        out
    }

    fn figure(&self) -> Figure {
        let (probes, points) = (self.probes(), self.points());
        let (mut amplitude, mut phase) = (
            Panel::new(Axis::log("amplitude", "µm").factor(1e6)),
            Panel::new(Axis::new("phase", "°").factor(180.0 / std::f64::consts::PI)),
        );
        let mut tilt = Panel::new(Axis::log("tilt", "mrad").factor(1e3));
        for p in probes {
            if p.is_tilt() {
                tilt = tilt.mark(Line::new("response", "speed", format!("tilt.{}", p.name)).name(probes::label(p)));
            } else {
                let name = probe_name(p);
                amplitude = amplitude.mark(Line::new("response", "speed", format!("amplitude.{name}")).name(probes::label(p)));
                phase = phase
                    .mark(Line::new("response", "speed", format!("phase.{name}")).name(probes::label(p)).cyclic(std::f64::consts::TAU));
            }
        }
        amplitude = self.boundary_lines().into_iter().fold(amplitude, Panel::mark);
        amplitude = self.peaks().into_iter().fold(amplitude, |p, (speed, label)| p.mark(Rule::x(speed, label)));
        let extrema =
            |y: &str| Points::new("extrema", "speed", y).classes("kind", &["resonance", "antiresonance"]).muted(&["antiresonance"]);
        amplitude = amplitude.mark(extrema("amplitude"));
        tilt = tilt.mark(extrema("tilt"));
        if let Some(o) = operating(self.system, self.study.speed.from, self.study.speed.to) {
            [&mut amplitude, &mut phase, &mut tilt].into_iter().for_each(|p| *p = p.clone().mark(o.margin()).mark(o.rule()));
        }
        let [moved, tilted] = self.largest;
        let bounded = match moved.or(tilted) {
            Some(e) if e.unbounded => "no",
            Some(_) => "yes",
            None => "none",
        };
        let alt = Message::new("forced-response-alt")
            .arg("bodies", Arg::count(self.system.stations().len()))
            .arg("bounded", Arg::word(bounded))
            .arg("speed", Arg::speed(moved.or(tilted).map_or(0.0, |e| e.speed)));
        // of a machine that only tilts there is nothing to draw of displacements, of one that does not tilt nothing of tilts
        let largest = |p: &Probe| points.iter().map(|r| r.size(p)).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let loud = probes::loudest(probes.iter().map(|p| (p, largest(p))));
        let some = |tilt: bool| probes.iter().any(|p| p.is_tilt() == tilt && !probes::still(p, largest(p), loud, probes::ROUNDING));
        let figure = Figure::new("response", "Unbalance response", alt).x(Axis::new("spin speed", "rad/s"));
        let figure = if some(false) { figure.panel(amplitude).panel(phase) } else { figure };
        if some(true) { figure.panel(tilt) } else { figure }
    }
}
