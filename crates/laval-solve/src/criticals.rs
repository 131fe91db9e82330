//! Critical speeds: where the frequency of a mode is a multiple of the spin speed.
//!
//! ```text
//! det T(growth + i k W, W) = 0      for (growth, W), from the crossings of a sweep
//! ```
//!
//! Newton's method from the chord of a step is quick and may lead to the crossing of another mode, or to none: a mode of a memory that turns with the rotor stays beside the
//! line over a wide range. So every solution is held against the mode it belongs to, and where it is another the mode itself is followed and its crossing bracketed.
//!
//! Theory: `docs/theory/linear-vibration.md#critical-speeds`.

use super::characteristic::Characteristic;
use super::locate::{Located, State, carried, crossing, value_and_slope};
use super::pencil::{MachineMode, Whirl};
use super::roots::{in_region, mode_near};
use super::sectors::Sector;
use super::sweep::{Sweep, spectrum};
use super::ties::{rank, settle};
use crate::model::spins::same_ratio;
use crate::model::system::System;
use laval_num::complex::{C64, c};
use laval_num::order::SortByNumber;
use laval_num::univariate::{maximum, root};
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// A speed where the frequency of a mode is a multiple of the speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Critical {
    /// Multiple.
    pub order: f64,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Growth of the mode there, 1/s.
    pub growth: f64,
    /// Direction of whirl.
    pub whirl: Whirl,
    /// Share of the forward part in the squared amplitudes.
    pub forward_share: f64,
    /// Sector of the mode, for a machine without preferred direction.
    pub sector: Option<Sector>,
    /// Branch of the sweep.
    pub branch: usize,
    /// Speeds before and after.
    pub bracket: (f64, f64),
    /// Relative distance of the dynamic stiffness from singularity; NaN when only bracketed.
    pub defect: f64,
    /// Last step, rad/s; the width of the bracket when only bracketed.
    pub step: f64,
}

impl Critical {
    /// Its equations were solved, and the last step was small.
    pub fn located(&self) -> bool {
        self.defect.is_finite() && self.step <= SMALL * self.speed.abs()
    }
    /// An unbalance of the machine's spin can drive the mode.
    pub fn driven_by_unbalance(&self) -> bool {
        self.driven_by(1.0)
    }
    /// An unbalance of a spin of this ratio to that of the machine can drive the mode: in a machine without preferred direction it drives whirls of its own direction alone.
    pub fn driven_by(&self, ratio: f64) -> bool {
        let against = if ratio < 0.0 { Sector::Forward } else { Sector::Backward };
        let direction = self.sector.is_none_or(|s| s != Sector::Axial && s != against);
        same_ratio(self.order, ratio.abs()) && self.whirl.is_lateral() && direction
    }
}

/// Step over the speed up to which a crossing is located.
const SMALL: f64 = 1e-8;
/// Distance of a frequency from the line, over the frequency, that is rounding.
const ON_LINE: f64 = 1e-11;
/// Distance of two values of one root, over the root.
const SAME: f64 = 1e-6;
/// Uncertainty of a bracketed crossing, over the speed.
const TOLERANCE: f64 = 1e-13;
/// Halvings of a step along which a root is followed.
const DEPTH: usize = 6;

/// Crossings of the frequencies of a sweep with multiples of the speed (order above 0), solved for on the characteristic function. Vibrations along or about
/// the axis have no crossing of the order of a spin: no unbalance drives them.
pub fn criticals(system: &System, state: State, found: &Sweep, orders: &[f64]) -> Vec<Critical> {
    let here = Here::now();
    let of_branch = |&(order, branch): &(f64, usize)| {
        let (b, _counted) = (&found.branches[branch], here.enter());
        let mut points: Vec<(f64, MachineMode)> = Vec::new();
        for (k, p) in b.points.iter().enumerate() {
            points.push(p.clone());
            if k >= 1 && k + 1 < b.points.len() {
                // the mode may cross the line and come back between these speeds
                points.extend(beyond(system, state, order, &b.points[k - 1..k + 2]));
            }
        }
        points.sort_by_number(|a| a.0);
        let pairs = points.windows(2);
        pairs.filter_map(|pair| between(system, state, order, (branch, &pair[0], &pair[1]))).collect::<Vec<_>>()
    };
    let mut all: Vec<(f64, usize)> = Vec::new();
    for &order in orders {
        let of_spin = same_ratio(order, 1.0) || system.spins().iter().any(|s| same_ratio(s.ratio.abs(), order));
        let along = |p: &(f64, MachineMode)| matches!(p.1.whirl, Whirl::Axial | Whirl::Torsional);
        let crosses = |b: &usize| !(of_spin && found.branches[*b].points.iter().all(along));
        all.extend((0..found.branches.len()).filter(crosses).map(|b| (order, b)));
    }
    let mut out = all.par_iter().map(of_branch).collect::<Vec<_>>().concat();
    out.sort_by_number(|a| a.order);
    for same in out.chunk_by_mut(|a, b| a.order == b.order) {
        settle(same, |x| c(x.growth, x.speed), |x| rank(x.whirl));
    }
    out
}

/// Frequency above the line.
fn gap(order: f64, speed: f64, value: C64) -> f64 {
    value.im - order * speed.abs()
}

/// A gap that is rounding.
fn on_line(speed: f64, value: C64, gap: f64) -> bool {
    gap.abs() <= ON_LINE * (value.abs() + speed.abs())
}

/// A root followed to another speed is this one.
fn same(followed: Option<C64>, value: C64) -> bool {
    followed.is_some_and(|x| (x - value).abs() <= SAME * value.abs())
}

/// The mode where it is nearest to the line among three neighbours on one side of it, if it is on the other side there.
fn beyond(system: &System, state: State, order: f64, three: &[(f64, MachineMode)]) -> Option<(f64, MachineMode)> {
    let [(w0, m0), (w1, m1), (w2, m2)] = three else { return None };
    let gaps = [(w0, m0), (w1, m1), (w2, m2)].map(|(w, m)| gap(order, *w, m.value));
    let side = gaps[1].signum();
    let nearest = side * gaps[1] < side * gaps[0] && side * gaps[1] < side * gaps[2];
    if !nearest || on_line(*w1, m1.value, gaps[1]) || m1.frequency() == 0.0 {
        return None;
    }
    let value = |w: f64| carried(system, state, (*w1, m1.value), w, m1.sector, DEPTH);
    let (w, top) = maximum(|w| value(w).map(|z| -side * gap(order, w, z)), *w0, *w2, 1e-6 * (w2 - w0).abs())?;
    if !(top > 0.0) {
        return None;
    }
    let value = value(w)?;
    let back = carried(system, state, (w, value), *w1, m1.sector, DEPTH);
    (same(back, m1.value) && !on_line(w, value, top)).then(|| (w, MachineMode { value, ..m1.clone() }))
}

/// The crossing of a mode between two speeds.
fn between(
    system: &System,
    state: State,
    order: f64,
    (branch, a, b): (usize, &(f64, MachineMode), &(f64, MachineMode)),
) -> Option<Critical> {
    let ((w0, m0), (w1, m1)) = (a, b);
    let (g0, g1) = (gap(order, *w0, m0.value), gap(order, *w1, m1.value));
    if !(g0 * g1 < 0.0 || (g0 == 0.0 && g1 != 0.0)) || m0.frequency() == 0.0 && m1.frequency() == 0.0 {
        return None;
    }
    // a mode that runs along the line crosses it nowhere
    if on_line(*w0, m0.value, g0) && on_line(*w1, m1.value, g1) {
        return None;
    }
    let start = w0 + (w1 - w0) * g0 / (g0 - g1);
    // at standstill nothing excites
    if start.abs() <= 1e-12 * w0.abs().max(w1.abs()) {
        return None;
    }
    let share = (start - w0) / (w1 - w0);
    let growth = m0.growth() + (m1.growth() - m0.growth()) * share;
    let solved = solve(system, state, order, ((*w0, m0), (*w1, m1)), (start, growth));
    let (near, there) = (if share < 0.5 { m0 } else { m1 }, solved.and_then(|c| shape(system, state, &c, m0.sector)));
    let shown = there.as_ref().unwrap_or(near);
    Some(Critical {
        order,
        speed: solved.map_or(start, |c| c.speed),
        growth: solved.map_or(growth, |c| c.value.re),
        whirl: shown.whirl,
        forward_share: shown.forward_share,
        sector: m0.sector,
        branch,
        bracket: (*w0, *w1),
        defect: solved.map_or(f64::NAN, |c| c.defect),
        step: solved.map_or(w1 - w0, |c| c.step),
    })
}

type Side<'a> = (f64, &'a MachineMode);

/// By Newton's method where that leads to the crossing of this mode, else by bracketing along the mode.
fn solve(system: &System, state: State, order: f64, (a, b): (Side, Side), (start, growth): (f64, f64)) -> Option<Located> {
    let ((w0, m0), (w1, m1)) = (a, b);
    let slack = 1e-9 * (w1 - w0).abs() + 1e-12 * w1.abs();
    let inside = |c: &Located| c.speed >= w0 - slack && c.speed <= w1 + slack && c.step <= SMALL * c.speed.abs();
    let signed = if start < 0.0 { -order } else { order };
    let led = |from: Side, to: f64| carried(system, state, (from.0, from.1.value), to, from.1.sector, DEPTH);
    let own = |c: &Located| same(led(a, c.speed), c.value) || same(led(b, c.speed), c.value);
    let newton = crossing(system, state, signed, start, growth, m0.sector).filter(|c| inside(c));
    if let Some(c) = newton.filter(own) {
        return Some(c);
    }
    let from = if same(led(a, w1), m1.value) {
        a
    } else if same(led(b, w0), m0.value) {
        b
    } else {
        return None;
    };
    let ends = [(w0, m0), (w1, m1)].map(|(w, m)| (w, gap(order, w, m.value)));
    let speed = root(|w| led(from, w).map(|z| gap(order, w, z)), ends[0], ends[1], TOLERANCE * w1.abs())?;
    let value = led(from, speed)?;
    let polished =
        crossing(system, state, signed, speed, value.re, m0.sector).filter(|c| inside(c) && (c.speed - speed).abs() <= 1e-6 * speed.abs());
    polished.or_else(|| {
        let p = Characteristic::new(system, &state(speed).ok()?).polish(value, m0.sector)?;
        let slope = value_and_slope(system, state, speed, p.value, m0.sector)?.1.im - signed;
        let step = (p.step + f64::EPSILON * p.value.abs()) / slope.abs();
        Some(Located { speed, value: p.value, defect: p.defect, step: step.max(TOLERANCE * speed.abs()) })
    })
}

/// The mode at its crossing, with its shape there.
fn shape(system: &System, state: State, at: &Located, sector: Option<Sector>) -> Option<MachineMode> {
    if in_region(system) {
        return mode_near(system, &state(at.speed).ok()?, at.value, sector);
    }
    let modes = spectrum(system, state, at.speed).ok()?.1.modes;
    let distance = |m: &MachineMode| (m.value - at.value).abs();
    let own = modes.into_iter().filter(|m| m.sector == sector).min_by(|x, y| distance(x).total_cmp(&distance(y)))?;
    (distance(&own) <= SAME * at.value.abs()).then_some(own)
}
