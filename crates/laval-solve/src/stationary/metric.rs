//! How far apart states of a machine with movable masses are, in axes that turn with the rotor.
//!
//! ```text
//! d^2 = sum_i (m_i/m) (dq_i^2 + dv_i^2/W^2),   v = q' - W J q
//! ```
//!
//! m_i are the diagonal entries of the mass matrix, m the largest of an angle: d is one when the mass with the most inertia is one radian away, or moves
//! by one turn a turn. Angles count modulo a turn. W spin speed, J the quarter turn of vectors and tilts.

use crate::characteristic::coordinate_sectors;
use crate::model::part::At;
use crate::model::system::System;
use crate::model::tangent::{Tangent, TangentScratch};
use crate::sectors::Sectors;
use crate::stationary::images::{Images, wrapped};
use laval_num::order::ascending;

/// Most images of a state that are compared one by one.
const MOST_IMAGES: usize = 128;

/// Coordinates and relative rates of a machine, their weights, and the images of a state.
pub struct Metric {
    n: usize,
    speed: f64,
    /// What leaves the machine as it is.
    pub images: Images,
    turning: Sectors,
    weight: Vec<f64>,
    angle: Vec<bool>,
}

impl Metric {
    /// Weights are those of the mass matrix at coordinates `q`.
    pub fn new(system: &System, speed: f64, images: Images, q: &[f64]) -> Self {
        let n = system.n();
        let (zero, z) = (vec![0.0; n], vec![0.0; system.m()]);
        let at = At { q, v: &zero, a: &zero, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut tangent = Tangent::default();
        system.tangent(&at, false, &mut tangent, &mut TangentScratch::default(), |_| true);
        let mut angle = vec![false; n];
        images.angles.iter().for_each(|&i| angle[i] = true);
        let unit = images.angles.iter().map(|&i| tangent.a[(i, i)]).fold(0.0, f64::max);
        let weight = (0..n).map(|i| tangent.a[(i, i)] / unit).collect();
        Metric { n, speed, images, turning: coordinate_sectors(system), weight, angle }
    }

    /// Coordinates, then relative rates over the speed, of a state (q, v, z) at phase zero.
    pub fn seen(&self, y: &[f64]) -> Vec<f64> {
        let (q, v) = (&y[..self.n], &y[self.n..2 * self.n]);
        let turned = self.turning.quarter_turn(q);
        let rates = v.iter().zip(&turned).map(|(v, t)| v / self.speed - t);
        q.iter().copied().chain(rates).collect()
    }

    /// A state at rest in turning axes.
    pub fn resting(&self, q: &[f64]) -> Vec<f64> {
        q[..self.n].iter().copied().chain(std::iter::repeat_n(0.0, self.n)).collect()
    }

    /// Part of the square of the distance that belongs to coordinate `i`.
    #[inline(always)]
    fn square(&self, i: usize, a: &[f64], b: &[f64]) -> f64 {
        let off = a[i] - b[i];
        let off = if self.angle[i] { wrapped(off) } else { off };
        let rate = a[self.n + i] - b[self.n + i];
        self.weight[i] * (off * off + rate * rate)
    }

    /// Distance from a state to the nearest of others; those at no finite distance are left out, infinite without others.
    pub fn to_nearest(&self, at: &[f64], others: &[Vec<f64>]) -> f64 {
        let mut least = f64::INFINITY;
        for other in others {
            let mut sum = 0.0;
            for i in 0..self.n {
                sum += self.square(i, other, at);
            }
            // not so for NaN
            if sum < least {
                least = sum;
            }
        }
        least.sqrt()
    }

    /// One of the states is no farther than `limit`.
    pub fn any_within(&self, at: &[f64], others: &[Vec<f64>], limit: f64) -> bool {
        let most = limit * limit;
        others.iter().any(|other| {
            let mut sum = 0.0;
            (0..self.n).all(|i| {
                sum += self.square(i, other, at);
                sum <= most
            })
        })
    }

    /// Distance from rest in turning axes.
    pub fn stir(&self, a: &[f64]) -> f64 {
        (0..self.n).map(|i| self.weight[i] * a[self.n + i] * a[self.n + i]).sum::<f64>().sqrt()
    }

    /// How far the bodies are from the axis, on the same scale.
    pub fn size(&self, a: &[f64]) -> f64 {
        (0..self.n).filter(|&i| !self.angle[i]).map(|i| self.weight[i] * a[i] * a[i]).sum::<f64>().sqrt()
    }

    /// The images of a state; the state alone where there are too many.
    pub fn images(&self, a: &[f64]) -> Vec<Vec<f64>> {
        match self.images.all(&a[..self.n], &a[self.n..], MOST_IMAGES) {
            Some(all) => all.into_iter().map(|(q, v)| [q, v].concat()).collect(),
            None => vec![a.to_vec()],
        }
    }

    /// All images of a state can be compared.
    pub fn countable(&self) -> bool {
        let zero = vec![0.0; self.n];
        self.images.all(&zero, &zero, MOST_IMAGES).is_some()
    }

    /// Values of the angles, in rising order within each group of masses that may be exchanged.
    pub fn sorted(&self, by_angle: &[f64]) -> Vec<f64> {
        let of = |i: &usize| self.images.angles.iter().position(|a| a == i).map_or(f64::NAN, |k| by_angle[k]);
        let mut out = Vec::new();
        for group in &self.images.groups {
            let mut own: Vec<f64> = group.iter().map(of).collect();
            ascending(&mut own);
            out.extend(own);
        }
        out
    }
}
