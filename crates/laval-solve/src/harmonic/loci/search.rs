//! Loci of bifurcations in the plane of spin speed and one parameter: starts from responses at some values of the parameter, then continuation.
//!
//! Every fold and every change of stability of these responses that no known locus passes through starts a new one. A locus that lies between the values and
//! meets none of them is not found.

pub use crate::harmonic::loci::locus::{Corner, Locus, LocusKind, LocusPoint};
use laval_model::text;
use serde::{Deserialize, Serialize};

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::problem::{Balance, Discretisation, Nonlinear};
use crate::harmonic::balance::terms::{Terms, admitted};
use crate::harmonic::balance::whole_period::whole_period;
use crate::harmonic::branches::bifurcation::{Event, frequency};
use crate::harmonic::branches::branch::{Assessor, Origin, Traced};
use crate::harmonic::branches::response::{self, MOST_HARMONICS, Response, States, carry, respond};
use crate::harmonic::loci::crossings::{CrossingLocus, angle, exponents, nearest, span};
use crate::harmonic::loci::existence::existence;
use crate::harmonic::loci::folds::FoldLocus;
use crate::harmonic::loci::follow::{Path, PathEnd, Turn, follow, passes, passes_after};
use crate::harmonic::loci::varied::{Varied, stopped};
use crate::harmonic::stability::floquet::{Exponents, Stability, Unassessed};
use crate::harmonic::stability::hill;
use crate::model::system::System;
use crate::symmetry::Symmetry;
use laval_num::complex::C64;
use laval_num::continuation::{End, Point, Settings, Zero, fold};
use laval_num::newton::{Options, newton};
use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

/// Loci followed at most.
pub const MOST_LOCI: usize = 24;
/// Times the orders are raised at most.
const RAISES: usize = 3;
/// Most unknowns to which orders are raised.
const MOST_UNKNOWNS: usize = 96;
/// Points of a locus of stability that are assessed again.
const ASSESSED_AGAIN: usize = 3;

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
struct Start {
    /// Index of its machine.
    machine: usize,
    value: f64,
    speed: f64,
    x: Vec<f64>,
    discretisation: Discretisation,
    kind: LocusKind,
}

/// All of them, and which are folds that belong together, by index.
#[derive(Default)]
struct Starts {
    all: Vec<Start>,
    pairs: Vec<[usize; 2]>,
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
    let mut search = Search { request, machines: &machines, cancel, tick, done };
    let automatic = request.harmonics.is_none() && symmetry != Symmetry::Circular;
    for raise in 0.. {
        search.all(&starts, &mut out)?;
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
    out.stopped |= stopped(cancel) || search.done >= request.work;
    out.work = vec![("points", search.done), ("points of responses", sampled)];
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

struct Search<'s> {
    request: &'s Request,
    machines: &'s [(f64, System)],
    cancel: &'s AtomicBool,
    tick: &'s (dyn Fn(u64) + Sync),
    done: u64,
}

impl<'s> Search<'s> {
    fn settings(&self, out: &Loci, kind: LocusKind) -> Settings {
        let (lo, hi) = out.exists;
        let left = usize::try_from(self.request.work.saturating_sub(self.done)).unwrap_or(usize::MAX);
        let mut s = Settings { max_points: self.request.max_points.min(left).max(1), ..Settings::new(lo, hi) };
        s.corrector.noise = 1e-13;
        match kind {
            LocusKind::Fold => s.corrector.step = 1e-10,
            // as well as maps over the period are integrated
            LocusKind::Change(_) => {
                s.max_parameter_step = (hi - lo) / 25.0;
                (s.corrector.step, s.corrector.residual, s.corrector.noise, s.corrector.loose_step) = (1e-7, 1e-7, 1e-7, 1e-5);
            }
        }
        s
    }

    /// All loci with the discretisation of `out`.
    fn all(&mut self, starts: &Starts, out: &mut Loci) -> Result<(), Diagnostic> {
        (out.loci, out.lost, out.more) = (Vec::new(), 0, false);
        let mut folds: Vec<(FoldLocus<'s>, Path, usize)> = Vec::new();
        let mut on: Vec<Option<(usize, usize)>> = vec![None; starts.all.len()];
        let mut changes: Vec<(CrossingLocus<'s>, Path, Event)> = Vec::new();
        for (start, on) in starts.all.iter().zip(&mut on) {
            if stopped(self.cancel) || self.done >= self.request.work {
                out.stopped = true;
                break;
            }
            if out.loci.len() >= MOST_LOCI {
                out.more = true;
                break;
            }
            let (speed, value) = (start.speed, start.value);
            let known = match start.kind {
                LocusKind::Fold => {
                    *on = folds.iter_mut().find_map(|(p, path, locus)| {
                        let at = 2 * p.size();
                        Some((*locus, passes_after(p, path, value, speed, at, 1e-6)?))
                    });
                    on.is_some()
                }
                LocusKind::Change(event) => changes.iter_mut().filter(|c| c.2 == event).any(|(p, path, _)| {
                    let at = p.size();
                    // a response places them where the growth rate equals its estimated error
                    passes(p, path, value, speed, at, 1e-4)
                }),
            };
            if known {
                continue;
            }
            let system = &self.machines[start.machine].1;
            let balance = Balance::new(system, out.discretisation, self.request.speeds, Some(self.cancel))?;
            let x = self.carried(start, system, &balance.terms);
            let varied = Varied::new(system, balance, &self.request.parameter, out.exists, self.request.speeds);
            let settings = self.settings(out, start.kind);
            let found = match start.kind {
                LocusKind::Fold => self.fold(FoldLocus { varied }, &x, start, &settings, out)?.map(|(p, path, locus)| {
                    *on = Some((out.loci.len(), path.start));
                    folds.push((p, path, out.loci.len()));
                    locus
                }),
                LocusKind::Change(event) => {
                    self.change(CrossingLocus { varied, real: None }, &x, start, &settings)?.map(|(p, path, locus)| {
                        changes.push((p, path, event));
                        locus
                    })
                }
            };
            match found {
                Some(locus) => {
                    out.stopped |= locus.ends.contains(&PathEnd::Cancelled);
                    out.loci.push(locus);
                }
                None => out.lost += 1,
            }
        }
        let pair = |&[a, b]: &[usize; 2]| {
            let speeds = [a, b].map(|k| starts.all[k].speed);
            Some(Pair { value: starts.all[a].value, speeds, on: [on[a]?, on[b]?] })
        };
        out.pairs = starts.pairs.iter().filter_map(pair).collect();
        Ok(())
    }

    /// The motion at a start in the terms of the loci.
    fn carried(&self, start: &Start, system: &System, to: &Terms) -> Vec<f64> {
        let d = start.discretisation;
        let from = Terms::new(&Nonlinear::of(system).kinds, d.symmetry, d.harmonics, d.divisor, d.samples);
        carry(&from, to, &start.x)
    }

    fn follow<P: Zero>(
        &mut self,
        problem: &mut P,
        y: &[f64],
        value: f64,
        speed: usize,
        settings: &Settings,
    ) -> Result<Option<Path>, Diagnostic> {
        let invalid = |e| Diagnostic::error("loci.settings", text!("the locus cannot be followed: {e}", e));
        let path = follow(problem, y, value, speed, self.request.speeds, settings).map_err(invalid)?;
        self.done += path.work;
        (self.tick)(self.done);
        // a start that is left at once leads nowhere
        let extends = |of: &dyn Fn(&Point) -> f64| {
            let (lo, hi) = path.points.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
            hi - lo > SPOT * hi.abs().max(lo.abs())
        };
        Ok((extends(&|p| p.p) || extends(&|p| p.x[speed])).then_some(path))
    }

    fn fold(
        &mut self,
        mut problem: FoldLocus<'s>,
        x: &[f64],
        start: &Start,
        settings: &Settings,
        out: &Loci,
    ) -> Result<Option<(FoldLocus<'s>, Path, Locus)>, Diagnostic> {
        let Ok(y) = problem.unknowns(x, start.speed, start.value) else { return Ok(None) };
        let n = problem.size();
        let Some(mut path) = self.follow(&mut problem, &y, start.value, 2 * n, settings)? else { return Ok(None) };
        path.points.iter_mut().for_each(|p| polish(&mut problem, p));
        let mut points = Vec::with_capacity(path.points.len());
        for p in &path.points {
            let (x, speed) = (&p.x[..n], p.x[2 * n]);
            let truncation = problem.varied.at(p.p, |b| {
                b.sample(x, speed);
                Ok(b.truncation())
            });
            let truncation = truncation.unwrap_or(f64::NAN);
            points.push(LocusPoint { speed, value: p.p, x: x.to_vec(), residual: p.residual, truncation, crossing: None });
        }
        let mut corners = Vec::new();
        for turn in &path.turns {
            let harmonics_change = self.finer(turn, &problem, start, out)?;
            corners.push(Corner { speed: turn.y[2 * n], x: turn.y[..n].to_vec(), turn: turn.clone(), harmonics_change });
        }
        let locus = Locus {
            kind: start.kind,
            points,
            corners,
            ends: path.ends.clone(),
            assessed_again: (0.0, 0),
            start: (start.speed, start.value),
        };
        Ok(Some((problem, path, locus)))
    }

    /// Change of speed and parameter of a turn of folds when four more orders are kept.
    fn finer(&self, turn: &Turn, coarse: &FoldLocus<'s>, start: &Start, out: &Loci) -> Result<[f64; 2], Diagnostic> {
        let d = out.discretisation;
        if d.symmetry == Symmetry::Circular {
            return Ok([0.0; 2]);
        }
        let more = Discretisation { harmonics: d.harmonics + 4, samples: d.samples.max(Terms::samples(d.harmonics + 4, 1)), ..d };
        let system = &self.machines[start.machine].1;
        let balance = Balance::new(system, more, self.request.speeds, Some(self.cancel))?;
        let mut finer = FoldLocus { varied: Varied::new(system, balance, &self.request.parameter, out.exists, self.request.speeds) };
        let (n, from) = (coarse.size(), coarse.varied.scales().to_vec());
        let to = finer.varied.scales().to_vec();
        let terms = [coarse.varied.terms(), finer.varied.terms()];
        let lift = |y: &[f64]| -> Vec<f64> {
            let own: Vec<f64> = y[n..2 * n].iter().zip(&from).map(|(v, s)| v * s).collect();
            let [x, v] = [&y[..n], &own[..]].map(|x| carry(terms[0], terms[1], x));
            x.into_iter().chain(v.iter().zip(&to).map(|(v, s)| v / s)).chain([y[2 * n]]).collect()
        };
        let (y, tangent) = (lift(&turn.y), lift(&turn.tangent));
        Ok(match fold(&mut finer, &y, turn.value, &tangent) {
            Ok(f) => [f.x[f.x.len() - 1] - turn.y[2 * n], f.p - turn.value],
            Err(_) => [f64::NAN; 2],
        })
    }

    fn change(
        &mut self,
        mut problem: CrossingLocus<'s>,
        x: &[f64],
        start: &Start,
        settings: &Settings,
    ) -> Result<Option<(CrossingLocus<'s>, Path, Locus)>, Diagnostic> {
        let n = problem.size();
        problem.real = match start.kind {
            LocusKind::Change(Event::NeimarkSacker) => None,
            _ => Some(PI),
        };
        // the angle as the maps of the locus see it
        let seen = problem.varied.at(start.value, |b| exponents(b, x, start.speed));
        let Ok(seen) = seen else { return Ok(None) };
        let crossing = |z: &&C64| {
            (z.im != 0.0 && problem.real.is_none()) || problem.real.is_some_and(|r| (angle(**z, &seen, start.speed) - r).abs() < 1e-3)
        };
        let Some(own) = seen.values.iter().filter(crossing).min_by(|a, b| a.re.abs().total_cmp(&b.re.abs())) else { return Ok(None) };
        let mut y: Vec<f64> = x.iter().copied().chain([start.speed]).collect();
        if problem.real.is_none() {
            y.push(angle(*own, &seen, start.speed));
        }
        let Some(path) = self.follow(&mut problem, &y, start.value, n, settings)? else { return Ok(None) };
        let mut assessor = Assessor::new(&self.machines[start.machine].1, (true, false), self.request.work);
        let mut points = Vec::with_capacity(path.points.len());
        let mut assessed_again = (0.0, 0);
        let every = path.points.len().div_ceil(ASSESSED_AGAIN);
        let mut ends = path.ends.clone();
        for (i, p) in path.points.iter().enumerate() {
            if stopped(self.cancel) {
                ends[1] = PathEnd::Cancelled;
                break;
            }
            let theta = problem.theta(&p.x);
            let Some((point, all, own)) = self.assessed(&mut problem, &mut assessor, p, theta) else { continue };
            if i % every == every / 2
                && let Some(difference) = by_hill(&mut problem, p, &all, own)
            {
                let worst: f64 = assessed_again.0;
                assessed_again = (if difference <= worst { worst } else { difference }, assessed_again.1 + 1);
            }
            points.push(point);
        }
        let corners =
            path.turns.iter().map(|t| Corner { speed: t.y[n], x: t.y[..n].to_vec(), turn: t.clone(), harmonics_change: [f64::NAN; 2] });
        let corners = corners.collect();
        let locus = Locus { kind: start.kind, points, corners, ends, assessed_again, start: (start.speed, start.value) };
        Ok(Some((problem, path, locus)))
    }

    fn assessed(
        &self,
        problem: &mut CrossingLocus<'s>,
        assessor: &mut Assessor,
        p: &Point,
        theta: f64,
    ) -> Option<(LocusPoint, Exponents, C64)> {
        let n = problem.size();
        let (x, speed) = (&p.x[..n], p.x[n]);
        let found = problem.varied.at(p.p, |b| {
            let all = exponents(b, x, speed)?;
            let truncation = b.truncation();
            // assessed by the machine of this value
            assessor.stability = Stability::new(b.system).ok();
            let own = nearest(&all, speed, theta).map(|i| all.values[i]);
            let frequency = own.map_or(f64::NAN, |z| frequency(assessor, b, z, &all, speed));
            Ok((all, truncation, own, frequency))
        });
        let (all, truncation, own, frequency) = found.ok()?;
        let own = own?;
        let meant = |z: &C64| {
            (z.re - own.re).abs() <= 1e-9 * own.abs().max(1.0)
                && ((z.im - own.im).abs() <= 1e-9 * own.abs() || (z.im + own.im).abs() <= 1e-9 * own.abs())
        };
        let growing = all.values.iter().filter(|z| !meant(z) && !(z.re <= all.error)).count();
        let point =
            LocusPoint { speed, value: p.p, x: x.to_vec(), residual: p.residual, truncation, crossing: Some((own.re, frequency, growing)) };
        Some((point, all, own))
    }
}

/// Relative distance from an end of the range of speeds that is rounding.
const EDGE: f64 = 1e-9;
/// Relative size of what is one place and no locus.
const SPOT: f64 = 1e-6;

/// The same point at its parameter to rounding, unless the locus turns back so near that it would leave.
fn polish<P: Zero>(problem: &mut P, p: &mut Point) {
    let mut y = p.x.clone();
    let Ok(done) = newton(problem, &mut y, p.p, &Options { to_rounding: true, ..Options::default() }) else { return };
    let mut scale = vec![1.0; y.len()];
    problem.scale(&mut scale);
    if p.x.iter().zip(&y).zip(&scale).all(|((a, b), s)| (a - b).abs() <= 1e-6 * s.max(a.abs())) {
        (p.x, p.residual) = (y, done.residual);
    }
}

/// Difference of the growth rate by Hill's method over the whole period, of the multiplier nearest to the one that crosses.
fn by_hill(problem: &mut CrossingLocus, p: &Point, all: &Exponents, own: C64) -> Option<f64> {
    let n = problem.size();
    let (x, speed) = (&p.x[..n], p.x[n]);
    let machine = problem.varied.machine(p.p).ok()?;
    let terms = problem.varied.terms();
    let d = Discretisation {
        harmonics: terms.harmonics,
        divisor: terms.divisor,
        samples: terms.samples * terms.symmetry.order().max(1),
        symmetry: terms.symmetry,
    };
    let (mut balance, x) = whole_period(&machine, d, x, speed).ok()?;
    balance.sample(&x, speed);
    let mut assessor = Stability::new(&machine).ok()?;
    let found = hill::exponents(&mut assessor, &mut balance, &x, speed).ok()?;
    let period = TAU / speed.abs();
    let parts = (period / span(all, speed)).round();
    let turned = C64::cis(own.im * span(all, speed) * parts).scale((own.re * period).exp());
    let multiplier = |z: &C64| C64::cis(z.im * period).scale((z.re * period).exp());
    let nearest = found.values.iter().min_by(|a, b| {
        let distance = |z: &C64| (multiplier(z) - turned).abs().min((multiplier(z).conj() - turned).abs());
        distance(a).total_cmp(&distance(b))
    })?;
    Some((nearest.re - own.re).abs())
}
