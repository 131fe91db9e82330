//! Findings about changes of stability, and about assessing it again by other methods.

use super::stretches::stretch_of;
use crate::outcome::{Arg, Finding, Message};
use crate::solve::harmonic::branches::agreement::{Agreement, TOLERANCE};
use crate::solve::harmonic::branches::bifurcation::{Change, Event};
use crate::solve::harmonic::branches::response::{Response, Traced};
use crate::solve::harmonic::stability::floquet::Unassessed;
use crate::study::shared::support::larger;

/// Changes listed one by one at most.
const MOST: usize = 6;

/// Every place where states that could be held cease to be stable, or become so, away from folds.
pub(super) fn changes(response: &Response) -> Vec<Finding> {
    let all = || response.branches.iter().flat_map(|b| b.changes.iter().map(move |c| (b, c)));
    let mut out: Vec<Finding> = all().filter_map(|(b, c)| change(b, c)).take(MOST).collect();
    let more = all().count() - out.len();
    if more > 0 {
        out.push(Finding::info("more_bifurcations", "nonlinear-response-more-bifurcations").arg("more", Arg::count(more)));
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
    let way = Arg::word(if lost { "lost" } else { "gained" });
    let event = match c.event {
        Event::NeimarkSacker if c.frequency.is_finite() => "neimark-sacker",
        Event::NeimarkSacker => "torus",
        Event::PeriodDoubling => "period-doubling",
        Event::SymmetryBreaking => "symmetry-breaking",
        Event::BranchPoint => "branch-point",
    };
    let event = Message::new("nonlinear-response-event").arg("kind", Arg::word(event)).arg("way", way.clone());
    let event = if c.frequency.is_finite() { event.arg("frequency", Arg::frequency(c.frequency)) } else { event };
    let (from, to) = (c.bracket.0.min(c.bracket.1), c.bracket.0.max(c.bracket.1));
    let id = if lost { "stability_lost" } else { "stability_gained" };
    let finding = Finding::warning(id, "nonlinear-response-stability")
        .of(c.event.name())
        .value(c.speed, "rad/s")
        .arg("stretch", stretch_of(branch, c.after)?.phrase())
        .arg("way", way)
        .arg("place", Arg::word(if c.located { "located" } else { "bracketed" }))
        .arg("from", Arg::speed(from))
        .arg("to", Arg::speed(to))
        .arg("event", event)
        .evidence("growth rate there", c.growth, "1/s");
    let finding = if c.frequency.is_finite() { finding.evidence("frequency of the disturbance", c.frequency, "rad/s") } else { finding };
    Some(finding.evidence("width of the bracket", to - from, "rad/s"))
}

/// What the other methods say.
pub(super) fn checked(a: &Agreement) -> Finding {
    if a.assessed == [0, 0] {
        return match &a.failed {
            Some(why) => Finding::warning("stability_not_checked", "nonlinear-response-stability-not-checked").arg("why", Arg::term(why)),
            None => Finding::warning("stability_not_checked", "nonlinear-response-nothing-checked"),
        };
    }
    let worst = larger(a.difference[0], a.difference[1]);
    let finding = match a.contradictions {
        0 => Finding::info("stability_checked", "nonlinear-response-stability-checked").arg("states", Arg::count(a.states)),
        n => Finding::warning("stability_contradicted", "nonlinear-response-stability-contradicted")
            .arg("contradictions", Arg::count(n))
            .arg("checks", Arg::count(a.assessed[0] + a.assessed[1])),
    };
    let difference = |k: usize| if a.assessed[k] > 0 { a.difference[k] } else { f64::NAN };
    finding
        .value(worst, "1/s")
        .evidence(
            Message::new("nonlinear-response-map-evidence").arg("tolerance", Arg::number(TOLERANCE).digits(1)),
            a.assessed[0] as f64,
            "",
        )
        .evidence("its largest difference of a growth rate", difference(0), "1/s")
        .evidence("Hill's method without sorting: states", a.assessed[1] as f64, "")
        .evidence("its largest difference of a growth rate", difference(1), "1/s")
}

/// Why stability was not assessed, as a phrase behind a colon.
pub(in crate::study) fn unassessed(why: &Unassessed) -> Message {
    let because = |word| Message::new("nonlinear-response-unassessed").arg("why", Arg::word(word));
    match why {
        Unassessed::NoTimeForm(part, cause) => because("no-time-form").arg("part", Arg::name(part)).arg("cause", Arg::term(*cause)),
        Unassessed::TooManyStates(n) => because("states").arg("states", Arg::count(*n)),
        Unassessed::Massless => because("massless"),
        Unassessed::Jumps(part) => because("jumps").arg("part", Arg::name(part)),
        Unassessed::Failed(cause) => because("failed").arg("cause", Arg::term(cause)),
    }
}
