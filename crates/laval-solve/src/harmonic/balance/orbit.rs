//! A periodic motion of the whole machine, from the terms of its nonlinear coordinates.

use crate::harmonic::balance::problem::Balance;
use crate::model::probe::Probe;
use crate::model::station::Pair;
use laval_num::complex::{C64, c};
use laval_num::continuation::{Failure, Zero};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A periodic motion: complex amplitudes of every coordinate and state at every order.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Orbit {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Base frequency, rad/s: speed / divisor.
    pub frequency: f64,
    /// Orders of the base frequency, ascending.
    pub orders: Vec<usize>,
    /// Amplitudes of coordinates: `coordinate = sum_k Re(amplitude exp(i k frequency t))`.
    pub coordinates: Vec<Vec<C64>>,
    /// Amplitudes of internal states.
    pub states: Vec<Vec<C64>>,
    /// Coordinates of the machine at rest, where they are not all zero: displacements count from there.
    pub rest: Vec<f64>,
}

impl Orbit {
    /// Of the unknowns `x` of a balance at a speed (rad/s).
    pub fn of(balance: &mut Balance, x: &[f64], speed: f64) -> Result<Orbit, Failure> {
        let mut r = vec![0.0; balance.dim()];
        balance.eval(x, speed, &mut r, None, None)?;
        let system = balance.system;
        let (n, m) = (system.n(), system.m());
        let frequency = balance.pace(speed).frequency;
        let mut orbit = Orbit { speed, frequency, orders: balance.terms.orders.clone(), ..Orbit::default() };
        let mut motion = Vec::new();
        let mut own = vec![C64::zero(); balance.terms.coordinates];
        let mu = balance.nonlinear.basis.rows.len();
        for which in 0..orbit.orders.len() {
            balance.motion(x, which, &mut motion);
            let mut states = vec![C64::zero(); m];
            for (&g, &z) in balance.linear_states().iter().zip(&motion[n..]) {
                states[g] = z;
            }
            balance.terms.amplitudes(x, orbit.orders[which], &mut own);
            for (&g, &z) in balance.nonlinear.states.iter().zip(&own[mu..]) {
                states[g] = z;
            }
            motion.truncate(n);
            balance.memory_states(c(0.0, orbit.orders[which] as f64 * frequency), &motion, &mut states);
            orbit.coordinates.push(motion.clone());
            orbit.states.push(states);
        }
        orbit.rest = balance.rest(speed).to_vec();
        Ok(orbit)
    }

    /// Coordinates, rates, accelerations and states at base phase `tau`, in vectors of the machine's sizes.
    pub fn at(&self, tau: f64, q: &mut [f64], v: &mut [f64], a: &mut [f64], z: &mut [f64]) {
        for x in [&mut *q, &mut *v, &mut *a, &mut *z] {
            x.fill(0.0);
        }
        for ((&k, amplitudes), states) in self.orders.iter().zip(&self.coordinates).zip(&self.states) {
            let w = k as f64 * self.frequency;
            let turn = C64::cis(k as f64 * tau);
            for (i, &amplitude) in amplitudes.iter().enumerate() {
                let x = amplitude * turn;
                q[i] += x.re;
                v[i] -= w * x.im;
                a[i] -= w * w * x.re;
            }
            for (z, &amplitude) in z.iter_mut().zip(states) {
                *z += (amplitude * turn).re;
            }
        }
    }

    /// The same of some coordinates and states, in vectors of as many.
    pub fn at_some(&self, coordinates: &[usize], states: Range<usize>, tau: f64, [q, v, a, z]: [&mut [f64]; 4]) {
        for x in [&mut *q, &mut *v, &mut *a, &mut *z] {
            x.fill(0.0);
        }
        for ((&k, amplitudes), own) in self.orders.iter().zip(&self.coordinates).zip(&self.states) {
            let w = k as f64 * self.frequency;
            let turn = C64::cis(k as f64 * tau);
            for (j, &i) in coordinates.iter().enumerate() {
                let x = amplitudes[i] * turn;
                q[j] += x.re;
                v[j] -= w * x.im;
                a[j] -= w * w * x.re;
            }
            for (z, &amplitude) in z.iter_mut().zip(&own[states.clone()]) {
                *z += (amplitude * turn).re;
            }
        }
    }

    /// Place of rest of the pair that starts at coordinate `x`.
    pub fn rest_of(&self, pair: &Pair) -> [f64; 2] {
        if self.rest.is_empty() { [0.0; 2] } else { pair.of(&self.rest) }
    }

    /// A pair, from rest, at base phase `tau`.
    pub fn pair_at(&self, pair: &Pair, tau: f64) -> [f64; 2] {
        let [x, y] = self.rest_of(pair);
        let each = self.orders.iter().zip(&self.coordinates);
        each.fold([-x, -y], |[x, y], (&k, amplitudes)| {
            let turn = C64::cis(k as f64 * tau);
            let [a, b] = pair.amplitudes(amplitudes);
            [x + (a * turn).re, y + (b * turn).re]
        })
    }

    /// What a probe measures, from rest, with its first and second derivative in the base phase, at base phase `tau`.
    pub fn probe_at(&self, probe: &Probe, tau: f64) -> [[f64; 2]; 3] {
        let mut out = [[0.0; 2]; 3];
        out[0] = self.rest_seen(probe).map(|r| -r);
        for (&k, amplitudes) in self.orders.iter().zip(&self.coordinates) {
            let turn = C64::cis(k as f64 * tau);
            for (j, amplitude) in probe.amplitudes(amplitudes).into_iter().enumerate() {
                let mut z = amplitude * turn;
                for o in &mut out {
                    o[j] += z.re;
                    z = z.mul_i().scale(k as f64);
                }
            }
        }
        out
    }

    /// What a probe measures at rest.
    pub fn rest_seen(&self, probe: &Probe) -> [f64; 2] {
        if self.rest.is_empty() { [0.0; 2] } else { probe.of(&self.rest) }
    }

    /// Forward and backward amplitude of a pair, at order `k`: `x + i y = forward e^(i k tau) + backward e^(-i k tau)`.
    pub fn whirl(&self, pair: &Pair, k: usize) -> (C64, C64) {
        match self.orders.iter().position(|&o| o == k) {
            None => (C64::zero(), C64::zero()),
            Some(i) => {
                let [a, b] = pair.amplitudes(&self.coordinates[i]);
                ((a + b.mul_i()).scale(0.5), (a.conj() + b.conj().mul_i()).scale(0.5))
            }
        }
    }
}
