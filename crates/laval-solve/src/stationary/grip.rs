//! States that dry friction widens to a range: where masses stay although the track pulls, as long as it pulls less than friction holds.
//!
//! ```text
//! r(x) = f,   |f_i| <= T_i for the coordinates i that friction holds,   f = 0 elsewhere
//! ```
//!
//! The ends of the range are sought where friction is used up: at the corners f_i = +T_i or -T_i, reached step by step from the state without friction.
//! About the states of a continuum there are no such corners: there the masses are moved along straight ways until friction gives way.
//!
//! Theory: `docs/theory/equilibria.md#dry-friction`.

use super::{Search, State};
use crate::characteristic::Equilibrium;
use crate::characteristic::coordinate_sectors;
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::system::Workspace;
use crate::pencil::{Linearised, time_forms};
use laval_num::sampling::Points;
use std::f64::consts::PI;

/// Most coordinates all of whose corners are visited; of more only those at which all pull alike, and each alone.
const MOST: usize = 6;
/// Steps from the state to a corner.
const STEPS: usize = 16;

/// Ways from a state of a continuum: as many at random for each mass, beside those on which it moves alone.
const WAYS: usize = 4;
/// Step along a way, rad, and halvings of the last one.
const STEP: f64 = 0.05;
const HALVINGS: usize = 40;
/// Steps of Newton's method for what is not held, and their length in typical sizes at which it rests.
const SETTLING: (usize, f64) = (20, 1e-10);

/// What friction holds about a state of a continuum.
#[derive(Clone, Debug)]
pub struct Slack {
    /// Coordinates held, and the largest force on each (N; of angles N m).
    pub held: Vec<(usize, f64)>,
    /// Unknowns where friction is just used up, one for each way; where it holds half a turn on, those there.
    pub ends: Vec<Vec<f64>>,
    /// Friction gave way on all of them.
    pub closed: bool,
}

/// A state with the range that friction makes of it.
#[derive(Clone, Debug)]
pub struct Zone {
    /// Coordinates held, and the largest force on each (N; of angles N m).
    pub held: Vec<(usize, f64)>,
    /// Unknowns at the corners that were reached.
    pub corners: Vec<Vec<f64>>,
    /// All of them were: else friction holds the masses farther on, to another state.
    pub closed: bool,
    /// Largest growth rate with the masses held, 1/s; NaN where it cannot be determined.
    pub growth: f64,
}

impl Search<'_> {
    /// What dry friction makes of a state; `None` where nothing is held.
    ///
    /// `goes_on` receives every corner; those left when it says no count as not found.
    ///
    /// # Errors
    /// Eigenvalues that cannot be computed.
    pub fn zone(&mut self, state: &State, goes_on: &mut dyn FnMut(u64) -> bool) -> Result<Option<Zone>, Diagnostic> {
        let system = self.problem.system;
        let about = self.problem.equilibrium(&state.x, state.speed);
        let held = self.gripped(&about, state.speed);
        if held.is_empty() {
            return Ok(None);
        }
        let signs = corners(held.len());
        let mut out = Zone { corners: Vec::new(), closed: true, growth: f64::NAN, held };
        for sign in signs {
            let place = if goes_on(STEPS as u64) { self.corner(state, &out.held, &sign) } else { None };
            match place {
                Some(x) => out.corners.push(x),
                None => out.closed = false,
            }
        }
        if time_forms(system).is_ok() {
            let rate = 10.0 * state.speed.abs().max(1.0);
            let rest: Vec<usize> = out.held.iter().map(|h| h.0).collect();
            let spectrum = Linearised::new(system, &about)?.holding(&rest, rate).spectrum();
            out.growth = spectrum.ok().and_then(|s| s.least_stable().map(|m| m.value.re)).unwrap_or(f64::NAN);
        }
        Ok(Some(out))
    }

    /// Coordinates that friction holds, and how strongly.
    fn gripped(&self, about: &Equilibrium, speed: f64) -> Vec<(usize, f64)> {
        let system = self.problem.system;
        let sectors = coordinate_sectors(system);
        let (v, a) = (about.velocity(&sectors), about.acceleration(&sectors));
        let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        system.grips(&at, &mut Workspace::default())
    }

    /// How far from a state of a continuum friction holds the masses; `None` where nothing is held. `tried` numbers the ways, which `goes_on` receives.
    pub fn slack(&mut self, state: &State, tried: u32, goes_on: &mut dyn FnMut(u64) -> bool) -> Option<Slack> {
        let about = self.problem.equilibrium(&state.x, state.speed);
        let held = self.gripped(&about, state.speed);
        if held.is_empty() {
            return None;
        }
        let n = held.len();
        let alone =
            |k: usize| (0..n).map(|i| if i == k / 2 { if k.is_multiple_of(2) { 1.0 } else { -1.0 } } else { 0.0 }).collect::<Vec<f64>>();
        let random = |k: usize| {
            let place = tried.wrapping_mul((WAYS * n) as u32).wrapping_add(k as u32);
            (0..n).map(|i| 2.0 * Points::Random.at(10, place, i as u32) - 1.0).collect()
        };
        let mut out = Slack { held, ends: Vec::new(), closed: true };
        for way in (0..2 * n).map(alone).chain((0..WAYS * n).map(random)) {
            if !goes_on((PI / STEP) as u64) {
                break;
            }
            let (end, gave) = self.way(state, &out.held, &way);
            out.ends.push(end);
            out.closed &= gave;
        }
        Some(out)
    }

    /// Along a straight way until friction is used up or half a turn is over: where, and whether friction gave way.
    fn way(&mut self, state: &State, held: &[(usize, f64)], way: &[f64]) -> (Vec<f64>, bool) {
        let longest = way.iter().fold(0.0f64, |m, w| m.max(w.abs()));
        let mut last = state.x.clone();
        let mut at = 0.0;
        while at < PI {
            let next = (at + STEP).min(PI);
            let mut place = |s: f64, from: &[f64]| -> Option<Vec<f64>> {
                let mut x = from.to_vec();
                held.iter().zip(way).for_each(|(h, w)| x[h.0] = state.x[h.0] + s * w / longest);
                self.holds(&mut x, state.speed, held).then_some(x)
            };
            let Some(x) = place(next, &last) else {
                let (mut lo, mut hi) = (at, next);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (lo + hi);
                    match place(middle, &last) {
                        Some(x) => (lo, last) = (middle, x),
                        None => hi = middle,
                    }
                }
                return (last, true);
            };
            (last, at) = (x, next);
        }
        (last, false)
    }

    /// Lets everything that is not held come to rest, and tells whether friction holds the rest.
    fn holds(&mut self, x: &mut [f64], speed: f64, held: &[(usize, f64)]) -> bool {
        let free: Vec<usize> = (0..x.len()).filter(|i| held.iter().all(|h| h.0 != *i)).collect();
        for _ in 0..SETTLING.0 {
            let Some((moved, r)) = self.yield_to(x, speed, &free) else { return false };
            if !moved.is_finite() {
                return false;
            }
            if moved <= SETTLING.1 {
                return held.iter().all(|h| r[h.0].abs() <= h.1);
            }
        }
        false
    }

    /// The state at which friction is used up in these directions.
    fn corner(&mut self, state: &State, held: &[(usize, f64)], sign: &[f64]) -> Option<Vec<f64>> {
        let mut x = state.x.clone();
        for k in 1..=STEPS {
            let share = k as f64 / STEPS as f64;
            self.problem.load = held.iter().zip(sign).map(|(h, s)| (h.0, share * s * h.1)).collect();
            let before = x.clone();
            let settled = self.settle(&mut x, state.speed);
            let far = held.iter().any(|h| !((x[h.0] - before[h.0]).abs() < 1.0));
            if settled.is_err() || far {
                self.problem.load.clear();
                return None;
            }
        }
        self.problem.load.clear();
        Some(x)
    }
}

/// Directions in which friction may be used up.
fn corners(n: usize) -> Vec<Vec<f64>> {
    let of = |bits: usize| (0..n).map(|i| if bits >> i & 1 == 1 { 1.0 } else { -1.0 }).collect();
    if n <= MOST {
        return (0..1 << n).map(of).collect();
    }
    let alone = |k: usize, s: f64| (0..n).map(|i| if i == k { s } else { 0.0 }).collect();
    [1.0, -1.0].into_iter().flat_map(|s| std::iter::once(vec![s; n]).chain((0..n).map(move |k| alone(k, s)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_is_used_up_in_all_directions() {
        assert_eq!(corners(2), [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]]);
        assert_eq!((corners(6).len(), corners(7).len()), (64, 16));
        assert!(corners(7).iter().all(|c| c.len() == 7));
    }
}
