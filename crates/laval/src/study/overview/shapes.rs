//! Modes at the operating speed: frequency, damping, direction, and which bodies move.

use super::Facts;
use crate::outcome::Mode;
use crate::solve::pencil::{MachineMode, Whirl};
use crate::solve::sectors::circular;
use laval_num::order::SortByNumber;

/// Modes shown: the slowest in decay first.
const MOST: usize = 8;
/// Share of the largest amplitude below which a body is not named.
const HARDLY: f64 = 0.02;

/// Modes by frequency; of many those that decay most slowly.
pub(super) fn modes(facts: &Facts) -> Vec<Mode> {
    let Some((study, result)) = facts.modes.as_ref().and_then(|(s, m)| Some((s, m.get()?))) else { return Vec::new() };
    let threshold = study.threshold.max(facts.threshold);
    let mut all: Vec<&MachineMode> = result.spectrum.modes.iter().filter(|m| m.frequency() > 0.0).collect();
    all.sort_by_number(|a| a.damping_ratio());
    all.truncate(MOST);
    all.sort_by_number(|a| a.frequency());
    let speed = facts.system.machine.speed.unwrap_or(0.0);
    all.into_iter().map(|m| Mode { grows: m.growth() > threshold, ..mode(facts, m, speed) }).collect()
}

fn mode(facts: &Facts, m: &MachineMode, speed: f64) -> Mode {
    let probes = facts.system.probes();
    let axes: Vec<(String, f64, f64)> = probes
        .iter()
        .filter(|p| p.is_reference())
        .map(|p| {
            let [x, y] = p.amplitudes(&m.q);
            let (f, b) = circular(x, y);
            (p.name.clone(), f.abs() + b.abs(), (f.abs() - b.abs()).abs())
        })
        .collect();
    let largest = axes.iter().map(|a| a.1).fold(0.0, f64::max);
    let share = |x: f64| if largest > 0.0 { x / largest } else { 0.0 };
    let orbits = axes.into_iter().map(|(n, a, b)| (n, share(a), share(b))).filter(|o| o.1 >= HARDLY).collect();
    let whirl = match m.whirl.at(speed) {
        Whirl::Forward => "forward",
        Whirl::Backward => "backward",
        Whirl::Mixed => "mixed",
        Whirl::None => "none",
    };
    Mode { growth: m.growth(), grows: m.growth() > 0.0, frequency: m.frequency(), whirl, orbits }
}
