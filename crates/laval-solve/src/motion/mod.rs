//! A machine in time: its equations as one first-order system y' = f(t, y).
//!
//! ```text
//! y = (q, v, z [, phase, speed] [, energy account])
//! q' = v,   M a = -r(q, v, a = 0, z; spin, t),   v' = a,   z' as the parts say (may read a)
//! ```
//!
//! With a prescribed spin (phase, speed, acceleration from a [`Programme`]) the spin row is not solved: it gives the drive torque. With a free
//! spin the spin angle is one more coordinate with its row and column in M.
//!
//! The energy account appends four integrals from the start: heat, work of the parts' own sources, work of the drive, work of the weight. Stored energy
//! changes by `-heat + sources + drive + weight`: what is missing is the error of the integration.
//!
//! Coordinates without inertia are solved for (`massless`): what has damping is a first-order state, what has neither follows from the others.
//!
//! A machine of constant mass at constant speed is compiled once: its linear parts become one matrix, column by column (`single`) or, beside memory
//! states, dense (`compiled`), and only nonlinear parts and memory states are evaluated at every call. One with many coordinates keeps its matrices as
//! entries (`large`).
//!
//! Theory: `docs/theory/motion-in-time.md#first-order-system`.

mod account;
pub(super) mod compiled;
pub(super) mod constant;
mod direct;
pub mod envelope;
mod large;
mod massless;
pub(crate) mod one_by_one;
mod seeded;
mod single;
mod stiff;
pub mod trajectory;

pub use account::Powers;

use super::programme::{Programme, Spin};
use crate::diagnostic::Diagnostic;
use crate::model::part::{At, Physics, TimeForm};
use crate::model::system::{Drive, System};
use account::Power;
use compiled::Compiled;
use direct::Direct;
use large::Large;
use laval_model::text;
use laval_num::ode::{Failure, Ode};
use massless::Massless;
use single::Single;
use std::f64::consts::PI;
use stiff::Elimination;

/// Least rate at which what follows from other states is followed, 1/s.
const LEAST_RATE: f64 = 100.0;

/// Number of integrals in the energy account.
pub const ACCOUNT: usize = 4;

/// How the spin moves.
#[derive(Clone, Debug, PartialEq)]
pub enum SpinLaw {
    /// As prescribed.
    Programme(Programme),
    /// By the spin row.
    Free,
}

impl SpinLaw {
    /// A step forwards from `t` (s), where the spin is `now`, shortened so that a load of `ratio` times the speed turns by half a turn at most. Where the speed is
    /// free its acceleration is taken to stay.
    pub(crate) fn within_half_turn(&self, ratio: f64, t: f64, now: Spin, proposed: f64) -> f64 {
        let speed = |h: f64| match self {
            SpinLaw::Programme(p) => p.at(t + h).speed,
            SpinLaw::Free => now.speed + h * now.accel,
        };
        let mut h = proposed;
        loop {
            let fastest = [now.speed, speed(0.5 * h), speed(h)].into_iter().fold(0.0_f64, |most, w| most.max(w.abs()));
            let allowed = PI / (ratio * fastest);
            if !allowed.lt(&h) {
                return h;
            }
            h = allowed.max(0.5 * h);
        }
    }
}

/// The machine as an ODE, with its scratch; see the [module](self).
pub struct Motion<'a> {
    system: &'a System,
    law: SpinLaw,
    /// Speed of its fastest load that turns over its own.
    fastest_load: f64,
    account: bool,
    direct: Direct,
    steady: Option<Steady<'a>>,
    /// Of a machine with coordinates without inertia.
    massless: Option<Massless>,
    /// Of one with many coordinates.
    large: Option<Box<Large>>,
    elimination: Elimination,
    power: Power,
}

/// The compiled forms.
enum Steady<'a> {
    /// Without memory, and a place for the rates of all states.
    Single(Box<Single<'a>>, Vec<f64>),
    /// With memory.
    Dense(Box<Compiled>),
}

impl<'a> Steady<'a> {
    fn new(system: &'a System, speed: f64, phase: f64) -> Result<Self, Failure> {
        if system.slots().iter().any(|s| s.memory > 0) {
            return Ok(Steady::Dense(Box::new(Compiled::new(system, speed)?)));
        }
        let single = Single::new(system, speed, phase)?;
        let rates = vec![0.0; single.dim()];
        Ok(Steady::Single(Box::new(single), rates))
    }

    /// Fills `accel` and `rate` of `out`.
    fn evaluate(&mut self, system: &System, t: f64, spin: Spin, y: &[f64], out: &mut Direct) {
        match self {
            Steady::Dense(c) => c.evaluate(system, t, spin, y, out),
            Steady::Single(equations, rates) => {
                let n = system.n();
                // the account of energy may stand behind the states
                equations.rhs(t, &y[..rates.len()], rates);
                out.accel[..n].copy_from_slice(&rates[n..2 * n]);
                out.rate.copy_from_slice(&rates[2 * n..]);
            }
        }
    }
}

/// Accelerations at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Accelerations<'m> {
    /// Of the coordinates.
    pub coordinates: &'m [f64],
    /// Of the spin, rad/s^2.
    pub spin: f64,
    /// Rates of the internal states.
    pub rates: &'m [f64],
}

impl<'a> Motion<'a> {
    /// The machine in time. A prescribed law serves any drive; a free one needs [`Drive::Free`] and inertia about the axis.
    ///
    /// # Errors
    /// A part without a time form; a mass matrix that is singular at the undeflected state beyond coordinates without inertia; one of these that nothing determines.
    pub fn new(system: &'a System, law: SpinLaw) -> Result<Self, Diagnostic> {
        for slot in system.slots() {
            if let Physics::Frequency(TimeForm::None(why)) = slot.physics {
                return Err(Diagnostic::error(
                    "motion.no_time_form",
                    text!("\"{name}\" has no form in the time domain: {why}", name = slot.name, why = text::term(why)),
                )
                .at(slot.span.clone())
                .help(text!("use a study in the frequency domain, such as forced_response")));
            }
        }
        let free = law == SpinLaw::Free;
        let mut motion = Motion {
            system,
            direct: Direct::new(system, free),
            steady: None,
            massless: None,
            large: None,
            elimination: Elimination::new(system, free),
            law,
            fastest_load: system.fastest_load(),
            account: false,
            power: Power::new(system),
        };
        let mut y = vec![0.0; motion.core()];
        if let (true, Some(speed)) = (free, system.machine.speed) {
            y[2 * system.n() + system.m() + 1] = speed;
        }
        let fail = |what: Failure| {
            Diagnostic::error("motion.mass", text!("the machine has no equations of motion: {what}", what = direct::in_words(&what)))
                .help(text!("a coordinate follows from inertia, or without it from a damper or a spring that holds it: give the part that owns it a mass or hold it, and give a spin that is free a moment of inertia about the axis"))
        };
        let spin = motion.spin(0.0, &y);
        let fastest = fastest_of(&motion.law, spin);
        let speeds = [spin.speed, 0.5 * (spin.speed + fastest), fastest];
        motion.massless = Massless::new(system, free, motion.direct.constant_mass(), &speeds, fastest.max(LEAST_RATE)).map_err(fail)?;
        if motion.massless.is_some() {
            return Ok(motion);
        }
        let one_speed = matches!(&motion.law, SpinLaw::Programme(p) if p.constant_speed().is_some());
        let top = if one_speed { None } else { Some(fastest) };
        motion.large = Large::new(system, !free && motion.direct.constant_mass(), spin.speed, top).map_err(fail)?.map(Box::new);
        if motion.large.is_some() {
            return Ok(motion);
        }
        motion.accelerate(0.0, &y).map_err(fail)?;
        motion.direct.check_mass(system).map_err(fail)?;
        if let SpinLaw::Programme(p) = &motion.law
            && let Some(speed) = p.constant_speed()
            && motion.direct.constant_mass()
        {
            motion.steady = Some(Steady::new(system, speed, p.at(0.0).phase).map_err(fail)?);
        }
        Ok(motion)
    }

    /// The law of the machine's own drive: free from its speed, or constant at `speed`.
    pub fn law_of(system: &System, speed: f64, phase: f64) -> SpinLaw {
        match system.machine.drive {
            Drive::Prescribed => SpinLaw::Programme(Programme::constant(speed, phase)),
            Drive::Free => SpinLaw::Free,
        }
    }

    /// Appends the energy account to the states.
    ///
    /// # Errors
    /// The name of a part that keeps no account of its energy; the motion stays as it was.
    pub fn keep_account(&mut self) -> Result<(), String> {
        let y = vec![0.0; self.dim()];
        self.stored_energy(0.0, &y)?;
        self.account = true;
        Ok(())
    }

    /// The machine.
    pub fn system(&self) -> &'a System {
        self.system
    }
    /// How the spin moves.
    pub fn law(&self) -> &SpinLaw {
        &self.law
    }
    /// The spin angle is a coordinate.
    pub fn is_free(&self) -> bool {
        self.law == SpinLaw::Free
    }
    /// The energy account is kept.
    pub fn has_account(&self) -> bool {
        self.account
    }
    /// Number of states without the account.
    fn core(&self) -> usize {
        2 * self.system.n() + self.system.m() + 2 * usize::from(self.is_free())
    }
    /// Index of the first integral of the account: heat, sources, drive, weight.
    pub fn account_start(&self) -> Option<usize> {
        self.account.then(|| self.core())
    }
    /// Index of the spin angle; the speed follows. `None` when prescribed.
    pub fn spin_start(&self) -> Option<usize> {
        self.is_free().then(|| 2 * self.system.n() + self.system.m())
    }
    /// Memory states of all parts.
    pub fn memory_states(&self) -> usize {
        self.elimination.memory()
    }
    /// Why an explicit method cannot be used, naming the part.
    pub fn refuses_explicit(&self) -> Option<Diagnostic> {
        let slot = self.system.slots().iter().find(|s| s.memory > 0)?;
        Some(
            Diagnostic::error(
                "motion.memory",
                text!("\"{name}\" has memory states, which an explicit method cannot follow", name = slot.name),
            )
            .at(slot.span.clone())
            .help(text!("use method = \"stiff\"")),
        )
    }
    /// The machine has many coordinates, and its matrices are kept as entries: no reduction makes its motion quicker.
    pub fn is_by_entries(&self) -> bool {
        self.large.is_some()
    }
    /// The integration uses the matrices compiled for a constant speed.
    pub fn is_compiled(&self) -> bool {
        self.steady.is_some()
    }

    /// Phase and speed at a state; the acceleration is that of the programme (0 when free: see [`Motion::accelerations`]).
    pub fn spin(&self, t: f64, y: &[f64]) -> Spin {
        match &self.law {
            SpinLaw::Programme(p) => p.at(t),
            SpinLaw::Free => {
                let k = 2 * self.system.n() + self.system.m();
                Spin { phase: y[k], speed: y[k + 1], accel: 0.0 }
            }
        }
    }

    fn accelerate(&mut self, t: f64, y: &[f64]) -> Result<Spin, Failure> {
        let (spin, free) = (self.spin(t, y), self.is_free());
        match (&mut self.steady, &mut self.massless, &mut self.large) {
            (Some(s), ..) => s.evaluate(self.system, t, spin, y, &mut self.direct),
            (_, Some(m), _) => m.evaluate(self.system, free, t, spin, y, &mut self.direct)?,
            (.., Some(l)) => l.evaluate(self.system, t, spin, y, &mut self.direct)?,
            _ => self.direct.evaluate(self.system, t, spin, y)?,
        }
        Ok(Spin { accel: if self.is_free() { self.direct.accel[self.system.n()] } else { spin.accel }, ..spin })
    }

    /// Accelerations and rates at a state.
    ///
    /// # Errors
    /// A singular mass matrix, naming the coordinate.
    pub fn accelerations(&mut self, t: f64, y: &[f64]) -> Result<Accelerations<'_>, Failure> {
        let spin = self.accelerate(t, y)?.accel;
        let (n, m) = (self.system.n(), self.system.m());
        Ok(Accelerations { coordinates: &self.direct.accel[..n], spin, rates: &self.direct.rate[..m] })
    }

    /// Calls `f` with the full point (accelerations included) at a state.
    ///
    /// # Errors
    /// As [`Motion::accelerations`].
    pub fn with_point<R>(&mut self, t: f64, y: &[f64], f: impl FnOnce(&System, &At<f64>) -> R) -> Result<R, Failure> {
        let spin = self.accelerate(t, y)?;
        Ok(f(self.system, &point(self.system, t, spin, completed(&self.massless, y), &self.direct.accel)))
    }

    /// Residual of the spin row, N m: the torque the drive must bring when the spin is prescribed, 0 to rounding when it is free.
    ///
    /// # Errors
    /// As [`Motion::accelerations`].
    pub fn torque(&mut self, t: f64, y: &[f64]) -> Result<f64, Failure> {
        let spin = self.accelerate(t, y)?;
        let at = point(self.system, t, spin, completed(&self.massless, y), &self.direct.accel);
        Ok(self.power.torque(self.system, &at))
    }

    /// Stored energy, J.
    ///
    /// # Errors
    /// The name of a part that keeps no account.
    pub fn stored_energy(&mut self, t: f64, y: &[f64]) -> Result<f64, String> {
        let spin = self.spin(t, y);
        // what nothing determines here stays as it is
        let y = if self.massless.is_some() && self.accelerate(t, y).is_ok() { completed(&self.massless, y) } else { y };
        // no stored energy reads an acceleration
        let zero = &self.direct.zero;
        let at = point(self.system, t, spin, y, zero);
        self.power.stored(self.system, &at)
    }

    /// Powers at a state.
    ///
    /// # Errors
    /// As [`Motion::accelerations`], or a part that keeps no account.
    pub fn powers(&mut self, t: f64, y: &[f64]) -> Result<Powers, Failure> {
        let spin = self.accelerate(t, y)?;
        self.powers_here(t, spin, y)
    }

    fn powers_here(&mut self, t: f64, spin: Spin, y: &[f64]) -> Result<Powers, Failure> {
        let at = point(self.system, t, spin, completed(&self.massless, y), &self.direct.accel);
        self.power.powers(self.system, &at, self.law == SpinLaw::Free)
    }

    /// Rates of all states, the account among them, by the way that serves every machine.
    #[inline(never)]
    fn rates(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        let spin = self.rates_without_account(t, y, dy)?;
        if let Some(k) = self.account_start() {
            let p = self.powers_here(t, spin, y)?;
            dy[k..k + ACCOUNT].copy_from_slice(&[p.dissipated, p.supplied, p.drive, p.weight]);
        }
        Ok(())
    }

    fn rates_without_account(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<Spin, Failure> {
        let (n, m) = (self.system.n(), self.system.m());
        let spin = self.accelerate(t, y)?;
        dy[..n].copy_from_slice(&y[n..2 * n]);
        dy[n..2 * n].copy_from_slice(&self.direct.accel[..n]);
        if let Some(massless) = &self.massless {
            massless.rates(y, &self.direct.accel, dy);
        }
        dy[2 * n..2 * n + m].copy_from_slice(&self.direct.rate);
        if let Some(k) = self.spin_start() {
            dy[k] = spin.speed;
            dy[k + 1] = spin.accel;
        }
        Ok(spin)
    }

    /// Applies sudden changes of velocity; internal states that read accelerations follow.
    ///
    /// # Errors
    /// As [`Motion::accelerations`].
    pub fn kick(&mut self, t: f64, y: &mut [f64], change: &[f64]) -> Result<(), Failure> {
        let (n, m) = (self.system.n(), self.system.m());
        self.accelerate(t, y)?;
        let mut jump = vec![0.0; m];
        self.direct.state_jump(self.system, t, self.spin(t, y), completed(&self.massless, y), change, &mut jump);
        for (v, d) in y[n..2 * n].iter_mut().zip(change) {
            *v += d;
        }
        for (z, d) in y[2 * n..2 * n + m].iter_mut().zip(jump) {
            *z += d;
        }
        self.settle(t, y)
    }

    /// Writes into a state what follows from the rest of it: places and velocities of coordinates without inertia.
    ///
    /// # Errors
    /// As [`Motion::accelerations`].
    pub fn settle(&mut self, t: f64, y: &mut [f64]) -> Result<(), Failure> {
        if self.massless.is_none() {
            return Ok(());
        }
        self.accelerate(t, y)?;
        if self.direct.accel.iter().any(|a| !a.is_finite()) {
            return Err(direct::NOT_FOUND.into());
        }
        if let Some(m) = &self.massless {
            m.settle(y);
        }
        Ok(())
    }
}

/// The largest speed of a law, rad/s: of a free spin the present one.
fn fastest_of(law: &SpinLaw, spin: Spin) -> f64 {
    match law {
        SpinLaw::Programme(p) => p.largest_speed(),
        SpinLaw::Free => spin.speed.abs(),
    }
}

/// A state with what follows from it.
fn completed<'y>(massless: &'y Option<Massless>, y: &'y [f64]) -> &'y [f64] {
    massless.as_ref().map_or(y, Massless::completed)
}

/// The global point of a state.
fn point<'b>(system: &System, t: f64, spin: Spin, y: &'b [f64], a: &'b [f64]) -> At<'b, f64> {
    let (n, m) = (system.n(), system.m());
    At { q: &y[..n], v: &y[n..2 * n], a: &a[..n], z: &y[2 * n..2 * n + m], phase: spin.phase, speed: spin.speed, spin_accel: spin.accel, t }
}

impl Ode for Motion<'_> {
    fn dim(&self) -> usize {
        self.core() + if self.account { ACCOUNT } else { 0 }
    }

    fn ahead(&mut self, times: &[f64]) {
        if let (Some(Steady::Single(equations, _)), false) = (&mut self.steady, self.account) {
            equations.ahead(times);
        }
    }

    fn longest_step(&self, t: f64, y: &[f64], proposed: f64) -> f64 {
        let now = self.spin(t, y);
        let accel = if self.is_free() { self.direct.accel[self.system.n()] } else { now.accel };
        self.law.within_half_turn(self.fastest_load, t, Spin { accel, ..now }, proposed)
    }

    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        if let (Some(Steady::Single(equations, _)), false) = (&mut self.steady, self.account) {
            equations.rhs(t, y, dy);
            return Ok(());
        }
        self.rates(t, y, dy)
    }

    fn integrals(&self) -> usize {
        if self.account { ACCOUNT } else { 0 }
    }

    fn rhs_without_integrals(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        if let (Some(Steady::Single(equations, _)), false) = (&mut self.steady, self.account) {
            equations.rhs(t, y, dy);
            return Ok(());
        }
        self.rates_without_account(t, y, dy).map(|_| ())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programme::Shape;

    #[test]
    fn a_step_turns_a_load_by_half_a_turn_at_most() {
        let ramp = |from, to, shape| Programme::ramp(from, to, 100.0, shape, 0.3).unwrap();
        let programmes = [
            Programme::constant(-7.0, 0.0),
            ramp(0.0, 200.0, Shape::Linear),
            ramp(0.0, -200.0, Shape::Smooth),
            ramp(50.0, -50.0, Shape::Linear),
            ramp(300.0, 3.0, Shape::Exponential),
        ];
        for p in programmes {
            let law = SpinLaw::Programme(p.clone());
            for (ratio, t, proposed) in [(1.0, 0.0, 90.0), (20.0, 0.0, 90.0), (1.0, 49.0, 50.0), (0.1, 30.0, 60.0), (1.0, 20.0, 1e-3)] {
                let h = law.within_half_turn(ratio, t, p.at(t), proposed);
                let turned = ratio * (p.at(t + h).phase - p.at(t).phase).abs();
                assert!(h > 0.0 && h <= proposed && turned < PI * (1.0 + 1e-9), "{p:?} {t} {h} {turned}");
                // nor much shorter
                let most = [t, t + 0.5 * h, t + h].map(|t| p.at(t).speed.abs()).into_iter().fold(0.0, f64::max);
                assert!(h == proposed || ratio * h * most > 0.2 * PI, "{p:?} {t} {h} {most}");
            }
        }
        for (speed, accel) in [(0.0, 3.0), (40.0, 0.0), (-40.0, 3.0), (2.0, -3.0)] {
            let h = SpinLaw::Free.within_half_turn(2.0, 0.0, Spin { phase: 0.0, speed, accel }, 1e3);
            let turned = 2.0 * (speed * h + 0.5 * accel * h * h).abs();
            assert!(turned < PI * (1.0 + 1e-9) && 2.0 * h * (speed.abs() + accel.abs() * h) > 0.2 * PI, "{speed} {accel} {h} {turned}");
        }
        // nothing turns, or the machine stands still
        let still = Programme::constant(0.0, 0.0);
        assert_eq!(SpinLaw::Programme(still.clone()).within_half_turn(1.0, 0.0, still.at(0.0), 5.0), 5.0);
        let turning = Programme::constant(10.0, 0.0);
        assert_eq!(SpinLaw::Programme(turning.clone()).within_half_turn(0.0, 0.0, turning.at(0.0), 5.0), 5.0);
    }
}
