//! Whether parts that take inertia away leave enough of it.

use super::part::At;
use super::system::System;
use super::tangent::{Tangent, TangentScratch};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;
use laval_num::dense::Mat;

/// Least share of a coordinate's inertia that must be left.
const LEAST: f64 = 1e-9;

/// Reports parts that leave the mass matrix of the machine indefinite: it would run away by itself, faster than any motion that is meant.
pub(super) fn check(system: &System, diagnostics: &mut Diagnostics) {
    let lightening: Vec<_> =
        system.slots().iter().filter_map(|s| Some((s, s.part.added_inertia()?.removed(&system.params()[s.params.clone()])?))).collect();
    if lightening.is_empty() {
        return;
    }
    let (zero, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let speed = system.machine.speed.unwrap_or(0.0);
    let at = At { q: &zero, v: &zero, a: &zero, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut scratch) = (Tangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut scratch, |_| true);
    let Some(lost) = indefinite(&t.a) else { return };
    for (slot, removed) in lightening {
        let name = &system.coordinates()[lost].name;
        diagnostics.push(
            Diagnostic::error(
                "part.inertia",
                text!("\"{slot}\": {what}, and no inertia is left for {name}", slot = slot.name, what = removed.what, name),
            )
            .at(slot.span.clone())
            .help(removed.help),
        );
    }
}

/// The first coordinate for which a symmetric matrix is not positive; coordinates without mass are left out.
fn indefinite(mass: &Mat) -> Option<usize> {
    let n = mass.rows();
    let mut m = Mat::from_fn(n, n, |i, j| mass[(i, j)]);
    for k in (0..n).filter(|&k| (0..n).any(|j| mass[(k, j)] != 0.0)) {
        // a pivot that is not a number is not positive
        if !(m[(k, k)] > LEAST * mass[(k, k)].abs()) {
            return Some(k);
        }
        for i in k + 1..n {
            let f = m[(i, k)] / m[(k, k)];
            for j in k + 1..n {
                let x = m[(k, j)];
                m[(i, j)] -= f * x;
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definite_matrices_and_others() {
        let from = |rows: [[f64; 3]; 3]| Mat::from_fn(3, 3, |i, j| rows[i][j]);
        assert_eq!(indefinite(&from([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 0.0]])), None);
        assert_eq!(indefinite(&from([[2.0, 3.0, 0.0], [3.0, 2.0, 0.0], [0.0, 0.0, 1.0]])), Some(1));
        assert_eq!(indefinite(&from([[2.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])), Some(1));
        // nothing is left
        assert_eq!(indefinite(&from([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])), Some(1));
        assert_eq!(indefinite(&from([[1.0, 0.0, 0.0], [0.0, f64::NAN, 0.0], [0.0, 0.0, 1.0]])), Some(1));
    }
}
