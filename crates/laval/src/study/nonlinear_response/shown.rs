//! What a reader sees of every state: amplitudes, observed quantities, validity; the tables and the figure.

use super::NonlinearResponse;
use super::forces::Extremes;
use super::self_centring::Centring;
use super::tables::{branch_table, change_table, fold_table};
use super::tuning::Tuned;
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::system::{System, Workspace};
use crate::outcome::{self, Outcome, SpecialPoint, Status, significant};
use crate::solve::harmonic::branch::Origin;
use crate::solve::harmonic::orbit::Orbit;
use crate::solve::harmonic::measure::Measure;
use crate::solve::harmonic::peak::{Peak, Sense, refine};
use crate::solve::harmonic::problem::Balance;
use crate::solve::harmonic::response::{Request, Response, State, States, Traced};
use crate::study::{Context, Study};
use laval_num::continuation::End;
use std::f64::consts::TAU;

/// What a reader sees of every point.
pub(super) struct Shown<'a> {
    pub(super) system: &'a System,
    /// By the discretisation of a branch.
    balances: Vec<Balance<'a>>,
    pub(super) bodies: Vec<(String, usize)>,
    /// By branch and point: per body |Z_1|, largest distance from the axis, largest x, largest component slower than the spin, root of the mean square.
    pub(super) amplitudes: Vec<Vec<Vec<[f64; 5]>>>,
    /// Names and units of observed quantities, and by branch and point their largest values.
    pub(super) observed: Vec<(String, &'static str)>,
    pub(super) observations: Vec<Vec<Vec<f64>>>,
    /// By branch and point: largest use of validity and what.
    pub(super) validity: Vec<Vec<(f64, String)>>,
    pub(super) largest: Option<Largest>,
    pub(super) rising: Option<Rising>,
    /// Of each body, where there are several.
    pub(super) of_bodies: Vec<Largest>,
    pub(super) forces: Vec<Extremes>,
    pub(super) centring: Option<Centring>,
    pub(super) tuned: Vec<Tuned>,
}

/// The largest displacement of all states that can be held.
pub(super) struct Largest {
    pub(super) body: String,
    /// At a computed point: displacement, m, and speed, rad/s.
    displacement: f64,
    speed: f64,
    /// Between computed points, where the displacement falls on both sides.
    pub(super) refined: Option<Peak>,
    /// It lies where a branch meets the end of the range of speeds.
    pub(super) at_end: bool,
}

/// A displacement that still rises where a branch was left, above all others: there is no largest one.
pub(super) struct Rising {
    pub(super) body: String,
    /// Displacement, m, and speed, rad/s, at the last point.
    pub(super) displacement: f64,
    pub(super) speed: f64,
    /// Index of the branch.
    pub(super) branch: usize,
}

impl Largest {
    /// Displacement, m, and speed, rad/s, as well as known.
    pub(super) fn best(&self) -> (f64, f64) {
        self.refined.as_ref().map_or((self.displacement, self.speed), |p| (p.value, p.speed))
    }
}

const SAMPLES: usize = 64;

impl<'a> Shown<'a> {
    pub(super) fn new(system: &'a System, response: &Response, request: &Request) -> Result<Self, Diagnostic> {
        let mut balances: Vec<Balance> = Vec::new();
        for d in response.branches.iter().map(|b| b.discretisation.whole()) {
            if !balances.iter().any(|b| b.discretisation() == d) {
                balances.push(Balance::new(system, d, request.speeds, None)?);
            }
        }
        let bodies = system.bodies().into_iter().map(|b| (b.name, b.x)).collect();
        Ok(Shown {
            system,
            balances,
            bodies,
            amplitudes: vec![],
            observed: vec![],
            observations: vec![],
            validity: vec![],
            largest: None,
            rising: None,
            of_bodies: vec![],
            forces: vec![],
            centring: None,
            tuned: vec![],
        })
    }

    /// A largest or least value next to a point of a branch.
    pub(super) fn refined(&mut self, branch: &Traced, i: usize, measure: Measure, sense: Sense, request: &Request) -> Option<Peak> {
        let at = self.balance_of(branch);
        refine(&mut self.balances[at], branch, i, measure, sense, request.speeds)
    }

    /// The whole motion of a state.
    pub(super) fn orbit(&mut self, branch: &Traced, i: usize) -> Option<Orbit> {
        let (at, state) = (self.balance_of(branch), branch.points.get(i)?);
        Orbit::of(&mut self.balances[at], &state.x, state.speed).ok()
    }

    /// Index of the balance whose unknowns a branch has.
    fn balance_of(&self, branch: &Traced) -> usize {
        let d = branch.discretisation.whole();
        self.balances.iter().position(|b| b.discretisation() == d).unwrap_or(0)
    }

    pub(super) fn measure(&mut self, response: &Response) {
        for branch in &response.branches {
            let balance = self.balance_of(branch);
            let (mut amplitudes, mut observations, mut validity) = (Vec::new(), Vec::new(), Vec::new());
            for state in &branch.points {
                let orbit = Orbit::of(&mut self.balances[balance], &state.x, state.speed).unwrap_or_default();
                amplitudes.push(self.amplitudes_of(&orbit, branch.turns()));
                let (seen, valid) = self.observe(&orbit, branch.turns());
                observations.push(seen);
                validity.push(valid);
            }
            self.amplitudes.push(amplitudes);
            self.observations.push(observations);
            self.validity.push(validity);
        }
    }

    fn amplitudes_of(&self, orbit: &Orbit, divisor: usize) -> Vec<[f64; 5]> {
        if orbit.orders.is_empty() {
            return vec![[f64::NAN; 5]; self.bodies.len()];
        }
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let slow = |x: usize| {
            let whirls = (1..divisor).map(|k| orbit.whirl(x, k));
            whirls.fold(0.0, |m, (forward, backward)| larger(larger(m, forward.abs()), backward.abs()))
        };
        let mut out: Vec<[f64; 5]> = self.bodies.iter().map(|&(_, x)| [orbit.whirl(x, divisor).0.abs(), 0.0, 0.0, slow(x), 0.0]).collect();
        let samples = SAMPLES * divisor;
        for j in 0..samples {
            orbit.at(TAU * j as f64 / samples as f64, &mut q, &mut v, &mut a, &mut z);
            for (o, &(_, x)) in out.iter_mut().zip(&self.bodies) {
                o[1] = larger(o[1], q[x].hypot(q[x + 1]));
                o[2] = larger(o[2], q[x].abs());
                o[4] += (q[x] * q[x] + q[x + 1] * q[x + 1]) / samples as f64;
            }
        }
        out.iter_mut().for_each(|o| o[4] = o[4].sqrt());
        out
    }

    fn observe(&mut self, orbit: &Orbit, turns: usize) -> (Vec<f64>, (f64, String)) {
        let mut worst = (0.0, String::new());
        if orbit.orders.is_empty() {
            return (vec![f64::NAN; self.observed.len()], worst);
        }
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let mut ws = Workspace::default();
        let (divisor, samples) = (turns as f64, SAMPLES * turns);
        let mut series: Vec<Vec<f64>> = Vec::with_capacity(samples);
        for j in 0..samples {
            let tau = TAU * j as f64 / samples as f64;
            orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
            let at = At { q: &q, v: &v, a: &a, z: &z, phase: divisor * tau, speed: orbit.speed, spin_accel: 0.0, t: tau / orbit.frequency };
            // displacements of bodies have columns of their own
            let seen: Vec<_> = self.system.observe(&at, &mut ws).into_iter().filter(|(_, o)| o.name != "displacement").collect();
            if self.observed.is_empty() {
                self.observed = seen.iter().map(|(slot, o)| (format!("{} {}", self.system.slots()[*slot].name, o.name), o.unit)).collect();
            }
            series.push(seen.iter().map(|(_, o)| o.value.abs()).collect());
            if j % 4 != 0 {
                continue;
            }
            for (slot, v) in self.system.validity(&at, &mut ws) {
                if !(v.ratio <= worst.0) {
                    worst = (v.ratio, format!("{}: {}", self.system.slots()[slot].name, v.what));
                }
            }
        }
        let largest = (0..self.observed.len()).map(|k| crest(&series, k)).collect();
        (largest, worst)
    }

    pub(super) fn outcome(&self, response: &Response, request: &Request, context: &Context) -> Result<Outcome, outcome::OutcomeError> {
        let mut out = Outcome::new(NonlinearResponse::KIND, context.name).over("speed", "rad/s").end(end(response));
        for f in self.findings(response, request) {
            out = out.finding(f);
        }
        let all = request.states == States::All;
        for t in [self.table(response, all)?, fold_table(response)?, change_table(response)?] {
            if t.rows() > 0 {
                out = out.table(t);
            }
        }
        if all {
            out = out.table(branch_table(response)?);
        }
        // stopped before the first point: nothing to draw
        if out.find_table("response").is_some() {
            out = out.figure(self.figure(response, all));
            if let Some(figure) = self.force_figure(response, all) {
                out = out.figure(figure);
            }
        }
        for branch in &response.branches {
            for f in &branch.folds {
                let status = if f.confirmed { Status::Located } else { Status::Bracketed };
                out = out.special_point(
                    SpecialPoint::new("fold", f.speed, f.bracket)
                        .status(status)
                        .evidence("scaled residual", f.residual, "")
                        .evidence("difference of two methods", f.methods_differ, "rad/s")
                        .evidence("change with four more orders", f.harmonics_change, "rad/s"),
                );
            }
            for c in &branch.changes {
                let status = if c.located { Status::Located } else { Status::Bracketed };
                out = out.special_point(
                    SpecialPoint::new(c.event.name(), c.speed, c.bracket)
                        .status(status)
                        .evidence("growth rate there", c.growth, "1/s")
                        .evidence("frequency of the disturbance", c.frequency, "rad/s"),
                );
            }
        }
        for &(name, count) in &response.work {
            out = out.work(name, count);
        }
        out.checked()
    }

    /// Largest stable displacement of any body, and one that rises above it where a branch was left: what rises to such an end is no maximum.
    pub(super) fn peaks(&mut self, response: &Response, request: &Request) -> (Option<Largest>, Option<Rising>) {
        let mut best: Option<(f64, usize, usize, usize)> = None;
        let mut rising: Option<Rising> = None;
        for (b, branch) in response.branches.iter().enumerate() {
            let held: Vec<usize> = (0..branch.points.len()).filter(|&i| !branch.points[i].unstable()).collect();
            let left = !matches!(branch.end, End::Reached | End::Closed);
            for k in 0..self.bodies.len() {
                let a = |i: usize| self.amplitudes[b][i][k][1];
                let last = branch.points.len().saturating_sub(1);
                let foot = if left { (1..=last).rev().find(|&i| !(a(i) >= a(i - 1))).unwrap_or(0) } else { last };
                for &i in &held {
                    if left && i >= foot && foot < last {
                        if rising.as_ref().is_none_or(|r| a(i) > r.displacement) {
                            let (body, speed) = (self.bodies[k].0.clone(), branch.points[i].speed);
                            rising = Some(Rising { body, displacement: a(i), speed, branch: b });
                        }
                    } else if best.is_none_or(|best| a(i) > best.0) {
                        best = Some((a(i), b, i, k));
                    }
                }
            }
        }
        let largest = best.map(|(displacement, b, i, k)| {
            let (body, x) = self.bodies[k].clone();
            let branch = &response.branches[b];
            let refined = if displacement > 0.0 { self.refined(branch, i, Measure::Displacement(x), Sense::Largest, request) } else { None };
            let at_end = refined.is_none() && (i == 0 || i + 1 == branch.points.len());
            Largest { body, displacement, speed: branch.points[i].speed, refined, at_end }
        });
        let above = |r: &Rising| largest.as_ref().is_none_or(|l| r.displacement > l.best().0);
        let rising = rising.filter(above);
        (largest, rising)
    }
}

impl Shown<'_> {
    /// Largest displacement of each body over the states that can be held.
    pub(super) fn body_peaks(&mut self, response: &Response, request: &Request) -> Vec<Largest> {
        let mut out = Vec::new();
        for k in 0..self.bodies.len() {
            let points = response.branches.iter().enumerate().flat_map(|(b, t)| (0..t.points.len()).map(move |i| (b, i)));
            let held = points.filter(|&(b, i)| !response.branches[b].points[i].unstable() && self.amplitudes[b][i][k][1].is_finite());
            let size = |&(b, i): &(usize, usize)| self.amplitudes[b][i][k][1];
            let Some((b, i)) = held.max_by(|x, y| size(x).total_cmp(&size(y))) else { continue };
            let (displacement, branch) = (size(&(b, i)), &response.branches[b]);
            let (body, x) = self.bodies[k].clone();
            let refined = if displacement > 0.0 { self.refined(branch, i, Measure::Displacement(x), Sense::Largest, request) } else { None };
            let at_end = refined.is_none() && (i == 0 || i + 1 == branch.points.len());
            out.push(Largest { body, displacement, speed: branch.points[i].speed, refined, at_end });
        }
        out
    }
}

/// Largest value of quantity `k` in samples of a period: at the vertex of the parabola through the largest and those beside it.
fn crest(series: &[Vec<f64>], k: usize) -> f64 {
    let of = |j: usize| series[j % series.len()].get(k).copied().unwrap_or(f64::NAN);
    let mut top = 0;
    for j in 0..series.len() {
        if of(j).is_nan() {
            return f64::NAN;
        }
        if of(j) > of(top) {
            top = j;
        }
    }
    let (a, b, c) = (of(top + series.len() - 1), of(top), of(top + 1));
    let bend = a - 2.0 * b + c;
    if bend < 0.0 { b - (a - c) * (a - c) / (8.0 * bend) } else { b }
}

/// Like `f64::max`, but NaN stays.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// After "states": which ones.
pub(super) fn words(origin: Origin) -> String {
    let at = |w: f64| significant(w, 5);
    match origin {
        Origin::Low => "from low speed".into(),
        Origin::High => "from high speed".into(),
        Origin::Broken(_, w) => format!("of less symmetry from {} rad/s", at(w)),
        Origin::Doubled(_, w) => format!("of doubled period from {} rad/s", at(w)),
        Origin::Crossing(_, w) => format!("crossing at {} rad/s", at(w)),
        Origin::Mixed => "with x and y on different states".into(),
        Origin::Subharmonic(nu) => format!("that repeat every {nu} turns"),
        Origin::Start => "apart from the others".into(),
    }
}

/// Stability of some states is known.
pub(super) fn judged(response: &Response) -> bool {
    response.branches.iter().flat_map(|b| &b.points).any(|p| p.exponents.is_some())
}

pub(super) fn worst(response: &Response, f: impl Fn(&State) -> f64) -> f64 {
    response.branches.iter().flat_map(|b| &b.points).fold(0.0, |m, p| larger(m, f(p)))
}

fn end(response: &Response) -> outcome::End {
    let ends = || response.branches.iter().map(|b| b.end);
    if ends().any(|e| e == End::Cancelled) {
        return outcome::End::Cancelled;
    }
    for e in ends() {
        match e {
            End::StepTooSmall { at, .. } => return outcome::End::StepTooSmall { at },
            End::NewtonFailed { at, residual, .. } => return outcome::End::NewtonFailed { at, residual },
            End::MaxPoints => return outcome::End::MaxPoints,
            _ => {}
        }
    }
    outcome::End::Reached
}
