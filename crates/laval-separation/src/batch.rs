//! Exit times of the particles of a suspension in a machine, run-up included. All studies take their times
//! from here.
//!
//! Equations: closed form at constant speed with Stokes' drag ([`super::closed`]). Otherwise integration, with inertia ([`super::motion`]) or with the drag in
//! balance with the field ([`super::drift`]). [`Model::Adaptive`] takes inertia along where n/w is below [`FELT`]: left out above, it changes times by about (w/n)^2.
//!
//! Validity: particles of a swinging cup settle during the run-up; the liquid of a fixed-angle tube shifts to another place while the speed changes, so that its run-up
//! counts by the field at mean radius ([`super::recovery::Clock`]); machines that liquid flows through are fed at speed.
//!
//! Sources: `docs/theory/separation.md#exact-solution`, `docs/theory/separation.md#run-up`, `docs/theory/separation.md#ensembles-and-recovery`.

use super::closed::{Closed, Drifting, Steady};
use super::drift::{self, Climb};
use super::exit::{Exit, Surface, first_exit};
use super::motion::{Journey, Lost, Tilt};
use super::particle::{Drag, Medium, Particle};
use super::ramp::Ramp;
use super::recovery::Clock;
use super::separator::{Separator, Turning};
use super::suspension::{Member, Model, Powder, leave, paired_members};
use super::vessel::Inside;
use laval_model::text;

/// Drag rate over spin speed n/w below which inertia is taken along.
pub const FELT: f64 = 100.0;
/// Local error of integrations, relative.
pub const EXACT: f64 = 1e-9;

/// How a batch starts.
#[derive(Clone, Debug, PartialEq)]
pub enum RunUp {
    /// At speed at once.
    None,
    /// At constant acceleration; time per speed, s^2/rad.
    Linear(f64),
    /// The smooth law; time per speed, s^2/rad.
    Smooth(f64),
    /// In the times written, with all its speeds in proportion to the last.
    Programme(Ramp),
}

impl RunUp {
    /// The law of the speed up to `speed`.
    pub fn to(&self, speed: f64) -> Option<Ramp> {
        let w = speed.abs();
        match self {
            RunUp::None => None,
            RunUp::Linear(k) => (w > 0.0).then(|| Ramp::Linear(w, k * w)),
            RunUp::Smooth(k) => (w > 0.0).then(|| Ramp::Smooth(w, k * w)),
            RunUp::Programme(ramp) => Some(ramp.ending_at(speed)),
        }
    }
}

/// What is separated in what, and how that is computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Batch {
    /// The machine.
    pub separator: Separator,
    /// The liquid.
    pub medium: Medium,
    /// The particles.
    pub powder: Powder,
    /// Only particles of this diameter and larger count, m.
    pub from: Option<f64>,
    /// Places of the fixed set.
    pub places: usize,
    /// All start where it takes longest.
    pub slowest: bool,
    /// With inertia or without.
    pub model: Model,
    /// The way to the speed.
    pub run_up: RunUp,
}

/// The batch at one speed.
pub struct Spinning<'a> {
    /// What it is.
    pub batch: &'a Batch,
    /// The machine at its speed.
    pub turning: Turning,
    /// The members of the fixed set.
    pub crowd: Vec<Member>,
    /// The way up, when particles settle on it.
    pub ramp: Option<Ramp>,
    /// Time, counted as the field works.
    pub clock: Clock,
    pub(super) climb: Option<Climb>,
}

impl Batch {
    /// The batch at a speed, rad/s.
    pub fn at(&self, speed: f64) -> Spinning<'_> {
        let turning = self.separator.at(speed);
        let mut crowd = paired_members(&turning, self.places);
        if self.slowest {
            let heavy = self.powder.density.quantile(0.5) > self.medium.density;
            // one place: as many members as there are densities
            if self.powder.density.is_single() {
                crowd.truncate(1);
            }
            crowd.iter_mut().for_each(|m| m.start = turning.slowest(heavy));
        }
        let ramp = if self.separator.flow_volume().is_none() { self.run_up.to(speed) } else { None };
        let clock = match &ramp {
            None => Clock::plain(),
            Some(ramp) => {
                let (r1, r2) = turning.radii();
                Clock::new(ramp, 0.5 * (r1 + r2), self.medium.gravity)
            }
        };
        let climb = match (&self.separator, &ramp) {
            (Separator::Cup(c), Some(ramp)) => Some(Climb::new(&c.hanging, c.held, ramp, &c.vessel)),
            _ => None,
        };
        Spinning { batch: self, turning, crowd, ramp, clock, climb }
    }
}

impl Spinning<'_> {
    /// No closed form holds.
    pub fn integrated(&self) -> bool {
        self.climb.is_some() || self.batch.medium.drag == Drag::SchillerNaumann
    }

    /// Duration of the run-up that particles settle on, s.
    pub fn duration(&self) -> f64 {
        self.ramp.as_ref().map_or(0.0, Ramp::duration)
    }

    /// The particle is integrated with its inertia, where no closed form holds.
    pub(super) fn inertial(&self, particle: &Particle) -> bool {
        match self.batch.model {
            Model::Inertial => true,
            Model::Drifting => false,
            Model::Adaptive => !(0.5 * self.batch.medium.rates(particle).two_n >= FELT * self.turning.speed.abs()),
        }
    }

    /// First exit of a particle released at rest when the machine starts; `None` when it never leaves.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn exit(&self, particle: &Particle, member: &Member) -> Result<Option<Exit>, Lost> {
        let b = self.batch;
        let (inside, steady) = match (self.turning.inside(), self.turning.steady()) {
            (Some(i), Some(s)) => (i, s),
            _ => return Ok(self.flowing(particle, member)),
        };
        if !self.integrated() {
            let exit = leave(&self.turning, &b.medium, particle, member, b.model);
            return Ok(self.counted(exit));
        }
        if self.inertial(particle) {
            return Ok(self.counted(self.travel(particle, member.start, EXACT)?.0));
        }
        let rates = b.medium.rates(particle);
        if rates.sedimentation == 0.0 {
            return Ok(None);
        }
        let exit = match &self.climb {
            None => drift::settle(&b.medium, particle, &steady, inside, member.start),
            Some(climb) => climb.settle(&b.medium, particle, inside, member.start, |r, v| {
                let steady = climb.steady();
                let horizon = horizon(inside, &steady, rates.sedimentation, r);
                match b.model {
                    Model::Drifting => first_exit(&Drifting::new(rates.sedimentation, &steady, r), inside, horizon),
                    _ => first_exit(&Closed::new(&rates, &steady, r, v), inside, horizon),
                }
            }),
        };
        Ok(self.counted(exit))
    }

    /// The exit of a particle that settled at full speed, put where the run-up of a tube delays it to.
    pub(super) fn counted(&self, exit: Option<Exit>) -> Option<Exit> {
        match (&self.ramp, &self.climb) {
            (Some(_), None) => exit.map(|e| Exit { time: self.clock.time(e.time), ..e }),
            _ => exit,
        }
    }

    fn flowing(&self, particle: &Particle, member: &Member) -> Option<Exit> {
        let b = self.batch;
        match (&b.separator, b.medium.drag) {
            (Separator::Discs(d), Drag::SchillerNaumann) => {
                let volume = b.separator.flow_volume()?;
                let time = drift::lifted(&b.medium, particle, d, self.turning.speed, member.start[1], volume)?;
                Some(Exit { time, surface: Surface::Wall, position: [0.0, d.inner, 0.0], velocity: [0.0; 3] })
            }
            _ => self.turning.drift(b.medium.rates(particle).sedimentation, member.start),
        }
    }

    /// The journey of a particle with its inertia, the cup swinging.
    pub fn journey(&self, particle: Particle) -> Option<Journey> {
        let steady = self.turning.steady()?;
        let (ramp, tilt) = match (&self.batch.separator, &self.ramp) {
            (Separator::Cup(c), Some(r)) => {
                let tilt = c.held.map_or(Tilt::Swinging(c.hanging), |tilt| Tilt::Fixed { tilt, hinge: c.hanging.hinge });
                (r.clone(), tilt)
            }
            _ => (Ramp::Constant(self.turning.speed), Tilt::Fixed { tilt: steady.tilt, hinge: steady.hinge }),
        };
        let medium = Medium { gravity: steady.gravity, ..self.batch.medium };
        Some(Journey { medium, particle, ramp, tilt, vessel: *self.turning.inside()? })
    }

    /// First exit by integration with inertia, and the largest Reynolds number at its steps. Once the speed is held and the cup has come to rest the motion goes on in
    /// closed form; a cup without damping is taken as at rest at once, because every hinge damps.
    ///
    /// # Errors
    /// When the integration fails.
    pub fn travel(&self, particle: &Particle, start: [f64; 3], tolerance: f64) -> Result<(Option<Exit>, f64), Lost> {
        self.travel_from(particle, start, [0.0; 3], tolerance)
    }

    /// The same from a velocity relative to the cup, m/s.
    ///
    /// # Errors
    /// When the integration fails.
    pub fn travel_from(
        &self,
        particle: &Particle,
        start: [f64; 3],
        velocity: [f64; 3],
        tolerance: f64,
    ) -> Result<(Option<Exit>, f64), Lost> {
        let Some(journey) = self.journey(*particle) else {
            return Err(Lost(text!("no path in space")));
        };
        let speed = journey.ramp.final_speed();
        let (damping, settled) = match &journey.tilt {
            Tilt::Swinging(cup) => (cup.damping, cup.equilibrium(speed)),
            Tilt::Fixed { tilt, .. } => (0.0, *tilt),
        };
        let rates = journey.medium.rates(particle);
        let swinging = journey.ramp.duration() + if damping > 0.0 { 40.0 / damping } else { 0.0 };
        let mut state = journey.start_from(start, velocity);
        let (mut t, mut reynolds) = (0.0, 0.0);
        if swinging > 0.0 {
            let a = journey.follow(state, swinging, tolerance, &[])?;
            (t, state, reynolds) = (a.last.t, a.last.state, a.reynolds);
            if a.exit.is_some() {
                return Ok((a.exit, reynolds));
            }
        }
        let steady = Steady { speed, tilt: settled, hinge: journey.hinge(), gravity: journey.medium.gravity };
        let (place, velocity) = ([state[0], state[1], state[2]], [state[3], state[4], state[5]]);
        let horizon = horizon(&journey.vessel, &steady, rates.sedimentation, place);
        if journey.medium.drag == Drag::Stokes {
            let path = Closed::new(&rates, &steady, place, velocity);
            let exit = first_exit(&path, &journey.vessel, horizon).map(|e| Exit { time: e.time + t, ..e });
            let last = exit.map_or(0.0, |e| e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt());
            return Ok((exit, reynolds.max(journey.medium.reynolds(particle, last))));
        }
        if !horizon.is_finite() {
            return Ok((None, reynolds));
        }
        let held = Journey { ramp: Ramp::Constant(speed), tilt: Tilt::Fixed { tilt: settled, hinge: steady.hinge }, ..journey.clone() };
        (state[6], state[7]) = (settled, 0.0);
        let a = held.follow(state, 100.0 * (horizon + 1.0 / speed.abs().max(1e-3)), tolerance, &[])?;
        Ok((a.exit.map(|e| Exit { time: e.time + t, ..e }), reynolds.max(a.reynolds)))
    }
}

pub(super) fn horizon(inside: &Inside, steady: &Steady, sedimentation: f64, place: [f64; 3]) -> f64 {
    let field = (steady.speed.powi(2) * steady.radius(place)).hypot(steady.gravity);
    inside.length() / (sedimentation.abs() * field)
}
