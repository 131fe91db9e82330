//! What a separation computes: exits, recovery, paths of particles.

use super::result::{Path, Recovered, Released, RunUpTime, Separated};
use super::{ONE, Separation};
use crate::diagnostic::Diagnostic;
use crate::separation::batch::Spinning;
use crate::separation::exit::{Exit, Surface};
use crate::separation::motion::Tilt;
use crate::separation::ramp::Ramp;
use crate::separation::recovery::{Needed, Recovery, Watch};
use crate::separation::release::Release;
use crate::separation::slowest::Last;
use crate::separation::suspension::{products, quantile, sorted};
use crate::study::centrifuge::cups::task::lost;
use laval_num::order::ascending;

/// The particles of a study at its speed.
pub(super) struct Ensemble<'a> {
    pub study: &'a Separation,
    pub spinning: &'a Spinning<'a>,
    recovery: Recovery<'a>,
    exits: Vec<Option<Exit>>,
    pub watch: Watch<'a>,
    /// Whether to go on; counts no path.
    pub goes_on: Watch<'a>,
    caught: f64,
    needed: Needed,
    last: Option<Last>,
}

/// Share that counts as the whole of the fixed set.
const ALL: f64 = 1.0 - 1e-9;

impl<'a> Ensemble<'a> {
    /// `watch` receives every path; both say whether to go on.
    pub fn new(
        study: &'a Separation,
        spinning: &'a Spinning<'a>,
        exits: Vec<Option<Exit>>,
        (watch, goes_on): (Watch<'a>, Watch<'a>),
    ) -> Result<Self, Diagnostic> {
        let mut recovery = Recovery::watched(spinning, Some(&exits), watch).map_err(lost)?;
        let needed = recovery.needed(study.task.recovery).map_err(lost)?;
        let caught = recovery.caught(study.task.time).map_err(lost)?;
        let last = if caught >= ALL { spinning.last().map_err(lost)? } else { None };
        recovery.learn(&exits);
        Ok(Ensemble { study, spinning, recovery, exits, watch, goes_on, caught, needed, last })
    }

    /// Everything.
    pub fn separated(self) -> Result<Separated, Diagnostic> {
        let demand = self.demand();
        let paths = self.paths()?;
        let released = self.released()?;
        Ok(Separated {
            caught: self.caught,
            needed: self.needed,
            last: self.last,
            recovered: self.recovered(),
            products: self.products(),
            reynolds: self.reynolds(),
            tilt: self.spinning.turning.tilt(),
            radii: self.spinning.turning.radii(),
            full_time: self.spinning.clock.counted(self.study.task.time),
            run_up: self.spinning.ramp.as_ref().map(|r: &Ramp| RunUpTime { duration: r.duration(), equivalent: r.equivalent() }),
            demand,
            paths,
            released,
            exits: self.exits,
        })
    }

    /// The recovery over time.
    fn recovered(&self) -> Recovered {
        let s = &self.study.task;
        let times = sorted(self.exits.iter().map(|e| e.map(|e| e.time)));
        let first = quantile(&times, 0.01).min(s.time);
        let finite = times.iter().rev().copied().find(|t| t.is_finite()).unwrap_or(s.time);
        let (from, to) = (0.5 * first.max(1e-9 * s.time), 1.05 * finite.max(s.time));
        let mut time: Vec<f64> = (0..=120).map(|k| from * (to / from).powf(k as f64 / 120.0)).chain([s.time]).collect();
        ascending(&mut time);
        time.dedup();
        let at = |surface: Surface| time.iter().map(|&t| self.recovery.share_at(t, surface)).collect();
        Recovered {
            share: time.iter().map(|&t| self.recovery.share(t)).collect(),
            wall: at(Surface::Wall),
            bottom: at(Surface::Bottom),
            surface: at(Surface::Free),
            time,
        }
    }

    /// Products of the members without inertia.
    fn products(&self) -> Vec<f64> {
        let sign = if self.study.heavy() { 1.0 } else { -1.0 };
        let found = products(&self.spinning.turning, &self.spinning.crowd, sign);
        sorted(found.into_iter().map(|p| p.map(|p| p.0)))
    }

    /// Largest Reynolds number of the particles of the set, at their exits.
    fn reynolds(&self) -> f64 {
        let batch = self.spinning.batch;
        let mut worst = 0.0f64;
        for (m, e) in self.spinning.crowd.iter().zip(&self.exits) {
            let Some(e) = e else { continue };
            let speed = e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
            let re = batch.medium.reynolds(&batch.powder.particle(&m.point), speed);
            if !(re <= worst) {
                worst = re;
            }
        }
        worst
    }

    /// Paths of the first particles of the set, until they leave or the time at hand ends.
    fn paths(&self) -> Result<Vec<Path>, Diagnostic> {
        let (s, powder) = (self.study, &self.spinning.batch.powder);
        let shown = self.spinning.crowd.iter().take(s.paths);
        let found: Result<Vec<_>, _> = shown
            .map(|m| {
                let particle = powder.particle(&m.point);
                Ok(Path { diameter: 2.0 * particle.radius, places: self.spinning.places(&particle, m, s.task.time, 40)? })
            })
            .collect();
        found.map_err(lost)
    }

    /// The one particle released at a place.
    fn released(&self) -> Result<Option<Released>, Diagnostic> {
        let (s, batch) = (self.study, self.spinning.batch);
        let Some(place) = s.release else { return Ok(None) };
        let particle = s.median();
        let release = Release { particle, place, velocity: s.release_velocity };
        let (exit, reynolds) = self.spinning.released(&release, ONE).map_err(lost)?;
        let mut out = Released { exit, reynolds, path: Vec::new(), swing: None };
        let Some(e) = exit.filter(|e| e.time != 0.0) else { return Ok(Some(out)) };
        out.path = self.spinning.release_path(&release, e.time, 200, ONE).map_err(lost)?;
        // between release and exit as well
        let fastest = out.path.iter().map(|m| size(&m.velocity)).fold(size(&e.velocity), f64::max);
        out.reynolds = reynolds.max(batch.medium.reynolds(&particle, fastest));
        if let Some(Tilt::Swinging(cup)) = self.spinning.journey(particle).map(|j| j.tilt) {
            let ramp = self.spinning.ramp.as_ref();
            let speeds = out.path.iter().map(|p| ramp.map_or(s.speed, |r| r.at(p.time).0));
            out.swing = Some(speeds.map(|w| (cup.equilibrium(w), w)).collect());
        }
        Ok(Some(out))
    }
}

pub(super) fn size(v: &[f64; 3]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}
