//! Unbalance of other spins than that of the machine: their vibration adds to that of the machine, at another frequency, so that at times the largest values of all add up.

use super::studied::{self, Needed};
use crate::model::system::System;
use crate::outcome::{Arg, Message, Outcome, Verdict};
use crate::solve::characteristic::Characteristic;
use crate::solve::rest::rest;
use crate::study::linear::forced_response::ForcedResponseResult;

/// The other spins with loads.
#[derive(Default)]
pub(super) struct Spins {
    /// Responses at the operating speeds that studies of the file computed, by the names of the spins, with the lowest and the highest speed of each, amounts.
    pub known: Vec<(String, ForcedResponseResult, (f64, f64))>,
    /// Those that no study of the file took.
    pub left_out: Vec<String>,
}

impl Spins {
    /// At the operating speeds, with their sign.
    pub fn of(system: &System, outcomes: &[Outcome], low: f64, high: f64) -> Spins {
        let mut out = Spins::default();
        let loaded = |name: &str, ratio: f64| {
            let own = system.at_spin(name).ok()?;
            let about = rest(&own, ratio * high).ok()?;
            Some(Characteristic::new(&own, &about).loads().1.iter().any(|f| f.abs() > 0.0))
        };
        for spin in system.spins() {
            let Some(name) = spin.name.filter(|name| loaded(name, spin.ratio).unwrap_or(true)) else { continue };
            match studied::spin_response(outcomes, &name, Needed::between(spin.ratio * low, spin.ratio * high)) {
                Some(found) => out.known.push((name, found, ((spin.ratio * low).abs(), (spin.ratio * high).abs()))),
                None => out.left_out.push(name),
            }
        }
        out
    }

    /// A limit is not known to be kept where loads are left out.
    pub fn kept(&self, verdict: Verdict) -> Verdict {
        if self.left_out.is_empty() || verdict == Verdict::Failed { verdict } else { Verdict::NotComputed }
    }

    /// That the response is without their unbalance, or has it added; none where there is no other spin.
    pub fn remark(&self) -> Option<Message> {
        let names = |all: Vec<&str>| Arg::names(all);
        if !self.left_out.is_empty() {
            return Some(Message::new("response-without-spins").arg("spins", names(self.left_out.iter().map(String::as_str).collect())));
        }
        let known: Vec<&str> = self.known.iter().map(|k| k.0.as_str()).collect();
        (!known.is_empty()).then(|| Message::new("response-with-spins").arg("spins", names(known)))
    }
}
