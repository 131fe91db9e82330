//! What the response says in words: jumps, the largest displacement, instability, and how far the branches could be followed.

use super::largest::Rising;
use super::shown::{Shown, words, worst};
use super::stretches::{range_words, stretches};
use super::{families, stability, sweeps};
use crate::model::part::{Physics, TimeForm};
use crate::model::system::Slot;
use crate::outcome::{self, Finding, significant};
use crate::solve::harmonic::balance::terms::admitted;
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::peak::Peak;
use crate::solve::harmonic::branches::response::{Request, Response, State, States, Traced};
use crate::solve::harmonic::stability::floquet::{Exponents, Method};
use crate::solve::stationary::images::Images;
use crate::solve::turning::isotropic;
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
            out.push(Finding::info(
                "two_branches",
                "Two separate families of states were found: one reached from low speed, one from high speed. Which one the machine is on depends on \
                 how it got there.",
            ));
        }
        out.extend(response.unclosed.as_ref().map(families::unclosed));
        if request.states == States::All {
            out.extend(families::all(response));
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
            let end = match l.left {
                _ if l.at_end => ", an end of the range".to_string(),
                Some(left) if left == speed => ", where its branch was left: beyond it nothing is known".into(),
                Some(left) => format!(" (of what was followed: its branch was left at {} rad/s)", significant(left, 6)),
                None => String::new(),
            };
            let of = |f: &dyn Fn(&Peak) -> f64| peak.map_or(f64::NAN, f);
            out.push(
                Finding::info(
                    "largest_displacement",
                    format!("The largest steady displacement is {{}}, of \"{}\" at {} rad/s{end}.", l.owner, significant(speed, 6)),
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
        let reported = self.measured.largest.iter().filter(|l| !self.only_tilts(l));
        for l in reported.filter(|_| self.measured.largest.len() > 1 && displaced && rising.is_none() && !unforced) {
            let (a, speed) = l.best();
            let text = format!("The largest steady displacement of \"{}\" is {{}}, at {} rad/s.", l.owner, significant(speed, 6));
            let slope = l.refined.as_ref().map_or(f64::NAN, |p| p.slope.abs());
            out.push(
                Finding::info("largest_displacement_of", text)
                    .of(&l.owner)
                    .value(a, "m")
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
            out.push(
                Finding::warning(
                    "harmonics_short",
                    "The harmonics kept leave out {} of the nonlinear force at the worst point: a law with kinks converges slowly, and sharp details \
                     of such states are not resolved.",
                )
                .value(dropped, "")
                .shown_as(100.0 * dropped, "%")
                .evidence("orders kept", response.discretisation.harmonics as f64, ""),
            );
        }
        if !request.stability {
            out.push(Finding::warning("stability_unknown", "Stability was not requested: states shown may be unstable."));
        }
        let states = || response.branches.iter().flat_map(|b| &b.points);
        let (all, known) = (states().count(), states().filter(|p| p.exponents.is_some()).count());
        if let Some(why) = &response.unassessed {
            let of = if known == 0 { String::new() } else { format!(" of {} of {all} states", all - known) };
            out.push(Finding::warning("stability_unknown", format!("Stability{of} was not assessed: {why}.")));
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
            out.push(Finding::invalid("nan", format!("\"{}\" gives no number in some states.", b.part)));
        }
        out
    }

    /// That a displacement or tilt rises to where a branch was left.
    fn without_largest(&self, rising: &Rising, branch: &Traced) -> Finding {
        let grows = matches!(branch.end, End::StepTooSmall { why: Refusal::Parameter | Refusal::Monitor, .. });
        let probe = &self.probes[rising.probe];
        let what = probes::quality(probe);
        let head = if grows { format!("The steady {what} is unbounded") } else { format!("The largest steady {what} was not reached") };
        let text = format!(
            "{head}: that of \"{}\" still rises at {} rad/s, where the branch of states {} was left at {{}}.",
            probes::owner(probe),
            significant(rising.speed, 6),
            words(branch.origin),
        );
        let id = if grows { format!("unbounded_{what}") } else { format!("largest_{what}_not_reached") };
        Finding::warning(id, text).value(rising.size, probe.unit()).evidence("speed", rising.speed, "rad/s")
    }

    /// Parts whose fitted time form stood for them in the assessment of stability.
    fn fitted(&self) -> Vec<Finding> {
        let fit = |slot: &Slot| match slot.physics {
            Physics::Frequency(TimeForm::Fit(error)) => {
                let text =
                    format!("Stability was assessed with the fitted time form of \"{}\"; the states themselves are exact.", slot.name);
                Some(Finding::info("stability_fit", text).evidence("relative error of the fit", error, ""))
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
            let text = format!(
                "States {} are unstable {}; the fastest growth is {{}} at {} rad/s.",
                stretch.words(),
                range_words(&ranges),
                significant(worst.speed, 5)
            );
            let (low, high) = ranges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(r.0), h.max(r.1)));
            let error = worst.exponents.as_ref().map_or(f64::NAN, |e: &Exponents| e.error);
            let finding =
                Finding::warning("unstable_states", text).value(worst.growth(), "1/s").evidence("error of the growth rate", error, "1/s");
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
        let text = "No state that was followed is stable. The masses that move round in the rotor have other states than these: stationary finds all that rest in the rotor, \
                    transient and basins show to which a motion comes.";
        moves.then(|| Finding::info("masses_elsewhere", text))
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
    let text = format!(
        "Stability of {assessed} states was assessed on Hill's determinant with the exact impedances: exponents that grow faster than {{}} were counted by the argument principle, of those \
         that decay some are known."
    );
    (assessed > 0).then(|| Finding::info("stability_by_determinant", text).value(error, "1/s"))
}

/// That a branch ends within the range beyond a fold, where the sweeps do not say so.
fn unfinished(branch: &Traced, end: outcome::End) -> Option<Finding> {
    let last = branch.points.last().filter(|_| !branch.folds.is_empty())?;
    let why = reason(&branch.end, end);
    let text = format!("Beyond their folds the states {} could be followed to {{}} only ({why}).", words(branch.origin));
    Some(Finding::warning("branch_unfinished", text).value(last.speed, "rad/s"))
}

/// Why a branch ended, in a study that ended like this.
pub(super) fn reason(end: &End, study: outcome::End) -> String {
    match end {
        End::MaxPoints if study == outcome::End::WorkLimit => "the work limit was used up".into(),
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
