//! What a run keeps in memory, estimated before it begins: a request that no machine can hold is refused, not begun.

use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::significant;
use crate::solve::large::is_large;
use crate::text;
use crate::text::Text;

/// Bytes of a number that is kept.
pub(in crate::study) const KEPT: f64 = 8.0;
/// Bytes of a number in a table: itself, and the texts and files it is written to.
pub(in crate::study) const LISTED: f64 = 48.0;
/// Modes that are kept of a large machine, about.
const BAND: f64 = 100.0;
/// Most bytes of a run.
const MOST: f64 = 4e9;

/// What a run keeps.
pub struct Size {
    /// Bytes, to a factor of two.
    pub bytes: f64,
    /// What takes them.
    pub of: Text,
    /// What to change.
    pub fewer: Text,
}

impl Size {
    /// The spectra of a machine at so many speeds, with right and left vectors.
    pub(in crate::study) fn of_spectra(speeds: usize, system: &System) -> Size {
        let states = (2 * system.n() + system.m()) as f64;
        // of a large machine only modes up to a frequency are kept
        let modes = if is_large(system) { states.min(BAND) } else { states };
        Size {
            bytes: speeds as f64 * (2.5 * KEPT * states * modes + 7.0 * LISTED * modes),
            of: text!("{speeds} spectra of {states} states", speeds, states),
            fewer: text!("give the range fewer points"),
        }
    }

    /// Whether it fits.
    pub(in crate::study) fn check(self) -> Result<(), Diagnostic> {
        let Size { bytes, of, fewer } = self;
        if bytes <= MOST {
            return Ok(());
        }
        let gigabytes = |b: f64| significant(1e-9 * b, 2);
        let message = text!(
            "{of} take about {needed} GB of memory, more than the {most} GB allowed",
            of,
            needed = gigabytes(bytes),
            most = gigabytes(MOST)
        );
        Err(Diagnostic::error("request.memory", message).help(fewer))
    }
}
