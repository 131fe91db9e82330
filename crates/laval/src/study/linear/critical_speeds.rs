//! Critical speeds: where a frequency of the machine is a multiple of its spin speed, and how they differ from the peaks of the response.
//!
//! Equations: `det T(growth + i k W, W) = 0` for (growth, W), which for an undamped machine is `det Z(i k W, W) = 0`; peaks of the unbalance response
//! `T(i W, W) X = F` are maxima of the amplitude over W and lie beside the critical speeds where there is damping.
//!
//! Symbols: W spin speed, rad/s; k order.
//!
//! Validity: small motions about the equilibrium; constant speed.
//!
//! Sources: `docs/theory/linear-vibration.md#critical-speeds`.

use super::campbell::{ORDERS, critical, critical_table, damping, follow, order, orders, special};
use super::growing::{Follows, unstable};
use super::numbering;
use super::over_frequency::{Crossings, crossings, growth_unassessed, over_frequency};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::part::Frozen;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, End, Finding, Kept, Outcome, SpecialPoint, Table};
use crate::solve::characteristic::Characteristic;
use crate::solve::criticals::{Critical, criticals};
use crate::solve::extrema::{Curve, Extremum, above, curve, seeds};
use crate::solve::linear_response::Response;
use crate::solve::rest::over_speed;
use crate::solve::sweep::{Count, Strongest};
use crate::study::shared::margins::resonant;
use crate::study::shared::operation;
use crate::study::shared::probes;
use crate::study::shared::region;
use crate::study::shared::size;
use crate::study::shared::speed_range::{SpinSpeeds, with_table_speeds};
use crate::study::shared::support::{About, EndStates, SPEED_RANGE, admit_eigenvalues, held, inconsistent, probe_name, range};
use crate::study::shared::vibration::Vibration;
use crate::study::{Context, Study};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// See the [module](self).
#[derive(Clone)]
pub struct CriticalSpeeds {
    /// Speeds searched, rad/s.
    pub speed: RangeValue,
    /// Multiples of the spin speed.
    pub orders: Vec<f64>,
    /// Smallest distance, relative, that the operating speed should keep.
    pub margin: f64,
}

impl Study for CriticalSpeeds {
    type Result = CriticalSpeedsResult;
    const KIND: &'static str = "critical_speeds";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm" }
margin = "20 %"
"#;
    const DOC: &'static str = "Critical speeds, solved for on the dynamic stiffness of the machine, with the peaks of the unbalance response beside \
        them and the distance to the operating speed.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds to search; 120 points unless given"),
        ORDERS,
        Field::optional(
            "margin",
            FieldKind::Quantity { unit: "", bounds: Bounds::up_to(1.0) },
            "",
            "distance from lightly damped critical speeds, relative to the operating speed, that it should keep; resonance_margin of [operation], clearance of [limits], or 15 %, where absent",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = range("speed", values.range("speed")?, 2, values, diagnostics)?;
        let margin = values.number("margin").or_else(|| operation::required_margin(system)).unwrap_or(operation::MARGIN);
        Some(CriticalSpeeds { speed, orders: orders(values, system), margin })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn vibration(&self, _: &System) -> Vibration {
        Vibration::Orders(self.orders.clone())
    }

    fn size(&self, system: &System) -> Option<size::Size> {
        Some(size::Size::of_spectra(self.speed.points.unwrap_or(120), system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_eigenvalues(system, About::Rest, self.speed.from)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<CriticalSpeedsResult, Diagnostic> {
        let state = over_speed(system);
        let (crossings, strongest) = if over_frequency(system) {
            (crossings(system, context, &self.speed, &self.orders)?, Vec::new())
        } else {
            let limit = above(self.speed.to * self.orders.iter().fold(0.0, |m: f64, &k| m.max(k)));
            let (mut found, end) = follow(system, context, &with_table_speeds(&self.speed, 120, system), limit)?;
            numbering::in_order(&mut found.branches, numbering::reference(system, &self.speed));
            let crossings = criticals(system, &state, &found, &self.orders);
            (Crossings { crossings, spectra: found.points.len() as u64, counts: found.counts, end }, found.strongest)
        };
        let Crossings { crossings, spectra, counts, mut end } = crossings;
        let own = held(system, Frozen::Order(1.0))?.filter(|_| self.orders.contains(&1.0));
        let (system, unbalanced) = (own.as_ref().unwrap_or(system), own.is_some() || !over_frequency(system));
        let (_, load) = Characteristic::new(system, &state(self.speed.to)?).loads();
        let forced = load.iter().any(|f| f.abs() > 0.0) && !system.probes().is_empty() && end.is_complete() && unbalanced;
        let mut response = None;
        if forced {
            let mut speeds = self.speed.linspace(200);
            let mut each = |done| context.goes_on(done);
            speeds.extend(seeds(system, &state, self.speed.from, self.speed.to, &mut each)?.speeds);
            let found = curve(system, &state, speeds, system.probes(), &mut each)?;
            if !found.complete {
                end = context.end(false);
            }
            response = Some(found);
        }
        let states = EndStates::find(state, self.speed.from, self.speed.to)?;
        Ok(CriticalSpeedsResult { crossings, strongest, spectra, counts, response, states, end })
    }

    fn report(&self, system: &System, result: &CriticalSpeedsResult, name: &str) -> Result<Outcome, Diagnostic> {
        let mut outcome = Outcome::new(Self::KIND, name).over("speed", "rad/s").end(result.end).work("eigenproblems", result.spectra);
        if let Some(f) = unstable(system, &result.strongest, &Follows::Speeds) {
            outcome = outcome.finding(f);
        }
        let peaks: Vec<Extremum> = result.response.iter().flat_map(|r| &r.extrema).filter(|e| e.maximum).copied().collect();
        let responses = result.response.as_ref().map_or(&[][..], |r| &r.points);
        let loose = loose(&result.crossings, &peaks, system.probes(), responses);
        let shown = Shown { study: self, system, result, peaks: &peaks, loose };
        outcome = shown.critical_speeds(outcome);
        outcome = shown.response_peaks(outcome);
        if let Some(f) = shown.margin() {
            outcome = outcome.finding(f);
        }
        outcome = growth_unassessed(system).into_iter().fold(outcome, Outcome::finding);
        for f in region::modes_followed(&result.counts, result.spectra as usize).into_iter().chain(result.states.remarks(system)) {
            outcome = outcome.finding(f);
        }
        outcome = outcome.table(critical_table(&result.crossings)?).table(shown.peak_table()?);
        outcome.checked().map_err(inconsistent)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// Critical speeds, and the response to unbalance beside them.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CriticalSpeedsResult {
    /// By order, then speed.
    pub crossings: Vec<Critical>,
    /// The mode that grows most at every speed computed.
    pub strongest: Vec<Strongest>,
    /// Speeds whose spectra were followed.
    pub spectra: u64,
    /// Of a machine too large for all its modes the speeds at which they were counted.
    pub counts: Vec<Count>,
    /// The response to unbalance; none where nothing forces the machine, or the search was stopped.
    pub response: Option<Curve>,
    /// States at the ends of the range.
    pub states: EndStates,
    /// How the study ended.
    pub end: End,
}

struct Shown<'a> {
    study: &'a CriticalSpeeds,
    system: &'a System,
    result: &'a CriticalSpeedsResult,
    /// Maxima of the response.
    peaks: &'a [Extremum],
    /// Those that belong to no critical speed.
    loose: Vec<&'a Extremum>,
}

impl Shown<'_> {
    fn forced(&self) -> bool {
        self.result.response.is_some()
    }

    fn complete(&self) -> bool {
        self.result.end.is_complete()
    }

    fn probe(&self, p: &Extremum) -> &Probe {
        &self.system.probes()[p.probe]
    }

    fn name(&self, p: &Extremum) -> String {
        probe_name(self.probe(p))
    }

    fn own_peak(&self, c: &Critical) -> Option<&Extremum> {
        own_peak(c, &self.result.crossings, self.peaks)
    }

    /// Adds what the unbalance response does beside a located critical speed.
    fn beside(&self, c: &Critical, finding: Finding) -> Finding {
        if !c.located() {
            return finding;
        }
        let finding = |word: &'static str| finding.arg("response", Arg::word(word));
        match self.own_peak(c) {
            _ if !self.forced() || c.order != 1.0 => finding("none"),
            Some(p) if p.unbounded => finding("unbounded").arg("body", probes::arg(self.probe(p))),
            Some(p) => finding("peak").arg("body", probes::arg(self.probe(p))).arg("peak", Arg::speed(p.speed)),
            None if !c.driven_by_unbalance() => finding("not_excited"),
            None => finding("no_peak"),
        }
    }

    fn critical_speeds(&self, mut outcome: Outcome) -> Outcome {
        for c in &self.result.crossings {
            let finding = self.beside(c, critical(c, "critical-speeds-critical-speed"));
            let finding = finding.evidence("relative defect of the dynamic stiffness", c.defect, "").evidence(
                if c.located() { "last Newton step" } else { "width of the bracket" },
                c.step,
                "rad/s",
            );
            let finding = match self.own_peak(c) {
                Some(p) => finding.evidence("peak of the response", p.speed, "rad/s"),
                None => finding,
            };
            outcome = outcome.finding(finding).special_point(special(c));
        }
        outcome
    }

    /// Peaks of the response, and that there are no critical speeds.
    fn response_peaks(&self, mut outcome: Outcome) -> Outcome {
        for p in &self.loose {
            let finding = if p.unbounded {
                Finding::info("response_peak", "critical-speeds-response-unbounded")
            } else {
                let amplitude = Arg::quantity(p.value, self.probe(p).unit());
                Finding::info("response_peak", "critical-speeds-response-peak").arg("amplitude", amplitude)
            };
            let finding = finding.of(self.name(p)).value(p.speed, "rad/s").arg("body", probes::arg(self.probe(p)));
            outcome = outcome.finding(finding.evidence("amplitude", p.value, self.probe(p).unit()));
        }
        if self.result.crossings.is_empty() {
            outcome = outcome.finding(match (self.complete(), self.loose.len()) {
                (true, 0) => Finding::info("no_critical_speed", "critical-speeds-none"),
                (true, n) => Finding::info("no_critical_speed", "critical-speeds-peaks-alone").arg("peaks", Arg::count(n)),
                _ => Finding::info("no_critical_speed", "critical-speeds-none-yet"),
            });
        }
        for p in self.peaks {
            let name = self.name(p);
            let point = SpecialPoint::new("response_peak", p.speed, p.bracket).of(&name);
            outcome = outcome.special_point(point.evidence(probes::size_of(self.probe(p)), p.value, self.probe(p).unit()));
        }
        outcome
    }

    /// Distance of the operating speeds from the nearest critical speed or peak, over the operating speed next to it.
    fn margin(&self) -> Option<Finding> {
        // a machine at rest has no distance in parts of its speed
        let w = self.system.machine.speed.filter(|w| *w != 0.0)?;
        let (a, b) = operation::among(&self.system.machine.extras).speed.unwrap_or((w, w));
        let beside = |x: f64| x.clamp(a.min(b), a.max(b));
        let distance = |x: f64| (x - beside(x)).abs() / beside(x).abs();
        let near = |x: &Critical, y: &Critical| distance(x.speed).total_cmp(&distance(y.speed));
        let lightly = || self.result.crossings.iter().filter(|c| resonant(damping(c)));
        let excited = |c: &&Critical| !self.forced() || c.order != 1.0 || self.own_peak(c).is_some();
        let peak = self.loose.iter().min_by(|a, b| distance(a.speed).total_cmp(&distance(b.speed)));
        let close = lightly().filter(excited).min_by(|a, b| near(a, b));
        let peak = peak.filter(|p| close.is_none_or(|c| distance(p.speed) < distance(c.speed)));
        // without any that the load excites the nearest of the others is named, and is no reason for a warning
        let (close, quiet) = match (peak, close) {
            (None, None) => (lightly().min_by(|a, b| near(a, b)), true),
            (None, c) => (c, false),
            _ => (None, false),
        };
        let speed = peak.map(|p| p.speed).or(close.map(|c| c.speed))?;
        let (w, distance) = (beside(speed), distance(speed));
        // which is the nearest, and whether the load excites it, is known of a whole search alone
        let near = self.complete() && !quiet && distance < self.study.margin;
        let finding = match (distance <= SAME, near) {
            (true, true) => Finding::warning("margin", "critical-speeds-no-margin"),
            (true, false) => Finding::info("margin", "critical-speeds-no-margin"),
            (false, true) => Finding::warning("margin", "critical-speeds-small-margin"),
            (false, false) => Finding::info("margin", "critical-speeds-margin"),
        };
        let finding = match close {
            None => finding.arg("nearest", Arg::word("peak")).arg("located", Arg::word("yes")),
            Some(c) => finding
                .arg("nearest", Arg::word("critical_speed"))
                .arg("order", order(c.order))
                .arg("located", Arg::word(if c.located() { "yes" } else { "no" })),
        };
        Some(
            finding
                .of("to the nearest critical speed, over the operating speed")
                .value_as(Arg::percent(distance))
                .arg("critical", Arg::speed(speed))
                .arg("operating", Arg::speed(w))
                .arg("required", Arg::percent(self.study.margin))
                .arg("excited", Arg::word(if quiet { "no" } else { "yes" }))
                .arg("search", Arg::word(if self.complete() { "complete" } else { "stopped" }))
                .evidence("margin requested", self.study.margin, "")
                .evidence("its speed", speed, "rad/s"),
        )
    }

    fn peak_table(&self) -> Result<Table, Diagnostic> {
        let peaks = self.peaks;
        let size = |tilt: bool| peaks.iter().map(|p| if self.probe(p).is_tilt() == tilt { p.value } else { f64::NAN }).collect();
        Table::new("response_peaks", "Maxima of the unbalance response")
            .names("body", "body, point of a body, or tilt of a body", peaks.iter().map(|p| self.name(p)).collect())
            .float("speed", "rad/s", "spin speed", peaks.iter().map(|p| p.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound, and of a tilt", size(false))
            .float("tilt", "rad", "semi-major axis of the tilt; NaN where it has no bound, and of a displacement", size(true))
            .build()
            .map_err(inconsistent)
    }
}

/// Distance of two speeds, over one of them, that is rounding.
const SAME: f64 = 1e-12;

/// Widths of a resonance within which a peak belongs to it.
const WIDTHS: f64 = 2.0;

/// A peak is beside a critical speed that unbalance can excite: within a few widths of its resonance.
fn beside(c: &Critical, p: &Extremum) -> bool {
    c.driven_by_unbalance() && (p.speed - c.speed).abs() <= WIDTHS * c.growth.abs() + 1e-6 * c.speed.abs()
}

/// The nearest peak of the response that belongs to a critical speed, and to no nearer one.
fn own_peak<'p>(c: &Critical, all: &[Critical], peaks: &'p [Extremum]) -> Option<&'p Extremum> {
    let distance = |c: &Critical, p: &Extremum| (c.speed - p.speed).abs();
    let nearest = peaks.iter().filter(|p| beside(c, p)).min_by(|a, b| distance(c, a).total_cmp(&distance(c, b)))?;
    let nearer = |o: &Critical| beside(o, nearest) && distance(o, nearest) < distance(c, nearest) - 1e-9 * nearest.speed.abs();
    (!all.iter().any(nearer)).then_some(nearest)
}

/// Share of the largest displacement (tilt) of the machine at a speed below which a peak of one body is no
/// resonance: beside a node of the deflection a body has antiresonances, and maxima between them.
const LEADING: f64 = 0.5;

/// The body moves as far there as others do.
fn leads(p: &Extremum, probes: &[Probe], responses: &[Response]) -> bool {
    let near = responses.partition_point(|r| r.speed < p.speed);
    let beside = responses[near.saturating_sub(1)..responses.len().min(near + 1)].iter();
    let nearest = beside.min_by(|a, b| (a.speed - p.speed).abs().total_cmp(&(b.speed - p.speed).abs()));
    let alike = |r: &Response| probes.iter().filter(|s| s.is_tilt() == probes[p.probe].is_tilt()).map(|s| r.size(s)).fold(0.0, f64::max);
    p.unbounded || nearest.is_none_or(|r| !(p.value < LEADING * alike(r)))
}

/// Peaks that belong to no critical speed: of those of several bodies at one speed the largest.
fn loose<'p>(all: &[Critical], peaks: &'p [Extremum], probes: &[Probe], responses: &[Response]) -> Vec<&'p Extremum> {
    const ONE: f64 = 0.02;
    let mut out: Vec<&Extremum> = Vec::new();
    let own = peaks.iter().filter(|p| !all.iter().any(|c| beside(c, p)));
    let mut own: Vec<&Extremum> = own.filter(|p| leads(p, probes, responses)).collect();
    // what has no bound is larger than any
    let size = |e: &Extremum| e.value / probes[e.probe].typical();
    own.sort_by(|a, b| b.unbounded.cmp(&a.unbounded).then(size(b).total_cmp(&size(a))));
    for p in own {
        if out.iter().all(|o| (o.speed - p.speed).abs() > ONE * p.speed.abs()) {
            out.push(p);
        }
    }
    out.sort_by_number(|a| a.speed);
    out
}
