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

use super::campbell::{ORDERS, bracketed, critical_table, damping, damping_words, follow, orders, special};
use super::growing::{Follows, unstable};
use super::modes::WHIRLS;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Axis, End, Figure, Finding, Outcome, Panel, Points, Rule, SpecialPoint, Table, quantity};
use crate::solve::characteristic::Characteristic;
use crate::solve::criticals::{Critical, criticals};
use crate::solve::extrema::{Curve, Extremum, above, curve, seeds};
use crate::solve::linear_response::Response;
use crate::solve::rest::rest;
use crate::solve::sweep::Strongest;
use crate::study::shared::size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{About, EndStates, SPEED_RANGE, admit_eigenvalues, inconsistent, moves, probe_name, range};
use crate::study::{Context, Study};
use serde::{Deserialize, Serialize};

/// See the [module](self).
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
margin = 0.15
"#;
    const DOC: &'static str = "Critical speeds, solved for on the dynamic stiffness of the machine, with the peaks of the unbalance response beside \
        them and the distance to the operating speed.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds to search; 120 points unless given"),
        ORDERS,
        Field::optional(
            "margin",
            FieldKind::Quantity { unit: "", bounds: Bounds::up_to(1.0) },
            "0.15",
            "distance from lightly damped critical speeds, relative to the operating speed, that it should keep",
        ),
    ];

    fn build(values: &Values, _: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = range("speed", values.range("speed")?, 2, values, diagnostics)?;
        Some(CriticalSpeeds { speed, orders: orders(values), margin: values.number("margin").unwrap_or(0.15) })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<size::Size> {
        Some(size::Size::of_spectra(self.speed.points.unwrap_or(120), system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_eigenvalues(system, About::Rest, self.speed.from)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<CriticalSpeedsResult, Diagnostic> {
        let state = |w: f64| rest(system, w);
        let limit = above(self.speed.to * self.orders.iter().fold(0.0, |m: f64, &k| m.max(k)));
        let (found, mut end) = follow(system, context, &self.speed.linspace(120), limit)?;
        let crossings = criticals(system, &state, &found, &self.orders);
        let (_, load) = Characteristic::new(system, &state(self.speed.to)?).loads();
        let forced = load.iter().any(|f| f.abs() > 0.0) && !system.probes().is_empty() && end.is_complete();
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
        Ok(CriticalSpeedsResult { crossings, strongest: found.strongest, spectra: found.points.len() as u64, response, states, end })
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
        for f in result.states.remarks(system) {
            outcome = outcome.finding(f);
        }
        outcome = outcome.table(critical_table(&result.crossings)?).table(shown.peak_table()?);
        if !result.crossings.is_empty() {
            outcome = outcome.figure(shown.figure());
        }
        outcome.checked().map_err(inconsistent)
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

    fn subject(&self, p: &Extremum) -> String {
        match self.probe(p).is_tilt() {
            true => format!("the {}", self.name(p)),
            false => format!("the response of {}", self.name(p)),
        }
    }

    fn own_peak(&self, c: &Critical) -> Option<&Extremum> {
        own_peak(c, &self.result.crossings, self.peaks)
    }

    fn critical_speeds(&self, mut outcome: Outcome) -> Outcome {
        for c in &self.result.crossings {
            let beside = match self.own_peak(c) {
                _ if !self.forced() || c.order != 1.0 => String::new(),
                Some(p) if p.unbounded => format!("; there {} has no bound", self.subject(p)),
                Some(p) => format!("; {} peaks at {}", self.subject(p), quantity(p.speed, "rad/s")),
                None if !c.driven_by_unbalance() => "; in this machine unbalance does not excite it".into(),
                None => "; the unbalance response has no peak there".into(),
            };
            let whirl = c.whirl.of("whirl", c.forward_share);
            let finding = if c.located() {
                let text = format!("Critical speed of order {} at {{}}: {whirl}, {}{beside}.", c.order, damping_words(c));
                Finding::info("critical_speed", text).of(format!("order {} {}", c.order, c.whirl.word())).value(c.speed, "rad/s")
            } else {
                bracketed(c)
            };
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
            let text = format!(
                "The unbalance response peaks at {{}}, where the frequency of no mode equals the speed: {}.",
                if p.unbounded { format!("{} has no bound there", self.subject(p)) } else { moves(self.probe(p), p.value) }
            );
            let finding = Finding::info("response_peak", text).of(self.name(p)).value(p.speed, "rad/s");
            outcome = outcome.finding(finding.evidence("amplitude", p.value, self.probe(p).unit()));
        }
        if self.result.crossings.is_empty() {
            let text = match (self.complete(), self.loose.is_empty()) {
                (true, true) => "No critical speed was found in this range.",
                (true, false) => "No speed was found in this range at which the frequency of a mode equals it.",
                _ => "No critical speed was found before the study stopped.",
            };
            outcome = outcome.finding(Finding::info("no_critical_speed", text));
        }
        for p in self.peaks {
            let name = self.name(p);
            let point = SpecialPoint::new("response_peak", p.speed, p.bracket).of(&name);
            outcome = outcome.special_point(point.evidence(format!("amplitude of {name}"), p.value, self.probe(p).unit()));
        }
        outcome
    }

    /// Distance of the operating speed from the nearest critical speed or peak.
    fn margin(&self) -> Option<Finding> {
        // a machine at rest has no distance in parts of its speed
        let w = self.system.machine.speed.filter(|w| *w != 0.0)?;
        let near = |x: &Critical, y: &Critical| (x.speed - w).abs().total_cmp(&(y.speed - w).abs());
        // a mode with a tenth of critical damping or more does not show as a resonance
        let lightly = || self.result.crossings.iter().filter(|c| damping(c).abs() < 0.1);
        let excited = |c: &&Critical| !self.forced() || c.order != 1.0 || self.own_peak(c).is_some();
        let peak = self.loose.iter().min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs()));
        let close = lightly().filter(excited).min_by(|a, b| near(a, b));
        let peak = peak.filter(|p| close.is_none_or(|c| (p.speed - w).abs() < (c.speed - w).abs()));
        // without any that the load excites the nearest of the others is named, and is no reason for a warning
        let (close, quiet) = match (peak, close) {
            (None, None) => (lightly().min_by(|a, b| near(a, b)), true),
            (None, c) => (c, false),
            _ => (None, false),
        };
        let place = peak.map(|p| (p.speed, "peak of the unbalance response".to_string())).or(close.map(|c| {
            let order = if c.order == 1.0 { String::new() } else { format!(" of order {}", c.order) };
            let not = if c.located() { "" } else { " (not located)" };
            (c.speed, format!("lightly damped critical speed{order}{not}"))
        }));
        let (speed, what) = place?;
        let distance = (speed - w).abs() / w.abs();
        let so_far = if self.complete() { "" } else { " found before the study stopped" };
        let quietly = if quiet { "; the unbalance of this machine excites no resonance there" } else { "" };
        let text = if distance <= SAME {
            format!("The operating speed, {}, is a {what}{so_far}{quietly}.", quantity(w, "rad/s"))
        } else {
            format!(
                "The nearest {what}{so_far}, {}, is {{}} of the operating speed, {}, away from it{quietly}.",
                quantity(speed, "rad/s"),
                quantity(w, "rad/s")
            )
        };
        // which is the nearest, and whether the load excites it, is known of a whole search alone
        let near = self.complete() && !quiet && distance < self.study.margin;
        let finding = if near { Finding::warning("margin", text) } else { Finding::info("margin", text) };
        let finding = finding.of("to the nearest critical speed, over the operating speed").value(distance, "");
        Some(finding.shown_as(100.0 * distance, "%").evidence("margin requested", self.study.margin, "").evidence(
            "its speed",
            speed,
            "rad/s",
        ))
    }

    fn peak_table(&self) -> Result<Table, Diagnostic> {
        let peaks = self.peaks;
        let size = |tilt: bool| peaks.iter().map(|p| if self.probe(p).is_tilt() == tilt { p.value } else { f64::NAN }).collect();
        Table::new("response_peaks", "Maxima of the unbalance response")
            .text("body", "body, point of a body, or tilt of a body", peaks.iter().map(|p| self.name(p)).collect())
            .float("speed", "rad/s", "spin speed", peaks.iter().map(|p| p.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound, and of a tilt", size(false))
            .float("tilt", "rad", "semi-major axis of the tilt; NaN where it has no bound, and of a displacement", size(true))
            .build()
            .map_err(inconsistent)
    }

    fn figure(&self) -> Figure {
        let mut panel = Panel::new(Axis::new("damping ratio", ""))
            .mark(Points::new("critical_speeds", "speed", "damping_ratio").classes("whirl", WHIRLS));
        if let Some(w) = self.system.machine.speed {
            panel = panel.mark(Rule::x(w, "operating speed"));
        }
        let alt = format!("Damping ratio at each of {} critical speeds.", self.result.crossings.len());
        let range = &self.study.speed;
        Figure::new("critical_speeds", "Critical speeds", alt).x(Axis::new("spin speed", "rad/s").range(range.from, range.to)).panel(panel)
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
    out.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    out
}
