//! The motion of a rotor with movable masses, to be played.

use super::history::Columns;
use crate::diagnostic::Diagnostic;
use crate::model::part::Outline;
use crate::model::system::Workspace;
use crate::outcome::{Animation, Circle, Outcome, significant};
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;

/// Most frames: the rest of the outputs is left out evenly.
const MOST_FRAMES: usize = 600;
/// Share of the largest circle that the largest displacement takes, at most.
const SHARE: f64 = 0.25;

/// What is seen at an output: circles, bodies, both in axes that turn with the rotor.
struct Frame {
    t: f64,
    phase: f64,
    outlines: Vec<(usize, Outline)>,
    bodies: Vec<[f64; 2]>,
}

fn turned(x: [f64; 2], phase: f64) -> [f64; 2] {
    let (s, c) = phase.sin_cos();
    [c * x[0] + s * x[1], c * x[1] - s * x[0]]
}

fn frames(motion: &mut Motion, trajectory: &Trajectory) -> Option<Vec<Frame>> {
    let system = motion.system();
    let dim = trajectory.state.len().max(1);
    let stride = trajectory.times.len().div_ceil(MOST_FRAMES).max(1);
    let (mut ws, mut out) = (Workspace::default(), Vec::new());
    for (&t, y) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)).step_by(stride) {
        let phase = motion.spin(t, y).phase;
        let mut outlines = motion.with_point(t, y, |s, at| s.outlines(at, &mut ws)).ok()?;
        for (_, o) in &mut outlines {
            o.displacement = turned(o.displacement, phase);
            o.place = turned(o.place, phase);
        }
        let bodies = system.bodies().iter().map(|b| turned([y[b.x], y[b.x + 1]], phase)).collect();
        out.push(Frame { t, phase, outlines, bodies });
    }
    out.first().is_some_and(|f| f.outlines.iter().any(|o| o.1.movable)).then_some(out)
}

/// The largest of 1, 2, 5, 10 .. not above `x`, at least 1.
fn round(x: f64) -> f64 {
    if !(x > 1.0 && x.is_finite()) {
        return 1.0;
    }
    let power = 10f64.powf(x.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|r| *r <= x).unwrap_or(1.0)
}

/// Appends the animation of a machine with movable masses and the table of its frames.
///
/// # Errors
/// An outcome that does not hold together.
pub(in crate::study) fn report(motion: &mut Motion, trajectory: &Trajectory, outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let Some(frames) = frames(motion, trajectory) else { return Ok(outcome) };
    let system = motion.system();
    let mut c = Columns::default();
    let mut add = |name: &str, unit: &str, doc: &str, of: &dyn Fn(&Frame) -> f64| {
        c.add(name, unit, doc, frames.iter().map(of).collect());
        name.to_string()
    };
    let time = add("t", "s", "time", &|f| f.t);
    let phase = add("phase", "rad", "spin angle", &|f| f.phase);
    let mut pair = |name: &str, doc: &str, of: &dyn Fn(&Frame) -> [f64; 2]| {
        ["x", "y"].map(|k| add(&format!("{name}.{k}"), "m", doc, &|f| of(f)[usize::from(k == "y")]))
    };
    let mut circles = Vec::new();
    let mut largest = (0.0f64, 0.0f64);
    for (b, body) in system.bodies().iter().enumerate() {
        let displacement = pair(&body.name, "displacement in axes that turn with the rotor", &|f| f.bodies[b]);
        circles.push(Circle { name: body.name.clone(), displacement, place: None, radius: 0.0, movable: false });
    }
    for (k, (slot, own)) in frames[0].outlines.iter().enumerate() {
        let name = format!("{} {}", system.slots()[*slot].name, own.name);
        let displacement = pair(&format!("{name}, carried"), "displacement of its centre in axes that turn with the rotor", &|f| {
            f.outlines[k].1.displacement
        });
        let place = own.movable.then(|| pair(&name, "place from there in axes that turn with the rotor", &|f| f.outlines[k].1.place));
        for f in &frames {
            let [x, y] = f.outlines[k].1.displacement;
            largest.0 = largest.0.max(x.hypot(y));
        }
        largest.1 = largest.1.max(own.radius);
        circles.push(Circle { name, displacement, place, radius: own.radius, movable: own.movable });
    }
    let enlarged = round(SHARE * largest.1 / largest.0);
    let alt = format!(
        "Seen along the axis: the centres of the bodies with the key mark, tracks and balls. Displacements are drawn {} times as large as the tracks.",
        significant(enlarged, 6)
    );
    let animation = Animation {
        name: "motion".into(),
        title: "Rotor, tracks and balls".into(),
        alt,
        table: "animation".into(),
        time,
        phase,
        enlarged,
        circles,
    };
    let table = c.table("animation", "Frames of the animation")?;
    Ok(outcome.table(table).animation(animation))
}
