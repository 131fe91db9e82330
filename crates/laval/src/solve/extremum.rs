//! Maxima and minima of amplitudes between computed responses, shared by all bodies.
//!
//! Equations: the logarithm of an amplitude is interpolated by a polynomial p through the responses next to its extremum; the response is computed at
//! the zero of p', which joins the others, until p foretold its amplitude. Responses hold all bodies: what one body's search computed serves those whose
//! extrema lie beside it.
//!
//! Validity: amplitudes that are smooth between the responses; otherwise golden section and parabolas take over.

use super::linear_response::{Response, response};
use super::locate::State;
use super::scalar::{maximum, root};
use crate::model::system::System;

/// Most responses an interpolation uses.
const NODES: usize = 8;
/// Interpolations tried before golden section.
const TRIES: usize = 8;
/// Difference between the logarithms of an amplitude and of what was foretold that ends the search.
const FORETOLD: f64 = 1e-11;
/// Distance of responses, over that of the neighbours of the best one, below which their differences are rounding.
const APART: f64 = 1e-5;

/// Responses computed in the search for extrema.
pub(super) struct Search<'a> {
    system: &'a System,
    state: State<'a>,
    /// By speed.
    points: Vec<Response>,
}

impl<'a> Search<'a> {
    pub fn new(system: &'a System, state: State<'a>) -> Self {
        Search { system, state, points: Vec::new() }
    }

    /// Amplitude at a speed; none where the response does not exist.
    pub fn at(&self, speed: f64, i: usize) -> Option<f64> {
        response(self.system, self.state, speed).ok().flatten().map(|r| r.major(i))
    }

    /// The speed and the amplitude of coordinate `i` at its one maximum (or minimum) between the neighbours of `around[middle]`, which is above (below)
    /// both.
    pub fn extremum(&mut self, around: &[Response], middle: usize, i: usize, up: bool) -> Option<(f64, f64)> {
        let sign = if up { 1.0 } else { -1.0 };
        let (from, to) = (around.get(middle.checked_sub(1)?)?.speed, around.get(middle + 1)?.speed);
        let found = self.interpolated(around, (from, to), i, sign).or_else(|| {
            let tolerance = 1e-10 * to.abs();
            maximum(|w| self.at(w, i).map(|x| sign * x.ln()), from, to, tolerance)
        });
        found.map(|(speed, v)| (speed, (sign * v).exp()))
    }

    /// By interpolation, as often as it takes to foretell the value at the extremum; none where it does not come to that.
    fn interpolated(&mut self, around: &[Response], (from, to): (f64, f64), i: usize, sign: f64) -> Option<(f64, f64)> {
        let log = |r: &Response| (r.speed, sign * r.major(i).ln());
        let inside = |w: f64| w > from && w < to;
        let mut known: Vec<(f64, f64)> = around.iter().chain(self.points.iter().filter(|r| inside(r.speed))).map(log).collect();
        known.retain(|k| k.1.is_finite());
        known.sort_by(|a, b| a.0.total_cmp(&b.0));
        known.dedup_by(|a, b| a.0 == b.0);
        for _ in 0..TRIES {
            let best =
                (1..known.len().checked_sub(1)?).filter(|&k| inside(known[k].0)).max_by(|&a, &b| known[a].1.total_cmp(&known[b].1))?;
            let (origin, ends) = (known[best], (known[best - 1].0, known[best + 1].0));
            let unit = ends.1 - ends.0;
            let p = Polynomial::through(&known, origin, unit);
            let slope = |w: f64| p.at((w - origin.0) / unit).1;
            let w = root(|w| Some(slope(w)), (ends.0, slope(ends.0)), (ends.1, slope(ends.1)), 0.0).filter(|&w| inside(w))?;
            let next = response(self.system, self.state, w).ok().flatten()?;
            let (_, value) = log(&next);
            let place = self.points.partition_point(|r| r.speed < w);
            self.points.insert(place, next);
            if (value - origin.1 - p.at((w - origin.0) / unit).0).abs() <= FORETOLD {
                return Some((w, value));
            }
            if !value.is_finite() || known.iter().any(|k| k.0 == w) {
                return None;
            }
            known.insert(known.partition_point(|k| k.0 < w), (w, value));
        }
        None
    }
}

/// A polynomial in Newton's form.
struct Polynomial {
    nodes: Vec<f64>,
    coefficients: Vec<f64>,
}

impl Polynomial {
    /// Through the points next to `origin`, in multiples of `unit` from it and as differences from its value.
    fn through(points: &[(f64, f64)], origin: (f64, f64), unit: f64) -> Self {
        let mut near: Vec<(f64, f64)> = points.iter().map(|p| ((p.0 - origin.0) / unit, p.1 - origin.1)).collect();
        near.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let (mut nodes, mut coefficients) = (Vec::<f64>::new(), Vec::<f64>::new());
        for (t, y) in near {
            if nodes.len() == NODES || nodes.iter().any(|n| (n - t).abs() < APART) {
                continue;
            }
            // the next divided difference is what the polynomial so far misses, over the product of the distances
            let so_far = Polynomial { nodes: nodes.clone(), coefficients: coefficients.clone() }.at(t).0;
            coefficients.push((y - so_far) / nodes.iter().map(|n| t - n).product::<f64>());
            nodes.push(t);
        }
        Polynomial { nodes, coefficients }
    }

    /// Value and slope.
    fn at(&self, t: f64) -> (f64, f64) {
        self.nodes.iter().zip(&self.coefficients).rev().fold((0.0, 0.0), |(p, slope), (n, c)| (p * (t - n) + c, slope * (t - n) + p))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_met_with_its_slope() {
        let f = |x: f64| 2.0 - 3.0 * x + x.powi(3) - 0.5 * x.powi(5);
        let slope = |x: f64| -3.0 + 3.0 * x * x - 2.5 * x.powi(4);
        let points: Vec<(f64, f64)> = [-1.0, -0.6, -0.1, 0.2, 0.5, 0.9, 1.3].iter().map(|&x| (x, f(x))).collect();
        let p = Polynomial::through(&points, points[3], 2.0);
        for x in [-0.9, 0.0, 0.33, 1.1] {
            let (value, s) = p.at((x - 0.2) / 2.0);
            assert!((value + f(0.2) - f(x)).abs() < 1e-14 && (s / 2.0 - slope(x)).abs() < 1e-13, "{x}");
        }
    }
}
