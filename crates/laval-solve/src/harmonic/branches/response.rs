//! The forced response over a range of speeds: branches from both ends, folds, stability of every point, evidence.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::{Balance, Discretisation, Nonlinear};
use crate::harmonic::balance::terms::{Terms, admitted};
use crate::harmonic::branches::agreement::{self, Agreement};
use crate::harmonic::branches::branch::{Assessor, GROUP, Origin};
use crate::harmonic::branches::families;
use crate::harmonic::branches::starts::Starts;
use crate::harmonic::branches::unclosed::{Unclosed, unclosed};
use crate::harmonic::stability::floquet::Unassessed;
use crate::model::system::System;
use crate::reduction::Reduced;
use crate::symmetry::{Broken, Symmetry, probe, probed_speeds};
use laval_model::text;
use laval_num::continuation::{Branch, Direction, End, Point, Settings, Zero, fold, trace};
use laval_num::dense::{Mat, max_abs};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

pub use crate::harmonic::branches::branch::{Fold, State, Traced};

/// Largest order tried by the automatic choice.
pub const MOST_HARMONICS: usize = 63;

/// Orders the automatic choice settles for when none would be enough (a law with kinks: forces fall like the square of the order, motions
/// like the fourth power).
const SLOW_HARMONICS: usize = 15;

/// Most unknowns the automatic choice of orders goes to.
const MOST_UNKNOWNS: usize = 128;

/// The request.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// Range of the spin speed, rad/s, ascending; both ends of one sign. Negative speeds turn clockwise.
    pub speeds: (f64, f64),
    /// Largest order; `None` chooses.
    pub harmonics: Option<usize>,
    /// Symmetry to impose; `None` takes the largest the machine has.
    pub symmetry: Option<Symmetry>,
    /// Subharmonic divisor.
    pub divisor: usize,
    /// Dropped force harmonics over kept ones that the automatic choice of orders accepts.
    pub truncation: f64,
    /// Assessor stability.
    pub stability: bool,
    /// Assessor it on Hill's determinant also where all parts have a time form.
    pub determinant: bool,
    /// For a figure that follows a changing machine: fewer points, and the branch from the second end only where that from the first does not lead there.
    pub sketch: bool,
    /// Most points of a branch; after as many in all, orders and samples are raised no more.
    pub max_points: usize,
    /// Points, and starts tried, after which no further states are looked for.
    pub work: u64,
    /// Which states are looked for.
    pub states: States,
    /// Starts taken anywhere when all states are looked for.
    pub starts: usize,
    /// Starts integrated in time at every speed searched when all states are looked for.
    pub time_starts: usize,
    /// Assessor some states of every branch again by two other methods.
    pub check_stability: bool,
}

/// Which states are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum States {
    /// Those of the branches from both ends of the range.
    Main,
    /// Also those of less symmetry, of longer period, and apart from the others (see [`crate::harmonic::branches::families`]).
    All,
}

impl Request {
    /// The usual request over a range of speeds (rad/s): orders and symmetry chosen, stability assessed.
    pub fn over(lo: f64, hi: f64) -> Self {
        Request {
            speeds: (lo, hi),
            harmonics: None,
            symmetry: None,
            divisor: 1,
            truncation: 1e-7,
            stability: true,
            determinant: false,
            sketch: false,
            max_points: 2_000,
            work: u64::MAX,
            states: States::Main,
            starts: 64,
            time_starts: 0,
            check_stability: false,
        }
    }
}

/// The response.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Response {
    /// Branches.
    pub branches: Vec<Traced>,
    /// Discretisation of the branches from the ends of the range.
    pub discretisation: Discretisation,
    /// Families of states were left unfollowed: there are more than the search follows.
    pub more_families: bool,
    /// How far the search for further states came where it was stopped.
    pub cut: Option<Cut>,
    /// Ends of the range at which no motion was found, rad/s: no branch begins there.
    pub unstarted: Vec<f64>,
    /// Ends of the range whose states were found there alone, rad/s: no branch was followed to them from beyond the range.
    pub unfollowed: Vec<f64>,
    /// A branch that does not close in the range.
    pub unclosed: Option<Unclosed>,
    /// Stability of some states by two other methods.
    pub agreement: Option<Agreement>,
    /// Parts that break larger symmetries.
    pub broken: Vec<Broken>,
    /// Why stability was not assessed.
    pub unassessed: Option<Unassessed>,
    /// What the machine was reduced to for the stability of motions that are not circular.
    pub reduced: Option<Reduced>,
    /// Terms of Hill's determinants that were added up.
    pub assessing: u64,
    /// Largest change of the residual when the samples of a period are doubled, relative to the largest force.
    pub sampling: f64,
    /// Work: name and count.
    #[serde(deserialize_with = "laval_num::text::counts")]
    pub work: Vec<(laval_num::text::Text, u64)>,
}

/// A search for further states that was stopped: what was done of it, and of how much; nothing of nothing where the main branches were stopped, from which it
/// begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Cut {
    /// Speeds at which it was done.
    pub speeds: (usize, usize),
    /// Starts of any size and phase.
    pub starts: (usize, usize),
    /// Starts integrated in time.
    pub in_time: (usize, usize),
}

/// What is under way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stage {
    /// The motion at an end of the range.
    Start,
    /// A branch from an end of the range is followed.
    Follow(Origin),
    /// The points of a branch are assessed.
    Assess(Origin),
}

/// How far a response is.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Points done of this stage.
    pub done: u64,
    /// What is under way.
    pub stage: Stage,
    /// Where, rad/s.
    pub speed: f64,
}

/// Receives every accepted round of work, from whichever thread does it.
pub type Tick<'a> = &'a (dyn Fn(Step) + Sync);

/// The symmetry that the request imposes on the motion, and what changes when the machine is turned.
///
/// # Errors
/// A symmetry the machine does not have, naming a part that breaks it; motions of several turns where only circular ones are computed.
pub fn symmetry(system: &System, request: &Request) -> Result<(Symmetry, Vec<Broken>), Diagnostic> {
    let (found, broken) = probe(system, &probed_speeds(request.speeds));
    // a machine whose nonlinear coordinates do not come in pairs is expanded coordinate by coordinate, which no turn maps onto itself
    let found = if Nonlinear::of(system).paired { found } else { Symmetry::None };
    match request.symmetry {
        None if found == Symmetry::Circular && request.divisor > 1 => {
            let message = text!(
                "the machine is symmetric by any turn: its motion is computed as circular, of order 1 alone, and none of {divisor} turns is among these",
                divisor = request.divisor
            );
            let help = match request.divisor.is_multiple_of(2) {
                true => text!("leave subharmonic out, or write symmetry = \"none\" to keep more orders"),
                false => text!("leave subharmonic out, or write symmetry = \"half\" or \"none\" to keep more orders"),
            };
            Err(Diagnostic::error("response.subharmonic", message).help(help))
        }
        None => Ok((found, broken)),
        Some(s) if s <= found => Ok((s, broken)),
        Some(s) => {
            let symmetry = text::term(s.name());
            let message = match broken.iter().find(|b| b.change > 0.0) {
                Some(b) => text!("the machine has no symmetry by {symmetry}: part \"{part}\" changes when turned", symmetry, part = b.part),
                None => text!("the machine has no symmetry by {symmetry}", symmetry),
            };
            Err(Diagnostic::error("response.symmetry", message)
                .help(text!("use symmetry = \"auto\"; this machine is symmetric by {symmetry}", symmetry = text::term(found.name()))))
        }
    }
}

/// Computes the response of a machine.
pub fn respond<'a>(system: &'a System, request: &Request, cancel: &'a AtomicBool, tick: Tick<'a>) -> Result<Response, Diagnostic> {
    let (symmetry, broken) = symmetry(system, request)?;
    let automatic = request.harmonics.is_none() && symmetry != Symmetry::Circular;
    let mut harmonics = match symmetry {
        Symmetry::Circular => request.divisor,
        _ => request.harmonics.unwrap_or(7 * request.divisor).max(request.divisor),
    };
    let coordinates = Nonlinear::of(system).kinds.len();
    let mut oversampling = 1;
    let mut spent = 0;
    let mut before: Option<(usize, f64)> = None;
    let mut settled = false;
    let mut starts = Starts::default();
    loop {
        let d = Discretisation {
            harmonics,
            divisor: request.divisor,
            samples: oversampling * Terms::samples(harmonics, request.divisor),
            symmetry,
        };
        // stability is assessed once the orders are chosen
        let trial = Request { stability: request.stability && (!automatic || settled), ..*request };
        let response = attempt(system, &trial, d, &mut starts, cancel, tick)?;
        let worst = worst_truncation(&response);
        // a law with kinks converges slowly: wider steps then
        let slow = harmonics >= 4 * 7 * request.divisor;
        // where a law switches, or the dropped force is seen to fall so slowly that no affordable number of orders is enough, one more attempt
        // says what there is
        let switches = response.branches.iter().flat_map(|b| &b.points).any(|p| p.switches);
        let hopeless = switches
            || before.is_some_and(|(h, t)| {
                let rate = (t / worst).ln() / (harmonics as f64 / h as f64).ln();
                let needed = harmonics as f64 * (worst / request.truncation).powf(1.0 / rate);
                !(rate > 0.0 && needed <= MOST_HARMONICS as f64)
            });
        let last = hopeless && harmonics >= SLOW_HARMONICS * request.divisor;
        before = Some((harmonics, worst));
        let more = match request.divisor {
            nu if hopeless && !last => (SLOW_HARMONICS * nu).saturating_sub(harmonics).next_multiple_of(4 * nu),
            _ if slow => 4 * (harmonics / 8).max(request.divisor),
            1 if symmetry == Symmetry::Quarter => 4,
            nu => 4 * nu,
        };
        // every attempt follows the branches anew: together they stay within the limit as well
        spent += response.branches.iter().map(|b| b.points.len()).sum::<usize>();
        let complete = response.branches.iter().all(|b| b.end != End::Cancelled) && spent < request.max_points;
        let (vector, _) = admitted(symmetry, harmonics + more, request.divisor);
        let affordable = harmonics + more <= MOST_HARMONICS && vector.len() * coordinates <= MOST_UNKNOWNS;
        if automatic && complete && worst > request.truncation && affordable && !last {
            harmonics += more;
            settled = hopeless;
        } else if complete && response.sampling > 1e-9 && oversampling < 4 {
            oversampling *= 2;
        } else {
            let response =
                if trial.stability == request.stability { response } else { attempt(system, request, d, &mut starts, cancel, tick)? };
            let mut response = Response { broken, ..response };
            if request.states == States::All {
                families::extend(system, request, &mut response, complete, cancel, tick)?;
            }
            response.unclosed = unclosed(system, &response, request, cancel);
            if request.check_stability && request.stability && response.unassessed.is_none() {
                response.agreement = Some(agreement::check(system, &response, cancel));
            }
            return Ok(response);
        }
    }
}

fn worst_truncation(r: &Response) -> f64 {
    r.branches
        .iter()
        .flat_map(|b| &b.points)
        .fold(0.0, |m: f64, p| if p.truncation > m || p.truncation.is_nan() { p.truncation } else { m })
}

fn attempt<'a>(
    system: &'a System,
    request: &Request,
    d: Discretisation,
    starts: &mut Starts,
    cancel: &'a AtomicBool,
    tick: Tick<'a>,
) -> Result<Response, Diagnostic> {
    let (lo, hi) = request.speeds;
    // low and high, up and down speak of how fast the rotor turns, whichever way round
    let origin = |up: bool| if up != (hi < 0.0) { Origin::Low } else { Origin::High };
    let mut balance = Balance::new(system, d, (lo, hi), Some(cancel))?;
    tick(Step { done: 0, stage: Stage::Start, speed: lo });
    let (from_lo, from_hi) = starts.both(system, &mut balance, request, cancel);
    let ends = [(&from_lo, lo), (&from_hi, hi)];
    let unfollowed = ends.iter().filter(|(s, _)| s.as_ref().is_some_and(|s| !s.followed)).map(|f| f.1).collect();
    let unstarted = ends.iter().filter(|(found, _)| found.is_none()).map(|f| f.1).collect();
    let settings = settings(request);
    let from = (from_lo.map(|s| s.x), from_hi.map(|s| s.x));
    let branches = both_ways(&balance, from, (&settings, !request.sketch), origin, tick)?;
    if branches.is_empty() {
        return Err(Diagnostic::error(
            "response.start",
            text!("no periodic motion was found at {lo} nor at {hi}", lo = text::quantity(lo, "rad/s"), hi = text::quantity(hi, "rad/s")),
        )
        .help(text!("integrate the machine in time (transient, sweep): its motion may not repeat after one turn, or not at all")));
    }
    let mut assessor = Assessor::new(system, (request.stability, request.determinant), request.work);
    let sampling = sampling_error(system, &mut balance, d, &branches)?;
    let mut work = [("points", 0), ("Newton iterations", 0), ("factorisations", 0), ("maps over the period", 0)];
    let mut traced = Vec::new();
    for (branch, up) in branches {
        work[0].1 += branch.points.len() as u64;
        work[1].1 += branch.counters.work.iterations as u64;
        work[2].1 += branch.counters.work.factorisations as u64;
        traced.push(assessor.branch(&mut balance, branch, origin(up), &settings, tick));
    }
    for t in &mut traced {
        finish(system, request, t);
    }
    work[3].1 = traced.iter().map(Traced::maps).sum();
    Ok(Response {
        branches: traced,
        discretisation: d,
        more_families: false,
        cut: None,
        unstarted,
        unfollowed,
        unclosed: None,
        agreement: None,
        broken: Vec::new(),
        assessing: assessor.spent(),
        unassessed: assessor.unassessed,
        reduced: assessor.reduced,
        sampling,
        work: work.to_vec(),
    })
}

/// The branches from both ends of the range, with whether each runs up. On request they are followed at once where there is a thread for each; the second is of no use where
/// the first ends in its start.
fn both_ways(
    balance: &Balance,
    (from_lo, from_hi): (Option<Vec<f64>>, Option<Vec<f64>>),
    (settings, at_once): (&Settings, bool),
    origin: impl Fn(bool) -> Origin + Sync,
    tick: Tick,
) -> Result<Vec<(Branch, bool)>, Diagnostic> {
    let (lo, hi) = settings.range;
    let (met, needless) = (AtomicBool::new(false), AtomicBool::new(false));
    let follow = |x: &[f64], up: bool| {
        let (points, before) = (AtomicU64::new(0), AtomicU64::new(f64::NAN.to_bits()));
        let watch = |speed: f64| {
            if !up && (met.load(Ordering::Relaxed) || balance.cancelled()) {
                needless.store(true, Ordering::Relaxed);
            }
            // a step that was refused begins at the same point again, and the last one may lead out of the range
            let speed = speed.clamp(lo, hi);
            if before.swap(speed.to_bits(), Ordering::Relaxed) != speed.to_bits() {
                let done = points.fetch_add(1, Ordering::Relaxed) + 1;
                tick(Step { done, stage: Stage::Follow(origin(up)), speed });
            }
        };
        let mut own = balance.twin(if up { balance.cancel } else { Some(&needless) });
        own.watch = Some(&watch);
        let (start, direction) = if up { (lo, Direction::Up) } else { (hi, Direction::Down) };
        trace(&mut own, x, start, direction, settings, &mut [])
    };
    let ends_in = |branch: &Branch, x: &[f64]| {
        let same =
            |p: &Point| p.p == hi && p.x.iter().zip(x).zip(balance.scales()).all(|((a, b), s)| (a - b).abs() <= 1e-6 * s.max(a.abs()));
        [branch.points.first(), branch.points.last()].into_iter().flatten().any(same)
    };
    let up = || {
        let branch = from_lo.as_ref().map(|x| follow(x, true));
        if let (Some(Ok(branch)), Some(x)) = (&branch, &from_hi) {
            met.store(ends_in(branch, x), Ordering::Relaxed);
        }
        branch
    };
    let down = || from_hi.as_ref().filter(|_| !met.load(Ordering::Relaxed)).map(|x| follow(x, false));
    let (up, down) = if at_once { rayon::join(up, down) } else { (up(), down()) };
    let down = down.filter(|_| !met.load(Ordering::Relaxed));
    let invalid =
        |e: laval_num::continuation::Invalid| Diagnostic::error("response.settings", text!("the response cannot be followed: {e}", e));
    [(up, true), (down, false)].into_iter().filter_map(|(branch, way)| Some(branch?.map(|b| (b, way)).map_err(invalid))).collect()
}

/// How branches are followed.
pub(super) fn settings(request: &Request) -> Settings {
    let (lo, hi) = request.speeds;
    let usual = Settings::new(lo, hi);
    let usual = match request.sketch {
        true => Settings { monitor_change: 0.2, min_cosine: 0.97, target_rate: 0.2, ..usual },
        false => usual,
    };
    let steps = if request.sketch { 60.0 } else { 100.0 };
    Settings { max_points: request.max_points, max_parameter_step: (hi - lo) / steps, ..usual }
}

/// Folds of an assessed branch by how fast the rotor turns, with the evidence of more orders.
pub(super) fn finish(system: &System, request: &Request, branch: &mut Traced) {
    if request.speeds.1 < 0.0 {
        branch.folds.iter_mut().for_each(|f| f.upper = !f.upper);
    }
    confirm_with_more_harmonics(system, branch.discretisation, request, &mut branch.folds);
}

/// The same folds with four more orders, as evidence.
fn confirm_with_more_harmonics(system: &System, d: Discretisation, request: &Request, folds: &mut [Fold]) {
    if d.symmetry == Symmetry::Circular {
        folds.iter_mut().for_each(|f| f.harmonics_change = 0.0);
        return;
    }
    let more = Discretisation {
        harmonics: d.harmonics + 4 * d.divisor,
        samples: d.samples.max(Terms::samples(d.harmonics + 4 * d.divisor, d.divisor)),
        ..d
    };
    if folds.is_empty() {
        return;
    }
    let Ok(mut finer) = Balance::new(system, more, request.speeds, None) else { return };
    let coarse = Terms::new(&finer.nonlinear.kinds, d.symmetry, d.harmonics, d.divisor, d.samples);
    for f in folds {
        let x = carry(&coarse, &finer.terms, &f.x);
        let guess = vec![0.0; x.len()];
        let null = null_vector(&mut finer, &x, f.speed).unwrap_or(guess);
        if let Ok(p) = fold(&mut finer, &x, f.speed, &null) {
            f.harmonics_change = p.p - f.speed;
        }
    }
}

/// Unknowns of one set of terms in another; orders it lacks are left out, new ones are zero.
pub fn carry(from: &Terms, to: &Terms, x: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; to.unknowns];
    for &(term, at) in &to.list {
        if let Some(&(_, old)) = from.list.iter().find(|(t, _)| *t == term) {
            out[at..at + term.size()].copy_from_slice(&x[old..old + term.size()]);
        }
    }
    out
}

/// Null vector of the Jacobian near a fold by inverse iteration.
fn null_vector(balance: &mut Balance, x: &[f64], speed: f64) -> Option<Vec<f64>> {
    let n = balance.dim();
    let (mut r, mut jac) = (vec![0.0; n], Mat::zeros(n, n));
    balance.eval(x, speed, &mut r, Some(&mut jac), None).ok()?;
    let lu = laval_num::dense::Lu::new(&jac).ok()?;
    let mut v: Vec<f64> = (0..n).map(|i| 1.0 + 0.1 * (i as f64).sin()).collect();
    for _ in 0..4 {
        lu.solve(&mut v);
        let size = max_abs(&v);
        if !(size.is_finite() && size > 0.0) {
            return None;
        }
        v.iter_mut().for_each(|x| *x /= size);
    }
    Some(v)
}

/// Change of the residual at the point of largest motion when the samples are doubled, relative to the largest force.
fn sampling_error(system: &System, balance: &mut Balance, d: Discretisation, branches: &[(Branch, bool)]) -> Result<f64, Diagnostic> {
    if d.symmetry == Symmetry::Circular {
        return Ok(0.0);
    }
    let points = branches.iter().flat_map(|(b, _)| &b.points);
    let Some(largest) = points.max_by(|a, b| max_abs(&a.x).total_cmp(&max_abs(&b.x))) else { return Ok(0.0) };
    let n = balance.dim();
    let speeds = (largest.p, largest.p);
    let mut finer = Balance::new(system, Discretisation { samples: 2 * d.samples, ..d }, speeds, None)?;
    let (mut r, mut fine) = (vec![0.0; n], vec![0.0; n]);
    let evaluated =
        balance.eval(&largest.x, largest.p, &mut r, None, None).is_ok() && finer.eval(&largest.x, largest.p, &mut fine, None, None).is_ok();
    if !evaluated {
        return Ok(f64::NAN);
    }
    let size = balance.largest_force();
    let change = max_abs(&r.iter().zip(&fine).map(|(a, b)| a - b).collect::<Vec<_>>());
    Ok(if size == 0.0 { change } else { change / size })
}

/// The whole motions at points, empty where there is none. Groups are of a fixed number, so that nothing depends on how many threads share them.
pub fn orbits(balance: &Balance, states: &[State]) -> Vec<Orbit> {
    let of = |group: &[State]| {
        let mut own = balance.twin(balance.cancel);
        group.iter().map(|s| Orbit::of(&mut own, &s.x, s.speed).unwrap_or_default()).collect::<Vec<_>>()
    };
    states.par_chunks(GROUP).map(of).collect::<Vec<_>>().concat()
}
