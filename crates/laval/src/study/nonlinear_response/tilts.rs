//! The largest tilt of every body over all states that can be held.

use super::shown::Shown;
use crate::outcome::{Finding, significant};
use crate::solve::harmonic::measure::Measure;
use crate::solve::harmonic::response::{Request, Response};

/// The largest tilt of a body.
pub(super) struct Tilt {
    body: String,
    /// rad, and the speed, rad/s.
    largest: (f64, f64),
    /// Relative slope along the branch there; NaN at a computed point.
    slope: f64,
}

/// Tilt that is rounding, rad.
const ROUNDING: f64 = 1e-12;

impl Shown<'_> {
    /// Of every body that tilts.
    pub(super) fn largest_tilts(&mut self, response: &Response, request: &Request) -> Vec<Tilt> {
        let system = self.system;
        let probes = system.probes().iter().enumerate().filter(|p| p.1.is_tilt());
        let all = probes.filter_map(|(k, probe)| {
            let column = self.observed.iter().position(|o| o.1 == "rad" && o.0 == format!("{} tilt", probe.name))?;
            let held = |b: usize, i: usize| !response.branches[b].points[i].unstable();
            let of = |(b, branch): (usize, &Vec<Vec<f64>>)| -> Vec<f64> {
                let tilt = |(i, o): (usize, &Vec<f64>)| if held(b, i) { o.get(column).copied().unwrap_or(f64::NAN) } else { f64::NAN };
                branch.iter().enumerate().map(tilt).collect()
            };
            let values: Vec<Vec<f64>> = self.observations.iter().enumerate().map(of).collect();
            let s = self.summit(response, request, Measure::Probe(k), &values)?;
            let speed = response.branches[s.at.0].points[s.at.1].speed;
            let largest = s.refined.as_ref().map_or((s.value, speed), |p| (p.value, p.speed));
            let slope = s.refined.as_ref().map_or(f64::NAN, |p| p.slope.abs());
            (largest.0 > ROUNDING).then(|| Tilt { body: probe.name.clone(), largest, slope })
        });
        all.collect()
    }

    pub(super) fn tilt_findings(&self) -> Vec<Finding> {
        let say = |t: &Tilt| {
            let text = format!("The largest steady tilt of \"{}\" is {{}}, at {} rad/s.", t.body, significant(t.largest.1, 6));
            let finding = Finding::info("largest_tilt", text).of(&t.body).value(t.largest.0, "rad");
            finding.evidence("relative slope along the branch", t.slope, "").evidence("speed", t.largest.1, "rad/s")
        };
        self.tilts.iter().map(say).collect()
    }
}
