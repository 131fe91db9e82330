//! Moments of the balls: of each track, of all, and the most they can have.

use super::{BalancerBallParams, BallBalancer, Track};
use crate::model::part::At;
use laval_num::complex::Complex;

impl BallBalancer {
    /// Largest moment of the balls, sum of m r, kg m.
    pub fn capacity(&self, p: &BalancerBallParams) -> f64 {
        let moment = |t: &Track| self.masses[t.balls.clone()].iter().sum::<f64>() * t.radius;
        p.ball_mass * p.track_radius * self.tracks.iter().map(moment).sum::<f64>()
    }
    /// Moment of the balls in the plane, about the ring centre, in rotor axes, kg m.
    pub fn moment(&self, p: &BalancerBallParams, at: &At<f64>) -> Complex<f64> {
        let mut sum = Complex::zero();
        for k in 0..self.tracks.len() {
            sum += self.moment_of(p, at, k);
        }
        sum
    }
    /// Of those on one track.
    pub(super) fn moment_of(&self, p: &BalancerBallParams, at: &At<f64>, k: usize) -> Complex<f64> {
        let ring = self.ring(p, at, k);
        let mut sum = Complex::zero();
        for i in self.tracks[k].balls.clone() {
            let (s, co) = at.q[self.row(i)].sin_cos();
            let u = Complex { re: co, im: ring.cos * s } * ring.line;
            sum += u.scale(p.ball_mass * self.masses[i] * ring.radius);
        }
        sum
    }
}
