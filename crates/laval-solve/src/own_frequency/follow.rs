//! Modes with the coefficients of their own frequency along the spin speed.
//!
//! Every mode goes on to the next speed where the line through the two before, and the secant method, lead. One that ends far from that line, or where another ends, goes by
//! way of the speed between. The modes of each speed are counted as those of one.

use super::{OwnModes, own_modes, range, solve, still};
use crate::locate::State;
use crate::machine_mode::MachineMode;
use crate::pencil::Spectrum;
use crate::sweep::{Branch, Strongest, Sweep};
use laval_model::diagnostic::Diagnostic;
use laval_model::model::system::System;
use laval_num::complex::C64;

/// How far from the line a mode may end, over the step and over the mode.
const BEND: f64 = 0.3;
const NEAR: f64 = 2e-3;
/// Deepest halving of a step, and steps where two modes led to one.
const DEPTH: usize = 6;
const PIECES: usize = 8;
/// Distance of two values of one mode, over the mode.
const SAME: f64 = 1e-7;

/// Modes followed, and the evidence for them.
#[derive(Clone, Debug, Default)]
pub struct Followed {
    /// Branches and spectra.
    pub sweep: Sweep,
    /// Frequencies searched, rad/s.
    pub range: (f64, f64),
    /// Speeds at which the count does not agree with what was found.
    pub open: Vec<f64>,
    /// Most modes below the range at any speed, and above it.
    pub below: usize,
    /// See `below`.
    pub above: usize,
    /// Largest [`residual`](super::OwnMode::residual).
    pub residual: f64,
}

/// Follows the modes over the speeds (ascending); `each` receives the number of the speed and of the spectra computed so far, and stops the work by saying false.
///
/// # Errors
/// As [`own_modes`], and as the state.
pub fn follow(
    system: &System,
    state: State,
    speeds: &[f64],
    limit: Option<f64>,
    mut each: impl FnMut(usize, u64) -> bool,
) -> Result<Followed, Diagnostic> {
    let mut out = Followed { sweep: Sweep { worst_assurance: 1.0, ..Sweep::default() }, ..Followed::default() };
    let (Some(first), Some(last)) = (speeds.first(), speeds.last()) else { return Ok(out) };
    let ends = [range(system, &state(*first)?, limit)?, range(system, &state(*last)?, limit)?];
    out.range = (ends[0].0, ends[0].1.max(ends[1].1));
    for (k, &speed) in speeds.iter().enumerate() {
        if !each(k, out.sweep.solved) {
            break;
        }
        let about = state(speed)?;
        let mut led: Vec<(usize, MachineMode)> = Vec::new();
        if k > 0 {
            let open: Vec<usize> = (0..out.sweep.branches.len()).filter(|&b| ends_at(&out.sweep.branches[b], speeds[k - 1])).collect();
            for &b in &open {
                led.extend(lead_branch(system, state, &out.sweep.branches[b], speed, 1)?.map(|m| (b, m)));
            }
            let twice = |all: &[(usize, MachineMode)], b: usize| {
                let own = all.iter().find(|l| l.0 == b).map(|l| l.1.clone());
                own.is_some_and(|own| all.iter().any(|l| l.0 != b && same(&l.1, &own)))
            };
            for b in open.into_iter().filter(|&b| twice(&led, b)).collect::<Vec<_>>() {
                let again = lead_branch(system, state, &out.sweep.branches[b], speed, PIECES)?;
                led.retain(|l| l.0 != b);
                if again.as_ref().is_some_and(|m| led.iter().any(|l| same(&l.1, m))) {
                    out.sweep.ambiguous.push((speeds[k - 1], speed));
                } else {
                    led.extend(again.map(|m| (b, m)));
                }
            }
        }
        let known: Vec<MachineMode> = led.iter().map(|l| l.1.clone()).collect();
        let solved = out.sweep.solved;
        let own = own_modes(system, &about, out.range, &known, &mut |more| each(k, solved + more))?;
        if !own.complete {
            break;
        }
        out.record(speed, own, led);
    }
    Ok(out)
}

fn ends_at(branch: &Branch, speed: f64) -> bool {
    branch.points.last().is_some_and(|p| p.0 == speed)
}

fn same(a: &MachineMode, b: &MachineMode) -> bool {
    a.sector == b.sector && (a.value - b.value).abs() <= SAME * b.value.abs()
}

impl Followed {
    fn record(&mut self, speed: f64, own: OwnModes, mut led: Vec<(usize, MachineMode)>) {
        self.sweep.solved += own.spectra;
        self.below = self.below.max(own.below);
        self.above = self.above.max(own.above);
        if !own.counted() {
            self.open.push(speed);
        }
        for m in &own.modes {
            if !(m.residual <= self.residual) {
                self.residual = m.residual;
            }
            let branch = match led.iter().position(|l| same(&l.1, &m.mode)) {
                Some(at) => led.swap_remove(at).0,
                None => {
                    self.sweep.branches.push(Branch::default());
                    self.sweep.branches.len() - 1
                }
            };
            self.sweep.branches[branch].points.push((speed, m.mode.without_vectors()));
        }
        let spectrum = Spectrum { modes: own.modes.iter().map(|m| m.mode.without_vectors()).collect(), ..Spectrum::default() };
        self.sweep.strongest.extend(Strongest::of(speed, &spectrum));
        self.sweep.points.push((speed, spectrum));
    }
}

/// Where a branch goes at the next speed, in so many equal steps.
fn lead_branch(system: &System, state: State, branch: &Branch, to: f64, pieces: usize) -> Result<Option<MachineMode>, Diagnostic> {
    let Some((from, mode)) = branch.points.last() else { return Ok(None) };
    let rate = branch.points.iter().rev().nth(1).map(|(w, m)| (mode.value - m.value).scale(1.0 / (from - w)));
    let (mut at, mut mode) = (*from, mode.clone());
    for k in 1..=pieces {
        let next = from + (to - from) * k as f64 / pieces as f64;
        let expected = rate.filter(|_| pieces == 1).map(|r| mode.value + r.scale(next - at));
        match lead(system, state, (at, next), &mode, expected, DEPTH)? {
            Some(there) => (at, mode) = (next, there),
            None => return Ok(None),
        }
    }
    Ok(Some(mode))
}

fn lead(
    system: &System,
    state: State,
    (from, to): (f64, f64),
    mode: &MachineMode,
    expected: Option<C64>,
    depth: usize,
) -> Result<Option<MachineMode>, Diagnostic> {
    let start = expected.unwrap_or(mode.value);
    let near = |m: &MachineMode| (m.value - start).abs() <= BEND * (start - mode.value).abs() + NEAR * mode.value.abs();
    let frequency = if still(mode) { 0.0 } else { start.im.abs() };
    let there = solve(system, &state(to)?, &MachineMode { value: start, ..mode.clone() }, frequency);
    if let Some(there) = there.filter(|t| near(&t.mode)) {
        return Ok(Some(there.mode));
    }
    if depth == 0 {
        return Ok(None);
    }
    let middle = 0.5 * (from + to);
    match lead(system, state, (from, middle), mode, None, depth - 1)? {
        Some(between) => {
            let ahead = between.value + (between.value - mode.value);
            lead(system, state, (middle, to), &between, Some(ahead), depth - 1)
        }
        None => Ok(None),
    }
}
