//! What is said of changes of stability, and of assessing it again by other methods.

use super::stretches::stretch_of;
use crate::outcome::{Finding, significant};
use crate::solve::harmonic::branches::agreement::{Agreement, TOLERANCE};
use crate::solve::harmonic::branches::bifurcation::{Change, Event};
use crate::solve::harmonic::branches::response::{Response, Traced};
use crate::study::shared::support::larger;

/// Changes listed one by one at most.
const MOST: usize = 6;

/// Every place where states that could be held cease to be stable, or become so, away from folds.
pub(super) fn changes(response: &Response) -> Vec<Finding> {
    let all = || response.branches.iter().flat_map(|b| b.changes.iter().map(move |c| (b, c)));
    let mut out: Vec<Finding> = all().filter_map(|(b, c)| change(b, c)).take(MOST).collect();
    let more = all().count() - out.len();
    if more > 0 {
        let text = format!("{more} more bifurcations are listed in the table, most of them of states that are unstable on both sides.");
        let text = if more == 1 { "One more bifurcation is listed in the table.".into() } else { text };
        out.push(Finding::info("more_bifurcations", text));
    }
    out
}

/// A change between two neighbouring states one of which is stable and one unstable, no fold between them.
fn change(branch: &Traced, c: &Change) -> Option<Finding> {
    let (a, b) = (branch.points.get(c.after)?, branch.points.get(c.after + 1)?);
    if a.stable() == b.stable() || a.unstable() == b.unstable() || branch.folds.iter().any(|f| f.after == c.after) {
        return None;
    }
    // along rising speed, whichever way the branch runs
    let rising = b.speed.abs() > a.speed.abs();
    let lost = a.stable() == rising;
    let what = match c.event {
        Event::NeimarkSacker => {
            let disturbance = if c.frequency.is_finite() {
                format!("a disturbance of {} rad/s, beside the spin,", significant(c.frequency, 5))
            } else {
                "a disturbance beside the spin".into()
            };
            format!("Neimark-Sacker: {disturbance} {}", if lost { "begins to grow" } else { "dies out above it" })
        }
        Event::PeriodDoubling => "period doubling: every other turn of the rotor begins to differ".into(),
        Event::SymmetryBreaking => "symmetry breaking: the orbit loses its symmetry, and less symmetric states branch off".into(),
        Event::BranchPoint => "branch point: other states cross".into(),
    };
    let way = if lost { "lose their stability" } else { "become stable" };
    let (from, to) = (c.bracket.0.min(c.bracket.1), c.bracket.0.max(c.bracket.1));
    let place =
        if c.located { "at {}".into() } else { format!("near {{}}, between {} and {} rad/s", significant(from, 5), significant(to, 5)) };
    let text = format!("With rising speed the states {} {way} {place} ({what}).", stretch_of(branch, c.after)?.words());
    let id = if lost { "stability_lost" } else { "stability_gained" };
    let finding = Finding::warning(id, text).of(c.event.name()).value(c.speed, "rad/s").evidence("growth rate there", c.growth, "1/s");
    let finding = if c.frequency.is_finite() { finding.evidence("frequency of the disturbance", c.frequency, "rad/s") } else { finding };
    Some(finding.evidence("width of the bracket", to - from, "rad/s"))
}

/// What the other methods say.
pub(super) fn checked(a: &Agreement) -> Finding {
    let text = match (a.contradictions, a.assessed) {
        (_, [0, 0]) => {
            let why = a.failed.clone().unwrap_or_else(|| "no state was assessed".into());
            return Finding::warning("stability_not_checked", format!("Stability could not be assessed a second time: {why}."));
        }
        (0, _) => format!(
            "Stability of {} states was assessed again by two methods that use no symmetry; growth rates differ by {{}} at most.",
            a.states
        ),
        (n, _) => format!(
            "Stability of {} states was assessed again by two methods that use no symmetry; {n} of them are called stable by one and unstable by another, \
             and growth rates differ by {{}}.",
            a.states
        ),
    };
    let worst = larger(a.difference[0], a.difference[1]);
    let finding =
        if a.contradictions == 0 { Finding::info("stability_checked", text) } else { Finding::warning("stability_contradicted", text) };
    let difference = |k: usize| if a.assessed[k] > 0 { a.difference[k] } else { f64::NAN };
    finding
        .value(worst, "1/s")
        .evidence(format!("map over the whole period, tolerance {TOLERANCE:.0e}: states"), a.assessed[0] as f64, "")
        .evidence("its largest difference of a growth rate", difference(0), "1/s")
        .evidence("Hill's method without sorting: states", a.assessed[1] as f64, "")
        .evidence("its largest difference of a growth rate", difference(1), "1/s")
}
