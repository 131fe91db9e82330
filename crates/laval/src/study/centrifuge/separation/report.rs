//! What a separation study tells.

use super::Separation;
use super::result::Separated;
use super::tables::{sensitivity_table, validity_table};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Outcome, OutcomeError};
use crate::separation::exit::Surface;
use crate::separation::particle::Drag;
use crate::separation::validity::{Case, Flag, flags};
use crate::study::Study;
use crate::study::centrifuge::cups::uncarried;

pub(super) struct Shown<'a> {
    pub study: &'a Separation,
    pub found: &'a Separated,
}

pub(super) type Built<T> = Result<T, OutcomeError>;

impl Shown<'_> {
    pub fn outcome(&self, system: &System, name: &str) -> Result<Outcome, Diagnostic> {
        let (study, s) = (self.study, &self.study.task);
        let mut out = Outcome::new(Separation::KIND, name).work("particles", self.found.exits.len() as u64);
        out = self.recovered(out);
        if let Some(demand) = &self.found.demand {
            out = self.speed_findings(demand).into_iter().fold(out, Outcome::finding);
        } else if study.speed != 0.0 {
            out = out.finding(self.one_speed());
        }
        out = self.describe(out);
        let assessed = self.assessed();
        out = assessed.iter().filter(|f| f.raised()).map(raised).fold(out, Outcome::finding);
        if !system.stations().is_empty() {
            out = uncarried(system, Some(&s.vessel.name)).into_iter().fold(out, Outcome::finding);
        }
        out = self.followed().into_iter().fold(out, Outcome::finding);
        out = self.tables(out, &assessed).map_err(Diagnostic::from)?;
        self.figures(out).checked().map_err(Diagnostic::from)
    }

    fn tables(&self, out: Outcome, assessed: &[Flag]) -> Built<Outcome> {
        let mut out = out.table(self.efficiency_table()?);
        out = out.table(self.measures_table()?);
        if self.stokes() {
            let (grade, cuts) = self.grade_tables()?;
            out = out.table(grade).table(cuts);
        }
        if let Some(demand) = &self.found.demand {
            out = out.table(self.demand_table(demand)?).table(sensitivity_table(demand)?);
        }
        out = out.table(validity_table(assessed)?);
        let more = [self.pellet_table()?, self.paths_table()?, self.released_table()?];
        Ok(more.into_iter().flatten().fold(out, Outcome::table))
    }

    /// The numbers that bound the model.
    fn assessed(&self) -> Vec<Flag> {
        let (s, exits) = (&self.study.task, &self.found.exits);
        let wall = exits.iter().filter(|e| e.is_some_and(|e| e.surface == Surface::Wall)).count() as f64 / exits.len() as f64;
        flags(&Case {
            separator: &s.vessel.separator,
            medium: &s.suspension.medium,
            particle: &self.study.median(),
            speed: self.study.speed,
            reynolds: self.found.reynolds,
            wall_share: wall,
            ramp: self.duration(),
            temperature: s.suspension.temperature,
        })
    }

    /// Duration of the run-up that particles settle on, s.
    pub fn duration(&self) -> f64 {
        self.found.run_up.map_or(0.0, |r| r.duration)
    }

    /// Sizes and times scale with each other.
    pub fn stokes(&self) -> bool {
        self.study.task.suspension.medium.drag == Drag::Stokes
    }

    /// Liquid flows through.
    pub fn flow(&self) -> bool {
        self.study.task.throughput.is_some()
    }
}

/// A number beyond its limit.
fn raised(f: &Flag) -> Finding {
    let id = format!("validity_{}", f.name.replace([' ', '-'], "_"));
    let finding = if f.value.is_finite() {
        Finding::warning(id, "separation-validity").value(f.value, "")
    } else {
        Finding::warning(id, "separation-validity-undefined")
    };
    finding.arg("name", Arg::term(f.name)).arg("limit", Arg::number(f.limit)).arg("meaning", Arg::term(f.meaning))
}
