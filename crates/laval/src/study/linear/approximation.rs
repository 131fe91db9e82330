//! A machine whose parts have waves without number beside the same machine with parts in their place that have few: what the approximation gets right.
//!
//! Equations: both characteristic equations, `det T(s, W) = 0` of the machine and the eigenvalue problem of finite size that stands for it. Which waves are kept the part says
//! ([`approximation`](crate::model::capability::FrequencyDomain::approximation)).
//!
//! Symbols: W spin speed, rad/s; s = growth + i frequency.
//!
//! Validity: of the comparison that of both machines; roots of the approximation are held against the nearest root of the whole machine that was found.
//!
//! Theory: `docs/theory/approximate-methods.md#truncated-axial-waves`.
//!
//! Sources: `001_352384e7bf252e35` equation (37), corrected.

use crate::diagnostic::Diagnostic;
use crate::model::field::{Field, FieldKind, Values};
use crate::model::system::System;
use crate::outcome::{Axis, Figure, Finding, Line, Outcome, Panel, Points, Table, quantity, significant};
use crate::solve::pencil::{MachineMode, Spectrum};
use crate::solve::rest::rest;
use crate::solve::sweep::{Sweep, sweep};
use crate::study::Context;
use crate::study::shared::support::inconsistent;
use laval_num::complex::C64;

/// Field: what the roots are held against.
pub(in crate::study) const COMPARE: Field = Field::optional(
    "compare",
    FieldKind::Choice(&[
        ("nothing", "only the machine as it is"),
        (
            "approximation",
            "the machine with few waves in place of waves without number, of parts that have such a form: of a liquid in three dimensions planar_tilt",
        ),
    ]),
    "nothing",
    "what the roots are drawn beside",
);

/// From the field.
pub(in crate::study) fn wanted(values: &Values) -> bool {
    values.choice("compare") == Some("approximation")
}

/// The approximation can be made.
///
/// # Errors
/// A machine without parts that have one, and one whose approximation is refused.
pub(in crate::study) fn admit(system: &System) -> Result<System, Diagnostic> {
    let made = system.approximation().ok_or_else(|| {
        Diagnostic::error("study.compare", "no part of this machine has an approximation to be compared with")
            .help("parts with waves without number have one; leave compare out otherwise")
    })?;
    made.map_err(|d| {
        let why = d.0.first().map_or_else(String::new, |d| d.message.clone());
        Diagnostic::error("study.compare", format!("the approximation is no machine: {why}")).help("leave compare out")
    })
}

/// Branch, speed, mode of the approximation; its distance from the nearest root of the machine, and that root.
type Row<'a> = (usize, f64, &'a MachineMode, f64, C64);

/// How far a root of the approximation is from the nearest root of the machine that whirls alike.
fn apart(mode: &MachineMode, whole: &Spectrum) -> (f64, C64) {
    let signed = |m: &MachineMode| if m.forward_share < 0.5 { m.value.conj() } else { m.value };
    let own = signed(mode);
    let distance = |m: &MachineMode| (signed(m) - own).abs().min((signed(m).conj() - own).abs());
    let nearest = whole.modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map_or((f64::NAN, C64::zero()), |m| (distance(m), m.value))
}

/// Adds the roots of the approximation to those of the machine, as a table, a figure and findings.
///
/// # Errors
/// As [`admit`], and as the eigenvalue problem.
pub(in crate::study) fn add(outcome: Outcome, system: &System, whole: &Sweep, context: &Context) -> Result<Outcome, Diagnostic> {
    let other = admit(system)?;
    let speeds: Vec<f64> = whole.points.iter().map(|p| p.0).collect();
    let found = sweep(&other, &|w| rest(&other, w), &speeds, f64::INFINITY, |_, solved| context.goes_on(solved))?;
    let rows: Vec<Row> = found
        .branches
        .iter()
        .enumerate()
        .flat_map(|(k, b)| b.points.iter().map(move |(w, m)| (k, *w, m)))
        .filter_map(|(k, w, m)| {
            let spectrum = whole.points.iter().find(|p| p.0 == w)?;
            let (distance, nearest) = apart(m, &spectrum.1);
            Some((k, w, m, distance, nearest))
        })
        .collect();
    let column = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
    let table = Table::new("approximate_modes", "Modes of the approximation, each with the nearest root of the whole machine")
        .float("speed", "rad/s", "spin speed", column(&|r| r.1))
        .int("mode", "", "branch of the approximation", rows.iter().map(|r| r.0 as i64 + 1).collect())
        .text("whirl", "direction of whirl", rows.iter().map(|r| r.2.whirl.word().into()).collect())
        .float("frequency", "rad/s", "frequency", column(&|r| r.2.frequency()))
        .float("growth", "1/s", "growth rate", column(&|r| r.2.growth()))
        .float("whole_frequency", "rad/s", "frequency of the nearest root of the whole machine", column(&|r| r.4.im.abs()))
        .float("whole_growth", "1/s", "its growth rate", column(&|r| r.4.re))
        .float("distance", "1/s", "distance of the two in the plane of s", column(&|r| r.3))
        .build()
        .map_err(inconsistent)?;
    let degree = found.points.first().map_or(0, |p| p.1.modes.iter().map(|m| if m.value.im > 0.0 { 2 } else { 1 }).sum::<usize>());
    let mut outcome = outcome;
    // the mode that is best met, and the one that is worst
    let share = |k: usize| {
        let own = rows.iter().filter(|r| r.0 == k);
        own.map(|r| r.3 / r.2.value.abs()).fold(0.0f64, |m, x| if x > m || x.is_nan() { x } else { m })
    };
    let shares: Vec<(usize, f64)> = (0..found.branches.len()).map(|k| (k, share(k))).collect();
    let met = shares.iter().filter(|s| s.1 < 0.01).count();
    if let Some(r) = rows.iter().max_by(|a, b| (a.3 / a.2.value.abs()).total_cmp(&(b.3 / b.2.value.abs()))) {
        let text = format!(
            "The approximation is a polynomial of degree {degree}. {met} of its {} modes stay within 1 % of a root of the whole machine; the one farthest from any, at {}, has {} rad/s and grows \
             {} 1/s where the machine has {} rad/s and {} 1/s: {{}} of its size.",
            shares.len(),
            quantity(r.1, "rad/s"),
            significant(r.2.frequency(), 5),
            significant(r.2.growth(), 3),
            significant(r.4.im.abs(), 5),
            significant(r.4.re, 3),
        );
        outcome = outcome.finding(
            Finding::info("approximation", text).value(r.3 / r.2.value.abs(), "").evidence("degree", degree as f64, "").evidence(
                "modes within 1 %",
                met as f64,
                "",
            ),
        );
    }
    let largest = |s: &Sweep| {
        let all = s.points.iter().filter_map(|p| Some((p.0, p.1.least_stable()?.value.re)));
        all.max_by(|a, b| a.1.total_cmp(&b.1))
    };
    if let (Some(exact), Some(rough)) = (largest(whole), largest(&found)) {
        let text = format!(
            "Of the speeds computed the whole machine grows most at {}, {} 1/s, the approximation at {}, {} 1/s: a difference of {{}}.",
            quantity(exact.0, "rad/s"),
            significant(exact.1, 4),
            quantity(rough.0, "rad/s"),
            significant(rough.1, 4),
        );
        outcome = outcome.finding(Finding::info("approximate_growth", text).value(rough.1 - exact.1, "1/s"));
    }
    let top = 1.25 * speeds.iter().fold(0.0f64, |m, w| m.max(w.abs()));
    let frequency = Panel::new(Axis::new("frequency", "rad/s").range(0.0, top))
        .mark(Line::new("modes", "speed", "frequency").group("mode").reference())
        .mark(Points::new("approximate_modes", "speed", "frequency").name(format!("degree {degree}")));
    let growth = Panel::new(Axis::new("growth rate", "1/s"))
        .mark(Line::new("modes", "speed", "growth").group("mode").reference())
        .mark(Points::new("approximate_modes", "speed", "growth").name(format!("degree {degree}")));
    let alt = format!(
        "Grey lines: frequencies and growth rates of the machine over spin speed. Points: those of its approximation of degree {degree}."
    );
    let figure = Figure::new("approximation", "The whole machine and its approximation", alt)
        .x(Axis::new("spin speed", "rad/s"))
        .panel(frequency)
        .panel(growth);
    Ok(outcome.table(table).figure(figure))
}
