//! All states of a machine that are at rest in axes that turn with the rotor, over a range of speeds: many starts, continuation along the speed from
//! every new state, stability along the branches, and the places where it changes.
//!
//! No finite number of starts proves that a list of states is complete. How many starts led to states that were known before is reported instead.
//!
//! Theory: `docs/theory/equilibria.md#states-in-rotating-axes`.

pub mod along;
mod continuum;
mod found;
mod grip;
pub mod images;
pub mod metric;
pub mod problem;

use super::pencil::modes_about;
use crate::diagnostic::Diagnostic;
use crate::model::part::DofKind;
use crate::model::system::System;
pub use found::{Change, Found, Located, Loose, Path, Progress, Request, Sample, Stability, State};
pub use grip::{Slack, Zone};
use images::Images;
use laval_num::complex::C64;
use laval_num::continuation::{Branch, End, Kind, Point, Settings, Zero, cross, trace_both};
use laval_num::dense::{Lu, Mat};
use laval_num::newton::{Cause, Options, newton};
use laval_num::order::SortByNumber;
use laval_num::sampling::Points;
use laval_num::univariate::root;
use laval_num::work::Here;
use problem::Stationary;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, Ordering};

/// Share of the turn within which a ring is nearly flat.
const NEARLY_FLAT: f64 = 0.1;
/// Widest angle between masses that lie side by side in a start, rad.
const WIDEST: f64 = 0.5;
/// Roots this many times as large as the speed drown slow growth in their rounding: the others are then solved for by themselves.
const STIFF: f64 = 50.0;
/// Two states are one within this many typical sizes.
const SAME: f64 = 1e-6;
/// Share of the speed within which a fold or branch point is known at best: what holds the masses is a small difference of their forces.
const ROUNDING: f64 = 1e-11;
/// Most changes of stability located along one branch; where roots are zero to rounding there would be no end of them.
const MOST_LOCATED: usize = 100;
/// Most branches followed.
const MOST_BRANCHES: usize = 200;

/// The search in a machine without preferred direction.
pub struct Search<'a> {
    problem: Stationary<'a>,
    scale: Vec<f64>,
    images: Images,
    request: &'a Request,
    cancel: &'a AtomicBool,
    /// Points that may still be assessed.
    left: u64,
}

/// Starts, or branches, that are looked at together, whatever the number of processors.
const TOGETHER: usize = 8;

/// A state that a start leads to, and in how many directions it is free; an error where there is none, true when it was cancelled.
type Reached = (Vec<f64>, Result<usize, bool>);

impl<'a> Search<'a> {
    /// For a machine that [`co_rotating::isotropic`](super::co_rotating::isotropic) admits.
    pub fn new(system: &'a System, request: &'a Request, cancel: &'a AtomicBool) -> Self {
        let (lo, hi) = request.range;
        let problem = Stationary::new(system, 0.1 * (hi - lo).max(1e-6 * hi.abs()), cancel);
        let mut scale = vec![1.0; problem.dim()];
        problem.scale(&mut scale);
        Search { problem, scale, images: Images::of(system, 0.5 * (lo + hi)), request, cancel, left: request.work }
    }

    /// Speeds searched, rad/s.
    pub fn range(&self) -> (f64, f64) {
        self.request.range
    }

    /// Typical sizes of the unknowns.
    pub fn scale(&self) -> &[f64] {
        &self.scale
    }

    /// What counts as the same state.
    pub fn images(&self) -> &Images {
        &self.images
    }

    /// Newton's method on all unknowns.
    ///
    /// # Errors
    /// Why it ended.
    pub fn settle(&mut self, x: &mut [f64], speed: f64) -> Result<f64, Cause> {
        let options = Options { max_iterations: 60, to_rounding: true, noise: 1e-12, loose_step: 1e-7, ..Options::default() };
        newton(&mut self.problem, x, speed, &options).map(|c| c.step).map_err(|e| e.cause)
    }

    /// A start: everything where it comes to rest with the angles held. Of four starts two have the angles spread over the turn, one has the masses of each part
    /// together or side by side, one has them opposite each other in turn; every other one has rings that may turn over nearly flat. States with few masses
    /// apart attract few starts of the first kind.
    pub fn start(&mut self, index: usize, speed: f64) -> Option<Vec<f64>> {
        let n = self.problem.system.n();
        let free: Vec<usize> = (0..self.problem.dim()).filter(|i| !self.images.angles.contains(i)).collect();
        let mut x = vec![0.0; self.problem.dim()];
        let mut first: Vec<(usize, f64, bool)> = Vec::new();
        // masses that touch lie side by side
        let beside = if index % 8 == 6 { WIDEST * Points::Sobol.at(9, index as u32, 0) } else { 0.0 };
        for (d, &i) in self.images.angles.iter().enumerate() {
            let own = PI * (2.0 * Points::Sobol.at(7, index as u32, d as u32) - 1.0);
            if self.images.flips.iter().any(|f| f.0 == i) {
                x[i] = if index % 2 == 1 { NEARLY_FLAT * own } else { own };
                continue;
            }
            x[i] = own;
            let slot = self.problem.system.coordinates()[i].slot;
            match first.iter_mut().find(|f| f.0 == slot) {
                Some(f) if index % 4 >= 2 => {
                    f.2 = !f.2 && index % 4 == 3;
                    f.1 += beside;
                    x[i] = f.1 + if f.2 { PI } else { 0.0 };
                }
                Some(_) => {}
                None => first.push((slot, own, false)),
            }
        }
        for (d, &i) in free.iter().enumerate().filter(|(_, i)| **i < n) {
            if self.problem.system.coordinates()[i].dof.kind == DofKind::Scalar {
                x[i] = self.scale[i] * (2.0 * Points::Random.at(8, index as u32, d as u32) - 1.0);
            }
        }
        // nearly linear in what is left
        for _ in 0..3 {
            self.yield_to(&mut x, speed, &free)?;
        }
        x.iter().all(|x| x.is_finite()).then_some(x)
    }

    /// One step of Newton's method on these unknowns alone, the others held; its largest change in typical sizes, and the residual before it.
    fn yield_to(&mut self, x: &mut [f64], speed: f64, free: &[usize]) -> Option<(f64, Vec<f64>)> {
        let size = x.len();
        let (mut r, mut jac) = (vec![0.0; size], Mat::zeros(size, size));
        self.problem.eval(x, speed, &mut r, Some(&mut jac), None).ok()?;
        let mut step: Vec<f64> = free.iter().map(|&i| r[i]).collect();
        Lu::new(&Mat::from_fn(free.len(), free.len(), |i, j| jac[(free[i], free[j])])).ok()?.solve(&mut step);
        free.iter().zip(&step).for_each(|(&i, s)| x[i] -= s);
        Some((free.iter().zip(&step).map(|(&i, s)| (s / self.scale[i]).abs()).fold(0.0, f64::max), r))
    }

    /// The states of a branch at a speed.
    pub fn at(&mut self, branch: usize, path: &Branch, speed: f64) -> Vec<State> {
        let mut out: Vec<State> = Vec::new();
        for w in path.points.windows(2) {
            let (a, b) = (w[0].p - speed, w[1].p - speed);
            if !(a * b <= 0.0) || a == b {
                continue;
            }
            let share = a / (a - b);
            let mut x: Vec<f64> = w[0].x.iter().zip(&w[1].x).map(|(p, q)| p + share * (q - p)).collect();
            let chord = w[0].x.iter().zip(&w[1].x).zip(&self.scale).map(|((p, q), s)| ((q - p) / s).abs()).fold(0.0, f64::max);
            let from = x.clone();
            let Ok(error) = self.settle(&mut x, speed) else { continue };
            let moved = x.iter().zip(&from).zip(&self.scale).map(|((p, q), s)| ((q - p) / s).abs()).fold(0.0, f64::max);
            if moved > 2.0 * chord + SAME || out.iter().any(|s| self.images.distance(&s.x, &x, &self.scale) < SAME) {
                continue;
            }
            out.push(State { branch, speed, x, error });
        }
        out
    }

    /// Whether a state is one of these or an image.
    pub fn among(&self, x: &[f64], known: &[State]) -> bool {
        known.iter().any(|s| self.images.distance(&s.x, x, &self.scale) < SAME)
    }

    /// Eigenvalues about a state.
    ///
    /// # Errors
    /// As [`modes_about`].
    pub fn stability(&self, x: &[f64], speed: f64) -> Result<Stability, Diagnostic> {
        let about = self.problem.equilibrium(x, speed);
        let spectrum = modes_about(self.problem.system, &about, false)?;
        let fastest = spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
        if fastest <= STIFF * speed.abs() {
            return Ok(Stability::of(&spectrum));
        }
        Ok(Stability::of(&modes_about(self.problem.system, &about, true)?))
    }

    /// The machine's state as an equilibrium.
    pub fn problem(&self) -> &Stationary<'a> {
        &self.problem
    }

    fn settings(&self, work: u64) -> Settings {
        let (lo, hi) = self.request.range;
        let left = usize::try_from(self.request.work.saturating_sub(work)).unwrap_or(usize::MAX);
        Settings {
            max_points: self.request.max_points.min(left).max(2),
            max_parameter_step: (hi - lo) / 100.0,
            min_step: 1e-9,
            ..Settings::new(lo, hi)
        }
    }

    /// The whole search; `each` receives how far it is and says whether to go on.
    ///
    /// # Errors
    /// A spectrum that cannot be computed.
    pub fn run(&mut self, mut each: impl FnMut(Progress) -> bool) -> Result<Found, Diagnostic> {
        let images = self.images.clone();
        let mut found = Found { paths: Vec::new(), images, starts: [0; 3], loose: Vec::new(), crowded: false, stopped: false, work: 0 };
        let request = self.request;
        self.seek(&mut found, &request.seeds, &mut each)?;
        Ok(found)
    }

    /// Seeks at these speeds what is not among what was found.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn seek(&mut self, found: &mut Found, seeds: &[f64], each: &mut dyn FnMut(Progress) -> bool) -> Result<(), Diagnostic> {
        let mut branches: Vec<Branch> = found.paths.iter().map(|p| p.branch.clone()).collect();
        let first = branches.len();
        let total = (seeds.len() * self.request.starts) as u64;
        let mut done = 0;
        'all: for &speed in seeds {
            let mut known = self.known(&branches, speed);
            let mut reached = Vec::new().into_iter();
            for index in 0..self.request.starts {
                if found.stopped || !each(Progress { work: found.work, done, total: 2 * total }) || self.spent(found) {
                    found.stopped = true;
                    break 'all;
                }
                done += 1;
                found.work += 1;
                found.starts[0] += 1;
                if index.is_multiple_of(TOGETHER) {
                    reached = self.reach_all(index..self.request.starts.min(index + TOGETHER), speed).into_iter();
                }
                let Some((mut x, free)) = reached.next().flatten() else { continue };
                let free = match free {
                    Ok(free) => free,
                    Err(cancelled) => {
                        found.stopped |= cancelled;
                        continue;
                    }
                };
                found.starts[1] += 1;
                if free > 0 {
                    self.images.normalise(&mut x);
                    found.loose.push(Loose { speed, x, free });
                } else if self.among(&x, &known) {
                    found.starts[2] += 1;
                } else {
                    self.images.normalise(&mut x);
                    self.follow(&x, speed, &mut branches, found);
                    known = self.known(&branches, speed);
                }
            }
        }
        let all = (branches.len() - first) as u64;
        let mut assessed_ahead = Vec::new().into_iter();
        for (k, branch) in branches.iter().enumerate().skip(first) {
            let before = found.work;
            let mut goes_on = |assessed: u64| {
                let done = total + (total * (k - first) as u64) / all.max(1);
                each(Progress { work: before + assessed, done, total: 2 * total }) && before + assessed < self.request.work
            };
            if !goes_on(0) {
                found.stopped = true;
                break;
            }
            self.left = self.request.work.saturating_sub(before);
            // under a limit on the work what may be spent on a branch depends on those before
            let (path, assessed) = if self.request.work == u64::MAX {
                if (k - first).is_multiple_of(TOGETHER) {
                    assessed_ahead = self.assess_all(k, &branches[k..branches.len().min(k + TOGETHER)]).into_iter();
                }
                let Some(ahead) = assessed_ahead.next() else { break };
                ahead?
            } else {
                self.assess(k, branch.clone(), &mut goes_on)?
            };
            found.work += path.points.len() as u64;
            found.paths.push(path);
            if !assessed {
                found.stopped = true;
                break;
            }
        }
        Ok(())
    }

    /// Where some starts lead at a speed, on all processors; none for a start that there is not.
    fn reach_all(&self, starts: std::ops::Range<usize>, speed: f64) -> Vec<Option<Reached>> {
        let here = Here::now();
        let (system, request, cancel) = (self.problem.system, self.request, self.cancel);
        let one = |index: usize| {
            let _counted = here.enter();
            let mut search = Search::new(system, request, cancel);
            let mut x = search.start(index, speed)?;
            let free = search.reach(&mut x, speed);
            Some((x, free))
        };
        starts.into_par_iter().map(one).collect()
    }

    /// Some branches assessed, on all processors; the first has this number.
    fn assess_all(&self, first: usize, branches: &[Branch]) -> Vec<Result<(Path, bool), Diagnostic>> {
        let here = Here::now();
        let (system, request, cancel) = (self.problem.system, self.request, self.cancel);
        let one = |(k, branch): (usize, &Branch)| {
            let _counted = here.enter();
            let mut search = Search::new(system, request, cancel);
            search.assess(first + k, branch.clone(), &mut |_| !cancel.load(Ordering::Relaxed))
        };
        branches.par_iter().enumerate().map(one).collect()
    }

    fn spent(&self, found: &Found) -> bool {
        found.work >= self.request.work
    }

    /// The states of some branches at a speed.
    fn known(&mut self, branches: &[Branch], speed: f64) -> Vec<State> {
        branches.iter().enumerate().flat_map(|(k, b)| self.at(k, b, speed)).collect()
    }

    /// From a start to a state, and in how many directions that is free.
    ///
    /// # Errors
    /// No state near; true when it was cancelled.
    pub fn reach(&mut self, x: &mut [f64], speed: f64) -> Result<usize, bool> {
        let start = x.to_vec();
        match self.settle(x, speed) {
            Ok(_) if self.freedom(x, speed) == Some(0) => return Ok(0),
            Ok(_) => {}
            Err(Cause::Cancelled) => return Err(true),
            Err(_) => x.copy_from_slice(&start),
        }
        self.settle_freely(x, speed).ok_or(false)
    }

    /// Follows the branch through a state, and those that cross it.
    fn follow(&mut self, x: &[f64], speed: f64, branches: &mut Vec<Branch>, found: &mut Found) {
        let mut waiting = vec![(x.to_vec(), speed)];
        while let Some((x, speed)) = waiting.pop() {
            if self.spent(found) {
                found.stopped = true;
                return;
            }
            if branches.len() >= MOST_BRANCHES {
                found.crowded = true;
                return;
            }
            let known = self.known(branches, speed);
            if self.among(&x, &known) {
                continue;
            }
            match self.freedom(&x, speed) {
                Some(0) => {}
                Some(free) => {
                    found.loose.push(Loose { speed, x, free });
                    continue;
                }
                None => continue,
            }
            let settings = self.settings(found.work);
            let Ok(branch) = trace_both(&mut self.problem, &x, speed, &settings, &mut []) else { continue };
            found.work += branch.points.len() as u64;
            found.stopped |= [branch.first_end.as_ref(), Some(&branch.end)].contains(&Some(&End::Cancelled));
            if branch.points.len() < 2 {
                continue;
            }
            for special in branch.of(Kind::BranchPoint) {
                // beside the branch point, away from it
                let crossing = cross(&mut self.problem, &special.point, &settings).unwrap_or_default();
                waiting.extend(crossing.into_iter().map(|c| (c.x, c.p)));
            }
            branches.push(branch);
        }
    }

    /// Stability along a branch and where it changes, as far as `each` lets it go on.
    fn assess(&mut self, k: usize, branch: Branch, each: &mut dyn FnMut(u64) -> bool) -> Result<(Path, bool), Diagnostic> {
        let mut complete = true;
        let mut points: Vec<Sample> = Vec::new();
        let mut special: Vec<Located> = Vec::new();
        let sample = |search: &Self, p: &Point| -> Result<Sample, Diagnostic> {
            let state = State { branch: k, speed: p.p, x: p.x.clone(), error: p.error };
            Ok(Sample { s: p.s, stability: search.stability(&p.x, p.p)?, state })
        };
        for (i, p) in branch.points.iter().enumerate() {
            if !each(points.len() as u64) {
                complete = false;
                break;
            }
            let next = sample(self, p)?;
            let Some(last) = points.last().cloned() else {
                points.push(next);
                continue;
            };
            let within = |k: Kind| branch.specials.iter().filter(move |s| s.after + 1 == i && s.kind == k);
            // where the parameter has its extremum at a branch point the two are one
            let crossed = within(Kind::BranchPoint).count() > 0;
            let turns: Vec<_> =
                within(Kind::Fold).chain(within(Kind::BranchPoint)).chain(within(Kind::ParameterExtremum).filter(|_| !crossed)).collect();
            let growing = (last.stability.growing, next.stability.growing);
            for s in &turns {
                let change = if s.kind == Kind::Fold { Change::Fold } else { Change::BranchPoint };
                let (low, high) = s.range();
                let open = ROUNDING * s.point.p.abs();
                let bracket = (low - open, high + open);
                let located = s.status != laval_num::continuation::Status::Bracketed;
                let state = State { branch: k, speed: s.point.p, x: s.point.x.clone(), error: s.point.error };
                let place = s.point.s.clamp(last.s, next.s);
                special.push(Located { s: place, change, state, frequency: 0.0, bracket, growing, located });
            }
            if turns.is_empty() {
                self.refine(&last, &next, 0, &mut points);
            }
            points.push(next);
            // a real root is zero at a fold and at a branch point
            if !turns.is_empty() && growing.0.abs_diff(growing.1) <= turns.len() {
                continue;
            }
            let first = points.iter().rposition(|p| p.s <= last.s).unwrap_or(0);
            for j in first..points.len() - 1 {
                if points[j].stability.growing != points[j + 1].stability.growing {
                    let (a, b) = (points[j].clone(), points[j + 1].clone());
                    special.push(self.crossing(&a, &b, special.len() < MOST_LOCATED));
                }
            }
        }
        special.sort_by_number(|a| a.s);
        Ok((Path { branch, points, special }, complete))
    }

    /// The state of a branch at a speed between two of its points that do not turn back.
    pub fn between(&mut self, a: &Sample, b: &Sample, speed: f64) -> Option<Sample> {
        let share = (speed - a.state.speed) / (b.state.speed - a.state.speed);
        let mut x: Vec<f64> = a.state.x.iter().zip(&b.state.x).map(|(p, q)| p + share * (q - p)).collect();
        let from = x.clone();
        let error = self.settle(&mut x, speed).ok()?;
        let length = |p: &[f64], q: &[f64]| p.iter().zip(q).zip(&self.scale).map(|((p, q), s)| ((q - p) / s).abs()).fold(0.0, f64::max);
        // another branch is nearer than half the way along this one
        if length(&from, &x) > 0.5 * length(&a.state.x, &b.state.x) + SAME {
            return None;
        }
        let stability = self.stability(&x, speed).ok()?;
        Some(Sample { s: a.s + share * (b.s - a.s), state: State { branch: a.state.branch, speed, x, error }, stability })
    }

    /// Points between two others until the largest growth rate is nearly straight beside its own size: two changes of stability close together are then seen.
    fn refine(&mut self, a: &Sample, b: &Sample, depth: usize, out: &mut Vec<Sample>) {
        if depth >= 8 || out.len() as u64 >= self.left {
            return;
        }
        let Some(middle) = self.between(a, b, 0.5 * (a.state.speed + b.state.speed)) else { return };
        let g = [a, &middle, b].map(|p| p.stability.growth());
        let bend = (g[1] - 0.5 * (g[0] + g[2])).abs();
        let least = g.iter().map(|g| g.abs()).fold(f64::INFINITY, f64::min);
        if bend > (0.2 * least).max(10.0 * middle.stability.noise) {
            self.refine(a, &middle, depth + 1, out);
            out.push(middle.clone());
            self.refine(&middle, b, depth + 1, out);
        }
    }

    /// Where a root crosses the imaginary axis between two points of a branch.
    fn crossing(&mut self, a: &Sample, b: &Sample, locate: bool) -> Located {
        let rank = a.stability.growing.max(b.stability.growing).saturating_sub(1);
        let (lo, hi) = (a.state.speed, b.state.speed);
        let tolerance = 1e-13 * lo.abs().max(hi.abs());
        // undamped roots beside the one that crosses stand at zero on both sides: there the crossing is sought just above them
        let mut place = None;
        for above in [0.0, 1.0] {
            let value = |s: &Stability| s.ranked(rank).map_or(f64::NAN, |z| z.re - above * s.noise);
            let ends = ((lo, value(&a.stability)), (hi, value(&b.stability)));
            if locate && place.is_none() {
                place = root(|p| self.between(a, b, p).map(|s| value(&s.stability)), ends.0, ends.1, tolerance);
            }
        }
        let found = place.and_then(|p| self.between(a, b, p));
        let located = found.is_some();
        let at = found.unwrap_or_else(|| a.clone());
        let z = at.stability.ranked(rank).unwrap_or(C64::zero());
        let size = at.stability.values.iter().map(|v| v.0.abs()).fold(0.0, f64::max);
        Located {
            s: if located { at.s } else { 0.5 * (a.s + b.s) },
            change: if z.im > 1e-7 * size { Change::Hopf } else { Change::Real },
            frequency: if located { z.im } else { f64::NAN },
            bracket: (lo.min(hi), lo.max(hi)),
            growing: (a.stability.growing, b.stability.growing),
            state: at.state,
            located,
        }
    }
}

impl Found {
    /// The states of all branches at a speed, images once.
    pub fn states(&self, search: &mut Search, speed: f64) -> Vec<State> {
        let mut out: Vec<State> = Vec::new();
        for (k, path) in self.paths.iter().enumerate() {
            for s in search.at(k, &path.branch, speed) {
                if !search.among(&s.x, &out) {
                    out.push(s);
                }
            }
        }
        out
    }
}
