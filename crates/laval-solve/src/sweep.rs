//! Spectra along the spin speed, followed by modal assurance.

use super::characteristic::{Characteristic, Equilibrium};
use super::locate::State;
use super::pencil::{Family, MachineMode, Spectrum, modes_about, wants_polish};
use super::roots::{Request, mode_near, roots, transcendental};
use super::sectors::Sector;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::eig::Track;
use laval_num::work::piece;
use serde::{Deserialize, Serialize};

/// A mode followed along the speed.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Branch {
    /// Speed and mode, in order of speed.
    pub points: Vec<(f64, MachineMode)>,
}

/// A pair of modes whose values passed each other between two speeds while their shapes did not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passing {
    /// Speeds before and after.
    pub between: (f64, f64),
    /// Estimate of the speed where the frequencies agree.
    pub at: f64,
}

/// All modes along the speed.
#[derive(Clone, Debug, Default)]
pub struct Sweep {
    /// Speeds computed, with their spectra.
    pub points: Vec<(f64, Spectrum)>,
    /// Branches.
    pub branches: Vec<Branch>,
    /// Smallest assurance with which a step was accepted.
    pub worst_assurance: f64,
    /// Steps accepted although shapes had mixed.
    pub ambiguous: Vec<(f64, f64)>,
    /// Passings.
    pub passings: Vec<Passing>,
    /// Spectra computed.
    pub solved: u64,
    /// The mode that grows most at every speed computed, with what its growth may be off by: also where its frequency is not followed.
    pub strongest: Vec<Strongest>,
}

/// The mode that grows most at a speed.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Strongest {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Eigenvalue.
    pub value: C64,
    /// It grows by more than its error.
    pub grows: bool,
}

impl Strongest {
    /// Of a spectrum.
    pub fn of(speed: f64, spectrum: &Spectrum) -> Option<Self> {
        let m = spectrum.least_stable()?;
        let largest = spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
        let error = if m.error.is_nan() { 0.0 } else { m.error };
        // of a machine without damping pairs of modes that meet lose half the digits
        let grows = !(m.value.re <= GROWS * m.value.abs() + error + ROUNDING * largest);
        Some(Strongest { speed, value: m.value, grows })
    }
}

/// Spectrum at a speed.
///
/// # Errors
/// As [`modes_about`].
pub fn spectrum(system: &System, state: State, speed: f64) -> Result<(Equilibrium, Spectrum), Diagnostic> {
    let about = state(speed)?;
    let modes = modes_about(system, &about, wants_polish(system))?;
    Ok((about, modes))
}

/// Growth or decay over the speed from which on the roots of a machine with parts without time form are counted at every speed; those nearer to the imaginary axis are
/// followed.
const COUNTED: f64 = 0.01;

/// Of a root that is followed: share of the step over which its tangent is taken; how far the tangent may lead, relative to the root; how far from the tangent
/// the root may end, relative to the tangent and to the root.
const TANGENT: f64 = 1e-3;
const FAR: f64 = 0.2;
const BEND: f64 = 0.3;
const STILL: f64 = 1e-4;

/// Steps between two speeds: more where two roots seem to lead to one.
const PIECES: [usize; 4] = [1, 4, 16, 64];

/// Growth over the eigenvalue, and over the largest of all, that is rounding.
const GROWS: f64 = 1e-7;
const ROUNDING: f64 = 1e-13;

/// Deepest halving of a step where shapes mix.
const DEPTH: usize = 7;

struct Follower<'a> {
    system: &'a System,
    state: State<'a>,
    /// Largest frequency followed, rad/s.
    limit: f64,
    /// Receives the speed of the grid and of the spectra computed so far; says whether to go on.
    each: &'a mut dyn FnMut(usize, u64) -> bool,
    /// Speed of the grid under way.
    place: usize,
    tracks: Vec<Track>,
    /// Branch of each mode of each family, in the order of its track.
    ids: Vec<Vec<usize>>,
    out: Sweep,
}

impl Follower<'_> {
    fn record(&mut self, speed: f64, spectrum: Spectrum, order: &[Vec<usize>]) {
        for (family, order) in order.iter().enumerate() {
            for (&branch, &mode) in self.ids[family].iter().zip(order) {
                if let Some(m) = spectrum.modes.iter().find(|m| m.place == (family, mode)) {
                    self.out.branches[branch].points.push((speed, m.clone()));
                }
            }
        }
        self.out.points.push((speed, spectrum));
    }

    fn start(&mut self, speed: f64, spectrum: Spectrum) {
        self.tracks = spectrum.families.iter().map(|f| Track::new(&f.modes)).collect();
        self.ids = Vec::new();
        let mut order = Vec::new();
        for f in &spectrum.families {
            let first = self.out.branches.len();
            self.out.branches.resize_with(first + f.modes.len(), Branch::default);
            self.ids.push((first..first + f.modes.len()).collect());
            order.push((0..f.modes.len()).collect());
        }
        self.record(speed, spectrum, &order);
    }

    fn advance(&mut self, from: f64, to: f64, spectrum: Spectrum, depth: usize) -> Result<(), Diagnostic> {
        if spectrum.families.len() != self.tracks.len()
            || spectrum.families.iter().zip(&self.out.points[self.out.points.len() - 1].1.families).any(|(a, b)| a.sector != b.sector)
        {
            // the machine changed its symmetry on the way: nothing to compare
            self.start(to, spectrum);
            return Ok(());
        }
        let moved = |(track, family): (&Track, &Family)| {
            let mut track = track.clone();
            let found = track.force(&family.modes);
            (track, found)
        };
        let trial: Vec<_> = self.tracks.iter().zip(&spectrum.families).map(moved).collect();
        let ambiguous = trial.iter().any(|t| t.1.ambiguous);
        let middle = 0.5 * (from + to);
        if ambiguous && depth < DEPTH && from < middle && middle < to && (self.each)(self.place, self.out.solved) {
            let mut between = self::spectrum(self.system, self.state, middle)?.1;
            self.out.strongest.extend(Strongest::of(middle, &between));
            band(&mut between, self.limit);
            self.out.solved += 1;
            self.advance(from, middle, between, depth + 1)?;
            return self.advance(middle, to, spectrum, depth + 1);
        }
        if ambiguous {
            self.out.ambiguous.push((from, to));
        }
        let before = self.out.points[self.out.points.len() - 1].1.clone();
        let mut order = Vec::new();
        for (k, ((track, m), f)) in trial.into_iter().zip(&spectrum.families).enumerate() {
            if m.worst_mac < self.out.worst_assurance || m.worst_mac.is_nan() {
                self.out.worst_assurance = m.worst_mac;
            }
            self.tracks[k] = track;
            let kept: Vec<(usize, usize)> = self.ids[k].iter().zip(&m.permutation).filter_map(|(&id, p)| p.map(|p| (id, p))).collect();
            let value = |id: usize| -> Option<C64> {
                let (w, mode) = self.out.branches[id].points.last()?;
                (*w == from).then(|| before.families[k].modes[mode.place.1].value)
            };
            for (i, &(a, pa)) in kept.iter().enumerate() {
                for &(b, pb) in &kept[i + 1..] {
                    let (Some(a0), Some(b0)) = (value(a), value(b)) else { continue };
                    let (d0, d1) = (a0.im - b0.im, f.modes[pa].value.im - f.modes[pb].value.im);
                    if d0 * d1 < 0.0 {
                        self.out.passings.push(Passing { between: (from, to), at: from + (to - from) * d0 / (d0 - d1) });
                    }
                }
            }
            let mut ids: Vec<usize> = kept.iter().map(|p| p.0).collect();
            let mut modes: Vec<usize> = kept.iter().map(|p| p.1).collect();
            for &born in &m.born {
                ids.push(self.out.branches.len());
                modes.push(born);
                self.out.branches.push(Branch::default());
            }
            self.ids[k] = ids;
            order.push(modes);
        }
        self.record(to, spectrum, &order);
        Ok(())
    }
}

/// Leaves only modes whose frequency is at most `limit` in size.
fn band(spectrum: &mut Spectrum, limit: f64) {
    if limit.is_infinite() {
        return;
    }
    let mut places: Vec<Vec<Option<usize>>> = Vec::new();
    for f in &mut spectrum.families {
        let mut next = 0;
        places.push(
            f.modes
                .iter()
                .map(|m| {
                    let inside = m.value.im.abs() <= limit;
                    next += usize::from(inside);
                    inside.then(|| next - 1)
                })
                .collect(),
        );
        f.modes.retain(|m| m.value.im.abs() <= limit);
    }
    spectrum.modes.retain_mut(|m| match places[m.place.0][m.place.1] {
        Some(place) => {
            m.place.1 = place;
            true
        }
        None => false,
    });
}

/// Follows all modes with frequencies up to `limit` (rad/s) over the speeds (ascending): what lies above it is not compared, and cannot be confused. Before every spectrum `each` receives the number of the speed and of the spectra computed so
/// far, and stops the work by saying false.
///
/// # Errors
/// As [`modes_about`] at any speed.
pub fn sweep(
    system: &System,
    state: State,
    speeds: &[f64],
    limit: f64,
    mut each: impl FnMut(usize, u64) -> bool,
) -> Result<Sweep, Diagnostic> {
    if transcendental(system) {
        return follow(system, state, speeds, limit, each);
    }
    let out = Sweep { worst_assurance: 1.0, ..Sweep::default() };
    let mut f = Follower { system, state, limit, each: &mut each, place: 0, tracks: vec![], ids: vec![], out };
    for (k, &speed) in speeds.iter().enumerate() {
        f.place = k;
        if !(f.each)(k, f.out.solved) {
            break;
        }
        let mut s = spectrum(system, state, speed)?.1;
        f.out.strongest.extend(Strongest::of(speed, &s));
        band(&mut s, limit);
        f.out.solved += 1;
        if k == 0 {
            f.start(speed, s);
        } else {
            f.advance(speeds[k - 1], speed, s, 0)?;
        }
    }
    Ok(f.out)
}

/// The same for a machine with parts that have no time form: a root goes on where its tangent and Newton's method lead. Roots that enter the region are born.
fn follow(
    system: &System,
    state: State,
    speeds: &[f64],
    limit: f64,
    mut each: impl FnMut(usize, u64) -> bool,
) -> Result<Sweep, Diagnostic> {
    let mut out = Sweep { worst_assurance: 1.0, ..Sweep::default() };
    // branch of each mode of the speed before
    let mut ids: Vec<usize> = Vec::new();
    for (k, &speed) in speeds.iter().enumerate() {
        if !each(k, out.solved) {
            break;
        }
        let about = state(speed)?;
        let before: Vec<(usize, MachineMode)> = match out.points.last() {
            Some((_, s)) => ids.iter().copied().zip(s.modes.iter().cloned()).collect(),
            None => Vec::new(),
        };
        let mut led: Vec<(usize, C64, Option<Sector>)> = Vec::new();
        for pieces in PIECES {
            let again = |id: usize, m: &MachineMode| {
                let to = led.iter().filter(|l| l.0 == id && l.2 == m.sector).map(|l| l.1).next();
                to.is_some_and(|to| led.iter().any(|l| l.0 != id && l.2 == m.sector && same(l.1, to)))
            };
            let those: Vec<&(usize, MachineMode)> = before.iter().filter(|(id, m)| pieces == 1 || again(*id, m)).collect();
            if those.is_empty() {
                break;
            }
            led.retain(|l| those.iter().all(|t| t.0 != l.0));
            for (id, mode) in those {
                let Some(to) = piece(|| lead_in_pieces(system, state, (speeds[k - 1], speed), mode, pieces)) else { return Ok(met(out)) };
                let to = to?;
                led.extend(to.map(|value| (*id, value, mode.sector)));
            }
        }
        let forward = |z: C64, sector: Option<Sector>| if sector == Some(Sector::Backward) { z.conj() } else { z };
        let starts: Vec<C64> = led.iter().map(|l| forward(l.1, l.2)).collect();
        let frequency = limit.is_finite().then_some(limit);
        let dense = system.domains(speed).iter().any(|d| !d.axis);
        let request = Request { margin: if dense { COUNTED * speed.abs() } else { 0.0 }, frequency, starts: &starts, ..Request::default() };
        let Some(found) = piece(|| roots(system, &about, &request)) else { return Ok(met(out)) };
        let found = found?.spectrum;
        out.strongest.extend(Strongest::of(speed, &found));
        out.solved += 1;
        ids = found.modes.iter().map(|_| usize::MAX).collect();
        for (id, value, sector) in led {
            if let Some(at) = found.modes.iter().position(|m| m.sector == sector && same(m.value, value))
                && ids[at] == usize::MAX
            {
                ids[at] = id;
            }
        }
        for (id, mode) in ids.iter_mut().zip(&found.modes) {
            if *id == usize::MAX {
                *id = out.branches.len();
                out.branches.push(Branch::default());
            }
            out.branches[*id].points.push((speed, mode.clone()));
        }
        out.points.push((speed, found));
    }
    for born in 0..out.branches.len() {
        match piece(|| back(system, state, limit, born, &mut out)) {
            Some(done) => done?,
            None => break,
        }
    }
    Ok(met(out))
}

/// Without the branches that turned out to be the end of others.
fn met(mut out: Sweep) -> Sweep {
    out.branches.retain(|b| !b.points.is_empty());
    out
}

/// Two values are those of one root.
fn same(a: C64, b: C64) -> bool {
    (a - b).abs() <= 1e-8 * b.abs()
}

/// A branch that was met at some speed, followed back to where it comes from. Where that is the end of another the two are one.
fn back(system: &System, state: State, limit: f64, born: usize, out: &mut Sweep) -> Result<(), Diagnostic> {
    while let Some((speed, mode)) = out.branches[born].points.first().cloned()
        && let Some(k) = out.points.iter().position(|p| p.0 == speed)
        && k > 0
    {
        let before = out.points[k - 1].0;
        for pieces in PIECES {
            let Some(value) = lead_in_pieces(system, state, (speed, before), &mode, pieces)? else { return Ok(()) };
            let own = |m: &MachineMode| m.sector == mode.sector && same(m.value, value);
            if !out.points[k - 1].1.modes.iter().any(own) {
                let there = mode_near(system, &state(before)?, value, mode.sector);
                let Some(there) = there.filter(|m| own(m) && m.value.im.abs() <= limit) else { return Ok(()) };
                out.points[k - 1].1.modes.push(there.clone());
                out.branches[born].points.insert(0, (before, there));
                break;
            }
            let ends = |b: &Branch| b.points.last().is_some_and(|(w, m)| *w == before && own(m));
            if let Some(other) = out.branches.iter().position(ends) {
                let rest = std::mem::take(&mut out.branches[born].points);
                out.branches[other].points.extend(rest);
                return Ok(());
            }
            // it is on another branch: perhaps one that runs beside this
            if Some(&pieces) == PIECES.last() {
                return Ok(());
            }
        }
    }
    Ok(())
}

/// [`lead`] in so many equal steps.
fn lead_in_pieces(
    system: &System,
    state: State,
    (from, to): (f64, f64),
    mode: &MachineMode,
    pieces: usize,
) -> Result<Option<C64>, Diagnostic> {
    let mut value = mode.value;
    for k in 0..pieces {
        let at = |k: usize| from + (to - from) * k as f64 / pieces as f64;
        match lead(system, state, (at(k), at(k + 1)), value, mode.sector, DEPTH)? {
            Some(next) => value = next,
            None => return Ok(None),
        }
    }
    Ok(Some(value))
}

/// Where a root goes from one speed to the next: where Newton's method leads from its tangent, if that is near; else by way of the speed between, and nowhere
/// when it is not near at the shortest step: what is found there is another root.
fn lead(
    system: &System,
    state: State,
    (from, to): (f64, f64),
    value: C64,
    sector: Option<Sector>,
    depth: usize,
) -> Result<Option<C64>, Diagnostic> {
    let at = |speed: f64, start: C64| -> Result<Option<C64>, Diagnostic> {
        let about = state(speed)?;
        Ok(Characteristic::new(system, &about).polish(start, sector).map(|p| p.value))
    };
    let beside = from + TANGENT * (to - from);
    // a wave that hardly moves the machine has a frequency that is proportional to the speed, and leads Newton's method from nowhere else
    let starts = [Some(value), (from != 0.0).then(|| value.scale(beside / from))];
    for start in starts.into_iter().flatten() {
        let Some(near) = at(beside, start)? else { continue };
        let ahead = (near - value).scale(1.0 / TANGENT);
        if ahead.abs() <= FAR * value.abs()
            && let Some(there) = at(to, value + ahead)?
            && (there - value - ahead).abs() <= BEND * ahead.abs() + STILL * value.abs()
        {
            return Ok(Some(there));
        }
    }
    if depth == 0 {
        return Ok(None);
    }
    let middle = 0.5 * (from + to);
    match lead(system, state, (from, middle), value, sector, depth - 1)? {
        Some(between) => lead(system, state, (middle, to), between, sector, depth - 1),
        None => Ok(None),
    }
}
