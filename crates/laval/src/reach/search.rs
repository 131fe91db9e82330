//! From the values of the file to those of the wanted result.

use super::goal::{Sought, Valued};
use super::machine::Varied;
use crate::diagnostic::Diagnostic;
use crate::study::Context;
use crate::text;
use laval_num::nearest::{Axis, nearest};

/// What a search ended with.
pub(super) struct Found {
    /// Result of the file.
    pub from: f64,
    /// Values, all of them.
    pub p: Vec<f64>,
    /// The result there, and its slopes.
    pub value: f64,
    pub slopes: Vec<f64>,
    pub reached: bool,
    pub unit: &'static str,
    pub evaluations: usize,
}

/// Steps of a search, and halvings of one.
const STEPS: usize = 30;
const HALVINGS: usize = 8;
/// Change of the parameters, over their ranges, with which a search that has reached the value ends.
const STILL: f64 = 1e-6;
/// Step of differences, over the range.
const DIFFERENCE: f64 = 1e-4;
/// Change of the result over the whole range of a parameter, over the result, that is rounding: the parameter does not enter.
const NO_INFLUENCE: f64 = 1e-7;

/// Moves the parameters `free`.
pub(super) fn search(
    machine: &Varied,
    sought: &mut dyn Sought,
    start: &[f64],
    free: &[usize],
    wanted: f64,
    context: &Context,
) -> Result<Found, Diagnostic> {
    let mut evaluations = 0;
    let mut p = start.to_vec();
    let lost = || Diagnostic::error("reach.goal", text!("the machine of the file does not have this result"));
    let stated = sought.mark().first().copied().unwrap_or(0.0);
    let mut now = valued(machine, sought, &p, free, &mut evaluations, context)?.ok_or_else(lost)?;
    let found = sought.mark().first().copied().unwrap_or(0.0);
    // another result beside it is not moved in its place
    if !((found - stated).abs() <= sought.tolerance() * stated.abs()) {
        let (stated, found) = (text::quantity(stated, "rad/s"), text::quantity(found, "rad/s"));
        let message = text!("the result at {stated} cannot be moved: the nearest that can be followed is at {found}", stated, found);
        return Err(Diagnostic::error("reach.goal", message));
    }
    let from = now.value;
    let size = wanted.abs().max(from.abs());
    let accuracy = sought.accuracy();
    let near = |v: f64| (v - wanted).abs() <= accuracy * size;
    for _ in 0..STEPS {
        if context.cancelled() {
            break;
        }
        let axes: Vec<Axis> = free
            .iter()
            .zip(&now.slopes)
            .map(|(&k, &gradient)| {
                let f = &machine.free[k];
                Axis { from: start[k], scale: f.high - f.low, low: f.low, high: f.high, gradient }
            })
            .collect();
        let plane = wanted - now.value + free.iter().zip(&now.slopes).map(|(&k, g)| g * p[k]).sum::<f64>();
        let (next, _) = nearest(&axes, plane);
        let far = free.iter().zip(&next).map(|(&k, x)| (x - p[k]).abs() / (machine.free[k].high - machine.free[k].low)).fold(0.0, f64::max);
        if far <= STILL && near(now.value) || far <= 1e-12 {
            break;
        }
        let mark = sought.mark();
        let mut step = 1.0;
        let mut better = None;
        for _ in 0..HALVINGS {
            let mut trial = p.clone();
            for (&k, x) in free.iter().zip(&next) {
                // a whole step ends on the bound itself
                trial[k] = if step == 1.0 { *x } else { p[k] + step * (x - p[k]) };
            }
            let there = valued(machine, sought, &trial, free, &mut evaluations, context);
            if let Ok(Some(there)) = there
                && ((there.value - wanted).abs() < (now.value - wanted).abs() || near(there.value))
            {
                better = Some((trial, there));
                break;
            }
            sought.back(&mark);
            step *= 0.5;
        }
        match better {
            Some((trial, there)) => (p, now) = (trial, there),
            None => break,
        }
    }
    let mut slopes = vec![0.0; start.len()];
    for (&k, g) in free.iter().zip(&now.slopes) {
        slopes[k] = *g;
    }
    Ok(Found { from, reached: near(now.value), p, value: now.value, slopes, unit: sought.unit(), evaluations })
}

/// The result at some values with all slopes: where none is known exactly, by differences.
fn valued(
    machine: &Varied,
    sought: &mut dyn Sought,
    p: &[f64],
    free: &[usize],
    evaluations: &mut usize,
    context: &Context,
) -> Result<Option<Valued>, Diagnostic> {
    let exact: Vec<Vec<usize>> = free.iter().map(|&k| machine.indices[k].clone()).filter(|i| !i.is_empty()).collect();
    *evaluations += 1;
    let Some(found) = sought.of(&machine.at(p)?, &exact, context)? else { return Ok(None) };
    let mut known = found.slopes.into_iter();
    let mut slopes: Vec<f64> =
        free.iter().map(|&k| if machine.indices[k].is_empty() { f64::NAN } else { known.next().unwrap_or(f64::NAN) }).collect();
    let mark = sought.mark();
    for (&k, slope) in free.iter().zip(&mut slopes).filter(|s| s.1.is_nan()) {
        let f = &machine.free[k];
        let h = DIFFERENCE * (f.high - f.low);
        let (a, b) = ((p[k] - h).max(f.low), (p[k] + h).min(f.high));
        let mut beside = |x: f64| {
            let mut moved = p.to_vec();
            moved[k] = x;
            *evaluations += 1;
            let value = sought.of(&machine.at(&moved)?, &[], context)?.map(|v| v.value);
            sought.back(&mark);
            Ok::<_, Diagnostic>(value)
        };
        *slope = match (beside(a)?, beside(b)?) {
            (Some(low), Some(high)) => (high - low) / (b - a),
            _ => 0.0,
        };
    }
    for (&k, slope) in free.iter().zip(&mut slopes) {
        let f = &machine.free[k];
        if (*slope * (f.high - f.low)).abs() <= NO_INFLUENCE * found.value.abs() {
            *slope = 0.0;
        }
    }
    Ok(Some(Valued { value: found.value, slopes }))
}
