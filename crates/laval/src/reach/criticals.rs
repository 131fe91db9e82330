//! A critical speed and its slopes.
//!
//! ```text
//! Im s(W, p) = k W    dW/dp = Im(ds/dp) / (k - Im(ds/dW))
//! ```

use super::goal::{Sought, Valued};
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::solve::criticals::Critical;
use crate::solve::locate::{crossing, value_and_slope};
use crate::solve::mode_slopes::mode_slopes;
use crate::solve::rest::{over_speed, rest};
use crate::solve::sectors::Sector;
use crate::study::critical_speeds::CriticalSpeeds;
use crate::study::{Context, TypedStudy};
use crate::text;
use laval_num::complex::c;

pub(super) struct CriticalSpeed {
    order: f64,
    speed: f64,
    growth: f64,
    sector: Option<Sector>,
}

/// Range searched, over the speed: about where a critical speed is stated, and for one that was lost; and speeds in it.
const CLOSE: f64 = 0.02;
const ABOUT: f64 = 0.35;
const SPEEDS: usize = 24;
/// Farthest that Newton's method may lead from where the critical speed was, over the speed.
const FAR: f64 = 0.35;

fn near(
    system: &System,
    (order, at): (f64, f64),
    about: f64,
    sector: Option<Sector>,
    context: &Context,
) -> Result<Option<Critical>, Diagnostic> {
    let speed = RangeValue { from: (1.0 - about) * at, to: (1.0 + about) * at, points: Some(SPEEDS) };
    let study = CriticalSpeeds { speed, orders: vec![order], margin: 0.15 };
    let found = study.result(system, context)?;
    // where one was lost, one that whirls the other way is none in its place
    let all = found.crossings.into_iter().filter(|c| c.located() && (sector.is_none() || c.sector == sector));
    Ok(all.min_by(|a, b| (a.speed - at).abs().total_cmp(&(b.speed - at).abs())))
}

impl CriticalSpeed {
    pub fn find(system: &System, order: f64, at: f64, context: &Context) -> Result<CriticalSpeed, Diagnostic> {
        if !(order > 0.0 && at.is_finite() && at != 0.0) {
            return Err(Diagnostic::error("reach.goal", text!("a critical speed has an order above 0 and a speed")));
        }
        // of two that lie close together a coarse search may see one alone
        let found = match near(system, (order, at), CLOSE, None, context)? {
            Some(found) => Some(found),
            None => near(system, (order, at), ABOUT, None, context)?,
        };
        let found = found.ok_or_else(|| {
            Diagnostic::error("reach.goal", text!("there is no such critical speed near {at}", at = text::quantity(at, "rad/s")))
        })?;
        Ok(CriticalSpeed { order, speed: found.speed, growth: found.growth, sector: found.sector })
    }
}

impl Sought for CriticalSpeed {
    fn unit(&self) -> &'static str {
        "rad/s"
    }

    fn quick(&self) -> bool {
        true
    }

    fn of(&mut self, system: &System, parameters: &[Vec<usize>], context: &Context) -> Result<Option<Valued>, Diagnostic> {
        let state = over_speed(system);
        let own = crossing(system, &state, self.order, self.speed, self.growth, self.sector);
        let own = own.filter(|l| (l.speed - self.speed).abs() <= FAR * self.speed.abs()).map(|l| (l.speed, l.value.re, self.sector));
        let other = || {
            Ok::<_, Diagnostic>(near(system, (self.order, self.speed), ABOUT, self.sector, context)?.map(|c| (c.speed, c.growth, c.sector)))
        };
        let Some((speed, growth, sector)) = own.map_or_else(other, |o| Ok(Some(o)))? else { return Ok(None) };
        let s = c(growth, self.order * speed);
        let by_speed = value_and_slope(system, &state, speed, s, sector).map(|v| v.1.im);
        let by_p = mode_slopes(system, &|m: &System| rest(m, speed), s, sector, parameters)?;
        let slopes = match (by_speed, by_p) {
            (Some(along), Some(by_p)) if (by_p.value - s).abs() <= 1e-6 * s.abs() => {
                by_p.slopes.iter().map(|d| d.im / (self.order - along)).collect()
            }
            _ => vec![f64::NAN; parameters.len()],
        };
        (self.speed, self.growth, self.sector) = (speed, growth, sector);
        Ok(Some(Valued { value: speed, slopes }))
    }

    fn mark(&self) -> Vec<f64> {
        vec![self.speed, self.growth]
    }

    fn back(&mut self, mark: &[f64]) {
        if let [speed, growth] = mark {
            (self.speed, self.growth) = (*speed, *growth);
        }
    }
}
