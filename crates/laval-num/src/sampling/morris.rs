//! Screening by elementary effects (Morris 1991; mu* after Campolongo et al. 2007).
//!
//! Equations: a trajectory changes one input after the other by D = 1/2 on a grid of four levels 1/8, 3/8, 5/8, 7/8 (the middles of the quarters,
//! so that the ends of distributions without ends are never needed); the effect of input i is `d_i = (f(x + D e_i) - f(x)) / D`. Over all
//! trajectories mu is its mean, mu* the mean of its size, sigma its standard deviation.

use super::quantile::Interval;
use super::{below, hash, moments};
use serde::{Deserialize, Serialize};

const LEVELS: usize = 4;
const STEP: usize = 2;

/// The plan of runs: trajectories of `inputs + 1` points each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Seed.
    pub seed: u32,
    /// Number of inputs.
    pub inputs: usize,
}

impl Plan {
    /// Runs per trajectory.
    pub fn runs(&self) -> usize {
        self.inputs + 1
    }

    /// Order in which a trajectory changes the inputs, and the level each begins at.
    fn trajectory(&self, t: usize) -> (Vec<usize>, Vec<usize>) {
        let random = |j: usize| hash(u64::from(self.seed), t as u64, j as u64);
        let mut order: Vec<usize> = (0..self.inputs).collect();
        for i in (1..self.inputs).rev() {
            order.swap(i, below(random(i), i + 1));
        }
        let start = (0..self.inputs).map(|i| below(random(self.inputs + i), LEVELS)).collect();
        (order, start)
    }

    /// The point of a run in the unit cube.
    pub fn point(&self, run: usize) -> Vec<f64> {
        let (order, start) = self.trajectory(run / self.runs());
        let mut level = start.clone();
        for &i in &order[..run % self.runs()] {
            level[i] = moved(start[i]);
        }
        level.iter().map(|&l| (l as f64 + 0.5) / LEVELS as f64).collect()
    }
}

/// The other level of a pair that is one step apart.
fn moved(level: usize) -> usize {
    if level < STEP { level + STEP } else { level - STEP }
}

/// What the trajectories say of one input; per unit of probability, so for a uniform input per width of its interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Effects {
    /// Mean.
    pub mu: f64,
    /// Mean size, with its confidence interval from the standard error.
    pub mu_star: Interval,
    /// Standard deviation: interaction or curvature.
    pub sigma: f64,
    /// Number of effects: steps between two runs that both have a value.
    pub count: usize,
}

/// Effects of all inputs from the values in the order of the plan.
pub fn effects(plan: &Plan, values: &[f64], confidence: f64) -> Vec<Effects> {
    let mut all = vec![Vec::new(); plan.inputs];
    for (t, v) in values.chunks_exact(plan.runs()).enumerate() {
        let (order, start) = plan.trajectory(t);
        for (j, &i) in order.iter().enumerate() {
            let sign = if start[i] < STEP { 1.0 } else { -1.0 };
            let d = sign * (v[j + 1] - v[j]) * LEVELS as f64 / STEP as f64;
            if d.is_finite() {
                all[i].push(d);
            }
        }
    }
    let z = super::distribution::normal_quantile(0.5 + 0.5 * confidence);
    let one = |d: &Vec<f64>| {
        let n = d.len() as f64;
        let (mu, sigma) = moments(d);
        let (star, spread) = moments(&d.iter().map(|x| x.abs()).collect::<Vec<_>>());
        let half = z * spread / n.sqrt();
        Effects { mu, mu_star: Interval { value: star, low: star - half, high: star + half }, sigma, count: d.len() }
    };
    all.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_function_gives_its_coefficients() {
        let c = [3.0, -0.25, 0.0, 1e-3];
        let plan = Plan { seed: 4, inputs: 4 };
        let f = |x: Vec<f64>| 2.0 + x.iter().zip(c).map(|(x, c)| c * x).sum::<f64>();
        let values: Vec<f64> = (0..20 * 5).map(|r| f(plan.point(r))).collect();
        for (e, c) in effects(&plan, &values, 0.95).iter().zip(c) {
            assert!((e.mu - c).abs() < 1e-14 && (e.mu_star.value - c.abs()).abs() < 1e-14 && e.sigma < 1e-14, "{e:?} {c}");
            assert_eq!(e.count, 20);
        }
    }

    #[test]
    fn each_run_changes_one_input_by_half_and_all_are_changed() {
        let plan = Plan { seed: 9, inputs: 6 };
        for t in 0..50 {
            let points: Vec<Vec<f64>> = (0..7).map(|j| plan.point(7 * t + j)).collect();
            let mut changed = vec![0; 6];
            for w in points.windows(2) {
                let d: Vec<f64> = w[0].iter().zip(&w[1]).map(|(a, b)| (b - a).abs()).collect();
                assert_eq!((d.iter().sum::<f64>(), d.iter().filter(|x| **x > 0.0).count()), (0.5, 1));
                changed[d.iter().position(|x| *x > 0.0).unwrap()] += 1;
            }
            assert_eq!(changed, [1; 6]);
            assert!(points.iter().flatten().all(|x| (0.125..=0.875).contains(x)));
        }
    }

    /// f = x y: the effect of x is y, uniform over the four levels: mean 1/2, standard deviation sqrt(5)/8.
    #[test]
    fn interaction_shows_in_sigma() {
        let plan = Plan { seed: 1, inputs: 2 };
        let values: Vec<f64> = (0..4000 * 3).map(|r| plan.point(r).iter().product()).collect();
        for e in effects(&plan, &values, 0.95) {
            assert!((e.mu - 0.5).abs() < 0.02 && (e.sigma - 5f64.sqrt() / 8.0).abs() < 0.01, "{e:?}");
            assert!(e.mu_star.low < 0.5 && 0.5 < e.mu_star.high);
        }
    }

    #[test]
    fn a_failed_run_costs_the_effects_beside_it_alone() {
        let plan = Plan { seed: 1, inputs: 3 };
        let mut values: Vec<f64> = (0..40).map(|r| plan.point(r).iter().sum()).collect();
        values[1] = f64::NAN;
        assert_eq!(effects(&plan, &values, 0.95).iter().map(|e| e.count).sum::<usize>(), 28);
    }
}
