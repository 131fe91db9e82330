//! The search, the test of what it found, and how far each parameter may stray.

use super::machine::at;
use super::request::number;
use super::result::{Along, Found, Run, Slope, Stray, Trail, size};
use super::{Context, Limit, Optimum};
use crate::model::system::System;
use crate::study::parameters::uncertainty::collect::{Quantity, Sample, sample, with_sizes};
use laval_num::optimise::{Ended, Settings, minimise};
use laval_num::order::SortByNumber;
use laval_num::sampling::Points;
use laval_num::sampling::distribution::normal_quantile;
use laval_num::work::Here;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Excess over a limit that counts as kept, as a share of the limit.
pub(super) const KEPT: f64 = 1e-9;

impl Limit {
    /// How far a number is beyond the limit, as a share of it; kept when 0 or less.
    pub(super) fn excess(&self, x: f64) -> f64 {
        let e = (x - self.value) / self.value.abs();
        if self.upper { e } else { -e }
    }
}

impl Run {
    /// Largest excess over a limit.
    pub(super) fn excess(&self, limits: &[Limit]) -> f64 {
        let all = limits.iter().zip(&self.limited).map(|(l, x)| l.excess(*x));
        all.fold(0.0, |m, e| if e > m || e.is_nan() { e } else { m })
    }
    pub(super) fn kept(&self, limits: &[Limit]) -> bool {
        self.value.is_finite() && self.excess(limits) <= KEPT
    }
}

/// Weights of the penalty, one after the other until the limits are kept.
const WEIGHTS: [f64; 3] = [10.0, 1e3, 1e5];
/// Width of the first generation in the unit cube, and at which a search has arrived.
const WIDE: f64 = 0.25;
const NARROW: f64 = 1e-6;
/// Length of the steps of the test in the unit cube.
pub(super) const TEST: f64 = 1e-4;
/// Directions of the test between the parameters, for each of them.
const BETWEEN: usize = 4;
/// Halvings of a recommended range's end.
const HALVINGS: usize = 14;
/// Points of a profile.
const PROFILE: usize = 33;

struct Bench<'a> {
    study: &'a Optimum,
    system: &'a System,
    inner: &'a Context<'a>,
    now: f64,
    runs: AtomicU64,
    failed: AtomicU64,
}

impl Bench<'_> {
    /// Runs machines on all cores; `None` when stopped.
    fn run(&self, places: &[Vec<f64>]) -> Option<Vec<Run>> {
        let here = Here::now();
        let one = |p: &Vec<f64>| {
            let _counted = here.enter();
            self.one(p)
        };
        places.par_iter().map(one).collect()
    }

    fn one(&self, place: &[f64]) -> Option<Run> {
        if self.inner.cancelled() {
            return None;
        }
        self.runs.fetch_add(1, Ordering::Relaxed);
        let s = self.study;
        let none = |invalid| Run { place: place.to_vec(), value: f64::NAN, limited: vec![f64::NAN; s.limits.len()], invalid };
        match sample(&*s.study, at(&s.vary, self.system, place), self.inner, with_sizes) {
            Sample::Stopped => None,
            Sample::Failed(_) => {
                self.failed.fetch_add(1, Ordering::Relaxed);
                Some(none(false))
            }
            Sample::Found(list, invalid) => {
                let value = number(&list, &s.aim.name, !s.aim.large).unwrap_or(f64::NAN);
                let limited = s.limits.iter().map(|l| number(&list, &l.name, l.upper).unwrap_or(f64::NAN)).collect();
                Some(Run { value, limited, ..none(invalid) })
            }
        }
    }

    /// What is minimised.
    fn merit(&self, run: &Run, weight: f64) -> f64 {
        let size = size(self.now);
        let sign = if self.study.aim.large { -1.0 } else { 1.0 };
        let beyond: f64 =
            self.study.limits.iter().zip(&run.limited).map(|(l, x)| if l.excess(*x) <= 0.0 { 0.0 } else { l.excess(*x) }).sum();
        sign * run.value / size + weight * beyond
    }

    fn better(&self, a: &Run, b: &Run) -> bool {
        if self.study.aim.large { a.value > b.value } else { a.value < b.value }
    }
}

/// Searches from several starts, tests the best and measures how far each parameter may stray.
pub(super) fn search(study: &Optimum, system: &System, now: &[Quantity], inner: &Context, context: &Context) -> Found {
    let current = number(now, &study.aim.name, !study.aim.large).unwrap_or(f64::NAN);
    let unit = |name: &str| now.iter().find(|q| q.label == name).map_or(String::new(), |q| q.unit.clone());
    let bench = Bench { study, system, inner, now: current, runs: AtomicU64::new(0), failed: AtomicU64::new(0) };
    let mut found = Found {
        now: current,
        unit: unit(&study.aim.name),
        units: study.limits.iter().map(|l| unit(&l.name)).collect(),
        trails: vec![],
        best: None,
        slopes: vec![],
        stray: vec![],
        profiles: vec![],
        runs: 0,
        failed: 0,
        complete: false,
        weight: WEIGHTS[0],
    };
    let total = (study.starts * study.runs) as u64;
    let seconds = |bench: &Bench| {
        context.progress.report(bench.runs.load(Ordering::Relaxed).min(total), total);
        context.goes_on(bench.runs.load(Ordering::Relaxed))
    };
    for start in 0..study.starts {
        let trail = follow(&bench, start, &mut found.weight, &seconds);
        let stopped = trail.ended == Ended::Stopped;
        if let Some(run) = trail.best.as_ref()
            && found.best.as_ref().is_none_or(|b| bench.better(run, b))
        {
            found.best = Some(run.clone());
        }
        found.trails.push(trail);
        if stopped {
            break;
        }
    }
    found.complete = found.trails.iter().all(|t| t.ended != Ended::Stopped);
    if let Some(best) = found.best.clone().filter(|_| found.complete) {
        found.complete = examine(&bench, &best, &mut found).is_some();
    }
    (found.runs, found.failed) = (bench.runs.into_inner(), bench.failed.into_inner());
    found
}

/// One search; with a heavier penalty again when it ends where a limit is not kept.
fn follow(bench: &Bench, start: usize, weight: &mut f64, go_on: &dyn Fn(&Bench) -> bool) -> Trail {
    let s = bench.study;
    let mut place: Vec<f64> = match start {
        0 => s.vary.iter().map(|v| v.place(v.now)).collect(),
        k => (0..s.vary.len() as u32).map(|d| Points::Sobol.at(1, k as u32, d)).collect(),
    };
    let mut trail = Trail { history: vec![], best: None, ended: Ended::Arrived, width: f64::NAN };
    let mut left = s.runs;
    for w in WEIGHTS.into_iter().filter(|w| *w >= *weight).collect::<Vec<f64>>() {
        *weight = w;
        let width = if trail.history.is_empty() { WIDE } else { 0.1 * WIDE };
        let settings = Settings { start: place.clone(), width, narrow: NARROW, evaluations: left, seed: start as u32 + 1 };
        let (best, history) = (&mut trail.best, &mut trail.history);
        let done = minimise(&settings, |points| {
            if !go_on(bench) {
                return None;
            }
            let runs = bench.run(points)?;
            for run in runs.iter().filter(|r| r.kept(&s.limits)) {
                if best.as_ref().is_none_or(|b| bench.better(run, b)) {
                    *best = Some(run.clone());
                }
            }
            history.push((history.last().map_or(0, |h: &(u64, f64)| h.0) + runs.len() as u64, best.as_ref().map_or(f64::NAN, |b| b.value)));
            Some(runs.iter().map(|r| bench.merit(r, w)).collect())
        });
        (trail.ended, trail.width) = (done.ended, done.width);
        left = left.saturating_sub(done.evaluations);
        // the limits are kept where the penalty is least, but for what the last width leaves open
        let kept = trail.best.as_ref().is_some_and(|b| bench.merit(b, w) - done.value <= 1e-3 * done.value.abs());
        if kept || done.ended == Ended::Stopped || left == 0 {
            break;
        }
        place = done.x;
    }
    trail
}

/// One-sided slopes at the optimum, recommended ranges, profiles; `None` when stopped.
fn examine(bench: &Bench, best: &Run, found: &mut Found) -> Option<()> {
    let s = bench.study;
    let n = s.vary.len();
    let here = bench.merit(best, found.weight);
    // directions that stay inside the bounds
    let mut ways: Vec<(Along, Vec<f64>)> = Vec::new();
    for k in 0..n {
        for sign in [1.0, -1.0] {
            let mut d = vec![0.0; n];
            d[k] = sign;
            ways.push((Some((k, sign)), d));
        }
    }
    for j in 0..if n > 1 { BETWEEN * n } else { 0 } {
        let d: Vec<f64> = (0..n as u32).map(|k| normal_quantile(Points::Random.at(77, j as u32, k))).collect();
        let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
        let d: Vec<f64> = d.iter().map(|x| x / length).collect();
        ways.push((None, d));
    }
    let moved = |d: &[f64]| best.place.iter().zip(d).map(|(u, d)| u + TEST * d).collect::<Vec<f64>>();
    ways.retain(|w| moved(&w.1).iter().all(|u| (0.0..=1.0).contains(u)));
    let runs = bench.run(&ways.iter().map(|w| moved(&w.1)).collect::<Vec<_>>())?;
    found.slopes = ways.iter().zip(&runs).map(|(w, r)| Slope { along: w.0, slope: (bench.merit(r, found.weight) - here) / TEST }).collect();
    // recommended ranges: along each parameter outwards
    let room = s.tolerance * best.value.abs();
    let fits = |r: &Run| {
        let worse = if s.aim.large { best.value - r.value } else { r.value - best.value };
        worse <= room && r.excess(&s.limits) <= 1e-6
    };
    let along = |k: usize, u: f64| {
        let mut place = best.place.clone();
        place[k] = u;
        place
    };
    let places: Vec<Vec<f64>> =
        (0..n).flat_map(|k| (0..PROFILE).map(move |i| (k, i))).map(|(k, i)| along(k, i as f64 / (PROFILE - 1) as f64)).collect();
    let mut runs = bench.run(&places)?.into_iter();
    let profiles: Vec<Vec<Run>> = (0..n)
        .map(|k| {
            let mut profile: Vec<Run> = runs.by_ref().take(PROFILE).chain([best.clone()]).collect();
            profile.sort_by_number(|a| a.place[k]);
            profile
        })
        .collect();
    let counts = Here::now();
    // both ends of each range are located beside each other
    let end = |j: usize| -> Option<(f64, bool)> {
        let _counted = counts.enter();
        let (k, below) = (j / 2, j.is_multiple_of(2));
        let own = best.place[k];
        // the neighbours outwards from the best, up to the first that does not fit
        let outwards: Vec<&Run> = if below {
            profiles[k].iter().rev().filter(|r| r.place[k] < own).collect()
        } else {
            profiles[k].iter().filter(|r| r.place[k] > own).collect()
        };
        let (mut inside, mut outside) = (own, None);
        for r in outwards {
            if !fits(r) {
                outside = Some(r.place[k]);
                break;
            }
            inside = r.place[k];
        }
        if let Some(mut out) = outside {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (inside + out);
                let fine = fits(&bench.one(&along(k, middle))?);
                if fine { inside = middle } else { out = middle }
            }
        }
        Some((s.vary[k].value(inside), outside.is_none()))
    };
    let ends: Vec<(f64, bool)> = (0..2 * n).into_par_iter().map(end).collect::<Option<_>>()?;
    found.stray = ends.chunks_exact(2).map(|e| Stray { ends: [e[0], e[1]] }).collect();
    found.profiles = profiles;
    Some(())
}
