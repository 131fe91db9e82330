//! Findings, tables and figures.

use super::Optimum;
use super::result::{Found, Run, Stray};
use super::search::{KEPT, TEST};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Axis, End, Figure, Finding, Line, Message, Outcome, Panel, Points, Rule, Table, TableBuilder, parameter_name};
use crate::study::Study;
use crate::study::shared::support::inconsistent;
use laval_num::optimise::Ended;

/// A limit is reached within this share of it.
const REACHED: f64 = 1e-3;
/// A parameter lies at a bound within this share of the range.
const AT_BOUND: f64 = 1e-9;
/// Relative difference of the numbers of two searches that arrived at the same optimum.
const SAME: f64 = 1e-4;

/// Whether the searches came to their end, as a word.
fn search_word(found: &Found) -> Arg {
    Arg::word(if found.complete { "complete" } else { "stopped" })
}

pub(super) fn report(study: &Optimum, found: &Found, end: End, name: &str) -> Result<Outcome, Diagnostic> {
    let mut out = Outcome::new(Optimum::KIND, name).end(end).work("runs", found.runs).work("runs without the number", found.failed);
    match &found.best {
        None => {
            let key = if study.limits.is_empty() { "optimum-none" } else { "optimum-none-in-limits" };
            let finding = Finding::warning("no_optimum", key)
                .arg("aim", Arg::name(&study.aim.name))
                .arg("search", search_word(found))
                .arg("runs", Arg::Count(found.runs));
            out = out.finding(finding);
        }
        Some(best) => {
            out = out.finding(headline(study, found, best));
            for f in parameters(study, found, best) {
                out = out.finding(f);
            }
            for f in limits(study, found, best) {
                out = out.finding(f);
            }
            out = test(out, study, found);
            if best.invalid {
                out = out.finding(Finding::invalid("outside_validity", "optimum-outside-validity"));
            }
        }
    }
    if let Some(best) = &found.best {
        out = out.table(optimum_table(study, found, best)?);
    }
    out = searches(out, study, found)?;
    profiles(out, study, found)?.checked().map_err(inconsistent)
}

fn headline(study: &Optimum, found: &Found, best: &Run) -> Finding {
    let change = (best.value - found.now) / found.now.abs();
    // of zero nothing is a share
    let present = match (found.now.is_finite(), change.is_finite()) {
        (true, true) => "change",
        (true, false) => "value",
        _ => "none",
    };
    let arrived: Vec<f64> = found.trails.iter().filter_map(|t| t.best.as_ref()).map(|r| r.value).collect();
    let same = arrived.iter().filter(|v| (**v - best.value).abs() <= SAME * best.value.abs()).count();
    let worst = found.slopes.iter().map(|s| s.slope).reduce(f64::min).unwrap_or(f64::NAN);
    let mut finding = Finding::info("optimum", "optimum-best")
        .of(&study.aim.name)
        .value(best.value, &found.unit)
        .arg("aim", Arg::name(&study.aim.name))
        .arg("extreme", Arg::word(if study.aim.large { "largest" } else { "smallest" }))
        // a resonance is no amplitude: what is made small or large is named
        .arg("kind", Arg::word(if found.unit == "rad/s" { "speed" } else { "other" }))
        .arg("search", search_word(found))
        .arg("present", Arg::word(present));
    if found.now.is_finite() {
        finding = finding.arg("now", Arg::quantity(found.now, &found.unit));
    }
    if change.is_finite() {
        finding = finding.arg("change", Arg::percent(change));
    }
    finding
        .evidence("searches that ended there", same as f64, "")
        .evidence("searches", found.trails.len() as f64, "")
        .evidence("least slope in any direction tested, relative number per whole range", worst, "")
        .evidence("runs", found.runs as f64, "")
}

fn parameters(study: &Optimum, found: &Found, best: &Run) -> Vec<Finding> {
    let one = |(k, v): (usize, &super::Vary)| {
        let end = |side: usize| found.stray.get(k).map_or(f64::NAN, |s| s.ends[side].0);
        let finding = Finding::info("recommended", "optimum-recommended")
            .of(&v.path)
            .value(v.value(best.place[k]), v.unit)
            .arg("search", search_word(found))
            .arg("aim", Arg::name(&study.aim.name))
            .arg("parameter", Arg::name(&v.path))
            .arg("now", Arg::quantity(v.now, v.unit))
            .arg("bound", Arg::word(bound(best, k)));
        let finding = match at_bound(study, found, best, k) {
            Some(rate) => finding
                .arg("slope", Arg::word(if rate > 0.0 { "rises" } else { "falls" }))
                .arg("rate", Arg::quantity(rate.abs(), &found.unit))
                .arg("step", Arg::quantity(1.0, v.unit)),
            None => finding.arg("slope", Arg::word("none")),
        };
        let finding = match found.stray.get(k) {
            Some(s) => finding
                .arg("range", Arg::word(range(s)))
                .arg("tolerance", Arg::percent(study.tolerance))
                .arg("from", Arg::quantity(s.ends[0].0, v.unit))
                .arg("to", Arg::quantity(s.ends[1].0, v.unit)),
            None => finding.arg("range", Arg::word("none")),
        };
        finding.evidence("recommended from", end(0), v.unit).evidence("to", end(1), v.unit)
    };
    study.vary.iter().enumerate().map(one).collect()
}

/// The bound at which a parameter lies.
fn bound(best: &Run, k: usize) -> &'static str {
    match best.place[k] {
        u if u <= AT_BOUND => "lower",
        u if u >= 1.0 - AT_BOUND => "upper",
        _ => "none",
    }
}

/// Which ends of a recommended range are bounds of the search.
fn range(s: &Stray) -> &'static str {
    match s.ends.map(|e| e.1) {
        [true, true] => "whole",
        [true, false] => "lower",
        [false, true] => "upper",
        [false, false] => "inside",
    }
}

/// Change of the number towards the bound at which a parameter lies, per unit of the parameter. None where limits are reached: slopes then count what exceeds them.
fn at_bound(study: &Optimum, found: &Found, best: &Run, k: usize) -> Option<f64> {
    let u = best.place[k];
    let inwards = match bound(best, k) {
        "lower" => 1.0,
        "upper" => -1.0,
        _ => return None,
    };
    if study.limits.iter().zip(&best.limited).any(|(l, x)| !(l.excess(*x) < -REACHED)) {
        return None;
    }
    let slope = found.slopes.iter().find(|s| s.along == Some((k, inwards)))?.slope;
    let v = &study.vary[k];
    let rate = slope.abs() * found.size() * TEST / (v.value(u + inwards * TEST) - v.value(u)).abs();
    let sign = if (slope > 0.0) == study.aim.large { 1.0 } else { -1.0 };
    Some(sign * rate).filter(|r| r.is_finite())
}

fn limits(study: &Optimum, found: &Found, best: &Run) -> Vec<Finding> {
    let each = study.limits.iter().zip(&best.limited).zip(&found.units);
    each.map(|((l, x), unit)| {
        let reached = l.excess(*x) >= -REACHED;
        let key = if reached { "optimum-limit-reached" } else { "optimum-limit-kept" };
        Finding::info(if reached { "limit_reached" } else { "limit_kept" }, key)
            .of(&l.name)
            .value(*x, unit)
            .arg("number", Arg::name(&l.name))
            .arg("side", Arg::word(if l.upper { "upper" } else { "lower" }))
            .arg("limit", Arg::quantity(l.value, unit))
            .evidence("excess over the limit, as a share of it", l.excess(*x).max(-f64::MAX), "")
            .evidence("excess that counts as kept", KEPT, "")
    })
    .collect()
}

/// Whether the best is the best around it.
fn test(mut out: Outcome, study: &Optimum, found: &Found) -> Outcome {
    if found.slopes.is_empty() {
        return out;
    }
    let worst = found.slopes.iter().map(|s| s.slope).fold(f64::INFINITY, |m, s| if s < m || s.is_nan() { s } else { m });
    // what a smooth optimum shows at that distance is curvature
    let finding = match worst {
        w if !w.is_finite() => Finding::warning("optimality", "optimum-neighbour-without"),
        w if w >= 0.0 => Finding::info("optimality", "optimum-neighbours-worse"),
        w if w >= -1e-2 => Finding::info("optimality", "optimum-neighbours-alike"),
        _ => Finding::warning("optimality", "optimum-neighbour-better"),
    };
    let mut finding = finding
        .arg("count", Arg::count(found.slopes.len()))
        .arg("aim", Arg::name(&study.aim.name))
        .arg("limits", Arg::word(if study.limits.is_empty() { "none" } else { "some" }));
    if worst.is_finite() {
        let better = -worst * TEST;
        let better = if found.relative() { Arg::percent(better) } else { Arg::quantity(better, &found.unit) };
        finding = finding.value(worst, "").arg("better", better);
    }
    out = out.finding(finding.evidence("distance of the machines tested, as a share of the bounds", TEST, ""));
    let short = found.trails.iter().filter(|t| t.ended == Ended::Evaluations).count();
    // what every search found alike needs no such caution
    let arrived: Vec<f64> = found.trails.iter().filter_map(|t| t.best.as_ref()).map(|r| r.value).collect();
    let (least, most) = arrived.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
    let agreed = arrived.len() == found.trails.len() && arrived.len() > 1 && most - least <= SAME * most.abs().max(least.abs());
    if short > 0 && !agreed {
        let finding = Finding::info("searches_cut", "optimum-searches-cut").arg("count", Arg::count(short));
        out = out.finding(finding.arg("searches", Arg::count(found.trails.len())).arg("runs", Arg::count(study.runs)));
    }
    out
}

fn optimum_table(study: &Optimum, found: &Found, best: &Run) -> Result<Table, Diagnostic> {
    let side = |k: usize, sign: f64| found.slopes.iter().find(|s| s.along == Some((k, sign))).map_or(f64::NAN, |s| s.slope);
    let all: Vec<usize> = (0..study.vary.len()).collect();
    let float = |f: &dyn Fn(usize) -> f64| all.iter().map(|&k| f(k)).collect::<Vec<f64>>();
    let end = |k: usize, side: usize| found.stray.get(k).map_or(f64::NAN, |s| s.ends[side].0);
    Table::new("optimum", "The recommended parameters")
        .names("parameter", "path", study.vary.iter().map(|v| v.path.clone()).collect())
        .float("value", "", "recommended, in its unit", float(&|k| study.vary[k].value(best.place[k])))
        .names("unit", "of the parameter", study.vary.iter().map(|v| v.unit.to_string()).collect())
        .float("from", "", "lowest recommended value, the others at theirs; NaN when it was not sought", float(&|k| end(k, 0)))
        .float("to", "", "highest recommended value; NaN when it was not sought", float(&|k| end(k, 1)))
        .float("machine", "", "value of the machine as it is", float(&|k| study.vary[k].now))
        .float("lower bound", "", "of the search", float(&|k| study.vary[k].from))
        .float("upper bound", "", "of the search", float(&|k| study.vary[k].to))
        .text("at bound", "lower, upper or neither", all.iter().map(|&k| bound(best, k).replace("none", "")).collect())
        .float(
            "slope up",
            "",
            "one-sided slope towards higher values: relative change of what is minimised per whole range; NaN at the bound, and of a number that is zero",
            float(&|k| side(k, 1.0)),
        )
        .float("slope down", "", "the same towards lower values; NaN likewise", float(&|k| side(k, -1.0)))
        .in_row_units(&["value", "from", "to", "machine", "lower bound", "upper bound"])
        .build()
        .map_err(inconsistent)
}

/// A number in words: `critical speed order 1 forward`.
fn readable(name: &str) -> Arg {
    Arg::term(name.replace('_', " "))
}

/// Axis of the number.
fn axis(study: &Optimum, found: &Found) -> Axis {
    let size = found.best.as_ref().map_or(1.0, |b| b.value.abs());
    let (unit, factor) = match found.unit.as_str() {
        "m" if size < 1e-3 => ("µm", 1e6),
        "m" => ("mm", 1e3),
        u => (u, 1.0),
    };
    Axis::new(readable(&study.aim.name), unit).factor(factor)
}

fn searches(mut out: Outcome, study: &Optimum, found: &Found) -> Result<Outcome, Diagnostic> {
    let rows: Vec<(usize, u64, f64)> =
        found.trails.iter().enumerate().flat_map(|(k, t)| t.history.iter().map(move |h| (k + 1, h.0, h.1))).collect();
    let table = Table::new("search", "The best machine found so far, with all limits kept")
        .int("start", "", "number of the search", rows.iter().map(|r| r.0 as i64).collect())
        .int("runs", "", "runs of the study in this search", rows.iter().map(|r| r.1 as i64).collect())
        .float(
            "number",
            &found.unit,
            "the number that is made small or large; NaN before all limits are kept",
            rows.iter().map(|r| r.2).collect(),
        )
        .build()
        .map_err(inconsistent)?;
    let drawn = rows.iter().any(|r| r.2.is_finite());
    out = out.table(table);
    if drawn {
        let panel = Panel::new(axis(study, found))
            .mark(Line::new("search", "runs", "number").group("start"))
            .mark(Rule::y(found.now, "present value"));
        let alt = Message::new("optimum-alt-search").arg("aim", readable(&study.aim.name)).arg("searches", Arg::count(found.trails.len()));
        out = out.figure(Figure::new("search", "Progress of the search", alt).x(Axis::new("runs of the study", "")).panel(panel));
    }
    Ok(out)
}

/// The number along each parameter through the optimum.
fn profiles(mut out: Outcome, study: &Optimum, found: &Found) -> Result<Outcome, Diagnostic> {
    let Some(best) = found.best.as_ref().filter(|_| !found.profiles.is_empty()) else { return Ok(out) };
    let rows: Vec<(usize, &Run)> = found.profiles.iter().enumerate().flat_map(|(k, p)| p.iter().map(move |r| (k, r))).collect();
    let table = Table::new("profiles", "The number along each parameter, the others at their best")
        .names("parameter", "path", rows.iter().map(|r| study.vary[r.0].path.clone()).collect())
        .float(
            "place",
            "",
            "place between the bounds, 0 to 1; logarithmic over a decade and more",
            rows.iter().map(|r| r.1.place[r.0]).collect(),
        )
        .float("value", "", "of the parameter, in its unit", rows.iter().map(|r| study.vary[r.0].value(r.1.place[r.0])).collect())
        .float("number", &found.unit, "the number; NaN where the study does not find it", rows.iter().map(|r| r.1.value).collect())
        .flag("kept", "all limits are kept", rows.iter().map(|r| r.1.kept(&study.limits)).collect());
    let marks = Table::new("best", "The optimum in the figures of profiles")
        .names("parameter", "path", study.vary.iter().map(|v| v.path.clone()).collect())
        .float("place", "", "place between the bounds", best.place.clone())
        .float("number", &found.unit, "the number", vec![best.value; study.vary.len()]);
    // each figure has its own parameter along x
    let own = |k: usize| format!("along {}", study.vary[k].path);
    let along = |table: TableBuilder, of: &dyn Fn(usize) -> Vec<f64>| {
        let column =
            |t: TableBuilder, k: usize| t.float(own(k), study.vary[k].unit, "value of this parameter; NaN in rows of others", of(k));
        (0..study.vary.len()).fold(table, column)
    };
    let value = |k: usize, of: usize, u: f64| if of == k { study.vary[k].value(u) } else { f64::NAN };
    let table = along(table, &|k| rows.iter().map(|r| value(k, r.0, r.1.place[k])).collect()).build().map_err(inconsistent)?;
    let marks = along(marks, &|k| (0..study.vary.len()).map(|j| value(k, j, best.place[k])).collect()).build().map_err(inconsistent)?;
    let sign = if study.aim.large { -1.0 } else { 1.0 };
    let allowed = best.value + sign * study.tolerance * best.value.abs();
    // far from the optimum the number may be far larger: what matters lies near it
    let finite = rows.iter().map(|r| r.1.value).filter(|v| v.is_finite());
    let most = finite.fold(0.0f64, |m, v| m.max(v.abs()));
    let mut axis = axis(study, found);
    if !study.aim.large && best.value > 0.0 && most > 20.0 * best.value {
        axis = Axis { scale: crate::outcome::Scale::Log, ..axis };
    }
    out = out.table(table).table(marks);
    for (k, v) in study.vary.iter().enumerate() {
        let line = Line::new("profiles", own(k), "number").solid_where("kept").meaning("limits kept", "a limit broken");
        let panel = Panel::new(axis.clone())
            .mark(line.name(readable(&study.aim.name)))
            .mark(Points::new("best", own(k), "number").name("optimum"))
            .mark(Rule::x(v.now, "present value"))
            .mark(Rule::y(allowed, Message::new("optimum-worse").arg("share", Arg::percent(study.tolerance))));
        let named = |key: &str| Message::new(key).arg("parameter", parameter_name(&v.path));
        let alt = named("optimum-alt-profile").arg("aim", readable(&study.aim.name));
        let x = Axis::parameter(&v.path, v.unit);
        let x = if v.logarithmic() { Axis { scale: crate::outcome::Scale::Log, ..x } } else { x };
        let (from, to) = (v.from.min(v.to) * x.factor, v.from.max(v.to) * x.factor);
        let figure = Figure::new(format!("profiles-{}", k + 1), named("optimum-title-profile"), alt);
        out = out.figure(figure.x(x.range(from, to)).panel(panel));
    }
    Ok(out)
}
