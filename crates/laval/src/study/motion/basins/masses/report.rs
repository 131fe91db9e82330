//! Findings, tables and the figure of the basins of a machine with movable masses.

use super::super::axes::InitialValueAxis;
use super::super::report::share;
use super::super::rows::PLACE;
use super::super::{Basins, BasinsResult, MassBasins};
use super::known::{MassAttractor, MassKind};
use super::{EARLY, FAILURE, GOAL, Rehearsal, STATE, STEPS, TURNS};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Heat, Message, Outcome, Panel, Table};
use crate::store::Collected;
use crate::study::Study;
use crate::study::motion::start;
use crate::study::motion::steady_state::stored;
use crate::study::shared::support::inconsistent;
use std::collections::BTreeMap;

/// Mean slip rate over the speed above which masses go round.
const ROUND: f64 = 1e-2;
/// Word of cells that came to nothing in the time given.
const UNSETTLED: &str = "not settled";

/// What an attractor is called; several of a kind are numbered.
pub(super) fn names(all: &[MassAttractor]) -> Vec<String> {
    let kind = |a: &MassAttractor| match &a.kind {
        MassKind::Rest { class, stable: true, .. } => class.words().to_string(),
        MassKind::Rest { class, .. } => format!("{}, unstable", class.words()),
        MassKind::Moving { slip, .. } if slip.iter().all(|s| s.abs() > ROUND) => "masses go round".into(),
        MassKind::Moving { slip, .. } if slip.iter().any(|s| s.abs() > ROUND) => "some masses go round".into(),
        MassKind::Moving { .. } => "masses swing".into(),
    };
    let kinds: Vec<String> = all.iter().map(kind).collect();
    let name = |(k, word): (usize, &String)| {
        let same = kinds.iter().filter(|w| *w == word).count();
        if same == 1 { word.clone() } else { format!("{word} ({})", kinds[..=k].iter().filter(|w| *w == word).count()) }
    };
    kinds.iter().enumerate().map(name).collect()
}

/// What every cell ends in.
pub(super) fn ends(cells: &Collected, names: &[String]) -> Vec<String> {
    let goals = cells.words(GOAL);
    cells.numbers(STATE).iter().zip(goals).map(|(s, goal)| names.get((*s as usize).wrapping_sub(1)).cloned().unwrap_or(goal)).collect()
}

pub(in crate::study::motion::basins) fn report(
    study: &Basins,
    system: &System,
    (result, data): (&BasinsResult, &MassBasins),
    name: &str,
) -> Result<Outcome, Diagnostic> {
    let results = &data.cells;
    stored::check(results, [PLACE[0], PLACE[1], STATE, GOAL, EARLY, TURNS, STEPS, FAILURE].map(String::from).into_iter())?;
    let mut outcome = Outcome::new(Basins::KIND, name).end(result.end);
    for f in results.remark_of("motions").into_iter().chain(start::undeflected(&result.undeflected)) {
        outcome = outcome.finding(f);
    }
    let names = names(&data.attractors);
    let words = ends(results, &names);
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    words.iter().for_each(|w| *counts.entry(w).or_default() += 1);
    outcome = shares(study, data, &counts, &names, words.len(), outcome);
    outcome = undecided(&counts, words.len(), results, outcome);
    outcome = early(data.recognition, &results.numbers(EARLY), outcome);
    if let Some(checked) = &data.checked {
        outcome = checked.report(study, &study.axes.each_ref().map(InitialValueAxis::values), outcome)?;
    }
    let turns = results.numbers(TURNS);
    let steps = results.numbers(STEPS).iter().sum::<f64>();
    outcome = outcome.work("motions", results.done).work("steps", steps as u64).work("turns", turns.iter().sum::<f64>() as u64);
    outcome = tables(study, system, data, &names, &counts, &words, outcome)?;
    figure(study, &names, words, outcome).checked().map_err(inconsistent)
}

fn shares(
    study: &Basins,
    data: &MassBasins,
    counts: &BTreeMap<&str, usize>,
    names: &[String],
    cells: usize,
    mut outcome: Outcome,
) -> Outcome {
    if cells == 0 {
        return outcome;
    }
    let mut order: Vec<(&str, usize)> = counts.iter().map(|(w, n)| (*w, *n)).filter(|x| x.0 != UNSETTLED && x.0 != "failed").collect();
    order.sort_by_key(|x| (std::cmp::Reverse(x.1), x.0));
    outcome = outcome.finding(
        Finding::info("attractors", "basins-ends")
            .value(order.len() as f64, "")
            .arg("count", Arg::count(order.len()))
            .arg("speed", Arg::speed(study.speed))
            .evidence("cells", cells as f64, ""),
    );
    for (word, count) in order {
        let (p, error) = share(count, cells);
        let known = names.iter().position(|n| n == word).map(|k| &data.attractors[k].kind);
        let balances = matches!(known, Some(MassKind::Rest { class, .. }) if class.balances());
        let key = match known {
            Some(MassKind::Rest { stable: false, .. }) => "basins-end-unstable",
            Some(MassKind::Moving { .. }) => "basins-end-moving",
            _ => "basins-end",
        };
        let unbalanced = !balances && !word.starts_with("at rest");
        let make = if unbalanced { Finding::warning } else { Finding::info };
        let mut finding = make("share", key)
            .of(word)
            .value_as(Arg::percent(p))
            .arg("end", Arg::term(word))
            .arg("unbalanced", Arg::word(if unbalanced { "yes" } else { "no" }));
        if let Some(MassKind::Moving { slip, .. }) = known {
            finding = finding.arg("rates", Arg::List(slip.iter().map(|s| Arg::speed(s * study.speed)).collect()));
        }
        outcome = outcome.finding(finding.evidence("sampling error", error, "").evidence("cells", count as f64, ""));
    }
    outcome
}

fn undecided(counts: &BTreeMap<&str, usize>, cells: usize, results: &Collected, mut outcome: Outcome) -> Outcome {
    if let Some(&n) = counts.get(UNSETTLED) {
        let finding = Finding::warning("not_settled", "basins-not-settled").value(n as f64, "");
        outcome = outcome.finding(finding.arg("count", Arg::count(n)).arg("cells", Arg::count(cells)));
    }
    let mut causes: BTreeMap<String, usize> = BTreeMap::new();
    for why in results.words(FAILURE).into_iter().filter(|w| !w.is_empty()) {
        *causes.entry(why).or_default() += 1;
    }
    for (why, count) in causes {
        let finding = Finding::warning("failed_motions", "basins-failed-motions")
            .of(&why)
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("cells", Arg::count(cells))
            .arg("reason", Arg::term(why));
        outcome = outcome.finding(finding);
    }
    outcome
}

/// Ends of motions recognised early, and how often that was wrong.
fn early(seen: Option<Rehearsal>, stored: &[f64], outcome: Outcome) -> Outcome {
    let Some(seen) = seen else {
        return outcome.finding(Finding::info("recognition", "basins-recognition-none"));
    };
    let count = stored.iter().filter(|t| **t == 1.0).count();
    let doubtful = 100 * seen.wrong > seen.tried;
    let make = if doubtful { Finding::warning } else { Finding::info };
    outcome.finding(
        make("recognition", "basins-recognition")
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("cells", Arg::count(stored.len()))
            .arg("wrong", Arg::count(seen.wrong))
            .arg("tried", Arg::count(seen.tried))
            .arg("doubtful", Arg::word(if doubtful { "yes" } else { "no" }))
            .evidence("concluded wrongly", seen.wrong as f64, "")
            .evidence("starts followed to the end to see", seen.tried as f64, "")
            .evidence("of them concluded before", seen.assigned as f64, "")
            .evidence("starts that showed how near motions come", seen.witnessed as f64, "")
            .evidence("starts that showed what motions there are", seen.learned as f64, ""),
    )
}

fn tables(
    study: &Basins,
    system: &System,
    data: &MassBasins,
    names: &[String],
    counts: &BTreeMap<&str, usize>,
    words: &[String],
    outcome: Outcome,
) -> Result<Outcome, Diagnostic> {
    let (axes, results) = (&study.axes, &data.cells);
    let whole = |name: &str| results.numbers(name).into_iter().map(|x| if x >= 0.0 { x as i64 } else { 0 }).collect::<Vec<i64>>();
    let mut cells = Table::new("cells", "Attractor reached from every cell of the grid");
    for (k, axis) in axes.iter().enumerate() {
        cells = cells.float(PLACE[k], &axis.unit, axis.meaning(), results.numbers(PLACE[k]));
    }
    let cells = cells
        .int("attractor", "", "number in the table of attractors; 0 where the motion ends in none of them", whole(STATE))
        .text("end", "what the cell ends in", words.to_vec())
        .int("early", "", "1 where the end was recognised before it was reached", whole(EARLY))
        .int("turns", "", "turns of the rotor integrated", whole(TURNS))
        .text("failure", "why there is no motion", results.words(FAILURE));
    let all = &data.attractors;
    let column = |f: &dyn Fn(&MassAttractor) -> f64| all.iter().map(f).collect::<Vec<f64>>();
    let count = |name: &String| counts.get(name.as_str()).copied().unwrap_or(0);
    let mut table = Table::new("attractors", "States at rest in turning axes, and motions with masses that go round")
        .int("attractor", "", "number", (1..=all.len() as i64).collect())
        .text("what", "what it is", names.to_vec())
        .flag("stable", "small disturbances decay; true for motions, which were reached", all.iter().map(MassAttractor::attracts).collect())
        .float(
            "growth",
            "1/s",
            "largest growth rate of small disturbances; NaN for motions",
            column(&|a| if let MassKind::Rest { growth, .. } = a.kind { growth } else { f64::NAN }),
        )
        .int("cells", "", "cells of the grid that end in it", names.iter().map(|n| count(n) as i64).collect())
        .float("share", "", "share of all cells", names.iter().map(|n| share(count(n), words.len().max(1)).0).collect())
        .float("radius", "", "distance within which motions are assigned to it; zero where none is", column(&|a| a.radius))
        .float(
            "approach",
            "",
            "nearest a motion came that ended elsewhere; infinite where none was followed",
            column(&|a| a.approach.unwrap_or(f64::NAN)),
        );
    for b in system.stations() {
        let radius = |a: &MassAttractor| if let MassKind::Rest { q, .. } = &a.kind { b.lateral.length(q) } else { f64::NAN };
        table = table.float(format!("displacement.{}", b.name), "m", "distance from the axis; NaN for motions", column(&radius));
    }
    for (k, &i) in data.masses.iter().enumerate() {
        let name = &system.coordinates()[i].name;
        let slip = |a: &MassAttractor| match &a.kind {
            MassKind::Rest { .. } => 0.0,
            MassKind::Moving { slip, .. } => slip[k] * study.speed,
        };
        let place = |a: &MassAttractor| if let MassKind::Rest { q, .. } = &a.kind { q[i] } else { f64::NAN };
        table = table.float(format!("angle.{name}"), "rad", "where it rests; NaN for motions", column(&place)).float(
            format!("slip.{name}"),
            "rad/s",
            "mean rate; of masses that may be exchanged in rising order",
            column(&slip),
        );
    }
    let outcome = outcome.table(cells.build().map_err(inconsistent)?);
    Ok(outcome.table(table.build().map_err(inconsistent)?))
}

/// Words of the map that have colours of their own.
const FIRST: [&str; 5] = ["balanced", "masses go round", "masses together", "unbalance reduced", "partly balanced"];

fn figure(study: &Basins, names: &[String], words: Vec<String>, outcome: Outcome) -> Outcome {
    if words.is_empty() {
        return outcome;
    }
    let axes = &study.axes;
    let drawn = |k: usize| Axis::new(axes[k].label(), &axes[k].unit);
    // words that many maps have first: they have the same colours in all
    let mut classes: Vec<String> = FIRST.map(String::from).to_vec();
    let mut others: Vec<String> = words.iter().filter(|w| !names.contains(w)).cloned().collect();
    others.sort();
    for word in names.iter().chain(&others) {
        if words.contains(word) && !classes.contains(word) {
            classes.push(word.clone());
        }
    }
    let heat = Heat::new("cells", PLACE[0], PLACE[1], "end", Axis::new("ends in", "")).of_classes(classes);
    let alt = Message::new("basins-alt").arg("speed", Arg::speed(study.speed)).arg("x", axes[0].meaning()).arg("y", axes[1].meaning());
    let mut figure = Figure::new("basins", "Basins of attraction", alt).x(drawn(0)).panel(Panel::new(drawn(1)).mark(heat));
    if axes[0].unit == axes[1].unit {
        figure = figure.equal();
    }
    outcome.figure(figure)
}
