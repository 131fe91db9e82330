//! Stability along the speed of a machine with parts that have no time form: at every speed the roots that grow faster than the threshold, counted; between
//! speeds where their number changes the root that crosses, followed by Newton's method.

use super::follow::signed;
use super::locate::{State, carried, value_and_slope};
use super::roots::{LEAST, Request, Roots, roots};
use super::spectra_ahead::together;
use super::stability::{Edge, Row, Sample, peak, tops};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::univariate::root;
use laval_num::work::piece;
use std::ops::Range;
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

/// Speeds of a piece of the range, at least, and pieces at most, whatever the number of processors.
const PIECE: usize = 20;
const PIECES: usize = 4;

/// A range of speeds in pieces, one where nothing may be done beside it.
fn pieces(speeds: usize, beside: bool) -> Vec<Range<usize>> {
    let count = if beside { (speeds / PIECE).clamp(1, PIECES) } else { 1 };
    (0..count).map(|k| k * speeds / count..(k + 1) * speeds / count).collect()
}

/// What is sought at every speed.
struct Search<'a> {
    system: &'a System,
    state: State<'a>,
    threshold: f64,
    frequency: Option<f64>,
    cancel: &'a AtomicBool,
}

impl Search<'_> {
    fn request<'r>(&self, margin: f64, starts: &'r [C64]) -> Request<'r>
    where
        Self: 'r,
    {
        Request { margin, frequency: self.frequency, growing: true, starts, ..Request::default() }
    }

    /// Samples at some speeds, and whether it was ended from within; `first` is the number of the first of them.
    fn along(&self, speeds: &[f64], first: u64, each: &(impl Fn(u64) -> bool + Sync)) -> Result<(Row, bool), Diagnostic> {
        let mut out = Row::default();
        let mut starts: Vec<C64> = Vec::new();
        for (k, &speed) in speeds.iter().enumerate() {
            if !each(first + k as u64) {
                out.stopped = true;
                break;
            }
            let about = (self.state)(speed)?;
            let request = Request { cancel: Some(self.cancel), ..self.request(self.threshold, &starts) };
            let Some(found) = piece(|| roots(self.system, &about, &request)) else {
                out.stopped = true;
                return Ok((out, true));
            };
            let found = found?;
            if self.cancel.load(Ordering::Relaxed) {
                out.stopped = true;
                break;
            }
            out.evaluations += found.evaluations;
            out.frequency = Some(out.frequency.map_or(found.frequency, |f| f.min(found.frequency)));
            starts = found.spectrum.modes.iter().map(|m| signed(m.value, m.sector)).collect();
            out.samples.extend(sample(speed, &found));
        }
        Ok((out, false))
    }

    /// The first crossing of the threshold between two samples, and the evaluations of the characteristic matrix that it took.
    fn first_edge(&self, a: Sample, b: Sample) -> Result<(Edge, u64), Diagnostic> {
        let (threshold, mut evaluations) = (self.threshold, 0);
        let mut found = edge(self.system, self.state, a, b, threshold);
        // another root may have crossed before: then it is the edge
        for _ in 0..CROSSINGS {
            if !found.located || self.cancel.load(Ordering::Relaxed) {
                break;
            }
            let starts = [a.value, b.value, found.value];
            // the root that crosses here is not to lie on the edge of a rectangle
            let aside = BESIDE * found.speed.abs();
            let margin = if threshold - aside >= LEAST * found.speed.abs() { threshold - aside } else { threshold + aside };
            let request = Request { cancel: Some(self.cancel), ..self.request(margin, &starts) };
            let there = roots(self.system, &(self.state)(found.speed)?, &request)?;
            evaluations += there.evaluations;
            let Some(s) = sample(found.speed, &there).filter(|s| s.value.re > threshold + SAME * s.size) else { break };
            let (from, to) = if found.onset { (a, s) } else { (s, b) };
            found = Edge { bracket: (a.speed, b.speed), ..edge(self.system, self.state, from, to, threshold) };
        }
        Ok((found, evaluations))
    }
}

/// As [`row`](super::stability::row); growth is assessed against `threshold` or, where the domain of the parts ends above it, against that end, which is returned. `beside`: pieces of the range
/// may be computed beside each other; under a bound on the work where they end depends on the number of threads.
///
/// # Errors
/// As [`roots`].
pub fn row(
    system: &System,
    state: State,
    speeds: &[f64],
    threshold: f64,
    (frequency, cancel, beside): (Option<f64>, &AtomicBool, bool),
    each: impl Fn(u64) -> bool + Sync,
) -> Result<Row, Diagnostic> {
    let search = Search { system, state, threshold, frequency, cancel };
    let mut out = Row::default();
    // the roots at a speed make the search at the next one short, and prove nothing: pieces of the range begin without
    let pieces = pieces(speeds.len(), beside);
    for found in together(&pieces, |some| search.along(&speeds[some.clone()], some.start as u64, &each)) {
        let (found, halted) = found?;
        out.evaluations += found.evaluations;
        out.solved += found.samples.len() as u64;
        if let Some(f) = found.frequency {
            out.frequency = Some(out.frequency.map_or(f, |known: f64| known.min(f)));
        }
        out.samples.extend(found.samples);
        out.stopped = found.stopped;
        if halted {
            return Ok(out);
        }
        if out.stopped {
            break;
        }
    }
    let steps: Vec<(Sample, Sample)> = out.samples.windows(2).map(|w| (w[0], w[1])).collect();
    let goes_on = |(a, b): &(Sample, Sample)| {
        let led = carried(system, state, (a.speed, a.value), b.speed, a.sector, 0);
        led.is_some_and(|z| (z - b.value).abs() <= 1e-6 * b.value.abs())
    };
    let same = together(&steps, |pair| (!cancel.load(Ordering::Relaxed)).then(|| goes_on(pair)));
    for (sample, same) in out.samples.iter_mut().skip(1).zip(same) {
        let Some(same) = same else {
            out.stopped = true;
            return Ok(out);
        };
        sample.other = !same;
    }
    let crossed: Vec<(Sample, Sample)> =
        steps.into_iter().filter(|(a, b)| out.unstable(a, threshold) != out.unstable(b, threshold)).collect();
    if !crossed.is_empty() && !each(out.solved) {
        out.stopped = true;
        return Ok(out);
    }
    for found in together(&crossed, |(a, b)| search.first_edge(*a, *b)) {
        let (edge, evaluations) = found?;
        out.evaluations += evaluations;
        out.edges.push(edge);
    }
    if cancel.load(Ordering::Relaxed) {
        out.stopped = true;
        return Ok(out);
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
