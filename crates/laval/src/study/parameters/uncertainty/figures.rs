//! Distributions and indices drawn.

use super::result::{Samples, Shares, Spread};
use super::{Interval, Uncertainty};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Axis, Band, Figure, Finding, Line, Message, Outcome, Panel, Rule, Table, parameter_name};
use crate::study::shared::support::inconsistent;
use laval_num::sampling::morris::Effects;
use std::collections::BTreeMap;

/// Numbers drawn unless some are named.
const SHOWN: usize = 4;
/// Correlation from which on two numbers have the same picture.
const SAME_SHAPE: f64 = 0.999;
/// Samples below which indices of Sobol are rough.
const ROUGH: usize = 1000;
/// Points of a distribution curve.
const CURVE: usize = 500;

/// The numbers to draw.
fn shown(study: &Uncertainty, samples: &Samples) -> Vec<usize> {
    let all = 0..samples.names.len();
    if study.show.is_empty() { all.take(SHOWN).collect() } else { all.filter(|&i| samples.names[i].0.starts_with(&study.show)).collect() }
}

pub fn distributions(
    mut outcome: Outcome,
    study: &Uncertainty,
    samples: &Samples,
    spreads: &[Spread],
    own: &BTreeMap<&str, f64>,
) -> Result<Outcome, Diagnostic> {
    let chosen = shown(study, samples);
    if chosen.is_empty() && !samples.names.is_empty() {
        let finding = Finding::warning("nothing_shown", "uncertainty-nothing-shown").arg("show", Arg::name(&study.show));
        outcome = outcome.finding(finding.arg("quantities", Arg::names(samples.names.iter().map(|n| n.0.as_str()))));
    }
    let mut drawn: Vec<usize> = Vec::new();
    for &i in &chosen {
        let ((name, unit), s) = (&samples.names[i], &spreads[i]);
        let (low, high) = (s.smallest, s.largest);
        if !(high > low) {
            continue;
        }
        let sorted = study.sorted(&samples.values[i]);
        let (edges, density) = histogram(&sorted);
        // up, along and down each bar
        let x: Vec<f64> = (0..density.len()).flat_map(|b| [edges[b], edges[b + 1]]).collect();
        let y: Vec<f64> = density.iter().flat_map(|d| [*d, *d]).collect();
        let unit_of_density = if unit.is_empty() { String::new() } else { format!("1/({unit})") };
        let bars = format!("histogram {name}");
        let named = |key: &str| Message::new(key).arg("quantity", readable(name));
        let table = Table::new(&bars, named("uncertainty-table-histogram"))
            .float("value", unit, "end of a bar", x.clone())
            .float("density", unit_of_density, "share of the samples per unit", y)
            .float("zero", "", "foot of the bars", vec![0.0; x.len()])
            .build()
            .map_err(inconsistent)?;
        let curve = format!("distribution {name}");
        let n = sorted.len();
        let picked: Vec<usize> = (0..n.min(CURVE)).map(|j| if n <= CURVE { j } else { j * (n - 1) / (CURVE - 1) }).collect();
        let steps = Table::new(&curve, named("uncertainty-table-distribution"))
            .float("value", unit, "value", picked.iter().map(|&j| sorted[j]).collect())
            .float("share", "", "share of the samples at or below it", picked.iter().map(|&j| (j + 1) as f64 / n as f64).collect())
            .build()
            .map_err(inconsistent)?;
        outcome = outcome.table(table).table(steps);
        // a number that rises or falls in a straight line with one that is drawn has the same picture
        if study.show.is_empty() && drawn.iter().any(|&j| proportional(&samples.values[i], &samples.values[j])) {
            continue;
        }
        drawn.push(i);
        let mut panel = Panel::new(Axis::new("share of the samples per unit", "").bare())
            .mark(Band::between(&bars, "value", "zero", "density").neutral())
            .mark(Line::new(&bars, "value", "density"));
        for (share, label) in [(0.05, "5 %"), (0.5, "median"), (0.95, "95 %")] {
            panel = panel.mark(Rule::x(sorted[((share * n as f64) as usize).min(n - 1)], label));
        }
        if let Some(x) = own.get(name.as_str()) {
            panel = panel.mark(Rule::x(*x, "machine"));
        }
        let alike = chosen.iter().filter(|&&j| j > i && study.show.is_empty() && proportional(&samples.values[i], &samples.values[j]));
        let alt = named("uncertainty-alt-distribution").arg("samples", Arg::count(n));
        let alt = alt.arg("low", Arg::quantity(low, unit)).arg("high", Arg::quantity(high, unit));
        let room = 0.06 * (high - low);
        let x = Axis::new(readable(name), unit).range(low - room, high + room);
        let title = named("uncertainty-title-distribution").arg("samples", Arg::count(n)).arg("alike", Arg::count(alike.count()));
        outcome = outcome.figure(Figure::new(format!("distribution-{name}"), title, alt).x(x).panel(panel));
    }
    Ok(outcome)
}

/// A number in words: `critical speed order 1 forward`.
fn readable(name: &str) -> Arg {
    Arg::term(name.replace('_', " "))
}

/// Both rise and fall together in a straight line, as far as a picture shows.
fn proportional(a: &[f64], b: &[f64]) -> bool {
    let both = || a.iter().zip(b).filter(|(x, y)| x.is_finite() && y.is_finite());
    let n = both().count() as f64;
    let mean = both().fold((0.0, 0.0), |m, (x, y)| (m.0 + x / n, m.1 + y / n));
    let sums = both().fold((0.0, 0.0, 0.0), |s, (x, y)| {
        let (u, v) = (x - mean.0, y - mean.1);
        (s.0 + u * v, s.1 + u * u, s.2 + v * v)
    });
    n > 2.0 && sums.0.abs() > SAME_SHAPE * (sums.1 * sums.2).sqrt() && sums.1 > 0.0 && sums.2 > 0.0
}

/// Edges and densities of a histogram: width by Freedman and Diaconis (1981), 5 to 60 bars.
fn histogram(sorted: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let n = sorted.len();
    let (low, high) = (sorted[0], sorted[n - 1]);
    let quartiles = sorted[(3 * n / 4).min(n - 1)] - sorted[n / 4];
    let wanted = (high - low) / (2.0 * quartiles) * (n as f64).cbrt();
    let bars = if wanted.is_finite() { (wanted.ceil() as usize).clamp(5, 60) } else { 5 };
    let width = (high - low) / bars as f64;
    let mut count = vec![0usize; bars];
    for x in sorted {
        count[(((x - low) / width) as usize).min(bars - 1)] += 1;
    }
    let edges = (0..=bars).map(|b| low + b as f64 * width).collect();
    (edges, count.iter().map(|&c| c as f64 / (n as f64 * width)).collect())
}

/// Values of one kind of bar for one number, from the top parameter down.
struct Bars {
    /// Key of the title, which names the number.
    title: &'static str,
    axis: Axis,
    kinds: Vec<(&'static str, Vec<Interval>)>,
}

/// A horizontal bar per parameter and kind, with the confidence interval as a line.
fn bars(mut outcome: Outcome, study: &Uncertainty, name: &str, what: &str, bars: Bars) -> Result<Outcome, Diagnostic> {
    let k = study.parameters.len();
    let each = 0.8 / bars.kinds.len() as f64;
    // of most influence on top
    let mut order: Vec<usize> = (0..k).collect();
    let size = |p: usize| bars.kinds[0].1[p].value;
    order.sort_by(|&a, &b| size(b).partial_cmp(&size(a)).unwrap_or_else(|| size(a).is_nan().cmp(&size(b).is_nan())));
    let names = order.iter().enumerate().map(|(row, &p)| ((k - row) as f64, parameter_name(&study.parameters[p].path))).collect();
    let mut panel = Panel::new(Axis::new("parameter", "").range(0.4, k as f64 + 0.6).names(names));
    for (j, (kind, values)) in bars.kinds.iter().enumerate() {
        let (mut x, mut low, mut high) = (Vec::new(), Vec::new(), Vec::new());
        let (mut at, mut centre) = (Vec::new(), Vec::new());
        for (row, v) in order.iter().map(|&p| &values[p]).enumerate() {
            let top = (k - row) as f64 + 0.4 - j as f64 * each;
            x.extend([0.0, v.value, f64::NAN]);
            low.extend([top - each; 3]);
            high.extend([top; 3]);
            at.extend([v.low, v.high, f64::NAN]);
            centre.extend([top - 0.5 * each; 3]);
        }
        let table = format!("{what} {name} {kind}");
        let doc = Message::new("uncertainty-table-bars").arg("kind", *kind).arg("quantity", readable(name));
        let shape = Table::new(&table, doc)
            .float("x", "", "foot and end of a bar; NaN between bars and where there is none", x)
            .float("low", "", "lower side", low)
            .float("high", "", "upper side", high)
            .float("interval", "", "ends of the confidence interval; NaN between them and where there is none", at)
            .float("centre", "", "middle of the bar", centre)
            .build()
            .map_err(inconsistent)?;
        let band = Band::between(&table, "x", "low", "high").name(*kind).bar();
        panel = panel
            .mark(if j == 0 { band.neutral() } else { band.good() })
            .mark(Line::new(&table, "interval", "centre").name("95 % interval").ink());
        outcome = outcome.table(shape);
    }
    let title = Message::new(bars.title).arg("quantity", readable(name));
    let alt = Message::new("uncertainty-alt-bars").arg("quantity", readable(name)).arg("parameters", Arg::count(k));
    let figure = Figure::new(format!("{what}-{name}"), title, alt).x(bars.axis).panel(panel);
    Ok(outcome.figure(figure))
}

pub fn indices(mut outcome: Outcome, study: &Uncertainty, samples: &Samples, found: &[Option<Shares>]) -> Result<Outcome, Diagnostic> {
    let mut drawn: Vec<usize> = Vec::new();
    for i in shown(study, samples) {
        let Some(Shares { each: list, .. }) = &found[i] else { continue };
        if study.show.is_empty() && drawn.iter().any(|&j| proportional(&samples.values[i], &samples.values[j])) {
            continue;
        }
        drawn.push(i);
        let kinds =
            vec![("total", list.iter().map(|x| x.total).collect()), ("first order", list.iter().map(|x| x.first).collect::<Vec<_>>())];
        let n = study.sorted(&samples.values[i]).len();
        let rough = Arg::word(if n < ROUGH { "yes" } else { "no" });
        let label = Message::new("uncertainty-share-of-variance").arg("samples", Arg::count(n)).arg("rough", rough);
        let shape = Bars { title: "uncertainty-title-indices", axis: Axis::new(label, "").range(0.0, 1.0), kinds };
        outcome = bars(outcome, study, &samples.names[i].0, "indices", shape)?;
    }
    Ok(outcome)
}

pub fn effects(mut outcome: Outcome, study: &Uncertainty, samples: &Samples, found: &[Vec<Effects>]) -> Result<Outcome, Diagnostic> {
    for i in shown(study, samples) {
        let (name, unit) = &samples.names[i];
        if found[i].iter().all(|e| e.count == 0) {
            continue;
        }
        let list: Vec<Interval> = found[i].iter().map(|e| e.mu_star).collect();
        let shape =
            Bars { title: "uncertainty-title-effects", axis: Axis::new("mean size of the effects", unit), kinds: vec![("mu*", list)] };
        outcome = bars(outcome, study, name, "effects", shape)?;
    }
    Ok(outcome)
}
