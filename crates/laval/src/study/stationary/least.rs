//! The values of a parameter at which the balanced state becomes stable or unstable.

use super::classify::Class;
use super::{Context, Row, Stabilise, listed};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::scalar::root;
use crate::solve::stationary::{Request, Search};

/// Values computed over the range before changes are located.
const POINTS: usize = 61;

/// An edge of stability.
pub struct Edge {
    /// Value of the parameter.
    pub value: f64,
    /// Stable above it.
    pub gains: bool,
    /// Frequency of the root that crosses, rad/s, in turning axes.
    pub frequency: f64,
}

/// What was found.
pub struct Least {
    /// Class of the state that was followed; `None` where there is no state that balances.
    pub class: Option<Class>,
    /// Value, largest growth rate; NaN where the state does not exist.
    pub growth: Vec<(f64, f64)>,
    /// Edges in order.
    pub edges: Vec<Edge>,
}

/// The state that balances best at a speed: no displacement at all, else the own centre on the axis.
fn best(rows: Vec<Row>) -> Option<Row> {
    rows.into_iter().filter(|r| r.class <= Class::PartlyBalanced).min_by(|a, b| a.class.cmp(&b.class))
}

/// Follows the balanced state over the parameter.
///
/// # Errors
/// Eigenvalues that cannot be computed; a machine that does not exist at a value.
pub fn least(system: &System, asked: &Stabilise, request: &Request, context: &Context) -> Result<Least, Diagnostic> {
    let (lo, hi) = (asked.range.from, asked.range.to);
    let n = asked.range.points.unwrap_or(POINTS).max(3);
    // wide ranges by ratios
    let spread = |k: usize| {
        let t = k as f64 / (n - 1) as f64;
        if lo > 0.0 && hi / lo > 30.0 { lo * (hi / lo).powf(t) } else { lo + t * (hi - lo) }
    };
    let mut values: Vec<f64> = (0..n).map(spread).collect();
    values[n - 1] = hi;
    // the state is sought in the middle of the range and followed both ways
    let width = 1e-3 * asked.speed.abs().max(1e-3);
    let own = Request { range: (asked.speed - width, asked.speed + width), seeds: vec![asked.speed], ..request.clone() };
    let machine = |value: f64| -> Result<System, Diagnostic> {
        system
            .with(&[(&asked.path, value)])
            .map_err(|d| d.0.into_iter().next().unwrap_or_else(|| Diagnostic::error("stationary.parameter", "no machine")))
    };
    let mut out = Least { class: None, growth: values.iter().map(|&v| (v, f64::NAN)).collect(), edges: Vec::new() };
    let mut start: Option<(usize, Vec<f64>)> = None;
    for k in [n / 2, 0, n - 1] {
        let system = machine(values[k])?;
        let mut search = Search::new(&system, &own, context.cancel);
        let found = search.run(|done| context.goes_on(done))?;
        if let Some(row) = best(listed(&system, &mut search, &found, asked.speed)?) {
            out.class = Some(row.class);
            start = Some((k, row.state.x));
            break;
        }
    }
    let Some((first, x0)) = start else { return Ok(out) };
    // largest growth, its frequency and the state, from a nearby state
    let judge = |value: f64, x: &[f64]| -> Option<(f64, f64, Vec<f64>)> {
        let system = machine(value).ok()?;
        let mut search = Search::new(&system, &own, context.cancel);
        let mut x = x.to_vec();
        search.settle(&mut x, asked.speed).ok()?;
        let s = search.stability(&x, asked.speed).ok()?;
        Some((s.growth(), s.values.first()?.0.im, x))
    };
    let mut states: Vec<Option<Vec<f64>>> = vec![None; n];
    for order in [(first..n).collect::<Vec<_>>(), (0..first).rev().collect()] {
        let mut x = x0.clone();
        for k in order {
            if context.cancelled() {
                return Ok(out);
            }
            let Some((growth, _, found)) = judge(values[k], &x) else { break };
            out.growth[k].1 = growth;
            x = found.clone();
            states[k] = Some(found);
        }
    }
    for k in 0..n - 1 {
        let ((a, fa), (b, fb)) = (out.growth[k], out.growth[k + 1]);
        let Some(x) = states[k].as_ref().filter(|_| fa * fb < 0.0) else { continue };
        let Some(value) = root(|v| judge(v, x).map(|j| j.0), (a, fa), (b, fb), 1e-13 * b.abs()) else { continue };
        let frequency = judge(value, x).map_or(f64::NAN, |j| j.1);
        out.edges.push(Edge { value, gains: fb < 0.0, frequency });
    }
    Ok(out)
}
