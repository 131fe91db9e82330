//! Where the range of the first page begins: at or below the lowest critical speed, however far that is below the operating speeds.

use super::{Known, within};
use crate::model::system::System;
use crate::study::Context;
use crate::study::linear::modes::Modes;
use crate::study::shared::support::About;

/// A lower speed at which the modes are counted again, over the speed before.
const LOWER: f64 = 1e-3;
/// How often that is repeated.
const ROUNDS: usize = 3;
/// Frequencies below this share of the largest are rounding.
const ROUNDING: f64 = 1e-7;

/// The first speed of the page, rad/s, an amount: `from`, or a lower one where a mode meets one of these multiples of the speed below it, or a part has a row of a table
/// there. Where the modes at these speeds are refused or take longer than a second it stays, and what lies below is not examined.
pub(super) fn begin(system: &System, from: f64, sign: f64, orders: &[f64], context: &Context) -> f64 {
    let ends = [0.0, sign * from];
    let rows = system.table_speeds(ends[0].min(ends[1]), ends[0].max(ends[1]));
    let mut begin = rows.into_iter().map(f64::abs).fold(from, f64::min);
    for _ in 0..ROUNDS {
        let lower = LOWER * begin;
        let passed = |speed: f64, rounding: f64| passed(system, sign * speed, orders, rounding, context);
        match (passed(begin, ROUNDING), passed(lower, 0.0)) {
            (Some(here), Some(before)) if here > before => begin = lower,
            _ => break,
        }
    }
    begin
}

/// How many modes lie below the multiples of a speed; not known where they take too long or the machine has none there.
fn passed(system: &System, speed: f64, orders: &[f64], rounding: f64, context: &Context) -> Option<usize> {
    let study = Modes { speed, about: About::Rest, threshold: 0.0, frequency: None };
    let Known::Yes(found) = within(&study, system, context) else { return None };
    let frequencies: Vec<f64> = found.spectrum.modes.iter().map(|m| m.frequency()).collect();
    let least = rounding * found.spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
    let below = |f: f64| orders.iter().filter(|k| f < (*k * speed).abs()).count();
    Some(frequencies.into_iter().filter(|f| *f > least).map(below).sum())
}
