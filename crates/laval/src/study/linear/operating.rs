//! The operating speed in figures over the spin speed.

use crate::model::system::System;
use crate::outcome::{Band, Rule};

/// Separation margin of machine standards on both sides of the operating speed (API 684).
const MARGIN: f64 = 0.15;

/// An operating speed that a figure shows, rad/s.
pub(in crate::study) struct Operating(f64);

/// The operating speed, where it lies between two speeds.
pub(in crate::study) fn operating(system: &System, from: f64, to: f64) -> Option<Operating> {
    let inside = |w: &f64| *w != 0.0 && (from.min(to)..=from.max(to)).contains(w);
    system.machine.speed.filter(inside).map(Operating)
}

impl Operating {
    /// The speed, rad/s.
    pub fn speed(&self) -> f64 {
        self.0
    }

    /// A line at it.
    pub fn rule(&self) -> Rule {
        Rule::x(self.0, "operating speed")
    }

    /// The separation margin about it.
    pub fn margin(&self) -> Band {
        Band::x((1.0 - MARGIN) * self.0, (1.0 + MARGIN) * self.0).name("operating speed ± 15 %").neutral()
    }
}
