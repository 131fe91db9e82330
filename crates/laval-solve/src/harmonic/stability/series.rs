//! Tangents along a periodic motion as trigonometric polynomials through equidistant samples.
//!
//! Along a motion of finitely many harmonics the tangents of an analytic law are analytic and periodic, so that their Fourier coefficients fall
//! geometrically. Samples are doubled until the upper half of the orders they resolve is negligible; the polynomial through them then gives the tangents at
//! any instant. A law that is not smooth along the motion has no such series.

use crate::harmonic::balance::fourier::{motion_at, turns};
use crate::harmonic::balance::nonlinear::Sampled;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::balance::terms::Terms;
use crate::model::part::DofKind;
use crate::symmetry::Symmetry;
use laval_num::complex::C64;
use laval_num::dense::Mat;
use laval_num::lanes::LANES;
use laval_num::ode::transition::{Row, STAGES, at_nodes, nodes};
use std::f64::consts::{PI, TAU};

/// Samples of a whole period beyond which a law does not count as smooth.
const MOST_SAMPLES: usize = 1024;

/// An element of the tangents: derivative of the coordinates, row, column.
pub(super) type Element = (usize, usize, usize);

/// Samples of the tangents, and the weights with which they give the tangents at nodes of steps.
#[derive(Default)]
pub(super) struct Series {
    /// Samples between those of the balance.
    between: Sampled,
    /// Tangents by displacements and by rates over the part of the period that the symmetry repeats, sample after sample.
    part: [Mat; 2],
    /// Doublings that the last motion needed.
    doublings: u32,
    /// Samples over `span`, and their elements.
    count: usize,
    values: Vec<f64>,
    /// The tangents repeat after this base phase.
    span: f64,
    /// Those in use first.
    weights: Vec<Weights>,
}

/// Weights of samples at the nodes of steps: group after group, stage after stage.
struct Weights {
    /// Samples over a span of this length, and steps over this base phase.
    count: usize,
    span: f64,
    groups: usize,
    length: f64,
    forward: bool,
    rows: Vec<Row>,
}

/// Weights kept.
const KEPT: usize = 4;

/// How one coordinate of the motion follows from the motion one repeated part earlier: the coordinate there, and its sign.
fn repeated(kinds: &[DofKind], terms: &Terms) -> Vec<(usize, f64)> {
    let vector = |k: DofKind| k.leads_pair() || k.ends_pair();
    // exp(i nu pi/2) turns x + i y
    let sign = if terms.divisor % 4 == 3 { -1.0 } else { 1.0 };
    let of = |(i, &kind): (usize, &DofKind)| match terms.symmetry {
        Symmetry::Half if vector(kind) => (i, -1.0),
        Symmetry::Quarter if kind.leads_pair() => (i + 1, -sign),
        Symmetry::Quarter if kind.ends_pair() => (i - 1, sign),
        _ => (i, 1.0),
    };
    kinds.iter().enumerate().map(of).collect()
}

impl Series {
    /// Forgets the samples that earlier motions needed.
    pub(super) fn begin(&mut self) {
        self.doublings = 0;
    }

    /// Samples the tangents of a motion, as `balance` has sampled them last, until their series has this relative accuracy. False where it has none.
    pub(super) fn sample(&mut self, balance: &mut Balance, x: &[f64], speed: f64, elements: &[Element], tolerance: f64) -> bool {
        for (own, d) in self.part.iter_mut().zip(0..2) {
            own.copy_from(balance.sampled.tangent(d));
        }
        let mut doublings = 0;
        let mut samples = balance.terms.samples;
        loop {
            if doublings >= self.doublings && self.extend(balance, samples, elements, tolerance) {
                self.doublings = doublings;
                return true;
            }
            if 2 * samples * balance.terms.symmetry.order().max(1) > MOST_SAMPLES {
                return false;
            }
            self.double(balance, x, speed, samples);
            samples *= 2;
            doublings += 1;
        }
    }

    /// Puts a sample between every two.
    fn double(&mut self, balance: &mut Balance, x: &[f64], speed: f64, samples: usize) {
        let (terms, pace) = (&balance.terms, balance.pace(speed));
        let m = terms.coordinates;
        let step = TAU / (samples * terms.symmetry.order().max(1)) as f64;
        let angles: Vec<f64> = (0..samples).map(|i| (i as f64 + 0.5) * step).collect();
        let mut motion = [0; 3].map(|_| Vec::with_capacity(samples * m));
        let (mut one, mut turned) = ([0; 3].map(|_| vec![0.0; m]), Vec::new());
        for &tau in &angles {
            turns(tau, terms.harmonics, &mut turned);
            motion_at(terms, x, pace.frequency, &turned, &mut one);
            motion.iter_mut().zip(&one).for_each(|(all, u)| all.extend_from_slice(u));
        }
        let [u, v, w] = &motion;
        self.between.eval_along(balance.system, &balance.nonlinear.members, terms, &angles, [u, v, w], pace);
        for (d, own) in self.part.iter_mut().enumerate() {
            let new = self.between.tangent(d);
            let mut both = Mat::zeros(2 * samples * m, m);
            for i in 0..samples {
                for j in 0..m {
                    both.row_mut(2 * i * m + j).copy_from_slice(own.row(i * m + j));
                    both.row_mut((2 * i + 1) * m + j).copy_from_slice(new.row(i * m + j));
                }
            }
            *own = both;
        }
    }

    /// Elements over the span, from those of the repeated part; true where their series is accurate.
    fn extend(&mut self, balance: &Balance, samples: usize, elements: &[Element], tolerance: f64) -> bool {
        let (terms, kinds) = (&balance.terms, &balance.nonlinear.kinds);
        let (m, order) = (terms.coordinates, terms.symmetry.order().max(1));
        let signs = kinds.iter().all(|k| k.leads_pair() || k.ends_pair());
        // all coordinates change their sign in half a turn: the tangents do not
        let parts = if order > 1 && signs { order / 2 } else { order };
        self.span = parts as f64 * TAU / order as f64;
        self.count = parts * samples;
        let repeated = repeated(kinds, terms);
        let mut from: Vec<(usize, f64)> = (0..m).map(|i| (i, 1.0)).collect();
        self.values.clear();
        for _ in 0..parts {
            for i in 0..samples {
                self.values.extend(elements.iter().map(|&(d, j, k)| {
                    let ((j, sj), (k, sk)) = (from[j], from[k]);
                    sj * sk * self.part[d][(i * m + j, k)]
                }));
            }
            from = repeated.iter().map(|&(i, s)| (from[i].0, s * from[i].1)).collect();
        }
        let accurate = self.is_accurate(elements, tolerance);
        if accurate && self.count.is_multiple_of(2) {
            // every other sample resolves the orders that remain
            let width = elements.len();
            self.count /= 2;
            for i in 1..self.count {
                self.values.copy_within(2 * i * width..(2 * i + 1) * width, i * width);
            }
        }
        accurate
    }

    /// The upper half of the orders is negligible beside the largest value of the same derivative.
    fn is_accurate(&self, elements: &[Element], tolerance: f64) -> bool {
        let (count, width) = (self.count, elements.len());
        let mut size = [0.0f64; 2];
        for sample in self.values.chunks_exact(width) {
            elements.iter().zip(sample).for_each(|(e, x)| size[e.0] = size[e.0].max(x.abs()));
        }
        let turn: Vec<C64> = (0..count).map(|i| C64::cis(-TAU * i as f64 / count as f64)).collect();
        for (w, e) in elements.iter().enumerate() {
            let limit = tolerance * size[e.0] * count as f64;
            for order in count.div_ceil(4)..=count / 2 {
                let mut sum = C64::zero();
                for (i, sample) in self.values.chunks_exact(width).enumerate() {
                    sum += turn[order * i % count].scale(sample[w]);
                }
                // NaN fails
                if !(sum.norm_sqr() <= limit * limit) {
                    return false;
                }
            }
        }
        true
    }

    /// Prepares the weights for `groups` times [`LANES`] steps over the base phase `length`, forwards or backwards.
    pub(super) fn set_steps(&mut self, groups: usize, length: f64, forward: bool) {
        let (count, span) = (self.count, self.span);
        let same = |w: &Weights| (w.count, w.span, w.groups, w.length, w.forward) == (count, span, groups, length, forward);
        if let Some(at) = self.weights.iter().position(same) {
            return self.weights.swap(0, at);
        }
        let scale = TAU / span * if forward { 1.0 } else { -1.0 };
        let h = length / (groups * LANES) as f64;
        let cardinals = Cardinals::new(count);
        let mut rows = Vec::with_capacity(groups * STAGES * count);
        for group in 0..groups {
            for node in nodes() {
                let first = rows.len();
                rows.resize(first + count, [0.0; LANES]);
                for lane in 0..LANES {
                    let at = ((group * LANES + lane) as f64 + node) * h * scale;
                    cardinals.at(at, |i, x| rows[first + i][lane] = x);
                }
            }
        }
        self.weights.truncate(KEPT - 1);
        self.weights.insert(0, Weights { count, span, groups, length, forward, rows });
    }

    /// Elements at the nodes of a group of steps, stage after stage.
    pub(super) fn at_nodes(&self, group: usize, width: usize, out: &mut Vec<Row>) {
        let count = STAGES * self.count;
        let rows = self.weights.first().map_or(&[][..], |w| &w.rows[group * count..][..count]);
        at_nodes(rows, &self.values, width, out);
    }
}

/// The trigonometric polynomials through equidistant samples of a period that are 1 at one of them and 0 at the others.
struct Cardinals {
    /// Sine and cosine of half the angle of each sample.
    halves: Vec<(f64, f64)>,
}

impl Cardinals {
    fn new(count: usize) -> Self {
        Cardinals { halves: (0..count).map(|i| (PI * i as f64 / count as f64).sin_cos()).collect() }
    }

    /// All of them at an angle: `sin(n d) cot(d) / n`, with d half the distance from the sample; for an odd number n of samples without the cosine.
    fn at(&self, angle: f64, mut out: impl FnMut(usize, f64)) {
        let count = self.halves.len();
        let n = count as f64;
        let half = 0.5 * angle;
        let ((s, c), top) = (half.sin_cos(), (n * half).sin());
        for (i, &(si, ci)) in self.halves.iter().enumerate() {
            // half a turn for each sample
            let top = if i % 2 == 0 { top } else { -top };
            let (mut sine, mut cosine, mut top) = (s * ci - c * si, c * ci + s * si, top);
            if sine.abs() < 1e-2 {
                // close to the sample the difference has lost its digits
                let d = half - PI * i as f64 / n;
                let d = d - PI * (d / PI).round();
                let turned = if cosine < 0.0 { -1.0 } else { 1.0 };
                (sine, cosine) = (turned * d.sin(), turned * d.cos());
                let nd = n * d;
                if d.abs() < 1e-9 {
                    out(i, 1.0);
                    continue;
                }
                // an odd number of samples changes its sign with every turn, like the sine
                top = if count.is_multiple_of(2) { nd.sin() } else { turned * nd.sin() };
            }
            out(i, if count.is_multiple_of(2) { top * cosine / (n * sine) } else { top / (n * sine) });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cardinal_functions_interpolate_trigonometric_polynomials() {
        for count in [7, 8, 9, 16, 32] {
            let cardinals = Cardinals::new(count);
            let f = |a: f64| 0.3 + (2.0 * a).cos() - 0.7 * (3.0 * a).sin();
            for k in -40..40 {
                for shift in [0.0, 1e-12, 1e-8, 1e-4, 0.003, 0.1] {
                    let a = TAU * f64::from(k) / count as f64 + shift;
                    let mut sum = 0.0;
                    cardinals.at(a, |i, x| sum += x * f(TAU * i as f64 / count as f64));
                    assert!((sum - f(a)).abs() < 1e-12, "{count} {a}: {sum} instead of {}", f(a));
                }
            }
        }
    }
}
