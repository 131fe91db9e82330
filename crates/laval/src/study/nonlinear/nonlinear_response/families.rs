//! Findings about states beside the main branches, and about a branch that does not close.

use super::tables::label;
use crate::outcome::{Arg, Finding, Message};
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Cut, Response, Traced};
use crate::solve::harmonic::branches::unclosed::{Beyond, REACH, Unclosed};
use crate::study::shared::support::largest;

/// That the branch of large motions goes on beyond the range, and whether it would ever turn back.
pub(super) fn unclosed(u: &Unclosed) -> Finding {
    let beyond = |word| Message::new("nonlinear-response-beyond").arg("beyond", Arg::word(word)).arg("share", Arg::percent(u.share));
    let verdict = match u.beyond {
        Beyond::Closes(at) => beyond("closes").arg("at", Arg::speed(at.abs())),
        Beyond::Tends(limit) if limit < 1.0 => beyond("stays").arg("limit", Arg::percent(limit)),
        Beyond::Tends(limit) if limit >= 1.0 => beyond("rises").arg("reach", Arg::number(REACH)),
        Beyond::Tends(_) => beyond("unknown"),
        Beyond::Lost(at) => beyond("lost").arg("at", Arg::speed(at.abs())),
    };
    let mut finding = Finding::warning("branch_not_closed", "nonlinear-response-not-closed")
        .value(u.amplitude, "m")
        .arg("speed", Arg::speed(u.speed.abs()))
        .arg("lower", Arg::quantity(u.low_amplitude, "m"));
    finding.notes.push(verdict);
    let finding = finding.evidence("share of the power of the unbalance at the end of the range", u.share, "").evidence(
        "d ln amplitude / d ln speed",
        u.rise,
        "",
    );
    match u.beyond {
        Beyond::Closes(at) => finding.evidence("speed where it turns back", at, "rad/s"),
        Beyond::Tends(limit) => finding.evidence("share at ever higher speed (1 and more: the branch closes)", limit, ""),
        Beyond::Lost(_) => finding,
    }
}

/// What the search for all states found, with this number of random starts.
pub(super) fn all(response: &Response, starts: usize) -> Vec<Finding> {
    let mut out = Vec::new();
    let mut kinds: Vec<(&str, Vec<&Traced>)> = Vec::new();
    for branch in response.branches.iter().filter(|b| !matches!(b.origin, Origin::Low | Origin::High)) {
        let kind = label(branch);
        match kinds.iter_mut().find(|k| k.0 == kind) {
            Some(k) => k.1.push(branch),
            None => kinds.push((kind, vec![branch])),
        }
    }
    for (kind, branches) in &kinds {
        let points = || branches.iter().flat_map(|b| &b.points);
        let range = |held: bool| {
            let speeds = points().filter(|p| !held || p.stable()).map(|p| p.speed);
            speeds.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), w| (l.min(w), h.max(w)))
        };
        let ((from, to), (low, high)) = (range(false), range(true));
        let stability = match points().all(|p| p.exponents.is_some()) {
            _ if low <= high => "some",
            true => "none",
            false => "unknown",
        };
        let images = branches.iter().map(|b| b.images).max().unwrap_or(1);
        let turns = branches.iter().map(|b| b.turns()).max().unwrap_or(1);
        let copies = Message::new("nonlinear-response-copies").arg("copies", Arg::count(images));
        let copies = copies.arg("kind", Arg::word(if turns == 1 { "turned" } else { "later" }));
        let worst = largest(points().map(|p| p.truncation));
        let mut finding = Finding::info("further_states", "nonlinear-response-further-states")
            .of(*kind)
            .value(from, "rad/s")
            .arg("kind", Arg::term(*kind))
            .arg("branches", Arg::count(branches.len()))
            .arg("to", Arg::speed(to))
            .arg("stability", Arg::word(stability))
            .evidence("dropped over kept force harmonics, worst point", worst, "");
        if low <= high {
            finding = finding.arg("low", Arg::speed(low)).arg("high", Arg::speed(high));
        }
        finding.notes.extend((images > 1).then_some(copies));
        out.push(finding);
    }
    if let Some(cut) = &response.cut {
        out.push(stopped(cut));
    } else if kinds.is_empty() && !response.more_families {
        out.push(Finding::info("further_states", "nonlinear-response-no-further-states").arg("starts", Arg::count(starts)));
    }
    if response.more_families {
        out.push(Finding::warning("families_left_out", "nonlinear-response-families-left-out"));
    }
    out
}

/// A search that is not complete shows no absence.
fn stopped(cut: &Cut) -> Finding {
    if cut.speeds.1 == 0 {
        return Finding::info("further_states_unknown", "nonlinear-response-search-not-begun");
    }
    let mut finding = Finding::info("further_states_unknown", "nonlinear-response-search-stopped")
        .arg("speeds", Arg::count(cut.speeds.0))
        .arg("all-speeds", Arg::count(cut.speeds.1))
        .arg("starts", Arg::count(cut.starts.0))
        .arg("all-starts", Arg::count(cut.starts.1));
    let in_time = Message::new("nonlinear-response-search-in-time");
    let in_time = in_time.arg("starts", Arg::count(cut.in_time.0)).arg("all-starts", Arg::count(cut.in_time.1));
    finding.notes.extend((cut.in_time.1 > 0).then_some(in_time));
    finding
}
