//! Findings of a motion: how it ended, how far it went, where it leaves the models of parts.

use super::energy;
use crate::model::system::System;
use crate::outcome::{Arg, End, Finding, Message, Outcome};
use crate::solve::motion::envelope::{Course, Growth, Peak, Window, growth_of};
use crate::solve::motion::trajectory::Left;
use crate::solve::reduction::Reduced;
use crate::study::motion::record::{MotionRecord, UsedForm, ValidityUse};
use crate::study::shared::support::larger;
use laval_num::ode;

/// That a motion passed its bound, from the windows of the body that did, in its [`magnified`](super::magnified) trajectory; a turn of the rotor takes `turn` (s), and
/// `speed` (rad/s) is that at the bound.
pub(in crate::study) fn unbounded(system: &System, left: Left, windows: &[Window], turn: f64, speed: f64) -> Finding {
    let body = &system.stations()[left.body].name;
    // many e-folds in few turns tell the rate as well as many turns
    let finding = match growth_of(windows, turn, 4) {
        Some(Growth { course: Course::Straight { slope, uncertainty }, .. }) if slope > uncertainty => {
            Finding::warning("unbounded", "history-unbounded-linear").value(slope, "m/s").evidence("uncertainty", uncertainty, "m/s")
        }
        Some(g) if g.course == Course::Exponential && g.rate > g.uncertainty => {
            let finding = Finding::warning("unbounded", "history-unbounded-exponential").value(g.rate, "1/s");
            finding.evidence("uncertainty", g.uncertainty, "1/s")
        }
        _ => Finding::warning("unbounded", "history-unbounded"),
    };
    let finding = finding.arg("body", Arg::name(body)).arg("at", Arg::quantity(left.t, "s"));
    let finding = finding.arg("displacement", Arg::quantity(left.displacement, "m")).arg("speed", Arg::speed(speed));
    finding.of(body).evidence("left at", left.t, "s").evidence("displacement there", left.displacement, "m")
}

/// What is seen of the motion of a body: its displacement, at any of its points where something is attached, or its tilt.
pub(in crate::study) struct ProbeMotion<'f> {
    pub body: String,
    pub tilt: bool,
    pub peak: Peak,
    pub windows: &'f [Window],
    pub unit: &'static str,
    /// Up to here it is none.
    pub still: f64,
    /// The other of displacement and tilt is more than none.
    other: bool,
}

/// Displacements of the bodies, then tilts; `still` (m) is no displacement.
pub(in crate::study) fn probe_motions<'f>(system: &System, record: &'f MotionRecord, still: f64) -> Vec<ProbeMotion<'f>> {
    // typical sizes are 1 mm and 10 mrad
    let still_tilt = 10.0 * still;
    let bodies = system.stations();
    let name = |k: usize| bodies.get(k).map_or_else(String::new, |b| b.name.clone());
    let tilted = |k: usize| record.tilts.iter().any(|t| t.body == k && !(t.peak.amplitude <= still_tilt));
    let moved = record.peaks.iter().zip(&record.windows).enumerate().map(|(k, (peak, windows))| ProbeMotion {
        body: name(k),
        tilt: false,
        peak: *peak,
        windows,
        unit: "m",
        still,
        other: tilted(k),
    });
    let tilts = record.tilts.iter().map(|t| ProbeMotion {
        body: name(t.body),
        tilt: true,
        peak: t.peak,
        windows: &t.windows,
        unit: "rad",
        still: still_tilt,
        other: !(record.peaks[t.body].amplitude <= still),
    });
    moved.chain(tilts).collect()
}

/// Share of the displacement that the integration cannot distinguish from none, from which on one is not called none.
const UNRESOLVED: f64 = 0.1;

impl ProbeMotion<'_> {
    /// As the subject of a finding.
    pub fn label(&self) -> String {
        if self.tilt { format!("tilt of {}", self.body) } else { self.body.clone() }
    }
    /// As an argument of a sentence.
    pub fn arg(&self) -> Arg {
        Message::new(if self.tilt { "tilt-of" } else { "body" }).arg("body", Arg::name(&self.body)).into()
    }
    /// `tilt` or `displacement`.
    pub fn quality(&self) -> Arg {
        Arg::word(if self.tilt { "tilt" } else { "displacement" })
    }
    /// It is more than none.
    pub fn moves(&self) -> bool {
        !(self.peak.amplitude <= self.still)
    }
    /// Id of the finding that names its largest.
    pub fn id(&self) -> &'static str {
        if self.tilt { "largest_tilt" } else { "largest_displacement" }
    }
    /// The largest; nothing of a tilt that is none.
    pub fn largest(&self) -> Option<Finding> {
        let finding = if self.moves() {
            Finding::info(self.id(), "history-largest").arg("quality", self.quality()).value(self.peak.amplitude, self.unit)
        } else if self.tilt {
            return None;
        } else {
            let (key, value) = match self.other {
                true => ("history-only-tilts", 0.0),
                false if self.peak.amplitude > UNRESOLVED * self.still => ("history-unresolved", self.peak.amplitude),
                false => ("history-at-equilibrium", 0.0),
            };
            Finding::info(self.id(), key).value(value, "m")
        };
        Some(finding.of(&self.body).arg("body", Arg::name(&self.body)))
    }
}

/// How the integration ended.
pub(in crate::study) fn end(record: &MotionRecord) -> End {
    if let Some(left) = record.left {
        return End::Unbounded { at: left.t };
    }
    match record.run.end {
        ode::End::Reached | ode::End::Event { .. } => End::Reached,
        ode::End::Cancelled { .. } => End::Cancelled,
        ode::End::WorkLimit { .. } => End::WorkLimit,
        ode::End::StepTooSmall { t, .. } | ode::End::Failed { t, .. } => End::StepTooSmall { at: t },
    }
}

/// That an integration ended early.
pub(in crate::study) fn stop(record: &MotionRecord) -> Option<Finding> {
    if record.left.is_some() {
        return None;
    }
    match &record.run.end {
        ode::End::Reached | ode::End::Event { .. } | ode::End::Cancelled { .. } => None,
        ode::End::WorkLimit { t } => Some(Finding::warning("work_limit", "history-work-limit").value(*t, "s")),
        ode::End::StepTooSmall { t, .. } => Some(Finding::warning("integration_stopped", "history-step-too-small").value(*t, "s")),
        ode::End::Failed { t, what } => {
            let finding = Finding::warning("integration_stopped", "history-integration-failed").value(*t, "s");
            Some(finding.arg("why", Arg::term(what.to_string())))
        }
    }
}

/// The last moment of a record: the end of the study, or the time at which the integration stopped.
pub(in crate::study) fn last_moment(record: &MotionRecord) -> Message {
    match record.run.end {
        ode::End::Reached | ode::End::Event { .. } => Message::new("history-end"),
        _ => Message::new("history-stop").arg("at", Arg::quantity(record.run.t, "s")),
    }
}

/// Errors of the rational forms that stand for exact parts.
pub(in crate::study) fn time_forms(forms: &[UsedForm], mut outcome: Outcome) -> Outcome {
    for form in forms {
        let finding = match form.states {
            Some(f) => {
                let finding = Finding::info("time_form", "history-time-form").arg("states", Arg::count(f.count));
                finding.arg("scope", Arg::term(f.scope))
            }
            None => Finding::info("time_form", "history-time-fit"),
        };
        outcome = outcome.finding(finding.of(&form.part).arg("part", Arg::name(&form.part)).value(form.error, ""));
    }
    outcome
}

/// What the machine was reduced to for motions in time.
pub(in crate::study) fn reduced_to(reduced: Option<Reduced>, outcome: Outcome) -> Outcome {
    let Some(r) = reduced else { return outcome };
    let finding = Finding::info("reduced", "history-reduced").arg("coordinates", Arg::count(r.coordinates));
    outcome.finding(finding.arg("frequency", Arg::frequency(r.frequency)).value(r.error, ""))
}

/// What a motion uses of the validity of a part. One that is outside only while the rotor starts or stops, as the layer of a liquid that is not held on its wall then, is
/// valid above a speed; one that starts outside and is inside from some time on is valid later.
fn validity(system: &System, record: &MotionRecord, used: &ValidityUse) -> Finding {
    let u = &used.of;
    let part = &system.slots()[u.slot].name;
    let of = |finding: Finding| finding.arg("part", Arg::name(part)).arg("what", Arg::term(u.what));
    let (Some(first), Some(until)) = (u.exceeded, u.until) else {
        return of(Finding::info("validity", "history-valid")).value(u.ratio, "").evidence("reached at", u.t, "s");
    };
    let (starts, ends) = (first == u.begin, until >= record.run.t);
    if !(starts && ends)
        && let Some(speed) = slow(record, used, (first, until))
    {
        let key = if starts { "history-valid-after-start" } else { "history-valid-while-turning" };
        let finding = of(Finding::info("validity", key)).arg("speed", Arg::speed(speed));
        let finding = finding.arg("above", Arg::word(if speed == 0.0 { "standstill" } else { "speed" }));
        return if starts { finding.value(u.after, "") } else { finding };
    }
    if starts && !ends {
        let speed = used.speed_then.unwrap_or(f64::NAN);
        let finding = of(Finding::warning("validity", "history-valid-later")).value(until, "s").arg("speed", Arg::speed(speed));
        return finding.evidence("speed then", speed, "rad/s").evidence("largest value from then on", u.after, "");
    }
    let unbounded = !u.ratio.is_finite();
    let key = if unbounded { "history-not-valid-unbounded" } else { "history-not-valid" };
    let finding = of(Finding::invalid("validity", key)).arg("first", Arg::quantity(first, "s"));
    let finding = finding.evidence("first exceeded at", first, "s");
    if unbounded { finding } else { finding.value(u.ratio, "").evidence("reached at", u.t, "s") }
}

/// Speed over the largest of a motion below which the rotor counts as starting or stopping.
const SLOW: f64 = 0.05;

/// The largest speed at which a validity is exceeded, where that is only while the rotor starts, stops or stands still.
fn slow(record: &MotionRecord, used: &ValidityUse, (first, until): (f64, f64)) -> Option<f64> {
    let fastest = record.spin.iter().map(|s| s.speed.abs()).fold(0.0, f64::max);
    let meanwhile = record.times.iter().zip(&record.spin).filter(|(t, _)| (first..=until).contains(*t)).map(|(_, s)| s.speed);
    let speeds = [used.speed_first, used.speed_then].into_iter().flatten().chain(meanwhile);
    let largest = speeds.map(f64::abs).fold(0.0, larger);
    (largest <= SLOW * fastest).then_some(largest)
}

/// Appends whether the energy balance closes, findings on validity, time forms and contacts, and the work.
pub(in crate::study) fn common_findings(system: &System, record: &MotionRecord, outcome: Outcome) -> Outcome {
    let balance = energy::findings(record);
    let validity = record.validity.iter().map(|u| validity(system, record, u));
    let mut outcome = time_forms(&record.forms, balance.into_iter().chain(validity).fold(outcome, Outcome::finding));
    outcome = reduced_to(record.reduced, outcome);
    if !record.contacts.is_empty() {
        let count = record.contacts.len();
        let finding = Finding::info("contacts", "history-contacts").value(count as f64, "").arg("count", Arg::count(count));
        outcome = outcome.finding(finding.evidence("first at", record.contacts[0].2, "s"));
    }
    let w = &record.run.work;
    outcome
        .work("steps", w.steps)
        .work("rejected_steps", w.rejected)
        .work("right_sides", w.rhs)
        .work("jacobians", w.jacobians)
        .work("factorisations", w.factorisations)
        .work(if record.stiff { "stiff" } else { "explicit" }, 1)
}
