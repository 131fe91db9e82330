//! Numbers of modes that are followed over the speed: those of the study of modes at one speed, by rising frequency.

use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::solve::sweep::Branch;

/// The speed at which modes have their numbers: that of the machine, or the first where the range does not hold it.
pub(super) fn reference(system: &System, range: &RangeValue) -> f64 {
    system.machine.speed.filter(|w| range.from <= *w && *w <= range.to).unwrap_or(range.from)
}

/// Brings branches into the order of their frequencies at a speed. Those that do not reach it come last, in the order at their nearest points: the numbers of the others are those
/// of the modes there.
pub(super) fn in_order(branches: &mut [Branch], speed: f64) {
    branches.sort_by(|a, b| {
        let (a, b) = (key(a, speed), key(b, speed));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2))
    });
}

/// Share of a speed by which the end of a branch may miss it: rounding.
const SAME: f64 = 1e-9;

/// Whether the branch does not reach the speed; frequency and growth nearest to it, rad/s and 1/s.
fn key(b: &Branch, speed: f64) -> (bool, f64, f64) {
    let nearest = b.points.iter().min_by(|p, q| (p.0 - speed).abs().total_cmp(&(q.0 - speed).abs()));
    let slack = SAME * speed.abs();
    let reaches = b.points.iter().any(|p| p.0 <= speed + slack) && b.points.iter().any(|p| p.0 >= speed - slack);
    nearest.map_or((true, f64::INFINITY, 0.0), |p| (!reaches, p.1.frequency(), p.1.growth()))
}
