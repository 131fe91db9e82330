//! What a separation study tells: findings, tables, figures.

use super::{ONE, Separation};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Axis, Figure, Finding, Line, Outcome, OutcomeError, Panel, Points, Rule, Table, quantity, significant};
use crate::separation::closed::{Closed, Path};
use crate::separation::ensemble::{Member, Model, cut_size, efficiency, leave, members, products, quantile, sorted};
use crate::separation::exit::{Exit, Surface};
use crate::separation::machine::{Separator, Turning};
use crate::separation::measures::{self, Capture};
use crate::separation::motion::Tilt;
use crate::separation::particle::{Drag, Particle};
use crate::separation::validity::{Case, Flag, flags};
use crate::study::Context;
use crate::study::Study;
use crate::study::support::RPM;

/// Results of the ensemble.
pub(super) struct Found<'a> {
    pub study: &'a Separation,
    pub turning: Turning,
    pub crowd: Vec<Member>,
    pub exits: Vec<Option<Exit>>,
}

/// Members used where the ensemble is run again and again.
const FEW: usize = 20_000;

type Built<T> = Result<T, OutcomeError>;

impl Found<'_> {
    pub fn outcome(&self, _: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let s = self.study;
        let times = sorted(self.exits.iter().map(|e| e.map(|e| e.time)));
        let caught = efficiency(&times, s.time);
        let needed = quantile(&times, s.recovery);
        let mut out = Outcome::new(Separation::KIND, context.name).work("particles", self.crowd.len() as u64);
        let what = s.vessel.separator.word();
        let rpm = format!("{} rpm", significant(s.speed * RPM, 4));
        let percent = |x: f64| format!("{} %", significant(100.0 * x, 4));
        let at = match s.throughput {
            Some(q) => format!("at {rpm} and {} l/h", significant(q * 3.6e6, 4)),
            None => format!("in {} at {rpm}", quantity(s.time, "s")),
        };
        out = out.finding(
            Finding::info("caught", format!("{{}} of the particles are caught {at} ({}).", what.replace('_', " ")))
                .value(caught, "")
                .shown_as(100.0 * caught, "%")
                .evidence("particles of the fixed set", self.crowd.len() as f64, "")
                .evidence("share of one particle", 1.0 / self.crowd.len() as f64, ""),
        );
        let name = percent(s.recovery);
        out = if needed.is_finite() {
            let text = match s.throughput {
                Some(_) => format!("Catching {name} takes a residence time of {{}} at this speed."),
                None => format!("Catching {name} takes {{}} at this speed."),
            };
            out.finding(Finding::info("time_needed", text).value(needed, "s").evidence("time at hand", s.time, "s"))
        } else {
            let text = format!("{name} are never caught at this speed: some particles stay in the liquid.");
            out.finding(Finding::warning("time_needed", text))
        };
        // other speeds and sizes are answered by the closed form only
        let closed = !s.integrated() && s.speed != 0.0;
        if closed {
            out = out.finding(self.speed_finding(&name));
        }
        out = self.describe(out);
        let reynolds = self.reynolds()?;
        let wall = self.exits.iter().filter(|e| e.is_some_and(|e| e.surface == Surface::Wall)).count() as f64 / self.exits.len() as f64;
        let judged = flags(&Case {
            separator: &s.vessel.separator,
            medium: &s.suspension.medium,
            particle: &self.median(),
            speed: s.speed,
            reynolds,
            wall_share: wall,
            ramp: s.ramp.as_ref().map_or(0.0, |r| r.duration()),
            temperature: s.suspension.temperature,
        });
        for f in judged.iter().filter(|f| f.raised()) {
            let text = format!("Validity ({}): {}; {{}} where the limit is {}.", f.name, f.meaning, significant(f.limit, 3));
            let id = format!("validity_{}", f.name.replace([' ', '-'], "_"));
            let finding = if f.value.is_finite() {
                Finding::warning(id, text).value(f.value, "")
            } else {
                Finding::warning(id, text.replace("{}", "no number"))
            };
            out = out.finding(finding);
        }
        let built = || -> Built<Outcome> {
            let mut out = out.table(self.efficiency_table(&times)?);
            out = out.table(self.measures_table()?);
            if self.stokes() {
                let (grade, cuts) = self.grade_tables()?;
                out = out.table(grade).table(cuts);
            }
            if closed {
                out = out.table(self.demand_table()?).table(self.sensitivity_table()?);
            }
            out = out.table(validity_table(&judged)?);
            if let Some(t) = self.pellet_table()? {
                out = out.table(t);
            }
            if let Some(t) = self.paths_table()? {
                out = out.table(t);
            }
            Ok(out)
        };
        let mut out = built().map_err(Diagnostic::from)?;
        out = self.followed(out)?;
        out = self.figures(out);
        out.checked().map_err(Diagnostic::from)
    }

    /// Sizes and times scale with each other.
    fn stokes(&self) -> bool {
        self.study.suspension.medium.drag == Drag::Stokes
    }

    /// The particle of median size and density.
    fn median(&self) -> Particle {
        let p = &self.study.suspension.powder;
        Particle { radius: 0.5 * p.size.quantile(0.5), density: p.density.quantile(0.5) }
    }

    /// Largest Reynolds number of the largest tenth of the particles: at their exits, where they are fastest.
    fn reynolds(&self) -> Result<f64, Diagnostic> {
        let s = self.study;
        let mut worst = 0.0f64;
        for (m, e) in self.crowd.iter().zip(&self.exits) {
            let Some(e) = e else { continue };
            let speed = e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
            worst = worst.max(s.suspension.medium.reynolds(&s.suspension.powder.particle(&m.point), speed));
        }
        Ok(worst)
    }

    /// Time a share takes at another speed, with few members.
    fn time_at(&self, speed: f64, change: impl Fn(&mut Particle)) -> f64 {
        let s = self.study;
        let turning = s.vessel.separator.at(speed);
        let mut few = members(&turning, FEW.min(s.particles));
        if s.slowest {
            let heavy = self.median().density > s.suspension.medium.density;
            few.iter_mut().for_each(|m| m.start = turning.slowest(heavy));
        }
        let times = sorted(few.iter().map(|m| {
            let mut p = s.suspension.powder.particle(&m.point);
            change(&mut p);
            leave(&turning, &s.suspension.medium, &p, m, s.model).map(|e| e.time)
        }));
        quantile(&times, s.recovery)
    }

    /// The lowest speed that catches the recovery in the time at hand: scanned from below, then halved.
    fn speed_needed(&self) -> Option<(f64, f64)> {
        let s = self.study;
        let enough = |w: f64| self.time_at(w, |_| ()) <= s.time;
        if enough(0.0) {
            return Some((0.0, 0.0));
        }
        let mut low = 0.0;
        for k in 0..64 {
            // from a hundredth to a hundred times the speed
            let w = s.speed.abs() * 10f64.powf(-2.0 + 4.0 * k as f64 / 63.0);
            if enough(w) {
                let mut high = w;
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    if enough(middle) {
                        high = middle
                    } else {
                        low = middle
                    }
                    if high - low < 1e-9 * high {
                        break;
                    }
                }
                return Some((high, high - low));
            }
            low = w;
        }
        None
    }

    fn speed_finding(&self, name: &str) -> Finding {
        let s = self.study;
        let time = match s.throughput {
            Some(q) => format!("at {} l/h", significant(q * 3.6e6, 4)),
            None => format!("in {}", quantity(s.time, "s")),
        };
        match self.speed_needed() {
            Some((0.0, _)) => {
                Finding::info("speed_needed", format!("Gravity alone catches {name} {time}: no spin is needed, {{}}.")).value(0.0, "rad/s")
            }
            Some((w, bracket)) => Finding::info("speed_needed", format!("Catching {name} {time} takes at least {{}}."))
                .value(w, "rad/s")
                .shown_as(w * RPM, "rpm")
                .evidence("width of the bracket", bracket, "rad/s")
                .evidence("particles", FEW.min(s.particles) as f64, ""),
            None => Finding::warning("speed_needed", format!("No speed up to a hundred times this one catches {name} {time}.")),
        }
    }

    /// Tilt, field, cut size.
    fn describe(&self, mut out: Outcome) -> Outcome {
        let s = self.study;
        let g = s.suspension.medium.gravity;
        let (r1, r2) = self.turning.radii();
        if let (Separator::Cup(cup), Some(tilt)) = (&s.vessel.separator, self.turning.tilt()) {
            let text = if cup.held.is_some() {
                "The cup is held at a tilt of {}.".to_string()
            } else if tilt == 0.0 {
                "The cup hangs straight down: it does not swing out at this speed ({}).".to_string()
            } else {
                "The cup swings out to {} from the vertical.".to_string()
            };
            let swing = cup.hanging.swing_frequency(s.speed, tilt);
            let f = Finding::info("tilt", text).value(tilt, "rad").shown_as(tilt.to_degrees(), "°");
            out = out.finding(if cup.held.is_some() { f } else { f.evidence("frequency of its small swing", swing, "rad/s") });
        }
        let field = Finding::info(
            "rcf",
            format!("The field grows from {} g at the surface to {{}} g.", significant(measures::rcf(s.speed, r1, g), 4)),
        );
        out = out.finding(field.value(measures::rcf(s.speed, r2, g), ""));
        let (taus, heavy) = self.products();
        let d = cut_size(&taus, &s.suspension.medium, self.median().density, 0.5, self.full_time());
        if d.is_finite() && d > 0.0 && self.stokes() {
            let kind = if heavy { "" } else { " (light particles)" };
            out = out.finding(Finding::info("cut_size", format!("Half of the particles of {{}} are caught{kind}.")).value(d, "m"));
        }
        out
    }

    /// The time at hand, counted at full speed.
    fn full_time(&self) -> f64 {
        let s = self.study;
        s.ramp.as_ref().map_or(s.time, |r| (s.time - r.duration()).max(0.0) + r.equivalent())
    }

    /// Sorted products tau of the members without inertia, and whether particles are heavy.
    fn products(&self) -> (Vec<f64>, bool) {
        let heavy = self.median().density > self.study.suspension.medium.density;
        let sign = if heavy { 1.0 } else { -1.0 };
        (sorted(products(&self.turning, &self.crowd, sign).into_iter().map(|p| p.map(|p| p.0))), heavy)
    }

    fn efficiency_table(&self, times: &[f64]) -> Built<Table> {
        let s = self.study;
        let first = quantile(times, 0.01).min(s.time);
        let finite = times.iter().rev().copied().find(|t| t.is_finite()).unwrap_or(s.time);
        let (from, to) = (0.5 * first.max(1e-9 * s.time), 1.05 * finite.max(s.time));
        let mut at: Vec<f64> = (0..=120).map(|k| from * (to / from).powf(k as f64 / 120.0)).chain([s.time]).collect();
        at.sort_by(f64::total_cmp);
        at.dedup();
        let share = |surface: Surface| -> Vec<f64> {
            let own = sorted(self.exits.iter().map(|e| e.filter(|e| e.surface == surface).map(|e| e.time)));
            at.iter().map(|&t| efficiency(&own, t)).collect()
        };
        Table::new("efficiency", "Share of the particles caught over time")
            .float("efficiency", "", "share caught", at.iter().map(|&t| efficiency(times, t)).collect())
            .float("wall", "", "share caught at the wall", share(Surface::Wall))
            .float("bottom", "", "share caught at the bottom", share(Surface::Bottom))
            .float("surface", "", "share that reached the surface of the liquid", share(Surface::Free))
            .float("time", "s", if s.throughput.is_some() { "residence time" } else { "time" }, at)
            .build()
    }

    fn grade_tables(&self) -> Built<(Table, Table)> {
        let s = self.study;
        let (taus, _) = self.products();
        let (medium, density, t) = (&s.suspension.medium, self.median().density, self.full_time());
        let size = |q: f64| cut_size(&taus, medium, density, q, t);
        let last = taus.iter().rev().copied().find(|t| t.is_finite()).unwrap_or(f64::NAN);
        let top = 2.2 * medium.radius_for(last / t, density);
        let diameters: Vec<f64> = if top.is_finite() { (1..=80).map(|k| top * k as f64 / 80.0).collect() } else { vec![] };
        let grade: Vec<f64> = diameters
            .iter()
            .map(|d| efficiency(&taus, medium.rates(&Particle { radius: 0.5 * d, density }).sedimentation.abs() * t))
            .collect();
        let grade = Table::new("grade", "Share caught in the time at hand over the size of the particles, without inertia")
            .float("diameter", "m", "diameter", diameters)
            .float("efficiency", "", "share caught", grade)
            .build()?;
        let finite = |q: f64| if size(q).is_finite() { size(q) } else { f64::NAN };
        let shares = vec![0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.0];
        let cuts = Table::new("cut_size", "Diameter of which a share is caught in the time at hand, without inertia")
            .float("diameter", "m", "diameter; NaN where the share is never caught", shares.iter().map(|&q| finite(q)).collect())
            .float("share", "", "share caught", shares)
            .build()?;
        Ok((grade, cuts))
    }

    fn measures_table(&self) -> Built<Table> {
        let s = self.study;
        let (w, medium) = (s.speed, &s.suspension.medium);
        let (r1, r2) = self.turning.radii();
        let g = medium.gravity;
        let sed = medium.rates(&self.median()).sedimentation;
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
            if let Some(other) = s.transfer {
                rows.push((
                    "time in the other rotor",
                    measures::transfer(s.time, k, other),
                    "s",
                    "clears as much as the time at hand does here",
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
        if let Some(ramp) = &s.ramp {
            rows.push((
                "equivalent of the run-up",
                ramp.equivalent(),
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
            .text("unit", "SI unit", rows.iter().map(|r| r.2.into()).collect())
            .text("meaning", "meaning", rows.iter().map(|r| r.3.into()).collect())
            .build()
    }

    fn demand_table(&self) -> Built<Table> {
        let s = self.study;
        let g = s.suspension.medium.gravity;
        let speeds: Vec<f64> = (0..=32).map(|k| s.speed.abs() * 4f64.powf(-1.0 + 2.0 * k as f64 / 32.0)).collect();
        let times = speeds.iter().map(|&w| self.time_at(w, |_| ())).map(|t| if t.is_finite() { t } else { f64::NAN }).collect();
        let turned: Vec<Turning> = speeds.iter().map(|&w| s.vessel.separator.at(w)).collect();
        let mut table = Table::new("demand", format!("Time that catches {} % over the speed", significant(100.0 * s.recovery, 4)))
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
        table.float("speed", "rad/s", "spin speed", speeds).build()
    }

    fn sensitivity_table(&self) -> Built<Table> {
        let s = self.study;
        let h: f64 = 0.02;
        // central differences in the logarithm: the steps of the order statistics are small against two percent
        let slope = |up: f64, down: f64| {
            let d = (up / down).ln() / ((1.0 + h) / (1.0 - h)).ln();
            if d.is_finite() { d } else { f64::NAN }
        };
        let of_speed = slope(self.time_at(s.speed * (1.0 + h), |_| ()), self.time_at(s.speed * (1.0 - h), |_| ()));
        let of_size = slope(self.time_at(s.speed, |p| p.radius *= 1.0 + h), self.time_at(s.speed, |p| p.radius *= 1.0 - h));
        let rho = s.suspension.medium.density;
        let of_density = slope(
            self.time_at(s.speed, |p| p.density = rho + (p.density - rho) * (1.0 + h)),
            self.time_at(s.speed, |p| p.density = rho + (p.density - rho) * (1.0 - h)),
        );
        let of_viscosity = {
            let at = |factor: f64| {
                let mut other = s.suspension.clone();
                other.medium.viscosity *= factor;
                let few = members(&self.turning, FEW.min(s.particles));
                quantile(
                    &sorted(
                        few.iter()
                            .map(|m| leave(&self.turning, &other.medium, &other.powder.particle(&m.point), m, s.model).map(|e| e.time)),
                    ),
                    s.recovery,
                )
            };
            slope(at(1.0 + h), at(1.0 - h))
        };
        let rows = [("speed", of_speed), ("size", of_size), ("density difference", of_density), ("viscosity", of_viscosity)];
        Table::new("sensitivity", "Relative change of the time needed over the relative change of a parameter (d ln t_q/d ln p)")
            .text("parameter", "parameter", rows.iter().map(|r| r.0.into()).collect())
            .float("exponent", "", "exponent of the time; NaN where the share is never caught", rows.iter().map(|r| r.1).collect())
            .build()
    }

    /// Where particles lie that left through the wall or the bottom.
    fn pellet_table(&self) -> Built<Option<Table>> {
        const BINS: usize = 10;
        let (radius, from, to) = match &self.study.vessel.separator {
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

    fn paths_table(&self) -> Built<Option<Table>> {
        let s = self.study;
        let Some(steady) = self.turning.steady().filter(|_| s.paths > 0 && !s.integrated()) else { return Ok(None) };
        let mut columns: [Vec<f64>; 5] = Default::default();
        let mut number = Vec::new();
        let mut shown = 0;
        for (m, e) in self.crowd.iter().zip(&self.exits) {
            let Some(e) = e else { continue };
            if shown == s.paths {
                break;
            }
            shown += 1;
            let rates = s.suspension.medium.rates(&s.suspension.powder.particle(&m.point));
            let path = Closed::new(&rates, &steady, m.start, [0.0; 3]);
            for k in 0..=40 {
                let t = e.time * k as f64 / 40.0;
                let x = path.at(t).0;
                number.push(shown as i64);
                for (c, v) in columns.iter_mut().zip([t, x[0], x[1], x[2], steady.radius(x)]) {
                    c.push(v);
                }
            }
        }
        let [t, x, y, z, r] = columns;
        Table::new("paths", "Paths of some particles in the axes of the cup")
            .int("particle", "", "number of the particle", number)
            .float("time", "s", "time", t)
            .float("x", "m", "across the cup", x)
            .float("y", "m", "along the cup, from the hinge or mouth", y)
            .float("z", "m", "across the cup, in the sense of rotation", z)
            .float("radius", "m", "distance from the spin axis", r)
            .build()
            .map(Some)
    }

    /// The one particle released at a place.
    fn followed(&self, mut out: Outcome) -> Result<Outcome, Diagnostic> {
        let s = self.study;
        let Some(start) = s.release else { return Ok(out) };
        let particle = self.median();
        let rates = s.suspension.medium.rates(&particle);
        let (exit, reynolds) = match s.journey(particle) {
            Some(journey) if s.integrated() => s.arrive(&journey, start, ONE)?,
            _ => {
                let exit = match s.model {
                    Model::Inertial => self.turning.settle(&rates, start),
                    Model::Drifting => self.turning.drift(rates.sedimentation, start),
                };
                let speed = exit.map_or(0.0, |e| e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt());
                (exit, s.suspension.medium.reynolds(&particle, speed))
            }
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
        let path: Vec<(f64, [f64; 3], f64)> = if let (Some(journey), true) = (s.journey(particle), s.integrated()) {
            let times: Vec<f64> = (0..=200).map(|k| e.time * k as f64 / 200.0 * (1.0 - 1e-12)).collect();
            let arrival = journey.follow(journey.start(start), e.time, ONE, &times);
            let moments = arrival.map(|a| a.moments).unwrap_or_default();
            moments.iter().map(|m| (m.t, [m.state[0], m.state[1], m.state[2]], m.state[6])).collect()
        } else if let Some(steady) = self.turning.steady() {
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
        if let Some(Tilt::Swinging(cup)) = s.journey(particle).map(|j| j.tilt) {
            let ramp = s.ramp.as_ref();
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

    fn figures(&self, mut out: Outcome) -> Outcome {
        let s = self.study;
        let line = |y: &str, name: &str| Line::new("efficiency", "time", y).name(name);
        let mut panel = Panel::new(Axis::new("share caught", "%").factor(100.0).range(0.0, 102.0)).mark(line("efficiency", "all"));
        let flow = s.throughput.is_some();
        for (column, name) in [("wall", "at the wall"), ("bottom", "at the bottom"), ("surface", "at the surface")] {
            let used = out
                .find_table("efficiency")
                .and_then(|t| t.column(column))
                .is_some_and(|c| c.number(c.data.len().saturating_sub(1)).is_some_and(|x| x > 0.0));
            if used && !flow {
                panel = panel.mark(line(column, name));
            }
        }
        panel = panel.mark(Rule::x(s.time, if flow { "residence time" } else { "time at hand" })).mark(Rule::y(s.recovery, ""));
        let unit = if s.time >= 600.0 { ("min", 1.0 / 60.0) } else { ("s", 1.0) };
        let x = Axis::log(if flow { "residence time" } else { "time" }, unit.0).factor(unit.1);
        let alt = "Share of the particles caught over time, with the time at hand and the recovery asked for.";
        out = out.figure(Figure::new("efficiency", "Recovery over time", alt).x(x).panel(panel));
        if out.find_table("grade").is_some_and(|t| t.rows() > 0) {
            let panel = Panel::new(Axis::new("share caught", "%").factor(100.0).range(0.0, 102.0))
                .mark(Line::new("grade", "diameter", "efficiency"))
                .mark(Rule::y(0.5, "cut size"));
            let alt = "Share of the particles caught in the time at hand over their diameter.";
            out = out.figure(Figure::new("grade", "Grade efficiency", alt).x(Axis::new("diameter", "µm").factor(1e6)).panel(panel));
        }
        if out.find_table("demand").is_some() {
            let panel = Panel::new(Axis::log("time needed", unit.0).factor(unit.1))
                .mark(Line::new("demand", "speed", "time"))
                .mark(Rule::x(s.speed, "this speed"))
                .mark(Rule::y(s.time, if flow { "residence time" } else { "time at hand" }));
            let alt = "Time that catches the recovery asked for, over the spin speed.";
            out = out.figure(Figure::new("demand", "Time over speed", alt).x(Axis::log("spin speed", "rpm").factor(RPM)).panel(panel));
        }
        if out.find_table("pellet").is_some() {
            let along =
                Panel::new(Axis::new("share of all", "%").factor(100.0)).mark(Points::new("pellet", "middle", "share").group("where"));
            let alt = "Where particles leave the liquid: share of all particles over the place, along the cup for the wall, from its axis for bottom and surface.";
            out = out.figure(Figure::new("pellet", "Where the particles end", alt).x(Axis::new("place", "mm").factor(1e3)).panel(along));
        }
        if out.find_table("paths").is_some() {
            let side = Panel::new(Axis::new("x", "mm").factor(1e3)).mark(Line::new("paths", "y", "x").group("particle"));
            let turned = Panel::new(Axis::new("z", "mm").factor(1e3)).mark(Line::new("paths", "y", "z").group("particle"));
            let alt = "Paths of some particles in the axes of the cup, across it and in the sense of rotation, from the surface (left) to the bottom (right).";
            out = out.figure(
                Figure::new("paths", "Paths in the cup", alt).x(Axis::new("along the cup", "mm").factor(1e3)).panel(side).panel(turned),
            );
        }
        if out.find_table("released").is_some() {
            let place = |c: &str| Line::new("released", "time", c).name(c);
            let mut tilt = Panel::new(Axis::new("tilt", "°").factor(180.0 / std::f64::consts::PI))
                .mark(Line::new("released", "time", "tilt").name("cup"));
            if out.find_table("released").is_some_and(|t| t.column("static tilt").is_some()) {
                tilt = tilt.mark(Line::new("released", "time", "static tilt").name("equilibrium at the speed of the moment"));
            }
            let along = Panel::new(Axis::new("along the cup", "mm").factor(1e3)).mark(place("y"));
            let across = Panel::new(Axis::new("across", "mm").factor(1e3)).mark(place("x")).mark(place("z"));
            let alt = "Place of the particle released, over time, and the tilt of its cup.";
            out = out.figure(
                Figure::new("released", "The particle released", alt).x(Axis::new("time", "s")).panel(along).panel(across).panel(tilt),
            );
        }
        out
    }
}

fn validity_table(flags: &[Flag]) -> Built<Table> {
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
