//! The steady response to unbalance of a machine with nonlinear parts, over a range of speeds.
//!
//! Equations: harmonic balance of the assembled residual, linear parts exact at every order; see [`crate::solve::harmonic`].
//!
//! Symbols: W spin speed, rad/s; Z_n complex amplitude of order n of a body's `x + i y`, m.
//!
//! Validity: periodic motion at the spin frequency (or its submultiple); a motion that has lost its stability is shown, not followed.
//!
//! Sources: `000_a291f7ede1484e56` chapters 1 and 2 (averaging, harmonic balance); M. Urabe (1965) for the Galerkin form.

use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Value, Values};
use crate::model::part::{At, Physics, TimeForm};
use crate::model::system::{Drive, Slot, System, Workspace};
use crate::outcome::{self, Axis, Figure, Finding, Line, Outcome, Panel, Rule, SpecialPoint, Status, Table, quantity, significant};
use crate::solve::harmonic::floquet::Exponents;
use crate::solve::harmonic::orbit::Orbit;
use crate::solve::harmonic::peak::{Peak, refine};
use crate::solve::harmonic::problem::Balance;
use crate::solve::harmonic::response::{Fold, MOST_HARMONICS, Request, Response, State, Traced, respond};
use crate::solve::symmetry::Symmetry;
use laval_num::continuation::{End, Refusal};
use laval_num::newton::Cause;
use std::f64::consts::TAU;

/// See the [module](self).
pub struct NonlinearResponse {
    request: Request,
}

impl NonlinearResponse {
    /// The study that answers this request.
    pub fn new(request: Request) -> Self {
        NonlinearResponse { request }
    }
}

const SPEED: Bounds = Bounds::within(1e7);

/// Smallest spin speed, rad/s: the unbalance needs a turn to act.
const SLOWEST: f64 = 1e-3;

impl Study for NonlinearResponse {
    const KIND: &'static str = "nonlinear_response";
    const DOC: &'static str = "Steady response to unbalance over a range of speeds, with every state the machine can settle in: branches followed \
        from both ends, folds (where a slow sweep jumps) located, stability of every point.";
    const FIELDS: &'static [Field] = &[
        Field::required(
            "speed",
            FieldKind::Range { unit: "rad/s", bounds: SPEED },
            "range of the spin speed; negative speeds turn clockwise",
        ),
        Field::optional(
            "harmonics",
            FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS as i64 },
            "auto",
            "largest order of the spin frequency kept; auto raises it until the dropped force is below truncation",
        ),
        Field::optional(
            "truncation",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-15, 1.0) },
            "1e-7",
            "dropped over kept force harmonics that auto accepts",
        ),
        Field::optional(
            "symmetry",
            FieldKind::Choice(&[
                ("auto", "the largest symmetry the machine has"),
                ("quarter", "z(t + T/4) = i z(t): orders 1, -3, 5, -7"),
                ("half", "z(t + T/2) = -z(t): odd orders"),
                ("none", "all orders"),
            ]),
            "auto",
            "symmetry imposed on the motion; less symmetry admits more states",
        ),
        Field::optional("subharmonic", FieldKind::Integer { min: 1, max: 9 }, "1", "period sought, in turns of the rotor"),
        Field::optional("stability", FieldKind::Flag, "true", "judge the stability of every point"),
        Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of a branch"),
    ];

    fn build(values: &Values, _: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = values.range("speed")?;
        let (lo, hi) = (speed.from.min(speed.to), speed.from.max(speed.to));
        if lo == hi {
            diagnostics.push(
                Diagnostic::error("response.range", "the range of speeds is empty")
                    .at(values.span_of("speed"))
                    .help("give different from and to"),
            );
            return None;
        }
        if !(lo >= SLOWEST || hi <= -SLOWEST) {
            diagnostics.push(
                Diagnostic::error("response.standstill", "the range of speeds contains standstill, where no unbalance acts")
                    .at(values.span_of("speed"))
                    .help(format!("keep both ends above {SLOWEST} rad/s, or both below -{SLOWEST} rad/s for rotation the other way round")),
            );
            return None;
        }
        let harmonics = match values.get("harmonics") {
            Some(Value::Integer(h)) => usize::try_from(*h).ok(),
            _ => None,
        };
        let symmetry = match values.choice("symmetry") {
            Some("quarter") => Some(Symmetry::Quarter),
            Some("half") => Some(Symmetry::Half),
            Some("none") => Some(Symmetry::None),
            _ => None,
        };
        let whole = |name: &str, default: usize| values.integer(name).and_then(|i| usize::try_from(i).ok()).unwrap_or(default);
        let divisor = whole("subharmonic", 1);
        if let Some(h) = harmonics.filter(|&h| h < divisor) {
            diagnostics.push(
                Diagnostic::error(
                    "response.harmonics",
                    format!("order {h} of the base frequency does not reach the unbalance, which has order {divisor}"),
                )
                .at(values.span_of("harmonics"))
                .help("with subharmonic = n, orders count in steps of speed / n: keep at least n of them"),
            );
            return None;
        }
        Some(NonlinearResponse {
            request: Request {
                speeds: (lo, hi),
                harmonics,
                symmetry,
                divisor,
                truncation: values.number("truncation").unwrap_or(1e-7),
                stability: values.flag("stability").unwrap_or(true),
                max_points: whole("max_points", 2_000),
            },
        })
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "response.free_drive",
                "a steady response is computed at constant speed, and the speed of this machine is free",
            )
            .help(
                "prescribe the speed of the machine (leave out its free drive), or follow the free machine in time with a transient study",
            ));
        }
        let mut request = self.request;
        request.max_points = request.max_points.min(usize::try_from(context.work_limit).unwrap_or(usize::MAX)).max(2);
        let response = respond(system, &request, context.cancel, &|done| context.progress.report(done, 0))?;
        let mut shown = Shown::new(system, &response, &request)?;
        shown.measure(&response);
        shown.largest = shown.peak(&response, &request);
        shown.outcome(&response, &request, context).map_err(Diagnostic::from)
    }
}

/// What a reader sees of every point.
struct Shown<'a> {
    system: &'a System,
    balance: Balance<'a>,
    bodies: Vec<(String, usize)>,
    /// By branch and point: per body |Z_1|, largest distance from the axis, largest x.
    amplitudes: Vec<Vec<Vec<[f64; 3]>>>,
    /// Names and units of observed quantities, and by branch and point their largest values.
    observed: Vec<(String, &'static str)>,
    observations: Vec<Vec<Vec<f64>>>,
    /// By branch and point: largest use of validity and what.
    validity: Vec<Vec<(f64, String)>>,
    largest: Option<Largest>,
}

/// The largest displacement of all states that can be held.
struct Largest {
    body: String,
    /// At a computed point: displacement, m, and speed, rad/s.
    displacement: f64,
    speed: f64,
    /// Between computed points, where the displacement falls on both sides.
    refined: Option<Peak>,
}

impl Largest {
    /// Displacement, m, and speed, rad/s, as well as known.
    fn best(&self) -> (f64, f64) {
        self.refined.as_ref().map_or((self.displacement, self.speed), |p| (p.displacement, p.speed))
    }
}

const SAMPLES: usize = 64;

impl<'a> Shown<'a> {
    fn new(system: &'a System, response: &Response, request: &Request) -> Result<Self, Diagnostic> {
        let balance = Balance::new(system, response.discretisation, request.speeds, None)?;
        let bodies = system.bodies().into_iter().map(|b| (b.name, b.x)).collect();
        Ok(Shown { system, balance, bodies, amplitudes: vec![], observed: vec![], observations: vec![], validity: vec![], largest: None })
    }

    fn measure(&mut self, response: &Response) {
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

    fn outcome(&self, response: &Response, request: &Request, context: &Context) -> Result<Outcome, outcome::OutcomeError> {
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
            let growth = Panel::new(Axis::new("growth rate", "1/s"))
                .mark(grouped(Line::new("response", "speed", "growth rate").name("largest growth rate")).solid_where("stable"))
                .mark(Rule::y(0.0, ""));
            figure = figure.panel(growth);
        }
        figure
    }

    fn alt(&self, response: &Response) -> String {
        let folds = response.branches.iter().map(|b| b.folds.len()).sum::<usize>();
        match &self.largest {
            Some(l) => format!(
                "Largest displacement of each body against speed, on {} branch(es) with {folds} fold(s); the largest, {} of {}, is at {} rad/s.",
                response.branches.len(),
                quantity(l.best().0, "m"),
                l.body,
                significant(l.best().1, 5)
            ),
            None => "Largest displacement of each body against speed.".into(),
        }
    }

    /// Largest stable displacement of any body.
    fn peak(&mut self, response: &Response, request: &Request) -> Option<Largest> {
        let judged = judged(response);
        let mut best: Option<(f64, usize, usize, usize)> = None;
        for (b, branch) in response.branches.iter().enumerate() {
            for (i, _) in branch.points.iter().enumerate().filter(|(_, p)| !judged || p.stable()) {
                for k in 0..self.bodies.len() {
                    let a = self.amplitudes[b][i][k][1];
                    if best.is_none_or(|best| a > best.0) {
                        best = Some((a, b, i, k));
                    }
                }
            }
        }
        let (displacement, b, i, k) = best?;
        let (body, x) = self.bodies[k].clone();
        let branch = &response.branches[b];
        let refined = if displacement > 0.0 { refine(&mut self.balance, branch, i, x, request.speeds) } else { None };
        Some(Largest { body, displacement, speed: branch.points[i].speed, refined })
    }

    fn findings(&self, response: &Response, request: &Request) -> Vec<Finding> {
        let mut out = Vec::new();
        let (lo, hi) = request.speeds;
        let low = response.branches.iter().find(|b| b.from_low);
        if let Some(branch) = low {
            out.push(sweep(branch, true, lo, hi));
        }
        // the state a machine brought down from high speed is on: the branch that starts there, else the end of the other
        if let Some(branch) = response.branches.iter().find(|b| !b.from_low).or(low) {
            out.push(sweep(branch, false, lo, hi));
        }
        for branch in response.branches.iter().filter(|b| !matches!(b.end, End::Reached | End::Closed | End::Cancelled)) {
            out.extend(unfinished(branch));
        }
        if response.branches.len() > 1 && response.branches.iter().all(|b| b.end == End::Reached) {
            out.push(Finding::info(
                "two_branches",
                "Two separate families of states were found: one reached from low speed, one from high speed. Which one the machine is on depends on \
                 how it got there.",
            ));
        }
        if let Some(l) = &self.largest {
            let peak = l.refined.as_ref();
            let (a, speed) = l.best();
            let of = |f: &dyn Fn(&Peak) -> f64| peak.map_or(f64::NAN, f);
            out.push(
                Finding::info(
                    "largest_displacement",
                    format!("The largest steady displacement is {{}}, of \"{}\" at {} rad/s.", l.body, significant(speed, 6)),
                )
                .value(a, "m")
                .evidence("dropped over kept force harmonics, worst point", worst(response, |p| p.truncation), "")
                .evidence("change of the residual with twice the samples", response.sampling, "")
                .evidence("orders kept", response.discretisation.harmonics as f64, "")
                .evidence("speed", speed, "rad/s")
                .evidence("width of the bracket", of(&|p| (p.bracket.0 - p.bracket.1).abs()), "rad/s")
                .evidence("relative slope along the branch", of(&|p| p.slope.abs()), "")
                .evidence("scaled residual", of(&|p| p.residual), ""),
            );
        }
        let dropped = worst(response, |p| p.truncation);
        if request.harmonics.is_none() && dropped > request.truncation {
            out.push(
                Finding::warning(
                    "harmonics_short",
                    "The harmonics kept leave out {} of the nonlinear force at the worst point: a law with kinks converges slowly, and sharp details \
                     of such states are not resolved.",
                )
                .value(dropped, "")
                .evidence("orders kept", response.discretisation.harmonics as f64, ""),
            );
        }
        if !request.stability {
            out.push(Finding::warning("stability_unknown", "Stability was not asked for: states shown may be unstable."));
        }
        let states = || response.branches.iter().flat_map(|b| &b.points);
        let (all, known) = (states().count(), states().filter(|p| p.exponents.is_some()).count());
        if let Some(why) = &response.unjudged {
            let of = if known == 0 { String::new() } else { format!(" of {} of {all} states", all - known) };
            out.push(Finding::warning("stability_unknown", format!("Stability{of} was not judged: {why}.")));
        }
        if known > 0 {
            out.extend(self.unstable(response));
            out.extend(self.fitted());
        }
        out.extend(self.invalid(response));
        if let Some(b) = response.broken.iter().find(|b| b.change.is_nan()) {
            out.push(Finding::invalid("nan", format!("\"{}\" gives no number in some states.", b.part)));
        }
        out
    }

    /// Parts whose fitted time form stood for them in the judgement of stability.
    fn fitted(&self) -> Vec<Finding> {
        let fit = |slot: &Slot| match slot.physics {
            Physics::Frequency(TimeForm::Fit(error)) => {
                let text = format!("Stability was judged with the fitted time form of \"{}\"; the states themselves are exact.", slot.name);
                Some(Finding::info("stability_fit", text).evidence("relative error of the fit", error, ""))
            }
            _ => None,
        };
        self.system.slots().iter().filter_map(fit).collect()
    }

    /// Intervals of speed in which a branch is unstable between its folds.
    fn unstable(&self, response: &Response) -> Vec<Finding> {
        let mut out = Vec::new();
        for branch in &response.branches {
            let Some(worst) =
                branch.points.iter().filter(|p| p.growth() > 0.0 && p.unstable()).max_by(|a, b| a.growth().total_cmp(&b.growth()))
            else {
                continue;
            };
            let between_folds = branch.folds.len() >= 2 && branch.changes.is_empty() && {
                let (a, b) = (branch.folds[0].after, branch.folds[1].after);
                branch.points.iter().enumerate().all(|(i, p)| !p.unstable() || (i > a && i <= b))
            };
            if between_folds {
                continue; // the dashed middle of the curve: said by the jumps
            }
            out.push(
                Finding::warning(
                    "unstable_states",
                    format!(
                        "States from {} speed are unstable {}; the fastest growth is {{}} at {} rad/s.",
                        if branch.from_low { "low" } else { "high" },
                        unstable_ranges(branch),
                        significant(worst.speed, 5)
                    ),
                )
                .value(worst.growth(), "1/s")
                .evidence(
                    "error of the growth rate",
                    worst.exponents.as_ref().map_or(f64::NAN, |e: &Exponents| e.error),
                    "1/s",
                ),
            );
        }
        out
    }

    fn invalid(&self, response: &Response) -> Vec<Finding> {
        let mut worst: Vec<(String, f64, f64, f64)> = Vec::new();
        for (b, branch) in response.branches.iter().enumerate() {
            for (i, p) in branch.points.iter().enumerate() {
                let (ratio, what) = &self.validity[b][i];
                if *ratio <= 1.0 {
                    continue;
                }
                match worst.iter_mut().find(|w| w.0 == *what) {
                    None => worst.push((what.clone(), *ratio, p.speed, p.speed)),
                    Some(w) => *w = (w.0.clone(), w.1.max(*ratio), w.2.min(p.speed), w.3.max(p.speed)),
                }
            }
        }
        worst
            .into_iter()
            .map(|(what, ratio, from, to)| {
                Finding::invalid(
                    "outside_validity",
                    format!(
                        "Some states between {} and {} rad/s lie outside the validity of a part ({what}): up to {{}} times the limit.",
                        significant(from, 5),
                        significant(to, 5)
                    ),
                )
                .value(ratio, "")
            })
            .collect()
    }
}

/// Ranges of speed over which consecutive points of a branch are unstable, in words.
fn unstable_ranges(branch: &Traced) -> String {
    const MOST: usize = 4;
    let mut ranges = Vec::new();
    let mut start = 0;
    for run in branch.points.chunk_by(|a, b| a.unstable() == b.unstable()) {
        let (first, last) = (start, start + run.len() - 1);
        start += run.len();
        // the middle of a curve that turns back is said by the jumps
        let turned_back = branch.folds.windows(2).any(|f| f[0].after < first && last <= f[1].after);
        if !run[0].unstable() || turned_back {
            continue;
        }
        let (from, to) = run.iter().fold((f64::INFINITY, 0.0f64), |(a, b), p| (a.min(p.speed), b.max(p.speed)));
        let (from, to) = (significant(from, 4), significant(to, 4));
        ranges.push(if from == to { format!("at {from} rad/s") } else { format!("from {from} to {to} rad/s") });
    }
    let more = ranges.len().saturating_sub(MOST);
    let shown = ranges[..ranges.len() - more].join(", ");
    if more > 0 { format!("{shown} and over {more} more ranges") } else { shown }
}

/// Like `f64::max`, but NaN stays.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// Stability of every state is known.
fn judged(response: &Response) -> bool {
    response.unjudged.is_none() && response.branches.iter().flat_map(|b| &b.points).any(|p| p.exponents.is_some())
}

fn worst(response: &Response, f: impl Fn(&State) -> f64) -> f64 {
    response.branches.iter().flat_map(|b| &b.points).fold(0.0, |m, p| larger(m, f(p)))
}

/// Where a slow sweep jumps, or that it does not.
fn sweep(branch: &Traced, up: bool, lo: f64, hi: f64) -> Finding {
    let way = if up { "up" } else { "down" };
    // along the branch from the end the sweep starts at, the first fold that turns against it
    let forward = up == branch.from_low;
    let mut folds: Vec<&Fold> = branch.folds.iter().collect();
    if !forward {
        folds.reverse();
    }
    let first = folds.into_iter().find(|f| f.upper == up);
    let reaches = branch.end == End::Reached;
    match first {
        Some(f) => Finding::info(format!("jump_{way}"), format!("A slow sweep {way} jumps at {{}}."))
            .value(f.speed, "rad/s")
            .evidence("change with four more orders", f.harmonics_change.abs(), "rad/s")
            .evidence("difference of two methods", f.methods_differ.abs(), "rad/s")
            .evidence("width of the bracket", (f.bracket.0 - f.bracket.1).abs(), "rad/s")
            .evidence("scaled residual", f.residual, ""),
        None if reaches => Finding::info(
            format!("no_jump_{way}"),
            format!(
                "A slow sweep {way} between {} and {} rad/s meets no jump; its states go on to the end of the range.",
                significant(lo, 5),
                significant(hi, 5)
            ),
        ),
        None => match branch.points.last() {
            Some(p) => Finding::warning(
                format!("sweep_{way}_unfinished"),
                format!("The states of a slow sweep {way} could be followed to {{}} only ({}).", reason(&branch.end)),
            )
            .value(p.speed, "rad/s"),
            None => Finding::warning(
                format!("sweep_{way}_unfinished"),
                format!("The states of a slow sweep {way} were not followed ({}).", reason(&branch.end)),
            ),
        },
    }
}

/// That a branch ends within the range beyond a fold, where the sweeps do not say so.
fn unfinished(branch: &Traced) -> Option<Finding> {
    let from = if branch.from_low { "low" } else { "high" };
    let last = branch.points.last().filter(|_| !branch.folds.is_empty())?;
    let text = format!("Beyond their folds the states from {from} speed could be followed to {{}} only ({}).", reason(&branch.end));
    Some(Finding::warning("branch_unfinished", text).value(last.speed, "rad/s"))
}

fn reason(end: &End) -> String {
    match end {
        End::Reached => "the end of the range".into(),
        End::StepTooSmall { why, .. } => refusal(why).into(),
        End::NewtonFailed { residual, .. } => format!("the start did not converge, scaled residual {residual:.1e}"),
        End::MaxPoints => "the largest number of points was used up".into(),
        End::Cancelled => "stopped on request".into(),
        End::Closed => "the branch closes on itself".into(),
    }
}

/// Why a branch could not be followed further, and what helps.
fn refusal(why: &Refusal) -> &'static str {
    match why {
        Refusal::Corrector(Cause::Undefined(why)) => why,
        Refusal::Corrector(Cause::NotFinite) => {
            "a force or its derivative is not a number there: a part is used outside the states for which it is defined"
        }
        Refusal::Corrector(Cause::Singular) => {
            "the equations have no unique solution there: a coordinate is held by nothing, or branches meet"
        }
        Refusal::Corrector(_) => {
            "the equations could not be solved beyond it: keep more harmonics, or smooth the law of a part that changes its force abruptly"
        }
        Refusal::Angle | Refusal::Reversal => {
            "the states change direction too sharply there: keep more harmonics, or smooth the law of a part that changes its force abruptly"
        }
        Refusal::Strayed => "the nearest solution beyond it belongs to other states: narrow the range of speeds about it",
        Refusal::Monitor => "the motion of a body changes too fast there, as at a resonance without damping: give the bodies some damping",
        Refusal::Parameter => {
            "the amplitude grows without limit while the speed stands still, as at a resonance without damping: give the machine damping"
        }
    }
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
