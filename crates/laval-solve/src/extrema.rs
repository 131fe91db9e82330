//! The synchronous response over the speed on a grid that is refined where it bends, and its maxima and minima.

use super::characteristic::Equilibrium;
use super::criticals::criticals;
use super::extremum::{BESIDE, Search};
use super::linear_response::{Ahead, Response, is_known, response};
use super::locate::State;
use super::sweep::{Strongest, sweep};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use laval_num::complex::c;
use laval_num::order::ascending;
use serde::{Deserialize, Serialize};

/// A maximum or minimum of an amplitude.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Extremum {
    /// Probe, in the order requested.
    pub probe: usize,
    /// A maximum.
    pub maximum: bool,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Amplitude, m or rad; NaN for a maximum that is [`unbounded`](Self::unbounded).
    pub value: f64,
    /// A pole: the amplitude grows without bound, nothing dissipates.
    pub unbounded: bool,
    /// Interval that holds it.
    pub bracket: (f64, f64),
}

/// Response over the speed.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Curve {
    /// By speed.
    pub points: Vec<Response>,
    /// By probe, then speed.
    pub extrema: Vec<Extremum>,
    /// Speeds requested at which the response is infinite, exactly or to rounding: those without response, and ends of the range.
    pub singular: Vec<f64>,
    /// Speeds where a part has no accurate reaction, and the response is not known.
    pub unknown: Vec<f64>,
    /// Not stopped early.
    pub complete: bool,
    /// Linear systems solved.
    pub solved: u64,
}

impl Curve {
    /// Speeds at which the response has no bound, rising.
    pub fn poles(&self) -> Vec<f64> {
        let maxima = self.extrema.iter().filter(|e| e.unbounded).map(|e| e.speed);
        let mut out: Vec<f64> = maxima.chain(self.singular.iter().copied()).collect();
        ascending(&mut out);
        out.dedup_by(|b, a| (*b - *a).abs() <= FAR * NARROW * a.abs());
        out
    }
}

/// Frequency above which no mode can meet an excitation of this frequency on its way through the speeds computed.
pub fn above(excitation: f64) -> f64 {
    2.0 * excitation
}

/// Where a response is looked at closely, and how stable the machine is on the way.
#[derive(Clone, Debug, Default)]
pub struct Seeds {
    /// Speeds, rad/s.
    pub speeds: Vec<f64>,
    /// The mode that grows most at every speed of the search.
    pub strongest: Vec<Strongest>,
}

/// Speeds around every crossing of a frequency with the spin speed, spaced by the width of its resonance; `each` receives the spectra computed
/// so far and stops the search by saying false.
///
/// # Errors
/// As the spectrum.
pub fn seeds(system: &System, state: State, from: f64, to: f64, each: &mut dyn FnMut(u64) -> bool) -> Result<Seeds, Diagnostic> {
    // eigenvalues of a large machine are dear, and between far speeds the sweep halves by itself where shapes mix
    let points = if system.n() > 40 { 20 } else { 60 };
    let speeds = crate::model::field::RangeValue { from, to, points: Some(points) }.linspace(points);
    let found = sweep(system, state, &speeds, above(from.abs().max(to.abs())), |_, solved| each(solved))?;
    let mut out = Vec::new();
    for c in criticals(system, state, &found, &[1.0]) {
        let width = c.growth.abs().max(1e-9 * c.speed.abs());
        for k in [0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0] {
            out.extend([c.speed - k * width, c.speed + k * width]);
        }
    }
    out.retain(|&w| w >= from && w <= to);
    Ok(Seeds { speeds: out, strongest: found.strongest })
}

/// Deepest halving of an interval.
const DEPTH: usize = 24;
/// Bend of the logarithm of an amplitude at which an interval is halved.
const BEND: f64 = 0.05;

/// Amplitude over the largest one that is rounding.
const STILL: f64 = 1e-12;

/// Amplitude up to which a probe shows rounding alone where the largest, over its typical size, is `loudest`.
fn still(loudest: f64, probe: &Probe) -> f64 {
    (STILL * loudest * probe.typical()).max(f64::MIN_POSITIVE)
}

/// The largest amplitude of a response over its typical size.
fn loudest(r: &Response, probes: &[Probe]) -> f64 {
    probes.iter().map(|p| r.size(p) / p.typical()).fold(0.0, f64::max)
}

/// Damping ratio below which a resonance counts as undamped: its width is that of rounding.
const NARROW: f64 = 1e-9;
/// Multiple of [`NARROW`] at which the amplitude beside a pole has fallen, and by how much at least.
const FAR: f64 = 1e3;
const STEEP: f64 = 30.0;

/// The amplitude still grows as 1/distance where a resonance of damping ratio [`NARROW`] is already round.
fn pole(value: impl Fn(f64) -> Option<f64>, speed: f64) -> bool {
    let beside = |d: f64| Some(value(speed - d * speed)?.max(value(speed + d * speed)?));
    match (beside(10.0 * NARROW), beside(FAR * NARROW)) {
        (Some(near), Some(far)) => near > STEEP * far,
        (None, _) => true,
        _ => false,
    }
}

/// A computed response is what rounding makes of infinity, where it is seen by these probes: as `pole`, of all of them at once.
pub fn unbounded_at(system: &System, state: State, probes: &[Probe], speed: f64) -> bool {
    let beside = |d: f64| -> Vec<Response> {
        [-d, d].into_iter().filter_map(|d| response(system, state, speed + d * speed).ok().flatten()).collect()
    };
    let (near, far) = (beside(10.0 * NARROW), beside(FAR * NARROW));
    let largest = |of: &[Response], p: &Probe| of.iter().map(|r| r.size(p)).fold(0.0, f64::max);
    // what moves by rounding alone has no pole
    let loudest = far.iter().map(|r| loudest(r, probes)).fold(0.0, f64::max);
    !near.is_empty() && !far.is_empty() && probes.iter().any(|p| largest(&near, p) > (STEEP * largest(&far, p)).max(still(loudest, p)))
}

/// The response at a critical speed of a mode that nothing excites: that beside it. None where it has no bound.
fn through(system: &System, state: State, probes: &[Probe], speed: f64) -> Option<Response> {
    if unbounded_at(system, state, probes, speed) {
        return None;
    }
    let beside = |d: f64| response(system, state, speed + d * speed).ok().flatten();
    beside(10.0 * NARROW).or_else(|| beside(-10.0 * NARROW)).map(|r| Response { speed, ..r })
}

/// Growth of an amplitude from twice a distance beside a pole to that distance from which on it shares the pole.
const SHARES: f64 = 1.01;

/// Response over given speeds and between them, with the extrema of the amplitudes of these probes; `each` stops the work by saying false.
///
/// # Errors
/// As the state.
pub fn curve(
    system: &System,
    state: &(dyn Fn(f64) -> Result<Equilibrium, Diagnostic> + Sync),
    mut speeds: Vec<f64>,
    probes: &[Probe],
    each: &mut dyn FnMut(u64) -> bool,
) -> Result<Curve, Diagnostic> {
    ascending(&mut speeds);
    // two crossings at one speed seed the same points twice, but for rounding
    speeds.dedup_by(|b, a| *b - *a <= 1e-8 * b.abs());
    let mut out = Curve { complete: true, ..Curve::default() };
    let mut ahead = Ahead::new(system, state, &speeds);
    // intervals still to be looked at, the leftmost last, with the response at their right end where it is known
    let mut right: Vec<(f64, usize, Option<Response>)> = speeds.iter().rev().map(|&w| (w, 0, None)).collect();
    while let Some((w, depth, known)) = right.pop() {
        if !each(out.solved) {
            out.complete = false;
            break;
        }
        let r = match known {
            Some(r) => r,
            None => {
                out.solved += 1;
                match ahead.at(w)? {
                    Some(r) => r,
                    None if !is_known(system, state, w)? => {
                        out.unknown.push(w);
                        continue;
                    }
                    None => match through(system, state, probes, w) {
                        Some(r) => r,
                        None => {
                            out.singular.push(w);
                            continue;
                        }
                    },
                }
            }
        };
        if let Some(left) = out.points.last()
            && depth < DEPTH
            && w - left.speed > 1e-9 * w.abs()
        {
            let middle = 0.5 * (left.speed + w);
            out.solved += 1;
            let loudest = loudest(left, probes).max(loudest(&r, probes));
            let bent = ahead.at(middle)?.filter(|m| {
                probes.iter().any(|p| {
                    let (a, b, c) = (left.size(p), m.size(p), r.size(p));
                    // products of amplitudes can underflow
                    let bend = ((b / a) * (b / c)).ln().abs() * 0.5;
                    a.min(c) > still(loudest, p) && (bend > BEND || bend.is_nan())
                })
            });
            if bent.is_some() {
                right.push((w, depth + 1, Some(r)));
                right.push((middle, depth + 1, bent));
                continue;
            }
        }
        out.points.push(r);
    }
    let largest = |p: &Probe| out.points.iter().map(|r| r.size(p)).fold(0.0, f64::max);
    let loudest = out.points.iter().map(|r| loudest(r, probes)).fold(0.0, f64::max);
    let computed = |w: f64| response(system, state, w).ok().flatten();
    let mut search = Search::new(&computed);
    for (probe, sight) in probes.iter().enumerate() {
        // what moves by rounding alone has no resonance
        if largest(sight) <= still(loudest, sight) {
            continue;
        }
        let mut found: Vec<Extremum> = Vec::new();
        for (k, p) in out.points.windows(3).enumerate() {
            let (a, b, c) = (p[0].size(sight), p[1].size(sight), p[2].size(sight));
            let (up, down) = (b > a && b >= c, b < a && b <= c);
            if !(up || down) {
                continue;
            }
            let first = k.saturating_sub(BESIDE);
            let around = &out.points[first..(k + 3 + BESIDE).min(out.points.len())];
            if let Some((speed, value)) = search.extremum(around, k + 1 - first, sight, up) {
                let bracket = (p[0].speed, p[2].speed);
                // an amplitude that rises so little over so much cannot be a pole
                let reach = FAR * NARROW * speed.abs();
                let shallow = value <= STEEP * a.max(c) && bracket.0 <= speed - reach && speed + reach <= bracket.1;
                let unbounded = up && !shallow && pole(|w| search.at(w, sight), speed);
                found.push(Extremum { probe, maximum: up, speed, value, unbounded, bracket });
            }
        }
        // a shallow minimum between two resonances is no antiresonance, a ripple of rounding no resonance
        let deep: Vec<bool> = (0..found.len())
            .map(|k| {
                let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|j| found.get(j));
                let ends = [out.points.first(), out.points.last()].into_iter().flatten().map(|r| r.size(sight));
                let least =
                    beside.map(|e| e.value).chain(ends).filter(|&v| if found[k].maximum { v < found[k].value } else { v > found[k].value });
                if found[k].maximum {
                    least.fold(0.0, f64::max) < found[k].value * (1.0 - 1e-6)
                } else {
                    least.fold(f64::INFINITY, f64::min) > 10.0 * found[k].value
                }
            })
            .collect();
        out.extrema.extend(found.into_iter().zip(deep).filter_map(|(e, keep)| keep.then_some(e)));
    }
    let mut ends: Vec<f64> = [out.points.first(), out.points.last()].into_iter().flatten().map(|r| r.speed).collect();
    ends.dedup();
    ends.retain(|&w| unbounded_at(system, state, probes, w));
    out.singular.extend(ends);
    // beside a pole the numbers are what rounding makes of infinity
    let poles = out.poles();
    let at_pole = |w: f64| poles.iter().any(|p| (w - p).abs() <= FAR * NARROW * p.abs());
    for e in out.extrema.iter_mut().filter(|e| e.maximum && at_pole(e.speed)) {
        let beside =
            |d: f64| Some(search.at(e.speed - d * e.speed, &probes[e.probe])?.max(search.at(e.speed + d * e.speed, &probes[e.probe])?));
        let shares = match (beside(10.0 * NARROW), beside(20.0 * NARROW)) {
            (Some(near), Some(far)) => near > SHARES * far,
            _ => true,
        };
        e.unbounded |= shares;
        e.value = f64::NAN;
    }
    // a maximum of rounding
    out.extrema.retain(|e| !e.maximum || e.unbounded || !at_pole(e.speed));
    for p in out.points.iter_mut().filter(|p| at_pole(p.speed)) {
        p.x.fill(c(f64::NAN, f64::NAN));
        p.residual = f64::NAN;
    }
    Ok(out)
}
