//! From samples to findings and tables.

use super::result::{Failure, Found, Samples, Shares, Spread, Statistics};
use super::{Design, Uncertainty, figures};
use crate::diagnostic::Diagnostic;
use crate::outcome::{End, Finding, Outcome, Table, TableBuilder, quantity};
use crate::study::Study;
use crate::study::shared::support::inconsistent;
use laval_num::sampling::morris::Effects;
use laval_num::sampling::quantile::Interval;
use laval_num::sampling::sobol_indices::Indices;
use std::collections::BTreeMap;

/// The outcome of all samples that are there.
pub fn report(study: &Uncertainty, found: &Found, end: End, name: &str) -> Result<Outcome, Diagnostic> {
    let samples = &found.samples;
    let mut outcome = Outcome::new(Uncertainty::KIND, name).end(end).work("runs of the study", samples.count as u64);
    let own: BTreeMap<&str, f64> = found.nominal.iter().map(|q| (q.label.as_str(), q.value)).collect();
    // what is missing is said before what was found
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
    outcome = outcome.table(table_of(study, samples)?);
    outcome.checked().map_err(inconsistent)
}

/// Every sample with its parameters and numbers.
fn table_of(study: &Uncertainty, samples: &Samples) -> Result<Table, Diagnostic> {
    let mut table = Table::new("samples", "Every run: values of the parameters and what was found").int(
        "sample",
        "",
        "number of the run",
        (0..samples.count as i64).collect(),
    );
    for (p, x) in study.parameters.iter().zip(&samples.parameters) {
        table = table.float(&p.path, p.unit, "parameter", x.clone());
    }
    for ((name, unit), v) in samples.names.iter().zip(&samples.values) {
        table = table.float(name, unit, "number found; NaN where it was not", v.clone());
    }
    table.build().map_err(inconsistent)
}

fn interval(table: TableBuilder, name: &str, unit: &str, doc: &str, all: &[Interval]) -> TableBuilder {
    let column = |f: fn(&Interval) -> f64| all.iter().map(f).collect();
    table
        .float(name, unit, format!("{doc}; NaN where there are no values"), column(|i| i.value))
        .float(
            format!("{name}_low"),
            unit,
            "lower end of the 95 % confidence interval; NaN where the samples are too few for one",
            column(|i| i.low),
        )
        .float(format!("{name}_high"), unit, "upper end; NaN where the samples are too few", column(|i| i.high))
}

/// Sentences at most; the tables have all.
const LEADING: usize = 4;

/// The first sentences, and where the numbers of the others are.
fn lead(mut outcome: Outcome, sentences: Vec<Finding>, table: &str) -> Outcome {
    let more = sentences.len().saturating_sub(LEADING);
    for s in sentences.into_iter().take(LEADING) {
        outcome = outcome.finding(s);
    }
    if more > 0 {
        let text = format!("{{}} more numbers were found; the table \"{table}\" has all.");
        outcome = outcome.finding(Finding::info("more_numbers", text).of(table).value(more as f64, ""));
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
    let mut said: Vec<usize> = (0..spreads.len()).collect();
    said.sort_by_key(|&k| !(spreads[k].deviation > 0.0));
    let mut sentences = Vec::new();
    for k in said {
        let ((name, unit), s) = (&samples.names[k], &spreads[k]);
        if s.count == 0 {
            continue;
        }
        // a sentence keeps the outer two; the table has all
        let ends: Vec<String> = [0, study.quantiles.len().saturating_sub(1)]
            .into_iter()
            .filter_map(|j| {
                Some(format!("{} % below {}", significant(100.0 * study.quantiles.get(j)?), quantity(s.quantiles[j].value, unit)))
            })
            .collect();
        let mut text = format!("{name}: mean {{}}");
        if s.deviation.is_finite() {
            text += &format!(", standard deviation {}", quantity(s.deviation, unit));
        }
        if s.deviation > 0.0 && ends.len() == 2 && ends[0] != ends[1] {
            text += &format!(", {}", ends.join(", "));
        }
        if s.count < succeeded {
            text += &format!("; found in {} of {succeeded} samples", s.count);
        }
        let mut finding = Finding::info("distribution", text + ".")
            .of(name)
            .value(s.mean.value, unit)
            .evidence("half width of the 95 % interval of the mean", s.mean.high - s.mean.value, unit)
            .evidence("standard deviation", s.deviation, unit)
            .evidence("share of the samples", s.share.value, "");
        for (p, q) in study.quantiles.iter().zip(&s.quantiles) {
            finding = finding.evidence(format!("{} % quantile", significant(100.0 * p)), q.value, unit);
        }
        sentences.push(finding);
    }
    outcome = lead(outcome, sentences, "quantities");
    if samples.names.is_empty() {
        outcome = outcome.finding(Finding::warning("no_numbers", "The study says nothing in numbers, so there is nothing to distribute."));
    }
    let names = || samples.names.iter().map(|n| n.0.clone()).collect::<Vec<_>>();
    let units = || samples.names.iter().map(|n| n.1.clone()).collect::<Vec<_>>();
    let table = Table::new("quantities", "Every number found: over the samples, in its own unit").text("quantity", "name", names()).text(
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
    outcome = outcome.table(table.build().map_err(inconsistent)?);

    let rows: Vec<(usize, usize)> = (0..spreads.len()).flat_map(|i| (0..study.quantiles.len()).map(move |j| (i, j))).collect();
    let table = Table::new("quantiles", "Values below which a share of the samples lies")
        .text("quantity", "name", rows.iter().map(|r| samples.names[r.0].0.clone()).collect())
        .text("unit", "unit of the numbers in this row", rows.iter().map(|r| samples.names[r.0].1.clone()).collect())
        .float("share", "", "share below", rows.iter().map(|r| study.quantiles[r.1]).collect());
    let all: Vec<Interval> = rows.iter().map(|r| spreads[r.0].quantiles[r.1]).collect();
    let table = interval(table, "value", "", "quantile", &all);
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    figures::distributions(outcome, study, samples, spreads, own)
}

fn significant(x: f64) -> String {
    crate::outcome::significant(x, 4)
}

/// Fewest base points, or trajectories, whose resampling gives a confidence interval of an index.
const LEAST: usize = 8;

/// An interval in a sentence.
fn ends(i: &Interval, unit: &str) -> String {
    format!("95 % interval {} to {}", quantity(i.low, unit), quantity(i.high, unit))
}

/// The sample is large enough for these indices: enough base points, intervals narrower than the range from 0 to 1 that both have, which meet it, and
/// a first-order index that may lie below the total one.
fn known(i: &Indices, used: usize) -> bool {
    let meets = |x: &Interval| x.high - x.low < 1.0 && x.low <= 1.0 && x.high >= 0.0;
    used >= LEAST && meets(&i.first) && meets(&i.total) && i.first.low <= i.total.high
}

/// The first names of a list, and how many more there are.
fn listed(names: &[&str]) -> String {
    let more = names.len().saturating_sub(LEADING);
    let list = names[..names.len() - more].join(", ");
    if more > 0 { format!("{list} and {more} more") } else { list }
}

fn sensitivity(mut outcome: Outcome, study: &Uncertainty, samples: &Samples, found: &[Option<Shares>]) -> Result<Outcome, Diagnostic> {
    let rows: Vec<(usize, usize, &Indices, usize)> = found
        .iter()
        .enumerate()
        .flat_map(|(q, f)| f.iter().flat_map(move |f| f.each.iter().enumerate().map(move |(p, i)| (q, p, i, f.used))))
        .collect();
    let (mut sentences, mut without, mut small) = (Vec::new(), Vec::new(), Vec::new());
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
            let indices = format!(
                "total index {{}} ({}), first-order index {} ({})",
                ends(&i.total, ""),
                significant(i.first.value),
                ends(&i.first, "")
            );
            let text = if rivals.is_empty() {
                format!("{name} depends most on {path}: {indices}.")
            } else {
                format!("In the samples {name} depends most on {path}: {indices}. Intervals overlap with {}.", rivals.join(", "))
            };
            sentences.push(
                Finding::info("most_influential", text)
                    .of(name)
                    .value(i.total.value, "")
                    .evidence("base points used", *used as f64, "")
                    .evidence("half width of its 95 % interval", 0.5 * (i.total.high - i.total.low), ""),
            );
        }
    }
    outcome = lead(outcome, sentences, "indices");
    if !without.is_empty() {
        let verb = if without.len() == 1 { "does not vary, or was" } else { "do not vary, or were" };
        let list = listed(&without);
        outcome = outcome.finding(Finding::info("no_indices", format!("{list} {verb} found too seldom: no sensitivity indices.")));
    }
    if let Some(used) = small.iter().map(|s| s.1).min() {
        let names: Vec<&str> = small.iter().map(|s| s.0).collect();
        let text = format!(
            "The sample, {{}} base points, is too small for the sensitivity indices of {}: the table \"indices\" has their 95 % intervals. Raise samples.",
            listed(&names)
        );
        outcome = outcome.finding(Finding::warning("no_indices", text).value(used as f64, ""));
    }
    let table = Table::new("indices", "Sensitivity indices of Sobol")
        .text("quantity", "name", rows.iter().map(|r| samples.names[r.0].0.clone()).collect())
        .text("parameter", "path", rows.iter().map(|r| study.parameters[r.1].path.clone()).collect());
    let column = |f: fn(&Indices) -> Interval| rows.iter().map(|r| f(r.2)).collect::<Vec<_>>();
    let table = interval(table, "first", "", "share of the variance due to this parameter alone", &column(|i| i.first));
    let table = interval(table, "total", "", "with its interactions", &column(|i| i.total)).int(
        "base_points",
        "",
        "base points used",
        rows.iter().map(|r| r.3 as i64).collect(),
    );
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    figures::indices(outcome, study, samples, found)
}

fn screening(mut outcome: Outcome, study: &Uncertainty, samples: &Samples, found: &[Vec<Effects>]) -> Result<Outcome, Diagnostic> {
    let mut sentences = Vec::new();
    for (list, (name, unit)) in found.iter().zip(&samples.names) {
        let known = list.iter().enumerate().filter(|(_, e)| e.count > 0);
        if let Some((p, e)) = known.max_by(|a, b| a.1.mu_star.value.total_cmp(&b.1.mu_star.value)) {
            let interval =
                if e.mu_star.low.is_finite() { ends(&e.mu_star, unit) } else { "the sample is too small for its interval".into() };
            let text = format!("{name} changes most with {}: mu* = {{}} ({interval}).", study.parameters[p].path);
            sentences.push(
                Finding::info("most_influential", text).of(name).value(e.mu_star.value, unit).evidence("sigma", e.sigma, unit).evidence(
                    "effects",
                    e.count as f64,
                    "",
                ),
            );
        }
    }
    outcome = lead(outcome, sentences, "effects");
    let rows: Vec<(usize, usize)> = (0..found.len()).flat_map(|q| (0..study.parameters.len()).map(move |p| (q, p))).collect();
    let at = |r: &(usize, usize)| found[r.0][r.1];
    let table = Table::new("effects", "Elementary effects of Morris, per unit of probability, in the unit of the number")
        .text("quantity", "name", rows.iter().map(|r| samples.names[r.0].0.clone()).collect())
        .text("unit", "unit of the numbers in this row", rows.iter().map(|r| samples.names[r.0].1.clone()).collect())
        .text("parameter", "path", rows.iter().map(|r| study.parameters[r.1].path.clone()).collect());
    let table = interval(table, "mu_star", "", "mean size", &rows.iter().map(|r| at(r).mu_star).collect::<Vec<_>>())
        .float("mu", "", "mean; NaN without effects", rows.iter().map(|r| at(r).mu).collect())
        .float(
            "sigma",
            "",
            "standard deviation: interaction or curvature; NaN below two effects",
            rows.iter().map(|r| at(r).sigma).collect(),
        )
        .int("count", "", "effects", rows.iter().map(|r| at(r).count as i64).collect());
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    figures::effects(outcome, study, samples, found)
}

fn failures(mut outcome: Outcome, samples: &Samples) -> Result<Outcome, Diagnostic> {
    let mut all: Vec<(&String, &Failure)> = samples.failures.iter().collect();
    all.sort_by(|a, b| b.1.count.cmp(&a.1.count).then(a.0.cmp(b.0)));
    for (cause, Failure { count, first, example }) in &all {
        let instance = if *count > 1 { format!(", for instance sample {first}") } else { String::new() };
        let text = format!("{{}} of {} samples have no result{instance}: {example}", samples.count);
        outcome = outcome.finding(Finding::warning("failed_samples", text).of(*cause).value(*count as f64, "").evidence(
            "first such sample",
            *first as f64,
            "",
        ));
    }
    if samples.invalid > 0 {
        let text = format!("In {{}} of {} samples a result lies outside the validity of a model.", samples.count);
        outcome = outcome.finding(Finding::invalid("outside_validity", text).value(samples.invalid as f64, ""));
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
        assert_eq!(listed(&["a", "b"]), "a, b");
        assert_eq!(listed(&["a", "b", "c", "d", "e", "f"]), "a, b, c, d and 2 more");
    }
}
