//! Motions along and about the axis that nothing opposes: double roots of the characteristic function at zero.
//!
//! ```text
//! K x = 0 and C x = 0,   so that T(s) x = s^2 M x
//! ```

use crate::characteristic::Characteristic;
use crate::machine_mode::Unknowns;
use laval_num::complex::{C64, c};
use laval_num::dense::Field;

/// Force of a motion over the sum of its terms that is rounding.
const ROUNDING: f64 = 1e-12;

/// Of every group of coordinates along or about the axis that stiffness or damping joins its motion as a whole, over all unknowns, where no force opposes it; shafts in mesh turn as
/// their ratios. None where parts with memory or given in the frequency domain may oppose it.
pub(super) fn free_motions(t: &Characteristic, unknowns: &Unknowns) -> Vec<Vec<C64>> {
    let Some([stiffness, damping, _]) = t.as_polynomial() else { return Vec::new() };
    let (pattern, mut out) = (t.pattern(), Vec::new());
    for (kind, of) in unknowns.along.iter().enumerate() {
        let own = |i: usize| of.binary_search(&i).is_ok();
        let mut seen = vec![false; t.size()];
        for &first in of {
            if std::mem::replace(&mut seen[first], true) {
                continue;
            }
            let (mut group, mut next) = (vec![first], 0);
            while let Some(&i) = group.get(next) {
                next += 1;
                for (_, j) in pattern.row(i).filter(|x| stiffness[x.0] != C64::ZERO || damping[x.0] != C64::ZERO) {
                    if own(j) && !std::mem::replace(&mut seen[j], true) {
                        group.push(j);
                    }
                }
            }
            let mut motion = vec![C64::ZERO; t.size()];
            group.iter().for_each(|&i| motion[i] = c(if kind == 1 { unknowns.ratios[i] } else { 1.0 }, 0.0));
            let free = |m: &[C64]| {
                (0..t.size()).all(|i| {
                    let terms = pattern.row(i).map(|(e, j)| m[e] * motion[j]);
                    let (sum, size) = terms.fold((C64::ZERO, 0.0), |(sum, size), x| (sum + x, size + x.abs()));
                    sum.abs() <= ROUNDING * size
                })
            };
            if free(stiffness) && free(damping) {
                out.push(motion);
            }
        }
    }
    out
}
