//! A result where it should be: the least change of released parameters that moves a critical speed, a limit of stability, a peak or a jump to a wanted value.
//!
//! ```text
//! minimise sum_i ((p_i - p0_i) / (high_i - low_i))^2   with  f(p) = wanted,  low_i <= p_i <= high_i
//! ```
//!
//! f is linearised with its derivatives and the step to the nearest point of the box on that plane ([`laval_num::nearest`]) halved until f comes nearer to the wanted value.
//! Derivatives are exact where the parameters are those of parts; positions of attachments, and all parameters for a peak of the linear response, are varied by differences. What
//! changes the result by less than the differences show does not move. Where the box ends first, the parameters at their bounds are
//! named.
//!
//! Symbols: p parameters, p0 those of the file.
//!
//! Validity: that of the result; changes along which it exists, as a fold does not beyond a cusp.
//!
//! Sources: sequential quadratic programming, Nocedal, Wright, Numerical Optimization (2006) chapter 18.

mod criticals;
mod goal;
mod limits;
mod machine;
mod places;
mod resonances;
mod search;
#[cfg(test)]
mod tests;

pub use goal::{Goal, Of};
pub use machine::Free;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::file::{Catalog, Loaded};
use crate::study::Context;
use crate::text;
use crate::text::Text;
use machine::Varied;
use search::{Found, search};

/// A parameter that was moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// Its path.
    pub path: String,
    /// Value of the file.
    pub from: f64,
    /// Value found.
    pub to: f64,
    /// The change over the range that was released.
    pub share: f64,
    /// It stands at a bound.
    pub at_bound: bool,
}

/// What one parameter alone would do.
#[derive(Clone, Debug, PartialEq)]
pub struct Alone {
    /// Its path.
    pub path: String,
    /// Its value.
    pub value: f64,
    /// The result there.
    pub result: f64,
    /// That is the wanted one.
    pub reached: bool,
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached {
    /// The result of the file.
    pub from: f64,
    /// The result with the values found.
    pub to: f64,
    /// It is the wanted one.
    pub reached: bool,
    /// The parameters, as they were released.
    pub moved: Vec<Moved>,
    /// Why it is not, and which parameters stand at a bound.
    pub impossible: Option<(Text, Vec<String>)>,
    /// Each parameter alone.
    pub alone: Vec<Alone>,
    /// Results between that of the file and the wanted one, and the change that each takes: the root of the sum of squared shares.
    pub curve: Vec<(f64, f64)>,
    /// How often the result was computed.
    pub evaluations: usize,
}

/// Points of the curve.
const CURVE: usize = 6;

/// Moves the released parameters until the result of a file is the wanted one.
///
/// # Errors
/// A path that names no number, a range that is none, a result that the machine does not have.
pub fn reach(
    text: &str,
    loaded: &Loaded,
    catalog: &Catalog,
    goal: &Goal,
    wanted: f64,
    free: &[Free],
    context: &Context,
) -> Result<Reached, Diagnostics> {
    let one = |d| Diagnostics(vec![d]);
    if free.is_empty() {
        return Err(one(Diagnostic::error("reach.free", text!("no parameter is released"))));
    }
    if !wanted.is_finite() {
        return Err(one(Diagnostic::error("reach.wanted", text!("the wanted value is no number"))));
    }
    let machine = Varied::new(text, loaded, catalog, free)?;
    let mut sought = goal.sought(loaded, context).map_err(one)?;
    let origin = sought.mark();
    let start = machine.start();
    let all: Vec<usize> = (0..free.len()).collect();
    let found = search(&machine, &mut *sought, &start, &all, wanted, context).map_err(one)?;
    let (mut alone, mut curve, mut evaluations) = (Vec::new(), Vec::new(), found.evaluations);
    let quick = sought.quick() && !context.cancelled();
    if quick && free.len() > 1 {
        for k in 0..free.len() {
            sought.back(&origin);
            let own = search(&machine, &mut *sought, &start, &[k], wanted, context).map_err(one)?;
            evaluations += own.evaluations;
            alone.push(Alone { path: free[k].path.clone(), value: own.p[k], result: own.value, reached: own.reached });
        }
    }
    if quick {
        curve.push((found.from, 0.0));
        for k in 1..CURVE {
            sought.back(&origin);
            let part = found.from + (found.value - found.from) * k as f64 / CURVE as f64;
            let own = search(&machine, &mut *sought, &start, &all, part, context).map_err(one)?;
            evaluations += own.evaluations;
            curve.push((own.value, machine.distance(&own.p)));
        }
        curve.push((found.value, machine.distance(&found.p)));
    }
    Ok(finished(&machine, found, alone, curve, evaluations))
}

fn finished(machine: &Varied, found: Found, alone: Vec<Alone>, curve: Vec<(f64, f64)>, evaluations: usize) -> Reached {
    let start = machine.start();
    let moved: Vec<Moved> = machine
        .free
        .iter()
        .zip(start)
        .zip(&found.p)
        .map(|((f, from), &to)| {
            let width = f.high - f.low;
            let at_bound = (to - f.low).min(f.high - to) <= 1e-9 * width;
            Moved { path: f.path.clone(), from, to, share: (to - from) / width, at_bound }
        })
        .collect();
    let impossible = (!found.reached).then(|| {
        let bounds: Vec<String> =
            moved.iter().zip(&found.slopes).filter(|(m, s)| m.at_bound && **s != 0.0).map(|(m, _)| m.path.clone()).collect();
        let value = text::quantity(found.value, found.unit.to_string());
        let names = bounds.join(", ");
        let sentence = match bounds.as_slice() {
            _ if found.slopes.iter().all(|s| *s == 0.0) => text!("the released parameters do not move this result"),
            [] => {
                text!("the search ended at {value}: beyond, this result does not exist or no longer follows the released parameters", value)
            }
            [_] => text!("{value} is the nearest that can be reached: {names} stands at its bound", value, names),
            _ => text!("{value} is the nearest that can be reached: {names} stand at their bounds", value, names),
        };
        (sentence, bounds)
    });
    Reached { from: found.from, to: found.value, reached: found.reached, moved, impossible, alone, curve, evaluations }
}
