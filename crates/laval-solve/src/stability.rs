//! Stability along the spin speed: where the largest growth rate crosses a threshold, and where it peaks.
//!
//! A damped machine crosses the threshold transversally: the crossing is bracketed. An undamped one is unstable between double roots, which are
//! solved for as such ([`super::locate::double_root`]).
//!
//! Theory: `docs/theory/linear-vibration.md#stability-boundaries`.

use super::locate::{State, double_root, value_and_slope};
use super::pencil::Spectrum;
use super::sectors::Sector;
use super::spectra_ahead::{TOGETHER, at, together};
use super::sweep::{Passing, Sweep, follow_known, spectrum, sweep};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::{C64, c};
use laval_num::order::SortByNumber;
use laval_num::univariate::{maximum, root};
use serde::{Deserialize, Serialize};

/// Largest growth at a speed.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Sample {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Eigenvalue with the largest growth, Im s >= 0.
    pub value: C64,
    /// Its sector.
    pub sector: Option<Sector>,
    /// Largest modulus of all eigenvalues, 1/s: the scale of rounding.
    pub size: f64,
    /// Requested (not added to catch what lies between).
    pub on_grid: bool,
    /// Another mode than the strongest at the speed before.
    pub other: bool,
    /// Number of roots that grow faster than the threshold, where the argument principle was requested and agrees with the roots found.
    pub growing: Option<usize>,
    /// It was requested.
    pub counted: bool,
}

/// A crossing of the threshold.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Edge {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Growth rises through the threshold with the speed.
    pub onset: bool,
    /// Eigenvalue.
    pub value: C64,
    /// Solved for as a double root.
    pub double: bool,
    /// Interval that holds it.
    pub bracket: (f64, f64),
    /// Its equations were solved (or the bracket closed); otherwise only the bracket is known.
    pub located: bool,
    /// Uncertainty of the speed, rad/s.
    pub step: f64,
}

/// A maximum of the growth over the speed.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Peak {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Eigenvalue.
    pub value: C64,
    /// Interval that holds it.
    pub bracket: (f64, f64),
}

/// Stability along the speed.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Row {
    /// By speed.
    pub samples: Vec<Sample>,
    /// Crossings of the threshold.
    pub edges: Vec<Edge>,
    /// Peaks of the growth above the threshold.
    pub peaks: Vec<Peak>,
    /// Eigenvalues lie symmetric to the imaginary axis: nothing dissipates.
    pub undamped: bool,
    /// Stopped before the last speed.
    pub stopped: bool,
    /// Eigenproblems solved, or speeds at which roots were counted.
    pub solved: u64,
    /// Evaluations of the characteristic matrix for these counts.
    pub evaluations: u64,
    /// Frequency up to which roots were counted at every speed, rad/s; none where all modes were computed.
    pub frequency: Option<f64>,
}

fn sample(speed: f64, s: &Spectrum, on_grid: bool) -> Option<Sample> {
    s.least_stable().map(|m| Sample {
        speed,
        value: m.value,
        sector: m.sector,
        size: largest(s),
        on_grid,
        other: false,
        growing: None,
        counted: false,
    })
}

/// Relative growth that counts as rounding in an undamped machine: eigenvalues near a double root lose half the digits.
const NOISE: f64 = 1e-8;
/// Distance of two speeds, over the speed, at which they are one.
const APART: f64 = 1e-10;
/// Rise of the growth that makes a peak: over the eigenvalue, and over the largest of all where their rounding is larger.
const TOP: f64 = 1e-9;
const ROUNDING: f64 = 1e-14;

impl Row {
    /// The growth of a sample is above the threshold, and above rounding where nothing dissipates.
    pub fn unstable(&self, s: &Sample, threshold: f64) -> bool {
        above(s, threshold, self.undamped)
    }

    /// Ranges of speed, rad/s, between the located edges where the growth exceeds the threshold (the one the edges were located at), as far as computed.
    pub fn unstable_ranges(&self, threshold: f64) -> Vec<(f64, f64)> {
        let (Some(first), Some(last)) = (self.samples.first(), self.samples.last()) else { return Vec::new() };
        let mut out = Vec::new();
        let mut from = self.unstable(first, threshold).then_some(first.speed);
        for e in &self.edges {
            match from.take() {
                Some(a) if !e.onset => out.push((a, e.speed)),
                _ if e.onset => from = Some(e.speed),
                _ => {}
            }
        }
        out.extend(from.map(|a| (a, last.speed)));
        out
    }
}

fn above(s: &Sample, threshold: f64, undamped: bool) -> bool {
    let level = if undamped && threshold <= NOISE * s.size { NOISE * s.size } else { threshold };
    // a growth that is not a number is not stable
    s.value.re > level || s.value.re.is_nan()
}

fn largest(s: &Spectrum) -> f64 {
    s.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max)
}

fn symmetric(s: &Spectrum) -> bool {
    let tolerance = 10.0 * NOISE * largest(s);
    s.families.iter().all(|f| {
        f.modes.iter().all(|m| {
            let mirror = -m.value.conj();
            f.modes.iter().any(|o| (o.value - mirror).abs() <= tolerance)
        })
    })
}

/// Stability of a machine over ascending speeds; `each` receives the spectra computed so far before every
/// one and stops the work by saying false.
///
/// # Errors
/// As the spectrum at any speed.
pub fn row(system: &System, state: State, speeds: &[f64], threshold: f64, mut each: impl FnMut(u64) -> bool) -> Result<Row, Diagnostic> {
    let found = sweep(system, state, speeds, f64::INFINITY, |_, solved| each(solved))?;
    let mut out = Row { stopped: found.points.last().is_none_or(|p| Some(&p.0) != speeds.last()), ..Row::default() };
    let passings = undecided(&found, threshold);
    let mut all: Vec<(f64, Spectrum)> = found.points;
    // between two speeds where two modes pass each other lies an interaction that the grid may miss
    let mut solved = found.solved;

    let mut left = &passings[..];
    let mut block = 1;
    while !left.is_empty() {
        if !each(solved) {
            out.stopped = true;
            break;
        }
        let (some, rest) = left.split_at(block.min(left.len()));
        (left, block) = (rest, (2 * block).min(TOGETHER));
        for inside in together(some, |p| interaction(system, state, p, threshold)) {
            let inside = inside?;
            solved += inside.len() as u64;
            all.extend(inside);
        }
    }
    let on_grid = |w: f64| speeds.binary_search_by(|x| x.total_cmp(&w)).is_ok();
    all.sort_by_number(|a| a.0);
    // two samples at one speed differ by rounding: that of the grid stays
    all.dedup_by(|b, a| {
        let same = b.0 - a.0 <= APART * b.0.abs();
        if same && on_grid(b.0) {
            std::mem::swap(a, b);
        }
        same
    });
    out.solved = solved;
    let asymmetric = all.iter().filter(|p| !symmetric(&p.1)).count();
    out.undamped = asymmetric * 20 <= all.len();
    out.samples = all.iter().filter_map(|p| sample(p.0, &p.1, on_grid(p.0))).collect();
    for k in 1..out.samples.len() {
        out.samples[k].other = !goes_on(&out.samples[k - 1], &out.samples[k], &all);
    }
    for pair in out.samples.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if out.unstable(&a, threshold) == out.unstable(&b, threshold) {
            continue;
        }
        let edge = if out.undamped && threshold <= NOISE * b.size { band_edge(system, state, a, b) } else { None };
        let edge = edge.unwrap_or_else(|| threshold_edge(system, state, a, b, threshold));
        out.edges.push(edge);
    }
    for [a, b, c] in tops(&out, threshold) {
        let w = [out.samples[a], out.samples[b], out.samples[c]];
        let strongest = |speed: f64| -> Option<(C64, Option<Sector>)> {
            let s = spectrum(system, state, speed).ok()?.1;
            s.least_stable().map(|m| (m.value, m.sector))
        };
        let slope = |speed: f64| {
            let (value, sector) = strongest(speed)?;
            value_and_slope(system, state, speed, value, sector)
        };
        let found = peak(&out.edges, &w, slope, |speed| strongest(speed).map(|s| s.0));
        out.peaks.extend(found);
    }
    Ok(out)
}

/// Samples above the threshold that exceed their neighbours by more than rounding, between the nearest samples that are below them by more than that.
pub(super) fn tops(row: &Row, threshold: f64) -> Vec<[usize; 3]> {
    let s = &row.samples;
    let growth = |k: usize| s[k].value.re;
    let between = |k: usize| {
        let top = growth(k);
        let noise = TOP * s[k].value.abs() + ROUNDING * s[k].size;
        let fallen = |j: &usize| !(growth(*j) >= top - noise);
        let before = (0..k).rev().find(|j| fallen(j) || growth(*j) > top).filter(fallen)?;
        let after = (k + 1..s.len()).find(|j| fallen(j) || growth(*j) >= top).filter(fallen)?;
        Some([before, k, after])
    };
    (0..s.len()).filter(|&k| row.unstable(&s[k], threshold)).filter_map(between).collect()
}

/// The largest growth between the neighbours of the middle one of three samples, or the ends of the unstable range where these are nearer: where its `slope` vanishes, and
/// where that leads to less than the sample itself, as where growth begins like a square root or modes change places, by golden section on the `value`.
pub(super) fn peak(
    edges: &[Edge],
    w: &[Sample],
    slope: impl Fn(f64) -> Option<(C64, C64)>,
    value: impl Fn(f64) -> Option<C64>,
) -> Option<Peak> {
    let top = w[1];
    let within = |a: f64, b: f64| edges.iter().filter(move |e| e.located && e.speed > a && e.speed < b).map(|e| e.speed);
    let bracket = (within(w[0].speed, top.speed).fold(w[0].speed, f64::max), within(top.speed, w[2].speed).fold(w[2].speed, f64::min));
    let smooth = bracket == (w[0].speed, w[2].speed);
    let by_slope = || {
        let (a, b) = (slope(bracket.0)?, slope(bracket.1)?);
        let speed = root(|x| slope(x).map(|s| s.1.re), (bracket.0, a.1.re), (bracket.1, b.1.re), 1e-11 * bracket.1.abs())?;
        slope(speed).map(|s| Peak { speed, value: s.0, bracket })
    };
    let found = smooth.then(by_slope).flatten().filter(|p| p.value.re >= top.value.re);
    let searched = || {
        let (speed, _) = maximum(|x| value(x).map(|z| z.re), bracket.0, bracket.1, 1e-9 * bracket.1.abs())?;
        value(speed).map(|value| Peak { speed, value, bracket }).filter(|p| p.value.re >= top.value.re)
    };
    Some(found.or_else(searched).unwrap_or(Peak { speed: top.speed, value: top.value, bracket }))
}

/// The strongest mode at one speed is the strongest at the next: of all modes there the nearest one, seen from either side.
fn goes_on(a: &Sample, b: &Sample, all: &[(f64, Spectrum)]) -> bool {
    let nearest = |to: &Sample, among: &Sample| {
        let at = all.binary_search_by(|p| p.0.total_cmp(&among.speed)).ok()?;
        let values = all[at].1.modes.iter().map(|m| m.value);
        values.min_by(|x, y| (*x - to.value).abs().total_cmp(&(*y - to.value).abs()))
    };
    nearest(a, b) == Some(b.value) && nearest(b, a) == Some(a.value)
}

/// Passings at which a growth above the threshold may lie between the speeds.
fn undecided(found: &Sweep, threshold: f64) -> Vec<Passing> {
    // what is no number is not decided, nor is what was followed although shapes had mixed
    let open = |p: &&Passing| p.coupled() && !(p.highest() < threshold) || found.ambiguous.contains(&p.between);
    found.passings.iter().filter(open).copied().collect()
}

/// Halvings towards the speed where two modes pass each other.
const HALVINGS: usize = 8;

/// Spectra about the speed where two modes pass each other: nearer and nearer to it until the modes interact, or until no interaction can lift them above the threshold. A band
/// much narrower than the grid shows there.
fn interaction(system: &System, state: State, first: &Passing, threshold: f64) -> Result<Vec<(f64, Spectrum)>, Diagnostic> {
    let (lo, hi) = first.between;
    let middle = spectrum(system, state, first.at)?.1;
    if first.highest_at(&middle).is_some_and(|growth| growth < threshold) {
        return Ok(vec![(first.at, values(middle))]);
    }
    let wider = [lo, hi, 0.5 * (lo + first.at), 0.5 * (hi + first.at)];
    let mut known: Vec<(f64, Spectrum)> = Vec::new();
    for (w, found) in wider.into_iter().zip(at(system, state, &wider)) {
        known.push((w, found?));
    }
    let mut out: Vec<(f64, Spectrum)> = known.iter().skip(2).map(|(w, s)| (*w, values(s.clone()))).collect();
    known.truncate(2);
    known.insert(1, (first.at, middle));
    for _ in 0..HALVINGS {
        let inner = follow_known(system, state, known.clone())?;
        out.extend(inner.points.into_iter().map(|(w, s)| (w, values(s))));
        let Some(p) = inner.passings.first() else { break };
        let (lo, hi) = p.between;
        if hi - lo < 1e-7 * hi.abs() || p.at <= lo || p.at >= hi {
            break;
        }
        let middle = spectrum(system, state, p.at)?.1;
        if p.highest_at(&middle).is_some_and(|growth| growth < threshold) {
            out.push((p.at, values(middle)));
            break;
        }
        let mut ends = Vec::new();
        for w in [lo, hi] {
            // a halved step ends between the speeds known
            match known.iter().position(|k| k.0 == w) {
                Some(k) => ends.push(known[k].clone()),
                None => ends.push((w, spectrum(system, state, w)?.1)),
            }
        }
        ends.insert(1, (p.at, middle));
        known = ends;
    }
    Ok(out)
}

/// Values alone.
fn values(mut s: Spectrum) -> Spectrum {
    s.keep_values();
    s
}

fn band_edge(system: &System, state: State, a: Sample, b: Sample) -> Option<Edge> {
    let onset = above(&b, 0.0, true);
    let (mut stable, mut unstable) = if onset { (a.speed, b) } else { (b.speed, a) };
    let bracket = (a.speed, b.speed);
    for step in 0..40 {
        if (unstable.speed - stable).abs() < 1e-5 * unstable.speed.abs() {
            break;
        }
        // growth^2 is nearly linear in the speed close to the edge; halving keeps the bracket in any case
        let middle = 0.5 * (unstable.speed + stable);
        let s = sample(middle, &spectrum(system, state, middle).ok()?.1, false)?;
        if above(&s, 0.0, true) {
            unstable = s
        } else {
            stable = middle
        }
        if step >= 3
            && let Some(e) = solve_edge(system, state, &unstable, stable, onset, bracket)
        {
            return Some(e);
        }
    }
    solve_edge(system, state, &unstable, stable, onset, bracket)
}

fn solve_edge(system: &System, state: State, unstable: &Sample, stable: f64, onset: bool, bracket: (f64, f64)) -> Option<Edge> {
    // an unstable member of a backward pair belongs to the backward sector, and the characteristic matrix is taken there
    let found = double_root(system, state, 0.5 * (stable + unstable.speed), c(0.0, unstable.value.im), unstable.sector)?;
    let (lo, hi) = (stable.min(unstable.speed), stable.max(unstable.speed));
    // the edge itself may hide in the rounding just outside
    let slack = 3.0 * (hi - lo) + 1e-7 * hi.abs();
    let inside = found.speed >= bracket.0 && found.speed <= bracket.1;
    (inside && found.speed >= lo - slack && found.speed <= hi + slack).then_some(Edge {
        speed: found.speed,
        onset,
        value: found.value,
        double: true,
        bracket,
        located: true,
        step: found.step,
    })
}

fn threshold_edge(system: &System, state: State, a: Sample, b: Sample, threshold: f64) -> Edge {
    let onset = b.value.re > a.value.re;
    let at = |speed: f64| sample(speed, &spectrum(system, state, speed).ok()?.1, false);
    let tolerance = 1e-11 * b.speed.abs();
    let found =
        root(|w| at(w).map(|s| s.value.re - threshold), (a.speed, a.value.re - threshold), (b.speed, b.value.re - threshold), tolerance);
    let bracket = (a.speed, b.speed);
    match found.and_then(at) {
        Some(s) => Edge { speed: s.speed, onset, value: s.value, double: false, bracket, located: true, step: tolerance },
        None => {
            let middle = 0.5 * (a.speed + b.speed);
            Edge { speed: middle, onset, value: b.value, double: false, bracket, located: false, step: b.speed - a.speed }
        }
    }
}
