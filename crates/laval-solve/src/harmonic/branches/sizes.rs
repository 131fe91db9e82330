//! Sizes of the motion of a pair of coordinates (m, rad) over a period: largest values between equidistant samples, by the parabola through the largest and those beside it.

use crate::harmonic::balance::orbit::Orbit;
use crate::model::station::Pair;
use crate::symmetry::Symmetry;
use laval_num::fourier::Roots;
use std::f64::consts::TAU;

/// Samples of a turn.
pub const SAMPLES: usize = 64;
/// Step of the second look at a largest value, over the step of the samples.
pub const CLOSER: f64 = 0.125;

/// `cos(k tau)` and `sin(k tau)` of the orders k of a branch, at the samples of a period after which squares repeat.
pub struct Waves {
    turns: usize,
    orders: Vec<usize>,
    /// Cosine and sine by order.
    values: Vec<[Vec<f64>; 2]>,
    samples: usize,
}

impl Waves {
    /// Of motions with these orders (ascending), of a period of so many turns.
    pub fn new(orders: &[usize], turns: usize, symmetry: Symmetry) -> Waves {
        let roots = Roots::new(SAMPLES * turns);
        // after half a turn squares repeat
        let samples = if symmetry == Symmetry::None { SAMPLES * turns } else { SAMPLES * turns / 2 };
        let wave = |&k: &usize| {
            let at = |part: fn(laval_num::complex::C64) -> f64| (0..samples).map(|j| part(roots.at(k, j))).collect();
            [at(|z| z.re), at(|z| z.im)]
        };
        Waves { turns, values: orders.iter().map(wave).collect(), orders: orders.to_vec(), samples }
    }

    /// Of a pair: forward amplitude at the spin frequency; largest distance from rest, largest |x|; largest amplitude of an order below the spin frequency; root
    /// mean square of the distance; largest |y|; amplitudes of x and of y at the spin frequency. NaN of a motion with other orders.
    pub fn sizes(&self, orbit: &Orbit, pair: &Pair) -> [f64; 8] {
        if orbit.orders.is_empty() || orbit.orders.iter().any(|k| self.orders.binary_search(k).is_err()) {
            return [f64::NAN; 8];
        }
        let forward = orbit.whirl(pair, self.turns).0.abs();
        let slow = (1..self.turns).map(|k| orbit.whirl(pair, k)).fold(0.0, |m, (f, b)| larger(larger(m, f.abs()), b.abs()));
        let first = orbit.orders.iter().position(|&k| k == self.turns);
        let [x, y] = first.map_or([0.0; 2], |i| pair.amplitudes(&orbit.coordinates[i]).map(|a| a.abs()));
        // squares of the distance from rest, of x and of y, smooth where the sizes themselves have kinks
        let squares = |[x, y]: [f64; 2]| [x * x + y * y, x * x, y * y];
        let [xs, ys] = self.path(orbit, pair);
        let mut series = [0; 3].map(|_| Vec::with_capacity(self.samples));
        for (&x, &y) in xs.iter().zip(&ys) {
            series.iter_mut().zip(squares([x, y])).for_each(|(s, r)| s.push(r));
        }
        let h = TAU / (SAMPLES * self.turns) as f64;
        let largest = [0, 1, 2].map(|k| {
            crest(&series[k]).map_or(f64::NAN, |(top, beside)| {
                let near = |shift: f64| squares(orbit.pair_at(pair, h * (top as f64 + beside + shift * CLOSER)))[k];
                larger(series[k][top], vertex([near(-1.0), near(0.0), near(1.0)]).1).sqrt()
            })
        });
        let mean = (series[0].iter().sum::<f64>() / self.samples as f64).sqrt();
        [forward, largest[0], largest[1], slow, mean, largest[2], x, y]
    }

    /// Both components, from rest, at the samples.
    fn path(&self, orbit: &Orbit, pair: &Pair) -> [Vec<f64>; 2] {
        let mut path = orbit.rest_of(pair).map(|r| vec![-r; self.samples]);
        for (k, amplitudes) in orbit.orders.iter().zip(&orbit.coordinates) {
            let Ok(at) = self.orders.binary_search(k) else { continue };
            let [cos, sin] = &self.values[at];
            for (path, a) in path.iter_mut().zip(pair.amplitudes(amplitudes)) {
                for ((p, c), s) in path.iter_mut().zip(cos).zip(sin) {
                    *p += a.re * c - a.im * s;
                }
            }
        }
        path
    }
}

/// The larger of two sizes; NaN where one is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// Index of the largest of samples of a period, and how far beside it, in samples, the vertex of the parabola through it and those beside it lies; `None` where
/// one is not a number.
pub fn crest(series: &[f64]) -> Option<(usize, f64)> {
    let n = series.len();
    let last = n.checked_sub(1)?;
    let mut top = 0;
    for (j, x) in series.iter().enumerate() {
        if x.is_nan() {
            return None;
        }
        if *x > series[top] {
            top = j;
        }
    }
    Some((top, vertex([series[(top + last) % n], series[top], series[(top + 1) % n]]).0))
}

/// Place, in steps from the middle one, and value of the vertex of a parabola through three equally spaced values.
pub fn vertex([a, b, c]: [f64; 3]) -> (f64, f64) {
    let bend = a - 2.0 * b + c;
    if bend < 0.0 { ((0.5 * (a - c) / bend).clamp(-1.0, 1.0), b - (a - c) * (a - c) / (8.0 * bend)) } else { (0.0, b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::complex::c;

    /// An ellipse at the spin frequency with a third order, about a place beside the axis.
    fn orbit() -> (Orbit, Pair) {
        let coordinates = vec![vec![c(3.0, 1.0), c(0.5, -2.0)], vec![c(0.2, 0.1), c(-0.1, 0.15)]];
        let orbit = Orbit { speed: 1.0, frequency: 1.0, orders: vec![1, 3], coordinates, states: vec![vec![]; 2], rest: vec![0.4, -0.3] };
        (orbit, Pair([vec![(0, 1.0)], vec![(1, 1.0)]]))
    }

    #[test]
    fn largest_values_are_those_of_fine_samples() {
        let (orbit, pair) = orbit();
        for symmetry in [Symmetry::None, Symmetry::Half] {
            // a place of rest is no part of a symmetric motion
            let orbit = Orbit { rest: if symmetry == Symmetry::None { orbit.rest.clone() } else { vec![] }, ..orbit.clone() };
            let found = Waves::new(&orbit.orders, 1, symmetry).sizes(&orbit, &pair);
            let (mut largest, mut squares) = ([0.0f64; 3], 0.0);
            for j in 0..20_000 {
                let [x, y] = orbit.pair_at(&pair, TAU * f64::from(j) / 20_000.0);
                largest = [largest[0].max(x.hypot(y)), largest[1].max(x.abs()), largest[2].max(y.abs())];
                squares += (x * x + y * y) / 20_000.0;
            }
            for (a, b) in [found[1], found[2], found[5], found[4]].into_iter().zip([largest[0], largest[1], largest[2], squares.sqrt()]) {
                assert!((a - b).abs() < 1e-5 * b, "{symmetry:?}: {a} {b}");
            }
            assert!((found[6] - 10f64.sqrt()).abs() < 1e-14 && (found[7] - 4.25f64.sqrt()).abs() < 1e-14);
        }
        assert!(Waves::new(&[1], 1, Symmetry::None).sizes(&orbit, &pair).iter().all(|x| x.is_nan()));
    }

    #[test]
    fn no_number_has_no_crest() {
        assert_eq!(crest(&[1.0, f64::NAN, 0.0]), None);
        assert_eq!(crest(&[]), None);
        assert_eq!(crest(&[0.0, 3.0, 0.0, 0.0]), Some((1, 0.0)));
    }
}
