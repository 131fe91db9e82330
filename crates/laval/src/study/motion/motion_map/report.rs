//! From points to findings, the table and the figures.

use super::{GridAxis, MotionMap, MotionMapResult, REFUSED, place};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Heat, Message, Outcome, Panel, Table, parameter_name};
use crate::store::{Collected, Kind};
use crate::study::Study;
use crate::study::motion::steady_state::period::LONGEST;
use crate::study::motion::steady_state::stored;
use crate::study::shared::probes;
use crate::study::shared::support::inconsistent;
use std::collections::BTreeMap;

/// Repetitions that have a word of their own.
const NAMED: usize = 4;
/// A ratio of values from which colours go by powers of ten.
const WIDE: f64 = 30.0;

/// All points.
struct Map<'a> {
    study: &'a MotionMap,
    /// Values along both axes.
    values: [Vec<f64>; 2],
    /// What the motion of each is, in a word of the legend.
    classes: Vec<String>,
    /// Largest values of every probe, but of displacements that are not resolved beside the tilt of their body.
    sizes: Vec<(Probe, Vec<f64>)>,
}

impl Map<'_> {
    /// Where a row lies on the map.
    fn place(&self, row: usize) -> Arg {
        let (at, axes) = (place(&self.values, row), &self.study.axes);
        let one = |k: usize| match &axes[k].path {
            Some(path) => {
                Message::new("motion-map-parameter").arg("parameter", Arg::name(path)).arg("value", Arg::quantity(at[k], axes[k].unit))
            }
            None => Message::new("motion-map-speed").arg("speed", Arg::speed(at[k])),
        };
        Arg::List((0..2).map(|k| one(k).into()).collect())
    }

    /// The place as evidence.
    fn with_place(&self, f: Finding, row: usize) -> Finding {
        let (at, axes) = (place(&self.values, row), &self.study.axes);
        (0..2).fold(f, |f, k| f.evidence(parameter_name(axes[k].name()), at[k], axes[k].unit))
    }

    fn count(&self, of: impl Fn(&str) -> bool) -> usize {
        self.classes.iter().filter(|c| of(c)).count()
    }
}

/// The legend's word for a motion.
fn class(motion: &str, period: f64) -> String {
    match motion {
        "periodic" if period == 1.0 => "every turn".into(),
        "periodic" if period == 2.0 => "every 2 turns".into(),
        "periodic" if period == 3.0 => "every 3 turns".into(),
        "periodic" if period <= NAMED as f64 => "every 4 turns".into(),
        "periodic" => "after more than 4 turns".into(),
        other => other.into(),
    }
}

/// All words, in the order of the legend.
fn all_classes() -> Vec<String> {
    let repeating = (1..=NAMED + 1).map(|k| class("periodic", k as f64));
    repeating.chain(["not periodic", "not settled", "failed"].map(String::from)).collect()
}

pub(super) fn report(study: &MotionMap, system: &System, result: &MotionMapResult, name: &str) -> Result<Outcome, Diagnostic> {
    let (results, all) = (&result.motions, probes::all(system));
    let own = ["motion", "period", "failure", "validity", "steps", REFUSED].map(String::from);
    stored::check(results, own.into_iter().chain(all.iter().map(probes::column)))?;
    let classes: Vec<String> = results.words("motion").iter().zip(results.numbers("period")).map(|(m, p)| class(m, p)).collect();
    let sizes = all
        .into_iter()
        .map(|p| {
            let own = results.numbers(&probes::column(&p));
            (p, own)
        })
        .collect();
    let sizes = probes::resolved(sizes, study.rules.tolerance);
    let map = Map { study, values: study.axes.each_ref().map(GridAxis::values), classes, sizes };
    let mut outcome = Outcome::new(MotionMap::KIND, name).end(result.end);
    if let Some(f) = results.remark() {
        outcome = outcome.finding(f);
    }
    for f in largest(&map, system).into_iter().chain(repetition(&map)).chain(without(&map, results)) {
        outcome = outcome.finding(f);
    }
    outcome = stored::limits(results, |row, f| map.with_place(f, row), outcome);
    let steps = results.numbers("steps").iter().filter(|s| s.is_finite()).sum::<f64>();
    outcome = outcome.work("motions", results.done).work("steps", steps as u64).table(table(&map, results)?);
    figures(&map, outcome).checked().map_err(inconsistent)
}

/// The largest displacement of every body and point, and the largest tilt.
fn largest(map: &Map, system: &System) -> Vec<Finding> {
    let sizes = map.sizes.iter().flat_map(|(p, sizes)| sizes.iter().map(move |a| (p, *a)));
    if probes::unforced(system, &map.study.spin_speeds(system), sizes) {
        return vec![Finding::info("largest_displacement", probes::UNFORCED).value(0.0, "m")];
    }
    let one = |(probe, sizes): &(Probe, Vec<f64>)| {
        let known = sizes.iter().copied().enumerate().filter(|a| a.1.is_finite());
        let (row, size) = known.reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let (what, owner) = (probes::quality(probe), probes::owner(probe));
        let finding = Finding::info(format!("largest_{what}"), "motion-map-largest")
            .of(owner)
            .value(size, probe.unit())
            .arg("quality", Arg::word(what))
            .arg("point", probes::arg(probe))
            .arg("place", map.place(row));
        Some(map.with_place(finding, row))
    };
    map.sizes.iter().filter_map(one).collect()
}

/// How the motions repeat.
fn repetition(map: &Map) -> Vec<Finding> {
    let all = map.classes.len();
    let known = map.count(|c| c != "failed" && c != "not settled");
    let every = map.count(|c| c == "every turn");
    if every == known && known > 0 {
        let finding = Finding::info("every_turn", "motion-map-every-turn").value(known as f64, "");
        return vec![finding.arg("count", Arg::count(known)).arg("points", Arg::count(all))];
    }
    let mut out = Vec::new();
    let longer = (2..=NAMED).map(|k| (class("periodic", k as f64), "motion-map-subharmonic", k));
    let others = [
        (class("periodic", (NAMED + 1) as f64), "motion-map-longer-period", NAMED),
        (class("not periodic", f64::NAN), "motion-map-not-periodic", LONGEST),
    ];
    for (class, key, turns) in longer.chain(others) {
        let count = map.count(|c| c == class);
        let Some(first) = map.classes.iter().position(|c| *c == class) else { continue };
        let finding = Finding::info("other_motions", key)
            .of(class)
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("points", Arg::count(all))
            .arg("turns", Arg::count(turns))
            .arg("place", map.place(first));
        out.push(map.with_place(finding, first));
    }
    out
}

/// Points without a settled motion, by cause.
fn without(map: &Map, results: &Collected) -> Vec<Finding> {
    let all = map.classes.len();
    let mut out = Vec::new();
    let unsettled = map.count(|c| c == "not settled");
    if unsettled > 0 {
        let finding = Finding::warning("not_settled", "motion-map-not-settled").value(unsettled as f64, "");
        out.push(finding.arg("count", Arg::count(unsettled)).arg("points", Arg::count(all)));
    }
    let mut causes: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    let refused = results.words(REFUSED);
    for (row, why) in refused.iter().enumerate().filter(|w| !w.1.is_empty()) {
        causes.entry(crate::study::parameters::uncertainty::cause(why)).or_insert((0, row)).0 += 1;
    }
    for (cause, (count, row)) in causes {
        let finding = Finding::warning("failed_machines", "motion-map-failed-machines")
            .of(cause)
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("points", Arg::count(all))
            .arg("place", map.place(row))
            .arg("reason", Arg::term(refused[row].trim_end_matches('.')));
        out.push(map.with_place(finding, row));
    }
    let mut motions: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    for (row, why) in results.words("failure").into_iter().enumerate().filter(|(r, w)| !w.is_empty() && refused[*r].is_empty()) {
        motions.entry(why).or_insert((0, row)).0 += 1;
    }
    for (why, (count, row)) in motions {
        let finding = Finding::warning("failed_motions", "motion-map-failed-motions")
            .of(&why)
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("points", Arg::count(all))
            .arg("place", map.place(row))
            .arg("reason", Arg::term(why));
        out.push(map.with_place(finding, row));
    }
    out
}

fn table(map: &Map, results: &Collected) -> Result<Table, Diagnostic> {
    let mut t = Table::new("map", "Motions, along x and then along y").leading();
    for (i, (c, _)) in results.columns.iter().enumerate() {
        if c.kind == Kind::Text {
            t = t.text(&c.name, Arg::term(&c.doc), results.words(&c.name));
        } else {
            let finite = results.numbers(&c.name).into_iter().map(|x| if x.is_finite() { x } else { f64::NAN }).collect();
            let doc = Arg::term(&c.doc);
            let doc = if i < 2 { doc } else { Arg::noted(doc, "NaN where there is none") };
            t = t.float(&c.name, &c.unit, doc, finite);
        }
    }
    t.text("class", "how the motion repeats", map.classes.clone()).build().map_err(inconsistent)
}

/// Lengths in units that people read.
fn drawn(label: impl Into<Arg>, unit: &str, largest: f64, log: bool) -> Axis {
    let (unit, factor) = match unit {
        "m" if largest < 1e-3 => ("µm", 1e6),
        "m" => ("mm", 1e3),
        other => (other, 1.0),
    };
    let axis = if log { Axis::log(label, unit) } else { Axis::new(label, unit) };
    axis.factor(factor)
}

fn figures(map: &Map, mut outcome: Outcome) -> Outcome {
    if map.classes.is_empty() {
        return outcome;
    }
    let axes = &map.study.axes;
    let side =
        |k: usize| drawn(parameter_name(axes[k].name()), axes[k].unit, map.values[k].iter().fold(0.0, |m: f64, x| m.max(x.abs())), false);
    let [x, y] = [0, 1].map(|k| axes[k].name());
    let figure = |name: String, title: Arg, heat: Heat| {
        let alt = Message::new("motion-map-alt").arg("what", title.clone()).arg("x", parameter_name(x)).arg("y", parameter_name(y));
        Figure::new(name, title, alt).x(side(0)).panel(Panel::new(side(1)).mark(heat))
    };
    for (probe, sizes) in &map.sizes {
        let known = sizes.iter().filter(|a| a.is_finite());
        let (least, most) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
        if least <= most {
            let column = probes::column(probe);
            let label = if probe.is_tilt() { "largest tilt" } else { "largest displacement" };
            let log = least > 0.0 && most > WIDE * least;
            let colours = if probe.is_tilt() { probes::axis(label, probe, most) } else { drawn(label, "m", most, log) };
            let heat = Heat::new("map", x, y, &column, colours);
            let title = if probe.is_tilt() { "Largest tilt" } else { "Largest displacement" };
            outcome = outcome.figure(figure(column.replace('.', "-"), Arg::of(title, probes::label(probe)), heat));
        }
    }
    let classes = all_classes();
    if classes.iter().filter(|c| map.classes.contains(c)).count() < 2 {
        return outcome;
    }
    let heat = Heat::new("map", x, y, "class", Axis::new("the motion repeats", "")).of_classes(classes);
    outcome.figure(figure("motions".into(), "Period of the motions".into(), heat))
}
