//! Tables of a separation: recovery over time, grade efficiency and cut size, engineering measures, validity, demand, pellet, paths.

use super::report::{Built, Shown};
use super::result::{Demand, PARAMETERS, Released};
use crate::outcome::{Arg, Message, Table};
use crate::separation::exit::{Exit, Surface};
use crate::separation::measures::{self, Capture};
use crate::separation::particle::Particle;
use crate::separation::places::Place;
use crate::separation::release::Moment;
use crate::separation::separator::{Separator, Turning};
use crate::separation::suspension::{cut_size, efficiency};
use crate::separation::validity::Flag;

impl Shown<'_> {
    pub fn efficiency_table(&self) -> Built<Table> {
        let r = &self.found.recovered;
        Table::new("efficiency", "Share of the particles caught over time")
            .float("efficiency", "", "share caught", r.share.clone())
            .float("wall", "", "share caught at the wall", r.wall.clone())
            .float("bottom", "", "share caught at the bottom", r.bottom.clone())
            .float("surface", "", "share that reached the surface of the liquid", r.surface.clone())
            .float("time", "s", if self.flow() { "residence time" } else { "time" }, r.time.clone())
            .build()
    }

    pub fn grade_tables(&self) -> Built<(Table, Table)> {
        let s = &self.study.task;
        let taus = &self.found.products;
        let (medium, density, t) = (&s.suspension.medium, self.study.median().density, self.found.full_time);
        let size = |q: f64| cut_size(taus, medium, density, q, t);
        let last = taus.iter().rev().copied().find(|t| t.is_finite()).unwrap_or(f64::NAN);
        let top = 2.2 * medium.radius_for(last / t, density);
        let diameters: Vec<f64> = if top.is_finite() { (1..=80).map(|k| top * k as f64 / 80.0).collect() } else { vec![] };
        let grade: Vec<f64> = diameters
            .iter()
            .map(|d| efficiency(taus, medium.rates(&Particle { radius: 0.5 * d, density }).sedimentation.abs() * t))
            .collect();
        let grade = Table::new("grade", "Share caught in the available time over the size of the particles, without inertia")
            .float("diameter", "m", "diameter", diameters)
            .float("efficiency", "", "share caught", grade)
            .build()?;
        let finite = |q: f64| if size(q).is_finite() { size(q) } else { f64::NAN };
        let shares = vec![0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.0];
        let cuts = Table::new("cut_size", "Diameter of which a share is caught in the available time, without inertia")
            .float("diameter", "m", "diameter; NaN where the share is never caught", shares.iter().map(|&q| finite(q)).collect())
            .float("share", "", "share caught", shares)
            .build()?;
        Ok((grade, cuts))
    }

    pub fn measures_table(&self) -> Built<Table> {
        let s = &self.study.task;
        let (w, medium) = (self.study.speed, &s.suspension.medium);
        let (r1, r2) = self.found.radii;
        let g = medium.gravity;
        let sed = medium.rates(&self.study.median()).sedimentation;
        let mut rows: Vec<(&str, f64, &str, &str)> = vec![
            ("rcf surface", measures::rcf(w, r1, g), "", "field at the surface over gravity"),
            ("rcf bottom", measures::rcf(w, r2, g), "", "field at the bottom or wall over gravity"),
            ("least radius", r1, "m", "radius of the surface"),
            ("largest radius", r2, "m", "radius of the bottom or wall"),
            ("sedimentation", sed, "s", "sedimentation coefficient of the particle of median size and density"),
            ("sedimentation in svedberg", sed / measures::SVEDBERG, "", "the same in 1e-13 s"),
            ("gravity velocity", sed * g, "m/s", "settling velocity of that particle under gravity"),
        ];
        let k = measures::k_factor(w, r1, r2);
        if matches!(s.vessel.separator, Separator::Cup(_) | Separator::Tube(..)) {
            rows.push(("k-factor", k, "", "in svedberg hours: hours that clear particles of 1 S"));
            rows.push((
                "clearing time",
                k / (sed.abs() / measures::SVEDBERG) * 3600.0,
                "s",
                "from surface to bottom along the radius, particle of median size",
            ));
            if let Some(other) = self.study.transfer {
                rows.push((
                    "time in the other rotor",
                    measures::transfer(s.time, k, other),
                    "s",
                    "clears as much as the available time does here",
                ));
            }
        }
        if let (Some(sigma), Some(volume)) = (s.vessel.separator.sigma(w, g), s.vessel.separator.flow_volume()) {
            let note = match sigma.capture {
                Capture::Half => "settling area, half of the particles caught at 2 v_g Sigma",
                Capture::Full => "settling area, all particles caught at v_g Sigma",
            };
            rows.push(("sigma", sigma.area, "m^2", note));
            rows.push((
                "throughput of sigma",
                sigma.throughput(sed, g),
                "m^3/s",
                "throughput at which the particle of median size is just caught, by the convention of sigma",
            ));
            rows.push(("residence time", s.time, "s", "volume over throughput"));
            rows.push(("flow volume", volume, "m^3", "volume the liquid flows through"));
        }
        if let Some(run_up) = &self.found.run_up {
            rows.push((
                "equivalent of the run-up",
                run_up.equivalent,
                "s",
                "time at full speed that separates as much as the run-up, by an estimate along the radius",
            ));
        }
        Table::new("measures", "Engineering measures")
            .text("measure", "measure", rows.iter().map(|r| r.0.into()).collect())
            .float(
                "value",
                "",
                "value in the unit beside it; NaN where there is none",
                rows.iter().map(|r| if r.1.is_finite() { r.1 } else { f64::NAN }).collect(),
            )
            .names("unit", "SI unit", rows.iter().map(|r| r.2.into()).collect())
            .text("meaning", "meaning", rows.iter().map(|r| r.3.into()).collect())
            .in_row_units(&["value"])
            .build()
    }

    pub fn demand_table(&self, demand: &Demand) -> Built<Table> {
        let s = &self.study.task;
        let (g, speeds) = (s.suspension.medium.gravity, &demand.speeds);
        let times = demand.times.iter().map(|&t| if t.is_finite() { t } else { f64::NAN }).collect();
        let turned: Vec<Turning> = speeds.iter().map(|&w| s.vessel.separator.at(w)).collect();
        let mut table = Table::new("demand", Message::new("separation-table-demand").arg("share", Arg::percent(s.recovery).digits(4)))
            .float("time", "s", "time (residence time where liquid flows through); NaN where it is never caught", times)
            .float(
                "rcf",
                "",
                "field at the largest radius over gravity",
                turned.iter().map(|t| measures::rcf(t.speed, t.radii().1, g)).collect(),
            );
        if turned.iter().all(|t| t.tilt().is_some()) {
            table = table.float("tilt", "rad", "tilt", turned.iter().filter_map(Turning::tilt).collect());
        }
        table.float("speed", "rad/s", "spin speed", speeds.clone()).build()
    }

    /// Where particles lie that left through the wall or the bottom.
    pub fn pellet_table(&self) -> Built<Option<Table>> {
        const BINS: usize = 10;
        let (radius, from, to) = match &self.study.task.vessel.separator {
            Separator::Cup(c) => (c.vessel.radius, c.vessel.top, c.vessel.bottom),
            Separator::Tube(t, _) => (t.radius, 0.0, t.length),
            _ => return Ok(None),
        };
        let n = self.found.exits.len() as f64;
        let (mut surface, mut low, mut high, mut share) = (vec![], vec![], vec![], vec![]);
        for s in [Surface::Wall, Surface::Bottom, Surface::Free] {
            if !self.found.exits.iter().flatten().any(|e| e.surface == s) {
                continue;
            }
            let (a, b) = if s == Surface::Wall { (from, to) } else { (0.0, radius) };
            for k in 0..BINS {
                let edge = |k: usize| a + (b - a) * k as f64 / BINS as f64;
                let place = |e: &Exit| if s == Surface::Wall { e.position[1] } else { e.position[0].hypot(e.position[2]) };
                let count = self
                    .found
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
            "Places where particles leave the liquid: along the cup for the wall, by distance from its axis for bottom and surface",
        )
        .text("where", "surface", surface)
        .float("middle", "m", "middle of the interval", low.iter().zip(&high).map(|(a, b)| 0.5 * (a + b)).collect())
        .float("from", "m", "begin of the interval", low)
        .float("to", "m", "end of the interval", high)
        .float("share", "", "share of all particles", share)
        .build()
        .map(Some)
    }

    pub fn paths_table(&self) -> Built<Option<Table>> {
        let rows = || self.found.paths.iter().enumerate().flat_map(|(k, path)| path.places.iter().map(move |p| (k, path.diameter, p)));
        if rows().next().is_none() {
            return Ok(None);
        }
        let column = |f: &dyn Fn(&Place) -> f64| rows().map(|r| f(r.2)).collect();
        // across the plane of a bowl nothing moves but rounding
        let plain = |x: f64, p: &Place| if x.abs() <= 1e-12 * p.radius { 0.0 } else { x };
        Table::new("paths", "Paths of some particles in the axes of the cup, until they leave or the available time ends")
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

    /// The particle released.
    pub fn released_table(&self) -> Built<Option<Table>> {
        let Some(Released { path, swing, .. }) = self.found.released.as_ref().filter(|r| r.leaves()) else { return Ok(None) };
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
        if let Some(swing) = swing {
            table = table
                .float("static tilt", "rad", "tilt of equilibrium at the speed of the moment", swing.iter().map(|s| s.0).collect())
                .float("speed", "rad/s", "spin speed", swing.iter().map(|s| s.1).collect());
        }
        table.build().map(Some)
    }
}

pub(super) fn validity_table(flags: &[Flag]) -> Built<Table> {
    let number = |x: f64| if x.is_finite() { x } else { f64::NAN };
    Table::new("validity", "Numbers that bound the model")
        .text("flag", "name", flags.iter().map(|f| f.name.into()).collect())
        .float("value", "", "value; NaN where there is none", flags.iter().map(|f| number(f.value)).collect())
        .float("limit", "", "where doubts begin", flags.iter().map(|f| f.limit).collect())
        .text("must be", "side of the limit that is safe", flags.iter().map(|f| if f.below { "below" } else { "above" }.into()).collect())
        .flag("raised", "beyond the limit", flags.iter().map(Flag::raised).collect())
        .text("meaning", "what it means beyond", flags.iter().map(|f| f.meaning.into()).collect())
        .build()
}

pub(super) fn sensitivity_table(demand: &Demand) -> Built<Table> {
    Table::new("sensitivity", "Relative change of the time needed over the relative change of a parameter (d ln t_q/d ln p)")
        .text("parameter", "parameter", PARAMETERS.map(String::from).to_vec())
        .float("exponent", "", "exponent of the time; NaN where the share is never caught", demand.exponents.to_vec())
        .build()
}
