//! The operating speed in figures over the spin speed.

use crate::model::system::System;
use crate::outcome::{Arg, Band, Message, Rule};
use crate::study::shared::operation::{self, MARGIN};

/// An operating speed that a figure shows, rad/s, and the distance of resonances required, over it.
pub(in crate::study) struct Operating(f64, f64);

/// The operating speed, where it lies between two speeds.
pub(in crate::study) fn operating(system: &System, from: f64, to: f64) -> Option<Operating> {
    let inside = |w: &f64| *w != 0.0 && (from.min(to)..=from.max(to)).contains(w);
    let margin = operation::required_margin(system).unwrap_or(MARGIN);
    system.machine.speed.filter(inside).map(|w| Operating(w, margin))
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
        let name = Message::new("label-operating-margin").arg("margin", Arg::percent(self.1));
        Band::x((1.0 - self.1) * self.0, (1.0 + self.1) * self.0).name(name).neutral()
    }
}
