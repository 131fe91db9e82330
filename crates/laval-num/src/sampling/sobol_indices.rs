//! First-order and total sensitivity indices of Sobol.
//!
//! Equations: with two independent points a, b and ab_i (a with coordinate i of b), f centred at its mean and V its variance,
//! `S_i = mean( f(b) (f(ab_i) - f(a)) ) / V` (Saltelli et al. 2010) and `T_i = mean( (f(a) - f(ab_i))^2 ) / 2V` (Jansen 1999).
//! Confidence intervals by bootstrap over the base points; for points of a low-discrepancy sequence, which err less, they are on the wide side.

use super::quantile::{Interval, quantile};
use super::{Points, below, hash};
use serde::{Deserialize, Serialize};

/// Resamples of the bootstrap.
const RESAMPLES: usize = 1000;

/// The plan of runs: `runs` per base point, first a, then b, then ab_1 to ab_k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Where points are taken from.
    pub points: Points,
    /// Seed.
    pub seed: u32,
    /// Number k of inputs.
    pub inputs: usize,
}

impl Plan {
    /// Runs per base point.
    pub fn runs(&self) -> usize {
        self.inputs + 2
    }

    /// The point of a run in the unit cube.
    pub fn point(&self, run: usize) -> Vec<f64> {
        let (base, which) = ((run / self.runs()) as u32, run % self.runs());
        let k = self.inputs as u32;
        let from_b = |i: u32| which == 1 || which == i as usize + 2;
        (0..k).map(|i| self.points.at(self.seed, base, if from_b(i) { k + i } else { i })).collect()
    }
}

/// Indices of one input.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Indices {
    /// Share of the variance that goes when this input alone is known.
    pub first: Interval,
    /// Share of the variance that stays while this input alone is unknown.
    pub total: Interval,
}

/// Indices of all inputs from the values of complete base points, `inputs + 2` values each in the order of [`Plan`], and the number of base
/// points used: those with a value that is no number are left out. `None` when fewer than two are left or nothing varies.
pub fn indices(plan: &Plan, values: &[f64], confidence: f64) -> Option<(Vec<Indices>, usize)> {
    let runs = plan.runs();
    let rows: Vec<&[f64]> = values.chunks_exact(runs).filter(|r| r.iter().all(|x| x.is_finite())).collect();
    if rows.len() < 2 {
        return None;
    }
    let all: Vec<usize> = (0..rows.len()).collect();
    let (first, total) = estimate(&rows, &all)?;
    let mut spread: Vec<[Vec<f64>; 2]> = vec![Default::default(); plan.inputs];
    let mut pick = all.clone();
    for b in 0..RESAMPLES {
        for (j, p) in pick.iter_mut().enumerate() {
            *p = below(hash(u64::from(plan.seed) ^ 0xb007, b as u64, j as u64), rows.len());
        }
        // a resample that happens not to vary says nothing
        if let Some((s, t)) = estimate(&rows, &pick) {
            for i in 0..plan.inputs {
                spread[i][0].push(s[i]);
                spread[i][1].push(t[i]);
            }
        }
    }
    let interval = |value: f64, sample: &mut Vec<f64>| {
        sample.sort_by(f64::total_cmp);
        let at = |p| quantile(sample, p, 0.5).value;
        Interval { value, low: at(0.5 - 0.5 * confidence), high: at(0.5 + 0.5 * confidence) }
    };
    let each = spread.iter_mut().enumerate();
    let out = each.map(|(i, [s, t])| Indices { first: interval(first[i], s), total: interval(total[i], t) }).collect();
    Some((out, rows.len()))
}

fn estimate(rows: &[&[f64]], pick: &[usize]) -> Option<(Vec<f64>, Vec<f64>)> {
    let n = pick.len() as f64;
    let (mut mean, mut square) = (0.0, 0.0);
    for r in pick.iter().map(|&j| rows[j]) {
        mean += r[0] + r[1];
    }
    mean /= 2.0 * n;
    for r in pick.iter().map(|&j| rows[j]) {
        square += (r[0] - mean).powi(2) + (r[1] - mean).powi(2);
    }
    let variance = square / (2.0 * n);
    // differences below the last digits of the values are no variance
    if !(variance > (1e-14 * mean).powi(2)) {
        return None;
    }
    let inputs = rows.first()?.len() - 2;
    let (mut first, mut total) = (vec![0.0; inputs], vec![0.0; inputs]);
    for r in pick.iter().map(|&j| rows[j]) {
        for i in 0..inputs {
            first[i] += (r[1] - mean) * (r[i + 2] - r[0]);
            total[i] += (r[0] - r[i + 2]).powi(2);
        }
    }
    first.iter_mut().for_each(|x| *x /= n * variance);
    total.iter_mut().for_each(|x| *x /= 2.0 * n * variance);
    Some((first, total))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn run(points: Points, inputs: usize, n: usize, f: impl Fn(&[f64]) -> f64) -> Vec<Indices> {
        let plan = Plan { points, seed: 1, inputs };
        let values: Vec<f64> = (0..n * plan.runs()).map(|r| f(&plan.point(r))).collect();
        let (out, used) = indices(&plan, &values, 0.95).unwrap();
        assert_eq!(used, n);
        out
    }

    fn ishigami(u: &[f64]) -> f64 {
        let x: Vec<f64> = u.iter().map(|u| PI * (2.0 * u - 1.0)).collect();
        x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()
    }

    /// First and total indices of Ishigami's function in closed form (a = 7, b = 0.1).
    fn ishigami_exact() -> [(f64, f64); 3] {
        let (a, b) = (7.0f64, 0.1f64);
        let v1 = 0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2);
        let v2 = a * a / 8.0;
        let v13 = 8.0 * b * b * PI.powi(8) / 225.0;
        let v = v1 + v2 + v13;
        [(v1 / v, (v1 + v13) / v), (v2 / v, v2 / v), (0.0, v13 / v)]
    }

    #[test]
    fn ishigami_function() {
        // standard errors of 2^14 random points are about 0.01; scrambled Sobol points do better
        for (points, limit) in [(Points::Sobol, 0.004), (Points::Random, 0.04)] {
            for (i, (x, (s, t))) in run(points, 3, 1 << 14, ishigami).iter().zip(ishigami_exact()).enumerate() {
                assert!((x.first.value - s).abs() < limit, "S{i} {x:?} {s}");
                assert!((x.total.value - t).abs() < limit, "T{i} {x:?} {t}");
                assert!(x.first.low <= x.first.value && x.first.value <= x.first.high);
            }
        }
    }

    #[test]
    fn the_g_function_of_sobol() {
        let a = [0.0, 0.5, 3.0, 9.0, 99.0, 99.0];
        let g = |u: &[f64]| u.iter().zip(a).map(|(u, a)| ((4.0 * u - 2.0).abs() + a) / (1.0 + a)).product::<f64>();
        let part = a.map(|a: f64| 1.0 / (3.0 * (1.0 + a).powi(2)));
        let v = part.iter().map(|v| 1.0 + v).product::<f64>() - 1.0;
        for (i, x) in run(Points::Sobol, 6, 1 << 14, g).iter().enumerate() {
            let others: f64 = (0..6).filter(|&j| j != i).map(|j| 1.0 + part[j]).product();
            assert!((x.first.value - part[i] / v).abs() < 0.006, "S{i} {x:?} {}", part[i] / v);
            assert!((x.total.value - part[i] * others / v).abs() < 0.006, "T{i} {x:?}");
        }
    }

    #[test]
    fn bootstrap_intervals_hold_the_exact_values_of_random_sampling() {
        let exact = ishigami_exact();
        let mut held = 0;
        for seed in 0..40 {
            let plan = Plan { points: Points::Random, seed, inputs: 3 };
            let values: Vec<f64> = (0..400 * 5).map(|r| ishigami(&plan.point(r))).collect();
            let (found, _) = indices(&plan, &values, 0.95).unwrap();
            for (x, (s, t)) in found.iter().zip(exact) {
                held += usize::from(x.first.low <= s && s <= x.first.high) + usize::from(x.total.low <= t && t <= x.total.high);
            }
        }
        // 240 intervals; those of one sample hang together, so a wider margin than the binomial
        assert!((213..=240).contains(&held), "{held}");
    }

    #[test]
    fn failures_are_left_out_and_nothing_that_varies_is_nothing() {
        let plan = Plan { points: Points::Random, seed: 3, inputs: 2 };
        let mut values: Vec<f64> = (0..4 * 1000).map(|r| plan.point(r)[0]).collect();
        values[6] = f64::NAN;
        let (found, used) = indices(&plan, &values, 0.95).unwrap();
        assert_eq!(used, 999);
        assert!((found[0].total.value - 1.0).abs() < 0.1 && found[1].total.value == 0.0 && found[1].first.value == 0.0);
        assert!(indices(&plan, &[2.0; 400], 0.95).is_none());
        assert!(indices(&plan, &[f64::NAN; 400], 0.95).is_none());
    }
}
