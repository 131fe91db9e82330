//! Tables, figures and findings of spectra.

use super::Spectra;
use super::analyse::{Part, Window};
use super::natural::{self, NaturalFrequency};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Axis, Figure, Finding, Heat, Line, Message, Outcome, Panel, Rule, Table};
use crate::study::shared::support::inconsistent;
use laval_num::order::SortByNumber;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Lowest amplitude drawn over the highest.
const DEPTH: f64 = 1e-3;
/// Parts are distinguished from this share of the highest line on, unless a threshold is given.
const SHARE: f64 = 0.01;
/// A natural frequency so many times as high as what stands out is drawn all the same.
const NEAR: f64 = 2.5;
/// Largest denominator of an order that is called by its fraction.
const DENOMINATORS: usize = 4;
/// Classes of parts reported at most.
const MOST: usize = 8;

/// What a part is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Class {
    /// Order p/q in lowest terms, backward if negative.
    Fraction(i32, i32),
    /// No simple fraction: forward or backward.
    Free(bool),
}

/// The class of a part seen over so many turns.
fn class(p: Part, turns: f64) -> Class {
    let size = p.order.abs();
    let near = |q: usize| {
        let whole = (size * q as f64).round();
        (whole >= 1.0 && (size - whole / q as f64).abs() <= 0.25 / turns).then_some((whole as i32, q as i32))
    };
    let sign = if p.order < 0.0 { -1 } else { 1 };
    match (1..=DENOMINATORS).find_map(near) {
        Some((p, q)) => Class::Fraction(sign * p, q),
        None => Class::Free(p.order > 0.0),
    }
}

/// Name of a class in the subjects of findings.
fn label(class: Class) -> String {
    let way = |forward| if forward { "forward" } else { "backward" };
    match class {
        Class::Fraction(p, 1) if p.abs() > 1 => format!("superharmonic of order {}, {}", p.abs(), way(p > 0)),
        Class::Fraction(p, 1) => format!("part of the spin frequency, {}", way(p > 0)),
        Class::Fraction(p, q) if p.abs() == 1 => format!("subharmonic of order 1/{q}, {}", way(p > 0)),
        Class::Fraction(p, q) => format!("part of order {}/{q}, {}", p.abs(), way(p > 0)),
        Class::Free(forward) => {
            format!("part whose frequency is no fraction of the spin frequency with a denominator up to {DENOMINATORS}, {}", way(forward))
        }
    }
}

/// A part of the motion of a body, as an argument of a sentence.
fn component(class: Class, part: Part, body: &str) -> Message {
    let message = match class {
        Class::Fraction(p, 1) if p.abs() > 1 => Message::new("spectra-superharmonic").arg("order", Arg::count(p.unsigned_abs() as usize)),
        Class::Fraction(_, 1) => Message::new("spectra-spin-frequency"),
        Class::Fraction(p, q) => {
            let message = Message::new(if p.abs() == 1 { "spectra-subharmonic" } else { "spectra-fraction" });
            message.arg("p", Arg::count(p.unsigned_abs() as usize)).arg("q", Arg::count(q.unsigned_abs() as usize))
        }
        Class::Free(_) => Message::new("spectra-asynchronous").arg("order", Arg::number(part.order.abs())),
    };
    message.arg("whirl", Arg::word(if part.order > 0.0 { "forward" } else { "backward" })).arg("body", Arg::name(body))
}

/// Windows in which parts of one class exceed the threshold.
struct Seen {
    first: usize,
    last: usize,
    /// Number of windows.
    count: usize,
    largest: Part,
    at: usize,
}

pub(super) fn report(
    spectra: &Spectra,
    windows: &[Window],
    natural: &[NaturalFrequency],
    mut outcome: Outcome,
) -> Result<Outcome, Diagnostic> {
    if windows.is_empty() {
        return Ok(outcome.finding(Finding::info("no_spectra", "spectra-none")));
    }
    for f in findings(spectra, windows) {
        outcome = outcome.finding(f);
    }
    // along the speed where it only rises or only falls from window to window
    let steps = || windows.windows(2).map(|w| w[1].speed - w[0].speed);
    let along_speed = windows.len() > 1 && (steps().all(|d| d > 0.0) || steps().all(|d| d < 0.0));
    for (name, title, y, lines) in [
        ("waterfall", "Spectra along the motion, over frequency", ("frequency", "rad/s"), frequency_lines as fn(&Window) -> &[(f64, f64)]),
        ("order_spectra", "Spectra along the motion, over orders of the spin frequency", ("order", ""), order_lines),
    ] {
        let rows: Vec<(&Window, (f64, f64))> = windows.iter().flat_map(|w| lines(w).iter().map(move |l| (w, *l))).collect();
        if rows.is_empty() {
            continue;
        }
        let doc = if y.1.is_empty() {
            "frequency over spin frequency; negative turns against the rotor"
        } else {
            "negative turns against the rotor"
        };
        let table = Table::new(name, title)
            .float("t", "s", "time at the middle of the window", rows.iter().map(|r| r.0.t).collect())
            .float("speed", "rad/s", "spin speed there", rows.iter().map(|r| r.0.speed).collect())
            .float(y.0, y.1, doc, rows.iter().map(|r| r.1.0).collect())
            .float("amplitude", "m", "radius of the circular part of this line", rows.iter().map(|r| r.1.1).collect())
            .build()
            .map_err(inconsistent)?;
        let range = drawn_range(&rows, y.0, natural);
        let mut drawn = figure(spectra, name, y.0, along_speed, rows.iter().map(|r| r.1.1), range);
        let seen = |f: &NaturalFrequency| range.is_some_and(|(lo, hi)| (lo..=hi).contains(&f.on(y.0)));
        if let Some(panel) = drawn.panels.first_mut().filter(|_| natural.iter().any(seen)) {
            panel.marks.push(natural::line(natural, if along_speed { "speed" } else { "t" }, y.0).into());
        }
        outcome = outcome.table(table).figure(drawn);
    }
    if outcome.find_table("waterfall").or(outcome.find_table("order_spectra")).is_some() && !natural.is_empty() {
        outcome = outcome.table(natural::table(natural).build().map_err(inconsistent)?);
    }
    if outcome.find_table("waterfall").is_some() {
        outcome = outcome.table(spin_orders(spectra, windows)?);
    }
    Ok(outcome)
}

/// Frequencies or orders between which lines are drawn: those that stand out, and the spin frequency, with a margin.
fn drawn_range(rows: &[(&Window, (f64, f64))], y: &str, natural: &[NaturalFrequency]) -> Option<(f64, f64)> {
    let top = rows.iter().map(|r| r.1.1).fold(0.0, f64::max);
    let wider = |r: (f64, f64), x: f64| (r.0.min(x), r.1.max(x));
    let whole = rows.iter().map(|r| r.1.0).fold((f64::INFINITY, f64::NEG_INFINITY), wider);
    let spin = |w: &Window| if y == "order" { 1.0 } else { w.speed };
    let seen = rows.iter().filter(|r| r.1.1 >= DEPTH * top).map(|r| r.1.0).chain(rows.iter().map(|r| spin(r.0)));
    let seen = seen.fold((0.0, 0.0), wider);
    // the lowest natural frequency, where it is not far above
    let lowest = natural.iter().map(|f| f.on(y)).filter(|f| *f > 0.0).fold(f64::INFINITY, f64::min);
    let seen = if lowest <= NEAR * seen.1 { (seen.0, seen.1.max(lowest)) } else { seen };
    let margin = 0.1 * (seen.1 - seen.0);
    let (lo, hi) = ((seen.0 - margin).max(whole.0), (seen.1 + margin).min(whole.1));
    (lo < hi).then_some((lo, hi))
}

/// Orders of the spin that are drawn in a waterfall.
fn drawn_orders(spectra: &Spectra) -> impl Iterator<Item = i32> {
    let highest = spectra.highest;
    [-1, 1, 2, 3].into_iter().filter(move |k| f64::from(*k) <= highest)
}

/// Frequencies of the orders of the spin, window by window.
fn spin_orders(spectra: &Spectra, windows: &[Window]) -> Result<Table, Diagnostic> {
    let mut t = Table::new("spin_orders", "Frequencies of whole orders of the spin speed")
        .float("t", "s", "time at the middle of the window", windows.iter().map(|w| w.t).collect())
        .float("speed", "rad/s", "spin speed there", windows.iter().map(|w| w.speed).collect());
    for k in drawn_orders(spectra) {
        let doc = "order times spin speed; negative turns against the rotor";
        t = t.float(format!("order {k}"), "rad/s", doc, windows.iter().map(|w| f64::from(k) * w.speed).collect());
    }
    t.build().map_err(inconsistent)
}

fn frequency_lines(w: &Window) -> &[(f64, f64)] {
    &w.frequencies
}
fn order_lines(w: &Window) -> &[(f64, f64)] {
    &w.orders
}

fn figure(
    spectra: &Spectra,
    name: &str,
    y: &str,
    along_speed: bool,
    amplitudes: impl Iterator<Item = f64>,
    range: Option<(f64, f64)>,
) -> Figure {
    let top = amplitudes.fold(0.0, f64::max);
    let (unit, factor) = if top < 1e-3 { ("µm", 1e6) } else { ("mm", 1e3) };
    let top = factor * if top > 0.0 { top } else { 1e-6 };
    let colours = Axis::log("amplitude", unit).factor(factor).range(DEPTH * top, top);
    let (x, label) = if along_speed { ("speed", Axis::new("spin speed", "rad/s")) } else { ("t", Axis::new("time", "s")) };
    let axis = if y == "order" { Axis::new("order", "") } else { Axis::new("frequency", "Hz").factor(1.0 / TAU) };
    let axis = match (range, y) {
        (Some((lo, hi)), "order") => axis.range(lo, hi),
        (Some((lo, hi)), _) => axis.range(lo / TAU, hi / TAU),
        _ => axis,
    };
    let title = if y == "order" { "Order spectra" } else { "Waterfall" };
    let alt = Message::new("spectra-alt")
        .arg("body", Arg::name(&spectra.body.name))
        .arg("along", Arg::word(if along_speed { "speed" } else { "time" }))
        .arg("over", Arg::word(if y == "order" { "order" } else { "frequency" }));
    let mut panel = Panel::new(axis).mark(Heat::new(name, x, y, "amplitude", colours));
    for k in drawn_orders(spectra) {
        let word = Message::new("label-order").arg("order", Arg::number(f64::from(k)));
        panel = match y {
            "order" => panel.mark(Rule::y(f64::from(k), word)),
            _ => panel.mark(Line::new("spin_orders", x, format!("order {k}")).name(word).reference()),
        };
    }
    Figure::new(name, title, alt).x(label).panel(panel)
}

fn findings(spectra: &Spectra, windows: &[Window]) -> Vec<Finding> {
    let name = &spectra.body.name;
    let assessed: Vec<usize> = (0..windows.len()).filter(|&k| !windows[k].orders.is_empty()).collect();
    if assessed.is_empty() {
        return vec![Finding::info("no_orders", "spectra-no-orders")];
    }
    let top = assessed.iter().flat_map(|&k| &windows[k].orders).map(|l| l.1).fold(0.0, f64::max);
    let threshold = spectra.threshold.unwrap_or(SHARE * top);
    if !(top > 0.0) {
        return vec![Finding::info("no_components", "spectra-no-motion").of(name).arg("body", Arg::name(name))];
    }
    let mut classes: BTreeMap<Class, Seen> = BTreeMap::new();
    for &k in &assessed {
        for &p in windows[k].parts.iter().filter(|p| p.amplitude >= threshold) {
            let seen = classes.entry(class(p, windows[k].turns)).or_insert(Seen { first: k, last: k, count: 0, largest: p, at: k });
            seen.count += usize::from(seen.count == 0 || seen.last != k);
            seen.last = k;
            if p.amplitude > seen.largest.amplitude {
                (seen.largest, seen.at) = (p, k);
            }
        }
    }
    // seen once, a free vibration that dies out may pass for any fraction
    let mut once: Option<Seen> = None;
    classes.retain(|class, seen| {
        let fleeting = assessed.len() > 2 && seen.count == 1 && !matches!(class, Class::Fraction(_, 1));
        if fleeting && once.as_ref().is_none_or(|o| seen.largest.amplitude > o.largest.amplitude) {
            once = Some(Seen { ..*seen });
        }
        !fleeting
    });
    let limit = Arg::quantity(threshold, "m");
    let fleeting = once.map(|o| {
        let at = &windows[o.at];
        let finding = Finding::info("fleeting_components", "spectra-fleeting").of(name).value(o.largest.amplitude, "m");
        let finding = finding.arg("body", Arg::name(name)).arg("limit", limit.clone()).arg("speed", Arg::speed(at.speed));
        finding.evidence("order", o.largest.order, "").evidence("at speed", at.speed, "rad/s").evidence("at time", at.t, "s")
    });
    if classes.is_empty() {
        let key = if fleeting.is_some() { "spectra-no-lasting-components" } else { "spectra-no-components" };
        let none = Finding::info("no_components", key).of(name).arg("body", Arg::name(name)).arg("limit", limit);
        let none = none.arg("short", Arg::count(windows.len() - assessed.len())).evidence("highest line", top, "m");
        return std::iter::once(none).chain(fleeting).collect();
    }
    let mut sorted: Vec<(Class, Seen)> = classes.into_iter().collect();
    sorted.sort_by_number_down(|a| a.1.largest.amplitude);
    let speed = |k: usize| windows[k].speed;
    let one = |(class, seen): &(Class, Seen)| {
        let at = &windows[seen.at];
        // the part exceeds the threshold somewhere between the window before and this one
        let before = seen.first.checked_sub(1).map_or(f64::NAN, |k| (speed(seen.first) - speed(k)).abs());
        let between = assessed.iter().filter(|k| (seen.first..=seen.last).contains(k)).count();
        let one_speed = speed(seen.first) == speed(seen.last);
        let id = match class {
            Class::Fraction(p, 1) if p.abs() > 1 => "superharmonic",
            Class::Fraction(1 | -1, q) if *q > 1 => "subharmonic",
            Class::Fraction(..) => "component",
            Class::Free(_) => "asynchronous",
        };
        Finding::info(id, if one_speed { "spectra-component-at-speed" } else { "spectra-component" })
            .of(format!("{name} {}", label(*class)))
            .value(speed(seen.first), "rad/s")
            .arg("component", component(*class, seen.largest, name))
            .arg("limit", limit.clone())
            .arg("to", Arg::speed(speed(seen.last)))
            .arg("largest", Arg::quantity(seen.largest.amplitude, "m"))
            .arg("at", Arg::speed(at.speed))
            // not throughout: a part that comes and goes
            .arg("course", Arg::word(if seen.count < between { "intermittent" } else { "throughout" }))
            .arg("count", Arg::count(seen.count))
            .arg("between", Arg::count(between))
            .evidence("difference of speed to the window before", before, "rad/s")
            .evidence("largest amplitude", seen.largest.amplitude, "m")
            .evidence("order there", seen.largest.order, "")
            .evidence("orders distinguished there", 4.0 / at.turns, "")
            .evidence("frequency there", seen.largest.order.abs() * at.speed.abs(), "rad/s")
            .evidence("speed there", at.speed, "rad/s")
            .evidence("first seen at", windows[seen.first].t, "s")
            .evidence("last seen at", windows[seen.last].t, "s")
    };
    let mut out: Vec<Finding> = sorted.iter().take(MOST).map(one).collect();
    if sorted.len() > MOST {
        let finding = Finding::info("more_components", "spectra-more-components").arg("count", Arg::count(sorted.len() - MOST));
        out.push(finding.arg("body", Arg::name(name)).arg("limit", limit));
    }
    out.extend(fleeting);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_their_names() {
        let of = |order: f64| class(Part { order, amplitude: 1.0 }, 32.0);
        assert_eq!(of(-3.001), Class::Fraction(-3, 1));
        assert_eq!(of(0.502), Class::Fraction(1, 2));
        assert_eq!(of(1.0 / 3.0), Class::Fraction(1, 3));
        assert_eq!(of(1.5), Class::Fraction(3, 2));
        assert_eq!((of(0.46), of(-0.88)), (Class::Free(true), Class::Free(false)));
        assert!(
            label(of(-3.0)).contains("superharmonic of order 3, backward") && label(of(0.5)).contains("subharmonic of order 1/2, forward")
        );
    }
}
