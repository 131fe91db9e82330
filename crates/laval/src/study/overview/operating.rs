//! The speeds at which the machine runs.

use crate::model::system::System;
use crate::outcome::{Arg, Message};
use crate::study::shared::operation::Operation;

/// Amounts of the operating speeds, rad/s: one speed has two equal ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Operating {
    /// The lowest.
    pub low: f64,
    /// The highest.
    pub high: f64,
}

impl Operating {
    /// Those of `[operation]`, else that of the machine; none at standstill.
    pub fn of(system: &System, operation: &Operation) -> Option<Operating> {
        let speed = system.machine.speed.filter(|w| *w != 0.0)?;
        let (a, b) = operation.speed.unwrap_or((speed, speed));
        Some(Operating { low: a.abs().min(b.abs()), high: a.abs().max(b.abs()) })
    }

    /// One speed, not a range.
    pub fn is_one(&self) -> bool {
        self.low == self.high
    }

    /// One of the operating speeds.
    pub fn contains(&self, speed: f64) -> bool {
        (self.low..=self.high).contains(&speed)
    }

    /// As an argument of a sentence: a speed, or a range.
    pub fn arg(&self) -> Arg {
        if self.is_one() { Arg::speed(self.high) } else { span(self.low, self.high) }
    }
}

/// A range of speeds as an argument of a sentence.
pub(super) fn span(from: f64, to: f64) -> Arg {
    Message::new("speed-span").arg("from", Arg::speed(from)).arg("to", Arg::speed(to)).into()
}
