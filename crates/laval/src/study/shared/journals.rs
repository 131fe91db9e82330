//! Vibration of the shaft relative to its bearings, and of what these stand on, from a linear response.

use super::standards::VibrationStandard;
use super::supporting;
use crate::diagnostic::Diagnostic;
use crate::model::station::Pair;
use crate::model::system::System;
use crate::solve::extrema::Curve;
use crate::solve::linear_response::Response;
use crate::solve::sectors::circular;
use crate::solve::statics::supports::supports;
use serde::{Deserialize, Serialize};

/// A support and the displacement of the shaft in it.
#[derive(Clone, Debug)]
pub struct Journal {
    /// Slot of the support.
    pub slot: usize,
    /// Displacement of the shaft relative to what the support stands on; of a housing, its own.
    pub relative: Pair,
    /// The probe that measures the same.
    pub probe: Option<usize>,
}

impl Journal {
    /// Peak to peak in the direction in which it is largest, m.
    pub fn vibration(&self, r: &Response) -> f64 {
        let [x, y] = self.relative.amplitudes(&r.x);
        let (f, b) = circular(x, y);
        2.0 * (f.abs() + b.abs())
    }
}

/// The journals of a machine.
///
/// # Errors
/// A machine without state of rest at this speed.
pub fn journals(system: &System, speed: f64) -> Result<Vec<Journal>, Diagnostic> {
    let state = supporting::state(system, speed)?;
    let one = |s: crate::solve::statics::supports::Support| {
        let map = &system.slots()[s.slot].map;
        let relative = Pair([map.first()?.clone(), map.get(1)?.clone()]);
        Some(Journal { slot: s.slot, probe: probe(system, &relative), relative })
    };
    Ok(supports(system, &state).into_iter().filter_map(one).collect())
}

/// What the supports of a machine stand on, with the displacement there; nothing of a support on the ground.
///
/// # Errors
/// A machine without state of rest at this speed.
pub fn housings(system: &System, speed: f64) -> Result<Vec<Journal>, Diagnostic> {
    let stands = |g: usize| !system.slots()[system.coordinates()[g].slot].part.body().is_some_and(|b| b.turns());
    let one = |mut j: Journal| {
        j.relative.0.iter_mut().for_each(|row| row.retain(|x| stands(x.0)));
        let moves = j.relative.0.iter().all(|row| !row.is_empty());
        j.probe = probe(system, &j.relative);
        moves.then_some(j)
    };
    Ok(journals(system, speed)?.into_iter().filter_map(one).collect())
}

fn probe(system: &System, place: &Pair) -> Option<usize> {
    system.probes().iter().position(|p| !p.is_tilt() && [0, 1].iter().all(|&k| same(&place.0[k], &p.rows.0[k])))
}

/// The same combination up to its sign.
fn same(a: &[(usize, f64)], b: &[(usize, f64)]) -> bool {
    let with = |s: f64| a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.0 == y.0 && x.1 == s * y.1);
    with(1.0) || with(-1.0)
}

/// The vibration of a journal where it uses most of the limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct JournalVibration {
    /// Slot of the support.
    pub slot: usize,
    /// Speed, rad/s.
    pub speed: f64,
    /// Peak to peak, m.
    pub peak_to_peak: f64,
}

/// Of every journal, the vibration over the speeds from `low` to `high` (amounts, rad/s) that uses most of the limit; none without a response there.
pub fn vibrations(all: &[Journal], curve: &Curve, standard: VibrationStandard, (low, high): (f64, f64)) -> Vec<JournalVibration> {
    let slack = 1e-9 * high;
    let inside = |w: f64| (low - slack..=high + slack).contains(&w.abs());
    let one = |j: &Journal| {
        let points = curve.points.iter().filter(|r| inside(r.speed)).map(|r| (r.speed, j.vibration(r)));
        let peaks = curve.extrema.iter().filter(|e| e.maximum && Some(e.probe) == j.probe && inside(e.speed));
        let peaks = peaks.map(|e| (e.speed, if e.unbounded { f64::INFINITY } else { 2.0 * e.value }));
        let used = |v: &(f64, f64)| if v.1.is_nan() { f64::INFINITY } else { v.1 / standard.limit(v.0) };
        let (speed, peak_to_peak) = points.chain(peaks).max_by(|a, b| used(a).total_cmp(&used(b)))?;
        Some(JournalVibration { slot: j.slot, speed, peak_to_peak })
    };
    all.iter().filter_map(one).collect()
}
