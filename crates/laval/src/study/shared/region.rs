//! Roots of machines with parts that have no time form, in words: where they were counted, whether any is missing, what no count can reach.

use super::support::inconsistent;
use crate::diagnostic::Diagnostic;
use crate::model::field::{Bounds, Field, FieldKind};
use crate::model::part::{Domain, Words};
use crate::model::system::System;
use crate::outcome::{Finding, Table, quantity};
use crate::solve::harmonic::balance::refused::among_waves;
use crate::solve::roots::{ACCUMULATION, Area, LEAST, Roots};

/// Field: largest frequency of the region in which roots are counted.
pub(in crate::study) const FREQUENCY_LIMIT: Field = Field::optional(
    "frequency_limit",
    FieldKind::Quantity { unit: "rad/s", bounds: Bounds::positive(1e7) },
    "",
    "with parts that have no time form: roots with frequencies up to this are looked for; when left out, up to 1.2 times the larger of three times the \
     speed and the highest frequency of the machine without those parts",
);

/// What was counted, and what could not be.
pub(in crate::study) fn findings(system: &System, speed: f64, roots: &Roots) -> Vec<Finding> {
    let mut out = Vec::new();
    let missing: i64 = roots.areas.iter().filter_map(|a| a.missing).filter(|n| *n > 0).sum();
    let open = roots.areas.iter().filter(|a| a.missing.is_none_or(|n| n < 0)).count();
    let found: usize = roots.areas.iter().map(|a| a.found).sum();
    let (growth, frequency) = (quantity(roots.margin, "1/s"), quantity(roots.frequency, "rad/s"));
    let proven = roots.growing().is_some();
    let finding = if missing > 0 && proven {
        let name = system.domains(speed).into_iter().find(Domain::undamped).map_or(Words::PLAIN.name, |d| d.words.name);
        let others = if missing == 1 { "One slower root was".to_string() } else { format!("{missing} slower roots were") };
        let text = format!(
            "By the argument principle no root that grows faster than {growth} at frequencies up to {frequency} is missing. {others} counted and not computed: \
             waves of {name} that grow or decay slowly."
        );
        Finding::info("roots_missed", text)
    } else if missing > 0 {
        let others = if missing == 1 { "1 root that was".to_string() } else { format!("{missing} roots that were") };
        let text = format!(
            "The argument principle counts {others} not found, and one of them may grow faster than {growth}: stability is not established. A lower \
             frequency_limit or a growth_threshold above 0 makes the region smaller."
        );
        Finding::warning("roots_missed", text)
    } else if open > 0 {
        let text = format!(
            "In {open} of {} rectangles the phase of the characteristic function could not be followed, and roots may be missing there{}.",
            roots.areas.len(),
            if proven {
                format!("; of those that grow faster than {growth} none is missing")
            } else {
                ": stability is not established".into()
            }
        );
        Finding::warning("roots_not_counted", text)
    } else {
        let all = match found {
            0 => "there is no root in the rectangles of the table".to_string(),
            1 => "the root found in the rectangles of the table is the only one in them".to_string(),
            n => format!("the {n} roots found in the rectangles of the table are all there are in them"),
        };
        let text =
            format!("By the argument principle {all}: none that grows faster than {growth} at frequencies up to {frequency} is missed.");
        Finding::info("all_roots", text)
    };
    out.push(finding.evidence("evaluations of the characteristic function", roots.evaluations as f64, ""));
    let outside = roots.counted.iter().filter(|c| !**c).count();
    if outside > 0 {
        let text = format!(
            "{outside} of {} roots lie where no count reaches: they are roots, but there may be others beside them.",
            roots.counted.len()
        );
        out.push(Finding::info("uncounted_roots", text));
    }
    out.extend(limits(&system.domains(speed), speed));
    out.extend(accumulation(&system.domains(speed), speed));
    out
}

/// What the domain of the parts leaves out.
pub(in crate::study) fn limits(domains: &[Domain], speed: f64) -> Vec<Finding> {
    let mut out = Vec::new();
    if let Some(([a, b], Words { dense, .. })) = domains.iter().find_map(|d| Some((d.dense?, d.words))) {
        let text = format!(
            "At {} forward frequencies from {} to {} {dense}",
            quantity(speed, "rad/s"),
            quantity(a, "rad/s"),
            quantity(b, "rad/s")
        );
        out.push(Finding::info("dense_range", text));
    }
    if let Some(d) = domains.iter().find(|d| !d.left) {
        let text = format!(
            "Roots that decay are looked for where the response of the machine shows them, and from other starts, beside the branch of rates at which {} dies out; \
             the count is that of the roots that grow: of those that decay one that hardly shows in the response may be missing.",
            d.words.layer
        );
        out.push(Finding::info("half_plane", text));
    }
    out
}

/// Where waves accumulate, and slow roots are not counted.
pub(in crate::study) fn accumulation(domains: &[Domain], speed: f64) -> Option<Finding> {
    let e = domains.iter().find_map(|d| d.except.first())?;
    let (a, b) = (e - ACCUMULATION * speed.abs(), e + ACCUMULATION * speed.abs());
    let text = format!(
        "At {} waves accumulate at the speed: roots between {} and {} that grow or decay by less than {} are not counted.",
        quantity(speed, "rad/s"),
        quantity(a, "rad/s"),
        quantity(b, "rad/s"),
        quantity(LEAST * speed.abs(), "1/s")
    );
    Some(Finding::info("accumulation", text))
}

/// That orders of a response, multiples of the speed with their direction of whirl, fall among the waves of a part, where it has no steady answer.
pub(in crate::study) fn dense_orders(system: &System, speed: f64, orders: &[f64]) -> Option<Finding> {
    let among = among_waves(system, speed, orders.iter().copied())?;
    let [a, b] = among.range.map(|w| quantity(w, "rad/s"));
    let Words { name, waves, remedy, kept, .. } = among.words;
    let one = among.orders.len() == 1;
    let (which, lie, these) = if one { ("Order", "lies", "this order moves") } else { ("Orders", "lie", "these orders move") };
    let there = if among.dense {
        format!("there {name} has no steady response, and where {these} it the equations have no solution. {remedy}.")
    } else {
        format!("there {name} has no steady response; {kept}.")
    };
    let text = format!("{which} {} of the motion {lie} inside the dense range of {waves}, from {a} to {b} at {{}}: {there}", among.list());
    let finding = Finding::warning("inside_dense_range", text).value(speed, "rad/s");
    Some(among.orders.iter().take(6).fold(finding, |f, n| f.evidence("order", *n, "")))
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
