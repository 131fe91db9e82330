//! Peaks of many measures around one point of a branch, from few motions that serve all of them.
//!
//! Equations: with the place t of a motion along the chord between the points beside, every complex amplitude is interpolated by the polynomial through the
//! points of the branch next to it and corrected motions between them; these join, each where the product of its distances from the others is largest, until
//! one was foretold to rounding. A measure with the size r(tau; t) is stationary over t where `dr/dt` at the instant of its largest value vanishes. The number
//! of motions does not grow with that of the measures, nor their number with the size of the machine.
//!
//! Validity: amplitudes that are smooth along the branch, as they are not where a law switches; there nothing is found.

use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::measure::Measure;
use crate::harmonic::branches::peak::{Peak, Sense, refine};
use crate::harmonic::branches::response::Traced;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::continuation::{Chord, Point};
use laval_num::univariate::root;
use std::collections::HashMap;
use std::ops::Range;

/// Points of the branch beyond those beside a point that are interpolated through.
const BESIDE: usize = 1;
/// Motions computed between them at most.
const MOST: usize = 14;
/// Difference between a motion and what was foretold of it, over its size, that is rounding, and that is accepted where more motions do not lessen it.
const ROUNDING: f64 = 1e-13;
const FORETOLD: f64 = 1e-10;
/// Decrease of that difference from one motion to the next above which more motions lessen it.
const LESS: f64 = 0.3;
/// Places among which the next one is chosen.
const CHOICE: usize = 200;
/// Half the step of the difference that is the slope of a measure.
const STEP: f64 = 1e-5;

/// The peaks of one branch.
#[derive(Default)]
pub struct Peaks {
    /// By point; none where motions are not smooth.
    around: HashMap<usize, Option<Around>>,
}

impl Peaks {
    /// The peak (or least value) of a measure next to point `i`, where it is larger (less) than at the points beside; where motions are not smooth by
    /// corrections of its own in a range of speeds. `None` where it lies beyond a fold or the end of the branch.
    pub fn beside(
        &mut self,
        balance: &mut Balance,
        (branch, i): (&Traced, usize),
        measure: Measure,
        sense: Sense,
        speeds: (f64, f64),
    ) -> Option<Peak> {
        let system = balance.system;
        let around = self.around.entry(i).or_insert_with(|| Around::new(balance, branch, i));
        match around.as_ref().map_or(Err(Without::Kink), |a| a.peak(system, measure, sense)) {
            Ok(peak) => Some(peak),
            Err(Without::Apart) => None,
            Err(Without::Kink) => refine(balance, branch, i, measure, sense, speeds),
        }
    }
}

/// Why a measure has no peak around a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Without {
    /// The motions are not smooth there.
    Kink,
    /// It does not fall on both sides, or only beyond a fold.
    Apart,
}

/// A corrected motion.
struct Motion {
    place: f64,
    x: Vec<f64>,
    speed: f64,
    residual: f64,
    orbit: Orbit,
}

/// Motions around a point of a branch.
struct Around {
    motions: Vec<Motion>,
    /// Place of the point itself.
    middle: f64,
    folds: Vec<f64>,
    turns: usize,
    /// Equal parts of the period with which sizes repeat.
    parts: usize,
    /// Length of the chord in scaled unknowns and parameter.
    length: f64,
}

impl Around {
    /// Around point `i` of a branch; `None` at its ends, where it turns sharply, and where motions are not smooth.
    fn new(balance: &mut Balance, branch: &Traced, i: usize) -> Option<Self> {
        let (before, after) = (branch.points.get(i.checked_sub(1)?)?, branch.points.get(i + 1)?);
        let chord = Chord::new(balance, (&before.x, before.speed), (&after.x, after.speed))?;
        let place = |k: usize| chord.place(&branch.points[k].x, branch.points[k].speed);
        // beyond a sharp turn places run back
        let least = (i.saturating_sub(BESIDE + 1)..i).rev().take_while(|&k| place(k) < place(k + 1)).last()?;
        let most = (i + 1..(i + BESIDE + 2).min(branch.points.len())).take_while(|&k| place(k) > place(k - 1)).last()?;
        let mut motions = Vec::new();
        for (k, state) in branch.points.iter().enumerate().take(most + 1).skip(least) {
            let orbit = Orbit::of(balance, &state.x, state.speed).ok()?;
            motions.push(Motion { place: place(k), x: state.x.clone(), speed: state.speed, residual: state.residual, orbit });
        }
        let folds = branch.folds.iter().filter(|f| (least..most).contains(&f.after)).map(|f| chord.place(&f.x, f.speed)).collect();
        let parts = branch.discretisation.whole().symmetry.order().max(1);
        let mut around = Around { middle: place(i), motions, folds, turns: branch.turns(), parts, length: chord.length() };
        let mut last = f64::INFINITY;
        for _ in 0..MOST {
            let place = around.next();
            let (x, speed) = around.unknowns(place);
            let Point { x, p: speed, residual, .. } = chord.point(balance, place, (&x, speed))?;
            let orbit = Orbit::of(balance, &x, speed).ok()?;
            let missed = around.missed(place, &orbit);
            around.motions.push(Motion { place, x, speed, residual, orbit });
            if missed <= ROUNDING || missed <= FORETOLD && missed >= LESS * last {
                return Some(around);
            }
            last = missed;
        }
        (last <= FORETOLD).then_some(around)
    }

    /// The peak (or least value) of a measure.
    ///
    /// # Errors
    /// Where it has none.
    fn peak(&self, system: &System, measure: Measure, sense: Sense) -> Result<Peak, Without> {
        let mut own = Own::new(self, system, measure);
        let sign = if sense == Sense::Largest { 1.0 } else { -1.0 };
        let sampled = own.largest(self.middle).0;
        let mut slope = |place: f64| {
            let tau = own.largest(place).1;
            Some(sign * (own.square(place + STEP, tau) - own.square(place - STEP, tau)) / (2.0 * STEP))
        };
        let ends = [0.0, 1.0].map(|place| (place, slope(place).unwrap_or(f64::NAN)));
        if ends.iter().any(|e| e.1.is_nan()) {
            return Err(Without::Kink);
        }
        if !(ends[0].1 > 0.0 && ends[1].1 < 0.0) {
            return Err(Without::Apart);
        }
        let place = root(&mut slope, ends[0], ends[1], 1e-13).ok_or(Without::Kink)?;
        let left = slope(place).unwrap_or(f64::NAN) / (2.0 * sampled * sampled * self.length);
        let value = own.largest(place).0;
        if self.folds.iter().any(|f| (f - self.middle) * (f - place) < 0.0) || sign * (value - sampled) < -1e-9 * sampled {
            return Err(Without::Apart);
        }
        let (x, speed) = self.unknowns(place);
        let side = |up: bool| {
            let there = self.motions.iter().filter(|m| if up { m.place >= place } else { m.place <= place });
            there.min_by(|a, b| (a.place - place).abs().total_cmp(&(b.place - place).abs())).map_or(f64::NAN, |m| m.speed)
        };
        let residual = self.motions.iter().map(|m| m.residual).fold(0.0, f64::max);
        Ok(Peak { speed, value, x, bracket: (side(false), side(true)), slope: left, residual })
    }

    /// Where the motions known say least.
    fn next(&self) -> f64 {
        let blind = |t: f64| self.motions.iter().map(|m| (t - m.place).abs()).product::<f64>();
        let places = (1..CHOICE).map(|k| k as f64 / CHOICE as f64);
        places.max_by(|a, b| blind(*a).total_cmp(&blind(*b))).unwrap_or(0.5)
    }

    /// Weights of the motions in the interpolation at a place.
    fn weights(&self, place: f64) -> Vec<f64> {
        let others = |k: usize| self.motions.iter().enumerate().filter(move |o| o.0 != k).map(|o| o.1.place);
        (0..self.motions.len()).map(|k| others(k).map(|o| (place - o) / (self.motions[k].place - o)).product()).collect()
    }

    /// Unknowns of the balance and speed at a place.
    fn unknowns(&self, place: f64) -> (Vec<f64>, f64) {
        let weights = self.weights(place);
        let sum = |of: &dyn Fn(&Motion) -> f64| self.motions.iter().zip(&weights).map(|(m, w)| w * of(m)).sum::<f64>();
        ((0..self.motions[0].x.len()).map(|i| sum(&|m| m.x[i])).collect(), sum(&|m| m.speed))
    }

    /// Largest difference of an orbit at a place from what is interpolated, over the largest amplitude.
    fn missed(&self, place: f64, orbit: &Orbit) -> f64 {
        let weights = self.weights(place);
        let (mut size, mut missed) = (0.0f64, 0.0f64);
        for (k, amplitudes) in orbit.coordinates.iter().enumerate() {
            for (i, z) in amplitudes.iter().enumerate() {
                let foretold = self.motions.iter().zip(&weights).fold(C64::zero(), |sum, (m, w)| sum + m.orbit.coordinates[k][i].scale(*w));
                (size, missed) = (size.max(z.abs()), missed.max((*z - foretold).abs()));
            }
        }
        // NaN fails
        missed / size
    }
}

/// What a measure sees of the motions.
struct Own<'a> {
    around: &'a Around,
    system: &'a System,
    measure: Measure,
    coordinates: Vec<usize>,
    states: Range<usize>,
    /// Of these coordinates and states alone.
    orbit: Orbit,
    place: f64,
}

impl<'a> Own<'a> {
    fn new(around: &'a Around, system: &'a System, measure: Measure) -> Self {
        let (coordinates, states) = measure.coordinates(system);
        let (like, place) = (&around.motions[0].orbit, f64::NAN);
        let zeros = |of: &Vec<Vec<C64>>| of.iter().map(|x| vec![C64::zero(); x.len()]).collect();
        let (amplitudes, own) = (zeros(&like.coordinates), zeros(&like.states));
        let orbit =
            Orbit { orders: like.orders.clone(), coordinates: amplitudes, states: own, rest: like.rest.clone(), ..Orbit::default() };
        Own { around, system, measure, coordinates, states, orbit, place }
    }

    /// Interpolates at a place.
    fn go(&mut self, place: f64) {
        if place == self.place {
            return;
        }
        self.place = place;
        let (motions, weights) = (&self.around.motions, self.around.weights(place));
        let each = || motions.iter().zip(&weights);
        let sum = |of: &dyn Fn(&Orbit) -> f64| each().map(|(m, w)| w * of(&m.orbit)).sum::<f64>();
        self.orbit.speed = sum(&|o| o.speed);
        self.orbit.frequency = sum(&|o| o.frequency);
        for k in 0..self.orbit.orders.len() {
            for &i in &self.coordinates {
                self.orbit.coordinates[k][i] = each().fold(C64::zero(), |sum, (m, w)| sum + m.orbit.coordinates[k][i].scale(*w));
            }
            for i in self.states.clone() {
                self.orbit.states[k][i] = each().fold(C64::zero(), |sum, (m, w)| sum + m.orbit.states[k][i].scale(*w));
            }
        }
        if !self.orbit.rest.is_empty() {
            for &i in &self.coordinates {
                self.orbit.rest[i] = sum(&|o| o.rest[i]);
            }
        }
    }

    fn largest(&mut self, place: f64) -> (f64, f64) {
        self.go(place);
        self.measure.largest_of_part(self.system, &self.orbit, self.around.turns, self.around.parts)
    }

    fn square(&mut self, place: f64, tau: f64) -> f64 {
        self.go(place);
        self.measure.square_at(self.system, &self.orbit, self.around.turns, tau)
    }
}
