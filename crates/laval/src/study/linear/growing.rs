//! That a machine is unstable, in words: first among the findings of studies whose answers hold for a stable machine only.

use crate::model::part::Domain;
use crate::model::system::System;
use crate::outcome::{Finding, quantity};
use crate::solve::roots::LEAST;
use crate::solve::sweep::Strongest;

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
    all.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    all.dedup_by(|b, a| a.speed == b.speed);
    // waves that nothing inside a part damps always grow slowly with damping outside it
    let felt = |s: &Strongest| {
        let slow = system.domains(s.speed).iter().any(Domain::undamped);
        s.grows && !(slow && s.value.re <= LEAST * s.speed.abs())
    };
    let grow: Vec<&Strongest> = all.iter().filter(|s| felt(s)).collect();
    let (first, last) = (grow.first()?, grow.last()?);
    let most = grow.iter().max_by(|a, b| a.value.re.total_cmp(&b.value.re))?;
    let speed = |w: f64| quantity(w, "rad/s");
    let place = match (all.len(), grow.len()) {
        (1, _) => format!("at {}", speed(first.speed)),
        (m, n) if m == n => format!("at every speed computed, from {} to {}", speed(first.speed), speed(last.speed)),
        (m, 1) => format!("at 1 of {m} speeds computed, {}", speed(first.speed)),
        (m, n) => format!("at {n} of {m} speeds computed, between {} and {}", speed(first.speed), speed(last.speed)),
    };
    let how = if most.value.im == 0.0 { "diverges without oscillation".into() } else { format!("whirls at {}", speed(most.value.im)) };
    let at = if grow.len() > 1 { format!(", at {}", speed(most.speed)) } else { String::new() };
    let so = match follows {
        Follows::Response => {
            "A steady response is never reached there: the amplitudes and resonances at these speeds belong to an unstable solution."
        }
        Follows::Speeds => "Critical speeds and margins mean nothing there before the instability is removed.",
    };
    let text = format!("The machine is unstable {place}: it {how} with a growth rate of up to {{}}{at}. {so}");
    let share = grow.len() as f64 / all.len() as f64;
    let finding = Finding::warning("unstable", text).value(most.value.re, "1/s").evidence("share of the speeds computed", share, "");
    Some(finding.evidence("first speed", first.speed, "rad/s").evidence("last speed", last.speed, "rad/s"))
}
