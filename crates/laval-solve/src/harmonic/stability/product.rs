//! The map over a period as a product of maps over equal steps, side by side in lanes, where the tangents have a series.

use crate::harmonic::balance::problem::Balance;
use crate::harmonic::stability::floquet::{Block, Stability};
use crate::harmonic::stability::series::{Element, Series};
use laval_num::continuation::Zero;
use laval_num::dense::Mat;
use laval_num::lanes::LANES;
use laval_num::ode::transition::{Row, Transition, Varying};
use std::f64::consts::TAU;

/// Groups of steps beyond which steps of a length of their own are taken.
const MOST_GROUPS: usize = 32;
/// What the error of the series may be of the tolerance of the steps.
const OF_SERIES: f64 = 0.1;

/// Storage of the products.
#[derive(Default)]
pub(super) struct Products {
    series: Series,
    transition: Transition,
    /// Groups of [`LANES`] steps that the last motion needed.
    groups: usize,
    elements: Vec<Element>,
    values: Vec<Row>,
}

/// A block as the steps need it.
struct Sparse {
    constant: Vec<(usize, usize, f64)>,
    entries: Vec<(usize, usize, usize, f64)>,
}

impl Products {
    /// Forgets the steps that earlier motions needed.
    pub(super) fn begin(&mut self) {
        self.groups = 0;
        self.series.begin();
    }
}

impl Stability {
    /// Maps of the blocks over the base phase `TAU / parts`, which takes `period` seconds, and the number of steps; nothing where the tangents have no series or the steps
    /// would have to be very short.
    pub(super) fn product(
        &mut self,
        balance: &mut Balance,
        x: &[f64],
        speed: f64,
        blocks: &[Block],
        (parts, period): (usize, f64),
    ) -> Option<(Vec<Mat>, u64)> {
        let own = &mut self.products;
        let elements = &mut own.elements;
        elements.clear();
        elements.extend(blocks.iter().flat_map(|b| &b.entries).map(|e| (e.derivative, e.j, e.k)));
        elements.sort_unstable();
        elements.dedup();
        if elements.is_empty() || !own.series.sample(balance, x, speed, elements, OF_SERIES * self.tolerance) {
            return None;
        }
        let of = |b: &Block| {
            let n = b.states.len();
            let entries = b.constant.iter().enumerate().filter(|x| *x.1 != 0.0);
            Sparse {
                constant: entries.map(|(at, &x)| (at / n, at % n, x)).collect(),
                entries: b
                    .entries
                    .iter()
                    .filter_map(|e| Some((e.row, e.col, elements.binary_search(&(e.derivative, e.j, e.k)).ok()?, e.factor)))
                    .collect(),
            }
        };
        let sparse: Vec<Sparse> = blocks.iter().map(of).collect();
        let forward = balance.pace(speed).frequency > 0.0;
        let mut groups = own.groups.max(1);
        loop {
            if groups > MOST_GROUPS || balance.cancelled() {
                return None;
            }
            let steps = groups * LANES;
            own.series.set_steps(groups, TAU / parts as f64, forward);
            let mut worst = 0.0f64;
            let width = elements.len();
            let mut maps: Vec<Mat> = blocks.iter().map(|b| Mat::identity(b.states.len())).collect();
            for group in 0..groups {
                own.series.at_nodes(group, width, &mut own.values);
                for (sparse, map) in sparse.iter().zip(&mut maps) {
                    let a = Varying { n: map.rows(), constant: &sparse.constant, entries: &sparse.entries, width, values: &own.values };
                    let error = own.transition.steps(&a, period / steps as f64, self.tolerance, map);
                    if error.is_nan() || error > worst {
                        worst = error;
                    }
                }
            }
            // the error of a step falls with its eighth power
            let shorter = 1.1 * groups as f64 * worst.max(1e-12).powf(0.125);
            if worst <= 1.0 {
                own.groups = shorter.ceil() as usize;
                self.steps_left = self.steps_left.saturating_sub(steps as u64);
                return Some((maps, steps as u64));
            }
            if !(worst < 1e30) {
                return None;
            }
            groups = (shorter.ceil() as usize).max(groups + 1);
        }
    }
}
