//! The order of roots, in which rounding decides nothing.

use crate::pencil::{MachineMode, Whirl};
use crate::sectors::Sector;
use laval_num::complex::C64;
use laval_num::order::SortByNumber;

/// Roots nearer than this, relative to their size, are equal: two processors need not agree on which is larger.
const EQUAL: f64 = 1e-9;

/// Puts roots in the order of their frequencies (imaginary parts), those of equal frequency in the order of their growth (real parts), and equal ones in
/// the order of `rank`.
///
/// ```
/// use laval_num::complex::c;
/// use laval_solve::ties::settle;
/// // two pairs that differ in growth, each with a frequency that another processor rounds otherwise
/// let mut one = [(c(-3.0, 200.0), 1), (c(-2.0, 200.00000000000003), 1), (c(-3.0, 200.00000000000006), 0), (c(-2.0, 200.0), 0), (c(0.0, 9.0), 1)];
/// let mut other = one.map(|(s, rank)| (c(s.re, 400.0 - s.im), rank));
/// other[4].0 = one[4].0;
/// for roots in [&mut one, &mut other] {
///     settle(roots, |r| r.0, |r| r.1);
///     assert_eq!(roots.map(|(s, rank)| (s.re, rank)), [(0.0, 1), (-3.0, 0), (-3.0, 1), (-2.0, 0), (-2.0, 1)]);
/// }
/// ```
pub fn settle<T>(roots: &mut [T], value: impl Fn(&T) -> C64, rank: impl Fn(&T) -> u8) {
    let equal = |a: f64, b: f64, of: &T| (b - a).abs() <= EQUAL * value(of).abs();
    roots.sort_by_number(|a| value(a).im);
    for alike in roots.chunk_by_mut(|a, b| equal(value(a).im, value(b).im, b)) {
        alike.sort_by_number(|a| value(a).re);
        for same in alike.chunk_by_mut(|a, b| equal(value(a).re, value(b).re, b)) {
            same.sort_by_key(&rank);
        }
    }
}

/// Forward, mixed, backward, axial, torsional, none.
pub fn rank(whirl: Whirl) -> u8 {
    match whirl {
        Whirl::Forward => 0,
        Whirl::Mixed => 1,
        Whirl::Backward => 2,
        Whirl::Axial => 3,
        Whirl::Torsional => 4,
        Whirl::None => 5,
    }
}

/// Where a mode stands among equal ones: by its direction; that of a machine at rest, which whirls in no direction, by what it becomes when it turns.
pub fn mode_rank(mode: &MachineMode) -> u8 {
    let sector = match mode.sector {
        Some(Sector::Forward) => 0,
        Some(Sector::Backward) => 2,
        _ => 1,
    };
    4 * sector + rank(mode.whirl)
}

/// Modes in the order of [`settle`].
pub fn settle_modes(modes: &mut [MachineMode]) {
    settle(modes, |m| m.value, mode_rank);
}
