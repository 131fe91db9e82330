//! What a nonlinear response is doing, for those who wait.

use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Stage, Step};
use crate::study::Context;
use crate::text;
use crate::text::Text;

/// Shows how far a response is, and the branch and the speed at which it is.
pub(in crate::study) fn progress(context: &Context, step: &Step) {
    context.progress.doing(&words(step));
    context.progress.report(step.done, 0);
}

fn words(step: &Step) -> Text {
    let speed = text::quantity(step.speed, "rad/s");
    match step.stage {
        Stage::Start => text!("steady response at {speed}", speed),
        Stage::Follow(Origin::Low) => text!("branch from the lowest speed, at {speed}", speed),
        Stage::Follow(Origin::High) => text!("branch from the highest speed, at {speed}", speed),
        Stage::Follow(_) => text!("further branch, at {speed}", speed),
        Stage::Assess(Origin::Low) => text!("stability of the branch from the lowest speed, at {speed}", speed),
        Stage::Assess(Origin::High) => text!("stability of the branch from the highest speed, at {speed}", speed),
        Stage::Assess(_) => text!("stability of a further branch, at {speed}", speed),
    }
}
