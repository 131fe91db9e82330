//! Heights of the supports of a train at which its couplings carry nothing: their faces, uncoupled, coincide and are parallel.
//!
//! ```text
//! c(d) = (M_k, L V_k) = 0 in both planes at each coupling k,   d = d + J' (J J')^-1 (-c),   J = dc/dd
//! ```
//!
//! M bending moment, V shear force of the cut at the coupling, L length of the body, d offsets of the supports that may move. As many offsets as conditions: one answer; more: the one
//! with the least changes. J by differences, exact for a linear machine; Newton's method repeats the step.
//!
//! Theory: `docs/theory/shafts.md#alignment`.

use super::beam::{Beam, beams};
use super::offsets::Offset;
use super::{Statics, raised, solved};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::dense::{Mat, max_abs};
use serde::{Deserialize, Serialize};

/// A cut through a body that bends, at a node.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// Slot of the body.
    pub slot: usize,
    /// Position along it, m.
    pub position: f64,
    /// Just above the node instead of just below.
    pub above: bool,
}

impl Section {
    /// At a node of a body that bends: above the first one, below all others. `None` where there is no node.
    pub fn at(system: &System, slot: usize, position: f64) -> Option<Section> {
        const SAME: f64 = 1e-9;
        let nodes = system.slots()[slot].part.body()?.nodes()?;
        let (first, last) = (*nodes.first()?, *nodes.last()?);
        let node = nodes.iter().find(|z| (*z - position).abs() <= SAME * (last - first))?;
        Some(Section { slot, position: *node, above: *node == first })
    }

    /// Shear force, N, and bending moment, N m, in x and y.
    pub fn loads(&self, beams: &[Beam]) -> Option<([f64; 2], [f64; 2])> {
        let beam = beams.iter().find(|b| b.slot == self.slot)?;
        let cut = beam.cuts.iter().min_by(|a, b| (a.position - self.position).abs().total_cmp(&(b.position - self.position).abs()))?;
        let side = usize::from(self.above);
        Some((cut.shear[side], cut.moment[side]))
    }
}

/// A train with couplings free of load.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Aligned {
    /// Offsets of all supports.
    pub offsets: Vec<Offset>,
    /// The machine at rest on them.
    pub state: Statics,
    /// Largest moment, and shear force times length, that is left at a coupling, over the largest along the bodies before.
    pub left: f64,
    /// Offsets beyond those that the conditions determine.
    pub spare: usize,
}

/// Why no offsets were found.
#[derive(Clone, Debug, PartialEq)]
pub enum Unaligned {
    /// More conditions than offsets: how many of each.
    Few(usize, usize),
    /// Offsets do not change the conditions, or not all of them.
    Independent,
    /// Newton's method did not end: residual over its size before.
    Open(f64),
}

/// Newton steps, at most; what may be left of the conditions.
const MOST_STEPS: usize = 20;
const EXACT: f64 = 1e-9;

/// From the offsets of a state; `movable` supports may change theirs, in both directions. With `shear` both the shear force and the moment vanish, else the moment.
///
/// # Errors
/// A machine without equilibrium at some offsets.
pub fn aligned(
    system: &System,
    from: &Statics,
    supports: &[usize],
    movable: &[usize],
    couplings: &[Section],
    shear: bool,
) -> Result<Result<Aligned, Unaligned>, Diagnostic> {
    let conditions = |at: &Statics| -> Vec<f64> {
        let all = beams(system, at, &[]);
        let one = |s: &Section| {
            let length = all.iter().find(|b| b.slot == s.slot).map_or(1.0, length);
            let (v, m) = s.loads(&all).unwrap_or_default();
            let force = [0, 1].into_iter().filter(move |_| shear).map(move |p| v[p] * length);
            [m[0], m[1]].into_iter().chain(force).collect::<Vec<_>>()
        };
        couplings.iter().flat_map(one).collect()
    };
    let present = |slot: usize| from.raised.iter().find(|r| r.slot == slot).map_or([0.0; 2], |r| r.by);
    let mut offsets: Vec<Offset> = supports.iter().map(|&slot| Offset { slot, by: present(slot) }).collect();
    let mut at = from.clone();
    let mut c = conditions(&at);
    let unknowns = 2 * movable.len();
    let sizes = beams(system, &at, &[]);
    let of = |b: &Beam| b.cuts.iter().flat_map(|c| c.moment.iter().chain(&c.shear).flatten().copied()).fold(0.0f64, |m, x| m.max(x.abs()));
    let scale = sizes.iter().map(|b| of(b) * length(b).max(1.0)).fold(0.0, f64::max);
    if c.len() > unknowns {
        return Ok(Err(Unaligned::Few(unknowns / 2, c.len() / 2)));
    }
    let linear = system.slots().iter().all(|s| s.is_linear());
    // of a linear machine any step is exact, of others a part of the clearance of its films
    let step = if linear { 1e-4 } else { 1e-7 };
    let (mut left, mut best) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..MOST_STEPS {
        let mut j = Mat::zeros(c.len(), unknowns);
        for k in 0..unknowns {
            let mut moved = offsets.clone();
            moved.iter_mut().filter(|o| o.slot == movable[k / 2]).for_each(|o| o.by[k % 2] += step);
            let there = conditions(&raised(system, &at, &moved)?);
            (0..c.len()).for_each(|i| j[(i, k)] = (there[i] - c[i]) / step);
        }
        let Some(change) = shortest(&j, &c) else { return Ok(Err(Unaligned::Independent)) };
        for (k, dx) in change.iter().enumerate() {
            offsets.iter_mut().filter(|o| o.slot == movable[k / 2]).for_each(|o| o.by[k % 2] -= dx);
        }
        at = raised(system, &at, &offsets)?;
        c = conditions(&at);
        let size = max_abs(&c);
        left = if scale > 0.0 { size / scale } else { size };
        // the second step of a linear machine takes what rounding left of the first
        if left <= EXACT && left >= 0.1 * best {
            break;
        }
        best = best.min(left);
    }
    if !(left <= EXACT) {
        return Ok(Err(Unaligned::Open(left)));
    }
    Ok(Ok(Aligned { offsets, state: at, left, spare: unknowns / 2 - c.len() / 2 }))
}

fn length(beam: &Beam) -> f64 {
    beam.cuts.last().zip(beam.cuts.first()).map_or(1.0, |(b, a)| b.position - a.position)
}

/// The shortest x with `J x = c`; `None` where there is none for every c.
fn shortest(j: &Mat, c: &[f64]) -> Option<Vec<f64>> {
    let (rows, columns) = (j.rows(), j.cols());
    if rows == columns {
        return solved(j, c.to_vec());
    }
    let gram = Mat::from_fn(rows, rows, |a, b| (0..columns).map(|k| j[(a, k)] * j[(b, k)]).sum());
    let weights = solved(&gram, c.to_vec())?;
    Some((0..columns).map(|k| (0..rows).map(|i| j[(i, k)] * weights[i]).sum()).collect())
}
