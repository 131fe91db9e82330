//! Limits of standards on the vibration of the shaft in its bearings, beside a linear response.

use super::report::Shown;
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Finding, Line, Message, Table};
use crate::study::shared::journals::JournalVibration;
use crate::study::shared::operation;
use crate::study::shared::standards::{VibrationStandard, Zone};
use crate::study::shared::support::inconsistent;

/// Columns of the boundaries over the speed, with their meanings: half of the value peak to peak, as amplitudes are.
const ZONES: [(&str, &str); 3] = [
    ("zone_ab", "amplitude at the boundary of zones A and B (ISO 7919-3)"),
    ("zone_bc", "amplitude at the boundary of zones B and C (ISO 7919-3)"),
    ("zone_cd", "amplitude at the boundary of zones C and D (ISO 7919-3)"),
];
const LIMIT: (&str, &str) = ("api_limit", "amplitude at the limit of API 617");

impl Shown<'_> {
    fn standard(&self) -> Option<VibrationStandard> {
        operation::among(&self.system.machine.extras).shaft_vibration.filter(|_| !self.result.journals.is_empty())
    }

    /// The journal that uses most of its limit.
    fn worst(&self, standard: VibrationStandard) -> Option<&JournalVibration> {
        let used = |v: &JournalVibration| if v.peak_to_peak.is_nan() { f64::INFINITY } else { v.peak_to_peak / standard.limit(v.speed) };
        self.result.journals.iter().max_by(|a, b| used(a).total_cmp(&used(b)))
    }

    pub(super) fn shaft_vibration(&self) -> Option<Finding> {
        let standard = self.standard()?;
        let v = self.worst(standard)?;
        let name = &self.system.slots()[v.slot].name;
        if !standard.covers(v.speed) {
            return Some(Finding::info("shaft_vibration", "forced-response-shaft-vibration-outside").arg("speed", Arg::speed(v.speed)));
        }
        let zone = standard.zone(v.speed, v.peak_to_peak);
        let finding = match zone {
            Zone::A | Zone::B => Finding::info("shaft_vibration", "forced-response-shaft-vibration"),
            _ => Finding::warning("shaft_vibration", "forced-response-shaft-vibration-broken"),
        };
        let finding = finding
            .of(name.clone())
            .value(v.peak_to_peak, "m")
            .arg("part", Arg::name(name))
            .arg("standard", Arg::word(standard.word()))
            .arg("zone", Arg::word(zone.word()))
            .arg("limit", Arg::quantity(standard.limit(v.speed), "m"))
            .arg("speed", Arg::speed(v.speed));
        let all = standard.boundaries(v.speed);
        let over = |b: f64| v.peak_to_peak / b;
        Some(finding.evidence("over the limit", over(standard.limit(v.speed)), "").evidence(
            "over the highest boundary",
            over(all[all.len() - 1]),
            "",
        ))
    }

    /// Every journal, where it uses most of the limit.
    pub(super) fn journals_table(&self) -> Result<Option<Table>, Diagnostic> {
        let Some(standard) = self.standard() else { return Ok(None) };
        let rows = &self.result.journals;
        let limit = |v: &JournalVibration| if standard.covers(v.speed) { standard.limit(v.speed) } else { f64::NAN };
        let zone = |v: &JournalVibration| match () {
            () if !standard.covers(v.speed) => "not covered",
            () if standard.has_zones() => standard.zone(v.speed, v.peak_to_peak).word(),
            () if standard.zone(v.speed, v.peak_to_peak) == Zone::A => "kept",
            () => "exceeded",
        };
        let column = |f: &dyn Fn(&JournalVibration) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
        let table =
            Table::new("journals", "Vibration of the shaft relative to its bearings, at the operating speed that uses most of the limit")
                .names("support", "bearing, or other support", rows.iter().map(|v| self.system.slots()[v.slot].name.clone()).collect())
                .float("speed", "rad/s", "operating speed", column(&|v| v.speed))
                .float(
                    "peak_to_peak",
                    "m",
                    "relative displacement, peak to peak, in the direction in which it is largest",
                    column(&|v| v.peak_to_peak),
                )
                .float(
                    "limit",
                    "m",
                    "limit of unrestricted operation, peak to peak; NaN at a speed that the standard does not cover",
                    column(&limit),
                )
                .text("zone", "zone of ISO 7919-3, or whether the limit of API 617 is kept", rows.iter().map(|v| zone(v).into()).collect());
        table.build().map_err(inconsistent).map(Some)
    }

    /// Boundaries over the speed, as amplitudes.
    pub(super) fn boundaries(&self) -> Vec<(&'static str, &'static str, Vec<f64>)> {
        let Some(standard) = self.standard().filter(|_| !self.study.speed.is_one()) else { return Vec::new() };
        let columns: &[(&'static str, &'static str)] = if standard == VibrationStandard::Zones { &ZONES } else { &[LIMIT] };
        let at = |k: usize, w: f64| if standard.covers(w) { 0.5 * standard.boundaries(w)[k] } else { f64::NAN };
        let points = &self.result.curve.points;
        columns.iter().enumerate().map(|(k, (name, doc))| (*name, *doc, points.iter().map(|r| at(k, r.speed)).collect())).collect()
    }

    /// The same in the figure.
    pub(super) fn boundary_lines(&self) -> Vec<Line> {
        let known = self.boundaries().into_iter().filter(|b| b.2.iter().any(|x| x.is_finite()));
        known
            .map(|(name, ..)| {
                Line::new("response", "speed", name).name(Message::new("forced-response-boundary").arg("line", Arg::word(name)))
            })
            .collect()
    }
}
