//! Where particles of a separation go: paths, pellet, the one particle released.

use super::ONE;
use super::report::{Built, Found};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Finding, Outcome, Table, quantity};
use crate::separation::closed::{Closed, Path};
use crate::separation::ensemble::Model;
use crate::separation::exit::{Exit, Surface};
use crate::separation::machine::Separator;
use crate::separation::motion::Tilt;
use crate::separation::places::Place;
use crate::study::duty::task::lost;

impl Found<'_> {
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
        let Some(start) = s.release else { return Ok(out) };
        let particle = self.median();
        let rates = batch.medium.rates(&particle);
        let integrated = self.spinning.integrated();
        let (exit, reynolds) = if integrated {
            self.spinning.travel(&particle, start, ONE).map_err(lost)?
        } else {
            let turning = &self.spinning.turning;
            let exit = match batch.model {
                Model::Inertial | Model::Adaptive => turning.settle(&rates, start),
                Model::Drifting => turning.drift(rates.sedimentation, start),
            };
            let speed = exit.map_or(0.0, |e| e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt());
            (exit, batch.medium.reynolds(&particle, speed))
        };
        let Some(e) = exit else {
            return Ok(out.finding(Finding::warning("released", "The particle released never meets a surface.")));
        };
        if e.time == 0.0 {
            return Ok(out.finding(Finding::warning("released", "The place of the release does not lie in the liquid.")));
        }
        let speed = e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
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
        let path: Vec<(f64, [f64; 3], f64)> = if let (Some(journey), true) = (self.spinning.journey(particle), integrated) {
            let times: Vec<f64> = (0..=200).map(|k| e.time * k as f64 / 200.0 * (1.0 - 1e-12)).collect();
            let arrival = journey.follow(journey.start(start), e.time, ONE, &times);
            let moments = arrival.map(|a| a.moments).unwrap_or_default();
            moments.iter().map(|m| (m.t, [m.state[0], m.state[1], m.state[2]], m.state[6])).collect()
        } else if let Some(steady) = self.spinning.turning.steady() {
            let path = Closed::new(&rates, &steady, start, [0.0; 3]);
            (0..=200).map(|k| e.time * k as f64 / 200.0).map(|t| (t, path.at(t).0, steady.tilt)).collect()
        } else {
            vec![]
        };
        let mut table = Table::new("released", "Path of the particle released")
            .float("time", "s", "time", path.iter().map(|p| p.0).collect())
            .float("x", "m", "across the cup", path.iter().map(|p| p.1[0]).collect())
            .float("y", "m", "along the cup", path.iter().map(|p| p.1[1]).collect())
            .float("z", "m", "across the cup, in the sense of rotation", path.iter().map(|p| p.1[2]).collect())
            .float("tilt", "rad", "tilt of the cup", path.iter().map(|p| p.2).collect());
        if let Some(Tilt::Swinging(cup)) = self.spinning.journey(particle).map(|j| j.tilt) {
            let ramp = self.spinning.ramp.as_ref();
            let speeds: Vec<f64> = path.iter().map(|p| ramp.map_or(s.speed, |r| r.at(p.0).0)).collect();
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
