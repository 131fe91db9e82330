//! Points located on the characteristic function `g(s, W)`: crossings of a frequency with an order of the spin speed, and double roots,
//! the edges of instability bands of undamped machines.
//!
//! An eigenvalue varies like a square root near a double root, so that looking for the edge by its growth loses half the digits; `g = 0` and
//! `dg/ds = 0` together do not.

use super::characteristic::{Border, Characteristic, Equilibrium, Polished, Test};
use super::sectors::Sector;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;

/// The machine along its speed: finds the state it is linearised about.
pub type State<'a> = &'a (dyn Fn(f64) -> Result<Equilibrium, Diagnostic> + Sync);

/// Steps of the differences in speed, relative.
const STEP: f64 = 1e-3;

fn at_speed<'a>(system: &'a System, state: State, speed: f64) -> Option<Characteristic<'a>> {
    Some(Characteristic::new(system, &state(speed).ok()?))
}

/// A located point.
#[derive(Clone, Copy, Debug)]
pub struct Located {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Eigenvalue there.
    pub value: C64,
    /// Relative distance of T from singularity there.
    pub defect: f64,
    /// Last Newton step in speed, rad/s.
    pub step: f64,
}

/// What the derivative of T over the speed takes besides T: the tangents of nonlinear parts, which have no poles, at speeds beside.
pub(super) struct Beside<'a>(Vec<(f64, Characteristic<'a>)>);

impl<'a> Beside<'a> {
    /// `None` where the machine has no state at a speed beside.
    pub fn new(system: &'a System, state: State, speed: f64) -> Option<Self> {
        if system.slots().iter().all(|s| s.is_linear()) {
            return Some(Beside(Vec::new()));
        }
        let h = STEP * (1.0 + speed.abs());
        let one = |(k, weight): (f64, f64)| Some((weight / (12.0 * h), at_speed(system, state, speed + k * h)?));
        [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)].into_iter().map(one).collect::<Option<Vec<_>>>().map(Beside)
    }

    /// `dT/dW` at fixed s: exact for linear and frequency-domain parts, of which memory has poles that move with the speed; of the tangents of nonlinear
    /// parts by differences of fourth order.
    fn by_speed(&mut self, here: &mut Characteristic, s: C64) -> Vec<C64> {
        let mut out = here.linear_by_speed(s);
        for (weight, beside) in &mut self.0 {
            let tangents = beside.tangents_at(s).unwrap_or_default();
            out.iter_mut().zip(tangents).for_each(|(o, x)| *o += x.scale(*weight));
        }
        out
    }
}

/// Eigenvalue and its derivative in the speed, from a nearby eigenvalue.
pub fn value_and_slope(system: &System, state: State, speed: f64, near: C64, sector: Option<Sector>) -> Option<(C64, C64)> {
    let mut t = at_speed(system, state, speed)?;
    let found = t.polish(near, sector)?;
    Some((found.value, slope(&mut t, &mut Beside::new(system, state, speed)?, &found)?))
}

/// Derivative of a root in the speed: `-(y^H dT/dW x) / (y^H dT/ds x)`.
pub(super) fn slope(t: &mut Characteristic, beside: &mut Beside, root: &Polished) -> Option<C64> {
    let along = match beside.0.is_empty().then(|| t.product_by_speed(root)).flatten() {
        Some(product) => product,
        None => {
            let by_speed = beside.by_speed(t, root.value);
            t.product(root, &by_speed)
        }
    };
    let slope = -along / root.by_s;
    slope.is_finite().then_some(slope)
}

/// A root from one speed to another: Newton's method from where it was, in halved steps where it leads elsewhere.
pub(super) fn carried(system: &System, state: State, from: (f64, C64), to: f64, sector: Option<Sector>, depth: usize) -> Option<C64> {
    let (value, slope) = value_and_slope(system, state, from.0, from.1, sector)?;
    let ahead = value + slope.scale(to - from.0);
    let found = Characteristic::new(system, &state(to).ok()?).polish(ahead, sector).map(|p| p.value);
    if let Some(found) = found
        && (found - ahead).abs() <= 0.3 * (ahead - value).abs() + 1e-6 * value.abs()
    {
        return Some(found);
    }
    if depth == 0 {
        return found;
    }
    let middle = 0.5 * (from.0 + to);
    let there = carried(system, state, from, middle, sector, depth - 1)?;
    carried(system, state, (middle, there), to, sector, depth - 1)
}

/// Speed and growth at which the frequency is `order` times the speed: `T(growth + i order W, W)` singular.
pub fn crossing(system: &System, state: State, order: f64, speed: f64, growth: f64, sector: Option<Sector>) -> Option<Located> {
    let (mut w, mut growth) = (speed, growth);
    let mut t = at_speed(system, state, w)?;
    let border = t.border(c(growth, order * w), &t.members(sector))?;
    let mut last = f64::INFINITY;
    for _ in 0..30 {
        let s = c(growth, order * w);
        let mut t = at_speed(system, state, w)?;
        let test = t.test(s, &border)?;
        let along = -border.product(&test, &Beside::new(system, state, w)?.by_speed(&mut t, s)) + (test.slope * c(0.0, order));
        // g + g_s dgrowth + along dW = 0 for real steps
        let det = test.slope.re * along.im - test.slope.im * along.re;
        let dg = -(test.g.re * along.im - test.g.im * along.re) / det;
        let dw = -(test.slope.re * test.g.im - test.slope.im * test.g.re) / det;
        if !(dg.is_finite() && dw.is_finite()) {
            return None;
        }
        (growth, w) = (growth + dg, w + dw);
        let length = dw.abs() + dg.abs() / order.abs();
        if length <= 1e-14 * w.abs() || (length >= 0.5 * last && length <= 1e-9 * w.abs()) {
            return Some(Located { speed: w, value: c(growth, order * w), defect: test.g.abs(), step: length });
        }
        last = length;
    }
    None
}

/// Speed at which two eigenvalues near `start` merge: `g = 0` and `dg/ds = 0` for (s, W), by Gauss-Newton.
pub fn double_root(system: &System, state: State, speed: f64, start: C64, sector: Option<Sector>) -> Option<Located> {
    let (mut s, mut w) = (start, speed);
    let mut t = at_speed(system, state, w)?;
    let members = t.members(sector);
    let mut border = t.border(s, &members)?;
    let evaluate = |s: C64, w: f64, border: &Border| -> Option<Test> { at_speed(system, state, w)?.test(s, border) };
    let mut last = f64::INFINITY;
    for iteration in 0..40 {
        if iteration == 3 {
            border = at_speed(system, state, w)?.border(s, &members)?;
        }
        let here = evaluate(s, w, &border)?;
        // only the direction of the steps comes from differences; the equations themselves are exact
        let (hs, hw) = (1e-4 * (1.0 + s.abs()), 1e-4 * (1.0 + w.abs()));
        let (s1, s0) = (evaluate(s + c(hs, 0.0), w, &border)?, evaluate(s - c(hs, 0.0), w, &border)?);
        let (w1, w0) = (evaluate(s, w + hw, &border)?, evaluate(s, w - hw, &border)?);
        let second = (s1.slope - s0.slope).scale(0.5 / hs);
        let (gw, gsw) = ((w1.g - w0.g).scale(0.5 / hw), (w1.slope - w0.slope).scale(0.5 / hw));
        // weights bring g and dg/ds to one size: dg/ds times the size of s
        let k = s.abs().max(1.0);
        let rows = [(here.g, here.slope, gw), (here.slope.scale(k), second.scale(k), gsw.scale(k))];
        // unknowns: Re s, Im s, W; each complex equation gives two real ones
        let mut normal = Mat::zeros(3, 3);
        let mut right = vec![0.0; 3];
        let scale = [k, k, w.abs().max(1.0)];
        for (r, ds, dw) in rows {
            for part in [[ds.re, -ds.im, dw.re, r.re], [ds.im, ds.re, dw.im, r.im]] {
                for i in 0..3 {
                    for j in 0..3 {
                        normal[(i, j)] += part[i] * scale[i] * part[j] * scale[j];
                    }
                    right[i] -= part[i] * scale[i] * part[3];
                }
            }
        }
        laval_num::dense::Lu::new(&normal).ok()?.solve(&mut right);
        if !right.iter().all(|x| x.is_finite()) {
            return None;
        }
        s += c(right[0] * scale[0], right[1] * scale[1]);
        w += right[2] * scale[2];
        let length = right.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        if length > 1.0 {
            return None;
        }
        if iteration > 3 && (length <= 1e-13 || (length >= 0.5 * last && length <= 1e-9)) {
            let end = evaluate(s, w, &border)?;
            // consistent: both equations hold, not only their least squares
            let good = end.g.abs() <= 1e-9 && (end.slope.scale(k)).abs() <= 1e-6;
            return good.then_some(Located { speed: w, value: s, defect: end.g.abs(), step: (right[2] * scale[2]).abs() });
        }
        last = length;
    }
    None
}
