//! Accelerations from the residual: any speed, mass that depends on the configuration, free spin.

use super::point;
use super::seeded::{Seeded, Targets};
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, DofKind, Rows};
use crate::model::system::{Slot, System, Workspace};
use crate::programme::Spin;
use laval_model::text;
use laval_model::text::{Arg, Argument};
use laval_num::dense::{Lu, Mat};
use laval_num::ode::Failure;
use laval_num::refill::refill;

/// Scratch and results of the general evaluation. Rows of coordinates come first; with a free spin its row is the last.
pub(super) struct Direct {
    free: bool,
    /// Some part outside the blocks reads accelerations.
    varying: bool,
    /// Accelerations, with the spin's at the end.
    pub accel: Vec<f64>,
    /// Rates of all internal states.
    pub rate: Vec<f64>,
    /// Zero accelerations.
    pub zero: Vec<f64>,
    /// Linear parts at the speed of their last assembly.
    model: LinearModel<f64>,
    model_speed: Option<f64>,
    linear_scratch: LinearScratch<f64>,
    /// Mass matrix of the linear parts as entries and as a matrix, and that of all.
    mass_values: Vec<f64>,
    linear_mass: Mat,
    mass: Mat,
    lu: Lu,
    factored: bool,
    /// d rate / d accelerations.
    rate_a: Mat,
    /// Residual at zero acceleration.
    pub force: Vec<f64>,
    z: Vec<f64>,
    state_rate: Vec<f64>,
    plain: Workspace<f64>,
    seeded: Seeded,
}

/// Inertia of that motion, over the sum of the sizes of its terms, that counts as none: an eccentric mass m e^2 turns with the spin and not with the twist.
const NO_INERTIA: f64 = 1e-4;

/// With a free spin, the twist of all that twists by one angle while the spin goes back by it moves nothing, unless something turns that does not twist.
fn turns_without_inertia(system: &System, mass: &Mat, scale: &[f64]) -> bool {
    let n = system.n();
    let twist = |i: usize| match system.coordinates()[i].dof.kind {
        DofKind::Twist => system.slots()[system.coordinates()[i].slot].speed(system.params(), 1.0),
        _ => 0.0,
    };
    let turn: Vec<f64> = (0..=n).map(|i| scale[i] * if i < n { twist(i) } else { -1.0 }).collect();
    let terms = (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| turn[i] * mass[(i, j)] * turn[j]);
    let (inertia, size) = terms.fold((0.0f64, 0.0), |(sum, size), x| (sum + x, size + x.abs()));
    turn[..n].iter().any(|x| *x != 0.0) && inertia.abs() <= NO_INERTIA * size
}

pub(super) fn zeroed(x: &mut Vec<f64>, n: usize) {
    refill(x, n, 0.0);
}

impl Direct {
    pub fn new(system: &System, free: bool) -> Self {
        let rows = system.n() + usize::from(free);
        Direct {
            free,
            varying: free || system.slots().iter().any(reads_acceleration),
            accel: vec![0.0; rows],
            rate: vec![0.0; system.m()],
            zero: vec![0.0; system.n()],
            model: LinearModel::default(),
            model_speed: None,
            linear_scratch: LinearScratch::default(),
            mass_values: vec![],
            linear_mass: Mat::default(),
            mass: Mat::default(),
            lu: Lu::default(),
            factored: false,
            rate_a: Mat::default(),
            force: vec![],
            z: vec![],
            state_rate: vec![],
            plain: Workspace::default(),
            seeded: Seeded::new(system),
        }
    }

    /// The mass matrix depends on nothing but, perhaps, the speed.
    pub fn constant_mass(&self) -> bool {
        !self.varying
    }

    /// Refuses a mass matrix that is singular to rounding, whatever the units of its coordinates.
    pub fn check_mass(&self, system: &System) -> Result<(), Failure> {
        let size: Vec<f64> = (0..self.mass.rows()).map(|i| self.mass[(i, i)].abs().sqrt()).collect();
        let scaled = Mat::from_fn(size.len(), size.len(), |i, j| self.mass[(i, j)] / (size[i] * size[j]));
        if self.free && turns_without_inertia(system, &scaled, &size) {
            return Err(singular(system, size.len() - 1, self.mass.data()));
        }
        let lu = Lu::new(&scaled).map_err(|s| singular(system, s.column, self.mass.data()))?;
        // NaN fails
        if lu.pivot_ratio() > 1e-13 { Ok(()) } else { Err(singular(system, size.len() - 1, self.mass.data())) }
    }

    fn assemble(&mut self, system: &System, speed: f64) {
        // also when both are NaN
        if self.model_speed.is_some_and(|s| s.to_bits() == speed.to_bits()) {
            return;
        }
        system.linear(system.params(), speed, Form::Time, &mut self.model, &mut self.linear_scratch);
        self.model_speed = Some(speed);
        let mass = self.model.mass_values();
        if self.mass_values != mass {
            self.mass_values.clear();
            self.mass_values.extend_from_slice(mass);
            self.linear_mass = Mat::from_fn(system.n(), system.n(), |i, j| self.model.mass(i, j));
            self.factored = false;
        }
    }

    /// Fills `accel` and `rate`.
    pub fn evaluate(&mut self, system: &System, t: f64, spin: Spin, y: &[f64]) -> Result<(), Failure> {
        let (n, rows) = (system.n(), self.accel.len());
        self.evaluate_at_rest(system, t, spin, y);
        if self.varying || !self.factored {
            if let Err(s) = self.lu.factor(&self.mass) {
                if self.mass.data().iter().all(|x| x.is_finite()) {
                    return Err(singular(system, s.column, self.mass.data()));
                }
                // a trial step that went too far: it is tried again smaller
                self.accel.fill(f64::NAN);
                return Ok(());
            }
            self.factored = true;
        }
        for (a, f) in self.accel.iter_mut().zip(&self.force) {
            *a = -f;
        }
        self.lu.solve(&mut self.accel);
        self.add_rates_of_acceleration();
        debug_assert!(self.force.len() == rows && self.zero.len() == n);
        Ok(())
    }

    /// What rates read of the accelerations.
    pub fn add_rates_of_acceleration(&mut self) {
        for (i, rate) in self.rate.iter_mut().enumerate() {
            *rate += self.rate_a.row(i).iter().zip(&self.accel).map(|(r, a)| r * a).sum::<f64>();
        }
    }

    /// Residual, mass, rates and their derivative in the accelerations at zero acceleration.
    pub fn evaluate_at_rest(&mut self, system: &System, t: f64, spin: Spin, y: &[f64]) {
        let (n, m, rows) = (system.n(), system.m(), self.accel.len());
        zeroed(&mut self.force, rows);
        zeroed(&mut self.rate, m);
        self.rate_a.reset(m, rows);
        if !self.free {
            self.assemble(system, spin.speed);
            self.mass.copy_from(&self.linear_mass);
        }
        let at = At { spin_accel: if self.free { 0.0 } else { spin.accel }, ..point(system, t, spin, y, &self.zero) };
        if self.free {
            self.mass.reset(rows, rows);
            let Direct { seeded, force, rate, mass, rate_a, .. } = self;
            for slot in system.slots() {
                seeded.add(system, slot, &at, true, &mut Targets { force, rate, mass, rate_a });
            }
            return;
        }
        linear_rows(system, &self.model, &at, &mut self.force, &mut self.rate, &mut self.z, &mut self.state_rate);
        for (k, &i) in self.model.states().iter().enumerate() {
            let row = self.rate_a.row_mut(i);
            for (e, j) in self.model.pattern().row(n + k).take_while(|x| x.1 < n) {
                row[j] = self.model.mass_values()[e];
            }
        }
        let mut ignored = 0.0;
        let mut out = Rows { force: &mut self.force, rate: &mut self.rate, spin: &mut ignored };
        system.residual(system.params(), &at, &mut out, &mut self.plain, |s| !s.is_linear() && !reads_acceleration(s));
        if self.varying {
            let Direct { seeded, force, rate, mass, rate_a, .. } = self;
            for slot in system.slots().iter().filter(|s| reads_acceleration(s)) {
                seeded.add(system, slot, &at, false, &mut Targets { force, rate, mass, rate_a });
            }
        }
        debug_assert_eq!(self.force.len(), n);
    }

    /// What internal states gain when the velocities jump by `change`.
    pub fn state_jump(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], change: &[f64], jump: &mut [f64]) {
        self.evaluate_at_rest(system, t, spin, y);
        for (i, z) in jump.iter_mut().enumerate() {
            *z = self.rate_a.row(i).iter().zip(change).map(|(a, v)| a * v).sum();
        }
    }
}

fn reads_acceleration(slot: &Slot) -> bool {
    !slot.is_linear() && slot.uses.acceleration
}

/// Names the coordinate whose row of the mass matrix has nothing in it, or the one where elimination stopped.
pub(super) fn singular(system: &System, column: usize, mass: &[f64]) -> Failure {
    let name = |i: usize| system.coordinates().get(i).map_or(SPIN_ANGLE.to_string(), |c| format!("\"{}\"", c.name));
    if mass.iter().any(|x| !x.is_finite()) {
        return format!("{NOT_FINITE}{})", name(column)).into();
    }
    format!("{SINGULAR}{}", name(column)).into()
}

/// Names a coordinate without inertia that nothing determines.
pub(super) fn unheld(system: &System, column: usize) -> Failure {
    let name = system.coordinates().get(column).map_or(SPIN_ANGLE.to_string(), |c| format!("\"{}\"", c.name));
    format!("{UNHELD}{name}").into()
}

/// What stops a motion where Newton's method finds no places of coordinates without inertia.
pub(super) const NOT_FOUND: &str = "no places of the coordinates without inertia balance their forces";
const UNHELD: &str = "without inertia, no damping or stiffness determines ";
const SPIN_ANGLE: &str = "the spin angle";
const NOT_FINITE: &str = "the mass matrix has an entry that is not finite (at ";
const SINGULAR: &str = "the mass matrix is singular: no inertia of its own is left for ";

/// The same for a diagnostic.
pub(super) fn in_words(what: &Failure) -> Arg {
    let place = |name: &str| if name == SPIN_ANGLE { text!("the spin angle").argument() } else { name.argument() };
    if let Some(name) = what.0.strip_prefix(SINGULAR) {
        return text!("the mass matrix is singular: no inertia of its own is left for {place}", place = place(name)).argument();
    }
    if what.0 == NOT_FOUND {
        return text!("no places of the coordinates without inertia balance their forces").argument();
    }
    if let Some(name) = what.0.strip_prefix(UNHELD) {
        return text!("without inertia, no damping or stiffness determines {place}", place = place(name)).argument();
    }
    if let Some(name) = what.0.strip_prefix(NOT_FINITE).and_then(|n| n.strip_suffix(')')) {
        return text!("the mass matrix has an entry that is not finite (at {place})", place = place(name)).argument();
    }
    what.argument()
}

/// Adds force rows and rates of the linear parts from their assembled blocks; `at` may hold any accelerations.
pub(super) fn linear_rows(
    system: &System,
    model: &LinearModel<f64>,
    at: &At<f64>,
    force: &mut [f64],
    rate: &mut [f64],
    z: &mut Vec<f64>,
    state_rate: &mut Vec<f64>,
) {
    z.clear();
    z.extend(model.states().iter().map(|&i| at.z[i]));
    zeroed(state_rate, z.len());
    model.residual(&At { z, ..*at }, force, state_rate);
    for (&i, r) in model.states().iter().zip(state_rate.iter()) {
        rate[i] += r;
    }
    memory_rows(system, model, at, force, rate);
}

/// Adds force rows and rates of the memory states of linear parts.
pub(super) fn memory_rows(system: &System, model: &LinearModel<f64>, at: &At<f64>, force: &mut [f64], rate: &mut [f64]) {
    use crate::model::blocks::Axes;
    for part in &model.memory {
        let speed = part.speed;
        let map = &system.slots()[part.slot].map;
        for (k, s) in part.list.iter().enumerate() {
            let i = part.first + k;
            let input: f64 = map[s.input].iter().map(|&(g, c)| c * at.q[g]).sum();
            let turning = match s.axes {
                Axes::Fixed => 0.0,
                Axes::RotorX => -speed * at.z[i + 1],
                Axes::RotorY => speed * at.z[i - 1],
            };
            rate[i] += input - s.rate * at.z[i] + turning;
            for &(g, c) in &map[s.output] {
                force[g] += c * s.gain * at.z[i];
            }
        }
    }
}
