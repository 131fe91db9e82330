//! A periodic motion of the whole machine, from the terms of its nonlinear coordinates.

use crate::harmonic::balance::problem::Balance;
use crate::model::probe::Probe;
use crate::model::station::Pair;
use laval_num::complex::{C64, c};
use laval_num::continuation::{Failure, Zero};
use laval_num::fourier::Roots;
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

    /// The same beside it, `h` of a direction in the unknowns and the speed away, to first order in h. States that were eliminated stay.
    pub fn beside(
        &self,
        balance: &mut Balance,
        (x, speed): (&[f64], f64),
        (dx, rate): (&[f64], f64),
        h: f64,
    ) -> Result<[Orbit; 2], Failure> {
        let (n, mu) = (self.coordinates.first().map_or(0, Vec::len), balance.nonlinear.basis.rows.len());
        let change = balance.motion_along((x, speed), (dx, rate))?;
        let mut out = [-h, h].map(|h| Orbit { speed: speed + h * rate, ..self.clone() });
        let mut own = vec![C64::zero(); balance.terms.coordinates];
        for (orbit, h) in out.iter_mut().zip([-h, h]) {
            orbit.frequency = balance.pace(orbit.speed).frequency;
            for (which, change) in change.iter().enumerate() {
                let of_coordinates = orbit.coordinates[which].iter_mut().zip(change);
                of_coordinates.for_each(|(z, d)| *z += d.scale(h));
                let states = &mut orbit.states[which];
                for (&g, d) in balance.linear_states().iter().zip(&change[n..]) {
                    states[g] += d.scale(h);
                }
                balance.terms.amplitudes(dx, orbit.orders[which], &mut own);
                for (&g, d) in balance.nonlinear.states.iter().zip(&own[mu..]) {
                    states[g] += d.scale(h);
                }
            }
            orbit.rest = balance.rest(orbit.speed).to_vec();
        }
        Ok(out)
    }

    /// What of it moves at one order of the base frequency; `None` where it has no such order.
    pub fn of_order(&self, order: usize) -> Option<Orbit> {
        let which = self.orders.iter().position(|&k| k == order)?;
        let [coordinates, states] = [&self.coordinates, &self.states].map(|all| vec![all[which].clone()]);
        Some(Orbit { orders: vec![order], coordinates, states, rest: self.rest.clone(), ..*self })
    }

    /// Coordinates, rates, accelerations and states at base phase `tau`, in vectors of the machine's sizes.
    pub fn at(&self, tau: f64, q: &mut [f64], v: &mut [f64], a: &mut [f64], z: &mut [f64]) {
        self.turned(|k| C64::cis(k as f64 * tau), [q, v, a, z]);
    }

    /// The same at a sample of a period.
    pub fn at_sample(&self, roots: &Roots, j: usize, out: [&mut [f64]; 4]) {
        self.turned(|k| roots.at(k, j), out);
    }

    /// The same where every order stands at an angle, given as `e^(i angle)`.
    fn turned(&self, turned: impl Fn(usize) -> C64, [q, v, a, z]: [&mut [f64]; 4]) {
        for x in [&mut *q, &mut *v, &mut *a, &mut *z] {
            x.fill(0.0);
        }
        for ((&k, amplitudes), states) in self.orders.iter().zip(&self.coordinates).zip(&self.states) {
            let w = k as f64 * self.frequency;
            let turn = turned(k);
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
    pub fn at_some(&self, coordinates: &[usize], states: Range<usize>, tau: f64, out: [&mut [f64]; 4]) {
        self.some_turned(coordinates, states, |k| C64::cis(k as f64 * tau), out);
    }

    /// The same at a sample of a period.
    pub fn some_at_sample(&self, coordinates: &[usize], states: Range<usize>, (roots, j): (&Roots, usize), out: [&mut [f64]; 4]) {
        self.some_turned(coordinates, states, |k| roots.at(k, j), out);
    }

    fn some_turned(&self, coordinates: &[usize], states: Range<usize>, turned: impl Fn(usize) -> C64, [q, v, a, z]: [&mut [f64]; 4]) {
        for x in [&mut *q, &mut *v, &mut *a, &mut *z] {
            x.fill(0.0);
        }
        for ((&k, amplitudes), own) in self.orders.iter().zip(&self.coordinates).zip(&self.states) {
            let w = k as f64 * self.frequency;
            let turn = turned(k);
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

    /// What a probe measures, from rest, at a sample of a period.
    pub fn probe_at_sample(&self, probe: &Probe, roots: &Roots, j: usize) -> [f64; 2] {
        let each = self.orders.iter().zip(&self.coordinates);
        each.fold(self.rest_seen(probe).map(|r| -r), |[x, y], (&k, amplitudes)| {
            let (turn, [a, b]) = (roots.at(k, j), probe.amplitudes(amplitudes));
            [x + (a * turn).re, y + (b * turn).re]
        })
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Two orders of three coordinates and two states, with a place of rest.
    fn orbit() -> Orbit {
        let amplitudes = |k: f64, count: usize| (0..count).map(|i| c(0.3 + k * i as f64, 0.7 - 0.4 * k - i as f64)).collect();
        Orbit {
            speed: 260.0,
            frequency: 130.0,
            orders: vec![1, 3],
            coordinates: vec![amplitudes(0.5, 3), amplitudes(-0.2, 3)],
            states: vec![amplitudes(0.1, 2), amplitudes(0.9, 2)],
            rest: vec![0.4, -0.3, 0.2],
        }
    }

    /// Coordinates, rates, accelerations and states of the whole.
    fn whole(orbit: &Orbit, tau: f64) -> [Vec<f64>; 4] {
        let [mut q, mut v, mut a, mut z] = [3, 3, 3, 2].map(|n| vec![0.0; n]);
        orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
        [q, v, a, z]
    }

    #[test]
    fn rates_and_accelerations_are_derivatives_of_the_coordinates_in_time() {
        let (orbit, step) = (orbit(), 1e-5);
        for tau in [0.0, 0.8, 2.9] {
            let [[q0, v0, ..], [_, v, a, _], [q1, v1, ..]] = [-step, 0.0, step].map(|d| whole(&orbit, tau + d));
            let over = 2.0 * step / orbit.frequency;
            for i in 0..3 {
                assert!(((q1[i] - q0[i]) / over - v[i]).abs() < 1e-6 * 130.0, "{tau} {i}");
                assert!(((v1[i] - v0[i]) / over - a[i]).abs() < 1e-6 * 130.0 * 130.0, "{tau} {i}");
            }
        }
    }

    #[test]
    fn some_coordinates_move_as_in_the_whole() {
        let orbit = orbit();
        for tau in [0.0, 0.8, 2.9] {
            let [q, v, a, z] = whole(&orbit, tau);
            let [mut own_q, mut own_v, mut own_a, mut own_z] = [2, 2, 2, 1].map(|n| vec![f64::NAN; n]);
            orbit.at_some(&[2, 0], 1..2, tau, [&mut own_q, &mut own_v, &mut own_a, &mut own_z]);
            let some = |x: &[f64]| vec![x[2], x[0]];
            assert_eq!([own_q, own_v, own_a, own_z], [some(&q), some(&v), some(&a), vec![z[1]]]);
        }
    }

    #[test]
    fn orders_add_up_to_the_whole() {
        let orbit = orbit();
        let parts: Vec<Orbit> = orbit.orders.iter().map(|&k| orbit.of_order(k).expect("an order")).collect();
        for tau in [0.0, 0.8, 2.9] {
            let sums = parts
                .iter()
                .map(|o| whole(o, tau))
                .reduce(|a, b| [0, 1, 2, 3].map(|k| a[k].iter().zip(&b[k]).map(|(x, y)| x + y).collect()));
            for (sum, at) in sums.expect("orders").iter().zip(&whole(&orbit, tau)) {
                assert!(
                    !at.is_empty() && sum.iter().zip(at).all(|(x, y)| (x - y).abs() <= 1e-12 * y.abs().max(1.0)),
                    "{tau}: {sum:?} {at:?}"
                );
            }
        }
        assert!(parts.len() > 1 && orbit.of_order(999).is_none());
    }

    #[test]
    fn a_pair_is_seen_from_its_place_of_rest() {
        let (orbit, pair) = (orbit(), Pair([vec![(0, 1.0), (2, -0.5)], vec![(1, 2.0)]]));
        for tau in [0.0, 0.8, 2.9] {
            let [q, ..] = whole(&orbit, tau);
            let (at, [x, y]) = (pair.of(&q), orbit.pair_at(&pair, tau));
            // 0.4 - 0.5 * 0.2 and 2 * -0.3
            assert!((at[0] - 0.3 - x).abs() < 1e-14 && (at[1] + 0.6 - y).abs() < 1e-14, "{tau}");
        }
    }
}
