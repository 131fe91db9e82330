//! Findings about roots of machines with parts that have no time form: where they were counted, whether any is missing, what no count can reach.

use super::support::inconsistent;
use crate::diagnostic::Diagnostic;
use crate::model::field::{Bounds, Field, FieldKind};
use crate::model::part::{Domain, Words};
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Message, Table};
use crate::solve::harmonic::balance::refused::among_waves;
use crate::solve::roots::{ACCUMULATION, Area, LEAST, Roots, has_more_modes};
use crate::solve::sweep::Count;

/// Field: largest frequency of the region in which roots are counted.
pub(in crate::study) const FREQUENCY_LIMIT: Field = Field::optional(
    "frequency_limit",
    FieldKind::Quantity { unit: "rad/s", bounds: Bounds::positive(1e7) },
    "",
    "largest frequency of the modes, of machines with parts that have no time form and of those with more than 160 states; when left out, 1.2 times the \
     larger of three times the speed and the highest frequency of the machine without those parts, or so high that twelve modes lie below, and three times the speed",
);

/// What was counted, and what could not be.
pub(in crate::study) fn findings(system: &System, speed: f64, roots: &Roots) -> Vec<Finding> {
    let mut out = Vec::new();
    let missing: i64 = roots.areas.iter().filter_map(|a| a.missing).filter(|n| *n > 0).sum();
    let open = roots.areas.iter().filter(|a| a.missing.is_none_or(|n| n < 0)).count();
    let found: usize = roots.areas.iter().map(|a| a.found).sum();
    let proven = roots.growing().is_some();
    let finding = if missing > 0 && proven {
        let name = system.domains(speed).into_iter().find(Domain::undamped).map_or(Words::PLAIN.name, |d| d.words.name);
        Finding::info("roots_missed", "region-slower-roots-missed").arg("missing", Arg::Count(missing as u64)).arg("part", Arg::term(name))
    } else if missing > 0 {
        Finding::warning("roots_missed", "region-roots-missed").arg("missing", Arg::Count(missing as u64))
    } else if open > 0 {
        let finding = Finding::warning("roots_not_counted", "region-roots-not-counted").arg("open", Arg::count(open));
        finding.arg("all", Arg::count(roots.areas.len())).arg("proven", Arg::word(if proven { "yes" } else { "no" }))
    } else {
        match has_more_modes(system) {
            true => Finding::info("all_modes", "region-all-modes").arg("states", Arg::count(2 * system.n() + system.m())),
            false => Finding::info("all_roots", "region-all-roots"),
        }
        .arg("found", Arg::count(found))
    };
    let root = match roots.margin {
        0.0 => Message::new("region-growing-root"),
        growth => Message::new("region-faster-root").arg("growth", Arg::quantity(growth, "1/s")),
    };
    let finding = finding.arg("root", root).arg("frequency", Arg::frequency(roots.frequency));
    out.push(finding.evidence("evaluations of the characteristic function", roots.evaluations as f64, ""));
    let outside = roots.counted.iter().filter(|c| !**c).count();
    if outside > 0 {
        let finding = Finding::info("uncounted_roots", "region-uncounted-roots").arg("outside", Arg::count(outside));
        out.push(finding.arg("all", Arg::count(roots.counted.len())));
    }
    if let Some(still) = roots.at_zero {
        let finding = Finding::info("rigid_body_motions", "region-at-zero").arg("count", Arg::count(still.count));
        out.push(finding.evidence("largest distance of these roots from zero", still.within, "1/s"));
    }
    out.extend(limits(&system.domains(speed), speed));
    out.extend(accumulation(&system.domains(speed), speed));
    out
}

/// Of a machine with more modes than are computed: whether all up to a frequency were followed over so many speeds.
pub(in crate::study) fn modes_followed(counts: &[Count], speeds: usize) -> Option<Finding> {
    let last = counts.last()?;
    let open = counts.iter().filter(|c| !c.complete).count();
    let finding = match open {
        0 => Finding::info("all_modes", "region-modes-followed").arg("speeds", Arg::count(counts.len())),
        _ => Finding::warning("modes_not_counted", "region-modes-not-counted").arg("open", Arg::count(open)),
    };
    Some(finding.arg("all", Arg::count(speeds)).arg("frequency", Arg::frequency(last.frequency)))
}

/// What the domain of the parts leaves out.
pub(in crate::study) fn limits(domains: &[Domain], speed: f64) -> Vec<Finding> {
    let mut out = Vec::new();
    if let Some(([a, b], words)) = domains.iter().find_map(|d| Some((d.dense?, d.words))) {
        out.push(
            Finding::info("dense_range", "region-dense-range")
                .arg("speed", Arg::speed(speed))
                .arg("from", Arg::frequency(a))
                .arg("to", Arg::frequency(b))
                .arg("waves", Arg::term(words.waves))
                .arg("part", Arg::term(words.name))
                .arg("loss", Arg::term(words.loss)),
        );
    }
    if let Some(d) = domains.iter().find(|d| !d.left) {
        out.push(Finding::info("half_plane", "region-half-plane").arg("part", Arg::term(d.words.name)));
    }
    out
}

/// Where waves accumulate, and slow roots are not counted.
pub(in crate::study) fn accumulation(domains: &[Domain], speed: f64) -> Option<Finding> {
    let e = domains.iter().find_map(|d| d.except.first())?;
    let half = ACCUMULATION * speed.abs();
    Some(
        Finding::info("accumulation", "region-accumulation")
            .arg("speed", Arg::speed(speed))
            .arg("from", Arg::frequency(e - half))
            .arg("to", Arg::frequency(e + half))
            .arg("growth", Arg::quantity(LEAST * speed.abs(), "1/s")),
    )
}

/// Orders that a sentence names; of more it says how many.
const NAMED: usize = 6;

/// That orders of a response, multiples of the speed with their direction of whirl, fall among the waves of a part, where it has no steady answer.
pub(in crate::study) fn dense_orders(system: &System, speed: f64, orders: &[f64]) -> Option<Finding> {
    let among = among_waves(system, speed, orders.iter().copied())?;
    let words = among.words;
    let mut named: Vec<Arg> = among.orders.iter().take(NAMED).map(|n| Arg::number(*n).digits(4)).collect();
    if among.orders.len() > NAMED {
        named.push(Message::new("region-other-orders").arg("n", Arg::count(among.orders.len() - NAMED)).into());
    }
    let finding = match among.dense {
        true => Finding::warning("inside_dense_range", "region-orders-without-response").arg("remedy", Arg::term(words.remedy)),
        false => Finding::warning("inside_dense_range", "region-orders-of-kept-waves").arg("kept", Arg::term(words.kept)),
    };
    let finding = finding
        .value(speed, "rad/s")
        .arg("n", Arg::count(among.orders.len()))
        .arg("orders", Arg::List(named))
        .arg("from", Arg::frequency(among.range[0]))
        .arg("to", Arg::frequency(among.range[1]))
        .arg("waves", Arg::term(words.waves))
        .arg("part", Arg::term(words.name));
    Some(among.orders.iter().take(NAMED).fold(finding, |f, n| f.evidence("order", *n, "")))
}

/// Rectangles with their counts.
pub(in crate::study) fn areas(roots: &Roots) -> Result<Table, Diagnostic> {
    let column = |f: fn(&Area) -> f64| roots.areas.iter().map(f).collect::<Vec<f64>>();
    Table::new("areas", "Rectangles in which roots were counted by the argument principle")
        .float("growth_from", "1/s", "lowest growth", column(|a| a.growth.0))
        .float("growth_to", "1/s", "highest growth", column(|a| a.growth.1))
        .float("frequency_from", "rad/s", "lowest frequency, below 0 against the spin", column(|a| a.frequency.0))
        .float("frequency_to", "rad/s", "highest frequency", column(|a| a.frequency.1))
        .int("roots", "", "roots found in it", roots.areas.iter().map(|a| a.found as i64).collect())
        .float(
            "missing",
            "",
            "roots the count has more; NaN where the phase could not be followed",
            column(|a| a.missing.map_or(f64::NAN, |n| n as f64)),
        )
        .flag("complete", "none is missing", roots.areas.iter().map(Area::complete).collect())
        .build()
        .map_err(inconsistent)
}
