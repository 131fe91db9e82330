//! What a reader sees of the states: findings, tables and figures of a result.

use super::NonlinearResponse;
use super::largest::Largest;
use super::result::Measured;
use super::tables::{branch_table, change_table};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{self, Arg, Message, Outcome, SpecialPoint, Status, significant};
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::response::{Fold, Request, Response, State, States, Traced};
use crate::study::shared::probes;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::largest;
use crate::study::{Context, Study};
use laval_num::continuation::End;

/// A response and what is measured of it.
pub(super) struct Shown<'a> {
    pub(super) system: &'a System,
    pub(super) response: &'a Response,
    pub(super) measured: &'a Measured,
    pub(super) bodies: Vec<String>,
    /// Probes that are measured, the reference points of the bodies first.
    pub(super) probes: Vec<Probe>,
    /// Slots of parts whose force is measured.
    pub(super) force_slots: Vec<usize>,
}

impl<'a> Shown<'a> {
    pub(super) fn new(system: &'a System, response: &'a Response, measured: &'a Measured) -> Self {
        let bodies = system.stations().iter().map(|s| s.name.clone()).collect();
        Shown { system, response, measured, bodies, probes: probes::all(system), force_slots: Measure::forces(system) }
    }

    /// Some point is displaced.
    pub(super) fn displaced(&self) -> bool {
        self.measured.displaced(&self.probes)
    }

    /// The largest displacement of all.
    pub(super) fn most(&self) -> Option<&Largest> {
        self.measured.largest.iter().reduce(|a, b| if b.best().0 > a.best().0 { b } else { a })
    }

    /// The body or the point of a body that has this displacement.
    pub(super) fn place(&self, l: &Largest) -> Arg {
        let own = self.probes.iter().find(|p| !p.is_tilt() && probes::owner(p) == l.owner);
        own.map_or_else(|| Arg::name(&l.owner), holder)
    }

    /// Nothing moves, because nothing forces the machine.
    pub(super) fn unforced(&self, (from, to): (f64, f64)) -> bool {
        let sizes = self.measured.sizes.iter().flatten().flat_map(|s| self.probes.iter().zip(s.iter().copied()));
        probes::unforced(self.system, &[SpinSpeeds::between(from, to)], sizes)
    }

    /// What moves most at a fold, of tilts where nothing is displaced: its probe and the largest value.
    pub(super) fn size_at(&self, fold: &Fold) -> Option<(&Probe, f64)> {
        let place = |(b, t): (usize, &Traced)| Some((b, t.folds.iter().position(|f| std::ptr::eq(f, fold))?));
        let (b, k) = self.response.branches.iter().enumerate().find_map(place)?;
        let (which, size) = probes::most(&self.probes, self.measured.at_folds.get(b)?.get(k)?, !self.displaced())?;
        Some((&self.probes[which], size))
    }

    /// The first figure, its table and the folds.
    pub(super) fn sketch(&self, request: &Request, name: &str, end: outcome::End) -> Result<Outcome, outcome::OutcomeError> {
        let (response, all) = (self.response, request.states == States::All);
        let out = Outcome::new(NonlinearResponse::KIND, name).over("speed", "rad/s").end(end);
        let table = self.states(response, all).build()?;
        if table.rows() == 0 {
            return Ok(out);
        }
        let out = out.table(table).figure(self.figure(response, all, request.speeds));
        Ok(response.branches.iter().flat_map(|b| &b.folds).fold(out, |out, f| out.special_point(fold_point(f))))
    }

    pub(super) fn outcome(&self, request: &Request, name: &str, end: outcome::End) -> Result<Outcome, outcome::OutcomeError> {
        let response = self.response;
        let mut out = Outcome::new(NonlinearResponse::KIND, name).over("speed", "rad/s").end(end);
        for f in self.findings(response, request, end) {
            out = out.finding(f);
        }
        let all = request.states == States::All;
        for t in [self.table(response, all)?, self.fold_table(response)?, change_table(response)?] {
            if t.rows() > 0 {
                out = out.table(t);
            }
        }
        if all {
            out = out.table(branch_table(response, end)?);
        }
        // stopped before the first point: nothing to draw
        if out.find_table("response").is_some() {
            let figure = self.figure(response, all, request.speeds);
            let jumps = self.jump_figure(response, &figure, request.speeds);
            out = out.figure(figure);
            if let Some(figure) = jumps {
                out = out.figure(figure);
            }
            if let Some(figure) = self.force_figure(response, all) {
                out = out.figure(figure);
            }
        }
        for branch in &response.branches {
            for f in &branch.folds {
                out = out.special_point(fold_point(f));
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
        Ok(out)
    }
}

fn fold_point(f: &Fold) -> SpecialPoint {
    SpecialPoint::new("fold", f.speed, f.bracket)
        .status(if f.confirmed { Status::Located } else { Status::Bracketed })
        .evidence("scaled residual", f.residual, "")
        .evidence("difference of two methods", f.methods_differ, "rad/s")
        .evidence("change with four more orders", f.harmonics_change, "rad/s")
}

/// Which branch, as a phrase behind "the branch".
pub(super) fn branch(origin: Origin) -> Message {
    let of = |word| Message::new("nonlinear-response-branch").arg("origin", Arg::word(word));
    match origin {
        Origin::Low => of("low"),
        Origin::High => of("high"),
        Origin::Broken(_, w) => of("broken").arg("speed", Arg::speed(w)),
        Origin::Doubled(_, w) => of("doubled").arg("speed", Arg::speed(w)),
        Origin::Crossing(_, w) => of("crossing").arg("speed", Arg::speed(w)),
        Origin::Mixed => of("mixed"),
        Origin::Subharmonic(nu) => of("subharmonic").arg("turns", Arg::count(nu)),
        Origin::Start => of("start"),
    }
}

/// The body or the point of a body whose displacement or tilt a sentence names.
pub(in crate::study) fn holder(probe: &Probe) -> Arg {
    if probe.is_tilt() { Message::new("body").arg("body", Arg::name(&probe.name)).into() } else { probes::arg(probe) }
}

/// The word by which a sentence says displacement or tilt.
pub(super) fn quality(probe: &Probe) -> Arg {
    Arg::word(probes::quality(probe))
}

/// Where a branch comes from, in the tables.
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
pub(super) fn assessed(response: &Response) -> bool {
    response.branches.iter().flat_map(|b| &b.points).any(|p| p.exponents.is_some())
}

pub(super) fn worst(response: &Response, f: impl Fn(&State) -> f64) -> f64 {
    largest(response.branches.iter().flat_map(|b| &b.points).map(f))
}

pub(super) fn end(response: &Response) -> outcome::End {
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

/// The end of a response under the limits of a run: points that the work limit did not admit are not those of the request, and a search that was cut
/// is not complete.
pub(in crate::study) fn limited(response: &Response, request: &Request, context: &Context) -> outcome::End {
    match end(response) {
        outcome::End::MaxPoints if context.work_limit <= request.max_points as u64 => outcome::End::WorkLimit,
        outcome::End::Reached if response.cut.is_some() && context.work_limit == u64::MAX && !context.cancelled() => {
            outcome::End::MaxPoints
        }
        outcome::End::Reached => context.end(response.cut.is_none()),
        other => other,
    }
}
