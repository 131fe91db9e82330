//! What drives do: whether a free spin is caught by a vibration (Sommerfeld effect) before the speed it could reach, and whether they could follow a programme.
//!
//! Theory: `docs/theory/motors-and-run-up.md#speed-capture`.

use crate::model::part::{At, Rows};
use crate::model::system::{System, Workspace};
use crate::outcome::{Arg, Finding, SpecialPoint, Status};
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;
use laval_num::univariate::root;
use serde::{Deserialize, Serialize};

/// The speed rests when what still accelerates is below this share of the torque the vibration takes.
const RESTING: f64 = 0.05;
/// A speed below the one without vibration by less than this share is no capture.
const BELOW: f64 = 0.05;
/// A speed this close to the last one counts as caught.
const NEAR: f64 = 0.02;

/// Torques on a machine whose bodies do not move.
struct Quiet<'a> {
    system: &'a System,
    q: Vec<f64>,
    z: Vec<f64>,
    ws: Workspace<f64>,
}

impl Quiet<'_> {
    /// Torque of the drives left at a speed, N m, at a spin acceleration.
    fn surplus(&mut self, speed: f64, accel: f64) -> f64 {
        let (n, m) = (self.system.n(), self.system.m());
        let zero = vec![0.0; n];
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
        let at = At { q: &self.q, v: &zero, a: &zero, z: &self.z, phase: 0.0, speed, spin_accel: accel, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        self.system.residual(self.system.params(), &at, &mut rows, &mut self.ws, |_| true);
        -spin
    }
    /// The next higher speed where nothing is left; infinite when there is none.
    fn reachable(&mut self, speed: f64) -> f64 {
        let (mut a, mut fa) = (speed, self.surplus(speed, 0.0));
        for _ in 0..400 {
            let b = 1.03 * a;
            let fb = self.surplus(b, 0.0);
            if fa > 0.0 && fb <= 0.0 {
                return root(|w| Some(self.surplus(w, 0.0)), (a, fa), (b, fb), 1e-9 * b).unwrap_or(b);
            }
            (a, fa) = (b, fb);
        }
        f64::INFINITY
    }
}

/// A free spin that a vibration has caught.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Capture {
    /// Mean speed at the end, rad/s.
    pub speed: f64,
    /// Torque that the vibration takes, N m.
    pub torque: f64,
    /// Rate at which the speed still changes, rad/s^2.
    pub acceleration: f64,
    /// Speed without vibration, rad/s; none where it would rise on and on.
    pub without: Option<f64>,
    /// When the speed came near the one it has at the end, s.
    pub since: f64,
    /// Outputs between which it did, s.
    pub bracket: (f64, f64),
}

/// Whether a free spin was caught.
pub(in crate::study) fn capture(motion: &Motion, trajectory: &Trajectory) -> Option<Capture> {
    let system = motion.system();
    let count = trajectory.times.len();
    if !motion.is_free() || trajectory.left.is_some() || count < 20 {
        return None;
    }
    let dim = trajectory.state.len();
    let speeds: Vec<f64> =
        trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)).map(|(&t, y)| motion.spin(t, y).speed).collect();
    // the trend of a speed that swings about its mean: means over the last two tenths
    let tenth = count / 10;
    let mean = |range: std::ops::Range<usize>, x: &[f64]| x[range.clone()].iter().sum::<f64>() / range.len() as f64;
    let (late, before) = (count - tenth..count, count - 2 * tenth..count - tenth);
    let speed = mean(late.clone(), &speeds);
    let accel = (speed - mean(before.clone(), &speeds)) / (mean(late, &trajectory.times) - mean(before, &trajectory.times));
    let kinds = system.coordinates().iter().map(|c| c.dof.kind);
    let last = trajectory.states.chunks_exact(dim).next_back().unwrap_or(&trajectory.state);
    let q = kinds.zip(last).map(|(k, &q)| if k.leads_pair() || k.ends_pair() { 0.0 } else { q }).collect();
    let mut quiet = Quiet { system, q, z: vec![0.0; system.m()], ws: Workspace::default() };
    let (surplus, inertia) = (quiet.surplus(speed, 0.0), quiet.surplus(speed, 0.0) - quiet.surplus(speed, 1.0));
    let reachable = quiet.reachable(speed);
    let caught = speed > 0.0 && surplus > 0.0 && (inertia * accel).abs() < RESTING * surplus && speed < (1.0 - BELOW) * reachable;
    if !caught {
        return None;
    }
    let first = speeds.iter().rposition(|w| !((w - speed).abs() <= NEAR * speed)).map_or(0, |i| i + 1).min(count - 1);
    Some(Capture {
        speed,
        torque: surplus,
        acceleration: accel,
        without: Some(reachable).filter(|w| w.is_finite()),
        since: trajectory.times[first],
        bracket: (trajectory.times[first.saturating_sub(1)], trajectory.times[first]),
    })
}

impl Capture {
    /// The capture, and where it was.
    pub(in crate::study) fn report(&self) -> (Finding, SpecialPoint) {
        let finding = match self.without {
            Some(w) => Finding::warning("capture", "drive-captured").arg("reachable", Arg::speed(w)),
            None => Finding::warning("capture", "drive-captured-unlimited"),
        };
        let mut finding = finding
            .value(self.speed, "rad/s")
            .evidence("torque the vibration takes", self.torque, "N m")
            .evidence("power the vibration takes", self.torque * self.speed, "W")
            .evidence("speed still changes at", self.acceleration, "rad/s^2");
        if let Some(w) = self.without {
            finding = finding.evidence("speed without vibration", w, "rad/s");
        }
        let point = SpecialPoint::new("capture", self.since, self.bracket).status(Status::Bracketed).evidence("speed", self.speed, "rad/s");
        (finding.evidence("caught since", self.since, "s"), point)
    }
}

/// Share of a trajectory over which torques are averaged: the unbalance makes them swing.
const WINDOW: f64 = 0.02;

/// Whether the drives among the parts can follow a programme: where `torque` (N m) is missing beside theirs on average. Nothing without drives, nor where the inertia that
/// a change of speed takes is not known.
pub(in crate::study) fn short(system: &System, speeds: &[f64], torque: &[f64], accelerates: bool) -> Option<Finding> {
    let count = torque.len();
    let half = (0.5 * WINDOW * count as f64) as usize;
    let first = *speeds.first()?;
    if system.drive_torque(first).is_none() || (accelerates && !system.without_spin_inertia().is_empty()) {
        return None;
    }
    let mean = |i: usize| {
        let range = i.saturating_sub(half)..(i + half + 1).min(count);
        torque[range.clone()].iter().sum::<f64>() / range.len() as f64
    };
    let lacks: Vec<f64> = (0..count).map(mean).collect();
    let (at, most) = lacks.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
    if most <= 0.0 {
        return Some(Finding::info("drive_suffices", "drive-suffices").value(-most, "N m"));
    }
    let first = lacks.iter().position(|x| *x > 0.0).unwrap_or(at);
    let finding = Finding::warning("drive_short", "drive-short").value(most, "N m").arg("at", Arg::speed(speeds[at]));
    Some(finding.evidence("first at speed", speeds[first], "rad/s").evidence("most at speed", speeds[at], "rad/s"))
}

/// That spin acceleration and drive torque leave out parts whose inertia about the axis is 0.
pub(in crate::study) fn spin_inertia(system: &System) -> Option<Finding> {
    let missing = system.without_spin_inertia();
    (!missing.is_empty()).then(|| Finding::warning("spin_inertia", "drive-spin-inertia").arg("parameters", Arg::names(missing)))
}
