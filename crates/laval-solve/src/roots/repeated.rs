//! Roots that lie in one place with several modes: an isotropic body that is joined to no other has its forward and its backward mode at one root.
//!
//! ```text
//! X, Y: bases of the null spaces of T(s) and of its adjoint,   Y^H dT/ds X = 1
//! ```
//!
//! In X the modes that whirl forward most come first, so that a forward and a backward mode differ.

use crate::border::{Border, null_spaces};
use crate::characteristic::{Characteristic, Polished};
use crate::sectors::Sector;
use laval_num::complex::{C64, c};
use laval_num::dense::{Field, Lu, Mat};

/// Size of `T x` of a null vector, rows and columns of T scaled to one.
const NULL: f64 = 1e-9;
/// Sweeps of rotations, and the share of the direction of whirl that two modes have in common that is rounding.
const SWEEPS: usize = 8;
const APART: f64 = 1e-14;

/// So many roots at the place of one that is known; `None` where the null space is smaller.
pub(super) fn repeated(t: &mut Characteristic, known: &Polished, count: usize, sector: Option<Sector>) -> Option<Vec<Polished>> {
    let s = known.value;
    let Border { of, rows, cols, .. } = t.border(s, &t.members(sector))?;
    let [value, slope] = t.entries(s);
    let (pattern, mut scaled) = (of.inner.pattern(), of.taken(&value));
    for (i, &r) in rows.iter().enumerate() {
        pattern.row(i).for_each(|(e, j)| scaled[e] = scaled[e].scale(r * cols[j]));
    }
    let [left, mut right] = null_spaces(&of, &scaled, count)?;
    let row = |i: usize, x: &[C64]| pattern.row(i).fold(C64::ZERO, |sum, (e, j)| sum + scaled[e] * x[j]);
    let residual = |x: &Vec<C64>| (0..x.len()).map(|i| row(i, x).abs()).fold(0.0, f64::max);
    let defect = right.iter().map(residual).fold(0.0, f64::max);
    if !(defect <= NULL) {
        return None;
    }
    let weights: Vec<f64> = of.members.iter().map(|&i| t.sectors().of(i).winding()).collect();
    by_whirl(&mut right, &weights);
    let taken = of.taken(&slope);
    let times = |x: &[C64]| -> Vec<C64> {
        let row = |i: usize| pattern.row(i).fold(C64::ZERO, |sum, (e, j)| sum + taken[e].scale(rows[i] * cols[j]) * x[j]);
        (0..x.len()).map(row).collect()
    };
    let moved: Vec<Vec<C64>> = right.iter().map(|x| times(x)).collect();
    // of the adjoint: the columns of its inverse make the pairs
    let pairs = Lu::new(&Mat::from_fn(count, count, |a, b| product(&left[b], &moved[a]).conj())).ok()?;
    let mut out = Vec::new();
    for (k, x) in right.iter().enumerate() {
        let mut shares: Vec<C64> = (0..count).map(|i| c(if i == k { 1.0 } else { 0.0 }, 0.0)).collect();
        pairs.solve(&mut shares);
        let mut y = vec![C64::ZERO; x.len()];
        for (own, share) in left.iter().zip(&shares) {
            y.iter_mut().zip(own).for_each(|(y, own)| *y += *own * *share);
        }
        let factors = |x: &[C64], by: &[f64]| -> Vec<C64> { x.iter().zip(by).map(|(x, by)| x.scale(*by)).collect() };
        let (x, y) = (factors(x, &cols), factors(&y, &rows));
        let border = Border::of(&of, (&rows, &cols), (&y, &x))?;
        let spread = |x: &[C64]| {
            let mut out = vec![C64::ZERO; t.size()];
            of.members.iter().zip(x).for_each(|(&i, &x)| out[i] = x);
            out
        };
        let (right, left) = (spread(&x), spread(&y));
        out.push(Polished { value: s, right, left, defect, step: known.step, iterations: 0, by_s: C64::ONE, border });
    }
    Some(out)
}

/// `y^H x`.
fn product(y: &[C64], x: &[C64]) -> C64 {
    y.iter().zip(x).fold(C64::ZERO, |sum, (y, x)| sum + y.conj() * *x)
}

/// Turns an orthonormal basis so that its vectors have nothing of the direction of whirl in common, by Jacobi's rotations.
fn by_whirl(all: &mut [Vec<C64>], weights: &[f64]) {
    let weighted = |x: &[C64]| -> Vec<C64> { x.iter().zip(weights).map(|(x, w)| x.scale(*w)).collect() };
    for _ in 0..SWEEPS {
        let mut turned = false;
        for b in 1..all.len() {
            for a in 0..b {
                let (first, second) = (weighted(&all[a]), weighted(&all[b]));
                let (own, other, both) = (product(&all[a], &first).re, product(&all[b], &second).re, product(&all[a], &second));
                let size = both.abs();
                if size <= APART {
                    continue;
                }
                turned = true;
                let (angle, phase) = (0.5 * (2.0 * size).atan2(own - other), both.scale(1.0 / size));
                let (sin, cos) = angle.sin_cos();
                for i in 0..weights.len() {
                    let (x, y) = (all[a][i], all[b][i]);
                    all[a][i] = x.scale(cos) + (phase.conj() * y).scale(sin);
                    all[b][i] = y.scale(cos) - (phase * x).scale(sin);
                }
            }
        }
        if !turned {
            break;
        }
    }
}
