//! Supports that are raised against what they stand on.
//!
//! A part between a turning place u and another place w has the force of `B q = u - w`. Raised by d it has that of `u - w - d`: the force at the coordinates `q + s`,
//! where s is the shortest with `B s = -d` in the displacement of the port and `B s = 0` in its other components.

use super::supports::turning_first;
use crate::model::part::Link;
use crate::model::system::System;
use laval_num::dense::Mat;
use serde::{Deserialize, Serialize};

/// How far a support is raised.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Offset {
    /// Slot of the part.
    pub slot: usize,
    /// In x and y, m.
    pub by: [f64; 2],
}

/// A support that is raised, with what that does to the coordinates that it sees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Raised {
    /// Slot of the part.
    pub slot: usize,
    /// In x and y, m.
    pub by: [f64; 2],
    /// Change of the coordinates for an offset of 1 m in x and in y.
    pub unit: [Vec<(usize, f64)>; 2],
}

impl Raised {
    /// `None` of a part that does not act between two places.
    pub fn new(system: &System, offset: Offset) -> Option<Raised> {
        let slot = &system.slots()[offset.slot];
        let port = slot.layout.ports.first()?;
        let n = slot.map.len();
        if !matches!(port.link, Link::Between(..)) || n < 2 {
            return None;
        }
        let product = |i: usize, j: usize| -> f64 {
            slot.map[i].iter().map(|&(g, a)| slot.map[j].iter().filter(|x| x.0 == g).map(|x| a * x.1).sum::<f64>()).sum()
        };
        // a coordinate that the machine does not have stays 0
        let gram = Mat::from_fn(n, n, |i, j| if i == j && slot.map[i].is_empty() { 1.0 } else { product(i, j) });
        let sign = if turning_first(system, offset.slot) { -1.0 } else { 1.0 };
        let unit = |p: usize| -> Option<Vec<(usize, f64)>> {
            let right = (0..n).map(|i| if i == p { sign } else { 0.0 }).collect();
            let weights = super::solved(&gram, right)?;
            let mut out: Vec<(usize, f64)> = Vec::new();
            for (row, w) in slot.map.iter().zip(&weights) {
                for &(g, a) in row {
                    match out.iter_mut().find(|x| x.0 == g) {
                        Some(x) => x.1 += w * a,
                        None => out.push((g, w * a)),
                    }
                }
            }
            Some(out)
        };
        Some(Raised { slot: offset.slot, by: offset.by, unit: [unit(0)?, unit(1)?] })
    }

    /// All that differ from zero.
    pub fn all(system: &System, offsets: &[Offset]) -> Vec<Raised> {
        offsets.iter().filter(|o| o.by != [0.0; 2]).filter_map(|o| Raised::new(system, *o)).collect()
    }

    /// Change of the coordinates that the part sees.
    pub fn shift(&self) -> Vec<(usize, f64)> {
        (0..2).flat_map(|p| self.unit[p].iter().map(move |&(g, x)| (g, self.by[p] * x))).collect()
    }

    /// Coordinates as the part sees them.
    pub fn seen(&self, q: &[f64]) -> Vec<f64> {
        let mut out = q.to_vec();
        self.shift().into_iter().for_each(|(g, x)| out[g] += x);
        out
    }
}
