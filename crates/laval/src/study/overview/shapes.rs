//! Modes at the operating speed: frequency, damping, direction, and which bodies move.

use super::Facts;
use super::buckling::diverging;
use crate::model::system::System;
use crate::outcome::Mode;
use crate::solve::pencil::MachineMode;
use crate::solve::sectors::circular;
use crate::study::linear::whirl::{aperiodic, lowest};
use laval_num::order::SortByNumber;

/// Modes shown.
const MOST: usize = 8;
/// Share of the largest amplitude below which a body is not named.
const HARDLY: f64 = 0.02;
/// Semi-axes that differ by less than this share make a circle.
const ROUND: f64 = 1e-6;

/// Modes by frequency; of many those that grow and those of the lowest frequencies.
pub(super) fn modes(facts: &Facts) -> Vec<Mode> {
    let Some((study, result)) = facts.modes.as_ref().and_then(|(s, m)| Some((s, m.get()?))) else { return Vec::new() };
    let threshold = study.threshold.max(facts.threshold);
    let modes = &result.spectrum.modes;
    let fastest = facts.operating.map_or(0.0, |o| o.high.abs());
    let periodic = (0..modes.len()).filter(|&k| !aperiodic(modes[k].value));
    let shown = lowest(modes, periodic, fastest, MOST, |m| m.growth() > threshold);
    let mut all: Vec<&MachineMode> = diverging(result, threshold).into_iter().chain(shown.into_iter().map(|k| &modes[k])).collect();
    all.sort_by_number(|a| a.frequency());
    let speed = facts.system.machine.speed.unwrap_or(0.0);
    all.into_iter().map(|m| Mode { grows: m.growth() > threshold, ..mode(facts.system, m, speed) }).collect()
}

/// A mode at a speed of the machine, in the words of the first page.
pub fn mode(system: &System, m: &MachineMode, speed: f64) -> Mode {
    let probes = system.probes();
    let axes: Vec<(String, f64, f64, f64)> = probes
        .iter()
        .filter(|p| p.is_reference())
        .map(|p| {
            let [x, y] = p.amplitudes(&m.q);
            let (f, b) = circular(x, y);
            let (long, short) = (f.abs() + b.abs(), f.abs() - b.abs());
            // a circle has no direction
            let round = long - short.abs() <= ROUND * long;
            let angle = if round { 0.0 } else { 0.5 * (2.0 * (x * y.conj()).re).atan2(x.norm_sqr() - y.norm_sqr()) };
            (p.name.clone(), long, short, angle)
        })
        .collect();
    let largest = axes.iter().map(|a| a.1).fold(0.0, f64::max);
    let share = |x: f64| if largest > 0.0 { x / largest } else { 0.0 };
    let shown = axes.into_iter().filter(|a| share(a.1) >= HARDLY);
    let (orbits, angles) = shown.map(|(n, a, b, angle)| ((n, share(a), share(b)), angle)).unzip();
    let whirl = m.whirl.at(speed).word();
    Mode {
        growth: m.growth(),
        grows: m.growth() > 0.0,
        frequency: if aperiodic(m.value) { 0.0 } else { m.frequency() },
        whirl,
        orbits,
        angles,
    }
}
