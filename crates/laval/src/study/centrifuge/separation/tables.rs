//! Tables of a separation: recovery over time, grade efficiency and cut size, engineering measures, validity.

use super::report::{Built, EnsembleResult};
use crate::outcome::Table;
use crate::separation::ensemble::{cut_size, efficiency, quantile, sorted};
use crate::separation::exit::Surface;
use crate::separation::machine::Separator;
use crate::separation::measures::{self, Capture};
use crate::separation::particle::Particle;
use crate::separation::validity::Flag;

impl EnsembleResult<'_> {
    pub fn efficiency_table(&self) -> Built<Table> {
        let s = &self.study.task;
        let times = sorted(self.exits.iter().map(|e| e.map(|e| e.time)));
        let first = quantile(&times, 0.01).min(s.time);
        let finite = times.iter().rev().copied().find(|t| t.is_finite()).unwrap_or(s.time);
        let (from, to) = (0.5 * first.max(1e-9 * s.time), 1.05 * finite.max(s.time));
        let mut at: Vec<f64> = (0..=120).map(|k| from * (to / from).powf(k as f64 / 120.0)).chain([s.time]).collect();
        at.sort_by(f64::total_cmp);
        at.dedup();
        let share = |surface: Surface| -> Vec<f64> { at.iter().map(|&t| self.recovery.share_at(t, surface)).collect() };
        Table::new("efficiency", "Share of the particles caught over time")
            .float("efficiency", "", "share caught", at.iter().map(|&t| self.recovery.share(t)).collect())
            .float("wall", "", "share caught at the wall", share(Surface::Wall))
            .float("bottom", "", "share caught at the bottom", share(Surface::Bottom))
            .float("surface", "", "share that reached the surface of the liquid", share(Surface::Free))
            .float("time", "s", if s.throughput.is_some() { "residence time" } else { "time" }, at)
            .build()
    }

    pub fn grade_tables(&self) -> Built<(Table, Table)> {
        let s = &self.study.task;
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

    pub fn measures_table(&self) -> Built<Table> {
        let s = &self.study.task;
        let (w, medium) = (self.study.speed, &s.suspension.medium);
        let (r1, r2) = self.spinning.turning.radii();
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
            if let Some(other) = self.study.transfer {
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
        if let Some(ramp) = &self.spinning.ramp {
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
