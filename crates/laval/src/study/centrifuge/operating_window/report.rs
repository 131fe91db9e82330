//! What an operating window tells.

use super::margins::NAMES;
use super::request::{policy, requested};
use super::{Found, OperatingWindow, Policy};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Message, Outcome, OutcomeError, SpecialPoint, Status};
use crate::study::Study;
use crate::study::centrifuge::cups::task::Task;
use crate::study::shared::limits::Limits;

pub(super) struct Shown<'a> {
    pub study: &'a OperatingWindow,
    pub system: &'a System,
    pub found: &'a Found,
    pub task: Option<Task>,
    pub limits: Limits,
    pub policy: Policy,
    /// Time of the run-up to the top of the range, s.
    pub ramp: Option<f64>,
}

pub(super) type Built<T> = Result<T, OutcomeError>;

/// A requirement, or the range of speeds, as a phrase; `flow`: of a machine that liquid flows through.
pub(super) fn requirement(name: &str, flow: bool) -> Message {
    let name = NAMES.iter().find(|n| **n == name).map_or("range", |n| *n);
    let name = if flow && name == "separation" { "residence" } else { name };
    Message::new("operating-window-requirement").arg("name", Arg::word(name))
}

impl<'a> Shown<'a> {
    pub fn new(study: &'a OperatingWindow, system: &'a System, found: &'a Found) -> Result<Self, Diagnostic> {
        let (task, limits) = requested(study, system)?;
        Ok(Shown { study, system, found, task, limits, policy: policy(&study.values), ramp: study.values.number("ramp") })
    }

    pub fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let m = &self.found.main;
        let mut out = Outcome::new(OperatingWindow::KIND, name).over("speed", "rad/s").work("speeds", m.points.len() as u64);
        if let Some(p) = &m.passage {
            out = out.work("steps of the passage", p.steps);
        }
        let missing = self.study.missing(self.found);
        if !missing.is_empty() {
            let part = |word: &&'static str| Message::new("operating-window-missing").arg("part", Arg::word(word)).into();
            let parts = Arg::List(missing.iter().map(part).collect());
            out = out.finding(Finding::warning("incomplete", "operating-window-incomplete").arg("parts", parts));
        }
        out = if m.intervals.is_empty() { self.conflict(out) } else { self.windows(out) };
        out = self.recommended(out);
        out = self.shortest(out);
        out = self.remarks(out);
        for (k, i) in m.intervals.iter().enumerate() {
            for (e, kind) in [(&i.low, "window_low"), (&i.high, "window_high")] {
                let other = e.speed + if kind == "window_low" { -e.bracket } else { e.bracket };
                out = out.special_point(
                    SpecialPoint::new(kind, e.speed, (e.speed.min(other), e.speed.max(other)))
                        .status(if e.event == "domain limit" { Status::Bracketed } else { Status::Located })
                        .evidence("interval", (k + 1) as f64, ""),
                );
            }
        }
        let mut build = || -> Built<()> {
            let mut made = out
                .clone()
                .table(self.margins_table()?)
                .table(self.bars_table()?)
                .table(self.points_table()?)
                .table(self.intervals_table()?);
            if let Some(t) = self.trade_table()? {
                made = made.table(t);
            }
            if let Some(t) = self.map_table()? {
                made = made.table(t);
            }
            out = made;
            Ok(())
        };
        build().map_err(Diagnostic::from)?;
        self.figures(out).checked().map_err(Diagnostic::from)
    }

    /// The throughput, m^3/s, and the volume, m^3, of a machine that liquid flows through.
    pub fn flow(&self) -> Option<(f64, f64)> {
        let task = self.task.as_ref()?;
        task.throughput.zip(task.vessel.separator.flow_volume())
    }
}
