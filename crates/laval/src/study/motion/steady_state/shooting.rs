//! Newton's method on the Poincare map: `y = P^k(y)`, its Jacobian from motions that start beside y.
//!
//! In scaled states: `(I - DP) dy = P(y) - y`, with DP by one-sided differences; an orbit counts when the last correction is below the tolerance,
//! no multiplier (eigenvalue of DP) is larger than one by more than the differences can tell, and it lies where the motion was going.

use super::Rules;
use super::period::{LONGEST, Sections};
use laval_num::dense::{Lu, Mat, max_abs};
use laval_num::eig::eigenvalues;

/// Tolerances of the integration while differences are taken.
pub const RELATIVE: f64 = 1e-12;
/// Differences over the size of the motion.
const BESIDE: f64 = 1e-5;
const ITERATIONS: usize = 12;
/// Distance of the orbit from the settled state, over the size of the motion.
const FARTHEST: f64 = 0.3;
/// What the differences leave open of the modulus of a multiplier.
const MARGIN: f64 = 1e-6;

/// What follows after a leg.
pub enum Step {
    /// Another leg of [`Shooting::periods`] from the state written.
    Again,
    /// The orbit: last correction over the size of the motion, largest modulus of the multipliers. Its state is written.
    Found { residual: f64, multiplier: f64 },
    /// None was found; the state is that before shooting.
    Lost,
}

pub struct Shooting {
    tolerance: f64,
    size: Vec<f64>,
    amplitude: f64,
    periods: usize,
    start: Vec<f64>,
    iterate: Vec<f64>,
    image: Vec<f64>,
    /// Column under way; none for the motion itself.
    column: Option<usize>,
    map: Mat,
    iterations: usize,
}

impl Shooting {
    pub fn new(rules: &Rules, size: &[f64]) -> Self {
        let n = size.len();
        Shooting {
            tolerance: rules.tolerance,
            size: size.to_vec(),
            amplitude: 1.0,
            periods: 1,
            start: vec![],
            iterate: vec![],
            image: vec![0.0; n],
            column: None,
            map: Mat::zeros(n, n),
            iterations: 0,
        }
    }

    /// Forcing periods of a leg.
    pub fn periods(&self) -> u64 {
        self.periods as u64
    }

    /// Begins at the end of a record; the period is the shortest that repeats much better than one.
    pub fn begin(&mut self, sections: &Sections, y: &[f64]) {
        let one = sections.change(1);
        self.periods = (2..=LONGEST).find(|&k| sections.change(k) < 0.1 * one).unwrap_or(1);
        self.amplitude = sections.amplitude();
        (self.start, self.iterate) = (y.to_vec(), y.to_vec());
        self.column = None;
        self.iterations = 0;
    }

    /// A leg has ended at `y`, which becomes the start of the next.
    pub fn landed(&mut self, y: &mut [f64]) -> Step {
        let h = BESIDE * self.amplitude;
        let n = self.size.len();
        match self.column {
            None => self.image.copy_from_slice(y),
            Some(j) => (0..n).for_each(|i| self.map[(i, j)] = (y[i] - self.image[i]) / (self.size[i] * h)),
        }
        let next = self.column.map_or(0, |j| j + 1);
        if next == n {
            return self.correct(y);
        }
        self.column = Some(next);
        y.copy_from_slice(&self.iterate);
        y[next] += h * self.size[next];
        Step::Again
    }

    fn correct(&mut self, y: &mut [f64]) -> Step {
        let n = self.size.len();
        self.iterations += 1;
        let matrix = Mat::from_fn(n, n, |i, j| f64::from(u8::from(i == j)) - self.map[(i, j)]);
        let mut step: Vec<f64> = (0..n).map(|i| (self.image[i] - self.iterate[i]) / self.size[i]).collect();
        let solved = Lu::new(&matrix).map(|lu| lu.solve(&mut step)).is_ok();
        (0..n).for_each(|i| self.iterate[i] += step[i] * self.size[i]);
        let away: Vec<f64> = (0..n).map(|i| (self.iterate[i] - self.start[i]) / self.size[i]).collect();
        let near = away.iter().all(|x| x.abs() <= FARTHEST * self.amplitude);
        if !(solved && near && self.iterations < ITERATIONS) {
            return self.lost(y);
        }
        let residual = max_abs(&step) / self.amplitude;
        self.column = None;
        y.copy_from_slice(&self.iterate);
        if !(residual <= self.tolerance) {
            return Step::Again;
        }
        let Ok(multipliers) = eigenvalues(&self.map) else { return self.lost(y) };
        let multiplier = multipliers.iter().map(|m| m.abs()).fold(0.0, |a: f64, b| if a.is_nan() || b <= a { a } else { b });
        if multiplier <= 1.0 + MARGIN { Step::Found { residual, multiplier } } else { self.lost(y) }
    }

    fn lost(&self, y: &mut [f64]) -> Step {
        y.copy_from_slice(&self.start);
        Step::Lost
    }
}
