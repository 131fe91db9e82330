//! What is said of a motion: how it ended, how far it went, where it leaves the models of parts.

use super::energy;
use crate::model::system::System;
use crate::outcome::{End, Finding, Outcome, quantity};
use crate::solve::motion::envelope::{Course, Growth, Peak, Window, growth_of};
use crate::solve::motion::trajectory::Left;
use crate::study::motion::record::{MotionRecord, UsedForm, ValidityUse};
use laval_num::ode;

/// That a motion passed its bound, from the windows of the body that did, in its [`magnified`](super::magnified) trajectory; a turn of the rotor takes `turn` (s).
pub(in crate::study) fn unbounded(system: &System, left: Left, windows: &[Window], turn: f64) -> Finding {
    let body = &system.bodies()[left.body].name;
    let (at, place) = (quantity(left.t, "s"), quantity(left.displacement, "m"));
    let where_ = format!("it was left at {at}, {place} from its place of rest");
    // many e-folds in few turns tell the rate as well as many turns
    let finding = match growth_of(windows, turn, 4) {
        Some(Growth { course: Course::Straight { slope, uncertainty }, .. }) if slope > uncertainty => {
            let text = format!(
                "The motion of \"{body}\" grows without bound, linearly in time at {{}} over the second half of the record; {where_}."
            );
            Finding::warning("unbounded", text).value(slope, "m/s").evidence("uncertainty", uncertainty, "m/s")
        }
        Some(g) if g.course == Course::Exponential && g.rate > g.uncertainty => {
            let text = format!("The motion of \"{body}\" grows without bound, at {{}} over the second half of the record; {where_}.");
            Finding::warning("unbounded", text).value(g.rate, "1/s").evidence("uncertainty", g.uncertainty, "1/s")
        }
        _ => Finding::warning("unbounded", format!("The motion of \"{body}\" goes beyond all bounds; {where_}.")),
    };
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
    let bodies = system.bodies();
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

impl ProbeMotion<'_> {
    /// As the subject of a finding.
    pub fn label(&self) -> String {
        if self.tilt { format!("tilt of {}", self.body) } else { self.body.clone() }
    }
    /// As the subject of a sentence.
    pub fn words(&self) -> String {
        if self.tilt { format!("The tilt of \"{}\"", self.body) } else { format!("\"{}\"", self.body) }
    }
    /// It is more than none.
    pub fn moves(&self) -> bool {
        !(self.peak.amplitude <= self.still)
    }
    /// The largest in a sentence; nothing of a tilt that is none.
    pub fn largest(&self) -> Option<Finding> {
        let (id, what) = if self.tilt { ("largest_tilt", "tilt") } else { ("largest_displacement", "displacement") };
        if self.moves() {
            let text = format!("The largest {what} of \"{}\" from rest is {{}}.", self.body);
            return Some(Finding::info(id, text).of(&self.body).value(self.peak.amplitude, self.unit));
        }
        let but = if self.other { "; it tilts" } else { "" };
        let text = format!("\"{}\" does not move from its place of rest, to the tolerance of the integration{but}.", self.body);
        (!self.tilt).then(|| Finding::info(id, text).of(&self.body).value(0.0, "m"))
    }
}

/// How the integration ended, in the words of an outcome.
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

/// What must be said of an integration that ended early.
pub(in crate::study) fn stop(record: &MotionRecord) -> Option<Finding> {
    if record.left.is_some() {
        return None;
    }
    match &record.run.end {
        ode::End::Reached | ode::End::Event { .. } | ode::End::Cancelled { .. } => None,
        ode::End::WorkLimit { t } => {
            let text = "The limit on the number of steps (--work-limit) was reached at {}.";
            Some(Finding::warning("work_limit", text).value(*t, "s"))
        }
        ode::End::StepTooSmall { t, .. } => {
            let text = "The integration could not go on at {}: no step, however short, met the tolerance. The motion may run away there.";
            Some(Finding::warning("integration_stopped", text).value(*t, "s"))
        }
        ode::End::Failed { t, what } => {
            let text = format!("The integration could not go on at {{}}: {what}.");
            Some(Finding::warning("integration_stopped", text).value(*t, "s"))
        }
    }
}

/// When the record of a motion ends, as words at the end of a clause and at the beginning of a sentence.
pub(in crate::study) fn end_in_words(record: &MotionRecord) -> [String; 2] {
    match record.run.end {
        ode::End::Reached | ode::End::Event { .. } => ["by the end".into(), "At the end".into()],
        _ => {
            let at = quantity(record.run.t, "s");
            [format!("by {at}, where it was stopped"), format!("At {at}, where it was stopped,")]
        }
    }
}

/// What the rational forms that stood for exact parts are worth.
pub(in crate::study) fn time_forms(forms: &[UsedForm], mut outcome: Outcome) -> Outcome {
    for form in forms {
        let part = &form.part;
        let text = match form.states {
            Some(f) => {
                format!(
                    "\"{part}\" is integrated by a rational form of {} states, with a relative error of at most {{}} {}.",
                    f.count, f.scope
                )
            }
            None => format!("\"{part}\" is integrated by a rational fit of its frequency form with relative error {{}}."),
        };
        outcome = outcome.finding(Finding::info("time_form", text).of(part).value(form.error, ""));
    }
    outcome
}

/// What a motion uses of the validity of a part. One that starts outside, as the layer of a liquid that is not yet held on its wall, and is inside from some time on is
/// recognised by that time.
fn validity(system: &System, t_end: f64, used: &ValidityUse) -> Finding {
    let u = &used.of;
    let part = &system.slots()[u.slot].name;
    let (Some(first), Some(until)) = (u.exceeded, u.until) else {
        let text = format!("\"{part}\" stays inside its model: {} is at most {{}}.", u.what);
        return Finding::info("validity", text).value(u.ratio, "").evidence("reached at", u.t, "s");
    };
    if first == u.begin && until < t_end {
        let speed = used.speed_then.unwrap_or(f64::NAN);
        let after = crate::outcome::significant(u.after, 3);
        if until == 0.0 && speed == 0.0 {
            let text = format!(
                "\"{part}\" has no validity at standstill, where the motion starts. From the first step on {} is at most {{}}.",
                u.what
            );
            return Finding::info("validity", text).value(u.after, "");
        }
        let text = format!("\"{part}\" is not valid before {{}}: there {} exceeds 1. From then on it is at most {after}.", u.what);
        let finding = Finding::warning("validity", text).value(until, "s").evidence("speed then", speed, "rad/s");
        return finding.evidence("largest value from then on", u.after, "");
    }
    if u.ratio.is_infinite() {
        let text = format!("\"{part}\" leaves its model: {} grows without bound.", u.what);
        return Finding::invalid("validity", text).evidence("first exceeded at", first, "s");
    }
    let finding = Finding::invalid("validity", format!("\"{part}\" leaves its model: {} reaches {{}}, above 1.", u.what));
    finding.evidence("first exceeded at", first, "s").value(u.ratio, "").evidence("reached at", u.t, "s")
}

/// Appends whether the energy balance closes, findings on validity, time forms and contacts, and the work.
pub(in crate::study) fn common_findings(system: &System, record: &MotionRecord, outcome: Outcome) -> Outcome {
    let balance = energy::findings(record);
    let validity = record.validity.iter().map(|u| validity(system, record.run.t, u));
    let mut outcome = time_forms(&record.forms, balance.into_iter().chain(validity).fold(outcome, Outcome::finding));
    if !record.contacts.is_empty() {
        let count = record.contacts.len() as f64;
        let finding =
            Finding::info("contacts", "Laws with a switch changed side {} times; the integration restarted at each.").value(count, "");
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
