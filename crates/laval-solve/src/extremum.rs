//! Maxima and minima of amplitudes between computed responses, and where they have a given value, shared by all bodies.
//!
//! Equations: the logarithm of an amplitude is interpolated by a polynomial p through the responses next to its extremum. Where the zero of p' and the
//! value there stay when the farthest responses are left out, one and two, they are the extremum; else the response is computed at the zero, or beside it where one is
//! known too near for their difference to say anything, and joins the others. Responses hold all bodies: what one body's search computed serves those
//! whose extrema lie beside it, so that the number of responses hardly grows with that of the bodies. Places of a given value are zeros of p less its logarithm.
//!
//! Validity: amplitudes that are smooth between the responses; otherwise golden section and parabolas take over.

use super::linear_response::Response;
use crate::model::probe::Probe;
use laval_num::order::SortByNumber;
use laval_num::univariate::{maximum, root};

/// Most responses an interpolation uses.
const NODES: usize = 8;
/// Responses beyond the neighbours of an extremum that guide its search.
pub const BESIDE: usize = 2;
/// Fewest responses whose agreement with one less is believed.
const FEWEST: usize = 6;
/// Interpolations tried before golden section.
const TRIES: usize = 8;
/// Distance of responses, over the width of the bracket, below which the slope between them is rounding.
const APART: f64 = 1e-3;
/// Relative difference of two speeds of a given amplitude that are one.
const SAME: f64 = 1e-12;
/// Move of the extremum, over the width of the bracket, that ends the search; and the one that is taken where rounding keeps it moving.
const STAYS: f64 = 1e-8;
const NEARLY: f64 = 1e-5;
/// Difference between the logarithms of the amplitude at the extremum and of what was foretold, above which it is not believed.
const FORETOLD: f64 = 1e-10;
/// The same between two interpolations, of which no response is a witness.
const AGREE: f64 = 1e-13;

/// Responses computed in the search.
pub struct Search<'a> {
    response: &'a dyn Fn(f64) -> Option<Response>,
    /// By speed.
    points: Vec<Response>,
}

impl<'a> Search<'a> {
    /// With the response at a speed, or a frequency that is its `speed`.
    pub fn new(response: &'a dyn Fn(f64) -> Option<Response>) -> Self {
        Search { response, points: Vec::new() }
    }

    /// Amplitude at a speed; none where the response does not exist.
    pub fn at(&self, speed: f64, probe: &Probe) -> Option<f64> {
        (self.response)(speed).map(|r| r.size(probe))
    }

    /// Responses known in an interval and beside it, by speed, as logarithms of an amplitude.
    fn known(&self, around: &[Response], (from, to): (f64, f64), sight: &Probe) -> Vec<(f64, f64)> {
        let own = self.points.iter().filter(|r| r.speed > from && r.speed < to);
        let mut known: Vec<(f64, f64)> = around.iter().chain(own).map(|r| (r.speed, r.size(sight).ln())).collect();
        known.retain(|k| k.1.is_finite());
        known.sort_by_number(|a| a.0);
        known.dedup_by(|a, b| a.0 == b.0);
        known
    }

    /// Computes the response at a speed and keeps it.
    fn compute(&mut self, speed: f64, sight: &Probe) -> Option<(f64, f64)> {
        let next = (self.response)(speed)?;
        let value = next.size(sight).ln();
        self.points.insert(self.points.partition_point(|r| r.speed < speed), next);
        value.is_finite().then_some((speed, value))
    }

    /// Where between two speeds, given with amplitudes above and below it, the amplitude of a probe has a value; `around` are responses there and next to them.
    pub fn level(&mut self, around: &[Response], ends: [(f64, f64); 2], sight: &Probe, value: f64) -> Option<f64> {
        let (low, high) = (ends[0].0.min(ends[1].0), ends[0].0.max(ends[1].0));
        let mut known = self.known(around, (low, high), sight);
        known.extend(ends.map(|(w, size)| (w, size.ln())));
        known.sort_by_number(|a| a.0);
        known.dedup_by(|a, b| a.0 == b.0);
        let (unit, level) = (high - low, value.ln());
        for _ in 0..TRIES {
            let crossed = |w: &[(f64, f64)]| w[0].0 >= low && w[1].0 <= high && (w[0].1 > level) != (w[1].1 > level);
            let pair = known.windows(2).find(|w| crossed(w))?;
            let origin = if (pair[0].1 - level).abs() < (pair[1].1 - level).abs() { pair[0] } else { pair[1] };
            let ends = [pair[0].0, pair[1].0].map(|w| (w - origin.0) / unit);
            let p = Polynomial::through(&known, origin, unit);
            let t = p.reaches(level - origin.1, ends)?;
            let w = origin.0 + t * unit;
            let moves = |k: usize| p.without(k).reaches(level - origin.1, ends).map_or(f64::INFINITY, |other| (other - t).abs() * unit);
            if p.nodes.len() >= FEWEST && moves(1) <= SAME * w.abs() && moves(2) <= SAME.sqrt() * unit {
                return Some(w);
            }
            if known.iter().any(|k| (k.0 - w).abs() <= SAME * w.abs()) {
                return Some(w);
            }
            let next = self.compute(w, sight)?;
            known.insert(known.partition_point(|k| k.0 < w), next);
        }
        None
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
        let mut known = self.known(around, (from, to), sight);
        known.iter_mut().for_each(|k| k.1 *= sign);
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
            // both, because a pair of nodes far on either side hides behind one of them
            if settled && [less, lesser].iter().all(|q| (q.at(t).0 - top).abs() <= AGREE) {
                // the first one here is solved for, what lies beside it is known as well by interpolation
                let near = known.iter().any(|k| (k.0 - w).abs() <= APART * unit);
                return if near { Some((w, origin.1 + top)) } else { self.compute(w, sight).map(|(_, value)| (w, sign * value)) };
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
            let (_, value) = self.compute(probe, sight)?;
            known.insert(known.partition_point(|k| k.0 < probe), (probe, sign * value));
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

    /// Where it has a value between these ends, at which it is above and below.
    fn reaches(&self, value: f64, [from, to]: [f64; 2]) -> Option<f64> {
        let f = |t: f64| self.at(t).0 - value;
        root(|t| Some(f(t)), (from, f(from)), (to, f(to)), 0.0)
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
