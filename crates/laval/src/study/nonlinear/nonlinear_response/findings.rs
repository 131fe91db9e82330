//! Findings of the response: jumps, the largest displacement, instability, and how far the branches could be followed.

use super::largest::Rising;
use super::shown::{Shown, branch, holder, quality, worst};
use super::stretches::{listed, stretches};
use super::{families, stability, sweeps};
use crate::model::part::{Physics, TimeForm};
use crate::model::system::Slot;
use crate::outcome::{self, Arg, Finding, Message};
use crate::solve::co_rotating::isotropic;
use crate::solve::harmonic::balance::terms::admitted;
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::peak::Peak;
use crate::solve::harmonic::branches::response::{Request, Response, State, States, Traced};
use crate::solve::harmonic::stability::floquet::{Exponents, Method};
use crate::solve::stationary::images::Images;
use crate::study::shared::probes;
use crate::study::shared::region::dense_orders;
use crate::study::shared::validity::Uses;
use laval_num::continuation::{End, Refusal};
use laval_num::newton::Cause;

impl Shown<'_> {
    pub(super) fn findings(&self, response: &Response, request: &Request, end: outcome::End) -> Vec<Finding> {
        let mut out = Vec::new();
        for up in [true, false] {
            out.extend(sweeps::findings(response, up, (request.speeds, end), &|f| self.size_at(f)));
        }
        out.extend(sweeps::unfollowed(response));
        for branch in response.branches.iter().filter(|b| !matches!(b.end, End::Reached | End::Closed | End::Cancelled)) {
            out.extend(unfinished(branch, end));
        }
        let mut main = response.branches.iter().filter(|b| matches!(b.origin, Origin::Low | Origin::High));
        if main.clone().count() > 1 && main.all(|b| b.end == End::Reached) {
            out.push(Finding::info("two_branches", "nonlinear-response-two-branches"));
        }
        out.extend(response.unclosed.as_ref().map(families::unclosed));
        if request.states == States::All {
            out.extend(families::all(response, request.starts));
        }
        let displaced = self.displaced();
        let rising = self.measured.rising.as_ref().filter(|_| displaced);
        for r in rising.into_iter().chain(&self.measured.tilt_rising) {
            out.push(self.without_largest(r, &response.branches[r.branch]));
        }
        let largest = self.most().filter(|_| displaced && rising.is_none());
        let unforced = largest.is_some() && self.unforced(request.speeds);
        if unforced {
            out.push(Finding::info("largest_displacement", probes::UNFORCED).value(0.0, "m"));
        }
        if let Some(l) = largest.filter(|_| !unforced) {
            let peak = l.refined.as_ref();
            let (a, speed) = l.best();
            let of = |f: &dyn Fn(&Peak) -> f64| peak.map_or(f64::NAN, f);
            let mut finding = Finding::info("largest_displacement", "nonlinear-response-largest")
                .value(a, "m")
                .arg("body", self.place(l))
                .arg("speed", Arg::speed(speed))
                .arg("place", Arg::word(if l.at_end { "end" } else { "inside" }))
                .evidence("dropped over kept force harmonics, worst point", worst(response, |p| p.truncation), "")
                .evidence("change of the residual with twice the samples", response.sampling, "")
                .evidence("orders kept", response.discretisation.harmonics as f64, "")
                .evidence("speed", speed, "rad/s")
                .evidence("width of the bracket", of(&|p| (p.bracket.0 - p.bracket.1).abs()), "rad/s")
                .evidence("relative slope along the branch", of(&|p| p.slope.abs()), "")
                .evidence("scaled residual", of(&|p| p.residual), "");
            finding.notes.extend(match l.left {
                _ if l.at_end => None,
                Some(left) if left == speed => Some(Message::new("nonlinear-response-largest-at-left-end")),
                Some(left) => Some(Message::new("nonlinear-response-largest-left").arg("left", Arg::speed(left))),
                None => None,
            });
            out.push(finding);
        }
        let reported = self.measured.largest.iter().filter(|l| !self.only_tilts(l));
        for l in reported.filter(|_| self.measured.largest.len() > 1 && displaced && rising.is_none() && !unforced) {
            let (a, speed) = l.best();
            let slope = l.refined.as_ref().map_or(f64::NAN, |p| p.slope.abs());
            out.push(
                Finding::info("largest_displacement_of", "nonlinear-response-largest-of")
                    .of(&l.owner)
                    .value(a, "m")
                    .arg("body", self.place(l))
                    .arg("speed", Arg::speed(speed))
                    .evidence("relative slope along the branch", slope, "")
                    .evidence("speed", speed, "rad/s"),
            );
        }
        out.extend(self.tilt_findings());
        out.extend(self.force_findings());
        out.extend(self.centring_findings());
        out.extend(self.tuning_findings());
        let dropped = worst(response, |p| p.truncation);
        if request.harmonics.is_none() && dropped > request.truncation {
            out.push(Finding::warning("harmonics_short", "nonlinear-response-harmonics").value_as(Arg::percent(dropped)).evidence(
                "orders kept",
                response.discretisation.harmonics as f64,
                "",
            ));
        }
        if !request.stability {
            out.push(Finding::warning("stability_unknown", "nonlinear-response-stability-not-requested"));
        }
        let states = || response.branches.iter().flat_map(|b| &b.points);
        let (all, known) = (states().count(), states().filter(|p| p.exponents.is_some()).count());
        // between two states something may not have been assessed
        if let Some(why) = response.unassessed.as_ref().filter(|_| known < all) {
            let finding = match known {
                0 => Finding::warning("stability_unknown", "nonlinear-response-stability-unknown"),
                _ => Finding::warning("stability_unknown", "nonlinear-response-stability-partly-unknown")
                    .arg("unknown", Arg::count(all - known))
                    .arg("all", Arg::count(all)),
            };
            out.push(finding.arg("why", stability::unassessed(why)));
        }
        if let Some(r) = response.reduced.filter(|_| known > 0) {
            let finding =
                Finding::info("stability_reduced", "nonlinear-response-stability-reduced").arg("coordinates", Arg::count(r.coordinates));
            out.push(finding.arg("frequency", Arg::frequency(r.frequency)).value(r.error, ""));
        }
        if known > 0 {
            out.extend(self.unstable(response));
            out.extend(self.elsewhere(response, request));
            out.extend(stability::changes(response));
            out.extend(response.agreement.as_ref().map(stability::checked));
            out.extend(self.fitted());
            out.extend(determinant(response));
        }
        let d = response.discretisation.whole();
        let (orders, _) = admitted(d.symmetry, d.harmonics, d.divisor);
        let orders: Vec<f64> = orders.into_iter().map(|n| f64::from(n) / d.divisor as f64).collect();
        out.extend(dense_orders(self.system, request.speeds.1, &orders));
        out.extend(self.invalid());
        if let Some(b) = response.broken.iter().find(|b| b.change.is_nan()) {
            out.push(Finding::invalid("nan", "nonlinear-response-no-number").arg("part", Arg::name(&b.part)));
        }
        out
    }

    /// That a displacement or tilt rises to where a branch was left.
    fn without_largest(&self, rising: &Rising, of: &Traced) -> Finding {
        let grows = matches!(of.end, End::StepTooSmall { why: Refusal::Parameter | Refusal::Monitor, .. });
        let probe = &self.probes[rising.probe];
        let what = probes::quality(probe);
        let (id, key) = match grows {
            true => (format!("unbounded_{what}"), "nonlinear-response-unbounded"),
            false => (format!("largest_{what}_not_reached"), "nonlinear-response-not-reached"),
        };
        Finding::warning(id, key)
            .value(rising.size, probe.unit())
            .arg("quality", quality(probe))
            .arg("body", holder(probe))
            .arg("speed", Arg::speed(rising.speed))
            .arg("branch", branch(of.origin))
            .evidence("speed", rising.speed, "rad/s")
    }

    /// Parts whose fitted time form stood for them in the assessment of stability.
    fn fitted(&self) -> Vec<Finding> {
        let fit = |slot: &Slot| match slot.physics {
            Physics::Frequency(TimeForm::Fit(error)) => {
                Some(Finding::info("stability_fit", "nonlinear-response-stability-fit").arg("part", Arg::name(&slot.name)).evidence(
                    "relative error of the fit",
                    error,
                    "",
                ))
            }
            _ => None,
        };
        self.system.slots().iter().filter_map(fit).collect()
    }

    /// Intervals of speed in which a branch is unstable between its folds, stretch by stretch.
    fn unstable(&self, response: &Response) -> Vec<Finding> {
        let mut out = Vec::new();
        // of further states their own finding says where they are stable
        let main = response.branches.iter().filter(|b| matches!(b.origin, Origin::Low | Origin::High));
        for stretch in main.flat_map(stretches) {
            let Some(worst) = stretch.fastest() else { continue };
            let ranges = stretch.unstable_ranges();
            let (low, high) = ranges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(r.0), h.max(r.1)));
            let error = worst.exponents.as_ref().map_or(f64::NAN, |e: &Exponents| e.error);
            let finding = Finding::warning("unstable_states", "nonlinear-response-unstable")
                .value(worst.growth(), "1/s")
                .arg("stretch", stretch.phrase())
                .arg("ranges", listed(&ranges))
                .arg("speed", Arg::speed(worst.speed))
                .evidence("error of the growth rate", error, "1/s");
            out.push(finding.evidence("from", low, "rad/s").evidence("to", high, "rad/s"));
        }
        out
    }

    /// Where to look when masses move round in the rotor and no state followed is stable.
    fn elsewhere(&self, response: &Response, request: &Request) -> Option<Finding> {
        if !response.branches.iter().flat_map(|b| &b.points).all(State::unstable) {
            return None;
        }
        let middle = 0.5 * (request.speeds.0 + request.speeds.1);
        let moves = isotropic(self.system, middle).is_ok() && !Images::of(self.system, middle).angles.is_empty();
        moves.then(|| Finding::info("masses_elsewhere", "nonlinear-response-balls-elsewhere"))
    }

    fn invalid(&self) -> Vec<Finding> {
        let mut uses = Uses::default();
        self.measured.validity.iter().flatten().for_each(|u| uses.join(u));
        uses.of_states(self.system)
    }
}

/// That stability was assessed on Hill's determinant, and what that leaves open.
fn determinant(response: &Response) -> Option<Finding> {
    let exponents = || response.branches.iter().flat_map(|b| &b.points).filter_map(|p| p.exponents.as_ref());
    let assessed = exponents().filter(|e| e.method == Method::Determinant).count();
    let error = exponents().filter(|e| e.method == Method::Determinant).map(|e| e.error).fold(0.0, f64::max);
    let finding = || Finding::info("stability_by_determinant", "nonlinear-response-determinant").value(error, "1/s");
    (assessed > 0).then(|| finding().arg("states", Arg::count(assessed)))
}

/// That a branch ends within the range beyond a fold, where the sweeps do not say so.
fn unfinished(traced: &Traced, end: outcome::End) -> Option<Finding> {
    let last = traced.points.last().filter(|_| !traced.folds.is_empty())?;
    let finding = Finding::warning("branch_unfinished", "nonlinear-response-branch-unfinished")
        .value(last.speed, "rad/s")
        .arg("branch", branch(traced.origin))
        .arg("folds", Arg::count(traced.folds.len()))
        .arg("why", reason(&traced.end, end));
    Some(finding.evidence("scaled residual of the start", residual(&traced.end), ""))
}

/// Scaled residual of a start that did not converge; NaN of other ends.
pub(super) fn residual(end: &End) -> f64 {
    if let End::NewtonFailed { residual, .. } = end { *residual } else { f64::NAN }
}

/// Why a branch ended, in a study that ended like this, and what helps.
pub(super) fn reason(end: &End, study: outcome::End) -> Message {
    let because = |word| Message::new("nonlinear-response-end").arg("why", Arg::word(word));
    match end {
        End::MaxPoints if study == outcome::End::WorkLimit => because("work-limit"),
        End::Reached => because("range"),
        End::StepTooSmall { why: Refusal::Corrector(Cause::Undefined(cause)), .. } => because("undefined").arg("cause", Arg::term(*cause)),
        End::StepTooSmall { why, .. } => because(refusal(why)),
        End::NewtonFailed { .. } => because("start"),
        End::MaxPoints => because("points"),
        End::Cancelled => because("cancelled"),
        End::Closed => because("closed"),
    }
}

/// The word for why a branch could not be followed further.
fn refusal(why: &Refusal) -> &'static str {
    match why {
        Refusal::Corrector(Cause::NotFinite) => "infinite",
        Refusal::Corrector(Cause::Singular) => "singular",
        Refusal::Corrector(_) => "unsolved",
        Refusal::Angle | Refusal::Reversal => "sharp",
        Refusal::Strayed => "strayed",
        Refusal::Monitor => "resonance",
        Refusal::Parameter => "unbounded",
    }
}
