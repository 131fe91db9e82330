//! The values of a parameter at which the balanced state exists and is stable.

use super::classify::{Class, Scale, Seen};
use super::follow::{Follower, Limit, Reach, Why};
use super::{Context, Varied, alone, changed, listed, spread};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::stationary::{Request, Search, State};
use laval_num::order::SortByNumber;
use laval_num::univariate::root;
use serde::{Deserialize, Serialize};

/// Values computed over the range before changes are located.
const POINTS: usize = 61;
/// Share of a step inside a limit at which the state is computed too.
const INSIDE: f64 = 1e-3;
/// Halvings of the interval in which a state of a continuum is met no more.
const HALVINGS: usize = 40;

/// An edge of stability.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Edge {
    /// Value of the parameter.
    pub value: f64,
    /// Stable above it.
    pub gains: bool,
    /// Frequency of the root that crosses, rad/s, in turning axes.
    pub frequency: f64,
}

/// What was found.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Least {
    /// Class of the state that was followed; `None` where no state that balances was found.
    pub class: Option<Class>,
    /// It is one of a continuum.
    pub loose: bool,
    /// Value, largest growth rate; NaN where the state was not followed to.
    pub growth: Vec<(f64, f64)>,
    /// Edges in order.
    pub edges: Vec<Edge>,
    /// Where the state is followed no farther down and up; `None` where it goes on to the end of the range.
    pub limits: [Option<Limit>; 2],
    /// Values at which it is stable: from and to.
    pub stable: Vec<(f64, f64)>,
    /// Values at which states were sought from many starts.
    pub sought: usize,
}

/// A state at a value of the parameter.
pub(super) struct Assessed {
    pub growth: f64,
    pub stable: bool,
    pub frequency: f64,
    pub class: Class,
    free: usize,
    x: Vec<f64>,
}

/// The state near `x`, isolated or not, and how it grows.
pub(super) fn assess(system: &System, search: &mut Search, x: &[f64], speed: f64) -> Option<Assessed> {
    let mut x = x.to_vec();
    let free = search.reach(&mut x, speed).ok()?;
    let stability = search.stability(&x, speed).ok()?.without(free);
    let scale = Scale::at(system, search, speed);
    let class = Seen::of(system, search, &State { branch: 0, speed, x: x.clone(), error: 0.0 }).class(&scale);
    let frequency = stability.values.first()?.0.im;
    Some(Assessed { growth: stability.growth(), stable: stability.growing == 0, frequency, class, free, x })
}

/// The state that balances best at a speed: no displacement at all, else the own centre on the axis; of several the one that grows least.
fn best(
    system: &System,
    own: &Request,
    speed: f64,
    context: &Context,
    goes_on: &mut dyn FnMut(u64) -> bool,
) -> Result<Option<Assessed>, Diagnostic> {
    let mut search = Search::new(system, own, context.cancel);
    let found = search.run(|p| !context.cancelled() && p.work < own.work)?;
    goes_on(found.work);
    let rows = listed(system, &mut search, &found, speed)?;
    let mut all: Vec<Assessed> = Vec::new();
    for x in rows.into_iter().map(|r| r.state.x).chain(found.loose.into_iter().map(|l| l.x)) {
        all.extend(assess(system, &mut search, &x, speed).filter(|j| j.class.balances()));
    }
    Ok(all.into_iter().min_by(|a, b| a.class.cmp(&b.class).then(a.growth.total_cmp(&b.growth))))
}

/// A state that balances, followed over the values: isolated, or one of a continuum.
#[allow(clippy::large_enum_variant)] // there is one
enum Followed<'a> {
    Alone(Box<Follower<'a>>, [Reach; 2], f64),
    Loose(Vec<f64>),
}

/// Follows the balanced state over the parameter.
///
/// # Errors
/// Eigenvalues that cannot be computed; a machine that does not exist at a value.
pub fn least(
    system: &System,
    requested: &Varied,
    request: &Request,
    context: &Context,
    goes_on: &mut dyn FnMut(u64) -> bool,
) -> Result<Least, Diagnostic> {
    let values = spread(&requested.range, POINTS);
    let n = values.len();
    let own = alone(request, requested.speed);
    let mut out = Least {
        class: None,
        loose: false,
        growth: values.iter().map(|&v| (v, f64::NAN)).collect(),
        edges: Vec::new(),
        limits: [None, None],
        stable: Vec::new(),
        sought: 0,
    };
    // the state is sought in the middle of the range, at its ends and between, and followed both ways
    let mut start: Option<(usize, Assessed)> = None;
    for k in [n / 2, n - 1, 0, 3 * n / 4, n / 4] {
        if !goes_on(0) {
            return Ok(out);
        }
        out.sought += 1;
        if let Some(found) = best(&changed(system, &requested.path, values[k])?, &own, requested.speed, context, goes_on)? {
            start = Some((k, found));
            break;
        }
    }
    let Some((first, start)) = start else { return Ok(out) };
    (out.class, out.loose) = (Some(start.class), start.free > 0);
    let mut followed = if out.loose {
        Followed::Loose(start.x.clone())
    } else {
        let mut follower = Follower::new(system, requested, request, context.cancel)?;
        let reaches = [false, true].map(|up| follower.reach(&start.x, values[first], up));
        out.limits = [reaches[0].limit, reaches[1].limit];
        Followed::Alone(Box::new(follower), reaches, values[first])
    };
    let loosely = |value: f64, x: &[f64]| -> Option<Assessed> {
        let system = changed(system, &requested.path, value).ok()?;
        let mut search = Search::new(&system, &own, context.cancel);
        assess(&system, &mut search, x, requested.speed).filter(|j| j.class.balances() && j.free > 0)
    };
    // values of the table, and others just inside the limits
    let mut places: Vec<(f64, Option<usize>)> = values.iter().copied().enumerate().map(|(k, v)| (v, Some(k))).collect();
    let inside = |limit: &Limit, up: bool| {
        let next = |v: &&f64| if up { **v < limit.value } else { **v > limit.value };
        let near = if up { values.iter().rev().find(next) } else { values.iter().find(next) };
        near.map(|v| (limit.value + INSIDE * (v - limit.value), None))
    };
    for (k, limit) in out.limits.iter().enumerate() {
        places.extend(limit.iter().filter_map(|l| inside(l, k == 1)));
    }
    places.sort_by_number(|a| a.0);
    let mut states: Vec<Option<Assessed>> = (0..places.len()).map(|_| None).collect();
    match &mut followed {
        Followed::Alone(follower, [down, up], from) => {
            let (low, high) = (down.limit.map_or(f64::NEG_INFINITY, |l| l.value), up.limit.map_or(f64::INFINITY, |l| l.value));
            for (state, &(value, _)) in states.iter_mut().zip(&places) {
                if !goes_on(1) {
                    break;
                }
                if value > low && value < high {
                    *state = follower.at(if value < *from { down } else { up }, value);
                }
            }
        }
        Followed::Loose(x) => {
            for (up, order) in [(true, (first..n).collect::<Vec<_>>()), (false, (0..first).rev().collect())] {
                let mut x = x.clone();
                let mut last = values[first];
                for k in order {
                    let found = if goes_on(1) { loosely(values[k], &x) } else { return Ok(out) };
                    let Some(found) = found else {
                        let (mut yes, mut no) = (last, values[k]);
                        for _ in 0..HALVINGS {
                            let middle = 0.5 * (yes + no);
                            match if goes_on(1) { loosely(middle, &x) } else { None } {
                                Some(j) => (yes, x) = (middle, j.x),
                                None => no = middle,
                            }
                        }
                        let bracket = (yes.min(no), yes.max(no));
                        out.limits[usize::from(up)] = Some(Limit { value: yes, why: Why::Lost, bracket, located: false });
                        break;
                    };
                    x.clone_from(&found.x);
                    (states[k], last) = (Some(found), values[k]);
                }
            }
        }
    }
    for (state, place) in states.iter().zip(&places) {
        if let (Some(s), Some(k)) = (state, place.1) {
            out.growth[k].1 = s.growth;
        }
    }
    for w in 0..places.len().saturating_sub(1) {
        let (Some(a), Some(b)) = (&states[w], &states[w + 1]) else { continue };
        if a.stable == b.stable || !goes_on(1) {
            continue;
        }
        let ends = [(places[w].0, a.growth), (places[w + 1].0, b.growth)];
        let change = match &mut followed {
            Followed::Alone(follower, [down, up], from) => follower.change(if places[w].0 < *from { down } else { up }, ends),
            Followed::Loose(_) => {
                let at = |v: f64| loosely(v, &a.x);
                root(|v| at(v).map(|j| j.growth), ends[0], ends[1], 1e-13 * ends[1].0.abs())
                    .map(|v| (v, at(v).map_or(f64::NAN, |j| j.frequency)))
            }
        };
        // not located: the middle of where it lies
        let (value, frequency) = change.unwrap_or((0.5 * (ends[0].0 + ends[1].0), f64::NAN));
        out.edges.push(Edge { value, gains: b.stable, frequency });
    }
    out.stable = stretches(&places, &states, &out);
    Ok(out)
}

/// Values at which the state is stable: from a limit, an edge or the first value to the next.
fn stretches(places: &[(f64, Option<usize>)], states: &[Option<Assessed>], found: &Least) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = Vec::new();
    let edge = |a: f64, b: f64| found.edges.iter().map(|e| e.value).find(|v| (a..=b).contains(v));
    let mut from: Option<f64> = None;
    for (k, (place, state)) in places.iter().zip(states).enumerate() {
        let stable = state.as_ref().is_some_and(|s| s.stable);
        let before = k.checked_sub(1).filter(|&j| states[j].is_some()).map(|j| places[j].0);
        if stable && from.is_none() {
            let lowest = found.limits[0].map_or(place.0, |l| l.value);
            from = Some(before.map_or(lowest, |b| edge(b, place.0).unwrap_or(place.0)));
        }
        let next = states.get(k + 1).and_then(|s| s.as_ref());
        if let Some(begin) = from.filter(|_| stable && !next.is_some_and(|s| s.stable)) {
            let to = match next {
                Some(_) => edge(place.0, places[k + 1].0).unwrap_or(place.0),
                None => found.limits[1].map_or(place.0, |l| l.value),
            };
            out.push((begin, to));
            from = None;
        }
    }
    out
}
