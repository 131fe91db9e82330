//! The motion of a rotor with movable masses, to be played.

use super::history::Columns;
use crate::diagnostic::Diagnostic;
use crate::model::part::Outline;
use crate::model::system::{System, Workspace};
use crate::outcome::{Animation, Arg, Circle, Message, Outcome};
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;
use serde::{Deserialize, Serialize};

/// Most frames: the rest of the outputs is left out evenly.
const MOST_FRAMES: usize = 600;
/// Share of the largest circle that the largest displacement takes, at most.
const SHARE: f64 = 0.25;

/// The motion of a rotor with movable masses, in axes that turn with it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RotorMotion {
    /// Times of the frames, s.
    pub times: Vec<f64>,
    /// Spin angles at them, rad.
    pub phases: Vec<f64>,
    /// Displacements of every body, m.
    pub bodies: Vec<Vec<[f64; 2]>>,
    /// Tracks and masses.
    pub circles: Vec<CircleMotion>,
}

/// A track or a mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CircleMotion {
    /// Its part and its own name.
    pub name: String,
    /// Radius, m.
    pub radius: f64,
    /// A movable mass, not its track.
    pub movable: bool,
    /// Displacement of its carrier, m.
    pub displacements: Vec<[f64; 2]>,
    /// Its centre relative to it, m.
    pub places: Vec<[f64; 2]>,
}

fn turned(x: [f64; 2], phase: f64) -> [f64; 2] {
    let (s, c) = phase.sin_cos();
    [c * x[0] + s * x[1], c * x[1] - s * x[0]]
}

/// The motion of a machine with movable masses; `None` of others.
pub(in crate::study) fn played(motion: &mut Motion, trajectory: &Trajectory) -> Option<RotorMotion> {
    let system = motion.system();
    let bodies = system.stations();
    let dim = trajectory.state.len().max(1);
    let stride = trajectory.times.len().div_ceil(MOST_FRAMES).max(1);
    let mut ws = Workspace::default();
    let mut out = RotorMotion { times: vec![], phases: vec![], bodies: vec![vec![]; bodies.len()], circles: vec![] };
    for (&t, y) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)).step_by(stride) {
        let phase = motion.spin(t, y).phase;
        let outlines = motion.with_point(t, y, |s, at| s.outlines(at, &mut ws)).ok()?;
        if out.times.is_empty() {
            let circle = |(slot, own): &(usize, Outline)| CircleMotion {
                name: format!("{} {}", system.slots()[*slot].name, own.name),
                radius: own.radius,
                movable: own.movable,
                displacements: vec![],
                places: vec![],
            };
            out.circles = outlines.iter().map(circle).collect();
        }
        for (circle, (_, o)) in out.circles.iter_mut().zip(outlines) {
            circle.displacements.push(turned(o.displacement, phase));
            circle.places.push(turned(o.place, phase));
        }
        for (own, b) in out.bodies.iter_mut().zip(bodies) {
            own.push(turned(b.lateral.of(y), phase));
        }
        out.times.push(t);
        out.phases.push(phase);
    }
    out.circles.iter().any(|c| c.movable).then_some(out)
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
pub(in crate::study) fn report(system: &System, rotor: &RotorMotion, outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let mut c = Columns::default();
    c.add("t", "s", "time", rotor.times.clone());
    c.add("phase", "rad", "spin angle", rotor.phases.clone());
    let mut pair = |name: &str, doc: &'static str, points: &[[f64; 2]]| {
        [("x", 0), ("y", 1)].map(|(k, i)| {
            let column = format!("{name}.{k}");
            c.add(&column, "m", doc, points.iter().map(|p| p[i]).collect());
            column
        })
    };
    let mut circles = Vec::new();
    let mut largest = (0.0f64, 0.0f64);
    for (body, points) in system.stations().iter().zip(&rotor.bodies) {
        let displacement = pair(&body.name, "displacement in axes that turn with the rotor", points);
        circles.push(Circle { name: Arg::name(&body.name), displacement, place: None, radius: 0.0, movable: false });
    }
    for own in &rotor.circles {
        let name = &own.name;
        let doc = "displacement of its centre in axes that turn with the rotor";
        let displacement = pair(&format!("{name}, carried"), doc, &own.displacements);
        let place = own.movable.then(|| pair(name, "place from there in axes that turn with the rotor", &own.places));
        largest.0 = own.displacements.iter().fold(largest.0, |most, [x, y]| most.max(x.hypot(*y)));
        largest.1 = largest.1.max(own.radius);
        circles.push(Circle { name: Arg::name(name), displacement, place, radius: own.radius, movable: own.movable });
    }
    let enlarged = round(SHARE * largest.1 / largest.0);
    let alt = Message::new("animation-alt").arg("enlarged", Arg::number(enlarged).digits(6));
    let animation = Animation {
        name: "motion".into(),
        title: "Rotor, tracks and balls".into(),
        alt,
        table: "animation".into(),
        time: "t".into(),
        phase: "phase".into(),
        enlarged,
        circles,
    };
    let table = c.table("animation", "Frames of the animation")?;
    Ok(outcome.table(table).animation(animation))
}
