//! What a recovery takes: time and speed, and how both depend on speed, size, density and viscosity.

use super::Separation;
use super::report::{Built, EnsembleResult};
use crate::outcome::{Finding, Table, quantity, significant};
use crate::separation::batch::{Batch, FELT, RunUp, Spinning};
use crate::separation::ensemble::Model;
use crate::separation::law::Law;
use crate::separation::machine::Turning;
use crate::separation::measures;
use crate::separation::particle::Particle;
use crate::separation::validity::{FIELD, gravity_felt};
use crate::study::centrifuge::cups::task::needed;
use crate::study::shared::support::RPM;
use laval_num::univariate::maximum;

/// Highest speed shown over that of the study.
pub(super) const HIGHEST_SHOWN: f64 = 4.0;

/// Another speed can be requested: no particle after the other must be integrated with its inertia.
pub(super) fn searched(study: &Separation, spinning: &Spinning) -> bool {
    study.speed != 0.0 && affordable(study, spinning, HIGHEST_SHOWN * study.speed)
}

fn affordable(study: &Separation, spinning: &Spinning, speed: f64) -> bool {
    if !spinning.integrated() {
        return true;
    }
    let (batch, powder) = (&study.task.batch, &study.task.suspension.powder);
    let median = Particle { radius: 0.5 * powder.size.quantile(0.5), density: powder.density.quantile(0.5) };
    match batch.model {
        Model::Drifting => true,
        Model::Inertial => false,
        Model::Adaptive => 0.5 * study.task.suspension.medium.rates(&median).two_n >= FELT * speed.abs(),
    }
}

/// A law with all values times a factor.
fn scaled(law: &Law, by: f64) -> Law {
    let all = |points: &[(f64, f64)]| points.iter().map(|p| (by * p.0, p.1)).collect();
    match law {
        Law::Single(x) => Law::Single(by * x),
        Law::LogNormal { median, gsd } => Law::LogNormal { median: by * median, gsd: *gsd },
        Law::RosinRammler { characteristic, spread } => Law::RosinRammler { characteristic: by * characteristic, spread: *spread },
        Law::Cumulative(points) => Law::Cumulative(all(points)),
        Law::Classes(points) => Law::Classes(all(points)),
    }
}

/// A law of densities whose distance from the liquid's is multiplied.
fn moved(law: &Law, liquid: f64, by: f64) -> Law {
    let to = |x: f64| liquid + by * (x - liquid);
    match law {
        Law::Single(x) => Law::Single(to(*x)),
        Law::Cumulative(points) => Law::Cumulative(points.iter().map(|p| (to(p.0), p.1)).collect()),
        Law::Classes(points) => Law::Classes(points.iter().map(|p| (to(p.0), p.1)).collect()),
        Law::LogNormal { .. } | Law::RosinRammler { .. } => {
            const POINTS: usize = 1000;
            let share = |k: usize| (k as f64 / POINTS as f64).clamp(1e-9, 1.0 - 1e-9);
            Law::Cumulative((0..=POINTS).map(|k| (to(law.quantile(share(k))), k as f64 / POINTS as f64)).collect())
        }
    }
}

impl EnsembleResult<'_> {
    /// Another speed can be requested.
    pub fn any_speed(&self) -> bool {
        searched(self.study, self.spinning)
    }

    /// Time a batch takes at a speed, s; NaN where a path cannot be computed.
    fn time_of(&self, batch: &Batch, speed: f64) -> f64 {
        // a search goes on over numbers that are not there, but each must cost nothing
        if !(self.goes_on)() {
            return f64::NAN;
        }
        needed(batch, speed, self.study.task.recovery, self.watch).unwrap_or(f64::NAN)
    }

    /// Time the recovery takes at another speed, s; NaN where a path cannot be computed.
    fn time_at(&self, speed: f64) -> f64 {
        self.time_of(&self.study.task.batch, speed)
    }

    /// The lowest speed that catches the recovery in the time at hand, and the width of its bracket: scanned from below, then narrowed. Otherwise the highest
    /// speed looked at.
    fn speed_needed(&self) -> Result<(f64, f64), f64> {
        let s = self.study;
        let spare = |w: f64| {
            let t = self.time_at(w);
            if t > 0.0 { (s.task.time / t).ln() } else { f64::NEG_INFINITY }
        };
        if spare(0.0) >= 0.0 {
            return Ok((0.0, 0.0));
        }
        let (mut earlier, mut before) = ((0.0, f64::NEG_INFINITY), (0.0, f64::NEG_INFINITY));
        for k in 0..40 {
            // from a hundredth to a hundred times the speed
            let w = s.speed.abs() * 10f64.powf(-2.0 + 4.0 * k as f64 / 39.0);
            if !affordable(s, self.spinning, w) {
                break;
            }
            let m = spare(w);
            // between the speeds scanned it may suffice for a while
            let hill = before.1 > earlier.1 && before.1 > m && earlier.1.is_finite();
            let top = if hill { maximum(|x| Some(spare(x)), earlier.0, w, 1e-9 * w).filter(|t| t.1 >= 0.0) } else { None };
            if m >= 0.0 || top.is_some() {
                let (mut low, mut high) = match top {
                    Some(top) => (if top.0 > before.0 { before } else { earlier }, top),
                    None => (before, (w, m)),
                };
                for k in 0..60 {
                    if high.0 - low.0 < 1e-9 * high.0 {
                        break;
                    }
                    // the time falls like the square of the speed: secant in its logarithm, and the middle every third time
                    let middle = k % 3 == 2 || !low.1.is_finite();
                    let share = if middle { 0.5 } else { (low.1 / (low.1 - high.1)).clamp(1e-6, 1.0 - 1e-6) };
                    let x = if low.0 == 0.0 { 0.5 * high.0 } else { low.0 * (high.0 / low.0).powf(share) };
                    let m = spare(x);
                    if m >= 0.0 { high = (x, m) } else { low = (x, m) }
                }
                return Ok((high.0, high.0 - low.0));
            }
            (earlier, before) = (before, (w, m));
        }
        Err(before.0)
    }

    /// The speed a recovery needs, and whether the model still holds there.
    pub fn speed_findings(&self, name: &str) -> Vec<Finding> {
        let s = &self.study.task;
        let time = match s.throughput {
            Some(q) => format!("at {} l/h", significant(q * 3.6e6, 4)),
            None => format!("in {}", quantity(s.time, "s")),
        };
        let with = match s.batch.run_up {
            RunUp::None => "",
            RunUp::Linear(_) | RunUp::Smooth(_) => ", the run-up at the same acceleration included",
            RunUp::Programme(_) => ", with all speeds of the programme in proportion to the last",
        };
        let found = self.speed_needed();
        let finding = match found {
            Ok((0.0, _)) => {
                Finding::info("speed_needed", format!("Gravity alone catches {name} {time}: no spin is needed, {{}}.")).value(0.0, "rad/s")
            }
            Ok((w, bracket)) => Finding::info("speed_needed", format!("Catching {name} {time} takes at least {{}}{with}."))
                .value(w, "rad/s")
                .shown_as(w * RPM, "rpm")
                .evidence("width of the bracket", bracket, "rad/s")
                .evidence("places of the fixed set", s.batch.places as f64, ""),
            Err(highest) => {
                let text =
                    format!("None of the speeds computed, up to {} rpm, catches {name} {time}{with}.", significant(highest * RPM, 4));
                Finding::warning("speed_needed", text)
            }
        };
        let felt = found.ok().and_then(|(w, _)| gravity_felt(&s.vessel.separator, w, s.suspension.medium.gravity));
        let doubt = felt.map(|field| {
            let text = format!(
                "At the speed needed the field is {{}} g at the innermost liquid; the model of a machine that liquid flows through leaves gravity out, which holds from {} g on.",
                significant(FIELD, 2)
            );
            Finding::warning("speed_needed_gravity", text).value(field, "").evidence("least field over gravity", FIELD, "")
        });
        std::iter::once(finding).chain(doubt).collect()
    }

    /// Times at a row of speeds, and how the time depends on each parameter.
    pub fn demand_tables(&self) -> Built<(Table, Table)> {
        let speeds: Vec<f64> = (0..=32).map(|k| self.study.speed.abs() * HIGHEST_SHOWN.powf(-1.0 + 2.0 * k as f64 / 32.0)).collect();
        let times: Vec<f64> = speeds.iter().map(|&w| self.time_at(w)).collect();
        Ok((self.demand_table(&speeds, &times)?, sensitivity_table(&self.sensitivities())?))
    }

    fn demand_table(&self, speeds: &[f64], times: &[f64]) -> Built<Table> {
        let s = &self.study.task;
        let g = s.suspension.medium.gravity;
        let times = times.iter().map(|&t| if t.is_finite() { t } else { f64::NAN }).collect();
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
        table.float("speed", "rad/s", "spin speed", speeds.to_vec()).build()
    }

    /// d ln t_q/d ln p by central differences.
    fn sensitivities(&self) -> [(&'static str, f64); 4] {
        let (w, s) = (self.study.speed, &self.study.task);
        let h: f64 = 0.01;
        let slope = |name: &'static str, time: &dyn Fn(f64) -> f64| {
            let d = (time(1.0 + h) / time(1.0 - h)).ln() / ((1.0 + h) / (1.0 - h)).ln();
            (name, if d.is_finite() { d } else { f64::NAN })
        };
        let with = |change: &dyn Fn(&mut Batch)| {
            let mut batch = s.batch.clone();
            change(&mut batch);
            self.time_of(&batch, w)
        };
        [
            slope("speed", &|by| self.time_at(w * by)),
            slope("size", &|by| with(&|b| b.powder.size = scaled(&b.powder.size, by))),
            slope("density difference", &|by| with(&|b| b.powder.density = moved(&b.powder.density, b.medium.density, by))),
            slope("viscosity", &|by| with(&|b| b.medium.viscosity *= by)),
        ]
    }
}

fn sensitivity_table(rows: &[(&str, f64)]) -> Built<Table> {
    Table::new("sensitivity", "Relative change of the time needed over the relative change of a parameter (d ln t_q/d ln p)")
        .text("parameter", "parameter", rows.iter().map(|r| r.0.into()).collect())
        .float("exponent", "", "exponent of the time; NaN where the share is never caught", rows.iter().map(|r| r.1).collect())
        .build()
}
