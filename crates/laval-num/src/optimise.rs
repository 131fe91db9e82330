//! Minimisation without derivatives in the unit cube: the evolution strategy with covariance matrix adaptation (CMA-ES).
//!
//! Points are drawn from a normal distribution whose mean, width and covariance follow the better half of each generation. Only the order of the values counts, so
//! that kinks (the larger of two peaks), plateaus and points without a value do no harm. A point outside the cube is moved to its nearest face, where it may stay:
//! bounds are reached exactly. The numbers drawn are a function of the seed.
//!
//! Sources: N. Hansen, "The CMA evolution strategy: a tutorial", arXiv:1604.00772 (2016), default parameters of its table 1.

use crate::dense::{Mat, dot, norm};
use crate::sampling::Points;
use crate::sampling::distribution::normal_quantile;
use serde::{Deserialize, Serialize};

/// The request.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Where the search begins, in the unit cube.
    pub start: Vec<f64>,
    /// Width of the first generation in the unit cube.
    pub width: f64,
    /// The search has arrived when the distribution is narrower than this in every direction.
    pub narrow: f64,
    /// Most evaluations.
    pub evaluations: usize,
    /// Seed of the numbers drawn.
    pub seed: u32,
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Ended {
    /// The distribution has become narrow, or the values no longer differ.
    Arrived,
    /// The evaluations were used up.
    Evaluations,
    /// The caller stopped it.
    Stopped,
}

/// Where a search arrived.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// The best point.
    pub x: Vec<f64>,
    /// Its value; infinite when no point had one.
    pub value: f64,
    /// Evaluations.
    pub evaluations: usize,
    /// Largest width of the last distribution.
    pub width: f64,
    /// How it ended.
    pub ended: Ended,
    /// After each generation: evaluations and best value so far.
    pub history: Vec<(usize, f64)>,
}

/// Generations over which values that no longer differ end the search, at least.
const STALE: usize = 12;

/// Minimises `f`, which gets the points of a generation and gives their values in order; a value that is not finite is the worst. `None` from `f` stops.
pub fn minimise(settings: &Settings, mut f: impl FnMut(&[Vec<f64>]) -> Option<Vec<f64>>) -> Optimum {
    let n = settings.start.len();
    let nf = n as f64;
    // an even number, so that pairs of cores are used
    let lambda = (4 + (3.0 * nf.ln().max(0.0)) as usize).next_multiple_of(2).max(6);
    let mu = lambda / 2;
    let raw: Vec<f64> = (0..mu).map(|i| (mu as f64 + 0.5).ln() - ((i + 1) as f64).ln()).collect();
    let total: f64 = raw.iter().sum();
    let weights: Vec<f64> = raw.iter().map(|w| w / total).collect();
    let mu_eff = 1.0 / weights.iter().map(|w| w * w).sum::<f64>();
    let cc = (4.0 + mu_eff / nf) / (nf + 4.0 + 2.0 * mu_eff / nf);
    let cs = (mu_eff + 2.0) / (nf + mu_eff + 5.0);
    let c1 = 2.0 / ((nf + 1.3) * (nf + 1.3) + mu_eff);
    let cmu = (1.0 - c1).min(2.0 * (mu_eff - 2.0 + 1.0 / mu_eff) / ((nf + 2.0) * (nf + 2.0) + mu_eff));
    let damps = 1.0 + 2.0 * (((mu_eff - 1.0) / (nf + 1.0)).sqrt() - 1.0).max(0.0) + cs;
    let expected = nf.sqrt() * (1.0 - 1.0 / (4.0 * nf) + 1.0 / (21.0 * nf * nf));

    let mut mean: Vec<f64> = settings.start.iter().map(|x| x.clamp(0.0, 1.0)).collect();
    let mut sigma = settings.width;
    let mut cov = Mat::identity(n);
    let (mut pc, mut ps) = (vec![0.0; n], vec![0.0; n]);
    let mut out =
        Optimum { x: mean.clone(), value: f64::INFINITY, evaluations: 0, width: sigma, ended: Ended::Evaluations, history: Vec::new() };
    let stale = STALE + (30.0 * nf / lambda as f64).ceil() as usize;
    let mut bests: Vec<f64> = Vec::new();
    let mut drawn = 0u32;
    while out.evaluations + lambda <= settings.evaluations {
        let (axes, lengths) = symmetric(&cov);
        out.width = sigma * lengths.iter().fold(0.0f64, |m, l| m.max(*l)).sqrt();
        if out.width < settings.narrow {
            out.ended = Ended::Arrived;
            break;
        }
        let points: Vec<Vec<f64>> = (0..lambda)
            .map(|_| {
                let z: Vec<f64> = (0..n as u32).map(|d| normal_quantile(Points::Random.at(settings.seed, drawn, d))).collect();
                drawn += 1;
                let along = |i: usize| (0..n).map(|k| axes[(i, k)] * lengths[k].max(0.0).sqrt() * z[k]).sum::<f64>();
                (0..n).map(|i| (mean[i] + sigma * along(i)).clamp(0.0, 1.0)).collect()
            })
            .collect();
        let Some(values) = f(&points) else {
            out.ended = Ended::Stopped;
            break;
        };
        out.evaluations += lambda;
        let worth = |i: usize| values.get(i).copied().filter(|v| v.is_finite()).unwrap_or(f64::INFINITY);
        let mut order: Vec<usize> = (0..lambda).collect();
        order.sort_by(|&a, &b| worth(a).total_cmp(&worth(b)));
        let best = worth(order[0]);
        if best < out.value {
            (out.value, out.x) = (best, points[order[0]].clone());
        }
        out.history.push((out.evaluations, out.value));
        bests.push(best);
        let lately = &bests[bests.len().saturating_sub(stale)..];
        let (low, high) =
            lately.iter().chain([&worth(order[mu])]).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
        if bests.len() >= stale && high - low <= 1e-13 * low.abs() {
            out.ended = Ended::Arrived;
            break;
        }
        // steps of the better half, in the distribution's own width
        let steps: Vec<Vec<f64>> =
            order[..mu].iter().map(|&k| points[k].iter().zip(&mean).map(|(x, m)| (x - m) / sigma).collect()).collect();
        let step: Vec<f64> = (0..n).map(|i| steps.iter().zip(&weights).map(|(y, w)| w * y[i]).sum()).collect();
        mean.iter_mut().zip(&step).for_each(|(m, y)| *m = (*m + sigma * y).clamp(0.0, 1.0));
        let inner: Vec<f64> = (0..n).map(|k| (0..n).map(|i| axes[(i, k)] * step[i]).sum::<f64>() / lengths[k].max(1e-300).sqrt()).collect();
        let gain = (cs * (2.0 - cs) * mu_eff).sqrt();
        for i in 0..n {
            ps[i] = (1.0 - cs) * ps[i] + gain * (0..n).map(|k| axes[(i, k)] * inner[k]).sum::<f64>();
        }
        let generation = bests.len() as i32;
        let long = norm(&ps) / (1.0 - (1.0 - cs).powi(2 * generation)).sqrt();
        let moving = f64::from(u8::from(long < (1.4 + 2.0 / (nf + 1.0)) * expected));
        let gain = moving * (cc * (2.0 - cc) * mu_eff).sqrt();
        pc.iter_mut().zip(&step).for_each(|(p, y)| *p = (1.0 - cc) * *p + gain * y);
        let keep = 1.0 - c1 - cmu + (1.0 - moving) * c1 * cc * (2.0 - cc);
        for i in 0..n {
            for j in 0..n {
                let rank: f64 = steps.iter().zip(&weights).map(|(y, w)| w * y[i] * y[j]).sum();
                cov[(i, j)] = keep * cov[(i, j)] + c1 * pc[i] * pc[j] + cmu * rank;
            }
        }
        sigma *= ((cs / damps) * (norm(&ps) / expected - 1.0)).clamp(-1.0, 1.0).exp();
    }
    out
}

/// Eigenvectors (columns) and eigenvalues of a symmetric matrix, by Jacobi's rotations.
fn symmetric(a: &Mat) -> (Mat, Vec<f64>) {
    let n = a.rows();
    let mut a = Mat::from_fn(n, n, |i, j| 0.5 * (a[(i, j)] + a[(j, i)]));
    let mut v = Mat::identity(n);
    for _ in 0..60 {
        let off: f64 = (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).map(|e| a[e] * a[e]).sum();
        let all: f64 = dot(a.data(), a.data());
        if !(off > 1e-30 * all) {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if a[(p, q)] == 0.0 {
                    continue;
                }
                let theta = (a[(q, q)] - a[(p, p)]) / (2.0 * a[(p, q)]);
                let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let t = if theta == 0.0 { 1.0 } else { t };
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for k in 0..n {
                    let (x, y) = (a[(k, p)], a[(k, q)]);
                    (a[(k, p)], a[(k, q)]) = (c * x - s * y, s * x + c * y);
                }
                for k in 0..n {
                    let (x, y) = (a[(p, k)], a[(q, k)]);
                    (a[(p, k)], a[(q, k)]) = (c * x - s * y, s * x + c * y);
                }
                for k in 0..n {
                    let (x, y) = (v[(k, p)], v[(k, q)]);
                    (v[(k, p)], v[(k, q)]) = (c * x - s * y, s * x + c * y);
                }
            }
        }
    }
    let values = (0..n).map(|i| a[(i, i)]).collect();
    (v, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn search(n: usize, seed: u32, f: impl Fn(&[f64]) -> f64) -> Optimum {
        let settings = Settings { start: vec![0.4; n], width: 0.25, narrow: 1e-11, evaluations: 6000, seed };
        minimise(&settings, |points| Some(points.iter().map(|x| f(x)).collect()))
    }

    #[test]
    fn jacobi_gives_back_the_matrix() {
        let a = Mat::from_fn(4, 4, |i, j| 1.0 / (1.0 + i as f64 + j as f64));
        let (v, l) = symmetric(&a);
        for i in 0..4 {
            for j in 0..4 {
                let back: f64 = (0..4).map(|k| v[(i, k)] * l[k] * v[(j, k)]).sum();
                let unit: f64 = (0..4).map(|k| v[(k, i)] * v[(k, j)]).sum();
                assert!((back - a[(i, j)]).abs() < 1e-14 && (unit - f64::from(u8::from(i == j))).abs() < 1e-14);
            }
        }
    }

    /// A narrow valley, smooth and kinked, and one that bends.
    #[test]
    fn valleys_smooth_and_kinked() {
        for seed in 1..4 {
            let o = search(3, seed, |x| (x[0] - 0.7).powi(2) + 1e4 * (x[1] - x[0] + 0.2).powi(2) + 10.0 * (x[2] - 0.1).powi(2));
            assert!(o.value < 1e-18 && (o.x[0] - 0.7).abs() < 1e-8 && o.ended == Ended::Arrived, "{o:?}");
            // the larger of two planes and a bowl: the minimum lies on the kink
            let o = search(2, seed, |x| (3.0 * (x[0] - 0.3)).max(-2.0 * (x[0] - 0.3)) + (x[1] - x[0]).powi(2));
            assert!((o.x[0] - 0.3).abs() < 1e-8 && (o.x[1] - 0.3).abs() < 1e-5, "{o:?}");
            let o = search(2, seed, |x| (1.0 - 2.0 * x[0]).powi(2) + 100.0 * (2.0 * x[1] - 4.0 * x[0] * x[0]).powi(2));
            assert!((o.x[0] - 0.5).abs() < 1e-6 && (o.x[1] - 0.5).abs() < 1e-6, "{o:?}");
        }
    }

    /// Bounds are reached exactly, alone and together with a minimum inside.
    #[test]
    fn bounds_are_reached_exactly() {
        let o = search(2, 5, |x| x[0] - 2.0 * x[1]);
        assert_eq!(o.x, [0.0, 1.0]);
        let o = search(2, 5, |x| (x[0] - 1.5).powi(2) + (x[1] - 0.25 * x[0]).powi(2));
        assert!(o.x[0] == 1.0 && (o.x[1] - 0.25).abs() < 1e-7, "{o:?}");
        let o = search(1, 5, |x| (x[0] - 0.125).abs());
        assert!((o.x[0] - 0.125).abs() < 1e-10);
    }

    /// Points without a value are avoided; without any value, or stopped, that is said; the same seed draws the same points.
    #[test]
    fn values_that_are_missing() {
        let o = search(2, 7, |x| if x[0] > 0.45 { f64::NAN } else { (x[0] - 0.8).powi(2) + (x[1] - 0.5).powi(2) });
        assert!((o.x[0] - 0.45).abs() < 1e-4 && (o.x[1] - 0.5).abs() < 0.01, "{o:?}");
        let o = search(2, 7, |_| f64::NAN);
        assert!(o.value == f64::INFINITY);
        let settings = Settings { start: vec![0.5], width: 0.1, narrow: 1e-9, evaluations: 100, seed: 1 };
        assert_eq!(minimise(&settings, |_| None).ended, Ended::Stopped);
        let f = |x: &[f64]| x[0] * x[0] + x[1];
        assert_eq!(search(2, 9, f).history, search(2, 9, f).history);
        assert_ne!(search(2, 9, f).history, search(2, 8, f).history);
    }
}
