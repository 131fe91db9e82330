//! Peaks and jumps of the steady response, with the slopes of [`sensitivity`](crate::study::sensitivity).

use super::goal::{Of, STATED, Sought, Valued};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::study::nonlinear_response::NonlinearResponse;
use crate::study::sensitivity::{Kind, Place, Sensitivity};
use crate::study::support::probe_name;
use crate::study::{Context, TypedStudy};

pub(super) struct Placed {
    kinds: Vec<Kind>,
    of: Of,
    at: f64,
    body: Option<String>,
    range: (f64, f64),
    tilt: bool,
}

/// Speeds beyond the place that are followed, over its speed.
const BEYOND: f64 = 1.8;
/// Farthest that a place moves from one machine to the next, over its speed.
const FAR: f64 = 0.4;
/// Distance within which peaks of several bodies are one resonance, and places are one jump, over the speed.
const ONE_PEAK: f64 = 0.01;
const ONE_JUMP: f64 = 1e-6;

impl Placed {
    pub fn new(kinds: Vec<Kind>, of: Of, at: f64, body: Option<String>, range: (f64, f64)) -> Placed {
        Placed { kinds, of, at, body, range, tilt: false }
    }

    fn same(&self) -> f64 {
        if self.kinds.contains(&Kind::Peak) { ONE_PEAK } else { ONE_JUMP }
    }

    fn range(&self) -> (f64, f64) {
        let (low, high) = self.range;
        if self.at < 0.0 { (low.max(BEYOND * self.at), high) } else { (low, high.min(BEYOND * self.at).max(1.2 * self.at)) }
    }
}

impl Sought for Placed {
    fn unit(&self) -> &'static str {
        self.of.unit(self.tilt)
    }

    fn quick(&self) -> bool {
        false
    }

    fn of(&mut self, system: &System, parameters: &[Vec<usize>], context: &Context) -> Result<Option<Valued>, Diagnostic> {
        let (from, to) = self.range();
        let study = Sensitivity::new(*NonlinearResponse::over(from, to).request());
        let found = study.result(system, context)?.found;
        let named = |p: &&Place| self.body.as_ref().is_none_or(|b| probe_name(&p.probe) == *b || p.probe.name == *b);
        let near = |p: &&Place| (p.moved.speed - self.at).abs() <= FAR * self.at.abs();
        let own: Vec<&Place> = found.places.iter().filter(|p| self.kinds.contains(&p.kind)).filter(named).filter(near).collect();
        // of several bodies with a peak there the one that moves most
        let distance = |p: &Place| (p.moved.speed - self.at).abs();
        let least = own.iter().map(|p| distance(p)).fold(f64::INFINITY, f64::min);
        let together = own.into_iter().filter(|p| distance(p) <= least + self.same() * self.at.abs());
        let Some(place) = together.max_by(|a, b| a.moved.value.total_cmp(&b.moved.value)) else { return Ok(None) };
        self.at = place.moved.speed;
        // a jump up does not become one down
        self.kinds = vec![place.kind];
        self.tilt = place.probe.is_tilt();
        let slope = |moving: &Vec<usize>| {
            let held = found.parameters.iter().zip(&place.moved.slopes).filter(|(n, _)| {
                let own = n.parameter.first..n.parameter.first + n.parameter.count;
                own.clone().all(|i| moving.contains(&i)) && !own.is_empty()
            });
            let (mut sum, mut known) = (0.0, 0);
            for (n, s) in held {
                sum += if self.of == Of::Speed { s.speed } else { s.value };
                known += n.parameter.count;
            }
            if known == moving.len() { sum } else { f64::NAN }
        };
        let value = if self.of == Of::Speed { place.moved.speed } else { place.moved.value };
        Ok(Some(Valued { value, slopes: parameters.iter().map(slope).collect() }))
    }

    fn tolerance(&self) -> f64 {
        self.same().max(STATED)
    }

    fn mark(&self) -> Vec<f64> {
        vec![self.at]
    }

    fn back(&mut self, mark: &[f64]) {
        if let [at] = mark {
            self.at = *at;
        }
    }
}
