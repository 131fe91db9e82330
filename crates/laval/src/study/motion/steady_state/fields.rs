//! Fields of the studies that settle motions.

use super::Rules;
use super::period::FEWEST;
use crate::model::field::{Bounds, Field, FieldKind, Values, Word};
use crate::study::motion::history::method;

const SETTLINGS: &[Word] = &[
    ("decay", "as many e-folds of the slowest mode as the tolerance requires"),
    ("shooting", "five e-folds, then Newton's method on the Poincare map; the long way where it fails"),
];
/// Lowest speed, rad/s: a forcing period must end.
pub const SLOWEST: f64 = 1e-6;

pub const SETTLING: Field = Field::optional("settling", FieldKind::Choice(SETTLINGS), "decay", "how the settled motion is reached");
pub const TOLERANCE: Field = Field::optional(
    "tolerance",
    FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-9, 1e-2) },
    "1e-6",
    "distance from the settled motion over its size, by which it counts as settled and as repeating",
);
pub const MOST_PERIODS: Field = Field::optional(
    "most_periods",
    FieldKind::Integer { min: 1, max: 100_000_000 },
    "50000",
    "most forcing periods of settling of one motion",
);
pub const PERIODS: Field = Field::optional(
    "periods",
    FieldKind::Integer { min: FEWEST as i64, max: 4096 },
    "64",
    "forcing periods recorded of every motion, with 64 samples each",
);
pub const RELATIVE: Field = Field::optional(
    "relative_tolerance",
    FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-14, 1e-4) },
    "",
    "tolerated error of a step over the size of each state; 1e-4 of the tolerance unless given, but at most 1e-10",
);
pub const ABSOLUTE: Field = Field::optional(
    "absolute_tolerance",
    FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-18, 1e-4) },
    "",
    "tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given",
);

impl Rules {
    /// From the fields of this module; `most_periods` where the file says nothing.
    pub fn read(values: &Values, most_periods: i64, spectrum: Option<usize>) -> Option<Rules> {
        let tolerance = values.number("tolerance").unwrap_or(1e-6);
        let relative = values.number("relative_tolerance").unwrap_or((1e-4 * tolerance).min(1e-10));
        Some(Rules {
            relative,
            absolute: values.number("absolute_tolerance").unwrap_or(0.1 * relative),
            tolerance,
            most_periods: u64::try_from(values.integer("most_periods").unwrap_or(most_periods)).ok()?,
            periods: usize::try_from(values.integer("periods").unwrap_or(64)).ok()?,
            method: method(values),
            shooting: values.choice("settling") == Some("shooting"),
            spectrum,
        })
    }
}
