//! The peaks and folds of a response, each with its derivatives.

use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::End;
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::branches::branch::{State, Traced};
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::peak::{Sense, refine};
use crate::solve::harmonic::branches::response::{Request, Response};
use crate::solve::harmonic::branches::sensitivity::{Moved, Named, Stationary, moved, parameters};
use crate::study::Context;
use crate::study::nonlinear::nonlinear_response::limited;
use crate::study::shared::probes;
use laval_num::order::SortByNumber;
use laval_num::work::{self, Here};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// What a place is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// A peak of a displacement or tilt.
    Peak,
    /// A fold from which a slow sweep jumps to a larger motion.
    JumpUp,
    /// A fold from which it jumps to a smaller one.
    JumpDown,
}

/// A peak or fold.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Place {
    /// What it is.
    pub kind: Kind,
    /// Number of the branch, from 0.
    pub branch: usize,
    /// Whose displacement or tilt it is.
    pub probe: Probe,
    /// Its derivatives.
    pub moved: Moved,
}

/// Why a place has no derivatives.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Without {
    /// The branch turns at a corner, where a force law switches.
    Corner,
    /// The force of this part jumps.
    Jump(String),
    /// The derivatives did not converge.
    Unconverged,
}

/// The peaks and folds of a response with their derivatives.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Derivatives {
    /// By speed.
    pub places: Vec<Place>,
    /// The parameters of the machine.
    pub parameters: Vec<Named>,
    /// Places without derivatives: speed, rad/s, and why.
    pub without: Vec<(f64, Without)>,
    /// Orders kept.
    pub harmonics: usize,
}

/// Peaks lower than this share of the largest motion are left out.
const LOWEST: f64 = 1e-6;

/// The probes that are measured, and how large their motion is.
struct Seen {
    /// In the order of all studies, and their indices among those of the machine.
    probes: Vec<Probe>,
    which: Vec<usize>,
    /// By branch, point and probe: largest value over a period.
    sizes: Vec<Vec<Vec<f64>>>,
}

/// Relative difference of speeds that are one.
const SAME_SPEED: f64 = 1e-7;

impl Seen {
    fn new(system: &System) -> Self {
        Seen { probes: probes::all(system), which: probes::ordered(system), sizes: Vec::new() }
    }

    /// Measures one more branch.
    fn measure(&mut self, balance: &mut Balance, branch: &Traced) {
        let (system, turns) = (balance.system, branch.turns());
        let of = |p: &State| probes::sizes(system, &self.which, &Orbit::of(balance, &p.x, p.speed).unwrap_or_default(), turns);
        self.sizes.push(branch.points.iter().map(of).collect());
    }

    fn all(&self) -> impl Iterator<Item = (&Probe, f64)> {
        self.sizes.iter().flatten().flat_map(|s| self.probes.iter().zip(s.iter().copied()))
    }
}

/// Difference of two points in (x, speed).
fn along(a: &State, b: &State) -> Vec<f64> {
    a.x.iter().chain([&a.speed]).zip(b.x.iter().chain([&b.speed])).map(|(a, b)| b - a).collect()
}

/// A place before it is differentiated.
struct Seed {
    kind: Kind,
    branch: usize,
    /// Index among the probes that are measured.
    probe: usize,
    x: Vec<f64>,
    speed: f64,
    /// Direction of the branch.
    way: Vec<f64>,
}

/// Peaks and folds of a branch; folds without derivatives go to `without`.
fn places_of(
    balance: &mut Balance,
    seen: &Seen,
    b: usize,
    branch: &Traced,
    speeds: (f64, f64),
    without: &mut Vec<(f64, Without)>,
) -> Vec<Seed> {
    let (system, mut seeds) = (balance.system, Vec::new());
    let (sizes, loud) = (&seen.sizes[b], probes::loudest(seen.all()));
    for (k, probe) in seen.probes.iter().enumerate() {
        for i in 1..sizes.len().saturating_sub(1) {
            let [before, a, after] = [i - 1, i, i + 1].map(|i| sizes[i][k]);
            if a > before && a >= after && !branch.points[i].unstable() && !probes::still(probe, a, loud, LOWEST) {
                let Some(peak) = refine(balance, branch, i, Measure::Probe(seen.which[k]), Sense::Largest, speeds) else {
                    continue;
                };
                let way = along(&branch.points[i - 1], &branch.points[i + 1]);
                seeds.push(Seed { kind: Kind::Peak, branch: b, probe: k, x: peak.x, speed: peak.speed, way });
            }
        }
    }
    let tilt = !probes::displaced(|| seen.all());
    for f in &branch.folds {
        if f.corner || !f.confirmed {
            without.push((f.speed, Without::Corner));
            continue;
        }
        let (Some(before), Some(after)) = (branch.points.get(f.after), branch.points.get(f.after + 1)) else { continue };
        let Ok(orbit) = Orbit::of(balance, &f.x, f.speed) else { continue };
        let at_fold = probes::sizes(system, &seen.which, &orbit, branch.turns());
        let Some((probe, _)) = probes::most(&seen.probes, &at_fold, tilt) else { continue };
        let kind = if f.upper { Kind::JumpUp } else { Kind::JumpDown };
        seeds.push(Seed { kind, branch: b, probe, x: f.x.clone(), speed: f.speed, way: along(before, after) });
    }
    seeds
}

/// Places differentiated together.
const TOGETHER: usize = 16;

/// A place that was differentiated, or why not.
enum Derived {
    Moved(Box<Moved>),
    Without(Without),
}

/// Looks for them on all branches, and how that ended.
///
/// # Errors
/// As [`Balance::new`].
pub(super) fn find(system: &System, response: &Response, request: &Request, context: &Context) -> Result<(Derivatives, End), Diagnostic> {
    let d = response.discretisation.whole();
    let parameters = parameters(system, d.symmetry);
    let indices: Vec<_> = parameters.iter().map(|p| p.parameter).collect();
    let ended = limited(response, request, context);
    let mut found = Derivatives { places: vec![], parameters, without: vec![], harmonics: d.harmonics };
    let mut complete = !matches!(ended, End::Cancelled | End::WorkLimit | End::MaxPoints);
    let mut balance = Balance::new(system, d, request.speeds, None)?;
    let (mut seen, mut seeds) = (Seen::new(system), Vec::new());
    // which motions are large is known only of all branches
    let measured = work::piece(|| response.branches.iter().for_each(|branch| seen.measure(&mut balance, branch)));
    complete &= measured.is_some();
    for (b, branch) in response.branches.iter().enumerate().filter(|_| measured.is_some()) {
        let own = work::piece(|| places_of(&mut balance, &seen, b, branch, request.speeds, &mut found.without));
        let Some(own) = own else {
            complete = false;
            break;
        };
        seeds.extend(own);
    }
    let total = seeds.len() as u64;
    let period = TAU / d.symmetry.order().max(1) as f64;
    let here = Here::now();
    let of_seed = |seed: &Seed| {
        let _counted = here.enter();
        if context.cancelled() {
            return None;
        }
        // each from a balance of its own, so that none rests on another
        let derivatives = || -> Result<Derived, Diagnostic> {
            let mut balance = Balance::new(system, d, request.speeds, None)?;
            if let Some(part) = balance.switches(&seed.x, seed.speed, (0.0, period)).1 {
                return Ok(Derived::Without(Without::Jump(part)));
            }
            let measure = Measure::Probe(seen.which[seed.probe]);
            let what = if seed.kind == Kind::Peak { Stationary::Peak(measure) } else { Stationary::Fold };
            let found = moved(&mut balance, (&seed.x, seed.speed), &seed.way, what, measure, &indices);
            Ok(found.map_or(Derived::Without(Without::Unconverged), |m| Derived::Moved(Box::new(m))))
        };
        work::piece(derivatives)
    };
    let mut done = 0;
    'all: for some in seeds.chunks(TOGETHER) {
        context.progress.report(done, total);
        let derived: Vec<_> = some.par_iter().map(of_seed).collect();
        for (seed, derived) in some.iter().zip(derived) {
            match derived.transpose()? {
                None => {
                    complete = false;
                    break 'all;
                }
                Some(Derived::Without(why)) => found.without.push((seed.speed, why)),
                Some(Derived::Moved(moved)) => {
                    let probe = seen.probes[seed.probe].clone();
                    found.places.push(Place { kind: seed.kind, branch: seed.branch, probe, moved: *moved });
                }
            }
        }
        done += some.len() as u64;
    }
    // two branches may pass the same place
    let mut kept: Vec<Place> = Vec::new();
    for p in std::mem::take(&mut found.places) {
        let same = |q: &Place| {
            let (a, b) = (&p.moved, &q.moved);
            q.kind == p.kind
                && q.probe == p.probe
                && (a.speed - b.speed).abs() <= SAME_SPEED * a.speed.abs()
                && (a.value - b.value).abs() <= 1e-6 * a.value
        };
        if !kept.iter().any(same) {
            kept.push(p);
        }
    }
    kept.sort_by_number(|a| a.moved.speed.abs());
    let all = probes::all(system);
    // of places at one speed the order is that of the probes: rounding does not decide it
    for run in kept.chunk_by_mut(|a, b| b.moved.speed.abs() - a.moved.speed.abs() <= SAME_SPEED * b.moved.speed.abs()) {
        run.sort_by_key(|p| all.iter().position(|probe| *probe == p.probe));
    }
    found.places = kept;
    let end = if ended == End::MaxPoints { ended } else { context.end(complete) };
    Ok((found, end))
}
