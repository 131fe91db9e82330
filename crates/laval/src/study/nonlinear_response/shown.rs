//! What a reader sees of every state: amplitudes, observed quantities, validity; the tables and the figure.

use super::NonlinearResponse;
use super::findings::unstable_ranges;
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::system::{System, Workspace};
use crate::outcome::{self, Axis, Band, Figure, Line, Outcome, Panel, Rule, SpecialPoint, Status, Table, quantity, significant};
use crate::solve::harmonic::orbit::Orbit;
use crate::solve::harmonic::peak::{Peak, refine};
use crate::solve::harmonic::problem::Balance;
use crate::solve::harmonic::response::{Fold, Request, Response, State};
use crate::study::{Context, Study};
use laval_num::continuation::End;
use std::f64::consts::TAU;
/// What a reader sees of every point.
pub(super) struct Shown<'a> {
    pub(super) system: &'a System,
    balance: Balance<'a>,
    bodies: Vec<(String, usize)>,
    /// By branch and point: per body |Z_1|, largest distance from the axis, largest x.
    amplitudes: Vec<Vec<Vec<[f64; 3]>>>,
    /// Names and units of observed quantities, and by branch and point their largest values.
    observed: Vec<(String, &'static str)>,
    observations: Vec<Vec<Vec<f64>>>,
    /// By branch and point: largest use of validity and what.
    pub(super) validity: Vec<Vec<(f64, String)>>,
    pub(super) largest: Option<Largest>,
    pub(super) rising: Option<Rising>,
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
        self.refined.as_ref().map_or((self.displacement, self.speed), |p| (p.displacement, p.speed))
    }
}

const SAMPLES: usize = 64;

impl<'a> Shown<'a> {
    pub(super) fn new(system: &'a System, response: &Response, request: &Request) -> Result<Self, Diagnostic> {
        let balance = Balance::new(system, response.discretisation, request.speeds, None)?;
        let bodies = system.bodies().into_iter().map(|b| (b.name, b.x)).collect();
        Ok(Shown {
            system,
            balance,
            bodies,
            amplitudes: vec![],
            observed: vec![],
            observations: vec![],
            validity: vec![],
            largest: None,
            rising: None,
        })
    }

    pub(super) fn measure(&mut self, response: &Response) {
        for branch in &response.branches {
            let (mut amplitudes, mut observations, mut validity) = (Vec::new(), Vec::new(), Vec::new());
            for state in &branch.points {
                let orbit = Orbit::of(&mut self.balance, &state.x, state.speed).unwrap_or_default();
                amplitudes.push(self.amplitudes_of(&orbit));
                let (seen, valid) = self.observe(&orbit);
                observations.push(seen);
                validity.push(valid);
            }
            self.amplitudes.push(amplitudes);
            self.observations.push(observations);
            self.validity.push(validity);
        }
    }

    fn amplitudes_of(&self, orbit: &Orbit) -> Vec<[f64; 3]> {
        if orbit.orders.is_empty() {
            return vec![[f64::NAN; 3]; self.bodies.len()];
        }
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let divisor = self.balance.terms.divisor;
        let mut out: Vec<[f64; 3]> = self.bodies.iter().map(|&(_, x)| [orbit.whirl(x, divisor).0.abs(), 0.0, 0.0]).collect();
        for j in 0..SAMPLES {
            orbit.at(TAU * j as f64 / SAMPLES as f64, &mut q, &mut v, &mut a, &mut z);
            for (o, &(_, x)) in out.iter_mut().zip(&self.bodies) {
                o[1] = larger(o[1], q[x].hypot(q[x + 1]));
                o[2] = larger(o[2], q[x].abs());
            }
        }
        out
    }

    fn observe(&mut self, orbit: &Orbit) -> (Vec<f64>, (f64, String)) {
        let mut worst = (0.0, String::new());
        if orbit.orders.is_empty() {
            return (vec![f64::NAN; self.observed.len()], worst);
        }
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let mut ws = Workspace::default();
        let mut largest = vec![0.0f64; self.observed.len()];
        let divisor = self.balance.terms.divisor as f64;
        for j in 0..SAMPLES / 4 {
            let tau = TAU * j as f64 / (SAMPLES / 4) as f64;
            orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
            let at = At { q: &q, v: &v, a: &a, z: &z, phase: divisor * tau, speed: orbit.speed, spin_accel: 0.0, t: tau / orbit.frequency };
            // displacements of bodies have columns of their own
            let seen: Vec<_> = self.system.observe(&at, &mut ws).into_iter().filter(|(_, o)| o.name != "displacement").collect();
            if self.observed.is_empty() {
                self.observed = seen.iter().map(|(slot, o)| (format!("{} {}", self.system.slots()[*slot].name, o.name), o.unit)).collect();
                largest = vec![0.0; seen.len()];
            }
            for (l, (_, o)) in largest.iter_mut().zip(&seen) {
                *l = larger(*l, o.value.abs());
            }
            for (slot, v) in self.system.validity(&at, &mut ws) {
                if !(v.ratio <= worst.0) {
                    worst = (v.ratio, format!("{}: {}", self.system.slots()[slot].name, v.what));
                }
            }
        }
        (largest, worst)
    }

    pub(super) fn outcome(&self, response: &Response, request: &Request, context: &Context) -> Result<Outcome, outcome::OutcomeError> {
        let mut out = Outcome::new(NonlinearResponse::KIND, context.name).over("speed", "rad/s").end(end(response));
        for f in self.findings(response, request) {
            out = out.finding(f);
        }
        for t in [self.table(response)?, fold_table(response)?] {
            if t.rows() > 0 {
                out = out.table(t);
            }
        }
        // stopped before the first point: nothing to draw
        if out.find_table("response").is_some() {
            out = out.figure(self.figure(response));
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
                let kind = if c.exponent.im.abs() > 1e-6 * c.speed { "Neimark-Sacker" } else { "change of stability" };
                out =
                    out.special_point(SpecialPoint::new(kind, c.speed, c.bracket).evidence("growth rate there", c.growth, "1/s").evidence(
                        "frequency of the disturbance",
                        c.exponent.im.abs(),
                        "rad/s",
                    ));
            }
        }
        for &(name, count) in &response.work {
            out = out.work(name, count);
        }
        out.checked()
    }

    fn table(&self, response: &Response) -> Result<Table, outcome::OutcomeError> {
        let all: Vec<(usize, usize, &State)> =
            response.branches.iter().enumerate().flat_map(|(b, t)| t.points.iter().enumerate().map(move |(i, s)| (b, i, s))).collect();
        let mut t = Table::new("response", "Steady states, branch by branch in order along each; a branch may turn back in speed")
            .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", all.iter().map(|a| a.2.speed).collect());
        for (k, (name, _)) in self.bodies.iter().enumerate() {
            let column = |c: usize| all.iter().map(|a| self.amplitudes[a.0][a.1][k][c]).collect::<Vec<f64>>();
            t = t
                .float(format!("{name} first order"), "m", "modulus of the forward first-order amplitude |Z_1|", column(0))
                .float(
                    format!("{name} largest displacement"),
                    "m",
                    "largest distance of the centre from its rest position over a period",
                    column(1),
                )
                .float(format!("{name} largest x"), "m", "largest |x| over a period", column(2));
        }
        for (k, (name, unit)) in self.observed.iter().enumerate() {
            let column = all.iter().map(|a| self.observations[a.0][a.1].get(k).copied().unwrap_or(f64::NAN)).collect();
            t = t.float(name, *unit, "largest value over a period", column);
        }
        t.float(
            "growth rate",
            "1/s",
            "largest real part of the Floquet exponents; positive grows, NaN when not judged",
            all.iter().map(|a| a.2.growth()).collect(),
        )
        .float(
            "growth rate error",
            "1/s",
            "its estimated error; NaN when not judged",
            all.iter().map(|a| a.2.exponents.as_ref().map_or(f64::NAN, |e| e.error)).collect(),
        )
        .flag("stable", "no growth beyond the error", all.iter().map(|a| a.2.stable()).collect())
        .float("truncation", "", "dropped over kept force harmonics", all.iter().map(|a| a.2.truncation).collect())
        .float("residual", "", "scaled residual of the balance", all.iter().map(|a| a.2.residual).collect())
        .float(
            "validity",
            "",
            "largest use of a part's validity; above 1 is outside",
            all.iter().map(|a| self.validity[a.0][a.1].0).collect(),
        )
        .build()
    }

    fn figure(&self, response: &Response) -> Figure {
        let values: Vec<f64> = self.amplitudes.iter().flatten().flatten().map(|a| a[1]).filter(|a| *a > 0.0 && a.is_finite()).collect();
        let (least, most) = values.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &a| (l.min(a), m.max(a)));
        let (unit, factor) = if most >= 1e-3 { ("mm", 1e3) } else { ("µm", 1e6) };
        let axis = if most > 100.0 * least { Axis::log("largest displacement", unit) } else { Axis::new("largest displacement", unit) };
        let mut panel = Panel::new(axis.factor(factor));
        let judged = judged(response);
        // one family of states needs no number in the legend
        let grouped = |line: Line| if response.branches.len() > 1 { line.group("branch") } else { line };
        for (name, _) in &self.bodies {
            let line = grouped(Line::new("response", "speed", format!("{name} largest displacement")).name(name.clone()));
            panel = panel.mark(if judged { line.solid_where("stable") } else { line });
        }
        for f in response.branches.iter().flat_map(|b| &b.folds) {
            panel = panel.mark(Rule::x(f.speed, if f.upper { "jump up-sweep" } else { "jump down-sweep" }));
        }
        let alt = self.alt(response);
        let mut figure = Figure::new("response", "Steady response to unbalance", alt).x(Axis::new("speed", "rad/s")).panel(panel);
        if judged {
            let mut growth = Panel::new(Axis::new("growth rate", "1/s"));
            for (from, to) in response.branches.iter().flat_map(unstable_ranges) {
                growth = growth.mark(Band::x(from, to).name("unstable").strip());
            }
            let growth = growth
                .mark(grouped(Line::new("response", "speed", "growth rate").name("largest growth rate")).solid_where("stable"))
                .mark(Rule::y(0.0, ""));
            figure = figure.panel(growth);
        }
        figure
    }

    fn alt(&self, response: &Response) -> String {
        let folds = response.branches.iter().map(|b| b.folds.len()).sum::<usize>();
        match &self.largest {
            Some(l) if self.rising.is_none() => format!(
                "Largest displacement of each body against speed, on {} branch(es) with {folds} fold(s); the largest, {} of {}, is at {} rad/s.",
                response.branches.len(),
                quantity(l.best().0, "m"),
                l.body,
                significant(l.best().1, 5)
            ),
            _ => "Largest displacement of each body against speed.".into(),
        }
    }

    /// Largest stable displacement of any body, and one that rises above it where a branch was left: what rises to such an end is no maximum.
    pub(super) fn peaks(&mut self, response: &Response, request: &Request) -> (Option<Largest>, Option<Rising>) {
        let judged = judged(response);
        let mut best: Option<(f64, usize, usize, usize)> = None;
        let mut rising: Option<Rising> = None;
        for (b, branch) in response.branches.iter().enumerate() {
            let held: Vec<usize> = (0..branch.points.len()).filter(|&i| !judged || branch.points[i].stable()).collect();
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
            let refined = if displacement > 0.0 { refine(&mut self.balance, branch, i, x, request.speeds) } else { None };
            let at_end = refined.is_none() && (i == 0 || i + 1 == branch.points.len());
            Largest { body, displacement, speed: branch.points[i].speed, refined, at_end }
        });
        let above = |r: &Rising| largest.as_ref().is_none_or(|l| r.displacement > l.best().0);
        let rising = rising.filter(above);
        (largest, rising)
    }
}

/// Like `f64::max`, but NaN stays.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// Stability of every state is known.
pub(super) fn judged(response: &Response) -> bool {
    response.unjudged.is_none() && response.branches.iter().flat_map(|b| &b.points).any(|p| p.exponents.is_some())
}

pub(super) fn worst(response: &Response, f: impl Fn(&State) -> f64) -> f64 {
    response.branches.iter().flat_map(|b| &b.points).fold(0.0, |m, p| larger(m, f(p)))
}

fn fold_table(response: &Response) -> Result<Table, outcome::OutcomeError> {
    let all: Vec<(usize, &Fold)> =
        response.branches.iter().enumerate().flat_map(|(b, t)| t.folds.iter().map(move |f| (b + 1, f))).collect();
    let column = |f: &dyn Fn(&Fold) -> f64| all.iter().map(|(_, x)| f(x)).collect::<Vec<f64>>();
    Table::new("folds", "Folds of the response: speeds at which a state ceases to exist")
        .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64).collect())
        .float("speed", "rad/s", "spin speed", column(&|f| f.speed))
        .text("direction", "sweep that jumps here", all.iter().map(|(_, f)| if f.upper { "up" } else { "down" }.to_string()).collect())
        .float("residual", "", "scaled residual of the extended system", column(&|f| f.residual))
        .float(
            "methods differ",
            "rad/s",
            "speed by the extended system minus speed located along the branch; NaN when the second found none",
            column(&|f| f.methods_differ),
        )
        .float(
            "harmonics change",
            "rad/s",
            "change when four more orders are kept; NaN when no fold was found with them",
            column(&|f| f.harmonics_change),
        )
        .build()
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
