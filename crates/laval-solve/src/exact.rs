//! Roots of a machine whose pencil holds a fit, on its exact characteristic function, and the number of those that grow.
//!
//! A part given in the frequency domain may have a branch cut: a memory that dies out without oscillation in a continuum of rates. Its fit has a ladder
//! of real eigenvalues in place of the cut. They are no roots of the machine, while true roots close to the cut may be hidden among them. So every
//! eigenvalue of the pencil is a start of Newton's method on the exact function only, and what does not lead to a root is left out. That no growing
//! root is missed is counted independently: the argument principle for `det T` over the right half plane, where impedances of materials that only take
//! up energy are analytic, with the known roots divided out so that the phase turns slowly.

use super::characteristic::Characteristic;
use super::pencil::{Linearised, MachineMode, Spectrum};
use super::sectors::Sector;
use super::ties::settle_modes;
use laval_num::complex::{C64, c};
use laval_num::factor::{Directed, Factors, Selection};
use laval_num::order::SortByNumber;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Iterates of Newton's method that are this many times farther from their start than a root may be: beside a pole of the fit there is no root, and
/// without a bound all steps would be spent on finding some other one.
const STRAY: f64 = 4.0;

/// Replaces the modes of the pencil by roots of the exact function.
pub(super) fn settle(t: &mut Characteristic, linear: &Linearised, spectrum: &mut Spectrum) {
    let modes = std::mem::take(&mut spectrum.modes);
    let size = modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
    // in its own sector a member of a backward pair has its frequency below the axis
    let gap = |k: usize| {
        let near = |m: &MachineMode| if m.sector == modes[k].sector { (m.value - modes[k].value).abs() } else { f64::INFINITY };
        modes.iter().enumerate().filter(|&(j, _)| j != k).map(|(_, m)| near(m)).fold(size, f64::min)
    };
    let gaps: Vec<f64> = (0..modes.len()).map(gap).collect();
    let mut found: Vec<(usize, MachineMode)> = Vec::new();
    // first the roots beside their start, then those that the ladder of the fit hides
    for (near, starts) in [(0.3, &[0.0][..]), (3.0, &[0.5, -0.5, 1.0, -1.0][..])] {
        for (k, mode) in modes.iter().enumerate() {
            if found.iter().any(|f| f.0 == k) {
                continue;
            }
            for aside in starts {
                let start = mode.value + c(0.0, aside * gaps[k]);
                let Some(mut p) = t.polish_within(start, mode.sector, STRAY * near * gaps[k]) else { continue };
                if p.value.im.abs() <= 4.0 * f64::EPSILON * p.value.re.abs() {
                    p.value.im = 0.0;
                }
                let moved = (p.value - mode.value).abs();
                let mut root = mode.clone();
                linear.unknowns().reshape(&mut root, p.value, &p.right);
                let known =
                    |f: &(usize, MachineMode)| f.1.sector == root.sector && (f.1.value - root.value).abs() <= 1e-9 * root.value.abs();
                // Newton's method from far away finds some root of the machine, which the eigenvalue beside it stands for
                if moved > near * gaps[k] || found.iter().any(known) {
                    continue;
                }
                (root.error, root.polished) = (p.step, true);
                found.push((k, root));
                break;
            }
        }
    }
    spectrum.left_out = modes.len() - found.len();
    spectrum.polished = found.len();
    for (f, family) in spectrum.families.iter_mut().enumerate() {
        let mut place = 0;
        let mut kept = Vec::new();
        for (i, mode) in family.modes.iter().enumerate() {
            let Some((_, root)) = found.iter_mut().find(|(k, _)| modes[*k].place == (f, i)) else { continue };
            let signed = family.sector.is_some() && root.sector == Some(Sector::Backward);
            kept.push(laval_num::eig::Mode { value: if signed { root.value.conj() } else { root.value }, ..mode.clone() });
            root.place = (f, place);
            place += 1;
        }
        family.modes = kept;
    }
    spectrum.modes = found.into_iter().map(|f| f.1).collect();
    settle_modes(&mut spectrum.modes);
}

/// Number of growing roots by the argument principle, each pair of conjugates counted once, like the modes of `spectrum`, which help as places to look at
/// closely. `None` where the phase cannot be followed: a root on the imaginary axis, a frequency-domain part that is not analytic.
pub fn growing(t: &mut Characteristic, spectrum: &Spectrum) -> Option<usize> {
    let roots: Vec<(C64, usize)> = spectrum.modes.iter().map(|m| (m.value, multiplicity(m))).collect();
    let largest = roots.iter().map(|r| r.0.abs()).fold(t.speed().abs(), f64::max);
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let radius = 1e3 * largest;
    let of = t.selection(&(0..t.size()).collect::<Vec<_>>());
    let mut phase = Phase { t, roots: &roots, of, factors: Factors::default() };
    // a quarter of the circle, then down the imaginary axis; the other half is the mirror image
    let mut total = 0.0;
    let arc: Vec<C64> = (0..=16).map(|k| C64::cis(0.5 * PI * f64::from(k) / 16.0).scale(radius)).collect();
    let mut heights: Vec<f64> = (0..=72).map(|k| radius * 10f64.powf(-f64::from(k) / 6.0)).chain([0.0]).collect();
    let speed = phase.t.speed().abs();
    for centre in roots.iter().map(|r| r.0.im.abs()).chain([speed, 2.0 * speed]).filter(|x| *x > 0.0) {
        heights.push(centre);
        for k in 0..=36 {
            let off = centre * 10f64.powf(-f64::from(k) / 3.0);
            heights.extend([centre - off, centre + off].into_iter().filter(|h| *h >= 0.0 && *h < radius));
        }
    }
    heights.sort_by_number_down(|a| *a);
    heights.dedup();
    let path: Vec<C64> = arc.into_iter().chain(heights.into_iter().skip(1).map(|h| c(0.0, h))).collect();
    let mut last = phase.at(path[0])?;
    for w in path.windows(2) {
        let next = phase.at(w[1])?;
        total += phase.turned(w[0], last, w[1], next, 0)?;
        last = next;
    }
    let inside = total / PI;
    let missed = inside.round();
    let known: usize = roots.iter().filter(|r| r.0.re > 0.0).map(|r| r.1).sum();
    if !((inside - missed).abs() < 0.05 && missed + known as f64 >= 0.0) {
        return None;
    }
    // pairs, except what stands alone on the real axis
    let single: usize = roots.iter().filter(|r| r.0.re > 0.0 && r.1 == 1).count();
    Some((known + missed as usize - single).div_ceil(2) + single)
}

/// Roots of the machine in x and y that a mode stands for.
pub(super) fn multiplicity(m: &MachineMode) -> usize {
    let paired = m.value.im != 0.0 || matches!(m.sector, Some(Sector::Forward | Sector::Backward));
    if paired { 2 } else { 1 }
}

/// Phase of `det T` with the known roots divided out.
struct Phase<'a, 'b> {
    t: &'a mut Characteristic<'b>,
    roots: &'a [(C64, usize)],
    of: Arc<Selection>,
    factors: Factors<Directed>,
}

impl Phase<'_, '_> {
    fn at(&mut self, s: C64) -> Option<f64> {
        let mut phase = self.t.determinant(s, &self.of, &mut self.factors)?.phase;
        for &(root, times) in self.roots {
            phase -= (s - root).arg();
            if times == 2 {
                phase -= (s - root.conj()).arg();
            }
        }
        phase.is_finite().then_some(phase)
    }
    /// Change of the phase from a to b.
    fn turned(&mut self, a: C64, at_a: f64, b: C64, at_b: f64, depth: usize) -> Option<f64> {
        let wrap = |x: f64| x - TAU * (x / TAU).round();
        let middle = (a + b).scale(0.5);
        let at_middle = self.at(middle)?;
        let (first, second) = (wrap(at_middle - at_a), wrap(at_b - at_middle));
        if first.abs() < 0.7 && second.abs() < 0.7 {
            return Some(first + second);
        }
        if depth > 60 {
            return None;
        }
        Some(self.turned(a, at_a, middle, at_middle, depth + 1)? + self.turned(middle, at_middle, b, at_b, depth + 1)?)
    }
}
