//! Spectra along the spin speed, followed by modal assurance.

use super::characteristic::Equilibrium;
use super::follow::{follow, follow_large};
use super::locate::State;
use super::pencil::{Family, MachineMode, Spectrum, modes_about, wants_polish};
use super::roots::{in_region, transcendental};
use super::spectra_ahead::Ahead;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::eig::Track;
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
    /// Family of both.
    pub family: usize,
    /// Both values before, and after.
    pub values: [[C64; 2]; 2],
    /// The larger assurance of one of both before with the other one after.
    pub mixed: f64,
}

/// Two modes that interact lie at the mean of their values plus and minus the root of the squared half distance and the coupling; where shapes did not mix the coupling is the
/// smaller of the two. So their growth rises by half their distance at most; this is four times as much.
const RAISED: f64 = 2.0;

/// Assurance of two modes of different shape from which on they are coupled at all: a coupling of a ten-millionth of the frequency leaves far more over a step, and rounding far less.
const COUPLED: f64 = 1e-18;

impl Passing {
    /// The modes are coupled, so that they can interact where their values come near each other.
    pub fn coupled(&self) -> bool {
        !(self.mixed < COUPLED)
    }

    /// The largest growth that both can have between the speeds, shapes at both being unmixed.
    pub fn highest(&self) -> f64 {
        self.values.iter().map(|[a, b]| a.re.max(b.re) + RAISED * (*a - *b).abs()).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The same by the spectrum at the speed where the frequencies agree; none where its values are not those expected: then the modes interact there, or the speed
    /// is not near enough.
    pub fn highest_at(&self, spectrum: &Spectrum) -> Option<f64> {
        let modes = &spectrum.families.get(self.family)?.modes;
        let share = (self.at - self.between.0) / (self.between.1 - self.between.0);
        let [before, after] = self.values;
        let expected = [0, 1].map(|k| before[k] + (after[k] - before[k]).scale(share));
        let nearest = |to: C64, but: Option<usize>| {
            let others = (0..modes.len()).filter(|k| Some(*k) != but);
            others.min_by(|a, b| (modes[*a].value - to).abs().total_cmp(&(modes[*b].value - to).abs()))
        };
        let a = nearest(expected[0], None)?;
        let found = [modes[a].value, modes[nearest(expected[1], Some(a))?].value];
        let reach = RAISED * (found[0] - found[1]).abs();
        let as_expected = found.iter().zip(&expected).all(|(f, e)| (*f - *e).abs() <= reach);
        as_expected.then_some(found[0].re.max(found[1].re) + reach)
    }
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
    /// Of a large machine the speeds at which its roots were counted.
    pub counts: Vec<Count>,
    /// The mode that grows most at every speed computed, with what its growth may be off by: also where its frequency is not followed.
    pub strongest: Vec<Strongest>,
}

/// A count of the roots of a large machine at a speed.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Count {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Frequency up to which roots were counted, rad/s.
    pub frequency: f64,
    /// None is missing.
    pub complete: bool,
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
                    self.out.branches[branch].points.push((speed, m.without_vectors()));
                }
            }
        }
        // vectors of the speeds before stand in the tracks, as far as they are needed
        if let Some((_, before)) = self.out.points.last_mut() {
            before.keep_values();
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
        let values = |f: &Family| f.modes.iter().map(|m| m.value).collect::<Vec<C64>>();
        let before: Vec<Vec<C64>> = self.out.points[self.out.points.len() - 1].1.families.iter().map(values).collect();
        let mut order = Vec::new();
        for (k, ((track, m), f)) in trial.into_iter().zip(&spectrum.families).enumerate() {
            if m.worst_mac < self.out.worst_assurance || m.worst_mac.is_nan() {
                self.out.worst_assurance = m.worst_mac;
            }
            self.tracks[k] = track;
            let places = self.ids[k].iter().zip(&m.permutation).enumerate();
            let followed: Vec<(usize, usize, usize)> = places.filter_map(|(i, (&id, p))| p.map(|p| (i, id, p))).collect();
            let value = |id: usize| -> Option<C64> {
                let (w, mode) = self.out.branches[id].points.last()?;
                (*w == from).then(|| before[k][mode.place.1])
            };
            for (i, &(ia, a, pa)) in followed.iter().enumerate() {
                for &(ib, b, pb) in &followed[i + 1..] {
                    let (Some(a0), Some(b0)) = (value(a), value(b)) else { continue };
                    let [a1, b1] = [pa, pb].map(|p| f.modes[p].value);
                    let (d0, d1) = (a0.im - b0.im, a1.im - b1.im);
                    if d0 * d1 < 0.0 {
                        let at = from + (to - from) * d0 / (d0 - d1);
                        let mixed = m.assurance[(ia, pb)].max(m.assurance[(ib, pa)]);
                        self.out.passings.push(Passing { between: (from, to), at, family: k, values: [[a0, b0], [a1, b1]], mixed });
                    }
                }
            }
            let mut ids: Vec<usize> = followed.iter().map(|p| p.1).collect();
            let mut modes: Vec<usize> = followed.iter().map(|p| p.2).collect();
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

/// Modes over speeds whose spectra are known, and where steps are halved over those between them.
///
/// # Errors
/// As [`modes_about`].
pub(super) fn follow_known(system: &System, state: State, points: Vec<(f64, Spectrum)>) -> Result<Sweep, Diagnostic> {
    let out = Sweep { worst_assurance: 1.0, ..Sweep::default() };
    let mut each = |_, _| true;
    let mut f = Follower { system, state, limit: f64::INFINITY, each: &mut each, place: 0, tracks: vec![], ids: vec![], out };
    let mut before = None;
    for (speed, spectrum) in points {
        match before.replace(speed) {
            None => f.start(speed, spectrum),
            Some(from) => f.advance(from, speed, spectrum, 0)?,
        }
    }
    Ok(f.out)
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
    if in_region(system) {
        return follow_large(system, state, speeds, limit, each);
    }
    let out = Sweep { worst_assurance: 1.0, ..Sweep::default() };
    let mut f = Follower { system, state, limit, each: &mut each, place: 0, tracks: vec![], ids: vec![], out };
    let mut ahead = Ahead::new(system, state, speeds);
    for (k, &speed) in speeds.iter().enumerate() {
        f.place = k;
        if !(f.each)(k, f.out.solved) {
            break;
        }
        let Some(found) = ahead.next() else { break };
        let mut s = found?;
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
