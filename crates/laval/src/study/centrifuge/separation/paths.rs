//! Where particles of a separation go: paths, pellet, the one particle released.

use super::ONE;
use super::report::{Built, EnsembleResult};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Finding, Outcome, Table, quantity};
use crate::separation::exit::{Exit, Surface};
use crate::separation::machine::Separator;
use crate::separation::motion::Tilt;
use crate::separation::places::Place;
use crate::separation::release::{Moment, Release};
use crate::study::centrifuge::cups::task::lost;

impl EnsembleResult<'_> {
    /// Where particles lie that left through the wall or the bottom.
    pub fn pellet_table(&self) -> Built<Option<Table>> {
        const BINS: usize = 10;
        let (radius, from, to) = match &self.study.task.vessel.separator {
            Separator::Cup(c) => (c.vessel.radius, c.vessel.top, c.vessel.bottom),
            Separator::Tube(t, _) => (t.radius, 0.0, t.length),
            _ => return Ok(None),
        };
        let n = self.exits.len() as f64;
        let (mut surface, mut low, mut high, mut share) = (vec![], vec![], vec![], vec![]);
        for s in [Surface::Wall, Surface::Bottom, Surface::Free] {
            if !self.exits.iter().flatten().any(|e| e.surface == s) {
                continue;
            }
            let (a, b) = if s == Surface::Wall { (from, to) } else { (0.0, radius) };
            for k in 0..BINS {
                let edge = |k: usize| a + (b - a) * k as f64 / BINS as f64;
                let place = |e: &Exit| if s == Surface::Wall { e.position[1] } else { e.position[0].hypot(e.position[2]) };
                let count = self
                    .exits
                    .iter()
                    .flatten()
                    .filter(|e| e.surface == s)
                    .filter(|e| (((place(e) - a) / (b - a) * BINS as f64).floor().clamp(0.0, (BINS - 1) as f64)) as usize == k)
                    .count();
                surface.push(s.word().to_string());
                low.push(edge(k));
                high.push(edge(k + 1));
                share.push(count as f64 / n);
            }
        }
        Table::new(
            "pellet",
            "Where particles leave the liquid: along the cup for the wall, by distance from its axis for bottom and surface",
        )
        .text("where", "surface", surface)
        .float("middle", "m", "middle of the interval", low.iter().zip(&high).map(|(a, b)| 0.5 * (a + b)).collect())
        .float("from", "m", "begin of the interval", low)
        .float("to", "m", "end of the interval", high)
        .float("share", "", "share of all particles", share)
        .build()
        .map(Some)
    }

    /// Paths of the first particles of the set, until they leave or the time at hand ends.
    pub fn paths(&self) -> Result<Vec<(f64, Vec<Place>)>, Diagnostic> {
        let (s, powder) = (self.study, &self.spinning.batch.powder);
        let shown = self.spinning.crowd.iter().take(s.paths);
        let found: Result<Vec<_>, _> = shown
            .map(|m| {
                let particle = powder.particle(&m.point);
                Ok((2.0 * particle.radius, self.spinning.places(&particle, m, s.task.time, 40)?))
            })
            .collect();
        found.map_err(lost)
    }

    pub fn paths_table(paths: &[(f64, Vec<Place>)]) -> Built<Option<Table>> {
        let rows = || paths.iter().enumerate().flat_map(|(k, (d, places))| places.iter().map(move |p| (k, *d, p)));
        if rows().next().is_none() {
            return Ok(None);
        }
        let column = |f: &dyn Fn(&Place) -> f64| rows().map(|r| f(r.2)).collect();
        // across the plane of a bowl nothing moves but rounding
        let plain = |x: f64, p: &Place| if x.abs() <= 1e-12 * p.radius { 0.0 } else { x };
        Table::new("paths", "Paths of some particles in the axes of the cup, until they leave or the time at hand ends")
            .int("particle", "", "number of the particle", rows().map(|r| r.0 as i64 + 1).collect())
            .float("diameter", "m", "its diameter", rows().map(|r| r.1).collect())
            .float("time", "s", "time", column(&|p| p.time))
            .float("x", "m", "across the cup", column(&|p| plain(p.at[0], p)))
            .float("y", "m", "along the cup, from the hinge or mouth; in a bowl outwards from the spin axis", column(&|p| p.at[1]))
            .float("z", "m", "across the cup, in the sense of rotation", column(&|p| plain(p.at[2], p)))
            .float("radius", "m", "distance from the spin axis", column(&|p| p.radius))
            .build()
            .map(Some)
    }

    /// The one particle released at a place.
    pub fn followed(&self, mut out: Outcome) -> Result<Outcome, Diagnostic> {
        let (s, batch) = (self.study, self.spinning.batch);
        let Some(place) = s.release else { return Ok(out) };
        let particle = self.median();
        let release = Release { particle, place, velocity: s.release_velocity };
        let rates = batch.medium.rates(&particle);
        let (exit, reynolds) = self.spinning.released(&release, ONE).map_err(lost)?;
        let Some(e) = exit else {
            return Ok(out.finding(Finding::warning("released", "The particle released never meets a surface.")));
        };
        if e.time == 0.0 {
            return Ok(out.finding(Finding::warning("released", "The place of the release does not lie in the liquid.")));
        }
        let path = self.spinning.release_path(&release, e.time, 200, ONE).map_err(lost)?;
        let size = |v: &[f64; 3]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let speed = size(&e.velocity);
        // between release and exit as well
        let fastest = path.iter().map(|m| size(&m.velocity)).fold(speed, f64::max);
        let reynolds = reynolds.max(batch.medium.reynolds(&particle, fastest));
        let text = format!(
            "The particle released reaches the {} after {{}}, at {} along the cup.",
            e.surface.word(),
            quantity(e.position[1], "m")
        );
        out = out.finding(
            Finding::info("released", text)
                .value(e.time, "s")
                .evidence("x", e.position[0], "m")
                .evidence("y", e.position[1], "m")
                .evidence("z", e.position[2], "m")
                .evidence("speed there", speed, "m/s")
                .evidence("largest Reynolds number", reynolds, "")
                .evidence("drag rate over spin speed n/w", 0.5 * rates.two_n / s.speed.abs(), ""),
        );
        let column = |f: &dyn Fn(&Moment) -> f64| path.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("released", "Path of the particle released")
            .float("time", "s", "time", column(&|m| m.time))
            .float("x", "m", "across the cup", column(&|m| m.place[0]))
            .float("y", "m", "along the cup", column(&|m| m.place[1]))
            .float("z", "m", "across the cup, in the sense of rotation", column(&|m| m.place[2]))
            .float("x'", "m/s", "velocity relative to the cup, across it", column(&|m| m.velocity[0]))
            .float("y'", "m/s", "along it", column(&|m| m.velocity[1]))
            .float("z'", "m/s", "across it, in the sense of rotation", column(&|m| m.velocity[2]))
            .float("tilt", "rad", "tilt of the cup", column(&|m| m.tilt));
        if let Some(Tilt::Swinging(cup)) = self.spinning.journey(particle).map(|j| j.tilt) {
            let ramp = self.spinning.ramp.as_ref();
            let speeds: Vec<f64> = path.iter().map(|p| ramp.map_or(s.speed, |r| r.at(p.time).0)).collect();
            table = table
                .float(
                    "static tilt",
                    "rad",
                    "tilt of equilibrium at the speed of the moment",
                    speeds.iter().map(|&w| cup.equilibrium(w)).collect(),
                )
                .float("speed", "rad/s", "spin speed", speeds);
        }
        Ok(out.table(table.build().map_err(Diagnostic::from)?))
    }
}
