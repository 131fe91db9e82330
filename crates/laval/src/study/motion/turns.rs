//! The path of the bodies over the last turns of the rotor, where the outputs requested are too far apart to draw it.

use super::history::Columns;
use super::record::{LastTurns, Series};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Message, Table};
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;
use crate::solve::programme::Spin;
use laval_num::order::ascending;
use std::f64::consts::TAU;

/// Fewer outputs a turn draw polygons.
const COARSE: f64 = 16.0;
/// Turns shown, and samples in each.
const TURNS: usize = 12;
const SAMPLES: usize = 48;

/// The rotor turns too far between outputs for lines through them to be the motion.
pub(in crate::study) fn coarse(spins: &[Spin]) -> bool {
    spins.windows(2).any(|w| (w[1].phase - w[0].phase).abs() > TAU / COARSE)
}

/// Times of the samples of the last turns.
pub(in crate::study) struct Turns(Vec<f64>);

impl Turns {
    /// `None` where the outputs resolve the motion. `end` is the spin at the end of the programme, `fastest` its largest speed (rad/s).
    pub fn beside(outputs: &[f64], end: Spin, fastest: f64) -> Option<Turns> {
        let widest = outputs.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
        let t_end = *outputs.last()?;
        let first = t_end - TURNS as f64 * TAU / end.speed.abs();
        if !(widest * fastest.abs() > TAU / COARSE) || !(first >= 0.0) {
            return None;
        }
        let count = TURNS * SAMPLES;
        Some(Turns((0..=count).map(|k| if k == count { t_end } else { first + (t_end - first) * k as f64 / count as f64 }).collect()))
    }

    /// The times of these outputs and of the samples, each once, rising.
    pub fn with_outputs(&self, outputs: &[f64]) -> Vec<f64> {
        merged(self.0.iter().copied(), outputs)
    }

    /// Takes the samples out of a trajectory, which keeps the outputs requested besides: the path, if the trajectory came so far.
    pub fn taken(&self, motion: &Motion, trajectory: &mut Trajectory, outputs: &[f64]) -> Option<LastTurns> {
        let stations = motion.system().stations();
        let (mut times, mut path) = (Vec::new(), vec![Vec::new(); 2 * stations.len()]);
        separated(trajectory, self.0.iter().copied(), outputs, |t, y| {
            times.push(t);
            path.iter_mut().zip(stations.iter().flat_map(|s| s.lateral.of(y))).for_each(|(p, x)| p.push(x));
        });
        if times.len() != self.0.len() || stations.is_empty() {
            return None;
        }
        let names = stations.iter().flat_map(|s| s.columns());
        Some(LastTurns { times, coordinates: names.zip(path).map(|(name, values)| Series { name, unit: "m".into(), values }).collect() })
    }
}

/// The last turns as a table.
///
/// # Errors
/// A table that contradicts itself.
pub(in crate::study) fn table(last: &LastTurns) -> Result<Table, Diagnostic> {
    let mut columns = Columns::default();
    columns.add("t", "s", "time", last.times.clone());
    columns.all(&last.coordinates, "coordinate");
    columns
        .table("last turns", Message::new("history-table-last-turns").arg("turns", Arg::count(TURNS)).arg("samples", Arg::count(SAMPLES)))
}

/// Two rising lists of times as one, each time once.
pub(in crate::study) fn merged(samples: impl Iterator<Item = f64>, outputs: &[f64]) -> Vec<f64> {
    let mut all: Vec<f64> = samples.chain(outputs.iter().copied()).collect();
    ascending(&mut all);
    all.dedup();
    all
}

/// Shows the samples of a trajectory and leaves it the outputs requested.
pub(in crate::study) fn separated(
    trajectory: &mut Trajectory,
    samples: impl Iterator<Item = f64>,
    outputs: &[f64],
    mut sample: impl FnMut(f64, &[f64]),
) {
    let dim = trajectory.state.len().max(1);
    let (mut times, mut states) = (Vec::with_capacity(outputs.len()), Vec::with_capacity(outputs.len() * dim));
    let (mut next, mut output) = (samples.peekable(), outputs.iter().peekable());
    for (&t, y) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim)) {
        if next.next_if(|s| *s == t).is_some() {
            sample(t, y);
        }
        if output.next_if(|o| **o == t).is_some() {
            times.push(t);
            states.extend_from_slice(y);
        }
    }
    (trajectory.times, trajectory.states) = (times, states);
}
