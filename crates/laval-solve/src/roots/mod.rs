//! Roots of a machine with parts that have no time form: those of its characteristic function in a region, with the number that the argument principle counts.
//!
//! ```text
//! det T(s) = 0;   1/(2 pi i) closed integral of d ln(R det T) = number of roots inside,   R as in [`regular`](crate::model::capability::FrequencyDomain::regular)
//! ```
//!
//! The parts say where T is analytic ([`Domain`]). The region is made of rectangles inside that domain: of an ideal liquid with all its axial waves both
//! half planes but for a strip along the imaginary axis, of some of them all but the piece of that strip where they accumulate, of a viscous one the
//! right half plane. In every rectangle the roots known from nearby starts are divided out, those the count says are missing are looked for, and the
//! count is taken again. Roots outside the rectangles that starts lead to are kept and said to be uncounted.
//!
//! Theory: `docs/theory/linear-vibration.md#counting-of-roots`.

mod beyond;
mod region;
mod repeated;

pub use region::{ACCUMULATION, PAIR};
use region::{Piece, rectangles, step_limit};
use repeated::repeated;

use crate::characteristic::{Characteristic, Equilibrium, Frame, Polished, is_polynomial};
use crate::diagnostic::Diagnostic;
use crate::free_motions::free_motions;
use crate::large::{Starts, is_large, starts};
use crate::machine_mode::{MachineMode, Unknowns, Whirl};
use crate::model::part::{Domain, Physics, TimeForm};
use crate::model::system::System;
use crate::pencil::{Family, ISOTROPIC, Linearised, Spectrum, time_forms};
use crate::resonances::resonances;
use crate::sectors::Sector;
use crate::side_by_side::{Block, Determinants, Near, polish_all};
use crate::spectra_ahead::together;
use crate::ties::{mode_rank, settle};
use laval_model::text;
use laval_num::complex::{C64, c};
use laval_num::contour::{Found, Function, Region, Sample, missing, zeros};
use laval_num::eig;
use laval_num::factor::{Directed, Factors, LogDet, Selection};
use laval_num::lanes::LANES;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Least margin beside a dense range and where singularities accumulate, over the speed, and least resolution of waves that die out slowly.
pub const LEAST: f64 = Domain::MARGIN;
/// Starts spread over the frequencies.
const SPREAD: i32 = 16;
/// Most evaluations of the characteristic matrix for one rectangle, and most terms of series in them.
const BUDGET: u64 = 400_000;
const TERMS: u64 = 8_000_000;

/// Terms of series from which on places are evaluated on all processors, pieces that a path then begins with, and places that one thread takes together.
const COSTLY: u64 = 64;
const PIECES: usize = 4;
const SHARE: usize = 2;

/// Relative distance of a zero of the rough function from the root it stands for.
pub const SAME: f64 = 1e-6;

/// The request.
#[derive(Clone, Copy, Debug, Default)]
pub struct Request<'a> {
    /// Growth that counts, 1/s: roots that grow faster are counted.
    pub margin: f64,
    /// Largest frequency, rad/s; one that holds all modes of the machine without these parts when left out.
    pub frequency: Option<f64>,
    /// Only roots that grow faster than the margin are wanted; others are kept when starts lead to them.
    pub growing: bool,
    /// Also roots beyond the frequency that grow faster than the margin, where T is a polynomial; with `growing`.
    pub everywhere: bool,
    /// Places near roots.
    pub starts: &'a [C64],
    /// This search has all processors: places of a costly function are evaluated on them side by side.
    pub alone: bool,
    /// Most evaluations for one rectangle, where they are fewer than a study may take.
    pub evaluations: Option<u64>,
    /// Ends the search: what is not counted by then is not proven.
    pub cancel: Option<&'a AtomicBool>,
}

/// A rectangle in which roots were counted.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Area {
    /// Range of the growth, 1/s.
    pub growth: (f64, f64),
    /// Range of the frequency, rad/s; of the forward sector with its sign.
    pub frequency: (f64, f64),
    /// Together with its mirror image.
    pub mirrored: bool,
    /// Roots found.
    pub found: usize,
    /// Roots the count says are missing; `None` where the phase could not be followed.
    pub missing: Option<i64>,
}

impl Area {
    /// All roots in it are known.
    pub fn complete(&self) -> bool {
        self.missing == Some(0)
    }
}

/// Roots with the evidence for them.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Roots {
    /// As modes.
    pub spectrum: Spectrum,
    /// Where they were counted.
    pub areas: Vec<Area>,
    /// For each mode whether it lies in a rectangle whose count agrees.
    pub counted: Vec<bool>,
    /// Evaluations of the characteristic matrix.
    pub evaluations: u64,
    /// Growth from which on roots are counted, 1/s.
    pub margin: f64,
    /// Largest frequency, rad/s.
    pub frequency: f64,
    /// Roots at zero beside those of free motions along and about the axis: motions that nothing holds.
    pub at_zero: Option<AtZero>,
}

/// Roots at zero, of which some lie in one place, so that they are counted together and not solved for one by one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AtZero {
    /// Their number.
    pub count: usize,
    /// Largest distance from zero, 1/s.
    pub within: f64,
}

impl Roots {
    /// The number of roots that grow faster than the margin, where it is proven. Of a pair of conjugates one counts.
    pub fn growing(&self) -> Option<usize> {
        let proven = self.areas.iter().filter(|a| a.growth.1 > self.margin.max(0.0)).all(Area::complete);
        proven.then(|| self.spectrum.modes.iter().filter(|m| m.value.re > self.margin).count())
    }
}

/// A part of the machine has no time form: its roots are those of a transcendental function, which can be counted where all parts say where they are analytic.
pub fn transcendental(system: &System) -> bool {
    system.slots().iter().any(|s| matches!(s.physics, Physics::Frequency(TimeForm::None(_))))
}

/// Modes are searched in a region and counted there: a part has no time form, or the machine has more modes than are computed.
pub fn in_region(system: &System) -> bool {
    transcendental(system) || has_more_modes(system)
}

/// The machine has finitely many modes, and more than are computed: those up to a frequency are.
pub fn has_more_modes(system: &System) -> bool {
    is_large(system) && is_polynomial(system)
}

/// The characteristic function over one sector or all unknowns.
struct Determinant<'a, 'b> {
    t: &'a mut Characteristic<'b>,
    sector: Option<Sector>,
    of: Arc<Selection>,
    factors: Factors<Directed>,
    /// Without the factor that takes the poles of waves away.
    bare: bool,
    /// Many places together, where T is a polynomial with many unknowns.
    together: Option<Determinants>,
    /// T takes so long that places are evaluated on all processors.
    costly: bool,
    cancel: Option<&'a AtomicBool>,
}

impl<'a, 'b> Determinant<'a, 'b> {
    fn new(
        t: &'a mut Characteristic<'b>,
        sector: Option<Sector>,
        (frequency, counts): (f64, bool),
        costly: bool,
        cancel: Option<&'a AtomicBool>,
    ) -> Self {
        let of = t.selection(&t.members(sector));
        let together = counts.then(|| Block::new(t, sector)).flatten().and_then(|block| Determinants::new(&block, frequency));
        Determinant { t, sector, of, factors: Factors::default(), bare: false, together, costly, cancel }
    }

    /// For places of some size.
    fn scale_for(&mut self, size: f64) {
        if self.together.is_some() {
            self.together = Block::new(self.t, self.sector).and_then(|block| Determinants::new(&block, size));
        }
    }

    fn single(&mut self, s: C64) -> Option<Sample> {
        let determinant = self.t.determinant(s, &self.of, &mut self.factors)?;
        self.regular(determinant, s)
    }

    /// With the poles of waves taken away.
    fn regular(&self, determinant: LogDet, s: C64) -> Option<Sample> {
        let mut sample = Sample { phase: determinant.phase, rate: determinant.rate };
        if !self.bare && self.sector != Some(Sector::Axial) {
            let (value, rate) = self.t.regular(s);
            sample.phase += value.arg();
            sample.rate += rate;
        }
        if !self.bare && self.sector.is_none() {
            let (value, rate) = self.t.regular(s.conj());
            sample.phase -= value.arg();
            sample.rate += rate.conj();
        }
        (sample.phase.is_finite() && sample.rate.is_finite()).then_some(sample)
    }
}

impl Function for &mut Determinant<'_, '_> {
    fn together(&self) -> usize {
        match (&self.together, self.costly) {
            (Some(_), _) => LANES,
            (None, true) => PIECES,
            (None, false) => 1,
        }
    }
    fn at(&mut self, places: &[C64], out: &mut Vec<Option<Sample>>) {
        if self.costly && places.len() > 1 {
            let this = &*self;
            let share = |some: &&[C64]| {
                let (mut t, mut factors) = (this.t.clone(), Factors::default());
                let stopped = || this.cancel.is_some_and(|c| c.load(Ordering::Relaxed));
                let one = |&s: &C64| {
                    let determinant = if stopped() { None } else { t.determinant(s, &this.of, &mut factors) };
                    determinant.and_then(|d| this.regular(d, s))
                };
                some.iter().map(one).collect::<Vec<_>>()
            };
            return out.extend(together(&places.chunks(SHARE).collect::<Vec<_>>(), share).concat());
        }
        for some in places.chunks(self.together()) {
            if self.cancel.is_some_and(|c| c.load(Ordering::Relaxed)) {
                out.extend(some.iter().map(|_| None));
                continue;
            }
            let side_by_side = self.together.as_mut().map(|d| d.at(some));
            for (k, &s) in some.iter().enumerate() {
                let known = side_by_side.as_ref().and_then(|all| all[k]);
                out.push(known.or_else(|| self.single(s)));
            }
        }
    }
}

/// Roots of the machine in a region.
///
/// # Errors
/// A state that turns with the rotor, of a machine with parts given in the frequency domain: their domain is known in fixed axes.
pub fn roots(system: &System, about: &Equilibrium, request: &Request) -> Result<Roots, Diagnostic> {
    if about.frame == Frame::Turning && !is_polynomial(system) {
        return Err(Diagnostic::error("modes.frequency_only", text!("a part without time form is linearised about rest only"))
            .help(text!("leave about out")));
    }
    if let Some(silent) = system.undeclared() {
        time_forms(system)?;
        return Err(Diagnostic::error(
            "modes.domain",
            text!("\"{name}\" does not say where its dynamic stiffness is analytic", name = silent.name),
        )
        .at(silent.span.clone())
        .help(text!("without that no roots can be counted; forced_response works with it")));
    }
    let speed = about.speed;
    let domains = system.domains(speed);
    let unknowns = Unknowns::of(system);
    let mut t = Characteristic::new(system, about);
    let rough = system.rough();
    let mut counting = Characteristic::new(rough.as_ref().unwrap_or(system), about);
    let terms = domains.iter().map(|d| d.terms as u64).sum::<u64>().max(1);
    let budget = BUDGET.min(TERMS / terms).min(request.evaluations.unwrap_or(u64::MAX));
    let costly = request.alone && terms >= COSTLY;
    let sectors: &[Option<Sector>] = if uncoupled(&mut t, speed) { &[Some(Sector::Forward), Some(Sector::Axial)] } else { &[None] };
    // roots that are known lead on, and what is missing shows in the count
    let large = is_large(system).then(|| match request.frequency {
        Some(frequency) if !request.starts.is_empty() => Starts { frequency, values: Vec::new() },
        frequency => starts(&t, sectors, frequency),
    });
    let own: Vec<(Option<Sector>, C64)> = match &large {
        Some(near) => near.values.clone(),
        None => {
            let rest = Linearised::of_time_forms(system, about).spectrum().ok();
            let families = rest.into_iter().flat_map(|s| s.families);
            families.flat_map(|f| f.modes.into_iter().map(move |m| (f.sector, m.value))).collect()
        }
    };
    let values = |sector: Option<Sector>| -> Vec<C64> {
        // the rest of the machine may have other symmetries than the whole
        own.iter()
            .flat_map(|&(own, v)| match (own, sector) {
                (Some(Sector::Forward), None) => vec![if v.im < 0.0 { v.conj() } else { v }],
                (None, Some(Sector::Forward)) => vec![v, v.conj()],
                (a, b) if a == b || b.is_none() => vec![v],
                _ => vec![],
            })
            .collect()
    };
    let largest = match &large {
        Some(near) => near.frequency,
        None => values(None).iter().map(|v| v.abs()).filter(|v| v.is_finite()).fold(3.0 * speed.abs(), f64::max),
    };
    let usual = if large.is_some() { largest } else { 1.2 * largest };
    let frequency = request.frequency.unwrap_or(usual);
    if !(frequency > 0.0 && frequency.is_finite()) {
        return Err(Diagnostic::error(
            "modes.region",
            text!("the frequencies of the machine have no bound from which roots could be counted"),
        )
        .help(text!("give frequency_limit")));
    }
    let mut out = Roots {
        spectrum: Spectrum::default(),
        areas: Vec::new(),
        counted: Vec::new(),
        evaluations: 0,
        margin: request.margin,
        frequency,
        at_zero: None,
    };
    for &sector in sectors {
        let mut f = Determinant::new(&mut counting, sector, (frequency, budget > 0), costly, request.cancel);
        if f.of.members.is_empty() {
            continue;
        }
        let mirrored = sector != Some(Sector::Forward);
        let waves = domains.iter().flat_map(|d| {
            let gap = if d.gap.is_finite() { d.gap } else { 0.0 };
            d.waves.iter().flat_map(move |&w| [c(1e-3 * w.abs(), w), c(-gap - 1e-3 * w.abs(), w)])
        });
        // what the parts hold together has no modes without them
        let spread = if large.is_some() || request.growing && !request.starts.is_empty() { 0 } else { SPREAD };
        let spread = (0..spread).flat_map(|k| {
            let w = frequency * (0.75f64).powi(k);
            let both = [c(-0.03 * w, w), c(-0.03 * w, -w)];
            both.into_iter().take(if mirrored { 1 } else { 2 })
        });
        let starts = values(sector).into_iter().chain(spread).chain(waves.filter(|_| sector != Some(Sector::Axial)));
        let mut starts: Vec<C64> = request.starts.iter().copied().chain(starts).collect();
        // what decays there is not counted: what shows in the response is not overlooked
        if !request.growing && sector != Some(Sector::Axial) && domains.iter().any(|d| !d.left && !d.touches_axis()) {
            starts.extend(resonances(&mut t, &f.of.members, mirrored, (1.2 * largest, frequency)));
        }
        // double roots, which the matrices give to half of the digits
        let free = if mirrored { free_motions(&*f.t, &unknowns) } else { Vec::new() };
        let double = if free.is_empty() { 0.0 } else { HALF * frequency };
        let everywhere = request.everywhere && request.growing && is_polynomial(system);
        let mut rest = Vec::new();
        let mut reach = frequency;
        if everywhere {
            let (found, evaluations) = beyond::beyond(&mut f, (request.margin, frequency), mirrored, budget);
            out.evaluations += evaluations;
            match found {
                Some(found) => (rest, reach) = (found.pieces, found.reach),
                None => out.areas.push(Area {
                    growth: (request.margin, f64::MAX),
                    frequency: (frequency, f64::MAX),
                    mirrored,
                    found: 0,
                    missing: None,
                }),
            }
            f.scale_for(frequency);
        }
        let mut known: Vec<Polished> = Vec::new();
        let same = |a: C64, b: C64| (a - b).abs() <= 1e-9 * b.abs();
        let keep = |t: &mut Characteristic, p: Polished, known: &mut Vec<Polished>| {
            let mut p = p;
            // also where the axes turn, whose rounding is that of the speed; stiff elements of a fine division round the frequencies of soft bearings
            let im = p.value.im.abs();
            if mirrored
                && (im <= 4.0 * (f64::EPSILON * p.value.re.abs().max(speed.abs()) + p.step)
                    || im <= SAME * p.value.re.abs() && im <= 4.0 * t.rounding(&p))
            {
                p.value.im = 0.0;
            }
            // of a real function the upper half is enough
            let inside = p.value.im.abs() <= reach && p.value.re.abs() <= reach && p.defect < 1e-9 && p.value.abs() >= double;
            if inside && !(mirrored && p.value.im < 0.0) && !known.iter().any(|k| same(k.value, p.value)) {
                known.push(p);
            }
        };
        let upper = |s: C64| if mirrored && s.im < 0.0 { s.conj() } else { s };
        let near: Vec<Near> = starts.into_iter().map(|s| Near { value: upper(s), root: None }).collect();
        for p in polish_all(&mut t, &near, sector).into_iter().flatten() {
            keep(&mut t, p, &mut known);
        }
        let (pieces, margin) = rectangles(&domains, speed, request.margin, frequency, request.growing, sector);
        out.margin = out.margin.max(margin);
        let own = if sector == Some(Sector::Axial) { &[][..] } else { &domains[..] };
        let first_area = out.areas.len();
        for Piece { growth, band, bare } in pieces.into_iter().chain(rest) {
            let highest = band.1.abs().max(band.0.abs());
            if highest > frequency || growth.0 >= frequency {
                f.scale_for(highest.max(growth.0));
            }
            let reach = |s: C64| step_limit(own, speed, s, mirrored, bare);
            f.bare = bare;
            let region = Region { re: growth, im: band, mirrored: mirrored && band.0 == 0.0, reach: &reach, noise: SAME };
            let both = |known: &[Polished]| -> Vec<C64> {
                // a rectangle above the axis does not see that the function is real
                let lower = known.iter().filter(|p| mirrored && !region.mirrored && p.value.im != 0.0).map(|p| p.value.conj());
                known.iter().map(|p| p.value).chain(lower).collect()
            };
            let zero_inside = holds(&growth, &band, region.mirrored, C64::zero());
            let of_free = if zero_inside { 2 * free.len() } else { 0 };
            let mut still = of_free;
            let mut given: Vec<C64> = both(&known).into_iter().chain(vec![C64::zero(); still]).collect();
            let (mut first, evaluations) = missing(&mut f, &region, &given, budget);
            out.evaluations += evaluations;
            // several modes at a root that is known; a search about it sees little but rounding
            if first.is_some_and(|n| n > 0) {
                let simple = std::mem::take(&mut known);
                known.extend(simple.iter().flat_map(|p| {
                    let alone = simple.iter().filter(|k| same(k.value, p.value)).count() == 1;
                    alone.then(|| repeated(&mut t, p, 2, sector)).flatten().unwrap_or_else(|| vec![p.clone()])
                }));
                if known.len() > simple.len() {
                    given = both(&known).into_iter().chain(vec![C64::zero(); still]).collect();
                    let again = missing(&mut f, &region, &given, budget);
                    out.evaluations += again.1;
                    first = again.0;
                }
            }
            // a search would divide the region about roots that lie in one place until nothing is left of it
            let mut at_once = None;
            if first != Some(0) && zero_inside {
                at_once = at_zero(&mut f, &known, (frequency, region.mirrored), budget).filter(|a| a.0.count > 1);
            }
            let mut found = Found { zeros: Vec::new(), missing: first, evaluations: 0 };
            if at_once.is_none() {
                if first == Some(0) {
                    let own = |z: &&C64| holds(&growth, &band, region.mirrored, **z) && (!region.mirrored || z.im >= 0.0);
                    found.zeros = given.iter().filter(own).copied().collect();
                } else {
                    found = zeros(&mut f, &region, &given, budget);
                    out.evaluations += found.evaluations;
                }
                let slow = found.zeros.iter().filter(|z| **z != C64::zero() && z.abs() < SLOW * frequency).count();
                if (found.missing != Some(0) || slow > 1) && zero_inside {
                    at_once = at_zero(&mut f, &known, (frequency, region.mirrored), budget);
                }
            }
            if let Some((AtZero { count, within }, evaluations)) = at_once {
                still = count;
                known.retain(|p| p.value.abs() > within);
                given = both(&known);
                given.extend(vec![C64::zero(); still]);
                found = zeros(&mut f, &region, &given, budget);
                out.evaluations += evaluations + found.evaluations;
                let others = out.at_zero.unwrap_or(AtZero { count: 0, within: 0.0 });
                let count = others.count + count.saturating_sub(of_free);
                out.at_zero = (count > 0).then_some(AtZero { count, within: others.within.max(within) });
            }
            let all = |known: &[Polished]| -> Vec<C64> { both(known).into_iter().chain(vec![C64::zero(); still]).collect() };
            let mut left = found.missing;
            let before = known.len();
            let fresh: Vec<C64> = found.zeros.iter().filter(|z| !given.contains(z)).copied().collect();
            let mut moved = false;
            for &z in &fresh {
                let near = |p: &Polished| (p.value - z).abs() <= SAME * z.abs();
                // on a pole nothing is known, beside it the root is
                let aside = 0.1 * SAME * z.abs();
                let mut beside = [c(aside, 0.0), c(-aside, 0.0), c(0.0, aside), c(0.0, -aside)].into_iter();
                let polished = t.polish(z, sector).filter(near);
                if let Some(p) = polished.or_else(|| beside.find_map(|d| t.polish_beside_pole(z + d, sector).filter(near))) {
                    moved |= holds(&growth, &band, region.mirrored, z) != holds(&growth, &band, region.mirrored, p.value);
                    let alike = |k: &Polished| same(k.value, p.value);
                    let again = known.iter().filter(|k| alike(k)).count();
                    let first = known.iter().find(|k| alike(k));
                    // what is missing at the place of a root that is known is another one there
                    match first.and_then(|first| repeated(&mut t, first, again + 1, sector)) {
                        Some(all) => {
                            known.retain(|k| !alike(k));
                            known.extend(all);
                        }
                        None => keep(&mut t, p, &mut known),
                    }
                }
            }
            // the proof is for the roots as they are handed on: the same where each is one that was found, on the same side of the edge
            let unmoved = !moved && known.len() == before + fresh.len();
            if known.len() > before && left == Some(0) && !unmoved {
                let again = missing(&mut f, &region, &all(&known), budget);
                out.evaluations += again.1;
                left = again.0;
            } else if found.zeros.len() > all(&known).iter().filter(|z| holds(&growth, &band, region.mirrored, **z)).count() {
                left = None;
            }
            let inside = known.iter().filter(|p| holds(&growth, &band, region.mirrored, p.value)).count();
            out.areas.push(Area { growth, frequency: band, mirrored, found: inside + of_free / 2, missing: left });
        }
        let areas = &out.areas[first_area..];
        let proven = |z: C64| areas.iter().any(|a| a.complete() && holds(&a.growth, &a.frequency, a.mirrored && a.frequency.0 == 0.0, z));
        known.sort_by(|a, b| a.value.im.total_cmp(&b.value.im).then(a.value.re.total_cmp(&b.value.re)));
        let family = out.spectrum.families.len();
        let mut modes = Vec::new();
        for p in known {
            let mut mode = mode(&unknowns, &p, sector);
            mode.place = (family, modes.len());
            out.counted.push(proven(p.value));
            out.spectrum.modes.push(mode);
            modes.push(eig::Mode { value: p.value, right: p.right, left: p.left, residual: p.defect, sensitivity: 0.0 });
        }
        for x in free {
            let mut mode = bare_mode(&unknowns, C64::zero(), sector);
            mode.place = (family, modes.len());
            unknowns.reshape(&mut mode, C64::zero(), &x);
            out.counted.push(proven(C64::zero()));
            out.spectrum.modes.push(mode);
            modes.push(eig::Mode { value: C64::zero(), right: x.clone(), left: x, residual: 0.0, sensitivity: 0.0 });
        }
        out.spectrum.families.push(Family { sector, modes });
    }
    let mut order: Vec<usize> = (0..out.spectrum.modes.len()).collect();
    let modes = &out.spectrum.modes;
    settle(&mut order, |&k| modes[k].value, |&k| mode_rank(&modes[k]));
    out.counted = order.iter().map(|&k| out.counted[k]).collect();
    out.spectrum.modes = order.iter().map(|&k| modes[k].clone()).collect();
    out.spectrum.polished = out.spectrum.modes.len();
    Ok(out)
}

/// Size of a double root at zero, over the largest frequency, that is rounding.
const HALF: f64 = 1e-6;
/// Distance from zero, over that of the nearest root, within which roots at zero are counted, and that over the largest at which they lie.
const ABOUT_ZERO: f64 = 0.02;
/// Distance from zero, over the largest frequency, from which on a root is none of these.
const SLOW: f64 = 1e-3;
const CLOSE: f64 = 0.1;

/// The roots at zero: as many in a small square about it as in one ten times as large. `None` where there is none, or they cannot be distinguished from others.
fn at_zero(f: &mut Determinant, known: &[Polished], (frequency, mirrored): (f64, bool), budget: u64) -> Option<(AtZero, u64)> {
    // roots that lie together at zero show as some beside it
    let nearest = known.iter().map(|p| p.value.abs()).filter(|d| *d > SLOW * frequency).fold(frequency, f64::min);
    let mut evaluations = 0;
    let mut count = |half: f64| {
        let low = if mirrored { 0.0 } else { -half };
        let region = Region { re: (-half, half), im: (low, half), mirrored, reach: &|_| f64::INFINITY, noise: SAME };
        let (found, spent) = missing(&mut *f, &region, &[], budget);
        evaluations += spent;
        found.and_then(|n| usize::try_from(n).ok())
    };
    let outer = ABOUT_ZERO * nearest;
    let (wide, close) = (count(outer)?, count(CLOSE * outer)?);
    (wide == close && wide > 0).then_some((AtZero { count: wide, within: std::f64::consts::SQRT_2 * CLOSE * outer }, evaluations))
}

/// A root as a mode.
pub(super) fn mode(unknowns: &Unknowns, p: &Polished, sector: Option<Sector>) -> MachineMode {
    let mut mode = MachineMode { residual: p.defect, error: p.step, ..bare_mode(unknowns, p.value, sector) };
    unknowns.reshape(&mut mode, p.value, &p.right);
    mode
}

/// One without its shape.
fn bare_mode(unknowns: &Unknowns, value: C64, sector: Option<Sector>) -> MachineMode {
    MachineMode {
        value,
        q: Vec::new(),
        z: vec![C64::zero(); unknowns.states.len()],
        sector,
        whirl: Whirl::None,
        forward_share: 0.5,
        residual: 0.0,
        error: 0.0,
        polished: true,
        place: (0, 0),
    }
}

/// The mode that a start leads to.
pub(super) fn mode_near(system: &System, about: &Equilibrium, start: C64, sector: Option<Sector>) -> Option<MachineMode> {
    let p = Characteristic::new(system, about).polish(start, sector)?;
    Some(mode(&Unknowns::of(system), &p, sector))
}

fn holds(growth: &(f64, f64), band: &(f64, f64), mirrored: bool, z: C64) -> bool {
    let im = if mirrored { z.im.abs() } else { z.im };
    z.re > growth.0 && z.re < growth.1 && (mirrored || im > band.0) && im < band.1
}

/// No sector of the characteristic matrix is coupled with another.
pub(super) fn uncoupled(t: &mut Characteristic, speed: f64) -> bool {
    let scale = speed.abs().max(1.0);
    [c(0.31, 0.77), c(0.83, -1.9)].iter().all(|s| {
        let [value, _] = t.entries(s.scale(scale));
        t.sectors().coupling_of_entries(t.pattern(), &value) <= ISOTROPIC
    })
}
