//! Findings, tables and the figure of basins.

use super::super::start;
use super::super::steady_state::period::{LONGEST, Verdict};
use super::super::steady_state::{RUNAWAY, UNBOUNDED, stored};
use super::attractors::{AGREE, Attractor, AttractorSet, Motion};
use super::rows::{self, PLACE};
use super::{Basins, BasinsResult, MotionBasins};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, End, Figure, Finding, Heat, Message, Outcome, Panel, Points, Table, quantity_to};
use crate::study::Study;
use crate::study::shared::probes;
use crate::study::shared::support::inconsistent;
use crate::text;
use std::collections::BTreeMap;

/// Attractors of which a finding speaks.
const MOST_REPORTED: usize = 8;

/// All rows, the undisturbed start first, and what they are.
struct Map<'a> {
    study: &'a Basins,
    data: &'a MotionBasins,
    /// What is recorded of every motion.
    probes: Vec<Probe>,
    place: Vec<[f64; 2]>,
    /// Word of the assessment.
    motion: Vec<String>,
    /// Why there is none.
    failure: Vec<String>,
    motions: Vec<Motion>,
    /// By probe.
    amplitude: Vec<Vec<f64>>,
    /// The probe by which attractors are ordered and named.
    lead: usize,
    /// By body.
    rms: Vec<Vec<f64>>,
    found: &'a AttractorSet,
}

impl<'a> Map<'a> {
    fn read(study: &'a Basins, system: &System, data: &'a MotionBasins) -> Result<Self, Diagnostic> {
        let (results, probes) = (&data.motions, probes::all(system));
        let means: Vec<String> = system.stations().iter().map(|b| format!("rms.{}", b.name)).collect();
        let own = [PLACE[0], PLACE[1], "failure", "bounded", "validity", "steps", "periods"].map(String::from);
        stored::check(results, own.into_iter().chain(probes.iter().map(probes::column)).chain(means.iter().cloned()))?;
        let motions = rows::motions(study, results, &data.states, &probes, &data.modes)?;
        if data.attractors.of.len() != motions.len() {
            return Err(Diagnostic::error("basins.rows", text!("the attractors are not those of these motions")));
        }
        Ok(Map {
            study,
            data,
            place: results.numbers(PLACE[0]).into_iter().zip(results.numbers(PLACE[1])).map(|(x, y)| [x, y]).collect(),
            motion: results.words("motion"),
            failure: results.words("failure"),
            motions,
            amplitude: probes.iter().map(|p| results.numbers(&probes::column(p))).collect(),
            lead: rows::lead(study, results, &probes).unwrap_or(0),
            rms: means.iter().map(|m| results.numbers(m)).collect(),
            found: &data.attractors,
            probes,
        })
    }

    /// Rows of the grid.
    fn cells(&self) -> std::ops::Range<usize> {
        1.min(self.place.len())..self.place.len()
    }

    /// Cells of an attractor.
    fn count(&self, a: &Attractor) -> usize {
        a.members.iter().filter(|&&m| m > 0).count()
    }

    /// What a row ends in.
    fn word(&self, row: usize) -> String {
        match self.found.of[row] {
            Some(k) => self.name(k),
            None if self.motion[row] == Verdict::Failed("").word() => "failed".into(),
            None => "not settled".into(),
        }
    }

    fn name(&self, k: usize) -> String {
        if self.found.attractors[k].period.is_some() { format!("attractor {}", k + 1) } else { "does not repeat".into() }
    }

    /// An attractor by its size, as figures name it.
    fn sized(&self, k: usize) -> String {
        let a = &self.found.attractors[k];
        let size = self.probes.get(self.lead).map(|p| (self.peak(a, self.lead), p)).filter(|s| s.0.is_finite());
        match (a.period, size) {
            (Some(_), Some((size, p))) => format!("{} {} ({})", p.name, quantity_to(size, p.unit(), 3), self.name(k)),
            _ => self.name(k),
        }
    }

    /// The same in the legend.
    fn sized_phrase(&self, k: usize) -> Arg {
        let size = self.probes.get(self.lead).map(|p| (self.peak(&self.found.attractors[k], self.lead), p)).filter(|s| s.0.is_finite());
        match size {
            Some((size, p)) => Message::new("basins-sized")
                .arg("body", Arg::name(&p.name))
                .arg("size", Arg::quantity(size, p.unit()))
                .arg("attractor", Arg::count(k + 1))
                .into(),
            None => self.attractor(k).into(),
        }
    }

    /// What a row ends in, as figures name it.
    fn shown(&self, row: usize) -> String {
        self.found.of[row].map_or_else(|| self.word(row), |k| self.sized(k))
    }

    /// A pair of initial values.
    fn at(&self, place: [f64; 2]) -> Arg {
        let one = |k: usize| {
            let axis = &self.study.axes[k];
            Message::new("basins-initial-value")
                .arg("state", Arg::name(&axis.name))
                .arg("value", Arg::quantity(place[k], &axis.unit))
                .into()
        };
        Arg::List((0..2).filter(|&k| place[k].is_finite()).map(one).collect())
    }

    /// An attractor in a sentence.
    fn attractor(&self, k: usize) -> Message {
        match self.found.attractors[k].period {
            Some(_) => Message::new("basins-attractor").arg("attractor", Arg::count(k + 1)),
            None => Message::new("basins-irregular").arg("turns", Arg::count(LONGEST)),
        }
    }

    /// Largest value of a probe on an attractor.
    fn peak(&self, a: &Attractor, b: usize) -> f64 {
        match a.period {
            Some(_) => self.amplitude[b][a.best],
            None => a.members.iter().map(|&m| self.amplitude[b][m]).fold(f64::NAN, f64::max),
        }
    }
}

pub(super) fn report(
    study: &Basins,
    system: &System,
    (result, data): (&BasinsResult, &MotionBasins),
    name: &str,
) -> Result<Outcome, Diagnostic> {
    let (map, results) = (Map::read(study, system, data)?, &data.motions);
    let mut outcome = Outcome::new(Basins::KIND, name).end(result.end);
    let axes = &study.axes;
    for f in results.remark_of("motions").into_iter().chain(start::undeflected(&result.undeflected)) {
        outcome = outcome.finding(f);
    }
    outcome = cut_short(&map, outcome);
    outcome = shares(&map, outcome);
    outcome = failures(&map, outcome);
    outcome = disturbance(&map, results.end == End::Reached, outcome);
    outcome = undecided(&map, outcome);
    let at = |row: usize, f: Finding| {
        let place = map.place[row];
        (0..2).fold(f, |f, k| f.evidence(axes[k].label(), place[k], axes[k].unit.clone()))
    };
    outcome = stored::limits(results, at, outcome);
    let steps = results.numbers("steps").iter().sum::<f64>();
    outcome = outcome.work("motions", results.done).work("steps", steps as u64);
    outcome = tables(&map, outcome)?;
    figure(&map, outcome).checked().map_err(inconsistent)
}

/// Number of attractors, and the share of the cells that ends in each.
fn shares(map: &Map, mut outcome: Outcome) -> Outcome {
    let cells = map.cells().len();
    if cells == 0 {
        return outcome;
    }
    let own: Vec<(usize, &Attractor, usize)> =
        map.found.attractors.iter().enumerate().map(|(k, a)| (k, a, map.count(a))).filter(|x| x.2 > 0).collect();
    let repeating = own.iter().filter(|x| x.1.period.is_some()).count();
    let tolerance = AGREE * map.study.rules.tolerance;
    let mut finding = Finding::info("attractors", "basins-attractors")
        .value(repeating as f64, "")
        .arg("count", Arg::count(repeating))
        .arg("speed", Arg::speed(map.study.speed))
        .arg("turns", Arg::count(LONGEST))
        .evidence("cells", cells as f64, "");
    finding = finding.evidence("distance over the size of a motion that counts as the same", tolerance, "");
    if let Some(gap) = map.found.gap {
        finding = finding.evidence("smallest distance of two attractors of one period over their size", gap, "");
    }
    outcome = outcome.finding(finding);
    let mut by_share = own.clone();
    by_share.sort_by_key(|x| (std::cmp::Reverse(x.2), x.0));
    for &(k, a, count) in by_share.iter().take(MOST_REPORTED) {
        let (p, error) = share(count, cells);
        let (key, turns) = match a.period {
            Some(turns) => ("basins-share", turns),
            None => ("basins-share-irregular", LONGEST),
        };
        let mut finding = Finding::info("share", key)
            .of(map.name(k))
            .value_as(Arg::percent(p))
            .arg("attractor", Arg::count(k + 1))
            .arg("turns", Arg::count(turns));
        let size = map.probes.get(map.lead).map(|p| (p, map.peak(a, map.lead))).filter(|s| s.1.is_finite());
        finding = match size {
            Some((probe, size)) => finding
                .arg("quality", Arg::word(probes::quality(probe)))
                .arg("point", probes::arg(probe))
                .arg("size", Arg::quantity(size, probe.unit())),
            None => finding.arg("quality", Arg::word("none")),
        };
        outcome = outcome.finding(finding.evidence("sampling error", error, "").evidence("cells", count as f64, ""));
    }
    if own.len() > MOST_REPORTED {
        let more = own.len() - MOST_REPORTED;
        outcome = outcome
            .finding(Finding::info("more_attractors", "basins-more-attractors").value(more as f64, "").arg("count", Arg::count(more)));
    }
    outcome
}

/// Share and its sampling error.
pub(super) fn share(count: usize, of: usize) -> (f64, f64) {
    let n = of as f64;
    let p = count as f64 / n;
    (p, (p * (1.0 - p) / n).sqrt())
}

/// The cell nearest to the undisturbed start that ends in another attractor.
fn disturbance(map: &Map, complete: bool, outcome: Outcome) -> Outcome {
    let axes = &map.study.axes;
    let Some(&start) = map.place.first() else { return outcome };
    let about = |finding: Finding| finding.arg("place", map.at(start));
    let Some(home) = map.found.of[0] else {
        return outcome.finding(about(match map.failure[0].as_str() {
            "" => Finding::warning("undisturbed", "basins-undisturbed-not-settled"),
            why => Finding::warning("undisturbed", "basins-undisturbed-failed").arg("reason", Arg::term(why)),
        }));
    };
    let from = |finding: Finding| about(finding).arg("attractor", map.attractor(home));
    let at_home = |row: usize| map.found.of[row] == Some(home);
    if !(complete && axes[0].holds(start[0]) && axes[1].holds(start[1])) {
        return outcome.finding(from(Finding::info("undisturbed", "basins-undisturbed")));
    }
    let scale = axes.each_ref().map(|a| a.index.and_then(|i| map.data.sizes.get(i)).copied().unwrap_or(1.0));
    let distance = |row: usize| ((map.place[row][0] - start[0]) / scale[0]).hypot((map.place[row][1] - start[1]) / scale[1]);
    let away = map.cells().filter_map(|r| Some((distance(r), r, map.found.of[r]?))).filter(|x| x.2 != home);
    let Some((d, row, target)) = away.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        let cells = if map.cells().any(|r| map.found.of[r].is_none()) { "settled" } else { "all" };
        return outcome.finding(from(Finding::info("undisturbed", "basins-undisturbed-everywhere")).arg("cells", Arg::word(cells)));
    };
    let nearer = |r: &usize| distance(*r) < d;
    let inside = map.cells().filter(nearer).filter(|&r| at_home(r)).map(distance).fold(0.0, f64::max);
    let unknown = map.cells().filter(nearer).filter(|&r| map.found.of[r].is_none()).count();
    let same = axes[0].unit == axes[1].unit && scale[0] == scale[1];
    let (unit, factor, shown) = if same {
        (axes[0].unit.as_str(), scale[0], "farthest nearer cell that does not")
    } else {
        ("", 1.0, "farthest nearer cell that does not, over typical sizes")
    };
    let mut finding = from(Finding::info("smallest_disturbance", "basins-smallest-disturbance"))
        .value(d * factor, unit)
        .arg("scale", Arg::word(if same { "same" } else { "typical" }))
        .arg("target", map.attractor(target))
        .arg("disturbed", map.at(map.place[row]))
        .evidence(shown, inside * factor, unit);
    for k in 0..2 {
        let named = |key: &str| Message::new(key).arg("state", Arg::name(&axes[k].name));
        finding = finding.evidence(named("basins-grid-step"), axes[k].step(), axes[k].unit.clone());
        if !same {
            finding = finding.evidence(named("basins-typical-size"), scale[k], axes[k].unit.clone());
        }
    }
    if unknown > 0 {
        finding = finding.evidence("nearer cells that did not settle", unknown as f64, "");
    }
    outcome.finding(finding)
}

/// Cells without a motion.
fn failures(map: &Map, mut outcome: Outcome) -> Outcome {
    let cells = map.cells().len();
    let mut causes: BTreeMap<&str, usize> = BTreeMap::new();
    for why in map.failure.iter().skip(1).filter(|w| !w.is_empty()) {
        *causes.entry(why).or_default() += 1;
    }
    for (why, count) in causes {
        let key = if why == UNBOUNDED { "basins-unbounded" } else { "basins-failed-motions" };
        let finding = Finding::warning("failed_motions", key)
            .of(why)
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("cells", Arg::count(cells))
            .arg("limit", Arg::number(RUNAWAY))
            .arg("reason", Arg::term(why));
        outcome = outcome.finding(finding);
    }
    outcome
}

/// Cells whose settling was cut short.
fn cut_short(map: &Map, outcome: Outcome) -> Outcome {
    let cells = map.cells().len();
    let bounded = map.data.motions.numbers("bounded");
    let cut = map.cells().filter(|&r| bounded[r] == 1.0 && map.found.of[r].is_some()).count();
    if cut == 0 || map.data.modes.decay.is_none() {
        return outcome;
    }
    let finding = Finding::info("settling_bounded", "basins-settling-bounded").value(cut as f64, "");
    outcome.finding(finding.arg("count", Arg::count(cut)).arg("cells", Arg::count(cells)))
}

/// Cells without a settled motion.
fn undecided(map: &Map, mut outcome: Outcome) -> Outcome {
    let cells = map.cells().len();
    let count = |word: &str| map.cells().filter(|&r| map.word(r) == word).count();
    let modes = &map.data.modes;
    if !map.place.is_empty() && modes.decay.is_none() {
        let finding = match modes.growth {
            Some(growth) => Finding::warning("no_decay", "basins-growing").arg("growth", Arg::quantity(growth, "1/s")),
            None if modes.neutral => Finding::warning("no_decay", "basins-neutral"),
            None => Finding::warning("no_decay", "basins-modes-unknown"),
        };
        outcome = outcome.finding(finding.arg("turns", Arg::Count(map.study.rules.most_periods)));
    }
    let unsettled = count("not settled");
    if unsettled > 0 {
        let finding = Finding::warning("not_settled", "basins-not-settled").value(unsettled as f64, "");
        outcome = outcome.finding(finding.arg("count", Arg::count(unsettled)).arg("cells", Arg::count(cells)));
    }
    outcome
}

fn largest(probe: &Probe) -> &'static str {
    if probe.is_tilt() { "largest tilt" } else { "largest displacement" }
}

fn tables(map: &Map, mut outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let (results, rows) = (&map.data.motions, map.cells());
    let axes = &map.study.axes;
    let of_cells = |values: &[f64]| values[rows.clone()].iter().map(|x| if x.is_finite() { *x } else { f64::NAN }).collect::<Vec<f64>>();
    let mut cells = Table::new("cells", "Attractor reached from every cell of the grid");
    for k in 0..2 {
        cells = cells.float(PLACE[k], &axes[k].unit, axes[k].meaning(), rows.clone().map(|r| map.place[r][k]).collect());
    }
    let number = |r: usize| map.found.of[r].map_or(0, |a| i64::try_from(a + 1).unwrap_or(0));
    cells = cells
        .int(
            "attractor",
            "",
            "number in the table of attractors; 0 where the motion did not settle or failed",
            rows.clone().map(number).collect(),
        )
        .text("end", "what the cell ends in", rows.clone().map(|r| map.word(r)).collect())
        .text("motion", "the same with its largest displacement or tilt", rows.clone().map(|r| map.shown(r)).collect())
        .float(
            "period",
            "",
            "forcing periods after which the motion repeats; NaN where there is none",
            of_cells(&results.numbers("period")),
        );
    for (k, p) in map.probes.iter().enumerate() {
        let doc = Arg::noted(largest(p), "NaN where it failed");
        cells = cells.float(probes::column(p), p.unit(), doc, of_cells(&map.amplitude[k]));
    }
    cells = cells
        .float(
            "remaining",
            "",
            "estimated distance from the settled motion over its size; NaN where there is none",
            of_cells(&results.numbers("remaining")),
        )
        .float("periods", "", "forcing periods integrated", of_cells(&results.numbers("periods")))
        .text("failure", "why there is no motion", map.failure.iter().skip(1).cloned().collect());
    outcome = outcome.table(cells.build().map_err(inconsistent)?);

    let all = &map.found.attractors;
    let column = |f: &dyn Fn(&Attractor) -> f64| all.iter().map(f).collect::<Vec<f64>>();
    let mut table = Table::new("attractors", "Attractors")
        .int(
            "attractor",
            "",
            "number, in order of the first body's displacement, or of its tilt where it only tilts",
            (1..=all.len() as i64).collect(),
        )
        .text(
            "motion",
            "whether it repeats",
            all.iter().map(|a| if a.period.is_some() { "periodic" } else { "does not repeat" }.into()).collect(),
        )
        .float("period", "", "turns after which it repeats; NaN where it does not", column(&|a| a.period.map_or(f64::NAN, |k| k as f64)))
        .int("cells", "", "cells of the grid that end in it", all.iter().map(|a| map.count(a) as i64).collect())
        .float("share", "", "share p of all cells", column(&|a| share(map.count(a), rows.len()).0))
        .float("share_error", "", "sampling error sqrt(p (1 - p)/N) for N cells", column(&|a| share(map.count(a), rows.len()).1));
    for (k, p) in map.probes.iter().enumerate() {
        table = table.float(probes::column(p), p.unit(), largest(p), column(&|a| map.peak(a, k)));
        if let Some(rms) = map.rms.get(k) {
            let doc = "root of the mean squared displacement of its best motion";
            table = table.float(format!("rms.{}", probes::owner(p)), "m", doc, column(&|a| rms[a.best]));
        }
    }
    table = table
        .float(
            "remaining",
            "",
            "estimated distance of its best motion from the limit over its size; NaN where there is none",
            column(&|a| map.motions[a.best].remaining),
        )
        .float("spread", "", "largest distance of a motion from the first over its size; zero where none repeats", column(&|a| a.spread));
    if map.study.rules.shooting {
        let shot = |name: &str| {
            let all = results.numbers(name);
            column(&|a| all.get(a.best).copied().unwrap_or(f64::NAN))
        };
        table = table
            .float(
                "residual",
                "",
                "last correction of shooting over its size; NaN where shooting was not needed or failed",
                shot("residual"),
            )
            .float("multiplier", "", "largest modulus of its multipliers; NaN where shooting was not needed or failed", shot("multiplier"));
    }
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    outcome = outcome.table(poincare(map)?);
    if let Some(&place) = map.place.first() {
        let start = Table::new("undisturbed", "The start that no initial value of the grid disturbs")
            .float(PLACE[0], &axes[0].unit, axes[0].meaning(), vec![place[0]])
            .float(PLACE[1], &axes[1].unit, axes[1].meaning(), vec![place[1]])
            .text("end", "what it ends in", vec![map.word(0)]);
        outcome = outcome.table(start.build().map_err(inconsistent)?);
    }
    Ok(outcome)
}

/// Poincare points of the attractors that repeat.
fn poincare(map: &Map) -> Result<Table, Diagnostic> {
    let names = &map.data.states;
    let mut rows: Vec<(i64, i64, &str, &str, f64)> = Vec::new();
    for (k, a) in map.found.attractors.iter().enumerate() {
        for (p, y) in map.motions[a.best].orbit.iter().enumerate() {
            let own = names.iter().zip(y).map(|((name, unit), y)| (k as i64 + 1, p as i64, name.as_str(), unit.as_str(), *y));
            rows.extend(own);
        }
    }
    Table::new("poincare", "States of the attractors at phase zero: what `initial` of another study may be given")
        .int("attractor", "", "number of the attractor", rows.iter().map(|r| r.0).collect())
        .int("turn", "", "turns since its first point", rows.iter().map(|r| r.1).collect())
        .names("state", "coordinate, rate or internal state", rows.iter().map(|r| r.2.into()).collect())
        .names("unit", "unit of the value", rows.iter().map(|r| r.3.into()).collect())
        .float("value", "", "value", rows.iter().map(|r| r.4).collect())
        .build()
        .map_err(inconsistent)
}

fn figure(map: &Map, outcome: Outcome) -> Outcome {
    if map.cells().is_empty() {
        return outcome;
    }
    let axes = &map.study.axes;
    let drawn = |k: usize| {
        let a = &axes[k];
        let label = a.label();
        let largest = map.place.iter().map(|p| p[k].abs()).fold(0.0, f64::max);
        match a.unit.as_str() {
            "m" if largest < 1e-3 => Axis::new(label, "µm").factor(1e6),
            "m" => Axis::new(label, "mm").factor(1e3),
            unit => Axis::new(label, unit),
        }
    };
    // words that every map may have first: they have the same colours in all
    let mut classes: Vec<String> = ["not settled", "failed", "does not repeat"].map(String::from).to_vec();
    let repeating = (0..map.found.attractors.len()).filter(|&k| map.found.attractors[k].period.is_some());
    let called: Vec<(String, Arg)> = repeating.map(|k| (map.sized(k), map.sized_phrase(k))).collect();
    classes.extend(called.iter().map(|c| c.0.clone()));
    let colours = Axis::new("ends in", "");
    let mut panel = Panel::new(drawn(1)).mark(Heat::new("cells", PLACE[0], PLACE[1], "motion", colours).of_classes(classes).called(called));
    let start = map.place[0];
    if axes[0].holds(start[0]) && axes[1].holds(start[1]) {
        panel = panel.mark(Points::new("undisturbed", PLACE[0], PLACE[1]).name("undisturbed start"));
    }
    let alt = Message::new("basins-alt").arg("speed", Arg::speed(map.study.speed)).arg("x", axes[0].meaning()).arg("y", axes[1].meaning());
    let mut figure = Figure::new("basins", "Basins of attraction", alt).x(drawn(0)).panel(panel);
    let (x, y) = (drawn(0), drawn(1));
    let spans = [0, 1].map(|k| axes[k].values().last().copied().unwrap_or(0.0) - axes[k].values()[0]);
    if axes[0].unit == axes[1].unit && x.factor == y.factor && (spans[0] / spans[1]).clamp(0.5, 2.0) == spans[0] / spans[1] {
        figure = figure.equal();
    }
    outcome.figure(figure)
}
