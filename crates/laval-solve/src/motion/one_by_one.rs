//! Members of an ensemble whose machine has coordinates without inertia: one lane after another.

use super::LEAST_RATE;
use super::direct::Direct;
use super::massless::Massless;
use super::{SpinLaw, fastest_of};
use crate::model::system::System;
use crate::orders::Orders;
use crate::programme::Spin;
use std::sync::Arc;

/// Some coordinate of the machine has no inertia, at a typical speed.
pub(crate) fn is_massless(system: &System) -> bool {
    let speed = system.machine.speed.unwrap_or(LEAST_RATE);
    !matches!(Orders::of(system, false, &[speed], LEAST_RATE), Ok(None))
}

/// A member with what its right side needs.
pub(crate) struct MasslessMember {
    system: Arc<System>,
    law: SpinLaw,
    direct: Direct,
    massless: Massless,
}

impl MasslessMember {
    /// `None` where some coordinate is determined by nothing.
    pub fn new(system: Arc<System>, law: SpinLaw, y: &[f64]) -> Option<Self> {
        let free = law == SpinLaw::Free;
        let mut direct = Direct::new(&system, free);
        let spin = spin_at(&system, &law, 0.0, y);
        direct.evaluate_at_rest(&system, 0.0, spin, y);
        let fastest = fastest_of(&law, spin);
        let speeds = [spin.speed, 0.5 * (spin.speed + fastest), fastest];
        let massless = Massless::new(&system, free, direct.constant_mass(), &speeds, fastest.max(LEAST_RATE)).ok()??;
        Some(MasslessMember { system, law, direct, massless })
    }

    /// Rates of all states; NaN where no places of the coordinates without inertia balance their forces.
    pub fn rates(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        let (n, m) = (self.system.n(), self.system.m());
        let free = self.law == SpinLaw::Free;
        let spin = spin_at(&self.system, &self.law, t, y);
        if self.massless.evaluate(&self.system, free, t, spin, y, &mut self.direct).is_err() {
            dy.fill(f64::NAN);
            return;
        }
        dy[..n].copy_from_slice(&y[n..2 * n]);
        dy[n..2 * n].copy_from_slice(&self.direct.accel[..n]);
        self.massless.rates(y, &self.direct.accel, dy);
        dy[2 * n..2 * n + m].copy_from_slice(&self.direct.rate);
        if free {
            dy[2 * n + m] = spin.speed;
            dy[2 * n + m + 1] = self.direct.accel[n];
        }
    }

    /// Writes into a state what follows from the rest of it.
    pub fn settle(&mut self, t: f64, y: &mut [f64]) {
        let spin = spin_at(&self.system, &self.law, t, y);
        let free = self.law == SpinLaw::Free;
        if self.massless.evaluate(&self.system, free, t, spin, y, &mut self.direct).is_ok()
            && self.direct.accel.iter().all(|a| a.is_finite())
        {
            self.massless.settle(y);
        }
    }
}

fn spin_at(system: &System, law: &SpinLaw, t: f64, y: &[f64]) -> Spin {
    match law {
        SpinLaw::Programme(p) => p.at(t),
        SpinLaw::Free => {
            let k = 2 * system.n() + system.m();
            Spin { phase: y[k], speed: y[k + 1], accel: 0.0 }
        }
    }
}
