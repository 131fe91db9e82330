//! Modes of a machine with parts in a table over the frequency of vibration, each with the coefficients of its own frequency.
//!
//! ```text
//! det T(s; W, nu) = 0,   |Im s| = nu        (a mode that does not oscillate: nu = 0)
//! ```
//!
//! `T(.; W, nu)` is the characteristic matrix of the machine whose parts have the coefficients of nu at every frequency ([`System::frozen`]), an ordinary one. The modes sought
//! are the fixed points of `nu -> |Im s_k(nu)|`. Each is solved for by the secant method on `|Im s(nu)| - nu`, with s(nu) polished on T, or by Brent's method where a mode is on different sides
//! of the line at two frequencies.
//!
//! That none is missed is counted: with nu rising, a mode of the frozen machine falls below the line `Im s = nu` where it meets it from above (`d|Im s|/d nu < 1`), or rises
//! above it. So the number of modes below the line at the end of an interval, less that at its beginning, is the net number of fixed points inside; a pair of
//! conjugates counts twice and an aperiodic root once, so that two of them may meet. An interval whose fixed points do not make up its number is halved. Two that pass the line
//! in opposite directions within the shortest interval, and that no start leads to, remain unseen.
//!
//! Theory: `docs/theory/linear-vibration.md#coefficients-over-the-frequency`.

pub mod follow;

use crate::characteristic::{Characteristic, Equilibrium, Polished};
use crate::large::{is_large, usual_frequency};
use crate::machine_mode::{MachineMode, Unknowns};
use crate::pencil::modes_about;
use crate::roots::{Request, in_region, mode, roots, uncoupled};
use crate::sectors::Sector;
use crate::ties::{mode_rank, settle};
use laval_model::diagnostic::{Diagnostic, Diagnostics};
use laval_model::model::part::{Beyond, Frozen};
use laval_model::model::system::System;
use laval_model::text;
use laval_num::complex::C64;
use laval_num::univariate::root;
use serde::{Deserialize, Serialize};

/// Intervals of the frequencies at first, where known modes do not make up the count of the whole.
const PIECES: usize = 16;
/// Halvings of an interval whose count does not agree.
const DEPTH: usize = 10;
/// Steps of the secant method.
const MOST_STEPS: usize = 40;
/// Distance of the frequency of a mode from that of its coefficients, over the mode, that is rounding; and that a step may leave at most.
const ROUNDING: f64 = 4e-15;
const CLOSE: f64 = 1e-9;
/// Distance of two values of one mode, over the mode.
const SAME: f64 = 1e-7;
/// Share of a mode that is no oscillation.
const STILL: f64 = 1e-11;
/// Relative step over which the slope of a frequency is taken.
const BESIDE: f64 = 1e-5;
/// Highest frequency looked at, over that of the fastest mode.
const ABOVE: f64 = 1.05;

/// A mode with the coefficients of its own frequency.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OwnMode {
    /// The mode.
    pub mode: MachineMode,
    /// Distance of its frequency from that of the coefficients, over its size.
    pub residual: f64,
    /// How its frequency rises with that of the coefficients, `d|Im s|/d nu`.
    pub slope: f64,
}

/// The modes at one speed.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct OwnModes {
    /// By frequency.
    pub modes: Vec<OwnMode>,
    /// Frequencies searched, rad/s.
    pub range: (f64, f64),
    /// Intervals, rad/s, with the number of modes that the count has more than were found: net, of both directions.
    pub open: Vec<(f64, f64, i64)>,
    /// Modes of the machine frozen at the lowest frequency that lie below it, of a search that begins above 0.
    pub below: usize,
    /// Those of the machine frozen at the highest frequency that lie above it.
    pub above: usize,
    /// Spectra computed.
    pub spectra: u64,
    /// Not stopped early.
    pub complete: bool,
}

impl OwnModes {
    /// All fixed points that the count knows of were found.
    pub fn counted(&self) -> bool {
        self.complete && self.open.is_empty()
    }
}

/// The frequencies at which the parts of the machine are known, rad/s: those of the tables that refuse others; where none does, from 0 to above the fastest mode, or to
/// `limit`.
///
/// # Errors
/// Tables without a frequency in common; as the spectrum.
pub fn range(system: &System, about: &Equilibrium, limit: Option<f64>) -> Result<(f64, f64), Diagnostic> {
    let refusing = || system.over_frequency().filter(|(_, t)| t.beyond == Beyond::Refuse);
    let low = refusing().map(|(_, t)| t.from).fold(0.0, f64::max);
    let high = refusing().map(|(_, t)| t.to).fold(f64::INFINITY, f64::min);
    if high <= low {
        let names: Vec<String> = refusing().map(|(s, _)| format!("\"{}\"", s.name)).collect();
        return Err(Diagnostic::error(
            "modes.frequencies",
            text!("the tables of {names} have no frequencies in common", names = names.join(", ")),
        )
        .help(text!("write beyond = \"hold\" or beyond = \"linear\" where a table may be left, or add rows")));
    }
    let top = match (high.is_finite(), limit) {
        (_, Some(limit)) => limit,
        (true, None) => high,
        (false, None) => {
            let end = system.over_frequency().map(|(_, t)| t.to).fold(0.0, f64::max);
            let last = Held::new(system, about, end, f64::INFINITY, false)?;
            last.modes.iter().map(|m| ABOVE * m.frequency()).fold(end, f64::max)
        }
    };
    Ok((low, high.min(top)))
}

/// The machine frozen at one frequency.
struct Held {
    frequency: f64,
    modes: Vec<MachineMode>,
}

fn frozen(system: &System, frequency: f64) -> Result<System, Diagnostic> {
    let none =
        || Diagnostic::error("modes.frequencies", text!("no part of this machine is given in a table over the frequency of vibration"));
    system.frozen(Frozen::At(frequency)).ok_or_else(none)?.map_err(Diagnostics::into_error)
}

impl Held {
    /// Its modes are refined where that is wanted: a count and starts do without.
    fn new(system: &System, about: &Equilibrium, frequency: f64, limit: f64, refined: bool) -> Result<Self, Diagnostic> {
        let held = frozen(system, frequency)?;
        let modes = if in_region(&held) {
            let usual = if is_large(&held) { usual_frequency(&held, about) } else { 0.0 };
            let limit = if limit.is_finite() { Some(limit.max(usual)) } else { None };
            roots(&held, about, &Request { frequency: limit, ..Request::default() })?.spectrum.modes
        } else {
            modes_about(&held, about, refined)?.modes
        };
        Ok(Held { frequency, modes })
    }
    /// Modes below the line, a pair as two.
    fn weight(&self) -> i64 {
        self.modes.iter().filter(|m| below(m, self.frequency)).map(weight).sum()
    }
}

/// It does not oscillate.
fn still(m: &MachineMode) -> bool {
    m.frequency() <= STILL * m.value.abs()
}

fn below(m: &MachineMode, frequency: f64) -> bool {
    m.frequency() <= frequency * (1.0 + CLOSE) || still(m)
}

/// Roots that it stands for: of a machine without preferred direction every one of a sector has its mirror image in the other.
fn weight(m: &MachineMode) -> i64 {
    if still(m) && !matches!(m.sector, Some(Sector::Forward | Sector::Backward)) { 1 } else { 2 }
}

struct Search<'a> {
    system: &'a System,
    about: &'a Equilibrium,
    range: (f64, f64),
    found: Vec<OwnMode>,
    out: OwnModes,
    /// Receives the number of spectra computed; says whether to go on.
    each: &'a mut dyn FnMut(u64) -> bool,
}

/// All modes at the speed of a state with frequencies in a range (see [`range`]), each with the coefficients of its own frequency; those that do not oscillate where the range
/// begins at 0. `known` leads to some of them; `each` receives the spectra computed so far, and stops the search by saying false.
///
/// # Errors
/// As the spectrum of the frozen machine.
pub fn own_modes(
    system: &System,
    about: &Equilibrium,
    range: (f64, f64),
    known: &[MachineMode],
    each: &mut dyn FnMut(u64) -> bool,
) -> Result<OwnModes, Diagnostic> {
    let out = OwnModes { range, complete: true, ..OwnModes::default() };
    let mut search = Search { system, about, range, found: Vec::new(), out, each };
    let (Some(first), Some(last)) = (search.held(range.0)?, search.held(range.1)?) else { return Ok(search.finished()) };
    search.out.above = last.modes.iter().filter(|m| !below(m, range.1)).count();
    search.out.below = if range.0 > 0.0 { first.modes.iter().filter(|m| below(m, range.0)).count() } else { 0 };
    if range.0 == 0.0 {
        let aperiodic = first.modes.iter().filter(|m| still(m));
        search.found.extend(aperiodic.map(|m| OwnMode { mode: m.clone(), residual: 0.0, slope: 0.0 }));
    }
    for m in known {
        search.lead(m, m.frequency());
    }
    search.candidates(&first, &last);
    if search.missing(&first, &last) != 0 {
        let mut before = first;
        for k in 1..=PIECES {
            let frequency = range.0 + (range.1 - range.0) * k as f64 / PIECES as f64;
            let next =
                if k == PIECES { Some(Held { frequency: last.frequency, modes: last.modes.clone() }) } else { search.held(frequency)? };
            let Some(next) = next else { return Ok(search.finished()) };
            if !search.between(&before, &next, 0)? {
                return Ok(search.finished());
            }
            before = next;
        }
    }
    Ok(search.finished())
}

impl Search<'_> {
    fn held(&mut self, frequency: f64) -> Result<Option<Held>, Diagnostic> {
        if !(self.each)(self.out.spectra) {
            self.out.complete = false;
            return Ok(None);
        }
        self.out.spectra += 1;
        // those that do not oscillate are modes as they are
        Held::new(self.system, self.about, frequency, 2.0 * self.range.1, frequency == 0.0).map(Some)
    }

    /// What the count of an interval has more than was found.
    fn missing(&self, a: &Held, b: &Held) -> i64 {
        let inside = |m: &&OwnMode| !below(&m.mode, a.frequency) && below(&m.mode, b.frequency);
        let found: i64 = self.found.iter().filter(inside).map(|m| if m.slope < 1.0 { 2 } else { -2 }).sum();
        b.weight() - a.weight() - found
    }

    /// Whether it was not stopped.
    fn between(&mut self, a: &Held, b: &Held, depth: usize) -> Result<bool, Diagnostic> {
        self.candidates(a, b);
        if self.missing(a, b) == 0 {
            return Ok(true);
        }
        // two roots that are nearly one at one end are apart at the other
        for m in &a.modes {
            self.bracket(m, a.frequency, b.frequency);
        }
        for m in &b.modes {
            self.bracket(m, b.frequency, a.frequency);
        }
        let missing = self.missing(a, b);
        if missing == 0 {
            return Ok(true);
        }
        if depth == DEPTH {
            self.out.open.push((a.frequency, b.frequency, missing / 2));
            return Ok(true);
        }
        let Some(middle) = self.held(0.5 * (a.frequency + b.frequency))? else { return Ok(false) };
        Ok(self.between(a, &middle, depth + 1)? && self.between(&middle, b, depth + 1)?)
    }

    /// Leads on the modes at both ends that are near the line.
    fn candidates(&mut self, a: &Held, b: &Held) {
        let width = b.frequency - a.frequency;
        for m in a.modes.iter().chain(&b.modes) {
            if m.frequency() >= a.frequency - width && m.frequency() <= b.frequency + width && !still(m) {
                self.lead(m, m.frequency().clamp(a.frequency, b.frequency));
            }
        }
    }

    /// Enters the fixed point between two frequencies at which a mode, followed from one to the other, is on different sides of the line: also where its frequency
    /// rises steeply, as beside the place where two aperiodic roots become a pair.
    fn bracket(&mut self, m: &MachineMode, a: f64, b: f64) {
        let (system, about) = (self.system, self.about);
        let Some(there) = polished(system, about, b, m.value, m.sector).map(|p| p.0.value) else { return };
        let (from, to) = (m.value.im.abs() - a, there.im.abs() - b);
        if !(from * to < 0.0) {
            return;
        }
        let between = |nu: f64| m.value + (there - m.value).scale((nu - a) / (b - a));
        let value = |nu: f64| polished(system, about, nu, between(nu), m.sector).map(|p| p.0.value);
        let gap = |nu: f64| value(nu).map(|s| s.im.abs() - nu);
        let Some(nu) = root(gap, (a, from), (b, to), ROUNDING * b) else { return };
        if let Some(value) = value(nu) {
            self.lead(&MachineMode { value, ..m.clone() }, nu);
        }
    }

    /// Enters the fixed point that a mode leads to, if it is a new one in the range.
    fn lead(&mut self, start: &MachineMode, frequency: f64) {
        let (system, about, (low, high)) = (self.system, self.about, self.range);
        let Some(own) = solve(system, about, start, frequency) else { return };
        let (value, nu) = (own.mode.value, own.mode.frequency());
        let inside = nu >= low * (1.0 - CLOSE) && nu <= high * (1.0 + CLOSE) && !still(&own.mode);
        let same = |o: &OwnMode| o.mode.sector == own.mode.sector && (o.mode.value - value).abs() <= SAME * value.abs();
        if inside && !self.found.iter().any(same) {
            self.found.push(own);
        }
    }

    fn finished(mut self) -> OwnModes {
        settle(&mut self.found, |m| m.mode.value, |m| mode_rank(&m.mode));
        OwnModes { modes: self.found, ..self.out }
    }
}

/// A root of the machine frozen at a frequency that a start leads to, and the machine's unknowns.
fn polished(
    system: &System,
    about: &Equilibrium,
    frequency: f64,
    start: C64,
    sector: Option<Sector>,
) -> Option<(Polished, Option<Sector>, Unknowns)> {
    let held = frozen(system, frequency).ok()?;
    let mut t = Characteristic::new(&held, about);
    // coefficients may be alike in both directions at some frequencies only
    let sector = sector.filter(|_| uncoupled(&mut t, about.speed));
    let p = t.polish(start, sector)?;
    Some((p, sector, Unknowns::of(&held)))
}

/// The mode with the coefficients of its own frequency that a mode leads to, from coefficients at a frequency: the secant method, which begins with the slope there.
pub fn solve(system: &System, about: &Equilibrium, start: &MachineMode, frequency: f64) -> Option<OwnMode> {
    let (mut nu, mut value, mut before) = (frequency, start.value, None::<(f64, f64)>);
    let slope_at = |nu: f64, value: C64| {
        let beside = nu * (1.0 + BESIDE);
        let there = polished(system, about, beside, value, start.sector)?.0.value;
        Some((there.im.abs() - value.im.abs()) / (beside - nu))
    };
    for _ in 0..MOST_STEPS {
        let (p, sector, unknowns) = polished(system, about, nu, value, start.sector)?;
        value = p.value;
        let gap = value.im.abs() - nu;
        let small = gap.abs() <= ROUNDING * value.abs();
        let slope = match before.filter(|b| b.0 != nu) {
            Some((x, g)) => (gap - g) / (nu - x),
            None if small || nu == 0.0 => -1.0,
            None => slope_at(nu, value)? - 1.0,
        };
        let step = -gap / slope;
        if small || step.abs() <= ROUNDING * nu || !step.is_finite() {
            if !(gap.abs() <= CLOSE * value.abs()) {
                return None;
            }
            // a fixed point is passed from above where the frequency rises by less than that of the coefficients
            let slope = if nu == 0.0 { 0.0 } else { slope_at(nu, value)? };
            return Some(OwnMode { mode: mode(&unknowns, &p, sector), residual: gap.abs() / value.abs(), slope });
        }
        before = Some((nu, gap));
        nu = (nu + step).max(0.0);
    }
    None
}
