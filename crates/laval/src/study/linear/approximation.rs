//! A machine whose parts have waves without number beside the same machine with parts in their place that have few: what the approximation gets right.
//!
//! Equations: both characteristic equations, `det T(s, W) = 0` of the machine and the eigenvalue problem of finite size that stands for it. Which waves are kept the part says
//! ([`approximation`](crate::model::capability::FrequencyDomain::approximation)).
//!
//! Symbols: W spin speed, rad/s; s = growth + i frequency.
//!
//! Validity: of the comparison that of both machines; roots of the approximation are held against the nearest root of the whole machine that was found.
//!
//! Theory: `docs/theory/approximate-methods.md#truncated-axial-waves`.
//!
//! Sources: `001_352384e7bf252e35` equation (37), corrected.

use crate::diagnostic::Diagnostic;
use crate::model::field::{Field, FieldKind, Values};
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Message, Outcome, Panel, Points, Table};
use crate::solve::pencil::{MachineMode, Spectrum};
use crate::solve::rest::over_speed;
use crate::solve::sweep::{Sweep, sweep};
use crate::study::Context;
use crate::study::shared::support::inconsistent;
use crate::text;
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};

/// Field: what the roots are held against.
pub(in crate::study) const COMPARE: Field = Field::optional(
    "compare",
    FieldKind::Choice(&[
        ("nothing", "only the machine as it is"),
        (
            "approximation",
            "the machine with few waves in place of waves without number, of parts that have such a form: of a liquid in three dimensions planar_tilt",
        ),
    ]),
    "nothing",
    "what the roots are drawn beside",
);

/// From the field.
pub(in crate::study) fn wanted(values: &Values) -> bool {
    values.choice("compare") == Some("approximation")
}

/// The approximation can be made.
///
/// # Errors
/// A machine without parts that have one, and one whose approximation is refused.
pub(in crate::study) fn admit(system: &System) -> Result<System, Diagnostic> {
    let made = system.approximation().ok_or_else(|| {
        Diagnostic::error("study.compare", text!("no part of this machine has an approximation to be compared with"))
            .help(text!("parts with waves without number have one; leave compare out otherwise"))
    })?;
    made.map_err(|d| {
        let why = d.into_error().message;
        Diagnostic::error("study.compare", text!("the approximation is no machine: {why}", why)).help(text!("leave compare out"))
    })
}

/// A mode of the approximation at a speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// Branch of the approximation.
    pub branch: usize,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// The mode.
    pub mode: MachineMode,
    /// Distance from the nearest root of the whole machine, 1/s; NaN where it has none.
    pub distance: f64,
    /// That root.
    pub nearest: C64,
}

impl Row {
    /// Distance over the size of the root.
    fn share(&self) -> f64 {
        self.distance / self.mode.value.abs()
    }
}

/// The approximation beside the whole machine.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Approximation {
    /// By branch, then speed.
    pub rows: Vec<Row>,
    /// Number of branches.
    pub branches: usize,
    /// Degree of its characteristic polynomial.
    pub degree: usize,
    /// Largest of the speeds computed, rad/s.
    pub fastest: f64,
    /// Speed and growth rate where the whole machine grows most, and the same of the approximation.
    pub most: Option<[(f64, f64); 2]>,
}

/// Distance from a root of the whole machine, over its size, within which a mode of the approximation meets it.
const MET: f64 = 0.01;

/// How far a root of the approximation is from the nearest root of the machine that whirls alike.
fn apart(mode: &MachineMode, whole: &Spectrum) -> (f64, C64) {
    let signed = |m: &MachineMode| if m.forward_share < 0.5 { m.value.conj() } else { m.value };
    let own = signed(mode);
    let distance = |m: &MachineMode| (signed(m) - own).abs().min((signed(m).conj() - own).abs());
    let nearest = whole.modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map_or((f64::NAN, C64::zero()), |m| (distance(m), m.value))
}

/// Follows the roots of the approximation over the speeds at which those of the machine were found.
///
/// # Errors
/// As [`admit`], and as the eigenvalue problem.
pub(in crate::study) fn compare(system: &System, whole: &Sweep, context: &Context) -> Result<Approximation, Diagnostic> {
    let other = admit(system)?;
    let speeds: Vec<f64> = whole.points.iter().map(|p| p.0).collect();
    let found = sweep(&other, &over_speed(&other), &speeds, f64::INFINITY, |_, solved| context.goes_on(solved))?;
    let all = found.branches.iter().enumerate().flat_map(|(k, b)| b.points.iter().map(move |(w, m)| (k, *w, m)));
    let rows = all.filter_map(|(branch, speed, m)| {
        let spectrum = whole.points.iter().find(|p| p.0 == speed)?;
        let (distance, nearest) = apart(m, &spectrum.1);
        Some(Row { branch, speed, mode: m.clone(), distance, nearest })
    });
    let largest = |s: &Sweep| {
        let all = s.points.iter().filter_map(|p| Some((p.0, p.1.least_stable()?.value.re)));
        all.max_by(|a, b| a.1.total_cmp(&b.1))
    };
    Ok(Approximation {
        rows: rows.collect(),
        branches: found.branches.len(),
        degree: found.points.first().map_or(0, |p| p.1.modes.iter().map(|m| if m.value.im > 0.0 { 2 } else { 1 }).sum::<usize>()),
        fastest: speeds.iter().fold(0.0f64, |m, w| m.max(w.abs())),
        most: largest(whole).zip(largest(&found)).map(|(exact, rough)| [exact, rough]),
    })
}

impl Approximation {
    /// Adds the roots of the approximation to those of the machine, as a table, a figure and findings.
    ///
    /// # Errors
    /// A table that contradicts itself.
    pub(in crate::study) fn add(&self, outcome: Outcome) -> Result<Outcome, Diagnostic> {
        let outcome = self.findings().into_iter().fold(outcome, Outcome::finding);
        Ok(outcome.table(self.table()?).figure(self.figure()))
    }

    fn findings(&self) -> Vec<Finding> {
        let (rows, degree) = (&self.rows, self.degree);
        let mut out = Vec::new();
        // the mode that is best met, and the one that is worst
        let share = |k: usize| {
            let own = rows.iter().filter(|r| r.branch == k);
            own.map(Row::share).fold(0.0f64, |m, x| if x > m || x.is_nan() { x } else { m })
        };
        let met = (0..self.branches).filter(|&k| share(k) < MET).count();
        if let Some(r) = rows.iter().max_by(|a, b| a.share().total_cmp(&b.share())) {
            out.push(
                Finding::info("approximation", "approximation-modes")
                    .value_as(Arg::percent(r.share()))
                    .arg("met", Arg::count(met))
                    .arg("modes", Arg::count(self.branches))
                    .arg("degree", Arg::count(degree))
                    .arg("within", Arg::percent(MET))
                    .arg("speed", Arg::speed(r.speed))
                    .arg("frequency", Arg::frequency(r.mode.frequency()).digits(5))
                    .arg("growth", Arg::quantity(r.mode.growth(), "1/s"))
                    .arg("whole_frequency", Arg::frequency(r.nearest.im.abs()).digits(5))
                    .arg("whole_growth", Arg::quantity(r.nearest.re, "1/s"))
                    .evidence("degree", degree as f64, "")
                    .evidence("modes within 1 %", met as f64, ""),
            );
        }
        if let Some([exact, rough]) = self.most {
            let growth = |x: f64| Arg::quantity(x, "1/s").digits(4);
            out.push(
                Finding::info("approximate_growth", "approximation-growth")
                    .value(rough.1 - exact.1, "1/s")
                    .arg("whole_speed", Arg::speed(exact.0))
                    .arg("whole_growth", growth(exact.1))
                    .arg("speed", Arg::speed(rough.0))
                    .arg("growth", growth(rough.1)),
            );
        }
        out
    }

    fn table(&self) -> Result<Table, Diagnostic> {
        let rows = &self.rows;
        let column = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
        Table::new("approximate_modes", "Modes of the approximation, each with the nearest root of the whole machine")
            .float("speed", "rad/s", "spin speed", column(&|r| r.speed))
            .int("mode", "", "branch of the approximation", rows.iter().map(|r| r.branch as i64 + 1).collect())
            .text("whirl", "direction of whirl", rows.iter().map(|r| r.mode.whirl.word().into()).collect())
            .float("frequency", "rad/s", "frequency", column(&|r| r.mode.frequency()))
            .float("growth", "1/s", "growth rate", column(&|r| r.mode.growth()))
            .float("whole_frequency", "rad/s", "frequency of the nearest root of the whole machine", column(&|r| r.nearest.im.abs()))
            .float("whole_growth", "1/s", "its growth rate", column(&|r| r.nearest.re))
            .float("distance", "1/s", "distance of the two in the plane of s", column(&|r| r.distance))
            .build()
            .map_err(inconsistent)
    }

    fn figure(&self) -> Figure {
        let top = 1.25 * self.fastest;
        let degree = || Message::new("approximation-degree").arg("degree", Arg::count(self.degree));
        let frequency = Panel::new(Axis::new("frequency", "rad/s").range(0.0, top))
            .mark(Line::new("modes", "speed", "frequency").group("mode").reference())
            .mark(Points::new("approximate_modes", "speed", "frequency").name(degree()));
        let growth = Panel::new(Axis::new("growth rate", "1/s"))
            .mark(Line::new("modes", "speed", "growth").group("mode").reference())
            .mark(Points::new("approximate_modes", "speed", "growth").name(degree()));
        let alt = Message::new("approximation-alt").arg("degree", Arg::count(self.degree));
        Figure::new("approximation", "The whole machine and its approximation", alt)
            .x(Axis::new("spin speed", "rad/s"))
            .panel(frequency)
            .panel(growth)
    }
}
