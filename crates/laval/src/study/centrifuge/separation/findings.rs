//! Findings of a separation.

use super::compute::size;
use super::demand::HIGHEST_SHOWN;
use super::report::Shown;
use super::result::{Demand, Released, SpeedNeeded};
use crate::outcome::{Arg, Finding, Message, Outcome};
use crate::separation::batch::RunUp;
use crate::separation::measures;
use crate::separation::separator::Separator;
use crate::separation::suspension::{Model, cut_size};
use crate::separation::validity::{FIELD, gravity_felt};

/// Share of the particles, read in four digits: 99.95 % is not all.
fn share(x: f64) -> Arg {
    Arg::percent(x).digits(4)
}

impl Shown<'_> {
    /// The share to be caught.
    fn recovery(&self) -> Message {
        let message = match self.study.task.batch.from {
            Some(d) => Message::new("separation-recovery-from").arg("diameter", Arg::quantity(d, "m")),
            None => Message::new("separation-recovery"),
        };
        message.arg("share", share(self.study.task.recovery))
    }

    /// The time at hand, or the throughput.
    fn at_hand(&self) -> Message {
        match self.study.task.throughput {
            Some(q) => Message::new("separation-at-throughput").arg("throughput", Arg::quantity(q, "m^3/s")),
            None => Message::new("separation-in-time").arg("time", Arg::quantity(self.study.task.time, "s")),
        }
    }

    /// Without spin, or at the speed of the study.
    fn spin(&self) -> Message {
        match self.study.speed {
            0.0 => Message::new("separation-without-spin"),
            speed => Message::new("separation-at-speed").arg("speed", Arg::speed(speed)),
        }
    }

    /// How the run-up counts in the time.
    fn run_up(&self) -> Message {
        // the liquid of a tube shifts while the speed changes
        let message = match (self.duration(), &self.study.task.vessel.separator) {
            (0.0, _) => return Message::new("separation-no-run-up"),
            (_, Separator::Tube(..)) => Message::new("separation-run-up-estimated"),
            _ => Message::new("separation-run-up-included"),
        };
        message.arg("duration", Arg::quantity(self.duration(), "s"))
    }

    /// How much is caught, and what the recovery takes.
    pub fn recovered(&self, out: Outcome) -> Outcome {
        let s = &self.study.task;
        let places = self.found.exits.len() as f64;
        let particles = match s.batch.from {
            Some(d) => Message::new("separation-particles-from").arg("diameter", Arg::quantity(d, "m")),
            None => Message::new("separation-particles"),
        };
        let finding = match self.found.last.filter(|l| !(l.time <= s.time)) {
            None => Finding::info("caught", "separation-caught"),
            Some(l) if l.time.is_finite() => {
                Finding::info("caught", "separation-all-sampled-caught").arg("last", Arg::quantity(l.time, "s"))
            }
            Some(_) => Finding::info("caught", "separation-all-sampled-caught-some-never"),
        };
        let mut caught = finding
            .value_as(share(self.found.caught))
            .arg("vessel", Message::new("separation-vessel").arg("kind", Arg::word(s.vessel.separator.word())))
            .arg("particles", particles)
            .arg("at_hand", self.at_hand())
            .arg("spin", self.spin())
            .arg("run_up", self.run_up())
            .evidence("places of the fixed set", places, "")
            .evidence("share of one place", 1.0 / places, "");
        if let Some(l) = self.found.last.filter(|l| l.time.is_finite()) {
            caught = caught.evidence("the last one leaves after", l.time, "s");
        }
        let out = out.finding(caught);
        let needed = self.found.needed;
        if !needed.time.is_finite() {
            let finding = Finding::warning("time_needed", "separation-never-caught");
            return out.finding(finding.arg("recovery", self.recovery()).arg("spin", self.spin()));
        }
        let finding = match s.throughput.zip(s.vessel.separator.flow_volume()) {
            Some((_, volume)) => {
                Finding::info("time_needed", "separation-residence-needed").arg("throughput", Arg::quantity(volume / needed.time, "m^3/s"))
            }
            None => Finding::info("time_needed", "separation-time-needed").arg("run_up", self.run_up()),
        };
        let finding = finding.value(needed.time, "s").arg("recovery", self.recovery()).arg("spin", self.spin());
        let mut finding = finding.evidence("time at hand", s.time, "s");
        if let Some([x, y, z]) = needed.last {
            // not a place of the fixed set: nothing is sampled
            finding = finding.evidence("start of the last one, x", x, "m").evidence("y", y, "m").evidence("z", z, "m");
        }
        if needed.spread.is_finite() {
            finding = finding.evidence("largest difference with half or a quarter of the places", needed.spread, "s");
        }
        out.finding(finding)
    }

    /// The speed a recovery needs, and whether the model still holds there.
    pub fn speed_findings(&self, demand: &Demand) -> Vec<Finding> {
        let s = &self.study.task;
        let run_up = match s.batch.run_up {
            RunUp::None => "none",
            RunUp::Linear(_) | RunUp::Smooth(_) => "same",
            RunUp::Programme(_) => "programme",
        };
        let finding = match demand.speed {
            SpeedNeeded::Found { speed: 0.0, .. } => Finding::info("speed_needed", "separation-no-spin-needed").value(0.0, "rad/s"),
            SpeedNeeded::Found { speed: w, bracket } => Finding::info("speed_needed", "separation-speed-needed")
                .value(w, "rad/s")
                .evidence("width of the bracket", bracket, "rad/s")
                .evidence("places of the fixed set", s.batch.places as f64, ""),
            SpeedNeeded::None { highest } => Finding::warning("speed_needed", "separation-no-speed-suffices")
                .arg("highest", Arg::speed(highest))
                .arg("flow", Arg::word(if self.flow() { "yes" } else { "no" })),
        };
        let finding = finding.arg("recovery", self.recovery()).arg("at_hand", self.at_hand()).arg("run_up", Arg::word(run_up));
        let felt = match demand.speed {
            SpeedNeeded::Found { speed, .. } => gravity_felt(&s.vessel.separator, speed, s.suspension.medium.gravity),
            SpeedNeeded::None { .. } => None,
        };
        let doubt = felt.map(|field| {
            let finding = Finding::warning("speed_needed_gravity", "separation-gravity").value(field, "");
            finding.arg("least", Arg::number(FIELD)).evidence("least field over gravity", FIELD, "")
        });
        std::iter::once(finding).chain(doubt).collect()
    }

    /// That no other speed was searched for.
    pub fn one_speed(&self) -> Finding {
        let finding = Finding::info("speed_needed", "separation-one-speed").arg("recovery", self.recovery());
        finding.arg("times", Arg::number(HIGHEST_SHOWN))
    }

    /// Tilt, field, cut size.
    pub fn describe(&self, mut out: Outcome) -> Outcome {
        let s = &self.study.task;
        let g = s.suspension.medium.gravity;
        let (r1, r2) = self.found.radii;
        if let (Separator::Cup(cup), Some(tilt)) = (&s.vessel.separator, self.found.tilt) {
            let f = match (cup.held.is_some(), tilt) {
                (true, _) => Finding::info("tilt", "separation-tilt-held"),
                (false, 0.0) => Finding::info("tilt", "separation-tilt-none"),
                (false, _) => Finding::info("tilt", "separation-tilt"),
            };
            let f = f.value(tilt, "rad");
            let swing = cup.hanging.swing_frequency(self.study.speed, tilt);
            out = out.finding(if cup.held.is_some() { f } else { f.evidence("frequency of its small swing", swing, "rad/s") });
        }
        let field = match self.study.speed {
            0.0 => Finding::info("rcf", "separation-no-field"),
            speed => Finding::info("rcf", "separation-field").arg("surface", Arg::number(measures::rcf(speed, r1, g))),
        };
        out = out.finding(field.value(measures::rcf(self.study.speed, r2, g), ""));
        let heavy = self.study.heavy();
        let d = cut_size(&self.found.products, &s.suspension.medium, self.study.median().density, 0.5, self.found.full_time);
        if d.is_finite() && d > 0.0 && self.stokes() {
            // sizes and times scale without inertia only, and a run-up counts by its field
            let estimate = match (&self.found.run_up, s.batch.model) {
                (Some(_), _) => "run_up",
                (None, Model::Drifting) => "none",
                (None, _) => "inertia",
            };
            let finding = Finding::info("cut_size", "separation-cut-size").value(d, "m").arg("estimate", Arg::word(estimate));
            out = out.finding(finding.arg("particles", Arg::word(if heavy { "heavy" } else { "light" })));
        }
        out
    }

    /// The one particle released at a place.
    pub fn followed(&self) -> Option<Finding> {
        let s = self.study;
        let Released { exit, reynolds, .. } = self.found.released.as_ref()?;
        let Some(e) = exit else {
            return Some(Finding::warning("released", "separation-released-stays"));
        };
        if e.time == 0.0 {
            return Some(Finding::warning("released", "separation-released-outside"));
        }
        let finding = Finding::info("released", "separation-released")
            .arg("surface", Arg::word(e.surface.word()))
            .arg("along", Arg::quantity(e.position[1], "m"))
            .value(e.time, "s")
            .evidence("x", e.position[0], "m")
            .evidence("y", e.position[1], "m")
            .evidence("z", e.position[2], "m")
            .evidence("speed there", size(&e.velocity), "m/s")
            .evidence("largest Reynolds number", *reynolds, "");
        let rates = s.task.batch.medium.rates(&s.median());
        Some(finding.evidence("drag rate over spin speed n/w", 0.5 * rates.two_n / s.speed.abs(), ""))
    }
}
