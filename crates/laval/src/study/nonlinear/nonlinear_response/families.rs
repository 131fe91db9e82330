//! What is said of states beside the main branches, and of a branch that does not close.

use super::tables::label;
use crate::outcome::{Finding, quantity, significant};
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Cut, Response, Traced};
use crate::solve::harmonic::branches::unclosed::{Beyond, REACH, Unclosed};
use crate::study::shared::support::largest;

/// That the branch of large motions goes on beyond the range, and whether it would ever turn back.
pub(super) fn unclosed(u: &Unclosed) -> Finding {
    let speed = significant(u.speed.abs(), 5);
    let share = significant(100.0 * u.share, 4);
    let verdict = match u.beyond {
        Beyond::Closes(at) => {
            format!("Followed on, it turns back at {} rad/s: there these states end in a jump.", significant(at.abs(), 5))
        }
        Beyond::Tends(limit) if limit < 1.0 => format!(
            "Damping takes {share} % of the power the unbalance can give there, and {} % at ever higher speed: below 100 % these states never end in a jump.",
            significant(100.0 * limit, 4)
        ),
        Beyond::Tends(_) => format!(
            "Damping takes {share} % of the power the unbalance can give there and more at ever higher speed: the states end in a jump where it takes all, \
             beyond {REACH} times this speed.",
        ),
        Beyond::Lost(at) => format!(
            "Damping takes {share} % of the power the unbalance can give there; where it takes all the states end in a jump. Beyond the range the branch \
             could be followed to {} rad/s only.",
            significant(at.abs(), 5)
        ),
    };
    let text = format!(
        "The branch of large motions does not close in the range: at {speed} rad/s its amplitude, {{}}, still grows with the speed, beside {} on the \
         branch of small motions. The end of the range is no jump. {verdict}",
        quantity(u.low_amplitude, "m"),
    );
    let finding = Finding::warning("branch_not_closed", text).value(u.amplitude, "m");
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

/// What the search for all states found.
pub(super) fn all(response: &Response) -> Vec<Finding> {
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
        let stable = if low <= high {
            format!("some of them stable, between {} and {} rad/s", significant(low, 5), significant(high, 5))
        } else {
            "none of them stable".into()
        };
        let images = branches.iter().map(|b| b.images).max().unwrap_or(1);
        let turned = match (images, branches.iter().map(|b| b.turns()).max().unwrap_or(1)) {
            (1, _) => String::new(),
            (n, 1) => format!(" A branch stands for up to {n}, turned against each other by the symmetry of the machine."),
            (n, _) => {
                format!(" Each stands for up to {n} states: turned by the symmetry of the machine, and later by a turn of the rotor.")
            }
        };
        let text = format!(
            "Further states ({kind}) exist from {{}} to {} rad/s on {} branch{}, {stable}.{turned}",
            significant(to, 6),
            branches.len(),
            if branches.len() == 1 { "" } else { "es" },
        );
        let worst = largest(points().map(|p| p.truncation));
        out.push(Finding::info("further_states", text).of(*kind).value(from, "rad/s").evidence(
            "dropped over kept force harmonics, worst point",
            worst,
            "",
        ));
    }
    if let Some(cut) = &response.cut {
        out.push(stopped(cut, kinds.is_empty()));
    } else if kinds.is_empty() && !response.more_families {
        out.push(Finding::info(
            "further_states",
            "No states beside those from the ends of the range were found: neither by combining the planes of known states, nor from subharmonic starts, \
             nor from starts taken anywhere. The search does not exclude that there are some.",
        ));
    }
    if response.more_families {
        let text = "Not all families of states were followed: narrow the range of speeds to see those left out.";
        out.push(Finding::warning("families_left_out", text));
    }
    out
}

/// A search that is not complete shows no absence.
fn stopped(cut: &Cut, none: bool) -> Finding {
    if cut.speeds.1 == 0 {
        let text = "The search for further states was not begun: the branches from the ends of the range were stopped, or took all points allowed. Whether \
                    there are such states is not known.";
        return Finding::info("further_states_unknown", text);
    }
    let of = |(made, all): (usize, usize)| format!("{made} of {all}");
    let in_time = if cut.in_time.1 > 0 { format!(" and {} starts in time", of(cut.in_time)) } else { String::new() };
    let text = format!(
        "The search for further states is not complete: it was done at {} speeds, and {} starts of any size and phase{in_time} were made. Whether there \
         are {} is not known.",
        of(cut.speeds),
        of(cut.starts),
        if none { "such states" } else { "more of them" },
    );
    Finding::info("further_states_unknown", text)
}
