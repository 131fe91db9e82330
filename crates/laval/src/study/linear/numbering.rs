//! Numbers of modes that are followed over the speed: those of the study of modes at one speed, by rising frequency.

use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::solve::sweep::Branch;

/// The speed at which modes have their numbers: that of the machine, or the first where the range does not hold it.
pub(super) fn reference(system: &System, range: &RangeValue) -> f64 {
    system.machine.speed.filter(|w| range.from <= *w && *w <= range.to).unwrap_or(range.from)
}

/// Brings branches into the order of their frequencies at a speed; of a branch that does not reach it that of its nearest point counts.
pub(super) fn in_order(branches: &mut [Branch], speed: f64) {
    branches.sort_by(|a, b| key(a, speed).0.total_cmp(&key(b, speed).0).then(key(a, speed).1.total_cmp(&key(b, speed).1)));
}

/// Frequency and growth nearest to the speed, rad/s and 1/s.
fn key(b: &Branch, speed: f64) -> (f64, f64) {
    let nearest = b.points.iter().min_by(|p, q| (p.0 - speed).abs().total_cmp(&(q.0 - speed).abs()));
    nearest.map_or((f64::INFINITY, 0.0), |p| (p.1.frequency(), p.1.growth()))
}
