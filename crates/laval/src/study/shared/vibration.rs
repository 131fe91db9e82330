//! The frequencies of vibration that a study needs against the tables of parts over them: a study that cannot take such parts is refused, as one beyond a table is; where
//! the part says how the table continues, every finding there is marked.

use super::speed_range::{SpinSpeeds, mark};
use crate::diagnostic::Diagnostic;
use crate::model::part::{Beyond, Tabulated};
use crate::model::system::System;
use crate::outcome::Outcome;
use crate::study::Study;
use crate::text;

/// At which frequencies of vibration a study needs the coefficients of parts that are tabulated over them.
#[derive(Clone, Debug, PartialEq)]
pub enum Vibration {
    /// It has no answer for a machine with such parts.
    Refused,
    /// It rests on no motion, or runs another study.
    Elsewhere,
    /// Multiples of its spin speeds.
    Orders(Vec<f64>),
    /// From one to another, rad/s.
    Range(f64, f64),
    /// Those of the modes: it keeps to the tables, and marks what lies outside.
    Own,
}

/// The code of a refusal of a study beyond a table.
pub(in crate::study) const BEYOND: &str = "study.beyond_frequencies";

/// Share of a frequency within which two units say the same.
const SAME: f64 = 1e-9;

/// Frequencies that a study needs, rad/s.
fn needed<T: Study>(study: &T, system: &System) -> Vec<(f64, f64)> {
    let range = |n: &SpinSpeeds, order: f64| {
        let least = if n.from <= 0.0 && n.to >= 0.0 { 0.0 } else { n.from.abs().min(n.to.abs()) };
        (order.abs() * least, order.abs() * n.from.abs().max(n.to.abs()))
    };
    let mut out: Vec<(f64, f64)> = match study.vibration(system) {
        Vibration::Orders(orders) => {
            let speeds = study.spin_speeds(system);
            orders.iter().flat_map(|&k| speeds.iter().map(move |n| range(n, k))).collect()
        }
        Vibration::Range(from, to) => vec![(from, to)],
        Vibration::Own => Vec::new(),
        Vibration::Refused | Vibration::Elsewhere => return Vec::new(),
    };
    // what nonlinear parts are linearised about is the deflection under static loads
    if system.is_loaded() && system.slots().iter().any(|s| !s.is_linear()) {
        out.push((0.0, 0.0));
    }
    out
}

fn leaves(range: &(f64, f64), t: &Tabulated) -> bool {
    range.0 < t.from * (1.0 - SAME) || range.1 > t.to * (1.0 + SAME)
}

/// # Errors
/// A machine with parts in a table over the frequency of vibration in a study that does not take them; a frequency at which such a part is not known.
pub(super) fn known<T: Study>(study: &T, system: &System) -> Result<(), Diagnostic> {
    let Some((slot, _)) = system.over_frequency().next() else { return Ok(()) };
    if study.vibration(system) == Vibration::Refused {
        return Err(Diagnostic::error(
            "study.over_frequency",
            text!(
                "the coefficients of \"{name}\" depend on the frequency of vibration, and this study does not take such a part",
                name = slot.name
            ),
        )
        .at(slot.span.clone())
        .help(text!(
            "modes, campbell, critical_speeds, forced_response and harmonic_force take it; for this study give a table over the speed alone"
        )));
    }
    let needed = needed(study, system);
    for (slot, t) in system.over_frequency().filter(|(_, t)| t.beyond == Beyond::Refuse) {
        if let Some(n) = needed.iter().find(|n| leaves(n, &t)) {
            let shown = |w: f64| text::quantity(w / std::f64::consts::TAU, "Hz");
            let (low, high, from, to) = (shown(t.from), shown(t.to), shown(n.0), shown(n.1));
            let message = if n.0 == n.1 {
                text!(
                    "the study needs the coefficients of \"{name}\" at a frequency of vibration of {from}; its table goes from {low} to {high}",
                    name = slot.name,
                    from,
                    low,
                    high
                )
            } else {
                text!(
                    "the study needs the coefficients of \"{name}\" at frequencies of vibration from {from} to {to}; its table goes from {low} to {high}",
                    name = slot.name,
                    from,
                    to,
                    low,
                    high
                )
            };
            return Err(Diagnostic::error(BEYOND, message).help(text!("keep to frequencies of the table, add rows to it, or write beyond = \"hold\" or beyond = \"linear\" in \"{name}\": results beyond are then marked", name = slot.name)));
        }
    }
    Ok(())
}

/// Marks in an outcome what rests on a table beyond its frequencies.
pub(super) fn mark_beyond<T: Study>(study: &T, system: &System, outcome: &mut Outcome) {
    let needed = needed(study, system);
    for (slot, t) in system.over_frequency() {
        let beyond: Vec<&(f64, f64)> = needed.iter().filter(|n| leaves(n, &t)).collect();
        if beyond.is_empty() {
            continue;
        }
        let outside = beyond.iter().map(|n| SpinSpeeds::between(n.0, n.1)).collect::<Vec<_>>();
        // findings name speeds: those at which all orders are inside the table
        let orders = match study.vibration(system) {
            Vibration::Orders(orders) => orders,
            _ => vec![1.0],
        };
        let from = orders.iter().map(|k| t.from / k.abs()).fold(0.0, f64::max);
        let to = orders.iter().map(|k| t.to / k.abs()).fold(f64::INFINITY, f64::min);
        mark(outcome, &slot.name, &t, (from, to), &outside, "beyond-table-frequency");
    }
}
