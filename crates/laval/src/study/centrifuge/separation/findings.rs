//! Findings of a separation.

use super::compute::size;
use super::demand::HIGHEST_SHOWN;
use super::report::Shown;
use super::result::{Demand, Released, SpeedNeeded};
use crate::outcome::{Finding, Outcome, quantity, significant};
use crate::separation::batch::RunUp;
use crate::separation::ensemble::{Model, cut_size};
use crate::separation::machine::Separator;
use crate::separation::measures;
use crate::separation::validity::{FIELD, gravity_felt};
use crate::study::shared::support::RPM;

impl Shown<'_> {
    /// The share to be caught, in words.
    fn share(&self) -> String {
        let percent = format!("{} %", significant(100.0 * self.study.task.recovery, 4));
        match self.study.task.batch.from {
            Some(d) => format!("{percent} of the particles from {} on", quantity(d, "m")),
            None => percent,
        }
    }

    /// How much is caught, and what the recovery takes.
    pub fn recovered(&self, out: Outcome) -> Outcome {
        let s = &self.study.task;
        let what = s.vessel.separator.word().replace('_', " ");
        let still = self.study.speed == 0.0;
        let rpm = format!("{} rpm", significant(self.study.speed * RPM, 4));
        let speed = if still { "without spin".to_string() } else { format!("at {rpm}") };
        let run_up = match self.duration() {
            0.0 => String::new(),
            t => {
                // the liquid of a tube shifts while the speed changes
                let how = if matches!(s.vessel.separator, Separator::Tube(..)) { " by an estimate (field at mean radius)" } else { "" };
                format!(", the run-up of {} included{how}", quantity(t, "s"))
            }
        };
        let at = match s.throughput {
            Some(q) => format!("{speed} and {} l/h", significant(q * 3.6e6, 4)),
            None => format!("in {} {speed}{run_up}", quantity(s.time, "s")),
        };
        let places = self.found.exits.len() as f64;
        let of = match s.batch.from {
            Some(d) => format!("particles from {} on", quantity(d, "m")),
            None => "particles".to_string(),
        };
        let late = self.found.last.filter(|l| !(l.time <= s.time));
        let text = match late {
            None => format!("{{}} of the {of} are caught {at} ({what})."),
            Some(l) if l.time.is_finite() => format!(
                "All of the fixed set, nearly {{}} of the {of}, are caught {at} ({what}); the last ones would take {}.",
                quantity(l.time, "s")
            ),
            Some(_) => format!("All of the fixed set, nearly {{}} of the {of}, are caught {at} ({what}); some are never caught."),
        };
        let mut caught = Finding::info("caught", text)
            .value(self.found.caught, "")
            .shown_as(100.0 * self.found.caught, "%")
            .evidence("places of the fixed set", places, "")
            .evidence("share of one place", 1.0 / places, "");
        if let Some(l) = self.found.last.filter(|l| l.time.is_finite()) {
            caught = caught.evidence("the last one leaves after", l.time, "s");
        }
        let out = out.finding(caught);
        let (name, needed) = (self.share(), self.found.needed);
        let speed = if still { "without spin" } else { "at this speed" };
        if !needed.time.is_finite() {
            let text = format!("{name} are never caught {speed}: some particles stay in the liquid.");
            return out.finding(Finding::warning("time_needed", text));
        }
        let text = match s.throughput.zip(s.vessel.separator.flow_volume()) {
            Some((_, volume)) => format!(
                "Catching {name} takes a residence time of {{}} {speed}, a throughput of at most {} l/h.",
                significant(volume / needed.time * 3.6e6, 4)
            ),
            None => format!("Catching {name} takes {{}} {speed}{run_up}."),
        };
        let mut finding = Finding::info("time_needed", text).value(needed.time, "s").evidence("time at hand", s.time, "s");
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
        let time = match s.throughput {
            Some(q) => format!("at {} l/h", significant(q * 3.6e6, 4)),
            None => format!("in {}", quantity(s.time, "s")),
        };
        let with = match s.batch.run_up {
            RunUp::None => "",
            RunUp::Linear(_) | RunUp::Smooth(_) => ", the run-up at the same acceleration included",
            RunUp::Programme(_) => ", with all speeds of the programme in proportion to the last",
        };
        let (name, found) = (self.share(), demand.speed);
        let finding = match found {
            SpeedNeeded::Found { speed: 0.0, .. } => {
                Finding::info("speed_needed", format!("Gravity alone catches {name} {time}: no spin is needed, {{}}.")).value(0.0, "rad/s")
            }
            SpeedNeeded::Found { speed: w, bracket } => {
                Finding::info("speed_needed", format!("Catching {name} {time} takes at least {{}}{with}."))
                    .value(w, "rad/s")
                    .shown_as(w * RPM, "rpm")
                    .evidence("width of the bracket", bracket, "rad/s")
                    .evidence("places of the fixed set", s.batch.places as f64, "")
            }
            SpeedNeeded::None { highest } => {
                let text =
                    format!("None of the speeds computed, up to {} rpm, catches {name} {time}{with}.", significant(highest * RPM, 4));
                Finding::warning("speed_needed", text)
            }
        };
        let felt = match found {
            SpeedNeeded::Found { speed, .. } => gravity_felt(&s.vessel.separator, speed, s.suspension.medium.gravity),
            SpeedNeeded::None { .. } => None,
        };
        let doubt = felt.map(|field| {
            let text = format!(
                "At the speed needed the field is {{}} g at the innermost liquid; the model of a machine that liquid flows through leaves gravity out, which holds from {} g on.",
                significant(FIELD, 2)
            );
            Finding::warning("speed_needed_gravity", text).value(field, "").evidence("least field over gravity", FIELD, "")
        });
        std::iter::once(finding).chain(doubt).collect()
    }

    /// That no other speed was searched for.
    pub fn one_speed(&self) -> Finding {
        let text = format!(
            "The speed that catches {} and the sensitivities are not searched for: at up to {} times this speed every particle would be integrated with its \
             inertia. Use model = \"drifting\", which leaves the inertia out, or look at single speeds.",
            self.share(),
            significant(HIGHEST_SHOWN, 2)
        );
        Finding::info("speed_needed", text)
    }

    /// Tilt, field, cut size.
    pub fn describe(&self, mut out: Outcome) -> Outcome {
        let s = &self.study.task;
        let g = s.suspension.medium.gravity;
        let (r1, r2) = self.found.radii;
        if let (Separator::Cup(cup), Some(tilt)) = (&s.vessel.separator, self.found.tilt) {
            let text = if cup.held.is_some() {
                "The cup is held at a tilt of {}.".to_string()
            } else if tilt == 0.0 {
                "The cup hangs straight down ({}): it does not swing out at this speed.".to_string()
            } else {
                "The cup swings out to {} from the vertical.".to_string()
            };
            let swing = cup.hanging.swing_frequency(self.study.speed, tilt);
            let f = Finding::info("tilt", text).value(tilt, "rad").shown_as(tilt.to_degrees(), "°");
            out = out.finding(if cup.held.is_some() { f } else { f.evidence("frequency of its small swing", swing, "rad/s") });
        }
        let field = if self.study.speed == 0.0 {
            Finding::info("rcf", "Gravity alone acts: the field of the rotation is {} g.")
        } else {
            Finding::info(
                "rcf",
                format!("The field grows from {} g at the surface to {{}} g.", significant(measures::rcf(self.study.speed, r1, g), 4)),
            )
        };
        out = out.finding(field.value(measures::rcf(self.study.speed, r2, g), ""));
        let heavy = self.study.heavy();
        let d = cut_size(&self.found.products, &s.suspension.medium, self.study.median().density, 0.5, self.found.full_time);
        if d.is_finite() && d > 0.0 && self.stokes() {
            let kind = if heavy { "" } else { " (light particles)" };
            // sizes and times scale without inertia only, and a run-up counts by its field
            let how = match (&self.found.run_up, s.batch.model) {
                (Some(_), _) => ", by an estimate without inertia (run-up by the field at mean radius)",
                (None, Model::Drifting) => "",
                (None, _) => ", inertia left out",
            };
            out = out.finding(Finding::info("cut_size", format!("Half of the particles of {{}} are caught{kind}{how}.")).value(d, "m"));
        }
        out
    }

    /// The one particle released at a place.
    pub fn followed(&self) -> Option<Finding> {
        let s = self.study;
        let Released { exit, reynolds, .. } = self.found.released.as_ref()?;
        let Some(e) = exit else {
            return Some(Finding::warning("released", "The particle released never meets a surface."));
        };
        if e.time == 0.0 {
            return Some(Finding::warning("released", "The place of the release does not lie in the liquid."));
        }
        let text = format!(
            "The particle released reaches the {} after {{}}, at {} along the cup.",
            e.surface.word(),
            quantity(e.position[1], "m")
        );
        let finding = Finding::info("released", text)
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
