//! Findings about the forces of bearings and to the ground: the largest, and where the force of a bearing nearly vanishes.

use super::measuring::Measuring;
use super::shown::Shown;
use crate::outcome::{Arg, Finding, Message};
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::peak::{Peak, Sense};
use crate::solve::harmonic::branches::response::{Request, Response};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// Extreme values of the force of one part over the states that can be held.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Extremes {
    /// Index of the part among the parts of the machine.
    pub slot: usize,
    /// At a computed point: force, N, and speed, rad/s.
    pub largest: (f64, f64),
    /// Refined between the points where it falls on both sides.
    pub refined: Option<Peak>,
    /// Where it nearly vanishes.
    pub vanishing: Vec<Vanishing>,
}

/// A place where a force nearly vanishes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Vanishing {
    /// The place.
    pub peak: Peak,
    /// Share of the smaller of the largest forces on both sides.
    pub share: f64,
    /// That force, N.
    pub beside: f64,
    /// Index of the branch, and of its point next to the place.
    pub at: (usize, usize),
}

/// A force is rounding at this share of the largest of all, as of a rotating damper in synchronous whirl.
const ROUNDING: f64 = 1e-12;
/// A force vanishes nearly where it is this share of what it is on both sides.
const VANISHING: f64 = 0.05;
/// Places with evidence of their own at most.
const CONFIRMED: usize = 8;
/// Places listed for one part at most.
const MOST: usize = 2;

impl Measuring<'_> {
    /// Of every part that shows a force.
    pub(super) fn extreme_forces(&mut self, response: &Response, request: &Request) -> Vec<Extremes> {
        let mut all: Vec<Extremes> =
            Measure::forces(self.system).into_iter().filter_map(|slot| self.extremes(response, request, slot)).collect();
        let largest = all.iter().map(|e| e.largest.0).fold(0.0, f64::max);
        all.retain(|e| !(e.largest.0 <= ROUNDING * largest));
        // the deepest have brackets of their own
        let mut least: Vec<(f64, usize, usize)> =
            all.iter().enumerate().flat_map(|(e, x)| x.vanishing.iter().enumerate().map(move |(k, v)| (v.share, e, k))).collect();
        least.sort_by_number(|l| l.0);
        for (_, e, k) in least.into_iter().take(CONFIRMED) {
            let (slot, Vanishing { at, beside, .. }) = (all[e].slot, all[e].vanishing[k].clone());
            if let Some(peak) = self.confirmed(response, at, Measure::Force(slot), Sense::Least, request) {
                all[e].vanishing[k] = Vanishing { share: peak.value / beside, peak, at, beside };
            }
        }
        all
    }

    fn extremes(&mut self, response: &Response, request: &Request, slot: usize) -> Option<Extremes> {
        let name = &self.system.slots()[slot].name;
        let column = self
            .measured
            .observed
            .iter()
            .position(|(n, unit)| unit == "N" && n.strip_prefix(name.as_str()).is_some_and(|n| n.starts_with(' ')))?;
        let measure = Measure::Force(slot);
        let mut values = Vec::new();
        let mut vanishing = Vec::new();
        for (b, branch) in response.branches.iter().enumerate() {
            let force: Vec<f64> = self.measured.observations[b].iter().map(|o| o.get(column).copied().unwrap_or(f64::NAN)).collect();
            let held = |i: usize| !branch.points[i].unstable();
            values.push((0..force.len()).map(|i| if held(i) { force[i] } else { f64::NAN }).collect::<Vec<f64>>());
            // the largest force from either end up to each point
            let running = |all: &mut dyn Iterator<Item = f64>| {
                all.scan(0.0f64, |m, f| {
                    *m = m.max(f);
                    Some(*m)
                })
                .collect::<Vec<f64>>()
            };
            let before = running(&mut force.iter().copied());
            let mut after = running(&mut force.iter().rev().copied());
            after.reverse();
            for i in 1..force.len().saturating_sub(1) {
                let share = force[i] / before[i].min(after[i]);
                let least = force[i] <= force[i - 1] && force[i] < force[i + 1];
                if least && share < 4.0 * VANISHING && held(i) {
                    let found = self.refined(response, (b, i), measure, Sense::Least, request);
                    let beside = before[i].min(after[i]);
                    vanishing.extend(found.map(|peak| Vanishing { share: peak.value / beside, peak, beside, at: (b, i) }));
                }
            }
        }
        // of joints between bodies: what leads to the ground follows the motion of one
        let joint = self.system.slots()[slot].map.iter().take(2).all(|row| row.len() > 1);
        vanishing.retain(|v| joint && v.share < VANISHING);
        vanishing.sort_by_number(|v| v.share);
        vanishing.truncate(MOST);
        let top = self.summit(response, request, measure, &values, false)?;
        let speed = response.branches[top.at.0].points[top.at.1].speed;
        Some(Extremes { slot, largest: (top.value, speed), refined: top.refined, vanishing })
    }
}

impl Shown<'_> {
    /// The largest force of each part, and where one nearly vanishes.
    pub(super) fn force_findings(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        let rising = self.measured.rising.is_some();
        for e in &self.measured.forces {
            let name = &self.system.slots()[e.slot].name;
            let (force, speed) = e.refined.as_ref().map_or(e.largest, |p| (p.value, p.speed));
            let of = |f: &dyn Fn(&Peak) -> f64| e.refined.as_ref().map_or(f64::NAN, f);
            let mut finding = Finding::info("largest_force", "nonlinear-response-largest-force")
                .of(name)
                .value(force, "N")
                .arg("part", Arg::name(name))
                .arg("speed", Arg::speed(speed))
                .evidence("width of the bracket", of(&|p| (p.bracket.0 - p.bracket.1).abs()), "rad/s")
                .evidence("scaled residual", of(&|p| p.residual), "")
                .evidence("speed", speed, "rad/s");
            finding.notes.extend(rising.then(|| Message::new("nonlinear-response-largest-force-left")));
            out.push(finding);
        }
        for e in &self.measured.forces {
            let name = &self.system.slots()[e.slot].name;
            for Vanishing { peak: p, share, .. } in &e.vanishing {
                out.push(
                    Finding::info("vanishing_force", "nonlinear-response-antiresonance")
                        .of(name)
                        .value(p.speed, "rad/s")
                        .arg("part", Arg::name(name))
                        .arg("force", Arg::quantity(p.value, "N"))
                        .arg("share", Arg::percent(*share))
                        .evidence("width of the bracket", (p.bracket.0 - p.bracket.1).abs(), "rad/s")
                        .evidence("force there", p.value, "N")
                        .evidence("scaled residual", p.residual, ""),
                );
            }
        }
        out
    }
}
