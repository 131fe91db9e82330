//! States that dry friction widens to a range: where masses stay although the track pulls, as long as it pulls less than friction holds.
//!
//! ```text
//! r(x) = f,   |f_i| <= T_i for the coordinates i that friction holds,   f = 0 elsewhere
//! ```
//!
//! The ends of the range are sought where friction is used up: at the corners f_i = +T_i or -T_i, reached step by step from the state without friction.

use super::{Search, State};
use crate::diagnostic::Diagnostic;
use crate::model::part::At;
use crate::model::system::Workspace;
use crate::solve::characteristic::coordinate_sectors;
use crate::solve::pencil::{Linearised, time_forms};

/// Most coordinates all of whose corners are visited; of more only those at which all pull alike, and each alone.
const MOST: usize = 6;
/// Steps from the state to a corner.
const STEPS: usize = 16;

/// A state with the range that friction makes of it.
#[derive(Clone, Debug)]
pub struct Zone {
    /// Coordinates held, and the largest force on each (N; of angles N m).
    pub held: Vec<(usize, f64)>,
    /// Unknowns at the corners that were reached.
    pub corners: Vec<Vec<f64>>,
    /// All of them were: else friction holds the masses farther on, to another state.
    pub closed: bool,
    /// Largest growth rate with the masses held, 1/s; NaN where it cannot be told.
    pub growth: f64,
}

impl Search<'_> {
    /// What dry friction makes of a state; `None` where nothing is held.
    ///
    /// # Errors
    /// Eigenvalues that cannot be computed.
    pub fn zone(&mut self, state: &State) -> Result<Option<Zone>, Diagnostic> {
        let system = self.problem.system;
        let about = self.problem.equilibrium(&state.x, state.speed);
        let sectors = coordinate_sectors(system);
        let (v, a) = (about.velocity(&sectors), about.acceleration(&sectors));
        let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed: state.speed, spin_accel: 0.0, t: 0.0 };
        let held = system.grips(&at, &mut Workspace::default());
        if held.is_empty() {
            return Ok(None);
        }
        let signs = corners(held.len());
        let mut out = Zone { corners: Vec::new(), closed: true, growth: f64::NAN, held };
        for sign in signs {
            match self.corner(state, &out.held, &sign) {
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
