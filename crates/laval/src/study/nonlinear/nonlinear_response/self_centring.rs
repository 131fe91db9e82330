//! Findings about self-centring: the displacement that a rotor tends to at ever higher speed, and how far from it the machine is at the top of the range.

use super::measuring::Measuring;
use super::shown::Shown;
use crate::outcome::{Arg, Finding, Message};
use crate::solve::centring::{Limit, limit};
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::response::{Response, Traced};
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};

/// The limit and the way to it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Centring {
    /// The motion at ever higher speed.
    pub limit: Limit,
    /// The bodies that follow the unbalance.
    pub bodies: Vec<Approach>,
}

/// One body on its way to the limit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Approach {
    /// Index of the body.
    pub body: usize,
    /// Forward displacement of the limit, m.
    pub limit: C64,
    /// Speed at the top of the range, rad/s.
    pub speed: f64,
    /// Forward displacement there on the branch of small motions, m.
    pub displacement: C64,
    /// d ln |deviation| / d ln speed just below that speed.
    pub power: f64,
    /// The deviation falls like the inverse square of the speed over the last octave, so that it may be continued.
    pub settled: bool,
    /// Speed, rad/s, inside the range from which on the deviation is below 1 %.
    pub reached: Option<f64>,
    /// The state at the top of the range lasts.
    pub stable: bool,
}

impl Approach {
    fn deviation(&self) -> f64 {
        (self.displacement - self.limit).abs() / self.limit.abs()
    }
}

/// A body follows the unbalance when it goes to this share of the largest limit, at least.
const MOVES: f64 = 1e-6;
/// Deviation, as a share, for which the speed is reported.
const CLOSE: f64 = 0.01;
/// Inertia wins over stiffness as 1/W^2; near a resonance the fall is steeper, as r^2/(r^2 - 1), and where damping
/// remains it is slower. Largest relative difference of the exponent at which the fall is continued beyond the range.
const SETTLED: f64 = 0.05;
/// Shares of the highest speed between which the exponent is taken; the last octave has two parts.
const OCTAVE: [f64; 2] = [0.5, std::f64::consts::FRAC_1_SQRT_2];
/// Share of the highest speed below which the exponent at the top is taken.
const BELOW: f64 = 0.9;

/// d ln deviation / d ln speed between two points.
fn exponent((w, a): (f64, f64), (v, b): (f64, f64)) -> f64 {
    (b / a).ln() / (v / w).ln()
}

impl Measuring<'_> {
    /// On the branch of the smallest motion that reaches the top of the range.
    pub(super) fn centring(&mut self, response: &Response) -> Option<Centring> {
        let top = response.branches.iter().flat_map(|b| &b.points).map(|p| p.speed.abs()).fold(0.0, f64::max);
        let limit = limit(self.system, top).filter(|_| top > 0.0)?;
        let goal: Vec<C64> = self.bodies.iter().map(|(_, x)| limit.orbit.whirl(x, 1).0).collect();
        let largest = goal.iter().fold(0.0f64, |m, z| m.max(z.abs()));
        let ends = response.branches.iter().filter(|b| b.turns() == 1).flat_map(|b| {
            let last = b.points.len().checked_sub(1);
            [Some(0), last].into_iter().flatten().filter(|&i| b.points.get(i).is_some_and(|p| p.speed.abs() == top)).map(move |i| (b, i))
        });
        let ends: Vec<(&Traced, usize)> = ends.collect();
        let mut bodies = Vec::new();
        for (body, &limit) in goal.iter().enumerate().filter(|(_, z)| z.abs() > MOVES * largest) {
            let x = self.bodies[body].1.clone();
            let at = |measuring: &mut Self, branch: &Traced, i: usize| measuring.orbit(branch, i).map(|o| o.whirl(&x, 1).0);
            let mut best: Option<(C64, &Traced, usize)> = None;
            for &(branch, i) in &ends {
                let Some(z) = at(self, branch, i) else { continue };
                if best.as_ref().is_none_or(|b| z.abs() < b.0.abs()) {
                    best = Some((z, branch, i));
                }
            }
            let Some((displacement, branch, i)) = best else { continue };
            // along the branch from the top: speed and deviation
            let way: Vec<usize> = if i == 0 { (0..branch.points.len()).collect() } else { (0..branch.points.len()).rev().collect() };
            let deviation_at =
                |measuring: &mut Self, k: usize| Some((branch.points[k].speed.abs(), (at(measuring, branch, k)? - limit).abs()));
            let below = |share: f64| way.iter().copied().find(|&k| branch.points[k].speed.abs() <= share * top);
            let here = (top, (displacement - limit).abs());
            let Some(power) = below(BELOW).and_then(|k| deviation_at(self, k)).map(|there| exponent(there, here)) else { continue };
            let settled = match OCTAVE.map(|share| below(share).and_then(|k| deviation_at(self, k))) {
                [Some(low), Some(middle)] if low.0 < middle.0 => {
                    [exponent(low, middle), exponent(middle, here)].into_iter().all(|p| (p / -2.0 - 1.0).abs() <= SETTLED)
                }
                _ => false,
            };
            let close = CLOSE * limit.abs();
            let mut reached = None;
            let mut above = here;
            for &k in way.iter().skip(1).take_while(|_| here.1 <= close) {
                let Some(point) = deviation_at(self, k) else { break };
                if point.1 > close {
                    // a power law between two points of the branch
                    let share = (close / above.1).ln() / (point.1 / above.1).ln();
                    reached = Some(above.0 * (point.0 / above.0).powf(share));
                    break;
                }
                above = point;
            }
            let stable = !branch.points[i].unstable();
            bodies.push(Approach { body, limit, speed: branch.points[i].speed, displacement, power, settled, reached, stable });
        }
        // towards the limit, not away from it: the range ends above the resonances
        bodies.retain(|a| (a.displacement * a.limit.conj()).re > 0.0 && a.power < 0.0 && a.deviation().is_finite());
        (!bodies.is_empty()).then_some(Centring { limit, bodies })
    }
}

impl Shown<'_> {
    /// Forces that parts without damping tend to, by slot, N.
    pub(super) fn force_limits(&self) -> Vec<(usize, f64)> {
        let Some(c) = &self.measured.centring else { return Vec::new() };
        let slots = self.system.slots();
        let lasting = |&k: &usize| !slots[k].is_linear() && !slots[k].uses.velocity && !slots[k].uses.spin && slots[k].states.is_empty();
        let forces = Measure::forces(self.system).into_iter().filter(lasting);
        forces.map(|k| (k, Measure::Force(k).largest(self.system, &c.limit.orbit, 1).0)).filter(|f| f.1 > 0.0).collect()
    }

    /// Displacements and forces that remain at ever higher speed.
    pub(super) fn centring_findings(&self) -> Vec<Finding> {
        let Some(c) = &self.measured.centring else { return Vec::new() };
        let mut out = Vec::new();
        for a in &c.bodies {
            let name = &self.bodies[a.body];
            let deviation = a.deviation();
            let mut notes = Vec::new();
            let close = |key: &str, from: f64| Message::new(key).arg("close", Arg::percent(CLOSE)).arg("from", Arg::speed(from));
            match a.reached {
                Some(speed) => notes.push(close("nonlinear-response-centred", speed)),
                None if a.settled && deviation > CLOSE => {
                    let speed = a.speed.abs() * (deviation / CLOSE).powf(-1.0 / a.power);
                    notes.push(close("nonlinear-response-centred-beyond", speed));
                }
                None => (),
            }
            if !a.stable {
                notes.push(Message::new("nonlinear-response-centring-unstable").arg("speed", Arg::speed(a.speed)));
            }
            let mut finding = Finding::info("self_centring", "nonlinear-response-self-centring")
                .of(name)
                .value(a.limit.abs(), "m")
                .arg("body", Arg::name(name))
                .arg("speed", Arg::speed(a.speed))
                .arg("amplitude", Arg::quantity(a.displacement.abs(), "m"))
                .arg("difference", Arg::percent(deviation))
                .evidence("displacement at the top of the range, first order", a.displacement.abs(), "m")
                .evidence("relative difference there", deviation, "")
                .evidence("d ln difference / d ln speed", a.power, "")
                .evidence("change of the limit from a tenth of the speed it was taken at", c.limit.change, "");
            finding.notes = notes;
            out.push(finding);
        }
        for (slot, force) in self.force_limits() {
            let name = &self.system.slots()[slot].name;
            out.push(
                Finding::info("force_limit", "nonlinear-response-force-limit").of(name).value(force, "N").arg("part", Arg::name(name)),
            );
        }
        out
    }
}
