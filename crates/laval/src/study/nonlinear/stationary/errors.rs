//! What errors of a balancer cost: the states at one speed over a parameter that may be off, such as the tilt of a track.

use super::continua::continua;
use super::{Context, Varied, alone, changed, listed};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::stationary::{Request, Search};
use crate::study::shared::support::larger;
use serde::{Deserialize, Serialize};

/// Values when none are requested.
const POINTS: usize = 9;

/// The stable states at a value.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Cost {
    /// Value of the parameter.
    pub value: f64,
    /// Stable states; a continuum counts once.
    pub stable: usize,
    /// Some of them balance, fully or partly.
    pub balances: bool,
    /// Least and largest unbalance left, kg m; NaN where no state is stable.
    pub unbalance: (f64, f64),
    /// Grade number of the least, m/s.
    pub grade: f64,
    /// Unbalance without the movable masses, kg m.
    pub without: f64,
    /// Least and largest distance of a body from the axis, m.
    pub radius: (f64, f64),
}

/// What one parameter costs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Errors {
    pub requested: Varied,
    pub costs: Vec<Cost>,
}

fn widen(pair: &mut (f64, f64), x: f64) {
    // the first, and what is no number
    let lower = !(pair.0 <= x);
    *pair = (if lower { x } else { pair.0 }, if pair.1.is_nan() { x } else { larger(pair.1, x) });
}

/// Seeks the states anew at every value.
///
/// # Errors
/// Eigenvalues that cannot be computed; a machine that does not exist at a value.
pub fn errors(
    system: &System,
    requested: &Varied,
    request: &Request,
    context: &Context,
    goes_on: &mut dyn FnMut(u64) -> bool,
) -> Result<Errors, Diagnostic> {
    let own = alone(request, requested.speed);
    let mut costs = Vec::new();
    for value in requested.range.linspace(POINTS) {
        if !goes_on(0) {
            break;
        }
        let machine = changed(system, &requested.path, value)?;
        let mut search = Search::new(&machine, &own, context.cancel);
        let found = search.run(|p| !context.cancelled() && p.work < own.work)?;
        // what was not sought to its end says nothing of what is not there
        if !goes_on(found.work) {
            break;
        }
        let none = (f64::NAN, f64::NAN);
        let mut cost = Cost { value, stable: 0, balances: false, unbalance: none, grade: f64::NAN, without: f64::NAN, radius: none };
        for row in listed(&machine, &mut search, &found, requested.speed)? {
            if let Some(u) = row.seen.unbalance {
                cost.without = u.without();
            }
            if !row.stable() {
                continue;
            }
            cost.stable += 1;
            cost.balances |= row.class.balances();
            widen(&mut cost.radius, row.seen.radius());
            if let Some(u) = row.seen.unbalance {
                widen(&mut cost.unbalance, u.moment.abs());
                cost.grade = u.grade(cost.unbalance.0, requested.speed);
            }
        }
        for s in continua(&machine, &mut search, &found, &[requested.speed], goes_on)?.sheets.iter().filter(|s| s.stable > 0) {
            cost.stable += 1;
            cost.balances |= s.class.balances();
            widen(&mut cost.radius, s.radius);
            if let Some(u) = s.unbalance {
                cost.without = u.without();
                widen(&mut cost.unbalance, u.moment.abs());
                cost.grade = u.grade(cost.unbalance.0, requested.speed);
            }
        }
        costs.push(cost);
    }
    Ok(Errors { requested: requested.clone(), costs })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_and_the_largest_are_kept() {
        let mut pair = (f64::NAN, f64::NAN);
        for (x, want) in [(2.0, (2.0, 2.0)), (3.0, (2.0, 3.0)), (1.0, (1.0, 3.0)), (2.5, (1.0, 3.0))] {
            widen(&mut pair, x);
            assert_eq!(pair, want);
        }
        widen(&mut pair, f64::NAN);
        assert!(pair.1.is_nan());
    }
}
