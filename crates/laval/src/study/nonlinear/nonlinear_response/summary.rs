//! A response in a few numbers: what a study of many machines keeps of each.

use super::measuring::Measuring;
use super::shown::{end, worst};
use super::stretches::{ranges_of, unstable_runs};
use super::sweeps::{jumps, swept};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome;
use crate::solve::harmonic::branches::bifurcation::Event;
use crate::solve::harmonic::branches::branch::{Origin, POINT, Traced};
use crate::solve::harmonic::branches::response::{Request, Response, respond};
use crate::study::shared::validity::Uses;
use laval_num::continuation::End;
use laval_num::order::{SortByNumber, ascending};
use std::sync::atomic::AtomicBool;

/// What a slow sweep does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sweep {
    /// Jumps first at this speed, rad/s.
    Jumps(f64),
    /// Goes on to the end of the range.
    Passes,
    /// Its states could not be followed to the end.
    Unfinished,
    /// Its states are unstable where they would jump first.
    Unstable,
}

impl Sweep {
    /// Where it jumps, rad/s; NaN where it does not.
    pub fn speed(self) -> f64 {
        if let Sweep::Jumps(w) = self { w } else { f64::NAN }
    }
}

/// The largest stable displacement or tilt of any body over a period.
#[derive(Clone, Debug, PartialEq)]
pub struct Top {
    /// Name of the body, or of a point of it.
    pub body: String,
    /// Displacement, m, or tilt, rad.
    pub size: f64,
    /// Speed, rad/s.
    pub speed: f64,
    /// It lies at an end of the range of speeds.
    pub at_end: bool,
}

/// A response in a few numbers. Speeds in rad/s.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Folds of all branches.
    pub folds: usize,
    /// Of the slow sweeps up and down.
    pub sweeps: [Sweep; 2],
    /// Width of the speeds at which the branches hold more than one state; NaN where a branch could not be followed to its end.
    pub hysteresis: f64,
    /// Such speeds reach an end of the range.
    pub open: bool,
    /// The largest displacement; `None` where it still rises where a branch was left, and where nothing but tilts.
    pub top: Option<Top>,
    /// The largest tilt; `None` where it still rises where a branch was left, and where nothing tilts.
    pub tilt: Option<Top>,
    /// A branch was left while its displacement or tilt still rose above all others.
    pub rising: bool,
    /// Ranges in which states are unstable for another reason than lying between two folds.
    pub unstable: Vec<(f64, f64)>,
    /// Changes of stability away from folds.
    pub changes: Vec<(Event, f64)>,
    /// Fastest growth in these ranges, 1/s; zero where there are none, NaN where stability is not known.
    pub growth: f64,
    /// Largest use of a part's validity, and of what.
    pub validity: (f64, String),
    /// Dropped over kept force harmonics, worst point.
    pub truncation: f64,
    /// Orders kept.
    pub orders: usize,
    /// Points computed.
    pub points: u64,
    /// Work in points, the assessing of machines with parts that have no time form included.
    pub work: u64,
    /// Why stability of some states was not assessed.
    pub unassessed: Option<String>,
    /// How it ended.
    pub end: outcome::End,
}

impl Summary {
    /// The response of a machine as `nonlinear_response` finds it, with the states of the branches from both ends.
    ///
    /// # Errors
    /// As [`respond`].
    pub fn of(system: &System, request: &Request, cancel: &AtomicBool) -> Result<Summary, Diagnostic> {
        let response = respond(system, request, cancel, &|_| {})?;
        let mut measuring = Measuring::of_sizes(system, &response, request)?;
        measuring.measure(&response);
        let displaced = measuring.measured.displaced(&measuring.probes);
        let mut rises = false;
        let mut top = |tilt: bool, counts: bool| {
            let (largest, rising) = measuring.peaks(&response, request, tilt);
            let rising = rising.is_some() && counts;
            rises |= rising;
            let most = largest.into_iter().filter(|_| counts && !rising).max_by(|a, b| a.best().0.total_cmp(&b.best().0))?;
            let (size, speed) = most.best();
            Some(Top { size, speed, at_end: most.at_end, body: most.owner })
        };
        let (top, tilt) = (top(false, displaced), top(true, true));
        let (hysteresis, open) = several(&response, request.speeds);
        let mut unstable: Vec<(f64, f64)> = response.branches.iter().flat_map(|b| ranges_of(b, unstable_runs(b))).collect();
        unstable.sort_by_number(|a| a.0);
        let assessed = request.stability && response.unassessed.is_none();
        let points = |b: &'_ Traced| unstable_runs(b).into_iter().flatten().map(|i| b.points[i].growth()).collect::<Vec<_>>();
        let growing = response.branches.iter().flat_map(points);
        let growth = if assessed { growing.fold(0.0, f64::max) } else { f64::NAN };
        let mut uses = Uses::default();
        measuring.measured.validity.iter().flatten().for_each(|u| uses.join(u));
        Ok(Summary {
            folds: response.branches.iter().map(|b| b.folds.len()).sum(),
            sweeps: [true, false].map(|up| sweep(&response, up, request.speeds)),
            hysteresis,
            open,
            top,
            tilt,
            rising: rises,
            unstable,
            changes: response.branches.iter().flat_map(|b| &b.changes).map(|c| (c.event, c.speed)).collect(),
            growth,
            validity: uses.worst(system),
            truncation: worst(&response, |p| p.truncation),
            orders: response.discretisation.harmonics,
            points: response.branches.iter().map(|b| b.points.len() as u64).sum(),
            work: response.branches.iter().map(|b| b.points.len() as u64).sum::<u64>() + response.assessing / POINT,
            unassessed: response.unassessed.as_ref().map(ToString::to_string),
            end: end(&response),
        })
    }

    /// Neimark-Sacker points, rad/s, rising.
    pub fn neimark_sacker(&self) -> Vec<f64> {
        let mut out: Vec<f64> = self.changes.iter().filter(|c| c.0 == Event::NeimarkSacker).map(|c| c.1).collect();
        ascending(&mut out);
        out
    }
}

fn sweep(response: &Response, up: bool, speeds: (f64, f64)) -> Sweep {
    let Some(branch) = swept(response, up, speeds) else { return Sweep::Unfinished };
    match jumps(response, branch, up).first() {
        Some(jump) if jump.unstable.is_some() => Sweep::Unstable,
        Some(jump) => Sweep::Jumps(jump.fold.speed),
        None if branch.end == End::Reached => Sweep::Passes,
        None => Sweep::Unfinished,
    }
}

/// Width of the speeds at which the branches from both ends hold more than one state, and whether such speeds reach an end of the range. Between its
/// folds the speed along a branch only rises or only falls.
fn several(response: &Response, (lo, hi): (f64, f64)) -> (f64, bool) {
    let main = || response.branches.iter().filter(|b| matches!(b.origin, Origin::Low | Origin::High));
    if main().any(|b| !matches!(b.end, End::Reached | End::Closed)) {
        return (f64::NAN, false);
    }
    let pieces: Vec<(f64, f64)> = main().flat_map(pieces).collect();
    let mut edges: Vec<f64> = pieces.iter().flat_map(|p| [p.0, p.1]).collect();
    ascending(&mut edges);
    let (mut width, mut open) = (0.0, false);
    let mut from: Option<f64> = None;
    for pair in edges.windows(2) {
        let held = pieces.iter().filter(|p| p.0 <= pair[0] && pair[1] <= p.1).count();
        if pair[0] < pair[1] && held < 2 {
            // one difference for each interval: of two folds exactly that of their speeds
            width += from.take().map_or(0.0, |a| pair[0] - a);
        } else if pair[0] < pair[1] {
            from.get_or_insert(pair[0]);
            open |= pair[0] == lo || pair[1] == hi;
        }
    }
    if let (Some(a), Some(b)) = (from, edges.last()) {
        width += b - a;
    }
    (width, open)
}

/// Intervals of speed of a branch from fold to fold.
fn pieces(branch: &Traced) -> Vec<(f64, f64)> {
    let (Some(first), Some(last)) = (branch.points.first(), branch.points.last()) else { return Vec::new() };
    let turns = branch.folds.iter().map(|f| f.speed);
    let ends: Vec<f64> = [first.speed].into_iter().chain(turns).chain([last.speed]).collect();
    ends.windows(2).map(|w| (w[0].min(w[1]), w[0].max(w[1]))).collect()
}
