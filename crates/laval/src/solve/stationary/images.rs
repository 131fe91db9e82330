//! States that differ by names only: angles a whole turn apart, equal masses with their places exchanged.

use crate::model::part::{At, DofKind, Rows};
use crate::model::system::{System, Workspace};
use std::f64::consts::{PI, TAU};

/// What may be exchanged or counted modulo a turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Images {
    /// Coordinates that are angles of their part: they do not turn with the machine, and a whole turn changes nothing.
    pub angles: Vec<usize>,
    /// Angles whose exchange leaves the machine as it is: equal balls of one track. Every angle is in one group.
    pub groups: Vec<Vec<usize>>,
}

/// An angle between -pi and pi.
pub fn wrapped(x: f64) -> f64 {
    let y = x - TAU * (x / TAU).round();
    if y <= -PI { y + TAU } else { y }
}

impl Images {
    /// Found by probing the parts at random states.
    pub fn of(system: &System, speed: f64) -> Self {
        let candidates: Vec<usize> = system
            .coordinates()
            .iter()
            .enumerate()
            .filter(|(_, c)| c.dof.kind == DofKind::Scalar && c.dof.unit == "rad")
            .map(|(i, _)| i)
            .collect();
        let same = |change: &dyn Fn(&mut [f64], bool)| {
            let mut seed = 0x51_7c_c1_b7_27_22_0a_95u64;
            let mut random = || {
                seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
            };
            (0..3).all(|_| {
                let w = 1.0 + speed.abs();
                let sized = |random: &mut dyn FnMut() -> f64, size: f64| -> Vec<f64> {
                    let all = system.coordinates().iter();
                    all.map(|c| random() * size * if c.dof.kind == DofKind::Scalar { 1.0 } else { c.dof.typical }).collect()
                };
                let mut x = [sized(&mut random, 1.0), sized(&mut random, w), sized(&mut random, w * w)];
                let z: Vec<f64> = system.states().iter().map(|s| random() * s.dof.typical).collect();
                let rows = |x: &[Vec<f64>; 3]| {
                    let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
                    let at = At { q: &x[0], v: &x[1], a: &x[2], z: &z, phase: 0.4, speed, spin_accel: 0.0, t: 0.0 };
                    let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
                    system.residual(system.params(), &at, &mut out, &mut Workspace::default(), |s| !s.is_linear());
                    (force, rate)
                };
                let (mut before, rate) = rows(&x);
                for (i, x) in x.iter_mut().enumerate() {
                    change(x, i == 0);
                }
                let (after, changed) = rows(&x);
                change(&mut before, false);
                // rows that are zero but for rounding do not speak for themselves
                let near = |a: &[f64], b: &[f64]| {
                    let all = size(b);
                    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9 * (a.abs() + b.abs()) + 1e-12 * all)
                };
                near(&before, &after) && near(&rate, &changed)
            })
        };
        let angles: Vec<usize> = candidates
            .into_iter()
            .filter(|&i| {
                same(&|x, place| {
                    if place {
                        x[i] += TAU
                    }
                })
            })
            .collect();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for &i in &angles {
            let fits = |g: &Vec<usize>| {
                let j = g[0];
                same(&|x, _| x.swap(i, j))
            };
            match groups.iter().position(fits) {
                Some(k) => groups[k].push(i),
                None => groups.push(vec![i]),
            }
        }
        Images { angles, groups }
    }

    /// Distance of two states over the scales, the least over all images.
    pub fn distance(&self, a: &[f64], b: &[f64], scale: &[f64]) -> f64 {
        let mut worst = 0.0f64;
        let mut note = |d: f64| {
            if !(d <= worst) {
                worst = d;
            }
        };
        for i in (0..a.len()).filter(|i| !self.angles.contains(i)) {
            note((a[i] - b[i]).abs() / scale[i]);
        }
        for group in &self.groups {
            let mut left = group.clone();
            for &i in group {
                let off = |&j: &usize| wrapped(a[i] - b[j]).abs();
                let Some(k) = (0..left.len()).min_by(|&k, &l| off(&left[k]).total_cmp(&off(&left[l]))) else { return f64::INFINITY };
                note(off(&left[k]) / scale[i]);
                left.swap_remove(k);
            }
        }
        worst
    }
}

fn size(x: &[f64]) -> f64 {
    x.iter().map(|x| x.abs()).sum()
}
