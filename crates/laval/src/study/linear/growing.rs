//! That a machine is unstable: the first finding of studies whose answers hold for a stable machine only; and the growth rate that counts.

use crate::model::part::Domain;
use crate::model::system::System;
use crate::outcome::{Arg, Finding};
use crate::solve::roots::LEAST;
use crate::solve::sweep::Strongest;
use crate::study::linear::whirl::aperiodic;
use laval_num::order::SortByNumber;

/// What follows for the numbers of a study.
pub(in crate::study) enum Follows {
    /// Amplitudes.
    Response,
    /// Critical speeds and margins.
    Speeds,
}

/// Where the machine is unstable among the speeds computed, and what follows; none where it is not.
pub(in crate::study) fn unstable(system: &System, strongest: &[Strongest], follows: &Follows) -> Option<Finding> {
    let mut all = strongest.to_vec();
    all.sort_by_number(|a| a.speed);
    all.dedup_by(|b, a| a.speed == b.speed);
    // waves that nothing inside a part damps always grow slowly with damping outside it
    let felt = |s: &Strongest| {
        let slow = system.domains(s.speed).iter().any(Domain::undamped);
        s.grows && !(slow && s.value.re <= LEAST * s.speed.abs())
    };
    let grow: Vec<&Strongest> = all.iter().filter(|s| felt(s)).collect();
    let (first, last) = (grow.first()?, grow.last()?);
    let most = grow.iter().max_by(|a, b| a.value.re.total_cmp(&b.value.re))?;
    let place = match (all.len(), grow.len()) {
        (1, _) => "one",
        (m, n) if m == n => "all",
        (_, 1) => "single",
        _ => "several",
    };
    let follows = match follows {
        Follows::Response => "response",
        Follows::Speeds => "speeds",
    };
    let share = grow.len() as f64 / all.len() as f64;
    let finding = Finding::warning("unstable", "growing-unstable")
        .value(most.value.re, "1/s")
        .arg("place", Arg::word(place))
        .arg("from", Arg::speed(first.speed))
        .arg("to", Arg::speed(last.speed))
        .arg("unstable", Arg::count(grow.len()))
        .arg("computed", Arg::count(all.len()))
        .arg("speed", Arg::speed(most.speed))
        .arg("motion", Arg::word(if aperiodic(most.value) { "divergence" } else { "whirl" }))
        .arg("frequency", Arg::frequency(most.value.im))
        .arg("follows", Arg::word(follows))
        .evidence("share of the speeds computed", share, "");
    Some(finding.evidence("first speed", first.speed, "rad/s").evidence("last speed", last.speed, "rad/s"))
}

/// Adds the growth rate above which a mode counts as unstable, `limit`, and the word `threshold`: `zero` where that is any growth.
pub(in crate::study) fn limit(finding: Finding, growth: f64) -> Finding {
    finding.arg("limit", Arg::quantity(growth, "1/s")).arg("threshold", Arg::word(if growth == 0.0 { "zero" } else { "set" }))
}
