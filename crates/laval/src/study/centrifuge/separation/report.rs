//! What a separation study tells: findings.

use super::Separation;
use super::demand::HIGHEST_SHOWN;
use super::tables::validity_table;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Finding, Outcome, OutcomeError, quantity, significant};
use crate::separation::batch::Spinning;
use crate::separation::ensemble::{Model, cut_size, products, sorted};
use crate::separation::exit::{Exit, Surface};
use crate::separation::machine::Separator;
use crate::separation::measures;
use crate::separation::particle::{Drag, Particle};
use crate::separation::recovery::{Needed, Recovery, Watch};
use crate::separation::slowest::Last;
use crate::separation::validity::{Case, flags};
use crate::study::centrifuge::cups::task::lost;
use crate::study::centrifuge::cups::uncarried;
use crate::study::shared::support::RPM;
use crate::study::{Context, Study};

/// Results of the ensemble.
pub(super) struct EnsembleResult<'a> {
    pub study: &'a Separation,
    pub spinning: &'a Spinning<'a>,
    pub recovery: Recovery<'a>,
    pub exits: Vec<Option<Exit>>,
    pub watch: Watch<'a>,
    /// Whether to go on; counts no path.
    pub goes_on: Watch<'a>,
    caught: f64,
    needed: Needed,
    /// When the last particle is caught, where the whole fixed set is.
    last: Option<Last>,
}

pub(super) type Built<T> = Result<T, OutcomeError>;

/// Share that counts as the whole of the fixed set.
const ALL: f64 = 1.0 - 1e-9;

impl<'a> EnsembleResult<'a> {
    /// `watch` receives every path; both say whether to go on.
    pub fn new(
        study: &'a Separation,
        spinning: &'a Spinning<'a>,
        exits: Vec<Option<Exit>>,
        (watch, goes_on): (Watch<'a>, Watch<'a>),
    ) -> Result<Self, Diagnostic> {
        let mut recovery = Recovery::watched(spinning, Some(&exits), watch).map_err(lost)?;
        let needed = recovery.needed(study.task.recovery).map_err(lost)?;
        let caught = recovery.caught(study.task.time).map_err(lost)?;
        let last = if caught >= ALL { spinning.last().map_err(lost)? } else { None };
        recovery.learn(&exits);
        Ok(EnsembleResult { study, spinning, recovery, exits, watch, goes_on, caught, needed, last })
    }

    pub fn outcome(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let (study, s) = (self.study, &self.study.task);
        let mut out = Outcome::new(Separation::KIND, context.name).work("particles", self.spinning.crowd.len() as u64);
        out = self.recovered(out);
        let name = self.share();
        if self.any_speed() {
            out = self.speed_findings(&name).into_iter().fold(out, Outcome::finding);
        } else if study.speed != 0.0 {
            let text = format!(
                "The speed that catches {name} and the sensitivities are not searched for: at up to {} times this speed every particle would be integrated with its \
                 inertia. Use model = \"drifting\", which leaves the inertia out, or look at single speeds.",
                significant(HIGHEST_SHOWN, 2)
            );
            out = out.finding(Finding::info("speed_needed", text));
        }
        out = self.describe(out);
        let wall = self.exits.iter().filter(|e| e.is_some_and(|e| e.surface == Surface::Wall)).count() as f64 / self.exits.len() as f64;
        let judged = flags(&Case {
            separator: &s.vessel.separator,
            medium: &s.suspension.medium,
            particle: &self.median(),
            speed: study.speed,
            reynolds: self.reynolds(),
            wall_share: wall,
            ramp: self.spinning.duration(),
            temperature: s.suspension.temperature,
        });
        for f in judged.iter().filter(|f| f.raised()) {
            let text = format!("Validity ({}): {}; {{}} where the limit is {}.", f.name, f.meaning, significant(f.limit, 3));
            let id = format!("validity_{}", f.name.replace([' ', '-'], "_"));
            let finding = if f.value.is_finite() {
                Finding::warning(id, text).value(f.value, "")
            } else {
                Finding::warning(id, text.replace("{}", "no number"))
            };
            out = out.finding(finding);
        }
        if !system.bodies().is_empty() {
            out = uncarried(system, Some(&s.vessel.name)).into_iter().fold(out, Outcome::finding);
        }
        let paths = self.paths()?;
        let built = || -> Built<Outcome> {
            let mut out = out.table(self.efficiency_table()?);
            out = out.table(self.measures_table()?);
            if self.stokes() {
                let (grade, cuts) = self.grade_tables()?;
                out = out.table(grade).table(cuts);
            }
            if self.any_speed() {
                let (demand, sensitivity) = self.demand_tables()?;
                out = out.table(demand).table(sensitivity);
            }
            out = out.table(validity_table(&judged)?);
            if let Some(t) = self.pellet_table()? {
                out = out.table(t);
            }
            if let Some(t) = Self::paths_table(&paths)? {
                out = out.table(t);
            }
            Ok(out)
        };
        let mut out = built().map_err(Diagnostic::from)?;
        out = self.followed(out)?;
        out = self.figures(out);
        out.checked().map_err(Diagnostic::from)
    }

    /// The share to be caught, in words.
    fn share(&self) -> String {
        let percent = format!("{} %", significant(100.0 * self.study.task.recovery, 4));
        match self.study.task.batch.from {
            Some(d) => format!("{percent} of the particles from {} on", quantity(d, "m")),
            None => percent,
        }
    }

    /// How much is caught, and what the recovery takes.
    fn recovered(&self, out: Outcome) -> Outcome {
        let s = &self.study.task;
        let what = s.vessel.separator.word().replace('_', " ");
        let still = self.study.speed == 0.0;
        let rpm = format!("{} rpm", significant(self.study.speed * RPM, 4));
        let speed = if still { "without spin".to_string() } else { format!("at {rpm}") };
        let run_up = match self.spinning.duration() {
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
        let places = self.spinning.crowd.len() as f64;
        let of = match s.batch.from {
            Some(d) => format!("particles from {} on", quantity(d, "m")),
            None => "particles".to_string(),
        };
        let late = self.last.filter(|l| !(l.time <= s.time));
        let text = match late {
            None => format!("{{}} of the {of} are caught {at} ({what})."),
            Some(l) if l.time.is_finite() => format!(
                "All of the fixed set, nearly {{}} of the {of}, are caught {at} ({what}); the last ones would take {}.",
                quantity(l.time, "s")
            ),
            Some(_) => format!("All of the fixed set, nearly {{}} of the {of}, are caught {at} ({what}); some are never caught."),
        };
        let mut caught = Finding::info("caught", text)
            .value(self.caught, "")
            .shown_as(100.0 * self.caught, "%")
            .evidence("places of the fixed set", places, "")
            .evidence("share of one place", 1.0 / places, "");
        if let Some(l) = self.last.filter(|l| l.time.is_finite()) {
            caught = caught.evidence("the last one leaves after", l.time, "s");
        }
        let out = out.finding(caught);
        let (name, needed) = (self.share(), self.needed);
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

    /// Sizes and times scale with each other.
    pub fn stokes(&self) -> bool {
        self.study.task.suspension.medium.drag == Drag::Stokes
    }

    /// The particle of median size and density.
    pub fn median(&self) -> Particle {
        let p = &self.study.task.suspension.powder;
        Particle { radius: 0.5 * p.size.quantile(0.5), density: p.density.quantile(0.5) }
    }

    /// Largest Reynolds number of the particles of the set, at their exits.
    fn reynolds(&self) -> f64 {
        let batch = self.spinning.batch;
        let mut worst = 0.0f64;
        for (m, e) in self.spinning.crowd.iter().zip(&self.exits) {
            let Some(e) = e else { continue };
            let speed = e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
            let re = batch.medium.reynolds(&batch.powder.particle(&m.point), speed);
            if !(re <= worst) {
                worst = re;
            }
        }
        worst
    }

    /// Tilt, field, cut size.
    fn describe(&self, mut out: Outcome) -> Outcome {
        let s = &self.study.task;
        let g = s.suspension.medium.gravity;
        let (r1, r2) = self.spinning.turning.radii();
        if let (Separator::Cup(cup), Some(tilt)) = (&s.vessel.separator, self.spinning.turning.tilt()) {
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
        let (taus, heavy) = self.products();
        let d = cut_size(&taus, &s.suspension.medium, self.median().density, 0.5, self.full_time());
        if d.is_finite() && d > 0.0 && self.stokes() {
            let kind = if heavy { "" } else { " (light particles)" };
            // sizes and times scale without inertia only, and a run-up counts by its field
            let how = match (&self.spinning.ramp, s.batch.model) {
                (Some(_), _) => ", by an estimate without inertia (run-up by the field at mean radius)",
                (None, Model::Drifting) => "",
                (None, _) => ", inertia left out",
            };
            out = out.finding(Finding::info("cut_size", format!("Half of the particles of {{}} are caught{kind}{how}.")).value(d, "m"));
        }
        out
    }

    /// The time at hand, counted at full speed.
    pub fn full_time(&self) -> f64 {
        self.spinning.clock.counted(self.study.task.time)
    }

    /// Sorted products tau of the members without inertia, and whether particles are heavy.
    pub fn products(&self) -> (Vec<f64>, bool) {
        let heavy = self.median().density > self.study.task.suspension.medium.density;
        let sign = if heavy { 1.0 } else { -1.0 };
        let found = products(&self.spinning.turning, &self.spinning.crowd, sign);
        (sorted(found.into_iter().map(|p| p.map(|p| p.0))), heavy)
    }
}
