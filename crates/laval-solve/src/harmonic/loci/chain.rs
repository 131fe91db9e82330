//! Loci followed from their starts, those of folds and those of changes of stability side by side.

use super::crossings::{CrossingLocus, angle, exponents, nearest, span};
use super::folds::FoldLocus;
use super::follow::{Path, PathEnd, Turn, follow, passes, passes_after};
use super::locus::{Corner, Locus, LocusKind, LocusPoint};
use super::search::{Loci, MOST_LOCI, Pair, Request, Start, Starts};
use super::varied::{Varied, stopped};
use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::problem::{Balance, Discretisation, Nonlinear};
use crate::harmonic::balance::terms::Terms;
use crate::harmonic::balance::whole_period::whole_period;
use crate::harmonic::branches::bifurcation::{Event, frequency};
use crate::harmonic::branches::branch::Assessor;
use crate::harmonic::branches::response::carry;
use crate::harmonic::stability::floquet::{Exponents, Stability};
use crate::harmonic::stability::hill;
use crate::model::system::System;
use crate::symmetry::Symmetry;
use laval_model::text;
use laval_num::complex::C64;
use laval_num::continuation::{Point, Settings, Zero, fold};
use laval_num::newton::{Options, newton};
use laval_num::work::Here;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// Points of a locus of stability that are assessed again.
const ASSESSED_AGAIN: usize = 3;

/// Loci of one kind.
#[derive(Default)]
struct Chain {
    /// With the index of the start that each began from.
    loci: Vec<(usize, Locus)>,
    /// Starts that lie on a fold locus: their index, that of the locus here and that of the point after which they lie on it.
    on: Vec<(usize, usize, usize)>,
    /// Starts from which none could be followed.
    lost: usize,
    /// There are starts beyond the most loci.
    more: bool,
    stopped: bool,
    /// Points.
    done: u64,
}

/// What loci are followed with.
#[derive(Clone, Copy)]
pub(super) struct Search<'s> {
    pub request: &'s Request,
    pub machines: &'s [(f64, System)],
    pub cancel: &'s AtomicBool,
    /// Called with the number of points so far.
    pub tick: &'s (dyn Fn(u64) + Sync),
    /// Points before these loci.
    pub before: u64,
}

/// All loci with the discretisation of `out`: those of folds and those of changes of stability at once, as they do not depend on each other. Returns the number of points.
///
/// # Errors
/// A machine without a balance.
pub(super) fn follow_all(search: Search, starts: &Starts, out: &mut Loci) -> Result<u64, Diagnostic> {
    let (total, work) = (AtomicU64::new(0), search.request.work.saturating_sub(search.before));
    let kinds = [true, false].map(|folds| starts.all.iter().any(|s| (s.kind == LocusKind::Fold) == folds));
    // a limit is shared equally, so that what is found does not depend on which is faster
    let share = if kinds == [true, true] { work.div_ceil(2) } else { work };
    let here = Here::now();
    let of_kind = |folds: bool| {
        let _counted = here.enter();
        Following { search, out: &*out, work: share, done: 0, total: &total }.all(&starts.all, folds)
    };
    let (folds, changes) = rayon::join(|| of_kind(true), || of_kind(false));
    let (folds, changes) = (folds?, changes?);
    let done = folds.done + changes.done;
    let mut on: Vec<Option<(usize, usize)>> = vec![None; starts.all.len()];
    // in the order of their starts
    let mut loci: Vec<(usize, Locus, Option<usize>)> = Vec::new();
    loci.extend(folds.loci.into_iter().enumerate().map(|(own, (k, locus))| (k, locus, Some(own))));
    loci.extend(changes.loci.into_iter().map(|(k, locus)| (k, locus, None)));
    loci.sort_by_key(|l| l.0);
    out.more = folds.more || changes.more || loci.len() > MOST_LOCI;
    loci.truncate(MOST_LOCI);
    for (k, own, point) in folds.on {
        on[k] = loci.iter().position(|l| l.2 == Some(own)).map(|locus| (locus, point));
    }
    let pair = |&[a, b]: &[usize; 2]| {
        let speeds = [a, b].map(|k| starts.all[k].speed);
        Some(Pair { value: starts.all[a].value, speeds, on: [on[a]?, on[b]?] })
    };
    out.pairs = starts.pairs.iter().filter_map(pair).collect();
    out.lost = folds.lost + changes.lost;
    out.stopped |= folds.stopped || changes.stopped;
    out.loci = loci.into_iter().map(|l| l.1).collect();
    Ok(done)
}

/// On the way along the loci of one kind.
struct Following<'s> {
    search: Search<'s>,
    out: &'s Loci,
    /// Most points.
    work: u64,
    done: u64,
    /// Points of both kinds.
    total: &'s AtomicU64,
}

impl<'s> Following<'s> {
    fn settings(&self, kind: LocusKind) -> Settings {
        let (lo, hi) = self.out.exists;
        let left = usize::try_from(self.work.saturating_sub(self.done)).unwrap_or(usize::MAX);
        let mut s = Settings { max_points: self.search.request.max_points.min(left).max(1), ..Settings::new(lo, hi) };
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

    /// Loci of folds, or of changes of stability, one start after the other: a start that a locus passes through begins none.
    fn all(mut self, starts: &[Start], folds: bool) -> Result<Chain, Diagnostic> {
        let mut chain = Chain::default();
        let mut of_folds: Vec<(FoldLocus<'s>, Path)> = Vec::new();
        let mut of_changes: Vec<(CrossingLocus<'s>, Path, Event)> = Vec::new();
        for (k, start) in starts.iter().enumerate().filter(|s| (s.1.kind == LocusKind::Fold) == folds) {
            if stopped(self.search.cancel) || self.done >= self.work {
                chain.stopped = true;
                break;
            }
            if chain.loci.len() >= MOST_LOCI {
                chain.more = true;
                break;
            }
            let (speed, value) = (start.speed, start.value);
            let known = match start.kind {
                LocusKind::Fold => {
                    let on = of_folds.iter_mut().enumerate().find_map(|(locus, (p, path))| {
                        let at = 2 * p.size();
                        Some((locus, passes_after(p, path, value, speed, at, 1e-6)?))
                    });
                    chain.on.extend(on.map(|(locus, point)| (k, locus, point)));
                    on.is_some()
                }
                LocusKind::Change(event) => of_changes.iter_mut().filter(|c| c.2 == event).any(|(p, path, _)| {
                    let at = p.size();
                    // a response places them where the growth rate equals its estimated error
                    passes(p, path, value, speed, at, 1e-4)
                }),
            };
            if known {
                continue;
            }
            let system = &self.search.machines[start.machine].1;
            let balance = Balance::new(system, self.out.discretisation, self.search.request.speeds, Some(self.search.cancel))?;
            let x = self.carried(start, system, &balance.terms);
            let varied = Varied::new(system, balance, &self.search.request.parameter, self.out.exists, self.search.request.speeds);
            let settings = self.settings(start.kind);
            let found = match start.kind {
                LocusKind::Fold => self.fold(FoldLocus { varied }, &x, start, &settings)?.map(|(p, path, locus)| {
                    chain.on.push((k, chain.loci.len(), path.start));
                    of_folds.push((p, path));
                    locus
                }),
                LocusKind::Change(event) => {
                    self.change(CrossingLocus { varied, real: None }, &x, start, &settings)?.map(|(p, path, locus)| {
                        of_changes.push((p, path, event));
                        locus
                    })
                }
            };
            match found {
                Some(locus) => {
                    chain.stopped |= locus.ends.contains(&PathEnd::Cancelled);
                    chain.loci.push((k, locus));
                }
                None => chain.lost += 1,
            }
        }
        chain.done = self.done;
        chain.stopped |= self.done >= self.work;
        Ok(chain)
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
        let path = follow(problem, y, value, speed, self.search.request.speeds, settings).map_err(invalid)?;
        self.done += path.work;
        let of_both = self.total.fetch_add(path.work, Relaxed) + path.work;
        (self.search.tick)(self.search.before + of_both);
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
            let harmonics_change = self.finer(turn, &problem, start)?;
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
    fn finer(&self, turn: &Turn, coarse: &FoldLocus<'s>, start: &Start) -> Result<[f64; 2], Diagnostic> {
        let d = self.out.discretisation;
        if d.symmetry == Symmetry::Circular {
            return Ok([0.0; 2]);
        }
        let more = Discretisation { harmonics: d.harmonics + 4, samples: d.samples.max(Terms::samples(d.harmonics + 4, 1)), ..d };
        let system = &self.search.machines[start.machine].1;
        let balance = Balance::new(system, more, self.search.request.speeds, Some(self.search.cancel))?;
        let mut finer =
            FoldLocus { varied: Varied::new(system, balance, &self.search.request.parameter, self.out.exists, self.search.request.speeds) };
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
        let mut assessor = Assessor::new(&self.search.machines[start.machine].1, (true, false), self.search.request.work);
        let mut points = Vec::with_capacity(path.points.len());
        let mut assessed_again = (0.0, 0);
        let every = path.points.len().div_ceil(ASSESSED_AGAIN);
        let mut ends = path.ends.clone();
        for (i, p) in path.points.iter().enumerate() {
            if stopped(self.search.cancel) {
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
