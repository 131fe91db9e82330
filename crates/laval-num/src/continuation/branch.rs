//! What a continuation returns: points, special points, ends, and the work done.

use super::branch_point::BranchPoint;
use super::fold::FoldPoint;
use crate::newton::{Cause, Work};
use serde::{Deserialize, Serialize};

/// A solution on a branch.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Arclength from the start, in scaled unknowns and parameter (sum of chords).
    pub s: f64,
    /// Parameter.
    pub p: f64,
    /// Unknowns.
    pub x: Vec<f64>,
    /// dp/ds.
    pub dp_ds: f64,
    /// dx/ds.
    pub dx_ds: Vec<f64>,
    /// dp/ds with the parameter in its scale: the parameter's component of the unit tangent, zero at a fold.
    pub slope: f64,
    /// Determinant of the Jacobian, rows scaled to unit length, bordered by the unit tangent. It keeps its sign along a regular branch,
    /// through folds too, and changes it at a simple branch point.
    pub determinant: f64,
    /// Scaled residual.
    pub residual: f64,
    /// The Newton step that would follow: the estimated error relative to the scales.
    pub error: f64,
    /// Newton steps taken.
    pub iterations: usize,
}

/// Why a step was refused.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Refusal {
    /// The corrector gave up.
    Corrector(Cause),
    /// The tangent turned too far.
    Angle,
    /// The corrector moved too far from the predicted point: another branch.
    Strayed,
    /// Monitored quantities changed too much.
    Monitor,
    /// The parameter moved by more than the problem allows there.
    Parameter,
    /// The branch seemed to turn back on itself without a branch point between.
    Reversal,
}

/// How a branch ends. Every end is a fact about the computation, none is a jump of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum End {
    /// The last point lies on the edge of the parameter range.
    Reached,
    /// No acceptable step above the smallest was found.
    StepTooSmall {
        /// Parameter of the last point.
        at: f64,
        /// What was wrong with the last attempt.
        why: Refusal,
    },
    /// The starting point does not converge: the branch has no points.
    NewtonFailed {
        /// Parameter.
        at: f64,
        /// Scaled residual.
        residual: f64,
        /// Why.
        cause: Cause,
    },
    /// As many points as allowed.
    MaxPoints,
    /// Stopped by the user; the points so far are kept.
    Cancelled,
    /// Back at the start, which is repeated as the last point.
    Closed,
}

/// Kind of a special point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// The branch turns back in the parameter.
    Fold,
    /// The parameter has an extremum at a point where another branch crosses (as on the bent branch of a pitchfork).
    ParameterExtremum,
    /// Another branch crosses.
    BranchPoint,
    /// The equations change their law and the tangent jumps, as where a contact closes.
    Corner,
    /// Zero of the user's test function of this index.
    User(usize),
}

/// How well a special point is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// Located, and found again by the extended system of a fold or branch point.
    Confirmed,
    /// Located by its test function on corrected points.
    Located,
    /// The bracket could not be narrowed to rounding, or the test function jumps instead of vanishing: only the bracket is certain.
    Bracketed,
}

/// One side of a bracket.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Side {
    /// Arclength.
    pub s: f64,
    /// Parameter.
    pub p: f64,
    /// Its derivative in arclength.
    pub dp_ds: f64,
    /// Test function.
    pub value: f64,
}

/// A point of a branch with a name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Special {
    /// What it is.
    pub kind: Kind,
    /// Where it is.
    pub point: Point,
    /// It lies between `points[after]` and the next.
    pub after: usize,
    /// Points around it where the test function has opposite signs.
    pub bracket: [Side; 2],
    /// Test function at the point: slope for a fold, determinant for a branch point.
    pub residual: f64,
    /// How well it is known.
    pub status: Status,
    /// For a fold: the same point by the extended system, and its distance.
    pub fold: Option<FoldPoint>,
    /// For a branch point, and an extremum of the parameter there: what the extended system gave, which is then its place.
    pub crossing: Option<BranchPoint>,
}

impl Special {
    /// Width of the bracket in the parameter.
    pub fn width(&self) -> f64 {
        let [Side { p: a, .. }, Side { p: b, .. }] = self.bracket;
        (a - b).abs()
    }

    /// Parameters between which it lies. Where the parameter turns back it lies beyond both sides of the bracket, by no more than their slopes allow.
    pub fn range(&self) -> (f64, f64) {
        if let Some(c) = &self.crossing {
            return (c.p - c.p_error, c.p + c.p_error);
        }
        let [a, b] = &self.bracket;
        let (low, high) = (a.p.min(b.p).min(self.point.p), a.p.max(b.p).max(self.point.p));
        let length = (b.s - a.s).abs();
        let reach = |sign: f64| {
            let beyond = [a, b].map(|s| sign * s.p + s.dp_ds.abs() * length);
            sign * beyond[0].min(beyond[1])
        };
        // rising to the extremum or falling to it
        match (a.dp_ds > 0.0, b.dp_ds > 0.0) {
            (false, true) => (low.min(reach(-1.0)), high),
            (true, false) => (low, high.max(reach(1.0))),
            _ => (low, high),
        }
    }
}

/// Work done and choices made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counters {
    /// Points kept.
    pub points: usize,
    /// Steps refused.
    pub refused: usize,
    /// Corrections spent on special points and ends.
    pub located: usize,
    /// Values of user tests that were not finite: no sign change can be seen next to these.
    pub undefined_tests: usize,
    /// Newton steps, evaluations, factorisations.
    pub work: Work,
}

/// A branch of solutions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Branch {
    /// Points in order of arclength.
    pub points: Vec<Point>,
    /// Special points in order of arclength.
    pub specials: Vec<Special>,
    /// How the branch ends at its first point, when it was followed both ways.
    pub first_end: Option<End>,
    /// How the branch ends at its last point.
    pub end: End,
    /// Work done.
    pub counters: Counters,
}

impl Branch {
    /// Special points of one kind.
    pub fn of(&self, kind: Kind) -> impl Iterator<Item = &Special> {
        self.specials.iter().filter(move |s| s.kind == kind)
    }

    /// The same branch with arclength running the other way.
    pub(super) fn reverse(&mut self) {
        let last = self.points.len().saturating_sub(1);
        let turn = |p: &mut Point| {
            p.s = -p.s;
            p.dp_ds = -p.dp_ds;
            p.slope = -p.slope;
            p.determinant = -p.determinant;
            p.dx_ds.iter_mut().for_each(|d| *d = -*d);
        };
        self.points.reverse();
        self.points.iter_mut().for_each(turn);
        self.specials.reverse();
        for special in &mut self.specials {
            turn(&mut special.point);
            special.after = last - 1 - special.after;
            special.bracket.reverse();
            let sign = if matches!(special.kind, Kind::User(_)) { 1.0 } else { -1.0 };
            special.residual *= sign;
            for side in &mut special.bracket {
                side.s = -side.s;
                side.dp_ds = -side.dp_ds;
                side.value *= sign;
            }
        }
    }
}
