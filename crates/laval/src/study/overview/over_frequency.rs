//! Machines with coefficients over the frequency of vibration: the page speaks of all modes or of none.

use super::operating::Operating;
use super::{Facts, Known};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Message};
use crate::study::linear::modes::ModesResult;
use crate::text;

/// Modes where the tables hold all of them; else why they are not known.
pub(super) fn whole(system: &System, known: Known<ModesResult>) -> Known<ModesResult> {
    let part = known.get().and_then(|r| r.own.as_ref()).is_some_and(|o| !o.counted() || o.below + o.above > 0 || o.range.0 > 0.0);
    match system.over_frequency().next() {
        Some((slot, _)) if part => Known::Refused(Diagnostic::error(
            "modes.frequencies",
            text!("modes with frequencies outside the table of \"{name}\" are not known", name = slot.name),
        )),
        _ => known,
    }
}

/// Why stability was not computed. Where a table over the frequency of vibration is the reason: its part, its frequencies and the study that takes it.
pub(super) fn unknown(facts: &Facts, speed: Operating) -> Message {
    let m = |key: &str| Message::new(key).arg("speed", speed.arg());
    let beyond = matches!(&facts.modes, Some((_, Known::Refused(d))) if d.code == "modes.frequencies");
    let tables = || facts.system.over_frequency().map(|t| t.1);
    // where the tables have no frequencies in common that study answers nothing
    let (from, to) = (tables().map(|t| t.from).fold(0.0, f64::max), tables().map(|t| t.to).fold(f64::INFINITY, f64::min));
    if let Some((slot, table)) = facts.system.over_frequency().next().filter(|_| beyond && from < to) {
        let m = m("headline-unknown-table").arg("part", Arg::name(&slot.name));
        return m.arg("from", Arg::frequency(table.from)).arg("to", Arg::frequency(table.to));
    }
    // other reasons stand beside the check
    m("headline-unknown")
}
