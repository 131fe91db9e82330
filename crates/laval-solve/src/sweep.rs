//! Spectra along the spin speed, followed by modal assurance.

use super::characteristic::Equilibrium;
use super::follow::{follow, follow_large};
use super::locate::State;
use super::pencil::{Family, MachineMode, Spectrum, modes_about, wants_polish};
use super::roots::{in_region, transcendental};
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
    if in_region(system) {
        return follow_large(system, state, speeds, limit, each);
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
