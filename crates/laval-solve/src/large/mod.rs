//! Machines with so many states that not all of their modes are computed but those up to a frequency, as [roots](crate::roots) that are counted.
//!
//! Starts for Newton's method are the eigenvalues nearest to places on the imaginary axis, so many places that what is resolved around them covers
//! the axis up to the frequency. They need not be complete: what they lack the count of the roots says.
//!
//! Theory: `docs/theory/linear-vibration.md#machines-with-many-coordinates`.

use crate::characteristic::{Characteristic, Equilibrium};
use crate::model::system::System;
use crate::sectors::Sector;
use laval_num::complex::{C64, c};
use laval_num::eig::{Nearest, Quadratic, nearest, nearest_real};
use laval_num::factor::Selection;
use laval_num::order::ascending;
use std::sync::Arc;

#[cfg(test)]
mod tests;

/// First-order states up to which all modes of a machine are computed.
pub const ALL_MODES: usize = 160;

/// Modes, of either direction, that the frequency holds at least where none is given, and multiple of the speed that it is at least.
pub const LEAST_MODES: usize = 12;
const OF_SPEED: f64 = 3.0;
/// Of the frequencies above those modes, the number among which the limit is laid into the widest gap.
const GAPS: usize = 4;
/// Place of the first shift, over the size of the lowest frequencies: on the real axis of a real problem, else on the imaginary one.
const LOW: f64 = 0.37;
/// Eigenvalues sought about one place, and steps for them, at most.
const WANTED: usize = 24;
const STEPS: usize = 120;
/// Eigenvalues sought beside one frequency.
const BESIDE: usize = 8;
/// Place in an interval of the axis: in its middle may lie an eigenvalue.
const INSIDE: f64 = 0.4873;
/// Places that the axis is covered from, at most.
const PLACES: usize = 200;
/// Share of the resolved radius that counts as covered, and radius over the interval below which it cannot be covered.
const COVERED: f64 = 0.95;
const NARROW: f64 = 0.01;
/// Two starts at this relative distance lead to one root.
const SAME: f64 = 1e-6;
/// Size of a start over the frequency up to which roots are sought, where starts are near roots, and where parts with memory or given in the frequency domain move them.
const JUST_BEYOND: f64 = 1.01;
const BEYOND: f64 = 1.5;

/// Size of a root over that of the lowest frequencies, and of its imaginary part over the real one, that is rounding.
const REAL: f64 = 1e-4;

/// The machine has more states than all modes are computed of.
pub fn is_large(system: &System) -> bool {
    2 * system.n() + system.m() > ALL_MODES
}

/// Places near the eigenvalues of the machine without memory and parts given in the frequency domain, and the frequency up to which they were sought.
pub(super) struct Starts {
    pub frequency: f64,
    pub values: Vec<(Option<Sector>, C64)>,
}

/// Eigenvalues, with the range of the imaginary axis that their neighbourhood covers.
struct Covered {
    values: Vec<C64>,
    range: (f64, f64),
}

impl Covered {
    /// Of the eigenvalues nearest to a shift.
    fn about(shift: C64, found: Nearest) -> Self {
        let half = ((COVERED * found.radius).powi(2) - shift.re * shift.re).max(0.0).sqrt();
        Covered { values: found.values, range: (shift.im - half, shift.im + half) }
    }
}

/// The unknowns of one sector.
struct Block {
    sector: Option<Sector>,
    of: Arc<Selection>,
    terms: [Vec<C64>; 3],
    /// In x and y, of all unknowns of a machine at rest.
    real: Option<[Vec<f64>; 3]>,
}

impl Block {
    fn problem(&self) -> Quadratic<'_> {
        Quadratic { plan: &self.of.inner, terms: self.terms.each_ref().map(Vec::as_slice) }
    }
    /// Of a real problem the upper half is enough.
    fn mirrored(&self) -> bool {
        self.sector != Some(Sector::Forward)
    }
    /// Eigenvalues near the lowest frequencies, of about this size.
    fn low(&self, size: f64, wanted: usize) -> Option<Covered> {
        let found = if let Some(real) = &self.real {
            let problem = Quadratic { plan: &self.of.inner, terms: real.each_ref().map(Vec::as_slice) };
            nearest_real(&problem, LOW * size, size, wanted, STEPS).map(|found| Covered::about(c(LOW * size, 0.0), found))
        } else {
            nearest(&self.problem(), c(0.0, LOW * size), size, wanted, STEPS).map(|found| Covered::about(c(0.0, LOW * size), found))
        };
        found.ok()
    }
    /// Eigenvalues whose neighbourhoods cover the axis from `a` to `b`, with those already found.
    fn cover(&self, (a, b): (f64, f64), first: Option<Covered>) -> Vec<C64> {
        let (mut open, mut out, mut places) = (vec![(a, b)], Vec::new(), 0);
        if let Some(Covered { values, range: (low, high) }) = first {
            out = values;
            open = [(a, b.min(low)), (a.max(high), b)].into_iter().filter(|(a, b)| b > a).collect();
        }
        while let Some((a, b)) = open.pop()
            && places < PLACES
        {
            places += 1;
            let middle = a + INSIDE * (b - a);
            let half = (b - middle).max(middle - a);
            let Ok(found) = nearest(&self.problem(), c(0.0, middle), half.max(middle.abs()), WANTED, STEPS) else { continue };
            out.extend(found.values);
            let radius = COVERED * found.radius;
            if radius < half && radius > NARROW * half {
                open.extend([(a, middle - radius), (middle + radius, b)].into_iter().filter(|(a, b)| b > a));
            }
        }
        out
    }
}

/// Eigenvalues near the places where the axis meets a frequency, of either direction.
pub(super) fn near(t: &Characteristic, frequency: f64) -> Vec<C64> {
    let mut out = Vec::new();
    for block in blocks(t, &[None]) {
        out.extend(nearest(&block.problem(), c(0.0, frequency), frequency.abs(), BESIDE, STEPS).unwrap_or_default().values);
    }
    out
}

/// The largest real positive root of a machine about an equilibrium, 1/s, among the eigenvalues nearest to 0: a static instability. Of parts with memory or given in the
/// frequency domain nothing is known, and none is found.
pub fn divergence(system: &System, about: &Equilibrium) -> Option<f64> {
    let t = Characteristic::new(system, about);
    let of = |block: &Block| {
        let size = slow(block);
        let found = nearest(&block.problem(), c(0.0, 0.0), size, WANTED, STEPS).ok()?;
        // a double root at 0, as of a machine that nothing holds, is known to the square root of rounding
        let real = found.values.into_iter().filter(|s| s.re > REAL * size && s.im.abs() <= REAL * s.re);
        real.map(|s| s.re).max_by(f64::total_cmp)
    };
    blocks(&t, &[None]).iter().filter_map(of).max_by(f64::total_cmp)
}

fn blocks(t: &Characteristic, sectors: &[Option<Sector>]) -> Vec<Block> {
    let terms = t.polynomial();
    let block = |&sector: &Option<Sector>| {
        let of = t.selection(&t.members(sector));
        let real = sector.is_none().then(|| t.real_polynomial()).flatten().map(|all| all.map(|all| of.taken(&all)));
        let terms = terms.each_ref().map(|all| of.taken(all));
        Block { sector, of, terms, real }
    };
    sectors.iter().map(block).filter(|b| !b.of.members.is_empty()).collect()
}

/// Starts for the roots of a machine in some of its sectors.
pub(super) fn starts(t: &Characteristic, sectors: &[Option<Sector>], frequency: Option<f64>) -> Starts {
    let blocks = blocks(t, sectors);
    let (frequency, mut slowest) = match frequency {
        Some(frequency) => (frequency, Vec::new()),
        None => lowest(&blocks, t.speed().abs()),
    };
    slowest.resize_with(blocks.len(), || None);
    let reach = frequency * if t.as_polynomial().is_some() { JUST_BEYOND } else { BEYOND };
    let mut values: Vec<(Option<Sector>, C64)> = Vec::new();
    for (block, first) in blocks.iter().zip(slowest) {
        let low = if block.mirrored() { 0.0 } else { -frequency };
        for mut s in block.cover((low, frequency), first) {
            if block.mirrored() && s.im < 0.0 {
                s = s.conj();
            }
            let known = |v: &(Option<Sector>, C64)| v.0 == block.sector && (v.1 - s).abs() <= SAME * s.abs();
            if s.re.abs() <= reach && s.im.abs() <= reach && !values.iter().any(known) {
                values.push((block.sector, s));
            }
        }
    }
    Starts { frequency, values }
}

/// The frequency up to which the modes of a large machine are computed where none is given: at least three times the speed, and so high that twelve modes lie below.
pub fn usual_frequency(system: &System, about: &Equilibrium) -> f64 {
    lowest(&blocks(&Characteristic::new(system, about), &[None]), about.speed.abs()).0
}

/// A frequency that at least [`LEAST_MODES`] modes lie below, in a wide gap between two of them; and for each block what was found for that.
fn lowest(blocks: &[Block], speed: f64) -> (f64, Vec<Option<Covered>>) {
    let (mut all, mut about): (Vec<f64>, _) = (Vec::new(), Vec::new());
    for block in blocks {
        let size = if speed > 0.0 { speed } else { slow(block) };
        let found = block.low(size, (LEAST_MODES + GAPS) * if block.mirrored() { 2 } else { 1 });
        let values = found.iter().flat_map(|f| &f.values);
        all.extend(values.map(|s| s.im).filter(|f| !(block.mirrored() && *f < 0.0)).map(f64::abs));
        about.push(found);
    }
    ascending(&mut all);
    let last = all.last().map_or(0.0, |f| 1.05 * f);
    let above = all.get(LEAST_MODES - 1..).unwrap_or_default();
    let gaps = above.windows(2).take(GAPS).map(|w| (w[1] - w[0], 0.5 * (w[0] + w[1])));
    let limit = gaps.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(last, |g| g.1);
    (limit.max(OF_SPEED * speed), about)
}

/// The size of the lowest frequencies of a block, roughly: the usual one of an unknown by itself, over the number of unknowns.
fn slow(block: &Block) -> f64 {
    let pattern = block.of.inner.pattern();
    let own = |i: usize| {
        let e = pattern.index(i, i)?;
        let [k, _, m] = block.terms.each_ref().map(|all| all[e].abs());
        Some((k / m).sqrt()).filter(|f| *f > 0.0 && f.is_finite())
    };
    let mut all: Vec<f64> = (0..pattern.n()).filter_map(own).collect();
    ascending(&mut all);
    all.get(all.len() / 2).map_or(1.0, |f| f / pattern.n() as f64)
}
