//! Critical speeds: where a frequency of the machine is a multiple of its spin speed, and how they differ from the peaks of the response.
//!
//! Equations: `det T(growth + i k W, W) = 0` for (growth, W), which for an undamped machine is `det Z(i k W, W) = 0`; peaks of the unbalance response
//! `T(i W, W) X = F` are maxima of the amplitude over W and lie beside the critical speeds where there is damping.
//!
//! Symbols: W spin speed, rad/s; k order.
//!
//! Validity: small motions about the equilibrium; constant speed.
//!
//! Sources: `theory/planar-rotor.md` sections 6 and 9.

use super::campbell::{ORDERS, critical_table, damping, damping_words, follow, orders, special};
use super::modes::WHIRLS;
use super::support::{About, SPEED_RANGE, admit_eigenvalues, inconsistent, range, remarks};
use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::system::System;
use crate::outcome::{Axis, End, Figure, Finding, Outcome, Panel, Points, Rule, SpecialPoint, Table, quantity};
use crate::solve::characteristic::Characteristic;
use crate::solve::extrema::{above, criticals, curve, seeds};
use crate::solve::pencil::Whirl;
use crate::solve::rest::rest;

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

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_eigenvalues(system, About::Rest, self.speed.from)
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let state = |w: f64| rest(system, w);
        let limit = above(self.speed.to * self.orders.iter().fold(0.0, |m: f64, &k| m.max(k)));
        let (found, mut end) = follow(system, context, &self.speed.linspace(120), limit)?;
        let crossings = criticals(system, &state, &found, &self.orders);
        let bodies = system.bodies();
        let at: Vec<usize> = bodies.iter().map(|b| b.x).collect();
        let (_, load) = Characteristic::new(system, &state(self.speed.to)?).loads();
        let forced = load.iter().any(|f| f.abs() > 0.0) && !bodies.is_empty() && end.is_complete();
        let peaks: Vec<_> = if forced {
            let mut speeds = self.speed.linspace(200);
            let mut each = |done| context.goes_on(done);
            speeds.extend(seeds(system, &state, self.speed.from, self.speed.to, &mut each)?);
            let response = curve(system, &state, speeds, &at, &mut each)?;
            if !response.complete {
                end = context.end(false);
            }
            response.extrema.into_iter().filter(|e| e.maximum).collect()
        } else {
            Vec::new()
        };
        let complete = end == End::Reached;
        let mut outcome =
            Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(end).work("eigenproblems", found.points.len() as u64);
        for c in &crossings {
            let near =
                peaks.iter().filter(|_| c.order == 1.0).min_by(|a, b| (a.speed - c.speed).abs().total_cmp(&(b.speed - c.speed).abs()));
            // a peak belongs to a critical speed when it lies within a few widths of its resonance
            let near = near.filter(|p| (p.speed - c.speed).abs() <= 4.0 * c.growth.abs() + 1e-6 * c.speed.abs());
            // and to the nearest one only; of two at one place, to the one unbalance drives
            let near = near.filter(|p| {
                let own = ((c.speed - p.speed).abs(), c.whirl == Whirl::Backward);
                !crossings.iter().filter(|o| o.order == 1.0).any(|o| {
                    let other = ((o.speed - p.speed).abs(), o.whirl == Whirl::Backward);
                    other.0 < own.0 - 1e-9 * p.speed.abs() || ((other.0 - own.0).abs() <= 1e-9 * p.speed.abs() && !other.1 && own.1)
                })
            });
            let beside = match near {
                Some(p) if p.unbounded => format!("; there the response of {} has no bound", bodies[p.body].name),
                Some(p) => format!("; the response of {} peaks at {}", bodies[p.body].name, quantity(p.speed, "rad/s")),
                None if forced && c.order == 1.0 => "; the unbalance response has no peak there".into(),
                None => String::new(),
            };
            let text = format!(
                "Critical speed of order {} at {{}}: {}, {}{beside}.",
                c.order,
                c.whirl.of("whirl", c.forward_share),
                damping_words(c)
            );
            let mut finding = Finding::info("critical_speed", text)
                .of(format!("order {} {}", c.order, c.whirl.word()))
                .value(c.speed, "rad/s")
                .evidence("relative defect of the dynamic stiffness", c.defect, "")
                .evidence("last Newton step", c.step, "rad/s");
            if let Some(p) = near {
                finding = finding.evidence("peak of the response", p.speed, "rad/s");
            }
            outcome = outcome.finding(finding).special_point(special(c));
        }
        if crossings.is_empty() {
            let text = if complete {
                "There is no critical speed in this range."
            } else {
                "No critical speed was found before the study stopped."
            };
            outcome = outcome.finding(Finding::info("no_critical_speed", text));
        }
        for p in &peaks {
            outcome = outcome.special_point(SpecialPoint::new("response_peak", p.speed, p.bracket).of(&bodies[p.body].name).evidence(
                format!("amplitude of {}", bodies[p.body].name),
                p.value,
                "m",
            ));
        }
        // a machine at rest has no distance in parts of its speed
        if let Some(w) = system.machine.speed.filter(|w| *w != 0.0) {
            // a mode with a tenth of critical damping or more does not show as a resonance
            let close =
                crossings.iter().filter(|c| damping(c).abs() < 0.1).min_by(|a, b| (a.speed - w).abs().total_cmp(&(b.speed - w).abs()));
            if let Some(c) = close {
                let distance = (c.speed - w).abs() / w.abs();
                let text = format!(
                    "The nearest lightly damped critical speed, {}{}, is {{}} of the operating speed, {}, away from it.",
                    quantity(c.speed, "rad/s"),
                    if c.order == 1.0 { String::new() } else { format!(" (order {})", c.order) },
                    quantity(w, "rad/s"),
                );
                let finding = if distance >= self.margin { Finding::info("margin", text) } else { Finding::warning("margin", text) };
                outcome = outcome.finding(
                    finding
                        .of("to the nearest critical speed, over the operating speed")
                        .value(distance, "")
                        .shown_as(100.0 * distance, "%")
                        .evidence("margin asked for", self.margin, ""),
                );
            }
        }
        for f in remarks(system, &state(self.speed.from)?) {
            outcome = outcome.finding(f);
        }
        let peak_table = Table::new("response_peaks", "Maxima of the unbalance response")
            .text("body", "body", peaks.iter().map(|p| bodies[p.body].name.clone()).collect())
            .float("speed", "rad/s", "spin speed", peaks.iter().map(|p| p.speed).collect())
            .float("amplitude", "m", "semi-major axis of the orbit; NaN where it has no bound", peaks.iter().map(|p| p.value).collect())
            .build()
            .map_err(inconsistent)?;
        let mut panel = Panel::new(Axis::new("damping ratio", ""))
            .mark(Points::new("critical_speeds", "speed", "damping_ratio").classes("whirl", WHIRLS));
        if let Some(w) = system.machine.speed {
            panel = panel.mark(Rule::x(w, "operating speed"));
        }
        let alt = format!("Damping ratio at each of {} critical speeds.", crossings.len());
        let figure = Figure::new("critical_speeds", "Critical speeds", alt)
            .x(Axis::new("spin speed", "rad/s").range(self.speed.from, self.speed.to))
            .panel(panel);
        outcome.table(critical_table(&crossings)?).table(peak_table).figure(figure).checked().map_err(inconsistent)
    }
}
