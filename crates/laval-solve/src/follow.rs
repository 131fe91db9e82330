//! Roots along the spin speed, each followed by its tangent and Newton's method: of machines with parts that have no time form, and of machines too large for all their modes.

use super::characteristic::{Characteristic, Polished};
use super::locate::{Beside, State, slope};
use super::machine_mode::{MachineMode, Unknowns};
use super::pencil::Spectrum;
use super::roots::{Request, mode, mode_near, roots};
use super::sectors::Sector;
use super::side_by_side::{Near, polish_all};
use super::spectra_ahead::together;
use super::sweep::{Branch, Count, Strongest, Sweep};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::work::piece;

/// Growth or decay over the speed from which on the roots of a machine with parts without time form are counted at every speed; those nearer to the imaginary axis are
/// followed.
const COUNTED: f64 = 0.01;

/// Of a root that is followed: share of the step over which its tangent is taken; how far the tangent may lead, relative to the root; how far from the tangent
/// the root may end, relative to the tangent and to the root.
const TANGENT: f64 = 1e-3;
const FAR: f64 = 0.2;
const BEND: f64 = 0.3;
const STILL: f64 = 1e-4;

/// Of a large machine roots are counted at the first speed, at the last and between them, in equal steps of so many speeds at most.
const COUNT_EACH: usize = 16;

/// Whether roots are counted at one of the speeds.
fn is_counted(k: usize, speeds: usize) -> bool {
    let last = speeds.saturating_sub(1);
    let steps = last.div_ceil(COUNT_EACH).max(2);
    (0..=steps).any(|i| (i * last + steps / 2) / steps == k)
}

/// Steps between two speeds: more where two roots seem to lead to one.
const PIECES: [usize; 4] = [1, 4, 16, 64];

/// Deepest halving of a step along which a root is followed.
const DEPTH: usize = 7;

/// Roots of a machine with parts that have no time form: each goes on where its tangent and Newton's method lead. Roots that enter the region are born.
pub(super) fn follow(
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
            let lead = |m: &&(usize, MachineMode)| lead_in_pieces(system, state, (speeds[k - 1], speed), &m.1, pieces);
            let Some(all) = piece(|| together(&those, lead)) else { return Ok(met(out)) };
            for ((id, mode), to) in those.into_iter().zip(all) {
                led.extend(to?.map(|value| (*id, value, mode.sector)));
            }
        }
        let starts: Vec<C64> = led.iter().map(|l| signed(l.1, l.2)).collect();
        let frequency = limit.is_finite().then_some(limit);
        let dense = system.domains(speed).iter().any(|d| !d.axis);
        let margin = if dense { COUNTED * speed.abs() } else { 0.0 };
        let request = Request { margin, frequency, starts: &starts, alone: true, ..Request::default() };
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
            out.branches[*id].points.push((speed, mode.without_vectors()));
        }
        record(&mut out, speed, found);
    }
    traced_back(system, state, limit, out)
}

/// Roots of a machine too large for all its modes: tangents are exact, and roots are counted at some of the speeds.
pub(super) fn follow_large(
    system: &System,
    state: State,
    speeds: &[f64],
    limit: f64,
    mut each: impl FnMut(usize, u64) -> bool,
) -> Result<Sweep, Diagnostic> {
    let unknowns = Unknowns::of(system);
    let mut out = Sweep { worst_assurance: 1.0, ..Sweep::default() };
    let mut frequency = limit.is_finite().then_some(limit);
    // the roots of the speed before
    let mut before: Vec<Before> = Vec::new();
    for (k, &speed) in speeds.iter().enumerate() {
        if !each(k, out.solved) {
            break;
        }
        let about = state(speed)?;
        let mut t = Characteristic::new(system, &about);
        let Some(led) = piece(|| lead_all(system, state, (k.checked_sub(1).map_or(speed, |k| speeds[k]), speed), &mut t, &before)) else {
            break;
        };
        let (mut led, ambiguous) = led?;
        if ambiguous {
            out.ambiguous.push((speeds[k - 1], speed));
        }
        let mut spectrum = Spectrum::default();
        if is_counted(k, speeds.len()) {
            let starts: Vec<C64> = led.iter().map(|l| signed(l.root.value, l.sector)).collect();
            let request = Request { frequency, starts: &starts, alone: true, ..Request::default() };
            let Some(found) = piece(|| roots(system, &about, &request)) else { break };
            let found = found?;
            frequency = Some(found.frequency);
            out.counts.push(Count { speed, frequency: found.frequency, complete: found.areas.iter().all(|a| a.complete()) });
            spectrum = found.spectrum;
        } else {
            let inside = |l: &Led| frequency.is_none_or(|f| l.root.value.im.abs() <= f && l.root.value.re.abs() <= f);
            led.retain(inside);
            spectrum.modes = led.iter().map(|l| mode(&unknowns, &l.root, l.sector)).collect();
            spectrum.polished = led.len();
        }
        out.strongest.extend(Strongest::of(speed, &spectrum));
        out.solved += 1;
        let mut beside = Beside::new(system, state, speed);
        let earlier = std::mem::take(&mut before);
        for m in &spectrum.modes {
            let own = led.iter().position(|l| l.sector == m.sector && same(m.value, l.root.value));
            let (id, root) = match own.map(|at| led.swap_remove(at)) {
                Some(l) => (l.branch, Some(l.root)),
                None => {
                    out.branches.push(Branch::default());
                    (out.branches.len() - 1, t.polish(m.value, m.sector))
                }
            };
            out.branches[id].points.push((speed, m.without_vectors()));
            let tangent = beside.as_mut().zip(root.as_ref()).and_then(|(beside, root)| slope(&mut t, beside, root));
            let old = earlier.iter().find(|b| b.branch == id && b.mode.sector == m.sector);
            let old = old.and_then(|b| Some((speeds[k - 1], b.mode.value, b.tangent?)));
            before.push(Before { branch: id, mode: m.without_vectors(), tangent, old, root });
        }
        record(&mut out, speed, spectrum);
    }
    traced_back(system, state, frequency.unwrap_or(limit), out)
}

/// The spectrum of one more speed; of those before it values are enough.
fn record(out: &mut Sweep, speed: f64, mut spectrum: Spectrum) {
    spectrum.forget_vectors();
    out.points.push((speed, spectrum));
}

/// A root at the speed before.
struct Before {
    branch: usize,
    mode: MachineMode,
    tangent: Option<C64>,
    /// Speed, root and tangent one more speed before.
    old: Option<(f64, C64, C64)>,
    root: Option<Polished>,
}

impl Before {
    /// Where the tangent leads, and what is expected: by the cubic through both speeds where there are two and it does not bend far from the tangent.
    fn ahead(&self, from: f64, to: f64) -> Option<(C64, C64)> {
        let (tangent, value, step) = (self.tangent?, self.mode.value, to - from);
        let along = tangent.scale(step);
        let expected = self.old.map_or(along, |(speed, old, slope)| {
            let chord = (value - old).scale(1.0 / (from - speed));
            let (second, third) = (tangent.scale(2.0) + slope - chord.scale(3.0), tangent + slope - chord.scale(2.0));
            let share = step / (from - speed);
            (tangent + (second + third.scale(share)).scale(share)).scale(step)
        });
        let bends = !((expected - along).abs() <= BEND * along.abs());
        Some((along, if bends { along } else { expected }))
    }
}

/// A root that was followed to a speed.
struct Led {
    branch: usize,
    sector: Option<Sector>,
    root: Polished,
}

/// Roots of one speed at the next, and whether two of them could not be distinguished: of those one branch ends.
fn lead_all(
    system: &System,
    state: State,
    (from, to): (f64, f64),
    t: &mut Characteristic,
    before: &[Before],
) -> Result<(Vec<Led>, bool), Diagnostic> {
    let mut led: Vec<Led> = Vec::new();
    let in_pieces = |t: &mut Characteristic, m: &MachineMode, pieces: usize| -> Result<Option<Polished>, Diagnostic> {
        let value = lead_in_pieces(system, state, (from, to), m, pieces)?;
        Ok(value.and_then(|value| t.polish(value, m.sector)))
    };
    let ahead: Vec<Option<(C64, C64)>> = before.iter().map(|b| b.ahead(from, to)).collect();
    let mut near: Vec<Option<Polished>> = before.iter().map(|_| None).collect();
    for sector in [None, Some(Sector::Forward), Some(Sector::Backward), Some(Sector::Axial)] {
        let (mut which, mut starts) = (Vec::new(), Vec::new());
        for (k, b) in before.iter().enumerate().filter(|(_, b)| b.mode.sector == sector) {
            if let Some((_, expected)) = ahead[k] {
                which.push(k);
                starts.push(Near { value: b.mode.value + expected, root: b.root.as_ref() });
            }
        }
        for (k, root) in which.into_iter().zip(polish_all(t, &starts, sector)) {
            near[k] = root;
        }
    }
    for ((b, near), ahead) in before.iter().zip(near).zip(ahead) {
        let m = &b.mode;
        let near = near.zip(ahead).and_then(|(root, (along, _))| {
            ((root.value - m.value - along).abs() <= BEND * along.abs() + STILL * m.value.abs()).then_some(root)
        });
        let root = match near {
            Some(root) => Some(root),
            None => in_pieces(t, m, PIECES[1])?,
        };
        led.extend(root.map(|root| Led { branch: b.branch, sector: m.sector, root }));
    }
    let again = |led: &[Led], k: usize| {
        let alike = |(j, l): (usize, &Led)| j != k && l.sector == led[k].sector && same(l.root.value, led[k].root.value);
        led.iter().enumerate().any(alike)
    };
    for pieces in &PIECES[1..] {
        let twice: Vec<usize> = (0..led.len()).filter(|&k| again(&led, k)).collect();
        for k in twice {
            let Some(b) = before.iter().find(|b| b.branch == led[k].branch) else { continue };
            if let Some(root) = in_pieces(t, &b.mode, *pieces)? {
                led[k].root = root;
            }
        }
    }
    let all = led.len();
    let mut k = 0;
    while k < led.len() {
        if again(&led[..=k], k) {
            led.remove(k);
        } else {
            k += 1;
        }
    }
    let ambiguous = led.len() < all;
    Ok((led, ambiguous))
}

/// A root of the backward sector as the conjugate one of the forward sector.
pub(super) fn signed(value: C64, sector: Option<Sector>) -> C64 {
    if sector == Some(Sector::Backward) { value.conj() } else { value }
}

/// With every branch followed back to where it comes from.
fn traced_back(system: &System, state: State, limit: f64, mut out: Sweep) -> Result<Sweep, Diagnostic> {
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
pub(super) fn same(a: C64, b: C64) -> bool {
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
                let there = there.without_vectors();
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

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::complex::c;

    /// At both ends and in the middle at least, never further apart than said.
    #[test]
    fn roots_are_counted_along_the_speeds() {
        for speeds in 1..200 {
            let counted: Vec<usize> = (0..speeds).filter(|&k| is_counted(k, speeds)).collect();
            assert!(counted[0] == 0 && counted[counted.len() - 1] == speeds - 1, "{speeds}: {counted:?}");
            assert!(counted.len() >= speeds.min(3), "{speeds}: {counted:?}");
            assert!(counted.windows(2).all(|w| w[1] - w[0] <= COUNT_EACH), "{speeds}: {counted:?}");
        }
        assert_eq!((0..50).filter(|&k| is_counted(k, 50)).count(), 5);
    }

    /// Of a root that is a cubic over the speed both speeds before say where it goes; where that bends far from the tangent the tangent does.
    #[test]
    fn a_cubic_is_led_exactly() {
        let root = |w: f64| c(1.0 + 0.2 * w, 40.0 + 3.0 * w - 0.02 * w * w + 0.001 * w * w * w);
        let slope = |w: f64| c(0.2, 3.0 - 0.04 * w + 0.003 * w * w);
        let mut mode = MachineMode {
            value: root(10.0),
            q: vec![],
            z: vec![],
            sector: None,
            whirl: super::super::machine_mode::Whirl::None,
            forward_share: 0.5,
            residual: 0.0,
            error: 0.0,
            polished: true,
            place: (0, 0),
        };
        let old = Some((7.0, root(7.0), slope(7.0)));
        let before = |mode: MachineMode, old| Before { branch: 0, mode, tangent: Some(slope(10.0)), old, root: None };
        let (along, expected) = before(mode.clone(), old).ahead(10.0, 14.0).unwrap();
        assert!((along - slope(10.0).scale(4.0)).abs() < 1e-13);
        assert!((expected + root(10.0) - root(14.0)).abs() < 1e-12, "{expected:?}");
        assert_eq!(before(mode.clone(), None).ahead(10.0, 14.0).unwrap().1, along);
        mode.value += c(0.0, 100.0);
        assert_eq!(before(mode, old).ahead(10.0, 14.0).unwrap().1, along);
    }
}
