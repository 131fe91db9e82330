//! The values of a parameter at which the balanced state becomes stable or unstable.

use super::classify::{Class, Scale, Seen};
use super::{Context, Varied, alone, changed, listed, spread};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::scalar::root;
use crate::solve::stationary::{Request, Search, State};

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
    /// It is one of a continuum.
    pub loose: bool,
    /// Value, largest growth rate; NaN where the state does not exist.
    pub growth: Vec<(f64, f64)>,
    /// Edges in order.
    pub edges: Vec<Edge>,
}

/// A state at a value of the parameter.
pub(super) struct Judged {
    pub growth: f64,
    pub stable: bool,
    frequency: f64,
    pub class: Class,
    free: usize,
    x: Vec<f64>,
}

/// The state near `x`, isolated or not, and how it grows.
pub(super) fn judge(system: &System, search: &mut Search, x: &[f64], speed: f64) -> Option<Judged> {
    let mut x = x.to_vec();
    let free = search.reach(&mut x, speed).ok()?;
    let stability = search.stability(&x, speed).ok()?.without(free);
    let scale = Scale::at(system, search, speed);
    let class = Seen::of(system, search, &State { branch: 0, speed, x: x.clone(), error: 0.0 }).class(&scale);
    let frequency = stability.values.first()?.0.im;
    Some(Judged { growth: stability.growth(), stable: stability.growing == 0, frequency, class, free, x })
}

/// The state that balances best at a speed: no displacement at all, else the own centre on the axis; of several the one that grows least.
fn best(
    system: &System,
    own: &Request,
    speed: f64,
    context: &Context,
    goes_on: &mut dyn FnMut(u64) -> bool,
) -> Result<Option<Judged>, Diagnostic> {
    let mut search = Search::new(system, own, context.cancel);
    let found = search.run(|p| !context.cancelled() && p.work < own.work)?;
    goes_on(found.work);
    let rows = listed(system, &mut search, &found, speed)?;
    let mut all: Vec<Judged> = Vec::new();
    for x in rows.into_iter().map(|r| r.state.x).chain(found.loose.into_iter().map(|l| l.x)) {
        all.extend(judge(system, &mut search, &x, speed).filter(|j| j.class.balances()));
    }
    Ok(all.into_iter().min_by(|a, b| a.class.cmp(&b.class).then(a.growth.total_cmp(&b.growth))))
}

/// Follows the balanced state over the parameter.
///
/// # Errors
/// Eigenvalues that cannot be computed; a machine that does not exist at a value.
pub fn least(
    system: &System,
    asked: &Varied,
    request: &Request,
    context: &Context,
    goes_on: &mut dyn FnMut(u64) -> bool,
) -> Result<Least, Diagnostic> {
    let values = spread(&asked.range, POINTS);
    let n = values.len();
    let own = alone(request, asked.speed);
    let mut out = Least { class: None, loose: false, growth: values.iter().map(|&v| (v, f64::NAN)).collect(), edges: Vec::new() };
    // the state is sought in the middle of the range and at its ends, and followed both ways
    let mut start: Option<(usize, Judged)> = None;
    for k in [n / 2, 0, n - 1] {
        if !goes_on(0) {
            return Ok(out);
        }
        if let Some(found) = best(&changed(system, &asked.path, values[k])?, &own, asked.speed, context, goes_on)? {
            start = Some((k, found));
            break;
        }
    }
    let Some((first, start)) = start else { return Ok(out) };
    (out.class, out.loose) = (Some(start.class), start.free > 0);
    let mut at = |value: f64, x: &[f64]| -> Option<Judged> {
        if !goes_on(1) {
            return None;
        }
        let system = changed(system, &asked.path, value).ok()?;
        let mut search = Search::new(&system, &own, context.cancel);
        judge(&system, &mut search, x, asked.speed).filter(|j| j.class.balances())
    };
    let mut states: Vec<Option<Judged>> = (0..n).map(|_| None).collect();
    for order in [(first..n).collect::<Vec<_>>(), (0..first).rev().collect()] {
        let mut x = start.x.clone();
        for k in order {
            let Some(found) = at(values[k], &x) else { break };
            out.growth[k].1 = found.growth;
            x.clone_from(&found.x);
            states[k] = Some(found);
        }
    }
    for w in 0..n - 1 {
        let (Some(a), Some(b)) = (&states[w], &states[w + 1]) else { continue };
        if a.stable == b.stable {
            continue;
        }
        let ends = [(values[w], a.growth), (values[w + 1], b.growth)];
        let Some(value) = root(|v| at(v, &a.x).map(|j| j.growth), ends[0], ends[1], 1e-13 * ends[1].0.abs()) else { continue };
        let frequency = at(value, &a.x).map_or(f64::NAN, |j| j.frequency);
        out.edges.push(Edge { value, gains: b.stable, frequency });
    }
    Ok(out)
}
