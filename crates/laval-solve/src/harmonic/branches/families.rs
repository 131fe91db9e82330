//! States beside those of the branches from the ends of the range.
//!
//! - **Switched branches**: at every symmetry breaking, period doubling and branch point met, the branch that crosses there.
//! - **Mixed states**: where several states are known at a speed, x is taken from one and y from another, and the result solved for.
//! - **Longer periods**: known states with a component of a third of the spin frequency added (half as well where the machine has no symmetry).
//! - **Starts anywhere**: a deterministic set of motions of many sizes and phases.
//! - **Motions in time**, on request: what an ensemble of starts settles on, of any period up to some turns (see [`crate::harmonic::branches::time_starts`]).
//!
//! Whatever converges to a state that no known branch passes through at that speed, nor an image of it, is followed both ways and assessed; its own
//! bifurcations are switched at in turn. Newton's method finds unstable states as well as stable ones. What is not found is not excluded.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::motion::Motion;
use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::balance::terms::Terms;
use crate::harmonic::branches::bifurcation::Event;
use crate::harmonic::branches::branch::{Assessor, Origin};
use crate::harmonic::branches::response::{Cut, MOST_HARMONICS, Request, Response, Tick, carry, finish, settings, symmetry};
use crate::harmonic::branches::seeds::{Random, anywhere, planes, with_subharmonic};
use crate::harmonic::branches::time_starts::{LONGEST, loops};
use crate::model::system::System;
use crate::reduction::Reduced;
use crate::symmetry::Symmetry;
use laval_num::continuation::{Branch, Direction, Point, Settings, cross, trace, trace_both};
use laval_num::newton::{Options, newton};
use laval_num::order::{SortByNumber, ascending};
use std::sync::atomic::{AtomicBool, Ordering};

/// Families followed at most beside the main branches.
const MOST_FAMILIES: usize = 24;

/// Longest period followed through doublings, in turns.
const MOST_TURNS: usize = 8;

/// Speeds at which states are sought.
const MOST_SPEEDS: usize = 9;

/// Steps of integration in time for every point that a branch may have: the work limit bounds both.
const STEPS_PER_POINT: u64 = 50_000;

/// Most unknowns of a state sought from a motion in time.
const MOST_UNKNOWNS: usize = 400;

/// Sizes and phases of a subharmonic component tried on a known state.
const SIZES: usize = 10;
const PHASES: usize = 6;

struct Search<'a, 'r> {
    system: &'a System,
    request: &'r Request,
    /// Of the machine; where the user imposed one on the motion, that one is kept.
    symmetry: Symmetry,
    settings: Settings,
    /// Points that may still be computed; every start tried counts as one.
    left: usize,
    balances: Vec<Balance<'a>>,
    response: &'r mut Response,
    cancel: &'a AtomicBool,
    tick: Tick<'r>,
    found: usize,
    /// What was done of the search.
    done: Cut,
}

/// A known state at a speed.
#[derive(Clone)]
struct Known {
    balance: usize,
    x: Vec<f64>,
}

/// Adds to the response the branches found beside it; no search is begun unless the main branches are `complete`.
pub(super) fn extend<'a>(
    system: &'a System,
    request: &Request,
    response: &mut Response,
    complete: bool,
    cancel: &'a AtomicBool,
    tick: Tick,
) -> Result<(), Diagnostic> {
    // how much there is to search follows from all folds
    if !complete {
        response.cut = Some(Cut::default());
        return Ok(());
    }
    let (symmetry, _) = symmetry(system, request)?;
    let done = response.branches.iter().map(|b| b.points.len()).sum();
    let left = usize::try_from(request.work).unwrap_or(usize::MAX).saturating_sub(done);
    let settings = settings(request);
    let mut search =
        Search { system, request, symmetry, settings, left, balances: Vec::new(), response, cancel, tick, found: 0, done: Cut::default() };
    let speeds = search.speeds();
    let all = |each: usize| (0, each * speeds.len());
    let in_time = if search.response.discretisation.divisor == 1 { request.time_starts } else { 0 };
    search.done = Cut { speeds: all(1), starts: all(search.starts()), in_time: all(in_time) };
    let mut next = 0;
    search.switch_from(&mut next)?;
    for speed in speeds {
        if search.stopped() {
            break;
        }
        let mut known = search.known(speed)?;
        search.mixed(speed, &mut known)?;
        search.subharmonics(speed, &mut known)?;
        search.mixed(speed, &mut known)?;
        search.anywhere(speed, &mut known)?;
        search.in_time(speed, &mut known)?;
        search.mixed(speed, &mut known)?;
        search.switch_from(&mut next)?;
        search.done.speeds.0 += usize::from(!search.stopped());
    }
    if search.done.speeds.0 < search.done.speeds.1 {
        search.response.cut = Some(search.done);
    }
    for i in 0..search.response.branches.len() {
        search.response.branches[i].images = search.images(i)?;
    }
    Ok(())
}

impl<'a> Search<'a, '_> {
    /// Index of the balance of a discretisation.
    fn balance(&mut self, d: Discretisation) -> Result<usize, Diagnostic> {
        let d = d.whole();
        if let Some(i) = self.balances.iter().position(|b| b.discretisation() == d) {
            return Ok(i);
        }
        self.balances.push(Balance::new(self.system, d, self.request.speeds, Some(self.cancel))?);
        Ok(self.balances.len() - 1)
    }

    fn over(&self) -> bool {
        self.exhausted() || self.stopped()
    }

    /// No further family may be followed.
    fn exhausted(&self) -> bool {
        self.found >= MOST_FAMILIES
    }

    /// By the user, or by the limit on the work.
    fn stopped(&self) -> bool {
        self.left < 2 || self.cancel.load(Ordering::Relaxed)
    }

    /// Starts of any size and phase at each speed.
    fn starts(&self) -> usize {
        self.request.starts.div_ceil(MOST_SPEEDS)
    }

    /// The ends of the range, places between, and places between folds.
    fn speeds(&self) -> Vec<f64> {
        let (lo, hi) = self.request.speeds;
        let mut marks: Vec<f64> = self.response.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect();
        marks.extend([lo, hi]);
        ascending(&mut marks);
        let mut out = vec![hi, lo];
        out.extend(marks.windows(2).filter(|w| w[1] > w[0]).map(|w| 0.5 * (w[0] + w[1])));
        out.extend([0.75, 0.25, 0.9, 0.6, 0.4].map(|t| lo + t * (hi - lo)));
        out.truncate(MOST_SPEEDS);
        out
    }

    /// States of a branch at a speed: its balance and their unknowns.
    fn on_branch(&mut self, branch: usize, speed: f64) -> Result<(usize, Vec<Vec<f64>>), Diagnostic> {
        let balance = self.balance(self.response.branches[branch].discretisation)?;
        let mut out: Vec<Vec<f64>> = Vec::new();
        for pair in self.response.branches[branch].points.windows(2) {
            let (a, b) = (pair[0].speed, pair[1].speed);
            if (a - speed) * (b - speed) > 0.0 || a == b {
                continue;
            }
            let t = (speed - a) / (b - a);
            let mut x: Vec<f64> = pair[0].x.iter().zip(&pair[1].x).map(|(p, q)| p + t * (q - p)).collect();
            let options = Options { to_rounding: true, ..Options::default() };
            if newton(&mut self.balances[balance], &mut x, speed, &options).is_ok() && !out.iter().any(|y| close(y, &x, 1e-8)) {
                out.push(x);
            }
        }
        Ok((balance, out))
    }

    /// All known states at a speed.
    fn known(&mut self, speed: f64) -> Result<Vec<Known>, Diagnostic> {
        let mut out = Vec::new();
        for i in 0..self.response.branches.len() {
            let (balance, states) = self.on_branch(i, speed)?;
            out.extend(states.into_iter().map(|x| Known { balance, x }));
        }
        Ok(out)
    }

    /// How many branches one stands for: the images of a state of it, by those of them that lie on the branch itself.
    fn images(&mut self, branch: usize) -> Result<usize, Diagnostic> {
        let at = self.balance(self.response.branches[branch].discretisation)?;
        let points = &self.response.branches[branch].points;
        let motion = |x: &[f64]| Motion { terms: &self.balances[at].terms, x }.images(self.symmetry);
        let some = [1, 2, 3].iter().filter_map(|k| points.get(k * points.len() / 4));
        let Some((number, state)) = some.map(|p| (motion(&p.x), p.clone())).max_by_key(|m| m.0) else { return Ok(1) };
        let (_, states) = self.on_branch(branch, state.speed)?;
        let terms = &self.balances[at].terms;
        let mut images = vec![state.x];
        for _ in 1..number {
            images.push(Motion { terms, x: &images[images.len() - 1] }.image(self.symmetry));
        }
        let own = images.iter().filter(|i| states.iter().any(|s| close(i, s, 1e-5))).count();
        Ok(number / own.max(1))
    }

    /// Solves from a start; a state that is not known is reduced to the most symmetric terms it fits, followed, assessed, and made known.
    fn try_start(
        &mut self,
        d: Discretisation,
        start: &[f64],
        speed: f64,
        origin: Origin,
        known: &mut Vec<Known>,
    ) -> Result<bool, Diagnostic> {
        if self.over() {
            self.response.more_families |= self.exhausted();
            return Ok(false);
        }
        self.left -= 1;
        let at = self.balance(d)?;
        let mut x = start.to_vec();
        let options = Options { to_rounding: true, max_iterations: 40, ..Options::default() };
        if newton(&mut self.balances[at], &mut x, speed, &options).is_err() || self.is_known(at, &x, known) {
            return Ok(false);
        }
        let (at, x) = self.reduced(at, x, speed)?;
        let (at, x) = self.refined(at, x, speed)?;
        if self.is_known(at, &x, known) {
            return Ok(false);
        }
        let own_period = self.balances[at].terms.divisor == self.response.discretisation.divisor;
        let origin = if own_period && matches!(origin, Origin::Subharmonic(_)) { Origin::Start } else { origin };
        let before = self.response.branches.len();
        self.follow(at, origin, |balance, settings, x| trace_both(balance, x, speed, settings, &mut []).ok(), x)?;
        if self.response.branches.len() > before {
            *known = self.known(speed)?;
            return Ok(true);
        }
        Ok(false)
    }

    fn is_known(&self, at: usize, x: &[f64], known: &[Known]) -> bool {
        let new = Motion { terms: &self.balances[at].terms, x };
        known.iter().any(|k| new.same(&Motion { terms: &self.balances[k.balance].terms, x: &k.x }))
    }

    /// The motion in the terms of the most symmetry and the shortest period that hold it.
    fn reduced(&mut self, at: usize, x: Vec<f64>, speed: f64) -> Result<(usize, Vec<f64>), Diagnostic> {
        let d = self.balances[at].discretisation();
        let mut smaller = Vec::new();
        for divisor in if d.divisor > 1 { vec![1, d.divisor] } else { vec![1] } {
            for symmetry in [Symmetry::Quarter, Symmetry::Half, Symmetry::None] {
                let less = divisor < d.divisor || symmetry > d.symmetry;
                if less && symmetry >= d.symmetry && symmetry <= self.symmetry {
                    let harmonics = d.harmonics * divisor / d.divisor;
                    smaller.push(Discretisation {
                        divisor,
                        symmetry,
                        harmonics,
                        samples: d.samples.max(Terms::samples(harmonics, divisor)),
                    });
                }
            }
        }
        for s in smaller {
            let to = self.balance(s)?;
            let motion = Motion { terms: &self.balances[at].terms, x: &x };
            if motion.left_out(&self.balances[to].terms) <= 1e-8 {
                let mut y = motion.carried(&self.balances[to].terms);
                if newton(&mut self.balances[to], &mut y, speed, &Options { to_rounding: true, ..Options::default() }).is_ok() {
                    return Ok((to, y));
                }
            }
        }
        Ok((at, x))
    }

    /// The motion with as many orders as any branch of its symmetry and period keeps: states are compared there.
    fn refined(&mut self, at: usize, x: Vec<f64>, speed: f64) -> Result<(usize, Vec<f64>), Diagnostic> {
        let d = self.balances[at].discretisation();
        let alike = self.response.branches.iter().map(|b| b.discretisation).filter(|b| b.divisor == d.divisor && b.symmetry == d.symmetry);
        let Some(finest) = alike.max_by_key(|b| b.harmonics).filter(|b| b.harmonics > d.harmonics) else { return Ok((at, x)) };
        let to = self.balance(finest)?;
        let mut y = carry(&self.balances[at].terms, &self.balances[to].terms, &x);
        let solved = newton(&mut self.balances[to], &mut y, speed, &Options { to_rounding: true, ..Options::default() }).is_ok();
        Ok(if solved { (to, y) } else { (at, x) })
    }

    /// A branch in terms of less symmetry whose states are known: at a fold of both planes a step off the branch may lead back onto it.
    fn is_known_throughout(&mut self, at: usize, branch: &Branch) -> Result<bool, Diagnostic> {
        for part in 1..4 {
            let point = &branch.points[part * branch.points.len() / 4];
            let known = self.known(point.p)?;
            let (own, x) = self.reduced(at, point.x.clone(), point.p)?;
            let (own, x) = self.refined(own, x, point.p)?;
            if !self.is_known(own, &x, &known) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Follows a branch from a state with as many orders as its truncation requires, assesses it and adds it.
    fn follow(
        &mut self,
        at: usize,
        origin: Origin,
        trace: impl Fn(&mut Balance<'a>, &Settings, &[f64]) -> Option<Branch>,
        x: Vec<f64>,
    ) -> Result<(), Diagnostic> {
        let (mut at, mut x) = (at, x);
        let mut best: Option<(usize, Branch)> = None;
        for _ in 0..4 {
            let settings = Settings { max_points: self.settings.max_points.min(self.left), ..self.settings.clone() };
            if settings.max_points < 2 {
                break;
            }
            let Some(branch) = trace(&mut self.balances[at], &settings, &x) else { break };
            self.left = self.left.saturating_sub(branch.points.len());
            if branch.points.len() < 2 {
                break;
            }
            let mut assessor = Assessor::new(self.system, (false, false), 0);
            let balance = &mut self.balances[at];
            let step = (branch.points.len() / 40).max(1);
            let dropped = branch.points.iter().step_by(step).map(|p| assessor.state(balance, &p.x, p.p).truncation);
            // NaN stays
            let worst = dropped.fold(0.0, |m: f64, t| if t <= m { m } else { t });
            best = Some((at, branch));
            let d = self.balances[at].discretisation();
            let harmonics = d.harmonics + 4 * d.divisor;
            if self.request.harmonics.is_some() || worst <= self.request.truncation || harmonics > MOST_HARMONICS {
                break;
            }
            let finer = self.balance(Discretisation { harmonics, samples: d.samples.max(Terms::samples(harmonics, d.divisor)), ..d })?;
            x = carry(&self.balances[at].terms, &self.balances[finer].terms, &x);
            at = finer;
        }
        let Some((at, branch)) = best else { return Ok(()) };
        if self.is_known_throughout(at, &branch)? {
            return Ok(());
        }
        let mut assessor = Assessor::new(self.system, (self.request.stability, self.request.determinant), self.request.work);
        let mut traced = assessor.branch(&mut self.balances[at], branch, origin, &self.settings, self.tick);
        finish(self.system, self.request, &mut traced);
        self.response.assessing += assessor.spent();
        self.response.reduced = Reduced::worse(self.response.reduced, assessor.reduced);
        if self.response.unassessed.is_none() {
            self.response.unassessed = assessor.unassessed;
        }
        self.found += 1;
        if let Some(w) = self.response.work.iter_mut().find(|w| w.0 == "points") {
            w.1 += traced.points.len() as u64;
        }
        if let Some(w) = self.response.work.iter_mut().find(|w| w.0 == "maps over the period") {
            w.1 += traced.maps();
        }
        self.response.branches.push(traced);
        Ok(())
    }

    /// Switches at every bifurcation of the branches from number `next` on, and of those that come to it.
    fn switch_from(&mut self, next: &mut usize) -> Result<(), Diagnostic> {
        while *next < self.response.branches.len() {
            let branch = &self.response.branches[*next];
            let mut places: Vec<(Event, usize, Point)> = branch.changes.iter().map(|c| (c.event, c.parts, c.point.clone())).collect();
            places.retain(|(e, ..)| *e != Event::NeimarkSacker);
            for p in &branch.branch_points {
                if !places.iter().any(|(.., q)| (p.p - q.p).abs() <= 1e-6 * p.p.abs()) {
                    places.push((Event::BranchPoint, 1, p.clone()));
                }
            }
            for (event, parts, point) in places {
                if self.over() {
                    return Ok(());
                }
                self.switch(*next, event, parts, &point)?;
            }
            *next += 1;
        }
        Ok(())
    }

    /// The branch that leaves branch `from` at a point.
    fn switch(&mut self, from: usize, event: Event, parts: usize, point: &Point) -> Result<(), Diagnostic> {
        let d = self.response.branches[from].discretisation;
        let (to, origin) = match event {
            Event::BranchPoint => (d, Origin::Crossing(from, point.p)),
            Event::SymmetryBreaking => {
                // -1 over a quarter of the period is +1 over half of it
                let symmetry = if parts == 4 { Symmetry::Half } else { Symmetry::None };
                (Discretisation { symmetry, ..d }, Origin::Broken(from, point.p))
            }
            Event::PeriodDoubling if 2 * d.divisor <= MOST_TURNS => {
                let (harmonics, divisor) = (2 * d.harmonics, 2 * d.divisor);
                let samples = (2 * d.samples).max(Terms::samples(harmonics, divisor));
                (Discretisation { harmonics, divisor, samples, symmetry: Symmetry::None }, Origin::Doubled(from, point.p))
            }
            _ => return Ok(()),
        };
        if self.request.symmetry.is_some_and(|s| to.symmetry < s) || to.harmonics > MOST_HARMONICS {
            return Ok(());
        }
        let (source, target) = (self.balance(d)?, self.balance(to)?);
        let into = |x: &[f64]| Motion { terms: &self.balances[source].terms, x }.carried(&self.balances[target].terms);
        let carried = Point { x: into(&point.x), dx_ds: into(&point.dx_ds), ..point.clone() };
        let Ok(ways) = cross(&mut self.balances[target], &carried, &self.settings) else { return Ok(()) };
        for way in ways {
            let known = self.known(way.p)?;
            let (finest, x) = self.refined(target, way.x.clone(), way.p)?;
            if self.is_known(target, &way.x, &known) || self.is_known(finest, &x, &known) {
                continue;
            }
            let direction: Direction = way.direction;
            let p = way.p;
            self.follow(target, origin, |balance, settings, x| trace(balance, x, p, direction, settings, &mut []).ok(), way.x)?;
        }
        Ok(())
    }

    /// x from one known state of the rotor's own period, y from another.
    fn mixed(&mut self, speed: f64, known: &mut Vec<Known>) -> Result<(), Diagnostic> {
        let main = self.response.discretisation;
        if self.symmetry == Symmetry::Circular {
            return Ok(());
        }
        let symmetry = main.symmetry.min(Symmetry::Half);
        if self.request.symmetry.is_some_and(|s| symmetry < s) {
            return Ok(());
        }
        let d = Discretisation { symmetry, ..main };
        let to = self.balance(d)?;
        let same_period = |k: &&Known| self.balances[k.balance].terms.divisor == main.divisor;
        let sources: Vec<Known> = known.iter().filter(same_period).take(6).cloned().collect();
        for (i, a) in sources.iter().enumerate() {
            for (j, b) in sources.iter().enumerate() {
                if i == j || self.over() {
                    continue;
                }
                let motion = |k: &Known| (k.balance, k.x.clone());
                let ((ka, xa), (kb, xb)) = (motion(a), motion(b));
                let start = planes(
                    &self.balances[to].terms,
                    Motion { terms: &self.balances[ka].terms, x: &xa },
                    Motion { terms: &self.balances[kb].terms, x: &xb },
                );
                self.try_start(d, &start, speed, Origin::Mixed, known)?;
            }
        }
        Ok(())
    }

    /// Known states of the rotor's own period with a component of a fraction of the spin frequency.
    fn subharmonics(&mut self, speed: f64, known: &mut Vec<Known>) -> Result<(), Diagnostic> {
        let main = self.response.discretisation;
        if self.symmetry == Symmetry::Circular || main.divisor != 1 {
            return Ok(());
        }
        let divisors: &[usize] = if main.symmetry == Symmetry::None { &[2, 3] } else { &[3] };
        let Some(smallest) = self.by_size(known).first().map(|k| (*k).clone()) else { return Ok(()) };
        let largest = self.sizes(known).1;
        for &divisor in divisors {
            let harmonics = (divisor * main.harmonics).min(MOST_HARMONICS - MOST_HARMONICS % divisor);
            let d = Discretisation {
                harmonics,
                divisor,
                samples: Terms::samples(harmonics, divisor).max(main.samples),
                symmetry: main.symmetry,
            };
            let to = self.balance(d)?;
            let planes: &[bool] = if d.symmetry == Symmetry::Quarter { &[false] } else { &[false, true] };
            for &upright in planes {
                for i in 0..SIZES * PHASES {
                    let size = largest * 0.1 * 100f64.powf((i / PHASES) as f64 / (SIZES - 1) as f64);
                    let phase = std::f64::consts::TAU * (i % PHASES) as f64 / PHASES as f64;
                    let motion = Motion { terms: &self.balances[smallest.balance].terms, x: &smallest.x };
                    let start = with_subharmonic(&self.balances[to].terms, motion, size, phase, upright);
                    self.try_start(d, &start, speed, Origin::Subharmonic(divisor), known)?;
                    if self.over() {
                        return Ok(());
                    }
                }
            }
        }
        Ok(())
    }

    /// Starts of many sizes and phases, in the terms of the main branches and in less symmetric ones.
    fn anywhere(&mut self, speed: f64, known: &mut Vec<Known>) -> Result<(), Diagnostic> {
        let main = self.response.discretisation;
        let broken = if main.symmetry > Symmetry::Half { Symmetry::Half } else { Symmetry::None };
        let spaces = if self.symmetry == Symmetry::Circular || self.request.symmetry.is_some() {
            vec![main]
        } else {
            vec![main, Discretisation { symmetry: broken, ..main }]
        };
        let (least, most) = self.sizes(known);
        let mut random = Random(speed.to_bits());
        for i in 0..self.starts() {
            self.done.starts.0 += usize::from(!self.over());
            let d = spaces[i % spaces.len()];
            let to = self.balance(d)?;
            let start = anywhere(&self.balances[to].terms, (0.1 * least, 10.0 * most), &mut random);
            self.try_start(d, &start, speed, Origin::Start, known)?;
        }
        Ok(())
    }

    /// What an ensemble of starts settles on in time.
    fn in_time(&mut self, speed: f64, known: &mut Vec<Known>) -> Result<(), Diagnostic> {
        let main = self.response.discretisation;
        if self.request.time_starts == 0 || main.divisor != 1 || self.over() {
            return Ok(());
        }
        let circular = self.symmetry == Symmetry::Circular;
        let symmetry = if circular { main.symmetry } else { self.request.symmetry.unwrap_or(Symmetry::None) };
        let starts = self.request.time_starts;
        let most_steps = STEPS_PER_POINT.saturating_mul(self.request.max_points as u64) / (starts * MOST_SPEEDS) as u64;
        let (found, repeating) = loops(self.system, speed, self.sizes(known), starts, most_steps, self.cancel);
        if self.stopped() {
            return Ok(());
        }
        self.done.in_time.0 += starts;
        for (name, count) in [("starts in time", starts), ("starts in time that repeat", repeating)] {
            match self.response.work.iter_mut().find(|w| w.0 == name) {
                Some(w) => w.1 += count as u64,
                None => self.response.work.push((name, count as u64)),
            }
        }
        for motion in found.into_iter().filter(|m| m.turns == 1 || !circular) {
            let divisor = motion.turns.min(LONGEST);
            let harmonics = (divisor * main.harmonics).min(MOST_HARMONICS - MOST_HARMONICS % divisor);
            let d = Discretisation { harmonics, divisor, samples: Terms::samples(harmonics, divisor).max(main.samples), symmetry };
            let to = self.balance(d)?;
            if self.balances[to].terms.unknowns > MOST_UNKNOWNS {
                continue;
            }
            let start = motion.start(&self.balances[to].terms);
            let origin = if divisor == 1 { Origin::Start } else { Origin::Subharmonic(divisor) };
            self.try_start(d, &start, speed, origin, known)?;
        }
        Ok(())
    }

    /// Smallest and largest of the known motions, m.
    fn sizes(&self, known: &[Known]) -> (f64, f64) {
        let size = |k: &Known| Motion { terms: &self.balances[k.balance].terms, x: &k.x }.size();
        let (least, most) = known.iter().map(size).fold((f64::INFINITY, 0.0f64), |(a, b), s| (a.min(s), b.max(s)));
        if most > 0.0 { (least.max(1e-6 * most), most) } else { (1e-6, 1e-3) }
    }

    fn by_size<'k>(&self, known: &'k [Known]) -> Vec<&'k Known> {
        let size = |k: &Known| Motion { terms: &self.balances[k.balance].terms, x: &k.x }.size();
        let mut out: Vec<&Known> = known.iter().collect();
        out.sort_by_number(|a| size(a));
        out
    }
}

fn close(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance * size)
}
