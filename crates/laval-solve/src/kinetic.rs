//! Kinetic energy of a mode over a period, by kinds of motion.
//!
//! The share of some coordinates is `Re sum_i conj(q_i) (M q)_i`, i over them, over the same of all coordinates.

use crate::characteristic::Equilibrium;
use crate::model::part::At;
use crate::model::system::System;
use crate::model::tangent::{SparseTangent, TangentScratch};
use laval_num::complex::C64;

/// The mass matrix of a machine.
#[derive(Clone, Debug)]
pub struct Kinetic {
    /// Row, column, value.
    mass: Vec<(usize, usize, f64)>,
}

impl Kinetic {
    /// About a state; of the undeflected machine where none is given.
    pub fn of(system: &System, about: Option<&Equilibrium>) -> Self {
        let (zero, still) = (vec![0.0; system.n()], vec![0.0; system.m()]);
        let (q, z, speed) = about.map_or((&zero, &still, 0.0), |e| (&e.q, &e.z, e.speed));
        let at = At { q, v: &zero, a: &zero, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut tangent = SparseTangent::default();
        system.tangent(&at, false, &mut tangent, &mut TangentScratch::default(), |_| true);
        Kinetic { mass: tangent.a.0 }
    }

    /// Shares of two kinds of coordinates in the kinetic energy of a mode; `None` where nothing with mass moves.
    pub fn shares(&self, kinds: &[Vec<usize>; 2], q: &[C64]) -> Option<[f64; 2]> {
        let mut all = vec![0.0; q.len()];
        for &(i, j, m) in &self.mass {
            all[i] += m * (q[i].conj() * q[j]).re;
        }
        let total: f64 = all.iter().sum();
        let shares = kinds.each_ref().map(|own| own.iter().map(|&i| all[i]).sum::<f64>() / total);
        let known = total > 0.0 && shares.iter().all(|s| s.is_finite());
        known.then(|| shares.map(|s| s.clamp(0.0, 1.0)))
    }
}
