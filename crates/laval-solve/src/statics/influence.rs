//! Change of the loads of the supports of a machine at rest per offset of a support.
//!
//! ```text
//! R = w' r_i(x + w d),   K dx = -T_j w_j dd:   dR_i/dd_j = w_i' T_i (dx + delta_ij w_j)       on the stiffness of the supports
//! dR/dd = A^-1 - s I,   A = B' (K + s B B')^-1 B                                            with their places held
//! ```
//!
//! T_j derivative of the forces of part j, w_j change of the coordinates that it sees per offset ([`super::offsets`]), K derivative of all forces, B places held, s
//! stiffness of springs beside them, which cancels. Symmetric where K is (Maxwell and Betti).

use super::equations::Equations;
use super::offsets::{Offset, Raised};
use super::{Statics, along, spring};
use crate::model::station::Row;
use crate::model::system::System;
use laval_num::dense::{Lu, Mat};

/// Influence of offsets about a state, N/m: rows and columns are x and y of each support. `None` where a part is no support, or the machine is not held.
pub fn own(system: &System, at: &Statics, slots: &[usize]) -> Option<Mat> {
    let equations = Equations::new(system, at.speed, &at.left_out, &at.raised);
    let x = equations.point(at);
    let supports: Vec<Raised> = slots.iter().map(|&slot| Raised::new(system, Offset { slot, by: [0.0; 2] })).collect::<Option<_>>()?;
    let entries: Vec<Vec<(usize, usize, f64)>> = slots.iter().map(|&s| equations.each_entry(s, &x, &at.z, |i, j, k| (i, j, k))).collect();
    let times = |k: usize, v: &[f64]| -> Vec<f64> {
        let mut out = vec![0.0; equations.unknowns()];
        entries[k].iter().for_each(|&(i, j, e)| out[i] += e * v[j]);
        out
    };
    let unit = |k: usize| -> Vec<f64> {
        let mut out = vec![0.0; equations.unknowns()];
        supports[k / 2].unit[k % 2].iter().for_each(|&(g, w)| out[g] += w);
        out
    };
    let n = 2 * slots.len();
    let columns: Vec<Vec<f64>> = (0..n).map(|k| times(k / 2, &unit(k)).iter().map(|f| -f).collect()).collect();
    let moved = equations.solved(&x, &at.z, columns, &[], 0.0)?;
    let mut out = Mat::zeros(n, n);
    for j in 0..n {
        for i in 0..slots.len() {
            let mut seen = moved[j].clone();
            if i == j / 2 {
                supports[i].unit[j % 2].iter().for_each(|&(g, w)| seen[g] += w);
            }
            let force = times(i, &seen);
            for p in 0..2 {
                out[(2 * i + p, j)] = supports[i].unit[p].iter().map(|&(g, w)| w * force[g]).sum();
            }
        }
    }
    Some(out)
}

/// With places held: influence of their offsets, N/m.
pub fn rigid(system: &System, at: &Statics, ties: &[Row]) -> Option<Mat> {
    // differences of numbers as large as s are rounding below this share of them
    const ROUNDING: f64 = 1e-9;
    let equations = Equations::new(system, at.speed, &at.left_out, &at.raised);
    let (x, s) = (equations.point(at), spring(system, at, &equations.load));
    let columns = ties
        .iter()
        .map(|row| {
            let mut unit = vec![0.0; equations.unknowns()];
            row.iter().for_each(|&(i, a)| unit[i] = a);
            unit
        })
        .collect();
    let columns = equations.solved(&x, &at.z, columns, ties, s)?;
    let n = ties.len();
    let flexibility = Mat::from_fn(n, n, |i, j| along(&ties[i], &columns[j]));
    let lu = Lu::new(&flexibility).ok().filter(|lu| lu.pivot_ratio() > 1e-13)?;
    let mut out = Mat::zeros(n, n);
    for j in 0..n {
        let mut unit: Vec<f64> = (0..n).map(|i| if i == j { 1.0 } else { 0.0 }).collect();
        lu.solve(&mut unit);
        for i in 0..n {
            let x = unit[i] - if i == j { s } else { 0.0 };
            out[(i, j)] = if x.abs() > ROUNDING * s { x } else { 0.0 };
        }
    }
    Some(out)
}
