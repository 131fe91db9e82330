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
use crate::solve::extrema::{Extremum, above, curve, seeds};
use crate::solve::linear_response::Response;
use crate::solve::rest::rest;
use crate::study::shared::size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{About, SPEED_RANGE, admit_eigenvalues, inconsistent, moves, probe_name, range, remarks_between};
use crate::study::{Context, Study};

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
    type Result = Outcome;
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

    fn report(&self, _: &System, result: &Outcome, _: &str) -> Result<Outcome, Diagnostic> {
        Ok(result.clone())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let state = |w: f64| rest(system, w);
        let limit = above(self.speed.to * self.orders.iter().fold(0.0, |m: f64, &k| m.max(k)));
        let (found, mut end) = follow(system, context, &self.speed.linspace(120), limit)?;
        let crossings = criticals(system, &state, &found, &self.orders);
        let probes = system.probes();
        let (_, load) = Characteristic::new(system, &state(self.speed.to)?).loads();
        let forced = load.iter().any(|f| f.abs() > 0.0) && !probes.is_empty() && end.is_complete();
        let mut responses = Vec::new();
        let peaks: Vec<_> = if forced {
            let mut speeds = self.speed.linspace(200);
            let mut each = |done| context.goes_on(done);
            speeds.extend(seeds(system, &state, self.speed.from, self.speed.to, &mut each)?.speeds);
            let response = curve(system, &state, speeds, probes, &mut each)?;
            if !response.complete {
                end = context.end(false);
            }
            responses = response.points;
            response.extrema.into_iter().filter(|e| e.maximum).collect()
        } else {
            Vec::new()
        };
        let complete = end == End::Reached;
        let mut outcome =
            Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(end).work("eigenproblems", found.points.len() as u64);
        if let Some(f) = unstable(system, &found.strongest, &Follows::Speeds) {
            outcome = outcome.finding(f);
        }
        let name = |p: &Extremum| probe_name(&probes[p.probe]);
        let subject = |p: &Extremum| match probes[p.probe].is_tilt() {
            true => format!("the {}", name(p)),
            false => format!("the response of {}", name(p)),
        };
        for c in &crossings {
            let beside = match own_peak(c, &crossings, &peaks) {
                _ if !forced || c.order != 1.0 => String::new(),
                Some(p) if p.unbounded => format!("; there {} has no bound", subject(p)),
                Some(p) => format!("; {} peaks at {}", subject(p), quantity(p.speed, "rad/s")),
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
            let finding = match own_peak(c, &crossings, &peaks) {
                Some(p) => finding.evidence("peak of the response", p.speed, "rad/s"),
                None => finding,
            };
            outcome = outcome.finding(finding).special_point(special(c));
        }
        let loose = loose(&crossings, &peaks, probes, &responses);
        for p in &loose {
            let text = format!(
                "The unbalance response peaks at {{}}, where the frequency of no mode equals the speed: {}.",
                if p.unbounded { format!("{} has no bound there", subject(p)) } else { moves(&probes[p.probe], p.value) }
            );
            let finding = Finding::info("response_peak", text).of(name(p)).value(p.speed, "rad/s");
            outcome = outcome.finding(finding.evidence("amplitude", p.value, probes[p.probe].unit()));
        }
        if crossings.is_empty() {
            let text = match (complete, loose.is_empty()) {
                (true, true) => "No critical speed was found in this range.",
                (true, false) => "No speed was found in this range at which the frequency of a mode equals it.",
                _ => "No critical speed was found before the study stopped.",
            };
            outcome = outcome.finding(Finding::info("no_critical_speed", text));
        }
        for p in &peaks {
            let (probe, name) = (&probes[p.probe], probe_name(&probes[p.probe]));
            let point = SpecialPoint::new("response_peak", p.speed, p.bracket).of(&name);
            outcome = outcome.special_point(point.evidence(format!("amplitude of {name}"), p.value, probe.unit()));
        }
        // a machine at rest has no distance in parts of its speed
        if let Some(w) = system.machine.speed.filter(|w| *w != 0.0) {
            let near = |x: &Critical, y: &Critical| (x.speed - w).abs().total_cmp(&(y.speed - w).abs());
            // a mode with a tenth of critical damping or more does not show as a resonance
            let lightly = || crossings.iter().filter(|c| damping(c).abs() < 0.1);
            let excited = |c: &&Critical| !forced || c.order != 1.0 || own_peak(c, &crossings, &peaks).is_some();
            let peak = loose.iter().min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs()));
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
            if let Some((speed, what)) = place {
                let distance = (speed - w).abs() / w.abs();
                let so_far = if complete { "" } else { " found before the study stopped" };
                let text = format!(
                    "The nearest {what}{so_far}, {}, is {{}} of the operating speed, {}, away from it{}.",
                    quantity(speed, "rad/s"),
                    quantity(w, "rad/s"),
                    if quiet { "; the unbalance of this machine excites no resonance there" } else { "" }
                );
                // which is the nearest, and whether the load excites it, is known of a whole search alone
                let near = complete && !quiet && distance < self.margin;
                let finding = if near { Finding::warning("margin", text) } else { Finding::info("margin", text) };
                outcome = outcome.finding(
                    finding
                        .of("to the nearest critical speed, over the operating speed")
                        .value(distance, "")
                        .shown_as(100.0 * distance, "%")
                        .evidence("margin requested", self.margin, ""),
                );
            }
        }
        for f in remarks_between(system, &state(self.speed.from)?, state(self.speed.to)) {
            outcome = outcome.finding(f);
        }
        let size = |tilt: bool| peaks.iter().map(|p| if probes[p.probe].is_tilt() == tilt { p.value } else { f64::NAN }).collect();
        let peak_table = Table::new("response_peaks", "Maxima of the unbalance response")
            .text("body", "body, point of a body, or tilt of a body", peaks.iter().map(name).collect())
            .float("speed", "rad/s", "spin speed", peaks.iter().map(|p| p.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound, and of a tilt", size(false))
            .float("tilt", "rad", "semi-major axis of the tilt; NaN where it has no bound, and of a displacement", size(true))
            .build()
            .map_err(inconsistent)?;
        outcome = outcome.table(critical_table(&crossings)?).table(peak_table);
        if !crossings.is_empty() {
            let mut panel = Panel::new(Axis::new("damping ratio", ""))
                .mark(Points::new("critical_speeds", "speed", "damping_ratio").classes("whirl", WHIRLS));
            if let Some(w) = system.machine.speed {
                panel = panel.mark(Rule::x(w, "operating speed"));
            }
            let alt = format!("Damping ratio at each of {} critical speeds.", crossings.len());
            let figure = Figure::new("critical_speeds", "Critical speeds", alt)
                .x(Axis::new("spin speed", "rad/s").range(self.speed.from, self.speed.to))
                .panel(panel);
            outcome = outcome.figure(figure);
        }
        outcome.checked().map_err(inconsistent)
    }
}

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
