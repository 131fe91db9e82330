//! A limit of stability over the speed and its slopes.
//!
//! ```text
//! Re s(W, p) = 0    dW/dp = -Re(ds/dp) / Re(ds/dW)
//! ```
//!
//! Of a machine without damping, whose limits are double roots, the slopes are not known.

use super::goal::{Sought, Valued};
use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::system::System;
use crate::solve::locate::value_and_slope;
use crate::solve::mode_slopes::mode_slopes;
use crate::solve::rest::{over_speed, rest};
use crate::solve::sectors::Sector;
use crate::study::criterion::Criterion;
use crate::study::stability_map::StabilityMap;
use crate::study::support::About;
use crate::study::{Context, TypedStudy};
use crate::text;
use laval_num::complex::C64;

pub(super) struct StabilityLimit {
    speed: f64,
    value: C64,
    sector: Option<Sector>,
    double: bool,
    /// The growth rises with the speed.
    onset: bool,
}

/// Range searched, over the speed, and speeds in it.
const ABOUT: f64 = 0.35;
const SPEEDS: usize = 48;
/// Steps of Newton's method, and the farthest one, over the speed.
const STEPS: usize = 40;
const FAR: f64 = 0.1;
/// Last step, over the speed.
const TOLERANCE: f64 = 1e-12;

/// The limit next to a speed: an onset or an end where that is given.
fn near(system: &System, at: f64, onset: Option<bool>, context: &Context) -> Result<Option<StabilityLimit>, Diagnostic> {
    let speed = RangeValue { from: (1.0 - ABOUT) * at, to: (1.0 + ABOUT) * at, points: Some(SPEEDS) };
    let study = StabilityMap { speed, parameter: None, about: About::Rest, criterion: Criterion::Growth, threshold: 0.0, frequency: None };
    let found = study.result(system, context)?;
    let Some(row) = found.rows.into_iter().next() else { return Ok(None) };
    let edge = row
        .edges
        .iter()
        .filter(|e| e.located && onset.is_none_or(|o| e.onset == o))
        .min_by(|a, b| (a.speed - at).abs().total_cmp(&(b.speed - at).abs()));
    Ok(edge.map(|e| {
        let beside = row.samples.iter().min_by(|a, b| (a.value - e.value).abs().total_cmp(&(b.value - e.value).abs()));
        StabilityLimit { speed: e.speed, value: e.value, sector: beside.and_then(|s| s.sector), double: e.double, onset: e.onset }
    }))
}

impl StabilityLimit {
    pub fn find(system: &System, at: f64, context: &Context) -> Result<StabilityLimit, Diagnostic> {
        if !(at.is_finite() && at != 0.0) {
            return Err(Diagnostic::error("reach.goal", text!("a limit of stability has a speed")));
        }
        near(system, at, None, context)?.ok_or_else(|| {
            Diagnostic::error("reach.goal", text!("there is no limit of stability near {at}", at = text::quantity(at, "rad/s")))
        })
    }

    /// Where the growth of the mode is zero, and its derivative there.
    fn newton(&self, system: &System) -> Option<(f64, C64, C64)> {
        let state = over_speed(system);
        let (mut speed, mut value) = (self.speed, self.value);
        for _ in 0..STEPS {
            let (s, slope) = value_and_slope(system, &state, speed, value, self.sector)?;
            let step = -s.re / slope.re;
            if !step.is_finite() {
                return None;
            }
            let limit = FAR * speed.abs();
            let step = step.clamp(-limit, limit);
            if step.abs() <= TOLERANCE * speed.abs() {
                return Some((speed, s, slope));
            }
            speed += step;
            value = s + slope.scale(step);
        }
        None
    }
}

impl Sought for StabilityLimit {
    fn unit(&self) -> &'static str {
        "rad/s"
    }

    fn quick(&self) -> bool {
        !self.double
    }

    fn of(&mut self, system: &System, parameters: &[Vec<usize>], context: &Context) -> Result<Option<Valued>, Diagnostic> {
        let far = |speed: f64| (speed - self.speed).abs() > ABOUT * self.speed.abs();
        let own = if self.double { None } else { self.newton(system) };
        // what was an onset does not become an end
        let turned = |slope: C64| (slope.re > 0.0) != self.onset;
        let Some((speed, value, by_speed)) = own.filter(|o| !far(o.0) && !turned(o.2)) else {
            let Some(found) = near(system, self.speed, Some(self.onset), context)? else { return Ok(None) };
            *self = found;
            return Ok(Some(Valued { value: self.speed, slopes: vec![f64::NAN; parameters.len()] }));
        };
        let by_p = mode_slopes(system, &|m: &System| rest(m, speed), value, self.sector, parameters)?;
        let slopes = match by_p {
            Some(by_p) if (by_p.value - value).abs() <= 1e-6 * value.abs() => by_p.slopes.iter().map(|d| -d.re / by_speed.re).collect(),
            _ => vec![f64::NAN; parameters.len()],
        };
        (self.speed, self.value) = (speed, value);
        Ok(Some(Valued { value: speed, slopes }))
    }

    fn mark(&self) -> Vec<f64> {
        vec![self.speed, self.value.re, self.value.im]
    }

    fn back(&mut self, mark: &[f64]) {
        if let [speed, re, im] = mark {
            (self.speed, self.value) = (*speed, C64 { re: *re, im: *im });
        }
    }
}
