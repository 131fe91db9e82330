//! From samples to findings and tables.

use super::result::{Failure, Found, Samples, Shares, Spread, Statistics};
use super::{Design, Uncertainty, figures};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, End, Finding, Message, Outcome, Table, TableBuilder};
use crate::study::Study;
use crate::study::shared::support::inconsistent;
use laval_num::sampling::morris::Effects;
use laval_num::sampling::quantile::Interval;
use laval_num::sampling::sobol_indices::Indices;
use std::collections::BTreeMap;

/// The outcome of all samples that are there. They are moved into their table: of a million they are most of the memory.
pub fn report(study: &Uncertainty, found: Found, end: End, name: &str) -> Result<Outcome, Diagnostic> {
    let outcome = statistics(study, &found, end, name)?;
    with_samples(outcome, study, found.samples)
}

/// All but the table of samples.
fn statistics(study: &Uncertainty, found: &Found, end: End, name: &str) -> Result<Outcome, Diagnostic> {
    let samples = &found.samples;
    let mut outcome = Outcome::new(Uncertainty::KIND, name).end(end).work("runs of the study", samples.count as u64);
    let own: BTreeMap<&str, f64> = found.nominal.iter().map(|q| (q.label.as_str(), q.value)).collect();
    // what is missing comes before what was found
    outcome = failures(outcome, samples)?;
    match &found.statistics {
        Statistics::Effects(effects) => outcome = screening(outcome, study, samples, effects)?,
        Statistics::Spreads { spreads, drawn, succeeded } => {
            outcome = distributions(outcome, study, samples, &own, (spreads, *succeeded))?.work("independent samples", *drawn as u64);
        }
    }
    if matches!(study.design, Design::Sobol(_)) {
        outcome = sensitivity(outcome, study, samples, &found.indices)?;
    }
    if let Some(remark) = found.extent.remark() {
        outcome = outcome.finding(remark);
    }
    Ok(outcome)
}

/// Every sample with its parameters and numbers.
fn with_samples(outcome: Outcome, study: &Uncertainty, samples: Samples) -> Result<Outcome, Diagnostic> {
    let mut table = Table::new("samples", "Every run: values of the parameters and what was found").int(
        "sample",
        "",
        "number of the run",
        (0..samples.count as i64).collect(),
    );
    for (p, x) in study.parameters.iter().zip(samples.parameters) {
        table = table.float(&p.path, p.unit, "parameter", x);
    }
    for ((name, unit), v) in samples.names.iter().zip(samples.values) {
        table = table.float(name, unit, "number found; NaN where it was not", v);
    }
    outcome.table(table.build().map_err(inconsistent)?).checked().map_err(inconsistent)
}

fn interval(table: TableBuilder, name: &str, unit: &str, doc: &'static str, all: &[Interval]) -> TableBuilder {
    let column = |f: fn(&Interval) -> f64| all.iter().map(f).collect();
    table
        .float(name, unit, Arg::noted(doc, "NaN where there are no values"), column(|i| i.value))
        .float(
            format!("{name}_low"),
            unit,
            "lower end of the 95 % confidence interval; NaN where the samples are too few for one",
            column(|i| i.low),
        )
        .float(format!("{name}_high"), unit, "upper end; NaN where the samples are too few", column(|i| i.high))
}

/// Findings of one id at most, and names in a list; the tables have all.
const LEADING: usize = 4;

/// The first findings, and where the numbers of the others are.
fn lead(mut outcome: Outcome, findings: Vec<Finding>, table: &str) -> Outcome {
    let more = findings.len().saturating_sub(LEADING);
    for f in findings.into_iter().take(LEADING) {
        outcome = outcome.finding(f);
    }
    if more > 0 {
        let finding = Finding::info("more_numbers", "uncertainty-more-numbers").of(table).value(more as f64, "");
        outcome = outcome.finding(finding.arg("table", Arg::name(table)).arg("count", Arg::count(more)));
    }
    outcome
}

fn distributions(
    mut outcome: Outcome,
    study: &Uncertainty,
    samples: &Samples,
    own: &BTreeMap<&str, f64>,
    (spreads, succeeded): (&[Spread], usize),
) -> Result<Outcome, Diagnostic> {
    // what varies first
    let mut order: Vec<usize> = (0..spreads.len()).collect();
    order.sort_by_key(|&k| !(spreads[k].deviation > 0.0));
    let mut findings = Vec::new();
    for k in order {
        let ((name, unit), s) = (&samples.names[k], &spreads[k]);
        if s.count == 0 {
            continue;
        }
        let mut finding = Finding::info("distribution", "uncertainty-distribution")
            .of(name)
            .value(s.mean.value, unit)
            .arg("quantity", Arg::name(name))
            .arg("spread", Arg::word(if s.deviation.is_finite() { "known" } else { "none" }))
            .arg("found", Arg::word(if s.count < succeeded { "some" } else { "all" }))
            .arg("count", Arg::count(s.count))
            .arg("samples", Arg::count(succeeded));
        if s.deviation.is_finite() {
            finding = finding.arg("deviation", Arg::quantity(s.deviation, unit));
        }
        // a sentence keeps the outer two; the table has all
        let outer = s.deviation > 0.0 && study.quantiles.first() != study.quantiles.last();
        finding = finding.arg("quantiles", Arg::word(if outer { "outer" } else { "none" }));
        if outer {
            let last = study.quantiles.len() - 1;
            // shares beside 1 need their digits
            let share = |j: usize| Arg::percent(study.quantiles[j]).digits(6);
            let value = |j: usize| Arg::quantity(s.quantiles[j].value, unit);
            finding = finding.arg("lower", share(0)).arg("low", value(0)).arg("upper", share(last)).arg("high", value(last));
        }
        finding = finding
            .evidence("half width of the 95 % interval of the mean", s.mean.high - s.mean.value, unit)
            .evidence("standard deviation", s.deviation, unit)
            .evidence("share of the samples", s.share.value, "");
        for (p, q) in study.quantiles.iter().zip(&s.quantiles) {
            finding = finding.evidence(Message::new("uncertainty-quantile").arg("share", Arg::percent(*p).digits(6)), q.value, unit);
        }
        findings.push(finding);
    }
    outcome = lead(outcome, findings, "quantities");
    if samples.names.is_empty() {
        outcome = outcome.finding(Finding::warning("no_numbers", "uncertainty-no-numbers"));
    }
    let names = || samples.names.iter().map(|n| n.0.clone()).collect::<Vec<_>>();
    let units = || samples.names.iter().map(|n| n.1.clone()).collect::<Vec<_>>();
    let table = Table::new("quantities", "Every number found: over the samples, in its own unit").names("quantity", "name", names()).names(
        "unit",
        "unit of the numbers in this row",
        units(),
    );
    let table = table.float(
        "machine",
        "",
        "value of the machine as it is; NaN where that has none",
        samples.names.iter().map(|n| own.get(n.0.as_str()).copied().unwrap_or(f64::NAN)).collect(),
    );
    let table = interval(table, "mean", "", "mean", &spreads.iter().map(|s| s.mean).collect::<Vec<_>>())
        .float("deviation", "", "standard deviation; NaN below two values", spreads.iter().map(|s| s.deviation).collect())
        .float("smallest", "", "smallest value; NaN without values", spreads.iter().map(|s| s.smallest).collect())
        .float("largest", "", "largest value; NaN without values", spreads.iter().map(|s| s.largest).collect())
        .int("count", "", "samples in which it was found", spreads.iter().map(|s| s.count as i64).collect())
        .leading();
    let table = interval(table, "share", "", "share of the samples with a result", &spreads.iter().map(|s| s.share).collect::<Vec<_>>());
    let table = table.in_row_units(&["machine", "mean", "mean_low", "mean_high", "deviation", "smallest", "largest"]);
    outcome = outcome.table(table.build().map_err(inconsistent)?);

    let rows: Vec<(usize, usize)> = (0..spreads.len()).flat_map(|i| (0..study.quantiles.len()).map(move |j| (i, j))).collect();
    let table = Table::new("quantiles", "Values below which a share of the samples lies")
        .names("quantity", "name", rows.iter().map(|r| samples.names[r.0].0.clone()).collect())
        .names("unit", "unit of the numbers in this row", rows.iter().map(|r| samples.names[r.0].1.clone()).collect())
        .float("share", "", "share below", rows.iter().map(|r| study.quantiles[r.1]).collect());
    let all: Vec<Interval> = rows.iter().map(|r| spreads[r.0].quantiles[r.1]).collect();
    let table = interval(table, "value", "", "quantile", &all).in_row_units(&["value", "value_low", "value_high"]);
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    figures::distributions(outcome, study, samples, spreads, own)
}

/// Fewest base points, or trajectories, whose resampling gives a confidence interval of an index.
const LEAST: usize = 8;

/// Excess of a first-order index over the total one that three digits show.
const VISIBLE: f64 = 5e-4;

/// The sample is large enough for these indices: enough base points, intervals narrower than the range from 0 to 1 that both have, which meet it, and
/// a first-order index that may lie below the total one.
fn known(i: &Indices, used: usize) -> bool {
    let meets = |x: &Interval| x.high - x.low < 1.0 && x.low <= 1.0 && x.high >= 0.0;
    used >= LEAST && meets(&i.first) && meets(&i.total) && i.first.low <= i.total.high
}

/// The first-order index is not above the total one, of which it is a part.
fn resolved(i: &Indices) -> bool {
    i.first.value <= i.total.value + VISIBLE
}

/// The first names of a list, and how many more there are.
fn listed(names: &[&str]) -> Arg {
    let more = names.len().saturating_sub(LEADING);
    let mut list: Vec<Arg> = names[..names.len() - more].iter().map(|n| Arg::name(*n)).collect();
    if more > 0 {
        list.push(Message::new("uncertainty-more").arg("count", Arg::count(more)).into());
    }
    Arg::List(list)
}

/// Quantities with a first-order index above the total one, beside those whose sample is too small.
fn unresolved(names: &[(String, String)], found: &[Option<Shares>], small: &[(&str, usize)]) -> Option<Finding> {
    let excess = |s: &Shares| s.each.iter().filter(|i| !resolved(i)).map(|i| i.first.value - i.total.value).fold(0.0, f64::max);
    let all = names.iter().zip(found).filter_map(|(n, f)| Some((n.0.as_str(), excess(f.as_ref()?))));
    let own: Vec<(&str, f64)> = all.filter(|x| x.1 > 0.0 && !small.iter().any(|s| s.0 == x.0)).collect();
    let most = own.iter().map(|x| x.1).reduce(f64::max)?;
    let list: Vec<&str> = own.iter().map(|x| x.0).collect();
    let finding = Finding::warning("unresolved_indices", "uncertainty-unresolved-indices").value(most, "");
    Some(finding.arg("quantities", listed(&list)))
}

fn sensitivity(mut outcome: Outcome, study: &Uncertainty, samples: &Samples, found: &[Option<Shares>]) -> Result<Outcome, Diagnostic> {
    let rows: Vec<(usize, usize, &Indices, usize)> = found
        .iter()
        .enumerate()
        .flat_map(|(q, f)| f.iter().flat_map(move |f| f.each.iter().enumerate().map(move |(p, i)| (q, p, i, f.used))))
        .collect();
    let (mut findings, mut without, mut small) = (Vec::new(), Vec::new(), Vec::new());
    for (q, f) in found.iter().enumerate() {
        let name = &samples.names[q].0;
        let Some(Shares { each: list, used }) = f else {
            without.push(name.as_str());
            continue;
        };
        let most = list.iter().enumerate().max_by(|a, b| a.1.total.value.total_cmp(&b.1.total.value));
        if most.is_some_and(|(_, i)| !known(i, *used)) {
            small.push((name.as_str(), *used));
            continue;
        }
        if let Some((p, i)) = most {
            // the samples do not distinguish what their intervals share
            let rivals: Vec<&str> = list
                .iter()
                .enumerate()
                .filter(|(q, o)| *q != p && !(o.total.high < i.total.low))
                .map(|(q, _)| study.parameters[q].path.as_str())
                .collect();
            let path = &study.parameters[p].path;
            let key = if rivals.is_empty() { "uncertainty-most-influential" } else { "uncertainty-most-influential-overlap" };
            let mut finding = Finding::info("most_influential", key)
                .of(name)
                .value(i.total.value, "")
                .arg("quantity", Arg::name(name))
                .arg("parameter", Arg::name(path))
                .arg("low", Arg::number(i.total.low))
                .arg("high", Arg::number(i.total.high))
                .arg("rivals", Arg::names(rivals))
                .evidence("base points used", *used as f64, "")
                .evidence("half width of its 95 % interval", 0.5 * (i.total.high - i.total.low), "");
            if resolved(i) {
                finding = finding.evidence("first-order index", i.first.value, "").evidence(
                    "half width of the 95 % interval of the first-order index",
                    0.5 * (i.first.high - i.first.low),
                    "",
                );
            }
            findings.push(finding);
        }
    }
    outcome = lead(outcome, findings, "indices");
    if !without.is_empty() {
        let finding = Finding::info("no_indices", "uncertainty-no-indices").arg("quantities", listed(&without));
        outcome = outcome.finding(finding);
    }
    if let Some(used) = small.iter().map(|s| s.1).min() {
        let names: Vec<&str> = small.iter().map(|s| s.0).collect();
        let finding = Finding::warning("no_indices", "uncertainty-few-base-points").value(used as f64, "");
        outcome = outcome.finding(finding.arg("count", Arg::count(used)).arg("quantities", listed(&names)));
    }
    if let Some(finding) = unresolved(&samples.names, found, &small) {
        outcome = outcome.finding(finding);
    }
    let table = Table::new("indices", "Sensitivity indices of Sobol")
        .names("quantity", "name", rows.iter().map(|r| samples.names[r.0].0.clone()).collect())
        .names("parameter", "path", rows.iter().map(|r| study.parameters[r.1].path.clone()).collect());
    let column = |f: fn(&Indices) -> Interval| rows.iter().map(|r| f(r.2)).collect::<Vec<_>>();
    let table = interval(table, "first", "", "share of the variance due to this parameter alone", &column(|i| i.first));
    let table = interval(table, "total", "", "with its interactions", &column(|i| i.total)).int(
        "base_points",
        "",
        "base points used",
        rows.iter().map(|r| r.3 as i64).collect(),
    );
    let table = table.flag("resolved", "the first-order index is not above the total one", rows.iter().map(|r| resolved(r.2)).collect());
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    figures::indices(outcome, study, samples, found)
}

fn screening(mut outcome: Outcome, study: &Uncertainty, samples: &Samples, found: &[Vec<Effects>]) -> Result<Outcome, Diagnostic> {
    let mut findings = Vec::new();
    for (list, (name, unit)) in found.iter().zip(&samples.names) {
        let known = list.iter().enumerate().filter(|(_, e)| e.count > 0);
        if let Some((p, e)) = known.max_by(|a, b| a.1.mu_star.value.total_cmp(&b.1.mu_star.value)) {
            let known = e.mu_star.low.is_finite() && e.mu_star.high.is_finite();
            let key = if known { "uncertainty-largest-effect" } else { "uncertainty-largest-effect-few" };
            let mut finding = Finding::info("most_influential", key)
                .of(name)
                .value(e.mu_star.value, unit)
                .arg("quantity", Arg::name(name))
                .arg("parameter", Arg::name(&study.parameters[p].path))
                .evidence("sigma", e.sigma, unit)
                .evidence("effects", e.count as f64, "");
            if known {
                finding = finding.arg("low", Arg::quantity(e.mu_star.low, unit)).arg("high", Arg::quantity(e.mu_star.high, unit));
            }
            findings.push(finding);
        }
    }
    outcome = lead(outcome, findings, "effects");
    let rows: Vec<(usize, usize)> = (0..found.len()).flat_map(|q| (0..study.parameters.len()).map(move |p| (q, p))).collect();
    let at = |r: &(usize, usize)| found[r.0][r.1];
    let table = Table::new("effects", "Elementary effects of Morris, per unit of probability, in the unit of the number")
        .names("quantity", "name", rows.iter().map(|r| samples.names[r.0].0.clone()).collect())
        .names("unit", "unit of the numbers in this row", rows.iter().map(|r| samples.names[r.0].1.clone()).collect())
        .names("parameter", "path", rows.iter().map(|r| study.parameters[r.1].path.clone()).collect());
    let table = interval(table, "mu_star", "", "mean size", &rows.iter().map(|r| at(r).mu_star).collect::<Vec<_>>())
        .float("mu", "", "mean; NaN without effects", rows.iter().map(|r| at(r).mu).collect())
        .float(
            "sigma",
            "",
            "standard deviation: interaction or curvature; NaN below two effects",
            rows.iter().map(|r| at(r).sigma).collect(),
        )
        .int("count", "", "effects", rows.iter().map(|r| at(r).count as i64).collect())
        .in_row_units(&["mu_star", "mu_star_low", "mu_star_high", "mu", "sigma"]);
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    figures::effects(outcome, study, samples, found)
}

fn failures(mut outcome: Outcome, samples: &Samples) -> Result<Outcome, Diagnostic> {
    let mut all: Vec<(&String, &Failure)> = samples.failures.iter().collect();
    all.sort_by(|a, b| b.1.count.cmp(&a.1.count).then(a.0.cmp(b.0)));
    for (cause, Failure { count, first, example }) in &all {
        let finding = Finding::warning("failed_samples", "uncertainty-failed-samples")
            .of(*cause)
            .value(*count as f64, "")
            .arg("count", Arg::count(*count))
            .arg("samples", Arg::count(samples.count))
            .arg("first", Arg::count(*first))
            .arg("reason", Arg::term(example.trim_end_matches('.')))
            .evidence("first such sample", *first as f64, "");
        outcome = outcome.finding(finding);
    }
    if samples.invalid > 0 {
        let finding = Finding::invalid("outside_validity", "uncertainty-outside-validity").value(samples.invalid as f64, "");
        outcome = outcome.finding(finding.arg("count", Arg::count(samples.invalid)).arg("samples", Arg::count(samples.count)));
    }
    let table = Table::new("failures", "Samples without a result, by cause")
        .text("cause", "cause, without its numbers", all.iter().map(|f| f.0.clone()).collect())
        .int("count", "", "how many", all.iter().map(|f| f.1.count as i64).collect())
        .int("first", "", "first such sample", all.iter().map(|f| f.1.first as i64).collect())
        .text("example", "what it said", all.iter().map(|f| f.1.example.clone()).collect());
    Ok(outcome.table(table.build().map_err(inconsistent)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::Level;
    use crate::report::Style;

    /// Estimates beyond 0 and 1 are known where their intervals say how far, and not where these contradict the range, or fill it.
    #[test]
    fn indices_are_known_by_their_intervals() {
        let of = |value, low, high| Interval { value, low, high };
        for (first, total, is) in [
            (of(0.4, 0.3, 0.5), of(0.6, 0.5, 0.7), true),
            (of(1.01, 0.95, 1.07), of(1.02, 0.96, 1.08), true),
            (of(-0.02, -0.1, 0.06), of(0.1, 0.05, 0.2), true),
            (of(1.2, 1.05, 1.4), of(1.0, 0.8, 1.2), false),
            (of(-0.3, -0.5, -0.1), of(0.6, 0.5, 0.7), false),
            (of(0.8, 0.7, 0.9), of(0.5, 0.4, 0.6), false),
            (of(0.5, -0.4, 1.4), of(0.6, 0.5, 0.7), false),
            (of(0.5, f64::NAN, f64::NAN), of(0.6, 0.5, 0.7), false),
        ] {
            assert_eq!(known(&Indices { first, total }, LEAST), is, "{first:?} {total:?}");
            assert!(!known(&Indices { first, total }, LEAST - 1));
        }
        let text = |names: &[&str]| Style::default().arg(&listed(names));
        assert_eq!(text(&["a", "b"]), "a and b");
        assert_eq!(text(&["a", "b", "c", "d", "e", "f"]), "a, b, c, d and 2 more");
    }

    /// A first-order index is a part of the total one: above it, it is a sampling error.
    #[test]
    fn a_first_order_index_above_the_total_one_is_not_resolved() {
        let of = |value: f64| Interval { value, low: value - 0.1, high: value + 0.1 };
        let index = |first: f64, total: f64| Indices { first: of(first), total: of(total) };
        let shares = |each: Vec<Indices>| Some(Shares { each, used: 64 });
        let names: Vec<(String, String)> = ["a", "b", "c", "d"].map(|n| (n.to_string(), String::new())).to_vec();
        let found = [
            shares(vec![index(0.4, 0.6), index(0.2, 0.27)]),
            shares(vec![index(0.72, 0.68), index(0.31, 0.3)]),
            None,
            shares(vec![index(0.9, 0.5)]),
        ];
        let f = unresolved(&names, &found, &[("d", 4)]).unwrap();
        assert_eq!((f.id.as_str(), f.level), ("unresolved_indices", Level::Warning));
        assert!((f.value.unwrap() - 0.04).abs() < 1e-12, "{f:?}");
        let text = f.sentence();
        assert!(text.contains("of b are not resolved") && text.contains("Raise samples"), "{text}");
        assert_eq!(unresolved(&names[..1], &found[..1], &[]), None);
        // what three digits do not show is no contradiction
        assert_eq!(unresolved(&names[..1], &[shares(vec![index(0.9004, 0.9)])], &[]), None);
    }
}
