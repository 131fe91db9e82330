//! Where along a branch the displacement of a body or the force of a part is largest or least, refined between the points of the branch.
//!
//! With s the arclength and r(tau; s) the size at base phase tau, the largest over a period a(s) = max r is stationary where `da/ds = dr/ds` at the instant of
//! the maximum vanishes. That slope is followed along corrected points; its zero is located within a bracket like any special point.

use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::measure::Measure;
use crate::harmonic::branches::response::Traced;
use laval_num::continuation::{Direction, Kind, Point, Settings, Status, Test, trace};
use serde::{Deserialize, Serialize};

/// A stationary largest value.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Peak {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Largest value over a period, m or N.
    pub value: f64,
    /// Unknowns of the balance there.
    pub x: Vec<f64>,
    /// Speeds of corrected points on both sides, where the slope has opposite signs, rad/s.
    pub bracket: (f64, f64),
    /// Slope left, `d (a^2) / ds / (2 a0^2)` per scaled arclength, a0 the value at the point of the branch.
    pub slope: f64,
    /// Scaled residual of the balance there; of an interpolation the largest of the motions it goes through.
    pub residual: f64,
}

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// A peak.
    Largest,
    /// Where a force or displacement nearly vanishes.
    Least,
}

/// Points followed at most.
const POINTS: usize = 40;

/// The peak (or least value) next to point `i` of a branch, where it is larger (less) than at the points beside. `None` where the branch ends or turns back
/// before it falls (rises) again.
pub fn refine(balance: &mut Balance, branch: &Traced, i: usize, measure: Measure, sense: Sense, (lo, hi): (f64, f64)) -> Option<Peak> {
    let (before, at, after) = (branch.points.get(i.checked_sub(1)?)?, branch.points.get(i)?, branch.points.get(i + 1)?);
    let direction = if at.speed > before.speed { Direction::Up } else { Direction::Down };
    // no further than one of these steps beyond the points
    let speeds = [before.speed, at.speed, after.speed];
    let (least, most) = speeds.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &w| (a.min(w), b.max(w)));
    let range = (lo.max(2.0 * least - most), hi.min(2.0 * most - least));
    let settings = Settings { max_points: POINTS, max_parameter_step: (hi - lo) / 100.0, ..Settings::new(range.0, range.1) };
    let parts = branch.discretisation.whole().symmetry.order().max(1);
    let size = |balance: &mut Balance, x: &[f64], speed: f64| {
        Some(measure.largest_of_part(balance.system, &Orbit::of(balance, x, speed).ok()?, branch.turns(), parts).0)
    };
    let sampled = size(balance, &at.x, at.speed)?;
    let beside = size(balance, &before.x, before.speed)?;
    let (turns, unit) = (branch.turns(), sampled.max(beside));
    let mut tests: [Test<'_, Balance>; 1] =
        [Box::new(move |balance, point| slope(balance, point, measure, (turns, parts), unit).unwrap_or(f64::NAN))];
    let found = trace(balance, &before.x, before.speed, direction, &settings, &mut tests).ok()?;
    let mut best: Option<Peak> = None;
    let better = |a: f64, b: f64| if sense == Sense::Largest { a > b } else { a < b };
    for special in found.specials.iter().take_while(|s| s.kind != Kind::Fold) {
        if special.kind != Kind::User(0) || special.status != Status::Located {
            continue;
        }
        let point = &special.point;
        let value = size(balance, &point.x, point.p)?;
        if best.as_ref().is_none_or(|b| better(value, b.value)) {
            let bracket = (special.bracket[0].p, special.bracket[1].p);
            best = Some(Peak { speed: point.p, value, x: point.x.clone(), bracket, slope: special.residual, residual: point.residual });
        }
    }
    let slack = 1e-9 * sampled;
    best.filter(|p| if sense == Sense::Largest { p.value >= sampled - slack } else { p.value <= sampled + slack })
}

/// Slope of the square along a branch: at the instant of the largest value, by central differences along the tangent.
fn slope(balance: &mut Balance, point: &Point, measure: Measure, (turns, parts): (usize, usize), unit: f64) -> Option<f64> {
    let system = balance.system;
    balance.condense(point.p, true).ok()?;
    let orbit = Orbit::of(balance, &point.x, point.p).ok()?;
    let tau = measure.largest_of_part(system, &orbit, turns, parts).1;
    let size = point.x.iter().zip(balance.scales()).map(|(x, s)| (x / s) * (x / s)).sum::<f64>().sqrt().max(1.0);
    let step = 1e-5 * size;
    let beside = orbit.beside(balance, (&point.x, point.p), (&point.dx_ds, point.dp_ds), step).ok()?;
    let [less, more] = beside.map(|orbit| measure.square_at(system, &orbit, turns, tau));
    Some((more - less) / (4.0 * step * unit * unit))
}
