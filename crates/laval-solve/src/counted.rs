//! Stability along the speed of a machine with parts that have no time form: at every speed the roots that grow faster than the threshold, counted; between
//! speeds where their number changes the root that crosses, followed by Newton's method.

use super::follow::signed;
use super::locate::{State, carried, value_and_slope};
use super::roots::{LEAST, Request, Roots, roots};
use super::stability::{Edge, Row, Sample, peak, tops};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::univariate::root;
use laval_num::work::piece;
use std::sync::atomic::{AtomicBool, Ordering};

/// Roots that may cross the threshold between two speeds, at most.
const CROSSINGS: usize = 8;
/// How far beside a root, over the speed, others are counted.
const BESIDE: f64 = 1e-5;
/// Growth over the largest frequency that is no growth.
const SAME: f64 = 1e-9;
/// Halvings of a step between two speeds along which a root is followed.
const DEPTH: usize = 6;

fn sample(speed: f64, found: &Roots) -> Option<Sample> {
    let least = found.spectrum.least_stable()?;
    let size = found.spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
    Some(Sample {
        speed,
        value: least.value,
        sector: least.sector,
        size,
        on_grid: true,
        other: false,
        growing: found.growing(),
        counted: true,
    })
}

/// As [`row`](super::stability::row); growth is assessed against `threshold` or, where the domain of the parts ends above it, against that end, which is returned.
///
/// # Errors
/// As [`roots`].
pub fn row(
    system: &System,
    state: State,
    speeds: &[f64],
    threshold: f64,
    (frequency, cancel): (Option<f64>, &AtomicBool),
    mut each: impl FnMut(u64) -> bool,
) -> Result<Row, Diagnostic> {
    let mut out = Row::default();
    let mut starts: Vec<C64> = Vec::new();
    for (k, &speed) in speeds.iter().enumerate() {
        if !each(k as u64) {
            out.stopped = true;
            break;
        }
        let request = Request { margin: threshold, frequency, growing: true, starts: &starts, cancel: Some(cancel), ..Request::default() };
        let about = state(speed)?;
        let Some(found) = piece(|| roots(system, &about, &request)) else {
            out.stopped = true;
            return Ok(out);
        };
        let found = found?;
        if cancel.load(Ordering::Relaxed) {
            out.stopped = true;
            break;
        }
        out.evaluations += found.evaluations;
        out.frequency = Some(out.frequency.map_or(found.frequency, |f| f.min(found.frequency)));
        out.solved += 1;
        starts = found.spectrum.modes.iter().map(|m| signed(m.value, m.sector)).collect();
        out.samples.extend(sample(speed, &found));
    }
    for k in 1..out.samples.len() {
        if cancel.load(Ordering::Relaxed) {
            out.stopped = true;
            return Ok(out);
        }
        let (a, b) = (out.samples[k - 1], out.samples[k]);
        let led = carried(system, state, (a.speed, a.value), b.speed, a.sector, 0);
        out.samples[k].other = !led.is_some_and(|z| (z - b.value).abs() <= 1e-6 * b.value.abs());
    }
    for pair in out.samples.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if out.unstable(&a, threshold) == out.unstable(&b, threshold) {
            continue;
        }
        if !each(out.solved) {
            out.stopped = true;
            return Ok(out);
        }
        let mut found = edge(system, state, a, b, threshold);
        // another root may have crossed before: then it is the edge
        for _ in 0..CROSSINGS {
            if !found.located || cancel.load(Ordering::Relaxed) {
                break;
            }
            let starts = [a.value, b.value, found.value];
            // the root that crosses here is not to lie on the edge of a rectangle
            let aside = BESIDE * found.speed.abs();
            let margin = if threshold - aside >= LEAST * found.speed.abs() { threshold - aside } else { threshold + aside };
            let request = Request { margin, frequency, growing: true, starts: &starts, cancel: Some(cancel), ..Request::default() };
            let there = roots(system, &state(found.speed)?, &request)?;
            out.evaluations += there.evaluations;
            let Some(s) = sample(found.speed, &there).filter(|s| s.value.re > threshold + SAME * s.size) else { break };
            let (from, to) = if found.onset { (a, s) } else { (s, b) };
            found = Edge { bracket: (a.speed, b.speed), ..edge(system, state, from, to, threshold) };
        }
        out.edges.push(found);
    }
    for [a, b, c] in tops(&out, threshold) {
        let w = [out.samples[a], out.samples[b], out.samples[c]];
        if !each(out.solved) {
            out.stopped = true;
            return Ok(out);
        }
        let (near, sector) = ((w[1].speed, w[1].value), w[1].sector);
        let value = |speed: f64| carried(system, state, near, speed, sector, DEPTH);
        let slope = |speed: f64| value_and_slope(system, state, speed, value(speed)?, sector);
        let found = peak(&out.edges, &w, slope, value);
        out.peaks.extend(found);
    }
    Ok(out)
}

/// Where the root that grows on one side crosses the threshold.
fn edge(system: &System, state: State, a: Sample, b: Sample, threshold: f64) -> Edge {
    let onset = b.value.re > a.value.re;
    let unstable = if onset { b } else { a };
    let start = (unstable.speed, unstable.value);
    let at = |speed: f64| carried(system, state, start, speed, unstable.sector, DEPTH);
    let tolerance = 1e-11 * b.speed.abs();
    let ends = (at(a.speed), at(b.speed));
    let found = match ends {
        (Some(p), Some(q)) => {
            root(|w| at(w).map(|z| z.re - threshold), (a.speed, p.re - threshold), (b.speed, q.re - threshold), tolerance)
        }
        _ => None,
    };
    let bracket = (a.speed, b.speed);
    match found.and_then(|w| Some((w, at(w)?))) {
        Some((speed, value)) => Edge { speed, onset, value, double: false, bracket, located: true, step: tolerance },
        None => {
            let middle = 0.5 * (a.speed + b.speed);
            Edge { speed: middle, onset, value: b.value, double: false, bracket, located: false, step: b.speed - a.speed }
        }
    }
}
