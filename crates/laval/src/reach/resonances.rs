//! A peak of the linear response of a body. Its slopes are found by differences.

use super::goal::{Of, Sought, Valued};
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::solve::extrema::{curve, seeds};
use crate::solve::pencil::time_forms;
use crate::solve::rest::over_speed;
use crate::study::Context;
use crate::study::support::probe_name;

pub(super) struct Resonance {
    of: Of,
    at: f64,
    /// The point, body or tilt; the displacement that is largest where none is named.
    body: Option<String>,
    tilt: bool,
    quick: bool,
}

/// Range searched, over the speed, and speeds in it.
const ABOUT: f64 = 0.35;
const SPEEDS: usize = 48;
/// Coordinates and states up to which a response takes microseconds.
const SMALL: usize = 60;
/// Relative error of an extremum.
const LOCATED: f64 = 1e-7;

impl Resonance {
    pub fn new(system: &System, of: Of, at: f64, body: Option<String>) -> Resonance {
        Resonance { of, at, body, tilt: false, quick: system.n() + system.m() <= SMALL }
    }
}

impl Sought for Resonance {
    fn unit(&self) -> &'static str {
        self.of.unit(self.tilt)
    }

    fn quick(&self) -> bool {
        self.quick
    }

    fn accuracy(&self) -> f64 {
        LOCATED
    }

    fn of(&mut self, system: &System, parameters: &[Vec<usize>], context: &Context) -> Result<Option<Valued>, Diagnostic> {
        let named = |p: &&Probe| self.body.as_ref().map_or(!p.is_tilt(), |b| probe_name(p) == *b);
        let own: Vec<Probe> = system.probes().iter().filter(named).cloned().collect();
        let ends = [(1.0 - ABOUT) * self.at, (1.0 + ABOUT) * self.at];
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let state = over_speed(system);
        let mut each = |_| !context.cancelled();
        let mut speeds = RangeValue { from: low, to: high, points: Some(SPEEDS) }.linspace(SPEEDS);
        // without a time form no eigenvalue says where a narrow peak hides
        if time_forms(system).is_ok() {
            speeds.extend(seeds(system, &state, low, high, &mut each)?.speeds);
        }
        let found = curve(system, &state, speeds, &own, &mut each)?;
        let peaks = found.extrema.iter().filter(|e| e.maximum && !e.unbounded);
        let distance = |speed: f64| (speed - self.at).abs();
        let least = peaks.clone().map(|e| distance(e.speed)).fold(f64::INFINITY, f64::min);
        let nearest = peaks.filter(|e| distance(e.speed) <= least + self.tolerance() * self.at.abs());
        let Some(peak) = nearest.max_by(|a, b| a.value.total_cmp(&b.value)) else { return Ok(None) };
        self.at = peak.speed;
        self.tilt = own[peak.probe].is_tilt();
        let value = if self.of == Of::Speed { peak.speed } else { peak.value };
        Ok(Some(Valued { value, slopes: vec![f64::NAN; parameters.len()] }))
    }

    fn mark(&self) -> Vec<f64> {
        vec![self.at]
    }

    fn back(&mut self, mark: &[f64]) {
        if let [at] = mark {
            self.at = *at;
        }
    }
}
