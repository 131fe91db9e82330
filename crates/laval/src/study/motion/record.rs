//! Motions in time as plain data: all that is reported of a motion, without the machine in time that moved.

pub use super::animation::{CircleMotion, RotorMotion};
pub use super::balance::{Balancing, Caught};
pub use super::drive::Capture;
pub use super::history::energy::EnergyAccount;
pub use super::moved_roots::MovedRoots;
pub use super::spectra::{NaturalFrequency, Part, Window as SpectrumWindow};
pub use super::steady_state::stored::{SettledMotion, Settling};

use super::history::per_second;
use super::start::Start;
use super::{animation, balance};
use crate::diagnostic::Diagnostic;
use crate::model::part::{Physics, TimeForm};
use crate::model::system::{GlobalDof, Slot, Station, System, Workspace};
use crate::solve::motion::Motion;
use crate::solve::motion::envelope::{Peak, Window};
use crate::solve::motion::trajectory::{Left, Tilting, Trajectory, Use};
use crate::solve::programme::Spin;
use crate::solve::reduced_machine::ReducedMachine;
use crate::solve::reduction::Reduced;
use crate::text;
use laval_num::ode::Run;
use laval_num::text::Text;
use serde::{Deserialize, Serialize};

/// A quantity at the outputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Name, such as `drum.x`.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// Values; NaN where there is none.
    pub values: Vec<f64>,
}

/// The whole state of a machine in time at one moment, from which another motion can start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotionState {
    /// When, s.
    pub t: f64,
    /// Coordinates of the machine.
    pub coordinates: Vec<f64>,
    /// Their rates.
    pub rates: Vec<f64>,
    /// Internal states of its form in time, memory states included.
    pub states: Vec<f64>,
    /// Spin angle, speed and acceleration (0 of a free spin).
    pub spin: Spin,
}

impl MotionState {
    pub(in crate::study) fn of(motion: &Motion, t: f64, y: &[f64]) -> Self {
        let (n, m) = (motion.system().n(), motion.system().m());
        // of the machine as it is written
        let whole = |x: &[f64]| motion.system().projection().map_or_else(|| x.to_vec(), |p| p.all(x));
        MotionState {
            t,
            coordinates: whole(&y[..n]),
            rates: whole(&y[n..2 * n]),
            states: y[2 * n..2 * n + m].to_vec(),
            spin: motion.spin(t, y),
        }
    }

    /// Writes it into a state of a machine in time.
    ///
    /// # Errors
    /// A state of a machine with another number of coordinates or internal states.
    pub(in crate::study) fn write(&self, motion: &Motion, reduced: Option<&ReducedMachine>, y: &mut [f64]) -> Result<(), Diagnostic> {
        let m = motion.system().m();
        let n = motion.system().projection().map_or(motion.system().n(), |p| p.coordinates.len());
        if (self.coordinates.len(), self.rates.len(), self.states.len()) != (n, n, m) {
            let message = text!(
                "a state of {coordinates} coordinates and {states} internal states is not one of this machine, which has {n} and in time {m}",
                coordinates = self.coordinates.len(),
                states = self.states.len(),
                n,
                m
            );
            return Err(Diagnostic::error("transient.start", message).help(text!("continue from a motion of the same machine")));
        }
        let whole = [&self.coordinates[..], &self.rates, &self.states].concat();
        let own = reduced.map_or(whole.clone(), |r| r.state(&whole));
        y[..own.len()].copy_from_slice(&own);
        if let Some(k) = motion.spin_start() {
            (y[k], y[k + 1]) = (self.spin.phase, self.spin.speed);
        }
        Ok(())
    }
}

/// Use of a statement of validity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ValidityUse {
    /// How far it is used.
    pub of: Use,
    /// Spin speed when it was seen above 1 for the first time, rad/s; of a free spin at the output before.
    pub speed_first: Option<f64>,
    /// The same for the last time.
    pub speed_then: Option<f64>,
}

/// A rational form that stood for a part in time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct UsedForm {
    /// Name of the part.
    pub part: String,
    /// Largest relative error.
    pub error: f64,
    /// Its internal states, and for which motions the error holds; none of the fit of a part's own frequency form.
    pub states: Option<FormStates>,
}

/// Size and scope of a rational form.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FormStates {
    /// Number of internal states.
    pub count: usize,
    /// Motions for which the error holds, as a phrase.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub scope: Text,
}

/// Forms that stand for exact parts in a machine in time.
pub(in crate::study) fn exact_parts(timed: &System) -> Vec<UsedForm> {
    let one = |slot: &Slot| {
        let f = slot.part.replaced_in_time().and_then(|r| r.fitted())?;
        let states = Some(FormStates { count: f.states, scope: f.scope });
        Some(UsedForm { part: slot.name.clone(), error: f.error, states })
    };
    timed.slots().iter().filter_map(one).collect()
}

/// All forms of a machine in time.
fn forms(timed: &System) -> Vec<UsedForm> {
    let mut out = exact_parts(timed);
    for slot in timed.slots() {
        if let Physics::Frequency(TimeForm::Fit(error)) = slot.physics {
            out.push(UsedForm { part: slot.name.clone(), error, states: None });
        }
    }
    out
}

/// Motion of the bodies over the last turns of the rotor, closer together than the outputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LastTurns {
    /// Times, s.
    pub times: Vec<f64>,
    /// Coordinates of the bodies.
    pub coordinates: Vec<Series>,
}

/// A motion in time.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MotionRecord {
    /// Times of the outputs reached, s.
    pub times: Vec<f64>,
    /// Spin at them; the acceleration of a free spin is 0.
    pub spin: Vec<Spin>,
    /// Coordinates.
    pub coordinates: Vec<Series>,
    /// Their rates; empty unless requested.
    pub rates: Vec<Series>,
    /// Internal states of the parts, memory states left out.
    pub states: Vec<Series>,
    /// Forces and other quantities the parts show; empty unless requested.
    pub observed: Vec<Series>,
    /// The last turns, where the outputs do not resolve the motion.
    pub last_turns: Option<LastTurns>,
    /// The state at the end.
    pub end_state: MotionState,
    /// Coordinates at rest, from which displacements are measured.
    pub rest: Vec<f64>,
    /// Why the motion begins undeflected although the machine is loaded.
    pub undeflected: Option<String>,
    /// How the integration ended, and its work.
    pub run: Run,
    /// The implicit method was used.
    pub stiff: bool,
    /// Where the motion passed its bound.
    pub left: Option<Left>,
    /// Largest displacement of each body from rest, at any of its points where something is attached.
    pub peaks: Vec<Peak>,
    /// Its envelope.
    pub windows: Vec<Vec<Window>>,
    /// Tilts of the bodies that tilt.
    pub tilts: Vec<Tilting>,
    /// Crossings of switching surfaces: number of the part, surface of the part, time.
    pub contacts: Vec<(usize, usize, f64)>,
    /// Use of validity, by statement.
    pub validity: Vec<ValidityUse>,
    /// The energy account; none where a part keeps none.
    pub energy: Option<EnergyAccount>,
    /// The part that keeps no account of its energy.
    pub no_account: Option<String>,
    /// Rational forms of parts.
    pub forms: Vec<UsedForm>,
    /// How far they move the roots of the machine.
    pub moved_roots: Option<MovedRoots>,
    /// Spectra of the body requested.
    pub spectra: Vec<SpectrumWindow>,
    /// With spectra: natural frequencies of the machine linearised at rest.
    pub natural: Vec<NaturalFrequency>,
    /// What the machine was reduced to.
    pub reduced: Option<Reduced>,
    /// Unbalance of a machine with parts that balance by themselves.
    pub balancing: Option<Balancing>,
    /// Its motion to be played.
    pub animation: Option<RotorMotion>,
}

/// What is known of a motion beside its trajectory.
pub(in crate::study) struct Beside<'s> {
    pub start: &'s Start,
    pub velocities: bool,
    pub observables: bool,
    pub no_account: Option<String>,
    pub last_turns: Option<LastTurns>,
    pub moved_roots: Option<MovedRoots>,
    pub spectra: Vec<SpectrumWindow>,
    /// With spectra: natural frequencies of the machine linearised at rest.
    pub natural: Vec<NaturalFrequency>,
    /// What the machine was reduced to.
    pub reduced: Option<Reduced>,
}

impl MotionRecord {
    pub(in crate::study) fn of(motion: &mut Motion, trajectory: &Trajectory, beside: Beside) -> Self {
        let system = motion.system();
        let (n, dim) = (system.n(), trajectory.state.len().max(1));
        let rows = || trajectory.states.chunks_exact(dim);
        let series =
            |name: &str, unit: &str, i: usize| Series { name: name.into(), unit: unit.into(), values: rows().map(|y| y[i]).collect() };
        // coordinates of the machine as it is written, of one that was reduced too
        let projection = system.projection();
        let coordinates = projection.map_or(system.coordinates(), |p| &p.coordinates);
        let seen = |from: usize, i: usize| -> Vec<f64> {
            rows().map(|y| projection.map_or_else(|| y[from + i], |p| p.one(i, &y[from..from + n]))).collect()
        };
        let coordinate = |(i, c): (usize, &GlobalDof)| Series { name: c.name.clone(), unit: c.dof.unit.into(), values: seen(0, i) };
        let rate = |(i, c): (usize, &GlobalDof)| Series { name: format!("{}'", c.name), unit: per_second(c.dof.unit), values: seen(n, i) };
        // displacements of stations that are no coordinates
        let combined = system.stations().iter().filter(|s| s.columns().iter().any(|name| coordinates.iter().all(|c| c.name != *name)));
        let point = |s: &Station| {
            let names = s.columns().into_iter().enumerate();
            names
                .map(|(k, name)| Series { name, unit: "m".into(), values: rows().map(|y| s.lateral.of(y)[k]).collect() })
                .collect::<Vec<_>>()
        };
        let points = combined.flat_map(point);
        // memory states are many and mean nothing one by one
        let own = system.slots().iter().flat_map(|slot| slot.states.start..slot.states.end - slot.memory);
        let states = own.map(|i| series(&system.states()[i].name, system.states()[i].dof.unit, 2 * n + i)).collect();
        let balancing = if trajectory.left.is_none() { balance::balancing(motion, trajectory) } else { None };
        MotionRecord {
            times: trajectory.times.clone(),
            spin: trajectory.times.iter().zip(rows()).map(|(&t, y)| motion.spin(t, y)).collect(),
            coordinates: coordinates.iter().enumerate().map(coordinate).chain(points).collect(),
            rates: if beside.velocities { coordinates.iter().enumerate().map(rate).collect() } else { Vec::new() },
            states,
            observed: if beside.observables { observed(motion, trajectory) } else { Vec::new() },
            last_turns: beside.last_turns,
            end_state: MotionState::of(motion, trajectory.run.t, &trajectory.state),
            rest: projection.map_or_else(|| beside.start.rest.clone(), |p| p.all(&beside.start.rest)),
            undeflected: beside.start.undeflected.clone(),
            run: trajectory.run.clone(),
            stiff: trajectory.stiff,
            left: trajectory.left,
            peaks: trajectory.peaks.clone(),
            windows: trajectory.windows.clone(),
            tilts: trajectory.tilts.clone(),
            contacts: trajectory.contacts.clone(),
            validity: trajectory.validity.iter().map(|u| used(motion, trajectory, u)).collect(),
            energy: EnergyAccount::of(motion, trajectory),
            no_account: beside.no_account,
            forms: forms(system),
            moved_roots: beside.moved_roots,
            spectra: beside.spectra,
            natural: beside.natural,
            reduced: beside.reduced,
            animation: if balancing.is_some() { animation::played(motion, trajectory) } else { None },
            balancing,
        }
    }
}

fn used(motion: &Motion, trajectory: &Trajectory, u: &Use) -> ValidityUse {
    let speed = |t: f64| {
        let last = trajectory.times.partition_point(|&x| x <= t).saturating_sub(1);
        let state = trajectory.states.chunks_exact(trajectory.state.len().max(1)).nth(last).unwrap_or(&trajectory.state);
        motion.spin(t, state).speed
    };
    ValidityUse { of: u.clone(), speed_first: u.exceeded.map(speed), speed_then: u.until.map(speed) }
}

/// What the parts show at the outputs.
fn observed(motion: &mut Motion, trajectory: &Trajectory) -> Vec<Series> {
    let system = motion.system();
    let dim = trajectory.state.len();
    let mut workspace = Workspace::default();
    let mut out: Vec<Series> = Vec::new();
    for (row, (&t, y)) in trajectory.times.iter().zip(trajectory.states.chunks_exact(dim.max(1))).enumerate() {
        let seen = motion.with_point(t, y, |s, at| s.observe(at, &mut workspace)).unwrap_or_default();
        for (slot, o) in seen {
            let name = format!("{}.{}", system.slots()[slot].name, o.name);
            let k = out.iter().position(|s| s.name == name).unwrap_or_else(|| {
                out.push(Series { name, unit: o.unit.into(), values: Vec::new() });
                out.len() - 1
            });
            out[k].values.resize(row, f64::NAN);
            out[k].values.push(o.value);
        }
    }
    out.iter_mut().for_each(|s| s.values.resize(trajectory.times.len(), f64::NAN));
    out
}
