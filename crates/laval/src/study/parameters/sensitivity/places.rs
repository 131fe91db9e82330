//! The peaks and folds of a response, each with its derivatives.

use crate::diagnostic::Diagnostic;
use crate::model::system::{Body, System};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::branches::branch::{State, Traced};
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::peak::{Sense, refine};
use crate::solve::harmonic::branches::response::{Request, Response};
use crate::solve::harmonic::branches::sensitivity::{Moved, Named, Stationary, moved, parameters};
use crate::study::Context;
use laval_num::continuation::End;
use laval_num::work;
use std::f64::consts::TAU;

/// What a place is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Peak,
    JumpUp,
    JumpDown,
}

/// A peak or fold.
pub(super) struct Place {
    pub kind: Kind,
    /// Number of the branch, from 0.
    pub branch: usize,
    /// The body whose displacement it is told by.
    pub body: String,
    pub moved: Moved,
}

/// All that was found.
pub(super) struct Derivatives {
    pub places: Vec<Place>,
    pub parameters: Vec<Named>,
    /// Places whose derivatives could not be had: speed, rad/s, and why.
    pub without: Vec<(f64, String)>,
    pub complete: bool,
    pub harmonics: usize,
}

/// Peaks lower than this share of the highest are left out.
const LOWEST: f64 = 1e-6;

/// Largest displacements of the bodies at every point of a branch.
fn displacements(balance: &mut Balance, branch: &Traced, bodies: &[Body]) -> Vec<Vec<f64>> {
    let (system, turns) = (balance.system, branch.turns());
    let of = |state: &State, balance: &mut Balance| {
        let orbit = Orbit::of(balance, &state.x, state.speed).ok();
        let size = |b: &Body| orbit.as_ref().map_or(f64::NAN, |o| Measure::Displacement(b.x).largest(system, o, turns).0);
        bodies.iter().map(size).collect::<Vec<f64>>()
    };
    branch.points.iter().map(|p| of(p, balance)).collect()
}

/// Difference of two points in (x, speed).
fn along(a: &State, b: &State) -> Vec<f64> {
    a.x.iter().chain([&a.speed]).zip(b.x.iter().chain([&b.speed])).map(|(a, b)| b - a).collect()
}

/// A place before it is differentiated: kind, branch, body, unknowns, speed, direction of the branch, displacement.
type Seed = (Kind, usize, usize, Vec<f64>, f64, Vec<f64>, f64);

/// Peaks and folds of a branch; folds without derivatives go to `without`.
fn places_of(balance: &mut Balance, b: usize, branch: &Traced, speeds: (f64, f64), without: &mut Vec<(f64, String)>) -> Vec<Seed> {
    let (system, bodies, mut seeds) = (balance.system, balance.system.bodies(), Vec::new());
    let sizes = displacements(balance, branch, &bodies);
    for (k, body) in bodies.iter().enumerate() {
        for i in 1..sizes.len().saturating_sub(1) {
            let [before, a, after] = [i - 1, i, i + 1].map(|i| sizes[i][k]);
            if a > before && a >= after && !branch.points[i].unstable() {
                let Some(peak) = refine(balance, branch, i, Measure::Displacement(body.x), Sense::Largest, speeds) else {
                    continue;
                };
                let way = along(&branch.points[i - 1], &branch.points[i + 1]);
                seeds.push((Kind::Peak, b, k, peak.x, peak.speed, way, peak.value));
            }
        }
    }
    for f in &branch.folds {
        if f.corner || !f.confirmed {
            without.push((f.speed, "the branch turns at a corner, where a law switches".into()));
            continue;
        }
        let (Some(before), Some(after)) = (branch.points.get(f.after), branch.points.get(f.after + 1)) else { continue };
        let Ok(orbit) = Orbit::of(balance, &f.x, f.speed) else { continue };
        let size = |k: &usize| Measure::Displacement(bodies[*k].x).largest(system, &orbit, branch.turns()).0;
        let Some(k) = (0..bodies.len()).max_by(|a, b| size(a).total_cmp(&size(b))) else { continue };
        let kind = if f.upper { Kind::JumpUp } else { Kind::JumpDown };
        seeds.push((kind, b, k, f.x.clone(), f.speed, along(before, after), size(&k)));
    }
    seeds
}

/// Looks for them on all branches.
///
/// # Errors
/// As [`Balance::new`].
pub(super) fn find(system: &System, response: &Response, request: &Request, context: &Context) -> Result<Derivatives, Diagnostic> {
    let bodies = system.bodies();
    let d = response.discretisation.whole();
    let parameters = parameters(system, d.symmetry);
    let indices: Vec<_> = parameters.iter().map(|p| p.parameter).collect();
    let ended = response.branches.iter().all(|b| b.end != End::Cancelled);
    let mut found = Derivatives { places: vec![], parameters, without: vec![], complete: ended, harmonics: d.harmonics };
    let mut balance = Balance::new(system, d, request.speeds, None)?;
    let mut seeds = Vec::new();
    for (b, branch) in response.branches.iter().enumerate() {
        let own = work::piece(|| places_of(&mut balance, b, branch, request.speeds, &mut found.without));
        let Some(own) = own else {
            found.complete = false;
            break;
        };
        seeds.extend(own);
    }
    let highest = seeds.iter().map(|s| s.6).fold(0.0, f64::max);
    seeds.retain(|s| s.0 != Kind::Peak || s.6 > LOWEST * highest);
    let total = seeds.len() as u64;
    let period = TAU / d.symmetry.order().max(1) as f64;
    for (done, (kind, branch, k, x, speed, way, _)) in seeds.into_iter().enumerate() {
        if context.cancelled() {
            found.complete = false;
            break;
        }
        context.progress.report(done as u64, total);
        if let Some(part) = balance.switches(&x, speed, (0.0, period)).1 {
            found.without.push((speed, format!("the force of \"{part}\" jumps")));
            continue;
        }
        let measure = Measure::Displacement(bodies[k].x);
        let what = if kind == Kind::Peak { Stationary::Peak(measure) } else { Stationary::Fold };
        let Some(moved) = work::piece(|| moved(&mut balance, (&x, speed), &way, what, measure, &indices)) else {
            found.complete = false;
            break;
        };
        match moved {
            None => found.without.push((speed, "the derivatives did not settle".into())),
            Some(moved) => found.places.push(Place { kind, branch, body: bodies[k].name.clone(), moved }),
        }
    }
    // two branches may pass the same place
    let mut kept: Vec<Place> = Vec::new();
    for p in std::mem::take(&mut found.places) {
        let same = |q: &Place| {
            let (a, b) = (&p.moved, &q.moved);
            q.kind == p.kind
                && q.body == p.body
                && (a.speed - b.speed).abs() <= 1e-7 * a.speed.abs()
                && (a.value - b.value).abs() <= 1e-6 * a.value
        };
        if !kept.iter().any(same) {
            kept.push(p);
        }
    }
    kept.sort_by(|a, b| a.moved.speed.abs().total_cmp(&b.moved.speed.abs()));
    found.places = kept;
    Ok(found)
}
