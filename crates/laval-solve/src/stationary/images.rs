//! States that differ by names only: angles a whole turn apart, equal masses with their places exchanged.

use crate::model::part::{At, DofKind, Rows};
use crate::model::system::{System, Workspace};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// What may be exchanged or counted modulo a turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Images {
    /// Coordinates that are angles of their part: they do not turn with the machine, and a whole turn changes nothing.
    pub angles: Vec<usize>,
    /// Angles whose exchange leaves the machine as it is: equal balls of one track. Every angle is in one group.
    pub groups: Vec<Vec<usize>>,
    /// Angles half a turn of which, with those of some others counted the other way round, changes nothing: a free ring turned over with its balls.
    pub flips: Vec<(usize, Vec<usize>)>,
}

/// Most rings that are turned over in all combinations.
const MOST_FLIPS: usize = 6;

/// An angle between -pi and pi.
pub fn wrapped(x: f64) -> f64 {
    let y = x - TAU * (x / TAU).round();
    if y <= -PI { y + TAU } else { y }
}

/// The machine at three random states.
struct Probe<'a> {
    system: &'a System,
    speed: f64,
    /// Coordinates, rates, accelerations; internal states.
    states: Vec<([Vec<f64>; 3], Vec<f64>)>,
}

impl<'a> Probe<'a> {
    fn new(system: &'a System, speed: f64) -> Self {
        let mut seed = 0x51_7c_c1_b7_27_22_0a_95u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let w = 1.0 + speed.abs();
        let mut sized = |size: f64| -> Vec<f64> {
            let all = system.coordinates().iter();
            all.map(|c| random() * size * if c.dof.kind == DofKind::Scalar { 1.0 } else { c.dof.typical }).collect()
        };
        let places: Vec<[Vec<f64>; 3]> = (0..3).map(|_| [sized(1.0), sized(w), sized(w * w)]).collect();
        let states = places.into_iter().map(|x| (x, system.states().iter().map(|s| random() * s.dof.typical).collect())).collect();
        Probe { system, speed, states }
    }

    /// Forces and rates of the nonlinear parts.
    fn rows(&self, x: &[Vec<f64>; 3], z: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let system = self.system;
        let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
        let at = At { q: &x[0], v: &x[1], a: &x[2], z, phase: 0.4, speed: self.speed, spin_accel: 0.0, t: 0.0 };
        let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &at, &mut out, &mut Workspace::default(), |s| !s.is_linear());
        (force, rate)
    }

    /// Whether the forces change as the coordinates do; `change` receives whether it acts on places.
    fn same(&self, change: &dyn Fn(&mut [f64], bool)) -> bool {
        // rows that are zero but for rounding do not speak for themselves
        let near = |a: &[f64], b: &[f64]| {
            let all = size(b);
            a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9 * (a.abs() + b.abs()) + 1e-12 * all)
        };
        self.states.iter().all(|(x, z)| {
            let (mut before, rate) = self.rows(x, z);
            let mut x = x.clone();
            x.iter_mut().enumerate().for_each(|(i, x)| change(x, i == 0));
            let (after, changed) = self.rows(&x, z);
            change(&mut before, false);
            near(&before, &after) && near(&rate, &changed)
        })
    }

    /// Rows whose force changes with the place of one coordinate alone.
    fn depending(&self, i: usize) -> Vec<usize> {
        let changes = |(x, z): &([Vec<f64>; 3], Vec<f64>)| -> Vec<bool> {
            let mut moved = x.clone();
            moved[0][i] += 1.0;
            let (a, b) = (self.rows(x, z).0, self.rows(&moved, z).0);
            a.iter().zip(&b).map(|(a, b)| !((a - b).abs() <= 1e-9 * (a.abs() + b.abs()))).collect()
        };
        let all: Vec<Vec<bool>> = self.states.iter().map(changes).collect();
        (0..self.system.n()).filter(|&j| all.iter().any(|c| c[j])).collect()
    }
}

impl Images {
    /// Found by probing the parts at random states.
    pub fn of(system: &System, speed: f64) -> Self {
        let probe = Probe::new(system, speed);
        let turned = |i: usize| {
            probe.same(&|x, place| {
                if place {
                    x[i] += TAU
                }
            })
        };
        let inside = system.coordinates().iter().enumerate().filter(|(_, c)| c.dof.kind == DofKind::Scalar && c.dof.unit == "rad");
        let angles: Vec<usize> = inside.map(|(i, _)| i).filter(|&i| turned(i)).collect();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for &i in &angles {
            match groups.iter().position(|g| probe.same(&|x, _| x.swap(i, g[0]))) {
                Some(k) => groups[k].push(i),
                None => groups.push(vec![i]),
            }
        }
        let slot = |i: usize| system.coordinates()[i].slot;
        let over = |&i: &usize| {
            let bound = probe.depending(i);
            let others: Vec<usize> = angles.iter().copied().filter(|&j| j != i && slot(j) == slot(i) && bound.contains(&j)).collect();
            let fits = probe.same(&|x, place| {
                if place {
                    x[i] += PI;
                }
                others.iter().for_each(|&j| x[j] = -x[j]);
            });
            (!others.is_empty() && fits).then_some((i, others))
        };
        let flips = angles.iter().filter_map(over).take(MOST_FLIPS).collect();
        Images { angles, groups, flips }
    }

    /// Of all images the one with angles between -pi and pi, and rings tilted by less than a quarter turn.
    pub fn normalise(&self, x: &mut [f64]) {
        self.angles.iter().for_each(|&i| x[i] = wrapped(x[i]));
        for (i, others) in &self.flips {
            if x[*i].abs() > 0.5 * PI {
                turn_over(x, *i, others);
            }
        }
    }

    /// Distance of two states over the scales, the least over all images.
    pub fn distance(&self, a: &[f64], b: &[f64], scale: &[f64]) -> f64 {
        let mut least = f64::INFINITY;
        for which in 0..1usize << self.flips.len() {
            let mut a = a.to_vec();
            let chosen = self.flips.iter().enumerate().filter(|(k, _)| (which >> k) & 1 == 1);
            chosen.for_each(|(_, (i, others))| turn_over(&mut a, *i, others));
            let d = self.apart(&a, b, scale);
            if d < least {
                least = d;
            }
        }
        least
    }

    /// All images of a state and its rates but for whole turns, the state itself first; `None` where there are more than `most`.
    pub fn all(&self, q: &[f64], v: &[f64], most: usize) -> Option<Vec<(Vec<f64>, Vec<f64>)>> {
        let mut out = vec![(q.to_vec(), v.to_vec())];
        for (ring, balls) in &self.flips {
            let over = |(q, v): &(Vec<f64>, Vec<f64>)| {
                let (mut q, mut v) = (q.clone(), v.clone());
                turn_over(&mut q, *ring, balls);
                balls.iter().for_each(|&j| v[j] = -v[j]);
                (q, v)
            };
            let more: Vec<_> = out.iter().map(over).collect();
            out.extend(more);
        }
        for group in &self.groups {
            let mut orders: Vec<Vec<usize>> = vec![vec![]];
            for &i in group {
                let with = |o: &Vec<usize>| (0..=o.len()).map(|k| [&o[..k], &[i], &o[k..]].concat()).collect::<Vec<_>>();
                orders = orders.iter().flat_map(with).collect();
                if orders.len() * out.len() > most {
                    return None;
                }
            }
            let reordered = |(q, v): &(Vec<f64>, Vec<f64>), order: &[usize]| {
                let (mut p, mut w) = (q.clone(), v.clone());
                group.iter().zip(order).for_each(|(&i, &j)| (p[i], w[i]) = (q[j], v[j]));
                (p, w)
            };
            out = orders.iter().rev().flat_map(|o| out.iter().map(|x| reordered(x, o)).collect::<Vec<_>>()).collect();
        }
        Some(out)
    }

    /// The same without rings turned over.
    fn apart(&self, a: &[f64], b: &[f64], scale: &[f64]) -> f64 {
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

fn turn_over(x: &mut [f64], ring: usize, balls: &[usize]) {
    x[ring] = wrapped(x[ring] + PI);
    balls.iter().for_each(|&j| x[j] = -x[j]);
}

fn size(x: &[f64]) -> f64 {
    x.iter().map(|x| x.abs()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two equal balls on a ring that may be turned over: four images, each once, at no distance from each other.
    #[test]
    fn all_images_are_the_same_state() {
        let images = Images { angles: vec![2, 3, 4], groups: vec![vec![2, 3], vec![4]], flips: vec![(4, vec![2, 3])] };
        let (q, v) = (vec![0.1, -0.2, 0.5, 1.9, 0.3], vec![1.0, 2.0, 3.0, 4.0, 5.0]);
        let all = images.all(&q, &v, 10).unwrap_or_default();
        assert_eq!((all.len(), &all[0]), (4, &(q.clone(), v.clone())));
        let scale = [1.0; 5];
        for (i, (p, w)) in all.iter().enumerate() {
            assert!(images.distance(p, &q, &scale) < 1e-12, "{p:?}");
            assert!(all[..i].iter().all(|o| o.0 != *p), "{p:?}");
            // each rate stays with its mass, turned round with its ring
            let sign = if p[4] == q[4] { 1.0 } else { -1.0 };
            for k in [2, 3] {
                let own = [2, 3].into_iter().find(|&j| p[k] == sign * q[j]);
                assert_eq!(own.map(|j| sign * v[j]), Some(w[k]), "{p:?} {w:?}");
            }
            assert_eq!(w[4], 5.0);
        }
        assert_eq!(images.all(&q, &v, 3), None);
    }
}
