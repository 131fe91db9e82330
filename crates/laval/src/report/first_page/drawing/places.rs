//! Places along the axis of a machine that lies.

use super::lying::{BESIDE, LEFT, RIGHT};
use super::{Parts, WIDTH};

/// Least distance of two places.
const APART: f64 = 46.0;

/// Where points of the rotor are drawn: along the axis, but none nearer to another than [`APART`].
pub(super) struct Places {
    /// Places of the bodies.
    pub bodies: Vec<f64>,
    /// Places along the axis of the machine, m, and of the drawing.
    known: Vec<(f64, f64)>,
    /// Of the drawing over the machine, 1/m; 0 where all places are one.
    pub scale: f64,
}

pub(super) fn places(parts: &Parts) -> Places {
    let place: Vec<f64> = parts.bodies.iter().map(|b| b.place).collect();
    let rotor = |k: usize| parts.bodies[k].rotor;
    let on = parts.links.iter().flat_map(|l| l.ends.into_iter().flatten()).filter(|e| rotor(e.0)).map(|e| place[e.0] + e.1);
    let own = (0..place.len()).filter(|&k| rotor(k)).map(|k| place[k]);
    let wheels = parts.wheels.iter().flat_map(|w| w.ends).map(|e| place[e.0] + e.1);
    // of shafts beside each other the ends say how they lie
    let several = !parts.wheels.is_empty();
    let ends = parts.bodies.iter().filter(|b| several && b.rotor).filter_map(|b| Some(b.place + b.profile.last()?[1]));
    let mut all: Vec<f64> = on.chain(own).chain(wheels).chain(ends).collect();
    all.sort_by(f64::total_cmp);
    let size = all.last().zip(all.first()).map_or(0.0, |(b, a)| b - a);
    all.dedup_by(|a, b| (*a - *b).abs() <= 1e-6 * size);
    let count = all.len();
    let apart = if count > 1 { if several { APART / 3.0 } else { APART }.min((RIGHT - LEFT) / (count - 1) as f64) } else { 0.0 };
    let scale = if size > 0.0 { (RIGHT - LEFT) / size } else { 0.0 };
    let even = |z: f64| if size > 0.0 { LEFT + scale * (z - all[0]) } else { 0.5 * (LEFT + RIGHT) };
    let mut xs: Vec<f64> = all.iter().map(|z| even(*z)).collect();
    for k in 1..count {
        xs[k] = xs[k].max(xs[k - 1] + apart);
    }
    for k in (0..count.saturating_sub(1)).rev() {
        xs[k] = xs[k].min(xs[k + 1] - apart);
    }
    // the last may have left the drawing
    let over = xs.last().map_or(0.0, |x| (x - RIGHT).max(0.0));
    let known: Vec<(f64, f64)> = all.into_iter().zip(xs.into_iter().map(move |x| x - over)).collect();
    Places { bodies: place, known, scale }
}

impl Places {
    /// A point of a body.
    pub fn point(&self, body: usize, height: f64) -> f64 {
        let z = self.bodies[body] + height;
        let near = self.known.iter().min_by(|a, b| (a.0 - z).abs().total_cmp(&(b.0 - z).abs()));
        near.map_or(0.5 * (LEFT + RIGHT), |n| n.1)
    }

    /// Any place along the axis, between those known in proportion.
    pub fn along(&self, z: f64) -> f64 {
        let (Some(first), Some(last)) = (self.known.first(), self.known.last()) else { return 0.5 * (LEFT + RIGHT) };
        if z <= first.0 {
            return (first.1 + self.scale * (z - first.0)).max(BESIDE);
        }
        if z >= last.0 {
            return (last.1 + self.scale * (z - last.0)).min(WIDTH - BESIDE);
        }
        let k = self.known.partition_point(|p| p.0 <= z).clamp(1, self.known.len() - 1);
        let (a, b) = (self.known[k - 1], self.known[k]);
        a.1 + (b.1 - a.1) * (z - a.0) / (b.0 - a.0)
    }
}
