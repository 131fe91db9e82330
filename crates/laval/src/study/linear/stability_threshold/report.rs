//! Tables, figure and findings of the stability over a cross-coupled stiffness.

use super::region::{DENSE, Region, RigidLimit, speed_ratio_limit};
use super::{StabilityThreshold, ThresholdResult, decrement};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Line as Curve, Message, Outcome, Panel, Points, Rule, SpecialPoint, Table};
use crate::solve::cross_coupling::{Crossing, Line, NEUTRAL, Point};
use crate::study::Study;
use crate::study::linear::whirl;
use crate::study::shared::place;
use crate::study::shared::support::{RPM, inconsistent, remarks};

pub(super) struct Shown<'a> {
    pub study: &'a StabilityThreshold,
    pub system: &'a System,
    pub result: &'a ThresholdResult,
}

/// Least logarithmic decrement at the anticipated stiffness, and least threshold over it: API 684, SP6.8.5.10.
const DECREMENT: f64 = 0.1;
const RATIO: f64 = 2.0;
/// Threshold over the anticipated stiffness up to which the density of the gas counts as well: there.
const DENSITY: f64 = 10.0;

impl Shown<'_> {
    pub(super) fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let r = self.result;
        let solved: usize = r.lines.lines.iter().map(|l| l.points.len()).sum();
        let mut outcome =
            Outcome::new(StabilityThreshold::KIND, name).over("stiffness", "N/m").end(r.end).work("roots followed", solved as u64);
        outcome = self.findings().into_iter().chain(remarks(self.system, &r.about)).fold(outcome, Outcome::finding);
        outcome = self.crossings().map(|(_, c)| special(c)).fold(outcome, Outcome::special_point);
        outcome = outcome.table(self.thresholds()?).table(self.modes()?).figure(self.figure());
        outcome.checked().map_err(inconsistent)
    }

    fn crossings(&self) -> impl Iterator<Item = (usize, &Crossing)> {
        self.result.lines.lines.iter().enumerate().flat_map(|(k, l)| l.crossings.iter().map(move |c| (k, c)))
    }

    /// The mode that becomes unstable first, and where.
    fn first(&self) -> Option<(usize, &Crossing)> {
        self.crossings().filter(|c| c.1.onset).min_by(|a, b| a.1.at.stiffness.total_cmp(&b.1.at.stiffness))
    }

    /// The mode with the least logarithmic decrement at a stiffness: at a value computed.
    fn least(&self, stiffness: f64) -> Option<(usize, &Point)> {
        let all = self.result.lines.lines.iter().enumerate();
        let there = all.flat_map(|(k, l)| l.points.iter().filter(|p| p.stiffness == stiffness).map(move |p| (k, p)));
        there.filter(|x| decrement(x.1).is_finite()).min_by(|a, b| decrement(a.1).total_cmp(&decrement(b.1)))
    }

    /// The first forward mode at a stiffness: at a value computed.
    fn first_forward(&self, stiffness: f64) -> Option<(usize, &Point)> {
        let lines = &self.result.lines.lines;
        let k = self.result.forward?;
        lines.get(k)?.points.iter().find(|p| p.stiffness == stiffness).map(|p| (k, p))
    }

    /// No mode grows below the first threshold, or up to the largest stiffness without one: by a count at any frequency.
    fn proven(&self) -> bool {
        let lines = &self.result.lines;
        let counted = match self.first() {
            Some((_, c)) => c.at.stiffness == 0.0 || c.growing[0] == Some(0),
            None => lines.growing.is_some_and(|[all, among]| all == among),
        };
        counted && lines.below.is_none()
    }

    /// A mode grows without the stiffness.
    fn already(&self) -> bool {
        let at_zero = |l: &Line| l.points.first().is_some_and(|p| p.stiffness == 0.0 && p.value.re > NEUTRAL * p.value.abs());
        self.result.lines.lines.iter().any(at_zero)
    }

    fn direction(&self, line: &Line) -> Message {
        whirl::direction(line.whirl.at(self.study.speed), line.forward_share)
    }

    fn thresholds(&self) -> Result<Table, Diagnostic> {
        let all: Vec<(usize, &Crossing)> = self.crossings().collect();
        let column = |f: &dyn Fn(&Crossing) -> f64| all.iter().map(|x| f(x.1)).collect::<Vec<f64>>();
        let count = |k: usize| column(&|c| c.growing[k].map_or(f64::NAN, |n| n as f64));
        Table::new("thresholds", "Cross-coupled stiffness at which the growth rate of a mode is zero")
            .leading()
            .int("mode", "", "number of the mode in the figure", all.iter().map(|x| x.0 as i64 + 1).collect())
            .float("stiffness", "N/m", "cross-coupled stiffness", column(&|c| c.at.stiffness))
            .text(
                "becomes",
                "unstable or stable above it",
                all.iter().map(|x| if x.1.onset { "unstable" } else { "stable" }.into()).collect(),
            )
            .float("frequency", "rad/s", "frequency of the mode", column(&|c| c.at.value.im))
            .text("whirl", "direction of whirl", all.iter().map(|x| x.1.whirl.at(self.study.speed).word().into()).collect())
            .float("decrement", "", "logarithmic decrement, 0 to rounding", column(&|c| decrement(&c.at)))
            .float("uncertainty", "N/m", "growth rate left over, over its derivative", column(&|c| c.uncertainty))
            .float_if_any(
                "growing_below",
                "",
                "growing modes just below, of the whole machine; NaN where the count is not complete",
                count(0),
            )
            .float_if_any(
                "growing_above",
                "",
                "growing modes just above, of the whole machine; NaN where the count is not complete",
                count(1),
            )
            .build()
            .map_err(inconsistent)
    }

    fn modes(&self) -> Result<Table, Diagnostic> {
        let lines = self.result.lines.lines.iter().enumerate();
        let rows: Vec<(usize, &Line, &Point)> = lines.flat_map(|(k, l)| l.points.iter().map(move |p| (k, l, p))).collect();
        let column = |f: fn(&Point) -> f64| rows.iter().map(|x| f(x.2)).collect::<Vec<f64>>();
        Table::new("modes", "Modes over the cross-coupled stiffness")
            .float("stiffness", "N/m", "cross-coupled stiffness", column(|p| p.stiffness))
            .int("mode", "", "number of the mode", rows.iter().map(|x| x.0 as i64 + 1).collect())
            .float("growth", "1/s", "growth rate", column(|p| p.value.re))
            .float("frequency", "rad/s", "frequency", column(|p| p.value.im))
            .float("frequency_cpm", "rpm", "the same", column(|p| p.value.im * RPM))
            .float_if_any("decrement", "", "logarithmic decrement; NaN where the mode does not oscillate", column(decrement))
            .float("growth_by_stiffness", "m/(N s)", "derivative of the growth rate over the stiffness, exact", column(|p| p.slope.re))
            .text("curve", "curve of the figure", rows.iter().map(|x| curve(x.0)).collect())
            .build()
            .map_err(inconsistent)
    }

    fn figure(&self) -> Figure {
        let name = |(k, l): (usize, &Line)| {
            let first = l.points.first().map_or(f64::NAN, |p| p.value.im);
            let message = Message::new("stability-threshold-curve").arg("mode", Arg::count(k + 1)).arg("whirl", self.direction(l));
            (curve(k), message.arg("frequency", Arg::frequency(first)).into())
        };
        let names: Vec<(String, Arg)> = self.result.lines.lines.iter().enumerate().map(name).collect();
        let mut panel = Panel::new(Axis::new("logarithmic decrement", ""))
            .height(1.4)
            .mark(Curve::new("modes", "stiffness", "decrement").group("curve").called(names.clone()))
            .mark(Rule::y(0.0, "unstable below"));
        if let Some((_, c)) = self.first() {
            panel = panel.mark(Rule::x(c.at.stiffness, "threshold"));
        }
        if let Some(q) = self.study.anticipated {
            panel = panel.mark(Rule::x(q, "anticipated")).mark(Rule::y(DECREMENT, "level 1"));
        }
        let frequencies = Panel::new(Axis::new("frequency", "rad/s"))
            .height(0.7)
            .mark(Curve::new("modes", "stiffness", "frequency").group("curve").called(names));
        let crossings = self.crossings().count();
        if crossings > 0 {
            panel = panel.mark(Points::new("thresholds", "stiffness", "decrement").name("threshold"));
        }
        let alt = Message::new("stability-threshold-alt")
            .arg("modes", Arg::count(self.result.lines.lines.len()))
            .arg("thresholds", Arg::count(crossings));
        let axis = Axis::new("cross-coupled stiffness", "N/m");
        let axis = if self.study.logarithmic { Axis::log("cross-coupled stiffness", "N/m") } else { axis };
        Figure::new("decrement", "Logarithmic decrement over the cross-coupled stiffness", alt).x(axis).panel(panel).panel(frequencies)
    }

    fn findings(&self) -> Vec<Finding> {
        let (r, w) = (self.result, self.study.speed);
        let place = || place::label(&self.study.place);
        let mut out = Vec::new();
        let complete = r.end.is_complete();
        let last = r.lines.lines.iter().flat_map(|l| &l.points).map(|p| p.stiffness).fold(0.0, f64::max);
        let of = |finding: Finding| finding.arg("speed", Arg::speed(w)).arg("place", place());
        let already = self.already();
        let proven = self.proven();
        match self.first() {
            // that of another mode is no threshold of a machine that is unstable already
            Some((_, c)) if already && c.at.stiffness > 0.0 => {}
            Some((k, c)) => {
                let finding = of(Finding::info("threshold", "stability-threshold-threshold"))
                    .value(c.at.stiffness, "N/m")
                    .arg("mode", Arg::count(k + 1))
                    .arg("whirl", whirl::direction(c.whirl.at(w), c.forward_share))
                    .arg("frequency", Arg::frequency(c.at.value.im))
                    .arg("damped", Arg::word(if c.at.stiffness == 0.0 { "no" } else { "yes" }))
                    .evidence("growth rate left over, over its derivative", c.uncertainty, "N/m")
                    .evidence("derivative of the growth rate over the stiffness", c.at.slope.re, "m/(N s)");
                let [below, above] = c.growing.map(|n| n.map_or(f64::NAN, |n| n as f64));
                out.push(finding.evidence("growing modes just below", below, "").evidence("growing modes just above", above, ""));
            }
            None if already => {}
            None if complete && proven => out.push(of(Finding::info("no_threshold", "stability-threshold-none")).value(last, "N/m")),
            None => out.push(of(Finding::warning("threshold_unknown", "stability-threshold-unknown")).value(last, "N/m")),
        }
        if let Some((k, p)) = self.least(0.0) {
            let finding = match already {
                true => Finding::warning("unstable_without", "stability-threshold-unstable-without"),
                false => Finding::info("base_decrement", "stability-threshold-base"),
            };
            let line = &r.lines.lines[k];
            let finding = of(finding.value(decrement(p), "")).arg("mode", Arg::count(k + 1)).arg("whirl", self.direction(line));
            out.push(finding.arg("frequency", Arg::frequency(p.value.im)).evidence("growth rate", p.value.re, "1/s"));
        }
        out.extend(self.level_1(complete));
        let mut meetings: Vec<f64> = r.lines.meetings.iter().map(|m| 0.5 * (m.0 + m.1)).collect();
        meetings.sort_by(f64::total_cmp);
        meetings.dedup_by(|b, a| (*b - *a).abs() <= 1e-3 * a.abs());
        for q in meetings {
            let widest = r.lines.meetings.iter().filter(|m| (m.0 - q).abs() <= 1e-3 * q).map(|m| m.1 - m.0).fold(0.0, f64::max);
            out.push(Finding::info("meeting", "stability-threshold-meeting").value(q, "N/m").evidence(
                "width of the bracket",
                widest,
                "N/m",
            ));
        }
        if r.lines.lost > 0 {
            out.push(Finding::warning("lost", "stability-threshold-lost").arg("modes", Arg::count(r.lines.lost)));
        }
        if let Some([all, among]) = r.lines.growing {
            let finding = if all == among {
                let limit = r.lines.below;
                Finding::info("counted", "stability-threshold-counted")
                    .arg("range", Arg::word(if limit.is_some() { "below" } else { "all" }))
                    .arg("limit", limit.map_or(Arg::word("all"), Arg::frequency))
            } else {
                Finding::warning("missed", "stability-threshold-missed").arg("missed", Arg::count(all.saturating_sub(among)))
            };
            let finding = finding.arg("growing", Arg::count(all)).arg("stiffness", Arg::quantity(last, "N/m"));
            out.push(finding.arg("followed", Arg::count(r.lines.lines.len())).arg("modes", Arg::count(r.lines.modes)));
        } else if complete {
            out.push(Finding::warning("not_counted", "stability-threshold-not-counted").arg("stiffness", Arg::quantity(last, "N/m")));
        }
        out
    }

    /// The criteria of level 1 at the anticipated stiffness.
    fn level_1(&self, complete: bool) -> Option<Finding> {
        let anticipated = self.study.anticipated?;
        let (k, p) = self.first_forward(anticipated).or_else(|| self.least(anticipated))?;
        let decrement = decrement(p);
        let ratio = self.first().map(|(_, c)| c.at.stiffness / anticipated);
        // without a threshold up to the largest value the ratio is at least that
        let least = ratio.unwrap_or(self.result.values.last().copied().unwrap_or(f64::NAN) / anticipated);
        // a machine that is unstable without the stiffness has no threshold
        let (ratio, least) = if self.already() { (Some(0.0), 0.0) } else { (ratio, least) };
        let proven = self.proven() || self.already();
        let known = complete && (ratio.is_some_and(|r| r < RATIO) || proven && (ratio.is_some() || least >= RATIO));
        let counts = !(least >= DENSITY);
        let counted = if counts { "yes" } else { "no" };
        let region = self.study.gas_density.filter(|_| counts && !(least < RATIO)).map(|density| (density, self.region(density)));
        // a larger threshold than the largest value may lift the ratio to where the density does not count
        let third = match region {
            None | Some((_, Region::A)) => Some(true),
            Some((_, Region::B)) if ratio.is_some() => Some(false),
            Some(_) => None,
        };
        let passes = decrement >= DECREMENT && least >= RATIO && third == Some(true);
        let finding = match (passes, (known && third.is_some()) || decrement < DECREMENT) {
            (true, true) => Finding::info("level_1", "stability-threshold-level-1"),
            (false, true) => Finding::warning("level_1", "stability-threshold-level-2"),
            _ => Finding::warning("level_1", "stability-threshold-level-open"),
        };
        let finding = finding
            .value(decrement, "")
            .arg("anticipated", Arg::quantity(anticipated, "N/m"))
            .arg("mode", Arg::count(k + 1))
            .arg("least_decrement", Arg::number(DECREMENT))
            .arg("least_ratio", Arg::number(RATIO))
            .arg("ratio", Arg::number(least))
            .arg(
                "reached",
                Arg::word(if complete && !proven && !known {
                    "uncounted"
                } else if ratio.is_some() {
                    "yes"
                } else {
                    "no"
                }),
            )
            .arg("density", Arg::word(if region.is_some() { "region" } else { counted }));
        let finding = finding.evidence("growth rate", p.value.re, "1/s").evidence("threshold over the anticipated stiffness", least, "");
        let Some((density, region)) = region else { return Some(finding) };
        let finding = finding
            .arg("region", self.region_sentence(density, region))
            .evidence("critical speed ratio", self.speed_ratio(), "")
            .evidence("largest critical speed ratio at this gas density", speed_ratio_limit(density), "");
        let Some(RigidLimit::Found { speed, difference, .. }) = self.result.rigid else { return Some(finding) };
        Some(finding.evidence("first critical speed on rigid supports", speed, "rad/s").evidence(
            "difference with ten times the support stiffness, over it",
            difference,
            "",
        ))
    }

    /// Speed over the first critical speed on rigid supports; NaN where that is not known.
    fn speed_ratio(&self) -> f64 {
        match self.result.rigid {
            Some(RigidLimit::Found { speed, .. }) => self.study.speed.abs() / speed,
            _ => f64::NAN,
        }
    }

    fn region(&self, density: f64) -> Region {
        Region::of(self.speed_ratio(), density)
    }

    /// The region of a gas density with its numbers, or why it is not known.
    fn region_sentence(&self, density: f64, region: Region) -> Message {
        let sentence = |word: &'static str| {
            Message::new("stability-threshold-region")
                .arg("region", Arg::word(word))
                .arg("gas_density", Arg::quantity(density, "kg/m^3"))
                .arg("largest_density", Arg::quantity(DENSE, "kg/m^3"))
        };
        match (region, &self.result.rigid) {
            (Region::B, _) if density > DENSE => sentence("dense"),
            (Region::A | Region::B, Some(RigidLimit::Found { supports, .. })) => {
                let names = supports.iter().filter_map(|&k| self.system.slots().get(k)).map(|s| s.name.clone());
                sentence(if region == Region::A { "a" } else { "b" })
                    .arg("critical_ratio", Arg::number(self.speed_ratio()))
                    .arg("speed_ratio_limit", Arg::number(speed_ratio_limit(density)))
                    .arg("parts", Arg::names(names))
            }
            (_, Some(RigidLimit::Unknown(why))) => Message::new("stability-threshold-region-open").arg("reason", Arg::word(why.word())),
            _ => Message::new("stability-threshold-region-open").arg("reason", Arg::word("number")),
        }
    }
}

/// Name of a curve.
fn curve(k: usize) -> String {
    format!("mode {}", k + 1)
}

fn special(c: &Crossing) -> SpecialPoint {
    let half = c.uncertainty.max(1e-12 * c.at.stiffness);
    SpecialPoint::new("threshold", c.at.stiffness, (c.at.stiffness - half, c.at.stiffness + half)).evidence(
        "frequency",
        c.at.value.im,
        "rad/s",
    )
}
