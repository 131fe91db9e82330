//! The least stable of a range of operating speeds, located between the speeds computed.

use super::operating::Operating;
use super::{Known, SECOND, limited};
use crate::model::system::System;
use crate::solve::pencil::{MachineMode, Spectrum};
use crate::solve::rest::over_speed;
use crate::solve::roots::transcendental;
use crate::solve::sweep::spectrum;
use crate::study::Context;
use crate::study::linear::whirl::far;
use laval_num::complex::C64;
use laval_num::univariate::maximum;
use std::f64::consts::TAU;

/// Speeds computed before the largest values between them are located.
const SPEEDS: usize = 60;
/// Width to which a speed is located, over the speed.
const WIDTH: f64 = 1e-7;

/// The least stable modes of a range of speeds.
#[derive(Clone, Debug)]
pub(super) struct Worst {
    /// Amount of the speed of the largest growth, rad/s.
    pub speed: f64,
    /// Eigenvalue there.
    pub value: C64,
    /// Number of modes there.
    pub modes: usize,
    /// The least logarithmic decrement, and the frequency of its mode, rad/s; none where nothing oscillates.
    pub decrement: Option<(f64, f64)>,
    /// Speeds with their sign at which the growth has a maximum.
    pub peaks: Vec<f64>,
}

/// Logarithmic decrement of a mode that oscillates.
pub(super) fn decrement(m: &MachineMode) -> f64 {
    -TAU * m.growth() / m.frequency()
}

/// Of modes that are not far above these speeds: higher ones are those of a division.
fn least(s: &Spectrum, fastest: f64) -> Option<(f64, f64)> {
    let oscillating = s.modes.iter().filter(|m| m.frequency() > 0.0 && !far(m, fastest));
    oscillating.map(|m| (decrement(m), m.frequency())).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Over a range; of roots without number the growth is known at single speeds alone, and is not searched.
pub(super) fn worst(system: &System, operating: Operating, sign: f64, context: &Context) -> Option<Worst> {
    if operating.is_one() || transcendental(system) {
        return None;
    }
    match limited(context, SECOND, || search(system, operating, sign)) {
        Known::Yes(found) => found,
        _ => None,
    }
}

fn search(system: &System, operating: Operating, sign: f64) -> Result<Option<Worst>, crate::diagnostic::Diagnostic> {
    let state = over_speed(system);
    let at = |w: f64| spectrum(system, &state, sign * w).map(|s| s.1);
    let step = (operating.high - operating.low) / (SPEEDS - 1) as f64;
    let speeds: Vec<f64> = (0..SPEEDS).map(|k| (operating.low + k as f64 * step).min(operating.high)).collect();
    let all = speeds.iter().map(|w| at(*w)).collect::<Result<Vec<Spectrum>, _>>()?;
    let growth = |s: &Spectrum| s.least_stable().map(MachineMode::growth);
    let tops = |value: &dyn Fn(&Spectrum) -> Option<f64>| -> Vec<f64> {
        let values: Vec<f64> = all.iter().map(|s| value(s).unwrap_or(f64::NEG_INFINITY)).collect();
        let high = |k: usize| values.get(k).copied().unwrap_or(f64::NEG_INFINITY);
        let top = |&k: &usize| (k == 0 || high(k) >= high(k - 1)) && high(k) >= high(k + 1) && high(k).is_finite();
        let locate = |k: usize| {
            let (a, b) = (speeds[k.saturating_sub(1)], speeds[(k + 1).min(SPEEDS - 1)]);
            let found = maximum(|w| value(&at(w).ok()?), a, b, WIDTH * operating.high);
            found.filter(|f| f.1 >= values[k]).map_or(speeds[k], |f| f.0)
        };
        (0..SPEEDS).filter(top).map(locate).collect()
    };
    let peaks = tops(&growth);
    let mut found: Option<Worst> = None;
    // a growth that is no number is the worst
    for (w, s) in speeds.iter().copied().zip(all.iter().cloned()).chain(located(&peaks, &at)) {
        let Some(m) = s.least_stable() else { continue };
        let worse = found.as_ref().is_none_or(|f| !(m.growth() <= f.value.re));
        if worse && !found.as_ref().is_some_and(|f| f.value.re.is_nan()) {
            found = Some(Worst { speed: w, value: m.value, modes: s.held().count(), decrement: None, peaks: Vec::new() });
        }
    }
    let damped = tops(&|s| least(s, operating.high).map(|d| -d.0));
    let decrements = all.iter().cloned().chain(located(&damped, &at).map(|p| p.1)).filter_map(|s| least(&s, operating.high));
    let decrement = decrements.min_by(|a, b| a.0.total_cmp(&b.0));
    let peaks = peaks.into_iter().map(|w| sign * w).collect();
    Ok(found.map(|f| Worst { decrement, peaks, ..f }))
}

fn located<'a>(
    speeds: &'a [f64],
    at: &'a dyn Fn(f64) -> Result<Spectrum, crate::diagnostic::Diagnostic>,
) -> impl Iterator<Item = (f64, Spectrum)> + 'a {
    speeds.iter().filter_map(move |w| at(*w).ok().map(|s| (*w, s)))
}
