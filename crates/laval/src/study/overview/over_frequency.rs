//! Machines with coefficients over the frequency of vibration: the page speaks of all modes or of none.

use super::Known;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
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
