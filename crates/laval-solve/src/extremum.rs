//! Maxima and minima of amplitudes between computed responses, shared by all bodies.
//!
//! Equations: the logarithm of an amplitude is interpolated by a polynomial p through the responses next to its extremum. Where the zero of p' and the
//! value there stay when the farthest response is left out, they are the extremum; else the response is computed at the zero, or beside it where one is
//! known too near for their difference to say anything, and joins the others. Responses hold all bodies: what one body's search computed serves those
//! whose extrema lie beside it, so that the number of responses hardly grows with that of the bodies.
//!
//! Validity: amplitudes that are smooth between the responses; otherwise golden section and parabolas take over.

use super::linear_response::{Response, response};
use super::locate::State;
use crate::model::probe::Probe;
use crate::model::system::System;
use laval_num::order::SortByNumber;
use laval_num::univariate::{maximum, root};

/// Most responses an interpolation uses.
const NODES: usize = 8;
/// Fewest responses whose agreement with one less is believed.
const FEWEST: usize = 6;
/// Interpolations tried before golden section.
const TRIES: usize = 8;
/// Distance of responses, over the width of the bracket, below which the slope between them is rounding.
const APART: f64 = 1e-3;
/// Move of the extremum, over the width of the bracket, that ends the search; and the one that is taken where rounding keeps it moving.
const STAYS: f64 = 1e-8;
const NEARLY: f64 = 1e-5;
/// Difference between the logarithms of the amplitude at the extremum and of what was foretold, above which it is not believed.
const FORETOLD: f64 = 1e-10;
/// The same between two interpolations, of which no response is a witness.
const AGREE: f64 = 1e-12;

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
    pub fn at(&self, speed: f64, probe: &Probe) -> Option<f64> {
        response(self.system, self.state, speed).ok().flatten().map(|r| r.size(probe))
    }

    /// The speed and the amplitude of a probe at its one maximum (or minimum) between the neighbours of `around[middle]`, which is above (below)
    /// both.
    pub fn extremum(&mut self, around: &[Response], middle: usize, sight: &Probe, up: bool) -> Option<(f64, f64)> {
        let sign = if up { 1.0 } else { -1.0 };
        let (from, to) = (around.get(middle.checked_sub(1)?)?.speed, around.get(middle + 1)?.speed);
        let found = self.interpolated(around, (from, to), sight, sign).or_else(|| {
            let tolerance = 1e-10 * to.abs();
            maximum(|w| self.at(w, sight).map(|x| sign * x.ln()), from, to, tolerance)
        });
        found.map(|(speed, v)| (speed, (sign * v).exp()))
    }

    /// By interpolation, until the extremum stays; none where it does not.
    fn interpolated(&mut self, around: &[Response], (from, to): (f64, f64), sight: &Probe, sign: f64) -> Option<(f64, f64)> {
        let unit = to - from;
        let inside = |w: f64| w > from && w < to;
        let log = |r: &Response| (r.speed, sign * r.size(sight).ln());
        let mut known: Vec<(f64, f64)> = around.iter().chain(self.points.iter().filter(|r| inside(r.speed))).map(log).collect();
        known.retain(|k| k.1.is_finite());
        known.sort_by_number(|a| a.0);
        known.dedup_by(|a, b| a.0 == b.0);
        let mut last: Option<f64> = None;
        for turn in 0..=TRIES {
            let best =
                (1..known.len().checked_sub(1)?).filter(|&k| inside(known[k].0)).max_by(|&a, &b| known[a].1.total_cmp(&known[b].1))?;
            let origin = known[best];
            let p = Polynomial::through(&known, origin, unit);
            let place = |w: f64| (w - origin.0) / unit;
            let ends = [known[best - 1].0, known[best + 1].0].map(place);
            let t = p.stationary(ends)?;
            let (w, top) = (origin.0 + t * unit, p.at(t).0);
            if !inside(w) {
                return None;
            }
            let moves = |q: &Polynomial| q.stationary(ends).map_or(f64::INFINITY, |other| (other - t).abs());
            let [less, lesser] = [1, 2].map(|k| p.without(k));
            let settled = p.nodes.len() >= FEWEST && moves(&less) <= STAYS && moves(&lesser) <= STAYS.sqrt();
            if settled && (less.at(t).0 - top).abs() <= AGREE {
                return Some((w, origin.1 + top));
            }
            let moved = last.map_or(f64::INFINITY, |l| (w - l).abs() / unit);
            let next = probe(&known, w, APART * unit).filter(|&x| moved > STAYS && inside(x));
            if turn == TRIES || next.is_none() {
                // what was not foretold is not smooth
                let value = sign * self.at(w, sight)?.ln();
                let foretold = (value - origin.1 - top).abs() <= FORETOLD;
                return (foretold && (next.is_none() || moved <= NEARLY)).then_some((w, value));
            }
            let probe = next?;
            let next = response(self.system, self.state, probe).ok().flatten()?;
            let (_, value) = log(&next);
            self.points.insert(self.points.partition_point(|r| r.speed < probe), next);
            if !value.is_finite() {
                return None;
            }
            known.insert(known.partition_point(|k| k.0 < probe), (probe, value));
            last = Some(w);
        }
        None
    }
}

/// Where to look next: at `w`, or as near as is `apart` from all that is known; none where both sides are taken.
fn probe(known: &[(f64, f64)], w: f64, apart: f64) -> Option<f64> {
    // rounding must not make a place taken by the one it was stepped off from
    let free = |x: &f64| known.iter().all(|k| (k.0 - x).abs() >= 0.999 * apart);
    let near = known.iter().map(|k| k.0).min_by(|a, b| (a - w).abs().total_cmp(&(b - w).abs()))?;
    let aside = if w >= near { apart } else { -apart };
    [w, near + aside, near - aside].into_iter().find(free)
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
        near.sort_by_number(|a| a.0.abs());
        let (mut nodes, mut coefficients) = (Vec::<f64>::new(), Vec::<f64>::new());
        for (t, y) in near {
            if nodes.len() == NODES || nodes.iter().any(|n| (n - t).abs() < 0.1 * APART) {
                continue;
            }
            // the next divided difference is what the polynomial so far misses, over the product of the distances
            let so_far = Polynomial { nodes: nodes.clone(), coefficients: coefficients.clone() }.at(t).0;
            coefficients.push((y - so_far) / nodes.iter().map(|n| t - n).product::<f64>());
            nodes.push(t);
        }
        Polynomial { nodes, coefficients }
    }

    /// Without the last nodes, the farthest ones.
    fn without(&self, count: usize) -> Self {
        let keep = self.nodes.len().saturating_sub(count);
        Polynomial { nodes: self.nodes[..keep].to_vec(), coefficients: self.coefficients[..keep].to_vec() }
    }

    /// Where its slope vanishes between these ends, at which it has opposite signs.
    fn stationary(&self, [from, to]: [f64; 2]) -> Option<f64> {
        let slope = |t: f64| self.at(t).1;
        root(|t| Some(slope(t)), (from, slope(from)), (to, slope(to)), 0.0)
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
