//! Findings, tables and figures.

use super::Optimum;
use super::result::{Found, Run};
use super::search::{KEPT, TEST};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Axis, End, Figure, Finding, Level, Line, Outcome, Panel, Points, Rule, Table, quantity, significant};
use crate::study::Study;
use crate::study::shared::support::inconsistent;
use laval_num::optimise::Ended;

/// A limit is reached within this share of it.
const REACHED: f64 = 1e-3;
/// A parameter lies at a bound within this share of the range.
const AT_BOUND: f64 = 1e-9;
/// Relative difference of the numbers of two searches that arrived at the same optimum.
const SAME: f64 = 1e-4;

/// The number with its unit.
fn with(value: f64, unit: &str) -> String {
    if unit.is_empty() { significant(value, 5) } else { quantity(value, unit) }
}

pub(super) fn report(study: &Optimum, found: &Found, end: End, name: &str) -> Result<Outcome, Diagnostic> {
    let mut out = Outcome::new(Optimum::KIND, name).end(end).work("runs", found.runs).work("runs without the number", found.failed);
    match &found.best {
        None => {
            let text = if !found.complete {
                let kept = if study.limits.is_empty() { "had the number to be optimised" } else { "kept the limits" };
                format!("No machine {kept} before the study stopped; {} runs were begun.", found.runs)
            } else if study.limits.is_empty() {
                "None of the machines that were tried has the number to be optimised.".to_string()
            } else {
                "No machine that was tried keeps the limits: widen the bounds, or relax a limit.".to_string()
            };
            out = out.finding(Finding::warning("no_optimum", text));
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
                let text = "A result of the recommended machine lies outside the validity of a model.";
                out = out.finding(Finding { level: Level::Invalid, ..Finding::warning("outside_validity", text) });
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
    let way = if study.aim.large { "largest" } else { "least" };
    let change = 100.0 * (best.value - found.now) / found.now.abs();
    // of zero nothing is a share
    let away = if change.is_finite() { format!(" ({} % away)", significant(change.abs(), 3)) } else { String::new() };
    let now =
        if found.now.is_finite() { format!(" The machine as it is has {}{away}.", with(found.now, &found.unit)) } else { String::new() };
    let so_far = if found.complete { "" } else { " before the study stopped" };
    // a resonance is no amplitude: what is made small or large is said
    let what = if found.unit == "rad/s" { "speed or frequency of " } else { "" };
    let text = format!("The {way} {what}{} found within the bounds{so_far} is {{}}.{now}", study.aim.name);
    let arrived: Vec<f64> = found.trails.iter().filter_map(|t| t.best.as_ref()).map(|r| r.value).collect();
    let same = arrived.iter().filter(|v| (**v - best.value).abs() <= SAME * best.value.abs()).count();
    let worst = found.slopes.iter().map(|s| s.slope).reduce(f64::min).unwrap_or(f64::NAN);
    Finding::info("optimum", text)
        .of(&study.aim.name)
        .value(best.value, &found.unit)
        .evidence("searches that ended there", same as f64, "")
        .evidence("searches", found.trails.len() as f64, "")
        .evidence("least slope in any direction tested, relative number per whole range", worst, "")
        .evidence("runs", found.runs as f64, "")
}

fn parameters(study: &Optimum, found: &Found, best: &Run) -> Vec<Finding> {
    let say = |(k, v): (usize, &super::Vary)| {
        let at = if best.place[k] <= AT_BOUND {
            ", its lower bound: a lower one may allow a better machine"
        } else if best.place[k] >= 1.0 - AT_BOUND {
            ", its upper bound: a higher one may allow a better machine"
        } else {
            ""
        };
        let range = found.stray.get(k).map_or_else(String::new, |s| {
            let end = |(x, bound): (f64, bool)| format!("{}{}", with(x, v.unit), if bound { " (the bound)" } else { "" });
            format!(" Within {} % of the best from {} to {}.", significant(100.0 * study.tolerance, 3), end(s.ends[0]), end(s.ends[1]))
        });
        let slope = at_bound(study, found, best, k).unwrap_or_default();
        let head = if found.complete { "Recommended" } else { "Best before the study stopped" };
        let text = format!("{head}: {} = {{}}{at}.{slope}{range} The machine has {}.", v.path, with(v.now, v.unit));
        let end = |side: usize| found.stray.get(k).map_or(f64::NAN, |s| s.ends[side].0);
        Finding::info("recommended", text)
            .of(&v.path)
            .value(v.value(best.place[k]), v.unit)
            .evidence("recommended from", end(0), v.unit)
            .evidence("to", end(1), v.unit)
    };
    study.vary.iter().enumerate().map(say).collect()
}

/// How the number changes towards the bound at which a parameter lies. None where limits are reached: slopes then count what exceeds them.
fn at_bound(study: &Optimum, found: &Found, best: &Run, k: usize) -> Option<String> {
    let u = best.place[k];
    let inwards = if u <= AT_BOUND {
        1.0
    } else if u >= 1.0 - AT_BOUND {
        -1.0
    } else {
        return None;
    };
    if study.limits.iter().zip(&best.limited).any(|(l, x)| !(l.excess(*x) < -REACHED)) {
        return None;
    }
    let slope = found.slopes.iter().find(|s| s.along == Some((k, inwards)))?.slope;
    let v = &study.vary[k];
    let rate = slope.abs() * found.size() * TEST / (v.value(u + inwards * TEST) - v.value(u)).abs();
    let word = if (slope > 0.0) == study.aim.large { "rises" } else { "falls" };
    let unit = if v.unit.is_empty() { "unit" } else { v.unit };
    rate.is_finite().then(|| format!(" Towards it {} {word} by {} per {unit} of {}.", study.aim.name, with(rate, &found.unit), v.path))
}

fn limits(study: &Optimum, found: &Found, best: &Run) -> Vec<Finding> {
    let each = study.limits.iter().zip(&best.limited).zip(&found.units);
    each.map(|((l, x), unit)| {
        let reached = l.excess(*x) >= -REACHED;
        let side = if l.upper { "upper" } else { "lower" };
        let how = if reached { "is reached: relaxing it may allow a better machine" } else { "is not reached" };
        let text = format!("The {side} limit on {}, {}, {how}; it is {{}}.", l.name, with(l.value, unit));
        Finding::info(if reached { "limit_reached" } else { "limit_kept" }, text)
            .of(&l.name)
            .value(*x, unit)
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
    let count = found.slopes.len();
    let counted = if study.limits.is_empty() { "" } else { ", with what exceeds limits counted" };
    let (per, shown) = if found.relative() {
        (format!(" of the present {} per whole range between the bounds{counted}", study.aim.name), (100.0 * worst, "%"))
    } else {
        (format!(" per whole range between the bounds{counted}"), (worst, found.unit.as_str()))
    };
    // what a smooth optimum shows at that distance is curvature
    let finding = if worst >= 0.0 {
        let text = format!("None of {count} machines at a distance of {TEST:.0e} of the bounds is better: the least slope is {{}}{per}.");
        Finding::info("optimality", text)
    } else if worst >= -1e-2 {
        let better = significant(100.0 * TEST * -worst, 2);
        let text = format!(
            "Of {count} machines at a distance of {TEST:.0e} of the bounds the best is better by {better} % only: the search has arrived (least slope {{}}{per})."
        );
        Finding::info("optimality", text)
    } else {
        let text = format!(
            "Of {count} machines at a distance of {TEST:.0e} of the bounds one is better: the search has not arrived (slope {{}}{per}). Allow more runs."
        );
        Finding::warning("optimality", text)
    };
    out = out.finding(finding.value(worst, "").shown_as(shown.0, shown.1).evidence(
        "distance of the machines tested, as a share of the bounds",
        TEST,
        "",
    ));
    let short = found.trails.iter().filter(|t| t.ended == Ended::Evaluations).count();
    // what every search found alike needs no such caution
    let arrived: Vec<f64> = found.trails.iter().filter_map(|t| t.best.as_ref()).map(|r| r.value).collect();
    let (least, most) = arrived.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
    let agreed = arrived.len() == found.trails.len() && arrived.len() > 1 && most - least <= SAME * most.abs().max(least.abs());
    if short > 0 && !agreed {
        let text = format!("{short} of {} searches used up their {} runs before they had narrowed down.", found.trails.len(), study.runs);
        out = out.finding(Finding::info("searches_cut", text));
    }
    out
}

fn optimum_table(study: &Optimum, found: &Found, best: &Run) -> Result<Table, Diagnostic> {
    let side = |k: usize, sign: f64| found.slopes.iter().find(|s| s.along == Some((k, sign))).map_or(f64::NAN, |s| s.slope);
    let all: Vec<usize> = (0..study.vary.len()).collect();
    let float = |f: &dyn Fn(usize) -> f64| all.iter().map(|&k| f(k)).collect::<Vec<f64>>();
    let end = |k: usize, side: usize| found.stray.get(k).map_or(f64::NAN, |s| s.ends[side].0);
    let bound = |k: usize| match best.place[k] {
        u if u <= AT_BOUND => "lower",
        u if u >= 1.0 - AT_BOUND => "upper",
        _ => "",
    };
    Table::new("optimum", "The recommended parameters")
        .text("parameter", "path", study.vary.iter().map(|v| v.path.clone()).collect())
        .float("value", "", "recommended, in its unit", float(&|k| study.vary[k].value(best.place[k])))
        .text("unit", "of the parameter", study.vary.iter().map(|v| v.unit.to_string()).collect())
        .float("from", "", "lowest recommended value, the others at theirs; NaN when it was not sought", float(&|k| end(k, 0)))
        .float("to", "", "highest recommended value; NaN when it was not sought", float(&|k| end(k, 1)))
        .float("machine", "", "value of the machine as it is", float(&|k| study.vary[k].now))
        .float("lower bound", "", "of the search", float(&|k| study.vary[k].from))
        .float("upper bound", "", "of the search", float(&|k| study.vary[k].to))
        .text("at bound", "lower, upper or neither", all.iter().map(|&k| bound(k).to_string()).collect())
        .float(
            "slope up",
            "",
            "one-sided slope towards higher values: relative change of what is minimised per whole range; NaN at the bound, and of a number that is zero",
            float(&|k| side(k, 1.0)),
        )
        .float("slope down", "", "the same towards lower values; NaN likewise", float(&|k| side(k, -1.0)))
        .build()
        .map_err(inconsistent)
}

/// Axis of the number.
fn axis(study: &Optimum, found: &Found) -> Axis {
    let size = found.best.as_ref().map_or(1.0, |b| b.value.abs());
    let (unit, factor) = match found.unit.as_str() {
        "m" if size < 1e-3 => ("µm", 1e6),
        "m" => ("mm", 1e3),
        u => (u, 1.0),
    };
    Axis::new(study.aim.name.replace('_', " "), unit).factor(factor)
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
        let panel =
            Panel::new(axis(study, found)).mark(Line::new("search", "runs", "number").group("start")).mark(Rule::y(found.now, "as it is"));
        let alt = format!("Best {} over the runs of {} searches.", study.aim.name, found.trails.len());
        out = out.figure(Figure::new("search", "The search", alt).x(Axis::new("runs of the study", "")).panel(panel));
    }
    Ok(out)
}

/// The number along each parameter through the optimum.
fn profiles(mut out: Outcome, study: &Optimum, found: &Found) -> Result<Outcome, Diagnostic> {
    let Some(best) = found.best.as_ref().filter(|_| !found.profiles.is_empty()) else { return Ok(out) };
    let rows: Vec<(usize, &Run)> = found.profiles.iter().enumerate().flat_map(|(k, p)| p.iter().map(move |r| (k, r))).collect();
    let table = Table::new("profiles", "The number along each parameter, the others at their best")
        .text("parameter", "path", rows.iter().map(|r| study.vary[r.0].path.clone()).collect())
        .float(
            "place",
            "",
            "place between the bounds, 0 to 1; logarithmic over a decade and more",
            rows.iter().map(|r| r.1.place[r.0]).collect(),
        )
        .float("value", "", "of the parameter, in its unit", rows.iter().map(|r| study.vary[r.0].value(r.1.place[r.0])).collect())
        .float("number", &found.unit, "the number; NaN where the study does not find it", rows.iter().map(|r| r.1.value).collect())
        .flag("kept", "all limits are kept", rows.iter().map(|r| r.1.kept(&study.limits)).collect())
        .build()
        .map_err(inconsistent)?;
    let marks = Table::new("best", "The optimum in the figure of profiles")
        .text("parameter", "path", study.vary.iter().map(|v| v.path.clone()).collect())
        .float("place", "", "place between the bounds", best.place.clone())
        .float("number", &found.unit, "the number", vec![best.value; study.vary.len()])
        .build()
        .map_err(inconsistent)?;
    let sign = if study.aim.large { -1.0 } else { 1.0 };
    let allowed = best.value + sign * study.tolerance * best.value.abs();
    // far from the optimum the number may be far larger: what matters lies near it
    let finite = rows.iter().map(|r| r.1.value).filter(|v| v.is_finite());
    let most = finite.fold(0.0f64, |m, v| m.max(v.abs()));
    let mut axis = axis(study, found);
    if !study.aim.large && best.value > 0.0 && most > 20.0 * best.value {
        axis = Axis { scale: crate::outcome::Scale::Log, ..axis };
    }
    let line = Line::new("profiles", "place", "number").group("parameter").solid_where("kept").meaning("limits kept", "a limit broken");
    let panel = Panel::new(axis)
        .mark(line)
        .mark(Points::new("best", "place", "number").name("optimum"))
        .mark(Rule::y(allowed, format!("{} % worse", significant(100.0 * study.tolerance, 3))));
    let alt = format!("{} along each of {} parameters through the optimum.", study.aim.name, study.vary.len());
    out = out.table(table).table(marks);
    Ok(out.figure(
        Figure::new("profiles", "Around the optimum", alt).x(Axis::new("place between the bounds", "").range(0.0, 1.0)).panel(panel),
    ))
}
