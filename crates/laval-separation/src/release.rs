//! One particle released at a position with a velocity, by the model and the exit times of the batch.
//!
//! Equations: those of [`super::batch`]. With the drag in balance with the field a particle has no velocity of its own to begin with.
//!
//! Validity: as there; the run-up of a fixed-angle tube counts by its field, and so do velocities during it.

use super::batch::Spinning;
use super::closed::{Closed, Path};
use super::drift;
use super::exit::Exit;
use super::halton;
use super::motion::Lost;
use super::particle::Particle;
use super::suspension::{Member, Model};
use serde::{Deserialize, Serialize};

/// A particle, its place (m) and its velocity (m/s) in the axes of the cup.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Release {
    /// The particle.
    pub particle: Particle,
    /// Where it starts.
    pub place: [f64; 3],
    /// How fast.
    pub velocity: [f64; 3],
}

/// The particle at one time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moment {
    /// Time, s.
    pub time: f64,
    /// Place, m.
    pub place: [f64; 3],
    /// Velocity relative to the cup, m/s.
    pub velocity: [f64; 3],
    /// Tilt of the cup, rad.
    pub tilt: f64,
}

impl Spinning<'_> {
    /// First exit, and the largest Reynolds number: of all steps where the path is integrated, else at the exit.
    ///
    /// # Errors
    /// A machine without path in space; an integration that fails.
    pub fn released(&self, r: &Release, tolerance: f64) -> Result<(Option<Exit>, f64), Lost> {
        let batch = self.batch;
        let exit = match batch.model {
            Model::Drifting => self.exit(&r.particle, &member(r))?,
            Model::Inertial | Model::Adaptive if self.integrated() => {
                let (exit, reynolds) = self.travel_from(&r.particle, r.place, r.velocity, tolerance)?;
                return Ok((self.counted(exit), reynolds));
            }
            Model::Inertial | Model::Adaptive => {
                self.counted(self.turning.settle_from(&batch.medium.rates(&r.particle), r.place, r.velocity))
            }
        };
        let speed = exit.map_or(0.0, |e| e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt());
        Ok((exit, batch.medium.reynolds(&r.particle, speed)))
    }

    /// The path up to a time, in about `count` steps.
    ///
    /// # Errors
    /// As [`Spinning::released`].
    pub fn release_path(&self, r: &Release, until: f64, count: usize, tolerance: f64) -> Result<Vec<Moment>, Lost> {
        let batch = self.batch;
        let Some(steady) = self.turning.steady() else { return Ok(vec![]) };
        let tilt = |t: f64| self.climb.as_ref().map_or(steady.tilt, |c| c.tilt(t));
        if batch.model == Model::Drifting {
            let velocity = |t: f64, place: [f64; 3]| match &self.climb {
                Some(climb) => climb.velocity(&batch.medium, &r.particle, t, place),
                None => drift::velocity(&batch.medium, &r.particle, &steady, place).map(|v| v * self.pace(t)),
            };
            let places = self.places(&r.particle, &member(r), until, count)?;
            let moment = |time: f64, place| Moment { time, place, velocity: velocity(time, place), tilt: tilt(time) };
            return Ok(places.iter().map(|p| moment(p.time, p.at)).collect());
        }
        // the run-up of a tube counts by its field
        let counted = |t: f64| if self.climb.is_none() { self.clock.counted(t) } else { t };
        let times: Vec<f64> = (0..=count).map(|k| until * k as f64 / count as f64).collect();
        let scaled = |v: [f64; 3], t: f64| v.map(|v| v * self.pace(t));
        if !self.integrated() {
            let path = Closed::new(&batch.medium.rates(&r.particle), &steady, r.place, r.velocity);
            let moment = |t: f64| {
                let (place, v) = path.at(counted(t));
                Moment { time: t, place, velocity: scaled(v, t), tilt: steady.tilt }
            };
            return Ok(times.into_iter().map(moment).collect());
        }
        let Some(journey) = self.journey(r.particle) else { return Ok(vec![]) };
        let requested: Vec<f64> = times.iter().map(|&t| counted(t) * (1.0 - 1e-12)).collect();
        let arrival = journey.follow(journey.start_from(r.place, r.velocity), counted(until), tolerance, &requested)?;
        let seen = arrival.moments.iter().zip(times);
        Ok(seen
            .map(|(m, t)| {
                let s = m.state;
                Moment { time: t, place: [s[0], s[1], s[2]], velocity: scaled([s[3], s[4], s[5]], t), tilt: s[6] }
            })
            .collect())
    }

    /// Counted time per time.
    fn pace(&self, t: f64) -> f64 {
        let duration = self.duration();
        if self.climb.is_some() || t >= duration {
            return 1.0;
        }
        let h = 1e-5 * duration;
        let (from, to) = ((t - h).max(0.0), (t + h).min(duration));
        (self.clock.counted(to) - self.clock.counted(from)) / (to - from)
    }
}

/// A member of the set that starts there.
fn member(r: &Release) -> Member {
    Member { point: halton::point(1), start: r.place }
}
