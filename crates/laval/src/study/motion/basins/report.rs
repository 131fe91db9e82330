//! What is said of basins.

use super::super::start::state_names;
use super::super::steady_state::period::{LONGEST, Verdict};
use super::super::steady_state::{RUNAWAY, UNBOUNDED, sizes, stored};
use super::attractors::{AGREE, Attractor, AttractorSet, Motion, Ruler};
use super::rows::{PLACE, orbit};
use super::{Basins, Members};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Axis, End, Figure, Finding, Heat, Outcome, Panel, Points, Table, quantity};
use crate::store::Results;
use crate::study::shared::probes;
use crate::study::shared::support::inconsistent;
use crate::study::{Context, Study};
use std::collections::BTreeMap;

/// Attractors of which a finding speaks.
const MOST_REPORTED: usize = 8;

/// All rows, the undisturbed start first, and what they are.
struct Map<'a> {
    members: &'a Members<'a>,
    place: Vec<[f64; 2]>,
    /// Word of the judgement.
    motion: Vec<String>,
    /// Why there is none.
    failure: Vec<String>,
    motions: Vec<Motion>,
    /// By probe.
    amplitude: Vec<Vec<f64>>,
    /// The probe by which attractors are ordered and named: the first body, or its tilt where it only tilts.
    lead: usize,
    /// By body.
    rms: Vec<Vec<f64>>,
    found: AttractorSet,
}

impl<'a> Map<'a> {
    fn read(members: &'a Members<'a>, results: &Results) -> Result<Self, Diagnostic> {
        let position =
            |name: &str| results.position(name).ok_or_else(|| Diagnostic::error("store.columns", format!("there is no column \"{name}\"")));
        let names = state_names(&members.system);
        let peaks = members.probes.iter().map(|p| position(&probes::column(p))).collect::<Result<Vec<_>, _>>()?;
        let means = members.bodies.iter().map(|b| position(&format!("rms.{}", b.name))).collect::<Result<Vec<_>, _>>()?;
        let (x, y, word, period, remaining) =
            (position(PLACE[0])?, position(PLACE[1])?, position("motion")?, position("period")?, position("remaining")?);
        let states = (0..LONGEST)
            .map(|p| names.iter().map(|n| position(&orbit(p, &n.0))).collect::<Result<Vec<_>, _>>())
            .collect::<Result<Vec<_>, _>>()?;
        let (mut place, mut motion, mut motions) = (vec![], vec![], vec![]);
        let mut amplitude = vec![vec![]; peaks.len()];
        let mut rms = vec![vec![]; means.len()];
        for chunk in results.chunks() {
            let chunk = chunk?;
            for r in 0..chunk.rows.len() {
                let number = |c: usize| chunk.cells[c].number(r);
                let k = number(period);
                let turns = if k.is_finite() { (k as usize).min(LONGEST) } else { 0 };
                let assessment = chunk.cells[word].word(r).unwrap_or_default();
                place.push([number(x), number(y)]);
                motions.push(Motion {
                    orbit: (0..turns).rev().map(|p| states[p].iter().map(|&c| number(c)).collect()).collect(),
                    // where a mode neither decays nor grows, what does not repeat may never settle
                    irregular: assessment == Verdict::NotPeriodic.word() && !members.neutral,
                    remaining: number(remaining),
                    amplitude: f64::NAN,
                });
                motion.push(assessment.to_string());
                amplitude.iter_mut().zip(&peaks).for_each(|(a, &c)| a.push(number(c)));
                rms.iter_mut().zip(&means).for_each(|(a, &c)| a.push(number(c)));
            }
        }
        let known =
            probes::resolved(members.probes.iter().cloned().zip(amplitude.iter().cloned()).collect(), members.study.rules.tolerance);
        let lead = known.iter().min_by_key(|k| k.0.body).and_then(|k| members.probes.iter().position(|p| *p == k.0)).unwrap_or(0);
        if let Some(own) = amplitude.get(lead) {
            motions.iter_mut().zip(own).for_each(|(m, &a)| m.amplitude = a);
        }
        let (sizes, rules) = (sizes(&members.system, members.study.speed), &members.study.rules);
        let found = Ruler { sizes: &sizes, rest: &members.start.rest, tolerance: rules.tolerance }.sort(&motions);
        let failure = stored::words(results, "failure")?;
        Ok(Map { members, place, motion, failure, motions, amplitude, lead, rms, found })
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

    /// "drum.x = 1 mm, drum.x' = 0.1 m/s"
    fn at(&self, place: [f64; 2]) -> String {
        let one = |k: usize| {
            let axis = &self.members.study.axes[k];
            format!("{} = {}", axis.name, quantity(place[k], &axis.unit))
        };
        format!("{}, {}", one(0), one(1))
    }

    /// Largest value of a probe on an attractor.
    fn peak(&self, a: &Attractor, b: usize) -> f64 {
        match a.period {
            Some(_) => self.amplitude[b][a.best],
            None => a.members.iter().map(|&m| self.amplitude[b][m]).fold(f64::NAN, f64::max),
        }
    }
}

pub(super) fn report(members: &Members, results: &Results, context: &Context) -> Result<Outcome, Diagnostic> {
    let map = Map::read(members, results)?;
    let complete = results.end() == End::Reached;
    let mut outcome = Outcome::new(Basins::KIND, context.name).end(context.end(complete));
    let rows = format!("motions ({} cells and the undisturbed start)", members.values[0].len() * members.values[1].len());
    for f in results.remark_of(&rows).into_iter().chain(members.start.finding.clone()) {
        outcome = outcome.finding(f);
    }
    outcome = cut_short(&map, results, outcome)?;
    outcome = shares(&map, outcome);
    outcome = failures(&map, outcome);
    outcome = disturbance(&map, complete, outcome);
    outcome = undecided(&map, outcome);
    let axes = &members.study.axes;
    let at = |row: usize, f: Finding| {
        let place = map.place[row];
        f.evidence(axes[0].name.clone(), place[0], axes[0].unit.clone()).evidence(axes[1].name.clone(), place[1], axes[1].unit.clone())
    };
    outcome = stored::limits(results, at, outcome)?;
    let steps = results.numbers("steps")?.iter().sum::<f64>();
    outcome = outcome.work("motions", results.done()).work("steps", steps as u64);
    outcome = tables(&map, results, outcome)?;
    figure(&map, outcome).checked().map_err(inconsistent)
}

/// Number of attractors, and the share of the cells that ends in each.
fn shares(map: &Map, mut outcome: Outcome) -> Outcome {
    let cells = map.cells().len();
    if cells == 0 {
        return outcome;
    }
    let speed = quantity(map.members.study.speed, "rad/s");
    let own: Vec<(usize, &Attractor, usize)> =
        map.found.attractors.iter().enumerate().map(|(k, a)| (k, a, map.count(a))).filter(|x| x.2 > 0).collect();
    let repeating = own.iter().filter(|x| x.1.period.is_some()).count();
    let text = match repeating {
        0 => format!("No cell of the grid was found to end in a motion that repeats within {LONGEST} turns, at {speed}."),
        1 => format!("{{}} motion that repeats was found to be reached from the grid, at {speed}."),
        _ => format!("{{}} different motions that repeat were found to be reached from the grid, at {speed}."),
    };
    let tolerance = AGREE * map.members.study.rules.tolerance;
    let mut finding = Finding::info("attractors", text).value(repeating as f64, "").evidence("cells", cells as f64, "");
    finding = finding.evidence("distance over the size of a motion that counts as the same", tolerance, "");
    if let Some(gap) = map.found.gap {
        finding = finding.evidence("smallest distance of two attractors of one period over their size", gap, "");
    }
    outcome = outcome.finding(finding);
    let mut by_share = own.clone();
    by_share.sort_by_key(|x| (std::cmp::Reverse(x.2), x.0));
    for &(k, a, count) in by_share.iter().take(MOST_REPORTED) {
        let (p, error) = share(count, cells);
        let what = match a.period {
            Some(1) => "which repeats every turn".to_string(),
            Some(turns) => format!("which repeats after {turns} turns"),
            None => format!("motions that do not repeat within {LONGEST} turns, one or several attractors"),
        };
        let lead = map.members.probes.get(map.lead);
        let (size, body, unit) = lead.map_or(("", String::new(), ""), |p| (probes::quality(p), probes::owner(p), p.unit()));
        let moves = if lead.is_some() { quantity(map.peak(a, map.lead), unit) } else { String::new() };
        let begin = if a.period.is_some() { format!("{}, {what}", upper(&map.name(k))) } else { upper(&what) };
        let text = format!("{begin} (largest {size} of \"{body}\" {moves}): reached from {{}} of the cells.");
        let finding = Finding::info("share", text).of(map.name(k)).value(p, "").shown_as(100.0 * p, "%");
        outcome = outcome.finding(finding.evidence("sampling error", error, "").evidence("cells", count as f64, ""));
    }
    if own.len() > MOST_REPORTED {
        let text = format!("{{}} more attractors, each with a smaller share, are in the table of {}.", own.len());
        outcome = outcome.finding(Finding::info("more_attractors", text).value((own.len() - MOST_REPORTED) as f64, ""));
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
    let axes = &map.members.study.axes;
    let Some(&start) = map.place.first() else { return outcome };
    let place = map.at(start);
    let Some(home) = map.found.of[0] else {
        let what = match map.failure[0].as_str() {
            "" => format!("is {}", map.motion[0]),
            why => why.to_string(),
        };
        return outcome.finding(Finding::warning("undisturbed", format!("The motion from the undisturbed start ({place}) {what}.")));
    };
    let repeats = map.found.attractors[home].period.is_some();
    let ends = if repeats { format!("ends in {}", map.name(home)) } else { format!("does not repeat within {LONGEST} turns") };
    let from = format!("The motion from the undisturbed start ({place}) {ends}");
    let at_home = |row: usize| map.found.of[row] == Some(home);
    if !(complete && axes[0].holds(start[0]) && axes[1].holds(start[1])) {
        return outcome.finding(Finding::info("undisturbed", from + "."));
    }
    let all = sizes(&map.members.system, map.members.study.speed);
    let scale = axes.each_ref().map(|a| a.index.map_or(1.0, |i| all[i]));
    let distance = |row: usize| ((map.place[row][0] - start[0]) / scale[0]).hypot((map.place[row][1] - start[1]) / scale[1]);
    let other =
        map.cells().filter(|&r| map.found.of[r].is_some() && !at_home(r)).map(|r| (distance(r), r)).min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((d, row)) = other else {
        let which = if map.cells().any(|r| map.found.of[r].is_none()) { " that settled" } else { "" };
        return outcome.finding(Finding::info("undisturbed", format!("{from}, as does that from every cell of the grid{which}.")));
    };
    let nearer = |r: &usize| distance(*r) < d;
    let inside = map.cells().filter(nearer).filter(|&r| at_home(r)).map(distance).fold(0.0, f64::max);
    let unknown = map.cells().filter(nearer).filter(|&r| map.found.of[r].is_none()).count();
    let target = map.word(row);
    let leads = if target.starts_with("attractor") {
        format!("to {target}")
    } else {
        format!("to motion that does not repeat within {LONGEST} turns")
    };
    let text = format!("{from}; the smallest disturbance on the grid that leads {leads} is {}, {{}} away.", map.at(map.place[row]));
    let same = axes[0].unit == axes[1].unit && scale[0] == scale[1];
    let (unit, factor, shown) = if same { (axes[0].unit.as_str(), scale[0], "") } else { ("", 1.0, " over typical sizes") };
    let mut finding = Finding::info("smallest_disturbance", if same { text } else { text.replace("{} away", "{} typical sizes away") });
    finding = finding.value(d * factor, unit).evidence(format!("farthest nearer cell that does not{shown}"), inside * factor, unit);
    for k in 0..2 {
        finding = finding.evidence(format!("grid step of {}", axes[k].name), axes[k].step(), axes[k].unit.clone());
        if !same {
            finding = finding.evidence(format!("typical size of {}", axes[k].name), scale[k], axes[k].unit.clone());
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
        let text = if why == UNBOUNDED {
            format!(
                "{{}} of {cells} cells lead to a motion that grows without bound, to more than {RUNAWAY:e} typical displacements (1 mm, 10 mrad)."
            )
        } else {
            format!("{{}} of {cells} cells have a motion that could not be followed: it {why}.")
        };
        outcome = outcome.finding(Finding::warning("failed_motions", text).of(why).value(count as f64, ""));
    }
    outcome
}

/// That settling was cut short.
fn cut_short(map: &Map, results: &Results, outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let cells = map.cells().len();
    let bounded = results.numbers("bounded")?;
    let cut = map.cells().filter(|&r| bounded[r] == 1.0 && map.found.of[r].is_some()).count();
    if cut == 0 || map.members.rate.is_none() {
        return Ok(outcome);
    }
    let text = format!(
        "In {{}} of {cells} cells the largest number of periods (most_periods) cut the settling short of what the slowest mode requires; they are classified by their last turns."
    );
    Ok(outcome.finding(Finding::info("settling_bounded", text).value(cut as f64, "")))
}

/// Cells without a settled motion.
fn undecided(map: &Map, mut outcome: Outcome) -> Outcome {
    let cells = map.cells().len();
    let count = |word: &str| map.cells().filter(|&r| map.word(r) == word).count();
    if !map.place.is_empty()
        && let Some(what) = map.members.undecaying()
    {
        let most = map.members.study.rules.most_periods;
        let mut text = format!(
            "{}: nothing says how long settling takes, and motions that do not repeat were followed for {most} turns (most_periods).",
            upper(&what)
        );
        if map.members.neutral {
            text += " One that does not repeat by then is called not settled.";
        }
        outcome = outcome.finding(Finding::warning("no_decay", text));
    }
    let unsettled = count("not settled");
    if unsettled > 0 {
        let text = format!("{{}} of {cells} cells did not settle within the largest number of periods: they belong to no attractor here.");
        outcome = outcome.finding(Finding::warning("not_settled", text).value(unsettled as f64, ""));
    }
    outcome
}

pub(super) fn upper(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |c| c.to_uppercase().collect::<String>() + letters.as_str())
}

fn tables(map: &Map, results: &Results, mut outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let (members, rows) = (map.members, map.cells());
    let axes = &members.study.axes;
    let of_cells = |values: &[f64]| values[rows.clone()].iter().map(|x| if x.is_finite() { *x } else { f64::NAN }).collect::<Vec<f64>>();
    let mut cells = Table::new("cells", "The motion every cell of the grid settles on");
    for k in 0..2 {
        let doc = format!("initial value of {}", axes[k].name);
        cells = cells.float(PLACE[k], &axes[k].unit, doc, rows.clone().map(|r| map.place[r][k]).collect());
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
        .float(
            "period",
            "",
            "forcing periods after which the motion repeats; NaN where there is none",
            of_cells(&results.numbers("period")?),
        );
    for (k, p) in members.probes.iter().enumerate() {
        let doc = format!("largest {}; NaN where it failed", probes::quality(p));
        cells = cells.float(probes::column(p), p.unit(), doc, of_cells(&map.amplitude[k]));
    }
    cells = cells
        .float(
            "remaining",
            "",
            "estimated distance from the settled motion over its size; NaN where there is none",
            of_cells(&results.numbers("remaining")?),
        )
        .float("periods", "", "forcing periods integrated", of_cells(&results.numbers("periods")?))
        .text("failure", "why there is no motion", map.failure.iter().skip(1).cloned().collect());
    outcome = outcome.table(cells.build().map_err(inconsistent)?);

    let all = &map.found.attractors;
    let column = |f: &dyn Fn(&Attractor) -> f64| all.iter().map(f).collect::<Vec<f64>>();
    let mut table = Table::new("attractors", "Settled motions that differ")
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
    for (k, p) in members.probes.iter().enumerate() {
        table = table.float(probes::column(p), p.unit(), format!("largest {}", probes::quality(p)), column(&|a| map.peak(a, k)));
        if let Some(rms) = map.rms.get(k) {
            let doc = "root of the mean squared displacement of its best motion";
            table = table.float(format!("rms.{}", p.name), "m", doc, column(&|a| rms[a.best]));
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
    if members.study.rules.shooting {
        let shot = |name: &str| results.numbers(name).map(|v| column(&|a| v[a.best]));
        table = table
            .float(
                "residual",
                "",
                "last correction of shooting over its size; NaN where shooting was not needed or failed",
                shot("residual")?,
            )
            .float(
                "multiplier",
                "",
                "largest modulus of its multipliers; NaN where shooting was not needed or failed",
                shot("multiplier")?,
            );
    }
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    outcome = outcome.table(poincare(map)?);
    if let Some(&place) = map.place.first() {
        let start = Table::new("undisturbed", "The start that no initial value of the grid disturbs")
            .float(PLACE[0], &axes[0].unit, format!("initial value of {}", axes[0].name), vec![place[0]])
            .float(PLACE[1], &axes[1].unit, format!("initial value of {}", axes[1].name), vec![place[1]])
            .text("end", "what it ends in", vec![map.word(0)]);
        outcome = outcome.table(start.build().map_err(inconsistent)?);
    }
    Ok(outcome)
}

/// Poincare points of the attractors that repeat.
fn poincare(map: &Map) -> Result<Table, Diagnostic> {
    let names = state_names(&map.members.system);
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
        .text("state", "coordinate, rate or internal state", rows.iter().map(|r| r.2.into()).collect())
        .text("unit", "unit of the value", rows.iter().map(|r| r.3.into()).collect())
        .float("value", "", "value", rows.iter().map(|r| r.4).collect())
        .build()
        .map_err(inconsistent)
}

fn figure(map: &Map, outcome: Outcome) -> Outcome {
    if map.cells().is_empty() {
        return outcome;
    }
    let axes = &map.members.study.axes;
    let drawn = |k: usize| {
        let a = &axes[k];
        let largest = map.place.iter().map(|p| p[k].abs()).fold(0.0, f64::max);
        match a.unit.as_str() {
            "m" if largest < 1e-3 => Axis::new(&a.name, "µm").factor(1e6),
            "m" => Axis::new(&a.name, "mm").factor(1e3),
            unit => Axis::new(&a.name, unit),
        }
    };
    // words that every map may have first: they have the same colours in all
    let mut classes: Vec<String> = ["not settled", "failed", "does not repeat"].map(String::from).to_vec();
    let names = (0..map.found.attractors.len()).map(|k| map.name(k));
    classes.extend(names.filter(|n| n.starts_with("attractor")));
    let colours = Axis::new("ends in", "");
    let mut panel = Panel::new(drawn(1)).mark(Heat::new("cells", PLACE[0], PLACE[1], "end", colours).of_classes(classes));
    let start = map.place[0];
    if axes[0].holds(start[0]) && axes[1].holds(start[1]) {
        panel = panel.mark(Points::new("undisturbed", PLACE[0], PLACE[1]).name("undisturbed start"));
    }
    let speed = quantity(map.members.study.speed, "rad/s");
    let alt = format!("The motion each start settles on at {speed}, over the initial values {} and {}.", axes[0].name, axes[1].name);
    let mut figure = Figure::new("basins", "Basins of attraction", alt).x(drawn(0)).panel(panel);
    let (x, y) = (drawn(0), drawn(1));
    let spans = [0, 1].map(|k| axes[k].values().last().copied().unwrap_or(0.0) - axes[k].values()[0]);
    if axes[0].unit == axes[1].unit && x.factor == y.factor && (spans[0] / spans[1]).clamp(0.5, 2.0) == spans[0] / spans[1] {
        figure = figure.equal();
    }
    outcome.figure(figure)
}
