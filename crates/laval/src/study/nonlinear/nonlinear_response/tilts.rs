//! The largest tilt of every body over all states that can be held.

use super::largest::Largest;
use super::shown::Shown;
use crate::outcome::{Arg, Finding};

/// Tilt that is rounding, rad.
const ROUNDING: f64 = 1e-12;

impl Shown<'_> {
    pub(super) fn tilt_findings(&self) -> Vec<Finding> {
        let say = |t: &Largest| {
            let (tilt, speed) = t.best();
            let slope = t.refined.as_ref().map_or(f64::NAN, |p| p.slope.abs());
            let finding = Finding::info("largest_tilt", "nonlinear-response-largest-tilt").of(&t.owner).value(tilt, "rad");
            let finding = finding.arg("body", Arg::name(&t.owner)).arg("speed", Arg::speed(speed));
            finding.evidence("relative slope along the branch", slope, "").evidence("speed", speed, "rad/s")
        };
        let known = self.measured.tilts.iter().filter(|t| self.measured.tilt_rising.is_none() && t.best().0 > ROUNDING);
        known.map(say).collect()
    }
}
