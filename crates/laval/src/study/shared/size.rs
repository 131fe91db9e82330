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
/// Most bytes of a run, and the share of the memory of the machine that it may take at most.
const MOST: f64 = 4e9;
const SHARE: f64 = 0.5;

/// Most bytes of a run on this machine.
fn most() -> f64 {
    #[cfg(target_os = "linux")]
    {
        let about = rustix::system::sysinfo();
        let memory = about.totalram as f64 * f64::from(about.mem_unit);
        if memory > 0.0 {
            return MOST.min(SHARE * memory);
        }
    }
    MOST
}

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

    /// Rows of a table with so many numbers each, which are kept beside it.
    pub(in crate::study) fn of_rows(rows: usize, columns: usize) -> Size {
        Size {
            bytes: rows as f64 * columns as f64 * (KEPT + LISTED),
            of: text!("{rows} rows of {columns} numbers", rows, columns),
            fewer: text!("give fewer points"),
        }
    }

    /// A branch of so many motions with their sizes, forces and amplitudes.
    pub(in crate::study) fn of_branch(points: usize, system: &System) -> Size {
        Size::of_rows(points, 16 * system.stations().len() + system.slots().len() + 2 * (system.n() + system.m()))
    }

    /// Whether it fits.
    pub(in crate::study) fn check(self) -> Result<(), Diagnostic> {
        self.check_within(most())
    }

    fn check_within(self, limit: f64) -> Result<(), Diagnostic> {
        let Size { bytes, of, fewer } = self;
        if bytes <= limit {
            return Ok(());
        }
        let gigabytes = |b: f64| significant(1e-9 * b, 2);
        let message = text!(
            "{of} take about {needed} GB of memory, more than the {most} GB allowed",
            of,
            needed = gigabytes(bytes),
            most = gigabytes(limit)
        );
        Err(Diagnostic::error("request.memory", message).help(fewer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_refusal_states_need_and_limit() {
        assert!(most() > 0.0 && most() <= MOST);
        assert!(Size::of_rows(1000, 10).check_within(1e9).is_ok());
        let refused = Size::of_rows(1_000_000, 100).check_within(2e9).unwrap_err();
        let said = refused.message.to_string();
        assert!(said.contains("1000000 rows of 100 numbers take about 5.6 GB") && said.contains("the 2 GB allowed"), "{said}");
        // a size that is no number does not fit
        let unknown = Size { bytes: f64::NAN, ..Size::of_rows(1, 1) };
        assert!(unknown.check_within(1e9).is_err());
    }
}
