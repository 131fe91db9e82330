//! Machines with parts in a table over the frequency of vibration, in linear studies.
//!
//! At a critical speed of order k the frequency of the mode is k times the speed W: its coefficients are those of k W, and it is a critical speed of the machine that has
//! these at every frequency, an ordinary one. So is the response to a force of order k. Modes have the coefficients of their own frequency ([`own_frequency`]).
//!
//! [`own_frequency`]: crate::solve::own_frequency

use super::campbell::follow;
use super::numbering;
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::part::{Beyond, Frozen};
use crate::model::system::System;
use crate::outcome::{Arg, End, Finding};
use crate::solve::criticals::{Critical, criticals};
use crate::solve::extrema::above;
use crate::solve::own_frequency::OwnModes;
use crate::solve::own_frequency::follow::Followed;
use crate::solve::rest::over_speed;
use crate::solve::sweep::{Branch, Count};
use crate::study::Context;
use crate::study::shared::support::held;
use laval_num::complex::c as c64;
use serde::{Deserialize, Serialize};

/// A part has a table over the frequency of vibration.
pub(in crate::study) fn over_frequency(system: &System) -> bool {
    system.over_frequency().next().is_some()
}

/// Critical speeds of some orders, each of the machine with the coefficients of that order.
pub(super) struct Crossings {
    /// By order, then speed.
    pub crossings: Vec<Critical>,
    /// Speeds whose spectra were followed.
    pub spectra: u64,
    /// Of a large machine the speeds at which roots were counted.
    pub counts: Vec<Count>,
    /// How the work ended.
    pub end: End,
}

/// Finds them among the speeds of a range.
///
/// # Errors
/// As the spectrum.
pub(super) fn crossings(system: &System, context: &Context, range: &RangeValue, orders: &[f64]) -> Result<Crossings, Diagnostic> {
    let state = over_speed(system);
    let mut out = Crossings { crossings: Vec::new(), spectra: 0, counts: Vec::new(), end: End::Reached };
    for &order in orders {
        let Some(own) = held(system, Frozen::Order(order))? else { continue };
        // where the tables reach
        let refusing = || system.over_frequency().map(|t| t.1).filter(|t| t.beyond == Beyond::Refuse);
        let from = refusing().map(|t| t.from / order).fold(range.from, f64::max);
        let to = refusing().map(|t| t.to / order).fold(range.to, f64::min);
        if to <= from {
            continue;
        }
        let inside = RangeValue { from, to, ..*range };
        let (mut found, end) = follow(&own, context, &inside.linspace(120), above(order * to))?;
        numbering::in_order(&mut found.branches, numbering::reference(system, range));
        out.crossings.extend(criticals(&own, &state, &found, &[order]));
        out.spectra += found.points.len() as u64;
        out.counts.extend(found.counts);
        if end != End::Reached {
            out.end = end;
            break;
        }
    }
    Ok(out)
}

/// Gives critical speeds the numbers of modes that were followed: of the one whose frequency and growth are nearest there.
pub(super) fn number(crossings: &mut [Critical], branches: &[Branch]) {
    for c in crossings {
        let s = c64(c.growth, c.order * c.speed.abs());
        let value = |b: &Branch| {
            let k = b.points.partition_point(|p| p.0 < c.speed).clamp(1, b.points.len().max(2) - 1);
            let (a, b) = (b.points.get(k - 1)?, b.points.get(k)?);
            let share = (c.speed - a.0) / (b.0 - a.0);
            (0.0..=1.0).contains(&share).then(|| a.1.value + (b.1.value - a.1.value).scale(share))
        };
        let distance = |b: &Branch| value(b).map_or(f64::INFINITY, |v| (v - s).abs());
        let near = (0..branches.len()).min_by(|&a, &b| distance(&branches[a]).total_cmp(&distance(&branches[b])));
        c.branch = near.unwrap_or(c.branch);
    }
}

/// That growth is not assessed with the coefficients of the excitation.
pub(super) fn growth_unassessed(system: &System) -> Option<Finding> {
    let names: Vec<&str> = system.over_frequency().map(|(s, _)| s.name.as_str()).collect();
    let finding = Finding::info("growth_unassessed", "over-frequency-growth-unassessed");
    (!names.is_empty()).then(|| finding.arg("n", Arg::count(names.len())).arg("parts", Arg::names(names)))
}

/// What was searched for modes with the coefficients of their own frequency.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Searched {
    /// Frequencies, rad/s.
    pub range: (f64, f64),
    /// Modes below it, with the coefficients of its beginning.
    pub below: usize,
    /// Modes above it, with those of its end.
    pub above: usize,
    /// Largest distance of a frequency from that of its coefficients, over the mode.
    pub residual: f64,
    /// Speeds searched, and those at which a mode is missing.
    pub speeds: usize,
    /// See `speeds`.
    pub open: usize,
}

impl Searched {
    /// At one speed.
    pub fn at_one(own: &OwnModes) -> Self {
        let residual = own.modes.iter().map(|m| m.residual).fold(0.0, f64::max);
        Searched { range: own.range, below: own.below, above: own.above, residual, speeds: 1, open: usize::from(!own.counted()) }
    }
    /// Along the speed.
    pub fn along(found: &Followed) -> Self {
        let (speeds, open) = (found.sweep.points.len(), found.open.len());
        Searched { range: found.range, below: found.below, above: found.above, residual: found.residual, speeds, open }
    }
}

/// Whether any mode is missing, and what lies outside the frequencies searched.
pub(super) fn own_findings(system: &System, own: &Searched) -> Vec<Finding> {
    let names: Vec<&str> = system.over_frequency().map(|(s, _)| s.name.as_str()).collect();
    let ((from, to), residual) = (own.range, own.residual);
    let finding = match own.open {
        0 => Finding::info("own_frequency", "over-frequency-counted"),
        open => Finding::warning("own_frequency_missed", "over-frequency-not-counted").arg("open", Arg::count(open)),
    };
    let finding = finding.arg("speeds", Arg::count(own.speeds)).arg("from", Arg::frequency(from)).arg("to", Arg::frequency(to));
    let finding = finding.arg("n", Arg::count(names.len())).arg("parts", Arg::names(names));
    let mut out = vec![finding.evidence("largest relative distance of a frequency from that of its coefficients", residual, "")];
    if own.below + own.above > 0 {
        let finding = Finding::info("outside_frequencies", "over-frequency-outside");
        let sides = match (own.below > 0, own.above > 0) {
            (true, true) => "both",
            (true, false) => "below",
            _ => "above",
        };
        let finding = finding.arg("sides", Arg::word(sides)).arg("from", Arg::frequency(from)).arg("to", Arg::frequency(to));
        let finding = finding.evidence("modes below, with the coefficients of the lowest frequency", own.below as f64, "");
        out.push(finding.evidence("modes above, with the coefficients of the highest frequency", own.above as f64, ""));
    }
    out
}

/// Marks findings about modes whose frequency lies outside a table.
pub(super) fn mark(system: &System, modes: &[(usize, f64)], findings: &mut Vec<Finding>) {
    for (slot, t) in system.over_frequency() {
        let outside: Vec<usize> =
            modes.iter().filter(|(_, f)| *f < t.from * (1.0 - 1e-9) || *f > t.to * (1.0 + 1e-9)).map(|m| m.0).collect();
        if outside.is_empty() {
            continue;
        }
        let finding = Finding::invalid("beyond_frequencies", "over-frequency-beyond").of(&slot.name).arg("part", Arg::name(&slot.name));
        let finding = finding.arg("from", Arg::frequency(t.from)).arg("to", Arg::frequency(t.to)).arg("n", Arg::count(outside.len()));
        findings.insert(0, finding.arg("modes", Arg::List(outside.iter().map(|k| Arg::count(k + 1)).collect())));
    }
}
