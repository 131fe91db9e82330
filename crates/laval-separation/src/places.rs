//! Where a particle is on its way, by the account that gives its exit.

use super::batch::{EXACT, Spinning, horizon};
use super::closed::{Closed, Drifting, Path};
use super::drift;
use super::exit::first_exit;
use super::motion::Lost;
use super::particle::{Drag, Particle};
use super::suspension::{Member, Model};
use serde::{Deserialize, Serialize};

/// A particle at one time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Time from the start of the machine, s.
    pub time: f64,
    /// Place in the axes of the cup, m.
    pub at: [f64; 3],
    /// Distance from the spin axis, m.
    pub radius: f64,
}

impl Spinning<'_> {
    /// Places of a particle from its release to its exit, at most to the time `until`, about `count` of them; none in disc stacks and decanters, which have no path
    /// in space.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn places(&self, particle: &Particle, member: &Member, until: f64, count: usize) -> Result<Vec<Place>, Lost> {
        let (Some(inside), Some(steady)) = (self.turning.inside(), self.turning.steady()) else { return Ok(vec![]) };
        let (batch, count) = (self.batch, count.max(1));
        let exit = self.exit(particle, member)?;
        let end = exit.map_or(until, |e| e.time.min(until));
        let rates = batch.medium.rates(particle);
        let even = |from: f64| (0..=count).map(move |k| from + (end - from) * k as f64 / count as f64);
        // the run-up of a tube counts by its field
        let clocked = |t: f64| if self.climb.is_none() { self.clock.counted(t) } else { t };
        let tilted = |t: f64| self.climb.as_ref().map_or(steady.tilt, |c| c.tilt(t));
        let place = |time: f64, at: [f64; 3], tilt: f64| Place { time, at, radius: super::closed::Steady { tilt, ..steady }.radius(at) };
        let mut out: Vec<Place> = if !self.integrated() {
            let drifting = Drifting::new(rates.sedimentation, &steady, member.start);
            let exact = Closed::new(&rates, &steady, member.start, [0.0; 3]);
            let at = |t: f64| if batch.model == Model::Drifting { drifting.at(t).0 } else { exact.at(t).0 };
            even(0.0).map(|t| place(t, at(clocked(t)), steady.tilt)).collect()
        } else if self.inertial(particle) {
            let Some(journey) = self.journey(*particle) else { return Ok(vec![]) };
            let times: Vec<f64> = even(0.0).map(|t| clocked(t) * (1.0 - 1e-12)).collect();
            let arrival = journey.follow(journey.start(member.start), clocked(end), EXACT, &times)?;
            let seen = arrival.moments.iter().zip(even(0.0));
            seen.map(|(m, t)| place(t, [m.state[0], m.state[1], m.state[2]], m.state[6])).collect()
        } else {
            let mut seen: Vec<(f64, [f64; 3])> = vec![];
            let mut later = None;
            match &self.climb {
                None => {
                    drift::follow(&batch.medium, particle, &steady, inside, member.start, &mut seen);
                    seen.iter_mut().for_each(|s| s.0 = if self.ramp.is_some() { self.clock.time(s.0) } else { s.0 });
                }
                Some(climb) => {
                    let after = |r: [f64; 3], v: [f64; 3]| {
                        later = Some((r, v));
                        first_exit(
                            &Closed::new(&rates, &climb.steady(), r, v),
                            inside,
                            horizon(inside, &climb.steady(), rates.sedimentation, r),
                        )
                    };
                    climb.follow(&batch.medium, particle, inside, member.start, after, &mut seen);
                }
            }
            let stride = seen.len().div_ceil(count).max(1);
            let mut all: Vec<Place> = seen.iter().step_by(stride).filter(|s| s.0 <= end).map(|s| place(s.0, s.1, tilted(s.0))).collect();
            if let (Some((r, v)), Drag::Stokes) = (later, batch.medium.drag) {
                let begin = self.duration();
                let drifting = Drifting::new(rates.sedimentation, &steady, r);
                let exact = Closed::new(&rates, &steady, r, v);
                let at = |t: f64| if batch.model == Model::Drifting { drifting.at(t).0 } else { exact.at(t).0 };
                all.extend(even(begin).filter(|t| *t >= begin && *t <= end).map(|t| place(t, at(t - begin), steady.tilt)));
            }
            all
        };
        if let Some(e) = exit.filter(|e| e.time <= until) {
            out.retain(|p| p.time < e.time);
            out.push(place(e.time, e.position, tilted(e.time)));
        }
        Ok(out)
    }
}
