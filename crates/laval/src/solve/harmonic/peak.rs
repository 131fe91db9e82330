//! The largest displacement of a body along a branch, refined between the points of the branch.
//!
//! With s the arclength and r(tau; s) the distance of the body from its rest position, the largest distance over a period a(s) = max r is
//! stationary where `da/ds = dr/ds` at the instant of the maximum vanishes. That slope is followed along corrected points; its zero is located within a
//! bracket like any special point.

use super::orbit::Orbit;
use super::problem::Balance;
use super::response::Traced;
use laval_num::continuation::{Direction, Kind, Point, Settings, Status, Test, trace};
use std::f64::consts::TAU;

/// A stationary largest displacement.
#[derive(Clone, Debug)]
pub struct Peak {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Largest distance of the body from its rest position over a period, m.
    pub displacement: f64,
    /// Speeds of corrected points on both sides, where the slope has opposite signs, rad/s.
    pub bracket: (f64, f64),
    /// Relative slope `d ln a / ds` left at the peak, per scaled arclength.
    pub slope: f64,
    /// Scaled residual of the balance at the peak.
    pub residual: f64,
}

/// Points followed at most: a peak is sought within two steps of the branch.
const POINTS: usize = 40;

/// Instants of a period at which the largest distance is looked for before it is refined.
const SAMPLES: usize = 64;

/// The peak of the body whose pair starts at coordinate `body`, next to point `i` of a branch, where it moves farthest of all points. `None` where the
/// branch ends or turns back before the displacement falls again.
pub fn refine(balance: &mut Balance, branch: &Traced, i: usize, body: usize, (lo, hi): (f64, f64)) -> Option<Peak> {
    let (before, at) = (branch.points.get(i.checked_sub(1)?)?, branch.points.get(i)?);
    branch.points.get(i + 1)?;
    let direction = if at.speed > before.speed { Direction::Up } else { Direction::Down };
    let settings = Settings { max_points: POINTS, max_parameter_step: (hi - lo) / 100.0, ..Settings::new(lo, hi) };
    let mut tests: [Test<'_, Balance>; 1] = [Box::new(move |balance, point| slope(balance, point, body).unwrap_or(f64::NAN))];
    let found = trace(balance, &before.x, before.speed, direction, &settings, &mut tests).ok()?;
    let mut best: Option<Peak> = None;
    for special in found.specials.iter().take_while(|s| s.kind != Kind::Fold) {
        if special.kind != Kind::User(0) || special.status != Status::Located {
            continue;
        }
        let point = &special.point;
        let orbit = Orbit::of(balance, &point.x, point.p).ok()?;
        let displacement = farthest(&orbit, body).0;
        if best.as_ref().is_none_or(|b| displacement > b.displacement) {
            let bracket = (special.bracket[0].p, special.bracket[1].p);
            best = Some(Peak { speed: point.p, displacement, bracket, slope: special.residual, residual: point.residual });
        }
    }
    let sampled = farthest(&Orbit::of(balance, &at.x, at.speed).ok()?, body).0;
    best.filter(|p| p.displacement >= sampled * (1.0 - 1e-9))
}

/// Relative slope of the largest distance along a branch: at the instant of the maximum, by central differences along the tangent.
fn slope(balance: &mut Balance, point: &Point, body: usize) -> Option<f64> {
    let (a, tau) = farthest(&Orbit::of(balance, &point.x, point.p).ok()?, body);
    let size = point.x.iter().zip(balance.scales()).map(|(x, s)| (x / s) * (x / s)).sum::<f64>().sqrt().max(1.0);
    let step = 1e-5 * size;
    let mut square = |h: f64| {
        let x: Vec<f64> = point.x.iter().zip(&point.dx_ds).map(|(x, d)| x + h * d).collect();
        let orbit = Orbit::of(balance, &x, point.p + h * point.dp_ds).ok()?;
        let [[x, y], ..] = orbit.pair_at(body, tau);
        Some(x * x + y * y)
    };
    Some((square(step)? - square(-step)?) / (4.0 * step * a * a))
}

/// Largest distance from the axis over a period, and the base phase where it is reached.
fn farthest(orbit: &Orbit, body: usize) -> (f64, f64) {
    let h = TAU / SAMPLES as f64;
    let square = |tau: f64| {
        let [[x, y], ..] = orbit.pair_at(body, tau);
        x * x + y * y
    };
    let (mut tau, mut best) = (0.0, square(0.0));
    for j in 1..SAMPLES {
        let at = h * j as f64;
        let r = square(at);
        if r > best {
            (tau, best) = (at, r);
        }
    }
    // Newton's method on the rate of the square, where it leads to more
    for _ in 0..8 {
        let [[x, y], [dx, dy], [ddx, ddy]] = orbit.pair_at(body, tau);
        let (rate, bend) = (x * dx + y * dy, dx * dx + dy * dy + x * ddx + y * ddy);
        if !(bend < 0.0) {
            break;
        }
        let next = tau + (-rate / bend).clamp(-h, h);
        let r = square(next);
        if !(r > best) {
            break;
        }
        (tau, best) = (next, r);
    }
    (best.sqrt(), tau)
}
