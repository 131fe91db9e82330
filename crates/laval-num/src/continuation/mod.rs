//! Branches of solutions of `r(x, p) = 0` followed by pseudo-arclength, with their folds, branch points and zeros of test functions.
//!
//! Unknowns and parameter are divided by their scales. A step predicts along the tangent and its change, corrects by Newton's method in
//! the hyperplane normal to the tangent, and is accepted when tangent and chord turn little, the corrector contracts well and stays near,
//! and both the parameter and the monitored quantities have moved no more than allowed. The tangent comes from the Jacobian bordered by
//! the old tangent, regular at folds. Its determinant keeps its sign along a regular branch: a change is either a branch point, where it
//! vanishes, or a step onto the wrong side of a sharp turn, which is refused.
//!
//! Where the equations have a kink (a contact closes) the tangent jumps: such a corner is located, and the branch goes on beyond it.
//!
//! Sharp resonances in quantities that hardly move the unknowns are seen through [`Zero::measure`] and [`Zero::max_parameter_step`].
//! Close pairs of folds are found from the dip of dp/ds that the cubic through two points and their tangents shows. Not seen: an even
//! number of branch points or of zeros of a user's test within one step.

mod augmented;
mod branch;
mod branch_point;
mod chord;
mod corner;
mod cross;
mod event;
mod fold;
mod problem;
mod settings;
mod step;
mod trace;

pub use branch::{Branch, Counters, End, Kind, Point, Refusal, Side, Special, Status};
pub use branch_point::BranchPoint;
pub use chord::Chord;
pub use cross::{Crossing, cross, zero_between};
pub use event::Test;
pub use fold::{FoldPoint, fold};
pub use problem::{Failure, Zero, resonance_cap};
pub use settings::{Invalid, Settings};
pub use trace::{Direction, trace, trace_both};

#[cfg(test)]
mod tests;
