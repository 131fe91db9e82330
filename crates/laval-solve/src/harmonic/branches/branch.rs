//! A branch of the response with its points assessed: states, folds, other changes of stability, where it comes from.

use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::branches::bifurcation::{Change, changes_between};
use crate::harmonic::branches::on_determinant;
use crate::harmonic::branches::response::{Stage, Step, Tick};
use crate::harmonic::stability::determinant::{self, Effort, Shape};
use crate::harmonic::stability::floquet::{Exponents, Method, Stability, Unassessed};
use crate::model::system::System;
use crate::reduction::{Reduced, Reduction};
use laval_num::complex::C64;
use laval_num::continuation::{Branch, End, Kind, Point, Settings, Special, Status, Zero};
use laval_num::newton::{Options, newton};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// One point of the response.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Unknowns of the balance.
    pub x: Vec<f64>,
    /// Exponents, when they could be found.
    pub exponents: Option<Exponents>,
    /// Dropped force harmonics over kept ones.
    pub truncation: f64,
    /// A law switches along the motion (a contact opens or closes).
    pub switches: bool,
    /// Scaled residual.
    pub residual: f64,
}

impl State {
    /// Assessed stable; unknown counts as not.
    pub fn stable(&self) -> bool {
        self.exponents.as_ref().is_some_and(Exponents::stable)
    }
    /// Assessed unstable; unknown counts as not.
    pub fn unstable(&self) -> bool {
        self.exponents.as_ref().is_some_and(|e| !e.stable())
    }
    /// Largest growth rate, 1/s; NaN when not assessed, or where no exponent is known and none grows.
    pub fn growth(&self) -> f64 {
        self.exponents.as_ref().filter(|e| !e.values.is_empty()).map_or(f64::NAN, Exponents::growth)
    }
}

/// A fold of the response, and how well it is known.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Fold {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Unknowns there.
    pub x: Vec<f64>,
    /// Speeds of corrected points on both sides along the branch, where the slope dW/ds has opposite signs.
    pub bracket: (f64, f64),
    /// Scaled residual of the extended system, when it confirmed the fold.
    pub residual: f64,
    /// Change of the speed between the branch's location and the extended system, rad/s.
    pub methods_differ: f64,
    /// Change of the speed when four more orders are kept, rad/s; NaN when that did not converge.
    pub harmonics_change: f64,
    /// The extended system found it too.
    pub confirmed: bool,
    /// The branch turns back at a corner, where a law switches (as where a contact closes): sharply, not like a parabola.
    pub corner: bool,
    /// It lies between this point of the branch and the next.
    pub after: usize,
    /// The branch turns back from speeds rising in magnitude here (else from falling ones).
    pub upper: bool,
}

/// Where a branch comes from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Origin {
    /// Followed from the end of the range where the rotor turns slowly.
    Low,
    /// Followed from the other end.
    High,
    /// Branches off where another branch, by index, loses its symmetry at this speed, rad/s.
    Broken(usize, f64),
    /// Branches off where another branch, by index, doubles its period at this speed, rad/s.
    Doubled(usize, f64),
    /// Crosses another branch, by index, at this speed, rad/s.
    Crossing(usize, f64),
    /// x moves as on one known state, y as on another.
    Mixed,
    /// Found with a component of the spin frequency over this number.
    Subharmonic(usize),
    /// Found from a start taken anywhere.
    Start,
}

/// A branch with its points assessed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Traced {
    /// Points in order along the branch.
    pub points: Vec<State>,
    /// Folds in the same order.
    pub folds: Vec<Fold>,
    /// Other changes of stability.
    pub changes: Vec<Change>,
    /// Simple branch points met: the determinant of the equations changes its sign with the speed running on.
    pub branch_points: Vec<Point>,
    /// Where it comes from.
    pub origin: Origin,
    /// How it ended; of a branch followed both ways, the end that is not the range's, if there is one.
    pub end: End,
    /// What its unknowns mean.
    pub discretisation: Discretisation,
    /// How many branches it stands for: turned by the symmetry of the machine, or later by a turn of the rotor.
    pub images: usize,
}

impl Traced {
    /// Followed from the end of the range where the rotor turns slowly.
    pub fn from_low(&self) -> bool {
        self.origin == Origin::Low
    }
    /// Period in turns of the rotor.
    pub fn turns(&self) -> usize {
        self.discretisation.divisor
    }
    /// Maps over the period that were integrated for its points.
    pub(super) fn maps(&self) -> u64 {
        self.points.iter().filter(|p| p.exponents.as_ref().is_some_and(|e| e.method == Method::Map)).count() as u64
    }
}

/// Assesses states of one machine.
pub struct Assessor {
    /// `None` where stability was not requested or cannot be had.
    pub(in crate::harmonic) stability: Option<Stability>,
    /// Of a machine with parts that have no time form: exponents of the motion assessed last.
    pub(super) exponents: Option<Vec<C64>>,
    /// Terms of Hill's determinants that may still be added up.
    terms: u64,
    given: u64,
    /// Why stability was not assessed.
    pub unassessed: Option<Unassessed>,
    /// What the machine was reduced to, with the largest error.
    pub reduced: Option<Reduced>,
}

/// Points of a branch that one thread assesses together.
pub(super) const GROUP: usize = 32;
/// Exponents that decay and are followed from motion to motion.
const FOLLOWED: usize = 8;
/// Most terms of Hill's determinants for one branch.
const MOST_TERMS: u64 = 400_000_000;
/// Terms of Hill's determinants that are as much work as a point of a branch.
pub const POINT: u64 = 50_000;

impl Assessor {
    /// With `wanted`, of stability too; `work` in points. Everything on Hill's determinant where `determinant` says so.
    pub fn new(system: &System, (wanted, determinant): (bool, bool), work: u64) -> Assessor {
        let given = work.saturating_mul(POINT).min(MOST_TERMS);
        let assessor = Assessor { stability: None, exponents: None, terms: given, given, unassessed: None, reduced: None };
        match wanted.then(|| Stability::new(system)) {
            None => assessor,
            _ if determinant && system.undeclared().is_none() => Assessor { exponents: Some(Vec::new()), ..assessor },
            Some(Ok(s)) => Assessor { stability: Some(s), ..assessor },
            Some(Err(Unassessed::NoTimeForm(..))) if system.undeclared().is_none() => Assessor { exponents: Some(Vec::new()), ..assessor },
            Some(Err(why)) => Assessor { unassessed: Some(why), ..assessor },
        }
    }

    /// The exponent of a motion that a start leads to, no further from it than `within`; `None` where there is none or the work is used up.
    pub(in crate::harmonic) fn followed(&mut self, balance: &Balance, x: &[f64], speed: f64, start: (C64, f64)) -> Option<C64> {
        let mut effort = Effort { terms: self.terms, cancel: balance.cancel };
        let found = determinant::followed(balance.system, balance.discretisation(), x, speed, start, &mut effort);
        self.terms = effort.terms;
        found
    }

    /// How the machine moves at an exponent of a motion.
    pub(in crate::harmonic) fn shape(&mut self, balance: &Balance, x: &[f64], speed: f64, exponent: C64) -> Option<Shape> {
        let mut effort = Effort { terms: self.terms, cancel: balance.cancel };
        let found = determinant::shape(balance.system, balance.discretisation(), x, speed, exponent, &mut effort);
        self.terms = effort.terms;
        found
    }

    /// Terms of Hill's determinants that were added up.
    pub(super) fn spent(&self) -> u64 {
        self.given - self.terms
    }

    /// What there is to say of a motion.
    pub(in crate::harmonic) fn state(&mut self, balance: &mut Balance, x: &[f64], speed: f64) -> State {
        balance.sample(x, speed);
        let mut state =
            State { speed, x: x.to_vec(), exponents: None, truncation: balance.truncation(), switches: false, residual: f64::NAN };
        state.switches = !balance.switches(x, speed, (0.0, TAU / balance.terms.symmetry.order().max(1) as f64)).0.is_empty();
        if let Some(s) = &mut self.stability {
            match s.exponents(balance, x, speed) {
                Ok(e) => state.exponents = Some(e),
                Err(why) => self.unassessed = Some(why),
            }
            self.reduced = Reduced::worse(self.reduced, s.reduction().map(Reduction::summary));
        }
        if let Some(before) = &mut self.exponents {
            let mut effort = Effort { terms: self.terms, cancel: balance.cancel };
            let found = determinant::exponents(balance.system, balance.discretisation(), x, speed, before, &mut effort);
            self.terms = effort.terms;
            match found {
                Ok(e) => {
                    // in descending order
                    *before = e.values.iter().take(e.unstable() + FOLLOWED).copied().collect();
                    state.exponents = Some(e);
                }
                // a count that was stopped says nothing of its work
                Err(_) if balance.cancelled() => {}
                Err(why) => self.unassessed = Some(why),
            }
        }
        state
    }

    /// The points of a branch one after the other: exponents by determinants are led from point to point.
    fn points_in_turn(&mut self, balance: &mut Balance, branch: &Branch, origin: Origin, tick: Tick) -> Vec<State> {
        let mut points = Vec::with_capacity(branch.points.len());
        for p in &branch.points {
            if balance.cancelled() {
                break;
            }
            let state = self.polished(balance, p);
            if balance.cancelled() && state.exponents.is_none() {
                break;
            }
            points.push(state);
            tick(Step { done: points.len() as u64, stage: Stage::Assess(origin), speed: p.p });
        }
        points
    }

    /// The points of a branch in groups of a fixed number, so that nothing depends on how many threads share them.
    fn points_side_by_side(&mut self, balance: &Balance, branch: &Branch, origin: Origin, tick: Tick) -> Vec<State> {
        let done = AtomicU64::new(0);
        let workers: Mutex<Vec<(Balance, Assessor)>> = Mutex::new(Vec::new());
        let wanted = self.stability.is_some();
        let assess = |group: &[Point]| {
            let ready = workers.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let (mut own, mut assessor) =
                ready.unwrap_or_else(|| (balance.twin(balance.cancel), Assessor::new(balance.system, (wanted, false), 0)));
            assessor.begin();
            let mut states = Vec::with_capacity(group.len());
            for p in group {
                if own.cancelled() {
                    break;
                }
                states.push(assessor.polished(&mut own, p));
                let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                if done % 16 == 1 {
                    tick(Step { done, stage: Stage::Assess(origin), speed: p.p });
                }
            }
            let found = (states, assessor.unassessed.take(), assessor.reduced.take());
            workers.lock().unwrap_or_else(PoisonError::into_inner).push((own, assessor));
            found
        };
        let groups: Vec<_> = branch.points.par_chunks(GROUP).map(assess).collect();
        let mut points = Vec::with_capacity(branch.points.len());
        for (group, (states, unassessed, reduced)) in branch.points.chunks(GROUP).zip(groups) {
            let complete = states.len() == group.len();
            points.extend(states);
            self.unassessed = unassessed.or(self.unassessed.take());
            self.reduced = Reduced::worse(self.reduced, reduced);
            if !complete {
                break;
            }
        }
        points
    }

    /// Forgets the motions assessed before.
    fn begin(&mut self) {
        if let Some(s) = &mut self.stability {
            s.begin();
        }
    }

    /// A point of a branch, solved to rounding, assessed.
    fn polished(&mut self, balance: &mut Balance, p: &Point) -> State {
        let (x, residual) = polish(balance, &p.x, p.p).unwrap_or_else(|| (p.x.clone(), p.residual));
        State { residual, ..self.state(balance, &x, p.p) }
    }

    /// All points of a branch, its folds, and the other changes of stability on it; `tick` receives how many points are done.
    pub fn branch(&mut self, balance: &mut Balance, branch: Branch, origin: Origin, settings: &Settings, tick: Tick) -> Traced {
        let points = if self.exponents.is_some() {
            self.points_in_turn(balance, &branch, origin, tick)
        } else {
            self.points_side_by_side(balance, &branch, origin, tick)
        };
        let folds = branch.of(Kind::Fold).map(|s| fold_of(s, &branch)).collect::<Vec<_>>();
        let mut changes = Vec::new();
        let assessed: Vec<usize> = (0..points.len()).filter(|&i| points[i].exponents.is_some()).collect();
        for pair in assessed.windows(2) {
            let (i, j) = (pair[0], pair[1]);
            let (Some(a), Some(b)) = (&points[i].exponents, &points[j].exponents) else { continue };
            // at a fold on a corner the point between belongs to either side
            let corner = folds.iter().any(|f| f.corner && f.after + 1 >= i && f.after < j);
            if corner || balance.cancelled() {
                continue;
            }
            // the exponents that decay are not all known: none can be numbered
            if a.method == Method::Determinant {
                on_determinant::changes_between(self, balance, (&branch, &points), (i, j), settings, &mut changes);
            } else if j == i + 1 {
                let fold = branch.of(Kind::Fold).chain(branch.of(Kind::ParameterExtremum)).find(|s| s.after == i);
                let ends = [(&branch.points[i], a), (&branch.points[j], b)];
                changes_between(self, balance, ends, i, fold, settings, &mut changes);
            }
        }
        let cut = points.len() < branch.points.len();
        let end = match (branch.first_end, branch.end) {
            _ if cut => End::Cancelled,
            (Some(first), End::Reached) => first,
            (_, end) => end,
        };
        let branch_points = branch.of(Kind::BranchPoint).map(|s| s.point.clone()).collect();
        let discretisation = balance.discretisation();
        Traced { points, folds, changes, branch_points, origin, end, discretisation, images: 1 }
    }
}

/// A point of a branch solved to rounding at its speed (the corrector stops at its tolerance), unless a fold is so near that it would leave.
fn polish(balance: &mut Balance, x: &[f64], speed: f64) -> Option<(Vec<f64>, f64)> {
    let mut y = x.to_vec();
    let done = newton(balance, &mut y, speed, &Options { to_rounding: true, ..Options::default() }).ok()?;
    let near = x.iter().zip(&y).zip(balance.scales()).all(|((a, b), s)| (a - b).abs() <= 1e-3 * s.max(a.abs()));
    near.then_some((y, done.residual))
}

fn fold_of(s: &Special, branch: &Branch) -> Fold {
    let confirmed = s.status == Status::Confirmed;
    let polished = s.fold.as_ref();
    let speed = polished.map_or(s.point.p, |f| f.p);
    Fold {
        speed,
        x: polished.map_or_else(|| s.point.x.clone(), |f| f.x.clone()),
        bracket: (s.bracket[0].p, s.bracket[1].p),
        residual: polished.map_or(s.residual, |f| f.residual),
        methods_differ: polished.map_or(f64::NAN, |f| f.p_difference),
        harmonics_change: f64::NAN,
        confirmed,
        corner: branch.of(Kind::Corner).any(|c| c.after == s.after && c.point.p == s.point.p),
        after: s.after,
        upper: branch.points[s.after].p < speed || branch.points[s.after].slope > 0.0,
    }
}
