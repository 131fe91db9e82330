//! What motions of a machine with movable masses end in, and how near a motion must come to be recognised.

use crate::solve::stationary::metric::Metric;
use crate::study::nonlinear::stationary::classify::Class;
use serde::{Deserialize, Serialize};

/// Slip rates over the speed that differ by less belong to one motion.
const SAME_SLIP: f64 = 0.03;
/// Points of a motion nearer to each other than this add nothing.
const APART: f64 = 0.1;
/// Most points kept of a motion, images not counted.
const MOST_POINTS: usize = 300;
/// Farthest distance at which a motion may be assigned to an attractor.
const FARTHEST: f64 = 1.0;
/// Share of the nearest approach of a motion that went elsewhere within which motions are assigned.
const SHARE: f64 = 0.5;
/// Share of its size and stir within which motions that swing are one.
const ALIKE: f64 = 0.1;

/// What motions of a machine with movable masses end in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum MassKind {
    /// A state at rest in turning axes.
    Rest {
        /// What kind of state.
        class: Class,
        /// Largest growth rate of small disturbances, 1/s.
        growth: f64,
        /// Small disturbances decay.
        stable: bool,
        /// Coordinates.
        q: Vec<f64>,
    },
    /// Masses that go round or swing.
    Moving {
        /// Mean slip rates over the speed, in rising order within each group of masses that may be exchanged.
        slip: Vec<f64>,
        /// Mean distance of the bodies from the axis, weighted by inertia.
        size: f64,
        /// Largest distance from rest in turning axes, on the same scale.
        stir: f64,
    },
}

/// An attractor of a machine with movable masses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MassAttractor {
    /// What it is.
    pub kind: MassKind,
    /// Distance within which a motion is assigned to it; zero where none is.
    pub radius: f64,
    /// Nearest approach of a motion that ended elsewhere; none where none was followed.
    pub approach: Option<f64>,
}

impl MassAttractor {
    /// It may be ended in.
    pub fn attracts(&self) -> bool {
        self.kind.attracts()
    }
}

impl MassKind {
    fn attracts(&self) -> bool {
        !matches!(self, MassKind::Rest { stable: false, .. })
    }
}

pub(super) struct Attractor {
    pub kind: MassKind,
    /// States on it, with their images.
    points: Vec<Vec<f64>>,
    /// Distance within which a motion is assigned to it; zero where none is.
    pub radius: f64,
    /// Nearest approach of a motion that ended elsewhere; infinite where there was none.
    pub approach: f64,
}

impl Attractor {
    pub fn rest(metric: &Metric, q: &[f64], class: Class, growth: f64, stable: bool) -> Self {
        let points = metric.images(&metric.resting(q));
        Attractor { kind: MassKind::Rest { class, growth, stable, q: q.to_vec() }, points, radius: 0.0, approach: f64::INFINITY }
    }

    /// It may be ended in.
    pub fn attracts(&self) -> bool {
        self.kind.attracts()
    }

    /// What is kept of it.
    pub fn kept(&self) -> MassAttractor {
        MassAttractor { kind: self.kind.clone(), radius: self.radius, approach: Some(self.approach).filter(|a| a.is_finite()) }
    }

    pub fn distance(&self, metric: &Metric, at: &[f64]) -> f64 {
        metric.to_nearest(at, &self.points)
    }
}

#[derive(Default)]
pub(super) struct KnownAttractors {
    pub attractors: Vec<Attractor>,
}

impl KnownAttractors {
    /// The motion with these slip rates.
    pub fn moving(&self, slip: &[f64]) -> Option<usize> {
        let off = |own: &[f64]| own.iter().zip(slip).map(|(a, b)| (a - b).abs()).fold(0.0, crate::study::shared::support::larger);
        self.attractors.iter().position(|a| matches!(&a.kind, MassKind::Moving { slip: own, .. } if off(own) <= SAME_SLIP))
    }

    /// The motion without slip above `round` like which all these windows are (slip rates, size, stir).
    pub fn swinging(&self, windows: &[(Vec<f64>, f64, f64)], round: f64) -> Option<usize> {
        let near = |a: f64, b: f64| (a - b).abs() <= ALIKE * b;
        let like = |own: &[f64], size: f64, stir: f64| {
            let one = |w: &(Vec<f64>, f64, f64)| {
                let slip = w.0.iter().zip(own).all(|(a, b)| (a - b).abs() <= round);
                slip && near(w.1, size) && near(w.2, stir)
            };
            own.iter().all(|s| s.abs() <= round) && windows.iter().all(one)
        };
        self.attractors.iter().position(|a| matches!(&a.kind, MassKind::Moving { slip, size, stir } if like(slip, *size, *stir)))
    }

    /// Adds what a motion that was followed to its end shows of what it moves on.
    pub fn learn(&mut self, metric: &Metric, slip: &[f64], (size, stir): (f64, f64), tail: &[Vec<f64>]) {
        let k = self.moving(slip).unwrap_or_else(|| {
            let kind = MassKind::Moving { slip: slip.to_vec(), size, stir };
            self.attractors.push(Attractor { kind, points: vec![], radius: 0.0, approach: f64::INFINITY });
            self.attractors.len() - 1
        });
        let own = &mut self.attractors[k];
        for state in tail {
            if own.distance(metric, state) > APART {
                let images = metric.images(state);
                if own.points.len() < MOST_POINTS * images.len() {
                    own.points.extend(images);
                }
            }
        }
    }

    /// Distances of a state; where only `near` ones count, those of motions are infinite beyond the radius.
    pub fn distances(&self, metric: &Metric, at: &[f64], near: bool) -> Vec<f64> {
        let of = |a: &Attractor| match &a.kind {
            MassKind::Moving { .. } if near => {
                if metric.any_within(at, &a.points, a.radius) {
                    a.radius
                } else {
                    f64::INFINITY
                }
            }
            _ => a.distance(metric, at),
        };
        self.attractors.iter().map(of).collect()
    }

    /// A motion that ended in `end` (none of these where `None`) came as near as this.
    pub fn witness(&mut self, end: Option<usize>, nearest: &[f64]) {
        for (k, (a, &d)) in self.attractors.iter_mut().zip(nearest).enumerate() {
            if end != Some(k) {
                a.approach = a.approach.min(d);
            }
        }
    }

    /// Sets the distances within which motions are assigned, from what was witnessed.
    pub fn trust(&mut self) {
        for a in &mut self.attractors {
            a.radius = if a.attracts() { (SHARE * a.approach).min(FARTHEST) } else { 0.0 };
        }
    }
}
