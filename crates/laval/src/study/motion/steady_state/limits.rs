//! Use of the parts' validity along a recorded motion.

use crate::model::part::At;
use crate::model::system::{System, Workspace};
use std::f64::consts::TAU;

/// The largest use so far. Accelerations are central differences of the rates between samples: 0.2 % off at the forcing order, enough to compare with a limit.
#[derive(Default)]
pub struct Limits {
    before: Vec<f64>,
    now: Vec<f64>,
    ws: Workspace<f64>,
    /// Slot, statement, use.
    pub worst: Option<(usize, &'static str, f64)>,
}

impl Limits {
    /// The next sample, `step` after the one before it.
    pub fn watch(&mut self, system: &System, speed: f64, t: f64, step: f64, y: &[f64]) {
        let (n, m) = (system.n(), system.m());
        if !self.before.is_empty() {
            let a: Vec<f64> = (n..2 * n).map(|i| (y[i] - self.before[i]) / (2.0 * step)).collect();
            let (t, own) = (t - step, &self.now);
            let phase = (speed * t) % TAU;
            let at = At { q: &own[..n], v: &own[n..2 * n], a: &a, z: &own[2 * n..2 * n + m], phase, speed, spin_accel: 0.0, t };
            for (slot, v) in system.validity(&at, &mut self.ws) {
                // what is no number is outside
                if self.worst.is_none_or(|w| !(w.2.is_nan() || v.ratio <= w.2)) {
                    self.worst = Some((slot, v.what, v.ratio));
                }
            }
        }
        self.before = std::mem::take(&mut self.now);
        self.now = y.to_vec();
    }
}
