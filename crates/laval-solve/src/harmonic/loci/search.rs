//! Loci of bifurcations in the plane of spin speed and one parameter: starts from responses at some values of the parameter, then continuation.
//!
//! Every fold and every change of stability of these responses that no known locus passes through starts a new one. A locus that lies between the values and
//! meets none of them is not found.

pub use crate::harmonic::loci::locus::{Corner, Locus, LocusKind, LocusPoint};
use serde::{Deserialize, Serialize};

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::problem::{Discretisation, Nonlinear};
use crate::harmonic::balance::terms::{Terms, admitted};
use crate::harmonic::branches::bifurcation::Event;
use crate::harmonic::branches::branch::{Origin, Traced};
use crate::harmonic::branches::response::{self, MOST_HARMONICS, Response, States, respond};
use crate::harmonic::loci::chain::{Search, follow_all};
use crate::harmonic::loci::existence::existence;
use crate::harmonic::loci::varied::stopped;
use crate::harmonic::stability::floquet::Unassessed;
use crate::model::system::System;
use crate::symmetry::Symmetry;
use laval_num::continuation::End;
use std::sync::atomic::AtomicBool;

/// Loci followed at most.
pub const MOST_LOCI: usize = 24;
/// Times the orders are raised at most.
const RAISES: usize = 3;
/// Most unknowns to which orders are raised.
const MOST_UNKNOWNS: usize = 96;
/// Relative distance from an end of the range of speeds that is rounding.
const EDGE: f64 = 1e-9;

/// The request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// Range of the spin speed, rad/s.
    pub speeds: (f64, f64),
    /// Path of the parameter.
    pub parameter: String,
    /// Its range.
    pub range: (f64, f64),
    /// Values at which the response is computed to find starts, ascending.
    pub values: Vec<f64>,
    /// Follow folds.
    pub folds: bool,
    /// Follow changes of stability.
    pub stability: bool,
    /// Largest order; `None` chooses.
    pub harmonics: Option<usize>,
    /// Dropped force harmonics over kept ones that the automatic choice accepts.
    pub truncation: f64,
    /// Most points of a locus.
    pub max_points: usize,
    /// Most points in all.
    pub work: u64,
}

impl Request {
    /// Folds and changes of stability over a range of speeds (rad/s) and of a parameter; values at which responses are computed are to be added.
    pub fn over(speeds: (f64, f64), parameter: &str, range: (f64, f64)) -> Self {
        Request {
            speeds,
            parameter: parameter.into(),
            range,
            values: Vec::new(),
            folds: true,
            stability: true,
            harmonics: None,
            truncation: 1e-7,
            max_points: 2_000,
            work: u64::MAX,
        }
    }
}

/// A response that was computed to find starts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    /// The parameter.
    pub value: f64,
    /// Folds found.
    pub folds: usize,
    /// Other changes of the stability of states that can be held.
    pub changes: usize,
}

/// Two folds of one response that belong together: between them its branch runs back.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// The parameter.
    pub value: f64,
    /// Speeds in order along the branch, rad/s.
    pub speeds: [f64; 2],
    /// Of each, the index of its locus and that of the point after which it lies on it.
    pub on: [(usize, usize); 2],
}

/// What was found.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Loci {
    /// The loci.
    pub loci: Vec<Locus>,
    /// Of their motions.
    pub discretisation: Discretisation,
    /// Folds of the sampled responses that belong together, where both were followed.
    pub pairs: Vec<Pair>,
    /// Where starts were sought.
    pub samples: Vec<Sample>,
    /// Values of the parameter at which the machine exists, within the range requested.
    pub exists: (f64, f64),
    /// Why it does not exist beyond, where that is within the range.
    pub refused: [Option<String>; 2],
    /// Values of the parameter at which no response was found, and why.
    pub failed: Vec<(f64, String)>,
    /// Folds at corners of a law, which are not followed.
    pub corners: usize,
    /// Bifurcations from which no locus could be followed.
    pub lost: usize,
    /// There are more loci than are followed.
    pub more: bool,
    /// Changes of the stability of states that do not bound stability were found and not followed.
    pub others: usize,
    /// Why stability was not assessed.
    pub unassessed: Option<Unassessed>,
    /// Stopped before everything was followed.
    pub stopped: bool,
    /// Work: name and count.
    #[serde(deserialize_with = "laval_num::text::counts")]
    pub work: Vec<(laval_num::text::Text, u64)>,
}

/// A bifurcation from which a locus may be followed.
pub(super) struct Start {
    /// Index of its machine.
    pub machine: usize,
    pub value: f64,
    pub speed: f64,
    pub x: Vec<f64>,
    pub discretisation: Discretisation,
    pub kind: LocusKind,
}

/// All of them, and which are folds that belong together, by index.
#[derive(Default)]
pub(super) struct Starts {
    pub all: Vec<Start>,
    pub pairs: Vec<[usize; 2]>,
}

/// Follows the loci of a machine.
///
/// # Errors
/// A machine without a response, or that exists at no value of the parameter.
pub fn loci(system: &System, request: &Request, cancel: &AtomicBool, tick: &(dyn Fn(u64) + Sync)) -> Result<Loci, Diagnostic> {
    loci_from(system, request, &[], cancel, tick)
}

/// The same where responses at some of the values are known: there none is computed. Of theirs the branches from the ends of the range of speeds count.
///
/// # Errors
/// As [`loci`].
pub fn loci_from(
    system: &System,
    request: &Request,
    known: &[(f64, Response)],
    cancel: &AtomicBool,
    tick: &(dyn Fn(u64) + Sync),
) -> Result<Loci, Diagnostic> {
    let (exists, refused) = existence(system, request)?;
    let path = request.parameter.as_str();
    let mut machines = Vec::new();
    for &value in &request.values {
        if let Ok(machine) = system.with(&[(path, value)]) {
            machines.push((value, machine));
        }
    }
    // one set of terms for all: what every machine is symmetric by
    let requested = |symmetry| response::Request {
        harmonics: request.harmonics,
        truncation: request.truncation,
        symmetry,
        stability: request.stability,
        states: States::Main,
        ..response::Request::over(request.speeds.0, request.speeds.1)
    };
    let mut symmetry = Symmetry::Circular;
    for (_, machine) in &machines {
        symmetry = symmetry.min(response::symmetry(machine, &requested(None))?.0);
    }
    let mut out = Loci {
        loci: Vec::new(),
        discretisation: Discretisation { harmonics: 1, divisor: 1, samples: 32, symmetry },
        pairs: Vec::new(),
        samples: Vec::new(),
        exists,
        refused,
        failed: Vec::new(),
        corners: 0,
        lost: 0,
        more: false,
        others: 0,
        unassessed: None,
        stopped: false,
        work: Vec::new(),
    };
    let mut done = 0u64;
    let mut starts = Starts::default();
    let mut failed = None;
    for (k, (value, machine)) in machines.iter().enumerate() {
        if stopped(cancel) || done >= request.work {
            out.stopped = true;
            break;
        }
        let left = usize::try_from((request.work - done) / 2).unwrap_or(usize::MAX);
        let max_points = request.max_points.min(left).max(2);
        if let Some((_, found)) = known.iter().find(|k| k.0 == *value) {
            collect(found, request, k, *value, &mut out, &mut starts);
            continue;
        }
        let found =
            respond(machine, &response::Request { max_points, ..requested(Some(symmetry)) }, cancel, &|step| tick(done + step.done));
        let found = match found {
            Ok(found) => found,
            // a search that was stopped says nothing of the machine
            Err(_) if stopped(cancel) => {
                out.stopped = true;
                break;
            }
            Err(d) => {
                out.failed.push((*value, d.message.to_string()));
                failed = Some(d);
                continue;
            }
        };
        done += found.branches.iter().map(|b| b.points.len() as u64).sum::<u64>();
        // points that the work did not admit are not those of the request
        out.stopped |= max_points < request.max_points && found.branches.iter().any(|b| b.end == End::MaxPoints);
        collect(&found, request, k, *value, &mut out, &mut starts);
    }
    if let (true, Some(d)) = (out.samples.is_empty(), failed) {
        return Err(d);
    }
    let sampled = done;
    let automatic = request.harmonics.is_none() && symmetry != Symmetry::Circular;
    for raise in 0.. {
        done += follow_all(Search { request, machines: &machines, cancel, tick, before: done }, &starts, &mut out)?;
        let worst = out.loci.iter().flat_map(|l| &l.points).fold(0.0, |m: f64, p| if p.truncation <= m { m } else { p.truncation });
        let harmonics = out.discretisation.harmonics + 4;
        let coordinates = Nonlinear::of(system).kinds.len();
        let affordable = harmonics <= MOST_HARMONICS && admitted(symmetry, harmonics, 1).0.len() * coordinates <= MOST_UNKNOWNS;
        if !automatic || worst <= request.truncation || worst.is_nan() || raise >= RAISES || !affordable || out.stopped {
            break;
        }
        out.discretisation.harmonics = harmonics;
        out.discretisation.samples = out.discretisation.samples.max(Terms::samples(harmonics, 1));
    }
    out.stopped |= stopped(cancel) || done >= request.work;
    out.work = vec![("points", done), ("points of responses", sampled)];
    Ok(out)
}

/// Bifurcations of a response from which loci may start.
fn collect(found: &Response, request: &Request, machine: usize, value: f64, out: &mut Loci, starts: &mut Starts) {
    let mut sample = Sample { value, folds: 0, changes: 0 };
    let d = &mut out.discretisation;
    d.harmonics = d.harmonics.max(found.discretisation.harmonics);
    d.samples = d.samples.max(found.discretisation.samples);
    let (lo, hi) = request.speeds;
    let inside = |speed: f64| speed >= lo - EDGE * lo.abs() && speed <= hi + EDGE * hi.abs();
    let main = |b: &&Traced| matches!(b.origin, Origin::Low | Origin::High) && b.discretisation.divisor == 1;
    if out.unassessed.is_none() {
        out.unassessed.clone_from(&found.unassessed);
    }
    for branch in found.branches.iter().filter(main) {
        let start =
            |speed: f64, x: &[f64], kind| Start { machine, value, speed, x: x.to_vec(), discretisation: branch.discretisation, kind };
        // at a corner of a law the equations have no second derivative: the fold moves, but not by these equations
        let mut own = Vec::new();
        for f in &branch.folds {
            sample.folds += 1;
            out.corners += usize::from(f.corner);
            let followed = request.folds && !f.corner && inside(f.speed);
            own.push(followed.then_some(starts.all.len()));
            if followed {
                starts.all.push(start(f.speed, &f.x, LocusKind::Fold));
            }
        }
        // the branch runs back between its first fold and its second, its third and its fourth
        starts.pairs.extend(own.chunks_exact(2).filter_map(|p| Some([p[0]?, p[1]?])));
        for c in &branch.changes {
            let bounds = c.unstable.0 == 0 || c.unstable.1 == 0;
            let followed = c.event != Event::BranchPoint;
            sample.changes += usize::from(bounds);
            if bounds && followed && request.stability && inside(c.speed) {
                starts.all.push(start(c.speed, &c.point.x, LocusKind::Change(c.event)));
            } else {
                out.others += 1;
            }
        }
    }
    out.samples.push(sample);
}
