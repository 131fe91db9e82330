//! The operating speed in figures over the spin speed.

use crate::model::system::System;
use crate::outcome::{Arg, Band, Message, Rule};
use crate::study::shared::operation::{self, MARGIN};

/// An operating speed that a figure shows.
pub(in crate::study) struct Operating {
    /// rad/s.
    speed: f64,
    /// The first and the last speed at which the machine runs.
    range: (f64, f64),
    /// Distance of resonances required, over the speed.
    margin: f64,
}

/// The operating speed, where it lies between two speeds.
pub(in crate::study) fn operating(system: &System, from: f64, to: f64) -> Option<Operating> {
    let inside = |w: &f64| *w != 0.0 && (from.min(to)..=from.max(to)).contains(w);
    let margin = operation::required_margin(system).unwrap_or(MARGIN);
    let range = operation::among(&system.machine.extras).speed;
    system.machine.speed.filter(inside).map(|speed| Operating { speed, range: range.unwrap_or((speed, speed)), margin })
}

impl Operating {
    /// The speed, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// A line at it.
    pub fn rule(&self) -> Rule {
        Rule::x(self.speed, "operating speed")
    }

    /// The separation margin about the operating speeds.
    pub fn margin(&self) -> Band {
        let name = Message::new("label-operating-margin").arg("margin", Arg::percent(self.margin));
        let (low, high) = self.range;
        Band::x(low - self.margin * low.abs(), high + self.margin * high.abs()).name(name).neutral()
    }
}
