//! Tables, figure and findings of the response to a harmonic force.

use super::{HarmonicForce, HarmonicForceResult, Over, Peak, UNBOUNDED};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Message, Outcome, Panel, Points, SpecialPoint, Table};
use crate::solve::linear_response::Response;
use crate::study::Study;
use crate::study::linear::growing::{Follows, unstable};
use crate::study::linear::operating::operating;
use crate::study::shared::half_power::{at_most, factor};
use crate::study::shared::margins::{Open, Speeds, required_within, undecided};
use crate::study::shared::probes;
use crate::study::shared::support::{inconsistent, largest, probe_name};

pub(super) struct Shown<'a> {
    pub study: &'a HarmonicForce,
    pub system: &'a System,
    pub result: &'a HarmonicForceResult,
}

impl Shown<'_> {
    pub(super) fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let r = self.result;
        let mut out =
            Outcome::new(HarmonicForce::KIND, name).over(self.axis(), "rad/s").end(r.end).work("solutions", r.points.len() as u64);
        let findings = unstable(self.system, &r.strongest, &Follows::Response).into_iter().chain(self.findings());
        out = findings.chain(r.states.remarks(self.system)).fold(out, Outcome::finding);
        out = r.peaks.iter().map(|p| self.special(p)).fold(out, Outcome::special_point);
        out = out.table(self.peaks()?).table(self.response()?);
        if r.points.len() > 1 {
            out = out.figure(self.figure());
        }
        out.checked().map_err(inconsistent)
    }

    /// Name of what varies.
    fn axis(&self) -> &'static str {
        match self.study.over {
            Over::Speed(..) => "speed",
            Over::Frequency(..) => "frequency",
        }
    }

    fn probe(&self, p: &Peak) -> &Probe {
        &self.result.probes[p.probe]
    }

    /// A value of what varies.
    fn value(&self, x: f64) -> Arg {
        match self.study.over {
            Over::Speed(..) => Arg::speed(x),
            Over::Frequency(..) => Arg::frequency(x),
        }
    }

    fn amplification(p: &Peak) -> f64 {
        factor(p.at, p.half_power)
    }

    /// What that is at most where it is not known.
    fn at_most(p: &Peak) -> f64 {
        at_most(p.at, p.half_power, p.range_ends)
    }

    fn is_unbounded(p: &Peak) -> bool {
        Self::amplification(p) > UNBOUNDED
    }

    fn separation(&self, p: &Peak) -> f64 {
        match (self.study.over, Speeds::of(self.system)) {
            (Over::Speed(..), Some(o)) => o.separation(p.at),
            _ => f64::NAN,
        }
    }

    fn required(&self, p: &Peak) -> f64 {
        let operating = Speeds::of(self.system).filter(|_| self.study.margins);
        operating.map_or(f64::NAN, |o| required_within((Self::amplification(p), Self::at_most(p)), o.is_above(p.at), o.separation(p.at)))
    }

    fn special(&self, p: &Peak) -> SpecialPoint {
        let probe = self.probe(p);
        SpecialPoint::new("resonance", p.at, p.bracket).of(probe_name(probe)).evidence(probes::size_of(probe), p.value, probe.unit())
    }

    fn response(&self) -> Result<Table, Diagnostic> {
        let points = &self.result.points;
        let column = |f: &dyn Fn(&Response) -> f64| points.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("response", "Linear response to a harmonic force");
        table = match self.study.over {
            Over::Speed(..) => table.float("speed", "rad/s", "spin speed", column(&|r| r.speed)),
            Over::Frequency(..) => table.float("frequency", "rad/s", "frequency of the force", column(&|r| r.speed)),
        };
        for p in &self.result.probes {
            let n = probes::owner(p);
            let [amplitude, minor, phase] = match p.is_tilt() {
                false => ["amplitude", "minor", "phase"],
                true => ["tilt", "tilt_minor", "tilt_phase"],
            };
            let circles = |r: &Response| r.circles_of(p);
            table = table
                .float(format!("{amplitude}.{n}"), p.unit(), "semi-major axis of the orbit", column(&|r| r.size(p)))
                .float(
                    format!("{minor}.{n}"),
                    p.unit(),
                    "semi-minor axis of the orbit, negative for backward whirl",
                    column(&|r| circles(r).0.abs() - circles(r).1.abs()),
                )
                .float(
                    format!("{phase}.{n}"),
                    "rad",
                    "phase of the displacement in x against the force",
                    column(&|r| p.amplitudes(&r.x)[0].arg()),
                );
        }
        table.build().map_err(inconsistent)
    }

    fn peaks(&self) -> Result<Table, Diagnostic> {
        let peaks = &self.result.peaks;
        let column = |f: &dyn Fn(&Peak) -> f64| peaks.iter().map(f).collect::<Vec<f64>>();
        let size = |tilt: bool| column(&|p| if self.probe(p).is_tilt() == tilt && !Self::is_unbounded(p) { p.value } else { f64::NAN });
        let table = Table::new("peaks", "Maxima of the response to a harmonic force").leading().names(
            "body",
            "body, point of a body, or tilt of a body",
            peaks.iter().map(|p| probe_name(self.probe(p))).collect(),
        );
        let table = match self.study.over {
            Over::Speed(..) => table.float("speed", "rad/s", "spin speed", column(&|p| p.at)),
            Over::Frequency(..) => table.float("frequency", "rad/s", "frequency of the force", column(&|p| p.at)),
        };
        table
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound, and of a tilt", size(false))
            .float("tilt", "rad", "semi-major axis of the tilt; NaN where it has no bound, and of a displacement", size(true))
            .float_if_any(
                "amplification",
                "",
                "place of the peak over its width at 0.707 of its height (API 684); NaN where the response does not fall so far on both sides, or has no bound",
                column(&|p| if Self::is_unbounded(p) { f64::NAN } else { Self::amplification(p) }),
            )
            .float_if_any(
                "amplification_at_most",
                "",
                "bound of the amplification that is not known: the response stays above 0.707 of the peak up to an end of the range; NaN elsewhere, and without a standard",
                column(&|p| if self.study.margins { Self::at_most(p) } else { f64::NAN }),
            )
            .float_if_any(
                "separation",
                "",
                "distance of a peak from the nearest operating speed, over that; 0 among them; NaN without one, and over the frequency",
                column(&|p| self.separation(p)),
            )
            .float_if_any(
                "required_separation",
                "",
                "separation that the standard requires of a peak (API 684, SP6.8.2.10); where its amplification is not known, the most that any requires, if that is kept; NaN without a standard, and where it is not decided",
                column(&|p| self.required(p)),
            )
            .build()
            .map_err(inconsistent)
    }

    fn figure(&self) -> Figure {
        let mut panels = [Panel::new(Axis::log("amplitude", "µm").factor(1e6)), Panel::new(Axis::log("tilt", "mrad").factor(1e3))];
        let x = self.axis();
        for p in &self.result.probes {
            let column = format!("{}.{}", if p.is_tilt() { "tilt" } else { "amplitude" }, probes::owner(p));
            let panel = &mut panels[usize::from(p.is_tilt())];
            *panel = panel.clone().mark(Line::new("response", x, column).name(probes::label(p)));
        }
        let points = &self.result.points;
        let moving = |p: &Probe| points.iter().map(|r| r.size(p)).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let loud = probes::loudest(self.result.probes.iter().map(|p| (p, moving(p))));
        let some =
            |tilt: bool| self.result.probes.iter().any(|p| p.is_tilt() == tilt && !probes::still(p, moving(p), loud, probes::ROUNDING));
        let (title, axis) = match self.study.over {
            Over::Speed(..) => ("Response to a force that follows the speed", Axis::new("spin speed", "rad/s")),
            Over::Frequency(..) => ("Response to a force over its frequency", Axis::new("frequency of the force", "rad/s")),
        };
        let alt = Message::new("harmonic-force-alt").arg("peaks", Arg::count(self.result.peaks.len()));
        let [mut amplitude, tilt] = panels;
        amplitude = amplitude.mark(Points::new("peaks", x, "amplitude").name("resonance"));
        if let (Over::Speed(range, _), true) = (self.study.over, true)
            && let Some(o) = operating(self.system, range.from, range.to)
        {
            amplitude = amplitude.mark(o.rule());
        }
        let figure = Figure::new("response", title, alt).x(axis);
        let figure = if some(false) { figure.panel(amplitude) } else { figure };
        if some(true) { figure.panel(tilt.mark(Points::new("peaks", x, "tilt").name("resonance"))) } else { figure }
    }

    fn findings(&self) -> Vec<Finding> {
        let r = self.result;
        let residual = largest(r.points.iter().map(|p| p.residual));
        let mut out = Vec::new();
        let over = Arg::word(self.axis());
        if let [one] = &r.points[..] {
            for p in r.probes.iter().filter(|p| !p.is_tilt()) {
                let finding = Finding::info("amplitude", "harmonic-force-amplitude").of(probe_name(p)).value(one.size(p), p.unit());
                out.push(finding.arg("body", probes::arg(p)).arg("speed", Arg::speed(one.speed)).evidence("residual", residual, ""));
            }
            return out;
        }
        let moving: Vec<&Peak> = r.peaks.iter().filter(|p| !self.probe(p).is_tilt()).collect();
        match moving.iter().max_by(|a, b| a.value.total_cmp(&b.value)) {
            Some(p) if Self::is_unbounded(p) => {
                let finding = Finding::warning("undamped_resonance", "harmonic-force-unbounded").value_as(self.value(p.at));
                out.push(finding.arg("body", probes::arg(self.probe(p))).evidence("residual", residual, ""));
            }
            Some(p) => {
                let finding = Finding::info("largest_resonance", "harmonic-force-largest").value_as(self.value(p.at));
                let amplification = Self::amplification(p);
                let finding = finding
                    .arg("amplitude", Arg::quantity(p.value, "m"))
                    .arg("body", probes::arg(self.probe(p)))
                    .arg("known", Arg::word(if amplification.is_finite() { "yes" } else { "no" }))
                    .arg("factor", Arg::number(if amplification.is_finite() { amplification } else { 0.0 }))
                    .arg("over", over.clone());
                let [low, high] = p.half_power;
                let finding = finding.evidence("amplitude", p.value, "m").evidence("residual", residual, "");
                // within the range there may be none
                let sides = [("frequency or speed below at half power", low), ("frequency or speed above at half power", high)];
                let known = sides.into_iter().filter(|s| s.1.is_finite());
                out.push(known.fold(finding, |f, (what, at)| f.evidence(what, at, "rad/s")));
            }
            None => out.push(Finding::info("no_resonance", "harmonic-force-none").arg("over", over.clone())),
        }
        if self.study.margins {
            out.push(self.margins(&moving));
        }
        if !r.known {
            out.push(Finding::info("frequency_only", "harmonic-force-frequency-only"));
        }
        for c in &r.closed {
            let depth = if c.depth.is_finite() { c.depth } else { f64::NAN };
            let finding = Finding::warning("gap_closes", "harmonic-force-gap-closes").of(&c.part).value_as(self.value(c.from));
            let finding = finding.arg("part", Arg::name(&c.part)).arg("gap", Arg::quantity(c.gap, "m")).arg("last", self.value(c.to));
            out.push(finding.evidence("deepest penetration", depth, "m"));
        }
        for u in &r.outside {
            let finding = if u.ratio.is_finite() {
                Finding::invalid("validity", "harmonic-force-validity").value(u.ratio, "")
            } else {
                Finding::invalid("validity", "harmonic-force-validity-unbounded")
            };
            out.push(finding.of(&u.part).arg("part", Arg::name(&u.part)).arg("what", Arg::term(u.what)).arg("place", self.value(u.speed)));
        }
        for x in &r.singular {
            out.push(Finding::warning("undamped_resonance", "harmonic-force-singular").value_as(self.value(*x)));
        }
        out
    }

    /// Whether the peaks keep the margins of the standard: the one that keeps least.
    fn margins(&self, peaks: &[&Peak]) -> Finding {
        let unknown = peaks.iter().any(|p| self.required(p).is_nan());
        let slack = |p: &Peak| self.separation(p) - self.required(p);
        let worst = peaks.iter().filter(|p| self.required(p) > 0.0).min_by(|a, b| slack(a).total_cmp(&slack(b)));
        match worst {
            Some(p) if !unknown || !(slack(p) >= 0.0) => {
                let finding = match slack(p) >= 0.0 {
                    true => Finding::info("separation_margin", "harmonic-force-margin-kept"),
                    false => Finding::warning("separation_margin", "harmonic-force-margin-broken"),
                };
                finding
                    .of("of the resonance that keeps least")
                    .value_as(Arg::percent(self.separation(p)))
                    .arg("required", Arg::percent(self.required(p)))
                    .arg("resonance", Arg::speed(p.at))
                    .arg("factor", Arg::number(if Self::amplification(p).is_nan() { 0.0 } else { Self::amplification(p) }))
                    .arg("known", Arg::word(if Self::amplification(p).is_nan() { "no" } else { "yes" }))
                    .evidence("its speed", p.at, "rad/s")
            }
            _ if unknown || !self.result.end.is_complete() => {
                let operating = Speeds::of(self.system);
                undecided(peaks.iter().filter(|p| self.required(p).is_nan()).map(|p| Open {
                    speed: p.at,
                    separation: self.separation(p),
                    below: operating.is_some_and(|o| o.is_above(p.at)),
                    by_range: p.range_ends.iter().any(|x| x.is_finite()),
                }))
            }
            _ => {
                let most = peaks.iter().map(|p| Self::at_most(p)).filter(|x| x.is_finite()).reduce(f64::max);
                Finding::info("separation_margin", "forced-response-margin-none")
                    .arg("bounded", Arg::word(if most.is_some() { "yes" } else { "no" }))
                    .arg("most", Arg::number(most.unwrap_or(0.0)))
            }
        }
    }
}
