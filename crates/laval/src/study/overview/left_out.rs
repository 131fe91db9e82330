//! What the page does not take into account.

use super::{Facts, NEAR};
use crate::model::system::Drive;
use crate::outcome::{Arg, Message};
use crate::study::Study;
use crate::study::nonlinear::nonlinear_response::NonlinearResponse;

/// Sentences, the most consequential first.
pub(super) fn left_out(facts: &Facts) -> Vec<Message> {
    let mut out = Vec::new();
    let system = facts.system;
    let nonlinear: Vec<&str> = system.slots().iter().filter(|s| !s.is_linear()).map(|s| s.name.as_str()).collect();
    let kept = facts.outcomes.iter().any(|o| o.kind == NonlinearResponse::KIND);
    if !nonlinear.is_empty() && !facts.balls {
        let key = if kept { "left-linear-modes" } else { "left-linear" };
        out.push(Message::new(key).arg("parts", Arg::names(nonlinear)));
    }
    let spins: Vec<String> = system.spins().into_iter().filter_map(|s| s.name).collect();
    if !spins.is_empty() {
        out.push(Message::new("left-spins").arg("spins", Arg::names(spins.iter().map(String::as_str).collect::<Vec<_>>())));
    }
    let tilts = system.stations().iter().any(|b| b.tilt.is_some());
    let bends = system.stations().iter().any(|b| b.flexible);
    let word = match (bends, tilts) {
        (true, _) => "bends",
        (false, true) => "yes",
        (false, false) => "no",
    };
    out.push(Message::new("left-motions").arg("tilt", Arg::word(word)));
    out.push(Message::new("left-excitation"));
    if system.machine.drive == Drive::Prescribed {
        out.push(Message::new("left-drive"));
    }
    if let (Some(row), false) = (facts.stability.get(), facts.balls) {
        // edges are located between samples that differ; a range between two samples is not seen
        let step = row.samples.windows(2).map(|pair| pair[1].speed - pair[0].speed).fold(0.0, f64::max);
        let step = if step > 0.0 { step } else { facts.range.1 - facts.range.0 };
        let near = facts.near.as_ref().and(facts.operating);
        let fine = near.map(|o| ((1.0 + super::ABOUT) * o.high - (1.0 - super::ABOUT) * o.low) / (NEAR - 1) as f64);
        let m = Message::new(if fine.is_some() { "left-steps-near" } else { "left-steps" }).arg("step", Arg::speed(step).digits(2));
        out.push(m.arg("near", Arg::speed(fine.unwrap_or(step)).digits(2)));
    }
    out
}
